import{A as v,B as Fi,C as Nu,D as fa,E as _n,F as L_,G as Mi,H as D_,I as Uu,K as Ji,L as Zs,a as ji,b as Hn,c as da,d as te,e as Ys,f as Vl,g as Ui,h as Wl,i as Pu,j as us,k as Iu,l as Lu,m as T_,n as A_,o as xr,p as yr,q as R_,r as Es,s as Ap,t as C_,u as ci,v as Du,w as P_,x as I_,y as nt,z as ht}from"./chunk-YTOPIUNI.js";function M(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var St=(n,t,e)=>M("button",{type:"button",text:n,...t,on:{click:e}}),js=(n,t=document)=>t.querySelector(n),Wt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function bt(n,t){n.textContent!==t&&(n.textContent=t)}function Oi(n,t,e="wrong"){n.hidden=!1,n.dataset.tone=e,bt(n,t)}async function pa(n,t,e){let i=Rp(n);if(i)return Oi(t,i);try{await e()}catch(s){Oi(t,s.message)}}function We(n,t,e,i,s){let r=M("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(M("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function xn(n,t,e,i,s={}){let r=M("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>M("option",{value:o,text:a})));return r.value=e,r}function Js(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function ma(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Ks(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function ui(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=M("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Xr(n){try{await navigator.clipboard.writeText(n)}catch{let t=M("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}Me("Copied")}var N_;function Me(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(N_),N_=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Rp(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var ga=0,Ip=-1,Cp=[];function Lp(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Pp(){let n=ga;if(!v.table.joints.length){v.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ht("plan");return}try{let{plan:t}=await Ji("arm",{table:Lp(v.table)});if(n!==ga)return;Ip=n,v.plan=t,U_()}catch(t){if(n!==ga||t instanceof Uu)return;v.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},U_(t)}ht("plan")}function U_(n){let t=Cp;Cp=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var F_=Ks(Pp,60);function O_(){nt("table",n=>{ga+=1,n==="postures"&&(Ip=-1),n==="cell"?F_():(F_.cancel(),Pp())}),nt("online",n=>{n&&(ga+=1,Pp())})}function l1(){return Ip===ga?Promise.resolve():new Promise((n,t)=>Cp.push({resolve:n,reject:t}))}async function Fe(n,t,e){return await l1(),Ji(n,t,e)}function B_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Fu(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var so={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ro={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},vx=0,lm=1,bx=2;var Pc=1,Mx=2,Xa=3,rr=0,Pi=1,fi=2,No=0,Ya=1,cm=2,um=3,hm=4,Sx=5;var Uo=100,wx=101,Ex=102,Tx=103,Ax=104,Rx=200,Cx=201,Px=202,Ix=203,dm=204,fm=205,Lx=206,Dx=207,Nx=208,Ux=209,Fx=210,Ox=211,Bx=212,kx=213,zx=214,fh=0,ph=1,mh=2,Fa=3,gh=4,_h=5,xh=6,yh=7,pm=0,Hx=1,Gx=2,or=0,mm=1,gm=2,_m=3,xm=4,ym=5,vm=6,bm=7;var Mm=300,Fo=301,Za=302,$h=303,qh=304,vh=1e3,tr=1001,bh=1002,ei=1003,Vx=1004;var Ic=1005;var Ei=1006,Xh=1007;var Ir=1008;var is=1009,Sm=1010,wm=1011,ja=1012,Yh=1013,Is=1014,fs=1015,Ls=1016,Zh=1017,jh=1018,Oo=1020,Em=35902,Tm=35899,Am=1021,Rm=1022,Ds=1023,Ar=1026,Lr=1027,Jh=1028,Kh=1029,oo=1030,Qh=1031;var td=1033,Lc=33776,Dc=33777,Nc=33778,Uc=33779,ed=35840,nd=35841,id=35842,sd=35843,rd=36196,od=37492,ad=37496,ld=37488,cd=37489,Fc=37490,ud=37491,hd=37808,dd=37809,fd=37810,pd=37811,md=37812,gd=37813,_d=37814,xd=37815,yd=37816,vd=37817,bd=37818,Md=37819,Sd=37820,wd=37821,Ed=36492,Td=36494,Ad=36495,Rd=36283,Cd=36284,Oc=36285,Pd=36286;var sc=2300,Mh=2301,hh=2302,tm=2303,em=2400,nm=2401,im=2402;var Wx=3200;var Cm=0,$x=1,Dr="",si="srgb",rc="srgb-linear",oc="linear",$e="srgb";var dh=7680,Pm=7681;var Im=517;var qx=519,Xx=512,Yx=513,Zx=514,Lm=515,jx=516,Jx=517,Dm=518,Nm=519,Um=35044,Id=35048;var Fm="300 es",ds=2e3,ac=2001;function u1(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function h1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function lc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Kx(){let n=lc("canvas");return n.style.display="block",n}var k_={},Oa=null;function cc(...n){let t="THREE."+n.shift();Oa?Oa("log",t,...n):console.log(t,...n)}function Qx(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ie(...n){n=Qx(n);let t="THREE."+n.shift();if(Oa)Oa("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function oe(...n){n=Qx(n);let t="THREE."+n.shift();if(Oa)Oa("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ec(...n){let t=n.join(" ");t in k_||(k_[t]=!0,ie(...n))}function ty(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var ey={[fh]:fh,[mh]:xh,[gh]:gh,[Fa]:_h,[ph]:ph,[xh]:mh,[yh]:yh,[_h]:Fa},Cs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},hi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],z_=1234567,nc=Math.PI/180,Ba=180/Math.PI;function ao(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(hi[n&255]+hi[n>>8&255]+hi[n>>16&255]+hi[n>>24&255]+"-"+hi[t&255]+hi[t>>8&255]+"-"+hi[t>>16&15|64]+hi[t>>24&255]+"-"+hi[e&63|128]+hi[e>>8&255]+"-"+hi[e>>16&255]+hi[e>>24&255]+hi[i&255]+hi[i>>8&255]+hi[i>>16&255]+hi[i>>24&255]).toLowerCase()}function Te(n,t,e){return Math.max(t,Math.min(e,n))}function Om(n,t){return(n%t+t)%t}function d1(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function f1(n,t,e){return n!==t?(e-n)/(t-n):0}function ic(n,t,e){return(1-e)*n+e*t}function p1(n,t,e,i){return ic(n,t,1-Math.exp(-e*i))}function m1(n,t=1){return t-Math.abs(Om(n,t*2)-t)}function g1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function _1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function x1(n,t){return n+Math.floor(Math.random()*(t-n+1))}function y1(n,t){return n+Math.random()*(t-n)}function v1(n){return n*(.5-Math.random())}function b1(n){n!==void 0&&(z_=n);let t=z_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function M1(n){return n*nc}function S1(n){return n*Ba}function w1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function E1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Bm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function T1(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ld(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function km(n,t){if(t.constructor===Float32Array)return n;let e=Ld(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function zm(n,t){if(t.constructor===Float32Array)return n;let e=Ld(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var lo={DEG2RAD:nc,RAD2DEG:Ba,generateUUID:ao,clamp:Te,euclideanModulo:Om,mapLinear:d1,inverseLerp:f1,lerp:ic,damp:p1,pingpong:m1,smoothstep:g1,smootherstep:_1,randInt:x1,randFloat:y1,randFloatSpread:v1,seededRandom:b1,degToRad:M1,radToDeg:S1,isPowerOfTwo:w1,ceilPowerOfTwo:E1,floorPowerOfTwo:Bm,setQuaternionFromProperEuler:T1,normalize:zm,denormalize:km},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Te(this.x,t.x,e.x),this.y=Te(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Te(this.x,t,e),this.y=Te(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Te(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Te(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},hn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*y;g<0&&(d=-d,f=-f,p=-p,y=-y,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),E=Math.sin(_);m=Math.sin(m*_)/E,a=Math.sin(a*_)/E,l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+y*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+y*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Te(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(H_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(H_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Te(this.x,t.x,e.x),this.y=Te(this.y,t.y,e.y),this.z=Te(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Te(this.x,t,e),this.y=Te(this.y,t,e),this.z=Te(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Te(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Dp.copy(this).projectOnVector(t),this.sub(Dp)}reflect(t){return this.sub(Dp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Te(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dp=new G,H_=new hn,ue=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],y=s[0],g=s[3],m=s[6],_=s[1],E=s[4],b=s[7],A=s[2],T=s[5],x=s[8];return r[0]=o*y+a*_+l*A,r[3]=o*g+a*E+l*T,r[6]=o*m+a*b+l*x,r[1]=c*y+u*_+h*A,r[4]=c*g+u*E+h*T,r[7]=c*m+u*b+h*x,r[2]=d*y+f*_+p*A,r[5]=d*g+f*E+p*T,r[8]=d*m+f*b+p*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=h*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ec("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Np.makeScale(t,e)),this}rotate(t){return ec("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Np.makeRotation(-t)),this}translate(t,e){return ec("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Np.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Np=new ue,G_=new ue().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),V_=new ue().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function A1(){let n={enabled:!0,workingColorSpace:rc,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===$e&&(s.r=Tr(s.r),s.g=Tr(s.g),s.b=Tr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===$e&&(s.r=Ua(s.r),s.g=Ua(s.g),s.b=Ua(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Dr?oc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[rc]:{primaries:t,whitePoint:i,transfer:oc,toXYZ:G_,fromXYZ:V_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:si},outputColorSpaceConfig:{drawingBufferColorSpace:si}},[si]:{primaries:t,whitePoint:i,transfer:$e,toXYZ:G_,fromXYZ:V_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:si}}}),n}var Le=A1();function Tr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ua(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var _a,Sh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{_a===void 0&&(_a=lc("canvas")),_a.width=t.width,_a.height=t.height;let s=_a.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=_a}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=lc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Tr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Tr(e[i]/255)*255):e[i]=Tr(e[i]);return{data:e,width:t.width,height:t.height}}else return ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},R1=0,ka=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:R1++}),this.uuid=ao(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Up(s[o].image)):r.push(Up(s[o]))}else r=Up(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Up(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Sh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ie("Texture: Unable to serialize Texture."),{})}var C1=0,Fp=new G,Ti=class n extends Cs{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=tr,s=tr,r=Ei,o=Ir,a=Ds,l=is,c=n.DEFAULT_ANISOTROPY,u=Dr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:C1++}),this.uuid=ao(),this.name="",this.source=new ka(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ue,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Fp).x}get height(){return this.source.getSize(Fp).y}get depth(){return this.source.getSize(Fp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ie(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Mm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case vh:t.x=t.x-Math.floor(t.x);break;case tr:t.x=t.x<0?0:1;break;case bh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case vh:t.y=t.y-Math.floor(t.y);break;case tr:t.y=t.y<0?0:1;break;case bh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ti.DEFAULT_IMAGE=null;Ti.DEFAULT_MAPPING=Mm;Ti.DEFAULT_ANISOTROPY=1;var vn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],y=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,b=(f+1)/2,A=(m+1)/2,T=(u+d)/4,x=(h+y)/4,S=(p+g)/4;return E>b&&E>A?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=T/i,r=x/i):b>A?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=S/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=x/r,s=S/r),this.set(i,s,r,e),this}let _=Math.sqrt((g-p)*(g-p)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(h-y)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Te(this.x,t.x,e.x),this.y=Te(this.y,t.y,e.y),this.z=Te(this.z,t.z,e.z),this.w=Te(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Te(this.x,t,e),this.y=Te(this.y,t,e),this.z=Te(this.z,t,e),this.w=Te(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Te(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},wh=class extends Cs{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ei,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new vn(0,0,t,e),this.scissorTest=!1,this.viewport=new vn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ti({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ei,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ka(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ts=class extends wh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},uc=class extends Ti{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ei,this.minFilter=ei,this.wrapR=tr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Eh=class extends Ti{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ei,this.minFilter=ei,this.wrapR=tr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var _e=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,g)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,y,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=p,m[11]=y,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/xa.setFromMatrixColumn(t,0).length(),r=1/xa.setFromMatrixColumn(t,1).length(),o=1/xa.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-y*c,e[9]=-a*l,e[2]=y-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,y=c*h;e[0]=d+y*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=y+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,y=c*h;e[0]=d-y*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=y-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,y=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+y,e[1]=l*h,e[5]=y*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=y-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-y*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+y,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=y*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(P1,t,I1)}lookAt(t,e,i){let s=this.elements;return Ki.subVectors(t,e),Ki.lengthSq()===0&&(Ki.z=1),Ki.normalize(),Yr.crossVectors(i,Ki),Yr.lengthSq()===0&&(Math.abs(i.z)===1?Ki.x+=1e-4:Ki.z+=1e-4,Ki.normalize(),Yr.crossVectors(i,Ki)),Yr.normalize(),Ou.crossVectors(Ki,Yr),s[0]=Yr.x,s[4]=Ou.x,s[8]=Ki.x,s[1]=Yr.y,s[5]=Ou.y,s[9]=Ki.y,s[2]=Yr.z,s[6]=Ou.z,s[10]=Ki.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],y=i[6],g=i[10],m=i[14],_=i[3],E=i[7],b=i[11],A=i[15],T=s[0],x=s[4],S=s[8],D=s[12],I=s[1],N=s[5],H=s[9],V=s[13],k=s[2],O=s[6],L=s[10],F=s[14],j=s[3],X=s[7],J=s[11],et=s[15];return r[0]=o*T+a*I+l*k+c*j,r[4]=o*x+a*N+l*O+c*X,r[8]=o*S+a*H+l*L+c*J,r[12]=o*D+a*V+l*F+c*et,r[1]=u*T+h*I+d*k+f*j,r[5]=u*x+h*N+d*O+f*X,r[9]=u*S+h*H+d*L+f*J,r[13]=u*D+h*V+d*F+f*et,r[2]=p*T+y*I+g*k+m*j,r[6]=p*x+y*N+g*O+m*X,r[10]=p*S+y*H+g*L+m*J,r[14]=p*D+y*V+g*F+m*et,r[3]=_*T+E*I+b*k+A*j,r[7]=_*x+E*N+b*O+A*X,r[11]=_*S+E*H+b*L+A*J,r[15]=_*D+E*V+b*F+A*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],y=t[7],g=t[11],m=t[15],_=l*f-c*d,E=a*f-c*h,b=a*d-l*h,A=o*f-c*u,T=o*d-l*u,x=o*h-a*u;return e*(y*_-g*E+m*b)-i*(p*_-g*A+m*T)+s*(p*E-y*A+m*x)-r*(p*b-y*T+g*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],y=t[13],g=t[14],m=t[15],_=e*a-i*o,E=e*l-s*o,b=e*c-r*o,A=i*l-s*a,T=i*c-r*a,x=s*c-r*l,S=u*y-h*p,D=u*g-d*p,I=u*m-f*p,N=h*g-d*y,H=h*m-f*y,V=d*m-f*g,k=_*V-E*H+b*N+A*I-T*D+x*S;if(k===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let O=1/k;return t[0]=(a*V-l*H+c*N)*O,t[1]=(s*H-i*V-r*N)*O,t[2]=(y*x-g*T+m*A)*O,t[3]=(d*T-h*x-f*A)*O,t[4]=(l*I-o*V-c*D)*O,t[5]=(e*V-s*I+r*D)*O,t[6]=(g*b-p*x-m*E)*O,t[7]=(u*x-d*b+f*E)*O,t[8]=(o*H-a*I+c*S)*O,t[9]=(i*I-e*H-r*S)*O,t[10]=(p*T-y*b+m*_)*O,t[11]=(h*b-u*T-f*_)*O,t[12]=(a*D-o*N-l*S)*O,t[13]=(e*N-i*D+s*S)*O,t[14]=(y*E-p*A-g*_)*O,t[15]=(u*A-h*E+d*_)*O,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,y=o*u,g=o*h,m=a*h,_=l*c,E=l*u,b=l*h,A=i.x,T=i.y,x=i.z;return s[0]=(1-(y+m))*A,s[1]=(f+b)*A,s[2]=(p-E)*A,s[3]=0,s[4]=(f-b)*T,s[5]=(1-(d+m))*T,s[6]=(g+_)*T,s[7]=0,s[8]=(p+E)*x,s[9]=(g-_)*x,s[10]=(1-(d+y))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=xa.set(s[0],s[1],s[2]).length(),a=xa.set(s[4],s[5],s[6]).length(),l=xa.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ts.copy(this);let c=1/o,u=1/a,h=1/l;return Ts.elements[0]*=c,Ts.elements[1]*=c,Ts.elements[2]*=c,Ts.elements[4]*=u,Ts.elements[5]*=u,Ts.elements[6]*=u,Ts.elements[8]*=h,Ts.elements[9]*=h,Ts.elements[10]*=h,e.setFromRotationMatrix(Ts),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=ds,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===ds)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===ac)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=ds,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===ds)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===ac)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},xa=new G,Ts=new _e,P1=new G(0,0,0),I1=new G(1,1,1),Yr=new G,Ou=new G,Ki=new G,W_=new _e,$_=new hn,Qr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Te(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Te(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Te(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Te(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Te(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Te(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return W_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(W_,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return $_.setFromEuler(this),this.setFromQuaternion($_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Qr.DEFAULT_ORDER="XYZ";var za=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},L1=0,q_=new G,ya=new hn,vr=new _e,Bu=new G,$l=new G,D1=new G,N1=new hn,X_=new G(1,0,0),Y_=new G(0,1,0),Z_=new G(0,0,1),j_={type:"added"},U1={type:"removed"},va={type:"childadded",child:null},Op={type:"childremoved",child:null},Ai=class n extends Cs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:L1++}),this.uuid=ao(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new G,e=new Qr,i=new hn,s=new G(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new _e},normalMatrix:{value:new ue}}),this.matrix=new _e,this.matrixWorld=new _e,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new za,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ya.setFromAxisAngle(t,e),this.quaternion.multiply(ya),this}rotateOnWorldAxis(t,e){return ya.setFromAxisAngle(t,e),this.quaternion.premultiply(ya),this}rotateX(t){return this.rotateOnAxis(X_,t)}rotateY(t){return this.rotateOnAxis(Y_,t)}rotateZ(t){return this.rotateOnAxis(Z_,t)}translateOnAxis(t,e){return q_.copy(t).applyQuaternion(this.quaternion),this.position.add(q_.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(X_,t)}translateY(t){return this.translateOnAxis(Y_,t)}translateZ(t){return this.translateOnAxis(Z_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(vr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Bu.copy(t):Bu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),$l.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vr.lookAt($l,Bu,this.up):vr.lookAt(Bu,$l,this.up),this.quaternion.setFromRotationMatrix(vr),s&&(vr.extractRotation(s.matrixWorld),ya.setFromRotationMatrix(vr),this.quaternion.premultiply(ya.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(oe("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(j_),va.child=t,this.dispatchEvent(va),va.child=null):oe("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(U1),Op.child=t,this.dispatchEvent(Op),Op.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),vr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),vr.multiply(t.parent.matrixWorld)),t.applyMatrix4(vr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(j_),va.child=t,this.dispatchEvent(va),va.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($l,t,D1),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($l,N1,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ai.DEFAULT_UP=new G(0,1,0);Ai.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ai.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var An=class extends Ai{constructor(){super(),this.isGroup=!0,this.type="Group"}},F1={type:"move"},Ha=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new An,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new An,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new An,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,i),m=this._getHandJoint(c,y);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(F1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new An;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},ny={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zr={h:0,s:0,l:0},ku={h:0,s:0,l:0};function Bp(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ne=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=si){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Le.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Le.workingColorSpace){return this.r=t,this.g=e,this.b=i,Le.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Le.workingColorSpace){if(t=Om(t,1),e=Te(e,0,1),i=Te(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Bp(o,r,t+1/3),this.g=Bp(o,r,t),this.b=Bp(o,r,t-1/3)}return Le.colorSpaceToWorking(this,s),this}setStyle(t,e=si){function i(r){r!==void 0&&parseFloat(r)<1&&ie("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ie("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ie("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=si){let i=ny[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ie("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Tr(t.r),this.g=Tr(t.g),this.b=Tr(t.b),this}copyLinearToSRGB(t){return this.r=Ua(t.r),this.g=Ua(t.g),this.b=Ua(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=si){return Le.workingToColorSpace(di.copy(this),t),Math.round(Te(di.r*255,0,255))*65536+Math.round(Te(di.g*255,0,255))*256+Math.round(Te(di.b*255,0,255))}getHexString(t=si){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Le.workingColorSpace){Le.workingToColorSpace(di.copy(this),e);let i=di.r,s=di.g,r=di.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Le.workingColorSpace){return Le.workingToColorSpace(di.copy(this),e),t.r=di.r,t.g=di.g,t.b=di.b,t}getStyle(t=si){Le.workingToColorSpace(di.copy(this),t);let e=di.r,i=di.g,s=di.b;return t!==si?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Zr),this.setHSL(Zr.h+t,Zr.s+e,Zr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Zr),t.getHSL(ku);let i=ic(Zr.h,ku.h,e),s=ic(Zr.s,ku.s,e),r=ic(Zr.l,ku.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},di=new ne;ne.NAMES=ny;var hc=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ne(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},dc=class extends Ai{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Qr,this.environmentIntensity=1,this.environmentRotation=new Qr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},As=new G,br=new G,kp=new G,Mr=new G,ba=new G,Ma=new G,J_=new G,zp=new G,Hp=new G,Gp=new G,Vp=new vn,Wp=new vn,$p=new vn,Er=class n{constructor(t=new G,e=new G,i=new G){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),As.subVectors(t,e),s.cross(As);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){As.subVectors(s,e),br.subVectors(i,e),kp.subVectors(t,e);let o=As.dot(As),a=As.dot(br),l=As.dot(kp),c=br.dot(br),u=br.dot(kp),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Mr)===null?!1:Mr.x>=0&&Mr.y>=0&&Mr.x+Mr.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Mr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Mr.x),l.addScaledVector(o,Mr.y),l.addScaledVector(a,Mr.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Vp.setScalar(0),Wp.setScalar(0),$p.setScalar(0),Vp.fromBufferAttribute(t,e),Wp.fromBufferAttribute(t,i),$p.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Vp,r.x),o.addScaledVector(Wp,r.y),o.addScaledVector($p,r.z),o}static isFrontFacing(t,e,i,s){return As.subVectors(i,e),br.subVectors(t,e),As.cross(br).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return As.subVectors(this.c,this.b),br.subVectors(this.a,this.b),As.cross(br).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ba.subVectors(s,i),Ma.subVectors(r,i),zp.subVectors(t,i);let l=ba.dot(zp),c=Ma.dot(zp);if(l<=0&&c<=0)return e.copy(i);Hp.subVectors(t,s);let u=ba.dot(Hp),h=Ma.dot(Hp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(ba,o);Gp.subVectors(t,r);let f=ba.dot(Gp),p=Ma.dot(Gp);if(p>=0&&f<=p)return e.copy(r);let y=f*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Ma,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return J_.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(J_,a);let m=1/(g+y+d);return o=y*m,a=d*m,e.copy(i).addScaledVector(ba,o).addScaledVector(Ma,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Bi=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Rs.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Rs.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Rs.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Rs):Rs.fromBufferAttribute(r,o),Rs.applyMatrix4(t.matrixWorld),this.expandByPoint(Rs);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),zu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),zu.copy(i.boundingBox)),zu.applyMatrix4(t.matrixWorld),this.union(zu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Rs),Rs.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ql),Hu.subVectors(this.max,ql),Sa.subVectors(t.a,ql),wa.subVectors(t.b,ql),Ea.subVectors(t.c,ql),jr.subVectors(wa,Sa),Jr.subVectors(Ea,wa),Eo.subVectors(Sa,Ea);let e=[0,-jr.z,jr.y,0,-Jr.z,Jr.y,0,-Eo.z,Eo.y,jr.z,0,-jr.x,Jr.z,0,-Jr.x,Eo.z,0,-Eo.x,-jr.y,jr.x,0,-Jr.y,Jr.x,0,-Eo.y,Eo.x,0];return!qp(e,Sa,wa,Ea,Hu)||(e=[1,0,0,0,1,0,0,0,1],!qp(e,Sa,wa,Ea,Hu))?!1:(Gu.crossVectors(jr,Jr),e=[Gu.x,Gu.y,Gu.z],qp(e,Sa,wa,Ea,Hu))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Rs).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Rs).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Sr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Sr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Sr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Sr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Sr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Sr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Sr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Sr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Sr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Sr=[new G,new G,new G,new G,new G,new G,new G,new G],Rs=new G,zu=new Bi,Sa=new G,wa=new G,Ea=new G,jr=new G,Jr=new G,Eo=new G,ql=new G,Hu=new G,Gu=new G,To=new G;function qp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){To.fromArray(n,r);let a=s.x*Math.abs(To.x)+s.y*Math.abs(To.y)+s.z*Math.abs(To.z),l=t.dot(To),c=e.dot(To),u=i.dot(To);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var On=new G,Vu=new Yt,O1=0,ke=class extends Cs{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:O1++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Um,this.updateRanges=[],this.gpuType=fs,this.version=0,this._normalizationScale=t!==void 0?Ld(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Vu.fromBufferAttribute(this,e),Vu.applyMatrix3(t),this.setXY(e,Vu.x,Vu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.applyMatrix3(t),this.setXYZ(e,On.x,On.y,On.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.applyMatrix4(t),this.setXYZ(e,On.x,On.y,On.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.applyNormalMatrix(t),this.setXYZ(e,On.x,On.y,On.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.transformDirection(t),this.setXYZ(e,On.x,On.y,On.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):km(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):zm(t,this.array)}};var fc=class extends ke{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var pc=class extends ke{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ae=class extends ke{constructor(t,e,i){super(new Float32Array(t),e,i)}},B1=new Bi,Xl=new G,Xp=new G,er=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):B1.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Xl.subVectors(t,this.center);let e=Xl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Xl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Xp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Xl.copy(t.center).add(Xp)),this.expandByPoint(Xl.copy(t.center).sub(Xp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},k1=0,hs=new _e,Yp=new Ai,Ta=new G,Qi=new Bi,Yl=new Bi,ti=new G,Se=class n extends Cs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=ao(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(u1(t)?pc:fc)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ue().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return hs.makeRotationFromQuaternion(t),this.applyMatrix4(hs),this}rotateX(t){return hs.makeRotationX(t),this.applyMatrix4(hs),this}rotateY(t){return hs.makeRotationY(t),this.applyMatrix4(hs),this}rotateZ(t){return hs.makeRotationZ(t),this.applyMatrix4(hs),this}translate(t,e,i){return hs.makeTranslation(t,e,i),this.applyMatrix4(hs),this}scale(t,e,i){return hs.makeScale(t,e,i),this.applyMatrix4(hs),this}lookAt(t){return Yp.lookAt(t),Yp.updateMatrix(),this.applyMatrix4(Yp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ta).negate(),this.translate(Ta.x,Ta.y,Ta.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ae(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Bi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){oe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Qi.setFromBufferAttribute(r),this.morphTargetsRelative?(ti.addVectors(this.boundingBox.min,Qi.min),this.boundingBox.expandByPoint(ti),ti.addVectors(this.boundingBox.max,Qi.max),this.boundingBox.expandByPoint(ti)):(this.boundingBox.expandByPoint(Qi.min),this.boundingBox.expandByPoint(Qi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&oe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new er);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){oe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let i=this.boundingSphere.center;if(Qi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Yl.setFromBufferAttribute(a),this.morphTargetsRelative?(ti.addVectors(Qi.min,Yl.min),Qi.expandByPoint(ti),ti.addVectors(Qi.max,Yl.max),Qi.expandByPoint(ti)):(Qi.expandByPoint(Yl.min),Qi.expandByPoint(Yl.max))}Qi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)ti.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(ti));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)ti.fromBufferAttribute(a,c),l&&(Ta.fromBufferAttribute(t,c),ti.add(Ta)),s=Math.max(s,i.distanceToSquared(ti))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&oe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){oe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ke(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new G,l[D]=new G;let u=new G,h=new G,d=new G,f=new Yt,p=new Yt,y=new Yt,g=new G,m=new G;function _(D,I,N){c[D]=c[I]=c[N]=1,u.fromBufferAttribute(i,D),h.fromBufferAttribute(i,I),d.fromBufferAttribute(i,N),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,I),y.fromBufferAttribute(r,N),h.sub(u),d.sub(u),p.sub(f),y.sub(f);let H=1/(p.x*y.y-y.x*p.y);isFinite(H)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(d,-p.y).multiplyScalar(H),m.copy(d).multiplyScalar(p.x).addScaledVector(h,-y.x).multiplyScalar(H),a[D].add(g),a[I].add(g),a[N].add(g),l[D].add(m),l[I].add(m),l[N].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let D=0,I=E.length;D<I;++D){let N=E[D],H=N.start,V=N.count;for(let k=H,O=H+V;k<O;k+=3)_(t.getX(k+0),t.getX(k+1),t.getX(k+2))}let b=new G,A=new G,T=new G,x=new G;function S(D){T.fromBufferAttribute(s,D),x.copy(T);let I=a[D];b.copy(I),b.sub(T.multiplyScalar(T.dot(I))).normalize(),A.crossVectors(x,I);let H=A.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,H)}for(let D=0,I=i.count;D<I;++D)c[D]&&S(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ke(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,h=new G;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),y=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)ti.fromBufferAttribute(t,e),ti.normalize(),t.setXYZ(e,ti.x,ti.y,ti.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let m=0;m<u;m++)d[p++]=c[f++]}return new ke(d,u,h)}if(this.index===null)return ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Co=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Um,this.updateRanges=[],this.version=0,this.uuid=ao()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=K_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=K_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function K_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=ao()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Si=new G,to=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Ld(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Si.fromBufferAttribute(this,e),Si.applyMatrix4(t),this.setXYZ(e,Si.x,Si.y,Si.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Si.fromBufferAttribute(this,e),Si.applyNormalMatrix(t),this.setXYZ(e,Si.x,Si.y,Si.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Si.fromBufferAttribute(this,e),Si.transformDirection(t),this.setXYZ(e,Si.x,Si.y,Si.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){cc("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new ke(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){cc("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):km(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):zm(t,this.data.array)}},Zp=new G,z1=new G,H1=new ue,ri=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Zp.subVectors(i,e).cross(z1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Zp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||H1.getNormalMatrix(t),s=this.coplanarPoint(Zp).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},G1=0,nr=class extends Cs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:G1++}),this.uuid=ao(),this.name="",this.type="Material",this.blending=Ya,this.side=rr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=dm,this.blendDst=fm,this.blendEquation=Uo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ne(0,0,0),this.blendAlpha=0,this.depthFunc=Fa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=qx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=dh,this.stencilZFail=dh,this.stencilZPass=dh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ie(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ne().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ri().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Ga=class extends nr{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ne(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Aa,Zl=new G,Ra=new G,Ca=new G,Pa=new Yt,jl=new Yt,iy=new _e,Wu=new G,Jl=new G,$u=new G,Q_=new Yt,jp=new Yt,tx=new Yt,mc=class extends Ai{constructor(t=new Ga){if(super(),this.isSprite=!0,this.type="Sprite",Aa===void 0){Aa=new Se;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Co(e,5);Aa.setIndex([0,1,2,0,2,3]),Aa.setAttribute("position",new to(i,3,0,!1)),Aa.setAttribute("uv",new to(i,2,3,!1))}this.geometry=Aa,this.material=t,this.center=new Yt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&oe('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Ra.setFromMatrixScale(this.matrixWorld),iy.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Ca.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Ra.multiplyScalar(-Ca.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;qu(Wu.set(-.5,-.5,0),Ca,o,Ra,s,r),qu(Jl.set(.5,-.5,0),Ca,o,Ra,s,r),qu($u.set(.5,.5,0),Ca,o,Ra,s,r),Q_.set(0,0),jp.set(1,0),tx.set(1,1);let a=t.ray.intersectTriangle(Wu,Jl,$u,!1,Zl);if(a===null&&(qu(Jl.set(-.5,.5,0),Ca,o,Ra,s,r),jp.set(0,1),a=t.ray.intersectTriangle(Wu,$u,Jl,!1,Zl),a===null))return;let l=t.ray.origin.distanceTo(Zl);l<t.near||l>t.far||e.push({distance:l,point:Zl.clone(),uv:Er.getInterpolation(Zl,Wu,Jl,$u,Q_,jp,tx,new Yt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function qu(n,t,e,i,s,r){Pa.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(jl.x=r*Pa.x-s*Pa.y,jl.y=s*Pa.x+r*Pa.y):jl.copy(Pa),n.copy(t),n.x+=jl.x,n.y+=jl.y,n.applyMatrix4(iy)}var wr=new G,Jp=new G,Xu=new G,Yu=new G,Rr=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,wr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=wr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(wr.copy(this.origin).addScaledVector(this.direction,e),wr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Jp.copy(t).add(e).multiplyScalar(.5),Xu.copy(e).sub(t).normalize(),Yu.copy(this.origin).sub(Jp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Xu),a=Yu.dot(this.direction),l=-Yu.dot(Xu),c=Yu.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Jp).addScaledVector(Xu,d),f}intersectSphere(t,e){if(t.radius<0)return null;wr.subVectors(t.center,this.origin);let i=wr.dot(this.direction),s=wr.dot(wr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,wr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,y=e.y-o.y,g=e.z-o.z,m=i.x-o.x,_=i.y-o.y,E=i.z-o.z,b=Math.abs(l),A=Math.abs(c),T=Math.abs(u),x,S,D,I,N,H,V,k,O,L,F,j;if(b>=A&&b>=T?(D=l,H=h,O=p,j=m,l>=0?(x=c,S=u,I=d,N=f,V=y,k=g,L=_,F=E):(x=u,S=c,I=f,N=d,V=g,k=y,L=E,F=_)):A>=T?(D=c,H=d,O=y,j=_,c>=0?(x=u,S=l,I=f,N=h,V=g,k=p,L=E,F=m):(x=l,S=u,I=h,N=f,V=p,k=g,L=m,F=E)):(D=u,H=f,O=g,j=E,u>=0?(x=l,S=c,I=h,N=d,V=p,k=y,L=m,F=_):(x=c,S=l,I=d,N=h,V=y,k=p,L=_,F=m)),D===0)return null;let X=x/D,J=S/D,et=1/D,dt=I-X*H,ft=N-J*H,st=V-X*O,yt=k-J*O,_t=L-X*j,At=F-J*j,Rt=_t*yt-At*st,Kt=dt*At-ft*_t,me=st*ft-yt*dt;if(s){if(Rt<0||Kt<0||me<0)return null}else if((Rt<0||Kt<0||me<0)&&(Rt>0||Kt>0||me>0))return null;let jt=Rt+Kt+me;if(jt===0)return null;let Ee=et*(Rt*H+Kt*O+me*j);return(jt>0?Ee<0:Ee>0)?null:this.at(Ee/jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},oi=class extends nr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ne(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qr,this.combine=pm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},ex=new _e,Ao=new Rr,Zu=new er,nx=new G,ju=new G,Ju=new G,Ku=new G,Kp=new G,Qu=new G,ix=new G,th=new G,je=class extends Ai{constructor(t=new Se,e=new oi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Qu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Kp.fromBufferAttribute(h,t),o?Qu.addScaledVector(Kp,u):Qu.addScaledVector(Kp.sub(e),u))}e.add(Qu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Zu.copy(i.boundingSphere),Zu.applyMatrix4(r),Ao.copy(t.ray).recast(t.near),!(Zu.containsPoint(Ao.origin)===!1&&(Ao.intersectSphere(Zu,nx)===null||Ao.origin.distanceToSquared(nx)>(t.far-t.near)**2))&&(ex.copy(r).invert(),Ao.copy(t.ray).applyMatrix4(ex),!(i.boundingBox!==null&&Ao.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Ao)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),E=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=_,A=E;b<A;b+=3){let T=a.getX(b),x=a.getX(b+1),S=a.getX(b+2);s=eh(this,m,t,i,c,u,h,T,x,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let g=p,m=y;g<m;g+=3){let _=a.getX(g),E=a.getX(g+1),b=a.getX(g+2);s=eh(this,o,t,i,c,u,h,_,E,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=d.length;p<y;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),E=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=_,A=E;b<A;b+=3){let T=b,x=b+1,S=b+2;s=eh(this,m,t,i,c,u,h,T,x,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let g=p,m=y;g<m;g+=3){let _=g,E=g+1,b=g+2;s=eh(this,o,t,i,c,u,h,_,E,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function V1(n,t,e,i,s,r,o,a){let l;if(t.side===Pi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===rr,a),l===null)return null;th.copy(a),th.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(th);return c<e.near||c>e.far?null:{distance:c,point:th.clone(),object:n}}function eh(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ju),n.getVertexPosition(l,Ju),n.getVertexPosition(c,Ku);let u=V1(n,t,e,i,ju,Ju,Ku,ix);if(u){let h=new G;Er.getBarycoord(ix,ju,Ju,Ku,h),s&&(u.uv=Er.getInterpolatedAttribute(s,a,l,c,h,new Yt)),r&&(u.uv1=Er.getInterpolatedAttribute(r,a,l,c,h,new Yt)),o&&(u.normal=Er.getInterpolatedAttribute(o,a,l,c,h,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new G,materialIndex:0};Er.getNormal(ju,Ju,Ku,d.normal),u.face=d,u.barycoord=h}return u}var gc=class extends Ti{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ei,u=ei,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Va=class extends ke{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ia=new _e,sx=new _e,nh=[],rx=new Bi,W1=new _e,Kl=new je,Ql=new er,_c=class extends je{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Va(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,W1)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Bi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ia),rx.copy(t.boundingBox).applyMatrix4(Ia),this.boundingBox.union(rx)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new er),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ia),Ql.copy(t.boundingSphere).applyMatrix4(Ia),this.boundingSphere.union(Ql)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Kl.geometry=this.geometry,Kl.material=this.material,Kl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ql.copy(this.boundingSphere),Ql.applyMatrix4(i),t.ray.intersectsSphere(Ql)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ia),sx.multiplyMatrices(i,Ia),Kl.matrixWorld=sx,Kl.raycast(t,nh);for(let o=0,a=nh.length;o<a;o++){let l=nh[o];l.instanceId=r,l.object=this,e.push(l)}nh.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Va(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new gc(new Float32Array(s*this.count),s,this.count,Jh,fs));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ro=new er,$1=new Yt(.5,.5),ih=new G,Po=class{constructor(t=new ri,e=new ri,i=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=ds,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],y=r[9],g=r[10],m=r[11],_=r[12],E=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,m-p,A-_).normalize(),s[1].setComponents(c+o,f+u,m+p,A+_).normalize(),s[2].setComponents(c+a,f+h,m+y,A+E).normalize(),s[3].setComponents(c-a,f-h,m-y,A-E).normalize(),i)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,m-g,A-b).normalize();else if(s[4].setComponents(c-l,f-d,m-g,A-b).normalize(),e===ds)s[5].setComponents(c+l,f+d,m+g,A+b).normalize();else if(e===ac)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ro.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ro.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ro)}intersectsSprite(t){Ro.center.set(0,0,0);let e=$1.distanceTo(t.center);return Ro.radius=.7071067811865476+e,Ro.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ro)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ih.x=s.normal.x>0?t.max.x:t.min.x,ih.y=s.normal.y>0?t.max.y:t.min.y,ih.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ih)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ox=new _e,Th=class n{constructor(){this.coordinateSystem=ds,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];ox.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Po),i[s].setFromProjectionMatrix(ox,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Po),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var es=class extends nr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ne(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ah=new G,Rh=new G,ax=new _e,tc=new Rr,sh=new er,Qp=new G,lx=new G,ir=class extends Ai{constructor(t=new Se,e=new es){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ah.fromBufferAttribute(e,s-1),Rh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ah.distanceTo(Rh);t.setAttribute("lineDistance",new Ae(i,1))}else ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),sh.copy(i.boundingSphere),sh.applyMatrix4(s),sh.radius+=r,t.ray.intersectsSphere(sh)===!1)return;ax.copy(s).invert(),tc.copy(t.ray).applyMatrix4(ax);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=f,g=p-1;y<g;y+=c){let m=u.getX(y),_=u.getX(y+1),E=rh(this,t,tc,l,m,_,y);E&&e.push(E)}if(this.isLineLoop){let y=u.getX(p-1),g=u.getX(f),m=rh(this,t,tc,l,y,g,p-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let y=f,g=p-1;y<g;y+=c){let m=rh(this,t,tc,l,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=rh(this,t,tc,l,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function rh(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ah.fromBufferAttribute(a,s),Rh.fromBufferAttribute(a,r),e.distanceSqToSegment(Ah,Rh,Qp,lx)>i)return;Qp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Qp);if(!(c<t.near||c>t.far))return{distance:c,point:lx.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var cx=new G,ux=new G,Io=class extends ir{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)cx.fromBufferAttribute(e,s),ux.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+cx.distanceTo(ux);t.setAttribute("lineDistance",new Ae(i,1))}else ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var sr=class extends nr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ne(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},hx=new _e,sm=new Rr,oh=new er,ah=new G,Cr=class extends Ai{constructor(t=new Se,e=new sr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),oh.copy(i.boundingSphere),oh.applyMatrix4(s),oh.radius+=r,t.ray.intersectsSphere(oh)===!1)return;hx.copy(s).invert(),sm.copy(t.ray).applyMatrix4(hx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,y=f;p<y;p++){let g=c.getX(p);ah.fromBufferAttribute(h,g),dx(ah,g,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,y=f;p<y;p++)ah.fromBufferAttribute(h,p),dx(ah,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function dx(n,t,e,i,s,r,o){let a=sm.distanceSqToPoint(n);if(a<e){let l=new G;sm.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var xc=class extends Ti{constructor(t=[],e=Fo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},yc=class extends Ti{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Pr=class extends Ti{constructor(t,e,i=Is,s,r,o,a=ei,l=ei,c,u=Ar,h=1){if(u!==Ar&&u!==Lr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ka(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},vc=class extends Pr{constructor(t,e=Is,i=Fo,s,r,o=ei,a=ei,l,c=Ar){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},bc=class extends Ti{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ki=class n extends Se{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ae(c,3)),this.setAttribute("normal",new Ae(u,3)),this.setAttribute("uv",new Ae(h,2));function p(y,g,m,_,E,b,A,T,x,S,D){let I=b/x,N=A/S,H=b/2,V=A/2,k=T/2,O=x+1,L=S+1,F=0,j=0,X=new G;for(let J=0;J<L;J++){let et=J*N-V;for(let dt=0;dt<O;dt++){let ft=dt*I-H;X[y]=ft*_,X[g]=et*E,X[m]=k,c.push(X.x,X.y,X.z),X[y]=0,X[g]=0,X[m]=T>0?1:-1,u.push(X.x,X.y,X.z),h.push(dt/x),h.push(1-J/S),F+=1}}for(let J=0;J<S;J++)for(let et=0;et<x;et++){let dt=d+et+O*J,ft=d+et+O*(J+1),st=d+(et+1)+O*(J+1),yt=d+(et+1)+O*J;l.push(dt,ft,yt),l.push(ft,st,yt),j+=6}a.addGroup(f,j,D),f+=j,d+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Lo=class n extends Se{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,y=s+1,g=new G,m=new G;for(let _=0;_<=p;_++){let E=0,b=0,A=0,T=0;if(_<=i){let D=_/i,I=D*Math.PI/2;b=-u-t*Math.cos(I),A=t*Math.sin(I),T=-t*Math.cos(I),E=D*h}else if(_<=i+r){let D=(_-i)/r;b=-u+D*e,A=t,T=0,E=h+D*d}else{let D=(_-i-r)/i,I=D*Math.PI/2;b=u+t*Math.sin(I),A=t*Math.cos(I),T=t*Math.sin(I),E=h+d+D*h}let x=Math.max(0,Math.min(1,E/f)),S=0;_===0?S=.5/s:_===p&&(S=-.5/s);for(let D=0;D<=s;D++){let I=D/s,N=I*Math.PI*2,H=Math.sin(N),V=Math.cos(N);m.x=-A*V,m.y=b,m.z=A*H,a.push(m.x,m.y,m.z),g.set(-A*V,T,A*H),g.normalize(),l.push(g.x,g.y,g.z),c.push(I+S,x)}if(_>0){let D=(_-1)*y;for(let I=0;I<s;I++){let N=D+I,H=D+I+1,V=_*y+I,k=_*y+I+1;o.push(N,H,V),o.push(H,k,V)}}}this.setIndex(o),this.setAttribute("position",new Ae(a,3)),this.setAttribute("normal",new Ae(l,3)),this.setAttribute("uv",new Ae(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},Mc=class n extends Se{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new G,u=new Yt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new Ae(o,3)),this.setAttribute("normal",new Ae(a,3)),this.setAttribute("uv",new Ae(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ri=class n extends Se{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,y=[],g=i/2,m=0;_(),o===!1&&(t>0&&E(!0),e>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new Ae(h,3)),this.setAttribute("normal",new Ae(d,3)),this.setAttribute("uv",new Ae(f,2));function _(){let b=new G,A=new G,T=0,x=(e-t)/i;for(let S=0;S<=r;S++){let D=[],I=S/r,N=I*(e-t)+t;for(let H=0;H<=s;H++){let V=H/s,k=V*l+a,O=Math.sin(k),L=Math.cos(k);A.x=N*O,A.y=-I*i+g,A.z=N*L,h.push(A.x,A.y,A.z),b.set(O,x,L).normalize(),d.push(b.x,b.y,b.z),f.push(V,1-I),D.push(p++)}y.push(D)}for(let S=0;S<s;S++)for(let D=0;D<r;D++){let I=y[D][S],N=y[D+1][S],H=y[D+1][S+1],V=y[D][S+1];(t>0||D!==0)&&(u.push(I,N,V),T+=3),(e>0||D!==r-1)&&(u.push(N,H,V),T+=3)}c.addGroup(m,T,0),m+=T}function E(b){let A=p,T=new Yt,x=new G,S=0,D=b===!0?t:e,I=b===!0?1:-1;for(let H=1;H<=s;H++)h.push(0,g*I,0),d.push(0,I,0),f.push(.5,.5),p++;let N=p;for(let H=0;H<=s;H++){let k=H/s*l+a,O=Math.cos(k),L=Math.sin(k);x.x=D*L,x.y=g*I,x.z=D*O,h.push(x.x,x.y,x.z),d.push(0,I,0),T.x=O*.5+.5,T.y=L*.5*I+.5,f.push(T.x,T.y),p++}for(let H=0;H<s;H++){let V=A+H,k=N+H;b===!0?u.push(k,k+1,V):u.push(k+1,k,V),S+=3}c.addGroup(m,S,b===!0?1:2),m+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Do=class n extends Ri{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ch=class n extends Se{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Ae(r,3)),this.setAttribute("normal",new Ae(r.slice(),3)),this.setAttribute("uv",new Ae(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let E=new G,b=new G,A=new G;for(let T=0;T<e.length;T+=3)f(e[T+0],E),f(e[T+1],b),f(e[T+2],A),l(E,b,A,_)}function l(_,E,b,A){let T=A+1,x=[];for(let S=0;S<=T;S++){x[S]=[];let D=_.clone().lerp(b,S/T),I=E.clone().lerp(b,S/T),N=T-S;for(let H=0;H<=N;H++)H===0&&S===T?x[S][H]=D:x[S][H]=D.clone().lerp(I,H/N)}for(let S=0;S<T;S++)for(let D=0;D<2*(T-S)-1;D++){let I=Math.floor(D/2);D%2===0?(d(x[S][I+1]),d(x[S+1][I]),d(x[S][I])):(d(x[S][I+1]),d(x[S+1][I+1]),d(x[S+1][I]))}}function c(_){let E=new G;for(let b=0;b<r.length;b+=3)E.x=r[b+0],E.y=r[b+1],E.z=r[b+2],E.normalize().multiplyScalar(_),r[b+0]=E.x,r[b+1]=E.y,r[b+2]=E.z}function u(){let _=new G;for(let E=0;E<r.length;E+=3){_.x=r[E+0],_.y=r[E+1],_.z=r[E+2];let b=g(_)/2/Math.PI+.5,A=m(_)/Math.PI+.5;o.push(b,1-A)}p(),h()}function h(){for(let _=0;_<o.length;_+=6){let E=o[_+0],b=o[_+2],A=o[_+4],T=Math.max(E,b,A),x=Math.min(E,b,A);T>.9&&x<.1&&(E<.2&&(o[_+0]+=1),b<.2&&(o[_+2]+=1),A<.2&&(o[_+4]+=1))}}function d(_){r.push(_.x,_.y,_.z)}function f(_,E){let b=_*3;E.x=t[b+0],E.y=t[b+1],E.z=t[b+2]}function p(){let _=new G,E=new G,b=new G,A=new G,T=new Yt,x=new Yt,S=new Yt;for(let D=0,I=0;D<r.length;D+=9,I+=6){_.set(r[D+0],r[D+1],r[D+2]),E.set(r[D+3],r[D+4],r[D+5]),b.set(r[D+6],r[D+7],r[D+8]),T.set(o[I+0],o[I+1]),x.set(o[I+2],o[I+3]),S.set(o[I+4],o[I+5]),A.copy(_).add(E).add(b).divideScalar(3);let N=g(A);y(T,I+0,_,N),y(x,I+2,E,N),y(S,I+4,b,N)}}function y(_,E,b,A){A<0&&_.x===1&&(o[E]=_.x-1),b.x===0&&b.z===0&&(o[E]=A/2/Math.PI+.5)}function g(_){return Math.atan2(_.z,-_.x)}function m(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Sc=class n extends Se{constructor(t=[new Yt(0,-.5),new Yt(.5,0),new Yt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Te(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new G,d=new Yt,f=new G,p=new G,y=new G,g=0,m=0;for(let _=0;_<=t.length-1;_++)switch(_){case 0:g=t[_+1].x-t[_].x,m=t[_+1].y-t[_].y,f.x=m*1,f.y=-g,f.z=m*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:y.normalize(),l.push(y.x,y.y,y.z);break;default:g=t[_+1].x-t[_].x,m=t[_+1].y-t[_].y,f.x=m*1,f.y=-g,f.z=m*0,p.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(p)}for(let _=0;_<=e;_++){let E=i+_*u*s,b=Math.sin(E),A=Math.cos(E);for(let T=0;T<=t.length-1;T++){h.x=t[T].x*b,h.y=t[T].y,h.z=t[T].x*A,o.push(h.x,h.y,h.z),d.x=_/e,d.y=T/(t.length-1),a.push(d.x,d.y);let x=l[3*T+0]*b,S=l[3*T+1],D=l[3*T+0]*A;c.push(x,S,D)}}for(let _=0;_<e;_++)for(let E=0;E<t.length-1;E++){let b=E+_*t.length,A=b,T=b+t.length,x=b+t.length+1,S=b+1;r.push(A,T,S),r.push(x,S,T)}this.setIndex(r),this.setAttribute("position",new Ae(o,3)),this.setAttribute("uv",new Ae(a,2)),this.setAttribute("normal",new Ae(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},wc=class n extends Ch{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Ec=class n extends Se{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],y=[],g=[];for(let m=0;m<u;m++){let _=m*d-o;for(let E=0;E<c;E++){let b=E*h-r;p.push(b,-_,0),y.push(0,0,1),g.push(E/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let E=_+c*m,b=_+c*(m+1),A=_+1+c*(m+1),T=_+1+c*m;f.push(E,b,T),f.push(b,A,T)}this.setIndex(f),this.setAttribute("position",new Ae(p,3)),this.setAttribute("normal",new Ae(y,3)),this.setAttribute("uv",new Ae(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ps=class n extends Se{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new G,d=new G,f=[],p=[],y=[],g=[];for(let m=0;m<=i;m++){let _=[],E=m/i,b=o+E*a,A=t*Math.cos(b),T=Math.sqrt(t*t-A*A),x=0;m===0&&o===0?x=.5/e:m===i&&l===Math.PI&&(x=-.5/e);for(let S=0;S<=e;S++){let D=S/e,I=s+D*r;h.x=-T*Math.cos(I),h.y=A,h.z=T*Math.sin(I),p.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),g.push(D+x,1-E),_.push(c++)}u.push(_)}for(let m=0;m<i;m++)for(let _=0;_<e;_++){let E=u[m][_+1],b=u[m][_],A=u[m+1][_],T=u[m+1][_+1];(m!==0||o>0)&&f.push(E,b,T),(m!==i-1||l<Math.PI)&&f.push(b,A,T)}this.setIndex(f),this.setAttribute("position",new Ae(p,3)),this.setAttribute("normal",new Ae(y,3)),this.setAttribute("uv",new Ae(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Wa=class n extends Se{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new G,f=new G,p=new G;for(let y=0;y<=i;y++){let g=o+y/i*a;for(let m=0;m<=s;m++){let _=m/s*r;f.x=(t+e*Math.cos(g))*Math.cos(_),f.y=(t+e*Math.cos(g))*Math.sin(_),f.z=e*Math.sin(g),c.push(f.x,f.y,f.z),d.x=t*Math.cos(_),d.y=t*Math.sin(_),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(m/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let g=1;g<=s;g++){let m=(s+1)*y+g-1,_=(s+1)*(y-1)+g-1,E=(s+1)*(y-1)+g,b=(s+1)*y+g;l.push(m,_,b),l.push(_,E,b)}this.setIndex(l),this.setAttribute("position",new Ae(c,3)),this.setAttribute("normal",new Ae(u,3)),this.setAttribute("uv",new Ae(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Bo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(fx(s))s.isRenderTargetTexture?(ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(fx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function pi(n){let t={};for(let e=0;e<n.length;e++){let i=Bo(n[e]);for(let s in i)t[s]=i[s]}return t}function fx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function q1(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Hm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Le.workingColorSpace}var sy={clone:Bo,merge:pi},X1=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Y1=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ci=class extends nr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=X1,this.fragmentShader=Y1,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Bo(t.uniforms),this.uniformsGroups=q1(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ne().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new vn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ue().fromArray(s.value);break;case"m4":this.uniforms[i].value=new _e().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ph=class extends Ci{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ih=class extends nr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Wx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Lh=class extends nr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function La(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function lh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var eo=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dh=class extends eo{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:em,endingEnd:em}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case nm:r=t,a=2*e-i;break;case im:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case nm:o=t,l=2*i-e;break;case im:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),y=p*p,g=y*p,m=-d*g+2*d*y-d*p,_=(1+d)*g+(-1.5-2*d)*y+(-.5+d)*p+1,E=(-1-f)*g+(1.5+f)*y+.5*p,b=f*g-f*y;for(let A=0;A!==a;++A)r[A]=m*o[u+A]+_*o[c+A]+E*o[l+A]+b*o[h+A];return r}},Nh=class extends eo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Uh=class extends eo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Fh=class extends eo{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),y=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*y+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let y=o[c+p],g=o[l+p],m=f*d+p*2,_=h[m],E=h[m+1],b=t*d+p*2,A=u[b],T=u[b+1],x=j1(i,e,_,A,s);r[p]=ry(x,y,E,T,g)}return r}};function ry(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Z1(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function j1(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=ry(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Z1(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ns=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=La(e,this.TimeBufferType),this.values=La(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:La(t.times,Array),values:La(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),lh(t.settings)&&(i.settings={inTangents:La(t.settings.inTangents,Array),outTangents:La(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Uh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Nh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Fh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case sc:e=this.InterpolantFactoryMethodDiscrete;break;case Mh:e=this.InterpolantFactoryMethodLinear;break;case hh:e=this.InterpolantFactoryMethodSmooth;break;case tm:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ie("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return sc;case this.InterpolantFactoryMethodLinear:return Mh;case this.InterpolantFactoryMethodSmooth:return hh;case this.InterpolantFactoryMethodBezier:return tm}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;lh(this.settings)&&(px(this.settings.inTangents,t),px(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;lh(this.settings)&&(mx(this.settings.inTangents,t),mx(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(oe("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(oe("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){oe("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){oe("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&h1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){oe("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===hh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let y=e[h+p];if(y!==e[d+p]||y!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,lh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function px(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function mx(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ns.prototype.ValueTypeName="";ns.prototype.TimeBufferType=Float32Array;ns.prototype.ValueBufferType=Float32Array;ns.prototype.DefaultInterpolation=Mh;var no=class extends ns{constructor(t,e,i){super(t,e,i)}};no.prototype.ValueTypeName="bool";no.prototype.ValueBufferType=Array;no.prototype.DefaultInterpolation=sc;no.prototype.InterpolantFactoryMethodLinear=void 0;no.prototype.InterpolantFactoryMethodSmooth=void 0;var Oh=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};Oh.prototype.ValueTypeName="color";var Bh=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};Bh.prototype.ValueTypeName="number";var kh=class extends eo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)hn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Tc=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new kh(this.times,this.values,this.getValueSize(),t)}};Tc.prototype.ValueTypeName="quaternion";Tc.prototype.InterpolantFactoryMethodSmooth=void 0;var io=class extends ns{constructor(t,e,i){super(t,e,i)}};io.prototype.ValueTypeName="string";io.prototype.ValueBufferType=Array;io.prototype.DefaultInterpolation=sc;io.prototype.InterpolantFactoryMethodLinear=void 0;io.prototype.InterpolantFactoryMethodSmooth=void 0;var zh=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};zh.prototype.ValueTypeName="vector";var Hh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},oy=new Hh,Gh=class{constructor(t){this.manager=t!==void 0?t:oy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Gh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ch=new G,uh=new hn,Qs=new G,Ac=class extends Ai{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new _e,this.projectionMatrix=new _e,this.projectionMatrixInverse=new _e,this.coordinateSystem=ds,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ch,uh,Qs),Qs.x===1&&Qs.y===1&&Qs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ch,uh,Qs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ch,uh,Qs),Qs.x===1&&Qs.y===1&&Qs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ch,uh,Qs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Kr=new G,gx=new Yt,_x=new Yt,wi=class extends Ac{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ba*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(nc*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ba*2*Math.atan(Math.tan(nc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Kr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Kr.x,Kr.y).multiplyScalar(-t/Kr.z),Kr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Kr.x,Kr.y).multiplyScalar(-t/Kr.z)}getViewSize(t,e){return this.getViewBounds(t,gx,_x),e.subVectors(_x,gx)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(nc*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Vh=class extends Ac{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Da=-90,Na=1,$a=class extends Ai{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new wi(Da,Na,t,e);s.layers=this.layers,this.add(s);let r=new wi(Da,Na,t,e);r.layers=this.layers,this.add(r);let o=new wi(Da,Na,t,e);o.layers=this.layers,this.add(o);let a=new wi(Da,Na,t,e);a.layers=this.layers,this.add(a);let l=new wi(Da,Na,t,e);l.layers=this.layers,this.add(l);let c=new wi(Da,Na,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===ds)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ac)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Wh=class extends wi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Gm="\\[\\]\\.:\\/",J1=new RegExp("["+Gm+"]","g"),Vm="[^"+Gm+"]",K1="[^"+Gm.replace("\\.","")+"]",Q1=/((?:WC+[\/:])*)/.source.replace("WC",Vm),tE=/(WCOD+)?/.source.replace("WCOD",K1),eE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Vm),nE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Vm),iE=new RegExp("^"+Q1+tE+eE+nE+"$"),sE=["material","materials","bones","map"],rm=class{constructor(t,e,i){let s=i||un.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},un=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(J1,"")}static parseTrackName(t){let e=iE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);sE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){oe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){oe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){oe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){oe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){oe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){oe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){oe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;oe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){oe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){oe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};un.Composite=rm;un.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};un.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};un.prototype.GetterByBindingType=[un.prototype._getValue_direct,un.prototype._getValue_array,un.prototype._getValue_arrayElement,un.prototype._getValue_toArray];un.prototype.SetterByBindingTypeAndVersioning=[[un.prototype._setValue_direct,un.prototype._setValue_direct_setNeedsUpdate,un.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[un.prototype._setValue_array,un.prototype._setValue_array_setNeedsUpdate,un.prototype._setValue_array_setMatrixWorldNeedsUpdate],[un.prototype._setValue_arrayElement,un.prototype._setValue_arrayElement_setNeedsUpdate,un.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[un.prototype._setValue_fromArray,un.prototype._setValue_fromArray_setNeedsUpdate,un.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var fD=new Float32Array(1);var xx=new _e,Rc=class{constructor(t,e,i=0,s=1/0){this.ray=new Rr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new za,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):oe("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return xx.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(xx),this}intersectObject(t,e=!0,i=[]){return om(t,this,i,e),i.sort(yx),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)om(t[s],this,i,e);return i.sort(yx),i}};function yx(n,t){return n.distance-t.distance}function om(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)om(r[o],t,e,!0)}}var qa=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Te(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Te(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var am=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Cc=class extends Cs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Wm(n,t,e,i){let s=rE(i);switch(e){case Am:return n*t;case Jh:return n*t/s.components*s.byteLength;case Kh:return n*t/s.components*s.byteLength;case oo:return n*t*2/s.components*s.byteLength;case Qh:return n*t*2/s.components*s.byteLength;case Rm:return n*t*3/s.components*s.byteLength;case Ds:return n*t*4/s.components*s.byteLength;case td:return n*t*4/s.components*s.byteLength;case Lc:case Dc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Nc:case Uc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case nd:case sd:return Math.max(n,16)*Math.max(t,8)/4;case ed:case id:return Math.max(n,8)*Math.max(t,8)/2;case rd:case od:case ld:case cd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ad:case Fc:case ud:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case hd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case dd:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case fd:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case pd:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case md:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case gd:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case _d:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case xd:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case yd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case vd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case bd:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Md:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Sd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case wd:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Ed:case Td:case Ad:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Rd:case Cd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Oc:case Pd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function rE(n){switch(n){case is:case Sm:return{byteLength:1,components:1};case ja:case wm:case Ls:return{byteLength:2,components:1};case Zh:case jh:return{byteLength:2,components:4};case Is:case Yh:case fs:return{byteLength:4,components:1};case Em:case Tm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ry(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function uE(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],y=h[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let y=h[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var hE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,dE=`#ifdef USE_ALPHAHASH
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
#endif`,fE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,pE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_E=`#ifdef USE_AOMAP
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
#endif`,xE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,yE=`#ifdef USE_BATCHING
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
#endif`,vE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,bE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ME=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,SE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,wE=`#ifdef USE_IRIDESCENCE
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
#endif`,EE=`#ifdef USE_BUMPMAP
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
#endif`,TE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,AE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,RE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,CE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,PE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,IE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,LE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,DE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,NE=`#define PI 3.141592653589793
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
} // validated`,UE=`vec3 transformedNormal = objectNormal;
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
#endif`,FE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,OE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,BE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,kE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zE="gl_FragColor = linearToOutputTexel( gl_FragColor );",HE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,GE=`#ifdef USE_ENVMAP
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
#endif`,VE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,WE=`#ifdef USE_ENVMAP
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
#endif`,$E=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,qE=`#ifdef USE_ENVMAP
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
#endif`,XE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,YE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ZE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,jE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,JE=`#ifdef USE_GRADIENTMAP
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
}`,KE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,QE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,tT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,eT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,nT=`#ifdef USE_ENVMAP
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
#endif`,iT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,sT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,rT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,oT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,aT=`PhysicalMaterial material;
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
#endif`,lT=`uniform sampler2D dfgLUT;
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
}`,cT=`
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
#endif`,uT=`#if defined( RE_IndirectDiffuse )
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
#endif`,hT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,dT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,fT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,pT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_T=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,xT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,yT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,vT=`#if defined( USE_POINTS_UV )
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
#endif`,bT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,MT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ST=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,wT=`#if defined( USE_MORPHCOLORS )
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
#endif`,ET=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,TT=`#ifdef USE_MORPHTARGETS
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
#endif`,AT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,RT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,CT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,PT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,IT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,LT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,DT=`#ifdef USE_NORMALMAP
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
#endif`,NT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,UT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,FT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,OT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,BT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,kT=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,zT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,HT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,GT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,VT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,WT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,$T=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,qT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,XT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,YT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,ZT=`float getShadowMask() {
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
}`,jT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,JT=`#ifdef USE_SKINNING
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
#endif`,KT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,QT=`#ifdef USE_SKINNING
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
#endif`,tA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,eA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,nA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,iA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,sA=`#ifdef USE_TRANSMISSION
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
#endif`,rA=`#ifdef USE_TRANSMISSION
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
#endif`,oA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,aA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,lA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,cA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,uA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,hA=`uniform sampler2D t2D;
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
}`,dA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fA=`uniform float backgroundBlurriness;
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
}`,pA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gA=`#include <common>
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
}`,_A=`#if DEPTH_PACKING == 3200
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
}`,xA=`#define DISTANCE
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
}`,yA=`#define DISTANCE
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
}`,vA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MA=`uniform float scale;
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
}`,SA=`uniform vec3 diffuse;
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
}`,wA=`#include <common>
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
}`,EA=`uniform vec3 diffuse;
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
}`,TA=`#define LAMBERT
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
}`,AA=`#define LAMBERT
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
}`,RA=`#define MATCAP
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
}`,CA=`#define MATCAP
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
}`,PA=`#define NORMAL
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
}`,IA=`#define NORMAL
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
}`,LA=`#define PHONG
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
}`,DA=`#define PHONG
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
}`,NA=`#define STANDARD
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
}`,UA=`#define STANDARD
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
}`,FA=`#define TOON
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
}`,OA=`#define TOON
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
}`,BA=`uniform float size;
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
}`,kA=`uniform vec3 diffuse;
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
}`,zA=`#include <common>
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
}`,HA=`uniform vec3 color;
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
}`,GA=`uniform float rotation;
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
}`,VA=`uniform vec3 diffuse;
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
}`,we={alphahash_fragment:hE,alphahash_pars_fragment:dE,alphamap_fragment:fE,alphamap_pars_fragment:pE,alphatest_fragment:mE,alphatest_pars_fragment:gE,aomap_fragment:_E,aomap_pars_fragment:xE,batching_pars_vertex:yE,batching_vertex:vE,begin_vertex:bE,beginnormal_vertex:ME,bsdfs:SE,iridescence_fragment:wE,bumpmap_pars_fragment:EE,clipping_planes_fragment:TE,clipping_planes_pars_fragment:AE,clipping_planes_pars_vertex:RE,clipping_planes_vertex:CE,color_fragment:PE,color_pars_fragment:IE,color_pars_vertex:LE,color_vertex:DE,common:NE,defaultnormal_vertex:UE,displacementmap_pars_vertex:FE,displacementmap_vertex:OE,emissivemap_fragment:BE,emissivemap_pars_fragment:kE,colorspace_fragment:zE,colorspace_pars_fragment:HE,envmap_fragment:GE,envmap_common_pars_fragment:VE,envmap_pars_fragment:WE,envmap_pars_vertex:$E,envmap_physical_pars_fragment:nT,envmap_vertex:qE,fog_vertex:XE,fog_pars_vertex:YE,fog_fragment:ZE,fog_pars_fragment:jE,gradientmap_pars_fragment:JE,lightmap_pars_fragment:KE,lights_lambert_fragment:QE,lights_lambert_pars_fragment:tT,lights_pars_begin:eT,lights_toon_fragment:iT,lights_toon_pars_fragment:sT,lights_phong_fragment:rT,lights_phong_pars_fragment:oT,lights_physical_fragment:aT,lights_physical_pars_fragment:lT,lights_fragment_begin:cT,lights_fragment_maps:uT,lights_fragment_end:hT,lightprobes_pars_fragment:dT,logdepthbuf_fragment:fT,logdepthbuf_pars_fragment:pT,logdepthbuf_pars_vertex:mT,logdepthbuf_vertex:gT,map_fragment:_T,map_pars_fragment:xT,map_particle_fragment:yT,map_particle_pars_fragment:vT,metalnessmap_fragment:bT,metalnessmap_pars_fragment:MT,morphinstance_vertex:ST,morphcolor_vertex:wT,morphnormal_vertex:ET,morphtarget_pars_vertex:TT,morphtarget_vertex:AT,normal_fragment_begin:RT,normal_fragment_maps:CT,normal_pars_fragment:PT,normal_pars_vertex:IT,normal_vertex:LT,normalmap_pars_fragment:DT,clearcoat_normal_fragment_begin:NT,clearcoat_normal_fragment_maps:UT,clearcoat_pars_fragment:FT,iridescence_pars_fragment:OT,opaque_fragment:BT,packing:kT,premultiplied_alpha_fragment:zT,project_vertex:HT,dithering_fragment:GT,dithering_pars_fragment:VT,roughnessmap_fragment:WT,roughnessmap_pars_fragment:$T,shadowmap_pars_fragment:qT,shadowmap_pars_vertex:XT,shadowmap_vertex:YT,shadowmask_pars_fragment:ZT,skinbase_vertex:jT,skinning_pars_vertex:JT,skinning_vertex:KT,skinnormal_vertex:QT,specularmap_fragment:tA,specularmap_pars_fragment:eA,tonemapping_fragment:nA,tonemapping_pars_fragment:iA,transmission_fragment:sA,transmission_pars_fragment:rA,uv_pars_fragment:oA,uv_pars_vertex:aA,uv_vertex:lA,worldpos_vertex:cA,background_vert:uA,background_frag:hA,backgroundCube_vert:dA,backgroundCube_frag:fA,cube_vert:pA,cube_frag:mA,depth_vert:gA,depth_frag:_A,distance_vert:xA,distance_frag:yA,equirect_vert:vA,equirect_frag:bA,linedashed_vert:MA,linedashed_frag:SA,meshbasic_vert:wA,meshbasic_frag:EA,meshlambert_vert:TA,meshlambert_frag:AA,meshmatcap_vert:RA,meshmatcap_frag:CA,meshnormal_vert:PA,meshnormal_frag:IA,meshphong_vert:LA,meshphong_frag:DA,meshphysical_vert:NA,meshphysical_frag:UA,meshtoon_vert:FA,meshtoon_frag:OA,points_vert:BA,points_frag:kA,shadow_vert:zA,shadow_frag:HA,sprite_vert:GA,sprite_frag:VA},Bt={common:{diffuse:{value:new ne(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ue},alphaMap:{value:null},alphaMapTransform:{value:new ue},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ue}},envmap:{envMap:{value:null},envMapRotation:{value:new ue},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ue}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ue}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ue},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ue},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ue},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ue}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ue}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ue}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ne(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ne(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ue},alphaTest:{value:0},uvTransform:{value:new ue}},sprite:{diffuse:{value:new ne(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ue},alphaMap:{value:null},alphaMapTransform:{value:new ue},alphaTest:{value:0}}},lr={basic:{uniforms:pi([Bt.common,Bt.specularmap,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.fog]),vertexShader:we.meshbasic_vert,fragmentShader:we.meshbasic_frag},lambert:{uniforms:pi([Bt.common,Bt.specularmap,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.fog,Bt.lights,{emissive:{value:new ne(0)},envMapIntensity:{value:1}}]),vertexShader:we.meshlambert_vert,fragmentShader:we.meshlambert_frag},phong:{uniforms:pi([Bt.common,Bt.specularmap,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.fog,Bt.lights,{emissive:{value:new ne(0)},specular:{value:new ne(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:we.meshphong_vert,fragmentShader:we.meshphong_frag},standard:{uniforms:pi([Bt.common,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.roughnessmap,Bt.metalnessmap,Bt.fog,Bt.lights,{emissive:{value:new ne(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:we.meshphysical_vert,fragmentShader:we.meshphysical_frag},toon:{uniforms:pi([Bt.common,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.gradientmap,Bt.fog,Bt.lights,{emissive:{value:new ne(0)}}]),vertexShader:we.meshtoon_vert,fragmentShader:we.meshtoon_frag},matcap:{uniforms:pi([Bt.common,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.fog,{matcap:{value:null}}]),vertexShader:we.meshmatcap_vert,fragmentShader:we.meshmatcap_frag},points:{uniforms:pi([Bt.points,Bt.fog]),vertexShader:we.points_vert,fragmentShader:we.points_frag},dashed:{uniforms:pi([Bt.common,Bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:we.linedashed_vert,fragmentShader:we.linedashed_frag},depth:{uniforms:pi([Bt.common,Bt.displacementmap]),vertexShader:we.depth_vert,fragmentShader:we.depth_frag},normal:{uniforms:pi([Bt.common,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,{opacity:{value:1}}]),vertexShader:we.meshnormal_vert,fragmentShader:we.meshnormal_frag},sprite:{uniforms:pi([Bt.sprite,Bt.fog]),vertexShader:we.sprite_vert,fragmentShader:we.sprite_frag},background:{uniforms:{uvTransform:{value:new ue},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:we.background_vert,fragmentShader:we.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ue}},vertexShader:we.backgroundCube_vert,fragmentShader:we.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:we.cube_vert,fragmentShader:we.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:we.equirect_vert,fragmentShader:we.equirect_frag},distance:{uniforms:pi([Bt.common,Bt.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:we.distance_vert,fragmentShader:we.distance_frag},shadow:{uniforms:pi([Bt.lights,Bt.fog,{color:{value:new ne(0)},opacity:{value:1}}]),vertexShader:we.shadow_vert,fragmentShader:we.shadow_frag}};lr.physical={uniforms:pi([lr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ue},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ue},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ue},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ue},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ue},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ue},sheen:{value:0},sheenColor:{value:new ne(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ue},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ue},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ue},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ue},attenuationDistance:{value:0},attenuationColor:{value:new ne(0)},specularColor:{value:new ne(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ue},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ue},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ue}}]),vertexShader:we.meshphysical_vert,fragmentShader:we.meshphysical_frag};var Dd={r:0,b:0,g:0},WA=new _e,Cy=new ue;Cy.set(-1,0,0,0,1,0,0,0,1);function $A(n,t,e,i,s,r){let o=new ne(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let E=_.isScene===!0?_.background:null;if(E&&E.isTexture){let b=_.backgroundBlurriness>0;E=t.get(E,b)}return E}function p(_){let E=!1,b=f(_);b===null?g(o,a):b&&b.isColor&&(g(b,1),E=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(_,E){let b=f(E);b&&b.isCubeTexture?(c===void 0&&(c=new je(new ki(1,1,1),new Ci({name:"BackgroundCubeMaterial",uniforms:Bo(lr.backgroundCube.uniforms),vertexShader:lr.backgroundCube.vertexShader,fragmentShader:lr.backgroundCube.fragmentShader,side:Pi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(WA.makeRotationFromEuler(E.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Cy),c.material.toneMapped=Le.getTransfer(b.colorSpace)!==$e,(u!==b||h!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new je(new Ec(2,2),new Ci({name:"BackgroundMaterial",uniforms:Bo(lr.background.uniforms),vertexShader:lr.background.vertexShader,fragmentShader:lr.background.fragmentShader,side:rr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=Le.getTransfer(b.colorSpace)!==$e,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,E){_.getRGB(Dd,Hm(n)),e.buffers.color.setClear(Dd.r,Dd.g,Dd.b,E,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,E=1){o.set(_),a=E,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:y,dispose:m}}function qA(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(N,H,V,k,O){let L=!1,F=h(N,k,V,H);r!==F&&(r=F,c(r.object)),L=f(N,k,V,O),L&&p(N,k,V,O),O!==null&&t.update(O,n.ELEMENT_ARRAY_BUFFER),(L||o)&&(o=!1,b(N,H,V,k),O!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(O).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,H,V,k){let O=k.wireframe===!0,L=i[H.id];L===void 0&&(L={},i[H.id]=L);let F=N.isInstancedMesh===!0?N.id:0,j=L[F];j===void 0&&(j={},L[F]=j);let X=j[V.id];X===void 0&&(X={},j[V.id]=X);let J=X[O];return J===void 0&&(J=d(l()),X[O]=J),J}function d(N){let H=[],V=[],k=[];for(let O=0;O<e;O++)H[O]=0,V[O]=0,k[O]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:V,attributeDivisors:k,object:N,attributes:{},index:null}}function f(N,H,V,k){let O=r.attributes,L=H.attributes,F=0,j=V.getAttributes();for(let X in j)if(j[X].location>=0){let et=O[X],dt=L[X];if(dt===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;F++}return r.attributesNum!==F||r.index!==k}function p(N,H,V,k){let O={},L=H.attributes,F=0,j=V.getAttributes();for(let X in j)if(j[X].location>=0){let et=L[X];et===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&(et=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&(et=N.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),O[X]=dt,F++}r.attributes=O,r.attributesNum=F,r.index=k}function y(){let N=r.newAttributes;for(let H=0,V=N.length;H<V;H++)N[H]=0}function g(N){m(N,0)}function m(N,H){let V=r.newAttributes,k=r.enabledAttributes,O=r.attributeDivisors;V[N]=1,k[N]===0&&(n.enableVertexAttribArray(N),k[N]=1),O[N]!==H&&(n.vertexAttribDivisor(N,H),O[N]=H)}function _(){let N=r.newAttributes,H=r.enabledAttributes;for(let V=0,k=H.length;V<k;V++)H[V]!==N[V]&&(n.disableVertexAttribArray(V),H[V]=0)}function E(N,H,V,k,O,L,F){F===!0?n.vertexAttribIPointer(N,H,V,O,L):n.vertexAttribPointer(N,H,V,k,O,L)}function b(N,H,V,k){y();let O=k.attributes,L=V.getAttributes(),F=H.defaultAttributeValues;for(let j in L){let X=L[j];if(X.location>=0){let J=O[j];if(J===void 0&&(j==="instanceMatrix"&&N.instanceMatrix&&(J=N.instanceMatrix),j==="instanceColor"&&N.instanceColor&&(J=N.instanceColor)),J!==void 0){let et=J.normalized,dt=J.itemSize,ft=t.get(J);if(ft===void 0)continue;let st=ft.buffer,yt=ft.type,_t=ft.bytesPerElement,At=yt===n.INT||yt===n.UNSIGNED_INT||J.gpuType===Yh;if(J.isInterleavedBufferAttribute){let Rt=J.data,Kt=Rt.isInterleavedBuffer===!0?Rt.stride:Rt.itemSize,me=J.offset;if(Rt.isInstancedInterleavedBuffer||Rt.isInstancedBufferAttribute){for(let jt=0;jt<X.locationSize;jt++)m(X.location+jt,Rt.meshPerAttribute);N.isInstancedMesh!==!0&&k._maxInstanceCount===void 0&&(k._maxInstanceCount=Rt.meshPerAttribute*Rt.count)}else for(let jt=0;jt<X.locationSize;jt++)g(X.location+jt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let jt=0;jt<X.locationSize;jt++)E(X.location+jt,dt/X.locationSize,yt,et,Kt*_t,(me+dt/X.locationSize*jt)*_t,At)}else{if(J.isInstancedBufferAttribute){for(let Rt=0;Rt<X.locationSize;Rt++)m(X.location+Rt,J.meshPerAttribute);N.isInstancedMesh!==!0&&k._maxInstanceCount===void 0&&(k._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let Rt=0;Rt<X.locationSize;Rt++)g(X.location+Rt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let Rt=0;Rt<X.locationSize;Rt++)E(X.location+Rt,dt/X.locationSize,yt,et,dt*_t,dt/X.locationSize*Rt*_t,At)}}else if(F!==void 0){let et=F[j];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(X.location,et);break;case 3:n.vertexAttrib3fv(X.location,et);break;case 4:n.vertexAttrib4fv(X.location,et);break;default:n.vertexAttrib1fv(X.location,et)}}}}_()}function A(){D();for(let N in i){let H=i[N];for(let V in H){let k=H[V];for(let O in k){let L=k[O];for(let F in L)u(L[F].object),delete L[F];delete k[O]}}delete i[N]}}function T(N){if(i[N.id]===void 0)return;let H=i[N.id];for(let V in H){let k=H[V];for(let O in k){let L=k[O];for(let F in L)u(L[F].object),delete L[F];delete k[O]}}delete i[N.id]}function x(N){for(let H in i){let V=i[H];for(let k in V){let O=V[k];if(O[N.id]===void 0)continue;let L=O[N.id];for(let F in L)u(L[F].object),delete L[F];delete O[N.id]}}}function S(N){for(let H in i){let V=i[H],k=N.isInstancedMesh===!0?N.id:0,O=V[k];if(O!==void 0){for(let L in O){let F=O[L];for(let j in F)u(F[j].object),delete F[j];delete O[L]}delete V[k],Object.keys(V).length===0&&delete i[H]}}}function D(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:I,dispose:A,releaseStatesOfGeometry:T,releaseStatesOfObject:S,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:g,disableUnusedAttributes:_}}function XA(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function YA(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ds&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let S=x===Ls&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==is&&x!==fs&&!S&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:E,maxFragmentUniforms:b,maxSamples:A,samples:T}}function ZA(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ri,a=new ue,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let _=r?0:i,E=_*4,b=m.clippingState||null;l.value=b,b=u(p,d,E,f);for(let A=0;A!==E;++A)b[A]=e[A];m.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,p!==!0||g===null){let m=f+y*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let E=0,b=f;E!==y;++E,b+=4)o.copy(h[E]).applyMatrix4(_,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var zc=class extends ts{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new xc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ki(5,5,5),r=new Ci({name:"CubemapFromEquirect",uniforms:Bo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Pi,blending:No});r.uniforms.tEquirect.value=e;let o=new je(s,r),a=e.minFilter;return e.minFilter===Ir&&(e.minFilter=Ei),new $a(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},ay=256,jA=3,JA=20,Py=256,Iy=16,KA=3,QA=new G,tR=new ne,Ud=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new $a(1,10,null),this._boxMesh=new je(new ki(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=QA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(tR));let g=new $a(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=uy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=cy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(ay,Bm(t))}_fromTexture(t,e){t.mapping===Fo||t.mapping===Za?this._setSize(t.image.length===0?ay:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=ly(t,!1,!1),i=Math.log2(t)-jA;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ly(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Fo||t.mapping===Za?(this._cubemapMaterial===null&&(this._cubemapMaterial=uy()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=cy()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=eR(),this._integrationMaterial=nR());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Iy);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-KA)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Py*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=iR());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function ly(n,t,e){return new zc(n,{minFilter:Ir,generateMipmaps:t,type:Ls,colorSpace:rc,depthBuffer:e})}function Hc(n,t,e){return new Ci({name:n,uniforms:t,vertexShader:we.cube_vert,fragmentShader:e,side:Pi,blending:No,depthTest:!1,depthWrite:!1})}function eR(){return Hc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Py}u

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
	`)}function nR(){return Hc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Iy}},`

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
	`)}function iR(){return Hc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${JA}
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
	`)}function cy(){return Hc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function uy(){return Hc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function sR(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===$h||f===qh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let y=new zc(p.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===$h||f===qh,y=f===Fo||f===Za;if(p||y){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Ud(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||y&&_&&l(_)?(i===null&&(i=new Ud(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===$h?d.mapping=Fo:f===qh&&(d.mapping=Za),d}function l(d){let f=0,p=6;for(let y=0;y<p;y++)d[y]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function rR(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ec("WebGLRenderer: "+i+" extension not supported."),s}}}function oR(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(p){let y=p.attributes;for(let g in y)t.update(y[g],n.ARRAY_BUFFER)}function h(p){let y=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=y!==null?y.array.length:g.array.length/3-1,E=g.count>=65535?pc:fc,b=new E(Math.ceil(_/3)*6,1),A=b.array;if(y!==null){let x=y.array;m=y.version;for(let S=0,D=0;S<_;S+=3){let I=x[S+0],N=x[S+1],H=x[S+2];A[D++]=I,A[D++]=N,A[D++]=N,A[D++]=H,A[D++]=H,A[D++]=I}}else{m=g.version;for(let x=0,S=0;x<_;x+=3){let D=x+0,I=x+1,N=x+2;A[S++]=D,A[S++]=I,A[S++]=I,A[S++]=N,A[S++]=N,A[S++]=D}}b.version=m;let T=r.get(p);T&&t.remove(T),r.set(p,b)}function d(p){let y=r.get(p);if(y){let g=p.index;g!==null&&y.version<g.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function aR(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let g=0;g<f;g++)y+=d[g];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function lR(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:oe("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function cR(n,t,e){let i=new WeakMap,s=new vn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let D=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],E=0;f===!0&&(E=1),p===!0&&(E=2),y===!0&&(E=3);let b=a.attributes.position.count*E,A=1;b>t.maxTextureSize&&(A=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let T=new Float32Array(b*A*4*h),x=new uc(T,b,A,h);x.type=fs,x.needsUpdate=!0;let S=E*4;for(let I=0;I<h;I++){let N=g[I],H=m[I],V=_[I],k=b*A*4*I;for(let O=0;O<N.count;O++){let L=O*S;f===!0&&(s.fromBufferAttribute(N,O),T[k+L+0]=s.x,T[k+L+1]=s.y,T[k+L+2]=s.z,T[k+L+3]=0),p===!0&&(s.fromBufferAttribute(H,O),T[k+L+4]=s.x,T[k+L+5]=s.y,T[k+L+6]=s.z,T[k+L+7]=0),y===!0&&(s.fromBufferAttribute(V,O),T[k+L+8]=s.x,T[k+L+9]=s.y,T[k+L+10]=s.z,T[k+L+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:x,size:new Yt(b,A)},i.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function uR(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var hR={[mm]:"LINEAR_TONE_MAPPING",[gm]:"REINHARD_TONE_MAPPING",[_m]:"CINEON_TONE_MAPPING",[xm]:"ACES_FILMIC_TONE_MAPPING",[vm]:"AGX_TONE_MAPPING",[bm]:"NEUTRAL_TONE_MAPPING",[ym]:"CUSTOM_TONE_MAPPING"};function dR(n,t,e,i,s,r){let o=new ts(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Se;u.setAttribute("position",new Ae([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ae([0,2,0,0,2,0],2));let h=new Ph({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new je(u,h),f=new Vh(-1,1,1,-1,0,1),p=null,y=null,g=!1,m,_=null,E=[],b=!1;this.setSize=function(A,T){o.setSize(A,T),a!==null&&a.setSize(A,T),l!==null&&l.setSize(A,T);for(let x=0;x<E.length;x++){let S=E[x];S.setSize&&S.setSize(A,T)}},this.setEffects=function(A){E=A,b=E.length>0&&E[0].isRenderPass===!0;let T=o.width,x=o.height;E.length>0&&a===null&&(a=new ts(T,x,{type:Ls,depthBuffer:!1,stencilBuffer:!1}),l=new ts(T,x,{type:Ls,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&E.some(D=>D.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Pr(T,x),r===!0&&(c.format=Lr,c.type=Oo)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let D=0;D<E.length;D++){let I=E[D];I.setSize&&I.setSize(T,x),S&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(A,T){if(g||A.toneMapping===or&&E.length===0)return!1;if(_=T,T!==null){let x=T.width,S=T.height;(o.width!==x||o.height!==S)&&this.setSize(x,S)}return b===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=or,!0},this.hasRenderPass=function(){return b},this.end=function(A,T){A.toneMapping=m,g=!0;let x=o,S=a;for(let D=0;D<E.length;D++){let I=E[D];I.enabled!==!1&&(I.render(A,S,x,T),I.needsSwap!==!1&&(x=S,S=S===a?l:a))}if(p!==A.outputColorSpace||y!==A.toneMapping){p=A.outputColorSpace,y=A.toneMapping,h.defines={},Le.getTransfer(p)===$e&&(h.defines.SRGB_TRANSFER="");let D=hR[y];D&&(h.defines[D]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,A.setRenderTarget(_),A.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Ly=new Ti,Dy=new Pr(1,1),Ny=new vc(1),Uy=new uc,Fy=new Eh,Oy=new xc,hy=[],dy=[],fy=new Float32Array(16),py=new Float32Array(9),my=new Float32Array(4);function Ka(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=hy[s];if(r===void 0&&(r=new Float32Array(s),hy[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Gn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Vn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Od(n,t){let e=dy[t];e===void 0&&(e=new Int32Array(t),dy[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function fR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function pR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Gn(e,t))return;n.uniform2fv(this.addr,t),Vn(e,t)}}function mR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Gn(e,t))return;n.uniform3fv(this.addr,t),Vn(e,t)}}function gR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Gn(e,t))return;n.uniform4fv(this.addr,t),Vn(e,t)}}function _R(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Gn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Vn(e,t)}else{if(Gn(e,i))return;my.set(i),n.uniformMatrix2fv(this.addr,!1,my),Vn(e,i)}}function xR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Gn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Vn(e,t)}else{if(Gn(e,i))return;py.set(i),n.uniformMatrix3fv(this.addr,!1,py),Vn(e,i)}}function yR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Gn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Vn(e,t)}else{if(Gn(e,i))return;fy.set(i),n.uniformMatrix4fv(this.addr,!1,fy),Vn(e,i)}}function vR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function bR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Gn(e,t))return;n.uniform2iv(this.addr,t),Vn(e,t)}}function MR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Gn(e,t))return;n.uniform3iv(this.addr,t),Vn(e,t)}}function SR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Gn(e,t))return;n.uniform4iv(this.addr,t),Vn(e,t)}}function wR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function ER(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Gn(e,t))return;n.uniform2uiv(this.addr,t),Vn(e,t)}}function TR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Gn(e,t))return;n.uniform3uiv(this.addr,t),Vn(e,t)}}function AR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Gn(e,t))return;n.uniform4uiv(this.addr,t),Vn(e,t)}}function Bd(n){return n.version===0&&(n.compareFunction=Nm,n.needsUpdate=!0),n}function RR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Bd(Dy):r=Ly,e.setTexture2D(t||r,s)}function CR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Fy,s)}function PR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Bd(Ny):r=Oy,e.setTextureCube(t||r,s)}function IR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Uy,s)}function LR(n){switch(n){case 5126:return fR;case 35664:return pR;case 35665:return mR;case 35666:return gR;case 35674:return _R;case 35675:return xR;case 35676:return yR;case 5124:case 35670:return vR;case 35667:case 35671:return bR;case 35668:case 35672:return MR;case 35669:case 35673:return SR;case 5125:return wR;case 36294:return ER;case 36295:return TR;case 36296:return AR;case 35678:case 36198:case 36298:case 36306:case 35682:return RR;case 35679:case 36299:case 36307:return CR;case 35680:case 36300:case 36308:case 36293:return PR;case 36289:case 36303:case 36311:case 36292:return IR}}function DR(n,t){n.uniform1fv(this.addr,t)}function NR(n,t){let e=Ka(t,this.size,2);n.uniform2fv(this.addr,e)}function UR(n,t){let e=Ka(t,this.size,3);n.uniform3fv(this.addr,e)}function FR(n,t){let e=Ka(t,this.size,4);n.uniform4fv(this.addr,e)}function OR(n,t){let e=Ka(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function BR(n,t){let e=Ka(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function kR(n,t){let e=Ka(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function zR(n,t){n.uniform1iv(this.addr,t)}function HR(n,t){n.uniform2iv(this.addr,t)}function GR(n,t){n.uniform3iv(this.addr,t)}function VR(n,t){n.uniform4iv(this.addr,t)}function WR(n,t){n.uniform1uiv(this.addr,t)}function $R(n,t){n.uniform2uiv(this.addr,t)}function qR(n,t){n.uniform3uiv(this.addr,t)}function XR(n,t){n.uniform4uiv(this.addr,t)}function YR(n,t,e){let i=this.cache,s=t.length,r=Od(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Bd(Dy):o=Ly;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function ZR(n,t,e){let i=this.cache,s=t.length,r=Od(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Fy,r[o])}function jR(n,t,e){let i=this.cache,s=t.length,r=Od(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Bd(Ny):o=Oy;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function JR(n,t,e){let i=this.cache,s=t.length,r=Od(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Uy,r[o])}function KR(n){switch(n){case 5126:return DR;case 35664:return NR;case 35665:return UR;case 35666:return FR;case 35674:return OR;case 35675:return BR;case 35676:return kR;case 5124:case 35670:return zR;case 35667:case 35671:return HR;case 35668:case 35672:return GR;case 35669:case 35673:return VR;case 5125:return WR;case 36294:return $R;case 36295:return qR;case 36296:return XR;case 35678:case 36198:case 36298:case 36306:case 35682:return YR;case 35679:case 36299:case 36307:return ZR;case 35680:case 36300:case 36308:case 36293:return jR;case 36289:case 36303:case 36311:case 36292:return JR}}var Xm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=LR(e.type)}},Ym=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=KR(e.type)}},Zm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},$m=/(\w+)(\])?(\[|\.)?/g;function gy(n,t){n.seq.push(t),n.map[t.id]=t}function QR(n,t,e){let i=n.name,s=i.length;for($m.lastIndex=0;;){let r=$m.exec(i),o=$m.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){gy(e,c===void 0?new Xm(a,n,t):new Ym(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Zm(a),gy(e,h)),e=h}}}var Ja=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);QR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function _y(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var tC=37297,eC=0;function nC(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var xy=new ue;function iC(n){Le._getMatrix(xy,Le.workingColorSpace,n);let t=`mat3( ${xy.elements.map(e=>e.toFixed(4))} )`;switch(Le.getTransfer(n)){case oc:return[t,"LinearTransferOETF"];case $e:return[t,"sRGBTransferOETF"];default:return ie("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function yy(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+nC(n.getShaderSource(t),a)}else return r}function sC(n,t){let e=iC(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rC={[mm]:"Linear",[gm]:"Reinhard",[_m]:"Cineon",[xm]:"ACESFilmic",[vm]:"AgX",[bm]:"Neutral",[ym]:"Custom"};function oC(n,t){let e=rC[t];return e===void 0?(ie("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Nd=new G;function aC(){Le.getLuminanceCoefficients(Nd);let n=Nd.x.toFixed(4),t=Nd.y.toFixed(4),e=Nd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lC(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(kc).join(`
`)}function cC(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function uC(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function kc(n){return n!==""}function vy(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function by(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var hC=/^[ \t]*#include +<([\w\d./]+)>/gm;function jm(n){return n.replace(hC,dC)}function dC(n,t){let e=we[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return jm(e)}var fC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function My(n){return n.replace(fC,pC)}function pC(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Sy(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var mC={[Pc]:"SHADOWMAP_TYPE_PCF",[Xa]:"SHADOWMAP_TYPE_VSM"};function gC(n){return mC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var _C={[Za]:"ENVMAP_MODE_REFRACTION"};function xC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":_C[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yC={[pm]:"ENVMAP_BLENDING_MULTIPLY",[Hx]:"ENVMAP_BLENDING_MIX",[Gx]:"ENVMAP_BLENDING_ADD"};function vC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":yC[n.combine]||"ENVMAP_BLENDING_NONE"}function bC(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=gC(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=xC(e),h=vC(e),d=lC(e),f=cC(r),p=s.createProgram(),y,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(kc).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(kc).join(`
`),g.length>0&&(g+=`
`)):(y=[Sy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(kc).join(`
`),g=[Sy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==or?"#define TONE_MAPPING":"",e.toneMapping!==or?we.tonemapping_pars_fragment:"",e.toneMapping!==or?oC("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",we.colorspace_pars_fragment,sC("linearToOutputTexel",e.outputColorSpace),aC(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(kc).join(`
`)),o=jm(o),o=vy(o,e),o=by(o,e),a=jm(a),a=vy(a,e),a=by(a,e),o=My(o),a=My(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===Fm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Fm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+y+o,E=m+g+a,b=_y(s,s.VERTEX_SHADER,_),A=_y(s,s.FRAGMENT_SHADER,E);s.attachShader(p,b),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(I){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(b)||"",V=s.getShaderInfoLog(A)||"",k=N.trim(),O=H.trim(),L=V.trim(),F=!0,j=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(F=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,A);else{let X=yy(s,b,"vertex"),J=yy(s,A,"fragment");oe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+k+`
`+X+`
`+J)}else k!==""?ie("WebGLProgram: Program Info Log:",k):(O===""||L==="")&&(j=!1);j&&(I.diagnostics={runnable:F,programLog:k,vertexShader:{log:O,prefix:y},fragmentShader:{log:L,prefix:g}})}s.deleteShader(b),s.deleteShader(A),x=new Ja(s,p),S=uC(s,p)}let x;this.getUniforms=function(){return x===void 0&&T(this),x};let S;this.getAttributes=function(){return S===void 0&&T(this),S};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,tC)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eC++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=A,this}var MC=0,Jm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Km(t),e.set(t,i)),i}},Km=class{constructor(t){this.id=MC++,this.code=t,this.usedTimes=0}};function SC(n){return n===oo||n===Fc||n===Oc}function wC(n,t,e,i,s,r){let o=new za,a=new Jm,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,S,D,I,N,H){let V=I.fog,k=N.geometry,O=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,L=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,F=t.get(x.envMap||O,L),j=d[x.type],X=i.precision;x.precision!==null&&(X=i.getMaxPrecision(x.precision),X!==x.precision&&ie("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let J=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,et=J!==void 0?J.length:0,dt=0;k.morphAttributes.position!==void 0&&(dt=1),k.morphAttributes.normal!==void 0&&(dt=2),k.morphAttributes.color!==void 0&&(dt=3);let ft,st,yt,_t;if(j){let Nt=lr[j];ft=Nt.vertexShader,st=Nt.fragmentShader}else{ft=x.vertexShader,st=x.fragmentShader;let Nt=a.getVertexShaderStage(x),xe=a.getFragmentShaderStage(x);a.update(x,Nt,xe),yt=Nt.id,_t=xe.id}let At=n.getRenderTarget(),Rt=n.state.buffers.depth.getReversed(),Kt=N.isInstancedMesh===!0,me=N.isBatchedMesh===!0,jt=!!x.map,Ee=!!x.matcap,ve=!!F,fe=ve&&F.isPMREMTexture===!0,mn=!!x.aoMap,rn=!!x.lightMap,In=!!x.bumpMap&&x.wireframe===!1,Ke=!!x.normalMap,Zn=!!x.displacementMap,Ne=!!x.emissiveMap,kn=!!x.metalnessMap,Mn=!!x.roughnessMap,Ln=x.anisotropy>0,$=x.clearcoat>0,Ut=x.diffuseRoughness>0,se=x.dispersion>0,ge=x.retroreflectivity>0,Pt=x.iridescence>0,tn=x.sheen>0,Zt=x.transmission>0,ee=Ln&&!!x.anisotropyMap,U=$&&!!x.clearcoatMap,R=$&&!!x.clearcoatNormalMap,Z=$&&!!x.clearcoatRoughnessMap,mt=Ut&&!!x.diffuseRoughnessMap,ct=Pt&&!!x.iridescenceMap,wt=Pt&&!!x.iridescenceThicknessMap,Et=tn&&!!x.sheenColorMap,rt=tn&&!!x.sheenRoughnessMap,at=!!x.specularMap,vt=!!x.specularColorMap,W=!!x.specularIntensityMap,lt=Zt&&!!x.transmissionMap,ot=Zt&&!!x.thicknessMap,It=!!x.gradientMap,Mt=!!x.alphaMap,Ct=x.alphaTest>0,Jt=!!x.alphaHash,ae=!!x.extensions,pt=or;x.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(pt=n.toneMapping);let $t=fe?F.isCompressedCubeTexture?F.image[0].mipmaps:F.mipmaps:null,le={shaderID:j,shaderType:x.type,shaderName:x.name,vertexShader:ft,fragmentShader:st,defines:x.defines,customVertexShaderID:yt,customFragmentShaderID:_t,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:me,batchingColor:me&&N._colorsTexture!==null,instancing:Kt,instancingColor:Kt&&N.instanceColor!==null,instancingMorph:Kt&&N.morphTexture!==null,outputColorSpace:At===null?n.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:Le.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:jt,matcap:Ee,envMap:ve,envMapMode:ve&&F.mapping,envMapPMREM:fe,envMapMaxLod:fe?$t.length-1:null,envMapSize:fe?$t[0].width:null,aoMap:mn,lightMap:rn,bumpMap:In,normalMap:Ke,displacementMap:Zn,emissiveMap:Ne,normalMapObjectSpace:Ke&&x.normalMapType===$x,normalMapTangentSpace:Ke&&x.normalMapType===Cm,packedNormalMap:Ke&&x.normalMapType===Cm&&SC(x.normalMap.format),metalnessMap:kn,roughnessMap:Mn,anisotropy:Ln,anisotropyMap:ee,clearcoat:$,clearcoatMap:U,clearcoatNormalMap:R,clearcoatRoughnessMap:Z,diffuseRoughness:Ut,diffuseRoughnessMap:mt,dispersion:se,retroreflection:ge,iridescence:Pt,iridescenceMap:ct,iridescenceThicknessMap:wt,sheen:tn,sheenColorMap:Et,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:W,transmission:Zt,transmissionMap:lt,thicknessMap:ot,gradientMap:It,opaque:x.transparent===!1&&x.blending===Ya&&x.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Ct,alphaHash:Jt,combine:x.combine,mapUv:jt&&f(x.map.channel),aoMapUv:mn&&f(x.aoMap.channel),lightMapUv:rn&&f(x.lightMap.channel),bumpMapUv:In&&f(x.bumpMap.channel),normalMapUv:Ke&&f(x.normalMap.channel),displacementMapUv:Zn&&f(x.displacementMap.channel),emissiveMapUv:Ne&&f(x.emissiveMap.channel),metalnessMapUv:kn&&f(x.metalnessMap.channel),roughnessMapUv:Mn&&f(x.roughnessMap.channel),anisotropyMapUv:ee&&f(x.anisotropyMap.channel),clearcoatMapUv:U&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:wt&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:Et&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(x.sheenRoughnessMap.channel),specularMapUv:at&&f(x.specularMap.channel),specularColorMapUv:vt&&f(x.specularColorMap.channel),specularIntensityMapUv:W&&f(x.specularIntensityMap.channel),transmissionMapUv:lt&&f(x.transmissionMap.channel),thicknessMapUv:ot&&f(x.thicknessMap.channel),alphaMapUv:Mt&&f(x.alphaMap.channel),vertexTangents:!!k.attributes.tangent&&(Ke||Ln),vertexNormals:!!k.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!k.attributes.uv&&(jt||Mt),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||k.attributes.normal===void 0&&Ke===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Rt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:k.attributes.position!==void 0,morphTargets:k.morphAttributes.position!==void 0,morphNormals:k.morphAttributes.normal!==void 0,morphColors:k.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:H.filter(Nt=>Nt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:jt&&x.map.isVideoTexture===!0&&Le.getTransfer(x.map.colorSpace)===$e,decodeVideoTextureEmissive:Ne&&x.emissiveMap.isVideoTexture===!0&&Le.getTransfer(x.emissiveMap.colorSpace)===$e,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===fi,flipSided:x.side===Pi,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ae&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ae&&x.extensions.multiDraw===!0||me)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return le.vertexUv1s=l.has(1),le.vertexUv2s=l.has(2),le.vertexUv3s=l.has(3),l.clear(),le}function y(x){let S=[];if(x.shaderID?S.push(x.shaderID):(S.push(x.customVertexShaderID),S.push(x.customFragmentShaderID)),x.defines!==void 0)for(let D in x.defines)S.push(D),S.push(x.defines[D]);return x.isRawShaderMaterial===!1&&(g(S,x),m(S,x),S.push(n.outputColorSpace)),S.push(x.customProgramCacheKey),S.join()}function g(x,S){x.push(S.precision),x.push(S.outputColorSpace),x.push(S.envMapMode),x.push(S.envMapPMREM),x.push(S.envMapMaxLod),x.push(S.envMapSize),x.push(S.mapUv),x.push(S.alphaMapUv),x.push(S.lightMapUv),x.push(S.aoMapUv),x.push(S.bumpMapUv),x.push(S.normalMapUv),x.push(S.displacementMapUv),x.push(S.emissiveMapUv),x.push(S.metalnessMapUv),x.push(S.roughnessMapUv),x.push(S.anisotropyMapUv),x.push(S.clearcoatMapUv),x.push(S.clearcoatNormalMapUv),x.push(S.clearcoatRoughnessMapUv),x.push(S.diffuseRoughnessMapUv),x.push(S.iridescenceMapUv),x.push(S.iridescenceThicknessMapUv),x.push(S.sheenColorMapUv),x.push(S.sheenRoughnessMapUv),x.push(S.specularMapUv),x.push(S.specularColorMapUv),x.push(S.specularIntensityMapUv),x.push(S.transmissionMapUv),x.push(S.thicknessMapUv),x.push(S.combine),x.push(S.fogExp2),x.push(S.sizeAttenuation),x.push(S.morphTargetsCount),x.push(S.numSunLights),x.push(S.numDirLights),x.push(S.numPointLights),x.push(S.numSpotLights),x.push(S.numSpotLightMaps),x.push(S.numHemiLights),x.push(S.numRectAreaLights),x.push(S.numSunLightShadows),x.push(S.numDirLightShadows),x.push(S.numPointLightShadows),x.push(S.numSpotLightShadows),x.push(S.numSpotLightShadowsWithMaps),x.push(S.numLightProbes),x.push(S.numLightProbeGrids),x.push(S.shadowMapType),x.push(S.toneMapping),x.push(S.numClippingPlanes),x.push(S.numClipIntersection),x.push(S.depthPacking)}function m(x,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function _(x){let S=d[x.type],D;if(S){let I=lr[S];D=sy.clone(I.uniforms)}else D=x.uniforms;return D}function E(x,S){let D=u.get(S);return D!==void 0?++D.usedTimes:(D=new bC(n,S,x,s),c.push(D),u.set(S,D)),D}function b(x){if(--x.usedTimes===0){let S=c.indexOf(x);c[S]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function A(x){a.remove(x)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:_,acquireProgram:E,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:T}}function EC(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function TC(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function wy(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Ey(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,y,g,m){let _=n[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:g,group:m},n[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=y,_.renderOrder=d.renderOrder,_.z=g,_.group=m),t++,_}function l(d,f,p,y,g,m,_){_.reversedDepth===!0&&(g=-g);let E=a(d,f,p,y,g,m);p.transmission>0?i.push(E):p.transparent===!0?s.push(E):e.push(E)}function c(d,f,p,y,g,m){let _=a(d,f,p,y,g,m);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function u(d,f){e.length>1&&e.sort(d||TC),i.length>1&&i.sort(f||wy),s.length>1&&s.sort(f||wy)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function AC(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Ey,n.set(i,[o])):s>=r.length?(o=new Ey,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function RC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new ne};break;case"SpotLight":e={position:new G,direction:new G,color:new ne,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new ne,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new ne,groundColor:new ne};break;case"RectAreaLight":e={color:new ne,position:new G,halfWidth:new G,halfHeight:new G};break}return n[t.id]=e,e}}}function CC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var PC=0;function IC(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function LC(n){let t=new RC,e=CC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new _e,o=new _e;function a(c){let u=0,h=0,d=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let f=0,p=0,y=0,g=0,m=0,_=0,E=0,b=0,A=0,T=0,x=0,S=0,D=0,I=0;c.sort(IC);for(let H=0,V=c.length;H<V;H++){let k=c[H],O=k.color,L=k.intensity,F=k.distance,j=null;if(k.shadow&&k.shadow.map&&(k.shadow.map.texture.format===oo?j=k.shadow.map.texture:j=k.shadow.map.depthTexture||k.shadow.map.texture),k.isAmbientLight)u+=O.r*L,h+=O.g*L,d+=O.b*L;else if(k.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(k.sh.coefficients[X],L);I++}else if(k.isSunLight){let X=t.get(k);if(X.color.copy(k.color).multiplyScalar(k.intensity),k.castShadow){let J=k.shadow,et=e.get(k);et.shadowIntensity=J.intensity,et.shadowBias=J.bias,et.shadowNormalBias=J.normalBias,et.shadowRadius=J.radius,et.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=j;let dt=J.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[y+ft]=J.getMatrix(ft),i.sunShadowCascade[y+ft]=J._cascadeData[ft];y+=dt,p++}i.sun[f]=X,f++}else if(k.isDirectionalLight){let X=t.get(k);if(X.color.copy(k.color).multiplyScalar(k.intensity),k.castShadow){let J=k.shadow,et=e.get(k);et.shadowIntensity=J.intensity,et.shadowBias=J.bias,et.shadowNormalBias=J.normalBias,et.shadowRadius=J.radius,et.shadowMapSize=J.mapSize,i.directionalShadow[g]=et,i.directionalShadowMap[g]=j,i.directionalShadowMatrix[g]=k.shadow.matrix,A++}i.directional[g]=X,g++}else if(k.isSpotLight){let X=t.get(k);X.position.setFromMatrixPosition(k.matrixWorld),X.color.copy(O).multiplyScalar(L),X.distance=F,X.coneCos=Math.cos(k.angle),X.penumbraCos=Math.cos(k.angle*(1-k.penumbra)),X.decay=k.decay,i.spot[_]=X;let J=k.shadow;if(k.map&&(i.spotLightMap[S]=k.map,S++,J.updateMatrices(k),k.castShadow&&D++),i.spotLightMatrix[_]=J.matrix,k.castShadow){let et=e.get(k);et.shadowIntensity=J.intensity,et.shadowBias=J.bias,et.shadowNormalBias=J.normalBias,et.shadowRadius=J.radius,et.shadowMapSize=J.mapSize,i.spotShadow[_]=et,i.spotShadowMap[_]=j,x++}_++}else if(k.isRectAreaLight){let X=t.get(k);X.color.copy(O).multiplyScalar(L),X.halfWidth.set(k.width*.5,0,0),X.halfHeight.set(0,k.height*.5,0),i.rectArea[E]=X,E++}else if(k.isPointLight){let X=t.get(k);if(X.color.copy(k.color).multiplyScalar(k.intensity),X.distance=k.distance,X.decay=k.decay,k.castShadow){let J=k.shadow,et=e.get(k);et.shadowIntensity=J.intensity,et.shadowBias=J.bias,et.shadowNormalBias=J.normalBias,et.shadowRadius=J.radius,et.shadowMapSize=J.mapSize,et.shadowCameraNear=J.camera.near,et.shadowCameraFar=J.camera.far,i.pointShadow[m]=et,i.pointShadowMap[m]=j,i.pointShadowMatrix[m]=k.shadow.matrix,T++}i.point[m]=X,m++}else if(k.isHemisphereLight){let X=t.get(k);X.skyColor.copy(k.color).multiplyScalar(L),X.groundColor.copy(k.groundColor).multiplyScalar(L),i.hemi[b]=X,b++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Bt.LTC_FLOAT_1,i.rectAreaLTC2=Bt.LTC_FLOAT_2):(i.rectAreaLTC1=Bt.LTC_HALF_1,i.rectAreaLTC2=Bt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let N=i.hash;(N.sunLength!==f||N.directionalLength!==g||N.pointLength!==m||N.spotLength!==_||N.rectAreaLength!==E||N.hemiLength!==b||N.numSunShadows!==p||N.numDirectionalShadows!==A||N.numPointShadows!==T||N.numSpotShadows!==x||N.numSpotMaps!==S||N.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=g,i.spot.length=_,i.rectArea.length=E,i.point.length=m,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+S-D,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=I,N.sunLength=f,N.directionalLength=g,N.pointLength=m,N.spotLength=_,N.rectAreaLength=E,N.hemiLength=b,N.numSunShadows=p,N.numDirectionalShadows=A,N.numPointShadows=T,N.numSpotShadows=x,N.numSpotMaps=S,N.numLightProbes=I,i.version=PC++)}function l(c,u){let h=0,d=0,f=0,p=0,y=0,g=0,m=u.matrixWorldInverse;for(let _=0,E=c.length;_<E;_++){let b=c[_];if(b.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),h++}else if(b.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),d++}else if(b.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let A=i.rectArea[y];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let A=i.hemi[g];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Ty(n){let t=new LC(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function DC(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Ty(n),t.set(s,[a])):r>=o.length?(a=new Ty(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var NC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,UC=`uniform sampler2D shadow_pass;
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
}`,FC=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],OC=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Ay=new _e,Bc=new G,qm=new G;function BC(n,t,e){let i=new Po,s=new Yt,r=new Yt,o=new vn,a=new Ih,l=new Lh,c={},u=e.maxTextureSize,h={[rr]:Pi,[Pi]:rr,[fi]:fi},d=new Ci({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:NC,fragmentShader:UC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Se;p.setAttribute("position",new ke(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new je(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Pc;let m=this.type;this.render=function(T,x,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===Mx&&(ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Pc);let D=n.getRenderTarget(),I=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),H=n.state;H.setBlending(No),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let V=m!==this.type;V&&x.traverse(function(k){k.material&&(Array.isArray(k.material)?k.material.forEach(O=>O.needsUpdate=!0):k.material.needsUpdate=!0)});for(let k=0,O=T.length;k<O;k++){let L=T[k],F=L.shadow;if(F===void 0){ie("WebGLShadowMap:",L,"has no shadow.");continue}if(F.autoUpdate===!1&&F.needsUpdate===!1)continue;s.copy(F.mapSize);let j=F.getFrameExtents();s.multiply(j),r.copy(F.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/j.x),s.x=r.x*j.x,F.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/j.y),s.y=r.y*j.y,F.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(F.camera._reversedDepth=X,F.map===null||V===!0){if(F.map!==null&&(F.map.depthTexture!==null&&(F.map.depthTexture.dispose(),F.map.depthTexture=null),F.map.dispose()),this.type===Xa){if(L.isPointLight){ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}F.map=new ts(s.x,s.y,{format:oo,type:Ls,minFilter:Ei,magFilter:Ei,generateMipmaps:!1}),F.map.texture.name=L.name+".shadowMap",F.map.depthTexture=new Pr(s.x,s.y,fs),F.map.depthTexture.name=L.name+".shadowMapDepth",F.map.depthTexture.format=Ar,F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=ei,F.map.depthTexture.magFilter=ei}else L.isPointLight?(F.map=new zc(s.x),F.map.depthTexture=new vc(s.x,Is)):(F.map=new ts(s.x,s.y),F.map.depthTexture=new Pr(s.x,s.y,Is)),F.map.depthTexture.name=L.name+".shadowMap",F.map.depthTexture.format=Ar,this.type===Pc?(F.map.depthTexture.compareFunction=X?Dm:Lm,F.map.depthTexture.minFilter=Ei,F.map.depthTexture.magFilter=Ei):(F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=ei,F.map.depthTexture.magFilter=ei);F.camera.updateProjectionMatrix()}F.map.isWebGLCubeRenderTarget!==!0&&(F.map.width!==s.x||F.map.height!==s.y)&&F.map.setSize(s.x,s.y);let J=F.map.isWebGLCubeRenderTarget?6:F.getViewportCount();L.isPointLight!==!0&&F.updateMatrices(L,S);let et=(F.camera.layers.mask&4294967294)!==0?F.camera.layers:S.layers;for(let dt=0;dt<J;dt++){let ft=F.getCamera(dt);if(L.isPointLight){let st=F.camera,yt=F.matrix,_t=L.distance||st.far;_t!==st.far&&(st.far=_t,st.updateProjectionMatrix()),Bc.setFromMatrixPosition(L.matrixWorld),st.position.copy(Bc),qm.copy(st.position),qm.add(FC[dt]),st.up.copy(OC[dt]),st.lookAt(qm),st.updateMatrixWorld(),yt.makeTranslation(-Bc.x,-Bc.y,-Bc.z),Ay.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),F._frustum.setFromProjectionMatrix(Ay,st.coordinateSystem,st.reversedDepth)}if(F.map.isWebGLCubeRenderTarget)n.setRenderTarget(F.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(F.map),n.clear());let st=F.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),H.viewport(o)}i=F.getFrustum(dt),b(x,S,ft,L,et,this.type)}F.isPointLightShadow!==!0&&this.type===Xa&&_(F,S),F.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(D,I,N)};function _(T,x){let S=t.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new ts(s.x,s.y,{format:oo,type:Ls}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(x,null,S,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(x,null,S,f,y,null)}function E(T,x,S,D){let I=null,N=S.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(N!==void 0)I=N;else if(I=S.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let H=I.uuid,V=x.uuid,k=c[H];k===void 0&&(k={},c[H]=k);let O=k[V];O===void 0&&(O=I.clone(),k[V]=O,x.addEventListener("dispose",A)),I=O}if(I.visible=x.visible,I.wireframe=x.wireframe,D===Xa?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:h[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,S.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let H=n.properties.get(I);H.light=S}return I}function b(T,x,S,D,I,N){if(T.visible===!1)return;if(T.layers.test(I)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&N===Xa)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,T.matrixWorld);let k=t.update(T),O=T.material;if(Array.isArray(O)){let L=k.groups;for(let F=0,j=L.length;F<j;F++){let X=L[F],J=O[X.materialIndex];if(J&&J.visible){let et=E(T,J,D,N);T.onBeforeShadow(n,T,x,S,k,et,X),n.renderBufferDirect(S,null,k,et,T,X),T.onAfterShadow(n,T,x,S,k,et,X)}}}else if(O.visible){let L=E(T,O,D,N);T.onBeforeShadow(n,T,x,S,k,L,null),n.renderBufferDirect(S,null,k,L,T,null),T.onAfterShadow(n,T,x,S,k,L,null)}}let V=T.children;for(let k=0,O=V.length;k<O;k++)b(V[k],x,S,D,I,N)}function A(T){T.target.removeEventListener("dispose",A);for(let S in c){let D=c[S],I=T.target.uuid;I in D&&(D[I].dispose(),delete D[I])}}}function kC(n,t){function e(){let W=!1,lt=new vn,ot=null,It=new vn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!W&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){W=Mt},setClear:function(Mt,Ct,Jt,ae,pt){pt===!0&&(Mt*=ae,Ct*=ae,Jt*=ae),lt.set(Mt,Ct,Jt,ae),It.equals(lt)===!1&&(n.clearColor(Mt,Ct,Jt,ae),It.copy(lt))},reset:function(){W=!1,ot=null,It.set(-1,0,0,0)}}}function i(){let W=!1,lt=!1,ot=null,It=null,Mt=null;return{setReversed:function(Ct){if(lt!==Ct){let Jt=t.get("EXT_clip_control");Ct?Jt.clipControlEXT(Jt.LOWER_LEFT_EXT,Jt.ZERO_TO_ONE_EXT):Jt.clipControlEXT(Jt.LOWER_LEFT_EXT,Jt.NEGATIVE_ONE_TO_ONE_EXT),lt=Ct;let ae=Mt;Mt=null,this.setClear(ae)}},getReversed:function(){return lt},setTest:function(Ct){Ct?Rt(n.DEPTH_TEST):Kt(n.DEPTH_TEST)},setMask:function(Ct){ot!==Ct&&!W&&(n.depthMask(Ct),ot=Ct)},setFunc:function(Ct){if(lt&&(Ct=ey[Ct]),It!==Ct){switch(Ct){case fh:n.depthFunc(n.NEVER);break;case ph:n.depthFunc(n.ALWAYS);break;case mh:n.depthFunc(n.LESS);break;case Fa:n.depthFunc(n.LEQUAL);break;case gh:n.depthFunc(n.EQUAL);break;case _h:n.depthFunc(n.GEQUAL);break;case xh:n.depthFunc(n.GREATER);break;case yh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}It=Ct}},setLocked:function(Ct){W=Ct},setClear:function(Ct){Mt!==Ct&&(Mt=Ct,lt&&(Ct=1-Ct),n.clearDepth(Ct))},reset:function(){W=!1,ot=null,It=null,Mt=null,lt=!1}}}function s(){let W=!1,lt=null,ot=null,It=null,Mt=null,Ct=null,Jt=null,ae=null,pt=null;return{setTest:function($t){W||($t?Rt(n.STENCIL_TEST):Kt(n.STENCIL_TEST))},setMask:function($t){lt!==$t&&!W&&(n.stencilMask($t),lt=$t)},setFunc:function($t,le,Nt){(ot!==$t||It!==le||Mt!==Nt)&&(n.stencilFunc($t,le,Nt),ot=$t,It=le,Mt=Nt)},setOp:function($t,le,Nt){(Ct!==$t||Jt!==le||ae!==Nt)&&(n.stencilOp($t,le,Nt),Ct=$t,Jt=le,ae=Nt)},setLocked:function($t){W=$t},setClear:function($t){pt!==$t&&(n.clearStencil($t),pt=$t)},reset:function(){W=!1,lt=null,ot=null,It=null,Mt=null,Ct=null,Jt=null,ae=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],y=null,g=!1,m=null,_=null,E=null,b=null,A=null,T=null,x=null,S=new ne(0,0,0),D=0,I=!1,N=null,H=null,V=null,k=null,O=null,L=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),F=!1,j=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(X)[1]),F=j>=1):X.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),F=j>=2);let J=null,et={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new vn().fromArray(dt),yt=new vn().fromArray(ft);function _t(W,lt,ot,It){let Mt=new Uint8Array(4),Ct=n.createTexture();n.bindTexture(W,Ct),n.texParameteri(W,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(W,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Jt=0;Jt<ot;Jt++)W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,It,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+Jt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Ct}let At={};At[n.TEXTURE_2D]=_t(n.TEXTURE_2D,n.TEXTURE_2D,1),At[n.TEXTURE_CUBE_MAP]=_t(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[n.TEXTURE_2D_ARRAY]=_t(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),At[n.TEXTURE_3D]=_t(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Rt(n.DEPTH_TEST),o.setFunc(Fa),In(!1),Ke(lm),Rt(n.CULL_FACE),mn(No);function Rt(W){u[W]!==!0&&(n.enable(W),u[W]=!0)}function Kt(W){u[W]!==!1&&(n.disable(W),u[W]=!1)}function me(W,lt){return d[W]!==lt?(n.bindFramebuffer(W,lt),d[W]=lt,W===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),W===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function jt(W,lt){let ot=p,It=!1;if(W){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=W.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Ct=0,Jt=Mt.length;Ct<Jt;Ct++)ot[Ct]=n.COLOR_ATTACHMENT0+Ct;ot.length=Mt.length,It=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,It=!0);It&&n.drawBuffers(ot)}function Ee(W){return y!==W?(n.useProgram(W),y=W,!0):!1}let ve={[Uo]:n.FUNC_ADD,[wx]:n.FUNC_SUBTRACT,[Ex]:n.FUNC_REVERSE_SUBTRACT};ve[Tx]=n.MIN,ve[Ax]=n.MAX;let fe={[Rx]:n.ZERO,[Cx]:n.ONE,[Px]:n.SRC_COLOR,[dm]:n.SRC_ALPHA,[Fx]:n.SRC_ALPHA_SATURATE,[Nx]:n.DST_COLOR,[Lx]:n.DST_ALPHA,[Ix]:n.ONE_MINUS_SRC_COLOR,[fm]:n.ONE_MINUS_SRC_ALPHA,[Ux]:n.ONE_MINUS_DST_COLOR,[Dx]:n.ONE_MINUS_DST_ALPHA,[Ox]:n.CONSTANT_COLOR,[Bx]:n.ONE_MINUS_CONSTANT_COLOR,[kx]:n.CONSTANT_ALPHA,[zx]:n.ONE_MINUS_CONSTANT_ALPHA};function mn(W,lt,ot,It,Mt,Ct,Jt,ae,pt,$t){if(W===No){g===!0&&(Kt(n.BLEND),g=!1);return}if(g===!1&&(Rt(n.BLEND),g=!0),W!==Sx){if(W!==m||$t!==I){if((_!==Uo||A!==Uo)&&(n.blendEquation(n.FUNC_ADD),_=Uo,A=Uo),$t)switch(W){case Ya:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cm:n.blendFunc(n.ONE,n.ONE);break;case um:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hm:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:oe("WebGLState: Invalid blending: ",W);break}else switch(W){case Ya:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case um:oe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hm:oe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:oe("WebGLState: Invalid blending: ",W);break}E=null,b=null,T=null,x=null,S.set(0,0,0),D=0,m=W,I=$t}return}Mt=Mt||lt,Ct=Ct||ot,Jt=Jt||It,(lt!==_||Mt!==A)&&(n.blendEquationSeparate(ve[lt],ve[Mt]),_=lt,A=Mt),(ot!==E||It!==b||Ct!==T||Jt!==x)&&(n.blendFuncSeparate(fe[ot],fe[It],fe[Ct],fe[Jt]),E=ot,b=It,T=Ct,x=Jt),(ae.equals(S)===!1||pt!==D)&&(n.blendColor(ae.r,ae.g,ae.b,pt),S.copy(ae),D=pt),m=W,I=!1}function rn(W,lt){W.side===fi?Kt(n.CULL_FACE):Rt(n.CULL_FACE);let ot=W.side===Pi;lt&&(ot=!ot),In(ot),W.blending===Ya&&W.transparent===!1?mn(No):mn(W.blending,W.blendEquation,W.blendSrc,W.blendDst,W.blendEquationAlpha,W.blendSrcAlpha,W.blendDstAlpha,W.blendColor,W.blendAlpha,W.premultipliedAlpha),o.setFunc(W.depthFunc),o.setTest(W.depthTest),o.setMask(W.depthWrite),r.setMask(W.colorWrite);let It=W.stencilWrite;a.setTest(It),It&&(a.setMask(W.stencilWriteMask),a.setFunc(W.stencilFunc,W.stencilRef,W.stencilFuncMask),a.setOp(W.stencilFail,W.stencilZFail,W.stencilZPass)),Ne(W.polygonOffset,W.polygonOffsetFactor,W.polygonOffsetUnits),W.alphaToCoverage===!0?Rt(n.SAMPLE_ALPHA_TO_COVERAGE):Kt(n.SAMPLE_ALPHA_TO_COVERAGE)}function In(W){N!==W&&(W?n.frontFace(n.CW):n.frontFace(n.CCW),N=W)}function Ke(W){W!==vx?(Rt(n.CULL_FACE),W!==H&&(W===lm?n.cullFace(n.BACK):W===bx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Kt(n.CULL_FACE),H=W}function Zn(W){W!==V&&(F&&n.lineWidth(W),V=W)}function Ne(W,lt,ot){W?(Rt(n.POLYGON_OFFSET_FILL),(k!==lt||O!==ot)&&(k=lt,O=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Kt(n.POLYGON_OFFSET_FILL)}function kn(W){W?Rt(n.SCISSOR_TEST):Kt(n.SCISSOR_TEST)}function Mn(W){W===void 0&&(W=n.TEXTURE0+L-1),J!==W&&(n.activeTexture(W),J=W)}function Ln(W,lt,ot){ot===void 0&&(J===null?ot=n.TEXTURE0+L-1:ot=J);let It=et[ot];It===void 0&&(It={type:void 0,texture:void 0},et[ot]=It),(It.type!==W||It.texture!==lt)&&(J!==ot&&(n.activeTexture(ot),J=ot),n.bindTexture(W,lt||At[W]),It.type=W,It.texture=lt)}function $(){let W=et[J];W!==void 0&&W.type!==void 0&&(n.bindTexture(W.type,null),W.type=void 0,W.texture=void 0)}function Ut(){try{n.compressedTexImage2D(...arguments)}catch(W){oe("WebGLState:",W)}}function se(){try{n.compressedTexImage3D(...arguments)}catch(W){oe("WebGLState:",W)}}function ge(){try{n.texSubImage2D(...arguments)}catch(W){oe("WebGLState:",W)}}function Pt(){try{n.texSubImage3D(...arguments)}catch(W){oe("WebGLState:",W)}}function tn(){try{n.compressedTexSubImage2D(...arguments)}catch(W){oe("WebGLState:",W)}}function Zt(){try{n.compressedTexSubImage3D(...arguments)}catch(W){oe("WebGLState:",W)}}function ee(){try{n.texStorage2D(...arguments)}catch(W){oe("WebGLState:",W)}}function U(){try{n.texStorage3D(...arguments)}catch(W){oe("WebGLState:",W)}}function R(){try{n.texImage2D(...arguments)}catch(W){oe("WebGLState:",W)}}function Z(){try{n.texImage3D(...arguments)}catch(W){oe("WebGLState:",W)}}function mt(W){return h[W]!==void 0?h[W]:n.getParameter(W)}function ct(W,lt){h[W]!==lt&&(n.pixelStorei(W,lt),h[W]=lt)}function wt(W){st.equals(W)===!1&&(n.scissor(W.x,W.y,W.z,W.w),st.copy(W))}function Et(W){yt.equals(W)===!1&&(n.viewport(W.x,W.y,W.z,W.w),yt.copy(W))}function rt(W,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let It=ot.get(W);It===void 0&&(It=n.getUniformBlockIndex(lt,W.name),n.uniformBlockBinding(lt,It,It),ot.set(W,It))}function at(W,lt,ot){let Mt=c.get(lt).get(W);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},J=null,et={},d={},l={},f=new WeakMap,p=[],y=null,g=!1,m=null,_=null,E=null,b=null,A=null,T=null,x=null,S=new ne(0,0,0),D=0,I=!1,N=null,H=null,V=null,k=null,O=null,st.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Rt,disable:Kt,bindFramebuffer:me,drawBuffers:jt,useProgram:Ee,setBlending:mn,setMaterial:rn,setFlipSided:In,setCullFace:Ke,setLineWidth:Zn,setPolygonOffset:Ne,setScissorTest:kn,activeTexture:Mn,bindTexture:Ln,unbindTexture:$,compressedTexImage2D:Ut,compressedTexImage3D:se,texImage2D:R,texImage3D:Z,pixelStorei:ct,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:ee,texStorage3D:U,texSubImage2D:ge,texSubImage3D:Pt,compressedTexSubImage2D:tn,compressedTexSubImage3D:Zt,scissor:wt,viewport:Et,reset:vt}}function zC(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,y=new FinalizationRegistry(U=>p.delete(U)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(U,R){return g?new OffscreenCanvas(U,R):lc("canvas")}function _(U,R,Z){let mt=1,ct=ee(U);if((ct.width>Z||ct.height>Z)&&(mt=Z/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&U instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&U instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&U instanceof ImageBitmap||typeof VideoFrame<"u"&&U instanceof VideoFrame){let wt=Math.floor(mt*ct.width),Et=Math.floor(mt*ct.height);d===void 0&&(d=m(wt,Et));let rt=R?m(wt,Et):d;return rt.width=wt,rt.height=Et,rt.getContext("2d").drawImage(U,0,0,wt,Et),ie("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+wt+"x"+Et+")."),rt}else return"data"in U&&ie("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),U;return U}function E(U){return U.generateMipmaps}function b(U){n.generateMipmap(U)}function A(U){return U.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:U.isWebGL3DRenderTarget?n.TEXTURE_3D:U.isWebGLArrayRenderTarget||U.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(U,R,Z,mt,ct,wt=!1){if(U!==null){if(n[U]!==void 0)return n[U];ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+U+"'")}let Et;mt&&(Et=t.get("EXT_texture_norm16"),Et||ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(Z===n.FLOAT&&(rt=n.R32F),Z===n.HALF_FLOAT&&(rt=n.R16F),Z===n.UNSIGNED_BYTE&&(rt=n.R8),Z===n.UNSIGNED_SHORT&&Et&&(rt=Et.R16_EXT),Z===n.SHORT&&Et&&(rt=Et.R16_SNORM_EXT)),R===n.RED_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.R8UI),Z===n.UNSIGNED_SHORT&&(rt=n.R16UI),Z===n.UNSIGNED_INT&&(rt=n.R32UI),Z===n.BYTE&&(rt=n.R8I),Z===n.SHORT&&(rt=n.R16I),Z===n.INT&&(rt=n.R32I)),R===n.RG&&(Z===n.FLOAT&&(rt=n.RG32F),Z===n.HALF_FLOAT&&(rt=n.RG16F),Z===n.UNSIGNED_BYTE&&(rt=n.RG8),Z===n.UNSIGNED_SHORT&&Et&&(rt=Et.RG16_EXT),Z===n.SHORT&&Et&&(rt=Et.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.RG8UI),Z===n.UNSIGNED_SHORT&&(rt=n.RG16UI),Z===n.UNSIGNED_INT&&(rt=n.RG32UI),Z===n.BYTE&&(rt=n.RG8I),Z===n.SHORT&&(rt=n.RG16I),Z===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),Z===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),Z===n.UNSIGNED_INT&&(rt=n.RGB32UI),Z===n.BYTE&&(rt=n.RGB8I),Z===n.SHORT&&(rt=n.RGB16I),Z===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),Z===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),Z===n.UNSIGNED_INT&&(rt=n.RGBA32UI),Z===n.BYTE&&(rt=n.RGBA8I),Z===n.SHORT&&(rt=n.RGBA16I),Z===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(Z===n.UNSIGNED_SHORT&&Et&&(rt=Et.RGB16_EXT),Z===n.SHORT&&Et&&(rt=Et.RGB16_SNORM_EXT),Z===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),Z===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=wt?oc:Le.getTransfer(ct);Z===n.FLOAT&&(rt=n.RGBA32F),Z===n.HALF_FLOAT&&(rt=n.RGBA16F),Z===n.UNSIGNED_BYTE&&(rt=at===$e?n.SRGB8_ALPHA8:n.RGBA8),Z===n.UNSIGNED_SHORT&&Et&&(rt=Et.RGBA16_EXT),Z===n.SHORT&&Et&&(rt=Et.RGBA16_SNORM_EXT),Z===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),Z===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function x(U,R){let Z;return U?R===null||R===Is||R===Oo?Z=n.DEPTH24_STENCIL8:R===fs?Z=n.DEPTH32F_STENCIL8:R===ja&&(Z=n.DEPTH24_STENCIL8,ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Is||R===Oo?Z=n.DEPTH_COMPONENT24:R===fs?Z=n.DEPTH_COMPONENT32F:R===ja&&(Z=n.DEPTH_COMPONENT16),Z}function S(U,R){return E(U)===!0||U.isFramebufferTexture&&U.minFilter!==ei&&U.minFilter!==Ei?Math.log2(Math.max(R.width,R.height))+1:U.mipmaps.length>0?U.mipmaps.length:U.isCompressedTexture&&Array.isArray(U.image)?R.mipmaps.length:1}function D(U){let R=new WeakRef(U);i.get(U).__ref=R,p.add(R),y.register(U,R,R)}function I(U){let R=i.get(U).__ref;R!==void 0&&(p.delete(R),y.unregister(R))}function N(U){V(U.target)}function H(U){k(U.target)}function V(U){U.removeEventListener("dispose",N),I(U),L(U),U.isVideoTexture&&u.delete(U),U.isHTMLTexture&&h.delete(U)}function k(U){U.removeEventListener("dispose",H),I(U),j(U)}function O(){for(let U of p){let R=U.deref();R!==void 0&&(R.isRenderTarget===!0?k(R):V(R))}p.clear(),h.clear()}function L(U){let R=i.get(U);if(R.__webglInit===void 0)return;let Z=U.source,mt=f.get(Z);if(mt){let ct=mt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&F(U),Object.keys(mt).length===0&&f.delete(Z)}i.remove(U)}function F(U){let R=i.get(U);n.deleteTexture(R.__webglTexture);let Z=U.source,mt=f.get(Z);delete mt[R.__cacheKey],o.memory.textures--}function j(U){let R=i.get(U);R.__depthDisposeCallback&&R.__depthDisposeCallback();let Z=U.depthTexture;if(Z&&Z.renderTarget===U&&V(Z),U.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let wt=0;wt<R.__webglFramebuffer[ct].length;wt++)n.deleteFramebuffer(R.__webglFramebuffer[ct][wt]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=U.textures;for(let ct=0,wt=mt.length;ct<wt;ct++){let Et=i.get(mt[ct]);Et.__webglTexture&&(n.deleteTexture(Et.__webglTexture),o.memory.textures--),i.remove(mt[ct])}i.remove(U)}let X=0;function J(){X=0}function et(){return X}function dt(U){X=U}function ft(){let U=X;return U>=s.maxTextures&&ie("WebGLTextures: Trying to use "+(U+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,U}function st(U){let R=[];return R.push(U.wrapS),R.push(U.wrapT),R.push(U.wrapR||0),R.push(U.magFilter),R.push(U.minFilter),R.push(U.anisotropy),R.push(U.internalFormat),R.push(U.format),R.push(U.type),R.push(U.generateMipmaps),R.push(U.mipmapsAutoUpdate),R.push(U.premultiplyAlpha),R.push(U.flipY),R.push(U.unpackAlignment),R.push(U.colorSpace),R.join()}function yt(U,R){let Z=i.get(U);if(U.isVideoTexture&&tn(U),U.isRenderTargetTexture===!1&&U.isExternalTexture!==!0&&U.version>0&&Z.__version!==U.version){let mt=U.image;if(mt===null)ie("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ie("WebGLRenderer: Texture marked for update but image is incomplete");else{rn(Z,U,R);return}}else U.isExternalTexture&&(Z.__webglTexture=U.sourceTexture?U.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Z.__webglTexture,n.TEXTURE0+R)}function _t(U,R){let Z=i.get(U);if(U.isRenderTargetTexture===!1&&U.version>0&&Z.__version!==U.version){rn(Z,U,R);return}else U.isExternalTexture&&(Z.__webglTexture=U.sourceTexture?U.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Z.__webglTexture,n.TEXTURE0+R)}function At(U,R){let Z=i.get(U);if(U.isRenderTargetTexture===!1&&U.version>0&&Z.__version!==U.version){rn(Z,U,R);return}e.bindTexture(n.TEXTURE_3D,Z.__webglTexture,n.TEXTURE0+R)}function Rt(U,R){let Z=i.get(U);if(U.version>0&&Z.__version!==U.version){In(Z,U,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture,n.TEXTURE0+R)}let Kt={[vh]:n.REPEAT,[tr]:n.CLAMP_TO_EDGE,[bh]:n.MIRRORED_REPEAT},me={[ei]:n.NEAREST,[Vx]:n.NEAREST_MIPMAP_NEAREST,[Ic]:n.NEAREST_MIPMAP_LINEAR,[Ei]:n.LINEAR,[Xh]:n.LINEAR_MIPMAP_NEAREST,[Ir]:n.LINEAR_MIPMAP_LINEAR},jt={[Xx]:n.NEVER,[Nm]:n.ALWAYS,[Yx]:n.LESS,[Lm]:n.LEQUAL,[Zx]:n.EQUAL,[Dm]:n.GEQUAL,[jx]:n.GREATER,[Jx]:n.NOTEQUAL};function Ee(U,R){if(R.type===fs&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Ei||R.magFilter===Xh||R.magFilter===Ic||R.magFilter===Ir||R.minFilter===Ei||R.minFilter===Xh||R.minFilter===Ic||R.minFilter===Ir)&&ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(U,n.TEXTURE_WRAP_S,Kt[R.wrapS]),n.texParameteri(U,n.TEXTURE_WRAP_T,Kt[R.wrapT]),(U===n.TEXTURE_3D||U===n.TEXTURE_2D_ARRAY)&&n.texParameteri(U,n.TEXTURE_WRAP_R,Kt[R.wrapR]),n.texParameteri(U,n.TEXTURE_MAG_FILTER,me[R.magFilter]),n.texParameteri(U,n.TEXTURE_MIN_FILTER,me[R.minFilter]),R.compareFunction&&(n.texParameteri(U,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(U,n.TEXTURE_COMPARE_FUNC,jt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===ei||R.minFilter!==Ic&&R.minFilter!==Ir||R.type===fs&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(U,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ve(U,R){let Z=!1;U.__webglInit===void 0&&(U.__webglInit=!0,R.addEventListener("dispose",N),D(R));let mt=R.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let wt=st(R);if(wt!==U.__cacheKey){ct[wt]===void 0&&(ct[wt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),ct[wt].usedTimes++;let Et=ct[U.__cacheKey];Et!==void 0&&(ct[U.__cacheKey].usedTimes--,Et.usedTimes===0&&F(R)),U.__cacheKey=wt,U.__webglTexture=ct[wt].texture}return Z}function fe(U,R,Z){return Math.floor(Math.floor(U/Z)/R)}function mn(U,R,Z,mt){let wt=U.updateRanges;if(wt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,Z,mt,R.data);else{wt.sort((W,lt)=>W.start-lt.start);let Et=0;for(let W=1;W<wt.length;W++){let lt=wt[Et],ot=wt[W],It=lt.start+lt.count,Mt=fe(ot.start,R.width,4),Ct=fe(lt.start,R.width,4);ot.start<=It+1&&Mt===Ct&&fe(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++Et,wt[Et]=ot)}wt.length=Et+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let W=0,lt=wt.length;W<lt;W++){let ot=wt[W],It=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Ct=It%R.width,Jt=Math.floor(It/R.width),ae=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Ct),e.pixelStorei(n.UNPACK_SKIP_ROWS,Jt),e.texSubImage2D(n.TEXTURE_2D,0,Ct,Jt,ae,pt,Z,mt,R.data)}U.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function rn(U,R,Z){let mt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=n.TEXTURE_3D);let ct=ve(U,R),wt=R.source;e.bindTexture(mt,U.__webglTexture,n.TEXTURE0+Z);let Et=i.get(wt);if(wt.version!==Et.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+Z),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=Le.getPrimaries(Le.workingColorSpace),$t=R.colorSpace===Dr?null:Le.getPrimaries(R.colorSpace),le=R.colorSpace===Dr||pt===$t?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,le)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=_(R.image,!1,s.maxTextureSize);at=Zt(R,at);let vt=r.convert(R.format,R.colorSpace),W=r.convert(R.type),lt=T(R.internalFormat,vt,W,R.normalized,R.colorSpace,R.isVideoTexture);Ee(mt,R);let ot,It=R.mipmaps,Mt=R.isVideoTexture!==!0,Ct=Et.__version===void 0||ct===!0,Jt=wt.dataReady,ae=S(R,at);if(R.isDepthTexture)lt=x(R.format===Lr,R.type),Ct&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,W,null));else if(R.isDataTexture)if(It.length>0){Mt&&Ct&&e.texStorage2D(n.TEXTURE_2D,ae,lt,It[0].width,It[0].height);for(let pt=0,$t=It.length;pt<$t;pt++)ot=It[pt],Mt?Jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,W,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,W,ot.data);R.generateMipmaps=!1}else Mt?(Ct&&e.texStorage2D(n.TEXTURE_2D,ae,lt,at.width,at.height),Jt&&mn(R,at,vt,W)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,W,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Ct&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ae,lt,It[0].width,It[0].height,at.depth);for(let pt=0,$t=It.length;pt<$t;pt++)if(ot=It[pt],R.format!==Ds)if(vt!==null)if(Mt){if(Jt)if(R.layerUpdates.size>0){let le=Wm(ot.width,ot.height,R.format,R.type);for(let Nt of R.layerUpdates){let xe=ot.data.subarray(Nt*le/ot.data.BYTES_PER_ELEMENT,(Nt+1)*le/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Nt,ot.width,ot.height,1,vt,xe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?Jt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,W,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,vt,W,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Ct&&e.texStorage2D(n.TEXTURE_2D,ae,lt,It[0].width,It[0].height);for(let pt=0,$t=It.length;pt<$t;pt++)ot=It[pt],R.format!==Ds?vt!==null?Mt?Jt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?Jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,W,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,W,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Ct&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ae,lt,at.width,at.height,at.depth),Jt)if(R.layerUpdates.size>0){let pt=Wm(at.width,at.height,R.format,R.type);for(let $t of R.layerUpdates){let le=at.data.subarray($t*pt/at.data.BYTES_PER_ELEMENT,($t+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,$t,at.width,at.height,1,vt,W,le)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,W,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,vt,W,at.data);else if(R.isData3DTexture)Mt?(Ct&&e.texStorage3D(n.TEXTURE_3D,ae,lt,at.width,at.height,at.depth),Jt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,W,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,vt,W,at.data);else if(R.isFramebufferTexture){if(Ct)if(Mt)e.texStorage2D(n.TEXTURE_2D,ae,lt,at.width,at.height);else{let pt=at.width,$t=at.height;for(let le=0;le<ae;le++)e.texImage2D(n.TEXTURE_2D,le,lt,pt,$t,0,vt,W,null),pt>>=1,$t>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=$t=>{let le=$t.changedElements;for(let Nt of h)le.includes(Nt.image)&&(Nt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let le=n.RGBA,Nt=n.RGBA,xe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,le,Nt,xe,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(It.length>0){if(Mt&&Ct){let pt=ee(It[0]);e.texStorage2D(n.TEXTURE_2D,ae,lt,pt.width,pt.height)}for(let pt=0,$t=It.length;pt<$t;pt++)ot=It[pt],Mt?Jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,vt,W,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,vt,W,ot);R.generateMipmaps=!1}else if(Mt){if(Ct){let pt=ee(at);e.texStorage2D(n.TEXTURE_2D,ae,lt,pt.width,pt.height)}Jt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,W,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,vt,W,at);E(R)&&R.mipmapsAutoUpdate===!0&&b(mt),Et.__version=wt.version,R.onUpdate&&R.onUpdate(R)}U.__version=R.version}function In(U,R,Z){if(R.image.length!==6)return;let mt=ve(U,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,U.__webglTexture,n.TEXTURE0+Z);let wt=i.get(ct);if(ct.version!==wt.__version||mt===!0){e.activeTexture(n.TEXTURE0+Z);let Et=Le.getPrimaries(Le.workingColorSpace),rt=R.colorSpace===Dr?null:Le.getPrimaries(R.colorSpace),at=R.colorSpace===Dr||Et===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=R.isCompressedTexture||R.image[0].isCompressedTexture,W=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Nt=0;Nt<6;Nt++)!vt&&!W?lt[Nt]=_(R.image[Nt],!0,s.maxCubemapSize):lt[Nt]=W?R.image[Nt].image:R.image[Nt],lt[Nt]=Zt(R,lt[Nt]);let ot=lt[0],It=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Ct=T(R.internalFormat,It,Mt,R.normalized,R.colorSpace),Jt=R.isVideoTexture!==!0,ae=wt.__version===void 0||mt===!0,pt=ct.dataReady,$t=S(R,ot);Ee(n.TEXTURE_CUBE_MAP,R);let le;if(R.isDepthTexture){if(Ct=x(R.format===Lr,R.type),ae)if(Jt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Ct,ot.width,ot.height);else for(let Nt=0;Nt<6;Nt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Ct,ot.width,ot.height,0,It,Mt,null)}else if(vt){Jt&&ae&&e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Ct,ot.width,ot.height);for(let Nt=0;Nt<6;Nt++){le=lt[Nt].mipmaps;for(let xe=0;xe<le.length;xe++){let on=le[xe];R.format!==Ds?It!==null?Jt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe,0,0,on.width,on.height,It,on.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe,Ct,on.width,on.height,0,on.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe,0,0,on.width,on.height,It,Mt,on.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe,Ct,on.width,on.height,0,It,Mt,on.data)}}}else{if(le=R.mipmaps,Jt&&ae){le.length>0&&$t++;let Nt=ee(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Ct,Nt.width,Nt.height)}for(let Nt=0;Nt<6;Nt++)if(W){Jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,lt[Nt].width,lt[Nt].height,It,Mt,lt[Nt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Ct,lt[Nt].width,lt[Nt].height,0,It,Mt,lt[Nt].data);for(let xe=0;xe<le.length;xe++){let _i=le[xe].image[Nt].image;Jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe+1,0,0,_i.width,_i.height,It,Mt,_i.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe+1,Ct,_i.width,_i.height,0,It,Mt,_i.data)}}else{Jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,0,0,It,Mt,lt[Nt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,0,Ct,It,Mt,lt[Nt]);for(let xe=0;xe<le.length;xe++){let on=le[xe];Jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe+1,0,0,It,Mt,on.image[Nt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Nt,xe+1,Ct,It,Mt,on.image[Nt])}}}E(R)&&R.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),wt.__version=ct.version,R.onUpdate&&R.onUpdate(R)}U.__version=R.version}function Ke(U,R,Z,mt,ct,wt){let Et=r.convert(Z.format,Z.colorSpace),rt=r.convert(Z.type),at=T(Z.internalFormat,Et,rt,Z.normalized,Z.colorSpace),vt=i.get(R),W=i.get(Z);if(W.__renderTarget=R,!vt.__hasExternalTextures){let lt=Math.max(1,R.width>>wt),ot=Math.max(1,R.height>>wt);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,wt,at,lt,ot,R.depth,0,Et,rt,null):e.texImage2D(ct,wt,at,lt,ot,0,Et,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,U),Pt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ct,W.__webglTexture,0,ge(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ct,W.__webglTexture,wt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Zn(U,R,Z){if(n.bindRenderbuffer(n.RENDERBUFFER,U),R.depthBuffer){let mt=R.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,wt=x(R.stencilBuffer,ct),Et=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Pt(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ge(R),wt,R.width,R.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,ge(R),wt,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,wt,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Et,n.RENDERBUFFER,U)}else{let mt=R.textures;for(let ct=0;ct<mt.length;ct++){let wt=mt[ct],Et=r.convert(wt.format,wt.colorSpace),rt=r.convert(wt.type),at=T(wt.internalFormat,Et,rt,wt.normalized,wt.colorSpace);Pt(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ge(R),at,R.width,R.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,ge(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ne(U,R,Z){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,U),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let wt=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||wt.width!==R.width||wt.height!==R.height)&&(wt.width=R.width,wt.height=R.height,R.depthTexture.needsUpdate=!0),mt?Rt(R.depthTexture,0):yt(R.depthTexture,0);let Et=ct.__webglTexture,rt=ge(R),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+Z:n.TEXTURE_2D,vt=R.depthTexture.format===Lr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===Ar)Pt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,Et,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,Et,0);else if(R.depthTexture.format===Lr)Pt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,Et,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,Et,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function kn(U){let R=i.get(U),Z=U.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==U.depthTexture){let mt=U.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=mt}if(U.depthTexture&&!R.__autoAllocateDepthBuffer)if(Z)for(let mt=0;mt<6;mt++)Ne(R.__webglFramebuffer[mt],U,mt);else U.texture.mipmaps.length>0?Ne(R.__webglFramebuffer[0],U,0):Ne(R.__webglFramebuffer,U,0);else if(Z){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=n.createRenderbuffer(),Zn(R.__webglDepthbuffer[mt],U,!1);else{let ct=U.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=R.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,wt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,wt)}}else if(U.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),Zn(R.__webglDepthbuffer,U,!1);else{let ct=U.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,wt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,wt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Mn(U,R,Z){let mt=i.get(U);R!==void 0&&Ke(mt.__webglFramebuffer,U,U.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Z!==void 0&&kn(U)}function Ln(U){let R=U.texture,Z=i.get(U),mt=i.get(R);U.addEventListener("dispose",H),D(U);let ct=U.textures,wt=U.isWebGLCubeRenderTarget===!0,Et=ct.length>1;if(Et||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=R.version,o.memory.textures++),wt){Z.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){Z.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)Z.__webglFramebuffer[rt][at]=n.createFramebuffer()}else Z.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){Z.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)Z.__webglFramebuffer[rt]=n.createFramebuffer()}else Z.__webglFramebuffer=n.createFramebuffer();if(Et)for(let rt=0,at=ct.length;rt<at;rt++){let vt=i.get(ct[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(U.samples>0&&Pt(U)===!1){Z.__webglMultisampledFramebuffer=n.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];Z.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Z.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),W=r.convert(at.type),lt=T(at.internalFormat,vt,W,at.normalized,at.colorSpace,U.isXRRenderTarget===!0),ot=ge(U);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,U.width,U.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,Z.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),U.depthBuffer&&(Z.__webglDepthRenderbuffer=n.createRenderbuffer(),Zn(Z.__webglDepthRenderbuffer,U,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(wt){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),Ee(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Ke(Z.__webglFramebuffer[rt][at],U,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Ke(Z.__webglFramebuffer[rt],U,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);E(R)?b(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(Et){for(let rt=0,at=ct.length;rt<at;rt++){let vt=ct[rt],W=i.get(vt),lt=n.TEXTURE_2D;(U.isWebGL3DRenderTarget||U.isWebGLArrayRenderTarget)&&(lt=U.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,W.__webglTexture),Ee(lt,vt),Ke(Z.__webglFramebuffer,U,vt,n.COLOR_ATTACHMENT0+rt,lt,0),E(vt)&&b(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((U.isWebGL3DRenderTarget||U.isWebGLArrayRenderTarget)&&(rt=U.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),Ee(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Ke(Z.__webglFramebuffer[at],U,R,n.COLOR_ATTACHMENT0,rt,at);else Ke(Z.__webglFramebuffer,U,R,n.COLOR_ATTACHMENT0,rt,0);E(R)?b(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}U.depthBuffer&&kn(U)}function $(U){let R=U.textures;for(let Z=0,mt=R.length;Z<mt;Z++){let ct=R[Z];if(E(ct)&&ct.mipmapsAutoUpdate===!0){let wt=A(U),Et=i.get(ct).__webglTexture;e.bindTexture(wt,Et),b(wt),e.unbindTexture()}}}let Ut=[];function se(U){if(U.samples>0){if(Pt(U)===!1){let R=U.textures,Z=U.width,mt=U.height,ct=n.COLOR_BUFFER_BIT,wt=U.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Et=i.get(U),rt=R.length>1;if(rt)for(let vt=0;vt<R.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Et.__webglMultisampledFramebuffer),U.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Et.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Et.__webglFramebuffer);for(let vt=0;vt<R.length;vt++){if(U.resolveDepthBuffer&&(U.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),U.stencilBuffer&&U.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Et.__webglColorRenderbuffer[vt]);let W=i.get(R[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,W,0)}n.blitFramebuffer(0,0,Z,mt,0,0,Z,mt,ct,n.NEAREST),l===!0&&(Ut.length=0,Ut.push(n.COLOR_ATTACHMENT0+vt),U.depthBuffer&&U.storeMultisampledDepthBuffer===!1&&Ut.push(wt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ut))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<R.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,Et.__webglColorRenderbuffer[vt]);let W=i.get(R[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Et.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,W,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Et.__webglMultisampledFramebuffer)}else if(U.depthBuffer&&U.storeMultisampledDepthBuffer===!1&&l){let R=U.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function ge(U){return Math.min(s.maxSamples,U.samples)}function Pt(U){let R=i.get(U);return U.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function tn(U){let R=o.render.frame;u.get(U)!==R&&(u.set(U,R),U.update())}function Zt(U,R){let Z=U.colorSpace,mt=U.format,ct=U.type;return U.isCompressedTexture===!0||U.isVideoTexture===!0||Z!==rc&&Z!==Dr&&(Le.getTransfer(Z)===$e?(mt!==Ds||ct!==is)&&ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):oe("WebGLTextures: Unsupported texture color space:",Z)),R}function ee(U){return typeof HTMLImageElement<"u"&&U instanceof HTMLImageElement?(c.width=U.naturalWidth||U.width,c.height=U.naturalHeight||U.height):typeof VideoFrame<"u"&&U instanceof VideoFrame?(c.width=U.displayWidth,c.height=U.displayHeight):(c.width=U.width,c.height=U.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=J,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=yt,this.setTexture2DArray=_t,this.setTexture3D=At,this.setTextureCube=Rt,this.rebindTextures=Mn,this.setupRenderTarget=Ln,this.updateRenderTargetMipmap=$,this.updateMultisampleRenderTarget=se,this.setupDepthRenderbuffer=kn,this.setupFrameBufferTexture=Ke,this.useMultisampledRTT=Pt,this.dispose=O}function HC(n,t){function e(i,s=Dr){let r,o=Le.getTransfer(s);if(i===is)return n.UNSIGNED_BYTE;if(i===Zh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===jh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Em)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Tm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Sm)return n.BYTE;if(i===wm)return n.SHORT;if(i===ja)return n.UNSIGNED_SHORT;if(i===Yh)return n.INT;if(i===Is)return n.UNSIGNED_INT;if(i===fs)return n.FLOAT;if(i===Ls)return n.HALF_FLOAT;if(i===Am)return n.ALPHA;if(i===Rm)return n.RGB;if(i===Ds)return n.RGBA;if(i===Ar)return n.DEPTH_COMPONENT;if(i===Lr)return n.DEPTH_STENCIL;if(i===Jh)return n.RED;if(i===Kh)return n.RED_INTEGER;if(i===oo)return n.RG;if(i===Qh)return n.RG_INTEGER;if(i===td)return n.RGBA_INTEGER;if(i===Lc||i===Dc||i===Nc||i===Uc)if(o===$e)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Lc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Dc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Nc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Uc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Lc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Dc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Nc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Uc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ed||i===nd||i===id||i===sd)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ed)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===nd)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===id)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===sd)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===rd||i===od||i===ad||i===ld||i===cd||i===Fc||i===ud)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===rd||i===od)return o===$e?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ad)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ld)return r.COMPRESSED_R11_EAC;if(i===cd)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Fc)return r.COMPRESSED_RG11_EAC;if(i===ud)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===hd||i===dd||i===fd||i===pd||i===md||i===gd||i===_d||i===xd||i===yd||i===vd||i===bd||i===Md||i===Sd||i===wd)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===hd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===dd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===fd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===pd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===md)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===gd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===_d)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===xd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===yd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===vd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===bd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Md)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Sd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===wd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ed||i===Td||i===Ad)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ed)return o===$e?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Td)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ad)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Rd||i===Cd||i===Oc||i===Pd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Rd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Cd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Oc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Pd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Oo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var GC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,VC=`
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

}`,Qm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new bc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ci({vertexShader:GC,fragmentShader:VC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new je(new Ec(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},tg=class extends Cs{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,y=typeof XRWebGLBinding<"u",g=new Qm,m={},_=e.getContextAttributes(),E=null,b=null,A=[],T=[],x=new Yt,S=null,D=null,I=new wi;I.viewport=new vn;let N=new wi;N.viewport=new vn;let H=[I,N],V=new Wh,k=null,O=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let yt=A[st];return yt===void 0&&(yt=new Ha,A[st]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(st){let yt=A[st];return yt===void 0&&(yt=new Ha,A[st]=yt),yt.getGripSpace()},this.getHand=function(st){let yt=A[st];return yt===void 0&&(yt=new Ha,A[st]=yt),yt.getHandSpace()};function L(st){let yt=T.indexOf(st.inputSource);if(yt===-1)return;let _t=A[yt];_t!==void 0&&(_t.update(st.inputSource,st.frame,c||o),_t.dispatchEvent({type:st.type,data:st.inputSource}))}function F(){s.removeEventListener("select",L),s.removeEventListener("selectstart",L),s.removeEventListener("selectend",L),s.removeEventListener("squeeze",L),s.removeEventListener("squeezestart",L),s.removeEventListener("squeezeend",L),s.removeEventListener("end",F),s.removeEventListener("inputsourceschange",j);for(let st=0;st<A.length;st++){let yt=T[st];yt!==null&&(T[st]=null,A[st].disconnect(yt))}k=null,O=null,g.reset();for(let st in m)delete m[st];if(t.setRenderTarget(E),f=null,d=null,h=null,s=null,b=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(x.width,x.height,!1),D!==null){let st=D.camera;st.fov=D.fov,st.zoom=D.zoom,st.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",L),s.addEventListener("selectstart",L),s.addEventListener("selectend",L),s.addEventListener("squeeze",L),s.addEventListener("squeezestart",L),s.addEventListener("squeezeend",L),s.addEventListener("end",F),s.addEventListener("inputsourceschange",j),_.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,At=null,Rt=null;_.depth&&(Rt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=_.stencil?Lr:Ar,At=_.stencil?Oo:Is);let Kt={colorFormat:e.RGBA8,depthFormat:Rt,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Kt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new ts(d.textureWidth,d.textureHeight,{format:Ds,type:is,depthTexture:new Pr(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _t={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ts(f.framebufferWidth,f.framebufferHeight,{format:Ds,type:is,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function j(st){for(let yt=0;yt<st.removed.length;yt++){let _t=st.removed[yt],At=T.indexOf(_t);At>=0&&(T[At]=null,A[At].disconnect(_t))}for(let yt=0;yt<st.added.length;yt++){let _t=st.added[yt],At=T.indexOf(_t);if(At===-1){for(let Kt=0;Kt<A.length;Kt++)if(Kt>=T.length){T.push(_t),At=Kt;break}else if(T[Kt]===null){T[Kt]=_t,At=Kt;break}if(At===-1)break}let Rt=A[At];Rt&&Rt.connect(_t)}}function X(st,yt){yt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(yt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let yt=st.near,_t=st.far;g.texture!==null&&(g.depthNear>0&&(yt=g.depthNear),g.depthFar>0&&(_t=g.depthFar)),V.near=N.near=I.near=yt,V.far=N.far=I.far=_t,(k!==V.near||O!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),k=V.near,O=V.far),V.layers.mask=st.layers.mask|6,I.layers.mask=V.layers.mask&-5,N.layers.mask=V.layers.mask&-3;let At=st.parent,Rt=V.cameras;X(V,At);for(let Kt=0;Kt<Rt.length;Kt++)X(Rt[Kt],At);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),D===null&&st.isPerspectiveCamera&&(D={camera:st,fov:st.fov,zoom:st.zoom}),J(st,V,At)};function J(st,yt,_t){_t===null?st.matrix.copy(yt.matrixWorld):(st.matrix.copy(_t.matrixWorld),st.matrix.invert(),st.matrix.multiply(yt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(yt.projectionMatrix),st.projectionMatrixInverse.copy(yt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Ba*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(st){return m[st]};let et=null;function dt(st,yt){if(u=yt.getViewerPose(c||o),p=yt,u!==null){let _t=u.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let At=!1;_t.length!==V.cameras.length&&(V.cameras.length=0,At=!0);for(let jt=0;jt<_t.length;jt++){let Ee=_t[jt],ve=null;if(f!==null)ve=f.getViewport(Ee);else{let mn=h.getViewSubImage(d,Ee);ve=mn.viewport,jt===0&&(t.setRenderTargetTextures(b,mn.colorTexture,mn.depthStencilTexture),t.setRenderTarget(b))}let fe=H[jt];fe===void 0&&(fe=new wi,fe.layers.enable(jt),fe.viewport=new vn,H[jt]=fe),fe.matrix.fromArray(Ee.transform.matrix),fe.matrix.decompose(fe.position,fe.quaternion,fe.scale),fe.projectionMatrix.fromArray(Ee.projectionMatrix),fe.projectionMatrixInverse.copy(fe.projectionMatrix).invert(),fe.viewport.set(ve.x,ve.y,ve.width,ve.height),jt===0&&(V.matrix.copy(fe.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),At===!0&&V.cameras.push(fe)}let Rt=s.enabledFeatures;if(Rt&&Rt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let jt=h.getDepthInformation(_t[0]);jt&&jt.isValid&&jt.texture&&g.init(jt,s.renderState)}if(Rt&&Rt.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let jt=0;jt<_t.length;jt++){let Ee=_t[jt].camera;if(Ee){let ve=m[Ee];ve||(ve=new bc,m[Ee]=ve);let fe=h.getCameraImage(Ee);ve.sourceTexture=fe}}}}for(let _t=0;_t<A.length;_t++){let At=T[_t],Rt=A[_t];At!==null&&Rt!==void 0&&Rt.update(At,yt,c||o)}et&&et(st,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),p=null}let ft=new Ry;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){et=st},this.dispose=function(){}}},WC=new _e,By=new ue;By.set(-1,0,0,0,1,0,0,0,1);function $C(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Hm(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,E,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),y(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,E):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Pi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Pi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=t.get(m),E=_.envMap,b=_.envMapRotation;E&&(g.envMap.value=E,g.envMapRotation.value.setFromMatrix4(WC.makeRotationFromEuler(b)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(By),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,E){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=E*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Pi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function y(g,m){let _=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function qC(n,t,e,i){let s={},r={};function o(_,E){let b=E.program;i.uniformBlockBinding(_,b,s[_.id])}function a(_,E){let b=s[_.id];b===void 0&&(p(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",g));let A=E.program;i.updateUBOMapping(_,A);let T=t.render.frame;r[_.id]!==T&&(c(_),r[_.id]=T)}function l(_){let E=n.createBuffer(),b=_.__size,A=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,b,A),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(_){let E=s[_.id],b=_.uniforms,A=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let T=0,x=b.length;T<x;T++){let S=b[T];if(Array.isArray(S))for(let D=0,I=S.length;D<I;D++)u(S[D],T,D,A);else u(S,T,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,E,b,A){if(d(_,E,b,A)===!0){let T=_.__offset,x=_.value;if(Array.isArray(x)){let S=0;for(let D=0;D<x.length;D++){let I=x[D],N=y(I,!0);h(I,_.__data,S),S+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,_.__data)}}function h(_,E,b){typeof _=="number"||typeof _=="boolean"?E[b]=_:_.isMatrix3?(E[b]=_.elements[0],E[b+1]=_.elements[1],E[b+2]=_.elements[2],E[b+3]=0,E[b+4]=_.elements[3],E[b+5]=_.elements[4],E[b+6]=_.elements[5],E[b+7]=0,E[b+8]=_.elements[6],E[b+9]=_.elements[7],E[b+10]=_.elements[8],E[b+11]=0):ArrayBuffer.isView(_)?E.set(_.subarray(0,E.length-b),b):_.toArray(E,b)}function d(_,E,b,A){let T=_.value,x=E+"_"+b;if(Array.isArray(T)){A[x]===void 0&&(A[x]=[]);let S=A[x],D=!1;for(let I=0;I<T.length;I++)f(T[I],S,I)===!0&&(D=!0);return D}return f(T,A,x)}function f(_,E,b){if(E[b]===void 0)return typeof _=="number"||typeof _=="boolean"?E[b]=_:ArrayBuffer.isView(_)?E[b]=_.slice():E[b]=_.clone(),!0;{let A=E[b];if(typeof _=="number"||typeof _=="boolean"){if(A!==_)return E[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(A.equals(_)===!1)return A.copy(_),!0}}return!1}function p(_){let E=_.uniforms,b=0,A=16;for(let x=0,S=E.length;x<S;x++){let D=Array.isArray(E[x])?E[x]:[E[x]];for(let I=0,N=D.length;I<N;I++){let H=D[I],V=Array.isArray(H.value)?H.value:[H.value],k=Array.isArray(E[x])||Array.isArray(H.value),O=b;for(let F=0,j=V.length;F<j;F++){let X=V[F],J=y(X,k),et=b%A,dt=et%J.boundary,ft=et+dt;b+=dt,ft!==0&&A-ft<J.storage&&(b+=A-ft),F===0&&(O=b),b+=J.storage}let L=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new L((b-O)/Float32Array.BYTES_PER_ELEMENT),H.__offset=O}}let T=b%A;return T>0&&(b+=A-T),_.__size=b,_.__cache={},this}function y(_,E){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):ie("WebGLRenderer: Unsupported uniform value type.",_),E===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(_){let E=_.target;E.removeEventListener("dispose",g),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var XC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ar=null;function YC(){return ar===null&&(ar=new gc(XC,16,16,oo,Ls),ar.name="DFG_LUT",ar.minFilter=Ei,ar.magFilter=Ei,ar.wrapS=tr,ar.wrapT=tr,ar.generateMipmaps=!1,ar.needsUpdate=!0),ar}var Fd=class{constructor(t={}){let{canvas:e=Kx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=is}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=f,g=new Set([td,Qh,Kh]),m=new Set([is,Is,ja,Oo,Zh,jh]),_=new Uint32Array(4),E=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,T=null,x=[],S=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=or,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,N=!1,H=null,V=null,k=null,O=null;this._outputColorSpace=si;let L=0,F=0,j=null,X=-1,J=null,et=new vn,dt=new vn,ft=null,st=new ne(0),yt=0,_t=e.width,At=e.height,Rt=1,Kt=null,me=null,jt=new vn(0,0,_t,At),Ee=new vn(0,0,_t,At),ve=!1,fe=new Po,mn=new Th,rn=!1,In=!1,Ke=new _e,Zn=new G,Ne=new vn,kn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Mn=!1;function Ln(){return j===null?Rt:1}let $=i;function Ut(P,q){return e.getContext(P,q)}let se,ge,Pt,tn,Zt,ee,U,R,Z,mt,ct,wt,Et,rt,at,vt,W,lt,ot,It,Mt,Ct,Jt;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",$t,!1),e.addEventListener("webglcontextrestored",le,!1),e.addEventListener("webglcontextcreationerror",Nt,!1),$===null){let q="webgl2";if($=Ut(q,P),$===null)throw Ut(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ae()}catch(P){throw e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),oe("WebGLRenderer: "+P.message),P}function ae(){se=new rR($),se.init(),Mt=new HC($,se),ge=new YA($,se,t,Mt),Pt=new kC($,se),ge.reversedDepthBuffer&&d&&Pt.buffers.depth.setReversed(!0),V=$.createFramebuffer(),k=$.createFramebuffer(),O=$.createFramebuffer(),tn=new lR($),Zt=new EC,ee=new zC($,se,Pt,Zt,ge,Mt,tn),U=new sR(I),R=new uE($),Ct=new qA($,R),Z=new oR($,R,tn,Ct),mt=new uR($,Z,R,Ct,tn),lt=new cR($,ge,ee),at=new ZA(Zt),ct=new wC(I,U,se,ge,Ct,at),wt=new $C(I,Zt),Et=new AC,rt=new DC(se),W=new $A(I,U,Pt,mt,p,l),vt=new BC(I,mt,ge),Jt=new qC($,tn,ge,Pt),ot=new XA($,se,tn),It=new aR($,se,tn),tn.programs=ct.programs,I.capabilities=ge,I.extensions=se,I.properties=Zt,I.renderLists=Et,I.shadowMap=vt,I.state=Pt,I.info=tn}y!==is&&(D=new dR(y,e.width,e.height,a,s,r));let pt=new tg(I,$);this.xr=pt,this.getContext=function(){return $},this.getContextAttributes=function(){return $.getContextAttributes()},this.forceContextLoss=function(){let P=se.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=se.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return Rt},this.setPixelRatio=function(P){P!==void 0&&(Rt=P,this.setSize(_t,At,!1))},this.getSize=function(P){return P.set(_t,At)},this.setSize=function(P,q,it=!0){if(pt.isPresenting){ie("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=P,At=q,e.width=Math.floor(P*Rt),e.height=Math.floor(q*Rt),it===!0&&(e.style.width=P+"px",e.style.height=q+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,P,q)},this.getDrawingBufferSize=function(P){return P.set(_t*Rt,At*Rt).floor()},this.setDrawingBufferSize=function(P,q,it){_t=P,At=q,Rt=it,e.width=Math.floor(P*it),e.height=Math.floor(q*it),this.setViewport(0,0,P,q)},this.setEffects=function(P){if(y===is){oe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let q=0;q<P.length;q++)if(P[q].isOutputPass===!0){ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(et)},this.getViewport=function(P){return P.copy(jt)},this.setViewport=function(P,q,it,K){P.isVector4?jt.set(P.x,P.y,P.z,P.w):jt.set(P,q,it,K),Pt.viewport(et.copy(jt).multiplyScalar(Ln()).round())},this.getScissor=function(P){return P.copy(Ee)},this.setScissor=function(P,q,it,K){P.isVector4?Ee.set(P.x,P.y,P.z,P.w):Ee.set(P,q,it,K),Pt.scissor(dt.copy(Ee).multiplyScalar(Ln()).round())},this.getScissorTest=function(){return ve},this.setScissorTest=function(P){Pt.setScissorTest(ve=P)},this.setOpaqueSort=function(P){Kt=P},this.setTransparentSort=function(P){me=P},this.getClearColor=function(P){return P.copy(W.getClearColor())},this.setClearColor=function(){W.setClearColor(...arguments)},this.getClearAlpha=function(){return W.getClearAlpha()},this.setClearAlpha=function(){W.setClearAlpha(...arguments)},this.clear=function(P=!0,q=!0,it=!0){let K=0;if(P){let Q=!1;if(j!==null){let Lt=j.texture.format;Q=g.has(Lt)}if(Q){let Lt=j.texture.type,Ft=m.has(Lt),Dt=W.getClearColor(),Ot=W.getClearAlpha(),Xt=Dt.r,ce=Dt.g,Re=Dt.b;Ft?(_[0]=Xt,_[1]=ce,_[2]=Re,_[3]=Ot,$.clearBufferuiv($.COLOR,0,_)):(E[0]=Xt,E[1]=ce,E[2]=Re,E[3]=Ot,$.clearBufferiv($.COLOR,0,E))}else K|=$.COLOR_BUFFER_BIT}q&&(K|=$.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(K|=$.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&$.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),H=P},this.dispose=function(){e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Nt,!1),W.dispose(),Et.dispose(),rt.dispose(),ee.dispose(),Zt.dispose(),U.dispose(),mt.dispose(),Z.dispose(),Ct.dispose(),Jt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",Tu),pt.removeEventListener("sessionend",Hs),fr.stop()};function $t(P){P.preventDefault(),cc("WebGLRenderer: Context Lost."),N=!0}function le(){cc("WebGLRenderer: Context Restored."),N=!1;let P=tn.autoReset,q=vt.enabled,it=vt.autoUpdate,K=vt.needsUpdate,Q=vt.type;ae(),tn.autoReset=P,vt.enabled=q,vt.autoUpdate=it,vt.needsUpdate=K,vt.type=Q}function Nt(P){oe("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function xe(P){let q=P.target;q.removeEventListener("dispose",xe),on(q)}function on(P){_i(P),Zt.remove(P)}function _i(P){let q=Zt.get(P).programs;q!==void 0&&(q.forEach(function(it){ct.releaseProgram(it)}),P.isShaderMaterial&&ct.releaseShaderCache(P))}this.renderBufferDirect=function(P,q,it,K,Q,Lt){q===null&&(q=kn);let Ft=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Dt=Bl(P,q,it,K,Q);Pt.setMaterial(K,Ft);let Ot=it.index,Xt=1;if(K.wireframe===!0){if(Ot=Z.getWireframeAttribute(it),Ot===void 0)return;Xt=2}let ce=it.drawRange,Re=it.attributes.position,qt=ce.start*Xt,Ce=(ce.start+ce.count)*Xt;Lt!==null&&(qt=Math.max(qt,Lt.start*Xt),Ce=Math.min(Ce,(Lt.start+Lt.count)*Xt)),Ot!==null?(qt=Math.max(qt,0),Ce=Math.min(Ce,Ot.count)):Re!=null&&(qt=Math.max(qt,0),Ce=Math.min(Ce,Re.count));let yn=Ce-qt;if(yn<0||yn===1/0)return;Ct.setup(Q,K,Dt,it,Ot);let Xe,Ye=ot;if(Ot!==null&&(Xe=R.get(Ot),Ye=It,Ye.setIndex(Xe)),Q.isMesh)K.wireframe===!0?(Pt.setLineWidth(K.wireframeLinewidth*Ln()),Ye.setMode($.LINES)):Ye.setMode($.TRIANGLES);else if(Q.isLine){let zn=K.linewidth;zn===void 0&&(zn=1),Pt.setLineWidth(zn*Ln()),Q.isLineSegments?Ye.setMode($.LINES):Q.isLineLoop?Ye.setMode($.LINE_LOOP):Ye.setMode($.LINE_STRIP)}else Q.isPoints?Ye.setMode($.POINTS):Q.isSprite&&Ye.setMode($.TRIANGLES);if(Q.isBatchedMesh)if(se.get("WEBGL_multi_draw"))Ye.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let zn=Q._multiDrawStarts,Gt=Q._multiDrawCounts,Dn=Q._multiDrawCount,Ie=Ot?R.get(Ot).bytesPerElement:1,mr=Zt.get(K).currentProgram.getUniforms();for(let Nn=0;Nn<Dn;Nn++)mr.setValue($,"_gl_DrawID",Nn),Ye.render(zn[Nn]/Ie,Gt[Nn])}else if(Q.isInstancedMesh)Ye.renderInstances(qt,yn,Q.count);else if(it.isInstancedBufferGeometry){let zn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Gt=Math.min(it.instanceCount,zn);Ye.renderInstances(qt,yn,Gt)}else Ye.render(qt,yn)};function Ul(P,q,it,K){H!==null&&P.isNodeMaterial&&H.setObject(K,P),rn===!0&&at.setState(P,it,!1),P.transparent===!0&&P.side===fi&&P.forceSinglePass===!1?(P.side=Pi,P.needsUpdate=!0,Gs(P,q,K),P.side=rr,P.needsUpdate=!0,Gs(P,q,K),P.side=fi):Gs(P,q,K)}this.compile=function(P,q,it=null){it===null&&(it=P),H!==null&&H.renderStart(P,q,it),T=rt.get(it),T.init(q),S.push(T),it.traverseVisible(function(Q){Q.isLight&&Q.layers.test(q.layers)&&(T.pushLight(Q),Q.castShadow&&T.pushShadow(Q))}),P!==it&&P.traverseVisible(function(Q){Q.isLight&&Q.layers.test(q.layers)&&(T.pushLight(Q),Q.castShadow&&T.pushShadow(Q))}),T.setupLights(),H!==null&&H.updateLights(T.state.lightsArray),In=this.localClippingEnabled,rn=at.init(this.clippingPlanes,In),rn===!0&&at.setGlobalState(this.clippingPlanes,q),H!==null&&vt.render(T.state.shadowsArray,it,q);let K=new Set;return P.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Lt=Q.material;if(Lt)if(Array.isArray(Lt))for(let Ft=0;Ft<Lt.length;Ft++){let Dt=Lt[Ft];Ul(Dt,it,q,Q),K.add(Dt)}else Ul(Lt,it,q,Q),K.add(Lt)}),T=S.pop(),H!==null&&H.renderEnd(),K},this.compileAsync=function(P,q,it=null){let K=this.compile(P,q,it);return new Promise(Q=>{function Lt(){if(K.forEach(function(Ft){let Ot=Zt.get(Ft).currentProgram;(Ot===void 0||Ot.isReady())&&K.delete(Ft)}),K.size===0){Q(P);return}setTimeout(Lt,10)}se.get("KHR_parallel_shader_compile")!==null?Lt():setTimeout(Lt,10)})};let ea=null;function _p(P){ea&&ea(P)}function Tu(){fr.stop()}function Hs(){fr.start()}let fr=new Ry;fr.setAnimationLoop(_p),typeof self<"u"&&fr.setContext(self),this.setAnimationLoop=function(P){ea=P,pt.setAnimationLoop(P),P===null?fr.stop():fr.start()},pt.addEventListener("sessionstart",Tu),pt.addEventListener("sessionend",Hs),this.render=function(P,q){if(q!==void 0&&q.isCamera!==!0){oe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;H!==null&&H.renderStart(P,q);let it=pt.enabled===!0&&pt.isPresenting===!0,K=D!==null&&(j===null||it)&&D.begin(I,j);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),P.isScene===!0&&P.onBeforeRender(I,P,q,j),T=rt.get(P,S.length),T.init(q),T.state.textureUnits=ee.getTextureUnits(),S.push(T),Ke.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?mn.setFromArrayCamera(q):fe.setFromProjectionMatrix(Ke,ds,q.reversedDepth),In=this.localClippingEnabled,rn=at.init(this.clippingPlanes,In),A=Et.get(P,x.length),A.init(),x.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ft=I.xr.getDepthSensingMesh();Ft!==null&&pr(Ft,q,-1/0,I.sortObjects)}pr(P,q,0,I.sortObjects),A.finish(),H!==null&&H.updateLights(T.state.lightsArray),I.sortObjects===!0&&A.sort(Kt,me),Mn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Mn&&W.addToRenderList(A,P),this.info.autoReset===!0&&this.info.reset(),rn===!0&&at.beginShadows();let Q=T.state.shadowsArray;if(vt.render(Q,P,q),rn===!0&&at.endShadows(),(K&&D.hasRenderPass())===!1){let Ft=A.opaque,Dt=A.transmissive;if(T.setupLights(),q.isArrayCamera){let Ot=q.cameras;if(Dt.length>0)for(let Xt=0,ce=Ot.length;Xt<ce;Xt++){let Re=Ot[Xt];Ms(Ft,Dt,P,Re)}Mn&&W.render(P);for(let Xt=0,ce=Ot.length;Xt<ce;Xt++){let Re=Ot[Xt];Fl(A,P,Re,Re.viewport)}}else Dt.length>0&&Ms(Ft,Dt,P,q),Mn&&W.render(P),Fl(A,P,q)}j!==null&&F===0&&(ee.updateMultisampleRenderTarget(j),ee.updateRenderTargetMipmap(j)),K&&D.end(I),P.isScene===!0&&P.onAfterRender(I,P,q),Ct.resetDefaultState(),X=-1,J=null,S.pop(),S.length>0?(T=S[S.length-1],ee.setTextureUnits(T.state.textureUnits),rn===!0&&at.setGlobalState(I.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?A=x[x.length-1]:A=null,H!==null&&H.renderEnd()};function pr(P,q,it,K){if(P.visible===!1)return;if(P.layers.test(q.layers)){if(P.isGroup)it=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update(q);else if(P.isLight)T.pushLight(P),P.castShadow&&T.pushShadow(P);else if(P.isSprite){let Ft=q.isArrayCamera?mn:fe;if(!P.frustumCulled||P.intersectsFrustum(Ft)){K&&Ne.setFromMatrixPosition(P.matrixWorld).applyMatrix4(Ke);let Dt=mt.update(P),Ot=P.material;Ot.visible&&A.push(P,Dt,Ot,it,Ne.z,null,q)}}else if(P.isMesh||P.isLine||P.isPoints){let Ft=q.isArrayCamera?mn:fe;if(!P.frustumCulled||P.intersectsFrustum(Ft)){let Dt=mt.update(P),Ot=P.material;if(K&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),Ne.copy(P.boundingSphere.center)):(Dt.boundingSphere===null&&Dt.computeBoundingSphere(),Ne.copy(Dt.boundingSphere.center)),Ne.applyMatrix4(P.matrixWorld).applyMatrix4(Ke)),Array.isArray(Ot)){let Xt=Dt.groups;for(let ce=0,Re=Xt.length;ce<Re;ce++){let qt=Xt[ce],Ce=Ot[qt.materialIndex];Ce&&Ce.visible&&A.push(P,Dt,Ce,it,Ne.z,qt,q)}}else Ot.visible&&A.push(P,Dt,Ot,it,Ne.z,null,q)}}}let Lt=P.children;for(let Ft=0,Dt=Lt.length;Ft<Dt;Ft++)pr(Lt[Ft],q,it,K)}function Fl(P,q,it,K){let{opaque:Q,transmissive:Lt,transparent:Ft}=P;T.setupLightsView(it),rn===!0&&at.setGlobalState(I.clippingPlanes,it),K&&Pt.viewport(et.copy(K)),Q.length>0&&Sn(Q,q,it),Lt.length>0&&Sn(Lt,q,it),Ft.length>0&&Sn(Ft,q,it),Pt.buffers.depth.setTest(!0),Pt.buffers.depth.setMask(!0),Pt.buffers.color.setMask(!0),Pt.setPolygonOffset(!1)}function Ms(P,q,it,K){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[K.id]===void 0){let qt=se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[K.id]=new ts(1,1,{generateMipmaps:!0,type:qt?Ls:is,minFilter:Ir,samples:Math.max(4,ge.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Le.workingColorSpace})}let Lt=T.state.transmissionRenderTarget[K.id],Ft=K.viewport||et;Lt.setSize(Ft.z*I.transmissionResolutionScale,Ft.w*I.transmissionResolutionScale);let Dt=I.getRenderTarget(),Ot=I.getActiveCubeFace(),Xt=I.getActiveMipmapLevel();I.setRenderTarget(Lt),I.getClearColor(st),yt=I.getClearAlpha(),yt<1&&I.setClearColor(16777215,.5),I.clear(),Mn&&W.render(it);let ce=I.toneMapping;I.toneMapping=or;let Re=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),T.setupLightsView(K),rn===!0&&at.setGlobalState(I.clippingPlanes,K),Sn(P,it,K),ee.updateMultisampleRenderTarget(Lt),ee.updateRenderTargetMipmap(Lt),se.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ce=0,yn=q.length;Ce<yn;Ce++){let Xe=q[Ce],{object:Ye,geometry:zn,material:Gt,group:Dn}=Xe;if(Gt.side===fi&&Ye.layers.test(K.layers)){let Ie=Gt.side;Gt.side=Pi,Gt.needsUpdate=!0,Cn(Ye,it,K,zn,Gt,Dn),Gt.side=Ie,Gt.needsUpdate=!0,qt=!0}}qt===!0&&(ee.updateMultisampleRenderTarget(Lt),ee.updateRenderTargetMipmap(Lt))}I.setRenderTarget(Dt,Ot,Xt),I.setClearColor(st,yt),Re!==void 0&&(K.viewport=Re),I.toneMapping=ce}function Sn(P,q,it){let K=q.isScene===!0?q.overrideMaterial:null;for(let Q=0,Lt=P.length;Q<Lt;Q++){let Ft=P[Q],{object:Dt,geometry:Ot,group:Xt}=Ft,ce=Ft.material;ce.allowOverride===!0&&K!==null&&(ce=K),Dt.layers.test(it.layers)&&Cn(Dt,q,it,Ot,ce,Xt)}}function Cn(P,q,it,K,Q,Lt){H!==null&&Q.isNodeMaterial&&H.setObject(P,Q),P.onBeforeRender(I,q,it,K,Q,Lt),P.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),Q.onBeforeRender(I,q,it,K,P,Lt),Q.transparent===!0&&Q.side===fi&&Q.forceSinglePass===!1?(Q.side=Pi,Q.needsUpdate=!0,I.renderBufferDirect(it,q,K,Q,P,Lt),Q.side=rr,Q.needsUpdate=!0,I.renderBufferDirect(it,q,K,Q,P,Lt),Q.side=fi):I.renderBufferDirect(it,q,K,Q,P,Lt),P.onAfterRender(I,q,it,K,Q,Lt)}function Pn(P){let q=0;for(let it of P)it.texture!==null&&q++;return q}function Gs(P,q,it){q.isScene!==!0&&(q=kn);let K=Zt.get(P),Q=T.state.lights,Lt=T.state.shadowsArray,Ft=Q.state.version,Dt=ct.getParameters(P,Q.state,Lt,q,it,T.state.lightProbeGridArray),Ot=ct.getProgramCacheKey(Dt),Xt=K.programs;K.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?q.environment:null,K.fog=q.fog;let ce=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;K.envMap=U.get(P.envMap||K.environment,ce),K.envMapRotation=K.environment!==null&&P.envMap===null?q.environmentRotation:P.envMapRotation,Xt===void 0&&(P.addEventListener("dispose",xe),Xt=new Map,K.programs=Xt,K.programVariants=new Map);let Re=Xt.get(Ot);if(Re!==void 0){if(K.currentProgram===Re&&K.lightsStateVersion===Ft)return Ol(P,Dt),Re}else Dt.uniforms=ct.getUniforms(P),H!==null&&P.isNodeMaterial&&H.build(P,it,Dt),P.onBeforeCompile(Dt,I),Re=ct.acquireProgram(Dt,Ot),Xt.set(Ot,Re),K.uniforms=Dt.uniforms;let qt=K.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(qt.clippingPlanes=at.uniform),Ol(P,Dt),K.needsLights=Gr(P),K.lightsStateVersion=Ft,K.needsLights&&(qt.ambientLightColor.value=Q.state.ambient,qt.lightProbe.value=Q.state.probe,qt.sunLights.value=Q.state.sun,qt.sunLightShadows.value=Q.state.sunShadow,qt.directionalLights.value=Q.state.directional,qt.directionalLightShadows.value=Q.state.directionalShadow,qt.spotLights.value=Q.state.spot,qt.spotLightShadows.value=Q.state.spotShadow,qt.rectAreaLights.value=Q.state.rectArea,qt.ltc_1.value=Q.state.rectAreaLTC1,qt.ltc_2.value=Q.state.rectAreaLTC2,qt.pointLights.value=Q.state.point,qt.pointLightShadows.value=Q.state.pointShadow,qt.hemisphereLights.value=Q.state.hemi,qt.sunShadowMatrix.value=Q.state.sunShadowMatrix,qt.sunShadowCascade.value=Q.state.sunShadowCascade,qt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,qt.spotLightMatrix.value=Q.state.spotLightMatrix,qt.spotLightMap.value=Q.state.spotLightMap,qt.pointShadowMatrix.value=Q.state.pointShadowMatrix),K.numLightProbeGrids=Pn(T.state.lightProbeGridArray),K.currentProgram=Re,K.uniformsList=null,Re}function qi(P,q,it,K,Q){let Lt=Zt.get(P),Ft=Lt.currentProgram.id+","+K+","+Q,Dt=Lt.programVariants.get(Ft);return Dt===void 0?(Dt=Gs(P,q,it),Lt.programVariants.set(Ft,Dt)):(Lt.currentProgram=Dt,Lt.uniformsList=null,Lt.outputColorSpace=K,Lt.toneMapping=Q),Dt}function Hr(P){if(P.uniformsList===null){let q=P.currentProgram.getUniforms();P.uniformsList=Ja.seqWithValue(q.seq,P.uniforms)}return P.uniformsList}function Ol(P,q){let it=Zt.get(P);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function Bl(P,q,it,K,Q){q.isScene!==!0&&(q=kn),ee.resetTextureUnits();let Lt=q.fog,Ft=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?q.environment:null,Dt=j===null?I.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:Le.workingColorSpace,Ot=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Xt=U.get(K.envMap||Ft,Ot),ce=K.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Re=!!it.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),qt=!!it.morphAttributes.position,Ce=!!it.morphAttributes.normal,yn=!!it.morphAttributes.color,Xe=or;K.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(Xe=I.toneMapping);let Ye=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,zn=Ye!==void 0?Ye.length:0,Gt=Zt.get(K),Dn=T.state.lights;if(rn===!0&&(In===!0||P!==J)){let Ze=P===J&&K.id===X;at.setState(K,P,Ze)}let Ie=!1,mr=!1;K.version===Gt.__version?Gt.needsLights&&Gt.lightsStateVersion!==Dn.state.version||Q.isBatchedMesh&&Gt.batching===!1||!Q.isBatchedMesh&&Gt.batching===!0||Q.isBatchedMesh&&Gt.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Gt.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Gt.instancing===!1||!Q.isInstancedMesh&&Gt.instancing===!0||Q.isSkinnedMesh&&Gt.skinning===!1||!Q.isSkinnedMesh&&Gt.skinning===!0||Q.isInstancedMesh&&Gt.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Gt.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Gt.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Gt.instancingMorph===!1&&Q.morphTexture!==null||Gt.envMap!==Xt||K.fog===!0&&Gt.fog!==Lt||Gt.numClippingPlanes!==void 0&&(Gt.numClippingPlanes!==at.numPlanes||Gt.numIntersection!==at.numIntersection)||Gt.vertexAlphas!==ce||Gt.vertexTangents!==Re||Gt.morphTargets!==qt||Gt.morphNormals!==Ce||Gt.morphColors!==yn||Gt.morphTargetsCount!==zn||Gt.numLightProbeGrids!==Pn(T.state.lightProbeGridArray)?Ie=!0:(Gt.outputColorSpace!==Dt||Gt.toneMapping!==Xe)&&(mr=!0):(Ie=!0,Gt.__version=K.version);let Nn=Gt.currentProgram;(Ie===!0||mr===!0)&&(Nn=mr===!0?qi(K,q,Q,Dt,Xe):Gs(K,q,Q),H&&K.isNodeMaterial&&H.onUpdateProgram(K,Nn,Gt));let sa=!1,Vs=!1,gr=!1,be=Nn.getUniforms(),wn=Gt.uniforms;if(Pt.useProgram(Nn.program)&&(sa=!0,Vs=!0,gr=!0),K.id!==X&&(X=K.id,Vs=!0),sa||J!==P){Pt.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),be.setValue($,"projectionMatrix",P.projectionMatrix),be.setValue($,"viewMatrix",P.matrixWorldInverse);let Un=be.map.cameraPosition;Un!==void 0&&Un.setValue($,Zn.setFromMatrixPosition(P.matrixWorld)),ge.logarithmicDepthBuffer&&be.setValue($,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&be.setValue($,"isOrthographic",P.isOrthographicCamera===!0),J!==P&&(J=P,Vs=!0,gr=!0)}if(Gt.needsLights&&(Dn.state.sunShadowMap.length>0&&be.setValue($,"sunShadowMap",Dn.state.sunShadowMap,ee),Dn.state.directionalShadowMap.length>0&&be.setValue($,"directionalShadowMap",Dn.state.directionalShadowMap,ee),Dn.state.spotShadowMap.length>0&&be.setValue($,"spotShadowMap",Dn.state.spotShadowMap,ee),Dn.state.pointShadowMap.length>0&&be.setValue($,"pointShadowMap",Dn.state.pointShadowMap,ee)),Q.isSkinnedMesh){be.setOptional($,Q,"bindMatrix"),be.setOptional($,Q,"bindMatrixInverse");let Ze=Q.skeleton;Ze&&(Ze.boneTexture===null&&Ze.computeBoneTexture(),be.setValue($,"boneTexture",Ze.boneTexture,ee))}Q.isBatchedMesh&&(be.setOptional($,Q,"batchingTexture"),be.setValue($,"batchingTexture",Q._matricesTexture,ee),be.setOptional($,Q,"batchingIdTexture"),be.setValue($,"batchingIdTexture",Q._indirectTexture,ee),be.setOptional($,Q,"batchingColorTexture"),Q._colorsTexture!==null&&be.setValue($,"batchingColorTexture",Q._colorsTexture,ee));let xi=it.morphAttributes;if((xi.position!==void 0||xi.normal!==void 0||xi.color!==void 0)&&lt.update(Q,it,Nn),(Vs||Gt.receiveShadow!==Q.receiveShadow)&&(Gt.receiveShadow=Q.receiveShadow,be.setValue($,"receiveShadow",Q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&q.environment!==null&&(wn.envMapIntensity.value=q.environmentIntensity),wn.dfgLUT!==void 0&&(wn.dfgLUT.value=YC()),Vs){if(be.setValue($,"toneMappingExposure",I.toneMappingExposure),Gt.needsLights&&na(wn,gr),Lt&&K.fog===!0&&wt.refreshFogUniforms(wn,Lt),wt.refreshMaterialUniforms(wn,K,Rt,At,T.state.transmissionRenderTarget[P.id]),Gt.needsLights&&Gt.numLightProbeGrids>0){let Ze=b,Un=0;for(let li of T.state.lightProbeGridArray)li.texture!==null&&(Ze.textures[Un]=li.texture,Ze.min[Un]=li.boundingBox.min,Ze.max[Un]=li.boundingBox.max,Ze.resolution[Un]=li.resolution,Un++);for(let li in Ze)Ze[li].length=Un;wn.probesSH.value=Ze.textures,wn.probesMin.value=Ze.min,wn.probesMax.value=Ze.max,wn.probesResolution.value=Ze.resolution}Ja.upload($,Hr(Gt),wn,ee)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Ja.upload($,Hr(Gt),wn,ee),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&be.setValue($,"center",Q.center),be.setValue($,"modelViewMatrix",Q.modelViewMatrix),be.setValue($,"normalMatrix",Q.normalMatrix),be.setValue($,"modelMatrix",Q.matrixWorld),K.uniformsGroups!==void 0){let Ze=K.uniformsGroups;for(let Un=0,li=Ze.length;Un<li;Un++){let Au=Ze[Un];Jt.update(Au,Nn),Jt.bind(Au,Nn)}}return Nn}function na(P,q){P.ambientLightColor.needsUpdate=q,P.lightProbe.needsUpdate=q,P.sunLights.needsUpdate=q,P.sunLightShadows.needsUpdate=q,P.directionalLights.needsUpdate=q,P.directionalLightShadows.needsUpdate=q,P.pointLights.needsUpdate=q,P.pointLightShadows.needsUpdate=q,P.spotLights.needsUpdate=q,P.spotLightShadows.needsUpdate=q,P.rectAreaLights.needsUpdate=q,P.hemisphereLights.needsUpdate=q}function Gr(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return F},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(P,q,it){let K=Zt.get(P);K.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Zt.get(P.texture).__webglTexture=q,Zt.get(P.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:it,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,q){let it=Zt.get(P);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(P,q=0,it=0){j=P,L=q,F=it;let K=null,Q=!1,Lt=!1;if(P){let Dt=Zt.get(P);if(Dt.__useDefaultFramebuffer!==void 0){Pt.bindFramebuffer($.FRAMEBUFFER,Dt.__webglFramebuffer),et.copy(P.viewport),dt.copy(P.scissor),ft=P.scissorTest,Pt.viewport(et),Pt.scissor(dt),Pt.setScissorTest(ft),X=-1;return}else if(Dt.__webglFramebuffer===void 0)ee.setupRenderTarget(P);else if(Dt.__hasExternalTextures)ee.rebindTextures(P,Zt.get(P.texture).__webglTexture,Zt.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let ce=P.depthTexture;if(Dt.__boundDepthTexture!==ce){if(ce!==null&&Zt.has(ce)&&(P.width!==ce.image.width||P.height!==ce.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ee.setupDepthRenderbuffer(P)}}let Ot=P.texture;(Ot.isData3DTexture||Ot.isDataArrayTexture||Ot.isCompressedArrayTexture)&&(Lt=!0);let Xt=Zt.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray(Xt[q])?K=Xt[q][it]:K=Xt[q],Q=!0):P.samples>0&&ee.useMultisampledRTT(P)===!1?K=Zt.get(P).__webglMultisampledFramebuffer:Array.isArray(Xt)?K=Xt[it]:K=Xt,et.copy(P.viewport),dt.copy(P.scissor),ft=P.scissorTest}else et.copy(jt).multiplyScalar(Rt).floor(),dt.copy(Ee).multiplyScalar(Rt).floor(),ft=ve;if(it!==0&&(K=V),Pt.bindFramebuffer($.FRAMEBUFFER,K)&&Pt.drawBuffers(P,K),Pt.viewport(et),Pt.scissor(dt),Pt.setScissorTest(ft),Q){let Dt=Zt.get(P.texture);$.framebufferTexture2D($.FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_CUBE_MAP_POSITIVE_X+q,Dt.__webglTexture,it)}else if(Lt){let Dt=q;for(let Ot=0;Ot<P.textures.length;Ot++){let Xt=Zt.get(P.textures[Ot]);$.framebufferTextureLayer($.FRAMEBUFFER,$.COLOR_ATTACHMENT0+Ot,Xt.__webglTexture,it,Dt)}}else if(P!==null&&it!==0){let Dt=Zt.get(P.texture);$.framebufferTexture2D($.FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,Dt.__webglTexture,it)}X=-1};function ia(P){let q=Zt.get(P);return(q.__readFormat!==P.format||q.__readType!==P.type)&&(q.__readFormat=P.format,q.__readType=P.type,q.__formatReadable=ge.textureFormatReadable(P.format),q.__typeReadable=ge.textureTypeReadable(P.type)),q}this.readRenderTargetPixels=function(P,q,it,K,Q,Lt,Ft,Dt=0){if(!(P&&P.isWebGLRenderTarget)){oe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ot=Zt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ft!==void 0&&(Ot=Ot[Ft],Array.isArray(Ot)&&(Ot=Ot[0])),Ot){Pt.bindFramebuffer($.FRAMEBUFFER,Ot);try{let Xt=P.textures[Dt],ce=Xt.format,Re=Xt.type;P.textures.length>1&&$.readBuffer($.COLOR_ATTACHMENT0+Dt);let qt=ia(Xt);if(qt.__formatReadable===!1){oe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){oe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=P.width-K&&it>=0&&it<=P.height-Q&&$.readPixels(q,it,K,Q,Mt.convert(ce),Mt.convert(Re),Lt)}finally{let Xt=j!==null?Zt.get(j).__webglFramebuffer:null;Pt.bindFramebuffer($.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(P,q,it,K,Q,Lt,Ft,Dt=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ot=Zt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ft!==void 0&&(Ot=Ot[Ft],Array.isArray(Ot)&&(Ot=Ot[0])),Ot)if(q>=0&&q<=P.width-K&&it>=0&&it<=P.height-Q){Pt.bindFramebuffer($.FRAMEBUFFER,Ot);let Xt=P.textures[Dt],ce=Xt.format,Re=Xt.type;P.textures.length>1&&$.readBuffer($.COLOR_ATTACHMENT0+Dt);let qt=ia(Xt);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ce=$.createBuffer();$.bindBuffer($.PIXEL_PACK_BUFFER,Ce),$.bufferData($.PIXEL_PACK_BUFFER,Lt.byteLength,$.STREAM_READ),$.readPixels(q,it,K,Q,Mt.convert(ce),Mt.convert(Re),0),$.bindBuffer($.PIXEL_PACK_BUFFER,null);let yn=j!==null?Zt.get(j).__webglFramebuffer:null;Pt.bindFramebuffer($.FRAMEBUFFER,yn);let Xe=$.fenceSync($.SYNC_GPU_COMMANDS_COMPLETE,0);return $.flush(),await ty($,Xe,4),$.bindBuffer($.PIXEL_PACK_BUFFER,Ce),$.getBufferSubData($.PIXEL_PACK_BUFFER,0,Lt),$.bindBuffer($.PIXEL_PACK_BUFFER,null),$.deleteBuffer(Ce),$.deleteSync(Xe),Lt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,q=null,it=0){let K=Math.pow(2,-it),Q=Math.floor(P.image.width*K),Lt=Math.floor(P.image.height*K),Ft=q!==null?q.x:0,Dt=q!==null?q.y:0;ee.setTexture2D(P,0),$.copyTexSubImage2D($.TEXTURE_2D,it,0,0,Ft,Dt,Q,Lt),Pt.unbindTexture()},this.copyTextureToTexture=function(P,q,it=null,K=null,Q=0,Lt=0){let Ft,Dt,Ot,Xt,ce,Re,qt,Ce,yn,Xe=P.isCompressedTexture?P.mipmaps[Lt]:P.image;if(it!==null)Ft=it.max.x-it.min.x,Dt=it.max.y-it.min.y,Ot=it.isBox3?it.max.z-it.min.z:1,Xt=it.min.x,ce=it.min.y,Re=it.isBox3?it.min.z:0;else{let be=Math.pow(2,-Q);Ft=Math.floor(Xe.width*be),Dt=Math.floor(Xe.height*be),P.isDataArrayTexture?Ot=Xe.depth:P.isData3DTexture?Ot=Math.floor(Xe.depth*be):Ot=1,Xt=0,ce=0,Re=0}K!==null?(qt=K.x,Ce=K.y,yn=K.z):(qt=0,Ce=0,yn=0);let Ye=Mt.convert(q.format),zn=Mt.convert(q.type),Gt;q.isData3DTexture?(ee.setTexture3D(q,0),Gt=$.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(ee.setTexture2DArray(q,0),Gt=$.TEXTURE_2D_ARRAY):(ee.setTexture2D(q,0),Gt=$.TEXTURE_2D),Pt.activeTexture($.TEXTURE0),Pt.pixelStorei($.UNPACK_FLIP_Y_WEBGL,q.flipY),Pt.pixelStorei($.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Pt.pixelStorei($.UNPACK_ALIGNMENT,q.unpackAlignment);let Dn=Pt.getParameter($.UNPACK_ROW_LENGTH),Ie=Pt.getParameter($.UNPACK_IMAGE_HEIGHT),mr=Pt.getParameter($.UNPACK_SKIP_PIXELS),Nn=Pt.getParameter($.UNPACK_SKIP_ROWS),sa=Pt.getParameter($.UNPACK_SKIP_IMAGES);Pt.pixelStorei($.UNPACK_ROW_LENGTH,Xe.width),Pt.pixelStorei($.UNPACK_IMAGE_HEIGHT,Xe.height),Pt.pixelStorei($.UNPACK_SKIP_PIXELS,Xt),Pt.pixelStorei($.UNPACK_SKIP_ROWS,ce),Pt.pixelStorei($.UNPACK_SKIP_IMAGES,Re);let Vs=P.isDataArrayTexture||P.isData3DTexture,gr=q.isDataArrayTexture||q.isData3DTexture;if(P.isDepthTexture){let be=Zt.get(P),wn=Zt.get(q),xi=Zt.get(be.__renderTarget),Ze=Zt.get(wn.__renderTarget);Pt.bindFramebuffer($.READ_FRAMEBUFFER,xi.__webglFramebuffer),Pt.bindFramebuffer($.DRAW_FRAMEBUFFER,Ze.__webglFramebuffer);for(let Un=0;Un<Ot;Un++)Vs&&($.framebufferTextureLayer($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Zt.get(P).__webglTexture,Q,Re+Un),$.framebufferTextureLayer($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Zt.get(q).__webglTexture,Lt,yn+Un)),$.blitFramebuffer(Xt,ce,Xt+Ft,ce+Dt,qt,Ce,qt+Ft,Ce+Dt,$.DEPTH_BUFFER_BIT,$.NEAREST);Pt.bindFramebuffer($.READ_FRAMEBUFFER,null),Pt.bindFramebuffer($.DRAW_FRAMEBUFFER,null)}else if(Q!==0||P.isRenderTargetTexture||Zt.has(P)){let be=Zt.get(P),wn=Zt.get(q);Pt.bindFramebuffer($.READ_FRAMEBUFFER,k),Pt.bindFramebuffer($.DRAW_FRAMEBUFFER,O);for(let xi=0;xi<Ot;xi++)Vs?$.framebufferTextureLayer($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,be.__webglTexture,Q,Re+xi):$.framebufferTexture2D($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,be.__webglTexture,Q),gr?$.framebufferTextureLayer($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,wn.__webglTexture,Lt,yn+xi):$.framebufferTexture2D($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,wn.__webglTexture,Lt),Q!==0?$.blitFramebuffer(Xt,ce,Xt+Ft,ce+Dt,qt,Ce,qt+Ft,Ce+Dt,$.COLOR_BUFFER_BIT,$.NEAREST):gr?$.copyTexSubImage3D(Gt,Lt,qt,Ce,yn+xi,Xt,ce,Ft,Dt):$.copyTexSubImage2D(Gt,Lt,qt,Ce,Xt,ce,Ft,Dt);Pt.bindFramebuffer($.READ_FRAMEBUFFER,null),Pt.bindFramebuffer($.DRAW_FRAMEBUFFER,null)}else gr?P.isDataTexture||P.isData3DTexture?$.texSubImage3D(Gt,Lt,qt,Ce,yn,Ft,Dt,Ot,Ye,zn,Xe.data):q.isCompressedArrayTexture?$.compressedTexSubImage3D(Gt,Lt,qt,Ce,yn,Ft,Dt,Ot,Ye,Xe.data):$.texSubImage3D(Gt,Lt,qt,Ce,yn,Ft,Dt,Ot,Ye,zn,Xe):P.isDataTexture?$.texSubImage2D($.TEXTURE_2D,Lt,qt,Ce,Ft,Dt,Ye,zn,Xe.data):P.isCompressedTexture?$.compressedTexSubImage2D($.TEXTURE_2D,Lt,qt,Ce,Xe.width,Xe.height,Ye,Xe.data):$.texSubImage2D($.TEXTURE_2D,Lt,qt,Ce,Ft,Dt,Ye,zn,Xe);Pt.pixelStorei($.UNPACK_ROW_LENGTH,Dn),Pt.pixelStorei($.UNPACK_IMAGE_HEIGHT,Ie),Pt.pixelStorei($.UNPACK_SKIP_PIXELS,mr),Pt.pixelStorei($.UNPACK_SKIP_ROWS,Nn),Pt.pixelStorei($.UNPACK_SKIP_IMAGES,sa),Lt===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&$.generateMipmap(Gt),Pt.unbindTexture()},this.initRenderTarget=function(P){Zt.get(P).__webglFramebuffer===void 0&&ee.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?ee.setTextureCube(P,0):P.isData3DTexture?ee.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?ee.setTexture2DArray(P,0):ee.setTexture2D(P,0),Pt.unbindTexture()},this.resetState=function(){L=0,F=0,j=null,Pt.reset(),Ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ds}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Le._getDrawingBufferColorSpace(t),e.unpackColorSpace=Le._getUnpackColorSpace()}};var kd={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var kt={},jC=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],ky=matchMedia("(prefers-color-scheme: dark)");function zd(){let n=v.theme==="dark"||v.theme==="auto"&&ky.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of jC)kt[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();kt.dark=n,kt.curves=kd[n?"dark":"light"].curves}function Hd(n){v.theme=n,zd(),ht("theme")}ky.addEventListener("change",()=>{v.theme==="auto"&&(zd(),ht("theme"))});var zy={type:"change"},ng={type:"start"},Gy={type:"end"},Gd=new Rr,Hy=new ri,JC=Math.cos(70*lo.DEG2RAD),Wn=new G,zi=2*Math.PI,ze={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},eg=1e-6,Vd=class extends Cc{constructor(t,e=null){super(t,e),this.state=ze.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:so.ROTATE,MIDDLE:so.DOLLY,RIGHT:so.PAN},this.touches={ONE:ro.ROTATE,TWO:ro.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new hn,this._lastTargetPosition=new G,this._quat=new hn().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new qa,this._sphericalDelta=new qa,this._scale=1,this._panOffset=new G,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new G,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=QC.bind(this),this._onPointerDown=KC.bind(this),this._onPointerUp=tP.bind(this),this._onContextMenu=aP.bind(this),this._onMouseWheel=iP.bind(this),this._onKeyDown=sP.bind(this),this._onTouchStart=rP.bind(this),this._onTouchMove=oP.bind(this),this._onMouseDown=eP.bind(this),this._onMouseMove=nP.bind(this),this._interceptControlDown=lP.bind(this),this._interceptControlUp=cP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ze.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(zy),this.update(),this.state=ze.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Wn.copy(e).sub(this.target),Wn.applyQuaternion(this._quat),this._spherical.setFromVector3(Wn),this.autoRotate&&this.state===ze.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=zi:i>Math.PI&&(i-=zi),s<-Math.PI?s+=zi:s>Math.PI&&(s-=zi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Wn.setFromSpherical(this._spherical),Wn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Gd.origin.copy(this.object.position),Gd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Gd.direction))<JC?this.object.lookAt(this.target):(Hy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Gd.intersectPlane(Hy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>eg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>eg||this._lastTargetPosition.distanceToSquared(this.target)>eg?(this.dispatchEvent(zy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?zi/60*this.autoRotateSpeed*t:zi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Wn.setFromMatrixColumn(e,0),Wn.multiplyScalar(-t),this._panOffset.add(Wn)}_panUp(t,e){this.screenSpacePanning===!0?Wn.setFromMatrixColumn(e,1):(Wn.setFromMatrixColumn(e,0),Wn.crossVectors(this.object.up,Wn)),Wn.multiplyScalar(t),this._panOffset.add(Wn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Wn.copy(s).sub(this.target);let r=Wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(zi*this._rotateDelta.x/e.clientHeight),this._rotateUp(zi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(zi*this._rotateDelta.x/e.clientHeight),this._rotateUp(zi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function KC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function QC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function tP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Gy),this.state=ze.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function eP(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case so.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=ze.DOLLY;break;case so.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ze.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ze.ROTATE}break;case so.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ze.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ze.PAN}break;default:this.state=ze.NONE}this.state!==ze.NONE&&this.dispatchEvent(ng)}function nP(n){switch(this.state){case ze.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case ze.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case ze.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function iP(n){this.enabled===!1||this.enableZoom===!1||this.state!==ze.NONE||(n.preventDefault(),this.dispatchEvent(ng),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Gy))}function sP(n){this.enabled!==!1&&this._handleKeyDown(n)}function rP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ro.ROTATE:if(this.enableRotate===!1){this.state=ze.NONE;break}this._handleTouchStartRotate(n),this.state=ze.TOUCH_ROTATE;break;case ro.PAN:if(this.enablePan===!1){this.state=ze.NONE;break}this._handleTouchStartPan(n),this.state=ze.TOUCH_PAN;break;default:this.state=ze.NONE}break;case 2:switch(this.touches.TWO){case ro.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=ze.TOUCH_DOLLY_PAN;break;case ro.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=ze.TOUCH_DOLLY_ROTATE;break;default:this.state=ze.NONE}break;default:this.state=ze.NONE}this.state!==ze.NONE&&this.dispatchEvent(ng)}function oP(n){switch(this._trackPointer(n),this.state){case ze.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case ze.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case ze.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case ze.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=ze.NONE}}function aP(n){this.enabled!==!1&&n.preventDefault()}function lP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function cP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Vy=[1,.75,.55,.42],uP=30,hP=17,dP=400,Wy=6e6;function $y(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Wd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(Wy/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>uP&&this.level<Vy.length-1?this.level+=1:i<hP&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*Vy[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(Wy/this.area),.5))),this.draw()},dP)}};var Yy=32,Zy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},dn=new dc,He=new wi(Yy,1,.01,100);He.up.set(0,0,1);var ss,Rn,ms,$d,ig=!1,jy=!1,rg=0;function ye(){ig||!jy||(ig=!0,requestAnimationFrame(Jy))}function Jy(n=performance.now()){ig=!1,$d.moving(n),og()}var Ky=[],Qy=n=>Ky.push(n);function og(){for(let n of Ky)n();ss.render(dn,He),rg+=1}function tv(){jy=!0,ye()}function Qa(n){return og(),n(ss.domElement)}var ev=()=>rg,nv=()=>!!$d?.software;dn.fog=new hc("#fff",1,10);function qy(n){let t=document.createElement("canvas");t.width=ms.clientWidth||1,t.height=ms.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>fP.has(s)?i(s):null,e}var fP=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function iv(n){ms=n;let t=qy(!1),e=$y(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=qy(!0)),ss=new Fd({canvas:t.canvas,context:t}),ss.debug.checkShaderErrors=!1,$d=new Wd(e,ss,og,i=>ht("hurry",i)),ss.domElement.setAttribute("aria-hidden","true"),ms.append(ss.domElement),Rn=new Vd(He,ss.domElement),Rn.enableDamping=!1,Rn.addEventListener("change",ye),Rn.addEventListener("end",()=>{Gc=!rv(),ko=null}),new ResizeObserver(pP).observe(ms),ms.tabIndex=0,ms.setAttribute("role","application"),ms.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ms.addEventListener("keydown",mP)}function pP(){let n=ms.clientWidth,t=ms.clientHeight;!n||!t||($d.resized(n,t),ss.setSize(n,t),He.aspect=n/t,He.updateProjectionMatrix(),rg?Jy():ye(),tl())}function mP(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)gP(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")Xy(1/1.15);else if(n.key==="-")Xy(1.15);else if(n.key.toLowerCase()==="f")Xd(zo);else if(e)ag(e);else return;n.preventDefault()}function gP(n,t){let e=He.position.clone().sub(Rn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);He.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(Rn.target),Rn.update(),ye()}function Xy(n){He.position.sub(Rn.target).multiplyScalar(n).add(Rn.target),Rn.update(),ye()}var zo=[[0,0,0],[0,0,1]];function sv(n,t){let e=new Bi().setFromPoints(n.map(u=>new G(...u))),i=e.getCenter(new G),s=new G(...t).normalize(),r=new G().crossVectors(He.up,s).normalize(),o=new G().crossVectors(s,r),a=Math.tan(lo.degToRad(Yy/2))*.8,l=a*He.aspect,c=e.getSize(new G).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,y=-1/0;for(let g of n){let m=new G(...g).sub(i),_=m.dot(r),E=m.dot(o),b=m.dot(s);h=Math.max(h,b+Math.abs(_)/l,b+Math.abs(E)/a),d=Math.min(d,E),f=Math.max(f,E),p=Math.min(p,_),y=Math.max(y,_)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+y)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var sg=0;function qd({target:n,position:t},e=.35){let i={t:Rn.target.clone(),p:He.position.clone()},s=performance.now(),r=++sg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==sg)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);Rn.target.lerpVectors(i.t,n,u),He.position.lerpVectors(i.p,t,u);let h=He.position.distanceTo(Rn.target);He.near=h/100,He.far=h*30,dn.fog.near=h*1.3,dn.fog.far=h*3.4,He.updateProjectionMatrix(),Rn.update(),ye(),c<1&&requestAnimationFrame(a)})(s)}function Xd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){zo=n,i||(ko=null),Gc=!1;let s=e?Zy[e]:He.position.clone().sub(Rn.target).toArray();qd(sv(n,s),t?0:.35)}function ag(n){Gc=!1,ko=null,qd(sv(zo,Zy[n]))}var Gc=!1;function rv(){He.updateMatrixWorld();let n=new G;return zo.every(t=>(n.set(...t).project(He),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function tl(){Gc||!Rn.enabled||!zo.length||rv()||(ko??={position:He.position.clone(),target:Rn.target.clone()},Xd(zo,{byItself:!0}))}var ko=null;function ov(){if(!ko||Gc||!Rn.enabled)return;let n=ko;ko=null,qd(n),setTimeout(tl,500)}var lg=n=>{zo=n},el=()=>[...He.position.toArray(),...Rn.target.toArray()].map(n=>Number(n.toPrecision(5)));function av(n){sg+=1,qd({position:new G(...n.slice(0,3)),target:new G(...n.slice(3))},0)}var cr=null,cg={cell:.1};function ug(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;cg.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ne(kt.gridFine),l=new ne(kt.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}cr?.geometry.dispose();let c=new Se;c.setAttribute("position",new Ae(r,3)),c.setAttribute("color",new Ae(o,3)),cr?cr.geometry=c:(cr=new Io(c,new es({vertexColors:!0})),cr.renderOrder=-2,cr.material.depthWrite=!1,dn.add(cr)),cr.userData.reach=n,ye()}function hg(){dn.background=new ne(kt.ground),dn.fog.color.set(kt.ground),cr&&ug(cr.userData.reach),ye()}function Hi(n){He.updateMatrixWorld();let t=new G(...n).project(He),e=ms.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Yd(n){let t=n.joints.length,e=ci(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function dg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=Ap(n,t),u=(d,f,p,y=!0,g=p)=>{us(Ui(f,d))<=l||(s.rods.push({a:d,b:f,r:p,far:g}),y&&s.balls.push({at:f,r:g}))};a&&(s.pedestal={at:te(t[0]),dir:Ys(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:p},y)=>{let g=r[y],m=n.joints[y],_=te(t[y]),E=te(t[y+1]),b=g*.62,A=g*.84,T=(r[y+1]??e.rest)*.62,x=(r[y-1]??g)*.84;if(n.convention==="standard"){let O=Wl(_,f,Vl(Ui(E,_),f));u(_,O,b),u(O,E,A,!0,T)}else u(_,d,x,!0,b),u(d,E,b);let S=d,D=Vl(Ui(E,d),f);h&&us(Ui(d,h.at))<.5*g&&Math.abs(D)>l?S=Wl(d,f,Math.sign(D)*Math.min(Math.abs(D)*.55,h.r+g*1.15)):y===0&&Math.abs(D)>2.2*g&&(S=Wl(d,f,Math.sign(D)*g*1.25));let I=g*2.15,N=Ys(t[y+1],0),H=!!(i&&fg(m,i[y])),V=Ys(t[0],2),k=Vl(Ui(S,te(t[0])),V)-I/2;y===0&&m.type==="R"&&Math.abs(Vl(f,V))>.99&&k<0&&k>-I&&(S=Wl(S,V,-k)),m.type==="R"?s.drums.push({at:S,dir:f,x:p,turned:N,r:g,h:I,beyond:H,joint:y}):s.sleeves.push({at:S,dir:f,x:p,r:g*.95,h:g*3.4,beyond:H,joint:y}),h={at:d,r:g}}),a){let d=t[a+1],f=te(t[a]);s.flange={at:f,dir:Ys(t[a],2),turned:Ys(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,te(d),e.rest*.34,!1),s.tip={at:te(d),r:e.rest*.42}}return s}function fg(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function Vc(n,t){let e=Yd(n).radius[0]??.05,i=te(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(te)];for(let{point:r}of Ap(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function xP(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new Sc(s.map(([a,l])=>new Yt(a,l)),n):new Ri(1,1,1,n),o={rod:i(new Ri(1,1,1,n,1,!0)),ball:t>3?new Ps(1,n,t):new wc(1,0),drum:i(r),box:new ki(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var lv=new Map,_g=(n,t)=>lv.get(n)??lv.set(n,xP(n,t)).get(n),yP=()=>_g(26,12),pg=()=>_g(11,5),cv=()=>_g(6,3),jd=class{constructor(t){this.mesh=new je(new Se,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Se,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new ke(c,l).setUsage(Id);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new ke(o,1).setUsage(Id)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let p=t.at[d+2]>0?c:a,y=p*t.at[d],g=p*t.at[d+1],m=l*t.at[d+2],_=t.normal[d]/a,E=t.normal[d+1]/a,b=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*y+r[A]*g+o[A]*m,this.normal[f+A]=s[A]*_+r[A]*E+o[A]*b}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},hv=[1,0,0],vP=[0,1,0],dv=[0,0,1];function bP(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Pu(n,Math.abs(n[2])<.9?dv:hv),i=Pu(n,e),s=us(i)||1,r=i.map(o=>o/s);return[Pu(r,n),r]}var mg=0,Zd=1,gg=2,uv=3,nl=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new An,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new jd(t),this.group.add(this.body.mesh),e&&(this.flat=new jd(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?cv:pg:this.moving?pg:yP;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?cv():pg(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,u,h,d,f,p,y,g)=>t.put(c,u,h,...bP(d,y),d,f,p,g),l=(c,u,h)=>t.put(i.ball,c,u,hv,vP,dv,h,h);for(let{a:c,b:u,r:h,far:d}of e.rods){let f=Ui(u,c),p=us(f),y=[(c[0]+u[0])/2,(c[1]+u[1])/2,(c[2]+u[2])/2];a(i.rod,mg,y,f.map(g=>g/p),r*h,p,null,r*(d??h))}for(let{at:c,r:u}of e.balls)l(mg,c,r*u);for(let{at:c,dir:u,turned:h,r:d,h:f,beyond:p}of e.drums){if(a(i.drum,p&&o?uv:Zd,c,u,r*d,r*f),!o)continue;a(i.rod,gg,c,u,d*1.012,f*.13);let y=[0,1,2].map(g=>c[g]+h[g]*d*.96);a(i.box,mg,y,u,d*.11,f*.86,h)}for(let{at:c,dir:u,x:h,r:d,h:f,beyond:p}of e.sleeves)a(i.box,p&&o?uv:Zd,c,u,r*d,r*f,h);if(e.pedestal&&!this.veil){let{at:c,dir:u,r:h,h:d}=e.pedestal;a(i.drum,Zd,[c[0]+u[0]*d/2,c[1]+u[1]*d/2,c[2]+u[2]*d/2],u,h,d)}if(e.flange&&a(i.drum,Zd,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:c,dir:u,turned:h,r:d,h:f}=e.flange;a(i.box,gg,[0,1,2].map(p=>c[p]+h[p]*d*.95),u,d*.16,f*1.04,h)}e.tip&&o&&l(gg,e.tip.at,e.tip.r)}};var MP=`
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
  }`,fv=`
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
  }`,SP=`
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
  }`,wP=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Jd({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new Ci({vertexShader:e?SP:MP,fragmentShader:e?wP:fv,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ne)},opacity:{value:n},gloss:{value:t},sky:{value:new ne(.46,.46,.47)},ground:{value:new ne(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function pv(n){let t=new Ci({vertexShader:`
      varying vec3 vNormal;
      varying vec3 vToEye;
      varying vec3 vColour;
      uniform vec3 colour;
      void main() {
        vec4 world = modelMatrix * vec4(position, 1.0);
        vNormal = mat3(modelMatrix) * normal;
        vToEye = cameraPosition - world.xyz;
        vColour = colour;
        gl_Position = projectionMatrix * viewMatrix * world;
      }`,fragmentShader:fv.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?rr:fi,uniforms:{colour:{value:new ne},opacity:{value:1},gloss:{value:.14},sky:{value:new ne},ground:{value:new ne}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function xg(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Se;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,u),c+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=mv(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let y=0;y<o[u].length;++y)f.push(o[u][y][d]);let p=mv(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(p)}}}return l}function mv(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new ke(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let y=u.getComponent(d,p);a.setComponent(d+h,p,y)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var Nr=kd.axes;function yg(n,t){let e=new Ri(.028,.028,.82,8).translate(0,.41,0),i=new Do(.085,.22,12).translate(0,.9,0),s=xg([e,i]).applyMatrix4(t),r=new ne(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new ke(o,3)),s}var vg=n=>new _e().makeRotationFromQuaternion(new hn().setFromUnitVectors(new G(0,1,0),new G(...n))),EP=xg([yg(Nr[0],vg([1,0,0])),yg(Nr[1],vg([0,1,0])),yg(Nr[2],vg([0,0,1]))]),gv=.021,Wc=new Map;function TP(n){let t=`${n}/${kt.dark}`;if(Wc.has(t))return Wc.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=kt.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=kt.ink,s.fillText(n,e.width/2,e.height/2);let o=new yc(e);o.colorSpace=si;let a=new Ga({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,Wc.set(t,a),a}var il=class{constructor(){this.group=new An,this.mesh=new _c(EP,new oi({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new _e;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new G(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new mc);a.parent||this.group.add(a),a.material=TP(r),a.scale.set(gv*a.material.userData.aspect,gv,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of Wc.values())t.map.dispose(),t.dispose();Wc.clear(),this.last&&this.show(...this.last)}};var Mg=180/Math.PI,Gi={angle:"deg",length:"mm"},AP={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},bg={deg:Mg,rad:1,mm:1e3,m:1},RP={deg:2,rad:4,mm:2,m:5},CP={deg:1,rad:.02,mm:5,m:.005},gt={get angle(){return Gi.angle},get length(){return Gi.length},set(n,t){t in bg&&n in Gi&&(Gi[n]=t)},factor:n=>n in Gi?bg[Gi[n]]:1,symbol:n=>n in Gi?AP[Gi[n]]:"",digits:n=>n in Gi?RP[Gi[n]]:4,step:n=>n in Gi?CP[Gi[n]]/bg[Gi[n]]:.01,suffix:n=>n==="angle"?{deg:Mg,"\xB0":Mg,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ni(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var fn=(n,t,e=gt.digits(t))=>ni(n*gt.factor(t),e),he=(n,t,e)=>`${fn(n,t,e)}${t==="angle"&&Gi.angle==="deg"?"":" "}${gt.symbol(t)}`,$c=(n,t="plain")=>String(Number((n*gt.factor(t)).toPrecision(9))+0),Kd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function sl(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||gt.digits(t))/gt.factor(t)}var PP={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},IP={theta:(n,t,e)=>`turn by \u03B8${n} = ${he(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${he(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${he(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${he(t,"angle")} about x`};function _v(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=PP[n.convention],o=xr(n.joints[i],yr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:A_(n.convention,a.a,a.alpha,a.d,a.theta)}}function xv(){let n=M("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>St(o,{"aria-label":a},()=>i(l())),e=()=>4*v.table.joints.length-1,i=o=>{v.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ht("frames")},s=M("details",{class:"fold","data-testid":"dh-steps"},M("summary",{text:"The frames, one step at a time"}),M("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(v.dhStep??1)-1),t("On","One step on",()=>(v.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(v.dhStep===null||!v.table.joints.length){v.dhStep=null,bt(n,"");return}v.dhStep=Math.min(v.dhStep,e());let{i:o,key:a,value:l}=_v(v.table,v.q,v.dhStep),c=v.table.convention==="standard"?o:o+1;bt(n,`Joint ${o+1}, ${v.dhStep%4+1} of 4: ${IP[a](o+1,l,c)}`)};return nt(["q","table","units"],()=>v.dhStep!==null&&r()),nt("panel",o=>{o!=="table"&&v.dhStep!==null&&(s.open=!1,i(null))}),s}function Qd(){let{i:n,A:t}=_v(v.table,v.q,v.dhStep);return[...v.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:Hn(v.frames[n],t),name:`\u2192 ${n+1}`}]}var Sg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],rl=n=>[Math.cos(n),Math.sin(n)];function LP([n,t,e]){let[i,s]=rl(e),[r,o]=rl(t),[a,l]=rl(n);return Sg([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function DP(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function NP([n,t,e]){let[i,s]=rl(n),[r,o]=rl(t),[a,l]=rl(e);return Sg([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function UP(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function tf(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function qc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return Sg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function FP(n){let[t,e,i,s]=tf(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function OP([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:qc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Ns={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:DP,from:LP},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:UP,from:NP},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:FP,from:OP},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:tf,from:qc}};function yv(n,t,e){let i=Ns[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function ef(n,t,e){let i=tf(n),s=tf(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=qc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var ol=.145,rf=.105,Ig=.165,vv={mouse:13,pen:16,touch:28},BP=.2,ho=["x","y","z"],Yc=72,Ho=new An,sf=new Map,Ag="both",of="local",Lg=0,Ur=!1,Rg=null,en=null,af=()=>en!==null,Ev=()=>Ur,co=null,uo=null;function Tv(){Ho.visible=!1,dn.add(Ho),Qy(Dg),uo=document.getElementById("view"),co=M("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(co),uo.addEventListener("pointerdown",$P,!0),uo.addEventListener("pointermove",XP,!0);for(let n of["pointerup","pointercancel"])uo.addEventListener(n,Nv,!0);addEventListener("keydown",n=>n.key==="Escape"&&en&&ZP()),nt(["target","theme"],ye)}function Xc(n,t,e=8){let i=new oi({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new je(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var kP=[new hn().setFromUnitVectors(new G(0,1,0),new G(1,0,0)),new hn,new hn().setFromUnitVectors(new G(0,1,0),new G(0,0,1))],zP=[new hn().setFromUnitVectors(new G(0,0,1),new G(1,0,0)),new hn().setFromUnitVectors(new G(0,0,1),new G(0,1,0)),new hn];function HP(){if(sf.size)return;let n=(t,e)=>{sf.set(t,e),Ho.add(e)};ho.forEach((t,e)=>{let i=new Ri(.0032,.0032,ol*.8,8).translate(0,ol*.45,0),s=new Do(.0125,.034,14).translate(0,ol*.9,0),r=new An;r.add(Xc(i,Nr[e]),Xc(s,Nr[e])),r.userData.turn=kP[e],n(`move-${t}`,r);let o=Xc(new Wa(rf,.0026,6,Yc),Nr[e],7);o.userData.turn=zP[e],n(`turn-${t}`,o)}),n("turn-view",Xc(new Wa(Ig,.0022,6,Yc),"#8891a0",7)),n("move-view",Xc(new Ps(.0115,14,10),"#8891a0",9))}var nf=new G,fo=new G,wg=new hn;function lf(){return 2*Math.tan(lo.degToRad(He.fov/2))*He.position.distanceTo(nf)}var jc=()=>of==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):GP(),GP=()=>[0,1,2].map(n=>Ys(v.target,n)),VP=new _e;function Dg(){if(Ho.visible=Ur,!Ur)return;nf.set(...te(v.target)),fo.copy(He.position).sub(nf).normalize(),of==="world"?wg.identity():wg.setFromRotationMatrix(VP.set(...v.target)),Ho.position.copy(nf),Ho.scale.setScalar(lf());let n=jc();for(let[t,e]of sf){let[i,s]=t.split("-"),r=ho.indexOf(s),o=Ag==="both"||Ag===i;e.visible=o&&WP(i,n[r])&&(!en||en.name===t),s==="view"?e.quaternion.copy(He.quaternion):e.quaternion.copy(wg).multiply(e.userData.turn);let a=t===(en?.name??Rg);e.traverse(l=>l.material?.color.set(a?kt.accent:l.userData.colour))}}function WP(n,t){return!t||n!=="move"?!0:Math.hypot(...Av(t,fo.toArray()))>BP}var Av=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Zc=(n,t)=>te(v.target).map((e,i)=>e+t*n[i]);function Cg(n,t){let e=jc(),[i,s]=n<0?[bv(He.matrixWorld,0),bv(He.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Yc+1},(r,o)=>{let a=2*Math.PI*o/Yc,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:Zc(l,t),front:n<0||l.reduce((c,u,h)=>c+u*fo.getComponent(h),0)>-.15}})}var bv=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function Mv(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function Pg(n,t){let e=lf(),i=[];for(let[s,r]of sf){if(!r.visible)continue;let[o,a]=s.split("-"),l=ho.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=Hi(te(v.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=jc()[l],h=Hi(Zc(u,.92*ol*e));c=Math.min(Mv(n,t,Hi(Zc(u,.3*ol*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Cg(l,(l<0?Ig:rf)*e).map(h=>({...h,s:Hi(h.p)}));for(let h=0;h<Yc;h++)u[h].front&&(c=Math.min(c,Mv(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Rv(n){if(!Ur)return null;Dg();let[t]=Pg(n.clientX,n.clientY);return t&&t[1]<=(vv[n.pointerType]??vv.mouse)?t[0]:null}function Cv(){if(!Ur)return{};Dg();let n=lf(),t=jc(),e={"move-view":Hi(te(v.target))};return ho.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>Hi(Zc(t[s],c*ol*n))).find(([c,u])=>Pg(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=Cg(s,rf*n).filter(c=>c.front).map(c=>Hi(c.p)).filter(([c,u])=>Pg(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=Hi(Cg(-1,Ig*n)[9].p),e}var Sv=new Rc,wv=new Yt;function Pv(n){let t=ss.domElement.getBoundingClientRect();return wv.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),Sv.setFromCamera(wv,He),Sv.ray}function Iv(n,t,e){let{origin:i,direction:s}=Pv(e),r=new G(...n),o=new G(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function Lv(n,t,e){let i=new ri().setFromNormalAndCoplanarPoint(n,new G(...t));return Pv(e).intersectPlane(i,new G)}function $P(n){if(n.button!==0)return;let t=Rv(n);if(!t)return;n.stopPropagation(),n.preventDefault(),uo.focus({preventScroll:!0}),uo.setPointerCapture(n.pointerId),Rn.enabled=!1;let[e,i]=t.split("-"),s=ho.indexOf(i),r=s<0?fo.toArray():jc()[s].slice();en={name:t,what:e,axis:r,i:s,T:v.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},en.start=e==="turn"?Dv(n):s<0?Lv(fo,te(en.T),n):Iv(r,te(en.T),n),ye()}function Dv(n){let[t,e]=Hi(te(en.T)),i=en.axis.reduce((h,d,f)=>h+d*fo.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Av(en.axis,fo.toArray()),r=lf(),o=Hi(te(en.T)),a=Hi(Zc(s,rf*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-en.x)*l+(n.clientY-en.y)*c)/(u*u)}var qP=n=>Math.atan2(Math.sin(n),Math.cos(n)),Eg=(n,t,e)=>{let i=Lg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function XP(n){if(!en){if(n.buttons||!Ur)return;let l=Rv(n);l!==Rg&&(Rg=l,uo.style.setProperty("cursor",l?"grab":""),ye());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=en,r=of==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Dv(n);en.total+=qP(l-(en.before??en.start)),en.before=l;let c=Eg(en.total,n,Math.PI/180),u=Math.sin(c/2);o=Hn(qc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${Tg(c,"angle")} about ${s<0?"the line of sight":r+ho[s]}`}else if(s<0){let l=Lv(fo,te(t),n);if(!l)return;let c=l.sub(en.start);(Lg||n.shiftKey)&&c.set(...c.toArray().map(u=>Eg(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${ho[h]} ${Tg(u,"length")}`).join(", ")}else{let l=Eg(Iv(e,te(t),n)-en.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${Tg(l,"length")} along ${r}${ho[s]}`}Mi(o,"drag"),YP(a,n),ye()}var Tg=(n,t)=>`${n>=0?"+":""}${he(n,t,gt.digits(t))}`;function YP(n,t){let e=uo.getBoundingClientRect();co.hidden=!1,bt(co,n),co.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-co.offsetWidth-8)}px`),co.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Nv(n){en&&(n.stopPropagation(),en=null,co.hidden=!0,Rn.enabled=!0,Mi(v.target,"dropped"),ye())}function ZP(){let{T:n}=en;Mi(n,"drag"),Nv({stopPropagation(){}})}function Uv(){Ur&&HP(),Ho.visible=Ur,ht("frames"),ye()}function Fv(n){Ur=n,Uv()}function Ov(n){Ag=n,Uv()}function Bv(n){of=n,ye()}function kv(n){Lg=n}var Wv=Jd(),Hv=[.32,-.4,1],df=new oi({color:"#000",transparent:!0,opacity:.1,side:fi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Im,stencilRef:1,stencilZPass:Pm,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),Fg=new _e().set(1,0,-Hv[0],0,0,1,-Hv[1],0,0,0,0,5e-4,0,0,0,1),al=new je(new Mc(1,40),new Ci({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));al.renderOrder=-1;function jP(){let n=v.frames[0],t=2*(ur.radius[0]??0);al.visible=v.table.joints.length>0&&Math.abs(n[11])<.02*ur.size&&n[10]>.99,al.position.set(n[3],n[7],4e-4*ur.size),al.scale.set(1.6*t,1.6*t,1)}var Qc=new nl(Wv,{shadow:{material:df,matrix:Fg}});function $v(n,t){Qc.shown(n,n&&!t)}var qv=Jd({opacity:.2,veil:!0}),cf=new nl(qv,{veil:!0}),Xv=Jd({opacity:.62,gloss:.1}),Ug=new nl(Xv,{veil:!0}),ff=new il,ur=Yd(v.table),pf=[],hf=null;function Yv(){dn.add(al,Qc.group,cf.group,Ug.group,ff.group),cf.group.renderOrder=1,nt("table",n=>{ur=Yd(v.table),ug(ur.size),pf=[],hf=null,Og(),gf(),n==="new"&&tu({instant:!0,view:"iso"}),tv()}),nt("q",KP),nt("frames",Jv),nt("theme",Vv),nt("hurry",n=>{for(let t of[Qc,cf,Ug])t.hurry(n)}),Vv()}var Gv=new Map,Kc=[],Ng=0;function Or(n,t){if(Gv.set(n,t),Kc=[...Gv.values()].flat(),!v.table.joints.length)return;let e=Ng;Ng=Kc.length,lg([...Vc(v.table,v.frames),...Kc]),t.length?jv():e>Ng&&JP()}var JP=Ks(ov,120);function Zv(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Or("motion",i.flatMap(s=>Vc(n,Es(n,s))))}function tu(n){Xd([...Vc(v.table,v.frames),...Kc],n)}var jv=Ks(tl,220);function KP(){let n=v.frames;Qc.show(v.table.joints.length?[dg(v.table,n,ur,v.q)]:[]),jP(),lg([...Vc(v.table,n),...Kc]),jv(),ib&&QP(te(n[n.length-1])),Jv()}function Jv(){let n=(v.shownFrames??[]).filter(t=>t<v.frames.length&&!(t===v.frames.length-1&&Ev())).map(t=>({T:v.frames[t],name:mf(t)}));ff.show(v.dhStep===null?n:Qd(),ur.size*.13),ye()}var Kv=()=>Qc.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),Qv=()=>(ff.last?.[0]??[]).map(n=>n.name);function mf(n){let t=v.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function tb(n){pf=n,Og()}function gs(n){hf=n,Og()}var eb=()=>pf.length;function Og(){let n=t=>dg(v.table,Es(v.table,t),ur);cf.show(pf.map(n)),Ug.show(hf?[n(hf)]:[]),ye()}var nb=6e3,uf=new Float32Array(6*nb),Fr=new Io(new Se,new es({fog:!1}));Fr.geometry.setAttribute("position",new ke(uf,3));Fr.frustumCulled=!1;Fr.visible=!1;var po=0,ib=!0,Jc=null;dn.add(Fr);function QP(n){let t=Jc?us(Ui(n,Jc)):1/0;t<ur.size*.002||(t<ur.size*.2&&(po===nb&&(uf.copyWithin(0,6*1e3),po-=1e3),uf.set(Jc,6*po),uf.set(n,6*po+3),po+=1,Fr.geometry.setDrawRange(0,2*po),Fr.geometry.attributes.position.needsUpdate=!0,Fr.visible=!0),Jc=n)}function sb(n){ib=n,n||gf(),ye()}function gf(){po=0,Jc=null,Fr.visible=!1,ye()}var rb=()=>po,eu=new ir(new Se,new es({fog:!1}));eu.frustumCulled=!1;var nu=new Cr(new Se,new sr({size:4,sizeAttenuation:!1,fog:!1}));nu.frustumCulled=!1;eu.visible=nu.visible=!1;dn.add(eu,nu);function Go(n){Or("path",n);let t=new Float32Array(n.flat());for(let e of[eu,nu])e.geometry.dispose(),e.geometry=new Se,e.geometry.setAttribute("position",new ke(t,3)),e.visible=n.length>0;ye()}function Vv(){Wv.repaint(kt.link,kt.joint,kt.accent,kt.dark,kt.wrong),qv.repaint(kt.ghost,kt.ghost,kt.ghost,kt.dark),Xv.repaint(kt.accent,kt.accent,kt.accent,kt.dark),Fr.material.color.set(kt.accent),eu.material.color.set(kt.trace),nu.material.color.set(kt.trace),df.opacity=kt.dark?.28:.11,al.material.uniforms.strength.value=kt.dark?.75:.34,ff.paint(),ye()}var de={follow:!0,ghosts:"all",task:null,redundancy:null},Bg={answers:0},_f=!1,ob=Zs(async()=>{let n=_f;_f=!1;let t=v.target,e=v.table;try{let i=af()||kg,s=i?null:v.digits,{task:r,redundancy:o}=de,a=await Fe("ik",{T:t,q:v.q,brief:i,task:r,redundancy:o,digits:s});if(e!==v.table||t!==v.target&&!i)return;Bg.answers+=1,v.solutions={...a,T:t,brief:i},n&&de.follow&&a.nearest&&Fi(a.nearest,"follow"),ll(),ht("solutions"),!i&&!a.rows.some(l=>l.inside)&&nI(t),a.self_motions===null&&!i&&eI(v.solutions)}catch(i){if(i instanceof Uu)return;v.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},ll(),ht("solutions")}}),kg=!1;function ab(){kg=!0,_f=!0,ob()}function Us({follow:n=!1}={}){kg=!1,_f||=n,ob()}var eI=Zs(async n=>{try{let t={T:n.T,q:v.q,task:de.task,redundancy:de.redundancy},{self_motions:e}=await Fe("self_motions",t);if(v.solutions!==n||!e)return;n.self_motions=e,ht("solutions")}catch{}}),nI=Zs(async n=>{try{let t=await Fe("nearest",{T:n,task:de.task});v.solutions&&v.solutions.T===n&&(v.solutions.near=t,ht("solutions"))}catch{}}),iI=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function ll(){let n=v.solutions?.rows??[],t=v.panel==="inverse"&&de.ghosts!=="none"?n.filter(e=>(de.ghosts==="all"||e.inside)&&!iI(e.q,v.q)):[];tb(t.map(e=>e.q))}function lb(){nt("target",n=>{v.panel==="inverse"&&Us({follow:L_.has(n)})}),nt("task",()=>{ht("plan"),v.panel==="inverse"&&v.hasTarget&&Us()}),nt("panel",n=>{gs(null),n==="inverse"&&v.hasTarget&&!v.solutions&&Us(),ll()}),nt("moving",n=>{n||ll()}),nt("table",n=>{de.redundancy=null,n==="new"&&(de.task=null),ht("solutions"),n!=="new"&&v.panel==="inverse"&&v.hasTarget&&Us()}),nt("online",n=>{n&&v.panel==="inverse"&&v.hasTarget&&v.table.joints.length&&Us()})}var iu=0;function mi(){iu+=1,v.moving&&(v.moving=!1,ht("moving",!1))}function Ii(n,t=.8,e="move to a posture"){mi(),ht("let-go"),ht("did",{label:e});let i=v.q.slice(),s=iu,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),v.moving=!0,ht("moving",!0),new Promise(o=>{(function a(l){if(s!==iu||i.length!==v.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Fi(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(v.moving=!1,ht("moving",!1),o(!0))})(r)})}function cb(n,t,e,i){mi();let s=iu,r=performance.now()-1e3*n*t;v.moving=!0,ht("moving",!0),requestAnimationFrame(function o(a){if(s!==iu){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(v.moving=!1,ht("moving",!1),i?.(!0))})}var rI=200,oI=1500,Vo=[],ou=[],ru=null,su={key:null,at:0,open:!1},zg=!1,xf=()=>({table:v.table,q:v.q,target:v.target,digits:v.digits,hasTarget:v.hasTarget,path:{...v.path},sequence:structuredClone(v.sequence),program:v.program,world:v.world,limits:v.limits,start:v.start,routing:v.routing,task:de.task,redundancy:de.redundancy});function Hg(){zg||(zg=!0,queueMicrotask(()=>{zg=!1,ru=xf()}))}function aI({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===su.key&&(su.open||i-su.at<oI))&&ru&&(Vo.push({label:n,before:ru}),Vo.length>rI&&Vo.shift(),ou.length=0),su={key:t,at:i,open:e},Hg(),ht("history")}function Gg(){su={key:null,at:0,open:!1}}function lI(n){mi(),Gg(),de.task=n.task,n.table!==v.table?_n(n.table,{q:n.q,step:!1,what:"undo"}):Fi(n.q,"undo"),de.redundancy=n.redundancy,Object.assign(v.path,n.path),v.sequence=structuredClone(n.sequence),v.program=n.program,v.world=n.world,v.limits=n.limits,v.start=n.start;let t=v.routing!==n.routing;v.routing=n.routing,v.hasTarget=n.hasTarget,n.target!==v.target&&Mi(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ht(e,"undo");t&&ht("routing","undo")}function ub(n,t,e){let i=n.pop();if(!i)return;let s=xf();lI(i.before),t.push({label:i.label,before:s}),Hg(),ht("history"),Me(`${e}: ${i.label}`)}var Vg=()=>ub(Vo,ou,"Undone"),Wg=()=>ub(ou,Vo,"Redone"),yf=()=>Vo.at(-1)?.label??null,vf=()=>ou.at(-1)?.label??null;function bf(){Vo.length=0,ou.length=0,Gg(),ru=xf(),ht("history")}function hb(){ru=xf(),nt("did",aI),nt("let-go",Gg),nt(["table","q","target","path","sequence","program","world","task","routing"],Hg)}var pb=1,mb=30;function Mf(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=v;return{pieper:pb,table:n,q:t,target:i?e:null,digits:v.digits,task:de.task,redundancy:de.redundancy,follow:de.follow,ghosts:de.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:v.program,start:v.start,limits:v.limits},world:v.world,routing:v.routing,look:v.look,panel:l,theme:c,units:[gt.angle,gt.length],camera:el()}}var $n=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,ys=(n,t)=>Array.isArray(n)&&n.length===t&&n.every($n),_s=(n,t)=>typeof n=="string"?n.slice(0,t):"",xs=n=>{if(!ys(n,16))return null;let t=Iu(n);return t<1e-12?n.slice():t<.001?Lu(n):null},uI=n=>n&&$n(n.metres)&&$n(n.radians)?{metres:n.metres,radians:n.radians}:null,hI=n=>n&&[n.lower,n.upper,n.value].every($n)&&n.lower<=n.upper?{name:_s(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:_s(n.unit,10)}:null,dI=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>ys(e,t))?n:null;function fI(n){if(!n||!Array.isArray(n.joints)||n.joints.length>mb||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>$n(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:_s(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:$n(i.lower)?i.lower:null,upper:$n(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>ys(i,t.length)).slice(0,40));return{name:_s(n.name,60),convention:n.convention,joints:t,base:xs(n.base)??ji(),tool:xs(n.tool)??ji(),postures:e,manufacturer:_s(n.manufacturer,200),source:_s(n.source,2e3),notes:_s(n.notes,3e3),actuator:hI(n.actuator),catalog:_s(n.catalog,60)||void 0,derived:_s(n.derived,60)||void 0,coupling:dI(n.coupling,t.length)}}var db={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function pI(n,t){if(!n||!Object.hasOwn(db,n.kind))return null;let e=db[n.kind];if(e)return $n(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(l=>Number.isInteger(l)&&l>=1&&l<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return xs(n.T)?{kind:"frame",T:xs(n.T)}:null;let i=n.kind==="joint"&&ys(n.q,t)?n.q.slice():null,s=xs(n.T),r=n.kind==="circle"&&ys(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!xs(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(xs):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(l,c)=>c===null?{}:{[l]:c};return{kind:n.kind,...a("q",i),T:s,...a("via",xs(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",$n(n.speed)&&n.speed>0?n.speed:null),blend:$n(n.blend)&&n.blend>=0?n.blend:0}}var $g={frame:[],box:["size"],cylinder:["r","h"]};function mI(n){if(!n||!Object.hasOwn($g,n.kind))return null;let t=xs(n.T),e=_s(n.name,40),i=s=>s==="size"?ys(n.size,3)&&n.size.every(r=>r>0):$n(n[s])&&n[s]>0;return!t||!e||!$g[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries($g[n.kind].map(s=>[s,n[s]]))}}function gI(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&$n(s.turn)&&ys(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:_s(s.branch,80)}:null,i=(s,r)=>$n(s)&&s>=0&&s<r?s:0;return{turn:ys(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function _I(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};v.program=e(i.steps,s=>pI(s,t),200),v.start=ys(i.start,t)?i.start.slice():null,v.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||$n(r)&&r>0))),v.world=e(n.world,mI,60),v.routing=gI(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&$n(n.look.opacity)&&(v.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function Sf(n,t){let e=n&&n.pieper===pb?fI(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(gt.set("angle",n.units[0]),gt.set("length",n.units[1])),Object.hasOwn(Ns,n.notation)&&(v.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Hd(n.theme),v.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};_n(e,{q:ys(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(v.path,{from:xs(s.from),to:xs(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:$n(s.seconds)&&s.seconds>0?s.seconds:5}),v.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&ys(a.q,i)&&$n(a.seconds)&&$n(a.hold)).slice(0,40).map(a=>({name:_s(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),_I(n,i),["pose","position","position+axis"].includes(n.task)&&(de.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&$n(l));de.redundancy=r.length?Object.fromEntries(r.slice(0,mb)):null,typeof n.follow=="boolean"&&(de.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(de.ghosts=n.ghosts);let o=xs(n.target);v.hasTarget=!!o,o&&Mi(o,"restored",uI(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ht(a);t(n.panel),ht("path-loaded"),ht("routing","loaded"),ht("look","loaded"),ys(n.camera,6)&&av(n.camera),Fi(v.q,"restored"),bf()}async function gb(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function wf(){let n=await gb(new TextEncoder().encode(JSON.stringify(Mf())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function _b(){let n=xI();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await gb(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var xb="pieper-workbench";function xI(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(xb)??"{}");return t&&n===location.href?t:null}catch{return null}}function yI(){if(v.table.joints.length)try{sessionStorage.setItem(xb,JSON.stringify({address:location.href,shown:Mf()}))}catch{}}var fb=null,vI=Ks(async()=>{if(!v.table.joints.length)return;let n=await wf();n!==fb&&(fb=n,history.replaceState(null,"",n))},600);function yb(){addEventListener("pagehide",yI),nt(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],vI)}var MI="uplot",SI="u-hz",wI="u-vt",EI="u-title",TI="u-wrap",AI="u-under",RI="u-over",CI="u-axis",qo="u-off",PI="u-select",II="u-cursor-x",LI="u-cursor-y",DI="u-cursor-pt",NI="u-legend",UI="u-live",FI="u-inline",OI="u-series",BI="u-marker",vb="u-label",kI="u-value",lu="width",cu="height";var bb="bottom",cl="left",qg="right",c0="#000",Mb=c0+"0",Xg="mousemove",Sb="mousedown",Yg="mouseup",wb="mouseenter",Eb="mouseleave",Tb="dblclick",zI="resize",HI="scroll",Ab="change",Cf="dppxchange",u0="--",gl=typeof window<"u",Qg=gl?document:null,hl=gl?window:null,GI=gl?navigator:null,Ge,Ef;function t0(){let n=devicePixelRatio;Ge!=n&&(Ge=n,Ef&&n0(Ab,Ef,t0),Ef=matchMedia(`(min-resolution: ${Ge-.001}dppx) and (max-resolution: ${Ge+.001}dppx)`),Xo(Ab,Ef,t0),hl.dispatchEvent(new CustomEvent(Cf)))}function rs(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function e0(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function pn(n,t,e){n.style[t]=e+"px"}function Fs(n,t,e,i){let s=Qg.createElement(n);return t!=null&&rs(s,t),e?.insertBefore(s,i),s}function vs(n,t){return Fs("div",n,t)}var Rb=new WeakMap;function hr(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Rb.get(n);r!=o&&(n.style.transform=r,Rb.set(n,r),t<0||e<0||t>i||e>s?rs(n,qo):e0(n,qo))}var Cb=new WeakMap;function Pb(n,t,e){let i=t+e,s=Cb.get(n);i!=s&&(Cb.set(n,i),n.style.background=t,n.style.borderColor=e)}var Ib=new WeakMap;function Lb(n,t,e,i){let s=t+""+e,r=Ib.get(n);s!=r&&(Ib.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var h0={passive:!0},VI={...h0,capture:!0};function Xo(n,t,e,i){t.addEventListener(n,e,i?VI:h0)}function n0(n,t,e,i){t.removeEventListener(n,e,h0)}gl&&t0();function Os(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:os((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function oM(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var aM=n=>n!=null,lM=n=>n!=null&&n>0,Lf=oM(aM),WI=oM(lM);function $I(n,t,e,i=0,s=!1){let r=s?WI:Lf,o=s?lM:aM;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??nn,l??-nn]}function Df(n,t,e,i){let s=Ub(n),r=Ub(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Br:cM,a=s==1?os:bs,l=r==1?bs:os,c=a(o(Xn(n))),u=l(o(Xn(t))),h=dl(e,c),d=dl(e,u);return e==10&&(c<0&&(h=sn(h,-c)),u<0&&(d=sn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=fM(n,h),t=Nf(t,d)),[n,t]}function d0(n,t,e,i){let s=Df(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var f0=.1,Db={mode:3,pad:f0},hu={pad:0,soft:null,mode:0},qI={min:hu,max:hu};function Pf(n,t,e,i){return Uf(e)?Nb(n,t,e):(hu.pad=e,hu.soft=i?0:null,hu.mode=i?3:0,Nb(n,t,qI))}function Oe(n,t){return n??t}function XI(n,t,e){for(t=Oe(t,0),e=Oe(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Nb(n,t,e){let i=e.min,s=e.max,r=Oe(i.pad,0),o=Oe(s.pad,0),a=Oe(i.hard,-nn),l=Oe(s.hard,nn),c=Oe(i.soft,nn),u=Oe(s.soft,-nn),h=Oe(i.mode,0),d=Oe(s.mode,0),f=t-n,p=Br(f),y=Li(Xn(n),Xn(t)),g=Br(y),m=Xn(g-p);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=nn&&(r=0),d==2&&u!=-nn&&(o=0)));let _=f||y||1e3,E=Br(_),b=dl(10,os(E)),A=_*(f==0?n==0?.1:1:r),T=sn(fM(n-A,b/10),24),x=n>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:nn,S=Li(a,T<x&&n>=x?x:Bs(x,T)),D=_*(f==0?t==0?.1:1:o),I=sn(Nf(t+D,b/10),24),N=t<=u&&(d==1||d==3&&I>=u||d==2&&I<=u)?u:-nn,H=Bs(l,I>N&&t<=N?N:Li(N,I));return S==H&&S==0&&(H=100),[S,H]}var YI=new Intl.NumberFormat(gl?GI.language:"en-US"),p0=n=>YI.format(n),as=Math,Rf=as.PI,Xn=as.abs,os=as.floor,qn=as.round,bs=as.ceil,Bs=as.min,Li=as.max,dl=as.pow,Ub=as.sign,Br=as.log10,cM=as.log2,ZI=(n,t=1)=>as.sinh(n)*t,Zg=(n,t=1)=>as.asinh(n/t),nn=1/0;function Fb(n){return(Br((n^n>>31)-(n>>31))|0)+1}function i0(n,t,e){return Bs(Li(n,t),e)}function uM(n){return typeof n=="function"}function De(n){return uM(n)?n:()=>n}var jI=()=>{},hM=n=>n,dM=(n,t)=>t,JI=n=>null,Ob=n=>!0,Bb=(n,t)=>n==t,KI=/\.\d*?(?=9{6,}|0{6,})/gm,Yo=n=>{if(mM(n)||go.has(n))return n;let t=`${n}`,e=t.match(KI);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Yo(s)}e${r}`}return sn(n,i)};function Wo(n,t){return Yo(sn(Yo(n/t))*t)}function Nf(n,t){return Yo(bs(Yo(n/t))*t)}function fM(n,t){return Yo(os(Yo(n/t))*t)}function sn(n,t=0){if(mM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return qn(i)/e}var go=new Map;function pM(n){return((""+n).split(".")[1]||"").length}function fu(n,t,e,i){let s=[],r=i.map(pM);for(let o=t;o<e;o++){let a=Xn(o),l=sn(dl(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:sn(u,h);s.push(d),go.set(d,h)}}return s}var du={},m0=[],fl=[null,null],mo=Array.isArray,mM=Number.isInteger,QI=n=>n===void 0;function kb(n){return typeof n=="string"}function Uf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function t3(n){return n!=null&&typeof n=="object"}var e3=Object.getPrototypeOf(Uint8Array),gM="__proto__";function pl(n,t=Uf){let e;if(mo(n)){let i=n.find(s=>s!=null);if(mo(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=pl(n[s],t)}else e=n.slice()}else if(n instanceof e3)e=n.slice();else if(t(n)){e={};for(let i in n)i!=gM&&(e[i]=pl(n[i],t))}else e=n;return e}function Bn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=gM&&(Uf(n[s])?Bn(n[s],pl(i[s])):n[s]=pl(i[s]))}return n}var n3=0,i3=1,s3=2;function r3(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function o3(n,t){if(c3(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return u3(o[0])||(o=l3(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:i3,f=[];for(let p=0;p<u.length;p++){let y=u[p],g=r.get(l[p]);y===null?d!=n3&&(h[g]=y,d==s3&&f.push(g)):h[g]=y}r3(h,f,s),i.push(h)}}return i}var a3=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function l3(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function c3(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function u3(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Li(1,os((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var _M=["January","February","March","April","May","June","July","August","September","October","November","December"],xM=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function yM(n){return n.slice(0,3)}var h3=xM.map(yM),d3=_M.map(yM),f3={MMMM:_M,MMM:d3,WWWW:xM,WWW:h3};function au(n){return(n<10?"0":"")+n}function p3(n){return(n<10?"00":n<100?"0":"")+n}var m3={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>au(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>au(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>au(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>au(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>au(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>p3(n.getMilliseconds())};function g0(n,t){t=t||f3;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?m3[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var g3=new Intl.DateTimeFormat().resolvedOptions().timeZone;function _3(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==g3?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var vM=n=>n%1==0,If=[1,2,2.5,5],x3=fu(10,-32,0,If),bM=fu(10,0,32,If),y3=bM.filter(vM),$o=x3.concat(bM),_0=`
`,MM="{YYYY}",zb=_0+MM,SM="{M}/{D}",uu=_0+SM,Tf=uu+"/{YY}",wM="{aa}",v3="{h}:{mm}",ul=v3+wM,Hb=_0+ul,Gb=":{ss}",qe=null;function EM(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?fu(10,0,3,If).filter(vM):fu(10,-3,0,If)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,MM,qe,qe,qe,qe,qe,qe,1],[s*28,"{MMM}",zb,qe,qe,qe,qe,qe,1],[s,SM,zb,qe,qe,qe,qe,qe,1],[i,"{h}"+wM,Tf,qe,uu,qe,qe,qe,1],[e,ul,Tf,qe,uu,qe,qe,qe,1],[t,Gb,Tf+" "+ul,qe,uu+" "+ul,qe,Hb,qe,1],[n,Gb+".{fff}",Tf+" "+ul,qe,uu+" "+ul,qe,Hb,qe,1]];function u(h){return(d,f,p,y,g,m)=>{let _=[],E=g>=o,b=g>=r&&g<o,A=h(p),T=sn(A*n,3),x=jg(A.getFullYear(),E?0:A.getMonth(),b||E?1:A.getDate()),S=sn(x*n,3);if(b||E){let D=b?g/r:0,I=E?g/o:0,N=T==S?T:sn(jg(x.getFullYear()+I,x.getMonth()+D,1)*n,3),H=new Date(qn(N/n)),V=H.getFullYear(),k=H.getMonth();for(let O=0;N<=y;O++){let L=jg(V+I*O,k+D*O,1),F=L-h(sn(L*n,3));N=sn((+L+F)*n,3),N<=y&&_.push(N)}}else{let D=g>=s?s:g,I=os(p)-os(T),N=S+I+Nf(T-S,D);_.push(N);let H=h(N),V=H.getHours()+H.getMinutes()/e+H.getSeconds()/i,k=g/i,O=d.axes[f]._space,L=m/O;for(;N=sn(N+g,n==1?0:3),!(N>y);)if(k>1){let F=os(sn(V+k,6))%24,J=h(N).getHours()-F;J>1&&(J=-1),N-=J*i,V=(V+k)%24;let et=_[_.length-1];sn((N-et)/g,3)*L>=.7&&_.push(N)}else _.push(N)}return _}}return[l,c,u]}var[b3,M3,S3]=EM(1),[w3,E3,T3]=EM(.001);fu(2,-53,53,[1]);function Vb(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Wb(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let y=n(p),g=y.getFullYear(),m=y.getMonth(),_=y.getDate(),E=y.getHours(),b=y.getMinutes(),A=y.getSeconds(),T=g!=l&&a[2]||m!=c&&a[3]||_!=u&&a[4]||E!=h&&a[5]||b!=d&&a[6]||A!=f&&a[7]||a[1];return l=g,c=m,u=_,h=E,d=b,f=A,T(y)})}}function A3(n,t){let e=g0(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function jg(n,t,e){return new Date(n,t,e)}function $b(n,t){return t(n)}var R3="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function qb(n,t){return(e,i,s,r)=>r==null?u0:t(n(i))}function C3(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function P3(n,t){return n.series[t].fill(n,t)}var I3={show:!0,live:!0,isolate:!1,mount:jI,markers:{show:!0,width:2,stroke:C3,fill:P3,dash:"solid"},idx:null,idxs:null,values:[]};function L3(n,t){let e=n.cursor.points,i=vs(),s=e.size(n,t);pn(i,lu,s),pn(i,cu,s);let r=s/-2;pn(i,"marginLeft",r),pn(i,"marginTop",r);let o=e.width(n,t,s);return o&&pn(i,"borderWidth",o),i}function D3(n,t){let e=n.series[t].points;return e._fill||e._stroke}function N3(n,t){let e=n.series[t].points;return e._stroke||e._fill}function U3(n,t){return n.series[t].points.size}var Jg=[0,0];function F3(n,t,e){return Jg[0]=t,Jg[1]=e,Jg}function Af(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Kg(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var O3={show:!0,x:!0,y:!0,lock:!1,move:F3,points:{one:!1,show:L3,size:U3,width:0,stroke:N3,fill:D3},bind:{mousedown:Af,mouseup:Af,click:Af,dblclick:Af,mousemove:Kg,mouseleave:Kg,mouseenter:Kg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},TM={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},x0=Bn({},TM,{filter:dM}),AM=Bn({},x0,{size:10}),RM=Bn({},TM,{show:!1}),y0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',CM="bold "+y0,PM=1.5,Xb={show:!0,scale:"x",stroke:c0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:CM,side:2,grid:x0,ticks:AM,border:RM,font:y0,lineGap:PM,rotate:0},B3="Value",k3="Time",Yb={show:!0,scale:"x",auto:!1,sorted:1,min:nn,max:-nn,idxs:[]};function z3(n,t,e,i,s){return t.map(r=>r==null?"":p0(r))}function H3(n,t,e,i,s,r,o){let a=[],l=go.get(s)||0;e=o?e:sn(Nf(e,s),l);for(let c=e;c<=i;c=sn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function s0(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Br:cM,u=os(c(e));s=dl(l,u),l==10&&(s=$o[Os(s,$o)]);let h=e,d=s*l;l==10&&(d=$o[Os(d,$o)]);do a.push(h),h=h+s,l==10&&!go.has(h)&&(h=sn(h,go.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=$o[Os(d,$o)]));while(h<=i);return a}function G3(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?s0(n,t,Li(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?s0(n,t,Li(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var IM=/./,V3=/[12357]/,W3=/[125]/,Zb=/1/,r0=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function $3(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?IM:l(7,o)-u>=c?V3:l(5,o)-u>=c?W3:Zb;if(h==Zb){let d=Xn(l(1,o)-u);if(d<c)return r0(t.slice().reverse(),a.distr,h,bs(c/d)).reverse()}return r0(t,a.distr,h,1)}function q3(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Xn(l(1,o)-l(2,o));return c<a?r0(t.slice().reverse(),3,IM,bs(a/c)).reverse():t}function X3(n,t,e,i){return i==null?u0:t==null?"":p0(t)}var jb={show:!0,scale:"y",stroke:c0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:CM,side:3,grid:x0,ticks:AM,border:RM,font:y0,lineGap:PM,rotate:0};function Y3(n,t){let e=3+(n||1)*2;return sn(e*t,3)}function Z3(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Xn(o-r),l=n.series[t],c=a/(l.points.space*Ge);return i[1]-i[0]<=c}var Jb={scale:null,auto:!0,sorted:0,min:nn,max:-nn},LM=(n,t,e,i,s)=>s,Kb={show:!0,auto:!0,sorted:0,gaps:LM,alpha:1,facets:[Bn({},Jb,{scale:"x"}),Bn({},Jb,{scale:"y"})]},Qb={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:LM,alpha:1,points:{show:Z3,filter:null},values:null,min:nn,max:-nn,idxs:[],path:null,clip:null};function j3(n,t,e,i,s){return e/10}var DM={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},J3=Bn({},DM,{time:!1,ori:1}),tM={};function NM(n,t){let e=tM[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(tM[n]=e)),e}var ml=1,o0=2;function Zo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,y=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,l,c,u,h,g,m,d,f,p,y,Of,_l,kf,FM,BM):e(s,l,c,u,h,m,g,f,d,y,p,Bf,xl,M0,OM,kM)}function v0(n,t){let e=0,i=0,s=Oe(n.bands,m0);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function K3(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function kr(n,t,e,i,s,r){return Zo(n,t,(o,a,l,c,u,h,d,f,p,y,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),E=c.ori==0?_l:xl,b,A;_==1?(b=e,A=i):(b=i,A=e);let T=m(h(a[b],c,y,f)),x=m(d(l[b],u,g,p)),S=m(h(a[A],c,y,f)),D=m(d(r==1?u.max:u.min,u,g,p)),I=new Path2D(s);return E(I,S,D),E(I,T,D),E(I,T,x),I})}function Ff(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?kf:M0,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Q3(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function b0(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function eM(n){return n==0?hM:n==1?qn:t=>Wo(t,n)}function UM(n){let t=n==0?Of:Bf,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Bs(c,a/2,l/2),u=Bs(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Of=(n,t,e)=>{n.moveTo(t,e)},Bf=(n,t,e)=>{n.moveTo(e,t)},_l=(n,t,e)=>{n.lineTo(t,e)},xl=(n,t,e)=>{n.lineTo(e,t)},kf=UM(0),M0=UM(1),FM=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},OM=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},BM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},kM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function zM(n){return(t,e,i,s,r)=>Zo(t,e,(o,a,l,c,u,h,d,f,p,y,g)=>{let{pxRound:m,points:_}=o,E,b;c.ori==0?(E=Of,b=FM):(E=Bf,b=OM);let A=sn(_.width*Ge,3),T=(_.size-_.width)/2*Ge,x=sn(T*2,3),S=new Path2D,D=new Path2D,{left:I,top:N,width:H,height:V}=t.bbox;kf(D,I-x,N-x,H+x*2,V+x*2);let k=O=>{if(l[O]!=null){let L=m(h(a[O],c,y,f)),F=m(d(l[O],u,g,p));E(S,L+T,F),b(S,L,F,T,0,Rf*2)}};if(r)r.forEach(k);else for(let O=i;O<=s;O++)k(O);return{stroke:A>0?S:null,fill:S,clip:D,flags:ml|o0}})}function HM(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var t2=HM(_l),e2=HM(xl);function GM(n){let t=Oe(n?.alignGaps,0);return(e,i,s,r)=>Zo(e,i,(o,a,l,c,u,h,d,f,p,y,g)=>{[s,r]=Lf(l,s,r);let m=o.pxRound,_=V=>m(h(V,c,y,f)),E=V=>m(d(V,u,g,p)),b,A;c.ori==0?(b=_l,A=t2):(b=xl,A=e2);let T=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ml},S=x.stroke,D=!1;if(r-s>=y*4){let V=ft=>e.posToVal(ft,c.key,!0),k=null,O=null,L,F,j,X=_(a[T==1?s:r]),J=_(a[s]),et=_(a[r]),dt=V(T==1?J+1:et-1);for(let ft=T==1?s:r;ft>=s&&ft<=r;ft+=T){let st=a[ft],_t=(T==1?st<dt:st>dt)?X:_(st),At=l[ft];_t==X?At!=null?(F=At,k==null?(b(S,_t,E(F)),L=k=O=F):F<k?k=F:F>O&&(O=F)):At===null&&(D=!0):(k!=null&&A(S,X,E(k),E(O),E(L),E(F)),At!=null?(F=At,b(S,_t,E(F)),k=O=L=F):(k=O=null,At===null&&(D=!0)),X=_t,dt=V(X+T))}k!=null&&k!=O&&j!=X&&A(S,X,E(k),E(O),E(L),E(F))}else for(let V=T==1?s:r;V>=s&&V<=r;V+=T){let k=l[V];k===null?D=!0:k!=null&&b(S,_(a[V]),E(k))}let[N,H]=v0(e,i);if(o.fill!=null||N!=0){let V=x.fill=new Path2D(S),k=o.fillTo(e,i,o.min,o.max,N),O=E(k),L=_(a[s]),F=_(a[r]);T==-1&&([F,L]=[L,F]),b(V,F,O),b(V,L,O)}if(!o.spanGaps){let V=[];D&&V.push(...b0(a,l,s,r,T,_,t)),x.gaps=V=o.gaps(e,i,s,r,V),x.clip=Ff(V,c.ori,f,p,y,g)}return H!=0&&(x.band=H==2?[kr(e,i,s,r,S,-1),kr(e,i,s,r,S,1)]:kr(e,i,s,r,S,H)),x})}function n2(n){let t=Oe(n.align,1),e=Oe(n.ascDesc,!1),i=Oe(n.alignGaps,0),s=Oe(n.extend,!1);return(r,o,a,l)=>Zo(r,o,(c,u,h,d,f,p,y,g,m,_,E)=>{[a,l]=Lf(h,a,l);let b=c.pxRound,{left:A,width:T}=r.bbox,x=J=>b(p(J,d,_,g)),S=J=>b(y(J,f,E,m)),D=d.ori==0?_l:xl,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ml},N=I.stroke,H=d.dir*(d.ori==0?1:-1),V=S(h[H==1?a:l]),k=x(u[H==1?a:l]),O=k,L=k;s&&t==-1&&(L=A,D(N,L,V)),D(N,k,V);for(let J=H==1?a:l;J>=a&&J<=l;J+=H){let et=h[J];if(et==null)continue;let dt=x(u[J]),ft=S(et);t==1?D(N,dt,V):D(N,O,ft),D(N,dt,ft),V=ft,O=dt}let F=O;s&&t==1&&(F=A+T,D(N,F,V));let[j,X]=v0(r,o);if(c.fill!=null||j!=0){let J=I.fill=new Path2D(N),et=c.fillTo(r,o,c.min,c.max,j),dt=S(et);D(J,F,dt),D(J,L,dt)}if(!c.spanGaps){let J=[];J.push(...b0(u,h,a,l,H,x,i));let et=c.width*Ge/2,dt=e||t==1?et:-et,ft=e||t==-1?-et:et;J.forEach(st=>{st[0]+=dt,st[1]+=ft}),I.gaps=J=c.gaps(r,o,a,l,J),I.clip=Ff(J,d.ori,g,m,_,E)}return X!=0&&(I.band=X==2?[kr(r,o,a,l,N,-1),kr(r,o,a,l,N,1)]:kr(r,o,a,l,N,X)),I})}function nM(n,t,e,i,s,r,o=nn){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Xn(n[l]-n[a]);u<c&&(c=u,o=Xn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function i2(n){n=n||du;let t=Oe(n.size,[.6,nn,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=De(s),o=1-t[0],a=Oe(t[1],nn),l=Oe(t[2],1),c=Oe(n.disp,du),u=Oe(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,y,g)=>Zo(f,p,(m,_,E,b,A,T,x,S,D,I,N)=>{let H=m.pxRound,V=e,k=i*Ge,O=a*Ge,L=l*Ge,F,j;b.ori==0?[F,j]=r(f,p):[j,F]=r(f,p);let X=b.dir*(b.ori==0?1:-1),J=b.ori==0?kf:M0,et=b.ori==0?u:(Ut,se,ge,Pt,tn,Zt,ee)=>{u(Ut,se,ge,tn,Pt,ee,Zt)},dt=Oe(f.bands,m0).find(Ut=>Ut.series[0]==p),ft=dt!=null?dt.dir:0,st=m.fillTo(f,p,m.min,m.max,ft),yt=H(x(st,A,N,D)),_t,At,Rt,Kt=I,me=H(m.width*Ge),jt=!1,Ee=null,ve=null,fe=null,mn=null;h!=null&&(me==0||d!=null)&&(jt=!0,Ee=h.values(f,p,y,g),ve=new Map,new Set(Ee).forEach(Ut=>{Ut!=null&&ve.set(Ut,new Path2D)}),me>0&&(fe=d.values(f,p,y,g),mn=new Map,new Set(fe).forEach(Ut=>{Ut!=null&&mn.set(Ut,new Path2D)})));let{x0:rn,size:In}=c;if(rn!=null&&In!=null){V=1,_=rn.values(f,p,y,g),rn.unit==2&&(_=_.map(ge=>f.posToVal(S+ge*I,b.key,!0)));let Ut=In.values(f,p,y,g);In.unit==2?At=Ut[0]*I:At=T(Ut[0],b,I,S)-T(0,b,I,S),Kt=nM(_,E,T,b,I,S,Kt),Rt=Kt-At+k}else Kt=nM(_,E,T,b,I,S,Kt),Rt=Kt*o+k,At=Kt-Rt;Rt<1&&(Rt=0),me>=At/2&&(me=0),Rt<5&&(H=hM);let Ke=Rt>0,Zn=Kt-Rt-(Ke?me:0);At=H(i0(Zn,L,O)),_t=(V==0?At/2:V==X?0:At)-V*X*((V==0?k/2:0)+(Ke?me/2:0));let Ne={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kn=jt?null:new Path2D,Mn=null;if(dt!=null)Mn=f.data[dt.series[1]];else{let{y0:Ut,y1:se}=c;Ut!=null&&se!=null&&(E=se.values(f,p,y,g),Mn=Ut.values(f,p,y,g))}let Ln=F*At,$=j*At;for(let Ut=X==1?y:g;Ut>=y&&Ut<=g;Ut+=X){let se=E[Ut];if(se==null)continue;if(Mn!=null){let Z=Mn[Ut]??0;if(se-Z==0)continue;yt=x(Z,A,N,D)}let ge=b.distr!=2||c!=null?_[Ut]:Ut,Pt=T(ge,b,I,S),tn=x(Oe(se,st),A,N,D),Zt=H(Pt-_t),ee=H(Li(tn,yt)),U=H(Bs(tn,yt)),R=ee-U;if(se!=null){let Z=se<0?$:Ln,mt=se<0?Ln:$;jt?(me>0&&fe[Ut]!=null&&J(mn.get(fe[Ut]),Zt,U+os(me/2),At,Li(0,R-me),Z,mt),Ee[Ut]!=null&&J(ve.get(Ee[Ut]),Zt,U+os(me/2),At,Li(0,R-me),Z,mt)):J(kn,Zt,U+os(me/2),At,Li(0,R-me),Z,mt),et(f,p,Ut,Zt-me/2,U,At+me,R)}}return me>0?Ne.stroke=jt?mn:kn:jt||(Ne._fill=m.width==0?m._fill:m._stroke??m._fill,Ne.width=0),Ne.fill=jt?ve:kn,Ne})}function s2(n,t){let e=Oe(t?.alignGaps,0);return(i,s,r,o)=>Zo(i,s,(a,l,c,u,h,d,f,p,y,g,m)=>{[r,o]=Lf(c,r,o);let _=a.pxRound,E=F=>_(d(F,u,g,p)),b=F=>_(f(F,h,m,y)),A,T,x;u.ori==0?(A=Of,x=_l,T=BM):(A=Bf,x=xl,T=kM);let S=u.dir*(u.ori==0?1:-1),D=E(l[S==1?r:o]),I=D,N=[],H=[];for(let F=S==1?r:o;F>=r&&F<=o;F+=S)if(c[F]!=null){let X=l[F],J=E(X);N.push(I=J),H.push(b(c[F]))}let V={stroke:n(N,H,A,x,T,_),fill:null,clip:null,band:null,gaps:null,flags:ml},k=V.stroke,[O,L]=v0(i,s);if(a.fill!=null||O!=0){let F=V.fill=new Path2D(k),j=a.fillTo(i,s,a.min,a.max,O),X=b(j);x(F,I,X),x(F,D,X)}if(!a.spanGaps){let F=[];F.push(...b0(l,c,r,o,S,E,e)),V.gaps=F=a.gaps(i,s,r,o,F),V.clip=Ff(F,u.ori,p,y,g,m)}return L!=0&&(V.band=L==2?[kr(i,s,r,o,k,-1),kr(i,s,r,o,k,1)]:kr(i,s,r,o,k,L)),V})}function r2(n){return s2(o2,n)}function o2(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var a0=new Set;function iM(){for(let n of a0)n.syncRect(!0)}gl&&(Xo(zI,hl,iM),Xo(HI,hl,iM,!0),Xo(Cf,hl,()=>{ai.pxRatio=Ge}));var a2=GM(),l2=zM();function sM(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>l0(r,o,t,e))}function c2(n,t){return n.map((e,i)=>i==0?{}:Bn({},t,e))}function l0(n,t,e,i){return Bn({},t==0?e:i,n)}function VM(n,t,e){return t==null?fl:[t,e]}var u2=VM;function h2(n,t,e){return t==null?fl:Pf(t,e,f0,!0)}function WM(n,t,e,i){return t==null?fl:Df(t,e,n.scales[i].log,!1)}var d2=WM;function $M(n,t,e,i){return t==null?fl:d0(t,e,n.scales[i].log,!1)}var f2=$M;function p2(n,t,e,i,s){let r=Li(Fb(n),Fb(t)),o=t-n,a=Os(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?go.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function rM(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=qn((e=+s)*Ge))+"px"),[n,t,e]}function m2(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=sn(t[2]*Ge,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ai(n,t,e){let i={mode:Oe(n.mode,1)},s=i.mode;function r(w,C,B,z){let Y=C.valToPct(w);return z+B*(C.dir==-1?1-Y:Y)}function o(w,C,B,z){let Y=C.valToPct(w);return z+B*(C.dir==-1?Y:1-Y)}function a(w,C,B,z){return C.ori==0?r(w,C,B,z):o(w,C,B,z)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vs(MI);if(n.id!=null&&(c.id=n.id),rs(c,n.class),n.title){let w=vs(EI,c);w.textContent=n.title}let u=Fs("canvas"),h=i.ctx=u.getContext("2d"),d=vs(TI,c);Xo("click",d,w=>{w.target===p&&(an!=aa||gn!=la)&&ii.click(i,w)},!0);let f=i.under=vs(AI,d);d.appendChild(u);let p=i.over=vs(RI,d);n=pl(n);let y=+Oe(n.pxAlign,1),g=eM(y);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let m=n.ms||.001,_=i.series=s==1?sM(n.series||[],Yb,Qb,!1):c2(n.series||[null],Kb),E=i.axes=sM(n.axes||[],Xb,jb,!0),b=i.scales={},A=i.bands=n.bands||[];A.forEach(w=>{w.fill=De(w.fill||null),w.dir=Oe(w.dir,-1)});let T=s==2?_[1].facets[0].scale:_[0].scale,x={axes:gr,series:Ce},S=(n.drawOrder||["axes","series"]).map(w=>x[w]);function D(w){let C=w.distr==3?B=>Br(B>0?B:w.clamp(i,B,w.min,w.max,w.key)):w.distr==4?B=>Zg(B,w.asinh):w.distr==100?B=>w.fwd(B):B=>B;return B=>{let z=C(B),{_min:Y,_max:tt}=w,ut=tt-Y;return(z-Y)/ut}}function I(w){let C=b[w];if(C==null){let B=(n.scales||du)[w]||du;if(B.from!=null){I(B.from);let z=Bn({},b[B.from],B,{key:w});z.valToPct=D(z),b[w]=z}else{C=b[w]=Bn({},w==T?DM:J3,B),C.key=w;let z=C.time,Y=C.range,tt=mo(Y);if((w!=T||s==2&&!z)&&(tt&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?Db:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?Db:{mode:1,hard:Y[1],soft:Y[1]}},tt=!1),!tt&&Uf(Y))){let ut=Y;Y=(xt,Tt,zt)=>Tt==null?fl:Pf(Tt,zt,ut)}C.range=De(Y||(z?u2:w==T?C.distr==3?d2:C.distr==4?f2:VM:C.distr==3?WM:C.distr==4?$M:h2)),C.auto=De(tt?!1:C.auto),C.clamp=De(C.clamp||j3),C._min=C._max=null,C.valToPct=D(C)}}}I("x"),I("y"),s==1&&_.forEach(w=>{I(w.scale)}),E.forEach(w=>{I(w.scale)});for(let w in n.scales)I(w);let N=b[T],H=N.distr,V,k;N.ori==0?(rs(c,SI),V=r,k=o):(rs(c,wI),V=o,k=r);let O={};for(let w in b){let C=b[w];(C.min!=null||C.max!=null)&&(O[w]={min:C.min,max:C.max},C.min=C.max=null)}let L=n.tzDate||(w=>new Date(qn(w/m))),F=n.fmtDate||g0,j=m==1?S3(L):T3(L),X=Wb(L,Vb(m==1?M3:E3,F)),J=qb(L,$b(R3,F)),et=[],dt=i.legend=Bn({},I3,n.legend),ft=i.cursor=Bn({},O3,{drag:{y:s==2}},n.cursor),st=dt.show,yt=ft.show,_t=dt.markers;dt.idxs=et,_t.width=De(_t.width),_t.dash=De(_t.dash),_t.stroke=De(_t.stroke),_t.fill=De(_t.fill);let At,Rt,Kt,me=[],jt=[],Ee,ve=!1,fe={};if(dt.live){let w=_[1]?_[1].values:null;ve=w!=null,Ee=ve?w(i,1,0):{_:0};for(let C in Ee)fe[C]=u0}if(st)if(At=Fs("table",NI,c),Kt=Fs("tbody",null,At),dt.mount(i,At),ve){Rt=Fs("thead",null,At,Kt);let w=Fs("tr",null,Rt);Fs("th",null,w);for(var mn in Ee)Fs("th",vb,w).textContent=mn}else rs(At,FI),dt.live&&rs(At,UI);let rn={show:!0},In={show:!1};function Ke(w,C){if(C==0&&(ve||!dt.live||s==2))return fl;let B=[],z=Fs("tr",OI,Kt,Kt.childNodes[C]);rs(z,w.class),w.show||rs(z,qo);let Y=Fs("th",null,z);if(_t.show){let xt=vs(BI,Y);if(C>0){let Tt=_t.width(i,C);Tt&&(xt.style.border=Tt+"px "+_t.dash(i,C)+" "+_t.stroke(i,C)),xt.style.background=_t.fill(i,C)}}let tt=vs(vb,Y);w.label instanceof HTMLElement?tt.appendChild(w.label):tt.textContent=w.label,C>0&&(_t.show||(tt.style.color=w.width>0?_t.stroke(i,C):_t.fill(i,C)),Ne("click",Y,xt=>{if(ft._lock)return;ae(xt);let Tt=_.indexOf(w);if((xt.ctrlKey||xt.metaKey)!=dt.isolate){let zt=_.some((Ht,Vt)=>Vt>0&&Vt!=Tt&&Ht.show);_.forEach((Ht,Vt)=>{Vt>0&&Ws(Vt,zt?Vt==Tt?rn:In:rn,!0,Fn.setSeries)})}else Ws(Tt,{show:!w.show},!0,Fn.setSeries)},!1),le&&Ne(wb,Y,xt=>{ft._lock||(ae(xt),Ws(_.indexOf(w),ua,!0,Fn.setSeries))},!1));for(var ut in Ee){let xt=Fs("td",kI,z);xt.textContent="--",B.push(xt)}return[z,B]}let Zn=new Map;function Ne(w,C,B,z=!0){let Y=Zn.get(C)||{},tt=ft.bind[w](i,C,B,z);tt&&(Xo(w,C,Y[w]=tt),Zn.set(C,Y))}function kn(w,C,B){let z=Zn.get(C)||{};for(let Y in z)(w==null||Y==w)&&(n0(Y,C,z[Y]),delete z[Y]);w==null&&Zn.delete(C)}let Mn=0,Ln=0,$=0,Ut=0,se=0,ge=0,Pt=se,tn=ge,Zt=$,ee=Ut,U=0,R=0,Z=0,mt=0;i.bbox={};let ct=!1,wt=!1,Et=!1,rt=!1,at=!1,vt=!1;function W(w,C,B){(B||w!=i.width||C!=i.height)&&lt(w,C),be(!1),Et=!0,wt=!0,li()}function lt(w,C){i.width=Mn=$=w,i.height=Ln=Ut=C,se=ge=0,Ct(),Jt();let B=i.bbox;U=B.left=Wo(se*Ge,.5),R=B.top=Wo(ge*Ge,.5),Z=B.width=Wo($*Ge,.5),mt=B.height=Wo(Ut*Ge,.5)}let ot=3;function It(){let w=!1,C=0;for(;!w;){C++;let B=sa(C),z=Vs(C);w=C==ot||B&&z,w||(lt(i.width,i.height),wt=!0)}}function Mt({width:w,height:C}){W(w,C)}i.setSize=Mt;function Ct(){let w=!1,C=!1,B=!1,z=!1;E.forEach((Y,tt)=>{if(Y.show&&Y._show){let{side:ut,_size:xt}=Y,Tt=ut%2,zt=Y.label!=null?Y.labelSize:0,Ht=xt+zt;Ht>0&&(Tt?($-=Ht,ut==3?(se+=Ht,z=!0):B=!0):(Ut-=Ht,ut==0?(ge+=Ht,w=!0):C=!0))}}),Hs[0]=w,Hs[1]=B,Hs[2]=C,Hs[3]=z,$-=Ms[1]+Ms[3],se+=Ms[3],Ut-=Ms[2]+Ms[0],ge+=Ms[0]}function Jt(){let w=se+$,C=ge+Ut,B=se,z=ge;function Y(tt,ut){switch(tt){case 1:return w+=ut,w-ut;case 2:return C+=ut,C-ut;case 3:return B-=ut,B+ut;case 0:return z-=ut,z+ut}}E.forEach((tt,ut)=>{if(tt.show&&tt._show){let xt=tt.side;tt._pos=Y(xt,tt._size),tt.label!=null&&(tt._lpos=Y(xt,tt.labelSize))}})}if(ft.dataIdx==null){let w=ft.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let B=w.prox=De(w.prox),z=w.bias??=0;ft.dataIdx=(Y,tt,ut,xt)=>{if(tt==0)return ut;let Tt=ut,zt=B(Y,tt,ut,xt)??nn,Ht=zt>=0&&zt<nn,Vt=N.ori==0?$:Ut,pe=ft.left,Be=t[0],Ue=t[tt];if(C.has(Ue[ut])){Tt=null;let Pe=null,re=null,Qt;if(z==0||z==-1)for(Qt=ut;Pe==null&&Qt-- >0;)C.has(Ue[Qt])||(Pe=Qt);if(z==0||z==1)for(Qt=ut;re==null&&Qt++<Ue.length;)C.has(Ue[Qt])||(re=Qt);if(Pe!=null||re!=null)if(Ht){let cn=Pe==null?-1/0:V(Be[Pe],N,Vt,0),En=re==null?1/0:V(Be[re],N,Vt,0),Qn=pe-cn,Qe=En-pe;Qn<=Qe?Qn<=zt&&(Tt=Pe):Qe<=zt&&(Tt=re)}else Tt=re==null?Pe:Pe==null?re:ut-Pe<=re-ut?Pe:re}else Ht&&Xn(pe-V(Be[ut],N,Vt,0))>zt&&(Tt=null);return Tt}}let ae=w=>{ft.event=w};ft.idxs=et,ft._lock=!1;let pt=ft.points;pt.show=De(pt.show),pt.size=De(pt.size),pt.stroke=De(pt.stroke),pt.width=De(pt.width),pt.fill=De(pt.fill);let $t=i.focus=Bn({},n.focus||{alpha:.3},ft.focus),le=$t.prox>=0,Nt=le&&pt.one,xe=[],on=[],_i=[];function Ul(w,C){let B=pt.show(i,C);if(B instanceof HTMLElement)return rs(B,DI),rs(B,w.class),hr(B,-10,-10,$,Ut),p.insertBefore(B,xe[C]),B}function ea(w,C){if(s==1||C>0){let B=s==1&&b[w.scale].time,z=w.value;w.value=B?kb(z)?qb(L,$b(z,F)):z||J:z||X3,w.label=w.label||(B?k3:B3)}if(Nt||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||a2||JI,w.fillTo=De(w.fillTo||K3),w.pxAlign=+Oe(w.pxAlign,y),w.pxRound=eM(w.pxAlign),w.stroke=De(w.stroke||null),w.fill=De(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let B=Y3(Li(1,w.width),1),z=w.points=Bn({},{size:B,width:Li(1,B*.2),stroke:w.stroke,space:B*2,paths:l2,_stroke:null,_fill:null},w.points);z.show=De(z.show),z.filter=De(z.filter),z.fill=De(z.fill),z.stroke=De(z.stroke),z.paths=De(z.paths),z.pxAlign=w.pxAlign}if(st){let B=Ke(w,C);me.splice(C,0,B[0]),jt.splice(C,0,B[1]),dt.values.push(null)}if(yt){et.splice(C,0,null);let B=null;Nt?C==0&&(B=Ul(w,C)):C>0&&(B=Ul(w,C)),xe.splice(C,0,B),on.splice(C,0,0),_i.splice(C,0,0)}Kn("addSeries",C)}function _p(w,C){C=C??_.length,w=s==1?l0(w,C,Yb,Qb):l0(w,C,{},Kb),_.splice(C,0,w),ea(_[C],C)}i.addSeries=_p;function Tu(w){if(_.splice(w,1),st){dt.values.splice(w,1),jt.splice(w,1);let C=me.splice(w,1)[0];kn(null,C.firstChild),C.remove()}yt&&(et.splice(w,1),xe.splice(w,1)[0].remove(),on.splice(w,1),_i.splice(w,1)),Kn("delSeries",w)}i.delSeries=Tu;let Hs=[!1,!1,!1,!1];function fr(w,C){if(w._show=w.show,w.show){let B=w.side%2,z=b[w.scale];z==null&&(w.scale=B?_[1].scale:T,z=b[w.scale]);let Y=z.time;w.size=De(w.size),w.space=De(w.space),w.rotate=De(w.rotate),mo(w.incrs)&&w.incrs.forEach(ut=>{!go.has(ut)&&go.set(ut,pM(ut))}),w.incrs=De(w.incrs||(z.distr==2?y3:Y?m==1?b3:w3:$o)),w.splits=De(w.splits||(Y&&z.distr==1?j:z.distr==3?s0:z.distr==4?G3:H3)),w.stroke=De(w.stroke),w.grid.stroke=De(w.grid.stroke),w.ticks.stroke=De(w.ticks.stroke),w.border.stroke=De(w.border.stroke);let tt=w.values;w.values=mo(tt)&&!mo(tt[0])?De(tt):Y?mo(tt)?Wb(L,Vb(tt,F)):kb(tt)?A3(L,tt):tt||X:tt||z3,w.filter=De(w.filter||(z.distr>=3&&z.log==10?$3:z.distr==3&&z.log==2?q3:dM)),w.font=rM(w.font),w.labelFont=rM(w.labelFont),w._size=w.size(i,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Hs[C]=!0,w._el=vs(CI,d))}}function pr(w,C,B,z){let[Y,tt,ut,xt]=B,Tt=C%2,zt=0;return Tt==0&&(xt||tt)&&(zt=C==0&&!Y||C==2&&!ut?qn(Xb.size/3):0),Tt==1&&(Y||ut)&&(zt=C==1&&!tt||C==3&&!xt?qn(jb.size/2):0),zt}let Fl=i.padding=(n.padding||[pr,pr,pr,pr]).map(w=>De(Oe(w,pr))),Ms=i._padding=Fl.map((w,C)=>w(i,C,Hs,0)),Sn,Cn=null,Pn=null,Gs=s==1?_[0].idxs:null,qi=null,Hr=!1;function Ol(w,C){if(t=w??[],i.data=i._data=t,s==2){Sn=0;for(let B=1;B<_.length;B++)Sn+=t[B][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),qi=t[0],Sn=qi.length;let B=t;if(H==2){B=t.slice();let z=B[0]=Array(Sn);for(let Y=0;Y<Sn;Y++)z[Y]=Y}i._data=t=B}if(be(!0),Kn("setData"),H==2&&(Et=!0),C!==!1){let B=N;B.auto(i,Hr)?Bl():Wr(T,B.min,B.max),rt=rt||ft.left>=0,vt=!0,li()}}i.setData=Ol;function Bl(){Hr=!0;let w,C;s==1&&(Sn>0?(Cn=Gs[0]=0,Pn=Gs[1]=Sn-1,w=t[0][Cn],C=t[0][Pn],H==2?(w=Cn,C=Pn):w==C&&(H==3?[w,C]=Df(w,w,N.log,!1):H==4?[w,C]=d0(w,w,N.log,!1):N.time?C=w+qn(86400/m):[w,C]=Pf(w,C,f0,!0))):(Cn=Gs[0]=w=null,Pn=Gs[1]=C=null)),Wr(T,w,C)}let na,Gr,ia,P,q,it,K,Q,Lt,Ft;function Dt(w,C,B,z,Y,tt){w??=Mb,B??=m0,z??="butt",Y??=Mb,tt??="round",w!=na&&(h.strokeStyle=na=w),Y!=Gr&&(h.fillStyle=Gr=Y),C!=ia&&(h.lineWidth=ia=C),tt!=q&&(h.lineJoin=q=tt),z!=it&&(h.lineCap=it=z),B!=P&&h.setLineDash(P=B)}function Ot(w,C,B,z){C!=Gr&&(h.fillStyle=Gr=C),w!=K&&(h.font=K=w),B!=Q&&(h.textAlign=Q=B),z!=Lt&&(h.textBaseline=Lt=z)}function Xt(w,C,B,z,Y=0){if(z.length>0&&w.auto(i,Hr)&&(C==null||C.min==null)){let tt=Oe(Cn,0),ut=Oe(Pn,z.length-1),xt=B.min==null?$I(z,tt,ut,Y,w.distr==3):[B.min,B.max];w.min=Bs(w.min,B.min=xt[0]),w.max=Li(w.max,B.max=xt[1])}}let ce={min:null,max:null};function Re(){for(let z in b){let Y=b[z];O[z]==null&&(Y.min==null||O[T]!=null&&Y.auto(i,Hr))&&(O[z]=ce)}for(let z in b){let Y=b[z];O[z]==null&&Y.from!=null&&O[Y.from]!=null&&(O[z]=ce)}O[T]!=null&&be(!0);let w={};for(let z in O){let Y=O[z];if(Y!=null){let tt=w[z]=pl(b[z],t3);if(Y.min!=null)Bn(tt,Y);else if(z!=T||s==2)if(Sn==0&&tt.from==null){let ut=tt.range(i,null,null,z);tt.min=ut[0],tt.max=ut[1]}else tt.min=nn,tt.max=-nn}}if(Sn>0){_.forEach((z,Y)=>{if(s==1){let tt=z.scale,ut=O[tt];if(ut==null)return;let xt=w[tt];if(Y==0){let Tt=xt.range(i,xt.min,xt.max,tt);xt.min=Tt[0],xt.max=Tt[1],Cn=Os(xt.min,t[0]),Pn=Os(xt.max,t[0]),Pn-Cn>1&&(t[0][Cn]<xt.min&&Cn++,t[0][Pn]>xt.max&&Pn--),z.min=qi[Cn],z.max=qi[Pn]}else z.show&&z.auto&&Xt(xt,ut,z,t[Y],z.sorted);z.idxs[0]=Cn,z.idxs[1]=Pn}else if(Y>0&&z.show&&z.auto){let[tt,ut]=z.facets,xt=tt.scale,Tt=ut.scale,[zt,Ht]=t[Y],Vt=w[xt],pe=w[Tt];Vt!=null&&Xt(Vt,O[xt],tt,zt,tt.sorted),pe!=null&&Xt(pe,O[Tt],ut,Ht,ut.sorted),z.min=ut.min,z.max=ut.max}});for(let z in w){let Y=w[z],tt=O[z];if(Y.from==null&&(tt==null||tt.min==null)){let ut=Y.range(i,Y.min==nn?null:Y.min,Y.max==-nn?null:Y.max,z);Y.min=ut[0],Y.max=ut[1]}}}for(let z in w){let Y=w[z];if(Y.from!=null){let tt=w[Y.from];if(tt.min==null)Y.min=Y.max=null;else{let ut=Y.range(i,tt.min,tt.max,z);Y.min=ut[0],Y.max=ut[1]}}}let C={},B=!1;for(let z in w){let Y=w[z],tt=b[z];if(tt.min!=Y.min||tt.max!=Y.max){tt.min=Y.min,tt.max=Y.max;let ut=tt.distr;tt._min=ut==3?Br(tt.min):ut==4?Zg(tt.min,tt.asinh):ut==100?tt.fwd(tt.min):tt.min,tt._max=ut==3?Br(tt.max):ut==4?Zg(tt.max,tt.asinh):ut==100?tt.fwd(tt.max):tt.max,C[z]=B=!0}}if(B){_.forEach((z,Y)=>{s==2?Y>0&&C.y&&(z._paths=null):C[z.scale]&&(z._paths=null)});for(let z in C)Et=!0,Kn("setScale",z);yt&&ft.left>=0&&(rt=vt=!0)}for(let z in O)O[z]=null}function qt(w){let C=i0(Cn-1,0,Sn-1),B=i0(Pn+1,0,Sn-1);for(;w[C]==null&&C>0;)C--;for(;w[B]==null&&B<Sn-1;)B++;return[C,B]}function Ce(){if(Sn>0){let w=_.some(C=>C._focus)&&Ft!=$t.alpha;w&&(h.globalAlpha=Ft=$t.alpha),_.forEach((C,B)=>{if(B>0&&C.show&&(yn(B,!1),yn(B,!0),C._paths==null)){let z=Ft;Ft!=C.alpha&&(h.globalAlpha=Ft=C.alpha);let Y=s==2?[0,t[B][0].length-1]:qt(t[B]);C._paths=C.paths(i,B,Y[0],Y[1]),Ft!=z&&(h.globalAlpha=Ft=z)}}),_.forEach((C,B)=>{if(B>0&&C.show){let z=Ft;Ft!=C.alpha&&(h.globalAlpha=Ft=C.alpha),C._paths!=null&&Xe(B,!1);{let Y=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,B,Cn,Pn,Y),ut=C.points.filter(i,B,tt,Y);(tt||ut)&&(C.points._paths=C.points.paths(i,B,Cn,Pn,ut),Xe(B,!0))}Ft!=z&&(h.globalAlpha=Ft=z),Kn("drawSeries",B)}}),w&&(h.globalAlpha=Ft=1)}}function yn(w,C){let B=C?_[w].points:_[w];B._stroke=B.stroke(i,w),B._fill=B.fill(i,w)}function Xe(w,C){let B=C?_[w].points:_[w],{stroke:z,fill:Y,clip:tt,flags:ut,_stroke:xt=B._stroke,_fill:Tt=B._fill,_width:zt=B.width}=B._paths;zt=sn(zt*Ge,3);let Ht=null,Vt=zt%2/2;C&&Tt==null&&(Tt=zt>0?"#fff":xt);let pe=B.pxAlign==1&&Vt>0;if(pe&&h.translate(Vt,Vt),!C){let Be=U-zt/2,Ue=R-zt/2,Pe=Z+zt,re=mt+zt;Ht=new Path2D,Ht.rect(Be,Ue,Pe,re)}C?Gt(xt,zt,B.dash,B.cap,Tt,z,Y,ut,tt):Ye(w,xt,zt,B.dash,B.cap,Tt,z,Y,ut,Ht,tt),pe&&h.translate(-Vt,-Vt)}function Ye(w,C,B,z,Y,tt,ut,xt,Tt,zt,Ht){let Vt=!1;Tt!=0&&A.forEach((pe,Be)=>{if(pe.series[0]==w){let Ue=_[pe.series[1]],Pe=t[pe.series[1]],re=(Ue._paths||du).band;mo(re)&&(re=pe.dir==1?re[0]:re[1]);let Qt,cn=null;Ue.show&&re&&XI(Pe,Cn,Pn)?(cn=pe.fill(i,Be)||tt,Qt=Ue._paths.clip):re=null,Gt(C,B,z,Y,cn,ut,xt,Tt,zt,Ht,Qt,re),Vt=!0}}),Vt||Gt(C,B,z,Y,tt,ut,xt,Tt,zt,Ht)}let zn=ml|o0;function Gt(w,C,B,z,Y,tt,ut,xt,Tt,zt,Ht,Vt){Dt(w,C,B,z,Y),(Tt||zt||Vt)&&(h.save(),Tt&&h.clip(Tt),zt&&h.clip(zt)),Vt?(xt&zn)==zn?(h.clip(Vt),Ht&&h.clip(Ht),Ie(Y,ut),Dn(w,tt,C)):xt&o0?(Ie(Y,ut),h.clip(Vt),Dn(w,tt,C)):xt&ml&&(h.save(),h.clip(Vt),Ht&&h.clip(Ht),Ie(Y,ut),h.restore(),Dn(w,tt,C)):(Ie(Y,ut),Dn(w,tt,C)),(Tt||zt||Vt)&&h.restore()}function Dn(w,C,B){B>0&&(C instanceof Map?C.forEach((z,Y)=>{h.strokeStyle=na=Y,h.stroke(z)}):C!=null&&w&&h.stroke(C))}function Ie(w,C){C instanceof Map?C.forEach((B,z)=>{h.fillStyle=Gr=z,h.fill(B)}):C!=null&&w&&h.fill(C)}function mr(w,C,B,z){let Y=E[w],tt;if(z<=0)tt=[0,0];else{let ut=Y._space=Y.space(i,w,C,B,z),xt=Y._incrs=Y.incrs(i,w,C,B,z,ut);tt=p2(C,B,xt,z,ut)}return Y._found=tt}function Nn(w,C,B,z,Y,tt,ut,xt,Tt,zt){let Ht=ut%2/2;y==1&&h.translate(Ht,Ht),Dt(xt,ut,Tt,zt,xt),h.beginPath();let Vt,pe,Be,Ue,Pe=Y+(z==0||z==3?-tt:tt);B==0?(pe=Y,Ue=Pe):(Vt=Y,Be=Pe);for(let re=0;re<w.length;re++)C[re]!=null&&(B==0?Vt=Be=w[re]:pe=Ue=w[re],h.moveTo(Vt,pe),h.lineTo(Be,Ue));h.stroke(),y==1&&h.translate(-Ht,-Ht)}function sa(w){let C=!0;return E.forEach((B,z)=>{if(!B.show)return;let Y=b[B.scale];if(Y.min==null){B._show&&(C=!1,B._show=!1,be(!1));return}else B._show||(C=!1,B._show=!0,be(!1));let tt=B.side,ut=tt%2,{min:xt,max:Tt}=Y,[zt,Ht]=mr(z,xt,Tt,ut==0?$:Ut);if(Ht==0)return;let Vt=Y.distr==2,pe=B._splits=B.splits(i,z,xt,Tt,zt,Ht,Vt),Be=Y.distr==2?pe.map(Qt=>qi[Qt]):pe,Ue=Y.distr==2?qi[pe[1]]-qi[pe[0]]:zt,Pe=B._values=B.values(i,B.filter(i,Be,z,Ht,Ue),z,Ht,Ue);B._rotate=tt==2?B.rotate(i,Pe,z,Ht):0;let re=B._size;B._size=bs(B.size(i,Pe,z,w)),re!=null&&B._size!=re&&(C=!1)}),C}function Vs(w){let C=!0;return Fl.forEach((B,z)=>{let Y=B(i,z,Hs,w);Y!=Ms[z]&&(C=!1),Ms[z]=Y}),C}function gr(){for(let w=0;w<E.length;w++){let C=E[w];if(!C.show||!C._show)continue;let B=C.side,z=B%2,Y,tt,ut=C.stroke(i,w),xt=B==0||B==3?-1:1,[Tt,zt]=C._found;if(C.label!=null){let vi=C.labelGap*xt,Zi=qn((C._lpos+vi)*Ge);Ot(C.labelFont[0],ut,"center",B==2?"top":bb),h.save(),z==1?(Y=tt=0,h.translate(Zi,qn(R+mt/2)),h.rotate((B==3?-Rf:Rf)/2)):(Y=qn(U+Z/2),tt=Zi);let wo=uM(C.label)?C.label(i,w,Tt,zt):C.label;h.fillText(wo,Y,tt),h.restore()}if(zt==0)continue;let Ht=b[C.scale],Vt=z==0?Z:mt,pe=z==0?U:R,Be=C._splits,Ue=Ht.distr==2?Be.map(vi=>qi[vi]):Be,Pe=Ht.distr==2?qi[Be[1]]-qi[Be[0]]:Tt,re=C.ticks,Qt=C.border,cn=re.show?re.size:0,En=qn(cn*Ge),Qn=qn((C.alignTo==2?C._size-cn-C.gap:C.gap)*Ge),Qe=C._rotate*-Rf/180,Tn=g(C._pos*Ge),Xi=(En+Qn)*xt,yi=Tn+Xi;tt=z==0?yi:0,Y=z==1?yi:0;let ls=C.font[0],Ss=C.align==1?cl:C.align==2?qg:Qe>0?cl:Qe<0?qg:z==0?"center":B==3?qg:cl,qs=Qe||z==1?"middle":B==2?"top":bb;Ot(ls,ut,Ss,qs);let Yi=C.font[1]*C.lineGap,cs=Be.map(vi=>g(a(vi,Ht,Vt,pe))),ws=C._values;for(let vi=0;vi<ws.length;vi++){let Zi=ws[vi];if(Zi!=null){z==0?Y=cs[vi]:tt=cs[vi],Zi=""+Zi;let wo=Zi.indexOf(`
`)==-1?[Zi]:Zi.split(/\n/gm);for(let bi=0;bi<wo.length;bi++){let E_=wo[bi];Qe?(h.save(),h.translate(Y,tt+bi*Yi),h.rotate(Qe),h.fillText(E_,0,0),h.restore()):h.fillText(E_,Y,tt+bi*Yi)}}}re.show&&Nn(cs,re.filter(i,Ue,w,zt,Pe),z,B,Tn,En,sn(re.width*Ge,3),re.stroke(i,w),re.dash,re.cap);let Xs=C.grid;Xs.show&&Nn(cs,Xs.filter(i,Ue,w,zt,Pe),z,z==0?2:1,z==0?R:U,z==0?mt:Z,sn(Xs.width*Ge,3),Xs.stroke(i,w),Xs.dash,Xs.cap),Qt.show&&Nn([Tn],[1],z==0?1:0,z==0?1:2,z==1?R:U,z==1?mt:Z,sn(Qt.width*Ge,3),Qt.stroke(i,w),Qt.dash,Qt.cap)}Kn("drawAxes")}function be(w){_.forEach((C,B)=>{B>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(z=>{z.min=null,z.max=null})))})}let wn=!1,xi=!1,Ze=[];function Un(){xi=!1;for(let w=0;w<Ze.length;w++)Kn(...Ze[w]);Ze.length=0}function li(){wn||(a3(a_),wn=!0)}function Au(w,C=!1){wn=!0,xi=C,w(i),a_(),C&&Ze.length>0&&queueMicrotask(Un)}i.batch=Au;function a_(){if(ct&&(Re(),ct=!1),Et&&(It(),Et=!1),wt){if(pn(f,cl,se),pn(f,"top",ge),pn(f,lu,$),pn(f,cu,Ut),pn(p,cl,se),pn(p,"top",ge),pn(p,lu,$),pn(p,cu,Ut),pn(d,lu,Mn),pn(d,cu,Ln),u.width=qn(Mn*Ge),u.height=qn(Ln*Ge),E.forEach(({_el:w,_show:C,_size:B,_pos:z,side:Y})=>{if(w!=null)if(C){let tt=Y===3||Y===0?B:0,ut=Y%2==1;pn(w,ut?"left":"top",z-tt),pn(w,ut?"width":"height",B),pn(w,ut?"top":"left",ut?ge:se),pn(w,ut?"height":"width",ut?Ut:$),e0(w,qo)}else rs(w,qo)}),na=Gr=ia=q=it=K=Q=Lt=P=null,Ft=1,Hl(!0),se!=Pt||ge!=tn||$!=Zt||Ut!=ee){be(!1);let w=$/Zt,C=Ut/ee;if(yt&&!rt&&ft.left>=0){ft.left*=w,ft.top*=C,ra&&hr(ra,qn(ft.left),0,$,Ut),oa&&hr(oa,0,qn(ft.top),$,Ut);for(let B=0;B<xe.length;B++){let z=xe[B];z!=null&&(on[B]*=w,_i[B]*=C,hr(z,bs(on[B]),bs(_i[B]),$,Ut))}}if(ln.show&&!at&&ln.left>=0&&ln.width>0){ln.left*=w,ln.width*=w,ln.top*=C,ln.height*=C;for(let B in Sp)pn(ca,B,ln[B])}Pt=se,tn=ge,Zt=$,ee=Ut}Kn("setSize"),wt=!1}Mn>0&&Ln>0&&(h.clearRect(0,0,u.width,u.height),Kn("drawClear"),S.forEach(w=>w()),Kn("draw")),ln.show&&at&&(Ru(ln),at=!1),yt&&rt&&(So(null,!0,!1),rt=!1),dt.show&&dt.live&&vt&&(bp(),vt=!1),l||(l=!0,i.status=1,Kn("ready")),Hr=!1,wn=!1}i.redraw=(w,C)=>{Et=C||!1,w!==!1?Wr(T,N.min,N.max):li()};function xp(w,C){let B=b[w];if(B.from==null){if(Sn==0){let z=B.range(i,C.min,C.max,w);C.min=z[0],C.max=z[1]}if(C.min>C.max){let z=C.min;C.min=C.max,C.max=z}if(Sn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==T&&B.distr==2&&Sn>0&&(C.min=Os(C.min,t[0]),C.max=Os(C.max,t[0]),C.min==C.max&&C.max++),O[w]=C,ct=!0,li()}}i.setScale=xp;let yp,vp,ra,oa,l_,c_,aa,la,u_,h_,an,gn,Vr=!1,ii=ft.drag,jn=ii.x,Jn=ii.y;yt&&(ft.x&&(yp=vs(II,p)),ft.y&&(vp=vs(LI,p)),N.ori==0?(ra=yp,oa=vp):(ra=vp,oa=yp),an=ft.left,gn=ft.top);let ln=i.select=Bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ca=ln.show?vs(PI,ln.over?p:f):null;function Ru(w,C){if(ln.show){for(let B in w)ln[B]=w[B],B in Sp&&pn(ca,B,w[B]);C!==!1&&Kn("setSelect")}}i.setSelect=Ru;function jw(w){if(_[w].show)st&&e0(me[w],qo);else if(st&&rs(me[w],qo),yt){let B=Nt?xe[0]:xe[w];B!=null&&hr(B,-10,-10,$,Ut)}}function Wr(w,C,B){xp(w,{min:C,max:B})}function Ws(w,C,B,z){C.focus!=null&&e1(w),C.show!=null&&_.forEach((Y,tt)=>{tt>0&&(w==tt||w==null)&&(Y.show=C.show,jw(tt),s==2?(Wr(Y.facets[0].scale,null,null),Wr(Y.facets[1].scale,null,null)):Wr(Y.scale,null,null),li())}),B!==!1&&Kn("setSeries",w,C),z&&Gl("setSeries",i,w,C)}i.setSeries=Ws;function Jw(w,C){Bn(A[w],C)}function Kw(w,C){w.fill=De(w.fill||null),w.dir=Oe(w.dir,-1),C=C??A.length,A.splice(C,0,w)}function Qw(w){w==null?A.length=0:A.splice(w,1)}i.addBand=Kw,i.setBand=Jw,i.delBand=Qw;function t1(w,C){_[w].alpha=C,yt&&xe[w]!=null&&(xe[w].style.opacity=C),st&&me[w]&&(me[w].style.opacity=C)}let _r,$r,Mo,ua={focus:!0};function e1(w){if(w!=Mo){let C=w==null,B=$t.alpha!=1;_.forEach((z,Y)=>{if(s==1||Y>0){let tt=C||Y==0||Y==w;z._focus=C?null:tt,B&&t1(Y,tt?1:$t.alpha)}}),Mo=w,B&&li()}}st&&le&&Ne(Eb,At,w=>{ft._lock||(ae(w),Mo!=null&&Ws(null,ua,!0,Fn.setSeries))});function $s(w,C,B){let z=b[C];B&&(w=w/Ge-(z.ori==1?ge:se));let Y=$;z.ori==1&&(Y=Ut,w=Y-w),z.dir==-1&&(w=Y-w);let tt=z._min,ut=z._max,xt=w/Y,Tt=tt+(ut-tt)*xt,zt=z.distr;return zt==3?dl(10,Tt):zt==4?ZI(Tt,z.asinh):zt==100?z.bwd(Tt):Tt}function n1(w,C){let B=$s(w,T,C);return Os(B,t[0],Cn,Pn)}i.valToIdx=w=>Os(w,t[0]),i.posToIdx=n1,i.posToVal=$s,i.valToPos=(w,C,B)=>b[C].ori==0?r(w,b[C],B?Z:$,B?U:0):o(w,b[C],B?mt:Ut,B?R:0),i.setCursor=(w,C,B)=>{an=w.left,gn=w.top,So(null,C,B)};function d_(w,C){pn(ca,cl,ln.left=w),pn(ca,lu,ln.width=C)}function f_(w,C){pn(ca,"top",ln.top=w),pn(ca,cu,ln.height=C)}let kl=N.ori==0?d_:f_,zl=N.ori==1?d_:f_;function i1(){if(st&&dt.live)for(let w=s==2?1:0;w<_.length;w++){if(w==0&&ve)continue;let C=dt.values[w],B=0;for(let z in C)jt[w][B++].firstChild.nodeValue=C[z]}}function bp(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((B,z)=>{et[z]=B}):QI(w.idx)||et.fill(w.idx),dt.idx=et[0]),st&&dt.live){for(let B=0;B<_.length;B++)(B>0||s==1&&!ve)&&s1(B,et[B]);i1()}vt=!1,C!==!1&&Kn("setLegend")}i.setLegend=bp;function s1(w,C){let B=_[w],z=w==0&&H==2?qi:t[w],Y;ve?Y=B.values(i,w,C)??fe:(Y=B.value(i,C==null?null:z[C],w,C),Y=Y==null?fe:{_:Y}),dt.values[w]=Y}function So(w,C,B){u_=an,h_=gn,[an,gn]=ft.move(i,an,gn),ft.left=an,ft.top=gn,yt&&(ra&&hr(ra,qn(an),0,$,Ut),oa&&hr(oa,0,qn(gn),$,Ut));let z,Y=Cn>Pn;_r=nn,$r=null;let tt=N.ori==0?$:Ut,ut=N.ori==1?$:Ut;if(an<0||Sn==0||Y){z=ft.idx=null;for(let xt=0;xt<_.length;xt++){let Tt=xe[xt];Tt!=null&&hr(Tt,-10,-10,$,Ut)}le&&Ws(null,ua,!0,w==null&&Fn.setSeries),dt.live&&(et.fill(z),vt=!0)}else{let xt,Tt,zt;s==1&&(xt=N.ori==0?an:gn,Tt=$s(xt,T),z=ft.idx=Os(Tt,t[0],Cn,Pn),zt=V(t[0][z],N,tt,0));let Ht=-10,Vt=-10,pe=0,Be=0,Ue=!0,Pe="",re="";for(let Qt=s==2?1:0;Qt<_.length;Qt++){let cn=_[Qt],En=et[Qt],Qn=En==null?null:s==1?t[Qt][En]:t[Qt][1][En],Qe=ft.dataIdx(i,Qt,z,Tt),Tn=Qe==null?null:s==1?t[Qt][Qe]:t[Qt][1][Qe];if(vt=vt||Tn!=Qn||Qe!=En,et[Qt]=Qe,Qt>0&&cn.show){let Xi=Qe==null?-10:Qe==z?zt:V(s==1?t[0][Qe]:t[Qt][0][Qe],N,tt,0),yi=Tn==null?-10:k(Tn,s==1?b[cn.scale]:b[cn.facets[1].scale],ut,0);if(le&&Tn!=null){let ls=N.ori==1?an:gn,Ss=Xn($t.dist(i,Qt,Qe,yi,ls));if(Ss<_r){let qs=$t.bias;if(qs!=0){let Yi=$s(ls,cn.scale),cs=Tn>=0?1:-1,ws=Yi>=0?1:-1;ws==cs&&(ws==1?qs==1?Tn>=Yi:Tn<=Yi:qs==1?Tn<=Yi:Tn>=Yi)&&(_r=Ss,$r=Qt)}else _r=Ss,$r=Qt}}if(vt||Nt){let ls,Ss;N.ori==0?(ls=Xi,Ss=yi):(ls=yi,Ss=Xi);let qs,Yi,cs,ws,Xs,vi,Zi=!0,wo=pt.bbox;if(wo!=null){Zi=!1;let bi=wo(i,Qt);cs=bi.left,ws=bi.top,qs=bi.width,Yi=bi.height}else cs=ls,ws=Ss,qs=Yi=pt.size(i,Qt);if(vi=pt.fill(i,Qt),Xs=pt.stroke(i,Qt),Nt)Qt==$r&&_r<=$t.prox&&(Ht=cs,Vt=ws,pe=qs,Be=Yi,Ue=Zi,Pe=vi,re=Xs);else{let bi=xe[Qt];bi!=null&&(on[Qt]=cs,_i[Qt]=ws,Lb(bi,qs,Yi,Zi),Pb(bi,vi,Xs),hr(bi,bs(cs),bs(ws),$,Ut))}}}}if(Nt){let Qt=$t.prox,cn=Mo==null?_r<=Qt:_r>Qt||$r!=Mo;if(vt||cn){let En=xe[0];En!=null&&(on[0]=Ht,_i[0]=Vt,Lb(En,pe,Be,Ue),Pb(En,Pe,re),hr(En,bs(Ht),bs(Vt),$,Ut))}}}if(ln.show&&Vr)if(w!=null){let[xt,Tt]=Fn.scales,[zt,Ht]=Fn.match,[Vt,pe]=w.cursor.sync.scales,Be=w.cursor.drag;if(jn=Be._x,Jn=Be._y,jn||Jn){let{left:Ue,top:Pe,width:re,height:Qt}=w.select,cn=w.scales[Vt].ori,En=w.posToVal,Qn,Qe,Tn,Xi,yi,ls=xt!=null&&zt(xt,Vt),Ss=Tt!=null&&Ht(Tt,pe);ls&&jn?(cn==0?(Qn=Ue,Qe=re):(Qn=Pe,Qe=Qt),Tn=b[xt],Xi=V(En(Qn,Vt),Tn,tt,0),yi=V(En(Qn+Qe,Vt),Tn,tt,0),kl(Bs(Xi,yi),Xn(yi-Xi))):kl(0,tt),Ss&&Jn?(cn==1?(Qn=Ue,Qe=re):(Qn=Pe,Qe=Qt),Tn=b[Tt],Xi=k(En(Qn,pe),Tn,ut,0),yi=k(En(Qn+Qe,pe),Tn,ut,0),zl(Bs(Xi,yi),Xn(yi-Xi))):zl(0,ut)}else wp()}else{let xt=Xn(u_-l_),Tt=Xn(h_-c_);if(N.ori==1){let pe=xt;xt=Tt,Tt=pe}jn=ii.x&&xt>=ii.dist,Jn=ii.y&&Tt>=ii.dist;let zt=ii.uni;zt!=null?jn&&Jn&&(jn=xt>=zt,Jn=Tt>=zt,!jn&&!Jn&&(Tt>xt?Jn=!0:jn=!0)):ii.x&&ii.y&&(jn||Jn)&&(jn=Jn=!0);let Ht,Vt;jn&&(N.ori==0?(Ht=aa,Vt=an):(Ht=la,Vt=gn),kl(Bs(Ht,Vt),Xn(Vt-Ht)),Jn||zl(0,ut)),Jn&&(N.ori==1?(Ht=aa,Vt=an):(Ht=la,Vt=gn),zl(Bs(Ht,Vt),Xn(Vt-Ht)),jn||kl(0,tt)),!jn&&!Jn&&(kl(0,0),zl(0,0))}if(ii._x=jn,ii._y=Jn,w==null){if(B){if(w_!=null){let[xt,Tt]=Fn.scales;Fn.values[0]=xt!=null?$s(N.ori==0?an:gn,xt):null,Fn.values[1]=Tt!=null?$s(N.ori==1?an:gn,Tt):null}Gl(Xg,i,an,gn,$,Ut,z)}if(le){let xt=B&&Fn.setSeries,Tt=$t.prox;Mo==null?_r<=Tt&&Ws($r,ua,!0,xt):_r>Tt?Ws(null,ua,!0,xt):$r!=Mo&&Ws($r,ua,!0,xt)}}vt&&(dt.idx=z,bp()),C!==!1&&Kn("setCursor")}let qr=null;Object.defineProperty(i,"rect",{get(){return qr==null&&Hl(!1),qr}});function Hl(w=!1){w?qr=null:(qr=p.getBoundingClientRect(),Kn("syncRect",qr))}function p_(w,C,B,z,Y,tt,ut){ft._lock||Vr&&w!=null&&w.movementX==0&&w.movementY==0||(Mp(w,C,B,z,Y,tt,ut,!1,w!=null),w!=null?So(null,!0,!0):So(C,!0,!1))}function Mp(w,C,B,z,Y,tt,ut,xt,Tt){if(qr==null&&Hl(!1),ae(w),w!=null)B=w.clientX-qr.left,z=w.clientY-qr.top;else{if(B<0||z<0){an=-10,gn=-10;return}let[zt,Ht]=Fn.scales,Vt=C.cursor.sync,[pe,Be]=Vt.values,[Ue,Pe]=Vt.scales,[re,Qt]=Fn.match,cn=C.axes[0].side%2==1,En=N.ori==0?$:Ut,Qn=N.ori==1?$:Ut,Qe=cn?tt:Y,Tn=cn?Y:tt,Xi=cn?z:B,yi=cn?B:z;if(Ue!=null?B=re(zt,Ue)?a(pe,b[zt],En,0):-10:B=En*(Xi/Qe),Pe!=null?z=Qt(Ht,Pe)?a(Be,b[Ht],Qn,0):-10:z=Qn*(yi/Tn),N.ori==1){let ls=B;B=z,z=ls}}Tt&&(C==null||C.cursor.event.type==Xg)&&((B<=1||B>=$-1)&&(B=Wo(B,$)),(z<=1||z>=Ut-1)&&(z=Wo(z,Ut))),xt?(l_=B,c_=z,[aa,la]=ft.move(i,B,z)):(an=B,gn=z)}let Sp={width:0,height:0,left:0,top:0};function wp(){Ru(Sp,!1)}let m_,g_,__,x_;function y_(w,C,B,z,Y,tt,ut){Vr=!0,jn=Jn=ii._x=ii._y=!1,Mp(w,C,B,z,Y,tt,ut,!0,!1),w!=null&&(Ne(Yg,Qg,v_,!1),Gl(Sb,i,aa,la,$,Ut,null));let{left:xt,top:Tt,width:zt,height:Ht}=ln;m_=xt,g_=Tt,__=zt,x_=Ht}function v_(w,C,B,z,Y,tt,ut){Vr=ii._x=ii._y=!1,Mp(w,C,B,z,Y,tt,ut,!1,!0);let{left:xt,top:Tt,width:zt,height:Ht}=ln,Vt=zt>0||Ht>0,pe=m_!=xt||g_!=Tt||__!=zt||x_!=Ht;if(Vt&&pe&&Ru(ln),ii.setScale&&Vt&&pe){let Be=xt,Ue=zt,Pe=Tt,re=Ht;if(N.ori==1&&(Be=Tt,Ue=Ht,Pe=xt,re=zt),jn&&Wr(T,$s(Be,T),$s(Be+Ue,T)),Jn)for(let Qt in b){let cn=b[Qt];Qt!=T&&cn.from==null&&cn.min!=nn&&Wr(Qt,$s(Pe+re,Qt),$s(Pe,Qt))}wp()}else ft.lock&&(ft._lock=!ft._lock,So(C,!0,w!=null));w!=null&&(kn(Yg,Qg),Gl(Yg,i,an,gn,$,Ut,null))}function r1(w,C,B,z,Y,tt,ut){if(ft._lock)return;ae(w);let xt=Vr;if(Vr){let Tt=!0,zt=!0,Ht=10,Vt,pe;N.ori==0?(Vt=jn,pe=Jn):(Vt=Jn,pe=jn),Vt&&pe&&(Tt=an<=Ht||an>=$-Ht,zt=gn<=Ht||gn>=Ut-Ht),Vt&&Tt&&(an=an<aa?0:$),pe&&zt&&(gn=gn<la?0:Ut),So(null,!0,!0),Vr=!1}an=-10,gn=-10,et.fill(null),So(null,!0,!0),xt&&(Vr=xt)}function b_(w,C,B,z,Y,tt,ut){ft._lock||(ae(w),Bl(),wp(),w!=null&&Gl(Tb,i,an,gn,$,Ut,null))}function M_(){E.forEach(m2),W(i.width,i.height,!0)}Xo(Cf,hl,M_);let ha={};ha.mousedown=y_,ha.mousemove=p_,ha.mouseup=v_,ha.dblclick=b_,ha.setSeries=(w,C,B,z)=>{let Y=Fn.match[2];B=Y(i,C,B),B!=-1&&Ws(B,z,!0,!1)},yt&&(Ne(Sb,p,y_),Ne(Xg,p,p_),Ne(wb,p,w=>{ae(w),Hl(!1)}),Ne(Eb,p,r1),Ne(Tb,p,b_),a0.add(i),i.syncRect=Hl);let Cu=i.hooks=n.hooks||{};function Kn(w,C,B){xi?Ze.push([w,C,B]):w in Cu&&Cu[w].forEach(z=>{z.call(null,i,C,B)})}(n.plugins||[]).forEach(w=>{for(let C in w.hooks)Cu[C]=(Cu[C]||[]).concat(w.hooks[C])});let S_=(w,C,B)=>B,Fn=Bn({key:null,setSeries:!1,filters:{pub:Ob,sub:Ob},scales:[T,_[1]?_[1].scale:null],match:[Bb,Bb,S_],values:[null,null]},ft.sync);Fn.match.length==2&&Fn.match.push(S_),ft.sync=Fn;let w_=Fn.key,Ep=NM(w_);function Gl(w,C,B,z,Y,tt,ut){Fn.filters.pub(w,C,B,z,Y,tt,ut)&&Ep.pub(w,C,B,z,Y,tt,ut)}Ep.sub(i);function o1(w,C,B,z,Y,tt,ut){Fn.filters.sub(w,C,B,z,Y,tt,ut)&&ha[w](null,C,B,z,Y,tt,ut)}i.pub=o1;function a1(){Ep.unsub(i),a0.delete(i),Zn.clear(),n0(Cf,hl,M_),c.remove(),At?.remove(),Kn("destroy")}i.destroy=a1;function Tp(){Kn("init",n,t),Ol(t||n.data,!1),O[T]?xp(T,O[T]):Bl(),at=ln.show&&(ln.width>0||ln.height>0),rt=vt=!0,W(n.width,n.height)}return _.forEach(ea),E.forEach(fr),e?e instanceof HTMLElement?(e.appendChild(c),Tp()):e(i,Tp):Tp(),i}ai.assign=Bn;ai.fmtNum=p0;ai.rangeNum=Pf;ai.rangeLog=Df;ai.rangeAsinh=d0;ai.orient=Zo;ai.pxRatio=Ge;ai.join=o3;ai.fmtDate=g0,ai.tzDate=_3;ai.sync=NM;{ai.addGap=Q3,ai.clipGaps=Ff;let n=ai.paths={points:zM};n.linear=GM,n.stepped=n2,n.bars=i2,n.spline=r2}var S0={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},qM={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},zf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,XM=80;function g2(n){let t=[];zf.lastIndex=0;let e=n.trimEnd();for(;zf.lastIndex<e.length;){let i=zf.lastIndex,s=zf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function _2(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Hf(n,t="plain"){let e=_2(String(n));if(e.length>XM)throw new Error(`longer than ${XM} characters`);let i=g2(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in gt.suffix(t)&&(s=gt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=m=>i[o]?.sign===m,c=m=>{if(!l(m))throw new Error(`\u201C${m}\u201D is missing`);o++};function u(){let m=h();for(;l("+")||l("-");){let _=i[o++].sign,E=h();m=_==="+"?m+E:m-E}return m}function h(){let m=d();for(;;)if(l("*"))o++,m*=d();else if(l("/"))o++,m/=d();else if(i[o]?.word||l("("))m*=f();else return m}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let m=p();return l("^")?(o++,m**d()):m}function p(){let m=i[o];if(!m)throw new Error("something is missing at the end");if(o++,m.number!==void 0)return m.number;if(m.sign==="("){let _=u();return c(")"),_}if(m.word){let _=m.word.toLowerCase();if(Object.hasOwn(qM,_))return a=!0,qM[_];if(Object.hasOwn(S0,_)){c("(");let E=u();return c(")"),S0[_](E)}throw new Error(`\u201C${m.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(S0).join(", ")}`)}throw new Error(`\u201C${m.sign}\u201D is not expected here`)}let y=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(y))throw new Error("not a finite number");let g=s??(t==="angle"&&a?1:gt.factor(t));return{value:y/g+0,symbolic:a||s!==null||i.length>2}}function bn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=M("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let g=Hf(c.value,l()),m=a?.(g.value);if(m)throw new Error(m);return g},f=g=>{c.classList.toggle("wrong",!!g),g?(c.setAttribute("aria-invalid","true"),c.title=g):(c.removeAttribute("aria-invalid"),c.title=o??""),w0(c,g),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:g?{label:n,reason:g}:null}))},p=g=>{try{let m=d();return f(null),g?.(m.value,{symbolic:m.symbolic,text:c.value.trim()}),!0}catch(m){return f(m.message),!1}};c.addEventListener("input",()=>p(e)),c.addEventListener("change",()=>{p(i??e)&&c.blurred?.()});let y="";return c.addEventListener("focus",()=>{y=c.value,c.classList.contains("wrong")&&w0(c,c.title),c.select()}),c.addEventListener("blur",()=>w0(c,null)),c.addEventListener("keydown",g=>{let m=c.closest("table.dh");if(g.key==="Escape"&&c.value!==y){g.preventDefault(),c.value=y,p(i??e),c.select();return}if(m&&x2(c,g))return;let _={ArrowUp:1,ArrowDown:-1}[g.key];if(g.key==="Enter"&&(y=c.value,c.select()),!(!_||m&&!g.altKey)){g.preventDefault();try{let E=d();c.value=$c((E.value??0)+_*gt.step(l())*(g.shiftKey?.1:1),l()),p(i??e)}catch{}}}),c.put=(g,m=null)=>{document.activeElement===c&&!c.readOnly||g===u&&m===h&&!c.classList.contains("wrong")||(u=g,h=m,c.value=m??(g==null?"":$c(g,l())),E0(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>E0(c)),c.refresh=()=>{let g=u,m=h;u=NaN,c.put(g,m)},c}function E0(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&E0(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Di=null;function w0(n,t){if(!t){Di&&Di.about===n&&(Di.hidden=!0),n.removeAttribute("aria-describedby");return}Di||(Di=M("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Di)),Di.about=n,Di.hidden=!1,Di.textContent!==t&&(Di.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Di.style.setProperty("top",`${e.bottom+4}px`),Di.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Di.offsetWidth-8))}px`)}addEventListener("scroll",()=>Di&&(Di.hidden=!0),!0);function x2(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function Gf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Vf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Je=n=>n.type==="R"?"angle":"length";function YM(n){let t=n.type==="R"?Math.PI:ci(v.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var y2=fg;function v2(n){let t=v.table.joints[n],e=Je(t),{lo:i,hi:s,min:r,max:o}=YM(t),a=`q${n+1}`,l=M("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=y=>`${100*(y-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{mi(),Nu(n,Number(l.value))}),l.addEventListener("keydown",y=>{let g={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[y.key],m={Home:i,End:s}[y.key];if(g===void 0&&m===void 0)return;y.preventDefault(),mi();let _=gt.step(e)*(y.shiftKey?.1:1);Nu(n,m??Math.min(Math.max(Math.round((v.q[n]+g*_)/(_/10))*(_/10),r),o))});let u=bn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:y=>{mi(),Nu(n,y)}}),h=M("span",{class:"out",role:"note"}),d=M("span",{class:"chain",title:"What this row of the table moves by"}),f=M("span",{class:"limits"}),p=M("div",{class:"joint","data-testid":`joint-${n+1}`},M("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},M("i",{text:"q"}),M("sub",{text:String(n+1)})),M("div",{class:"track"},l,M("div",{class:"under"},f,d,h)),u,M("span",{class:"unit"}));return{el:p,number:u,show(){let y=v.q[n],g=y2(t,y);(document.activeElement!==l||Number(l.value)!==y)&&(l.value=y),l.style.setProperty("--at",c(Math.min(Math.max(y,r),o))),l.setAttribute("aria-valuetext",he(y,e)),u.put(Number((y*gt.factor(e)).toFixed(gt.digits(e)+1))/gt.factor(e)),p.classList.toggle("outside",g!==0);let m=v.table.coupling?`chain ${he(yr(v.table,v.q)[n],e)}`:"";bt(d,m),bt(h,g?`${he(Math.abs(g),e)} ${g>0?"above":"below"} the limit`:"")},relabel(){bt(p.lastChild,gt.symbol(e));let y=g=>g===null?"no limit":he(g,e,gt.angle==="deg"&&e==="angle"?0:void 0);bt(f,t.lower===null&&t.upper===null?"no limits":`${y(t.lower)} \u2026 ${y(t.upper)}`),u.refresh(),this.show()}}}var ZM={id:"joints",title:"Joints",build(n){let t=[],e=M("div",{class:"joints","data-testid":"joints"}),i=M("div",{class:"chips",role:"group","aria-label":"Postures"}),s=M("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=v.table.joints.map((o,a)=>v2(a)),Wt(e,t.map(o=>o.el)),t.length||e.append(M("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Wt(s,v.table.actuator?b2(v.table.actuator):null),M2(i)};nt("table",o=>o!=="gripper"&&r()),nt("q",()=>t.forEach(o=>o.show())),nt("units",()=>t.forEach(o=>o.relabel())),r()}};function b2(n){let t=M("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=M("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),bt(e,ni(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},_n({...v.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=M("div",{class:"under"},M("span",{text:`${n.name}: moves no frame`}));return M("div",{class:"joint"},M("span",{class:"joint-name",text:"tool"}),M("div",{class:"track"},t,s),e,M("span",{class:"unit",text:n.unit}))}function M2(n){let t=v.table.joints.length,e=Object.entries(v.table.postures??{}),i=(r,o)=>St(r,{class:"chip",title:o.map((a,l)=>he(a,Je(v.table.joints[l]))).join(", ")},()=>Ii(o,.8,`move to ${r}`)),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Wt(n,s,t?St("Random",{class:"chip quiet",title:"A posture inside the limits"},()=>Ii(S2(),.8,"move to a random posture")):null,t?St("Keep this one",{class:"chip quiet",title:"Add the present posture to the arm"},w2):null)}function S2(){return v.table.joints.map(n=>{let{lo:t,hi:e}=YM(n);return t+Math.random()*(e-t)})}function w2(){let n={...v.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=v.q.slice(),_n({...v.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),Me(`Kept as P${t}: ${v.q.map((e,i)=>$c(e,Je(v.table.joints[i]))).join(", ")}`),ht("postures")}var jM=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function dr({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(u=>Es(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(u=>te(u[u.length-1])),speeds:o??E2(t,r),least:t.map((u,h)=>Du(n,u,c[h])[0]??0)}}function E2(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function T0(n,t){let{table:e}=n,i=gt.factor("length");if(t==="position")return{y:`tool, ${gt.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(u=>u[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(Je))].map(l=>(l==="angle"?gt.angle:gt.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(u=>u[c]*gt.factor(Je(l)))}))}}function JM(n){let t=gt.angle,e=gt.length,{table:i}=n,s=l=>Je(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*gt.factor("length")),...l.map((u,h)=>u*gt.factor(Je(i.joints[h]))),...n.speeds[c].map((u,h)=>u*gt.factor(Je(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function KM(n,t,e){let{y:i,list:s}=T0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(x=>x.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,p]=[Math.min(...c),Math.max(...c)];p-f>1e-9||(f-=1,p+=1);let y=x=>a.l+(x-h)/(d-h)*(r-a.l-a.r),g=x=>o-a.b-(x-f)/(p-f)*(o-a.t-a.b),m=(x,S)=>{let D=(S-x)/6,I=10**Math.floor(Math.log10(D)),N=[1,2,5,10].map(H=>H*I).find(H=>H>=D);return Array.from({length:12},(H,V)=>(Math.ceil(x/N)+V)*N).filter(H=>H<=S+N*1e-6)},_=x=>x.toFixed(2),E=x=>String(Number(x.toPrecision(6))),b=x=>x.replace(/[&<>"]/g,S=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[S]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],T=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${b(n.title)}</text>`];for(let x of m(f,p))T.push(`<path d="M${a.l} ${_(g(x))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${_(g(x)+4)}" text-anchor="end">${E(x)}</text>`);for(let x of m(h,d))T.push(`<path d="M${_(y(x))} ${o-a.b}v5" stroke="#333"/><text x="${_(y(x))}" y="${o-a.b+20}" text-anchor="middle">${E(x)}</text>`);T.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let x of n.events)Number.isFinite(x.x)&&T.push(`<path d="M${_(y(x.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${_(y(x.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${b(x.short)}</text>`);return s.forEach((x,S)=>{let D=e[S%e.length],I=x.values[x.values.length-1];T.push(`<polyline fill="none" stroke="${D}" stroke-width="1.8" stroke-dasharray="${A[S%A.length]}" points="${x.values.map((N,H)=>`${_(y(l[H]))},${_(g(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*S}h22" stroke="${D}" stroke-width="2" stroke-dasharray="${A[S%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*S}"><title>${_(I)}</title>${b(x.name)}</text>`)}),T.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${b(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${b(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${T.join("")}</svg>
`}var T2=1500,A2={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function QM(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/T2)),r=n.q.map((b,A)=>A).filter(b=>b%s===0||b===n.q.length-1),[o,a,l,c,u,h]=el(),[d,f,p]=[o-c,a-u,l-h],y=[Math.atan2(p,Math.hypot(d,f)),Math.atan2(f,d)].map(b=>b*180/Math.PI),g=b=>Number(b.toPrecision(8)),m={kind:t,speed:e,view:y,q:r.map(b=>n.q[b].map(g)),t:r.map(b=>g(n.seconds[b]))},_=await Fe("film",m,({done:b,of:A})=>i(b,A));if(_.stopped)return null;let E=Uint8Array.from(atob(_.data),b=>b.charCodeAt(0));return{name:_.name,blob:new Blob([E],{type:A2[t]})}}async function tS(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var Ve=null,Yn=null,yl="joints",Vi=0,C0=1,gi=null;function nS(n){let t=St("Play",{class:"primary","data-testid":"play"},sS),e=M("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{mi(),zr(Number(e.value))}}}),i=M("output",{class:"where","data-testid":"where"}),s=M("div",{class:"marks"}),r=M("div",{class:"chart","data-testid":"chart"}),o=M("div",{class:"legend"});n.append(M("div",{class:"dock-bar"},t,xn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{C0=Number(a)},{"data-testid":"speed"}),M("div",{class:"scrubber"},e,s),i,M("span",{class:"line"},...[["CSV",()=>ui("motion.csv",JM(Ve),"text/csv")],["PNG",P2],["Film",C2],["GIF",()=>eS("gif")],["MP4",()=>eS("mp4")],["SVG",()=>ui(`${yl}.svg`,KM(Ve,yl,kt.curves),"image/svg+xml")]].map(([a,l])=>St(a,{class:"quiet","aria-label":`Save as ${a}`},()=>Ve&&l())),St("\xD7",{class:"icon","aria-label":"Close the curves"},()=>Ni(null)))),M("div",{class:"dock-bar second"},We("Curves",jM,yl,a=>{yl=a,A0()},"curves"),o),r),gi={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Js(()=>Yn&&r.clientWidth&&Yn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),nt(["units","theme"],A0),nt("moving",a=>bt(t,a&&$f?"Pause":"Play")),nt("table",a=>{Ve&&!["postures","name","gripper"].includes(a)&&Ni(null)})}function Ni(n){if(mi(),Ve=n,v.motion=n,gi.root.hidden=!n,Yn&&(Yn.destroy(),Yn=null),Zv(n?.table??null,n?.q??[]),!n){ht("motion");return}gi.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Wt(gi.marks,n.events.map(e=>{let i=M("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=M("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),A0(),ht("motion"),n.q.length&&zr(0),requestAnimationFrame(()=>tl())}var iS=()=>Vi;function zr(n){Ve?.q.length&&(Vi=Math.min(Math.max(Math.round(n),0),Ve.q.length-1),gi.scrub.value=String(Vi),gi.scrub.style.setProperty("--at",`${Ve.q.length>1?100*Vi/(Ve.q.length-1):0}%`),bt(gi.where,Ve.xName==="point"?`point ${Vi+1} of ${Ve.q.length}`:`${ni(Ve.xs[Vi],2)} s of ${ni(Ve.xs[Ve.xs.length-1],2)} s`),gi.scrub.setAttribute("aria-valuetext",gi.where.textContent),Fi(Ve.q[Vi].slice(),"scrub"),ht("played",Ve.seconds[Vi]),R0())}var $f=!1;function sS(n,t){if($f){mi();return}if(!Ve?.q.length)return;let e=Ve.seconds,i=e[e.length-1]||1,s=Vi>=Ve.q.length-1?0:e[Vi]/i;$f=!0,cb(i/C0,s,r=>{let o=Vi<=Ve.q.length-1&&e[Vi]<=r*i?Vi:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;zr(o)},()=>{$f=!1,bt(gi.toggle,"Play"),t?.()}),bt(gi.toggle,"Pause")}function A0(){if(!Ve||!gi)return;Yn&&(Yn.destroy(),Yn=null);let{y:n,list:t}=T0(Ve,yl),e={stroke:kt.line,width:1},i=`${Math.round(.78*Wf())}px "Inter Variable", system-ui, sans-serif`;Wt(gi.legend,t.map((o,a)=>{let l=M("span",{class:"swatch"});return l.style.setProperty("background",kt.curves[a%kt.curves.length]),M("span",{},l,o.name)}));let s={stroke:kt.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*Wf(),gap:4};Yn=new ai({width:gi.chart.clientWidth||600,height:gi.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,Ve.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:kt.curves[a%kt.curves.length],width:1.75,pxAlign:0,points:{show:Ve.q.length<3}}))],axes:[{...s,label:Ve.xName==="point"?"point number":"time, s",size:2.1*Wf()},{...s,label:n,size:4*Wf()}]},[Ve.xs,...t.map(o=>o.values)],gi.chart);let r=M("div",{class:"now"});Yn.over.append(r,...Ve.events.map(o=>{let a=M("div",{class:`event ${o.stop?"stop":""}`,title:o.text},M("span",{text:o.short}));return a.x=o.x,a})),Yn.over.addEventListener("pointerdown",o=>{let a=u=>zr(R2(Yn.posToVal(u.clientX-Yn.over.getBoundingClientRect().left,"x")));mi(),a(o);let l=u=>a(u),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),Yn.hooks.setSize=[R0],R0()}var Wf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),R2=n=>Ve.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(Ve.xs[t]-n)?i:t,0);function R0(){if(!Yn)return;let n=Yn.over.clientWidth;for(let t of Yn.over.querySelectorAll(".now, .event")){let e=Yn.valToPos(t.x??Ve.xs[Vi],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}async function eS(n){Me(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await QM(Ve,n,C0,(e,i)=>Me(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&ui(t.name,t.blob)}catch(t){Me(t.message,"wrong")}}async function C2(){mi(),zr(0);try{let n=await Qa(t=>tS(t,()=>new Promise(e=>sS(null,e))));ui("motion.webm",n)}catch(n){Me(n.message,"wrong")}}function P2(){let n=Yn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=kt.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>ui(`${yl}.png`,i))}function bl(n,t){let e=Array.from({length:16},(s,r)=>M("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=M("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>M("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;bt(e[r],r>=12?String(s[r]):o?ni(s[r]*gt.factor("length"),gt.digits("length")):ni(s[r],4))}},i}var qf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var P0="pieper-panel-width",I0=18,rS=70;function oS(n,t){let e=M("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(I0),"aria-valuemax":String(rS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,I0),rS,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(P0):localStorage.setItem(P0,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(P0));o>=I0?r(o):e.setAttribute("aria-valuenow","38")}function aS(n){let t=bl("Pose of the tool, large","present-pose"),e=M("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=St("Present",{"aria-pressed":"false","data-testid":"present"},()=>o(i.dataset.present!=="yes")),r=()=>!e.hidden&&t.show(v.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ht("units"),dispatchEvent(new Event("resize"))}return nt(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function lS(){Qa(n=>n.toBlob(t=>t?ui(`${v.table.name||"arm"}.png`,t):Me("The picture could not be read.","wrong")))}var I2="http://www.w3.org/2000/svg";function L2(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(I2,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}function cS(n){let t=null,e=M("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=M("span",{class:"hint",role:"status"}),s=M("input",{type:"text",placeholder:"Name, maker, or joints such as 7R","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>a(),keydown:l=>{if(l.key==="ArrowDown")e.firstElementChild?.focus();else if(l.key==="Enter")e.firstElementChild?.click();else return;l.preventDefault()}}}),r=M("dialog",{class:"catalogue","aria-label":"Catalogue"},M("div",{class:"line"},s,i,St("\xD7",{class:"icon","aria-label":"Close the catalogue"},()=>r.close())),e);document.body.append(r);let o=l=>/^(.)\1*$/.test(l)?`${l.length}${l[0]}`:l;function a(){let l=s.value.toLowerCase().split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>{let h=`${u.name} ${u.maker} ${u.joints} ${o(u.joints)}`.toLowerCase();return l.every(d=>h.includes(d))});i.textContent=`${c.length} of ${t?.length??0} arms`,Wt(e,c.map(u=>M("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},L2(u.points),M("span",{},M("b",{text:u.name}),M("span",{class:"hint",text:[u.maker,o(u.joints)].filter(Boolean).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Ji("catalog")).arms,a()}catch(l){Me(l.message,"wrong")}}}var pu=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),_o=(n,t)=>[...n.children].filter(e=>e.localName===t),D2=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function N2(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function U2([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var uS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:U2},F2={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function hS(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(p=>p.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=F2[e("up_axis")[0]?.textContent.trim()]??D2(),a=[];function l(f){let p=s(_o(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),y=p&&[...p.getElementsByTagName("*")].find(m=>m.localName==="diffuse"),g=y?pu(_o(y,"color")[0]):[];return g.length>=3?[g[0],g[1],g[2],g[3]??1]:null}function c(f){let p=_o(f,"input").find(g=>g.getAttribute("semantic")==="POSITION"),y=s(p?.getAttribute("source"));return y?pu(_o(y,"float_array")[0]):[]}function u(f,p,y){let g=f&&_o(f,"mesh")[0];if(g)for(let m of g.children){if(!["triangles","polylist","polygons"].includes(m.localName))continue;let _=_o(m,"input"),E=1+Math.max(..._.map(V=>Number(V.getAttribute("offset")??0))),b=_.find(V=>V.getAttribute("semantic")==="VERTEX");if(!b)continue;let A=Number(b.getAttribute("offset")??0),T=c(s(b.getAttribute("source"))),x=_o(m,"p").map(pu),S=m.localName==="polylist"?pu(_o(m,"vcount")[0]):m.localName==="polygons"?x.map(V=>V.length/E):new Array(x.reduce((V,k)=>V+k.length,0)/E/3).fill(3),D=x.flat(),I=[],N=0,H=V=>{let k=3*D[(N+V)*E+A],[O,L,F]=[T[k],T[k+1],T[k+2]];for(let j=0;j<3;j++)I.push(r*(p[4*j]*O+p[4*j+1]*L+p[4*j+2]*F+p[4*j+3]))};for(let V of S){for(let k=2;k<V;k++)for(let O of[0,k-1,k])H(O);N+=V}I.length&&I.every(Number.isFinite)&&a.push({at:Float32Array.from(I),colour:l(y.get(m.getAttribute("material")))})}}function h(f,p,y){if(!(y>60)){for(let g of f.children)uS[g.localName]&&(p=N2(p,uS[g.localName](pu(g))));for(let g of f.children)if(g.localName==="instance_geometry"){let m=new Map([...g.getElementsByTagName("*")].filter(_=>_.localName==="instance_material").map(_=>[_.getAttribute("symbol"),_.getAttribute("target")]));u(s(g.getAttribute("url")),p,m)}else if(g.localName==="node")h(g,p,y+1);else if(g.localName==="instance_node"){let m=s(g.getAttribute("url"));m&&h(m,p,y+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var Xf=[],mu=new Map,Yf=0;function O2(){if(Xf.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=mu.get(t);mu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of mu.values())t(new Error("meshes cannot be read in this browser"));mu.clear()},Xf.push(n),n}return Xf[Yf%Xf.length]}function dS(n,t){return new Promise((e,i)=>{Yf+=1,mu.set(Yf,{resolve:e,reject:i}),O2().postMessage({id:Yf,...n},t)})}async function fS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=hS(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await dS({at:r},[r.buffer]),colour:o})))}return[{mesh:await dS({bytes:i,kind:e},[i]),colour:null}]}var pS={light:"#c9ced6",dark:"#8b96a6"},Sl=new An,ks=[],gu=0,_S=!1,xS=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function wl(n,t,e=null){v.looks=n?.shapes.length?{...n,key:xS(t),files:e}:null,n?.notes.length&&Me(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),B2()}var D0=()=>!!(v.looks&&v.looks.key===xS(v.table)),N0=()=>D0()?v.look.mode:"sketch",Zf=null;function B2(){if(Zf===v.looks)return;Zf=v.looks;for(let t of ks)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();ks=[],Sl.clear();let n=Zf;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){gS(t,[k2[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(gu+=1,fS(e,t.url??t.file).then(i=>{if(Zf===n)for(let{mesh:s,colour:r}of i){let o=L0(s),a=s.some===s?o:L0(s.some);gS(t,[o,a,s.few===s.some?a:L0(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>Me(`${t.name}: ${i.message}`,"wrong")).finally(()=>{gu-=1,Ml(),gu||ht("looks","loaded")}))}ht("looks"),Ml()}var mS=n=>n.rotateX(Math.PI/2),k2={box:n=>new ki(...n),cylinder:([n,t])=>mS(new Ri(n,n,t,36)),capsule:([n,t])=>mS(new Lo(n,t,8,24)),sphere:([n])=>new Ps(n,28,16)};function L0(n){let t=new Se;return t.setAttribute("position",new ke(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new ke(n.normal,3):z2(n.normal)),t.setIndex(new ke(n.index,1)),t}function z2(n){return new to(new Co(n,4),3,0,!0)}function gS(n,[t,e=t,i=e],s,r=null,o=!0){let a=pv(o),l=new je(t,a),c=new je(i,df),u=new _e().set(...n.T);r&&u.scale(new G(...r));for(let h of[l,c])h.matrixAutoUpdate=!1,h.frustumCulled=!1;c.renderOrder=-1,Sl.add(l,c),ks.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:l,shadow:c,colour:s}),_u()}var H2=new _e;function Ml(){yS(),ye()}function yS(){let n=N0();if(Sl.visible=n!=="sketch"&&ks.length>0,$v(n!=="real"||gu>0,n!=="sketch"&&ks.length>0),!!Sl.visible)for(let t of ks){let e=v.frames[t.on];e&&(t.mesh.geometry=_S?t.few:nv()?t.some:t.fine,t.mesh.matrix.copy(H2.set(...e)).multiply(t.T),t.shadow.matrix.copy(Fg).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function _u(){let n=N0()==="both"?v.look.opacity:1;for(let{mesh:t,colour:e}of ks){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,si):t.material.colour.set(kt.dark?pS.dark:pS.light),t.material.see((o??1)*n,kt.dark)}ye()}function U0(n){v.look={...v.look,...n},_u(),Ml(),ht("look")}function vS(){dn.add(Sl),nt("table",()=>{Ml(),_u(),ht("looks")}),nt("q",Ml),nt("theme",_u),nt("look",n=>{n==="loaded"&&(_u(),Ml())}),nt("hurry",n=>{_S=n,yS()})}var bS=()=>({mode:N0(),visible:Sl.visible,loading:gu,shapes:ks.length,triangles:ks.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:ks.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:ks.map(n=>n.mesh.matrix.clone().transpose().toArray())});function SS(){let n=We("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],v.look.mode,s=>U0({mode:s}),"look"),t=M("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(v.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>U0({opacity:Number(t.value)})}}),e=M("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!D0(),n.mark(v.look.mode),t.hidden=v.look.mode!=="both",t.value=String(v.look.opacity)};return nt(["looks","look","table"],i),i(),e}function ES(n){let t=M("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>wS(t.value)}}),e=cS(wS),i=M("p",{class:"sentence","data-testid":"sentence"}),s=M("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=St(u,{"aria-label":h},d);return p.show=y=>{p.disabled=!y,p.title=y?`${h}: ${y} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",y??"")},p},o=r("\u21B6","Undo",Vg,"Ctrl+Z"),a=r("\u21B7","Redo",Wg,"Ctrl+Shift+Z");nt("history",()=>{o.show(yf()),a.show(vf())});let l=()=>{let{name:u,derived:h,catalog:d}=v.table,f=d?[]:[M("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Wt(t,f,(v.catalog??[]).map(p=>M("option",{value:p,text:p}))),t.value=d??""},c=M("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(M("h1",{class:"mark"},M("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),M("span",{text:"pieper"})),t,St("Find\u2026",{class:"find","aria-label":"Find an arm in the catalogue","data-testid":"find-arm"},e),c,i,M("span",{class:"bar-end"},s,We("Angles in",[["deg","\xB0"],["rad","rad"]],gt.angle,u=>{gt.set("angle",u),ht("units")},"unit-angle"),We("Lengths in",[["mm","mm"],["m","m"]],gt.length,u=>{gt.set("length",u),ht("units")},"unit-length"),xn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],v.theme,Hd,{"data-testid":"theme"}))),ht("history"),nt(["catalog","table"],l),nt("plan",()=>{bt(i,[Fu(v.plan),B_(v.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=v.plan?.explain??""}),nt("online",u=>{bt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),nt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(gt.angle),n.querySelector("[data-testid=unit-length]").mark(gt.length),n.querySelector("[data-testid=theme]").value=v.theme})}async function wS(n){if(n)try{let{table:t}=await Ji("load",{name:n});_n(t,{q:fa(t),what:"new",label:`open ${n}`})}catch(t){Me(t.message,"wrong")}}function TS(n,t,e,i){let s=M("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=M("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=M("section",{class:"section"},M("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=St(c.title,{role:"tab",id:`tab-${c.id}`,"aria-controls":u.id},()=>l(c.id));return c.group&&s.append(M("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(v.panel,t.scrollTop),v.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ht("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===v.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(v.panel==="move"||!a.some(c=>c.id===v.panel)?"move":v.panel)),l(v.panel),l}function AS(n){let t=M("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>St(u,{},()=>ag(c))),St("Fit",{},()=>tu())),e=M("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=St("Trace",{"aria-pressed":"true"},()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),sb(c)}),s=St("Clear",{"aria-label":"Clear the trace"},gf),r=M("span",{class:"scale"}),o=M("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=M("span",{class:"dot"});return h.style.setProperty("background",Nr[u]),M("span",{},h,c)}),r);n.append(M("div",{class:"corner top"},t,M("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),SS(),M("div",{class:"group",role:"group","aria-label":"The picture"},aS(n),St("PNG",{"aria-label":"Save the picture","data-testid":"save-picture"},lS))),M("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=v.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);v.shownFrames=(v.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{v.shownFrames=d,l()};Wt(e,M("span",{class:"group-name",text:"Frames"}),u.map(d=>St(mf(d),{"aria-pressed":String(v.shownFrames.includes(d)),"aria-label":`Frame ${mf(d)}`},()=>h(v.shownFrames.includes(d)?v.shownFrames.filter(f=>f!==d):[...v.shownFrames,d]))),St(v.shownFrames.length===c+2?"none":"all",{"aria-label":"All frames or none"},()=>h(v.shownFrames.length===c+2?[]:u))),ht("frames"),bt(r,`grid ${he(cg.cell,"length",gt.length==="mm"?0:2)}`)};nt(["table","units"],l),l()}function RS(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Vg()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Wg()))})}var F0=()=>v.frames[v.frames.length-1],PS={id:"pose",title:"Pose",build(n){let t=bl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>CS(u,"length",`pose-${u.toLowerCase()}`)),i=M("div",{class:"quantities","data-testid":"orientation"}),s=M("p",{class:"hint order"}),r=[],o=xn("Notation of the orientation",Object.entries(Ns).map(([u,h])=>[u,h.title]),v.notation,u=>{v.notation=u,ht("notation")}),a=M("span",{class:"copies"},St("Copy matrix",{class:"quiet",title:"As numbers in metres, row by row"},()=>Xr(qf(F0()))),St("Copy numbers",{class:"quiet",title:"Position and orientation, in the units shown"},()=>Xr(G2())));n.append(M("div",{class:"subhead"},M("span",{text:"Tool in the base frame"}),a),t,M("div",{class:"quantities"},e.map(u=>u.el)),M("div",{class:"line"},o,s),i);let l=()=>{let u=Ns[v.notation];o.value=v.notation,bt(s,u.order),r=u.names.map((h,d)=>CS(h,u.kinds[d],`turn-${d}`)),Wt(i,r.map(h=>h.el)),c()},c=()=>{let u=F0();t.show(u),te(u).forEach((h,d)=>e[d].show(h)),Ns[v.notation].to(u).forEach((h,d)=>r[d].show(h))};nt("q",c),nt("notation",l),nt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function G2(){let n=F0(),t=Ns[v.notation],e=te(n).map((s,r)=>`${"XYZ"[r]} ${fn(s,"length")} ${gt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${fn(s,"angle")} ${gt.symbol("angle")}`:ni(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function CS(n,t,e){let i=M("output",{"data-testid":e}),s=M("span",{class:"unit",text:gt.symbol(t)});return{el:M("div",{class:"quantity"},M("span",{class:"quantity-name",text:n}),i,s),show:o=>bt(i,t==="plain"?ni(o,5):fn(o,t)),relabel:()=>bt(s,gt.symbol(t))}}function V2(n,t){let e=[],i=n.joints.length,s=yr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=xr(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*xr(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var IS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=M("div",{class:"cards","data-testid":"matrices"}),a=M("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=xn("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),c=M("span",{class:"partial"});n.append(M("div",{class:"line"},We("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),c),M("div",{class:"line"},M("span",{class:"field-name",text:"Numbers of the"}),l),o,M("h3",{text:"Intermediate angles"}),M("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&v.solutions?.rows[Number(e)]?.q||v.q,h=()=>{let p=v.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let y=t==="links"?v.table.joints.map((m,_)=>["A",String(_+1),""]):t==="products"?v.table.joints.map((m,_)=>["T",String(_+1),"0"]):[["T",String(s),String(i)]];t==="links"&&y.push(["T","tool","base"]);let g=Array.from({length:p+1},(m,_)=>[String(_),String(_)]);Wt(c,t==="partial"?[xn("From frame",g,String(i),m=>{i=Number(m),h()})," \u2192 ",xn("To frame",g,String(s),m=>{s=Number(m),h()})]:[]),r=y.map(([m,_,E])=>({grid:bl(`${m} ${E} ${_}`,`matrix-${m}${E}${E?"-":""}${_}`),note:M("span",{class:"hint"}),sym:m,low:_,high:E})),Wt(o,r.map(({grid:m,note:_,sym:E,low:b,high:A})=>M("figure",{class:"card"},M("figcaption",{},M("span",{class:"symbol"},A?M("sup",{text:A}):null,M("i",{text:E}),M("sub",{text:b})),_),m))),d()},d=Js(()=>{if(n.closest(".panel").hidden||!v.table.joints.length)return;let p=u(),y=R_(v.table,p),g=y.length;r.forEach(({grid:E,note:b},A)=>{if(t==="links"&&A<g)E.show(y[A]),bt(b,`q${A+1} = ${he(p[A],Je(v.table.joints[A]))}`);else if(t==="links")E.show(Es(v.table,p)[g+1]);else if(t==="products")E.show(y.slice(0,A+1).reduce(Hn,ji()));else{let T=x=>y.slice(0,x).reduce(Hn,ji());E.show(Hn(da(T(i)),T(s)))}});let m=yr(v.table,p),_=v.table.joints.map((E,b)=>[E.type==="R"?`\u03B8${b+1}`:`d${b+1}`,E.type==="R"?fn(xr(E,m[b]).theta,"angle"):fn(xr(E,m[b]).d,"length"),E.type==="R"?"angle":"length"]).concat(V2(v.table,p).map(({name:E,value:b})=>[`\u03B8${E}`,fn(b,"angle"),"angle"]));Wt(a,M("tbody",{},_.map(([E,b,A])=>M("tr",{},M("th",{scope:"row"},M("i",{text:E[0]}),M("sub",{text:E.slice(1)})),M("td",{text:b}),M("td",{class:"unit",text:gt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=v.solutions?.rows??[];Wt(l,M("option",{value:"now",text:"present posture"}),p.map((y,g)=>M("option",{value:String(g),text:`solution ${g+1}: ${y.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),l.value=e,d()};nt("table",h),nt(["q","units","panel"],d),nt(["solutions","panel"],f),h()}};var W2=.002;function zs(n,t,e,i){let s=[],r="",o=M("div",{class:"pose-fields"}),a=()=>{let c=Ns[v.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=yv(v.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,$2(s))};s=u.map(([d,f],p)=>{let y={value:0,kind:f},g=(m,_)=>{y.value=m,y.text=_.text,h()};return y.f=bn({label:`${n}, ${d}`,kind:f,testid:`${t}-${p}`,input:g,commit:(m,_)=>{g(m,_),ht("let-go")}}),y.el=M("label",{class:"pose-field"},M("span",{text:d}),y.f,M("span",{class:"unit",text:gt.symbol(f)})),y}),Wt(o,s.map(d=>d.el)),r=v.notation},l=()=>{r!==v.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...te(c),...Ns[v.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,q2(u,s[h].kind))})};return nt("units",()=>{a(),l()}),nt("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=Gf(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),Vf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:M("fieldset",{class:"pose-editor"},M("legend",{text:n}),o),show:l}}function $2(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?sl(t(e),"angle"):2*sl(t(n.slice(3)),"plain");return{metres:sl(t(n.slice(0,3)),"length"),radians:i}}var q2=(n,t)=>String(Number((n*gt.factor(t)).toFixed(t==="plain"||gt[t]==="m"||gt[t]==="rad"?6:3))+0);function LS(n){let t=n.match(DS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:sl(e,"length"),radians:2*sl(i,"plain")}}var DS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function NS(n){let t=(n.replaceAll("\u2212","-").match(DS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Iu(e);if(i>W2)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=gt.factor("length");return Lu(e)}function jf(n){return n.map((t,e)=>{let i=v.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((v.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function US(n,t){let e=t?.self_motions??[],i=de.task??v.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Wt(n,M("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let p=d.moves.length>3?"most of its joints":d.moves.join(" and "),y=d.inside.length?j2(d):"All of it lies outside the limits.";return M("div",{class:"self-motion"},M("p",{},M("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${p}, ${a(d)}: the arm moves, ${o}. ${y}`),K2(d,f,t.T,s))},c=e.length?Y2(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?M("details",{class:"fold"},M("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Wt(n,c>=0?l(e[c],c):null,h)}var X2=n=>n.reduce((t,e,i)=>t+Math.sin((e-v.q[i])/2)**2,0),Y2=n=>{let t=n.map(e=>Math.min(...e.q.map(X2)));return t.indexOf(Math.min(...t))};function Z2(n){let t=(s,r)=>s.map((o,a)=>v.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(v.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var j2=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function J2(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function K2(n,t,e,i){let s=M("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{mi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ht("did",{label:"slide along a self-motion",key:"self-motion"}),Fi(jf(i?P_(v.table,u,e):u),"self-motion")};return s.value=String(Z2(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",J2(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function FS(){let n=[],t=[],e={},i=M("div",{class:"joints"}),s=M("details",{},M("summary",{class:"hint",text:"Hold by value"}),i),r=M("p",{class:"hint"}),o=We("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=M("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},M("div",{class:"line spread"},M("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:p=!1}={}){ht("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),de.redundancy=f&&Object.fromEntries(f.map(y=>[y,e[y]])),d(),p?ab():Us({follow:!0})}let c=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>v.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let y=f.kind==="angle"?Math.PI:ci(v.table),g=f.lower??-y,m=f.upper??y,_=M("input",{type:"range",min:String(g),max:String(m),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),E=!1,b=(S,D)=>{e[f.name]=S,l(c(f),{sliding:D})};_.addEventListener("input",()=>b(Number(_.value),!0)),_.addEventListener("change",()=>Us({follow:!0})),_.addEventListener("keydown",S=>{let D={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[S.key];if(D===void 0)return;S.preventDefault(),E=!0;let I=D*gt.step(f.kind)*(S.shiftKey?.1:1);b(Math.min(Math.max(e[f.name]+I,g),m),!0)}),_.addEventListener("keyup",()=>{E&&Us({follow:!0}),E=!1});let A=bn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:S=>S<g-1e-9&&f.lower!==null?`below the limit ${he(g,f.kind)}`:S>m+1e-9&&f.upper!==null?`above the limit ${he(m,f.kind)}`:null,commit:S=>b(S,!1)}),T=M("span",{class:"limits"}),x=M("div",{class:"joint"},M("span",{class:"joint-name",text:f.name}),M("div",{class:"track"},_,M("div",{class:"under"},T)),A,M("span",{class:"unit"}));return{line:x,show(){let S=e[f.name];_.value=S,_.style.setProperty("--at",`${100*(Math.min(Math.max(S,g),m)-g)/(m-g||1)}%`),_.setAttribute("aria-valuetext",he(S,f.kind)),x.classList.toggle("held",!!(de.redundancy&&f.name in de.redundancy)),A.put(Number((S*gt.factor(f.kind)).toFixed(gt.digits(f.kind)+1))/gt.factor(f.kind))},relabel(){bt(x.lastChild,gt.symbol(f.kind));let S=D=>D===null?"no limit":he(D,f.kind,f.kind==="angle"&&gt.angle==="deg"?0:void 0);bt(T,f.lower===null&&f.upper===null?"no limits":`${S(f.lower)} \u2026 ${S(f.upper)}`),A.refresh()}}}function d(){for(let f of n)de.redundancy&&f.name in de.redundancy?e[f.name]=de.redundancy[f.name]:u(f)>=0?e[f.name]=v.q[u(f)]:f.instead&&Number.isFinite(v.solutions?.arm_angle)?e[f.name]=v.solutions.arm_angle:e[f.name]??=0;o.mark(de.redundancy?"chosen":"free"),bt(r,de.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return nt("solutions",()=>{let f=v.solutions?.spare;if(!v.solutions||!f&&(v.solutions.brief||v.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Wt(i,t.map(y=>y.line));for(let y of t)y.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(y=>!y.instead).length>1||!!de.redundancy),d()}),nt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!de.redundancy&&d()),nt("units",()=>{for(let f of t)f.relabel();d()}),a}function OS(){let n=M("thead"),t=M("tbody"),e=M("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=M("div",{class:"scroll"},M("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${v.table.joints.map(c=>c.type).join("")}${gt.angle}${gt.length}`;l!==r&&(r=l,s=[],Wt(t),Wt(n,M("tr",{},M("td"),M("th",{class:"left",text:"posture"}),v.table.joints.map((c,u)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(u+1)}),M("span",{class:"unit",text:` ${gt.symbol(Je(c))}`}))),M("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=v.table.joints.map(()=>M("td")),u=M("span"),h=M("span",{class:"offscreen"}),d=M("td",{class:"unit"}),f=M("tr",{tabindex:"0","data-testid":`solution-${l+1}`},M("th",{scope:"row",text:String(l+1)}),M("td",{class:"left"},u,h),c,d),p=()=>v.solutions?.rows[l]?.q,y=()=>p()&&gs(p()),g=()=>gs(null),m=()=>{p()&&(gs(null),Ii(jf(p()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",y),f.addEventListener("pointerleave",g),f.addEventListener("focus",y),f.addEventListener("blur",g),f.addEventListener("click",m),f.addEventListener("keydown",_=>{(_.key==="Enter"||_.key===" ")&&(_.preventDefault(),m())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&bt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),bt(u.beyond,d.inside?"":", outside the limits"),bt(u.residual,d.residual?Kd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${Kd(d.residual[0])} m, ${Kd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let y=v.table.joints[p],g=y.lower!==null&&f<y.lower-1e-9||y.upper!==null&&f>y.upper+1e-9;bt(u.cells[p],fn(f,Je(y))),u.cells[p].classList.toggle("out",g)}))}),this.mark()},mark(){let l=v.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===v.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-v.q[d])/2))<1e-5)))}}}var Q2={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},O0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},tL=new Set(["REDUNDANT","UNCERTAIN"]),eL=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,B0=120;function k0(){Mi(v.frames[v.frames.length-1].slice(),"taken")}var kS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(M("div",{class:"line spread"},St("Take the present pose",{"data-testid":"take-pose"},k0),We("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",y=>{i.hidden=y!=="numbers",s.hidden=y!=="matrix"},"target-as")));let e=zs("Target","target",()=>v.target,(y,g)=>Mi(y,"typed",g)),i=M("div",{},e.el),{el:s,show:r}=iL();n.append(i,s,sL());let o=M("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=M("div",{class:"near","data-testid":"ik-nearest"}),l=M("div",{class:"self-motions","data-testid":"self-motions"}),c=OS();n.append(FS(),o,a,l,c.el);let u=ma(B0,()=>{e.show(),r()}),h=ma(B0,()=>{if(t.hidden)return;let y=v.solutions;rL(o,y),lL(a,y),US(l,y),c.show(y)}),d=ma(B0,()=>c.mark()),f=y=>()=>af()?y.soon():y();nt("target",f(u)),nt("notation",e.show),nt(["solutions","units"],f(h)),nt("q",f(d));let p=()=>Or("target",v.panel==="inverse"?nL(te(v.target)):[]);nt("target",y=>y!=="drag"&&p()),nt("panel",y=>{Fv(y==="inverse"),(y!=="inverse"||v.hasTarget)&&p(),y==="inverse"&&(v.hasTarget?ht("solutions"):(v.hasTarget=!0,k0()))}),nt("table",y=>{y==="new"&&(v.hasTarget=v.panel==="inverse",v.hasTarget&&k0())})}};function nL(n){let t=.25*ci(v.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function iL(){let n=M("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=M("p",{class:"reason",role:"alert"}),e=M("p",{class:"hint"});n.addEventListener("input",()=>{try{Mi(NS(n.value),"typed",LS(n.value)),bt(t,""),n.removeAttribute("aria-invalid")}catch(s){bt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(bt(e,`Twelve or sixteen numbers, row by row; the last column in ${gt.length}.`),document.activeElement===n)return;let s=v.target.map((r,o)=>o%4===3&&o<12?r*gt.factor("length"):r);n.value=qf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return nt("units",i),i(),{el:M("div",{hidden:!0},n,e,t),show:i}}function sL(){let n=M("span",{class:"line"}),t=M("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{de.follow=t.checked}}}),e=We("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{de.ghosts=i,ll()});return nt("task",()=>{t.checked=de.follow,e.mark(de.ghosts)}),nt("plan",()=>Wt(n,v.plan?.solvable?[M("span",{class:"field-name",text:"Task"}),xn("Task",[["",`${v.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],de.task??"",i=>{ht("did",{label:"choose the task"}),de.task=i||null,de.redundancy=null,Us()},{"data-testid":"task"})]:[])),M("div",{class:"line controls"},M("span",{class:"line"},M("span",{class:"field-name",text:"Handles"}),We("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Ov)),We("Axes of the handles",[["local","Tool"],["world","World"]],"local",Bv),M("span",{class:"line"},M("span",{class:"field-name",text:"Snap"}),xn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>kv(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),M("span",{class:"line"},M("span",{class:"field-name",text:"Ghosts"}),e),M("label",{class:"check"},t,"Arm follows"),n)}function rL(n,t){if(!t){Wt(n,M("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=Q2[t.status]??"note";let s=t.status==="SOLVED"&&e?BS(t.missed):[t.why,t.status==="SINGULAR"?eL(e,i):"",BS(t.missed)].filter(Boolean).join(" "),r=O0[t.status]&&!i?t.why.toLowerCase().includes(O0[t.status].toLowerCase())?"":O0[t.status]:t.status==="SINGULAR"||tL.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Wt(n,M("strong",{text:r})," ",M("span",{text:s}),t.ms===void 0?null:M("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var BS=n=>n?`The pose was rounded by ${aL(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",oL=(n,t)=>he(n,t,gt.digits(t)+2),aL=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*gt.factor(e)>=.5*10**-(gt.digits(e)+2)).map(([t,e])=>oL(t,e)).join(" and ");function lL(n,t){let e=t?.near;if(!e){Wt(n);return}let i=te(e.T).map(s=>fn(s,"length")).join(", ");Wt(n,M("p",{},M("strong",{text:"Nearest reachable: "}),`${i} ${gt.symbol("length")}, ${he(e.metres,"length")} away`,e.radians>.001?`, turned by ${he(e.radians,"angle")}`:""),M("div",{class:"line"},St("Go there",{},()=>Ii(e.q)),St("Make it the target",{},()=>Mi(e.T,"chosen"))))}var z0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Jf(n){return z0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Kf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Jf(r)??{a:0,alpha:0};Jf(r)&&(r=ji()),o=Hn(z0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Jf(o)??{a:0,alpha:0};Jf(o)&&(o=ji()),r=Hn(r,z0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var zS=30,cL=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),uL={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},El=null;function HS(n,t){El={label:n,key:"paste",open:!0};try{t(El)}finally{El=null,ht("let-go")}}function Qf(n,t,e,{symbolic:i,text:s},r){let o=v.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(v.table.joints[n][t],e)&&v.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${uL[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||_n({...v.table,joints:o},El?{...c,...El}:c),r&&!El&&ht("let-go")}function Tl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=v.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(v.q,0),c=o?t(o,null).map((u,h)=>hL(u&&t(u,0),h,n.length)):null;_n({...v.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var hL=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function GS(n,t,e){let i=v.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function H0({label:n,key:t,open:e}={}){let i=v.table.joints.length;return i>=zS?(Me(`At most ${zS} joints.`,"wrong"),!1):(Tl([...v.table.joints,cL(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function G0(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};Tl(e(v.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function tp(){try{ui(`${v.table.name||"arm"}.toml`,(await Fe("save",{})).text,"application/toml")}catch(n){Me(n.message,"wrong")}}function $S(){let n=(t,e,i)=>{let s=M("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>fL(s)}});return[St(t,{title:e},()=>s.click()),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var dL=/\.(toml|urdf|xml)$/i,VS=2e5;async function fL(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>dL.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){Me("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>VS){Me(`${i.name} has ${i.size} bytes; a robot file has at most ${VS.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Ji("open",{name:i.name.slice(-80),text:await i.text()});_n(s,{q:fa(s),what:"new",label:`open ${i.name.slice(-40)}`}),wl(r,s,a=>WS(t,a));let o=r?.shapes.filter(a=>a.file&&!WS(t,a.file)).length;o&&Me(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){Me(s.message,"wrong")}}function WS(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var V0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},pL=({catalog:n,...t})=>n?{...t,derived:n}:t,mL=n=>n.type==="R"?"angle":"length",qS={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=M("thead"),s=M("tbody"),r=M("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=M("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=M("p",{class:"verdict","data-testid":"arm-kind"}),l=We("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],v.table.convention,_=>{_!==v.table.convention&&_n(Kf(v.table,_),{what:"rows",label:`make the table ${_}`})},"convention"),c=M("p",{class:"hint order"}),u=M("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>_n({...pL(v.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=zs("Base","base",()=>v.table.base,_=>_n({...v.table,base:_},{what:"cell",label:"edit the base",key:"base",open:!0})),d=zs("Tool","tool",()=>v.table.tool,_=>_n({...v.table,tool:_},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(M("div",{class:"line spread"},M("span",{class:"line"},u),M("span",{class:"line"},St("Blank",{title:"An empty table"},()=>_n(I_(v.table.convention),{q:[],what:"new",label:"begin a blank table"})),...$S(),St("Save",{title:"As a robot file"},tp))),M("div",{class:"line spread"},l,We("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,_=>{t=_,g()},"dh-part")),c,r,M("div",{class:"line"},St("+ Add joint",{class:"add","data-testid":"add-joint"},()=>H0()),M("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,xv(),M("details",{class:"fold","data-testid":"base-tool"},M("summary",{text:"Base and tool"}),h.el,d.el)),s.addEventListener("paste",_=>{let E=Gf(_.clipboardData.getData("text")),b=()=>[...s.rows].map(x=>[...x.querySelectorAll("input.number")]);if(!E||!_.target.matches("input.number"))return;_.preventDefault();let A=b().findIndex(x=>x.includes(_.target)),T=b()[A].indexOf(_.target);HS("paste a table",x=>{for(;v.table.joints.length<A+E.length&&H0(x););let S=Vf(b(),A,T,E),D=E.flat().length;Me(`Pasted ${S} number${S===1?"":"s"}${S<D?`; ${D-S} had no cell`:""}`)})}),n.addEventListener("verdict",_=>{let E=_.detail??gL(n);bt(o,E?`${E.label}: ${E.reason}. The arm stays as it was.`:"")});let f=(_,E,[b,A,T])=>{let x=_.type==="R"&&b==="theta"||_.type==="P"&&b==="d",S=b==="lower"||b==="upper",D=bn({label:`Joint ${E+1}, ${A}`,kind:T??mL(_),testid:`dh-${E+1}-${b}`,empty:S?null:void 0,check:I=>S?GS(E,b,I):I!==null&&Math.abs(I)>1e6?"larger than a million":null,input:(I,N)=>Qf(E,b,I,N,!1),commit:(I,N)=>Qf(E,b,I,N,!0)});return S&&(D.placeholder="none"),e.push({f:D,i:E,key:b}),M("td",{class:x?"variable":""},x?M("span",{class:"plus"},M("i",{text:"q"}),M("sub",{text:String(E+1)})," +"):null,D)},p=(_,E)=>St(_.type,{class:`type type-${_.type}`,"data-testid":`dh-${E+1}-type`,"aria-label":`Joint ${E+1} is ${_.type==="R"?"revolute":"prismatic"}; press to change`,title:_.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute."},()=>Tl(v.table.joints.map((b,A)=>A===E?{...b,type:b.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...b.text,lower:void 0,upper:void 0,offset:void 0}}:b),b=>b.map((A,T)=>T===E&&typeof A=="number"?0:A),`make joint ${E+1} ${_.type==="R"?"prismatic":"revolute"}`)),y=(_,E)=>M("td",{class:"tools"},St("\u2191",{class:"icon","aria-label":`Move joint ${_+1} up`,disabled:_===0},()=>G0(_,_-1)),St("\u2193",{class:"icon","aria-label":`Move joint ${_+1} down`,disabled:_===E-1},()=>G0(_,_+1)),St("\xD7",{class:"icon","aria-label":`Remove joint ${_+1}`},()=>Tl(v.table.joints.filter((b,A)=>A!==_),b=>b.filter((A,T)=>T!==_),`remove joint ${_+1}`))),g=()=>{e=[];let{joints:_}=v.table,E=v.table.convention==="modified",b=t==="geometry"?V0.geometry.map(([A,T,x])=>M("th",{scope:"col"},M("i",{text:T}),M("sub",{text:E&&(A==="a"||A==="alpha")?"i\u22121":"i"}),M("span",{class:"unit",text:` ${gt.symbol(x)}`}))):["name","lower limit","upper limit","zero","sense"].map(A=>M("th",{scope:"col",text:A}));Wt(i,M("tr",{},M("th",{scope:"col",text:"i"}),M("th",{scope:"col"},M("span",{class:"offscreen",text:"type"})),b,M("td"))),Wt(s,_.map((A,T)=>{let x=t==="geometry"?V0.geometry.map(S=>f(A,T,S)):[M("td",{},M("input",{type:"text",class:"name",value:A.name,maxlength:"40","aria-label":`Joint ${T+1}, name`,on:{change:S=>Qf(T,"name",S.target.value||`joint_${T+1}`,{},!0)}})),...V0.joint.map(S=>f(A,T,S)),M("td",{},St(A.sign>0?"+":"\u2212",{class:"type","aria-label":`Joint ${T+1}, sense of the maker: ${A.sign>0?"as the table":"against the table"}`},()=>Tl(v.table.joints.map((S,D)=>D===T?{...S,sign:-S.sign}:S),S=>S,`turn the sense of joint ${T+1}`)))];return M("tr",{"data-testid":`dh-row-${T+1}`},M("th",{scope:"row",text:String(T+1)}),M("td",{},p(A,T)),x,y(T,_.length))})),_.length||s.append(M("tr",{},M("td",{colspan:"7",class:"hint",text:"No joints yet."}))),m()},m=()=>{for(let{f:_,i:E,key:b}of e){let A=v.table.joints[E];_.put(A[b],A.text?.[b]??null)}l.mark(v.table.convention),bt(c,v.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=v.table.name),h.show(),d.show()};nt("table",_=>{bt(o,""),_==="cell"||_==="name"||_==="postures"?m():g()}),nt("units",g),nt("notation",()=>{h.show(),d.show()}),nt("plan",()=>{a.dataset.tone=v.plan?.solvable?"good":"wrong",Wt(a,M("strong",{text:Fu(v.plan)||(v.plan?.refused?"Refused":"Not solved")})," ",M("span",{text:v.plan?.explain??""}))}),g()}};function gL(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var _L=4,xL=n=>{let t=n.toFixed(_L);return Number(t)<0?`(${t})`:t.replace("-","")};function ep(n,t,e){let i=yr(t,e),s=t.joints.map((c,u)=>xr(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,xL(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var np=null;async function yL(){return np??=(await import("./katex-LOBGZRV6.js")).default,np}function vL(n,t){let e=M("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function XS(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>vL(n,i)],[i=>"code"in i,i=>M("code",{text:i.code})],[()=>!0,i=>M("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var bL=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function ML(n){let t=v.table.joints.map((e,i)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(i+1)}),M("span",{class:"unit",text:` ${gt.symbol(Je(e))}`})));return[M("h3",{text:"The formulas at the present pose"}),M("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},M("thead",{},M("tr",{},M("th",{text:"branch"}),t)),M("tbody",{},n.map((e,i)=>M("tr",{},M("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>M("td",{text:fn(s,Je(v.table.joints[r]))}))))))]}var YS={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=M("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=M("div",{class:"equations","data-testid":"equations"}),c=We("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,b=>{i=b,y()},"equation-numbers"),u=M("div",{class:"scroll"});n.append(M("div",{class:"line spread"},M("span",{class:"line"},We("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,b=>{e=b,y()},"which-equations"),c),St("Copy LaTeX",{class:"quiet"},()=>Xr(f()))),a,u,l);let h=b=>b.symbols&&i==="present"?ep(b,v.table,v.q):b.latex,d=b=>b.number===void 0?"":` \\tag{${b.number}}`,f=()=>o.map(b=>b.kind==="equation"?`\\[ ${h(b)}${d(b)} \\]`:bL(b.pieces)).join(`

`);function p(b){r=[],Wt(l,o.map(A=>g(b,A))),m()}async function y(){if(t.hidden||!v.table.joints.length)return;let b=`${e}/${i}/${JSON.stringify(v.table.joints)}${v.table.convention}`;if(s!==b){s=b,bt(a,"Deriving \u2026"),Wt(l);try{let[A,T]=await Promise.all([yL(),Fe("equations",{which:e,numbers:i==="symbols"?i:"numbers"},x=>bt(a,x.note??""))]);if(s!==b)return;bt(a,T.note??""),o=T.blocks,p(A),c.hidden=e!=="forward",Wt(u),_()}catch(A){if(s!==b)return;s=null,bt(a,A.message)}}}function g(b,A){if(A.kind==="heading"||A.kind==="step")return M("h3",{},XS(b,A.pieces));if(A.kind!=="equation")return M("p",{class:"prose"},XS(b,A.pieces));let T=M("div",{class:"formula"});try{b.render(h(A),T,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{T.replaceChildren(M("code",{text:h(A)}))}if(A.number!==void 0)return M("div",{class:"formula-row numbered"},T,M("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return T;let x=M("output",{class:"value","data-entry":String(A.entry)});return r.push({value:x,entry:A.entry}),M("div",{class:"formula-row"},T,x)}let m=Js(()=>{if(t.hidden)return;let b=v.frames[v.frames.length-1];for(let{value:A,entry:T}of r)bt(A,`= ${T%4===3?`${ni(b[T]*gt.factor("length"),gt.digits("length"))} ${gt.length}`:ni(b[T],4)}`)}),_=Ks(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:b}=await Fe("formulas",{T:v.frames.at(-1)});Wt(u,b.length&&e==="inverse"?ML(b):null)}catch{Wt(u)}},250),E=Ks(()=>{!t.hidden&&np&&o.length&&e==="forward"&&i==="present"&&p(np)},120);nt("q",E),nt("panel",E),nt("q",_),nt("units",_),nt("panel",y),nt("plan",y),nt(["q","units"],m)}};var SL=()=>v.frames.at(-1).slice();function ip(n,t){let e=v.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{ht("did",{label:c,key:u}),e[a]=l,t(),ht("path",n)},r=["from","to"].map(a=>{let l=zs(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=St("Take the present pose",{class:"quiet","data-testid":`${i}take-${a}`},()=>{s(a,SL(),`take \u201C${a}\u201D of the path`),l.show()});return{el:M("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return nt("path",a=>a!==n&&o()),nt("path-loaded",o),nt("notation",o),{el:M("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var ZS=()=>v.frames[v.frames.length-1].slice(),jS={id:"path",title:"Path",wide:!0,build(n,t){let e=v.path,i=ip("path",()=>h()),s=M("span",{class:"hint"}),r=bn({label:"Number of points N",testid:"path-n",check:m=>Number.isInteger(m)&&m>=2&&m<=2e3?null:"a whole number from 2 to 2000",input:m=>{ht("did",{label:"set the points of the path",key:"path-n"}),e.n=m}}),o=bn({label:"Seconds for the whole line",testid:"path-seconds",check:m=>m>0&&m<=3600?null:"more than 0, at most 3600",input:m=>{ht("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=m}}),a=St("Keep the orientation of \u201CFrom\u201D",{class:"quiet"},()=>{if(e.from&&e.to){let m=te(e.to);ht("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((_,E)=>{e.to[_]=m[E]}),i.show(),ht("path","path"),h()}}),l=St("Plan the line",{class:"primary","data-testid":"plan"},()=>d(v.q)),c=M("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=M("div",{class:"branches","data-testid":"branches"});n.append(i.el,M("div",{class:"line"},a,s),M("div",{class:"line"},M("label",{class:"field"},M("span",{class:"field-name",text:"Points N"}),r),M("label",{class:"field"},M("span",{class:"field-name",text:"Seconds"}),o),l,M("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,u);let h=()=>{if(!e.from||!e.to){bt(s,"");return}let m=T_(e.from,e.to);bt(s,`${he(us(Ui(te(e.to),te(e.from))),"length")} long${m>1e-6?`, turning ${he(m,"angle")}`:", orientation kept"}`),Go(Array.from({length:33},(_,E)=>te(ef(e.from,e.to,E/32))))};function d(m){return pa(n,c,()=>f(m))}async function f(m){bt(l,"Planning \u2026"),l.disabled=!0;try{let _=await Fe("follow",{T0:e.from,T1:e.to,n:e.n,start:m});v.track=_,p(_,m)}finally{bt(l,"Plan the line"),l.disabled=!1}}function p(m){if(Oi(c,m.explain,m.complete?"good":"wrong"),Wt(u,m.branches.length?M("h3",{text:"Branches that start at the first pose"}):null,m.branches.map((A,T)=>M("button",{type:"button",class:`branch ${T===m.chosen?"chosen":""}`,"aria-pressed":String(T===m.chosen),"data-testid":`branch-${T+1}`,disabled:!A.q,title:A.cause||"reaches the end",on:{click:async()=>{await Ii(A.q,.4,`take branch ${T+1}`),d(A.q)}}},M("span",{class:"branch-name",text:`${T+1}  ${A.label}`}),y(A.s),M("span",{class:"branch-end",text:A.complete?"to the end":A.q?`${A.points} of ${e.n}`:"starts outside the limits"})))),Go(m.path.map(te)),!m.q.length){Ni(null);return}let _=m.path.length,E=m.q.map((A,T)=>T+1),b=m.q.map((A,T)=>_>1?e.seconds*T/(_-1):0);Ni(dr({table:v.table,q:m.q,xs:E,xName:"point",xEnd:_,seconds:b,title:`${v.table.name}: straight line, ${m.q.length} of ${_} points`,events:m.events.map(A=>({...A,x:1+A.s*(_-1),short:A.cause}))}))}function y(m){let _=M("span",{class:"bar-fill"});return _.style.setProperty("width",`${100*m}%`),M("span",{class:"bar"},_)}let g=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};nt("panel",m=>{m==="path"&&(e.from??=ZS(),e.to??=ZS(),g())}),nt("path-loaded",g),nt("units",h),nt("table",m=>{["postures","name","gripper"].includes(m)||(c.hidden=!0,Wt(u),Go([]),t.hidden||g())})}};var JS=Math.PI/180,wL=()=>({turn_speed:180*JS,turn_acceleration:600*JS,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var EL=n=>v.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??ji(),xu=n=>Hn(da(EL(n)),v.frames.at(-1));function sp(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(c=>c!==null),a=Math.min(...o),l=Math.min(Math.max(...o),t[r]);o.length===2&&a<=l&&(i[t[r]]={...s,first:a,last:l})}),i.filter(Boolean)}function jo(n,t,{key:e,open:i}={}){ht("did",{label:t,key:e,open:i}),!v.program.length&&n.length&&(v.start??=v.q),v.program=n,ht("program")}var Jo=(n,t,e,i)=>jo(v.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function KS(n,t){ht("did",{label:t,key:"limits"}),v.limits={...rp(),...n},ht("program","limits")}var rp=()=>({...wL(),...v.limits});function QS(n,t="set the start of the program"){ht("did",{label:t}),v.start=n,ht("program")}var op=()=>v.start?.length===v.table.joints.length?v.start:v.q;function Al(){let n=rp(),t=v.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:op(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:v.program.map(({name:i,...s})=>s)}}var TL=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),xo=()=>v.routing??TL();function Rl(n,t,e=t){ht("did",{label:t,key:e}),v.routing={...xo(),...n},ht("routing")}var W0=()=>{let n=xo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function ap(){let n=xo(),t=v.path,e=v.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:W0(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:v.world,clearance:e?n.clearance:0}}function $0(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Cl=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function tw(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Cl(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>$0(n,l)(o,r))}var Ko=Math.PI/180,ew=3.4,AL=2.1,nw=.5,RL=.9;function iw({drag:n,drop:t,scrub:e}){let i=M("canvas",{"aria-hidden":"true"}),s=M("div",{class:"route-now",hidden:!0}),r=M("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(L=>M("div",{class:`route-end ${L}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":L==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${L}`,hidden:!0})),a=M("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function y(){let L=p(),F=a.clientWidth,j=a.clientHeight,X={l:ew*L,t:nw*L,w:F-(ew+RL)*L,h:j-(nw+AL)*L},J=-Math.PI,et=Math.PI;if(l.map&&!Cl(l.map))J=l.map.turn[0],et=l.map.turn.at(-1);else if(l.turn.length){let dt=90*Ko;J=Math.min(J,dt*Math.floor(Math.min(...l.turn)/dt)),et=Math.max(et,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...X,lo:J,hi:et,W:F,H:j}}let g=L=>u.l+L*u.w,m=L=>u.t+(1-(L-u.lo)/(u.hi-u.lo))*u.h,_=L=>u.lo+(1-(L-u.t)/u.h)*(u.hi-u.lo),E=L=>kt.curves[Math.max(l.branches.indexOf(L),0)%kt.curves.length];function b(){f=(l.map?.branches??[]).map((L,F)=>{let j=$0(l.map,F),X=l.map.s.length,J=l.map.turn.length,et=M("canvas",{width:X,height:J}),dt=et.getContext("2d"),ft=dt.createImageData(X,J),st=parseInt(E(L).slice(1),16);for(let yt=0;yt<X;yt++)for(let _t=0;_t<J;_t++){if(!j(yt,_t))continue;let At=4*((J-1-_t)*X+yt);ft.data.set([st>>16,st>>8&255,st&255,255],At)}return dt.putImageData(ft,0,0),{name:L,c:et}})}function A(){if(!l||!a.clientWidth)return;y();let L=Math.min(devicePixelRatio,2),F=i.getContext("2d");i.width=u.W*L,i.height=u.H*L,F.scale(L,L);let j=.76*p();F.font=`${j}px "Inter Variable", system-ui, sans-serif`,F.fillStyle=kt.ground,F.fillRect(u.l,u.t,u.w,u.h),F.save(),F.beginPath(),F.rect(u.l,u.t,u.w,u.h),F.clip(),T(F),x(F),S(F),F.restore(),D(F,j),N()}function T(L){let F=l.map;if(!F)return;let j=F.turn[1]-F.turn[0],X=Cl(F),J=F.turn[0]-j/2,et=F.turn.at(-1)+j/2,dt=X?Math.floor((u.lo-J)/(2*Math.PI)):0,ft=X?Math.ceil((u.hi-et)/(2*Math.PI)):0;for(let{name:st,c:yt}of f)if(!(c&&c!==st)){L.globalAlpha=(c?.4:.3)*(kt.dark?.8:1);for(let _t=dt;_t<=ft;_t++){let At=m(et+2*Math.PI*_t),Rt=m(J+2*Math.PI*_t);L.drawImage(yt,u.l,At,u.w,Rt-At)}}L.globalAlpha=1}function x(L){if(!l.blocked)return;let[F,j]=l.blocked.s,X=g(F),J=Math.max(g(j)-X,3);L.fillStyle=kt.wrong,L.globalAlpha=.75,L.fillRect(Math.min(X,u.l+u.w-J),u.t,J,u.h),L.globalAlpha=1}function S(L){if(!l.q.length)return;let F=[[0]];l.labels.forEach((j,X)=>{X&&j!==l.labels[X-1]&&F.push([X-1]),F.at(-1).push(X)});for(let[j,X]of[[.38,!0],[.18,!1]])for(let J of F){L.beginPath();for(let et of J)L.lineTo(g(l.s[et]),m(l.turn[et]));L.lineWidth=j*p(),L.lineJoin=L.lineCap="round",L.strokeStyle=X?kt.panel:kt.curves[l.labels[J.at(-1)]%kt.curves.length],L.stroke()}}function D(L,F){L.strokeStyle=kt.line,L.strokeRect(u.l,u.t,u.w,u.h),L.fillStyle=kt.muted,L.textBaseline="middle",L.textAlign="right";let j=(u.hi-u.lo)/Ko,X=[5,10,15,30,45,90,180].find(et=>j/et<=6)??180;for(let et=Math.ceil(u.lo/Ko/X-1e-9)*X;et<=u.hi/Ko+1e-6;et+=X){let dt=m(et*Ko);L.fillText(fn(et*Ko,"angle",gt.angle==="deg"?0:2),u.l-.45*F,dt),L.globalAlpha=.5,L.beginPath(),L.moveTo(u.l,dt),L.lineTo(u.l+u.w,dt),L.lineWidth=1,L.stroke(),L.globalAlpha=1}L.textBaseline="top",L.textAlign="center";let J=u.t+u.h+.45*F;for(let et of[0,.25,.5,.75,1])L.fillText(String(et),g(et),J);L.fillText("path, from 0 to 1",g(.5),J+1.15*F),L.save(),L.translate(.5*F,u.t+u.h/2),L.rotate(-Math.PI/2),L.textBaseline="middle",L.fillText(`turn of the tool, ${gt.symbol("angle")}`,0,0),L.restore()}let I=L=>h?.which===L?h.turn:L==="start"?l.turn[0]:l.turn.at(-1);function N(){o.forEach((L,F)=>{let j=F?"end":"start",X=!!(l?.turn.length&&l.map);if(L.hidden=!X,!X)return;let J=I(j);L.style.setProperty("left",`${g(F)}px`),L.style.setProperty("top",`${m(J)}px`),L.classList.toggle("pinned",d[j]),L.setAttribute("aria-valuemin",fn(u.lo,"angle",0).replace("\u2212","-")),L.setAttribute("aria-valuemax",fn(u.hi,"angle",0).replace("\u2212","-")),L.setAttribute("aria-valuenow",fn(J,"angle").replace("\u2212","-")),L.setAttribute("aria-valuetext",`${he(J,"angle")}${d[j]?", held":""}`)})}let H=L=>Math.min(Math.max(L,u.lo),u.hi);function V(L,F){h={which:L,turn:H(F)},N();let j=tw(l.map,L==="start"?0:1,h.turn);r.hidden=!1,bt(r,`${he(h.turn,"angle",1)}: ${j.length?j.join("; "):"closed on every branch"}`),r.dataset.tone=j.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(m(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",L==="end"),n(L,h.turn)}function k(){if(!h)return;let{which:L,turn:F}=h;r.hidden=!0,t(L,F)}o.forEach((L,F)=>{let j=F?"end":"start";L.addEventListener("pointerdown",X=>{X.preventDefault(),L.focus(),L.setPointerCapture(X.pointerId);let J=I(j)-_(X.clientY-a.getBoundingClientRect().top),et=ft=>V(j,_(ft.clientY-a.getBoundingClientRect().top)+J);L.addEventListener("pointermove",et);let dt=()=>{L.removeEventListener("pointermove",et),k()};L.addEventListener("pointerup",dt,{once:!0}),L.addEventListener("pointercancel",dt,{once:!0})}),L.addEventListener("keydown",X=>{let J={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[X.key];if(J)V(j,I(j)+J*Ko*(X.shiftKey?.1:1));else if(X.key==="Enter")k();else if(X.key==="Escape"&&h)O(),n(j,null);else return;X.preventDefault(),X.stopPropagation()}),L.addEventListener("blur",()=>h?.which===j&&k())}),i.addEventListener("pointerdown",L=>{if(!l?.q.length)return;let F=X=>e(Math.min(Math.max((X.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(L.pointerId),F(L),i.addEventListener("pointermove",F);let j=()=>i.removeEventListener("pointermove",F);i.addEventListener("pointerup",j,{once:!0}),i.addEventListener("pointercancel",j,{once:!0})});function O(){h=null,r.hidden=!0,l&&N()}return new ResizeObserver(Js(A)).observe(a),{el:a,paint(){l&&b(),A()},cancel:O,show(L,F=null,j={start:!1,end:!1}){l=L,d=j,h=null,r.hidden=!0,a.hidden=!L,L&&(c=F,b(),A())},only(L){c=L,A()},at(L){s.hidden=L===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${g(L)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(L,F=null){let j=a.getBoundingClientRect();return[j.x+g(L==="end"?1:0),j.y+m(F??I(L))]}}}var sw=Math.PI/180;function rw(){let n=(p,y,g)=>Rl({...p,start:null,end:null},y,g),t=(p,y,g)=>{let m=M("span",{class:"field-name"}),_=M("label",{class:"field"},m,g);return _.label=()=>{m.textContent=y==="plain"?p:`${p}, ${gt.symbol(y)}`},_},e=(p,y,g,m,_)=>{let E=bn({label:p,kind:y,testid:g,check:m,input:_});return{f:E,el:t(p,y,E)}},i=We("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*sw,45*sw]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,y=>Math.abs(y)<=4*Math.PI?null:"at most two turns",y=>{let g=xo().turn?.slice()??[0,0];g[p]=y,n({turn:g},"bound the turn of the route",`route-turn-${p}`)})),r=We("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=xn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=M("details",{class:"fold"},M("summary",{text:"More that is free, and what must be kept"}),M("div",{class:"line"},o.el),M("div",{class:"line"},M("label",{class:"field"},M("span",{class:"field-name",text:"Cheapest"}),a)),M("div",{class:"line"},l.el),M("div",{class:"line"},c.el)),h=M("div",{},M("div",{class:"line"},M("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),M("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let p=xo();i.mark(p.turn?"within":"free"),s.forEach((y,g)=>{y.el.hidden=!p.turn,y.f.put(p.turn?.[g]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,l.f.put(p.singularity),c.f.put(p.clearance),c.el.hidden=!v.world.some(y=>y.role!=="object"&&y.kind!=="frame"),d.forEach(y=>y.el.label())}return nt(["units","world"],f),nt("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var ow=n=>({id:"route",title:"Route",wide:!0,build(t){let e=v.path,i=null,s=null,r=null,o=ip("route",()=>_()),a=rw(),l=(O,L,F,j={})=>St(O,{"data-testid":L,...j},F),c=l("Find the route","find-route",()=>E(),{class:"primary"}),u=l("Let both ends free","free-ends",()=>{Rl({start:null,end:null},"let the ends of the route free"),E()}),h=l("Send to the program","route-to-program",H,{hidden:!0}),d=l("","route-others",N,{hidden:!0}),f=M("p",{class:"verdict",role:"status","data-testid":"route-verdict",hidden:!0}),p=M("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),y=M("div",{class:"branches","data-testid":"route-list"}),g=iw({drag:(O,L)=>L===null?gs(null):D(O,L),drop:(O,L)=>I(O,L),scrub:O=>r&&v.motion===r&&zr(T(O))}),m=M("details",{class:"fold",open:!0},M("summary",{text:"The line"}),o.el);g.el.hidden=!0,u.hidden=!0,t.append(M("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),m,a.el,M("div",{class:"line"},c,u,h),g.el,p,f,M("div",{class:"line"},d),y);let _=()=>{e.from&&e.to&&!i&&Go(Array.from({length:33},(O,L)=>te(ef(e.from,e.to,L/32))))};async function E(){let O=Rp(t);if(O){Oi(f,O);return}bt(c,"Looking \u2026"),c.disabled=!0;try{let L=await Fe("route",ap());L.stopped||b(L)}catch(L){g.cancel(),Oi(f,L.message)}finally{bt(c,"Find the route"),c.disabled=!1}}function b(O){let L=xo();if(i=v.route={...O,turn:A(O,L),asked:[e.from,e.to]},s=O.found?O.branches[O.labels[0]]:null,O.found&&(m.open=!1),f.hidden=!1,f.dataset.tone=O.found?"good":O.verdict==="IMPOSSIBLE"?"wrong":"note",bt(f,O.text),g.show(i,s,{start:!!L.start,end:!!L.end}),gs(null),u.hidden=!(L.start||L.end),h.hidden=!O.found,d.hidden=!1,bt(d,O.found?"Routes that begin with other postures":"What would let it through?"),Wt(y),x(),Go(O.points),!O.found){r=null,Ni(null);return}let F=O.q.length;r=dr({table:v.table,q:O.q,xs:O.q.map((j,X)=>X+1),xName:"point",xEnd:F,seconds:O.s.map(j=>e.seconds*j),title:`${v.table.name}: route, ${F} points`}),Ni(r)}function A(O,L){if(!O.found||!O.map||!Cl(O.map))return O.turn;let F=L.start?L.start.turn-O.turn[0]:L.end?L.end.turn-O.turn.at(-1):0;return O.turn.map(j=>j+2*Math.PI*Math.round(F/(2*Math.PI)))}let T=O=>i.s.reduce((L,F,j)=>Math.abs(F-O)<Math.abs(i.s[L]-O)?j:L,0);function x(){Wt(p,i.branches.map((O,L)=>{let F=M("span",{class:"swatch"});return F.style.setProperty("background",kt.curves[L%kt.curves.length]),M("button",{type:"button",class:"chip","aria-pressed":String(s===O),title:s===O?"Show all branches":"Show this branch alone","data-testid":`route-branch-${L+1}`,on:{click:()=>{s=s===O?null:O,g.only(s),x()}}},F,O)}))}let S=(O,L)=>{let F=O==="start",j=F?0:i.q.length-1;return{T:F?e.from:e.to,turn:L,free:W0(),near:i.q[j],branch:i.branches[i.labels[j]]}},D=Zs(async(O,L)=>{let F=await Fe("route_posture",S(O,L)).catch(()=>null);gs(F?.q??null)});async function I(O,L){try{let F=await Fe("route_posture",S(O,L));if(!F.q)throw new Error(`The route cannot ${O} there. ${F.why}`);Rl({[O]:{turn:L,q:F.q,branch:F.label}},`turn the ${O} of the route to ${he(L,"angle",1)}`),await E()}catch(F){gs(null),g.cancel(),Me(F.message,"wrong")}}async function N(){d.disabled=!0,bt(d,"Looking \u2026");try{let O=await Fe("route_others",ap());if(O.stopped)return;let L=F=>`cost ${Number(F.toPrecision(3))}`;Wt(y,O.relaxations.map(F=>M("p",{class:"verdict","data-tone":"note",text:F})),O.alternatives.map((F,j)=>M("button",{type:"button",class:"branch","data-testid":`route-other-${j+1}`,on:{click:async()=>{Rl({start:{turn:F.turn,q:F.q,branch:F.branch},end:null},`begin the route ${F.branch}`),await E()}}},M("span",{class:"branch-name",text:F.branch}),M("span",{class:"hint",text:`begins turned ${he(F.turn,"angle",1)}`}),M("span",{class:"branch-end",text:L(F.cost)}))),O.relaxations.length+O.alternatives.length?null:M("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),d.hidden=!0}catch(O){Oi(f,O.message)}finally{d.disabled=!1,i&&bt(d,i.found?"Routes that begin with other postures":"What would let it through?")}}async function H(){h.disabled=!0;try{let O=await Fe("route_program",ap());if(O.stopped)return;let L=!v.program.length,F=L?O.steps.slice(1):O.steps;L&&(v.start=O.steps[0].q),jo([...v.program,...F],"send the route to the program");let j=`${he(O.metres,"length",3)} and ${he(O.radians,"angle",3)}`;Me(`Sent as a spline through ${O.poses} poses; it strays by at most ${j}.`),n()?.("program")}catch(O){Oi(f,O.message)}finally{h.disabled=!1}}let V=()=>{v.routing&&(v.routing={...v.routing,start:null,end:null})};function k(){i=v.route=null,f.hidden=!0,g.show(null),h.hidden=d.hidden=u.hidden=!0,Wt(p),Wt(y),gs(null)}nt("panel",O=>{if(O!=="route")return;let L=()=>v.frames.at(-1).slice();e.from??=L(),e.to??=L(),o.show(),_(),i&&g.paint()}),nt("played",()=>{!r||v.motion!==r?g.at(null):g.at(i.s[iS()]??null)}),nt("motion",()=>v.motion!==r&&g.at(null)),nt("theme",()=>{g.paint(),i&&x()}),nt("units",()=>g.paint()),nt("routing",O=>{O==="undo"&&i&&E()}),nt(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(V(),k())}),nt("table",O=>{["postures","name","gripper"].includes(O)||(O!=="undo"&&V(),k())}),g.el.addEventListener("where",O=>Object.assign(O.detail,{at:g.place(O.detail.which,O.detail.turn)}))}});function aw(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>Jo(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let p=bn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:y=>{n(()=>e(u,{[h]:y},h))}});return p.put(v.program[u][h]??null),M("label",{class:"field"},M("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),p)}let s=(u,h)=>{let d=v.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>zs(d,`step-${u+1}-${h}`,()=>v.program[u]?.[h],f=>{let p=v.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...p}:{[h]:f},h))}).el;function a(u,h){let d=We("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",y=>Jo(h,y==="centre"?{centre:te(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return M("div",{},M("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((y,g)=>{let m=bn({label:`Step ${h+1}, centre ${y}`,kind:"length",testid:`step-${h+1}-centre-${g}`,input:_=>{let E=v.program[h].centre.slice();E[g]=_,n(()=>e(h,{centre:E},"centre"))}});return m.put(u.centre[g]),M("label",{class:"field"},M("span",{class:"field-name",text:y}),m)}),p=M("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:p.checked},"far")}});return M("div",{},M("div",{class:"line"},d),M("div",{class:"line"},...f,M("span",{class:"unit",text:gt.length})),M("label",{class:"check"},p,"the longer way round"))}function l(u,h){let d=f=>Jo(h,{through:f,T:f.at(-1)},t(h));return M("div",{class:"line"},M("span",{class:"field-name",text:`Goes through ${u.through.length} poses, the last one its target`}),St("Add the present pose",{class:"quiet","data-testid":`step-${h+1}-through`},()=>d([...u.through,xu(h)])),St("Take the last one out",{class:"quiet",disabled:u.through.length<2},()=>d(u.through.slice(0,-1))))}function c(u,h){return u.kind==="wait"?M("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?M("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?M("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?M("div",{class:"step-editor"},o(h)("T","The frame, in the base"),M("div",{class:"line"},St("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>Jo(h,{T:v.frames.at(-1).slice()},`teach step ${h+1}`)),St("The base",{class:"quiet",title:"The poses that follow are meant in the base again"},()=>Jo(h,{T:ji()},`end the frame at step ${h+1}`)))):u.kind==="output"?M("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),M("label",{class:"check"},M("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):M("div",{class:"step-editor"},M("div",{class:"line"},xn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:gt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${gt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?l(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),M("div",{class:"line"},St("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>Jo(h,{...s(h,xu(h)),q:u.kind==="joint"?v.q.slice():null},`teach step ${h+1}`)),u.q?St("Go there",{class:"quiet"},()=>Ii(u.q.slice(),.8,`go to step ${h+1}`)):null))}return c}function lw(){let n=M("div",{class:"line limits-of"}),t=()=>{let e=new Set(v.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=bn({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>KS({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(rp()[r]),c===null&&(u.placeholder="none"),M("label",{class:"field"},M("span",{class:"field-name",text:`${o}, ${gt.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Wt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return nt(["table","units"],t),nt("program",e=>e==="undo"&&t()),t(),n}var lp={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function q0(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>fn(t,Je(v.table.joints[e]??{type:"R"}),1)).join(", "):`${te(n.T).map(t=>fn(t,"length",1)).join(", ")} ${gt.length}${n.kind==="spline"?`, ${n.through.length} poses`:""}`}var cw=200,CL=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Pl=()=>xu(cp()),cp=()=>v.program.length,uw={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=M("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=M("p",{class:"verdict",role:"status","data-testid":"program-verdict",hidden:!0}),o=M("details",{class:"fold",hidden:!0},M("summary",{text:"What binds, and when"}),M("p",{class:"hint prose"})),a=(x,S,D,I)=>St(S,{title:D,"data-testid":`step-add-${x}`},()=>f(I())),l=St("Run the program",{class:"primary","data-testid":"run-program"},b),c=M("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(M("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:v.q.slice(),T:Pl(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Pl(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Pl(),blend:0})),a("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Pl()],T:Pl(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),a("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:v.frames.at(-1).slice()})),a("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max(cp(),1),times:1}))),M("div",{class:"line spread"},c,M("span",{class:"line"},St("Start here",{class:"quiet","data-testid":"start-here",title:"The program begins in the present posture"},()=>QS(v.q.slice())),St("Go to the start",{class:"quiet"},()=>Ii(op().slice(),.8,"go to the start")))),s,lw(),M("div",{class:"line"},l,M("span",{class:"line"},xn("Language of the file",CL,u,x=>{u=x},{"data-testid":"dialect"}),St("Save the program",{"data-testid":"save-program"},T))),r,o),cp=()=>t>=0?t+1:v.program.length;let h=()=>v.program.slice(0,cp()).findLast(x=>x.T&&x.kind!=="frame")?.T??Pl(),d=()=>v.program.findLast(x=>x.kind==="gripper")?.value??0;function f(x){if(v.program.length>=cw){Me(`At most ${cw} steps.`,"wrong");return}let S=t>=0?t+1:v.program.length;t=S;let D=sp(v.program,v.program.map((I,N)=>N<S?N:N+1));if(x.kind==="call"&&!S){Me("There is no step before it that could be done again.","wrong"),t=-1;return}jo([...D.slice(0,S),x,...D.slice(S)],`add a step: ${lp[x.kind].toLowerCase()}`)}function p(x,S){if(S<0||S>=v.program.length||x===S)return;let D=v.program.map((N,H)=>H);D.splice(S,0,...D.splice(x,1));let I=sp(v.program,v.program.map((N,H)=>D.indexOf(H)));t=S,jo(I,`move step ${x+1} to ${S+1}`),s.children[S]?.querySelector(".step-name")?.focus()}function y(x){t=-1,jo(sp(v.program,v.program.map((S,D)=>D===x?-1:D<x?D:D-1)),`remove step ${x+1}`)}function g(x,S){let D=S===t,I=M("button",{type:"button",class:"step-name quiet","aria-expanded":String(D),"data-testid":`step-${S+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=D?-1:S,E()},keydown:H=>{let V={ArrowUp:-1,ArrowDown:1}[H.key];V&&H.altKey?(H.preventDefault(),p(S,S+V)):V?(H.preventDefault(),s.children[S+V]?.querySelector(".step-name")?.focus()):H.key==="Delete"&&y(S)}}},M("b",{text:lp[x.kind]}),` ${q0(x)}`,x.blend?M("span",{class:"hint",text:`, blend ${he(x.blend,"length",0)}`}):null),N=M("li",{class:`step${e?.step===S?" failed":""}${D?" open":""}`,draggable:"true","data-testid":`step-row-${S+1}`},M("div",{class:"step-line"},M("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),M("span",{class:"hint",text:String(S+1)}),I,St("\u2191",{class:"icon",disabled:S===0,"aria-label":`Move step ${S+1} up`},()=>p(S,S-1)),St("\u2193",{class:"icon",disabled:S===v.program.length-1,"aria-label":`Move step ${S+1} down`},()=>p(S,S+1)),St("\xD7",{class:"icon","aria-label":`Remove step ${S+1}`},()=>y(S))),e?.step===S?M("p",{class:"reason",text:e.text}):null,D?_(x,S):null);return N.addEventListener("dragstart",H=>{i=S,H.dataTransfer.effectAllowed="move",H.dataTransfer.setData("text/plain",String(S))}),N.addEventListener("dragover",H=>{i<0||(H.preventDefault(),N.classList.add("target"))}),N.addEventListener("dragleave",()=>N.classList.remove("target")),N.addEventListener("drop",H=>{H.preventDefault();let V=i;i=-1,V>=0&&p(V,S)}),N}let m=!1,_=aw(x=>{m=!0,x(),m=!1});function E(){if(m){v.program.forEach((S,D)=>{let I=s.children[D]?.querySelector(".step-name");I&&Wt(I,M("b",{text:lp[S.kind]}),document.createTextNode(` ${q0(S)}`))});return}t>=v.program.length&&(t=-1),Wt(s,v.program.map(g)),v.program.length||s.append(M("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.disabled=!v.program.length;let x=op();bt(c,v.program.length?`Starts at ${x.map((S,D)=>fn(S,Je(v.table.joints[D]),1)).join(", ")}`:"")}function b(){return pa(n,r,A)}async function A(){l.disabled=!0,bt(l,"Planning \u2026");try{let x=await Fe("program",{...Al(),world:v.world});e=x.failed,e&&(t=e.step),Oi(r,e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[x.explain,x.clear?.text].filter(Boolean).join(`
`),e||x.clear?.verdict==="HIT"?"wrong":x.clear?.verdict==="UNCERTAIN"?"note":"good"),o.hidden=!x.tight.length,bt(o.lastChild,x.tight.map(D=>D.text).join(`
`)),E();let S=x.events.map(([D,I,N])=>({x:D,s:0,text:`${I} ${N} at ${D.toFixed(2)} s`,short:I==="gripper"?N>.5?"close":"open":I,stop:!1}));Ni(Object.assign(dr({table:v.table,q:x.q,xs:x.t,xName:"time",seconds:x.t,dq:x.dq,events:S,title:`${v.table.name}: program, ${x.duration.toFixed(2)} s`}),{ddq:x.ddq,happens:x.events,tight:x.tight,limits:Al().limits}))}finally{l.disabled=!v.program.length,bt(l,"Run the program")}}async function T(){try{let x="program",{text:S,name:D}=await Fe("program_file",{...Al(),dialect:u,name:x});ui(D,S)}catch(x){Oi(r,x.message)}}nt(["program","units","table"],x=>{x!=="limits"&&(e=null,E())}),E()}};var Qo=new An,up=new il,PL=new _e,IL=n=>new oi({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function X0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new ke(e,3)),n}var hw=n=>n.rotateX(Math.PI/2),Y0={box:n=>[X0(new ki(...n.size)),n.T],cylinder:n=>[X0(hw(new Ri(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new G(...n.a),e=new G(...n.b).sub(t),i=e.length(),s=new _e().makeRotationFromQuaternion(new hn().setFromUnitVectors(new G(0,0,1),i?e.clone().normalize():new G(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[X0(hw(new Lo(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function Z0(n,t,e=.86){if(!Y0[n.kind])return null;let[i,s]=Y0[n.kind](n),r=IL(t);r.opacity=e,r.depthWrite=e>.5;let o=new je(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var LL=()=>[...v.world,...v.things??[]];function DL(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=te(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Ys(n.T,s)[o])))}function fw(){dn.add(Qo,up.group),nt(["world","table"],dw),nt("theme",()=>{up.paint(),dw()})}var yu=new Map;function j0(n,t){if(t)yu.set(n,t);else if(!yu.delete(n))return;let e=Qo.children.find(s=>s.userData.name===n),i=v.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),ye()}var pw=n=>yu.get(n)??null;function mw(){for(let n of[...yu.keys()])j0(n,null)}function dw(){for(let t of Qo.children)t.geometry.dispose();Qo.clear();let n=LL();for(let t of n)if(t.kind==="curve"){let e=new Se().setFromPoints(t.points.map(i=>new G(...i)));Qo.add(new ir(e,new es({color:kt.trace,fog:!1})))}else if(Y0[t.kind]){let{mesh:e,T:i}=Z0(t,t.role==="object"?kt.accent:kt.ghost);e.matrix.copy(PL.set(...yu.get(t.name)??i)),e.userData.name=t.name,Qo.add(e)}up.show(n.filter(t=>t.kind==="frame"),.11*ci(v.table)),Or("world",n.flatMap(DL)),ye()}var gw=()=>Qo.children.length+(up.last?.[0].length??0);var Ll=new ir(new Se,new es({depthTest:!1,fog:!1})),Dl=new Cr(new Se,new sr({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Ll.renderOrder=Dl.renderOrder=6;Ll.frustumCulled=Dl.frustumCulled=!1;Ll.visible=Dl.visible=!1;var Il=new An,vu=null,_w="",UL=()=>v.watch||v.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),FL=Zs(async()=>{try{let n=await Fe("clearance",{q:v.q,world:v.world});v.clearance=n}catch(n){v.clearance={refused:n.message}}J0(),ht("clearance")});function xw(){UL()&&v.table.joints.length?FL():v.clearance&&(v.clearance=null,J0(),ht("clearance"))}function J0(){let n=v.clearance,t=!!n?.points?.length;if(Ll.visible=Dl.visible=t,t){let e=n.points.map(i=>new G(...i));for(let i of[Ll,Dl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?kt.trace:kt.wrong)}ye()}async function K0(n){if(vu=null,n){let{bodies:t,explain:e}=await Fe("bodies",{});vu=t,_w=e}for(let t of Il.children)t.geometry.dispose();Il.clear();for(let t of vu??[]){let e=Z0(t,kt.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},Il.add(e.mesh))}return vw(),_w}var yw=()=>Il.children.length,OL=new _e;function vw(){for(let n of Il.children){let{on:t,T:e}=n.userData;v.frames[t]&&n.matrix.copy(OL.set(...Hn(v.frames[t],e)))}ye()}function bw(){dn.add(Ll,Dl,Il),nt(["q","world","watch"],xw),nt("plan",xw),nt("q",()=>vu&&vw()),nt("table",()=>vu&&K0(!1).then(()=>ht("bodies-gone"))),nt("theme",J0)}var kL=60,zL={box:"Box",cylinder:"Cylinder",frame:"Frame"},HL={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function Q0(n,t,e={}){ht("did",{label:t,...e}),v.world=n,ht("world")}var hp=(n,t,e)=>Q0(v.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function GL(n,t){if(v.world.length>=kL)return;let e=te(v.frames.at(-1)),i=.06*ci(v.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*v.world.length;let o=t==="object"?"object":n,a=1;for(;v.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};Q0([...v.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var Mw={id:"world",title:"World",wide:!0,build(n){let t=M("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=M("p",{class:"hint prose"}),i=M("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{v.watch=i.checked,ht("watch")}}}),s=M("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await K0(s.checked);bt(e,s.checked?h:"")}catch(h){bt(e,h.message)}}}}),r=M("div",{class:"things","data-testid":"world"}),o=(h,d,f,p)=>St(h,{title:p,"data-testid":`add-${f}-${d}`},()=>GL(d,f));n.append(M("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),M("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),M("div",{class:"line"},M("label",{class:"check"},i,"Distance, always"),M("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),nt(["clearance","units"],()=>{let h=v.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];bt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${he(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${he(-h.metres,"length")}.`))}),nt("bodies-gone",()=>{s.checked=!1,bt(e,"")});let l=!1,c=()=>{l||(Wt(r,v.world.map(u)),v.world.length||r.append(M("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=m=>(..._)=>{l=!0,m(..._),l=!1},p=M("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>p.value&&hp(d,{name:p.value},`name ${p.value}`)}}),y=HL[h.kind].map((m,_)=>{let E=bn({label:`${h.name}, ${m}`,kind:"length",testid:`world-${d+1}-size-${_}`,check:b=>b>0?null:"more than 0",input:f(b=>{let A=v.world[d],T=h.kind==="box"?{size:A.size.map((x,S)=>S===_?b:x)}:{[_?"h":"r"]:b};hp(d,T,`size of ${h.name}`)})});return E.put(h.kind==="box"?h.size[_]:_?h.h:h.r),M("label",{class:"field"},M("span",{class:"field-name",text:`${m}, ${gt.length}`}),E)}),g=zs("Place of its middle",`world-${d+1}`,()=>v.world[d]?.T,f(m=>hp(d,{T:m},`move ${h.name}`)));return M("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},M("div",{class:"line spread"},M("span",{class:"line"},p,M("span",{class:"hint",text:zL[h.kind]}),h.kind==="frame"?null:xn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,m=>hp(d,{role:m},`make ${h.name} an ${m}`))),St("\xD7",{class:"icon","aria-label":`Remove ${h.name}`},()=>Q0(v.world.filter((m,_)=>_!==d),`remove ${h.name}`))),y.length?M("div",{class:"line"},y):null,g.el)}nt(["world","units"],h=>h!=="python"&&c()),c()}};var VL=40,Sw={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return v.sequence.postures},set postures(h){v.sequence.postures=h},get rate(){return v.sequence.rate}},e=M("thead"),i=M("tbody"),s=M("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=St("Run the sequence",{class:"primary","data-testid":"run-sequence"},c),o=St("Same times for all legs",{class:"quiet",title:"Copy the first leg\u2019s time and rest to the others"},()=>{let h=t.postures[1];if(h){ht("did",{label:"use the same times for all legs"});for(let d of t.postures.slice(2))d.seconds=h.seconds,d.hold=h.hold;l()}});n.append(M("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),M("div",{class:"scroll"},M("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),M("div",{class:"line"},St("+ Present posture",{class:"add","data-testid":"add-posture"},()=>a(v.q.slice())),St("+ All named postures",{},()=>Object.entries(v.table.postures??{}).forEach(([h,d])=>a(d.slice(),h))),o),M("div",{class:"line"},r),s);function a(h,d){t.postures.length>=VL||(ht("did",{label:"add a posture to the sequence"}),t.postures.push({name:d??`P${t.postures.length}`,q:h,seconds:5,hold:0}),l(),ht("sequence"))}function l(){let h=v.table.joints;t.postures=t.postures.filter(d=>d.q.length===h.length),r.disabled=t.postures.length<2,Wt(e,M("tr",{},M("td"),h.map((d,f)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(f+1)}),M("span",{class:"unit",text:` ${gt.symbol(Je(d))}`}))),M("th",{text:"leg, s"}),M("th",{text:"rest, s"}),M("td"))),Wt(i,t.postures.map((d,f)=>{let p=h.map((g,m)=>{let _=bn({label:`${d.name}, q${m+1}`,kind:Je(g),testid:`seq-${f}-q${m+1}`,input:E=>{ht("did",{label:`edit ${d.name} of the sequence`,key:`seq-${f}-${m}`}),d.q[m]=E,ht("sequence")}});return _.put(d.q[m],String(Number((d.q[m]*gt.factor(Je(g))).toFixed(gt.digits(Je(g))))+0)),M("td",{},_)}),y=(g,m,_)=>{if(f===0)return M("td");let E=bn({label:`${m} ${d.name}`,testid:`seq-${f}-${g}`,check:_,input:b=>{ht("did",{label:`edit ${d.name} of the sequence`,key:`seq-${f}-${g}`}),d[g]=b,ht("sequence")}});return E.put(d[g]),M("td",{},E)};return M("tr",{"data-testid":`seq-row-${f}`},M("th",{scope:"row"},St(d.name,{class:"quiet",title:"Go there"},()=>Ii(d.q.slice()))),p,y("seconds","Seconds to",g=>g>0?null:"more than 0"),y("hold","Rest after",g=>g>=0?null:"0 or more"),M("td",{class:"tools"},St("\u2191",{class:"icon",disabled:f===0,"aria-label":`Move ${d.name} up`},()=>{ht("did",{label:`move ${d.name} up`}),t.postures.splice(f-1,0,...t.postures.splice(f,1)),l()}),St("\xD7",{class:"icon","aria-label":`Remove ${d.name}`},()=>{ht("did",{label:`remove ${d.name}`}),t.postures.splice(f,1),l(),ht("sequence")})))})),t.postures.length||i.append(M("tr",{},M("td",{class:"hint",colspan:String(h.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}function c(){return pa(n,s,u)}async function u(){r.disabled=!0;try{let h=t.postures,d=await Fe("motion",{postures:h.map(p=>p.q),seconds:h.slice(1).map(p=>p.seconds),holds:h.slice(1).map(p=>p.hold),rate:t.rate}),f=h.map((p,y)=>({x:d.arrivals[y],s:0,text:`${p.name} at ${d.arrivals[y].toFixed(2)} s`,short:p.name,stop:!1}));Oi(s,`${h.length} postures in ${d.t[d.t.length-1].toFixed(2)} s. ${WL(d.q)}`,"good"),Ni(dr({table:v.table,q:d.q,xs:d.t,xName:"time",seconds:d.t,dq:d.dq,events:f,title:`${v.table.name}: ${h.map(p=>p.name).join(" \u2013 ")}`}))}finally{r.disabled=t.postures.length<2}}nt(["table","units","sequence-loaded"],l),l()}};function WL(n){let t=v.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var $L=.14,yo=new je(new Ps(1,32,20),new oi({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));yo.matrixAutoUpdate=!1;yo.visible=!1;yo.renderOrder=4;var bu="none";function qL(n,t,e){let i=C_(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function ww(n){bu=n,Ew()}var dp=()=>v.ellipsoid??null;function Ew(){let n=bu!=="none"&&v.table.joints.length>0;if(yo.visible=n,v.ellipsoid=null,n){let t=qL(v.table,v.q,v.frames),e=$L*ci(v.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(bu==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=te(v.frames.at(-1)),[a,l]=r,c={...r[2]};yo.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),yo.material.color.set(bu==="velocity"?kt.trace:kt.accent),yo.material.side=fi,v.ellipsoid=t}ye(),ht("ellipsoid")}function Tw(){dn.add(yo),nt(["q","theme"],()=>bu!=="none"&&Ew())}var fp=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ne(n)),t_=new sr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Wi=new Cr(new Se,t_);Wi.frustumCulled=!1;Wi.visible=!1;dn.add(Wi);var Nl=null,Mu=null,$i=0,vo={lo:0,hi:1};function Aw(n){Nl=new Float32Array(3*n),Mu=new Float32Array(n),$i=0,Wi.geometry.dispose(),Wi.geometry=new Se,Wi.geometry.setAttribute("position",new ke(Nl,3)),Wi.geometry.setAttribute("color",new ke(new Float32Array(3*n),3)),Wi.geometry.setDrawRange(0,0),Wi.visible=!0,ye()}function Rw(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&$i<Mu.length;i+=4,$i++)Nl.set(e.subarray(i,i+3),3*$i),Mu[$i]=e[i+3];YL()}function YL(){let n=Mu.slice(0,$i).sort();vo.lo=n[Math.floor($i*.02)]??0,vo.hi=n[Math.max(Math.ceil($i*.98)-1,0)]??1;let t=new ne,e=Wi.geometry.attributes.color.array,i=vo.hi-vo.lo||1;for(let s=0;s<$i;s++){let r=Math.min(Math.max((Mu[s]-vo.lo)/i,0),1)*(fp.length-1),o=Math.min(Math.floor(r),fp.length-2);t.lerpColors(fp[o],fp[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Wi.geometry.setDrawRange(0,$i),Wi.geometry.attributes.position.needsUpdate=!0,Wi.geometry.attributes.color.needsUpdate=!0,ye()}var Su=()=>$i;function Cw(n){ss.localClippingEnabled=n!==null,t_.clippingPlanes=n===null?null:[new ri(new G(0,1,0),-n)],t_.needsUpdate=!0,ye()}function Pw(){let n=new Bi;for(let i=0;i<$i;i++)n.expandByPoint(new G(Nl[3*i],Nl[3*i+1],Nl[3*i+2]));let{min:t,max:e}=n;return $i?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Iw(){$i=0,Wi.visible=!1,ye()}var Dw=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],pp=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ni(n,4):n.toExponential(2).replace("-","\u2212"),Nw={id:"analysis",title:"Analysis",build(n){let t=M("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(M("div",{title:h},M("dt",{text:u}),i[c]=M("dd",{"data-testid":`fact-${c}`})));let s=M("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=M("p",{class:"hint","data-testid":"ellipsoid-axes"});nt("ellipsoid",()=>{let c=dp();bt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>he(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,M("h3",{text:"At the tool\u2019s point"}),We("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",ww,"ellipsoid"),o,M("h3",{text:"Distance to the limits"}),s,M("h3",{text:"Reachable points"}),ZL());let a=()=>{r=v.table.joints.map((c,u)=>{let h=M("span",{class:"bar-fill"}),d=M("span",{class:"bar-text"});return{el:M("div",{class:"distance"},M("span",{},M("i",{text:"q"}),M("sub",{text:String(u+1)})),M("span",{class:"bar"},h),d),fill:h,text:d}}),Wt(s,r.map(c=>c.el)),l()},l=Js(()=>{if(n.closest(".panel").hidden||!v.table.joints.length)return;let c=Du(v.table,v.q,v.frames),u=c[0],h=c[c.length-1];bt(i.manipulability,pp(c.reduce((d,f)=>d*f,1))),bt(i.condition,u>1e-9?ni(h/u,1):"\u221E"),bt(i.least,pp(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},y)=>{let g=v.table.joints[y],m=v.q[y];if(g.lower===null||g.upper===null){f.style.setProperty("width","100%"),bt(p,"no limit");return}let _=Math.min(m-g.lower,g.upper-m),E=Math.max(2*_/(g.upper-g.lower||1),0);f.style.setProperty("width",`${100*E}%`),d.classList.toggle("outside",_<-1e-9),bt(p,_<-1e-9?`${he(-_,Je(g))} beyond`:he(_,Je(g)))})});nt("table",a),nt(["q","units","panel"],l),a()}};function ZL(){let n="20000",t="manipulability",e=!1,i=St("Draw the cloud",{class:"primary","data-testid":"cloud-start"},()=>e?Ji("cancel",{kind:"cloud"}):d()),s=St("Clear",{},h),r=We("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>Cw(f==="half"?v.table.base[7]:null),"cloud-cut"),o=M("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=M("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=M("span"),c=M("span"),u=M("div",{class:"legend-scale",hidden:!0},l,M("span",{class:"scale-bar"}),c);function h(){Iw(),Or("cloud",[]),u.hidden=!0,bt(a,"")}async function d(){e=!0,bt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,Aw(Number(n));try{let f=await Fe("cloud",{count:Number(n),colour:t,seed:1},p=>{Rw(p.points),o.value=p.done/p.of,bt(l,pp(vo.lo)),bt(c,pp(vo.hi)),bt(a,`${p.done.toLocaleString("en")} of ${p.of.toLocaleString("en")} points`)});bt(a,f.stopped?`Cancelled after ${Su().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${Dw.find(([p])=>p===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){bt(a,f.message)}e=!1,Or("cloud",Pw()),tu(),bt(i,"Draw the cloud"),o.hidden=!0}return nt("table",f=>{f!=="postures"&&f!=="name"&&Su()&&h()}),M("div",{},M("div",{class:"line"},xn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),M("span",{class:"field-name",text:"coloured by"}),xn("Coloured by",Dw,t,f=>{t=f},{"data-testid":"cloud-colour"})),M("div",{class:"line"},i,s,r),o,u,a)}var Uw=n=>({id:"share",title:"Share",build(t,e){let i=M("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=M("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=M("p",{class:"hint",role:"status","data-testid":"report-note"}),o=St("Write the report",{class:"primary","data-testid":"report"},u),a=M("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(M("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),M("div",{class:"line share-link"},i,St("Copy the link",{"data-testid":"copy-link"},async()=>Xr(await wf()))),M("h3",{text:"As a file"}),M("div",{class:"line"},St("Save the state",{"data-testid":"save-state"},()=>ui(`${v.table.name||"arm"}.workbench.json`,JSON.stringify(Mf(),null,1),"application/json")),St("Open a state\u2026",{},()=>s.click()),s,St("Save the robot file",{"data-testid":"save-robot"},tp)),M("h3",{text:"As Python"}),M("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,M("div",{class:"line"},St("Copy the script",{"data-testid":"copy-python"},()=>Xr(a.value)),St("Save the script",{},()=>ui("workbench.py",a.value,"text/x-python"))),M("h3",{text:"Report"}),M("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),M("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&v.table.joints.length&&(i.value=await wf()),!e.hidden&&v.table.joints.length&&c()},c=Zs(async()=>{try{let{q:d,target:f,hasTarget:p,path:y,program:g}=v,{task:m,redundancy:_}=de,E={q:d,target:p?f:null,path:y,task:m,redundancy:_,program:Al()};a.value=(await Fe("python",g.length?E:{...E,program:null})).text}catch(d){a.value=`# ${d.message}`}});nt(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await Fe("report",{q:v.q},p=>bt(r,p.note));ui(f,d,"text/html"),bt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){bt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");Sf(JSON.parse(await f.text()),n()),Me("Opened")}catch(p){Me(p instanceof SyntaxError?`${f.name} is not a state file.`:p.message,"wrong")}}}});var jL=40,Ow=!1,Bw=0,e_=!1,mp=null,Fw=null;function kw(n){n&&(Ow=!0,mp=v.table,zw(n))}function zw(n){e_=!0,Bw=n.said,n.table&&(_n(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),mp=v.table,wl(n.looks??null,n.table)),n.things&&JL(n.things),n.target&&(v.hasTarget=!0,Mi(n.target,"restored")),n.q&&n.q.length===v.table.joints.length&&(ht("did",{label:"move from Python",key:"python"}),Fi(n.q,"python")),e_=!1}function JL(n){v.things=n.filter(i=>i.kind!=="motion"),ht("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==Fw){if(Fw=e,!t){Ni(null);return}Ni(dr({table:v.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${v.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var KL=ma(jL,()=>{let n=v.table===mp?void 0:Lp(v.table);mp=v.table,v.table.joints.length&&Ji("shown",{q:v.q,target:v.hasTarget?v.target:null,table:n,said:Bw}).catch(()=>{})});function Hw(){nt("push",zw),nt(["q","target","table"],()=>Ow&&!e_&&KL.soon())}var ta=new An,Vw=new oi({fog:!1}),n_=new oi({fog:!1}),i_=new ki(1,1,1),s_=new je(i_,Vw),Ww=[new je(i_,n_),new je(i_,n_)];ta.add(s_,...Ww);ta.matrixAutoUpdate=!1;ta.visible=!1;var wu=null;function $w(){dn.add(ta),nt("q",()=>wu!==null&&Xw()),nt("theme",Gw),Gw()}function Gw(){Vw.color.set(kt.joint),n_.color.set(kt.accent)}function r_(n){n===null&&wu===null||(wu=n,ta.visible=n!==null,n!==null&&Xw(),ye())}var qw=()=>wu;function Xw(){let n=v.frames.at(-1),t=.075*ci(v.table);s_.scale.set(.35*t,1.1*t,.25*t),s_.position.set(0,0,-.85*t),Ww.forEach((e,i)=>{let s=(.08+.36*(1-wu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),ta.matrix.set(...n),ta.updateMatrixWorld(!0)}var eD=.25,o_=.5;function nD(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(v.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=rD(n,r);if(o>=o_&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:us(Ui(te(u.at(-1).T),te(a)))})).filter(({name:c,d:u})=>u<iD(v.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:Hn(da(a),l.T)}))}else o<o_&&s&&i&&(e.get(i).push({t:r,T:Hn(a,e.get(i).at(-1).held)}),i=null);s=o>=o_}return{grips:t,objects:e}}var iD=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function sD(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var rD=(n,t)=>Es(n.table,n.q[sD(n.seconds,t)]).at(-1),bo=null,oD=n=>{let t=bo.grips.length?1-Math.round(bo.grips[0].value):0;for(let e of bo.grips){if(e.t>n)break;let i=Math.min((n-e.t)/eD,1);t+=i*(e.value-t)}return t};function Yw(){nt("motion",()=>{mw(),bo=v.motion?.happens?nD(v.motion):null,bo||r_(null)}),nt("played",n=>{if(!bo)return;let t=v.frames.at(-1);bo.grips.length&&r_(oD(n));for(let[e,i]of bo.objects){let s=i.findLast(r=>r.t<=n)??i[0];j0(e,s.held?Hn(t,s.held):s.T)}})}function Zw(){let n={q:()=>v.q.slice(),frames:()=>structuredClone(v.frames),target:()=>v.target.slice(),table:()=>structuredClone(v.table),solutions:()=>structuredClone(v.solutions),camera:()=>el(),pictures:()=>ev(),ghosts:()=>eb(),history:()=>[yf(),vf()],beyond:()=>Kv(),things:()=>gw(),looks:()=>bS(),program:()=>structuredClone(v.program),route:()=>structuredClone(v.route),motion:()=>structuredClone(v.motion),gripper:()=>qw(),stepFrame:()=>v.dhStep===null?null:Qd().at(-1).T,clearance:()=>structuredClone(v.clearance),bodies:()=>yw(),ellipsoid:()=>structuredClone(dp()),world:()=>structuredClone(v.world),framesDrawn:()=>Qv(),answers:()=>Bg.answers,trace:()=>rb(),cloud:()=>Su()},t={routePlace(e,i){let s={which:e,turn:i};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:s})),s.at},placeOf:e=>pw(e)??v.world.find(i=>i.name===e)?.T??null,go:zr,toScreen:Hi,withPicture:e=>Qa(e),handles:()=>Cv(),forward:(e,i)=>Es(e,i),convert:(e,i)=>Kf(e,i),read:(e,i)=>Hf(e,i),present:(e,i,s)=>ep(e,i,s)};for(let[e,i]of Object.entries(n))Object.defineProperty(t,e,{get:i,enumerable:!0});window.workbench=Object.freeze(t)}zd();iv(js("#view"));nt("theme",hg);hg();hb();Yv();Tv();fw();vS();bw();Tw();$w();Yw();Hw();O_();lb();ES(js("#bar"));AS(js("#overlay"));nS(js("#dock"));RS();var gp,Eu=(n,t,...e)=>[{...t,group:n},...e];gp=TS(js("#rail"),js("#panels"),js("#pinned"),[...Eu("Drive",{id:"move",title:"Move",sections:[ZM,PS]},kS),...Eu("Describe",qS,Mw),...Eu("Plan",jS,ow(()=>gp),uw,Sw),...Eu("Study",IS,YS,Nw),...Eu("Hand on",Uw(()=>gp))]);oS(js("#room"),js("#rail"));yb();var lD=_b().then(n=>n&&Sf(n,gp)).catch(n=>Me(`The link could not be read: ${n.message}`,"wrong"));nt("online",async n=>{if(!n)return;await lD;let t=await D_();v.catalog=t.catalog,ht("catalog"),t.table&&(!v.table.joints.length||t.bench)&&(_n(t.table,{q:fa(t.table),step:!1,what:"new"}),bf()),t.looks&&wl(t.looks,t.table),kw(t.bench),document.documentElement.dataset.ready="yes"});v.online&&ht("online",!0);document.fonts?.ready.then(()=>ht("theme"));Zw();
