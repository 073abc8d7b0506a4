import{A as b,B as Ui,C as Lu,D as ma,E as yn,F as I_,G as Si,H as L_,I as Du,K as Zi,L as js,a as ji,b as Hn,c as pa,d as te,e as Ys,f as Vl,g as Di,h as Wl,i as Ru,j as Ni,k as Cu,l as Pu,m as E_,n as T_,o as _r,p as xr,q as A_,r as Ss,s as Ep,t as R_,u as ci,v as Iu,w as C_,x as P_,y as nt,z as ut}from"./chunk-YTOPIUNI.js";function M(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ut=(n,t,e)=>M("button",{type:"button",text:n,...t,on:{click:e}}),ws=(n,t=document)=>t.querySelector(n),Wt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function bt(n,t){n.textContent!==t&&(n.textContent=t)}function Ve(n,t,e,i,s){let r=M("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(M("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function un(n,t,e,i,s={}){let r=M("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>M("option",{value:o,text:a})));return r.value=e,r}function Zs(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function ga(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Js(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function ui(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=M("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Xr(n){try{await navigator.clipboard.writeText(n)}catch{let t=M("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}Me("Copied")}var D_;function Me(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(D_),D_=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function N_(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var _a=0,Rp=-1,Tp=[];function Cp(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Ap(){let n=_a;if(!b.table.joints.length){b.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ut("plan");return}try{let{plan:t}=await Zi("arm",{table:Cp(b.table)});if(n!==_a)return;Rp=n,b.plan=t,U_()}catch(t){if(n!==_a||t instanceof Du)return;b.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},U_(t)}ut("plan")}function U_(n){let t=Tp;Tp=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var O_=Js(Ap,60);function F_(){nt("table",n=>{_a+=1,n==="postures"&&(Rp=-1),n==="cell"?O_():(O_.cancel(),Ap())}),nt("online",n=>{n&&(_a+=1,Ap())})}function y1(){return Rp===_a?Promise.resolve():new Promise((n,t)=>Tp.push({resolve:n,reject:t}))}async function Fe(n,t,e){return await y1(),Zi(n,t,e)}function B_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Nu(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var so={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ro={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},xx=0,sm=1,yx=2;var Ec=1,vx=2,$a=3,ir=0,ri=1,pi=2,Fo=0,qa=1,rm=2,om=3,am=4,bx=5;var Bo=100,Mx=101,Sx=102,wx=103,Ex=104,Tx=200,Ax=201,Rx=202,Cx=203,lm=204,cm=205,Px=206,Ix=207,Lx=208,Dx=209,Nx=210,Ux=211,Ox=212,Fx=213,Bx=214,lh=0,ch=1,uh=2,Da=3,hh=4,dh=5,fh=6,ph=7,um=0,kx=1,zx=2,sr=0,hm=1,dm=2,fm=3,pm=4,mm=5,gm=6,_m=7;var xm=300,ko=301,Xa=302,zh=303,Hh=304,mh=1e3,Qs=1001,gh=1002,ti=1003,Hx=1004;var Tc=1005;var Ai=1006,Gh=1007;var Pr=1008;var ns=1009,ym=1010,vm=1011,Ya=1012,Vh=1013,Ps=1014,ds=1015,Is=1016,Wh=1017,$h=1018,zo=1020,bm=35902,Mm=35899,Sm=1021,wm=1022,Ls=1023,Er=1026,Ir=1027,qh=1028,Xh=1029,oo=1030,Yh=1031;var jh=1033,Ac=33776,Rc=33777,Cc=33778,Pc=33779,Zh=35840,Jh=35841,Kh=35842,Qh=35843,td=36196,ed=37492,nd=37496,id=37488,sd=37489,Ic=37490,rd=37491,od=37808,ad=37809,ld=37810,cd=37811,ud=37812,hd=37813,dd=37814,fd=37815,pd=37816,md=37817,gd=37818,_d=37819,xd=37820,yd=37821,vd=36492,bd=36494,Md=36495,Sd=36283,wd=36284,Lc=36285,Ed=36286;var ec=2300,_h=2301,oh=2302,Zp=2303,Jp=2400,Kp=2401,Qp=2402;var Gx=3200;var Em=0,Vx=1,Lr="",Ei="srgb",nc="srgb-linear",ic="linear",We="srgb";var ah=7680,Tm=7681;var Am=517;var Wx=519,$x=512,qx=513,Xx=514,Rm=515,Yx=516,jx=517,Cm=518,Pm=519,Im=35044,Td=35048;var Lm="300 es",hs=2e3,sc=2001;function b1(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function M1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function rc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Zx(){let n=rc("canvas");return n.style.display="block",n}var k_={},Na=null;function oc(...n){let t="THREE."+n.shift();Na?Na("log",t,...n):console.log(t,...n)}function Jx(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ie(...n){n=Jx(n);let t="THREE."+n.shift();if(Na)Na("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function le(...n){n=Jx(n);let t="THREE."+n.shift();if(Na)Na("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Kl(...n){let t=n.join(" ");t in k_||(k_[t]=!0,ie(...n))}function Kx(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Qx={[lh]:lh,[uh]:fh,[hh]:hh,[Da]:dh,[ch]:ch,[fh]:uh,[ph]:ph,[dh]:Da},Rs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},hi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],z_=1234567,Ql=Math.PI/180,Ua=180/Math.PI;function ao(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(hi[n&255]+hi[n>>8&255]+hi[n>>16&255]+hi[n>>24&255]+"-"+hi[t&255]+hi[t>>8&255]+"-"+hi[t>>16&15|64]+hi[t>>24&255]+"-"+hi[e&63|128]+hi[e>>8&255]+"-"+hi[e>>16&255]+hi[e>>24&255]+hi[i&255]+hi[i>>8&255]+hi[i>>16&255]+hi[i>>24&255]).toLowerCase()}function Ee(n,t,e){return Math.max(t,Math.min(e,n))}function Dm(n,t){return(n%t+t)%t}function S1(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function w1(n,t,e){return n!==t?(e-n)/(t-n):0}function tc(n,t,e){return(1-e)*n+e*t}function E1(n,t,e,i){return tc(n,t,1-Math.exp(-e*i))}function T1(n,t=1){return t-Math.abs(Dm(n,t*2)-t)}function A1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function R1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function C1(n,t){return n+Math.floor(Math.random()*(t-n+1))}function P1(n,t){return n+Math.random()*(t-n)}function I1(n){return n*(.5-Math.random())}function L1(n){n!==void 0&&(z_=n);let t=z_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function D1(n){return n*Ql}function N1(n){return n*Ua}function U1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function O1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Nm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function F1(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ad(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Um(n,t){if(t.constructor===Float32Array)return n;let e=Ad(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Om(n,t){if(t.constructor===Float32Array)return n;let e=Ad(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var lo={DEG2RAD:Ql,RAD2DEG:Ua,generateUUID:ao,clamp:Ee,euclideanModulo:Dm,mapLinear:S1,inverseLerp:w1,lerp:tc,damp:E1,pingpong:T1,smoothstep:A1,smootherstep:R1,randInt:C1,randFloat:P1,randFloatSpread:I1,seededRandom:L1,degToRad:D1,radToDeg:N1,isPowerOfTwo:U1,ceilPowerOfTwo:O1,floorPowerOfTwo:Nm,setQuaternionFromProperEuler:F1,normalize:Om,denormalize:Um},Qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ee(this.x,t.x,e.x),this.y=Ee(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ee(this.x,t,e),this.y=Ee(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ee(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ee(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},dn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),T=Math.sin(_);g=Math.sin(g*_)/T,a=Math.sin(a*_)/T,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ee(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(H_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(H_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ee(this.x,t.x,e.x),this.y=Ee(this.y,t.y,e.y),this.z=Ee(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ee(this.x,t,e),this.y=Ee(this.y,t,e),this.z=Ee(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ee(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Pp.copy(this).projectOnVector(t),this.sub(Pp)}reflect(t){return this.sub(Pp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ee(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Pp=new G,H_=new dn,ue=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],x=s[0],m=s[3],g=s[6],_=s[1],T=s[4],v=s[7],A=s[2],S=s[5],y=s[8];return r[0]=o*x+a*_+l*A,r[3]=o*m+a*T+l*S,r[6]=o*g+a*v+l*y,r[1]=c*x+u*_+h*A,r[4]=c*m+u*T+h*S,r[7]=c*g+u*v+h*y,r[2]=d*x+f*_+p*A,r[5]=d*m+f*T+p*S,r[8]=d*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=h*x,t[1]=(s*c-u*i)*x,t[2]=(a*i-s*o)*x,t[3]=d*x,t[4]=(u*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Kl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ip.makeScale(t,e)),this}rotate(t){return Kl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ip.makeRotation(-t)),this}translate(t,e){return Kl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ip.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ip=new ue,G_=new ue().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),V_=new ue().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function B1(){let n={enabled:!0,workingColorSpace:nc,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===We&&(s.r=wr(s.r),s.g=wr(s.g),s.b=wr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===We&&(s.r=La(s.r),s.g=La(s.g),s.b=La(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Lr?ic:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[nc]:{primaries:t,whitePoint:i,transfer:ic,toXYZ:G_,fromXYZ:V_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ei},outputColorSpaceConfig:{drawingBufferColorSpace:Ei}},[Ei]:{primaries:t,whitePoint:i,transfer:We,toXYZ:G_,fromXYZ:V_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ei}}}),n}var De=B1();function wr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function La(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var xa,xh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{xa===void 0&&(xa=rc("canvas")),xa.width=t.width,xa.height=t.height;let s=xa.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=xa}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=wr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(wr(e[i]/255)*255):e[i]=wr(e[i]);return{data:e,width:t.width,height:t.height}}else return ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},k1=0,Oa=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=ao(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Lp(s[o].image)):r.push(Lp(s[o]))}else r=Lp(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Lp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?xh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ie("Texture: Unable to serialize Texture."),{})}var z1=0,Dp=new G,Oi=class n extends Rs{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Qs,s=Qs,r=Ai,o=Pr,a=Ls,l=ns,c=n.DEFAULT_ANISOTROPY,u=Lr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:z1++}),this.uuid=ao(),this.name="",this.source=new Oa(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Qt(0,0),this.repeat=new Qt(1,1),this.center=new Qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ue,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Dp).x}get height(){return this.source.getSize(Dp).y}get depth(){return this.source.getSize(Dp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ie(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==xm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case mh:t.x=t.x-Math.floor(t.x);break;case Qs:t.x=t.x<0?0:1;break;case gh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case mh:t.y=t.y-Math.floor(t.y);break;case Qs:t.y=t.y<0?0:1;break;case gh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Oi.DEFAULT_IMAGE=null;Oi.DEFAULT_MAPPING=xm;Oi.DEFAULT_ANISOTROPY=1;var bn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,v=(f+1)/2,A=(g+1)/2,S=(u+d)/4,y=(h+x)/4,w=(p+m)/4;return T>v&&T>A?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=S/i,r=y/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=S/s,r=w/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=w/r),this.set(i,s,r,e),this}let _=Math.sqrt((m-p)*(m-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(h-x)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ee(this.x,t.x,e.x),this.y=Ee(this.y,t.y,e.y),this.z=Ee(this.z,t.z,e.z),this.w=Ee(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ee(this.x,t,e),this.y=Ee(this.y,t,e),this.z=Ee(this.z,t,e),this.w=Ee(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ee(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},yh=class extends Rs{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new bn(0,0,t,e),this.scissorTest=!1,this.viewport=new bn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Oi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ai,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Oa(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Qi=class extends yh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ac=class extends Oi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=Qs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var vh=class extends Oi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=Qs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var _e=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/ya.setFromMatrixColumn(t,0).length(),r=1/ya.setFromMatrixColumn(t,1).length(),o=1/ya.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,x=c*h;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,x=c*h;e[0]=d-x*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*h,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*u,e[4]=x-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-x*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+x,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=x*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(H1,t,G1)}lookAt(t,e,i){let s=this.elements;return Ji.subVectors(t,e),Ji.lengthSq()===0&&(Ji.z=1),Ji.normalize(),Yr.crossVectors(i,Ji),Yr.lengthSq()===0&&(Math.abs(i.z)===1?Ji.x+=1e-4:Ji.z+=1e-4,Ji.normalize(),Yr.crossVectors(i,Ji)),Yr.normalize(),Uu.crossVectors(Ji,Yr),s[0]=Yr.x,s[4]=Uu.x,s[8]=Ji.x,s[1]=Yr.y,s[5]=Uu.y,s[9]=Ji.y,s[2]=Yr.z,s[6]=Uu.z,s[10]=Ji.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],x=i[6],m=i[10],g=i[14],_=i[3],T=i[7],v=i[11],A=i[15],S=s[0],y=s[4],w=s[8],U=s[12],L=s[1],N=s[5],H=s[9],$=s[13],P=s[2],z=s[6],D=s[10],B=s[14],Q=s[3],Y=s[7],Z=s[11],et=s[15];return r[0]=o*S+a*L+l*P+c*Q,r[4]=o*y+a*N+l*z+c*Y,r[8]=o*w+a*H+l*D+c*Z,r[12]=o*U+a*$+l*B+c*et,r[1]=u*S+h*L+d*P+f*Q,r[5]=u*y+h*N+d*z+f*Y,r[9]=u*w+h*H+d*D+f*Z,r[13]=u*U+h*$+d*B+f*et,r[2]=p*S+x*L+m*P+g*Q,r[6]=p*y+x*N+m*z+g*Y,r[10]=p*w+x*H+m*D+g*Z,r[14]=p*U+x*$+m*B+g*et,r[3]=_*S+T*L+v*P+A*Q,r[7]=_*y+T*N+v*z+A*Y,r[11]=_*w+T*H+v*D+A*Z,r[15]=_*U+T*$+v*B+A*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],_=l*f-c*d,T=a*f-c*h,v=a*d-l*h,A=o*f-c*u,S=o*d-l*u,y=o*h-a*u;return e*(x*_-m*T+g*v)-i*(p*_-m*A+g*S)+s*(p*T-x*A+g*y)-r*(p*v-x*S+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],_=e*a-i*o,T=e*l-s*o,v=e*c-r*o,A=i*l-s*a,S=i*c-r*a,y=s*c-r*l,w=u*x-h*p,U=u*m-d*p,L=u*g-f*p,N=h*m-d*x,H=h*g-f*x,$=d*g-f*m,P=_*$-T*H+v*N+A*L-S*U+y*w;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/P;return t[0]=(a*$-l*H+c*N)*z,t[1]=(s*H-i*$-r*N)*z,t[2]=(x*y-m*S+g*A)*z,t[3]=(d*S-h*y-f*A)*z,t[4]=(l*L-o*$-c*U)*z,t[5]=(e*$-s*L+r*U)*z,t[6]=(m*v-p*y-g*T)*z,t[7]=(u*y-d*v+f*T)*z,t[8]=(o*H-a*L+c*w)*z,t[9]=(i*L-e*H-r*w)*z,t[10]=(p*S-x*v+g*_)*z,t[11]=(h*v-u*S-f*_)*z,t[12]=(a*U-o*N-l*w)*z,t[13]=(e*N-i*U+s*w)*z,t[14]=(x*T-p*A-m*_)*z,t[15]=(u*A-h*T+d*_)*z,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,x=o*u,m=o*h,g=a*h,_=l*c,T=l*u,v=l*h,A=i.x,S=i.y,y=i.z;return s[0]=(1-(x+g))*A,s[1]=(f+v)*A,s[2]=(p-T)*A,s[3]=0,s[4]=(f-v)*S,s[5]=(1-(d+g))*S,s[6]=(m+_)*S,s[7]=0,s[8]=(p+T)*y,s[9]=(m-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=ya.set(s[0],s[1],s[2]).length(),a=ya.set(s[4],s[5],s[6]).length(),l=ya.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Es.copy(this);let c=1/o,u=1/a,h=1/l;return Es.elements[0]*=c,Es.elements[1]*=c,Es.elements[2]*=c,Es.elements[4]*=u,Es.elements[5]*=u,Es.elements[6]*=u,Es.elements[8]*=h,Es.elements[9]*=h,Es.elements[10]*=h,e.setFromRotationMatrix(Es),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=hs,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===hs)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===sc)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=hs,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===hs)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===sc)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},ya=new G,Es=new _e,H1=new G(0,0,0),G1=new G(1,1,1),Yr=new G,Uu=new G,Ji=new G,W_=new _e,$_=new dn,to=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ee(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ee(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ee(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ee(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ee(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ee(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return W_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(W_,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return $_.setFromEuler(this),this.setFromQuaternion($_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};to.DEFAULT_ORDER="XYZ";var Fa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},V1=0,q_=new G,va=new dn,yr=new _e,Ou=new G,$l=new G,W1=new G,$1=new dn,X_=new G(1,0,0),Y_=new G(0,1,0),j_=new G(0,0,1),Z_={type:"added"},q1={type:"removed"},ba={type:"childadded",child:null},Np={type:"childremoved",child:null},Fi=class n extends Rs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:V1++}),this.uuid=ao(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new G,e=new to,i=new dn,s=new G(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new _e},normalMatrix:{value:new ue}}),this.matrix=new _e,this.matrixWorld=new _e,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Fa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return va.setFromAxisAngle(t,e),this.quaternion.multiply(va),this}rotateOnWorldAxis(t,e){return va.setFromAxisAngle(t,e),this.quaternion.premultiply(va),this}rotateX(t){return this.rotateOnAxis(X_,t)}rotateY(t){return this.rotateOnAxis(Y_,t)}rotateZ(t){return this.rotateOnAxis(j_,t)}translateOnAxis(t,e){return q_.copy(t).applyQuaternion(this.quaternion),this.position.add(q_.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(X_,t)}translateY(t){return this.translateOnAxis(Y_,t)}translateZ(t){return this.translateOnAxis(j_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(yr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ou.copy(t):Ou.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),$l.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?yr.lookAt($l,Ou,this.up):yr.lookAt(Ou,$l,this.up),this.quaternion.setFromRotationMatrix(yr),s&&(yr.extractRotation(s.matrixWorld),va.setFromRotationMatrix(yr),this.quaternion.premultiply(va.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(le("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Z_),ba.child=t,this.dispatchEvent(ba),ba.child=null):le("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(q1),Np.child=t,this.dispatchEvent(Np),Np.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),yr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),yr.multiply(t.parent.matrixWorld)),t.applyMatrix4(yr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Z_),ba.child=t,this.dispatchEvent(ba),ba.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($l,t,W1),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose($l,$1,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Fi.DEFAULT_UP=new G(0,1,0);Fi.DEFAULT_MATRIX_AUTO_UPDATE=!0;Fi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Rn=class extends Fi{constructor(){super(),this.isGroup=!0,this.type="Group"}},X1={type:"move"},Ba=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(X1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Rn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},ty={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},jr={h:0,s:0,l:0},Fu={h:0,s:0,l:0};function Up(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,De.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=De.workingColorSpace){return this.r=t,this.g=e,this.b=i,De.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=De.workingColorSpace){if(t=Dm(t,1),e=Ee(e,0,1),i=Ee(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Up(o,r,t+1/3),this.g=Up(o,r,t),this.b=Up(o,r,t-1/3)}return De.colorSpaceToWorking(this,s),this}setStyle(t,e=Ei){function i(r){r!==void 0&&parseFloat(r)<1&&ie("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ie("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ie("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ei){let i=ty[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ie("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=wr(t.r),this.g=wr(t.g),this.b=wr(t.b),this}copyLinearToSRGB(t){return this.r=La(t.r),this.g=La(t.g),this.b=La(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ei){return De.workingToColorSpace(di.copy(this),t),Math.round(Ee(di.r*255,0,255))*65536+Math.round(Ee(di.g*255,0,255))*256+Math.round(Ee(di.b*255,0,255))}getHexString(t=Ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=De.workingColorSpace){De.workingToColorSpace(di.copy(this),e);let i=di.r,s=di.g,r=di.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=De.workingColorSpace){return De.workingToColorSpace(di.copy(this),e),t.r=di.r,t.g=di.g,t.b=di.b,t}getStyle(t=Ei){De.workingToColorSpace(di.copy(this),t);let e=di.r,i=di.g,s=di.b;return t!==Ei?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(jr),this.setHSL(jr.h+t,jr.s+e,jr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(jr),t.getHSL(Fu);let i=tc(jr.h,Fu.h,e),s=tc(jr.s,Fu.s,e),r=tc(jr.l,Fu.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},di=new ee;ee.NAMES=ty;var lc=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},cc=class extends Fi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new to,this.environmentIntensity=1,this.environmentRotation=new to,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ts=new G,vr=new G,Op=new G,br=new G,Ma=new G,Sa=new G,J_=new G,Fp=new G,Bp=new G,kp=new G,zp=new bn,Hp=new bn,Gp=new bn,Qr=class n{constructor(t=new G,e=new G,i=new G){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ts.subVectors(t,e),s.cross(Ts);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ts.subVectors(s,e),vr.subVectors(i,e),Op.subVectors(t,e);let o=Ts.dot(Ts),a=Ts.dot(vr),l=Ts.dot(Op),c=vr.dot(vr),u=vr.dot(Op),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,br)===null?!1:br.x>=0&&br.y>=0&&br.x+br.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,br)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,br.x),l.addScaledVector(o,br.y),l.addScaledVector(a,br.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return zp.setScalar(0),Hp.setScalar(0),Gp.setScalar(0),zp.fromBufferAttribute(t,e),Hp.fromBufferAttribute(t,i),Gp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zp,r.x),o.addScaledVector(Hp,r.y),o.addScaledVector(Gp,r.z),o}static isFrontFacing(t,e,i,s){return Ts.subVectors(i,e),vr.subVectors(t,e),Ts.cross(vr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ts.subVectors(this.c,this.b),vr.subVectors(this.a,this.b),Ts.cross(vr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Ma.subVectors(s,i),Sa.subVectors(r,i),Fp.subVectors(t,i);let l=Ma.dot(Fp),c=Sa.dot(Fp);if(l<=0&&c<=0)return e.copy(i);Bp.subVectors(t,s);let u=Ma.dot(Bp),h=Sa.dot(Bp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Ma,o);kp.subVectors(t,r);let f=Ma.dot(kp),p=Sa.dot(kp);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Sa,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return J_.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(J_,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(i).addScaledVector(Ma,o).addScaledVector(Sa,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Bi=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(As.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(As.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=As.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,As):As.fromBufferAttribute(r,o),As.applyMatrix4(t.matrixWorld),this.expandByPoint(As);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Bu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Bu.copy(i.boundingBox)),Bu.applyMatrix4(t.matrixWorld),this.union(Bu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,As),As.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ql),ku.subVectors(this.max,ql),wa.subVectors(t.a,ql),Ea.subVectors(t.b,ql),Ta.subVectors(t.c,ql),Zr.subVectors(Ea,wa),Jr.subVectors(Ta,Ea),Co.subVectors(wa,Ta);let e=[0,-Zr.z,Zr.y,0,-Jr.z,Jr.y,0,-Co.z,Co.y,Zr.z,0,-Zr.x,Jr.z,0,-Jr.x,Co.z,0,-Co.x,-Zr.y,Zr.x,0,-Jr.y,Jr.x,0,-Co.y,Co.x,0];return!Vp(e,wa,Ea,Ta,ku)||(e=[1,0,0,0,1,0,0,0,1],!Vp(e,wa,Ea,Ta,ku))?!1:(zu.crossVectors(Zr,Jr),e=[zu.x,zu.y,zu.z],Vp(e,wa,Ea,Ta,ku))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,As).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(As).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Mr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Mr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Mr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Mr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Mr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Mr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Mr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Mr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Mr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Mr=[new G,new G,new G,new G,new G,new G,new G,new G],As=new G,Bu=new Bi,wa=new G,Ea=new G,Ta=new G,Zr=new G,Jr=new G,Co=new G,ql=new G,ku=new G,zu=new G,Po=new G;function Vp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Po.fromArray(n,r);let a=s.x*Math.abs(Po.x)+s.y*Math.abs(Po.y)+s.z*Math.abs(Po.z),l=t.dot(Po),c=e.dot(Po),u=i.dot(Po);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Fn=new G,Hu=new Qt,Y1=0,ze=class extends Rs{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Y1++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Im,this.updateRanges=[],this.gpuType=ds,this.version=0,this._normalizationScale=t!==void 0?Ad(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Hu.fromBufferAttribute(this,e),Hu.applyMatrix3(t),this.setXY(e,Hu.x,Hu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix3(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Um(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Om(t,this.array)}};var uc=class extends ze{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var hc=class extends ze{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Te=class extends ze{constructor(t,e,i){super(new Float32Array(t),e,i)}},j1=new Bi,Xl=new G,Wp=new G,tr=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):j1.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Xl.subVectors(t,this.center);let e=Xl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Xl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Wp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Xl.copy(t.center).add(Wp)),this.expandByPoint(Xl.copy(t.center).sub(Wp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Z1=0,us=new _e,$p=new Fi,Aa=new G,Ki=new Bi,Yl=new Bi,Qn=new G,Ae=class n extends Rs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Z1++}),this.uuid=ao(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(b1(t)?hc:uc)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ue().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return us.makeRotationFromQuaternion(t),this.applyMatrix4(us),this}rotateX(t){return us.makeRotationX(t),this.applyMatrix4(us),this}rotateY(t){return us.makeRotationY(t),this.applyMatrix4(us),this}rotateZ(t){return us.makeRotationZ(t),this.applyMatrix4(us),this}translate(t,e,i){return us.makeTranslation(t,e,i),this.applyMatrix4(us),this}scale(t,e,i){return us.makeScale(t,e,i),this.applyMatrix4(us),this}lookAt(t){return $p.lookAt(t),$p.updateMatrix(),this.applyMatrix4($p.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Aa).negate(),this.translate(Aa.x,Aa.y,Aa.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Te(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Bi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){le("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ki.setFromBufferAttribute(r),this.morphTargetsRelative?(Qn.addVectors(this.boundingBox.min,Ki.min),this.boundingBox.expandByPoint(Qn),Qn.addVectors(this.boundingBox.max,Ki.max),this.boundingBox.expandByPoint(Qn)):(this.boundingBox.expandByPoint(Ki.min),this.boundingBox.expandByPoint(Ki.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&le('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){le("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let i=this.boundingSphere.center;if(Ki.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Yl.setFromBufferAttribute(a),this.morphTargetsRelative?(Qn.addVectors(Ki.min,Yl.min),Ki.expandByPoint(Qn),Qn.addVectors(Ki.max,Yl.max),Ki.expandByPoint(Qn)):(Ki.expandByPoint(Yl.min),Ki.expandByPoint(Yl.max))}Ki.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Qn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Qn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Qn.fromBufferAttribute(a,c),l&&(Aa.fromBufferAttribute(t,c),Qn.add(Aa)),s=Math.max(s,i.distanceToSquared(Qn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&le('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){le("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ze(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,l[U]=new G;let u=new G,h=new G,d=new G,f=new Qt,p=new Qt,x=new Qt,m=new G,g=new G;function _(U,L,N){c[U]=c[L]=c[N]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,N),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,L),x.fromBufferAttribute(r,N),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let H=1/(p.x*x.y-x.x*p.y);isFinite(H)&&(m.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(H),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(H),a[U].add(m),a[L].add(m),a[N].add(m),l[U].add(g),l[L].add(g),l[N].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let U=0,L=T.length;U<L;++U){let N=T[U],H=N.start,$=N.count;for(let P=H,z=H+$;P<z;P+=3)_(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let v=new G,A=new G,S=new G,y=new G;function w(U){S.fromBufferAttribute(s,U),y.copy(S);let L=a[U];v.copy(L),v.sub(S.multiplyScalar(S.dot(L))).normalize(),A.crossVectors(y,L);let H=A.dot(l[U])<0?-1:1;o.setXYZW(U,v.x,v.y,v.z,H)}for(let U=0,L=i.count;U<L;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ze(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,h=new G;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Qn.fromBufferAttribute(t,e),Qn.normalize(),t.setXYZ(e,Qn.x,Qn.y,Qn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new ze(d,u,h)}if(this.index===null)return ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ka=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Im,this.updateRanges=[],this.version=0,this.uuid=ao()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=K_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=K_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function K_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=ao()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var wi=new G,za=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Ad(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)wi.fromBufferAttribute(this,e),wi.applyMatrix4(t),this.setXYZ(e,wi.x,wi.y,wi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)wi.fromBufferAttribute(this,e),wi.applyNormalMatrix(t),this.setXYZ(e,wi.x,wi.y,wi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)wi.fromBufferAttribute(this,e),wi.transformDirection(t),this.setXYZ(e,wi.x,wi.y,wi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){oc("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new ze(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){oc("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Um(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Om(t,this.data.array)}},qp=new G,J1=new G,K1=new ue,ii=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=qp.subVectors(i,e).cross(J1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(qp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||K1.getNormalMatrix(t),s=this.coplanarPoint(qp).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Q1=0,Tr=class extends Rs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Q1++}),this.uuid=ao(),this.name="",this.type="Material",this.blending=qa,this.side=ir,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=lm,this.blendDst=cm,this.blendEquation=Bo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=Da,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Wx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ah,this.stencilZFail=ah,this.stencilZPass=ah,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ie(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ii().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Sr=new G,Xp=new G,Gu=new G,Vu=new G,Ar=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Sr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Sr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Sr.copy(this.origin).addScaledVector(this.direction,e),Sr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Xp.copy(t).add(e).multiplyScalar(.5),Gu.copy(e).sub(t).normalize(),Vu.copy(this.origin).sub(Xp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Gu),a=Vu.dot(this.direction),l=-Vu.dot(Gu),c=Vu.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Xp).addScaledVector(Gu,d),f}intersectSphere(t,e){if(t.radius<0)return null;Sr.subVectors(t.center,this.origin);let i=Sr.dot(this.direction),s=Sr.dot(Sr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Sr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=i.x-o.x,_=i.y-o.y,T=i.z-o.z,v=Math.abs(l),A=Math.abs(c),S=Math.abs(u),y,w,U,L,N,H,$,P,z,D,B,Q;if(v>=A&&v>=S?(U=l,H=h,z=p,Q=g,l>=0?(y=c,w=u,L=d,N=f,$=x,P=m,D=_,B=T):(y=u,w=c,L=f,N=d,$=m,P=x,D=T,B=_)):A>=S?(U=c,H=d,z=x,Q=_,c>=0?(y=u,w=l,L=f,N=h,$=m,P=p,D=T,B=g):(y=l,w=u,L=h,N=f,$=p,P=m,D=g,B=T)):(U=u,H=f,z=m,Q=T,u>=0?(y=l,w=c,L=h,N=d,$=p,P=x,D=g,B=_):(y=c,w=l,L=d,N=h,$=x,P=p,D=_,B=g)),U===0)return null;let Y=y/U,Z=w/U,et=1/U,dt=L-Y*H,ft=N-Z*H,st=$-Y*z,yt=P-Z*z,_t=D-Y*Q,Tt=B-Z*Q,At=_t*yt-Tt*st,Jt=dt*Tt-ft*_t,me=st*ft-yt*dt;if(s){if(At<0||Jt<0||me<0)return null}else if((At<0||Jt<0||me<0)&&(At>0||Jt>0||me>0))return null;let jt=At+Jt+me;if(jt===0)return null;let we=et*(At*H+Jt*z+me*Q);return(jt>0?we<0:we>0)?null:this.at(we/jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},si=class extends Tr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new to,this.combine=um,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Q_=new _e,Io=new Ar,Wu=new tr,tx=new G,$u=new G,qu=new G,Xu=new G,Yp=new G,Yu=new G,ex=new G,ju=new G,je=class extends Fi{constructor(t=new Ae,e=new si){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Yu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Yp.fromBufferAttribute(h,t),o?Yu.addScaledVector(Yp,u):Yu.addScaledVector(Yp.sub(e),u))}e.add(Yu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Wu.copy(i.boundingSphere),Wu.applyMatrix4(r),Io.copy(t.ray).recast(t.near),!(Wu.containsPoint(Io.origin)===!1&&(Io.intersectSphere(Wu,tx)===null||Io.origin.distanceToSquared(tx)>(t.far-t.near)**2))&&(Q_.copy(r).invert(),Io.copy(t.ray).applyMatrix4(Q_),!(i.boundingBox!==null&&Io.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Io)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),T=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=_,A=T;v<A;v+=3){let S=a.getX(v),y=a.getX(v+1),w=a.getX(v+2);s=Zu(this,g,t,i,c,u,h,S,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=a.getX(m),T=a.getX(m+1),v=a.getX(m+2);s=Zu(this,o,t,i,c,u,h,_,T,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),T=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=_,A=T;v<A;v+=3){let S=v,y=v+1,w=v+2;s=Zu(this,g,t,i,c,u,h,S,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=m,T=m+1,v=m+2;s=Zu(this,o,t,i,c,u,h,_,T,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function tE(n,t,e,i,s,r,o,a){let l;if(t.side===ri?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===ir,a),l===null)return null;ju.copy(a),ju.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ju);return c<e.near||c>e.far?null:{distance:c,point:ju.clone(),object:n}}function Zu(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,$u),n.getVertexPosition(l,qu),n.getVertexPosition(c,Xu);let u=tE(n,t,e,i,$u,qu,Xu,ex);if(u){let h=new G;Qr.getBarycoord(ex,$u,qu,Xu,h),s&&(u.uv=Qr.getInterpolatedAttribute(s,a,l,c,h,new Qt)),r&&(u.uv1=Qr.getInterpolatedAttribute(r,a,l,c,h,new Qt)),o&&(u.normal=Qr.getInterpolatedAttribute(o,a,l,c,h,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new G,materialIndex:0};Qr.getNormal($u,qu,Xu,d.normal),u.face=d,u.barycoord=h}return u}var dc=class extends Oi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ti,u=ti,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ha=class extends ze{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ra=new _e,nx=new _e,Ju=[],ix=new Bi,eE=new _e,jl=new je,Zl=new tr,fc=class extends je{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ha(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,eE)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Bi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ra),ix.copy(t.boundingBox).applyMatrix4(Ra),this.boundingBox.union(ix)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new tr),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ra),Zl.copy(t.boundingSphere).applyMatrix4(Ra),this.boundingSphere.union(Zl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(jl.geometry=this.geometry,jl.material=this.material,jl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Zl.copy(this.boundingSphere),Zl.applyMatrix4(i),t.ray.intersectsSphere(Zl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ra),nx.multiplyMatrices(i,Ra),jl.matrixWorld=nx,jl.raycast(t,Ju);for(let o=0,a=Ju.length;o<a;o++){let l=Ju[o];l.instanceId=r,l.object=this,e.push(l)}Ju.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ha(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new dc(new Float32Array(s*this.count),s,this.count,qh,ds));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Lo=new tr,nE=new Qt(.5,.5),Ku=new G,Do=class{constructor(t=new ii,e=new ii,i=new ii,s=new ii,r=new ii,o=new ii){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=hs,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],_=r[12],T=r[13],v=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-p,A-_).normalize(),s[1].setComponents(c+o,f+u,g+p,A+_).normalize(),s[2].setComponents(c+a,f+h,g+x,A+T).normalize(),s[3].setComponents(c-a,f-h,g-x,A-T).normalize(),i)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,f-d,g-m,A-v).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-v).normalize(),e===hs)s[5].setComponents(c+l,f+d,g+m,A+v).normalize();else if(e===sc)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Lo.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Lo.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Lo)}intersectsSprite(t){Lo.center.set(0,0,0);let e=nE.distanceTo(t.center);return Lo.radius=.7071067811865476+e,Lo.applyMatrix4(t.matrixWorld),this.intersectsSphere(Lo)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ku.x=s.normal.x>0?t.max.x:t.min.x,Ku.y=s.normal.y>0?t.max.y:t.min.y,Ku.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ku)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},sx=new _e,bh=class n{constructor(){this.coordinateSystem=hs,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];sx.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Do),i[s].setFromProjectionMatrix(sx,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Do),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var ts=class extends Tr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Mh=new G,Sh=new G,rx=new _e,Jl=new Ar,Qu=new tr,jp=new G,ox=new G,er=class extends Fi{constructor(t=new Ae,e=new ts){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Mh.fromBufferAttribute(e,s-1),Sh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Mh.distanceTo(Sh);t.setAttribute("lineDistance",new Te(i,1))}else ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Qu.copy(i.boundingSphere),Qu.applyMatrix4(s),Qu.radius+=r,t.ray.intersectsSphere(Qu)===!1)return;rx.copy(s).invert(),Jl.copy(t.ray).applyMatrix4(rx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=u.getX(x),_=u.getX(x+1),T=th(this,t,Jl,l,g,_,x);T&&e.push(T)}if(this.isLineLoop){let x=u.getX(p-1),m=u.getX(f),g=th(this,t,Jl,l,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=th(this,t,Jl,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=th(this,t,Jl,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function th(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Mh.fromBufferAttribute(a,s),Sh.fromBufferAttribute(a,r),e.distanceSqToSegment(Mh,Sh,jp,ox)>i)return;jp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(jp);if(!(c<t.near||c>t.far))return{distance:c,point:ox.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var ax=new G,lx=new G,No=class extends er{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)ax.fromBufferAttribute(e,s),lx.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+ax.distanceTo(lx);t.setAttribute("lineDistance",new Te(i,1))}else ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var nr=class extends Tr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},cx=new _e,tm=new Ar,eh=new tr,nh=new G,Rr=class extends Fi{constructor(t=new Ae,e=new nr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),eh.copy(i.boundingSphere),eh.applyMatrix4(s),eh.radius+=r,t.ray.intersectsSphere(eh)===!1)return;cx.copy(s).invert(),tm.copy(t.ray).applyMatrix4(cx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let m=c.getX(p);nh.fromBufferAttribute(h,m),ux(nh,m,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,x=f;p<x;p++)nh.fromBufferAttribute(h,p),ux(nh,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ux(n,t,e,i,s,r,o){let a=tm.distanceSqToPoint(n);if(a<e){let l=new G;tm.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var pc=class extends Oi{constructor(t=[],e=ko,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Cr=class extends Oi{constructor(t,e,i=Ps,s,r,o,a=ti,l=ti,c,u=Er,h=1){if(u!==Er&&u!==Ir)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Oa(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},mc=class extends Cr{constructor(t,e=Ps,i=ko,s,r,o=ti,a=ti,l,c=Er){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},gc=class extends Oi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ki=class n extends Ae{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(u,3)),this.setAttribute("uv",new Te(h,2));function p(x,m,g,_,T,v,A,S,y,w,U){let L=v/y,N=A/w,H=v/2,$=A/2,P=S/2,z=y+1,D=w+1,B=0,Q=0,Y=new G;for(let Z=0;Z<D;Z++){let et=Z*N-$;for(let dt=0;dt<z;dt++){let ft=dt*L-H;Y[x]=ft*_,Y[m]=et*T,Y[g]=P,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[m]=0,Y[g]=S>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(dt/y),h.push(1-Z/w),B+=1}}for(let Z=0;Z<w;Z++)for(let et=0;et<y;et++){let dt=d+et+z*Z,ft=d+et+z*(Z+1),st=d+(et+1)+z*(Z+1),yt=d+(et+1)+z*Z;l.push(dt,ft,yt),l.push(ft,st,yt),Q+=6}a.addGroup(f,Q,U),f+=Q,d+=B}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Uo=class n extends Ae{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,x=s+1,m=new G,g=new G;for(let _=0;_<=p;_++){let T=0,v=0,A=0,S=0;if(_<=i){let U=_/i,L=U*Math.PI/2;v=-u-t*Math.cos(L),A=t*Math.sin(L),S=-t*Math.cos(L),T=U*h}else if(_<=i+r){let U=(_-i)/r;v=-u+U*e,A=t,S=0,T=h+U*d}else{let U=(_-i-r)/i,L=U*Math.PI/2;v=u+t*Math.sin(L),A=t*Math.cos(L),S=t*Math.sin(L),T=h+d+U*h}let y=Math.max(0,Math.min(1,T/f)),w=0;_===0?w=.5/s:_===p&&(w=-.5/s);for(let U=0;U<=s;U++){let L=U/s,N=L*Math.PI*2,H=Math.sin(N),$=Math.cos(N);g.x=-A*$,g.y=v,g.z=A*H,a.push(g.x,g.y,g.z),m.set(-A*$,S,A*H),m.normalize(),l.push(m.x,m.y,m.z),c.push(L+w,y)}if(_>0){let U=(_-1)*x;for(let L=0;L<s;L++){let N=U+L,H=U+L+1,$=_*x+L,P=_*x+L+1;o.push(N,H,$),o.push(H,P,$)}}}this.setIndex(o),this.setAttribute("position",new Te(a,3)),this.setAttribute("normal",new Te(l,3)),this.setAttribute("uv",new Te(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},_c=class n extends Ae{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new G,u=new Qt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new Te(o,3)),this.setAttribute("normal",new Te(a,3)),this.setAttribute("uv",new Te(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ri=class n extends Ae{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],m=i/2,g=0;_(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Te(h,3)),this.setAttribute("normal",new Te(d,3)),this.setAttribute("uv",new Te(f,2));function _(){let v=new G,A=new G,S=0,y=(e-t)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,N=L*(e-t)+t;for(let H=0;H<=s;H++){let $=H/s,P=$*l+a,z=Math.sin(P),D=Math.cos(P);A.x=N*z,A.y=-L*i+m,A.z=N*D,h.push(A.x,A.y,A.z),v.set(z,y,D).normalize(),d.push(v.x,v.y,v.z),f.push($,1-L),U.push(p++)}x.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=x[U][w],N=x[U+1][w],H=x[U+1][w+1],$=x[U][w+1];(t>0||U!==0)&&(u.push(L,N,$),S+=3),(e>0||U!==r-1)&&(u.push(N,H,$),S+=3)}c.addGroup(g,S,0),g+=S}function T(v){let A=p,S=new Qt,y=new G,w=0,U=v===!0?t:e,L=v===!0?1:-1;for(let H=1;H<=s;H++)h.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let N=p;for(let H=0;H<=s;H++){let P=H/s*l+a,z=Math.cos(P),D=Math.sin(P);y.x=U*D,y.y=m*L,y.z=U*z,h.push(y.x,y.y,y.z),d.push(0,L,0),S.x=z*.5+.5,S.y=D*.5*L+.5,f.push(S.x,S.y),p++}for(let H=0;H<s;H++){let $=A+H,P=N+H;v===!0?u.push(P,P+1,$):u.push(P+1,P,$),w+=3}c.addGroup(g,w,v===!0?1:2),g+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Oo=class n extends Ri{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},wh=class n extends Ae{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Te(r,3)),this.setAttribute("normal",new Te(r.slice(),3)),this.setAttribute("uv",new Te(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let T=new G,v=new G,A=new G;for(let S=0;S<e.length;S+=3)f(e[S+0],T),f(e[S+1],v),f(e[S+2],A),l(T,v,A,_)}function l(_,T,v,A){let S=A+1,y=[];for(let w=0;w<=S;w++){y[w]=[];let U=_.clone().lerp(v,w/S),L=T.clone().lerp(v,w/S),N=S-w;for(let H=0;H<=N;H++)H===0&&w===S?y[w][H]=U:y[w][H]=U.clone().lerp(L,H/N)}for(let w=0;w<S;w++)for(let U=0;U<2*(S-w)-1;U++){let L=Math.floor(U/2);U%2===0?(d(y[w][L+1]),d(y[w+1][L]),d(y[w][L])):(d(y[w][L+1]),d(y[w+1][L+1]),d(y[w+1][L]))}}function c(_){let T=new G;for(let v=0;v<r.length;v+=3)T.x=r[v+0],T.y=r[v+1],T.z=r[v+2],T.normalize().multiplyScalar(_),r[v+0]=T.x,r[v+1]=T.y,r[v+2]=T.z}function u(){let _=new G;for(let T=0;T<r.length;T+=3){_.x=r[T+0],_.y=r[T+1],_.z=r[T+2];let v=m(_)/2/Math.PI+.5,A=g(_)/Math.PI+.5;o.push(v,1-A)}p(),h()}function h(){for(let _=0;_<o.length;_+=6){let T=o[_+0],v=o[_+2],A=o[_+4],S=Math.max(T,v,A),y=Math.min(T,v,A);S>.9&&y<.1&&(T<.2&&(o[_+0]+=1),v<.2&&(o[_+2]+=1),A<.2&&(o[_+4]+=1))}}function d(_){r.push(_.x,_.y,_.z)}function f(_,T){let v=_*3;T.x=t[v+0],T.y=t[v+1],T.z=t[v+2]}function p(){let _=new G,T=new G,v=new G,A=new G,S=new Qt,y=new Qt,w=new Qt;for(let U=0,L=0;U<r.length;U+=9,L+=6){_.set(r[U+0],r[U+1],r[U+2]),T.set(r[U+3],r[U+4],r[U+5]),v.set(r[U+6],r[U+7],r[U+8]),S.set(o[L+0],o[L+1]),y.set(o[L+2],o[L+3]),w.set(o[L+4],o[L+5]),A.copy(_).add(T).add(v).divideScalar(3);let N=m(A);x(S,L+0,_,N),x(y,L+2,T,N),x(w,L+4,v,N)}}function x(_,T,v,A){A<0&&_.x===1&&(o[T]=_.x-1),v.x===0&&v.z===0&&(o[T]=A/2/Math.PI+.5)}function m(_){return Math.atan2(_.z,-_.x)}function g(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var xc=class n extends Ae{constructor(t=[new Qt(0,-.5),new Qt(.5,0),new Qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Ee(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new G,d=new Qt,f=new G,p=new G,x=new G,m=0,g=0;for(let _=0;_<=t.length-1;_++)switch(_){case 0:m=t[_+1].x-t[_].x,g=t[_+1].y-t[_].y,f.x=g*1,f.y=-m,f.z=g*0,x.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:x.normalize(),l.push(x.x,x.y,x.z);break;default:m=t[_+1].x-t[_].x,g=t[_+1].y-t[_].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=x.x,f.y+=x.y,f.z+=x.z,f.normalize(),l.push(f.x,f.y,f.z),x.copy(p)}for(let _=0;_<=e;_++){let T=i+_*u*s,v=Math.sin(T),A=Math.cos(T);for(let S=0;S<=t.length-1;S++){h.x=t[S].x*v,h.y=t[S].y,h.z=t[S].x*A,o.push(h.x,h.y,h.z),d.x=_/e,d.y=S/(t.length-1),a.push(d.x,d.y);let y=l[3*S+0]*v,w=l[3*S+1],U=l[3*S+0]*A;c.push(y,w,U)}}for(let _=0;_<e;_++)for(let T=0;T<t.length-1;T++){let v=T+_*t.length,A=v,S=v+t.length,y=v+t.length+1,w=v+1;r.push(A,S,w),r.push(y,w,S)}this.setIndex(r),this.setAttribute("position",new Te(o,3)),this.setAttribute("uv",new Te(a,2)),this.setAttribute("normal",new Te(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},yc=class n extends wh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},vc=class n extends Ae{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<u;g++){let _=g*d-o;for(let T=0;T<c;T++){let v=T*h-r;p.push(v,-_,0),x.push(0,0,1),m.push(T/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let T=_+c*g,v=_+c*(g+1),A=_+1+c*(g+1),S=_+1+c*g;f.push(T,v,S),f.push(v,A,S)}this.setIndex(f),this.setAttribute("position",new Te(p,3)),this.setAttribute("normal",new Te(x,3)),this.setAttribute("uv",new Te(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Cs=class n extends Ae{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new G,d=new G,f=[],p=[],x=[],m=[];for(let g=0;g<=i;g++){let _=[],T=g/i,v=o+T*a,A=t*Math.cos(v),S=Math.sqrt(t*t-A*A),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let w=0;w<=e;w++){let U=w/e,L=s+U*r;h.x=-S*Math.cos(L),h.y=A,h.z=S*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),m.push(U+y,1-T),_.push(c++)}u.push(_)}for(let g=0;g<i;g++)for(let _=0;_<e;_++){let T=u[g][_+1],v=u[g][_],A=u[g+1][_],S=u[g+1][_+1];(g!==0||o>0)&&f.push(T,v,S),(g!==i-1||l<Math.PI)&&f.push(v,A,S)}this.setIndex(f),this.setAttribute("position",new Te(p,3)),this.setAttribute("normal",new Te(x,3)),this.setAttribute("uv",new Te(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ga=class n extends Ae{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new G,f=new G,p=new G;for(let x=0;x<=i;x++){let m=o+x/i*a;for(let g=0;g<=s;g++){let _=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(_),f.y=(t+e*Math.cos(m))*Math.sin(_),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(_),d.y=t*Math.sin(_),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(g/s),h.push(x/i)}}for(let x=1;x<=i;x++)for(let m=1;m<=s;m++){let g=(s+1)*x+m-1,_=(s+1)*(x-1)+m-1,T=(s+1)*(x-1)+m,v=(s+1)*x+m;l.push(g,_,v),l.push(_,T,v)}this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(u,3)),this.setAttribute("uv",new Te(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Ho(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(hx(s))s.isRenderTargetTexture?(ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(hx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function mi(n){let t={};for(let e=0;e<n.length;e++){let i=Ho(n[e]);for(let s in i)t[s]=i[s]}return t}function hx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function iE(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Fm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:De.workingColorSpace}var ey={clone:Ho,merge:mi},sE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,rE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,fi=class extends Tr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=sE,this.fragmentShader=rE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Ho(t.uniforms),this.uniformsGroups=iE(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new bn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ue().fromArray(s.value);break;case"m4":this.uniforms[i].value=new _e().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Eh=class extends fi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Th=class extends Tr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Gx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Ah=class extends Tr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ca(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function ih(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var eo=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Rh=class extends eo{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Jp,endingEnd:Jp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Kp:r=t,a=2*e-i;break;case Qp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Kp:o=t,l=2*i-e;break;case Qp:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,_=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,T=(-1-f)*m+(1.5+f)*x+.5*p,v=f*m-f*x;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+_*o[c+A]+T*o[l+A]+v*o[h+A];return r}},Ch=class extends eo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Ph=class extends eo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ih=class extends eo{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,_=h[g],T=h[g+1],v=t*d+p*2,A=u[v],S=u[v+1],y=aE(i,e,_,A,s);r[p]=ny(y,x,T,S,m)}return r}};function ny(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function oE(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function aE(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=ny(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=oE(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var es=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ca(e,this.TimeBufferType),this.values=Ca(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ca(t.times,Array),values:Ca(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),ih(t.settings)&&(i.settings={inTangents:Ca(t.settings.inTangents,Array),outTangents:Ca(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ph(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ch(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Rh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ih(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ec:e=this.InterpolantFactoryMethodDiscrete;break;case _h:e=this.InterpolantFactoryMethodLinear;break;case oh:e=this.InterpolantFactoryMethodSmooth;break;case Zp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ie("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ec;case this.InterpolantFactoryMethodLinear:return _h;case this.InterpolantFactoryMethodSmooth:return oh;case this.InterpolantFactoryMethodBezier:return Zp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;ih(this.settings)&&(dx(this.settings.inTangents,t),dx(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;ih(this.settings)&&(fx(this.settings.inTangents,t),fx(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(le("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(le("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){le("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){le("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&M1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){le("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===oh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let x=e[h+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,ih(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function dx(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function fx(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}es.prototype.ValueTypeName="";es.prototype.TimeBufferType=Float32Array;es.prototype.ValueBufferType=Float32Array;es.prototype.DefaultInterpolation=_h;var no=class extends es{constructor(t,e,i){super(t,e,i)}};no.prototype.ValueTypeName="bool";no.prototype.ValueBufferType=Array;no.prototype.DefaultInterpolation=ec;no.prototype.InterpolantFactoryMethodLinear=void 0;no.prototype.InterpolantFactoryMethodSmooth=void 0;var Lh=class extends es{constructor(t,e,i,s){super(t,e,i,s)}};Lh.prototype.ValueTypeName="color";var Dh=class extends es{constructor(t,e,i,s){super(t,e,i,s)}};Dh.prototype.ValueTypeName="number";var Nh=class extends eo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)dn.slerpFlat(r,0,o,c-a,o,c,l);return r}},bc=class extends es{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Nh(this.times,this.values,this.getValueSize(),t)}};bc.prototype.ValueTypeName="quaternion";bc.prototype.InterpolantFactoryMethodSmooth=void 0;var io=class extends es{constructor(t,e,i){super(t,e,i)}};io.prototype.ValueTypeName="string";io.prototype.ValueBufferType=Array;io.prototype.DefaultInterpolation=ec;io.prototype.InterpolantFactoryMethodLinear=void 0;io.prototype.InterpolantFactoryMethodSmooth=void 0;var Uh=class extends es{constructor(t,e,i,s){super(t,e,i,s)}};Uh.prototype.ValueTypeName="vector";var Oh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},iy=new Oh,Fh=class{constructor(t){this.manager=t!==void 0?t:iy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Fh.DEFAULT_MATERIAL_NAME="__DEFAULT";var sh=new G,rh=new dn,Ks=new G,Mc=class extends Fi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new _e,this.projectionMatrix=new _e,this.projectionMatrixInverse=new _e,this.coordinateSystem=hs,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(sh,rh,Ks),Ks.x===1&&Ks.y===1&&Ks.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(sh,rh,Ks.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(sh,rh,Ks),Ks.x===1&&Ks.y===1&&Ks.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(sh,rh,Ks.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Kr=new G,px=new Qt,mx=new Qt,Ti=class extends Mc{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ua*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Ql*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ua*2*Math.atan(Math.tan(Ql*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Kr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Kr.x,Kr.y).multiplyScalar(-t/Kr.z),Kr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Kr.x,Kr.y).multiplyScalar(-t/Kr.z)}getViewSize(t,e){return this.getViewBounds(t,px,mx),e.subVectors(mx,px)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Ql*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Bh=class extends Mc{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Pa=-90,Ia=1,Va=class extends Fi{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ti(Pa,Ia,t,e);s.layers=this.layers,this.add(s);let r=new Ti(Pa,Ia,t,e);r.layers=this.layers,this.add(r);let o=new Ti(Pa,Ia,t,e);o.layers=this.layers,this.add(o);let a=new Ti(Pa,Ia,t,e);a.layers=this.layers,this.add(a);let l=new Ti(Pa,Ia,t,e);l.layers=this.layers,this.add(l);let c=new Ti(Pa,Ia,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===hs)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===sc)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},kh=class extends Ti{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Bm="\\[\\]\\.:\\/",lE=new RegExp("["+Bm+"]","g"),km="[^"+Bm+"]",cE="[^"+Bm.replace("\\.","")+"]",uE=/((?:WC+[\/:])*)/.source.replace("WC",km),hE=/(WCOD+)?/.source.replace("WCOD",cE),dE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",km),fE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",km),pE=new RegExp("^"+uE+hE+dE+fE+"$"),mE=["material","materials","bones","map"],em=class{constructor(t,e,i){let s=i||hn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},hn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(lE,"")}static parseTrackName(t){let e=pE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);mE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){le("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){le("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){le("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){le("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){le("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){le("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){le("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;le("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){le("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){le("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};hn.Composite=em;hn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};hn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};hn.prototype.GetterByBindingType=[hn.prototype._getValue_direct,hn.prototype._getValue_array,hn.prototype._getValue_arrayElement,hn.prototype._getValue_toArray];hn.prototype.SetterByBindingTypeAndVersioning=[[hn.prototype._setValue_direct,hn.prototype._setValue_direct_setNeedsUpdate,hn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[hn.prototype._setValue_array,hn.prototype._setValue_array_setNeedsUpdate,hn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[hn.prototype._setValue_arrayElement,hn.prototype._setValue_arrayElement_setNeedsUpdate,hn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[hn.prototype._setValue_fromArray,hn.prototype._setValue_fromArray_setNeedsUpdate,hn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var BD=new Float32Array(1);var gx=new _e,Sc=class{constructor(t,e,i=0,s=1/0){this.ray=new Ar(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Fa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):le("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return gx.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(gx),this}intersectObject(t,e=!0,i=[]){return nm(t,this,i,e),i.sort(_x),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)nm(t[s],this,i,e);return i.sort(_x),i}};function _x(n,t){return n.distance-t.distance}function nm(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)nm(r[o],t,e,!0)}}var Wa=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ee(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Ee(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var im=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var wc=class extends Rs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function zm(n,t,e,i){let s=gE(i);switch(e){case Sm:return n*t;case qh:return n*t/s.components*s.byteLength;case Xh:return n*t/s.components*s.byteLength;case oo:return n*t*2/s.components*s.byteLength;case Yh:return n*t*2/s.components*s.byteLength;case wm:return n*t*3/s.components*s.byteLength;case Ls:return n*t*4/s.components*s.byteLength;case jh:return n*t*4/s.components*s.byteLength;case Ac:case Rc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Cc:case Pc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Jh:case Qh:return Math.max(n,16)*Math.max(t,8)/4;case Zh:case Kh:return Math.max(n,8)*Math.max(t,8)/2;case td:case ed:case id:case sd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case nd:case Ic:case rd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case od:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ad:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ld:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case cd:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case ud:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case hd:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case dd:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case fd:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case pd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case md:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case gd:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case _d:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case xd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case yd:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case vd:case bd:case Md:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Sd:case wd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Lc:case Ed:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function gE(n){switch(n){case ns:case ym:return{byteLength:1,components:1};case Ya:case vm:case Is:return{byteLength:2,components:1};case Wh:case $h:return{byteLength:2,components:4};case Ps:case Vh:case ds:return{byteLength:4,components:1};case bm:case Mm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ey(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function bE(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ME=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,SE=`#ifdef USE_ALPHAHASH
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
#endif`,wE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,EE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,AE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,RE=`#ifdef USE_AOMAP
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
#endif`,CE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,PE=`#ifdef USE_BATCHING
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
#endif`,IE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,LE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,DE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,NE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,UE=`#ifdef USE_IRIDESCENCE
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
#endif`,OE=`#ifdef USE_BUMPMAP
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
#endif`,FE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,BE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,HE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,GE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,VE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,WE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,$E=`#define PI 3.141592653589793
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
} // validated`,qE=`vec3 transformedNormal = objectNormal;
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
#endif`,XE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,YE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,jE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ZE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,JE="gl_FragColor = linearToOutputTexel( gl_FragColor );",KE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,QE=`#ifdef USE_ENVMAP
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
#endif`,tT=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,eT=`#ifdef USE_ENVMAP
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
#endif`,nT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iT=`#ifdef USE_ENVMAP
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
#endif`,sT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,oT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,aT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lT=`#ifdef USE_GRADIENTMAP
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
}`,cT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,uT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,dT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,fT=`#ifdef USE_ENVMAP
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
#endif`,pT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_T=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xT=`PhysicalMaterial material;
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
#endif`,yT=`uniform sampler2D dfgLUT;
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
}`,vT=`
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
#endif`,bT=`#if defined( RE_IndirectDiffuse )
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
#endif`,MT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,ST=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,wT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ET=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,AT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,RT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,CT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,PT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,IT=`#if defined( USE_POINTS_UV )
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
#endif`,LT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,DT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,NT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,UT=`#if defined( USE_MORPHCOLORS )
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
#endif`,OT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,FT=`#ifdef USE_MORPHTARGETS
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
#endif`,BT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,zT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,HT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,GT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,VT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,WT=`#ifdef USE_NORMALMAP
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
#endif`,$T=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,XT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,YT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,jT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ZT=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,JT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,KT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,QT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,tA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,eA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,nA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,iA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,sA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,rA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,oA=`float getShadowMask() {
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
}`,aA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,lA=`#ifdef USE_SKINNING
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
#endif`,cA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,uA=`#ifdef USE_SKINNING
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
#endif`,hA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,dA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,pA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,mA=`#ifdef USE_TRANSMISSION
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
#endif`,gA=`#ifdef USE_TRANSMISSION
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
#endif`,_A=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,yA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,MA=`uniform sampler2D t2D;
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
}`,SA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wA=`uniform float backgroundBlurriness;
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
}`,EA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AA=`#include <common>
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
}`,RA=`#if DEPTH_PACKING == 3200
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
}`,CA=`#define DISTANCE
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
}`,PA=`#define DISTANCE
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
}`,IA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,LA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DA=`uniform float scale;
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
}`,NA=`uniform vec3 diffuse;
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
}`,UA=`#include <common>
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
}`,OA=`uniform vec3 diffuse;
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
}`,FA=`#define LAMBERT
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
}`,BA=`#define LAMBERT
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
}`,kA=`#define MATCAP
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
}`,zA=`#define MATCAP
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
}`,HA=`#define NORMAL
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
}`,GA=`#define NORMAL
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
}`,VA=`#define PHONG
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
}`,WA=`#define PHONG
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
}`,$A=`#define STANDARD
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
}`,qA=`#define STANDARD
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
}`,XA=`#define TOON
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
}`,YA=`#define TOON
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
}`,jA=`uniform float size;
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
}`,ZA=`uniform vec3 diffuse;
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
}`,JA=`#include <common>
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
}`,KA=`uniform vec3 color;
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
}`,QA=`uniform float rotation;
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
}`,tR=`uniform vec3 diffuse;
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
}`,Se={alphahash_fragment:ME,alphahash_pars_fragment:SE,alphamap_fragment:wE,alphamap_pars_fragment:EE,alphatest_fragment:TE,alphatest_pars_fragment:AE,aomap_fragment:RE,aomap_pars_fragment:CE,batching_pars_vertex:PE,batching_vertex:IE,begin_vertex:LE,beginnormal_vertex:DE,bsdfs:NE,iridescence_fragment:UE,bumpmap_pars_fragment:OE,clipping_planes_fragment:FE,clipping_planes_pars_fragment:BE,clipping_planes_pars_vertex:kE,clipping_planes_vertex:zE,color_fragment:HE,color_pars_fragment:GE,color_pars_vertex:VE,color_vertex:WE,common:$E,defaultnormal_vertex:qE,displacementmap_pars_vertex:XE,displacementmap_vertex:YE,emissivemap_fragment:jE,emissivemap_pars_fragment:ZE,colorspace_fragment:JE,colorspace_pars_fragment:KE,envmap_fragment:QE,envmap_common_pars_fragment:tT,envmap_pars_fragment:eT,envmap_pars_vertex:nT,envmap_physical_pars_fragment:fT,envmap_vertex:iT,fog_vertex:sT,fog_pars_vertex:rT,fog_fragment:oT,fog_pars_fragment:aT,gradientmap_pars_fragment:lT,lightmap_pars_fragment:cT,lights_lambert_fragment:uT,lights_lambert_pars_fragment:hT,lights_pars_begin:dT,lights_toon_fragment:pT,lights_toon_pars_fragment:mT,lights_phong_fragment:gT,lights_phong_pars_fragment:_T,lights_physical_fragment:xT,lights_physical_pars_fragment:yT,lights_fragment_begin:vT,lights_fragment_maps:bT,lights_fragment_end:MT,lightprobes_pars_fragment:ST,logdepthbuf_fragment:wT,logdepthbuf_pars_fragment:ET,logdepthbuf_pars_vertex:TT,logdepthbuf_vertex:AT,map_fragment:RT,map_pars_fragment:CT,map_particle_fragment:PT,map_particle_pars_fragment:IT,metalnessmap_fragment:LT,metalnessmap_pars_fragment:DT,morphinstance_vertex:NT,morphcolor_vertex:UT,morphnormal_vertex:OT,morphtarget_pars_vertex:FT,morphtarget_vertex:BT,normal_fragment_begin:kT,normal_fragment_maps:zT,normal_pars_fragment:HT,normal_pars_vertex:GT,normal_vertex:VT,normalmap_pars_fragment:WT,clearcoat_normal_fragment_begin:$T,clearcoat_normal_fragment_maps:qT,clearcoat_pars_fragment:XT,iridescence_pars_fragment:YT,opaque_fragment:jT,packing:ZT,premultiplied_alpha_fragment:JT,project_vertex:KT,dithering_fragment:QT,dithering_pars_fragment:tA,roughnessmap_fragment:eA,roughnessmap_pars_fragment:nA,shadowmap_pars_fragment:iA,shadowmap_pars_vertex:sA,shadowmap_vertex:rA,shadowmask_pars_fragment:oA,skinbase_vertex:aA,skinning_pars_vertex:lA,skinning_vertex:cA,skinnormal_vertex:uA,specularmap_fragment:hA,specularmap_pars_fragment:dA,tonemapping_fragment:fA,tonemapping_pars_fragment:pA,transmission_fragment:mA,transmission_pars_fragment:gA,uv_pars_fragment:_A,uv_pars_vertex:xA,uv_vertex:yA,worldpos_vertex:vA,background_vert:bA,background_frag:MA,backgroundCube_vert:SA,backgroundCube_frag:wA,cube_vert:EA,cube_frag:TA,depth_vert:AA,depth_frag:RA,distance_vert:CA,distance_frag:PA,equirect_vert:IA,equirect_frag:LA,linedashed_vert:DA,linedashed_frag:NA,meshbasic_vert:UA,meshbasic_frag:OA,meshlambert_vert:FA,meshlambert_frag:BA,meshmatcap_vert:kA,meshmatcap_frag:zA,meshnormal_vert:HA,meshnormal_frag:GA,meshphong_vert:VA,meshphong_frag:WA,meshphysical_vert:$A,meshphysical_frag:qA,meshtoon_vert:XA,meshtoon_frag:YA,points_vert:jA,points_frag:ZA,shadow_vert:JA,shadow_frag:KA,sprite_vert:QA,sprite_frag:tR},kt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ue},alphaMap:{value:null},alphaMapTransform:{value:new ue},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ue}},envmap:{envMap:{value:null},envMapRotation:{value:new ue},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ue}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ue}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ue},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ue},normalScale:{value:new Qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ue},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ue}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ue}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ue}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ue},alphaTest:{value:0},uvTransform:{value:new ue}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ue},alphaMap:{value:null},alphaMapTransform:{value:new ue},alphaTest:{value:0}}},or={basic:{uniforms:mi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.fog]),vertexShader:Se.meshbasic_vert,fragmentShader:Se.meshbasic_frag},lambert:{uniforms:mi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:Se.meshlambert_vert,fragmentShader:Se.meshlambert_frag},phong:{uniforms:mi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Se.meshphong_vert,fragmentShader:Se.meshphong_frag},standard:{uniforms:mi([kt.common,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.roughnessmap,kt.metalnessmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag},toon:{uniforms:mi([kt.common,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.gradientmap,kt.fog,kt.lights,{emissive:{value:new ee(0)}}]),vertexShader:Se.meshtoon_vert,fragmentShader:Se.meshtoon_frag},matcap:{uniforms:mi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,{matcap:{value:null}}]),vertexShader:Se.meshmatcap_vert,fragmentShader:Se.meshmatcap_frag},points:{uniforms:mi([kt.points,kt.fog]),vertexShader:Se.points_vert,fragmentShader:Se.points_frag},dashed:{uniforms:mi([kt.common,kt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Se.linedashed_vert,fragmentShader:Se.linedashed_frag},depth:{uniforms:mi([kt.common,kt.displacementmap]),vertexShader:Se.depth_vert,fragmentShader:Se.depth_frag},normal:{uniforms:mi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,{opacity:{value:1}}]),vertexShader:Se.meshnormal_vert,fragmentShader:Se.meshnormal_frag},sprite:{uniforms:mi([kt.sprite,kt.fog]),vertexShader:Se.sprite_vert,fragmentShader:Se.sprite_frag},background:{uniforms:{uvTransform:{value:new ue},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Se.background_vert,fragmentShader:Se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ue}},vertexShader:Se.backgroundCube_vert,fragmentShader:Se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Se.cube_vert,fragmentShader:Se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Se.equirect_vert,fragmentShader:Se.equirect_frag},distance:{uniforms:mi([kt.common,kt.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Se.distance_vert,fragmentShader:Se.distance_frag},shadow:{uniforms:mi([kt.lights,kt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:Se.shadow_vert,fragmentShader:Se.shadow_frag}};or.physical={uniforms:mi([or.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ue},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ue},clearcoatNormalScale:{value:new Qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ue},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ue},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ue},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ue},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ue},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ue},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ue},transmissionSamplerSize:{value:new Qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ue},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ue},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ue},anisotropyVector:{value:new Qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ue}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag};var Rd={r:0,b:0,g:0},eR=new _e,Ty=new ue;Ty.set(-1,0,0,0,1,0,0,0,1);function nR(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let T=_.isScene===!0?_.background:null;if(T&&T.isTexture){let v=_.backgroundBlurriness>0;T=t.get(T,v)}return T}function p(_){let T=!1,v=f(_);v===null?m(o,a):v&&v.isColor&&(m(v,1),T=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,T){let v=f(T);v&&v.isCubeTexture?(c===void 0&&(c=new je(new ki(1,1,1),new fi({name:"BackgroundCubeMaterial",uniforms:Ho(or.backgroundCube.uniforms),vertexShader:or.backgroundCube.vertexShader,fragmentShader:or.backgroundCube.fragmentShader,side:ri,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,S,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(eR.makeRotationFromEuler(T.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ty),c.material.toneMapped=De.getTransfer(v.colorSpace)!==We,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new je(new vc(2,2),new fi({name:"BackgroundMaterial",uniforms:Ho(or.background.uniforms),vertexShader:or.background.vertexShader,fragmentShader:or.background.fragmentShader,side:ir,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=De.getTransfer(v.colorSpace)!==We,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,T){_.getRGB(Rd,Fm(n)),e.buffers.color.setClear(Rd.r,Rd.g,Rd.b,T,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,T=1){o.set(_),a=T,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:x,dispose:g}}function iR(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(N,H,$,P,z){let D=!1,B=h(N,P,$,H);r!==B&&(r=B,c(r.object)),D=f(N,P,$,z),D&&p(N,P,$,z),z!==null&&t.update(z,n.ELEMENT_ARRAY_BUFFER),(D||o)&&(o=!1,v(N,H,$,P),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,H,$,P){let z=P.wireframe===!0,D=i[H.id];D===void 0&&(D={},i[H.id]=D);let B=N.isInstancedMesh===!0?N.id:0,Q=D[B];Q===void 0&&(Q={},D[B]=Q);let Y=Q[$.id];Y===void 0&&(Y={},Q[$.id]=Y);let Z=Y[z];return Z===void 0&&(Z=d(l()),Y[z]=Z),Z}function d(N){let H=[],$=[],P=[];for(let z=0;z<e;z++)H[z]=0,$[z]=0,P[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:$,attributeDivisors:P,object:N,attributes:{},index:null}}function f(N,H,$,P){let z=r.attributes,D=H.attributes,B=0,Q=$.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let et=z[Y],dt=D[Y];if(dt===void 0&&(Y==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),Y==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;B++}return r.attributesNum!==B||r.index!==P}function p(N,H,$,P){let z={},D=H.attributes,B=0,Q=$.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let et=D[Y];et===void 0&&(Y==="instanceMatrix"&&N.instanceMatrix&&(et=N.instanceMatrix),Y==="instanceColor"&&N.instanceColor&&(et=N.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),z[Y]=dt,B++}r.attributes=z,r.attributesNum=B,r.index=P}function x(){let N=r.newAttributes;for(let H=0,$=N.length;H<$;H++)N[H]=0}function m(N){g(N,0)}function g(N,H){let $=r.newAttributes,P=r.enabledAttributes,z=r.attributeDivisors;$[N]=1,P[N]===0&&(n.enableVertexAttribArray(N),P[N]=1),z[N]!==H&&(n.vertexAttribDivisor(N,H),z[N]=H)}function _(){let N=r.newAttributes,H=r.enabledAttributes;for(let $=0,P=H.length;$<P;$++)H[$]!==N[$]&&(n.disableVertexAttribArray($),H[$]=0)}function T(N,H,$,P,z,D,B){B===!0?n.vertexAttribIPointer(N,H,$,z,D):n.vertexAttribPointer(N,H,$,P,z,D)}function v(N,H,$,P){x();let z=P.attributes,D=$.getAttributes(),B=H.defaultAttributeValues;for(let Q in D){let Y=D[Q];if(Y.location>=0){let Z=z[Q];if(Z===void 0&&(Q==="instanceMatrix"&&N.instanceMatrix&&(Z=N.instanceMatrix),Q==="instanceColor"&&N.instanceColor&&(Z=N.instanceColor)),Z!==void 0){let et=Z.normalized,dt=Z.itemSize,ft=t.get(Z);if(ft===void 0)continue;let st=ft.buffer,yt=ft.type,_t=ft.bytesPerElement,Tt=yt===n.INT||yt===n.UNSIGNED_INT||Z.gpuType===Vh;if(Z.isInterleavedBufferAttribute){let At=Z.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,me=Z.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let jt=0;jt<Y.locationSize;jt++)g(Y.location+jt,At.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let jt=0;jt<Y.locationSize;jt++)m(Y.location+jt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let jt=0;jt<Y.locationSize;jt++)T(Y.location+jt,dt/Y.locationSize,yt,et,Jt*_t,(me+dt/Y.locationSize*jt)*_t,Tt)}else{if(Z.isInstancedBufferAttribute){for(let At=0;At<Y.locationSize;At++)g(Y.location+At,Z.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let At=0;At<Y.locationSize;At++)m(Y.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<Y.locationSize;At++)T(Y.location+At,dt/Y.locationSize,yt,et,dt*_t,dt/Y.locationSize*At*_t,Tt)}}else if(B!==void 0){let et=B[Q];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(Y.location,et);break;case 3:n.vertexAttrib3fv(Y.location,et);break;case 4:n.vertexAttrib4fv(Y.location,et);break;default:n.vertexAttrib1fv(Y.location,et)}}}}_()}function A(){U();for(let N in i){let H=i[N];for(let $ in H){let P=H[$];for(let z in P){let D=P[z];for(let B in D)u(D[B].object),delete D[B];delete P[z]}}delete i[N]}}function S(N){if(i[N.id]===void 0)return;let H=i[N.id];for(let $ in H){let P=H[$];for(let z in P){let D=P[z];for(let B in D)u(D[B].object),delete D[B];delete P[z]}}delete i[N.id]}function y(N){for(let H in i){let $=i[H];for(let P in $){let z=$[P];if(z[N.id]===void 0)continue;let D=z[N.id];for(let B in D)u(D[B].object),delete D[B];delete z[N.id]}}}function w(N){for(let H in i){let $=i[H],P=N.isInstancedMesh===!0?N.id:0,z=$[P];if(z!==void 0){for(let D in z){let B=z[D];for(let Q in B)u(B[Q].object),delete B[Q];delete z[D]}delete $[P],Object.keys($).length===0&&delete i[H]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:_}}function sR(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function rR(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ls&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===Is&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==ns&&y!==ds&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:T,maxFragmentUniforms:v,maxSamples:A,samples:S}}function oR(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ii,a=new ue,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let _=r?0:i,T=_*4,v=g.clippingState||null;l.value=v,v=u(p,d,T,f);for(let A=0;A!==T;++A)v[A]=e[A];g.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let T=0,v=f;T!==x;++T,v+=4)o.copy(h[T]).applyMatrix4(_,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Uc=class extends Qi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new pc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ki(5,5,5),r=new fi({name:"CubemapFromEquirect",uniforms:Ho(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ri,blending:Fo});r.uniforms.tEquirect.value=e;let o=new je(s,r),a=e.minFilter;return e.minFilter===Pr&&(e.minFilter=Ai),new Va(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},sy=256,aR=3,lR=20,Ay=256,Ry=16,cR=3,uR=new G,hR=new ee,Pd=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Va(1,10,null),this._boxMesh=new je(new ki(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=uR}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(hR));let m=new Va(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ay(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=oy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(sy,Nm(t))}_fromTexture(t,e){t.mapping===ko||t.mapping===Xa?this._setSize(t.image.length===0?sy:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=ry(t,!1,!1),i=Math.log2(t)-aR;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ry(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ko||t.mapping===Xa?(this._cubemapMaterial===null&&(this._cubemapMaterial=ay()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=oy()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=dR(),this._integrationMaterial=fR());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Ry);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-cR)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Ay*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=pR());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function ry(n,t,e){return new Uc(n,{minFilter:Pr,generateMipmaps:t,type:Is,colorSpace:nc,depthBuffer:e})}function Oc(n,t,e){return new fi({name:n,uniforms:t,vertexShader:Se.cube_vert,fragmentShader:e,side:ri,blending:Fo,depthTest:!1,depthWrite:!1})}function dR(){return Oc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ay}u

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
	`)}function fR(){return Oc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ry}},`

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
	`)}function pR(){return Oc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${lR}
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
	`)}function oy(){return Oc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function ay(){return Oc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function mR(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===zh||f===Hh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Uc(p.height);return x.fromEquirectangularTexture(n,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===zh||f===Hh,x=f===ko||f===Xa;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Pd(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new Pd(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===zh?d.mapping=ko:f===Hh&&(d.mapping=Xa),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function gR(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Kl("WebGLRenderer: "+i+" extension not supported."),s}}}function _R(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function u(p){let x=p.attributes;for(let m in x)t.update(x[m],n.ARRAY_BUFFER)}function h(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=x!==null?x.array.length:m.array.length/3-1,T=m.count>=65535?hc:uc,v=new T(Math.ceil(_/3)*6,1),A=v.array;if(x!==null){let y=x.array;g=x.version;for(let w=0,U=0;w<_;w+=3){let L=y[w+0],N=y[w+1],H=y[w+2];A[U++]=L,A[U++]=N,A[U++]=N,A[U++]=H,A[U++]=H,A[U++]=L}}else{g=m.version;for(let y=0,w=0;y<_;y+=3){let U=y+0,L=y+1,N=y+2;A[w++]=U,A[w++]=L,A[w++]=L,A[w++]=N,A[w++]=N,A[w++]=U}}v.version=g;let S=r.get(p);S&&t.remove(S),r.set(p,v)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function xR(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function yR(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:le("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function vR(n,t,e){let i=new WeakMap,s=new bn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],T=0;f===!0&&(T=1),p===!0&&(T=2),x===!0&&(T=3);let v=a.attributes.position.count*T,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let S=new Float32Array(v*A*4*h),y=new ac(S,v,A,h);y.type=ds,y.needsUpdate=!0;let w=T*4;for(let L=0;L<h;L++){let N=m[L],H=g[L],$=_[L],P=v*A*4*L;for(let z=0;z<N.count;z++){let D=z*w;f===!0&&(s.fromBufferAttribute(N,z),S[P+D+0]=s.x,S[P+D+1]=s.y,S[P+D+2]=s.z,S[P+D+3]=0),p===!0&&(s.fromBufferAttribute(H,z),S[P+D+4]=s.x,S[P+D+5]=s.y,S[P+D+6]=s.z,S[P+D+7]=0),x===!0&&(s.fromBufferAttribute($,z),S[P+D+8]=s.x,S[P+D+9]=s.y,S[P+D+10]=s.z,S[P+D+11]=$.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Qt(v,A)},i.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function bR(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var MR={[hm]:"LINEAR_TONE_MAPPING",[dm]:"REINHARD_TONE_MAPPING",[fm]:"CINEON_TONE_MAPPING",[pm]:"ACES_FILMIC_TONE_MAPPING",[gm]:"AGX_TONE_MAPPING",[_m]:"NEUTRAL_TONE_MAPPING",[mm]:"CUSTOM_TONE_MAPPING"};function SR(n,t,e,i,s,r){let o=new Qi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ae;u.setAttribute("position",new Te([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Te([0,2,0,0,2,0],2));let h=new Eh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new je(u,h),f=new Bh(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,_=null,T=[],v=!1;this.setSize=function(A,S){o.setSize(A,S),a!==null&&a.setSize(A,S),l!==null&&l.setSize(A,S);for(let y=0;y<T.length;y++){let w=T[y];w.setSize&&w.setSize(A,S)}},this.setEffects=function(A){T=A,v=T.length>0&&T[0].isRenderPass===!0;let S=o.width,y=o.height;T.length>0&&a===null&&(a=new Qi(S,y,{type:Is,depthBuffer:!1,stencilBuffer:!1}),l=new Qi(S,y,{type:Is,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&T.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Cr(S,y),r===!0&&(c.format=Ir,c.type=zo)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<T.length;U++){let L=T[U];L.setSize&&L.setSize(S,y),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(A,S){if(m||A.toneMapping===sr&&T.length===0)return!1;if(_=S,S!==null){let y=S.width,w=S.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return v===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=sr,!0},this.hasRenderPass=function(){return v},this.end=function(A,S){A.toneMapping=g,m=!0;let y=o,w=a;for(let U=0;U<T.length;U++){let L=T[U];L.enabled!==!1&&(L.render(A,w,y,S),L.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(p!==A.outputColorSpace||x!==A.toneMapping){p=A.outputColorSpace,x=A.toneMapping,h.defines={},De.getTransfer(p)===We&&(h.defines.SRGB_TRANSFER="");let U=MR[x];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(_),A.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Cy=new Oi,Py=new Cr(1,1),Iy=new mc(1),Ly=new ac,Dy=new vh,Ny=new pc,ly=[],cy=[],uy=new Float32Array(16),hy=new Float32Array(9),dy=new Float32Array(4);function Za(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=ly[s];if(r===void 0&&(r=new Float32Array(s),ly[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Gn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Vn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Ld(n,t){let e=cy[t];e===void 0&&(e=new Int32Array(t),cy[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function wR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function ER(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Gn(e,t))return;n.uniform2fv(this.addr,t),Vn(e,t)}}function TR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Gn(e,t))return;n.uniform3fv(this.addr,t),Vn(e,t)}}function AR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Gn(e,t))return;n.uniform4fv(this.addr,t),Vn(e,t)}}function RR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Gn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Vn(e,t)}else{if(Gn(e,i))return;dy.set(i),n.uniformMatrix2fv(this.addr,!1,dy),Vn(e,i)}}function CR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Gn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Vn(e,t)}else{if(Gn(e,i))return;hy.set(i),n.uniformMatrix3fv(this.addr,!1,hy),Vn(e,i)}}function PR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Gn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Vn(e,t)}else{if(Gn(e,i))return;uy.set(i),n.uniformMatrix4fv(this.addr,!1,uy),Vn(e,i)}}function IR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function LR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Gn(e,t))return;n.uniform2iv(this.addr,t),Vn(e,t)}}function DR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Gn(e,t))return;n.uniform3iv(this.addr,t),Vn(e,t)}}function NR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Gn(e,t))return;n.uniform4iv(this.addr,t),Vn(e,t)}}function UR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function OR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Gn(e,t))return;n.uniform2uiv(this.addr,t),Vn(e,t)}}function FR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Gn(e,t))return;n.uniform3uiv(this.addr,t),Vn(e,t)}}function BR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Gn(e,t))return;n.uniform4uiv(this.addr,t),Vn(e,t)}}function Dd(n){return n.version===0&&(n.compareFunction=Pm,n.needsUpdate=!0),n}function kR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Dd(Py):r=Cy,e.setTexture2D(t||r,s)}function zR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Dy,s)}function HR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Dd(Iy):r=Ny,e.setTextureCube(t||r,s)}function GR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Ly,s)}function VR(n){switch(n){case 5126:return wR;case 35664:return ER;case 35665:return TR;case 35666:return AR;case 35674:return RR;case 35675:return CR;case 35676:return PR;case 5124:case 35670:return IR;case 35667:case 35671:return LR;case 35668:case 35672:return DR;case 35669:case 35673:return NR;case 5125:return UR;case 36294:return OR;case 36295:return FR;case 36296:return BR;case 35678:case 36198:case 36298:case 36306:case 35682:return kR;case 35679:case 36299:case 36307:return zR;case 35680:case 36300:case 36308:case 36293:return HR;case 36289:case 36303:case 36311:case 36292:return GR}}function WR(n,t){n.uniform1fv(this.addr,t)}function $R(n,t){let e=Za(t,this.size,2);n.uniform2fv(this.addr,e)}function qR(n,t){let e=Za(t,this.size,3);n.uniform3fv(this.addr,e)}function XR(n,t){let e=Za(t,this.size,4);n.uniform4fv(this.addr,e)}function YR(n,t){let e=Za(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function jR(n,t){let e=Za(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function ZR(n,t){let e=Za(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function JR(n,t){n.uniform1iv(this.addr,t)}function KR(n,t){n.uniform2iv(this.addr,t)}function QR(n,t){n.uniform3iv(this.addr,t)}function tC(n,t){n.uniform4iv(this.addr,t)}function eC(n,t){n.uniform1uiv(this.addr,t)}function nC(n,t){n.uniform2uiv(this.addr,t)}function iC(n,t){n.uniform3uiv(this.addr,t)}function sC(n,t){n.uniform4uiv(this.addr,t)}function rC(n,t,e){let i=this.cache,s=t.length,r=Ld(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Dd(Py):o=Cy;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function oC(n,t,e){let i=this.cache,s=t.length,r=Ld(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Dy,r[o])}function aC(n,t,e){let i=this.cache,s=t.length,r=Ld(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Dd(Iy):o=Ny;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function lC(n,t,e){let i=this.cache,s=t.length,r=Ld(e,s);Gn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Ly,r[o])}function cC(n){switch(n){case 5126:return WR;case 35664:return $R;case 35665:return qR;case 35666:return XR;case 35674:return YR;case 35675:return jR;case 35676:return ZR;case 5124:case 35670:return JR;case 35667:case 35671:return KR;case 35668:case 35672:return QR;case 35669:case 35673:return tC;case 5125:return eC;case 36294:return nC;case 36295:return iC;case 36296:return sC;case 35678:case 36198:case 36298:case 36306:case 35682:return rC;case 35679:case 36299:case 36307:return oC;case 35680:case 36300:case 36308:case 36293:return aC;case 36289:case 36303:case 36311:case 36292:return lC}}var Vm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=VR(e.type)}},Wm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=cC(e.type)}},$m=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Hm=/(\w+)(\])?(\[|\.)?/g;function fy(n,t){n.seq.push(t),n.map[t.id]=t}function uC(n,t,e){let i=n.name,s=i.length;for(Hm.lastIndex=0;;){let r=Hm.exec(i),o=Hm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){fy(e,c===void 0?new Vm(a,n,t):new Wm(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new $m(a),fy(e,h)),e=h}}}var ja=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);uC(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function py(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var hC=37297,dC=0;function fC(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var my=new ue;function pC(n){De._getMatrix(my,De.workingColorSpace,n);let t=`mat3( ${my.elements.map(e=>e.toFixed(4))} )`;switch(De.getTransfer(n)){case ic:return[t,"LinearTransferOETF"];case We:return[t,"sRGBTransferOETF"];default:return ie("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function gy(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+fC(n.getShaderSource(t),a)}else return r}function mC(n,t){let e=pC(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var gC={[hm]:"Linear",[dm]:"Reinhard",[fm]:"Cineon",[pm]:"ACESFilmic",[gm]:"AgX",[_m]:"Neutral",[mm]:"Custom"};function _C(n,t){let e=gC[t];return e===void 0?(ie("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Cd=new G;function xC(){De.getLuminanceCoefficients(Cd);let n=Cd.x.toFixed(4),t=Cd.y.toFixed(4),e=Cd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function yC(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Nc).join(`
`)}function vC(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function bC(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Nc(n){return n!==""}function _y(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function xy(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var MC=/^[ \t]*#include +<([\w\d./]+)>/gm;function qm(n){return n.replace(MC,SC)}function SC(n,t){let e=Se[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return qm(e)}var wC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function yy(n){return n.replace(wC,EC)}function EC(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vy(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var TC={[Ec]:"SHADOWMAP_TYPE_PCF",[$a]:"SHADOWMAP_TYPE_VSM"};function AC(n){return TC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var RC={[Xa]:"ENVMAP_MODE_REFRACTION"};function CC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":RC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var PC={[um]:"ENVMAP_BLENDING_MULTIPLY",[kx]:"ENVMAP_BLENDING_MIX",[zx]:"ENVMAP_BLENDING_ADD"};function IC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":PC[n.combine]||"ENVMAP_BLENDING_NONE"}function LC(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=AC(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=CC(e),h=IC(e),d=yC(e),f=vC(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Nc).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Nc).join(`
`),m.length>0&&(m+=`
`)):(x=[vy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Nc).join(`
`),m=[vy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==sr?"#define TONE_MAPPING":"",e.toneMapping!==sr?Se.tonemapping_pars_fragment:"",e.toneMapping!==sr?_C("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Se.colorspace_pars_fragment,mC("linearToOutputTexel",e.outputColorSpace),xC(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Nc).join(`
`)),o=qm(o),o=_y(o,e),o=xy(o,e),a=qm(a),a=_y(a,e),a=xy(a,e),o=yy(o),a=yy(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===Lm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Lm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+x+o,T=g+m+a,v=py(s,s.VERTEX_SHADER,_),A=py(s,s.FRAGMENT_SHADER,T);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(L){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(v)||"",$=s.getShaderInfoLog(A)||"",P=N.trim(),z=H.trim(),D=$.trim(),B=!0,Q=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(B=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,A);else{let Y=gy(s,v,"vertex"),Z=gy(s,A,"fragment");le("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+P+`
`+Y+`
`+Z)}else P!==""?ie("WebGLProgram: Program Info Log:",P):(z===""||D==="")&&(Q=!1);Q&&(L.diagnostics={runnable:B,programLog:P,vertexShader:{log:z,prefix:x},fragmentShader:{log:D,prefix:m}})}s.deleteShader(v),s.deleteShader(A),y=new ja(s,p),w=bC(s,p)}let y;this.getUniforms=function(){return y===void 0&&S(this),y};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,hC)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=dC++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var DC=0,Xm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Ym(t),e.set(t,i)),i}},Ym=class{constructor(t){this.id=DC++,this.code=t,this.usedTimes=0}};function NC(n){return n===oo||n===Ic||n===Lc}function UC(n,t,e,i,s,r){let o=new Fa,a=new Xm,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,w,U,L,N,H){let $=L.fog,P=N.geometry,z=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,D=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,B=t.get(y.envMap||z,D),Q=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&ie("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let Z=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,et=Z!==void 0?Z.length:0,dt=0;P.morphAttributes.position!==void 0&&(dt=1),P.morphAttributes.normal!==void 0&&(dt=2),P.morphAttributes.color!==void 0&&(dt=3);let ft,st,yt,_t;if(Q){let Dt=or[Q];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=y.vertexShader,st=y.fragmentShader;let Dt=a.getVertexShaderStage(y),ye=a.getFragmentShaderStage(y);a.update(y,Dt,ye),yt=Dt.id,_t=ye.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=N.isInstancedMesh===!0,me=N.isBatchedMesh===!0,jt=!!y.map,we=!!y.matcap,ve=!!B,fe=ve&&B.isPMREMTexture===!0,_n=!!y.aoMap,rn=!!y.lightMap,In=!!y.bumpMap&&y.wireframe===!1,Je=!!y.normalMap,Yn=!!y.displacementMap,Ue=!!y.emissiveMap,kn=!!y.metalnessMap,Sn=!!y.roughnessMap,Ln=y.anisotropy>0,W=y.clearcoat>0,Nt=y.diffuseRoughness>0,se=y.dispersion>0,ge=y.retroreflectivity>0,Ct=y.iridescence>0,Qe=y.sheen>0,Yt=y.transmission>0,ne=Ln&&!!y.anisotropyMap,O=W&&!!y.clearcoatMap,R=W&&!!y.clearcoatNormalMap,j=W&&!!y.clearcoatRoughnessMap,mt=Nt&&!!y.diffuseRoughnessMap,ct=Ct&&!!y.iridescenceMap,St=Ct&&!!y.iridescenceThicknessMap,wt=Qe&&!!y.sheenColorMap,rt=Qe&&!!y.sheenRoughnessMap,at=!!y.specularMap,vt=!!y.specularColorMap,V=!!y.specularIntensityMap,lt=Yt&&!!y.transmissionMap,ot=Yt&&!!y.thicknessMap,Pt=!!y.gradientMap,Mt=!!y.alphaMap,Rt=y.alphaTest>0,Zt=!!y.alphaHash,oe=!!y.extensions,pt=sr;y.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let $t=fe?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,ae={shaderID:Q,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:st,defines:y.defines,customVertexShaderID:yt,customFragmentShaderID:_t,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:me,batchingColor:me&&N._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&N.instanceColor!==null,instancingMorph:Jt&&N.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:De.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:jt,matcap:we,envMap:ve,envMapMode:ve&&B.mapping,envMapPMREM:fe,envMapMaxLod:fe?$t.length-1:null,envMapSize:fe?$t[0].width:null,aoMap:_n,lightMap:rn,bumpMap:In,normalMap:Je,displacementMap:Yn,emissiveMap:Ue,normalMapObjectSpace:Je&&y.normalMapType===Vx,normalMapTangentSpace:Je&&y.normalMapType===Em,packedNormalMap:Je&&y.normalMapType===Em&&NC(y.normalMap.format),metalnessMap:kn,roughnessMap:Sn,anisotropy:Ln,anisotropyMap:ne,clearcoat:W,clearcoatMap:O,clearcoatNormalMap:R,clearcoatRoughnessMap:j,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:se,retroreflection:ge,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:St,sheen:Qe,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:V,transmission:Yt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:y.transparent===!1&&y.blending===qa&&y.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:Zt,combine:y.combine,mapUv:jt&&f(y.map.channel),aoMapUv:_n&&f(y.aoMap.channel),lightMapUv:rn&&f(y.lightMap.channel),bumpMapUv:In&&f(y.bumpMap.channel),normalMapUv:Je&&f(y.normalMap.channel),displacementMapUv:Yn&&f(y.displacementMap.channel),emissiveMapUv:Ue&&f(y.emissiveMap.channel),metalnessMapUv:kn&&f(y.metalnessMap.channel),roughnessMapUv:Sn&&f(y.roughnessMap.channel),anisotropyMapUv:ne&&f(y.anisotropyMap.channel),clearcoatMapUv:O&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(y.sheenRoughnessMap.channel),specularMapUv:at&&f(y.specularMap.channel),specularColorMapUv:vt&&f(y.specularColorMap.channel),specularIntensityMapUv:V&&f(y.specularIntensityMap.channel),transmissionMapUv:lt&&f(y.transmissionMap.channel),thicknessMapUv:ot&&f(y.thicknessMap.channel),alphaMapUv:Mt&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Je||Ln),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(jt||Mt),fog:!!$,useFog:y.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&Je===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:H.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:jt&&y.map.isVideoTexture===!0&&De.getTransfer(y.map.colorSpace)===We,decodeVideoTextureEmissive:Ue&&y.emissiveMap.isVideoTexture===!0&&De.getTransfer(y.emissiveMap.colorSpace)===We,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===pi,flipSided:y.side===ri,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:oe&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(oe&&y.extensions.multiDraw===!0||me)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ae.vertexUv1s=l.has(1),ae.vertexUv2s=l.has(2),ae.vertexUv3s=l.has(3),l.clear(),ae}function x(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)w.push(U),w.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(w,y),g(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function m(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let w=d[y.type],U;if(w){let L=or[w];U=ey.clone(L.uniforms)}else U=y.uniforms;return U}function T(y,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new LC(n,w,y,s),c.push(U),u.set(w,U)),U}function v(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:T,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:S}}function OC(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function FC(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function by(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function My(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let _=n[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=m,_.group=g),t++,_}function l(d,f,p,x,m,g,_){_.reversedDepth===!0&&(m=-m);let T=a(d,f,p,x,m,g);p.transmission>0?i.push(T):p.transparent===!0?s.push(T):e.push(T)}function c(d,f,p,x,m,g){let _=a(d,f,p,x,m,g);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function u(d,f){e.length>1&&e.sort(d||FC),i.length>1&&i.sort(f||by),s.length>1&&s.sort(f||by)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function BC(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new My,n.set(i,[o])):s>=r.length?(o=new My,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function kC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new ee};break;case"SpotLight":e={position:new G,direction:new G,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new G,halfWidth:new G,halfHeight:new G};break}return n[t.id]=e,e}}}function zC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var HC=0;function GC(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function VC(n){let t=new kC,e=zC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new _e,o=new _e;function a(c){let u=0,h=0,d=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,_=0,T=0,v=0,A=0,S=0,y=0,w=0,U=0,L=0;c.sort(GC);for(let H=0,$=c.length;H<$;H++){let P=c[H],z=P.color,D=P.intensity,B=P.distance,Q=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===oo?Q=P.shadow.map.texture:Q=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=z.r*D,h+=z.g*D,d+=z.b*D;else if(P.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(P.sh.coefficients[Y],D);L++}else if(P.isSunLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,et=e.get(P);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=Q;let dt=Z.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[x+ft]=Z.getMatrix(ft),i.sunShadowCascade[x+ft]=Z._cascadeData[ft];x+=dt,p++}i.sun[f]=Y,f++}else if(P.isDirectionalLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Z=P.shadow,et=e.get(P);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize=Z.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=Q,i.directionalShadowMatrix[m]=P.shadow.matrix,A++}i.directional[m]=Y,m++}else if(P.isSpotLight){let Y=t.get(P);Y.position.setFromMatrixPosition(P.matrixWorld),Y.color.copy(z).multiplyScalar(D),Y.distance=B,Y.coneCos=Math.cos(P.angle),Y.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),Y.decay=P.decay,i.spot[_]=Y;let Z=P.shadow;if(P.map&&(i.spotLightMap[w]=P.map,w++,Z.updateMatrices(P),P.castShadow&&U++),i.spotLightMatrix[_]=Z.matrix,P.castShadow){let et=e.get(P);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize=Z.mapSize,i.spotShadow[_]=et,i.spotShadowMap[_]=Q,y++}_++}else if(P.isRectAreaLight){let Y=t.get(P);Y.color.copy(z).multiplyScalar(D),Y.halfWidth.set(P.width*.5,0,0),Y.halfHeight.set(0,P.height*.5,0),i.rectArea[T]=Y,T++}else if(P.isPointLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),Y.distance=P.distance,Y.decay=P.decay,P.castShadow){let Z=P.shadow,et=e.get(P);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize=Z.mapSize,et.shadowCameraNear=Z.camera.near,et.shadowCameraFar=Z.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=Q,i.pointShadowMatrix[g]=P.shadow.matrix,S++}i.point[g]=Y,g++}else if(P.isHemisphereLight){let Y=t.get(P);Y.skyColor.copy(P.color).multiplyScalar(D),Y.groundColor.copy(P.groundColor).multiplyScalar(D),i.hemi[v]=Y,v++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=kt.LTC_FLOAT_1,i.rectAreaLTC2=kt.LTC_FLOAT_2):(i.rectAreaLTC1=kt.LTC_HALF_1,i.rectAreaLTC2=kt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let N=i.hash;(N.sunLength!==f||N.directionalLength!==m||N.pointLength!==g||N.spotLength!==_||N.rectAreaLength!==T||N.hemiLength!==v||N.numSunShadows!==p||N.numDirectionalShadows!==A||N.numPointShadows!==S||N.numSpotShadows!==y||N.numSpotMaps!==w||N.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=T,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,N.sunLength=f,N.directionalLength=m,N.pointLength=g,N.spotLength=_,N.rectAreaLength=T,N.hemiLength=v,N.numSunShadows=p,N.numDirectionalShadows=A,N.numPointShadows=S,N.numSpotShadows=y,N.numSpotMaps=w,N.numLightProbes=L,i.version=HC++)}function l(c,u){let h=0,d=0,f=0,p=0,x=0,m=0,g=u.matrixWorldInverse;for(let _=0,T=c.length;_<T;_++){let v=c[_];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(v.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Sy(n){let t=new VC(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function WC(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Sy(n),t.set(s,[a])):r>=o.length?(a=new Sy(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var $C=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,qC=`uniform sampler2D shadow_pass;
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
}`,XC=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],YC=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],wy=new _e,Dc=new G,Gm=new G;function jC(n,t,e){let i=new Do,s=new Qt,r=new Qt,o=new bn,a=new Th,l=new Ah,c={},u=e.maxTextureSize,h={[ir]:ri,[ri]:ir,[pi]:pi},d=new fi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Qt},radius:{value:4}},vertexShader:$C,fragmentShader:qC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ae;p.setAttribute("position",new ze(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new je(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ec;let g=this.type;this.render=function(S,y,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===vx&&(ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ec);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),H=n.state;H.setBlending(Fo),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let $=g!==this.type;$&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(z=>z.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,z=S.length;P<z;P++){let D=S[P],B=D.shadow;if(B===void 0){ie("WebGLShadowMap:",D,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let Q=B.getFrameExtents();s.multiply(Q),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Q.x),s.x=r.x*Q.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Q.y),s.y=r.y*Q.y,B.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Y,B.map===null||$===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===$a){if(D.isPointLight){ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new Qi(s.x,s.y,{format:oo,type:Is,minFilter:Ai,magFilter:Ai,generateMipmaps:!1}),B.map.texture.name=D.name+".shadowMap",B.map.depthTexture=new Cr(s.x,s.y,ds),B.map.depthTexture.name=D.name+".shadowMapDepth",B.map.depthTexture.format=Er,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=ti,B.map.depthTexture.magFilter=ti}else D.isPointLight?(B.map=new Uc(s.x),B.map.depthTexture=new mc(s.x,Ps)):(B.map=new Qi(s.x,s.y),B.map.depthTexture=new Cr(s.x,s.y,Ps)),B.map.depthTexture.name=D.name+".shadowMap",B.map.depthTexture.format=Er,this.type===Ec?(B.map.depthTexture.compareFunction=Y?Cm:Rm,B.map.depthTexture.minFilter=Ai,B.map.depthTexture.magFilter=Ai):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=ti,B.map.depthTexture.magFilter=ti);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let Z=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();D.isPointLight!==!0&&B.updateMatrices(D,w);let et=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:w.layers;for(let dt=0;dt<Z;dt++){let ft=B.getCamera(dt);if(D.isPointLight){let st=B.camera,yt=B.matrix,_t=D.distance||st.far;_t!==st.far&&(st.far=_t,st.updateProjectionMatrix()),Dc.setFromMatrixPosition(D.matrixWorld),st.position.copy(Dc),Gm.copy(st.position),Gm.add(XC[dt]),st.up.copy(YC[dt]),st.lookAt(Gm),st.updateMatrixWorld(),yt.makeTranslation(-Dc.x,-Dc.y,-Dc.z),wy.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),B._frustum.setFromProjectionMatrix(wy,st.coordinateSystem,st.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)n.setRenderTarget(B.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(B.map),n.clear());let st=B.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),H.viewport(o)}i=B.getFrustum(dt),v(y,w,ft,D,et,this.type)}B.isPointLightShadow!==!0&&this.type===$a&&_(B,w),B.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(U,L,N)};function _(S,y){let w=t.update(x);d.defines.VSM_SAMPLES!==S.blurSamples&&(d.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new Qi(s.x,s.y,{format:oo,type:Is}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),d.uniforms.shadow_pass.value=S.map.depthTexture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(y,null,w,d,x,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(y,null,w,f,x,null)}function T(S,y,w,U){let L=null,N=w.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(N!==void 0)L=N;else if(L=w.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let H=L.uuid,$=y.uuid,P=c[H];P===void 0&&(P={},c[H]=P);let z=P[$];z===void 0&&(z=L.clone(),P[$]=z,y.addEventListener("dispose",A)),L=z}if(L.visible=y.visible,L.wireframe=y.wireframe,U===$a?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let H=n.properties.get(L);H.light=w}return L}function v(S,y,w,U,L,N){if(S.visible===!1)return;if(S.layers.test(L)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&N===$a)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,S.matrixWorld);let P=t.update(S),z=S.material;if(Array.isArray(z)){let D=P.groups;for(let B=0,Q=D.length;B<Q;B++){let Y=D[B],Z=z[Y.materialIndex];if(Z&&Z.visible){let et=T(S,Z,U,N);S.onBeforeShadow(n,S,y,w,P,et,Y),n.renderBufferDirect(w,null,P,et,S,Y),S.onAfterShadow(n,S,y,w,P,et,Y)}}}else if(z.visible){let D=T(S,z,U,N);S.onBeforeShadow(n,S,y,w,P,D,null),n.renderBufferDirect(w,null,P,D,S,null),S.onAfterShadow(n,S,y,w,P,D,null)}}let $=S.children;for(let P=0,z=$.length;P<z;P++)v($[P],y,w,U,L,N)}function A(S){S.target.removeEventListener("dispose",A);for(let w in c){let U=c[w],L=S.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function ZC(n,t){function e(){let V=!1,lt=new bn,ot=null,Pt=new bn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!V&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){V=Mt},setClear:function(Mt,Rt,Zt,oe,pt){pt===!0&&(Mt*=oe,Rt*=oe,Zt*=oe),lt.set(Mt,Rt,Zt,oe),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,Zt,oe),Pt.copy(lt))},reset:function(){V=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let V=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let Zt=t.get("EXT_clip_control");Rt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let oe=Mt;Mt=null,this.setClear(oe)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!V&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=Qx[Rt]),Pt!==Rt){switch(Rt){case lh:n.depthFunc(n.NEVER);break;case ch:n.depthFunc(n.ALWAYS);break;case uh:n.depthFunc(n.LESS);break;case Da:n.depthFunc(n.LEQUAL);break;case hh:n.depthFunc(n.EQUAL);break;case dh:n.depthFunc(n.GEQUAL);break;case fh:n.depthFunc(n.GREATER);break;case ph:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){V=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){V=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,oe=null,pt=null;return{setTest:function($t){V||($t?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function($t){lt!==$t&&!V&&(n.stencilMask($t),lt=$t)},setFunc:function($t,ae,Dt){(ot!==$t||Pt!==ae||Mt!==Dt)&&(n.stencilFunc($t,ae,Dt),ot=$t,Pt=ae,Mt=Dt)},setOp:function($t,ae,Dt){(Rt!==$t||Zt!==ae||oe!==Dt)&&(n.stencilOp($t,ae,Dt),Rt=$t,Zt=ae,oe=Dt)},setLocked:function($t){V=$t},setClear:function($t){pt!==$t&&(n.clearStencil($t),pt=$t)},reset:function(){V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,oe=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,T=null,v=null,A=null,S=null,y=null,w=new ee(0,0,0),U=0,L=!1,N=null,H=null,$=null,P=null,z=null,D=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,Q=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(Y)[1]),B=Q>=1):Y.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),B=Q>=2);let Z=null,et={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new bn().fromArray(dt),yt=new bn().fromArray(ft);function _t(V,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(V,Rt),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<ot;Zt++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=_t(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=_t(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=_t(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=_t(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(Da),In(!1),Je(sm),At(n.CULL_FACE),_n(Fo);function At(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Jt(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function me(V,lt){return d[V]!==lt?(n.bindFramebuffer(V,lt),d[V]=lt,V===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),V===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function jt(V,lt){let ot=p,Pt=!1;if(V){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=V.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,Zt=Mt.length;Rt<Zt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function we(V){return x!==V?(n.useProgram(V),x=V,!0):!1}let ve={[Bo]:n.FUNC_ADD,[Mx]:n.FUNC_SUBTRACT,[Sx]:n.FUNC_REVERSE_SUBTRACT};ve[wx]=n.MIN,ve[Ex]=n.MAX;let fe={[Tx]:n.ZERO,[Ax]:n.ONE,[Rx]:n.SRC_COLOR,[lm]:n.SRC_ALPHA,[Nx]:n.SRC_ALPHA_SATURATE,[Lx]:n.DST_COLOR,[Px]:n.DST_ALPHA,[Cx]:n.ONE_MINUS_SRC_COLOR,[cm]:n.ONE_MINUS_SRC_ALPHA,[Dx]:n.ONE_MINUS_DST_COLOR,[Ix]:n.ONE_MINUS_DST_ALPHA,[Ux]:n.CONSTANT_COLOR,[Ox]:n.ONE_MINUS_CONSTANT_COLOR,[Fx]:n.CONSTANT_ALPHA,[Bx]:n.ONE_MINUS_CONSTANT_ALPHA};function _n(V,lt,ot,Pt,Mt,Rt,Zt,oe,pt,$t){if(V===Fo){m===!0&&(Jt(n.BLEND),m=!1);return}if(m===!1&&(At(n.BLEND),m=!0),V!==bx){if(V!==g||$t!==L){if((_!==Bo||A!==Bo)&&(n.blendEquation(n.FUNC_ADD),_=Bo,A=Bo),$t)switch(V){case qa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case rm:n.blendFunc(n.ONE,n.ONE);break;case om:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case am:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:le("WebGLState: Invalid blending: ",V);break}else switch(V){case qa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case rm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case om:le("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case am:le("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:le("WebGLState: Invalid blending: ",V);break}T=null,v=null,S=null,y=null,w.set(0,0,0),U=0,g=V,L=$t}return}Mt=Mt||lt,Rt=Rt||ot,Zt=Zt||Pt,(lt!==_||Mt!==A)&&(n.blendEquationSeparate(ve[lt],ve[Mt]),_=lt,A=Mt),(ot!==T||Pt!==v||Rt!==S||Zt!==y)&&(n.blendFuncSeparate(fe[ot],fe[Pt],fe[Rt],fe[Zt]),T=ot,v=Pt,S=Rt,y=Zt),(oe.equals(w)===!1||pt!==U)&&(n.blendColor(oe.r,oe.g,oe.b,pt),w.copy(oe),U=pt),g=V,L=!1}function rn(V,lt){V.side===pi?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=V.side===ri;lt&&(ot=!ot),In(ot),V.blending===qa&&V.transparent===!1?_n(Fo):_n(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Pt=V.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Ue(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function In(V){N!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),N=V)}function Je(V){V!==xx?(At(n.CULL_FACE),V!==H&&(V===sm?n.cullFace(n.BACK):V===yx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),H=V}function Yn(V){V!==$&&(B&&n.lineWidth(V),$=V)}function Ue(V,lt,ot){V?(At(n.POLYGON_OFFSET_FILL),(P!==lt||z!==ot)&&(P=lt,z=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Jt(n.POLYGON_OFFSET_FILL)}function kn(V){V?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function Sn(V){V===void 0&&(V=n.TEXTURE0+D-1),Z!==V&&(n.activeTexture(V),Z=V)}function Ln(V,lt,ot){ot===void 0&&(Z===null?ot=n.TEXTURE0+D-1:ot=Z);let Pt=et[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},et[ot]=Pt),(Pt.type!==V||Pt.texture!==lt)&&(Z!==ot&&(n.activeTexture(ot),Z=ot),n.bindTexture(V,lt||Tt[V]),Pt.type=V,Pt.texture=lt)}function W(){let V=et[Z];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function se(){try{n.compressedTexImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function ge(){try{n.texSubImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function Qe(){try{n.compressedTexSubImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function ne(){try{n.texStorage2D(...arguments)}catch(V){le("WebGLState:",V)}}function O(){try{n.texStorage3D(...arguments)}catch(V){le("WebGLState:",V)}}function R(){try{n.texImage2D(...arguments)}catch(V){le("WebGLState:",V)}}function j(){try{n.texImage3D(...arguments)}catch(V){le("WebGLState:",V)}}function mt(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function ct(V,lt){h[V]!==lt&&(n.pixelStorei(V,lt),h[V]=lt)}function St(V){st.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),st.copy(V))}function wt(V){yt.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),yt.copy(V))}function rt(V,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Pt=ot.get(V);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,V.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(V,Pt))}function at(V,lt,ot){let Mt=c.get(lt).get(V);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Z=null,et={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,T=null,v=null,A=null,S=null,y=null,w=new ee(0,0,0),U=0,L=!1,N=null,H=null,$=null,P=null,z=null,st.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:me,drawBuffers:jt,useProgram:we,setBlending:_n,setMaterial:rn,setFlipSided:In,setCullFace:Je,setLineWidth:Yn,setPolygonOffset:Ue,setScissorTest:kn,activeTexture:Sn,bindTexture:Ln,unbindTexture:W,compressedTexImage2D:Nt,compressedTexImage3D:se,texImage2D:R,texImage3D:j,pixelStorei:ct,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:ne,texStorage3D:O,texSubImage2D:ge,texSubImage3D:Ct,compressedTexSubImage2D:Qe,compressedTexSubImage3D:Yt,scissor:St,viewport:wt,reset:vt}}function JC(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Qt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(O=>p.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(O,R){return m?new OffscreenCanvas(O,R):rc("canvas")}function _(O,R,j){let mt=1,ct=ne(O);if((ct.width>j||ct.height>j)&&(mt=j/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let St=Math.floor(mt*ct.width),wt=Math.floor(mt*ct.height);d===void 0&&(d=g(St,wt));let rt=R?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(O,0,0,St,wt),ie("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+St+"x"+wt+")."),rt}else return"data"in O&&ie("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),O;return O}function T(O){return O.generateMipmaps}function v(O){n.generateMipmap(O)}function A(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(O,R,j,mt,ct,St=!1){if(O!==null){if(n[O]!==void 0)return n[O];ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let wt;mt&&(wt=t.get("EXT_texture_norm16"),wt||ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(j===n.FLOAT&&(rt=n.R32F),j===n.HALF_FLOAT&&(rt=n.R16F),j===n.UNSIGNED_BYTE&&(rt=n.R8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),j===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.R8UI),j===n.UNSIGNED_SHORT&&(rt=n.R16UI),j===n.UNSIGNED_INT&&(rt=n.R32UI),j===n.BYTE&&(rt=n.R8I),j===n.SHORT&&(rt=n.R16I),j===n.INT&&(rt=n.R32I)),R===n.RG&&(j===n.FLOAT&&(rt=n.RG32F),j===n.HALF_FLOAT&&(rt=n.RG16F),j===n.UNSIGNED_BYTE&&(rt=n.RG8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),j===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RG8UI),j===n.UNSIGNED_SHORT&&(rt=n.RG16UI),j===n.UNSIGNED_INT&&(rt=n.RG32UI),j===n.BYTE&&(rt=n.RG8I),j===n.SHORT&&(rt=n.RG16I),j===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),j===n.UNSIGNED_INT&&(rt=n.RGB32UI),j===n.BYTE&&(rt=n.RGB8I),j===n.SHORT&&(rt=n.RGB16I),j===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),j===n.UNSIGNED_INT&&(rt=n.RGBA32UI),j===n.BYTE&&(rt=n.RGBA8I),j===n.SHORT&&(rt=n.RGBA16I),j===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),j===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=St?ic:De.getTransfer(ct);j===n.FLOAT&&(rt=n.RGBA32F),j===n.HALF_FLOAT&&(rt=n.RGBA16F),j===n.UNSIGNED_BYTE&&(rt=at===We?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),j===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function y(O,R){let j;return O?R===null||R===Ps||R===zo?j=n.DEPTH24_STENCIL8:R===ds?j=n.DEPTH32F_STENCIL8:R===Ya&&(j=n.DEPTH24_STENCIL8,ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Ps||R===zo?j=n.DEPTH_COMPONENT24:R===ds?j=n.DEPTH_COMPONENT32F:R===Ya&&(j=n.DEPTH_COMPONENT16),j}function w(O,R){return T(O)===!0||O.isFramebufferTexture&&O.minFilter!==ti&&O.minFilter!==Ai?Math.log2(Math.max(R.width,R.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?R.mipmaps.length:1}function U(O){let R=new WeakRef(O);i.get(O).__ref=R,p.add(R),x.register(O,R,R)}function L(O){let R=i.get(O).__ref;R!==void 0&&(p.delete(R),x.unregister(R))}function N(O){$(O.target)}function H(O){P(O.target)}function $(O){O.removeEventListener("dispose",N),L(O),D(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function P(O){O.removeEventListener("dispose",H),L(O),Q(O)}function z(){for(let O of p){let R=O.deref();R!==void 0&&(R.isRenderTarget===!0?P(R):$(R))}p.clear(),h.clear()}function D(O){let R=i.get(O);if(R.__webglInit===void 0)return;let j=O.source,mt=f.get(j);if(mt){let ct=mt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&B(O),Object.keys(mt).length===0&&f.delete(j)}i.remove(O)}function B(O){let R=i.get(O);n.deleteTexture(R.__webglTexture);let j=O.source,mt=f.get(j);delete mt[R.__cacheKey],o.memory.textures--}function Q(O){let R=i.get(O);R.__depthDisposeCallback&&R.__depthDisposeCallback();let j=O.depthTexture;if(j&&j.renderTarget===O&&$(j),O.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let St=0;St<R.__webglFramebuffer[ct].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[ct][St]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=O.textures;for(let ct=0,St=mt.length;ct<St;ct++){let wt=i.get(mt[ct]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(mt[ct])}i.remove(O)}let Y=0;function Z(){Y=0}function et(){return Y}function dt(O){Y=O}function ft(){let O=Y;return O>=s.maxTextures&&ie("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,O}function st(O){let R=[];return R.push(O.wrapS),R.push(O.wrapT),R.push(O.wrapR||0),R.push(O.magFilter),R.push(O.minFilter),R.push(O.anisotropy),R.push(O.internalFormat),R.push(O.format),R.push(O.type),R.push(O.generateMipmaps),R.push(O.mipmapsAutoUpdate),R.push(O.premultiplyAlpha),R.push(O.flipY),R.push(O.unpackAlignment),R.push(O.colorSpace),R.join()}function yt(O,R){let j=i.get(O);if(O.isVideoTexture&&Qe(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&j.__version!==O.version){let mt=O.image;if(mt===null)ie("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ie("WebGLRenderer: Texture marked for update but image is incomplete");else{rn(j,O,R);return}}else O.isExternalTexture&&(j.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+R)}function _t(O,R){let j=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&j.__version!==O.version){rn(j,O,R);return}else O.isExternalTexture&&(j.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+R)}function Tt(O,R){let j=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&j.__version!==O.version){rn(j,O,R);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+R)}function At(O,R){let j=i.get(O);if(O.version>0&&j.__version!==O.version){In(j,O,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+R)}let Jt={[mh]:n.REPEAT,[Qs]:n.CLAMP_TO_EDGE,[gh]:n.MIRRORED_REPEAT},me={[ti]:n.NEAREST,[Hx]:n.NEAREST_MIPMAP_NEAREST,[Tc]:n.NEAREST_MIPMAP_LINEAR,[Ai]:n.LINEAR,[Gh]:n.LINEAR_MIPMAP_NEAREST,[Pr]:n.LINEAR_MIPMAP_LINEAR},jt={[$x]:n.NEVER,[Pm]:n.ALWAYS,[qx]:n.LESS,[Rm]:n.LEQUAL,[Xx]:n.EQUAL,[Cm]:n.GEQUAL,[Yx]:n.GREATER,[jx]:n.NOTEQUAL};function we(O,R){if(R.type===ds&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Ai||R.magFilter===Gh||R.magFilter===Tc||R.magFilter===Pr||R.minFilter===Ai||R.minFilter===Gh||R.minFilter===Tc||R.minFilter===Pr)&&ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Jt[R.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Jt[R.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Jt[R.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,me[R.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,me[R.minFilter]),R.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,jt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===ti||R.minFilter!==Tc&&R.minFilter!==Pr||R.type===ds&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(O,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ve(O,R){let j=!1;O.__webglInit===void 0&&(O.__webglInit=!0,R.addEventListener("dispose",N),U(R));let mt=R.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let St=st(R);if(St!==O.__cacheKey){ct[St]===void 0&&(ct[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),ct[St].usedTimes++;let wt=ct[O.__cacheKey];wt!==void 0&&(ct[O.__cacheKey].usedTimes--,wt.usedTimes===0&&B(R)),O.__cacheKey=St,O.__webglTexture=ct[St].texture}return j}function fe(O,R,j){return Math.floor(Math.floor(O/j)/R)}function _n(O,R,j,mt){let St=O.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,j,mt,R.data);else{St.sort((V,lt)=>V.start-lt.start);let wt=0;for(let V=1;V<St.length;V++){let lt=St[wt],ot=St[V],Pt=lt.start+lt.count,Mt=fe(ot.start,R.width,4),Rt=fe(lt.start,R.width,4);ot.start<=Pt+1&&Mt===Rt&&fe(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let V=0,lt=St.length;V<lt;V++){let ot=St[V],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%R.width,Zt=Math.floor(Pt/R.width),oe=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,Zt,oe,pt,j,mt,R.data)}O.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function rn(O,R,j){let mt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=n.TEXTURE_3D);let ct=ve(O,R),St=R.source;e.bindTexture(mt,O.__webglTexture,n.TEXTURE0+j);let wt=i.get(St);if(St.version!==wt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=De.getPrimaries(De.workingColorSpace),$t=R.colorSpace===Lr?null:De.getPrimaries(R.colorSpace),ae=R.colorSpace===Lr||pt===$t?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=_(R.image,!1,s.maxTextureSize);at=Yt(R,at);let vt=r.convert(R.format,R.colorSpace),V=r.convert(R.type),lt=S(R.internalFormat,vt,V,R.normalized,R.colorSpace,R.isVideoTexture);we(mt,R);let ot,Pt=R.mipmaps,Mt=R.isVideoTexture!==!0,Rt=wt.__version===void 0||ct===!0,Zt=St.dataReady,oe=w(R,at);if(R.isDepthTexture)lt=y(R.format===Ir,R.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,V,null));else if(R.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,V,ot.data);R.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height),Zt&&_n(R,at,vt,V)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,V,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,$t=Pt.length;pt<$t;pt++)if(ot=Pt[pt],R.format!==Ls)if(vt!==null)if(Mt){if(Zt)if(R.layerUpdates.size>0){let ae=zm(ot.width,ot.height,R.format,R.type);for(let Dt of R.layerUpdates){let ye=ot.data.subarray(Dt*ae/ot.data.BYTES_PER_ELEMENT,(Dt+1)*ae/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,vt,ye)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,V,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,vt,V,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],R.format!==Ls?vt!==null?Mt?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,V,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,at.width,at.height,at.depth),Zt)if(R.layerUpdates.size>0){let pt=zm(at.width,at.height,R.format,R.type);for(let $t of R.layerUpdates){let ae=at.data.subarray($t*pt/at.data.BYTES_PER_ELEMENT,($t+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,$t,at.width,at.height,1,vt,V,ae)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,V,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,vt,V,at.data);else if(R.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,oe,lt,at.width,at.height,at.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,V,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,vt,V,at.data);else if(R.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height);else{let pt=at.width,$t=at.height;for(let ae=0;ae<oe;ae++)e.texImage2D(n.TEXTURE_2D,ae,lt,pt,$t,0,vt,V,null),pt>>=1,$t>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=$t=>{let ae=$t.changedElements;for(let Dt of h)ae.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ae=n.RGBA,Dt=n.RGBA,ye=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ae,Dt,ye,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=ne(Pt[0]);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,vt,V,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,vt,V,ot);R.generateMipmaps=!1}else if(Mt){if(Rt){let pt=ne(at);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,V,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,vt,V,at);T(R)&&R.mipmapsAutoUpdate===!0&&v(mt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function In(O,R,j){if(R.image.length!==6)return;let mt=ve(O,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+j);let St=i.get(ct);if(ct.version!==St.__version||mt===!0){e.activeTexture(n.TEXTURE0+j);let wt=De.getPrimaries(De.workingColorSpace),rt=R.colorSpace===Lr?null:De.getPrimaries(R.colorSpace),at=R.colorSpace===Lr||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=R.isCompressedTexture||R.image[0].isCompressedTexture,V=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!vt&&!V?lt[Dt]=_(R.image[Dt],!0,s.maxCubemapSize):lt[Dt]=V?R.image[Dt].image:R.image[Dt],lt[Dt]=Yt(R,lt[Dt]);let ot=lt[0],Pt=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Rt=S(R.internalFormat,Pt,Mt,R.normalized,R.colorSpace),Zt=R.isVideoTexture!==!0,oe=St.__version===void 0||mt===!0,pt=ct.dataReady,$t=w(R,ot);we(n.TEXTURE_CUBE_MAP,R);let ae;if(R.isDepthTexture){if(Rt=y(R.format===Ir,R.type),oe)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(vt){Zt&&oe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){ae=lt[Dt].mipmaps;for(let ye=0;ye<ae.length;ye++){let on=ae[ye];R.format!==Ls?Pt!==null?Zt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,0,0,on.width,on.height,Pt,on.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,Rt,on.width,on.height,0,on.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,0,0,on.width,on.height,Pt,Mt,on.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye,Rt,on.width,on.height,0,Pt,Mt,on.data)}}}else{if(ae=R.mipmaps,Zt&&oe){ae.length>0&&$t++;let Dt=ne(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(V){Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let ye=0;ye<ae.length;ye++){let xi=ae[ye].image[Dt].image;Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,0,0,xi.width,xi.height,Pt,Mt,xi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,Rt,xi.width,xi.height,0,Pt,Mt,xi.data)}}else{Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let ye=0;ye<ae.length;ye++){let on=ae[ye];Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,0,0,Pt,Mt,on.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ye+1,Rt,Pt,Mt,on.image[Dt])}}}T(R)&&R.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),St.__version=ct.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function Je(O,R,j,mt,ct,St){let wt=r.convert(j.format,j.colorSpace),rt=r.convert(j.type),at=S(j.internalFormat,wt,rt,j.normalized,j.colorSpace),vt=i.get(R),V=i.get(j);if(V.__renderTarget=R,!vt.__hasExternalTextures){let lt=Math.max(1,R.width>>St),ot=Math.max(1,R.height>>St);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,St,at,lt,ot,R.depth,0,wt,rt,null):e.texImage2D(ct,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,O),Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ct,V.__webglTexture,0,ge(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ct,V.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Yn(O,R,j){if(n.bindRenderbuffer(n.RENDERBUFFER,O),R.depthBuffer){let mt=R.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,St=y(R.stencilBuffer,ct),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ge(R),St,R.width,R.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,ge(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,O)}else{let mt=R.textures;for(let ct=0;ct<mt.length;ct++){let St=mt[ct],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=S(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ge(R),at,R.width,R.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,ge(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ue(O,R,j){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,O),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let St=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),mt?At(R.depthTexture,0):yt(R.depthTexture,0);let wt=ct.__webglTexture,rt=ge(R),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,vt=R.depthTexture.format===Ir?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===Er)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else if(R.depthTexture.format===Ir)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function kn(O){let R=i.get(O),j=O.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==O.depthTexture){let mt=O.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=mt}if(O.depthTexture&&!R.__autoAllocateDepthBuffer)if(j)for(let mt=0;mt<6;mt++)Ue(R.__webglFramebuffer[mt],O,mt);else O.texture.mipmaps.length>0?Ue(R.__webglFramebuffer[0],O,0):Ue(R.__webglFramebuffer,O,0);else if(j){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=n.createRenderbuffer(),Yn(R.__webglDepthbuffer[mt],O,!1);else{let ct=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}}else if(O.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),Yn(R.__webglDepthbuffer,O,!1);else{let ct=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Sn(O,R,j){let mt=i.get(O);R!==void 0&&Je(mt.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&kn(O)}function Ln(O){let R=O.texture,j=i.get(O),mt=i.get(R);O.addEventListener("dispose",H),U(O);let ct=O.textures,St=O.isWebGLCubeRenderTarget===!0,wt=ct.length>1;if(wt||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=R.version,o.memory.textures++),St){j.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){j.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)j.__webglFramebuffer[rt][at]=n.createFramebuffer()}else j.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){j.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)j.__webglFramebuffer[rt]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ct.length;rt<at;rt++){let vt=i.get(ct[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&Ct(O)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];j.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),V=r.convert(at.type),lt=S(at.internalFormat,vt,V,at.normalized,at.colorSpace,O.isXRRenderTarget===!0),ot=ge(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,j.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),Yn(j.__webglDepthRenderbuffer,O,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),we(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Je(j.__webglFramebuffer[rt][at],O,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Je(j.__webglFramebuffer[rt],O,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);T(R)?v(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ct.length;rt<at;rt++){let vt=ct[rt],V=i.get(vt),lt=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(lt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,V.__webglTexture),we(lt,vt),Je(j.__webglFramebuffer,O,vt,n.COLOR_ATTACHMENT0+rt,lt,0),T(vt)&&v(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(rt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),we(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Je(j.__webglFramebuffer[at],O,R,n.COLOR_ATTACHMENT0,rt,at);else Je(j.__webglFramebuffer,O,R,n.COLOR_ATTACHMENT0,rt,0);T(R)?v(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}O.depthBuffer&&kn(O)}function W(O){let R=O.textures;for(let j=0,mt=R.length;j<mt;j++){let ct=R[j];if(T(ct)&&ct.mipmapsAutoUpdate===!0){let St=A(O),wt=i.get(ct).__webglTexture;e.bindTexture(St,wt),v(St),e.unbindTexture()}}}let Nt=[];function se(O){if(O.samples>0){if(Ct(O)===!1){let R=O.textures,j=O.width,mt=O.height,ct=n.COLOR_BUFFER_BIT,St=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(O),rt=R.length>1;if(rt)for(let vt=0;vt<R.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let vt=0;vt<R.length;vt++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let V=i.get(R[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,j,mt,0,0,j,mt,ct,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+vt),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<R.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let V=i.get(R[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,V,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let R=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function ge(O){return Math.min(s.maxSamples,O.samples)}function Ct(O){let R=i.get(O);return O.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Qe(O){let R=o.render.frame;u.get(O)!==R&&(u.set(O,R),O.update())}function Yt(O,R){let j=O.colorSpace,mt=O.format,ct=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||j!==nc&&j!==Lr&&(De.getTransfer(j)===We?(mt!==Ls||ct!==ns)&&ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):le("WebGLTextures: Unsupported texture color space:",j)),R}function ne(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=Z,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=yt,this.setTexture2DArray=_t,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=Sn,this.setupRenderTarget=Ln,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=se,this.setupDepthRenderbuffer=kn,this.setupFrameBufferTexture=Je,this.useMultisampledRTT=Ct,this.dispose=z}function KC(n,t){function e(i,s=Lr){let r,o=De.getTransfer(s);if(i===ns)return n.UNSIGNED_BYTE;if(i===Wh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===$h)return n.UNSIGNED_SHORT_5_5_5_1;if(i===bm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Mm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===ym)return n.BYTE;if(i===vm)return n.SHORT;if(i===Ya)return n.UNSIGNED_SHORT;if(i===Vh)return n.INT;if(i===Ps)return n.UNSIGNED_INT;if(i===ds)return n.FLOAT;if(i===Is)return n.HALF_FLOAT;if(i===Sm)return n.ALPHA;if(i===wm)return n.RGB;if(i===Ls)return n.RGBA;if(i===Er)return n.DEPTH_COMPONENT;if(i===Ir)return n.DEPTH_STENCIL;if(i===qh)return n.RED;if(i===Xh)return n.RED_INTEGER;if(i===oo)return n.RG;if(i===Yh)return n.RG_INTEGER;if(i===jh)return n.RGBA_INTEGER;if(i===Ac||i===Rc||i===Cc||i===Pc)if(o===We)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ac)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Rc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Cc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Pc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ac)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Rc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Cc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Pc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zh||i===Jh||i===Kh||i===Qh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Jh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Kh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Qh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===td||i===ed||i===nd||i===id||i===sd||i===Ic||i===rd)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===td||i===ed)return o===We?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===nd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===id)return r.COMPRESSED_R11_EAC;if(i===sd)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ic)return r.COMPRESSED_RG11_EAC;if(i===rd)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===od||i===ad||i===ld||i===cd||i===ud||i===hd||i===dd||i===fd||i===pd||i===md||i===gd||i===_d||i===xd||i===yd)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===od)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ad)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ld)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===cd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ud)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===hd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===dd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===fd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===pd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===md)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===gd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===_d)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===xd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===yd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===vd||i===bd||i===Md)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===vd)return o===We?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===bd)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Md)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Sd||i===wd||i===Lc||i===Ed)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Sd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===wd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Lc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ed)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===zo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var QC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,tP=`
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

}`,jm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new gc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new fi({vertexShader:QC,fragmentShader:tP,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new je(new vc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zm=class extends Rs{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new jm,g={},_=e.getContextAttributes(),T=null,v=null,A=[],S=[],y=new Qt,w=null,U=null,L=new Ti;L.viewport=new bn;let N=new Ti;N.viewport=new bn;let H=[L,N],$=new kh,P=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let yt=A[st];return yt===void 0&&(yt=new Ba,A[st]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(st){let yt=A[st];return yt===void 0&&(yt=new Ba,A[st]=yt),yt.getGripSpace()},this.getHand=function(st){let yt=A[st];return yt===void 0&&(yt=new Ba,A[st]=yt),yt.getHandSpace()};function D(st){let yt=S.indexOf(st.inputSource);if(yt===-1)return;let _t=A[yt];_t!==void 0&&(_t.update(st.inputSource,st.frame,c||o),_t.dispatchEvent({type:st.type,data:st.inputSource}))}function B(){s.removeEventListener("select",D),s.removeEventListener("selectstart",D),s.removeEventListener("selectend",D),s.removeEventListener("squeeze",D),s.removeEventListener("squeezestart",D),s.removeEventListener("squeezeend",D),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",Q);for(let st=0;st<A.length;st++){let yt=S[st];yt!==null&&(S[st]=null,A[st].disconnect(yt))}P=null,z=null,m.reset();for(let st in g)delete g[st];if(t.setRenderTarget(T),f=null,d=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),U!==null){let st=U.camera;st.fov=U.fov,st.zoom=U.zoom,st.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",D),s.addEventListener("selectstart",D),s.addEventListener("selectend",D),s.addEventListener("squeeze",D),s.addEventListener("squeezestart",D),s.addEventListener("squeezeend",D),s.addEventListener("end",B),s.addEventListener("inputsourceschange",Q),_.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,Tt=null,At=null;_.depth&&(At=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=_.stencil?Ir:Er,Tt=_.stencil?zo:Ps);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new Qi(d.textureWidth,d.textureHeight,{format:Ls,type:ns,depthTexture:new Cr(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _t={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Qi(f.framebufferWidth,f.framebufferHeight,{format:Ls,type:ns,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q(st){for(let yt=0;yt<st.removed.length;yt++){let _t=st.removed[yt],Tt=S.indexOf(_t);Tt>=0&&(S[Tt]=null,A[Tt].disconnect(_t))}for(let yt=0;yt<st.added.length;yt++){let _t=st.added[yt],Tt=S.indexOf(_t);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=S.length){S.push(_t),Tt=Jt;break}else if(S[Jt]===null){S[Jt]=_t,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(_t)}}function Y(st,yt){yt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(yt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let yt=st.near,_t=st.far;m.texture!==null&&(m.depthNear>0&&(yt=m.depthNear),m.depthFar>0&&(_t=m.depthFar)),$.near=N.near=L.near=yt,$.far=N.far=L.far=_t,(P!==$.near||z!==$.far)&&(s.updateRenderState({depthNear:$.near,depthFar:$.far}),P=$.near,z=$.far),$.layers.mask=st.layers.mask|6,L.layers.mask=$.layers.mask&-5,N.layers.mask=$.layers.mask&-3;let Tt=st.parent,At=$.cameras;Y($,Tt);for(let Jt=0;Jt<At.length;Jt++)Y(At[Jt],Tt);$.projectionMatrix.copy(L.projectionMatrix),$.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&st.isPerspectiveCamera&&(U={camera:st,fov:st.fov,zoom:st.zoom}),Z(st,$,Tt)};function Z(st,yt,_t){_t===null?st.matrix.copy(yt.matrixWorld):(st.matrix.copy(_t.matrixWorld),st.matrix.invert(),st.matrix.multiply(yt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(yt.projectionMatrix),st.projectionMatrixInverse.copy(yt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Ua*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return $},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh($)},this.getCameraTexture=function(st){return g[st]};let et=null;function dt(st,yt){if(u=yt.getViewerPose(c||o),p=yt,u!==null){let _t=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Tt=!1;_t.length!==$.cameras.length&&($.cameras.length=0,Tt=!0);for(let jt=0;jt<_t.length;jt++){let we=_t[jt],ve=null;if(f!==null)ve=f.getViewport(we);else{let _n=h.getViewSubImage(d,we);ve=_n.viewport,jt===0&&(t.setRenderTargetTextures(v,_n.colorTexture,_n.depthStencilTexture),t.setRenderTarget(v))}let fe=H[jt];fe===void 0&&(fe=new Ti,fe.layers.enable(jt),fe.viewport=new bn,H[jt]=fe),fe.matrix.fromArray(we.transform.matrix),fe.matrix.decompose(fe.position,fe.quaternion,fe.scale),fe.projectionMatrix.fromArray(we.projectionMatrix),fe.projectionMatrixInverse.copy(fe.projectionMatrix).invert(),fe.viewport.set(ve.x,ve.y,ve.width,ve.height),jt===0&&($.matrix.copy(fe.matrix),$.matrix.decompose($.position,$.quaternion,$.scale)),Tt===!0&&$.cameras.push(fe)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let jt=h.getDepthInformation(_t[0]);jt&&jt.isValid&&jt.texture&&m.init(jt,s.renderState)}if(At&&At.includes("camera-access")&&x){t.state.unbindTexture(),h=i.getBinding();for(let jt=0;jt<_t.length;jt++){let we=_t[jt].camera;if(we){let ve=g[we];ve||(ve=new gc,g[we]=ve);let fe=h.getCameraImage(we);ve.sourceTexture=fe}}}}for(let _t=0;_t<A.length;_t++){let Tt=S[_t],At=A[_t];Tt!==null&&At!==void 0&&At.update(Tt,yt,c||o)}et&&et(st,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),p=null}let ft=new Ey;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){et=st},this.dispose=function(){}}},eP=new _e,Uy=new ue;Uy.set(-1,0,0,0,1,0,0,0,1);function nP(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Fm(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,T,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,T):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ri&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ri&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=t.get(g),T=_.envMap,v=_.envMapRotation;T&&(m.envMap.value=T,m.envMapRotation.value.setFromMatrix4(eP.makeRotationFromEuler(v)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Uy),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,T){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=T*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ri&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let _=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function iP(n,t,e,i){let s={},r={};function o(_,T){let v=T.program;i.uniformBlockBinding(_,v,s[_.id])}function a(_,T){let v=s[_.id];v===void 0&&(p(_),v=l(_),s[_.id]=v,_.addEventListener("dispose",m));let A=T.program;i.updateUBOMapping(_,A);let S=t.render.frame;r[_.id]!==S&&(c(_),r[_.id]=S)}function l(_){let T=n.createBuffer(),v=_.__size,A=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(_){let T=s[_.id],v=_.uniforms,A=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let S=0,y=v.length;S<y;S++){let w=v[S];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],S,U,A);else u(w,S,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,T,v,A){if(d(_,T,v,A)===!0){let S=_.__offset,y=_.value;if(Array.isArray(y)){let w=0;for(let U=0;U<y.length;U++){let L=y[U],N=x(L,!0);h(L,_.__data,w),w+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,_.__data)}}function h(_,T,v){typeof _=="number"||typeof _=="boolean"?T[v]=_:_.isMatrix3?(T[v]=_.elements[0],T[v+1]=_.elements[1],T[v+2]=_.elements[2],T[v+3]=0,T[v+4]=_.elements[3],T[v+5]=_.elements[4],T[v+6]=_.elements[5],T[v+7]=0,T[v+8]=_.elements[6],T[v+9]=_.elements[7],T[v+10]=_.elements[8],T[v+11]=0):ArrayBuffer.isView(_)?T.set(_.subarray(0,T.length-v),v):_.toArray(T,v)}function d(_,T,v,A){let S=_.value,y=T+"_"+v;if(Array.isArray(S)){A[y]===void 0&&(A[y]=[]);let w=A[y],U=!1;for(let L=0;L<S.length;L++)f(S[L],w,L)===!0&&(U=!0);return U}return f(S,A,y)}function f(_,T,v){if(T[v]===void 0)return typeof _=="number"||typeof _=="boolean"?T[v]=_:ArrayBuffer.isView(_)?T[v]=_.slice():T[v]=_.clone(),!0;{let A=T[v];if(typeof _=="number"||typeof _=="boolean"){if(A!==_)return T[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(A.equals(_)===!1)return A.copy(_),!0}}return!1}function p(_){let T=_.uniforms,v=0,A=16;for(let y=0,w=T.length;y<w;y++){let U=Array.isArray(T[y])?T[y]:[T[y]];for(let L=0,N=U.length;L<N;L++){let H=U[L],$=Array.isArray(H.value)?H.value:[H.value],P=Array.isArray(T[y])||Array.isArray(H.value),z=v;for(let B=0,Q=$.length;B<Q;B++){let Y=$[B],Z=x(Y,P),et=v%A,dt=et%Z.boundary,ft=et+dt;v+=dt,ft!==0&&A-ft<Z.storage&&(v+=A-ft),B===0&&(z=v),v+=Z.storage}let D=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new D((v-z)/Float32Array.BYTES_PER_ELEMENT),H.__offset=z}}let S=v%A;return S>0&&(v+=A-S),_.__size=v,_.__cache={},this}function x(_,T){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):ie("WebGLRenderer: Unsupported uniform value type.",_),T===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(_){let T=_.target;T.removeEventListener("dispose",m),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function g(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var sP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),rr=null;function rP(){return rr===null&&(rr=new dc(sP,16,16,oo,Is),rr.name="DFG_LUT",rr.minFilter=Ai,rr.magFilter=Ai,rr.wrapS=Qs,rr.wrapT=Qs,rr.generateMipmaps=!1,rr.needsUpdate=!0),rr}var Id=class{constructor(t={}){let{canvas:e=Zx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ns}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,m=new Set([jh,Yh,Xh]),g=new Set([ns,Ps,Ya,zo,Wh,$h]),_=new Uint32Array(4),T=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,S=null,y=[],w=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=sr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,H=null,$=null,P=null,z=null;this._outputColorSpace=Ei;let D=0,B=0,Q=null,Y=-1,Z=null,et=new bn,dt=new bn,ft=null,st=new ee(0),yt=0,_t=e.width,Tt=e.height,At=1,Jt=null,me=null,jt=new bn(0,0,_t,Tt),we=new bn(0,0,_t,Tt),ve=!1,fe=new Do,_n=new bh,rn=!1,In=!1,Je=new _e,Yn=new G,Ue=new bn,kn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Sn=!1;function Ln(){return Q===null?At:1}let W=i;function Nt(I,q){return e.getContext(I,q)}let se,ge,Ct,Qe,Yt,ne,O,R,j,mt,ct,St,wt,rt,at,vt,V,lt,ot,Pt,Mt,Rt,Zt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",$t,!1),e.addEventListener("webglcontextrestored",ae,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),W===null){let q="webgl2";if(W=Nt(q,I),W===null)throw Nt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}oe()}catch(I){throw e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),le("WebGLRenderer: "+I.message),I}function oe(){se=new gR(W),se.init(),Mt=new KC(W,se),ge=new rR(W,se,t,Mt),Ct=new ZC(W,se),ge.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),$=W.createFramebuffer(),P=W.createFramebuffer(),z=W.createFramebuffer(),Qe=new yR(W),Yt=new OC,ne=new JC(W,se,Ct,Yt,ge,Mt,Qe),O=new mR(L),R=new bE(W),Rt=new iR(W,R),j=new _R(W,R,Qe,Rt),mt=new bR(W,j,R,Rt,Qe),lt=new vR(W,ge,ne),at=new oR(Yt),ct=new UC(L,O,se,ge,Rt,at),St=new nP(L,Yt),wt=new BC,rt=new WC(se),V=new nR(L,O,Ct,mt,p,l),vt=new jC(L,mt,ge),Zt=new iP(W,Qe,ge,Ct),ot=new sR(W,se,Qe),Pt=new xR(W,se,Qe),Qe.programs=ct.programs,L.capabilities=ge,L.extensions=se,L.properties=Yt,L.renderLists=wt,L.shadowMap=vt,L.state=Ct,L.info=Qe}x!==ns&&(U=new SR(x,e.width,e.height,a,s,r));let pt=new Zm(L,W);this.xr=pt,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let I=se.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=se.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(_t,Tt,!1))},this.getSize=function(I){return I.set(_t,Tt)},this.setSize=function(I,q,it=!0){if(pt.isPresenting){ie("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=I,Tt=q,e.width=Math.floor(I*At),e.height=Math.floor(q*At),it===!0&&(e.style.width=I+"px",e.style.height=q+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,I,q)},this.getDrawingBufferSize=function(I){return I.set(_t*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,q,it){_t=I,Tt=q,At=it,e.width=Math.floor(I*it),e.height=Math.floor(q*it),this.setViewport(0,0,I,q)},this.setEffects=function(I){if(x===ns){le("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let q=0;q<I.length;q++)if(I[q].isOutputPass===!0){ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(et)},this.getViewport=function(I){return I.copy(jt)},this.setViewport=function(I,q,it,J){I.isVector4?jt.set(I.x,I.y,I.z,I.w):jt.set(I,q,it,J),Ct.viewport(et.copy(jt).multiplyScalar(Ln()).round())},this.getScissor=function(I){return I.copy(we)},this.setScissor=function(I,q,it,J){I.isVector4?we.set(I.x,I.y,I.z,I.w):we.set(I,q,it,J),Ct.scissor(dt.copy(we).multiplyScalar(Ln()).round())},this.getScissorTest=function(){return ve},this.setScissorTest=function(I){Ct.setScissorTest(ve=I)},this.setOpaqueSort=function(I){Jt=I},this.setTransparentSort=function(I){me=I},this.getClearColor=function(I){return I.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(I=!0,q=!0,it=!0){let J=0;if(I){let K=!1;if(Q!==null){let It=Q.texture.format;K=m.has(It)}if(K){let It=Q.texture.type,Ot=g.has(It),Lt=V.getClearColor(),Bt=V.getClearAlpha(),Xt=Lt.r,ce=Lt.g,Re=Lt.b;Ot?(_[0]=Xt,_[1]=ce,_[2]=Re,_[3]=Bt,W.clearBufferuiv(W.COLOR,0,_)):(T[0]=Xt,T[1]=ce,T[2]=Re,T[3]=Bt,W.clearBufferiv(W.COLOR,0,T))}else J|=W.COLOR_BUFFER_BIT}q&&(J|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(J|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&W.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),H=I},this.dispose=function(){e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),V.dispose(),wt.dispose(),rt.dispose(),ne.dispose(),Yt.dispose(),O.dispose(),mt.dispose(),j.dispose(),Rt.dispose(),Zt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",wu),pt.removeEventListener("sessionend",Hs),dr.stop()};function $t(I){I.preventDefault(),oc("WebGLRenderer: Context Lost."),N=!0}function ae(){oc("WebGLRenderer: Context Restored."),N=!1;let I=Qe.autoReset,q=vt.enabled,it=vt.autoUpdate,J=vt.needsUpdate,K=vt.type;oe(),Qe.autoReset=I,vt.enabled=q,vt.autoUpdate=it,vt.needsUpdate=J,vt.type=K}function Dt(I){le("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function ye(I){let q=I.target;q.removeEventListener("dispose",ye),on(q)}function on(I){xi(I),Yt.remove(I)}function xi(I){let q=Yt.get(I).programs;q!==void 0&&(q.forEach(function(it){ct.releaseProgram(it)}),I.isShaderMaterial&&ct.releaseShaderCache(I))}this.renderBufferDirect=function(I,q,it,J,K,It){q===null&&(q=kn);let Ot=K.isMesh&&K.matrixWorld.determinantAffine()<0,Lt=Bl(I,q,it,J,K);Ct.setMaterial(J,Ot);let Bt=it.index,Xt=1;if(J.wireframe===!0){if(Bt=j.getWireframeAttribute(it),Bt===void 0)return;Xt=2}let ce=it.drawRange,Re=it.attributes.position,qt=ce.start*Xt,Ce=(ce.start+ce.count)*Xt;It!==null&&(qt=Math.max(qt,It.start*Xt),Ce=Math.min(Ce,(It.start+It.count)*Xt)),Bt!==null?(qt=Math.max(qt,0),Ce=Math.min(Ce,Bt.count)):Re!=null&&(qt=Math.max(qt,0),Ce=Math.min(Ce,Re.count));let vn=Ce-qt;if(vn<0||vn===1/0)return;Rt.setup(K,J,Lt,it,Bt);let qe,Xe=ot;if(Bt!==null&&(qe=R.get(Bt),Xe=Pt,Xe.setIndex(qe)),K.isMesh)J.wireframe===!0?(Ct.setLineWidth(J.wireframeLinewidth*Ln()),Xe.setMode(W.LINES)):Xe.setMode(W.TRIANGLES);else if(K.isLine){let zn=J.linewidth;zn===void 0&&(zn=1),Ct.setLineWidth(zn*Ln()),K.isLineSegments?Xe.setMode(W.LINES):K.isLineLoop?Xe.setMode(W.LINE_LOOP):Xe.setMode(W.LINE_STRIP)}else K.isPoints?Xe.setMode(W.POINTS):K.isSprite&&Xe.setMode(W.TRIANGLES);if(K.isBatchedMesh)if(se.get("WEBGL_multi_draw"))Xe.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let zn=K._multiDrawStarts,Gt=K._multiDrawCounts,Dn=K._multiDrawCount,Le=Bt?R.get(Bt).bytesPerElement:1,pr=Yt.get(J).currentProgram.getUniforms();for(let Nn=0;Nn<Dn;Nn++)pr.setValue(W,"_gl_DrawID",Nn),Xe.render(zn[Nn]/Le,Gt[Nn])}else if(K.isInstancedMesh)Xe.renderInstances(qt,vn,K.count);else if(it.isInstancedBufferGeometry){let zn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Gt=Math.min(it.instanceCount,zn);Xe.renderInstances(qt,vn,Gt)}else Xe.render(qt,vn)};function Ul(I,q,it,J){H!==null&&I.isNodeMaterial&&H.setObject(J,I),rn===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===pi&&I.forceSinglePass===!1?(I.side=ri,I.needsUpdate=!0,Gs(I,q,J),I.side=ir,I.needsUpdate=!0,Gs(I,q,J),I.side=pi):Gs(I,q,J)}this.compile=function(I,q,it=null){it===null&&(it=I),H!==null&&H.renderStart(I,q,it),S=rt.get(it),S.init(q),w.push(S),it.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(S.pushLight(K),K.castShadow&&S.pushShadow(K))}),I!==it&&I.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(S.pushLight(K),K.castShadow&&S.pushShadow(K))}),S.setupLights(),H!==null&&H.updateLights(S.state.lightsArray),In=this.localClippingEnabled,rn=at.init(this.clippingPlanes,In),rn===!0&&at.setGlobalState(this.clippingPlanes,q),H!==null&&vt.render(S.state.shadowsArray,it,q);let J=new Set;return I.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let It=K.material;if(It)if(Array.isArray(It))for(let Ot=0;Ot<It.length;Ot++){let Lt=It[Ot];Ul(Lt,it,q,K),J.add(Lt)}else Ul(It,it,q,K),J.add(It)}),S=w.pop(),H!==null&&H.renderEnd(),J},this.compileAsync=function(I,q,it=null){let J=this.compile(I,q,it);return new Promise(K=>{function It(){if(J.forEach(function(Ot){let Bt=Yt.get(Ot).currentProgram;(Bt===void 0||Bt.isReady())&&J.delete(Ot)}),J.size===0){K(I);return}setTimeout(It,10)}se.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let ia=null;function mp(I){ia&&ia(I)}function wu(){dr.stop()}function Hs(){dr.start()}let dr=new Ey;dr.setAnimationLoop(mp),typeof self<"u"&&dr.setContext(self),this.setAnimationLoop=function(I){ia=I,pt.setAnimationLoop(I),I===null?dr.stop():dr.start()},pt.addEventListener("sessionstart",wu),pt.addEventListener("sessionend",Hs),this.render=function(I,q){if(q!==void 0&&q.isCamera!==!0){le("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;H!==null&&H.renderStart(I,q);let it=pt.enabled===!0&&pt.isPresenting===!0,J=U!==null&&(Q===null||it)&&U.begin(L,Q);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(L,I,q,Q),S=rt.get(I,w.length),S.init(q),S.state.textureUnits=ne.getTextureUnits(),w.push(S),Je.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?_n.setFromArrayCamera(q):fe.setFromProjectionMatrix(Je,hs,q.reversedDepth),In=this.localClippingEnabled,rn=at.init(this.clippingPlanes,In),A=wt.get(I,y.length),A.init(),y.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ot=L.xr.getDepthSensingMesh();Ot!==null&&fr(Ot,q,-1/0,L.sortObjects)}fr(I,q,0,L.sortObjects),A.finish(),H!==null&&H.updateLights(S.state.lightsArray),L.sortObjects===!0&&A.sort(Jt,me),Sn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Sn&&V.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),rn===!0&&at.beginShadows();let K=S.state.shadowsArray;if(vt.render(K,I,q),rn===!0&&at.endShadows(),(J&&U.hasRenderPass())===!1){let Ot=A.opaque,Lt=A.transmissive;if(S.setupLights(),q.isArrayCamera){let Bt=q.cameras;if(Lt.length>0)for(let Xt=0,ce=Bt.length;Xt<ce;Xt++){let Re=Bt[Xt];vs(Ot,Lt,I,Re)}Sn&&V.render(I);for(let Xt=0,ce=Bt.length;Xt<ce;Xt++){let Re=Bt[Xt];Ol(A,I,Re,Re.viewport)}}else Lt.length>0&&vs(Ot,Lt,I,q),Sn&&V.render(I),Ol(A,I,q)}Q!==null&&B===0&&(ne.updateMultisampleRenderTarget(Q),ne.updateRenderTargetMipmap(Q)),J&&U.end(L),I.isScene===!0&&I.onAfterRender(L,I,q),Rt.resetDefaultState(),Y=-1,Z=null,w.pop(),w.length>0?(S=w[w.length-1],ne.setTextureUnits(S.state.textureUnits),rn===!0&&at.setGlobalState(L.clippingPlanes,S.state.camera)):S=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,H!==null&&H.renderEnd()};function fr(I,q,it,J){if(I.visible===!1)return;if(I.layers.test(q.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update(q);else if(I.isLight)S.pushLight(I),I.castShadow&&S.pushShadow(I);else if(I.isSprite){let Ot=q.isArrayCamera?_n:fe;if(!I.frustumCulled||I.intersectsFrustum(Ot)){J&&Ue.setFromMatrixPosition(I.matrixWorld).applyMatrix4(Je);let Lt=mt.update(I),Bt=I.material;Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}else if(I.isMesh||I.isLine||I.isPoints){let Ot=q.isArrayCamera?_n:fe;if(!I.frustumCulled||I.intersectsFrustum(Ot)){let Lt=mt.update(I),Bt=I.material;if(J&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),Ue.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),Ue.copy(Lt.boundingSphere.center)),Ue.applyMatrix4(I.matrixWorld).applyMatrix4(Je)),Array.isArray(Bt)){let Xt=Lt.groups;for(let ce=0,Re=Xt.length;ce<Re;ce++){let qt=Xt[ce],Ce=Bt[qt.materialIndex];Ce&&Ce.visible&&A.push(I,Lt,Ce,it,Ue.z,qt,q)}}else Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}}let It=I.children;for(let Ot=0,Lt=It.length;Ot<Lt;Ot++)fr(It[Ot],q,it,J)}function Ol(I,q,it,J){let{opaque:K,transmissive:It,transparent:Ot}=I;S.setupLightsView(it),rn===!0&&at.setGlobalState(L.clippingPlanes,it),J&&Ct.viewport(et.copy(J)),K.length>0&&wn(K,q,it),It.length>0&&wn(It,q,it),Ot.length>0&&wn(Ot,q,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function vs(I,q,it,J){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[J.id]===void 0){let qt=se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[J.id]=new Qi(1,1,{generateMipmaps:!0,type:qt?Is:ns,minFilter:Pr,samples:Math.max(4,ge.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:De.workingColorSpace})}let It=S.state.transmissionRenderTarget[J.id],Ot=J.viewport||et;It.setSize(Ot.z*L.transmissionResolutionScale,Ot.w*L.transmissionResolutionScale);let Lt=L.getRenderTarget(),Bt=L.getActiveCubeFace(),Xt=L.getActiveMipmapLevel();L.setRenderTarget(It),L.getClearColor(st),yt=L.getClearAlpha(),yt<1&&L.setClearColor(16777215,.5),L.clear(),Sn&&V.render(it);let ce=L.toneMapping;L.toneMapping=sr;let Re=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),S.setupLightsView(J),rn===!0&&at.setGlobalState(L.clippingPlanes,J),wn(I,it,J),ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It),se.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ce=0,vn=q.length;Ce<vn;Ce++){let qe=q[Ce],{object:Xe,geometry:zn,material:Gt,group:Dn}=qe;if(Gt.side===pi&&Xe.layers.test(J.layers)){let Le=Gt.side;Gt.side=ri,Gt.needsUpdate=!0,Cn(Xe,it,J,zn,Gt,Dn),Gt.side=Le,Gt.needsUpdate=!0,qt=!0}}qt===!0&&(ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It))}L.setRenderTarget(Lt,Bt,Xt),L.setClearColor(st,yt),Re!==void 0&&(J.viewport=Re),L.toneMapping=ce}function wn(I,q,it){let J=q.isScene===!0?q.overrideMaterial:null;for(let K=0,It=I.length;K<It;K++){let Ot=I[K],{object:Lt,geometry:Bt,group:Xt}=Ot,ce=Ot.material;ce.allowOverride===!0&&J!==null&&(ce=J),Lt.layers.test(it.layers)&&Cn(Lt,q,it,Bt,ce,Xt)}}function Cn(I,q,it,J,K,It){H!==null&&K.isNodeMaterial&&H.setObject(I,K),I.onBeforeRender(L,q,it,J,K,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),K.onBeforeRender(L,q,it,J,I,It),K.transparent===!0&&K.side===pi&&K.forceSinglePass===!1?(K.side=ri,K.needsUpdate=!0,L.renderBufferDirect(it,q,J,K,I,It),K.side=ir,K.needsUpdate=!0,L.renderBufferDirect(it,q,J,K,I,It),K.side=pi):L.renderBufferDirect(it,q,J,K,I,It),I.onAfterRender(L,q,it,J,K,It)}function Pn(I){let q=0;for(let it of I)it.texture!==null&&q++;return q}function Gs(I,q,it){q.isScene!==!0&&(q=kn);let J=Yt.get(I),K=S.state.lights,It=S.state.shadowsArray,Ot=K.state.version,Lt=ct.getParameters(I,K.state,It,q,it,S.state.lightProbeGridArray),Bt=ct.getProgramCacheKey(Lt),Xt=J.programs;J.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?q.environment:null,J.fog=q.fog;let ce=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;J.envMap=O.get(I.envMap||J.environment,ce),J.envMapRotation=J.environment!==null&&I.envMap===null?q.environmentRotation:I.envMapRotation,Xt===void 0&&(I.addEventListener("dispose",ye),Xt=new Map,J.programs=Xt,J.programVariants=new Map);let Re=Xt.get(Bt);if(Re!==void 0){if(J.currentProgram===Re&&J.lightsStateVersion===Ot)return Fl(I,Lt),Re}else Lt.uniforms=ct.getUniforms(I),H!==null&&I.isNodeMaterial&&H.build(I,it,Lt),I.onBeforeCompile(Lt,L),Re=ct.acquireProgram(Lt,Bt),Xt.set(Bt,Re),J.uniforms=Lt.uniforms;let qt=J.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&(qt.clippingPlanes=at.uniform),Fl(I,Lt),J.needsLights=Gr(I),J.lightsStateVersion=Ot,J.needsLights&&(qt.ambientLightColor.value=K.state.ambient,qt.lightProbe.value=K.state.probe,qt.sunLights.value=K.state.sun,qt.sunLightShadows.value=K.state.sunShadow,qt.directionalLights.value=K.state.directional,qt.directionalLightShadows.value=K.state.directionalShadow,qt.spotLights.value=K.state.spot,qt.spotLightShadows.value=K.state.spotShadow,qt.rectAreaLights.value=K.state.rectArea,qt.ltc_1.value=K.state.rectAreaLTC1,qt.ltc_2.value=K.state.rectAreaLTC2,qt.pointLights.value=K.state.point,qt.pointLightShadows.value=K.state.pointShadow,qt.hemisphereLights.value=K.state.hemi,qt.sunShadowMatrix.value=K.state.sunShadowMatrix,qt.sunShadowCascade.value=K.state.sunShadowCascade,qt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,qt.spotLightMatrix.value=K.state.spotLightMatrix,qt.spotLightMap.value=K.state.spotLightMap,qt.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=Pn(S.state.lightProbeGridArray),J.currentProgram=Re,J.uniformsList=null,Re}function $i(I,q,it,J,K){let It=Yt.get(I),Ot=It.currentProgram.id+","+J+","+K,Lt=It.programVariants.get(Ot);return Lt===void 0?(Lt=Gs(I,q,it),It.programVariants.set(Ot,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=J,It.toneMapping=K),Lt}function Hr(I){if(I.uniformsList===null){let q=I.currentProgram.getUniforms();I.uniformsList=ja.seqWithValue(q.seq,I.uniforms)}return I.uniformsList}function Fl(I,q){let it=Yt.get(I);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function Bl(I,q,it,J,K){q.isScene!==!0&&(q=kn),ne.resetTextureUnits();let It=q.fog,Ot=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?q.environment:null,Lt=Q===null?L.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:De.workingColorSpace,Bt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Xt=O.get(J.envMap||Ot,Bt),ce=J.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Re=!!it.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),qt=!!it.morphAttributes.position,Ce=!!it.morphAttributes.normal,vn=!!it.morphAttributes.color,qe=sr;J.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(qe=L.toneMapping);let Xe=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,zn=Xe!==void 0?Xe.length:0,Gt=Yt.get(J),Dn=S.state.lights;if(rn===!0&&(In===!0||I!==Z)){let Ye=I===Z&&J.id===Y;at.setState(J,I,Ye)}let Le=!1,pr=!1;J.version===Gt.__version?Gt.needsLights&&Gt.lightsStateVersion!==Dn.state.version||K.isBatchedMesh&&Gt.batching===!1||!K.isBatchedMesh&&Gt.batching===!0||K.isBatchedMesh&&Gt.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Gt.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Gt.instancing===!1||!K.isInstancedMesh&&Gt.instancing===!0||K.isSkinnedMesh&&Gt.skinning===!1||!K.isSkinnedMesh&&Gt.skinning===!0||K.isInstancedMesh&&Gt.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Gt.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Gt.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Gt.instancingMorph===!1&&K.morphTexture!==null||Gt.envMap!==Xt||J.fog===!0&&Gt.fog!==It||Gt.numClippingPlanes!==void 0&&(Gt.numClippingPlanes!==at.numPlanes||Gt.numIntersection!==at.numIntersection)||Gt.vertexAlphas!==ce||Gt.vertexTangents!==Re||Gt.morphTargets!==qt||Gt.morphNormals!==Ce||Gt.morphColors!==vn||Gt.morphTargetsCount!==zn||Gt.numLightProbeGrids!==Pn(S.state.lightProbeGridArray)?Le=!0:(Gt.outputColorSpace!==Lt||Gt.toneMapping!==qe)&&(pr=!0):(Le=!0,Gt.__version=J.version);let Nn=Gt.currentProgram;(Le===!0||pr===!0)&&(Nn=pr===!0?$i(J,q,K,Lt,qe):Gs(J,q,K),H&&J.isNodeMaterial&&H.onUpdateProgram(J,Nn,Gt));let oa=!1,Vs=!1,mr=!1,be=Nn.getUniforms(),En=Gt.uniforms;if(Ct.useProgram(Nn.program)&&(oa=!0,Vs=!0,mr=!0),J.id!==Y&&(Y=J.id,Vs=!0),oa||Z!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),be.setValue(W,"projectionMatrix",I.projectionMatrix),be.setValue(W,"viewMatrix",I.matrixWorldInverse);let Un=be.map.cameraPosition;Un!==void 0&&Un.setValue(W,Yn.setFromMatrixPosition(I.matrixWorld)),ge.logarithmicDepthBuffer&&be.setValue(W,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&be.setValue(W,"isOrthographic",I.isOrthographicCamera===!0),Z!==I&&(Z=I,Vs=!0,mr=!0)}if(Gt.needsLights&&(Dn.state.sunShadowMap.length>0&&be.setValue(W,"sunShadowMap",Dn.state.sunShadowMap,ne),Dn.state.directionalShadowMap.length>0&&be.setValue(W,"directionalShadowMap",Dn.state.directionalShadowMap,ne),Dn.state.spotShadowMap.length>0&&be.setValue(W,"spotShadowMap",Dn.state.spotShadowMap,ne),Dn.state.pointShadowMap.length>0&&be.setValue(W,"pointShadowMap",Dn.state.pointShadowMap,ne)),K.isSkinnedMesh){be.setOptional(W,K,"bindMatrix"),be.setOptional(W,K,"bindMatrixInverse");let Ye=K.skeleton;Ye&&(Ye.boneTexture===null&&Ye.computeBoneTexture(),be.setValue(W,"boneTexture",Ye.boneTexture,ne))}K.isBatchedMesh&&(be.setOptional(W,K,"batchingTexture"),be.setValue(W,"batchingTexture",K._matricesTexture,ne),be.setOptional(W,K,"batchingIdTexture"),be.setValue(W,"batchingIdTexture",K._indirectTexture,ne),be.setOptional(W,K,"batchingColorTexture"),K._colorsTexture!==null&&be.setValue(W,"batchingColorTexture",K._colorsTexture,ne));let yi=it.morphAttributes;if((yi.position!==void 0||yi.normal!==void 0||yi.color!==void 0)&&lt.update(K,it,Nn),(Vs||Gt.receiveShadow!==K.receiveShadow)&&(Gt.receiveShadow=K.receiveShadow,be.setValue(W,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&q.environment!==null&&(En.envMapIntensity.value=q.environmentIntensity),En.dfgLUT!==void 0&&(En.dfgLUT.value=rP()),Vs){if(be.setValue(W,"toneMappingExposure",L.toneMappingExposure),Gt.needsLights&&sa(En,mr),It&&J.fog===!0&&St.refreshFogUniforms(En,It),St.refreshMaterialUniforms(En,J,At,Tt,S.state.transmissionRenderTarget[I.id]),Gt.needsLights&&Gt.numLightProbeGrids>0){let Ye=v,Un=0;for(let li of S.state.lightProbeGridArray)li.texture!==null&&(Ye.textures[Un]=li.texture,Ye.min[Un]=li.boundingBox.min,Ye.max[Un]=li.boundingBox.max,Ye.resolution[Un]=li.resolution,Un++);for(let li in Ye)Ye[li].length=Un;En.probesSH.value=Ye.textures,En.probesMin.value=Ye.min,En.probesMax.value=Ye.max,En.probesResolution.value=Ye.resolution}ja.upload(W,Hr(Gt),En,ne)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(ja.upload(W,Hr(Gt),En,ne),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&be.setValue(W,"center",K.center),be.setValue(W,"modelViewMatrix",K.modelViewMatrix),be.setValue(W,"normalMatrix",K.normalMatrix),be.setValue(W,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Ye=J.uniformsGroups;for(let Un=0,li=Ye.length;Un<li;Un++){let Eu=Ye[Un];Zt.update(Eu,Nn),Zt.bind(Eu,Nn)}}return Nn}function sa(I,q){I.ambientLightColor.needsUpdate=q,I.lightProbe.needsUpdate=q,I.sunLights.needsUpdate=q,I.sunLightShadows.needsUpdate=q,I.directionalLights.needsUpdate=q,I.directionalLightShadows.needsUpdate=q,I.pointLights.needsUpdate=q,I.pointLightShadows.needsUpdate=q,I.spotLights.needsUpdate=q,I.spotLightShadows.needsUpdate=q,I.rectAreaLights.needsUpdate=q,I.hemisphereLights.needsUpdate=q}function Gr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(I,q,it){let J=Yt.get(I);J.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Yt.get(I.texture).__webglTexture=q,Yt.get(I.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:it,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,q){let it=Yt.get(I);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(I,q=0,it=0){Q=I,D=q,B=it;let J=null,K=!1,It=!1;if(I){let Lt=Yt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(W.FRAMEBUFFER,Lt.__webglFramebuffer),et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),Y=-1;return}else if(Lt.__webglFramebuffer===void 0)ne.setupRenderTarget(I);else if(Lt.__hasExternalTextures)ne.rebindTextures(I,Yt.get(I.texture).__webglTexture,Yt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let ce=I.depthTexture;if(Lt.__boundDepthTexture!==ce){if(ce!==null&&Yt.has(ce)&&(I.width!==ce.image.width||I.height!==ce.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ne.setupDepthRenderbuffer(I)}}let Bt=I.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(It=!0);let Xt=Yt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray(Xt[q])?J=Xt[q][it]:J=Xt[q],K=!0):I.samples>0&&ne.useMultisampledRTT(I)===!1?J=Yt.get(I).__webglMultisampledFramebuffer:Array.isArray(Xt)?J=Xt[it]:J=Xt,et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else et.copy(jt).multiplyScalar(At).floor(),dt.copy(we).multiplyScalar(At).floor(),ft=ve;if(it!==0&&(J=$),Ct.bindFramebuffer(W.FRAMEBUFFER,J)&&Ct.drawBuffers(I,J),Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),K){let Lt=Yt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+q,Lt.__webglTexture,it)}else if(It){let Lt=q;for(let Bt=0;Bt<I.textures.length;Bt++){let Xt=Yt.get(I.textures[Bt]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Bt,Xt.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Yt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Lt.__webglTexture,it)}Y=-1};function ra(I){let q=Yt.get(I);return(q.__readFormat!==I.format||q.__readType!==I.type)&&(q.__readFormat=I.format,q.__readType=I.type,q.__formatReadable=ge.textureFormatReadable(I.format),q.__typeReadable=ge.textureTypeReadable(I.type)),q}this.readRenderTargetPixels=function(I,q,it,J,K,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget)){le("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){Ct.bindFramebuffer(W.FRAMEBUFFER,Bt);try{let Xt=I.textures[Lt],ce=Xt.format,Re=Xt.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let qt=ra(Xt);if(qt.__formatReadable===!1){le("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){le("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=I.width-J&&it>=0&&it<=I.height-K&&W.readPixels(q,it,J,K,Mt.convert(ce),Mt.convert(Re),It)}finally{let Xt=Q!==null?Yt.get(Q).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(I,q,it,J,K,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(q>=0&&q<=I.width-J&&it>=0&&it<=I.height-K){Ct.bindFramebuffer(W.FRAMEBUFFER,Bt);let Xt=I.textures[Lt],ce=Xt.format,Re=Xt.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let qt=ra(Xt);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ce=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,Ce),W.bufferData(W.PIXEL_PACK_BUFFER,It.byteLength,W.STREAM_READ),W.readPixels(q,it,J,K,Mt.convert(ce),Mt.convert(Re),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let vn=Q!==null?Yt.get(Q).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,vn);let qe=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await Kx(W,qe,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,Ce),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,It),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(Ce),W.deleteSync(qe),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,q=null,it=0){let J=Math.pow(2,-it),K=Math.floor(I.image.width*J),It=Math.floor(I.image.height*J),Ot=q!==null?q.x:0,Lt=q!==null?q.y:0;ne.setTexture2D(I,0),W.copyTexSubImage2D(W.TEXTURE_2D,it,0,0,Ot,Lt,K,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,q,it=null,J=null,K=0,It=0){let Ot,Lt,Bt,Xt,ce,Re,qt,Ce,vn,qe=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ot=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Bt=it.isBox3?it.max.z-it.min.z:1,Xt=it.min.x,ce=it.min.y,Re=it.isBox3?it.min.z:0;else{let be=Math.pow(2,-K);Ot=Math.floor(qe.width*be),Lt=Math.floor(qe.height*be),I.isDataArrayTexture?Bt=qe.depth:I.isData3DTexture?Bt=Math.floor(qe.depth*be):Bt=1,Xt=0,ce=0,Re=0}J!==null?(qt=J.x,Ce=J.y,vn=J.z):(qt=0,Ce=0,vn=0);let Xe=Mt.convert(q.format),zn=Mt.convert(q.type),Gt;q.isData3DTexture?(ne.setTexture3D(q,0),Gt=W.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(ne.setTexture2DArray(q,0),Gt=W.TEXTURE_2D_ARRAY):(ne.setTexture2D(q,0),Gt=W.TEXTURE_2D),Ct.activeTexture(W.TEXTURE0),Ct.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,q.flipY),Ct.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ct.pixelStorei(W.UNPACK_ALIGNMENT,q.unpackAlignment);let Dn=Ct.getParameter(W.UNPACK_ROW_LENGTH),Le=Ct.getParameter(W.UNPACK_IMAGE_HEIGHT),pr=Ct.getParameter(W.UNPACK_SKIP_PIXELS),Nn=Ct.getParameter(W.UNPACK_SKIP_ROWS),oa=Ct.getParameter(W.UNPACK_SKIP_IMAGES);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,qe.width),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,qe.height),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,Xt),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,ce),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,Re);let Vs=I.isDataArrayTexture||I.isData3DTexture,mr=q.isDataArrayTexture||q.isData3DTexture;if(I.isDepthTexture){let be=Yt.get(I),En=Yt.get(q),yi=Yt.get(be.__renderTarget),Ye=Yt.get(En.__renderTarget);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,yi.__webglFramebuffer),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,Ye.__webglFramebuffer);for(let Un=0;Un<Bt;Un++)Vs&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Yt.get(I).__webglTexture,K,Re+Un),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Yt.get(q).__webglTexture,It,vn+Un)),W.blitFramebuffer(Xt,ce,Xt+Ot,ce+Lt,qt,Ce,qt+Ot,Ce+Lt,W.DEPTH_BUFFER_BIT,W.NEAREST);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if(K!==0||I.isRenderTargetTexture||Yt.has(I)){let be=Yt.get(I),En=Yt.get(q);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,P),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,z);for(let yi=0;yi<Bt;yi++)Vs?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,be.__webglTexture,K,Re+yi):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,be.__webglTexture,K),mr?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,En.__webglTexture,It,vn+yi):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,En.__webglTexture,It),K!==0?W.blitFramebuffer(Xt,ce,Xt+Ot,ce+Lt,qt,Ce,qt+Ot,Ce+Lt,W.COLOR_BUFFER_BIT,W.NEAREST):mr?W.copyTexSubImage3D(Gt,It,qt,Ce,vn+yi,Xt,ce,Ot,Lt):W.copyTexSubImage2D(Gt,It,qt,Ce,Xt,ce,Ot,Lt);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else mr?I.isDataTexture||I.isData3DTexture?W.texSubImage3D(Gt,It,qt,Ce,vn,Ot,Lt,Bt,Xe,zn,qe.data):q.isCompressedArrayTexture?W.compressedTexSubImage3D(Gt,It,qt,Ce,vn,Ot,Lt,Bt,Xe,qe.data):W.texSubImage3D(Gt,It,qt,Ce,vn,Ot,Lt,Bt,Xe,zn,qe):I.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,It,qt,Ce,Ot,Lt,Xe,zn,qe.data):I.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,It,qt,Ce,qe.width,qe.height,Xe,qe.data):W.texSubImage2D(W.TEXTURE_2D,It,qt,Ce,Ot,Lt,Xe,zn,qe);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,Dn),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Le),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,pr),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,Nn),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,oa),It===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&W.generateMipmap(Gt),Ct.unbindTexture()},this.initRenderTarget=function(I){Yt.get(I).__webglFramebuffer===void 0&&ne.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?ne.setTextureCube(I,0):I.isData3DTexture?ne.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?ne.setTexture2DArray(I,0):ne.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){D=0,B=0,Q=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return hs}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=De._getDrawingBufferColorSpace(t),e.unpackColorSpace=De._getUnpackColorSpace()}};var Nd={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Ft={},aP=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],Oy=matchMedia("(prefers-color-scheme: dark)");function Ud(){let n=b.theme==="dark"||b.theme==="auto"&&Oy.matches;document.documentElement.dataset.theme=n?"dark":"light",document.documentElement.style.setProperty("--text-size",String(Jm()));let t=getComputedStyle(document.documentElement);for(let e of aP)Ft[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Ft.dark=n,Ft.curves=Nd[n?"dark":"light"].curves}function Od(n){b.theme=n,Ud(),ut("theme")}var Fy="pieper-text-size";function Jm(){let n=Number(localStorage.getItem(Fy));return n>=.5&&n<=3?n:1}function By(n){document.documentElement.style.setProperty("--text-size",String(n));try{localStorage.setItem(Fy,String(n))}catch{}ut("theme"),dispatchEvent(new Event("resize"))}Oy.addEventListener("change",()=>{b.theme==="auto"&&(Ud(),ut("theme"))});var ky={type:"change"},Qm={type:"start"},Hy={type:"end"},Fd=new Ar,zy=new ii,lP=Math.cos(70*lo.DEG2RAD),Wn=new G,zi=2*Math.PI,He={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Km=1e-6,Bd=class extends wc{constructor(t,e=null){super(t,e),this.state=He.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:so.ROTATE,MIDDLE:so.DOLLY,RIGHT:so.PAN},this.touches={ONE:ro.ROTATE,TWO:ro.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new dn,this._lastTargetPosition=new G,this._quat=new dn().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wa,this._sphericalDelta=new Wa,this._scale=1,this._panOffset=new G,this._rotateStart=new Qt,this._rotateEnd=new Qt,this._rotateDelta=new Qt,this._panStart=new Qt,this._panEnd=new Qt,this._panDelta=new Qt,this._dollyStart=new Qt,this._dollyEnd=new Qt,this._dollyDelta=new Qt,this._dollyDirection=new G,this._mouse=new Qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=uP.bind(this),this._onPointerDown=cP.bind(this),this._onPointerUp=hP.bind(this),this._onContextMenu=xP.bind(this),this._onMouseWheel=pP.bind(this),this._onKeyDown=mP.bind(this),this._onTouchStart=gP.bind(this),this._onTouchMove=_P.bind(this),this._onMouseDown=dP.bind(this),this._onMouseMove=fP.bind(this),this._interceptControlDown=yP.bind(this),this._interceptControlUp=vP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=He.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ky),this.update(),this.state=He.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Wn.copy(e).sub(this.target),Wn.applyQuaternion(this._quat),this._spherical.setFromVector3(Wn),this.autoRotate&&this.state===He.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=zi:i>Math.PI&&(i-=zi),s<-Math.PI?s+=zi:s>Math.PI&&(s-=zi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Wn.setFromSpherical(this._spherical),Wn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Fd.origin.copy(this.object.position),Fd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Fd.direction))<lP?this.object.lookAt(this.target):(zy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Fd.intersectPlane(zy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Km||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Km||this._lastTargetPosition.distanceToSquared(this.target)>Km?(this.dispatchEvent(ky),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?zi/60*this.autoRotateSpeed*t:zi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Wn.setFromMatrixColumn(e,0),Wn.multiplyScalar(-t),this._panOffset.add(Wn)}_panUp(t,e){this.screenSpacePanning===!0?Wn.setFromMatrixColumn(e,1):(Wn.setFromMatrixColumn(e,0),Wn.crossVectors(this.object.up,Wn)),Wn.multiplyScalar(t),this._panOffset.add(Wn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Wn.copy(s).sub(this.target);let r=Wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(zi*this._rotateDelta.x/e.clientHeight),this._rotateUp(zi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-zi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(zi*this._rotateDelta.x/e.clientHeight),this._rotateUp(zi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function cP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function uP(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function hP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Hy),this.state=He.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function dP(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case so.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=He.DOLLY;break;case so.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=He.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=He.ROTATE}break;case so.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=He.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=He.PAN}break;default:this.state=He.NONE}this.state!==He.NONE&&this.dispatchEvent(Qm)}function fP(n){switch(this.state){case He.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case He.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case He.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function pP(n){this.enabled===!1||this.enableZoom===!1||this.state!==He.NONE||(n.preventDefault(),this.dispatchEvent(Qm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Hy))}function mP(n){this.enabled!==!1&&this._handleKeyDown(n)}function gP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ro.ROTATE:if(this.enableRotate===!1){this.state=He.NONE;break}this._handleTouchStartRotate(n),this.state=He.TOUCH_ROTATE;break;case ro.PAN:if(this.enablePan===!1){this.state=He.NONE;break}this._handleTouchStartPan(n),this.state=He.TOUCH_PAN;break;default:this.state=He.NONE}break;case 2:switch(this.touches.TWO){case ro.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=He.TOUCH_DOLLY_PAN;break;case ro.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=He.TOUCH_DOLLY_ROTATE;break;default:this.state=He.NONE}break;default:this.state=He.NONE}this.state!==He.NONE&&this.dispatchEvent(Qm)}function _P(n){switch(this._trackPointer(n),this.state){case He.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case He.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case He.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case He.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=He.NONE}}function xP(n){this.enabled!==!1&&n.preventDefault()}function yP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function vP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Gy=[1,.75,.55,.42],bP=30,MP=17,SP=400,Vy=6e6;function Wy(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var kd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(Vy/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>bP&&this.level<Gy.length-1?this.level+=1:i<MP&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*Gy[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(Vy/this.area),.5))),this.draw()},SP)}};var Xy=32,Yy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},pn=new cc,Ie=new Ti(Xy,1,.01,100);Ie.up.set(0,0,1);var ss,fn,fs,zd,tg=!1,jy=!1,ng=0;function xe(){tg||!jy||(tg=!0,requestAnimationFrame(Zy))}function Zy(n=performance.now()){tg=!1,zd.moving(n),ig()}var Jy=[],Hd=n=>Jy.push(n);function ig(){for(let n of Jy)n();ss.render(pn,Ie),ng+=1}function Ky(){jy=!0,xe()}function Ja(n){return ig(),n(ss.domElement)}var Qy=()=>ng,tv=()=>!!zd?.software;pn.fog=new lc("#fff",1,10);function $y(n){let t=document.createElement("canvas");t.width=fs.clientWidth||1,t.height=fs.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>wP.has(s)?i(s):null,e}var wP=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function ev(n){fs=n;let t=$y(!1),e=Wy(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=$y(!0)),ss=new Id({canvas:t.canvas,context:t}),ss.debug.checkShaderErrors=!1,zd=new kd(e,ss,ig,i=>ut("hurry",i)),ss.domElement.setAttribute("aria-hidden","true"),fs.append(ss.domElement),fn=new Bd(Ie,ss.domElement),fn.enableDamping=!1,fn.addEventListener("change",xe),fn.addEventListener("end",()=>{Ka=!rg(),lr=null}),new ResizeObserver(EP).observe(fs),fs.tabIndex=0,fs.setAttribute("role","application"),fs.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),fs.addEventListener("keydown",TP)}function EP(){let n=fs.clientWidth,t=fs.clientHeight;!n||!t||(zd.resized(n,t),ss.setSize(n,t),Ie.aspect=n/t,Ie.updateProjectionMatrix(),ng?Zy():xe(),RP()||Qa())}function TP(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)AP(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")qy(1/1.15);else if(n.key==="-")qy(1.15);else if(n.key.toLowerCase()==="f")Gd(Go);else if(e)sg(e);else return;n.preventDefault()}function AP(n,t){let e=Ie.position.clone().sub(fn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Ie.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(fn.target),fn.update(),xe()}function qy(n){Ie.position.sub(fn.target).multiplyScalar(n).add(fn.target),fn.update(),xe()}var Go=[[0,0,0],[0,0,1]];function nv(n,t){let e=new Bi().setFromPoints(n.map(u=>new G(...u))),i=e.getCenter(new G),s=new G(...t).normalize(),r=new G().crossVectors(Ie.up,s).normalize(),o=new G().crossVectors(s,r),a=Math.tan(lo.degToRad(Xy/2))*.8,l=a*Ie.aspect,c=e.getSize(new G).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,x=-1/0;for(let m of n){let g=new G(...m).sub(i),_=g.dot(r),T=g.dot(o),v=g.dot(s);h=Math.max(h,v+Math.abs(_)/l,v+Math.abs(T)/a),d=Math.min(d,T),f=Math.max(f,T),p=Math.min(p,_),x=Math.max(x,_)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+x)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var eg=0;function Fc({target:n,position:t},e=.35){let i={t:fn.target.clone(),p:Ie.position.clone()},s=performance.now(),r=++eg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==eg)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);fn.target.lerpVectors(i.t,n,u),Ie.position.lerpVectors(i.p,t,u);let h=Ie.position.distanceTo(fn.target);Ie.near=h/100,Ie.far=h*30,pn.fog.near=h*1.3,pn.fog.far=h*3.4,Ie.updateProjectionMatrix(),fn.update(),xe(),c<1&&requestAnimationFrame(a)})(s)}function Gd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){Go=n,i||(lr=null),Ka=!1;let s=e?Yy[e]:Ie.position.clone().sub(fn.target).toArray();Fc(nv(n,s),t?0:.35)}function sg(n){Ka=!1,lr=null,Fc(nv(Go,Yy[n]))}var Ka=!1;function rg(){Ie.updateMatrixWorld();let n=new G;return Go.every(t=>(n.set(...t).project(Ie),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Qa(){Ka||!fn.enabled||!Go.length||rg()||(lr??={position:Ie.position.clone(),target:fn.target.clone()},Gd(Go,{byItself:!0}))}var lr=null;function iv(){if(!lr||Ka||!fn.enabled)return;let n=lr;lr=null,Fc(n),setTimeout(Qa,500)}function RP(){if(!lr||Ka||!fn.enabled)return!1;let n={position:Ie.position.clone(),target:fn.target.clone()},t=lr,e=({position:s,target:r})=>{Ie.position.copy(s),fn.target.copy(r),Ie.lookAt(r)};e(t);let i=rg();return e(n),i?(lr=null,Fc(t,0),!0):!1}var og=n=>{Go=n},tl=()=>[...Ie.position.toArray(),...fn.target.toArray()].map(n=>Number(n.toPrecision(5)));function sv(n){eg+=1,Fc({position:new G(...n.slice(0,3)),target:new G(...n.slice(3))},0)}var ar=null,ag={cell:.1};function lg(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;ag.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(Ft.gridFine),l=new ee(Ft.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}ar?.geometry.dispose();let c=new Ae;c.setAttribute("position",new Te(r,3)),c.setAttribute("color",new Te(o,3)),ar?ar.geometry=c:(ar=new No(c,new ts({vertexColors:!0})),ar.renderOrder=-2,ar.material.depthWrite=!1,pn.add(ar)),ar.userData.reach=n,xe()}function cg(){pn.background=new ee(Ft.ground),pn.fog.color.set(Ft.ground),ar&&lg(ar.userData.reach),xe()}function Hi(n){Ie.updateMatrixWorld();let t=new G(...n).project(Ie),e=fs.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Vd(n){let t=n.joints.length,e=ci(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function ug(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=Ep(n,t),u=(d,f,p,x=!0,m=p)=>{Ni(Di(f,d))<=l||(s.rods.push({a:d,b:f,r:p,far:m}),x&&s.balls.push({at:f,r:m}))};a&&(s.pedestal={at:te(t[0]),dir:Ys(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:p},x)=>{let m=r[x],g=n.joints[x],_=te(t[x]),T=te(t[x+1]),v=m*.62,A=m*.84,S=(r[x+1]??e.rest)*.62,y=(r[x-1]??m)*.84;if(n.convention==="standard"){let z=Wl(_,f,Vl(Di(T,_),f));u(_,z,v),u(z,T,A,!0,S)}else u(_,d,y,!0,v),u(d,T,v);let w=d,U=Vl(Di(T,d),f);h&&Ni(Di(d,h.at))<.5*m&&Math.abs(U)>l?w=Wl(d,f,Math.sign(U)*Math.min(Math.abs(U)*.55,h.r+m*1.15)):x===0&&Math.abs(U)>2.2*m&&(w=Wl(d,f,Math.sign(U)*m*1.25));let L=m*2.15,N=Ys(t[x+1],0),H=!!(i&&Bc(g,i[x])),$=Ys(t[0],2),P=Vl(Di(w,te(t[0])),$)-L/2;x===0&&g.type==="R"&&Math.abs(Vl(f,$))>.99&&P<0&&P>-L&&(w=Wl(w,$,-P)),g.type==="R"?s.drums.push({at:w,dir:f,x:p,turned:N,r:m,h:L,beyond:H,joint:x}):s.sleeves.push({at:w,dir:f,x:p,r:m*.95,h:m*3.4,beyond:H,joint:x}),h={at:d,r:m}}),a){let d=t[a+1],f=te(t[a]);s.flange={at:f,dir:Ys(t[a],2),turned:Ys(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,te(d),e.rest*.34,!1),s.tip={at:te(d),r:e.rest*.42}}return s}function Bc(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function kc(n,t){let e=Vd(n).radius[0]??.05,i=te(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(te)];for(let{point:r}of Ep(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function PP(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new xc(s.map(([a,l])=>new Qt(a,l)),n):new Ri(1,1,1,n),o={rod:i(new Ri(1,1,1,n,1,!0)),ball:t>3?new Cs(1,n,t):new yc(1,0),drum:i(r),box:new ki(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var rv=new Map,pg=(n,t)=>rv.get(n)??rv.set(n,PP(n,t)).get(n),IP=()=>pg(26,12),hg=()=>pg(11,5),ov=()=>pg(6,3),zc=class{constructor(t){this.mesh=new je(new Ae,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Ae,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new ze(c,l).setUsage(Td);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new ze(o,1).setUsage(Td)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let p=t.at[d+2]>0?c:a,x=p*t.at[d],m=p*t.at[d+1],g=l*t.at[d+2],_=t.normal[d]/a,T=t.normal[d+1]/a,v=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*x+r[A]*m+o[A]*g,this.normal[f+A]=s[A]*_+r[A]*T+o[A]*v}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},av=[1,0,0],LP=[0,1,0],lv=[0,0,1];function DP(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Ru(n,Math.abs(n[2])<.9?lv:av),i=Ru(n,e),s=Ni(i)||1,r=i.map(o=>o/s);return[Ru(r,n),r]}var Wd=0,$d=1,dg=2,fg=3,el=class{constructor(t,{shadow:e=null,veil:i=!1,rim:s=null}={}){this.group=new Rn,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new zc(t),this.group.add(this.body.mesh),s&&(this.rim=new zc(s),this.rim.mesh.renderOrder=1,this.group.add(this.rim.mesh)),e&&(this.flat=new zc(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?ov:hg:this.moving?hg:IP;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),this.rim){this.rim.clear();for(let i of this.seen?t:[])this.#t(this.rim,i,e(),{rim:!0});this.rim.done()}if(this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?ov():hg(),{flat:!0});this.flat.done()}}#t(t,e,i,{flat:s=!1,rim:r=!1}={}){let o=this.rim&&!r?e.rim:0,a=!this.veil&&!s,l=f=>this.veil?Math.max(.96*f-o,.3*f):f,c=f=>2*l(f/2),u=f=>this.veil?e.outside?fg:Wd:f,h=(f,p,x,m,g,_,T,v)=>t.put(f,u(p),x,...DP(m,T),m,g,_,v),d=(f,p,x)=>t.put(i.ball,u(f),p,av,LP,lv,x,x);for(let{a:f,b:p,r:x,far:m}of e.rods){let g=Di(p,f),_=Ni(g),T=[(f[0]+p[0])/2,(f[1]+p[1])/2,(f[2]+p[2])/2];h(i.rod,Wd,T,g.map(v=>v/_),l(x),_,null,l(m??x))}for(let{at:f,r:p}of e.balls)d(Wd,f,l(p));for(let{at:f,dir:p,turned:x,r:m,h:g,beyond:_}of e.drums){if(h(i.drum,_&&a?fg:$d,f,p,l(m),c(g)),!a)continue;h(i.rod,dg,f,p,m*1.012,g*.13);let T=[0,1,2].map(v=>f[v]+x[v]*m*.96);h(i.box,Wd,T,p,m*.11,g*.86,x)}for(let{at:f,dir:p,x,r:m,h:g,beyond:_}of e.sleeves)h(i.box,_&&a?fg:$d,f,p,l(m),c(g),x);if(e.pedestal&&!this.veil){let{at:f,dir:p,r:x,h:m}=e.pedestal;h(i.drum,$d,[f[0]+p[0]*m/2,f[1]+p[1]*m/2,f[2]+p[2]*m/2],p,x,m)}if(e.flange&&h(i.drum,$d,e.flange.at,e.flange.dir,l(e.flange.r),c(e.flange.h)),e.flange&&a){let{at:f,dir:p,turned:x,r:m,h:g}=e.flange;h(i.box,dg,[0,1,2].map(_=>f[_]+x[_]*m*.95),p,m*.16,g*1.04,x)}e.tip&&a&&d(dg,e.tip.at,e.tip.r)}};var NP=`
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
  }`,cv=`
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
  }`,UP=`
  attribute float paint;
  uniform vec3 colours[4];
  uniform vec3 sky;
  uniform vec3 ground;
  varying vec3 vColour;
  const vec3 SUN = vec3(0.332, -0.443, 0.831);
  void main() {
    vec3 n = normalize(normal);
    vec3 linear = (paint < 2.5 ? colours[0] : colours[3]) * (mix(ground, sky, 0.5 + 0.5 * n.z) + 0.75 * max(dot(n, SUN), 0.0));
    vColour = pow(linear, vec3(1.0 / 2.2));
    gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
  }`,OP=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function qd({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new fi({vertexShader:e?UP:NP,fragmentShader:e?OP:cv,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function uv(){let n=new fi({vertexShader:`
      attribute float paint;
      uniform vec3 colours[2];
      varying vec3 vColour;
      void main() {
        vColour = paint < 2.5 ? colours[0] : colours[1];
        gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
      }`,fragmentShader:`
      varying vec3 vColour;
      void main() {
        gl_FragColor = vec4(vColour, 0.85);
        #include <colorspace_fragment>
      }`,side:ri,transparent:!0,depthWrite:!1,uniforms:{colours:{value:[new ee,new ee]}}});return n.repaint=(...t)=>t.forEach((e,i)=>n.uniforms.colours.value[i].set(e)),n}function hv(n){let t=new fi({vertexShader:`
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
      }`,fragmentShader:cv.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?ir:pi,uniforms:{colour:{value:new ee},opacity:{value:1},gloss:{value:.14},sky:{value:new ee},ground:{value:new ee}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function mg(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Ae;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,u),c+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=dv(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let x=0;x<o[u].length;++x)f.push(o[u][x][d]);let p=dv(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(p)}}}return l}function dv(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new ze(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let x=u.getComponent(d,p);a.setComponent(d+h,p,x)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var FP=Array.from({length:12},(n,t)=>[Math.cos(t*Math.PI/6),Math.sin(t*Math.PI/6)]),BP=[.75,1.5,2.4],fv=2,Xd=4,nl=M("div",{class:"labels","aria-hidden":"true"}),Hc=new Map,co=null;function mv(n,t){let e=Hc.get(n)??[],i=t.map(({text:s,at:r,wish:o},a)=>{let l=e[a]??{el:nl.appendChild(M("span",{class:"label"})),stands:null};return l.text!==s&&(l.text=l.el.textContent=s,l.width=null),Object.assign(l,{at:r,wish:o})});for(let s of e.slice(t.length))s.el.remove();Hc.set(n,i),xe()}function gv(n){n.prepend(nl),Hd(kP),nt("theme",()=>{for(let t of[...Hc.values()].flat())t.width=null;co=null}),new ResizeObserver(([t])=>{co=[t.contentRect.width,t.contentRect.height],xe()}).observe(nl)}var Yd=new G;function _v(n){return Yd.set(...n).project(Ie),Yd.z<1?[(Yd.x+1)/2*co[0],(1-Yd.y)/2*co[1]]:null}var pv=(n,t)=>Math.max(0,Math.min(n[2],t[2])-Math.max(n[0],t[0]))*Math.max(0,Math.min(n[3],t[3])-Math.max(n[1],t[1]));function kP(){co??=[nl.clientWidth,nl.clientHeight],Ie.updateMatrixWorld();let n=[...Hc.values()].flat();for(let i of n)i.point=_v(i.at),i.width===null&&(i.width=i.el.offsetWidth,i.height=i.el.offsetHeight);let t=n.filter(i=>i.point).map(({point:[i,s]})=>[i-Xd,s-Xd,i+Xd,s+Xd]),e=[];for(let i of n){let s=i.point&&zP(i,e,t);if(i.box=s?s.box:null,i.stands=s?s.key:null,i.el.hidden=!s,!s)continue;e.push(s.box.map((o,a)=>o+(a<2?-fv:fv)));let r=`translate(${Math.round(s.box[0])}px, ${Math.round(s.box[1])}px)`;r!==i.where&&i.el.style.setProperty("transform",i.where=r)}}function zP({point:n,width:t,height:e,wish:i,stands:s},r,o){let[a,l]=n;if(a<0||l<0||a>co[0]||l>co[1])return null;let c=i&&_v(i),u=c&&Math.hypot(c[0]-a,c[1]-l)||1,h=c?[(c[0]-a)/u,(c[1]-l)/u]:[0,-1],d=null;return BP.forEach((f,p)=>{FP.forEach(([x,m],g)=>{let _=a+x*(f*e+t/2),T=l+m*f*e*1.35,v=[_-t/2,T-e/2,_+t/2,T+e/2],A=t*e-pv(v,[0,0,...co]),S=[...r,...o].reduce((U,L)=>U+pv(v,L),A),y=`${p}.${g}`,w=100*S+2*p+(1-x*h[0]-m*h[1])-(y===s?.8:0);(!d||w<d.cost)&&(d={cost:w,box:v,key:y})})}),d}var gg=()=>[...Hc.values()].flat().map(({text:n,box:t,point:e})=>({text:n,box:t,point:e}));function xv(n,t){let e=getComputedStyle(nl);n.font=`600 ${parseFloat(e.fontSize)*t}px ${e.fontFamily}`,Object.assign(n,{textAlign:"center",textBaseline:"middle",lineJoin:"round",lineWidth:4*t}),n.strokeStyle=Ft.ground,n.fillStyle=Ft.ink;for(let{text:i,box:s}of gg()){if(!s)continue;let r=[(s[0]+s[2])/2*t,(s[1]+s[3])/2*t];n.strokeText(i,...r),n.fillText(i,...r)}}var Dr=Nd.axes;function _g(n,t){let e=new Ri(.028,.028,.82,8).translate(0,.41,0),i=new Oo(.085,.22,12).translate(0,.9,0),s=mg([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new ze(o,3)),s}var xg=n=>new _e().makeRotationFromQuaternion(new dn().setFromUnitVectors(new G(0,1,0),new G(...n))),GP=mg([_g(Dr[0],xg([1,0,0])),_g(Dr[1],xg([0,1,0])),_g(Dr[2],xg([0,0,1]))]),il=class{constructor(){this.group=new Rn,this.mesh=new fc(GP,new si({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.group.add(this.mesh)}show(t,e,i=[]){this.last=[t,e];let s=new _e;this.mesh.count=t.length,t.forEach(({T:o},a)=>this.mesh.setMatrixAt(a,s.set(...o).scale(new G(e,e,e))));let r=(o,a)=>o[a+3]-e*.4*(o[a]+o[a+1]+o[a+2]);mv(this,[...t.map(({T:o,name:a})=>({text:a,at:[o[3],o[7],o[11]],wish:[0,4,8].map(l=>r(o,l))})),...i]),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}};var vg=180/Math.PI,Gi={angle:"deg",length:"mm"},VP={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},yg={deg:vg,rad:1,mm:1e3,m:1},WP={deg:2,rad:4,mm:2,m:5},$P={deg:1,rad:.02,mm:5,m:.005},gt={get angle(){return Gi.angle},get length(){return Gi.length},set(n,t){t in yg&&n in Gi&&(Gi[n]=t)},factor:n=>n in Gi?yg[Gi[n]]:1,symbol:n=>n in Gi?VP[Gi[n]]:"",digits:n=>n in Gi?WP[Gi[n]]:4,step:n=>n in Gi?$P[Gi[n]]/yg[Gi[n]]:.01,suffix:n=>n==="angle"?{deg:vg,"\xB0":vg,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ei(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var mn=(n,t,e=gt.digits(t))=>ei(n*gt.factor(t),e),he=(n,t,e)=>`${mn(n,t,e)}${t==="angle"&&Gi.angle==="deg"?"":" "}${gt.symbol(t)}`,Gc=(n,t="plain")=>String(Number((n*gt.factor(t)).toPrecision(9))+0),jd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function sl(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||gt.digits(t))/gt.factor(t)}var qP={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},XP={theta:(n,t,e)=>`turn by \u03B8${n} = ${he(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${he(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${he(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${he(t,"angle")} about x`};function yv(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=qP[n.convention],o=_r(n.joints[i],xr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:T_(n.convention,a.a,a.alpha,a.d,a.theta)}}function vv(){let n=M("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>Ut(o,{"aria-label":a},()=>i(l())),e=()=>4*b.table.joints.length-1,i=o=>{b.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ut("frames")},s=M("details",{class:"fold","data-testid":"dh-steps"},M("summary",{text:"The frames, one step at a time"}),M("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(b.dhStep??1)-1),t("On","One step on",()=>(b.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(b.dhStep===null||!b.table.joints.length){b.dhStep=null,bt(n,"");return}b.dhStep=Math.min(b.dhStep,e());let{i:o,key:a,value:l}=yv(b.table,b.q,b.dhStep),c=b.table.convention==="standard"?o:o+1;bt(n,`Joint ${o+1}, ${b.dhStep%4+1} of 4: ${XP[a](o+1,l,c)}`)};return nt(["q","table","units"],()=>b.dhStep!==null&&r()),nt("panel",o=>{o!=="table"&&b.dhStep!==null&&(s.open=!1,i(null))}),s}function Zd(){let{i:n,A:t}=yv(b.table,b.q,b.dhStep);return[...b.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:Hn(b.frames[n],t),name:`\u2192 ${n+1}`}]}var bg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],rl=n=>[Math.cos(n),Math.sin(n)];function YP([n,t,e]){let[i,s]=rl(e),[r,o]=rl(t),[a,l]=rl(n);return bg([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function jP(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function ZP([n,t,e]){let[i,s]=rl(n),[r,o]=rl(t),[a,l]=rl(e);return bg([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function JP(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Jd(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function Vc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return bg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function KP(n){let[t,e,i,s]=Jd(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function QP([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:Vc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Ds={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:jP,from:YP},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:JP,from:ZP},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:KP,from:QP},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Jd,from:Vc}};function bv(n,t,e){let i=Ds[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Kd(n,t,e){let i=Jd(n),s=Jd(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=Vc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var ol=.145,ef=.105,Cg=.165,Mv={mouse:13,pen:16,touch:28},tI=.2,fo=["x","y","z"],$c=72,Vo=new Rn,tf=new Map,Eg="both",nf="local",Pg=0,Nr=!1,Tg=null,tn=null,sf=()=>tn!==null,Av=()=>Nr,uo=null,ho=null;function Rv(){Vo.visible=!1,pn.add(Vo),Hd(Ig),ho=document.getElementById("view"),uo=M("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(uo),ho.addEventListener("pointerdown",aI,!0),ho.addEventListener("pointermove",cI,!0);for(let n of["pointerup","pointercancel"])ho.addEventListener(n,Ov,!0);addEventListener("keydown",n=>n.key==="Escape"&&tn&&hI()),nt(["target","theme"],xe)}function Wc(n,t,e=8){let i=new si({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new je(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var eI=[new dn().setFromUnitVectors(new G(0,1,0),new G(1,0,0)),new dn,new dn().setFromUnitVectors(new G(0,1,0),new G(0,0,1))],nI=[new dn().setFromUnitVectors(new G(0,0,1),new G(1,0,0)),new dn().setFromUnitVectors(new G(0,0,1),new G(0,1,0)),new dn];function iI(){if(tf.size)return;let n=(t,e)=>{tf.set(t,e),Vo.add(e)};fo.forEach((t,e)=>{let i=new Ri(.0032,.0032,ol*.8,8).translate(0,ol*.45,0),s=new Oo(.0125,.034,14).translate(0,ol*.9,0),r=new Rn;r.add(Wc(i,Dr[e]),Wc(s,Dr[e])),r.userData.turn=eI[e],n(`move-${t}`,r);let o=Wc(new Ga(ef,.0026,6,$c),Dr[e],7);o.userData.turn=nI[e],n(`turn-${t}`,o)}),n("turn-view",Wc(new Ga(Cg,.0022,6,$c),"#8891a0",7)),n("move-view",Wc(new Cs(.0115,14,10),"#8891a0",9))}var Qd=new G,po=new G,Mg=new dn;function rf(){return 2*Math.tan(lo.degToRad(Ie.fov/2))*Ie.position.distanceTo(Qd)}var Xc=()=>nf==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):sI(),sI=()=>[0,1,2].map(n=>Ys(b.target,n)),rI=new _e;function Ig(){if(Vo.visible=Nr,!Nr)return;Qd.set(...te(b.target)),po.copy(Ie.position).sub(Qd).normalize(),nf==="world"?Mg.identity():Mg.setFromRotationMatrix(rI.set(...b.target)),Vo.position.copy(Qd),Vo.scale.setScalar(rf());let n=Xc();for(let[t,e]of tf){let[i,s]=t.split("-"),r=fo.indexOf(s),o=Eg==="both"||Eg===i;e.visible=o&&oI(i,n[r])&&(!tn||tn.name===t),s==="view"?e.quaternion.copy(Ie.quaternion):e.quaternion.copy(Mg).multiply(e.userData.turn);let a=t===(tn?.name??Tg);e.traverse(l=>l.material?.color.set(a?Ft.accent:l.userData.colour))}}function oI(n,t){return!t||n!=="move"?!0:Math.hypot(...Cv(t,po.toArray()))>tI}var Cv=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],qc=(n,t)=>te(b.target).map((e,i)=>e+t*n[i]);function Ag(n,t){let e=Xc(),[i,s]=n<0?[Sv(Ie.matrixWorld,0),Sv(Ie.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:$c+1},(r,o)=>{let a=2*Math.PI*o/$c,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:qc(l,t),front:n<0||l.reduce((c,u,h)=>c+u*po.getComponent(h),0)>-.15}})}var Sv=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function wv(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function Rg(n,t){let e=rf(),i=[];for(let[s,r]of tf){if(!r.visible)continue;let[o,a]=s.split("-"),l=fo.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=Hi(te(b.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=Xc()[l],h=Hi(qc(u,.92*ol*e));c=Math.min(wv(n,t,Hi(qc(u,.3*ol*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Ag(l,(l<0?Cg:ef)*e).map(h=>({...h,s:Hi(h.p)}));for(let h=0;h<$c;h++)u[h].front&&(c=Math.min(c,wv(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Pv(n){if(!Nr)return null;Ig();let[t]=Rg(n.clientX,n.clientY);return t&&t[1]<=(Mv[n.pointerType]??Mv.mouse)?t[0]:null}function Iv(){if(!Nr)return{};Ig();let n=rf(),t=Xc(),e={"move-view":Hi(te(b.target))};return fo.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>Hi(qc(t[s],c*ol*n))).find(([c,u])=>Rg(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=Ag(s,ef*n).filter(c=>c.front).map(c=>Hi(c.p)).filter(([c,u])=>Rg(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=Hi(Ag(-1,Cg*n)[9].p),e}var Ev=new Sc,Tv=new Qt;function Lv(n){let t=ss.domElement.getBoundingClientRect();return Tv.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),Ev.setFromCamera(Tv,Ie),Ev.ray}function Dv(n,t,e){let{origin:i,direction:s}=Lv(e),r=new G(...n),o=new G(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function Nv(n,t,e){let i=new ii().setFromNormalAndCoplanarPoint(n,new G(...t));return Lv(e).intersectPlane(i,new G)}function aI(n){if(n.button!==0)return;let t=Pv(n);if(!t)return;n.stopPropagation(),n.preventDefault(),ho.focus({preventScroll:!0}),ho.setPointerCapture(n.pointerId),fn.enabled=!1;let[e,i]=t.split("-"),s=fo.indexOf(i),r=s<0?po.toArray():Xc()[s].slice();tn={name:t,what:e,axis:r,i:s,T:b.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},tn.start=e==="turn"?Uv(n):s<0?Nv(po,te(tn.T),n):Dv(r,te(tn.T),n),xe()}function Uv(n){let[t,e]=Hi(te(tn.T)),i=tn.axis.reduce((h,d,f)=>h+d*po.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Cv(tn.axis,po.toArray()),r=rf(),o=Hi(te(tn.T)),a=Hi(qc(s,ef*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-tn.x)*l+(n.clientY-tn.y)*c)/(u*u)}var lI=n=>Math.atan2(Math.sin(n),Math.cos(n)),Sg=(n,t,e)=>{let i=Pg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function cI(n){if(!tn){if(n.buttons||!Nr)return;let l=Pv(n);l!==Tg&&(Tg=l,ho.style.setProperty("cursor",l?"grab":""),xe());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=tn,r=nf==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Uv(n);tn.total+=lI(l-(tn.before??tn.start)),tn.before=l;let c=Sg(tn.total,n,Math.PI/180),u=Math.sin(c/2);o=Hn(Vc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${wg(c,"angle")} about ${s<0?"the line of sight":r+fo[s]}`}else if(s<0){let l=Nv(po,te(t),n);if(!l)return;let c=l.sub(tn.start);(Pg||n.shiftKey)&&c.set(...c.toArray().map(u=>Sg(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${fo[h]} ${wg(u,"length")}`).join(", ")}else{let l=Sg(Dv(e,te(t),n)-tn.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${wg(l,"length")} along ${r}${fo[s]}`}Si(o,"drag"),uI(a,n),xe()}var wg=(n,t)=>`${n>=0?"+":""}${he(n,t,gt.digits(t))}`;function uI(n,t){let e=ho.getBoundingClientRect();uo.hidden=!1,bt(uo,n),uo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-uo.offsetWidth-8)}px`),uo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Ov(n){tn&&(n.stopPropagation(),tn=null,uo.hidden=!0,fn.enabled=!0,Si(b.target,"dropped"),xe())}function hI(){let{T:n}=tn;Si(n,"drag"),Ov({stopPropagation(){}})}function Fv(){Nr&&iI(),Vo.visible=Nr,ut("frames"),xe()}function Bv(n){Nr=n,Fv()}function kv(n){Eg=n,Fv()}function zv(n){nf=n,xe()}function Hv(n){Pg=n}var qv=qd(),Vv=[.32,-.4,1],lf=new si({color:"#000",transparent:!0,opacity:.1,side:pi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Am,stencilRef:1,stencilZPass:Tm,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),Ng=new _e().set(1,0,-Vv[0],0,0,1,-Vv[1],0,0,0,0,5e-4,0,0,0,1),al=new je(new _c(1,40),new fi({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));al.renderOrder=-1;function dI(){let n=b.frames[0],t=2*(Ns.radius[0]??0);al.visible=b.table.joints.length>0&&Math.abs(n[11])<.02*Ns.size&&n[10]>.99,al.position.set(n[3],n[7],4e-4*Ns.size),al.scale.set(1.6*t,1.6*t,1)}var Jc=new el(qv,{shadow:{material:lf,matrix:Ng}});function Xv(n,t){Jc.shown(n,n&&!t)}var Yv=qd({opacity:.1,veil:!0}),jv=uv(),jc=new el(Yv,{veil:!0,rim:jv}),Zv=qd({opacity:.62,gloss:.1}),Dg=new el(Zv,{veil:!0}),Ug=new il,Ns=Vd(b.table),cf=[],af=null;function Jv(){pn.add(al,Jc.group,jc.group,Dg.group,Ug.group),jc.group.renderOrder=1,nt("table",n=>{Ns=Vd(b.table),lg(Ns.size),cf=[],af=null,Og(),hf(),n==="new"&&Kc({instant:!0,view:"iso"}),Ky()}),nt("q",pI),nt("frames",tb),nt("theme",$v),nt("hurry",n=>{for(let t of[Jc,jc,Dg])t.hurry(n)}),$v()}var Wv=new Map,Zc=[],Lg=0;function Or(n,t){if(Wv.set(n,t),Zc=[...Wv.values()].flat(),!b.table.joints.length)return;let e=Lg;Lg=Zc.length,og([...kc(b.table,b.frames),...Zc]),t.length?Qv():e>Lg&&fI()}var fI=Js(iv,120);function Kv(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Or("motion",i.flatMap(s=>kc(n,Ss(n,s))))}function Kc(n){Gd([...kc(b.table,b.frames),...Zc],n)}var Qv=Js(Qa,220);function pI(){let n=b.frames;Jc.show(b.table.joints.length?[ug(b.table,n,Ns,b.q)]:[]),dI(),og([...kc(b.table,n),...Zc]),Qv(),ab&&gI(te(n[n.length-1])),tb()}function tb(){let n=(b.shownFrames??[]).filter(t=>t<b.frames.length&&!(t===b.frames.length-1&&Av())).map(t=>({T:b.frames[t],name:uf(t)}));Ug.show(b.dhStep===null?n:Zd(),Ns.size*.13),xe()}var eb=()=>Jc.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),nb=()=>(Ug.last?.[0]??[]).map(n=>n.name);function uf(n){let t=b.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function ib(n){cf=n,Og()}function ps(n){af=n,Og()}var sb=()=>cf.length,rb=()=>jc.arms.filter(n=>n.outside).length,mI=.0035;function Og(){let n=t=>({...ug(b.table,Ss(b.table,t),Ns),outside:b.table.joints.some((e,i)=>Bc(e,t[i])),rim:mI*Ns.size});jc.show(cf.map(n)),Dg.show(af?[n(af)]:[]),xe()}var ob=6e3,of=new Float32Array(6*ob),Ur=new No(new Ae,new ts({fog:!1}));Ur.geometry.setAttribute("position",new ze(of,3));Ur.frustumCulled=!1;Ur.visible=!1;var mo=0,ab=!0,Yc=null;pn.add(Ur);function gI(n){let t=Yc?Ni(Di(n,Yc)):1/0;t<Ns.size*.002||(t<Ns.size*.2&&(mo===ob&&(of.copyWithin(0,6*1e3),mo-=1e3),of.set(Yc,6*mo),of.set(n,6*mo+3),mo+=1,Ur.geometry.setDrawRange(0,2*mo),Ur.geometry.attributes.position.needsUpdate=!0,Ur.visible=!0),Yc=n)}function lb(n){ab=n,n||hf(),xe()}function hf(){mo=0,Yc=null,Ur.visible=!1,xe()}var cb=()=>mo,Qc=new er(new Ae,new ts({fog:!1}));Qc.frustumCulled=!1;var tu=new Rr(new Ae,new nr({size:4,sizeAttenuation:!1,fog:!1}));tu.frustumCulled=!1;Qc.visible=tu.visible=!1;pn.add(Qc,tu);function Wo(n){Or("path",n);let t=new Float32Array(n.flat());for(let e of[Qc,tu])e.geometry.dispose(),e.geometry=new Ae,e.geometry.setAttribute("position",new ze(t,3)),e.visible=n.length>0;xe()}function $v(){qv.repaint(Ft.link,Ft.joint,Ft.accent,Ft.dark,Ft.wrong),Yv.repaint(Ft.ghost,Ft.ghost,Ft.ghost,Ft.dark,Ft.wrong),jv.repaint(Ft.ghost,Ft.wrong),Zv.repaint(Ft.accent,Ft.accent,Ft.accent,Ft.dark),Ur.material.color.set(Ft.accent),Qc.material.color.set(Ft.trace),tu.material.color.set(Ft.trace),lf.opacity=Ft.dark?.28:.11,al.material.uniforms.strength.value=Ft.dark?.75:.34,xe()}var de={follow:!0,ghosts:"all",task:null,redundancy:null},Fg={answers:0},df=!1,ub=js(async()=>{let n=df;df=!1;let t=b.target,e=b.table;try{let i=sf()||Bg,s=i?null:b.digits,{task:r,redundancy:o}=de,a=await Fe("ik",{T:t,q:b.q,brief:i,task:r,redundancy:o,digits:s});if(e!==b.table||t!==b.target&&!i)return;Fg.answers+=1,b.solutions={...a,T:t,brief:i},n&&de.follow&&a.nearest&&Ui(a.nearest,"follow"),ll(),ut("solutions"),!i&&!a.rows.some(l=>l.inside)&&yI(t),a.self_motions===null&&!i&&xI(b.solutions)}catch(i){if(i instanceof Du)return;b.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},ll(),ut("solutions")}}),Bg=!1;function hb(){Bg=!0,df=!0,ub()}function Us({follow:n=!1}={}){Bg=!1,df||=n,ub()}var xI=js(async n=>{try{let t={T:n.T,q:b.q,task:de.task,redundancy:de.redundancy},{self_motions:e}=await Fe("self_motions",t);if(b.solutions!==n||!e)return;n.self_motions=e,ut("solutions")}catch{}}),yI=js(async n=>{try{let t=await Fe("nearest",{T:n,task:de.task});b.solutions&&b.solutions.T===n&&(b.solutions.near=t,ut("solutions"))}catch{}}),vI=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function ll(){let n=b.solutions?.rows??[],t=b.panel==="inverse"&&de.ghosts!=="none"?n.filter(e=>(de.ghosts==="all"||e.inside)&&!vI(e.q,b.q)):[];ib(t.map(e=>e.q))}function db(){nt("target",n=>{b.panel==="inverse"&&Us({follow:I_.has(n)})}),nt("task",()=>{ut("plan"),b.panel==="inverse"&&b.hasTarget&&Us()}),nt("panel",n=>{ps(null),n==="inverse"&&b.hasTarget&&!b.solutions&&Us(),ll()}),nt("moving",n=>{n||ll()}),nt("table",n=>{de.redundancy=null,n==="new"&&(de.task=null),ut("solutions"),n!=="new"&&b.panel==="inverse"&&b.hasTarget&&Us()}),nt("online",n=>{n&&b.panel==="inverse"&&b.hasTarget&&b.table.joints.length&&Us()})}var eu=0;function gi(){eu+=1,b.moving&&(b.moving=!1,ut("moving",!1))}function Ci(n,t=.8,e="move to a posture"){gi(),ut("let-go"),ut("did",{label:e});let i=b.q.slice(),s=eu,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),b.moving=!0,ut("moving",!0),new Promise(o=>{(function a(l){if(s!==eu||i.length!==b.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Ui(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(b.moving=!1,ut("moving",!1),o(!0))})(r)})}function fb(n,t,e,i){gi();let s=eu,r=performance.now()-1e3*n*t;b.moving=!0,ut("moving",!0),requestAnimationFrame(function o(a){if(s!==eu){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(b.moving=!1,ut("moving",!1),i?.(!0))})}var MI=200,SI=1500,$o=[],su=[],iu=null,nu={key:null,at:0,open:!1},kg=!1,ff=()=>({table:b.table,q:b.q,target:b.target,digits:b.digits,hasTarget:b.hasTarget,path:{...b.path},sequence:structuredClone(b.sequence),program:b.program,world:b.world,limits:b.limits,start:b.start,routing:b.routing,task:de.task,redundancy:de.redundancy});function zg(){kg||(kg=!0,queueMicrotask(()=>{kg=!1,iu=ff()}))}function wI({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===nu.key&&(nu.open||i-nu.at<SI))&&iu&&($o.push({label:n,before:iu}),$o.length>MI&&$o.shift(),su.length=0),nu={key:t,at:i,open:e},zg(),ut("history")}function Hg(){nu={key:null,at:0,open:!1}}function EI(n){gi(),Hg(),de.task=n.task,n.table!==b.table?yn(n.table,{q:n.q,step:!1,what:"undo"}):Ui(n.q,"undo"),de.redundancy=n.redundancy,Object.assign(b.path,n.path),b.sequence=structuredClone(n.sequence),b.program=n.program,b.world=n.world,b.limits=n.limits,b.start=n.start;let t=b.routing!==n.routing;b.routing=n.routing,b.hasTarget=n.hasTarget,n.target!==b.target&&Si(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ut(e,"undo");t&&ut("routing","undo")}function pb(n,t,e){let i=n.pop();if(!i)return;let s=ff();EI(i.before),t.push({label:i.label,before:s}),zg(),ut("history"),Me(`${e}: ${i.label}`)}var Gg=()=>pb($o,su,"Undone"),Vg=()=>pb(su,$o,"Redone"),pf=()=>$o.at(-1)?.label??null,mf=()=>su.at(-1)?.label??null;function gf(){$o.length=0,su.length=0,Hg(),iu=ff(),ut("history")}function mb(){iu=ff(),nt("did",wI),nt("let-go",Hg),nt(["table","q","target","path","sequence","program","world","task","routing"],zg)}var xb=1,yb=30;function _f(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=b;return{pieper:xb,table:n,q:t,target:i?e:null,digits:b.digits,task:de.task,redundancy:de.redundancy,follow:de.follow,ghosts:de.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:b.program,start:b.start,limits:b.limits},world:b.world,routing:b.routing,look:b.look,panel:l,theme:c,units:[gt.angle,gt.length],camera:tl()}}var $n=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,_s=(n,t)=>Array.isArray(n)&&n.length===t&&n.every($n),ms=(n,t)=>typeof n=="string"?n.slice(0,t):"",gs=n=>{if(!_s(n,16))return null;let t=Cu(n);return t<1e-12?n.slice():t<.001?Pu(n):null},AI=n=>n&&$n(n.metres)&&$n(n.radians)?{metres:n.metres,radians:n.radians}:null,RI=n=>n&&[n.lower,n.upper,n.value].every($n)&&n.lower<=n.upper?{name:ms(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:ms(n.unit,10)}:null,CI=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>_s(e,t))?n:null;function PI(n){if(!n||!Array.isArray(n.joints)||n.joints.length>yb||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>$n(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:ms(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:$n(i.lower)?i.lower:null,upper:$n(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>_s(i,t.length)).slice(0,40));return{name:ms(n.name,60),convention:n.convention,joints:t,base:gs(n.base)??ji(),tool:gs(n.tool)??ji(),postures:e,manufacturer:ms(n.manufacturer,200),source:ms(n.source,2e3),notes:ms(n.notes,3e3),actuator:RI(n.actuator),catalog:ms(n.catalog,60)||void 0,derived:ms(n.derived,60)||void 0,coupling:CI(n.coupling,t.length)}}var gb={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function II(n,t){if(!n||!Object.hasOwn(gb,n.kind))return null;let e=gb[n.kind];if(e)return $n(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(l=>Number.isInteger(l)&&l>=1&&l<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return gs(n.T)?{kind:"frame",T:gs(n.T)}:null;let i=n.kind==="joint"&&_s(n.q,t)?n.q.slice():null,s=gs(n.T),r=n.kind==="circle"&&_s(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!gs(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(gs):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(l,c)=>c===null?{}:{[l]:c};return{kind:n.kind,...a("q",i),T:s,...a("via",gs(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",$n(n.speed)&&n.speed>0?n.speed:null),blend:$n(n.blend)&&n.blend>=0?n.blend:0}}var Wg={frame:[],box:["size"],cylinder:["r","h"]};function LI(n){if(!n||!Object.hasOwn(Wg,n.kind))return null;let t=gs(n.T),e=ms(n.name,40),i=s=>s==="size"?_s(n.size,3)&&n.size.every(r=>r>0):$n(n[s])&&n[s]>0;return!t||!e||!Wg[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(Wg[n.kind].map(s=>[s,n[s]]))}}function DI(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&$n(s.turn)&&_s(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:ms(s.branch,80)}:null,i=(s,r)=>$n(s)&&s>=0&&s<r?s:0;return{turn:_s(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function NI(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};b.program=e(i.steps,s=>II(s,t),200),b.start=_s(i.start,t)?i.start.slice():null,b.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||$n(r)&&r>0))),b.world=e(n.world,LI,60),b.routing=DI(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&$n(n.look.opacity)&&(b.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function xf(n,t){let e=n&&n.pieper===xb?PI(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(gt.set("angle",n.units[0]),gt.set("length",n.units[1])),Object.hasOwn(Ds,n.notation)&&(b.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Od(n.theme),b.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};yn(e,{q:_s(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(b.path,{from:gs(s.from),to:gs(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:$n(s.seconds)&&s.seconds>0?s.seconds:5}),b.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&_s(a.q,i)&&$n(a.seconds)&&$n(a.hold)).slice(0,40).map(a=>({name:ms(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),NI(n,i),["pose","position","position+axis"].includes(n.task)&&(de.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&$n(l));de.redundancy=r.length?Object.fromEntries(r.slice(0,yb)):null,typeof n.follow=="boolean"&&(de.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(de.ghosts=n.ghosts);let o=gs(n.target);b.hasTarget=!!o,o&&Si(o,"restored",AI(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ut(a);t(n.panel),ut("path-loaded"),ut("routing","loaded"),ut("look","loaded"),_s(n.camera,6)&&sv(n.camera),Ui(b.q,"restored"),gf()}async function vb(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function yf(){let n=await vb(new TextEncoder().encode(JSON.stringify(_f())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function bb(){let n=UI();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await vb(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var Mb="pieper-workbench";function UI(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(Mb)??"{}");return t&&n===location.href?t:null}catch{return null}}function OI(){if(b.table.joints.length)try{sessionStorage.setItem(Mb,JSON.stringify({address:location.href,shown:_f()}))}catch{}}var _b=null,FI=Js(async()=>{if(!b.table.joints.length)return;let n=await yf();n!==_b&&(_b=n,history.replaceState(null,"",n))},600);function Sb(){addEventListener("pagehide",OI),nt(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],FI)}var $g={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},wb={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},vf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,Eb=80;function kI(n){let t=[];vf.lastIndex=0;let e=n.trimEnd();for(;vf.lastIndex<e.length;){let i=vf.lastIndex,s=vf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function zI(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function bf(n,t="plain"){let e=zI(String(n));if(e.length>Eb)throw new Error(`longer than ${Eb} characters`);let i=kI(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in gt.suffix(t)&&(s=gt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=g=>i[o]?.sign===g,c=g=>{if(!l(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;l("+")||l("-");){let _=i[o++].sign,T=h();g=_==="+"?g+T:g-T}return g}function h(){let g=d();for(;;)if(l("*"))o++,g*=d();else if(l("/"))o++,g/=d();else if(i[o]?.word||l("("))g*=f();else return g}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let g=p();return l("^")?(o++,g**d()):g}function p(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let _=u();return c(")"),_}if(g.word){let _=g.word.toLowerCase();if(Object.hasOwn(wb,_))return a=!0,wb[_];if(Object.hasOwn($g,_)){c("(");let T=u();return c(")"),$g[_](T)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys($g).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let x=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(x))throw new Error("not a finite number");let m=s??(t==="angle"&&a?1:gt.factor(t));return{value:x/m+0,symbolic:a||s!==null||i.length>2}}function Mn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=M("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let m=bf(c.value,l()),g=a?.(m.value);if(g)throw new Error(g);return m},f=m=>{c.classList.toggle("wrong",!!m),m?(c.setAttribute("aria-invalid","true"),c.title=m):(c.removeAttribute("aria-invalid"),c.title=o??""),qg(c,m),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:m?{label:n,reason:m}:null}))},p=m=>{try{let g=d();return f(null),m?.(g.value,{symbolic:g.symbolic,text:c.value.trim()}),!0}catch(g){return f(g.message),!1}};c.addEventListener("input",()=>p(e)),c.addEventListener("change",()=>{p(i??e)&&c.blurred?.()});let x="";return c.addEventListener("focus",()=>{x=c.value,c.classList.contains("wrong")&&qg(c,c.title),c.select()}),c.addEventListener("blur",()=>qg(c,null)),c.addEventListener("keydown",m=>{let g=c.closest("table.dh");if(m.key==="Escape"&&c.value!==x){m.preventDefault(),c.value=x,p(i??e),c.select();return}if(g&&HI(c,m))return;let _={ArrowUp:1,ArrowDown:-1}[m.key];if(m.key==="Enter"&&(x=c.value,c.select()),!(!_||g&&!m.altKey)){m.preventDefault();try{let T=d();c.value=Gc((T.value??0)+_*gt.step(l())*(m.shiftKey?.1:1),l()),p(i??e)}catch{}}}),c.put=(m,g=null)=>{document.activeElement===c&&!c.readOnly||m===u&&g===h&&!c.classList.contains("wrong")||(u=m,h=g,c.value=g??(m==null?"":Gc(m,l())),Xg(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>Xg(c)),c.refresh=()=>{let m=u,g=h;u=NaN,c.put(m,g)},c}function Xg(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&Xg(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Pi=null;function qg(n,t){if(!t){Pi&&Pi.about===n&&(Pi.hidden=!0),n.removeAttribute("aria-describedby");return}Pi||(Pi=M("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Pi)),Pi.about=n,Pi.hidden=!1,Pi.textContent!==t&&(Pi.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Pi.style.setProperty("top",`${e.bottom+4}px`),Pi.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Pi.offsetWidth-8))}px`)}addEventListener("scroll",()=>Pi&&(Pi.hidden=!0),!0);function HI(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function Mf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Sf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Ze=n=>n.type==="R"?"angle":"length";function Tb(n){let t=n.type==="R"?Math.PI:ci(b.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var GI=Bc;function VI(n){let t=b.table.joints[n],e=Ze(t),{lo:i,hi:s,min:r,max:o}=Tb(t),a=`q${n+1}`,l=M("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=x=>`${100*(x-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{gi(),Lu(n,Number(l.value))}),l.addEventListener("keydown",x=>{let m={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[x.key],g={Home:i,End:s}[x.key];if(m===void 0&&g===void 0)return;x.preventDefault(),gi();let _=gt.step(e)*(x.shiftKey?.1:1);Lu(n,g??Math.min(Math.max(Math.round((b.q[n]+m*_)/(_/10))*(_/10),r),o))});let u=Mn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:x=>{gi(),Lu(n,x)}}),h=M("span",{class:"out",role:"note"}),d=M("span",{class:"chain",title:"What this row of the table moves by"}),f=M("span",{class:"limits"}),p=M("div",{class:"joint","data-testid":`joint-${n+1}`},M("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},M("i",{text:"q"}),M("sub",{text:String(n+1)})),M("div",{class:"track"},l,M("div",{class:"under"},f,d,h)),u,M("span",{class:"unit"}));return{el:p,number:u,show(){let x=b.q[n],m=GI(t,x);(document.activeElement!==l||Number(l.value)!==x)&&(l.value=x),l.style.setProperty("--at",c(Math.min(Math.max(x,r),o))),l.setAttribute("aria-valuetext",he(x,e)),u.put(Number((x*gt.factor(e)).toFixed(gt.digits(e)+1))/gt.factor(e)),p.classList.toggle("outside",m!==0);let g=b.table.coupling?`chain ${he(xr(b.table,b.q)[n],e)}`:"";bt(d,g),bt(h,m?`${he(Math.abs(m),e)} ${m>0?"above":"below"} the limit`:"")},relabel(){bt(p.lastChild,gt.symbol(e));let x=m=>m===null?"no limit":he(m,e,gt.angle==="deg"&&e==="angle"?0:void 0);bt(f,t.lower===null&&t.upper===null?"no limits":`${x(t.lower)} \u2026 ${x(t.upper)}`),u.refresh(),this.show()}}}var Ab={id:"joints",title:"Joints",build(n){let t=[],e=M("div",{class:"joints","data-testid":"joints"}),i=M("div",{class:"chips",role:"group","aria-label":"Postures"}),s=M("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=b.table.joints.map((o,a)=>VI(a)),Wt(e,t.map(o=>o.el)),t.length||e.append(M("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Wt(s,b.table.actuator?WI(b.table.actuator):null),$I(i)};nt("table",o=>o!=="gripper"&&r()),nt("q",()=>t.forEach(o=>o.show())),nt("units",()=>t.forEach(o=>o.relabel())),r()}};function WI(n){let t=M("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=M("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),bt(e,ei(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},yn({...b.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=M("div",{class:"under"},M("span",{text:`${n.name}: moves no frame`}));return M("div",{class:"joint"},M("span",{class:"joint-name",text:"tool"}),M("div",{class:"track"},t,s),e,M("span",{class:"unit",text:n.unit}))}function $I(n){let t=b.table.joints.length,e=Object.entries(b.table.postures??{}),i=(r,o)=>Ut(r,{class:"chip",title:o.map((a,l)=>he(a,Ze(b.table.joints[l]))).join(", ")},()=>Ci(o,.8,`move to ${r}`)),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Wt(n,s,t?Ut("Random",{class:"chip quiet",title:"A posture inside the limits"},()=>Ci(qI(),.8,"move to a random posture")):null,t?Ut("Keep this one",{class:"chip quiet",title:"Add the present posture to the arm"},XI):null)}function qI(){return b.table.joints.map(n=>{let{lo:t,hi:e}=Tb(n);return t+Math.random()*(e-t)})}function XI(){let n={...b.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=b.q.slice(),yn({...b.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),Me(`Kept as P${t}: ${b.q.map((e,i)=>Gc(e,Ze(b.table.joints[i]))).join(", ")}`),ut("postures")}var Cb=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["accelerations","Accelerations"],["toolspeed","Tool speed"],["singularity","Distance to singularity"]];function cr({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o,ddq:a,events:l=[],title:c,...u}){let h=t.map(p=>Ss(n,p)),d=h.map(p=>te(p[p.length-1])),f=o??Yg(t,r);return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:l,title:c,...u,tool:d,speeds:f,accelerations:a??Yg(f,r),toolspeeds:Yg(d,r).map(Ni),least:t.map((p,x)=>Iu(n,p,h[x])[0]??0)}}function Yg(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}var YI=1e6;function jI(n,t,e){let i=n.table.joints[e];if(t==="joints")return[i.lower,i.upper];let s=n.limits?.[{speeds:"speed",accelerations:"acceleration"}[t]],r=Array.isArray(s)?s[e]:s??null;return r===null||r>=YI?[null,null]:[-r,r]}var ZI={speeds:"speed",accelerations:"acceleration",toolspeed:"tool speed"},Rb=(n,t,e=null)=>(n.tight??[]).filter(i=>i.limit===ZI[t]&&i.joint===e),Pb=(n,t)=>(n.tight??[]).filter(e=>e.start-1e-9<=t&&t<=e.end+1e-9).map(e=>e.joint?`${e.limit} of ${e.joint}`:e.limit).join(", ");function jg(n,t){let{table:e}=n,i=gt.factor("length");if(t==="position")return{y:`tool, ${gt.length}`,list:["X","Y","Z"].map((c,u)=>wf(c,n.tool.map(h=>h[u]*i)))};if(t==="singularity")return{y:"smallest singular value",list:[wf("\u03C3 min",n.least)]};if(t==="toolspeed"){let c=n.limits?.tool_speed??null,u=n.toolspeeds.map(h=>h*i);return{y:`tool, ${gt.length}/s`,list:[wf("tool speed",u,[null,c&&c*i],Rb(n,t))]}}let s={joints:n.q,speeds:n.speeds,accelerations:n.accelerations}[t],r={joints:"",speeds:"/s",accelerations:"/s\xB2"}[t],a=[...new Set(e.joints.map(Ze))].map(c=>(c==="angle"?gt.angle:gt.length)+r).join(" or "),l=e.joints.map((c,u)=>{let h=gt.factor(Ze(c));return wf(`q${u+1}`,s.map(d=>d[u]*h),jI(n,t,u).map(d=>d===null?null:d*h),Rb(n,t,c.name))});return{y:a,list:l}}var wf=(n,t,e=[null,null],i=[])=>({name:n,values:t,limits:e,binds:i});function ru(n){let t=n.flatMap((i,s)=>i.limits.filter(r=>r!==null).map(r=>({value:r,of:s}))),e=new Map;for(let i of t)e.set(i.value,[...e.get(i.value)??[],i.of]);return[...e].map(([i,s])=>({value:i,of:s.length===1&&n.length>1?s[0]:null}))}function Ib(n){let t=gt.angle,e=gt.length,{table:i}=n,s=l=>Ze(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*gt.factor("length")),...l.map((u,h)=>u*gt.factor(Ze(i.joints[h]))),...n.speeds[c].map((u,h)=>u*gt.factor(Ze(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function Lb(n,t,e){let{y:i,list:s}=jg(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(y=>y.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,p]=[Math.min(...c),Math.max(...c)];p-f>1e-9||(f-=1,p+=1);let x=y=>a.l+(y-h)/(d-h)*(r-a.l-a.r),m=y=>o-a.b-(y-f)/(p-f)*(o-a.t-a.b),g=(y,w)=>{let U=(w-y)/6,L=10**Math.floor(Math.log10(U)),N=[1,2,5,10].map(H=>H*L).find(H=>H>=U);return Array.from({length:12},(H,$)=>(Math.ceil(y/N)+$)*N).filter(H=>H<=w+N*1e-6)},_=y=>y.toFixed(2),T=y=>String(Number(y.toPrecision(6))),v=y=>y.replace(/[&<>"]/g,w=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[w]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],S=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let y of g(f,p))S.push(`<path d="M${a.l} ${_(m(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${_(m(y)+4)}" text-anchor="end">${T(y)}</text>`);for(let y of g(h,d))S.push(`<path d="M${_(x(y))} ${o-a.b}v5" stroke="#333"/><text x="${_(x(y))}" y="${o-a.b+20}" text-anchor="middle">${T(y)}</text>`);S.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&S.push(`<path d="M${_(x(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${_(x(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(y.short)}</text>`);for(let{value:y,of:w}of ru(s))y>=f&&y<=p&&S.push(`<path d="M${a.l} ${_(m(y))}H${r-a.r}" stroke="${w===null?"#333":e[w%e.length]}" stroke-dasharray="2 5"/>`);return s.forEach((y,w)=>{let U=e[w%e.length],L=y.values[y.values.length-1];S.push(`<polyline fill="none" stroke="${U}" stroke-width="1.8" stroke-dasharray="${A[w%A.length]}" points="${y.values.map((N,H)=>`${_(x(l[H]))},${_(m(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*w}h22" stroke="${U}" stroke-width="2" stroke-dasharray="${A[w%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*w}"><title>${_(L)}</title>${v(y.name)}</text>`)}),S.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${S.join("")}</svg>
`}var JI="uplot",KI="u-hz",QI="u-vt",t3="u-title",e3="u-wrap",n3="u-under",i3="u-over",s3="u-axis",Yo="u-off",r3="u-select",o3="u-cursor-x",a3="u-cursor-y",l3="u-cursor-pt",c3="u-legend",u3="u-live",h3="u-inline",d3="u-series",f3="u-marker",Db="u-label",p3="u-value",au="width",lu="height";var Nb="bottom",cl="left",Zg="right",f0="#000",Ub=f0+"0",Jg="mousemove",Ob="mousedown",Kg="mouseup",Fb="mouseenter",Bb="mouseleave",kb="dblclick",m3="resize",g3="scroll",zb="change",Cf="dppxchange",p0="--",gl=typeof window<"u",i0=gl?document:null,hl=gl?window:null,_3=gl?navigator:null,Ge,Ef;function s0(){let n=devicePixelRatio;Ge!=n&&(Ge=n,Ef&&o0(zb,Ef,s0),Ef=matchMedia(`(min-resolution: ${Ge-.001}dppx) and (max-resolution: ${Ge+.001}dppx)`),jo(zb,Ef,s0),hl.dispatchEvent(new CustomEvent(Cf)))}function rs(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function r0(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function gn(n,t,e){n.style[t]=e+"px"}function Os(n,t,e,i){let s=i0.createElement(n);return t!=null&&rs(s,t),e?.insertBefore(s,i),s}function xs(n,t){return Os("div",n,t)}var Hb=new WeakMap;function ur(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Hb.get(n);r!=o&&(n.style.transform=r,Hb.set(n,r),t<0||e<0||t>i||e>s?rs(n,Yo):r0(n,Yo))}var Gb=new WeakMap;function Vb(n,t,e){let i=t+e,s=Gb.get(n);i!=s&&(Gb.set(n,i),n.style.background=t,n.style.borderColor=e)}var Wb=new WeakMap;function $b(n,t,e,i){let s=t+""+e,r=Wb.get(n);s!=r&&(Wb.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var m0={passive:!0},x3={...m0,capture:!0};function jo(n,t,e,i){t.addEventListener(n,e,i?x3:m0)}function o0(n,t,e,i){t.removeEventListener(n,e,m0)}gl&&s0();function Fs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:os((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function yM(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var vM=n=>n!=null,bM=n=>n!=null&&n>0,Lf=yM(vM),y3=yM(bM);function v3(n,t,e,i=0,s=!1){let r=s?y3:Lf,o=s?bM:vM;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??en,l??-en]}function Df(n,t,e,i){let s=Yb(n),r=Yb(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Fr:MM,a=s==1?os:ys,l=r==1?ys:os,c=a(o(Xn(n))),u=l(o(Xn(t))),h=dl(e,c),d=dl(e,u);return e==10&&(c<0&&(h=nn(h,-c)),u<0&&(d=nn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=TM(n,h),t=Nf(t,d)),[n,t]}function g0(n,t,e,i){let s=Df(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var _0=.1,qb={mode:3,pad:_0},uu={pad:0,soft:null,mode:0},b3={min:uu,max:uu};function Pf(n,t,e,i){return Uf(e)?Xb(n,t,e):(uu.pad=e,uu.soft=i?0:null,uu.mode=i?3:0,Xb(n,t,b3))}function Be(n,t){return n??t}function M3(n,t,e){for(t=Be(t,0),e=Be(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Xb(n,t,e){let i=e.min,s=e.max,r=Be(i.pad,0),o=Be(s.pad,0),a=Be(i.hard,-en),l=Be(s.hard,en),c=Be(i.soft,en),u=Be(s.soft,-en),h=Be(i.mode,0),d=Be(s.mode,0),f=t-n,p=Fr(f),x=Ii(Xn(n),Xn(t)),m=Fr(x),g=Xn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=en&&(r=0),d==2&&u!=-en&&(o=0)));let _=f||x||1e3,T=Fr(_),v=dl(10,os(T)),A=_*(f==0?n==0?.1:1:r),S=nn(TM(n-A,v/10),24),y=n>=c&&(h==1||h==3&&S<=c||h==2&&S>=c)?c:en,w=Ii(a,S<y&&n>=y?y:Bs(y,S)),U=_*(f==0?t==0?.1:1:o),L=nn(Nf(t+U,v/10),24),N=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-en,H=Bs(l,L>N&&t<=N?N:Ii(N,L));return w==H&&w==0&&(H=100),[w,H]}var S3=new Intl.NumberFormat(gl?_3.language:"en-US"),x0=n=>S3.format(n),as=Math,Rf=as.PI,Xn=as.abs,os=as.floor,qn=as.round,ys=as.ceil,Bs=as.min,Ii=as.max,dl=as.pow,Yb=as.sign,Fr=as.log10,MM=as.log2,w3=(n,t=1)=>as.sinh(n)*t,Qg=(n,t=1)=>as.asinh(n/t),en=1/0;function jb(n){return(Fr((n^n>>31)-(n>>31))|0)+1}function a0(n,t,e){return Bs(Ii(n,t),e)}function SM(n){return typeof n=="function"}function Ne(n){return SM(n)?n:()=>n}var E3=()=>{},wM=n=>n,EM=(n,t)=>t,T3=n=>null,Zb=n=>!0,Jb=(n,t)=>n==t,A3=/\.\d*?(?=9{6,}|0{6,})/gm,Zo=n=>{if(RM(n)||_o.has(n))return n;let t=`${n}`,e=t.match(A3);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Zo(s)}e${r}`}return nn(n,i)};function qo(n,t){return Zo(nn(Zo(n/t))*t)}function Nf(n,t){return Zo(ys(Zo(n/t))*t)}function TM(n,t){return Zo(os(Zo(n/t))*t)}function nn(n,t=0){if(RM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return qn(i)/e}var _o=new Map;function AM(n){return((""+n).split(".")[1]||"").length}function du(n,t,e,i){let s=[],r=i.map(AM);for(let o=t;o<e;o++){let a=Xn(o),l=nn(dl(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:nn(u,h);s.push(d),_o.set(d,h)}}return s}var hu={},y0=[],fl=[null,null],go=Array.isArray,RM=Number.isInteger,R3=n=>n===void 0;function Kb(n){return typeof n=="string"}function Uf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function C3(n){return n!=null&&typeof n=="object"}var P3=Object.getPrototypeOf(Uint8Array),CM="__proto__";function pl(n,t=Uf){let e;if(go(n)){let i=n.find(s=>s!=null);if(go(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=pl(n[s],t)}else e=n.slice()}else if(n instanceof P3)e=n.slice();else if(t(n)){e={};for(let i in n)i!=CM&&(e[i]=pl(n[i],t))}else e=n;return e}function Bn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=CM&&(Uf(n[s])?Bn(n[s],pl(i[s])):n[s]=pl(i[s]))}return n}var I3=0,L3=1,D3=2;function N3(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function U3(n,t){if(B3(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return k3(o[0])||(o=F3(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:L3,f=[];for(let p=0;p<u.length;p++){let x=u[p],m=r.get(l[p]);x===null?d!=I3&&(h[m]=x,d==D3&&f.push(m)):h[m]=x}N3(h,f,s),i.push(h)}}return i}var O3=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function F3(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function B3(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function k3(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Ii(1,os((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var PM=["January","February","March","April","May","June","July","August","September","October","November","December"],IM=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function LM(n){return n.slice(0,3)}var z3=IM.map(LM),H3=PM.map(LM),G3={MMMM:PM,MMM:H3,WWWW:IM,WWW:z3};function ou(n){return(n<10?"0":"")+n}function V3(n){return(n<10?"00":n<100?"0":"")+n}var W3={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ou(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ou(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ou(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ou(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ou(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>V3(n.getMilliseconds())};function v0(n,t){t=t||G3;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?W3[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var $3=new Intl.DateTimeFormat().resolvedOptions().timeZone;function q3(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==$3?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var DM=n=>n%1==0,If=[1,2,2.5,5],X3=du(10,-32,0,If),NM=du(10,0,32,If),Y3=NM.filter(DM),Xo=X3.concat(NM),b0=`
`,UM="{YYYY}",Qb=b0+UM,OM="{M}/{D}",cu=b0+OM,Tf=cu+"/{YY}",FM="{aa}",j3="{h}:{mm}",ul=j3+FM,tM=b0+ul,eM=":{ss}",$e=null;function BM(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?du(10,0,3,If).filter(DM):du(10,-3,0,If)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,UM,$e,$e,$e,$e,$e,$e,1],[s*28,"{MMM}",Qb,$e,$e,$e,$e,$e,1],[s,OM,Qb,$e,$e,$e,$e,$e,1],[i,"{h}"+FM,Tf,$e,cu,$e,$e,$e,1],[e,ul,Tf,$e,cu,$e,$e,$e,1],[t,eM,Tf+" "+ul,$e,cu+" "+ul,$e,tM,$e,1],[n,eM+".{fff}",Tf+" "+ul,$e,cu+" "+ul,$e,tM,$e,1]];function u(h){return(d,f,p,x,m,g)=>{let _=[],T=m>=o,v=m>=r&&m<o,A=h(p),S=nn(A*n,3),y=t0(A.getFullYear(),T?0:A.getMonth(),v||T?1:A.getDate()),w=nn(y*n,3);if(v||T){let U=v?m/r:0,L=T?m/o:0,N=S==w?S:nn(t0(y.getFullYear()+L,y.getMonth()+U,1)*n,3),H=new Date(qn(N/n)),$=H.getFullYear(),P=H.getMonth();for(let z=0;N<=x;z++){let D=t0($+L*z,P+U*z,1),B=D-h(nn(D*n,3));N=nn((+D+B)*n,3),N<=x&&_.push(N)}}else{let U=m>=s?s:m,L=os(p)-os(S),N=w+L+Nf(S-w,U);_.push(N);let H=h(N),$=H.getHours()+H.getMinutes()/e+H.getSeconds()/i,P=m/i,z=d.axes[f]._space,D=g/z;for(;N=nn(N+m,n==1?0:3),!(N>x);)if(P>1){let B=os(nn($+P,6))%24,Z=h(N).getHours()-B;Z>1&&(Z=-1),N-=Z*i,$=($+P)%24;let et=_[_.length-1];nn((N-et)/m,3)*D>=.7&&_.push(N)}else _.push(N)}return _}}return[l,c,u]}var[Z3,J3,K3]=BM(1),[Q3,t2,e2]=BM(.001);du(2,-53,53,[1]);function nM(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function iM(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let x=n(p),m=x.getFullYear(),g=x.getMonth(),_=x.getDate(),T=x.getHours(),v=x.getMinutes(),A=x.getSeconds(),S=m!=l&&a[2]||g!=c&&a[3]||_!=u&&a[4]||T!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,u=_,h=T,d=v,f=A,S(x)})}}function n2(n,t){let e=v0(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function t0(n,t,e){return new Date(n,t,e)}function sM(n,t){return t(n)}var i2="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function rM(n,t){return(e,i,s,r)=>r==null?p0:t(n(i))}function s2(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function r2(n,t){return n.series[t].fill(n,t)}var o2={show:!0,live:!0,isolate:!1,mount:E3,markers:{show:!0,width:2,stroke:s2,fill:r2,dash:"solid"},idx:null,idxs:null,values:[]};function a2(n,t){let e=n.cursor.points,i=xs(),s=e.size(n,t);gn(i,au,s),gn(i,lu,s);let r=s/-2;gn(i,"marginLeft",r),gn(i,"marginTop",r);let o=e.width(n,t,s);return o&&gn(i,"borderWidth",o),i}function l2(n,t){let e=n.series[t].points;return e._fill||e._stroke}function c2(n,t){let e=n.series[t].points;return e._stroke||e._fill}function u2(n,t){return n.series[t].points.size}var e0=[0,0];function h2(n,t,e){return e0[0]=t,e0[1]=e,e0}function Af(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function n0(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var d2={show:!0,x:!0,y:!0,lock:!1,move:h2,points:{one:!1,show:a2,size:u2,width:0,stroke:c2,fill:l2},bind:{mousedown:Af,mouseup:Af,click:Af,dblclick:Af,mousemove:n0,mouseleave:n0,mouseenter:n0},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},kM={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},M0=Bn({},kM,{filter:EM}),zM=Bn({},M0,{size:10}),HM=Bn({},kM,{show:!1}),S0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',GM="bold "+S0,VM=1.5,oM={show:!0,scale:"x",stroke:f0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:GM,side:2,grid:M0,ticks:zM,border:HM,font:S0,lineGap:VM,rotate:0},f2="Value",p2="Time",aM={show:!0,scale:"x",auto:!1,sorted:1,min:en,max:-en,idxs:[]};function m2(n,t,e,i,s){return t.map(r=>r==null?"":x0(r))}function g2(n,t,e,i,s,r,o){let a=[],l=_o.get(s)||0;e=o?e:nn(Nf(e,s),l);for(let c=e;c<=i;c=nn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function l0(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Fr:MM,u=os(c(e));s=dl(l,u),l==10&&(s=Xo[Fs(s,Xo)]);let h=e,d=s*l;l==10&&(d=Xo[Fs(d,Xo)]);do a.push(h),h=h+s,l==10&&!_o.has(h)&&(h=nn(h,_o.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Xo[Fs(d,Xo)]));while(h<=i);return a}function _2(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?l0(n,t,Ii(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?l0(n,t,Ii(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var WM=/./,x2=/[12357]/,y2=/[125]/,lM=/1/,c0=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function v2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?WM:l(7,o)-u>=c?x2:l(5,o)-u>=c?y2:lM;if(h==lM){let d=Xn(l(1,o)-u);if(d<c)return c0(t.slice().reverse(),a.distr,h,ys(c/d)).reverse()}return c0(t,a.distr,h,1)}function b2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Xn(l(1,o)-l(2,o));return c<a?c0(t.slice().reverse(),3,WM,ys(a/c)).reverse():t}function M2(n,t,e,i){return i==null?p0:t==null?"":x0(t)}var cM={show:!0,scale:"y",stroke:f0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:GM,side:3,grid:M0,ticks:zM,border:HM,font:S0,lineGap:VM,rotate:0};function S2(n,t){let e=3+(n||1)*2;return nn(e*t,3)}function w2(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Xn(o-r),l=n.series[t],c=a/(l.points.space*Ge);return i[1]-i[0]<=c}var uM={scale:null,auto:!0,sorted:0,min:en,max:-en},$M=(n,t,e,i,s)=>s,hM={show:!0,auto:!0,sorted:0,gaps:$M,alpha:1,facets:[Bn({},uM,{scale:"x"}),Bn({},uM,{scale:"y"})]},dM={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:$M,alpha:1,points:{show:w2,filter:null},values:null,min:en,max:-en,idxs:[],path:null,clip:null};function E2(n,t,e,i,s){return e/10}var qM={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},T2=Bn({},qM,{time:!1,ori:1}),fM={};function XM(n,t){let e=fM[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(fM[n]=e)),e}var ml=1,u0=2;function Jo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,g,d,f,p,x,Ff,_l,kf,jM,JM):e(s,l,c,u,h,g,m,f,d,x,p,Bf,xl,T0,ZM,KM)}function w0(n,t){let e=0,i=0,s=Be(n.bands,y0);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function A2(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Br(n,t,e,i,s,r){return Jo(n,t,(o,a,l,c,u,h,d,f,p,x,m)=>{let g=o.pxRound,_=c.dir*(c.ori==0?1:-1),T=c.ori==0?_l:xl,v,A;_==1?(v=e,A=i):(v=i,A=e);let S=g(h(a[v],c,x,f)),y=g(d(l[v],u,m,p)),w=g(h(a[A],c,x,f)),U=g(d(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return T(L,w,U),T(L,S,U),T(L,S,y),L})}function Of(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?kf:T0,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function R2(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function E0(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function pM(n){return n==0?wM:n==1?qn:t=>qo(t,n)}function YM(n){let t=n==0?Ff:Bf,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Bs(c,a/2,l/2),u=Bs(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Ff=(n,t,e)=>{n.moveTo(t,e)},Bf=(n,t,e)=>{n.moveTo(e,t)},_l=(n,t,e)=>{n.lineTo(t,e)},xl=(n,t,e)=>{n.lineTo(e,t)},kf=YM(0),T0=YM(1),jM=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},ZM=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},JM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},KM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function QM(n){return(t,e,i,s,r)=>Jo(t,e,(o,a,l,c,u,h,d,f,p,x,m)=>{let{pxRound:g,points:_}=o,T,v;c.ori==0?(T=Ff,v=jM):(T=Bf,v=ZM);let A=nn(_.width*Ge,3),S=(_.size-_.width)/2*Ge,y=nn(S*2,3),w=new Path2D,U=new Path2D,{left:L,top:N,width:H,height:$}=t.bbox;kf(U,L-y,N-y,H+y*2,$+y*2);let P=z=>{if(l[z]!=null){let D=g(h(a[z],c,x,f)),B=g(d(l[z],u,m,p));T(w,D+S,B),v(w,D,B,S,0,Rf*2)}};if(r)r.forEach(P);else for(let z=i;z<=s;z++)P(z);return{stroke:A>0?w:null,fill:w,clip:U,flags:ml|u0}})}function tS(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var C2=tS(_l),P2=tS(xl);function eS(n){let t=Be(n?.alignGaps,0);return(e,i,s,r)=>Jo(e,i,(o,a,l,c,u,h,d,f,p,x,m)=>{[s,r]=Lf(l,s,r);let g=o.pxRound,_=$=>g(h($,c,x,f)),T=$=>g(d($,u,m,p)),v,A;c.ori==0?(v=_l,A=C2):(v=xl,A=P2);let S=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ml},w=y.stroke,U=!1;if(r-s>=x*4){let $=ft=>e.posToVal(ft,c.key,!0),P=null,z=null,D,B,Q,Y=_(a[S==1?s:r]),Z=_(a[s]),et=_(a[r]),dt=$(S==1?Z+1:et-1);for(let ft=S==1?s:r;ft>=s&&ft<=r;ft+=S){let st=a[ft],_t=(S==1?st<dt:st>dt)?Y:_(st),Tt=l[ft];_t==Y?Tt!=null?(B=Tt,P==null?(v(w,_t,T(B)),D=P=z=B):B<P?P=B:B>z&&(z=B)):Tt===null&&(U=!0):(P!=null&&A(w,Y,T(P),T(z),T(D),T(B)),Tt!=null?(B=Tt,v(w,_t,T(B)),P=z=D=B):(P=z=null,Tt===null&&(U=!0)),Y=_t,dt=$(Y+S))}P!=null&&P!=z&&Q!=Y&&A(w,Y,T(P),T(z),T(D),T(B))}else for(let $=S==1?s:r;$>=s&&$<=r;$+=S){let P=l[$];P===null?U=!0:P!=null&&v(w,_(a[$]),T(P))}let[N,H]=w0(e,i);if(o.fill!=null||N!=0){let $=y.fill=new Path2D(w),P=o.fillTo(e,i,o.min,o.max,N),z=T(P),D=_(a[s]),B=_(a[r]);S==-1&&([B,D]=[D,B]),v($,B,z),v($,D,z)}if(!o.spanGaps){let $=[];U&&$.push(...E0(a,l,s,r,S,_,t)),y.gaps=$=o.gaps(e,i,s,r,$),y.clip=Of($,c.ori,f,p,x,m)}return H!=0&&(y.band=H==2?[Br(e,i,s,r,w,-1),Br(e,i,s,r,w,1)]:Br(e,i,s,r,w,H)),y})}function I2(n){let t=Be(n.align,1),e=Be(n.ascDesc,!1),i=Be(n.alignGaps,0),s=Be(n.extend,!1);return(r,o,a,l)=>Jo(r,o,(c,u,h,d,f,p,x,m,g,_,T)=>{[a,l]=Lf(h,a,l);let v=c.pxRound,{left:A,width:S}=r.bbox,y=Z=>v(p(Z,d,_,m)),w=Z=>v(x(Z,f,T,g)),U=d.ori==0?_l:xl,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ml},N=L.stroke,H=d.dir*(d.ori==0?1:-1),$=w(h[H==1?a:l]),P=y(u[H==1?a:l]),z=P,D=P;s&&t==-1&&(D=A,U(N,D,$)),U(N,P,$);for(let Z=H==1?a:l;Z>=a&&Z<=l;Z+=H){let et=h[Z];if(et==null)continue;let dt=y(u[Z]),ft=w(et);t==1?U(N,dt,$):U(N,z,ft),U(N,dt,ft),$=ft,z=dt}let B=z;s&&t==1&&(B=A+S,U(N,B,$));let[Q,Y]=w0(r,o);if(c.fill!=null||Q!=0){let Z=L.fill=new Path2D(N),et=c.fillTo(r,o,c.min,c.max,Q),dt=w(et);U(Z,B,dt),U(Z,D,dt)}if(!c.spanGaps){let Z=[];Z.push(...E0(u,h,a,l,H,y,i));let et=c.width*Ge/2,dt=e||t==1?et:-et,ft=e||t==-1?-et:et;Z.forEach(st=>{st[0]+=dt,st[1]+=ft}),L.gaps=Z=c.gaps(r,o,a,l,Z),L.clip=Of(Z,d.ori,m,g,_,T)}return Y!=0&&(L.band=Y==2?[Br(r,o,a,l,N,-1),Br(r,o,a,l,N,1)]:Br(r,o,a,l,N,Y)),L})}function mM(n,t,e,i,s,r,o=en){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Xn(n[l]-n[a]);u<c&&(c=u,o=Xn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function L2(n){n=n||hu;let t=Be(n.size,[.6,en,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ne(s),o=1-t[0],a=Be(t[1],en),l=Be(t[2],1),c=Be(n.disp,hu),u=Be(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,x,m)=>Jo(f,p,(g,_,T,v,A,S,y,w,U,L,N)=>{let H=g.pxRound,$=e,P=i*Ge,z=a*Ge,D=l*Ge,B,Q;v.ori==0?[B,Q]=r(f,p):[Q,B]=r(f,p);let Y=v.dir*(v.ori==0?1:-1),Z=v.ori==0?kf:T0,et=v.ori==0?u:(Nt,se,ge,Ct,Qe,Yt,ne)=>{u(Nt,se,ge,Qe,Ct,ne,Yt)},dt=Be(f.bands,y0).find(Nt=>Nt.series[0]==p),ft=dt!=null?dt.dir:0,st=g.fillTo(f,p,g.min,g.max,ft),yt=H(y(st,A,N,U)),_t,Tt,At,Jt=L,me=H(g.width*Ge),jt=!1,we=null,ve=null,fe=null,_n=null;h!=null&&(me==0||d!=null)&&(jt=!0,we=h.values(f,p,x,m),ve=new Map,new Set(we).forEach(Nt=>{Nt!=null&&ve.set(Nt,new Path2D)}),me>0&&(fe=d.values(f,p,x,m),_n=new Map,new Set(fe).forEach(Nt=>{Nt!=null&&_n.set(Nt,new Path2D)})));let{x0:rn,size:In}=c;if(rn!=null&&In!=null){$=1,_=rn.values(f,p,x,m),rn.unit==2&&(_=_.map(ge=>f.posToVal(w+ge*L,v.key,!0)));let Nt=In.values(f,p,x,m);In.unit==2?Tt=Nt[0]*L:Tt=S(Nt[0],v,L,w)-S(0,v,L,w),Jt=mM(_,T,S,v,L,w,Jt),At=Jt-Tt+P}else Jt=mM(_,T,S,v,L,w,Jt),At=Jt*o+P,Tt=Jt-At;At<1&&(At=0),me>=Tt/2&&(me=0),At<5&&(H=wM);let Je=At>0,Yn=Jt-At-(Je?me:0);Tt=H(a0(Yn,D,z)),_t=($==0?Tt/2:$==Y?0:Tt)-$*Y*(($==0?P/2:0)+(Je?me/2:0));let Ue={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kn=jt?null:new Path2D,Sn=null;if(dt!=null)Sn=f.data[dt.series[1]];else{let{y0:Nt,y1:se}=c;Nt!=null&&se!=null&&(T=se.values(f,p,x,m),Sn=Nt.values(f,p,x,m))}let Ln=B*Tt,W=Q*Tt;for(let Nt=Y==1?x:m;Nt>=x&&Nt<=m;Nt+=Y){let se=T[Nt];if(se==null)continue;if(Sn!=null){let j=Sn[Nt]??0;if(se-j==0)continue;yt=y(j,A,N,U)}let ge=v.distr!=2||c!=null?_[Nt]:Nt,Ct=S(ge,v,L,w),Qe=y(Be(se,st),A,N,U),Yt=H(Ct-_t),ne=H(Ii(Qe,yt)),O=H(Bs(Qe,yt)),R=ne-O;if(se!=null){let j=se<0?W:Ln,mt=se<0?Ln:W;jt?(me>0&&fe[Nt]!=null&&Z(_n.get(fe[Nt]),Yt,O+os(me/2),Tt,Ii(0,R-me),j,mt),we[Nt]!=null&&Z(ve.get(we[Nt]),Yt,O+os(me/2),Tt,Ii(0,R-me),j,mt)):Z(kn,Yt,O+os(me/2),Tt,Ii(0,R-me),j,mt),et(f,p,Nt,Yt-me/2,O,Tt+me,R)}}return me>0?Ue.stroke=jt?_n:kn:jt||(Ue._fill=g.width==0?g._fill:g._stroke??g._fill,Ue.width=0),Ue.fill=jt?ve:kn,Ue})}function D2(n,t){let e=Be(t?.alignGaps,0);return(i,s,r,o)=>Jo(i,s,(a,l,c,u,h,d,f,p,x,m,g)=>{[r,o]=Lf(c,r,o);let _=a.pxRound,T=B=>_(d(B,u,m,p)),v=B=>_(f(B,h,g,x)),A,S,y;u.ori==0?(A=Ff,y=_l,S=JM):(A=Bf,y=xl,S=KM);let w=u.dir*(u.ori==0?1:-1),U=T(l[w==1?r:o]),L=U,N=[],H=[];for(let B=w==1?r:o;B>=r&&B<=o;B+=w)if(c[B]!=null){let Y=l[B],Z=T(Y);N.push(L=Z),H.push(v(c[B]))}let $={stroke:n(N,H,A,y,S,_),fill:null,clip:null,band:null,gaps:null,flags:ml},P=$.stroke,[z,D]=w0(i,s);if(a.fill!=null||z!=0){let B=$.fill=new Path2D(P),Q=a.fillTo(i,s,a.min,a.max,z),Y=v(Q);y(B,L,Y),y(B,U,Y)}if(!a.spanGaps){let B=[];B.push(...E0(l,c,r,o,w,T,e)),$.gaps=B=a.gaps(i,s,r,o,B),$.clip=Of(B,u.ori,p,x,m,g)}return D!=0&&($.band=D==2?[Br(i,s,r,o,P,-1),Br(i,s,r,o,P,1)]:Br(i,s,r,o,P,D)),$})}function N2(n){return D2(U2,n)}function U2(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var h0=new Set;function gM(){for(let n of h0)n.syncRect(!0)}gl&&(jo(m3,hl,gM),jo(g3,hl,gM,!0),jo(Cf,hl,()=>{oi.pxRatio=Ge}));var O2=eS(),F2=QM();function _M(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>d0(r,o,t,e))}function B2(n,t){return n.map((e,i)=>i==0?{}:Bn({},t,e))}function d0(n,t,e,i){return Bn({},t==0?e:i,n)}function nS(n,t,e){return t==null?fl:[t,e]}var k2=nS;function z2(n,t,e){return t==null?fl:Pf(t,e,_0,!0)}function iS(n,t,e,i){return t==null?fl:Df(t,e,n.scales[i].log,!1)}var H2=iS;function sS(n,t,e,i){return t==null?fl:g0(t,e,n.scales[i].log,!1)}var G2=sS;function V2(n,t,e,i,s){let r=Ii(jb(n),jb(t)),o=t-n,a=Fs(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?_o.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function xM(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=qn((e=+s)*Ge))+"px"),[n,t,e]}function W2(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=nn(t[2]*Ge,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function oi(n,t,e){let i={mode:Be(n.mode,1)},s=i.mode;function r(E,C,F,k){let X=C.valToPct(E);return k+F*(C.dir==-1?1-X:X)}function o(E,C,F,k){let X=C.valToPct(E);return k+F*(C.dir==-1?X:1-X)}function a(E,C,F,k){return C.ori==0?r(E,C,F,k):o(E,C,F,k)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=xs(JI);if(n.id!=null&&(c.id=n.id),rs(c,n.class),n.title){let E=xs(t3,c);E.textContent=n.title}let u=Os("canvas"),h=i.ctx=u.getContext("2d"),d=xs(e3,c);jo("click",d,E=>{E.target===p&&(an!=ca||xn!=ua)&&ni.click(i,E)},!0);let f=i.under=xs(n3,d);d.appendChild(u);let p=i.over=xs(i3,d);n=pl(n);let x=+Be(n.pxAlign,1),m=pM(x);(n.plugins||[]).forEach(E=>{E.opts&&(n=E.opts(i,n)||n)});let g=n.ms||.001,_=i.series=s==1?_M(n.series||[],aM,dM,!1):B2(n.series||[null],hM),T=i.axes=_M(n.axes||[],oM,cM,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(E=>{E.fill=Ne(E.fill||null),E.dir=Be(E.dir,-1)});let S=s==2?_[1].facets[0].scale:_[0].scale,y={axes:mr,series:Ce},w=(n.drawOrder||["axes","series"]).map(E=>y[E]);function U(E){let C=E.distr==3?F=>Fr(F>0?F:E.clamp(i,F,E.min,E.max,E.key)):E.distr==4?F=>Qg(F,E.asinh):E.distr==100?F=>E.fwd(F):F=>F;return F=>{let k=C(F),{_min:X,_max:tt}=E,ht=tt-X;return(k-X)/ht}}function L(E){let C=v[E];if(C==null){let F=(n.scales||hu)[E]||hu;if(F.from!=null){L(F.from);let k=Bn({},v[F.from],F,{key:E});k.valToPct=U(k),v[E]=k}else{C=v[E]=Bn({},E==S?qM:T2,F),C.key=E;let k=C.time,X=C.range,tt=go(X);if((E!=S||s==2&&!k)&&(tt&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?qb:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?qb:{mode:1,hard:X[1],soft:X[1]}},tt=!1),!tt&&Uf(X))){let ht=X;X=(xt,Et,zt)=>Et==null?fl:Pf(Et,zt,ht)}C.range=Ne(X||(k?k2:E==S?C.distr==3?H2:C.distr==4?G2:nS:C.distr==3?iS:C.distr==4?sS:z2)),C.auto=Ne(tt?!1:C.auto),C.clamp=Ne(C.clamp||E2),C._min=C._max=null,C.valToPct=U(C)}}}L("x"),L("y"),s==1&&_.forEach(E=>{L(E.scale)}),T.forEach(E=>{L(E.scale)});for(let E in n.scales)L(E);let N=v[S],H=N.distr,$,P;N.ori==0?(rs(c,KI),$=r,P=o):(rs(c,QI),$=o,P=r);let z={};for(let E in v){let C=v[E];(C.min!=null||C.max!=null)&&(z[E]={min:C.min,max:C.max},C.min=C.max=null)}let D=n.tzDate||(E=>new Date(qn(E/g))),B=n.fmtDate||v0,Q=g==1?K3(D):e2(D),Y=iM(D,nM(g==1?J3:t2,B)),Z=rM(D,sM(i2,B)),et=[],dt=i.legend=Bn({},o2,n.legend),ft=i.cursor=Bn({},d2,{drag:{y:s==2}},n.cursor),st=dt.show,yt=ft.show,_t=dt.markers;dt.idxs=et,_t.width=Ne(_t.width),_t.dash=Ne(_t.dash),_t.stroke=Ne(_t.stroke),_t.fill=Ne(_t.fill);let Tt,At,Jt,me=[],jt=[],we,ve=!1,fe={};if(dt.live){let E=_[1]?_[1].values:null;ve=E!=null,we=ve?E(i,1,0):{_:0};for(let C in we)fe[C]=p0}if(st)if(Tt=Os("table",c3,c),Jt=Os("tbody",null,Tt),dt.mount(i,Tt),ve){At=Os("thead",null,Tt,Jt);let E=Os("tr",null,At);Os("th",null,E);for(var _n in we)Os("th",Db,E).textContent=_n}else rs(Tt,h3),dt.live&&rs(Tt,u3);let rn={show:!0},In={show:!1};function Je(E,C){if(C==0&&(ve||!dt.live||s==2))return fl;let F=[],k=Os("tr",d3,Jt,Jt.childNodes[C]);rs(k,E.class),E.show||rs(k,Yo);let X=Os("th",null,k);if(_t.show){let xt=xs(f3,X);if(C>0){let Et=_t.width(i,C);Et&&(xt.style.border=Et+"px "+_t.dash(i,C)+" "+_t.stroke(i,C)),xt.style.background=_t.fill(i,C)}}let tt=xs(Db,X);E.label instanceof HTMLElement?tt.appendChild(E.label):tt.textContent=E.label,C>0&&(_t.show||(tt.style.color=E.width>0?_t.stroke(i,C):_t.fill(i,C)),Ue("click",X,xt=>{if(ft._lock)return;oe(xt);let Et=_.indexOf(E);if((xt.ctrlKey||xt.metaKey)!=dt.isolate){let zt=_.some((Ht,Vt)=>Vt>0&&Vt!=Et&&Ht.show);_.forEach((Ht,Vt)=>{Vt>0&&Ws(Vt,zt?Vt==Et?rn:In:rn,!0,On.setSeries)})}else Ws(Et,{show:!E.show},!0,On.setSeries)},!1),ae&&Ue(Fb,X,xt=>{ft._lock||(oe(xt),Ws(_.indexOf(E),da,!0,On.setSeries))},!1));for(var ht in we){let xt=Os("td",p3,k);xt.textContent="--",F.push(xt)}return[k,F]}let Yn=new Map;function Ue(E,C,F,k=!0){let X=Yn.get(C)||{},tt=ft.bind[E](i,C,F,k);tt&&(jo(E,C,X[E]=tt),Yn.set(C,X))}function kn(E,C,F){let k=Yn.get(C)||{};for(let X in k)(E==null||X==E)&&(o0(X,C,k[X]),delete k[X]);E==null&&Yn.delete(C)}let Sn=0,Ln=0,W=0,Nt=0,se=0,ge=0,Ct=se,Qe=ge,Yt=W,ne=Nt,O=0,R=0,j=0,mt=0;i.bbox={};let ct=!1,St=!1,wt=!1,rt=!1,at=!1,vt=!1;function V(E,C,F){(F||E!=i.width||C!=i.height)&&lt(E,C),be(!1),wt=!0,St=!0,li()}function lt(E,C){i.width=Sn=W=E,i.height=Ln=Nt=C,se=ge=0,Rt(),Zt();let F=i.bbox;O=F.left=qo(se*Ge,.5),R=F.top=qo(ge*Ge,.5),j=F.width=qo(W*Ge,.5),mt=F.height=qo(Nt*Ge,.5)}let ot=3;function Pt(){let E=!1,C=0;for(;!E;){C++;let F=oa(C),k=Vs(C);E=C==ot||F&&k,E||(lt(i.width,i.height),St=!0)}}function Mt({width:E,height:C}){V(E,C)}i.setSize=Mt;function Rt(){let E=!1,C=!1,F=!1,k=!1;T.forEach((X,tt)=>{if(X.show&&X._show){let{side:ht,_size:xt}=X,Et=ht%2,zt=X.label!=null?X.labelSize:0,Ht=xt+zt;Ht>0&&(Et?(W-=Ht,ht==3?(se+=Ht,k=!0):F=!0):(Nt-=Ht,ht==0?(ge+=Ht,E=!0):C=!0))}}),Hs[0]=E,Hs[1]=F,Hs[2]=C,Hs[3]=k,W-=vs[1]+vs[3],se+=vs[3],Nt-=vs[2]+vs[0],ge+=vs[0]}function Zt(){let E=se+W,C=ge+Nt,F=se,k=ge;function X(tt,ht){switch(tt){case 1:return E+=ht,E-ht;case 2:return C+=ht,C-ht;case 3:return F-=ht,F+ht;case 0:return k-=ht,k+ht}}T.forEach((tt,ht)=>{if(tt.show&&tt._show){let xt=tt.side;tt._pos=X(xt,tt._size),tt.label!=null&&(tt._lpos=X(xt,tt.labelSize))}})}if(ft.dataIdx==null){let E=ft.hover,C=E.skip=new Set(E.skip??[]);C.add(void 0);let F=E.prox=Ne(E.prox),k=E.bias??=0;ft.dataIdx=(X,tt,ht,xt)=>{if(tt==0)return ht;let Et=ht,zt=F(X,tt,ht,xt)??en,Ht=zt>=0&&zt<en,Vt=N.ori==0?W:Nt,pe=ft.left,ke=t[0],Oe=t[tt];if(C.has(Oe[ht])){Et=null;let Pe=null,re=null,Kt;if(k==0||k==-1)for(Kt=ht;Pe==null&&Kt-- >0;)C.has(Oe[Kt])||(Pe=Kt);if(k==0||k==1)for(Kt=ht;re==null&&Kt++<Oe.length;)C.has(Oe[Kt])||(re=Kt);if(Pe!=null||re!=null)if(Ht){let cn=Pe==null?-1/0:$(ke[Pe],N,Vt,0),Tn=re==null?1/0:$(ke[re],N,Vt,0),Kn=pe-cn,Ke=Tn-pe;Kn<=Ke?Kn<=zt&&(Et=Pe):Ke<=zt&&(Et=re)}else Et=re==null?Pe:Pe==null?re:ht-Pe<=re-ht?Pe:re}else Ht&&Xn(pe-$(ke[ht],N,Vt,0))>zt&&(Et=null);return Et}}let oe=E=>{ft.event=E};ft.idxs=et,ft._lock=!1;let pt=ft.points;pt.show=Ne(pt.show),pt.size=Ne(pt.size),pt.stroke=Ne(pt.stroke),pt.width=Ne(pt.width),pt.fill=Ne(pt.fill);let $t=i.focus=Bn({},n.focus||{alpha:.3},ft.focus),ae=$t.prox>=0,Dt=ae&&pt.one,ye=[],on=[],xi=[];function Ul(E,C){let F=pt.show(i,C);if(F instanceof HTMLElement)return rs(F,l3),rs(F,E.class),ur(F,-10,-10,W,Nt),p.insertBefore(F,ye[C]),F}function ia(E,C){if(s==1||C>0){let F=s==1&&v[E.scale].time,k=E.value;E.value=F?Kb(k)?rM(D,sM(k,B)):k||Z:k||M2,E.label=E.label||(F?p2:f2)}if(Dt||C>0){E.width=E.width==null?1:E.width,E.paths=E.paths||O2||T3,E.fillTo=Ne(E.fillTo||A2),E.pxAlign=+Be(E.pxAlign,x),E.pxRound=pM(E.pxAlign),E.stroke=Ne(E.stroke||null),E.fill=Ne(E.fill||null),E._stroke=E._fill=E._paths=E._focus=null;let F=S2(Ii(1,E.width),1),k=E.points=Bn({},{size:F,width:Ii(1,F*.2),stroke:E.stroke,space:F*2,paths:F2,_stroke:null,_fill:null},E.points);k.show=Ne(k.show),k.filter=Ne(k.filter),k.fill=Ne(k.fill),k.stroke=Ne(k.stroke),k.paths=Ne(k.paths),k.pxAlign=E.pxAlign}if(st){let F=Je(E,C);me.splice(C,0,F[0]),jt.splice(C,0,F[1]),dt.values.push(null)}if(yt){et.splice(C,0,null);let F=null;Dt?C==0&&(F=Ul(E,C)):C>0&&(F=Ul(E,C)),ye.splice(C,0,F),on.splice(C,0,0),xi.splice(C,0,0)}Jn("addSeries",C)}function mp(E,C){C=C??_.length,E=s==1?d0(E,C,aM,dM):d0(E,C,{},hM),_.splice(C,0,E),ia(_[C],C)}i.addSeries=mp;function wu(E){if(_.splice(E,1),st){dt.values.splice(E,1),jt.splice(E,1);let C=me.splice(E,1)[0];kn(null,C.firstChild),C.remove()}yt&&(et.splice(E,1),ye.splice(E,1)[0].remove(),on.splice(E,1),xi.splice(E,1)),Jn("delSeries",E)}i.delSeries=wu;let Hs=[!1,!1,!1,!1];function dr(E,C){if(E._show=E.show,E.show){let F=E.side%2,k=v[E.scale];k==null&&(E.scale=F?_[1].scale:S,k=v[E.scale]);let X=k.time;E.size=Ne(E.size),E.space=Ne(E.space),E.rotate=Ne(E.rotate),go(E.incrs)&&E.incrs.forEach(ht=>{!_o.has(ht)&&_o.set(ht,AM(ht))}),E.incrs=Ne(E.incrs||(k.distr==2?Y3:X?g==1?Z3:Q3:Xo)),E.splits=Ne(E.splits||(X&&k.distr==1?Q:k.distr==3?l0:k.distr==4?_2:g2)),E.stroke=Ne(E.stroke),E.grid.stroke=Ne(E.grid.stroke),E.ticks.stroke=Ne(E.ticks.stroke),E.border.stroke=Ne(E.border.stroke);let tt=E.values;E.values=go(tt)&&!go(tt[0])?Ne(tt):X?go(tt)?iM(D,nM(tt,B)):Kb(tt)?n2(D,tt):tt||Y:tt||m2,E.filter=Ne(E.filter||(k.distr>=3&&k.log==10?v2:k.distr==3&&k.log==2?b2:EM)),E.font=xM(E.font),E.labelFont=xM(E.labelFont),E._size=E.size(i,null,C,0),E._space=E._rotate=E._incrs=E._found=E._splits=E._values=null,E._size>0&&(Hs[C]=!0,E._el=xs(s3,d))}}function fr(E,C,F,k){let[X,tt,ht,xt]=F,Et=C%2,zt=0;return Et==0&&(xt||tt)&&(zt=C==0&&!X||C==2&&!ht?qn(oM.size/3):0),Et==1&&(X||ht)&&(zt=C==1&&!tt||C==3&&!xt?qn(cM.size/2):0),zt}let Ol=i.padding=(n.padding||[fr,fr,fr,fr]).map(E=>Ne(Be(E,fr))),vs=i._padding=Ol.map((E,C)=>E(i,C,Hs,0)),wn,Cn=null,Pn=null,Gs=s==1?_[0].idxs:null,$i=null,Hr=!1;function Fl(E,C){if(t=E??[],i.data=i._data=t,s==2){wn=0;for(let F=1;F<_.length;F++)wn+=t[F][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),$i=t[0],wn=$i.length;let F=t;if(H==2){F=t.slice();let k=F[0]=Array(wn);for(let X=0;X<wn;X++)k[X]=X}i._data=t=F}if(be(!0),Jn("setData"),H==2&&(wt=!0),C!==!1){let F=N;F.auto(i,Hr)?Bl():Wr(S,F.min,F.max),rt=rt||ft.left>=0,vt=!0,li()}}i.setData=Fl;function Bl(){Hr=!0;let E,C;s==1&&(wn>0?(Cn=Gs[0]=0,Pn=Gs[1]=wn-1,E=t[0][Cn],C=t[0][Pn],H==2?(E=Cn,C=Pn):E==C&&(H==3?[E,C]=Df(E,E,N.log,!1):H==4?[E,C]=g0(E,E,N.log,!1):N.time?C=E+qn(86400/g):[E,C]=Pf(E,C,_0,!0))):(Cn=Gs[0]=E=null,Pn=Gs[1]=C=null)),Wr(S,E,C)}let sa,Gr,ra,I,q,it,J,K,It,Ot;function Lt(E,C,F,k,X,tt){E??=Ub,F??=y0,k??="butt",X??=Ub,tt??="round",E!=sa&&(h.strokeStyle=sa=E),X!=Gr&&(h.fillStyle=Gr=X),C!=ra&&(h.lineWidth=ra=C),tt!=q&&(h.lineJoin=q=tt),k!=it&&(h.lineCap=it=k),F!=I&&h.setLineDash(I=F)}function Bt(E,C,F,k){C!=Gr&&(h.fillStyle=Gr=C),E!=J&&(h.font=J=E),F!=K&&(h.textAlign=K=F),k!=It&&(h.textBaseline=It=k)}function Xt(E,C,F,k,X=0){if(k.length>0&&E.auto(i,Hr)&&(C==null||C.min==null)){let tt=Be(Cn,0),ht=Be(Pn,k.length-1),xt=F.min==null?v3(k,tt,ht,X,E.distr==3):[F.min,F.max];E.min=Bs(E.min,F.min=xt[0]),E.max=Ii(E.max,F.max=xt[1])}}let ce={min:null,max:null};function Re(){for(let k in v){let X=v[k];z[k]==null&&(X.min==null||z[S]!=null&&X.auto(i,Hr))&&(z[k]=ce)}for(let k in v){let X=v[k];z[k]==null&&X.from!=null&&z[X.from]!=null&&(z[k]=ce)}z[S]!=null&&be(!0);let E={};for(let k in z){let X=z[k];if(X!=null){let tt=E[k]=pl(v[k],C3);if(X.min!=null)Bn(tt,X);else if(k!=S||s==2)if(wn==0&&tt.from==null){let ht=tt.range(i,null,null,k);tt.min=ht[0],tt.max=ht[1]}else tt.min=en,tt.max=-en}}if(wn>0){_.forEach((k,X)=>{if(s==1){let tt=k.scale,ht=z[tt];if(ht==null)return;let xt=E[tt];if(X==0){let Et=xt.range(i,xt.min,xt.max,tt);xt.min=Et[0],xt.max=Et[1],Cn=Fs(xt.min,t[0]),Pn=Fs(xt.max,t[0]),Pn-Cn>1&&(t[0][Cn]<xt.min&&Cn++,t[0][Pn]>xt.max&&Pn--),k.min=$i[Cn],k.max=$i[Pn]}else k.show&&k.auto&&Xt(xt,ht,k,t[X],k.sorted);k.idxs[0]=Cn,k.idxs[1]=Pn}else if(X>0&&k.show&&k.auto){let[tt,ht]=k.facets,xt=tt.scale,Et=ht.scale,[zt,Ht]=t[X],Vt=E[xt],pe=E[Et];Vt!=null&&Xt(Vt,z[xt],tt,zt,tt.sorted),pe!=null&&Xt(pe,z[Et],ht,Ht,ht.sorted),k.min=ht.min,k.max=ht.max}});for(let k in E){let X=E[k],tt=z[k];if(X.from==null&&(tt==null||tt.min==null)){let ht=X.range(i,X.min==en?null:X.min,X.max==-en?null:X.max,k);X.min=ht[0],X.max=ht[1]}}}for(let k in E){let X=E[k];if(X.from!=null){let tt=E[X.from];if(tt.min==null)X.min=X.max=null;else{let ht=X.range(i,tt.min,tt.max,k);X.min=ht[0],X.max=ht[1]}}}let C={},F=!1;for(let k in E){let X=E[k],tt=v[k];if(tt.min!=X.min||tt.max!=X.max){tt.min=X.min,tt.max=X.max;let ht=tt.distr;tt._min=ht==3?Fr(tt.min):ht==4?Qg(tt.min,tt.asinh):ht==100?tt.fwd(tt.min):tt.min,tt._max=ht==3?Fr(tt.max):ht==4?Qg(tt.max,tt.asinh):ht==100?tt.fwd(tt.max):tt.max,C[k]=F=!0}}if(F){_.forEach((k,X)=>{s==2?X>0&&C.y&&(k._paths=null):C[k.scale]&&(k._paths=null)});for(let k in C)wt=!0,Jn("setScale",k);yt&&ft.left>=0&&(rt=vt=!0)}for(let k in z)z[k]=null}function qt(E){let C=a0(Cn-1,0,wn-1),F=a0(Pn+1,0,wn-1);for(;E[C]==null&&C>0;)C--;for(;E[F]==null&&F<wn-1;)F++;return[C,F]}function Ce(){if(wn>0){let E=_.some(C=>C._focus)&&Ot!=$t.alpha;E&&(h.globalAlpha=Ot=$t.alpha),_.forEach((C,F)=>{if(F>0&&C.show&&(vn(F,!1),vn(F,!0),C._paths==null)){let k=Ot;Ot!=C.alpha&&(h.globalAlpha=Ot=C.alpha);let X=s==2?[0,t[F][0].length-1]:qt(t[F]);C._paths=C.paths(i,F,X[0],X[1]),Ot!=k&&(h.globalAlpha=Ot=k)}}),_.forEach((C,F)=>{if(F>0&&C.show){let k=Ot;Ot!=C.alpha&&(h.globalAlpha=Ot=C.alpha),C._paths!=null&&qe(F,!1);{let X=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,F,Cn,Pn,X),ht=C.points.filter(i,F,tt,X);(tt||ht)&&(C.points._paths=C.points.paths(i,F,Cn,Pn,ht),qe(F,!0))}Ot!=k&&(h.globalAlpha=Ot=k),Jn("drawSeries",F)}}),E&&(h.globalAlpha=Ot=1)}}function vn(E,C){let F=C?_[E].points:_[E];F._stroke=F.stroke(i,E),F._fill=F.fill(i,E)}function qe(E,C){let F=C?_[E].points:_[E],{stroke:k,fill:X,clip:tt,flags:ht,_stroke:xt=F._stroke,_fill:Et=F._fill,_width:zt=F.width}=F._paths;zt=nn(zt*Ge,3);let Ht=null,Vt=zt%2/2;C&&Et==null&&(Et=zt>0?"#fff":xt);let pe=F.pxAlign==1&&Vt>0;if(pe&&h.translate(Vt,Vt),!C){let ke=O-zt/2,Oe=R-zt/2,Pe=j+zt,re=mt+zt;Ht=new Path2D,Ht.rect(ke,Oe,Pe,re)}C?Gt(xt,zt,F.dash,F.cap,Et,k,X,ht,tt):Xe(E,xt,zt,F.dash,F.cap,Et,k,X,ht,Ht,tt),pe&&h.translate(-Vt,-Vt)}function Xe(E,C,F,k,X,tt,ht,xt,Et,zt,Ht){let Vt=!1;Et!=0&&A.forEach((pe,ke)=>{if(pe.series[0]==E){let Oe=_[pe.series[1]],Pe=t[pe.series[1]],re=(Oe._paths||hu).band;go(re)&&(re=pe.dir==1?re[0]:re[1]);let Kt,cn=null;Oe.show&&re&&M3(Pe,Cn,Pn)?(cn=pe.fill(i,ke)||tt,Kt=Oe._paths.clip):re=null,Gt(C,F,k,X,cn,ht,xt,Et,zt,Ht,Kt,re),Vt=!0}}),Vt||Gt(C,F,k,X,tt,ht,xt,Et,zt,Ht)}let zn=ml|u0;function Gt(E,C,F,k,X,tt,ht,xt,Et,zt,Ht,Vt){Lt(E,C,F,k,X),(Et||zt||Vt)&&(h.save(),Et&&h.clip(Et),zt&&h.clip(zt)),Vt?(xt&zn)==zn?(h.clip(Vt),Ht&&h.clip(Ht),Le(X,ht),Dn(E,tt,C)):xt&u0?(Le(X,ht),h.clip(Vt),Dn(E,tt,C)):xt&ml&&(h.save(),h.clip(Vt),Ht&&h.clip(Ht),Le(X,ht),h.restore(),Dn(E,tt,C)):(Le(X,ht),Dn(E,tt,C)),(Et||zt||Vt)&&h.restore()}function Dn(E,C,F){F>0&&(C instanceof Map?C.forEach((k,X)=>{h.strokeStyle=sa=X,h.stroke(k)}):C!=null&&E&&h.stroke(C))}function Le(E,C){C instanceof Map?C.forEach((F,k)=>{h.fillStyle=Gr=k,h.fill(F)}):C!=null&&E&&h.fill(C)}function pr(E,C,F,k){let X=T[E],tt;if(k<=0)tt=[0,0];else{let ht=X._space=X.space(i,E,C,F,k),xt=X._incrs=X.incrs(i,E,C,F,k,ht);tt=V2(C,F,xt,k,ht)}return X._found=tt}function Nn(E,C,F,k,X,tt,ht,xt,Et,zt){let Ht=ht%2/2;x==1&&h.translate(Ht,Ht),Lt(xt,ht,Et,zt,xt),h.beginPath();let Vt,pe,ke,Oe,Pe=X+(k==0||k==3?-tt:tt);F==0?(pe=X,Oe=Pe):(Vt=X,ke=Pe);for(let re=0;re<E.length;re++)C[re]!=null&&(F==0?Vt=ke=E[re]:pe=Oe=E[re],h.moveTo(Vt,pe),h.lineTo(ke,Oe));h.stroke(),x==1&&h.translate(-Ht,-Ht)}function oa(E){let C=!0;return T.forEach((F,k)=>{if(!F.show)return;let X=v[F.scale];if(X.min==null){F._show&&(C=!1,F._show=!1,be(!1));return}else F._show||(C=!1,F._show=!0,be(!1));let tt=F.side,ht=tt%2,{min:xt,max:Et}=X,[zt,Ht]=pr(k,xt,Et,ht==0?W:Nt);if(Ht==0)return;let Vt=X.distr==2,pe=F._splits=F.splits(i,k,xt,Et,zt,Ht,Vt),ke=X.distr==2?pe.map(Kt=>$i[Kt]):pe,Oe=X.distr==2?$i[pe[1]]-$i[pe[0]]:zt,Pe=F._values=F.values(i,F.filter(i,ke,k,Ht,Oe),k,Ht,Oe);F._rotate=tt==2?F.rotate(i,Pe,k,Ht):0;let re=F._size;F._size=ys(F.size(i,Pe,k,E)),re!=null&&F._size!=re&&(C=!1)}),C}function Vs(E){let C=!0;return Ol.forEach((F,k)=>{let X=F(i,k,Hs,E);X!=vs[k]&&(C=!1),vs[k]=X}),C}function mr(){for(let E=0;E<T.length;E++){let C=T[E];if(!C.show||!C._show)continue;let F=C.side,k=F%2,X,tt,ht=C.stroke(i,E),xt=F==0||F==3?-1:1,[Et,zt]=C._found;if(C.label!=null){let bi=C.labelGap*xt,Yi=qn((C._lpos+bi)*Ge);Bt(C.labelFont[0],ht,"center",F==2?"top":Nb),h.save(),k==1?(X=tt=0,h.translate(Yi,qn(R+mt/2)),h.rotate((F==3?-Rf:Rf)/2)):(X=qn(O+j/2),tt=Yi);let Ro=SM(C.label)?C.label(i,E,Et,zt):C.label;h.fillText(Ro,X,tt),h.restore()}if(zt==0)continue;let Ht=v[C.scale],Vt=k==0?j:mt,pe=k==0?O:R,ke=C._splits,Oe=Ht.distr==2?ke.map(bi=>$i[bi]):ke,Pe=Ht.distr==2?$i[ke[1]]-$i[ke[0]]:Et,re=C.ticks,Kt=C.border,cn=re.show?re.size:0,Tn=qn(cn*Ge),Kn=qn((C.alignTo==2?C._size-cn-C.gap:C.gap)*Ge),Ke=C._rotate*-Rf/180,An=m(C._pos*Ge),qi=(Tn+Kn)*xt,vi=An+qi;tt=k==0?vi:0,X=k==1?vi:0;let ls=C.font[0],bs=C.align==1?cl:C.align==2?Zg:Ke>0?cl:Ke<0?Zg:k==0?"center":F==3?Zg:cl,qs=Ke||k==1?"middle":F==2?"top":Nb;Bt(ls,ht,bs,qs);let Xi=C.font[1]*C.lineGap,cs=ke.map(bi=>m(a(bi,Ht,Vt,pe))),Ms=C._values;for(let bi=0;bi<Ms.length;bi++){let Yi=Ms[bi];if(Yi!=null){k==0?X=cs[bi]:tt=cs[bi],Yi=""+Yi;let Ro=Yi.indexOf(`
`)==-1?[Yi]:Yi.split(/\n/gm);for(let Mi=0;Mi<Ro.length;Mi++){let w_=Ro[Mi];Ke?(h.save(),h.translate(X,tt+Mi*Xi),h.rotate(Ke),h.fillText(w_,0,0),h.restore()):h.fillText(w_,X,tt+Mi*Xi)}}}re.show&&Nn(cs,re.filter(i,Oe,E,zt,Pe),k,F,An,Tn,nn(re.width*Ge,3),re.stroke(i,E),re.dash,re.cap);let Xs=C.grid;Xs.show&&Nn(cs,Xs.filter(i,Oe,E,zt,Pe),k,k==0?2:1,k==0?R:O,k==0?mt:j,nn(Xs.width*Ge,3),Xs.stroke(i,E),Xs.dash,Xs.cap),Kt.show&&Nn([An],[1],k==0?1:0,k==0?1:2,k==1?R:O,k==1?mt:j,nn(Kt.width*Ge,3),Kt.stroke(i,E),Kt.dash,Kt.cap)}Jn("drawAxes")}function be(E){_.forEach((C,F)=>{F>0&&(C._paths=null,E&&(s==1?(C.min=null,C.max=null):C.facets.forEach(k=>{k.min=null,k.max=null})))})}let En=!1,yi=!1,Ye=[];function Un(){yi=!1;for(let E=0;E<Ye.length;E++)Jn(...Ye[E]);Ye.length=0}function li(){En||(O3(o_),En=!0)}function Eu(E,C=!1){En=!0,yi=C,E(i),o_(),C&&Ye.length>0&&queueMicrotask(Un)}i.batch=Eu;function o_(){if(ct&&(Re(),ct=!1),wt&&(Pt(),wt=!1),St){if(gn(f,cl,se),gn(f,"top",ge),gn(f,au,W),gn(f,lu,Nt),gn(p,cl,se),gn(p,"top",ge),gn(p,au,W),gn(p,lu,Nt),gn(d,au,Sn),gn(d,lu,Ln),u.width=qn(Sn*Ge),u.height=qn(Ln*Ge),T.forEach(({_el:E,_show:C,_size:F,_pos:k,side:X})=>{if(E!=null)if(C){let tt=X===3||X===0?F:0,ht=X%2==1;gn(E,ht?"left":"top",k-tt),gn(E,ht?"width":"height",F),gn(E,ht?"top":"left",ht?ge:se),gn(E,ht?"height":"width",ht?Nt:W),r0(E,Yo)}else rs(E,Yo)}),sa=Gr=ra=q=it=J=K=It=I=null,Ot=1,Hl(!0),se!=Ct||ge!=Qe||W!=Yt||Nt!=ne){be(!1);let E=W/Yt,C=Nt/ne;if(yt&&!rt&&ft.left>=0){ft.left*=E,ft.top*=C,aa&&ur(aa,qn(ft.left),0,W,Nt),la&&ur(la,0,qn(ft.top),W,Nt);for(let F=0;F<ye.length;F++){let k=ye[F];k!=null&&(on[F]*=E,xi[F]*=C,ur(k,ys(on[F]),ys(xi[F]),W,Nt))}}if(ln.show&&!at&&ln.left>=0&&ln.width>0){ln.left*=E,ln.width*=E,ln.top*=C,ln.height*=C;for(let F in bp)gn(ha,F,ln[F])}Ct=se,Qe=ge,Yt=W,ne=Nt}Jn("setSize"),St=!1}Sn>0&&Ln>0&&(h.clearRect(0,0,u.width,u.height),Jn("drawClear"),w.forEach(E=>E()),Jn("draw")),ln.show&&at&&(Tu(ln),at=!1),yt&&rt&&(Ao(null,!0,!1),rt=!1),dt.show&&dt.live&&vt&&(yp(),vt=!1),l||(l=!0,i.status=1,Jn("ready")),Hr=!1,En=!1}i.redraw=(E,C)=>{wt=C||!1,E!==!1?Wr(S,N.min,N.max):li()};function gp(E,C){let F=v[E];if(F.from==null){if(wn==0){let k=F.range(i,C.min,C.max,E);C.min=k[0],C.max=k[1]}if(C.min>C.max){let k=C.min;C.min=C.max,C.max=k}if(wn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;E==S&&F.distr==2&&wn>0&&(C.min=Fs(C.min,t[0]),C.max=Fs(C.max,t[0]),C.min==C.max&&C.max++),z[E]=C,ct=!0,li()}}i.setScale=gp;let _p,xp,aa,la,a_,l_,ca,ua,c_,u_,an,xn,Vr=!1,ni=ft.drag,jn=ni.x,Zn=ni.y;yt&&(ft.x&&(_p=xs(o3,p)),ft.y&&(xp=xs(a3,p)),N.ori==0?(aa=_p,la=xp):(aa=xp,la=_p),an=ft.left,xn=ft.top);let ln=i.select=Bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ha=ln.show?xs(r3,ln.over?p:f):null;function Tu(E,C){if(ln.show){for(let F in E)ln[F]=E[F],F in bp&&gn(ha,F,E[F]);C!==!1&&Jn("setSelect")}}i.setSelect=Tu;function a1(E){if(_[E].show)st&&r0(me[E],Yo);else if(st&&rs(me[E],Yo),yt){let F=Dt?ye[0]:ye[E];F!=null&&ur(F,-10,-10,W,Nt)}}function Wr(E,C,F){gp(E,{min:C,max:F})}function Ws(E,C,F,k){C.focus!=null&&d1(E),C.show!=null&&_.forEach((X,tt)=>{tt>0&&(E==tt||E==null)&&(X.show=C.show,a1(tt),s==2?(Wr(X.facets[0].scale,null,null),Wr(X.facets[1].scale,null,null)):Wr(X.scale,null,null),li())}),F!==!1&&Jn("setSeries",E,C),k&&Gl("setSeries",i,E,C)}i.setSeries=Ws;function l1(E,C){Bn(A[E],C)}function c1(E,C){E.fill=Ne(E.fill||null),E.dir=Be(E.dir,-1),C=C??A.length,A.splice(C,0,E)}function u1(E){E==null?A.length=0:A.splice(E,1)}i.addBand=c1,i.setBand=l1,i.delBand=u1;function h1(E,C){_[E].alpha=C,yt&&ye[E]!=null&&(ye[E].style.opacity=C),st&&me[E]&&(me[E].style.opacity=C)}let gr,$r,To,da={focus:!0};function d1(E){if(E!=To){let C=E==null,F=$t.alpha!=1;_.forEach((k,X)=>{if(s==1||X>0){let tt=C||X==0||X==E;k._focus=C?null:tt,F&&h1(X,tt?1:$t.alpha)}}),To=E,F&&li()}}st&&ae&&Ue(Bb,Tt,E=>{ft._lock||(oe(E),To!=null&&Ws(null,da,!0,On.setSeries))});function $s(E,C,F){let k=v[C];F&&(E=E/Ge-(k.ori==1?ge:se));let X=W;k.ori==1&&(X=Nt,E=X-E),k.dir==-1&&(E=X-E);let tt=k._min,ht=k._max,xt=E/X,Et=tt+(ht-tt)*xt,zt=k.distr;return zt==3?dl(10,Et):zt==4?w3(Et,k.asinh):zt==100?k.bwd(Et):Et}function f1(E,C){let F=$s(E,S,C);return Fs(F,t[0],Cn,Pn)}i.valToIdx=E=>Fs(E,t[0]),i.posToIdx=f1,i.posToVal=$s,i.valToPos=(E,C,F)=>v[C].ori==0?r(E,v[C],F?j:W,F?O:0):o(E,v[C],F?mt:Nt,F?R:0),i.setCursor=(E,C,F)=>{an=E.left,xn=E.top,Ao(null,C,F)};function h_(E,C){gn(ha,cl,ln.left=E),gn(ha,au,ln.width=C)}function d_(E,C){gn(ha,"top",ln.top=E),gn(ha,lu,ln.height=C)}let kl=N.ori==0?h_:d_,zl=N.ori==1?h_:d_;function p1(){if(st&&dt.live)for(let E=s==2?1:0;E<_.length;E++){if(E==0&&ve)continue;let C=dt.values[E],F=0;for(let k in C)jt[E][F++].firstChild.nodeValue=C[k]}}function yp(E,C){if(E!=null&&(E.idxs?E.idxs.forEach((F,k)=>{et[k]=F}):R3(E.idx)||et.fill(E.idx),dt.idx=et[0]),st&&dt.live){for(let F=0;F<_.length;F++)(F>0||s==1&&!ve)&&m1(F,et[F]);p1()}vt=!1,C!==!1&&Jn("setLegend")}i.setLegend=yp;function m1(E,C){let F=_[E],k=E==0&&H==2?$i:t[E],X;ve?X=F.values(i,E,C)??fe:(X=F.value(i,C==null?null:k[C],E,C),X=X==null?fe:{_:X}),dt.values[E]=X}function Ao(E,C,F){c_=an,u_=xn,[an,xn]=ft.move(i,an,xn),ft.left=an,ft.top=xn,yt&&(aa&&ur(aa,qn(an),0,W,Nt),la&&ur(la,0,qn(xn),W,Nt));let k,X=Cn>Pn;gr=en,$r=null;let tt=N.ori==0?W:Nt,ht=N.ori==1?W:Nt;if(an<0||wn==0||X){k=ft.idx=null;for(let xt=0;xt<_.length;xt++){let Et=ye[xt];Et!=null&&ur(Et,-10,-10,W,Nt)}ae&&Ws(null,da,!0,E==null&&On.setSeries),dt.live&&(et.fill(k),vt=!0)}else{let xt,Et,zt;s==1&&(xt=N.ori==0?an:xn,Et=$s(xt,S),k=ft.idx=Fs(Et,t[0],Cn,Pn),zt=$(t[0][k],N,tt,0));let Ht=-10,Vt=-10,pe=0,ke=0,Oe=!0,Pe="",re="";for(let Kt=s==2?1:0;Kt<_.length;Kt++){let cn=_[Kt],Tn=et[Kt],Kn=Tn==null?null:s==1?t[Kt][Tn]:t[Kt][1][Tn],Ke=ft.dataIdx(i,Kt,k,Et),An=Ke==null?null:s==1?t[Kt][Ke]:t[Kt][1][Ke];if(vt=vt||An!=Kn||Ke!=Tn,et[Kt]=Ke,Kt>0&&cn.show){let qi=Ke==null?-10:Ke==k?zt:$(s==1?t[0][Ke]:t[Kt][0][Ke],N,tt,0),vi=An==null?-10:P(An,s==1?v[cn.scale]:v[cn.facets[1].scale],ht,0);if(ae&&An!=null){let ls=N.ori==1?an:xn,bs=Xn($t.dist(i,Kt,Ke,vi,ls));if(bs<gr){let qs=$t.bias;if(qs!=0){let Xi=$s(ls,cn.scale),cs=An>=0?1:-1,Ms=Xi>=0?1:-1;Ms==cs&&(Ms==1?qs==1?An>=Xi:An<=Xi:qs==1?An<=Xi:An>=Xi)&&(gr=bs,$r=Kt)}else gr=bs,$r=Kt}}if(vt||Dt){let ls,bs;N.ori==0?(ls=qi,bs=vi):(ls=vi,bs=qi);let qs,Xi,cs,Ms,Xs,bi,Yi=!0,Ro=pt.bbox;if(Ro!=null){Yi=!1;let Mi=Ro(i,Kt);cs=Mi.left,Ms=Mi.top,qs=Mi.width,Xi=Mi.height}else cs=ls,Ms=bs,qs=Xi=pt.size(i,Kt);if(bi=pt.fill(i,Kt),Xs=pt.stroke(i,Kt),Dt)Kt==$r&&gr<=$t.prox&&(Ht=cs,Vt=Ms,pe=qs,ke=Xi,Oe=Yi,Pe=bi,re=Xs);else{let Mi=ye[Kt];Mi!=null&&(on[Kt]=cs,xi[Kt]=Ms,$b(Mi,qs,Xi,Yi),Vb(Mi,bi,Xs),ur(Mi,ys(cs),ys(Ms),W,Nt))}}}}if(Dt){let Kt=$t.prox,cn=To==null?gr<=Kt:gr>Kt||$r!=To;if(vt||cn){let Tn=ye[0];Tn!=null&&(on[0]=Ht,xi[0]=Vt,$b(Tn,pe,ke,Oe),Vb(Tn,Pe,re),ur(Tn,ys(Ht),ys(Vt),W,Nt))}}}if(ln.show&&Vr)if(E!=null){let[xt,Et]=On.scales,[zt,Ht]=On.match,[Vt,pe]=E.cursor.sync.scales,ke=E.cursor.drag;if(jn=ke._x,Zn=ke._y,jn||Zn){let{left:Oe,top:Pe,width:re,height:Kt}=E.select,cn=E.scales[Vt].ori,Tn=E.posToVal,Kn,Ke,An,qi,vi,ls=xt!=null&&zt(xt,Vt),bs=Et!=null&&Ht(Et,pe);ls&&jn?(cn==0?(Kn=Oe,Ke=re):(Kn=Pe,Ke=Kt),An=v[xt],qi=$(Tn(Kn,Vt),An,tt,0),vi=$(Tn(Kn+Ke,Vt),An,tt,0),kl(Bs(qi,vi),Xn(vi-qi))):kl(0,tt),bs&&Zn?(cn==1?(Kn=Oe,Ke=re):(Kn=Pe,Ke=Kt),An=v[Et],qi=P(Tn(Kn,pe),An,ht,0),vi=P(Tn(Kn+Ke,pe),An,ht,0),zl(Bs(qi,vi),Xn(vi-qi))):zl(0,ht)}else Mp()}else{let xt=Xn(c_-a_),Et=Xn(u_-l_);if(N.ori==1){let pe=xt;xt=Et,Et=pe}jn=ni.x&&xt>=ni.dist,Zn=ni.y&&Et>=ni.dist;let zt=ni.uni;zt!=null?jn&&Zn&&(jn=xt>=zt,Zn=Et>=zt,!jn&&!Zn&&(Et>xt?Zn=!0:jn=!0)):ni.x&&ni.y&&(jn||Zn)&&(jn=Zn=!0);let Ht,Vt;jn&&(N.ori==0?(Ht=ca,Vt=an):(Ht=ua,Vt=xn),kl(Bs(Ht,Vt),Xn(Vt-Ht)),Zn||zl(0,ht)),Zn&&(N.ori==1?(Ht=ca,Vt=an):(Ht=ua,Vt=xn),zl(Bs(Ht,Vt),Xn(Vt-Ht)),jn||kl(0,tt)),!jn&&!Zn&&(kl(0,0),zl(0,0))}if(ni._x=jn,ni._y=Zn,E==null){if(F){if(S_!=null){let[xt,Et]=On.scales;On.values[0]=xt!=null?$s(N.ori==0?an:xn,xt):null,On.values[1]=Et!=null?$s(N.ori==1?an:xn,Et):null}Gl(Jg,i,an,xn,W,Nt,k)}if(ae){let xt=F&&On.setSeries,Et=$t.prox;To==null?gr<=Et&&Ws($r,da,!0,xt):gr>Et?Ws(null,da,!0,xt):$r!=To&&Ws($r,da,!0,xt)}}vt&&(dt.idx=k,yp()),C!==!1&&Jn("setCursor")}let qr=null;Object.defineProperty(i,"rect",{get(){return qr==null&&Hl(!1),qr}});function Hl(E=!1){E?qr=null:(qr=p.getBoundingClientRect(),Jn("syncRect",qr))}function f_(E,C,F,k,X,tt,ht){ft._lock||Vr&&E!=null&&E.movementX==0&&E.movementY==0||(vp(E,C,F,k,X,tt,ht,!1,E!=null),E!=null?Ao(null,!0,!0):Ao(C,!0,!1))}function vp(E,C,F,k,X,tt,ht,xt,Et){if(qr==null&&Hl(!1),oe(E),E!=null)F=E.clientX-qr.left,k=E.clientY-qr.top;else{if(F<0||k<0){an=-10,xn=-10;return}let[zt,Ht]=On.scales,Vt=C.cursor.sync,[pe,ke]=Vt.values,[Oe,Pe]=Vt.scales,[re,Kt]=On.match,cn=C.axes[0].side%2==1,Tn=N.ori==0?W:Nt,Kn=N.ori==1?W:Nt,Ke=cn?tt:X,An=cn?X:tt,qi=cn?k:F,vi=cn?F:k;if(Oe!=null?F=re(zt,Oe)?a(pe,v[zt],Tn,0):-10:F=Tn*(qi/Ke),Pe!=null?k=Kt(Ht,Pe)?a(ke,v[Ht],Kn,0):-10:k=Kn*(vi/An),N.ori==1){let ls=F;F=k,k=ls}}Et&&(C==null||C.cursor.event.type==Jg)&&((F<=1||F>=W-1)&&(F=qo(F,W)),(k<=1||k>=Nt-1)&&(k=qo(k,Nt))),xt?(a_=F,l_=k,[ca,ua]=ft.move(i,F,k)):(an=F,xn=k)}let bp={width:0,height:0,left:0,top:0};function Mp(){Tu(bp,!1)}let p_,m_,g_,__;function x_(E,C,F,k,X,tt,ht){Vr=!0,jn=Zn=ni._x=ni._y=!1,vp(E,C,F,k,X,tt,ht,!0,!1),E!=null&&(Ue(Kg,i0,y_,!1),Gl(Ob,i,ca,ua,W,Nt,null));let{left:xt,top:Et,width:zt,height:Ht}=ln;p_=xt,m_=Et,g_=zt,__=Ht}function y_(E,C,F,k,X,tt,ht){Vr=ni._x=ni._y=!1,vp(E,C,F,k,X,tt,ht,!1,!0);let{left:xt,top:Et,width:zt,height:Ht}=ln,Vt=zt>0||Ht>0,pe=p_!=xt||m_!=Et||g_!=zt||__!=Ht;if(Vt&&pe&&Tu(ln),ni.setScale&&Vt&&pe){let ke=xt,Oe=zt,Pe=Et,re=Ht;if(N.ori==1&&(ke=Et,Oe=Ht,Pe=xt,re=zt),jn&&Wr(S,$s(ke,S),$s(ke+Oe,S)),Zn)for(let Kt in v){let cn=v[Kt];Kt!=S&&cn.from==null&&cn.min!=en&&Wr(Kt,$s(Pe+re,Kt),$s(Pe,Kt))}Mp()}else ft.lock&&(ft._lock=!ft._lock,Ao(C,!0,E!=null));E!=null&&(kn(Kg,i0),Gl(Kg,i,an,xn,W,Nt,null))}function g1(E,C,F,k,X,tt,ht){if(ft._lock)return;oe(E);let xt=Vr;if(Vr){let Et=!0,zt=!0,Ht=10,Vt,pe;N.ori==0?(Vt=jn,pe=Zn):(Vt=Zn,pe=jn),Vt&&pe&&(Et=an<=Ht||an>=W-Ht,zt=xn<=Ht||xn>=Nt-Ht),Vt&&Et&&(an=an<ca?0:W),pe&&zt&&(xn=xn<ua?0:Nt),Ao(null,!0,!0),Vr=!1}an=-10,xn=-10,et.fill(null),Ao(null,!0,!0),xt&&(Vr=xt)}function v_(E,C,F,k,X,tt,ht){ft._lock||(oe(E),Bl(),Mp(),E!=null&&Gl(kb,i,an,xn,W,Nt,null))}function b_(){T.forEach(W2),V(i.width,i.height,!0)}jo(Cf,hl,b_);let fa={};fa.mousedown=x_,fa.mousemove=f_,fa.mouseup=y_,fa.dblclick=v_,fa.setSeries=(E,C,F,k)=>{let X=On.match[2];F=X(i,C,F),F!=-1&&Ws(F,k,!0,!1)},yt&&(Ue(Ob,p,x_),Ue(Jg,p,f_),Ue(Fb,p,E=>{oe(E),Hl(!1)}),Ue(Bb,p,g1),Ue(kb,p,v_),h0.add(i),i.syncRect=Hl);let Au=i.hooks=n.hooks||{};function Jn(E,C,F){yi?Ye.push([E,C,F]):E in Au&&Au[E].forEach(k=>{k.call(null,i,C,F)})}(n.plugins||[]).forEach(E=>{for(let C in E.hooks)Au[C]=(Au[C]||[]).concat(E.hooks[C])});let M_=(E,C,F)=>F,On=Bn({key:null,setSeries:!1,filters:{pub:Zb,sub:Zb},scales:[S,_[1]?_[1].scale:null],match:[Jb,Jb,M_],values:[null,null]},ft.sync);On.match.length==2&&On.match.push(M_),ft.sync=On;let S_=On.key,Sp=XM(S_);function Gl(E,C,F,k,X,tt,ht){On.filters.pub(E,C,F,k,X,tt,ht)&&Sp.pub(E,C,F,k,X,tt,ht)}Sp.sub(i);function _1(E,C,F,k,X,tt,ht){On.filters.sub(E,C,F,k,X,tt,ht)&&fa[E](null,C,F,k,X,tt,ht)}i.pub=_1;function x1(){Sp.unsub(i),h0.delete(i),Yn.clear(),o0(Cf,hl,b_),c.remove(),Tt?.remove(),Jn("destroy")}i.destroy=x1;function wp(){Jn("init",n,t),Fl(t||n.data,!1),z[S]?gp(S,z[S]):Bl(),at=ln.show&&(ln.width>0||ln.height>0),rt=vt=!0,V(n.width,n.height)}return _.forEach(ia),T.forEach(dr),e?e instanceof HTMLElement?(e.appendChild(c),wp()):e(i,wp):wp(),i}oi.assign=Bn;oi.fmtNum=x0;oi.rangeNum=Pf;oi.rangeLog=Df;oi.rangeAsinh=g0;oi.orient=Jo;oi.pxRatio=Ge;oi.join=U3;oi.fmtDate=v0,oi.tzDate=q3;oi.sync=XM;{oi.addGap=R2,oi.clipGaps=Of;let n=oi.paths={points:QM};n.linear=eS,n.stepped=I2,n.bars=L2,n.spline=N2}var zf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),A0=n=>Ft.curves[n%Ft.curves.length],$2=.06;function q2(n,t,e){let i=[n,t,...e.map(a=>a.value)],s=Math.min(...i),r=Math.max(...i),o=$2*(r-s);return r-s>1e-9?[s-o,r+o]:[s-1,r+1]}function X2(n,t,e,i){let{ctx:s}=n,r=devicePixelRatio;s.save(),s.beginPath(),s.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),s.clip();for(let{value:o,of:a}of i){let l=n.valToPos(o,"y",!0);s.strokeStyle=a===null?Ft.ink:A0(a),s.lineWidth=1.25*r,s.setLineDash([5*r,4*r]),s.beginPath(),s.moveTo(n.bbox.left,l),s.lineTo(n.bbox.left+n.bbox.width,l),s.stroke()}s.setLineDash([]),s.lineCap="round",s.lineWidth=4.5*r,e.forEach((o,a)=>{s.strokeStyle=A0(a);for(let{start:l,end:c}of o.binds){let u=t.xs.map((h,d)=>[h,o.values[d]]).filter(([h])=>h>=l-1e-9&&h<=c+1e-9);s.beginPath();for(let[h,d]of u)s.lineTo(n.valToPos(h,"x",!0),n.valToPos(d,"y",!0));s.stroke()}}),s.restore()}function rS(n,t,{y:e,list:i},{withLimits:s,pick:r}){let o={stroke:Ft.line,width:1},a=`${Math.round(.78*zf())}px "Inter Variable", system-ui, sans-serif`,l=ru(i),c={stroke:Ft.muted,grid:o,ticks:{...o,size:4},font:a,labelFont:a,labelSize:1.4*zf(),gap:4},u=new oi({width:n.clientWidth||600,height:n.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(f,p,x)=>[p,Math.max(x,t.xEnd??x,p+1e-6)]},y:{range:(f,p,x)=>q2(p,x,s?l:[])}},series:[{},...i.map((f,p)=>({label:f.name,stroke:A0(p),width:1.75,pxAlign:0,points:{show:t.q.length<3}}))],axes:[{...c,label:t.xName==="point"?"point number":"time, s",size:2.1*zf()},{...c,label:e,size:4*zf()}],hooks:{draw:[f=>X2(f,t,i,l)],setSize:[()=>d()]}},[t.xs,...i.map(f=>f.values)],n);u.over.append(M("div",{class:"now"}),...t.events.map(f=>{let p=M("div",{class:`event ${f.stop?"stop":""}`,title:f.text},M("span",{text:f.short}));return p.x=f.x,p})),u.over.addEventListener("pointerdown",f=>{let p=m=>{let g=u.posToVal(m.clientX-u.over.getBoundingClientRect().left,"x");r(t.xs.reduce((_,T,v)=>Math.abs(T-g)<Math.abs(t.xs[_]-g)?v:_,0))};p(f);let x=()=>{removeEventListener("pointermove",p),removeEventListener("pointerup",x),removeEventListener("pointercancel",x)};addEventListener("pointermove",p),addEventListener("pointerup",x),addEventListener("pointercancel",x)});let h=0;function d(f=h){h=f;let p=u.over.clientWidth;for(let x of u.over.querySelectorAll(".now, .event")){let m=u.valToPos(x.x??t.xs[h],"x");x.style.setProperty("left",`${m}px`),x.classList.toggle("leftward",m>p*.7)}}return{point:d,canvas:u.ctx.canvas,resize:()=>n.clientWidth&&u.setSize({width:n.clientWidth,height:n.clientHeight}),destroy:()=>u.destroy()}}var Y2=1500,j2={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function oS(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/Y2)),r=n.q.map((v,A)=>A).filter(v=>v%s===0||v===n.q.length-1),[o,a,l,c,u,h]=tl(),[d,f,p]=[o-c,a-u,l-h],x=[Math.atan2(p,Math.hypot(d,f)),Math.atan2(f,d)].map(v=>v*180/Math.PI),m=v=>Number(v.toPrecision(8)),g={kind:t,speed:e,view:x,q:r.map(v=>n.q[v].map(m)),t:r.map(v=>m(n.seconds[v]))},_=await Fe("film",g,({done:v,of:A})=>i(v,A));if(_.stopped)return null;let T=Uint8Array.from(atob(_.data),v=>v.charCodeAt(0));return{name:_.name,blob:new Blob([T],{type:j2[t]})}}async function aS(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var sn=null,kr=null,hr="joints",_i=0,R0=1,ai=null,Vf=new Set(["speeds","accelerations","toolspeed"]);function cS(n){let t=Ut("Play",{class:"primary","data-testid":"play"},hS),e=M("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{gi(),zr(Number(e.value))}}}),i=M("output",{class:"where","data-testid":"where"}),s=M("div",{class:"marks"}),r=M("div",{class:"chart","data-testid":"chart"}),o=M("div",{class:"legend"}),a=M("output",{class:"binds","data-testid":"binds"}),l=Ut("To the limits",{class:"quiet",title:"Scale the curves so that their limits, dashed, are seen; thick is where one binds","data-testid":"limits-shown"},()=>{Vf.delete(hr)||Vf.add(hr),Gf()});n.append(M("div",{class:"dock-bar"},t,un("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",c=>{R0=Number(c)},{"data-testid":"speed"}),M("div",{class:"scrubber"},e,s),i,Ut("\xD7",{class:"icon","aria-label":"Close the curves"},()=>Li(null))),M("div",{class:"dock-bar second"},Ve("Curves",Cb,hr,c=>{hr=c,Gf()},"curves"),l,o,a,M("span",{class:"line saves"},...[["CSV",()=>ui("motion.csv",Ib(sn),"text/csv")],["PNG",J2],["Film",Z2],["GIF",()=>lS("gif")],["MP4",()=>lS("mp4")],["SVG",()=>ui(`${hr}.svg`,Lb(sn,hr,Ft.curves),"image/svg+xml")]].map(([c,u])=>Ut(c,{class:"quiet","aria-label":`Save as ${c}`},()=>sn&&u())))),r),ai={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o,limits:l,binds:a},new ResizeObserver(Zs(()=>kr?.resize())).observe(r),nt(["units","theme"],Gf),nt("moving",c=>bt(t,c&&Hf?"Pause":"Play")),nt("table",c=>{sn&&!["postures","name","gripper"].includes(c)&&Li(null)})}function Li(n){if(gi(),sn=n,b.motion=n,ai.root.hidden=!n,kr&&(kr.destroy(),kr=null),Kv(n?.table??null,n?.q??[]),!n){ut("motion");return}ai.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Wt(ai.marks,n.events.map(e=>{let i=M("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=M("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),Gf(),ut("motion"),n.q.length&&zr(0),requestAnimationFrame(()=>Qa())}var uS=()=>_i;function zr(n){sn?.q.length&&(_i=Math.min(Math.max(Math.round(n),0),sn.q.length-1),ai.scrub.value=String(_i),ai.scrub.style.setProperty("--at",`${sn.q.length>1?100*_i/(sn.q.length-1):0}%`),bt(ai.where,sn.xName==="point"?`point ${_i+1} of ${sn.q.length}`:`${ei(sn.xs[_i],2)} s of ${ei(sn.xs[sn.xs.length-1],2)} s`),ai.scrub.setAttribute("aria-valuetext",ai.where.textContent),Ui(sn.q[_i].slice(),"scrub"),ut("played",sn.seconds[_i]),bt(ai.binds,sn.tight?`Binds: ${Pb(sn,sn.seconds[_i])||"nothing"}`:""),kr?.point(_i))}var Hf=!1;function hS(n,t){if(Hf){gi();return}if(!sn?.q.length)return;let e=sn.seconds,i=e[e.length-1]||1,s=_i>=sn.q.length-1?0:e[_i]/i;Hf=!0,fb(i/R0,s,r=>{let o=_i<=sn.q.length-1&&e[_i]<=r*i?_i:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;zr(o)},()=>{Hf=!1,bt(ai.toggle,"Play"),t?.()}),bt(ai.toggle,"Pause")}function Gf(){if(!sn||!ai)return;kr?.destroy();let n=jg(sn,hr);Wt(ai.legend,n.list.map((t,e)=>{let i=M("span",{class:"swatch"});return i.style.setProperty("background",Ft.curves[e%Ft.curves.length]),M("span",{},i,t.name)})),ai.limits.hidden=!ru(n.list).length,ai.limits.setAttribute("aria-pressed",String(Vf.has(hr))),kr=rS(ai.chart,sn,n,{withLimits:Vf.has(hr),pick(t){gi(),zr(t)}}),kr.point(_i)}async function lS(n){Me(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await oS(sn,n,R0,(e,i)=>Me(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&ui(t.name,t.blob)}catch(t){Me(t.message,"wrong")}}async function Z2(){gi(),zr(0);try{let n=await Ja(t=>aS(t,()=>new Promise(e=>hS(null,e))));ui("motion.webm",n)}catch(n){Me(n.message,"wrong")}}function J2(){let n=kr.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Ft.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>ui(`${hr}.png`,i))}function vl(n,t){let e=Array.from({length:16},(s,r)=>M("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=M("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>M("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;bt(e[r],r>=12?String(s[r]):o?ei(s[r]*gt.factor("length"),gt.digits("length")):ei(s[r],4))}},i}var Wf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var C0="pieper-panel-width",P0=18,dS=70;function fS(n,t){let e=M("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(P0),"aria-valuemax":String(dS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,P0),dS,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(C0):localStorage.setItem(C0,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(C0));o>=P0?r(o):e.setAttribute("aria-valuenow","38")}function pS(n){let t=vl("Pose of the tool, large","present-pose"),e=M("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=Ut("Present",{"aria-pressed":"false","data-testid":"present"},()=>o(i.dataset.present!=="yes")),r=()=>!e.hidden&&t.show(b.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ut("units"),dispatchEvent(new Event("resize"))}return nt(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function mS(){Ja(n=>{let t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.drawImage(n,0,0),xv(e,n.width/n.clientWidth),t.toBlob(i=>i?ui(`${b.table.name||"arm"}.png`,i):Me("The picture could not be read.","wrong"))})}var K2="http://www.w3.org/2000/svg";function Q2(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(K2,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}var gS=n=>/^(.)\1*$/.test(n)?`${n.length}${n[0]}`:n;function tL(n){let t=/^>?(\d+(?:[.,]\d+)?)(kg|mm|m)$/.exec(n);if(!t)return null;let e=Number(t[1].replace(",","."));return t[2]==="kg"?{payload:e}:{reach:t[2]==="m"?e:e/1e3}}function eL(n,t){let e=`${n.name} ${n.maker} ${n.joints} ${gS(n.joints)}`.toLowerCase();return t.every(i=>{let s=tL(i);return s?Object.entries(s).every(([r,o])=>n[r]!==null&&n[r]>=o-1e-9):e.includes(i)})}var nL=({maker:n,joints:t,payload:e,reach:i})=>[n,gS(t),e===null?"":`${e} kg`,i===null?"":`${Math.round(i*1e3)} mm`].filter(Boolean);function _S(n){let t=null,e=M("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=M("span",{class:"hint",role:"status"}),s=M("input",{type:"text",placeholder:"Name, maker, joints (7R), payload (5 kg), reach (900 mm)","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>o(),keydown:a=>{if(a.key==="ArrowDown")e.firstElementChild?.focus();else if(a.key==="Enter")e.firstElementChild?.click();else return;a.preventDefault()}}}),r=M("dialog",{class:"catalogue","aria-label":"Catalogue"},M("div",{class:"line"},s,i,Ut("\xD7",{class:"icon","aria-label":"Close the catalogue"},()=>r.close())),e);document.body.append(r);function o(){let l=s.value.toLowerCase().replace(/(\d)\s+(kg|mm|m)\b/g,"$1$2").split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>eL(u,l));i.textContent=`${c.length} of ${t?.length??0} arms`,Wt(e,c.map(u=>M("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},Q2(u.points),M("span",{},M("b",{text:u.name}),M("span",{class:"hint",text:nL(u).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Zi("catalog")).arms,o()}catch(a){Me(a.message,"wrong")}}}var fu=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),xo=(n,t)=>[...n.children].filter(e=>e.localName===t),iL=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function sL(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function rL([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var xS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:rL},oL={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function yS(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(p=>p.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=oL[e("up_axis")[0]?.textContent.trim()]??iL(),a=[];function l(f){let p=s(xo(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),x=p&&[...p.getElementsByTagName("*")].find(g=>g.localName==="diffuse"),m=x?fu(xo(x,"color")[0]):[];return m.length>=3?[m[0],m[1],m[2],m[3]??1]:null}function c(f){let p=xo(f,"input").find(m=>m.getAttribute("semantic")==="POSITION"),x=s(p?.getAttribute("source"));return x?fu(xo(x,"float_array")[0]):[]}function u(f,p,x){let m=f&&xo(f,"mesh")[0];if(m)for(let g of m.children){if(!["triangles","polylist","polygons"].includes(g.localName))continue;let _=xo(g,"input"),T=1+Math.max(..._.map($=>Number($.getAttribute("offset")??0))),v=_.find($=>$.getAttribute("semantic")==="VERTEX");if(!v)continue;let A=Number(v.getAttribute("offset")??0),S=c(s(v.getAttribute("source"))),y=xo(g,"p").map(fu),w=g.localName==="polylist"?fu(xo(g,"vcount")[0]):g.localName==="polygons"?y.map($=>$.length/T):new Array(y.reduce(($,P)=>$+P.length,0)/T/3).fill(3),U=y.flat(),L=[],N=0,H=$=>{let P=3*U[(N+$)*T+A],[z,D,B]=[S[P],S[P+1],S[P+2]];for(let Q=0;Q<3;Q++)L.push(r*(p[4*Q]*z+p[4*Q+1]*D+p[4*Q+2]*B+p[4*Q+3]))};for(let $ of w){for(let P=2;P<$;P++)for(let z of[0,P-1,P])H(z);N+=$}L.length&&L.every(Number.isFinite)&&a.push({at:Float32Array.from(L),colour:l(x.get(g.getAttribute("material")))})}}function h(f,p,x){if(!(x>60)){for(let m of f.children)xS[m.localName]&&(p=sL(p,xS[m.localName](fu(m))));for(let m of f.children)if(m.localName==="instance_geometry"){let g=new Map([...m.getElementsByTagName("*")].filter(_=>_.localName==="instance_material").map(_=>[_.getAttribute("symbol"),_.getAttribute("target")]));u(s(m.getAttribute("url")),p,g)}else if(m.localName==="node")h(m,p,x+1);else if(m.localName==="instance_node"){let g=s(m.getAttribute("url"));g&&h(g,p,x+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var $f=[],pu=new Map,qf=0;function aL(){if($f.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=pu.get(t);pu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of pu.values())t(new Error("meshes cannot be read in this browser"));pu.clear()},$f.push(n),n}return $f[qf%$f.length]}function vS(n,t){return new Promise((e,i)=>{qf+=1,pu.set(qf,{resolve:e,reject:i}),aL().postMessage({id:qf,...n},t)})}async function bS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=yS(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await vS({at:r},[r.buffer]),colour:o})))}return[{mesh:await vS({bytes:i,kind:e},[i]),colour:null}]}var MS={light:"#c9ced6",dark:"#8b96a6"},Ml=new Rn,ks=[],mu=0,ES=!1,TS=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function Sl(n,t,e=null){b.looks=n?.shapes.length?{...n,key:TS(t),files:e}:null,n?.notes.length&&Me(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),lL()}var L0=()=>!!(b.looks&&b.looks.key===TS(b.table)),D0=()=>L0()?b.look.mode:"sketch",Xf=null;function lL(){if(Xf===b.looks)return;Xf=b.looks;for(let t of ks)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();ks=[],Ml.clear();let n=Xf;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){wS(t,[cL[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(mu+=1,bS(e,t.url??t.file).then(i=>{if(Xf===n)for(let{mesh:s,colour:r}of i){let o=I0(s),a=s.some===s?o:I0(s.some);wS(t,[o,a,s.few===s.some?a:I0(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>Me(`${t.name}: ${i.message}`,"wrong")).finally(()=>{mu-=1,bl(),mu||ut("looks","loaded")}))}ut("looks"),bl()}var SS=n=>n.rotateX(Math.PI/2),cL={box:n=>new ki(...n),cylinder:([n,t])=>SS(new Ri(n,n,t,36)),capsule:([n,t])=>SS(new Uo(n,t,8,24)),sphere:([n])=>new Cs(n,28,16)};function I0(n){let t=new Ae;return t.setAttribute("position",new ze(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new ze(n.normal,3):uL(n.normal)),t.setIndex(new ze(n.index,1)),t}function uL(n){return new za(new ka(n,4),3,0,!0)}function wS(n,[t,e=t,i=e],s,r=null,o=!0){let a=hv(o),l=new je(t,a),c=new je(i,lf),u=new _e().set(...n.T);r&&u.scale(new G(...r));for(let h of[l,c])h.matrixAutoUpdate=!1,h.frustumCulled=!1;c.renderOrder=-1,Ml.add(l,c),ks.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:l,shadow:c,colour:s}),gu()}var hL=new _e;function bl(){AS(),xe()}function AS(){let n=D0();if(Ml.visible=n!=="sketch"&&ks.length>0,Xv(n!=="real"||mu>0,n!=="sketch"&&ks.length>0),!!Ml.visible)for(let t of ks){let e=b.frames[t.on];e&&(t.mesh.geometry=ES?t.few:tv()?t.some:t.fine,t.mesh.matrix.copy(hL.set(...e)).multiply(t.T),t.shadow.matrix.copy(Ng).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function gu(){let n=D0()==="both"?b.look.opacity:1;for(let{mesh:t,colour:e}of ks){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,Ei):t.material.colour.set(Ft.dark?MS.dark:MS.light),t.material.see((o??1)*n,Ft.dark)}xe()}function N0(n){b.look={...b.look,...n},gu(),bl(),ut("look")}function RS(){pn.add(Ml),nt("table",()=>{bl(),gu(),ut("looks")}),nt("q",bl),nt("theme",gu),nt("look",n=>{n==="loaded"&&(gu(),bl())}),nt("hurry",n=>{ES=n,AS()})}var CS=()=>({mode:D0(),visible:Ml.visible,loading:mu,shapes:ks.length,triangles:ks.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:ks.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:ks.map(n=>n.mesh.matrix.clone().transpose().toArray())});function IS(){let n=Ve("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],b.look.mode,s=>N0({mode:s}),"look"),t=M("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(b.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>N0({opacity:Number(t.value)})}}),e=M("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!L0(),n.mark(b.look.mode),t.hidden=b.look.mode!=="both",t.value=String(b.look.opacity)};return nt(["looks","look","table"],i),i(),e}function DS(n){let t=M("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>LS(t.value)}}),e=_S(LS),i=M("p",{class:"sentence","data-testid":"sentence"}),s=M("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=Ut(u,{"aria-label":h},d);return p.show=x=>{p.disabled=!x,p.title=x?`${h}: ${x} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",x??"")},p},o=r("\u21B6","Undo",Gg,"Ctrl+Z"),a=r("\u21B7","Redo",Vg,"Ctrl+Shift+Z");nt("history",()=>{o.show(pf()),a.show(mf())});let l=()=>{let{name:u,derived:h,catalog:d}=b.table,f=d?[]:[M("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Wt(t,f,(b.catalog??[]).map(p=>M("option",{value:p,text:p}))),t.value=d??""},c=M("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(M("h1",{class:"mark"},M("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),M("span",{text:"pieper"})),t,Ut("Find\u2026",{class:"find","aria-label":"Find an arm in the catalogue","data-testid":"find-arm"},e),c,i,M("span",{class:"bar-end"},s,Ve("Angles in",[["deg","\xB0"],["rad","rad"]],gt.angle,u=>{gt.set("angle",u),ut("units")},"unit-angle"),Ve("Lengths in",[["mm","mm"],["m","m"]],gt.length,u=>{gt.set("length",u),ut("units")},"unit-length"),un("Size of the letters",[1,1.15,1.3,1.5].map(u=>[String(u),`${Math.round(100*u)} %`]),String(Jm()),u=>By(Number(u)),{"data-testid":"text-size"}),un("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],b.theme,Od,{"data-testid":"theme"}))),ut("history"),nt(["catalog","table"],l),nt("plan",()=>{bt(i,[Nu(b.plan),B_(b.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=b.plan?.explain??""}),nt("online",u=>{bt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),nt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(gt.angle),n.querySelector("[data-testid=unit-length]").mark(gt.length),n.querySelector("[data-testid=theme]").value=b.theme})}async function LS(n){if(n)try{let{table:t}=await Zi("load",{name:n});yn(t,{q:ma(t),what:"new",label:`open ${n}`})}catch(t){Me(t.message,"wrong")}}function NS(n,t,e,i){let s=M("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=M("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=M("section",{class:"section"},M("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=Ut(c.title,{role:"tab",id:`tab-${c.id}`,"aria-controls":u.id},()=>l(c.id));return c.group&&s.append(M("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(b.panel,t.scrollTop),b.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ut("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===b.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(b.panel==="move"||!a.some(c=>c.id===b.panel)?"move":b.panel)),l(b.panel),l}function US(n){let t=M("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>Ut(u,{},()=>sg(c))),Ut("Fit",{},()=>Kc())),e=M("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=Ut("Trace",{"aria-pressed":"true"},()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),lb(c)}),s=Ut("Clear",{"aria-label":"Clear the trace"},hf),r=M("span",{class:"scale"}),o=M("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=M("span",{class:"dot"});return h.style.setProperty("background",Dr[u]),M("span",{},h,c)}),r);n.append(M("div",{class:"corner top"},t,M("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),IS(),M("div",{class:"group",role:"group","aria-label":"The picture"},pS(n),Ut("PNG",{"aria-label":"Save the picture","data-testid":"save-picture"},mS))),M("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=b.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);b.shownFrames=(b.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{b.shownFrames=d,l()};Wt(e,M("span",{class:"group-name",text:"Frames"}),u.map(d=>Ut(uf(d),{"aria-pressed":String(b.shownFrames.includes(d)),"aria-label":`Frame ${uf(d)}`},()=>h(b.shownFrames.includes(d)?b.shownFrames.filter(f=>f!==d):[...b.shownFrames,d]))),Ut(b.shownFrames.length===c+2?"none":"all",{"aria-label":"All frames or none"},()=>h(b.shownFrames.length===c+2?[]:u))),ut("frames"),bt(r,`grid ${he(ag.cell,"length",gt.length==="mm"?0:2)}`)};nt(["table","units"],l),l()}function OS(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Gg()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Vg()))})}var U0=()=>b.frames[b.frames.length-1],BS={id:"pose",title:"Pose",build(n){let t=vl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>FS(u,"length",`pose-${u.toLowerCase()}`)),i=M("div",{class:"quantities","data-testid":"orientation"}),s=M("p",{class:"hint order"}),r=[],o=un("Notation of the orientation",Object.entries(Ds).map(([u,h])=>[u,h.title]),b.notation,u=>{b.notation=u,ut("notation")}),a=M("span",{class:"copies"},Ut("Copy matrix",{class:"quiet",title:"As numbers in metres, row by row"},()=>Xr(Wf(U0()))),Ut("Copy numbers",{class:"quiet",title:"Position and orientation, in the units shown"},()=>Xr(dL())));n.append(M("div",{class:"subhead"},M("span",{text:"Tool in the base frame"}),a),t,M("div",{class:"quantities"},e.map(u=>u.el)),M("div",{class:"line"},o,s),i);let l=()=>{let u=Ds[b.notation];o.value=b.notation,bt(s,u.order),r=u.names.map((h,d)=>FS(h,u.kinds[d],`turn-${d}`)),Wt(i,r.map(h=>h.el)),c()},c=()=>{let u=U0();t.show(u),te(u).forEach((h,d)=>e[d].show(h)),Ds[b.notation].to(u).forEach((h,d)=>r[d].show(h))};nt("q",c),nt("notation",l),nt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function dL(){let n=U0(),t=Ds[b.notation],e=te(n).map((s,r)=>`${"XYZ"[r]} ${mn(s,"length")} ${gt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${mn(s,"angle")} ${gt.symbol("angle")}`:ei(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function FS(n,t,e){let i=M("output",{"data-testid":e}),s=M("span",{class:"unit",text:gt.symbol(t)});return{el:M("div",{class:"quantity"},M("span",{class:"quantity-name",text:n}),i,s),show:o=>bt(i,t==="plain"?ei(o,5):mn(o,t)),relabel:()=>bt(s,gt.symbol(t))}}function fL(n,t){let e=[],i=n.joints.length,s=xr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=_r(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*_r(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var kS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=M("div",{class:"cards","data-testid":"matrices"}),a=M("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=un("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),c=M("span",{class:"partial"});n.append(M("div",{class:"line"},Ve("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),c),M("div",{class:"line"},M("span",{class:"field-name",text:"Numbers of the"}),l),o,M("h3",{text:"Intermediate angles"}),M("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&b.solutions?.rows[Number(e)]?.q||b.q,h=()=>{let p=b.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let x=t==="links"?b.table.joints.map((g,_)=>["A",String(_+1),""]):t==="products"?b.table.joints.map((g,_)=>["T",String(_+1),"0"]):[["T",String(s),String(i)]];t==="links"&&x.push(["T","tool","base"]);let m=Array.from({length:p+1},(g,_)=>[String(_),String(_)]);Wt(c,t==="partial"?[un("From frame",m,String(i),g=>{i=Number(g),h()})," \u2192 ",un("To frame",m,String(s),g=>{s=Number(g),h()})]:[]),r=x.map(([g,_,T])=>({grid:vl(`${g} ${T} ${_}`,`matrix-${g}${T}${T?"-":""}${_}`),note:M("span",{class:"hint"}),sym:g,low:_,high:T})),Wt(o,r.map(({grid:g,note:_,sym:T,low:v,high:A})=>M("figure",{class:"card"},M("figcaption",{},M("span",{class:"symbol"},A?M("sup",{text:A}):null,M("i",{text:T}),M("sub",{text:v})),_),g))),d()},d=Zs(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let p=u(),x=A_(b.table,p),m=x.length;r.forEach(({grid:T,note:v},A)=>{if(t==="links"&&A<m)T.show(x[A]),bt(v,`q${A+1} = ${he(p[A],Ze(b.table.joints[A]))}`);else if(t==="links")T.show(Ss(b.table,p)[m+1]);else if(t==="products")T.show(x.slice(0,A+1).reduce(Hn,ji()));else{let S=y=>x.slice(0,y).reduce(Hn,ji());T.show(Hn(pa(S(i)),S(s)))}});let g=xr(b.table,p),_=b.table.joints.map((T,v)=>[T.type==="R"?`\u03B8${v+1}`:`d${v+1}`,T.type==="R"?mn(_r(T,g[v]).theta,"angle"):mn(_r(T,g[v]).d,"length"),T.type==="R"?"angle":"length"]).concat(fL(b.table,p).map(({name:T,value:v})=>[`\u03B8${T}`,mn(v,"angle"),"angle"]));Wt(a,M("tbody",{},_.map(([T,v,A])=>M("tr",{},M("th",{scope:"row"},M("i",{text:T[0]}),M("sub",{text:T.slice(1)})),M("td",{text:v}),M("td",{class:"unit",text:gt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=b.solutions?.rows??[];Wt(l,M("option",{value:"now",text:"present posture"}),p.map((x,m)=>M("option",{value:String(m),text:`solution ${m+1}: ${x.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),l.value=e,d()};nt("table",h),nt(["q","units","panel"],d),nt(["solutions","panel"],f),h()}};var pL=.002;function zs(n,t,e,i){let s=[],r="",o=M("div",{class:"pose-fields"}),a=()=>{let c=Ds[b.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=bv(b.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,mL(s))};s=u.map(([d,f],p)=>{let x={value:0,kind:f},m=(g,_)=>{x.value=g,x.text=_.text,h()};return x.f=Mn({label:`${n}, ${d}`,kind:f,testid:`${t}-${p}`,input:m,commit:(g,_)=>{m(g,_),ut("let-go")}}),x.el=M("label",{class:"pose-field"},M("span",{text:d}),x.f,M("span",{class:"unit",text:gt.symbol(f)})),x}),Wt(o,s.map(d=>d.el)),r=b.notation},l=()=>{r!==b.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...te(c),...Ds[b.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,gL(u,s[h].kind))})};return nt("units",()=>{a(),l()}),nt("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=Mf(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),Sf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:M("fieldset",{class:"pose-editor"},M("legend",{text:n}),o),show:l}}function mL(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?sl(t(e),"angle"):2*sl(t(n.slice(3)),"plain");return{metres:sl(t(n.slice(0,3)),"length"),radians:i}}var gL=(n,t)=>String(Number((n*gt.factor(t)).toFixed(t==="plain"||gt[t]==="m"||gt[t]==="rad"?6:3))+0);function zS(n){let t=n.match(HS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:sl(e,"length"),radians:2*sl(i,"plain")}}var HS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function GS(n){let t=(n.replaceAll("\u2212","-").match(HS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Cu(e);if(i>pL)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=gt.factor("length");return Pu(e)}function Yf(n){return n.map((t,e)=>{let i=b.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((b.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function VS(n,t){let e=t?.self_motions??[],i=de.task??b.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Wt(n,M("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let p=d.moves.length>3?"most of its joints":d.moves.join(" and "),x=d.inside.length?vL(d):"All of it lies outside the limits.";return M("div",{class:"self-motion"},M("p",{},M("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${p}, ${a(d)}: the arm moves, ${o}. ${x}`),ML(d,f,t.T,s))},c=e.length?xL(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?M("details",{class:"fold"},M("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Wt(n,c>=0?l(e[c],c):null,h)}var _L=n=>n.reduce((t,e,i)=>t+Math.sin((e-b.q[i])/2)**2,0),xL=n=>{let t=n.map(e=>Math.min(...e.q.map(_L)));return t.indexOf(Math.min(...t))};function yL(n){let t=(s,r)=>s.map((o,a)=>b.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(b.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var vL=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function bL(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function ML(n,t,e,i){let s=M("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{gi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ut("did",{label:"slide along a self-motion",key:"self-motion"}),Ui(Yf(i?C_(b.table,u,e):u),"self-motion")};return s.value=String(yL(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",bL(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function WS(){let n=[],t=[],e={},i=M("div",{class:"joints"}),s=M("details",{},M("summary",{class:"hint",text:"Hold by value"}),i),r=M("p",{class:"hint"}),o=Ve("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=M("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},M("div",{class:"line spread"},M("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:p=!1}={}){ut("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),de.redundancy=f&&Object.fromEntries(f.map(x=>[x,e[x]])),d(),p?hb():Us({follow:!0})}let c=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>b.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let x=f.kind==="angle"?Math.PI:ci(b.table),m=f.lower??-x,g=f.upper??x,_=M("input",{type:"range",min:String(m),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),T=!1,v=(w,U)=>{e[f.name]=w,l(c(f),{sliding:U})};_.addEventListener("input",()=>v(Number(_.value),!0)),_.addEventListener("change",()=>Us({follow:!0})),_.addEventListener("keydown",w=>{let U={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[w.key];if(U===void 0)return;w.preventDefault(),T=!0;let L=U*gt.step(f.kind)*(w.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+L,m),g),!0)}),_.addEventListener("keyup",()=>{T&&Us({follow:!0}),T=!1});let A=Mn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:w=>w<m-1e-9&&f.lower!==null?`below the limit ${he(m,f.kind)}`:w>g+1e-9&&f.upper!==null?`above the limit ${he(g,f.kind)}`:null,commit:w=>v(w,!1)}),S=M("span",{class:"limits"}),y=M("div",{class:"joint"},M("span",{class:"joint-name",text:f.name}),M("div",{class:"track"},_,M("div",{class:"under"},S)),A,M("span",{class:"unit"}));return{line:y,show(){let w=e[f.name];_.value=w,_.style.setProperty("--at",`${100*(Math.min(Math.max(w,m),g)-m)/(g-m||1)}%`),_.setAttribute("aria-valuetext",he(w,f.kind)),y.classList.toggle("held",!!(de.redundancy&&f.name in de.redundancy)),A.put(Number((w*gt.factor(f.kind)).toFixed(gt.digits(f.kind)+1))/gt.factor(f.kind))},relabel(){bt(y.lastChild,gt.symbol(f.kind));let w=U=>U===null?"no limit":he(U,f.kind,f.kind==="angle"&&gt.angle==="deg"?0:void 0);bt(S,f.lower===null&&f.upper===null?"no limits":`${w(f.lower)} \u2026 ${w(f.upper)}`),A.refresh()}}}function d(){for(let f of n)de.redundancy&&f.name in de.redundancy?e[f.name]=de.redundancy[f.name]:u(f)>=0?e[f.name]=b.q[u(f)]:f.instead&&Number.isFinite(b.solutions?.arm_angle)?e[f.name]=b.solutions.arm_angle:e[f.name]??=0;o.mark(de.redundancy?"chosen":"free"),bt(r,de.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return nt("solutions",()=>{let f=b.solutions?.spare;if(!b.solutions||!f&&(b.solutions.brief||b.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Wt(i,t.map(x=>x.line));for(let x of t)x.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(x=>!x.instead).length>1||!!de.redundancy),d()}),nt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!de.redundancy&&d()),nt("units",()=>{for(let f of t)f.relabel();d()}),a}function $S(){let n=M("thead"),t=M("tbody"),e=M("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=M("div",{class:"scroll"},M("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${b.table.joints.map(c=>c.type).join("")}${gt.angle}${gt.length}`;l!==r&&(r=l,s=[],Wt(t),Wt(n,M("tr",{},M("td"),M("th",{class:"left",text:"posture"}),b.table.joints.map((c,u)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(u+1)}),M("span",{class:"unit",text:` ${gt.symbol(Ze(c))}`}))),M("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=b.table.joints.map(()=>M("td")),u=M("span"),h=M("span",{class:"offscreen"}),d=M("td",{class:"unit"}),f=M("tr",{tabindex:"0","data-testid":`solution-${l+1}`},M("th",{scope:"row",text:String(l+1)}),M("td",{class:"left"},u,h),c,d),p=()=>b.solutions?.rows[l]?.q,x=()=>p()&&ps(p()),m=()=>ps(null),g=()=>{p()&&(ps(null),Ci(Yf(p()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",x),f.addEventListener("pointerleave",m),f.addEventListener("focus",x),f.addEventListener("blur",m),f.addEventListener("click",g),f.addEventListener("keydown",_=>{(_.key==="Enter"||_.key===" ")&&(_.preventDefault(),g())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&bt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),bt(u.beyond,d.inside?"":", outside the limits"),bt(u.residual,d.residual?jd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${jd(d.residual[0])} m, ${jd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let x=b.table.joints[p],m=x.lower!==null&&f<x.lower-1e-9||x.upper!==null&&f>x.upper+1e-9;bt(u.cells[p],mn(f,Ze(x))),u.cells[p].classList.toggle("out",m)}))}),this.mark()},mark(){let l=b.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===b.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-b.q[d])/2))<1e-5)))}}}var SL={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},O0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},wL=new Set(["REDUNDANT","UNCERTAIN"]),EL=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,F0=120;function B0(){Si(b.frames[b.frames.length-1].slice(),"taken")}var XS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(M("div",{class:"line spread"},Ut("Take the present pose",{"data-testid":"take-pose"},B0),Ve("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",x=>{i.hidden=x!=="numbers",s.hidden=x!=="matrix"},"target-as")));let e=zs("Target","target",()=>b.target,(x,m)=>Si(x,"typed",m)),i=M("div",{},e.el),{el:s,show:r}=AL();n.append(i,s,RL());let o=M("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=M("div",{class:"near","data-testid":"ik-nearest"}),l=M("div",{class:"self-motions","data-testid":"self-motions"}),c=$S();n.append(WS(),o,a,l,c.el);let u=ga(F0,()=>{e.show(),r()}),h=ga(F0,()=>{if(t.hidden)return;let x=b.solutions;CL(o,x),LL(a,x),VS(l,x),c.show(x)}),d=ga(F0,()=>c.mark()),f=x=>()=>sf()?x.soon():x();nt("target",f(u)),nt("notation",e.show),nt(["solutions","units"],f(h)),nt("q",f(d));let p=()=>Or("target",b.panel==="inverse"?TL(te(b.target)):[]);nt("target",x=>x!=="drag"&&p()),nt("panel",x=>{Bv(x==="inverse"),(x!=="inverse"||b.hasTarget)&&p(),x==="inverse"&&(b.hasTarget?ut("solutions"):(b.hasTarget=!0,B0()))}),nt("table",x=>{x==="new"&&(b.hasTarget=b.panel==="inverse",b.hasTarget&&B0())})}};function TL(n){let t=.25*ci(b.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function AL(){let n=M("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=M("p",{class:"reason",role:"alert"}),e=M("p",{class:"hint"});n.addEventListener("input",()=>{try{Si(GS(n.value),"typed",zS(n.value)),bt(t,""),n.removeAttribute("aria-invalid")}catch(s){bt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(bt(e,`Twelve or sixteen numbers, row by row; the last column in ${gt.length}.`),document.activeElement===n)return;let s=b.target.map((r,o)=>o%4===3&&o<12?r*gt.factor("length"):r);n.value=Wf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return nt("units",i),i(),{el:M("div",{hidden:!0},n,e,t),show:i}}function RL(){let n=M("span",{class:"line"}),t=M("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{de.follow=t.checked}}}),e=Ve("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{de.ghosts=i,ll()});return nt("task",()=>{t.checked=de.follow,e.mark(de.ghosts)}),nt("plan",()=>Wt(n,b.plan?.solvable?[M("span",{class:"field-name",text:"Task"}),un("Task",[["",`${b.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],de.task??"",i=>{ut("did",{label:"choose the task"}),de.task=i||null,de.redundancy=null,Us()},{"data-testid":"task"})]:[])),M("div",{class:"line controls"},M("span",{class:"line"},M("span",{class:"field-name",text:"Handles"}),Ve("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",kv)),Ve("Axes of the handles",[["local","Tool"],["world","World"]],"local",zv),M("span",{class:"line"},M("span",{class:"field-name",text:"Snap"}),un("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>Hv(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),M("span",{class:"line"},M("span",{class:"field-name",text:"Ghosts"}),e),M("label",{class:"check"},t,"Arm follows"),n)}function CL(n,t){if(!t){Wt(n,M("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=SL[t.status]??"note";let s=t.status==="SOLVED"&&e?qS(t.missed):[t.why,t.status==="SINGULAR"?EL(e,i):"",qS(t.missed)].filter(Boolean).join(" "),r=O0[t.status]&&!i?t.why.toLowerCase().includes(O0[t.status].toLowerCase())?"":O0[t.status]:t.status==="SINGULAR"||wL.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Wt(n,M("strong",{text:r})," ",M("span",{text:s}),t.ms===void 0?null:M("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var qS=n=>n?`The pose was rounded by ${IL(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",PL=(n,t)=>he(n,t,gt.digits(t)+2),IL=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*gt.factor(e)>=.5*10**-(gt.digits(e)+2)).map(([t,e])=>PL(t,e)).join(" and ");function LL(n,t){let e=t?.near;if(!e){Wt(n);return}let i=te(e.T).map(s=>mn(s,"length")).join(", ");Wt(n,M("p",{},M("strong",{text:"Nearest reachable: "}),`${i} ${gt.symbol("length")}, ${he(e.metres,"length")} away`,e.radians>.001?`, turned by ${he(e.radians,"angle")}`:""),M("div",{class:"line"},Ut("Go there",{},()=>Ci(e.q)),Ut("Make it the target",{},()=>Si(e.T,"chosen"))))}var k0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function jf(n){return k0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Zf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=jf(r)??{a:0,alpha:0};jf(r)&&(r=ji()),o=Hn(k0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=jf(o)??{a:0,alpha:0};jf(o)&&(o=ji()),r=Hn(r,k0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var YS=30,DL=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),NL={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},wl=null;function jS(n,t){wl={label:n,key:"paste",open:!0};try{t(wl)}finally{wl=null,ut("let-go")}}function Jf(n,t,e,{symbolic:i,text:s},r){let o=b.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(b.table.joints[n][t],e)&&b.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${NL[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||yn({...b.table,joints:o},wl?{...c,...wl}:c),r&&!wl&&ut("let-go")}function El(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=b.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(b.q,0),c=o?t(o,null).map((u,h)=>UL(u&&t(u,0),h,n.length)):null;yn({...b.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var UL=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function ZS(n,t,e){let i=b.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function z0({label:n,key:t,open:e}={}){let i=b.table.joints.length;return i>=YS?(Me(`At most ${YS} joints.`,"wrong"),!1):(El([...b.table.joints,DL(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function JS(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};El(e(b.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function Kf(){try{ui(`${b.table.name||"arm"}.toml`,(await Fe("save",{})).text,"application/toml")}catch(n){Me(n.message,"wrong")}}function tw(){let n=(t,e,i)=>{let s=M("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>FL(s)}});return[Ut(t,{title:e},()=>s.click()),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var OL=/\.(toml|urdf|xml)$/i,KS=2e5;async function FL(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>OL.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){Me("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>KS){Me(`${i.name} has ${i.size} bytes; a robot file has at most ${KS.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Zi("open",{name:i.name.slice(-80),text:await i.text()});yn(s,{q:ma(s),what:"new",label:`open ${i.name.slice(-40)}`}),Sl(r,s,a=>QS(t,a));let o=r?.shapes.filter(a=>a.file&&!QS(t,a.file)).length;o&&Me(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){Me(s.message,"wrong")}}function QS(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var H0=(n,t,e,i=!1)=>Ut(n,{class:"icon","aria-label":t,disabled:i},e),yo=({k:n,n:t,name:e,move:i=null,remove:s})=>[...i?[H0("\u2191",`Move ${e} up`,()=>i(n,n-1),n===0),H0("\u2193",`Move ${e} down`,()=>i(n,n+1),n===t-1)]:[],H0("\xD7",`Remove ${e}`,()=>s(n))];var G0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},BL=({catalog:n,...t})=>n?{...t,derived:n}:t,kL=n=>n.type==="R"?"angle":"length",ew={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=M("thead"),s=M("tbody"),r=M("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=M("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=M("p",{class:"verdict","data-testid":"arm-kind"}),l=Ve("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],b.table.convention,_=>{_!==b.table.convention&&yn(Zf(b.table,_),{what:"rows",label:`make the table ${_}`})},"convention"),c=M("p",{class:"hint order"}),u=M("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>yn({...BL(b.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=zs("Base","base",()=>b.table.base,_=>yn({...b.table,base:_},{what:"cell",label:"edit the base",key:"base",open:!0})),d=zs("Tool","tool",()=>b.table.tool,_=>yn({...b.table,tool:_},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(M("div",{class:"line spread"},M("span",{class:"line"},u),M("span",{class:"line"},Ut("Blank",{title:"An empty table"},()=>yn(P_(b.table.convention),{q:[],what:"new",label:"begin a blank table"})),...tw(),Ut("Save",{title:"As a robot file"},Kf))),M("div",{class:"line spread"},l,Ve("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,_=>{t=_,m()},"dh-part")),c,r,M("div",{class:"line"},Ut("+ Add joint",{class:"add","data-testid":"add-joint"},()=>z0()),M("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,vv(),M("details",{class:"fold","data-testid":"base-tool"},M("summary",{text:"Base and tool"}),h.el,d.el)),s.addEventListener("paste",_=>{let T=Mf(_.clipboardData.getData("text")),v=()=>[...s.rows].map(y=>[...y.querySelectorAll("input.number")]);if(!T||!_.target.matches("input.number"))return;_.preventDefault();let A=v().findIndex(y=>y.includes(_.target)),S=v()[A].indexOf(_.target);jS("paste a table",y=>{for(;b.table.joints.length<A+T.length&&z0(y););let w=Sf(v(),A,S,T),U=T.flat().length;Me(`Pasted ${w} number${w===1?"":"s"}${w<U?`; ${U-w} had no cell`:""}`)})}),n.addEventListener("verdict",_=>{let T=_.detail??zL(n);bt(o,T?`${T.label}: ${T.reason}. The arm stays as it was.`:"")});let f=(_,T,[v,A,S])=>{let y=_.type==="R"&&v==="theta"||_.type==="P"&&v==="d",w=v==="lower"||v==="upper",U=Mn({label:`Joint ${T+1}, ${A}`,kind:S??kL(_),testid:`dh-${T+1}-${v}`,empty:w?null:void 0,check:L=>w?ZS(T,v,L):L!==null&&Math.abs(L)>1e6?"larger than a million":null,input:(L,N)=>Jf(T,v,L,N,!1),commit:(L,N)=>Jf(T,v,L,N,!0)});return w&&(U.placeholder="none"),e.push({f:U,i:T,key:v}),M("td",{class:y?"variable":""},y?M("span",{class:"plus"},M("i",{text:"q"}),M("sub",{text:String(T+1)})," +"):null,U)},p=(_,T)=>Ut(_.type,{class:`type type-${_.type}`,"data-testid":`dh-${T+1}-type`,"aria-label":`Joint ${T+1} is ${_.type==="R"?"revolute":"prismatic"}; press to change`,title:_.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute."},()=>El(b.table.joints.map((v,A)=>A===T?{...v,type:v.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...v.text,lower:void 0,upper:void 0,offset:void 0}}:v),v=>v.map((A,S)=>S===T&&typeof A=="number"?0:A),`make joint ${T+1} ${_.type==="R"?"prismatic":"revolute"}`)),x=(_,T)=>M("td",{class:"tools"},yo({k:_,n:T,name:`joint ${_+1}`,move:JS,remove:()=>El(b.table.joints.filter((v,A)=>A!==_),v=>v.filter((A,S)=>S!==_),`remove joint ${_+1}`)})),m=()=>{e=[];let{joints:_}=b.table,T=b.table.convention==="modified",v=t==="geometry"?G0.geometry.map(([A,S,y])=>M("th",{scope:"col"},M("i",{text:S}),M("sub",{text:T&&(A==="a"||A==="alpha")?"i\u22121":"i"}),M("span",{class:"unit",text:` ${gt.symbol(y)}`}))):["name","lower limit","upper limit","zero","sense"].map(A=>M("th",{scope:"col",text:A}));Wt(i,M("tr",{},M("th",{scope:"col",text:"i"}),M("th",{scope:"col"},M("span",{class:"offscreen",text:"type"})),v,M("td"))),Wt(s,_.map((A,S)=>{let y=t==="geometry"?G0.geometry.map(w=>f(A,S,w)):[M("td",{},M("input",{type:"text",class:"name",value:A.name,maxlength:"40","aria-label":`Joint ${S+1}, name`,on:{change:w=>Jf(S,"name",w.target.value||`joint_${S+1}`,{},!0)}})),...G0.joint.map(w=>f(A,S,w)),M("td",{},Ut(A.sign>0?"+":"\u2212",{class:"type","aria-label":`Joint ${S+1}, sense of the maker: ${A.sign>0?"as the table":"against the table"}`},()=>El(b.table.joints.map((w,U)=>U===S?{...w,sign:-w.sign}:w),w=>w,`turn the sense of joint ${S+1}`)))];return M("tr",{"data-testid":`dh-row-${S+1}`},M("th",{scope:"row",text:String(S+1)}),M("td",{},p(A,S)),y,x(S,_.length))})),_.length||s.append(M("tr",{},M("td",{colspan:"7",class:"hint",text:"No joints yet."}))),g()},g=()=>{for(let{f:_,i:T,key:v}of e){let A=b.table.joints[T];_.put(A[v],A.text?.[v]??null)}l.mark(b.table.convention),bt(c,b.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=b.table.name),h.show(),d.show()};nt("table",_=>{bt(o,""),_==="cell"||_==="name"||_==="postures"?g():m()}),nt("units",m),nt("notation",()=>{h.show(),d.show()}),nt("plan",()=>{a.dataset.tone=b.plan?.solvable?"good":"wrong",Wt(a,M("strong",{text:Nu(b.plan)||(b.plan?.refused?"Refused":"Not solved")})," ",M("span",{text:b.plan?.explain??""}))}),m()}};function zL(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var HL=4,GL=n=>{let t=n.toFixed(HL);return Number(t)<0?`(${t})`:t.replace("-","")};function Qf(n,t,e){let i=xr(t,e),s=t.joints.map((c,u)=>_r(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,GL(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var tp=null;async function VL(){return tp??=(await import("./katex-LOBGZRV6.js")).default,tp}function WL(n,t){let e=M("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function nw(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>WL(n,i)],[i=>"code"in i,i=>M("code",{text:i.code})],[()=>!0,i=>M("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var $L=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function qL(n){let t=b.table.joints.map((e,i)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(i+1)}),M("span",{class:"unit",text:` ${gt.symbol(Ze(e))}`})));return[M("h3",{text:"The formulas at the present pose"}),M("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},M("thead",{},M("tr",{},M("th",{text:"branch"}),t)),M("tbody",{},n.map((e,i)=>M("tr",{},M("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>M("td",{text:mn(s,Ze(b.table.joints[r]))}))))))]}var iw={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=M("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=M("div",{class:"equations","data-testid":"equations"}),c=Ve("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,x()},"equation-numbers"),u=M("div",{class:"scroll"});n.append(M("div",{class:"line spread"},M("span",{class:"line"},Ve("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,x()},"which-equations"),c),Ut("Copy LaTeX",{class:"quiet"},()=>Xr(f()))),a,u,l);let h=v=>v.symbols&&i==="present"?Qf(v,b.table,b.q):v.latex,d=v=>v.number===void 0?"":` \\tag{${v.number}}`,f=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${d(v)} \\]`:$L(v.pieces)).join(`

`);function p(v){r=[],Wt(l,o.map(A=>m(v,A))),g()}async function x(){if(t.hidden||!b.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(b.table.joints)}${b.table.convention}`;if(s!==v){s=v,bt(a,"Deriving \u2026"),Wt(l);try{let[A,S]=await Promise.all([VL(),Fe("equations",{which:e,numbers:i==="symbols"?i:"numbers"},y=>bt(a,y.note??""))]);if(s!==v)return;bt(a,S.note??""),o=S.blocks,p(A),c.hidden=e!=="forward",Wt(u),_()}catch(A){if(s!==v)return;s=null,bt(a,A.message)}}}function m(v,A){if(A.kind==="heading"||A.kind==="step")return M("h3",{},nw(v,A.pieces));if(A.kind!=="equation")return M("p",{class:"prose"},nw(v,A.pieces));let S=M("div",{class:"formula"});try{v.render(h(A),S,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{S.replaceChildren(M("code",{text:h(A)}))}if(A.number!==void 0)return M("div",{class:"formula-row numbered"},S,M("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return S;let y=M("output",{class:"value","data-entry":String(A.entry)});return r.push({value:y,entry:A.entry}),M("div",{class:"formula-row"},S,y)}let g=Zs(()=>{if(t.hidden)return;let v=b.frames[b.frames.length-1];for(let{value:A,entry:S}of r)bt(A,`= ${S%4===3?`${ei(v[S]*gt.factor("length"),gt.digits("length"))} ${gt.length}`:ei(v[S],4)}`)}),_=Js(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:v}=await Fe("formulas",{T:b.frames.at(-1)});Wt(u,v.length&&e==="inverse"?qL(v):null)}catch{Wt(u)}},250),T=Js(()=>{!t.hidden&&tp&&o.length&&e==="forward"&&i==="present"&&p(tp)},120);nt("q",T),nt("panel",T),nt("q",_),nt("units",_),nt("panel",x),nt("plan",x),nt(["q","units"],g)}};function vo(n){let t=M("p",{class:"verdict",role:"status","data-testid":n,hidden:!0});return t.say=(e,i="wrong")=>{t.hidden=!e,t.dataset.tone=i,bt(t,e)},t}function bo({text:n,working:t,testid:e,verdict:i,root:s,open:r=()=>!0,ask:o}){let a=M("button",{type:"button",class:"primary",text:n,"data-testid":e});return a.ask=async(...l)=>{let c=N_(s);if(c){i.say(c);return}a.disabled=!0,bt(a,t);try{await o(...l)}catch(u){i.say(u.message)}finally{bt(a,n),a.show()}},a.show=()=>{a.disabled=!r()},a.addEventListener("click",()=>a.ask()),a}var XL=()=>b.frames.at(-1).slice();function ep(n,t){let e=b.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{ut("did",{label:c,key:u}),e[a]=l,t(),ut("path",n)},r=["from","to"].map(a=>{let l=zs(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=Ut("Take the present pose",{class:"quiet","data-testid":`${i}take-${a}`},()=>{s(a,XL(),`take \u201C${a}\u201D of the path`),l.show()});return{el:M("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return nt("path",a=>a!==n&&o()),nt("path-loaded",o),nt("notation",o),{el:M("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var sw=()=>b.frames[b.frames.length-1].slice(),rw={id:"path",title:"Path",wide:!0,build(n,t){let e=b.path,i=ep("path",()=>h()),s=M("span",{class:"hint"}),r=Mn({label:"Number of points N",testid:"path-n",check:m=>Number.isInteger(m)&&m>=2&&m<=2e3?null:"a whole number from 2 to 2000",input:m=>{ut("did",{label:"set the points of the path",key:"path-n"}),e.n=m}}),o=Mn({label:"Seconds for the whole line",testid:"path-seconds",check:m=>m>0&&m<=3600?null:"more than 0, at most 3600",input:m=>{ut("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=m}}),a=Ut("Keep the orientation of \u201CFrom\u201D",{class:"quiet"},()=>{if(e.from&&e.to){let m=te(e.to);ut("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((g,_)=>{e.to[g]=m[_]}),i.show(),ut("path","path"),h()}}),l=vo("path-verdict"),c=bo({text:"Plan the line",working:"Planning \u2026",testid:"plan",verdict:l,root:n,ask:m=>d(m??b.q)}),u=M("div",{class:"branches","data-testid":"branches"});n.append(i.el,M("div",{class:"line"},a,s),M("div",{class:"line"},M("label",{class:"field"},M("span",{class:"field-name",text:"Points N"}),r),M("label",{class:"field"},M("span",{class:"field-name",text:"Seconds"}),o),c,M("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),l,u);let h=()=>{if(!e.from||!e.to){bt(s,"");return}let m=E_(e.from,e.to);bt(s,`${he(Ni(Di(te(e.to),te(e.from))),"length")} long${m>1e-6?`, turning ${he(m,"angle")}`:", orientation kept"}`),Wo(Array.from({length:33},(g,_)=>te(Kd(e.from,e.to,_/32))))};async function d(m){let g=await Fe("follow",{T0:e.from,T1:e.to,n:e.n,start:m});b.track=g,f(g,m)}function f(m){if(l.say(m.explain,m.complete?"good":"wrong"),Wt(u,m.branches.length?M("h3",{text:"Branches that start at the first pose"}):null,m.branches.map((v,A)=>M("button",{type:"button",class:`branch ${A===m.chosen?"chosen":""}`,"aria-pressed":String(A===m.chosen),"data-testid":`branch-${A+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await Ci(v.q,.4,`take branch ${A+1}`),c.ask(v.q)}}},M("span",{class:"branch-name",text:`${A+1}  ${v.label}`}),p(v.s),M("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),Wo(m.path.map(te)),!m.q.length){Li(null);return}let g=m.path.length,_=m.q.map((v,A)=>A+1),T=m.q.map((v,A)=>g>1?e.seconds*A/(g-1):0);Li(cr({table:b.table,q:m.q,xs:_,xName:"point",xEnd:g,seconds:T,title:`${b.table.name}: straight line, ${m.q.length} of ${g} points`,events:m.events.map(v=>({...v,x:1+v.s*(g-1),short:v.cause}))}))}function p(m){let g=M("span",{class:"bar-fill"});return g.style.setProperty("width",`${100*m}%`),M("span",{class:"bar"},g)}let x=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};nt("panel",m=>{m==="path"&&(e.from??=sw(),e.to??=sw(),x())}),nt("path-loaded",x),nt("units",h),nt("table",m=>{["postures","name","gripper"].includes(m)||(l.say(""),Wt(u),Wo([]),t.hidden||x())})}};var ow=Math.PI/180,YL=()=>({turn_speed:180*ow,turn_acceleration:600*ow,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var jL=n=>b.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??ji(),_u=n=>Hn(pa(jL(n)),b.frames.at(-1));function np(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(c=>c!==null),a=Math.min(...o),l=Math.min(Math.max(...o),t[r]);o.length===2&&a<=l&&(i[t[r]]={...s,first:a,last:l})}),i.filter(Boolean)}function Ko(n,t,{key:e,open:i}={}){ut("did",{label:t,key:e,open:i}),!b.program.length&&n.length&&(b.start??=b.q),b.program=n,ut("program")}var Qo=(n,t,e,i)=>Ko(b.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function aw(n,t){ut("did",{label:t,key:"limits"}),b.limits={...ip(),...n},ut("program","limits")}var ip=()=>({...YL(),...b.limits});function lw(n,t="set the start of the program"){ut("did",{label:t}),b.start=n,ut("program")}var sp=()=>b.start?.length===b.table.joints.length?b.start:b.q;function Tl(){let n=ip(),t=b.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:sp(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:b.program.map(({name:i,...s})=>s)}}var ZL=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),Mo=()=>b.routing??ZL();function Al(n,t,e=t){ut("did",{label:t,key:e}),b.routing={...Mo(),...n},ut("routing")}var V0=()=>{let n=Mo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function rp(){let n=Mo(),t=b.path,e=b.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:V0(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:b.world,clearance:e?n.clearance:0}}function W0(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Rl=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function cw(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Rl(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>W0(n,l)(o,r))}var ta=Math.PI/180,uw=3.4,JL=2.1,hw=.5,KL=.9;function dw({drag:n,drop:t,scrub:e}){let i=M("canvas",{"aria-hidden":"true"}),s=M("div",{class:"route-now",hidden:!0}),r=M("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(D=>M("div",{class:`route-end ${D}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":D==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${D}`,hidden:!0})),a=M("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function x(){let D=p(),B=a.clientWidth,Q=a.clientHeight,Y={l:uw*D,t:hw*D,w:B-(uw+KL)*D,h:Q-(hw+JL)*D},Z=-Math.PI,et=Math.PI;if(l.map&&!Rl(l.map))Z=l.map.turn[0],et=l.map.turn.at(-1);else if(l.turn.length){let dt=90*ta;Z=Math.min(Z,dt*Math.floor(Math.min(...l.turn)/dt)),et=Math.max(et,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...Y,lo:Z,hi:et,W:B,H:Q}}let m=D=>u.l+D*u.w,g=D=>u.t+(1-(D-u.lo)/(u.hi-u.lo))*u.h,_=D=>u.lo+(1-(D-u.t)/u.h)*(u.hi-u.lo),T=D=>Ft.curves[Math.max(l.branches.indexOf(D),0)%Ft.curves.length];function v(){f=(l.map?.branches??[]).map((D,B)=>{let Q=W0(l.map,B),Y=l.map.s.length,Z=l.map.turn.length,et=M("canvas",{width:Y,height:Z}),dt=et.getContext("2d"),ft=dt.createImageData(Y,Z),st=parseInt(T(D).slice(1),16);for(let yt=0;yt<Y;yt++)for(let _t=0;_t<Z;_t++){if(!Q(yt,_t))continue;let Tt=4*((Z-1-_t)*Y+yt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:D,c:et}})}function A(){if(!l||!a.clientWidth)return;x();let D=Math.min(devicePixelRatio,2),B=i.getContext("2d");i.width=u.W*D,i.height=u.H*D,B.scale(D,D);let Q=.76*p();B.font=`${Q}px "Inter Variable", system-ui, sans-serif`,B.fillStyle=Ft.ground,B.fillRect(u.l,u.t,u.w,u.h),B.save(),B.beginPath(),B.rect(u.l,u.t,u.w,u.h),B.clip(),S(B),y(B),w(B),B.restore(),U(B,Q),N()}function S(D){let B=l.map;if(!B)return;let Q=B.turn[1]-B.turn[0],Y=Rl(B),Z=B.turn[0]-Q/2,et=B.turn.at(-1)+Q/2,dt=Y?Math.floor((u.lo-Z)/(2*Math.PI)):0,ft=Y?Math.ceil((u.hi-et)/(2*Math.PI)):0;for(let{name:st,c:yt}of f)if(!(c&&c!==st)){D.globalAlpha=(c?.4:.3)*(Ft.dark?.8:1);for(let _t=dt;_t<=ft;_t++){let Tt=g(et+2*Math.PI*_t),At=g(Z+2*Math.PI*_t);D.drawImage(yt,u.l,Tt,u.w,At-Tt)}}D.globalAlpha=1}function y(D){if(!l.blocked)return;let[B,Q]=l.blocked.s,Y=m(B),Z=Math.max(m(Q)-Y,3);D.fillStyle=Ft.wrong,D.globalAlpha=.75,D.fillRect(Math.min(Y,u.l+u.w-Z),u.t,Z,u.h),D.globalAlpha=1}function w(D){if(!l.q.length)return;let B=[[0]];l.labels.forEach((Q,Y)=>{Y&&Q!==l.labels[Y-1]&&B.push([Y-1]),B.at(-1).push(Y)});for(let[Q,Y]of[[.38,!0],[.18,!1]])for(let Z of B){D.beginPath();for(let et of Z)D.lineTo(m(l.s[et]),g(l.turn[et]));D.lineWidth=Q*p(),D.lineJoin=D.lineCap="round",D.strokeStyle=Y?Ft.panel:Ft.curves[l.labels[Z.at(-1)]%Ft.curves.length],D.stroke()}}function U(D,B){D.strokeStyle=Ft.line,D.strokeRect(u.l,u.t,u.w,u.h),D.fillStyle=Ft.muted,D.textBaseline="middle",D.textAlign="right";let Q=(u.hi-u.lo)/ta,Y=[5,10,15,30,45,90,180].find(et=>Q/et<=6)??180;for(let et=Math.ceil(u.lo/ta/Y-1e-9)*Y;et<=u.hi/ta+1e-6;et+=Y){let dt=g(et*ta);D.fillText(mn(et*ta,"angle",gt.angle==="deg"?0:2),u.l-.45*B,dt),D.globalAlpha=.5,D.beginPath(),D.moveTo(u.l,dt),D.lineTo(u.l+u.w,dt),D.lineWidth=1,D.stroke(),D.globalAlpha=1}D.textBaseline="top",D.textAlign="center";let Z=u.t+u.h+.45*B;for(let et of[0,.25,.5,.75,1])D.fillText(String(et),m(et),Z);D.fillText("path, from 0 to 1",m(.5),Z+1.15*B),D.save(),D.translate(.5*B,u.t+u.h/2),D.rotate(-Math.PI/2),D.textBaseline="middle",D.fillText(`turn of the tool, ${gt.symbol("angle")}`,0,0),D.restore()}let L=D=>h?.which===D?h.turn:D==="start"?l.turn[0]:l.turn.at(-1);function N(){o.forEach((D,B)=>{let Q=B?"end":"start",Y=!!(l?.turn.length&&l.map);if(D.hidden=!Y,!Y)return;let Z=L(Q);D.style.setProperty("left",`${m(B)}px`),D.style.setProperty("top",`${g(Z)}px`),D.classList.toggle("pinned",d[Q]),D.setAttribute("aria-valuemin",mn(u.lo,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuemax",mn(u.hi,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuenow",mn(Z,"angle").replace("\u2212","-")),D.setAttribute("aria-valuetext",`${he(Z,"angle")}${d[Q]?", held":""}`)})}let H=D=>Math.min(Math.max(D,u.lo),u.hi);function $(D,B){h={which:D,turn:H(B)},N();let Q=cw(l.map,D==="start"?0:1,h.turn);r.hidden=!1,bt(r,`${he(h.turn,"angle",1)}: ${Q.length?Q.join("; "):"closed on every branch"}`),r.dataset.tone=Q.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",D==="end"),n(D,h.turn)}function P(){if(!h)return;let{which:D,turn:B}=h;r.hidden=!0,t(D,B)}o.forEach((D,B)=>{let Q=B?"end":"start";D.addEventListener("pointerdown",Y=>{Y.preventDefault(),D.focus(),D.setPointerCapture(Y.pointerId);let Z=L(Q)-_(Y.clientY-a.getBoundingClientRect().top),et=ft=>$(Q,_(ft.clientY-a.getBoundingClientRect().top)+Z);D.addEventListener("pointermove",et);let dt=()=>{D.removeEventListener("pointermove",et),P()};D.addEventListener("pointerup",dt,{once:!0}),D.addEventListener("pointercancel",dt,{once:!0})}),D.addEventListener("keydown",Y=>{let Z={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[Y.key];if(Z)$(Q,L(Q)+Z*ta*(Y.shiftKey?.1:1));else if(Y.key==="Enter")P();else if(Y.key==="Escape"&&h)z(),n(Q,null);else return;Y.preventDefault(),Y.stopPropagation()}),D.addEventListener("blur",()=>h?.which===Q&&P())}),i.addEventListener("pointerdown",D=>{if(!l?.q.length)return;let B=Y=>e(Math.min(Math.max((Y.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(D.pointerId),B(D),i.addEventListener("pointermove",B);let Q=()=>i.removeEventListener("pointermove",B);i.addEventListener("pointerup",Q,{once:!0}),i.addEventListener("pointercancel",Q,{once:!0})});function z(){h=null,r.hidden=!0,l&&N()}return new ResizeObserver(Zs(A)).observe(a),{el:a,paint(){l&&v(),A()},cancel:z,show(D,B=null,Q={start:!1,end:!1}){l=D,d=Q,h=null,r.hidden=!0,a.hidden=!D,D&&(c=B,v(),A())},only(D){c=D,A()},at(D){s.hidden=D===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${m(D)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(D,B=null){let Q=a.getBoundingClientRect();return[Q.x+m(D==="end"?1:0),Q.y+g(B??L(D))]}}}var fw=Math.PI/180;function pw(){let n=(p,x,m)=>Al({...p,start:null,end:null},x,m),t=(p,x,m)=>{let g=M("span",{class:"field-name"}),_=M("label",{class:"field"},g,m);return _.label=()=>{g.textContent=x==="plain"?p:`${p}, ${gt.symbol(x)}`},_},e=(p,x,m,g,_)=>{let T=Mn({label:p,kind:x,testid:m,check:g,input:_});return{f:T,el:t(p,x,T)}},i=Ve("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*fw,45*fw]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,x=>Math.abs(x)<=4*Math.PI?null:"at most two turns",x=>{let m=Mo().turn?.slice()??[0,0];m[p]=x,n({turn:m},"bound the turn of the route",`route-turn-${p}`)})),r=Ve("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=un("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=M("details",{class:"fold"},M("summary",{text:"More that is free, and what must be kept"}),M("div",{class:"line"},o.el),M("div",{class:"line"},M("label",{class:"field"},M("span",{class:"field-name",text:"Cheapest"}),a)),M("div",{class:"line"},l.el),M("div",{class:"line"},c.el)),h=M("div",{},M("div",{class:"line"},M("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),M("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let p=Mo();i.mark(p.turn?"within":"free"),s.forEach((x,m)=>{x.el.hidden=!p.turn,x.f.put(p.turn?.[m]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,l.f.put(p.singularity),c.f.put(p.clearance),c.el.hidden=!b.world.some(x=>x.role!=="object"&&x.kind!=="frame"),d.forEach(x=>x.el.label())}return nt(["units","world"],f),nt("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var mw=n=>({id:"route",title:"Route",wide:!0,build(t){let e=b.path,i=null,s=null,r=null,o=ep("route",()=>_()),a=pw(),l=(P,z,D,B={})=>Ut(P,{"data-testid":z,...B},D),c=l("Let both ends free","free-ends",()=>{Al({start:null,end:null},"let the ends of the route free"),f.ask()}),u=l("Send to the program","route-to-program",N,{hidden:!0}),h=l("","route-others",L,{hidden:!0}),d=vo("route-verdict"),f=bo({text:"Find the route",working:"Looking \u2026",testid:"find-route",verdict:d,root:t,async ask(){try{let P=await Fe("route",rp());P.stopped||T(P)}catch(P){throw m.cancel(),P}}}),p=M("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),x=M("div",{class:"branches","data-testid":"route-list"}),m=dw({drag:(P,z)=>z===null?ps(null):w(P,z),drop:(P,z)=>U(P,z),scrub:P=>r&&b.motion===r&&zr(A(P))}),g=M("details",{class:"fold",open:!0},M("summary",{text:"The line"}),o.el);m.el.hidden=!0,c.hidden=!0,t.append(M("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),g,a.el,M("div",{class:"line"},f,c,u),m.el,p,d,M("div",{class:"line"},h),x);let _=()=>{e.from&&e.to&&!i&&Wo(Array.from({length:33},(P,z)=>te(Kd(e.from,e.to,z/32))))};function T(P){let z=Mo();if(i=b.route={...P,turn:v(P,z),asked:[e.from,e.to]},s=P.found?P.branches[P.labels[0]]:null,P.found&&(g.open=!1),d.say(P.text,P.found?"good":P.verdict==="IMPOSSIBLE"?"wrong":"note"),m.show(i,s,{start:!!z.start,end:!!z.end}),ps(null),c.hidden=!(z.start||z.end),u.hidden=!P.found,h.hidden=!1,bt(h,P.found?"Routes that begin with other postures":"What would let it through?"),Wt(x),S(),Wo(P.points),!P.found){r=null,Li(null);return}let D=P.q.length;r=cr({table:b.table,q:P.q,xs:P.q.map((B,Q)=>Q+1),xName:"point",xEnd:D,seconds:P.s.map(B=>e.seconds*B),title:`${b.table.name}: route, ${D} points`}),Li(r)}function v(P,z){if(!P.found||!P.map||!Rl(P.map))return P.turn;let D=z.start?z.start.turn-P.turn[0]:z.end?z.end.turn-P.turn.at(-1):0;return P.turn.map(B=>B+2*Math.PI*Math.round(D/(2*Math.PI)))}let A=P=>i.s.reduce((z,D,B)=>Math.abs(D-P)<Math.abs(i.s[z]-P)?B:z,0);function S(){Wt(p,i.branches.map((P,z)=>{let D=M("span",{class:"swatch"});return D.style.setProperty("background",Ft.curves[z%Ft.curves.length]),M("button",{type:"button",class:"chip","aria-pressed":String(s===P),title:s===P?"Show all branches":"Show this branch alone","data-testid":`route-branch-${z+1}`,on:{click:()=>{s=s===P?null:P,m.only(s),S()}}},D,P)}))}let y=(P,z)=>{let D=P==="start",B=D?0:i.q.length-1;return{T:D?e.from:e.to,turn:z,free:V0(),near:i.q[B],branch:i.branches[i.labels[B]]}},w=js(async(P,z)=>{let D=await Fe("route_posture",y(P,z)).catch(()=>null);ps(D?.q??null)});async function U(P,z){try{let D=await Fe("route_posture",y(P,z));if(!D.q)throw new Error(`The route cannot ${P} there. ${D.why}`);Al({[P]:{turn:z,q:D.q,branch:D.label}},`turn the ${P} of the route to ${he(z,"angle",1)}`),await f.ask()}catch(D){ps(null),m.cancel(),Me(D.message,"wrong")}}async function L(){h.disabled=!0,bt(h,"Looking \u2026");try{let P=await Fe("route_others",rp());if(P.stopped)return;let z=D=>`cost ${Number(D.toPrecision(3))}`;Wt(x,P.relaxations.map(D=>M("p",{class:"verdict","data-tone":"note",text:D})),P.alternatives.map((D,B)=>M("button",{type:"button",class:"branch","data-testid":`route-other-${B+1}`,on:{click:async()=>{Al({start:{turn:D.turn,q:D.q,branch:D.branch},end:null},`begin the route ${D.branch}`),await f.ask()}}},M("span",{class:"branch-name",text:D.branch}),M("span",{class:"hint",text:`begins turned ${he(D.turn,"angle",1)}`}),M("span",{class:"branch-end",text:z(D.cost)}))),P.relaxations.length+P.alternatives.length?null:M("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),h.hidden=!0}catch(P){d.say(P.message)}finally{h.disabled=!1,i&&bt(h,i.found?"Routes that begin with other postures":"What would let it through?")}}async function N(){u.disabled=!0;try{let P=await Fe("route_program",rp());if(P.stopped)return;let z=!b.program.length,D=z?P.steps.slice(1):P.steps;z&&(b.start=P.steps[0].q),Ko([...b.program,...D],"send the route to the program");let B=`${he(P.metres,"length",3)} and ${he(P.radians,"angle",3)}`;Me(`Sent as a spline through ${P.poses} poses; it strays by at most ${B}.`),n()?.("program")}catch(P){d.say(P.message)}finally{u.disabled=!1}}let H=()=>{b.routing&&(b.routing={...b.routing,start:null,end:null})};function $(){i=b.route=null,d.say(""),m.show(null),u.hidden=h.hidden=c.hidden=!0,Wt(p),Wt(x),ps(null)}nt("panel",P=>{if(P!=="route")return;let z=()=>b.frames.at(-1).slice();e.from??=z(),e.to??=z(),o.show(),_(),i&&m.paint()}),nt("played",()=>{!r||b.motion!==r?m.at(null):m.at(i.s[uS()]??null)}),nt("motion",()=>b.motion!==r&&m.at(null)),nt("theme",()=>{m.paint(),i&&S()}),nt("units",()=>m.paint()),nt("routing",P=>{P==="undo"&&i&&f.ask()}),nt(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(H(),$())}),nt("table",P=>{["postures","name","gripper"].includes(P)||(P!=="undo"&&H(),$())}),m.el.addEventListener("where",P=>Object.assign(P.detail,{at:m.place(P.detail.which,P.detail.turn)}))}});function gw(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>Qo(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let p=Mn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:x=>{n(()=>e(u,{[h]:x},h))}});return p.put(b.program[u][h]??null),M("label",{class:"field"},M("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),p)}let s=(u,h)=>{let d=b.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>zs(d,`step-${u+1}-${h}`,()=>b.program[u]?.[h],f=>{let p=b.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...p}:{[h]:f},h))}).el;function a(u,h){let d=Ve("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",x=>Qo(h,x==="centre"?{centre:te(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return M("div",{},M("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((x,m)=>{let g=Mn({label:`Step ${h+1}, centre ${x}`,kind:"length",testid:`step-${h+1}-centre-${m}`,input:_=>{let T=b.program[h].centre.slice();T[m]=_,n(()=>e(h,{centre:T},"centre"))}});return g.put(u.centre[m]),M("label",{class:"field"},M("span",{class:"field-name",text:x}),g)}),p=M("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:p.checked},"far")}});return M("div",{},M("div",{class:"line"},d),M("div",{class:"line"},...f,M("span",{class:"unit",text:gt.length})),M("label",{class:"check"},p,"the longer way round"))}function l(u,h){let d=f=>Qo(h,{through:f,T:f.at(-1)},t(h));return M("div",{class:"line"},M("span",{class:"field-name",text:`Goes through ${u.through.length} poses, the last one its target`}),Ut("Add the present pose",{class:"quiet","data-testid":`step-${h+1}-through`},()=>d([...u.through,_u(h)])),Ut("Take the last one out",{class:"quiet",disabled:u.through.length<2},()=>d(u.through.slice(0,-1))))}function c(u,h){return u.kind==="wait"?M("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?M("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?M("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?M("div",{class:"step-editor"},o(h)("T","The frame, in the base"),M("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>Qo(h,{T:b.frames.at(-1).slice()},`teach step ${h+1}`)),Ut("The base",{class:"quiet",title:"The poses that follow are meant in the base again"},()=>Qo(h,{T:ji()},`end the frame at step ${h+1}`)))):u.kind==="output"?M("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),M("label",{class:"check"},M("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):M("div",{class:"step-editor"},M("div",{class:"line"},un("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:gt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${gt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?l(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),M("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>Qo(h,{...s(h,_u(h)),q:u.kind==="joint"?b.q.slice():null},`teach step ${h+1}`)),u.q?Ut("Go there",{class:"quiet"},()=>Ci(u.q.slice(),.8,`go to step ${h+1}`)):null))}return c}function _w(){let n=M("div",{class:"line limits-of"}),t=()=>{let e=new Set(b.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=Mn({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>aw({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(ip()[r]),c===null&&(u.placeholder="none"),M("label",{class:"field"},M("span",{class:"field-name",text:`${o}, ${gt.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Wt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return nt(["table","units"],t),nt("program",e=>e==="undo"&&t()),t(),n}var op={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function $0(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>mn(t,Ze(b.table.joints[e]??{type:"R"}),1)).join(", "):`${te(n.T).map(t=>mn(t,"length",1)).join(", ")} ${gt.length}${n.kind==="spline"?`, ${n.through.length} poses`:""}`}var xw=200,QL=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Cl=()=>_u(ap()),ap=()=>b.program.length,yw={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=M("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=vo("program-verdict"),o=M("details",{class:"fold",hidden:!0},M("summary",{text:"What binds, and when"}),M("p",{class:"hint prose"})),a=(S,y,w,U)=>Ut(y,{title:w,"data-testid":`step-add-${S}`},()=>f(U())),l=bo({text:"Run the program",working:"Planning \u2026",testid:"run-program",verdict:r,root:n,open:()=>b.program.length>0,ask:v}),c=M("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(M("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:b.q.slice(),T:Cl(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Cl(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Cl(),blend:0})),a("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Cl()],T:Cl(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),a("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:b.frames.at(-1).slice()})),a("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max(ap(),1),times:1}))),M("div",{class:"line spread"},c,M("span",{class:"line"},Ut("Start here",{class:"quiet","data-testid":"start-here",title:"The program begins in the present posture"},()=>lw(b.q.slice())),Ut("Go to the start",{class:"quiet"},()=>Ci(sp().slice(),.8,"go to the start")))),s,_w(),M("div",{class:"line"},l,M("span",{class:"line"},un("Language of the file",QL,u,S=>{u=S},{"data-testid":"dialect"}),Ut("Save the program",{"data-testid":"save-program"},A))),r,o),ap=()=>t>=0?t+1:b.program.length;let h=()=>b.program.slice(0,ap()).findLast(S=>S.T&&S.kind!=="frame")?.T??Cl(),d=()=>b.program.findLast(S=>S.kind==="gripper")?.value??0;function f(S){if(b.program.length>=xw){Me(`At most ${xw} steps.`,"wrong");return}let y=t>=0?t+1:b.program.length;t=y;let w=np(b.program,b.program.map((U,L)=>L<y?L:L+1));if(S.kind==="call"&&!y){Me("There is no step before it that could be done again.","wrong"),t=-1;return}Ko([...w.slice(0,y),S,...w.slice(y)],`add a step: ${op[S.kind].toLowerCase()}`)}function p(S,y){if(y<0||y>=b.program.length||S===y)return;let w=b.program.map((L,N)=>N);w.splice(y,0,...w.splice(S,1));let U=np(b.program,b.program.map((L,N)=>w.indexOf(N)));t=y,Ko(U,`move step ${S+1} to ${y+1}`),s.children[y]?.querySelector(".step-name")?.focus()}function x(S){t=-1,Ko(np(b.program,b.program.map((y,w)=>w===S?-1:w<S?w:w-1)),`remove step ${S+1}`)}function m(S,y){let w=y===t,U=M("button",{type:"button",class:"step-name quiet","aria-expanded":String(w),"data-testid":`step-${y+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=w?-1:y,T()},keydown:N=>{let H={ArrowUp:-1,ArrowDown:1}[N.key];H&&N.altKey?(N.preventDefault(),p(y,y+H)):H?(N.preventDefault(),s.children[y+H]?.querySelector(".step-name")?.focus()):N.key==="Delete"&&x(y)}}},M("b",{text:op[S.kind]}),` ${$0(S)}`,S.blend?M("span",{class:"hint",text:`, blend ${he(S.blend,"length",0)}`}):null),L=M("li",{class:`step${e?.step===y?" failed":""}${w?" open":""}`,draggable:"true","data-testid":`step-row-${y+1}`},M("div",{class:"step-line"},M("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),M("span",{class:"hint",text:String(y+1)}),U,yo({k:y,n:b.program.length,name:`step ${y+1}`,move:p,remove:x})),e?.step===y?M("p",{class:"reason",text:e.text}):null,w?_(S,y):null);return L.addEventListener("dragstart",N=>{i=y,N.dataTransfer.effectAllowed="move",N.dataTransfer.setData("text/plain",String(y))}),L.addEventListener("dragover",N=>{i<0||(N.preventDefault(),L.classList.add("target"))}),L.addEventListener("dragleave",()=>L.classList.remove("target")),L.addEventListener("drop",N=>{N.preventDefault();let H=i;i=-1,H>=0&&p(H,y)}),L}let g=!1,_=gw(S=>{g=!0,S(),g=!1});function T(){if(g){b.program.forEach((y,w)=>{let U=s.children[w]?.querySelector(".step-name");U&&Wt(U,M("b",{text:op[y.kind]}),document.createTextNode(` ${$0(y)}`))});return}t>=b.program.length&&(t=-1),Wt(s,b.program.map(m)),b.program.length||s.append(M("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.show();let S=sp();bt(c,b.program.length?`Starts at ${S.map((y,w)=>mn(y,Ze(b.table.joints[w]),1)).join(", ")}`:"")}async function v(){let S=await Fe("program",{...Tl(),world:b.world});e=S.failed,e&&(t=e.step),r.say(e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[S.explain,S.clear?.text].filter(Boolean).join(`
`),e||S.clear?.verdict==="HIT"?"wrong":S.clear?.verdict==="UNCERTAIN"?"note":"good"),o.hidden=!S.tight.length,bt(o.lastChild,S.tight.map(w=>w.text).join(`
`)),T();let y=S.events.map(([w,U,L])=>({x:w,s:0,text:`${U} ${L} at ${w.toFixed(2)} s`,short:U==="gripper"?L>.5?"close":"open":U,stop:!1}));Li(cr({table:b.table,q:S.q,xs:S.t,xName:"time",seconds:S.t,dq:S.dq,ddq:S.ddq,events:y,title:`${b.table.name}: program, ${S.duration.toFixed(2)} s`,happens:S.events,tight:S.tight,limits:Tl().limits}))}async function A(){try{let S="program",{text:y,name:w}=await Fe("program_file",{...Tl(),dialect:u,name:S});ui(w,y)}catch(S){r.say(S.message)}}nt(["program","units","table"],S=>{S!=="limits"&&(e=null,T())}),T()}};var ea=new Rn,X0=new il,tD=new _e,eD=n=>new si({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function q0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new ze(e,3)),n}var vw=n=>n.rotateX(Math.PI/2),lp={box:n=>[q0(new ki(...n.size)),n.T],cylinder:n=>[q0(vw(new Ri(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new G(...n.a),e=new G(...n.b).sub(t),i=e.length(),s=new _e().makeRotationFromQuaternion(new dn().setFromUnitVectors(new G(0,0,1),i?e.clone().normalize():new G(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[q0(vw(new Uo(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function Y0(n,t,e=.86){if(!lp[n.kind])return null;let[i,s]=lp[n.kind](n),r=eD(t);r.opacity=e,r.depthWrite=e>.5;let o=new je(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var Mw=()=>[...b.world,...b.things??[]],Sw=n=>{let t=Pl.get(n.name)??n.T;return t?te(t):n.a.map((e,i)=>(e+n.b[i])/2)},nD=n=>Sw(n).map((t,e)=>t+(e===2?1:0));function iD(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=te(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Ys(n.T,s)[o])))}function ww(){pn.add(ea,X0.group),nt(["world","table"],bw),nt("theme",bw)}var Pl=new Map;function j0(n,t){if(t)Pl.set(n,t);else if(!Pl.delete(n))return;let e=ea.children.find(s=>s.userData.name===n),i=b.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),n()}var Ew=n=>Pl.get(n)??null;function Tw(){for(let n of[...Pl.keys()])j0(n,null)}function sD(){let n=Mw();X0.show(n.filter(t=>t.kind==="frame"),.11*ci(b.table),n.filter(t=>lp[t.kind]).map(t=>({text:t.name,at:Sw(t),wish:nD(t)})))}function bw(){for(let t of ea.children)t.geometry.dispose();ea.clear();let n=Mw();for(let t of n)if(t.kind==="curve"){let e=new Ae().setFromPoints(t.points.map(i=>new G(...i)));ea.add(new er(e,new ts({color:Ft.trace,fog:!1})))}else if(lp[t.kind]){let{mesh:e,T:i}=Y0(t,t.role==="object"?Ft.accent:Ft.ghost);e.matrix.copy(tD.set(...Pl.get(t.name)??i)),e.userData.name=t.name,ea.add(e)}sD(),Or("world",n.flatMap(iD)),xe()}var Aw=()=>ea.children.length+(X0.last?.[0].length??0);var Ll=new er(new Ae,new ts({depthTest:!1,fog:!1})),Dl=new Rr(new Ae,new nr({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Ll.renderOrder=Dl.renderOrder=6;Ll.frustumCulled=Dl.frustumCulled=!1;Ll.visible=Dl.visible=!1;var Il=new Rn,xu=null,Rw="",oD=()=>b.watch||b.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),aD=js(async()=>{try{let n=await Fe("clearance",{q:b.q,world:b.world});b.clearance=n}catch(n){b.clearance={refused:n.message}}Z0(),ut("clearance")});function Cw(){oD()&&b.table.joints.length?aD():b.clearance&&(b.clearance=null,Z0(),ut("clearance"))}function Z0(){let n=b.clearance,t=!!n?.points?.length;if(Ll.visible=Dl.visible=t,t){let e=n.points.map(i=>new G(...i));for(let i of[Ll,Dl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Ft.trace:Ft.wrong)}xe()}async function J0(n){if(xu=null,n){let{bodies:t,explain:e}=await Fe("bodies",{});xu=t,Rw=e}for(let t of Il.children)t.geometry.dispose();Il.clear();for(let t of xu??[]){let e=Y0(t,Ft.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},Il.add(e.mesh))}return Iw(),Rw}var Pw=()=>Il.children.length,lD=new _e;function Iw(){for(let n of Il.children){let{on:t,T:e}=n.userData;b.frames[t]&&n.matrix.copy(lD.set(...Hn(b.frames[t],e)))}xe()}function Lw(){pn.add(Ll,Dl,Il),nt(["q","world","watch"],Cw),nt("plan",Cw),nt("q",()=>xu&&Iw()),nt("table",()=>xu&&J0(!1).then(()=>ut("bodies-gone"))),nt("theme",Z0)}var uD=60,hD={box:"Box",cylinder:"Cylinder",frame:"Frame"},dD={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function K0(n,t,e={}){ut("did",{label:t,...e}),b.world=n,ut("world")}var cp=(n,t,e)=>K0(b.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function fD(n,t){if(b.world.length>=uD)return;let e=te(b.frames.at(-1)),i=.06*ci(b.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*b.world.length;let o=t==="object"?"object":n,a=1;for(;b.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};K0([...b.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var Dw={id:"world",title:"World",wide:!0,build(n){let t=M("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=M("p",{class:"hint prose"}),i=M("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{b.watch=i.checked,ut("watch")}}}),s=M("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await J0(s.checked);bt(e,s.checked?h:"")}catch(h){bt(e,h.message)}}}}),r=M("div",{class:"things","data-testid":"world"}),o=(h,d,f,p)=>Ut(h,{title:p,"data-testid":`add-${f}-${d}`},()=>fD(d,f));n.append(M("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),M("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),M("div",{class:"line"},M("label",{class:"check"},i,"Distance, always"),M("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),nt(["clearance","units"],()=>{let h=b.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];bt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${he(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${he(-h.metres,"length")}.`))}),nt("bodies-gone",()=>{s.checked=!1,bt(e,"")});let l=!1,c=()=>{l||(Wt(r,b.world.map(u)),b.world.length||r.append(M("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=g=>(..._)=>{l=!0,g(..._),l=!1},p=M("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>p.value&&cp(d,{name:p.value},`name ${p.value}`)}}),x=dD[h.kind].map((g,_)=>{let T=Mn({label:`${h.name}, ${g}`,kind:"length",testid:`world-${d+1}-size-${_}`,check:v=>v>0?null:"more than 0",input:f(v=>{let A=b.world[d],S=h.kind==="box"?{size:A.size.map((y,w)=>w===_?v:y)}:{[_?"h":"r"]:v};cp(d,S,`size of ${h.name}`)})});return T.put(h.kind==="box"?h.size[_]:_?h.h:h.r),M("label",{class:"field"},M("span",{class:"field-name",text:`${g}, ${gt.length}`}),T)}),m=zs("Place of its middle",`world-${d+1}`,()=>b.world[d]?.T,f(g=>cp(d,{T:g},`move ${h.name}`)));return M("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},M("div",{class:"line spread"},M("span",{class:"line"},p,M("span",{class:"hint",text:hD[h.kind]}),h.kind==="frame"?null:un(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,g=>cp(d,{role:g},`make ${h.name} an ${g}`))),yo({k:d,name:h.name,remove:()=>K0(b.world.filter((g,_)=>_!==d),`remove ${h.name}`)})),x.length?M("div",{class:"line"},x):null,m.el)}nt(["world","units"],h=>h!=="python"&&c()),c()}};var pD=40,Nw={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return b.sequence.postures},set postures(d){b.sequence.postures=d},get rate(){return b.sequence.rate}},e=M("thead"),i=M("tbody"),s=vo("sequence-verdict"),r=bo({text:"Run the sequence",working:"Planning \u2026",testid:"run-sequence",verdict:s,root:n,open:()=>t.postures.length>1,ask:h}),o=Ut("Same times for all legs",{class:"quiet",title:"Copy the first leg\u2019s time and rest to the others"},()=>{let d=t.postures[1];if(d){ut("did",{label:"use the same times for all legs"});for(let f of t.postures.slice(2))f.seconds=d.seconds,f.hold=d.hold;u()}});n.append(M("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),M("div",{class:"scroll"},M("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),M("div",{class:"line"},Ut("+ Present posture",{class:"add","data-testid":"add-posture"},()=>a(b.q.slice())),Ut("+ All named postures",{},()=>Object.entries(b.table.postures??{}).forEach(([d,f])=>a(f.slice(),d))),o),M("div",{class:"line"},r),s);function a(d,f){t.postures.length>=pD||(ut("did",{label:"add a posture to the sequence"}),t.postures.push({name:f??`P${t.postures.length}`,q:d,seconds:5,hold:0}),u(),ut("sequence"))}function l(d,f){ut("did",{label:`move ${t.postures[d].name} ${f<d?"up":"down"}`}),t.postures.splice(f,0,...t.postures.splice(d,1)),u(),ut("sequence")}function c(d){ut("did",{label:`remove ${t.postures[d].name}`}),t.postures.splice(d,1),u(),ut("sequence")}function u(){let d=b.table.joints;t.postures=t.postures.filter(f=>f.q.length===d.length),r.show(),Wt(e,M("tr",{},M("td"),d.map((f,p)=>M("th",{},M("i",{text:"q"}),M("sub",{text:String(p+1)}),M("span",{class:"unit",text:` ${gt.symbol(Ze(f))}`}))),M("th",{text:"leg, s"}),M("th",{text:"rest, s"}),M("td"))),Wt(i,t.postures.map((f,p)=>{let x=d.map((g,_)=>{let T=Mn({label:`${f.name}, q${_+1}`,kind:Ze(g),testid:`seq-${p}-q${_+1}`,input:v=>{ut("did",{label:`edit ${f.name} of the sequence`,key:`seq-${p}-${_}`}),f.q[_]=v,ut("sequence")}});return T.put(f.q[_],String(Number((f.q[_]*gt.factor(Ze(g))).toFixed(gt.digits(Ze(g))))+0)),M("td",{},T)}),m=(g,_,T)=>{if(p===0)return M("td");let v=Mn({label:`${_} ${f.name}`,testid:`seq-${p}-${g}`,check:T,input:A=>{ut("did",{label:`edit ${f.name} of the sequence`,key:`seq-${p}-${g}`}),f[g]=A,ut("sequence")}});return v.put(f[g]),M("td",{},v)};return M("tr",{"data-testid":`seq-row-${p}`},M("th",{scope:"row"},Ut(f.name,{class:"quiet",title:"Go there"},()=>Ci(f.q.slice()))),x,m("seconds","Seconds to",g=>g>0?null:"more than 0"),m("hold","Rest after",g=>g>=0?null:"0 or more"),M("td",{class:"tools"},yo({k:p,n:t.postures.length,name:f.name,move:l,remove:c})))})),t.postures.length||i.append(M("tr",{},M("td",{class:"hint",colspan:String(d.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function h(){let d=t.postures,f=await Fe("motion",{postures:d.map(x=>x.q),seconds:d.slice(1).map(x=>x.seconds),holds:d.slice(1).map(x=>x.hold),rate:t.rate}),p=d.map((x,m)=>({x:f.arrivals[m],s:0,text:`${x.name} at ${f.arrivals[m].toFixed(2)} s`,short:x.name,stop:!1}));s.say(`${d.length} postures in ${f.t[f.t.length-1].toFixed(2)} s. ${mD(f.q)}`,"good"),Li(cr({table:b.table,q:f.q,xs:f.t,xName:"time",seconds:f.t,dq:f.dq,events:p,title:`${b.table.name}: ${d.map(x=>x.name).join(" \u2013 ")}`}))}nt(["table","units","sequence-loaded"],u),u()}};function mD(n){let t=b.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var gD=.14,So=new je(new Cs(1,32,20),new si({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));So.matrixAutoUpdate=!1;So.visible=!1;So.renderOrder=4;var yu="none";function _D(n,t,e){let i=R_(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function Uw(n){yu=n,Ow()}var up=()=>b.ellipsoid??null;function Ow(){let n=yu!=="none"&&b.table.joints.length>0;if(So.visible=n,b.ellipsoid=null,n){let t=_D(b.table,b.q,b.frames),e=gD*ci(b.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(yu==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=te(b.frames.at(-1)),[a,l]=r,c={...r[2]};So.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),So.material.color.set(yu==="velocity"?Ft.trace:Ft.accent),So.material.side=pi,b.ellipsoid=t}xe(),ut("ellipsoid")}function Fw(){pn.add(So),nt(["q","theme"],()=>yu!=="none"&&Ow())}var hp=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),Q0=new nr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Vi=new Rr(new Ae,Q0);Vi.frustumCulled=!1;Vi.visible=!1;pn.add(Vi);var Nl=null,vu=null,Wi=0,wo={lo:0,hi:1};function Bw(n){Nl=new Float32Array(3*n),vu=new Float32Array(n),Wi=0,Vi.geometry.dispose(),Vi.geometry=new Ae,Vi.geometry.setAttribute("position",new ze(Nl,3)),Vi.geometry.setAttribute("color",new ze(new Float32Array(3*n),3)),Vi.geometry.setDrawRange(0,0),Vi.visible=!0,xe()}function kw(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Wi<vu.length;i+=4,Wi++)Nl.set(e.subarray(i,i+3),3*Wi),vu[Wi]=e[i+3];yD()}function yD(){let n=vu.slice(0,Wi).sort();wo.lo=n[Math.floor(Wi*.02)]??0,wo.hi=n[Math.max(Math.ceil(Wi*.98)-1,0)]??1;let t=new ee,e=Vi.geometry.attributes.color.array,i=wo.hi-wo.lo||1;for(let s=0;s<Wi;s++){let r=Math.min(Math.max((vu[s]-wo.lo)/i,0),1)*(hp.length-1),o=Math.min(Math.floor(r),hp.length-2);t.lerpColors(hp[o],hp[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Vi.geometry.setDrawRange(0,Wi),Vi.geometry.attributes.position.needsUpdate=!0,Vi.geometry.attributes.color.needsUpdate=!0,xe()}var bu=()=>Wi;function zw(n){ss.localClippingEnabled=n!==null,Q0.clippingPlanes=n===null?null:[new ii(new G(0,1,0),-n)],Q0.needsUpdate=!0,xe()}function Hw(){let n=new Bi;for(let i=0;i<Wi;i++)n.expandByPoint(new G(Nl[3*i],Nl[3*i+1],Nl[3*i+2]));let{min:t,max:e}=n;return Wi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Gw(){Wi=0,Vi.visible=!1,xe()}var Ww=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],dp=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ei(n,4):n.toExponential(2).replace("-","\u2212"),$w={id:"analysis",title:"Analysis",build(n){let t=M("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(M("div",{title:h},M("dt",{text:u}),i[c]=M("dd",{"data-testid":`fact-${c}`})));let s=M("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=M("p",{class:"hint","data-testid":"ellipsoid-axes"});nt("ellipsoid",()=>{let c=up();bt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>he(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,M("h3",{text:"At the tool\u2019s point"}),Ve("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",Uw,"ellipsoid"),o,M("h3",{text:"Distance to the limits"}),s,M("h3",{text:"Reachable points"}),vD());let a=()=>{r=b.table.joints.map((c,u)=>{let h=M("span",{class:"bar-fill"}),d=M("span",{class:"bar-text"});return{el:M("div",{class:"distance"},M("span",{},M("i",{text:"q"}),M("sub",{text:String(u+1)})),M("span",{class:"bar"},h),d),fill:h,text:d}}),Wt(s,r.map(c=>c.el)),l()},l=Zs(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let c=Iu(b.table,b.q,b.frames),u=c[0],h=c[c.length-1];bt(i.manipulability,dp(c.reduce((d,f)=>d*f,1))),bt(i.condition,u>1e-9?ei(h/u,1):"\u221E"),bt(i.least,dp(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},x)=>{let m=b.table.joints[x],g=b.q[x];if(m.lower===null||m.upper===null){f.style.setProperty("width","100%"),bt(p,"no limit");return}let _=Math.min(g-m.lower,m.upper-g),T=Math.max(2*_/(m.upper-m.lower||1),0);f.style.setProperty("width",`${100*T}%`),d.classList.toggle("outside",_<-1e-9),bt(p,_<-1e-9?`${he(-_,Ze(m))} beyond`:he(_,Ze(m)))})});nt("table",a),nt(["q","units","panel"],l),a()}};function vD(){let n="20000",t="manipulability",e=!1,i=Ut("Draw the cloud",{class:"primary","data-testid":"cloud-start"},()=>e?Zi("cancel",{kind:"cloud"}):d()),s=Ut("Clear",{},h),r=Ve("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>zw(f==="half"?b.table.base[7]:null),"cloud-cut"),o=M("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=M("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=M("span"),c=M("span"),u=M("div",{class:"legend-scale",hidden:!0},l,M("span",{class:"scale-bar"}),c);function h(){Gw(),Or("cloud",[]),u.hidden=!0,bt(a,"")}async function d(){e=!0,bt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,Bw(Number(n));try{let f=await Fe("cloud",{count:Number(n),colour:t,seed:1},p=>{kw(p.points),o.value=p.done/p.of,bt(l,dp(wo.lo)),bt(c,dp(wo.hi)),bt(a,`${p.done.toLocaleString("en")} of ${p.of.toLocaleString("en")} points`)});bt(a,f.stopped?`Cancelled after ${bu().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${Ww.find(([p])=>p===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){bt(a,f.message)}e=!1,Or("cloud",Hw()),Kc(),bt(i,"Draw the cloud"),o.hidden=!0}return nt("table",f=>{f!=="postures"&&f!=="name"&&bu()&&h()}),M("div",{},M("div",{class:"line"},un("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),M("span",{class:"field-name",text:"coloured by"}),un("Coloured by",Ww,t,f=>{t=f},{"data-testid":"cloud-colour"})),M("div",{class:"line"},i,s,r),o,u,a)}var qw=n=>({id:"share",title:"Share",build(t,e){let i=M("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=M("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=M("p",{class:"hint",role:"status","data-testid":"report-note"}),o=Ut("Write the report",{class:"primary","data-testid":"report"},u),a=M("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(M("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),M("div",{class:"line share-link"},i,Ut("Copy the link",{"data-testid":"copy-link"},async()=>Xr(await yf()))),M("h3",{text:"As a file"}),M("div",{class:"line"},Ut("Save the state",{"data-testid":"save-state"},()=>ui(`${b.table.name||"arm"}.workbench.json`,JSON.stringify(_f(),null,1),"application/json")),Ut("Open a state\u2026",{},()=>s.click()),s,Ut("Save the robot file",{"data-testid":"save-robot"},Kf)),M("h3",{text:"As Python"}),M("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,M("div",{class:"line"},Ut("Copy the script",{"data-testid":"copy-python"},()=>Xr(a.value)),Ut("Save the script",{},()=>ui("workbench.py",a.value,"text/x-python"))),M("h3",{text:"Report"}),M("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),M("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&b.table.joints.length&&(i.value=await yf()),!e.hidden&&b.table.joints.length&&c()},c=js(async()=>{try{let{q:d,target:f,hasTarget:p,path:x,program:m}=b,{task:g,redundancy:_}=de,T={q:d,target:p?f:null,path:x,task:g,redundancy:_,program:Tl()};a.value=(await Fe("python",m.length?T:{...T,program:null})).text}catch(d){a.value=`# ${d.message}`}});nt(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await Fe("report",{q:b.q},p=>bt(r,p.note));ui(f,d,"text/html"),bt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){bt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");xf(JSON.parse(await f.text()),n()),Me("Opened")}catch(p){Me(p instanceof SyntaxError?`${f.name} is not a state file.`:p.message,"wrong")}}}});var bD=40,Yw=!1,jw=0,t_=!1,fp=null,Xw=null;function Zw(n){n&&(Yw=!0,fp=b.table,Jw(n))}function Jw(n){t_=!0,jw=n.said,n.table&&(yn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),fp=b.table,Sl(n.looks??null,n.table)),n.things&&MD(n.things),n.target&&(b.hasTarget=!0,Si(n.target,"restored")),n.q&&n.q.length===b.table.joints.length&&(ut("did",{label:"move from Python",key:"python"}),Ui(n.q,"python")),t_=!1}function MD(n){b.things=n.filter(i=>i.kind!=="motion"),ut("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==Xw){if(Xw=e,!t){Li(null);return}Li(cr({table:b.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${b.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var SD=ga(bD,()=>{let n=b.table===fp?void 0:Cp(b.table);fp=b.table,b.table.joints.length&&Zi("shown",{q:b.q,target:b.hasTarget?b.target:null,table:n,said:jw}).catch(()=>{})});function Kw(){nt("push",Jw),nt(["q","target","table"],()=>Yw&&!t_&&SD.soon())}var na=new Rn,t1=new si({fog:!1}),e_=new si({fog:!1}),n_=new ki(1,1,1),i_=new je(n_,t1),e1=[new je(n_,e_),new je(n_,e_)];na.add(i_,...e1);na.matrixAutoUpdate=!1;na.visible=!1;var Mu=null;function n1(){pn.add(na),nt("q",()=>Mu!==null&&s1()),nt("theme",Qw),Qw()}function Qw(){t1.color.set(Ft.joint),e_.color.set(Ft.accent)}function s_(n){n===null&&Mu===null||(Mu=n,na.visible=n!==null,n!==null&&s1(),xe())}var i1=()=>Mu;function s1(){let n=b.frames.at(-1),t=.075*ci(b.table);i_.scale.set(.35*t,1.1*t,.25*t),i_.position.set(0,0,-.85*t),e1.forEach((e,i)=>{let s=(.08+.36*(1-Mu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),na.matrix.set(...n),na.updateMatrixWorld(!0)}var TD=.25,r_=.5;function AD(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(b.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=PD(n,r);if(o>=r_&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:Ni(Di(te(u.at(-1).T),te(a)))})).filter(({name:c,d:u})=>u<RD(b.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:Hn(pa(a),l.T)}))}else o<r_&&s&&i&&(e.get(i).push({t:r,T:Hn(a,e.get(i).at(-1).held)}),i=null);s=o>=r_}return{grips:t,objects:e}}var RD=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function CD(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var PD=(n,t)=>Ss(n.table,n.q[CD(n.seconds,t)]).at(-1),Eo=null,ID=n=>{let t=Eo.grips.length?1-Math.round(Eo.grips[0].value):0;for(let e of Eo.grips){if(e.t>n)break;let i=Math.min((n-e.t)/TD,1);t+=i*(e.value-t)}return t};function r1(){nt("motion",()=>{Tw(),Eo=b.motion?.happens?AD(b.motion):null,Eo||s_(null)}),nt("played",n=>{if(!Eo)return;let t=b.frames.at(-1);Eo.grips.length&&s_(ID(n));for(let[e,i]of Eo.objects){let s=i.findLast(r=>r.t<=n)??i[0];j0(e,s.held?Hn(t,s.held):s.T)}})}function o1(){let n={q:()=>b.q.slice(),frames:()=>structuredClone(b.frames),target:()=>b.target.slice(),table:()=>structuredClone(b.table),solutions:()=>structuredClone(b.solutions),camera:()=>tl(),pictures:()=>Qy(),ghosts:()=>sb(),ghostsOutside:()=>rb(),labels:()=>gg(),history:()=>[pf(),mf()],beyond:()=>eb(),things:()=>Aw(),looks:()=>CS(),program:()=>structuredClone(b.program),route:()=>structuredClone(b.route),motion:()=>structuredClone(b.motion),gripper:()=>i1(),stepFrame:()=>b.dhStep===null?null:Zd().at(-1).T,clearance:()=>structuredClone(b.clearance),bodies:()=>Pw(),ellipsoid:()=>structuredClone(up()),world:()=>structuredClone(b.world),framesDrawn:()=>nb(),answers:()=>Fg.answers,trace:()=>cb(),cloud:()=>bu()},t={routePlace(e,i){let s={which:e,turn:i};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:s})),s.at},placeOf:e=>Ew(e)??b.world.find(i=>i.name===e)?.T??null,go:zr,toScreen:Hi,withPicture:e=>Ja(e),handles:()=>Iv(),forward:(e,i)=>Ss(e,i),convert:(e,i)=>Zf(e,i),read:(e,i)=>bf(e,i),present:(e,i,s)=>Qf(e,i,s)};for(let[e,i]of Object.entries(n))Object.defineProperty(t,e,{get:i,enumerable:!0});window.workbench=Object.freeze(t)}Ud();ev(ws("#view"));nt("theme",cg);cg();mb();gv(ws("#overlay"));Jv();Rv();ww();RS();Lw();Fw();n1();r1();Kw();F_();db();DS(ws("#bar"));US(ws("#overlay"));cS(ws("#dock"));OS();var pp,Su=(n,t,...e)=>[{...t,group:n},...e];pp=NS(ws("#rail"),ws("#panels"),ws("#pinned"),[...Su("Drive",{id:"move",title:"Move",sections:[Ab,BS]},XS),...Su("Describe",ew,Dw),...Su("Plan",rw,mw(()=>pp),yw,Nw),...Su("Study",kS,iw,$w),...Su("Hand on",qw(()=>pp))]);fS(ws("#room"),ws("#rail"));Sb();var DD=bb().then(n=>n&&xf(n,pp)).catch(n=>Me(`The link could not be read: ${n.message}`,"wrong"));nt("online",async n=>{if(!n)return;await DD;let t=await L_();b.catalog=t.catalog,ut("catalog"),t.table&&(!b.table.joints.length||t.bench)&&(yn(t.table,{q:ma(t.table),step:!1,what:"new"}),gf()),t.looks&&Sl(t.looks,t.table),Zw(t.bench),document.documentElement.dataset.ready="yes"});b.online&&ut("online",!0);document.fonts?.ready.then(()=>ut("theme"));o1();
