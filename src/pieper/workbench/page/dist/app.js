import{A as M,B as Ui,C as Lu,D as da,E as gn,F as Cx,G as bi,H as Px,I as Du,K as Zi,L as Xs,a as Yi,b as zn,c as ha,d as Qt,e as qs,f as Hl,g as Ni,h as Gl,i as Ru,j as ls,k as Cu,l as Pu,m as Sx,n as wx,o as gr,p as xr,q as Ex,r as Ss,s as Ep,t as Tx,u as li,v as Iu,w as Ax,x as Rx,y as nt,z as ht}from"./chunk-F4CXFWSV.js";function v(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ys=(n,t=document)=>t.querySelector(n),Vt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function gt(n,t){n.textContent!==t&&(n.textContent=t)}function Ve(n,t,e,i,s){let r=v("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(v("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function xn(n,t,e,i,s={}){let r=v("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>v("option",{value:o,text:a})));return r.value=e,r}function Zs(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function fa(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function js(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function ci(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=v("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function $r(n){try{await navigator.clipboard.writeText(n)}catch{let t=v("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}be("Copied")}var Ix;function be(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(Ix),Ix=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function qr(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var pa=0,Rp=-1,Tp=[];function Cp(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Ap(){let n=pa;if(!M.table.joints.length){M.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ht("plan");return}try{let{plan:t}=await Zi("arm",{table:Cp(M.table)});if(n!==pa)return;Rp=n,M.plan=t,Lx()}catch(t){if(n!==pa||t instanceof Du)return;M.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},Lx(t)}ht("plan")}function Lx(n){let t=Tp;Tp=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var Dx=js(Ap,60);function Nx(){nt("table",n=>{pa+=1,n==="postures"&&(Rp=-1),n==="cell"?Dx():(Dx.cancel(),Ap())}),nt("online",n=>{n&&(pa+=1,Ap())})}function r1(){return Rp===pa?Promise.resolve():new Promise((n,t)=>Tp.push({resolve:n,reject:t}))}async function Ue(n,t,e){return await r1(),Zi(n,t,e)}function Ux(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Nu(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var io={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},so={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},x_=0,rm=1,__=2;var Rc=1,y_=2,$a=3,ir=0,Ci=1,di=2,Do=0,qa=1,om=2,am=3,lm=4,v_=5;var No=100,b_=101,M_=102,S_=103,w_=104,E_=200,T_=201,A_=202,R_=203,cm=204,um=205,C_=206,P_=207,I_=208,L_=209,D_=210,N_=211,U_=212,F_=213,O_=214,hh=0,dh=1,fh=2,Na=3,ph=4,mh=5,gh=6,xh=7,hm=0,B_=1,k_=2,sr=0,dm=1,fm=2,pm=3,mm=4,gm=5,xm=6,_m=7;var ym=300,Uo=301,Xa=302,Vh=303,Wh=304,_h=1e3,Ks=1001,yh=1002,ti=1003,z_=1004;var Cc=1005;var wi=1006,$h=1007;var Cr=1008;var es=1009,vm=1010,bm=1011,Ya=1012,qh=1013,Cs=1014,hs=1015,Ps=1016,Xh=1017,Yh=1018,Fo=1020,Mm=35902,Sm=35899,wm=1021,Em=1022,Is=1023,Er=1026,Pr=1027,Zh=1028,jh=1029,ro=1030,Jh=1031;var Kh=1033,Pc=33776,Ic=33777,Lc=33778,Dc=33779,Qh=35840,td=35841,ed=35842,nd=35843,id=36196,sd=37492,rd=37496,od=37488,ad=37489,Nc=37490,ld=37491,cd=37808,ud=37809,hd=37810,dd=37811,fd=37812,pd=37813,md=37814,gd=37815,xd=37816,_d=37817,yd=37818,vd=37819,bd=37820,Md=37821,Sd=36492,wd=36494,Ed=36495,Td=36283,Ad=36284,Uc=36285,Rd=36286;var nc=2300,vh=2301,ch=2302,Jp=2303,Kp=2400,Qp=2401,tm=2402;var H_=3200;var Tm=0,G_=1,Ir="",ii="srgb",ic="srgb-linear",sc="linear",We="srgb";var uh=7680,Am=7681;var Rm=517;var V_=519,W_=512,$_=513,q_=514,Cm=515,X_=516,Y_=517,Pm=518,Im=519,Lm=35044,Cd=35048;var Dm="300 es",us=2e3,rc=2001;function a1(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function l1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function oc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Z_(){let n=oc("canvas");return n.style.display="block",n}var Fx={},Ua=null;function ac(...n){let t="THREE."+n.shift();Ua?Ua("log",t,...n):console.log(t,...n)}function j_(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ne(...n){n=j_(n);let t="THREE."+n.shift();if(Ua)Ua("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function re(...n){n=j_(n);let t="THREE."+n.shift();if(Ua)Ua("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Ql(...n){let t=n.join(" ");t in Fx||(Fx[t]=!0,ne(...n))}function J_(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var K_={[hh]:hh,[fh]:gh,[ph]:ph,[Na]:mh,[dh]:dh,[gh]:fh,[xh]:xh,[mh]:Na},As=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ui=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ox=1234567,tc=Math.PI/180,Fa=180/Math.PI;function oo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ui[n&255]+ui[n>>8&255]+ui[n>>16&255]+ui[n>>24&255]+"-"+ui[t&255]+ui[t>>8&255]+"-"+ui[t>>16&15|64]+ui[t>>24&255]+"-"+ui[e&63|128]+ui[e>>8&255]+"-"+ui[e>>16&255]+ui[e>>24&255]+ui[i&255]+ui[i>>8&255]+ui[i>>16&255]+ui[i>>24&255]).toLowerCase()}function Ee(n,t,e){return Math.max(t,Math.min(e,n))}function Nm(n,t){return(n%t+t)%t}function c1(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function u1(n,t,e){return n!==t?(e-n)/(t-n):0}function ec(n,t,e){return(1-e)*n+e*t}function h1(n,t,e,i){return ec(n,t,1-Math.exp(-e*i))}function d1(n,t=1){return t-Math.abs(Nm(n,t*2)-t)}function f1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function p1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function m1(n,t){return n+Math.floor(Math.random()*(t-n+1))}function g1(n,t){return n+Math.random()*(t-n)}function x1(n){return n*(.5-Math.random())}function _1(n){n!==void 0&&(Ox=n);let t=Ox+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function y1(n){return n*tc}function v1(n){return n*Fa}function b1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function M1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Um(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function S1(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*f,a*u,a*c);break;default:ne("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Fm(n,t){if(t.constructor===Float32Array)return n;let e=Pd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Om(n,t){if(t.constructor===Float32Array)return n;let e=Pd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ao={DEG2RAD:tc,RAD2DEG:Fa,generateUUID:oo,clamp:Ee,euclideanModulo:Nm,mapLinear:c1,inverseLerp:u1,lerp:ec,damp:h1,pingpong:d1,smoothstep:f1,smootherstep:p1,randInt:m1,randFloat:g1,randFloatSpread:x1,seededRandom:_1,degToRad:y1,radToDeg:v1,isPowerOfTwo:b1,ceilPowerOfTwo:M1,floorPowerOfTwo:Um,setQuaternionFromProperEuler:S1,normalize:Om,denormalize:Fm},Xt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ee(this.x,t.x,e.x),this.y=Ee(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ee(this.x,t,e),this.y=Ee(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ee(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ee(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},un=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],m=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==m){let p=l*d+c*f+u*m+h*y;p<0&&(d=-d,f=-f,m=-m,y=-y,p=-p);let g=1-a;if(p<.9995){let x=Math.acos(p),T=Math.sin(x);g=Math.sin(g*x)/T,a=Math.sin(a*x)/T,l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+y*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+u*h+l*f-c*d,t[e+1]=l*m+u*d+c*h-a*f,t[e+2]=c*m+u*f+a*d-l*h,t[e+3]=u*m-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:ne("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ee(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Bx.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Bx.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ee(this.x,t.x,e.x),this.y=Ee(this.y,t.y,e.y),this.z=Ee(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ee(this.x,t,e),this.y=Ee(this.y,t,e),this.z=Ee(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ee(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Pp.copy(this).projectOnVector(t),this.sub(Pp)}reflect(t){return this.sub(Pp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ee(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Pp=new H,Bx=new un,ce=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],m=i[8],y=s[0],p=s[3],g=s[6],x=s[1],T=s[4],b=s[7],A=s[2],E=s[5],_=s[8];return r[0]=o*y+a*x+l*A,r[3]=o*p+a*T+l*E,r[6]=o*g+a*b+l*_,r[1]=c*y+u*x+h*A,r[4]=c*p+u*T+h*E,r[7]=c*g+u*b+h*_,r[2]=d*y+f*x+m*A,r[5]=d*p+f*T+m*E,r[8]=d*g+f*b+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,m=e*h+i*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=h*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Ql("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ip.makeScale(t,e)),this}rotate(t){return Ql("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ip.makeRotation(-t)),this}translate(t,e){return Ql("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ip.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ip=new ce,kx=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),zx=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function w1(){let n={enabled:!0,workingColorSpace:ic,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===We&&(s.r=wr(s.r),s.g=wr(s.g),s.b=wr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===We&&(s.r=Da(s.r),s.g=Da(s.g),s.b=Da(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ir?sc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ic]:{primaries:t,whitePoint:i,transfer:sc,toXYZ:kx,fromXYZ:zx,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ii},outputColorSpaceConfig:{drawingBufferColorSpace:ii}},[ii]:{primaries:t,whitePoint:i,transfer:We,toXYZ:kx,fromXYZ:zx,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ii}}}),n}var Ie=w1();function wr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Da(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ma,bh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ma===void 0&&(ma=oc("canvas")),ma.width=t.width,ma.height=t.height;let s=ma.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=ma}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=oc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=wr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(wr(e[i]/255)*255):e[i]=wr(e[i]);return{data:e,width:t.width,height:t.height}}else return ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},E1=0,Oa=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:E1++}),this.uuid=oo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Lp(s[o].image)):r.push(Lp(s[o]))}else r=Lp(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Lp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?bh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ne("Texture: Unable to serialize Texture."),{})}var T1=0,Dp=new H,Ei=class n extends As{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ks,s=Ks,r=wi,o=Cr,a=Is,l=es,c=n.DEFAULT_ANISOTROPY,u=Ir){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:T1++}),this.uuid=oo(),this.name="",this.source=new Oa(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Xt(0,0),this.repeat=new Xt(1,1),this.center=new Xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Dp).x}get height(){return this.source.getSize(Dp).y}get depth(){return this.source.getSize(Dp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ne(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ne(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==ym)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case _h:t.x=t.x-Math.floor(t.x);break;case Ks:t.x=t.x<0?0:1;break;case yh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case _h:t.y=t.y-Math.floor(t.y);break;case Ks:t.y=t.y<0?0:1;break;case yh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ei.DEFAULT_IMAGE=null;Ei.DEFAULT_MAPPING=ym;Ei.DEFAULT_ANISOTROPY=1;var yn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],y=l[2],p=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(m-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(m+p)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,b=(f+1)/2,A=(g+1)/2,E=(u+d)/4,_=(h+y)/4,S=(m+p)/4;return T>b&&T>A?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=E/i,r=_/i):b>A?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=E/s,r=S/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=S/r),this.set(i,s,r,e),this}let x=Math.sqrt((p-m)*(p-m)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(p-m)/x,this.y=(h-y)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ee(this.x,t.x,e.x),this.y=Ee(this.y,t.y,e.y),this.z=Ee(this.z,t.z,e.z),this.w=Ee(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ee(this.x,t,e),this.y=Ee(this.y,t,e),this.z=Ee(this.z,t,e),this.w=Ee(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ee(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mh=class extends As{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:wi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new yn(0,0,t,e),this.scissorTest=!1,this.viewport=new yn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ei({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:wi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Oa(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends Mh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},lc=class extends Ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=Ks,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Sh=class extends Ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ti,this.minFilter=ti,this.wrapR=Ks,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ge=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,m,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,m,y,p)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,m,y,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=m,g[11]=y,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/ga.setFromMatrixColumn(t,0).length(),r=1/ga.setFromMatrixColumn(t,1).length(),o=1/ga.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+m*c,e[5]=d-y*c,e[9]=-a*l,e[2]=y-d*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,m=c*u,y=c*h;e[0]=d+y*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-m,e[6]=y+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,m=c*u,y=c*h;e[0]=d-y*a,e[4]=-o*h,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*u,e[9]=y-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,m=a*u,y=a*h;e[0]=l*u,e[4]=m*c-f,e[8]=d*c+y,e[1]=l*h,e[5]=y*c+d,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=y-d*h,e[8]=m*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+m,e[10]=d-y*h}else if(t.order==="XZY"){let d=o*l,f=o*c,m=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+y,e[5]=o*u,e[9]=f*h-m,e[2]=m*h-f,e[6]=a*u,e[10]=y*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(A1,t,R1)}lookAt(t,e,i){let s=this.elements;return ji.subVectors(t,e),ji.lengthSq()===0&&(ji.z=1),ji.normalize(),Xr.crossVectors(i,ji),Xr.lengthSq()===0&&(Math.abs(i.z)===1?ji.x+=1e-4:ji.z+=1e-4,ji.normalize(),Xr.crossVectors(i,ji)),Xr.normalize(),Uu.crossVectors(ji,Xr),s[0]=Xr.x,s[4]=Uu.x,s[8]=ji.x,s[1]=Xr.y,s[5]=Uu.y,s[9]=ji.y,s[2]=Xr.z,s[6]=Uu.z,s[10]=ji.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],m=i[2],y=i[6],p=i[10],g=i[14],x=i[3],T=i[7],b=i[11],A=i[15],E=s[0],_=s[4],S=s[8],U=s[12],L=s[1],D=s[5],z=s[9],W=s[13],B=s[2],X=s[6],P=s[10],N=s[14],Z=s[3],$=s[7],j=s[11],et=s[15];return r[0]=o*E+a*L+l*B+c*Z,r[4]=o*_+a*D+l*X+c*$,r[8]=o*S+a*z+l*P+c*j,r[12]=o*U+a*W+l*N+c*et,r[1]=u*E+h*L+d*B+f*Z,r[5]=u*_+h*D+d*X+f*$,r[9]=u*S+h*z+d*P+f*j,r[13]=u*U+h*W+d*N+f*et,r[2]=m*E+y*L+p*B+g*Z,r[6]=m*_+y*D+p*X+g*$,r[10]=m*S+y*z+p*P+g*j,r[14]=m*U+y*W+p*N+g*et,r[3]=x*E+T*L+b*B+A*Z,r[7]=x*_+T*D+b*X+A*$,r[11]=x*S+T*z+b*P+A*j,r[15]=x*U+T*W+b*N+A*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],m=t[3],y=t[7],p=t[11],g=t[15],x=l*f-c*d,T=a*f-c*h,b=a*d-l*h,A=o*f-c*u,E=o*d-l*u,_=o*h-a*u;return e*(y*x-p*T+g*b)-i*(m*x-p*A+g*E)+s*(m*T-y*A+g*_)-r*(m*b-y*E+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],m=t[12],y=t[13],p=t[14],g=t[15],x=e*a-i*o,T=e*l-s*o,b=e*c-r*o,A=i*l-s*a,E=i*c-r*a,_=s*c-r*l,S=u*y-h*m,U=u*p-d*m,L=u*g-f*m,D=h*p-d*y,z=h*g-f*y,W=d*g-f*p,B=x*W-T*z+b*D+A*L-E*U+_*S;if(B===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/B;return t[0]=(a*W-l*z+c*D)*X,t[1]=(s*z-i*W-r*D)*X,t[2]=(y*_-p*E+g*A)*X,t[3]=(d*E-h*_-f*A)*X,t[4]=(l*L-o*W-c*U)*X,t[5]=(e*W-s*L+r*U)*X,t[6]=(p*b-m*_-g*T)*X,t[7]=(u*_-d*b+f*T)*X,t[8]=(o*z-a*L+c*S)*X,t[9]=(i*L-e*z-r*S)*X,t[10]=(m*E-y*b+g*x)*X,t[11]=(h*b-u*E-f*x)*X,t[12]=(a*U-o*D-l*S)*X,t[13]=(e*D-i*U+s*S)*X,t[14]=(y*T-m*A-p*x)*X,t[15]=(u*A-h*T+d*x)*X,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,m=r*h,y=o*u,p=o*h,g=a*h,x=l*c,T=l*u,b=l*h,A=i.x,E=i.y,_=i.z;return s[0]=(1-(y+g))*A,s[1]=(f+b)*A,s[2]=(m-T)*A,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(d+g))*E,s[6]=(p+x)*E,s[7]=0,s[8]=(m+T)*_,s[9]=(p-x)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=ga.set(s[0],s[1],s[2]).length(),a=ga.set(s[4],s[5],s[6]).length(),l=ga.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ws.copy(this);let c=1/o,u=1/a,h=1/l;return ws.elements[0]*=c,ws.elements[1]*=c,ws.elements[2]*=c,ws.elements[4]*=u,ws.elements[5]*=u,ws.elements[6]*=u,ws.elements[8]*=h,ws.elements[9]*=h,ws.elements[10]*=h,e.setFromRotationMatrix(ws),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=us,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===us)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===rc)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=us,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===us)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===rc)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},ga=new H,ws=new ge,A1=new H(0,0,0),R1=new H(1,1,1),Xr=new H,Uu=new H,ji=new H,Hx=new ge,Gx=new un,Kr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ee(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ee(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ee(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ee(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ee(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ee(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Hx.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Hx,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Gx.setFromEuler(this),this.setFromQuaternion(Gx,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Kr.DEFAULT_ORDER="XYZ";var Ba=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},C1=0,Vx=new H,xa=new un,_r=new ge,Fu=new H,Vl=new H,P1=new H,I1=new un,Wx=new H(1,0,0),$x=new H(0,1,0),qx=new H(0,0,1),Xx={type:"added"},L1={type:"removed"},_a={type:"childadded",child:null},Np={type:"childremoved",child:null},Ti=class n extends As{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:C1++}),this.uuid=oo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new H,e=new Kr,i=new un,s=new H(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new ce}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ba,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return xa.setFromAxisAngle(t,e),this.quaternion.multiply(xa),this}rotateOnWorldAxis(t,e){return xa.setFromAxisAngle(t,e),this.quaternion.premultiply(xa),this}rotateX(t){return this.rotateOnAxis(Wx,t)}rotateY(t){return this.rotateOnAxis($x,t)}rotateZ(t){return this.rotateOnAxis(qx,t)}translateOnAxis(t,e){return Vx.copy(t).applyQuaternion(this.quaternion),this.position.add(Vx.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Wx,t)}translateY(t){return this.translateOnAxis($x,t)}translateZ(t){return this.translateOnAxis(qx,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(_r.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Fu.copy(t):Fu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Vl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_r.lookAt(Vl,Fu,this.up):_r.lookAt(Fu,Vl,this.up),this.quaternion.setFromRotationMatrix(_r),s&&(_r.extractRotation(s.matrixWorld),xa.setFromRotationMatrix(_r),this.quaternion.premultiply(xa.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Xx),_a.child=t,this.dispatchEvent(_a),_a.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(L1),Np.child=t,this.dispatchEvent(Np),Np.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),_r.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),_r.multiply(t.parent.matrixWorld)),t.applyMatrix4(_r),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Xx),_a.child=t,this.dispatchEvent(_a),_a.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Vl,t,P1),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Vl,I1,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ti.DEFAULT_UP=new H(0,1,0);Ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Tn=class extends Ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},D1={type:"move"},ka=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Tn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Tn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Tn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,i),g=this._getHandJoint(c,y);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(D1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Tn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Q_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Yr={h:0,s:0,l:0},Ou={h:0,s:0,l:0};function Up(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ii){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ie.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ie.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ie.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ie.workingColorSpace){if(t=Nm(t,1),e=Ee(e,0,1),i=Ee(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Up(o,r,t+1/3),this.g=Up(o,r,t),this.b=Up(o,r,t-1/3)}return Ie.colorSpaceToWorking(this,s),this}setStyle(t,e=ii){function i(r){r!==void 0&&parseFloat(r)<1&&ne("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ne("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ne("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ii){let i=Q_[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ne("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=wr(t.r),this.g=wr(t.g),this.b=wr(t.b),this}copyLinearToSRGB(t){return this.r=Da(t.r),this.g=Da(t.g),this.b=Da(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ii){return Ie.workingToColorSpace(hi.copy(this),t),Math.round(Ee(hi.r*255,0,255))*65536+Math.round(Ee(hi.g*255,0,255))*256+Math.round(Ee(hi.b*255,0,255))}getHexString(t=ii){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ie.workingColorSpace){Ie.workingToColorSpace(hi.copy(this),e);let i=hi.r,s=hi.g,r=hi.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Ie.workingColorSpace){return Ie.workingToColorSpace(hi.copy(this),e),t.r=hi.r,t.g=hi.g,t.b=hi.b,t}getStyle(t=ii){Ie.workingToColorSpace(hi.copy(this),t);let e=hi.r,i=hi.g,s=hi.b;return t!==ii?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Yr),this.setHSL(Yr.h+t,Yr.s+e,Yr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Yr),t.getHSL(Ou);let i=ec(Yr.h,Ou.h,e),s=ec(Yr.s,Ou.s,e),r=ec(Yr.l,Ou.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},hi=new ee;ee.NAMES=Q_;var cc=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},uc=class extends Ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Kr,this.environmentIntensity=1,this.environmentRotation=new Kr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Es=new H,yr=new H,Fp=new H,vr=new H,ya=new H,va=new H,Yx=new H,Op=new H,Bp=new H,kp=new H,zp=new yn,Hp=new yn,Gp=new yn,Sr=class n{constructor(t=new H,e=new H,i=new H){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Es.subVectors(t,e),s.cross(Es);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Es.subVectors(s,e),yr.subVectors(i,e),Fp.subVectors(t,e);let o=Es.dot(Es),a=Es.dot(yr),l=Es.dot(Fp),c=yr.dot(yr),u=yr.dot(Fp),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,vr)===null?!1:vr.x>=0&&vr.y>=0&&vr.x+vr.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,vr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vr.x),l.addScaledVector(o,vr.y),l.addScaledVector(a,vr.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return zp.setScalar(0),Hp.setScalar(0),Gp.setScalar(0),zp.fromBufferAttribute(t,e),Hp.fromBufferAttribute(t,i),Gp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zp,r.x),o.addScaledVector(Hp,r.y),o.addScaledVector(Gp,r.z),o}static isFrontFacing(t,e,i,s){return Es.subVectors(i,e),yr.subVectors(t,e),Es.cross(yr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Es.subVectors(this.c,this.b),yr.subVectors(this.a,this.b),Es.cross(yr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ya.subVectors(s,i),va.subVectors(r,i),Op.subVectors(t,i);let l=ya.dot(Op),c=va.dot(Op);if(l<=0&&c<=0)return e.copy(i);Bp.subVectors(t,s);let u=ya.dot(Bp),h=va.dot(Bp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(ya,o);kp.subVectors(t,r);let f=ya.dot(kp),m=va.dot(kp);if(m>=0&&f<=m)return e.copy(r);let y=f*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(va,a);let p=u*m-f*h;if(p<=0&&h-u>=0&&f-m>=0)return Yx.subVectors(r,s),a=(h-u)/(h-u+(f-m)),e.copy(s).addScaledVector(Yx,a);let g=1/(p+y+d);return o=y*g,a=d*g,e.copy(i).addScaledVector(ya,o).addScaledVector(va,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Fi=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ts.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ts.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ts.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ts):Ts.fromBufferAttribute(r,o),Ts.applyMatrix4(t.matrixWorld),this.expandByPoint(Ts);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Bu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Bu.copy(i.boundingBox)),Bu.applyMatrix4(t.matrixWorld),this.union(Bu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ts),Ts.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Wl),ku.subVectors(this.max,Wl),ba.subVectors(t.a,Wl),Ma.subVectors(t.b,Wl),Sa.subVectors(t.c,Wl),Zr.subVectors(Ma,ba),jr.subVectors(Sa,Ma),wo.subVectors(ba,Sa);let e=[0,-Zr.z,Zr.y,0,-jr.z,jr.y,0,-wo.z,wo.y,Zr.z,0,-Zr.x,jr.z,0,-jr.x,wo.z,0,-wo.x,-Zr.y,Zr.x,0,-jr.y,jr.x,0,-wo.y,wo.x,0];return!Vp(e,ba,Ma,Sa,ku)||(e=[1,0,0,0,1,0,0,0,1],!Vp(e,ba,Ma,Sa,ku))?!1:(zu.crossVectors(Zr,jr),e=[zu.x,zu.y,zu.z],Vp(e,ba,Ma,Sa,ku))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ts).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ts).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(br[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),br[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),br[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),br[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),br[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),br[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),br[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),br[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(br),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},br=[new H,new H,new H,new H,new H,new H,new H,new H],Ts=new H,Bu=new Fi,ba=new H,Ma=new H,Sa=new H,Zr=new H,jr=new H,wo=new H,Wl=new H,ku=new H,zu=new H,Eo=new H;function Vp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Eo.fromArray(n,r);let a=s.x*Math.abs(Eo.x)+s.y*Math.abs(Eo.y)+s.z*Math.abs(Eo.z),l=t.dot(Eo),c=e.dot(Eo),u=i.dot(Eo);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Fn=new H,Hu=new Xt,N1=0,Be=class extends As{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:N1++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Lm,this.updateRanges=[],this.gpuType=hs,this.version=0,this._normalizationScale=t!==void 0?Pd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Hu.fromBufferAttribute(this,e),Hu.applyMatrix3(t),this.setXY(e,Hu.x,Hu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix3(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Fm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Om(t,this.array)}};var hc=class extends Be{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var dc=class extends Be{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Te=class extends Be{constructor(t,e,i){super(new Float32Array(t),e,i)}},U1=new Fi,$l=new H,Wp=new H,Qs=class{constructor(t=new H,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):U1.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$l.subVectors(t,this.center);let e=$l.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector($l,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Wp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($l.copy(t.center).add(Wp)),this.expandByPoint($l.copy(t.center).sub(Wp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},F1=0,cs=new ge,$p=new Ti,wa=new H,Ji=new Fi,ql=new Fi,Qn=new H,Me=class n extends As{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:F1++}),this.uuid=oo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(a1(t)?dc:hc)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ce().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return cs.makeRotationFromQuaternion(t),this.applyMatrix4(cs),this}rotateX(t){return cs.makeRotationX(t),this.applyMatrix4(cs),this}rotateY(t){return cs.makeRotationY(t),this.applyMatrix4(cs),this}rotateZ(t){return cs.makeRotationZ(t),this.applyMatrix4(cs),this}translate(t,e,i){return cs.makeTranslation(t,e,i),this.applyMatrix4(cs),this}scale(t,e,i){return cs.makeScale(t,e,i),this.applyMatrix4(cs),this}lookAt(t){return $p.lookAt(t),$p.updateMatrix(),this.applyMatrix4($p.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(wa).negate(),this.translate(wa.x,wa.y,wa.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Te(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ji.setFromBufferAttribute(r),this.morphTargetsRelative?(Qn.addVectors(this.boundingBox.min,Ji.min),this.boundingBox.expandByPoint(Qn),Qn.addVectors(this.boundingBox.max,Ji.max),this.boundingBox.expandByPoint(Qn)):(this.boundingBox.expandByPoint(Ji.min),this.boundingBox.expandByPoint(Ji.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Qs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let i=this.boundingSphere.center;if(Ji.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ql.setFromBufferAttribute(a),this.morphTargetsRelative?(Qn.addVectors(Ji.min,ql.min),Ji.expandByPoint(Qn),Qn.addVectors(Ji.max,ql.max),Ji.expandByPoint(Qn)):(Ji.expandByPoint(ql.min),Ji.expandByPoint(ql.max))}Ji.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Qn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Qn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Qn.fromBufferAttribute(a,c),l&&(wa.fromBufferAttribute(t,c),Qn.add(wa)),s=Math.max(s,i.distanceToSquared(Qn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Be(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new H,l[U]=new H;let u=new H,h=new H,d=new H,f=new Xt,m=new Xt,y=new Xt,p=new H,g=new H;function x(U,L,D){c[U]=c[L]=c[D]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,U),m.fromBufferAttribute(r,L),y.fromBufferAttribute(r,D),h.sub(u),d.sub(u),m.sub(f),y.sub(f);let z=1/(m.x*y.y-y.x*m.y);isFinite(z)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(d,-m.y).multiplyScalar(z),g.copy(d).multiplyScalar(m.x).addScaledVector(h,-y.x).multiplyScalar(z),a[U].add(p),a[L].add(p),a[D].add(p),l[U].add(g),l[L].add(g),l[D].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let U=0,L=T.length;U<L;++U){let D=T[U],z=D.start,W=D.count;for(let B=z,X=z+W;B<X;B+=3)x(t.getX(B+0),t.getX(B+1),t.getX(B+2))}let b=new H,A=new H,E=new H,_=new H;function S(U){E.fromBufferAttribute(s,U),_.copy(E);let L=a[U];b.copy(L),b.sub(E.multiplyScalar(E.dot(L))).normalize(),A.crossVectors(_,L);let z=A.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,z)}for(let U=0,L=i.count;U<L;++U)c[U]&&S(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Be(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(t)for(let d=0,f=t.count;d<f;d+=3){let m=t.getX(d+0),y=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Qn.fromBufferAttribute(t,e),Qn.normalize(),t.setXYZ(e,Qn.x,Qn.y,Qn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let g=0;g<u;g++)d[m++]=c[f++]}return new Be(d,u,h)}if(this.index===null)return ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ro=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Lm,this.updateRanges=[],this.version=0,this.uuid=oo()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Zx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Zx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Zx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=oo()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Mi=new H,Qr=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Pd(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Mi.fromBufferAttribute(this,e),Mi.applyMatrix4(t),this.setXYZ(e,Mi.x,Mi.y,Mi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Mi.fromBufferAttribute(this,e),Mi.applyNormalMatrix(t),this.setXYZ(e,Mi.x,Mi.y,Mi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Mi.fromBufferAttribute(this,e),Mi.transformDirection(t),this.setXYZ(e,Mi.x,Mi.y,Mi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){ac("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Be(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){ac("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Fm(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Om(t,this.data.array)}},qp=new H,O1=new H,B1=new ce,si=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=qp.subVectors(i,e).cross(O1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(qp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||B1.getNormalMatrix(t),s=this.coplanarPoint(qp).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},k1=0,tr=class extends As{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=oo(),this.name="",this.type="Material",this.blending=qa,this.side=ir,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=cm,this.blendDst=um,this.blendEquation=No,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=Na,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=V_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uh,this.stencilZFail=uh,this.stencilZPass=uh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ne(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ne(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new si().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Xt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},za=class extends tr{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ea,Xl=new H,Ta=new H,Aa=new H,Ra=new Xt,Yl=new Xt,ty=new ge,Gu=new H,Zl=new H,Vu=new H,jx=new Xt,Xp=new Xt,Jx=new Xt,fc=class extends Ti{constructor(t=new za){if(super(),this.isSprite=!0,this.type="Sprite",Ea===void 0){Ea=new Me;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Ro(e,5);Ea.setIndex([0,1,2,0,2,3]),Ea.setAttribute("position",new Qr(i,3,0,!1)),Ea.setAttribute("uv",new Qr(i,2,3,!1))}this.geometry=Ea,this.material=t,this.center=new Xt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&re('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Ta.setFromMatrixScale(this.matrixWorld),ty.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Aa.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Ta.multiplyScalar(-Aa.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Wu(Gu.set(-.5,-.5,0),Aa,o,Ta,s,r),Wu(Zl.set(.5,-.5,0),Aa,o,Ta,s,r),Wu(Vu.set(.5,.5,0),Aa,o,Ta,s,r),jx.set(0,0),Xp.set(1,0),Jx.set(1,1);let a=t.ray.intersectTriangle(Gu,Zl,Vu,!1,Xl);if(a===null&&(Wu(Zl.set(-.5,.5,0),Aa,o,Ta,s,r),Xp.set(0,1),a=t.ray.intersectTriangle(Gu,Vu,Zl,!1,Xl),a===null))return;let l=t.ray.origin.distanceTo(Xl);l<t.near||l>t.far||e.push({distance:l,point:Xl.clone(),uv:Sr.getInterpolation(Xl,Gu,Zl,Vu,jx,Xp,Jx,new Xt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Wu(n,t,e,i,s,r){Ra.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Yl.x=r*Ra.x-s*Ra.y,Yl.y=s*Ra.x+r*Ra.y):Yl.copy(Ra),n.copy(t),n.x+=Yl.x,n.y+=Yl.y,n.applyMatrix4(ty)}var Mr=new H,Yp=new H,$u=new H,qu=new H,Tr=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Mr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Mr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Mr.copy(this.origin).addScaledVector(this.direction,e),Mr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Yp.copy(t).add(e).multiplyScalar(.5),$u.copy(e).sub(t).normalize(),qu.copy(this.origin).sub(Yp);let r=t.distanceTo(e)*.5,o=-this.direction.dot($u),a=qu.dot(this.direction),l=-qu.dot($u),c=qu.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=r*u,h>=0)if(d>=-m)if(d<=m){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Yp).addScaledVector($u,d),f}intersectSphere(t,e){if(t.radius<0)return null;Mr.subVectors(t.center,this.origin);let i=Mr.dot(this.direction),s=Mr.dot(Mr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Mr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,m=e.x-o.x,y=e.y-o.y,p=e.z-o.z,g=i.x-o.x,x=i.y-o.y,T=i.z-o.z,b=Math.abs(l),A=Math.abs(c),E=Math.abs(u),_,S,U,L,D,z,W,B,X,P,N,Z;if(b>=A&&b>=E?(U=l,z=h,X=m,Z=g,l>=0?(_=c,S=u,L=d,D=f,W=y,B=p,P=x,N=T):(_=u,S=c,L=f,D=d,W=p,B=y,P=T,N=x)):A>=E?(U=c,z=d,X=y,Z=x,c>=0?(_=u,S=l,L=f,D=h,W=p,B=m,P=T,N=g):(_=l,S=u,L=h,D=f,W=m,B=p,P=g,N=T)):(U=u,z=f,X=p,Z=T,u>=0?(_=l,S=c,L=h,D=d,W=m,B=y,P=g,N=x):(_=c,S=l,L=d,D=h,W=y,B=m,P=x,N=g)),U===0)return null;let $=_/U,j=S/U,et=1/U,dt=L-$*z,ft=D-j*z,st=W-$*X,vt=B-j*X,_t=P-$*Z,Tt=N-j*Z,At=_t*vt-Tt*st,Jt=dt*Tt-ft*_t,pe=st*ft-vt*dt;if(s){if(At<0||Jt<0||pe<0)return null}else if((At<0||Jt<0||pe<0)&&(At>0||Jt>0||pe>0))return null;let Zt=At+Jt+pe;if(Zt===0)return null;let we=et*(At*z+Jt*X+pe*Z);return(Zt>0?we<0:we>0)?null:this.at(we/Zt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ri=class extends tr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Kr,this.combine=hm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Kx=new ge,To=new Tr,Xu=new Qs,Qx=new H,Yu=new H,Zu=new H,ju=new H,Zp=new H,Ju=new H,t_=new H,Ku=new H,Ze=class extends Ti{constructor(t=new Me,e=new ri){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ju.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Zp.fromBufferAttribute(h,t),o?Ju.addScaledVector(Zp,u):Ju.addScaledVector(Zp.sub(e),u))}e.add(Ju)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Xu.copy(i.boundingSphere),Xu.applyMatrix4(r),To.copy(t.ray).recast(t.near),!(Xu.containsPoint(To.origin)===!1&&(To.intersectSphere(Xu,Qx)===null||To.origin.distanceToSquared(Qx)>(t.far-t.near)**2))&&(Kx.copy(r).invert(),To.copy(t.ray).applyMatrix4(Kx),!(i.boundingBox!==null&&To.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,To)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=d.length;m<y;m++){let p=d[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),T=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let b=x,A=T;b<A;b+=3){let E=a.getX(b),_=a.getX(b+1),S=a.getX(b+2);s=Qu(this,g,t,i,c,u,h,E,_,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=m,g=y;p<g;p+=3){let x=a.getX(p),T=a.getX(p+1),b=a.getX(p+2);s=Qu(this,o,t,i,c,u,h,x,T,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=d.length;m<y;m++){let p=d[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),T=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let b=x,A=T;b<A;b+=3){let E=b,_=b+1,S=b+2;s=Qu(this,g,t,i,c,u,h,E,_,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=m,g=y;p<g;p+=3){let x=p,T=p+1,b=p+2;s=Qu(this,o,t,i,c,u,h,x,T,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function z1(n,t,e,i,s,r,o,a){let l;if(t.side===Ci?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===ir,a),l===null)return null;Ku.copy(a),Ku.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ku);return c<e.near||c>e.far?null:{distance:c,point:Ku.clone(),object:n}}function Qu(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Yu),n.getVertexPosition(l,Zu),n.getVertexPosition(c,ju);let u=z1(n,t,e,i,Yu,Zu,ju,t_);if(u){let h=new H;Sr.getBarycoord(t_,Yu,Zu,ju,h),s&&(u.uv=Sr.getInterpolatedAttribute(s,a,l,c,h,new Xt)),r&&(u.uv1=Sr.getInterpolatedAttribute(r,a,l,c,h,new Xt)),o&&(u.normal=Sr.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new H,materialIndex:0};Sr.getNormal(Yu,Zu,ju,d.normal),u.face=d,u.barycoord=h}return u}var pc=class extends Ei{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ti,u=ti,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ha=class extends Be{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ca=new ge,e_=new ge,th=[],n_=new Fi,H1=new ge,jl=new Ze,Jl=new Qs,mc=class extends Ze{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ha(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,H1)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Fi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ca),n_.copy(t.boundingBox).applyMatrix4(Ca),this.boundingBox.union(n_)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Qs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ca),Jl.copy(t.boundingSphere).applyMatrix4(Ca),this.boundingSphere.union(Jl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(jl.geometry=this.geometry,jl.material=this.material,jl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Jl.copy(this.boundingSphere),Jl.applyMatrix4(i),t.ray.intersectsSphere(Jl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ca),e_.multiplyMatrices(i,Ca),jl.matrixWorld=e_,jl.raycast(t,th);for(let o=0,a=th.length;o<a;o++){let l=th[o];l.instanceId=r,l.object=this,e.push(l)}th.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ha(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new pc(new Float32Array(s*this.count),s,this.count,Zh,hs));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ao=new Qs,G1=new Xt(.5,.5),eh=new H,Co=class{constructor(t=new si,e=new si,i=new si,s=new si,r=new si,o=new si){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=us,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],m=r[8],y=r[9],p=r[10],g=r[11],x=r[12],T=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-m,A-x).normalize(),s[1].setComponents(c+o,f+u,g+m,A+x).normalize(),s[2].setComponents(c+a,f+h,g+y,A+T).normalize(),s[3].setComponents(c-a,f-h,g-y,A-T).normalize(),i)s[4].setComponents(l,d,p,b).normalize(),s[5].setComponents(c-l,f-d,g-p,A-b).normalize();else if(s[4].setComponents(c-l,f-d,g-p,A-b).normalize(),e===us)s[5].setComponents(c+l,f+d,g+p,A+b).normalize();else if(e===rc)s[5].setComponents(l,d,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ao.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ao.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ao)}intersectsSprite(t){Ao.center.set(0,0,0);let e=G1.distanceTo(t.center);return Ao.radius=.7071067811865476+e,Ao.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ao)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(eh.x=s.normal.x>0?t.max.x:t.min.x,eh.y=s.normal.y>0?t.max.y:t.min.y,eh.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(eh)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},i_=new ge,wh=class n{constructor(){this.coordinateSystem=us,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];i_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Co),i[s].setFromProjectionMatrix(i_,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Co),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Qi=class extends tr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Eh=new H,Th=new H,s_=new ge,Kl=new Tr,nh=new Qs,jp=new H,r_=new H,er=class extends Ti{constructor(t=new Me,e=new Qi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Eh.fromBufferAttribute(e,s-1),Th.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Eh.distanceTo(Th);t.setAttribute("lineDistance",new Te(i,1))}else ne("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),nh.copy(i.boundingSphere),nh.applyMatrix4(s),nh.radius+=r,t.ray.intersectsSphere(nh)===!1)return;s_.copy(s).invert(),Kl.copy(t.ray).applyMatrix4(s_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=f,p=m-1;y<p;y+=c){let g=u.getX(y),x=u.getX(y+1),T=ih(this,t,Kl,l,g,x,y);T&&e.push(T)}if(this.isLineLoop){let y=u.getX(m-1),p=u.getX(f),g=ih(this,t,Kl,l,y,p,m-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let y=f,p=m-1;y<p;y+=c){let g=ih(this,t,Kl,l,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=ih(this,t,Kl,l,m-1,f,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ih(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Eh.fromBufferAttribute(a,s),Th.fromBufferAttribute(a,r),e.distanceSqToSegment(Eh,Th,jp,r_)>i)return;jp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(jp);if(!(c<t.near||c>t.far))return{distance:c,point:r_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var o_=new H,a_=new H,Po=class extends er{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)o_.fromBufferAttribute(e,s),a_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+o_.distanceTo(a_);t.setAttribute("lineDistance",new Te(i,1))}else ne("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var nr=class extends tr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},l_=new ge,em=new Tr,sh=new Qs,rh=new H,Ar=class extends Ti{constructor(t=new Me,e=new nr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),sh.copy(i.boundingSphere),sh.applyMatrix4(s),sh.radius+=r,t.ray.intersectsSphere(sh)===!1)return;l_.copy(s).invert(),em.copy(t.ray).applyMatrix4(l_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,y=f;m<y;m++){let p=c.getX(m);rh.fromBufferAttribute(h,p),c_(rh,p,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let m=d,y=f;m<y;m++)rh.fromBufferAttribute(h,m),c_(rh,m,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function c_(n,t,e,i,s,r,o){let a=em.distanceSqToPoint(n);if(a<e){let l=new H;em.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var gc=class extends Ei{constructor(t=[],e=Uo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},xc=class extends Ei{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Rr=class extends Ei{constructor(t,e,i=Cs,s,r,o,a=ti,l=ti,c,u=Er,h=1){if(u!==Er&&u!==Pr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Oa(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},_c=class extends Rr{constructor(t,e=Cs,i=Uo,s,r,o=ti,a=ti,l,c=Er){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},yc=class extends Ei{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Oi=class n extends Me{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(u,3)),this.setAttribute("uv",new Te(h,2));function m(y,p,g,x,T,b,A,E,_,S,U){let L=b/_,D=A/S,z=b/2,W=A/2,B=E/2,X=_+1,P=S+1,N=0,Z=0,$=new H;for(let j=0;j<P;j++){let et=j*D-W;for(let dt=0;dt<X;dt++){let ft=dt*L-z;$[y]=ft*x,$[p]=et*T,$[g]=B,c.push($.x,$.y,$.z),$[y]=0,$[p]=0,$[g]=E>0?1:-1,u.push($.x,$.y,$.z),h.push(dt/_),h.push(1-j/S),N+=1}}for(let j=0;j<S;j++)for(let et=0;et<_;et++){let dt=d+et+X*j,ft=d+et+X*(j+1),st=d+(et+1)+X*(j+1),vt=d+(et+1)+X*j;l.push(dt,ft,vt),l.push(ft,st,vt),Z+=6}a.addGroup(f,Z,U),f+=Z,d+=N}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Io=class n extends Me{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,m=i*2+r,y=s+1,p=new H,g=new H;for(let x=0;x<=m;x++){let T=0,b=0,A=0,E=0;if(x<=i){let U=x/i,L=U*Math.PI/2;b=-u-t*Math.cos(L),A=t*Math.sin(L),E=-t*Math.cos(L),T=U*h}else if(x<=i+r){let U=(x-i)/r;b=-u+U*e,A=t,E=0,T=h+U*d}else{let U=(x-i-r)/i,L=U*Math.PI/2;b=u+t*Math.sin(L),A=t*Math.cos(L),E=t*Math.sin(L),T=h+d+U*h}let _=Math.max(0,Math.min(1,T/f)),S=0;x===0?S=.5/s:x===m&&(S=-.5/s);for(let U=0;U<=s;U++){let L=U/s,D=L*Math.PI*2,z=Math.sin(D),W=Math.cos(D);g.x=-A*W,g.y=b,g.z=A*z,a.push(g.x,g.y,g.z),p.set(-A*W,E,A*z),p.normalize(),l.push(p.x,p.y,p.z),c.push(L+S,_)}if(x>0){let U=(x-1)*y;for(let L=0;L<s;L++){let D=U+L,z=U+L+1,W=x*y+L,B=x*y+L+1;o.push(D,z,W),o.push(z,B,W)}}}this.setIndex(o),this.setAttribute("position",new Te(a,3)),this.setAttribute("normal",new Te(l,3)),this.setAttribute("uv",new Te(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},vc=class n extends Me{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new H,u=new Xt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new Te(o,3)),this.setAttribute("normal",new Te(a,3)),this.setAttribute("uv",new Te(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ai=class n extends Me{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],m=0,y=[],p=i/2,g=0;x(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Te(h,3)),this.setAttribute("normal",new Te(d,3)),this.setAttribute("uv",new Te(f,2));function x(){let b=new H,A=new H,E=0,_=(e-t)/i;for(let S=0;S<=r;S++){let U=[],L=S/r,D=L*(e-t)+t;for(let z=0;z<=s;z++){let W=z/s,B=W*l+a,X=Math.sin(B),P=Math.cos(B);A.x=D*X,A.y=-L*i+p,A.z=D*P,h.push(A.x,A.y,A.z),b.set(X,_,P).normalize(),d.push(b.x,b.y,b.z),f.push(W,1-L),U.push(m++)}y.push(U)}for(let S=0;S<s;S++)for(let U=0;U<r;U++){let L=y[U][S],D=y[U+1][S],z=y[U+1][S+1],W=y[U][S+1];(t>0||U!==0)&&(u.push(L,D,W),E+=3),(e>0||U!==r-1)&&(u.push(D,z,W),E+=3)}c.addGroup(g,E,0),g+=E}function T(b){let A=m,E=new Xt,_=new H,S=0,U=b===!0?t:e,L=b===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,p*L,0),d.push(0,L,0),f.push(.5,.5),m++;let D=m;for(let z=0;z<=s;z++){let B=z/s*l+a,X=Math.cos(B),P=Math.sin(B);_.x=U*P,_.y=p*L,_.z=U*X,h.push(_.x,_.y,_.z),d.push(0,L,0),E.x=X*.5+.5,E.y=P*.5*L+.5,f.push(E.x,E.y),m++}for(let z=0;z<s;z++){let W=A+z,B=D+z;b===!0?u.push(B,B+1,W):u.push(B+1,B,W),S+=3}c.addGroup(g,S,b===!0?1:2),g+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Lo=class n extends Ai{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ah=class n extends Me{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Te(r,3)),this.setAttribute("normal",new Te(r.slice(),3)),this.setAttribute("uv",new Te(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let T=new H,b=new H,A=new H;for(let E=0;E<e.length;E+=3)f(e[E+0],T),f(e[E+1],b),f(e[E+2],A),l(T,b,A,x)}function l(x,T,b,A){let E=A+1,_=[];for(let S=0;S<=E;S++){_[S]=[];let U=x.clone().lerp(b,S/E),L=T.clone().lerp(b,S/E),D=E-S;for(let z=0;z<=D;z++)z===0&&S===E?_[S][z]=U:_[S][z]=U.clone().lerp(L,z/D)}for(let S=0;S<E;S++)for(let U=0;U<2*(E-S)-1;U++){let L=Math.floor(U/2);U%2===0?(d(_[S][L+1]),d(_[S+1][L]),d(_[S][L])):(d(_[S][L+1]),d(_[S+1][L+1]),d(_[S+1][L]))}}function c(x){let T=new H;for(let b=0;b<r.length;b+=3)T.x=r[b+0],T.y=r[b+1],T.z=r[b+2],T.normalize().multiplyScalar(x),r[b+0]=T.x,r[b+1]=T.y,r[b+2]=T.z}function u(){let x=new H;for(let T=0;T<r.length;T+=3){x.x=r[T+0],x.y=r[T+1],x.z=r[T+2];let b=p(x)/2/Math.PI+.5,A=g(x)/Math.PI+.5;o.push(b,1-A)}m(),h()}function h(){for(let x=0;x<o.length;x+=6){let T=o[x+0],b=o[x+2],A=o[x+4],E=Math.max(T,b,A),_=Math.min(T,b,A);E>.9&&_<.1&&(T<.2&&(o[x+0]+=1),b<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,T){let b=x*3;T.x=t[b+0],T.y=t[b+1],T.z=t[b+2]}function m(){let x=new H,T=new H,b=new H,A=new H,E=new Xt,_=new Xt,S=new Xt;for(let U=0,L=0;U<r.length;U+=9,L+=6){x.set(r[U+0],r[U+1],r[U+2]),T.set(r[U+3],r[U+4],r[U+5]),b.set(r[U+6],r[U+7],r[U+8]),E.set(o[L+0],o[L+1]),_.set(o[L+2],o[L+3]),S.set(o[L+4],o[L+5]),A.copy(x).add(T).add(b).divideScalar(3);let D=p(A);y(E,L+0,x,D),y(_,L+2,T,D),y(S,L+4,b,D)}}function y(x,T,b,A){A<0&&x.x===1&&(o[T]=x.x-1),b.x===0&&b.z===0&&(o[T]=A/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var bc=class n extends Me{constructor(t=[new Xt(0,-.5),new Xt(.5,0),new Xt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Ee(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new H,d=new Xt,f=new H,m=new H,y=new H,p=0,g=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:p=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-p,f.z=g*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:y.normalize(),l.push(y.x,y.y,y.z);break;default:p=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-p,f.z=g*0,m.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(m)}for(let x=0;x<=e;x++){let T=i+x*u*s,b=Math.sin(T),A=Math.cos(T);for(let E=0;E<=t.length-1;E++){h.x=t[E].x*b,h.y=t[E].y,h.z=t[E].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=E/(t.length-1),a.push(d.x,d.y);let _=l[3*E+0]*b,S=l[3*E+1],U=l[3*E+0]*A;c.push(_,S,U)}}for(let x=0;x<e;x++)for(let T=0;T<t.length-1;T++){let b=T+x*t.length,A=b,E=b+t.length,_=b+t.length+1,S=b+1;r.push(A,E,S),r.push(_,S,E)}this.setIndex(r),this.setAttribute("position",new Te(o,3)),this.setAttribute("uv",new Te(a,2)),this.setAttribute("normal",new Te(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Mc=class n extends Ah{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Sc=class n extends Me{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],m=[],y=[],p=[];for(let g=0;g<u;g++){let x=g*d-o;for(let T=0;T<c;T++){let b=T*h-r;m.push(b,-x,0),y.push(0,0,1),p.push(T/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let T=x+c*g,b=x+c*(g+1),A=x+1+c*(g+1),E=x+1+c*g;f.push(T,b,E),f.push(b,A,E)}this.setIndex(f),this.setAttribute("position",new Te(m,3)),this.setAttribute("normal",new Te(y,3)),this.setAttribute("uv",new Te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Rs=class n extends Me{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,d=new H,f=[],m=[],y=[],p=[];for(let g=0;g<=i;g++){let x=[],T=g/i,b=o+T*a,A=t*Math.cos(b),E=Math.sqrt(t*t-A*A),_=0;g===0&&o===0?_=.5/e:g===i&&l===Math.PI&&(_=-.5/e);for(let S=0;S<=e;S++){let U=S/e,L=s+U*r;h.x=-E*Math.cos(L),h.y=A,h.z=E*Math.sin(L),m.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),p.push(U+_,1-T),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let T=u[g][x+1],b=u[g][x],A=u[g+1][x],E=u[g+1][x+1];(g!==0||o>0)&&f.push(T,b,E),(g!==i-1||l<Math.PI)&&f.push(b,A,E)}this.setIndex(f),this.setAttribute("position",new Te(m,3)),this.setAttribute("normal",new Te(y,3)),this.setAttribute("uv",new Te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ga=class n extends Me{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new H,f=new H,m=new H;for(let y=0;y<=i;y++){let p=o+y/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(p))*Math.cos(x),f.y=(t+e*Math.cos(p))*Math.sin(x),f.z=e*Math.sin(p),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),m.subVectors(f,d).normalize(),u.push(m.x,m.y,m.z),h.push(g/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let p=1;p<=s;p++){let g=(s+1)*y+p-1,x=(s+1)*(y-1)+p-1,T=(s+1)*(y-1)+p,b=(s+1)*y+p;l.push(g,x,b),l.push(x,T,b)}this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(u,3)),this.setAttribute("uv",new Te(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Oo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(u_(s))s.isRenderTargetTexture?(ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(u_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function fi(n){let t={};for(let e=0;e<n.length;e++){let i=Oo(n[e]);for(let s in i)t[s]=i[s]}return t}function u_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function V1(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Bm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ie.workingColorSpace}var ey={clone:Oo,merge:fi},W1=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,$1=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ri=class extends tr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=W1,this.fragmentShader=$1,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Oo(t.uniforms),this.uniformsGroups=V1(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new Xt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new yn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ce().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ge().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Rh=class extends Ri{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ch=class extends tr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=H_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Ph=class extends tr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Pa(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function oh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var to=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ih=class extends to{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Kp,endingEnd:Kp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Qp:r=t,a=2*e-i;break;case tm:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Qp:o=t,l=2*i-e;break;case tm:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),y=m*m,p=y*m,g=-d*p+2*d*y-d*m,x=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*m+1,T=(-1-f)*p+(1.5+f)*y+.5*m,b=f*p-f*y;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[c+A]+T*o[l+A]+b*o[h+A];return r}},Lh=class extends to{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Dh=class extends to{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Nh=class extends to{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-e)/(s-e),y=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*m;return r}let d=a*2,f=t-1;for(let m=0;m!==a;++m){let y=o[c+m],p=o[l+m],g=f*d+m*2,x=h[g],T=h[g+1],b=t*d+m*2,A=u[b],E=u[b+1],_=X1(i,e,x,A,s);r[m]=ny(_,y,T,E,p)}return r}};function ny(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function q1(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function X1(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=ny(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=q1(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ts=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Pa(e,this.TimeBufferType),this.values=Pa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Pa(t.times,Array),values:Pa(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),oh(t.settings)&&(i.settings={inTangents:Pa(t.settings.inTangents,Array),outTangents:Pa(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Lh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ih(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Nh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case nc:e=this.InterpolantFactoryMethodDiscrete;break;case vh:e=this.InterpolantFactoryMethodLinear;break;case ch:e=this.InterpolantFactoryMethodSmooth;break;case Jp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ne("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return nc;case this.InterpolantFactoryMethodLinear:return vh;case this.InterpolantFactoryMethodSmooth:return ch;case this.InterpolantFactoryMethodBezier:return Jp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;oh(this.settings)&&(h_(this.settings.inTangents,t),h_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;oh(this.settings)&&(d_(this.settings.inTangents,t),d_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&l1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ch,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let m=0;m!==i;++m){let y=e[h+m];if(y!==e[d+m]||y!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,oh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function h_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function d_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ts.prototype.ValueTypeName="";ts.prototype.TimeBufferType=Float32Array;ts.prototype.ValueBufferType=Float32Array;ts.prototype.DefaultInterpolation=vh;var eo=class extends ts{constructor(t,e,i){super(t,e,i)}};eo.prototype.ValueTypeName="bool";eo.prototype.ValueBufferType=Array;eo.prototype.DefaultInterpolation=nc;eo.prototype.InterpolantFactoryMethodLinear=void 0;eo.prototype.InterpolantFactoryMethodSmooth=void 0;var Uh=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}};Uh.prototype.ValueTypeName="color";var Fh=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}};Fh.prototype.ValueTypeName="number";var Oh=class extends to{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)un.slerpFlat(r,0,o,c-a,o,c,l);return r}},wc=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Oh(this.times,this.values,this.getValueSize(),t)}};wc.prototype.ValueTypeName="quaternion";wc.prototype.InterpolantFactoryMethodSmooth=void 0;var no=class extends ts{constructor(t,e,i){super(t,e,i)}};no.prototype.ValueTypeName="string";no.prototype.ValueBufferType=Array;no.prototype.DefaultInterpolation=nc;no.prototype.InterpolantFactoryMethodLinear=void 0;no.prototype.InterpolantFactoryMethodSmooth=void 0;var Bh=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}};Bh.prototype.ValueTypeName="vector";var kh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},iy=new kh,zh=class{constructor(t){this.manager=t!==void 0?t:iy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};zh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ah=new H,lh=new un,Js=new H,Ec=class extends Ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,this.coordinateSystem=us,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ah,lh,Js),Js.x===1&&Js.y===1&&Js.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ah,lh,Js.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ah,lh,Js),Js.x===1&&Js.y===1&&Js.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ah,lh,Js.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Jr=new H,f_=new Xt,p_=new Xt,Si=class extends Ec{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Fa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(tc*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Fa*2*Math.atan(Math.tan(tc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Jr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Jr.x,Jr.y).multiplyScalar(-t/Jr.z),Jr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Jr.x,Jr.y).multiplyScalar(-t/Jr.z)}getViewSize(t,e){return this.getViewBounds(t,f_,p_),e.subVectors(p_,f_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(tc*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Hh=class extends Ec{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Ia=-90,La=1,Va=class extends Ti{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Si(Ia,La,t,e);s.layers=this.layers,this.add(s);let r=new Si(Ia,La,t,e);r.layers=this.layers,this.add(r);let o=new Si(Ia,La,t,e);o.layers=this.layers,this.add(o);let a=new Si(Ia,La,t,e);a.layers=this.layers,this.add(a);let l=new Si(Ia,La,t,e);l.layers=this.layers,this.add(l);let c=new Si(Ia,La,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===us)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===rc)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Gh=class extends Si{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var km="\\[\\]\\.:\\/",Y1=new RegExp("["+km+"]","g"),zm="[^"+km+"]",Z1="[^"+km.replace("\\.","")+"]",j1=/((?:WC+[\/:])*)/.source.replace("WC",zm),J1=/(WCOD+)?/.source.replace("WCOD",Z1),K1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",zm),Q1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",zm),tE=new RegExp("^"+j1+J1+K1+Q1+"$"),eE=["material","materials","bones","map"],nm=class{constructor(t,e,i){let s=i||cn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},cn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Y1,"")}static parseTrackName(t){let e=tE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);eE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ne("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};cn.Composite=nm;cn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};cn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};cn.prototype.GetterByBindingType=[cn.prototype._getValue_direct,cn.prototype._getValue_array,cn.prototype._getValue_arrayElement,cn.prototype._getValue_toArray];cn.prototype.SetterByBindingTypeAndVersioning=[[cn.prototype._setValue_direct,cn.prototype._setValue_direct_setNeedsUpdate,cn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[cn.prototype._setValue_array,cn.prototype._setValue_array_setNeedsUpdate,cn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[cn.prototype._setValue_arrayElement,cn.prototype._setValue_arrayElement_setNeedsUpdate,cn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[cn.prototype._setValue_fromArray,cn.prototype._setValue_fromArray_setNeedsUpdate,cn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var uD=new Float32Array(1);var m_=new ge,Tc=class{constructor(t,e,i=0,s=1/0){this.ray=new Tr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Ba,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):re("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return m_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(m_),this}intersectObject(t,e=!0,i=[]){return im(t,this,i,e),i.sort(g_),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)im(t[s],this,i,e);return i.sort(g_),i}};function g_(n,t){return n.distance-t.distance}function im(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)im(r[o],t,e,!0)}}var Wa=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ee(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Ee(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var sm=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ac=class extends As{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Hm(n,t,e,i){let s=nE(i);switch(e){case wm:return n*t;case Zh:return n*t/s.components*s.byteLength;case jh:return n*t/s.components*s.byteLength;case ro:return n*t*2/s.components*s.byteLength;case Jh:return n*t*2/s.components*s.byteLength;case Em:return n*t*3/s.components*s.byteLength;case Is:return n*t*4/s.components*s.byteLength;case Kh:return n*t*4/s.components*s.byteLength;case Pc:case Ic:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Lc:case Dc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case td:case nd:return Math.max(n,16)*Math.max(t,8)/4;case Qh:case ed:return Math.max(n,8)*Math.max(t,8)/2;case id:case sd:case od:case ad:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case rd:case Nc:case ld:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case cd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ud:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case hd:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case dd:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case fd:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case pd:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case md:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case gd:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case xd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case _d:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case yd:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case vd:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case bd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Md:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Sd:case wd:case Ed:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Td:case Ad:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Uc:case Rd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function nE(n){switch(n){case es:case vm:return{byteLength:1,components:1};case Ya:case bm:case Ps:return{byteLength:2,components:1};case Xh:case Yh:return{byteLength:2,components:4};case Cs:case qh:case hs:return{byteLength:4,components:1};case Mm:case Sm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ey(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function aE(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],y=h[f];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let y=h[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var lE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,cE=`#ifdef USE_ALPHAHASH
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
#endif`,uE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,hE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,dE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,fE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,pE=`#ifdef USE_AOMAP
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
#endif`,mE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,gE=`#ifdef USE_BATCHING
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
#endif`,xE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,_E=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,yE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,vE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,bE=`#ifdef USE_IRIDESCENCE
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
#endif`,ME=`#ifdef USE_BUMPMAP
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
#endif`,SE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,wE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,EE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,TE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,AE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,RE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,CE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,PE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,IE=`#define PI 3.141592653589793
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
} // validated`,LE=`vec3 transformedNormal = objectNormal;
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
#endif`,DE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,NE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,UE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,FE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,OE="gl_FragColor = linearToOutputTexel( gl_FragColor );",BE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,kE=`#ifdef USE_ENVMAP
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
#endif`,zE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,HE=`#ifdef USE_ENVMAP
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
#endif`,GE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,VE=`#ifdef USE_ENVMAP
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
#endif`,WE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,$E=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,qE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,XE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,YE=`#ifdef USE_GRADIENTMAP
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
}`,ZE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,jE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,JE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,KE=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,QE=`#ifdef USE_ENVMAP
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
#endif`,tT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,eT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,nT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,iT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,sT=`PhysicalMaterial material;
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
#endif`,rT=`uniform sampler2D dfgLUT;
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
}`,oT=`
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
#endif`,aT=`#if defined( RE_IndirectDiffuse )
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
#endif`,lT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,cT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,uT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,hT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,dT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,fT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,pT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,mT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,gT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,xT=`#if defined( USE_POINTS_UV )
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
#endif`,_T=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,yT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,vT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,bT=`#if defined( USE_MORPHCOLORS )
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
#endif`,MT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ST=`#ifdef USE_MORPHTARGETS
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
#endif`,wT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ET=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,TT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,AT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,RT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,CT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,PT=`#ifdef USE_NORMALMAP
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
#endif`,IT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,LT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,DT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,NT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,UT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,FT=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,OT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,BT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,kT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,zT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,HT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,GT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,VT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,WT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,$T=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,qT=`float getShadowMask() {
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
}`,XT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,YT=`#ifdef USE_SKINNING
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
#endif`,ZT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,jT=`#ifdef USE_SKINNING
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
#endif`,JT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,KT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,QT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,eA=`#ifdef USE_TRANSMISSION
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
#endif`,nA=`#ifdef USE_TRANSMISSION
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
#endif`,iA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,oA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,aA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,lA=`uniform sampler2D t2D;
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
}`,cA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uA=`uniform float backgroundBlurriness;
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
}`,hA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fA=`#include <common>
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
}`,pA=`#if DEPTH_PACKING == 3200
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
}`,mA=`#define DISTANCE
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
}`,gA=`#define DISTANCE
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
}`,xA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,_A=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yA=`uniform float scale;
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
}`,vA=`uniform vec3 diffuse;
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
}`,bA=`#include <common>
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
}`,MA=`uniform vec3 diffuse;
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
}`,SA=`#define LAMBERT
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
}`,wA=`#define LAMBERT
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
}`,EA=`#define MATCAP
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
}`,TA=`#define MATCAP
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
}`,AA=`#define NORMAL
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
}`,RA=`#define NORMAL
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
}`,CA=`#define PHONG
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
}`,PA=`#define PHONG
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
}`,IA=`#define STANDARD
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
}`,LA=`#define STANDARD
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
}`,DA=`#define TOON
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
}`,NA=`#define TOON
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
}`,UA=`uniform float size;
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
}`,FA=`uniform vec3 diffuse;
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
}`,OA=`#include <common>
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
}`,BA=`uniform vec3 color;
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
}`,kA=`uniform float rotation;
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
}`,zA=`uniform vec3 diffuse;
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
}`,Se={alphahash_fragment:lE,alphahash_pars_fragment:cE,alphamap_fragment:uE,alphamap_pars_fragment:hE,alphatest_fragment:dE,alphatest_pars_fragment:fE,aomap_fragment:pE,aomap_pars_fragment:mE,batching_pars_vertex:gE,batching_vertex:xE,begin_vertex:_E,beginnormal_vertex:yE,bsdfs:vE,iridescence_fragment:bE,bumpmap_pars_fragment:ME,clipping_planes_fragment:SE,clipping_planes_pars_fragment:wE,clipping_planes_pars_vertex:EE,clipping_planes_vertex:TE,color_fragment:AE,color_pars_fragment:RE,color_pars_vertex:CE,color_vertex:PE,common:IE,defaultnormal_vertex:LE,displacementmap_pars_vertex:DE,displacementmap_vertex:NE,emissivemap_fragment:UE,emissivemap_pars_fragment:FE,colorspace_fragment:OE,colorspace_pars_fragment:BE,envmap_fragment:kE,envmap_common_pars_fragment:zE,envmap_pars_fragment:HE,envmap_pars_vertex:GE,envmap_physical_pars_fragment:QE,envmap_vertex:VE,fog_vertex:WE,fog_pars_vertex:$E,fog_fragment:qE,fog_pars_fragment:XE,gradientmap_pars_fragment:YE,lightmap_pars_fragment:ZE,lights_lambert_fragment:jE,lights_lambert_pars_fragment:JE,lights_pars_begin:KE,lights_toon_fragment:tT,lights_toon_pars_fragment:eT,lights_phong_fragment:nT,lights_phong_pars_fragment:iT,lights_physical_fragment:sT,lights_physical_pars_fragment:rT,lights_fragment_begin:oT,lights_fragment_maps:aT,lights_fragment_end:lT,lightprobes_pars_fragment:cT,logdepthbuf_fragment:uT,logdepthbuf_pars_fragment:hT,logdepthbuf_pars_vertex:dT,logdepthbuf_vertex:fT,map_fragment:pT,map_pars_fragment:mT,map_particle_fragment:gT,map_particle_pars_fragment:xT,metalnessmap_fragment:_T,metalnessmap_pars_fragment:yT,morphinstance_vertex:vT,morphcolor_vertex:bT,morphnormal_vertex:MT,morphtarget_pars_vertex:ST,morphtarget_vertex:wT,normal_fragment_begin:ET,normal_fragment_maps:TT,normal_pars_fragment:AT,normal_pars_vertex:RT,normal_vertex:CT,normalmap_pars_fragment:PT,clearcoat_normal_fragment_begin:IT,clearcoat_normal_fragment_maps:LT,clearcoat_pars_fragment:DT,iridescence_pars_fragment:NT,opaque_fragment:UT,packing:FT,premultiplied_alpha_fragment:OT,project_vertex:BT,dithering_fragment:kT,dithering_pars_fragment:zT,roughnessmap_fragment:HT,roughnessmap_pars_fragment:GT,shadowmap_pars_fragment:VT,shadowmap_pars_vertex:WT,shadowmap_vertex:$T,shadowmask_pars_fragment:qT,skinbase_vertex:XT,skinning_pars_vertex:YT,skinning_vertex:ZT,skinnormal_vertex:jT,specularmap_fragment:JT,specularmap_pars_fragment:KT,tonemapping_fragment:QT,tonemapping_pars_fragment:tA,transmission_fragment:eA,transmission_pars_fragment:nA,uv_pars_fragment:iA,uv_pars_vertex:sA,uv_vertex:rA,worldpos_vertex:oA,background_vert:aA,background_frag:lA,backgroundCube_vert:cA,backgroundCube_frag:uA,cube_vert:hA,cube_frag:dA,depth_vert:fA,depth_frag:pA,distance_vert:mA,distance_frag:gA,equirect_vert:xA,equirect_frag:_A,linedashed_vert:yA,linedashed_frag:vA,meshbasic_vert:bA,meshbasic_frag:MA,meshlambert_vert:SA,meshlambert_frag:wA,meshmatcap_vert:EA,meshmatcap_frag:TA,meshnormal_vert:AA,meshnormal_frag:RA,meshphong_vert:CA,meshphong_frag:PA,meshphysical_vert:IA,meshphysical_frag:LA,meshtoon_vert:DA,meshtoon_frag:NA,points_vert:UA,points_frag:FA,shadow_vert:OA,shadow_frag:BA,sprite_vert:kA,sprite_frag:zA},Ot={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new Xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},or={basic:{uniforms:fi([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:Se.meshbasic_vert,fragmentShader:Se.meshbasic_frag},lambert:{uniforms:fi([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:Se.meshlambert_vert,fragmentShader:Se.meshlambert_frag},phong:{uniforms:fi([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Se.meshphong_vert,fragmentShader:Se.meshphong_frag},standard:{uniforms:fi([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag},toon:{uniforms:fi([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)}}]),vertexShader:Se.meshtoon_vert,fragmentShader:Se.meshtoon_frag},matcap:{uniforms:fi([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:Se.meshmatcap_vert,fragmentShader:Se.meshmatcap_frag},points:{uniforms:fi([Ot.points,Ot.fog]),vertexShader:Se.points_vert,fragmentShader:Se.points_frag},dashed:{uniforms:fi([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Se.linedashed_vert,fragmentShader:Se.linedashed_frag},depth:{uniforms:fi([Ot.common,Ot.displacementmap]),vertexShader:Se.depth_vert,fragmentShader:Se.depth_frag},normal:{uniforms:fi([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:Se.meshnormal_vert,fragmentShader:Se.meshnormal_frag},sprite:{uniforms:fi([Ot.sprite,Ot.fog]),vertexShader:Se.sprite_vert,fragmentShader:Se.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Se.background_vert,fragmentShader:Se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:Se.backgroundCube_vert,fragmentShader:Se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Se.cube_vert,fragmentShader:Se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Se.equirect_vert,fragmentShader:Se.equirect_frag},distance:{uniforms:fi([Ot.common,Ot.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Se.distance_vert,fragmentShader:Se.distance_frag},shadow:{uniforms:fi([Ot.lights,Ot.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:Se.shadow_vert,fragmentShader:Se.shadow_frag}};or.physical={uniforms:fi([or.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new Xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ce},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new Xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new Xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:Se.meshphysical_vert,fragmentShader:Se.meshphysical_frag};var Id={r:0,b:0,g:0},HA=new ge,Ty=new ce;Ty.set(-1,0,0,0,1,0,0,0,1);function GA(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let T=x.isScene===!0?x.background:null;if(T&&T.isTexture){let b=x.backgroundBlurriness>0;T=t.get(T,b)}return T}function m(x){let T=!1,b=f(x);b===null?p(o,a):b&&b.isColor&&(p(b,1),T=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,T){let b=f(T);b&&b.isCubeTexture?(c===void 0&&(c=new Ze(new Oi(1,1,1),new Ri({name:"BackgroundCubeMaterial",uniforms:Oo(or.backgroundCube.uniforms),vertexShader:or.backgroundCube.vertexShader,fragmentShader:or.backgroundCube.fragmentShader,side:Ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(HA.makeRotationFromEuler(T.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ty),c.material.toneMapped=Ie.getTransfer(b.colorSpace)!==We,(u!==b||h!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ze(new Sc(2,2),new Ri({name:"BackgroundMaterial",uniforms:Oo(or.background.uniforms),vertexShader:or.background.vertexShader,fragmentShader:or.background.fragmentShader,side:ir,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Ie.getTransfer(b.colorSpace)!==We,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,T){x.getRGB(Id,Bm(n)),e.buffers.color.setClear(Id.r,Id.g,Id.b,T,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,T=1){o.set(x),a=T,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:m,addToRenderList:y,dispose:g}}function VA(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,z,W,B,X){let P=!1,N=h(D,B,W,z);r!==N&&(r=N,c(r.object)),P=f(D,B,W,X),P&&m(D,B,W,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(P||o)&&(o=!1,b(D,z,W,B),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function h(D,z,W,B){let X=B.wireframe===!0,P=i[z.id];P===void 0&&(P={},i[z.id]=P);let N=D.isInstancedMesh===!0?D.id:0,Z=P[N];Z===void 0&&(Z={},P[N]=Z);let $=Z[W.id];$===void 0&&($={},Z[W.id]=$);let j=$[X];return j===void 0&&(j=d(l()),$[X]=j),j}function d(D){let z=[],W=[],B=[];for(let X=0;X<e;X++)z[X]=0,W[X]=0,B[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:W,attributeDivisors:B,object:D,attributes:{},index:null}}function f(D,z,W,B){let X=r.attributes,P=z.attributes,N=0,Z=W.getAttributes();for(let $ in Z)if(Z[$].location>=0){let et=X[$],dt=P[$];if(dt===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(dt=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(dt=D.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;N++}return r.attributesNum!==N||r.index!==B}function m(D,z,W,B){let X={},P=z.attributes,N=0,Z=W.getAttributes();for(let $ in Z)if(Z[$].location>=0){let et=P[$];et===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(et=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(et=D.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),X[$]=dt,N++}r.attributes=X,r.attributesNum=N,r.index=B}function y(){let D=r.newAttributes;for(let z=0,W=D.length;z<W;z++)D[z]=0}function p(D){g(D,0)}function g(D,z){let W=r.newAttributes,B=r.enabledAttributes,X=r.attributeDivisors;W[D]=1,B[D]===0&&(n.enableVertexAttribArray(D),B[D]=1),X[D]!==z&&(n.vertexAttribDivisor(D,z),X[D]=z)}function x(){let D=r.newAttributes,z=r.enabledAttributes;for(let W=0,B=z.length;W<B;W++)z[W]!==D[W]&&(n.disableVertexAttribArray(W),z[W]=0)}function T(D,z,W,B,X,P,N){N===!0?n.vertexAttribIPointer(D,z,W,X,P):n.vertexAttribPointer(D,z,W,B,X,P)}function b(D,z,W,B){y();let X=B.attributes,P=W.getAttributes(),N=z.defaultAttributeValues;for(let Z in P){let $=P[Z];if($.location>=0){let j=X[Z];if(j===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let et=j.normalized,dt=j.itemSize,ft=t.get(j);if(ft===void 0)continue;let st=ft.buffer,vt=ft.type,_t=ft.bytesPerElement,Tt=vt===n.INT||vt===n.UNSIGNED_INT||j.gpuType===qh;if(j.isInterleavedBufferAttribute){let At=j.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,pe=j.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Zt=0;Zt<$.locationSize;Zt++)g($.location+Zt,At.meshPerAttribute);D.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Zt=0;Zt<$.locationSize;Zt++)p($.location+Zt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let Zt=0;Zt<$.locationSize;Zt++)T($.location+Zt,dt/$.locationSize,vt,et,Jt*_t,(pe+dt/$.locationSize*Zt)*_t,Tt)}else{if(j.isInstancedBufferAttribute){for(let At=0;At<$.locationSize;At++)g($.location+At,j.meshPerAttribute);D.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let At=0;At<$.locationSize;At++)p($.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<$.locationSize;At++)T($.location+At,dt/$.locationSize,vt,et,dt*_t,dt/$.locationSize*At*_t,Tt)}}else if(N!==void 0){let et=N[Z];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv($.location,et);break;case 3:n.vertexAttrib3fv($.location,et);break;case 4:n.vertexAttrib4fv($.location,et);break;default:n.vertexAttrib1fv($.location,et)}}}}x()}function A(){U();for(let D in i){let z=i[D];for(let W in z){let B=z[W];for(let X in B){let P=B[X];for(let N in P)u(P[N].object),delete P[N];delete B[X]}}delete i[D]}}function E(D){if(i[D.id]===void 0)return;let z=i[D.id];for(let W in z){let B=z[W];for(let X in B){let P=B[X];for(let N in P)u(P[N].object),delete P[N];delete B[X]}}delete i[D.id]}function _(D){for(let z in i){let W=i[z];for(let B in W){let X=W[B];if(X[D.id]===void 0)continue;let P=X[D.id];for(let N in P)u(P[N].object),delete P[N];delete X[D.id]}}}function S(D){for(let z in i){let W=i[z],B=D.isInstancedMesh===!0?D.id:0,X=W[B];if(X!==void 0){for(let P in X){let N=X[P];for(let Z in N)u(N[Z].object),delete N[Z];delete X[P]}delete W[B],Object.keys(W).length===0&&delete i[z]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:S,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function WA(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function $A(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Is&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let S=_===Ps&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==es&&_!==hs&&!S&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ne("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ne("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:x,maxVaryings:T,maxFragmentUniforms:b,maxSamples:A,samples:E}}function qA(n){let t=this,e=null,i=0,s=!1,r=!1,o=new si,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!p)r?u(null):c();else{let x=r?0:i,T=x*4,b=g.clippingState||null;l.value=b,b=u(m,d,T,f);for(let A=0;A!==T;++A)b[A]=e[A];g.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,m){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=l.value,m!==!0||p===null){let g=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<g)&&(p=new Float32Array(g));for(let T=0,b=f;T!==y;++T,b+=4)o.copy(h[T]).applyMatrix4(x,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var Bc=class extends Ki{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new gc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Oi(5,5,5),r=new Ri({name:"CubemapFromEquirect",uniforms:Oo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ci,blending:Do});r.uniforms.tEquirect.value=e;let o=new Ze(s,r),a=e.minFilter;return e.minFilter===Cr&&(e.minFilter=wi),new Va(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},sy=256,XA=3,YA=20,Ay=256,Ry=16,ZA=3,jA=new H,JA=new ee,Dd=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Va(1,10,null),this._boxMesh=new Ze(new Oi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=jA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(JA));let p=new Va(i,s,u);return p.position.copy(a),p.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ay(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=oy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(sy,Um(t))}_fromTexture(t,e){t.mapping===Uo||t.mapping===Xa?this._setSize(t.image.length===0?sy:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=ry(t,!1,!1),i=Math.log2(t)-XA;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ry(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Uo||t.mapping===Xa?(this._cubemapMaterial===null&&(this._cubemapMaterial=ay()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=oy()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=KA(),this._integrationMaterial=QA());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Ry);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-ZA)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Ay*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=tR());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function ry(n,t,e){return new Bc(n,{minFilter:Cr,generateMipmaps:t,type:Ps,colorSpace:ic,depthBuffer:e})}function kc(n,t,e){return new Ri({name:n,uniforms:t,vertexShader:Se.cube_vert,fragmentShader:e,side:Ci,blending:Do,depthTest:!1,depthWrite:!1})}function KA(){return kc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

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
	`)}function QA(){return kc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ry}},`

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
	`)}function tR(){return kc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${YA}
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
	`)}function oy(){return kc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function ay(){return kc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function eR(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Vh||f===Wh)if(t.has(d)){let m=t.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let y=new Bc(m.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===Vh||f===Wh,y=f===Uo||f===Xa;if(m||y){let p=e.get(d),g=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Dd(n)),p=m?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return m&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new Dd(n)),p=m?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function a(d,f){return f===Vh?d.mapping=Uo:f===Wh&&(d.mapping=Xa),d}function l(d){let f=0,m=6;for(let y=0;y<m;y++)d[y]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function nR(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Ql("WebGLRenderer: "+i+" extension not supported."),s}}}function iR(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(t.remove(y),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(m){let y=m.attributes;for(let p in y)t.update(y[p],n.ARRAY_BUFFER)}function h(m){let y=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,T=p.count>=65535?dc:hc,b=new T(Math.ceil(x/3)*6,1),A=b.array;if(y!==null){let _=y.array;g=y.version;for(let S=0,U=0;S<x;S+=3){let L=_[S+0],D=_[S+1],z=_[S+2];A[U++]=L,A[U++]=D,A[U++]=D,A[U++]=z,A[U++]=z,A[U++]=L}}else{g=p.version;for(let _=0,S=0;_<x;_+=3){let U=_+0,L=_+1,D=_+2;A[S++]=U,A[S++]=L,A[S++]=L,A[S++]=D,A[S++]=D,A[S++]=U}}b.version=g;let E=r.get(m);E&&t.remove(E),r.set(m,b)}function d(m){let y=r.get(m);if(y){let p=m.index;p!==null&&y.version<p.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function sR(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function rR(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function oR(n,t,e){let i=new WeakMap,s=new yn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let U=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],T=0;f===!0&&(T=1),m===!0&&(T=2),y===!0&&(T=3);let b=a.attributes.position.count*T,A=1;b>t.maxTextureSize&&(A=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let E=new Float32Array(b*A*4*h),_=new lc(E,b,A,h);_.type=hs,_.needsUpdate=!0;let S=T*4;for(let L=0;L<h;L++){let D=p[L],z=g[L],W=x[L],B=b*A*4*L;for(let X=0;X<D.count;X++){let P=X*S;f===!0&&(s.fromBufferAttribute(D,X),E[B+P+0]=s.x,E[B+P+1]=s.y,E[B+P+2]=s.z,E[B+P+3]=0),m===!0&&(s.fromBufferAttribute(z,X),E[B+P+4]=s.x,E[B+P+5]=s.y,E[B+P+6]=s.z,E[B+P+7]=0),y===!0&&(s.fromBufferAttribute(W,X),E[B+P+8]=s.x,E[B+P+9]=s.y,E[B+P+10]=s.z,E[B+P+11]=W.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new Xt(b,A)},i.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function aR(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var lR={[dm]:"LINEAR_TONE_MAPPING",[fm]:"REINHARD_TONE_MAPPING",[pm]:"CINEON_TONE_MAPPING",[mm]:"ACES_FILMIC_TONE_MAPPING",[xm]:"AGX_TONE_MAPPING",[_m]:"NEUTRAL_TONE_MAPPING",[gm]:"CUSTOM_TONE_MAPPING"};function cR(n,t,e,i,s,r){let o=new Ki(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Me;u.setAttribute("position",new Te([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Te([0,2,0,0,2,0],2));let h=new Rh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ze(u,h),f=new Hh(-1,1,1,-1,0,1),m=null,y=null,p=!1,g,x=null,T=[],b=!1;this.setSize=function(A,E){o.setSize(A,E),a!==null&&a.setSize(A,E),l!==null&&l.setSize(A,E);for(let _=0;_<T.length;_++){let S=T[_];S.setSize&&S.setSize(A,E)}},this.setEffects=function(A){T=A,b=T.length>0&&T[0].isRenderPass===!0;let E=o.width,_=o.height;T.length>0&&a===null&&(a=new Ki(E,_,{type:Ps,depthBuffer:!1,stencilBuffer:!1}),l=new Ki(E,_,{type:Ps,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&T.some(U=>U.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Rr(E,_),r===!0&&(c.format=Pr,c.type=Fo)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let U=0;U<T.length;U++){let L=T[U];L.setSize&&L.setSize(E,_),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(A,E){if(p||A.toneMapping===sr&&T.length===0)return!1;if(x=E,E!==null){let _=E.width,S=E.height;(o.width!==_||o.height!==S)&&this.setSize(_,S)}return b===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=sr,!0},this.hasRenderPass=function(){return b},this.end=function(A,E){A.toneMapping=g,p=!0;let _=o,S=a;for(let U=0;U<T.length;U++){let L=T[U];L.enabled!==!1&&(L.render(A,S,_,E),L.needsSwap!==!1&&(_=S,S=S===a?l:a))}if(m!==A.outputColorSpace||y!==A.toneMapping){m=A.outputColorSpace,y=A.toneMapping,h.defines={},Ie.getTransfer(m)===We&&(h.defines.SRGB_TRANSFER="");let U=lR[y];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(x),A.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Cy=new Ei,Py=new Rr(1,1),Iy=new _c(1),Ly=new lc,Dy=new Sh,Ny=new gc,ly=[],cy=[],uy=new Float32Array(16),hy=new Float32Array(9),dy=new Float32Array(4);function ja(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=ly[s];if(r===void 0&&(r=new Float32Array(s),ly[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Hn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Gn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Ud(n,t){let e=cy[t];e===void 0&&(e=new Int32Array(t),cy[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function uR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function hR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Hn(e,t))return;n.uniform2fv(this.addr,t),Gn(e,t)}}function dR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Hn(e,t))return;n.uniform3fv(this.addr,t),Gn(e,t)}}function fR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Hn(e,t))return;n.uniform4fv(this.addr,t),Gn(e,t)}}function pR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Hn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Gn(e,t)}else{if(Hn(e,i))return;dy.set(i),n.uniformMatrix2fv(this.addr,!1,dy),Gn(e,i)}}function mR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Hn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Gn(e,t)}else{if(Hn(e,i))return;hy.set(i),n.uniformMatrix3fv(this.addr,!1,hy),Gn(e,i)}}function gR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Hn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Gn(e,t)}else{if(Hn(e,i))return;uy.set(i),n.uniformMatrix4fv(this.addr,!1,uy),Gn(e,i)}}function xR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function _R(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Hn(e,t))return;n.uniform2iv(this.addr,t),Gn(e,t)}}function yR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Hn(e,t))return;n.uniform3iv(this.addr,t),Gn(e,t)}}function vR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Hn(e,t))return;n.uniform4iv(this.addr,t),Gn(e,t)}}function bR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function MR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Hn(e,t))return;n.uniform2uiv(this.addr,t),Gn(e,t)}}function SR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Hn(e,t))return;n.uniform3uiv(this.addr,t),Gn(e,t)}}function wR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Hn(e,t))return;n.uniform4uiv(this.addr,t),Gn(e,t)}}function Fd(n){return n.version===0&&(n.compareFunction=Im,n.needsUpdate=!0),n}function ER(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Fd(Py):r=Cy,e.setTexture2D(t||r,s)}function TR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Dy,s)}function AR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Fd(Iy):r=Ny,e.setTextureCube(t||r,s)}function RR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Ly,s)}function CR(n){switch(n){case 5126:return uR;case 35664:return hR;case 35665:return dR;case 35666:return fR;case 35674:return pR;case 35675:return mR;case 35676:return gR;case 5124:case 35670:return xR;case 35667:case 35671:return _R;case 35668:case 35672:return yR;case 35669:case 35673:return vR;case 5125:return bR;case 36294:return MR;case 36295:return SR;case 36296:return wR;case 35678:case 36198:case 36298:case 36306:case 35682:return ER;case 35679:case 36299:case 36307:return TR;case 35680:case 36300:case 36308:case 36293:return AR;case 36289:case 36303:case 36311:case 36292:return RR}}function PR(n,t){n.uniform1fv(this.addr,t)}function IR(n,t){let e=ja(t,this.size,2);n.uniform2fv(this.addr,e)}function LR(n,t){let e=ja(t,this.size,3);n.uniform3fv(this.addr,e)}function DR(n,t){let e=ja(t,this.size,4);n.uniform4fv(this.addr,e)}function NR(n,t){let e=ja(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function UR(n,t){let e=ja(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function FR(n,t){let e=ja(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function OR(n,t){n.uniform1iv(this.addr,t)}function BR(n,t){n.uniform2iv(this.addr,t)}function kR(n,t){n.uniform3iv(this.addr,t)}function zR(n,t){n.uniform4iv(this.addr,t)}function HR(n,t){n.uniform1uiv(this.addr,t)}function GR(n,t){n.uniform2uiv(this.addr,t)}function VR(n,t){n.uniform3uiv(this.addr,t)}function WR(n,t){n.uniform4uiv(this.addr,t)}function $R(n,t,e){let i=this.cache,s=t.length,r=Ud(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Fd(Py):o=Cy;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function qR(n,t,e){let i=this.cache,s=t.length,r=Ud(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Dy,r[o])}function XR(n,t,e){let i=this.cache,s=t.length,r=Ud(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Fd(Iy):o=Ny;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function YR(n,t,e){let i=this.cache,s=t.length,r=Ud(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Ly,r[o])}function ZR(n){switch(n){case 5126:return PR;case 35664:return IR;case 35665:return LR;case 35666:return DR;case 35674:return NR;case 35675:return UR;case 35676:return FR;case 5124:case 35670:return OR;case 35667:case 35671:return BR;case 35668:case 35672:return kR;case 35669:case 35673:return zR;case 5125:return HR;case 36294:return GR;case 36295:return VR;case 36296:return WR;case 35678:case 36198:case 36298:case 36306:case 35682:return $R;case 35679:case 36299:case 36307:return qR;case 35680:case 36300:case 36308:case 36293:return XR;case 36289:case 36303:case 36311:case 36292:return YR}}var Wm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=CR(e.type)}},$m=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=ZR(e.type)}},qm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Gm=/(\w+)(\])?(\[|\.)?/g;function fy(n,t){n.seq.push(t),n.map[t.id]=t}function jR(n,t,e){let i=n.name,s=i.length;for(Gm.lastIndex=0;;){let r=Gm.exec(i),o=Gm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){fy(e,c===void 0?new Wm(a,n,t):new $m(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new qm(a),fy(e,h)),e=h}}}var Za=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);jR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function py(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var JR=37297,KR=0;function QR(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var my=new ce;function tC(n){Ie._getMatrix(my,Ie.workingColorSpace,n);let t=`mat3( ${my.elements.map(e=>e.toFixed(4))} )`;switch(Ie.getTransfer(n)){case sc:return[t,"LinearTransferOETF"];case We:return[t,"sRGBTransferOETF"];default:return ne("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function gy(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+QR(n.getShaderSource(t),a)}else return r}function eC(n,t){let e=tC(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var nC={[dm]:"Linear",[fm]:"Reinhard",[pm]:"Cineon",[mm]:"ACESFilmic",[xm]:"AgX",[_m]:"Neutral",[gm]:"Custom"};function iC(n,t){let e=nC[t];return e===void 0?(ne("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ld=new H;function sC(){Ie.getLuminanceCoefficients(Ld);let n=Ld.x.toFixed(4),t=Ld.y.toFixed(4),e=Ld.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function rC(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Oc).join(`
`)}function oC(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function aC(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Oc(n){return n!==""}function xy(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function _y(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var lC=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xm(n){return n.replace(lC,cC)}function cC(n,t){let e=Se[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Xm(e)}var uC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function yy(n){return n.replace(uC,hC)}function hC(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vy(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var dC={[Rc]:"SHADOWMAP_TYPE_PCF",[$a]:"SHADOWMAP_TYPE_VSM"};function fC(n){return dC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var pC={[Xa]:"ENVMAP_MODE_REFRACTION"};function mC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":pC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var gC={[hm]:"ENVMAP_BLENDING_MULTIPLY",[B_]:"ENVMAP_BLENDING_MIX",[k_]:"ENVMAP_BLENDING_ADD"};function xC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":gC[n.combine]||"ENVMAP_BLENDING_NONE"}function _C(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=fC(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=mC(e),h=xC(e),d=rC(e),f=oC(r),m=s.createProgram(),y,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Oc).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Oc).join(`
`),p.length>0&&(p+=`
`)):(y=[vy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Oc).join(`
`),p=[vy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==sr?"#define TONE_MAPPING":"",e.toneMapping!==sr?Se.tonemapping_pars_fragment:"",e.toneMapping!==sr?iC("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Se.colorspace_pars_fragment,eC("linearToOutputTexel",e.outputColorSpace),sC(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Oc).join(`
`)),o=Xm(o),o=xy(o,e),o=_y(o,e),a=Xm(a),a=xy(a,e),a=_y(a,e),o=yy(o),a=yy(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===Dm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Dm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=g+y+o,T=g+p+a,b=py(s,s.VERTEX_SHADER,x),A=py(s,s.FRAGMENT_SHADER,T);s.attachShader(m,b),s.attachShader(m,A),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function E(L){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(m)||"",z=s.getShaderInfoLog(b)||"",W=s.getShaderInfoLog(A)||"",B=D.trim(),X=z.trim(),P=W.trim(),N=!0,Z=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(N=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,b,A);else{let $=gy(s,b,"vertex"),j=gy(s,A,"fragment");re("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+B+`
`+$+`
`+j)}else B!==""?ne("WebGLProgram: Program Info Log:",B):(X===""||P==="")&&(Z=!1);Z&&(L.diagnostics={runnable:N,programLog:B,vertexShader:{log:X,prefix:y},fragmentShader:{log:P,prefix:p}})}s.deleteShader(b),s.deleteShader(A),_=new Za(s,m),S=aC(s,m)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let S;this.getAttributes=function(){return S===void 0&&E(this),S};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(m,JR)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=KR++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=A,this}var yC=0,Ym=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Zm(t),e.set(t,i)),i}},Zm=class{constructor(t){this.id=yC++,this.code=t,this.usedTimes=0}};function vC(n){return n===ro||n===Nc||n===Uc}function bC(n,t,e,i,s,r){let o=new Ba,a=new Ym,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,S,U,L,D,z){let W=L.fog,B=D.geometry,X=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,P=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,N=t.get(_.envMap||X,P),Z=d[_.type],$=i.precision;_.precision!==null&&($=i.getMaxPrecision(_.precision),$!==_.precision&&ne("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let j=B.morphAttributes.position||B.morphAttributes.normal||B.morphAttributes.color,et=j!==void 0?j.length:0,dt=0;B.morphAttributes.position!==void 0&&(dt=1),B.morphAttributes.normal!==void 0&&(dt=2),B.morphAttributes.color!==void 0&&(dt=3);let ft,st,vt,_t;if(Z){let Dt=or[Z];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=_.vertexShader,st=_.fragmentShader;let Dt=a.getVertexShaderStage(_),xe=a.getFragmentShaderStage(_);a.update(_,Dt,xe),vt=Dt.id,_t=xe.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=D.isInstancedMesh===!0,pe=D.isBatchedMesh===!0,Zt=!!_.map,we=!!_.matcap,ye=!!N,de=ye&&N.isPMREMTexture===!0,pn=!!_.aoMap,sn=!!_.lightMap,Pn=!!_.bumpMap&&_.wireframe===!1,Je=!!_.normalMap,Yn=!!_.displacementMap,De=!!_.emissiveMap,Bn=!!_.metalnessMap,bn=!!_.roughnessMap,In=_.anisotropy>0,V=_.clearcoat>0,Nt=_.diffuseRoughness>0,ie=_.dispersion>0,me=_.retroreflectivity>0,Ct=_.iridescence>0,Qe=_.sheen>0,Yt=_.transmission>0,te=In&&!!_.anisotropyMap,F=V&&!!_.clearcoatMap,R=V&&!!_.clearcoatNormalMap,J=V&&!!_.clearcoatRoughnessMap,mt=Nt&&!!_.diffuseRoughnessMap,ct=Ct&&!!_.iridescenceMap,St=Ct&&!!_.iridescenceThicknessMap,wt=Qe&&!!_.sheenColorMap,rt=Qe&&!!_.sheenRoughnessMap,at=!!_.specularMap,bt=!!_.specularColorMap,G=!!_.specularIntensityMap,lt=Yt&&!!_.transmissionMap,ot=Yt&&!!_.thicknessMap,Pt=!!_.gradientMap,Mt=!!_.alphaMap,Rt=_.alphaTest>0,jt=!!_.alphaHash,oe=!!_.extensions,pt=sr;_.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let Wt=de?N.isCompressedCubeTexture?N.image[0].mipmaps:N.mipmaps:null,ae={shaderID:Z,shaderType:_.type,shaderName:_.name,vertexShader:ft,fragmentShader:st,defines:_.defines,customVertexShaderID:vt,customFragmentShaderID:_t,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:pe,batchingColor:pe&&D._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&D.instanceColor!==null,instancingMorph:Jt&&D.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:Ie.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Zt,matcap:we,envMap:ye,envMapMode:ye&&N.mapping,envMapPMREM:de,envMapMaxLod:de?Wt.length-1:null,envMapSize:de?Wt[0].width:null,aoMap:pn,lightMap:sn,bumpMap:Pn,normalMap:Je,displacementMap:Yn,emissiveMap:De,normalMapObjectSpace:Je&&_.normalMapType===G_,normalMapTangentSpace:Je&&_.normalMapType===Tm,packedNormalMap:Je&&_.normalMapType===Tm&&vC(_.normalMap.format),metalnessMap:Bn,roughnessMap:bn,anisotropy:In,anisotropyMap:te,clearcoat:V,clearcoatMap:F,clearcoatNormalMap:R,clearcoatRoughnessMap:J,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:ie,retroreflection:me,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:St,sheen:Qe,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:bt,specularIntensityMap:G,transmission:Yt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:_.transparent===!1&&_.blending===qa&&_.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:jt,combine:_.combine,mapUv:Zt&&f(_.map.channel),aoMapUv:pn&&f(_.aoMap.channel),lightMapUv:sn&&f(_.lightMap.channel),bumpMapUv:Pn&&f(_.bumpMap.channel),normalMapUv:Je&&f(_.normalMap.channel),displacementMapUv:Yn&&f(_.displacementMap.channel),emissiveMapUv:De&&f(_.emissiveMap.channel),metalnessMapUv:Bn&&f(_.metalnessMap.channel),roughnessMapUv:bn&&f(_.roughnessMap.channel),anisotropyMapUv:te&&f(_.anisotropyMap.channel),clearcoatMapUv:F&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(_.sheenRoughnessMap.channel),specularMapUv:at&&f(_.specularMap.channel),specularColorMapUv:bt&&f(_.specularColorMap.channel),specularIntensityMapUv:G&&f(_.specularIntensityMap.channel),transmissionMapUv:lt&&f(_.transmissionMap.channel),thicknessMapUv:ot&&f(_.thicknessMap.channel),alphaMapUv:Mt&&f(_.alphaMap.channel),vertexTangents:!!B.attributes.tangent&&(Je||In),vertexNormals:!!B.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!B.attributes.color&&B.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!B.attributes.uv&&(Zt||Mt),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||B.attributes.normal===void 0&&Je===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:B.attributes.position!==void 0,morphTargets:B.morphAttributes.position!==void 0,morphNormals:B.morphAttributes.normal!==void 0,morphColors:B.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:z.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:Zt&&_.map.isVideoTexture===!0&&Ie.getTransfer(_.map.colorSpace)===We,decodeVideoTextureEmissive:De&&_.emissiveMap.isVideoTexture===!0&&Ie.getTransfer(_.emissiveMap.colorSpace)===We,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===di,flipSided:_.side===Ci,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:oe&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(oe&&_.extensions.multiDraw===!0||pe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ae.vertexUv1s=l.has(1),ae.vertexUv2s=l.has(2),ae.vertexUv3s=l.has(3),l.clear(),ae}function y(_){let S=[];if(_.shaderID?S.push(_.shaderID):(S.push(_.customVertexShaderID),S.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)S.push(U),S.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(p(S,_),g(S,_),S.push(n.outputColorSpace)),S.push(_.customProgramCacheKey),S.join()}function p(_,S){_.push(S.precision),_.push(S.outputColorSpace),_.push(S.envMapMode),_.push(S.envMapPMREM),_.push(S.envMapMaxLod),_.push(S.envMapSize),_.push(S.mapUv),_.push(S.alphaMapUv),_.push(S.lightMapUv),_.push(S.aoMapUv),_.push(S.bumpMapUv),_.push(S.normalMapUv),_.push(S.displacementMapUv),_.push(S.emissiveMapUv),_.push(S.metalnessMapUv),_.push(S.roughnessMapUv),_.push(S.anisotropyMapUv),_.push(S.clearcoatMapUv),_.push(S.clearcoatNormalMapUv),_.push(S.clearcoatRoughnessMapUv),_.push(S.diffuseRoughnessMapUv),_.push(S.iridescenceMapUv),_.push(S.iridescenceThicknessMapUv),_.push(S.sheenColorMapUv),_.push(S.sheenRoughnessMapUv),_.push(S.specularMapUv),_.push(S.specularColorMapUv),_.push(S.specularIntensityMapUv),_.push(S.transmissionMapUv),_.push(S.thicknessMapUv),_.push(S.combine),_.push(S.fogExp2),_.push(S.sizeAttenuation),_.push(S.morphTargetsCount),_.push(S.numSunLights),_.push(S.numDirLights),_.push(S.numPointLights),_.push(S.numSpotLights),_.push(S.numSpotLightMaps),_.push(S.numHemiLights),_.push(S.numRectAreaLights),_.push(S.numSunLightShadows),_.push(S.numDirLightShadows),_.push(S.numPointLightShadows),_.push(S.numSpotLightShadows),_.push(S.numSpotLightShadowsWithMaps),_.push(S.numLightProbes),_.push(S.numLightProbeGrids),_.push(S.shadowMapType),_.push(S.toneMapping),_.push(S.numClippingPlanes),_.push(S.numClipIntersection),_.push(S.depthPacking)}function g(_,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let S=d[_.type],U;if(S){let L=or[S];U=ey.clone(L.uniforms)}else U=_.uniforms;return U}function T(_,S){let U=u.get(S);return U!==void 0?++U.usedTimes:(U=new _C(n,S,_,s),c.push(U),u.set(S,U)),U}function b(_){if(--_.usedTimes===0){let S=c.indexOf(_);c[S]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function E(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:x,acquireProgram:T,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:E}}function MC(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function SC(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function by(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function My(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,y,p,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=m,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=p,x.group=g),t++,x}function l(d,f,m,y,p,g,x){x.reversedDepth===!0&&(p=-p);let T=a(d,f,m,y,p,g);m.transmission>0?i.push(T):m.transparent===!0?s.push(T):e.push(T)}function c(d,f,m,y,p,g){let x=a(d,f,m,y,p,g);m.transmission>0?i.unshift(x):m.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||SC),i.length>1&&i.sort(f||by),s.length>1&&s.sort(f||by)}function h(){for(let d=t,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function wC(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new My,n.set(i,[o])):s>=r.length?(o=new My,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function EC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new H,color:new ee};break;case"SpotLight":e={position:new H,direction:new H,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new H,halfWidth:new H,halfHeight:new H};break}return n[t.id]=e,e}}}function TC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var AC=0;function RC(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function CC(n){let t=new EC,e=TC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new H);let s=new H,r=new ge,o=new ge;function a(c){let u=0,h=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,m=0,y=0,p=0,g=0,x=0,T=0,b=0,A=0,E=0,_=0,S=0,U=0,L=0;c.sort(RC);for(let z=0,W=c.length;z<W;z++){let B=c[z],X=B.color,P=B.intensity,N=B.distance,Z=null;if(B.shadow&&B.shadow.map&&(B.shadow.map.texture.format===ro?Z=B.shadow.map.texture:Z=B.shadow.map.depthTexture||B.shadow.map.texture),B.isAmbientLight)u+=X.r*P,h+=X.g*P,d+=X.b*P;else if(B.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(B.sh.coefficients[$],P);L++}else if(B.isSunLight){let $=t.get(B);if($.color.copy(B.color).multiplyScalar(B.intensity),B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[m]=et,i.sunShadowMap[m]=Z;let dt=j.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[y+ft]=j.getMatrix(ft),i.sunShadowCascade[y+ft]=j._cascadeData[ft];y+=dt,m++}i.sun[f]=$,f++}else if(B.isDirectionalLight){let $=t.get(B);if($.color.copy(B.color).multiplyScalar(B.intensity),B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.directionalShadow[p]=et,i.directionalShadowMap[p]=Z,i.directionalShadowMatrix[p]=B.shadow.matrix,A++}i.directional[p]=$,p++}else if(B.isSpotLight){let $=t.get(B);$.position.setFromMatrixPosition(B.matrixWorld),$.color.copy(X).multiplyScalar(P),$.distance=N,$.coneCos=Math.cos(B.angle),$.penumbraCos=Math.cos(B.angle*(1-B.penumbra)),$.decay=B.decay,i.spot[x]=$;let j=B.shadow;if(B.map&&(i.spotLightMap[S]=B.map,S++,j.updateMatrices(B),B.castShadow&&U++),i.spotLightMatrix[x]=j.matrix,B.castShadow){let et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=Z,_++}x++}else if(B.isRectAreaLight){let $=t.get(B);$.color.copy(X).multiplyScalar(P),$.halfWidth.set(B.width*.5,0,0),$.halfHeight.set(0,B.height*.5,0),i.rectArea[T]=$,T++}else if(B.isPointLight){let $=t.get(B);if($.color.copy(B.color).multiplyScalar(B.intensity),$.distance=B.distance,$.decay=B.decay,B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=Z,i.pointShadowMatrix[g]=B.shadow.matrix,E++}i.point[g]=$,g++}else if(B.isHemisphereLight){let $=t.get(B);$.skyColor.copy(B.color).multiplyScalar(P),$.groundColor.copy(B.groundColor).multiplyScalar(P),i.hemi[b]=$,b++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ot.LTC_FLOAT_1,i.rectAreaLTC2=Ot.LTC_FLOAT_2):(i.rectAreaLTC1=Ot.LTC_HALF_1,i.rectAreaLTC2=Ot.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==g||D.spotLength!==x||D.rectAreaLength!==T||D.hemiLength!==b||D.numSunShadows!==m||D.numDirectionalShadows!==A||D.numPointShadows!==E||D.numSpotShadows!==_||D.numSpotMaps!==S||D.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=p,i.spot.length=x,i.rectArea.length=T,i.point.length=g,i.hemi.length=b,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+S-U,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,D.sunLength=f,D.directionalLength=p,D.pointLength=g,D.spotLength=x,D.rectAreaLength=T,D.hemiLength=b,D.numSunShadows=m,D.numDirectionalShadows=A,D.numPointShadows=E,D.numSpotShadows=_,D.numSpotMaps=S,D.numLightProbes=L,i.version=AC++)}function l(c,u){let h=0,d=0,f=0,m=0,y=0,p=0,g=u.matrixWorldInverse;for(let x=0,T=c.length;x<T;x++){let b=c[x];if(b.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(b.isSpotLight){let A=i.spot[m];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),m++}else if(b.isRectAreaLight){let A=i.rectArea[y];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let A=i.hemi[p];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:i}}function Sy(n){let t=new CC(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function PC(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Sy(n),t.set(s,[a])):r>=o.length?(a=new Sy(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var IC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,LC=`uniform sampler2D shadow_pass;
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
}`,DC=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],NC=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],wy=new ge,Fc=new H,Vm=new H;function UC(n,t,e){let i=new Co,s=new Xt,r=new Xt,o=new yn,a=new Ch,l=new Ph,c={},u=e.maxTextureSize,h={[ir]:Ci,[Ci]:ir,[di]:di},d=new Ri({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xt},radius:{value:4}},vertexShader:IC,fragmentShader:LC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Me;m.setAttribute("position",new Be(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ze(m,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Rc;let g=this.type;this.render=function(E,_,S){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===y_&&(ne("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Rc);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Do),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let W=g!==this.type;W&&_.traverse(function(B){B.material&&(Array.isArray(B.material)?B.material.forEach(X=>X.needsUpdate=!0):B.material.needsUpdate=!0)});for(let B=0,X=E.length;B<X;B++){let P=E[B],N=P.shadow;if(N===void 0){ne("WebGLShadowMap:",P,"has no shadow.");continue}if(N.autoUpdate===!1&&N.needsUpdate===!1)continue;s.copy(N.mapSize);let Z=N.getFrameExtents();s.multiply(Z),r.copy(N.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Z.x),s.x=r.x*Z.x,N.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Z.y),s.y=r.y*Z.y,N.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(N.camera._reversedDepth=$,N.map===null||W===!0){if(N.map!==null&&(N.map.depthTexture!==null&&(N.map.depthTexture.dispose(),N.map.depthTexture=null),N.map.dispose()),this.type===$a){if(P.isPointLight){ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}N.map=new Ki(s.x,s.y,{format:ro,type:Ps,minFilter:wi,magFilter:wi,generateMipmaps:!1}),N.map.texture.name=P.name+".shadowMap",N.map.depthTexture=new Rr(s.x,s.y,hs),N.map.depthTexture.name=P.name+".shadowMapDepth",N.map.depthTexture.format=Er,N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=ti,N.map.depthTexture.magFilter=ti}else P.isPointLight?(N.map=new Bc(s.x),N.map.depthTexture=new _c(s.x,Cs)):(N.map=new Ki(s.x,s.y),N.map.depthTexture=new Rr(s.x,s.y,Cs)),N.map.depthTexture.name=P.name+".shadowMap",N.map.depthTexture.format=Er,this.type===Rc?(N.map.depthTexture.compareFunction=$?Pm:Cm,N.map.depthTexture.minFilter=wi,N.map.depthTexture.magFilter=wi):(N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=ti,N.map.depthTexture.magFilter=ti);N.camera.updateProjectionMatrix()}N.map.isWebGLCubeRenderTarget!==!0&&(N.map.width!==s.x||N.map.height!==s.y)&&N.map.setSize(s.x,s.y);let j=N.map.isWebGLCubeRenderTarget?6:N.getViewportCount();P.isPointLight!==!0&&N.updateMatrices(P,S);let et=(N.camera.layers.mask&4294967294)!==0?N.camera.layers:S.layers;for(let dt=0;dt<j;dt++){let ft=N.getCamera(dt);if(P.isPointLight){let st=N.camera,vt=N.matrix,_t=P.distance||st.far;_t!==st.far&&(st.far=_t,st.updateProjectionMatrix()),Fc.setFromMatrixPosition(P.matrixWorld),st.position.copy(Fc),Vm.copy(st.position),Vm.add(DC[dt]),st.up.copy(NC[dt]),st.lookAt(Vm),st.updateMatrixWorld(),vt.makeTranslation(-Fc.x,-Fc.y,-Fc.z),wy.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),N._frustum.setFromProjectionMatrix(wy,st.coordinateSystem,st.reversedDepth)}if(N.map.isWebGLCubeRenderTarget)n.setRenderTarget(N.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(N.map),n.clear());let st=N.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),z.viewport(o)}i=N.getFrustum(dt),b(_,S,ft,P,et,this.type)}N.isPointLightShadow!==!0&&this.type===$a&&x(N,S),N.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(U,L,D)};function x(E,_){let S=t.update(y);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new Ki(s.x,s.y,{format:ro,type:Ps}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,S,d,y,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,S,f,y,null)}function T(E,_,S,U){let L=null,D=S.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)L=D;else if(L=S.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let z=L.uuid,W=_.uuid,B=c[z];B===void 0&&(B={},c[z]=B);let X=B[W];X===void 0&&(X=L.clone(),B[W]=X,_.addEventListener("dispose",A)),L=X}if(L.visible=_.visible,L.wireframe=_.wireframe,U===$a?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:h[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let z=n.properties.get(L);z.light=S}return L}function b(E,_,S,U,L,D){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===$a)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,E.matrixWorld);let B=t.update(E),X=E.material;if(Array.isArray(X)){let P=B.groups;for(let N=0,Z=P.length;N<Z;N++){let $=P[N],j=X[$.materialIndex];if(j&&j.visible){let et=T(E,j,U,D);E.onBeforeShadow(n,E,_,S,B,et,$),n.renderBufferDirect(S,null,B,et,E,$),E.onAfterShadow(n,E,_,S,B,et,$)}}}else if(X.visible){let P=T(E,X,U,D);E.onBeforeShadow(n,E,_,S,B,P,null),n.renderBufferDirect(S,null,B,P,E,null),E.onAfterShadow(n,E,_,S,B,P,null)}}let W=E.children;for(let B=0,X=W.length;B<X;B++)b(W[B],_,S,U,L,D)}function A(E){E.target.removeEventListener("dispose",A);for(let S in c){let U=c[S],L=E.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function FC(n,t){function e(){let G=!1,lt=new yn,ot=null,Pt=new yn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!G&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){G=Mt},setClear:function(Mt,Rt,jt,oe,pt){pt===!0&&(Mt*=oe,Rt*=oe,jt*=oe),lt.set(Mt,Rt,jt,oe),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,jt,oe),Pt.copy(lt))},reset:function(){G=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let G=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let jt=t.get("EXT_clip_control");Rt?jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.ZERO_TO_ONE_EXT):jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let oe=Mt;Mt=null,this.setClear(oe)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!G&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=K_[Rt]),Pt!==Rt){switch(Rt){case hh:n.depthFunc(n.NEVER);break;case dh:n.depthFunc(n.ALWAYS);break;case fh:n.depthFunc(n.LESS);break;case Na:n.depthFunc(n.LEQUAL);break;case ph:n.depthFunc(n.EQUAL);break;case mh:n.depthFunc(n.GEQUAL);break;case gh:n.depthFunc(n.GREATER);break;case xh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){G=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){G=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let G=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,jt=null,oe=null,pt=null;return{setTest:function(Wt){G||(Wt?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function(Wt){lt!==Wt&&!G&&(n.stencilMask(Wt),lt=Wt)},setFunc:function(Wt,ae,Dt){(ot!==Wt||Pt!==ae||Mt!==Dt)&&(n.stencilFunc(Wt,ae,Dt),ot=Wt,Pt=ae,Mt=Dt)},setOp:function(Wt,ae,Dt){(Rt!==Wt||jt!==ae||oe!==Dt)&&(n.stencilOp(Wt,ae,Dt),Rt=Wt,jt=ae,oe=Dt)},setLocked:function(Wt){G=Wt},setClear:function(Wt){pt!==Wt&&(n.clearStencil(Wt),pt=Wt)},reset:function(){G=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,jt=null,oe=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],y=null,p=!1,g=null,x=null,T=null,b=null,A=null,E=null,_=null,S=new ee(0,0,0),U=0,L=!1,D=null,z=null,W=null,B=null,X=null,P=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,Z=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec($)[1]),N=Z>=1):$.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),N=Z>=2);let j=null,et={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new yn().fromArray(dt),vt=new yn().fromArray(ft);function _t(G,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(G,Rt),n.texParameteri(G,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(G,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let jt=0;jt<ot;jt++)G===n.TEXTURE_3D||G===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+jt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=_t(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=_t(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=_t(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=_t(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(Na),Pn(!1),Je(rm),At(n.CULL_FACE),pn(Do);function At(G){u[G]!==!0&&(n.enable(G),u[G]=!0)}function Jt(G){u[G]!==!1&&(n.disable(G),u[G]=!1)}function pe(G,lt){return d[G]!==lt?(n.bindFramebuffer(G,lt),d[G]=lt,G===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),G===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function Zt(G,lt){let ot=m,Pt=!1;if(G){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=G.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,jt=Mt.length;Rt<jt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function we(G){return y!==G?(n.useProgram(G),y=G,!0):!1}let ye={[No]:n.FUNC_ADD,[b_]:n.FUNC_SUBTRACT,[M_]:n.FUNC_REVERSE_SUBTRACT};ye[S_]=n.MIN,ye[w_]=n.MAX;let de={[E_]:n.ZERO,[T_]:n.ONE,[A_]:n.SRC_COLOR,[cm]:n.SRC_ALPHA,[D_]:n.SRC_ALPHA_SATURATE,[I_]:n.DST_COLOR,[C_]:n.DST_ALPHA,[R_]:n.ONE_MINUS_SRC_COLOR,[um]:n.ONE_MINUS_SRC_ALPHA,[L_]:n.ONE_MINUS_DST_COLOR,[P_]:n.ONE_MINUS_DST_ALPHA,[N_]:n.CONSTANT_COLOR,[U_]:n.ONE_MINUS_CONSTANT_COLOR,[F_]:n.CONSTANT_ALPHA,[O_]:n.ONE_MINUS_CONSTANT_ALPHA};function pn(G,lt,ot,Pt,Mt,Rt,jt,oe,pt,Wt){if(G===Do){p===!0&&(Jt(n.BLEND),p=!1);return}if(p===!1&&(At(n.BLEND),p=!0),G!==v_){if(G!==g||Wt!==L){if((x!==No||A!==No)&&(n.blendEquation(n.FUNC_ADD),x=No,A=No),Wt)switch(G){case qa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case om:n.blendFunc(n.ONE,n.ONE);break;case am:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case lm:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:re("WebGLState: Invalid blending: ",G);break}else switch(G){case qa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case om:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case am:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case lm:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",G);break}T=null,b=null,E=null,_=null,S.set(0,0,0),U=0,g=G,L=Wt}return}Mt=Mt||lt,Rt=Rt||ot,jt=jt||Pt,(lt!==x||Mt!==A)&&(n.blendEquationSeparate(ye[lt],ye[Mt]),x=lt,A=Mt),(ot!==T||Pt!==b||Rt!==E||jt!==_)&&(n.blendFuncSeparate(de[ot],de[Pt],de[Rt],de[jt]),T=ot,b=Pt,E=Rt,_=jt),(oe.equals(S)===!1||pt!==U)&&(n.blendColor(oe.r,oe.g,oe.b,pt),S.copy(oe),U=pt),g=G,L=!1}function sn(G,lt){G.side===di?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=G.side===Ci;lt&&(ot=!ot),Pn(ot),G.blending===qa&&G.transparent===!1?pn(Do):pn(G.blending,G.blendEquation,G.blendSrc,G.blendDst,G.blendEquationAlpha,G.blendSrcAlpha,G.blendDstAlpha,G.blendColor,G.blendAlpha,G.premultipliedAlpha),o.setFunc(G.depthFunc),o.setTest(G.depthTest),o.setMask(G.depthWrite),r.setMask(G.colorWrite);let Pt=G.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(G.stencilWriteMask),a.setFunc(G.stencilFunc,G.stencilRef,G.stencilFuncMask),a.setOp(G.stencilFail,G.stencilZFail,G.stencilZPass)),De(G.polygonOffset,G.polygonOffsetFactor,G.polygonOffsetUnits),G.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Pn(G){D!==G&&(G?n.frontFace(n.CW):n.frontFace(n.CCW),D=G)}function Je(G){G!==x_?(At(n.CULL_FACE),G!==z&&(G===rm?n.cullFace(n.BACK):G===__?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),z=G}function Yn(G){G!==W&&(N&&n.lineWidth(G),W=G)}function De(G,lt,ot){G?(At(n.POLYGON_OFFSET_FILL),(B!==lt||X!==ot)&&(B=lt,X=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Jt(n.POLYGON_OFFSET_FILL)}function Bn(G){G?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function bn(G){G===void 0&&(G=n.TEXTURE0+P-1),j!==G&&(n.activeTexture(G),j=G)}function In(G,lt,ot){ot===void 0&&(j===null?ot=n.TEXTURE0+P-1:ot=j);let Pt=et[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},et[ot]=Pt),(Pt.type!==G||Pt.texture!==lt)&&(j!==ot&&(n.activeTexture(ot),j=ot),n.bindTexture(G,lt||Tt[G]),Pt.type=G,Pt.texture=lt)}function V(){let G=et[j];G!==void 0&&G.type!==void 0&&(n.bindTexture(G.type,null),G.type=void 0,G.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function ie(){try{n.compressedTexImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function me(){try{n.texSubImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function Qe(){try{n.compressedTexSubImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function te(){try{n.texStorage2D(...arguments)}catch(G){re("WebGLState:",G)}}function F(){try{n.texStorage3D(...arguments)}catch(G){re("WebGLState:",G)}}function R(){try{n.texImage2D(...arguments)}catch(G){re("WebGLState:",G)}}function J(){try{n.texImage3D(...arguments)}catch(G){re("WebGLState:",G)}}function mt(G){return h[G]!==void 0?h[G]:n.getParameter(G)}function ct(G,lt){h[G]!==lt&&(n.pixelStorei(G,lt),h[G]=lt)}function St(G){st.equals(G)===!1&&(n.scissor(G.x,G.y,G.z,G.w),st.copy(G))}function wt(G){vt.equals(G)===!1&&(n.viewport(G.x,G.y,G.z,G.w),vt.copy(G))}function rt(G,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Pt=ot.get(G);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,G.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(G,Pt))}function at(G,lt,ot){let Mt=c.get(lt).get(G);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function bt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,et={},d={},l={},f=new WeakMap,m=[],y=null,p=!1,g=null,x=null,T=null,b=null,A=null,E=null,_=null,S=new ee(0,0,0),U=0,L=!1,D=null,z=null,W=null,B=null,X=null,st.set(0,0,n.canvas.width,n.canvas.height),vt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:pe,drawBuffers:Zt,useProgram:we,setBlending:pn,setMaterial:sn,setFlipSided:Pn,setCullFace:Je,setLineWidth:Yn,setPolygonOffset:De,setScissorTest:Bn,activeTexture:bn,bindTexture:In,unbindTexture:V,compressedTexImage2D:Nt,compressedTexImage3D:ie,texImage2D:R,texImage3D:J,pixelStorei:ct,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:te,texStorage3D:F,texSubImage2D:me,texSubImage3D:Ct,compressedTexSubImage2D:Qe,compressedTexSubImage3D:Yt,scissor:St,viewport:wt,reset:bt}}function OC(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xt,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,y=new FinalizationRegistry(F=>m.delete(F)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(F,R){return p?new OffscreenCanvas(F,R):oc("canvas")}function x(F,R,J){let mt=1,ct=te(F);if((ct.width>J||ct.height>J)&&(mt=J/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&F instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&F instanceof ImageBitmap||typeof VideoFrame<"u"&&F instanceof VideoFrame){let St=Math.floor(mt*ct.width),wt=Math.floor(mt*ct.height);d===void 0&&(d=g(St,wt));let rt=R?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(F,0,0,St,wt),ne("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+St+"x"+wt+")."),rt}else return"data"in F&&ne("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),F;return F}function T(F){return F.generateMipmaps}function b(F){n.generateMipmap(F)}function A(F){return F.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:F.isWebGL3DRenderTarget?n.TEXTURE_3D:F.isWebGLArrayRenderTarget||F.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(F,R,J,mt,ct,St=!1){if(F!==null){if(n[F]!==void 0)return n[F];ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+F+"'")}let wt;mt&&(wt=t.get("EXT_texture_norm16"),wt||ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(J===n.FLOAT&&(rt=n.R32F),J===n.HALF_FLOAT&&(rt=n.R16F),J===n.UNSIGNED_BYTE&&(rt=n.R8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),J===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.R8UI),J===n.UNSIGNED_SHORT&&(rt=n.R16UI),J===n.UNSIGNED_INT&&(rt=n.R32UI),J===n.BYTE&&(rt=n.R8I),J===n.SHORT&&(rt=n.R16I),J===n.INT&&(rt=n.R32I)),R===n.RG&&(J===n.FLOAT&&(rt=n.RG32F),J===n.HALF_FLOAT&&(rt=n.RG16F),J===n.UNSIGNED_BYTE&&(rt=n.RG8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),J===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RG8UI),J===n.UNSIGNED_SHORT&&(rt=n.RG16UI),J===n.UNSIGNED_INT&&(rt=n.RG32UI),J===n.BYTE&&(rt=n.RG8I),J===n.SHORT&&(rt=n.RG16I),J===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),J===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),J===n.UNSIGNED_INT&&(rt=n.RGB32UI),J===n.BYTE&&(rt=n.RGB8I),J===n.SHORT&&(rt=n.RGB16I),J===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),J===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),J===n.UNSIGNED_INT&&(rt=n.RGBA32UI),J===n.BYTE&&(rt=n.RGBA8I),J===n.SHORT&&(rt=n.RGBA16I),J===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),J===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),J===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),J===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=St?sc:Ie.getTransfer(ct);J===n.FLOAT&&(rt=n.RGBA32F),J===n.HALF_FLOAT&&(rt=n.RGBA16F),J===n.UNSIGNED_BYTE&&(rt=at===We?n.SRGB8_ALPHA8:n.RGBA8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),J===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),J===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),J===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function _(F,R){let J;return F?R===null||R===Cs||R===Fo?J=n.DEPTH24_STENCIL8:R===hs?J=n.DEPTH32F_STENCIL8:R===Ya&&(J=n.DEPTH24_STENCIL8,ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Cs||R===Fo?J=n.DEPTH_COMPONENT24:R===hs?J=n.DEPTH_COMPONENT32F:R===Ya&&(J=n.DEPTH_COMPONENT16),J}function S(F,R){return T(F)===!0||F.isFramebufferTexture&&F.minFilter!==ti&&F.minFilter!==wi?Math.log2(Math.max(R.width,R.height))+1:F.mipmaps.length>0?F.mipmaps.length:F.isCompressedTexture&&Array.isArray(F.image)?R.mipmaps.length:1}function U(F){let R=new WeakRef(F);i.get(F).__ref=R,m.add(R),y.register(F,R,R)}function L(F){let R=i.get(F).__ref;R!==void 0&&(m.delete(R),y.unregister(R))}function D(F){W(F.target)}function z(F){B(F.target)}function W(F){F.removeEventListener("dispose",D),L(F),P(F),F.isVideoTexture&&u.delete(F),F.isHTMLTexture&&h.delete(F)}function B(F){F.removeEventListener("dispose",z),L(F),Z(F)}function X(){for(let F of m){let R=F.deref();R!==void 0&&(R.isRenderTarget===!0?B(R):W(R))}m.clear(),h.clear()}function P(F){let R=i.get(F);if(R.__webglInit===void 0)return;let J=F.source,mt=f.get(J);if(mt){let ct=mt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&N(F),Object.keys(mt).length===0&&f.delete(J)}i.remove(F)}function N(F){let R=i.get(F);n.deleteTexture(R.__webglTexture);let J=F.source,mt=f.get(J);delete mt[R.__cacheKey],o.memory.textures--}function Z(F){let R=i.get(F);R.__depthDisposeCallback&&R.__depthDisposeCallback();let J=F.depthTexture;if(J&&J.renderTarget===F&&W(J),F.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let St=0;St<R.__webglFramebuffer[ct].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[ct][St]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=F.textures;for(let ct=0,St=mt.length;ct<St;ct++){let wt=i.get(mt[ct]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(mt[ct])}i.remove(F)}let $=0;function j(){$=0}function et(){return $}function dt(F){$=F}function ft(){let F=$;return F>=s.maxTextures&&ne("WebGLTextures: Trying to use "+(F+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,F}function st(F){let R=[];return R.push(F.wrapS),R.push(F.wrapT),R.push(F.wrapR||0),R.push(F.magFilter),R.push(F.minFilter),R.push(F.anisotropy),R.push(F.internalFormat),R.push(F.format),R.push(F.type),R.push(F.generateMipmaps),R.push(F.mipmapsAutoUpdate),R.push(F.premultiplyAlpha),R.push(F.flipY),R.push(F.unpackAlignment),R.push(F.colorSpace),R.join()}function vt(F,R){let J=i.get(F);if(F.isVideoTexture&&Qe(F),F.isRenderTargetTexture===!1&&F.isExternalTexture!==!0&&F.version>0&&J.__version!==F.version){let mt=F.image;if(mt===null)ne("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ne("WebGLRenderer: Texture marked for update but image is incomplete");else{sn(J,F,R);return}}else F.isExternalTexture&&(J.__webglTexture=F.sourceTexture?F.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,J.__webglTexture,n.TEXTURE0+R)}function _t(F,R){let J=i.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&J.__version!==F.version){sn(J,F,R);return}else F.isExternalTexture&&(J.__webglTexture=F.sourceTexture?F.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,J.__webglTexture,n.TEXTURE0+R)}function Tt(F,R){let J=i.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&J.__version!==F.version){sn(J,F,R);return}e.bindTexture(n.TEXTURE_3D,J.__webglTexture,n.TEXTURE0+R)}function At(F,R){let J=i.get(F);if(F.version>0&&J.__version!==F.version){Pn(J,F,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture,n.TEXTURE0+R)}let Jt={[_h]:n.REPEAT,[Ks]:n.CLAMP_TO_EDGE,[yh]:n.MIRRORED_REPEAT},pe={[ti]:n.NEAREST,[z_]:n.NEAREST_MIPMAP_NEAREST,[Cc]:n.NEAREST_MIPMAP_LINEAR,[wi]:n.LINEAR,[$h]:n.LINEAR_MIPMAP_NEAREST,[Cr]:n.LINEAR_MIPMAP_LINEAR},Zt={[W_]:n.NEVER,[Im]:n.ALWAYS,[$_]:n.LESS,[Cm]:n.LEQUAL,[q_]:n.EQUAL,[Pm]:n.GEQUAL,[X_]:n.GREATER,[Y_]:n.NOTEQUAL};function we(F,R){if(R.type===hs&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===wi||R.magFilter===$h||R.magFilter===Cc||R.magFilter===Cr||R.minFilter===wi||R.minFilter===$h||R.minFilter===Cc||R.minFilter===Cr)&&ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(F,n.TEXTURE_WRAP_S,Jt[R.wrapS]),n.texParameteri(F,n.TEXTURE_WRAP_T,Jt[R.wrapT]),(F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY)&&n.texParameteri(F,n.TEXTURE_WRAP_R,Jt[R.wrapR]),n.texParameteri(F,n.TEXTURE_MAG_FILTER,pe[R.magFilter]),n.texParameteri(F,n.TEXTURE_MIN_FILTER,pe[R.minFilter]),R.compareFunction&&(n.texParameteri(F,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(F,n.TEXTURE_COMPARE_FUNC,Zt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===ti||R.minFilter!==Cc&&R.minFilter!==Cr||R.type===hs&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let J=t.get("EXT_texture_filter_anisotropic");n.texParameterf(F,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ye(F,R){let J=!1;F.__webglInit===void 0&&(F.__webglInit=!0,R.addEventListener("dispose",D),U(R));let mt=R.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let St=st(R);if(St!==F.__cacheKey){ct[St]===void 0&&(ct[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,J=!0),ct[St].usedTimes++;let wt=ct[F.__cacheKey];wt!==void 0&&(ct[F.__cacheKey].usedTimes--,wt.usedTimes===0&&N(R)),F.__cacheKey=St,F.__webglTexture=ct[St].texture}return J}function de(F,R,J){return Math.floor(Math.floor(F/J)/R)}function pn(F,R,J,mt){let St=F.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,J,mt,R.data);else{St.sort((G,lt)=>G.start-lt.start);let wt=0;for(let G=1;G<St.length;G++){let lt=St[wt],ot=St[G],Pt=lt.start+lt.count,Mt=de(ot.start,R.width,4),Rt=de(lt.start,R.width,4);ot.start<=Pt+1&&Mt===Rt&&de(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),bt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let G=0,lt=St.length;G<lt;G++){let ot=St[G],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%R.width,jt=Math.floor(Pt/R.width),oe=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,jt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,jt,oe,pt,J,mt,R.data)}F.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,bt)}}function sn(F,R,J){let mt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=n.TEXTURE_3D);let ct=ye(F,R),St=R.source;e.bindTexture(mt,F.__webglTexture,n.TEXTURE0+J);let wt=i.get(St);if(St.version!==wt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+J),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=Ie.getPrimaries(Ie.workingColorSpace),Wt=R.colorSpace===Ir?null:Ie.getPrimaries(R.colorSpace),ae=R.colorSpace===Ir||pt===Wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=x(R.image,!1,s.maxTextureSize);at=Yt(R,at);let bt=r.convert(R.format,R.colorSpace),G=r.convert(R.type),lt=E(R.internalFormat,bt,G,R.normalized,R.colorSpace,R.isVideoTexture);we(mt,R);let ot,Pt=R.mipmaps,Mt=R.isVideoTexture!==!0,Rt=wt.__version===void 0||ct===!0,jt=St.dataReady,oe=S(R,at);if(R.isDepthTexture)lt=_(R.format===Pr,R.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,bt,G,null));else if(R.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,G,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,bt,G,ot.data);R.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height),jt&&pn(R,at,bt,G)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,bt,G,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)if(ot=Pt[pt],R.format!==Is)if(bt!==null)if(Mt){if(jt)if(R.layerUpdates.size>0){let ae=Hm(ot.width,ot.height,R.format,R.type);for(let Dt of R.layerUpdates){let xe=ot.data.subarray(Dt*ae/ot.data.BYTES_PER_ELEMENT,(Dt+1)*ae/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,bt,xe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,bt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?jt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,bt,G,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,bt,G,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],R.format!==Is?bt!==null?Mt?jt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,G,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,bt,G,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,at.width,at.height,at.depth),jt)if(R.layerUpdates.size>0){let pt=Hm(at.width,at.height,R.format,R.type);for(let Wt of R.layerUpdates){let ae=at.data.subarray(Wt*pt/at.data.BYTES_PER_ELEMENT,(Wt+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Wt,at.width,at.height,1,bt,G,ae)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,bt,G,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,bt,G,at.data);else if(R.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,oe,lt,at.width,at.height,at.depth),jt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,bt,G,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,bt,G,at.data);else if(R.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height);else{let pt=at.width,Wt=at.height;for(let ae=0;ae<oe;ae++)e.texImage2D(n.TEXTURE_2D,ae,lt,pt,Wt,0,bt,G,null),pt>>=1,Wt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=Wt=>{let ae=Wt.changedElements;for(let Dt of h)ae.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ae=n.RGBA,Dt=n.RGBA,xe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ae,Dt,xe,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=te(Pt[0]);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,bt,G,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,bt,G,ot);R.generateMipmaps=!1}else if(Mt){if(Rt){let pt=te(at);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}jt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,bt,G,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,bt,G,at);T(R)&&R.mipmapsAutoUpdate===!0&&b(mt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}F.__version=R.version}function Pn(F,R,J){if(R.image.length!==6)return;let mt=ye(F,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,F.__webglTexture,n.TEXTURE0+J);let St=i.get(ct);if(ct.version!==St.__version||mt===!0){e.activeTexture(n.TEXTURE0+J);let wt=Ie.getPrimaries(Ie.workingColorSpace),rt=R.colorSpace===Ir?null:Ie.getPrimaries(R.colorSpace),at=R.colorSpace===Ir||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let bt=R.isCompressedTexture||R.image[0].isCompressedTexture,G=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!bt&&!G?lt[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):lt[Dt]=G?R.image[Dt].image:R.image[Dt],lt[Dt]=Yt(R,lt[Dt]);let ot=lt[0],Pt=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Rt=E(R.internalFormat,Pt,Mt,R.normalized,R.colorSpace),jt=R.isVideoTexture!==!0,oe=St.__version===void 0||mt===!0,pt=ct.dataReady,Wt=S(R,ot);we(n.TEXTURE_CUBE_MAP,R);let ae;if(R.isDepthTexture){if(Rt=_(R.format===Pr,R.type),oe)if(jt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(bt){jt&&oe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){ae=lt[Dt].mipmaps;for(let xe=0;xe<ae.length;xe++){let rn=ae[xe];R.format!==Is?Pt!==null?jt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,0,0,rn.width,rn.height,Pt,rn.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,Rt,rn.width,rn.height,0,rn.data):ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,0,0,rn.width,rn.height,Pt,Mt,rn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,Rt,rn.width,rn.height,0,Pt,Mt,rn.data)}}}else{if(ae=R.mipmaps,jt&&oe){ae.length>0&&Wt++;let Dt=te(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(G){jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let xe=0;xe<ae.length;xe++){let gi=ae[xe].image[Dt].image;jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,0,0,gi.width,gi.height,Pt,Mt,gi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,Rt,gi.width,gi.height,0,Pt,Mt,gi.data)}}else{jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let xe=0;xe<ae.length;xe++){let rn=ae[xe];jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,0,0,Pt,Mt,rn.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,Rt,Pt,Mt,rn.image[Dt])}}}T(R)&&R.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),St.__version=ct.version,R.onUpdate&&R.onUpdate(R)}F.__version=R.version}function Je(F,R,J,mt,ct,St){let wt=r.convert(J.format,J.colorSpace),rt=r.convert(J.type),at=E(J.internalFormat,wt,rt,J.normalized,J.colorSpace),bt=i.get(R),G=i.get(J);if(G.__renderTarget=R,!bt.__hasExternalTextures){let lt=Math.max(1,R.width>>St),ot=Math.max(1,R.height>>St);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,St,at,lt,ot,R.depth,0,wt,rt,null):e.texImage2D(ct,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,F),Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ct,G.__webglTexture,0,me(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ct,G.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Yn(F,R,J){if(n.bindRenderbuffer(n.RENDERBUFFER,F),R.depthBuffer){let mt=R.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,St=_(R.stencilBuffer,ct),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),St,R.width,R.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,F)}else{let mt=R.textures;for(let ct=0;ct<mt.length;ct++){let St=mt[ct],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=E(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),at,R.width,R.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function De(F,R,J){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,F),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let St=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),mt?At(R.depthTexture,0):vt(R.depthTexture,0);let wt=ct.__webglTexture,rt=me(R),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+J:n.TEXTURE_2D,bt=R.depthTexture.format===Pr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===Er)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,bt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,bt,at,wt,0);else if(R.depthTexture.format===Pr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,bt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,bt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bn(F){let R=i.get(F),J=F.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==F.depthTexture){let mt=F.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=mt}if(F.depthTexture&&!R.__autoAllocateDepthBuffer)if(J)for(let mt=0;mt<6;mt++)De(R.__webglFramebuffer[mt],F,mt);else F.texture.mipmaps.length>0?De(R.__webglFramebuffer[0],F,0):De(R.__webglFramebuffer,F,0);else if(J){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=n.createRenderbuffer(),Yn(R.__webglDepthbuffer[mt],F,!1);else{let ct=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}}else if(F.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),Yn(R.__webglDepthbuffer,F,!1);else{let ct=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function bn(F,R,J){let mt=i.get(F);R!==void 0&&Je(mt.__webglFramebuffer,F,F.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),J!==void 0&&Bn(F)}function In(F){let R=F.texture,J=i.get(F),mt=i.get(R);F.addEventListener("dispose",z),U(F);let ct=F.textures,St=F.isWebGLCubeRenderTarget===!0,wt=ct.length>1;if(wt||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=R.version,o.memory.textures++),St){J.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){J.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)J.__webglFramebuffer[rt][at]=n.createFramebuffer()}else J.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){J.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)J.__webglFramebuffer[rt]=n.createFramebuffer()}else J.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ct.length;rt<at;rt++){let bt=i.get(ct[rt]);bt.__webglTexture===void 0&&(bt.__webglTexture=n.createTexture(),o.memory.textures++)}if(F.samples>0&&Ct(F)===!1){J.__webglMultisampledFramebuffer=n.createFramebuffer(),J.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];J.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,J.__webglColorRenderbuffer[rt]);let bt=r.convert(at.format,at.colorSpace),G=r.convert(at.type),lt=E(at.internalFormat,bt,G,at.normalized,at.colorSpace,F.isXRRenderTarget===!0),ot=me(F);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,F.width,F.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,J.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),F.depthBuffer&&(J.__webglDepthRenderbuffer=n.createRenderbuffer(),Yn(J.__webglDepthRenderbuffer,F,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),we(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Je(J.__webglFramebuffer[rt][at],F,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Je(J.__webglFramebuffer[rt],F,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);T(R)?b(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ct.length;rt<at;rt++){let bt=ct[rt],G=i.get(bt),lt=n.TEXTURE_2D;(F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(lt=F.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,G.__webglTexture),we(lt,bt),Je(J.__webglFramebuffer,F,bt,n.COLOR_ATTACHMENT0+rt,lt,0),T(bt)&&b(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(rt=F.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),we(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Je(J.__webglFramebuffer[at],F,R,n.COLOR_ATTACHMENT0,rt,at);else Je(J.__webglFramebuffer,F,R,n.COLOR_ATTACHMENT0,rt,0);T(R)?b(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}F.depthBuffer&&Bn(F)}function V(F){let R=F.textures;for(let J=0,mt=R.length;J<mt;J++){let ct=R[J];if(T(ct)&&ct.mipmapsAutoUpdate===!0){let St=A(F),wt=i.get(ct).__webglTexture;e.bindTexture(St,wt),b(St),e.unbindTexture()}}}let Nt=[];function ie(F){if(F.samples>0){if(Ct(F)===!1){let R=F.textures,J=F.width,mt=F.height,ct=n.COLOR_BUFFER_BIT,St=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(F),rt=R.length>1;if(rt)for(let bt=0;bt<R.length;bt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),F.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let bt=0;bt<R.length;bt++){if(F.resolveDepthBuffer&&(F.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),F.stencilBuffer&&F.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let G=i.get(R[bt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,G,0)}n.blitFramebuffer(0,0,J,mt,0,0,J,mt,ct,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+bt),F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let bt=0;bt<R.length;bt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let G=i.get(R[bt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,G,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&l){let R=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function me(F){return Math.min(s.maxSamples,F.samples)}function Ct(F){let R=i.get(F);return F.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Qe(F){let R=o.render.frame;u.get(F)!==R&&(u.set(F,R),F.update())}function Yt(F,R){let J=F.colorSpace,mt=F.format,ct=F.type;return F.isCompressedTexture===!0||F.isVideoTexture===!0||J!==ic&&J!==Ir&&(Ie.getTransfer(J)===We?(mt!==Is||ct!==es)&&ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",J)),R}function te(F){return typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement?(c.width=F.naturalWidth||F.width,c.height=F.naturalHeight||F.height):typeof VideoFrame<"u"&&F instanceof VideoFrame?(c.width=F.displayWidth,c.height=F.displayHeight):(c.width=F.width,c.height=F.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=vt,this.setTexture2DArray=_t,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=bn,this.setupRenderTarget=In,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=ie,this.setupDepthRenderbuffer=Bn,this.setupFrameBufferTexture=Je,this.useMultisampledRTT=Ct,this.dispose=X}function BC(n,t){function e(i,s=Ir){let r,o=Ie.getTransfer(s);if(i===es)return n.UNSIGNED_BYTE;if(i===Xh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Yh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Mm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Sm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===vm)return n.BYTE;if(i===bm)return n.SHORT;if(i===Ya)return n.UNSIGNED_SHORT;if(i===qh)return n.INT;if(i===Cs)return n.UNSIGNED_INT;if(i===hs)return n.FLOAT;if(i===Ps)return n.HALF_FLOAT;if(i===wm)return n.ALPHA;if(i===Em)return n.RGB;if(i===Is)return n.RGBA;if(i===Er)return n.DEPTH_COMPONENT;if(i===Pr)return n.DEPTH_STENCIL;if(i===Zh)return n.RED;if(i===jh)return n.RED_INTEGER;if(i===ro)return n.RG;if(i===Jh)return n.RG_INTEGER;if(i===Kh)return n.RGBA_INTEGER;if(i===Pc||i===Ic||i===Lc||i===Dc)if(o===We)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Pc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ic)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Lc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Dc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Pc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ic)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Lc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Dc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Qh||i===td||i===ed||i===nd)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Qh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===td)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ed)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===nd)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===id||i===sd||i===rd||i===od||i===ad||i===Nc||i===ld)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===id||i===sd)return o===We?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===rd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===od)return r.COMPRESSED_R11_EAC;if(i===ad)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Nc)return r.COMPRESSED_RG11_EAC;if(i===ld)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===cd||i===ud||i===hd||i===dd||i===fd||i===pd||i===md||i===gd||i===xd||i===_d||i===yd||i===vd||i===bd||i===Md)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===cd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ud)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===hd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===dd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===fd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===pd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===md)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===gd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===xd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===_d)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===yd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===vd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===bd)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Md)return o===We?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Sd||i===wd||i===Ed)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Sd)return o===We?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===wd)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ed)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Td||i===Ad||i===Uc||i===Rd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Td)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ad)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Uc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Rd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var kC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,zC=`
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

}`,jm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new yc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ri({vertexShader:kC,fragmentShader:zC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ze(new Sc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Jm=class extends As{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,y=typeof XRWebGLBinding<"u",p=new jm,g={},x=e.getContextAttributes(),T=null,b=null,A=[],E=[],_=new Xt,S=null,U=null,L=new Si;L.viewport=new yn;let D=new Si;D.viewport=new yn;let z=[L,D],W=new Gh,B=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let vt=A[st];return vt===void 0&&(vt=new ka,A[st]=vt),vt.getTargetRaySpace()},this.getControllerGrip=function(st){let vt=A[st];return vt===void 0&&(vt=new ka,A[st]=vt),vt.getGripSpace()},this.getHand=function(st){let vt=A[st];return vt===void 0&&(vt=new ka,A[st]=vt),vt.getHandSpace()};function P(st){let vt=E.indexOf(st.inputSource);if(vt===-1)return;let _t=A[vt];_t!==void 0&&(_t.update(st.inputSource,st.frame,c||o),_t.dispatchEvent({type:st.type,data:st.inputSource}))}function N(){s.removeEventListener("select",P),s.removeEventListener("selectstart",P),s.removeEventListener("selectend",P),s.removeEventListener("squeeze",P),s.removeEventListener("squeezestart",P),s.removeEventListener("squeezeend",P),s.removeEventListener("end",N),s.removeEventListener("inputsourceschange",Z);for(let st=0;st<A.length;st++){let vt=E[st];vt!==null&&(E[st]=null,A[st].disconnect(vt))}B=null,X=null,p.reset();for(let st in g)delete g[st];if(t.setRenderTarget(T),f=null,d=null,h=null,s=null,b=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(_.width,_.height,!1),U!==null){let st=U.camera;st.fov=U.fov,st.zoom=U.zoom,st.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",P),s.addEventListener("selectstart",P),s.addEventListener("selectend",P),s.addEventListener("squeeze",P),s.addEventListener("squeezestart",P),s.addEventListener("squeezeend",P),s.addEventListener("end",N),s.addEventListener("inputsourceschange",Z),x.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=x.stencil?Pr:Er,Tt=x.stencil?Fo:Cs);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new Ki(d.textureWidth,d.textureHeight,{format:Is,type:es,depthTexture:new Rr(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _t={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Ki(f.framebufferWidth,f.framebufferHeight,{format:Is,type:es,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function Z(st){for(let vt=0;vt<st.removed.length;vt++){let _t=st.removed[vt],Tt=E.indexOf(_t);Tt>=0&&(E[Tt]=null,A[Tt].disconnect(_t))}for(let vt=0;vt<st.added.length;vt++){let _t=st.added[vt],Tt=E.indexOf(_t);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=E.length){E.push(_t),Tt=Jt;break}else if(E[Jt]===null){E[Jt]=_t,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(_t)}}function $(st,vt){vt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(vt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let vt=st.near,_t=st.far;p.texture!==null&&(p.depthNear>0&&(vt=p.depthNear),p.depthFar>0&&(_t=p.depthFar)),W.near=D.near=L.near=vt,W.far=D.far=L.far=_t,(B!==W.near||X!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),B=W.near,X=W.far),W.layers.mask=st.layers.mask|6,L.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Tt=st.parent,At=W.cameras;$(W,Tt);for(let Jt=0;Jt<At.length;Jt++)$(At[Jt],Tt);W.projectionMatrix.copy(L.projectionMatrix),W.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&st.isPerspectiveCamera&&(U={camera:st,fov:st.fov,zoom:st.zoom}),j(st,W,Tt)};function j(st,vt,_t){_t===null?st.matrix.copy(vt.matrixWorld):(st.matrix.copy(_t.matrixWorld),st.matrix.invert(),st.matrix.multiply(vt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(vt.projectionMatrix),st.projectionMatrixInverse.copy(vt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Fa*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(W)},this.getCameraTexture=function(st){return g[st]};let et=null;function dt(st,vt){if(u=vt.getViewerPose(c||o),m=vt,u!==null){let _t=u.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Tt=!1;_t.length!==W.cameras.length&&(W.cameras.length=0,Tt=!0);for(let Zt=0;Zt<_t.length;Zt++){let we=_t[Zt],ye=null;if(f!==null)ye=f.getViewport(we);else{let pn=h.getViewSubImage(d,we);ye=pn.viewport,Zt===0&&(t.setRenderTargetTextures(b,pn.colorTexture,pn.depthStencilTexture),t.setRenderTarget(b))}let de=z[Zt];de===void 0&&(de=new Si,de.layers.enable(Zt),de.viewport=new yn,z[Zt]=de),de.matrix.fromArray(we.transform.matrix),de.matrix.decompose(de.position,de.quaternion,de.scale),de.projectionMatrix.fromArray(we.projectionMatrix),de.projectionMatrixInverse.copy(de.projectionMatrix).invert(),de.viewport.set(ye.x,ye.y,ye.width,ye.height),Zt===0&&(W.matrix.copy(de.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Tt===!0&&W.cameras.push(de)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Zt=h.getDepthInformation(_t[0]);Zt&&Zt.isValid&&Zt.texture&&p.init(Zt,s.renderState)}if(At&&At.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let Zt=0;Zt<_t.length;Zt++){let we=_t[Zt].camera;if(we){let ye=g[we];ye||(ye=new yc,g[we]=ye);let de=h.getCameraImage(we);ye.sourceTexture=de}}}}for(let _t=0;_t<A.length;_t++){let Tt=E[_t],At=A[_t];Tt!==null&&At!==void 0&&At.update(Tt,vt,c||o)}et&&et(st,vt),vt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:vt}),m=null}let ft=new Ey;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){et=st},this.dispose=function(){}}},HC=new ge,Uy=new ce;Uy.set(-1,0,0,0,1,0,0,0,1);function GC(n,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,Bm(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,x,T,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),h(p,g)):g.isMeshPhongMaterial?(r(p,g),u(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),d(p,g),g.isMeshPhysicalMaterial&&f(p,g,b)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),y(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,x,T):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===Ci&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===Ci&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let x=t.get(g),T=x.envMap,b=x.envMapRotation;T&&(p.envMap.value=T,p.envMapRotation.value.setFromMatrix4(HC.makeRotationFromEuler(b)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Uy),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,x,T){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*x,p.scale.value=T*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function u(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function h(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function d(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,x){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Ci&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function y(p,g){let x=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function VC(n,t,e,i){let s={},r={};function o(x,T){let b=T.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,T){let b=s[x.id];b===void 0&&(m(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",p));let A=T.program;i.updateUBOMapping(x,A);let E=t.render.frame;r[x.id]!==E&&(c(x),r[x.id]=E)}function l(x){let T=n.createBuffer(),b=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,b,A),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(x){let T=s[x.id],b=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let E=0,_=b.length;E<_;E++){let S=b[E];if(Array.isArray(S))for(let U=0,L=S.length;U<L;U++)u(S[U],E,U,A);else u(S,E,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,T,b,A){if(d(x,T,b,A)===!0){let E=x.__offset,_=x.value;if(Array.isArray(_)){let S=0;for(let U=0;U<_.length;U++){let L=_[U],D=y(L,!0);h(L,x.__data,S),S+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,x.__data)}}function h(x,T,b){typeof x=="number"||typeof x=="boolean"?T[b]=x:x.isMatrix3?(T[b]=x.elements[0],T[b+1]=x.elements[1],T[b+2]=x.elements[2],T[b+3]=0,T[b+4]=x.elements[3],T[b+5]=x.elements[4],T[b+6]=x.elements[5],T[b+7]=0,T[b+8]=x.elements[6],T[b+9]=x.elements[7],T[b+10]=x.elements[8],T[b+11]=0):ArrayBuffer.isView(x)?T.set(x.subarray(0,T.length-b),b):x.toArray(T,b)}function d(x,T,b,A){let E=x.value,_=T+"_"+b;if(Array.isArray(E)){A[_]===void 0&&(A[_]=[]);let S=A[_],U=!1;for(let L=0;L<E.length;L++)f(E[L],S,L)===!0&&(U=!0);return U}return f(E,A,_)}function f(x,T,b){if(T[b]===void 0)return typeof x=="number"||typeof x=="boolean"?T[b]=x:ArrayBuffer.isView(x)?T[b]=x.slice():T[b]=x.clone(),!0;{let A=T[b];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return T[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function m(x){let T=x.uniforms,b=0,A=16;for(let _=0,S=T.length;_<S;_++){let U=Array.isArray(T[_])?T[_]:[T[_]];for(let L=0,D=U.length;L<D;L++){let z=U[L],W=Array.isArray(z.value)?z.value:[z.value],B=Array.isArray(T[_])||Array.isArray(z.value),X=b;for(let N=0,Z=W.length;N<Z;N++){let $=W[N],j=y($,B),et=b%A,dt=et%j.boundary,ft=et+dt;b+=dt,ft!==0&&A-ft<j.storage&&(b+=A-ft),N===0&&(X=b),b+=j.storage}let P=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new P((b-X)/Float32Array.BYTES_PER_ELEMENT),z.__offset=X}}let E=b%A;return E>0&&(b+=A-E),x.__size=b,x.__cache={},this}function y(x,T){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):ne("WebGLRenderer: Unsupported uniform value type.",x),T===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(x){let T=x.target;T.removeEventListener("dispose",p),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var WC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),rr=null;function $C(){return rr===null&&(rr=new pc(WC,16,16,ro,Ps),rr.name="DFG_LUT",rr.minFilter=wi,rr.magFilter=wi,rr.wrapS=Ks,rr.wrapT=Ks,rr.generateMipmaps=!1,rr.needsUpdate=!0),rr}var Nd=class{constructor(t={}){let{canvas:e=Z_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=es}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let y=f,p=new Set([Kh,Jh,jh]),g=new Set([es,Cs,Ya,Fo,Xh,Yh]),x=new Uint32Array(4),T=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,E=null,_=[],S=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=sr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,D=!1,z=null,W=null,B=null,X=null;this._outputColorSpace=ii;let P=0,N=0,Z=null,$=-1,j=null,et=new yn,dt=new yn,ft=null,st=new ee(0),vt=0,_t=e.width,Tt=e.height,At=1,Jt=null,pe=null,Zt=new yn(0,0,_t,Tt),we=new yn(0,0,_t,Tt),ye=!1,de=new Co,pn=new wh,sn=!1,Pn=!1,Je=new ge,Yn=new H,De=new yn,Bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},bn=!1;function In(){return Z===null?At:1}let V=i;function Nt(I,q){return e.getContext(I,q)}let ie,me,Ct,Qe,Yt,te,F,R,J,mt,ct,St,wt,rt,at,bt,G,lt,ot,Pt,Mt,Rt,jt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Wt,!1),e.addEventListener("webglcontextrestored",ae,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),V===null){let q="webgl2";if(V=Nt(q,I),V===null)throw Nt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}oe()}catch(I){throw e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),re("WebGLRenderer: "+I.message),I}function oe(){ie=new nR(V),ie.init(),Mt=new BC(V,ie),me=new $A(V,ie,t,Mt),Ct=new FC(V,ie),me.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),W=V.createFramebuffer(),B=V.createFramebuffer(),X=V.createFramebuffer(),Qe=new rR(V),Yt=new MC,te=new OC(V,ie,Ct,Yt,me,Mt,Qe),F=new eR(L),R=new aE(V),Rt=new VA(V,R),J=new iR(V,R,Qe,Rt),mt=new aR(V,J,R,Rt,Qe),lt=new oR(V,me,te),at=new qA(Yt),ct=new bC(L,F,ie,me,Rt,at),St=new GC(L,Yt),wt=new wC,rt=new PC(ie),G=new GA(L,F,Ct,mt,m,l),bt=new UC(L,mt,me),jt=new VC(V,Qe,me,Ct),ot=new WA(V,ie,Qe),Pt=new sR(V,ie,Qe),Qe.programs=ct.programs,L.capabilities=me,L.extensions=ie,L.properties=Yt,L.renderLists=wt,L.shadowMap=bt,L.state=Ct,L.info=Qe}y!==es&&(U=new cR(y,e.width,e.height,a,s,r));let pt=new Jm(L,V);this.xr=pt,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let I=ie.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=ie.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(_t,Tt,!1))},this.getSize=function(I){return I.set(_t,Tt)},this.setSize=function(I,q,it=!0){if(pt.isPresenting){ne("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=I,Tt=q,e.width=Math.floor(I*At),e.height=Math.floor(q*At),it===!0&&(e.style.width=I+"px",e.style.height=q+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,I,q)},this.getDrawingBufferSize=function(I){return I.set(_t*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,q,it){_t=I,Tt=q,At=it,e.width=Math.floor(I*it),e.height=Math.floor(q*it),this.setViewport(0,0,I,q)},this.setEffects=function(I){if(y===es){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let q=0;q<I.length;q++)if(I[q].isOutputPass===!0){ne("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(et)},this.getViewport=function(I){return I.copy(Zt)},this.setViewport=function(I,q,it,K){I.isVector4?Zt.set(I.x,I.y,I.z,I.w):Zt.set(I,q,it,K),Ct.viewport(et.copy(Zt).multiplyScalar(In()).round())},this.getScissor=function(I){return I.copy(we)},this.setScissor=function(I,q,it,K){I.isVector4?we.set(I.x,I.y,I.z,I.w):we.set(I,q,it,K),Ct.scissor(dt.copy(we).multiplyScalar(In()).round())},this.getScissorTest=function(){return ye},this.setScissorTest=function(I){Ct.setScissorTest(ye=I)},this.setOpaqueSort=function(I){Jt=I},this.setTransparentSort=function(I){pe=I},this.getClearColor=function(I){return I.copy(G.getClearColor())},this.setClearColor=function(){G.setClearColor(...arguments)},this.getClearAlpha=function(){return G.getClearAlpha()},this.setClearAlpha=function(){G.setClearAlpha(...arguments)},this.clear=function(I=!0,q=!0,it=!0){let K=0;if(I){let Q=!1;if(Z!==null){let It=Z.texture.format;Q=p.has(It)}if(Q){let It=Z.texture.type,Ut=g.has(It),Lt=G.getClearColor(),Ft=G.getClearAlpha(),qt=Lt.r,le=Lt.g,Ae=Lt.b;Ut?(x[0]=qt,x[1]=le,x[2]=Ae,x[3]=Ft,V.clearBufferuiv(V.COLOR,0,x)):(T[0]=qt,T[1]=le,T[2]=Ae,T[3]=Ft,V.clearBufferiv(V.COLOR,0,T))}else K|=V.COLOR_BUFFER_BIT}q&&(K|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(K|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&V.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),z=I},this.dispose=function(){e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),G.dispose(),wt.dispose(),rt.dispose(),te.dispose(),Yt.dispose(),F.dispose(),mt.dispose(),J.dispose(),Rt.dispose(),jt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",wu),pt.removeEventListener("sessionend",ks),hr.stop()};function Wt(I){I.preventDefault(),ac("WebGLRenderer: Context Lost."),D=!0}function ae(){ac("WebGLRenderer: Context Restored."),D=!1;let I=Qe.autoReset,q=bt.enabled,it=bt.autoUpdate,K=bt.needsUpdate,Q=bt.type;oe(),Qe.autoReset=I,bt.enabled=q,bt.autoUpdate=it,bt.needsUpdate=K,bt.type=Q}function Dt(I){re("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function xe(I){let q=I.target;q.removeEventListener("dispose",xe),rn(q)}function rn(I){gi(I),Yt.remove(I)}function gi(I){let q=Yt.get(I).programs;q!==void 0&&(q.forEach(function(it){ct.releaseProgram(it)}),I.isShaderMaterial&&ct.releaseShaderCache(I))}this.renderBufferDirect=function(I,q,it,K,Q,It){q===null&&(q=Bn);let Ut=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Lt=Fl(I,q,it,K,Q);Ct.setMaterial(K,Ut);let Ft=it.index,qt=1;if(K.wireframe===!0){if(Ft=J.getWireframeAttribute(it),Ft===void 0)return;qt=2}let le=it.drawRange,Ae=it.attributes.position,$t=le.start*qt,Re=(le.start+le.count)*qt;It!==null&&($t=Math.max($t,It.start*qt),Re=Math.min(Re,(It.start+It.count)*qt)),Ft!==null?($t=Math.max($t,0),Re=Math.min(Re,Ft.count)):Ae!=null&&($t=Math.max($t,0),Re=Math.min(Re,Ae.count));let _n=Re-$t;if(_n<0||_n===1/0)return;Rt.setup(Q,K,Lt,it,Ft);let qe,Xe=ot;if(Ft!==null&&(qe=R.get(Ft),Xe=Pt,Xe.setIndex(qe)),Q.isMesh)K.wireframe===!0?(Ct.setLineWidth(K.wireframeLinewidth*In()),Xe.setMode(V.LINES)):Xe.setMode(V.TRIANGLES);else if(Q.isLine){let kn=K.linewidth;kn===void 0&&(kn=1),Ct.setLineWidth(kn*In()),Q.isLineSegments?Xe.setMode(V.LINES):Q.isLineLoop?Xe.setMode(V.LINE_LOOP):Xe.setMode(V.LINE_STRIP)}else Q.isPoints?Xe.setMode(V.POINTS):Q.isSprite&&Xe.setMode(V.TRIANGLES);if(Q.isBatchedMesh)if(ie.get("WEBGL_multi_draw"))Xe.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let kn=Q._multiDrawStarts,Ht=Q._multiDrawCounts,Ln=Q._multiDrawCount,Pe=Ft?R.get(Ft).bytesPerElement:1,fr=Yt.get(K).currentProgram.getUniforms();for(let Dn=0;Dn<Ln;Dn++)fr.setValue(V,"_gl_DrawID",Dn),Xe.render(kn[Dn]/Pe,Ht[Dn])}else if(Q.isInstancedMesh)Xe.renderInstances($t,_n,Q.count);else if(it.isInstancedBufferGeometry){let kn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Ht=Math.min(it.instanceCount,kn);Xe.renderInstances($t,_n,Ht)}else Xe.render($t,_n)};function Dl(I,q,it,K){z!==null&&I.isNodeMaterial&&z.setObject(K,I),sn===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===di&&I.forceSinglePass===!1?(I.side=Ci,I.needsUpdate=!0,zs(I,q,K),I.side=ir,I.needsUpdate=!0,zs(I,q,K),I.side=di):zs(I,q,K)}this.compile=function(I,q,it=null){it===null&&(it=I),z!==null&&z.renderStart(I,q,it),E=rt.get(it),E.init(q),S.push(E),it.traverseVisible(function(Q){Q.isLight&&Q.layers.test(q.layers)&&(E.pushLight(Q),Q.castShadow&&E.pushShadow(Q))}),I!==it&&I.traverseVisible(function(Q){Q.isLight&&Q.layers.test(q.layers)&&(E.pushLight(Q),Q.castShadow&&E.pushShadow(Q))}),E.setupLights(),z!==null&&z.updateLights(E.state.lightsArray),Pn=this.localClippingEnabled,sn=at.init(this.clippingPlanes,Pn),sn===!0&&at.setGlobalState(this.clippingPlanes,q),z!==null&&bt.render(E.state.shadowsArray,it,q);let K=new Set;return I.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let It=Q.material;if(It)if(Array.isArray(It))for(let Ut=0;Ut<It.length;Ut++){let Lt=It[Ut];Dl(Lt,it,q,Q),K.add(Lt)}else Dl(It,it,q,Q),K.add(It)}),E=S.pop(),z!==null&&z.renderEnd(),K},this.compileAsync=function(I,q,it=null){let K=this.compile(I,q,it);return new Promise(Q=>{function It(){if(K.forEach(function(Ut){let Ft=Yt.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&K.delete(Ut)}),K.size===0){Q(I);return}setTimeout(It,10)}ie.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let ta=null;function mp(I){ta&&ta(I)}function wu(){hr.stop()}function ks(){hr.start()}let hr=new Ey;hr.setAnimationLoop(mp),typeof self<"u"&&hr.setContext(self),this.setAnimationLoop=function(I){ta=I,pt.setAnimationLoop(I),I===null?hr.stop():hr.start()},pt.addEventListener("sessionstart",wu),pt.addEventListener("sessionend",ks),this.render=function(I,q){if(q!==void 0&&q.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(I,q);let it=pt.enabled===!0&&pt.isPresenting===!0,K=U!==null&&(Z===null||it)&&U.begin(L,Z);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(L,I,q,Z),E=rt.get(I,S.length),E.init(q),E.state.textureUnits=te.getTextureUnits(),S.push(E),Je.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?pn.setFromArrayCamera(q):de.setFromProjectionMatrix(Je,us,q.reversedDepth),Pn=this.localClippingEnabled,sn=at.init(this.clippingPlanes,Pn),A=wt.get(I,_.length),A.init(),_.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ut=L.xr.getDepthSensingMesh();Ut!==null&&dr(Ut,q,-1/0,L.sortObjects)}dr(I,q,0,L.sortObjects),A.finish(),z!==null&&z.updateLights(E.state.lightsArray),L.sortObjects===!0&&A.sort(Jt,pe),bn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,bn&&G.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),sn===!0&&at.beginShadows();let Q=E.state.shadowsArray;if(bt.render(Q,I,q),sn===!0&&at.endShadows(),(K&&U.hasRenderPass())===!1){let Ut=A.opaque,Lt=A.transmissive;if(E.setupLights(),q.isArrayCamera){let Ft=q.cameras;if(Lt.length>0)for(let qt=0,le=Ft.length;qt<le;qt++){let Ae=Ft[qt];vs(Ut,Lt,I,Ae)}bn&&G.render(I);for(let qt=0,le=Ft.length;qt<le;qt++){let Ae=Ft[qt];Nl(A,I,Ae,Ae.viewport)}}else Lt.length>0&&vs(Ut,Lt,I,q),bn&&G.render(I),Nl(A,I,q)}Z!==null&&N===0&&(te.updateMultisampleRenderTarget(Z),te.updateRenderTargetMipmap(Z)),K&&U.end(L),I.isScene===!0&&I.onAfterRender(L,I,q),Rt.resetDefaultState(),$=-1,j=null,S.pop(),S.length>0?(E=S[S.length-1],te.setTextureUnits(E.state.textureUnits),sn===!0&&at.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,z!==null&&z.renderEnd()};function dr(I,q,it,K){if(I.visible===!1)return;if(I.layers.test(q.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update(q);else if(I.isLight)E.pushLight(I),I.castShadow&&E.pushShadow(I);else if(I.isSprite){let Ut=q.isArrayCamera?pn:de;if(!I.frustumCulled||I.intersectsFrustum(Ut)){K&&De.setFromMatrixPosition(I.matrixWorld).applyMatrix4(Je);let Lt=mt.update(I),Ft=I.material;Ft.visible&&A.push(I,Lt,Ft,it,De.z,null,q)}}else if(I.isMesh||I.isLine||I.isPoints){let Ut=q.isArrayCamera?pn:de;if(!I.frustumCulled||I.intersectsFrustum(Ut)){let Lt=mt.update(I),Ft=I.material;if(K&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),De.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),De.copy(Lt.boundingSphere.center)),De.applyMatrix4(I.matrixWorld).applyMatrix4(Je)),Array.isArray(Ft)){let qt=Lt.groups;for(let le=0,Ae=qt.length;le<Ae;le++){let $t=qt[le],Re=Ft[$t.materialIndex];Re&&Re.visible&&A.push(I,Lt,Re,it,De.z,$t,q)}}else Ft.visible&&A.push(I,Lt,Ft,it,De.z,null,q)}}}let It=I.children;for(let Ut=0,Lt=It.length;Ut<Lt;Ut++)dr(It[Ut],q,it,K)}function Nl(I,q,it,K){let{opaque:Q,transmissive:It,transparent:Ut}=I;E.setupLightsView(it),sn===!0&&at.setGlobalState(L.clippingPlanes,it),K&&Ct.viewport(et.copy(K)),Q.length>0&&Mn(Q,q,it),It.length>0&&Mn(It,q,it),Ut.length>0&&Mn(Ut,q,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function vs(I,q,it,K){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[K.id]===void 0){let $t=ie.has("EXT_color_buffer_half_float")||ie.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[K.id]=new Ki(1,1,{generateMipmaps:!0,type:$t?Ps:es,minFilter:Cr,samples:Math.max(4,me.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ie.workingColorSpace})}let It=E.state.transmissionRenderTarget[K.id],Ut=K.viewport||et;It.setSize(Ut.z*L.transmissionResolutionScale,Ut.w*L.transmissionResolutionScale);let Lt=L.getRenderTarget(),Ft=L.getActiveCubeFace(),qt=L.getActiveMipmapLevel();L.setRenderTarget(It),L.getClearColor(st),vt=L.getClearAlpha(),vt<1&&L.setClearColor(16777215,.5),L.clear(),bn&&G.render(it);let le=L.toneMapping;L.toneMapping=sr;let Ae=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),E.setupLightsView(K),sn===!0&&at.setGlobalState(L.clippingPlanes,K),Mn(I,it,K),te.updateMultisampleRenderTarget(It),te.updateRenderTargetMipmap(It),ie.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let Re=0,_n=q.length;Re<_n;Re++){let qe=q[Re],{object:Xe,geometry:kn,material:Ht,group:Ln}=qe;if(Ht.side===di&&Xe.layers.test(K.layers)){let Pe=Ht.side;Ht.side=Ci,Ht.needsUpdate=!0,Rn(Xe,it,K,kn,Ht,Ln),Ht.side=Pe,Ht.needsUpdate=!0,$t=!0}}$t===!0&&(te.updateMultisampleRenderTarget(It),te.updateRenderTargetMipmap(It))}L.setRenderTarget(Lt,Ft,qt),L.setClearColor(st,vt),Ae!==void 0&&(K.viewport=Ae),L.toneMapping=le}function Mn(I,q,it){let K=q.isScene===!0?q.overrideMaterial:null;for(let Q=0,It=I.length;Q<It;Q++){let Ut=I[Q],{object:Lt,geometry:Ft,group:qt}=Ut,le=Ut.material;le.allowOverride===!0&&K!==null&&(le=K),Lt.layers.test(it.layers)&&Rn(Lt,q,it,Ft,le,qt)}}function Rn(I,q,it,K,Q,It){z!==null&&Q.isNodeMaterial&&z.setObject(I,Q),I.onBeforeRender(L,q,it,K,Q,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),Q.onBeforeRender(L,q,it,K,I,It),Q.transparent===!0&&Q.side===di&&Q.forceSinglePass===!1?(Q.side=Ci,Q.needsUpdate=!0,L.renderBufferDirect(it,q,K,Q,I,It),Q.side=ir,Q.needsUpdate=!0,L.renderBufferDirect(it,q,K,Q,I,It),Q.side=di):L.renderBufferDirect(it,q,K,Q,I,It),I.onAfterRender(L,q,it,K,Q,It)}function Cn(I){let q=0;for(let it of I)it.texture!==null&&q++;return q}function zs(I,q,it){q.isScene!==!0&&(q=Bn);let K=Yt.get(I),Q=E.state.lights,It=E.state.shadowsArray,Ut=Q.state.version,Lt=ct.getParameters(I,Q.state,It,q,it,E.state.lightProbeGridArray),Ft=ct.getProgramCacheKey(Lt),qt=K.programs;K.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?q.environment:null,K.fog=q.fog;let le=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;K.envMap=F.get(I.envMap||K.environment,le),K.envMapRotation=K.environment!==null&&I.envMap===null?q.environmentRotation:I.envMapRotation,qt===void 0&&(I.addEventListener("dispose",xe),qt=new Map,K.programs=qt,K.programVariants=new Map);let Ae=qt.get(Ft);if(Ae!==void 0){if(K.currentProgram===Ae&&K.lightsStateVersion===Ut)return Ul(I,Lt),Ae}else Lt.uniforms=ct.getUniforms(I),z!==null&&I.isNodeMaterial&&z.build(I,it,Lt),I.onBeforeCompile(Lt,L),Ae=ct.acquireProgram(Lt,Ft),qt.set(Ft,Ae),K.uniforms=Lt.uniforms;let $t=K.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&($t.clippingPlanes=at.uniform),Ul(I,Lt),K.needsLights=zr(I),K.lightsStateVersion=Ut,K.needsLights&&($t.ambientLightColor.value=Q.state.ambient,$t.lightProbe.value=Q.state.probe,$t.sunLights.value=Q.state.sun,$t.sunLightShadows.value=Q.state.sunShadow,$t.directionalLights.value=Q.state.directional,$t.directionalLightShadows.value=Q.state.directionalShadow,$t.spotLights.value=Q.state.spot,$t.spotLightShadows.value=Q.state.spotShadow,$t.rectAreaLights.value=Q.state.rectArea,$t.ltc_1.value=Q.state.rectAreaLTC1,$t.ltc_2.value=Q.state.rectAreaLTC2,$t.pointLights.value=Q.state.point,$t.pointLightShadows.value=Q.state.pointShadow,$t.hemisphereLights.value=Q.state.hemi,$t.sunShadowMatrix.value=Q.state.sunShadowMatrix,$t.sunShadowCascade.value=Q.state.sunShadowCascade,$t.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,$t.spotLightMatrix.value=Q.state.spotLightMatrix,$t.spotLightMap.value=Q.state.spotLightMap,$t.pointShadowMatrix.value=Q.state.pointShadowMatrix),K.numLightProbeGrids=Cn(E.state.lightProbeGridArray),K.currentProgram=Ae,K.uniformsList=null,Ae}function Wi(I,q,it,K,Q){let It=Yt.get(I),Ut=It.currentProgram.id+","+K+","+Q,Lt=It.programVariants.get(Ut);return Lt===void 0?(Lt=zs(I,q,it),It.programVariants.set(Ut,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=K,It.toneMapping=Q),Lt}function kr(I){if(I.uniformsList===null){let q=I.currentProgram.getUniforms();I.uniformsList=Za.seqWithValue(q.seq,I.uniforms)}return I.uniformsList}function Ul(I,q){let it=Yt.get(I);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function Fl(I,q,it,K,Q){q.isScene!==!0&&(q=Bn),te.resetTextureUnits();let It=q.fog,Ut=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?q.environment:null,Lt=Z===null?L.outputColorSpace:Z.isXRRenderTarget===!0?Z.texture.colorSpace:Ie.workingColorSpace,Ft=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,qt=F.get(K.envMap||Ut,Ft),le=K.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Ae=!!it.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),$t=!!it.morphAttributes.position,Re=!!it.morphAttributes.normal,_n=!!it.morphAttributes.color,qe=sr;K.toneMapped&&(Z===null||Z.isXRRenderTarget===!0)&&(qe=L.toneMapping);let Xe=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,kn=Xe!==void 0?Xe.length:0,Ht=Yt.get(K),Ln=E.state.lights;if(sn===!0&&(Pn===!0||I!==j)){let Ye=I===j&&K.id===$;at.setState(K,I,Ye)}let Pe=!1,fr=!1;K.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==Ln.state.version||Q.isBatchedMesh&&Ht.batching===!1||!Q.isBatchedMesh&&Ht.batching===!0||Q.isBatchedMesh&&Ht.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Ht.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Ht.instancing===!1||!Q.isInstancedMesh&&Ht.instancing===!0||Q.isSkinnedMesh&&Ht.skinning===!1||!Q.isSkinnedMesh&&Ht.skinning===!0||Q.isInstancedMesh&&Ht.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Ht.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Ht.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Ht.instancingMorph===!1&&Q.morphTexture!==null||Ht.envMap!==qt||K.fog===!0&&Ht.fog!==It||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==at.numPlanes||Ht.numIntersection!==at.numIntersection)||Ht.vertexAlphas!==le||Ht.vertexTangents!==Ae||Ht.morphTargets!==$t||Ht.morphNormals!==Re||Ht.morphColors!==_n||Ht.morphTargetsCount!==kn||Ht.numLightProbeGrids!==Cn(E.state.lightProbeGridArray)?Pe=!0:(Ht.outputColorSpace!==Lt||Ht.toneMapping!==qe)&&(fr=!0):(Pe=!0,Ht.__version=K.version);let Dn=Ht.currentProgram;(Pe===!0||fr===!0)&&(Dn=fr===!0?Wi(K,q,Q,Lt,qe):zs(K,q,Q),z&&K.isNodeMaterial&&z.onUpdateProgram(K,Dn,Ht));let ia=!1,Hs=!1,pr=!1,ve=Dn.getUniforms(),Sn=Ht.uniforms;if(Ct.useProgram(Dn.program)&&(ia=!0,Hs=!0,pr=!0),K.id!==$&&($=K.id,Hs=!0),ia||j!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),ve.setValue(V,"projectionMatrix",I.projectionMatrix),ve.setValue(V,"viewMatrix",I.matrixWorldInverse);let Nn=ve.map.cameraPosition;Nn!==void 0&&Nn.setValue(V,Yn.setFromMatrixPosition(I.matrixWorld)),me.logarithmicDepthBuffer&&ve.setValue(V,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&ve.setValue(V,"isOrthographic",I.isOrthographicCamera===!0),j!==I&&(j=I,Hs=!0,pr=!0)}if(Ht.needsLights&&(Ln.state.sunShadowMap.length>0&&ve.setValue(V,"sunShadowMap",Ln.state.sunShadowMap,te),Ln.state.directionalShadowMap.length>0&&ve.setValue(V,"directionalShadowMap",Ln.state.directionalShadowMap,te),Ln.state.spotShadowMap.length>0&&ve.setValue(V,"spotShadowMap",Ln.state.spotShadowMap,te),Ln.state.pointShadowMap.length>0&&ve.setValue(V,"pointShadowMap",Ln.state.pointShadowMap,te)),Q.isSkinnedMesh){ve.setOptional(V,Q,"bindMatrix"),ve.setOptional(V,Q,"bindMatrixInverse");let Ye=Q.skeleton;Ye&&(Ye.boneTexture===null&&Ye.computeBoneTexture(),ve.setValue(V,"boneTexture",Ye.boneTexture,te))}Q.isBatchedMesh&&(ve.setOptional(V,Q,"batchingTexture"),ve.setValue(V,"batchingTexture",Q._matricesTexture,te),ve.setOptional(V,Q,"batchingIdTexture"),ve.setValue(V,"batchingIdTexture",Q._indirectTexture,te),ve.setOptional(V,Q,"batchingColorTexture"),Q._colorsTexture!==null&&ve.setValue(V,"batchingColorTexture",Q._colorsTexture,te));let xi=it.morphAttributes;if((xi.position!==void 0||xi.normal!==void 0||xi.color!==void 0)&&lt.update(Q,it,Dn),(Hs||Ht.receiveShadow!==Q.receiveShadow)&&(Ht.receiveShadow=Q.receiveShadow,ve.setValue(V,"receiveShadow",Q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&q.environment!==null&&(Sn.envMapIntensity.value=q.environmentIntensity),Sn.dfgLUT!==void 0&&(Sn.dfgLUT.value=$C()),Hs){if(ve.setValue(V,"toneMappingExposure",L.toneMappingExposure),Ht.needsLights&&ea(Sn,pr),It&&K.fog===!0&&St.refreshFogUniforms(Sn,It),St.refreshMaterialUniforms(Sn,K,At,Tt,E.state.transmissionRenderTarget[I.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let Ye=b,Nn=0;for(let ai of E.state.lightProbeGridArray)ai.texture!==null&&(Ye.textures[Nn]=ai.texture,Ye.min[Nn]=ai.boundingBox.min,Ye.max[Nn]=ai.boundingBox.max,Ye.resolution[Nn]=ai.resolution,Nn++);for(let ai in Ye)Ye[ai].length=Nn;Sn.probesSH.value=Ye.textures,Sn.probesMin.value=Ye.min,Sn.probesMax.value=Ye.max,Sn.probesResolution.value=Ye.resolution}Za.upload(V,kr(Ht),Sn,te)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Za.upload(V,kr(Ht),Sn,te),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&ve.setValue(V,"center",Q.center),ve.setValue(V,"modelViewMatrix",Q.modelViewMatrix),ve.setValue(V,"normalMatrix",Q.normalMatrix),ve.setValue(V,"modelMatrix",Q.matrixWorld),K.uniformsGroups!==void 0){let Ye=K.uniformsGroups;for(let Nn=0,ai=Ye.length;Nn<ai;Nn++){let Eu=Ye[Nn];jt.update(Eu,Dn),jt.bind(Eu,Dn)}}return Dn}function ea(I,q){I.ambientLightColor.needsUpdate=q,I.lightProbe.needsUpdate=q,I.sunLights.needsUpdate=q,I.sunLightShadows.needsUpdate=q,I.directionalLights.needsUpdate=q,I.directionalLightShadows.needsUpdate=q,I.pointLights.needsUpdate=q,I.pointLightShadows.needsUpdate=q,I.spotLights.needsUpdate=q,I.spotLightShadows.needsUpdate=q,I.rectAreaLights.needsUpdate=q,I.hemisphereLights.needsUpdate=q}function zr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return N},this.getRenderTarget=function(){return Z},this.setRenderTargetTextures=function(I,q,it){let K=Yt.get(I);K.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Yt.get(I.texture).__webglTexture=q,Yt.get(I.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:it,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,q){let it=Yt.get(I);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(I,q=0,it=0){Z=I,P=q,N=it;let K=null,Q=!1,It=!1;if(I){let Lt=Yt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(V.FRAMEBUFFER,Lt.__webglFramebuffer),et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),$=-1;return}else if(Lt.__webglFramebuffer===void 0)te.setupRenderTarget(I);else if(Lt.__hasExternalTextures)te.rebindTextures(I,Yt.get(I.texture).__webglTexture,Yt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let le=I.depthTexture;if(Lt.__boundDepthTexture!==le){if(le!==null&&Yt.has(le)&&(I.width!==le.image.width||I.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");te.setupDepthRenderbuffer(I)}}let Ft=I.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(It=!0);let qt=Yt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray(qt[q])?K=qt[q][it]:K=qt[q],Q=!0):I.samples>0&&te.useMultisampledRTT(I)===!1?K=Yt.get(I).__webglMultisampledFramebuffer:Array.isArray(qt)?K=qt[it]:K=qt,et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else et.copy(Zt).multiplyScalar(At).floor(),dt.copy(we).multiplyScalar(At).floor(),ft=ye;if(it!==0&&(K=W),Ct.bindFramebuffer(V.FRAMEBUFFER,K)&&Ct.drawBuffers(I,K),Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),Q){let Lt=Yt.get(I.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+q,Lt.__webglTexture,it)}else if(It){let Lt=q;for(let Ft=0;Ft<I.textures.length;Ft++){let qt=Yt.get(I.textures[Ft]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+Ft,qt.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Yt.get(I.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Lt.__webglTexture,it)}$=-1};function na(I){let q=Yt.get(I);return(q.__readFormat!==I.format||q.__readType!==I.type)&&(q.__readFormat=I.format,q.__readType=I.type,q.__formatReadable=me.textureFormatReadable(I.format),q.__typeReadable=me.textureTypeReadable(I.type)),q}this.readRenderTargetPixels=function(I,q,it,K,Q,It,Ut,Lt=0){if(!(I&&I.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Ct.bindFramebuffer(V.FRAMEBUFFER,Ft);try{let qt=I.textures[Lt],le=qt.format,Ae=qt.type;I.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Lt);let $t=na(qt);if($t.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($t.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=I.width-K&&it>=0&&it<=I.height-Q&&V.readPixels(q,it,K,Q,Mt.convert(le),Mt.convert(Ae),It)}finally{let qt=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer(V.FRAMEBUFFER,qt)}}},this.readRenderTargetPixelsAsync=async function(I,q,it,K,Q,It,Ut,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(q>=0&&q<=I.width-K&&it>=0&&it<=I.height-Q){Ct.bindFramebuffer(V.FRAMEBUFFER,Ft);let qt=I.textures[Lt],le=qt.format,Ae=qt.type;I.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+Lt);let $t=na(qt);if($t.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($t.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Re=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,Re),V.bufferData(V.PIXEL_PACK_BUFFER,It.byteLength,V.STREAM_READ),V.readPixels(q,it,K,Q,Mt.convert(le),Mt.convert(Ae),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let _n=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer(V.FRAMEBUFFER,_n);let qe=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await J_(V,qe,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,Re),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,It),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(Re),V.deleteSync(qe),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,q=null,it=0){let K=Math.pow(2,-it),Q=Math.floor(I.image.width*K),It=Math.floor(I.image.height*K),Ut=q!==null?q.x:0,Lt=q!==null?q.y:0;te.setTexture2D(I,0),V.copyTexSubImage2D(V.TEXTURE_2D,it,0,0,Ut,Lt,Q,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,q,it=null,K=null,Q=0,It=0){let Ut,Lt,Ft,qt,le,Ae,$t,Re,_n,qe=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ut=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Ft=it.isBox3?it.max.z-it.min.z:1,qt=it.min.x,le=it.min.y,Ae=it.isBox3?it.min.z:0;else{let ve=Math.pow(2,-Q);Ut=Math.floor(qe.width*ve),Lt=Math.floor(qe.height*ve),I.isDataArrayTexture?Ft=qe.depth:I.isData3DTexture?Ft=Math.floor(qe.depth*ve):Ft=1,qt=0,le=0,Ae=0}K!==null?($t=K.x,Re=K.y,_n=K.z):($t=0,Re=0,_n=0);let Xe=Mt.convert(q.format),kn=Mt.convert(q.type),Ht;q.isData3DTexture?(te.setTexture3D(q,0),Ht=V.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(te.setTexture2DArray(q,0),Ht=V.TEXTURE_2D_ARRAY):(te.setTexture2D(q,0),Ht=V.TEXTURE_2D),Ct.activeTexture(V.TEXTURE0),Ct.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,q.flipY),Ct.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ct.pixelStorei(V.UNPACK_ALIGNMENT,q.unpackAlignment);let Ln=Ct.getParameter(V.UNPACK_ROW_LENGTH),Pe=Ct.getParameter(V.UNPACK_IMAGE_HEIGHT),fr=Ct.getParameter(V.UNPACK_SKIP_PIXELS),Dn=Ct.getParameter(V.UNPACK_SKIP_ROWS),ia=Ct.getParameter(V.UNPACK_SKIP_IMAGES);Ct.pixelStorei(V.UNPACK_ROW_LENGTH,qe.width),Ct.pixelStorei(V.UNPACK_IMAGE_HEIGHT,qe.height),Ct.pixelStorei(V.UNPACK_SKIP_PIXELS,qt),Ct.pixelStorei(V.UNPACK_SKIP_ROWS,le),Ct.pixelStorei(V.UNPACK_SKIP_IMAGES,Ae);let Hs=I.isDataArrayTexture||I.isData3DTexture,pr=q.isDataArrayTexture||q.isData3DTexture;if(I.isDepthTexture){let ve=Yt.get(I),Sn=Yt.get(q),xi=Yt.get(ve.__renderTarget),Ye=Yt.get(Sn.__renderTarget);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,xi.__webglFramebuffer),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,Ye.__webglFramebuffer);for(let Nn=0;Nn<Ft;Nn++)Hs&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Yt.get(I).__webglTexture,Q,Ae+Nn),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Yt.get(q).__webglTexture,It,_n+Nn)),V.blitFramebuffer(qt,le,qt+Ut,le+Lt,$t,Re,$t+Ut,Re+Lt,V.DEPTH_BUFFER_BIT,V.NEAREST);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(Q!==0||I.isRenderTargetTexture||Yt.has(I)){let ve=Yt.get(I),Sn=Yt.get(q);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,B),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,X);for(let xi=0;xi<Ft;xi++)Hs?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,ve.__webglTexture,Q,Ae+xi):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,ve.__webglTexture,Q),pr?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Sn.__webglTexture,It,_n+xi):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Sn.__webglTexture,It),Q!==0?V.blitFramebuffer(qt,le,qt+Ut,le+Lt,$t,Re,$t+Ut,Re+Lt,V.COLOR_BUFFER_BIT,V.NEAREST):pr?V.copyTexSubImage3D(Ht,It,$t,Re,_n+xi,qt,le,Ut,Lt):V.copyTexSubImage2D(Ht,It,$t,Re,qt,le,Ut,Lt);Ct.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else pr?I.isDataTexture||I.isData3DTexture?V.texSubImage3D(Ht,It,$t,Re,_n,Ut,Lt,Ft,Xe,kn,qe.data):q.isCompressedArrayTexture?V.compressedTexSubImage3D(Ht,It,$t,Re,_n,Ut,Lt,Ft,Xe,qe.data):V.texSubImage3D(Ht,It,$t,Re,_n,Ut,Lt,Ft,Xe,kn,qe):I.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,It,$t,Re,Ut,Lt,Xe,kn,qe.data):I.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,It,$t,Re,qe.width,qe.height,Xe,qe.data):V.texSubImage2D(V.TEXTURE_2D,It,$t,Re,Ut,Lt,Xe,kn,qe);Ct.pixelStorei(V.UNPACK_ROW_LENGTH,Ln),Ct.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Pe),Ct.pixelStorei(V.UNPACK_SKIP_PIXELS,fr),Ct.pixelStorei(V.UNPACK_SKIP_ROWS,Dn),Ct.pixelStorei(V.UNPACK_SKIP_IMAGES,ia),It===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&V.generateMipmap(Ht),Ct.unbindTexture()},this.initRenderTarget=function(I){Yt.get(I).__webglFramebuffer===void 0&&te.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?te.setTextureCube(I,0):I.isData3DTexture?te.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?te.setTexture2DArray(I,0):te.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){P=0,N=0,Z=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return us}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ie._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ie._getUnpackColorSpace()}};var Od={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Bt={},XC=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],Fy=matchMedia("(prefers-color-scheme: dark)");function Bd(){let n=M.theme==="dark"||M.theme==="auto"&&Fy.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of XC)Bt[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Bt.dark=n,Bt.curves=Od[n?"dark":"light"].curves}function kd(n){M.theme=n,Bd(),ht("theme")}Fy.addEventListener("change",()=>{M.theme==="auto"&&(Bd(),ht("theme"))});var Oy={type:"change"},Qm={type:"start"},ky={type:"end"},zd=new Tr,By=new si,YC=Math.cos(70*ao.DEG2RAD),Vn=new H,Bi=2*Math.PI,ke={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Km=1e-6,Hd=class extends Ac{constructor(t,e=null){super(t,e),this.state=ke.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:io.ROTATE,MIDDLE:io.DOLLY,RIGHT:io.PAN},this.touches={ONE:so.ROTATE,TWO:so.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new un,this._lastTargetPosition=new H,this._quat=new un().setFromUnitVectors(t.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wa,this._sphericalDelta=new Wa,this._scale=1,this._panOffset=new H,this._rotateStart=new Xt,this._rotateEnd=new Xt,this._rotateDelta=new Xt,this._panStart=new Xt,this._panEnd=new Xt,this._panDelta=new Xt,this._dollyStart=new Xt,this._dollyEnd=new Xt,this._dollyDelta=new Xt,this._dollyDirection=new H,this._mouse=new Xt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=jC.bind(this),this._onPointerDown=ZC.bind(this),this._onPointerUp=JC.bind(this),this._onContextMenu=sP.bind(this),this._onMouseWheel=tP.bind(this),this._onKeyDown=eP.bind(this),this._onTouchStart=nP.bind(this),this._onTouchMove=iP.bind(this),this._onMouseDown=KC.bind(this),this._onMouseMove=QC.bind(this),this._interceptControlDown=rP.bind(this),this._interceptControlUp=oP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ke.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Oy),this.update(),this.state=ke.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Vn.copy(e).sub(this.target),Vn.applyQuaternion(this._quat),this._spherical.setFromVector3(Vn),this.autoRotate&&this.state===ke.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Bi:i>Math.PI&&(i-=Bi),s<-Math.PI?s+=Bi:s>Math.PI&&(s-=Bi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Vn.setFromSpherical(this._spherical),Vn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Vn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Vn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new H(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Vn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(zd.origin.copy(this.object.position),zd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(zd.direction))<YC?this.object.lookAt(this.target):(By.setFromNormalAndCoplanarPoint(this.object.up,this.target),zd.intersectPlane(By,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Km||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Km||this._lastTargetPosition.distanceToSquared(this.target)>Km?(this.dispatchEvent(Oy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Bi/60*this.autoRotateSpeed*t:Bi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Vn.setFromMatrixColumn(e,0),Vn.multiplyScalar(-t),this._panOffset.add(Vn)}_panUp(t,e){this.screenSpacePanning===!0?Vn.setFromMatrixColumn(e,1):(Vn.setFromMatrixColumn(e,0),Vn.crossVectors(this.object.up,Vn)),Vn.multiplyScalar(t),this._panOffset.add(Vn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Vn.copy(s).sub(this.target);let r=Vn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Bi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Bi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Bi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Bi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Xt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function ZC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function jC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function JC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(ky),this.state=ke.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function KC(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case io.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=ke.DOLLY;break;case io.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ke.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ke.ROTATE}break;case io.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ke.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ke.PAN}break;default:this.state=ke.NONE}this.state!==ke.NONE&&this.dispatchEvent(Qm)}function QC(n){switch(this.state){case ke.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case ke.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case ke.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function tP(n){this.enabled===!1||this.enableZoom===!1||this.state!==ke.NONE||(n.preventDefault(),this.dispatchEvent(Qm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(ky))}function eP(n){this.enabled!==!1&&this._handleKeyDown(n)}function nP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case so.ROTATE:if(this.enableRotate===!1){this.state=ke.NONE;break}this._handleTouchStartRotate(n),this.state=ke.TOUCH_ROTATE;break;case so.PAN:if(this.enablePan===!1){this.state=ke.NONE;break}this._handleTouchStartPan(n),this.state=ke.TOUCH_PAN;break;default:this.state=ke.NONE}break;case 2:switch(this.touches.TWO){case so.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=ke.TOUCH_DOLLY_PAN;break;case so.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=ke.TOUCH_DOLLY_ROTATE;break;default:this.state=ke.NONE}break;default:this.state=ke.NONE}this.state!==ke.NONE&&this.dispatchEvent(Qm)}function iP(n){switch(this._trackPointer(n),this.state){case ke.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case ke.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case ke.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case ke.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=ke.NONE}}function sP(n){this.enabled!==!1&&n.preventDefault()}function rP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function oP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var zy=[1,.75,.55,.42],aP=30,lP=17,cP=400,Hy=6e6;function Gy(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Gd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(Hy/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>aP&&this.level<zy.length-1?this.level+=1:i<lP&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*zy[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(Hy/this.area),.5))),this.draw()},cP)}};var $y=32,qy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},hn=new uc,ze=new Si($y,1,.01,100);ze.up.set(0,0,1);var ns,An,fs,Vd,tg=!1,Xy=!1,ng=0;function _e(){tg||!Xy||(tg=!0,requestAnimationFrame(Yy))}function Yy(n=performance.now()){tg=!1,Vd.moving(n),ig()}var Zy=[],jy=n=>Zy.push(n);function ig(){for(let n of Zy)n();ns.render(hn,ze),ng+=1}function Jy(){Xy=!0,_e()}function Ja(n){return ig(),n(ns.domElement)}var Ky=()=>ng,Qy=()=>!!Vd?.software;hn.fog=new cc("#fff",1,10);function Vy(n){let t=document.createElement("canvas");t.width=fs.clientWidth||1,t.height=fs.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>uP.has(s)?i(s):null,e}var uP=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function tv(n){fs=n;let t=Vy(!1),e=Gy(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=Vy(!0)),ns=new Nd({canvas:t.canvas,context:t}),ns.debug.checkShaderErrors=!1,Vd=new Gd(e,ns,ig,i=>ht("hurry",i)),ns.domElement.setAttribute("aria-hidden","true"),fs.append(ns.domElement),An=new Hd(ze,ns.domElement),An.enableDamping=!1,An.addEventListener("change",_e),An.addEventListener("end",()=>{zc=!nv(),Bo=null}),new ResizeObserver(hP).observe(fs),fs.tabIndex=0,fs.setAttribute("role","application"),fs.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),fs.addEventListener("keydown",dP)}function hP(){let n=fs.clientWidth,t=fs.clientHeight;!n||!t||(Vd.resized(n,t),ns.setSize(n,t),ze.aspect=n/t,ze.updateProjectionMatrix(),ng?Yy():_e(),Ka())}function dP(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)fP(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")Wy(1/1.15);else if(n.key==="-")Wy(1.15);else if(n.key.toLowerCase()==="f")$d(ko);else if(e)sg(e);else return;n.preventDefault()}function fP(n,t){let e=ze.position.clone().sub(An.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);ze.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(An.target),An.update(),_e()}function Wy(n){ze.position.sub(An.target).multiplyScalar(n).add(An.target),An.update(),_e()}var ko=[[0,0,0],[0,0,1]];function ev(n,t){let e=new Fi().setFromPoints(n.map(u=>new H(...u))),i=e.getCenter(new H),s=new H(...t).normalize(),r=new H().crossVectors(ze.up,s).normalize(),o=new H().crossVectors(s,r),a=Math.tan(ao.degToRad($y/2))*.8,l=a*ze.aspect,c=e.getSize(new H).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,m=1/0,y=-1/0;for(let p of n){let g=new H(...p).sub(i),x=g.dot(r),T=g.dot(o),b=g.dot(s);h=Math.max(h,b+Math.abs(x)/l,b+Math.abs(T)/a),d=Math.min(d,T),f=Math.max(f,T),m=Math.min(m,x),y=Math.max(y,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(m+y)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var eg=0;function Wd({target:n,position:t},e=.35){let i={t:An.target.clone(),p:ze.position.clone()},s=performance.now(),r=++eg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==eg)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);An.target.lerpVectors(i.t,n,u),ze.position.lerpVectors(i.p,t,u);let h=ze.position.distanceTo(An.target);ze.near=h/100,ze.far=h*30,hn.fog.near=h*1.3,hn.fog.far=h*3.4,ze.updateProjectionMatrix(),An.update(),_e(),c<1&&requestAnimationFrame(a)})(s)}function $d(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){ko=n,i||(Bo=null),zc=!1;let s=e?qy[e]:ze.position.clone().sub(An.target).toArray();Wd(ev(n,s),t?0:.35)}function sg(n){zc=!1,Bo=null,Wd(ev(ko,qy[n]))}var zc=!1;function nv(){ze.updateMatrixWorld();let n=new H;return ko.every(t=>(n.set(...t).project(ze),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Ka(){zc||!An.enabled||!ko.length||nv()||(Bo??={position:ze.position.clone(),target:An.target.clone()},$d(ko,{byItself:!0}))}var Bo=null;function iv(){if(!Bo||zc||!An.enabled)return;let n=Bo;Bo=null,Wd(n),setTimeout(Ka,500)}var rg=n=>{ko=n},Qa=()=>[...ze.position.toArray(),...An.target.toArray()].map(n=>Number(n.toPrecision(5)));function sv(n){eg+=1,Wd({position:new H(...n.slice(0,3)),target:new H(...n.slice(3))},0)}var ar=null,og={cell:.1};function ag(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;og.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(Bt.gridFine),l=new ee(Bt.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}ar?.geometry.dispose();let c=new Me;c.setAttribute("position",new Te(r,3)),c.setAttribute("color",new Te(o,3)),ar?ar.geometry=c:(ar=new Po(c,new Qi({vertexColors:!0})),ar.renderOrder=-2,ar.material.depthWrite=!1,hn.add(ar)),ar.userData.reach=n,_e()}function lg(){hn.background=new ee(Bt.ground),hn.fog.color.set(Bt.ground),ar&&ag(ar.userData.reach),_e()}function ki(n){ze.updateMatrixWorld();let t=new H(...n).project(ze),e=fs.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function qd(n){let t=n.joints.length,e=li(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function cg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=Ep(n,t),u=(d,f,m,y=!0,p=m)=>{ls(Ni(f,d))<=l||(s.rods.push({a:d,b:f,r:m,far:p}),y&&s.balls.push({at:f,r:p}))};a&&(s.pedestal={at:Qt(t[0]),dir:qs(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:m},y)=>{let p=r[y],g=n.joints[y],x=Qt(t[y]),T=Qt(t[y+1]),b=p*.62,A=p*.84,E=(r[y+1]??e.rest)*.62,_=(r[y-1]??p)*.84;if(n.convention==="standard"){let X=Gl(x,f,Hl(Ni(T,x),f));u(x,X,b),u(X,T,A,!0,E)}else u(x,d,_,!0,b),u(d,T,b);let S=d,U=Hl(Ni(T,d),f);h&&ls(Ni(d,h.at))<.5*p&&Math.abs(U)>l?S=Gl(d,f,Math.sign(U)*Math.min(Math.abs(U)*.55,h.r+p*1.15)):y===0&&Math.abs(U)>2.2*p&&(S=Gl(d,f,Math.sign(U)*p*1.25));let L=p*2.15,D=qs(t[y+1],0),z=!!(i&&ug(g,i[y])),W=qs(t[0],2),B=Hl(Ni(S,Qt(t[0])),W)-L/2;y===0&&g.type==="R"&&Math.abs(Hl(f,W))>.99&&B<0&&B>-L&&(S=Gl(S,W,-B)),g.type==="R"?s.drums.push({at:S,dir:f,x:m,turned:D,r:p,h:L,beyond:z,joint:y}):s.sleeves.push({at:S,dir:f,x:m,r:p*.95,h:p*3.4,beyond:z,joint:y}),h={at:d,r:p}}),a){let d=t[a+1],f=Qt(t[a]);s.flange={at:f,dir:qs(t[a],2),turned:qs(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,Qt(d),e.rest*.34,!1),s.tip={at:Qt(d),r:e.rest*.42}}return s}function ug(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function Hc(n,t){let e=qd(n).radius[0]??.05,i=Qt(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(Qt)];for(let{point:r}of Ep(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function mP(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new bc(s.map(([a,l])=>new Xt(a,l)),n):new Ai(1,1,1,n),o={rod:i(new Ai(1,1,1,n,1,!0)),ball:t>3?new Rs(1,n,t):new Mc(1,0),drum:i(r),box:new Oi(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var rv=new Map,pg=(n,t)=>rv.get(n)??rv.set(n,mP(n,t)).get(n),gP=()=>pg(26,12),hg=()=>pg(11,5),ov=()=>pg(6,3),Yd=class{constructor(t){this.mesh=new Ze(new Me,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Me,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new Be(c,l).setUsage(Cd);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new Be(o,1).setUsage(Cd)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let m=t.at[d+2]>0?c:a,y=m*t.at[d],p=m*t.at[d+1],g=l*t.at[d+2],x=t.normal[d]/a,T=t.normal[d+1]/a,b=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*y+r[A]*p+o[A]*g,this.normal[f+A]=s[A]*x+r[A]*T+o[A]*b}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},lv=[1,0,0],xP=[0,1,0],cv=[0,0,1];function _P(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Ru(n,Math.abs(n[2])<.9?cv:lv),i=Ru(n,e),s=ls(i)||1,r=i.map(o=>o/s);return[Ru(r,n),r]}var dg=0,Xd=1,fg=2,av=3,tl=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new Tn,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new Yd(t),this.group.add(this.body.mesh),e&&(this.flat=new Yd(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?ov:hg:this.moving?hg:gP;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?ov():hg(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,u,h,d,f,m,y,p)=>t.put(c,u,h,..._P(d,y),d,f,m,p),l=(c,u,h)=>t.put(i.ball,c,u,lv,xP,cv,h,h);for(let{a:c,b:u,r:h,far:d}of e.rods){let f=Ni(u,c),m=ls(f),y=[(c[0]+u[0])/2,(c[1]+u[1])/2,(c[2]+u[2])/2];a(i.rod,dg,y,f.map(p=>p/m),r*h,m,null,r*(d??h))}for(let{at:c,r:u}of e.balls)l(dg,c,r*u);for(let{at:c,dir:u,turned:h,r:d,h:f,beyond:m}of e.drums){if(a(i.drum,m&&o?av:Xd,c,u,r*d,r*f),!o)continue;a(i.rod,fg,c,u,d*1.012,f*.13);let y=[0,1,2].map(p=>c[p]+h[p]*d*.96);a(i.box,dg,y,u,d*.11,f*.86,h)}for(let{at:c,dir:u,x:h,r:d,h:f,beyond:m}of e.sleeves)a(i.box,m&&o?av:Xd,c,u,r*d,r*f,h);if(e.pedestal&&!this.veil){let{at:c,dir:u,r:h,h:d}=e.pedestal;a(i.drum,Xd,[c[0]+u[0]*d/2,c[1]+u[1]*d/2,c[2]+u[2]*d/2],u,h,d)}if(e.flange&&a(i.drum,Xd,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:c,dir:u,turned:h,r:d,h:f}=e.flange;a(i.box,fg,[0,1,2].map(m=>c[m]+h[m]*d*.95),u,d*.16,f*1.04,h)}e.tip&&o&&l(fg,e.tip.at,e.tip.r)}};var yP=`
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
  }`,uv=`
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
  }`,vP=`
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
  }`,bP=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Zd({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new Ri({vertexShader:e?vP:yP,fragmentShader:e?bP:uv,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function hv(n){let t=new Ri({vertexShader:`
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
      }`,fragmentShader:uv.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?ir:di,uniforms:{colour:{value:new ee},opacity:{value:1},gloss:{value:.14},sky:{value:new ee},ground:{value:new ee}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function mg(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Me;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let m in h.attributes){if(!i.has(m))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+m+'" attribute exists among all geometries, or in none of them.'),null;r[m]===void 0&&(r[m]=[]),r[m].push(h.attributes[m]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let m in h.morphAttributes){if(!s.has(m))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[m].length!==n[0].morphAttributes[m].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+m+'" morph attribute.'),null;o[m]===void 0&&(o[m]=[]),o[m].push(h.morphAttributes[m]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let m;if(e)m=h.index.count;else if(h.attributes.position!==void 0)m=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,m,u),c+=m}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let m=0;m<f.count;++m)h.push(f.getX(m)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=dv(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let y=0;y<o[u].length;++y)f.push(o[u][y][d]);let m=dv(f);if(!m)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(m)}}}return l}function dv(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new Be(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let m=0;m<e;m++){let y=u.getComponent(d,m);a.setComponent(d+h,m,y)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var Lr=Od.axes;function gg(n,t){let e=new Ai(.028,.028,.82,8).translate(0,.41,0),i=new Lo(.085,.22,12).translate(0,.9,0),s=mg([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new Be(o,3)),s}var xg=n=>new ge().makeRotationFromQuaternion(new un().setFromUnitVectors(new H(0,1,0),new H(...n))),MP=mg([gg(Lr[0],xg([1,0,0])),gg(Lr[1],xg([0,1,0])),gg(Lr[2],xg([0,0,1]))]),fv=.021,Gc=new Map;function SP(n){let t=`${n}/${Bt.dark}`;if(Gc.has(t))return Gc.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=Bt.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=Bt.ink,s.fillText(n,e.width/2,e.height/2);let o=new xc(e);o.colorSpace=ii;let a=new za({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,Gc.set(t,a),a}var el=class{constructor(){this.group=new Tn,this.mesh=new mc(MP,new ri({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new ge;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new H(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new fc);a.parent||this.group.add(a),a.material=SP(r),a.scale.set(fv*a.material.userData.aspect,fv,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of Gc.values())t.map.dispose(),t.dispose();Gc.clear(),this.last&&this.show(...this.last)}};var yg=180/Math.PI,zi={angle:"deg",length:"mm"},wP={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},_g={deg:yg,rad:1,mm:1e3,m:1},EP={deg:2,rad:4,mm:2,m:5},TP={deg:1,rad:.02,mm:5,m:.005},xt={get angle(){return zi.angle},get length(){return zi.length},set(n,t){t in _g&&n in zi&&(zi[n]=t)},factor:n=>n in zi?_g[zi[n]]:1,symbol:n=>n in zi?wP[zi[n]]:"",digits:n=>n in zi?EP[zi[n]]:4,step:n=>n in zi?TP[zi[n]]/_g[zi[n]]:.01,suffix:n=>n==="angle"?{deg:yg,"\xB0":yg,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ei(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var dn=(n,t,e=xt.digits(t))=>ei(n*xt.factor(t),e),ue=(n,t,e)=>`${dn(n,t,e)}${t==="angle"&&zi.angle==="deg"?"":" "}${xt.symbol(t)}`,Vc=(n,t="plain")=>String(Number((n*xt.factor(t)).toPrecision(9))+0),jd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function nl(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||xt.digits(t))/xt.factor(t)}var AP={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},RP={theta:(n,t,e)=>`turn by \u03B8${n} = ${ue(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${ue(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${ue(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${ue(t,"angle")} about x`};function pv(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=AP[n.convention],o=gr(n.joints[i],xr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:wx(n.convention,a.a,a.alpha,a.d,a.theta)}}function mv(){let n=v("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>v("button",{type:"button",text:o,"aria-label":a,on:{click:()=>i(l())}}),e=()=>4*M.table.joints.length-1,i=o=>{M.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ht("frames")},s=v("details",{class:"fold","data-testid":"dh-steps"},v("summary",{text:"The frames, one step at a time"}),v("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(M.dhStep??1)-1),t("On","One step on",()=>(M.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(M.dhStep===null||!M.table.joints.length){M.dhStep=null,gt(n,"");return}M.dhStep=Math.min(M.dhStep,e());let{i:o,key:a,value:l}=pv(M.table,M.q,M.dhStep),c=M.table.convention==="standard"?o:o+1;gt(n,`Joint ${o+1}, ${M.dhStep%4+1} of 4: ${RP[a](o+1,l,c)}`)};return nt(["q","table","units"],()=>M.dhStep!==null&&r()),nt("panel",o=>{o!=="table"&&M.dhStep!==null&&(s.open=!1,i(null))}),s}function Jd(){let{i:n,A:t}=pv(M.table,M.q,M.dhStep);return[...M.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:zn(M.frames[n],t),name:`\u2192 ${n+1}`}]}var vg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],il=n=>[Math.cos(n),Math.sin(n)];function CP([n,t,e]){let[i,s]=il(e),[r,o]=il(t),[a,l]=il(n);return vg([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function PP(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function IP([n,t,e]){let[i,s]=il(n),[r,o]=il(t),[a,l]=il(e);return vg([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function LP(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Kd(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function Wc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return vg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function DP(n){let[t,e,i,s]=Kd(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function NP([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:Wc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Ls={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:PP,from:CP},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:LP,from:IP},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:DP,from:NP},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Kd,from:Wc}};function gv(n,t,e){let i=Ls[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Qd(n,t,e){let i=Kd(n),s=Kd(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=Wc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var sl=.145,nf=.105,Rg=.165,xv={mouse:13,pen:16,touch:28},UP=.2,uo=["x","y","z"],qc=72,zo=new Tn,ef=new Map,wg="both",sf="local",Cg=0,Dr=!1,Eg=null,tn=null,rf=()=>tn!==null,Mv=()=>Dr,lo=null,co=null;function Sv(){zo.visible=!1,hn.add(zo),jy(Pg),co=document.getElementById("view"),lo=v("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(lo),co.addEventListener("pointerdown",GP,!0),co.addEventListener("pointermove",WP,!0);for(let n of["pointerup","pointercancel"])co.addEventListener(n,Iv,!0);addEventListener("keydown",n=>n.key==="Escape"&&tn&&qP()),nt(["target","theme"],_e)}function $c(n,t,e=8){let i=new ri({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new Ze(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var FP=[new un().setFromUnitVectors(new H(0,1,0),new H(1,0,0)),new un,new un().setFromUnitVectors(new H(0,1,0),new H(0,0,1))],OP=[new un().setFromUnitVectors(new H(0,0,1),new H(1,0,0)),new un().setFromUnitVectors(new H(0,0,1),new H(0,1,0)),new un];function BP(){if(ef.size)return;let n=(t,e)=>{ef.set(t,e),zo.add(e)};uo.forEach((t,e)=>{let i=new Ai(.0032,.0032,sl*.8,8).translate(0,sl*.45,0),s=new Lo(.0125,.034,14).translate(0,sl*.9,0),r=new Tn;r.add($c(i,Lr[e]),$c(s,Lr[e])),r.userData.turn=FP[e],n(`move-${t}`,r);let o=$c(new Ga(nf,.0026,6,qc),Lr[e],7);o.userData.turn=OP[e],n(`turn-${t}`,o)}),n("turn-view",$c(new Ga(Rg,.0022,6,qc),"#8891a0",7)),n("move-view",$c(new Rs(.0115,14,10),"#8891a0",9))}var tf=new H,ho=new H,bg=new un;function of(){return 2*Math.tan(ao.degToRad(ze.fov/2))*ze.position.distanceTo(tf)}var Yc=()=>sf==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):kP(),kP=()=>[0,1,2].map(n=>qs(M.target,n)),zP=new ge;function Pg(){if(zo.visible=Dr,!Dr)return;tf.set(...Qt(M.target)),ho.copy(ze.position).sub(tf).normalize(),sf==="world"?bg.identity():bg.setFromRotationMatrix(zP.set(...M.target)),zo.position.copy(tf),zo.scale.setScalar(of());let n=Yc();for(let[t,e]of ef){let[i,s]=t.split("-"),r=uo.indexOf(s),o=wg==="both"||wg===i;e.visible=o&&HP(i,n[r])&&(!tn||tn.name===t),s==="view"?e.quaternion.copy(ze.quaternion):e.quaternion.copy(bg).multiply(e.userData.turn);let a=t===(tn?.name??Eg);e.traverse(l=>l.material?.color.set(a?Bt.accent:l.userData.colour))}}function HP(n,t){return!t||n!=="move"?!0:Math.hypot(...wv(t,ho.toArray()))>UP}var wv=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Xc=(n,t)=>Qt(M.target).map((e,i)=>e+t*n[i]);function Tg(n,t){let e=Yc(),[i,s]=n<0?[_v(ze.matrixWorld,0),_v(ze.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:qc+1},(r,o)=>{let a=2*Math.PI*o/qc,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:Xc(l,t),front:n<0||l.reduce((c,u,h)=>c+u*ho.getComponent(h),0)>-.15}})}var _v=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function yv(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function Ag(n,t){let e=of(),i=[];for(let[s,r]of ef){if(!r.visible)continue;let[o,a]=s.split("-"),l=uo.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=ki(Qt(M.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=Yc()[l],h=ki(Xc(u,.92*sl*e));c=Math.min(yv(n,t,ki(Xc(u,.3*sl*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Tg(l,(l<0?Rg:nf)*e).map(h=>({...h,s:ki(h.p)}));for(let h=0;h<qc;h++)u[h].front&&(c=Math.min(c,yv(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Ev(n){if(!Dr)return null;Pg();let[t]=Ag(n.clientX,n.clientY);return t&&t[1]<=(xv[n.pointerType]??xv.mouse)?t[0]:null}function Tv(){if(!Dr)return{};Pg();let n=of(),t=Yc(),e={"move-view":ki(Qt(M.target))};return uo.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>ki(Xc(t[s],c*sl*n))).find(([c,u])=>Ag(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=Tg(s,nf*n).filter(c=>c.front).map(c=>ki(c.p)).filter(([c,u])=>Ag(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=ki(Tg(-1,Rg*n)[9].p),e}var vv=new Tc,bv=new Xt;function Av(n){let t=ns.domElement.getBoundingClientRect();return bv.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),vv.setFromCamera(bv,ze),vv.ray}function Rv(n,t,e){let{origin:i,direction:s}=Av(e),r=new H(...n),o=new H(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function Cv(n,t,e){let i=new si().setFromNormalAndCoplanarPoint(n,new H(...t));return Av(e).intersectPlane(i,new H)}function GP(n){if(n.button!==0)return;let t=Ev(n);if(!t)return;n.stopPropagation(),n.preventDefault(),co.focus({preventScroll:!0}),co.setPointerCapture(n.pointerId),An.enabled=!1;let[e,i]=t.split("-"),s=uo.indexOf(i),r=s<0?ho.toArray():Yc()[s].slice();tn={name:t,what:e,axis:r,i:s,T:M.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},tn.start=e==="turn"?Pv(n):s<0?Cv(ho,Qt(tn.T),n):Rv(r,Qt(tn.T),n),_e()}function Pv(n){let[t,e]=ki(Qt(tn.T)),i=tn.axis.reduce((h,d,f)=>h+d*ho.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=wv(tn.axis,ho.toArray()),r=of(),o=ki(Qt(tn.T)),a=ki(Xc(s,nf*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-tn.x)*l+(n.clientY-tn.y)*c)/(u*u)}var VP=n=>Math.atan2(Math.sin(n),Math.cos(n)),Mg=(n,t,e)=>{let i=Cg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function WP(n){if(!tn){if(n.buttons||!Dr)return;let l=Ev(n);l!==Eg&&(Eg=l,co.style.setProperty("cursor",l?"grab":""),_e());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=tn,r=sf==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Pv(n);tn.total+=VP(l-(tn.before??tn.start)),tn.before=l;let c=Mg(tn.total,n,Math.PI/180),u=Math.sin(c/2);o=zn(Wc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${Sg(c,"angle")} about ${s<0?"the line of sight":r+uo[s]}`}else if(s<0){let l=Cv(ho,Qt(t),n);if(!l)return;let c=l.sub(tn.start);(Cg||n.shiftKey)&&c.set(...c.toArray().map(u=>Mg(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${uo[h]} ${Sg(u,"length")}`).join(", ")}else{let l=Mg(Rv(e,Qt(t),n)-tn.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${Sg(l,"length")} along ${r}${uo[s]}`}bi(o,"drag"),$P(a,n),_e()}var Sg=(n,t)=>`${n>=0?"+":""}${ue(n,t,xt.digits(t))}`;function $P(n,t){let e=co.getBoundingClientRect();lo.hidden=!1,gt(lo,n),lo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-lo.offsetWidth-8)}px`),lo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Iv(n){tn&&(n.stopPropagation(),tn=null,lo.hidden=!0,An.enabled=!0,bi(M.target,"dropped"),_e())}function qP(){let{T:n}=tn;bi(n,"drag"),Iv({stopPropagation(){}})}function Lv(){Dr&&BP(),zo.visible=Dr,ht("frames"),_e()}function Dv(n){Dr=n,Lv()}function Nv(n){wg=n,Lv()}function Uv(n){sf=n,_e()}function Fv(n){Cg=n}var Hv=Zd(),Bv=[.32,-.4,1],uf=new ri({color:"#000",transparent:!0,opacity:.1,side:di,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Rm,stencilRef:1,stencilZPass:Am,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),Dg=new ge().set(1,0,-Bv[0],0,0,1,-Bv[1],0,0,0,0,5e-4,0,0,0,1),rl=new Ze(new vc(1,40),new Ri({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));rl.renderOrder=-1;function XP(){let n=M.frames[0],t=2*(lr.radius[0]??0);rl.visible=M.table.joints.length>0&&Math.abs(n[11])<.02*lr.size&&n[10]>.99,rl.position.set(n[3],n[7],4e-4*lr.size),rl.scale.set(1.6*t,1.6*t,1)}var Jc=new tl(Hv,{shadow:{material:uf,matrix:Dg}});function Gv(n,t){Jc.shown(n,n&&!t)}var Vv=Zd({opacity:.2,veil:!0}),af=new tl(Vv,{veil:!0}),Wv=Zd({opacity:.62,gloss:.1}),Lg=new tl(Wv,{veil:!0}),hf=new el,lr=qd(M.table),df=[],cf=null;function $v(){hn.add(rl,Jc.group,af.group,Lg.group,hf.group),af.group.renderOrder=1,nt("table",n=>{lr=qd(M.table),ag(lr.size),df=[],cf=null,Ng(),pf(),n==="new"&&Kc({instant:!0,view:"iso"}),Jy()}),nt("q",ZP),nt("frames",Yv),nt("theme",zv),nt("hurry",n=>{for(let t of[Jc,af,Lg])t.hurry(n)}),zv()}var kv=new Map,jc=[],Ig=0;function Ur(n,t){if(kv.set(n,t),jc=[...kv.values()].flat(),!M.table.joints.length)return;let e=Ig;Ig=jc.length,rg([...Hc(M.table,M.frames),...jc]),t.length?Xv():e>Ig&&YP()}var YP=js(iv,120);function qv(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Ur("motion",i.flatMap(s=>Hc(n,Ss(n,s))))}function Kc(n){$d([...Hc(M.table,M.frames),...jc],n)}var Xv=js(Ka,220);function ZP(){let n=M.frames;Jc.show(M.table.joints.length?[cg(M.table,n,lr,M.q)]:[]),XP(),rg([...Hc(M.table,n),...jc]),Xv(),tb&&jP(Qt(n[n.length-1])),Yv()}function Yv(){let n=(M.shownFrames??[]).filter(t=>t<M.frames.length&&!(t===M.frames.length-1&&Mv())).map(t=>({T:M.frames[t],name:ff(t)}));hf.show(M.dhStep===null?n:Jd(),lr.size*.13),_e()}var Zv=()=>Jc.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),jv=()=>(hf.last?.[0]??[]).map(n=>n.name);function ff(n){let t=M.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function Jv(n){df=n,Ng()}function ps(n){cf=n,Ng()}var Kv=()=>df.length;function Ng(){let n=t=>cg(M.table,Ss(M.table,t),lr);af.show(df.map(n)),Lg.show(cf?[n(cf)]:[]),_e()}var Qv=6e3,lf=new Float32Array(6*Qv),Nr=new Po(new Me,new Qi({fog:!1}));Nr.geometry.setAttribute("position",new Be(lf,3));Nr.frustumCulled=!1;Nr.visible=!1;var fo=0,tb=!0,Zc=null;hn.add(Nr);function jP(n){let t=Zc?ls(Ni(n,Zc)):1/0;t<lr.size*.002||(t<lr.size*.2&&(fo===Qv&&(lf.copyWithin(0,6*1e3),fo-=1e3),lf.set(Zc,6*fo),lf.set(n,6*fo+3),fo+=1,Nr.geometry.setDrawRange(0,2*fo),Nr.geometry.attributes.position.needsUpdate=!0,Nr.visible=!0),Zc=n)}function eb(n){tb=n,n||pf(),_e()}function pf(){fo=0,Zc=null,Nr.visible=!1,_e()}var nb=()=>fo,Qc=new er(new Me,new Qi({fog:!1}));Qc.frustumCulled=!1;var tu=new Ar(new Me,new nr({size:4,sizeAttenuation:!1,fog:!1}));tu.frustumCulled=!1;Qc.visible=tu.visible=!1;hn.add(Qc,tu);function Ho(n){Ur("path",n);let t=new Float32Array(n.flat());for(let e of[Qc,tu])e.geometry.dispose(),e.geometry=new Me,e.geometry.setAttribute("position",new Be(t,3)),e.visible=n.length>0;_e()}function zv(){Hv.repaint(Bt.link,Bt.joint,Bt.accent,Bt.dark,Bt.wrong),Vv.repaint(Bt.ghost,Bt.ghost,Bt.ghost,Bt.dark),Wv.repaint(Bt.accent,Bt.accent,Bt.accent,Bt.dark),Nr.material.color.set(Bt.accent),Qc.material.color.set(Bt.trace),tu.material.color.set(Bt.trace),uf.opacity=Bt.dark?.28:.11,rl.material.uniforms.strength.value=Bt.dark?.75:.34,hf.paint(),_e()}var he={follow:!0,ghosts:"all",task:null,redundancy:null},Ug={answers:0},mf=!1,ib=Xs(async()=>{let n=mf;mf=!1;let t=M.target,e=M.table;try{let i=rf()||Fg,s=i?null:M.digits,{task:r,redundancy:o}=he,a=await Ue("ik",{T:t,q:M.q,brief:i,task:r,redundancy:o,digits:s});if(e!==M.table||t!==M.target&&!i)return;Ug.answers+=1,M.solutions={...a,T:t,brief:i},n&&he.follow&&a.nearest&&Ui(a.nearest,"follow"),ol(),ht("solutions"),!i&&!a.rows.some(l=>l.inside)&&QP(t),a.self_motions===null&&!i&&KP(M.solutions)}catch(i){if(i instanceof Du)return;M.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},ol(),ht("solutions")}}),Fg=!1;function sb(){Fg=!0,mf=!0,ib()}function Ds({follow:n=!1}={}){Fg=!1,mf||=n,ib()}var KP=Xs(async n=>{try{let t={T:n.T,q:M.q,task:he.task,redundancy:he.redundancy},{self_motions:e}=await Ue("self_motions",t);if(M.solutions!==n||!e)return;n.self_motions=e,ht("solutions")}catch{}}),QP=Xs(async n=>{try{let t=await Ue("nearest",{T:n,task:he.task});M.solutions&&M.solutions.T===n&&(M.solutions.near=t,ht("solutions"))}catch{}}),tI=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function ol(){let n=M.solutions?.rows??[],t=M.panel==="inverse"&&he.ghosts!=="none"?n.filter(e=>(he.ghosts==="all"||e.inside)&&!tI(e.q,M.q)):[];Jv(t.map(e=>e.q))}function rb(){nt("target",n=>{M.panel==="inverse"&&Ds({follow:Cx.has(n)})}),nt("task",()=>{ht("plan"),M.panel==="inverse"&&M.hasTarget&&Ds()}),nt("panel",n=>{ps(null),n==="inverse"&&M.hasTarget&&!M.solutions&&Ds(),ol()}),nt("moving",n=>{n||ol()}),nt("table",n=>{he.redundancy=null,n==="new"&&(he.task=null),ht("solutions"),n!=="new"&&M.panel==="inverse"&&M.hasTarget&&Ds()}),nt("online",n=>{n&&M.panel==="inverse"&&M.hasTarget&&M.table.joints.length&&Ds()})}var eu=0;function pi(){eu+=1,M.moving&&(M.moving=!1,ht("moving",!1))}function Pi(n,t=.8,e="move to a posture"){pi(),ht("let-go"),ht("did",{label:e});let i=M.q.slice(),s=eu,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),M.moving=!0,ht("moving",!0),new Promise(o=>{(function a(l){if(s!==eu||i.length!==M.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Ui(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(M.moving=!1,ht("moving",!1),o(!0))})(r)})}function ob(n,t,e,i){pi();let s=eu,r=performance.now()-1e3*n*t;M.moving=!0,ht("moving",!0),requestAnimationFrame(function o(a){if(s!==eu){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(M.moving=!1,ht("moving",!1),i?.(!0))})}var nI=200,iI=1500,Go=[],su=[],iu=null,nu={key:null,at:0,open:!1},Og=!1,gf=()=>({table:M.table,q:M.q,target:M.target,digits:M.digits,hasTarget:M.hasTarget,path:{...M.path},sequence:structuredClone(M.sequence),program:M.program,world:M.world,limits:M.limits,start:M.start,routing:M.routing,task:he.task,redundancy:he.redundancy});function Bg(){Og||(Og=!0,queueMicrotask(()=>{Og=!1,iu=gf()}))}function sI({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===nu.key&&(nu.open||i-nu.at<iI))&&iu&&(Go.push({label:n,before:iu}),Go.length>nI&&Go.shift(),su.length=0),nu={key:t,at:i,open:e},Bg(),ht("history")}function kg(){nu={key:null,at:0,open:!1}}function rI(n){pi(),kg(),he.task=n.task,n.table!==M.table?gn(n.table,{q:n.q,step:!1,what:"undo"}):Ui(n.q,"undo"),he.redundancy=n.redundancy,Object.assign(M.path,n.path),M.sequence=structuredClone(n.sequence),M.program=n.program,M.world=n.world,M.limits=n.limits,M.start=n.start;let t=M.routing!==n.routing;M.routing=n.routing,M.hasTarget=n.hasTarget,n.target!==M.target&&bi(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ht(e,"undo");t&&ht("routing","undo")}function ab(n,t,e){let i=n.pop();if(!i)return;let s=gf();rI(i.before),t.push({label:i.label,before:s}),Bg(),ht("history"),be(`${e}: ${i.label}`)}var zg=()=>ab(Go,su,"Undone"),Hg=()=>ab(su,Go,"Redone"),xf=()=>Go.at(-1)?.label??null,_f=()=>su.at(-1)?.label??null;function yf(){Go.length=0,su.length=0,kg(),iu=gf(),ht("history")}function lb(){iu=gf(),nt("did",sI),nt("let-go",kg),nt(["table","q","target","path","sequence","program","world","task","routing"],Bg)}var hb=1,db=30;function vf(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=M;return{pieper:hb,table:n,q:t,target:i?e:null,digits:M.digits,task:he.task,redundancy:he.redundancy,follow:he.follow,ghosts:he.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:M.program,start:M.start,limits:M.limits},world:M.world,routing:M.routing,look:M.look,panel:l,theme:c,units:[xt.angle,xt.length],camera:Qa()}}var Wn=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,xs=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Wn),ms=(n,t)=>typeof n=="string"?n.slice(0,t):"",gs=n=>{if(!xs(n,16))return null;let t=Cu(n);return t<1e-12?n.slice():t<.001?Pu(n):null},aI=n=>n&&Wn(n.metres)&&Wn(n.radians)?{metres:n.metres,radians:n.radians}:null,lI=n=>n&&[n.lower,n.upper,n.value].every(Wn)&&n.lower<=n.upper?{name:ms(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:ms(n.unit,10)}:null,cI=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>xs(e,t))?n:null;function uI(n){if(!n||!Array.isArray(n.joints)||n.joints.length>db||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Wn(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:ms(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Wn(i.lower)?i.lower:null,upper:Wn(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>xs(i,t.length)).slice(0,40));return{name:ms(n.name,60),convention:n.convention,joints:t,base:gs(n.base)??Yi(),tool:gs(n.tool)??Yi(),postures:e,manufacturer:ms(n.manufacturer,200),source:ms(n.source,2e3),notes:ms(n.notes,3e3),actuator:lI(n.actuator),catalog:ms(n.catalog,60)||void 0,derived:ms(n.derived,60)||void 0,coupling:cI(n.coupling,t.length)}}var cb={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function hI(n,t){if(!n||!Object.hasOwn(cb,n.kind))return null;let e=cb[n.kind];if(e)return Wn(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(l=>Number.isInteger(l)&&l>=1&&l<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return gs(n.T)?{kind:"frame",T:gs(n.T)}:null;let i=n.kind==="joint"&&xs(n.q,t)?n.q.slice():null,s=gs(n.T),r=n.kind==="circle"&&xs(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!gs(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(gs):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(l,c)=>c===null?{}:{[l]:c};return{kind:n.kind,...a("q",i),T:s,...a("via",gs(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",Wn(n.speed)&&n.speed>0?n.speed:null),blend:Wn(n.blend)&&n.blend>=0?n.blend:0}}var Gg={frame:[],box:["size"],cylinder:["r","h"]};function dI(n){if(!n||!Object.hasOwn(Gg,n.kind))return null;let t=gs(n.T),e=ms(n.name,40),i=s=>s==="size"?xs(n.size,3)&&n.size.every(r=>r>0):Wn(n[s])&&n[s]>0;return!t||!e||!Gg[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(Gg[n.kind].map(s=>[s,n[s]]))}}function fI(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&Wn(s.turn)&&xs(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:ms(s.branch,80)}:null,i=(s,r)=>Wn(s)&&s>=0&&s<r?s:0;return{turn:xs(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function pI(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};M.program=e(i.steps,s=>hI(s,t),200),M.start=xs(i.start,t)?i.start.slice():null,M.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||Wn(r)&&r>0))),M.world=e(n.world,dI,60),M.routing=fI(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&Wn(n.look.opacity)&&(M.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function bf(n,t){let e=n&&n.pieper===hb?uI(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(xt.set("angle",n.units[0]),xt.set("length",n.units[1])),Object.hasOwn(Ls,n.notation)&&(M.notation=n.notation),["auto","light","dark"].includes(n.theme)&&kd(n.theme),M.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};gn(e,{q:xs(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(M.path,{from:gs(s.from),to:gs(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:Wn(s.seconds)&&s.seconds>0?s.seconds:5}),M.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&xs(a.q,i)&&Wn(a.seconds)&&Wn(a.hold)).slice(0,40).map(a=>({name:ms(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),pI(n,i),["pose","position","position+axis"].includes(n.task)&&(he.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&Wn(l));he.redundancy=r.length?Object.fromEntries(r.slice(0,db)):null,typeof n.follow=="boolean"&&(he.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(he.ghosts=n.ghosts);let o=gs(n.target);M.hasTarget=!!o,o&&bi(o,"restored",aI(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ht(a);t(n.panel),ht("path-loaded"),ht("routing","loaded"),ht("look","loaded"),xs(n.camera,6)&&sv(n.camera),Ui(M.q,"restored"),yf()}async function fb(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function Mf(){let n=await fb(new TextEncoder().encode(JSON.stringify(vf())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function pb(){let n=mI();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await fb(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var mb="pieper-workbench";function mI(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(mb)??"{}");return t&&n===location.href?t:null}catch{return null}}function gI(){if(M.table.joints.length)try{sessionStorage.setItem(mb,JSON.stringify({address:location.href,shown:vf()}))}catch{}}var ub=null,xI=js(async()=>{if(!M.table.joints.length)return;let n=await Mf();n!==ub&&(ub=n,history.replaceState(null,"",n))},600);function gb(){addEventListener("pagehide",gI),nt(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],xI)}var yI="uplot",vI="u-hz",bI="u-vt",MI="u-title",SI="u-wrap",wI="u-under",EI="u-over",TI="u-axis",$o="u-off",AI="u-select",RI="u-cursor-x",CI="u-cursor-y",PI="u-cursor-pt",II="u-legend",LI="u-live",DI="u-inline",NI="u-series",UI="u-marker",xb="u-label",FI="u-value",ou="width",au="height";var _b="bottom",al="left",Vg="right",o0="#000",yb=o0+"0",Wg="mousemove",vb="mousedown",$g="mouseup",bb="mouseenter",Mb="mouseleave",Sb="dblclick",OI="resize",BI="scroll",wb="change",Af="dppxchange",a0="--",pl=typeof window<"u",jg=pl?document:null,cl=pl?window:null,kI=pl?navigator:null,He,Sf;function Jg(){let n=devicePixelRatio;He!=n&&(He=n,Sf&&Qg(wb,Sf,Jg),Sf=matchMedia(`(min-resolution: ${He-.001}dppx) and (max-resolution: ${He+.001}dppx)`),qo(wb,Sf,Jg),cl.dispatchEvent(new CustomEvent(Af)))}function is(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Kg(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function fn(n,t,e){n.style[t]=e+"px"}function Ns(n,t,e,i){let s=jg.createElement(n);return t!=null&&is(s,t),e?.insertBefore(s,i),s}function _s(n,t){return Ns("div",n,t)}var Eb=new WeakMap;function cr(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Eb.get(n);r!=o&&(n.style.transform=r,Eb.set(n,r),t<0||e<0||t>i||e>s?is(n,$o):Kg(n,$o))}var Tb=new WeakMap;function Ab(n,t,e){let i=t+e,s=Tb.get(n);i!=s&&(Tb.set(n,i),n.style.background=t,n.style.borderColor=e)}var Rb=new WeakMap;function Cb(n,t,e,i){let s=t+""+e,r=Rb.get(n);s!=r&&(Rb.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var l0={passive:!0},zI={...l0,capture:!0};function qo(n,t,e,i){t.addEventListener(n,e,i?zI:l0)}function Qg(n,t,e,i){t.removeEventListener(n,e,l0)}pl&&Jg();function Us(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ss((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function iM(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var sM=n=>n!=null,rM=n=>n!=null&&n>0,Pf=iM(sM),HI=iM(rM);function GI(n,t,e,i=0,s=!1){let r=s?HI:Pf,o=s?rM:sM;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??en,l??-en]}function If(n,t,e,i){let s=Lb(n),r=Lb(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Fr:oM,a=s==1?ss:ys,l=r==1?ys:ss,c=a(o(qn(n))),u=l(o(qn(t))),h=ul(e,c),d=ul(e,u);return e==10&&(c<0&&(h=nn(h,-c)),u<0&&(d=nn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=uM(n,h),t=Lf(t,d)),[n,t]}function c0(n,t,e,i){let s=If(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var u0=.1,Pb={mode:3,pad:u0},cu={pad:0,soft:null,mode:0},VI={min:cu,max:cu};function Rf(n,t,e,i){return Df(e)?Ib(n,t,e):(cu.pad=e,cu.soft=i?0:null,cu.mode=i?3:0,Ib(n,t,VI))}function Fe(n,t){return n??t}function WI(n,t,e){for(t=Fe(t,0),e=Fe(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Ib(n,t,e){let i=e.min,s=e.max,r=Fe(i.pad,0),o=Fe(s.pad,0),a=Fe(i.hard,-en),l=Fe(s.hard,en),c=Fe(i.soft,en),u=Fe(s.soft,-en),h=Fe(i.mode,0),d=Fe(s.mode,0),f=t-n,m=Fr(f),y=Ii(qn(n),qn(t)),p=Fr(y),g=qn(p-m);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=en&&(r=0),d==2&&u!=-en&&(o=0)));let x=f||y||1e3,T=Fr(x),b=ul(10,ss(T)),A=x*(f==0?n==0?.1:1:r),E=nn(uM(n-A,b/10),24),_=n>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:en,S=Ii(a,E<_&&n>=_?_:Fs(_,E)),U=x*(f==0?t==0?.1:1:o),L=nn(Lf(t+U,b/10),24),D=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-en,z=Fs(l,L>D&&t<=D?D:Ii(D,L));return S==z&&S==0&&(z=100),[S,z]}var $I=new Intl.NumberFormat(pl?kI.language:"en-US"),h0=n=>$I.format(n),rs=Math,Tf=rs.PI,qn=rs.abs,ss=rs.floor,$n=rs.round,ys=rs.ceil,Fs=rs.min,Ii=rs.max,ul=rs.pow,Lb=rs.sign,Fr=rs.log10,oM=rs.log2,qI=(n,t=1)=>rs.sinh(n)*t,qg=(n,t=1)=>rs.asinh(n/t),en=1/0;function Db(n){return(Fr((n^n>>31)-(n>>31))|0)+1}function t0(n,t,e){return Fs(Ii(n,t),e)}function aM(n){return typeof n=="function"}function Le(n){return aM(n)?n:()=>n}var XI=()=>{},lM=n=>n,cM=(n,t)=>t,YI=n=>null,Nb=n=>!0,Ub=(n,t)=>n==t,ZI=/\.\d*?(?=9{6,}|0{6,})/gm,Xo=n=>{if(dM(n)||mo.has(n))return n;let t=`${n}`,e=t.match(ZI);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Xo(s)}e${r}`}return nn(n,i)};function Vo(n,t){return Xo(nn(Xo(n/t))*t)}function Lf(n,t){return Xo(ys(Xo(n/t))*t)}function uM(n,t){return Xo(ss(Xo(n/t))*t)}function nn(n,t=0){if(dM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return $n(i)/e}var mo=new Map;function hM(n){return((""+n).split(".")[1]||"").length}function hu(n,t,e,i){let s=[],r=i.map(hM);for(let o=t;o<e;o++){let a=qn(o),l=nn(ul(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:nn(u,h);s.push(d),mo.set(d,h)}}return s}var uu={},d0=[],hl=[null,null],po=Array.isArray,dM=Number.isInteger,jI=n=>n===void 0;function Fb(n){return typeof n=="string"}function Df(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function JI(n){return n!=null&&typeof n=="object"}var KI=Object.getPrototypeOf(Uint8Array),fM="__proto__";function dl(n,t=Df){let e;if(po(n)){let i=n.find(s=>s!=null);if(po(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=dl(n[s],t)}else e=n.slice()}else if(n instanceof KI)e=n.slice();else if(t(n)){e={};for(let i in n)i!=fM&&(e[i]=dl(n[i],t))}else e=n;return e}function On(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=fM&&(Df(n[s])?On(n[s],dl(i[s])):n[s]=dl(i[s]))}return n}var QI=0,t3=1,e3=2;function n3(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function i3(n,t){if(o3(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return a3(o[0])||(o=r3(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:t3,f=[];for(let m=0;m<u.length;m++){let y=u[m],p=r.get(l[m]);y===null?d!=QI&&(h[p]=y,d==e3&&f.push(p)):h[p]=y}n3(h,f,s),i.push(h)}}return i}var s3=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function r3(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function o3(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function a3(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Ii(1,ss((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var pM=["January","February","March","April","May","June","July","August","September","October","November","December"],mM=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function gM(n){return n.slice(0,3)}var l3=mM.map(gM),c3=pM.map(gM),u3={MMMM:pM,MMM:c3,WWWW:mM,WWW:l3};function ru(n){return(n<10?"0":"")+n}function h3(n){return(n<10?"00":n<100?"0":"")+n}var d3={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ru(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ru(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ru(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ru(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ru(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>h3(n.getMilliseconds())};function f0(n,t){t=t||u3;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?d3[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var f3=new Intl.DateTimeFormat().resolvedOptions().timeZone;function p3(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==f3?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var xM=n=>n%1==0,Cf=[1,2,2.5,5],m3=hu(10,-32,0,Cf),_M=hu(10,0,32,Cf),g3=_M.filter(xM),Wo=m3.concat(_M),p0=`
`,yM="{YYYY}",Ob=p0+yM,vM="{M}/{D}",lu=p0+vM,wf=lu+"/{YY}",bM="{aa}",x3="{h}:{mm}",ll=x3+bM,Bb=p0+ll,kb=":{ss}",$e=null;function MM(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?hu(10,0,3,Cf).filter(xM):hu(10,-3,0,Cf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,yM,$e,$e,$e,$e,$e,$e,1],[s*28,"{MMM}",Ob,$e,$e,$e,$e,$e,1],[s,vM,Ob,$e,$e,$e,$e,$e,1],[i,"{h}"+bM,wf,$e,lu,$e,$e,$e,1],[e,ll,wf,$e,lu,$e,$e,$e,1],[t,kb,wf+" "+ll,$e,lu+" "+ll,$e,Bb,$e,1],[n,kb+".{fff}",wf+" "+ll,$e,lu+" "+ll,$e,Bb,$e,1]];function u(h){return(d,f,m,y,p,g)=>{let x=[],T=p>=o,b=p>=r&&p<o,A=h(m),E=nn(A*n,3),_=Xg(A.getFullYear(),T?0:A.getMonth(),b||T?1:A.getDate()),S=nn(_*n,3);if(b||T){let U=b?p/r:0,L=T?p/o:0,D=E==S?E:nn(Xg(_.getFullYear()+L,_.getMonth()+U,1)*n,3),z=new Date($n(D/n)),W=z.getFullYear(),B=z.getMonth();for(let X=0;D<=y;X++){let P=Xg(W+L*X,B+U*X,1),N=P-h(nn(P*n,3));D=nn((+P+N)*n,3),D<=y&&x.push(D)}}else{let U=p>=s?s:p,L=ss(m)-ss(E),D=S+L+Lf(E-S,U);x.push(D);let z=h(D),W=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,B=p/i,X=d.axes[f]._space,P=g/X;for(;D=nn(D+p,n==1?0:3),!(D>y);)if(B>1){let N=ss(nn(W+B,6))%24,j=h(D).getHours()-N;j>1&&(j=-1),D-=j*i,W=(W+B)%24;let et=x[x.length-1];nn((D-et)/p,3)*P>=.7&&x.push(D)}else x.push(D)}return x}}return[l,c,u]}var[_3,y3,v3]=MM(1),[b3,M3,S3]=MM(.001);hu(2,-53,53,[1]);function zb(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Hb(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,d,f;return i.map(m=>{let y=n(m),p=y.getFullYear(),g=y.getMonth(),x=y.getDate(),T=y.getHours(),b=y.getMinutes(),A=y.getSeconds(),E=p!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||T!=h&&a[5]||b!=d&&a[6]||A!=f&&a[7]||a[1];return l=p,c=g,u=x,h=T,d=b,f=A,E(y)})}}function w3(n,t){let e=f0(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Xg(n,t,e){return new Date(n,t,e)}function Gb(n,t){return t(n)}var E3="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vb(n,t){return(e,i,s,r)=>r==null?a0:t(n(i))}function T3(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function A3(n,t){return n.series[t].fill(n,t)}var R3={show:!0,live:!0,isolate:!1,mount:XI,markers:{show:!0,width:2,stroke:T3,fill:A3,dash:"solid"},idx:null,idxs:null,values:[]};function C3(n,t){let e=n.cursor.points,i=_s(),s=e.size(n,t);fn(i,ou,s),fn(i,au,s);let r=s/-2;fn(i,"marginLeft",r),fn(i,"marginTop",r);let o=e.width(n,t,s);return o&&fn(i,"borderWidth",o),i}function P3(n,t){let e=n.series[t].points;return e._fill||e._stroke}function I3(n,t){let e=n.series[t].points;return e._stroke||e._fill}function L3(n,t){return n.series[t].points.size}var Yg=[0,0];function D3(n,t,e){return Yg[0]=t,Yg[1]=e,Yg}function Ef(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Zg(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var N3={show:!0,x:!0,y:!0,lock:!1,move:D3,points:{one:!1,show:C3,size:L3,width:0,stroke:I3,fill:P3},bind:{mousedown:Ef,mouseup:Ef,click:Ef,dblclick:Ef,mousemove:Zg,mouseleave:Zg,mouseenter:Zg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},SM={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},m0=On({},SM,{filter:cM}),wM=On({},m0,{size:10}),EM=On({},SM,{show:!1}),g0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',TM="bold "+g0,AM=1.5,Wb={show:!0,scale:"x",stroke:o0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:TM,side:2,grid:m0,ticks:wM,border:EM,font:g0,lineGap:AM,rotate:0},U3="Value",F3="Time",$b={show:!0,scale:"x",auto:!1,sorted:1,min:en,max:-en,idxs:[]};function O3(n,t,e,i,s){return t.map(r=>r==null?"":h0(r))}function B3(n,t,e,i,s,r,o){let a=[],l=mo.get(s)||0;e=o?e:nn(Lf(e,s),l);for(let c=e;c<=i;c=nn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function e0(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Fr:oM,u=ss(c(e));s=ul(l,u),l==10&&(s=Wo[Us(s,Wo)]);let h=e,d=s*l;l==10&&(d=Wo[Us(d,Wo)]);do a.push(h),h=h+s,l==10&&!mo.has(h)&&(h=nn(h,mo.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Wo[Us(d,Wo)]));while(h<=i);return a}function k3(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?e0(n,t,Ii(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?e0(n,t,Ii(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var RM=/./,z3=/[12357]/,H3=/[125]/,qb=/1/,n0=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function G3(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?RM:l(7,o)-u>=c?z3:l(5,o)-u>=c?H3:qb;if(h==qb){let d=qn(l(1,o)-u);if(d<c)return n0(t.slice().reverse(),a.distr,h,ys(c/d)).reverse()}return n0(t,a.distr,h,1)}function V3(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=qn(l(1,o)-l(2,o));return c<a?n0(t.slice().reverse(),3,RM,ys(a/c)).reverse():t}function W3(n,t,e,i){return i==null?a0:t==null?"":h0(t)}var Xb={show:!0,scale:"y",stroke:o0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:TM,side:3,grid:m0,ticks:wM,border:EM,font:g0,lineGap:AM,rotate:0};function $3(n,t){let e=3+(n||1)*2;return nn(e*t,3)}function q3(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=qn(o-r),l=n.series[t],c=a/(l.points.space*He);return i[1]-i[0]<=c}var Yb={scale:null,auto:!0,sorted:0,min:en,max:-en},CM=(n,t,e,i,s)=>s,Zb={show:!0,auto:!0,sorted:0,gaps:CM,alpha:1,facets:[On({},Yb,{scale:"x"}),On({},Yb,{scale:"y"})]},jb={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:CM,alpha:1,points:{show:q3,filter:null},values:null,min:en,max:-en,idxs:[],path:null,clip:null};function X3(n,t,e,i,s){return e/10}var PM={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Y3=On({},PM,{time:!1,ori:1}),Jb={};function IM(n,t){let e=Jb[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Jb[n]=e)),e}var fl=1,i0=2;function Yo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,y=a.height,p=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,p,g,d,f,m,y,Uf,ml,Of,DM,UM):e(s,l,c,u,h,g,p,f,d,y,m,Ff,gl,y0,NM,FM)}function x0(n,t){let e=0,i=0,s=Fe(n.bands,d0);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Z3(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Or(n,t,e,i,s,r){return Yo(n,t,(o,a,l,c,u,h,d,f,m,y,p)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),T=c.ori==0?ml:gl,b,A;x==1?(b=e,A=i):(b=i,A=e);let E=g(h(a[b],c,y,f)),_=g(d(l[b],u,p,m)),S=g(h(a[A],c,y,f)),U=g(d(r==1?u.max:u.min,u,p,m)),L=new Path2D(s);return T(L,S,U),T(L,E,U),T(L,E,_),L})}function Nf(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Of:y0,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function j3(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function _0(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),m=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let g=d+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=f&&a.push([f,m])}return a}function Kb(n){return n==0?lM:n==1?$n:t=>Vo(t,n)}function LM(n){let t=n==0?Uf:Ff,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Fs(c,a/2,l/2),u=Fs(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Uf=(n,t,e)=>{n.moveTo(t,e)},Ff=(n,t,e)=>{n.moveTo(e,t)},ml=(n,t,e)=>{n.lineTo(t,e)},gl=(n,t,e)=>{n.lineTo(e,t)},Of=LM(0),y0=LM(1),DM=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},NM=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},UM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},FM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function OM(n){return(t,e,i,s,r)=>Yo(t,e,(o,a,l,c,u,h,d,f,m,y,p)=>{let{pxRound:g,points:x}=o,T,b;c.ori==0?(T=Uf,b=DM):(T=Ff,b=NM);let A=nn(x.width*He,3),E=(x.size-x.width)/2*He,_=nn(E*2,3),S=new Path2D,U=new Path2D,{left:L,top:D,width:z,height:W}=t.bbox;Of(U,L-_,D-_,z+_*2,W+_*2);let B=X=>{if(l[X]!=null){let P=g(h(a[X],c,y,f)),N=g(d(l[X],u,p,m));T(S,P+E,N),b(S,P,N,E,0,Tf*2)}};if(r)r.forEach(B);else for(let X=i;X<=s;X++)B(X);return{stroke:A>0?S:null,fill:S,clip:U,flags:fl|i0}})}function BM(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var J3=BM(ml),K3=BM(gl);function kM(n){let t=Fe(n?.alignGaps,0);return(e,i,s,r)=>Yo(e,i,(o,a,l,c,u,h,d,f,m,y,p)=>{[s,r]=Pf(l,s,r);let g=o.pxRound,x=W=>g(h(W,c,y,f)),T=W=>g(d(W,u,p,m)),b,A;c.ori==0?(b=ml,A=J3):(b=gl,A=K3);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fl},S=_.stroke,U=!1;if(r-s>=y*4){let W=ft=>e.posToVal(ft,c.key,!0),B=null,X=null,P,N,Z,$=x(a[E==1?s:r]),j=x(a[s]),et=x(a[r]),dt=W(E==1?j+1:et-1);for(let ft=E==1?s:r;ft>=s&&ft<=r;ft+=E){let st=a[ft],_t=(E==1?st<dt:st>dt)?$:x(st),Tt=l[ft];_t==$?Tt!=null?(N=Tt,B==null?(b(S,_t,T(N)),P=B=X=N):N<B?B=N:N>X&&(X=N)):Tt===null&&(U=!0):(B!=null&&A(S,$,T(B),T(X),T(P),T(N)),Tt!=null?(N=Tt,b(S,_t,T(N)),B=X=P=N):(B=X=null,Tt===null&&(U=!0)),$=_t,dt=W($+E))}B!=null&&B!=X&&Z!=$&&A(S,$,T(B),T(X),T(P),T(N))}else for(let W=E==1?s:r;W>=s&&W<=r;W+=E){let B=l[W];B===null?U=!0:B!=null&&b(S,x(a[W]),T(B))}let[D,z]=x0(e,i);if(o.fill!=null||D!=0){let W=_.fill=new Path2D(S),B=o.fillTo(e,i,o.min,o.max,D),X=T(B),P=x(a[s]),N=x(a[r]);E==-1&&([N,P]=[P,N]),b(W,N,X),b(W,P,X)}if(!o.spanGaps){let W=[];U&&W.push(..._0(a,l,s,r,E,x,t)),_.gaps=W=o.gaps(e,i,s,r,W),_.clip=Nf(W,c.ori,f,m,y,p)}return z!=0&&(_.band=z==2?[Or(e,i,s,r,S,-1),Or(e,i,s,r,S,1)]:Or(e,i,s,r,S,z)),_})}function Q3(n){let t=Fe(n.align,1),e=Fe(n.ascDesc,!1),i=Fe(n.alignGaps,0),s=Fe(n.extend,!1);return(r,o,a,l)=>Yo(r,o,(c,u,h,d,f,m,y,p,g,x,T)=>{[a,l]=Pf(h,a,l);let b=c.pxRound,{left:A,width:E}=r.bbox,_=j=>b(m(j,d,x,p)),S=j=>b(y(j,f,T,g)),U=d.ori==0?ml:gl,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fl},D=L.stroke,z=d.dir*(d.ori==0?1:-1),W=S(h[z==1?a:l]),B=_(u[z==1?a:l]),X=B,P=B;s&&t==-1&&(P=A,U(D,P,W)),U(D,B,W);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let et=h[j];if(et==null)continue;let dt=_(u[j]),ft=S(et);t==1?U(D,dt,W):U(D,X,ft),U(D,dt,ft),W=ft,X=dt}let N=X;s&&t==1&&(N=A+E,U(D,N,W));let[Z,$]=x0(r,o);if(c.fill!=null||Z!=0){let j=L.fill=new Path2D(D),et=c.fillTo(r,o,c.min,c.max,Z),dt=S(et);U(j,N,dt),U(j,P,dt)}if(!c.spanGaps){let j=[];j.push(..._0(u,h,a,l,z,_,i));let et=c.width*He/2,dt=e||t==1?et:-et,ft=e||t==-1?-et:et;j.forEach(st=>{st[0]+=dt,st[1]+=ft}),L.gaps=j=c.gaps(r,o,a,l,j),L.clip=Nf(j,d.ori,p,g,x,T)}return $!=0&&(L.band=$==2?[Or(r,o,a,l,D,-1),Or(r,o,a,l,D,1)]:Or(r,o,a,l,D,$)),L})}function Qb(n,t,e,i,s,r,o=en){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=qn(n[l]-n[a]);u<c&&(c=u,o=qn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function t2(n){n=n||uu;let t=Fe(n.size,[.6,en,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Le(s),o=1-t[0],a=Fe(t[1],en),l=Fe(t[2],1),c=Fe(n.disp,uu),u=Fe(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,y,p)=>Yo(f,m,(g,x,T,b,A,E,_,S,U,L,D)=>{let z=g.pxRound,W=e,B=i*He,X=a*He,P=l*He,N,Z;b.ori==0?[N,Z]=r(f,m):[Z,N]=r(f,m);let $=b.dir*(b.ori==0?1:-1),j=b.ori==0?Of:y0,et=b.ori==0?u:(Nt,ie,me,Ct,Qe,Yt,te)=>{u(Nt,ie,me,Qe,Ct,te,Yt)},dt=Fe(f.bands,d0).find(Nt=>Nt.series[0]==m),ft=dt!=null?dt.dir:0,st=g.fillTo(f,m,g.min,g.max,ft),vt=z(_(st,A,D,U)),_t,Tt,At,Jt=L,pe=z(g.width*He),Zt=!1,we=null,ye=null,de=null,pn=null;h!=null&&(pe==0||d!=null)&&(Zt=!0,we=h.values(f,m,y,p),ye=new Map,new Set(we).forEach(Nt=>{Nt!=null&&ye.set(Nt,new Path2D)}),pe>0&&(de=d.values(f,m,y,p),pn=new Map,new Set(de).forEach(Nt=>{Nt!=null&&pn.set(Nt,new Path2D)})));let{x0:sn,size:Pn}=c;if(sn!=null&&Pn!=null){W=1,x=sn.values(f,m,y,p),sn.unit==2&&(x=x.map(me=>f.posToVal(S+me*L,b.key,!0)));let Nt=Pn.values(f,m,y,p);Pn.unit==2?Tt=Nt[0]*L:Tt=E(Nt[0],b,L,S)-E(0,b,L,S),Jt=Qb(x,T,E,b,L,S,Jt),At=Jt-Tt+B}else Jt=Qb(x,T,E,b,L,S,Jt),At=Jt*o+B,Tt=Jt-At;At<1&&(At=0),pe>=Tt/2&&(pe=0),At<5&&(z=lM);let Je=At>0,Yn=Jt-At-(Je?pe:0);Tt=z(t0(Yn,P,X)),_t=(W==0?Tt/2:W==$?0:Tt)-W*$*((W==0?B/2:0)+(Je?pe/2:0));let De={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bn=Zt?null:new Path2D,bn=null;if(dt!=null)bn=f.data[dt.series[1]];else{let{y0:Nt,y1:ie}=c;Nt!=null&&ie!=null&&(T=ie.values(f,m,y,p),bn=Nt.values(f,m,y,p))}let In=N*Tt,V=Z*Tt;for(let Nt=$==1?y:p;Nt>=y&&Nt<=p;Nt+=$){let ie=T[Nt];if(ie==null)continue;if(bn!=null){let J=bn[Nt]??0;if(ie-J==0)continue;vt=_(J,A,D,U)}let me=b.distr!=2||c!=null?x[Nt]:Nt,Ct=E(me,b,L,S),Qe=_(Fe(ie,st),A,D,U),Yt=z(Ct-_t),te=z(Ii(Qe,vt)),F=z(Fs(Qe,vt)),R=te-F;if(ie!=null){let J=ie<0?V:In,mt=ie<0?In:V;Zt?(pe>0&&de[Nt]!=null&&j(pn.get(de[Nt]),Yt,F+ss(pe/2),Tt,Ii(0,R-pe),J,mt),we[Nt]!=null&&j(ye.get(we[Nt]),Yt,F+ss(pe/2),Tt,Ii(0,R-pe),J,mt)):j(Bn,Yt,F+ss(pe/2),Tt,Ii(0,R-pe),J,mt),et(f,m,Nt,Yt-pe/2,F,Tt+pe,R)}}return pe>0?De.stroke=Zt?pn:Bn:Zt||(De._fill=g.width==0?g._fill:g._stroke??g._fill,De.width=0),De.fill=Zt?ye:Bn,De})}function e2(n,t){let e=Fe(t?.alignGaps,0);return(i,s,r,o)=>Yo(i,s,(a,l,c,u,h,d,f,m,y,p,g)=>{[r,o]=Pf(c,r,o);let x=a.pxRound,T=N=>x(d(N,u,p,m)),b=N=>x(f(N,h,g,y)),A,E,_;u.ori==0?(A=Uf,_=ml,E=UM):(A=Ff,_=gl,E=FM);let S=u.dir*(u.ori==0?1:-1),U=T(l[S==1?r:o]),L=U,D=[],z=[];for(let N=S==1?r:o;N>=r&&N<=o;N+=S)if(c[N]!=null){let $=l[N],j=T($);D.push(L=j),z.push(b(c[N]))}let W={stroke:n(D,z,A,_,E,x),fill:null,clip:null,band:null,gaps:null,flags:fl},B=W.stroke,[X,P]=x0(i,s);if(a.fill!=null||X!=0){let N=W.fill=new Path2D(B),Z=a.fillTo(i,s,a.min,a.max,X),$=b(Z);_(N,L,$),_(N,U,$)}if(!a.spanGaps){let N=[];N.push(..._0(l,c,r,o,S,T,e)),W.gaps=N=a.gaps(i,s,r,o,N),W.clip=Nf(N,u.ori,m,y,p,g)}return P!=0&&(W.band=P==2?[Or(i,s,r,o,B,-1),Or(i,s,r,o,B,1)]:Or(i,s,r,o,B,P)),W})}function n2(n){return e2(i2,n)}function i2(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var s0=new Set;function tM(){for(let n of s0)n.syncRect(!0)}pl&&(qo(OI,cl,tM),qo(BI,cl,tM,!0),qo(Af,cl,()=>{oi.pxRatio=He}));var s2=kM(),r2=OM();function eM(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>r0(r,o,t,e))}function o2(n,t){return n.map((e,i)=>i==0?{}:On({},t,e))}function r0(n,t,e,i){return On({},t==0?e:i,n)}function zM(n,t,e){return t==null?hl:[t,e]}var a2=zM;function l2(n,t,e){return t==null?hl:Rf(t,e,u0,!0)}function HM(n,t,e,i){return t==null?hl:If(t,e,n.scales[i].log,!1)}var c2=HM;function GM(n,t,e,i){return t==null?hl:c0(t,e,n.scales[i].log,!1)}var u2=GM;function h2(n,t,e,i,s){let r=Ii(Db(n),Db(t)),o=t-n,a=Us(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?mo.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function nM(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=$n((e=+s)*He))+"px"),[n,t,e]}function d2(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=nn(t[2]*He,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function oi(n,t,e){let i={mode:Fe(n.mode,1)},s=i.mode;function r(w,C,O,k){let Y=C.valToPct(w);return k+O*(C.dir==-1?1-Y:Y)}function o(w,C,O,k){let Y=C.valToPct(w);return k+O*(C.dir==-1?Y:1-Y)}function a(w,C,O,k){return C.ori==0?r(w,C,O,k):o(w,C,O,k)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=_s(yI);if(n.id!=null&&(c.id=n.id),is(c,n.class),n.title){let w=_s(MI,c);w.textContent=n.title}let u=Ns("canvas"),h=i.ctx=u.getContext("2d"),d=_s(SI,c);qo("click",d,w=>{w.target===m&&(on!=oa||mn!=aa)&&ni.click(i,w)},!0);let f=i.under=_s(wI,d);d.appendChild(u);let m=i.over=_s(EI,d);n=dl(n);let y=+Fe(n.pxAlign,1),p=Kb(y);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?eM(n.series||[],$b,jb,!1):o2(n.series||[null],Zb),T=i.axes=eM(n.axes||[],Wb,Xb,!0),b=i.scales={},A=i.bands=n.bands||[];A.forEach(w=>{w.fill=Le(w.fill||null),w.dir=Fe(w.dir,-1)});let E=s==2?x[1].facets[0].scale:x[0].scale,_={axes:pr,series:Re},S=(n.drawOrder||["axes","series"]).map(w=>_[w]);function U(w){let C=w.distr==3?O=>Fr(O>0?O:w.clamp(i,O,w.min,w.max,w.key)):w.distr==4?O=>qg(O,w.asinh):w.distr==100?O=>w.fwd(O):O=>O;return O=>{let k=C(O),{_min:Y,_max:tt}=w,ut=tt-Y;return(k-Y)/ut}}function L(w){let C=b[w];if(C==null){let O=(n.scales||uu)[w]||uu;if(O.from!=null){L(O.from);let k=On({},b[O.from],O,{key:w});k.valToPct=U(k),b[w]=k}else{C=b[w]=On({},w==E?PM:Y3,O),C.key=w;let k=C.time,Y=C.range,tt=po(Y);if((w!=E||s==2&&!k)&&(tt&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?Pb:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?Pb:{mode:1,hard:Y[1],soft:Y[1]}},tt=!1),!tt&&Df(Y))){let ut=Y;Y=(yt,Et,kt)=>Et==null?hl:Rf(Et,kt,ut)}C.range=Le(Y||(k?a2:w==E?C.distr==3?c2:C.distr==4?u2:zM:C.distr==3?HM:C.distr==4?GM:l2)),C.auto=Le(tt?!1:C.auto),C.clamp=Le(C.clamp||X3),C._min=C._max=null,C.valToPct=U(C)}}}L("x"),L("y"),s==1&&x.forEach(w=>{L(w.scale)}),T.forEach(w=>{L(w.scale)});for(let w in n.scales)L(w);let D=b[E],z=D.distr,W,B;D.ori==0?(is(c,vI),W=r,B=o):(is(c,bI),W=o,B=r);let X={};for(let w in b){let C=b[w];(C.min!=null||C.max!=null)&&(X[w]={min:C.min,max:C.max},C.min=C.max=null)}let P=n.tzDate||(w=>new Date($n(w/g))),N=n.fmtDate||f0,Z=g==1?v3(P):S3(P),$=Hb(P,zb(g==1?y3:M3,N)),j=Vb(P,Gb(E3,N)),et=[],dt=i.legend=On({},R3,n.legend),ft=i.cursor=On({},N3,{drag:{y:s==2}},n.cursor),st=dt.show,vt=ft.show,_t=dt.markers;dt.idxs=et,_t.width=Le(_t.width),_t.dash=Le(_t.dash),_t.stroke=Le(_t.stroke),_t.fill=Le(_t.fill);let Tt,At,Jt,pe=[],Zt=[],we,ye=!1,de={};if(dt.live){let w=x[1]?x[1].values:null;ye=w!=null,we=ye?w(i,1,0):{_:0};for(let C in we)de[C]=a0}if(st)if(Tt=Ns("table",II,c),Jt=Ns("tbody",null,Tt),dt.mount(i,Tt),ye){At=Ns("thead",null,Tt,Jt);let w=Ns("tr",null,At);Ns("th",null,w);for(var pn in we)Ns("th",xb,w).textContent=pn}else is(Tt,DI),dt.live&&is(Tt,LI);let sn={show:!0},Pn={show:!1};function Je(w,C){if(C==0&&(ye||!dt.live||s==2))return hl;let O=[],k=Ns("tr",NI,Jt,Jt.childNodes[C]);is(k,w.class),w.show||is(k,$o);let Y=Ns("th",null,k);if(_t.show){let yt=_s(UI,Y);if(C>0){let Et=_t.width(i,C);Et&&(yt.style.border=Et+"px "+_t.dash(i,C)+" "+_t.stroke(i,C)),yt.style.background=_t.fill(i,C)}}let tt=_s(xb,Y);w.label instanceof HTMLElement?tt.appendChild(w.label):tt.textContent=w.label,C>0&&(_t.show||(tt.style.color=w.width>0?_t.stroke(i,C):_t.fill(i,C)),De("click",Y,yt=>{if(ft._lock)return;oe(yt);let Et=x.indexOf(w);if((yt.ctrlKey||yt.metaKey)!=dt.isolate){let kt=x.some((zt,Gt)=>Gt>0&&Gt!=Et&&zt.show);x.forEach((zt,Gt)=>{Gt>0&&Gs(Gt,kt?Gt==Et?sn:Pn:sn,!0,Un.setSeries)})}else Gs(Et,{show:!w.show},!0,Un.setSeries)},!1),ae&&De(bb,Y,yt=>{ft._lock||(oe(yt),Gs(x.indexOf(w),ca,!0,Un.setSeries))},!1));for(var ut in we){let yt=Ns("td",FI,k);yt.textContent="--",O.push(yt)}return[k,O]}let Yn=new Map;function De(w,C,O,k=!0){let Y=Yn.get(C)||{},tt=ft.bind[w](i,C,O,k);tt&&(qo(w,C,Y[w]=tt),Yn.set(C,Y))}function Bn(w,C,O){let k=Yn.get(C)||{};for(let Y in k)(w==null||Y==w)&&(Qg(Y,C,k[Y]),delete k[Y]);w==null&&Yn.delete(C)}let bn=0,In=0,V=0,Nt=0,ie=0,me=0,Ct=ie,Qe=me,Yt=V,te=Nt,F=0,R=0,J=0,mt=0;i.bbox={};let ct=!1,St=!1,wt=!1,rt=!1,at=!1,bt=!1;function G(w,C,O){(O||w!=i.width||C!=i.height)&&lt(w,C),ve(!1),wt=!0,St=!0,ai()}function lt(w,C){i.width=bn=V=w,i.height=In=Nt=C,ie=me=0,Rt(),jt();let O=i.bbox;F=O.left=Vo(ie*He,.5),R=O.top=Vo(me*He,.5),J=O.width=Vo(V*He,.5),mt=O.height=Vo(Nt*He,.5)}let ot=3;function Pt(){let w=!1,C=0;for(;!w;){C++;let O=ia(C),k=Hs(C);w=C==ot||O&&k,w||(lt(i.width,i.height),St=!0)}}function Mt({width:w,height:C}){G(w,C)}i.setSize=Mt;function Rt(){let w=!1,C=!1,O=!1,k=!1;T.forEach((Y,tt)=>{if(Y.show&&Y._show){let{side:ut,_size:yt}=Y,Et=ut%2,kt=Y.label!=null?Y.labelSize:0,zt=yt+kt;zt>0&&(Et?(V-=zt,ut==3?(ie+=zt,k=!0):O=!0):(Nt-=zt,ut==0?(me+=zt,w=!0):C=!0))}}),ks[0]=w,ks[1]=O,ks[2]=C,ks[3]=k,V-=vs[1]+vs[3],ie+=vs[3],Nt-=vs[2]+vs[0],me+=vs[0]}function jt(){let w=ie+V,C=me+Nt,O=ie,k=me;function Y(tt,ut){switch(tt){case 1:return w+=ut,w-ut;case 2:return C+=ut,C-ut;case 3:return O-=ut,O+ut;case 0:return k-=ut,k+ut}}T.forEach((tt,ut)=>{if(tt.show&&tt._show){let yt=tt.side;tt._pos=Y(yt,tt._size),tt.label!=null&&(tt._lpos=Y(yt,tt.labelSize))}})}if(ft.dataIdx==null){let w=ft.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let O=w.prox=Le(w.prox),k=w.bias??=0;ft.dataIdx=(Y,tt,ut,yt)=>{if(tt==0)return ut;let Et=ut,kt=O(Y,tt,ut,yt)??en,zt=kt>=0&&kt<en,Gt=D.ori==0?V:Nt,fe=ft.left,Oe=t[0],Ne=t[tt];if(C.has(Ne[ut])){Et=null;let Ce=null,se=null,Kt;if(k==0||k==-1)for(Kt=ut;Ce==null&&Kt-- >0;)C.has(Ne[Kt])||(Ce=Kt);if(k==0||k==1)for(Kt=ut;se==null&&Kt++<Ne.length;)C.has(Ne[Kt])||(se=Kt);if(Ce!=null||se!=null)if(zt){let ln=Ce==null?-1/0:W(Oe[Ce],D,Gt,0),wn=se==null?1/0:W(Oe[se],D,Gt,0),Kn=fe-ln,Ke=wn-fe;Kn<=Ke?Kn<=kt&&(Et=Ce):Ke<=kt&&(Et=se)}else Et=se==null?Ce:Ce==null?se:ut-Ce<=se-ut?Ce:se}else zt&&qn(fe-W(Oe[ut],D,Gt,0))>kt&&(Et=null);return Et}}let oe=w=>{ft.event=w};ft.idxs=et,ft._lock=!1;let pt=ft.points;pt.show=Le(pt.show),pt.size=Le(pt.size),pt.stroke=Le(pt.stroke),pt.width=Le(pt.width),pt.fill=Le(pt.fill);let Wt=i.focus=On({},n.focus||{alpha:.3},ft.focus),ae=Wt.prox>=0,Dt=ae&&pt.one,xe=[],rn=[],gi=[];function Dl(w,C){let O=pt.show(i,C);if(O instanceof HTMLElement)return is(O,PI),is(O,w.class),cr(O,-10,-10,V,Nt),m.insertBefore(O,xe[C]),O}function ta(w,C){if(s==1||C>0){let O=s==1&&b[w.scale].time,k=w.value;w.value=O?Fb(k)?Vb(P,Gb(k,N)):k||j:k||W3,w.label=w.label||(O?F3:U3)}if(Dt||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||s2||YI,w.fillTo=Le(w.fillTo||Z3),w.pxAlign=+Fe(w.pxAlign,y),w.pxRound=Kb(w.pxAlign),w.stroke=Le(w.stroke||null),w.fill=Le(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let O=$3(Ii(1,w.width),1),k=w.points=On({},{size:O,width:Ii(1,O*.2),stroke:w.stroke,space:O*2,paths:r2,_stroke:null,_fill:null},w.points);k.show=Le(k.show),k.filter=Le(k.filter),k.fill=Le(k.fill),k.stroke=Le(k.stroke),k.paths=Le(k.paths),k.pxAlign=w.pxAlign}if(st){let O=Je(w,C);pe.splice(C,0,O[0]),Zt.splice(C,0,O[1]),dt.values.push(null)}if(vt){et.splice(C,0,null);let O=null;Dt?C==0&&(O=Dl(w,C)):C>0&&(O=Dl(w,C)),xe.splice(C,0,O),rn.splice(C,0,0),gi.splice(C,0,0)}Jn("addSeries",C)}function mp(w,C){C=C??x.length,w=s==1?r0(w,C,$b,jb):r0(w,C,{},Zb),x.splice(C,0,w),ta(x[C],C)}i.addSeries=mp;function wu(w){if(x.splice(w,1),st){dt.values.splice(w,1),Zt.splice(w,1);let C=pe.splice(w,1)[0];Bn(null,C.firstChild),C.remove()}vt&&(et.splice(w,1),xe.splice(w,1)[0].remove(),rn.splice(w,1),gi.splice(w,1)),Jn("delSeries",w)}i.delSeries=wu;let ks=[!1,!1,!1,!1];function hr(w,C){if(w._show=w.show,w.show){let O=w.side%2,k=b[w.scale];k==null&&(w.scale=O?x[1].scale:E,k=b[w.scale]);let Y=k.time;w.size=Le(w.size),w.space=Le(w.space),w.rotate=Le(w.rotate),po(w.incrs)&&w.incrs.forEach(ut=>{!mo.has(ut)&&mo.set(ut,hM(ut))}),w.incrs=Le(w.incrs||(k.distr==2?g3:Y?g==1?_3:b3:Wo)),w.splits=Le(w.splits||(Y&&k.distr==1?Z:k.distr==3?e0:k.distr==4?k3:B3)),w.stroke=Le(w.stroke),w.grid.stroke=Le(w.grid.stroke),w.ticks.stroke=Le(w.ticks.stroke),w.border.stroke=Le(w.border.stroke);let tt=w.values;w.values=po(tt)&&!po(tt[0])?Le(tt):Y?po(tt)?Hb(P,zb(tt,N)):Fb(tt)?w3(P,tt):tt||$:tt||O3,w.filter=Le(w.filter||(k.distr>=3&&k.log==10?G3:k.distr==3&&k.log==2?V3:cM)),w.font=nM(w.font),w.labelFont=nM(w.labelFont),w._size=w.size(i,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(ks[C]=!0,w._el=_s(TI,d))}}function dr(w,C,O,k){let[Y,tt,ut,yt]=O,Et=C%2,kt=0;return Et==0&&(yt||tt)&&(kt=C==0&&!Y||C==2&&!ut?$n(Wb.size/3):0),Et==1&&(Y||ut)&&(kt=C==1&&!tt||C==3&&!yt?$n(Xb.size/2):0),kt}let Nl=i.padding=(n.padding||[dr,dr,dr,dr]).map(w=>Le(Fe(w,dr))),vs=i._padding=Nl.map((w,C)=>w(i,C,ks,0)),Mn,Rn=null,Cn=null,zs=s==1?x[0].idxs:null,Wi=null,kr=!1;function Ul(w,C){if(t=w??[],i.data=i._data=t,s==2){Mn=0;for(let O=1;O<x.length;O++)Mn+=t[O][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Wi=t[0],Mn=Wi.length;let O=t;if(z==2){O=t.slice();let k=O[0]=Array(Mn);for(let Y=0;Y<Mn;Y++)k[Y]=Y}i._data=t=O}if(ve(!0),Jn("setData"),z==2&&(wt=!0),C!==!1){let O=D;O.auto(i,kr)?Fl():Gr(E,O.min,O.max),rt=rt||ft.left>=0,bt=!0,ai()}}i.setData=Ul;function Fl(){kr=!0;let w,C;s==1&&(Mn>0?(Rn=zs[0]=0,Cn=zs[1]=Mn-1,w=t[0][Rn],C=t[0][Cn],z==2?(w=Rn,C=Cn):w==C&&(z==3?[w,C]=If(w,w,D.log,!1):z==4?[w,C]=c0(w,w,D.log,!1):D.time?C=w+$n(86400/g):[w,C]=Rf(w,C,u0,!0))):(Rn=zs[0]=w=null,Cn=zs[1]=C=null)),Gr(E,w,C)}let ea,zr,na,I,q,it,K,Q,It,Ut;function Lt(w,C,O,k,Y,tt){w??=yb,O??=d0,k??="butt",Y??=yb,tt??="round",w!=ea&&(h.strokeStyle=ea=w),Y!=zr&&(h.fillStyle=zr=Y),C!=na&&(h.lineWidth=na=C),tt!=q&&(h.lineJoin=q=tt),k!=it&&(h.lineCap=it=k),O!=I&&h.setLineDash(I=O)}function Ft(w,C,O,k){C!=zr&&(h.fillStyle=zr=C),w!=K&&(h.font=K=w),O!=Q&&(h.textAlign=Q=O),k!=It&&(h.textBaseline=It=k)}function qt(w,C,O,k,Y=0){if(k.length>0&&w.auto(i,kr)&&(C==null||C.min==null)){let tt=Fe(Rn,0),ut=Fe(Cn,k.length-1),yt=O.min==null?GI(k,tt,ut,Y,w.distr==3):[O.min,O.max];w.min=Fs(w.min,O.min=yt[0]),w.max=Ii(w.max,O.max=yt[1])}}let le={min:null,max:null};function Ae(){for(let k in b){let Y=b[k];X[k]==null&&(Y.min==null||X[E]!=null&&Y.auto(i,kr))&&(X[k]=le)}for(let k in b){let Y=b[k];X[k]==null&&Y.from!=null&&X[Y.from]!=null&&(X[k]=le)}X[E]!=null&&ve(!0);let w={};for(let k in X){let Y=X[k];if(Y!=null){let tt=w[k]=dl(b[k],JI);if(Y.min!=null)On(tt,Y);else if(k!=E||s==2)if(Mn==0&&tt.from==null){let ut=tt.range(i,null,null,k);tt.min=ut[0],tt.max=ut[1]}else tt.min=en,tt.max=-en}}if(Mn>0){x.forEach((k,Y)=>{if(s==1){let tt=k.scale,ut=X[tt];if(ut==null)return;let yt=w[tt];if(Y==0){let Et=yt.range(i,yt.min,yt.max,tt);yt.min=Et[0],yt.max=Et[1],Rn=Us(yt.min,t[0]),Cn=Us(yt.max,t[0]),Cn-Rn>1&&(t[0][Rn]<yt.min&&Rn++,t[0][Cn]>yt.max&&Cn--),k.min=Wi[Rn],k.max=Wi[Cn]}else k.show&&k.auto&&qt(yt,ut,k,t[Y],k.sorted);k.idxs[0]=Rn,k.idxs[1]=Cn}else if(Y>0&&k.show&&k.auto){let[tt,ut]=k.facets,yt=tt.scale,Et=ut.scale,[kt,zt]=t[Y],Gt=w[yt],fe=w[Et];Gt!=null&&qt(Gt,X[yt],tt,kt,tt.sorted),fe!=null&&qt(fe,X[Et],ut,zt,ut.sorted),k.min=ut.min,k.max=ut.max}});for(let k in w){let Y=w[k],tt=X[k];if(Y.from==null&&(tt==null||tt.min==null)){let ut=Y.range(i,Y.min==en?null:Y.min,Y.max==-en?null:Y.max,k);Y.min=ut[0],Y.max=ut[1]}}}for(let k in w){let Y=w[k];if(Y.from!=null){let tt=w[Y.from];if(tt.min==null)Y.min=Y.max=null;else{let ut=Y.range(i,tt.min,tt.max,k);Y.min=ut[0],Y.max=ut[1]}}}let C={},O=!1;for(let k in w){let Y=w[k],tt=b[k];if(tt.min!=Y.min||tt.max!=Y.max){tt.min=Y.min,tt.max=Y.max;let ut=tt.distr;tt._min=ut==3?Fr(tt.min):ut==4?qg(tt.min,tt.asinh):ut==100?tt.fwd(tt.min):tt.min,tt._max=ut==3?Fr(tt.max):ut==4?qg(tt.max,tt.asinh):ut==100?tt.fwd(tt.max):tt.max,C[k]=O=!0}}if(O){x.forEach((k,Y)=>{s==2?Y>0&&C.y&&(k._paths=null):C[k.scale]&&(k._paths=null)});for(let k in C)wt=!0,Jn("setScale",k);vt&&ft.left>=0&&(rt=bt=!0)}for(let k in X)X[k]=null}function $t(w){let C=t0(Rn-1,0,Mn-1),O=t0(Cn+1,0,Mn-1);for(;w[C]==null&&C>0;)C--;for(;w[O]==null&&O<Mn-1;)O++;return[C,O]}function Re(){if(Mn>0){let w=x.some(C=>C._focus)&&Ut!=Wt.alpha;w&&(h.globalAlpha=Ut=Wt.alpha),x.forEach((C,O)=>{if(O>0&&C.show&&(_n(O,!1),_n(O,!0),C._paths==null)){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha);let Y=s==2?[0,t[O][0].length-1]:$t(t[O]);C._paths=C.paths(i,O,Y[0],Y[1]),Ut!=k&&(h.globalAlpha=Ut=k)}}),x.forEach((C,O)=>{if(O>0&&C.show){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha),C._paths!=null&&qe(O,!1);{let Y=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,O,Rn,Cn,Y),ut=C.points.filter(i,O,tt,Y);(tt||ut)&&(C.points._paths=C.points.paths(i,O,Rn,Cn,ut),qe(O,!0))}Ut!=k&&(h.globalAlpha=Ut=k),Jn("drawSeries",O)}}),w&&(h.globalAlpha=Ut=1)}}function _n(w,C){let O=C?x[w].points:x[w];O._stroke=O.stroke(i,w),O._fill=O.fill(i,w)}function qe(w,C){let O=C?x[w].points:x[w],{stroke:k,fill:Y,clip:tt,flags:ut,_stroke:yt=O._stroke,_fill:Et=O._fill,_width:kt=O.width}=O._paths;kt=nn(kt*He,3);let zt=null,Gt=kt%2/2;C&&Et==null&&(Et=kt>0?"#fff":yt);let fe=O.pxAlign==1&&Gt>0;if(fe&&h.translate(Gt,Gt),!C){let Oe=F-kt/2,Ne=R-kt/2,Ce=J+kt,se=mt+kt;zt=new Path2D,zt.rect(Oe,Ne,Ce,se)}C?Ht(yt,kt,O.dash,O.cap,Et,k,Y,ut,tt):Xe(w,yt,kt,O.dash,O.cap,Et,k,Y,ut,zt,tt),fe&&h.translate(-Gt,-Gt)}function Xe(w,C,O,k,Y,tt,ut,yt,Et,kt,zt){let Gt=!1;Et!=0&&A.forEach((fe,Oe)=>{if(fe.series[0]==w){let Ne=x[fe.series[1]],Ce=t[fe.series[1]],se=(Ne._paths||uu).band;po(se)&&(se=fe.dir==1?se[0]:se[1]);let Kt,ln=null;Ne.show&&se&&WI(Ce,Rn,Cn)?(ln=fe.fill(i,Oe)||tt,Kt=Ne._paths.clip):se=null,Ht(C,O,k,Y,ln,ut,yt,Et,kt,zt,Kt,se),Gt=!0}}),Gt||Ht(C,O,k,Y,tt,ut,yt,Et,kt,zt)}let kn=fl|i0;function Ht(w,C,O,k,Y,tt,ut,yt,Et,kt,zt,Gt){Lt(w,C,O,k,Y),(Et||kt||Gt)&&(h.save(),Et&&h.clip(Et),kt&&h.clip(kt)),Gt?(yt&kn)==kn?(h.clip(Gt),zt&&h.clip(zt),Pe(Y,ut),Ln(w,tt,C)):yt&i0?(Pe(Y,ut),h.clip(Gt),Ln(w,tt,C)):yt&fl&&(h.save(),h.clip(Gt),zt&&h.clip(zt),Pe(Y,ut),h.restore(),Ln(w,tt,C)):(Pe(Y,ut),Ln(w,tt,C)),(Et||kt||Gt)&&h.restore()}function Ln(w,C,O){O>0&&(C instanceof Map?C.forEach((k,Y)=>{h.strokeStyle=ea=Y,h.stroke(k)}):C!=null&&w&&h.stroke(C))}function Pe(w,C){C instanceof Map?C.forEach((O,k)=>{h.fillStyle=zr=k,h.fill(O)}):C!=null&&w&&h.fill(C)}function fr(w,C,O,k){let Y=T[w],tt;if(k<=0)tt=[0,0];else{let ut=Y._space=Y.space(i,w,C,O,k),yt=Y._incrs=Y.incrs(i,w,C,O,k,ut);tt=h2(C,O,yt,k,ut)}return Y._found=tt}function Dn(w,C,O,k,Y,tt,ut,yt,Et,kt){let zt=ut%2/2;y==1&&h.translate(zt,zt),Lt(yt,ut,Et,kt,yt),h.beginPath();let Gt,fe,Oe,Ne,Ce=Y+(k==0||k==3?-tt:tt);O==0?(fe=Y,Ne=Ce):(Gt=Y,Oe=Ce);for(let se=0;se<w.length;se++)C[se]!=null&&(O==0?Gt=Oe=w[se]:fe=Ne=w[se],h.moveTo(Gt,fe),h.lineTo(Oe,Ne));h.stroke(),y==1&&h.translate(-zt,-zt)}function ia(w){let C=!0;return T.forEach((O,k)=>{if(!O.show)return;let Y=b[O.scale];if(Y.min==null){O._show&&(C=!1,O._show=!1,ve(!1));return}else O._show||(C=!1,O._show=!0,ve(!1));let tt=O.side,ut=tt%2,{min:yt,max:Et}=Y,[kt,zt]=fr(k,yt,Et,ut==0?V:Nt);if(zt==0)return;let Gt=Y.distr==2,fe=O._splits=O.splits(i,k,yt,Et,kt,zt,Gt),Oe=Y.distr==2?fe.map(Kt=>Wi[Kt]):fe,Ne=Y.distr==2?Wi[fe[1]]-Wi[fe[0]]:kt,Ce=O._values=O.values(i,O.filter(i,Oe,k,zt,Ne),k,zt,Ne);O._rotate=tt==2?O.rotate(i,Ce,k,zt):0;let se=O._size;O._size=ys(O.size(i,Ce,k,w)),se!=null&&O._size!=se&&(C=!1)}),C}function Hs(w){let C=!0;return Nl.forEach((O,k)=>{let Y=O(i,k,ks,w);Y!=vs[k]&&(C=!1),vs[k]=Y}),C}function pr(){for(let w=0;w<T.length;w++){let C=T[w];if(!C.show||!C._show)continue;let O=C.side,k=O%2,Y,tt,ut=C.stroke(i,w),yt=O==0||O==3?-1:1,[Et,kt]=C._found;if(C.label!=null){let yi=C.labelGap*yt,Xi=$n((C._lpos+yi)*He);Ft(C.labelFont[0],ut,"center",O==2?"top":_b),h.save(),k==1?(Y=tt=0,h.translate(Xi,$n(R+mt/2)),h.rotate((O==3?-Tf:Tf)/2)):(Y=$n(F+J/2),tt=Xi);let So=aM(C.label)?C.label(i,w,Et,kt):C.label;h.fillText(So,Y,tt),h.restore()}if(kt==0)continue;let zt=b[C.scale],Gt=k==0?J:mt,fe=k==0?F:R,Oe=C._splits,Ne=zt.distr==2?Oe.map(yi=>Wi[yi]):Oe,Ce=zt.distr==2?Wi[Oe[1]]-Wi[Oe[0]]:Et,se=C.ticks,Kt=C.border,ln=se.show?se.size:0,wn=$n(ln*He),Kn=$n((C.alignTo==2?C._size-ln-C.gap:C.gap)*He),Ke=C._rotate*-Tf/180,En=p(C._pos*He),$i=(wn+Kn)*yt,_i=En+$i;tt=k==0?_i:0,Y=k==1?_i:0;let os=C.font[0],bs=C.align==1?al:C.align==2?Vg:Ke>0?al:Ke<0?Vg:k==0?"center":O==3?Vg:al,Ws=Ke||k==1?"middle":O==2?"top":_b;Ft(os,ut,bs,Ws);let qi=C.font[1]*C.lineGap,as=Oe.map(yi=>p(a(yi,zt,Gt,fe))),Ms=C._values;for(let yi=0;yi<Ms.length;yi++){let Xi=Ms[yi];if(Xi!=null){k==0?Y=as[yi]:tt=as[yi],Xi=""+Xi;let So=Xi.indexOf(`
`)==-1?[Xi]:Xi.split(/\n/gm);for(let vi=0;vi<So.length;vi++){let Mx=So[vi];Ke?(h.save(),h.translate(Y,tt+vi*qi),h.rotate(Ke),h.fillText(Mx,0,0),h.restore()):h.fillText(Mx,Y,tt+vi*qi)}}}se.show&&Dn(as,se.filter(i,Ne,w,kt,Ce),k,O,En,wn,nn(se.width*He,3),se.stroke(i,w),se.dash,se.cap);let $s=C.grid;$s.show&&Dn(as,$s.filter(i,Ne,w,kt,Ce),k,k==0?2:1,k==0?R:F,k==0?mt:J,nn($s.width*He,3),$s.stroke(i,w),$s.dash,$s.cap),Kt.show&&Dn([En],[1],k==0?1:0,k==0?1:2,k==1?R:F,k==1?mt:J,nn(Kt.width*He,3),Kt.stroke(i,w),Kt.dash,Kt.cap)}Jn("drawAxes")}function ve(w){x.forEach((C,O)=>{O>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(k=>{k.min=null,k.max=null})))})}let Sn=!1,xi=!1,Ye=[];function Nn(){xi=!1;for(let w=0;w<Ye.length;w++)Jn(...Ye[w]);Ye.length=0}function ai(){Sn||(s3(sx),Sn=!0)}function Eu(w,C=!1){Sn=!0,xi=C,w(i),sx(),C&&Ye.length>0&&queueMicrotask(Nn)}i.batch=Eu;function sx(){if(ct&&(Ae(),ct=!1),wt&&(Pt(),wt=!1),St){if(fn(f,al,ie),fn(f,"top",me),fn(f,ou,V),fn(f,au,Nt),fn(m,al,ie),fn(m,"top",me),fn(m,ou,V),fn(m,au,Nt),fn(d,ou,bn),fn(d,au,In),u.width=$n(bn*He),u.height=$n(In*He),T.forEach(({_el:w,_show:C,_size:O,_pos:k,side:Y})=>{if(w!=null)if(C){let tt=Y===3||Y===0?O:0,ut=Y%2==1;fn(w,ut?"left":"top",k-tt),fn(w,ut?"width":"height",O),fn(w,ut?"top":"left",ut?me:ie),fn(w,ut?"height":"width",ut?Nt:V),Kg(w,$o)}else is(w,$o)}),ea=zr=na=q=it=K=Q=It=I=null,Ut=1,kl(!0),ie!=Ct||me!=Qe||V!=Yt||Nt!=te){ve(!1);let w=V/Yt,C=Nt/te;if(vt&&!rt&&ft.left>=0){ft.left*=w,ft.top*=C,sa&&cr(sa,$n(ft.left),0,V,Nt),ra&&cr(ra,0,$n(ft.top),V,Nt);for(let O=0;O<xe.length;O++){let k=xe[O];k!=null&&(rn[O]*=w,gi[O]*=C,cr(k,ys(rn[O]),ys(gi[O]),V,Nt))}}if(an.show&&!at&&an.left>=0&&an.width>0){an.left*=w,an.width*=w,an.top*=C,an.height*=C;for(let O in bp)fn(la,O,an[O])}Ct=ie,Qe=me,Yt=V,te=Nt}Jn("setSize"),St=!1}bn>0&&In>0&&(h.clearRect(0,0,u.width,u.height),Jn("drawClear"),S.forEach(w=>w()),Jn("draw")),an.show&&at&&(Tu(an),at=!1),vt&&rt&&(Mo(null,!0,!1),rt=!1),dt.show&&dt.live&&bt&&(yp(),bt=!1),l||(l=!0,i.status=1,Jn("ready")),kr=!1,Sn=!1}i.redraw=(w,C)=>{wt=C||!1,w!==!1?Gr(E,D.min,D.max):ai()};function gp(w,C){let O=b[w];if(O.from==null){if(Mn==0){let k=O.range(i,C.min,C.max,w);C.min=k[0],C.max=k[1]}if(C.min>C.max){let k=C.min;C.min=C.max,C.max=k}if(Mn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==E&&O.distr==2&&Mn>0&&(C.min=Us(C.min,t[0]),C.max=Us(C.max,t[0]),C.min==C.max&&C.max++),X[w]=C,ct=!0,ai()}}i.setScale=gp;let xp,_p,sa,ra,rx,ox,oa,aa,ax,lx,on,mn,Hr=!1,ni=ft.drag,Zn=ni.x,jn=ni.y;vt&&(ft.x&&(xp=_s(RI,m)),ft.y&&(_p=_s(CI,m)),D.ori==0?(sa=xp,ra=_p):(sa=_p,ra=xp),on=ft.left,mn=ft.top);let an=i.select=On({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),la=an.show?_s(AI,an.over?m:f):null;function Tu(w,C){if(an.show){for(let O in w)an[O]=w[O],O in bp&&fn(la,O,w[O]);C!==!1&&Jn("setSelect")}}i.setSelect=Tu;function Xw(w){if(x[w].show)st&&Kg(pe[w],$o);else if(st&&is(pe[w],$o),vt){let O=Dt?xe[0]:xe[w];O!=null&&cr(O,-10,-10,V,Nt)}}function Gr(w,C,O){gp(w,{min:C,max:O})}function Gs(w,C,O,k){C.focus!=null&&Kw(w),C.show!=null&&x.forEach((Y,tt)=>{tt>0&&(w==tt||w==null)&&(Y.show=C.show,Xw(tt),s==2?(Gr(Y.facets[0].scale,null,null),Gr(Y.facets[1].scale,null,null)):Gr(Y.scale,null,null),ai())}),O!==!1&&Jn("setSeries",w,C),k&&zl("setSeries",i,w,C)}i.setSeries=Gs;function Yw(w,C){On(A[w],C)}function Zw(w,C){w.fill=Le(w.fill||null),w.dir=Fe(w.dir,-1),C=C??A.length,A.splice(C,0,w)}function jw(w){w==null?A.length=0:A.splice(w,1)}i.addBand=Zw,i.setBand=Yw,i.delBand=jw;function Jw(w,C){x[w].alpha=C,vt&&xe[w]!=null&&(xe[w].style.opacity=C),st&&pe[w]&&(pe[w].style.opacity=C)}let mr,Vr,bo,ca={focus:!0};function Kw(w){if(w!=bo){let C=w==null,O=Wt.alpha!=1;x.forEach((k,Y)=>{if(s==1||Y>0){let tt=C||Y==0||Y==w;k._focus=C?null:tt,O&&Jw(Y,tt?1:Wt.alpha)}}),bo=w,O&&ai()}}st&&ae&&De(Mb,Tt,w=>{ft._lock||(oe(w),bo!=null&&Gs(null,ca,!0,Un.setSeries))});function Vs(w,C,O){let k=b[C];O&&(w=w/He-(k.ori==1?me:ie));let Y=V;k.ori==1&&(Y=Nt,w=Y-w),k.dir==-1&&(w=Y-w);let tt=k._min,ut=k._max,yt=w/Y,Et=tt+(ut-tt)*yt,kt=k.distr;return kt==3?ul(10,Et):kt==4?qI(Et,k.asinh):kt==100?k.bwd(Et):Et}function Qw(w,C){let O=Vs(w,E,C);return Us(O,t[0],Rn,Cn)}i.valToIdx=w=>Us(w,t[0]),i.posToIdx=Qw,i.posToVal=Vs,i.valToPos=(w,C,O)=>b[C].ori==0?r(w,b[C],O?J:V,O?F:0):o(w,b[C],O?mt:Nt,O?R:0),i.setCursor=(w,C,O)=>{on=w.left,mn=w.top,Mo(null,C,O)};function cx(w,C){fn(la,al,an.left=w),fn(la,ou,an.width=C)}function ux(w,C){fn(la,"top",an.top=w),fn(la,au,an.height=C)}let Ol=D.ori==0?cx:ux,Bl=D.ori==1?cx:ux;function t1(){if(st&&dt.live)for(let w=s==2?1:0;w<x.length;w++){if(w==0&&ye)continue;let C=dt.values[w],O=0;for(let k in C)Zt[w][O++].firstChild.nodeValue=C[k]}}function yp(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((O,k)=>{et[k]=O}):jI(w.idx)||et.fill(w.idx),dt.idx=et[0]),st&&dt.live){for(let O=0;O<x.length;O++)(O>0||s==1&&!ye)&&e1(O,et[O]);t1()}bt=!1,C!==!1&&Jn("setLegend")}i.setLegend=yp;function e1(w,C){let O=x[w],k=w==0&&z==2?Wi:t[w],Y;ye?Y=O.values(i,w,C)??de:(Y=O.value(i,C==null?null:k[C],w,C),Y=Y==null?de:{_:Y}),dt.values[w]=Y}function Mo(w,C,O){ax=on,lx=mn,[on,mn]=ft.move(i,on,mn),ft.left=on,ft.top=mn,vt&&(sa&&cr(sa,$n(on),0,V,Nt),ra&&cr(ra,0,$n(mn),V,Nt));let k,Y=Rn>Cn;mr=en,Vr=null;let tt=D.ori==0?V:Nt,ut=D.ori==1?V:Nt;if(on<0||Mn==0||Y){k=ft.idx=null;for(let yt=0;yt<x.length;yt++){let Et=xe[yt];Et!=null&&cr(Et,-10,-10,V,Nt)}ae&&Gs(null,ca,!0,w==null&&Un.setSeries),dt.live&&(et.fill(k),bt=!0)}else{let yt,Et,kt;s==1&&(yt=D.ori==0?on:mn,Et=Vs(yt,E),k=ft.idx=Us(Et,t[0],Rn,Cn),kt=W(t[0][k],D,tt,0));let zt=-10,Gt=-10,fe=0,Oe=0,Ne=!0,Ce="",se="";for(let Kt=s==2?1:0;Kt<x.length;Kt++){let ln=x[Kt],wn=et[Kt],Kn=wn==null?null:s==1?t[Kt][wn]:t[Kt][1][wn],Ke=ft.dataIdx(i,Kt,k,Et),En=Ke==null?null:s==1?t[Kt][Ke]:t[Kt][1][Ke];if(bt=bt||En!=Kn||Ke!=wn,et[Kt]=Ke,Kt>0&&ln.show){let $i=Ke==null?-10:Ke==k?kt:W(s==1?t[0][Ke]:t[Kt][0][Ke],D,tt,0),_i=En==null?-10:B(En,s==1?b[ln.scale]:b[ln.facets[1].scale],ut,0);if(ae&&En!=null){let os=D.ori==1?on:mn,bs=qn(Wt.dist(i,Kt,Ke,_i,os));if(bs<mr){let Ws=Wt.bias;if(Ws!=0){let qi=Vs(os,ln.scale),as=En>=0?1:-1,Ms=qi>=0?1:-1;Ms==as&&(Ms==1?Ws==1?En>=qi:En<=qi:Ws==1?En<=qi:En>=qi)&&(mr=bs,Vr=Kt)}else mr=bs,Vr=Kt}}if(bt||Dt){let os,bs;D.ori==0?(os=$i,bs=_i):(os=_i,bs=$i);let Ws,qi,as,Ms,$s,yi,Xi=!0,So=pt.bbox;if(So!=null){Xi=!1;let vi=So(i,Kt);as=vi.left,Ms=vi.top,Ws=vi.width,qi=vi.height}else as=os,Ms=bs,Ws=qi=pt.size(i,Kt);if(yi=pt.fill(i,Kt),$s=pt.stroke(i,Kt),Dt)Kt==Vr&&mr<=Wt.prox&&(zt=as,Gt=Ms,fe=Ws,Oe=qi,Ne=Xi,Ce=yi,se=$s);else{let vi=xe[Kt];vi!=null&&(rn[Kt]=as,gi[Kt]=Ms,Cb(vi,Ws,qi,Xi),Ab(vi,yi,$s),cr(vi,ys(as),ys(Ms),V,Nt))}}}}if(Dt){let Kt=Wt.prox,ln=bo==null?mr<=Kt:mr>Kt||Vr!=bo;if(bt||ln){let wn=xe[0];wn!=null&&(rn[0]=zt,gi[0]=Gt,Cb(wn,fe,Oe,Ne),Ab(wn,Ce,se),cr(wn,ys(zt),ys(Gt),V,Nt))}}}if(an.show&&Hr)if(w!=null){let[yt,Et]=Un.scales,[kt,zt]=Un.match,[Gt,fe]=w.cursor.sync.scales,Oe=w.cursor.drag;if(Zn=Oe._x,jn=Oe._y,Zn||jn){let{left:Ne,top:Ce,width:se,height:Kt}=w.select,ln=w.scales[Gt].ori,wn=w.posToVal,Kn,Ke,En,$i,_i,os=yt!=null&&kt(yt,Gt),bs=Et!=null&&zt(Et,fe);os&&Zn?(ln==0?(Kn=Ne,Ke=se):(Kn=Ce,Ke=Kt),En=b[yt],$i=W(wn(Kn,Gt),En,tt,0),_i=W(wn(Kn+Ke,Gt),En,tt,0),Ol(Fs($i,_i),qn(_i-$i))):Ol(0,tt),bs&&jn?(ln==1?(Kn=Ne,Ke=se):(Kn=Ce,Ke=Kt),En=b[Et],$i=B(wn(Kn,fe),En,ut,0),_i=B(wn(Kn+Ke,fe),En,ut,0),Bl(Fs($i,_i),qn(_i-$i))):Bl(0,ut)}else Mp()}else{let yt=qn(ax-rx),Et=qn(lx-ox);if(D.ori==1){let fe=yt;yt=Et,Et=fe}Zn=ni.x&&yt>=ni.dist,jn=ni.y&&Et>=ni.dist;let kt=ni.uni;kt!=null?Zn&&jn&&(Zn=yt>=kt,jn=Et>=kt,!Zn&&!jn&&(Et>yt?jn=!0:Zn=!0)):ni.x&&ni.y&&(Zn||jn)&&(Zn=jn=!0);let zt,Gt;Zn&&(D.ori==0?(zt=oa,Gt=on):(zt=aa,Gt=mn),Ol(Fs(zt,Gt),qn(Gt-zt)),jn||Bl(0,ut)),jn&&(D.ori==1?(zt=oa,Gt=on):(zt=aa,Gt=mn),Bl(Fs(zt,Gt),qn(Gt-zt)),Zn||Ol(0,tt)),!Zn&&!jn&&(Ol(0,0),Bl(0,0))}if(ni._x=Zn,ni._y=jn,w==null){if(O){if(bx!=null){let[yt,Et]=Un.scales;Un.values[0]=yt!=null?Vs(D.ori==0?on:mn,yt):null,Un.values[1]=Et!=null?Vs(D.ori==1?on:mn,Et):null}zl(Wg,i,on,mn,V,Nt,k)}if(ae){let yt=O&&Un.setSeries,Et=Wt.prox;bo==null?mr<=Et&&Gs(Vr,ca,!0,yt):mr>Et?Gs(null,ca,!0,yt):Vr!=bo&&Gs(Vr,ca,!0,yt)}}bt&&(dt.idx=k,yp()),C!==!1&&Jn("setCursor")}let Wr=null;Object.defineProperty(i,"rect",{get(){return Wr==null&&kl(!1),Wr}});function kl(w=!1){w?Wr=null:(Wr=m.getBoundingClientRect(),Jn("syncRect",Wr))}function hx(w,C,O,k,Y,tt,ut){ft._lock||Hr&&w!=null&&w.movementX==0&&w.movementY==0||(vp(w,C,O,k,Y,tt,ut,!1,w!=null),w!=null?Mo(null,!0,!0):Mo(C,!0,!1))}function vp(w,C,O,k,Y,tt,ut,yt,Et){if(Wr==null&&kl(!1),oe(w),w!=null)O=w.clientX-Wr.left,k=w.clientY-Wr.top;else{if(O<0||k<0){on=-10,mn=-10;return}let[kt,zt]=Un.scales,Gt=C.cursor.sync,[fe,Oe]=Gt.values,[Ne,Ce]=Gt.scales,[se,Kt]=Un.match,ln=C.axes[0].side%2==1,wn=D.ori==0?V:Nt,Kn=D.ori==1?V:Nt,Ke=ln?tt:Y,En=ln?Y:tt,$i=ln?k:O,_i=ln?O:k;if(Ne!=null?O=se(kt,Ne)?a(fe,b[kt],wn,0):-10:O=wn*($i/Ke),Ce!=null?k=Kt(zt,Ce)?a(Oe,b[zt],Kn,0):-10:k=Kn*(_i/En),D.ori==1){let os=O;O=k,k=os}}Et&&(C==null||C.cursor.event.type==Wg)&&((O<=1||O>=V-1)&&(O=Vo(O,V)),(k<=1||k>=Nt-1)&&(k=Vo(k,Nt))),yt?(rx=O,ox=k,[oa,aa]=ft.move(i,O,k)):(on=O,mn=k)}let bp={width:0,height:0,left:0,top:0};function Mp(){Tu(bp,!1)}let dx,fx,px,mx;function gx(w,C,O,k,Y,tt,ut){Hr=!0,Zn=jn=ni._x=ni._y=!1,vp(w,C,O,k,Y,tt,ut,!0,!1),w!=null&&(De($g,jg,xx,!1),zl(vb,i,oa,aa,V,Nt,null));let{left:yt,top:Et,width:kt,height:zt}=an;dx=yt,fx=Et,px=kt,mx=zt}function xx(w,C,O,k,Y,tt,ut){Hr=ni._x=ni._y=!1,vp(w,C,O,k,Y,tt,ut,!1,!0);let{left:yt,top:Et,width:kt,height:zt}=an,Gt=kt>0||zt>0,fe=dx!=yt||fx!=Et||px!=kt||mx!=zt;if(Gt&&fe&&Tu(an),ni.setScale&&Gt&&fe){let Oe=yt,Ne=kt,Ce=Et,se=zt;if(D.ori==1&&(Oe=Et,Ne=zt,Ce=yt,se=kt),Zn&&Gr(E,Vs(Oe,E),Vs(Oe+Ne,E)),jn)for(let Kt in b){let ln=b[Kt];Kt!=E&&ln.from==null&&ln.min!=en&&Gr(Kt,Vs(Ce+se,Kt),Vs(Ce,Kt))}Mp()}else ft.lock&&(ft._lock=!ft._lock,Mo(C,!0,w!=null));w!=null&&(Bn($g,jg),zl($g,i,on,mn,V,Nt,null))}function n1(w,C,O,k,Y,tt,ut){if(ft._lock)return;oe(w);let yt=Hr;if(Hr){let Et=!0,kt=!0,zt=10,Gt,fe;D.ori==0?(Gt=Zn,fe=jn):(Gt=jn,fe=Zn),Gt&&fe&&(Et=on<=zt||on>=V-zt,kt=mn<=zt||mn>=Nt-zt),Gt&&Et&&(on=on<oa?0:V),fe&&kt&&(mn=mn<aa?0:Nt),Mo(null,!0,!0),Hr=!1}on=-10,mn=-10,et.fill(null),Mo(null,!0,!0),yt&&(Hr=yt)}function _x(w,C,O,k,Y,tt,ut){ft._lock||(oe(w),Fl(),Mp(),w!=null&&zl(Sb,i,on,mn,V,Nt,null))}function yx(){T.forEach(d2),G(i.width,i.height,!0)}qo(Af,cl,yx);let ua={};ua.mousedown=gx,ua.mousemove=hx,ua.mouseup=xx,ua.dblclick=_x,ua.setSeries=(w,C,O,k)=>{let Y=Un.match[2];O=Y(i,C,O),O!=-1&&Gs(O,k,!0,!1)},vt&&(De(vb,m,gx),De(Wg,m,hx),De(bb,m,w=>{oe(w),kl(!1)}),De(Mb,m,n1),De(Sb,m,_x),s0.add(i),i.syncRect=kl);let Au=i.hooks=n.hooks||{};function Jn(w,C,O){xi?Ye.push([w,C,O]):w in Au&&Au[w].forEach(k=>{k.call(null,i,C,O)})}(n.plugins||[]).forEach(w=>{for(let C in w.hooks)Au[C]=(Au[C]||[]).concat(w.hooks[C])});let vx=(w,C,O)=>O,Un=On({key:null,setSeries:!1,filters:{pub:Nb,sub:Nb},scales:[E,x[1]?x[1].scale:null],match:[Ub,Ub,vx],values:[null,null]},ft.sync);Un.match.length==2&&Un.match.push(vx),ft.sync=Un;let bx=Un.key,Sp=IM(bx);function zl(w,C,O,k,Y,tt,ut){Un.filters.pub(w,C,O,k,Y,tt,ut)&&Sp.pub(w,C,O,k,Y,tt,ut)}Sp.sub(i);function i1(w,C,O,k,Y,tt,ut){Un.filters.sub(w,C,O,k,Y,tt,ut)&&ua[w](null,C,O,k,Y,tt,ut)}i.pub=i1;function s1(){Sp.unsub(i),s0.delete(i),Yn.clear(),Qg(Af,cl,yx),c.remove(),Tt?.remove(),Jn("destroy")}i.destroy=s1;function wp(){Jn("init",n,t),Ul(t||n.data,!1),X[E]?gp(E,X[E]):Fl(),at=an.show&&(an.width>0||an.height>0),rt=bt=!0,G(n.width,n.height)}return x.forEach(ta),T.forEach(hr),e?e instanceof HTMLElement?(e.appendChild(c),wp()):e(i,wp):wp(),i}oi.assign=On;oi.fmtNum=h0;oi.rangeNum=Rf;oi.rangeLog=If;oi.rangeAsinh=c0;oi.orient=Yo;oi.pxRatio=He;oi.join=i3;oi.fmtDate=f0,oi.tzDate=p3;oi.sync=IM;{oi.addGap=j3,oi.clipGaps=Nf;let n=oi.paths={points:OM};n.linear=kM,n.stepped=Q3,n.bars=t2,n.spline=n2}var v0={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},VM={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},Bf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,WM=80;function f2(n){let t=[];Bf.lastIndex=0;let e=n.trimEnd();for(;Bf.lastIndex<e.length;){let i=Bf.lastIndex,s=Bf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function p2(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function kf(n,t="plain"){let e=p2(String(n));if(e.length>WM)throw new Error(`longer than ${WM} characters`);let i=f2(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in xt.suffix(t)&&(s=xt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=g=>i[o]?.sign===g,c=g=>{if(!l(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;l("+")||l("-");){let x=i[o++].sign,T=h();g=x==="+"?g+T:g-T}return g}function h(){let g=d();for(;;)if(l("*"))o++,g*=d();else if(l("/"))o++,g/=d();else if(i[o]?.word||l("("))g*=f();else return g}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let g=m();return l("^")?(o++,g**d()):g}function m(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let x=u();return c(")"),x}if(g.word){let x=g.word.toLowerCase();if(Object.hasOwn(VM,x))return a=!0,VM[x];if(Object.hasOwn(v0,x)){c("(");let T=u();return c(")"),v0[x](T)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(v0).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let y=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(y))throw new Error("not a finite number");let p=s??(t==="angle"&&a?1:xt.factor(t));return{value:y/p+0,symbolic:a||s!==null||i.length>2}}function vn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=v("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let p=kf(c.value,l()),g=a?.(p.value);if(g)throw new Error(g);return p},f=p=>{c.classList.toggle("wrong",!!p),p?(c.setAttribute("aria-invalid","true"),c.title=p):(c.removeAttribute("aria-invalid"),c.title=o??""),b0(c,p),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:p?{label:n,reason:p}:null}))},m=p=>{try{let g=d();return f(null),p?.(g.value,{symbolic:g.symbolic,text:c.value.trim()}),!0}catch(g){return f(g.message),!1}};c.addEventListener("input",()=>m(e)),c.addEventListener("change",()=>{m(i??e)&&c.blurred?.()});let y="";return c.addEventListener("focus",()=>{y=c.value,c.classList.contains("wrong")&&b0(c,c.title),c.select()}),c.addEventListener("blur",()=>b0(c,null)),c.addEventListener("keydown",p=>{let g=c.closest("table.dh");if(p.key==="Escape"&&c.value!==y){p.preventDefault(),c.value=y,m(i??e),c.select();return}if(g&&m2(c,p))return;let x={ArrowUp:1,ArrowDown:-1}[p.key];if(p.key==="Enter"&&(y=c.value,c.select()),!(!x||g&&!p.altKey)){p.preventDefault();try{let T=d();c.value=Vc((T.value??0)+x*xt.step(l())*(p.shiftKey?.1:1),l()),m(i??e)}catch{}}}),c.put=(p,g=null)=>{document.activeElement===c&&!c.readOnly||p===u&&g===h&&!c.classList.contains("wrong")||(u=p,h=g,c.value=g??(p==null?"":Vc(p,l())),M0(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>M0(c)),c.refresh=()=>{let p=u,g=h;u=NaN,c.put(p,g)},c}function M0(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&M0(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Li=null;function b0(n,t){if(!t){Li&&Li.about===n&&(Li.hidden=!0),n.removeAttribute("aria-describedby");return}Li||(Li=v("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Li)),Li.about=n,Li.hidden=!1,Li.textContent!==t&&(Li.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Li.style.setProperty("top",`${e.bottom+4}px`),Li.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Li.offsetWidth-8))}px`)}addEventListener("scroll",()=>Li&&(Li.hidden=!0),!0);function m2(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function zf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Hf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var je=n=>n.type==="R"?"angle":"length";function $M(n){let t=n.type==="R"?Math.PI:li(M.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var g2=ug;function x2(n){let t=M.table.joints[n],e=je(t),{lo:i,hi:s,min:r,max:o}=$M(t),a=`q${n+1}`,l=v("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=y=>`${100*(y-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{pi(),Lu(n,Number(l.value))}),l.addEventListener("keydown",y=>{let p={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[y.key],g={Home:i,End:s}[y.key];if(p===void 0&&g===void 0)return;y.preventDefault(),pi();let x=xt.step(e)*(y.shiftKey?.1:1);Lu(n,g??Math.min(Math.max(Math.round((M.q[n]+p*x)/(x/10))*(x/10),r),o))});let u=vn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:y=>{pi(),Lu(n,y)}}),h=v("span",{class:"out",role:"note"}),d=v("span",{class:"chain",title:"What this row of the table moves by"}),f=v("span",{class:"limits"}),m=v("div",{class:"joint","data-testid":`joint-${n+1}`},v("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},v("i",{text:"q"}),v("sub",{text:String(n+1)})),v("div",{class:"track"},l,v("div",{class:"under"},f,d,h)),u,v("span",{class:"unit"}));return{el:m,number:u,show(){let y=M.q[n],p=g2(t,y);(document.activeElement!==l||Number(l.value)!==y)&&(l.value=y),l.style.setProperty("--at",c(Math.min(Math.max(y,r),o))),l.setAttribute("aria-valuetext",ue(y,e)),u.put(Number((y*xt.factor(e)).toFixed(xt.digits(e)+1))/xt.factor(e)),m.classList.toggle("outside",p!==0);let g=M.table.coupling?`chain ${ue(xr(M.table,M.q)[n],e)}`:"";gt(d,g),gt(h,p?`${ue(Math.abs(p),e)} ${p>0?"above":"below"} the limit`:"")},relabel(){gt(m.lastChild,xt.symbol(e));let y=p=>p===null?"no limit":ue(p,e,xt.angle==="deg"&&e==="angle"?0:void 0);gt(f,t.lower===null&&t.upper===null?"no limits":`${y(t.lower)} \u2026 ${y(t.upper)}`),u.refresh(),this.show()}}}var qM={id:"joints",title:"Joints",build(n){let t=[],e=v("div",{class:"joints","data-testid":"joints"}),i=v("div",{class:"chips",role:"group","aria-label":"Postures"}),s=v("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=M.table.joints.map((o,a)=>x2(a)),Vt(e,t.map(o=>o.el)),t.length||e.append(v("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Vt(s,M.table.actuator?_2(M.table.actuator):null),y2(i)};nt("table",o=>o!=="gripper"&&r()),nt("q",()=>t.forEach(o=>o.show())),nt("units",()=>t.forEach(o=>o.relabel())),r()}};function _2(n){let t=v("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=v("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),gt(e,ei(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},gn({...M.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=v("div",{class:"under"},v("span",{text:`${n.name}: moves no frame`}));return v("div",{class:"joint"},v("span",{class:"joint-name",text:"tool"}),v("div",{class:"track"},t,s),e,v("span",{class:"unit",text:n.unit}))}function y2(n){let t=M.table.joints.length,e=Object.entries(M.table.postures??{}),i=(r,o)=>v("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>ue(a,je(M.table.joints[l]))).join(", "),on:{click:()=>Pi(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Vt(n,s,t?v("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>Pi(v2(),.8,"move to a random posture")}}):null,t?v("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:b2}}):null)}function v2(){return M.table.joints.map(n=>{let{lo:t,hi:e}=$M(n);return t+Math.random()*(e-t)})}function b2(){let n={...M.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=M.q.slice(),gn({...M.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),be(`Kept as P${t}: ${M.q.map((e,i)=>Vc(e,je(M.table.joints[i]))).join(", ")}`),ht("postures")}var XM=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function ur({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(u=>Ss(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(u=>Qt(u[u.length-1])),speeds:o??M2(t,r),least:t.map((u,h)=>Iu(n,u,c[h])[0]??0)}}function M2(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function S0(n,t){let{table:e}=n,i=xt.factor("length");if(t==="position")return{y:`tool, ${xt.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(u=>u[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(je))].map(l=>(l==="angle"?xt.angle:xt.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(u=>u[c]*xt.factor(je(l)))}))}}function YM(n){let t=xt.angle,e=xt.length,{table:i}=n,s=l=>je(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*xt.factor("length")),...l.map((u,h)=>u*xt.factor(je(i.joints[h]))),...n.speeds[c].map((u,h)=>u*xt.factor(je(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function ZM(n,t,e){let{y:i,list:s}=S0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(_=>_.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,m]=[Math.min(...c),Math.max(...c)];m-f>1e-9||(f-=1,m+=1);let y=_=>a.l+(_-h)/(d-h)*(r-a.l-a.r),p=_=>o-a.b-(_-f)/(m-f)*(o-a.t-a.b),g=(_,S)=>{let U=(S-_)/6,L=10**Math.floor(Math.log10(U)),D=[1,2,5,10].map(z=>z*L).find(z=>z>=U);return Array.from({length:12},(z,W)=>(Math.ceil(_/D)+W)*D).filter(z=>z<=S+D*1e-6)},x=_=>_.toFixed(2),T=_=>String(Number(_.toPrecision(6))),b=_=>_.replace(/[&<>"]/g,S=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[S]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],E=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${b(n.title)}</text>`];for(let _ of g(f,m))E.push(`<path d="M${a.l} ${x(p(_))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(p(_)+4)}" text-anchor="end">${T(_)}</text>`);for(let _ of g(h,d))E.push(`<path d="M${x(y(_))} ${o-a.b}v5" stroke="#333"/><text x="${x(y(_))}" y="${o-a.b+20}" text-anchor="middle">${T(_)}</text>`);E.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let _ of n.events)Number.isFinite(_.x)&&E.push(`<path d="M${x(y(_.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(y(_.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${b(_.short)}</text>`);return s.forEach((_,S)=>{let U=e[S%e.length],L=_.values[_.values.length-1];E.push(`<polyline fill="none" stroke="${U}" stroke-width="1.8" stroke-dasharray="${A[S%A.length]}" points="${_.values.map((D,z)=>`${x(y(l[z]))},${x(p(D))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*S}h22" stroke="${U}" stroke-width="2" stroke-dasharray="${A[S%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*S}"><title>${x(L)}</title>${b(_.name)}</text>`)}),E.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${b(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${b(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${E.join("")}</svg>
`}var S2=1500,w2={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function jM(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/S2)),r=n.q.map((b,A)=>A).filter(b=>b%s===0||b===n.q.length-1),[o,a,l,c,u,h]=Qa(),[d,f,m]=[o-c,a-u,l-h],y=[Math.atan2(m,Math.hypot(d,f)),Math.atan2(f,d)].map(b=>b*180/Math.PI),p=b=>Number(b.toPrecision(8)),g={kind:t,speed:e,view:y,q:r.map(b=>n.q[b].map(p)),t:r.map(b=>p(n.seconds[b]))},x=await Ue("film",g,({done:b,of:A})=>i(b,A));if(x.stopped)return null;let T=Uint8Array.from(atob(x.data),b=>b.charCodeAt(0));return{name:x.name,blob:new Blob([T],{type:w2[t]})}}async function JM(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var Ge=null,Xn=null,xl="joints",Hi=0,T0=1,mi=null;function QM(n){let t=v("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:eS}}),e=v("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{pi(),Br(Number(e.value))}}}),i=v("output",{class:"where","data-testid":"where"}),s=v("div",{class:"marks"}),r=v("div",{class:"chart","data-testid":"chart"}),o=v("div",{class:"legend"});n.append(v("div",{class:"dock-bar"},t,xn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{T0=Number(a)},{"data-testid":"speed"}),v("div",{class:"scrubber"},e,s),i,v("span",{class:"line"},...[["CSV",()=>ci("motion.csv",YM(Ge),"text/csv")],["PNG",A2],["Film",T2],["GIF",()=>KM("gif")],["MP4",()=>KM("mp4")],["SVG",()=>ci(`${xl}.svg`,ZM(Ge,xl,Bt.curves),"image/svg+xml")]].map(([a,l])=>v("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>Ge&&l()}})),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>Di(null)}}))),v("div",{class:"dock-bar second"},Ve("Curves",XM,xl,a=>{xl=a,w0()},"curves"),o),r),mi={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Zs(()=>Xn&&r.clientWidth&&Xn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),nt(["units","theme"],w0),nt("moving",a=>gt(t,a&&Vf?"Pause":"Play")),nt("table",a=>{Ge&&!["postures","name","gripper"].includes(a)&&Di(null)})}function Di(n){if(pi(),Ge=n,M.motion=n,mi.root.hidden=!n,Xn&&(Xn.destroy(),Xn=null),qv(n?.table??null,n?.q??[]),!n){ht("motion");return}mi.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Vt(mi.marks,n.events.map(e=>{let i=v("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=v("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),w0(),ht("motion"),n.q.length&&Br(0),requestAnimationFrame(()=>Ka())}var tS=()=>Hi;function Br(n){Ge?.q.length&&(Hi=Math.min(Math.max(Math.round(n),0),Ge.q.length-1),mi.scrub.value=String(Hi),mi.scrub.style.setProperty("--at",`${Ge.q.length>1?100*Hi/(Ge.q.length-1):0}%`),gt(mi.where,Ge.xName==="point"?`point ${Hi+1} of ${Ge.q.length}`:`${ei(Ge.xs[Hi],2)} s of ${ei(Ge.xs[Ge.xs.length-1],2)} s`),mi.scrub.setAttribute("aria-valuetext",mi.where.textContent),Ui(Ge.q[Hi].slice(),"scrub"),ht("played",Ge.seconds[Hi]),E0())}var Vf=!1;function eS(n,t){if(Vf){pi();return}if(!Ge?.q.length)return;let e=Ge.seconds,i=e[e.length-1]||1,s=Hi>=Ge.q.length-1?0:e[Hi]/i;Vf=!0,ob(i/T0,s,r=>{let o=Hi<=Ge.q.length-1&&e[Hi]<=r*i?Hi:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;Br(o)},()=>{Vf=!1,gt(mi.toggle,"Play"),t?.()}),gt(mi.toggle,"Pause")}function w0(){if(!Ge||!mi)return;Xn&&(Xn.destroy(),Xn=null);let{y:n,list:t}=S0(Ge,xl),e={stroke:Bt.line,width:1},i=`${Math.round(.78*Gf())}px "Inter Variable", system-ui, sans-serif`;Vt(mi.legend,t.map((o,a)=>{let l=v("span",{class:"swatch"});return l.style.setProperty("background",Bt.curves[a%Bt.curves.length]),v("span",{},l,o.name)}));let s={stroke:Bt.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*Gf(),gap:4};Xn=new oi({width:mi.chart.clientWidth||600,height:mi.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,Ge.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:Bt.curves[a%Bt.curves.length],width:1.75,pxAlign:0,points:{show:Ge.q.length<3}}))],axes:[{...s,label:Ge.xName==="point"?"point number":"time, s",size:2.1*Gf()},{...s,label:n,size:4*Gf()}]},[Ge.xs,...t.map(o=>o.values)],mi.chart);let r=v("div",{class:"now"});Xn.over.append(r,...Ge.events.map(o=>{let a=v("div",{class:`event ${o.stop?"stop":""}`,title:o.text},v("span",{text:o.short}));return a.x=o.x,a})),Xn.over.addEventListener("pointerdown",o=>{let a=u=>Br(E2(Xn.posToVal(u.clientX-Xn.over.getBoundingClientRect().left,"x")));pi(),a(o);let l=u=>a(u),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),Xn.hooks.setSize=[E0],E0()}var Gf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),E2=n=>Ge.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(Ge.xs[t]-n)?i:t,0);function E0(){if(!Xn)return;let n=Xn.over.clientWidth;for(let t of Xn.over.querySelectorAll(".now, .event")){let e=Xn.valToPos(t.x??Ge.xs[Hi],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}async function KM(n){be(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await jM(Ge,n,T0,(e,i)=>be(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&ci(t.name,t.blob)}catch(t){be(t.message,"wrong")}}async function T2(){pi(),Br(0);try{let n=await Ja(t=>JM(t,()=>new Promise(e=>eS(null,e))));ci("motion.webm",n)}catch(n){be(n.message,"wrong")}}function A2(){let n=Xn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Bt.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>ci(`${xl}.png`,i))}function yl(n,t){let e=Array.from({length:16},(s,r)=>v("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=v("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>v("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;gt(e[r],r>=12?String(s[r]):o?ei(s[r]*xt.factor("length"),xt.digits("length")):ei(s[r],4))}},i}var Wf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var A0="pieper-panel-width",R0=18,nS=70;function iS(n,t){let e=v("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(R0),"aria-valuemax":String(nS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,R0),nS,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(A0):localStorage.setItem(A0,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(A0));o>=R0?r(o):e.setAttribute("aria-valuenow","38")}function sS(n){let t=yl("Pose of the tool, large","present-pose"),e=v("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=v("button",{type:"button",text:"Present","aria-pressed":"false","data-testid":"present",on:{click:()=>o(i.dataset.present!=="yes")}}),r=()=>!e.hidden&&t.show(M.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ht("units"),dispatchEvent(new Event("resize"))}return nt(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function rS(){Ja(n=>n.toBlob(t=>t?ci(`${M.table.name||"arm"}.png`,t):be("The picture could not be read.","wrong")))}var R2="http://www.w3.org/2000/svg";function C2(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(R2,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}function oS(n){let t=null,e=v("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=v("span",{class:"hint",role:"status"}),s=v("input",{type:"text",placeholder:"Name, maker, or joints such as 7R","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>a(),keydown:l=>{if(l.key==="ArrowDown")e.firstElementChild?.focus();else if(l.key==="Enter")e.firstElementChild?.click();else return;l.preventDefault()}}}),r=v("dialog",{class:"catalogue","aria-label":"Catalogue"},v("div",{class:"line"},s,i,v("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the catalogue",on:{click:()=>r.close()}})),e);document.body.append(r);let o=l=>/^(.)\1*$/.test(l)?`${l.length}${l[0]}`:l;function a(){let l=s.value.toLowerCase().split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>{let h=`${u.name} ${u.maker} ${u.joints} ${o(u.joints)}`.toLowerCase();return l.every(d=>h.includes(d))});i.textContent=`${c.length} of ${t?.length??0} arms`,Vt(e,c.map(u=>v("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},C2(u.points),v("span",{},v("b",{text:u.name}),v("span",{class:"hint",text:[u.maker,o(u.joints)].filter(Boolean).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Zi("catalog")).arms,a()}catch(l){be(l.message,"wrong")}}}var du=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),go=(n,t)=>[...n.children].filter(e=>e.localName===t),P2=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function I2(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function L2([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var aS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:L2},D2={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function lS(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(m=>m.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=D2[e("up_axis")[0]?.textContent.trim()]??P2(),a=[];function l(f){let m=s(go(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),y=m&&[...m.getElementsByTagName("*")].find(g=>g.localName==="diffuse"),p=y?du(go(y,"color")[0]):[];return p.length>=3?[p[0],p[1],p[2],p[3]??1]:null}function c(f){let m=go(f,"input").find(p=>p.getAttribute("semantic")==="POSITION"),y=s(m?.getAttribute("source"));return y?du(go(y,"float_array")[0]):[]}function u(f,m,y){let p=f&&go(f,"mesh")[0];if(p)for(let g of p.children){if(!["triangles","polylist","polygons"].includes(g.localName))continue;let x=go(g,"input"),T=1+Math.max(...x.map(W=>Number(W.getAttribute("offset")??0))),b=x.find(W=>W.getAttribute("semantic")==="VERTEX");if(!b)continue;let A=Number(b.getAttribute("offset")??0),E=c(s(b.getAttribute("source"))),_=go(g,"p").map(du),S=g.localName==="polylist"?du(go(g,"vcount")[0]):g.localName==="polygons"?_.map(W=>W.length/T):new Array(_.reduce((W,B)=>W+B.length,0)/T/3).fill(3),U=_.flat(),L=[],D=0,z=W=>{let B=3*U[(D+W)*T+A],[X,P,N]=[E[B],E[B+1],E[B+2]];for(let Z=0;Z<3;Z++)L.push(r*(m[4*Z]*X+m[4*Z+1]*P+m[4*Z+2]*N+m[4*Z+3]))};for(let W of S){for(let B=2;B<W;B++)for(let X of[0,B-1,B])z(X);D+=W}L.length&&L.every(Number.isFinite)&&a.push({at:Float32Array.from(L),colour:l(y.get(g.getAttribute("material")))})}}function h(f,m,y){if(!(y>60)){for(let p of f.children)aS[p.localName]&&(m=I2(m,aS[p.localName](du(p))));for(let p of f.children)if(p.localName==="instance_geometry"){let g=new Map([...p.getElementsByTagName("*")].filter(x=>x.localName==="instance_material").map(x=>[x.getAttribute("symbol"),x.getAttribute("target")]));u(s(p.getAttribute("url")),m,g)}else if(p.localName==="node")h(p,m,y+1);else if(p.localName==="instance_node"){let g=s(p.getAttribute("url"));g&&h(g,m,y+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var $f=[],fu=new Map,qf=0;function N2(){if($f.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=fu.get(t);fu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of fu.values())t(new Error("meshes cannot be read in this browser"));fu.clear()},$f.push(n),n}return $f[qf%$f.length]}function cS(n,t){return new Promise((e,i)=>{qf+=1,fu.set(qf,{resolve:e,reject:i}),N2().postMessage({id:qf,...n},t)})}async function uS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=lS(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await cS({at:r},[r.buffer]),colour:o})))}return[{mesh:await cS({bytes:i,kind:e},[i]),colour:null}]}var hS={light:"#c9ced6",dark:"#8b96a6"},bl=new Tn,Os=[],pu=0,pS=!1,mS=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function Ml(n,t,e=null){M.looks=n?.shapes.length?{...n,key:mS(t),files:e}:null,n?.notes.length&&be(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),U2()}var P0=()=>!!(M.looks&&M.looks.key===mS(M.table)),I0=()=>P0()?M.look.mode:"sketch",Xf=null;function U2(){if(Xf===M.looks)return;Xf=M.looks;for(let t of Os)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();Os=[],bl.clear();let n=Xf;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){fS(t,[F2[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(pu+=1,uS(e,t.url??t.file).then(i=>{if(Xf===n)for(let{mesh:s,colour:r}of i){let o=C0(s),a=s.some===s?o:C0(s.some);fS(t,[o,a,s.few===s.some?a:C0(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>be(`${t.name}: ${i.message}`,"wrong")).finally(()=>{pu-=1,vl(),pu||ht("looks","loaded")}))}ht("looks"),vl()}var dS=n=>n.rotateX(Math.PI/2),F2={box:n=>new Oi(...n),cylinder:([n,t])=>dS(new Ai(n,n,t,36)),capsule:([n,t])=>dS(new Io(n,t,8,24)),sphere:([n])=>new Rs(n,28,16)};function C0(n){let t=new Me;return t.setAttribute("position",new Be(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new Be(n.normal,3):O2(n.normal)),t.setIndex(new Be(n.index,1)),t}function O2(n){return new Qr(new Ro(n,4),3,0,!0)}function fS(n,[t,e=t,i=e],s,r=null,o=!0){let a=hv(o),l=new Ze(t,a),c=new Ze(i,uf),u=new ge().set(...n.T);r&&u.scale(new H(...r));for(let h of[l,c])h.matrixAutoUpdate=!1,h.frustumCulled=!1;c.renderOrder=-1,bl.add(l,c),Os.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:l,shadow:c,colour:s}),mu()}var B2=new ge;function vl(){gS(),_e()}function gS(){let n=I0();if(bl.visible=n!=="sketch"&&Os.length>0,Gv(n!=="real"||pu>0,n!=="sketch"&&Os.length>0),!!bl.visible)for(let t of Os){let e=M.frames[t.on];e&&(t.mesh.geometry=pS?t.few:Qy()?t.some:t.fine,t.mesh.matrix.copy(B2.set(...e)).multiply(t.T),t.shadow.matrix.copy(Dg).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function mu(){let n=I0()==="both"?M.look.opacity:1;for(let{mesh:t,colour:e}of Os){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,ii):t.material.colour.set(Bt.dark?hS.dark:hS.light),t.material.see((o??1)*n,Bt.dark)}_e()}function L0(n){M.look={...M.look,...n},mu(),vl(),ht("look")}function xS(){hn.add(bl),nt("table",()=>{vl(),mu(),ht("looks")}),nt("q",vl),nt("theme",mu),nt("look",n=>{n==="loaded"&&(mu(),vl())}),nt("hurry",n=>{pS=n,gS()})}var _S=()=>({mode:I0(),visible:bl.visible,loading:pu,shapes:Os.length,triangles:Os.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:Os.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:Os.map(n=>n.mesh.matrix.clone().transpose().toArray())});function vS(){let n=Ve("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],M.look.mode,s=>L0({mode:s}),"look"),t=v("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(M.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>L0({opacity:Number(t.value)})}}),e=v("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!P0(),n.mark(M.look.mode),t.hidden=M.look.mode!=="both",t.value=String(M.look.opacity)};return nt(["looks","look","table"],i),i(),e}function MS(n){let t=v("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>bS(t.value)}}),e=oS(bS),i=v("p",{class:"sentence","data-testid":"sentence"}),s=v("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let m=v("button",{type:"button",text:u,"aria-label":h,on:{click:d}});return m.show=y=>{m.disabled=!y,m.title=y?`${h}: ${y} (${f})`:`Nothing to ${h.toLowerCase()}`,m.setAttribute("aria-description",y??"")},m},o=r("\u21B6","Undo",zg,"Ctrl+Z"),a=r("\u21B7","Redo",Hg,"Ctrl+Shift+Z");nt("history",()=>{o.show(xf()),a.show(_f())});let l=()=>{let{name:u,derived:h,catalog:d}=M.table,f=d?[]:[v("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Vt(t,f,(M.catalog??[]).map(m=>v("option",{value:m,text:m}))),t.value=d??""},c=v("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(v("h1",{class:"mark"},v("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),v("span",{text:"pieper"})),t,v("button",{type:"button",class:"find",text:"Find\u2026","aria-label":"Find an arm in the catalogue","data-testid":"find-arm",on:{click:e}}),c,i,v("span",{class:"bar-end"},s,Ve("Angles in",[["deg","\xB0"],["rad","rad"]],xt.angle,u=>{xt.set("angle",u),ht("units")},"unit-angle"),Ve("Lengths in",[["mm","mm"],["m","m"]],xt.length,u=>{xt.set("length",u),ht("units")},"unit-length"),xn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],M.theme,kd,{"data-testid":"theme"}))),ht("history"),nt(["catalog","table"],l),nt("plan",()=>{gt(i,[Nu(M.plan),Ux(M.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=M.plan?.explain??""}),nt("online",u=>{gt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),nt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(xt.angle),n.querySelector("[data-testid=unit-length]").mark(xt.length),n.querySelector("[data-testid=theme]").value=M.theme})}async function bS(n){if(n)try{let{table:t}=await Zi("load",{name:n});gn(t,{q:da(t),what:"new",label:`open ${n}`})}catch(t){be(t.message,"wrong")}}function SS(n,t,e,i){let s=v("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=v("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=v("section",{class:"section"},v("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=v("button",{type:"button",role:"tab",id:`tab-${c.id}`,"aria-controls":u.id,text:c.title,on:{click:()=>l(c.id)}});return c.group&&s.append(v("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(M.panel,t.scrollTop),M.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ht("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(m=>!m.tab.hidden),d=h.findIndex(m=>m.id===M.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(M.panel==="move"||!a.some(c=>c.id===M.panel)?"move":M.panel)),l(M.panel),l}function wS(n){let t=v("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>v("button",{type:"button",text:u,on:{click:()=>sg(c)}})),v("button",{type:"button",text:"Fit",on:{click:()=>Kc()}})),e=v("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=v("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),eb(c)}}}),s=v("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:pf}}),r=v("span",{class:"scale"}),o=v("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=v("span",{class:"dot"});return h.style.setProperty("background",Lr[u]),v("span",{},h,c)}),r);n.append(v("div",{class:"corner top"},t,v("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),vS(),v("div",{class:"group",role:"group","aria-label":"The picture"},sS(n),v("button",{type:"button",text:"PNG","aria-label":"Save the picture","data-testid":"save-picture",on:{click:rS}}))),v("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=M.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);M.shownFrames=(M.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{M.shownFrames=d,l()};Vt(e,v("span",{class:"group-name",text:"Frames"}),u.map(d=>v("button",{type:"button",text:ff(d),"aria-pressed":String(M.shownFrames.includes(d)),"aria-label":`Frame ${ff(d)}`,on:{click:()=>h(M.shownFrames.includes(d)?M.shownFrames.filter(f=>f!==d):[...M.shownFrames,d])}})),v("button",{type:"button",text:M.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(M.shownFrames.length===c+2?[]:u)}})),ht("frames"),gt(r,`grid ${ue(og.cell,"length",xt.length==="mm"?0:2)}`)};nt(["table","units"],l),l()}function ES(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),zg()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Hg()))})}var D0=()=>M.frames[M.frames.length-1],AS={id:"pose",title:"Pose",build(n){let t=yl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>TS(u,"length",`pose-${u.toLowerCase()}`)),i=v("div",{class:"quantities","data-testid":"orientation"}),s=v("p",{class:"hint order"}),r=[],o=xn("Notation of the orientation",Object.entries(Ls).map(([u,h])=>[u,h.title]),M.notation,u=>{M.notation=u,ht("notation")}),a=v("span",{class:"copies"},v("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>$r(Wf(D0()))}}),v("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>$r(k2())}}));n.append(v("div",{class:"subhead"},v("span",{text:"Tool in the base frame"}),a),t,v("div",{class:"quantities"},e.map(u=>u.el)),v("div",{class:"line"},o,s),i);let l=()=>{let u=Ls[M.notation];o.value=M.notation,gt(s,u.order),r=u.names.map((h,d)=>TS(h,u.kinds[d],`turn-${d}`)),Vt(i,r.map(h=>h.el)),c()},c=()=>{let u=D0();t.show(u),Qt(u).forEach((h,d)=>e[d].show(h)),Ls[M.notation].to(u).forEach((h,d)=>r[d].show(h))};nt("q",c),nt("notation",l),nt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function k2(){let n=D0(),t=Ls[M.notation],e=Qt(n).map((s,r)=>`${"XYZ"[r]} ${dn(s,"length")} ${xt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${dn(s,"angle")} ${xt.symbol("angle")}`:ei(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function TS(n,t,e){let i=v("output",{"data-testid":e}),s=v("span",{class:"unit",text:xt.symbol(t)});return{el:v("div",{class:"quantity"},v("span",{class:"quantity-name",text:n}),i,s),show:o=>gt(i,t==="plain"?ei(o,5):dn(o,t)),relabel:()=>gt(s,xt.symbol(t))}}function z2(n,t){let e=[],i=n.joints.length,s=xr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=gr(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*gr(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var RS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=v("div",{class:"cards","data-testid":"matrices"}),a=v("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=xn("Posture",[["now","present posture"]],"now",m=>{e=m,d()}),c=v("span",{class:"partial"});n.append(v("div",{class:"line"},Ve("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,m=>{t=m,h()},"matrix-mode"),c),v("div",{class:"line"},v("span",{class:"field-name",text:"Numbers of the"}),l),o,v("h3",{text:"Intermediate angles"}),v("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&M.solutions?.rows[Number(e)]?.q||M.q,h=()=>{let m=M.table.joints.length;i=Math.min(i,m),s=s===0||s>m?m:s;let y=t==="links"?M.table.joints.map((g,x)=>["A",String(x+1),""]):t==="products"?M.table.joints.map((g,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&y.push(["T","tool","base"]);let p=Array.from({length:m+1},(g,x)=>[String(x),String(x)]);Vt(c,t==="partial"?[xn("From frame",p,String(i),g=>{i=Number(g),h()})," \u2192 ",xn("To frame",p,String(s),g=>{s=Number(g),h()})]:[]),r=y.map(([g,x,T])=>({grid:yl(`${g} ${T} ${x}`,`matrix-${g}${T}${T?"-":""}${x}`),note:v("span",{class:"hint"}),sym:g,low:x,high:T})),Vt(o,r.map(({grid:g,note:x,sym:T,low:b,high:A})=>v("figure",{class:"card"},v("figcaption",{},v("span",{class:"symbol"},A?v("sup",{text:A}):null,v("i",{text:T}),v("sub",{text:b})),x),g))),d()},d=Zs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let m=u(),y=Ex(M.table,m),p=y.length;r.forEach(({grid:T,note:b},A)=>{if(t==="links"&&A<p)T.show(y[A]),gt(b,`q${A+1} = ${ue(m[A],je(M.table.joints[A]))}`);else if(t==="links")T.show(Ss(M.table,m)[p+1]);else if(t==="products")T.show(y.slice(0,A+1).reduce(zn,Yi()));else{let E=_=>y.slice(0,_).reduce(zn,Yi());T.show(zn(ha(E(i)),E(s)))}});let g=xr(M.table,m),x=M.table.joints.map((T,b)=>[T.type==="R"?`\u03B8${b+1}`:`d${b+1}`,T.type==="R"?dn(gr(T,g[b]).theta,"angle"):dn(gr(T,g[b]).d,"length"),T.type==="R"?"angle":"length"]).concat(z2(M.table,m).map(({name:T,value:b})=>[`\u03B8${T}`,dn(b,"angle"),"angle"]));Vt(a,v("tbody",{},x.map(([T,b,A])=>v("tr",{},v("th",{scope:"row"},v("i",{text:T[0]}),v("sub",{text:T.slice(1)})),v("td",{text:b}),v("td",{class:"unit",text:xt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let m=M.solutions?.rows??[];Vt(l,v("option",{value:"now",text:"present posture"}),m.map((y,p)=>v("option",{value:String(p),text:`solution ${p+1}: ${y.label??""}`}))),e!=="now"&&!m[Number(e)]&&(e="now"),l.value=e,d()};nt("table",h),nt(["q","units","panel"],d),nt(["solutions","panel"],f),h()}};var H2=.002;function Bs(n,t,e,i){let s=[],r="",o=v("div",{class:"pose-fields"}),a=()=>{let c=Ls[M.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=gv(M.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,G2(s))};s=u.map(([d,f],m)=>{let y={value:0,kind:f},p=(g,x)=>{y.value=g,y.text=x.text,h()};return y.f=vn({label:`${n}, ${d}`,kind:f,testid:`${t}-${m}`,input:p,commit:(g,x)=>{p(g,x),ht("let-go")}}),y.el=v("label",{class:"pose-field"},v("span",{text:d}),y.f,v("span",{class:"unit",text:xt.symbol(f)})),y}),Vt(o,s.map(d=>d.el)),r=M.notation},l=()=>{r!==M.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...Qt(c),...Ls[M.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,V2(u,s[h].kind))})};return nt("units",()=>{a(),l()}),nt("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=zf(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),Hf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:v("fieldset",{class:"pose-editor"},v("legend",{text:n}),o),show:l}}function G2(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?nl(t(e),"angle"):2*nl(t(n.slice(3)),"plain");return{metres:nl(t(n.slice(0,3)),"length"),radians:i}}var V2=(n,t)=>String(Number((n*xt.factor(t)).toFixed(t==="plain"||xt[t]==="m"||xt[t]==="rad"?6:3))+0);function CS(n){let t=n.match(PS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:nl(e,"length"),radians:2*nl(i,"plain")}}var PS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function IS(n){let t=(n.replaceAll("\u2212","-").match(PS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Cu(e);if(i>H2)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=xt.factor("length");return Pu(e)}function Yf(n){return n.map((t,e)=>{let i=M.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((M.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function LS(n,t){let e=t?.self_motions??[],i=he.task??M.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Vt(n,v("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let m=d.moves.length>3?"most of its joints":d.moves.join(" and "),y=d.inside.length?X2(d):"All of it lies outside the limits.";return v("div",{class:"self-motion"},v("p",{},v("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${m}, ${a(d)}: the arm moves, ${o}. ${y}`),Z2(d,f,t.T,s))},c=e.length?$2(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?v("details",{class:"fold"},v("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Vt(n,c>=0?l(e[c],c):null,h)}var W2=n=>n.reduce((t,e,i)=>t+Math.sin((e-M.q[i])/2)**2,0),$2=n=>{let t=n.map(e=>Math.min(...e.q.map(W2)));return t.indexOf(Math.min(...t))};function q2(n){let t=(s,r)=>s.map((o,a)=>M.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(M.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var X2=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function Y2(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function Z2(n,t,e,i){let s=v("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{pi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ht("did",{label:"slide along a self-motion",key:"self-motion"}),Ui(Yf(i?Ax(M.table,u,e):u),"self-motion")};return s.value=String(q2(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",Y2(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function DS(){let n=[],t=[],e={},i=v("div",{class:"joints"}),s=v("details",{},v("summary",{class:"hint",text:"Hold by value"}),i),r=v("p",{class:"hint"}),o=Ve("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(m=>!m.instead).map(m=>m.name):null),"spare-mode"),a=v("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},v("div",{class:"line spread"},v("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:m=!1}={}){ht("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),he.redundancy=f&&Object.fromEntries(f.map(y=>[y,e[y]])),d(),m?sb():Ds({follow:!0})}let c=f=>n.filter(m=>m.instead===f.instead).map(m=>m.name),u=f=>M.table.joints.findIndex(m=>m.name===f.name);function h(f,m){let y=f.kind==="angle"?Math.PI:li(M.table),p=f.lower??-y,g=f.upper??y,x=v("input",{type:"range",min:String(p),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${m+1}`}),T=!1,b=(S,U)=>{e[f.name]=S,l(c(f),{sliding:U})};x.addEventListener("input",()=>b(Number(x.value),!0)),x.addEventListener("change",()=>Ds({follow:!0})),x.addEventListener("keydown",S=>{let U={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[S.key];if(U===void 0)return;S.preventDefault(),T=!0;let L=U*xt.step(f.kind)*(S.shiftKey?.1:1);b(Math.min(Math.max(e[f.name]+L,p),g),!0)}),x.addEventListener("keyup",()=>{T&&Ds({follow:!0}),T=!1});let A=vn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${m+1}`,check:S=>S<p-1e-9&&f.lower!==null?`below the limit ${ue(p,f.kind)}`:S>g+1e-9&&f.upper!==null?`above the limit ${ue(g,f.kind)}`:null,commit:S=>b(S,!1)}),E=v("span",{class:"limits"}),_=v("div",{class:"joint"},v("span",{class:"joint-name",text:f.name}),v("div",{class:"track"},x,v("div",{class:"under"},E)),A,v("span",{class:"unit"}));return{line:_,show(){let S=e[f.name];x.value=S,x.style.setProperty("--at",`${100*(Math.min(Math.max(S,p),g)-p)/(g-p||1)}%`),x.setAttribute("aria-valuetext",ue(S,f.kind)),_.classList.toggle("held",!!(he.redundancy&&f.name in he.redundancy)),A.put(Number((S*xt.factor(f.kind)).toFixed(xt.digits(f.kind)+1))/xt.factor(f.kind))},relabel(){gt(_.lastChild,xt.symbol(f.kind));let S=U=>U===null?"no limit":ue(U,f.kind,f.kind==="angle"&&xt.angle==="deg"?0:void 0);gt(E,f.lower===null&&f.upper===null?"no limits":`${S(f.lower)} \u2026 ${S(f.upper)}`),A.refresh()}}}function d(){for(let f of n)he.redundancy&&f.name in he.redundancy?e[f.name]=he.redundancy[f.name]:u(f)>=0?e[f.name]=M.q[u(f)]:f.instead&&Number.isFinite(M.solutions?.arm_angle)?e[f.name]=M.solutions.arm_angle:e[f.name]??=0;o.mark(he.redundancy?"chosen":"free"),gt(r,he.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return nt("solutions",()=>{let f=M.solutions?.spare;if(!M.solutions||!f&&(M.solutions.brief||M.solutions.status==="REFUSED"))return;let m=JSON.stringify(f??[])!==JSON.stringify(n);if(m){n=f??[],e={},t=n.map(h),Vt(i,t.map(y=>y.line));for(let y of t)y.relabel()}a.hidden=n.length===0,m&&(s.open=n.filter(y=>!y.instead).length>1||!!he.redundancy),d()}),nt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!he.redundancy&&d()),nt("units",()=>{for(let f of t)f.relabel();d()}),a}function NS(){let n=v("thead"),t=v("tbody"),e=v("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=v("div",{class:"scroll"},v("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${M.table.joints.map(c=>c.type).join("")}${xt.angle}${xt.length}`;l!==r&&(r=l,s=[],Vt(t),Vt(n,v("tr",{},v("td"),v("th",{class:"left",text:"posture"}),M.table.joints.map((c,u)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(u+1)}),v("span",{class:"unit",text:` ${xt.symbol(je(c))}`}))),v("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=M.table.joints.map(()=>v("td")),u=v("span"),h=v("span",{class:"offscreen"}),d=v("td",{class:"unit"}),f=v("tr",{tabindex:"0","data-testid":`solution-${l+1}`},v("th",{scope:"row",text:String(l+1)}),v("td",{class:"left"},u,h),c,d),m=()=>M.solutions?.rows[l]?.q,y=()=>m()&&ps(m()),p=()=>ps(null),g=()=>{m()&&(ps(null),Pi(Yf(m()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",y),f.addEventListener("pointerleave",p),f.addEventListener("focus",y),f.addEventListener("blur",p),f.addEventListener("click",g),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),g())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&gt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),gt(u.beyond,d.inside?"":", outside the limits"),gt(u.residual,d.residual?jd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${jd(d.residual[0])} m, ${jd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,m)=>{let y=M.table.joints[m],p=y.lower!==null&&f<y.lower-1e-9||y.upper!==null&&f>y.upper+1e-9;gt(u.cells[m],dn(f,je(y))),u.cells[m].classList.toggle("out",p)}))}),this.mark()},mark(){let l=M.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===M.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-M.q[d])/2))<1e-5)))}}}var j2={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},N0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},J2=new Set(["REDUNDANT","UNCERTAIN"]),K2=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,U0=120;function F0(){bi(M.frames[M.frames.length-1].slice(),"taken")}var FS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(v("div",{class:"line spread"},v("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:F0}}),Ve("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",y=>{i.hidden=y!=="numbers",s.hidden=y!=="matrix"},"target-as")));let e=Bs("Target","target",()=>M.target,(y,p)=>bi(y,"typed",p)),i=v("div",{},e.el),{el:s,show:r}=tL();n.append(i,s,eL());let o=v("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=v("div",{class:"near","data-testid":"ik-nearest"}),l=v("div",{class:"self-motions","data-testid":"self-motions"}),c=NS();n.append(DS(),o,a,l,c.el);let u=fa(U0,()=>{e.show(),r()}),h=fa(U0,()=>{if(t.hidden)return;let y=M.solutions;nL(o,y),rL(a,y),LS(l,y),c.show(y)}),d=fa(U0,()=>c.mark()),f=y=>()=>rf()?y.soon():y();nt("target",f(u)),nt("notation",e.show),nt(["solutions","units"],f(h)),nt("q",f(d));let m=()=>Ur("target",M.panel==="inverse"?Q2(Qt(M.target)):[]);nt("target",y=>y!=="drag"&&m()),nt("panel",y=>{Dv(y==="inverse"),(y!=="inverse"||M.hasTarget)&&m(),y==="inverse"&&(M.hasTarget?ht("solutions"):(M.hasTarget=!0,F0()))}),nt("table",y=>{y==="new"&&(M.hasTarget=M.panel==="inverse",M.hasTarget&&F0())})}};function Q2(n){let t=.25*li(M.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function tL(){let n=v("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=v("p",{class:"reason",role:"alert"}),e=v("p",{class:"hint"});n.addEventListener("input",()=>{try{bi(IS(n.value),"typed",CS(n.value)),gt(t,""),n.removeAttribute("aria-invalid")}catch(s){gt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(gt(e,`Twelve or sixteen numbers, row by row; the last column in ${xt.length}.`),document.activeElement===n)return;let s=M.target.map((r,o)=>o%4===3&&o<12?r*xt.factor("length"):r);n.value=Wf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return nt("units",i),i(),{el:v("div",{hidden:!0},n,e,t),show:i}}function eL(){let n=v("span",{class:"line"}),t=v("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{he.follow=t.checked}}}),e=Ve("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{he.ghosts=i,ol()});return nt("task",()=>{t.checked=he.follow,e.mark(he.ghosts)}),nt("plan",()=>Vt(n,M.plan?.solvable?[v("span",{class:"field-name",text:"Task"}),xn("Task",[["",`${M.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],he.task??"",i=>{ht("did",{label:"choose the task"}),he.task=i||null,he.redundancy=null,Ds()},{"data-testid":"task"})]:[])),v("div",{class:"line controls"},v("span",{class:"line"},v("span",{class:"field-name",text:"Handles"}),Ve("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Nv)),Ve("Axes of the handles",[["local","Tool"],["world","World"]],"local",Uv),v("span",{class:"line"},v("span",{class:"field-name",text:"Snap"}),xn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>Fv(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),v("span",{class:"line"},v("span",{class:"field-name",text:"Ghosts"}),e),v("label",{class:"check"},t,"Arm follows"),n)}function nL(n,t){if(!t){Vt(n,v("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=j2[t.status]??"note";let s=t.status==="SOLVED"&&e?US(t.missed):[t.why,t.status==="SINGULAR"?K2(e,i):"",US(t.missed)].filter(Boolean).join(" "),r=N0[t.status]&&!i?t.why.toLowerCase().includes(N0[t.status].toLowerCase())?"":N0[t.status]:t.status==="SINGULAR"||J2.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Vt(n,v("strong",{text:r})," ",v("span",{text:s}),t.ms===void 0?null:v("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var US=n=>n?`The pose was rounded by ${sL(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",iL=(n,t)=>ue(n,t,xt.digits(t)+2),sL=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*xt.factor(e)>=.5*10**-(xt.digits(e)+2)).map(([t,e])=>iL(t,e)).join(" and ");function rL(n,t){let e=t?.near;if(!e){Vt(n);return}let i=Qt(e.T).map(s=>dn(s,"length")).join(", ");Vt(n,v("p",{},v("strong",{text:"Nearest reachable: "}),`${i} ${xt.symbol("length")}, ${ue(e.metres,"length")} away`,e.radians>.001?`, turned by ${ue(e.radians,"angle")}`:""),v("div",{class:"line"},v("button",{type:"button",text:"Go there",on:{click:()=>Pi(e.q)}}),v("button",{type:"button",text:"Make it the target",on:{click:()=>bi(e.T,"chosen")}})))}var O0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Zf(n){return O0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function jf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Zf(r)??{a:0,alpha:0};Zf(r)&&(r=Yi()),o=zn(O0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Zf(o)??{a:0,alpha:0};Zf(o)&&(o=Yi()),r=zn(r,O0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var OS=30,oL=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),aL={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},Sl=null;function BS(n,t){Sl={label:n,key:"paste",open:!0};try{t(Sl)}finally{Sl=null,ht("let-go")}}function Jf(n,t,e,{symbolic:i,text:s},r){let o=M.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(M.table.joints[n][t],e)&&M.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${aL[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||gn({...M.table,joints:o},Sl?{...c,...Sl}:c),r&&!Sl&&ht("let-go")}function wl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=M.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(M.q,0),c=o?t(o,null).map((u,h)=>lL(u&&t(u,0),h,n.length)):null;gn({...M.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var lL=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function kS(n,t,e){let i=M.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function B0({label:n,key:t,open:e}={}){let i=M.table.joints.length;return i>=OS?(be(`At most ${OS} joints.`,"wrong"),!1):(wl([...M.table.joints,oL(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function k0(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};wl(e(M.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function Kf(){try{ci(`${M.table.name||"arm"}.toml`,(await Ue("save",{})).text,"application/toml")}catch(n){be(n.message,"wrong")}}function GS(){let n=(t,e,i)=>{let s=v("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>uL(s)}});return[v("button",{type:"button",text:t,title:e,on:{click:()=>s.click()}}),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var cL=/\.(toml|urdf|xml)$/i,zS=2e5;async function uL(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>cL.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){be("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>zS){be(`${i.name} has ${i.size} bytes; a robot file has at most ${zS.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Zi("open",{name:i.name.slice(-80),text:await i.text()});gn(s,{q:da(s),what:"new",label:`open ${i.name.slice(-40)}`}),Ml(r,s,a=>HS(t,a));let o=r?.shapes.filter(a=>a.file&&!HS(t,a.file)).length;o&&be(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){be(s.message,"wrong")}}function HS(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var z0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},hL=({catalog:n,...t})=>n?{...t,derived:n}:t,dL=n=>n.type==="R"?"angle":"length",VS={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=v("thead"),s=v("tbody"),r=v("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=v("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=v("p",{class:"verdict","data-testid":"arm-kind"}),l=Ve("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],M.table.convention,x=>{x!==M.table.convention&&gn(jf(M.table,x),{what:"rows",label:`make the table ${x}`})},"convention"),c=v("p",{class:"hint order"}),u=v("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>gn({...hL(M.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=Bs("Base","base",()=>M.table.base,x=>gn({...M.table,base:x},{what:"cell",label:"edit the base",key:"base",open:!0})),d=Bs("Tool","tool",()=>M.table.tool,x=>gn({...M.table,tool:x},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(v("div",{class:"line spread"},v("span",{class:"line"},u),v("span",{class:"line"},v("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>gn(Rx(M.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),...GS(),v("button",{type:"button",text:"Save",title:"As a robot file",on:{click:Kf}}))),v("div",{class:"line spread"},l,Ve("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,x=>{t=x,p()},"dh-part")),c,r,v("div",{class:"line"},v("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>B0()}}),v("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,mv(),v("details",{class:"fold","data-testid":"base-tool"},v("summary",{text:"Base and tool"}),h.el,d.el)),s.addEventListener("paste",x=>{let T=zf(x.clipboardData.getData("text")),b=()=>[...s.rows].map(_=>[..._.querySelectorAll("input.number")]);if(!T||!x.target.matches("input.number"))return;x.preventDefault();let A=b().findIndex(_=>_.includes(x.target)),E=b()[A].indexOf(x.target);BS("paste a table",_=>{for(;M.table.joints.length<A+T.length&&B0(_););let S=Hf(b(),A,E,T),U=T.flat().length;be(`Pasted ${S} number${S===1?"":"s"}${S<U?`; ${U-S} had no cell`:""}`)})}),n.addEventListener("verdict",x=>{let T=x.detail??fL(n);gt(o,T?`${T.label}: ${T.reason}. The arm stays as it was.`:"")});let f=(x,T,[b,A,E])=>{let _=x.type==="R"&&b==="theta"||x.type==="P"&&b==="d",S=b==="lower"||b==="upper",U=vn({label:`Joint ${T+1}, ${A}`,kind:E??dL(x),testid:`dh-${T+1}-${b}`,empty:S?null:void 0,check:L=>S?kS(T,b,L):L!==null&&Math.abs(L)>1e6?"larger than a million":null,input:(L,D)=>Jf(T,b,L,D,!1),commit:(L,D)=>Jf(T,b,L,D,!0)});return S&&(U.placeholder="none"),e.push({f:U,i:T,key:b}),v("td",{class:_?"variable":""},_?v("span",{class:"plus"},v("i",{text:"q"}),v("sub",{text:String(T+1)})," +"):null,U)},m=(x,T)=>v("button",{type:"button",class:`type type-${x.type}`,text:x.type,"data-testid":`dh-${T+1}-type`,"aria-label":`Joint ${T+1} is ${x.type==="R"?"revolute":"prismatic"}; press to change`,title:x.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>wl(M.table.joints.map((b,A)=>A===T?{...b,type:b.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...b.text,lower:void 0,upper:void 0,offset:void 0}}:b),b=>b.map((A,E)=>E===T&&typeof A=="number"?0:A),`make joint ${T+1} ${x.type==="R"?"prismatic":"revolute"}`)}}),y=(x,T)=>v("td",{class:"tools"},v("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${x+1} up`,disabled:x===0,on:{click:()=>k0(x,x-1)}}),v("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${x+1} down`,disabled:x===T-1,on:{click:()=>k0(x,x+1)}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${x+1}`,on:{click:()=>wl(M.table.joints.filter((b,A)=>A!==x),b=>b.filter((A,E)=>E!==x),`remove joint ${x+1}`)}})),p=()=>{e=[];let{joints:x}=M.table,T=M.table.convention==="modified",b=t==="geometry"?z0.geometry.map(([A,E,_])=>v("th",{scope:"col"},v("i",{text:E}),v("sub",{text:T&&(A==="a"||A==="alpha")?"i\u22121":"i"}),v("span",{class:"unit",text:` ${xt.symbol(_)}`}))):["name","lower limit","upper limit","zero","sense"].map(A=>v("th",{scope:"col",text:A}));Vt(i,v("tr",{},v("th",{scope:"col",text:"i"}),v("th",{scope:"col"},v("span",{class:"offscreen",text:"type"})),b,v("td"))),Vt(s,x.map((A,E)=>{let _=t==="geometry"?z0.geometry.map(S=>f(A,E,S)):[v("td",{},v("input",{type:"text",class:"name",value:A.name,maxlength:"40","aria-label":`Joint ${E+1}, name`,on:{change:S=>Jf(E,"name",S.target.value||`joint_${E+1}`,{},!0)}})),...z0.joint.map(S=>f(A,E,S)),v("td",{},v("button",{type:"button",class:"type",text:A.sign>0?"+":"\u2212","aria-label":`Joint ${E+1}, sense of the maker: ${A.sign>0?"as the table":"against the table"}`,on:{click:()=>wl(M.table.joints.map((S,U)=>U===E?{...S,sign:-S.sign}:S),S=>S,`turn the sense of joint ${E+1}`)}}))];return v("tr",{"data-testid":`dh-row-${E+1}`},v("th",{scope:"row",text:String(E+1)}),v("td",{},m(A,E)),_,y(E,x.length))})),x.length||s.append(v("tr",{},v("td",{colspan:"7",class:"hint",text:"No joints yet."}))),g()},g=()=>{for(let{f:x,i:T,key:b}of e){let A=M.table.joints[T];x.put(A[b],A.text?.[b]??null)}l.mark(M.table.convention),gt(c,M.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=M.table.name),h.show(),d.show()};nt("table",x=>{gt(o,""),x==="cell"||x==="name"||x==="postures"?g():p()}),nt("units",p),nt("notation",()=>{h.show(),d.show()}),nt("plan",()=>{a.dataset.tone=M.plan?.solvable?"good":"wrong",Vt(a,v("strong",{text:Nu(M.plan)||(M.plan?.refused?"Refused":"Not solved")})," ",v("span",{text:M.plan?.explain??""}))}),p()}};function fL(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var pL=4,mL=n=>{let t=n.toFixed(pL);return Number(t)<0?`(${t})`:t.replace("-","")};function Qf(n,t,e){let i=xr(t,e),s=t.joints.map((c,u)=>gr(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,mL(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var tp=null;async function gL(){return tp??=(await import("./katex-OJEVB6AI.js")).default,tp}function xL(n,t){let e=v("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function WS(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>xL(n,i)],[i=>"code"in i,i=>v("code",{text:i.code})],[()=>!0,i=>v("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var _L=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function yL(n){let t=M.table.joints.map((e,i)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(i+1)}),v("span",{class:"unit",text:` ${xt.symbol(je(e))}`})));return[v("h3",{text:"The formulas at the present pose"}),v("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},v("thead",{},v("tr",{},v("th",{text:"branch"}),t)),v("tbody",{},n.map((e,i)=>v("tr",{},v("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>v("td",{text:dn(s,je(M.table.joints[r]))}))))))]}var $S={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=v("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=v("div",{class:"equations","data-testid":"equations"}),c=Ve("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,b=>{i=b,y()},"equation-numbers"),u=v("div",{class:"scroll"});n.append(v("div",{class:"line spread"},v("span",{class:"line"},Ve("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,b=>{e=b,y()},"which-equations"),c),v("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>$r(f())}})),a,u,l);let h=b=>b.symbols&&i==="present"?Qf(b,M.table,M.q):b.latex,d=b=>b.number===void 0?"":` \\tag{${b.number}}`,f=()=>o.map(b=>b.kind==="equation"?`\\[ ${h(b)}${d(b)} \\]`:_L(b.pieces)).join(`

`);function m(b){r=[],Vt(l,o.map(A=>p(b,A))),g()}async function y(){if(t.hidden||!M.table.joints.length)return;let b=`${e}/${i}/${JSON.stringify(M.table.joints)}${M.table.convention}`;if(s!==b){s=b,gt(a,"Deriving \u2026"),Vt(l);try{let[A,E]=await Promise.all([gL(),Ue("equations",{which:e,numbers:i==="symbols"?i:"numbers"},_=>gt(a,_.note??""))]);if(s!==b)return;gt(a,E.note??""),o=E.blocks,m(A),c.hidden=e!=="forward",Vt(u),x()}catch(A){if(s!==b)return;s=null,gt(a,A.message)}}}function p(b,A){if(A.kind==="heading"||A.kind==="step")return v("h3",{},WS(b,A.pieces));if(A.kind!=="equation")return v("p",{class:"prose"},WS(b,A.pieces));let E=v("div",{class:"formula"});try{b.render(h(A),E,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{E.replaceChildren(v("code",{text:h(A)}))}if(A.number!==void 0)return v("div",{class:"formula-row numbered"},E,v("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return E;let _=v("output",{class:"value","data-entry":String(A.entry)});return r.push({value:_,entry:A.entry}),v("div",{class:"formula-row"},E,_)}let g=Zs(()=>{if(t.hidden)return;let b=M.frames[M.frames.length-1];for(let{value:A,entry:E}of r)gt(A,`= ${E%4===3?`${ei(b[E]*xt.factor("length"),xt.digits("length"))} ${xt.length}`:ei(b[E],4)}`)}),x=js(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:b}=await Ue("formulas",{T:M.frames.at(-1)});Vt(u,b.length&&e==="inverse"?yL(b):null)}catch{Vt(u)}},250),T=js(()=>{!t.hidden&&tp&&o.length&&e==="forward"&&i==="present"&&m(tp)},120);nt("q",T),nt("panel",T),nt("q",x),nt("units",x),nt("panel",y),nt("plan",y),nt(["q","units"],g)}};var vL=()=>M.frames.at(-1).slice();function ep(n,t){let e=M.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{ht("did",{label:c,key:u}),e[a]=l,t(),ht("path",n)},r=["from","to"].map(a=>{let l=Bs(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`${i}take-${a}`,on:{click:()=>{s(a,vL(),`take \u201C${a}\u201D of the path`),l.show()}}});return{el:v("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return nt("path",a=>a!==n&&o()),nt("path-loaded",o),nt("notation",o),{el:v("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var qS=()=>M.frames[M.frames.length-1].slice(),XS={id:"path",title:"Path",wide:!0,build(n,t){let e=M.path,i=ep("path",()=>h()),s=v("span",{class:"hint"}),r=vn({label:"Number of points N",testid:"path-n",check:p=>Number.isInteger(p)&&p>=2&&p<=2e3?null:"a whole number from 2 to 2000",input:p=>{ht("did",{label:"set the points of the path",key:"path-n"}),e.n=p}}),o=vn({label:"Seconds for the whole line",testid:"path-seconds",check:p=>p>0&&p<=3600?null:"more than 0, at most 3600",input:p=>{ht("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=p}}),a=v("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let p=Qt(e.to);ht("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((g,x)=>{e.to[g]=p[x]}),i.show(),ht("path","path"),h()}}}}),l=v("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>d(M.q)}}),c=v("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=v("div",{class:"branches","data-testid":"branches"});n.append(i.el,v("div",{class:"line"},a,s),v("div",{class:"line"},v("label",{class:"field"},v("span",{class:"field-name",text:"Points N"}),r),v("label",{class:"field"},v("span",{class:"field-name",text:"Seconds"}),o),l,v("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,u);let h=()=>{if(!e.from||!e.to){gt(s,"");return}let p=Sx(e.from,e.to);gt(s,`${ue(ls(Ni(Qt(e.to),Qt(e.from))),"length")} long${p>1e-6?`, turning ${ue(p,"angle")}`:", orientation kept"}`),Ho(Array.from({length:33},(g,x)=>Qt(Qd(e.from,e.to,x/32))))};async function d(p){let g=qr(n);if(g){c.hidden=!1,c.dataset.tone="wrong",gt(c,g);return}gt(l,"Planning \u2026"),l.disabled=!0;try{let x=await Ue("follow",{T0:e.from,T1:e.to,n:e.n,start:p});M.track=x,f(x,p)}catch(x){c.hidden=!1,c.dataset.tone="wrong",gt(c,x.message)}finally{gt(l,"Plan the line"),l.disabled=!1}}function f(p){if(c.hidden=!1,c.dataset.tone=p.complete?"good":"wrong",gt(c,p.explain),Vt(u,p.branches.length?v("h3",{text:"Branches that start at the first pose"}):null,p.branches.map((b,A)=>v("button",{type:"button",class:`branch ${A===p.chosen?"chosen":""}`,"aria-pressed":String(A===p.chosen),"data-testid":`branch-${A+1}`,disabled:!b.q,title:b.cause||"reaches the end",on:{click:async()=>{await Pi(b.q,.4,`take branch ${A+1}`),d(b.q)}}},v("span",{class:"branch-name",text:`${A+1}  ${b.label}`}),m(b.s),v("span",{class:"branch-end",text:b.complete?"to the end":b.q?`${b.points} of ${e.n}`:"starts outside the limits"})))),Ho(p.path.map(Qt)),!p.q.length){Di(null);return}let g=p.path.length,x=p.q.map((b,A)=>A+1),T=p.q.map((b,A)=>g>1?e.seconds*A/(g-1):0);Di(ur({table:M.table,q:p.q,xs:x,xName:"point",xEnd:g,seconds:T,title:`${M.table.name}: straight line, ${p.q.length} of ${g} points`,events:p.events.map(b=>({...b,x:1+b.s*(g-1),short:b.cause}))}))}function m(p){let g=v("span",{class:"bar-fill"});return g.style.setProperty("width",`${100*p}%`),v("span",{class:"bar"},g)}let y=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};nt("panel",p=>{p==="path"&&(e.from??=qS(),e.to??=qS(),y())}),nt("path-loaded",y),nt("units",h),nt("table",p=>{["postures","name","gripper"].includes(p)||(c.hidden=!0,Vt(u),Ho([]),t.hidden||y())})}};var YS=Math.PI/180,bL=()=>({turn_speed:180*YS,turn_acceleration:600*YS,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var ML=n=>M.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??Yi(),gu=n=>zn(ha(ML(n)),M.frames.at(-1));function np(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(c=>c!==null),a=Math.min(...o),l=Math.min(Math.max(...o),t[r]);o.length===2&&a<=l&&(i[t[r]]={...s,first:a,last:l})}),i.filter(Boolean)}function Zo(n,t,{key:e,open:i}={}){ht("did",{label:t,key:e,open:i}),!M.program.length&&n.length&&(M.start??=M.q),M.program=n,ht("program")}var jo=(n,t,e,i)=>Zo(M.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function ZS(n,t){ht("did",{label:t,key:"limits"}),M.limits={...ip(),...n},ht("program","limits")}var ip=()=>({...bL(),...M.limits});function jS(n,t="set the start of the program"){ht("did",{label:t}),M.start=n,ht("program")}var sp=()=>M.start?.length===M.table.joints.length?M.start:M.q;function El(){let n=ip(),t=M.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:sp(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:M.program.map(({name:i,...s})=>s)}}var SL=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),xo=()=>M.routing??SL();function Tl(n,t,e=t){ht("did",{label:t,key:e}),M.routing={...xo(),...n},ht("routing")}var H0=()=>{let n=xo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function rp(){let n=xo(),t=M.path,e=M.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:H0(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:M.world,clearance:e?n.clearance:0}}function G0(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Al=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function JS(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Al(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>G0(n,l)(o,r))}var Jo=Math.PI/180,KS=3.4,wL=2.1,QS=.5,EL=.9;function tw({drag:n,drop:t,scrub:e}){let i=v("canvas",{"aria-hidden":"true"}),s=v("div",{class:"route-now",hidden:!0}),r=v("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(P=>v("div",{class:`route-end ${P}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":P==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${P}`,hidden:!0})),a=v("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],m=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function y(){let P=m(),N=a.clientWidth,Z=a.clientHeight,$={l:KS*P,t:QS*P,w:N-(KS+EL)*P,h:Z-(QS+wL)*P},j=-Math.PI,et=Math.PI;if(l.map&&!Al(l.map))j=l.map.turn[0],et=l.map.turn.at(-1);else if(l.turn.length){let dt=90*Jo;j=Math.min(j,dt*Math.floor(Math.min(...l.turn)/dt)),et=Math.max(et,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...$,lo:j,hi:et,W:N,H:Z}}let p=P=>u.l+P*u.w,g=P=>u.t+(1-(P-u.lo)/(u.hi-u.lo))*u.h,x=P=>u.lo+(1-(P-u.t)/u.h)*(u.hi-u.lo),T=P=>Bt.curves[Math.max(l.branches.indexOf(P),0)%Bt.curves.length];function b(){f=(l.map?.branches??[]).map((P,N)=>{let Z=G0(l.map,N),$=l.map.s.length,j=l.map.turn.length,et=v("canvas",{width:$,height:j}),dt=et.getContext("2d"),ft=dt.createImageData($,j),st=parseInt(T(P).slice(1),16);for(let vt=0;vt<$;vt++)for(let _t=0;_t<j;_t++){if(!Z(vt,_t))continue;let Tt=4*((j-1-_t)*$+vt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:P,c:et}})}function A(){if(!l||!a.clientWidth)return;y();let P=Math.min(devicePixelRatio,2),N=i.getContext("2d");i.width=u.W*P,i.height=u.H*P,N.scale(P,P);let Z=.76*m();N.font=`${Z}px "Inter Variable", system-ui, sans-serif`,N.fillStyle=Bt.ground,N.fillRect(u.l,u.t,u.w,u.h),N.save(),N.beginPath(),N.rect(u.l,u.t,u.w,u.h),N.clip(),E(N),_(N),S(N),N.restore(),U(N,Z),D()}function E(P){let N=l.map;if(!N)return;let Z=N.turn[1]-N.turn[0],$=Al(N),j=N.turn[0]-Z/2,et=N.turn.at(-1)+Z/2,dt=$?Math.floor((u.lo-j)/(2*Math.PI)):0,ft=$?Math.ceil((u.hi-et)/(2*Math.PI)):0;for(let{name:st,c:vt}of f)if(!(c&&c!==st)){P.globalAlpha=(c?.4:.3)*(Bt.dark?.8:1);for(let _t=dt;_t<=ft;_t++){let Tt=g(et+2*Math.PI*_t),At=g(j+2*Math.PI*_t);P.drawImage(vt,u.l,Tt,u.w,At-Tt)}}P.globalAlpha=1}function _(P){if(!l.blocked)return;let[N,Z]=l.blocked.s,$=p(N),j=Math.max(p(Z)-$,3);P.fillStyle=Bt.wrong,P.globalAlpha=.75,P.fillRect(Math.min($,u.l+u.w-j),u.t,j,u.h),P.globalAlpha=1}function S(P){if(!l.q.length)return;let N=[[0]];l.labels.forEach((Z,$)=>{$&&Z!==l.labels[$-1]&&N.push([$-1]),N.at(-1).push($)});for(let[Z,$]of[[.38,!0],[.18,!1]])for(let j of N){P.beginPath();for(let et of j)P.lineTo(p(l.s[et]),g(l.turn[et]));P.lineWidth=Z*m(),P.lineJoin=P.lineCap="round",P.strokeStyle=$?Bt.panel:Bt.curves[l.labels[j.at(-1)]%Bt.curves.length],P.stroke()}}function U(P,N){P.strokeStyle=Bt.line,P.strokeRect(u.l,u.t,u.w,u.h),P.fillStyle=Bt.muted,P.textBaseline="middle",P.textAlign="right";let Z=(u.hi-u.lo)/Jo,$=[5,10,15,30,45,90,180].find(et=>Z/et<=6)??180;for(let et=Math.ceil(u.lo/Jo/$-1e-9)*$;et<=u.hi/Jo+1e-6;et+=$){let dt=g(et*Jo);P.fillText(dn(et*Jo,"angle",xt.angle==="deg"?0:2),u.l-.45*N,dt),P.globalAlpha=.5,P.beginPath(),P.moveTo(u.l,dt),P.lineTo(u.l+u.w,dt),P.lineWidth=1,P.stroke(),P.globalAlpha=1}P.textBaseline="top",P.textAlign="center";let j=u.t+u.h+.45*N;for(let et of[0,.25,.5,.75,1])P.fillText(String(et),p(et),j);P.fillText("path, from 0 to 1",p(.5),j+1.15*N),P.save(),P.translate(.5*N,u.t+u.h/2),P.rotate(-Math.PI/2),P.textBaseline="middle",P.fillText(`turn of the tool, ${xt.symbol("angle")}`,0,0),P.restore()}let L=P=>h?.which===P?h.turn:P==="start"?l.turn[0]:l.turn.at(-1);function D(){o.forEach((P,N)=>{let Z=N?"end":"start",$=!!(l?.turn.length&&l.map);if(P.hidden=!$,!$)return;let j=L(Z);P.style.setProperty("left",`${p(N)}px`),P.style.setProperty("top",`${g(j)}px`),P.classList.toggle("pinned",d[Z]),P.setAttribute("aria-valuemin",dn(u.lo,"angle",0).replace("\u2212","-")),P.setAttribute("aria-valuemax",dn(u.hi,"angle",0).replace("\u2212","-")),P.setAttribute("aria-valuenow",dn(j,"angle").replace("\u2212","-")),P.setAttribute("aria-valuetext",`${ue(j,"angle")}${d[Z]?", held":""}`)})}let z=P=>Math.min(Math.max(P,u.lo),u.hi);function W(P,N){h={which:P,turn:z(N)},D();let Z=JS(l.map,P==="start"?0:1,h.turn);r.hidden=!1,gt(r,`${ue(h.turn,"angle",1)}: ${Z.length?Z.join("; "):"closed on every branch"}`),r.dataset.tone=Z.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",P==="end"),n(P,h.turn)}function B(){if(!h)return;let{which:P,turn:N}=h;r.hidden=!0,t(P,N)}o.forEach((P,N)=>{let Z=N?"end":"start";P.addEventListener("pointerdown",$=>{$.preventDefault(),P.focus(),P.setPointerCapture($.pointerId);let j=L(Z)-x($.clientY-a.getBoundingClientRect().top),et=ft=>W(Z,x(ft.clientY-a.getBoundingClientRect().top)+j);P.addEventListener("pointermove",et);let dt=()=>{P.removeEventListener("pointermove",et),B()};P.addEventListener("pointerup",dt,{once:!0}),P.addEventListener("pointercancel",dt,{once:!0})}),P.addEventListener("keydown",$=>{let j={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[$.key];if(j)W(Z,L(Z)+j*Jo*($.shiftKey?.1:1));else if($.key==="Enter")B();else if($.key==="Escape"&&h)X(),n(Z,null);else return;$.preventDefault(),$.stopPropagation()}),P.addEventListener("blur",()=>h?.which===Z&&B())}),i.addEventListener("pointerdown",P=>{if(!l?.q.length)return;let N=$=>e(Math.min(Math.max(($.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(P.pointerId),N(P),i.addEventListener("pointermove",N);let Z=()=>i.removeEventListener("pointermove",N);i.addEventListener("pointerup",Z,{once:!0}),i.addEventListener("pointercancel",Z,{once:!0})});function X(){h=null,r.hidden=!0,l&&D()}return new ResizeObserver(Zs(A)).observe(a),{el:a,paint(){l&&b(),A()},cancel:X,show(P,N=null,Z={start:!1,end:!1}){l=P,d=Z,h=null,r.hidden=!0,a.hidden=!P,P&&(c=N,b(),A())},only(P){c=P,A()},at(P){s.hidden=P===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${p(P)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(P,N=null){let Z=a.getBoundingClientRect();return[Z.x+p(P==="end"?1:0),Z.y+g(N??L(P))]}}}var ew=Math.PI/180;function nw(){let n=(m,y,p)=>Tl({...m,start:null,end:null},y,p),t=(m,y,p)=>{let g=v("span",{class:"field-name"}),x=v("label",{class:"field"},g,p);return x.label=()=>{g.textContent=y==="plain"?m:`${m}, ${xt.symbol(y)}`},x},e=(m,y,p,g,x)=>{let T=vn({label:m,kind:y,testid:p,check:g,input:x});return{f:T,el:t(m,y,T)}},i=Ve("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",m=>{n({turn:m==="free"?null:[-45*ew,45*ew]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(m=>e(m?"to":"from","angle",`route-turn-${m}`,y=>Math.abs(y)<=4*Math.PI?null:"at most two turns",y=>{let p=xo().turn?.slice()??[0,0];p[m]=y,n({turn:p},"bound the turn of the route",`route-turn-${m}`)})),r=Ve("About which axis of the tool",["x","y","z"].map(m=>[m,m]),"z",m=>n({axis:m},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",m=>m>=0&&m<Math.PI/2?null:"from 0 to less than 90 degrees",m=>n({cone:m},"set the cone of the route","route-cone")),a=xn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",m=>n({cost:m},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",m=>m>=0&&m<1?null:"from 0 to less than 1",m=>n({singularity:m},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",m=>m>=0?null:"0 or more",m=>n({clearance:m},"keep the route from obstacles","route-clearance")),u=v("details",{class:"fold"},v("summary",{text:"More that is free, and what must be kept"}),v("div",{class:"line"},o.el),v("div",{class:"line"},v("label",{class:"field"},v("span",{class:"field-name",text:"Cheapest"}),a)),v("div",{class:"line"},l.el),v("div",{class:"line"},c.el)),h=v("div",{},v("div",{class:"line"},v("span",{class:"field-name",text:"Turn"}),i,...s.map(m=>m.el),v("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let m=xo();i.mark(m.turn?"within":"free"),s.forEach((y,p)=>{y.el.hidden=!m.turn,y.f.put(m.turn?.[p]??0)}),r.mark(m.axis),o.f.put(m.cone),a.value=m.cost,l.f.put(m.singularity),c.f.put(m.clearance),c.el.hidden=!M.world.some(y=>y.role!=="object"&&y.kind!=="frame"),d.forEach(y=>y.el.label())}return nt(["units","world"],f),nt("routing",m=>["undo","loaded"].includes(m)&&f()),f(),{el:h,show:f}}var iw=n=>({id:"route",title:"Route",wide:!0,build(t){let e=M.path,i=null,s=null,r=null,o=ep("route",()=>x()),a=nw(),l=(P,N,Z,$={})=>v("button",{type:"button",text:P,"data-testid":N,on:{click:Z},...$}),c=l("Find the route","find-route",()=>b(),{class:"primary"}),u=l("Let both ends free","free-ends",()=>{Tl({start:null,end:null},"let the ends of the route free"),b()}),h=l("Send to the program","route-to-program",W,{hidden:!0}),d=l("","route-others",z,{hidden:!0}),f=v("p",{class:"verdict",role:"status","data-testid":"route-verdict",hidden:!0}),m=v("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),y=v("div",{class:"branches","data-testid":"route-list"}),p=tw({drag:(P,N)=>N===null?ps(null):L(P,N),drop:(P,N)=>D(P,N),scrub:P=>r&&M.motion===r&&Br(_(P))}),g=v("details",{class:"fold",open:!0},v("summary",{text:"The line"}),o.el);p.el.hidden=!0,u.hidden=!0,t.append(v("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),g,a.el,v("div",{class:"line"},c,u,h),p.el,m,f,v("div",{class:"line"},d),y);let x=()=>{e.from&&e.to&&!i&&Ho(Array.from({length:33},(P,N)=>Qt(Qd(e.from,e.to,N/32))))},T=P=>{f.hidden=!1,f.dataset.tone="wrong",gt(f,P)};async function b(){let P=qr(t);if(P){T(P);return}gt(c,"Looking \u2026"),c.disabled=!0;try{let N=await Ue("route",rp());N.stopped||A(N)}catch(N){p.cancel(),T(N.message)}finally{gt(c,"Find the route"),c.disabled=!1}}function A(P){let N=xo();if(i=M.route={...P,turn:E(P,N),asked:[e.from,e.to]},s=P.found?P.branches[P.labels[0]]:null,P.found&&(g.open=!1),f.hidden=!1,f.dataset.tone=P.found?"good":P.verdict==="IMPOSSIBLE"?"wrong":"note",gt(f,P.text),p.show(i,s,{start:!!N.start,end:!!N.end}),ps(null),u.hidden=!(N.start||N.end),h.hidden=!P.found,d.hidden=!1,gt(d,P.found?"Routes that begin with other postures":"What would let it through?"),Vt(y),S(),Ho(P.points),!P.found){r=null,Di(null);return}let Z=P.q.length;r=ur({table:M.table,q:P.q,xs:P.q.map(($,j)=>j+1),xName:"point",xEnd:Z,seconds:P.s.map($=>e.seconds*$),title:`${M.table.name}: route, ${Z} points`}),Di(r)}function E(P,N){if(!P.found||!P.map||!Al(P.map))return P.turn;let Z=N.start?N.start.turn-P.turn[0]:N.end?N.end.turn-P.turn.at(-1):0;return P.turn.map($=>$+2*Math.PI*Math.round(Z/(2*Math.PI)))}let _=P=>i.s.reduce((N,Z,$)=>Math.abs(Z-P)<Math.abs(i.s[N]-P)?$:N,0);function S(){Vt(m,i.branches.map((P,N)=>{let Z=v("span",{class:"swatch"});return Z.style.setProperty("background",Bt.curves[N%Bt.curves.length]),v("button",{type:"button",class:"chip","aria-pressed":String(s===P),title:s===P?"Show all branches":"Show this branch alone","data-testid":`route-branch-${N+1}`,on:{click:()=>{s=s===P?null:P,p.only(s),S()}}},Z,P)}))}let U=(P,N)=>{let Z=P==="start",$=Z?0:i.q.length-1;return{T:Z?e.from:e.to,turn:N,free:H0(),near:i.q[$],branch:i.branches[i.labels[$]]}},L=Xs(async(P,N)=>{let Z=await Ue("route_posture",U(P,N)).catch(()=>null);ps(Z?.q??null)});async function D(P,N){try{let Z=await Ue("route_posture",U(P,N));if(!Z.q)throw new Error(`The route cannot ${P} there. ${Z.why}`);Tl({[P]:{turn:N,q:Z.q,branch:Z.label}},`turn the ${P} of the route to ${ue(N,"angle",1)}`),await b()}catch(Z){ps(null),p.cancel(),be(Z.message,"wrong")}}async function z(){d.disabled=!0,gt(d,"Looking \u2026");try{let P=await Ue("route_others",rp());if(P.stopped)return;let N=Z=>`cost ${Number(Z.toPrecision(3))}`;Vt(y,P.relaxations.map(Z=>v("p",{class:"verdict","data-tone":"note",text:Z})),P.alternatives.map((Z,$)=>v("button",{type:"button",class:"branch","data-testid":`route-other-${$+1}`,on:{click:async()=>{Tl({start:{turn:Z.turn,q:Z.q,branch:Z.branch},end:null},`begin the route ${Z.branch}`),await b()}}},v("span",{class:"branch-name",text:Z.branch}),v("span",{class:"hint",text:`begins turned ${ue(Z.turn,"angle",1)}`}),v("span",{class:"branch-end",text:N(Z.cost)}))),P.relaxations.length+P.alternatives.length?null:v("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),d.hidden=!0}catch(P){T(P.message)}finally{d.disabled=!1,i&&gt(d,i.found?"Routes that begin with other postures":"What would let it through?")}}async function W(){h.disabled=!0;try{let P=await Ue("route_program",rp());if(P.stopped)return;let N=!M.program.length,Z=N?P.steps.slice(1):P.steps;N&&(M.start=P.steps[0].q),Zo([...M.program,...Z],"send the route to the program");let $=`${ue(P.metres,"length",3)} and ${ue(P.radians,"angle",3)}`;be(`Sent as a spline through ${P.poses} poses; it strays by at most ${$}.`),n()?.("program")}catch(P){T(P.message)}finally{h.disabled=!1}}let B=()=>{M.routing&&(M.routing={...M.routing,start:null,end:null})};function X(){i=M.route=null,f.hidden=!0,p.show(null),h.hidden=d.hidden=u.hidden=!0,Vt(m),Vt(y),ps(null)}nt("panel",P=>{if(P!=="route")return;let N=()=>M.frames.at(-1).slice();e.from??=N(),e.to??=N(),o.show(),x(),i&&p.paint()}),nt("played",()=>{!r||M.motion!==r?p.at(null):p.at(i.s[tS()]??null)}),nt("motion",()=>M.motion!==r&&p.at(null)),nt("theme",()=>{p.paint(),i&&S()}),nt("units",()=>p.paint()),nt("routing",P=>{P==="undo"&&i&&b()}),nt(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(B(),X())}),nt("table",P=>{["postures","name","gripper"].includes(P)||(P!=="undo"&&B(),X())}),p.el.addEventListener("where",P=>Object.assign(P.detail,{at:p.place(P.detail.which,P.detail.turn)}))}});function sw(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>jo(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let m=vn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:y=>{n(()=>e(u,{[h]:y},h))}});return m.put(M.program[u][h]??null),v("label",{class:"field"},v("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),m)}let s=(u,h)=>{let d=M.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>Bs(d,`step-${u+1}-${h}`,()=>M.program[u]?.[h],f=>{let m=M.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...m}:{[h]:f},h))}).el;function a(u,h){let d=Ve("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",y=>jo(h,y==="centre"?{centre:Qt(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return v("div",{},v("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((y,p)=>{let g=vn({label:`Step ${h+1}, centre ${y}`,kind:"length",testid:`step-${h+1}-centre-${p}`,input:x=>{let T=M.program[h].centre.slice();T[p]=x,n(()=>e(h,{centre:T},"centre"))}});return g.put(u.centre[p]),v("label",{class:"field"},v("span",{class:"field-name",text:y}),g)}),m=v("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:m.checked},"far")}});return v("div",{},v("div",{class:"line"},d),v("div",{class:"line"},...f,v("span",{class:"unit",text:xt.length})),v("label",{class:"check"},m,"the longer way round"))}function l(u,h){let d=f=>jo(h,{through:f,T:f.at(-1)},t(h));return v("div",{class:"line"},v("span",{class:"field-name",text:`Goes through ${u.through.length} poses, the last one its target`}),v("button",{type:"button",class:"quiet",text:"Add the present pose","data-testid":`step-${h+1}-through`,on:{click:()=>d([...u.through,gu(h)])}}),v("button",{type:"button",class:"quiet",text:"Take the last one out",disabled:u.through.length<2,on:{click:()=>d(u.through.slice(0,-1))}}))}function c(u,h){return u.kind==="wait"?v("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?v("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?v("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?v("div",{class:"step-editor"},o(h)("T","The frame, in the base"),v("div",{class:"line"},v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${h+1}-teach`,on:{click:()=>jo(h,{T:M.frames.at(-1).slice()},`teach step ${h+1}`)}}),v("button",{type:"button",class:"quiet",text:"The base",title:"The poses that follow are meant in the base again",on:{click:()=>jo(h,{T:Yi()},`end the frame at step ${h+1}`)}}))):u.kind==="output"?v("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),v("label",{class:"check"},v("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):v("div",{class:"step-editor"},v("div",{class:"line"},xn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:xt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${xt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?l(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),v("div",{class:"line"},v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${h+1}-teach`,on:{click:()=>jo(h,{...s(h,gu(h)),q:u.kind==="joint"?M.q.slice():null},`teach step ${h+1}`)}}),u.q?v("button",{type:"button",class:"quiet",text:"Go there",on:{click:()=>Pi(u.q.slice(),.8,`go to step ${h+1}`)}}):null))}return c}function rw(){let n=v("div",{class:"line limits-of"}),t=()=>{let e=new Set(M.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=vn({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>ZS({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(ip()[r]),c===null&&(u.placeholder="none"),v("label",{class:"field"},v("span",{class:"field-name",text:`${o}, ${xt.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Vt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return nt(["table","units"],t),nt("program",e=>e==="undo"&&t()),t(),n}var op={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function V0(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>dn(t,je(M.table.joints[e]??{type:"R"}),1)).join(", "):`${Qt(n.T).map(t=>dn(t,"length",1)).join(", ")} ${xt.length}${n.kind==="spline"?`, ${n.through.length} poses`:""}`}var ow=200,TL=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Rl=()=>gu(ap()),ap=()=>M.program.length,aw={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=v("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=v("p",{class:"verdict",role:"status","data-testid":"program-verdict",hidden:!0}),o=v("details",{class:"fold",hidden:!0},v("summary",{text:"What binds, and when"}),v("p",{class:"hint prose"})),a=(E,_,S,U)=>v("button",{type:"button",text:_,title:S,"data-testid":`step-add-${E}`,on:{click:()=>f(U())}}),l=v("button",{type:"button",class:"primary",text:"Run the program","data-testid":"run-program",on:{click:b}}),c=v("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(v("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:M.q.slice(),T:Rl(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Rl(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Rl(),blend:0})),a("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Rl()],T:Rl(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),a("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:M.frames.at(-1).slice()})),a("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max(ap(),1),times:1}))),v("div",{class:"line spread"},c,v("span",{class:"line"},v("button",{type:"button",class:"quiet",text:"Start here","data-testid":"start-here",title:"The program begins in the present posture",on:{click:()=>jS(M.q.slice())}}),v("button",{type:"button",class:"quiet",text:"Go to the start",on:{click:()=>Pi(sp().slice(),.8,"go to the start")}}))),s,rw(),v("div",{class:"line"},l,v("span",{class:"line"},xn("Language of the file",TL,u,E=>{u=E},{"data-testid":"dialect"}),v("button",{type:"button",text:"Save the program","data-testid":"save-program",on:{click:A}}))),r,o),ap=()=>t>=0?t+1:M.program.length;let h=()=>M.program.slice(0,ap()).findLast(E=>E.T&&E.kind!=="frame")?.T??Rl(),d=()=>M.program.findLast(E=>E.kind==="gripper")?.value??0;function f(E){if(M.program.length>=ow){be(`At most ${ow} steps.`,"wrong");return}let _=t>=0?t+1:M.program.length;t=_;let S=np(M.program,M.program.map((U,L)=>L<_?L:L+1));if(E.kind==="call"&&!_){be("There is no step before it that could be done again.","wrong"),t=-1;return}Zo([...S.slice(0,_),E,...S.slice(_)],`add a step: ${op[E.kind].toLowerCase()}`)}function m(E,_){if(_<0||_>=M.program.length||E===_)return;let S=M.program.map((L,D)=>D);S.splice(_,0,...S.splice(E,1));let U=np(M.program,M.program.map((L,D)=>S.indexOf(D)));t=_,Zo(U,`move step ${E+1} to ${_+1}`),s.children[_]?.querySelector(".step-name")?.focus()}function y(E){t=-1,Zo(np(M.program,M.program.map((_,S)=>S===E?-1:S<E?S:S-1)),`remove step ${E+1}`)}function p(E,_){let S=_===t,U=v("button",{type:"button",class:"step-name quiet","aria-expanded":String(S),"data-testid":`step-${_+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=S?-1:_,T()},keydown:D=>{let z={ArrowUp:-1,ArrowDown:1}[D.key];z&&D.altKey?(D.preventDefault(),m(_,_+z)):z?(D.preventDefault(),s.children[_+z]?.querySelector(".step-name")?.focus()):D.key==="Delete"&&y(_)}}},v("b",{text:op[E.kind]}),` ${V0(E)}`,E.blend?v("span",{class:"hint",text:`, blend ${ue(E.blend,"length",0)}`}):null),L=v("li",{class:`step${e?.step===_?" failed":""}${S?" open":""}`,draggable:"true","data-testid":`step-row-${_+1}`},v("div",{class:"step-line"},v("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),v("span",{class:"hint",text:String(_+1)}),U,v("button",{type:"button",class:"icon",text:"\u2191",disabled:_===0,"aria-label":`Move step ${_+1} up`,on:{click:()=>m(_,_-1)}}),v("button",{type:"button",class:"icon",text:"\u2193",disabled:_===M.program.length-1,"aria-label":`Move step ${_+1} down`,on:{click:()=>m(_,_+1)}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove step ${_+1}`,on:{click:()=>y(_)}})),e?.step===_?v("p",{class:"reason",text:e.text}):null,S?x(E,_):null);return L.addEventListener("dragstart",D=>{i=_,D.dataTransfer.effectAllowed="move",D.dataTransfer.setData("text/plain",String(_))}),L.addEventListener("dragover",D=>{i<0||(D.preventDefault(),L.classList.add("target"))}),L.addEventListener("dragleave",()=>L.classList.remove("target")),L.addEventListener("drop",D=>{D.preventDefault();let z=i;i=-1,z>=0&&m(z,_)}),L}let g=!1,x=sw(E=>{g=!0,E(),g=!1});function T(){if(g){M.program.forEach((_,S)=>{let U=s.children[S]?.querySelector(".step-name");U&&Vt(U,v("b",{text:op[_.kind]}),document.createTextNode(` ${V0(_)}`))});return}t>=M.program.length&&(t=-1),Vt(s,M.program.map(p)),M.program.length||s.append(v("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.disabled=!M.program.length;let E=sp();gt(c,M.program.length?`Starts at ${E.map((_,S)=>dn(_,je(M.table.joints[S]),1)).join(", ")}`:"")}async function b(){r.hidden=!1;let E=qr(n);if(E){r.dataset.tone="wrong",gt(r,E);return}l.disabled=!0,gt(l,"Planning \u2026");try{let _=await Ue("program",{...El(),world:M.world});e=_.failed,e&&(t=e.step),r.dataset.tone=e||_.clear?.verdict==="HIT"?"wrong":_.clear?.verdict==="UNCERTAIN"?"note":"good",gt(r,e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[_.explain,_.clear?.text].filter(Boolean).join(`
`)),o.hidden=!_.tight.length,gt(o.lastChild,_.tight.map(U=>U.text).join(`
`)),T();let S=_.events.map(([U,L,D])=>({x:U,s:0,text:`${L} ${D} at ${U.toFixed(2)} s`,short:L==="gripper"?D>.5?"close":"open":L,stop:!1}));Di(Object.assign(ur({table:M.table,q:_.q,xs:_.t,xName:"time",seconds:_.t,dq:_.dq,events:S,title:`${M.table.name}: program, ${_.duration.toFixed(2)} s`}),{ddq:_.ddq,happens:_.events,tight:_.tight,limits:El().limits}))}catch(_){r.dataset.tone="wrong",gt(r,_.message)}finally{l.disabled=!M.program.length,gt(l,"Run the program")}}async function A(){try{let E="program",{text:_,name:S}=await Ue("program_file",{...El(),dialect:u,name:E});ci(S,_)}catch(E){r.hidden=!1,r.dataset.tone="wrong",gt(r,E.message)}}nt(["program","units","table"],E=>{E!=="limits"&&(e=null,T())}),T()}};var Ko=new Tn,lp=new el,AL=new ge,RL=n=>new ri({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function W0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new Be(e,3)),n}var lw=n=>n.rotateX(Math.PI/2),$0={box:n=>[W0(new Oi(...n.size)),n.T],cylinder:n=>[W0(lw(new Ai(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new H(...n.a),e=new H(...n.b).sub(t),i=e.length(),s=new ge().makeRotationFromQuaternion(new un().setFromUnitVectors(new H(0,0,1),i?e.clone().normalize():new H(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[W0(lw(new Io(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function q0(n,t,e=.86){if(!$0[n.kind])return null;let[i,s]=$0[n.kind](n),r=RL(t);r.opacity=e,r.depthWrite=e>.5;let o=new Ze(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var CL=()=>[...M.world,...M.things??[]];function PL(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=Qt(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*qs(n.T,s)[o])))}function uw(){hn.add(Ko,lp.group),nt(["world","table"],cw),nt("theme",()=>{lp.paint(),cw()})}var xu=new Map;function X0(n,t){if(t)xu.set(n,t);else if(!xu.delete(n))return;let e=Ko.children.find(s=>s.userData.name===n),i=M.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),_e()}var hw=n=>xu.get(n)??null;function dw(){for(let n of[...xu.keys()])X0(n,null)}function cw(){for(let t of Ko.children)t.geometry.dispose();Ko.clear();let n=CL();for(let t of n)if(t.kind==="curve"){let e=new Me().setFromPoints(t.points.map(i=>new H(...i)));Ko.add(new er(e,new Qi({color:Bt.trace,fog:!1})))}else if($0[t.kind]){let{mesh:e,T:i}=q0(t,t.role==="object"?Bt.accent:Bt.ghost);e.matrix.copy(AL.set(...xu.get(t.name)??i)),e.userData.name=t.name,Ko.add(e)}lp.show(n.filter(t=>t.kind==="frame"),.11*li(M.table)),Ur("world",n.flatMap(PL)),_e()}var fw=()=>Ko.children.length+(lp.last?.[0].length??0);var Pl=new er(new Me,new Qi({depthTest:!1,fog:!1})),Il=new Ar(new Me,new nr({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Pl.renderOrder=Il.renderOrder=6;Pl.frustumCulled=Il.frustumCulled=!1;Pl.visible=Il.visible=!1;var Cl=new Tn,_u=null,pw="",LL=()=>M.watch||M.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),DL=Xs(async()=>{try{let n=await Ue("clearance",{q:M.q,world:M.world});M.clearance=n}catch(n){M.clearance={refused:n.message}}Y0(),ht("clearance")});function mw(){LL()&&M.table.joints.length?DL():M.clearance&&(M.clearance=null,Y0(),ht("clearance"))}function Y0(){let n=M.clearance,t=!!n?.points?.length;if(Pl.visible=Il.visible=t,t){let e=n.points.map(i=>new H(...i));for(let i of[Pl,Il])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Bt.trace:Bt.wrong)}_e()}async function Z0(n){if(_u=null,n){let{bodies:t,explain:e}=await Ue("bodies",{});_u=t,pw=e}for(let t of Cl.children)t.geometry.dispose();Cl.clear();for(let t of _u??[]){let e=q0(t,Bt.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},Cl.add(e.mesh))}return xw(),pw}var gw=()=>Cl.children.length,NL=new ge;function xw(){for(let n of Cl.children){let{on:t,T:e}=n.userData;M.frames[t]&&n.matrix.copy(NL.set(...zn(M.frames[t],e)))}_e()}function _w(){hn.add(Pl,Il,Cl),nt(["q","world","watch"],mw),nt("plan",mw),nt("q",()=>_u&&xw()),nt("table",()=>_u&&Z0(!1).then(()=>ht("bodies-gone"))),nt("theme",Y0)}var FL=60,OL={box:"Box",cylinder:"Cylinder",frame:"Frame"},BL={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function j0(n,t,e={}){ht("did",{label:t,...e}),M.world=n,ht("world")}var cp=(n,t,e)=>j0(M.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function kL(n,t){if(M.world.length>=FL)return;let e=Qt(M.frames.at(-1)),i=.06*li(M.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*M.world.length;let o=t==="object"?"object":n,a=1;for(;M.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};j0([...M.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var yw={id:"world",title:"World",wide:!0,build(n){let t=v("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=v("p",{class:"hint prose"}),i=v("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{M.watch=i.checked,ht("watch")}}}),s=v("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await Z0(s.checked);gt(e,s.checked?h:"")}catch(h){gt(e,h.message)}}}}),r=v("div",{class:"things","data-testid":"world"}),o=(h,d,f,m)=>v("button",{type:"button",text:h,title:m,"data-testid":`add-${f}-${d}`,on:{click:()=>kL(d,f)}});n.append(v("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),v("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),v("div",{class:"line"},v("label",{class:"check"},i,"Distance, always"),v("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),nt(["clearance","units"],()=>{let h=M.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];gt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${ue(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${ue(-h.metres,"length")}.`))}),nt("bodies-gone",()=>{s.checked=!1,gt(e,"")});let l=!1,c=()=>{l||(Vt(r,M.world.map(u)),M.world.length||r.append(v("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=g=>(...x)=>{l=!0,g(...x),l=!1},m=v("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>m.value&&cp(d,{name:m.value},`name ${m.value}`)}}),y=BL[h.kind].map((g,x)=>{let T=vn({label:`${h.name}, ${g}`,kind:"length",testid:`world-${d+1}-size-${x}`,check:b=>b>0?null:"more than 0",input:f(b=>{let A=M.world[d],E=h.kind==="box"?{size:A.size.map((_,S)=>S===x?b:_)}:{[x?"h":"r"]:b};cp(d,E,`size of ${h.name}`)})});return T.put(h.kind==="box"?h.size[x]:x?h.h:h.r),v("label",{class:"field"},v("span",{class:"field-name",text:`${g}, ${xt.length}`}),T)}),p=Bs("Place of its middle",`world-${d+1}`,()=>M.world[d]?.T,f(g=>cp(d,{T:g},`move ${h.name}`)));return v("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},v("div",{class:"line spread"},v("span",{class:"line"},m,v("span",{class:"hint",text:OL[h.kind]}),h.kind==="frame"?null:xn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,g=>cp(d,{role:g},`make ${h.name} an ${g}`))),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>j0(M.world.filter((g,x)=>x!==d),`remove ${h.name}`)}})),y.length?v("div",{class:"line"},y):null,p.el)}nt(["world","units"],h=>h!=="python"&&c()),c()}};var zL=40,vw={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return M.sequence.postures},set postures(u){M.sequence.postures=u},get rate(){return M.sequence.rate}},e=v("thead"),i=v("tbody"),s=v("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=v("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:c}}),o=v("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let u=t.postures[1];if(u){ht("did",{label:"use the same times for all legs"});for(let h of t.postures.slice(2))h.seconds=u.seconds,h.hold=u.hold;l()}}}});n.append(v("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),v("div",{class:"scroll"},v("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),v("div",{class:"line"},v("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(M.q.slice())}}),v("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(M.table.postures??{}).forEach(([u,h])=>a(h.slice(),u))}}),o),v("div",{class:"line"},r),s);function a(u,h){t.postures.length>=zL||(ht("did",{label:"add a posture to the sequence"}),t.postures.push({name:h??`P${t.postures.length}`,q:u,seconds:5,hold:0}),l(),ht("sequence"))}function l(){let u=M.table.joints;t.postures=t.postures.filter(h=>h.q.length===u.length),r.disabled=t.postures.length<2,Vt(e,v("tr",{},v("td"),u.map((h,d)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(d+1)}),v("span",{class:"unit",text:` ${xt.symbol(je(h))}`}))),v("th",{text:"leg, s"}),v("th",{text:"rest, s"}),v("td"))),Vt(i,t.postures.map((h,d)=>{let f=u.map((y,p)=>{let g=vn({label:`${h.name}, q${p+1}`,kind:je(y),testid:`seq-${d}-q${p+1}`,input:x=>{ht("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${p}`}),h.q[p]=x,ht("sequence")}});return g.put(h.q[p],String(Number((h.q[p]*xt.factor(je(y))).toFixed(xt.digits(je(y))))+0)),v("td",{},g)}),m=(y,p,g)=>{if(d===0)return v("td");let x=vn({label:`${p} ${h.name}`,testid:`seq-${d}-${y}`,check:g,input:T=>{ht("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${y}`}),h[y]=T,ht("sequence")}});return x.put(h[y]),v("td",{},x)};return v("tr",{"data-testid":`seq-row-${d}`},v("th",{scope:"row"},v("button",{type:"button",class:"quiet",text:h.name,title:"Go there",on:{click:()=>Pi(h.q.slice())}})),f,m("seconds","Seconds to",y=>y>0?null:"more than 0"),m("hold","Rest after",y=>y>=0?null:"0 or more"),v("td",{class:"tools"},v("button",{type:"button",class:"icon",text:"\u2191",disabled:d===0,"aria-label":`Move ${h.name} up`,on:{click:()=>{ht("did",{label:`move ${h.name} up`}),t.postures.splice(d-1,0,...t.postures.splice(d,1)),l()}}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>{ht("did",{label:`remove ${h.name}`}),t.postures.splice(d,1),l(),ht("sequence")}}})))})),t.postures.length||i.append(v("tr",{},v("td",{class:"hint",colspan:String(u.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function c(){s.hidden=!1;let u=qr(n);if(u){s.dataset.tone="wrong",gt(s,u);return}r.disabled=!0;try{let h=t.postures,d=await Ue("motion",{postures:h.map(m=>m.q),seconds:h.slice(1).map(m=>m.seconds),holds:h.slice(1).map(m=>m.hold),rate:t.rate}),f=h.map((m,y)=>({x:d.arrivals[y],s:0,text:`${m.name} at ${d.arrivals[y].toFixed(2)} s`,short:m.name,stop:!1}));s.dataset.tone="good",gt(s,`${h.length} postures in ${d.t[d.t.length-1].toFixed(2)} s. ${HL(d.q)}`),Di(ur({table:M.table,q:d.q,xs:d.t,xName:"time",seconds:d.t,dq:d.dq,events:f,title:`${M.table.name}: ${h.map(m=>m.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",gt(s,h.message)}finally{r.disabled=t.postures.length<2}}nt(["table","units","sequence-loaded"],l),l()}};function HL(n){let t=M.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var GL=.14,_o=new Ze(new Rs(1,32,20),new ri({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));_o.matrixAutoUpdate=!1;_o.visible=!1;_o.renderOrder=4;var yu="none";function VL(n,t,e){let i=Tx(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function bw(n){yu=n,Mw()}var up=()=>M.ellipsoid??null;function Mw(){let n=yu!=="none"&&M.table.joints.length>0;if(_o.visible=n,M.ellipsoid=null,n){let t=VL(M.table,M.q,M.frames),e=GL*li(M.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(yu==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=Qt(M.frames.at(-1)),[a,l]=r,c={...r[2]};_o.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),_o.material.color.set(yu==="velocity"?Bt.trace:Bt.accent),_o.material.side=di,M.ellipsoid=t}_e(),ht("ellipsoid")}function Sw(){hn.add(_o),nt(["q","theme"],()=>yu!=="none"&&Mw())}var hp=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),J0=new nr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Gi=new Ar(new Me,J0);Gi.frustumCulled=!1;Gi.visible=!1;hn.add(Gi);var Ll=null,vu=null,Vi=0,yo={lo:0,hi:1};function ww(n){Ll=new Float32Array(3*n),vu=new Float32Array(n),Vi=0,Gi.geometry.dispose(),Gi.geometry=new Me,Gi.geometry.setAttribute("position",new Be(Ll,3)),Gi.geometry.setAttribute("color",new Be(new Float32Array(3*n),3)),Gi.geometry.setDrawRange(0,0),Gi.visible=!0,_e()}function Ew(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Vi<vu.length;i+=4,Vi++)Ll.set(e.subarray(i,i+3),3*Vi),vu[Vi]=e[i+3];$L()}function $L(){let n=vu.slice(0,Vi).sort();yo.lo=n[Math.floor(Vi*.02)]??0,yo.hi=n[Math.max(Math.ceil(Vi*.98)-1,0)]??1;let t=new ee,e=Gi.geometry.attributes.color.array,i=yo.hi-yo.lo||1;for(let s=0;s<Vi;s++){let r=Math.min(Math.max((vu[s]-yo.lo)/i,0),1)*(hp.length-1),o=Math.min(Math.floor(r),hp.length-2);t.lerpColors(hp[o],hp[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Gi.geometry.setDrawRange(0,Vi),Gi.geometry.attributes.position.needsUpdate=!0,Gi.geometry.attributes.color.needsUpdate=!0,_e()}var bu=()=>Vi;function Tw(n){ns.localClippingEnabled=n!==null,J0.clippingPlanes=n===null?null:[new si(new H(0,1,0),-n)],J0.needsUpdate=!0,_e()}function Aw(){let n=new Fi;for(let i=0;i<Vi;i++)n.expandByPoint(new H(Ll[3*i],Ll[3*i+1],Ll[3*i+2]));let{min:t,max:e}=n;return Vi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Rw(){Vi=0,Gi.visible=!1,_e()}var Pw=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],dp=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ei(n,4):n.toExponential(2).replace("-","\u2212"),Iw={id:"analysis",title:"Analysis",build(n){let t=v("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(v("div",{title:h},v("dt",{text:u}),i[c]=v("dd",{"data-testid":`fact-${c}`})));let s=v("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=v("p",{class:"hint","data-testid":"ellipsoid-axes"});nt("ellipsoid",()=>{let c=up();gt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>ue(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,v("h3",{text:"At the tool\u2019s point"}),Ve("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",bw,"ellipsoid"),o,v("h3",{text:"Distance to the limits"}),s,v("h3",{text:"Reachable points"}),qL());let a=()=>{r=M.table.joints.map((c,u)=>{let h=v("span",{class:"bar-fill"}),d=v("span",{class:"bar-text"});return{el:v("div",{class:"distance"},v("span",{},v("i",{text:"q"}),v("sub",{text:String(u+1)})),v("span",{class:"bar"},h),d),fill:h,text:d}}),Vt(s,r.map(c=>c.el)),l()},l=Zs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let c=Iu(M.table,M.q,M.frames),u=c[0],h=c[c.length-1];gt(i.manipulability,dp(c.reduce((d,f)=>d*f,1))),gt(i.condition,u>1e-9?ei(h/u,1):"\u221E"),gt(i.least,dp(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:m},y)=>{let p=M.table.joints[y],g=M.q[y];if(p.lower===null||p.upper===null){f.style.setProperty("width","100%"),gt(m,"no limit");return}let x=Math.min(g-p.lower,p.upper-g),T=Math.max(2*x/(p.upper-p.lower||1),0);f.style.setProperty("width",`${100*T}%`),d.classList.toggle("outside",x<-1e-9),gt(m,x<-1e-9?`${ue(-x,je(p))} beyond`:ue(x,je(p)))})});nt("table",a),nt(["q","units","panel"],l),a()}};function qL(){let n="20000",t="manipulability",e=!1,i=v("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Zi("cancel",{kind:"cloud"}):d()}}),s=v("button",{type:"button",text:"Clear",on:{click:h}}),r=Ve("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>Tw(f==="half"?M.table.base[7]:null),"cloud-cut"),o=v("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=v("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=v("span"),c=v("span"),u=v("div",{class:"legend-scale",hidden:!0},l,v("span",{class:"scale-bar"}),c);function h(){Rw(),Ur("cloud",[]),u.hidden=!0,gt(a,"")}async function d(){e=!0,gt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,ww(Number(n));try{let f=await Ue("cloud",{count:Number(n),colour:t,seed:1},m=>{Ew(m.points),o.value=m.done/m.of,gt(l,dp(yo.lo)),gt(c,dp(yo.hi)),gt(a,`${m.done.toLocaleString("en")} of ${m.of.toLocaleString("en")} points`)});gt(a,f.stopped?`Cancelled after ${bu().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${Pw.find(([m])=>m===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){gt(a,f.message)}e=!1,Ur("cloud",Aw()),Kc(),gt(i,"Draw the cloud"),o.hidden=!0}return nt("table",f=>{f!=="postures"&&f!=="name"&&bu()&&h()}),v("div",{},v("div",{class:"line"},xn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),v("span",{class:"field-name",text:"coloured by"}),xn("Coloured by",Pw,t,f=>{t=f},{"data-testid":"cloud-colour"})),v("div",{class:"line"},i,s,r),o,u,a)}var Lw=n=>({id:"share",title:"Share",build(t,e){let i=v("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=v("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=v("p",{class:"hint",role:"status","data-testid":"report-note"}),o=v("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:u}}),a=v("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(v("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),v("div",{class:"line share-link"},i,v("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>$r(await Mf())}})),v("h3",{text:"As a file"}),v("div",{class:"line"},v("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>ci(`${M.table.name||"arm"}.workbench.json`,JSON.stringify(vf(),null,1),"application/json")}}),v("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,v("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:Kf}})),v("h3",{text:"As Python"}),v("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,v("div",{class:"line"},v("button",{type:"button",text:"Copy the script","data-testid":"copy-python",on:{click:()=>$r(a.value)}}),v("button",{type:"button",text:"Save the script",on:{click:()=>ci("workbench.py",a.value,"text/x-python")}})),v("h3",{text:"Report"}),v("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),v("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&M.table.joints.length&&(i.value=await Mf()),!e.hidden&&M.table.joints.length&&c()},c=Xs(async()=>{try{let{q:d,target:f,hasTarget:m,path:y,program:p}=M,{task:g,redundancy:x}=he,T={q:d,target:m?f:null,path:y,task:g,redundancy:x,program:El()};a.value=(await Ue("python",p.length?T:{...T,program:null})).text}catch(d){a.value=`# ${d.message}`}});nt(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await Ue("report",{q:M.q},m=>gt(r,m.note));ci(f,d,"text/html"),gt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){gt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");bf(JSON.parse(await f.text()),n()),be("Opened")}catch(m){be(m instanceof SyntaxError?`${f.name} is not a state file.`:m.message,"wrong")}}}});var XL=40,Nw=!1,Uw=0,K0=!1,fp=null,Dw=null;function Fw(n){n&&(Nw=!0,fp=M.table,Ow(n))}function Ow(n){K0=!0,Uw=n.said,n.table&&(gn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),fp=M.table,Ml(n.looks??null,n.table)),n.things&&YL(n.things),n.target&&(M.hasTarget=!0,bi(n.target,"restored")),n.q&&n.q.length===M.table.joints.length&&(ht("did",{label:"move from Python",key:"python"}),Ui(n.q,"python")),K0=!1}function YL(n){M.things=n.filter(i=>i.kind!=="motion"),ht("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==Dw){if(Dw=e,!t){Di(null);return}Di(ur({table:M.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${M.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var ZL=fa(XL,()=>{let n=M.table===fp?void 0:Cp(M.table);fp=M.table,M.table.joints.length&&Zi("shown",{q:M.q,target:M.hasTarget?M.target:null,table:n,said:Uw}).catch(()=>{})});function Bw(){nt("push",Ow),nt(["q","target","table"],()=>Nw&&!K0&&ZL.soon())}var Qo=new Tn,zw=new ri({fog:!1}),Q0=new ri({fog:!1}),tx=new Oi(1,1,1),ex=new Ze(tx,zw),Hw=[new Ze(tx,Q0),new Ze(tx,Q0)];Qo.add(ex,...Hw);Qo.matrixAutoUpdate=!1;Qo.visible=!1;var Mu=null;function Gw(){hn.add(Qo),nt("q",()=>Mu!==null&&Ww()),nt("theme",kw),kw()}function kw(){zw.color.set(Bt.joint),Q0.color.set(Bt.accent)}function nx(n){n===null&&Mu===null||(Mu=n,Qo.visible=n!==null,n!==null&&Ww(),_e())}var Vw=()=>Mu;function Ww(){let n=M.frames.at(-1),t=.075*li(M.table);ex.scale.set(.35*t,1.1*t,.25*t),ex.position.set(0,0,-.85*t),Hw.forEach((e,i)=>{let s=(.08+.36*(1-Mu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),Qo.matrix.set(...n),Qo.updateMatrixWorld(!0)}var KL=.25,ix=.5;function QL(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(M.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=nD(n,r);if(o>=ix&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:ls(Ni(Qt(u.at(-1).T),Qt(a)))})).filter(({name:c,d:u})=>u<tD(M.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:zn(ha(a),l.T)}))}else o<ix&&s&&i&&(e.get(i).push({t:r,T:zn(a,e.get(i).at(-1).held)}),i=null);s=o>=ix}return{grips:t,objects:e}}var tD=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function eD(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var nD=(n,t)=>Ss(n.table,n.q[eD(n.seconds,t)]).at(-1),vo=null,iD=n=>{let t=vo.grips.length?1-Math.round(vo.grips[0].value):0;for(let e of vo.grips){if(e.t>n)break;let i=Math.min((n-e.t)/KL,1);t+=i*(e.value-t)}return t};function $w(){nt("motion",()=>{dw(),vo=M.motion?.happens?QL(M.motion):null,vo||nx(null)}),nt("played",n=>{if(!vo)return;let t=M.frames.at(-1);vo.grips.length&&nx(iD(n));for(let[e,i]of vo.objects){let s=i.findLast(r=>r.t<=n)??i[0];X0(e,s.held?zn(t,s.held):s.T)}})}function qw(){window.workbench=Object.freeze({get q(){return M.q.slice()},get frames(){return structuredClone(M.frames)},get target(){return M.target.slice()},get table(){return structuredClone(M.table)},get solutions(){return structuredClone(M.solutions)},get camera(){return Qa()},get pictures(){return Ky()},get ghosts(){return Kv()},get history(){return[xf(),_f()]},get beyond(){return Zv()},get things(){return fw()},get looks(){return _S()},get program(){return structuredClone(M.program)},get route(){return structuredClone(M.route)},routePlace(n,t){let e={which:n,turn:t};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:e})),e.at},get motion(){return structuredClone(M.motion)},get gripper(){return Vw()},placeOf:n=>hw(n)??M.world.find(t=>t.name===n)?.T??null,go:Br,get stepFrame(){return M.dhStep===null?null:Jd().at(-1).T},get clearance(){return structuredClone(M.clearance)},get bodies(){return gw()},get ellipsoid(){return structuredClone(up())},get world(){return structuredClone(M.world)},get framesDrawn(){return jv()},get answers(){return Ug.answers},get trace(){return nb()},get cloud(){return bu()},toScreen:ki,withPicture:n=>Ja(n),handles:()=>Tv(),forward:(n,t)=>Ss(n,t),convert:(n,t)=>jf(n,t),read:(n,t)=>kf(n,t),present:(n,t,e)=>Qf(n,t,e)})}Bd();tv(Ys("#view"));nt("theme",lg);lg();lb();$v();Sv();uw();xS();_w();Sw();Gw();$w();Bw();Nx();rb();MS(Ys("#bar"));wS(Ys("#overlay"));QM(Ys("#dock"));ES();var pp,Su=(n,t,...e)=>[{...t,group:n},...e];pp=SS(Ys("#rail"),Ys("#panels"),Ys("#pinned"),[...Su("Drive",{id:"move",title:"Move",sections:[qM,AS]},FS),...Su("Describe",VS,yw),...Su("Plan",XS,iw(()=>pp),aw,vw),...Su("Study",RS,$S,Iw),...Su("Hand on",Lw(()=>pp))]);iS(Ys("#room"),Ys("#rail"));gb();var rD=pb().then(n=>n&&bf(n,pp)).catch(n=>be(`The link could not be read: ${n.message}`,"wrong"));nt("online",async n=>{if(!n)return;await rD;let t=await Px();M.catalog=t.catalog,ht("catalog"),t.table&&(!M.table.joints.length||t.bench)&&(gn(t.table,{q:da(t.table),step:!1,what:"new"}),yf()),t.looks&&Ml(t.looks,t.table),Fw(t.bench),document.documentElement.dataset.ready="yes"});M.online&&ht("online",!0);document.fonts?.ready.then(()=>ht("theme"));qw();
