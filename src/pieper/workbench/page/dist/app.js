import{A as M,B as Li,C as gu,D as ra,E as fn,F as i_,G as xi,H as s_,I as _u,K as qi,L as Vs,a as ur,b as ni,c as hu,d as te,e as Gs,f as Cl,g as Ii,h as Pl,i as du,j as rs,k as fu,l as pu,m as J0,n as K0,o as hr,p as dr,q as Q0,r as ys,s as ip,t as t_,u as ai,v as mu,w as e_,x as n_,y as st,z as dt}from"./chunk-PZXUYE4H.js";function v(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ws=(n,t=document)=>t.querySelector(n),Vt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function gt(n,t){n.textContent!==t&&(n.textContent=t)}function nn(n,t,e,i,s){let r=v("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(v("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function pn(n,t,e,i,s={}){let r=v("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>v("option",{value:o,text:a})));return r.value=e,r}function qs(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function oa(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function $s(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function yi(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=v("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Gr(n){try{await navigator.clipboard.writeText(n)}catch{let t=v("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}Fe("Copied")}var r_;function Fe(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(r_),r_=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Vr(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var aa=0,op=-1,sp=[];function ap(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function rp(){let n=aa;if(!M.table.joints.length){M.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},dt("plan");return}try{let{plan:t}=await qi("arm",{table:ap(M.table)});if(n!==aa)return;op=n,M.plan=t,o_()}catch(t){if(n!==aa||t instanceof _u)return;M.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},o_(t)}dt("plan")}function o_(n){let t=sp;sp=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var a_=$s(rp,60);function l_(){st("table",n=>{aa+=1,n==="postures"&&(op=-1),n==="cell"?a_():(a_.cancel(),rp())}),st("online",n=>{n&&(aa+=1,rp())})}function fw(){return op===aa?Promise.resolve():new Promise((n,t)=>sp.push({resolve:n,reject:t}))}async function ze(n,t,e){return await fw(),qi(n,t,e)}function c_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function xu(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var Qr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},to={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},q_=0,Op=1,$_=2;var _c=1,X_=2,ka=3,eo=0,Ti=1,Ni=2,Ao=0,za=1,Bp=2,kp=3,zp=4,Y_=5;var Ro=100,Z_=101,j_=102,J_=103,K_=104,Q_=200,tx=201,ex=202,nx=203,Hp=204,Gp=205,ix=206,sx=207,rx=208,ox=209,ax=210,lx=211,cx=212,ux=213,hx=214,Zu=0,ju=1,Ju=2,Aa=3,Ku=4,Qu=5,th=6,eh=7,Vp=0,dx=1,fx=2,Qs=0,Wp=1,qp=2,$p=3,Xp=4,Yp=5,Zp=6,jp=7;var Jp=300,Co=301,Ha=302,Ah=303,Rh=304,nh=1e3,Ys=1001,ih=1002,Kn=1003,px=1004;var xc=1005;var Si=1006,Ch=1007;var Er=1008;var Ki=1009,Kp=1010,Qp=1011,Ga=1012,Ph=1013,ws=1014,us=1015,Es=1016,Ih=1017,Lh=1018,Po=1020,tm=35902,em=35899,nm=1021,im=1022,Ts=1023,vr=1026,Tr=1027,Dh=1028,Nh=1029,no=1030,Uh=1031;var Fh=1033,yc=33776,vc=33777,bc=33778,Mc=33779,Oh=35840,Bh=35841,kh=35842,zh=35843,Hh=36196,Gh=37492,Vh=37496,Wh=37488,qh=37489,Sc=37490,$h=37491,Xh=37808,Yh=37809,Zh=37810,jh=37811,Jh=37812,Kh=37813,Qh=37814,td=37815,ed=37816,nd=37817,id=37818,sd=37819,rd=37820,od=37821,ad=36492,ld=36494,cd=36495,ud=36283,hd=36284,wc=36285,dd=36286;var Wl=2300,sh=2301,Xu=2302,Cp=2303,Pp=2400,Ip=2401,Lp=2402;var mx=3200;var sm=0,gx=1,Ar="",bi="srgb",ql="srgb-linear",$l="linear",He="srgb";var Yu=7680,rm=7681;var om=517;var _x=519,xx=512,yx=513,vx=514,am=515,bx=516,Mx=517,lm=518,cm=519,um=35044,fd=35048;var hm="300 es",as=2e3,Xl=2001;function mw(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function gw(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Yl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Sx(){let n=Yl("canvas");return n.style.display="block",n}var u_={},Ra=null;function Zl(...n){let t="THREE."+n.shift();Ra?Ra("log",t,...n):console.log(t,...n)}function wx(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ee(...n){n=wx(n);let t="THREE."+n.shift();if(Ra)Ra("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function re(...n){n=wx(n);let t="THREE."+n.shift();if(Ra)Ra("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Hl(...n){let t=n.join(" ");t in u_||(u_[t]=!0,ee(...n))}function Ex(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Tx={[Zu]:Zu,[Ju]:th,[Ku]:Ku,[Aa]:Qu,[ju]:ju,[th]:Ju,[eh]:eh,[Qu]:Aa},Ss=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},li=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],h_=1234567,Gl=Math.PI/180,Ca=180/Math.PI;function io(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(li[n&255]+li[n>>8&255]+li[n>>16&255]+li[n>>24&255]+"-"+li[t&255]+li[t>>8&255]+"-"+li[t>>16&15|64]+li[t>>24&255]+"-"+li[e&63|128]+li[e>>8&255]+"-"+li[e>>16&255]+li[e>>24&255]+li[i&255]+li[i>>8&255]+li[i>>16&255]+li[i>>24&255]).toLowerCase()}function Me(n,t,e){return Math.max(t,Math.min(e,n))}function dm(n,t){return(n%t+t)%t}function _w(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function xw(n,t,e){return n!==t?(e-n)/(t-n):0}function Vl(n,t,e){return(1-e)*n+e*t}function yw(n,t,e,i){return Vl(n,t,1-Math.exp(-e*i))}function vw(n,t=1){return t-Math.abs(dm(n,t*2)-t)}function bw(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Mw(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Sw(n,t){return n+Math.floor(Math.random()*(t-n+1))}function ww(n,t){return n+Math.random()*(t-n)}function Ew(n){return n*(.5-Math.random())}function Tw(n){n!==void 0&&(h_=n);let t=h_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Aw(n){return n*Gl}function Rw(n){return n*Ca}function Cw(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Pw(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function fm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Iw(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:ee("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function pd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function pm(n,t){if(t.constructor===Float32Array)return n;let e=pd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function mm(n,t){if(t.constructor===Float32Array)return n;let e=pd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var so={DEG2RAD:Gl,RAD2DEG:Ca,generateUUID:io,clamp:Me,euclideanModulo:dm,mapLinear:_w,inverseLerp:xw,lerp:Vl,damp:yw,pingpong:vw,smoothstep:bw,smootherstep:Mw,randInt:Sw,randFloat:ww,randFloatSpread:Ew,seededRandom:Tw,degToRad:Aw,radToDeg:Rw,isPowerOfTwo:Cw,ceilPowerOfTwo:Pw,floorPowerOfTwo:fm,setQuaternionFromProperEuler:Iw,normalize:mm,denormalize:pm},Xt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Me(this.x,t.x,e.x),this.y=Me(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Me(this.x,t,e),this.y=Me(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Me(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},cn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*y;m<0&&(d=-d,f=-f,p=-p,y=-y,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),w=Math.sin(x);g=Math.sin(g*x)/w,a=Math.sin(a*x)/w,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+y*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:ee("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Me(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(d_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(d_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Me(this.x,t.x,e.x),this.y=Me(this.y,t.y,e.y),this.z=Me(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Me(this.x,t,e),this.y=Me(this.y,t,e),this.z=Me(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return lp.copy(this).projectOnVector(t),this.sub(lp)}reflect(t){return this.sub(lp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Me(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},lp=new H,d_=new cn,ce=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],y=s[0],m=s[3],g=s[6],x=s[1],w=s[4],b=s[7],A=s[2],T=s[5],_=s[8];return r[0]=o*y+a*x+l*A,r[3]=o*m+a*w+l*T,r[6]=o*g+a*b+l*_,r[1]=c*y+u*x+h*A,r[4]=c*m+u*w+h*T,r[7]=c*g+u*b+h*_,r[2]=d*y+f*x+p*A,r[5]=d*m+f*w+p*T,r[8]=d*g+f*b+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=h*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Hl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(cp.makeScale(t,e)),this}rotate(t){return Hl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(cp.makeRotation(-t)),this}translate(t,e){return Hl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(cp.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},cp=new ce,f_=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),p_=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Lw(){let n={enabled:!0,workingColorSpace:ql,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===He&&(s.r=yr(s.r),s.g=yr(s.g),s.b=yr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===He&&(s.r=Ta(s.r),s.g=Ta(s.g),s.b=Ta(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ar?$l:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ql]:{primaries:t,whitePoint:i,transfer:$l,toXYZ:f_,fromXYZ:p_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:t,whitePoint:i,transfer:He,toXYZ:f_,fromXYZ:p_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),n}var Ce=Lw();function yr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ta(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var la,rh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{la===void 0&&(la=Yl("canvas")),la.width=t.width,la.height=t.height;let s=la.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=la}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Yl("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=yr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(yr(e[i]/255)*255):e[i]=yr(e[i]);return{data:e,width:t.width,height:t.height}}else return ee("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Dw=0,Pa=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Dw++}),this.uuid=io(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(up(s[o].image)):r.push(up(s[o]))}else r=up(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function up(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?rh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ee("Texture: Unable to serialize Texture."),{})}var Nw=0,hp=new H,wi=class n extends Ss{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ys,s=Ys,r=Si,o=Er,a=Ts,l=Ki,c=n.DEFAULT_ANISOTROPY,u=Ar){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Nw++}),this.uuid=io(),this.name="",this.source=new Pa(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Xt(0,0),this.repeat=new Xt(1,1),this.center=new Xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hp).x}get height(){return this.source.getSize(hp).y}get depth(){return this.source.getSize(hp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ee(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ee(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Jp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case nh:t.x=t.x-Math.floor(t.x);break;case Ys:t.x=t.x<0?0:1;break;case ih:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case nh:t.y=t.y-Math.floor(t.y);break;case Ys:t.y=t.y<0?0:1;break;case ih:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};wi.DEFAULT_IMAGE=null;wi.DEFAULT_MAPPING=Jp;wi.DEFAULT_ANISOTROPY=1;var xn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],y=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(f+1)/2,A=(g+1)/2,T=(u+d)/4,_=(h+y)/4,S=(p+m)/4;return w>b&&w>A?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=T/i,r=_/i):b>A?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=S/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=S/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(h-y)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Me(this.x,t.x,e.x),this.y=Me(this.y,t.y,e.y),this.z=Me(this.z,t.z,e.z),this.w=Me(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Me(this.x,t,e),this.y=Me(this.y,t,e),this.z=Me(this.z,t,e),this.w=Me(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},oh=class extends Ss{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new xn(0,0,t,e),this.scissorTest=!1,this.viewport=new xn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new wi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Si,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Pa(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Yi=class extends oh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},jl=class extends wi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Kn,this.minFilter=Kn,this.wrapR=Ys,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var ah=class extends wi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Kn,this.minFilter=Kn,this.wrapR=Ys,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var _e=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=y,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/ca.setFromMatrixColumn(t,0).length(),r=1/ca.setFromMatrixColumn(t,1).length(),o=1/ca.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-y*c,e[9]=-a*l,e[2]=y-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,y=c*h;e[0]=d+y*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=y+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,y=c*h;e[0]=d-y*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=y-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+y,e[1]=l*h,e[5]=y*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=y-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-y*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+y,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=y*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Uw,t,Fw)}lookAt(t,e,i){let s=this.elements;return $i.subVectors(t,e),$i.lengthSq()===0&&($i.z=1),$i.normalize(),Wr.crossVectors(i,$i),Wr.lengthSq()===0&&(Math.abs(i.z)===1?$i.x+=1e-4:$i.z+=1e-4,$i.normalize(),Wr.crossVectors(i,$i)),Wr.normalize(),yu.crossVectors($i,Wr),s[0]=Wr.x,s[4]=yu.x,s[8]=$i.x,s[1]=Wr.y,s[5]=yu.y,s[9]=$i.y,s[2]=Wr.z,s[6]=yu.z,s[10]=$i.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],y=i[6],m=i[10],g=i[14],x=i[3],w=i[7],b=i[11],A=i[15],T=s[0],_=s[4],S=s[8],D=s[12],L=s[1],N=s[5],z=s[9],W=s[13],B=s[2],X=s[6],I=s[10],U=s[14],Z=s[3],q=s[7],j=s[11],et=s[15];return r[0]=o*T+a*L+l*B+c*Z,r[4]=o*_+a*N+l*X+c*q,r[8]=o*S+a*z+l*I+c*j,r[12]=o*D+a*W+l*U+c*et,r[1]=u*T+h*L+d*B+f*Z,r[5]=u*_+h*N+d*X+f*q,r[9]=u*S+h*z+d*I+f*j,r[13]=u*D+h*W+d*U+f*et,r[2]=p*T+y*L+m*B+g*Z,r[6]=p*_+y*N+m*X+g*q,r[10]=p*S+y*z+m*I+g*j,r[14]=p*D+y*W+m*U+g*et,r[3]=x*T+w*L+b*B+A*Z,r[7]=x*_+w*N+b*X+A*q,r[11]=x*S+w*z+b*I+A*j,r[15]=x*D+w*W+b*U+A*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],y=t[7],m=t[11],g=t[15],x=l*f-c*d,w=a*f-c*h,b=a*d-l*h,A=o*f-c*u,T=o*d-l*u,_=o*h-a*u;return e*(y*x-m*w+g*b)-i*(p*x-m*A+g*T)+s*(p*w-y*A+g*_)-r*(p*b-y*T+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],y=t[13],m=t[14],g=t[15],x=e*a-i*o,w=e*l-s*o,b=e*c-r*o,A=i*l-s*a,T=i*c-r*a,_=s*c-r*l,S=u*y-h*p,D=u*m-d*p,L=u*g-f*p,N=h*m-d*y,z=h*g-f*y,W=d*g-f*m,B=x*W-w*z+b*N+A*L-T*D+_*S;if(B===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/B;return t[0]=(a*W-l*z+c*N)*X,t[1]=(s*z-i*W-r*N)*X,t[2]=(y*_-m*T+g*A)*X,t[3]=(d*T-h*_-f*A)*X,t[4]=(l*L-o*W-c*D)*X,t[5]=(e*W-s*L+r*D)*X,t[6]=(m*b-p*_-g*w)*X,t[7]=(u*_-d*b+f*w)*X,t[8]=(o*z-a*L+c*S)*X,t[9]=(i*L-e*z-r*S)*X,t[10]=(p*T-y*b+g*x)*X,t[11]=(h*b-u*T-f*x)*X,t[12]=(a*D-o*N-l*S)*X,t[13]=(e*N-i*D+s*S)*X,t[14]=(y*w-p*A-m*x)*X,t[15]=(u*A-h*w+d*x)*X,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,y=o*u,m=o*h,g=a*h,x=l*c,w=l*u,b=l*h,A=i.x,T=i.y,_=i.z;return s[0]=(1-(y+g))*A,s[1]=(f+b)*A,s[2]=(p-w)*A,s[3]=0,s[4]=(f-b)*T,s[5]=(1-(d+g))*T,s[6]=(m+x)*T,s[7]=0,s[8]=(p+w)*_,s[9]=(m-x)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=ca.set(s[0],s[1],s[2]).length(),a=ca.set(s[4],s[5],s[6]).length(),l=ca.set(s[8],s[9],s[10]).length();r<0&&(o=-o),vs.copy(this);let c=1/o,u=1/a,h=1/l;return vs.elements[0]*=c,vs.elements[1]*=c,vs.elements[2]*=c,vs.elements[4]*=u,vs.elements[5]*=u,vs.elements[6]*=u,vs.elements[8]*=h,vs.elements[9]*=h,vs.elements[10]*=h,e.setFromRotationMatrix(vs),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=as,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===as)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Xl)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=as,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===as)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===Xl)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},ca=new H,vs=new _e,Uw=new H(0,0,0),Fw=new H(1,1,1),Wr=new H,yu=new H,$i=new H,m_=new _e,g_=new cn,Zr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Me(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Me(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Me(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Me(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Me(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Me(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ee("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return m_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(m_,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return g_.setFromEuler(this),this.setFromQuaternion(g_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Zr.DEFAULT_ORDER="XYZ";var Ia=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Ow=0,__=new H,ua=new cn,fr=new _e,vu=new H,Il=new H,Bw=new H,kw=new cn,x_=new H(1,0,0),y_=new H(0,1,0),v_=new H(0,0,1),b_={type:"added"},zw={type:"removed"},ha={type:"childadded",child:null},dp={type:"childremoved",child:null},Ei=class n extends Ss{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ow++}),this.uuid=io(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new H,e=new Zr,i=new cn,s=new H(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new _e},normalMatrix:{value:new ce}}),this.matrix=new _e,this.matrixWorld=new _e,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ia,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ua.setFromAxisAngle(t,e),this.quaternion.multiply(ua),this}rotateOnWorldAxis(t,e){return ua.setFromAxisAngle(t,e),this.quaternion.premultiply(ua),this}rotateX(t){return this.rotateOnAxis(x_,t)}rotateY(t){return this.rotateOnAxis(y_,t)}rotateZ(t){return this.rotateOnAxis(v_,t)}translateOnAxis(t,e){return __.copy(t).applyQuaternion(this.quaternion),this.position.add(__.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(x_,t)}translateY(t){return this.translateOnAxis(y_,t)}translateZ(t){return this.translateOnAxis(v_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(fr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?vu.copy(t):vu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Il.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?fr.lookAt(Il,vu,this.up):fr.lookAt(vu,Il,this.up),this.quaternion.setFromRotationMatrix(fr),s&&(fr.extractRotation(s.matrixWorld),ua.setFromRotationMatrix(fr),this.quaternion.premultiply(ua.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(b_),ha.child=t,this.dispatchEvent(ha),ha.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(zw),dp.child=t,this.dispatchEvent(dp),dp.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),fr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),fr.multiply(t.parent.matrixWorld)),t.applyMatrix4(fr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(b_),ha.child=t,this.dispatchEvent(ha),ha.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Il,t,Bw),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Il,kw,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ei.DEFAULT_UP=new H(0,1,0);Ei.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ei.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fn=class extends Ei{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hw={type:"move"},La=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),g=this._getHandJoint(c,y);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Fn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Ax={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qr={h:0,s:0,l:0},bu={h:0,s:0,l:0};function fp(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ie=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=bi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ce.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ce.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ce.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ce.workingColorSpace){if(t=dm(t,1),e=Me(e,0,1),i=Me(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=fp(o,r,t+1/3),this.g=fp(o,r,t),this.b=fp(o,r,t-1/3)}return Ce.colorSpaceToWorking(this,s),this}setStyle(t,e=bi){function i(r){r!==void 0&&parseFloat(r)<1&&ee("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ee("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ee("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=bi){let i=Ax[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ee("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=yr(t.r),this.g=yr(t.g),this.b=yr(t.b),this}copyLinearToSRGB(t){return this.r=Ta(t.r),this.g=Ta(t.g),this.b=Ta(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=bi){return Ce.workingToColorSpace(ci.copy(this),t),Math.round(Me(ci.r*255,0,255))*65536+Math.round(Me(ci.g*255,0,255))*256+Math.round(Me(ci.b*255,0,255))}getHexString(t=bi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ce.workingColorSpace){Ce.workingToColorSpace(ci.copy(this),e);let i=ci.r,s=ci.g,r=ci.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Ce.workingColorSpace){return Ce.workingToColorSpace(ci.copy(this),e),t.r=ci.r,t.g=ci.g,t.b=ci.b,t}getStyle(t=bi){Ce.workingToColorSpace(ci.copy(this),t);let e=ci.r,i=ci.g,s=ci.b;return t!==bi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(qr),this.setHSL(qr.h+t,qr.s+e,qr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(qr),t.getHSL(bu);let i=Vl(qr.h,bu.h,e),s=Vl(qr.s,bu.s,e),r=Vl(qr.l,bu.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ci=new ie;ie.NAMES=Ax;var Jl=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ie(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Kl=class extends Ei{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Zr,this.environmentIntensity=1,this.environmentRotation=new Zr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},bs=new H,pr=new H,pp=new H,mr=new H,da=new H,fa=new H,M_=new H,mp=new H,gp=new H,_p=new H,xp=new xn,yp=new xn,vp=new xn,xr=class n{constructor(t=new H,e=new H,i=new H){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),bs.subVectors(t,e),s.cross(bs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){bs.subVectors(s,e),pr.subVectors(i,e),pp.subVectors(t,e);let o=bs.dot(bs),a=bs.dot(pr),l=bs.dot(pp),c=pr.dot(pr),u=pr.dot(pp),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,mr)===null?!1:mr.x>=0&&mr.y>=0&&mr.x+mr.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,mr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,mr.x),l.addScaledVector(o,mr.y),l.addScaledVector(a,mr.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return xp.setScalar(0),yp.setScalar(0),vp.setScalar(0),xp.fromBufferAttribute(t,e),yp.fromBufferAttribute(t,i),vp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(xp,r.x),o.addScaledVector(yp,r.y),o.addScaledVector(vp,r.z),o}static isFrontFacing(t,e,i,s){return bs.subVectors(i,e),pr.subVectors(t,e),bs.cross(pr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return bs.subVectors(this.c,this.b),pr.subVectors(this.a,this.b),bs.cross(pr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;da.subVectors(s,i),fa.subVectors(r,i),mp.subVectors(t,i);let l=da.dot(mp),c=fa.dot(mp);if(l<=0&&c<=0)return e.copy(i);gp.subVectors(t,s);let u=da.dot(gp),h=fa.dot(gp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(da,o);_p.subVectors(t,r);let f=da.dot(_p),p=fa.dot(_p);if(p>=0&&f<=p)return e.copy(r);let y=f*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(fa,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return M_.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(M_,a);let g=1/(m+y+d);return o=y*g,a=d*g,e.copy(i).addScaledVector(da,o).addScaledVector(fa,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Di=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ms.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ms.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ms.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ms):Ms.fromBufferAttribute(r,o),Ms.applyMatrix4(t.matrixWorld),this.expandByPoint(Ms);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Mu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Mu.copy(i.boundingBox)),Mu.applyMatrix4(t.matrixWorld),this.union(Mu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ms),Ms.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ll),Su.subVectors(this.max,Ll),pa.subVectors(t.a,Ll),ma.subVectors(t.b,Ll),ga.subVectors(t.c,Ll),$r.subVectors(ma,pa),Xr.subVectors(ga,ma),vo.subVectors(pa,ga);let e=[0,-$r.z,$r.y,0,-Xr.z,Xr.y,0,-vo.z,vo.y,$r.z,0,-$r.x,Xr.z,0,-Xr.x,vo.z,0,-vo.x,-$r.y,$r.x,0,-Xr.y,Xr.x,0,-vo.y,vo.x,0];return!bp(e,pa,ma,ga,Su)||(e=[1,0,0,0,1,0,0,0,1],!bp(e,pa,ma,ga,Su))?!1:(wu.crossVectors($r,Xr),e=[wu.x,wu.y,wu.z],bp(e,pa,ma,ga,Su))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ms).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ms).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(gr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),gr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),gr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),gr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),gr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),gr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),gr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),gr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(gr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},gr=[new H,new H,new H,new H,new H,new H,new H,new H],Ms=new H,Mu=new Di,pa=new H,ma=new H,ga=new H,$r=new H,Xr=new H,vo=new H,Ll=new H,Su=new H,wu=new H,bo=new H;function bp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){bo.fromArray(n,r);let a=s.x*Math.abs(bo.x)+s.y*Math.abs(bo.y)+s.z*Math.abs(bo.z),l=t.dot(bo),c=e.dot(bo),u=i.dot(bo);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Un=new H,Eu=new Xt,Gw=0,Je=class extends Ss{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Gw++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=um,this.updateRanges=[],this.gpuType=us,this.version=0,this._normalizationScale=t!==void 0?pd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Eu.fromBufferAttribute(this,e),Eu.applyMatrix3(t),this.setXY(e,Eu.x,Eu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Un.fromBufferAttribute(this,e),Un.applyMatrix3(t),this.setXYZ(e,Un.x,Un.y,Un.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Un.fromBufferAttribute(this,e),Un.applyMatrix4(t),this.setXYZ(e,Un.x,Un.y,Un.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Un.fromBufferAttribute(this,e),Un.applyNormalMatrix(t),this.setXYZ(e,Un.x,Un.y,Un.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Un.fromBufferAttribute(this,e),Un.transformDirection(t),this.setXYZ(e,Un.x,Un.y,Un.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):pm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):mm(t,this.array)}};var Ql=class extends Je{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var tc=class extends Je{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Pe=class extends Je{constructor(t,e,i){super(new Float32Array(t),e,i)}},Vw=new Di,Dl=new H,Mp=new H,Zs=class{constructor(t=new H,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Vw.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Dl.subVectors(t,this.center);let e=Dl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Dl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Mp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Dl.copy(t.center).add(Mp)),this.expandByPoint(Dl.copy(t.center).sub(Mp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ww=0,os=new _e,Sp=new Ei,_a=new H,Xi=new Di,Nl=new Di,Jn=new H,Ae=class n extends Ss{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ww++}),this.uuid=io(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(mw(t)?tc:Ql)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ce().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return os.makeRotationFromQuaternion(t),this.applyMatrix4(os),this}rotateX(t){return os.makeRotationX(t),this.applyMatrix4(os),this}rotateY(t){return os.makeRotationY(t),this.applyMatrix4(os),this}rotateZ(t){return os.makeRotationZ(t),this.applyMatrix4(os),this}translate(t,e,i){return os.makeTranslation(t,e,i),this.applyMatrix4(os),this}scale(t,e,i){return os.makeScale(t,e,i),this.applyMatrix4(os),this}lookAt(t){return Sp.lookAt(t),Sp.updateMatrix(),this.applyMatrix4(Sp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_a).negate(),this.translate(_a.x,_a.y,_a.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Pe(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ee("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Di);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Xi.setFromBufferAttribute(r),this.morphTargetsRelative?(Jn.addVectors(this.boundingBox.min,Xi.min),this.boundingBox.expandByPoint(Jn),Jn.addVectors(this.boundingBox.max,Xi.max),this.boundingBox.expandByPoint(Jn)):(this.boundingBox.expandByPoint(Xi.min),this.boundingBox.expandByPoint(Xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Zs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let i=this.boundingSphere.center;if(Xi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Nl.setFromBufferAttribute(a),this.morphTargetsRelative?(Jn.addVectors(Xi.min,Nl.min),Xi.expandByPoint(Jn),Jn.addVectors(Xi.max,Nl.max),Xi.expandByPoint(Jn)):(Xi.expandByPoint(Nl.min),Xi.expandByPoint(Nl.max))}Xi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Jn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Jn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Jn.fromBufferAttribute(a,c),l&&(_a.fromBufferAttribute(t,c),Jn.add(_a)),s=Math.max(s,i.distanceToSquared(Jn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Je(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new H,l[D]=new H;let u=new H,h=new H,d=new H,f=new Xt,p=new Xt,y=new Xt,m=new H,g=new H;function x(D,L,N){c[D]=c[L]=c[N]=1,u.fromBufferAttribute(i,D),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,N),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,L),y.fromBufferAttribute(r,N),h.sub(u),d.sub(u),p.sub(f),y.sub(f);let z=1/(p.x*y.y-y.x*p.y);isFinite(z)&&(m.copy(h).multiplyScalar(y.y).addScaledVector(d,-p.y).multiplyScalar(z),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-y.x).multiplyScalar(z),a[D].add(m),a[L].add(m),a[N].add(m),l[D].add(g),l[L].add(g),l[N].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let D=0,L=w.length;D<L;++D){let N=w[D],z=N.start,W=N.count;for(let B=z,X=z+W;B<X;B+=3)x(t.getX(B+0),t.getX(B+1),t.getX(B+2))}let b=new H,A=new H,T=new H,_=new H;function S(D){T.fromBufferAttribute(s,D),_.copy(T);let L=a[D];b.copy(L),b.sub(T.multiplyScalar(T.dot(L))).normalize(),A.crossVectors(_,L);let z=A.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,z)}for(let D=0,L=i.count;D<L;++D)c[D]&&S(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Je(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),y=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Jn.fromBufferAttribute(t,e),Jn.normalize(),t.setXYZ(e,Jn.x,Jn.y,Jn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new Je(d,u,h)}if(this.index===null)return ee("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ec=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=um,this.updateRanges=[],this.version=0,this.uuid=io()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=S_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=S_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function S_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=io()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var vi=new H,Da=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?pd(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)vi.fromBufferAttribute(this,e),vi.applyMatrix4(t),this.setXYZ(e,vi.x,vi.y,vi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)vi.fromBufferAttribute(this,e),vi.applyNormalMatrix(t),this.setXYZ(e,vi.x,vi.y,vi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)vi.fromBufferAttribute(this,e),vi.transformDirection(t),this.setXYZ(e,vi.x,vi.y,vi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Zl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Je(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Zl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):pm(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):mm(t,this.data.array)}},wp=new H,qw=new H,$w=new ce,ii=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=wp.subVectors(i,e).cross(qw.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(wp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||$w.getNormalMatrix(t),s=this.coplanarPoint(wp).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Xw=0,js=class extends Ss{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xw++}),this.uuid=io(),this.name="",this.type="Material",this.blending=za,this.side=eo,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hp,this.blendDst=Gp,this.blendEquation=Ro,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ie(0,0,0),this.blendAlpha=0,this.depthFunc=Aa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=_x,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Yu,this.stencilZFail=Yu,this.stencilZPass=Yu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ee(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ee(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ie().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ii().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Xt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Na=class extends js{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ie(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},xa,Ul=new H,ya=new H,va=new H,ba=new Xt,Fl=new Xt,Rx=new _e,Tu=new H,Ol=new H,Au=new H,w_=new Xt,Ep=new Xt,E_=new Xt,nc=class extends Ei{constructor(t=new Na){if(super(),this.isSprite=!0,this.type="Sprite",xa===void 0){xa=new Ae;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new ec(e,5);xa.setIndex([0,1,2,0,2,3]),xa.setAttribute("position",new Da(i,3,0,!1)),xa.setAttribute("uv",new Da(i,2,3,!1))}this.geometry=xa,this.material=t,this.center=new Xt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&re('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),ya.setFromMatrixScale(this.matrixWorld),Rx.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),va.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&ya.multiplyScalar(-va.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Ru(Tu.set(-.5,-.5,0),va,o,ya,s,r),Ru(Ol.set(.5,-.5,0),va,o,ya,s,r),Ru(Au.set(.5,.5,0),va,o,ya,s,r),w_.set(0,0),Ep.set(1,0),E_.set(1,1);let a=t.ray.intersectTriangle(Tu,Ol,Au,!1,Ul);if(a===null&&(Ru(Ol.set(-.5,.5,0),va,o,ya,s,r),Ep.set(0,1),a=t.ray.intersectTriangle(Tu,Au,Ol,!1,Ul),a===null))return;let l=t.ray.origin.distanceTo(Ul);l<t.near||l>t.far||e.push({distance:l,point:Ul.clone(),uv:xr.getInterpolation(Ul,Tu,Ol,Au,w_,Ep,E_,new Xt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Ru(n,t,e,i,s,r){ba.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Fl.x=r*ba.x-s*ba.y,Fl.y=s*ba.x+r*ba.y):Fl.copy(ba),n.copy(t),n.x+=Fl.x,n.y+=Fl.y,n.applyMatrix4(Rx)}var _r=new H,Tp=new H,Cu=new H,Pu=new H,br=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_r)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_r.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_r.copy(this.origin).addScaledVector(this.direction,e),_r.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Tp.copy(t).add(e).multiplyScalar(.5),Cu.copy(e).sub(t).normalize(),Pu.copy(this.origin).sub(Tp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Cu),a=Pu.dot(this.direction),l=-Pu.dot(Cu),c=Pu.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Tp).addScaledVector(Cu,d),f}intersectSphere(t,e){if(t.radius<0)return null;_r.subVectors(t.center,this.origin);let i=_r.dot(this.direction),s=_r.dot(_r)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,_r)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,y=e.y-o.y,m=e.z-o.z,g=i.x-o.x,x=i.y-o.y,w=i.z-o.z,b=Math.abs(l),A=Math.abs(c),T=Math.abs(u),_,S,D,L,N,z,W,B,X,I,U,Z;if(b>=A&&b>=T?(D=l,z=h,X=p,Z=g,l>=0?(_=c,S=u,L=d,N=f,W=y,B=m,I=x,U=w):(_=u,S=c,L=f,N=d,W=m,B=y,I=w,U=x)):A>=T?(D=c,z=d,X=y,Z=x,c>=0?(_=u,S=l,L=f,N=h,W=m,B=p,I=w,U=g):(_=l,S=u,L=h,N=f,W=p,B=m,I=g,U=w)):(D=u,z=f,X=m,Z=w,u>=0?(_=l,S=c,L=h,N=d,W=p,B=y,I=g,U=x):(_=c,S=l,L=d,N=h,W=y,B=p,I=x,U=g)),D===0)return null;let q=_/D,j=S/D,et=1/D,ht=L-q*z,ft=N-j*z,it=W-q*X,vt=B-j*X,xt=I-q*Z,Tt=U-j*Z,At=xt*vt-Tt*it,Jt=ht*Tt-ft*xt,pe=it*ft-vt*ht;if(s){if(At<0||Jt<0||pe<0)return null}else if((At<0||Jt<0||pe<0)&&(At>0||Jt>0||pe>0))return null;let Zt=At+Jt+pe;if(Zt===0)return null;let be=et*(At*z+Jt*X+pe*Z);return(Zt>0?be<0:be>0)?null:this.at(be/Zt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},si=class extends js{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ie(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zr,this.combine=Vp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},T_=new _e,Mo=new br,Iu=new Zs,A_=new H,Lu=new H,Du=new H,Nu=new H,Ap=new H,Uu=new H,R_=new H,Fu=new H,mn=class extends Ei{constructor(t=new Ae,e=new si){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Uu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Ap.fromBufferAttribute(h,t),o?Uu.addScaledVector(Ap,u):Uu.addScaledVector(Ap.sub(e),u))}e.add(Uu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Iu.copy(i.boundingSphere),Iu.applyMatrix4(r),Mo.copy(t.ray).recast(t.near),!(Iu.containsPoint(Mo.origin)===!1&&(Mo.intersectSphere(Iu,A_)===null||Mo.origin.distanceToSquared(A_)>(t.far-t.near)**2))&&(T_.copy(r).invert(),Mo.copy(t.ray).applyMatrix4(T_),!(i.boundingBox!==null&&Mo.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Mo)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=x,A=w;b<A;b+=3){let T=a.getX(b),_=a.getX(b+1),S=a.getX(b+2);s=Ou(this,g,t,i,c,u,h,T,_,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let x=a.getX(m),w=a.getX(m+1),b=a.getX(m+2);s=Ou(this,o,t,i,c,u,h,x,w,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=x,A=w;b<A;b+=3){let T=b,_=b+1,S=b+2;s=Ou(this,g,t,i,c,u,h,T,_,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let x=m,w=m+1,b=m+2;s=Ou(this,o,t,i,c,u,h,x,w,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Yw(n,t,e,i,s,r,o,a){let l;if(t.side===Ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===eo,a),l===null)return null;Fu.copy(a),Fu.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Fu);return c<e.near||c>e.far?null:{distance:c,point:Fu.clone(),object:n}}function Ou(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Lu),n.getVertexPosition(l,Du),n.getVertexPosition(c,Nu);let u=Yw(n,t,e,i,Lu,Du,Nu,R_);if(u){let h=new H;xr.getBarycoord(R_,Lu,Du,Nu,h),s&&(u.uv=xr.getInterpolatedAttribute(s,a,l,c,h,new Xt)),r&&(u.uv1=xr.getInterpolatedAttribute(r,a,l,c,h,new Xt)),o&&(u.normal=xr.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new H,materialIndex:0};xr.getNormal(Lu,Du,Nu,d.normal),u.face=d,u.barycoord=h}return u}var ic=class extends wi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Kn,u=Kn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ua=class extends Je{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ma=new _e,C_=new _e,Bu=[],P_=new Di,Zw=new _e,Bl=new mn,kl=new Zs,sc=class extends mn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ua(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Zw)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Di),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ma),P_.copy(t.boundingBox).applyMatrix4(Ma),this.boundingBox.union(P_)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Zs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ma),kl.copy(t.boundingSphere).applyMatrix4(Ma),this.boundingSphere.union(kl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Bl.geometry=this.geometry,Bl.material=this.material,Bl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),kl.copy(this.boundingSphere),kl.applyMatrix4(i),t.ray.intersectsSphere(kl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ma),C_.multiplyMatrices(i,Ma),Bl.matrixWorld=C_,Bl.raycast(t,Bu);for(let o=0,a=Bu.length;o<a;o++){let l=Bu[o];l.instanceId=r,l.object=this,e.push(l)}Bu.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ua(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new ic(new Float32Array(s*this.count),s,this.count,Dh,us));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},So=new Zs,jw=new Xt(.5,.5),ku=new H,wo=class{constructor(t=new ii,e=new ii,i=new ii,s=new ii,r=new ii,o=new ii){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=as,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],y=r[9],m=r[10],g=r[11],x=r[12],w=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-p,A-x).normalize(),s[1].setComponents(c+o,f+u,g+p,A+x).normalize(),s[2].setComponents(c+a,f+h,g+y,A+w).normalize(),s[3].setComponents(c-a,f-h,g-y,A-w).normalize(),i)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,A-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-b).normalize(),e===as)s[5].setComponents(c+l,f+d,g+m,A+b).normalize();else if(e===Xl)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),So.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),So.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(So)}intersectsSprite(t){So.center.set(0,0,0);let e=jw.distanceTo(t.center);return So.radius=.7071067811865476+e,So.applyMatrix4(t.matrixWorld),this.intersectsSphere(So)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ku.x=s.normal.x>0?t.max.x:t.min.x,ku.y=s.normal.y>0?t.max.y:t.min.y,ku.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ku)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},I_=new _e,lh=class n{constructor(){this.coordinateSystem=as,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];I_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new wo),i[s].setFromProjectionMatrix(I_,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new wo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Zi=class extends js{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ie(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},ch=new H,uh=new H,L_=new _e,zl=new br,zu=new Zs,Rp=new H,D_=new H,Js=class extends Ei{constructor(t=new Ae,e=new Zi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)ch.fromBufferAttribute(e,s-1),uh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=ch.distanceTo(uh);t.setAttribute("lineDistance",new Pe(i,1))}else ee("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),zu.copy(i.boundingSphere),zu.applyMatrix4(s),zu.radius+=r,t.ray.intersectsSphere(zu)===!1)return;L_.copy(s).invert(),zl.copy(t.ray).applyMatrix4(L_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=c){let g=u.getX(y),x=u.getX(y+1),w=Hu(this,t,zl,l,g,x,y);w&&e.push(w)}if(this.isLineLoop){let y=u.getX(p-1),m=u.getX(f),g=Hu(this,t,zl,l,y,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let y=f,m=p-1;y<m;y+=c){let g=Hu(this,t,zl,l,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=Hu(this,t,zl,l,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Hu(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(ch.fromBufferAttribute(a,s),uh.fromBufferAttribute(a,r),e.distanceSqToSegment(ch,uh,Rp,D_)>i)return;Rp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Rp);if(!(c<t.near||c>t.far))return{distance:c,point:D_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var N_=new H,U_=new H,Eo=class extends Js{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)N_.fromBufferAttribute(e,s),U_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+N_.distanceTo(U_);t.setAttribute("lineDistance",new Pe(i,1))}else ee("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ks=class extends js{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ie(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},F_=new _e,Dp=new br,Gu=new Zs,Vu=new H,Mr=class extends Ei{constructor(t=new Ae,e=new Ks){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Gu.copy(i.boundingSphere),Gu.applyMatrix4(s),Gu.radius+=r,t.ray.intersectsSphere(Gu)===!1)return;F_.copy(s).invert(),Dp.copy(t.ray).applyMatrix4(F_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,y=f;p<y;p++){let m=c.getX(p);Vu.fromBufferAttribute(h,m),O_(Vu,m,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,y=f;p<y;p++)Vu.fromBufferAttribute(h,p),O_(Vu,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function O_(n,t,e,i,s,r,o){let a=Dp.distanceSqToPoint(n);if(a<e){let l=new H;Dp.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var rc=class extends wi{constructor(t=[],e=Co,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},oc=class extends wi{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Sr=class extends wi{constructor(t,e,i=ws,s,r,o,a=Kn,l=Kn,c,u=vr,h=1){if(u!==vr&&u!==Tr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Pa(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ac=class extends Sr{constructor(t,e=ws,i=Co,s,r,o=Kn,a=Kn,l,c=vr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},lc=class extends wi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ls=class n extends Ae{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Pe(c,3)),this.setAttribute("normal",new Pe(u,3)),this.setAttribute("uv",new Pe(h,2));function p(y,m,g,x,w,b,A,T,_,S,D){let L=b/_,N=A/S,z=b/2,W=A/2,B=T/2,X=_+1,I=S+1,U=0,Z=0,q=new H;for(let j=0;j<I;j++){let et=j*N-W;for(let ht=0;ht<X;ht++){let ft=ht*L-z;q[y]=ft*x,q[m]=et*w,q[g]=B,c.push(q.x,q.y,q.z),q[y]=0,q[m]=0,q[g]=T>0?1:-1,u.push(q.x,q.y,q.z),h.push(ht/_),h.push(1-j/S),U+=1}}for(let j=0;j<S;j++)for(let et=0;et<_;et++){let ht=d+et+X*j,ft=d+et+X*(j+1),it=d+(et+1)+X*(j+1),vt=d+(et+1)+X*j;l.push(ht,ft,vt),l.push(ft,it,vt),Z+=6}a.addGroup(f,Z,D),f+=Z,d+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},cc=class n extends Ae{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,y=s+1,m=new H,g=new H;for(let x=0;x<=p;x++){let w=0,b=0,A=0,T=0;if(x<=i){let D=x/i,L=D*Math.PI/2;b=-u-t*Math.cos(L),A=t*Math.sin(L),T=-t*Math.cos(L),w=D*h}else if(x<=i+r){let D=(x-i)/r;b=-u+D*e,A=t,T=0,w=h+D*d}else{let D=(x-i-r)/i,L=D*Math.PI/2;b=u+t*Math.sin(L),A=t*Math.cos(L),T=t*Math.sin(L),w=h+d+D*h}let _=Math.max(0,Math.min(1,w/f)),S=0;x===0?S=.5/s:x===p&&(S=-.5/s);for(let D=0;D<=s;D++){let L=D/s,N=L*Math.PI*2,z=Math.sin(N),W=Math.cos(N);g.x=-A*W,g.y=b,g.z=A*z,a.push(g.x,g.y,g.z),m.set(-A*W,T,A*z),m.normalize(),l.push(m.x,m.y,m.z),c.push(L+S,_)}if(x>0){let D=(x-1)*y;for(let L=0;L<s;L++){let N=D+L,z=D+L+1,W=x*y+L,B=x*y+L+1;o.push(N,z,W),o.push(z,B,W)}}}this.setIndex(o),this.setAttribute("position",new Pe(a,3)),this.setAttribute("normal",new Pe(l,3)),this.setAttribute("uv",new Pe(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}};var ji=class n extends Ae{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,y=[],m=i/2,g=0;x(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new Pe(h,3)),this.setAttribute("normal",new Pe(d,3)),this.setAttribute("uv",new Pe(f,2));function x(){let b=new H,A=new H,T=0,_=(e-t)/i;for(let S=0;S<=r;S++){let D=[],L=S/r,N=L*(e-t)+t;for(let z=0;z<=s;z++){let W=z/s,B=W*l+a,X=Math.sin(B),I=Math.cos(B);A.x=N*X,A.y=-L*i+m,A.z=N*I,h.push(A.x,A.y,A.z),b.set(X,_,I).normalize(),d.push(b.x,b.y,b.z),f.push(W,1-L),D.push(p++)}y.push(D)}for(let S=0;S<s;S++)for(let D=0;D<r;D++){let L=y[D][S],N=y[D+1][S],z=y[D+1][S+1],W=y[D][S+1];(t>0||D!==0)&&(u.push(L,N,W),T+=3),(e>0||D!==r-1)&&(u.push(N,z,W),T+=3)}c.addGroup(g,T,0),g+=T}function w(b){let A=p,T=new Xt,_=new H,S=0,D=b===!0?t:e,L=b===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let N=p;for(let z=0;z<=s;z++){let B=z/s*l+a,X=Math.cos(B),I=Math.sin(B);_.x=D*I,_.y=m*L,_.z=D*X,h.push(_.x,_.y,_.z),d.push(0,L,0),T.x=X*.5+.5,T.y=I*.5*L+.5,f.push(T.x,T.y),p++}for(let z=0;z<s;z++){let W=A+z,B=N+z;b===!0?u.push(B,B+1,W):u.push(B+1,B,W),S+=3}c.addGroup(g,S,b===!0?1:2),g+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},To=class n extends ji{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},hh=class n extends Ae{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Pe(r,3)),this.setAttribute("normal",new Pe(r.slice(),3)),this.setAttribute("uv",new Pe(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let w=new H,b=new H,A=new H;for(let T=0;T<e.length;T+=3)f(e[T+0],w),f(e[T+1],b),f(e[T+2],A),l(w,b,A,x)}function l(x,w,b,A){let T=A+1,_=[];for(let S=0;S<=T;S++){_[S]=[];let D=x.clone().lerp(b,S/T),L=w.clone().lerp(b,S/T),N=T-S;for(let z=0;z<=N;z++)z===0&&S===T?_[S][z]=D:_[S][z]=D.clone().lerp(L,z/N)}for(let S=0;S<T;S++)for(let D=0;D<2*(T-S)-1;D++){let L=Math.floor(D/2);D%2===0?(d(_[S][L+1]),d(_[S+1][L]),d(_[S][L])):(d(_[S][L+1]),d(_[S+1][L+1]),d(_[S+1][L]))}}function c(x){let w=new H;for(let b=0;b<r.length;b+=3)w.x=r[b+0],w.y=r[b+1],w.z=r[b+2],w.normalize().multiplyScalar(x),r[b+0]=w.x,r[b+1]=w.y,r[b+2]=w.z}function u(){let x=new H;for(let w=0;w<r.length;w+=3){x.x=r[w+0],x.y=r[w+1],x.z=r[w+2];let b=m(x)/2/Math.PI+.5,A=g(x)/Math.PI+.5;o.push(b,1-A)}p(),h()}function h(){for(let x=0;x<o.length;x+=6){let w=o[x+0],b=o[x+2],A=o[x+4],T=Math.max(w,b,A),_=Math.min(w,b,A);T>.9&&_<.1&&(w<.2&&(o[x+0]+=1),b<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,w){let b=x*3;w.x=t[b+0],w.y=t[b+1],w.z=t[b+2]}function p(){let x=new H,w=new H,b=new H,A=new H,T=new Xt,_=new Xt,S=new Xt;for(let D=0,L=0;D<r.length;D+=9,L+=6){x.set(r[D+0],r[D+1],r[D+2]),w.set(r[D+3],r[D+4],r[D+5]),b.set(r[D+6],r[D+7],r[D+8]),T.set(o[L+0],o[L+1]),_.set(o[L+2],o[L+3]),S.set(o[L+4],o[L+5]),A.copy(x).add(w).add(b).divideScalar(3);let N=m(A);y(T,L+0,x,N),y(_,L+2,w,N),y(S,L+4,b,N)}}function y(x,w,b,A){A<0&&x.x===1&&(o[w]=x.x-1),b.x===0&&b.z===0&&(o[w]=A/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var uc=class n extends Ae{constructor(t=[new Xt(0,-.5),new Xt(.5,0),new Xt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Me(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new H,d=new Xt,f=new H,p=new H,y=new H,m=0,g=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:y.normalize(),l.push(y.x,y.y,y.z);break;default:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(p)}for(let x=0;x<=e;x++){let w=i+x*u*s,b=Math.sin(w),A=Math.cos(w);for(let T=0;T<=t.length-1;T++){h.x=t[T].x*b,h.y=t[T].y,h.z=t[T].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=T/(t.length-1),a.push(d.x,d.y);let _=l[3*T+0]*b,S=l[3*T+1],D=l[3*T+0]*A;c.push(_,S,D)}}for(let x=0;x<e;x++)for(let w=0;w<t.length-1;w++){let b=w+x*t.length,A=b,T=b+t.length,_=b+t.length+1,S=b+1;r.push(A,T,S),r.push(_,S,T)}this.setIndex(r),this.setAttribute("position",new Pe(o,3)),this.setAttribute("uv",new Pe(a,2)),this.setAttribute("normal",new Pe(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},hc=class n extends hh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},dc=class n extends Ae{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],y=[],m=[];for(let g=0;g<u;g++){let x=g*d-o;for(let w=0;w<c;w++){let b=w*h-r;p.push(b,-x,0),y.push(0,0,1),m.push(w/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let w=x+c*g,b=x+c*(g+1),A=x+1+c*(g+1),T=x+1+c*g;f.push(w,b,T),f.push(b,A,T)}this.setIndex(f),this.setAttribute("position",new Pe(p,3)),this.setAttribute("normal",new Pe(y,3)),this.setAttribute("uv",new Pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var wr=class n extends Ae{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,d=new H,f=[],p=[],y=[],m=[];for(let g=0;g<=i;g++){let x=[],w=g/i,b=o+w*a,A=t*Math.cos(b),T=Math.sqrt(t*t-A*A),_=0;g===0&&o===0?_=.5/e:g===i&&l===Math.PI&&(_=-.5/e);for(let S=0;S<=e;S++){let D=S/e,L=s+D*r;h.x=-T*Math.cos(L),h.y=A,h.z=T*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),m.push(D+_,1-w),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let w=u[g][x+1],b=u[g][x],A=u[g+1][x],T=u[g+1][x+1];(g!==0||o>0)&&f.push(w,b,T),(g!==i-1||l<Math.PI)&&f.push(b,A,T)}this.setIndex(f),this.setAttribute("position",new Pe(p,3)),this.setAttribute("normal",new Pe(y,3)),this.setAttribute("uv",new Pe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Fa=class n extends Ae{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new H,f=new H,p=new H;for(let y=0;y<=i;y++){let m=o+y/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(x),f.y=(t+e*Math.cos(m))*Math.sin(x),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(g/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let m=1;m<=s;m++){let g=(s+1)*y+m-1,x=(s+1)*(y-1)+m-1,w=(s+1)*(y-1)+m,b=(s+1)*y+m;l.push(g,x,b),l.push(x,w,b)}this.setIndex(l),this.setAttribute("position",new Pe(c,3)),this.setAttribute("normal",new Pe(u,3)),this.setAttribute("uv",new Pe(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Io(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(B_(s))s.isRenderTargetTexture?(ee("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(B_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function ui(n){let t={};for(let e=0;e<n.length;e++){let i=Io(n[e]);for(let s in i)t[s]=i[s]}return t}function B_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Jw(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function gm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ce.workingColorSpace}var Cx={clone:Io,merge:ui},Kw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Qw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,cs=class extends js{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Kw,this.fragmentShader=Qw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Io(t.uniforms),this.uniformsGroups=Jw(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ie().setHex(s.value);break;case"v2":this.uniforms[i].value=new Xt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new xn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ce().fromArray(s.value);break;case"m4":this.uniforms[i].value=new _e().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},dh=class extends cs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var fh=class extends js{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=mx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ph=class extends js{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Sa(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Wu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var jr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},mh=class extends jr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Pp,endingEnd:Pp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ip:r=t,a=2*e-i;break;case Lp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Ip:o=t,l=2*i-e;break;case Lp:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),y=p*p,m=y*p,g=-d*m+2*d*y-d*p,x=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*y+.5*p,b=f*m-f*y;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[c+A]+w*o[l+A]+b*o[h+A];return r}},gh=class extends jr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},_h=class extends jr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},xh=class extends jr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),y=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let y=o[c+p],m=o[l+p],g=f*d+p*2,x=h[g],w=h[g+1],b=t*d+p*2,A=u[b],T=u[b+1],_=eE(i,e,x,A,s);r[p]=Px(_,y,w,T,m)}return r}};function Px(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function tE(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function eE(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Px(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=tE(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ji=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Sa(e,this.TimeBufferType),this.values=Sa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Sa(t.times,Array),values:Sa(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Wu(t.settings)&&(i.settings={inTangents:Sa(t.settings.inTangents,Array),outTangents:Sa(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new _h(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new gh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new mh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new xh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Wl:e=this.InterpolantFactoryMethodDiscrete;break;case sh:e=this.InterpolantFactoryMethodLinear;break;case Xu:e=this.InterpolantFactoryMethodSmooth;break;case Cp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ee("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Wl;case this.InterpolantFactoryMethodLinear:return sh;case this.InterpolantFactoryMethodSmooth:return Xu;case this.InterpolantFactoryMethodBezier:return Cp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Wu(this.settings)&&(k_(this.settings.inTangents,t),k_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Wu(this.settings)&&(z_(this.settings.inTangents,t),z_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&gw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Xu,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let y=e[h+p];if(y!==e[d+p]||y!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Wu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function k_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function z_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Ji.prototype.ValueTypeName="";Ji.prototype.TimeBufferType=Float32Array;Ji.prototype.ValueBufferType=Float32Array;Ji.prototype.DefaultInterpolation=sh;var Jr=class extends Ji{constructor(t,e,i){super(t,e,i)}};Jr.prototype.ValueTypeName="bool";Jr.prototype.ValueBufferType=Array;Jr.prototype.DefaultInterpolation=Wl;Jr.prototype.InterpolantFactoryMethodLinear=void 0;Jr.prototype.InterpolantFactoryMethodSmooth=void 0;var yh=class extends Ji{constructor(t,e,i,s){super(t,e,i,s)}};yh.prototype.ValueTypeName="color";var vh=class extends Ji{constructor(t,e,i,s){super(t,e,i,s)}};vh.prototype.ValueTypeName="number";var bh=class extends jr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)cn.slerpFlat(r,0,o,c-a,o,c,l);return r}},fc=class extends Ji{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new bh(this.times,this.values,this.getValueSize(),t)}};fc.prototype.ValueTypeName="quaternion";fc.prototype.InterpolantFactoryMethodSmooth=void 0;var Kr=class extends Ji{constructor(t,e,i){super(t,e,i)}};Kr.prototype.ValueTypeName="string";Kr.prototype.ValueBufferType=Array;Kr.prototype.DefaultInterpolation=Wl;Kr.prototype.InterpolantFactoryMethodLinear=void 0;Kr.prototype.InterpolantFactoryMethodSmooth=void 0;var Mh=class extends Ji{constructor(t,e,i,s){super(t,e,i,s)}};Mh.prototype.ValueTypeName="vector";var Sh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ix=new Sh,wh=class{constructor(t){this.manager=t!==void 0?t:Ix,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};wh.DEFAULT_MATERIAL_NAME="__DEFAULT";var qu=new H,$u=new cn,Xs=new H,pc=class extends Ei{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new _e,this.projectionMatrix=new _e,this.projectionMatrixInverse=new _e,this.coordinateSystem=as,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(qu,$u,Xs),Xs.x===1&&Xs.y===1&&Xs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qu,$u,Xs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(qu,$u,Xs),Xs.x===1&&Xs.y===1&&Xs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qu,$u,Xs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Yr=new H,H_=new Xt,G_=new Xt,Mi=class extends pc{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ca*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Gl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ca*2*Math.atan(Math.tan(Gl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Yr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Yr.x,Yr.y).multiplyScalar(-t/Yr.z),Yr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Yr.x,Yr.y).multiplyScalar(-t/Yr.z)}getViewSize(t,e){return this.getViewBounds(t,H_,G_),e.subVectors(G_,H_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Gl*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Eh=class extends pc{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var wa=-90,Ea=1,Oa=class extends Ei{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Mi(wa,Ea,t,e);s.layers=this.layers,this.add(s);let r=new Mi(wa,Ea,t,e);r.layers=this.layers,this.add(r);let o=new Mi(wa,Ea,t,e);o.layers=this.layers,this.add(o);let a=new Mi(wa,Ea,t,e);a.layers=this.layers,this.add(a);let l=new Mi(wa,Ea,t,e);l.layers=this.layers,this.add(l);let c=new Mi(wa,Ea,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===as)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Xl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Th=class extends Mi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var _m="\\[\\]\\.:\\/",nE=new RegExp("["+_m+"]","g"),xm="[^"+_m+"]",iE="[^"+_m.replace("\\.","")+"]",sE=/((?:WC+[\/:])*)/.source.replace("WC",xm),rE=/(WCOD+)?/.source.replace("WCOD",iE),oE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xm),aE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xm),lE=new RegExp("^"+sE+rE+oE+aE+"$"),cE=["material","materials","bones","map"],Np=class{constructor(t,e,i){let s=i||ln.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},ln=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(nE,"")}static parseTrackName(t){let e=lE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);cE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ee("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ln.Composite=Np;ln.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ln.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ln.prototype.GetterByBindingType=[ln.prototype._getValue_direct,ln.prototype._getValue_array,ln.prototype._getValue_arrayElement,ln.prototype._getValue_toArray];ln.prototype.SetterByBindingTypeAndVersioning=[[ln.prototype._setValue_direct,ln.prototype._setValue_direct_setNeedsUpdate,ln.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_array,ln.prototype._setValue_array_setNeedsUpdate,ln.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_arrayElement,ln.prototype._setValue_arrayElement_setNeedsUpdate,ln.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_fromArray,ln.prototype._setValue_fromArray_setNeedsUpdate,ln.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var oL=new Float32Array(1);var V_=new _e,mc=class{constructor(t,e,i=0,s=1/0){this.ray=new br(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Ia,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):re("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return V_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(V_),this}intersectObject(t,e=!0,i=[]){return Up(t,this,i,e),i.sort(W_),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Up(t[s],this,i,e);return i.sort(W_),i}};function W_(n,t){return n.distance-t.distance}function Up(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Up(r[o],t,e,!0)}}var Ba=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Me(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Me(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Fp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var gc=class extends Ss{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function ym(n,t,e,i){let s=uE(i);switch(e){case nm:return n*t;case Dh:return n*t/s.components*s.byteLength;case Nh:return n*t/s.components*s.byteLength;case no:return n*t*2/s.components*s.byteLength;case Uh:return n*t*2/s.components*s.byteLength;case im:return n*t*3/s.components*s.byteLength;case Ts:return n*t*4/s.components*s.byteLength;case Fh:return n*t*4/s.components*s.byteLength;case yc:case vc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case bc:case Mc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Bh:case zh:return Math.max(n,16)*Math.max(t,8)/4;case Oh:case kh:return Math.max(n,8)*Math.max(t,8)/2;case Hh:case Gh:case Wh:case qh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Vh:case Sc:case $h:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Xh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Yh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Zh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case jh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Jh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Kh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Qh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case td:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case ed:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case nd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case id:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case sd:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case rd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case od:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case ad:case ld:case cd:return Math.ceil(n/4)*Math.ceil(t/4)*16;case ud:case hd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case wc:case dd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function uE(n){switch(n){case Ki:case Kp:return{byteLength:1,components:1};case Ga:case Qp:case Es:return{byteLength:2,components:1};case Ih:case Lh:return{byteLength:2,components:4};case ws:case Ph:case us:return{byteLength:4,components:1};case tm:case em:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ee("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Qx(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function mE(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],y=h[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let y=h[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_E=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,xE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ME=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,SE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wE=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,EE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,TE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,AE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,RE=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,CE=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,PE=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,IE=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,LE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,DE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,NE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,UE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,FE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,OE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,BE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,kE=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,zE=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,HE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,GE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,VE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,WE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qE="gl_FragColor = linearToOutputTexel( gl_FragColor );",$E=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,XE=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,YE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ZE=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,jE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,JE=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,KE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,QE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,t1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,e1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,n1=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,i1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,s1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,r1=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,o1=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,a1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,l1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,c1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,u1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,h1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,d1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,f1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,p1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,m1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,g1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,x1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,y1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,v1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,b1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,M1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,S1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,w1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,E1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,T1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,A1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,R1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,C1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,P1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,I1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,L1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,D1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,N1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,U1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,F1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,O1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,B1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,k1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,z1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,H1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,G1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,V1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,W1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,q1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,X1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Y1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Z1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,j1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,J1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,K1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Q1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,tT=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,eT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nT=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,iT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sT=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,rT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,oT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,aT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,cT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,uT=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,hT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,dT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,fT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,pT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,mT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gT=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_T=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xT=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,MT=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ST=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,wT=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,ET=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,TT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AT=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,RT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,CT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,PT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,IT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,LT=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,DT=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,NT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,FT=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,OT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,BT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,zT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,HT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,GT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,WT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$T=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,XT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,YT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ve={alphahash_fragment:gE,alphahash_pars_fragment:_E,alphamap_fragment:xE,alphamap_pars_fragment:yE,alphatest_fragment:vE,alphatest_pars_fragment:bE,aomap_fragment:ME,aomap_pars_fragment:SE,batching_pars_vertex:wE,batching_vertex:EE,begin_vertex:TE,beginnormal_vertex:AE,bsdfs:RE,iridescence_fragment:CE,bumpmap_pars_fragment:PE,clipping_planes_fragment:IE,clipping_planes_pars_fragment:LE,clipping_planes_pars_vertex:DE,clipping_planes_vertex:NE,color_fragment:UE,color_pars_fragment:FE,color_pars_vertex:OE,color_vertex:BE,common:kE,defaultnormal_vertex:zE,displacementmap_pars_vertex:HE,displacementmap_vertex:GE,emissivemap_fragment:VE,emissivemap_pars_fragment:WE,colorspace_fragment:qE,colorspace_pars_fragment:$E,envmap_fragment:XE,envmap_common_pars_fragment:YE,envmap_pars_fragment:ZE,envmap_pars_vertex:jE,envmap_physical_pars_fragment:a1,envmap_vertex:JE,fog_vertex:KE,fog_pars_vertex:QE,fog_fragment:t1,fog_pars_fragment:e1,gradientmap_pars_fragment:n1,lightmap_pars_fragment:i1,lights_lambert_fragment:s1,lights_lambert_pars_fragment:r1,lights_pars_begin:o1,lights_toon_fragment:l1,lights_toon_pars_fragment:c1,lights_phong_fragment:u1,lights_phong_pars_fragment:h1,lights_physical_fragment:d1,lights_physical_pars_fragment:f1,lights_fragment_begin:p1,lights_fragment_maps:m1,lights_fragment_end:g1,lightprobes_pars_fragment:_1,logdepthbuf_fragment:x1,logdepthbuf_pars_fragment:y1,logdepthbuf_pars_vertex:v1,logdepthbuf_vertex:b1,map_fragment:M1,map_pars_fragment:S1,map_particle_fragment:w1,map_particle_pars_fragment:E1,metalnessmap_fragment:T1,metalnessmap_pars_fragment:A1,morphinstance_vertex:R1,morphcolor_vertex:C1,morphnormal_vertex:P1,morphtarget_pars_vertex:I1,morphtarget_vertex:L1,normal_fragment_begin:D1,normal_fragment_maps:N1,normal_pars_fragment:U1,normal_pars_vertex:F1,normal_vertex:O1,normalmap_pars_fragment:B1,clearcoat_normal_fragment_begin:k1,clearcoat_normal_fragment_maps:z1,clearcoat_pars_fragment:H1,iridescence_pars_fragment:G1,opaque_fragment:V1,packing:W1,premultiplied_alpha_fragment:q1,project_vertex:$1,dithering_fragment:X1,dithering_pars_fragment:Y1,roughnessmap_fragment:Z1,roughnessmap_pars_fragment:j1,shadowmap_pars_fragment:J1,shadowmap_pars_vertex:K1,shadowmap_vertex:Q1,shadowmask_pars_fragment:tT,skinbase_vertex:eT,skinning_pars_vertex:nT,skinning_vertex:iT,skinnormal_vertex:sT,specularmap_fragment:rT,specularmap_pars_fragment:oT,tonemapping_fragment:aT,tonemapping_pars_fragment:lT,transmission_fragment:cT,transmission_pars_fragment:uT,uv_pars_fragment:hT,uv_pars_vertex:dT,uv_vertex:fT,worldpos_vertex:pT,background_vert:mT,background_frag:gT,backgroundCube_vert:_T,backgroundCube_frag:xT,cube_vert:yT,cube_frag:vT,depth_vert:bT,depth_frag:MT,distance_vert:ST,distance_frag:wT,equirect_vert:ET,equirect_frag:TT,linedashed_vert:AT,linedashed_frag:RT,meshbasic_vert:CT,meshbasic_frag:PT,meshlambert_vert:IT,meshlambert_frag:LT,meshmatcap_vert:DT,meshmatcap_frag:NT,meshnormal_vert:UT,meshnormal_frag:FT,meshphong_vert:OT,meshphong_frag:BT,meshphysical_vert:kT,meshphysical_frag:zT,meshtoon_vert:HT,meshtoon_frag:GT,points_vert:VT,points_frag:WT,shadow_vert:qT,shadow_frag:$T,sprite_vert:XT,sprite_frag:YT},Ot={common:{diffuse:{value:new ie(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new Xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ie(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ie(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new ie(16777215)},opacity:{value:1},center:{value:new Xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},er={basic:{uniforms:ui([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:ve.meshbasic_vert,fragmentShader:ve.meshbasic_frag},lambert:{uniforms:ui([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)},envMapIntensity:{value:1}}]),vertexShader:ve.meshlambert_vert,fragmentShader:ve.meshlambert_frag},phong:{uniforms:ui([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)},specular:{value:new ie(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ve.meshphong_vert,fragmentShader:ve.meshphong_frag},standard:{uniforms:ui([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ve.meshphysical_vert,fragmentShader:ve.meshphysical_frag},toon:{uniforms:ui([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)}}]),vertexShader:ve.meshtoon_vert,fragmentShader:ve.meshtoon_frag},matcap:{uniforms:ui([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:ve.meshmatcap_vert,fragmentShader:ve.meshmatcap_frag},points:{uniforms:ui([Ot.points,Ot.fog]),vertexShader:ve.points_vert,fragmentShader:ve.points_frag},dashed:{uniforms:ui([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ve.linedashed_vert,fragmentShader:ve.linedashed_frag},depth:{uniforms:ui([Ot.common,Ot.displacementmap]),vertexShader:ve.depth_vert,fragmentShader:ve.depth_frag},normal:{uniforms:ui([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:ve.meshnormal_vert,fragmentShader:ve.meshnormal_frag},sprite:{uniforms:ui([Ot.sprite,Ot.fog]),vertexShader:ve.sprite_vert,fragmentShader:ve.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ve.background_vert,fragmentShader:ve.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:ve.backgroundCube_vert,fragmentShader:ve.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ve.cube_vert,fragmentShader:ve.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ve.equirect_vert,fragmentShader:ve.equirect_frag},distance:{uniforms:ui([Ot.common,Ot.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ve.distance_vert,fragmentShader:ve.distance_frag},shadow:{uniforms:ui([Ot.lights,Ot.fog,{color:{value:new ie(0)},opacity:{value:1}}]),vertexShader:ve.shadow_vert,fragmentShader:ve.shadow_frag}};er.physical={uniforms:ui([er.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new Xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ce},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new ie(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new Xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new ie(0)},specularColor:{value:new ie(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new Xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:ve.meshphysical_vert,fragmentShader:ve.meshphysical_frag};var md={r:0,b:0,g:0},ZT=new _e,ty=new ce;ty.set(-1,0,0,0,1,0,0,0,1);function jT(n,t,e,i,s,r){let o=new ie(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let b=x.backgroundBlurriness>0;w=t.get(w,b)}return w}function p(x){let w=!1,b=f(x);b===null?m(o,a):b&&b.isColor&&(m(b,1),w=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,w){let b=f(w);b&&b.isCubeTexture?(c===void 0&&(c=new mn(new ls(1,1,1),new cs({name:"BackgroundCubeMaterial",uniforms:Io(er.backgroundCube.uniforms),vertexShader:er.backgroundCube.vertexShader,fragmentShader:er.backgroundCube.fragmentShader,side:Ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,T,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ZT.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ty),c.material.toneMapped=Ce.getTransfer(b.colorSpace)!==He,(u!==b||h!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new mn(new dc(2,2),new cs({name:"BackgroundMaterial",uniforms:Io(er.background.uniforms),vertexShader:er.background.vertexShader,fragmentShader:er.background.fragmentShader,side:eo,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Ce.getTransfer(b.colorSpace)!==He,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,w){x.getRGB(md,gm(n)),e.buffers.color.setClear(md.r,md.g,md.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:y,dispose:g}}function JT(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(N,z,W,B,X){let I=!1,U=h(N,B,W,z);r!==U&&(r=U,c(r.object)),I=f(N,B,W,X),I&&p(N,B,W,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(I||o)&&(o=!1,b(N,z,W,B),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,z,W,B){let X=B.wireframe===!0,I=i[z.id];I===void 0&&(I={},i[z.id]=I);let U=N.isInstancedMesh===!0?N.id:0,Z=I[U];Z===void 0&&(Z={},I[U]=Z);let q=Z[W.id];q===void 0&&(q={},Z[W.id]=q);let j=q[X];return j===void 0&&(j=d(l()),q[X]=j),j}function d(N){let z=[],W=[],B=[];for(let X=0;X<e;X++)z[X]=0,W[X]=0,B[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:B,object:N,attributes:{},index:null}}function f(N,z,W,B){let X=r.attributes,I=z.attributes,U=0,Z=W.getAttributes();for(let q in Z)if(Z[q].location>=0){let et=X[q],ht=I[q];if(ht===void 0&&(q==="instanceMatrix"&&N.instanceMatrix&&(ht=N.instanceMatrix),q==="instanceColor"&&N.instanceColor&&(ht=N.instanceColor)),et===void 0||et.attribute!==ht||ht&&et.data!==ht.data)return!0;U++}return r.attributesNum!==U||r.index!==B}function p(N,z,W,B){let X={},I=z.attributes,U=0,Z=W.getAttributes();for(let q in Z)if(Z[q].location>=0){let et=I[q];et===void 0&&(q==="instanceMatrix"&&N.instanceMatrix&&(et=N.instanceMatrix),q==="instanceColor"&&N.instanceColor&&(et=N.instanceColor));let ht={};ht.attribute=et,et&&et.data&&(ht.data=et.data),X[q]=ht,U++}r.attributes=X,r.attributesNum=U,r.index=B}function y(){let N=r.newAttributes;for(let z=0,W=N.length;z<W;z++)N[z]=0}function m(N){g(N,0)}function g(N,z){let W=r.newAttributes,B=r.enabledAttributes,X=r.attributeDivisors;W[N]=1,B[N]===0&&(n.enableVertexAttribArray(N),B[N]=1),X[N]!==z&&(n.vertexAttribDivisor(N,z),X[N]=z)}function x(){let N=r.newAttributes,z=r.enabledAttributes;for(let W=0,B=z.length;W<B;W++)z[W]!==N[W]&&(n.disableVertexAttribArray(W),z[W]=0)}function w(N,z,W,B,X,I,U){U===!0?n.vertexAttribIPointer(N,z,W,X,I):n.vertexAttribPointer(N,z,W,B,X,I)}function b(N,z,W,B){y();let X=B.attributes,I=W.getAttributes(),U=z.defaultAttributeValues;for(let Z in I){let q=I[Z];if(q.location>=0){let j=X[Z];if(j===void 0&&(Z==="instanceMatrix"&&N.instanceMatrix&&(j=N.instanceMatrix),Z==="instanceColor"&&N.instanceColor&&(j=N.instanceColor)),j!==void 0){let et=j.normalized,ht=j.itemSize,ft=t.get(j);if(ft===void 0)continue;let it=ft.buffer,vt=ft.type,xt=ft.bytesPerElement,Tt=vt===n.INT||vt===n.UNSIGNED_INT||j.gpuType===Ph;if(j.isInterleavedBufferAttribute){let At=j.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,pe=j.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Zt=0;Zt<q.locationSize;Zt++)g(q.location+Zt,At.meshPerAttribute);N.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Zt=0;Zt<q.locationSize;Zt++)m(q.location+Zt);n.bindBuffer(n.ARRAY_BUFFER,it);for(let Zt=0;Zt<q.locationSize;Zt++)w(q.location+Zt,ht/q.locationSize,vt,et,Jt*xt,(pe+ht/q.locationSize*Zt)*xt,Tt)}else{if(j.isInstancedBufferAttribute){for(let At=0;At<q.locationSize;At++)g(q.location+At,j.meshPerAttribute);N.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let At=0;At<q.locationSize;At++)m(q.location+At);n.bindBuffer(n.ARRAY_BUFFER,it);for(let At=0;At<q.locationSize;At++)w(q.location+At,ht/q.locationSize,vt,et,ht*xt,ht/q.locationSize*At*xt,Tt)}}else if(U!==void 0){let et=U[Z];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(q.location,et);break;case 3:n.vertexAttrib3fv(q.location,et);break;case 4:n.vertexAttrib4fv(q.location,et);break;default:n.vertexAttrib1fv(q.location,et)}}}}x()}function A(){D();for(let N in i){let z=i[N];for(let W in z){let B=z[W];for(let X in B){let I=B[X];for(let U in I)u(I[U].object),delete I[U];delete B[X]}}delete i[N]}}function T(N){if(i[N.id]===void 0)return;let z=i[N.id];for(let W in z){let B=z[W];for(let X in B){let I=B[X];for(let U in I)u(I[U].object),delete I[U];delete B[X]}}delete i[N.id]}function _(N){for(let z in i){let W=i[z];for(let B in W){let X=W[B];if(X[N.id]===void 0)continue;let I=X[N.id];for(let U in I)u(I[U].object),delete I[U];delete X[N.id]}}}function S(N){for(let z in i){let W=i[z],B=N.isInstancedMesh===!0?N.id:0,X=W[B];if(X!==void 0){for(let I in X){let U=X[I];for(let Z in U)u(U[Z].object),delete U[Z];delete X[I]}delete W[B],Object.keys(W).length===0&&delete i[z]}}}function D(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:T,releaseStatesOfObject:S,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:m,disableUnusedAttributes:x}}function KT(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function QT(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Ts&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let S=_===Es&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==Ki&&_!==us&&!S&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ee("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ee("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ee("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:b,maxSamples:A,samples:T}}function tA(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ii,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,y=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,w=x*4,b=g.clippingState||null;l.value=b,b=u(p,d,w,f);for(let A=0;A!==w;++A)b[A]=e[A];g.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let y=h!==null?h.length:0,m=null;if(y!==0){if(m=l.value,p!==!0||m===null){let g=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,b=f;w!==y;++w,b+=4)o.copy(h[w]).applyMatrix4(x,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var Ac=class extends Yi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new rc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ls(5,5,5),r=new cs({name:"CubemapFromEquirect",uniforms:Io(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ti,blending:Ao});r.uniforms.tEquirect.value=e;let o=new mn(s,r),a=e.minFilter;return e.minFilter===Er&&(e.minFilter=Si),new Oa(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Lx=256,eA=3,nA=20,ey=256,ny=16,iA=3,sA=new H,rA=new ie,_d=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Oa(1,10,null),this._boxMesh=new mn(new ls(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=sA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(rA));let m=new Oa(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ux(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Nx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Lx,fm(t))}_fromTexture(t,e){t.mapping===Co||t.mapping===Ha?this._setSize(t.image.length===0?Lx:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Dx(t,!1,!1),i=Math.log2(t)-eA;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Dx(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Co||t.mapping===Ha?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ux()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Nx()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=oA(),this._integrationMaterial=aA());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/ny);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-iA)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(ey*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=lA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Dx(n,t,e){return new Ac(n,{minFilter:Er,generateMipmaps:t,type:Es,colorSpace:ql,depthBuffer:e})}function Rc(n,t,e){return new cs({name:n,uniforms:t,vertexShader:ve.cube_vert,fragmentShader:e,side:Ti,blending:Ao,depthTest:!1,depthWrite:!1})}function oA(){return Rc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${ey}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function aA(){return Rc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ny}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function lA(){return Rc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nA}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Nx(){return Rc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Ux(){return Rc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cA(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Ah||f===Rh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let y=new Ac(p.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Ah||f===Rh,y=f===Co||f===Ha;if(p||y){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new _d(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return p&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new _d(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===Ah?d.mapping=Co:f===Rh&&(d.mapping=Ha),d}function l(d){let f=0,p=6;for(let y=0;y<p;y++)d[y]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function uA(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Hl("WebGLRenderer: "+i+" extension not supported."),s}}}function hA(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(p){let y=p.attributes;for(let m in y)t.update(y[m],n.ARRAY_BUFFER)}function h(p){let y=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=y!==null?y.array.length:m.array.length/3-1,w=m.count>=65535?tc:Ql,b=new w(Math.ceil(x/3)*6,1),A=b.array;if(y!==null){let _=y.array;g=y.version;for(let S=0,D=0;S<x;S+=3){let L=_[S+0],N=_[S+1],z=_[S+2];A[D++]=L,A[D++]=N,A[D++]=N,A[D++]=z,A[D++]=z,A[D++]=L}}else{g=m.version;for(let _=0,S=0;_<x;_+=3){let D=_+0,L=_+1,N=_+2;A[S++]=D,A[S++]=L,A[S++]=L,A[S++]=N,A[S++]=N,A[S++]=D}}b.version=g;let T=r.get(p);T&&t.remove(T),r.set(p,b)}function d(p){let y=r.get(p);if(y){let m=p.index;m!==null&&y.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function dA(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let m=0;m<f;m++)y+=d[m];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function fA(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function pA(n,t,e){let i=new WeakMap,s=new xn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let D=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),y===!0&&(w=3);let b=a.attributes.position.count*w,A=1;b>t.maxTextureSize&&(A=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let T=new Float32Array(b*A*4*h),_=new jl(T,b,A,h);_.type=us,_.needsUpdate=!0;let S=w*4;for(let L=0;L<h;L++){let N=m[L],z=g[L],W=x[L],B=b*A*4*L;for(let X=0;X<N.count;X++){let I=X*S;f===!0&&(s.fromBufferAttribute(N,X),T[B+I+0]=s.x,T[B+I+1]=s.y,T[B+I+2]=s.z,T[B+I+3]=0),p===!0&&(s.fromBufferAttribute(z,X),T[B+I+4]=s.x,T[B+I+5]=s.y,T[B+I+6]=s.z,T[B+I+7]=0),y===!0&&(s.fromBufferAttribute(W,X),T[B+I+8]=s.x,T[B+I+9]=s.y,T[B+I+10]=s.z,T[B+I+11]=W.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new Xt(b,A)},i.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function mA(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var gA={[Wp]:"LINEAR_TONE_MAPPING",[qp]:"REINHARD_TONE_MAPPING",[$p]:"CINEON_TONE_MAPPING",[Xp]:"ACES_FILMIC_TONE_MAPPING",[Zp]:"AGX_TONE_MAPPING",[jp]:"NEUTRAL_TONE_MAPPING",[Yp]:"CUSTOM_TONE_MAPPING"};function _A(n,t,e,i,s,r){let o=new Yi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ae;u.setAttribute("position",new Pe([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Pe([0,2,0,0,2,0],2));let h=new dh({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new mn(u,h),f=new Eh(-1,1,1,-1,0,1),p=null,y=null,m=!1,g,x=null,w=[],b=!1;this.setSize=function(A,T){o.setSize(A,T),a!==null&&a.setSize(A,T),l!==null&&l.setSize(A,T);for(let _=0;_<w.length;_++){let S=w[_];S.setSize&&S.setSize(A,T)}},this.setEffects=function(A){w=A,b=w.length>0&&w[0].isRenderPass===!0;let T=o.width,_=o.height;w.length>0&&a===null&&(a=new Yi(T,_,{type:Es,depthBuffer:!1,stencilBuffer:!1}),l=new Yi(T,_,{type:Es,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&w.some(D=>D.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Sr(T,_),r===!0&&(c.format=Tr,c.type=Po)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let D=0;D<w.length;D++){let L=w[D];L.setSize&&L.setSize(T,_),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(A,T){if(m||A.toneMapping===Qs&&w.length===0)return!1;if(x=T,T!==null){let _=T.width,S=T.height;(o.width!==_||o.height!==S)&&this.setSize(_,S)}return b===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=Qs,!0},this.hasRenderPass=function(){return b},this.end=function(A,T){A.toneMapping=g,m=!0;let _=o,S=a;for(let D=0;D<w.length;D++){let L=w[D];L.enabled!==!1&&(L.render(A,S,_,T),L.needsSwap!==!1&&(_=S,S=S===a?l:a))}if(p!==A.outputColorSpace||y!==A.toneMapping){p=A.outputColorSpace,y=A.toneMapping,h.defines={},Ce.getTransfer(p)===He&&(h.defines.SRGB_TRANSFER="");let D=gA[y];D&&(h.defines[D]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(x),A.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var iy=new wi,sy=new Sr(1,1),ry=new ac(1),oy=new jl,ay=new ah,ly=new rc,Fx=[],Ox=[],Bx=new Float32Array(16),kx=new Float32Array(9),zx=new Float32Array(4);function Wa(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Fx[s];if(r===void 0&&(r=new Float32Array(s),Fx[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function zn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Hn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function yd(n,t){let e=Ox[t];e===void 0&&(e=new Int32Array(t),Ox[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function xA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function yA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(zn(e,t))return;n.uniform2fv(this.addr,t),Hn(e,t)}}function vA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(zn(e,t))return;n.uniform3fv(this.addr,t),Hn(e,t)}}function bA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(zn(e,t))return;n.uniform4fv(this.addr,t),Hn(e,t)}}function MA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(zn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Hn(e,t)}else{if(zn(e,i))return;zx.set(i),n.uniformMatrix2fv(this.addr,!1,zx),Hn(e,i)}}function SA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(zn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Hn(e,t)}else{if(zn(e,i))return;kx.set(i),n.uniformMatrix3fv(this.addr,!1,kx),Hn(e,i)}}function wA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(zn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Hn(e,t)}else{if(zn(e,i))return;Bx.set(i),n.uniformMatrix4fv(this.addr,!1,Bx),Hn(e,i)}}function EA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function TA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(zn(e,t))return;n.uniform2iv(this.addr,t),Hn(e,t)}}function AA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(zn(e,t))return;n.uniform3iv(this.addr,t),Hn(e,t)}}function RA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(zn(e,t))return;n.uniform4iv(this.addr,t),Hn(e,t)}}function CA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function PA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(zn(e,t))return;n.uniform2uiv(this.addr,t),Hn(e,t)}}function IA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(zn(e,t))return;n.uniform3uiv(this.addr,t),Hn(e,t)}}function LA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(zn(e,t))return;n.uniform4uiv(this.addr,t),Hn(e,t)}}function vd(n){return n.version===0&&(n.compareFunction=cm,n.needsUpdate=!0),n}function DA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=vd(sy):r=iy,e.setTexture2D(t||r,s)}function NA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||ay,s)}function UA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=vd(ry):r=ly,e.setTextureCube(t||r,s)}function FA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||oy,s)}function OA(n){switch(n){case 5126:return xA;case 35664:return yA;case 35665:return vA;case 35666:return bA;case 35674:return MA;case 35675:return SA;case 35676:return wA;case 5124:case 35670:return EA;case 35667:case 35671:return TA;case 35668:case 35672:return AA;case 35669:case 35673:return RA;case 5125:return CA;case 36294:return PA;case 36295:return IA;case 36296:return LA;case 35678:case 36198:case 36298:case 36306:case 35682:return DA;case 35679:case 36299:case 36307:return NA;case 35680:case 36300:case 36308:case 36293:return UA;case 36289:case 36303:case 36311:case 36292:return FA}}function BA(n,t){n.uniform1fv(this.addr,t)}function kA(n,t){let e=Wa(t,this.size,2);n.uniform2fv(this.addr,e)}function zA(n,t){let e=Wa(t,this.size,3);n.uniform3fv(this.addr,e)}function HA(n,t){let e=Wa(t,this.size,4);n.uniform4fv(this.addr,e)}function GA(n,t){let e=Wa(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function VA(n,t){let e=Wa(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function WA(n,t){let e=Wa(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function qA(n,t){n.uniform1iv(this.addr,t)}function $A(n,t){n.uniform2iv(this.addr,t)}function XA(n,t){n.uniform3iv(this.addr,t)}function YA(n,t){n.uniform4iv(this.addr,t)}function ZA(n,t){n.uniform1uiv(this.addr,t)}function jA(n,t){n.uniform2uiv(this.addr,t)}function JA(n,t){n.uniform3uiv(this.addr,t)}function KA(n,t){n.uniform4uiv(this.addr,t)}function QA(n,t,e){let i=this.cache,s=t.length,r=yd(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=vd(sy):o=iy;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function tR(n,t,e){let i=this.cache,s=t.length,r=yd(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||ay,r[o])}function eR(n,t,e){let i=this.cache,s=t.length,r=yd(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=vd(ry):o=ly;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function nR(n,t,e){let i=this.cache,s=t.length,r=yd(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||oy,r[o])}function iR(n){switch(n){case 5126:return BA;case 35664:return kA;case 35665:return zA;case 35666:return HA;case 35674:return GA;case 35675:return VA;case 35676:return WA;case 5124:case 35670:return qA;case 35667:case 35671:return $A;case 35668:case 35672:return XA;case 35669:case 35673:return YA;case 5125:return ZA;case 36294:return jA;case 36295:return JA;case 36296:return KA;case 35678:case 36198:case 36298:case 36306:case 35682:return QA;case 35679:case 36299:case 36307:return tR;case 35680:case 36300:case 36308:case 36293:return eR;case 36289:case 36303:case 36311:case 36292:return nR}}var Mm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=OA(e.type)}},Sm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=iR(e.type)}},wm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},vm=/(\w+)(\])?(\[|\.)?/g;function Hx(n,t){n.seq.push(t),n.map[t.id]=t}function sR(n,t,e){let i=n.name,s=i.length;for(vm.lastIndex=0;;){let r=vm.exec(i),o=vm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Hx(e,c===void 0?new Mm(a,n,t):new Sm(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new wm(a),Hx(e,h)),e=h}}}var Va=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);sR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Gx(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var rR=37297,oR=0;function aR(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Vx=new ce;function lR(n){Ce._getMatrix(Vx,Ce.workingColorSpace,n);let t=`mat3( ${Vx.elements.map(e=>e.toFixed(4))} )`;switch(Ce.getTransfer(n)){case $l:return[t,"LinearTransferOETF"];case He:return[t,"sRGBTransferOETF"];default:return ee("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Wx(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+aR(n.getShaderSource(t),a)}else return r}function cR(n,t){let e=lR(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var uR={[Wp]:"Linear",[qp]:"Reinhard",[$p]:"Cineon",[Xp]:"ACESFilmic",[Zp]:"AgX",[jp]:"Neutral",[Yp]:"Custom"};function hR(n,t){let e=uR[t];return e===void 0?(ee("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var gd=new H;function dR(){Ce.getLuminanceCoefficients(gd);let n=gd.x.toFixed(4),t=gd.y.toFixed(4),e=gd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function fR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tc).join(`
`)}function pR(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function mR(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Tc(n){return n!==""}function qx(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function $x(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var gR=/^[ \t]*#include +<([\w\d./]+)>/gm;function Em(n){return n.replace(gR,_R)}function _R(n,t){let e=ve[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Em(e)}var xR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Xx(n){return n.replace(xR,yR)}function yR(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Yx(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var vR={[_c]:"SHADOWMAP_TYPE_PCF",[ka]:"SHADOWMAP_TYPE_VSM"};function bR(n){return vR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var MR={[Ha]:"ENVMAP_MODE_REFRACTION"};function SR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":MR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var wR={[Vp]:"ENVMAP_BLENDING_MULTIPLY",[dx]:"ENVMAP_BLENDING_MIX",[fx]:"ENVMAP_BLENDING_ADD"};function ER(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":wR[n.combine]||"ENVMAP_BLENDING_NONE"}function TR(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=bR(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=SR(e),h=ER(e),d=fR(e),f=pR(r),p=s.createProgram(),y,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Tc).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Tc).join(`
`),m.length>0&&(m+=`
`)):(y=[Yx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tc).join(`
`),m=[Yx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Qs?"#define TONE_MAPPING":"",e.toneMapping!==Qs?ve.tonemapping_pars_fragment:"",e.toneMapping!==Qs?hR("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ve.colorspace_pars_fragment,cR("linearToOutputTexel",e.outputColorSpace),dR(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Tc).join(`
`)),o=Em(o),o=qx(o,e),o=$x(o,e),a=Em(a),a=qx(a,e),a=$x(a,e),o=Xx(o),a=Xx(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===hm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===hm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+y+o,w=g+m+a,b=Gx(s,s.VERTEX_SHADER,x),A=Gx(s,s.FRAGMENT_SHADER,w);s.attachShader(p,b),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(L){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(A)||"",B=N.trim(),X=z.trim(),I=W.trim(),U=!0,Z=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(U=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,A);else{let q=Wx(s,b,"vertex"),j=Wx(s,A,"fragment");re("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+B+`
`+q+`
`+j)}else B!==""?ee("WebGLProgram: Program Info Log:",B):(X===""||I==="")&&(Z=!1);Z&&(L.diagnostics={runnable:U,programLog:B,vertexShader:{log:X,prefix:y},fragmentShader:{log:I,prefix:m}})}s.deleteShader(b),s.deleteShader(A),_=new Va(s,p),S=mR(s,p)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let S;this.getAttributes=function(){return S===void 0&&T(this),S};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,rR)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=oR++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=A,this}var AR=0,Tm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Am(t),e.set(t,i)),i}},Am=class{constructor(t){this.id=AR++,this.code=t,this.usedTimes=0}};function RR(n){return n===no||n===Sc||n===wc}function CR(n,t,e,i,s,r){let o=new Ia,a=new Tm,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,S,D,L,N,z){let W=L.fog,B=N.geometry,X=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,I=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,U=t.get(_.envMap||X,I),Z=d[_.type],q=i.precision;_.precision!==null&&(q=i.getMaxPrecision(_.precision),q!==_.precision&&ee("WebGLProgram.getParameters:",_.precision,"not supported, using",q,"instead."));let j=B.morphAttributes.position||B.morphAttributes.normal||B.morphAttributes.color,et=j!==void 0?j.length:0,ht=0;B.morphAttributes.position!==void 0&&(ht=1),B.morphAttributes.normal!==void 0&&(ht=2),B.morphAttributes.color!==void 0&&(ht=3);let ft,it,vt,xt;if(Z){let Dt=er[Z];ft=Dt.vertexShader,it=Dt.fragmentShader}else{ft=_.vertexShader,it=_.fragmentShader;let Dt=a.getVertexShaderStage(_),ge=a.getFragmentShaderStage(_);a.update(_,Dt,ge),vt=Dt.id,xt=ge.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=N.isInstancedMesh===!0,pe=N.isBatchedMesh===!0,Zt=!!_.map,be=!!_.matcap,xe=!!U,de=xe&&U.isPMREMTexture===!0,hn=!!_.aoMap,en=!!_.lightMap,Cn=!!_.bumpMap&&_.wireframe===!1,Xe=!!_.normalMap,$n=!!_.displacementMap,Le=!!_.emissiveMap,Bn=!!_.metalnessMap,vn=!!_.roughnessMap,Pn=_.anisotropy>0,V=_.clearcoat>0,Nt=_.diffuseRoughness>0,ne=_.dispersion>0,me=_.retroreflectivity>0,Ct=_.iridescence>0,je=_.sheen>0,Yt=_.transmission>0,Qt=Pn&&!!_.anisotropyMap,F=V&&!!_.clearcoatMap,R=V&&!!_.clearcoatNormalMap,J=V&&!!_.clearcoatRoughnessMap,mt=Nt&&!!_.diffuseRoughnessMap,ct=Ct&&!!_.iridescenceMap,St=Ct&&!!_.iridescenceThicknessMap,wt=je&&!!_.sheenColorMap,rt=je&&!!_.sheenRoughnessMap,at=!!_.specularMap,bt=!!_.specularColorMap,G=!!_.specularIntensityMap,lt=Yt&&!!_.transmissionMap,ot=Yt&&!!_.thicknessMap,Pt=!!_.gradientMap,Mt=!!_.alphaMap,Rt=_.alphaTest>0,jt=!!_.alphaHash,oe=!!_.extensions,pt=Qs;_.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let Wt=de?U.isCompressedCubeTexture?U.image[0].mipmaps:U.mipmaps:null,ae={shaderID:Z,shaderType:_.type,shaderName:_.name,vertexShader:ft,fragmentShader:it,defines:_.defines,customVertexShaderID:vt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:q,batching:pe,batchingColor:pe&&N._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&N.instanceColor!==null,instancingMorph:Jt&&N.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:Ce.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Zt,matcap:be,envMap:xe,envMapMode:xe&&U.mapping,envMapPMREM:de,envMapMaxLod:de?Wt.length-1:null,envMapSize:de?Wt[0].width:null,aoMap:hn,lightMap:en,bumpMap:Cn,normalMap:Xe,displacementMap:$n,emissiveMap:Le,normalMapObjectSpace:Xe&&_.normalMapType===gx,normalMapTangentSpace:Xe&&_.normalMapType===sm,packedNormalMap:Xe&&_.normalMapType===sm&&RR(_.normalMap.format),metalnessMap:Bn,roughnessMap:vn,anisotropy:Pn,anisotropyMap:Qt,clearcoat:V,clearcoatMap:F,clearcoatNormalMap:R,clearcoatRoughnessMap:J,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:ne,retroreflection:me,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:St,sheen:je,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:bt,specularIntensityMap:G,transmission:Yt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:_.transparent===!1&&_.blending===za&&_.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:jt,combine:_.combine,mapUv:Zt&&f(_.map.channel),aoMapUv:hn&&f(_.aoMap.channel),lightMapUv:en&&f(_.lightMap.channel),bumpMapUv:Cn&&f(_.bumpMap.channel),normalMapUv:Xe&&f(_.normalMap.channel),displacementMapUv:$n&&f(_.displacementMap.channel),emissiveMapUv:Le&&f(_.emissiveMap.channel),metalnessMapUv:Bn&&f(_.metalnessMap.channel),roughnessMapUv:vn&&f(_.roughnessMap.channel),anisotropyMapUv:Qt&&f(_.anisotropyMap.channel),clearcoatMapUv:F&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(_.sheenRoughnessMap.channel),specularMapUv:at&&f(_.specularMap.channel),specularColorMapUv:bt&&f(_.specularColorMap.channel),specularIntensityMapUv:G&&f(_.specularIntensityMap.channel),transmissionMapUv:lt&&f(_.transmissionMap.channel),thicknessMapUv:ot&&f(_.thicknessMap.channel),alphaMapUv:Mt&&f(_.alphaMap.channel),vertexTangents:!!B.attributes.tangent&&(Xe||Pn),vertexNormals:!!B.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!B.attributes.color&&B.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!B.attributes.uv&&(Zt||Mt),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||B.attributes.normal===void 0&&Xe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:B.attributes.position!==void 0,morphTargets:B.morphAttributes.position!==void 0,morphNormals:B.morphAttributes.normal!==void 0,morphColors:B.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ht,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:z.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:Zt&&_.map.isVideoTexture===!0&&Ce.getTransfer(_.map.colorSpace)===He,decodeVideoTextureEmissive:Le&&_.emissiveMap.isVideoTexture===!0&&Ce.getTransfer(_.emissiveMap.colorSpace)===He,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ni,flipSided:_.side===Ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:oe&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(oe&&_.extensions.multiDraw===!0||pe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ae.vertexUv1s=l.has(1),ae.vertexUv2s=l.has(2),ae.vertexUv3s=l.has(3),l.clear(),ae}function y(_){let S=[];if(_.shaderID?S.push(_.shaderID):(S.push(_.customVertexShaderID),S.push(_.customFragmentShaderID)),_.defines!==void 0)for(let D in _.defines)S.push(D),S.push(_.defines[D]);return _.isRawShaderMaterial===!1&&(m(S,_),g(S,_),S.push(n.outputColorSpace)),S.push(_.customProgramCacheKey),S.join()}function m(_,S){_.push(S.precision),_.push(S.outputColorSpace),_.push(S.envMapMode),_.push(S.envMapPMREM),_.push(S.envMapMaxLod),_.push(S.envMapSize),_.push(S.mapUv),_.push(S.alphaMapUv),_.push(S.lightMapUv),_.push(S.aoMapUv),_.push(S.bumpMapUv),_.push(S.normalMapUv),_.push(S.displacementMapUv),_.push(S.emissiveMapUv),_.push(S.metalnessMapUv),_.push(S.roughnessMapUv),_.push(S.anisotropyMapUv),_.push(S.clearcoatMapUv),_.push(S.clearcoatNormalMapUv),_.push(S.clearcoatRoughnessMapUv),_.push(S.diffuseRoughnessMapUv),_.push(S.iridescenceMapUv),_.push(S.iridescenceThicknessMapUv),_.push(S.sheenColorMapUv),_.push(S.sheenRoughnessMapUv),_.push(S.specularMapUv),_.push(S.specularColorMapUv),_.push(S.specularIntensityMapUv),_.push(S.transmissionMapUv),_.push(S.thicknessMapUv),_.push(S.combine),_.push(S.fogExp2),_.push(S.sizeAttenuation),_.push(S.morphTargetsCount),_.push(S.numSunLights),_.push(S.numDirLights),_.push(S.numPointLights),_.push(S.numSpotLights),_.push(S.numSpotLightMaps),_.push(S.numHemiLights),_.push(S.numRectAreaLights),_.push(S.numSunLightShadows),_.push(S.numDirLightShadows),_.push(S.numPointLightShadows),_.push(S.numSpotLightShadows),_.push(S.numSpotLightShadowsWithMaps),_.push(S.numLightProbes),_.push(S.numLightProbeGrids),_.push(S.shadowMapType),_.push(S.toneMapping),_.push(S.numClippingPlanes),_.push(S.numClipIntersection),_.push(S.depthPacking)}function g(_,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let S=d[_.type],D;if(S){let L=er[S];D=Cx.clone(L.uniforms)}else D=_.uniforms;return D}function w(_,S){let D=u.get(S);return D!==void 0?++D.usedTimes:(D=new TR(n,S,_,s),c.push(D),u.set(S,D)),D}function b(_){if(--_.usedTimes===0){let S=c.indexOf(_);c[S]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:x,acquireProgram:w,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:T}}function PR(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function IR(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Zx(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function jx(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,y,m,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:m,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=m,x.group=g),t++,x}function l(d,f,p,y,m,g,x){x.reversedDepth===!0&&(m=-m);let w=a(d,f,p,y,m,g);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(d,f,p,y,m,g){let x=a(d,f,p,y,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||IR),i.length>1&&i.sort(f||Zx),s.length>1&&s.sort(f||Zx)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function LR(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new jx,n.set(i,[o])):s>=r.length?(o=new jx,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function DR(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new H,color:new ie};break;case"SpotLight":e={position:new H,direction:new H,color:new ie,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new ie,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new ie,groundColor:new ie};break;case"RectAreaLight":e={color:new ie,position:new H,halfWidth:new H,halfHeight:new H};break}return n[t.id]=e,e}}}function NR(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var UR=0;function FR(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function OR(n){let t=new DR,e=NR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new H);let s=new H,r=new _e,o=new _e;function a(c){let u=0,h=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,p=0,y=0,m=0,g=0,x=0,w=0,b=0,A=0,T=0,_=0,S=0,D=0,L=0;c.sort(FR);for(let z=0,W=c.length;z<W;z++){let B=c[z],X=B.color,I=B.intensity,U=B.distance,Z=null;if(B.shadow&&B.shadow.map&&(B.shadow.map.texture.format===no?Z=B.shadow.map.texture:Z=B.shadow.map.depthTexture||B.shadow.map.texture),B.isAmbientLight)u+=X.r*I,h+=X.g*I,d+=X.b*I;else if(B.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(B.sh.coefficients[q],I);L++}else if(B.isSunLight){let q=t.get(B);if(q.color.copy(B.color).multiplyScalar(B.intensity),B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=Z;let ht=j.getViewportCount();for(let ft=0;ft<ht;ft++)i.sunShadowMatrix[y+ft]=j.getMatrix(ft),i.sunShadowCascade[y+ft]=j._cascadeData[ft];y+=ht,p++}i.sun[f]=q,f++}else if(B.isDirectionalLight){let q=t.get(B);if(q.color.copy(B.color).multiplyScalar(B.intensity),B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=Z,i.directionalShadowMatrix[m]=B.shadow.matrix,A++}i.directional[m]=q,m++}else if(B.isSpotLight){let q=t.get(B);q.position.setFromMatrixPosition(B.matrixWorld),q.color.copy(X).multiplyScalar(I),q.distance=U,q.coneCos=Math.cos(B.angle),q.penumbraCos=Math.cos(B.angle*(1-B.penumbra)),q.decay=B.decay,i.spot[x]=q;let j=B.shadow;if(B.map&&(i.spotLightMap[S]=B.map,S++,j.updateMatrices(B),B.castShadow&&D++),i.spotLightMatrix[x]=j.matrix,B.castShadow){let et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=Z,_++}x++}else if(B.isRectAreaLight){let q=t.get(B);q.color.copy(X).multiplyScalar(I),q.halfWidth.set(B.width*.5,0,0),q.halfHeight.set(0,B.height*.5,0),i.rectArea[w]=q,w++}else if(B.isPointLight){let q=t.get(B);if(q.color.copy(B.color).multiplyScalar(B.intensity),q.distance=B.distance,q.decay=B.decay,B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=Z,i.pointShadowMatrix[g]=B.shadow.matrix,T++}i.point[g]=q,g++}else if(B.isHemisphereLight){let q=t.get(B);q.skyColor.copy(B.color).multiplyScalar(I),q.groundColor.copy(B.groundColor).multiplyScalar(I),i.hemi[b]=q,b++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ot.LTC_FLOAT_1,i.rectAreaLTC2=Ot.LTC_FLOAT_2):(i.rectAreaLTC1=Ot.LTC_HALF_1,i.rectAreaLTC2=Ot.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let N=i.hash;(N.sunLength!==f||N.directionalLength!==m||N.pointLength!==g||N.spotLength!==x||N.rectAreaLength!==w||N.hemiLength!==b||N.numSunShadows!==p||N.numDirectionalShadows!==A||N.numPointShadows!==T||N.numSpotShadows!==_||N.numSpotMaps!==S||N.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=w,i.point.length=g,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+S-D,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=L,N.sunLength=f,N.directionalLength=m,N.pointLength=g,N.spotLength=x,N.rectAreaLength=w,N.hemiLength=b,N.numSunShadows=p,N.numDirectionalShadows=A,N.numPointShadows=T,N.numSpotShadows=_,N.numSpotMaps=S,N.numLightProbes=L,i.version=UR++)}function l(c,u){let h=0,d=0,f=0,p=0,y=0,m=0,g=u.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){let b=c[x];if(b.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(b.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let A=i.rectArea[y];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Jx(n){let t=new OR(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function BR(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Jx(n),t.set(s,[a])):r>=o.length?(a=new Jx(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var kR=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zR=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,HR=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],GR=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],Kx=new _e,Ec=new H,bm=new H;function VR(n,t,e){let i=new wo,s=new Xt,r=new Xt,o=new xn,a=new fh,l=new ph,c={},u=e.maxTextureSize,h={[eo]:Ti,[Ti]:eo,[Ni]:Ni},d=new cs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xt},radius:{value:4}},vertexShader:kR,fragmentShader:zR}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ae;p.setAttribute("position",new Je(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new mn(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=_c;let g=this.type;this.render=function(T,_,S){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===X_&&(ee("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=_c);let D=n.getRenderTarget(),L=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Ao),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=g!==this.type;W&&_.traverse(function(B){B.material&&(Array.isArray(B.material)?B.material.forEach(X=>X.needsUpdate=!0):B.material.needsUpdate=!0)});for(let B=0,X=T.length;B<X;B++){let I=T[B],U=I.shadow;if(U===void 0){ee("WebGLShadowMap:",I,"has no shadow.");continue}if(U.autoUpdate===!1&&U.needsUpdate===!1)continue;s.copy(U.mapSize);let Z=U.getFrameExtents();s.multiply(Z),r.copy(U.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Z.x),s.x=r.x*Z.x,U.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Z.y),s.y=r.y*Z.y,U.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(U.camera._reversedDepth=q,U.map===null||W===!0){if(U.map!==null&&(U.map.depthTexture!==null&&(U.map.depthTexture.dispose(),U.map.depthTexture=null),U.map.dispose()),this.type===ka){if(I.isPointLight){ee("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}U.map=new Yi(s.x,s.y,{format:no,type:Es,minFilter:Si,magFilter:Si,generateMipmaps:!1}),U.map.texture.name=I.name+".shadowMap",U.map.depthTexture=new Sr(s.x,s.y,us),U.map.depthTexture.name=I.name+".shadowMapDepth",U.map.depthTexture.format=vr,U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Kn,U.map.depthTexture.magFilter=Kn}else I.isPointLight?(U.map=new Ac(s.x),U.map.depthTexture=new ac(s.x,ws)):(U.map=new Yi(s.x,s.y),U.map.depthTexture=new Sr(s.x,s.y,ws)),U.map.depthTexture.name=I.name+".shadowMap",U.map.depthTexture.format=vr,this.type===_c?(U.map.depthTexture.compareFunction=q?lm:am,U.map.depthTexture.minFilter=Si,U.map.depthTexture.magFilter=Si):(U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Kn,U.map.depthTexture.magFilter=Kn);U.camera.updateProjectionMatrix()}U.map.isWebGLCubeRenderTarget!==!0&&(U.map.width!==s.x||U.map.height!==s.y)&&U.map.setSize(s.x,s.y);let j=U.map.isWebGLCubeRenderTarget?6:U.getViewportCount();I.isPointLight!==!0&&U.updateMatrices(I,S);let et=(U.camera.layers.mask&4294967294)!==0?U.camera.layers:S.layers;for(let ht=0;ht<j;ht++){let ft=U.getCamera(ht);if(I.isPointLight){let it=U.camera,vt=U.matrix,xt=I.distance||it.far;xt!==it.far&&(it.far=xt,it.updateProjectionMatrix()),Ec.setFromMatrixPosition(I.matrixWorld),it.position.copy(Ec),bm.copy(it.position),bm.add(HR[ht]),it.up.copy(GR[ht]),it.lookAt(bm),it.updateMatrixWorld(),vt.makeTranslation(-Ec.x,-Ec.y,-Ec.z),Kx.multiplyMatrices(it.projectionMatrix,it.matrixWorldInverse),U._frustum.setFromProjectionMatrix(Kx,it.coordinateSystem,it.reversedDepth)}if(U.map.isWebGLCubeRenderTarget)n.setRenderTarget(U.map,ht),n.clear();else{ht===0&&(n.setRenderTarget(U.map),n.clear());let it=U.getViewport(ht);o.set(r.x*it.x,r.y*it.y,r.x*it.z,r.y*it.w),z.viewport(o)}i=U.getFrustum(ht),b(_,S,ft,I,et,this.type)}U.isPointLightShadow!==!0&&this.type===ka&&x(U,S),U.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(D,L,N)};function x(T,_){let S=t.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new Yi(s.x,s.y,{format:no,type:Es}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(_,null,S,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(_,null,S,f,y,null)}function w(T,_,S,D){let L=null,N=S.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(N!==void 0)L=N;else if(L=S.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let z=L.uuid,W=_.uuid,B=c[z];B===void 0&&(B={},c[z]=B);let X=B[W];X===void 0&&(X=L.clone(),B[W]=X,_.addEventListener("dispose",A)),L=X}if(L.visible=_.visible,L.wireframe=_.wireframe,D===ka?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:h[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let z=n.properties.get(L);z.light=S}return L}function b(T,_,S,D,L,N){if(T.visible===!1)return;if(T.layers.test(L)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&N===ka)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,T.matrixWorld);let B=t.update(T),X=T.material;if(Array.isArray(X)){let I=B.groups;for(let U=0,Z=I.length;U<Z;U++){let q=I[U],j=X[q.materialIndex];if(j&&j.visible){let et=w(T,j,D,N);T.onBeforeShadow(n,T,_,S,B,et,q),n.renderBufferDirect(S,null,B,et,T,q),T.onAfterShadow(n,T,_,S,B,et,q)}}}else if(X.visible){let I=w(T,X,D,N);T.onBeforeShadow(n,T,_,S,B,I,null),n.renderBufferDirect(S,null,B,I,T,null),T.onAfterShadow(n,T,_,S,B,I,null)}}let W=T.children;for(let B=0,X=W.length;B<X;B++)b(W[B],_,S,D,L,N)}function A(T){T.target.removeEventListener("dispose",A);for(let S in c){let D=c[S],L=T.target.uuid;L in D&&(D[L].dispose(),delete D[L])}}}function WR(n,t){function e(){let G=!1,lt=new xn,ot=null,Pt=new xn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!G&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){G=Mt},setClear:function(Mt,Rt,jt,oe,pt){pt===!0&&(Mt*=oe,Rt*=oe,jt*=oe),lt.set(Mt,Rt,jt,oe),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,jt,oe),Pt.copy(lt))},reset:function(){G=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let G=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let jt=t.get("EXT_clip_control");Rt?jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.ZERO_TO_ONE_EXT):jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let oe=Mt;Mt=null,this.setClear(oe)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!G&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=Tx[Rt]),Pt!==Rt){switch(Rt){case Zu:n.depthFunc(n.NEVER);break;case ju:n.depthFunc(n.ALWAYS);break;case Ju:n.depthFunc(n.LESS);break;case Aa:n.depthFunc(n.LEQUAL);break;case Ku:n.depthFunc(n.EQUAL);break;case Qu:n.depthFunc(n.GEQUAL);break;case th:n.depthFunc(n.GREATER);break;case eh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){G=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){G=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let G=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,jt=null,oe=null,pt=null;return{setTest:function(Wt){G||(Wt?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function(Wt){lt!==Wt&&!G&&(n.stencilMask(Wt),lt=Wt)},setFunc:function(Wt,ae,Dt){(ot!==Wt||Pt!==ae||Mt!==Dt)&&(n.stencilFunc(Wt,ae,Dt),ot=Wt,Pt=ae,Mt=Dt)},setOp:function(Wt,ae,Dt){(Rt!==Wt||jt!==ae||oe!==Dt)&&(n.stencilOp(Wt,ae,Dt),Rt=Wt,jt=ae,oe=Dt)},setLocked:function(Wt){G=Wt},setClear:function(Wt){pt!==Wt&&(n.clearStencil(Wt),pt=Wt)},reset:function(){G=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,jt=null,oe=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],y=null,m=!1,g=null,x=null,w=null,b=null,A=null,T=null,_=null,S=new ie(0,0,0),D=0,L=!1,N=null,z=null,W=null,B=null,X=null,I=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),U=!1,Z=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(q)[1]),U=Z>=1):q.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),U=Z>=2);let j=null,et={},ht=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),it=new xn().fromArray(ht),vt=new xn().fromArray(ft);function xt(G,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(G,Rt),n.texParameteri(G,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(G,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let jt=0;jt<ot;jt++)G===n.TEXTURE_3D||G===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+jt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(Aa),Cn(!1),Xe(Op),At(n.CULL_FACE),hn(Ao);function At(G){u[G]!==!0&&(n.enable(G),u[G]=!0)}function Jt(G){u[G]!==!1&&(n.disable(G),u[G]=!1)}function pe(G,lt){return d[G]!==lt?(n.bindFramebuffer(G,lt),d[G]=lt,G===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),G===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function Zt(G,lt){let ot=p,Pt=!1;if(G){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=G.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,jt=Mt.length;Rt<jt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function be(G){return y!==G?(n.useProgram(G),y=G,!0):!1}let xe={[Ro]:n.FUNC_ADD,[Z_]:n.FUNC_SUBTRACT,[j_]:n.FUNC_REVERSE_SUBTRACT};xe[J_]=n.MIN,xe[K_]=n.MAX;let de={[Q_]:n.ZERO,[tx]:n.ONE,[ex]:n.SRC_COLOR,[Hp]:n.SRC_ALPHA,[ax]:n.SRC_ALPHA_SATURATE,[rx]:n.DST_COLOR,[ix]:n.DST_ALPHA,[nx]:n.ONE_MINUS_SRC_COLOR,[Gp]:n.ONE_MINUS_SRC_ALPHA,[ox]:n.ONE_MINUS_DST_COLOR,[sx]:n.ONE_MINUS_DST_ALPHA,[lx]:n.CONSTANT_COLOR,[cx]:n.ONE_MINUS_CONSTANT_COLOR,[ux]:n.CONSTANT_ALPHA,[hx]:n.ONE_MINUS_CONSTANT_ALPHA};function hn(G,lt,ot,Pt,Mt,Rt,jt,oe,pt,Wt){if(G===Ao){m===!0&&(Jt(n.BLEND),m=!1);return}if(m===!1&&(At(n.BLEND),m=!0),G!==Y_){if(G!==g||Wt!==L){if((x!==Ro||A!==Ro)&&(n.blendEquation(n.FUNC_ADD),x=Ro,A=Ro),Wt)switch(G){case za:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Bp:n.blendFunc(n.ONE,n.ONE);break;case kp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case zp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:re("WebGLState: Invalid blending: ",G);break}else switch(G){case za:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Bp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case kp:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case zp:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",G);break}w=null,b=null,T=null,_=null,S.set(0,0,0),D=0,g=G,L=Wt}return}Mt=Mt||lt,Rt=Rt||ot,jt=jt||Pt,(lt!==x||Mt!==A)&&(n.blendEquationSeparate(xe[lt],xe[Mt]),x=lt,A=Mt),(ot!==w||Pt!==b||Rt!==T||jt!==_)&&(n.blendFuncSeparate(de[ot],de[Pt],de[Rt],de[jt]),w=ot,b=Pt,T=Rt,_=jt),(oe.equals(S)===!1||pt!==D)&&(n.blendColor(oe.r,oe.g,oe.b,pt),S.copy(oe),D=pt),g=G,L=!1}function en(G,lt){G.side===Ni?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=G.side===Ti;lt&&(ot=!ot),Cn(ot),G.blending===za&&G.transparent===!1?hn(Ao):hn(G.blending,G.blendEquation,G.blendSrc,G.blendDst,G.blendEquationAlpha,G.blendSrcAlpha,G.blendDstAlpha,G.blendColor,G.blendAlpha,G.premultipliedAlpha),o.setFunc(G.depthFunc),o.setTest(G.depthTest),o.setMask(G.depthWrite),r.setMask(G.colorWrite);let Pt=G.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(G.stencilWriteMask),a.setFunc(G.stencilFunc,G.stencilRef,G.stencilFuncMask),a.setOp(G.stencilFail,G.stencilZFail,G.stencilZPass)),Le(G.polygonOffset,G.polygonOffsetFactor,G.polygonOffsetUnits),G.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Cn(G){N!==G&&(G?n.frontFace(n.CW):n.frontFace(n.CCW),N=G)}function Xe(G){G!==q_?(At(n.CULL_FACE),G!==z&&(G===Op?n.cullFace(n.BACK):G===$_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),z=G}function $n(G){G!==W&&(U&&n.lineWidth(G),W=G)}function Le(G,lt,ot){G?(At(n.POLYGON_OFFSET_FILL),(B!==lt||X!==ot)&&(B=lt,X=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Jt(n.POLYGON_OFFSET_FILL)}function Bn(G){G?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function vn(G){G===void 0&&(G=n.TEXTURE0+I-1),j!==G&&(n.activeTexture(G),j=G)}function Pn(G,lt,ot){ot===void 0&&(j===null?ot=n.TEXTURE0+I-1:ot=j);let Pt=et[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},et[ot]=Pt),(Pt.type!==G||Pt.texture!==lt)&&(j!==ot&&(n.activeTexture(ot),j=ot),n.bindTexture(G,lt||Tt[G]),Pt.type=G,Pt.texture=lt)}function V(){let G=et[j];G!==void 0&&G.type!==void 0&&(n.bindTexture(G.type,null),G.type=void 0,G.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function ne(){try{n.compressedTexImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function me(){try{n.texSubImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function je(){try{n.compressedTexSubImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function Qt(){try{n.texStorage2D(...arguments)}catch(G){re("WebGLState:",G)}}function F(){try{n.texStorage3D(...arguments)}catch(G){re("WebGLState:",G)}}function R(){try{n.texImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function J(){try{n.texImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function mt(G){return h[G]!==void 0?h[G]:n.getParameter(G)}function ct(G,lt){h[G]!==lt&&(n.pixelStorei(G,lt),h[G]=lt)}function St(G){it.equals(G)===!1&&(n.scissor(G.x,G.y,G.z,G.w),it.copy(G))}function wt(G){vt.equals(G)===!1&&(n.viewport(G.x,G.y,G.z,G.w),vt.copy(G))}function rt(G,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Pt=ot.get(G);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,G.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(G,Pt))}function at(G,lt,ot){let Mt=c.get(lt).get(G);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function bt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,et={},d={},l={},f=new WeakMap,p=[],y=null,m=!1,g=null,x=null,w=null,b=null,A=null,T=null,_=null,S=new ie(0,0,0),D=0,L=!1,N=null,z=null,W=null,B=null,X=null,it.set(0,0,n.canvas.width,n.canvas.height),vt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:pe,drawBuffers:Zt,useProgram:be,setBlending:hn,setMaterial:en,setFlipSided:Cn,setCullFace:Xe,setLineWidth:$n,setPolygonOffset:Le,setScissorTest:Bn,activeTexture:vn,bindTexture:Pn,unbindTexture:V,compressedTexImage2D:Nt,compressedTexImage3D:ne,texImage2D:R,texImage3D:J,pixelStorei:ct,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:Qt,texStorage3D:F,texSubImage2D:me,texSubImage3D:Ct,compressedTexSubImage2D:je,compressedTexSubImage3D:Yt,scissor:St,viewport:wt,reset:bt}}function qR(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,y=new FinalizationRegistry(F=>p.delete(F)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(F,R){return m?new OffscreenCanvas(F,R):Yl("canvas")}function x(F,R,J){let mt=1,ct=Qt(F);if((ct.width>J||ct.height>J)&&(mt=J/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&F instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&F instanceof ImageBitmap||typeof VideoFrame<"u"&&F instanceof VideoFrame){let St=Math.floor(mt*ct.width),wt=Math.floor(mt*ct.height);d===void 0&&(d=g(St,wt));let rt=R?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(F,0,0,St,wt),ee("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+St+"x"+wt+")."),rt}else return"data"in F&&ee("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),F;return F}function w(F){return F.generateMipmaps}function b(F){n.generateMipmap(F)}function A(F){return F.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:F.isWebGL3DRenderTarget?n.TEXTURE_3D:F.isWebGLArrayRenderTarget||F.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(F,R,J,mt,ct,St=!1){if(F!==null){if(n[F]!==void 0)return n[F];ee("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+F+"'")}let wt;mt&&(wt=t.get("EXT_texture_norm16"),wt||ee("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(J===n.FLOAT&&(rt=n.R32F),J===n.HALF_FLOAT&&(rt=n.R16F),J===n.UNSIGNED_BYTE&&(rt=n.R8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),J===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.R8UI),J===n.UNSIGNED_SHORT&&(rt=n.R16UI),J===n.UNSIGNED_INT&&(rt=n.R32UI),J===n.BYTE&&(rt=n.R8I),J===n.SHORT&&(rt=n.R16I),J===n.INT&&(rt=n.R32I)),R===n.RG&&(J===n.FLOAT&&(rt=n.RG32F),J===n.HALF_FLOAT&&(rt=n.RG16F),J===n.UNSIGNED_BYTE&&(rt=n.RG8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),J===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RG8UI),J===n.UNSIGNED_SHORT&&(rt=n.RG16UI),J===n.UNSIGNED_INT&&(rt=n.RG32UI),J===n.BYTE&&(rt=n.RG8I),J===n.SHORT&&(rt=n.RG16I),J===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),J===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),J===n.UNSIGNED_INT&&(rt=n.RGB32UI),J===n.BYTE&&(rt=n.RGB8I),J===n.SHORT&&(rt=n.RGB16I),J===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),J===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),J===n.UNSIGNED_INT&&(rt=n.RGBA32UI),J===n.BYTE&&(rt=n.RGBA8I),J===n.SHORT&&(rt=n.RGBA16I),J===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),J===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),J===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),J===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=St?$l:Ce.getTransfer(ct);J===n.FLOAT&&(rt=n.RGBA32F),J===n.HALF_FLOAT&&(rt=n.RGBA16F),J===n.UNSIGNED_BYTE&&(rt=at===He?n.SRGB8_ALPHA8:n.RGBA8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),J===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),J===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),J===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function _(F,R){let J;return F?R===null||R===ws||R===Po?J=n.DEPTH24_STENCIL8:R===us?J=n.DEPTH32F_STENCIL8:R===Ga&&(J=n.DEPTH24_STENCIL8,ee("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===ws||R===Po?J=n.DEPTH_COMPONENT24:R===us?J=n.DEPTH_COMPONENT32F:R===Ga&&(J=n.DEPTH_COMPONENT16),J}function S(F,R){return w(F)===!0||F.isFramebufferTexture&&F.minFilter!==Kn&&F.minFilter!==Si?Math.log2(Math.max(R.width,R.height))+1:F.mipmaps.length>0?F.mipmaps.length:F.isCompressedTexture&&Array.isArray(F.image)?R.mipmaps.length:1}function D(F){let R=new WeakRef(F);i.get(F).__ref=R,p.add(R),y.register(F,R,R)}function L(F){let R=i.get(F).__ref;R!==void 0&&(p.delete(R),y.unregister(R))}function N(F){W(F.target)}function z(F){B(F.target)}function W(F){F.removeEventListener("dispose",N),L(F),I(F),F.isVideoTexture&&u.delete(F),F.isHTMLTexture&&h.delete(F)}function B(F){F.removeEventListener("dispose",z),L(F),Z(F)}function X(){for(let F of p){let R=F.deref();R!==void 0&&(R.isRenderTarget===!0?B(R):W(R))}p.clear(),h.clear()}function I(F){let R=i.get(F);if(R.__webglInit===void 0)return;let J=F.source,mt=f.get(J);if(mt){let ct=mt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&U(F),Object.keys(mt).length===0&&f.delete(J)}i.remove(F)}function U(F){let R=i.get(F);n.deleteTexture(R.__webglTexture);let J=F.source,mt=f.get(J);delete mt[R.__cacheKey],o.memory.textures--}function Z(F){let R=i.get(F);R.__depthDisposeCallback&&R.__depthDisposeCallback();let J=F.depthTexture;if(J&&J.renderTarget===F&&W(J),F.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let St=0;St<R.__webglFramebuffer[ct].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[ct][St]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=F.textures;for(let ct=0,St=mt.length;ct<St;ct++){let wt=i.get(mt[ct]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(mt[ct])}i.remove(F)}let q=0;function j(){q=0}function et(){return q}function ht(F){q=F}function ft(){let F=q;return F>=s.maxTextures&&ee("WebGLTextures: Trying to use "+(F+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,F}function it(F){let R=[];return R.push(F.wrapS),R.push(F.wrapT),R.push(F.wrapR||0),R.push(F.magFilter),R.push(F.minFilter),R.push(F.anisotropy),R.push(F.internalFormat),R.push(F.format),R.push(F.type),R.push(F.generateMipmaps),R.push(F.mipmapsAutoUpdate),R.push(F.premultiplyAlpha),R.push(F.flipY),R.push(F.unpackAlignment),R.push(F.colorSpace),R.join()}function vt(F,R){let J=i.get(F);if(F.isVideoTexture&&je(F),F.isRenderTargetTexture===!1&&F.isExternalTexture!==!0&&F.version>0&&J.__version!==F.version){let mt=F.image;if(mt===null)ee("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ee("WebGLRenderer: Texture marked for update but image is incomplete");else{en(J,F,R);return}}else F.isExternalTexture&&(J.__webglTexture=F.sourceTexture?F.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,J.__webglTexture,n.TEXTURE0+R)}function xt(F,R){let J=i.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&J.__version!==F.version){en(J,F,R);return}else F.isExternalTexture&&(J.__webglTexture=F.sourceTexture?F.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,J.__webglTexture,n.TEXTURE0+R)}function Tt(F,R){let J=i.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&J.__version!==F.version){en(J,F,R);return}e.bindTexture(n.TEXTURE_3D,J.__webglTexture,n.TEXTURE0+R)}function At(F,R){let J=i.get(F);if(F.version>0&&J.__version!==F.version){Cn(J,F,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture,n.TEXTURE0+R)}let Jt={[nh]:n.REPEAT,[Ys]:n.CLAMP_TO_EDGE,[ih]:n.MIRRORED_REPEAT},pe={[Kn]:n.NEAREST,[px]:n.NEAREST_MIPMAP_NEAREST,[xc]:n.NEAREST_MIPMAP_LINEAR,[Si]:n.LINEAR,[Ch]:n.LINEAR_MIPMAP_NEAREST,[Er]:n.LINEAR_MIPMAP_LINEAR},Zt={[xx]:n.NEVER,[cm]:n.ALWAYS,[yx]:n.LESS,[am]:n.LEQUAL,[vx]:n.EQUAL,[lm]:n.GEQUAL,[bx]:n.GREATER,[Mx]:n.NOTEQUAL};function be(F,R){if(R.type===us&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Si||R.magFilter===Ch||R.magFilter===xc||R.magFilter===Er||R.minFilter===Si||R.minFilter===Ch||R.minFilter===xc||R.minFilter===Er)&&ee("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(F,n.TEXTURE_WRAP_S,Jt[R.wrapS]),n.texParameteri(F,n.TEXTURE_WRAP_T,Jt[R.wrapT]),(F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY)&&n.texParameteri(F,n.TEXTURE_WRAP_R,Jt[R.wrapR]),n.texParameteri(F,n.TEXTURE_MAG_FILTER,pe[R.magFilter]),n.texParameteri(F,n.TEXTURE_MIN_FILTER,pe[R.minFilter]),R.compareFunction&&(n.texParameteri(F,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(F,n.TEXTURE_COMPARE_FUNC,Zt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Kn||R.minFilter!==xc&&R.minFilter!==Er||R.type===us&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let J=t.get("EXT_texture_filter_anisotropic");n.texParameterf(F,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function xe(F,R){let J=!1;F.__webglInit===void 0&&(F.__webglInit=!0,R.addEventListener("dispose",N),D(R));let mt=R.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let St=it(R);if(St!==F.__cacheKey){ct[St]===void 0&&(ct[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,J=!0),ct[St].usedTimes++;let wt=ct[F.__cacheKey];wt!==void 0&&(ct[F.__cacheKey].usedTimes--,wt.usedTimes===0&&U(R)),F.__cacheKey=St,F.__webglTexture=ct[St].texture}return J}function de(F,R,J){return Math.floor(Math.floor(F/J)/R)}function hn(F,R,J,mt){let St=F.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,J,mt,R.data);else{St.sort((G,lt)=>G.start-lt.start);let wt=0;for(let G=1;G<St.length;G++){let lt=St[wt],ot=St[G],Pt=lt.start+lt.count,Mt=de(ot.start,R.width,4),Rt=de(lt.start,R.width,4);ot.start<=Pt+1&&Mt===Rt&&de(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),bt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let G=0,lt=St.length;G<lt;G++){let ot=St[G],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%R.width,jt=Math.floor(Pt/R.width),oe=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,jt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,jt,oe,pt,J,mt,R.data)}F.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,bt)}}function en(F,R,J){let mt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=n.TEXTURE_3D);let ct=xe(F,R),St=R.source;e.bindTexture(mt,F.__webglTexture,n.TEXTURE0+J);let wt=i.get(St);if(St.version!==wt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+J),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=Ce.getPrimaries(Ce.workingColorSpace),Wt=R.colorSpace===Ar?null:Ce.getPrimaries(R.colorSpace),ae=R.colorSpace===Ar||pt===Wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=x(R.image,!1,s.maxTextureSize);at=Yt(R,at);let bt=r.convert(R.format,R.colorSpace),G=r.convert(R.type),lt=T(R.internalFormat,bt,G,R.normalized,R.colorSpace,R.isVideoTexture);be(mt,R);let ot,Pt=R.mipmaps,Mt=R.isVideoTexture!==!0,Rt=wt.__version===void 0||ct===!0,jt=St.dataReady,oe=S(R,at);if(R.isDepthTexture)lt=_(R.format===Tr,R.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,bt,G,null));else if(R.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,G,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,bt,G,ot.data);R.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height),jt&&hn(R,at,bt,G)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,bt,G,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)if(ot=Pt[pt],R.format!==Ts)if(bt!==null)if(Mt){if(jt)if(R.layerUpdates.size>0){let ae=ym(ot.width,ot.height,R.format,R.type);for(let Dt of R.layerUpdates){let ge=ot.data.subarray(Dt*ae/ot.data.BYTES_PER_ELEMENT,(Dt+1)*ae/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,bt,ge)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,bt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ee("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?jt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,bt,G,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,bt,G,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],R.format!==Ts?bt!==null?Mt?jt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ee("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,G,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,bt,G,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,at.width,at.height,at.depth),jt)if(R.layerUpdates.size>0){let pt=ym(at.width,at.height,R.format,R.type);for(let Wt of R.layerUpdates){let ae=at.data.subarray(Wt*pt/at.data.BYTES_PER_ELEMENT,(Wt+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Wt,at.width,at.height,1,bt,G,ae)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,bt,G,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,bt,G,at.data);else if(R.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,oe,lt,at.width,at.height,at.depth),jt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,bt,G,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,bt,G,at.data);else if(R.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height);else{let pt=at.width,Wt=at.height;for(let ae=0;ae<oe;ae++)e.texImage2D(n.TEXTURE_2D,ae,lt,pt,Wt,0,bt,G,null),pt>>=1,Wt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=Wt=>{let ae=Wt.changedElements;for(let Dt of h)ae.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ae=n.RGBA,Dt=n.RGBA,ge=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ae,Dt,ge,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=Qt(Pt[0]);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,bt,G,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,bt,G,ot);R.generateMipmaps=!1}else if(Mt){if(Rt){let pt=Qt(at);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}jt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,bt,G,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,bt,G,at);w(R)&&R.mipmapsAutoUpdate===!0&&b(mt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}F.__version=R.version}function Cn(F,R,J){if(R.image.length!==6)return;let mt=xe(F,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,F.__webglTexture,n.TEXTURE0+J);let St=i.get(ct);if(ct.version!==St.__version||mt===!0){e.activeTexture(n.TEXTURE0+J);let wt=Ce.getPrimaries(Ce.workingColorSpace),rt=R.colorSpace===Ar?null:Ce.getPrimaries(R.colorSpace),at=R.colorSpace===Ar||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let bt=R.isCompressedTexture||R.image[0].isCompressedTexture,G=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!bt&&!G?lt[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):lt[Dt]=G?R.image[Dt].image:R.image[Dt],lt[Dt]=Yt(R,lt[Dt]);let ot=lt[0],Pt=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Rt=T(R.internalFormat,Pt,Mt,R.normalized,R.colorSpace),jt=R.isVideoTexture!==!0,oe=St.__version===void 0||mt===!0,pt=ct.dataReady,Wt=S(R,ot);be(n.TEXTURE_CUBE_MAP,R);let ae;if(R.isDepthTexture){if(Rt=_(R.format===Tr,R.type),oe)if(jt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(bt){jt&&oe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){ae=lt[Dt].mipmaps;for(let ge=0;ge<ae.length;ge++){let sn=ae[ge];R.format!==Ts?Pt!==null?jt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge,0,0,sn.width,sn.height,Pt,sn.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge,Rt,sn.width,sn.height,0,sn.data):ee("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge,0,0,sn.width,sn.height,Pt,Mt,sn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge,Rt,sn.width,sn.height,0,Pt,Mt,sn.data)}}}else{if(ae=R.mipmaps,jt&&oe){ae.length>0&&Wt++;let Dt=Qt(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(G){jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let ge=0;ge<ae.length;ge++){let fi=ae[ge].image[Dt].image;jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge+1,0,0,fi.width,fi.height,Pt,Mt,fi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge+1,Rt,fi.width,fi.height,0,Pt,Mt,fi.data)}}else{jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let ge=0;ge<ae.length;ge++){let sn=ae[ge];jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge+1,0,0,Pt,Mt,sn.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ge+1,Rt,Pt,Mt,sn.image[Dt])}}}w(R)&&R.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),St.__version=ct.version,R.onUpdate&&R.onUpdate(R)}F.__version=R.version}function Xe(F,R,J,mt,ct,St){let wt=r.convert(J.format,J.colorSpace),rt=r.convert(J.type),at=T(J.internalFormat,wt,rt,J.normalized,J.colorSpace),bt=i.get(R),G=i.get(J);if(G.__renderTarget=R,!bt.__hasExternalTextures){let lt=Math.max(1,R.width>>St),ot=Math.max(1,R.height>>St);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,St,at,lt,ot,R.depth,0,wt,rt,null):e.texImage2D(ct,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,F),Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ct,G.__webglTexture,0,me(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ct,G.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function $n(F,R,J){if(n.bindRenderbuffer(n.RENDERBUFFER,F),R.depthBuffer){let mt=R.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,St=_(R.stencilBuffer,ct),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),St,R.width,R.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,F)}else{let mt=R.textures;for(let ct=0;ct<mt.length;ct++){let St=mt[ct],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=T(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),at,R.width,R.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Le(F,R,J){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,F),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let St=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),mt?At(R.depthTexture,0):vt(R.depthTexture,0);let wt=ct.__webglTexture,rt=me(R),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+J:n.TEXTURE_2D,bt=R.depthTexture.format===Tr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===vr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,bt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,bt,at,wt,0);else if(R.depthTexture.format===Tr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,bt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,bt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bn(F){let R=i.get(F),J=F.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==F.depthTexture){let mt=F.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=mt}if(F.depthTexture&&!R.__autoAllocateDepthBuffer)if(J)for(let mt=0;mt<6;mt++)Le(R.__webglFramebuffer[mt],F,mt);else F.texture.mipmaps.length>0?Le(R.__webglFramebuffer[0],F,0):Le(R.__webglFramebuffer,F,0);else if(J){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=n.createRenderbuffer(),$n(R.__webglDepthbuffer[mt],F,!1);else{let ct=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}}else if(F.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),$n(R.__webglDepthbuffer,F,!1);else{let ct=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function vn(F,R,J){let mt=i.get(F);R!==void 0&&Xe(mt.__webglFramebuffer,F,F.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),J!==void 0&&Bn(F)}function Pn(F){let R=F.texture,J=i.get(F),mt=i.get(R);F.addEventListener("dispose",z),D(F);let ct=F.textures,St=F.isWebGLCubeRenderTarget===!0,wt=ct.length>1;if(wt||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=R.version,o.memory.textures++),St){J.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){J.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)J.__webglFramebuffer[rt][at]=n.createFramebuffer()}else J.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){J.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)J.__webglFramebuffer[rt]=n.createFramebuffer()}else J.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ct.length;rt<at;rt++){let bt=i.get(ct[rt]);bt.__webglTexture===void 0&&(bt.__webglTexture=n.createTexture(),o.memory.textures++)}if(F.samples>0&&Ct(F)===!1){J.__webglMultisampledFramebuffer=n.createFramebuffer(),J.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];J.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,J.__webglColorRenderbuffer[rt]);let bt=r.convert(at.format,at.colorSpace),G=r.convert(at.type),lt=T(at.internalFormat,bt,G,at.normalized,at.colorSpace,F.isXRRenderTarget===!0),ot=me(F);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,F.width,F.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,J.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),F.depthBuffer&&(J.__webglDepthRenderbuffer=n.createRenderbuffer(),$n(J.__webglDepthRenderbuffer,F,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),be(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Xe(J.__webglFramebuffer[rt][at],F,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Xe(J.__webglFramebuffer[rt],F,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);w(R)?b(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ct.length;rt<at;rt++){let bt=ct[rt],G=i.get(bt),lt=n.TEXTURE_2D;(F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(lt=F.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,G.__webglTexture),be(lt,bt),Xe(J.__webglFramebuffer,F,bt,n.COLOR_ATTACHMENT0+rt,lt,0),w(bt)&&b(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(rt=F.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),be(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Xe(J.__webglFramebuffer[at],F,R,n.COLOR_ATTACHMENT0,rt,at);else Xe(J.__webglFramebuffer,F,R,n.COLOR_ATTACHMENT0,rt,0);w(R)?b(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}F.depthBuffer&&Bn(F)}function V(F){let R=F.textures;for(let J=0,mt=R.length;J<mt;J++){let ct=R[J];if(w(ct)&&ct.mipmapsAutoUpdate===!0){let St=A(F),wt=i.get(ct).__webglTexture;e.bindTexture(St,wt),b(St),e.unbindTexture()}}}let Nt=[];function ne(F){if(F.samples>0){if(Ct(F)===!1){let R=F.textures,J=F.width,mt=F.height,ct=n.COLOR_BUFFER_BIT,St=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(F),rt=R.length>1;if(rt)for(let bt=0;bt<R.length;bt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),F.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let bt=0;bt<R.length;bt++){if(F.resolveDepthBuffer&&(F.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),F.stencilBuffer&&F.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let G=i.get(R[bt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,G,0)}n.blitFramebuffer(0,0,J,mt,0,0,J,mt,ct,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+bt),F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let bt=0;bt<R.length;bt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let G=i.get(R[bt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,G,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&l){let R=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function me(F){return Math.min(s.maxSamples,F.samples)}function Ct(F){let R=i.get(F);return F.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function je(F){let R=o.render.frame;u.get(F)!==R&&(u.set(F,R),F.update())}function Yt(F,R){let J=F.colorSpace,mt=F.format,ct=F.type;return F.isCompressedTexture===!0||F.isVideoTexture===!0||J!==ql&&J!==Ar&&(Ce.getTransfer(J)===He?(mt!==Ts||ct!==Ki)&&ee("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",J)),R}function Qt(F){return typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement?(c.width=F.naturalWidth||F.width,c.height=F.naturalHeight||F.height):typeof VideoFrame<"u"&&F instanceof VideoFrame?(c.width=F.displayWidth,c.height=F.displayHeight):(c.width=F.width,c.height=F.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=ht,this.setTexture2D=vt,this.setTexture2DArray=xt,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=vn,this.setupRenderTarget=Pn,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=Bn,this.setupFrameBufferTexture=Xe,this.useMultisampledRTT=Ct,this.dispose=X}function $R(n,t){function e(i,s=Ar){let r,o=Ce.getTransfer(s);if(i===Ki)return n.UNSIGNED_BYTE;if(i===Ih)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Lh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===tm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===em)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Kp)return n.BYTE;if(i===Qp)return n.SHORT;if(i===Ga)return n.UNSIGNED_SHORT;if(i===Ph)return n.INT;if(i===ws)return n.UNSIGNED_INT;if(i===us)return n.FLOAT;if(i===Es)return n.HALF_FLOAT;if(i===nm)return n.ALPHA;if(i===im)return n.RGB;if(i===Ts)return n.RGBA;if(i===vr)return n.DEPTH_COMPONENT;if(i===Tr)return n.DEPTH_STENCIL;if(i===Dh)return n.RED;if(i===Nh)return n.RED_INTEGER;if(i===no)return n.RG;if(i===Uh)return n.RG_INTEGER;if(i===Fh)return n.RGBA_INTEGER;if(i===yc||i===vc||i===bc||i===Mc)if(o===He)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===yc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===vc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===bc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Mc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===yc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===vc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===bc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Mc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Oh||i===Bh||i===kh||i===zh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Oh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Bh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===kh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===zh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Hh||i===Gh||i===Vh||i===Wh||i===qh||i===Sc||i===$h)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Hh||i===Gh)return o===He?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Vh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Wh)return r.COMPRESSED_R11_EAC;if(i===qh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Sc)return r.COMPRESSED_RG11_EAC;if(i===$h)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Xh||i===Yh||i===Zh||i===jh||i===Jh||i===Kh||i===Qh||i===td||i===ed||i===nd||i===id||i===sd||i===rd||i===od)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Xh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Yh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Zh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===jh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Jh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Kh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Qh)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===td)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===ed)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===nd)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===id)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===sd)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===rd)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===od)return o===He?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ad||i===ld||i===cd)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===ad)return o===He?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ld)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===cd)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ud||i===hd||i===wc||i===dd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===ud)return r.COMPRESSED_RED_RGTC1_EXT;if(i===hd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===wc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===dd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Po?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var XR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YR=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Rm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new lc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new cs({vertexShader:XR,fragmentShader:YR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new mn(new dc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cm=class extends Ss{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,y=typeof XRWebGLBinding<"u",m=new Rm,g={},x=e.getContextAttributes(),w=null,b=null,A=[],T=[],_=new Xt,S=null,D=null,L=new Mi;L.viewport=new xn;let N=new Mi;N.viewport=new xn;let z=[L,N],W=new Th,B=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let vt=A[it];return vt===void 0&&(vt=new La,A[it]=vt),vt.getTargetRaySpace()},this.getControllerGrip=function(it){let vt=A[it];return vt===void 0&&(vt=new La,A[it]=vt),vt.getGripSpace()},this.getHand=function(it){let vt=A[it];return vt===void 0&&(vt=new La,A[it]=vt),vt.getHandSpace()};function I(it){let vt=T.indexOf(it.inputSource);if(vt===-1)return;let xt=A[vt];xt!==void 0&&(xt.update(it.inputSource,it.frame,c||o),xt.dispatchEvent({type:it.type,data:it.inputSource}))}function U(){s.removeEventListener("select",I),s.removeEventListener("selectstart",I),s.removeEventListener("selectend",I),s.removeEventListener("squeeze",I),s.removeEventListener("squeezestart",I),s.removeEventListener("squeezeend",I),s.removeEventListener("end",U),s.removeEventListener("inputsourceschange",Z);for(let it=0;it<A.length;it++){let vt=T[it];vt!==null&&(T[it]=null,A[it].disconnect(vt))}B=null,X=null,m.reset();for(let it in g)delete g[it];if(t.setRenderTarget(w),f=null,d=null,h=null,s=null,b=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(_.width,_.height,!1),D!==null){let it=D.camera;it.fov=D.fov,it.zoom=D.zoom,it.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,i.isPresenting===!0&&ee("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,i.isPresenting===!0&&ee("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",I),s.addEventListener("selectstart",I),s.addEventListener("selectend",I),s.addEventListener("squeeze",I),s.addEventListener("squeezestart",I),s.addEventListener("squeezeend",I),s.addEventListener("end",U),s.addEventListener("inputsourceschange",Z),x.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=x.stencil?Tr:vr,Tt=x.stencil?Po:ws);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new Yi(d.textureWidth,d.textureHeight,{format:Ts,type:Ki,depthTexture:new Sr(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Yi(f.framebufferWidth,f.framebufferHeight,{format:Ts,type:Ki,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Z(it){for(let vt=0;vt<it.removed.length;vt++){let xt=it.removed[vt],Tt=T.indexOf(xt);Tt>=0&&(T[Tt]=null,A[Tt].disconnect(xt))}for(let vt=0;vt<it.added.length;vt++){let xt=it.added[vt],Tt=T.indexOf(xt);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=T.length){T.push(xt),Tt=Jt;break}else if(T[Jt]===null){T[Jt]=xt,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(xt)}}function q(it,vt){vt===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(vt.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let vt=it.near,xt=it.far;m.texture!==null&&(m.depthNear>0&&(vt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),W.near=N.near=L.near=vt,W.far=N.far=L.far=xt,(B!==W.near||X!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),B=W.near,X=W.far),W.layers.mask=it.layers.mask|6,L.layers.mask=W.layers.mask&-5,N.layers.mask=W.layers.mask&-3;let Tt=it.parent,At=W.cameras;q(W,Tt);for(let Jt=0;Jt<At.length;Jt++)q(At[Jt],Tt);W.projectionMatrix.copy(L.projectionMatrix),W.projectionMatrixInverse.copy(L.projectionMatrixInverse),D===null&&it.isPerspectiveCamera&&(D={camera:it,fov:it.fov,zoom:it.zoom}),j(it,W,Tt)};function j(it,vt,xt){xt===null?it.matrix.copy(vt.matrixWorld):(it.matrix.copy(xt.matrixWorld),it.matrix.invert(),it.matrix.multiply(vt.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(vt.projectionMatrix),it.projectionMatrixInverse.copy(vt.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=Ca*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(it){l=it,d!==null&&(d.fixedFoveation=it),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=it)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(it){return g[it]};let et=null;function ht(it,vt){if(u=vt.getViewerPose(c||o),p=vt,u!==null){let xt=u.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Tt=!1;xt.length!==W.cameras.length&&(W.cameras.length=0,Tt=!0);for(let Zt=0;Zt<xt.length;Zt++){let be=xt[Zt],xe=null;if(f!==null)xe=f.getViewport(be);else{let hn=h.getViewSubImage(d,be);xe=hn.viewport,Zt===0&&(t.setRenderTargetTextures(b,hn.colorTexture,hn.depthStencilTexture),t.setRenderTarget(b))}let de=z[Zt];de===void 0&&(de=new Mi,de.layers.enable(Zt),de.viewport=new xn,z[Zt]=de),de.matrix.fromArray(be.transform.matrix),de.matrix.decompose(de.position,de.quaternion,de.scale),de.projectionMatrix.fromArray(be.projectionMatrix),de.projectionMatrixInverse.copy(de.projectionMatrix).invert(),de.viewport.set(xe.x,xe.y,xe.width,xe.height),Zt===0&&(W.matrix.copy(de.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Tt===!0&&W.cameras.push(de)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Zt=h.getDepthInformation(xt[0]);Zt&&Zt.isValid&&Zt.texture&&m.init(Zt,s.renderState)}if(At&&At.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let Zt=0;Zt<xt.length;Zt++){let be=xt[Zt].camera;if(be){let xe=g[be];xe||(xe=new lc,g[be]=xe);let de=h.getCameraImage(be);xe.sourceTexture=de}}}}for(let xt=0;xt<A.length;xt++){let Tt=T[xt],At=A[xt];Tt!==null&&At!==void 0&&At.update(Tt,vt,c||o)}et&&et(it,vt),vt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:vt}),p=null}let ft=new Qx;ft.setAnimationLoop(ht),this.setAnimationLoop=function(it){et=it},this.dispose=function(){}}},ZR=new _e,cy=new ce;cy.set(-1,0,0,0,1,0,0,0,1);function jR(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,gm(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,w,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),y(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Ti&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Ti&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=t.get(g),w=x.envMap,b=x.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(ZR.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(cy),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=w*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Ti&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function y(m,g){let x=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function JR(n,t,e,i){let s={},r={};function o(x,w){let b=w.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,w){let b=s[x.id];b===void 0&&(p(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",m));let A=w.program;i.updateUBOMapping(x,A);let T=t.render.frame;r[x.id]!==T&&(c(x),r[x.id]=T)}function l(x){let w=n.createBuffer(),b=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,b,A),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(x){let w=s[x.id],b=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let T=0,_=b.length;T<_;T++){let S=b[T];if(Array.isArray(S))for(let D=0,L=S.length;D<L;D++)u(S[D],T,D,A);else u(S,T,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,w,b,A){if(d(x,w,b,A)===!0){let T=x.__offset,_=x.value;if(Array.isArray(_)){let S=0;for(let D=0;D<_.length;D++){let L=_[D],N=y(L,!0);h(L,x.__data,S),S+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,x.__data)}}function h(x,w,b){typeof x=="number"||typeof x=="boolean"?w[b]=x:x.isMatrix3?(w[b]=x.elements[0],w[b+1]=x.elements[1],w[b+2]=x.elements[2],w[b+3]=0,w[b+4]=x.elements[3],w[b+5]=x.elements[4],w[b+6]=x.elements[5],w[b+7]=0,w[b+8]=x.elements[6],w[b+9]=x.elements[7],w[b+10]=x.elements[8],w[b+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-b),b):x.toArray(w,b)}function d(x,w,b,A){let T=x.value,_=w+"_"+b;if(Array.isArray(T)){A[_]===void 0&&(A[_]=[]);let S=A[_],D=!1;for(let L=0;L<T.length;L++)f(T[L],S,L)===!0&&(D=!0);return D}return f(T,A,_)}function f(x,w,b){if(w[b]===void 0)return typeof x=="number"||typeof x=="boolean"?w[b]=x:ArrayBuffer.isView(x)?w[b]=x.slice():w[b]=x.clone(),!0;{let A=w[b];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return w[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let w=x.uniforms,b=0,A=16;for(let _=0,S=w.length;_<S;_++){let D=Array.isArray(w[_])?w[_]:[w[_]];for(let L=0,N=D.length;L<N;L++){let z=D[L],W=Array.isArray(z.value)?z.value:[z.value],B=Array.isArray(w[_])||Array.isArray(z.value),X=b;for(let U=0,Z=W.length;U<Z;U++){let q=W[U],j=y(q,B),et=b%A,ht=et%j.boundary,ft=et+ht;b+=ht,ft!==0&&A-ft<j.storage&&(b+=A-ft),U===0&&(X=b),b+=j.storage}let I=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new I((b-X)/Float32Array.BYTES_PER_ELEMENT),z.__offset=X}}let T=b%A;return T>0&&(b+=A-T),x.__size=b,x.__cache={},this}function y(x,w){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?ee("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):ee("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(x){let w=x.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var KR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),tr=null;function QR(){return tr===null&&(tr=new ic(KR,16,16,no,Es),tr.name="DFG_LUT",tr.minFilter=Si,tr.magFilter=Si,tr.wrapS=Ys,tr.wrapT=Ys,tr.generateMipmaps=!1,tr.needsUpdate=!0),tr}var xd=class{constructor(t={}){let{canvas:e=Sx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Ki}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=f,m=new Set([Fh,Uh,Nh]),g=new Set([Ki,ws,Ga,Po,Ih,Lh]),x=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,T=null,_=[],S=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Qs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,z=null,W=null,B=null,X=null;this._outputColorSpace=bi;let I=0,U=0,Z=null,q=-1,j=null,et=new xn,ht=new xn,ft=null,it=new ie(0),vt=0,xt=e.width,Tt=e.height,At=1,Jt=null,pe=null,Zt=new xn(0,0,xt,Tt),be=new xn(0,0,xt,Tt),xe=!1,de=new wo,hn=new lh,en=!1,Cn=!1,Xe=new _e,$n=new H,Le=new xn,Bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},vn=!1;function Pn(){return Z===null?At:1}let V=i;function Nt(P,$){return e.getContext(P,$)}let ne,me,Ct,je,Yt,Qt,F,R,J,mt,ct,St,wt,rt,at,bt,G,lt,ot,Pt,Mt,Rt,jt;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Wt,!1),e.addEventListener("webglcontextrestored",ae,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),V===null){let $="webgl2";if(V=Nt($,P),V===null)throw Nt($)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}oe()}catch(P){throw e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),re("WebGLRenderer: "+P.message),P}function oe(){ne=new uA(V),ne.init(),Mt=new $R(V,ne),me=new QT(V,ne,t,Mt),Ct=new WR(V,ne),me.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),W=V.createFramebuffer(),B=V.createFramebuffer(),X=V.createFramebuffer(),je=new fA(V),Yt=new PR,Qt=new qR(V,ne,Ct,Yt,me,Mt,je),F=new cA(L),R=new mE(V),Rt=new JT(V,R),J=new hA(V,R,je,Rt),mt=new mA(V,J,R,Rt,je),lt=new pA(V,me,Qt),at=new tA(Yt),ct=new CR(L,F,ne,me,Rt,at),St=new jR(L,Yt),wt=new LR,rt=new BR(ne),G=new jT(L,F,Ct,mt,p,l),bt=new VR(L,mt,me),jt=new JR(V,je,me,Ct),ot=new KT(V,ne,je),Pt=new dA(V,ne,je),je.programs=ct.programs,L.capabilities=me,L.extensions=ne,L.properties=Yt,L.renderLists=wt,L.shadowMap=bt,L.state=Ct,L.info=je}y!==Ki&&(D=new _A(y,e.width,e.height,a,s,r));let pt=new Cm(L,V);this.xr=pt,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let P=ne.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=ne.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(P){P!==void 0&&(At=P,this.setSize(xt,Tt,!1))},this.getSize=function(P){return P.set(xt,Tt)},this.setSize=function(P,$,nt=!0){if(pt.isPresenting){ee("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=P,Tt=$,e.width=Math.floor(P*At),e.height=Math.floor($*At),nt===!0&&(e.style.width=P+"px",e.style.height=$+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,P,$)},this.getDrawingBufferSize=function(P){return P.set(xt*At,Tt*At).floor()},this.setDrawingBufferSize=function(P,$,nt){xt=P,Tt=$,At=nt,e.width=Math.floor(P*nt),e.height=Math.floor($*nt),this.setViewport(0,0,P,$)},this.setEffects=function(P){if(y===Ki){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let $=0;$<P.length;$++)if(P[$].isOutputPass===!0){ee("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(et)},this.getViewport=function(P){return P.copy(Zt)},this.setViewport=function(P,$,nt,K){P.isVector4?Zt.set(P.x,P.y,P.z,P.w):Zt.set(P,$,nt,K),Ct.viewport(et.copy(Zt).multiplyScalar(Pn()).round())},this.getScissor=function(P){return P.copy(be)},this.setScissor=function(P,$,nt,K){P.isVector4?be.set(P.x,P.y,P.z,P.w):be.set(P,$,nt,K),Ct.scissor(ht.copy(be).multiplyScalar(Pn()).round())},this.getScissorTest=function(){return xe},this.setScissorTest=function(P){Ct.setScissorTest(xe=P)},this.setOpaqueSort=function(P){Jt=P},this.setTransparentSort=function(P){pe=P},this.getClearColor=function(P){return P.copy(G.getClearColor())},this.setClearColor=function(){G.setClearColor(...arguments)},this.getClearAlpha=function(){return G.getClearAlpha()},this.setClearAlpha=function(){G.setClearAlpha(...arguments)},this.clear=function(P=!0,$=!0,nt=!0){let K=0;if(P){let Q=!1;if(Z!==null){let It=Z.texture.format;Q=m.has(It)}if(Q){let It=Z.texture.type,Ut=g.has(It),Lt=G.getClearColor(),Ft=G.getClearAlpha(),$t=Lt.r,le=Lt.g,Se=Lt.b;Ut?(x[0]=$t,x[1]=le,x[2]=Se,x[3]=Ft,V.clearBufferuiv(V.COLOR,0,x)):(w[0]=$t,w[1]=le,w[2]=Se,w[3]=Ft,V.clearBufferiv(V.COLOR,0,w))}else K|=V.COLOR_BUFFER_BIT}$&&(K|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&(K|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&V.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),z=P},this.dispose=function(){e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),G.dispose(),wt.dispose(),rt.dispose(),Qt.dispose(),Yt.dispose(),F.dispose(),mt.dispose(),J.dispose(),Rt.dispose(),jt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",au),pt.removeEventListener("sessionend",Us),rr.stop()};function Wt(P){P.preventDefault(),Zl("WebGLRenderer: Context Lost."),N=!0}function ae(){Zl("WebGLRenderer: Context Restored."),N=!1;let P=je.autoReset,$=bt.enabled,nt=bt.autoUpdate,K=bt.needsUpdate,Q=bt.type;oe(),je.autoReset=P,bt.enabled=$,bt.autoUpdate=nt,bt.needsUpdate=K,bt.type=Q}function Dt(P){re("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function ge(P){let $=P.target;$.removeEventListener("dispose",ge),sn($)}function sn(P){fi(P),Yt.remove(P)}function fi(P){let $=Yt.get(P).programs;$!==void 0&&($.forEach(function(nt){ct.releaseProgram(nt)}),P.isShaderMaterial&&ct.releaseShaderCache(P))}this.renderBufferDirect=function(P,$,nt,K,Q,It){$===null&&($=Bn);let Ut=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Lt=wl(P,$,nt,K,Q);Ct.setMaterial(K,Ut);let Ft=nt.index,$t=1;if(K.wireframe===!0){if(Ft=J.getWireframeAttribute(nt),Ft===void 0)return;$t=2}let le=nt.drawRange,Se=nt.attributes.position,qt=le.start*$t,we=(le.start+le.count)*$t;It!==null&&(qt=Math.max(qt,It.start*$t),we=Math.min(we,(It.start+It.count)*$t)),Ft!==null?(qt=Math.max(qt,0),we=Math.min(we,Ft.count)):Se!=null&&(qt=Math.max(qt,0),we=Math.min(we,Se.count));let _n=we-qt;if(_n<0||_n===1/0)return;Rt.setup(Q,K,Lt,nt,Ft);let We,qe=ot;if(Ft!==null&&(We=R.get(Ft),qe=Pt,qe.setIndex(We)),Q.isMesh)K.wireframe===!0?(Ct.setLineWidth(K.wireframeLinewidth*Pn()),qe.setMode(V.LINES)):qe.setMode(V.TRIANGLES);else if(Q.isLine){let kn=K.linewidth;kn===void 0&&(kn=1),Ct.setLineWidth(kn*Pn()),Q.isLineSegments?qe.setMode(V.LINES):Q.isLineLoop?qe.setMode(V.LINE_LOOP):qe.setMode(V.LINE_STRIP)}else Q.isPoints?qe.setMode(V.POINTS):Q.isSprite&&qe.setMode(V.TRIANGLES);if(Q.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))qe.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let kn=Q._multiDrawStarts,Ht=Q._multiDrawCounts,In=Q._multiDrawCount,Re=Ft?R.get(Ft).bytesPerElement:1,ar=Yt.get(K).currentProgram.getUniforms();for(let Ln=0;Ln<In;Ln++)ar.setValue(V,"_gl_DrawID",Ln),qe.render(kn[Ln]/Re,Ht[Ln])}else if(Q.isInstancedMesh)qe.renderInstances(qt,_n,Q.count);else if(nt.isInstancedBufferGeometry){let kn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Ht=Math.min(nt.instanceCount,kn);qe.renderInstances(qt,_n,Ht)}else qe.render(qt,_n)};function bl(P,$,nt,K){z!==null&&P.isNodeMaterial&&z.setObject(K,P),en===!0&&at.setState(P,nt,!1),P.transparent===!0&&P.side===Ni&&P.forceSinglePass===!1?(P.side=Ti,P.needsUpdate=!0,Fs(P,$,K),P.side=eo,P.needsUpdate=!0,Fs(P,$,K),P.side=Ni):Fs(P,$,K)}this.compile=function(P,$,nt=null){nt===null&&(nt=P),z!==null&&z.renderStart(P,$,nt),T=rt.get(nt),T.init($),S.push(T),nt.traverseVisible(function(Q){Q.isLight&&Q.layers.test($.layers)&&(T.pushLight(Q),Q.castShadow&&T.pushShadow(Q))}),P!==nt&&P.traverseVisible(function(Q){Q.isLight&&Q.layers.test($.layers)&&(T.pushLight(Q),Q.castShadow&&T.pushShadow(Q))}),T.setupLights(),z!==null&&z.updateLights(T.state.lightsArray),Cn=this.localClippingEnabled,en=at.init(this.clippingPlanes,Cn),en===!0&&at.setGlobalState(this.clippingPlanes,$),z!==null&&bt.render(T.state.shadowsArray,nt,$);let K=new Set;return P.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let It=Q.material;if(It)if(Array.isArray(It))for(let Ut=0;Ut<It.length;Ut++){let Lt=It[Ut];bl(Lt,nt,$,Q),K.add(Lt)}else bl(It,nt,$,Q),K.add(It)}),T=S.pop(),z!==null&&z.renderEnd(),K},this.compileAsync=function(P,$,nt=null){let K=this.compile(P,$,nt);return new Promise(Q=>{function It(){if(K.forEach(function(Ut){let Ft=Yt.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&K.delete(Ut)}),K.size===0){Q(P);return}setTimeout(It,10)}ne.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let Yo=null;function Xf(P){Yo&&Yo(P)}function au(){rr.stop()}function Us(){rr.start()}let rr=new Qx;rr.setAnimationLoop(Xf),typeof self<"u"&&rr.setContext(self),this.setAnimationLoop=function(P){Yo=P,pt.setAnimationLoop(P),P===null?rr.stop():rr.start()},pt.addEventListener("sessionstart",au),pt.addEventListener("sessionend",Us),this.render=function(P,$){if($!==void 0&&$.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;z!==null&&z.renderStart(P,$);let nt=pt.enabled===!0&&pt.isPresenting===!0,K=D!==null&&(Z===null||nt)&&D.begin(L,Z);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),$.parent===null&&$.matrixWorldAutoUpdate===!0&&$.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera($),$=pt.getCamera()),P.isScene===!0&&P.onBeforeRender(L,P,$,Z),T=rt.get(P,S.length),T.init($),T.state.textureUnits=Qt.getTextureUnits(),S.push(T),Xe.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),$.isArrayCamera?hn.setFromArrayCamera($):de.setFromProjectionMatrix(Xe,as,$.reversedDepth),Cn=this.localClippingEnabled,en=at.init(this.clippingPlanes,Cn),A=wt.get(P,_.length),A.init(),_.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ut=L.xr.getDepthSensingMesh();Ut!==null&&or(Ut,$,-1/0,L.sortObjects)}or(P,$,0,L.sortObjects),A.finish(),z!==null&&z.updateLights(T.state.lightsArray),L.sortObjects===!0&&A.sort(Jt,pe),vn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,vn&&G.addToRenderList(A,P),this.info.autoReset===!0&&this.info.reset(),en===!0&&at.beginShadows();let Q=T.state.shadowsArray;if(bt.render(Q,P,$),en===!0&&at.endShadows(),(K&&D.hasRenderPass())===!1){let Ut=A.opaque,Lt=A.transmissive;if(T.setupLights(),$.isArrayCamera){let Ft=$.cameras;if(Lt.length>0)for(let $t=0,le=Ft.length;$t<le;$t++){let Se=Ft[$t];gs(Ut,Lt,P,Se)}vn&&G.render(P);for(let $t=0,le=Ft.length;$t<le;$t++){let Se=Ft[$t];Ml(A,P,Se,Se.viewport)}}else Lt.length>0&&gs(Ut,Lt,P,$),vn&&G.render(P),Ml(A,P,$)}Z!==null&&U===0&&(Qt.updateMultisampleRenderTarget(Z),Qt.updateRenderTargetMipmap(Z)),K&&D.end(L),P.isScene===!0&&P.onAfterRender(L,P,$),Rt.resetDefaultState(),q=-1,j=null,S.pop(),S.length>0?(T=S[S.length-1],Qt.setTextureUnits(T.state.textureUnits),en===!0&&at.setGlobalState(L.clippingPlanes,T.state.camera)):T=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,z!==null&&z.renderEnd()};function or(P,$,nt,K){if(P.visible===!1)return;if(P.layers.test($.layers)){if(P.isGroup)nt=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update($);else if(P.isLight)T.pushLight(P),P.castShadow&&T.pushShadow(P);else if(P.isSprite){let Ut=$.isArrayCamera?hn:de;if(!P.frustumCulled||P.intersectsFrustum(Ut)){K&&Le.setFromMatrixPosition(P.matrixWorld).applyMatrix4(Xe);let Lt=mt.update(P),Ft=P.material;Ft.visible&&A.push(P,Lt,Ft,nt,Le.z,null,$)}}else if(P.isMesh||P.isLine||P.isPoints){let Ut=$.isArrayCamera?hn:de;if(!P.frustumCulled||P.intersectsFrustum(Ut)){let Lt=mt.update(P),Ft=P.material;if(K&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),Le.copy(P.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),Le.copy(Lt.boundingSphere.center)),Le.applyMatrix4(P.matrixWorld).applyMatrix4(Xe)),Array.isArray(Ft)){let $t=Lt.groups;for(let le=0,Se=$t.length;le<Se;le++){let qt=$t[le],we=Ft[qt.materialIndex];we&&we.visible&&A.push(P,Lt,we,nt,Le.z,qt,$)}}else Ft.visible&&A.push(P,Lt,Ft,nt,Le.z,null,$)}}}let It=P.children;for(let Ut=0,Lt=It.length;Ut<Lt;Ut++)or(It[Ut],$,nt,K)}function Ml(P,$,nt,K){let{opaque:Q,transmissive:It,transparent:Ut}=P;T.setupLightsView(nt),en===!0&&at.setGlobalState(L.clippingPlanes,nt),K&&Ct.viewport(et.copy(K)),Q.length>0&&bn(Q,$,nt),It.length>0&&bn(It,$,nt),Ut.length>0&&bn(Ut,$,nt),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function gs(P,$,nt,K){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[K.id]===void 0){let qt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[K.id]=new Yi(1,1,{generateMipmaps:!0,type:qt?Es:Ki,minFilter:Er,samples:Math.max(4,me.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ce.workingColorSpace})}let It=T.state.transmissionRenderTarget[K.id],Ut=K.viewport||et;It.setSize(Ut.z*L.transmissionResolutionScale,Ut.w*L.transmissionResolutionScale);let Lt=L.getRenderTarget(),Ft=L.getActiveCubeFace(),$t=L.getActiveMipmapLevel();L.setRenderTarget(It),L.getClearColor(it),vt=L.getClearAlpha(),vt<1&&L.setClearColor(16777215,.5),L.clear(),vn&&G.render(nt);let le=L.toneMapping;L.toneMapping=Qs;let Se=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),T.setupLightsView(K),en===!0&&at.setGlobalState(L.clippingPlanes,K),bn(P,nt,K),Qt.updateMultisampleRenderTarget(It),Qt.updateRenderTargetMipmap(It),ne.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let we=0,_n=$.length;we<_n;we++){let We=$[we],{object:qe,geometry:kn,material:Ht,group:In}=We;if(Ht.side===Ni&&qe.layers.test(K.layers)){let Re=Ht.side;Ht.side=Ti,Ht.needsUpdate=!0,An(qe,nt,K,kn,Ht,In),Ht.side=Re,Ht.needsUpdate=!0,qt=!0}}qt===!0&&(Qt.updateMultisampleRenderTarget(It),Qt.updateRenderTargetMipmap(It))}L.setRenderTarget(Lt,Ft,$t),L.setClearColor(it,vt),Se!==void 0&&(K.viewport=Se),L.toneMapping=le}function bn(P,$,nt){let K=$.isScene===!0?$.overrideMaterial:null;for(let Q=0,It=P.length;Q<It;Q++){let Ut=P[Q],{object:Lt,geometry:Ft,group:$t}=Ut,le=Ut.material;le.allowOverride===!0&&K!==null&&(le=K),Lt.layers.test(nt.layers)&&An(Lt,$,nt,Ft,le,$t)}}function An(P,$,nt,K,Q,It){z!==null&&Q.isNodeMaterial&&z.setObject(P,Q),P.onBeforeRender(L,$,nt,K,Q,It),P.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),Q.onBeforeRender(L,$,nt,K,P,It),Q.transparent===!0&&Q.side===Ni&&Q.forceSinglePass===!1?(Q.side=Ti,Q.needsUpdate=!0,L.renderBufferDirect(nt,$,K,Q,P,It),Q.side=eo,Q.needsUpdate=!0,L.renderBufferDirect(nt,$,K,Q,P,It),Q.side=Ni):L.renderBufferDirect(nt,$,K,Q,P,It),P.onAfterRender(L,$,nt,K,Q,It)}function Rn(P){let $=0;for(let nt of P)nt.texture!==null&&$++;return $}function Fs(P,$,nt){$.isScene!==!0&&($=Bn);let K=Yt.get(P),Q=T.state.lights,It=T.state.shadowsArray,Ut=Q.state.version,Lt=ct.getParameters(P,Q.state,It,$,nt,T.state.lightProbeGridArray),Ft=ct.getProgramCacheKey(Lt),$t=K.programs;K.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?$.environment:null,K.fog=$.fog;let le=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;K.envMap=F.get(P.envMap||K.environment,le),K.envMapRotation=K.environment!==null&&P.envMap===null?$.environmentRotation:P.envMapRotation,$t===void 0&&(P.addEventListener("dispose",ge),$t=new Map,K.programs=$t,K.programVariants=new Map);let Se=$t.get(Ft);if(Se!==void 0){if(K.currentProgram===Se&&K.lightsStateVersion===Ut)return Sl(P,Lt),Se}else Lt.uniforms=ct.getUniforms(P),z!==null&&P.isNodeMaterial&&z.build(P,nt,Lt),P.onBeforeCompile(Lt,L),Se=ct.acquireProgram(Lt,Ft),$t.set(Ft,Se),K.uniforms=Lt.uniforms;let qt=K.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(qt.clippingPlanes=at.uniform),Sl(P,Lt),K.needsLights=Or(P),K.lightsStateVersion=Ut,K.needsLights&&(qt.ambientLightColor.value=Q.state.ambient,qt.lightProbe.value=Q.state.probe,qt.sunLights.value=Q.state.sun,qt.sunLightShadows.value=Q.state.sunShadow,qt.directionalLights.value=Q.state.directional,qt.directionalLightShadows.value=Q.state.directionalShadow,qt.spotLights.value=Q.state.spot,qt.spotLightShadows.value=Q.state.spotShadow,qt.rectAreaLights.value=Q.state.rectArea,qt.ltc_1.value=Q.state.rectAreaLTC1,qt.ltc_2.value=Q.state.rectAreaLTC2,qt.pointLights.value=Q.state.point,qt.pointLightShadows.value=Q.state.pointShadow,qt.hemisphereLights.value=Q.state.hemi,qt.sunShadowMatrix.value=Q.state.sunShadowMatrix,qt.sunShadowCascade.value=Q.state.sunShadowCascade,qt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,qt.spotLightMatrix.value=Q.state.spotLightMatrix,qt.spotLightMap.value=Q.state.spotLightMap,qt.pointShadowMatrix.value=Q.state.pointShadowMatrix),K.numLightProbeGrids=Rn(T.state.lightProbeGridArray),K.currentProgram=Se,K.uniformsList=null,Se}function Hi(P,$,nt,K,Q){let It=Yt.get(P),Ut=It.currentProgram.id+","+K+","+Q,Lt=It.programVariants.get(Ut);return Lt===void 0?(Lt=Fs(P,$,nt),It.programVariants.set(Ut,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=K,It.toneMapping=Q),Lt}function Fr(P){if(P.uniformsList===null){let $=P.currentProgram.getUniforms();P.uniformsList=Va.seqWithValue($.seq,P.uniforms)}return P.uniformsList}function Sl(P,$){let nt=Yt.get(P);nt.outputColorSpace=$.outputColorSpace,nt.batching=$.batching,nt.batchingColor=$.batchingColor,nt.instancing=$.instancing,nt.instancingColor=$.instancingColor,nt.instancingMorph=$.instancingMorph,nt.skinning=$.skinning,nt.morphTargets=$.morphTargets,nt.morphNormals=$.morphNormals,nt.morphColors=$.morphColors,nt.morphTargetsCount=$.morphTargetsCount,nt.numClippingPlanes=$.numClippingPlanes,nt.numIntersection=$.numClipIntersection,nt.vertexAlphas=$.vertexAlphas,nt.vertexTangents=$.vertexTangents,nt.toneMapping=$.toneMapping}function wl(P,$,nt,K,Q){$.isScene!==!0&&($=Bn),Qt.resetTextureUnits();let It=$.fog,Ut=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?$.environment:null,Lt=Z===null?L.outputColorSpace:Z.isXRRenderTarget===!0?Z.texture.colorSpace:Ce.workingColorSpace,Ft=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,$t=F.get(K.envMap||Ut,Ft),le=K.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,Se=!!nt.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),qt=!!nt.morphAttributes.position,we=!!nt.morphAttributes.normal,_n=!!nt.morphAttributes.color,We=Qs;K.toneMapped&&(Z===null||Z.isXRRenderTarget===!0)&&(We=L.toneMapping);let qe=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,kn=qe!==void 0?qe.length:0,Ht=Yt.get(K),In=T.state.lights;if(en===!0&&(Cn===!0||P!==j)){let $e=P===j&&K.id===q;at.setState(K,P,$e)}let Re=!1,ar=!1;K.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==In.state.version||Q.isBatchedMesh&&Ht.batching===!1||!Q.isBatchedMesh&&Ht.batching===!0||Q.isBatchedMesh&&Ht.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Ht.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Ht.instancing===!1||!Q.isInstancedMesh&&Ht.instancing===!0||Q.isSkinnedMesh&&Ht.skinning===!1||!Q.isSkinnedMesh&&Ht.skinning===!0||Q.isInstancedMesh&&Ht.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Ht.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Ht.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Ht.instancingMorph===!1&&Q.morphTexture!==null||Ht.envMap!==$t||K.fog===!0&&Ht.fog!==It||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==at.numPlanes||Ht.numIntersection!==at.numIntersection)||Ht.vertexAlphas!==le||Ht.vertexTangents!==Se||Ht.morphTargets!==qt||Ht.morphNormals!==we||Ht.morphColors!==_n||Ht.morphTargetsCount!==kn||Ht.numLightProbeGrids!==Rn(T.state.lightProbeGridArray)?Re=!0:(Ht.outputColorSpace!==Lt||Ht.toneMapping!==We)&&(ar=!0):(Re=!0,Ht.__version=K.version);let Ln=Ht.currentProgram;(Re===!0||ar===!0)&&(Ln=ar===!0?Hi(K,$,Q,Lt,We):Fs(K,$,Q),z&&K.isNodeMaterial&&z.onUpdateProgram(K,Ln,Ht));let Jo=!1,Os=!1,lr=!1,ye=Ln.getUniforms(),Mn=Ht.uniforms;if(Ct.useProgram(Ln.program)&&(Jo=!0,Os=!0,lr=!0),K.id!==q&&(q=K.id,Os=!0),Jo||j!==P){Ct.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),ye.setValue(V,"projectionMatrix",P.projectionMatrix),ye.setValue(V,"viewMatrix",P.matrixWorldInverse);let Dn=ye.map.cameraPosition;Dn!==void 0&&Dn.setValue(V,$n.setFromMatrixPosition(P.matrixWorld)),me.logarithmicDepthBuffer&&ye.setValue(V,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&ye.setValue(V,"isOrthographic",P.isOrthographicCamera===!0),j!==P&&(j=P,Os=!0,lr=!0)}if(Ht.needsLights&&(In.state.sunShadowMap.length>0&&ye.setValue(V,"sunShadowMap",In.state.sunShadowMap,Qt),In.state.directionalShadowMap.length>0&&ye.setValue(V,"directionalShadowMap",In.state.directionalShadowMap,Qt),In.state.spotShadowMap.length>0&&ye.setValue(V,"spotShadowMap",In.state.spotShadowMap,Qt),In.state.pointShadowMap.length>0&&ye.setValue(V,"pointShadowMap",In.state.pointShadowMap,Qt)),Q.isSkinnedMesh){ye.setOptional(V,Q,"bindMatrix"),ye.setOptional(V,Q,"bindMatrixInverse");let $e=Q.skeleton;$e&&($e.boneTexture===null&&$e.computeBoneTexture(),ye.setValue(V,"boneTexture",$e.boneTexture,Qt))}Q.isBatchedMesh&&(ye.setOptional(V,Q,"batchingTexture"),ye.setValue(V,"batchingTexture",Q._matricesTexture,Qt),ye.setOptional(V,Q,"batchingIdTexture"),ye.setValue(V,"batchingIdTexture",Q._indirectTexture,Qt),ye.setOptional(V,Q,"batchingColorTexture"),Q._colorsTexture!==null&&ye.setValue(V,"batchingColorTexture",Q._colorsTexture,Qt));let pi=nt.morphAttributes;if((pi.position!==void 0||pi.normal!==void 0||pi.color!==void 0)&&lt.update(Q,nt,Ln),(Os||Ht.receiveShadow!==Q.receiveShadow)&&(Ht.receiveShadow=Q.receiveShadow,ye.setValue(V,"receiveShadow",Q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&$.environment!==null&&(Mn.envMapIntensity.value=$.environmentIntensity),Mn.dfgLUT!==void 0&&(Mn.dfgLUT.value=QR()),Os){if(ye.setValue(V,"toneMappingExposure",L.toneMappingExposure),Ht.needsLights&&Zo(Mn,lr),It&&K.fog===!0&&St.refreshFogUniforms(Mn,It),St.refreshMaterialUniforms(Mn,K,At,Tt,T.state.transmissionRenderTarget[P.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let $e=b,Dn=0;for(let oi of T.state.lightProbeGridArray)oi.texture!==null&&($e.textures[Dn]=oi.texture,$e.min[Dn]=oi.boundingBox.min,$e.max[Dn]=oi.boundingBox.max,$e.resolution[Dn]=oi.resolution,Dn++);for(let oi in $e)$e[oi].length=Dn;Mn.probesSH.value=$e.textures,Mn.probesMin.value=$e.min,Mn.probesMax.value=$e.max,Mn.probesResolution.value=$e.resolution}Va.upload(V,Fr(Ht),Mn,Qt)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Va.upload(V,Fr(Ht),Mn,Qt),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&ye.setValue(V,"center",Q.center),ye.setValue(V,"modelViewMatrix",Q.modelViewMatrix),ye.setValue(V,"normalMatrix",Q.normalMatrix),ye.setValue(V,"modelMatrix",Q.matrixWorld),K.uniformsGroups!==void 0){let $e=K.uniformsGroups;for(let Dn=0,oi=$e.length;Dn<oi;Dn++){let lu=$e[Dn];jt.update(lu,Ln),jt.bind(lu,Ln)}}return Ln}function Zo(P,$){P.ambientLightColor.needsUpdate=$,P.lightProbe.needsUpdate=$,P.sunLights.needsUpdate=$,P.sunLightShadows.needsUpdate=$,P.directionalLights.needsUpdate=$,P.directionalLightShadows.needsUpdate=$,P.pointLights.needsUpdate=$,P.pointLightShadows.needsUpdate=$,P.spotLights.needsUpdate=$,P.spotLightShadows.needsUpdate=$,P.rectAreaLights.needsUpdate=$,P.hemisphereLights.needsUpdate=$}function Or(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return I},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return Z},this.setRenderTargetTextures=function(P,$,nt){let K=Yt.get(P);K.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Yt.get(P.texture).__webglTexture=$,Yt.get(P.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:nt,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,$){let nt=Yt.get(P);nt.__webglFramebuffer=$,nt.__useDefaultFramebuffer=$===void 0},this.setRenderTarget=function(P,$=0,nt=0){Z=P,I=$,U=nt;let K=null,Q=!1,It=!1;if(P){let Lt=Yt.get(P);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(V.FRAMEBUFFER,Lt.__webglFramebuffer),et.copy(P.viewport),ht.copy(P.scissor),ft=P.scissorTest,Ct.viewport(et),Ct.scissor(ht),Ct.setScissorTest(ft),q=-1;return}else if(Lt.__webglFramebuffer===void 0)Qt.setupRenderTarget(P);else if(Lt.__hasExternalTextures)Qt.rebindTextures(P,Yt.get(P.texture).__webglTexture,Yt.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let le=P.depthTexture;if(Lt.__boundDepthTexture!==le){if(le!==null&&Yt.has(le)&&(P.width!==le.image.width||P.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Qt.setupDepthRenderbuffer(P)}}let Ft=P.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(It=!0);let $t=Yt.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray($t[$])?K=$t[$][nt]:K=$t[$],Q=!0):P.samples>0&&Qt.useMultisampledRTT(P)===!1?K=Yt.get(P).__webglMultisampledFramebuffer:Array.isArray($t)?K=$t[nt]:K=$t,et.copy(P.viewport),ht.copy(P.scissor),ft=P.scissorTest}else et.copy(Zt).multiplyScalar(At).floor(),ht.copy(be).multiplyScalar(At).floor(),ft=xe;if(nt!==0&&(K=W),Ct.bindFramebuffer(V.FRAMEBUFFER,K)&&Ct.drawBuffers(P,K),Ct.viewport(et),Ct.scissor(ht),Ct.setScissorTest(ft),Q){let Lt=Yt.get(P.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+$,Lt.__webglTexture,nt)}else if(It){let Lt=$;for(let Ft=0;Ft<P.textures.length;Ft++){let $t=Yt.get(P.textures[Ft]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Ft,$t.__webglTexture,nt,Lt)}}else if(P!==null&&nt!==0){let Lt=Yt.get(P.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Lt.__webglTexture,nt)}q=-1};function jo(P){let $=Yt.get(P);return($.__readFormat!==P.format||$.__readType!==P.type)&&($.__readFormat=P.format,$.__readType=P.type,$.__formatReadable=me.textureFormatReadable(P.format),$.__typeReadable=me.textureTypeReadable(P.type)),$}this.readRenderTargetPixels=function(P,$,nt,K,Q,It,Ut,Lt=0){if(!(P&&P.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Yt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Ct.bindFramebuffer(V.FRAMEBUFFER,Ft);try{let $t=P.textures[Lt],le=$t.format,Se=$t.type;P.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Lt);let qt=jo($t);if(qt.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}$>=0&&$<=P.width-K&&nt>=0&&nt<=P.height-Q&&V.readPixels($,nt,K,Q,Mt.convert(le),Mt.convert(Se),It)}finally{let $t=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer(V.FRAMEBUFFER,$t)}}},this.readRenderTargetPixelsAsync=async function(P,$,nt,K,Q,It,Ut,Lt=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Yt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if($>=0&&$<=P.width-K&&nt>=0&&nt<=P.height-Q){Ct.bindFramebuffer(V.FRAMEBUFFER,Ft);let $t=P.textures[Lt],le=$t.format,Se=$t.type;P.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Lt);let qt=jo($t);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let we=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,we),V.bufferData(V.PIXEL_PACK_BUFFER,It.byteLength,V.STREAM_READ),V.readPixels($,nt,K,Q,Mt.convert(le),Mt.convert(Se),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let _n=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer(V.FRAMEBUFFER,_n);let We=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await Ex(V,We,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,we),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,It),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(we),V.deleteSync(We),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,$=null,nt=0){let K=Math.pow(2,-nt),Q=Math.floor(P.image.width*K),It=Math.floor(P.image.height*K),Ut=$!==null?$.x:0,Lt=$!==null?$.y:0;Qt.setTexture2D(P,0),V.copyTexSubImage2D(V.TEXTURE_2D,nt,0,0,Ut,Lt,Q,It),Ct.unbindTexture()},this.copyTextureToTexture=function(P,$,nt=null,K=null,Q=0,It=0){let Ut,Lt,Ft,$t,le,Se,qt,we,_n,We=P.isCompressedTexture?P.mipmaps[It]:P.image;if(nt!==null)Ut=nt.max.x-nt.min.x,Lt=nt.max.y-nt.min.y,Ft=nt.isBox3?nt.max.z-nt.min.z:1,$t=nt.min.x,le=nt.min.y,Se=nt.isBox3?nt.min.z:0;else{let ye=Math.pow(2,-Q);Ut=Math.floor(We.width*ye),Lt=Math.floor(We.height*ye),P.isDataArrayTexture?Ft=We.depth:P.isData3DTexture?Ft=Math.floor(We.depth*ye):Ft=1,$t=0,le=0,Se=0}K!==null?(qt=K.x,we=K.y,_n=K.z):(qt=0,we=0,_n=0);let qe=Mt.convert($.format),kn=Mt.convert($.type),Ht;$.isData3DTexture?(Qt.setTexture3D($,0),Ht=V.TEXTURE_3D):$.isDataArrayTexture||$.isCompressedArrayTexture?(Qt.setTexture2DArray($,0),Ht=V.TEXTURE_2D_ARRAY):(Qt.setTexture2D($,0),Ht=V.TEXTURE_2D),Ct.activeTexture(V.TEXTURE0),Ct.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,$.flipY),Ct.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,$.premultiplyAlpha),Ct.pixelStorei(V.UNPACK_ALIGNMENT,$.unpackAlignment);let In=Ct.getParameter(V.UNPACK_ROW_LENGTH),Re=Ct.getParameter(V.UNPACK_IMAGE_HEIGHT),ar=Ct.getParameter(V.UNPACK_SKIP_PIXELS),Ln=Ct.getParameter(V.UNPACK_SKIP_ROWS),Jo=Ct.getParameter(V.UNPACK_SKIP_IMAGES);Ct.pixelStorei(V.UNPACK_ROW_LENGTH,We.width),Ct.pixelStorei(V.UNPACK_IMAGE_HEIGHT,We.height),Ct.pixelStorei(V.UNPACK_SKIP_PIXELS,$t),Ct.pixelStorei(V.UNPACK_SKIP_ROWS,le),Ct.pixelStorei(V.UNPACK_SKIP_IMAGES,Se);let Os=P.isDataArrayTexture||P.isData3DTexture,lr=$.isDataArrayTexture||$.isData3DTexture;if(P.isDepthTexture){let ye=Yt.get(P),Mn=Yt.get($),pi=Yt.get(ye.__renderTarget),$e=Yt.get(Mn.__renderTarget);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,pi.__webglFramebuffer),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,$e.__webglFramebuffer);for(let Dn=0;Dn<Ft;Dn++)Os&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Yt.get(P).__webglTexture,Q,Se+Dn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Yt.get($).__webglTexture,It,_n+Dn)),V.blitFramebuffer($t,le,$t+Ut,le+Lt,qt,we,qt+Ut,we+Lt,V.DEPTH_BUFFER_BIT,V.NEAREST);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(Q!==0||P.isRenderTargetTexture||Yt.has(P)){let ye=Yt.get(P),Mn=Yt.get($);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,B),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,X);for(let pi=0;pi<Ft;pi++)Os?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ye.__webglTexture,Q,Se+pi):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,ye.__webglTexture,Q),lr?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Mn.__webglTexture,It,_n+pi):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Mn.__webglTexture,It),Q!==0?V.blitFramebuffer($t,le,$t+Ut,le+Lt,qt,we,qt+Ut,we+Lt,V.COLOR_BUFFER_BIT,V.NEAREST):lr?V.copyTexSubImage3D(Ht,It,qt,we,_n+pi,$t,le,Ut,Lt):V.copyTexSubImage2D(Ht,It,qt,we,$t,le,Ut,Lt);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else lr?P.isDataTexture||P.isData3DTexture?V.texSubImage3D(Ht,It,qt,we,_n,Ut,Lt,Ft,qe,kn,We.data):$.isCompressedArrayTexture?V.compressedTexSubImage3D(Ht,It,qt,we,_n,Ut,Lt,Ft,qe,We.data):V.texSubImage3D(Ht,It,qt,we,_n,Ut,Lt,Ft,qe,kn,We):P.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,It,qt,we,Ut,Lt,qe,kn,We.data):P.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,It,qt,we,We.width,We.height,qe,We.data):V.texSubImage2D(V.TEXTURE_2D,It,qt,we,Ut,Lt,qe,kn,We);Ct.pixelStorei(V.UNPACK_ROW_LENGTH,In),Ct.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Re),Ct.pixelStorei(V.UNPACK_SKIP_PIXELS,ar),Ct.pixelStorei(V.UNPACK_SKIP_ROWS,Ln),Ct.pixelStorei(V.UNPACK_SKIP_IMAGES,Jo),It===0&&$.generateMipmaps===!0&&$.mipmapsAutoUpdate===!0&&V.generateMipmap(Ht),Ct.unbindTexture()},this.initRenderTarget=function(P){Yt.get(P).__webglFramebuffer===void 0&&Qt.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?Qt.setTextureCube(P,0):P.isData3DTexture?Qt.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?Qt.setTexture2DArray(P,0):Qt.setTexture2D(P,0),Ct.unbindTexture()},this.resetState=function(){I=0,U=0,Z=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return as}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ce._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ce._getUnpackColorSpace()}};var zt={},tC=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],eC={light:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"],dark:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},uy=matchMedia("(prefers-color-scheme: dark)");function bd(){let n=M.theme==="dark"||M.theme==="auto"&&uy.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of tC)zt[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();zt.dark=n,zt.curves=eC[n?"dark":"light"]}function Md(n){M.theme=n,bd(),dt("theme")}uy.addEventListener("change",()=>{M.theme==="auto"&&(bd(),dt("theme"))});var hy={type:"change"},Im={type:"start"},fy={type:"end"},Sd=new br,dy=new ii,nC=Math.cos(70*so.DEG2RAD),Gn=new H,Ui=2*Math.PI,Oe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Pm=1e-6,wd=class extends gc{constructor(t,e=null){super(t,e),this.state=Oe.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Qr.ROTATE,MIDDLE:Qr.DOLLY,RIGHT:Qr.PAN},this.touches={ONE:to.ROTATE,TWO:to.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new cn,this._lastTargetPosition=new H,this._quat=new cn().setFromUnitVectors(t.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ba,this._sphericalDelta=new Ba,this._scale=1,this._panOffset=new H,this._rotateStart=new Xt,this._rotateEnd=new Xt,this._rotateDelta=new Xt,this._panStart=new Xt,this._panEnd=new Xt,this._panDelta=new Xt,this._dollyStart=new Xt,this._dollyEnd=new Xt,this._dollyDelta=new Xt,this._dollyDirection=new H,this._mouse=new Xt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=sC.bind(this),this._onPointerDown=iC.bind(this),this._onPointerUp=rC.bind(this),this._onContextMenu=dC.bind(this),this._onMouseWheel=lC.bind(this),this._onKeyDown=cC.bind(this),this._onTouchStart=uC.bind(this),this._onTouchMove=hC.bind(this),this._onMouseDown=oC.bind(this),this._onMouseMove=aC.bind(this),this._interceptControlDown=fC.bind(this),this._interceptControlUp=pC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Oe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(hy),this.update(),this.state=Oe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Gn.copy(e).sub(this.target),Gn.applyQuaternion(this._quat),this._spherical.setFromVector3(Gn),this.autoRotate&&this.state===Oe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Ui:i>Math.PI&&(i-=Ui),s<-Math.PI?s+=Ui:s>Math.PI&&(s-=Ui),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Gn.setFromSpherical(this._spherical),Gn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Gn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Gn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new H(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Gn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Sd.origin.copy(this.object.position),Sd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Sd.direction))<nC?this.object.lookAt(this.target):(dy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Sd.intersectPlane(dy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Pm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Pm||this._lastTargetPosition.distanceToSquared(this.target)>Pm?(this.dispatchEvent(hy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Ui/60*this.autoRotateSpeed*t:Ui/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Gn.setFromMatrixColumn(e,0),Gn.multiplyScalar(-t),this._panOffset.add(Gn)}_panUp(t,e){this.screenSpacePanning===!0?Gn.setFromMatrixColumn(e,1):(Gn.setFromMatrixColumn(e,0),Gn.crossVectors(this.object.up,Gn)),Gn.multiplyScalar(t),this._panOffset.add(Gn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Gn.copy(s).sub(this.target);let r=Gn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Xt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function iC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function sC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function rC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(fy),this.state=Oe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function oC(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Qr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Oe.DOLLY;break;case Qr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Oe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Oe.ROTATE}break;case Qr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Oe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Oe.PAN}break;default:this.state=Oe.NONE}this.state!==Oe.NONE&&this.dispatchEvent(Im)}function aC(n){switch(this.state){case Oe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Oe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Oe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function lC(n){this.enabled===!1||this.enableZoom===!1||this.state!==Oe.NONE||(n.preventDefault(),this.dispatchEvent(Im),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(fy))}function cC(n){this.enabled!==!1&&this._handleKeyDown(n)}function uC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case to.ROTATE:if(this.enableRotate===!1){this.state=Oe.NONE;break}this._handleTouchStartRotate(n),this.state=Oe.TOUCH_ROTATE;break;case to.PAN:if(this.enablePan===!1){this.state=Oe.NONE;break}this._handleTouchStartPan(n),this.state=Oe.TOUCH_PAN;break;default:this.state=Oe.NONE}break;case 2:switch(this.touches.TWO){case to.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Oe.TOUCH_DOLLY_PAN;break;case to.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Oe.TOUCH_DOLLY_ROTATE;break;default:this.state=Oe.NONE}break;default:this.state=Oe.NONE}this.state!==Oe.NONE&&this.dispatchEvent(Im)}function hC(n){switch(this._trackPointer(n),this.state){case Oe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Oe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Oe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Oe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Oe.NONE}}function dC(n){this.enabled!==!1&&n.preventDefault()}function fC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function pC(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var py=[1,.75,.55,.42],mC=30,gC=17,_C=400,my=6e6;function gy(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Ed=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(my/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>mC&&this.level<py.length-1?this.level+=1:i<gC&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*py[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(my/this.area),.5))),this.draw()},_C)}};var yy=32,vy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},yn=new Kl,Be=new Mi(yy,1,.01,100);Be.up.set(0,0,1);var Qi,En,hs,Nm,Lm=!1,by=!1,Um=0;function Ee(){Lm||!by||(Lm=!0,requestAnimationFrame(My))}function My(n=performance.now()){Lm=!1,Nm.moving(n),Fm()}var Sy=[],wy=n=>Sy.push(n);function Fm(){for(let n of Sy)n();Qi.render(yn,Be),Um+=1}function Ey(){by=!0,Ee()}function qa(n){return Fm(),n(Qi.domElement)}var Ty=()=>Um;yn.fog=new Jl("#fff",1,10);function _y(n){let t=document.createElement("canvas");t.width=hs.clientWidth||1,t.height=hs.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>xC.has(s)?i(s):null,e}var xC=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function Ay(n){hs=n;let t=_y(!1),e=gy(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=_y(!0)),Qi=new xd({canvas:t.canvas,context:t}),Qi.debug.checkShaderErrors=!1,Nm=new Ed(e,Qi,Fm,i=>dt("hurry",i)),Qi.domElement.setAttribute("aria-hidden","true"),hs.append(Qi.domElement),En=new wd(Be,Qi.domElement),En.enableDamping=!1,En.addEventListener("change",Ee),En.addEventListener("end",()=>{Cc=!Cy(),Lo=null}),new ResizeObserver(yC).observe(hs),hs.tabIndex=0,hs.setAttribute("role","application"),hs.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),hs.addEventListener("keydown",vC)}function yC(){let n=hs.clientWidth,t=hs.clientHeight;!n||!t||(Nm.resized(n,t),Qi.setSize(n,t),Be.aspect=n/t,Be.updateProjectionMatrix(),Um?My():Ee(),$a())}function vC(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)bC(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")xy(1/1.15);else if(n.key==="-")xy(1.15);else if(n.key.toLowerCase()==="f")Ad(Do);else if(e)Om(e);else return;n.preventDefault()}function bC(n,t){let e=Be.position.clone().sub(En.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Be.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(En.target),En.update(),Ee()}function xy(n){Be.position.sub(En.target).multiplyScalar(n).add(En.target),En.update(),Ee()}var Do=[[0,0,0],[0,0,1]];function Ry(n,t){let e=new Di().setFromPoints(n.map(u=>new H(...u))),i=e.getCenter(new H),s=new H(...t).normalize(),r=new H().crossVectors(Be.up,s).normalize(),o=new H().crossVectors(s,r),a=Math.tan(so.degToRad(yy/2))*.8,l=a*Be.aspect,c=e.getSize(new H).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,y=-1/0;for(let m of n){let g=new H(...m).sub(i),x=g.dot(r),w=g.dot(o),b=g.dot(s);h=Math.max(h,b+Math.abs(x)/l,b+Math.abs(w)/a),d=Math.min(d,w),f=Math.max(f,w),p=Math.min(p,x),y=Math.max(y,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+y)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var Dm=0;function Td({target:n,position:t},e=.35){let i={t:En.target.clone(),p:Be.position.clone()},s=performance.now(),r=++Dm,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==Dm)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);En.target.lerpVectors(i.t,n,u),Be.position.lerpVectors(i.p,t,u);let h=Be.position.distanceTo(En.target);Be.near=h/100,Be.far=h*30,yn.fog.near=h*1.3,yn.fog.far=h*3.4,Be.updateProjectionMatrix(),En.update(),Ee(),c<1&&requestAnimationFrame(a)})(s)}function Ad(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){Do=n,i||(Lo=null),Cc=!1;let s=e?vy[e]:Be.position.clone().sub(En.target).toArray();Td(Ry(n,s),t?0:.35)}function Om(n){Cc=!1,Lo=null,Td(Ry(Do,vy[n]))}var Cc=!1;function Cy(){Be.updateMatrixWorld();let n=new H;return Do.every(t=>(n.set(...t).project(Be),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function $a(){Cc||!En.enabled||!Do.length||Cy()||(Lo??={position:Be.position.clone(),target:En.target.clone()},Ad(Do,{byItself:!0}))}var Lo=null;function Py(){if(!Lo||Cc||!En.enabled)return;let n=Lo;Lo=null,Td(n),setTimeout($a,500)}var Bm=n=>{Do=n},Rd=()=>[...Be.position.toArray(),...En.target.toArray()].map(n=>Number(n.toPrecision(5)));function Iy(n){Dm+=1,Td({position:new H(...n.slice(0,3)),target:new H(...n.slice(3))},0)}var nr=null,km={cell:.1};function zm(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;km.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ie(zt.gridFine),l=new ie(zt.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}nr?.geometry.dispose();let c=new Ae;c.setAttribute("position",new Pe(r,3)),c.setAttribute("color",new Pe(o,3)),nr?nr.geometry=c:(nr=new Eo(c,new Zi({vertexColors:!0})),nr.renderOrder=-2,nr.material.depthWrite=!1,yn.add(nr)),nr.userData.reach=n,Ee()}function Hm(){yn.background=new ie(zt.ground),yn.fog.color.set(zt.ground),nr&&zm(nr.userData.reach),Ee()}function Fi(n){Be.updateMatrixWorld();let t=new H(...n).project(Be),e=hs.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Cd(n){let t=n.joints.length,e=ai(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function Gm(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=ip(n,t),u=(d,f,p,y=!0)=>{rs(Ii(f,d))<=l||(s.rods.push({a:d,b:f,r:p}),y&&s.balls.push({at:f,r:p}))};a&&(s.pedestal={at:te(t[0]),dir:Gs(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:p},y)=>{let m=r[y],g=n.joints[y],x=te(t[y]),w=te(t[y+1]),b=m*.62;if(n.convention==="standard"){let z=Pl(x,f,Cl(Ii(w,x),f));u(x,z,b),u(z,w,b)}else u(x,d,b),u(d,w,b);let A=d,T=Cl(Ii(w,d),f);h&&rs(Ii(d,h.at))<.5*m&&Math.abs(T)>l?A=Pl(d,f,Math.sign(T)*Math.min(Math.abs(T)*.55,h.r+m*1.15)):y===0&&Math.abs(T)>2.2*m&&(A=Pl(d,f,Math.sign(T)*m*1.25));let _=m*2.15,S=Gs(t[y+1],0),D=!!(i&&Vm(g,i[y])),L=Gs(t[0],2),N=Cl(Ii(A,te(t[0])),L)-_/2;y===0&&g.type==="R"&&Math.abs(Cl(f,L))>.99&&N<0&&N>-_&&(A=Pl(A,L,-N)),g.type==="R"?s.drums.push({at:A,dir:f,x:p,turned:S,r:m,h:_,beyond:D,joint:y}):s.sleeves.push({at:A,dir:f,x:p,r:m*.95,h:m*3.4,beyond:D,joint:y}),h={at:d,r:m}}),a){let d=t[a+1],f=te(t[a]);s.flange={at:f,dir:Gs(t[a],2),turned:Gs(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,te(d),e.rest*.34,!1),s.tip={at:te(d),r:e.rest*.42}}return s}function Vm(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function Pc(n,t){let e=Cd(n).radius[0]??.05,i=te(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(te)];for(let{point:r}of ip(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function SC(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new uc(s.map(([a,l])=>new Xt(a,l)),n):new ji(1,1,1,n),o={rod:i(new ji(1,1,1,n,1,!0)),ball:t>3?new wr(1,n,t):new hc(1,0),drum:i(r),box:new ls(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var Ly=new Map,Xm=(n,t)=>Ly.get(n)??Ly.set(n,SC(n,t)).get(n),wC=()=>Xm(26,12),Wm=()=>Xm(11,5),Dy=()=>Xm(6,3),Id=class{constructor(t){this.mesh=new mn(new Ae,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Ae,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new Je(c,l).setUsage(fd);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new Je(o,1).setUsage(fd)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l){let c=this.corners,u=c+t.count;(3*u>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(u,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let h=0,d=3*c;h<3*t.count;h+=3,d+=3){let f=a*t.at[h],p=a*t.at[h+1],y=l*t.at[h+2],m=t.normal[h]/a,g=t.normal[h+1]/a,x=t.normal[h+2]/l;for(let w=0;w<3;w++)this.at[d+w]=i[w]+s[w]*f+r[w]*p+o[w]*y,this.normal[d+w]=s[w]*m+r[w]*g+o[w]*x}this.paint.fill(e,c,u);for(let h=0;h<t.index.length;h++)this.index[this.indices+h]=c+t.index[h];this.corners=u,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},Uy=[1,0,0],EC=[0,1,0],Fy=[0,0,1];function TC(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:du(n,Math.abs(n[2])<.9?Fy:Uy),i=du(n,e),s=rs(i)||1,r=i.map(o=>o/s);return[du(r,n),r]}var qm=0,Pd=1,$m=2,Ny=3,Xa=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new Fn,this.veil=i,this.moving=!1,this.arms=[],this.body=new Id(t),this.group.add(this.body.mesh),e&&(this.flat=new Id(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?Dy:Wm:this.moving?Wm:wC;for(let i of t)this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of t)this.#t(this.flat,i,this.moving?Dy():Wm(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,u,h,d,f,p,y)=>t.put(c,u,h,...TC(d,y),d,f,p),l=(c,u,h)=>t.put(i.ball,c,u,Uy,EC,Fy,h,h);for(let{a:c,b:u,r:h}of e.rods){let d=Ii(u,c),f=rs(d),p=[(c[0]+u[0])/2,(c[1]+u[1])/2,(c[2]+u[2])/2];a(i.rod,qm,p,d.map(y=>y/f),r*h,f)}for(let{at:c,r:u}of e.balls)l(qm,c,r*u);for(let{at:c,dir:u,turned:h,r:d,h:f,beyond:p}of e.drums){if(a(i.drum,p&&o?Ny:Pd,c,u,r*d,r*f),!o)continue;a(i.rod,$m,c,u,d*1.012,f*.13);let y=[0,1,2].map(m=>c[m]+h[m]*d*.96);a(i.box,qm,y,u,d*.11,f*.86,h)}for(let{at:c,dir:u,x:h,r:d,h:f,beyond:p}of e.sleeves)a(i.box,p&&o?Ny:Pd,c,u,r*d,r*f,h);if(e.pedestal&&!this.veil){let{at:c,dir:u,r:h,h:d}=e.pedestal;a(i.drum,Pd,[c[0]+u[0]*d/2,c[1]+u[1]*d/2,c[2]+u[2]*d/2],u,h,d)}if(e.flange&&a(i.drum,Pd,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:c,dir:u,turned:h,r:d,h:f}=e.flange;a(i.box,$m,[0,1,2].map(p=>c[p]+h[p]*d*.95),u,d*.16,f*1.04,h)}e.tip&&o&&l($m,e.tip.at,e.tip.r)}};var AC=`
  attribute float paint;
  uniform vec3 colours[4];
  varying vec3 vNormal;
  varying vec3 vToEye;
  varying vec3 vColour;
  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    vNormal = normalize(normal);
    vToEye = cameraPosition - world.xyz;
    vColour = paint < 0.5 ? colours[0] : paint < 1.5 ? colours[1] : paint < 2.5 ? colours[2] : colours[3];
    gl_Position = projectionMatrix * viewMatrix * world;
  }`,RC=`
  uniform float opacity;
  uniform vec3 sky;
  uniform vec3 ground;
  uniform float gloss;
  varying vec3 vNormal;
  varying vec3 vToEye;
  varying vec3 vColour;
  const vec3 SUN = vec3(0.332, -0.443, 0.831);
  const vec3 FILL = vec3(-0.788, 0.394, 0.473);
  void main() {
    vec3 n = normalize(vNormal), e = normalize(vToEye);
    float sun = max(dot(n, SUN), 0.0), fill = max(dot(n, FILL), 0.0);
    vec3 light = mix(ground, sky, 0.5 + 0.5 * n.z) + 0.62 * sun + 0.2 * fill;
    float shine = gloss * pow(max(dot(n, normalize(SUN + e)), 0.0), 28.0);
    gl_FragColor = vec4(vColour * light + shine, opacity);
    #include <colorspace_fragment>
  }`,CC=`
  uniform vec3 colours[4];
  uniform vec3 sky;
  uniform vec3 ground;
  varying vec3 vColour;
  const vec3 SUN = vec3(0.332, -0.443, 0.831);
  void main() {
    vec3 n = normalize(normal);
    vec3 linear = colours[0] * (mix(ground, sky, 0.5 + 0.5 * n.z) + 0.75 * max(dot(n, SUN), 0.0));
    vColour = pow(linear, vec3(1.0 / 2.2));
    gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
  }`,PC=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Ld({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new cs({vertexShader:e?CC:AC,fragmentShader:e?PC:RC,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ie)},opacity:{value:n},gloss:{value:t},sky:{value:new ie(.46,.46,.47)},ground:{value:new ie(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function Ym(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Ae;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,u),c+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=Oy(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let y=0;y<o[u].length;++y)f.push(o[u][y][d]);let p=Oy(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(p)}}}return l}function Oy(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new Je(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let y=u.getComponent(d,p);a.setComponent(d+h,p,y)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var Rr=["#d8343f","#1b9a50","#2f6fe0"];function Zm(n,t){let e=new ji(.028,.028,.82,8).translate(0,.41,0),i=new To(.085,.22,12).translate(0,.9,0),s=Ym([e,i]).applyMatrix4(t),r=new ie(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new Je(o,3)),s}var jm=n=>new _e().makeRotationFromQuaternion(new cn().setFromUnitVectors(new H(0,1,0),new H(...n))),IC=Ym([Zm(Rr[0],jm([1,0,0])),Zm(Rr[1],jm([0,1,0])),Zm(Rr[2],jm([0,0,1]))]),By=.021,Ic=new Map;function LC(n){let t=`${n}/${zt.dark}`;if(Ic.has(t))return Ic.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=zt.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=zt.ink,s.fillText(n,e.width/2,e.height/2);let o=new oc(e);o.colorSpace=bi;let a=new Na({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,Ic.set(t,a),a}var Ya=class{constructor(){this.group=new Fn,this.mesh=new sc(IC,new si({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new _e;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new H(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new nc);a.parent||this.group.add(a),a.material=LC(r),a.scale.set(By*a.material.userData.aspect,By,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of Ic.values())t.map.dispose(),t.dispose();Ic.clear(),this.last&&this.show(...this.last)}};var Km=180/Math.PI,Oi={angle:"deg",length:"mm"},DC={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},Jm={deg:Km,rad:1,mm:1e3,m:1},NC={deg:2,rad:4,mm:2,m:5},UC={deg:1,rad:.02,mm:5,m:.005},_t={get angle(){return Oi.angle},get length(){return Oi.length},set(n,t){t in Jm&&n in Oi&&(Oi[n]=t)},factor:n=>n in Oi?Jm[Oi[n]]:1,symbol:n=>n in Oi?DC[Oi[n]]:"",digits:n=>n in Oi?NC[Oi[n]]:4,step:n=>n in Oi?UC[Oi[n]]/Jm[Oi[n]]:.01,suffix:n=>n==="angle"?{deg:Km,"\xB0":Km,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function Qn(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var gn=(n,t,e=_t.digits(t))=>Qn(n*_t.factor(t),e),ue=(n,t,e)=>`${gn(n,t,e)}${t==="angle"&&Oi.angle==="deg"?"":" "}${_t.symbol(t)}`,Lc=(n,t="plain")=>String(Number((n*_t.factor(t)).toPrecision(9))+0),Dd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function Za(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||_t.digits(t))/_t.factor(t)}var FC={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},OC={theta:(n,t,e)=>`turn by \u03B8${n} = ${ue(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${ue(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${ue(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${ue(t,"angle")} about x`};function ky(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=FC[n.convention],o=hr(n.joints[i],dr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:K0(n.convention,a.a,a.alpha,a.d,a.theta)}}function zy(){let n=v("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>v("button",{type:"button",text:o,"aria-label":a,on:{click:()=>i(l())}}),e=()=>4*M.table.joints.length-1,i=o=>{M.dhStep=o===null||o<0?null:Math.min(o,e()),r(),dt("frames")},s=v("details",{class:"fold","data-testid":"dh-steps"},v("summary",{text:"The frames, one step at a time"}),v("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(M.dhStep??1)-1),t("On","One step on",()=>(M.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(M.dhStep===null||!M.table.joints.length){M.dhStep=null,gt(n,"");return}M.dhStep=Math.min(M.dhStep,e());let{i:o,key:a,value:l}=ky(M.table,M.q,M.dhStep),c=M.table.convention==="standard"?o:o+1;gt(n,`Joint ${o+1}, ${M.dhStep%4+1} of 4: ${OC[a](o+1,l,c)}`)};return st(["q","table","units"],()=>M.dhStep!==null&&r()),st("panel",o=>{o!=="table"&&M.dhStep!==null&&(s.open=!1,i(null))}),s}function Nd(){let{i:n,A:t}=ky(M.table,M.q,M.dhStep);return[...M.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:ni(M.frames[n],t),name:`\u2192 ${n+1}`}]}var Qm=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],ja=n=>[Math.cos(n),Math.sin(n)];function BC([n,t,e]){let[i,s]=ja(e),[r,o]=ja(t),[a,l]=ja(n);return Qm([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function kC(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function zC([n,t,e]){let[i,s]=ja(n),[r,o]=ja(t),[a,l]=ja(e);return Qm([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function HC(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Ud(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function Dc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return Qm([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function GC(n){let[t,e,i,s]=Ud(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function VC([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:Dc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Rs={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:kC,from:BC},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:HC,from:zC},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:GC,from:VC},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Ud,from:Dc}};function Hy(n,t,e){let i=Rs[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Fd(n,t,e){let i=Ud(n),s=Ud(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=Dc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var Ja=.145,kd=.105,ag=.165,Gy={mouse:13,pen:16,touch:28},WC=.2,ao=["x","y","z"],Uc=72,No=new Fn,Bd=new Map,ig="both",zd="local",lg=0,Cr=!1,sg=null,Ke=null,Hd=()=>Ke!==null,Xy=()=>Cr,ro=null,oo=null;function Yy(){No.visible=!1,yn.add(No),wy(cg),oo=document.getElementById("view"),ro=v("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(ro),oo.addEventListener("pointerdown",JC,!0),oo.addEventListener("pointermove",QC,!0);for(let n of["pointerup","pointercancel"])oo.addEventListener(n,nv,!0);addEventListener("keydown",n=>n.key==="Escape"&&Ke&&eP()),st(["target","theme"],Ee)}function Nc(n,t,e=8){let i=new si({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new mn(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var qC=[new cn().setFromUnitVectors(new H(0,1,0),new H(1,0,0)),new cn,new cn().setFromUnitVectors(new H(0,1,0),new H(0,0,1))],$C=[new cn().setFromUnitVectors(new H(0,0,1),new H(1,0,0)),new cn().setFromUnitVectors(new H(0,0,1),new H(0,1,0)),new cn];function XC(){if(Bd.size)return;let n=(t,e)=>{Bd.set(t,e),No.add(e)};ao.forEach((t,e)=>{let i=new ji(.0032,.0032,Ja*.8,8).translate(0,Ja*.45,0),s=new To(.0125,.034,14).translate(0,Ja*.9,0),r=new Fn;r.add(Nc(i,Rr[e]),Nc(s,Rr[e])),r.userData.turn=qC[e],n(`move-${t}`,r);let o=Nc(new Fa(kd,.0026,6,Uc),Rr[e],7);o.userData.turn=$C[e],n(`turn-${t}`,o)}),n("turn-view",Nc(new Fa(ag,.0022,6,Uc),"#8891a0",7)),n("move-view",Nc(new wr(.0115,14,10),"#8891a0",9))}var Od=new H,lo=new H,tg=new cn;function Gd(){return 2*Math.tan(so.degToRad(Be.fov/2))*Be.position.distanceTo(Od)}var Oc=()=>zd==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):YC(),YC=()=>[0,1,2].map(n=>Gs(M.target,n)),ZC=new _e;function cg(){if(No.visible=Cr,!Cr)return;Od.set(...te(M.target)),lo.copy(Be.position).sub(Od).normalize(),zd==="world"?tg.identity():tg.setFromRotationMatrix(ZC.set(...M.target)),No.position.copy(Od),No.scale.setScalar(Gd());let n=Oc();for(let[t,e]of Bd){let[i,s]=t.split("-"),r=ao.indexOf(s),o=ig==="both"||ig===i;e.visible=o&&jC(i,n[r])&&(!Ke||Ke.name===t),s==="view"?e.quaternion.copy(Be.quaternion):e.quaternion.copy(tg).multiply(e.userData.turn);let a=t===(Ke?.name??sg);e.traverse(l=>l.material?.color.set(a?zt.accent:l.userData.colour))}}function jC(n,t){return!t||n!=="move"?!0:Math.hypot(...Zy(t,lo.toArray()))>WC}var Zy=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Fc=(n,t)=>te(M.target).map((e,i)=>e+t*n[i]);function rg(n,t){let e=Oc(),[i,s]=n<0?[Vy(Be.matrixWorld,0),Vy(Be.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Uc+1},(r,o)=>{let a=2*Math.PI*o/Uc,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:Fc(l,t),front:n<0||l.reduce((c,u,h)=>c+u*lo.getComponent(h),0)>-.15}})}var Vy=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function Wy(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function og(n,t){let e=Gd(),i=[];for(let[s,r]of Bd){if(!r.visible)continue;let[o,a]=s.split("-"),l=ao.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=Fi(te(M.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=Oc()[l],h=Fi(Fc(u,.92*Ja*e));c=Math.min(Wy(n,t,Fi(Fc(u,.3*Ja*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=rg(l,(l<0?ag:kd)*e).map(h=>({...h,s:Fi(h.p)}));for(let h=0;h<Uc;h++)u[h].front&&(c=Math.min(c,Wy(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function jy(n){if(!Cr)return null;cg();let[t]=og(n.clientX,n.clientY);return t&&t[1]<=(Gy[n.pointerType]??Gy.mouse)?t[0]:null}function Jy(){if(!Cr)return{};cg();let n=Gd(),t=Oc(),e={"move-view":Fi(te(M.target))};return ao.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>Fi(Fc(t[s],c*Ja*n))).find(([c,u])=>og(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=rg(s,kd*n).filter(c=>c.front).map(c=>Fi(c.p)).filter(([c,u])=>og(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=Fi(rg(-1,ag*n)[9].p),e}var qy=new mc,$y=new Xt;function Ky(n){let t=Qi.domElement.getBoundingClientRect();return $y.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),qy.setFromCamera($y,Be),qy.ray}function Qy(n,t,e){let{origin:i,direction:s}=Ky(e),r=new H(...n),o=new H(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function tv(n,t,e){let i=new ii().setFromNormalAndCoplanarPoint(n,new H(...t));return Ky(e).intersectPlane(i,new H)}function JC(n){if(n.button!==0)return;let t=jy(n);if(!t)return;n.stopPropagation(),n.preventDefault(),oo.focus({preventScroll:!0}),oo.setPointerCapture(n.pointerId),En.enabled=!1;let[e,i]=t.split("-"),s=ao.indexOf(i),r=s<0?lo.toArray():Oc()[s].slice();Ke={name:t,what:e,axis:r,i:s,T:M.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},Ke.start=e==="turn"?ev(n):s<0?tv(lo,te(Ke.T),n):Qy(r,te(Ke.T),n),Ee()}function ev(n){let[t,e]=Fi(te(Ke.T)),i=Ke.axis.reduce((h,d,f)=>h+d*lo.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Zy(Ke.axis,lo.toArray()),r=Gd(),o=Fi(te(Ke.T)),a=Fi(Fc(s,kd*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-Ke.x)*l+(n.clientY-Ke.y)*c)/(u*u)}var KC=n=>Math.atan2(Math.sin(n),Math.cos(n)),eg=(n,t,e)=>{let i=lg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function QC(n){if(!Ke){if(n.buttons||!Cr)return;let l=jy(n);l!==sg&&(sg=l,oo.style.setProperty("cursor",l?"grab":""),Ee());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=Ke,r=zd==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=ev(n);Ke.total+=KC(l-(Ke.before??Ke.start)),Ke.before=l;let c=eg(Ke.total,n,Math.PI/180),u=Math.sin(c/2);o=ni(Dc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${ng(c,"angle")} about ${s<0?"the line of sight":r+ao[s]}`}else if(s<0){let l=tv(lo,te(t),n);if(!l)return;let c=l.sub(Ke.start);(lg||n.shiftKey)&&c.set(...c.toArray().map(u=>eg(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${ao[h]} ${ng(u,"length")}`).join(", ")}else{let l=eg(Qy(e,te(t),n)-Ke.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${ng(l,"length")} along ${r}${ao[s]}`}xi(o,"drag"),tP(a,n),Ee()}var ng=(n,t)=>`${n>=0?"+":""}${ue(n,t,_t.digits(t))}`;function tP(n,t){let e=oo.getBoundingClientRect();ro.hidden=!1,gt(ro,n),ro.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-ro.offsetWidth-8)}px`),ro.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function nv(n){Ke&&(n.stopPropagation(),Ke=null,ro.hidden=!0,En.enabled=!0,xi(M.target,"dropped"),Ee())}function eP(){let{T:n}=Ke;xi(n,"drag"),nv({stopPropagation(){}})}function iv(){Cr&&XC(),No.visible=Cr,dt("frames"),Ee()}function sv(n){Cr=n,iv()}function rv(n){ig=n,iv()}function ov(n){zd=n,Ee()}function av(n){lg=n}var dv=Ld(),cv=[.32,-.4,1],fv=new si({color:"#000",transparent:!0,opacity:.1,side:Ni,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:om,stencilRef:1,stencilZPass:rm,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),nP=new _e().set(1,0,-cv[0],0,0,1,-cv[1],0,0,0,0,5e-4,0,0,0,1),qd=new Xa(dv,{shadow:{material:fv,matrix:nP}}),pv=Ld({opacity:.2,veil:!0}),Vd=new Xa(pv,{veil:!0}),mv=Ld({opacity:.62,gloss:.1}),hg=new Xa(mv,{veil:!0}),Xd=new Ya,Uo=Cd(M.table),Yd=[],$d=null;function gv(){yn.add(qd.group,Vd.group,hg.group,Xd.group),Vd.group.renderOrder=1,st("table",n=>{Uo=Cd(M.table),zm(Uo.size),Yd=[],$d=null,dg(),jd(),n==="new"&&zc({instant:!0,view:"iso"}),Ey()}),st("q",sP),st("frames",yv),st("theme",hv),st("hurry",n=>{for(let t of[qd,Vd,hg])t.hurry(n)}),hv()}var uv=new Map,kc=[],ug=0;function Ir(n,t){if(uv.set(n,t),kc=[...uv.values()].flat(),!M.table.joints.length)return;let e=ug;ug=kc.length,Bm([...Pc(M.table,M.frames),...kc]),t.length?xv():e>ug&&iP()}var iP=$s(Py,120);function _v(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Ir("motion",i.flatMap(s=>Pc(n,ys(n,s))))}function zc(n){Ad([...Pc(M.table,M.frames),...kc],n)}var xv=$s($a,220);function sP(){let n=M.frames;qd.show(M.table.joints.length?[Gm(M.table,n,Uo,M.q)]:[]),Bm([...Pc(M.table,n),...kc]),xv(),Ev&&rP(te(n[n.length-1])),yv()}function yv(){let n=(M.shownFrames??[]).filter(t=>t<M.frames.length&&!(t===M.frames.length-1&&Xy())).map(t=>({T:M.frames[t],name:Zd(t)}));Xd.show(M.dhStep===null?n:Nd(),Uo.size*.13),Ee()}var vv=()=>qd.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),bv=()=>(Xd.last?.[0]??[]).map(n=>n.name);function Zd(n){let t=M.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function Mv(n){Yd=n,dg()}function ds(n){$d=n,dg()}var Sv=()=>Yd.length;function dg(){let n=t=>Gm(M.table,ys(M.table,t),Uo);Vd.show(Yd.map(n)),hg.show($d?[n($d)]:[]),Ee()}var wv=6e3,Wd=new Float32Array(6*wv),Pr=new Eo(new Ae,new Zi({fog:!1}));Pr.geometry.setAttribute("position",new Je(Wd,3));Pr.frustumCulled=!1;Pr.visible=!1;var co=0,Ev=!0,Bc=null;yn.add(Pr);function rP(n){let t=Bc?rs(Ii(n,Bc)):1/0;t<Uo.size*.002||(t<Uo.size*.2&&(co===wv&&(Wd.copyWithin(0,6*1e3),co-=1e3),Wd.set(Bc,6*co),Wd.set(n,6*co+3),co+=1,Pr.geometry.setDrawRange(0,2*co),Pr.geometry.attributes.position.needsUpdate=!0,Pr.visible=!0),Bc=n)}function Tv(n){Ev=n,n||jd(),Ee()}function jd(){co=0,Bc=null,Pr.visible=!1,Ee()}var Av=()=>co,Hc=new Js(new Ae,new Zi({fog:!1}));Hc.frustumCulled=!1;var Gc=new Mr(new Ae,new Ks({size:4,sizeAttenuation:!1,fog:!1}));Gc.frustumCulled=!1;Hc.visible=Gc.visible=!1;yn.add(Hc,Gc);function Fo(n){Ir("path",n);let t=new Float32Array(n.flat());for(let e of[Hc,Gc])e.geometry.dispose(),e.geometry=new Ae,e.geometry.setAttribute("position",new Je(t,3)),e.visible=n.length>0;Ee()}function hv(){dv.repaint(zt.link,zt.joint,zt.accent,zt.dark,zt.wrong),pv.repaint(zt.ghost,zt.ghost,zt.ghost,zt.dark),mv.repaint(zt.accent,zt.accent,zt.accent,zt.dark),Pr.material.color.set(zt.accent),Hc.material.color.set(zt.trace),Gc.material.color.set(zt.trace),fv.opacity=zt.dark?.28:.11,Xd.paint(),Ee()}var he={follow:!0,ghosts:"all",task:null,redundancy:null},fg={answers:0},Jd=!1,Rv=Vs(async()=>{let n=Jd;Jd=!1;let t=M.target,e=M.table;try{let i=Hd()||pg,s=i?null:M.digits,{task:r,redundancy:o}=he,a=await ze("ik",{T:t,q:M.q,brief:i,task:r,redundancy:o,digits:s});if(e!==M.table||t!==M.target&&!i)return;fg.answers+=1,M.solutions={...a,T:t,brief:i},n&&he.follow&&a.nearest&&Li(a.nearest,"follow"),Ka(),dt("solutions"),!i&&!a.rows.some(l=>l.inside)&&lP(t),a.self_motions===null&&!i&&aP(M.solutions)}catch(i){if(i instanceof _u)return;M.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},Ka(),dt("solutions")}}),pg=!1;function Cv(){pg=!0,Jd=!0,Rv()}function Cs({follow:n=!1}={}){pg=!1,Jd||=n,Rv()}var aP=Vs(async n=>{try{let t={T:n.T,q:M.q,task:he.task,redundancy:he.redundancy},{self_motions:e}=await ze("self_motions",t);if(M.solutions!==n||!e)return;n.self_motions=e,dt("solutions")}catch{}}),lP=Vs(async n=>{try{let t=await ze("nearest",{T:n,task:he.task});M.solutions&&M.solutions.T===n&&(M.solutions.near=t,dt("solutions"))}catch{}}),cP=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function Ka(){let n=M.solutions?.rows??[],t=M.panel==="inverse"&&he.ghosts!=="none"?n.filter(e=>(he.ghosts==="all"||e.inside)&&!cP(e.q,M.q)):[];Mv(t.map(e=>e.q))}function Pv(){st("target",n=>{M.panel==="inverse"&&Cs({follow:i_.has(n)})}),st("task",()=>{dt("plan"),M.panel==="inverse"&&M.hasTarget&&Cs()}),st("panel",n=>{ds(null),n==="inverse"&&M.hasTarget&&!M.solutions&&Cs(),Ka()}),st("moving",n=>{n||Ka()}),st("table",n=>{he.redundancy=null,n==="new"&&(he.task=null),dt("solutions"),n!=="new"&&M.panel==="inverse"&&M.hasTarget&&Cs()}),st("online",n=>{n&&M.panel==="inverse"&&M.hasTarget&&M.table.joints.length&&Cs()})}var Vc=0;function hi(){Vc+=1,M.moving&&(M.moving=!1,dt("moving",!1))}function Ai(n,t=.8,e="move to a posture"){hi(),dt("let-go"),dt("did",{label:e});let i=M.q.slice(),s=Vc,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),M.moving=!0,dt("moving",!0),new Promise(o=>{(function a(l){if(s!==Vc||i.length!==M.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Li(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(M.moving=!1,dt("moving",!1),o(!0))})(r)})}function Iv(n,t,e,i){hi();let s=Vc,r=performance.now()-1e3*n*t;M.moving=!0,dt("moving",!0),requestAnimationFrame(function o(a){if(s!==Vc){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(M.moving=!1,dt("moving",!1),i?.(!0))})}var hP=200,dP=1500,Oo=[],$c=[],qc=null,Wc={key:null,at:0,open:!1},mg=!1,Kd=()=>({table:M.table,q:M.q,target:M.target,digits:M.digits,hasTarget:M.hasTarget,path:{...M.path},sequence:structuredClone(M.sequence),program:M.program,world:M.world,limits:M.limits,start:M.start,routing:M.routing,task:he.task,redundancy:he.redundancy});function gg(){mg||(mg=!0,queueMicrotask(()=>{mg=!1,qc=Kd()}))}function fP({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===Wc.key&&(Wc.open||i-Wc.at<dP))&&qc&&(Oo.push({label:n,before:qc}),Oo.length>hP&&Oo.shift(),$c.length=0),Wc={key:t,at:i,open:e},gg(),dt("history")}function _g(){Wc={key:null,at:0,open:!1}}function pP(n){hi(),_g(),he.task=n.task,n.table!==M.table?fn(n.table,{q:n.q,step:!1,what:"undo"}):Li(n.q,"undo"),he.redundancy=n.redundancy,Object.assign(M.path,n.path),M.sequence=structuredClone(n.sequence),M.program=n.program,M.world=n.world,M.limits=n.limits,M.start=n.start;let t=M.routing!==n.routing;M.routing=n.routing,M.hasTarget=n.hasTarget,n.target!==M.target&&xi(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])dt(e,"undo");t&&dt("routing","undo")}function Lv(n,t,e){let i=n.pop();if(!i)return;let s=Kd();pP(i.before),t.push({label:i.label,before:s}),gg(),dt("history"),Fe(`${e}: ${i.label}`)}var xg=()=>Lv(Oo,$c,"Undone"),yg=()=>Lv($c,Oo,"Redone"),Qd=()=>Oo.at(-1)?.label??null,tf=()=>$c.at(-1)?.label??null;function ef(){Oo.length=0,$c.length=0,_g(),qc=Kd(),dt("history")}function Dv(){qc=Kd(),st("did",fP),st("let-go",_g),st(["table","q","target","path","sequence","program","world","task","routing"],gg)}var Fv=1,Ov=30;function nf(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=M;return{pieper:Fv,table:n,q:t,target:i?e:null,digits:M.digits,task:he.task,redundancy:he.redundancy,follow:he.follow,ghosts:he.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:M.program,start:M.start,limits:M.limits},world:M.world,routing:M.routing,panel:l,theme:c,units:[_t.angle,_t.length],camera:Rd()}}var ti=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,Ps=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(ti),fs=(n,t)=>typeof n=="string"?n.slice(0,t):"",Lr=n=>{if(!Ps(n,16))return null;let t=fu(n);return t<1e-12?n.slice():t<.001?pu(n):null},gP=n=>n&&ti(n.metres)&&ti(n.radians)?{metres:n.metres,radians:n.radians}:null,_P=n=>n&&[n.lower,n.upper,n.value].every(ti)&&n.lower<=n.upper?{name:fs(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:fs(n.unit,10)}:null,xP=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>Ps(e,t))?n:null;function yP(n){if(!n||!Array.isArray(n.joints)||n.joints.length>Ov||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>ti(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:fs(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:ti(i.lower)?i.lower:null,upper:ti(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>Ps(i,t.length)).slice(0,40));return{name:fs(n.name,60),convention:n.convention,joints:t,base:Lr(n.base)??ur(),tool:Lr(n.tool)??ur(),postures:e,manufacturer:fs(n.manufacturer,200),source:fs(n.source,2e3),notes:fs(n.notes,3e3),actuator:_P(n.actuator),catalog:fs(n.catalog,60)||void 0,derived:fs(n.derived,60)||void 0,coupling:xP(n.coupling,t.length)}}var Nv={joint:0,line:0,circle:0,wait:"seconds",gripper:"value",output:"port"};function vP(n,t){if(!n||!Object.hasOwn(Nv,n.kind))return null;let e=Nv[n.kind];if(e)return ti(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;let i=n.kind==="joint"&&Ps(n.q,t)?n.q.slice():null,s=Lr(n.T);if(!s||n.kind==="circle"&&!Lr(n.via))return null;let r=(o,a)=>a===null?{}:{[o]:a};return{kind:n.kind,...r("q",i),T:s,...r("via",Lr(n.via)),...r("speed",ti(n.speed)&&n.speed>0?n.speed:null),blend:ti(n.blend)&&n.blend>=0?n.blend:0}}var vg={frame:[],box:["size"],cylinder:["r","h"]};function bP(n){if(!n||!Object.hasOwn(vg,n.kind))return null;let t=Lr(n.T),e=fs(n.name,40),i=s=>s==="size"?Ps(n.size,3)&&n.size.every(r=>r>0):ti(n[s])&&n[s]>0;return!t||!e||!vg[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(vg[n.kind].map(s=>[s,n[s]]))}}function MP(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&ti(s.turn)&&Ps(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:fs(s.branch,80)}:null,i=(s,r)=>ti(s)&&s>=0&&s<r?s:0;return{turn:Ps(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function SP(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};M.program=e(i.steps,s=>vP(s,t),200),M.start=Ps(i.start,t)?i.start.slice():null,M.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||ti(r)&&r>0))),M.world=e(n.world,bP,60),M.routing=MP(n.routing,t)}function sf(n,t){let e=n&&n.pieper===Fv?yP(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(_t.set("angle",n.units[0]),_t.set("length",n.units[1])),Object.hasOwn(Rs,n.notation)&&(M.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Md(n.theme),M.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};fn(e,{q:Ps(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(M.path,{from:Lr(s.from),to:Lr(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:ti(s.seconds)&&s.seconds>0?s.seconds:5}),M.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&Ps(a.q,i)&&ti(a.seconds)&&ti(a.hold)).slice(0,40).map(a=>({name:fs(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),SP(n,i),["pose","position","position+axis"].includes(n.task)&&(he.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&ti(l));he.redundancy=r.length?Object.fromEntries(r.slice(0,Ov)):null,typeof n.follow=="boolean"&&(he.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(he.ghosts=n.ghosts);let o=Lr(n.target);M.hasTarget=!!o,o&&xi(o,"restored",gP(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])dt(a);t(n.panel),dt("path-loaded"),dt("routing","loaded"),Ps(n.camera,6)&&Iy(n.camera),Li(M.q,"restored"),ef()}async function Bv(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function rf(){let n=await Bv(new TextEncoder().encode(JSON.stringify(nf())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function kv(){let n=wP();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await Bv(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var zv="pieper-workbench";function wP(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(zv)??"{}");return t&&n===location.href?t:null}catch{return null}}function EP(){if(M.table.joints.length)try{sessionStorage.setItem(zv,JSON.stringify({address:location.href,shown:nf()}))}catch{}}var Uv=null,TP=$s(async()=>{if(!M.table.joints.length)return;let n=await rf();n!==Uv&&(Uv=n,history.replaceState(null,"",n))},600);function Hv(){addEventListener("pagehide",EP),st(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","theme","frames"],TP)}var RP="uplot",CP="u-hz",PP="u-vt",IP="u-title",LP="u-wrap",DP="u-under",NP="u-over",UP="u-axis",zo="u-off",FP="u-select",OP="u-cursor-x",BP="u-cursor-y",kP="u-cursor-pt",zP="u-legend",HP="u-live",GP="u-inline",VP="u-series",WP="u-marker",Gv="u-label",qP="u-value",Yc="width",Zc="height";var Vv="bottom",Qa="left",bg="right",Bg="#000",Wv=Bg+"0",Mg="mousemove",qv="mousedown",Sg="mouseup",$v="mouseenter",Xv="mouseleave",Yv="dblclick",$P="resize",XP="scroll",Zv="change",uf="dppxchange",kg="--",ol=typeof window<"u",Rg=ol?document:null,el=ol?window:null,YP=ol?navigator:null,ke,of;function Cg(){let n=devicePixelRatio;ke!=n&&(ke=n,of&&Ig(Zv,of,Cg),of=matchMedia(`(min-resolution: ${ke-.001}dppx) and (max-resolution: ${ke+.001}dppx)`),Ho(Zv,of,Cg),el.dispatchEvent(new CustomEvent(uf)))}function ts(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Pg(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function un(n,t,e){n.style[t]=e+"px"}function Is(n,t,e,i){let s=Rg.createElement(n);return t!=null&&ts(s,t),e?.insertBefore(s,i),s}function ps(n,t){return Is("div",n,t)}var jv=new WeakMap;function ir(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=jv.get(n);r!=o&&(n.style.transform=r,jv.set(n,r),t<0||e<0||t>i||e>s?ts(n,zo):Pg(n,zo))}var Jv=new WeakMap;function Kv(n,t,e){let i=t+e,s=Jv.get(n);i!=s&&(Jv.set(n,i),n.style.background=t,n.style.borderColor=e)}var Qv=new WeakMap;function tb(n,t,e,i){let s=t+""+e,r=Qv.get(n);s!=r&&(Qv.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var zg={passive:!0},ZP={...zg,capture:!0};function Ho(n,t,e,i){t.addEventListener(n,e,i?ZP:zg)}function Ig(n,t,e,i){t.removeEventListener(n,e,zg)}ol&&Cg();function Ls(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:es((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Rb(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Cb=n=>n!=null,Pb=n=>n!=null&&n>0,ff=Rb(Cb),jP=Rb(Pb);function JP(n,t,e,i=0,s=!1){let r=s?jP:ff,o=s?Pb:Cb;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Qe,l??-Qe]}function pf(n,t,e,i){let s=ib(n),r=ib(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Dr:Ib,a=s==1?es:ms,l=r==1?ms:es,c=a(o(Wn(n))),u=l(o(Wn(t))),h=nl(e,c),d=nl(e,u);return e==10&&(c<0&&(h=tn(h,-c)),u<0&&(d=tn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=Ub(n,h),t=mf(t,d)),[n,t]}function Hg(n,t,e,i){let s=pf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Gg=.1,eb={mode:3,pad:Gg},Jc={pad:0,soft:null,mode:0},KP={min:Jc,max:Jc};function hf(n,t,e,i){return gf(e)?nb(n,t,e):(Jc.pad=e,Jc.soft=i?0:null,Jc.mode=i?3:0,nb(n,t,KP))}function Ne(n,t){return n??t}function QP(n,t,e){for(t=Ne(t,0),e=Ne(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function nb(n,t,e){let i=e.min,s=e.max,r=Ne(i.pad,0),o=Ne(s.pad,0),a=Ne(i.hard,-Qe),l=Ne(s.hard,Qe),c=Ne(i.soft,Qe),u=Ne(s.soft,-Qe),h=Ne(i.mode,0),d=Ne(s.mode,0),f=t-n,p=Dr(f),y=Ri(Wn(n),Wn(t)),m=Dr(y),g=Wn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Qe&&(r=0),d==2&&u!=-Qe&&(o=0)));let x=f||y||1e3,w=Dr(x),b=nl(10,es(w)),A=x*(f==0?n==0?.1:1:r),T=tn(Ub(n-A,b/10),24),_=n>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:Qe,S=Ri(a,T<_&&n>=_?_:Ds(_,T)),D=x*(f==0?t==0?.1:1:o),L=tn(mf(t+D,b/10),24),N=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Qe,z=Ds(l,L>N&&t<=N?N:Ri(N,L));return S==z&&S==0&&(z=100),[S,z]}var tI=new Intl.NumberFormat(ol?YP.language:"en-US"),Vg=n=>tI.format(n),ns=Math,cf=ns.PI,Wn=ns.abs,es=ns.floor,Vn=ns.round,ms=ns.ceil,Ds=ns.min,Ri=ns.max,nl=ns.pow,ib=ns.sign,Dr=ns.log10,Ib=ns.log2,eI=(n,t=1)=>ns.sinh(n)*t,wg=(n,t=1)=>ns.asinh(n/t),Qe=1/0;function sb(n){return(Dr((n^n>>31)-(n>>31))|0)+1}function Lg(n,t,e){return Ds(Ri(n,t),e)}function Lb(n){return typeof n=="function"}function Ie(n){return Lb(n)?n:()=>n}var nI=()=>{},Db=n=>n,Nb=(n,t)=>t,iI=n=>null,rb=n=>!0,ob=(n,t)=>n==t,sI=/\.\d*?(?=9{6,}|0{6,})/gm,Go=n=>{if(Ob(n)||ho.has(n))return n;let t=`${n}`,e=t.match(sI);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Go(s)}e${r}`}return tn(n,i)};function Bo(n,t){return Go(tn(Go(n/t))*t)}function mf(n,t){return Go(ms(Go(n/t))*t)}function Ub(n,t){return Go(es(Go(n/t))*t)}function tn(n,t=0){if(Ob(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Vn(i)/e}var ho=new Map;function Fb(n){return((""+n).split(".")[1]||"").length}function Qc(n,t,e,i){let s=[],r=i.map(Fb);for(let o=t;o<e;o++){let a=Wn(o),l=tn(nl(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:tn(u,h);s.push(d),ho.set(d,h)}}return s}var Kc={},Wg=[],il=[null,null],uo=Array.isArray,Ob=Number.isInteger,rI=n=>n===void 0;function ab(n){return typeof n=="string"}function gf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function oI(n){return n!=null&&typeof n=="object"}var aI=Object.getPrototypeOf(Uint8Array),Bb="__proto__";function sl(n,t=gf){let e;if(uo(n)){let i=n.find(s=>s!=null);if(uo(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=sl(n[s],t)}else e=n.slice()}else if(n instanceof aI)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Bb&&(e[i]=sl(n[i],t))}else e=n;return e}function On(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Bb&&(gf(n[s])?On(n[s],sl(i[s])):n[s]=sl(i[s]))}return n}var lI=0,cI=1,uI=2;function hI(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function dI(n,t){if(mI(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return gI(o[0])||(o=pI(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:cI,f=[];for(let p=0;p<u.length;p++){let y=u[p],m=r.get(l[p]);y===null?d!=lI&&(h[m]=y,d==uI&&f.push(m)):h[m]=y}hI(h,f,s),i.push(h)}}return i}var fI=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function pI(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function mI(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function gI(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Ri(1,es((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var kb=["January","February","March","April","May","June","July","August","September","October","November","December"],zb=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Hb(n){return n.slice(0,3)}var _I=zb.map(Hb),xI=kb.map(Hb),yI={MMMM:kb,MMM:xI,WWWW:zb,WWW:_I};function Xc(n){return(n<10?"0":"")+n}function vI(n){return(n<10?"00":n<100?"0":"")+n}var bI={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Xc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Xc(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Xc(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Xc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Xc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>vI(n.getMilliseconds())};function qg(n,t){t=t||yI;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?bI[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var MI=new Intl.DateTimeFormat().resolvedOptions().timeZone;function SI(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==MI?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Gb=n=>n%1==0,df=[1,2,2.5,5],wI=Qc(10,-32,0,df),Vb=Qc(10,0,32,df),EI=Vb.filter(Gb),ko=wI.concat(Vb),$g=`
`,Wb="{YYYY}",lb=$g+Wb,qb="{M}/{D}",jc=$g+qb,af=jc+"/{YY}",$b="{aa}",TI="{h}:{mm}",tl=TI+$b,cb=$g+tl,ub=":{ss}",Ge=null;function Xb(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Qc(10,0,3,df).filter(Gb):Qc(10,-3,0,df)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Wb,Ge,Ge,Ge,Ge,Ge,Ge,1],[s*28,"{MMM}",lb,Ge,Ge,Ge,Ge,Ge,1],[s,qb,lb,Ge,Ge,Ge,Ge,Ge,1],[i,"{h}"+$b,af,Ge,jc,Ge,Ge,Ge,1],[e,tl,af,Ge,jc,Ge,Ge,Ge,1],[t,ub,af+" "+tl,Ge,jc+" "+tl,Ge,cb,Ge,1],[n,ub+".{fff}",af+" "+tl,Ge,jc+" "+tl,Ge,cb,Ge,1]];function u(h){return(d,f,p,y,m,g)=>{let x=[],w=m>=o,b=m>=r&&m<o,A=h(p),T=tn(A*n,3),_=Eg(A.getFullYear(),w?0:A.getMonth(),b||w?1:A.getDate()),S=tn(_*n,3);if(b||w){let D=b?m/r:0,L=w?m/o:0,N=T==S?T:tn(Eg(_.getFullYear()+L,_.getMonth()+D,1)*n,3),z=new Date(Vn(N/n)),W=z.getFullYear(),B=z.getMonth();for(let X=0;N<=y;X++){let I=Eg(W+L*X,B+D*X,1),U=I-h(tn(I*n,3));N=tn((+I+U)*n,3),N<=y&&x.push(N)}}else{let D=m>=s?s:m,L=es(p)-es(T),N=S+L+mf(T-S,D);x.push(N);let z=h(N),W=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,B=m/i,X=d.axes[f]._space,I=g/X;for(;N=tn(N+m,n==1?0:3),!(N>y);)if(B>1){let U=es(tn(W+B,6))%24,j=h(N).getHours()-U;j>1&&(j=-1),N-=j*i,W=(W+B)%24;let et=x[x.length-1];tn((N-et)/m,3)*I>=.7&&x.push(N)}else x.push(N)}return x}}return[l,c,u]}var[AI,RI,CI]=Xb(1),[PI,II,LI]=Xb(.001);Qc(2,-53,53,[1]);function hb(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function db(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let y=n(p),m=y.getFullYear(),g=y.getMonth(),x=y.getDate(),w=y.getHours(),b=y.getMinutes(),A=y.getSeconds(),T=m!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||w!=h&&a[5]||b!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,u=x,h=w,d=b,f=A,T(y)})}}function DI(n,t){let e=qg(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Eg(n,t,e){return new Date(n,t,e)}function fb(n,t){return t(n)}var NI="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function pb(n,t){return(e,i,s,r)=>r==null?kg:t(n(i))}function UI(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function FI(n,t){return n.series[t].fill(n,t)}var OI={show:!0,live:!0,isolate:!1,mount:nI,markers:{show:!0,width:2,stroke:UI,fill:FI,dash:"solid"},idx:null,idxs:null,values:[]};function BI(n,t){let e=n.cursor.points,i=ps(),s=e.size(n,t);un(i,Yc,s),un(i,Zc,s);let r=s/-2;un(i,"marginLeft",r),un(i,"marginTop",r);let o=e.width(n,t,s);return o&&un(i,"borderWidth",o),i}function kI(n,t){let e=n.series[t].points;return e._fill||e._stroke}function zI(n,t){let e=n.series[t].points;return e._stroke||e._fill}function HI(n,t){return n.series[t].points.size}var Tg=[0,0];function GI(n,t,e){return Tg[0]=t,Tg[1]=e,Tg}function lf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Ag(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var VI={show:!0,x:!0,y:!0,lock:!1,move:GI,points:{one:!1,show:BI,size:HI,width:0,stroke:zI,fill:kI},bind:{mousedown:lf,mouseup:lf,click:lf,dblclick:lf,mousemove:Ag,mouseleave:Ag,mouseenter:Ag},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Yb={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xg=On({},Yb,{filter:Nb}),Zb=On({},Xg,{size:10}),jb=On({},Yb,{show:!1}),Yg='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Jb="bold "+Yg,Kb=1.5,mb={show:!0,scale:"x",stroke:Bg,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jb,side:2,grid:Xg,ticks:Zb,border:jb,font:Yg,lineGap:Kb,rotate:0},WI="Value",qI="Time",gb={show:!0,scale:"x",auto:!1,sorted:1,min:Qe,max:-Qe,idxs:[]};function $I(n,t,e,i,s){return t.map(r=>r==null?"":Vg(r))}function XI(n,t,e,i,s,r,o){let a=[],l=ho.get(s)||0;e=o?e:tn(mf(e,s),l);for(let c=e;c<=i;c=tn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Dg(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Dr:Ib,u=es(c(e));s=nl(l,u),l==10&&(s=ko[Ls(s,ko)]);let h=e,d=s*l;l==10&&(d=ko[Ls(d,ko)]);do a.push(h),h=h+s,l==10&&!ho.has(h)&&(h=tn(h,ho.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=ko[Ls(d,ko)]));while(h<=i);return a}function YI(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Dg(n,t,Ri(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Dg(n,t,Ri(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var Qb=/./,ZI=/[12357]/,jI=/[125]/,_b=/1/,Ng=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function JI(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Qb:l(7,o)-u>=c?ZI:l(5,o)-u>=c?jI:_b;if(h==_b){let d=Wn(l(1,o)-u);if(d<c)return Ng(t.slice().reverse(),a.distr,h,ms(c/d)).reverse()}return Ng(t,a.distr,h,1)}function KI(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Wn(l(1,o)-l(2,o));return c<a?Ng(t.slice().reverse(),3,Qb,ms(a/c)).reverse():t}function QI(n,t,e,i){return i==null?kg:t==null?"":Vg(t)}var xb={show:!0,scale:"y",stroke:Bg,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jb,side:3,grid:Xg,ticks:Zb,border:jb,font:Yg,lineGap:Kb,rotate:0};function t3(n,t){let e=3+(n||1)*2;return tn(e*t,3)}function e3(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Wn(o-r),l=n.series[t],c=a/(l.points.space*ke);return i[1]-i[0]<=c}var yb={scale:null,auto:!0,sorted:0,min:Qe,max:-Qe},tM=(n,t,e,i,s)=>s,vb={show:!0,auto:!0,sorted:0,gaps:tM,alpha:1,facets:[On({},yb,{scale:"x"}),On({},yb,{scale:"y"})]},bb={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:tM,alpha:1,points:{show:e3,filter:null},values:null,min:Qe,max:-Qe,idxs:[],path:null,clip:null};function n3(n,t,e,i,s){return e/10}var eM={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},i3=On({},eM,{time:!1,ori:1}),Mb={};function nM(n,t){let e=Mb[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Mb[n]=e)),e}var rl=1,Ug=2;function Vo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,y=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,g,d,f,p,y,xf,al,vf,sM,oM):e(s,l,c,u,h,g,m,f,d,y,p,yf,ll,Jg,rM,aM)}function Zg(n,t){let e=0,i=0,s=Ne(n.bands,Wg);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function s3(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Nr(n,t,e,i,s,r){return Vo(n,t,(o,a,l,c,u,h,d,f,p,y,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),w=c.ori==0?al:ll,b,A;x==1?(b=e,A=i):(b=i,A=e);let T=g(h(a[b],c,y,f)),_=g(d(l[b],u,m,p)),S=g(h(a[A],c,y,f)),D=g(d(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return w(L,S,D),w(L,T,D),w(L,T,_),L})}function _f(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?vf:Jg,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function r3(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function jg(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function Sb(n){return n==0?Db:n==1?Vn:t=>Bo(t,n)}function iM(n){let t=n==0?xf:yf,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ds(c,a/2,l/2),u=Ds(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var xf=(n,t,e)=>{n.moveTo(t,e)},yf=(n,t,e)=>{n.moveTo(e,t)},al=(n,t,e)=>{n.lineTo(t,e)},ll=(n,t,e)=>{n.lineTo(e,t)},vf=iM(0),Jg=iM(1),sM=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},rM=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},oM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},aM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function lM(n){return(t,e,i,s,r)=>Vo(t,e,(o,a,l,c,u,h,d,f,p,y,m)=>{let{pxRound:g,points:x}=o,w,b;c.ori==0?(w=xf,b=sM):(w=yf,b=rM);let A=tn(x.width*ke,3),T=(x.size-x.width)/2*ke,_=tn(T*2,3),S=new Path2D,D=new Path2D,{left:L,top:N,width:z,height:W}=t.bbox;vf(D,L-_,N-_,z+_*2,W+_*2);let B=X=>{if(l[X]!=null){let I=g(h(a[X],c,y,f)),U=g(d(l[X],u,m,p));w(S,I+T,U),b(S,I,U,T,0,cf*2)}};if(r)r.forEach(B);else for(let X=i;X<=s;X++)B(X);return{stroke:A>0?S:null,fill:S,clip:D,flags:rl|Ug}})}function cM(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var o3=cM(al),a3=cM(ll);function uM(n){let t=Ne(n?.alignGaps,0);return(e,i,s,r)=>Vo(e,i,(o,a,l,c,u,h,d,f,p,y,m)=>{[s,r]=ff(l,s,r);let g=o.pxRound,x=W=>g(h(W,c,y,f)),w=W=>g(d(W,u,m,p)),b,A;c.ori==0?(b=al,A=o3):(b=ll,A=a3);let T=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:rl},S=_.stroke,D=!1;if(r-s>=y*4){let W=ft=>e.posToVal(ft,c.key,!0),B=null,X=null,I,U,Z,q=x(a[T==1?s:r]),j=x(a[s]),et=x(a[r]),ht=W(T==1?j+1:et-1);for(let ft=T==1?s:r;ft>=s&&ft<=r;ft+=T){let it=a[ft],xt=(T==1?it<ht:it>ht)?q:x(it),Tt=l[ft];xt==q?Tt!=null?(U=Tt,B==null?(b(S,xt,w(U)),I=B=X=U):U<B?B=U:U>X&&(X=U)):Tt===null&&(D=!0):(B!=null&&A(S,q,w(B),w(X),w(I),w(U)),Tt!=null?(U=Tt,b(S,xt,w(U)),B=X=I=U):(B=X=null,Tt===null&&(D=!0)),q=xt,ht=W(q+T))}B!=null&&B!=X&&Z!=q&&A(S,q,w(B),w(X),w(I),w(U))}else for(let W=T==1?s:r;W>=s&&W<=r;W+=T){let B=l[W];B===null?D=!0:B!=null&&b(S,x(a[W]),w(B))}let[N,z]=Zg(e,i);if(o.fill!=null||N!=0){let W=_.fill=new Path2D(S),B=o.fillTo(e,i,o.min,o.max,N),X=w(B),I=x(a[s]),U=x(a[r]);T==-1&&([U,I]=[I,U]),b(W,U,X),b(W,I,X)}if(!o.spanGaps){let W=[];D&&W.push(...jg(a,l,s,r,T,x,t)),_.gaps=W=o.gaps(e,i,s,r,W),_.clip=_f(W,c.ori,f,p,y,m)}return z!=0&&(_.band=z==2?[Nr(e,i,s,r,S,-1),Nr(e,i,s,r,S,1)]:Nr(e,i,s,r,S,z)),_})}function l3(n){let t=Ne(n.align,1),e=Ne(n.ascDesc,!1),i=Ne(n.alignGaps,0),s=Ne(n.extend,!1);return(r,o,a,l)=>Vo(r,o,(c,u,h,d,f,p,y,m,g,x,w)=>{[a,l]=ff(h,a,l);let b=c.pxRound,{left:A,width:T}=r.bbox,_=j=>b(p(j,d,x,m)),S=j=>b(y(j,f,w,g)),D=d.ori==0?al:ll,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:rl},N=L.stroke,z=d.dir*(d.ori==0?1:-1),W=S(h[z==1?a:l]),B=_(u[z==1?a:l]),X=B,I=B;s&&t==-1&&(I=A,D(N,I,W)),D(N,B,W);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let et=h[j];if(et==null)continue;let ht=_(u[j]),ft=S(et);t==1?D(N,ht,W):D(N,X,ft),D(N,ht,ft),W=ft,X=ht}let U=X;s&&t==1&&(U=A+T,D(N,U,W));let[Z,q]=Zg(r,o);if(c.fill!=null||Z!=0){let j=L.fill=new Path2D(N),et=c.fillTo(r,o,c.min,c.max,Z),ht=S(et);D(j,U,ht),D(j,I,ht)}if(!c.spanGaps){let j=[];j.push(...jg(u,h,a,l,z,_,i));let et=c.width*ke/2,ht=e||t==1?et:-et,ft=e||t==-1?-et:et;j.forEach(it=>{it[0]+=ht,it[1]+=ft}),L.gaps=j=c.gaps(r,o,a,l,j),L.clip=_f(j,d.ori,m,g,x,w)}return q!=0&&(L.band=q==2?[Nr(r,o,a,l,N,-1),Nr(r,o,a,l,N,1)]:Nr(r,o,a,l,N,q)),L})}function wb(n,t,e,i,s,r,o=Qe){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Wn(n[l]-n[a]);u<c&&(c=u,o=Wn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function c3(n){n=n||Kc;let t=Ne(n.size,[.6,Qe,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ie(s),o=1-t[0],a=Ne(t[1],Qe),l=Ne(t[2],1),c=Ne(n.disp,Kc),u=Ne(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,y,m)=>Vo(f,p,(g,x,w,b,A,T,_,S,D,L,N)=>{let z=g.pxRound,W=e,B=i*ke,X=a*ke,I=l*ke,U,Z;b.ori==0?[U,Z]=r(f,p):[Z,U]=r(f,p);let q=b.dir*(b.ori==0?1:-1),j=b.ori==0?vf:Jg,et=b.ori==0?u:(Nt,ne,me,Ct,je,Yt,Qt)=>{u(Nt,ne,me,je,Ct,Qt,Yt)},ht=Ne(f.bands,Wg).find(Nt=>Nt.series[0]==p),ft=ht!=null?ht.dir:0,it=g.fillTo(f,p,g.min,g.max,ft),vt=z(_(it,A,N,D)),xt,Tt,At,Jt=L,pe=z(g.width*ke),Zt=!1,be=null,xe=null,de=null,hn=null;h!=null&&(pe==0||d!=null)&&(Zt=!0,be=h.values(f,p,y,m),xe=new Map,new Set(be).forEach(Nt=>{Nt!=null&&xe.set(Nt,new Path2D)}),pe>0&&(de=d.values(f,p,y,m),hn=new Map,new Set(de).forEach(Nt=>{Nt!=null&&hn.set(Nt,new Path2D)})));let{x0:en,size:Cn}=c;if(en!=null&&Cn!=null){W=1,x=en.values(f,p,y,m),en.unit==2&&(x=x.map(me=>f.posToVal(S+me*L,b.key,!0)));let Nt=Cn.values(f,p,y,m);Cn.unit==2?Tt=Nt[0]*L:Tt=T(Nt[0],b,L,S)-T(0,b,L,S),Jt=wb(x,w,T,b,L,S,Jt),At=Jt-Tt+B}else Jt=wb(x,w,T,b,L,S,Jt),At=Jt*o+B,Tt=Jt-At;At<1&&(At=0),pe>=Tt/2&&(pe=0),At<5&&(z=Db);let Xe=At>0,$n=Jt-At-(Xe?pe:0);Tt=z(Lg($n,I,X)),xt=(W==0?Tt/2:W==q?0:Tt)-W*q*((W==0?B/2:0)+(Xe?pe/2:0));let Le={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bn=Zt?null:new Path2D,vn=null;if(ht!=null)vn=f.data[ht.series[1]];else{let{y0:Nt,y1:ne}=c;Nt!=null&&ne!=null&&(w=ne.values(f,p,y,m),vn=Nt.values(f,p,y,m))}let Pn=U*Tt,V=Z*Tt;for(let Nt=q==1?y:m;Nt>=y&&Nt<=m;Nt+=q){let ne=w[Nt];if(ne==null)continue;if(vn!=null){let J=vn[Nt]??0;if(ne-J==0)continue;vt=_(J,A,N,D)}let me=b.distr!=2||c!=null?x[Nt]:Nt,Ct=T(me,b,L,S),je=_(Ne(ne,it),A,N,D),Yt=z(Ct-xt),Qt=z(Ri(je,vt)),F=z(Ds(je,vt)),R=Qt-F;if(ne!=null){let J=ne<0?V:Pn,mt=ne<0?Pn:V;Zt?(pe>0&&de[Nt]!=null&&j(hn.get(de[Nt]),Yt,F+es(pe/2),Tt,Ri(0,R-pe),J,mt),be[Nt]!=null&&j(xe.get(be[Nt]),Yt,F+es(pe/2),Tt,Ri(0,R-pe),J,mt)):j(Bn,Yt,F+es(pe/2),Tt,Ri(0,R-pe),J,mt),et(f,p,Nt,Yt-pe/2,F,Tt+pe,R)}}return pe>0?Le.stroke=Zt?hn:Bn:Zt||(Le._fill=g.width==0?g._fill:g._stroke??g._fill,Le.width=0),Le.fill=Zt?xe:Bn,Le})}function u3(n,t){let e=Ne(t?.alignGaps,0);return(i,s,r,o)=>Vo(i,s,(a,l,c,u,h,d,f,p,y,m,g)=>{[r,o]=ff(c,r,o);let x=a.pxRound,w=U=>x(d(U,u,m,p)),b=U=>x(f(U,h,g,y)),A,T,_;u.ori==0?(A=xf,_=al,T=oM):(A=yf,_=ll,T=aM);let S=u.dir*(u.ori==0?1:-1),D=w(l[S==1?r:o]),L=D,N=[],z=[];for(let U=S==1?r:o;U>=r&&U<=o;U+=S)if(c[U]!=null){let q=l[U],j=w(q);N.push(L=j),z.push(b(c[U]))}let W={stroke:n(N,z,A,_,T,x),fill:null,clip:null,band:null,gaps:null,flags:rl},B=W.stroke,[X,I]=Zg(i,s);if(a.fill!=null||X!=0){let U=W.fill=new Path2D(B),Z=a.fillTo(i,s,a.min,a.max,X),q=b(Z);_(U,L,q),_(U,D,q)}if(!a.spanGaps){let U=[];U.push(...jg(l,c,r,o,S,w,e)),W.gaps=U=a.gaps(i,s,r,o,U),W.clip=_f(U,u.ori,p,y,m,g)}return I!=0&&(W.band=I==2?[Nr(i,s,r,o,B,-1),Nr(i,s,r,o,B,1)]:Nr(i,s,r,o,B,I)),W})}function h3(n){return u3(d3,n)}function d3(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var Fg=new Set;function Eb(){for(let n of Fg)n.syncRect(!0)}ol&&(Ho($P,el,Eb),Ho(XP,el,Eb,!0),Ho(uf,el,()=>{ri.pxRatio=ke}));var f3=uM(),p3=lM();function Tb(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Og(r,o,t,e))}function m3(n,t){return n.map((e,i)=>i==0?{}:On({},t,e))}function Og(n,t,e,i){return On({},t==0?e:i,n)}function hM(n,t,e){return t==null?il:[t,e]}var g3=hM;function _3(n,t,e){return t==null?il:hf(t,e,Gg,!0)}function dM(n,t,e,i){return t==null?il:pf(t,e,n.scales[i].log,!1)}var x3=dM;function fM(n,t,e,i){return t==null?il:Hg(t,e,n.scales[i].log,!1)}var y3=fM;function v3(n,t,e,i,s){let r=Ri(sb(n),sb(t)),o=t-n,a=Ls(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?ho.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ab(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Vn((e=+s)*ke))+"px"),[n,t,e]}function b3(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=tn(t[2]*ke,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ri(n,t,e){let i={mode:Ne(n.mode,1)},s=i.mode;function r(E,C,O,k){let Y=C.valToPct(E);return k+O*(C.dir==-1?1-Y:Y)}function o(E,C,O,k){let Y=C.valToPct(E);return k+O*(C.dir==-1?Y:1-Y)}function a(E,C,O,k){return C.ori==0?r(E,C,O,k):o(E,C,O,k)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ps(RP);if(n.id!=null&&(c.id=n.id),ts(c,n.class),n.title){let E=ps(IP,c);E.textContent=n.title}let u=Is("canvas"),h=i.ctx=u.getContext("2d"),d=ps(LP,c);Ho("click",d,E=>{E.target===p&&(rn!=ta||dn!=ea)&&ei.click(i,E)},!0);let f=i.under=ps(DP,d);d.appendChild(u);let p=i.over=ps(NP,d);n=sl(n);let y=+Ne(n.pxAlign,1),m=Sb(y);(n.plugins||[]).forEach(E=>{E.opts&&(n=E.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?Tb(n.series||[],gb,bb,!1):m3(n.series||[null],vb),w=i.axes=Tb(n.axes||[],mb,xb,!0),b=i.scales={},A=i.bands=n.bands||[];A.forEach(E=>{E.fill=Ie(E.fill||null),E.dir=Ne(E.dir,-1)});let T=s==2?x[1].facets[0].scale:x[0].scale,_={axes:lr,series:we},S=(n.drawOrder||["axes","series"]).map(E=>_[E]);function D(E){let C=E.distr==3?O=>Dr(O>0?O:E.clamp(i,O,E.min,E.max,E.key)):E.distr==4?O=>wg(O,E.asinh):E.distr==100?O=>E.fwd(O):O=>O;return O=>{let k=C(O),{_min:Y,_max:tt}=E,ut=tt-Y;return(k-Y)/ut}}function L(E){let C=b[E];if(C==null){let O=(n.scales||Kc)[E]||Kc;if(O.from!=null){L(O.from);let k=On({},b[O.from],O,{key:E});k.valToPct=D(k),b[E]=k}else{C=b[E]=On({},E==T?eM:i3,O),C.key=E;let k=C.time,Y=C.range,tt=uo(Y);if((E!=T||s==2&&!k)&&(tt&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?eb:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?eb:{mode:1,hard:Y[1],soft:Y[1]}},tt=!1),!tt&&gf(Y))){let ut=Y;Y=(yt,Et,Bt)=>Et==null?il:hf(Et,Bt,ut)}C.range=Ie(Y||(k?g3:E==T?C.distr==3?x3:C.distr==4?y3:hM:C.distr==3?dM:C.distr==4?fM:_3)),C.auto=Ie(tt?!1:C.auto),C.clamp=Ie(C.clamp||n3),C._min=C._max=null,C.valToPct=D(C)}}}L("x"),L("y"),s==1&&x.forEach(E=>{L(E.scale)}),w.forEach(E=>{L(E.scale)});for(let E in n.scales)L(E);let N=b[T],z=N.distr,W,B;N.ori==0?(ts(c,CP),W=r,B=o):(ts(c,PP),W=o,B=r);let X={};for(let E in b){let C=b[E];(C.min!=null||C.max!=null)&&(X[E]={min:C.min,max:C.max},C.min=C.max=null)}let I=n.tzDate||(E=>new Date(Vn(E/g))),U=n.fmtDate||qg,Z=g==1?CI(I):LI(I),q=db(I,hb(g==1?RI:II,U)),j=pb(I,fb(NI,U)),et=[],ht=i.legend=On({},OI,n.legend),ft=i.cursor=On({},VI,{drag:{y:s==2}},n.cursor),it=ht.show,vt=ft.show,xt=ht.markers;ht.idxs=et,xt.width=Ie(xt.width),xt.dash=Ie(xt.dash),xt.stroke=Ie(xt.stroke),xt.fill=Ie(xt.fill);let Tt,At,Jt,pe=[],Zt=[],be,xe=!1,de={};if(ht.live){let E=x[1]?x[1].values:null;xe=E!=null,be=xe?E(i,1,0):{_:0};for(let C in be)de[C]=kg}if(it)if(Tt=Is("table",zP,c),Jt=Is("tbody",null,Tt),ht.mount(i,Tt),xe){At=Is("thead",null,Tt,Jt);let E=Is("tr",null,At);Is("th",null,E);for(var hn in be)Is("th",Gv,E).textContent=hn}else ts(Tt,GP),ht.live&&ts(Tt,HP);let en={show:!0},Cn={show:!1};function Xe(E,C){if(C==0&&(xe||!ht.live||s==2))return il;let O=[],k=Is("tr",VP,Jt,Jt.childNodes[C]);ts(k,E.class),E.show||ts(k,zo);let Y=Is("th",null,k);if(xt.show){let yt=ps(WP,Y);if(C>0){let Et=xt.width(i,C);Et&&(yt.style.border=Et+"px "+xt.dash(i,C)+" "+xt.stroke(i,C)),yt.style.background=xt.fill(i,C)}}let tt=ps(Gv,Y);E.label instanceof HTMLElement?tt.appendChild(E.label):tt.textContent=E.label,C>0&&(xt.show||(tt.style.color=E.width>0?xt.stroke(i,C):xt.fill(i,C)),Le("click",Y,yt=>{if(ft._lock)return;oe(yt);let Et=x.indexOf(E);if((yt.ctrlKey||yt.metaKey)!=ht.isolate){let Bt=x.some((kt,Gt)=>Gt>0&&Gt!=Et&&kt.show);x.forEach((kt,Gt)=>{Gt>0&&Bs(Gt,Bt?Gt==Et?en:Cn:en,!0,Nn.setSeries)})}else Bs(Et,{show:!E.show},!0,Nn.setSeries)},!1),ae&&Le($v,Y,yt=>{ft._lock||(oe(yt),Bs(x.indexOf(E),ia,!0,Nn.setSeries))},!1));for(var ut in be){let yt=Is("td",qP,k);yt.textContent="--",O.push(yt)}return[k,O]}let $n=new Map;function Le(E,C,O,k=!0){let Y=$n.get(C)||{},tt=ft.bind[E](i,C,O,k);tt&&(Ho(E,C,Y[E]=tt),$n.set(C,Y))}function Bn(E,C,O){let k=$n.get(C)||{};for(let Y in k)(E==null||Y==E)&&(Ig(Y,C,k[Y]),delete k[Y]);E==null&&$n.delete(C)}let vn=0,Pn=0,V=0,Nt=0,ne=0,me=0,Ct=ne,je=me,Yt=V,Qt=Nt,F=0,R=0,J=0,mt=0;i.bbox={};let ct=!1,St=!1,wt=!1,rt=!1,at=!1,bt=!1;function G(E,C,O){(O||E!=i.width||C!=i.height)&&lt(E,C),ye(!1),wt=!0,St=!0,oi()}function lt(E,C){i.width=vn=V=E,i.height=Pn=Nt=C,ne=me=0,Rt(),jt();let O=i.bbox;F=O.left=Bo(ne*ke,.5),R=O.top=Bo(me*ke,.5),J=O.width=Bo(V*ke,.5),mt=O.height=Bo(Nt*ke,.5)}let ot=3;function Pt(){let E=!1,C=0;for(;!E;){C++;let O=Jo(C),k=Os(C);E=C==ot||O&&k,E||(lt(i.width,i.height),St=!0)}}function Mt({width:E,height:C}){G(E,C)}i.setSize=Mt;function Rt(){let E=!1,C=!1,O=!1,k=!1;w.forEach((Y,tt)=>{if(Y.show&&Y._show){let{side:ut,_size:yt}=Y,Et=ut%2,Bt=Y.label!=null?Y.labelSize:0,kt=yt+Bt;kt>0&&(Et?(V-=kt,ut==3?(ne+=kt,k=!0):O=!0):(Nt-=kt,ut==0?(me+=kt,E=!0):C=!0))}}),Us[0]=E,Us[1]=O,Us[2]=C,Us[3]=k,V-=gs[1]+gs[3],ne+=gs[3],Nt-=gs[2]+gs[0],me+=gs[0]}function jt(){let E=ne+V,C=me+Nt,O=ne,k=me;function Y(tt,ut){switch(tt){case 1:return E+=ut,E-ut;case 2:return C+=ut,C-ut;case 3:return O-=ut,O+ut;case 0:return k-=ut,k+ut}}w.forEach((tt,ut)=>{if(tt.show&&tt._show){let yt=tt.side;tt._pos=Y(yt,tt._size),tt.label!=null&&(tt._lpos=Y(yt,tt.labelSize))}})}if(ft.dataIdx==null){let E=ft.hover,C=E.skip=new Set(E.skip??[]);C.add(void 0);let O=E.prox=Ie(E.prox),k=E.bias??=0;ft.dataIdx=(Y,tt,ut,yt)=>{if(tt==0)return ut;let Et=ut,Bt=O(Y,tt,ut,yt)??Qe,kt=Bt>=0&&Bt<Qe,Gt=N.ori==0?V:Nt,fe=ft.left,Ue=t[0],De=t[tt];if(C.has(De[ut])){Et=null;let Te=null,se=null,Kt;if(k==0||k==-1)for(Kt=ut;Te==null&&Kt-- >0;)C.has(De[Kt])||(Te=Kt);if(k==0||k==1)for(Kt=ut;se==null&&Kt++<De.length;)C.has(De[Kt])||(se=Kt);if(Te!=null||se!=null)if(kt){let an=Te==null?-1/0:W(Ue[Te],N,Gt,0),Sn=se==null?1/0:W(Ue[se],N,Gt,0),jn=fe-an,Ye=Sn-fe;jn<=Ye?jn<=Bt&&(Et=Te):Ye<=Bt&&(Et=se)}else Et=se==null?Te:Te==null?se:ut-Te<=se-ut?Te:se}else kt&&Wn(fe-W(Ue[ut],N,Gt,0))>Bt&&(Et=null);return Et}}let oe=E=>{ft.event=E};ft.idxs=et,ft._lock=!1;let pt=ft.points;pt.show=Ie(pt.show),pt.size=Ie(pt.size),pt.stroke=Ie(pt.stroke),pt.width=Ie(pt.width),pt.fill=Ie(pt.fill);let Wt=i.focus=On({},n.focus||{alpha:.3},ft.focus),ae=Wt.prox>=0,Dt=ae&&pt.one,ge=[],sn=[],fi=[];function bl(E,C){let O=pt.show(i,C);if(O instanceof HTMLElement)return ts(O,kP),ts(O,E.class),ir(O,-10,-10,V,Nt),p.insertBefore(O,ge[C]),O}function Yo(E,C){if(s==1||C>0){let O=s==1&&b[E.scale].time,k=E.value;E.value=O?ab(k)?pb(I,fb(k,U)):k||j:k||QI,E.label=E.label||(O?qI:WI)}if(Dt||C>0){E.width=E.width==null?1:E.width,E.paths=E.paths||f3||iI,E.fillTo=Ie(E.fillTo||s3),E.pxAlign=+Ne(E.pxAlign,y),E.pxRound=Sb(E.pxAlign),E.stroke=Ie(E.stroke||null),E.fill=Ie(E.fill||null),E._stroke=E._fill=E._paths=E._focus=null;let O=t3(Ri(1,E.width),1),k=E.points=On({},{size:O,width:Ri(1,O*.2),stroke:E.stroke,space:O*2,paths:p3,_stroke:null,_fill:null},E.points);k.show=Ie(k.show),k.filter=Ie(k.filter),k.fill=Ie(k.fill),k.stroke=Ie(k.stroke),k.paths=Ie(k.paths),k.pxAlign=E.pxAlign}if(it){let O=Xe(E,C);pe.splice(C,0,O[0]),Zt.splice(C,0,O[1]),ht.values.push(null)}if(vt){et.splice(C,0,null);let O=null;Dt?C==0&&(O=bl(E,C)):C>0&&(O=bl(E,C)),ge.splice(C,0,O),sn.splice(C,0,0),fi.splice(C,0,0)}Zn("addSeries",C)}function Xf(E,C){C=C??x.length,E=s==1?Og(E,C,gb,bb):Og(E,C,{},vb),x.splice(C,0,E),Yo(x[C],C)}i.addSeries=Xf;function au(E){if(x.splice(E,1),it){ht.values.splice(E,1),Zt.splice(E,1);let C=pe.splice(E,1)[0];Bn(null,C.firstChild),C.remove()}vt&&(et.splice(E,1),ge.splice(E,1)[0].remove(),sn.splice(E,1),fi.splice(E,1)),Zn("delSeries",E)}i.delSeries=au;let Us=[!1,!1,!1,!1];function rr(E,C){if(E._show=E.show,E.show){let O=E.side%2,k=b[E.scale];k==null&&(E.scale=O?x[1].scale:T,k=b[E.scale]);let Y=k.time;E.size=Ie(E.size),E.space=Ie(E.space),E.rotate=Ie(E.rotate),uo(E.incrs)&&E.incrs.forEach(ut=>{!ho.has(ut)&&ho.set(ut,Fb(ut))}),E.incrs=Ie(E.incrs||(k.distr==2?EI:Y?g==1?AI:PI:ko)),E.splits=Ie(E.splits||(Y&&k.distr==1?Z:k.distr==3?Dg:k.distr==4?YI:XI)),E.stroke=Ie(E.stroke),E.grid.stroke=Ie(E.grid.stroke),E.ticks.stroke=Ie(E.ticks.stroke),E.border.stroke=Ie(E.border.stroke);let tt=E.values;E.values=uo(tt)&&!uo(tt[0])?Ie(tt):Y?uo(tt)?db(I,hb(tt,U)):ab(tt)?DI(I,tt):tt||q:tt||$I,E.filter=Ie(E.filter||(k.distr>=3&&k.log==10?JI:k.distr==3&&k.log==2?KI:Nb)),E.font=Ab(E.font),E.labelFont=Ab(E.labelFont),E._size=E.size(i,null,C,0),E._space=E._rotate=E._incrs=E._found=E._splits=E._values=null,E._size>0&&(Us[C]=!0,E._el=ps(UP,d))}}function or(E,C,O,k){let[Y,tt,ut,yt]=O,Et=C%2,Bt=0;return Et==0&&(yt||tt)&&(Bt=C==0&&!Y||C==2&&!ut?Vn(mb.size/3):0),Et==1&&(Y||ut)&&(Bt=C==1&&!tt||C==3&&!yt?Vn(xb.size/2):0),Bt}let Ml=i.padding=(n.padding||[or,or,or,or]).map(E=>Ie(Ne(E,or))),gs=i._padding=Ml.map((E,C)=>E(i,C,Us,0)),bn,An=null,Rn=null,Fs=s==1?x[0].idxs:null,Hi=null,Fr=!1;function Sl(E,C){if(t=E??[],i.data=i._data=t,s==2){bn=0;for(let O=1;O<x.length;O++)bn+=t[O][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Hi=t[0],bn=Hi.length;let O=t;if(z==2){O=t.slice();let k=O[0]=Array(bn);for(let Y=0;Y<bn;Y++)k[Y]=Y}i._data=t=O}if(ye(!0),Zn("setData"),z==2&&(wt=!0),C!==!1){let O=N;O.auto(i,Fr)?wl():kr(T,O.min,O.max),rt=rt||ft.left>=0,bt=!0,oi()}}i.setData=Sl;function wl(){Fr=!0;let E,C;s==1&&(bn>0?(An=Fs[0]=0,Rn=Fs[1]=bn-1,E=t[0][An],C=t[0][Rn],z==2?(E=An,C=Rn):E==C&&(z==3?[E,C]=pf(E,E,N.log,!1):z==4?[E,C]=Hg(E,E,N.log,!1):N.time?C=E+Vn(86400/g):[E,C]=hf(E,C,Gg,!0))):(An=Fs[0]=E=null,Rn=Fs[1]=C=null)),kr(T,E,C)}let Zo,Or,jo,P,$,nt,K,Q,It,Ut;function Lt(E,C,O,k,Y,tt){E??=Wv,O??=Wg,k??="butt",Y??=Wv,tt??="round",E!=Zo&&(h.strokeStyle=Zo=E),Y!=Or&&(h.fillStyle=Or=Y),C!=jo&&(h.lineWidth=jo=C),tt!=$&&(h.lineJoin=$=tt),k!=nt&&(h.lineCap=nt=k),O!=P&&h.setLineDash(P=O)}function Ft(E,C,O,k){C!=Or&&(h.fillStyle=Or=C),E!=K&&(h.font=K=E),O!=Q&&(h.textAlign=Q=O),k!=It&&(h.textBaseline=It=k)}function $t(E,C,O,k,Y=0){if(k.length>0&&E.auto(i,Fr)&&(C==null||C.min==null)){let tt=Ne(An,0),ut=Ne(Rn,k.length-1),yt=O.min==null?JP(k,tt,ut,Y,E.distr==3):[O.min,O.max];E.min=Ds(E.min,O.min=yt[0]),E.max=Ri(E.max,O.max=yt[1])}}let le={min:null,max:null};function Se(){for(let k in b){let Y=b[k];X[k]==null&&(Y.min==null||X[T]!=null&&Y.auto(i,Fr))&&(X[k]=le)}for(let k in b){let Y=b[k];X[k]==null&&Y.from!=null&&X[Y.from]!=null&&(X[k]=le)}X[T]!=null&&ye(!0);let E={};for(let k in X){let Y=X[k];if(Y!=null){let tt=E[k]=sl(b[k],oI);if(Y.min!=null)On(tt,Y);else if(k!=T||s==2)if(bn==0&&tt.from==null){let ut=tt.range(i,null,null,k);tt.min=ut[0],tt.max=ut[1]}else tt.min=Qe,tt.max=-Qe}}if(bn>0){x.forEach((k,Y)=>{if(s==1){let tt=k.scale,ut=X[tt];if(ut==null)return;let yt=E[tt];if(Y==0){let Et=yt.range(i,yt.min,yt.max,tt);yt.min=Et[0],yt.max=Et[1],An=Ls(yt.min,t[0]),Rn=Ls(yt.max,t[0]),Rn-An>1&&(t[0][An]<yt.min&&An++,t[0][Rn]>yt.max&&Rn--),k.min=Hi[An],k.max=Hi[Rn]}else k.show&&k.auto&&$t(yt,ut,k,t[Y],k.sorted);k.idxs[0]=An,k.idxs[1]=Rn}else if(Y>0&&k.show&&k.auto){let[tt,ut]=k.facets,yt=tt.scale,Et=ut.scale,[Bt,kt]=t[Y],Gt=E[yt],fe=E[Et];Gt!=null&&$t(Gt,X[yt],tt,Bt,tt.sorted),fe!=null&&$t(fe,X[Et],ut,kt,ut.sorted),k.min=ut.min,k.max=ut.max}});for(let k in E){let Y=E[k],tt=X[k];if(Y.from==null&&(tt==null||tt.min==null)){let ut=Y.range(i,Y.min==Qe?null:Y.min,Y.max==-Qe?null:Y.max,k);Y.min=ut[0],Y.max=ut[1]}}}for(let k in E){let Y=E[k];if(Y.from!=null){let tt=E[Y.from];if(tt.min==null)Y.min=Y.max=null;else{let ut=Y.range(i,tt.min,tt.max,k);Y.min=ut[0],Y.max=ut[1]}}}let C={},O=!1;for(let k in E){let Y=E[k],tt=b[k];if(tt.min!=Y.min||tt.max!=Y.max){tt.min=Y.min,tt.max=Y.max;let ut=tt.distr;tt._min=ut==3?Dr(tt.min):ut==4?wg(tt.min,tt.asinh):ut==100?tt.fwd(tt.min):tt.min,tt._max=ut==3?Dr(tt.max):ut==4?wg(tt.max,tt.asinh):ut==100?tt.fwd(tt.max):tt.max,C[k]=O=!0}}if(O){x.forEach((k,Y)=>{s==2?Y>0&&C.y&&(k._paths=null):C[k.scale]&&(k._paths=null)});for(let k in C)wt=!0,Zn("setScale",k);vt&&ft.left>=0&&(rt=bt=!0)}for(let k in X)X[k]=null}function qt(E){let C=Lg(An-1,0,bn-1),O=Lg(Rn+1,0,bn-1);for(;E[C]==null&&C>0;)C--;for(;E[O]==null&&O<bn-1;)O++;return[C,O]}function we(){if(bn>0){let E=x.some(C=>C._focus)&&Ut!=Wt.alpha;E&&(h.globalAlpha=Ut=Wt.alpha),x.forEach((C,O)=>{if(O>0&&C.show&&(_n(O,!1),_n(O,!0),C._paths==null)){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha);let Y=s==2?[0,t[O][0].length-1]:qt(t[O]);C._paths=C.paths(i,O,Y[0],Y[1]),Ut!=k&&(h.globalAlpha=Ut=k)}}),x.forEach((C,O)=>{if(O>0&&C.show){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha),C._paths!=null&&We(O,!1);{let Y=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,O,An,Rn,Y),ut=C.points.filter(i,O,tt,Y);(tt||ut)&&(C.points._paths=C.points.paths(i,O,An,Rn,ut),We(O,!0))}Ut!=k&&(h.globalAlpha=Ut=k),Zn("drawSeries",O)}}),E&&(h.globalAlpha=Ut=1)}}function _n(E,C){let O=C?x[E].points:x[E];O._stroke=O.stroke(i,E),O._fill=O.fill(i,E)}function We(E,C){let O=C?x[E].points:x[E],{stroke:k,fill:Y,clip:tt,flags:ut,_stroke:yt=O._stroke,_fill:Et=O._fill,_width:Bt=O.width}=O._paths;Bt=tn(Bt*ke,3);let kt=null,Gt=Bt%2/2;C&&Et==null&&(Et=Bt>0?"#fff":yt);let fe=O.pxAlign==1&&Gt>0;if(fe&&h.translate(Gt,Gt),!C){let Ue=F-Bt/2,De=R-Bt/2,Te=J+Bt,se=mt+Bt;kt=new Path2D,kt.rect(Ue,De,Te,se)}C?Ht(yt,Bt,O.dash,O.cap,Et,k,Y,ut,tt):qe(E,yt,Bt,O.dash,O.cap,Et,k,Y,ut,kt,tt),fe&&h.translate(-Gt,-Gt)}function qe(E,C,O,k,Y,tt,ut,yt,Et,Bt,kt){let Gt=!1;Et!=0&&A.forEach((fe,Ue)=>{if(fe.series[0]==E){let De=x[fe.series[1]],Te=t[fe.series[1]],se=(De._paths||Kc).band;uo(se)&&(se=fe.dir==1?se[0]:se[1]);let Kt,an=null;De.show&&se&&QP(Te,An,Rn)?(an=fe.fill(i,Ue)||tt,Kt=De._paths.clip):se=null,Ht(C,O,k,Y,an,ut,yt,Et,Bt,kt,Kt,se),Gt=!0}}),Gt||Ht(C,O,k,Y,tt,ut,yt,Et,Bt,kt)}let kn=rl|Ug;function Ht(E,C,O,k,Y,tt,ut,yt,Et,Bt,kt,Gt){Lt(E,C,O,k,Y),(Et||Bt||Gt)&&(h.save(),Et&&h.clip(Et),Bt&&h.clip(Bt)),Gt?(yt&kn)==kn?(h.clip(Gt),kt&&h.clip(kt),Re(Y,ut),In(E,tt,C)):yt&Ug?(Re(Y,ut),h.clip(Gt),In(E,tt,C)):yt&rl&&(h.save(),h.clip(Gt),kt&&h.clip(kt),Re(Y,ut),h.restore(),In(E,tt,C)):(Re(Y,ut),In(E,tt,C)),(Et||Bt||Gt)&&h.restore()}function In(E,C,O){O>0&&(C instanceof Map?C.forEach((k,Y)=>{h.strokeStyle=Zo=Y,h.stroke(k)}):C!=null&&E&&h.stroke(C))}function Re(E,C){C instanceof Map?C.forEach((O,k)=>{h.fillStyle=Or=k,h.fill(O)}):C!=null&&E&&h.fill(C)}function ar(E,C,O,k){let Y=w[E],tt;if(k<=0)tt=[0,0];else{let ut=Y._space=Y.space(i,E,C,O,k),yt=Y._incrs=Y.incrs(i,E,C,O,k,ut);tt=v3(C,O,yt,k,ut)}return Y._found=tt}function Ln(E,C,O,k,Y,tt,ut,yt,Et,Bt){let kt=ut%2/2;y==1&&h.translate(kt,kt),Lt(yt,ut,Et,Bt,yt),h.beginPath();let Gt,fe,Ue,De,Te=Y+(k==0||k==3?-tt:tt);O==0?(fe=Y,De=Te):(Gt=Y,Ue=Te);for(let se=0;se<E.length;se++)C[se]!=null&&(O==0?Gt=Ue=E[se]:fe=De=E[se],h.moveTo(Gt,fe),h.lineTo(Ue,De));h.stroke(),y==1&&h.translate(-kt,-kt)}function Jo(E){let C=!0;return w.forEach((O,k)=>{if(!O.show)return;let Y=b[O.scale];if(Y.min==null){O._show&&(C=!1,O._show=!1,ye(!1));return}else O._show||(C=!1,O._show=!0,ye(!1));let tt=O.side,ut=tt%2,{min:yt,max:Et}=Y,[Bt,kt]=ar(k,yt,Et,ut==0?V:Nt);if(kt==0)return;let Gt=Y.distr==2,fe=O._splits=O.splits(i,k,yt,Et,Bt,kt,Gt),Ue=Y.distr==2?fe.map(Kt=>Hi[Kt]):fe,De=Y.distr==2?Hi[fe[1]]-Hi[fe[0]]:Bt,Te=O._values=O.values(i,O.filter(i,Ue,k,kt,De),k,kt,De);O._rotate=tt==2?O.rotate(i,Te,k,kt):0;let se=O._size;O._size=ms(O.size(i,Te,k,E)),se!=null&&O._size!=se&&(C=!1)}),C}function Os(E){let C=!0;return Ml.forEach((O,k)=>{let Y=O(i,k,Us,E);Y!=gs[k]&&(C=!1),gs[k]=Y}),C}function lr(){for(let E=0;E<w.length;E++){let C=w[E];if(!C.show||!C._show)continue;let O=C.side,k=O%2,Y,tt,ut=C.stroke(i,E),yt=O==0||O==3?-1:1,[Et,Bt]=C._found;if(C.label!=null){let gi=C.labelGap*yt,Wi=Vn((C._lpos+gi)*ke);Ft(C.labelFont[0],ut,"center",O==2?"top":Vv),h.save(),k==1?(Y=tt=0,h.translate(Wi,Vn(R+mt/2)),h.rotate((O==3?-cf:cf)/2)):(Y=Vn(F+J/2),tt=Wi);let yo=Lb(C.label)?C.label(i,E,Et,Bt):C.label;h.fillText(yo,Y,tt),h.restore()}if(Bt==0)continue;let kt=b[C.scale],Gt=k==0?J:mt,fe=k==0?F:R,Ue=C._splits,De=kt.distr==2?Ue.map(gi=>Hi[gi]):Ue,Te=kt.distr==2?Hi[Ue[1]]-Hi[Ue[0]]:Et,se=C.ticks,Kt=C.border,an=se.show?se.size:0,Sn=Vn(an*ke),jn=Vn((C.alignTo==2?C._size-an-C.gap:C.gap)*ke),Ye=C._rotate*-cf/180,wn=m(C._pos*ke),Gi=(Sn+jn)*yt,mi=wn+Gi;tt=k==0?mi:0,Y=k==1?mi:0;let is=C.font[0],_s=C.align==1?Qa:C.align==2?bg:Ye>0?Qa:Ye<0?bg:k==0?"center":O==3?bg:Qa,zs=Ye||k==1?"middle":O==2?"top":Vv;Ft(is,ut,_s,zs);let Vi=C.font[1]*C.lineGap,ss=Ue.map(gi=>m(a(gi,kt,Gt,fe))),xs=C._values;for(let gi=0;gi<xs.length;gi++){let Wi=xs[gi];if(Wi!=null){k==0?Y=ss[gi]:tt=ss[gi],Wi=""+Wi;let yo=Wi.indexOf(`
`)==-1?[Wi]:Wi.split(/\n/gm);for(let _i=0;_i<yo.length;_i++){let j0=yo[_i];Ye?(h.save(),h.translate(Y,tt+_i*Vi),h.rotate(Ye),h.fillText(j0,0,0),h.restore()):h.fillText(j0,Y,tt+_i*Vi)}}}se.show&&Ln(ss,se.filter(i,De,E,Bt,Te),k,O,wn,Sn,tn(se.width*ke,3),se.stroke(i,E),se.dash,se.cap);let Hs=C.grid;Hs.show&&Ln(ss,Hs.filter(i,De,E,Bt,Te),k,k==0?2:1,k==0?R:F,k==0?mt:J,tn(Hs.width*ke,3),Hs.stroke(i,E),Hs.dash,Hs.cap),Kt.show&&Ln([wn],[1],k==0?1:0,k==0?1:2,k==1?R:F,k==1?mt:J,tn(Kt.width*ke,3),Kt.stroke(i,E),Kt.dash,Kt.cap)}Zn("drawAxes")}function ye(E){x.forEach((C,O)=>{O>0&&(C._paths=null,E&&(s==1?(C.min=null,C.max=null):C.facets.forEach(k=>{k.min=null,k.max=null})))})}let Mn=!1,pi=!1,$e=[];function Dn(){pi=!1;for(let E=0;E<$e.length;E++)Zn(...$e[E]);$e.length=0}function oi(){Mn||(fI(L0),Mn=!0)}function lu(E,C=!1){Mn=!0,pi=C,E(i),L0(),C&&$e.length>0&&queueMicrotask(Dn)}i.batch=lu;function L0(){if(ct&&(Se(),ct=!1),wt&&(Pt(),wt=!1),St){if(un(f,Qa,ne),un(f,"top",me),un(f,Yc,V),un(f,Zc,Nt),un(p,Qa,ne),un(p,"top",me),un(p,Yc,V),un(p,Zc,Nt),un(d,Yc,vn),un(d,Zc,Pn),u.width=Vn(vn*ke),u.height=Vn(Pn*ke),w.forEach(({_el:E,_show:C,_size:O,_pos:k,side:Y})=>{if(E!=null)if(C){let tt=Y===3||Y===0?O:0,ut=Y%2==1;un(E,ut?"left":"top",k-tt),un(E,ut?"width":"height",O),un(E,ut?"top":"left",ut?me:ne),un(E,ut?"height":"width",ut?Nt:V),Pg(E,zo)}else ts(E,zo)}),Zo=Or=jo=$=nt=K=Q=It=P=null,Ut=1,Al(!0),ne!=Ct||me!=je||V!=Yt||Nt!=Qt){ye(!1);let E=V/Yt,C=Nt/Qt;if(vt&&!rt&&ft.left>=0){ft.left*=E,ft.top*=C,Ko&&ir(Ko,Vn(ft.left),0,V,Nt),Qo&&ir(Qo,0,Vn(ft.top),V,Nt);for(let O=0;O<ge.length;O++){let k=ge[O];k!=null&&(sn[O]*=E,fi[O]*=C,ir(k,ms(sn[O]),ms(fi[O]),V,Nt))}}if(on.show&&!at&&on.left>=0&&on.width>0){on.left*=E,on.width*=E,on.top*=C,on.height*=C;for(let O in Qf)un(na,O,on[O])}Ct=ne,je=me,Yt=V,Qt=Nt}Zn("setSize"),St=!1}vn>0&&Pn>0&&(h.clearRect(0,0,u.width,u.height),Zn("drawClear"),S.forEach(E=>E()),Zn("draw")),on.show&&at&&(cu(on),at=!1),vt&&rt&&(xo(null,!0,!1),rt=!1),ht.show&&ht.live&&bt&&(Jf(),bt=!1),l||(l=!0,i.status=1,Zn("ready")),Fr=!1,Mn=!1}i.redraw=(E,C)=>{wt=C||!1,E!==!1?kr(T,N.min,N.max):oi()};function Yf(E,C){let O=b[E];if(O.from==null){if(bn==0){let k=O.range(i,C.min,C.max,E);C.min=k[0],C.max=k[1]}if(C.min>C.max){let k=C.min;C.min=C.max,C.max=k}if(bn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;E==T&&O.distr==2&&bn>0&&(C.min=Ls(C.min,t[0]),C.max=Ls(C.max,t[0]),C.min==C.max&&C.max++),X[E]=C,ct=!0,oi()}}i.setScale=Yf;let Zf,jf,Ko,Qo,D0,N0,ta,ea,U0,F0,rn,dn,Br=!1,ei=ft.drag,Xn=ei.x,Yn=ei.y;vt&&(ft.x&&(Zf=ps(OP,p)),ft.y&&(jf=ps(BP,p)),N.ori==0?(Ko=Zf,Qo=jf):(Ko=jf,Qo=Zf),rn=ft.left,dn=ft.top);let on=i.select=On({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),na=on.show?ps(FP,on.over?p:f):null;function cu(E,C){if(on.show){for(let O in E)on[O]=E[O],O in Qf&&un(na,O,E[O]);C!==!1&&Zn("setSelect")}}i.setSelect=cu;function ew(E){if(x[E].show)it&&Pg(pe[E],zo);else if(it&&ts(pe[E],zo),vt){let O=Dt?ge[0]:ge[E];O!=null&&ir(O,-10,-10,V,Nt)}}function kr(E,C,O){Yf(E,{min:C,max:O})}function Bs(E,C,O,k){C.focus!=null&&ow(E),C.show!=null&&x.forEach((Y,tt)=>{tt>0&&(E==tt||E==null)&&(Y.show=C.show,ew(tt),s==2?(kr(Y.facets[0].scale,null,null),kr(Y.facets[1].scale,null,null)):kr(Y.scale,null,null),oi())}),O!==!1&&Zn("setSeries",E,C),k&&Rl("setSeries",i,E,C)}i.setSeries=Bs;function nw(E,C){On(A[E],C)}function iw(E,C){E.fill=Ie(E.fill||null),E.dir=Ne(E.dir,-1),C=C??A.length,A.splice(C,0,E)}function sw(E){E==null?A.length=0:A.splice(E,1)}i.addBand=iw,i.setBand=nw,i.delBand=sw;function rw(E,C){x[E].alpha=C,vt&&ge[E]!=null&&(ge[E].style.opacity=C),it&&pe[E]&&(pe[E].style.opacity=C)}let cr,zr,_o,ia={focus:!0};function ow(E){if(E!=_o){let C=E==null,O=Wt.alpha!=1;x.forEach((k,Y)=>{if(s==1||Y>0){let tt=C||Y==0||Y==E;k._focus=C?null:tt,O&&rw(Y,tt?1:Wt.alpha)}}),_o=E,O&&oi()}}it&&ae&&Le(Xv,Tt,E=>{ft._lock||(oe(E),_o!=null&&Bs(null,ia,!0,Nn.setSeries))});function ks(E,C,O){let k=b[C];O&&(E=E/ke-(k.ori==1?me:ne));let Y=V;k.ori==1&&(Y=Nt,E=Y-E),k.dir==-1&&(E=Y-E);let tt=k._min,ut=k._max,yt=E/Y,Et=tt+(ut-tt)*yt,Bt=k.distr;return Bt==3?nl(10,Et):Bt==4?eI(Et,k.asinh):Bt==100?k.bwd(Et):Et}function aw(E,C){let O=ks(E,T,C);return Ls(O,t[0],An,Rn)}i.valToIdx=E=>Ls(E,t[0]),i.posToIdx=aw,i.posToVal=ks,i.valToPos=(E,C,O)=>b[C].ori==0?r(E,b[C],O?J:V,O?F:0):o(E,b[C],O?mt:Nt,O?R:0),i.setCursor=(E,C,O)=>{rn=E.left,dn=E.top,xo(null,C,O)};function O0(E,C){un(na,Qa,on.left=E),un(na,Yc,on.width=C)}function B0(E,C){un(na,"top",on.top=E),un(na,Zc,on.height=C)}let El=N.ori==0?O0:B0,Tl=N.ori==1?O0:B0;function lw(){if(it&&ht.live)for(let E=s==2?1:0;E<x.length;E++){if(E==0&&xe)continue;let C=ht.values[E],O=0;for(let k in C)Zt[E][O++].firstChild.nodeValue=C[k]}}function Jf(E,C){if(E!=null&&(E.idxs?E.idxs.forEach((O,k)=>{et[k]=O}):rI(E.idx)||et.fill(E.idx),ht.idx=et[0]),it&&ht.live){for(let O=0;O<x.length;O++)(O>0||s==1&&!xe)&&cw(O,et[O]);lw()}bt=!1,C!==!1&&Zn("setLegend")}i.setLegend=Jf;function cw(E,C){let O=x[E],k=E==0&&z==2?Hi:t[E],Y;xe?Y=O.values(i,E,C)??de:(Y=O.value(i,C==null?null:k[C],E,C),Y=Y==null?de:{_:Y}),ht.values[E]=Y}function xo(E,C,O){U0=rn,F0=dn,[rn,dn]=ft.move(i,rn,dn),ft.left=rn,ft.top=dn,vt&&(Ko&&ir(Ko,Vn(rn),0,V,Nt),Qo&&ir(Qo,0,Vn(dn),V,Nt));let k,Y=An>Rn;cr=Qe,zr=null;let tt=N.ori==0?V:Nt,ut=N.ori==1?V:Nt;if(rn<0||bn==0||Y){k=ft.idx=null;for(let yt=0;yt<x.length;yt++){let Et=ge[yt];Et!=null&&ir(Et,-10,-10,V,Nt)}ae&&Bs(null,ia,!0,E==null&&Nn.setSeries),ht.live&&(et.fill(k),bt=!0)}else{let yt,Et,Bt;s==1&&(yt=N.ori==0?rn:dn,Et=ks(yt,T),k=ft.idx=Ls(Et,t[0],An,Rn),Bt=W(t[0][k],N,tt,0));let kt=-10,Gt=-10,fe=0,Ue=0,De=!0,Te="",se="";for(let Kt=s==2?1:0;Kt<x.length;Kt++){let an=x[Kt],Sn=et[Kt],jn=Sn==null?null:s==1?t[Kt][Sn]:t[Kt][1][Sn],Ye=ft.dataIdx(i,Kt,k,Et),wn=Ye==null?null:s==1?t[Kt][Ye]:t[Kt][1][Ye];if(bt=bt||wn!=jn||Ye!=Sn,et[Kt]=Ye,Kt>0&&an.show){let Gi=Ye==null?-10:Ye==k?Bt:W(s==1?t[0][Ye]:t[Kt][0][Ye],N,tt,0),mi=wn==null?-10:B(wn,s==1?b[an.scale]:b[an.facets[1].scale],ut,0);if(ae&&wn!=null){let is=N.ori==1?rn:dn,_s=Wn(Wt.dist(i,Kt,Ye,mi,is));if(_s<cr){let zs=Wt.bias;if(zs!=0){let Vi=ks(is,an.scale),ss=wn>=0?1:-1,xs=Vi>=0?1:-1;xs==ss&&(xs==1?zs==1?wn>=Vi:wn<=Vi:zs==1?wn<=Vi:wn>=Vi)&&(cr=_s,zr=Kt)}else cr=_s,zr=Kt}}if(bt||Dt){let is,_s;N.ori==0?(is=Gi,_s=mi):(is=mi,_s=Gi);let zs,Vi,ss,xs,Hs,gi,Wi=!0,yo=pt.bbox;if(yo!=null){Wi=!1;let _i=yo(i,Kt);ss=_i.left,xs=_i.top,zs=_i.width,Vi=_i.height}else ss=is,xs=_s,zs=Vi=pt.size(i,Kt);if(gi=pt.fill(i,Kt),Hs=pt.stroke(i,Kt),Dt)Kt==zr&&cr<=Wt.prox&&(kt=ss,Gt=xs,fe=zs,Ue=Vi,De=Wi,Te=gi,se=Hs);else{let _i=ge[Kt];_i!=null&&(sn[Kt]=ss,fi[Kt]=xs,tb(_i,zs,Vi,Wi),Kv(_i,gi,Hs),ir(_i,ms(ss),ms(xs),V,Nt))}}}}if(Dt){let Kt=Wt.prox,an=_o==null?cr<=Kt:cr>Kt||zr!=_o;if(bt||an){let Sn=ge[0];Sn!=null&&(sn[0]=kt,fi[0]=Gt,tb(Sn,fe,Ue,De),Kv(Sn,Te,se),ir(Sn,ms(kt),ms(Gt),V,Nt))}}}if(on.show&&Br)if(E!=null){let[yt,Et]=Nn.scales,[Bt,kt]=Nn.match,[Gt,fe]=E.cursor.sync.scales,Ue=E.cursor.drag;if(Xn=Ue._x,Yn=Ue._y,Xn||Yn){let{left:De,top:Te,width:se,height:Kt}=E.select,an=E.scales[Gt].ori,Sn=E.posToVal,jn,Ye,wn,Gi,mi,is=yt!=null&&Bt(yt,Gt),_s=Et!=null&&kt(Et,fe);is&&Xn?(an==0?(jn=De,Ye=se):(jn=Te,Ye=Kt),wn=b[yt],Gi=W(Sn(jn,Gt),wn,tt,0),mi=W(Sn(jn+Ye,Gt),wn,tt,0),El(Ds(Gi,mi),Wn(mi-Gi))):El(0,tt),_s&&Yn?(an==1?(jn=De,Ye=se):(jn=Te,Ye=Kt),wn=b[Et],Gi=B(Sn(jn,fe),wn,ut,0),mi=B(Sn(jn+Ye,fe),wn,ut,0),Tl(Ds(Gi,mi),Wn(mi-Gi))):Tl(0,ut)}else tp()}else{let yt=Wn(U0-D0),Et=Wn(F0-N0);if(N.ori==1){let fe=yt;yt=Et,Et=fe}Xn=ei.x&&yt>=ei.dist,Yn=ei.y&&Et>=ei.dist;let Bt=ei.uni;Bt!=null?Xn&&Yn&&(Xn=yt>=Bt,Yn=Et>=Bt,!Xn&&!Yn&&(Et>yt?Yn=!0:Xn=!0)):ei.x&&ei.y&&(Xn||Yn)&&(Xn=Yn=!0);let kt,Gt;Xn&&(N.ori==0?(kt=ta,Gt=rn):(kt=ea,Gt=dn),El(Ds(kt,Gt),Wn(Gt-kt)),Yn||Tl(0,ut)),Yn&&(N.ori==1?(kt=ta,Gt=rn):(kt=ea,Gt=dn),Tl(Ds(kt,Gt),Wn(Gt-kt)),Xn||El(0,tt)),!Xn&&!Yn&&(El(0,0),Tl(0,0))}if(ei._x=Xn,ei._y=Yn,E==null){if(O){if(Z0!=null){let[yt,Et]=Nn.scales;Nn.values[0]=yt!=null?ks(N.ori==0?rn:dn,yt):null,Nn.values[1]=Et!=null?ks(N.ori==1?rn:dn,Et):null}Rl(Mg,i,rn,dn,V,Nt,k)}if(ae){let yt=O&&Nn.setSeries,Et=Wt.prox;_o==null?cr<=Et&&Bs(zr,ia,!0,yt):cr>Et?Bs(null,ia,!0,yt):zr!=_o&&Bs(zr,ia,!0,yt)}}bt&&(ht.idx=k,Jf()),C!==!1&&Zn("setCursor")}let Hr=null;Object.defineProperty(i,"rect",{get(){return Hr==null&&Al(!1),Hr}});function Al(E=!1){E?Hr=null:(Hr=p.getBoundingClientRect(),Zn("syncRect",Hr))}function k0(E,C,O,k,Y,tt,ut){ft._lock||Br&&E!=null&&E.movementX==0&&E.movementY==0||(Kf(E,C,O,k,Y,tt,ut,!1,E!=null),E!=null?xo(null,!0,!0):xo(C,!0,!1))}function Kf(E,C,O,k,Y,tt,ut,yt,Et){if(Hr==null&&Al(!1),oe(E),E!=null)O=E.clientX-Hr.left,k=E.clientY-Hr.top;else{if(O<0||k<0){rn=-10,dn=-10;return}let[Bt,kt]=Nn.scales,Gt=C.cursor.sync,[fe,Ue]=Gt.values,[De,Te]=Gt.scales,[se,Kt]=Nn.match,an=C.axes[0].side%2==1,Sn=N.ori==0?V:Nt,jn=N.ori==1?V:Nt,Ye=an?tt:Y,wn=an?Y:tt,Gi=an?k:O,mi=an?O:k;if(De!=null?O=se(Bt,De)?a(fe,b[Bt],Sn,0):-10:O=Sn*(Gi/Ye),Te!=null?k=Kt(kt,Te)?a(Ue,b[kt],jn,0):-10:k=jn*(mi/wn),N.ori==1){let is=O;O=k,k=is}}Et&&(C==null||C.cursor.event.type==Mg)&&((O<=1||O>=V-1)&&(O=Bo(O,V)),(k<=1||k>=Nt-1)&&(k=Bo(k,Nt))),yt?(D0=O,N0=k,[ta,ea]=ft.move(i,O,k)):(rn=O,dn=k)}let Qf={width:0,height:0,left:0,top:0};function tp(){cu(Qf,!1)}let z0,H0,G0,V0;function W0(E,C,O,k,Y,tt,ut){Br=!0,Xn=Yn=ei._x=ei._y=!1,Kf(E,C,O,k,Y,tt,ut,!0,!1),E!=null&&(Le(Sg,Rg,q0,!1),Rl(qv,i,ta,ea,V,Nt,null));let{left:yt,top:Et,width:Bt,height:kt}=on;z0=yt,H0=Et,G0=Bt,V0=kt}function q0(E,C,O,k,Y,tt,ut){Br=ei._x=ei._y=!1,Kf(E,C,O,k,Y,tt,ut,!1,!0);let{left:yt,top:Et,width:Bt,height:kt}=on,Gt=Bt>0||kt>0,fe=z0!=yt||H0!=Et||G0!=Bt||V0!=kt;if(Gt&&fe&&cu(on),ei.setScale&&Gt&&fe){let Ue=yt,De=Bt,Te=Et,se=kt;if(N.ori==1&&(Ue=Et,De=kt,Te=yt,se=Bt),Xn&&kr(T,ks(Ue,T),ks(Ue+De,T)),Yn)for(let Kt in b){let an=b[Kt];Kt!=T&&an.from==null&&an.min!=Qe&&kr(Kt,ks(Te+se,Kt),ks(Te,Kt))}tp()}else ft.lock&&(ft._lock=!ft._lock,xo(C,!0,E!=null));E!=null&&(Bn(Sg,Rg),Rl(Sg,i,rn,dn,V,Nt,null))}function uw(E,C,O,k,Y,tt,ut){if(ft._lock)return;oe(E);let yt=Br;if(Br){let Et=!0,Bt=!0,kt=10,Gt,fe;N.ori==0?(Gt=Xn,fe=Yn):(Gt=Yn,fe=Xn),Gt&&fe&&(Et=rn<=kt||rn>=V-kt,Bt=dn<=kt||dn>=Nt-kt),Gt&&Et&&(rn=rn<ta?0:V),fe&&Bt&&(dn=dn<ea?0:Nt),xo(null,!0,!0),Br=!1}rn=-10,dn=-10,et.fill(null),xo(null,!0,!0),yt&&(Br=yt)}function $0(E,C,O,k,Y,tt,ut){ft._lock||(oe(E),wl(),tp(),E!=null&&Rl(Yv,i,rn,dn,V,Nt,null))}function X0(){w.forEach(b3),G(i.width,i.height,!0)}Ho(uf,el,X0);let sa={};sa.mousedown=W0,sa.mousemove=k0,sa.mouseup=q0,sa.dblclick=$0,sa.setSeries=(E,C,O,k)=>{let Y=Nn.match[2];O=Y(i,C,O),O!=-1&&Bs(O,k,!0,!1)},vt&&(Le(qv,p,W0),Le(Mg,p,k0),Le($v,p,E=>{oe(E),Al(!1)}),Le(Xv,p,uw),Le(Yv,p,$0),Fg.add(i),i.syncRect=Al);let uu=i.hooks=n.hooks||{};function Zn(E,C,O){pi?$e.push([E,C,O]):E in uu&&uu[E].forEach(k=>{k.call(null,i,C,O)})}(n.plugins||[]).forEach(E=>{for(let C in E.hooks)uu[C]=(uu[C]||[]).concat(E.hooks[C])});let Y0=(E,C,O)=>O,Nn=On({key:null,setSeries:!1,filters:{pub:rb,sub:rb},scales:[T,x[1]?x[1].scale:null],match:[ob,ob,Y0],values:[null,null]},ft.sync);Nn.match.length==2&&Nn.match.push(Y0),ft.sync=Nn;let Z0=Nn.key,ep=nM(Z0);function Rl(E,C,O,k,Y,tt,ut){Nn.filters.pub(E,C,O,k,Y,tt,ut)&&ep.pub(E,C,O,k,Y,tt,ut)}ep.sub(i);function hw(E,C,O,k,Y,tt,ut){Nn.filters.sub(E,C,O,k,Y,tt,ut)&&sa[E](null,C,O,k,Y,tt,ut)}i.pub=hw;function dw(){ep.unsub(i),Fg.delete(i),$n.clear(),Ig(uf,el,X0),c.remove(),Tt?.remove(),Zn("destroy")}i.destroy=dw;function np(){Zn("init",n,t),Sl(t||n.data,!1),X[T]?Yf(T,X[T]):wl(),at=on.show&&(on.width>0||on.height>0),rt=bt=!0,G(n.width,n.height)}return x.forEach(Yo),w.forEach(rr),e?e instanceof HTMLElement?(e.appendChild(c),np()):e(i,np):np(),i}ri.assign=On;ri.fmtNum=Vg;ri.rangeNum=hf;ri.rangeLog=pf;ri.rangeAsinh=Hg;ri.orient=Vo;ri.pxRatio=ke;ri.join=dI;ri.fmtDate=qg,ri.tzDate=SI;ri.sync=nM;{ri.addGap=r3,ri.clipGaps=_f;let n=ri.paths={points:lM};n.linear=uM,n.stepped=l3,n.bars=c3,n.spline=h3}var Kg={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},pM={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},bf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,mM=80;function M3(n){let t=[];bf.lastIndex=0;let e=n.trimEnd();for(;bf.lastIndex<e.length;){let i=bf.lastIndex,s=bf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function S3(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Mf(n,t="plain"){let e=S3(String(n));if(e.length>mM)throw new Error(`longer than ${mM} characters`);let i=M3(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in _t.suffix(t)&&(s=_t.suffix(t)[r.word],i.pop());let o=0,a=!1,l=g=>i[o]?.sign===g,c=g=>{if(!l(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;l("+")||l("-");){let x=i[o++].sign,w=h();g=x==="+"?g+w:g-w}return g}function h(){let g=d();for(;;)if(l("*"))o++,g*=d();else if(l("/"))o++,g/=d();else if(i[o]?.word||l("("))g*=f();else return g}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let g=p();return l("^")?(o++,g**d()):g}function p(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let x=u();return c(")"),x}if(g.word){let x=g.word.toLowerCase();if(Object.hasOwn(pM,x))return a=!0,pM[x];if(Object.hasOwn(Kg,x)){c("(");let w=u();return c(")"),Kg[x](w)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(Kg).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let y=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(y))throw new Error("not a finite number");let m=s??(t==="angle"&&a?1:_t.factor(t));return{value:y/m+0,symbolic:a||s!==null||i.length>2}}function Tn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=v("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let m=Mf(c.value,l()),g=a?.(m.value);if(g)throw new Error(g);return m},f=m=>{c.classList.toggle("wrong",!!m),m?(c.setAttribute("aria-invalid","true"),c.title=m):(c.removeAttribute("aria-invalid"),c.title=o??""),Qg(c,m),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:m?{label:n,reason:m}:null}))},p=m=>{try{let g=d();return f(null),m?.(g.value,{symbolic:g.symbolic,text:c.value.trim()}),!0}catch(g){return f(g.message),!1}};c.addEventListener("input",()=>p(e)),c.addEventListener("change",()=>{p(i??e)&&c.blurred?.()});let y="";return c.addEventListener("focus",()=>{y=c.value,c.classList.contains("wrong")&&Qg(c,c.title),c.select()}),c.addEventListener("blur",()=>Qg(c,null)),c.addEventListener("keydown",m=>{let g=c.closest("table.dh");if(m.key==="Escape"&&c.value!==y){m.preventDefault(),c.value=y,p(i??e),c.select();return}if(g&&w3(c,m))return;let x={ArrowUp:1,ArrowDown:-1}[m.key];if(m.key==="Enter"&&(y=c.value,c.select()),!(!x||g&&!m.altKey)){m.preventDefault();try{let w=d();c.value=Lc((w.value??0)+x*_t.step(l())*(m.shiftKey?.1:1),l()),p(i??e)}catch{}}}),c.put=(m,g=null)=>{document.activeElement===c&&!c.readOnly||m===u&&g===h&&!c.classList.contains("wrong")||(u=m,h=g,c.value=g??(m==null?"":Lc(m,l())),t0(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>t0(c)),c.refresh=()=>{let m=u,g=h;u=NaN,c.put(m,g)},c}function t0(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&t0(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Ci=null;function Qg(n,t){if(!t){Ci&&Ci.about===n&&(Ci.hidden=!0),n.removeAttribute("aria-describedby");return}Ci||(Ci=v("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Ci)),Ci.about=n,Ci.hidden=!1,Ci.textContent!==t&&(Ci.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Ci.style.setProperty("top",`${e.bottom+4}px`),Ci.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Ci.offsetWidth-8))}px`)}addEventListener("scroll",()=>Ci&&(Ci.hidden=!0),!0);function w3(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function Sf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function wf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Ze=n=>n.type==="R"?"angle":"length";function gM(n){let t=n.type==="R"?Math.PI:ai(M.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var E3=Vm;function T3(n){let t=M.table.joints[n],e=Ze(t),{lo:i,hi:s,min:r,max:o}=gM(t),a=`q${n+1}`,l=v("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=y=>`${100*(y-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{hi(),gu(n,Number(l.value))}),l.addEventListener("keydown",y=>{let m={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[y.key],g={Home:i,End:s}[y.key];if(m===void 0&&g===void 0)return;y.preventDefault(),hi();let x=_t.step(e)*(y.shiftKey?.1:1);gu(n,g??Math.min(Math.max(Math.round((M.q[n]+m*x)/(x/10))*(x/10),r),o))});let u=Tn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:y=>{hi(),gu(n,y)}}),h=v("span",{class:"out",role:"note"}),d=v("span",{class:"chain",title:"What this row of the table moves by"}),f=v("span",{class:"limits"}),p=v("div",{class:"joint","data-testid":`joint-${n+1}`},v("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},v("i",{text:"q"}),v("sub",{text:String(n+1)})),v("div",{class:"track"},l,v("div",{class:"under"},f,d,h)),u,v("span",{class:"unit"}));return{el:p,number:u,show(){let y=M.q[n],m=E3(t,y);(document.activeElement!==l||Number(l.value)!==y)&&(l.value=y),l.style.setProperty("--at",c(Math.min(Math.max(y,r),o))),l.setAttribute("aria-valuetext",ue(y,e)),u.put(Number((y*_t.factor(e)).toFixed(_t.digits(e)+1))/_t.factor(e)),p.classList.toggle("outside",m!==0);let g=M.table.coupling?`chain ${ue(dr(M.table,M.q)[n],e)}`:"";gt(d,g),gt(h,m?`${ue(Math.abs(m),e)} ${m>0?"above":"below"} the limit`:"")},relabel(){gt(p.lastChild,_t.symbol(e));let y=m=>m===null?"no limit":ue(m,e,_t.angle==="deg"&&e==="angle"?0:void 0);gt(f,t.lower===null&&t.upper===null?"no limits":`${y(t.lower)} \u2026 ${y(t.upper)}`),u.refresh(),this.show()}}}var _M={id:"joints",title:"Joints",build(n){let t=[],e=v("div",{class:"joints","data-testid":"joints"}),i=v("div",{class:"chips",role:"group","aria-label":"Postures"}),s=v("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=M.table.joints.map((o,a)=>T3(a)),Vt(e,t.map(o=>o.el)),t.length||e.append(v("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Vt(s,M.table.actuator?A3(M.table.actuator):null),R3(i)};st("table",o=>o!=="gripper"&&r()),st("q",()=>t.forEach(o=>o.show())),st("units",()=>t.forEach(o=>o.relabel())),r()}};function A3(n){let t=v("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=v("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),gt(e,Qn(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},fn({...M.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=v("div",{class:"under"},v("span",{text:`${n.name}: moves no frame`}));return v("div",{class:"joint"},v("span",{class:"joint-name",text:"tool"}),v("div",{class:"track"},t,s),e,v("span",{class:"unit",text:n.unit}))}function R3(n){let t=M.table.joints.length,e=Object.entries(M.table.postures??{}),i=(r,o)=>v("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>ue(a,Ze(M.table.joints[l]))).join(", "),on:{click:()=>Ai(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Vt(n,s,t?v("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>Ai(C3(),.8,"move to a random posture")}}):null,t?v("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:P3}}):null)}function C3(){return M.table.joints.map(n=>{let{lo:t,hi:e}=gM(n);return t+Math.random()*(e-t)})}function P3(){let n={...M.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=M.q.slice(),fn({...M.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),Fe(`Kept as P${t}: ${M.q.map((e,i)=>Lc(e,Ze(M.table.joints[i]))).join(", ")}`),dt("postures")}var xM=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function sr({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(u=>ys(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(u=>te(u[u.length-1])),speeds:o??I3(t,r),least:t.map((u,h)=>mu(n,u,c[h])[0]??0)}}function I3(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function e0(n,t){let{table:e}=n,i=_t.factor("length");if(t==="position")return{y:`tool, ${_t.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(u=>u[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(Ze))].map(l=>(l==="angle"?_t.angle:_t.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(u=>u[c]*_t.factor(Ze(l)))}))}}function yM(n){let t=_t.angle,e=_t.length,{table:i}=n,s=l=>Ze(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*_t.factor("length")),...l.map((u,h)=>u*_t.factor(Ze(i.joints[h]))),...n.speeds[c].map((u,h)=>u*_t.factor(Ze(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function vM(n,t,e){let{y:i,list:s}=e0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(_=>_.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,p]=[Math.min(...c),Math.max(...c)];p-f>1e-9||(f-=1,p+=1);let y=_=>a.l+(_-h)/(d-h)*(r-a.l-a.r),m=_=>o-a.b-(_-f)/(p-f)*(o-a.t-a.b),g=(_,S)=>{let D=(S-_)/6,L=10**Math.floor(Math.log10(D)),N=[1,2,5,10].map(z=>z*L).find(z=>z>=D);return Array.from({length:12},(z,W)=>(Math.ceil(_/N)+W)*N).filter(z=>z<=S+N*1e-6)},x=_=>_.toFixed(2),w=_=>String(Number(_.toPrecision(6))),b=_=>_.replace(/[&<>"]/g,S=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[S]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],T=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${b(n.title)}</text>`];for(let _ of g(f,p))T.push(`<path d="M${a.l} ${x(m(_))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(m(_)+4)}" text-anchor="end">${w(_)}</text>`);for(let _ of g(h,d))T.push(`<path d="M${x(y(_))} ${o-a.b}v5" stroke="#333"/><text x="${x(y(_))}" y="${o-a.b+20}" text-anchor="middle">${w(_)}</text>`);T.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let _ of n.events)Number.isFinite(_.x)&&T.push(`<path d="M${x(y(_.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(y(_.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${b(_.short)}</text>`);return s.forEach((_,S)=>{let D=e[S%e.length],L=_.values[_.values.length-1];T.push(`<polyline fill="none" stroke="${D}" stroke-width="1.8" stroke-dasharray="${A[S%A.length]}" points="${_.values.map((N,z)=>`${x(y(l[z]))},${x(m(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*S}h22" stroke="${D}" stroke-width="2" stroke-dasharray="${A[S%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*S}"><title>${x(L)}</title>${b(_.name)}</text>`)}),T.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${b(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${b(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${T.join("")}</svg>
`}async function bM(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var Ve=null,qn=null,cl="joints",Bi=0,MM=1,di=null;function SM(n){let t=v("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:EM}}),e=v("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{hi(),Ur(Number(e.value))}}}),i=v("output",{class:"where","data-testid":"where"}),s=v("div",{class:"marks"}),r=v("div",{class:"chart","data-testid":"chart"}),o=v("div",{class:"legend"});n.append(v("div",{class:"dock-bar"},t,pn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{MM=Number(a)},{"data-testid":"speed"}),v("div",{class:"scrubber"},e,s),i,v("span",{class:"line"},...[["CSV",()=>yi("motion.csv",yM(Ve),"text/csv")],["PNG",N3],["Film",D3],["SVG",()=>yi(`${cl}.svg`,vM(Ve,cl,zt.curves),"image/svg+xml")]].map(([a,l])=>v("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>Ve&&l()}})),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>Pi(null)}}))),v("div",{class:"dock-bar second"},nn("Curves",xM,cl,a=>{cl=a,n0()},"curves"),o),r),di={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(qs(()=>qn&&r.clientWidth&&qn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),st(["units","theme"],n0),st("moving",a=>gt(t,a&&Tf?"Pause":"Play")),st("table",a=>{Ve&&!["postures","name","gripper"].includes(a)&&Pi(null)})}function Pi(n){if(hi(),Ve=n,M.motion=n,di.root.hidden=!n,qn&&(qn.destroy(),qn=null),_v(n?.table??null,n?.q??[]),!n){dt("motion");return}di.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Vt(di.marks,n.events.map(e=>{let i=v("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=v("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),n0(),dt("motion"),n.q.length&&Ur(0),requestAnimationFrame(()=>$a())}var wM=()=>Bi;function Ur(n){Ve?.q.length&&(Bi=Math.min(Math.max(Math.round(n),0),Ve.q.length-1),di.scrub.value=String(Bi),di.scrub.style.setProperty("--at",`${Ve.q.length>1?100*Bi/(Ve.q.length-1):0}%`),gt(di.where,Ve.xName==="point"?`point ${Bi+1} of ${Ve.q.length}`:`${Qn(Ve.xs[Bi],2)} s of ${Qn(Ve.xs[Ve.xs.length-1],2)} s`),di.scrub.setAttribute("aria-valuetext",di.where.textContent),Li(Ve.q[Bi].slice(),"scrub"),dt("played",Ve.seconds[Bi]),i0())}var Tf=!1;function EM(n,t){if(Tf){hi();return}if(!Ve?.q.length)return;let e=Ve.seconds,i=e[e.length-1]||1,s=Bi>=Ve.q.length-1?0:e[Bi]/i;Tf=!0,Iv(i/MM,s,r=>{let o=Bi<=Ve.q.length-1&&e[Bi]<=r*i?Bi:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;Ur(o)},()=>{Tf=!1,gt(di.toggle,"Play"),t?.()}),gt(di.toggle,"Pause")}function n0(){if(!Ve||!di)return;qn&&(qn.destroy(),qn=null);let{y:n,list:t}=e0(Ve,cl),e={stroke:zt.line,width:1},i=`${Math.round(.78*Ef())}px "Inter Variable", system-ui, sans-serif`;Vt(di.legend,t.map((o,a)=>{let l=v("span",{class:"swatch"});return l.style.setProperty("background",zt.curves[a%zt.curves.length]),v("span",{},l,o.name)}));let s={stroke:zt.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*Ef(),gap:4};qn=new ri({width:di.chart.clientWidth||600,height:di.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,Ve.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:zt.curves[a%zt.curves.length],width:1.75,pxAlign:0,points:{show:Ve.q.length<3}}))],axes:[{...s,label:Ve.xName==="point"?"point number":"time, s",size:2.1*Ef()},{...s,label:n,size:4*Ef()}]},[Ve.xs,...t.map(o=>o.values)],di.chart);let r=v("div",{class:"now"});qn.over.append(r,...Ve.events.map(o=>{let a=v("div",{class:`event ${o.stop?"stop":""}`,title:o.text},v("span",{text:o.short}));return a.x=o.x,a})),qn.over.addEventListener("pointerdown",o=>{let a=u=>Ur(L3(qn.posToVal(u.clientX-qn.over.getBoundingClientRect().left,"x")));hi(),a(o);let l=u=>a(u),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),qn.hooks.setSize=[i0],i0()}var Ef=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),L3=n=>Ve.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(Ve.xs[t]-n)?i:t,0);function i0(){if(!qn)return;let n=qn.over.clientWidth;for(let t of qn.over.querySelectorAll(".now, .event")){let e=qn.valToPos(t.x??Ve.xs[Bi],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}async function D3(){hi(),Ur(0);try{let n=await qa(t=>bM(t,()=>new Promise(e=>EM(null,e))));yi("motion.webm",n)}catch(n){Fe(n.message,"wrong")}}function N3(){let n=qn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=zt.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>yi(`${cl}.png`,i))}function hl(n,t){let e=Array.from({length:16},(s,r)=>v("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=v("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>v("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;gt(e[r],r>=12?String(s[r]):o?Qn(s[r]*_t.factor("length"),_t.digits("length")):Qn(s[r],4))}},i}var Af=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var s0="pieper-panel-width",r0=18,TM=70;function AM(n,t){let e=v("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(r0),"aria-valuemax":String(TM),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,r0),TM,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(s0):localStorage.setItem(s0,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(s0));o>=r0?r(o):e.setAttribute("aria-valuenow","38")}function RM(n){let t=hl("Pose of the tool, large","present-pose"),e=v("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=v("button",{type:"button",text:"Present","aria-pressed":"false","data-testid":"present",on:{click:()=>o(i.dataset.present!=="yes")}}),r=()=>!e.hidden&&t.show(M.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),dt("units"),dispatchEvent(new Event("resize"))}return st(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function CM(){qa(n=>n.toBlob(t=>t?yi(`${M.table.name||"arm"}.png`,t):Fe("The picture could not be read.","wrong")))}var U3="http://www.w3.org/2000/svg";function F3(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(U3,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}function PM(n){let t=null,e=v("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=v("span",{class:"hint",role:"status"}),s=v("input",{type:"text",placeholder:"Name, maker, or joints such as 7R","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>a(),keydown:l=>{if(l.key==="ArrowDown")e.firstElementChild?.focus();else if(l.key==="Enter")e.firstElementChild?.click();else return;l.preventDefault()}}}),r=v("dialog",{class:"catalogue","aria-label":"Catalogue"},v("div",{class:"line"},s,i,v("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the catalogue",on:{click:()=>r.close()}})),e);document.body.append(r);let o=l=>/^(.)\1*$/.test(l)?`${l.length}${l[0]}`:l;function a(){let l=s.value.toLowerCase().split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>{let h=`${u.name} ${u.maker} ${u.joints} ${o(u.joints)}`.toLowerCase();return l.every(d=>h.includes(d))});i.textContent=`${c.length} of ${t?.length??0} arms`,Vt(e,c.map(u=>v("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},F3(u.points),v("span",{},v("b",{text:u.name}),v("span",{class:"hint",text:[u.maker,o(u.joints)].filter(Boolean).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await qi("catalog")).arms,a()}catch(l){Fe(l.message,"wrong")}}}function LM(n){let t=v("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>IM(t.value)}}),e=PM(IM),i=v("p",{class:"sentence","data-testid":"sentence"}),s=v("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=v("button",{type:"button",text:u,"aria-label":h,on:{click:d}});return p.show=y=>{p.disabled=!y,p.title=y?`${h}: ${y} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",y??"")},p},o=r("\u21B6","Undo",xg,"Ctrl+Z"),a=r("\u21B7","Redo",yg,"Ctrl+Shift+Z");st("history",()=>{o.show(Qd()),a.show(tf())});let l=()=>{let{name:u,derived:h,catalog:d}=M.table,f=d?[]:[v("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Vt(t,f,(M.catalog??[]).map(p=>v("option",{value:p,text:p}))),t.value=d??""},c=v("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(v("span",{class:"mark"},v("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),v("b",{text:"pieper"})),t,v("button",{type:"button",class:"find",text:"Find\u2026","aria-label":"Find an arm in the catalogue","data-testid":"find-arm",on:{click:e}}),c,i,v("span",{class:"bar-end"},s,nn("Angles in",[["deg","\xB0"],["rad","rad"]],_t.angle,u=>{_t.set("angle",u),dt("units")},"unit-angle"),nn("Lengths in",[["mm","mm"],["m","m"]],_t.length,u=>{_t.set("length",u),dt("units")},"unit-length"),pn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],M.theme,Md,{"data-testid":"theme"}))),dt("history"),st(["catalog","table"],l),st("plan",()=>{gt(i,[xu(M.plan),c_(M.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=M.plan?.explain??""}),st("online",u=>{gt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),st(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(_t.angle),n.querySelector("[data-testid=unit-length]").mark(_t.length),n.querySelector("[data-testid=theme]").value=M.theme})}async function IM(n){if(n)try{let{table:t}=await qi("load",{name:n});fn(t,{q:ra(t),what:"new",label:`open ${n}`})}catch(t){Fe(t.message,"wrong")}}function DM(n,t,e,i){let s=v("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=v("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=v("section",{class:"section"},v("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=v("button",{type:"button",role:"tab",id:`tab-${c.id}`,"aria-controls":u.id,text:c.title,on:{click:()=>l(c.id)}});return c.group&&s.append(v("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(M.panel,t.scrollTop),M.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}dt("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===M.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(M.panel==="move"||!a.some(c=>c.id===M.panel)?"move":M.panel)),l(M.panel),l}function NM(n){let t=v("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>v("button",{type:"button",text:u,on:{click:()=>Om(c)}})),v("button",{type:"button",text:"Fit",on:{click:()=>zc()}})),e=v("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=v("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),Tv(c)}}}),s=v("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:jd}}),r=v("span",{class:"scale"}),o=v("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=v("span",{class:"dot"});return h.style.setProperty("background",Rr[u]),v("span",{},h,c)}),r);n.append(v("div",{class:"corner top"},t,v("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),v("div",{class:"group",role:"group","aria-label":"The picture"},RM(n),v("button",{type:"button",text:"PNG","aria-label":"Save the picture","data-testid":"save-picture",on:{click:CM}}))),v("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=M.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);M.shownFrames=(M.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{M.shownFrames=d,l()};Vt(e,v("span",{class:"group-name",text:"Frames"}),u.map(d=>v("button",{type:"button",text:Zd(d),"aria-pressed":String(M.shownFrames.includes(d)),"aria-label":`Frame ${Zd(d)}`,on:{click:()=>h(M.shownFrames.includes(d)?M.shownFrames.filter(f=>f!==d):[...M.shownFrames,d])}})),v("button",{type:"button",text:M.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(M.shownFrames.length===c+2?[]:u)}})),dt("frames"),gt(r,`grid ${ue(km.cell,"length",_t.length==="mm"?0:2)}`)};st(["table","units"],l),l()}function UM(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),xg()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),yg()))})}var o0=()=>M.frames[M.frames.length-1],OM={id:"pose",title:"Pose",build(n){let t=hl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>FM(u,"length",`pose-${u.toLowerCase()}`)),i=v("div",{class:"quantities","data-testid":"orientation"}),s=v("p",{class:"hint order"}),r=[],o=pn("Notation of the orientation",Object.entries(Rs).map(([u,h])=>[u,h.title]),M.notation,u=>{M.notation=u,dt("notation")}),a=v("span",{class:"copies"},v("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>Gr(Af(o0()))}}),v("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>Gr(O3())}}));n.append(v("div",{class:"subhead"},v("span",{text:"Tool in the base frame"}),a),t,v("div",{class:"quantities"},e.map(u=>u.el)),v("div",{class:"line"},o,s),i);let l=()=>{let u=Rs[M.notation];o.value=M.notation,gt(s,u.order),r=u.names.map((h,d)=>FM(h,u.kinds[d],`turn-${d}`)),Vt(i,r.map(h=>h.el)),c()},c=()=>{let u=o0();t.show(u),te(u).forEach((h,d)=>e[d].show(h)),Rs[M.notation].to(u).forEach((h,d)=>r[d].show(h))};st("q",c),st("notation",l),st("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function O3(){let n=o0(),t=Rs[M.notation],e=te(n).map((s,r)=>`${"XYZ"[r]} ${gn(s,"length")} ${_t.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${gn(s,"angle")} ${_t.symbol("angle")}`:Qn(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function FM(n,t,e){let i=v("output",{"data-testid":e}),s=v("span",{class:"unit",text:_t.symbol(t)});return{el:v("div",{class:"quantity"},v("span",{class:"quantity-name",text:n}),i,s),show:o=>gt(i,t==="plain"?Qn(o,5):gn(o,t)),relabel:()=>gt(s,_t.symbol(t))}}function B3(n,t){let e=[],i=n.joints.length,s=dr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=hr(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*hr(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var BM={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=v("div",{class:"cards","data-testid":"matrices"}),a=v("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=pn("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),c=v("span",{class:"partial"});n.append(v("div",{class:"line"},nn("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),c),v("div",{class:"line"},v("span",{class:"field-name",text:"Numbers of the"}),l),o,v("h3",{text:"Intermediate angles"}),v("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&M.solutions?.rows[Number(e)]?.q||M.q,h=()=>{let p=M.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let y=t==="links"?M.table.joints.map((g,x)=>["A",String(x+1),""]):t==="products"?M.table.joints.map((g,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&y.push(["T","tool","base"]);let m=Array.from({length:p+1},(g,x)=>[String(x),String(x)]);Vt(c,t==="partial"?[pn("From frame",m,String(i),g=>{i=Number(g),h()})," \u2192 ",pn("To frame",m,String(s),g=>{s=Number(g),h()})]:[]),r=y.map(([g,x,w])=>({grid:hl(`${g} ${w} ${x}`,`matrix-${g}${w}${w?"-":""}${x}`),note:v("span",{class:"hint"}),sym:g,low:x,high:w})),Vt(o,r.map(({grid:g,note:x,sym:w,low:b,high:A})=>v("figure",{class:"card"},v("figcaption",{},v("span",{class:"symbol"},A?v("sup",{text:A}):null,v("i",{text:w}),v("sub",{text:b})),x),g))),d()},d=qs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let p=u(),y=Q0(M.table,p),m=y.length;r.forEach(({grid:w,note:b},A)=>{if(t==="links"&&A<m)w.show(y[A]),gt(b,`q${A+1} = ${ue(p[A],Ze(M.table.joints[A]))}`);else if(t==="links")w.show(ys(M.table,p)[m+1]);else if(t==="products")w.show(y.slice(0,A+1).reduce(ni,ur()));else{let T=_=>y.slice(0,_).reduce(ni,ur());w.show(ni(hu(T(i)),T(s)))}});let g=dr(M.table,p),x=M.table.joints.map((w,b)=>[w.type==="R"?`\u03B8${b+1}`:`d${b+1}`,w.type==="R"?gn(hr(w,g[b]).theta,"angle"):gn(hr(w,g[b]).d,"length"),w.type==="R"?"angle":"length"]).concat(B3(M.table,p).map(({name:w,value:b})=>[`\u03B8${w}`,gn(b,"angle"),"angle"]));Vt(a,v("tbody",{},x.map(([w,b,A])=>v("tr",{},v("th",{scope:"row"},v("i",{text:w[0]}),v("sub",{text:w.slice(1)})),v("td",{text:b}),v("td",{class:"unit",text:_t.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=M.solutions?.rows??[];Vt(l,v("option",{value:"now",text:"present posture"}),p.map((y,m)=>v("option",{value:String(m),text:`solution ${m+1}: ${y.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),l.value=e,d()};st("table",h),st(["q","units","panel"],d),st(["solutions","panel"],f),h()}};var k3=.002;function Ns(n,t,e,i){let s=[],r="",o=v("div",{class:"pose-fields"}),a=()=>{let c=Rs[M.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=Hy(M.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,z3(s))};s=u.map(([d,f],p)=>{let y={value:0,kind:f},m=(g,x)=>{y.value=g,y.text=x.text,h()};return y.f=Tn({label:`${n}, ${d}`,kind:f,testid:`${t}-${p}`,input:m,commit:(g,x)=>{m(g,x),dt("let-go")}}),y.el=v("label",{class:"pose-field"},v("span",{text:d}),y.f,v("span",{class:"unit",text:_t.symbol(f)})),y}),Vt(o,s.map(d=>d.el)),r=M.notation},l=()=>{r!==M.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...te(c),...Rs[M.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,H3(u,s[h].kind))})};return st("units",()=>{a(),l()}),st("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=Sf(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),wf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:v("fieldset",{class:"pose-editor"},v("legend",{text:n}),o),show:l}}function z3(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?Za(t(e),"angle"):2*Za(t(n.slice(3)),"plain");return{metres:Za(t(n.slice(0,3)),"length"),radians:i}}var H3=(n,t)=>String(Number((n*_t.factor(t)).toFixed(t==="plain"||_t[t]==="m"||_t[t]==="rad"?6:3))+0);function kM(n){let t=n.match(zM)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:Za(e,"length"),radians:2*Za(i,"plain")}}var zM=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function HM(n){let t=(n.replaceAll("\u2212","-").match(zM)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=fu(e);if(i>k3)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=_t.factor("length");return pu(e)}function Rf(n){return n.map((t,e)=>{let i=M.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((M.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function GM(n,t){let e=t?.self_motions??[],i=he.task??M.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Vt(n,v("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let p=d.moves.length>3?"most of its joints":d.moves.join(" and "),y=d.inside.length?q3(d):"All of it lies outside the limits.";return v("div",{class:"self-motion"},v("p",{},v("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${p}, ${a(d)}: the arm moves, ${o}. ${y}`),X3(d,f,t.T,s))},c=e.length?V3(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?v("details",{class:"fold"},v("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Vt(n,c>=0?l(e[c],c):null,h)}var G3=n=>n.reduce((t,e,i)=>t+Math.sin((e-M.q[i])/2)**2,0),V3=n=>{let t=n.map(e=>Math.min(...e.q.map(G3)));return t.indexOf(Math.min(...t))};function W3(n){let t=(s,r)=>s.map((o,a)=>M.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(M.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var q3=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function $3(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function X3(n,t,e,i){let s=v("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{hi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));dt("did",{label:"slide along a self-motion",key:"self-motion"}),Li(Rf(i?e_(M.table,u,e):u),"self-motion")};return s.value=String(W3(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",$3(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function VM(){let n=[],t=[],e={},i=v("div",{class:"joints"}),s=v("details",{},v("summary",{class:"hint",text:"Hold by value"}),i),r=v("p",{class:"hint"}),o=nn("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=v("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},v("div",{class:"line spread"},v("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:p=!1}={}){dt("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),he.redundancy=f&&Object.fromEntries(f.map(y=>[y,e[y]])),d(),p?Cv():Cs({follow:!0})}let c=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>M.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let y=f.kind==="angle"?Math.PI:ai(M.table),m=f.lower??-y,g=f.upper??y,x=v("input",{type:"range",min:String(m),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),w=!1,b=(S,D)=>{e[f.name]=S,l(c(f),{sliding:D})};x.addEventListener("input",()=>b(Number(x.value),!0)),x.addEventListener("change",()=>Cs({follow:!0})),x.addEventListener("keydown",S=>{let D={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[S.key];if(D===void 0)return;S.preventDefault(),w=!0;let L=D*_t.step(f.kind)*(S.shiftKey?.1:1);b(Math.min(Math.max(e[f.name]+L,m),g),!0)}),x.addEventListener("keyup",()=>{w&&Cs({follow:!0}),w=!1});let A=Tn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:S=>S<m-1e-9&&f.lower!==null?`below the limit ${ue(m,f.kind)}`:S>g+1e-9&&f.upper!==null?`above the limit ${ue(g,f.kind)}`:null,commit:S=>b(S,!1)}),T=v("span",{class:"limits"}),_=v("div",{class:"joint"},v("span",{class:"joint-name",text:f.name}),v("div",{class:"track"},x,v("div",{class:"under"},T)),A,v("span",{class:"unit"}));return{line:_,show(){let S=e[f.name];x.value=S,x.style.setProperty("--at",`${100*(Math.min(Math.max(S,m),g)-m)/(g-m||1)}%`),x.setAttribute("aria-valuetext",ue(S,f.kind)),_.classList.toggle("held",!!(he.redundancy&&f.name in he.redundancy)),A.put(Number((S*_t.factor(f.kind)).toFixed(_t.digits(f.kind)+1))/_t.factor(f.kind))},relabel(){gt(_.lastChild,_t.symbol(f.kind));let S=D=>D===null?"no limit":ue(D,f.kind,f.kind==="angle"&&_t.angle==="deg"?0:void 0);gt(T,f.lower===null&&f.upper===null?"no limits":`${S(f.lower)} \u2026 ${S(f.upper)}`),A.refresh()}}}function d(){for(let f of n)he.redundancy&&f.name in he.redundancy?e[f.name]=he.redundancy[f.name]:u(f)>=0?e[f.name]=M.q[u(f)]:f.instead&&Number.isFinite(M.solutions?.arm_angle)?e[f.name]=M.solutions.arm_angle:e[f.name]??=0;o.mark(he.redundancy?"chosen":"free"),gt(r,he.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return st("solutions",()=>{let f=M.solutions?.spare;if(!M.solutions||!f&&(M.solutions.brief||M.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Vt(i,t.map(y=>y.line));for(let y of t)y.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(y=>!y.instead).length>1||!!he.redundancy),d()}),st("q",()=>!a.hidden&&!a.closest("[hidden]")&&!he.redundancy&&d()),st("units",()=>{for(let f of t)f.relabel();d()}),a}function WM(){let n=v("thead"),t=v("tbody"),e=v("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=v("div",{class:"scroll"},v("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${M.table.joints.map(c=>c.type).join("")}${_t.angle}${_t.length}`;l!==r&&(r=l,s=[],Vt(t),Vt(n,v("tr",{},v("th",{text:""}),v("th",{class:"left",text:"posture"}),M.table.joints.map((c,u)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(u+1)}),v("span",{class:"unit",text:` ${_t.symbol(Ze(c))}`}))),v("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=M.table.joints.map(()=>v("td")),u=v("span"),h=v("span",{class:"offscreen"}),d=v("td",{class:"unit"}),f=v("tr",{tabindex:"0","data-testid":`solution-${l+1}`},v("th",{scope:"row",text:String(l+1)}),v("td",{class:"left"},u,h),c,d),p=()=>M.solutions?.rows[l]?.q,y=()=>p()&&ds(p()),m=()=>ds(null),g=()=>{p()&&(ds(null),Ai(Rf(p()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",y),f.addEventListener("pointerleave",m),f.addEventListener("focus",y),f.addEventListener("blur",m),f.addEventListener("click",g),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),g())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&gt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),gt(u.beyond,d.inside?"":", outside the limits"),gt(u.residual,d.residual?Dd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${Dd(d.residual[0])} m, ${Dd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let y=M.table.joints[p],m=y.lower!==null&&f<y.lower-1e-9||y.upper!==null&&f>y.upper+1e-9;gt(u.cells[p],gn(f,Ze(y))),u.cells[p].classList.toggle("out",m)}))}),this.mark()},mark(){let l=M.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===M.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-M.q[d])/2))<1e-5)))}}}var Y3={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},a0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},Z3=new Set(["REDUNDANT","UNCERTAIN"]),j3=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,l0=120;function c0(){xi(M.frames[M.frames.length-1].slice(),"taken")}var $M={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(v("div",{class:"line spread"},v("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:c0}}),nn("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",y=>{i.hidden=y!=="numbers",s.hidden=y!=="matrix"},"target-as")));let e=Ns("Target","target",()=>M.target,(y,m)=>xi(y,"typed",m)),i=v("div",{},e.el),{el:s,show:r}=K3();n.append(i,s,Q3());let o=v("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=v("div",{class:"near","data-testid":"ik-nearest"}),l=v("div",{class:"self-motions","data-testid":"self-motions"}),c=WM();n.append(VM(),o,a,l,c.el);let u=oa(l0,()=>{e.show(),r()}),h=oa(l0,()=>{if(t.hidden)return;let y=M.solutions;t2(o,y),i2(a,y),GM(l,y),c.show(y)}),d=oa(l0,()=>c.mark()),f=y=>()=>Hd()?y.soon():y();st("target",f(u)),st("notation",e.show),st(["solutions","units"],f(h)),st("q",f(d));let p=()=>Ir("target",M.panel==="inverse"?J3(te(M.target)):[]);st("target",y=>y!=="drag"&&p()),st("panel",y=>{sv(y==="inverse"),(y!=="inverse"||M.hasTarget)&&p(),y==="inverse"&&(M.hasTarget?dt("solutions"):(M.hasTarget=!0,c0()))}),st("table",y=>{y==="new"&&(M.hasTarget=M.panel==="inverse",M.hasTarget&&c0())})}};function J3(n){let t=.25*ai(M.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function K3(){let n=v("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=v("p",{class:"reason",role:"alert"}),e=v("p",{class:"hint"});n.addEventListener("input",()=>{try{xi(HM(n.value),"typed",kM(n.value)),gt(t,""),n.removeAttribute("aria-invalid")}catch(s){gt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(gt(e,`Twelve or sixteen numbers, row by row; the last column in ${_t.length}.`),document.activeElement===n)return;let s=M.target.map((r,o)=>o%4===3&&o<12?r*_t.factor("length"):r);n.value=Af(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return st("units",i),i(),{el:v("div",{hidden:!0},n,e,t),show:i}}function Q3(){let n=v("span",{class:"line"}),t=v("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{he.follow=t.checked}}}),e=nn("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{he.ghosts=i,Ka()});return st("task",()=>{t.checked=he.follow,e.mark(he.ghosts)}),st("plan",()=>Vt(n,M.plan?.solvable?[v("span",{class:"field-name",text:"Task"}),pn("Task",[["",`${M.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],he.task??"",i=>{dt("did",{label:"choose the task"}),he.task=i||null,he.redundancy=null,Cs()},{"data-testid":"task"})]:[])),v("div",{class:"line controls"},v("span",{class:"line"},v("span",{class:"field-name",text:"Handles"}),nn("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",rv)),nn("Axes of the handles",[["local","Tool"],["world","World"]],"local",ov),v("span",{class:"line"},v("span",{class:"field-name",text:"Snap"}),pn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>av(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),v("span",{class:"line"},v("span",{class:"field-name",text:"Ghosts"}),e),v("label",{class:"check"},t,"Arm follows"),n)}function t2(n,t){if(!t){Vt(n,v("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=Y3[t.status]??"note";let s=t.status==="SOLVED"&&e?qM(t.missed):[t.why,t.status==="SINGULAR"?j3(e,i):"",qM(t.missed)].filter(Boolean).join(" "),r=a0[t.status]&&!i?t.why.toLowerCase().includes(a0[t.status].toLowerCase())?"":a0[t.status]:t.status==="SINGULAR"||Z3.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Vt(n,v("strong",{text:r})," ",v("span",{text:s}),t.ms===void 0?null:v("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var qM=n=>n?`The pose was rounded by ${n2(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",e2=(n,t)=>ue(n,t,_t.digits(t)+2),n2=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*_t.factor(e)>=.5*10**-(_t.digits(e)+2)).map(([t,e])=>e2(t,e)).join(" and ");function i2(n,t){let e=t?.near;if(!e){Vt(n);return}let i=te(e.T).map(s=>gn(s,"length")).join(", ");Vt(n,v("p",{},v("strong",{text:"Nearest reachable: "}),`${i} ${_t.symbol("length")}, ${ue(e.metres,"length")} away`,e.radians>.001?`, turned by ${ue(e.radians,"angle")}`:""),v("div",{class:"line"},v("button",{type:"button",text:"Go there",on:{click:()=>Ai(e.q)}}),v("button",{type:"button",text:"Make it the target",on:{click:()=>xi(e.T,"chosen")}})))}var u0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Cf(n){return u0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Pf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Cf(r)??{a:0,alpha:0};Cf(r)&&(r=ur()),o=ni(u0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Cf(o)??{a:0,alpha:0};Cf(o)&&(o=ur()),r=ni(r,u0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var XM=30,s2=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),r2={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},dl=null;function YM(n,t){dl={label:n,key:"paste",open:!0};try{t(dl)}finally{dl=null,dt("let-go")}}function If(n,t,e,{symbolic:i,text:s},r){let o=M.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(M.table.joints[n][t],e)&&M.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${r2[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||fn({...M.table,joints:o},dl?{...c,...dl}:c),r&&!dl&&dt("let-go")}function fl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=M.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(M.q,0),c=o?t(o,null).map((u,h)=>o2(u&&t(u,0),h,n.length)):null;fn({...M.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var o2=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function ZM(n,t,e){let i=M.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function h0({label:n,key:t,open:e}={}){let i=M.table.joints.length;return i>=XM?(Fe(`At most ${XM} joints.`,"wrong"),!1):(fl([...M.table.joints,s2(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function d0(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};fl(e(M.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function Lf(){try{yi(`${M.table.name||"arm"}.toml`,(await ze("save",{})).text,"application/toml")}catch(n){Fe(n.message,"wrong")}}async function jM(n){let t=n.files[0];if(n.value="",!!t){if(t.size>2e5){Fe(`${t.name} has ${t.size} bytes; a robot file has at most 200,000.`,"wrong");return}try{let{table:e}=await qi("open",{name:t.name.slice(-80),text:await t.text()});fn(e,{q:ra(e),what:"new",label:`open ${t.name.slice(-40)}`})}catch(e){Fe(e.message,"wrong")}}}var f0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},a2=({catalog:n,...t})=>n?{...t,derived:n}:t,l2=n=>n.type==="R"?"angle":"length",JM={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=v("thead"),s=v("tbody"),r=v("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=v("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=v("p",{class:"verdict","data-testid":"arm-kind"}),l=nn("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],M.table.convention,w=>{w!==M.table.convention&&fn(Pf(M.table,w),{what:"rows",label:`make the table ${w}`})},"convention"),c=v("p",{class:"hint order"}),u=v("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>fn({...a2(M.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=v("input",{type:"file",accept:".toml,.urdf,.xml",class:"offscreen","aria-label":"Robot file","data-testid":"robot-file",tabindex:"-1",on:{change:()=>jM(h)}}),d=Ns("Base","base",()=>M.table.base,w=>fn({...M.table,base:w},{what:"cell",label:"edit the base",key:"base",open:!0})),f=Ns("Tool","tool",()=>M.table.tool,w=>fn({...M.table,tool:w},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(v("div",{class:"line spread"},v("span",{class:"line"},u),v("span",{class:"line"},v("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>fn(n_(M.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),v("button",{type:"button",text:"Open\u2026",title:"A robot file (.toml) or a URDF",on:{click:()=>h.click()}}),h,v("button",{type:"button",text:"Save",title:"As a robot file",on:{click:Lf}}))),v("div",{class:"line spread"},l,nn("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,w=>{t=w,g()},"dh-part")),c,r,v("div",{class:"line"},v("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>h0()}}),v("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,zy(),v("details",{class:"fold","data-testid":"base-tool"},v("summary",{text:"Base and tool"}),d.el,f.el)),s.addEventListener("paste",w=>{let b=Sf(w.clipboardData.getData("text")),A=()=>[...s.rows].map(S=>[...S.querySelectorAll("input.number")]);if(!b||!w.target.matches("input.number"))return;w.preventDefault();let T=A().findIndex(S=>S.includes(w.target)),_=A()[T].indexOf(w.target);YM("paste a table",S=>{for(;M.table.joints.length<T+b.length&&h0(S););let D=wf(A(),T,_,b),L=b.flat().length;Fe(`Pasted ${D} number${D===1?"":"s"}${D<L?`; ${L-D} had no cell`:""}`)})}),n.addEventListener("verdict",w=>{let b=w.detail??c2(n);gt(o,b?`${b.label}: ${b.reason}. The arm stays as it was.`:"")});let p=(w,b,[A,T,_])=>{let S=w.type==="R"&&A==="theta"||w.type==="P"&&A==="d",D=A==="lower"||A==="upper",L=Tn({label:`Joint ${b+1}, ${T}`,kind:_??l2(w),testid:`dh-${b+1}-${A}`,empty:D?null:void 0,check:N=>D?ZM(b,A,N):N!==null&&Math.abs(N)>1e6?"larger than a million":null,input:(N,z)=>If(b,A,N,z,!1),commit:(N,z)=>If(b,A,N,z,!0)});return D&&(L.placeholder="none"),e.push({f:L,i:b,key:A}),v("td",{class:S?"variable":""},S?v("span",{class:"plus"},v("i",{text:"q"}),v("sub",{text:String(b+1)})," +"):null,L)},y=(w,b)=>v("button",{type:"button",class:`type type-${w.type}`,text:w.type,"data-testid":`dh-${b+1}-type`,"aria-label":`Joint ${b+1} is ${w.type==="R"?"revolute":"prismatic"}; press to change`,title:w.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>fl(M.table.joints.map((A,T)=>T===b?{...A,type:A.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...A.text,lower:void 0,upper:void 0,offset:void 0}}:A),A=>A.map((T,_)=>_===b&&typeof T=="number"?0:T),`make joint ${b+1} ${w.type==="R"?"prismatic":"revolute"}`)}}),m=(w,b)=>v("td",{class:"tools"},v("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${w+1} up`,disabled:w===0,on:{click:()=>d0(w,w-1)}}),v("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${w+1} down`,disabled:w===b-1,on:{click:()=>d0(w,w+1)}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${w+1}`,on:{click:()=>fl(M.table.joints.filter((A,T)=>T!==w),A=>A.filter((T,_)=>_!==w),`remove joint ${w+1}`)}})),g=()=>{e=[];let{joints:w}=M.table,b=M.table.convention==="modified",A=t==="geometry"?f0.geometry.map(([T,_,S])=>v("th",{scope:"col"},v("i",{text:_}),v("sub",{text:b&&(T==="a"||T==="alpha")?"i\u22121":"i"}),v("span",{class:"unit",text:` ${_t.symbol(S)}`}))):["name","lower limit","upper limit","zero","sense"].map(T=>v("th",{scope:"col",text:T}));Vt(i,v("tr",{},v("th",{scope:"col",text:"i"}),v("th",{scope:"col","aria-label":"type"}),A,v("th",{"aria-label":"row tools"}))),Vt(s,w.map((T,_)=>{let S=t==="geometry"?f0.geometry.map(D=>p(T,_,D)):[v("td",{},v("input",{type:"text",class:"name",value:T.name,maxlength:"40","aria-label":`Joint ${_+1}, name`,on:{change:D=>If(_,"name",D.target.value||`joint_${_+1}`,{},!0)}})),...f0.joint.map(D=>p(T,_,D)),v("td",{},v("button",{type:"button",class:"type",text:T.sign>0?"+":"\u2212","aria-label":`Joint ${_+1}, sense of the maker: ${T.sign>0?"as the table":"against the table"}`,on:{click:()=>fl(M.table.joints.map((D,L)=>L===_?{...D,sign:-D.sign}:D),D=>D,`turn the sense of joint ${_+1}`)}}))];return v("tr",{"data-testid":`dh-row-${_+1}`},v("th",{scope:"row",text:String(_+1)}),v("td",{},y(T,_)),S,m(_,w.length))})),w.length||s.append(v("tr",{},v("td",{colspan:"7",class:"hint",text:"No joints yet."}))),x()},x=()=>{for(let{f:w,i:b,key:A}of e){let T=M.table.joints[b];w.put(T[A],T.text?.[A]??null)}l.mark(M.table.convention),gt(c,M.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=M.table.name),d.show(),f.show()};st("table",w=>{gt(o,""),w==="cell"||w==="name"||w==="postures"?x():g()}),st("units",g),st("notation",()=>{d.show(),f.show()}),st("plan",()=>{a.dataset.tone=M.plan?.solvable?"good":"wrong",Vt(a,v("strong",{text:xu(M.plan)||(M.plan?.refused?"Refused":"Not solved")})," ",v("span",{text:M.plan?.explain??""}))}),g()}};function c2(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var u2=4,h2=n=>{let t=n.toFixed(u2);return Number(t)<0?`(${t})`:t.replace("-","")};function Df(n,t,e){let i=dr(t,e),s=t.joints.map((c,u)=>hr(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,h2(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Nf=null;async function d2(){return Nf??=(await import("./katex-OJEVB6AI.js")).default,Nf}function f2(n,t){let e=v("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function KM(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>f2(n,i)],[i=>"code"in i,i=>v("code",{text:i.code})],[()=>!0,i=>v("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var p2=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function m2(n){let t=M.table.joints.map((e,i)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(i+1)}),v("span",{class:"unit",text:` ${_t.symbol(Ze(e))}`})));return[v("h3",{text:"The formulas at the present pose"}),v("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},v("thead",{},v("tr",{},v("th",{text:"branch"}),t)),v("tbody",{},n.map((e,i)=>v("tr",{},v("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>v("td",{text:gn(s,Ze(M.table.joints[r]))}))))))]}var QM={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=v("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=v("div",{class:"equations","data-testid":"equations"}),c=nn("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,b=>{i=b,y()},"equation-numbers"),u=v("div",{class:"scroll"});n.append(v("div",{class:"line spread"},v("span",{class:"line"},nn("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,b=>{e=b,y()},"which-equations"),c),v("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>Gr(f())}})),a,u,l);let h=b=>b.symbols&&i==="present"?Df(b,M.table,M.q):b.latex,d=b=>b.number===void 0?"":` \\tag{${b.number}}`,f=()=>o.map(b=>b.kind==="equation"?`\\[ ${h(b)}${d(b)} \\]`:p2(b.pieces)).join(`

`);function p(b){r=[],Vt(l,o.map(A=>m(b,A))),g()}async function y(){if(t.hidden||!M.table.joints.length)return;let b=`${e}/${i}/${JSON.stringify(M.table.joints)}${M.table.convention}`;if(s!==b){s=b,gt(a,"Deriving \u2026"),Vt(l);try{let[A,T]=await Promise.all([d2(),ze("equations",{which:e,numbers:i==="symbols"?i:"numbers"},_=>gt(a,_.note??""))]);if(s!==b)return;gt(a,T.note??""),o=T.blocks,p(A),c.hidden=e!=="forward",Vt(u),x()}catch(A){if(s!==b)return;s=null,gt(a,A.message)}}}function m(b,A){if(A.kind==="heading"||A.kind==="step")return v("h3",{},KM(b,A.pieces));if(A.kind!=="equation")return v("p",{class:"prose"},KM(b,A.pieces));let T=v("div",{class:"formula"});try{b.render(h(A),T,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{T.replaceChildren(v("code",{text:h(A)}))}if(A.number!==void 0)return v("div",{class:"formula-row numbered"},T,v("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return T;let _=v("output",{class:"value","data-entry":String(A.entry)});return r.push({value:_,entry:A.entry}),v("div",{class:"formula-row"},T,_)}let g=qs(()=>{if(t.hidden)return;let b=M.frames[M.frames.length-1];for(let{value:A,entry:T}of r)gt(A,`= ${T%4===3?`${Qn(b[T]*_t.factor("length"),_t.digits("length"))} ${_t.length}`:Qn(b[T],4)}`)}),x=$s(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:b}=await ze("formulas",{T:M.frames.at(-1)});Vt(u,b.length&&e==="inverse"?m2(b):null)}catch{Vt(u)}},250),w=$s(()=>{!t.hidden&&Nf&&o.length&&e==="forward"&&i==="present"&&p(Nf)},120);st("q",w),st("panel",w),st("q",x),st("units",x),st("panel",y),st("plan",y),st(["q","units"],g)}};var g2=()=>M.frames.at(-1).slice();function Uf(n,t){let e=M.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{dt("did",{label:c,key:u}),e[a]=l,t(),dt("path",n)},r=["from","to"].map(a=>{let l=Ns(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`${i}take-${a}`,on:{click:()=>{s(a,g2(),`take \u201C${a}\u201D of the path`),l.show()}}});return{el:v("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return st("path",a=>a!==n&&o()),st("path-loaded",o),st("notation",o),{el:v("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var tS=()=>M.frames[M.frames.length-1].slice(),eS={id:"path",title:"Path",wide:!0,build(n,t){let e=M.path,i=Uf("path",()=>h()),s=v("span",{class:"hint"}),r=Tn({label:"Number of points N",testid:"path-n",check:m=>Number.isInteger(m)&&m>=2&&m<=2e3?null:"a whole number from 2 to 2000",input:m=>{dt("did",{label:"set the points of the path",key:"path-n"}),e.n=m}}),o=Tn({label:"Seconds for the whole line",testid:"path-seconds",check:m=>m>0&&m<=3600?null:"more than 0, at most 3600",input:m=>{dt("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=m}}),a=v("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let m=te(e.to);dt("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((g,x)=>{e.to[g]=m[x]}),i.show(),dt("path","path"),h()}}}}),l=v("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>d(M.q)}}),c=v("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=v("div",{class:"branches","data-testid":"branches"});n.append(i.el,v("div",{class:"line"},a,s),v("div",{class:"line"},v("label",{class:"field"},v("span",{class:"field-name",text:"Points N"}),r),v("label",{class:"field"},v("span",{class:"field-name",text:"Seconds"}),o),l,v("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,u);let h=()=>{if(!e.from||!e.to){gt(s,"");return}let m=J0(e.from,e.to);gt(s,`${ue(rs(Ii(te(e.to),te(e.from))),"length")} long${m>1e-6?`, turning ${ue(m,"angle")}`:", orientation kept"}`),Fo(Array.from({length:33},(g,x)=>te(Fd(e.from,e.to,x/32))))};async function d(m){let g=Vr(n);if(g){c.hidden=!1,c.dataset.tone="wrong",gt(c,g);return}gt(l,"Planning \u2026"),l.disabled=!0;try{let x=await ze("follow",{T0:e.from,T1:e.to,n:e.n,start:m});M.track=x,f(x,m)}catch(x){c.hidden=!1,c.dataset.tone="wrong",gt(c,x.message)}finally{gt(l,"Plan the line"),l.disabled=!1}}function f(m){if(c.hidden=!1,c.dataset.tone=m.complete?"good":"wrong",gt(c,m.explain),Vt(u,m.branches.length?v("h3",{text:"Branches that start at the first pose"}):null,m.branches.map((b,A)=>v("button",{type:"button",class:`branch ${A===m.chosen?"chosen":""}`,"aria-pressed":String(A===m.chosen),"data-testid":`branch-${A+1}`,disabled:!b.q,title:b.cause||"reaches the end",on:{click:async()=>{await Ai(b.q,.4,`take branch ${A+1}`),d(b.q)}}},v("span",{class:"branch-name",text:`${A+1}  ${b.label}`}),p(b.s),v("span",{class:"branch-end",text:b.complete?"to the end":b.q?`${b.points} of ${e.n}`:"starts outside the limits"})))),Fo(m.path.map(te)),!m.q.length){Pi(null);return}let g=m.path.length,x=m.q.map((b,A)=>A+1),w=m.q.map((b,A)=>g>1?e.seconds*A/(g-1):0);Pi(sr({table:M.table,q:m.q,xs:x,xName:"point",xEnd:g,seconds:w,title:`${M.table.name}: straight line, ${m.q.length} of ${g} points`,events:m.events.map(b=>({...b,x:1+b.s*(g-1),short:b.cause}))}))}function p(m){let g=v("span",{class:"bar-fill"});return g.style.setProperty("width",`${100*m}%`),v("span",{class:"bar"},g)}let y=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};st("panel",m=>{m==="path"&&(e.from??=tS(),e.to??=tS(),y())}),st("path-loaded",y),st("units",h),st("table",m=>{["postures","name","gripper"].includes(m)||(c.hidden=!0,Vt(u),Fo([]),t.hidden||y())})}};var nS=Math.PI/180,_2=()=>({turn_speed:180*nS,turn_acceleration:600*nS,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});function Wo(n,t,{key:e,open:i}={}){dt("did",{label:t,key:e,open:i}),!M.program.length&&n.length&&(M.start??=M.q),M.program=n,dt("program")}var p0=(n,t,e,i)=>Wo(M.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function iS(n,t){dt("did",{label:t,key:"limits"}),M.limits={...Ff(),...n},dt("program","limits")}var Ff=()=>({..._2(),...M.limits});function sS(n,t="set the start of the program"){dt("did",{label:t}),M.start=n,dt("program")}var Of=()=>M.start?.length===M.table.joints.length?M.start:M.q;function pl(){let n=Ff(),t=M.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:Of(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:M.program.map(({name:i,...s})=>s)}}var x2=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),fo=()=>M.routing??x2();function ml(n,t,e=t){dt("did",{label:t,key:e}),M.routing={...fo(),...n},dt("routing")}var m0=()=>{let n=fo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function Bf(){let n=fo(),t=M.path,e=M.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:m0(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:M.world,clearance:e?n.clearance:0}}function g0(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var gl=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function rS(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(gl(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>g0(n,l)(o,r))}var qo=Math.PI/180,oS=3.4,y2=2.1,aS=.5,v2=.9;function lS({drag:n,drop:t,scrub:e}){let i=v("canvas",{"aria-hidden":"true"}),s=v("div",{class:"route-now",hidden:!0}),r=v("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(I=>v("div",{class:`route-end ${I}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":I==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${I}`,hidden:!0})),a=v("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function y(){let I=p(),U=a.clientWidth,Z=a.clientHeight,q={l:oS*I,t:aS*I,w:U-(oS+v2)*I,h:Z-(aS+y2)*I},j=-Math.PI,et=Math.PI;if(l.map&&!gl(l.map))j=l.map.turn[0],et=l.map.turn.at(-1);else if(l.turn.length){let ht=90*qo;j=Math.min(j,ht*Math.floor(Math.min(...l.turn)/ht)),et=Math.max(et,ht*Math.ceil(Math.max(...l.turn)/ht))}u={...q,lo:j,hi:et,W:U,H:Z}}let m=I=>u.l+I*u.w,g=I=>u.t+(1-(I-u.lo)/(u.hi-u.lo))*u.h,x=I=>u.lo+(1-(I-u.t)/u.h)*(u.hi-u.lo),w=I=>zt.curves[Math.max(l.branches.indexOf(I),0)%zt.curves.length];function b(){f=(l.map?.branches??[]).map((I,U)=>{let Z=g0(l.map,U),q=l.map.s.length,j=l.map.turn.length,et=v("canvas",{width:q,height:j}),ht=et.getContext("2d"),ft=ht.createImageData(q,j),it=parseInt(w(I).slice(1),16);for(let vt=0;vt<q;vt++)for(let xt=0;xt<j;xt++){if(!Z(vt,xt))continue;let Tt=4*((j-1-xt)*q+vt);ft.data.set([it>>16,it>>8&255,it&255,255],Tt)}return ht.putImageData(ft,0,0),{name:I,c:et}})}function A(){if(!l||!a.clientWidth)return;y();let I=Math.min(devicePixelRatio,2),U=i.getContext("2d");i.width=u.W*I,i.height=u.H*I,U.scale(I,I);let Z=.76*p();U.font=`${Z}px "Inter Variable", system-ui, sans-serif`,U.fillStyle=zt.ground,U.fillRect(u.l,u.t,u.w,u.h),U.save(),U.beginPath(),U.rect(u.l,u.t,u.w,u.h),U.clip(),T(U),_(U),S(U),U.restore(),D(U,Z),N()}function T(I){let U=l.map;if(!U)return;let Z=U.turn[1]-U.turn[0],q=gl(U),j=U.turn[0]-Z/2,et=U.turn.at(-1)+Z/2,ht=q?Math.floor((u.lo-j)/(2*Math.PI)):0,ft=q?Math.ceil((u.hi-et)/(2*Math.PI)):0;for(let{name:it,c:vt}of f)if(!(c&&c!==it)){I.globalAlpha=(c?.4:.3)*(zt.dark?.8:1);for(let xt=ht;xt<=ft;xt++){let Tt=g(et+2*Math.PI*xt),At=g(j+2*Math.PI*xt);I.drawImage(vt,u.l,Tt,u.w,At-Tt)}}I.globalAlpha=1}function _(I){if(!l.blocked)return;let[U,Z]=l.blocked.s,q=m(U),j=Math.max(m(Z)-q,3);I.fillStyle=zt.wrong,I.globalAlpha=.75,I.fillRect(Math.min(q,u.l+u.w-j),u.t,j,u.h),I.globalAlpha=1}function S(I){if(!l.q.length)return;let U=[[0]];l.labels.forEach((Z,q)=>{q&&Z!==l.labels[q-1]&&U.push([q-1]),U.at(-1).push(q)});for(let[Z,q]of[[.38,!0],[.18,!1]])for(let j of U){I.beginPath();for(let et of j)I.lineTo(m(l.s[et]),g(l.turn[et]));I.lineWidth=Z*p(),I.lineJoin=I.lineCap="round",I.strokeStyle=q?zt.panel:zt.curves[l.labels[j.at(-1)]%zt.curves.length],I.stroke()}}function D(I,U){I.strokeStyle=zt.line,I.strokeRect(u.l,u.t,u.w,u.h),I.fillStyle=zt.muted,I.textBaseline="middle",I.textAlign="right";let Z=(u.hi-u.lo)/qo,q=[5,10,15,30,45,90,180].find(et=>Z/et<=6)??180;for(let et=Math.ceil(u.lo/qo/q-1e-9)*q;et<=u.hi/qo+1e-6;et+=q){let ht=g(et*qo);I.fillText(gn(et*qo,"angle",_t.angle==="deg"?0:2),u.l-.45*U,ht),I.globalAlpha=.5,I.beginPath(),I.moveTo(u.l,ht),I.lineTo(u.l+u.w,ht),I.lineWidth=1,I.stroke(),I.globalAlpha=1}I.textBaseline="top",I.textAlign="center";let j=u.t+u.h+.45*U;for(let et of[0,.25,.5,.75,1])I.fillText(String(et),m(et),j);I.fillText("path, from 0 to 1",m(.5),j+1.15*U),I.save(),I.translate(.5*U,u.t+u.h/2),I.rotate(-Math.PI/2),I.textBaseline="middle",I.fillText(`turn of the tool, ${_t.symbol("angle")}`,0,0),I.restore()}let L=I=>h?.which===I?h.turn:I==="start"?l.turn[0]:l.turn.at(-1);function N(){o.forEach((I,U)=>{let Z=U?"end":"start",q=!!(l?.turn.length&&l.map);if(I.hidden=!q,!q)return;let j=L(Z);I.style.setProperty("left",`${m(U)}px`),I.style.setProperty("top",`${g(j)}px`),I.classList.toggle("pinned",d[Z]),I.setAttribute("aria-valuemin",gn(u.lo,"angle",0).replace("\u2212","-")),I.setAttribute("aria-valuemax",gn(u.hi,"angle",0).replace("\u2212","-")),I.setAttribute("aria-valuenow",gn(j,"angle").replace("\u2212","-")),I.setAttribute("aria-valuetext",`${ue(j,"angle")}${d[Z]?", held":""}`)})}let z=I=>Math.min(Math.max(I,u.lo),u.hi);function W(I,U){h={which:I,turn:z(U)},N();let Z=rS(l.map,I==="start"?0:1,h.turn);r.hidden=!1,gt(r,`${ue(h.turn,"angle",1)}: ${Z.length?Z.join("; "):"closed on every branch"}`),r.dataset.tone=Z.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",I==="end"),n(I,h.turn)}function B(){if(!h)return;let{which:I,turn:U}=h;r.hidden=!0,t(I,U)}o.forEach((I,U)=>{let Z=U?"end":"start";I.addEventListener("pointerdown",q=>{q.preventDefault(),I.focus(),I.setPointerCapture(q.pointerId);let j=L(Z)-x(q.clientY-a.getBoundingClientRect().top),et=ft=>W(Z,x(ft.clientY-a.getBoundingClientRect().top)+j);I.addEventListener("pointermove",et);let ht=()=>{I.removeEventListener("pointermove",et),B()};I.addEventListener("pointerup",ht,{once:!0}),I.addEventListener("pointercancel",ht,{once:!0})}),I.addEventListener("keydown",q=>{let j={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[q.key];if(j)W(Z,L(Z)+j*qo*(q.shiftKey?.1:1));else if(q.key==="Enter")B();else if(q.key==="Escape"&&h)X(),n(Z,null);else return;q.preventDefault(),q.stopPropagation()}),I.addEventListener("blur",()=>h?.which===Z&&B())}),i.addEventListener("pointerdown",I=>{if(!l?.q.length)return;let U=q=>e(Math.min(Math.max((q.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(I.pointerId),U(I),i.addEventListener("pointermove",U);let Z=()=>i.removeEventListener("pointermove",U);i.addEventListener("pointerup",Z,{once:!0}),i.addEventListener("pointercancel",Z,{once:!0})});function X(){h=null,r.hidden=!0,l&&N()}return new ResizeObserver(qs(A)).observe(a),{el:a,paint(){l&&b(),A()},cancel:X,show(I,U=null,Z={start:!1,end:!1}){l=I,d=Z,h=null,r.hidden=!0,a.hidden=!I,I&&(c=U,b(),A())},only(I){c=I,A()},at(I){s.hidden=I===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${m(I)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(I,U=null){let Z=a.getBoundingClientRect();return[Z.x+m(I==="end"?1:0),Z.y+g(U??L(I))]}}}var cS=Math.PI/180;function uS(){let n=(p,y,m)=>ml({...p,start:null,end:null},y,m),t=(p,y,m)=>{let g=v("span",{class:"field-name"}),x=v("label",{class:"field"},g,m);return x.label=()=>{g.textContent=y==="plain"?p:`${p}, ${_t.symbol(y)}`},x},e=(p,y,m,g,x)=>{let w=Tn({label:p,kind:y,testid:m,check:g,input:x});return{f:w,el:t(p,y,w)}},i=nn("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*cS,45*cS]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,y=>Math.abs(y)<=4*Math.PI?null:"at most two turns",y=>{let m=fo().turn?.slice()??[0,0];m[p]=y,n({turn:m},"bound the turn of the route",`route-turn-${p}`)})),r=nn("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=pn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=v("details",{class:"fold"},v("summary",{text:"More that is free, and what must be kept"}),v("div",{class:"line"},o.el),v("div",{class:"line"},v("label",{class:"field"},v("span",{class:"field-name",text:"Cheapest"}),a)),v("div",{class:"line"},l.el),v("div",{class:"line"},c.el)),h=v("div",{},v("div",{class:"line"},v("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),v("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let p=fo();i.mark(p.turn?"within":"free"),s.forEach((y,m)=>{y.el.hidden=!p.turn,y.f.put(p.turn?.[m]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,l.f.put(p.singularity),c.f.put(p.clearance),c.el.hidden=!M.world.some(y=>y.role!=="object"&&y.kind!=="frame"),d.forEach(y=>y.el.label())}return st(["units","world"],f),st("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var hS=n=>({id:"route",title:"Route",wide:!0,build(t){let e=M.path,i=null,s=null,r=null,o=Uf("route",()=>x()),a=uS(),l=(I,U,Z,q={})=>v("button",{type:"button",text:I,"data-testid":U,on:{click:Z},...q}),c=l("Find the route","find-route",()=>b(),{class:"primary"}),u=l("Let both ends free","free-ends",()=>{ml({start:null,end:null},"let the ends of the route free"),b()}),h=l("Send to the program","route-to-program",W,{hidden:!0}),d=l("","route-others",z,{hidden:!0}),f=v("p",{class:"verdict",role:"status","data-testid":"route-verdict",hidden:!0}),p=v("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),y=v("div",{class:"branches","data-testid":"route-list"}),m=lS({drag:(I,U)=>U===null?ds(null):L(I,U),drop:(I,U)=>N(I,U),scrub:I=>r&&M.motion===r&&Ur(_(I))}),g=v("details",{class:"fold",open:!0},v("summary",{text:"The line"}),o.el);m.el.hidden=!0,u.hidden=!0,t.append(v("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),g,a.el,v("div",{class:"line"},c,u,h),m.el,p,f,v("div",{class:"line"},d),y);let x=()=>{e.from&&e.to&&!i&&Fo(Array.from({length:33},(I,U)=>te(Fd(e.from,e.to,U/32))))},w=I=>{f.hidden=!1,f.dataset.tone="wrong",gt(f,I)};async function b(){let I=Vr(t);if(I){w(I);return}gt(c,"Looking \u2026"),c.disabled=!0;try{let U=await ze("route",Bf());U.stopped||A(U)}catch(U){m.cancel(),w(U.message)}finally{gt(c,"Find the route"),c.disabled=!1}}function A(I){let U=fo();if(i=M.route={...I,turn:T(I,U),asked:[e.from,e.to]},s=I.found?I.branches[I.labels[0]]:null,I.found&&(g.open=!1),f.hidden=!1,f.dataset.tone=I.found?"good":I.verdict==="IMPOSSIBLE"?"wrong":"note",gt(f,I.text),m.show(i,s,{start:!!U.start,end:!!U.end}),ds(null),u.hidden=!(U.start||U.end),h.hidden=!I.found,d.hidden=!1,gt(d,I.found?"Routes that begin with other postures":"What would let it through?"),Vt(y),S(),Fo(I.points),!I.found){r=null,Pi(null);return}let Z=I.q.length;r=sr({table:M.table,q:I.q,xs:I.q.map((q,j)=>j+1),xName:"point",xEnd:Z,seconds:I.s.map(q=>e.seconds*q),title:`${M.table.name}: route, ${Z} points`}),Pi(r)}function T(I,U){if(!I.found||!I.map||!gl(I.map))return I.turn;let Z=U.start?U.start.turn-I.turn[0]:U.end?U.end.turn-I.turn.at(-1):0;return I.turn.map(q=>q+2*Math.PI*Math.round(Z/(2*Math.PI)))}let _=I=>i.s.reduce((U,Z,q)=>Math.abs(Z-I)<Math.abs(i.s[U]-I)?q:U,0);function S(){Vt(p,i.branches.map((I,U)=>{let Z=v("span",{class:"swatch"});return Z.style.setProperty("background",zt.curves[U%zt.curves.length]),v("button",{type:"button",class:"chip","aria-pressed":String(s===I),title:s===I?"Show all branches":"Show this branch alone","data-testid":`route-branch-${U+1}`,on:{click:()=>{s=s===I?null:I,m.only(s),S()}}},Z,I)}))}let D=(I,U)=>{let Z=I==="start",q=Z?0:i.q.length-1;return{T:Z?e.from:e.to,turn:U,free:m0(),near:i.q[q],branch:i.branches[i.labels[q]]}},L=Vs(async(I,U)=>{let Z=await ze("route_posture",D(I,U)).catch(()=>null);ds(Z?.q??null)});async function N(I,U){try{let Z=await ze("route_posture",D(I,U));if(!Z.q)throw new Error(`The route cannot ${I} there. ${Z.why}`);ml({[I]:{turn:U,q:Z.q,branch:Z.label}},`turn the ${I} of the route to ${ue(U,"angle",1)}`),await b()}catch(Z){ds(null),m.cancel(),Fe(Z.message,"wrong")}}async function z(){d.disabled=!0,gt(d,"Looking \u2026");try{let I=await ze("route_others",Bf());if(I.stopped)return;let U=Z=>`cost ${Number(Z.toPrecision(3))}`;Vt(y,I.relaxations.map(Z=>v("p",{class:"verdict","data-tone":"note",text:Z})),I.alternatives.map((Z,q)=>v("button",{type:"button",class:"branch","data-testid":`route-other-${q+1}`,on:{click:async()=>{ml({start:{turn:Z.turn,q:Z.q,branch:Z.branch},end:null},`begin the route ${Z.branch}`),await b()}}},v("span",{class:"branch-name",text:Z.branch}),v("span",{class:"hint",text:`begins turned ${ue(Z.turn,"angle",1)}`}),v("span",{class:"branch-end",text:U(Z.cost)}))),I.relaxations.length+I.alternatives.length?null:v("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),d.hidden=!0}catch(I){w(I.message)}finally{d.disabled=!1,i&&gt(d,i.found?"Routes that begin with other postures":"What would let it through?")}}async function W(){h.disabled=!0;try{let I=await ze("route_program",Bf());if(I.stopped)return;let U=!M.program.length,Z=U?I.steps.slice(1):I.steps;U&&(M.start=I.steps[0].q),Wo([...M.program,...Z],"send the route to the program");let q=`${ue(I.metres,"length",3)} and ${ue(I.radians,"angle",3)}`;Fe(`Sent as a spline through ${I.poses} poses; it strays by at most ${q}.`),n()?.("program")}catch(I){w(I.message)}finally{h.disabled=!1}}let B=()=>{M.routing&&(M.routing={...M.routing,start:null,end:null})};function X(){i=M.route=null,f.hidden=!0,m.show(null),h.hidden=d.hidden=u.hidden=!0,Vt(p),Vt(y),ds(null)}st("panel",I=>{if(I!=="route")return;let U=()=>M.frames.at(-1).slice();e.from??=U(),e.to??=U(),o.show(),x(),i&&m.paint()}),st("played",()=>{!r||M.motion!==r?m.at(null):m.at(i.s[wM()]??null)}),st("motion",()=>M.motion!==r&&m.at(null)),st("theme",()=>{m.paint(),i&&S()}),st("units",()=>m.paint()),st("routing",I=>{I==="undo"&&i&&b()}),st(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(B(),X())}),st("table",I=>{["postures","name","gripper"].includes(I)||(I!=="undo"&&B(),X())}),m.el.addEventListener("where",I=>Object.assign(I.detail,{at:m.place(I.detail.which,I.detail.turn)}))}});var b2=()=>M.frames.at(-1).slice();function dS(n){let t=r=>`edit step ${r+1}`,e=(r,o,a)=>p0(r,o,t(r),{key:`step-${r}-${a}`});function i(r,o,a,l){let c=Tn({label:`Step ${r+1}, ${a}`,testid:`step-${r+1}-${o}`,...l,input:u=>{n(()=>e(r,{[o]:u},o))}});return c.put(M.program[r][o]??null),v("label",{class:"field"},v("span",{class:"field-name",text:l.unit?`${a}, ${l.unit}`:a}),c)}function s(r,o){if(r.kind==="wait")return v("div",{class:"line step-editor"},i(o,"seconds","seconds",{check:l=>l>=0?null:"0 or more"}));if(r.kind==="gripper")return v("div",{class:"line step-editor"},i(o,"value","value",{check:l=>l>=0&&l<=1?null:"from 0, open, to 1, closed"}));if(r.kind==="output")return v("div",{class:"line step-editor"},i(o,"port","port",{check:l=>Number.isInteger(l)&&l>=0?null:"a whole number from 0"}),v("label",{class:"check"},v("input",{type:"checkbox",checked:r.value,on:{change:l=>e(o,{value:l.target.checked},"value")}}),"on"));let a=(l,c)=>Ns(c,`step-${o+1}-${l}`,()=>M.program[o]?.[l],h=>{n(()=>e(o,l==="T"?{T:h,q:null}:{[l]:h},l))}).el;return v("div",{class:"step-editor"},v("div",{class:"line"},pn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"]],r.kind,l=>e(o,{kind:l,q:l==="joint"?r.q??null:null,speed:null,...l==="circle"&&!r.via?{via:r.T}:{}},"kind"),{"data-testid":`step-${o+1}-kind`}),i(o,"blend","blend",{kind:"length",unit:_t.length,check:l=>l>=0?null:"0 or more"}),r.kind==="joint"?i(o,"speed","part of the speed",{empty:null,check:l=>l===null||l>0&&l<=1?null:"above 0 to 1"}):i(o,"speed","speed",{kind:"length",unit:`${_t.length}/s`,empty:null,check:l=>l===null||l>0?null:"more than 0"})),r.kind==="circle"?a("via","Over"):null,a("T",r.q?"To (a taught posture; typing makes it a pose)":"To"),v("div",{class:"line"},v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${o+1}-teach`,on:{click:()=>p0(o,{T:b2(),q:r.kind==="joint"?M.q.slice():null},`teach step ${o+1}`)}}),r.q?v("button",{type:"button",class:"quiet",text:"Go there",on:{click:()=>Ai(r.q.slice(),.8,`go to step ${o+1}`)}}):null))}return s}function fS(){let n=v("div",{class:"line limits-of"}),t=()=>{let e=new Set(M.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=Tn({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>iS({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(Ff()[r]),c===null&&(u.placeholder="none"),v("label",{class:"field"},v("span",{class:"field-name",text:`${o}, ${_t.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Vt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return st(["table","units"],t),st("program",e=>e==="undo"&&t()),t(),n}var pS=200,M2=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],_0={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output"},kf=()=>M.frames.at(-1).slice(),mS={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=v("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=v("p",{class:"verdict",role:"status","data-testid":"program-verdict",hidden:!0}),o=v("details",{class:"fold",hidden:!0},v("summary",{text:"What binds, and when"}),v("p",{class:"hint prose"})),a=(_,S,D,L)=>v("button",{type:"button",text:S,title:D,"data-testid":`step-add-${_}`,on:{click:()=>f(L())}}),l=v("button",{type:"button",class:"primary",text:"Run the program","data-testid":"run-program",on:{click:A}}),c=v("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(v("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:M.q.slice(),T:kf(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:kf(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:kf(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0}))),v("div",{class:"line spread"},c,v("span",{class:"line"},v("button",{type:"button",class:"quiet",text:"Start here","data-testid":"start-here",title:"The program begins in the present posture",on:{click:()=>sS(M.q.slice())}}),v("button",{type:"button",class:"quiet",text:"Go to the start",on:{click:()=>Ai(Of().slice(),.8,"go to the start")}}))),s,fS(),v("div",{class:"line"},l,v("span",{class:"line"},pn("Language of the file",M2,u,_=>{u=_},{"data-testid":"dialect"}),v("button",{type:"button",text:"Save the program","data-testid":"save-program",on:{click:T}}))),r,o);let h=()=>M.program.findLast(_=>_.T)?.T??kf(),d=()=>M.program.findLast(_=>_.kind==="gripper")?.value??0;function f(_){if(M.program.length>=pS){Fe(`At most ${pS} steps.`,"wrong");return}let S=t>=0?t+1:M.program.length;t=S,Wo([...M.program.slice(0,S),_,...M.program.slice(S)],`add a step: ${_0[_.kind].toLowerCase()}`)}function p(_,S){if(S<0||S>=M.program.length||_===S)return;let D=M.program.slice(),[L]=D.splice(_,1);D.splice(S,0,L),t=S,Wo(D,`move step ${_+1} to ${S+1}`),s.children[S]?.querySelector(".step-name")?.focus()}function y(_){t=-1,Wo(M.program.filter((S,D)=>D!==_),`remove step ${_+1}`)}function m(_){return _.kind==="wait"?`${_.seconds} s`:_.kind==="gripper"?_.value===0?"open":_.value===1?"closed":`${_.value}`:_.kind==="output"?`${_.port} ${_.value?"on":"off"}`:_.kind==="joint"&&_.q?_.q.map((S,D)=>gn(S,Ze(M.table.joints[D]??{type:"R"}),1)).join(", "):`${te(_.T).map(S=>gn(S,"length",1)).join(", ")} ${_t.length}`}function g(_,S){let D=S===t,L=v("button",{type:"button",class:"step-name quiet","aria-expanded":String(D),"data-testid":`step-${S+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=D?-1:S,b()},keydown:z=>{let W={ArrowUp:-1,ArrowDown:1}[z.key];W&&z.altKey?(z.preventDefault(),p(S,S+W)):W?(z.preventDefault(),s.children[S+W]?.querySelector(".step-name")?.focus()):z.key==="Delete"&&y(S)}}},v("b",{text:_0[_.kind]}),` ${m(_)}`,_.blend?v("span",{class:"hint",text:`, blend ${ue(_.blend,"length",0)}`}):null),N=v("li",{class:`step${e?.step===S?" failed":""}${D?" open":""}`,draggable:"true","data-testid":`step-row-${S+1}`},v("div",{class:"step-line"},v("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),v("span",{class:"hint",text:String(S+1)}),L,v("button",{type:"button",class:"icon",text:"\u2191",disabled:S===0,"aria-label":`Move step ${S+1} up`,on:{click:()=>p(S,S-1)}}),v("button",{type:"button",class:"icon",text:"\u2193",disabled:S===M.program.length-1,"aria-label":`Move step ${S+1} down`,on:{click:()=>p(S,S+1)}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove step ${S+1}`,on:{click:()=>y(S)}})),e?.step===S?v("p",{class:"reason",text:e.text}):null,D?w(_,S):null);return N.addEventListener("dragstart",z=>{i=S,z.dataTransfer.effectAllowed="move",z.dataTransfer.setData("text/plain",String(S))}),N.addEventListener("dragover",z=>{i<0||(z.preventDefault(),N.classList.add("target"))}),N.addEventListener("dragleave",()=>N.classList.remove("target")),N.addEventListener("drop",z=>{z.preventDefault();let W=i;i=-1,W>=0&&p(W,S)}),N}let x=!1,w=dS(_=>{x=!0,_(),x=!1});function b(){if(x){M.program.forEach((S,D)=>{let L=s.children[D]?.querySelector(".step-name");L&&Vt(L,v("b",{text:_0[S.kind]}),document.createTextNode(` ${m(S)}`))});return}t>=M.program.length&&(t=-1),Vt(s,M.program.map(g)),M.program.length||s.append(v("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.disabled=!M.program.length;let _=Of();gt(c,M.program.length?`Starts at ${_.map((S,D)=>gn(S,Ze(M.table.joints[D]),1)).join(", ")}`:"")}async function A(){r.hidden=!1;let _=Vr(n);if(_){r.dataset.tone="wrong",gt(r,_);return}l.disabled=!0,gt(l,"Planning \u2026");try{let S=await ze("program",{...pl(),world:M.world});e=S.failed,e&&(t=e.step),r.dataset.tone=e||S.clear?.verdict==="HIT"?"wrong":S.clear?.verdict==="UNCERTAIN"?"note":"good",gt(r,e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[S.explain,S.clear?.text].filter(Boolean).join(`
`)),o.hidden=!S.tight.length,gt(o.lastChild,S.tight.map(L=>L.text).join(`
`)),b();let D=S.events.map(([L,N,z])=>({x:L,s:0,text:`${N} ${z} at ${L.toFixed(2)} s`,short:N==="gripper"?z>.5?"close":"open":N,stop:!1}));Pi(Object.assign(sr({table:M.table,q:S.q,xs:S.t,xName:"time",seconds:S.t,dq:S.dq,events:D,title:`${M.table.name}: program, ${S.duration.toFixed(2)} s`}),{ddq:S.ddq,happens:S.events,tight:S.tight,limits:pl().limits}))}catch(S){r.dataset.tone="wrong",gt(r,S.message)}finally{l.disabled=!M.program.length,gt(l,"Run the program")}}async function T(){try{let _="program",{text:S,name:D}=await ze("program_file",{...pl(),dialect:u,name:_});yi(D,S)}catch(_){r.hidden=!1,r.dataset.tone="wrong",gt(r,_.message)}}st(["program","units","table"],_=>{_!=="limits"&&(e=null,b())}),b()}};var $o=new Fn,zf=new Ya,S2=new _e,w2=n=>new si({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function x0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new Je(e,3)),n}var gS=n=>n.rotateX(Math.PI/2),y0={box:n=>[x0(new ls(...n.size)),n.T],cylinder:n=>[x0(gS(new ji(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new H(...n.a),e=new H(...n.b).sub(t),i=e.length(),s=new _e().makeRotationFromQuaternion(new cn().setFromUnitVectors(new H(0,0,1),i?e.clone().normalize():new H(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[x0(gS(new cc(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function v0(n,t,e=.86){if(!y0[n.kind])return null;let[i,s]=y0[n.kind](n),r=w2(t);r.opacity=e,r.depthWrite=e>.5;let o=new mn(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var E2=()=>[...M.world,...M.things??[]];function T2(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=te(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Gs(n.T,s)[o])))}function xS(){yn.add($o,zf.group),st(["world","table"],_S),st("theme",()=>{zf.paint(),_S()})}var tu=new Map;function b0(n,t){if(t)tu.set(n,t);else if(!tu.delete(n))return;let e=$o.children.find(s=>s.userData.name===n),i=M.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),Ee()}var yS=n=>tu.get(n)??null;function vS(){for(let n of[...tu.keys()])b0(n,null)}function _S(){for(let t of $o.children)t.geometry.dispose();$o.clear();let n=E2();for(let t of n)if(t.kind==="curve"){let e=new Ae().setFromPoints(t.points.map(i=>new H(...i)));$o.add(new Js(e,new Zi({color:zt.trace,fog:!1})))}else if(y0[t.kind]){let{mesh:e,T:i}=v0(t,t.role==="object"?zt.accent:zt.ghost);e.matrix.copy(S2.set(...tu.get(t.name)??i)),e.userData.name=t.name,$o.add(e)}zf.show(n.filter(t=>t.kind==="frame"),.11*ai(M.table)),Ir("world",n.flatMap(T2)),Ee()}var bS=()=>$o.children.length+(zf.last?.[0].length??0);var xl=new Js(new Ae,new Zi({depthTest:!1,fog:!1})),yl=new Mr(new Ae,new Ks({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));xl.renderOrder=yl.renderOrder=6;xl.frustumCulled=yl.frustumCulled=!1;xl.visible=yl.visible=!1;var _l=new Fn,eu=null,MS="",R2=()=>M.watch||M.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),C2=Vs(async()=>{try{let n=await ze("clearance",{q:M.q,world:M.world});M.clearance=n}catch(n){M.clearance={refused:n.message}}M0(),dt("clearance")});function SS(){R2()&&M.table.joints.length?C2():M.clearance&&(M.clearance=null,M0(),dt("clearance"))}function M0(){let n=M.clearance,t=!!n?.points?.length;if(xl.visible=yl.visible=t,t){let e=n.points.map(i=>new H(...i));for(let i of[xl,yl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?zt.trace:zt.wrong)}Ee()}async function S0(n){if(eu=null,n){let{bodies:t,explain:e}=await ze("bodies",{});eu=t,MS=e}for(let t of _l.children)t.geometry.dispose();_l.clear();for(let t of eu??[]){let e=v0(t,zt.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},_l.add(e.mesh))}return ES(),MS}var wS=()=>_l.children.length,P2=new _e;function ES(){for(let n of _l.children){let{on:t,T:e}=n.userData;M.frames[t]&&n.matrix.copy(P2.set(...ni(M.frames[t],e)))}Ee()}function TS(){yn.add(xl,yl,_l),st(["q","world","watch"],SS),st("plan",SS),st("q",()=>eu&&ES()),st("table",()=>eu&&S0(!1).then(()=>dt("bodies-gone"))),st("theme",M0)}var L2=60,D2={box:"Box",cylinder:"Cylinder",frame:"Frame"},N2={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function w0(n,t,e={}){dt("did",{label:t,...e}),M.world=n,dt("world")}var Hf=(n,t,e)=>w0(M.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function U2(n,t){if(M.world.length>=L2)return;let e=te(M.frames.at(-1)),i=.06*ai(M.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*M.world.length;let o=t==="object"?"object":n,a=1;for(;M.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};w0([...M.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var AS={id:"world",title:"World",wide:!0,build(n){let t=v("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=v("p",{class:"hint prose"}),i=v("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{M.watch=i.checked,dt("watch")}}}),s=v("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await S0(s.checked);gt(e,s.checked?h:"")}catch(h){gt(e,h.message)}}}}),r=v("div",{class:"things","data-testid":"world"}),o=(h,d,f,p)=>v("button",{type:"button",text:h,title:p,"data-testid":`add-${f}-${d}`,on:{click:()=>U2(d,f)}});n.append(v("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),v("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),v("div",{class:"line"},v("label",{class:"check"},i,"Distance, always"),v("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),st(["clearance","units"],()=>{let h=M.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];gt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${ue(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${ue(-h.metres,"length")}.`))}),st("bodies-gone",()=>{s.checked=!1,gt(e,"")});let l=!1,c=()=>{l||(Vt(r,M.world.map(u)),M.world.length||r.append(v("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=g=>(...x)=>{l=!0,g(...x),l=!1},p=v("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>p.value&&Hf(d,{name:p.value},`name ${p.value}`)}}),y=N2[h.kind].map((g,x)=>{let w=Tn({label:`${h.name}, ${g}`,kind:"length",testid:`world-${d+1}-size-${x}`,check:b=>b>0?null:"more than 0",input:f(b=>{let A=M.world[d],T=h.kind==="box"?{size:A.size.map((_,S)=>S===x?b:_)}:{[x?"h":"r"]:b};Hf(d,T,`size of ${h.name}`)})});return w.put(h.kind==="box"?h.size[x]:x?h.h:h.r),v("label",{class:"field"},v("span",{class:"field-name",text:`${g}, ${_t.length}`}),w)}),m=Ns("Place of its middle",`world-${d+1}`,()=>M.world[d]?.T,f(g=>Hf(d,{T:g},`move ${h.name}`)));return v("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},v("div",{class:"line spread"},v("span",{class:"line"},p,v("span",{class:"hint",text:D2[h.kind]}),h.kind==="frame"?null:pn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,g=>Hf(d,{role:g},`make ${h.name} an ${g}`))),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>w0(M.world.filter((g,x)=>x!==d),`remove ${h.name}`)}})),y.length?v("div",{class:"line"},y):null,m.el)}st(["world","units"],h=>h!=="python"&&c()),c()}};var F2=40,RS={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return M.sequence.postures},set postures(u){M.sequence.postures=u},get rate(){return M.sequence.rate}},e=v("thead"),i=v("tbody"),s=v("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=v("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:c}}),o=v("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let u=t.postures[1];if(u){dt("did",{label:"use the same times for all legs"});for(let h of t.postures.slice(2))h.seconds=u.seconds,h.hold=u.hold;l()}}}});n.append(v("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),v("div",{class:"scroll"},v("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),v("div",{class:"line"},v("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(M.q.slice())}}),v("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(M.table.postures??{}).forEach(([u,h])=>a(h.slice(),u))}}),o),v("div",{class:"line"},r),s);function a(u,h){t.postures.length>=F2||(dt("did",{label:"add a posture to the sequence"}),t.postures.push({name:h??`P${t.postures.length}`,q:u,seconds:5,hold:0}),l(),dt("sequence"))}function l(){let u=M.table.joints;t.postures=t.postures.filter(h=>h.q.length===u.length),r.disabled=t.postures.length<2,Vt(e,v("tr",{},v("th",{text:""}),u.map((h,d)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(d+1)}),v("span",{class:"unit",text:` ${_t.symbol(Ze(h))}`}))),v("th",{text:"leg, s"}),v("th",{text:"rest, s"}),v("th",{"aria-label":"row tools"}))),Vt(i,t.postures.map((h,d)=>{let f=u.map((y,m)=>{let g=Tn({label:`${h.name}, q${m+1}`,kind:Ze(y),testid:`seq-${d}-q${m+1}`,input:x=>{dt("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${m}`}),h.q[m]=x,dt("sequence")}});return g.put(h.q[m],String(Number((h.q[m]*_t.factor(Ze(y))).toFixed(_t.digits(Ze(y))))+0)),v("td",{},g)}),p=(y,m,g)=>{if(d===0)return v("td");let x=Tn({label:`${m} ${h.name}`,testid:`seq-${d}-${y}`,check:g,input:w=>{dt("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${y}`}),h[y]=w,dt("sequence")}});return x.put(h[y]),v("td",{},x)};return v("tr",{"data-testid":`seq-row-${d}`},v("th",{scope:"row"},v("button",{type:"button",class:"quiet",text:h.name,title:"Go there",on:{click:()=>Ai(h.q.slice())}})),f,p("seconds","Seconds to",y=>y>0?null:"more than 0"),p("hold","Rest after",y=>y>=0?null:"0 or more"),v("td",{class:"tools"},v("button",{type:"button",class:"icon",text:"\u2191",disabled:d===0,"aria-label":`Move ${h.name} up`,on:{click:()=>{dt("did",{label:`move ${h.name} up`}),t.postures.splice(d-1,0,...t.postures.splice(d,1)),l()}}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>{dt("did",{label:`remove ${h.name}`}),t.postures.splice(d,1),l(),dt("sequence")}}})))})),t.postures.length||i.append(v("tr",{},v("td",{class:"hint",colspan:String(u.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function c(){s.hidden=!1;let u=Vr(n);if(u){s.dataset.tone="wrong",gt(s,u);return}r.disabled=!0;try{let h=t.postures,d=await ze("motion",{postures:h.map(p=>p.q),seconds:h.slice(1).map(p=>p.seconds),holds:h.slice(1).map(p=>p.hold),rate:t.rate}),f=h.map((p,y)=>({x:d.arrivals[y],s:0,text:`${p.name} at ${d.arrivals[y].toFixed(2)} s`,short:p.name,stop:!1}));s.dataset.tone="good",gt(s,`${h.length} postures in ${d.t[d.t.length-1].toFixed(2)} s. ${O2(d.q)}`),Pi(sr({table:M.table,q:d.q,xs:d.t,xName:"time",seconds:d.t,dq:d.dq,events:f,title:`${M.table.name}: ${h.map(p=>p.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",gt(s,h.message)}finally{r.disabled=t.postures.length<2}}st(["table","units","sequence-loaded"],l),l()}};function O2(n){let t=M.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var B2=.14,po=new mn(new wr(1,32,20),new si({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));po.matrixAutoUpdate=!1;po.visible=!1;po.renderOrder=4;var nu="none";function k2(n,t,e){let i=t_(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function CS(n){nu=n,PS()}var Gf=()=>M.ellipsoid??null;function PS(){let n=nu!=="none"&&M.table.joints.length>0;if(po.visible=n,M.ellipsoid=null,n){let t=k2(M.table,M.q,M.frames),e=B2*ai(M.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(nu==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=te(M.frames.at(-1)),[a,l]=r,c={...r[2]};po.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),po.material.color.set(nu==="velocity"?zt.trace:zt.accent),po.material.side=Ni,M.ellipsoid=t}Ee(),dt("ellipsoid")}function IS(){yn.add(po),st(["q","theme"],()=>nu!=="none"&&PS())}var Vf=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ie(n)),E0=new Ks({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),ki=new Mr(new Ae,E0);ki.frustumCulled=!1;ki.visible=!1;yn.add(ki);var vl=null,iu=null,zi=0,mo={lo:0,hi:1};function LS(n){vl=new Float32Array(3*n),iu=new Float32Array(n),zi=0,ki.geometry.dispose(),ki.geometry=new Ae,ki.geometry.setAttribute("position",new Je(vl,3)),ki.geometry.setAttribute("color",new Je(new Float32Array(3*n),3)),ki.geometry.setDrawRange(0,0),ki.visible=!0,Ee()}function DS(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&zi<iu.length;i+=4,zi++)vl.set(e.subarray(i,i+3),3*zi),iu[zi]=e[i+3];H2()}function H2(){let n=iu.slice(0,zi).sort();mo.lo=n[Math.floor(zi*.02)]??0,mo.hi=n[Math.max(Math.ceil(zi*.98)-1,0)]??1;let t=new ie,e=ki.geometry.attributes.color.array,i=mo.hi-mo.lo||1;for(let s=0;s<zi;s++){let r=Math.min(Math.max((iu[s]-mo.lo)/i,0),1)*(Vf.length-1),o=Math.min(Math.floor(r),Vf.length-2);t.lerpColors(Vf[o],Vf[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}ki.geometry.setDrawRange(0,zi),ki.geometry.attributes.position.needsUpdate=!0,ki.geometry.attributes.color.needsUpdate=!0,Ee()}var su=()=>zi;function NS(n){Qi.localClippingEnabled=n!==null,E0.clippingPlanes=n===null?null:[new ii(new H(0,1,0),-n)],E0.needsUpdate=!0,Ee()}function US(){let n=new Di;for(let i=0;i<zi;i++)n.expandByPoint(new H(vl[3*i],vl[3*i+1],vl[3*i+2]));let{min:t,max:e}=n;return zi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function FS(){zi=0,ki.visible=!1,Ee()}var BS=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],Wf=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?Qn(n,4):n.toExponential(2).replace("-","\u2212"),kS={id:"analysis",title:"Analysis",build(n){let t=v("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(v("div",{title:h},v("dt",{text:u}),i[c]=v("dd",{"data-testid":`fact-${c}`})));let s=v("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=v("p",{class:"hint","data-testid":"ellipsoid-axes"});st("ellipsoid",()=>{let c=Gf();gt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>ue(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,v("h3",{text:"At the tool\u2019s point"}),nn("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",CS,"ellipsoid"),o,v("h3",{text:"Distance to the limits"}),s,v("h3",{text:"Reachable points"}),G2());let a=()=>{r=M.table.joints.map((c,u)=>{let h=v("span",{class:"bar-fill"}),d=v("span",{class:"bar-text"});return{el:v("div",{class:"distance"},v("span",{},v("i",{text:"q"}),v("sub",{text:String(u+1)})),v("span",{class:"bar"},h),d),fill:h,text:d}}),Vt(s,r.map(c=>c.el)),l()},l=qs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let c=mu(M.table,M.q,M.frames),u=c[0],h=c[c.length-1];gt(i.manipulability,Wf(c.reduce((d,f)=>d*f,1))),gt(i.condition,u>1e-9?Qn(h/u,1):"\u221E"),gt(i.least,Wf(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},y)=>{let m=M.table.joints[y],g=M.q[y];if(m.lower===null||m.upper===null){f.style.setProperty("width","100%"),gt(p,"no limit");return}let x=Math.min(g-m.lower,m.upper-g),w=Math.max(2*x/(m.upper-m.lower||1),0);f.style.setProperty("width",`${100*w}%`),d.classList.toggle("outside",x<-1e-9),gt(p,x<-1e-9?`${ue(-x,Ze(m))} beyond`:ue(x,Ze(m)))})});st("table",a),st(["q","units","panel"],l),a()}};function G2(){let n="20000",t="manipulability",e=!1,i=v("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?qi("cancel",{kind:"cloud"}):d()}}),s=v("button",{type:"button",text:"Clear",on:{click:h}}),r=nn("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>NS(f==="half"?M.table.base[7]:null),"cloud-cut"),o=v("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=v("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=v("span"),c=v("span"),u=v("div",{class:"legend-scale",hidden:!0},l,v("span",{class:"scale-bar"}),c);function h(){FS(),Ir("cloud",[]),u.hidden=!0,gt(a,"")}async function d(){e=!0,gt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,LS(Number(n));try{let f=await ze("cloud",{count:Number(n),colour:t,seed:1},p=>{DS(p.points),o.value=p.done/p.of,gt(l,Wf(mo.lo)),gt(c,Wf(mo.hi)),gt(a,`${p.done.toLocaleString("en")} of ${p.of.toLocaleString("en")} points`)});gt(a,f.stopped?`Cancelled after ${su().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${BS.find(([p])=>p===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){gt(a,f.message)}e=!1,Ir("cloud",US()),zc(),gt(i,"Draw the cloud"),o.hidden=!0}return st("table",f=>{f!=="postures"&&f!=="name"&&su()&&h()}),v("div",{},v("div",{class:"line"},pn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),v("span",{class:"field-name",text:"coloured by"}),pn("Coloured by",BS,t,f=>{t=f},{"data-testid":"cloud-colour"})),v("div",{class:"line"},i,s,r),o,u,a)}var zS=n=>({id:"share",title:"Share",build(t,e){let i=v("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=v("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=v("p",{class:"hint",role:"status","data-testid":"report-note"}),o=v("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:u}}),a=v("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(v("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),v("div",{class:"line share-link"},i,v("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>Gr(await rf())}})),v("h3",{text:"As a file"}),v("div",{class:"line"},v("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>yi(`${M.table.name||"arm"}.workbench.json`,JSON.stringify(nf(),null,1),"application/json")}}),v("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,v("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:Lf}})),v("h3",{text:"As Python"}),v("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,v("div",{class:"line"},v("button",{type:"button",text:"Copy the script","data-testid":"copy-python",on:{click:()=>Gr(a.value)}}),v("button",{type:"button",text:"Save the script",on:{click:()=>yi("workbench.py",a.value,"text/x-python")}})),v("h3",{text:"Report"}),v("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),v("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&M.table.joints.length&&(i.value=await rf()),!e.hidden&&M.table.joints.length&&c()},c=Vs(async()=>{try{let{q:d,target:f,hasTarget:p,path:y,program:m}=M,{task:g,redundancy:x}=he,w={q:d,target:p?f:null,path:y,task:g,redundancy:x,program:pl()};a.value=(await ze("python",m.length?w:{...w,program:null})).text}catch(d){a.value=`# ${d.message}`}});st(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await ze("report",{q:M.q},p=>gt(r,p.note));yi(f,d,"text/html"),gt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){gt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");sf(JSON.parse(await f.text()),n()),Fe("Opened")}catch(p){Fe(p instanceof SyntaxError?`${f.name} is not a state file.`:p.message,"wrong")}}}});var V2=40,GS=!1,VS=0,T0=!1,qf=null,HS=null;function WS(n){n&&(GS=!0,qf=M.table,qS(n))}function qS(n){T0=!0,VS=n.said,n.table&&(fn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),qf=M.table),n.things&&W2(n.things),n.target&&(M.hasTarget=!0,xi(n.target,"restored")),n.q&&n.q.length===M.table.joints.length&&(dt("did",{label:"move from Python",key:"python"}),Li(n.q,"python")),T0=!1}function W2(n){M.things=n.filter(i=>i.kind!=="motion"),dt("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==HS){if(HS=e,!t){Pi(null);return}Pi(sr({table:M.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${M.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var q2=oa(V2,()=>{let n=M.table===qf?void 0:ap(M.table);qf=M.table,M.table.joints.length&&qi("shown",{q:M.q,target:M.hasTarget?M.target:null,table:n,said:VS}).catch(()=>{})});function $S(){st("push",qS),st(["q","target","table"],()=>GS&&!T0&&q2.soon())}var Xo=new Fn,YS=new si({fog:!1}),A0=new si({fog:!1}),R0=new ls(1,1,1),C0=new mn(R0,YS),ZS=[new mn(R0,A0),new mn(R0,A0)];Xo.add(C0,...ZS);Xo.matrixAutoUpdate=!1;Xo.visible=!1;var ru=null;function jS(){yn.add(Xo),st("q",()=>ru!==null&&KS()),st("theme",XS),XS()}function XS(){YS.color.set(zt.joint),A0.color.set(zt.accent)}function P0(n){n===null&&ru===null||(ru=n,Xo.visible=n!==null,n!==null&&KS(),Ee())}var JS=()=>ru;function KS(){let n=M.frames.at(-1),t=.075*ai(M.table);C0.scale.set(.35*t,1.1*t,.25*t),C0.position.set(0,0,-.85*t),ZS.forEach((e,i)=>{let s=(.08+.36*(1-ru))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),Xo.matrix.set(...n),Xo.updateMatrixWorld(!0)}var Y2=.25,I0=.5;function Z2(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(M.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=K2(n,r);if(o>=I0&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:rs(Ii(te(u.at(-1).T),te(a)))})).filter(({name:c,d:u})=>u<j2(M.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:ni(hu(a),l.T)}))}else o<I0&&s&&i&&(e.get(i).push({t:r,T:ni(a,e.get(i).at(-1).held)}),i=null);s=o>=I0}return{grips:t,objects:e}}var j2=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function J2(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var K2=(n,t)=>ys(n.table,n.q[J2(n.seconds,t)]).at(-1),go=null,Q2=n=>{let t=go.grips.length?1-Math.round(go.grips[0].value):0;for(let e of go.grips){if(e.t>n)break;let i=Math.min((n-e.t)/Y2,1);t+=i*(e.value-t)}return t};function QS(){st("motion",()=>{vS(),go=M.motion?.happens?Z2(M.motion):null,go||P0(null)}),st("played",n=>{if(!go)return;let t=M.frames.at(-1);go.grips.length&&P0(Q2(n));for(let[e,i]of go.objects){let s=i.findLast(r=>r.t<=n)??i[0];b0(e,s.held?ni(t,s.held):s.T)}})}function tw(){window.workbench=Object.freeze({get q(){return M.q.slice()},get frames(){return structuredClone(M.frames)},get target(){return M.target.slice()},get table(){return structuredClone(M.table)},get solutions(){return structuredClone(M.solutions)},get camera(){return Rd()},get pictures(){return Ty()},get ghosts(){return Sv()},get history(){return[Qd(),tf()]},get beyond(){return vv()},get things(){return bS()},get program(){return structuredClone(M.program)},get route(){return structuredClone(M.route)},routePlace(n,t){let e={which:n,turn:t};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:e})),e.at},get motion(){return structuredClone(M.motion)},get gripper(){return JS()},placeOf:n=>yS(n)??M.world.find(t=>t.name===n)?.T??null,go:Ur,get stepFrame(){return M.dhStep===null?null:Nd().at(-1).T},get clearance(){return structuredClone(M.clearance)},get bodies(){return wS()},get ellipsoid(){return structuredClone(Gf())},get world(){return structuredClone(M.world)},get framesDrawn(){return bv()},get answers(){return fg.answers},get trace(){return Av()},get cloud(){return su()},toScreen:Fi,withPicture:n=>qa(n),handles:()=>Jy(),forward:(n,t)=>ys(n,t),convert:(n,t)=>Pf(n,t),read:(n,t)=>Mf(n,t),present:(n,t,e)=>Df(n,t,e)})}bd();Ay(Ws("#view"));st("theme",Hm);Hm();Dv();gv();Yy();xS();TS();IS();jS();QS();$S();l_();Pv();LM(Ws("#bar"));NM(Ws("#overlay"));SM(Ws("#dock"));UM();var $f,ou=(n,t,...e)=>[{...t,group:n},...e];$f=DM(Ws("#rail"),Ws("#panels"),Ws("#pinned"),[...ou("Drive",{id:"move",title:"Move",sections:[_M,OM]},$M),...ou("Describe",JM,AS),...ou("Plan",eS,hS(()=>$f),mS,RS),...ou("Study",BM,QM,kS),...ou("Hand on",zS(()=>$f))]);AM(Ws("#room"),Ws("#rail"));Hv();var eL=kv().then(n=>n&&sf(n,$f)).catch(n=>Fe(`The link could not be read: ${n.message}`,"wrong"));st("online",async n=>{if(!n)return;await eL;let t=await s_();M.catalog=t.catalog,dt("catalog"),t.table&&(!M.table.joints.length||t.bench)&&(fn(t.table,{q:ra(t.table),step:!1,what:"new"}),ef()),WS(t.bench),document.documentElement.dataset.ready="yes"});M.online&&dt("online",!0);document.fonts?.ready.then(()=>dt("theme"));tw();
