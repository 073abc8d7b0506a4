import{A as M,B as Ni,C as Iu,D as pa,E as _n,F as Px,G as Mi,H as Ix,I as Lu,K as Zi,L as Ys,a as Yi,b as zn,c as fa,d as Qt,e as Xs,f as Gl,g as Li,h as Vl,i as Au,j as Di,k as Ru,l as Cu,m as wx,n as Ex,o as gr,p as xr,q as Tx,r as Ms,s as wp,t as Ax,u as li,v as Pu,w as Rx,x as Cx,y as nt,z as ut}from"./chunk-F4CXFWSV.js";function b(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ss=(n,t=document)=>t.querySelector(n),Vt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function bt(n,t){n.textContent!==t&&(n.textContent=t)}function Ge(n,t,e,i,s){let r=b("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(b("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function cn(n,t,e,i,s={}){let r=b("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>b("option",{value:o,text:a})));return r.value=e,r}function Zs(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function ma(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function js(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function ci(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=b("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function qr(n){try{await navigator.clipboard.writeText(n)}catch{let t=b("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}be("Copied")}var Lx;function be(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(Lx),Lx=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Dx(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var ga=0,Ap=-1,Ep=[];function Rp(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Tp(){let n=ga;if(!M.table.joints.length){M.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ut("plan");return}try{let{plan:t}=await Zi("arm",{table:Rp(M.table)});if(n!==ga)return;Ap=n,M.plan=t,Nx()}catch(t){if(n!==ga||t instanceof Lu)return;M.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},Nx(t)}ut("plan")}function Nx(n){let t=Ep;Ep=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var Ux=js(Tp,60);function Ox(){nt("table",n=>{ga+=1,n==="postures"&&(Ap=-1),n==="cell"?Ux():(Ux.cancel(),Tp())}),nt("online",n=>{n&&(ga+=1,Tp())})}function _1(){return Ap===ga?Promise.resolve():new Promise((n,t)=>Ep.push({resolve:n,reject:t}))}async function Oe(n,t,e){return await _1(),Zi(n,t,e)}function Fx(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Du(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var io={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},so={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},x_=0,im=1,__=2;var wc=1,y_=2,Wa=3,nr=0,si=1,fi=2,Oo=0,$a=1,sm=2,rm=3,om=4,v_=5;var Fo=100,b_=101,M_=102,S_=103,w_=104,E_=200,T_=201,A_=202,R_=203,am=204,lm=205,C_=206,P_=207,I_=208,L_=209,D_=210,N_=211,U_=212,O_=213,F_=214,ah=0,lh=1,ch=2,La=3,uh=4,hh=5,dh=6,fh=7,cm=0,B_=1,k_=2,ir=0,um=1,hm=2,dm=3,fm=4,pm=5,mm=6,gm=7;var xm=300,Bo=301,qa=302,kh=303,zh=304,ph=1e3,Ks=1001,mh=1002,Qn=1003,z_=1004;var Ec=1005;var Ti=1006,Hh=1007;var Cr=1008;var es=1009,_m=1010,ym=1011,Xa=1012,Gh=1013,Cs=1014,hs=1015,Ps=1016,Vh=1017,Wh=1018,ko=1020,vm=35902,bm=35899,Mm=1021,Sm=1022,Is=1023,wr=1026,Pr=1027,$h=1028,qh=1029,ro=1030,Xh=1031;var Yh=1033,Tc=33776,Ac=33777,Rc=33778,Cc=33779,Zh=35840,jh=35841,Jh=35842,Kh=35843,Qh=36196,td=37492,ed=37496,nd=37488,id=37489,Pc=37490,sd=37491,rd=37808,od=37809,ad=37810,ld=37811,cd=37812,ud=37813,hd=37814,dd=37815,fd=37816,pd=37817,md=37818,gd=37819,xd=37820,_d=37821,yd=36492,vd=36494,bd=36495,Md=36283,Sd=36284,Ic=36285,wd=36286;var tc=2300,gh=2301,rh=2302,Zp=2303,jp=2400,Jp=2401,Kp=2402;var H_=3200;var wm=0,G_=1,Ir="",wi="srgb",ec="srgb-linear",nc="linear",Ve="srgb";var oh=7680,Em=7681;var Tm=517;var V_=519,W_=512,$_=513,q_=514,Am=515,X_=516,Y_=517,Rm=518,Cm=519,Pm=35044,Ed=35048;var Im="300 es",us=2e3,ic=2001;function v1(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function b1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function sc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Z_(){let n=sc("canvas");return n.style.display="block",n}var Bx={},Da=null;function rc(...n){let t="THREE."+n.shift();Da?Da("log",t,...n):console.log(t,...n)}function j_(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ne(...n){n=j_(n);let t="THREE."+n.shift();if(Da)Da("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ae(...n){n=j_(n);let t="THREE."+n.shift();if(Da)Da("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Jl(...n){let t=n.join(" ");t in Bx||(Bx[t]=!0,ne(...n))}function J_(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var K_={[ah]:ah,[ch]:dh,[uh]:uh,[La]:hh,[lh]:lh,[dh]:ch,[fh]:fh,[hh]:La},As=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ui=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],kx=1234567,Kl=Math.PI/180,Na=180/Math.PI;function oo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ui[n&255]+ui[n>>8&255]+ui[n>>16&255]+ui[n>>24&255]+"-"+ui[t&255]+ui[t>>8&255]+"-"+ui[t>>16&15|64]+ui[t>>24&255]+"-"+ui[e&63|128]+ui[e>>8&255]+"-"+ui[e>>16&255]+ui[e>>24&255]+ui[i&255]+ui[i>>8&255]+ui[i>>16&255]+ui[i>>24&255]).toLowerCase()}function we(n,t,e){return Math.max(t,Math.min(e,n))}function Lm(n,t){return(n%t+t)%t}function M1(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function S1(n,t,e){return n!==t?(e-n)/(t-n):0}function Ql(n,t,e){return(1-e)*n+e*t}function w1(n,t,e,i){return Ql(n,t,1-Math.exp(-e*i))}function E1(n,t=1){return t-Math.abs(Lm(n,t*2)-t)}function T1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function A1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function R1(n,t){return n+Math.floor(Math.random()*(t-n+1))}function C1(n,t){return n+Math.random()*(t-n)}function P1(n){return n*(.5-Math.random())}function I1(n){n!==void 0&&(kx=n);let t=kx+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function L1(n){return n*Kl}function D1(n){return n*Na}function N1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function U1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Dm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function O1(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:ne("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Td(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Nm(n,t){if(t.constructor===Float32Array)return n;let e=Td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Um(n,t){if(t.constructor===Float32Array)return n;let e=Td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ao={DEG2RAD:Kl,RAD2DEG:Na,generateUUID:oo,clamp:we,euclideanModulo:Lm,mapLinear:M1,inverseLerp:S1,lerp:Ql,damp:w1,pingpong:E1,smoothstep:T1,smootherstep:A1,randInt:R1,randFloat:C1,randFloatSpread:P1,seededRandom:I1,degToRad:L1,radToDeg:D1,isPowerOfTwo:N1,ceilPowerOfTwo:U1,floorPowerOfTwo:Dm,setQuaternionFromProperEuler:O1,normalize:Um,denormalize:Nm},Kt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=we(this.x,t.x,e.x),this.y=we(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=we(this.x,t,e),this.y=we(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(we(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(we(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},hn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*_;m<0&&(d=-d,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),T=Math.sin(x);g=Math.sin(g*x)/T,a=Math.sin(a*x)/T,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+_*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:ne("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(we(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(zx.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(zx.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=we(this.x,t.x,e.x),this.y=we(this.y,t.y,e.y),this.z=we(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=we(this.x,t,e),this.y=we(this.y,t,e),this.z=we(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(we(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Cp.copy(this).projectOnVector(t),this.sub(Cp)}reflect(t){return this.sub(Cp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(we(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Cp=new G,zx=new hn,ce=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],_=s[0],m=s[3],g=s[6],x=s[1],T=s[4],v=s[7],A=s[2],S=s[5],y=s[8];return r[0]=o*_+a*x+l*A,r[3]=o*m+a*T+l*S,r[6]=o*g+a*v+l*y,r[1]=c*_+u*x+h*A,r[4]=c*m+u*T+h*S,r[7]=c*g+u*v+h*y,r[2]=d*_+f*x+p*A,r[5]=d*m+f*T+p*S,r[8]=d*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=h*_,t[1]=(s*c-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(u*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Jl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Pp.makeScale(t,e)),this}rotate(t){return Jl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Pp.makeRotation(-t)),this}translate(t,e){return Jl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Pp.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Pp=new ce,Hx=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Gx=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function F1(){let n={enabled:!0,workingColorSpace:ec,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ve&&(s.r=Sr(s.r),s.g=Sr(s.g),s.b=Sr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ve&&(s.r=Ia(s.r),s.g=Ia(s.g),s.b=Ia(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ir?nc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ec]:{primaries:t,whitePoint:i,transfer:nc,toXYZ:Hx,fromXYZ:Gx,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:wi},outputColorSpaceConfig:{drawingBufferColorSpace:wi}},[wi]:{primaries:t,whitePoint:i,transfer:Ve,toXYZ:Hx,fromXYZ:Gx,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:wi}}}),n}var Le=F1();function Sr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ia(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var xa,xh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{xa===void 0&&(xa=sc("canvas")),xa.width=t.width,xa.height=t.height;let s=xa.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=xa}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=sc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Sr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Sr(e[i]/255)*255):e[i]=Sr(e[i]);return{data:e,width:t.width,height:t.height}}else return ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},B1=0,Ua=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:B1++}),this.uuid=oo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ip(s[o].image)):r.push(Ip(s[o]))}else r=Ip(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Ip(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?xh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ne("Texture: Unable to serialize Texture."),{})}var k1=0,Lp=new G,Ui=class n extends As{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ks,s=Ks,r=Ti,o=Cr,a=Is,l=es,c=n.DEFAULT_ANISOTROPY,u=Ir){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=oo(),this.name="",this.source=new Ua(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Kt(0,0),this.repeat=new Kt(1,1),this.center=new Kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Lp).x}get height(){return this.source.getSize(Lp).y}get depth(){return this.source.getSize(Lp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ne(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ne(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==xm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ph:t.x=t.x-Math.floor(t.x);break;case Ks:t.x=t.x<0?0:1;break;case mh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ph:t.y=t.y-Math.floor(t.y);break;case Ks:t.y=t.y<0?0:1;break;case mh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ui.DEFAULT_IMAGE=null;Ui.DEFAULT_MAPPING=xm;Ui.DEFAULT_ANISOTROPY=1;var vn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,v=(f+1)/2,A=(g+1)/2,S=(u+d)/4,y=(h+_)/4,w=(p+m)/4;return T>v&&T>A?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=S/i,r=y/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=S/s,r=w/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=w/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(h-_)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=we(this.x,t.x,e.x),this.y=we(this.y,t.y,e.y),this.z=we(this.z,t.z,e.z),this.w=we(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=we(this.x,t,e),this.y=we(this.y,t,e),this.z=we(this.z,t,e),this.w=we(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(we(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},_h=class extends As{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ti,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new vn(0,0,t,e),this.scissorTest=!1,this.viewport=new vn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ui({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ti,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ua(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends _h{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},oc=class extends Ui{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Qn,this.minFilter=Qn,this.wrapR=Ks,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var yh=class extends Ui{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Qn,this.minFilter=Qn,this.wrapR=Ks,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ge=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/_a.setFromMatrixColumn(t,0).length(),r=1/_a.setFromMatrixColumn(t,1).length(),o=1/_a.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d+_*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d-_*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+_,e[1]=l*h,e[5]=_*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=_-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-_*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+_,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=_*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(z1,t,H1)}lookAt(t,e,i){let s=this.elements;return ji.subVectors(t,e),ji.lengthSq()===0&&(ji.z=1),ji.normalize(),Xr.crossVectors(i,ji),Xr.lengthSq()===0&&(Math.abs(i.z)===1?ji.x+=1e-4:ji.z+=1e-4,ji.normalize(),Xr.crossVectors(i,ji)),Xr.normalize(),Nu.crossVectors(ji,Xr),s[0]=Xr.x,s[4]=Nu.x,s[8]=ji.x,s[1]=Xr.y,s[5]=Nu.y,s[9]=ji.y,s[2]=Xr.z,s[6]=Nu.z,s[10]=ji.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],_=i[6],m=i[10],g=i[14],x=i[3],T=i[7],v=i[11],A=i[15],S=s[0],y=s[4],w=s[8],U=s[12],L=s[1],N=s[5],H=s[9],$=s[13],P=s[2],z=s[6],D=s[10],B=s[14],Q=s[3],Y=s[7],j=s[11],et=s[15];return r[0]=o*S+a*L+l*P+c*Q,r[4]=o*y+a*N+l*z+c*Y,r[8]=o*w+a*H+l*D+c*j,r[12]=o*U+a*$+l*B+c*et,r[1]=u*S+h*L+d*P+f*Q,r[5]=u*y+h*N+d*z+f*Y,r[9]=u*w+h*H+d*D+f*j,r[13]=u*U+h*$+d*B+f*et,r[2]=p*S+_*L+m*P+g*Q,r[6]=p*y+_*N+m*z+g*Y,r[10]=p*w+_*H+m*D+g*j,r[14]=p*U+_*$+m*B+g*et,r[3]=x*S+T*L+v*P+A*Q,r[7]=x*y+T*N+v*z+A*Y,r[11]=x*w+T*H+v*D+A*j,r[15]=x*U+T*$+v*B+A*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],_=t[7],m=t[11],g=t[15],x=l*f-c*d,T=a*f-c*h,v=a*d-l*h,A=o*f-c*u,S=o*d-l*u,y=o*h-a*u;return e*(_*x-m*T+g*v)-i*(p*x-m*A+g*S)+s*(p*T-_*A+g*y)-r*(p*v-_*S+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],_=t[13],m=t[14],g=t[15],x=e*a-i*o,T=e*l-s*o,v=e*c-r*o,A=i*l-s*a,S=i*c-r*a,y=s*c-r*l,w=u*_-h*p,U=u*m-d*p,L=u*g-f*p,N=h*m-d*_,H=h*g-f*_,$=d*g-f*m,P=x*$-T*H+v*N+A*L-S*U+y*w;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/P;return t[0]=(a*$-l*H+c*N)*z,t[1]=(s*H-i*$-r*N)*z,t[2]=(_*y-m*S+g*A)*z,t[3]=(d*S-h*y-f*A)*z,t[4]=(l*L-o*$-c*U)*z,t[5]=(e*$-s*L+r*U)*z,t[6]=(m*v-p*y-g*T)*z,t[7]=(u*y-d*v+f*T)*z,t[8]=(o*H-a*L+c*w)*z,t[9]=(i*L-e*H-r*w)*z,t[10]=(p*S-_*v+g*x)*z,t[11]=(h*v-u*S-f*x)*z,t[12]=(a*U-o*N-l*w)*z,t[13]=(e*N-i*U+s*w)*z,t[14]=(_*T-p*A-m*x)*z,t[15]=(u*A-h*T+d*x)*z,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,_=o*u,m=o*h,g=a*h,x=l*c,T=l*u,v=l*h,A=i.x,S=i.y,y=i.z;return s[0]=(1-(_+g))*A,s[1]=(f+v)*A,s[2]=(p-T)*A,s[3]=0,s[4]=(f-v)*S,s[5]=(1-(d+g))*S,s[6]=(m+x)*S,s[7]=0,s[8]=(p+T)*y,s[9]=(m-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=_a.set(s[0],s[1],s[2]).length(),a=_a.set(s[4],s[5],s[6]).length(),l=_a.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ws.copy(this);let c=1/o,u=1/a,h=1/l;return ws.elements[0]*=c,ws.elements[1]*=c,ws.elements[2]*=c,ws.elements[4]*=u,ws.elements[5]*=u,ws.elements[6]*=u,ws.elements[8]*=h,ws.elements[9]*=h,ws.elements[10]*=h,e.setFromRotationMatrix(ws),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=us,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===us)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ic)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=us,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===us)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===ic)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},_a=new G,ws=new ge,z1=new G(0,0,0),H1=new G(1,1,1),Xr=new G,Nu=new G,ji=new G,Vx=new ge,Wx=new hn,Qr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(we(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-we(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(we(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-we(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(we(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-we(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Vx.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Vx,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Wx.setFromEuler(this),this.setFromQuaternion(Wx,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Qr.DEFAULT_ORDER="XYZ";var Oa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},G1=0,$x=new G,ya=new hn,_r=new ge,Uu=new G,Wl=new G,V1=new G,W1=new hn,qx=new G(1,0,0),Xx=new G(0,1,0),Yx=new G(0,0,1),Zx={type:"added"},$1={type:"removed"},va={type:"childadded",child:null},Dp={type:"childremoved",child:null},Oi=class n extends As{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:G1++}),this.uuid=oo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new G,e=new Qr,i=new hn,s=new G(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new ce}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Oa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ya.setFromAxisAngle(t,e),this.quaternion.multiply(ya),this}rotateOnWorldAxis(t,e){return ya.setFromAxisAngle(t,e),this.quaternion.premultiply(ya),this}rotateX(t){return this.rotateOnAxis(qx,t)}rotateY(t){return this.rotateOnAxis(Xx,t)}rotateZ(t){return this.rotateOnAxis(Yx,t)}translateOnAxis(t,e){return $x.copy(t).applyQuaternion(this.quaternion),this.position.add($x.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(qx,t)}translateY(t){return this.translateOnAxis(Xx,t)}translateZ(t){return this.translateOnAxis(Yx,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(_r.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Uu.copy(t):Uu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Wl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_r.lookAt(Wl,Uu,this.up):_r.lookAt(Uu,Wl,this.up),this.quaternion.setFromRotationMatrix(_r),s&&(_r.extractRotation(s.matrixWorld),ya.setFromRotationMatrix(_r),this.quaternion.premultiply(ya.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ae("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Zx),va.child=t,this.dispatchEvent(va),va.child=null):ae("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent($1),Dp.child=t,this.dispatchEvent(Dp),Dp.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),_r.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),_r.multiply(t.parent.matrixWorld)),t.applyMatrix4(_r),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Zx),va.child=t,this.dispatchEvent(va),va.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wl,t,V1),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wl,W1,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Oi.DEFAULT_UP=new G(0,1,0);Oi.DEFAULT_MATRIX_AUTO_UPDATE=!0;Oi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var An=class extends Oi{constructor(){super(),this.isGroup=!0,this.type="Group"}},q1={type:"move"},Fa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new An,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new An,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new An,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(q1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new An;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Q_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Yr={h:0,s:0,l:0},Ou={h:0,s:0,l:0};function Np(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var te=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=wi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Le.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Le.workingColorSpace){return this.r=t,this.g=e,this.b=i,Le.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Le.workingColorSpace){if(t=Lm(t,1),e=we(e,0,1),i=we(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Np(o,r,t+1/3),this.g=Np(o,r,t),this.b=Np(o,r,t-1/3)}return Le.colorSpaceToWorking(this,s),this}setStyle(t,e=wi){function i(r){r!==void 0&&parseFloat(r)<1&&ne("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ne("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ne("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=wi){let i=Q_[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ne("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Sr(t.r),this.g=Sr(t.g),this.b=Sr(t.b),this}copyLinearToSRGB(t){return this.r=Ia(t.r),this.g=Ia(t.g),this.b=Ia(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=wi){return Le.workingToColorSpace(hi.copy(this),t),Math.round(we(hi.r*255,0,255))*65536+Math.round(we(hi.g*255,0,255))*256+Math.round(we(hi.b*255,0,255))}getHexString(t=wi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Le.workingColorSpace){Le.workingToColorSpace(hi.copy(this),e);let i=hi.r,s=hi.g,r=hi.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Le.workingColorSpace){return Le.workingToColorSpace(hi.copy(this),e),t.r=hi.r,t.g=hi.g,t.b=hi.b,t}getStyle(t=wi){Le.workingToColorSpace(hi.copy(this),t);let e=hi.r,i=hi.g,s=hi.b;return t!==wi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Yr),this.setHSL(Yr.h+t,Yr.s+e,Yr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Yr),t.getHSL(Ou);let i=Ql(Yr.h,Ou.h,e),s=Ql(Yr.s,Ou.s,e),r=Ql(Yr.l,Ou.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},hi=new te;te.NAMES=Q_;var ac=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new te(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},lc=class extends Oi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Qr,this.environmentIntensity=1,this.environmentRotation=new Qr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Es=new G,yr=new G,Up=new G,vr=new G,ba=new G,Ma=new G,jx=new G,Op=new G,Fp=new G,Bp=new G,kp=new vn,zp=new vn,Hp=new vn,Kr=class n{constructor(t=new G,e=new G,i=new G){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Es.subVectors(t,e),s.cross(Es);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Es.subVectors(s,e),yr.subVectors(i,e),Up.subVectors(t,e);let o=Es.dot(Es),a=Es.dot(yr),l=Es.dot(Up),c=yr.dot(yr),u=yr.dot(Up),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,vr)===null?!1:vr.x>=0&&vr.y>=0&&vr.x+vr.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,vr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vr.x),l.addScaledVector(o,vr.y),l.addScaledVector(a,vr.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return kp.setScalar(0),zp.setScalar(0),Hp.setScalar(0),kp.fromBufferAttribute(t,e),zp.fromBufferAttribute(t,i),Hp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(kp,r.x),o.addScaledVector(zp,r.y),o.addScaledVector(Hp,r.z),o}static isFrontFacing(t,e,i,s){return Es.subVectors(i,e),yr.subVectors(t,e),Es.cross(yr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Es.subVectors(this.c,this.b),yr.subVectors(this.a,this.b),Es.cross(yr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ba.subVectors(s,i),Ma.subVectors(r,i),Op.subVectors(t,i);let l=ba.dot(Op),c=Ma.dot(Op);if(l<=0&&c<=0)return e.copy(i);Fp.subVectors(t,s);let u=ba.dot(Fp),h=Ma.dot(Fp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(ba,o);Bp.subVectors(t,r);let f=ba.dot(Bp),p=Ma.dot(Bp);if(p>=0&&f<=p)return e.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Ma,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return jx.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(jx,a);let g=1/(m+_+d);return o=_*g,a=d*g,e.copy(i).addScaledVector(ba,o).addScaledVector(Ma,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Fi=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ts.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ts.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ts.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ts):Ts.fromBufferAttribute(r,o),Ts.applyMatrix4(t.matrixWorld),this.expandByPoint(Ts);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Fu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Fu.copy(i.boundingBox)),Fu.applyMatrix4(t.matrixWorld),this.union(Fu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ts),Ts.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter($l),Bu.subVectors(this.max,$l),Sa.subVectors(t.a,$l),wa.subVectors(t.b,$l),Ea.subVectors(t.c,$l),Zr.subVectors(wa,Sa),jr.subVectors(Ea,wa),Ro.subVectors(Sa,Ea);let e=[0,-Zr.z,Zr.y,0,-jr.z,jr.y,0,-Ro.z,Ro.y,Zr.z,0,-Zr.x,jr.z,0,-jr.x,Ro.z,0,-Ro.x,-Zr.y,Zr.x,0,-jr.y,jr.x,0,-Ro.y,Ro.x,0];return!Gp(e,Sa,wa,Ea,Bu)||(e=[1,0,0,0,1,0,0,0,1],!Gp(e,Sa,wa,Ea,Bu))?!1:(ku.crossVectors(Zr,jr),e=[ku.x,ku.y,ku.z],Gp(e,Sa,wa,Ea,Bu))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ts).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ts).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(br[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),br[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),br[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),br[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),br[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),br[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),br[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),br[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(br),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},br=[new G,new G,new G,new G,new G,new G,new G,new G],Ts=new G,Fu=new Fi,Sa=new G,wa=new G,Ea=new G,Zr=new G,jr=new G,Ro=new G,$l=new G,Bu=new G,ku=new G,Co=new G;function Gp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Co.fromArray(n,r);let a=s.x*Math.abs(Co.x)+s.y*Math.abs(Co.y)+s.z*Math.abs(Co.z),l=t.dot(Co),c=e.dot(Co),u=i.dot(Co);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var On=new G,zu=new Kt,X1=0,ke=class extends As{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:X1++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Pm,this.updateRanges=[],this.gpuType=hs,this.version=0,this._normalizationScale=t!==void 0?Td(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)zu.fromBufferAttribute(this,e),zu.applyMatrix3(t),this.setXY(e,zu.x,zu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.applyMatrix3(t),this.setXYZ(e,On.x,On.y,On.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.applyMatrix4(t),this.setXYZ(e,On.x,On.y,On.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.applyNormalMatrix(t),this.setXYZ(e,On.x,On.y,On.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)On.fromBufferAttribute(this,e),On.transformDirection(t),this.setXYZ(e,On.x,On.y,On.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Nm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Um(t,this.array)}};var cc=class extends ke{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var uc=class extends ke{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ee=class extends ke{constructor(t,e,i){super(new Float32Array(t),e,i)}},Y1=new Fi,ql=new G,Vp=new G,Qs=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Y1.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ql.subVectors(t,this.center);let e=ql.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ql,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Vp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ql.copy(t.center).add(Vp)),this.expandByPoint(ql.copy(t.center).sub(Vp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Z1=0,cs=new ge,Wp=new Oi,Ta=new G,Ji=new Fi,Xl=new Fi,Kn=new G,Te=class n extends As{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Z1++}),this.uuid=oo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(v1(t)?uc:cc)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ce().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return cs.makeRotationFromQuaternion(t),this.applyMatrix4(cs),this}rotateX(t){return cs.makeRotationX(t),this.applyMatrix4(cs),this}rotateY(t){return cs.makeRotationY(t),this.applyMatrix4(cs),this}rotateZ(t){return cs.makeRotationZ(t),this.applyMatrix4(cs),this}translate(t,e,i){return cs.makeTranslation(t,e,i),this.applyMatrix4(cs),this}scale(t,e,i){return cs.makeScale(t,e,i),this.applyMatrix4(cs),this}lookAt(t){return Wp.lookAt(t),Wp.updateMatrix(),this.applyMatrix4(Wp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ta).negate(),this.translate(Ta.x,Ta.y,Ta.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ee(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ae("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ji.setFromBufferAttribute(r),this.morphTargetsRelative?(Kn.addVectors(this.boundingBox.min,Ji.min),this.boundingBox.expandByPoint(Kn),Kn.addVectors(this.boundingBox.max,Ji.max),this.boundingBox.expandByPoint(Kn)):(this.boundingBox.expandByPoint(Ji.min),this.boundingBox.expandByPoint(Ji.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ae('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Qs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ae("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let i=this.boundingSphere.center;if(Ji.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Xl.setFromBufferAttribute(a),this.morphTargetsRelative?(Kn.addVectors(Ji.min,Xl.min),Ji.expandByPoint(Kn),Kn.addVectors(Ji.max,Xl.max),Ji.expandByPoint(Kn)):(Ji.expandByPoint(Xl.min),Ji.expandByPoint(Xl.max))}Ji.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Kn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Kn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Kn.fromBufferAttribute(a,c),l&&(Ta.fromBufferAttribute(t,c),Kn.add(Ta)),s=Math.max(s,i.distanceToSquared(Kn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ae('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ae("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ke(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new G,l[U]=new G;let u=new G,h=new G,d=new G,f=new Kt,p=new Kt,_=new Kt,m=new G,g=new G;function x(U,L,N){c[U]=c[L]=c[N]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,N),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,L),_.fromBufferAttribute(r,N),h.sub(u),d.sub(u),p.sub(f),_.sub(f);let H=1/(p.x*_.y-_.x*p.y);isFinite(H)&&(m.copy(h).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(H),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(H),a[U].add(m),a[L].add(m),a[N].add(m),l[U].add(g),l[L].add(g),l[N].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let U=0,L=T.length;U<L;++U){let N=T[U],H=N.start,$=N.count;for(let P=H,z=H+$;P<z;P+=3)x(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let v=new G,A=new G,S=new G,y=new G;function w(U){S.fromBufferAttribute(s,U),y.copy(S);let L=a[U];v.copy(L),v.sub(S.multiplyScalar(S.dot(L))).normalize(),A.crossVectors(y,L);let H=A.dot(l[U])<0?-1:1;o.setXYZW(U,v.x,v.y,v.z,H)}for(let U=0,L=i.count;U<L;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ke(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,h=new G;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),_=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Kn.fromBufferAttribute(t,e),Kn.normalize(),t.setXYZ(e,Kn.x,Kn.y,Kn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new ke(d,u,h)}if(this.index===null)return ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ba=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Pm,this.updateRanges=[],this.version=0,this.uuid=oo()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Jx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Jx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Jx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=oo()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Si=new G,ka=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Td(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Si.fromBufferAttribute(this,e),Si.applyMatrix4(t),this.setXYZ(e,Si.x,Si.y,Si.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Si.fromBufferAttribute(this,e),Si.applyNormalMatrix(t),this.setXYZ(e,Si.x,Si.y,Si.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Si.fromBufferAttribute(this,e),Si.transformDirection(t),this.setXYZ(e,Si.x,Si.y,Si.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){rc("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new ke(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){rc("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Nm(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Um(t,this.data.array)}},$p=new G,j1=new G,J1=new ce,ni=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=$p.subVectors(i,e).cross(j1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta($p),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||J1.getNormalMatrix(t),s=this.coplanarPoint($p).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},K1=0,Er=class extends As{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:K1++}),this.uuid=oo(),this.name="",this.type="Material",this.blending=$a,this.side=nr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=am,this.blendDst=lm,this.blendEquation=Fo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new te(0,0,0),this.blendAlpha=0,this.depthFunc=La,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=V_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=oh,this.stencilZFail=oh,this.stencilZPass=oh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ne(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ne(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new te().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ni().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Kt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Mr=new G,qp=new G,Hu=new G,Gu=new G,Tr=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Mr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Mr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Mr.copy(this.origin).addScaledVector(this.direction,e),Mr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){qp.copy(t).add(e).multiplyScalar(.5),Hu.copy(e).sub(t).normalize(),Gu.copy(this.origin).sub(qp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Hu),a=Gu.dot(this.direction),l=-Gu.dot(Hu),c=Gu.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(qp).addScaledVector(Hu,d),f}intersectSphere(t,e){if(t.radius<0)return null;Mr.subVectors(t.center,this.origin);let i=Mr.dot(this.direction),s=Mr.dot(Mr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Mr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,_=e.y-o.y,m=e.z-o.z,g=i.x-o.x,x=i.y-o.y,T=i.z-o.z,v=Math.abs(l),A=Math.abs(c),S=Math.abs(u),y,w,U,L,N,H,$,P,z,D,B,Q;if(v>=A&&v>=S?(U=l,H=h,z=p,Q=g,l>=0?(y=c,w=u,L=d,N=f,$=_,P=m,D=x,B=T):(y=u,w=c,L=f,N=d,$=m,P=_,D=T,B=x)):A>=S?(U=c,H=d,z=_,Q=x,c>=0?(y=u,w=l,L=f,N=h,$=m,P=p,D=T,B=g):(y=l,w=u,L=h,N=f,$=p,P=m,D=g,B=T)):(U=u,H=f,z=m,Q=T,u>=0?(y=l,w=c,L=h,N=d,$=p,P=_,D=g,B=x):(y=c,w=l,L=d,N=h,$=_,P=p,D=x,B=g)),U===0)return null;let Y=y/U,j=w/U,et=1/U,dt=L-Y*H,ft=N-j*H,st=$-Y*z,yt=P-j*z,xt=D-Y*Q,Tt=B-j*Q,At=xt*yt-Tt*st,jt=dt*Tt-ft*xt,pe=st*ft-yt*dt;if(s){if(At<0||jt<0||pe<0)return null}else if((At<0||jt<0||pe<0)&&(At>0||jt>0||pe>0))return null;let Yt=At+jt+pe;if(Yt===0)return null;let Se=et*(At*H+jt*z+pe*Q);return(Yt>0?Se<0:Se>0)?null:this.at(Se/Yt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ii=class extends Er{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new te(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qr,this.combine=cm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Kx=new ge,Po=new Tr,Vu=new Qs,Qx=new G,Wu=new G,$u=new G,qu=new G,Xp=new G,Xu=new G,t_=new G,Yu=new G,Ye=class extends Oi{constructor(t=new Te,e=new ii){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Xu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Xp.fromBufferAttribute(h,t),o?Xu.addScaledVector(Xp,u):Xu.addScaledVector(Xp.sub(e),u))}e.add(Xu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Vu.copy(i.boundingSphere),Vu.applyMatrix4(r),Po.copy(t.ray).recast(t.near),!(Vu.containsPoint(Po.origin)===!1&&(Po.intersectSphere(Vu,Qx)===null||Po.origin.distanceToSquared(Qx)>(t.far-t.near)**2))&&(Kx.copy(r).invert(),Po.copy(t.ray).applyMatrix4(Kx),!(i.boundingBox!==null&&Po.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Po)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),T=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=T;v<A;v+=3){let S=a.getX(v),y=a.getX(v+1),w=a.getX(v+2);s=Zu(this,g,t,i,c,u,h,S,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),T=a.getX(m+1),v=a.getX(m+2);s=Zu(this,o,t,i,c,u,h,x,T,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),T=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=T;v<A;v+=3){let S=v,y=v+1,w=v+2;s=Zu(this,g,t,i,c,u,h,S,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,T=m+1,v=m+2;s=Zu(this,o,t,i,c,u,h,x,T,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Q1(n,t,e,i,s,r,o,a){let l;if(t.side===si?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===nr,a),l===null)return null;Yu.copy(a),Yu.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Yu);return c<e.near||c>e.far?null:{distance:c,point:Yu.clone(),object:n}}function Zu(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Wu),n.getVertexPosition(l,$u),n.getVertexPosition(c,qu);let u=Q1(n,t,e,i,Wu,$u,qu,t_);if(u){let h=new G;Kr.getBarycoord(t_,Wu,$u,qu,h),s&&(u.uv=Kr.getInterpolatedAttribute(s,a,l,c,h,new Kt)),r&&(u.uv1=Kr.getInterpolatedAttribute(r,a,l,c,h,new Kt)),o&&(u.normal=Kr.getInterpolatedAttribute(o,a,l,c,h,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new G,materialIndex:0};Kr.getNormal(Wu,$u,qu,d.normal),u.face=d,u.barycoord=h}return u}var hc=class extends Ui{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Qn,u=Qn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var za=class extends ke{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Aa=new ge,e_=new ge,ju=[],n_=new Fi,tE=new ge,Yl=new Ye,Zl=new Qs,dc=class extends Ye{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new za(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,tE)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Fi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Aa),n_.copy(t.boundingBox).applyMatrix4(Aa),this.boundingBox.union(n_)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Qs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Aa),Zl.copy(t.boundingSphere).applyMatrix4(Aa),this.boundingSphere.union(Zl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Yl.geometry=this.geometry,Yl.material=this.material,Yl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Zl.copy(this.boundingSphere),Zl.applyMatrix4(i),t.ray.intersectsSphere(Zl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Aa),e_.multiplyMatrices(i,Aa),Yl.matrixWorld=e_,Yl.raycast(t,ju);for(let o=0,a=ju.length;o<a;o++){let l=ju[o];l.instanceId=r,l.object=this,e.push(l)}ju.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new za(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new hc(new Float32Array(s*this.count),s,this.count,$h,hs));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Io=new Qs,eE=new Kt(.5,.5),Ju=new G,Lo=class{constructor(t=new ni,e=new ni,i=new ni,s=new ni,r=new ni,o=new ni){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=us,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],T=r[13],v=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-p,A-x).normalize(),s[1].setComponents(c+o,f+u,g+p,A+x).normalize(),s[2].setComponents(c+a,f+h,g+_,A+T).normalize(),s[3].setComponents(c-a,f-h,g-_,A-T).normalize(),i)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,f-d,g-m,A-v).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-v).normalize(),e===us)s[5].setComponents(c+l,f+d,g+m,A+v).normalize();else if(e===ic)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Io.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Io.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Io)}intersectsSprite(t){Io.center.set(0,0,0);let e=eE.distanceTo(t.center);return Io.radius=.7071067811865476+e,Io.applyMatrix4(t.matrixWorld),this.intersectsSphere(Io)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ju.x=s.normal.x>0?t.max.x:t.min.x,Ju.y=s.normal.y>0?t.max.y:t.min.y,Ju.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ju)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},i_=new ge,vh=class n{constructor(){this.coordinateSystem=us,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];i_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Lo),i[s].setFromProjectionMatrix(i_,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Lo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Qi=class extends Er{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new te(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},bh=new G,Mh=new G,s_=new ge,jl=new Tr,Ku=new Qs,Yp=new G,r_=new G,tr=class extends Oi{constructor(t=new Te,e=new Qi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)bh.fromBufferAttribute(e,s-1),Mh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=bh.distanceTo(Mh);t.setAttribute("lineDistance",new Ee(i,1))}else ne("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ku.copy(i.boundingSphere),Ku.applyMatrix4(s),Ku.radius+=r,t.ray.intersectsSphere(Ku)===!1)return;s_.copy(s).invert(),jl.copy(t.ray).applyMatrix4(s_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=u.getX(_),x=u.getX(_+1),T=Qu(this,t,jl,l,g,x,_);T&&e.push(T)}if(this.isLineLoop){let _=u.getX(p-1),m=u.getX(f),g=Qu(this,t,jl,l,_,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=Qu(this,t,jl,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=Qu(this,t,jl,l,p-1,f,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Qu(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(bh.fromBufferAttribute(a,s),Mh.fromBufferAttribute(a,r),e.distanceSqToSegment(bh,Mh,Yp,r_)>i)return;Yp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Yp);if(!(c<t.near||c>t.far))return{distance:c,point:r_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var o_=new G,a_=new G,Do=class extends tr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)o_.fromBufferAttribute(e,s),a_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+o_.distanceTo(a_);t.setAttribute("lineDistance",new Ee(i,1))}else ne("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var er=class extends Er{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new te(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},l_=new ge,Qp=new Tr,th=new Qs,eh=new G,Ar=class extends Oi{constructor(t=new Te,e=new er){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),th.copy(i.boundingSphere),th.applyMatrix4(s),th.radius+=r,t.ray.intersectsSphere(th)===!1)return;l_.copy(s).invert(),Qp.copy(t.ray).applyMatrix4(l_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,_=f;p<_;p++){let m=c.getX(p);eh.fromBufferAttribute(h,m),c_(eh,m,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,_=f;p<_;p++)eh.fromBufferAttribute(h,p),c_(eh,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function c_(n,t,e,i,s,r,o){let a=Qp.distanceSqToPoint(n);if(a<e){let l=new G;Qp.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var fc=class extends Ui{constructor(t=[],e=Bo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Rr=class extends Ui{constructor(t,e,i=Cs,s,r,o,a=Qn,l=Qn,c,u=wr,h=1){if(u!==wr&&u!==Pr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ua(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},pc=class extends Rr{constructor(t,e=Cs,i=Bo,s,r,o=Qn,a=Qn,l,c=wr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},mc=class extends Ui{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Bi=class n extends Te{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ee(c,3)),this.setAttribute("normal",new Ee(u,3)),this.setAttribute("uv",new Ee(h,2));function p(_,m,g,x,T,v,A,S,y,w,U){let L=v/y,N=A/w,H=v/2,$=A/2,P=S/2,z=y+1,D=w+1,B=0,Q=0,Y=new G;for(let j=0;j<D;j++){let et=j*N-$;for(let dt=0;dt<z;dt++){let ft=dt*L-H;Y[_]=ft*x,Y[m]=et*T,Y[g]=P,c.push(Y.x,Y.y,Y.z),Y[_]=0,Y[m]=0,Y[g]=S>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(dt/y),h.push(1-j/w),B+=1}}for(let j=0;j<w;j++)for(let et=0;et<y;et++){let dt=d+et+z*j,ft=d+et+z*(j+1),st=d+(et+1)+z*(j+1),yt=d+(et+1)+z*j;l.push(dt,ft,yt),l.push(ft,st,yt),Q+=6}a.addGroup(f,Q,U),f+=Q,d+=B}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},No=class n extends Te{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,_=s+1,m=new G,g=new G;for(let x=0;x<=p;x++){let T=0,v=0,A=0,S=0;if(x<=i){let U=x/i,L=U*Math.PI/2;v=-u-t*Math.cos(L),A=t*Math.sin(L),S=-t*Math.cos(L),T=U*h}else if(x<=i+r){let U=(x-i)/r;v=-u+U*e,A=t,S=0,T=h+U*d}else{let U=(x-i-r)/i,L=U*Math.PI/2;v=u+t*Math.sin(L),A=t*Math.cos(L),S=t*Math.sin(L),T=h+d+U*h}let y=Math.max(0,Math.min(1,T/f)),w=0;x===0?w=.5/s:x===p&&(w=-.5/s);for(let U=0;U<=s;U++){let L=U/s,N=L*Math.PI*2,H=Math.sin(N),$=Math.cos(N);g.x=-A*$,g.y=v,g.z=A*H,a.push(g.x,g.y,g.z),m.set(-A*$,S,A*H),m.normalize(),l.push(m.x,m.y,m.z),c.push(L+w,y)}if(x>0){let U=(x-1)*_;for(let L=0;L<s;L++){let N=U+L,H=U+L+1,$=x*_+L,P=x*_+L+1;o.push(N,H,$),o.push(H,P,$)}}}this.setIndex(o),this.setAttribute("position",new Ee(a,3)),this.setAttribute("normal",new Ee(l,3)),this.setAttribute("uv",new Ee(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},gc=class n extends Te{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new G,u=new Kt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new Ee(o,3)),this.setAttribute("normal",new Ee(a,3)),this.setAttribute("uv",new Ee(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ai=class n extends Te{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,_=[],m=i/2,g=0;x(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Ee(h,3)),this.setAttribute("normal",new Ee(d,3)),this.setAttribute("uv",new Ee(f,2));function x(){let v=new G,A=new G,S=0,y=(e-t)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,N=L*(e-t)+t;for(let H=0;H<=s;H++){let $=H/s,P=$*l+a,z=Math.sin(P),D=Math.cos(P);A.x=N*z,A.y=-L*i+m,A.z=N*D,h.push(A.x,A.y,A.z),v.set(z,y,D).normalize(),d.push(v.x,v.y,v.z),f.push($,1-L),U.push(p++)}_.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=_[U][w],N=_[U+1][w],H=_[U+1][w+1],$=_[U][w+1];(t>0||U!==0)&&(u.push(L,N,$),S+=3),(e>0||U!==r-1)&&(u.push(N,H,$),S+=3)}c.addGroup(g,S,0),g+=S}function T(v){let A=p,S=new Kt,y=new G,w=0,U=v===!0?t:e,L=v===!0?1:-1;for(let H=1;H<=s;H++)h.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let N=p;for(let H=0;H<=s;H++){let P=H/s*l+a,z=Math.cos(P),D=Math.sin(P);y.x=U*D,y.y=m*L,y.z=U*z,h.push(y.x,y.y,y.z),d.push(0,L,0),S.x=z*.5+.5,S.y=D*.5*L+.5,f.push(S.x,S.y),p++}for(let H=0;H<s;H++){let $=A+H,P=N+H;v===!0?u.push(P,P+1,$):u.push(P+1,P,$),w+=3}c.addGroup(g,w,v===!0?1:2),g+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Uo=class n extends Ai{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Sh=class n extends Te{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Ee(r,3)),this.setAttribute("normal",new Ee(r.slice(),3)),this.setAttribute("uv",new Ee(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let T=new G,v=new G,A=new G;for(let S=0;S<e.length;S+=3)f(e[S+0],T),f(e[S+1],v),f(e[S+2],A),l(T,v,A,x)}function l(x,T,v,A){let S=A+1,y=[];for(let w=0;w<=S;w++){y[w]=[];let U=x.clone().lerp(v,w/S),L=T.clone().lerp(v,w/S),N=S-w;for(let H=0;H<=N;H++)H===0&&w===S?y[w][H]=U:y[w][H]=U.clone().lerp(L,H/N)}for(let w=0;w<S;w++)for(let U=0;U<2*(S-w)-1;U++){let L=Math.floor(U/2);U%2===0?(d(y[w][L+1]),d(y[w+1][L]),d(y[w][L])):(d(y[w][L+1]),d(y[w+1][L+1]),d(y[w+1][L]))}}function c(x){let T=new G;for(let v=0;v<r.length;v+=3)T.x=r[v+0],T.y=r[v+1],T.z=r[v+2],T.normalize().multiplyScalar(x),r[v+0]=T.x,r[v+1]=T.y,r[v+2]=T.z}function u(){let x=new G;for(let T=0;T<r.length;T+=3){x.x=r[T+0],x.y=r[T+1],x.z=r[T+2];let v=m(x)/2/Math.PI+.5,A=g(x)/Math.PI+.5;o.push(v,1-A)}p(),h()}function h(){for(let x=0;x<o.length;x+=6){let T=o[x+0],v=o[x+2],A=o[x+4],S=Math.max(T,v,A),y=Math.min(T,v,A);S>.9&&y<.1&&(T<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,T){let v=x*3;T.x=t[v+0],T.y=t[v+1],T.z=t[v+2]}function p(){let x=new G,T=new G,v=new G,A=new G,S=new Kt,y=new Kt,w=new Kt;for(let U=0,L=0;U<r.length;U+=9,L+=6){x.set(r[U+0],r[U+1],r[U+2]),T.set(r[U+3],r[U+4],r[U+5]),v.set(r[U+6],r[U+7],r[U+8]),S.set(o[L+0],o[L+1]),y.set(o[L+2],o[L+3]),w.set(o[L+4],o[L+5]),A.copy(x).add(T).add(v).divideScalar(3);let N=m(A);_(S,L+0,x,N),_(y,L+2,T,N),_(w,L+4,v,N)}}function _(x,T,v,A){A<0&&x.x===1&&(o[T]=x.x-1),v.x===0&&v.z===0&&(o[T]=A/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var xc=class n extends Te{constructor(t=[new Kt(0,-.5),new Kt(.5,0),new Kt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=we(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new G,d=new Kt,f=new G,p=new G,_=new G,m=0,g=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,_.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:_.normalize(),l.push(_.x,_.y,_.z);break;default:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=_.x,f.y+=_.y,f.z+=_.z,f.normalize(),l.push(f.x,f.y,f.z),_.copy(p)}for(let x=0;x<=e;x++){let T=i+x*u*s,v=Math.sin(T),A=Math.cos(T);for(let S=0;S<=t.length-1;S++){h.x=t[S].x*v,h.y=t[S].y,h.z=t[S].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=S/(t.length-1),a.push(d.x,d.y);let y=l[3*S+0]*v,w=l[3*S+1],U=l[3*S+0]*A;c.push(y,w,U)}}for(let x=0;x<e;x++)for(let T=0;T<t.length-1;T++){let v=T+x*t.length,A=v,S=v+t.length,y=v+t.length+1,w=v+1;r.push(A,S,w),r.push(y,w,S)}this.setIndex(r),this.setAttribute("position",new Ee(o,3)),this.setAttribute("uv",new Ee(a,2)),this.setAttribute("normal",new Ee(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},_c=class n extends Sh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},yc=class n extends Te{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],_=[],m=[];for(let g=0;g<u;g++){let x=g*d-o;for(let T=0;T<c;T++){let v=T*h-r;p.push(v,-x,0),_.push(0,0,1),m.push(T/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let T=x+c*g,v=x+c*(g+1),A=x+1+c*(g+1),S=x+1+c*g;f.push(T,v,S),f.push(v,A,S)}this.setIndex(f),this.setAttribute("position",new Ee(p,3)),this.setAttribute("normal",new Ee(_,3)),this.setAttribute("uv",new Ee(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Rs=class n extends Te{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new G,d=new G,f=[],p=[],_=[],m=[];for(let g=0;g<=i;g++){let x=[],T=g/i,v=o+T*a,A=t*Math.cos(v),S=Math.sqrt(t*t-A*A),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let w=0;w<=e;w++){let U=w/e,L=s+U*r;h.x=-S*Math.cos(L),h.y=A,h.z=S*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),m.push(U+y,1-T),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let T=u[g][x+1],v=u[g][x],A=u[g+1][x],S=u[g+1][x+1];(g!==0||o>0)&&f.push(T,v,S),(g!==i-1||l<Math.PI)&&f.push(v,A,S)}this.setIndex(f),this.setAttribute("position",new Ee(p,3)),this.setAttribute("normal",new Ee(_,3)),this.setAttribute("uv",new Ee(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ha=class n extends Te{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new G,f=new G,p=new G;for(let _=0;_<=i;_++){let m=o+_/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(x),f.y=(t+e*Math.cos(m))*Math.sin(x),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(g/s),h.push(_/i)}}for(let _=1;_<=i;_++)for(let m=1;m<=s;m++){let g=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,T=(s+1)*(_-1)+m,v=(s+1)*_+m;l.push(g,x,v),l.push(x,T,v)}this.setIndex(l),this.setAttribute("position",new Ee(c,3)),this.setAttribute("normal",new Ee(u,3)),this.setAttribute("uv",new Ee(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function zo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(u_(s))s.isRenderTargetTexture?(ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(u_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function pi(n){let t={};for(let e=0;e<n.length;e++){let i=zo(n[e]);for(let s in i)t[s]=i[s]}return t}function u_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function nE(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Om(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Le.workingColorSpace}var ty={clone:zo,merge:pi},iE=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,sE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,di=class extends Er{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=iE,this.fragmentShader=sE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=zo(t.uniforms),this.uniformsGroups=nE(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new te().setHex(s.value);break;case"v2":this.uniforms[i].value=new Kt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new vn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ce().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ge().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},wh=class extends di{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Eh=class extends Er{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=H_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Th=class extends Er{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ra(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function nh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var to=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ah=class extends to{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:jp,endingEnd:jp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Jp:r=t,a=2*e-i;break;case Kp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Jp:o=t,l=2*i-e;break;case Kp:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),_=p*p,m=_*p,g=-d*m+2*d*_-d*p,x=(1+d)*m+(-1.5-2*d)*_+(-.5+d)*p+1,T=(-1-f)*m+(1.5+f)*_+.5*p,v=f*m-f*_;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[c+A]+T*o[l+A]+v*o[h+A];return r}},Rh=class extends to{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Ch=class extends to{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ph=class extends to{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*d+p*2,x=h[g],T=h[g+1],v=t*d+p*2,A=u[v],S=u[v+1],y=oE(i,e,x,A,s);r[p]=ey(y,_,T,S,m)}return r}};function ey(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function rE(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function oE(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=ey(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=rE(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ts=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ra(e,this.TimeBufferType),this.values=Ra(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ra(t.times,Array),values:Ra(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),nh(t.settings)&&(i.settings={inTangents:Ra(t.settings.inTangents,Array),outTangents:Ra(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ch(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Rh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ah(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ph(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case tc:e=this.InterpolantFactoryMethodDiscrete;break;case gh:e=this.InterpolantFactoryMethodLinear;break;case rh:e=this.InterpolantFactoryMethodSmooth;break;case Zp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ne("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return tc;case this.InterpolantFactoryMethodLinear:return gh;case this.InterpolantFactoryMethodSmooth:return rh;case this.InterpolantFactoryMethodBezier:return Zp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;nh(this.settings)&&(h_(this.settings.inTangents,t),h_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;nh(this.settings)&&(d_(this.settings.inTangents,t),d_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ae("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ae("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ae("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ae("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&b1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ae("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===rh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let _=e[h+p];if(_!==e[d+p]||_!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,nh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function h_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function d_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ts.prototype.ValueTypeName="";ts.prototype.TimeBufferType=Float32Array;ts.prototype.ValueBufferType=Float32Array;ts.prototype.DefaultInterpolation=gh;var eo=class extends ts{constructor(t,e,i){super(t,e,i)}};eo.prototype.ValueTypeName="bool";eo.prototype.ValueBufferType=Array;eo.prototype.DefaultInterpolation=tc;eo.prototype.InterpolantFactoryMethodLinear=void 0;eo.prototype.InterpolantFactoryMethodSmooth=void 0;var Ih=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}};Ih.prototype.ValueTypeName="color";var Lh=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}};Lh.prototype.ValueTypeName="number";var Dh=class extends to{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)hn.slerpFlat(r,0,o,c-a,o,c,l);return r}},vc=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Dh(this.times,this.values,this.getValueSize(),t)}};vc.prototype.ValueTypeName="quaternion";vc.prototype.InterpolantFactoryMethodSmooth=void 0;var no=class extends ts{constructor(t,e,i){super(t,e,i)}};no.prototype.ValueTypeName="string";no.prototype.ValueBufferType=Array;no.prototype.DefaultInterpolation=tc;no.prototype.InterpolantFactoryMethodLinear=void 0;no.prototype.InterpolantFactoryMethodSmooth=void 0;var Nh=class extends ts{constructor(t,e,i,s){super(t,e,i,s)}};Nh.prototype.ValueTypeName="vector";var Uh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ny=new Uh,Oh=class{constructor(t){this.manager=t!==void 0?t:ny,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Oh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ih=new G,sh=new hn,Js=new G,bc=class extends Oi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,this.coordinateSystem=us,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ih,sh,Js),Js.x===1&&Js.y===1&&Js.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ih,sh,Js.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ih,sh,Js),Js.x===1&&Js.y===1&&Js.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ih,sh,Js.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Jr=new G,f_=new Kt,p_=new Kt,Ei=class extends bc{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Na*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Kl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Na*2*Math.atan(Math.tan(Kl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Jr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Jr.x,Jr.y).multiplyScalar(-t/Jr.z),Jr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Jr.x,Jr.y).multiplyScalar(-t/Jr.z)}getViewSize(t,e){return this.getViewBounds(t,f_,p_),e.subVectors(p_,f_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Kl*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Fh=class extends bc{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Ca=-90,Pa=1,Ga=class extends Oi{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ei(Ca,Pa,t,e);s.layers=this.layers,this.add(s);let r=new Ei(Ca,Pa,t,e);r.layers=this.layers,this.add(r);let o=new Ei(Ca,Pa,t,e);o.layers=this.layers,this.add(o);let a=new Ei(Ca,Pa,t,e);a.layers=this.layers,this.add(a);let l=new Ei(Ca,Pa,t,e);l.layers=this.layers,this.add(l);let c=new Ei(Ca,Pa,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===us)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ic)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Bh=class extends Ei{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Fm="\\[\\]\\.:\\/",aE=new RegExp("["+Fm+"]","g"),Bm="[^"+Fm+"]",lE="[^"+Fm.replace("\\.","")+"]",cE=/((?:WC+[\/:])*)/.source.replace("WC",Bm),uE=/(WCOD+)?/.source.replace("WCOD",lE),hE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Bm),dE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Bm),fE=new RegExp("^"+cE+uE+hE+dE+"$"),pE=["material","materials","bones","map"],tm=class{constructor(t,e,i){let s=i||un.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},un=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(aE,"")}static parseTrackName(t){let e=fE.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);pE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ne("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ae("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ae("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ae("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ae("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ae("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ae("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ae("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ae("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ae("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ae("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};un.Composite=tm;un.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};un.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};un.prototype.GetterByBindingType=[un.prototype._getValue_direct,un.prototype._getValue_array,un.prototype._getValue_arrayElement,un.prototype._getValue_toArray];un.prototype.SetterByBindingTypeAndVersioning=[[un.prototype._setValue_direct,un.prototype._setValue_direct_setNeedsUpdate,un.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[un.prototype._setValue_array,un.prototype._setValue_array_setNeedsUpdate,un.prototype._setValue_array_setMatrixWorldNeedsUpdate],[un.prototype._setValue_arrayElement,un.prototype._setValue_arrayElement_setNeedsUpdate,un.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[un.prototype._setValue_fromArray,un.prototype._setValue_fromArray_setNeedsUpdate,un.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var FD=new Float32Array(1);var m_=new ge,Mc=class{constructor(t,e,i=0,s=1/0){this.ray=new Tr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Oa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ae("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return m_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(m_),this}intersectObject(t,e=!0,i=[]){return em(t,this,i,e),i.sort(g_),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)em(t[s],this,i,e);return i.sort(g_),i}};function g_(n,t){return n.distance-t.distance}function em(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)em(r[o],t,e,!0)}}var Va=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=we(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(we(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var nm=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Sc=class extends As{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function km(n,t,e,i){let s=mE(i);switch(e){case Mm:return n*t;case $h:return n*t/s.components*s.byteLength;case qh:return n*t/s.components*s.byteLength;case ro:return n*t*2/s.components*s.byteLength;case Xh:return n*t*2/s.components*s.byteLength;case Sm:return n*t*3/s.components*s.byteLength;case Is:return n*t*4/s.components*s.byteLength;case Yh:return n*t*4/s.components*s.byteLength;case Tc:case Ac:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Rc:case Cc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case jh:case Kh:return Math.max(n,16)*Math.max(t,8)/4;case Zh:case Jh:return Math.max(n,8)*Math.max(t,8)/2;case Qh:case td:case nd:case id:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ed:case Pc:case sd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case rd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case od:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ad:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case ld:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case cd:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case ud:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case hd:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case dd:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case fd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case pd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case md:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case gd:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case xd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case _d:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case yd:case vd:case bd:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Md:case Sd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ic:case wd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function mE(n){switch(n){case es:case _m:return{byteLength:1,components:1};case Xa:case ym:case Ps:return{byteLength:2,components:1};case Vh:case Wh:return{byteLength:2,components:4};case Cs:case Gh:case hs:return{byteLength:4,components:1};case vm:case bm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function wy(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function vE(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],_=h[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let _=h[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var bE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ME=`#ifdef USE_ALPHAHASH
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
#endif`,SE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,EE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,TE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,AE=`#ifdef USE_AOMAP
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
#endif`,RE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,CE=`#ifdef USE_BATCHING
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
#endif`,PE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,IE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,LE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,NE=`#ifdef USE_IRIDESCENCE
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
#endif`,UE=`#ifdef USE_BUMPMAP
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
#endif`,OE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,FE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,BE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,kE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,HE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,GE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,VE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,WE=`#define PI 3.141592653589793
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
} // validated`,$E=`vec3 transformedNormal = objectNormal;
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
#endif`,qE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,XE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,YE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ZE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,jE="gl_FragColor = linearToOutputTexel( gl_FragColor );",JE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,KE=`#ifdef USE_ENVMAP
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
#endif`,QE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tT=`#ifdef USE_ENVMAP
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
#endif`,eT=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nT=`#ifdef USE_ENVMAP
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
#endif`,iT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,oT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,aT=`#ifdef USE_GRADIENTMAP
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
}`,lT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,hT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,dT=`#ifdef USE_ENVMAP
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
#endif`,fT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gT=`varying vec3 vViewPosition;
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
#endif`,_T=`uniform sampler2D dfgLUT;
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
}`,yT=`
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
#endif`,vT=`#if defined( RE_IndirectDiffuse )
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
#endif`,bT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,MT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ST=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ET=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,AT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,RT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,CT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,PT=`#if defined( USE_POINTS_UV )
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
#endif`,IT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,LT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,DT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,NT=`#if defined( USE_MORPHCOLORS )
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
#endif`,UT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,OT=`#ifdef USE_MORPHTARGETS
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
#endif`,FT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,BT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,kT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,zT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,GT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,VT=`#ifdef USE_NORMALMAP
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
#endif`,WT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$T=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,XT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,YT=`#ifdef OPAQUE
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
}`,jT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,JT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,KT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,QT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,eA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,iA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,sA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,rA=`float getShadowMask() {
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
}`,oA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aA=`#ifdef USE_SKINNING
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
#endif`,lA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cA=`#ifdef USE_SKINNING
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
#endif`,uA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,hA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,fA=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,pA=`#ifdef USE_TRANSMISSION
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
#endif`,mA=`#ifdef USE_TRANSMISSION
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
#endif`,gA=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_A=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,yA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,vA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bA=`uniform sampler2D t2D;
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
}`,MA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,SA=`uniform float backgroundBlurriness;
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
}`,wA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,EA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,TA=`#include <common>
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
}`,AA=`#if DEPTH_PACKING == 3200
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
}`,RA=`#define DISTANCE
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
}`,CA=`#define DISTANCE
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
}`,PA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LA=`uniform float scale;
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
}`,DA=`uniform vec3 diffuse;
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
}`,NA=`#include <common>
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
}`,UA=`uniform vec3 diffuse;
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
}`,OA=`#define LAMBERT
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
}`,FA=`#define LAMBERT
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
}`,BA=`#define MATCAP
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
}`,kA=`#define MATCAP
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
}`,zA=`#define NORMAL
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
}`,HA=`#define NORMAL
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
}`,GA=`#define PHONG
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
}`,VA=`#define PHONG
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
}`,WA=`#define STANDARD
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
}`,$A=`#define STANDARD
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
}`,qA=`#define TOON
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
}`,XA=`#define TOON
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
}`,YA=`uniform float size;
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
}`,jA=`#include <common>
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
}`,JA=`uniform vec3 color;
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
}`,KA=`uniform float rotation;
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
}`,QA=`uniform vec3 diffuse;
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
}`,Me={alphahash_fragment:bE,alphahash_pars_fragment:ME,alphamap_fragment:SE,alphamap_pars_fragment:wE,alphatest_fragment:EE,alphatest_pars_fragment:TE,aomap_fragment:AE,aomap_pars_fragment:RE,batching_pars_vertex:CE,batching_vertex:PE,begin_vertex:IE,beginnormal_vertex:LE,bsdfs:DE,iridescence_fragment:NE,bumpmap_pars_fragment:UE,clipping_planes_fragment:OE,clipping_planes_pars_fragment:FE,clipping_planes_pars_vertex:BE,clipping_planes_vertex:kE,color_fragment:zE,color_pars_fragment:HE,color_pars_vertex:GE,color_vertex:VE,common:WE,defaultnormal_vertex:$E,displacementmap_pars_vertex:qE,displacementmap_vertex:XE,emissivemap_fragment:YE,emissivemap_pars_fragment:ZE,colorspace_fragment:jE,colorspace_pars_fragment:JE,envmap_fragment:KE,envmap_common_pars_fragment:QE,envmap_pars_fragment:tT,envmap_pars_vertex:eT,envmap_physical_pars_fragment:dT,envmap_vertex:nT,fog_vertex:iT,fog_pars_vertex:sT,fog_fragment:rT,fog_pars_fragment:oT,gradientmap_pars_fragment:aT,lightmap_pars_fragment:lT,lights_lambert_fragment:cT,lights_lambert_pars_fragment:uT,lights_pars_begin:hT,lights_toon_fragment:fT,lights_toon_pars_fragment:pT,lights_phong_fragment:mT,lights_phong_pars_fragment:gT,lights_physical_fragment:xT,lights_physical_pars_fragment:_T,lights_fragment_begin:yT,lights_fragment_maps:vT,lights_fragment_end:bT,lightprobes_pars_fragment:MT,logdepthbuf_fragment:ST,logdepthbuf_pars_fragment:wT,logdepthbuf_pars_vertex:ET,logdepthbuf_vertex:TT,map_fragment:AT,map_pars_fragment:RT,map_particle_fragment:CT,map_particle_pars_fragment:PT,metalnessmap_fragment:IT,metalnessmap_pars_fragment:LT,morphinstance_vertex:DT,morphcolor_vertex:NT,morphnormal_vertex:UT,morphtarget_pars_vertex:OT,morphtarget_vertex:FT,normal_fragment_begin:BT,normal_fragment_maps:kT,normal_pars_fragment:zT,normal_pars_vertex:HT,normal_vertex:GT,normalmap_pars_fragment:VT,clearcoat_normal_fragment_begin:WT,clearcoat_normal_fragment_maps:$T,clearcoat_pars_fragment:qT,iridescence_pars_fragment:XT,opaque_fragment:YT,packing:ZT,premultiplied_alpha_fragment:jT,project_vertex:JT,dithering_fragment:KT,dithering_pars_fragment:QT,roughnessmap_fragment:tA,roughnessmap_pars_fragment:eA,shadowmap_pars_fragment:nA,shadowmap_pars_vertex:iA,shadowmap_vertex:sA,shadowmask_pars_fragment:rA,skinbase_vertex:oA,skinning_pars_vertex:aA,skinning_vertex:lA,skinnormal_vertex:cA,specularmap_fragment:uA,specularmap_pars_fragment:hA,tonemapping_fragment:dA,tonemapping_pars_fragment:fA,transmission_fragment:pA,transmission_pars_fragment:mA,uv_pars_fragment:gA,uv_pars_vertex:xA,uv_vertex:_A,worldpos_vertex:yA,background_vert:vA,background_frag:bA,backgroundCube_vert:MA,backgroundCube_frag:SA,cube_vert:wA,cube_frag:EA,depth_vert:TA,depth_frag:AA,distance_vert:RA,distance_frag:CA,equirect_vert:PA,equirect_frag:IA,linedashed_vert:LA,linedashed_frag:DA,meshbasic_vert:NA,meshbasic_frag:UA,meshlambert_vert:OA,meshlambert_frag:FA,meshmatcap_vert:BA,meshmatcap_frag:kA,meshnormal_vert:zA,meshnormal_frag:HA,meshphong_vert:GA,meshphong_frag:VA,meshphysical_vert:WA,meshphysical_frag:$A,meshtoon_vert:qA,meshtoon_frag:XA,points_vert:YA,points_frag:ZA,shadow_vert:jA,shadow_frag:JA,sprite_vert:KA,sprite_frag:QA},Bt={common:{diffuse:{value:new te(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new Kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new te(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new te(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new te(16777215)},opacity:{value:1},center:{value:new Kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},rr={basic:{uniforms:pi([Bt.common,Bt.specularmap,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.fog]),vertexShader:Me.meshbasic_vert,fragmentShader:Me.meshbasic_frag},lambert:{uniforms:pi([Bt.common,Bt.specularmap,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.fog,Bt.lights,{emissive:{value:new te(0)},envMapIntensity:{value:1}}]),vertexShader:Me.meshlambert_vert,fragmentShader:Me.meshlambert_frag},phong:{uniforms:pi([Bt.common,Bt.specularmap,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.fog,Bt.lights,{emissive:{value:new te(0)},specular:{value:new te(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Me.meshphong_vert,fragmentShader:Me.meshphong_frag},standard:{uniforms:pi([Bt.common,Bt.envmap,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.roughnessmap,Bt.metalnessmap,Bt.fog,Bt.lights,{emissive:{value:new te(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Me.meshphysical_vert,fragmentShader:Me.meshphysical_frag},toon:{uniforms:pi([Bt.common,Bt.aomap,Bt.lightmap,Bt.emissivemap,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.gradientmap,Bt.fog,Bt.lights,{emissive:{value:new te(0)}}]),vertexShader:Me.meshtoon_vert,fragmentShader:Me.meshtoon_frag},matcap:{uniforms:pi([Bt.common,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,Bt.fog,{matcap:{value:null}}]),vertexShader:Me.meshmatcap_vert,fragmentShader:Me.meshmatcap_frag},points:{uniforms:pi([Bt.points,Bt.fog]),vertexShader:Me.points_vert,fragmentShader:Me.points_frag},dashed:{uniforms:pi([Bt.common,Bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Me.linedashed_vert,fragmentShader:Me.linedashed_frag},depth:{uniforms:pi([Bt.common,Bt.displacementmap]),vertexShader:Me.depth_vert,fragmentShader:Me.depth_frag},normal:{uniforms:pi([Bt.common,Bt.bumpmap,Bt.normalmap,Bt.displacementmap,{opacity:{value:1}}]),vertexShader:Me.meshnormal_vert,fragmentShader:Me.meshnormal_frag},sprite:{uniforms:pi([Bt.sprite,Bt.fog]),vertexShader:Me.sprite_vert,fragmentShader:Me.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Me.background_vert,fragmentShader:Me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:Me.backgroundCube_vert,fragmentShader:Me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Me.cube_vert,fragmentShader:Me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Me.equirect_vert,fragmentShader:Me.equirect_frag},distance:{uniforms:pi([Bt.common,Bt.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Me.distance_vert,fragmentShader:Me.distance_frag},shadow:{uniforms:pi([Bt.lights,Bt.fog,{color:{value:new te(0)},opacity:{value:1}}]),vertexShader:Me.shadow_vert,fragmentShader:Me.shadow_frag}};rr.physical={uniforms:pi([rr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new Kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ce},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new te(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new Kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new te(0)},specularColor:{value:new te(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new Kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:Me.meshphysical_vert,fragmentShader:Me.meshphysical_frag};var Ad={r:0,b:0,g:0},tR=new ge,Ey=new ce;Ey.set(-1,0,0,0,1,0,0,0,1);function eR(n,t,e,i,s,r){let o=new te(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let T=x.isScene===!0?x.background:null;if(T&&T.isTexture){let v=x.backgroundBlurriness>0;T=t.get(T,v)}return T}function p(x){let T=!1,v=f(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),T=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,T){let v=f(T);v&&v.isCubeTexture?(c===void 0&&(c=new Ye(new Bi(1,1,1),new di({name:"BackgroundCubeMaterial",uniforms:zo(rr.backgroundCube.uniforms),vertexShader:rr.backgroundCube.vertexShader,fragmentShader:rr.backgroundCube.fragmentShader,side:si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,S,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(tR.makeRotationFromEuler(T.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ey),c.material.toneMapped=Le.getTransfer(v.colorSpace)!==Ve,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ye(new yc(2,2),new di({name:"BackgroundMaterial",uniforms:zo(rr.background.uniforms),vertexShader:rr.background.vertexShader,fragmentShader:rr.background.fragmentShader,side:nr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Le.getTransfer(v.colorSpace)!==Ve,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,T){x.getRGB(Ad,Om(n)),e.buffers.color.setClear(Ad.r,Ad.g,Ad.b,T,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,T=1){o.set(x),a=T,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function nR(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(N,H,$,P,z){let D=!1,B=h(N,P,$,H);r!==B&&(r=B,c(r.object)),D=f(N,P,$,z),D&&p(N,P,$,z),z!==null&&t.update(z,n.ELEMENT_ARRAY_BUFFER),(D||o)&&(o=!1,v(N,H,$,P),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,H,$,P){let z=P.wireframe===!0,D=i[H.id];D===void 0&&(D={},i[H.id]=D);let B=N.isInstancedMesh===!0?N.id:0,Q=D[B];Q===void 0&&(Q={},D[B]=Q);let Y=Q[$.id];Y===void 0&&(Y={},Q[$.id]=Y);let j=Y[z];return j===void 0&&(j=d(l()),Y[z]=j),j}function d(N){let H=[],$=[],P=[];for(let z=0;z<e;z++)H[z]=0,$[z]=0,P[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:$,attributeDivisors:P,object:N,attributes:{},index:null}}function f(N,H,$,P){let z=r.attributes,D=H.attributes,B=0,Q=$.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let et=z[Y],dt=D[Y];if(dt===void 0&&(Y==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),Y==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;B++}return r.attributesNum!==B||r.index!==P}function p(N,H,$,P){let z={},D=H.attributes,B=0,Q=$.getAttributes();for(let Y in Q)if(Q[Y].location>=0){let et=D[Y];et===void 0&&(Y==="instanceMatrix"&&N.instanceMatrix&&(et=N.instanceMatrix),Y==="instanceColor"&&N.instanceColor&&(et=N.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),z[Y]=dt,B++}r.attributes=z,r.attributesNum=B,r.index=P}function _(){let N=r.newAttributes;for(let H=0,$=N.length;H<$;H++)N[H]=0}function m(N){g(N,0)}function g(N,H){let $=r.newAttributes,P=r.enabledAttributes,z=r.attributeDivisors;$[N]=1,P[N]===0&&(n.enableVertexAttribArray(N),P[N]=1),z[N]!==H&&(n.vertexAttribDivisor(N,H),z[N]=H)}function x(){let N=r.newAttributes,H=r.enabledAttributes;for(let $=0,P=H.length;$<P;$++)H[$]!==N[$]&&(n.disableVertexAttribArray($),H[$]=0)}function T(N,H,$,P,z,D,B){B===!0?n.vertexAttribIPointer(N,H,$,z,D):n.vertexAttribPointer(N,H,$,P,z,D)}function v(N,H,$,P){_();let z=P.attributes,D=$.getAttributes(),B=H.defaultAttributeValues;for(let Q in D){let Y=D[Q];if(Y.location>=0){let j=z[Q];if(j===void 0&&(Q==="instanceMatrix"&&N.instanceMatrix&&(j=N.instanceMatrix),Q==="instanceColor"&&N.instanceColor&&(j=N.instanceColor)),j!==void 0){let et=j.normalized,dt=j.itemSize,ft=t.get(j);if(ft===void 0)continue;let st=ft.buffer,yt=ft.type,xt=ft.bytesPerElement,Tt=yt===n.INT||yt===n.UNSIGNED_INT||j.gpuType===Gh;if(j.isInterleavedBufferAttribute){let At=j.data,jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,pe=j.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Yt=0;Yt<Y.locationSize;Yt++)g(Y.location+Yt,At.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Yt=0;Yt<Y.locationSize;Yt++)m(Y.location+Yt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let Yt=0;Yt<Y.locationSize;Yt++)T(Y.location+Yt,dt/Y.locationSize,yt,et,jt*xt,(pe+dt/Y.locationSize*Yt)*xt,Tt)}else{if(j.isInstancedBufferAttribute){for(let At=0;At<Y.locationSize;At++)g(Y.location+At,j.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let At=0;At<Y.locationSize;At++)m(Y.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<Y.locationSize;At++)T(Y.location+At,dt/Y.locationSize,yt,et,dt*xt,dt/Y.locationSize*At*xt,Tt)}}else if(B!==void 0){let et=B[Q];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(Y.location,et);break;case 3:n.vertexAttrib3fv(Y.location,et);break;case 4:n.vertexAttrib4fv(Y.location,et);break;default:n.vertexAttrib1fv(Y.location,et)}}}}x()}function A(){U();for(let N in i){let H=i[N];for(let $ in H){let P=H[$];for(let z in P){let D=P[z];for(let B in D)u(D[B].object),delete D[B];delete P[z]}}delete i[N]}}function S(N){if(i[N.id]===void 0)return;let H=i[N.id];for(let $ in H){let P=H[$];for(let z in P){let D=P[z];for(let B in D)u(D[B].object),delete D[B];delete P[z]}}delete i[N.id]}function y(N){for(let H in i){let $=i[H];for(let P in $){let z=$[P];if(z[N.id]===void 0)continue;let D=z[N.id];for(let B in D)u(D[B].object),delete D[B];delete z[N.id]}}}function w(N){for(let H in i){let $=i[H],P=N.isInstancedMesh===!0?N.id:0,z=$[P];if(z!==void 0){for(let D in z){let B=z[D];for(let Q in B)u(B[Q].object),delete B[Q];delete z[D]}delete $[P],Object.keys($).length===0&&delete i[H]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function iR(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function sR(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Is&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===Ps&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==es&&y!==hs&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ne("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ne("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:T,maxFragmentUniforms:v,maxSamples:A,samples:S}}function rR(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ni,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,_=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,T=x*4,v=g.clippingState||null;l.value=v,v=u(p,d,T,f);for(let A=0;A!==T;++A)v[A]=e[A];g.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let _=h!==null?h.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let T=0,v=f;T!==_;++T,v+=4)o.copy(h[T]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Nc=class extends Ki{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new fc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Bi(5,5,5),r=new di({name:"CubemapFromEquirect",uniforms:zo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:si,blending:Oo});r.uniforms.tEquirect.value=e;let o=new Ye(s,r),a=e.minFilter;return e.minFilter===Cr&&(e.minFilter=Ti),new Ga(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},iy=256,oR=3,aR=20,Ty=256,Ay=16,lR=3,cR=new G,uR=new te,Cd=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ga(1,10,null),this._boxMesh=new Ye(new Bi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=cR}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(uR));let m=new Ga(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=oy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ry(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(iy,Dm(t))}_fromTexture(t,e){t.mapping===Bo||t.mapping===qa?this._setSize(t.image.length===0?iy:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=sy(t,!1,!1),i=Math.log2(t)-oR;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=sy(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Bo||t.mapping===qa?(this._cubemapMaterial===null&&(this._cubemapMaterial=oy()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ry()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=hR(),this._integrationMaterial=dR());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Ay);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-lR)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Ty*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=fR());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function sy(n,t,e){return new Nc(n,{minFilter:Cr,generateMipmaps:t,type:Ps,colorSpace:ec,depthBuffer:e})}function Uc(n,t,e){return new di({name:n,uniforms:t,vertexShader:Me.cube_vert,fragmentShader:e,side:si,blending:Oo,depthTest:!1,depthWrite:!1})}function hR(){return Uc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ty}u

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
	`)}function dR(){return Uc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ay}},`

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
	`)}function fR(){return Uc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${aR}
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
	`)}function ry(){return Uc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function oy(){return Uc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function pR(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===kh||f===zh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new Nc(p.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===kh||f===zh,_=f===Bo||f===qa;if(p||_){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Cd(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new Cd(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===kh?d.mapping=Bo:f===zh&&(d.mapping=qa),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function mR(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Jl("WebGLRenderer: "+i+" extension not supported."),s}}}function gR(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(p){let _=p.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function h(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,T=m.count>=65535?uc:cc,v=new T(Math.ceil(x/3)*6,1),A=v.array;if(_!==null){let y=_.array;g=_.version;for(let w=0,U=0;w<x;w+=3){let L=y[w+0],N=y[w+1],H=y[w+2];A[U++]=L,A[U++]=N,A[U++]=N,A[U++]=H,A[U++]=H,A[U++]=L}}else{g=m.version;for(let y=0,w=0;y<x;y+=3){let U=y+0,L=y+1,N=y+2;A[w++]=U,A[w++]=L,A[w++]=L,A[w++]=N,A[w++]=N,A[w++]=U}}v.version=g;let S=r.get(p);S&&t.remove(S),r.set(p,v)}function d(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function xR(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let m=0;m<f;m++)_+=d[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function _R(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ae("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function yR(n,t,e){let i=new WeakMap,s=new vn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],T=0;f===!0&&(T=1),p===!0&&(T=2),_===!0&&(T=3);let v=a.attributes.position.count*T,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let S=new Float32Array(v*A*4*h),y=new oc(S,v,A,h);y.type=hs,y.needsUpdate=!0;let w=T*4;for(let L=0;L<h;L++){let N=m[L],H=g[L],$=x[L],P=v*A*4*L;for(let z=0;z<N.count;z++){let D=z*w;f===!0&&(s.fromBufferAttribute(N,z),S[P+D+0]=s.x,S[P+D+1]=s.y,S[P+D+2]=s.z,S[P+D+3]=0),p===!0&&(s.fromBufferAttribute(H,z),S[P+D+4]=s.x,S[P+D+5]=s.y,S[P+D+6]=s.z,S[P+D+7]=0),_===!0&&(s.fromBufferAttribute($,z),S[P+D+8]=s.x,S[P+D+9]=s.y,S[P+D+10]=s.z,S[P+D+11]=$.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Kt(v,A)},i.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function vR(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var bR={[um]:"LINEAR_TONE_MAPPING",[hm]:"REINHARD_TONE_MAPPING",[dm]:"CINEON_TONE_MAPPING",[fm]:"ACES_FILMIC_TONE_MAPPING",[mm]:"AGX_TONE_MAPPING",[gm]:"NEUTRAL_TONE_MAPPING",[pm]:"CUSTOM_TONE_MAPPING"};function MR(n,t,e,i,s,r){let o=new Ki(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Te;u.setAttribute("position",new Ee([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ee([0,2,0,0,2,0],2));let h=new wh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ye(u,h),f=new Fh(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,T=[],v=!1;this.setSize=function(A,S){o.setSize(A,S),a!==null&&a.setSize(A,S),l!==null&&l.setSize(A,S);for(let y=0;y<T.length;y++){let w=T[y];w.setSize&&w.setSize(A,S)}},this.setEffects=function(A){T=A,v=T.length>0&&T[0].isRenderPass===!0;let S=o.width,y=o.height;T.length>0&&a===null&&(a=new Ki(S,y,{type:Ps,depthBuffer:!1,stencilBuffer:!1}),l=new Ki(S,y,{type:Ps,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&T.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Rr(S,y),r===!0&&(c.format=Pr,c.type=ko)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<T.length;U++){let L=T[U];L.setSize&&L.setSize(S,y),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(A,S){if(m||A.toneMapping===ir&&T.length===0)return!1;if(x=S,S!==null){let y=S.width,w=S.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return v===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=ir,!0},this.hasRenderPass=function(){return v},this.end=function(A,S){A.toneMapping=g,m=!0;let y=o,w=a;for(let U=0;U<T.length;U++){let L=T[U];L.enabled!==!1&&(L.render(A,w,y,S),L.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(p!==A.outputColorSpace||_!==A.toneMapping){p=A.outputColorSpace,_=A.toneMapping,h.defines={},Le.getTransfer(p)===Ve&&(h.defines.SRGB_TRANSFER="");let U=bR[_];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Ry=new Ui,Cy=new Rr(1,1),Py=new pc(1),Iy=new oc,Ly=new yh,Dy=new fc,ay=[],ly=[],cy=new Float32Array(16),uy=new Float32Array(9),hy=new Float32Array(4);function Za(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=ay[s];if(r===void 0&&(r=new Float32Array(s),ay[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Hn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Gn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Id(n,t){let e=ly[t];e===void 0&&(e=new Int32Array(t),ly[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function SR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function wR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Hn(e,t))return;n.uniform2fv(this.addr,t),Gn(e,t)}}function ER(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Hn(e,t))return;n.uniform3fv(this.addr,t),Gn(e,t)}}function TR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Hn(e,t))return;n.uniform4fv(this.addr,t),Gn(e,t)}}function AR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Hn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Gn(e,t)}else{if(Hn(e,i))return;hy.set(i),n.uniformMatrix2fv(this.addr,!1,hy),Gn(e,i)}}function RR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Hn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Gn(e,t)}else{if(Hn(e,i))return;uy.set(i),n.uniformMatrix3fv(this.addr,!1,uy),Gn(e,i)}}function CR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Hn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Gn(e,t)}else{if(Hn(e,i))return;cy.set(i),n.uniformMatrix4fv(this.addr,!1,cy),Gn(e,i)}}function PR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function IR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Hn(e,t))return;n.uniform2iv(this.addr,t),Gn(e,t)}}function LR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Hn(e,t))return;n.uniform3iv(this.addr,t),Gn(e,t)}}function DR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Hn(e,t))return;n.uniform4iv(this.addr,t),Gn(e,t)}}function NR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function UR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Hn(e,t))return;n.uniform2uiv(this.addr,t),Gn(e,t)}}function OR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Hn(e,t))return;n.uniform3uiv(this.addr,t),Gn(e,t)}}function FR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Hn(e,t))return;n.uniform4uiv(this.addr,t),Gn(e,t)}}function Ld(n){return n.version===0&&(n.compareFunction=Cm,n.needsUpdate=!0),n}function BR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ld(Cy):r=Ry,e.setTexture2D(t||r,s)}function kR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Ly,s)}function zR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ld(Py):r=Dy,e.setTextureCube(t||r,s)}function HR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Iy,s)}function GR(n){switch(n){case 5126:return SR;case 35664:return wR;case 35665:return ER;case 35666:return TR;case 35674:return AR;case 35675:return RR;case 35676:return CR;case 5124:case 35670:return PR;case 35667:case 35671:return IR;case 35668:case 35672:return LR;case 35669:case 35673:return DR;case 5125:return NR;case 36294:return UR;case 36295:return OR;case 36296:return FR;case 35678:case 36198:case 36298:case 36306:case 35682:return BR;case 35679:case 36299:case 36307:return kR;case 35680:case 36300:case 36308:case 36293:return zR;case 36289:case 36303:case 36311:case 36292:return HR}}function VR(n,t){n.uniform1fv(this.addr,t)}function WR(n,t){let e=Za(t,this.size,2);n.uniform2fv(this.addr,e)}function $R(n,t){let e=Za(t,this.size,3);n.uniform3fv(this.addr,e)}function qR(n,t){let e=Za(t,this.size,4);n.uniform4fv(this.addr,e)}function XR(n,t){let e=Za(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function YR(n,t){let e=Za(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function ZR(n,t){let e=Za(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function jR(n,t){n.uniform1iv(this.addr,t)}function JR(n,t){n.uniform2iv(this.addr,t)}function KR(n,t){n.uniform3iv(this.addr,t)}function QR(n,t){n.uniform4iv(this.addr,t)}function tC(n,t){n.uniform1uiv(this.addr,t)}function eC(n,t){n.uniform2uiv(this.addr,t)}function nC(n,t){n.uniform3uiv(this.addr,t)}function iC(n,t){n.uniform4uiv(this.addr,t)}function sC(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ld(Cy):o=Ry;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function rC(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ly,r[o])}function oC(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ld(Py):o=Dy;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function aC(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);Hn(i,r)||(n.uniform1iv(this.addr,r),Gn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Iy,r[o])}function lC(n){switch(n){case 5126:return VR;case 35664:return WR;case 35665:return $R;case 35666:return qR;case 35674:return XR;case 35675:return YR;case 35676:return ZR;case 5124:case 35670:return jR;case 35667:case 35671:return JR;case 35668:case 35672:return KR;case 35669:case 35673:return QR;case 5125:return tC;case 36294:return eC;case 36295:return nC;case 36296:return iC;case 35678:case 36198:case 36298:case 36306:case 35682:return sC;case 35679:case 36299:case 36307:return rC;case 35680:case 36300:case 36308:case 36293:return oC;case 36289:case 36303:case 36311:case 36292:return aC}}var Gm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=GR(e.type)}},Vm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=lC(e.type)}},Wm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},zm=/(\w+)(\])?(\[|\.)?/g;function dy(n,t){n.seq.push(t),n.map[t.id]=t}function cC(n,t,e){let i=n.name,s=i.length;for(zm.lastIndex=0;;){let r=zm.exec(i),o=zm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){dy(e,c===void 0?new Gm(a,n,t):new Vm(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Wm(a),dy(e,h)),e=h}}}var Ya=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);cC(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function fy(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var uC=37297,hC=0;function dC(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var py=new ce;function fC(n){Le._getMatrix(py,Le.workingColorSpace,n);let t=`mat3( ${py.elements.map(e=>e.toFixed(4))} )`;switch(Le.getTransfer(n)){case nc:return[t,"LinearTransferOETF"];case Ve:return[t,"sRGBTransferOETF"];default:return ne("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function my(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+dC(n.getShaderSource(t),a)}else return r}function pC(n,t){let e=fC(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mC={[um]:"Linear",[hm]:"Reinhard",[dm]:"Cineon",[fm]:"ACESFilmic",[mm]:"AgX",[gm]:"Neutral",[pm]:"Custom"};function gC(n,t){let e=mC[t];return e===void 0?(ne("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Rd=new G;function xC(){Le.getLuminanceCoefficients(Rd);let n=Rd.x.toFixed(4),t=Rd.y.toFixed(4),e=Rd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function _C(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Dc).join(`
`)}function yC(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function vC(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Dc(n){return n!==""}function gy(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function xy(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var bC=/^[ \t]*#include +<([\w\d./]+)>/gm;function $m(n){return n.replace(bC,MC)}function MC(n,t){let e=Me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return $m(e)}var SC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _y(n){return n.replace(SC,wC)}function wC(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function yy(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var EC={[wc]:"SHADOWMAP_TYPE_PCF",[Wa]:"SHADOWMAP_TYPE_VSM"};function TC(n){return EC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var AC={[qa]:"ENVMAP_MODE_REFRACTION"};function RC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":AC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var CC={[cm]:"ENVMAP_BLENDING_MULTIPLY",[B_]:"ENVMAP_BLENDING_MIX",[k_]:"ENVMAP_BLENDING_ADD"};function PC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":CC[n.combine]||"ENVMAP_BLENDING_NONE"}function IC(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=TC(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=RC(e),h=PC(e),d=_C(e),f=yC(r),p=s.createProgram(),_,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dc).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dc).join(`
`),m.length>0&&(m+=`
`)):(_=[yy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Dc).join(`
`),m=[yy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ir?"#define TONE_MAPPING":"",e.toneMapping!==ir?Me.tonemapping_pars_fragment:"",e.toneMapping!==ir?gC("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Me.colorspace_pars_fragment,pC("linearToOutputTexel",e.outputColorSpace),xC(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Dc).join(`
`)),o=$m(o),o=gy(o,e),o=xy(o,e),a=$m(a),a=gy(a,e),a=xy(a,e),o=_y(o),a=_y(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===Im?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Im?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,T=g+m+a,v=fy(s,s.VERTEX_SHADER,x),A=fy(s,s.FRAGMENT_SHADER,T);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function S(L){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(v)||"",$=s.getShaderInfoLog(A)||"",P=N.trim(),z=H.trim(),D=$.trim(),B=!0,Q=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(B=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,A);else{let Y=my(s,v,"vertex"),j=my(s,A,"fragment");ae("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+P+`
`+Y+`
`+j)}else P!==""?ne("WebGLProgram: Program Info Log:",P):(z===""||D==="")&&(Q=!1);Q&&(L.diagnostics={runnable:B,programLog:P,vertexShader:{log:z,prefix:_},fragmentShader:{log:D,prefix:m}})}s.deleteShader(v),s.deleteShader(A),y=new Ya(s,p),w=vC(s,p)}let y;this.getUniforms=function(){return y===void 0&&S(this),y};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,uC)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=hC++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var LC=0,qm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Xm(t),e.set(t,i)),i}},Xm=class{constructor(t){this.id=LC++,this.code=t,this.usedTimes=0}};function DC(n){return n===ro||n===Pc||n===Ic}function NC(n,t,e,i,s,r){let o=new Oa,a=new qm,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,w,U,L,N,H){let $=L.fog,P=N.geometry,z=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,D=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,B=t.get(y.envMap||z,D),Q=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&ne("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let j=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,et=j!==void 0?j.length:0,dt=0;P.morphAttributes.position!==void 0&&(dt=1),P.morphAttributes.normal!==void 0&&(dt=2),P.morphAttributes.color!==void 0&&(dt=3);let ft,st,yt,xt;if(Q){let Dt=rr[Q];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=y.vertexShader,st=y.fragmentShader;let Dt=a.getVertexShaderStage(y),_e=a.getFragmentShaderStage(y);a.update(y,Dt,_e),yt=Dt.id,xt=_e.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),jt=N.isInstancedMesh===!0,pe=N.isBatchedMesh===!0,Yt=!!y.map,Se=!!y.matcap,ye=!!B,de=ye&&B.isPMREMTexture===!0,gn=!!y.aoMap,sn=!!y.lightMap,Pn=!!y.bumpMap&&y.wireframe===!1,je=!!y.normalMap,Xn=!!y.displacementMap,Ne=!!y.emissiveMap,Bn=!!y.metalnessMap,Mn=!!y.roughnessMap,In=y.anisotropy>0,W=y.clearcoat>0,Nt=y.diffuseRoughness>0,ie=y.dispersion>0,me=y.retroreflectivity>0,Ct=y.iridescence>0,Ke=y.sheen>0,Xt=y.transmission>0,ee=In&&!!y.anisotropyMap,O=W&&!!y.clearcoatMap,R=W&&!!y.clearcoatNormalMap,Z=W&&!!y.clearcoatRoughnessMap,mt=Nt&&!!y.diffuseRoughnessMap,ct=Ct&&!!y.iridescenceMap,St=Ct&&!!y.iridescenceThicknessMap,wt=Ke&&!!y.sheenColorMap,rt=Ke&&!!y.sheenRoughnessMap,at=!!y.specularMap,vt=!!y.specularColorMap,V=!!y.specularIntensityMap,lt=Xt&&!!y.transmissionMap,ot=Xt&&!!y.thicknessMap,Pt=!!y.gradientMap,Mt=!!y.alphaMap,Rt=y.alphaTest>0,Zt=!!y.alphaHash,re=!!y.extensions,pt=ir;y.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let Wt=de?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,oe={shaderID:Q,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:st,defines:y.defines,customVertexShaderID:yt,customFragmentShaderID:xt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:pe,batchingColor:pe&&N._colorsTexture!==null,instancing:jt,instancingColor:jt&&N.instanceColor!==null,instancingMorph:jt&&N.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:Le.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Yt,matcap:Se,envMap:ye,envMapMode:ye&&B.mapping,envMapPMREM:de,envMapMaxLod:de?Wt.length-1:null,envMapSize:de?Wt[0].width:null,aoMap:gn,lightMap:sn,bumpMap:Pn,normalMap:je,displacementMap:Xn,emissiveMap:Ne,normalMapObjectSpace:je&&y.normalMapType===G_,normalMapTangentSpace:je&&y.normalMapType===wm,packedNormalMap:je&&y.normalMapType===wm&&DC(y.normalMap.format),metalnessMap:Bn,roughnessMap:Mn,anisotropy:In,anisotropyMap:ee,clearcoat:W,clearcoatMap:O,clearcoatNormalMap:R,clearcoatRoughnessMap:Z,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:ie,retroreflection:me,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:St,sheen:Ke,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:V,transmission:Xt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:y.transparent===!1&&y.blending===$a&&y.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:Zt,combine:y.combine,mapUv:Yt&&f(y.map.channel),aoMapUv:gn&&f(y.aoMap.channel),lightMapUv:sn&&f(y.lightMap.channel),bumpMapUv:Pn&&f(y.bumpMap.channel),normalMapUv:je&&f(y.normalMap.channel),displacementMapUv:Xn&&f(y.displacementMap.channel),emissiveMapUv:Ne&&f(y.emissiveMap.channel),metalnessMapUv:Bn&&f(y.metalnessMap.channel),roughnessMapUv:Mn&&f(y.roughnessMap.channel),anisotropyMapUv:ee&&f(y.anisotropyMap.channel),clearcoatMapUv:O&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(y.sheenRoughnessMap.channel),specularMapUv:at&&f(y.specularMap.channel),specularColorMapUv:vt&&f(y.specularColorMap.channel),specularIntensityMapUv:V&&f(y.specularIntensityMap.channel),transmissionMapUv:lt&&f(y.transmissionMap.channel),thicknessMapUv:ot&&f(y.thicknessMap.channel),alphaMapUv:Mt&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(je||In),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(Yt||Mt),fog:!!$,useFog:y.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&je===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:H.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:Yt&&y.map.isVideoTexture===!0&&Le.getTransfer(y.map.colorSpace)===Ve,decodeVideoTextureEmissive:Ne&&y.emissiveMap.isVideoTexture===!0&&Le.getTransfer(y.emissiveMap.colorSpace)===Ve,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===fi,flipSided:y.side===si,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:re&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(re&&y.extensions.multiDraw===!0||pe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return oe.vertexUv1s=l.has(1),oe.vertexUv2s=l.has(2),oe.vertexUv3s=l.has(3),l.clear(),oe}function _(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)w.push(U),w.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(w,y),g(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function m(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let w=d[y.type],U;if(w){let L=rr[w];U=ty.clone(L.uniforms)}else U=y.uniforms;return U}function T(y,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new IC(n,w,y,s),c.push(U),u.set(w,U)),U}function v(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function S(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:T,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:S}}function UC(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function OC(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function vy(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function by(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,m,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:m,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=m,x.group=g),t++,x}function l(d,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let T=a(d,f,p,_,m,g);p.transmission>0?i.push(T):p.transparent===!0?s.push(T):e.push(T)}function c(d,f,p,_,m,g){let x=a(d,f,p,_,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||OC),i.length>1&&i.sort(f||vy),s.length>1&&s.sort(f||vy)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function FC(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new by,n.set(i,[o])):s>=r.length?(o=new by,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function BC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new te};break;case"SpotLight":e={position:new G,direction:new G,color:new te,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new te,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new te,groundColor:new te};break;case"RectAreaLight":e={color:new te,position:new G,halfWidth:new G,halfHeight:new G};break}return n[t.id]=e,e}}}function kC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var zC=0;function HC(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function GC(n){let t=new BC,e=kC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new ge,o=new ge;function a(c){let u=0,h=0,d=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,T=0,v=0,A=0,S=0,y=0,w=0,U=0,L=0;c.sort(HC);for(let H=0,$=c.length;H<$;H++){let P=c[H],z=P.color,D=P.intensity,B=P.distance,Q=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===ro?Q=P.shadow.map.texture:Q=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=z.r*D,h+=z.g*D,d+=z.b*D;else if(P.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(P.sh.coefficients[Y],D);L++}else if(P.isSunLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,et=e.get(P);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=Q;let dt=j.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[_+ft]=j.getMatrix(ft),i.sunShadowCascade[_+ft]=j._cascadeData[ft];_+=dt,p++}i.sun[f]=Y,f++}else if(P.isDirectionalLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,et=e.get(P);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=Q,i.directionalShadowMatrix[m]=P.shadow.matrix,A++}i.directional[m]=Y,m++}else if(P.isSpotLight){let Y=t.get(P);Y.position.setFromMatrixPosition(P.matrixWorld),Y.color.copy(z).multiplyScalar(D),Y.distance=B,Y.coneCos=Math.cos(P.angle),Y.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),Y.decay=P.decay,i.spot[x]=Y;let j=P.shadow;if(P.map&&(i.spotLightMap[w]=P.map,w++,j.updateMatrices(P),P.castShadow&&U++),i.spotLightMatrix[x]=j.matrix,P.castShadow){let et=e.get(P);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=Q,y++}x++}else if(P.isRectAreaLight){let Y=t.get(P);Y.color.copy(z).multiplyScalar(D),Y.halfWidth.set(P.width*.5,0,0),Y.halfHeight.set(0,P.height*.5,0),i.rectArea[T]=Y,T++}else if(P.isPointLight){let Y=t.get(P);if(Y.color.copy(P.color).multiplyScalar(P.intensity),Y.distance=P.distance,Y.decay=P.decay,P.castShadow){let j=P.shadow,et=e.get(P);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=Q,i.pointShadowMatrix[g]=P.shadow.matrix,S++}i.point[g]=Y,g++}else if(P.isHemisphereLight){let Y=t.get(P);Y.skyColor.copy(P.color).multiplyScalar(D),Y.groundColor.copy(P.groundColor).multiplyScalar(D),i.hemi[v]=Y,v++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Bt.LTC_FLOAT_1,i.rectAreaLTC2=Bt.LTC_FLOAT_2):(i.rectAreaLTC1=Bt.LTC_HALF_1,i.rectAreaLTC2=Bt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let N=i.hash;(N.sunLength!==f||N.directionalLength!==m||N.pointLength!==g||N.spotLength!==x||N.rectAreaLength!==T||N.hemiLength!==v||N.numSunShadows!==p||N.numDirectionalShadows!==A||N.numPointShadows!==S||N.numSpotShadows!==y||N.numSpotMaps!==w||N.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=T,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,N.sunLength=f,N.directionalLength=m,N.pointLength=g,N.spotLength=x,N.rectAreaLength=T,N.hemiLength=v,N.numSunShadows=p,N.numDirectionalShadows=A,N.numPointShadows=S,N.numSpotShadows=y,N.numSpotMaps=w,N.numLightProbes=L,i.version=zC++)}function l(c,u){let h=0,d=0,f=0,p=0,_=0,m=0,g=u.matrixWorldInverse;for(let x=0,T=c.length;x<T;x++){let v=c[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(v.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let A=i.rectArea[_];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function My(n){let t=new GC(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function VC(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new My(n),t.set(s,[a])):r>=o.length?(a=new My(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var WC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$C=`uniform sampler2D shadow_pass;
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
}`,qC=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],XC=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Sy=new ge,Lc=new G,Hm=new G;function YC(n,t,e){let i=new Lo,s=new Kt,r=new Kt,o=new vn,a=new Eh,l=new Th,c={},u=e.maxTextureSize,h={[nr]:si,[si]:nr,[fi]:fi},d=new di({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Kt},radius:{value:4}},vertexShader:WC,fragmentShader:$C}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Te;p.setAttribute("position",new ke(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ye(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=wc;let g=this.type;this.render=function(S,y,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===y_&&(ne("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=wc);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),H=n.state;H.setBlending(Oo),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let $=g!==this.type;$&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(z=>z.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,z=S.length;P<z;P++){let D=S[P],B=D.shadow;if(B===void 0){ne("WebGLShadowMap:",D,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let Q=B.getFrameExtents();s.multiply(Q),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Q.x),s.x=r.x*Q.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Q.y),s.y=r.y*Q.y,B.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Y,B.map===null||$===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===Wa){if(D.isPointLight){ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new Ki(s.x,s.y,{format:ro,type:Ps,minFilter:Ti,magFilter:Ti,generateMipmaps:!1}),B.map.texture.name=D.name+".shadowMap",B.map.depthTexture=new Rr(s.x,s.y,hs),B.map.depthTexture.name=D.name+".shadowMapDepth",B.map.depthTexture.format=wr,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Qn,B.map.depthTexture.magFilter=Qn}else D.isPointLight?(B.map=new Nc(s.x),B.map.depthTexture=new pc(s.x,Cs)):(B.map=new Ki(s.x,s.y),B.map.depthTexture=new Rr(s.x,s.y,Cs)),B.map.depthTexture.name=D.name+".shadowMap",B.map.depthTexture.format=wr,this.type===wc?(B.map.depthTexture.compareFunction=Y?Rm:Am,B.map.depthTexture.minFilter=Ti,B.map.depthTexture.magFilter=Ti):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Qn,B.map.depthTexture.magFilter=Qn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let j=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();D.isPointLight!==!0&&B.updateMatrices(D,w);let et=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:w.layers;for(let dt=0;dt<j;dt++){let ft=B.getCamera(dt);if(D.isPointLight){let st=B.camera,yt=B.matrix,xt=D.distance||st.far;xt!==st.far&&(st.far=xt,st.updateProjectionMatrix()),Lc.setFromMatrixPosition(D.matrixWorld),st.position.copy(Lc),Hm.copy(st.position),Hm.add(qC[dt]),st.up.copy(XC[dt]),st.lookAt(Hm),st.updateMatrixWorld(),yt.makeTranslation(-Lc.x,-Lc.y,-Lc.z),Sy.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),B._frustum.setFromProjectionMatrix(Sy,st.coordinateSystem,st.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)n.setRenderTarget(B.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(B.map),n.clear());let st=B.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),H.viewport(o)}i=B.getFrustum(dt),v(y,w,ft,D,et,this.type)}B.isPointLightShadow!==!0&&this.type===Wa&&x(B,w),B.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(U,L,N)};function x(S,y){let w=t.update(_);d.defines.VSM_SAMPLES!==S.blurSamples&&(d.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new Ki(s.x,s.y,{format:ro,type:Ps}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),d.uniforms.shadow_pass.value=S.map.depthTexture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(y,null,w,d,_,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(y,null,w,f,_,null)}function T(S,y,w,U){let L=null,N=w.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(N!==void 0)L=N;else if(L=w.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let H=L.uuid,$=y.uuid,P=c[H];P===void 0&&(P={},c[H]=P);let z=P[$];z===void 0&&(z=L.clone(),P[$]=z,y.addEventListener("dispose",A)),L=z}if(L.visible=y.visible,L.wireframe=y.wireframe,U===Wa?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let H=n.properties.get(L);H.light=w}return L}function v(S,y,w,U,L,N){if(S.visible===!1)return;if(S.layers.test(L)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&N===Wa)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,S.matrixWorld);let P=t.update(S),z=S.material;if(Array.isArray(z)){let D=P.groups;for(let B=0,Q=D.length;B<Q;B++){let Y=D[B],j=z[Y.materialIndex];if(j&&j.visible){let et=T(S,j,U,N);S.onBeforeShadow(n,S,y,w,P,et,Y),n.renderBufferDirect(w,null,P,et,S,Y),S.onAfterShadow(n,S,y,w,P,et,Y)}}}else if(z.visible){let D=T(S,z,U,N);S.onBeforeShadow(n,S,y,w,P,D,null),n.renderBufferDirect(w,null,P,D,S,null),S.onAfterShadow(n,S,y,w,P,D,null)}}let $=S.children;for(let P=0,z=$.length;P<z;P++)v($[P],y,w,U,L,N)}function A(S){S.target.removeEventListener("dispose",A);for(let w in c){let U=c[w],L=S.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function ZC(n,t){function e(){let V=!1,lt=new vn,ot=null,Pt=new vn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!V&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){V=Mt},setClear:function(Mt,Rt,Zt,re,pt){pt===!0&&(Mt*=re,Rt*=re,Zt*=re),lt.set(Mt,Rt,Zt,re),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,Zt,re),Pt.copy(lt))},reset:function(){V=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let V=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let Zt=t.get("EXT_clip_control");Rt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let re=Mt;Mt=null,this.setClear(re)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!V&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=K_[Rt]),Pt!==Rt){switch(Rt){case ah:n.depthFunc(n.NEVER);break;case lh:n.depthFunc(n.ALWAYS);break;case ch:n.depthFunc(n.LESS);break;case La:n.depthFunc(n.LEQUAL);break;case uh:n.depthFunc(n.EQUAL);break;case hh:n.depthFunc(n.GEQUAL);break;case dh:n.depthFunc(n.GREATER);break;case fh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){V=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){V=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,re=null,pt=null;return{setTest:function(Wt){V||(Wt?At(n.STENCIL_TEST):jt(n.STENCIL_TEST))},setMask:function(Wt){lt!==Wt&&!V&&(n.stencilMask(Wt),lt=Wt)},setFunc:function(Wt,oe,Dt){(ot!==Wt||Pt!==oe||Mt!==Dt)&&(n.stencilFunc(Wt,oe,Dt),ot=Wt,Pt=oe,Mt=Dt)},setOp:function(Wt,oe,Dt){(Rt!==Wt||Zt!==oe||re!==Dt)&&(n.stencilOp(Wt,oe,Dt),Rt=Wt,Zt=oe,re=Dt)},setLocked:function(Wt){V=Wt},setClear:function(Wt){pt!==Wt&&(n.clearStencil(Wt),pt=Wt)},reset:function(){V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,re=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,T=null,v=null,A=null,S=null,y=null,w=new te(0,0,0),U=0,L=!1,N=null,H=null,$=null,P=null,z=null,D=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,Q=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(Y)[1]),B=Q>=1):Y.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),B=Q>=2);let j=null,et={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new vn().fromArray(dt),yt=new vn().fromArray(ft);function xt(V,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(V,Rt),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<ot;Zt++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(La),Pn(!1),je(im),At(n.CULL_FACE),gn(Oo);function At(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function jt(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function pe(V,lt){return d[V]!==lt?(n.bindFramebuffer(V,lt),d[V]=lt,V===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),V===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function Yt(V,lt){let ot=p,Pt=!1;if(V){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=V.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,Zt=Mt.length;Rt<Zt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function Se(V){return _!==V?(n.useProgram(V),_=V,!0):!1}let ye={[Fo]:n.FUNC_ADD,[b_]:n.FUNC_SUBTRACT,[M_]:n.FUNC_REVERSE_SUBTRACT};ye[S_]=n.MIN,ye[w_]=n.MAX;let de={[E_]:n.ZERO,[T_]:n.ONE,[A_]:n.SRC_COLOR,[am]:n.SRC_ALPHA,[D_]:n.SRC_ALPHA_SATURATE,[I_]:n.DST_COLOR,[C_]:n.DST_ALPHA,[R_]:n.ONE_MINUS_SRC_COLOR,[lm]:n.ONE_MINUS_SRC_ALPHA,[L_]:n.ONE_MINUS_DST_COLOR,[P_]:n.ONE_MINUS_DST_ALPHA,[N_]:n.CONSTANT_COLOR,[U_]:n.ONE_MINUS_CONSTANT_COLOR,[O_]:n.CONSTANT_ALPHA,[F_]:n.ONE_MINUS_CONSTANT_ALPHA};function gn(V,lt,ot,Pt,Mt,Rt,Zt,re,pt,Wt){if(V===Oo){m===!0&&(jt(n.BLEND),m=!1);return}if(m===!1&&(At(n.BLEND),m=!0),V!==v_){if(V!==g||Wt!==L){if((x!==Fo||A!==Fo)&&(n.blendEquation(n.FUNC_ADD),x=Fo,A=Fo),Wt)switch(V){case $a:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case sm:n.blendFunc(n.ONE,n.ONE);break;case rm:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case om:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ae("WebGLState: Invalid blending: ",V);break}else switch(V){case $a:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case sm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case rm:ae("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case om:ae("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ae("WebGLState: Invalid blending: ",V);break}T=null,v=null,S=null,y=null,w.set(0,0,0),U=0,g=V,L=Wt}return}Mt=Mt||lt,Rt=Rt||ot,Zt=Zt||Pt,(lt!==x||Mt!==A)&&(n.blendEquationSeparate(ye[lt],ye[Mt]),x=lt,A=Mt),(ot!==T||Pt!==v||Rt!==S||Zt!==y)&&(n.blendFuncSeparate(de[ot],de[Pt],de[Rt],de[Zt]),T=ot,v=Pt,S=Rt,y=Zt),(re.equals(w)===!1||pt!==U)&&(n.blendColor(re.r,re.g,re.b,pt),w.copy(re),U=pt),g=V,L=!1}function sn(V,lt){V.side===fi?jt(n.CULL_FACE):At(n.CULL_FACE);let ot=V.side===si;lt&&(ot=!ot),Pn(ot),V.blending===$a&&V.transparent===!1?gn(Oo):gn(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Pt=V.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Ne(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Pn(V){N!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),N=V)}function je(V){V!==x_?(At(n.CULL_FACE),V!==H&&(V===im?n.cullFace(n.BACK):V===__?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):jt(n.CULL_FACE),H=V}function Xn(V){V!==$&&(B&&n.lineWidth(V),$=V)}function Ne(V,lt,ot){V?(At(n.POLYGON_OFFSET_FILL),(P!==lt||z!==ot)&&(P=lt,z=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):jt(n.POLYGON_OFFSET_FILL)}function Bn(V){V?At(n.SCISSOR_TEST):jt(n.SCISSOR_TEST)}function Mn(V){V===void 0&&(V=n.TEXTURE0+D-1),j!==V&&(n.activeTexture(V),j=V)}function In(V,lt,ot){ot===void 0&&(j===null?ot=n.TEXTURE0+D-1:ot=j);let Pt=et[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},et[ot]=Pt),(Pt.type!==V||Pt.texture!==lt)&&(j!==ot&&(n.activeTexture(ot),j=ot),n.bindTexture(V,lt||Tt[V]),Pt.type=V,Pt.texture=lt)}function W(){let V=et[j];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(V){ae("WebGLState:",V)}}function ie(){try{n.compressedTexImage3D(...arguments)}catch(V){ae("WebGLState:",V)}}function me(){try{n.texSubImage2D(...arguments)}catch(V){ae("WebGLState:",V)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(V){ae("WebGLState:",V)}}function Ke(){try{n.compressedTexSubImage2D(...arguments)}catch(V){ae("WebGLState:",V)}}function Xt(){try{n.compressedTexSubImage3D(...arguments)}catch(V){ae("WebGLState:",V)}}function ee(){try{n.texStorage2D(...arguments)}catch(V){ae("WebGLState:",V)}}function O(){try{n.texStorage3D(...arguments)}catch(V){ae("WebGLState:",V)}}function R(){try{n.texImage2D(...arguments)}catch(V){ae("WebGLState:",V)}}function Z(){try{n.texImage3D(...arguments)}catch(V){ae("WebGLState:",V)}}function mt(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function ct(V,lt){h[V]!==lt&&(n.pixelStorei(V,lt),h[V]=lt)}function St(V){st.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),st.copy(V))}function wt(V){yt.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),yt.copy(V))}function rt(V,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Pt=ot.get(V);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,V.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(V,Pt))}function at(V,lt,ot){let Mt=c.get(lt).get(V);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,et={},d={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,T=null,v=null,A=null,S=null,y=null,w=new te(0,0,0),U=0,L=!1,N=null,H=null,$=null,P=null,z=null,st.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:jt,bindFramebuffer:pe,drawBuffers:Yt,useProgram:Se,setBlending:gn,setMaterial:sn,setFlipSided:Pn,setCullFace:je,setLineWidth:Xn,setPolygonOffset:Ne,setScissorTest:Bn,activeTexture:Mn,bindTexture:In,unbindTexture:W,compressedTexImage2D:Nt,compressedTexImage3D:ie,texImage2D:R,texImage3D:Z,pixelStorei:ct,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:ee,texStorage3D:O,texSubImage2D:me,texSubImage3D:Ct,compressedTexSubImage2D:Ke,compressedTexSubImage3D:Xt,scissor:St,viewport:wt,reset:vt}}function jC(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Kt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(O=>p.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(O,R){return m?new OffscreenCanvas(O,R):sc("canvas")}function x(O,R,Z){let mt=1,ct=ee(O);if((ct.width>Z||ct.height>Z)&&(mt=Z/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let St=Math.floor(mt*ct.width),wt=Math.floor(mt*ct.height);d===void 0&&(d=g(St,wt));let rt=R?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(O,0,0,St,wt),ne("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+St+"x"+wt+")."),rt}else return"data"in O&&ne("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),O;return O}function T(O){return O.generateMipmaps}function v(O){n.generateMipmap(O)}function A(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(O,R,Z,mt,ct,St=!1){if(O!==null){if(n[O]!==void 0)return n[O];ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let wt;mt&&(wt=t.get("EXT_texture_norm16"),wt||ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(Z===n.FLOAT&&(rt=n.R32F),Z===n.HALF_FLOAT&&(rt=n.R16F),Z===n.UNSIGNED_BYTE&&(rt=n.R8),Z===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),Z===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.R8UI),Z===n.UNSIGNED_SHORT&&(rt=n.R16UI),Z===n.UNSIGNED_INT&&(rt=n.R32UI),Z===n.BYTE&&(rt=n.R8I),Z===n.SHORT&&(rt=n.R16I),Z===n.INT&&(rt=n.R32I)),R===n.RG&&(Z===n.FLOAT&&(rt=n.RG32F),Z===n.HALF_FLOAT&&(rt=n.RG16F),Z===n.UNSIGNED_BYTE&&(rt=n.RG8),Z===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),Z===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.RG8UI),Z===n.UNSIGNED_SHORT&&(rt=n.RG16UI),Z===n.UNSIGNED_INT&&(rt=n.RG32UI),Z===n.BYTE&&(rt=n.RG8I),Z===n.SHORT&&(rt=n.RG16I),Z===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),Z===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),Z===n.UNSIGNED_INT&&(rt=n.RGB32UI),Z===n.BYTE&&(rt=n.RGB8I),Z===n.SHORT&&(rt=n.RGB16I),Z===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(Z===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),Z===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),Z===n.UNSIGNED_INT&&(rt=n.RGBA32UI),Z===n.BYTE&&(rt=n.RGBA8I),Z===n.SHORT&&(rt=n.RGBA16I),Z===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(Z===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),Z===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),Z===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),Z===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=St?nc:Le.getTransfer(ct);Z===n.FLOAT&&(rt=n.RGBA32F),Z===n.HALF_FLOAT&&(rt=n.RGBA16F),Z===n.UNSIGNED_BYTE&&(rt=at===Ve?n.SRGB8_ALPHA8:n.RGBA8),Z===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),Z===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),Z===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),Z===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function y(O,R){let Z;return O?R===null||R===Cs||R===ko?Z=n.DEPTH24_STENCIL8:R===hs?Z=n.DEPTH32F_STENCIL8:R===Xa&&(Z=n.DEPTH24_STENCIL8,ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Cs||R===ko?Z=n.DEPTH_COMPONENT24:R===hs?Z=n.DEPTH_COMPONENT32F:R===Xa&&(Z=n.DEPTH_COMPONENT16),Z}function w(O,R){return T(O)===!0||O.isFramebufferTexture&&O.minFilter!==Qn&&O.minFilter!==Ti?Math.log2(Math.max(R.width,R.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?R.mipmaps.length:1}function U(O){let R=new WeakRef(O);i.get(O).__ref=R,p.add(R),_.register(O,R,R)}function L(O){let R=i.get(O).__ref;R!==void 0&&(p.delete(R),_.unregister(R))}function N(O){$(O.target)}function H(O){P(O.target)}function $(O){O.removeEventListener("dispose",N),L(O),D(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function P(O){O.removeEventListener("dispose",H),L(O),Q(O)}function z(){for(let O of p){let R=O.deref();R!==void 0&&(R.isRenderTarget===!0?P(R):$(R))}p.clear(),h.clear()}function D(O){let R=i.get(O);if(R.__webglInit===void 0)return;let Z=O.source,mt=f.get(Z);if(mt){let ct=mt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&B(O),Object.keys(mt).length===0&&f.delete(Z)}i.remove(O)}function B(O){let R=i.get(O);n.deleteTexture(R.__webglTexture);let Z=O.source,mt=f.get(Z);delete mt[R.__cacheKey],o.memory.textures--}function Q(O){let R=i.get(O);R.__depthDisposeCallback&&R.__depthDisposeCallback();let Z=O.depthTexture;if(Z&&Z.renderTarget===O&&$(Z),O.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let St=0;St<R.__webglFramebuffer[ct].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[ct][St]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=O.textures;for(let ct=0,St=mt.length;ct<St;ct++){let wt=i.get(mt[ct]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(mt[ct])}i.remove(O)}let Y=0;function j(){Y=0}function et(){return Y}function dt(O){Y=O}function ft(){let O=Y;return O>=s.maxTextures&&ne("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,O}function st(O){let R=[];return R.push(O.wrapS),R.push(O.wrapT),R.push(O.wrapR||0),R.push(O.magFilter),R.push(O.minFilter),R.push(O.anisotropy),R.push(O.internalFormat),R.push(O.format),R.push(O.type),R.push(O.generateMipmaps),R.push(O.mipmapsAutoUpdate),R.push(O.premultiplyAlpha),R.push(O.flipY),R.push(O.unpackAlignment),R.push(O.colorSpace),R.join()}function yt(O,R){let Z=i.get(O);if(O.isVideoTexture&&Ke(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&Z.__version!==O.version){let mt=O.image;if(mt===null)ne("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ne("WebGLRenderer: Texture marked for update but image is incomplete");else{sn(Z,O,R);return}}else O.isExternalTexture&&(Z.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Z.__webglTexture,n.TEXTURE0+R)}function xt(O,R){let Z=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Z.__version!==O.version){sn(Z,O,R);return}else O.isExternalTexture&&(Z.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Z.__webglTexture,n.TEXTURE0+R)}function Tt(O,R){let Z=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Z.__version!==O.version){sn(Z,O,R);return}e.bindTexture(n.TEXTURE_3D,Z.__webglTexture,n.TEXTURE0+R)}function At(O,R){let Z=i.get(O);if(O.version>0&&Z.__version!==O.version){Pn(Z,O,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture,n.TEXTURE0+R)}let jt={[ph]:n.REPEAT,[Ks]:n.CLAMP_TO_EDGE,[mh]:n.MIRRORED_REPEAT},pe={[Qn]:n.NEAREST,[z_]:n.NEAREST_MIPMAP_NEAREST,[Ec]:n.NEAREST_MIPMAP_LINEAR,[Ti]:n.LINEAR,[Hh]:n.LINEAR_MIPMAP_NEAREST,[Cr]:n.LINEAR_MIPMAP_LINEAR},Yt={[W_]:n.NEVER,[Cm]:n.ALWAYS,[$_]:n.LESS,[Am]:n.LEQUAL,[q_]:n.EQUAL,[Rm]:n.GEQUAL,[X_]:n.GREATER,[Y_]:n.NOTEQUAL};function Se(O,R){if(R.type===hs&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Ti||R.magFilter===Hh||R.magFilter===Ec||R.magFilter===Cr||R.minFilter===Ti||R.minFilter===Hh||R.minFilter===Ec||R.minFilter===Cr)&&ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,jt[R.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,jt[R.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,jt[R.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,pe[R.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,pe[R.minFilter]),R.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,Yt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Qn||R.minFilter!==Ec&&R.minFilter!==Cr||R.type===hs&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(O,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ye(O,R){let Z=!1;O.__webglInit===void 0&&(O.__webglInit=!0,R.addEventListener("dispose",N),U(R));let mt=R.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let St=st(R);if(St!==O.__cacheKey){ct[St]===void 0&&(ct[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),ct[St].usedTimes++;let wt=ct[O.__cacheKey];wt!==void 0&&(ct[O.__cacheKey].usedTimes--,wt.usedTimes===0&&B(R)),O.__cacheKey=St,O.__webglTexture=ct[St].texture}return Z}function de(O,R,Z){return Math.floor(Math.floor(O/Z)/R)}function gn(O,R,Z,mt){let St=O.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,Z,mt,R.data);else{St.sort((V,lt)=>V.start-lt.start);let wt=0;for(let V=1;V<St.length;V++){let lt=St[wt],ot=St[V],Pt=lt.start+lt.count,Mt=de(ot.start,R.width,4),Rt=de(lt.start,R.width,4);ot.start<=Pt+1&&Mt===Rt&&de(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let V=0,lt=St.length;V<lt;V++){let ot=St[V],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%R.width,Zt=Math.floor(Pt/R.width),re=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,Zt,re,pt,Z,mt,R.data)}O.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function sn(O,R,Z){let mt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=n.TEXTURE_3D);let ct=ye(O,R),St=R.source;e.bindTexture(mt,O.__webglTexture,n.TEXTURE0+Z);let wt=i.get(St);if(St.version!==wt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+Z),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=Le.getPrimaries(Le.workingColorSpace),Wt=R.colorSpace===Ir?null:Le.getPrimaries(R.colorSpace),oe=R.colorSpace===Ir||pt===Wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,oe)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=x(R.image,!1,s.maxTextureSize);at=Xt(R,at);let vt=r.convert(R.format,R.colorSpace),V=r.convert(R.type),lt=S(R.internalFormat,vt,V,R.normalized,R.colorSpace,R.isVideoTexture);Se(mt,R);let ot,Pt=R.mipmaps,Mt=R.isVideoTexture!==!0,Rt=wt.__version===void 0||ct===!0,Zt=St.dataReady,re=w(R,at);if(R.isDepthTexture)lt=y(R.format===Pr,R.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,V,null));else if(R.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,re,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,V,ot.data);R.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,re,lt,at.width,at.height),Zt&&gn(R,at,vt,V)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,V,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)if(ot=Pt[pt],R.format!==Is)if(vt!==null)if(Mt){if(Zt)if(R.layerUpdates.size>0){let oe=km(ot.width,ot.height,R.format,R.type);for(let Dt of R.layerUpdates){let _e=ot.data.subarray(Dt*oe/ot.data.BYTES_PER_ELEMENT,(Dt+1)*oe/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,vt,_e)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,V,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,vt,V,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,re,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],R.format!==Is?vt!==null?Mt?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,V,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,lt,at.width,at.height,at.depth),Zt)if(R.layerUpdates.size>0){let pt=km(at.width,at.height,R.format,R.type);for(let Wt of R.layerUpdates){let oe=at.data.subarray(Wt*pt/at.data.BYTES_PER_ELEMENT,(Wt+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Wt,at.width,at.height,1,vt,V,oe)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,V,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,vt,V,at.data);else if(R.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,re,lt,at.width,at.height,at.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,V,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,vt,V,at.data);else if(R.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,re,lt,at.width,at.height);else{let pt=at.width,Wt=at.height;for(let oe=0;oe<re;oe++)e.texImage2D(n.TEXTURE_2D,oe,lt,pt,Wt,0,vt,V,null),pt>>=1,Wt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=Wt=>{let oe=Wt.changedElements;for(let Dt of h)oe.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let oe=n.RGBA,Dt=n.RGBA,_e=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,oe,Dt,_e,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=ee(Pt[0]);e.texStorage2D(n.TEXTURE_2D,re,lt,pt.width,pt.height)}for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,vt,V,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,vt,V,ot);R.generateMipmaps=!1}else if(Mt){if(Rt){let pt=ee(at);e.texStorage2D(n.TEXTURE_2D,re,lt,pt.width,pt.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,V,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,vt,V,at);T(R)&&R.mipmapsAutoUpdate===!0&&v(mt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function Pn(O,R,Z){if(R.image.length!==6)return;let mt=ye(O,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+Z);let St=i.get(ct);if(ct.version!==St.__version||mt===!0){e.activeTexture(n.TEXTURE0+Z);let wt=Le.getPrimaries(Le.workingColorSpace),rt=R.colorSpace===Ir?null:Le.getPrimaries(R.colorSpace),at=R.colorSpace===Ir||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=R.isCompressedTexture||R.image[0].isCompressedTexture,V=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!vt&&!V?lt[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):lt[Dt]=V?R.image[Dt].image:R.image[Dt],lt[Dt]=Xt(R,lt[Dt]);let ot=lt[0],Pt=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Rt=S(R.internalFormat,Pt,Mt,R.normalized,R.colorSpace),Zt=R.isVideoTexture!==!0,re=St.__version===void 0||mt===!0,pt=ct.dataReady,Wt=w(R,ot);Se(n.TEXTURE_CUBE_MAP,R);let oe;if(R.isDepthTexture){if(Rt=y(R.format===Pr,R.type),re)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(vt){Zt&&re&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){oe=lt[Dt].mipmaps;for(let _e=0;_e<oe.length;_e++){let rn=oe[_e];R.format!==Is?Pt!==null?Zt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e,0,0,rn.width,rn.height,Pt,rn.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e,Rt,rn.width,rn.height,0,rn.data):ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e,0,0,rn.width,rn.height,Pt,Mt,rn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e,Rt,rn.width,rn.height,0,Pt,Mt,rn.data)}}}else{if(oe=R.mipmaps,Zt&&re){oe.length>0&&Wt++;let Dt=ee(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(V){Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let _e=0;_e<oe.length;_e++){let xi=oe[_e].image[Dt].image;Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e+1,0,0,xi.width,xi.height,Pt,Mt,xi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e+1,Rt,xi.width,xi.height,0,Pt,Mt,xi.data)}}else{Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let _e=0;_e<oe.length;_e++){let rn=oe[_e];Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e+1,0,0,Pt,Mt,rn.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,_e+1,Rt,Pt,Mt,rn.image[Dt])}}}T(R)&&R.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),St.__version=ct.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function je(O,R,Z,mt,ct,St){let wt=r.convert(Z.format,Z.colorSpace),rt=r.convert(Z.type),at=S(Z.internalFormat,wt,rt,Z.normalized,Z.colorSpace),vt=i.get(R),V=i.get(Z);if(V.__renderTarget=R,!vt.__hasExternalTextures){let lt=Math.max(1,R.width>>St),ot=Math.max(1,R.height>>St);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,St,at,lt,ot,R.depth,0,wt,rt,null):e.texImage2D(ct,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,O),Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ct,V.__webglTexture,0,me(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ct,V.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Xn(O,R,Z){if(n.bindRenderbuffer(n.RENDERBUFFER,O),R.depthBuffer){let mt=R.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,St=y(R.stencilBuffer,ct),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),St,R.width,R.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,O)}else{let mt=R.textures;for(let ct=0;ct<mt.length;ct++){let St=mt[ct],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=S(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),at,R.width,R.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ne(O,R,Z){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,O),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let St=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),mt?At(R.depthTexture,0):yt(R.depthTexture,0);let wt=ct.__webglTexture,rt=me(R),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+Z:n.TEXTURE_2D,vt=R.depthTexture.format===Pr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===wr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else if(R.depthTexture.format===Pr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bn(O){let R=i.get(O),Z=O.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==O.depthTexture){let mt=O.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=mt}if(O.depthTexture&&!R.__autoAllocateDepthBuffer)if(Z)for(let mt=0;mt<6;mt++)Ne(R.__webglFramebuffer[mt],O,mt);else O.texture.mipmaps.length>0?Ne(R.__webglFramebuffer[0],O,0):Ne(R.__webglFramebuffer,O,0);else if(Z){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=n.createRenderbuffer(),Xn(R.__webglDepthbuffer[mt],O,!1);else{let ct=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}}else if(O.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),Xn(R.__webglDepthbuffer,O,!1);else{let ct=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Mn(O,R,Z){let mt=i.get(O);R!==void 0&&je(mt.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Z!==void 0&&Bn(O)}function In(O){let R=O.texture,Z=i.get(O),mt=i.get(R);O.addEventListener("dispose",H),U(O);let ct=O.textures,St=O.isWebGLCubeRenderTarget===!0,wt=ct.length>1;if(wt||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=R.version,o.memory.textures++),St){Z.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){Z.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)Z.__webglFramebuffer[rt][at]=n.createFramebuffer()}else Z.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){Z.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)Z.__webglFramebuffer[rt]=n.createFramebuffer()}else Z.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ct.length;rt<at;rt++){let vt=i.get(ct[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&Ct(O)===!1){Z.__webglMultisampledFramebuffer=n.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];Z.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Z.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),V=r.convert(at.type),lt=S(at.internalFormat,vt,V,at.normalized,at.colorSpace,O.isXRRenderTarget===!0),ot=me(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,Z.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(Z.__webglDepthRenderbuffer=n.createRenderbuffer(),Xn(Z.__webglDepthRenderbuffer,O,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),Se(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)je(Z.__webglFramebuffer[rt][at],O,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else je(Z.__webglFramebuffer[rt],O,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);T(R)?v(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ct.length;rt<at;rt++){let vt=ct[rt],V=i.get(vt),lt=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(lt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,V.__webglTexture),Se(lt,vt),je(Z.__webglFramebuffer,O,vt,n.COLOR_ATTACHMENT0+rt,lt,0),T(vt)&&v(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(rt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),Se(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)je(Z.__webglFramebuffer[at],O,R,n.COLOR_ATTACHMENT0,rt,at);else je(Z.__webglFramebuffer,O,R,n.COLOR_ATTACHMENT0,rt,0);T(R)?v(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}O.depthBuffer&&Bn(O)}function W(O){let R=O.textures;for(let Z=0,mt=R.length;Z<mt;Z++){let ct=R[Z];if(T(ct)&&ct.mipmapsAutoUpdate===!0){let St=A(O),wt=i.get(ct).__webglTexture;e.bindTexture(St,wt),v(St),e.unbindTexture()}}}let Nt=[];function ie(O){if(O.samples>0){if(Ct(O)===!1){let R=O.textures,Z=O.width,mt=O.height,ct=n.COLOR_BUFFER_BIT,St=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(O),rt=R.length>1;if(rt)for(let vt=0;vt<R.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let vt=0;vt<R.length;vt++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let V=i.get(R[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,Z,mt,0,0,Z,mt,ct,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+vt),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<R.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let V=i.get(R[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,V,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let R=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function me(O){return Math.min(s.maxSamples,O.samples)}function Ct(O){let R=i.get(O);return O.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Ke(O){let R=o.render.frame;u.get(O)!==R&&(u.set(O,R),O.update())}function Xt(O,R){let Z=O.colorSpace,mt=O.format,ct=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||Z!==ec&&Z!==Ir&&(Le.getTransfer(Z)===Ve?(mt!==Is||ct!==es)&&ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ae("WebGLTextures: Unsupported texture color space:",Z)),R}function ee(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=yt,this.setTexture2DArray=xt,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=Mn,this.setupRenderTarget=In,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=ie,this.setupDepthRenderbuffer=Bn,this.setupFrameBufferTexture=je,this.useMultisampledRTT=Ct,this.dispose=z}function JC(n,t){function e(i,s=Ir){let r,o=Le.getTransfer(s);if(i===es)return n.UNSIGNED_BYTE;if(i===Vh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Wh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===vm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===bm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===_m)return n.BYTE;if(i===ym)return n.SHORT;if(i===Xa)return n.UNSIGNED_SHORT;if(i===Gh)return n.INT;if(i===Cs)return n.UNSIGNED_INT;if(i===hs)return n.FLOAT;if(i===Ps)return n.HALF_FLOAT;if(i===Mm)return n.ALPHA;if(i===Sm)return n.RGB;if(i===Is)return n.RGBA;if(i===wr)return n.DEPTH_COMPONENT;if(i===Pr)return n.DEPTH_STENCIL;if(i===$h)return n.RED;if(i===qh)return n.RED_INTEGER;if(i===ro)return n.RG;if(i===Xh)return n.RG_INTEGER;if(i===Yh)return n.RGBA_INTEGER;if(i===Tc||i===Ac||i===Rc||i===Cc)if(o===Ve)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Tc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ac)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Rc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Cc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Tc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ac)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Rc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Cc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zh||i===jh||i===Jh||i===Kh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===jh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Jh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Kh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qh||i===td||i===ed||i===nd||i===id||i===Pc||i===sd)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Qh||i===td)return o===Ve?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ed)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===nd)return r.COMPRESSED_R11_EAC;if(i===id)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Pc)return r.COMPRESSED_RG11_EAC;if(i===sd)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===rd||i===od||i===ad||i===ld||i===cd||i===ud||i===hd||i===dd||i===fd||i===pd||i===md||i===gd||i===xd||i===_d)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===rd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===od)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ad)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ld)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===cd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ud)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===hd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===dd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===pd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===md)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===gd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===xd)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===_d)return o===Ve?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===yd||i===vd||i===bd)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===yd)return o===Ve?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vd)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===bd)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Md||i===Sd||i===Ic||i===wd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Md)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Sd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ic)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===wd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ko?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var KC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,QC=`
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

}`,Ym=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new mc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new di({vertexShader:KC,fragmentShader:QC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ye(new yc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zm=class extends As{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new Ym,g={},x=e.getContextAttributes(),T=null,v=null,A=[],S=[],y=new Kt,w=null,U=null,L=new Ei;L.viewport=new vn;let N=new Ei;N.viewport=new vn;let H=[L,N],$=new Bh,P=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let yt=A[st];return yt===void 0&&(yt=new Fa,A[st]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(st){let yt=A[st];return yt===void 0&&(yt=new Fa,A[st]=yt),yt.getGripSpace()},this.getHand=function(st){let yt=A[st];return yt===void 0&&(yt=new Fa,A[st]=yt),yt.getHandSpace()};function D(st){let yt=S.indexOf(st.inputSource);if(yt===-1)return;let xt=A[yt];xt!==void 0&&(xt.update(st.inputSource,st.frame,c||o),xt.dispatchEvent({type:st.type,data:st.inputSource}))}function B(){s.removeEventListener("select",D),s.removeEventListener("selectstart",D),s.removeEventListener("selectend",D),s.removeEventListener("squeeze",D),s.removeEventListener("squeezestart",D),s.removeEventListener("squeezeend",D),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",Q);for(let st=0;st<A.length;st++){let yt=S[st];yt!==null&&(S[st]=null,A[st].disconnect(yt))}P=null,z=null,m.reset();for(let st in g)delete g[st];if(t.setRenderTarget(T),f=null,d=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),U!==null){let st=U.camera;st.fov=U.fov,st.zoom=U.zoom,st.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",D),s.addEventListener("selectstart",D),s.addEventListener("selectend",D),s.addEventListener("squeeze",D),s.addEventListener("squeezestart",D),s.addEventListener("squeezeend",D),s.addEventListener("end",B),s.addEventListener("inputsourceschange",Q),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=x.stencil?Pr:wr,Tt=x.stencil?ko:Cs);let jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new Ki(d.textureWidth,d.textureHeight,{format:Is,type:es,depthTexture:new Rr(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Ki(f.framebufferWidth,f.framebufferHeight,{format:Is,type:es,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q(st){for(let yt=0;yt<st.removed.length;yt++){let xt=st.removed[yt],Tt=S.indexOf(xt);Tt>=0&&(S[Tt]=null,A[Tt].disconnect(xt))}for(let yt=0;yt<st.added.length;yt++){let xt=st.added[yt],Tt=S.indexOf(xt);if(Tt===-1){for(let jt=0;jt<A.length;jt++)if(jt>=S.length){S.push(xt),Tt=jt;break}else if(S[jt]===null){S[jt]=xt,Tt=jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(xt)}}function Y(st,yt){yt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(yt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let yt=st.near,xt=st.far;m.texture!==null&&(m.depthNear>0&&(yt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),$.near=N.near=L.near=yt,$.far=N.far=L.far=xt,(P!==$.near||z!==$.far)&&(s.updateRenderState({depthNear:$.near,depthFar:$.far}),P=$.near,z=$.far),$.layers.mask=st.layers.mask|6,L.layers.mask=$.layers.mask&-5,N.layers.mask=$.layers.mask&-3;let Tt=st.parent,At=$.cameras;Y($,Tt);for(let jt=0;jt<At.length;jt++)Y(At[jt],Tt);$.projectionMatrix.copy(L.projectionMatrix),$.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&st.isPerspectiveCamera&&(U={camera:st,fov:st.fov,zoom:st.zoom}),j(st,$,Tt)};function j(st,yt,xt){xt===null?st.matrix.copy(yt.matrixWorld):(st.matrix.copy(xt.matrixWorld),st.matrix.invert(),st.matrix.multiply(yt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(yt.projectionMatrix),st.projectionMatrixInverse.copy(yt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Na*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return $},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh($)},this.getCameraTexture=function(st){return g[st]};let et=null;function dt(st,yt){if(u=yt.getViewerPose(c||o),p=yt,u!==null){let xt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Tt=!1;xt.length!==$.cameras.length&&($.cameras.length=0,Tt=!0);for(let Yt=0;Yt<xt.length;Yt++){let Se=xt[Yt],ye=null;if(f!==null)ye=f.getViewport(Se);else{let gn=h.getViewSubImage(d,Se);ye=gn.viewport,Yt===0&&(t.setRenderTargetTextures(v,gn.colorTexture,gn.depthStencilTexture),t.setRenderTarget(v))}let de=H[Yt];de===void 0&&(de=new Ei,de.layers.enable(Yt),de.viewport=new vn,H[Yt]=de),de.matrix.fromArray(Se.transform.matrix),de.matrix.decompose(de.position,de.quaternion,de.scale),de.projectionMatrix.fromArray(Se.projectionMatrix),de.projectionMatrixInverse.copy(de.projectionMatrix).invert(),de.viewport.set(ye.x,ye.y,ye.width,ye.height),Yt===0&&($.matrix.copy(de.matrix),$.matrix.decompose($.position,$.quaternion,$.scale)),Tt===!0&&$.cameras.push(de)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let Yt=h.getDepthInformation(xt[0]);Yt&&Yt.isValid&&Yt.texture&&m.init(Yt,s.renderState)}if(At&&At.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let Yt=0;Yt<xt.length;Yt++){let Se=xt[Yt].camera;if(Se){let ye=g[Se];ye||(ye=new mc,g[Se]=ye);let de=h.getCameraImage(Se);ye.sourceTexture=de}}}}for(let xt=0;xt<A.length;xt++){let Tt=S[xt],At=A[xt];Tt!==null&&At!==void 0&&At.update(Tt,yt,c||o)}et&&et(st,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),p=null}let ft=new wy;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){et=st},this.dispose=function(){}}},tP=new ge,Ny=new ce;Ny.set(-1,0,0,0,1,0,0,0,1);function eP(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Om(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,T,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,T):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===si&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===si&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=t.get(g),T=x.envMap,v=x.envMapRotation;T&&(m.envMap.value=T,m.envMapRotation.value.setFromMatrix4(tP.makeRotationFromEuler(v)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Ny),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,T){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=T*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===si&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function nP(n,t,e,i){let s={},r={};function o(x,T){let v=T.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,T){let v=s[x.id];v===void 0&&(p(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",m));let A=T.program;i.updateUBOMapping(x,A);let S=t.render.frame;r[x.id]!==S&&(c(x),r[x.id]=S)}function l(x){let T=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(x){let T=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let S=0,y=v.length;S<y;S++){let w=v[S];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],S,U,A);else u(w,S,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,T,v,A){if(d(x,T,v,A)===!0){let S=x.__offset,y=x.value;if(Array.isArray(y)){let w=0;for(let U=0;U<y.length;U++){let L=y[U],N=_(L,!0);h(L,x.__data,w),w+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,x.__data)}}function h(x,T,v){typeof x=="number"||typeof x=="boolean"?T[v]=x:x.isMatrix3?(T[v]=x.elements[0],T[v+1]=x.elements[1],T[v+2]=x.elements[2],T[v+3]=0,T[v+4]=x.elements[3],T[v+5]=x.elements[4],T[v+6]=x.elements[5],T[v+7]=0,T[v+8]=x.elements[6],T[v+9]=x.elements[7],T[v+10]=x.elements[8],T[v+11]=0):ArrayBuffer.isView(x)?T.set(x.subarray(0,T.length-v),v):x.toArray(T,v)}function d(x,T,v,A){let S=x.value,y=T+"_"+v;if(Array.isArray(S)){A[y]===void 0&&(A[y]=[]);let w=A[y],U=!1;for(let L=0;L<S.length;L++)f(S[L],w,L)===!0&&(U=!0);return U}return f(S,A,y)}function f(x,T,v){if(T[v]===void 0)return typeof x=="number"||typeof x=="boolean"?T[v]=x:ArrayBuffer.isView(x)?T[v]=x.slice():T[v]=x.clone(),!0;{let A=T[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return T[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let T=x.uniforms,v=0,A=16;for(let y=0,w=T.length;y<w;y++){let U=Array.isArray(T[y])?T[y]:[T[y]];for(let L=0,N=U.length;L<N;L++){let H=U[L],$=Array.isArray(H.value)?H.value:[H.value],P=Array.isArray(T[y])||Array.isArray(H.value),z=v;for(let B=0,Q=$.length;B<Q;B++){let Y=$[B],j=_(Y,P),et=v%A,dt=et%j.boundary,ft=et+dt;v+=dt,ft!==0&&A-ft<j.storage&&(v+=A-ft),B===0&&(z=v),v+=j.storage}let D=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new D((v-z)/Float32Array.BYTES_PER_ELEMENT),H.__offset=z}}let S=v%A;return S>0&&(v+=A-S),x.__size=v,x.__cache={},this}function _(x,T){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):ne("WebGLRenderer: Unsupported uniform value type.",x),T===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let T=x.target;T.removeEventListener("dispose",m),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var iP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),sr=null;function sP(){return sr===null&&(sr=new hc(iP,16,16,ro,Ps),sr.name="DFG_LUT",sr.minFilter=Ti,sr.magFilter=Ti,sr.wrapS=Ks,sr.wrapT=Ks,sr.generateMipmaps=!1,sr.needsUpdate=!0),sr}var Pd=class{constructor(t={}){let{canvas:e=Z_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=es}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,m=new Set([Yh,Xh,qh]),g=new Set([es,Cs,Xa,ko,Vh,Wh]),x=new Uint32Array(4),T=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,S=null,y=[],w=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ir,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,H=null,$=null,P=null,z=null;this._outputColorSpace=wi;let D=0,B=0,Q=null,Y=-1,j=null,et=new vn,dt=new vn,ft=null,st=new te(0),yt=0,xt=e.width,Tt=e.height,At=1,jt=null,pe=null,Yt=new vn(0,0,xt,Tt),Se=new vn(0,0,xt,Tt),ye=!1,de=new Lo,gn=new vh,sn=!1,Pn=!1,je=new ge,Xn=new G,Ne=new vn,Bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Mn=!1;function In(){return Q===null?At:1}let W=i;function Nt(I,q){return e.getContext(I,q)}let ie,me,Ct,Ke,Xt,ee,O,R,Z,mt,ct,St,wt,rt,at,vt,V,lt,ot,Pt,Mt,Rt,Zt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Wt,!1),e.addEventListener("webglcontextrestored",oe,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),W===null){let q="webgl2";if(W=Nt(q,I),W===null)throw Nt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}re()}catch(I){throw e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),ae("WebGLRenderer: "+I.message),I}function re(){ie=new mR(W),ie.init(),Mt=new JC(W,ie),me=new sR(W,ie,t,Mt),Ct=new ZC(W,ie),me.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),$=W.createFramebuffer(),P=W.createFramebuffer(),z=W.createFramebuffer(),Ke=new _R(W),Xt=new UC,ee=new jC(W,ie,Ct,Xt,me,Mt,Ke),O=new pR(L),R=new vE(W),Rt=new nR(W,R),Z=new gR(W,R,Ke,Rt),mt=new vR(W,Z,R,Rt,Ke),lt=new yR(W,me,ee),at=new rR(Xt),ct=new NC(L,O,ie,me,Rt,at),St=new eP(L,Xt),wt=new FC,rt=new VC(ie),V=new eR(L,O,Ct,mt,p,l),vt=new YC(L,mt,me),Zt=new nP(W,Ke,me,Ct),ot=new iR(W,ie,Ke),Pt=new xR(W,ie,Ke),Ke.programs=ct.programs,L.capabilities=me,L.extensions=ie,L.properties=Xt,L.renderLists=wt,L.shadowMap=vt,L.state=Ct,L.info=Ke}_!==es&&(U=new MR(_,e.width,e.height,a,s,r));let pt=new Zm(L,W);this.xr=pt,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let I=ie.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=ie.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(xt,Tt,!1))},this.getSize=function(I){return I.set(xt,Tt)},this.setSize=function(I,q,it=!0){if(pt.isPresenting){ne("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=I,Tt=q,e.width=Math.floor(I*At),e.height=Math.floor(q*At),it===!0&&(e.style.width=I+"px",e.style.height=q+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,I,q)},this.getDrawingBufferSize=function(I){return I.set(xt*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,q,it){xt=I,Tt=q,At=it,e.width=Math.floor(I*it),e.height=Math.floor(q*it),this.setViewport(0,0,I,q)},this.setEffects=function(I){if(_===es){ae("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let q=0;q<I.length;q++)if(I[q].isOutputPass===!0){ne("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(et)},this.getViewport=function(I){return I.copy(Yt)},this.setViewport=function(I,q,it,J){I.isVector4?Yt.set(I.x,I.y,I.z,I.w):Yt.set(I,q,it,J),Ct.viewport(et.copy(Yt).multiplyScalar(In()).round())},this.getScissor=function(I){return I.copy(Se)},this.setScissor=function(I,q,it,J){I.isVector4?Se.set(I.x,I.y,I.z,I.w):Se.set(I,q,it,J),Ct.scissor(dt.copy(Se).multiplyScalar(In()).round())},this.getScissorTest=function(){return ye},this.setScissorTest=function(I){Ct.setScissorTest(ye=I)},this.setOpaqueSort=function(I){jt=I},this.setTransparentSort=function(I){pe=I},this.getClearColor=function(I){return I.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(I=!0,q=!0,it=!0){let J=0;if(I){let K=!1;if(Q!==null){let It=Q.texture.format;K=m.has(It)}if(K){let It=Q.texture.type,Ut=g.has(It),Lt=V.getClearColor(),Ft=V.getClearAlpha(),qt=Lt.r,le=Lt.g,Ae=Lt.b;Ut?(x[0]=qt,x[1]=le,x[2]=Ae,x[3]=Ft,W.clearBufferuiv(W.COLOR,0,x)):(T[0]=qt,T[1]=le,T[2]=Ae,T[3]=Ft,W.clearBufferiv(W.COLOR,0,T))}else J|=W.COLOR_BUFFER_BIT}q&&(J|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(J|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&W.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),H=I},this.dispose=function(){e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),V.dispose(),wt.dispose(),rt.dispose(),ee.dispose(),Xt.dispose(),O.dispose(),mt.dispose(),Z.dispose(),Rt.dispose(),Zt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",Su),pt.removeEventListener("sessionend",zs),hr.stop()};function Wt(I){I.preventDefault(),rc("WebGLRenderer: Context Lost."),N=!0}function oe(){rc("WebGLRenderer: Context Restored."),N=!1;let I=Ke.autoReset,q=vt.enabled,it=vt.autoUpdate,J=vt.needsUpdate,K=vt.type;re(),Ke.autoReset=I,vt.enabled=q,vt.autoUpdate=it,vt.needsUpdate=J,vt.type=K}function Dt(I){ae("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function _e(I){let q=I.target;q.removeEventListener("dispose",_e),rn(q)}function rn(I){xi(I),Xt.remove(I)}function xi(I){let q=Xt.get(I).programs;q!==void 0&&(q.forEach(function(it){ct.releaseProgram(it)}),I.isShaderMaterial&&ct.releaseShaderCache(I))}this.renderBufferDirect=function(I,q,it,J,K,It){q===null&&(q=Bn);let Ut=K.isMesh&&K.matrixWorld.determinantAffine()<0,Lt=Fl(I,q,it,J,K);Ct.setMaterial(J,Ut);let Ft=it.index,qt=1;if(J.wireframe===!0){if(Ft=Z.getWireframeAttribute(it),Ft===void 0)return;qt=2}let le=it.drawRange,Ae=it.attributes.position,$t=le.start*qt,Re=(le.start+le.count)*qt;It!==null&&($t=Math.max($t,It.start*qt),Re=Math.min(Re,(It.start+It.count)*qt)),Ft!==null?($t=Math.max($t,0),Re=Math.min(Re,Ft.count)):Ae!=null&&($t=Math.max($t,0),Re=Math.min(Re,Ae.count));let yn=Re-$t;if(yn<0||yn===1/0)return;Rt.setup(K,J,Lt,it,Ft);let $e,qe=ot;if(Ft!==null&&($e=R.get(Ft),qe=Pt,qe.setIndex($e)),K.isMesh)J.wireframe===!0?(Ct.setLineWidth(J.wireframeLinewidth*In()),qe.setMode(W.LINES)):qe.setMode(W.TRIANGLES);else if(K.isLine){let kn=J.linewidth;kn===void 0&&(kn=1),Ct.setLineWidth(kn*In()),K.isLineSegments?qe.setMode(W.LINES):K.isLineLoop?qe.setMode(W.LINE_LOOP):qe.setMode(W.LINE_STRIP)}else K.isPoints?qe.setMode(W.POINTS):K.isSprite&&qe.setMode(W.TRIANGLES);if(K.isBatchedMesh)if(ie.get("WEBGL_multi_draw"))qe.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let kn=K._multiDrawStarts,Ht=K._multiDrawCounts,Ln=K._multiDrawCount,Ie=Ft?R.get(Ft).bytesPerElement:1,fr=Xt.get(J).currentProgram.getUniforms();for(let Dn=0;Dn<Ln;Dn++)fr.setValue(W,"_gl_DrawID",Dn),qe.render(kn[Dn]/Ie,Ht[Dn])}else if(K.isInstancedMesh)qe.renderInstances($t,yn,K.count);else if(it.isInstancedBufferGeometry){let kn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Ht=Math.min(it.instanceCount,kn);qe.renderInstances($t,yn,Ht)}else qe.render($t,yn)};function Nl(I,q,it,J){H!==null&&I.isNodeMaterial&&H.setObject(J,I),sn===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===fi&&I.forceSinglePass===!1?(I.side=si,I.needsUpdate=!0,Hs(I,q,J),I.side=nr,I.needsUpdate=!0,Hs(I,q,J),I.side=fi):Hs(I,q,J)}this.compile=function(I,q,it=null){it===null&&(it=I),H!==null&&H.renderStart(I,q,it),S=rt.get(it),S.init(q),w.push(S),it.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(S.pushLight(K),K.castShadow&&S.pushShadow(K))}),I!==it&&I.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(S.pushLight(K),K.castShadow&&S.pushShadow(K))}),S.setupLights(),H!==null&&H.updateLights(S.state.lightsArray),Pn=this.localClippingEnabled,sn=at.init(this.clippingPlanes,Pn),sn===!0&&at.setGlobalState(this.clippingPlanes,q),H!==null&&vt.render(S.state.shadowsArray,it,q);let J=new Set;return I.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let It=K.material;if(It)if(Array.isArray(It))for(let Ut=0;Ut<It.length;Ut++){let Lt=It[Ut];Nl(Lt,it,q,K),J.add(Lt)}else Nl(It,it,q,K),J.add(It)}),S=w.pop(),H!==null&&H.renderEnd(),J},this.compileAsync=function(I,q,it=null){let J=this.compile(I,q,it);return new Promise(K=>{function It(){if(J.forEach(function(Ut){let Ft=Xt.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&J.delete(Ut)}),J.size===0){K(I);return}setTimeout(It,10)}ie.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let na=null;function pp(I){na&&na(I)}function Su(){hr.stop()}function zs(){hr.start()}let hr=new wy;hr.setAnimationLoop(pp),typeof self<"u"&&hr.setContext(self),this.setAnimationLoop=function(I){na=I,pt.setAnimationLoop(I),I===null?hr.stop():hr.start()},pt.addEventListener("sessionstart",Su),pt.addEventListener("sessionend",zs),this.render=function(I,q){if(q!==void 0&&q.isCamera!==!0){ae("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;H!==null&&H.renderStart(I,q);let it=pt.enabled===!0&&pt.isPresenting===!0,J=U!==null&&(Q===null||it)&&U.begin(L,Q);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(L,I,q,Q),S=rt.get(I,w.length),S.init(q),S.state.textureUnits=ee.getTextureUnits(),w.push(S),je.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?gn.setFromArrayCamera(q):de.setFromProjectionMatrix(je,us,q.reversedDepth),Pn=this.localClippingEnabled,sn=at.init(this.clippingPlanes,Pn),A=wt.get(I,y.length),A.init(),y.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ut=L.xr.getDepthSensingMesh();Ut!==null&&dr(Ut,q,-1/0,L.sortObjects)}dr(I,q,0,L.sortObjects),A.finish(),H!==null&&H.updateLights(S.state.lightsArray),L.sortObjects===!0&&A.sort(jt,pe),Mn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Mn&&V.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),sn===!0&&at.beginShadows();let K=S.state.shadowsArray;if(vt.render(K,I,q),sn===!0&&at.endShadows(),(J&&U.hasRenderPass())===!1){let Ut=A.opaque,Lt=A.transmissive;if(S.setupLights(),q.isArrayCamera){let Ft=q.cameras;if(Lt.length>0)for(let qt=0,le=Ft.length;qt<le;qt++){let Ae=Ft[qt];ys(Ut,Lt,I,Ae)}Mn&&V.render(I);for(let qt=0,le=Ft.length;qt<le;qt++){let Ae=Ft[qt];Ul(A,I,Ae,Ae.viewport)}}else Lt.length>0&&ys(Ut,Lt,I,q),Mn&&V.render(I),Ul(A,I,q)}Q!==null&&B===0&&(ee.updateMultisampleRenderTarget(Q),ee.updateRenderTargetMipmap(Q)),J&&U.end(L),I.isScene===!0&&I.onAfterRender(L,I,q),Rt.resetDefaultState(),Y=-1,j=null,w.pop(),w.length>0?(S=w[w.length-1],ee.setTextureUnits(S.state.textureUnits),sn===!0&&at.setGlobalState(L.clippingPlanes,S.state.camera)):S=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,H!==null&&H.renderEnd()};function dr(I,q,it,J){if(I.visible===!1)return;if(I.layers.test(q.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update(q);else if(I.isLight)S.pushLight(I),I.castShadow&&S.pushShadow(I);else if(I.isSprite){let Ut=q.isArrayCamera?gn:de;if(!I.frustumCulled||I.intersectsFrustum(Ut)){J&&Ne.setFromMatrixPosition(I.matrixWorld).applyMatrix4(je);let Lt=mt.update(I),Ft=I.material;Ft.visible&&A.push(I,Lt,Ft,it,Ne.z,null,q)}}else if(I.isMesh||I.isLine||I.isPoints){let Ut=q.isArrayCamera?gn:de;if(!I.frustumCulled||I.intersectsFrustum(Ut)){let Lt=mt.update(I),Ft=I.material;if(J&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),Ne.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),Ne.copy(Lt.boundingSphere.center)),Ne.applyMatrix4(I.matrixWorld).applyMatrix4(je)),Array.isArray(Ft)){let qt=Lt.groups;for(let le=0,Ae=qt.length;le<Ae;le++){let $t=qt[le],Re=Ft[$t.materialIndex];Re&&Re.visible&&A.push(I,Lt,Re,it,Ne.z,$t,q)}}else Ft.visible&&A.push(I,Lt,Ft,it,Ne.z,null,q)}}}let It=I.children;for(let Ut=0,Lt=It.length;Ut<Lt;Ut++)dr(It[Ut],q,it,J)}function Ul(I,q,it,J){let{opaque:K,transmissive:It,transparent:Ut}=I;S.setupLightsView(it),sn===!0&&at.setGlobalState(L.clippingPlanes,it),J&&Ct.viewport(et.copy(J)),K.length>0&&Sn(K,q,it),It.length>0&&Sn(It,q,it),Ut.length>0&&Sn(Ut,q,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function ys(I,q,it,J){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[J.id]===void 0){let $t=ie.has("EXT_color_buffer_half_float")||ie.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[J.id]=new Ki(1,1,{generateMipmaps:!0,type:$t?Ps:es,minFilter:Cr,samples:Math.max(4,me.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Le.workingColorSpace})}let It=S.state.transmissionRenderTarget[J.id],Ut=J.viewport||et;It.setSize(Ut.z*L.transmissionResolutionScale,Ut.w*L.transmissionResolutionScale);let Lt=L.getRenderTarget(),Ft=L.getActiveCubeFace(),qt=L.getActiveMipmapLevel();L.setRenderTarget(It),L.getClearColor(st),yt=L.getClearAlpha(),yt<1&&L.setClearColor(16777215,.5),L.clear(),Mn&&V.render(it);let le=L.toneMapping;L.toneMapping=ir;let Ae=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),S.setupLightsView(J),sn===!0&&at.setGlobalState(L.clippingPlanes,J),Sn(I,it,J),ee.updateMultisampleRenderTarget(It),ee.updateRenderTargetMipmap(It),ie.has("WEBGL_multisampled_render_to_texture")===!1){let $t=!1;for(let Re=0,yn=q.length;Re<yn;Re++){let $e=q[Re],{object:qe,geometry:kn,material:Ht,group:Ln}=$e;if(Ht.side===fi&&qe.layers.test(J.layers)){let Ie=Ht.side;Ht.side=si,Ht.needsUpdate=!0,Rn(qe,it,J,kn,Ht,Ln),Ht.side=Ie,Ht.needsUpdate=!0,$t=!0}}$t===!0&&(ee.updateMultisampleRenderTarget(It),ee.updateRenderTargetMipmap(It))}L.setRenderTarget(Lt,Ft,qt),L.setClearColor(st,yt),Ae!==void 0&&(J.viewport=Ae),L.toneMapping=le}function Sn(I,q,it){let J=q.isScene===!0?q.overrideMaterial:null;for(let K=0,It=I.length;K<It;K++){let Ut=I[K],{object:Lt,geometry:Ft,group:qt}=Ut,le=Ut.material;le.allowOverride===!0&&J!==null&&(le=J),Lt.layers.test(it.layers)&&Rn(Lt,q,it,Ft,le,qt)}}function Rn(I,q,it,J,K,It){H!==null&&K.isNodeMaterial&&H.setObject(I,K),I.onBeforeRender(L,q,it,J,K,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),K.onBeforeRender(L,q,it,J,I,It),K.transparent===!0&&K.side===fi&&K.forceSinglePass===!1?(K.side=si,K.needsUpdate=!0,L.renderBufferDirect(it,q,J,K,I,It),K.side=nr,K.needsUpdate=!0,L.renderBufferDirect(it,q,J,K,I,It),K.side=fi):L.renderBufferDirect(it,q,J,K,I,It),I.onAfterRender(L,q,it,J,K,It)}function Cn(I){let q=0;for(let it of I)it.texture!==null&&q++;return q}function Hs(I,q,it){q.isScene!==!0&&(q=Bn);let J=Xt.get(I),K=S.state.lights,It=S.state.shadowsArray,Ut=K.state.version,Lt=ct.getParameters(I,K.state,It,q,it,S.state.lightProbeGridArray),Ft=ct.getProgramCacheKey(Lt),qt=J.programs;J.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?q.environment:null,J.fog=q.fog;let le=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;J.envMap=O.get(I.envMap||J.environment,le),J.envMapRotation=J.environment!==null&&I.envMap===null?q.environmentRotation:I.envMapRotation,qt===void 0&&(I.addEventListener("dispose",_e),qt=new Map,J.programs=qt,J.programVariants=new Map);let Ae=qt.get(Ft);if(Ae!==void 0){if(J.currentProgram===Ae&&J.lightsStateVersion===Ut)return Ol(I,Lt),Ae}else Lt.uniforms=ct.getUniforms(I),H!==null&&I.isNodeMaterial&&H.build(I,it,Lt),I.onBeforeCompile(Lt,L),Ae=ct.acquireProgram(Lt,Ft),qt.set(Ft,Ae),J.uniforms=Lt.uniforms;let $t=J.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&($t.clippingPlanes=at.uniform),Ol(I,Lt),J.needsLights=Hr(I),J.lightsStateVersion=Ut,J.needsLights&&($t.ambientLightColor.value=K.state.ambient,$t.lightProbe.value=K.state.probe,$t.sunLights.value=K.state.sun,$t.sunLightShadows.value=K.state.sunShadow,$t.directionalLights.value=K.state.directional,$t.directionalLightShadows.value=K.state.directionalShadow,$t.spotLights.value=K.state.spot,$t.spotLightShadows.value=K.state.spotShadow,$t.rectAreaLights.value=K.state.rectArea,$t.ltc_1.value=K.state.rectAreaLTC1,$t.ltc_2.value=K.state.rectAreaLTC2,$t.pointLights.value=K.state.point,$t.pointLightShadows.value=K.state.pointShadow,$t.hemisphereLights.value=K.state.hemi,$t.sunShadowMatrix.value=K.state.sunShadowMatrix,$t.sunShadowCascade.value=K.state.sunShadowCascade,$t.directionalShadowMatrix.value=K.state.directionalShadowMatrix,$t.spotLightMatrix.value=K.state.spotLightMatrix,$t.spotLightMap.value=K.state.spotLightMap,$t.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=Cn(S.state.lightProbeGridArray),J.currentProgram=Ae,J.uniformsList=null,Ae}function Wi(I,q,it,J,K){let It=Xt.get(I),Ut=It.currentProgram.id+","+J+","+K,Lt=It.programVariants.get(Ut);return Lt===void 0?(Lt=Hs(I,q,it),It.programVariants.set(Ut,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=J,It.toneMapping=K),Lt}function zr(I){if(I.uniformsList===null){let q=I.currentProgram.getUniforms();I.uniformsList=Ya.seqWithValue(q.seq,I.uniforms)}return I.uniformsList}function Ol(I,q){let it=Xt.get(I);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function Fl(I,q,it,J,K){q.isScene!==!0&&(q=Bn),ee.resetTextureUnits();let It=q.fog,Ut=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?q.environment:null,Lt=Q===null?L.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:Le.workingColorSpace,Ft=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,qt=O.get(J.envMap||Ut,Ft),le=J.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Ae=!!it.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),$t=!!it.morphAttributes.position,Re=!!it.morphAttributes.normal,yn=!!it.morphAttributes.color,$e=ir;J.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&($e=L.toneMapping);let qe=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,kn=qe!==void 0?qe.length:0,Ht=Xt.get(J),Ln=S.state.lights;if(sn===!0&&(Pn===!0||I!==j)){let Xe=I===j&&J.id===Y;at.setState(J,I,Xe)}let Ie=!1,fr=!1;J.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==Ln.state.version||K.isBatchedMesh&&Ht.batching===!1||!K.isBatchedMesh&&Ht.batching===!0||K.isBatchedMesh&&Ht.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ht.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ht.instancing===!1||!K.isInstancedMesh&&Ht.instancing===!0||K.isSkinnedMesh&&Ht.skinning===!1||!K.isSkinnedMesh&&Ht.skinning===!0||K.isInstancedMesh&&Ht.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ht.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ht.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ht.instancingMorph===!1&&K.morphTexture!==null||Ht.envMap!==qt||J.fog===!0&&Ht.fog!==It||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==at.numPlanes||Ht.numIntersection!==at.numIntersection)||Ht.vertexAlphas!==le||Ht.vertexTangents!==Ae||Ht.morphTargets!==$t||Ht.morphNormals!==Re||Ht.morphColors!==yn||Ht.morphTargetsCount!==kn||Ht.numLightProbeGrids!==Cn(S.state.lightProbeGridArray)?Ie=!0:(Ht.outputColorSpace!==Lt||Ht.toneMapping!==$e)&&(fr=!0):(Ie=!0,Ht.__version=J.version);let Dn=Ht.currentProgram;(Ie===!0||fr===!0)&&(Dn=fr===!0?Wi(J,q,K,Lt,$e):Hs(J,q,K),H&&J.isNodeMaterial&&H.onUpdateProgram(J,Dn,Ht));let ra=!1,Gs=!1,pr=!1,ve=Dn.getUniforms(),wn=Ht.uniforms;if(Ct.useProgram(Dn.program)&&(ra=!0,Gs=!0,pr=!0),J.id!==Y&&(Y=J.id,Gs=!0),ra||j!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),ve.setValue(W,"projectionMatrix",I.projectionMatrix),ve.setValue(W,"viewMatrix",I.matrixWorldInverse);let Nn=ve.map.cameraPosition;Nn!==void 0&&Nn.setValue(W,Xn.setFromMatrixPosition(I.matrixWorld)),me.logarithmicDepthBuffer&&ve.setValue(W,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&ve.setValue(W,"isOrthographic",I.isOrthographicCamera===!0),j!==I&&(j=I,Gs=!0,pr=!0)}if(Ht.needsLights&&(Ln.state.sunShadowMap.length>0&&ve.setValue(W,"sunShadowMap",Ln.state.sunShadowMap,ee),Ln.state.directionalShadowMap.length>0&&ve.setValue(W,"directionalShadowMap",Ln.state.directionalShadowMap,ee),Ln.state.spotShadowMap.length>0&&ve.setValue(W,"spotShadowMap",Ln.state.spotShadowMap,ee),Ln.state.pointShadowMap.length>0&&ve.setValue(W,"pointShadowMap",Ln.state.pointShadowMap,ee)),K.isSkinnedMesh){ve.setOptional(W,K,"bindMatrix"),ve.setOptional(W,K,"bindMatrixInverse");let Xe=K.skeleton;Xe&&(Xe.boneTexture===null&&Xe.computeBoneTexture(),ve.setValue(W,"boneTexture",Xe.boneTexture,ee))}K.isBatchedMesh&&(ve.setOptional(W,K,"batchingTexture"),ve.setValue(W,"batchingTexture",K._matricesTexture,ee),ve.setOptional(W,K,"batchingIdTexture"),ve.setValue(W,"batchingIdTexture",K._indirectTexture,ee),ve.setOptional(W,K,"batchingColorTexture"),K._colorsTexture!==null&&ve.setValue(W,"batchingColorTexture",K._colorsTexture,ee));let _i=it.morphAttributes;if((_i.position!==void 0||_i.normal!==void 0||_i.color!==void 0)&&lt.update(K,it,Dn),(Gs||Ht.receiveShadow!==K.receiveShadow)&&(Ht.receiveShadow=K.receiveShadow,ve.setValue(W,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&q.environment!==null&&(wn.envMapIntensity.value=q.environmentIntensity),wn.dfgLUT!==void 0&&(wn.dfgLUT.value=sP()),Gs){if(ve.setValue(W,"toneMappingExposure",L.toneMappingExposure),Ht.needsLights&&ia(wn,pr),It&&J.fog===!0&&St.refreshFogUniforms(wn,It),St.refreshMaterialUniforms(wn,J,At,Tt,S.state.transmissionRenderTarget[I.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let Xe=v,Nn=0;for(let ai of S.state.lightProbeGridArray)ai.texture!==null&&(Xe.textures[Nn]=ai.texture,Xe.min[Nn]=ai.boundingBox.min,Xe.max[Nn]=ai.boundingBox.max,Xe.resolution[Nn]=ai.resolution,Nn++);for(let ai in Xe)Xe[ai].length=Nn;wn.probesSH.value=Xe.textures,wn.probesMin.value=Xe.min,wn.probesMax.value=Xe.max,wn.probesResolution.value=Xe.resolution}Ya.upload(W,zr(Ht),wn,ee)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Ya.upload(W,zr(Ht),wn,ee),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&ve.setValue(W,"center",K.center),ve.setValue(W,"modelViewMatrix",K.modelViewMatrix),ve.setValue(W,"normalMatrix",K.normalMatrix),ve.setValue(W,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Xe=J.uniformsGroups;for(let Nn=0,ai=Xe.length;Nn<ai;Nn++){let wu=Xe[Nn];Zt.update(wu,Dn),Zt.bind(wu,Dn)}}return Dn}function ia(I,q){I.ambientLightColor.needsUpdate=q,I.lightProbe.needsUpdate=q,I.sunLights.needsUpdate=q,I.sunLightShadows.needsUpdate=q,I.directionalLights.needsUpdate=q,I.directionalLightShadows.needsUpdate=q,I.pointLights.needsUpdate=q,I.pointLightShadows.needsUpdate=q,I.spotLights.needsUpdate=q,I.spotLightShadows.needsUpdate=q,I.rectAreaLights.needsUpdate=q,I.hemisphereLights.needsUpdate=q}function Hr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(I,q,it){let J=Xt.get(I);J.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Xt.get(I.texture).__webglTexture=q,Xt.get(I.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:it,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,q){let it=Xt.get(I);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(I,q=0,it=0){Q=I,D=q,B=it;let J=null,K=!1,It=!1;if(I){let Lt=Xt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(W.FRAMEBUFFER,Lt.__webglFramebuffer),et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),Y=-1;return}else if(Lt.__webglFramebuffer===void 0)ee.setupRenderTarget(I);else if(Lt.__hasExternalTextures)ee.rebindTextures(I,Xt.get(I.texture).__webglTexture,Xt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let le=I.depthTexture;if(Lt.__boundDepthTexture!==le){if(le!==null&&Xt.has(le)&&(I.width!==le.image.width||I.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ee.setupDepthRenderbuffer(I)}}let Ft=I.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(It=!0);let qt=Xt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray(qt[q])?J=qt[q][it]:J=qt[q],K=!0):I.samples>0&&ee.useMultisampledRTT(I)===!1?J=Xt.get(I).__webglMultisampledFramebuffer:Array.isArray(qt)?J=qt[it]:J=qt,et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else et.copy(Yt).multiplyScalar(At).floor(),dt.copy(Se).multiplyScalar(At).floor(),ft=ye;if(it!==0&&(J=$),Ct.bindFramebuffer(W.FRAMEBUFFER,J)&&Ct.drawBuffers(I,J),Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),K){let Lt=Xt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+q,Lt.__webglTexture,it)}else if(It){let Lt=q;for(let Ft=0;Ft<I.textures.length;Ft++){let qt=Xt.get(I.textures[Ft]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Ft,qt.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Xt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Lt.__webglTexture,it)}Y=-1};function sa(I){let q=Xt.get(I);return(q.__readFormat!==I.format||q.__readType!==I.type)&&(q.__readFormat=I.format,q.__readType=I.type,q.__formatReadable=me.textureFormatReadable(I.format),q.__typeReadable=me.textureTypeReadable(I.type)),q}this.readRenderTargetPixels=function(I,q,it,J,K,It,Ut,Lt=0){if(!(I&&I.isWebGLRenderTarget)){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Xt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Ct.bindFramebuffer(W.FRAMEBUFFER,Ft);try{let qt=I.textures[Lt],le=qt.format,Ae=qt.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let $t=sa(qt);if($t.__formatReadable===!1){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($t.__typeReadable===!1){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=I.width-J&&it>=0&&it<=I.height-K&&W.readPixels(q,it,J,K,Mt.convert(le),Mt.convert(Ae),It)}finally{let qt=Q!==null?Xt.get(Q).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,qt)}}},this.readRenderTargetPixelsAsync=async function(I,q,it,J,K,It,Ut,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Xt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(q>=0&&q<=I.width-J&&it>=0&&it<=I.height-K){Ct.bindFramebuffer(W.FRAMEBUFFER,Ft);let qt=I.textures[Lt],le=qt.format,Ae=qt.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let $t=sa(qt);if($t.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($t.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Re=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,Re),W.bufferData(W.PIXEL_PACK_BUFFER,It.byteLength,W.STREAM_READ),W.readPixels(q,it,J,K,Mt.convert(le),Mt.convert(Ae),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let yn=Q!==null?Xt.get(Q).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,yn);let $e=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await J_(W,$e,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,Re),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,It),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(Re),W.deleteSync($e),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,q=null,it=0){let J=Math.pow(2,-it),K=Math.floor(I.image.width*J),It=Math.floor(I.image.height*J),Ut=q!==null?q.x:0,Lt=q!==null?q.y:0;ee.setTexture2D(I,0),W.copyTexSubImage2D(W.TEXTURE_2D,it,0,0,Ut,Lt,K,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,q,it=null,J=null,K=0,It=0){let Ut,Lt,Ft,qt,le,Ae,$t,Re,yn,$e=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ut=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Ft=it.isBox3?it.max.z-it.min.z:1,qt=it.min.x,le=it.min.y,Ae=it.isBox3?it.min.z:0;else{let ve=Math.pow(2,-K);Ut=Math.floor($e.width*ve),Lt=Math.floor($e.height*ve),I.isDataArrayTexture?Ft=$e.depth:I.isData3DTexture?Ft=Math.floor($e.depth*ve):Ft=1,qt=0,le=0,Ae=0}J!==null?($t=J.x,Re=J.y,yn=J.z):($t=0,Re=0,yn=0);let qe=Mt.convert(q.format),kn=Mt.convert(q.type),Ht;q.isData3DTexture?(ee.setTexture3D(q,0),Ht=W.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(ee.setTexture2DArray(q,0),Ht=W.TEXTURE_2D_ARRAY):(ee.setTexture2D(q,0),Ht=W.TEXTURE_2D),Ct.activeTexture(W.TEXTURE0),Ct.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,q.flipY),Ct.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ct.pixelStorei(W.UNPACK_ALIGNMENT,q.unpackAlignment);let Ln=Ct.getParameter(W.UNPACK_ROW_LENGTH),Ie=Ct.getParameter(W.UNPACK_IMAGE_HEIGHT),fr=Ct.getParameter(W.UNPACK_SKIP_PIXELS),Dn=Ct.getParameter(W.UNPACK_SKIP_ROWS),ra=Ct.getParameter(W.UNPACK_SKIP_IMAGES);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,$e.width),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,$e.height),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,qt),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,le),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,Ae);let Gs=I.isDataArrayTexture||I.isData3DTexture,pr=q.isDataArrayTexture||q.isData3DTexture;if(I.isDepthTexture){let ve=Xt.get(I),wn=Xt.get(q),_i=Xt.get(ve.__renderTarget),Xe=Xt.get(wn.__renderTarget);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,_i.__webglFramebuffer),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,Xe.__webglFramebuffer);for(let Nn=0;Nn<Ft;Nn++)Gs&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Xt.get(I).__webglTexture,K,Ae+Nn),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Xt.get(q).__webglTexture,It,yn+Nn)),W.blitFramebuffer(qt,le,qt+Ut,le+Lt,$t,Re,$t+Ut,Re+Lt,W.DEPTH_BUFFER_BIT,W.NEAREST);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if(K!==0||I.isRenderTargetTexture||Xt.has(I)){let ve=Xt.get(I),wn=Xt.get(q);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,P),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,z);for(let _i=0;_i<Ft;_i++)Gs?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ve.__webglTexture,K,Ae+_i):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ve.__webglTexture,K),pr?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,wn.__webglTexture,It,yn+_i):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,wn.__webglTexture,It),K!==0?W.blitFramebuffer(qt,le,qt+Ut,le+Lt,$t,Re,$t+Ut,Re+Lt,W.COLOR_BUFFER_BIT,W.NEAREST):pr?W.copyTexSubImage3D(Ht,It,$t,Re,yn+_i,qt,le,Ut,Lt):W.copyTexSubImage2D(Ht,It,$t,Re,qt,le,Ut,Lt);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else pr?I.isDataTexture||I.isData3DTexture?W.texSubImage3D(Ht,It,$t,Re,yn,Ut,Lt,Ft,qe,kn,$e.data):q.isCompressedArrayTexture?W.compressedTexSubImage3D(Ht,It,$t,Re,yn,Ut,Lt,Ft,qe,$e.data):W.texSubImage3D(Ht,It,$t,Re,yn,Ut,Lt,Ft,qe,kn,$e):I.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,It,$t,Re,Ut,Lt,qe,kn,$e.data):I.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,It,$t,Re,$e.width,$e.height,qe,$e.data):W.texSubImage2D(W.TEXTURE_2D,It,$t,Re,Ut,Lt,qe,kn,$e);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,Ln),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Ie),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,fr),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,Dn),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,ra),It===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&W.generateMipmap(Ht),Ct.unbindTexture()},this.initRenderTarget=function(I){Xt.get(I).__webglFramebuffer===void 0&&ee.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?ee.setTextureCube(I,0):I.isData3DTexture?ee.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?ee.setTexture2DArray(I,0):ee.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){D=0,B=0,Q=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return us}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Le._getDrawingBufferColorSpace(t),e.unpackColorSpace=Le._getUnpackColorSpace()}};var Dd={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Ot={},oP=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],Uy=matchMedia("(prefers-color-scheme: dark)");function Nd(){let n=M.theme==="dark"||M.theme==="auto"&&Uy.matches;document.documentElement.dataset.theme=n?"dark":"light",document.documentElement.style.setProperty("--text-size",String(jm()));let t=getComputedStyle(document.documentElement);for(let e of oP)Ot[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Ot.dark=n,Ot.curves=Dd[n?"dark":"light"].curves}function Ud(n){M.theme=n,Nd(),ut("theme")}var Oy="pieper-text-size";function jm(){let n=Number(localStorage.getItem(Oy));return n>=.5&&n<=3?n:1}function Fy(n){document.documentElement.style.setProperty("--text-size",String(n));try{localStorage.setItem(Oy,String(n))}catch{}ut("theme"),dispatchEvent(new Event("resize"))}Uy.addEventListener("change",()=>{M.theme==="auto"&&(Nd(),ut("theme"))});var By={type:"change"},Km={type:"start"},zy={type:"end"},Od=new Tr,ky=new ni,aP=Math.cos(70*ao.DEG2RAD),Vn=new G,ki=2*Math.PI,ze={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Jm=1e-6,Fd=class extends Sc{constructor(t,e=null){super(t,e),this.state=ze.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:io.ROTATE,MIDDLE:io.DOLLY,RIGHT:io.PAN},this.touches={ONE:so.ROTATE,TWO:so.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new hn,this._lastTargetPosition=new G,this._quat=new hn().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Va,this._sphericalDelta=new Va,this._scale=1,this._panOffset=new G,this._rotateStart=new Kt,this._rotateEnd=new Kt,this._rotateDelta=new Kt,this._panStart=new Kt,this._panEnd=new Kt,this._panDelta=new Kt,this._dollyStart=new Kt,this._dollyEnd=new Kt,this._dollyDelta=new Kt,this._dollyDirection=new G,this._mouse=new Kt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=cP.bind(this),this._onPointerDown=lP.bind(this),this._onPointerUp=uP.bind(this),this._onContextMenu=xP.bind(this),this._onMouseWheel=fP.bind(this),this._onKeyDown=pP.bind(this),this._onTouchStart=mP.bind(this),this._onTouchMove=gP.bind(this),this._onMouseDown=hP.bind(this),this._onMouseMove=dP.bind(this),this._interceptControlDown=_P.bind(this),this._interceptControlUp=yP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ze.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(By),this.update(),this.state=ze.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Vn.copy(e).sub(this.target),Vn.applyQuaternion(this._quat),this._spherical.setFromVector3(Vn),this.autoRotate&&this.state===ze.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ki:i>Math.PI&&(i-=ki),s<-Math.PI?s+=ki:s>Math.PI&&(s-=ki),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Vn.setFromSpherical(this._spherical),Vn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Vn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Vn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Vn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Od.origin.copy(this.object.position),Od.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Od.direction))<aP?this.object.lookAt(this.target):(ky.setFromNormalAndCoplanarPoint(this.object.up,this.target),Od.intersectPlane(ky,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Jm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Jm||this._lastTargetPosition.distanceToSquared(this.target)>Jm?(this.dispatchEvent(By),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ki/60*this.autoRotateSpeed*t:ki/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Vn.setFromMatrixColumn(e,0),Vn.multiplyScalar(-t),this._panOffset.add(Vn)}_panUp(t,e){this.screenSpacePanning===!0?Vn.setFromMatrixColumn(e,1):(Vn.setFromMatrixColumn(e,0),Vn.crossVectors(this.object.up,Vn)),Vn.multiplyScalar(t),this._panOffset.add(Vn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Vn.copy(s).sub(this.target);let r=Vn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ki*this._rotateDelta.x/e.clientHeight),this._rotateUp(ki*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ki*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ki*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ki*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ki*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ki*this._rotateDelta.x/e.clientHeight),this._rotateUp(ki*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Kt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function lP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function cP(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function uP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(zy),this.state=ze.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function hP(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case io.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=ze.DOLLY;break;case io.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ze.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ze.ROTATE}break;case io.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ze.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ze.PAN}break;default:this.state=ze.NONE}this.state!==ze.NONE&&this.dispatchEvent(Km)}function dP(n){switch(this.state){case ze.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case ze.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case ze.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function fP(n){this.enabled===!1||this.enableZoom===!1||this.state!==ze.NONE||(n.preventDefault(),this.dispatchEvent(Km),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(zy))}function pP(n){this.enabled!==!1&&this._handleKeyDown(n)}function mP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case so.ROTATE:if(this.enableRotate===!1){this.state=ze.NONE;break}this._handleTouchStartRotate(n),this.state=ze.TOUCH_ROTATE;break;case so.PAN:if(this.enablePan===!1){this.state=ze.NONE;break}this._handleTouchStartPan(n),this.state=ze.TOUCH_PAN;break;default:this.state=ze.NONE}break;case 2:switch(this.touches.TWO){case so.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=ze.TOUCH_DOLLY_PAN;break;case so.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=ze.TOUCH_DOLLY_ROTATE;break;default:this.state=ze.NONE}break;default:this.state=ze.NONE}this.state!==ze.NONE&&this.dispatchEvent(Km)}function gP(n){switch(this._trackPointer(n),this.state){case ze.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case ze.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case ze.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case ze.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=ze.NONE}}function xP(n){this.enabled!==!1&&n.preventDefault()}function _P(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function yP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Hy=[1,.75,.55,.42],vP=30,bP=17,MP=400,Gy=6e6;function Vy(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Bd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(Gy/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>vP&&this.level<Hy.length-1?this.level+=1:i<bP&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*Hy[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(Gy/this.area),.5))),this.draw()},MP)}};var qy=32,Xy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},fn=new lc,Pe=new Ei(qy,1,.01,100);Pe.up.set(0,0,1);var is,dn,ds,kd,Qm=!1,Yy=!1,eg=0;function xe(){Qm||!Yy||(Qm=!0,requestAnimationFrame(Zy))}function Zy(n=performance.now()){Qm=!1,kd.moving(n),ng()}var jy=[],zd=n=>jy.push(n);function ng(){for(let n of jy)n();is.render(fn,Pe),eg+=1}function Jy(){Yy=!0,xe()}function ja(n){return ng(),n(is.domElement)}var Ky=()=>eg,Qy=()=>!!kd?.software;fn.fog=new ac("#fff",1,10);function Wy(n){let t=document.createElement("canvas");t.width=ds.clientWidth||1,t.height=ds.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>SP.has(s)?i(s):null,e}var SP=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function tv(n){ds=n;let t=Wy(!1),e=Vy(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=Wy(!0)),is=new Pd({canvas:t.canvas,context:t}),is.debug.checkShaderErrors=!1,kd=new Bd(e,is,ng,i=>ut("hurry",i)),is.domElement.setAttribute("aria-hidden","true"),ds.append(is.domElement),dn=new Fd(Pe,is.domElement),dn.enableDamping=!1,dn.addEventListener("change",xe),dn.addEventListener("end",()=>{Ja=!sg(),ar=null}),new ResizeObserver(wP).observe(ds),ds.tabIndex=0,ds.setAttribute("role","application"),ds.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ds.addEventListener("keydown",EP)}function wP(){let n=ds.clientWidth,t=ds.clientHeight;!n||!t||(kd.resized(n,t),is.setSize(n,t),Pe.aspect=n/t,Pe.updateProjectionMatrix(),eg?Zy():xe(),AP()||Ka())}function EP(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)TP(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")$y(1/1.15);else if(n.key==="-")$y(1.15);else if(n.key.toLowerCase()==="f")Hd(Ho);else if(e)ig(e);else return;n.preventDefault()}function TP(n,t){let e=Pe.position.clone().sub(dn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Pe.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(dn.target),dn.update(),xe()}function $y(n){Pe.position.sub(dn.target).multiplyScalar(n).add(dn.target),dn.update(),xe()}var Ho=[[0,0,0],[0,0,1]];function ev(n,t){let e=new Fi().setFromPoints(n.map(u=>new G(...u))),i=e.getCenter(new G),s=new G(...t).normalize(),r=new G().crossVectors(Pe.up,s).normalize(),o=new G().crossVectors(s,r),a=Math.tan(ao.degToRad(qy/2))*.8,l=a*Pe.aspect,c=e.getSize(new G).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,_=-1/0;for(let m of n){let g=new G(...m).sub(i),x=g.dot(r),T=g.dot(o),v=g.dot(s);h=Math.max(h,v+Math.abs(x)/l,v+Math.abs(T)/a),d=Math.min(d,T),f=Math.max(f,T),p=Math.min(p,x),_=Math.max(_,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+_)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var tg=0;function Oc({target:n,position:t},e=.35){let i={t:dn.target.clone(),p:Pe.position.clone()},s=performance.now(),r=++tg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==tg)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);dn.target.lerpVectors(i.t,n,u),Pe.position.lerpVectors(i.p,t,u);let h=Pe.position.distanceTo(dn.target);Pe.near=h/100,Pe.far=h*30,fn.fog.near=h*1.3,fn.fog.far=h*3.4,Pe.updateProjectionMatrix(),dn.update(),xe(),c<1&&requestAnimationFrame(a)})(s)}function Hd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){Ho=n,i||(ar=null),Ja=!1;let s=e?Xy[e]:Pe.position.clone().sub(dn.target).toArray();Oc(ev(n,s),t?0:.35)}function ig(n){Ja=!1,ar=null,Oc(ev(Ho,Xy[n]))}var Ja=!1;function sg(){Pe.updateMatrixWorld();let n=new G;return Ho.every(t=>(n.set(...t).project(Pe),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Ka(){Ja||!dn.enabled||!Ho.length||sg()||(ar??={position:Pe.position.clone(),target:dn.target.clone()},Hd(Ho,{byItself:!0}))}var ar=null;function nv(){if(!ar||Ja||!dn.enabled)return;let n=ar;ar=null,Oc(n),setTimeout(Ka,500)}function AP(){if(!ar||Ja||!dn.enabled)return!1;let n={position:Pe.position.clone(),target:dn.target.clone()},t=ar,e=({position:s,target:r})=>{Pe.position.copy(s),dn.target.copy(r),Pe.lookAt(r)};e(t);let i=sg();return e(n),i?(ar=null,Oc(t,0),!0):!1}var rg=n=>{Ho=n},Qa=()=>[...Pe.position.toArray(),...dn.target.toArray()].map(n=>Number(n.toPrecision(5)));function iv(n){tg+=1,Oc({position:new G(...n.slice(0,3)),target:new G(...n.slice(3))},0)}var or=null,og={cell:.1};function ag(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;og.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new te(Ot.gridFine),l=new te(Ot.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}or?.geometry.dispose();let c=new Te;c.setAttribute("position",new Ee(r,3)),c.setAttribute("color",new Ee(o,3)),or?or.geometry=c:(or=new Do(c,new Qi({vertexColors:!0})),or.renderOrder=-2,or.material.depthWrite=!1,fn.add(or)),or.userData.reach=n,xe()}function lg(){fn.background=new te(Ot.ground),fn.fog.color.set(Ot.ground),or&&ag(or.userData.reach),xe()}function zi(n){Pe.updateMatrixWorld();let t=new G(...n).project(Pe),e=ds.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Gd(n){let t=n.joints.length,e=li(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function cg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=wp(n,t),u=(d,f,p,_=!0,m=p)=>{Di(Li(f,d))<=l||(s.rods.push({a:d,b:f,r:p,far:m}),_&&s.balls.push({at:f,r:m}))};a&&(s.pedestal={at:Qt(t[0]),dir:Xs(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:p},_)=>{let m=r[_],g=n.joints[_],x=Qt(t[_]),T=Qt(t[_+1]),v=m*.62,A=m*.84,S=(r[_+1]??e.rest)*.62,y=(r[_-1]??m)*.84;if(n.convention==="standard"){let z=Vl(x,f,Gl(Li(T,x),f));u(x,z,v),u(z,T,A,!0,S)}else u(x,d,y,!0,v),u(d,T,v);let w=d,U=Gl(Li(T,d),f);h&&Di(Li(d,h.at))<.5*m&&Math.abs(U)>l?w=Vl(d,f,Math.sign(U)*Math.min(Math.abs(U)*.55,h.r+m*1.15)):_===0&&Math.abs(U)>2.2*m&&(w=Vl(d,f,Math.sign(U)*m*1.25));let L=m*2.15,N=Xs(t[_+1],0),H=!!(i&&Fc(g,i[_])),$=Xs(t[0],2),P=Gl(Li(w,Qt(t[0])),$)-L/2;_===0&&g.type==="R"&&Math.abs(Gl(f,$))>.99&&P<0&&P>-L&&(w=Vl(w,$,-P)),g.type==="R"?s.drums.push({at:w,dir:f,x:p,turned:N,r:m,h:L,beyond:H,joint:_}):s.sleeves.push({at:w,dir:f,x:p,r:m*.95,h:m*3.4,beyond:H,joint:_}),h={at:d,r:m}}),a){let d=t[a+1],f=Qt(t[a]);s.flange={at:f,dir:Xs(t[a],2),turned:Xs(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,Qt(d),e.rest*.34,!1),s.tip={at:Qt(d),r:e.rest*.42}}return s}function Fc(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function Bc(n,t){let e=Gd(n).radius[0]??.05,i=Qt(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(Qt)];for(let{point:r}of wp(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function CP(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new xc(s.map(([a,l])=>new Kt(a,l)),n):new Ai(1,1,1,n),o={rod:i(new Ai(1,1,1,n,1,!0)),ball:t>3?new Rs(1,n,t):new _c(1,0),drum:i(r),box:new Bi(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var sv=new Map,fg=(n,t)=>sv.get(n)??sv.set(n,CP(n,t)).get(n),PP=()=>fg(26,12),ug=()=>fg(11,5),rv=()=>fg(6,3),kc=class{constructor(t){this.mesh=new Ye(new Te,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Te,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new ke(c,l).setUsage(Ed);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new ke(o,1).setUsage(Ed)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let p=t.at[d+2]>0?c:a,_=p*t.at[d],m=p*t.at[d+1],g=l*t.at[d+2],x=t.normal[d]/a,T=t.normal[d+1]/a,v=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*_+r[A]*m+o[A]*g,this.normal[f+A]=s[A]*x+r[A]*T+o[A]*v}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},ov=[1,0,0],IP=[0,1,0],av=[0,0,1];function LP(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Au(n,Math.abs(n[2])<.9?av:ov),i=Au(n,e),s=Di(i)||1,r=i.map(o=>o/s);return[Au(r,n),r]}var Vd=0,Wd=1,hg=2,dg=3,tl=class{constructor(t,{shadow:e=null,veil:i=!1,rim:s=null}={}){this.group=new An,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new kc(t),this.group.add(this.body.mesh),s&&(this.rim=new kc(s),this.rim.mesh.renderOrder=1,this.group.add(this.rim.mesh)),e&&(this.flat=new kc(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?rv:ug:this.moving?ug:PP;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),this.rim){this.rim.clear();for(let i of this.seen?t:[])this.#t(this.rim,i,e(),{rim:!0});this.rim.done()}if(this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?rv():ug(),{flat:!0});this.flat.done()}}#t(t,e,i,{flat:s=!1,rim:r=!1}={}){let o=this.rim&&!r?e.rim:0,a=!this.veil&&!s,l=f=>this.veil?Math.max(.96*f-o,.3*f):f,c=f=>2*l(f/2),u=f=>this.veil?e.outside?dg:Vd:f,h=(f,p,_,m,g,x,T,v)=>t.put(f,u(p),_,...LP(m,T),m,g,x,v),d=(f,p,_)=>t.put(i.ball,u(f),p,ov,IP,av,_,_);for(let{a:f,b:p,r:_,far:m}of e.rods){let g=Li(p,f),x=Di(g),T=[(f[0]+p[0])/2,(f[1]+p[1])/2,(f[2]+p[2])/2];h(i.rod,Vd,T,g.map(v=>v/x),l(_),x,null,l(m??_))}for(let{at:f,r:p}of e.balls)d(Vd,f,l(p));for(let{at:f,dir:p,turned:_,r:m,h:g,beyond:x}of e.drums){if(h(i.drum,x&&a?dg:Wd,f,p,l(m),c(g)),!a)continue;h(i.rod,hg,f,p,m*1.012,g*.13);let T=[0,1,2].map(v=>f[v]+_[v]*m*.96);h(i.box,Vd,T,p,m*.11,g*.86,_)}for(let{at:f,dir:p,x:_,r:m,h:g,beyond:x}of e.sleeves)h(i.box,x&&a?dg:Wd,f,p,l(m),c(g),_);if(e.pedestal&&!this.veil){let{at:f,dir:p,r:_,h:m}=e.pedestal;h(i.drum,Wd,[f[0]+p[0]*m/2,f[1]+p[1]*m/2,f[2]+p[2]*m/2],p,_,m)}if(e.flange&&h(i.drum,Wd,e.flange.at,e.flange.dir,l(e.flange.r),c(e.flange.h)),e.flange&&a){let{at:f,dir:p,turned:_,r:m,h:g}=e.flange;h(i.box,hg,[0,1,2].map(x=>f[x]+_[x]*m*.95),p,m*.16,g*1.04,_)}e.tip&&a&&d(hg,e.tip.at,e.tip.r)}};var DP=`
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
  }`,lv=`
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
  }`,NP=`
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
  }`,UP=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function $d({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new di({vertexShader:e?NP:DP,fragmentShader:e?UP:lv,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new te)},opacity:{value:n},gloss:{value:t},sky:{value:new te(.46,.46,.47)},ground:{value:new te(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function cv(){let n=new di({vertexShader:`
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
      }`,side:si,transparent:!0,depthWrite:!1,uniforms:{colours:{value:[new te,new te]}}});return n.repaint=(...t)=>t.forEach((e,i)=>n.uniforms.colours.value[i].set(e)),n}function uv(n){let t=new di({vertexShader:`
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
      }`,fragmentShader:lv.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?nr:fi,uniforms:{colour:{value:new te},opacity:{value:1},gloss:{value:.14},sky:{value:new te},ground:{value:new te}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function pg(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Te;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,u),c+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=hv(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let _=0;_<o[u].length;++_)f.push(o[u][_][d]);let p=hv(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(p)}}}return l}function hv(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new ke(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let _=u.getComponent(d,p);a.setComponent(d+h,p,_)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var OP=Array.from({length:12},(n,t)=>[Math.cos(t*Math.PI/6),Math.sin(t*Math.PI/6)]),FP=[.75,1.5,2.4],dv=2,qd=4,el=b("div",{class:"labels","aria-hidden":"true"}),zc=new Map,lo=null;function pv(n,t){let e=zc.get(n)??[],i=t.map(({text:s,at:r,wish:o},a)=>{let l=e[a]??{el:el.appendChild(b("span",{class:"label"})),stands:null};return l.text!==s&&(l.text=l.el.textContent=s,l.width=null),Object.assign(l,{at:r,wish:o})});for(let s of e.slice(t.length))s.el.remove();zc.set(n,i),xe()}function mv(n){n.prepend(el),zd(BP),nt("theme",()=>{for(let t of[...zc.values()].flat())t.width=null;lo=null}),new ResizeObserver(([t])=>{lo=[t.contentRect.width,t.contentRect.height],xe()}).observe(el)}var Xd=new G;function gv(n){return Xd.set(...n).project(Pe),Xd.z<1?[(Xd.x+1)/2*lo[0],(1-Xd.y)/2*lo[1]]:null}var fv=(n,t)=>Math.max(0,Math.min(n[2],t[2])-Math.max(n[0],t[0]))*Math.max(0,Math.min(n[3],t[3])-Math.max(n[1],t[1]));function BP(){lo??=[el.clientWidth,el.clientHeight],Pe.updateMatrixWorld();let n=[...zc.values()].flat();for(let i of n)i.point=gv(i.at),i.width===null&&(i.width=i.el.offsetWidth,i.height=i.el.offsetHeight);let t=n.filter(i=>i.point).map(({point:[i,s]})=>[i-qd,s-qd,i+qd,s+qd]),e=[];for(let i of n){let s=i.point&&kP(i,e,t);if(i.box=s?s.box:null,i.stands=s?s.key:null,i.el.hidden=!s,!s)continue;e.push(s.box.map((o,a)=>o+(a<2?-dv:dv)));let r=`translate(${Math.round(s.box[0])}px, ${Math.round(s.box[1])}px)`;r!==i.where&&i.el.style.setProperty("transform",i.where=r)}}function kP({point:n,width:t,height:e,wish:i,stands:s},r,o){let[a,l]=n;if(a<0||l<0||a>lo[0]||l>lo[1])return null;let c=i&&gv(i),u=c&&Math.hypot(c[0]-a,c[1]-l)||1,h=c?[(c[0]-a)/u,(c[1]-l)/u]:[0,-1],d=null;return FP.forEach((f,p)=>{OP.forEach(([_,m],g)=>{let x=a+_*(f*e+t/2),T=l+m*f*e*1.35,v=[x-t/2,T-e/2,x+t/2,T+e/2],A=t*e-fv(v,[0,0,...lo]),S=[...r,...o].reduce((U,L)=>U+fv(v,L),A),y=`${p}.${g}`,w=100*S+2*p+(1-_*h[0]-m*h[1])-(y===s?.8:0);(!d||w<d.cost)&&(d={cost:w,box:v,key:y})})}),d}var mg=()=>[...zc.values()].flat().map(({text:n,box:t,point:e})=>({text:n,box:t,point:e}));function xv(n,t){let e=getComputedStyle(el);n.font=`600 ${parseFloat(e.fontSize)*t}px ${e.fontFamily}`,Object.assign(n,{textAlign:"center",textBaseline:"middle",lineJoin:"round",lineWidth:4*t}),n.strokeStyle=Ot.ground,n.fillStyle=Ot.ink;for(let{text:i,box:s}of mg()){if(!s)continue;let r=[(s[0]+s[2])/2*t,(s[1]+s[3])/2*t];n.strokeText(i,...r),n.fillText(i,...r)}}var Lr=Dd.axes;function gg(n,t){let e=new Ai(.028,.028,.82,8).translate(0,.41,0),i=new Uo(.085,.22,12).translate(0,.9,0),s=pg([e,i]).applyMatrix4(t),r=new te(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new ke(o,3)),s}var xg=n=>new ge().makeRotationFromQuaternion(new hn().setFromUnitVectors(new G(0,1,0),new G(...n))),HP=pg([gg(Lr[0],xg([1,0,0])),gg(Lr[1],xg([0,1,0])),gg(Lr[2],xg([0,0,1]))]),nl=class{constructor(){this.group=new An,this.mesh=new dc(HP,new ii({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.group.add(this.mesh)}show(t,e,i=[]){this.last=[t,e];let s=new ge;this.mesh.count=t.length,t.forEach(({T:o},a)=>this.mesh.setMatrixAt(a,s.set(...o).scale(new G(e,e,e))));let r=(o,a)=>o[a+3]-e*.4*(o[a]+o[a+1]+o[a+2]);pv(this,[...t.map(({T:o,name:a})=>({text:a,at:[o[3],o[7],o[11]],wish:[0,4,8].map(l=>r(o,l))})),...i]),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}};var yg=180/Math.PI,Hi={angle:"deg",length:"mm"},GP={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},_g={deg:yg,rad:1,mm:1e3,m:1},VP={deg:2,rad:4,mm:2,m:5},WP={deg:1,rad:.02,mm:5,m:.005},gt={get angle(){return Hi.angle},get length(){return Hi.length},set(n,t){t in _g&&n in Hi&&(Hi[n]=t)},factor:n=>n in Hi?_g[Hi[n]]:1,symbol:n=>n in Hi?GP[Hi[n]]:"",digits:n=>n in Hi?VP[Hi[n]]:4,step:n=>n in Hi?WP[Hi[n]]/_g[Hi[n]]:.01,suffix:n=>n==="angle"?{deg:yg,"\xB0":yg,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ti(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var pn=(n,t,e=gt.digits(t))=>ti(n*gt.factor(t),e),ue=(n,t,e)=>`${pn(n,t,e)}${t==="angle"&&Hi.angle==="deg"?"":" "}${gt.symbol(t)}`,Hc=(n,t="plain")=>String(Number((n*gt.factor(t)).toPrecision(9))+0),Yd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function il(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||gt.digits(t))/gt.factor(t)}var $P={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},qP={theta:(n,t,e)=>`turn by \u03B8${n} = ${ue(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${ue(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${ue(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${ue(t,"angle")} about x`};function _v(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=$P[n.convention],o=gr(n.joints[i],xr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:Ex(n.convention,a.a,a.alpha,a.d,a.theta)}}function yv(){let n=b("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>b("button",{type:"button",text:o,"aria-label":a,on:{click:()=>i(l())}}),e=()=>4*M.table.joints.length-1,i=o=>{M.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ut("frames")},s=b("details",{class:"fold","data-testid":"dh-steps"},b("summary",{text:"The frames, one step at a time"}),b("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(M.dhStep??1)-1),t("On","One step on",()=>(M.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(M.dhStep===null||!M.table.joints.length){M.dhStep=null,bt(n,"");return}M.dhStep=Math.min(M.dhStep,e());let{i:o,key:a,value:l}=_v(M.table,M.q,M.dhStep),c=M.table.convention==="standard"?o:o+1;bt(n,`Joint ${o+1}, ${M.dhStep%4+1} of 4: ${qP[a](o+1,l,c)}`)};return nt(["q","table","units"],()=>M.dhStep!==null&&r()),nt("panel",o=>{o!=="table"&&M.dhStep!==null&&(s.open=!1,i(null))}),s}function Zd(){let{i:n,A:t}=_v(M.table,M.q,M.dhStep);return[...M.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:zn(M.frames[n],t),name:`\u2192 ${n+1}`}]}var vg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],sl=n=>[Math.cos(n),Math.sin(n)];function XP([n,t,e]){let[i,s]=sl(e),[r,o]=sl(t),[a,l]=sl(n);return vg([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function YP(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function ZP([n,t,e]){let[i,s]=sl(n),[r,o]=sl(t),[a,l]=sl(e);return vg([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function jP(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function jd(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function Gc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return vg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function JP(n){let[t,e,i,s]=jd(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function KP([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:Gc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Ls={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:YP,from:XP},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:jP,from:ZP},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:JP,from:KP},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:jd,from:Gc}};function vv(n,t,e){let i=Ls[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Jd(n,t,e){let i=jd(n),s=jd(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=Gc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var rl=.145,tf=.105,Rg=.165,bv={mouse:13,pen:16,touch:28},QP=.2,ho=["x","y","z"],Wc=72,Go=new An,Qd=new Map,wg="both",ef="local",Cg=0,Dr=!1,Eg=null,Qe=null,nf=()=>Qe!==null,Tv=()=>Dr,co=null,uo=null;function Av(){Go.visible=!1,fn.add(Go),zd(Pg),uo=document.getElementById("view"),co=b("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(co),uo.addEventListener("pointerdown",oI,!0),uo.addEventListener("pointermove",lI,!0);for(let n of["pointerup","pointercancel"])uo.addEventListener(n,Uv,!0);addEventListener("keydown",n=>n.key==="Escape"&&Qe&&uI()),nt(["target","theme"],xe)}function Vc(n,t,e=8){let i=new ii({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new Ye(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var tI=[new hn().setFromUnitVectors(new G(0,1,0),new G(1,0,0)),new hn,new hn().setFromUnitVectors(new G(0,1,0),new G(0,0,1))],eI=[new hn().setFromUnitVectors(new G(0,0,1),new G(1,0,0)),new hn().setFromUnitVectors(new G(0,0,1),new G(0,1,0)),new hn];function nI(){if(Qd.size)return;let n=(t,e)=>{Qd.set(t,e),Go.add(e)};ho.forEach((t,e)=>{let i=new Ai(.0032,.0032,rl*.8,8).translate(0,rl*.45,0),s=new Uo(.0125,.034,14).translate(0,rl*.9,0),r=new An;r.add(Vc(i,Lr[e]),Vc(s,Lr[e])),r.userData.turn=tI[e],n(`move-${t}`,r);let o=Vc(new Ha(tf,.0026,6,Wc),Lr[e],7);o.userData.turn=eI[e],n(`turn-${t}`,o)}),n("turn-view",Vc(new Ha(Rg,.0022,6,Wc),"#8891a0",7)),n("move-view",Vc(new Rs(.0115,14,10),"#8891a0",9))}var Kd=new G,fo=new G,bg=new hn;function sf(){return 2*Math.tan(ao.degToRad(Pe.fov/2))*Pe.position.distanceTo(Kd)}var qc=()=>ef==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):iI(),iI=()=>[0,1,2].map(n=>Xs(M.target,n)),sI=new ge;function Pg(){if(Go.visible=Dr,!Dr)return;Kd.set(...Qt(M.target)),fo.copy(Pe.position).sub(Kd).normalize(),ef==="world"?bg.identity():bg.setFromRotationMatrix(sI.set(...M.target)),Go.position.copy(Kd),Go.scale.setScalar(sf());let n=qc();for(let[t,e]of Qd){let[i,s]=t.split("-"),r=ho.indexOf(s),o=wg==="both"||wg===i;e.visible=o&&rI(i,n[r])&&(!Qe||Qe.name===t),s==="view"?e.quaternion.copy(Pe.quaternion):e.quaternion.copy(bg).multiply(e.userData.turn);let a=t===(Qe?.name??Eg);e.traverse(l=>l.material?.color.set(a?Ot.accent:l.userData.colour))}}function rI(n,t){return!t||n!=="move"?!0:Math.hypot(...Rv(t,fo.toArray()))>QP}var Rv=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],$c=(n,t)=>Qt(M.target).map((e,i)=>e+t*n[i]);function Tg(n,t){let e=qc(),[i,s]=n<0?[Mv(Pe.matrixWorld,0),Mv(Pe.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Wc+1},(r,o)=>{let a=2*Math.PI*o/Wc,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:$c(l,t),front:n<0||l.reduce((c,u,h)=>c+u*fo.getComponent(h),0)>-.15}})}var Mv=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function Sv(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function Ag(n,t){let e=sf(),i=[];for(let[s,r]of Qd){if(!r.visible)continue;let[o,a]=s.split("-"),l=ho.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=zi(Qt(M.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=qc()[l],h=zi($c(u,.92*rl*e));c=Math.min(Sv(n,t,zi($c(u,.3*rl*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Tg(l,(l<0?Rg:tf)*e).map(h=>({...h,s:zi(h.p)}));for(let h=0;h<Wc;h++)u[h].front&&(c=Math.min(c,Sv(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Cv(n){if(!Dr)return null;Pg();let[t]=Ag(n.clientX,n.clientY);return t&&t[1]<=(bv[n.pointerType]??bv.mouse)?t[0]:null}function Pv(){if(!Dr)return{};Pg();let n=sf(),t=qc(),e={"move-view":zi(Qt(M.target))};return ho.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>zi($c(t[s],c*rl*n))).find(([c,u])=>Ag(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=Tg(s,tf*n).filter(c=>c.front).map(c=>zi(c.p)).filter(([c,u])=>Ag(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=zi(Tg(-1,Rg*n)[9].p),e}var wv=new Mc,Ev=new Kt;function Iv(n){let t=is.domElement.getBoundingClientRect();return Ev.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),wv.setFromCamera(Ev,Pe),wv.ray}function Lv(n,t,e){let{origin:i,direction:s}=Iv(e),r=new G(...n),o=new G(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function Dv(n,t,e){let i=new ni().setFromNormalAndCoplanarPoint(n,new G(...t));return Iv(e).intersectPlane(i,new G)}function oI(n){if(n.button!==0)return;let t=Cv(n);if(!t)return;n.stopPropagation(),n.preventDefault(),uo.focus({preventScroll:!0}),uo.setPointerCapture(n.pointerId),dn.enabled=!1;let[e,i]=t.split("-"),s=ho.indexOf(i),r=s<0?fo.toArray():qc()[s].slice();Qe={name:t,what:e,axis:r,i:s,T:M.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},Qe.start=e==="turn"?Nv(n):s<0?Dv(fo,Qt(Qe.T),n):Lv(r,Qt(Qe.T),n),xe()}function Nv(n){let[t,e]=zi(Qt(Qe.T)),i=Qe.axis.reduce((h,d,f)=>h+d*fo.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Rv(Qe.axis,fo.toArray()),r=sf(),o=zi(Qt(Qe.T)),a=zi($c(s,tf*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-Qe.x)*l+(n.clientY-Qe.y)*c)/(u*u)}var aI=n=>Math.atan2(Math.sin(n),Math.cos(n)),Mg=(n,t,e)=>{let i=Cg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function lI(n){if(!Qe){if(n.buttons||!Dr)return;let l=Cv(n);l!==Eg&&(Eg=l,uo.style.setProperty("cursor",l?"grab":""),xe());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=Qe,r=ef==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Nv(n);Qe.total+=aI(l-(Qe.before??Qe.start)),Qe.before=l;let c=Mg(Qe.total,n,Math.PI/180),u=Math.sin(c/2);o=zn(Gc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${Sg(c,"angle")} about ${s<0?"the line of sight":r+ho[s]}`}else if(s<0){let l=Dv(fo,Qt(t),n);if(!l)return;let c=l.sub(Qe.start);(Cg||n.shiftKey)&&c.set(...c.toArray().map(u=>Mg(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${ho[h]} ${Sg(u,"length")}`).join(", ")}else{let l=Mg(Lv(e,Qt(t),n)-Qe.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${Sg(l,"length")} along ${r}${ho[s]}`}Mi(o,"drag"),cI(a,n),xe()}var Sg=(n,t)=>`${n>=0?"+":""}${ue(n,t,gt.digits(t))}`;function cI(n,t){let e=uo.getBoundingClientRect();co.hidden=!1,bt(co,n),co.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-co.offsetWidth-8)}px`),co.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Uv(n){Qe&&(n.stopPropagation(),Qe=null,co.hidden=!0,dn.enabled=!0,Mi(M.target,"dropped"),xe())}function uI(){let{T:n}=Qe;Mi(n,"drag"),Uv({stopPropagation(){}})}function Ov(){Dr&&nI(),Go.visible=Dr,ut("frames"),xe()}function Fv(n){Dr=n,Ov()}function Bv(n){wg=n,Ov()}function kv(n){ef=n,xe()}function zv(n){Cg=n}var $v=$d(),Gv=[.32,-.4,1],af=new ii({color:"#000",transparent:!0,opacity:.1,side:fi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Tm,stencilRef:1,stencilZPass:Em,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),Dg=new ge().set(1,0,-Gv[0],0,0,1,-Gv[1],0,0,0,0,5e-4,0,0,0,1),ol=new Ye(new gc(1,40),new di({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));ol.renderOrder=-1;function hI(){let n=M.frames[0],t=2*(Ds.radius[0]??0);ol.visible=M.table.joints.length>0&&Math.abs(n[11])<.02*Ds.size&&n[10]>.99,ol.position.set(n[3],n[7],4e-4*Ds.size),ol.scale.set(1.6*t,1.6*t,1)}var jc=new tl($v,{shadow:{material:af,matrix:Dg}});function qv(n,t){jc.shown(n,n&&!t)}var Xv=$d({opacity:.1,veil:!0}),Yv=cv(),Yc=new tl(Xv,{veil:!0,rim:Yv}),Zv=$d({opacity:.62,gloss:.1}),Lg=new tl(Zv,{veil:!0}),Ng=new nl,Ds=Gd(M.table),lf=[],of=null;function jv(){fn.add(ol,jc.group,Yc.group,Lg.group,Ng.group),Yc.group.renderOrder=1,nt("table",n=>{Ds=Gd(M.table),ag(Ds.size),lf=[],of=null,Ug(),uf(),n==="new"&&Jc({instant:!0,view:"iso"}),Jy()}),nt("q",fI),nt("frames",Qv),nt("theme",Wv),nt("hurry",n=>{for(let t of[jc,Yc,Lg])t.hurry(n)}),Wv()}var Vv=new Map,Zc=[],Ig=0;function Ur(n,t){if(Vv.set(n,t),Zc=[...Vv.values()].flat(),!M.table.joints.length)return;let e=Ig;Ig=Zc.length,rg([...Bc(M.table,M.frames),...Zc]),t.length?Kv():e>Ig&&dI()}var dI=js(nv,120);function Jv(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Ur("motion",i.flatMap(s=>Bc(n,Ms(n,s))))}function Jc(n){Hd([...Bc(M.table,M.frames),...Zc],n)}var Kv=js(Ka,220);function fI(){let n=M.frames;jc.show(M.table.joints.length?[cg(M.table,n,Ds,M.q)]:[]),hI(),rg([...Bc(M.table,n),...Zc]),Kv(),ob&&mI(Qt(n[n.length-1])),Qv()}function Qv(){let n=(M.shownFrames??[]).filter(t=>t<M.frames.length&&!(t===M.frames.length-1&&Tv())).map(t=>({T:M.frames[t],name:cf(t)}));Ng.show(M.dhStep===null?n:Zd(),Ds.size*.13),xe()}var tb=()=>jc.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),eb=()=>(Ng.last?.[0]??[]).map(n=>n.name);function cf(n){let t=M.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function nb(n){lf=n,Ug()}function fs(n){of=n,Ug()}var ib=()=>lf.length,sb=()=>Yc.arms.filter(n=>n.outside).length,pI=.0035;function Ug(){let n=t=>({...cg(M.table,Ms(M.table,t),Ds),outside:M.table.joints.some((e,i)=>Fc(e,t[i])),rim:pI*Ds.size});Yc.show(lf.map(n)),Lg.show(of?[n(of)]:[]),xe()}var rb=6e3,rf=new Float32Array(6*rb),Nr=new Do(new Te,new Qi({fog:!1}));Nr.geometry.setAttribute("position",new ke(rf,3));Nr.frustumCulled=!1;Nr.visible=!1;var po=0,ob=!0,Xc=null;fn.add(Nr);function mI(n){let t=Xc?Di(Li(n,Xc)):1/0;t<Ds.size*.002||(t<Ds.size*.2&&(po===rb&&(rf.copyWithin(0,6*1e3),po-=1e3),rf.set(Xc,6*po),rf.set(n,6*po+3),po+=1,Nr.geometry.setDrawRange(0,2*po),Nr.geometry.attributes.position.needsUpdate=!0,Nr.visible=!0),Xc=n)}function ab(n){ob=n,n||uf(),xe()}function uf(){po=0,Xc=null,Nr.visible=!1,xe()}var lb=()=>po,Kc=new tr(new Te,new Qi({fog:!1}));Kc.frustumCulled=!1;var Qc=new Ar(new Te,new er({size:4,sizeAttenuation:!1,fog:!1}));Qc.frustumCulled=!1;Kc.visible=Qc.visible=!1;fn.add(Kc,Qc);function Vo(n){Ur("path",n);let t=new Float32Array(n.flat());for(let e of[Kc,Qc])e.geometry.dispose(),e.geometry=new Te,e.geometry.setAttribute("position",new ke(t,3)),e.visible=n.length>0;xe()}function Wv(){$v.repaint(Ot.link,Ot.joint,Ot.accent,Ot.dark,Ot.wrong),Xv.repaint(Ot.ghost,Ot.ghost,Ot.ghost,Ot.dark,Ot.wrong),Yv.repaint(Ot.ghost,Ot.wrong),Zv.repaint(Ot.accent,Ot.accent,Ot.accent,Ot.dark),Nr.material.color.set(Ot.accent),Kc.material.color.set(Ot.trace),Qc.material.color.set(Ot.trace),af.opacity=Ot.dark?.28:.11,ol.material.uniforms.strength.value=Ot.dark?.75:.34,xe()}var he={follow:!0,ghosts:"all",task:null,redundancy:null},Og={answers:0},hf=!1,cb=Ys(async()=>{let n=hf;hf=!1;let t=M.target,e=M.table;try{let i=nf()||Fg,s=i?null:M.digits,{task:r,redundancy:o}=he,a=await Oe("ik",{T:t,q:M.q,brief:i,task:r,redundancy:o,digits:s});if(e!==M.table||t!==M.target&&!i)return;Og.answers+=1,M.solutions={...a,T:t,brief:i},n&&he.follow&&a.nearest&&Ni(a.nearest,"follow"),al(),ut("solutions"),!i&&!a.rows.some(l=>l.inside)&&_I(t),a.self_motions===null&&!i&&xI(M.solutions)}catch(i){if(i instanceof Lu)return;M.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},al(),ut("solutions")}}),Fg=!1;function ub(){Fg=!0,hf=!0,cb()}function Ns({follow:n=!1}={}){Fg=!1,hf||=n,cb()}var xI=Ys(async n=>{try{let t={T:n.T,q:M.q,task:he.task,redundancy:he.redundancy},{self_motions:e}=await Oe("self_motions",t);if(M.solutions!==n||!e)return;n.self_motions=e,ut("solutions")}catch{}}),_I=Ys(async n=>{try{let t=await Oe("nearest",{T:n,task:he.task});M.solutions&&M.solutions.T===n&&(M.solutions.near=t,ut("solutions"))}catch{}}),yI=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function al(){let n=M.solutions?.rows??[],t=M.panel==="inverse"&&he.ghosts!=="none"?n.filter(e=>(he.ghosts==="all"||e.inside)&&!yI(e.q,M.q)):[];nb(t.map(e=>e.q))}function hb(){nt("target",n=>{M.panel==="inverse"&&Ns({follow:Px.has(n)})}),nt("task",()=>{ut("plan"),M.panel==="inverse"&&M.hasTarget&&Ns()}),nt("panel",n=>{fs(null),n==="inverse"&&M.hasTarget&&!M.solutions&&Ns(),al()}),nt("moving",n=>{n||al()}),nt("table",n=>{he.redundancy=null,n==="new"&&(he.task=null),ut("solutions"),n!=="new"&&M.panel==="inverse"&&M.hasTarget&&Ns()}),nt("online",n=>{n&&M.panel==="inverse"&&M.hasTarget&&M.table.joints.length&&Ns()})}var tu=0;function mi(){tu+=1,M.moving&&(M.moving=!1,ut("moving",!1))}function Ri(n,t=.8,e="move to a posture"){mi(),ut("let-go"),ut("did",{label:e});let i=M.q.slice(),s=tu,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),M.moving=!0,ut("moving",!0),new Promise(o=>{(function a(l){if(s!==tu||i.length!==M.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Ni(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(M.moving=!1,ut("moving",!1),o(!0))})(r)})}function db(n,t,e,i){mi();let s=tu,r=performance.now()-1e3*n*t;M.moving=!0,ut("moving",!0),requestAnimationFrame(function o(a){if(s!==tu){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(M.moving=!1,ut("moving",!1),i?.(!0))})}var bI=200,MI=1500,Wo=[],iu=[],nu=null,eu={key:null,at:0,open:!1},Bg=!1,df=()=>({table:M.table,q:M.q,target:M.target,digits:M.digits,hasTarget:M.hasTarget,path:{...M.path},sequence:structuredClone(M.sequence),program:M.program,world:M.world,limits:M.limits,start:M.start,routing:M.routing,task:he.task,redundancy:he.redundancy});function kg(){Bg||(Bg=!0,queueMicrotask(()=>{Bg=!1,nu=df()}))}function SI({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===eu.key&&(eu.open||i-eu.at<MI))&&nu&&(Wo.push({label:n,before:nu}),Wo.length>bI&&Wo.shift(),iu.length=0),eu={key:t,at:i,open:e},kg(),ut("history")}function zg(){eu={key:null,at:0,open:!1}}function wI(n){mi(),zg(),he.task=n.task,n.table!==M.table?_n(n.table,{q:n.q,step:!1,what:"undo"}):Ni(n.q,"undo"),he.redundancy=n.redundancy,Object.assign(M.path,n.path),M.sequence=structuredClone(n.sequence),M.program=n.program,M.world=n.world,M.limits=n.limits,M.start=n.start;let t=M.routing!==n.routing;M.routing=n.routing,M.hasTarget=n.hasTarget,n.target!==M.target&&Mi(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ut(e,"undo");t&&ut("routing","undo")}function fb(n,t,e){let i=n.pop();if(!i)return;let s=df();wI(i.before),t.push({label:i.label,before:s}),kg(),ut("history"),be(`${e}: ${i.label}`)}var Hg=()=>fb(Wo,iu,"Undone"),Gg=()=>fb(iu,Wo,"Redone"),ff=()=>Wo.at(-1)?.label??null,pf=()=>iu.at(-1)?.label??null;function mf(){Wo.length=0,iu.length=0,zg(),nu=df(),ut("history")}function pb(){nu=df(),nt("did",SI),nt("let-go",zg),nt(["table","q","target","path","sequence","program","world","task","routing"],kg)}var xb=1,_b=30;function gf(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=M;return{pieper:xb,table:n,q:t,target:i?e:null,digits:M.digits,task:he.task,redundancy:he.redundancy,follow:he.follow,ghosts:he.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:M.program,start:M.start,limits:M.limits},world:M.world,routing:M.routing,look:M.look,panel:l,theme:c,units:[gt.angle,gt.length],camera:Qa()}}var Wn=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,gs=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Wn),ps=(n,t)=>typeof n=="string"?n.slice(0,t):"",ms=n=>{if(!gs(n,16))return null;let t=Ru(n);return t<1e-12?n.slice():t<.001?Cu(n):null},TI=n=>n&&Wn(n.metres)&&Wn(n.radians)?{metres:n.metres,radians:n.radians}:null,AI=n=>n&&[n.lower,n.upper,n.value].every(Wn)&&n.lower<=n.upper?{name:ps(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:ps(n.unit,10)}:null,RI=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>gs(e,t))?n:null;function CI(n){if(!n||!Array.isArray(n.joints)||n.joints.length>_b||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Wn(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:ps(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Wn(i.lower)?i.lower:null,upper:Wn(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>gs(i,t.length)).slice(0,40));return{name:ps(n.name,60),convention:n.convention,joints:t,base:ms(n.base)??Yi(),tool:ms(n.tool)??Yi(),postures:e,manufacturer:ps(n.manufacturer,200),source:ps(n.source,2e3),notes:ps(n.notes,3e3),actuator:AI(n.actuator),catalog:ps(n.catalog,60)||void 0,derived:ps(n.derived,60)||void 0,coupling:RI(n.coupling,t.length)}}var mb={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function PI(n,t){if(!n||!Object.hasOwn(mb,n.kind))return null;let e=mb[n.kind];if(e)return Wn(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(l=>Number.isInteger(l)&&l>=1&&l<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return ms(n.T)?{kind:"frame",T:ms(n.T)}:null;let i=n.kind==="joint"&&gs(n.q,t)?n.q.slice():null,s=ms(n.T),r=n.kind==="circle"&&gs(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!ms(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(ms):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(l,c)=>c===null?{}:{[l]:c};return{kind:n.kind,...a("q",i),T:s,...a("via",ms(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",Wn(n.speed)&&n.speed>0?n.speed:null),blend:Wn(n.blend)&&n.blend>=0?n.blend:0}}var Vg={frame:[],box:["size"],cylinder:["r","h"]};function II(n){if(!n||!Object.hasOwn(Vg,n.kind))return null;let t=ms(n.T),e=ps(n.name,40),i=s=>s==="size"?gs(n.size,3)&&n.size.every(r=>r>0):Wn(n[s])&&n[s]>0;return!t||!e||!Vg[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(Vg[n.kind].map(s=>[s,n[s]]))}}function LI(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&Wn(s.turn)&&gs(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:ps(s.branch,80)}:null,i=(s,r)=>Wn(s)&&s>=0&&s<r?s:0;return{turn:gs(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function DI(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};M.program=e(i.steps,s=>PI(s,t),200),M.start=gs(i.start,t)?i.start.slice():null,M.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||Wn(r)&&r>0))),M.world=e(n.world,II,60),M.routing=LI(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&Wn(n.look.opacity)&&(M.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function xf(n,t){let e=n&&n.pieper===xb?CI(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(gt.set("angle",n.units[0]),gt.set("length",n.units[1])),Object.hasOwn(Ls,n.notation)&&(M.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Ud(n.theme),M.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};_n(e,{q:gs(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(M.path,{from:ms(s.from),to:ms(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:Wn(s.seconds)&&s.seconds>0?s.seconds:5}),M.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&gs(a.q,i)&&Wn(a.seconds)&&Wn(a.hold)).slice(0,40).map(a=>({name:ps(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),DI(n,i),["pose","position","position+axis"].includes(n.task)&&(he.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&Wn(l));he.redundancy=r.length?Object.fromEntries(r.slice(0,_b)):null,typeof n.follow=="boolean"&&(he.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(he.ghosts=n.ghosts);let o=ms(n.target);M.hasTarget=!!o,o&&Mi(o,"restored",TI(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ut(a);t(n.panel),ut("path-loaded"),ut("routing","loaded"),ut("look","loaded"),gs(n.camera,6)&&iv(n.camera),Ni(M.q,"restored"),mf()}async function yb(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function _f(){let n=await yb(new TextEncoder().encode(JSON.stringify(gf())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function vb(){let n=NI();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await yb(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var bb="pieper-workbench";function NI(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(bb)??"{}");return t&&n===location.href?t:null}catch{return null}}function UI(){if(M.table.joints.length)try{sessionStorage.setItem(bb,JSON.stringify({address:location.href,shown:gf()}))}catch{}}var gb=null,OI=js(async()=>{if(!M.table.joints.length)return;let n=await _f();n!==gb&&(gb=n,history.replaceState(null,"",n))},600);function Mb(){addEventListener("pagehide",UI),nt(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],OI)}var Wg={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},Sb={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},yf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,wb=80;function BI(n){let t=[];yf.lastIndex=0;let e=n.trimEnd();for(;yf.lastIndex<e.length;){let i=yf.lastIndex,s=yf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function kI(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function vf(n,t="plain"){let e=kI(String(n));if(e.length>wb)throw new Error(`longer than ${wb} characters`);let i=BI(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in gt.suffix(t)&&(s=gt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=g=>i[o]?.sign===g,c=g=>{if(!l(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;l("+")||l("-");){let x=i[o++].sign,T=h();g=x==="+"?g+T:g-T}return g}function h(){let g=d();for(;;)if(l("*"))o++,g*=d();else if(l("/"))o++,g/=d();else if(i[o]?.word||l("("))g*=f();else return g}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let g=p();return l("^")?(o++,g**d()):g}function p(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let x=u();return c(")"),x}if(g.word){let x=g.word.toLowerCase();if(Object.hasOwn(Sb,x))return a=!0,Sb[x];if(Object.hasOwn(Wg,x)){c("(");let T=u();return c(")"),Wg[x](T)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(Wg).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let _=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(_))throw new Error("not a finite number");let m=s??(t==="angle"&&a?1:gt.factor(t));return{value:_/m+0,symbolic:a||s!==null||i.length>2}}function bn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=b("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let m=vf(c.value,l()),g=a?.(m.value);if(g)throw new Error(g);return m},f=m=>{c.classList.toggle("wrong",!!m),m?(c.setAttribute("aria-invalid","true"),c.title=m):(c.removeAttribute("aria-invalid"),c.title=o??""),$g(c,m),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:m?{label:n,reason:m}:null}))},p=m=>{try{let g=d();return f(null),m?.(g.value,{symbolic:g.symbolic,text:c.value.trim()}),!0}catch(g){return f(g.message),!1}};c.addEventListener("input",()=>p(e)),c.addEventListener("change",()=>{p(i??e)&&c.blurred?.()});let _="";return c.addEventListener("focus",()=>{_=c.value,c.classList.contains("wrong")&&$g(c,c.title),c.select()}),c.addEventListener("blur",()=>$g(c,null)),c.addEventListener("keydown",m=>{let g=c.closest("table.dh");if(m.key==="Escape"&&c.value!==_){m.preventDefault(),c.value=_,p(i??e),c.select();return}if(g&&zI(c,m))return;let x={ArrowUp:1,ArrowDown:-1}[m.key];if(m.key==="Enter"&&(_=c.value,c.select()),!(!x||g&&!m.altKey)){m.preventDefault();try{let T=d();c.value=Hc((T.value??0)+x*gt.step(l())*(m.shiftKey?.1:1),l()),p(i??e)}catch{}}}),c.put=(m,g=null)=>{document.activeElement===c&&!c.readOnly||m===u&&g===h&&!c.classList.contains("wrong")||(u=m,h=g,c.value=g??(m==null?"":Hc(m,l())),qg(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>qg(c)),c.refresh=()=>{let m=u,g=h;u=NaN,c.put(m,g)},c}function qg(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&qg(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Ci=null;function $g(n,t){if(!t){Ci&&Ci.about===n&&(Ci.hidden=!0),n.removeAttribute("aria-describedby");return}Ci||(Ci=b("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Ci)),Ci.about=n,Ci.hidden=!1,Ci.textContent!==t&&(Ci.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Ci.style.setProperty("top",`${e.bottom+4}px`),Ci.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Ci.offsetWidth-8))}px`)}addEventListener("scroll",()=>Ci&&(Ci.hidden=!0),!0);function zI(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function bf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Mf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Ze=n=>n.type==="R"?"angle":"length";function Eb(n){let t=n.type==="R"?Math.PI:li(M.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var HI=Fc;function GI(n){let t=M.table.joints[n],e=Ze(t),{lo:i,hi:s,min:r,max:o}=Eb(t),a=`q${n+1}`,l=b("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=_=>`${100*(_-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{mi(),Iu(n,Number(l.value))}),l.addEventListener("keydown",_=>{let m={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[_.key],g={Home:i,End:s}[_.key];if(m===void 0&&g===void 0)return;_.preventDefault(),mi();let x=gt.step(e)*(_.shiftKey?.1:1);Iu(n,g??Math.min(Math.max(Math.round((M.q[n]+m*x)/(x/10))*(x/10),r),o))});let u=bn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:_=>{mi(),Iu(n,_)}}),h=b("span",{class:"out",role:"note"}),d=b("span",{class:"chain",title:"What this row of the table moves by"}),f=b("span",{class:"limits"}),p=b("div",{class:"joint","data-testid":`joint-${n+1}`},b("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},b("i",{text:"q"}),b("sub",{text:String(n+1)})),b("div",{class:"track"},l,b("div",{class:"under"},f,d,h)),u,b("span",{class:"unit"}));return{el:p,number:u,show(){let _=M.q[n],m=HI(t,_);(document.activeElement!==l||Number(l.value)!==_)&&(l.value=_),l.style.setProperty("--at",c(Math.min(Math.max(_,r),o))),l.setAttribute("aria-valuetext",ue(_,e)),u.put(Number((_*gt.factor(e)).toFixed(gt.digits(e)+1))/gt.factor(e)),p.classList.toggle("outside",m!==0);let g=M.table.coupling?`chain ${ue(xr(M.table,M.q)[n],e)}`:"";bt(d,g),bt(h,m?`${ue(Math.abs(m),e)} ${m>0?"above":"below"} the limit`:"")},relabel(){bt(p.lastChild,gt.symbol(e));let _=m=>m===null?"no limit":ue(m,e,gt.angle==="deg"&&e==="angle"?0:void 0);bt(f,t.lower===null&&t.upper===null?"no limits":`${_(t.lower)} \u2026 ${_(t.upper)}`),u.refresh(),this.show()}}}var Tb={id:"joints",title:"Joints",build(n){let t=[],e=b("div",{class:"joints","data-testid":"joints"}),i=b("div",{class:"chips",role:"group","aria-label":"Postures"}),s=b("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=M.table.joints.map((o,a)=>GI(a)),Vt(e,t.map(o=>o.el)),t.length||e.append(b("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Vt(s,M.table.actuator?VI(M.table.actuator):null),WI(i)};nt("table",o=>o!=="gripper"&&r()),nt("q",()=>t.forEach(o=>o.show())),nt("units",()=>t.forEach(o=>o.relabel())),r()}};function VI(n){let t=b("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=b("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),bt(e,ti(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},_n({...M.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=b("div",{class:"under"},b("span",{text:`${n.name}: moves no frame`}));return b("div",{class:"joint"},b("span",{class:"joint-name",text:"tool"}),b("div",{class:"track"},t,s),e,b("span",{class:"unit",text:n.unit}))}function WI(n){let t=M.table.joints.length,e=Object.entries(M.table.postures??{}),i=(r,o)=>b("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>ue(a,Ze(M.table.joints[l]))).join(", "),on:{click:()=>Ri(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Vt(n,s,t?b("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>Ri($I(),.8,"move to a random posture")}}):null,t?b("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:qI}}):null)}function $I(){return M.table.joints.map(n=>{let{lo:t,hi:e}=Eb(n);return t+Math.random()*(e-t)})}function qI(){let n={...M.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=M.q.slice(),_n({...M.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),be(`Kept as P${t}: ${M.q.map((e,i)=>Hc(e,Ze(M.table.joints[i]))).join(", ")}`),ut("postures")}var Rb=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["accelerations","Accelerations"],["toolspeed","Tool speed"],["singularity","Distance to singularity"]];function lr({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o,ddq:a,events:l=[],title:c,...u}){let h=t.map(p=>Ms(n,p)),d=h.map(p=>Qt(p[p.length-1])),f=o??Xg(t,r);return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:l,title:c,...u,tool:d,speeds:f,accelerations:a??Xg(f,r),toolspeeds:Xg(d,r).map(Di),least:t.map((p,_)=>Pu(n,p,h[_])[0]??0)}}function Xg(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}var XI=1e6;function YI(n,t,e){let i=n.table.joints[e];if(t==="joints")return[i.lower,i.upper];let s=n.limits?.[{speeds:"speed",accelerations:"acceleration"}[t]],r=Array.isArray(s)?s[e]:s??null;return r===null||r>=XI?[null,null]:[-r,r]}var ZI={speeds:"speed",accelerations:"acceleration",toolspeed:"tool speed"},Ab=(n,t,e=null)=>(n.tight??[]).filter(i=>i.limit===ZI[t]&&i.joint===e),Cb=(n,t)=>(n.tight??[]).filter(e=>e.start-1e-9<=t&&t<=e.end+1e-9).map(e=>e.joint?`${e.limit} of ${e.joint}`:e.limit).join(", ");function Yg(n,t){let{table:e}=n,i=gt.factor("length");if(t==="position")return{y:`tool, ${gt.length}`,list:["X","Y","Z"].map((c,u)=>Sf(c,n.tool.map(h=>h[u]*i)))};if(t==="singularity")return{y:"smallest singular value",list:[Sf("\u03C3 min",n.least)]};if(t==="toolspeed"){let c=n.limits?.tool_speed??null,u=n.toolspeeds.map(h=>h*i);return{y:`tool, ${gt.length}/s`,list:[Sf("tool speed",u,[null,c&&c*i],Ab(n,t))]}}let s={joints:n.q,speeds:n.speeds,accelerations:n.accelerations}[t],r={joints:"",speeds:"/s",accelerations:"/s\xB2"}[t],a=[...new Set(e.joints.map(Ze))].map(c=>(c==="angle"?gt.angle:gt.length)+r).join(" or "),l=e.joints.map((c,u)=>{let h=gt.factor(Ze(c));return Sf(`q${u+1}`,s.map(d=>d[u]*h),YI(n,t,u).map(d=>d===null?null:d*h),Ab(n,t,c.name))});return{y:a,list:l}}var Sf=(n,t,e=[null,null],i=[])=>({name:n,values:t,limits:e,binds:i});function su(n){let t=n.flatMap((i,s)=>i.limits.filter(r=>r!==null).map(r=>({value:r,of:s}))),e=new Map;for(let i of t)e.set(i.value,[...e.get(i.value)??[],i.of]);return[...e].map(([i,s])=>({value:i,of:s.length===1&&n.length>1?s[0]:null}))}function Pb(n){let t=gt.angle,e=gt.length,{table:i}=n,s=l=>Ze(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*gt.factor("length")),...l.map((u,h)=>u*gt.factor(Ze(i.joints[h]))),...n.speeds[c].map((u,h)=>u*gt.factor(Ze(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function Ib(n,t,e){let{y:i,list:s}=Yg(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(y=>y.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,p]=[Math.min(...c),Math.max(...c)];p-f>1e-9||(f-=1,p+=1);let _=y=>a.l+(y-h)/(d-h)*(r-a.l-a.r),m=y=>o-a.b-(y-f)/(p-f)*(o-a.t-a.b),g=(y,w)=>{let U=(w-y)/6,L=10**Math.floor(Math.log10(U)),N=[1,2,5,10].map(H=>H*L).find(H=>H>=U);return Array.from({length:12},(H,$)=>(Math.ceil(y/N)+$)*N).filter(H=>H<=w+N*1e-6)},x=y=>y.toFixed(2),T=y=>String(Number(y.toPrecision(6))),v=y=>y.replace(/[&<>"]/g,w=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[w]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],S=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let y of g(f,p))S.push(`<path d="M${a.l} ${x(m(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(m(y)+4)}" text-anchor="end">${T(y)}</text>`);for(let y of g(h,d))S.push(`<path d="M${x(_(y))} ${o-a.b}v5" stroke="#333"/><text x="${x(_(y))}" y="${o-a.b+20}" text-anchor="middle">${T(y)}</text>`);S.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&S.push(`<path d="M${x(_(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(_(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(y.short)}</text>`);for(let{value:y,of:w}of su(s))y>=f&&y<=p&&S.push(`<path d="M${a.l} ${x(m(y))}H${r-a.r}" stroke="${w===null?"#333":e[w%e.length]}" stroke-dasharray="2 5"/>`);return s.forEach((y,w)=>{let U=e[w%e.length],L=y.values[y.values.length-1];S.push(`<polyline fill="none" stroke="${U}" stroke-width="1.8" stroke-dasharray="${A[w%A.length]}" points="${y.values.map((N,H)=>`${x(_(l[H]))},${x(m(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*w}h22" stroke="${U}" stroke-width="2" stroke-dasharray="${A[w%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*w}"><title>${x(L)}</title>${v(y.name)}</text>`)}),S.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${S.join("")}</svg>
`}var jI="uplot",JI="u-hz",KI="u-vt",QI="u-title",t3="u-wrap",e3="u-under",n3="u-over",i3="u-axis",Xo="u-off",s3="u-select",r3="u-cursor-x",o3="u-cursor-y",a3="u-cursor-pt",l3="u-legend",c3="u-live",u3="u-inline",h3="u-series",d3="u-marker",Lb="u-label",f3="u-value",ou="width",au="height";var Db="bottom",ll="left",Zg="right",d0="#000",Nb=d0+"0",jg="mousemove",Ub="mousedown",Jg="mouseup",Ob="mouseenter",Fb="mouseleave",Bb="dblclick",p3="resize",m3="scroll",kb="change",Rf="dppxchange",f0="--",ml=typeof window<"u",n0=ml?document:null,ul=ml?window:null,g3=ml?navigator:null,He,wf;function i0(){let n=devicePixelRatio;He!=n&&(He=n,wf&&r0(kb,wf,i0),wf=matchMedia(`(min-resolution: ${He-.001}dppx) and (max-resolution: ${He+.001}dppx)`),Yo(kb,wf,i0),ul.dispatchEvent(new CustomEvent(Rf)))}function ss(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function s0(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function mn(n,t,e){n.style[t]=e+"px"}function Us(n,t,e,i){let s=n0.createElement(n);return t!=null&&ss(s,t),e?.insertBefore(s,i),s}function xs(n,t){return Us("div",n,t)}var zb=new WeakMap;function cr(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=zb.get(n);r!=o&&(n.style.transform=r,zb.set(n,r),t<0||e<0||t>i||e>s?ss(n,Xo):s0(n,Xo))}var Hb=new WeakMap;function Gb(n,t,e){let i=t+e,s=Hb.get(n);i!=s&&(Hb.set(n,i),n.style.background=t,n.style.borderColor=e)}var Vb=new WeakMap;function Wb(n,t,e,i){let s=t+""+e,r=Vb.get(n);s!=r&&(Vb.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var p0={passive:!0},x3={...p0,capture:!0};function Yo(n,t,e,i){t.addEventListener(n,e,i?x3:p0)}function r0(n,t,e,i){t.removeEventListener(n,e,p0)}ml&&i0();function Os(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:rs((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function _M(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var yM=n=>n!=null,vM=n=>n!=null&&n>0,If=_M(yM),_3=_M(vM);function y3(n,t,e,i=0,s=!1){let r=s?_3:If,o=s?vM:yM;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??tn,l??-tn]}function Lf(n,t,e,i){let s=Xb(n),r=Xb(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Or:bM,a=s==1?rs:_s,l=r==1?_s:rs,c=a(o(qn(n))),u=l(o(qn(t))),h=hl(e,c),d=hl(e,u);return e==10&&(c<0&&(h=en(h,-c)),u<0&&(d=en(d,-u))),i||e==2?(n=h*s,t=d*r):(n=EM(n,h),t=Df(t,d)),[n,t]}function m0(n,t,e,i){let s=Lf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var g0=.1,$b={mode:3,pad:g0},cu={pad:0,soft:null,mode:0},v3={min:cu,max:cu};function Cf(n,t,e,i){return Nf(e)?qb(n,t,e):(cu.pad=e,cu.soft=i?0:null,cu.mode=i?3:0,qb(n,t,v3))}function Fe(n,t){return n??t}function b3(n,t,e){for(t=Fe(t,0),e=Fe(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function qb(n,t,e){let i=e.min,s=e.max,r=Fe(i.pad,0),o=Fe(s.pad,0),a=Fe(i.hard,-tn),l=Fe(s.hard,tn),c=Fe(i.soft,tn),u=Fe(s.soft,-tn),h=Fe(i.mode,0),d=Fe(s.mode,0),f=t-n,p=Or(f),_=Pi(qn(n),qn(t)),m=Or(_),g=qn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=tn&&(r=0),d==2&&u!=-tn&&(o=0)));let x=f||_||1e3,T=Or(x),v=hl(10,rs(T)),A=x*(f==0?n==0?.1:1:r),S=en(EM(n-A,v/10),24),y=n>=c&&(h==1||h==3&&S<=c||h==2&&S>=c)?c:tn,w=Pi(a,S<y&&n>=y?y:Fs(y,S)),U=x*(f==0?t==0?.1:1:o),L=en(Df(t+U,v/10),24),N=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-tn,H=Fs(l,L>N&&t<=N?N:Pi(N,L));return w==H&&w==0&&(H=100),[w,H]}var M3=new Intl.NumberFormat(ml?g3.language:"en-US"),x0=n=>M3.format(n),os=Math,Af=os.PI,qn=os.abs,rs=os.floor,$n=os.round,_s=os.ceil,Fs=os.min,Pi=os.max,hl=os.pow,Xb=os.sign,Or=os.log10,bM=os.log2,S3=(n,t=1)=>os.sinh(n)*t,Kg=(n,t=1)=>os.asinh(n/t),tn=1/0;function Yb(n){return(Or((n^n>>31)-(n>>31))|0)+1}function o0(n,t,e){return Fs(Pi(n,t),e)}function MM(n){return typeof n=="function"}function De(n){return MM(n)?n:()=>n}var w3=()=>{},SM=n=>n,wM=(n,t)=>t,E3=n=>null,Zb=n=>!0,jb=(n,t)=>n==t,T3=/\.\d*?(?=9{6,}|0{6,})/gm,Zo=n=>{if(AM(n)||go.has(n))return n;let t=`${n}`,e=t.match(T3);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Zo(s)}e${r}`}return en(n,i)};function $o(n,t){return Zo(en(Zo(n/t))*t)}function Df(n,t){return Zo(_s(Zo(n/t))*t)}function EM(n,t){return Zo(rs(Zo(n/t))*t)}function en(n,t=0){if(AM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return $n(i)/e}var go=new Map;function TM(n){return((""+n).split(".")[1]||"").length}function hu(n,t,e,i){let s=[],r=i.map(TM);for(let o=t;o<e;o++){let a=qn(o),l=en(hl(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:en(u,h);s.push(d),go.set(d,h)}}return s}var uu={},_0=[],dl=[null,null],mo=Array.isArray,AM=Number.isInteger,A3=n=>n===void 0;function Jb(n){return typeof n=="string"}function Nf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function R3(n){return n!=null&&typeof n=="object"}var C3=Object.getPrototypeOf(Uint8Array),RM="__proto__";function fl(n,t=Nf){let e;if(mo(n)){let i=n.find(s=>s!=null);if(mo(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=fl(n[s],t)}else e=n.slice()}else if(n instanceof C3)e=n.slice();else if(t(n)){e={};for(let i in n)i!=RM&&(e[i]=fl(n[i],t))}else e=n;return e}function Fn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=RM&&(Nf(n[s])?Fn(n[s],fl(i[s])):n[s]=fl(i[s]))}return n}var P3=0,I3=1,L3=2;function D3(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function N3(n,t){if(F3(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return B3(o[0])||(o=O3(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:I3,f=[];for(let p=0;p<u.length;p++){let _=u[p],m=r.get(l[p]);_===null?d!=P3&&(h[m]=_,d==L3&&f.push(m)):h[m]=_}D3(h,f,s),i.push(h)}}return i}var U3=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function O3(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function F3(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function B3(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Pi(1,rs((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var CM=["January","February","March","April","May","June","July","August","September","October","November","December"],PM=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function IM(n){return n.slice(0,3)}var k3=PM.map(IM),z3=CM.map(IM),H3={MMMM:CM,MMM:z3,WWWW:PM,WWW:k3};function ru(n){return(n<10?"0":"")+n}function G3(n){return(n<10?"00":n<100?"0":"")+n}var V3={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ru(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ru(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ru(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ru(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ru(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>G3(n.getMilliseconds())};function y0(n,t){t=t||H3;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?V3[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var W3=new Intl.DateTimeFormat().resolvedOptions().timeZone;function $3(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==W3?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var LM=n=>n%1==0,Pf=[1,2,2.5,5],q3=hu(10,-32,0,Pf),DM=hu(10,0,32,Pf),X3=DM.filter(LM),qo=q3.concat(DM),v0=`
`,NM="{YYYY}",Kb=v0+NM,UM="{M}/{D}",lu=v0+UM,Ef=lu+"/{YY}",OM="{aa}",Y3="{h}:{mm}",cl=Y3+OM,Qb=v0+cl,tM=":{ss}",We=null;function FM(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?hu(10,0,3,Pf).filter(LM):hu(10,-3,0,Pf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,NM,We,We,We,We,We,We,1],[s*28,"{MMM}",Kb,We,We,We,We,We,1],[s,UM,Kb,We,We,We,We,We,1],[i,"{h}"+OM,Ef,We,lu,We,We,We,1],[e,cl,Ef,We,lu,We,We,We,1],[t,tM,Ef+" "+cl,We,lu+" "+cl,We,Qb,We,1],[n,tM+".{fff}",Ef+" "+cl,We,lu+" "+cl,We,Qb,We,1]];function u(h){return(d,f,p,_,m,g)=>{let x=[],T=m>=o,v=m>=r&&m<o,A=h(p),S=en(A*n,3),y=Qg(A.getFullYear(),T?0:A.getMonth(),v||T?1:A.getDate()),w=en(y*n,3);if(v||T){let U=v?m/r:0,L=T?m/o:0,N=S==w?S:en(Qg(y.getFullYear()+L,y.getMonth()+U,1)*n,3),H=new Date($n(N/n)),$=H.getFullYear(),P=H.getMonth();for(let z=0;N<=_;z++){let D=Qg($+L*z,P+U*z,1),B=D-h(en(D*n,3));N=en((+D+B)*n,3),N<=_&&x.push(N)}}else{let U=m>=s?s:m,L=rs(p)-rs(S),N=w+L+Df(S-w,U);x.push(N);let H=h(N),$=H.getHours()+H.getMinutes()/e+H.getSeconds()/i,P=m/i,z=d.axes[f]._space,D=g/z;for(;N=en(N+m,n==1?0:3),!(N>_);)if(P>1){let B=rs(en($+P,6))%24,j=h(N).getHours()-B;j>1&&(j=-1),N-=j*i,$=($+P)%24;let et=x[x.length-1];en((N-et)/m,3)*D>=.7&&x.push(N)}else x.push(N)}return x}}return[l,c,u]}var[Z3,j3,J3]=FM(1),[K3,Q3,t2]=FM(.001);hu(2,-53,53,[1]);function eM(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function nM(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let _=n(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),T=_.getHours(),v=_.getMinutes(),A=_.getSeconds(),S=m!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||T!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,u=x,h=T,d=v,f=A,S(_)})}}function e2(n,t){let e=y0(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Qg(n,t,e){return new Date(n,t,e)}function iM(n,t){return t(n)}var n2="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function sM(n,t){return(e,i,s,r)=>r==null?f0:t(n(i))}function i2(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function s2(n,t){return n.series[t].fill(n,t)}var r2={show:!0,live:!0,isolate:!1,mount:w3,markers:{show:!0,width:2,stroke:i2,fill:s2,dash:"solid"},idx:null,idxs:null,values:[]};function o2(n,t){let e=n.cursor.points,i=xs(),s=e.size(n,t);mn(i,ou,s),mn(i,au,s);let r=s/-2;mn(i,"marginLeft",r),mn(i,"marginTop",r);let o=e.width(n,t,s);return o&&mn(i,"borderWidth",o),i}function a2(n,t){let e=n.series[t].points;return e._fill||e._stroke}function l2(n,t){let e=n.series[t].points;return e._stroke||e._fill}function c2(n,t){return n.series[t].points.size}var t0=[0,0];function u2(n,t,e){return t0[0]=t,t0[1]=e,t0}function Tf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function e0(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var h2={show:!0,x:!0,y:!0,lock:!1,move:u2,points:{one:!1,show:o2,size:c2,width:0,stroke:l2,fill:a2},bind:{mousedown:Tf,mouseup:Tf,click:Tf,dblclick:Tf,mousemove:e0,mouseleave:e0,mouseenter:e0},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},BM={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},b0=Fn({},BM,{filter:wM}),kM=Fn({},b0,{size:10}),zM=Fn({},BM,{show:!1}),M0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',HM="bold "+M0,GM=1.5,rM={show:!0,scale:"x",stroke:d0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:HM,side:2,grid:b0,ticks:kM,border:zM,font:M0,lineGap:GM,rotate:0},d2="Value",f2="Time",oM={show:!0,scale:"x",auto:!1,sorted:1,min:tn,max:-tn,idxs:[]};function p2(n,t,e,i,s){return t.map(r=>r==null?"":x0(r))}function m2(n,t,e,i,s,r,o){let a=[],l=go.get(s)||0;e=o?e:en(Df(e,s),l);for(let c=e;c<=i;c=en(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function a0(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Or:bM,u=rs(c(e));s=hl(l,u),l==10&&(s=qo[Os(s,qo)]);let h=e,d=s*l;l==10&&(d=qo[Os(d,qo)]);do a.push(h),h=h+s,l==10&&!go.has(h)&&(h=en(h,go.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=qo[Os(d,qo)]));while(h<=i);return a}function g2(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?a0(n,t,Pi(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?a0(n,t,Pi(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var VM=/./,x2=/[12357]/,_2=/[125]/,aM=/1/,l0=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function y2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?VM:l(7,o)-u>=c?x2:l(5,o)-u>=c?_2:aM;if(h==aM){let d=qn(l(1,o)-u);if(d<c)return l0(t.slice().reverse(),a.distr,h,_s(c/d)).reverse()}return l0(t,a.distr,h,1)}function v2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=qn(l(1,o)-l(2,o));return c<a?l0(t.slice().reverse(),3,VM,_s(a/c)).reverse():t}function b2(n,t,e,i){return i==null?f0:t==null?"":x0(t)}var lM={show:!0,scale:"y",stroke:d0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:HM,side:3,grid:b0,ticks:kM,border:zM,font:M0,lineGap:GM,rotate:0};function M2(n,t){let e=3+(n||1)*2;return en(e*t,3)}function S2(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=qn(o-r),l=n.series[t],c=a/(l.points.space*He);return i[1]-i[0]<=c}var cM={scale:null,auto:!0,sorted:0,min:tn,max:-tn},WM=(n,t,e,i,s)=>s,uM={show:!0,auto:!0,sorted:0,gaps:WM,alpha:1,facets:[Fn({},cM,{scale:"x"}),Fn({},cM,{scale:"y"})]},hM={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:WM,alpha:1,points:{show:S2,filter:null},values:null,min:tn,max:-tn,idxs:[],path:null,clip:null};function w2(n,t,e,i,s){return e/10}var $M={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},E2=Fn({},$M,{time:!1,ori:1}),dM={};function qM(n,t){let e=dM[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(dM[n]=e)),e}var pl=1,c0=2;function jo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,g,d,f,p,_,Of,gl,Bf,YM,jM):e(s,l,c,u,h,g,m,f,d,_,p,Ff,xl,E0,ZM,JM)}function S0(n,t){let e=0,i=0,s=Fe(n.bands,_0);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function T2(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Fr(n,t,e,i,s,r){return jo(n,t,(o,a,l,c,u,h,d,f,p,_,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),T=c.ori==0?gl:xl,v,A;x==1?(v=e,A=i):(v=i,A=e);let S=g(h(a[v],c,_,f)),y=g(d(l[v],u,m,p)),w=g(h(a[A],c,_,f)),U=g(d(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return T(L,w,U),T(L,S,U),T(L,S,y),L})}function Uf(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Bf:E0,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function A2(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function w0(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function fM(n){return n==0?SM:n==1?$n:t=>$o(t,n)}function XM(n){let t=n==0?Of:Ff,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Fs(c,a/2,l/2),u=Fs(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Of=(n,t,e)=>{n.moveTo(t,e)},Ff=(n,t,e)=>{n.moveTo(e,t)},gl=(n,t,e)=>{n.lineTo(t,e)},xl=(n,t,e)=>{n.lineTo(e,t)},Bf=XM(0),E0=XM(1),YM=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},ZM=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},jM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},JM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function KM(n){return(t,e,i,s,r)=>jo(t,e,(o,a,l,c,u,h,d,f,p,_,m)=>{let{pxRound:g,points:x}=o,T,v;c.ori==0?(T=Of,v=YM):(T=Ff,v=ZM);let A=en(x.width*He,3),S=(x.size-x.width)/2*He,y=en(S*2,3),w=new Path2D,U=new Path2D,{left:L,top:N,width:H,height:$}=t.bbox;Bf(U,L-y,N-y,H+y*2,$+y*2);let P=z=>{if(l[z]!=null){let D=g(h(a[z],c,_,f)),B=g(d(l[z],u,m,p));T(w,D+S,B),v(w,D,B,S,0,Af*2)}};if(r)r.forEach(P);else for(let z=i;z<=s;z++)P(z);return{stroke:A>0?w:null,fill:w,clip:U,flags:pl|c0}})}function QM(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var R2=QM(gl),C2=QM(xl);function tS(n){let t=Fe(n?.alignGaps,0);return(e,i,s,r)=>jo(e,i,(o,a,l,c,u,h,d,f,p,_,m)=>{[s,r]=If(l,s,r);let g=o.pxRound,x=$=>g(h($,c,_,f)),T=$=>g(d($,u,m,p)),v,A;c.ori==0?(v=gl,A=R2):(v=xl,A=C2);let S=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:pl},w=y.stroke,U=!1;if(r-s>=_*4){let $=ft=>e.posToVal(ft,c.key,!0),P=null,z=null,D,B,Q,Y=x(a[S==1?s:r]),j=x(a[s]),et=x(a[r]),dt=$(S==1?j+1:et-1);for(let ft=S==1?s:r;ft>=s&&ft<=r;ft+=S){let st=a[ft],xt=(S==1?st<dt:st>dt)?Y:x(st),Tt=l[ft];xt==Y?Tt!=null?(B=Tt,P==null?(v(w,xt,T(B)),D=P=z=B):B<P?P=B:B>z&&(z=B)):Tt===null&&(U=!0):(P!=null&&A(w,Y,T(P),T(z),T(D),T(B)),Tt!=null?(B=Tt,v(w,xt,T(B)),P=z=D=B):(P=z=null,Tt===null&&(U=!0)),Y=xt,dt=$(Y+S))}P!=null&&P!=z&&Q!=Y&&A(w,Y,T(P),T(z),T(D),T(B))}else for(let $=S==1?s:r;$>=s&&$<=r;$+=S){let P=l[$];P===null?U=!0:P!=null&&v(w,x(a[$]),T(P))}let[N,H]=S0(e,i);if(o.fill!=null||N!=0){let $=y.fill=new Path2D(w),P=o.fillTo(e,i,o.min,o.max,N),z=T(P),D=x(a[s]),B=x(a[r]);S==-1&&([B,D]=[D,B]),v($,B,z),v($,D,z)}if(!o.spanGaps){let $=[];U&&$.push(...w0(a,l,s,r,S,x,t)),y.gaps=$=o.gaps(e,i,s,r,$),y.clip=Uf($,c.ori,f,p,_,m)}return H!=0&&(y.band=H==2?[Fr(e,i,s,r,w,-1),Fr(e,i,s,r,w,1)]:Fr(e,i,s,r,w,H)),y})}function P2(n){let t=Fe(n.align,1),e=Fe(n.ascDesc,!1),i=Fe(n.alignGaps,0),s=Fe(n.extend,!1);return(r,o,a,l)=>jo(r,o,(c,u,h,d,f,p,_,m,g,x,T)=>{[a,l]=If(h,a,l);let v=c.pxRound,{left:A,width:S}=r.bbox,y=j=>v(p(j,d,x,m)),w=j=>v(_(j,f,T,g)),U=d.ori==0?gl:xl,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:pl},N=L.stroke,H=d.dir*(d.ori==0?1:-1),$=w(h[H==1?a:l]),P=y(u[H==1?a:l]),z=P,D=P;s&&t==-1&&(D=A,U(N,D,$)),U(N,P,$);for(let j=H==1?a:l;j>=a&&j<=l;j+=H){let et=h[j];if(et==null)continue;let dt=y(u[j]),ft=w(et);t==1?U(N,dt,$):U(N,z,ft),U(N,dt,ft),$=ft,z=dt}let B=z;s&&t==1&&(B=A+S,U(N,B,$));let[Q,Y]=S0(r,o);if(c.fill!=null||Q!=0){let j=L.fill=new Path2D(N),et=c.fillTo(r,o,c.min,c.max,Q),dt=w(et);U(j,B,dt),U(j,D,dt)}if(!c.spanGaps){let j=[];j.push(...w0(u,h,a,l,H,y,i));let et=c.width*He/2,dt=e||t==1?et:-et,ft=e||t==-1?-et:et;j.forEach(st=>{st[0]+=dt,st[1]+=ft}),L.gaps=j=c.gaps(r,o,a,l,j),L.clip=Uf(j,d.ori,m,g,x,T)}return Y!=0&&(L.band=Y==2?[Fr(r,o,a,l,N,-1),Fr(r,o,a,l,N,1)]:Fr(r,o,a,l,N,Y)),L})}function pM(n,t,e,i,s,r,o=tn){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=qn(n[l]-n[a]);u<c&&(c=u,o=qn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function I2(n){n=n||uu;let t=Fe(n.size,[.6,tn,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=De(s),o=1-t[0],a=Fe(t[1],tn),l=Fe(t[2],1),c=Fe(n.disp,uu),u=Fe(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,_,m)=>jo(f,p,(g,x,T,v,A,S,y,w,U,L,N)=>{let H=g.pxRound,$=e,P=i*He,z=a*He,D=l*He,B,Q;v.ori==0?[B,Q]=r(f,p):[Q,B]=r(f,p);let Y=v.dir*(v.ori==0?1:-1),j=v.ori==0?Bf:E0,et=v.ori==0?u:(Nt,ie,me,Ct,Ke,Xt,ee)=>{u(Nt,ie,me,Ke,Ct,ee,Xt)},dt=Fe(f.bands,_0).find(Nt=>Nt.series[0]==p),ft=dt!=null?dt.dir:0,st=g.fillTo(f,p,g.min,g.max,ft),yt=H(y(st,A,N,U)),xt,Tt,At,jt=L,pe=H(g.width*He),Yt=!1,Se=null,ye=null,de=null,gn=null;h!=null&&(pe==0||d!=null)&&(Yt=!0,Se=h.values(f,p,_,m),ye=new Map,new Set(Se).forEach(Nt=>{Nt!=null&&ye.set(Nt,new Path2D)}),pe>0&&(de=d.values(f,p,_,m),gn=new Map,new Set(de).forEach(Nt=>{Nt!=null&&gn.set(Nt,new Path2D)})));let{x0:sn,size:Pn}=c;if(sn!=null&&Pn!=null){$=1,x=sn.values(f,p,_,m),sn.unit==2&&(x=x.map(me=>f.posToVal(w+me*L,v.key,!0)));let Nt=Pn.values(f,p,_,m);Pn.unit==2?Tt=Nt[0]*L:Tt=S(Nt[0],v,L,w)-S(0,v,L,w),jt=pM(x,T,S,v,L,w,jt),At=jt-Tt+P}else jt=pM(x,T,S,v,L,w,jt),At=jt*o+P,Tt=jt-At;At<1&&(At=0),pe>=Tt/2&&(pe=0),At<5&&(H=SM);let je=At>0,Xn=jt-At-(je?pe:0);Tt=H(o0(Xn,D,z)),xt=($==0?Tt/2:$==Y?0:Tt)-$*Y*(($==0?P/2:0)+(je?pe/2:0));let Ne={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bn=Yt?null:new Path2D,Mn=null;if(dt!=null)Mn=f.data[dt.series[1]];else{let{y0:Nt,y1:ie}=c;Nt!=null&&ie!=null&&(T=ie.values(f,p,_,m),Mn=Nt.values(f,p,_,m))}let In=B*Tt,W=Q*Tt;for(let Nt=Y==1?_:m;Nt>=_&&Nt<=m;Nt+=Y){let ie=T[Nt];if(ie==null)continue;if(Mn!=null){let Z=Mn[Nt]??0;if(ie-Z==0)continue;yt=y(Z,A,N,U)}let me=v.distr!=2||c!=null?x[Nt]:Nt,Ct=S(me,v,L,w),Ke=y(Fe(ie,st),A,N,U),Xt=H(Ct-xt),ee=H(Pi(Ke,yt)),O=H(Fs(Ke,yt)),R=ee-O;if(ie!=null){let Z=ie<0?W:In,mt=ie<0?In:W;Yt?(pe>0&&de[Nt]!=null&&j(gn.get(de[Nt]),Xt,O+rs(pe/2),Tt,Pi(0,R-pe),Z,mt),Se[Nt]!=null&&j(ye.get(Se[Nt]),Xt,O+rs(pe/2),Tt,Pi(0,R-pe),Z,mt)):j(Bn,Xt,O+rs(pe/2),Tt,Pi(0,R-pe),Z,mt),et(f,p,Nt,Xt-pe/2,O,Tt+pe,R)}}return pe>0?Ne.stroke=Yt?gn:Bn:Yt||(Ne._fill=g.width==0?g._fill:g._stroke??g._fill,Ne.width=0),Ne.fill=Yt?ye:Bn,Ne})}function L2(n,t){let e=Fe(t?.alignGaps,0);return(i,s,r,o)=>jo(i,s,(a,l,c,u,h,d,f,p,_,m,g)=>{[r,o]=If(c,r,o);let x=a.pxRound,T=B=>x(d(B,u,m,p)),v=B=>x(f(B,h,g,_)),A,S,y;u.ori==0?(A=Of,y=gl,S=jM):(A=Ff,y=xl,S=JM);let w=u.dir*(u.ori==0?1:-1),U=T(l[w==1?r:o]),L=U,N=[],H=[];for(let B=w==1?r:o;B>=r&&B<=o;B+=w)if(c[B]!=null){let Y=l[B],j=T(Y);N.push(L=j),H.push(v(c[B]))}let $={stroke:n(N,H,A,y,S,x),fill:null,clip:null,band:null,gaps:null,flags:pl},P=$.stroke,[z,D]=S0(i,s);if(a.fill!=null||z!=0){let B=$.fill=new Path2D(P),Q=a.fillTo(i,s,a.min,a.max,z),Y=v(Q);y(B,L,Y),y(B,U,Y)}if(!a.spanGaps){let B=[];B.push(...w0(l,c,r,o,w,T,e)),$.gaps=B=a.gaps(i,s,r,o,B),$.clip=Uf(B,u.ori,p,_,m,g)}return D!=0&&($.band=D==2?[Fr(i,s,r,o,P,-1),Fr(i,s,r,o,P,1)]:Fr(i,s,r,o,P,D)),$})}function D2(n){return L2(N2,n)}function N2(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var u0=new Set;function mM(){for(let n of u0)n.syncRect(!0)}ml&&(Yo(p3,ul,mM),Yo(m3,ul,mM,!0),Yo(Rf,ul,()=>{ri.pxRatio=He}));var U2=tS(),O2=KM();function gM(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>h0(r,o,t,e))}function F2(n,t){return n.map((e,i)=>i==0?{}:Fn({},t,e))}function h0(n,t,e,i){return Fn({},t==0?e:i,n)}function eS(n,t,e){return t==null?dl:[t,e]}var B2=eS;function k2(n,t,e){return t==null?dl:Cf(t,e,g0,!0)}function nS(n,t,e,i){return t==null?dl:Lf(t,e,n.scales[i].log,!1)}var z2=nS;function iS(n,t,e,i){return t==null?dl:m0(t,e,n.scales[i].log,!1)}var H2=iS;function G2(n,t,e,i,s){let r=Pi(Yb(n),Yb(t)),o=t-n,a=Os(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?go.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function xM(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=$n((e=+s)*He))+"px"),[n,t,e]}function V2(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=en(t[2]*He,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ri(n,t,e){let i={mode:Fe(n.mode,1)},s=i.mode;function r(E,C,F,k){let X=C.valToPct(E);return k+F*(C.dir==-1?1-X:X)}function o(E,C,F,k){let X=C.valToPct(E);return k+F*(C.dir==-1?X:1-X)}function a(E,C,F,k){return C.ori==0?r(E,C,F,k):o(E,C,F,k)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=xs(jI);if(n.id!=null&&(c.id=n.id),ss(c,n.class),n.title){let E=xs(QI,c);E.textContent=n.title}let u=Us("canvas"),h=i.ctx=u.getContext("2d"),d=xs(t3,c);Yo("click",d,E=>{E.target===p&&(on!=la||xn!=ca)&&ei.click(i,E)},!0);let f=i.under=xs(e3,d);d.appendChild(u);let p=i.over=xs(n3,d);n=fl(n);let _=+Fe(n.pxAlign,1),m=fM(_);(n.plugins||[]).forEach(E=>{E.opts&&(n=E.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?gM(n.series||[],oM,hM,!1):F2(n.series||[null],uM),T=i.axes=gM(n.axes||[],rM,lM,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(E=>{E.fill=De(E.fill||null),E.dir=Fe(E.dir,-1)});let S=s==2?x[1].facets[0].scale:x[0].scale,y={axes:pr,series:Re},w=(n.drawOrder||["axes","series"]).map(E=>y[E]);function U(E){let C=E.distr==3?F=>Or(F>0?F:E.clamp(i,F,E.min,E.max,E.key)):E.distr==4?F=>Kg(F,E.asinh):E.distr==100?F=>E.fwd(F):F=>F;return F=>{let k=C(F),{_min:X,_max:tt}=E,ht=tt-X;return(k-X)/ht}}function L(E){let C=v[E];if(C==null){let F=(n.scales||uu)[E]||uu;if(F.from!=null){L(F.from);let k=Fn({},v[F.from],F,{key:E});k.valToPct=U(k),v[E]=k}else{C=v[E]=Fn({},E==S?$M:E2,F),C.key=E;let k=C.time,X=C.range,tt=mo(X);if((E!=S||s==2&&!k)&&(tt&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?$b:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?$b:{mode:1,hard:X[1],soft:X[1]}},tt=!1),!tt&&Nf(X))){let ht=X;X=(_t,Et,kt)=>Et==null?dl:Cf(Et,kt,ht)}C.range=De(X||(k?B2:E==S?C.distr==3?z2:C.distr==4?H2:eS:C.distr==3?nS:C.distr==4?iS:k2)),C.auto=De(tt?!1:C.auto),C.clamp=De(C.clamp||w2),C._min=C._max=null,C.valToPct=U(C)}}}L("x"),L("y"),s==1&&x.forEach(E=>{L(E.scale)}),T.forEach(E=>{L(E.scale)});for(let E in n.scales)L(E);let N=v[S],H=N.distr,$,P;N.ori==0?(ss(c,JI),$=r,P=o):(ss(c,KI),$=o,P=r);let z={};for(let E in v){let C=v[E];(C.min!=null||C.max!=null)&&(z[E]={min:C.min,max:C.max},C.min=C.max=null)}let D=n.tzDate||(E=>new Date($n(E/g))),B=n.fmtDate||y0,Q=g==1?J3(D):t2(D),Y=nM(D,eM(g==1?j3:Q3,B)),j=sM(D,iM(n2,B)),et=[],dt=i.legend=Fn({},r2,n.legend),ft=i.cursor=Fn({},h2,{drag:{y:s==2}},n.cursor),st=dt.show,yt=ft.show,xt=dt.markers;dt.idxs=et,xt.width=De(xt.width),xt.dash=De(xt.dash),xt.stroke=De(xt.stroke),xt.fill=De(xt.fill);let Tt,At,jt,pe=[],Yt=[],Se,ye=!1,de={};if(dt.live){let E=x[1]?x[1].values:null;ye=E!=null,Se=ye?E(i,1,0):{_:0};for(let C in Se)de[C]=f0}if(st)if(Tt=Us("table",l3,c),jt=Us("tbody",null,Tt),dt.mount(i,Tt),ye){At=Us("thead",null,Tt,jt);let E=Us("tr",null,At);Us("th",null,E);for(var gn in Se)Us("th",Lb,E).textContent=gn}else ss(Tt,u3),dt.live&&ss(Tt,c3);let sn={show:!0},Pn={show:!1};function je(E,C){if(C==0&&(ye||!dt.live||s==2))return dl;let F=[],k=Us("tr",h3,jt,jt.childNodes[C]);ss(k,E.class),E.show||ss(k,Xo);let X=Us("th",null,k);if(xt.show){let _t=xs(d3,X);if(C>0){let Et=xt.width(i,C);Et&&(_t.style.border=Et+"px "+xt.dash(i,C)+" "+xt.stroke(i,C)),_t.style.background=xt.fill(i,C)}}let tt=xs(Lb,X);E.label instanceof HTMLElement?tt.appendChild(E.label):tt.textContent=E.label,C>0&&(xt.show||(tt.style.color=E.width>0?xt.stroke(i,C):xt.fill(i,C)),Ne("click",X,_t=>{if(ft._lock)return;re(_t);let Et=x.indexOf(E);if((_t.ctrlKey||_t.metaKey)!=dt.isolate){let kt=x.some((zt,Gt)=>Gt>0&&Gt!=Et&&zt.show);x.forEach((zt,Gt)=>{Gt>0&&Vs(Gt,kt?Gt==Et?sn:Pn:sn,!0,Un.setSeries)})}else Vs(Et,{show:!E.show},!0,Un.setSeries)},!1),oe&&Ne(Ob,X,_t=>{ft._lock||(re(_t),Vs(x.indexOf(E),ha,!0,Un.setSeries))},!1));for(var ht in Se){let _t=Us("td",f3,k);_t.textContent="--",F.push(_t)}return[k,F]}let Xn=new Map;function Ne(E,C,F,k=!0){let X=Xn.get(C)||{},tt=ft.bind[E](i,C,F,k);tt&&(Yo(E,C,X[E]=tt),Xn.set(C,X))}function Bn(E,C,F){let k=Xn.get(C)||{};for(let X in k)(E==null||X==E)&&(r0(X,C,k[X]),delete k[X]);E==null&&Xn.delete(C)}let Mn=0,In=0,W=0,Nt=0,ie=0,me=0,Ct=ie,Ke=me,Xt=W,ee=Nt,O=0,R=0,Z=0,mt=0;i.bbox={};let ct=!1,St=!1,wt=!1,rt=!1,at=!1,vt=!1;function V(E,C,F){(F||E!=i.width||C!=i.height)&&lt(E,C),ve(!1),wt=!0,St=!0,ai()}function lt(E,C){i.width=Mn=W=E,i.height=In=Nt=C,ie=me=0,Rt(),Zt();let F=i.bbox;O=F.left=$o(ie*He,.5),R=F.top=$o(me*He,.5),Z=F.width=$o(W*He,.5),mt=F.height=$o(Nt*He,.5)}let ot=3;function Pt(){let E=!1,C=0;for(;!E;){C++;let F=ra(C),k=Gs(C);E=C==ot||F&&k,E||(lt(i.width,i.height),St=!0)}}function Mt({width:E,height:C}){V(E,C)}i.setSize=Mt;function Rt(){let E=!1,C=!1,F=!1,k=!1;T.forEach((X,tt)=>{if(X.show&&X._show){let{side:ht,_size:_t}=X,Et=ht%2,kt=X.label!=null?X.labelSize:0,zt=_t+kt;zt>0&&(Et?(W-=zt,ht==3?(ie+=zt,k=!0):F=!0):(Nt-=zt,ht==0?(me+=zt,E=!0):C=!0))}}),zs[0]=E,zs[1]=F,zs[2]=C,zs[3]=k,W-=ys[1]+ys[3],ie+=ys[3],Nt-=ys[2]+ys[0],me+=ys[0]}function Zt(){let E=ie+W,C=me+Nt,F=ie,k=me;function X(tt,ht){switch(tt){case 1:return E+=ht,E-ht;case 2:return C+=ht,C-ht;case 3:return F-=ht,F+ht;case 0:return k-=ht,k+ht}}T.forEach((tt,ht)=>{if(tt.show&&tt._show){let _t=tt.side;tt._pos=X(_t,tt._size),tt.label!=null&&(tt._lpos=X(_t,tt.labelSize))}})}if(ft.dataIdx==null){let E=ft.hover,C=E.skip=new Set(E.skip??[]);C.add(void 0);let F=E.prox=De(E.prox),k=E.bias??=0;ft.dataIdx=(X,tt,ht,_t)=>{if(tt==0)return ht;let Et=ht,kt=F(X,tt,ht,_t)??tn,zt=kt>=0&&kt<tn,Gt=N.ori==0?W:Nt,fe=ft.left,Be=t[0],Ue=t[tt];if(C.has(Ue[ht])){Et=null;let Ce=null,se=null,Jt;if(k==0||k==-1)for(Jt=ht;Ce==null&&Jt-- >0;)C.has(Ue[Jt])||(Ce=Jt);if(k==0||k==1)for(Jt=ht;se==null&&Jt++<Ue.length;)C.has(Ue[Jt])||(se=Jt);if(Ce!=null||se!=null)if(zt){let ln=Ce==null?-1/0:$(Be[Ce],N,Gt,0),En=se==null?1/0:$(Be[se],N,Gt,0),Jn=fe-ln,Je=En-fe;Jn<=Je?Jn<=kt&&(Et=Ce):Je<=kt&&(Et=se)}else Et=se==null?Ce:Ce==null?se:ht-Ce<=se-ht?Ce:se}else zt&&qn(fe-$(Be[ht],N,Gt,0))>kt&&(Et=null);return Et}}let re=E=>{ft.event=E};ft.idxs=et,ft._lock=!1;let pt=ft.points;pt.show=De(pt.show),pt.size=De(pt.size),pt.stroke=De(pt.stroke),pt.width=De(pt.width),pt.fill=De(pt.fill);let Wt=i.focus=Fn({},n.focus||{alpha:.3},ft.focus),oe=Wt.prox>=0,Dt=oe&&pt.one,_e=[],rn=[],xi=[];function Nl(E,C){let F=pt.show(i,C);if(F instanceof HTMLElement)return ss(F,a3),ss(F,E.class),cr(F,-10,-10,W,Nt),p.insertBefore(F,_e[C]),F}function na(E,C){if(s==1||C>0){let F=s==1&&v[E.scale].time,k=E.value;E.value=F?Jb(k)?sM(D,iM(k,B)):k||j:k||b2,E.label=E.label||(F?f2:d2)}if(Dt||C>0){E.width=E.width==null?1:E.width,E.paths=E.paths||U2||E3,E.fillTo=De(E.fillTo||T2),E.pxAlign=+Fe(E.pxAlign,_),E.pxRound=fM(E.pxAlign),E.stroke=De(E.stroke||null),E.fill=De(E.fill||null),E._stroke=E._fill=E._paths=E._focus=null;let F=M2(Pi(1,E.width),1),k=E.points=Fn({},{size:F,width:Pi(1,F*.2),stroke:E.stroke,space:F*2,paths:O2,_stroke:null,_fill:null},E.points);k.show=De(k.show),k.filter=De(k.filter),k.fill=De(k.fill),k.stroke=De(k.stroke),k.paths=De(k.paths),k.pxAlign=E.pxAlign}if(st){let F=je(E,C);pe.splice(C,0,F[0]),Yt.splice(C,0,F[1]),dt.values.push(null)}if(yt){et.splice(C,0,null);let F=null;Dt?C==0&&(F=Nl(E,C)):C>0&&(F=Nl(E,C)),_e.splice(C,0,F),rn.splice(C,0,0),xi.splice(C,0,0)}jn("addSeries",C)}function pp(E,C){C=C??x.length,E=s==1?h0(E,C,oM,hM):h0(E,C,{},uM),x.splice(C,0,E),na(x[C],C)}i.addSeries=pp;function Su(E){if(x.splice(E,1),st){dt.values.splice(E,1),Yt.splice(E,1);let C=pe.splice(E,1)[0];Bn(null,C.firstChild),C.remove()}yt&&(et.splice(E,1),_e.splice(E,1)[0].remove(),rn.splice(E,1),xi.splice(E,1)),jn("delSeries",E)}i.delSeries=Su;let zs=[!1,!1,!1,!1];function hr(E,C){if(E._show=E.show,E.show){let F=E.side%2,k=v[E.scale];k==null&&(E.scale=F?x[1].scale:S,k=v[E.scale]);let X=k.time;E.size=De(E.size),E.space=De(E.space),E.rotate=De(E.rotate),mo(E.incrs)&&E.incrs.forEach(ht=>{!go.has(ht)&&go.set(ht,TM(ht))}),E.incrs=De(E.incrs||(k.distr==2?X3:X?g==1?Z3:K3:qo)),E.splits=De(E.splits||(X&&k.distr==1?Q:k.distr==3?a0:k.distr==4?g2:m2)),E.stroke=De(E.stroke),E.grid.stroke=De(E.grid.stroke),E.ticks.stroke=De(E.ticks.stroke),E.border.stroke=De(E.border.stroke);let tt=E.values;E.values=mo(tt)&&!mo(tt[0])?De(tt):X?mo(tt)?nM(D,eM(tt,B)):Jb(tt)?e2(D,tt):tt||Y:tt||p2,E.filter=De(E.filter||(k.distr>=3&&k.log==10?y2:k.distr==3&&k.log==2?v2:wM)),E.font=xM(E.font),E.labelFont=xM(E.labelFont),E._size=E.size(i,null,C,0),E._space=E._rotate=E._incrs=E._found=E._splits=E._values=null,E._size>0&&(zs[C]=!0,E._el=xs(i3,d))}}function dr(E,C,F,k){let[X,tt,ht,_t]=F,Et=C%2,kt=0;return Et==0&&(_t||tt)&&(kt=C==0&&!X||C==2&&!ht?$n(rM.size/3):0),Et==1&&(X||ht)&&(kt=C==1&&!tt||C==3&&!_t?$n(lM.size/2):0),kt}let Ul=i.padding=(n.padding||[dr,dr,dr,dr]).map(E=>De(Fe(E,dr))),ys=i._padding=Ul.map((E,C)=>E(i,C,zs,0)),Sn,Rn=null,Cn=null,Hs=s==1?x[0].idxs:null,Wi=null,zr=!1;function Ol(E,C){if(t=E??[],i.data=i._data=t,s==2){Sn=0;for(let F=1;F<x.length;F++)Sn+=t[F][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Wi=t[0],Sn=Wi.length;let F=t;if(H==2){F=t.slice();let k=F[0]=Array(Sn);for(let X=0;X<Sn;X++)k[X]=X}i._data=t=F}if(ve(!0),jn("setData"),H==2&&(wt=!0),C!==!1){let F=N;F.auto(i,zr)?Fl():Vr(S,F.min,F.max),rt=rt||ft.left>=0,vt=!0,ai()}}i.setData=Ol;function Fl(){zr=!0;let E,C;s==1&&(Sn>0?(Rn=Hs[0]=0,Cn=Hs[1]=Sn-1,E=t[0][Rn],C=t[0][Cn],H==2?(E=Rn,C=Cn):E==C&&(H==3?[E,C]=Lf(E,E,N.log,!1):H==4?[E,C]=m0(E,E,N.log,!1):N.time?C=E+$n(86400/g):[E,C]=Cf(E,C,g0,!0))):(Rn=Hs[0]=E=null,Cn=Hs[1]=C=null)),Vr(S,E,C)}let ia,Hr,sa,I,q,it,J,K,It,Ut;function Lt(E,C,F,k,X,tt){E??=Nb,F??=_0,k??="butt",X??=Nb,tt??="round",E!=ia&&(h.strokeStyle=ia=E),X!=Hr&&(h.fillStyle=Hr=X),C!=sa&&(h.lineWidth=sa=C),tt!=q&&(h.lineJoin=q=tt),k!=it&&(h.lineCap=it=k),F!=I&&h.setLineDash(I=F)}function Ft(E,C,F,k){C!=Hr&&(h.fillStyle=Hr=C),E!=J&&(h.font=J=E),F!=K&&(h.textAlign=K=F),k!=It&&(h.textBaseline=It=k)}function qt(E,C,F,k,X=0){if(k.length>0&&E.auto(i,zr)&&(C==null||C.min==null)){let tt=Fe(Rn,0),ht=Fe(Cn,k.length-1),_t=F.min==null?y3(k,tt,ht,X,E.distr==3):[F.min,F.max];E.min=Fs(E.min,F.min=_t[0]),E.max=Pi(E.max,F.max=_t[1])}}let le={min:null,max:null};function Ae(){for(let k in v){let X=v[k];z[k]==null&&(X.min==null||z[S]!=null&&X.auto(i,zr))&&(z[k]=le)}for(let k in v){let X=v[k];z[k]==null&&X.from!=null&&z[X.from]!=null&&(z[k]=le)}z[S]!=null&&ve(!0);let E={};for(let k in z){let X=z[k];if(X!=null){let tt=E[k]=fl(v[k],R3);if(X.min!=null)Fn(tt,X);else if(k!=S||s==2)if(Sn==0&&tt.from==null){let ht=tt.range(i,null,null,k);tt.min=ht[0],tt.max=ht[1]}else tt.min=tn,tt.max=-tn}}if(Sn>0){x.forEach((k,X)=>{if(s==1){let tt=k.scale,ht=z[tt];if(ht==null)return;let _t=E[tt];if(X==0){let Et=_t.range(i,_t.min,_t.max,tt);_t.min=Et[0],_t.max=Et[1],Rn=Os(_t.min,t[0]),Cn=Os(_t.max,t[0]),Cn-Rn>1&&(t[0][Rn]<_t.min&&Rn++,t[0][Cn]>_t.max&&Cn--),k.min=Wi[Rn],k.max=Wi[Cn]}else k.show&&k.auto&&qt(_t,ht,k,t[X],k.sorted);k.idxs[0]=Rn,k.idxs[1]=Cn}else if(X>0&&k.show&&k.auto){let[tt,ht]=k.facets,_t=tt.scale,Et=ht.scale,[kt,zt]=t[X],Gt=E[_t],fe=E[Et];Gt!=null&&qt(Gt,z[_t],tt,kt,tt.sorted),fe!=null&&qt(fe,z[Et],ht,zt,ht.sorted),k.min=ht.min,k.max=ht.max}});for(let k in E){let X=E[k],tt=z[k];if(X.from==null&&(tt==null||tt.min==null)){let ht=X.range(i,X.min==tn?null:X.min,X.max==-tn?null:X.max,k);X.min=ht[0],X.max=ht[1]}}}for(let k in E){let X=E[k];if(X.from!=null){let tt=E[X.from];if(tt.min==null)X.min=X.max=null;else{let ht=X.range(i,tt.min,tt.max,k);X.min=ht[0],X.max=ht[1]}}}let C={},F=!1;for(let k in E){let X=E[k],tt=v[k];if(tt.min!=X.min||tt.max!=X.max){tt.min=X.min,tt.max=X.max;let ht=tt.distr;tt._min=ht==3?Or(tt.min):ht==4?Kg(tt.min,tt.asinh):ht==100?tt.fwd(tt.min):tt.min,tt._max=ht==3?Or(tt.max):ht==4?Kg(tt.max,tt.asinh):ht==100?tt.fwd(tt.max):tt.max,C[k]=F=!0}}if(F){x.forEach((k,X)=>{s==2?X>0&&C.y&&(k._paths=null):C[k.scale]&&(k._paths=null)});for(let k in C)wt=!0,jn("setScale",k);yt&&ft.left>=0&&(rt=vt=!0)}for(let k in z)z[k]=null}function $t(E){let C=o0(Rn-1,0,Sn-1),F=o0(Cn+1,0,Sn-1);for(;E[C]==null&&C>0;)C--;for(;E[F]==null&&F<Sn-1;)F++;return[C,F]}function Re(){if(Sn>0){let E=x.some(C=>C._focus)&&Ut!=Wt.alpha;E&&(h.globalAlpha=Ut=Wt.alpha),x.forEach((C,F)=>{if(F>0&&C.show&&(yn(F,!1),yn(F,!0),C._paths==null)){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha);let X=s==2?[0,t[F][0].length-1]:$t(t[F]);C._paths=C.paths(i,F,X[0],X[1]),Ut!=k&&(h.globalAlpha=Ut=k)}}),x.forEach((C,F)=>{if(F>0&&C.show){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha),C._paths!=null&&$e(F,!1);{let X=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,F,Rn,Cn,X),ht=C.points.filter(i,F,tt,X);(tt||ht)&&(C.points._paths=C.points.paths(i,F,Rn,Cn,ht),$e(F,!0))}Ut!=k&&(h.globalAlpha=Ut=k),jn("drawSeries",F)}}),E&&(h.globalAlpha=Ut=1)}}function yn(E,C){let F=C?x[E].points:x[E];F._stroke=F.stroke(i,E),F._fill=F.fill(i,E)}function $e(E,C){let F=C?x[E].points:x[E],{stroke:k,fill:X,clip:tt,flags:ht,_stroke:_t=F._stroke,_fill:Et=F._fill,_width:kt=F.width}=F._paths;kt=en(kt*He,3);let zt=null,Gt=kt%2/2;C&&Et==null&&(Et=kt>0?"#fff":_t);let fe=F.pxAlign==1&&Gt>0;if(fe&&h.translate(Gt,Gt),!C){let Be=O-kt/2,Ue=R-kt/2,Ce=Z+kt,se=mt+kt;zt=new Path2D,zt.rect(Be,Ue,Ce,se)}C?Ht(_t,kt,F.dash,F.cap,Et,k,X,ht,tt):qe(E,_t,kt,F.dash,F.cap,Et,k,X,ht,zt,tt),fe&&h.translate(-Gt,-Gt)}function qe(E,C,F,k,X,tt,ht,_t,Et,kt,zt){let Gt=!1;Et!=0&&A.forEach((fe,Be)=>{if(fe.series[0]==E){let Ue=x[fe.series[1]],Ce=t[fe.series[1]],se=(Ue._paths||uu).band;mo(se)&&(se=fe.dir==1?se[0]:se[1]);let Jt,ln=null;Ue.show&&se&&b3(Ce,Rn,Cn)?(ln=fe.fill(i,Be)||tt,Jt=Ue._paths.clip):se=null,Ht(C,F,k,X,ln,ht,_t,Et,kt,zt,Jt,se),Gt=!0}}),Gt||Ht(C,F,k,X,tt,ht,_t,Et,kt,zt)}let kn=pl|c0;function Ht(E,C,F,k,X,tt,ht,_t,Et,kt,zt,Gt){Lt(E,C,F,k,X),(Et||kt||Gt)&&(h.save(),Et&&h.clip(Et),kt&&h.clip(kt)),Gt?(_t&kn)==kn?(h.clip(Gt),zt&&h.clip(zt),Ie(X,ht),Ln(E,tt,C)):_t&c0?(Ie(X,ht),h.clip(Gt),Ln(E,tt,C)):_t&pl&&(h.save(),h.clip(Gt),zt&&h.clip(zt),Ie(X,ht),h.restore(),Ln(E,tt,C)):(Ie(X,ht),Ln(E,tt,C)),(Et||kt||Gt)&&h.restore()}function Ln(E,C,F){F>0&&(C instanceof Map?C.forEach((k,X)=>{h.strokeStyle=ia=X,h.stroke(k)}):C!=null&&E&&h.stroke(C))}function Ie(E,C){C instanceof Map?C.forEach((F,k)=>{h.fillStyle=Hr=k,h.fill(F)}):C!=null&&E&&h.fill(C)}function fr(E,C,F,k){let X=T[E],tt;if(k<=0)tt=[0,0];else{let ht=X._space=X.space(i,E,C,F,k),_t=X._incrs=X.incrs(i,E,C,F,k,ht);tt=G2(C,F,_t,k,ht)}return X._found=tt}function Dn(E,C,F,k,X,tt,ht,_t,Et,kt){let zt=ht%2/2;_==1&&h.translate(zt,zt),Lt(_t,ht,Et,kt,_t),h.beginPath();let Gt,fe,Be,Ue,Ce=X+(k==0||k==3?-tt:tt);F==0?(fe=X,Ue=Ce):(Gt=X,Be=Ce);for(let se=0;se<E.length;se++)C[se]!=null&&(F==0?Gt=Be=E[se]:fe=Ue=E[se],h.moveTo(Gt,fe),h.lineTo(Be,Ue));h.stroke(),_==1&&h.translate(-zt,-zt)}function ra(E){let C=!0;return T.forEach((F,k)=>{if(!F.show)return;let X=v[F.scale];if(X.min==null){F._show&&(C=!1,F._show=!1,ve(!1));return}else F._show||(C=!1,F._show=!0,ve(!1));let tt=F.side,ht=tt%2,{min:_t,max:Et}=X,[kt,zt]=fr(k,_t,Et,ht==0?W:Nt);if(zt==0)return;let Gt=X.distr==2,fe=F._splits=F.splits(i,k,_t,Et,kt,zt,Gt),Be=X.distr==2?fe.map(Jt=>Wi[Jt]):fe,Ue=X.distr==2?Wi[fe[1]]-Wi[fe[0]]:kt,Ce=F._values=F.values(i,F.filter(i,Be,k,zt,Ue),k,zt,Ue);F._rotate=tt==2?F.rotate(i,Ce,k,zt):0;let se=F._size;F._size=_s(F.size(i,Ce,k,E)),se!=null&&F._size!=se&&(C=!1)}),C}function Gs(E){let C=!0;return Ul.forEach((F,k)=>{let X=F(i,k,zs,E);X!=ys[k]&&(C=!1),ys[k]=X}),C}function pr(){for(let E=0;E<T.length;E++){let C=T[E];if(!C.show||!C._show)continue;let F=C.side,k=F%2,X,tt,ht=C.stroke(i,E),_t=F==0||F==3?-1:1,[Et,kt]=C._found;if(C.label!=null){let vi=C.labelGap*_t,Xi=$n((C._lpos+vi)*He);Ft(C.labelFont[0],ht,"center",F==2?"top":Db),h.save(),k==1?(X=tt=0,h.translate(Xi,$n(R+mt/2)),h.rotate((F==3?-Af:Af)/2)):(X=$n(O+Z/2),tt=Xi);let Ao=MM(C.label)?C.label(i,E,Et,kt):C.label;h.fillText(Ao,X,tt),h.restore()}if(kt==0)continue;let zt=v[C.scale],Gt=k==0?Z:mt,fe=k==0?O:R,Be=C._splits,Ue=zt.distr==2?Be.map(vi=>Wi[vi]):Be,Ce=zt.distr==2?Wi[Be[1]]-Wi[Be[0]]:Et,se=C.ticks,Jt=C.border,ln=se.show?se.size:0,En=$n(ln*He),Jn=$n((C.alignTo==2?C._size-ln-C.gap:C.gap)*He),Je=C._rotate*-Af/180,Tn=m(C._pos*He),$i=(En+Jn)*_t,yi=Tn+$i;tt=k==0?yi:0,X=k==1?yi:0;let as=C.font[0],vs=C.align==1?ll:C.align==2?Zg:Je>0?ll:Je<0?Zg:k==0?"center":F==3?Zg:ll,$s=Je||k==1?"middle":F==2?"top":Db;Ft(as,ht,vs,$s);let qi=C.font[1]*C.lineGap,ls=Be.map(vi=>m(a(vi,zt,Gt,fe))),bs=C._values;for(let vi=0;vi<bs.length;vi++){let Xi=bs[vi];if(Xi!=null){k==0?X=ls[vi]:tt=ls[vi],Xi=""+Xi;let Ao=Xi.indexOf(`
`)==-1?[Xi]:Xi.split(/\n/gm);for(let bi=0;bi<Ao.length;bi++){let Sx=Ao[bi];Je?(h.save(),h.translate(X,tt+bi*qi),h.rotate(Je),h.fillText(Sx,0,0),h.restore()):h.fillText(Sx,X,tt+bi*qi)}}}se.show&&Dn(ls,se.filter(i,Ue,E,kt,Ce),k,F,Tn,En,en(se.width*He,3),se.stroke(i,E),se.dash,se.cap);let qs=C.grid;qs.show&&Dn(ls,qs.filter(i,Ue,E,kt,Ce),k,k==0?2:1,k==0?R:O,k==0?mt:Z,en(qs.width*He,3),qs.stroke(i,E),qs.dash,qs.cap),Jt.show&&Dn([Tn],[1],k==0?1:0,k==0?1:2,k==1?R:O,k==1?mt:Z,en(Jt.width*He,3),Jt.stroke(i,E),Jt.dash,Jt.cap)}jn("drawAxes")}function ve(E){x.forEach((C,F)=>{F>0&&(C._paths=null,E&&(s==1?(C.min=null,C.max=null):C.facets.forEach(k=>{k.min=null,k.max=null})))})}let wn=!1,_i=!1,Xe=[];function Nn(){_i=!1;for(let E=0;E<Xe.length;E++)jn(...Xe[E]);Xe.length=0}function ai(){wn||(U3(rx),wn=!0)}function wu(E,C=!1){wn=!0,_i=C,E(i),rx(),C&&Xe.length>0&&queueMicrotask(Nn)}i.batch=wu;function rx(){if(ct&&(Ae(),ct=!1),wt&&(Pt(),wt=!1),St){if(mn(f,ll,ie),mn(f,"top",me),mn(f,ou,W),mn(f,au,Nt),mn(p,ll,ie),mn(p,"top",me),mn(p,ou,W),mn(p,au,Nt),mn(d,ou,Mn),mn(d,au,In),u.width=$n(Mn*He),u.height=$n(In*He),T.forEach(({_el:E,_show:C,_size:F,_pos:k,side:X})=>{if(E!=null)if(C){let tt=X===3||X===0?F:0,ht=X%2==1;mn(E,ht?"left":"top",k-tt),mn(E,ht?"width":"height",F),mn(E,ht?"top":"left",ht?me:ie),mn(E,ht?"height":"width",ht?Nt:W),s0(E,Xo)}else ss(E,Xo)}),ia=Hr=sa=q=it=J=K=It=I=null,Ut=1,zl(!0),ie!=Ct||me!=Ke||W!=Xt||Nt!=ee){ve(!1);let E=W/Xt,C=Nt/ee;if(yt&&!rt&&ft.left>=0){ft.left*=E,ft.top*=C,oa&&cr(oa,$n(ft.left),0,W,Nt),aa&&cr(aa,0,$n(ft.top),W,Nt);for(let F=0;F<_e.length;F++){let k=_e[F];k!=null&&(rn[F]*=E,xi[F]*=C,cr(k,_s(rn[F]),_s(xi[F]),W,Nt))}}if(an.show&&!at&&an.left>=0&&an.width>0){an.left*=E,an.width*=E,an.top*=C,an.height*=C;for(let F in vp)mn(ua,F,an[F])}Ct=ie,Ke=me,Xt=W,ee=Nt}jn("setSize"),St=!1}Mn>0&&In>0&&(h.clearRect(0,0,u.width,u.height),jn("drawClear"),w.forEach(E=>E()),jn("draw")),an.show&&at&&(Eu(an),at=!1),yt&&rt&&(To(null,!0,!1),rt=!1),dt.show&&dt.live&&vt&&(_p(),vt=!1),l||(l=!0,i.status=1,jn("ready")),zr=!1,wn=!1}i.redraw=(E,C)=>{wt=C||!1,E!==!1?Vr(S,N.min,N.max):ai()};function mp(E,C){let F=v[E];if(F.from==null){if(Sn==0){let k=F.range(i,C.min,C.max,E);C.min=k[0],C.max=k[1]}if(C.min>C.max){let k=C.min;C.min=C.max,C.max=k}if(Sn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;E==S&&F.distr==2&&Sn>0&&(C.min=Os(C.min,t[0]),C.max=Os(C.max,t[0]),C.min==C.max&&C.max++),z[E]=C,ct=!0,ai()}}i.setScale=mp;let gp,xp,oa,aa,ox,ax,la,ca,lx,cx,on,xn,Gr=!1,ei=ft.drag,Yn=ei.x,Zn=ei.y;yt&&(ft.x&&(gp=xs(r3,p)),ft.y&&(xp=xs(o3,p)),N.ori==0?(oa=gp,aa=xp):(oa=xp,aa=gp),on=ft.left,xn=ft.top);let an=i.select=Fn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ua=an.show?xs(s3,an.over?p:f):null;function Eu(E,C){if(an.show){for(let F in E)an[F]=E[F],F in vp&&mn(ua,F,E[F]);C!==!1&&jn("setSelect")}}i.setSelect=Eu;function o1(E){if(x[E].show)st&&s0(pe[E],Xo);else if(st&&ss(pe[E],Xo),yt){let F=Dt?_e[0]:_e[E];F!=null&&cr(F,-10,-10,W,Nt)}}function Vr(E,C,F){mp(E,{min:C,max:F})}function Vs(E,C,F,k){C.focus!=null&&h1(E),C.show!=null&&x.forEach((X,tt)=>{tt>0&&(E==tt||E==null)&&(X.show=C.show,o1(tt),s==2?(Vr(X.facets[0].scale,null,null),Vr(X.facets[1].scale,null,null)):Vr(X.scale,null,null),ai())}),F!==!1&&jn("setSeries",E,C),k&&Hl("setSeries",i,E,C)}i.setSeries=Vs;function a1(E,C){Fn(A[E],C)}function l1(E,C){E.fill=De(E.fill||null),E.dir=Fe(E.dir,-1),C=C??A.length,A.splice(C,0,E)}function c1(E){E==null?A.length=0:A.splice(E,1)}i.addBand=l1,i.setBand=a1,i.delBand=c1;function u1(E,C){x[E].alpha=C,yt&&_e[E]!=null&&(_e[E].style.opacity=C),st&&pe[E]&&(pe[E].style.opacity=C)}let mr,Wr,Eo,ha={focus:!0};function h1(E){if(E!=Eo){let C=E==null,F=Wt.alpha!=1;x.forEach((k,X)=>{if(s==1||X>0){let tt=C||X==0||X==E;k._focus=C?null:tt,F&&u1(X,tt?1:Wt.alpha)}}),Eo=E,F&&ai()}}st&&oe&&Ne(Fb,Tt,E=>{ft._lock||(re(E),Eo!=null&&Vs(null,ha,!0,Un.setSeries))});function Ws(E,C,F){let k=v[C];F&&(E=E/He-(k.ori==1?me:ie));let X=W;k.ori==1&&(X=Nt,E=X-E),k.dir==-1&&(E=X-E);let tt=k._min,ht=k._max,_t=E/X,Et=tt+(ht-tt)*_t,kt=k.distr;return kt==3?hl(10,Et):kt==4?S3(Et,k.asinh):kt==100?k.bwd(Et):Et}function d1(E,C){let F=Ws(E,S,C);return Os(F,t[0],Rn,Cn)}i.valToIdx=E=>Os(E,t[0]),i.posToIdx=d1,i.posToVal=Ws,i.valToPos=(E,C,F)=>v[C].ori==0?r(E,v[C],F?Z:W,F?O:0):o(E,v[C],F?mt:Nt,F?R:0),i.setCursor=(E,C,F)=>{on=E.left,xn=E.top,To(null,C,F)};function ux(E,C){mn(ua,ll,an.left=E),mn(ua,ou,an.width=C)}function hx(E,C){mn(ua,"top",an.top=E),mn(ua,au,an.height=C)}let Bl=N.ori==0?ux:hx,kl=N.ori==1?ux:hx;function f1(){if(st&&dt.live)for(let E=s==2?1:0;E<x.length;E++){if(E==0&&ye)continue;let C=dt.values[E],F=0;for(let k in C)Yt[E][F++].firstChild.nodeValue=C[k]}}function _p(E,C){if(E!=null&&(E.idxs?E.idxs.forEach((F,k)=>{et[k]=F}):A3(E.idx)||et.fill(E.idx),dt.idx=et[0]),st&&dt.live){for(let F=0;F<x.length;F++)(F>0||s==1&&!ye)&&p1(F,et[F]);f1()}vt=!1,C!==!1&&jn("setLegend")}i.setLegend=_p;function p1(E,C){let F=x[E],k=E==0&&H==2?Wi:t[E],X;ye?X=F.values(i,E,C)??de:(X=F.value(i,C==null?null:k[C],E,C),X=X==null?de:{_:X}),dt.values[E]=X}function To(E,C,F){lx=on,cx=xn,[on,xn]=ft.move(i,on,xn),ft.left=on,ft.top=xn,yt&&(oa&&cr(oa,$n(on),0,W,Nt),aa&&cr(aa,0,$n(xn),W,Nt));let k,X=Rn>Cn;mr=tn,Wr=null;let tt=N.ori==0?W:Nt,ht=N.ori==1?W:Nt;if(on<0||Sn==0||X){k=ft.idx=null;for(let _t=0;_t<x.length;_t++){let Et=_e[_t];Et!=null&&cr(Et,-10,-10,W,Nt)}oe&&Vs(null,ha,!0,E==null&&Un.setSeries),dt.live&&(et.fill(k),vt=!0)}else{let _t,Et,kt;s==1&&(_t=N.ori==0?on:xn,Et=Ws(_t,S),k=ft.idx=Os(Et,t[0],Rn,Cn),kt=$(t[0][k],N,tt,0));let zt=-10,Gt=-10,fe=0,Be=0,Ue=!0,Ce="",se="";for(let Jt=s==2?1:0;Jt<x.length;Jt++){let ln=x[Jt],En=et[Jt],Jn=En==null?null:s==1?t[Jt][En]:t[Jt][1][En],Je=ft.dataIdx(i,Jt,k,Et),Tn=Je==null?null:s==1?t[Jt][Je]:t[Jt][1][Je];if(vt=vt||Tn!=Jn||Je!=En,et[Jt]=Je,Jt>0&&ln.show){let $i=Je==null?-10:Je==k?kt:$(s==1?t[0][Je]:t[Jt][0][Je],N,tt,0),yi=Tn==null?-10:P(Tn,s==1?v[ln.scale]:v[ln.facets[1].scale],ht,0);if(oe&&Tn!=null){let as=N.ori==1?on:xn,vs=qn(Wt.dist(i,Jt,Je,yi,as));if(vs<mr){let $s=Wt.bias;if($s!=0){let qi=Ws(as,ln.scale),ls=Tn>=0?1:-1,bs=qi>=0?1:-1;bs==ls&&(bs==1?$s==1?Tn>=qi:Tn<=qi:$s==1?Tn<=qi:Tn>=qi)&&(mr=vs,Wr=Jt)}else mr=vs,Wr=Jt}}if(vt||Dt){let as,vs;N.ori==0?(as=$i,vs=yi):(as=yi,vs=$i);let $s,qi,ls,bs,qs,vi,Xi=!0,Ao=pt.bbox;if(Ao!=null){Xi=!1;let bi=Ao(i,Jt);ls=bi.left,bs=bi.top,$s=bi.width,qi=bi.height}else ls=as,bs=vs,$s=qi=pt.size(i,Jt);if(vi=pt.fill(i,Jt),qs=pt.stroke(i,Jt),Dt)Jt==Wr&&mr<=Wt.prox&&(zt=ls,Gt=bs,fe=$s,Be=qi,Ue=Xi,Ce=vi,se=qs);else{let bi=_e[Jt];bi!=null&&(rn[Jt]=ls,xi[Jt]=bs,Wb(bi,$s,qi,Xi),Gb(bi,vi,qs),cr(bi,_s(ls),_s(bs),W,Nt))}}}}if(Dt){let Jt=Wt.prox,ln=Eo==null?mr<=Jt:mr>Jt||Wr!=Eo;if(vt||ln){let En=_e[0];En!=null&&(rn[0]=zt,xi[0]=Gt,Wb(En,fe,Be,Ue),Gb(En,Ce,se),cr(En,_s(zt),_s(Gt),W,Nt))}}}if(an.show&&Gr)if(E!=null){let[_t,Et]=Un.scales,[kt,zt]=Un.match,[Gt,fe]=E.cursor.sync.scales,Be=E.cursor.drag;if(Yn=Be._x,Zn=Be._y,Yn||Zn){let{left:Ue,top:Ce,width:se,height:Jt}=E.select,ln=E.scales[Gt].ori,En=E.posToVal,Jn,Je,Tn,$i,yi,as=_t!=null&&kt(_t,Gt),vs=Et!=null&&zt(Et,fe);as&&Yn?(ln==0?(Jn=Ue,Je=se):(Jn=Ce,Je=Jt),Tn=v[_t],$i=$(En(Jn,Gt),Tn,tt,0),yi=$(En(Jn+Je,Gt),Tn,tt,0),Bl(Fs($i,yi),qn(yi-$i))):Bl(0,tt),vs&&Zn?(ln==1?(Jn=Ue,Je=se):(Jn=Ce,Je=Jt),Tn=v[Et],$i=P(En(Jn,fe),Tn,ht,0),yi=P(En(Jn+Je,fe),Tn,ht,0),kl(Fs($i,yi),qn(yi-$i))):kl(0,ht)}else bp()}else{let _t=qn(lx-ox),Et=qn(cx-ax);if(N.ori==1){let fe=_t;_t=Et,Et=fe}Yn=ei.x&&_t>=ei.dist,Zn=ei.y&&Et>=ei.dist;let kt=ei.uni;kt!=null?Yn&&Zn&&(Yn=_t>=kt,Zn=Et>=kt,!Yn&&!Zn&&(Et>_t?Zn=!0:Yn=!0)):ei.x&&ei.y&&(Yn||Zn)&&(Yn=Zn=!0);let zt,Gt;Yn&&(N.ori==0?(zt=la,Gt=on):(zt=ca,Gt=xn),Bl(Fs(zt,Gt),qn(Gt-zt)),Zn||kl(0,ht)),Zn&&(N.ori==1?(zt=la,Gt=on):(zt=ca,Gt=xn),kl(Fs(zt,Gt),qn(Gt-zt)),Yn||Bl(0,tt)),!Yn&&!Zn&&(Bl(0,0),kl(0,0))}if(ei._x=Yn,ei._y=Zn,E==null){if(F){if(Mx!=null){let[_t,Et]=Un.scales;Un.values[0]=_t!=null?Ws(N.ori==0?on:xn,_t):null,Un.values[1]=Et!=null?Ws(N.ori==1?on:xn,Et):null}Hl(jg,i,on,xn,W,Nt,k)}if(oe){let _t=F&&Un.setSeries,Et=Wt.prox;Eo==null?mr<=Et&&Vs(Wr,ha,!0,_t):mr>Et?Vs(null,ha,!0,_t):Wr!=Eo&&Vs(Wr,ha,!0,_t)}}vt&&(dt.idx=k,_p()),C!==!1&&jn("setCursor")}let $r=null;Object.defineProperty(i,"rect",{get(){return $r==null&&zl(!1),$r}});function zl(E=!1){E?$r=null:($r=p.getBoundingClientRect(),jn("syncRect",$r))}function dx(E,C,F,k,X,tt,ht){ft._lock||Gr&&E!=null&&E.movementX==0&&E.movementY==0||(yp(E,C,F,k,X,tt,ht,!1,E!=null),E!=null?To(null,!0,!0):To(C,!0,!1))}function yp(E,C,F,k,X,tt,ht,_t,Et){if($r==null&&zl(!1),re(E),E!=null)F=E.clientX-$r.left,k=E.clientY-$r.top;else{if(F<0||k<0){on=-10,xn=-10;return}let[kt,zt]=Un.scales,Gt=C.cursor.sync,[fe,Be]=Gt.values,[Ue,Ce]=Gt.scales,[se,Jt]=Un.match,ln=C.axes[0].side%2==1,En=N.ori==0?W:Nt,Jn=N.ori==1?W:Nt,Je=ln?tt:X,Tn=ln?X:tt,$i=ln?k:F,yi=ln?F:k;if(Ue!=null?F=se(kt,Ue)?a(fe,v[kt],En,0):-10:F=En*($i/Je),Ce!=null?k=Jt(zt,Ce)?a(Be,v[zt],Jn,0):-10:k=Jn*(yi/Tn),N.ori==1){let as=F;F=k,k=as}}Et&&(C==null||C.cursor.event.type==jg)&&((F<=1||F>=W-1)&&(F=$o(F,W)),(k<=1||k>=Nt-1)&&(k=$o(k,Nt))),_t?(ox=F,ax=k,[la,ca]=ft.move(i,F,k)):(on=F,xn=k)}let vp={width:0,height:0,left:0,top:0};function bp(){Eu(vp,!1)}let fx,px,mx,gx;function xx(E,C,F,k,X,tt,ht){Gr=!0,Yn=Zn=ei._x=ei._y=!1,yp(E,C,F,k,X,tt,ht,!0,!1),E!=null&&(Ne(Jg,n0,_x,!1),Hl(Ub,i,la,ca,W,Nt,null));let{left:_t,top:Et,width:kt,height:zt}=an;fx=_t,px=Et,mx=kt,gx=zt}function _x(E,C,F,k,X,tt,ht){Gr=ei._x=ei._y=!1,yp(E,C,F,k,X,tt,ht,!1,!0);let{left:_t,top:Et,width:kt,height:zt}=an,Gt=kt>0||zt>0,fe=fx!=_t||px!=Et||mx!=kt||gx!=zt;if(Gt&&fe&&Eu(an),ei.setScale&&Gt&&fe){let Be=_t,Ue=kt,Ce=Et,se=zt;if(N.ori==1&&(Be=Et,Ue=zt,Ce=_t,se=kt),Yn&&Vr(S,Ws(Be,S),Ws(Be+Ue,S)),Zn)for(let Jt in v){let ln=v[Jt];Jt!=S&&ln.from==null&&ln.min!=tn&&Vr(Jt,Ws(Ce+se,Jt),Ws(Ce,Jt))}bp()}else ft.lock&&(ft._lock=!ft._lock,To(C,!0,E!=null));E!=null&&(Bn(Jg,n0),Hl(Jg,i,on,xn,W,Nt,null))}function m1(E,C,F,k,X,tt,ht){if(ft._lock)return;re(E);let _t=Gr;if(Gr){let Et=!0,kt=!0,zt=10,Gt,fe;N.ori==0?(Gt=Yn,fe=Zn):(Gt=Zn,fe=Yn),Gt&&fe&&(Et=on<=zt||on>=W-zt,kt=xn<=zt||xn>=Nt-zt),Gt&&Et&&(on=on<la?0:W),fe&&kt&&(xn=xn<ca?0:Nt),To(null,!0,!0),Gr=!1}on=-10,xn=-10,et.fill(null),To(null,!0,!0),_t&&(Gr=_t)}function yx(E,C,F,k,X,tt,ht){ft._lock||(re(E),Fl(),bp(),E!=null&&Hl(Bb,i,on,xn,W,Nt,null))}function vx(){T.forEach(V2),V(i.width,i.height,!0)}Yo(Rf,ul,vx);let da={};da.mousedown=xx,da.mousemove=dx,da.mouseup=_x,da.dblclick=yx,da.setSeries=(E,C,F,k)=>{let X=Un.match[2];F=X(i,C,F),F!=-1&&Vs(F,k,!0,!1)},yt&&(Ne(Ub,p,xx),Ne(jg,p,dx),Ne(Ob,p,E=>{re(E),zl(!1)}),Ne(Fb,p,m1),Ne(Bb,p,yx),u0.add(i),i.syncRect=zl);let Tu=i.hooks=n.hooks||{};function jn(E,C,F){_i?Xe.push([E,C,F]):E in Tu&&Tu[E].forEach(k=>{k.call(null,i,C,F)})}(n.plugins||[]).forEach(E=>{for(let C in E.hooks)Tu[C]=(Tu[C]||[]).concat(E.hooks[C])});let bx=(E,C,F)=>F,Un=Fn({key:null,setSeries:!1,filters:{pub:Zb,sub:Zb},scales:[S,x[1]?x[1].scale:null],match:[jb,jb,bx],values:[null,null]},ft.sync);Un.match.length==2&&Un.match.push(bx),ft.sync=Un;let Mx=Un.key,Mp=qM(Mx);function Hl(E,C,F,k,X,tt,ht){Un.filters.pub(E,C,F,k,X,tt,ht)&&Mp.pub(E,C,F,k,X,tt,ht)}Mp.sub(i);function g1(E,C,F,k,X,tt,ht){Un.filters.sub(E,C,F,k,X,tt,ht)&&da[E](null,C,F,k,X,tt,ht)}i.pub=g1;function x1(){Mp.unsub(i),u0.delete(i),Xn.clear(),r0(Rf,ul,vx),c.remove(),Tt?.remove(),jn("destroy")}i.destroy=x1;function Sp(){jn("init",n,t),Ol(t||n.data,!1),z[S]?mp(S,z[S]):Fl(),at=an.show&&(an.width>0||an.height>0),rt=vt=!0,V(n.width,n.height)}return x.forEach(na),T.forEach(hr),e?e instanceof HTMLElement?(e.appendChild(c),Sp()):e(i,Sp):Sp(),i}ri.assign=Fn;ri.fmtNum=x0;ri.rangeNum=Cf;ri.rangeLog=Lf;ri.rangeAsinh=m0;ri.orient=jo;ri.pxRatio=He;ri.join=N3;ri.fmtDate=y0,ri.tzDate=$3;ri.sync=qM;{ri.addGap=A2,ri.clipGaps=Uf;let n=ri.paths={points:KM};n.linear=tS,n.stepped=P2,n.bars=I2,n.spline=D2}var kf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),T0=n=>Ot.curves[n%Ot.curves.length],W2=.06;function $2(n,t,e){let i=[n,t,...e.map(a=>a.value)],s=Math.min(...i),r=Math.max(...i),o=W2*(r-s);return r-s>1e-9?[s-o,r+o]:[s-1,r+1]}function q2(n,t,e,i){let{ctx:s}=n,r=devicePixelRatio;s.save(),s.beginPath(),s.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),s.clip();for(let{value:o,of:a}of i){let l=n.valToPos(o,"y",!0);s.strokeStyle=a===null?Ot.ink:T0(a),s.lineWidth=1.25*r,s.setLineDash([5*r,4*r]),s.beginPath(),s.moveTo(n.bbox.left,l),s.lineTo(n.bbox.left+n.bbox.width,l),s.stroke()}s.setLineDash([]),s.lineCap="round",s.lineWidth=4.5*r,e.forEach((o,a)=>{s.strokeStyle=T0(a);for(let{start:l,end:c}of o.binds){let u=t.xs.map((h,d)=>[h,o.values[d]]).filter(([h])=>h>=l-1e-9&&h<=c+1e-9);s.beginPath();for(let[h,d]of u)s.lineTo(n.valToPos(h,"x",!0),n.valToPos(d,"y",!0));s.stroke()}}),s.restore()}function sS(n,t,{y:e,list:i},{withLimits:s,pick:r}){let o={stroke:Ot.line,width:1},a=`${Math.round(.78*kf())}px "Inter Variable", system-ui, sans-serif`,l=su(i),c={stroke:Ot.muted,grid:o,ticks:{...o,size:4},font:a,labelFont:a,labelSize:1.4*kf(),gap:4},u=new ri({width:n.clientWidth||600,height:n.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(f,p,_)=>[p,Math.max(_,t.xEnd??_,p+1e-6)]},y:{range:(f,p,_)=>$2(p,_,s?l:[])}},series:[{},...i.map((f,p)=>({label:f.name,stroke:T0(p),width:1.75,pxAlign:0,points:{show:t.q.length<3}}))],axes:[{...c,label:t.xName==="point"?"point number":"time, s",size:2.1*kf()},{...c,label:e,size:4*kf()}],hooks:{draw:[f=>q2(f,t,i,l)],setSize:[()=>d()]}},[t.xs,...i.map(f=>f.values)],n);u.over.append(b("div",{class:"now"}),...t.events.map(f=>{let p=b("div",{class:`event ${f.stop?"stop":""}`,title:f.text},b("span",{text:f.short}));return p.x=f.x,p})),u.over.addEventListener("pointerdown",f=>{let p=m=>{let g=u.posToVal(m.clientX-u.over.getBoundingClientRect().left,"x");r(t.xs.reduce((x,T,v)=>Math.abs(T-g)<Math.abs(t.xs[x]-g)?v:x,0))};p(f);let _=()=>{removeEventListener("pointermove",p),removeEventListener("pointerup",_),removeEventListener("pointercancel",_)};addEventListener("pointermove",p),addEventListener("pointerup",_),addEventListener("pointercancel",_)});let h=0;function d(f=h){h=f;let p=u.over.clientWidth;for(let _ of u.over.querySelectorAll(".now, .event")){let m=u.valToPos(_.x??t.xs[h],"x");_.style.setProperty("left",`${m}px`),_.classList.toggle("leftward",m>p*.7)}}return{point:d,canvas:u.ctx.canvas,resize:()=>n.clientWidth&&u.setSize({width:n.clientWidth,height:n.clientHeight}),destroy:()=>u.destroy()}}var X2=1500,Y2={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function rS(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/X2)),r=n.q.map((v,A)=>A).filter(v=>v%s===0||v===n.q.length-1),[o,a,l,c,u,h]=Qa(),[d,f,p]=[o-c,a-u,l-h],_=[Math.atan2(p,Math.hypot(d,f)),Math.atan2(f,d)].map(v=>v*180/Math.PI),m=v=>Number(v.toPrecision(8)),g={kind:t,speed:e,view:_,q:r.map(v=>n.q[v].map(m)),t:r.map(v=>m(n.seconds[v]))},x=await Oe("film",g,({done:v,of:A})=>i(v,A));if(x.stopped)return null;let T=Uint8Array.from(atob(x.data),v=>v.charCodeAt(0));return{name:x.name,blob:new Blob([T],{type:Y2[t]})}}async function oS(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var nn=null,Br=null,ur="joints",gi=0,A0=1,oi=null,Gf=new Set(["speeds","accelerations","toolspeed"]);function lS(n){let t=b("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:uS}}),e=b("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{mi(),kr(Number(e.value))}}}),i=b("output",{class:"where","data-testid":"where"}),s=b("div",{class:"marks"}),r=b("div",{class:"chart","data-testid":"chart"}),o=b("div",{class:"legend"}),a=b("output",{class:"binds","data-testid":"binds"}),l=b("button",{type:"button",class:"quiet",text:"To the limits",title:"Scale the curves so that their limits, dashed, are seen; thick is where one binds","data-testid":"limits-shown",on:{click:()=>{Gf.delete(ur)||Gf.add(ur),Hf()}}});n.append(b("div",{class:"dock-bar"},t,cn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",c=>{A0=Number(c)},{"data-testid":"speed"}),b("div",{class:"scrubber"},e,s),i,b("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>Ii(null)}})),b("div",{class:"dock-bar second"},Ge("Curves",Rb,ur,c=>{ur=c,Hf()},"curves"),l,o,a,b("span",{class:"line saves"},...[["CSV",()=>ci("motion.csv",Pb(nn),"text/csv")],["PNG",j2],["Film",Z2],["GIF",()=>aS("gif")],["MP4",()=>aS("mp4")],["SVG",()=>ci(`${ur}.svg`,Ib(nn,ur,Ot.curves),"image/svg+xml")]].map(([c,u])=>b("button",{type:"button",class:"quiet",text:c,"aria-label":`Save as ${c}`,on:{click:()=>nn&&u()}})))),r),oi={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o,limits:l,binds:a},new ResizeObserver(Zs(()=>Br?.resize())).observe(r),nt(["units","theme"],Hf),nt("moving",c=>bt(t,c&&zf?"Pause":"Play")),nt("table",c=>{nn&&!["postures","name","gripper"].includes(c)&&Ii(null)})}function Ii(n){if(mi(),nn=n,M.motion=n,oi.root.hidden=!n,Br&&(Br.destroy(),Br=null),Jv(n?.table??null,n?.q??[]),!n){ut("motion");return}oi.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Vt(oi.marks,n.events.map(e=>{let i=b("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=b("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),Hf(),ut("motion"),n.q.length&&kr(0),requestAnimationFrame(()=>Ka())}var cS=()=>gi;function kr(n){nn?.q.length&&(gi=Math.min(Math.max(Math.round(n),0),nn.q.length-1),oi.scrub.value=String(gi),oi.scrub.style.setProperty("--at",`${nn.q.length>1?100*gi/(nn.q.length-1):0}%`),bt(oi.where,nn.xName==="point"?`point ${gi+1} of ${nn.q.length}`:`${ti(nn.xs[gi],2)} s of ${ti(nn.xs[nn.xs.length-1],2)} s`),oi.scrub.setAttribute("aria-valuetext",oi.where.textContent),Ni(nn.q[gi].slice(),"scrub"),ut("played",nn.seconds[gi]),bt(oi.binds,nn.tight?`Binds: ${Cb(nn,nn.seconds[gi])||"nothing"}`:""),Br?.point(gi))}var zf=!1;function uS(n,t){if(zf){mi();return}if(!nn?.q.length)return;let e=nn.seconds,i=e[e.length-1]||1,s=gi>=nn.q.length-1?0:e[gi]/i;zf=!0,db(i/A0,s,r=>{let o=gi<=nn.q.length-1&&e[gi]<=r*i?gi:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;kr(o)},()=>{zf=!1,bt(oi.toggle,"Play"),t?.()}),bt(oi.toggle,"Pause")}function Hf(){if(!nn||!oi)return;Br?.destroy();let n=Yg(nn,ur);Vt(oi.legend,n.list.map((t,e)=>{let i=b("span",{class:"swatch"});return i.style.setProperty("background",Ot.curves[e%Ot.curves.length]),b("span",{},i,t.name)})),oi.limits.hidden=!su(n.list).length,oi.limits.setAttribute("aria-pressed",String(Gf.has(ur))),Br=sS(oi.chart,nn,n,{withLimits:Gf.has(ur),pick(t){mi(),kr(t)}}),Br.point(gi)}async function aS(n){be(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await rS(nn,n,A0,(e,i)=>be(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&ci(t.name,t.blob)}catch(t){be(t.message,"wrong")}}async function Z2(){mi(),kr(0);try{let n=await ja(t=>oS(t,()=>new Promise(e=>uS(null,e))));ci("motion.webm",n)}catch(n){be(n.message,"wrong")}}function j2(){let n=Br.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Ot.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>ci(`${ur}.png`,i))}function yl(n,t){let e=Array.from({length:16},(s,r)=>b("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=b("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>b("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;bt(e[r],r>=12?String(s[r]):o?ti(s[r]*gt.factor("length"),gt.digits("length")):ti(s[r],4))}},i}var Vf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var R0="pieper-panel-width",C0=18,hS=70;function dS(n,t){let e=b("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(C0),"aria-valuemax":String(hS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,C0),hS,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(R0):localStorage.setItem(R0,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(R0));o>=C0?r(o):e.setAttribute("aria-valuenow","38")}function fS(n){let t=yl("Pose of the tool, large","present-pose"),e=b("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=b("button",{type:"button",text:"Present","aria-pressed":"false","data-testid":"present",on:{click:()=>o(i.dataset.present!=="yes")}}),r=()=>!e.hidden&&t.show(M.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ut("units"),dispatchEvent(new Event("resize"))}return nt(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function pS(){ja(n=>{let t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.drawImage(n,0,0),xv(e,n.width/n.clientWidth),t.toBlob(i=>i?ci(`${M.table.name||"arm"}.png`,i):be("The picture could not be read.","wrong"))})}var J2="http://www.w3.org/2000/svg";function K2(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(J2,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}var mS=n=>/^(.)\1*$/.test(n)?`${n.length}${n[0]}`:n;function Q2(n){let t=/^>?(\d+(?:[.,]\d+)?)(kg|mm|m)$/.exec(n);if(!t)return null;let e=Number(t[1].replace(",","."));return t[2]==="kg"?{payload:e}:{reach:t[2]==="m"?e:e/1e3}}function tL(n,t){let e=`${n.name} ${n.maker} ${n.joints} ${mS(n.joints)}`.toLowerCase();return t.every(i=>{let s=Q2(i);return s?Object.entries(s).every(([r,o])=>n[r]!==null&&n[r]>=o-1e-9):e.includes(i)})}var eL=({maker:n,joints:t,payload:e,reach:i})=>[n,mS(t),e===null?"":`${e} kg`,i===null?"":`${Math.round(i*1e3)} mm`].filter(Boolean);function gS(n){let t=null,e=b("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=b("span",{class:"hint",role:"status"}),s=b("input",{type:"text",placeholder:"Name, maker, joints (7R), payload (5 kg), reach (900 mm)","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>o(),keydown:a=>{if(a.key==="ArrowDown")e.firstElementChild?.focus();else if(a.key==="Enter")e.firstElementChild?.click();else return;a.preventDefault()}}}),r=b("dialog",{class:"catalogue","aria-label":"Catalogue"},b("div",{class:"line"},s,i,b("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the catalogue",on:{click:()=>r.close()}})),e);document.body.append(r);function o(){let l=s.value.toLowerCase().replace(/(\d)\s+(kg|mm|m)\b/g,"$1$2").split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>tL(u,l));i.textContent=`${c.length} of ${t?.length??0} arms`,Vt(e,c.map(u=>b("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},K2(u.points),b("span",{},b("b",{text:u.name}),b("span",{class:"hint",text:eL(u).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Zi("catalog")).arms,o()}catch(a){be(a.message,"wrong")}}}var du=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),xo=(n,t)=>[...n.children].filter(e=>e.localName===t),nL=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function iL(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function sL([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var xS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:sL},rL={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function _S(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(p=>p.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=rL[e("up_axis")[0]?.textContent.trim()]??nL(),a=[];function l(f){let p=s(xo(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),_=p&&[...p.getElementsByTagName("*")].find(g=>g.localName==="diffuse"),m=_?du(xo(_,"color")[0]):[];return m.length>=3?[m[0],m[1],m[2],m[3]??1]:null}function c(f){let p=xo(f,"input").find(m=>m.getAttribute("semantic")==="POSITION"),_=s(p?.getAttribute("source"));return _?du(xo(_,"float_array")[0]):[]}function u(f,p,_){let m=f&&xo(f,"mesh")[0];if(m)for(let g of m.children){if(!["triangles","polylist","polygons"].includes(g.localName))continue;let x=xo(g,"input"),T=1+Math.max(...x.map($=>Number($.getAttribute("offset")??0))),v=x.find($=>$.getAttribute("semantic")==="VERTEX");if(!v)continue;let A=Number(v.getAttribute("offset")??0),S=c(s(v.getAttribute("source"))),y=xo(g,"p").map(du),w=g.localName==="polylist"?du(xo(g,"vcount")[0]):g.localName==="polygons"?y.map($=>$.length/T):new Array(y.reduce(($,P)=>$+P.length,0)/T/3).fill(3),U=y.flat(),L=[],N=0,H=$=>{let P=3*U[(N+$)*T+A],[z,D,B]=[S[P],S[P+1],S[P+2]];for(let Q=0;Q<3;Q++)L.push(r*(p[4*Q]*z+p[4*Q+1]*D+p[4*Q+2]*B+p[4*Q+3]))};for(let $ of w){for(let P=2;P<$;P++)for(let z of[0,P-1,P])H(z);N+=$}L.length&&L.every(Number.isFinite)&&a.push({at:Float32Array.from(L),colour:l(_.get(g.getAttribute("material")))})}}function h(f,p,_){if(!(_>60)){for(let m of f.children)xS[m.localName]&&(p=iL(p,xS[m.localName](du(m))));for(let m of f.children)if(m.localName==="instance_geometry"){let g=new Map([...m.getElementsByTagName("*")].filter(x=>x.localName==="instance_material").map(x=>[x.getAttribute("symbol"),x.getAttribute("target")]));u(s(m.getAttribute("url")),p,g)}else if(m.localName==="node")h(m,p,_+1);else if(m.localName==="instance_node"){let g=s(m.getAttribute("url"));g&&h(g,p,_+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var Wf=[],fu=new Map,$f=0;function oL(){if(Wf.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=fu.get(t);fu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of fu.values())t(new Error("meshes cannot be read in this browser"));fu.clear()},Wf.push(n),n}return Wf[$f%Wf.length]}function yS(n,t){return new Promise((e,i)=>{$f+=1,fu.set($f,{resolve:e,reject:i}),oL().postMessage({id:$f,...n},t)})}async function vS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=_S(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await yS({at:r},[r.buffer]),colour:o})))}return[{mesh:await yS({bytes:i,kind:e},[i]),colour:null}]}var bS={light:"#c9ced6",dark:"#8b96a6"},bl=new An,Bs=[],pu=0,wS=!1,ES=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function Ml(n,t,e=null){M.looks=n?.shapes.length?{...n,key:ES(t),files:e}:null,n?.notes.length&&be(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),aL()}var I0=()=>!!(M.looks&&M.looks.key===ES(M.table)),L0=()=>I0()?M.look.mode:"sketch",qf=null;function aL(){if(qf===M.looks)return;qf=M.looks;for(let t of Bs)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();Bs=[],bl.clear();let n=qf;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){SS(t,[lL[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(pu+=1,vS(e,t.url??t.file).then(i=>{if(qf===n)for(let{mesh:s,colour:r}of i){let o=P0(s),a=s.some===s?o:P0(s.some);SS(t,[o,a,s.few===s.some?a:P0(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>be(`${t.name}: ${i.message}`,"wrong")).finally(()=>{pu-=1,vl(),pu||ut("looks","loaded")}))}ut("looks"),vl()}var MS=n=>n.rotateX(Math.PI/2),lL={box:n=>new Bi(...n),cylinder:([n,t])=>MS(new Ai(n,n,t,36)),capsule:([n,t])=>MS(new No(n,t,8,24)),sphere:([n])=>new Rs(n,28,16)};function P0(n){let t=new Te;return t.setAttribute("position",new ke(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new ke(n.normal,3):cL(n.normal)),t.setIndex(new ke(n.index,1)),t}function cL(n){return new ka(new Ba(n,4),3,0,!0)}function SS(n,[t,e=t,i=e],s,r=null,o=!0){let a=uv(o),l=new Ye(t,a),c=new Ye(i,af),u=new ge().set(...n.T);r&&u.scale(new G(...r));for(let h of[l,c])h.matrixAutoUpdate=!1,h.frustumCulled=!1;c.renderOrder=-1,bl.add(l,c),Bs.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:l,shadow:c,colour:s}),mu()}var uL=new ge;function vl(){TS(),xe()}function TS(){let n=L0();if(bl.visible=n!=="sketch"&&Bs.length>0,qv(n!=="real"||pu>0,n!=="sketch"&&Bs.length>0),!!bl.visible)for(let t of Bs){let e=M.frames[t.on];e&&(t.mesh.geometry=wS?t.few:Qy()?t.some:t.fine,t.mesh.matrix.copy(uL.set(...e)).multiply(t.T),t.shadow.matrix.copy(Dg).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function mu(){let n=L0()==="both"?M.look.opacity:1;for(let{mesh:t,colour:e}of Bs){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,wi):t.material.colour.set(Ot.dark?bS.dark:bS.light),t.material.see((o??1)*n,Ot.dark)}xe()}function D0(n){M.look={...M.look,...n},mu(),vl(),ut("look")}function AS(){fn.add(bl),nt("table",()=>{vl(),mu(),ut("looks")}),nt("q",vl),nt("theme",mu),nt("look",n=>{n==="loaded"&&(mu(),vl())}),nt("hurry",n=>{wS=n,TS()})}var RS=()=>({mode:L0(),visible:bl.visible,loading:pu,shapes:Bs.length,triangles:Bs.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:Bs.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:Bs.map(n=>n.mesh.matrix.clone().transpose().toArray())});function PS(){let n=Ge("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],M.look.mode,s=>D0({mode:s}),"look"),t=b("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(M.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>D0({opacity:Number(t.value)})}}),e=b("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!I0(),n.mark(M.look.mode),t.hidden=M.look.mode!=="both",t.value=String(M.look.opacity)};return nt(["looks","look","table"],i),i(),e}function LS(n){let t=b("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>IS(t.value)}}),e=gS(IS),i=b("p",{class:"sentence","data-testid":"sentence"}),s=b("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=b("button",{type:"button",text:u,"aria-label":h,on:{click:d}});return p.show=_=>{p.disabled=!_,p.title=_?`${h}: ${_} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",_??"")},p},o=r("\u21B6","Undo",Hg,"Ctrl+Z"),a=r("\u21B7","Redo",Gg,"Ctrl+Shift+Z");nt("history",()=>{o.show(ff()),a.show(pf())});let l=()=>{let{name:u,derived:h,catalog:d}=M.table,f=d?[]:[b("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Vt(t,f,(M.catalog??[]).map(p=>b("option",{value:p,text:p}))),t.value=d??""},c=b("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(b("h1",{class:"mark"},b("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),b("span",{text:"pieper"})),t,b("button",{type:"button",class:"find",text:"Find\u2026","aria-label":"Find an arm in the catalogue","data-testid":"find-arm",on:{click:e}}),c,i,b("span",{class:"bar-end"},s,Ge("Angles in",[["deg","\xB0"],["rad","rad"]],gt.angle,u=>{gt.set("angle",u),ut("units")},"unit-angle"),Ge("Lengths in",[["mm","mm"],["m","m"]],gt.length,u=>{gt.set("length",u),ut("units")},"unit-length"),cn("Size of the letters",[1,1.15,1.3,1.5].map(u=>[String(u),`${Math.round(100*u)} %`]),String(jm()),u=>Fy(Number(u)),{"data-testid":"text-size"}),cn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],M.theme,Ud,{"data-testid":"theme"}))),ut("history"),nt(["catalog","table"],l),nt("plan",()=>{bt(i,[Du(M.plan),Fx(M.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=M.plan?.explain??""}),nt("online",u=>{bt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),nt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(gt.angle),n.querySelector("[data-testid=unit-length]").mark(gt.length),n.querySelector("[data-testid=theme]").value=M.theme})}async function IS(n){if(n)try{let{table:t}=await Zi("load",{name:n});_n(t,{q:pa(t),what:"new",label:`open ${n}`})}catch(t){be(t.message,"wrong")}}function DS(n,t,e,i){let s=b("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=b("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=b("section",{class:"section"},b("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=b("button",{type:"button",role:"tab",id:`tab-${c.id}`,"aria-controls":u.id,text:c.title,on:{click:()=>l(c.id)}});return c.group&&s.append(b("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(M.panel,t.scrollTop),M.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ut("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===M.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(M.panel==="move"||!a.some(c=>c.id===M.panel)?"move":M.panel)),l(M.panel),l}function NS(n){let t=b("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>b("button",{type:"button",text:u,on:{click:()=>ig(c)}})),b("button",{type:"button",text:"Fit",on:{click:()=>Jc()}})),e=b("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=b("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),ab(c)}}}),s=b("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:uf}}),r=b("span",{class:"scale"}),o=b("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=b("span",{class:"dot"});return h.style.setProperty("background",Lr[u]),b("span",{},h,c)}),r);n.append(b("div",{class:"corner top"},t,b("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),PS(),b("div",{class:"group",role:"group","aria-label":"The picture"},fS(n),b("button",{type:"button",text:"PNG","aria-label":"Save the picture","data-testid":"save-picture",on:{click:pS}}))),b("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=M.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);M.shownFrames=(M.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{M.shownFrames=d,l()};Vt(e,b("span",{class:"group-name",text:"Frames"}),u.map(d=>b("button",{type:"button",text:cf(d),"aria-pressed":String(M.shownFrames.includes(d)),"aria-label":`Frame ${cf(d)}`,on:{click:()=>h(M.shownFrames.includes(d)?M.shownFrames.filter(f=>f!==d):[...M.shownFrames,d])}})),b("button",{type:"button",text:M.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(M.shownFrames.length===c+2?[]:u)}})),ut("frames"),bt(r,`grid ${ue(og.cell,"length",gt.length==="mm"?0:2)}`)};nt(["table","units"],l),l()}function US(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Hg()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Gg()))})}var N0=()=>M.frames[M.frames.length-1],FS={id:"pose",title:"Pose",build(n){let t=yl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>OS(u,"length",`pose-${u.toLowerCase()}`)),i=b("div",{class:"quantities","data-testid":"orientation"}),s=b("p",{class:"hint order"}),r=[],o=cn("Notation of the orientation",Object.entries(Ls).map(([u,h])=>[u,h.title]),M.notation,u=>{M.notation=u,ut("notation")}),a=b("span",{class:"copies"},b("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>qr(Vf(N0()))}}),b("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>qr(hL())}}));n.append(b("div",{class:"subhead"},b("span",{text:"Tool in the base frame"}),a),t,b("div",{class:"quantities"},e.map(u=>u.el)),b("div",{class:"line"},o,s),i);let l=()=>{let u=Ls[M.notation];o.value=M.notation,bt(s,u.order),r=u.names.map((h,d)=>OS(h,u.kinds[d],`turn-${d}`)),Vt(i,r.map(h=>h.el)),c()},c=()=>{let u=N0();t.show(u),Qt(u).forEach((h,d)=>e[d].show(h)),Ls[M.notation].to(u).forEach((h,d)=>r[d].show(h))};nt("q",c),nt("notation",l),nt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function hL(){let n=N0(),t=Ls[M.notation],e=Qt(n).map((s,r)=>`${"XYZ"[r]} ${pn(s,"length")} ${gt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${pn(s,"angle")} ${gt.symbol("angle")}`:ti(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function OS(n,t,e){let i=b("output",{"data-testid":e}),s=b("span",{class:"unit",text:gt.symbol(t)});return{el:b("div",{class:"quantity"},b("span",{class:"quantity-name",text:n}),i,s),show:o=>bt(i,t==="plain"?ti(o,5):pn(o,t)),relabel:()=>bt(s,gt.symbol(t))}}function dL(n,t){let e=[],i=n.joints.length,s=xr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=gr(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*gr(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var BS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=b("div",{class:"cards","data-testid":"matrices"}),a=b("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=cn("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),c=b("span",{class:"partial"});n.append(b("div",{class:"line"},Ge("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),c),b("div",{class:"line"},b("span",{class:"field-name",text:"Numbers of the"}),l),o,b("h3",{text:"Intermediate angles"}),b("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&M.solutions?.rows[Number(e)]?.q||M.q,h=()=>{let p=M.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let _=t==="links"?M.table.joints.map((g,x)=>["A",String(x+1),""]):t==="products"?M.table.joints.map((g,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&_.push(["T","tool","base"]);let m=Array.from({length:p+1},(g,x)=>[String(x),String(x)]);Vt(c,t==="partial"?[cn("From frame",m,String(i),g=>{i=Number(g),h()})," \u2192 ",cn("To frame",m,String(s),g=>{s=Number(g),h()})]:[]),r=_.map(([g,x,T])=>({grid:yl(`${g} ${T} ${x}`,`matrix-${g}${T}${T?"-":""}${x}`),note:b("span",{class:"hint"}),sym:g,low:x,high:T})),Vt(o,r.map(({grid:g,note:x,sym:T,low:v,high:A})=>b("figure",{class:"card"},b("figcaption",{},b("span",{class:"symbol"},A?b("sup",{text:A}):null,b("i",{text:T}),b("sub",{text:v})),x),g))),d()},d=Zs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let p=u(),_=Tx(M.table,p),m=_.length;r.forEach(({grid:T,note:v},A)=>{if(t==="links"&&A<m)T.show(_[A]),bt(v,`q${A+1} = ${ue(p[A],Ze(M.table.joints[A]))}`);else if(t==="links")T.show(Ms(M.table,p)[m+1]);else if(t==="products")T.show(_.slice(0,A+1).reduce(zn,Yi()));else{let S=y=>_.slice(0,y).reduce(zn,Yi());T.show(zn(fa(S(i)),S(s)))}});let g=xr(M.table,p),x=M.table.joints.map((T,v)=>[T.type==="R"?`\u03B8${v+1}`:`d${v+1}`,T.type==="R"?pn(gr(T,g[v]).theta,"angle"):pn(gr(T,g[v]).d,"length"),T.type==="R"?"angle":"length"]).concat(dL(M.table,p).map(({name:T,value:v})=>[`\u03B8${T}`,pn(v,"angle"),"angle"]));Vt(a,b("tbody",{},x.map(([T,v,A])=>b("tr",{},b("th",{scope:"row"},b("i",{text:T[0]}),b("sub",{text:T.slice(1)})),b("td",{text:v}),b("td",{class:"unit",text:gt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=M.solutions?.rows??[];Vt(l,b("option",{value:"now",text:"present posture"}),p.map((_,m)=>b("option",{value:String(m),text:`solution ${m+1}: ${_.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),l.value=e,d()};nt("table",h),nt(["q","units","panel"],d),nt(["solutions","panel"],f),h()}};var fL=.002;function ks(n,t,e,i){let s=[],r="",o=b("div",{class:"pose-fields"}),a=()=>{let c=Ls[M.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=vv(M.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,pL(s))};s=u.map(([d,f],p)=>{let _={value:0,kind:f},m=(g,x)=>{_.value=g,_.text=x.text,h()};return _.f=bn({label:`${n}, ${d}`,kind:f,testid:`${t}-${p}`,input:m,commit:(g,x)=>{m(g,x),ut("let-go")}}),_.el=b("label",{class:"pose-field"},b("span",{text:d}),_.f,b("span",{class:"unit",text:gt.symbol(f)})),_}),Vt(o,s.map(d=>d.el)),r=M.notation},l=()=>{r!==M.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...Qt(c),...Ls[M.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,mL(u,s[h].kind))})};return nt("units",()=>{a(),l()}),nt("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=bf(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),Mf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:b("fieldset",{class:"pose-editor"},b("legend",{text:n}),o),show:l}}function pL(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?il(t(e),"angle"):2*il(t(n.slice(3)),"plain");return{metres:il(t(n.slice(0,3)),"length"),radians:i}}var mL=(n,t)=>String(Number((n*gt.factor(t)).toFixed(t==="plain"||gt[t]==="m"||gt[t]==="rad"?6:3))+0);function kS(n){let t=n.match(zS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:il(e,"length"),radians:2*il(i,"plain")}}var zS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function HS(n){let t=(n.replaceAll("\u2212","-").match(zS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Ru(e);if(i>fL)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=gt.factor("length");return Cu(e)}function Xf(n){return n.map((t,e)=>{let i=M.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((M.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function GS(n,t){let e=t?.self_motions??[],i=he.task??M.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Vt(n,b("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let p=d.moves.length>3?"most of its joints":d.moves.join(" and "),_=d.inside.length?yL(d):"All of it lies outside the limits.";return b("div",{class:"self-motion"},b("p",{},b("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${p}, ${a(d)}: the arm moves, ${o}. ${_}`),bL(d,f,t.T,s))},c=e.length?xL(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?b("details",{class:"fold"},b("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Vt(n,c>=0?l(e[c],c):null,h)}var gL=n=>n.reduce((t,e,i)=>t+Math.sin((e-M.q[i])/2)**2,0),xL=n=>{let t=n.map(e=>Math.min(...e.q.map(gL)));return t.indexOf(Math.min(...t))};function _L(n){let t=(s,r)=>s.map((o,a)=>M.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(M.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var yL=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function vL(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function bL(n,t,e,i){let s=b("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{mi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ut("did",{label:"slide along a self-motion",key:"self-motion"}),Ni(Xf(i?Rx(M.table,u,e):u),"self-motion")};return s.value=String(_L(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",vL(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function VS(){let n=[],t=[],e={},i=b("div",{class:"joints"}),s=b("details",{},b("summary",{class:"hint",text:"Hold by value"}),i),r=b("p",{class:"hint"}),o=Ge("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=b("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},b("div",{class:"line spread"},b("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:p=!1}={}){ut("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),he.redundancy=f&&Object.fromEntries(f.map(_=>[_,e[_]])),d(),p?ub():Ns({follow:!0})}let c=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>M.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let _=f.kind==="angle"?Math.PI:li(M.table),m=f.lower??-_,g=f.upper??_,x=b("input",{type:"range",min:String(m),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),T=!1,v=(w,U)=>{e[f.name]=w,l(c(f),{sliding:U})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>Ns({follow:!0})),x.addEventListener("keydown",w=>{let U={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[w.key];if(U===void 0)return;w.preventDefault(),T=!0;let L=U*gt.step(f.kind)*(w.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+L,m),g),!0)}),x.addEventListener("keyup",()=>{T&&Ns({follow:!0}),T=!1});let A=bn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:w=>w<m-1e-9&&f.lower!==null?`below the limit ${ue(m,f.kind)}`:w>g+1e-9&&f.upper!==null?`above the limit ${ue(g,f.kind)}`:null,commit:w=>v(w,!1)}),S=b("span",{class:"limits"}),y=b("div",{class:"joint"},b("span",{class:"joint-name",text:f.name}),b("div",{class:"track"},x,b("div",{class:"under"},S)),A,b("span",{class:"unit"}));return{line:y,show(){let w=e[f.name];x.value=w,x.style.setProperty("--at",`${100*(Math.min(Math.max(w,m),g)-m)/(g-m||1)}%`),x.setAttribute("aria-valuetext",ue(w,f.kind)),y.classList.toggle("held",!!(he.redundancy&&f.name in he.redundancy)),A.put(Number((w*gt.factor(f.kind)).toFixed(gt.digits(f.kind)+1))/gt.factor(f.kind))},relabel(){bt(y.lastChild,gt.symbol(f.kind));let w=U=>U===null?"no limit":ue(U,f.kind,f.kind==="angle"&&gt.angle==="deg"?0:void 0);bt(S,f.lower===null&&f.upper===null?"no limits":`${w(f.lower)} \u2026 ${w(f.upper)}`),A.refresh()}}}function d(){for(let f of n)he.redundancy&&f.name in he.redundancy?e[f.name]=he.redundancy[f.name]:u(f)>=0?e[f.name]=M.q[u(f)]:f.instead&&Number.isFinite(M.solutions?.arm_angle)?e[f.name]=M.solutions.arm_angle:e[f.name]??=0;o.mark(he.redundancy?"chosen":"free"),bt(r,he.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return nt("solutions",()=>{let f=M.solutions?.spare;if(!M.solutions||!f&&(M.solutions.brief||M.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Vt(i,t.map(_=>_.line));for(let _ of t)_.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(_=>!_.instead).length>1||!!he.redundancy),d()}),nt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!he.redundancy&&d()),nt("units",()=>{for(let f of t)f.relabel();d()}),a}function WS(){let n=b("thead"),t=b("tbody"),e=b("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=b("div",{class:"scroll"},b("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${M.table.joints.map(c=>c.type).join("")}${gt.angle}${gt.length}`;l!==r&&(r=l,s=[],Vt(t),Vt(n,b("tr",{},b("td"),b("th",{class:"left",text:"posture"}),M.table.joints.map((c,u)=>b("th",{},b("i",{text:"q"}),b("sub",{text:String(u+1)}),b("span",{class:"unit",text:` ${gt.symbol(Ze(c))}`}))),b("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=M.table.joints.map(()=>b("td")),u=b("span"),h=b("span",{class:"offscreen"}),d=b("td",{class:"unit"}),f=b("tr",{tabindex:"0","data-testid":`solution-${l+1}`},b("th",{scope:"row",text:String(l+1)}),b("td",{class:"left"},u,h),c,d),p=()=>M.solutions?.rows[l]?.q,_=()=>p()&&fs(p()),m=()=>fs(null),g=()=>{p()&&(fs(null),Ri(Xf(p()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",_),f.addEventListener("pointerleave",m),f.addEventListener("focus",_),f.addEventListener("blur",m),f.addEventListener("click",g),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),g())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&bt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),bt(u.beyond,d.inside?"":", outside the limits"),bt(u.residual,d.residual?Yd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${Yd(d.residual[0])} m, ${Yd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let _=M.table.joints[p],m=_.lower!==null&&f<_.lower-1e-9||_.upper!==null&&f>_.upper+1e-9;bt(u.cells[p],pn(f,Ze(_))),u.cells[p].classList.toggle("out",m)}))}),this.mark()},mark(){let l=M.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===M.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-M.q[d])/2))<1e-5)))}}}var ML={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},U0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},SL=new Set(["REDUNDANT","UNCERTAIN"]),wL=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,O0=120;function F0(){Mi(M.frames[M.frames.length-1].slice(),"taken")}var qS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(b("div",{class:"line spread"},b("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:F0}}),Ge("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",_=>{i.hidden=_!=="numbers",s.hidden=_!=="matrix"},"target-as")));let e=ks("Target","target",()=>M.target,(_,m)=>Mi(_,"typed",m)),i=b("div",{},e.el),{el:s,show:r}=TL();n.append(i,s,AL());let o=b("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=b("div",{class:"near","data-testid":"ik-nearest"}),l=b("div",{class:"self-motions","data-testid":"self-motions"}),c=WS();n.append(VS(),o,a,l,c.el);let u=ma(O0,()=>{e.show(),r()}),h=ma(O0,()=>{if(t.hidden)return;let _=M.solutions;RL(o,_),IL(a,_),GS(l,_),c.show(_)}),d=ma(O0,()=>c.mark()),f=_=>()=>nf()?_.soon():_();nt("target",f(u)),nt("notation",e.show),nt(["solutions","units"],f(h)),nt("q",f(d));let p=()=>Ur("target",M.panel==="inverse"?EL(Qt(M.target)):[]);nt("target",_=>_!=="drag"&&p()),nt("panel",_=>{Fv(_==="inverse"),(_!=="inverse"||M.hasTarget)&&p(),_==="inverse"&&(M.hasTarget?ut("solutions"):(M.hasTarget=!0,F0()))}),nt("table",_=>{_==="new"&&(M.hasTarget=M.panel==="inverse",M.hasTarget&&F0())})}};function EL(n){let t=.25*li(M.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function TL(){let n=b("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=b("p",{class:"reason",role:"alert"}),e=b("p",{class:"hint"});n.addEventListener("input",()=>{try{Mi(HS(n.value),"typed",kS(n.value)),bt(t,""),n.removeAttribute("aria-invalid")}catch(s){bt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(bt(e,`Twelve or sixteen numbers, row by row; the last column in ${gt.length}.`),document.activeElement===n)return;let s=M.target.map((r,o)=>o%4===3&&o<12?r*gt.factor("length"):r);n.value=Vf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return nt("units",i),i(),{el:b("div",{hidden:!0},n,e,t),show:i}}function AL(){let n=b("span",{class:"line"}),t=b("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{he.follow=t.checked}}}),e=Ge("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{he.ghosts=i,al()});return nt("task",()=>{t.checked=he.follow,e.mark(he.ghosts)}),nt("plan",()=>Vt(n,M.plan?.solvable?[b("span",{class:"field-name",text:"Task"}),cn("Task",[["",`${M.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],he.task??"",i=>{ut("did",{label:"choose the task"}),he.task=i||null,he.redundancy=null,Ns()},{"data-testid":"task"})]:[])),b("div",{class:"line controls"},b("span",{class:"line"},b("span",{class:"field-name",text:"Handles"}),Ge("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Bv)),Ge("Axes of the handles",[["local","Tool"],["world","World"]],"local",kv),b("span",{class:"line"},b("span",{class:"field-name",text:"Snap"}),cn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>zv(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),b("span",{class:"line"},b("span",{class:"field-name",text:"Ghosts"}),e),b("label",{class:"check"},t,"Arm follows"),n)}function RL(n,t){if(!t){Vt(n,b("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=ML[t.status]??"note";let s=t.status==="SOLVED"&&e?$S(t.missed):[t.why,t.status==="SINGULAR"?wL(e,i):"",$S(t.missed)].filter(Boolean).join(" "),r=U0[t.status]&&!i?t.why.toLowerCase().includes(U0[t.status].toLowerCase())?"":U0[t.status]:t.status==="SINGULAR"||SL.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Vt(n,b("strong",{text:r})," ",b("span",{text:s}),t.ms===void 0?null:b("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var $S=n=>n?`The pose was rounded by ${PL(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",CL=(n,t)=>ue(n,t,gt.digits(t)+2),PL=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*gt.factor(e)>=.5*10**-(gt.digits(e)+2)).map(([t,e])=>CL(t,e)).join(" and ");function IL(n,t){let e=t?.near;if(!e){Vt(n);return}let i=Qt(e.T).map(s=>pn(s,"length")).join(", ");Vt(n,b("p",{},b("strong",{text:"Nearest reachable: "}),`${i} ${gt.symbol("length")}, ${ue(e.metres,"length")} away`,e.radians>.001?`, turned by ${ue(e.radians,"angle")}`:""),b("div",{class:"line"},b("button",{type:"button",text:"Go there",on:{click:()=>Ri(e.q)}}),b("button",{type:"button",text:"Make it the target",on:{click:()=>Mi(e.T,"chosen")}})))}var B0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Yf(n){return B0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Zf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Yf(r)??{a:0,alpha:0};Yf(r)&&(r=Yi()),o=zn(B0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Yf(o)??{a:0,alpha:0};Yf(o)&&(o=Yi()),r=zn(r,B0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var XS=30,LL=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),DL={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},Sl=null;function YS(n,t){Sl={label:n,key:"paste",open:!0};try{t(Sl)}finally{Sl=null,ut("let-go")}}function jf(n,t,e,{symbolic:i,text:s},r){let o=M.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(M.table.joints[n][t],e)&&M.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${DL[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||_n({...M.table,joints:o},Sl?{...c,...Sl}:c),r&&!Sl&&ut("let-go")}function wl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=M.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(M.q,0),c=o?t(o,null).map((u,h)=>NL(u&&t(u,0),h,n.length)):null;_n({...M.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var NL=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function ZS(n,t,e){let i=M.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function k0({label:n,key:t,open:e}={}){let i=M.table.joints.length;return i>=XS?(be(`At most ${XS} joints.`,"wrong"),!1):(wl([...M.table.joints,LL(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function jS(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};wl(e(M.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function Jf(){try{ci(`${M.table.name||"arm"}.toml`,(await Oe("save",{})).text,"application/toml")}catch(n){be(n.message,"wrong")}}function QS(){let n=(t,e,i)=>{let s=b("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>OL(s)}});return[b("button",{type:"button",text:t,title:e,on:{click:()=>s.click()}}),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var UL=/\.(toml|urdf|xml)$/i,JS=2e5;async function OL(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>UL.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){be("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>JS){be(`${i.name} has ${i.size} bytes; a robot file has at most ${JS.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Zi("open",{name:i.name.slice(-80),text:await i.text()});_n(s,{q:pa(s),what:"new",label:`open ${i.name.slice(-40)}`}),Ml(r,s,a=>KS(t,a));let o=r?.shapes.filter(a=>a.file&&!KS(t,a.file)).length;o&&be(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){be(s.message,"wrong")}}function KS(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var z0=(n,t,e,i=!1)=>b("button",{type:"button",class:"icon",text:n,"aria-label":t,disabled:i,on:{click:e}}),_o=({k:n,n:t,name:e,move:i=null,remove:s})=>[...i?[z0("\u2191",`Move ${e} up`,()=>i(n,n-1),n===0),z0("\u2193",`Move ${e} down`,()=>i(n,n+1),n===t-1)]:[],z0("\xD7",`Remove ${e}`,()=>s(n))];var H0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},FL=({catalog:n,...t})=>n?{...t,derived:n}:t,BL=n=>n.type==="R"?"angle":"length",tw={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=b("thead"),s=b("tbody"),r=b("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=b("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=b("p",{class:"verdict","data-testid":"arm-kind"}),l=Ge("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],M.table.convention,x=>{x!==M.table.convention&&_n(Zf(M.table,x),{what:"rows",label:`make the table ${x}`})},"convention"),c=b("p",{class:"hint order"}),u=b("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>_n({...FL(M.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=ks("Base","base",()=>M.table.base,x=>_n({...M.table,base:x},{what:"cell",label:"edit the base",key:"base",open:!0})),d=ks("Tool","tool",()=>M.table.tool,x=>_n({...M.table,tool:x},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(b("div",{class:"line spread"},b("span",{class:"line"},u),b("span",{class:"line"},b("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>_n(Cx(M.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),...QS(),b("button",{type:"button",text:"Save",title:"As a robot file",on:{click:Jf}}))),b("div",{class:"line spread"},l,Ge("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,x=>{t=x,m()},"dh-part")),c,r,b("div",{class:"line"},b("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>k0()}}),b("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,yv(),b("details",{class:"fold","data-testid":"base-tool"},b("summary",{text:"Base and tool"}),h.el,d.el)),s.addEventListener("paste",x=>{let T=bf(x.clipboardData.getData("text")),v=()=>[...s.rows].map(y=>[...y.querySelectorAll("input.number")]);if(!T||!x.target.matches("input.number"))return;x.preventDefault();let A=v().findIndex(y=>y.includes(x.target)),S=v()[A].indexOf(x.target);YS("paste a table",y=>{for(;M.table.joints.length<A+T.length&&k0(y););let w=Mf(v(),A,S,T),U=T.flat().length;be(`Pasted ${w} number${w===1?"":"s"}${w<U?`; ${U-w} had no cell`:""}`)})}),n.addEventListener("verdict",x=>{let T=x.detail??kL(n);bt(o,T?`${T.label}: ${T.reason}. The arm stays as it was.`:"")});let f=(x,T,[v,A,S])=>{let y=x.type==="R"&&v==="theta"||x.type==="P"&&v==="d",w=v==="lower"||v==="upper",U=bn({label:`Joint ${T+1}, ${A}`,kind:S??BL(x),testid:`dh-${T+1}-${v}`,empty:w?null:void 0,check:L=>w?ZS(T,v,L):L!==null&&Math.abs(L)>1e6?"larger than a million":null,input:(L,N)=>jf(T,v,L,N,!1),commit:(L,N)=>jf(T,v,L,N,!0)});return w&&(U.placeholder="none"),e.push({f:U,i:T,key:v}),b("td",{class:y?"variable":""},y?b("span",{class:"plus"},b("i",{text:"q"}),b("sub",{text:String(T+1)})," +"):null,U)},p=(x,T)=>b("button",{type:"button",class:`type type-${x.type}`,text:x.type,"data-testid":`dh-${T+1}-type`,"aria-label":`Joint ${T+1} is ${x.type==="R"?"revolute":"prismatic"}; press to change`,title:x.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>wl(M.table.joints.map((v,A)=>A===T?{...v,type:v.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...v.text,lower:void 0,upper:void 0,offset:void 0}}:v),v=>v.map((A,S)=>S===T&&typeof A=="number"?0:A),`make joint ${T+1} ${x.type==="R"?"prismatic":"revolute"}`)}}),_=(x,T)=>b("td",{class:"tools"},_o({k:x,n:T,name:`joint ${x+1}`,move:jS,remove:()=>wl(M.table.joints.filter((v,A)=>A!==x),v=>v.filter((A,S)=>S!==x),`remove joint ${x+1}`)})),m=()=>{e=[];let{joints:x}=M.table,T=M.table.convention==="modified",v=t==="geometry"?H0.geometry.map(([A,S,y])=>b("th",{scope:"col"},b("i",{text:S}),b("sub",{text:T&&(A==="a"||A==="alpha")?"i\u22121":"i"}),b("span",{class:"unit",text:` ${gt.symbol(y)}`}))):["name","lower limit","upper limit","zero","sense"].map(A=>b("th",{scope:"col",text:A}));Vt(i,b("tr",{},b("th",{scope:"col",text:"i"}),b("th",{scope:"col"},b("span",{class:"offscreen",text:"type"})),v,b("td"))),Vt(s,x.map((A,S)=>{let y=t==="geometry"?H0.geometry.map(w=>f(A,S,w)):[b("td",{},b("input",{type:"text",class:"name",value:A.name,maxlength:"40","aria-label":`Joint ${S+1}, name`,on:{change:w=>jf(S,"name",w.target.value||`joint_${S+1}`,{},!0)}})),...H0.joint.map(w=>f(A,S,w)),b("td",{},b("button",{type:"button",class:"type",text:A.sign>0?"+":"\u2212","aria-label":`Joint ${S+1}, sense of the maker: ${A.sign>0?"as the table":"against the table"}`,on:{click:()=>wl(M.table.joints.map((w,U)=>U===S?{...w,sign:-w.sign}:w),w=>w,`turn the sense of joint ${S+1}`)}}))];return b("tr",{"data-testid":`dh-row-${S+1}`},b("th",{scope:"row",text:String(S+1)}),b("td",{},p(A,S)),y,_(S,x.length))})),x.length||s.append(b("tr",{},b("td",{colspan:"7",class:"hint",text:"No joints yet."}))),g()},g=()=>{for(let{f:x,i:T,key:v}of e){let A=M.table.joints[T];x.put(A[v],A.text?.[v]??null)}l.mark(M.table.convention),bt(c,M.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=M.table.name),h.show(),d.show()};nt("table",x=>{bt(o,""),x==="cell"||x==="name"||x==="postures"?g():m()}),nt("units",m),nt("notation",()=>{h.show(),d.show()}),nt("plan",()=>{a.dataset.tone=M.plan?.solvable?"good":"wrong",Vt(a,b("strong",{text:Du(M.plan)||(M.plan?.refused?"Refused":"Not solved")})," ",b("span",{text:M.plan?.explain??""}))}),m()}};function kL(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var zL=4,HL=n=>{let t=n.toFixed(zL);return Number(t)<0?`(${t})`:t.replace("-","")};function Kf(n,t,e){let i=xr(t,e),s=t.joints.map((c,u)=>gr(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,HL(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Qf=null;async function GL(){return Qf??=(await import("./katex-OJEVB6AI.js")).default,Qf}function VL(n,t){let e=b("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function ew(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>VL(n,i)],[i=>"code"in i,i=>b("code",{text:i.code})],[()=>!0,i=>b("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var WL=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function $L(n){let t=M.table.joints.map((e,i)=>b("th",{},b("i",{text:"q"}),b("sub",{text:String(i+1)}),b("span",{class:"unit",text:` ${gt.symbol(Ze(e))}`})));return[b("h3",{text:"The formulas at the present pose"}),b("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},b("thead",{},b("tr",{},b("th",{text:"branch"}),t)),b("tbody",{},n.map((e,i)=>b("tr",{},b("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>b("td",{text:pn(s,Ze(M.table.joints[r]))}))))))]}var nw={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=b("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=b("div",{class:"equations","data-testid":"equations"}),c=Ge("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,_()},"equation-numbers"),u=b("div",{class:"scroll"});n.append(b("div",{class:"line spread"},b("span",{class:"line"},Ge("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,_()},"which-equations"),c),b("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>qr(f())}})),a,u,l);let h=v=>v.symbols&&i==="present"?Kf(v,M.table,M.q):v.latex,d=v=>v.number===void 0?"":` \\tag{${v.number}}`,f=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${d(v)} \\]`:WL(v.pieces)).join(`

`);function p(v){r=[],Vt(l,o.map(A=>m(v,A))),g()}async function _(){if(t.hidden||!M.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(M.table.joints)}${M.table.convention}`;if(s!==v){s=v,bt(a,"Deriving \u2026"),Vt(l);try{let[A,S]=await Promise.all([GL(),Oe("equations",{which:e,numbers:i==="symbols"?i:"numbers"},y=>bt(a,y.note??""))]);if(s!==v)return;bt(a,S.note??""),o=S.blocks,p(A),c.hidden=e!=="forward",Vt(u),x()}catch(A){if(s!==v)return;s=null,bt(a,A.message)}}}function m(v,A){if(A.kind==="heading"||A.kind==="step")return b("h3",{},ew(v,A.pieces));if(A.kind!=="equation")return b("p",{class:"prose"},ew(v,A.pieces));let S=b("div",{class:"formula"});try{v.render(h(A),S,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{S.replaceChildren(b("code",{text:h(A)}))}if(A.number!==void 0)return b("div",{class:"formula-row numbered"},S,b("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return S;let y=b("output",{class:"value","data-entry":String(A.entry)});return r.push({value:y,entry:A.entry}),b("div",{class:"formula-row"},S,y)}let g=Zs(()=>{if(t.hidden)return;let v=M.frames[M.frames.length-1];for(let{value:A,entry:S}of r)bt(A,`= ${S%4===3?`${ti(v[S]*gt.factor("length"),gt.digits("length"))} ${gt.length}`:ti(v[S],4)}`)}),x=js(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:v}=await Oe("formulas",{T:M.frames.at(-1)});Vt(u,v.length&&e==="inverse"?$L(v):null)}catch{Vt(u)}},250),T=js(()=>{!t.hidden&&Qf&&o.length&&e==="forward"&&i==="present"&&p(Qf)},120);nt("q",T),nt("panel",T),nt("q",x),nt("units",x),nt("panel",_),nt("plan",_),nt(["q","units"],g)}};function yo(n){let t=b("p",{class:"verdict",role:"status","data-testid":n,hidden:!0});return t.say=(e,i="wrong")=>{t.hidden=!e,t.dataset.tone=i,bt(t,e)},t}function vo({text:n,working:t,testid:e,verdict:i,root:s,open:r=()=>!0,ask:o}){let a=b("button",{type:"button",class:"primary",text:n,"data-testid":e});return a.ask=async(...l)=>{let c=Dx(s);if(c){i.say(c);return}a.disabled=!0,bt(a,t);try{await o(...l)}catch(u){i.say(u.message)}finally{bt(a,n),a.show()}},a.show=()=>{a.disabled=!r()},a.addEventListener("click",()=>a.ask()),a}var qL=()=>M.frames.at(-1).slice();function tp(n,t){let e=M.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{ut("did",{label:c,key:u}),e[a]=l,t(),ut("path",n)},r=["from","to"].map(a=>{let l=ks(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=b("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`${i}take-${a}`,on:{click:()=>{s(a,qL(),`take \u201C${a}\u201D of the path`),l.show()}}});return{el:b("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return nt("path",a=>a!==n&&o()),nt("path-loaded",o),nt("notation",o),{el:b("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var iw=()=>M.frames[M.frames.length-1].slice(),sw={id:"path",title:"Path",wide:!0,build(n,t){let e=M.path,i=tp("path",()=>h()),s=b("span",{class:"hint"}),r=bn({label:"Number of points N",testid:"path-n",check:m=>Number.isInteger(m)&&m>=2&&m<=2e3?null:"a whole number from 2 to 2000",input:m=>{ut("did",{label:"set the points of the path",key:"path-n"}),e.n=m}}),o=bn({label:"Seconds for the whole line",testid:"path-seconds",check:m=>m>0&&m<=3600?null:"more than 0, at most 3600",input:m=>{ut("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=m}}),a=b("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let m=Qt(e.to);ut("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((g,x)=>{e.to[g]=m[x]}),i.show(),ut("path","path"),h()}}}}),l=yo("path-verdict"),c=vo({text:"Plan the line",working:"Planning \u2026",testid:"plan",verdict:l,root:n,ask:m=>d(m??M.q)}),u=b("div",{class:"branches","data-testid":"branches"});n.append(i.el,b("div",{class:"line"},a,s),b("div",{class:"line"},b("label",{class:"field"},b("span",{class:"field-name",text:"Points N"}),r),b("label",{class:"field"},b("span",{class:"field-name",text:"Seconds"}),o),c,b("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),l,u);let h=()=>{if(!e.from||!e.to){bt(s,"");return}let m=wx(e.from,e.to);bt(s,`${ue(Di(Li(Qt(e.to),Qt(e.from))),"length")} long${m>1e-6?`, turning ${ue(m,"angle")}`:", orientation kept"}`),Vo(Array.from({length:33},(g,x)=>Qt(Jd(e.from,e.to,x/32))))};async function d(m){let g=await Oe("follow",{T0:e.from,T1:e.to,n:e.n,start:m});M.track=g,f(g,m)}function f(m){if(l.say(m.explain,m.complete?"good":"wrong"),Vt(u,m.branches.length?b("h3",{text:"Branches that start at the first pose"}):null,m.branches.map((v,A)=>b("button",{type:"button",class:`branch ${A===m.chosen?"chosen":""}`,"aria-pressed":String(A===m.chosen),"data-testid":`branch-${A+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await Ri(v.q,.4,`take branch ${A+1}`),c.ask(v.q)}}},b("span",{class:"branch-name",text:`${A+1}  ${v.label}`}),p(v.s),b("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),Vo(m.path.map(Qt)),!m.q.length){Ii(null);return}let g=m.path.length,x=m.q.map((v,A)=>A+1),T=m.q.map((v,A)=>g>1?e.seconds*A/(g-1):0);Ii(lr({table:M.table,q:m.q,xs:x,xName:"point",xEnd:g,seconds:T,title:`${M.table.name}: straight line, ${m.q.length} of ${g} points`,events:m.events.map(v=>({...v,x:1+v.s*(g-1),short:v.cause}))}))}function p(m){let g=b("span",{class:"bar-fill"});return g.style.setProperty("width",`${100*m}%`),b("span",{class:"bar"},g)}let _=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};nt("panel",m=>{m==="path"&&(e.from??=iw(),e.to??=iw(),_())}),nt("path-loaded",_),nt("units",h),nt("table",m=>{["postures","name","gripper"].includes(m)||(l.say(""),Vt(u),Vo([]),t.hidden||_())})}};var rw=Math.PI/180,XL=()=>({turn_speed:180*rw,turn_acceleration:600*rw,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var YL=n=>M.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??Yi(),gu=n=>zn(fa(YL(n)),M.frames.at(-1));function ep(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(c=>c!==null),a=Math.min(...o),l=Math.min(Math.max(...o),t[r]);o.length===2&&a<=l&&(i[t[r]]={...s,first:a,last:l})}),i.filter(Boolean)}function Jo(n,t,{key:e,open:i}={}){ut("did",{label:t,key:e,open:i}),!M.program.length&&n.length&&(M.start??=M.q),M.program=n,ut("program")}var Ko=(n,t,e,i)=>Jo(M.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function ow(n,t){ut("did",{label:t,key:"limits"}),M.limits={...np(),...n},ut("program","limits")}var np=()=>({...XL(),...M.limits});function aw(n,t="set the start of the program"){ut("did",{label:t}),M.start=n,ut("program")}var ip=()=>M.start?.length===M.table.joints.length?M.start:M.q;function El(){let n=np(),t=M.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:ip(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:M.program.map(({name:i,...s})=>s)}}var ZL=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),bo=()=>M.routing??ZL();function Tl(n,t,e=t){ut("did",{label:t,key:e}),M.routing={...bo(),...n},ut("routing")}var G0=()=>{let n=bo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function sp(){let n=bo(),t=M.path,e=M.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:G0(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:M.world,clearance:e?n.clearance:0}}function V0(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Al=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function lw(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Al(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>V0(n,l)(o,r))}var Qo=Math.PI/180,cw=3.4,jL=2.1,uw=.5,JL=.9;function hw({drag:n,drop:t,scrub:e}){let i=b("canvas",{"aria-hidden":"true"}),s=b("div",{class:"route-now",hidden:!0}),r=b("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(D=>b("div",{class:`route-end ${D}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":D==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${D}`,hidden:!0})),a=b("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function _(){let D=p(),B=a.clientWidth,Q=a.clientHeight,Y={l:cw*D,t:uw*D,w:B-(cw+JL)*D,h:Q-(uw+jL)*D},j=-Math.PI,et=Math.PI;if(l.map&&!Al(l.map))j=l.map.turn[0],et=l.map.turn.at(-1);else if(l.turn.length){let dt=90*Qo;j=Math.min(j,dt*Math.floor(Math.min(...l.turn)/dt)),et=Math.max(et,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...Y,lo:j,hi:et,W:B,H:Q}}let m=D=>u.l+D*u.w,g=D=>u.t+(1-(D-u.lo)/(u.hi-u.lo))*u.h,x=D=>u.lo+(1-(D-u.t)/u.h)*(u.hi-u.lo),T=D=>Ot.curves[Math.max(l.branches.indexOf(D),0)%Ot.curves.length];function v(){f=(l.map?.branches??[]).map((D,B)=>{let Q=V0(l.map,B),Y=l.map.s.length,j=l.map.turn.length,et=b("canvas",{width:Y,height:j}),dt=et.getContext("2d"),ft=dt.createImageData(Y,j),st=parseInt(T(D).slice(1),16);for(let yt=0;yt<Y;yt++)for(let xt=0;xt<j;xt++){if(!Q(yt,xt))continue;let Tt=4*((j-1-xt)*Y+yt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:D,c:et}})}function A(){if(!l||!a.clientWidth)return;_();let D=Math.min(devicePixelRatio,2),B=i.getContext("2d");i.width=u.W*D,i.height=u.H*D,B.scale(D,D);let Q=.76*p();B.font=`${Q}px "Inter Variable", system-ui, sans-serif`,B.fillStyle=Ot.ground,B.fillRect(u.l,u.t,u.w,u.h),B.save(),B.beginPath(),B.rect(u.l,u.t,u.w,u.h),B.clip(),S(B),y(B),w(B),B.restore(),U(B,Q),N()}function S(D){let B=l.map;if(!B)return;let Q=B.turn[1]-B.turn[0],Y=Al(B),j=B.turn[0]-Q/2,et=B.turn.at(-1)+Q/2,dt=Y?Math.floor((u.lo-j)/(2*Math.PI)):0,ft=Y?Math.ceil((u.hi-et)/(2*Math.PI)):0;for(let{name:st,c:yt}of f)if(!(c&&c!==st)){D.globalAlpha=(c?.4:.3)*(Ot.dark?.8:1);for(let xt=dt;xt<=ft;xt++){let Tt=g(et+2*Math.PI*xt),At=g(j+2*Math.PI*xt);D.drawImage(yt,u.l,Tt,u.w,At-Tt)}}D.globalAlpha=1}function y(D){if(!l.blocked)return;let[B,Q]=l.blocked.s,Y=m(B),j=Math.max(m(Q)-Y,3);D.fillStyle=Ot.wrong,D.globalAlpha=.75,D.fillRect(Math.min(Y,u.l+u.w-j),u.t,j,u.h),D.globalAlpha=1}function w(D){if(!l.q.length)return;let B=[[0]];l.labels.forEach((Q,Y)=>{Y&&Q!==l.labels[Y-1]&&B.push([Y-1]),B.at(-1).push(Y)});for(let[Q,Y]of[[.38,!0],[.18,!1]])for(let j of B){D.beginPath();for(let et of j)D.lineTo(m(l.s[et]),g(l.turn[et]));D.lineWidth=Q*p(),D.lineJoin=D.lineCap="round",D.strokeStyle=Y?Ot.panel:Ot.curves[l.labels[j.at(-1)]%Ot.curves.length],D.stroke()}}function U(D,B){D.strokeStyle=Ot.line,D.strokeRect(u.l,u.t,u.w,u.h),D.fillStyle=Ot.muted,D.textBaseline="middle",D.textAlign="right";let Q=(u.hi-u.lo)/Qo,Y=[5,10,15,30,45,90,180].find(et=>Q/et<=6)??180;for(let et=Math.ceil(u.lo/Qo/Y-1e-9)*Y;et<=u.hi/Qo+1e-6;et+=Y){let dt=g(et*Qo);D.fillText(pn(et*Qo,"angle",gt.angle==="deg"?0:2),u.l-.45*B,dt),D.globalAlpha=.5,D.beginPath(),D.moveTo(u.l,dt),D.lineTo(u.l+u.w,dt),D.lineWidth=1,D.stroke(),D.globalAlpha=1}D.textBaseline="top",D.textAlign="center";let j=u.t+u.h+.45*B;for(let et of[0,.25,.5,.75,1])D.fillText(String(et),m(et),j);D.fillText("path, from 0 to 1",m(.5),j+1.15*B),D.save(),D.translate(.5*B,u.t+u.h/2),D.rotate(-Math.PI/2),D.textBaseline="middle",D.fillText(`turn of the tool, ${gt.symbol("angle")}`,0,0),D.restore()}let L=D=>h?.which===D?h.turn:D==="start"?l.turn[0]:l.turn.at(-1);function N(){o.forEach((D,B)=>{let Q=B?"end":"start",Y=!!(l?.turn.length&&l.map);if(D.hidden=!Y,!Y)return;let j=L(Q);D.style.setProperty("left",`${m(B)}px`),D.style.setProperty("top",`${g(j)}px`),D.classList.toggle("pinned",d[Q]),D.setAttribute("aria-valuemin",pn(u.lo,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuemax",pn(u.hi,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuenow",pn(j,"angle").replace("\u2212","-")),D.setAttribute("aria-valuetext",`${ue(j,"angle")}${d[Q]?", held":""}`)})}let H=D=>Math.min(Math.max(D,u.lo),u.hi);function $(D,B){h={which:D,turn:H(B)},N();let Q=lw(l.map,D==="start"?0:1,h.turn);r.hidden=!1,bt(r,`${ue(h.turn,"angle",1)}: ${Q.length?Q.join("; "):"closed on every branch"}`),r.dataset.tone=Q.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",D==="end"),n(D,h.turn)}function P(){if(!h)return;let{which:D,turn:B}=h;r.hidden=!0,t(D,B)}o.forEach((D,B)=>{let Q=B?"end":"start";D.addEventListener("pointerdown",Y=>{Y.preventDefault(),D.focus(),D.setPointerCapture(Y.pointerId);let j=L(Q)-x(Y.clientY-a.getBoundingClientRect().top),et=ft=>$(Q,x(ft.clientY-a.getBoundingClientRect().top)+j);D.addEventListener("pointermove",et);let dt=()=>{D.removeEventListener("pointermove",et),P()};D.addEventListener("pointerup",dt,{once:!0}),D.addEventListener("pointercancel",dt,{once:!0})}),D.addEventListener("keydown",Y=>{let j={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[Y.key];if(j)$(Q,L(Q)+j*Qo*(Y.shiftKey?.1:1));else if(Y.key==="Enter")P();else if(Y.key==="Escape"&&h)z(),n(Q,null);else return;Y.preventDefault(),Y.stopPropagation()}),D.addEventListener("blur",()=>h?.which===Q&&P())}),i.addEventListener("pointerdown",D=>{if(!l?.q.length)return;let B=Y=>e(Math.min(Math.max((Y.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(D.pointerId),B(D),i.addEventListener("pointermove",B);let Q=()=>i.removeEventListener("pointermove",B);i.addEventListener("pointerup",Q,{once:!0}),i.addEventListener("pointercancel",Q,{once:!0})});function z(){h=null,r.hidden=!0,l&&N()}return new ResizeObserver(Zs(A)).observe(a),{el:a,paint(){l&&v(),A()},cancel:z,show(D,B=null,Q={start:!1,end:!1}){l=D,d=Q,h=null,r.hidden=!0,a.hidden=!D,D&&(c=B,v(),A())},only(D){c=D,A()},at(D){s.hidden=D===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${m(D)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(D,B=null){let Q=a.getBoundingClientRect();return[Q.x+m(D==="end"?1:0),Q.y+g(B??L(D))]}}}var dw=Math.PI/180;function fw(){let n=(p,_,m)=>Tl({...p,start:null,end:null},_,m),t=(p,_,m)=>{let g=b("span",{class:"field-name"}),x=b("label",{class:"field"},g,m);return x.label=()=>{g.textContent=_==="plain"?p:`${p}, ${gt.symbol(_)}`},x},e=(p,_,m,g,x)=>{let T=bn({label:p,kind:_,testid:m,check:g,input:x});return{f:T,el:t(p,_,T)}},i=Ge("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*dw,45*dw]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,_=>Math.abs(_)<=4*Math.PI?null:"at most two turns",_=>{let m=bo().turn?.slice()??[0,0];m[p]=_,n({turn:m},"bound the turn of the route",`route-turn-${p}`)})),r=Ge("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=cn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=b("details",{class:"fold"},b("summary",{text:"More that is free, and what must be kept"}),b("div",{class:"line"},o.el),b("div",{class:"line"},b("label",{class:"field"},b("span",{class:"field-name",text:"Cheapest"}),a)),b("div",{class:"line"},l.el),b("div",{class:"line"},c.el)),h=b("div",{},b("div",{class:"line"},b("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),b("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let p=bo();i.mark(p.turn?"within":"free"),s.forEach((_,m)=>{_.el.hidden=!p.turn,_.f.put(p.turn?.[m]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,l.f.put(p.singularity),c.f.put(p.clearance),c.el.hidden=!M.world.some(_=>_.role!=="object"&&_.kind!=="frame"),d.forEach(_=>_.el.label())}return nt(["units","world"],f),nt("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var pw=n=>({id:"route",title:"Route",wide:!0,build(t){let e=M.path,i=null,s=null,r=null,o=tp("route",()=>x()),a=fw(),l=(P,z,D,B={})=>b("button",{type:"button",text:P,"data-testid":z,on:{click:D},...B}),c=l("Let both ends free","free-ends",()=>{Tl({start:null,end:null},"let the ends of the route free"),f.ask()}),u=l("Send to the program","route-to-program",N,{hidden:!0}),h=l("","route-others",L,{hidden:!0}),d=yo("route-verdict"),f=vo({text:"Find the route",working:"Looking \u2026",testid:"find-route",verdict:d,root:t,async ask(){try{let P=await Oe("route",sp());P.stopped||T(P)}catch(P){throw m.cancel(),P}}}),p=b("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),_=b("div",{class:"branches","data-testid":"route-list"}),m=hw({drag:(P,z)=>z===null?fs(null):w(P,z),drop:(P,z)=>U(P,z),scrub:P=>r&&M.motion===r&&kr(A(P))}),g=b("details",{class:"fold",open:!0},b("summary",{text:"The line"}),o.el);m.el.hidden=!0,c.hidden=!0,t.append(b("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),g,a.el,b("div",{class:"line"},f,c,u),m.el,p,d,b("div",{class:"line"},h),_);let x=()=>{e.from&&e.to&&!i&&Vo(Array.from({length:33},(P,z)=>Qt(Jd(e.from,e.to,z/32))))};function T(P){let z=bo();if(i=M.route={...P,turn:v(P,z),asked:[e.from,e.to]},s=P.found?P.branches[P.labels[0]]:null,P.found&&(g.open=!1),d.say(P.text,P.found?"good":P.verdict==="IMPOSSIBLE"?"wrong":"note"),m.show(i,s,{start:!!z.start,end:!!z.end}),fs(null),c.hidden=!(z.start||z.end),u.hidden=!P.found,h.hidden=!1,bt(h,P.found?"Routes that begin with other postures":"What would let it through?"),Vt(_),S(),Vo(P.points),!P.found){r=null,Ii(null);return}let D=P.q.length;r=lr({table:M.table,q:P.q,xs:P.q.map((B,Q)=>Q+1),xName:"point",xEnd:D,seconds:P.s.map(B=>e.seconds*B),title:`${M.table.name}: route, ${D} points`}),Ii(r)}function v(P,z){if(!P.found||!P.map||!Al(P.map))return P.turn;let D=z.start?z.start.turn-P.turn[0]:z.end?z.end.turn-P.turn.at(-1):0;return P.turn.map(B=>B+2*Math.PI*Math.round(D/(2*Math.PI)))}let A=P=>i.s.reduce((z,D,B)=>Math.abs(D-P)<Math.abs(i.s[z]-P)?B:z,0);function S(){Vt(p,i.branches.map((P,z)=>{let D=b("span",{class:"swatch"});return D.style.setProperty("background",Ot.curves[z%Ot.curves.length]),b("button",{type:"button",class:"chip","aria-pressed":String(s===P),title:s===P?"Show all branches":"Show this branch alone","data-testid":`route-branch-${z+1}`,on:{click:()=>{s=s===P?null:P,m.only(s),S()}}},D,P)}))}let y=(P,z)=>{let D=P==="start",B=D?0:i.q.length-1;return{T:D?e.from:e.to,turn:z,free:G0(),near:i.q[B],branch:i.branches[i.labels[B]]}},w=Ys(async(P,z)=>{let D=await Oe("route_posture",y(P,z)).catch(()=>null);fs(D?.q??null)});async function U(P,z){try{let D=await Oe("route_posture",y(P,z));if(!D.q)throw new Error(`The route cannot ${P} there. ${D.why}`);Tl({[P]:{turn:z,q:D.q,branch:D.label}},`turn the ${P} of the route to ${ue(z,"angle",1)}`),await f.ask()}catch(D){fs(null),m.cancel(),be(D.message,"wrong")}}async function L(){h.disabled=!0,bt(h,"Looking \u2026");try{let P=await Oe("route_others",sp());if(P.stopped)return;let z=D=>`cost ${Number(D.toPrecision(3))}`;Vt(_,P.relaxations.map(D=>b("p",{class:"verdict","data-tone":"note",text:D})),P.alternatives.map((D,B)=>b("button",{type:"button",class:"branch","data-testid":`route-other-${B+1}`,on:{click:async()=>{Tl({start:{turn:D.turn,q:D.q,branch:D.branch},end:null},`begin the route ${D.branch}`),await f.ask()}}},b("span",{class:"branch-name",text:D.branch}),b("span",{class:"hint",text:`begins turned ${ue(D.turn,"angle",1)}`}),b("span",{class:"branch-end",text:z(D.cost)}))),P.relaxations.length+P.alternatives.length?null:b("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),h.hidden=!0}catch(P){d.say(P.message)}finally{h.disabled=!1,i&&bt(h,i.found?"Routes that begin with other postures":"What would let it through?")}}async function N(){u.disabled=!0;try{let P=await Oe("route_program",sp());if(P.stopped)return;let z=!M.program.length,D=z?P.steps.slice(1):P.steps;z&&(M.start=P.steps[0].q),Jo([...M.program,...D],"send the route to the program");let B=`${ue(P.metres,"length",3)} and ${ue(P.radians,"angle",3)}`;be(`Sent as a spline through ${P.poses} poses; it strays by at most ${B}.`),n()?.("program")}catch(P){d.say(P.message)}finally{u.disabled=!1}}let H=()=>{M.routing&&(M.routing={...M.routing,start:null,end:null})};function $(){i=M.route=null,d.say(""),m.show(null),u.hidden=h.hidden=c.hidden=!0,Vt(p),Vt(_),fs(null)}nt("panel",P=>{if(P!=="route")return;let z=()=>M.frames.at(-1).slice();e.from??=z(),e.to??=z(),o.show(),x(),i&&m.paint()}),nt("played",()=>{!r||M.motion!==r?m.at(null):m.at(i.s[cS()]??null)}),nt("motion",()=>M.motion!==r&&m.at(null)),nt("theme",()=>{m.paint(),i&&S()}),nt("units",()=>m.paint()),nt("routing",P=>{P==="undo"&&i&&f.ask()}),nt(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(H(),$())}),nt("table",P=>{["postures","name","gripper"].includes(P)||(P!=="undo"&&H(),$())}),m.el.addEventListener("where",P=>Object.assign(P.detail,{at:m.place(P.detail.which,P.detail.turn)}))}});function mw(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>Ko(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let p=bn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:_=>{n(()=>e(u,{[h]:_},h))}});return p.put(M.program[u][h]??null),b("label",{class:"field"},b("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),p)}let s=(u,h)=>{let d=M.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>ks(d,`step-${u+1}-${h}`,()=>M.program[u]?.[h],f=>{let p=M.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...p}:{[h]:f},h))}).el;function a(u,h){let d=Ge("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",_=>Ko(h,_==="centre"?{centre:Qt(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return b("div",{},b("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((_,m)=>{let g=bn({label:`Step ${h+1}, centre ${_}`,kind:"length",testid:`step-${h+1}-centre-${m}`,input:x=>{let T=M.program[h].centre.slice();T[m]=x,n(()=>e(h,{centre:T},"centre"))}});return g.put(u.centre[m]),b("label",{class:"field"},b("span",{class:"field-name",text:_}),g)}),p=b("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:p.checked},"far")}});return b("div",{},b("div",{class:"line"},d),b("div",{class:"line"},...f,b("span",{class:"unit",text:gt.length})),b("label",{class:"check"},p,"the longer way round"))}function l(u,h){let d=f=>Ko(h,{through:f,T:f.at(-1)},t(h));return b("div",{class:"line"},b("span",{class:"field-name",text:`Goes through ${u.through.length} poses, the last one its target`}),b("button",{type:"button",class:"quiet",text:"Add the present pose","data-testid":`step-${h+1}-through`,on:{click:()=>d([...u.through,gu(h)])}}),b("button",{type:"button",class:"quiet",text:"Take the last one out",disabled:u.through.length<2,on:{click:()=>d(u.through.slice(0,-1))}}))}function c(u,h){return u.kind==="wait"?b("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?b("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?b("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?b("div",{class:"step-editor"},o(h)("T","The frame, in the base"),b("div",{class:"line"},b("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${h+1}-teach`,on:{click:()=>Ko(h,{T:M.frames.at(-1).slice()},`teach step ${h+1}`)}}),b("button",{type:"button",class:"quiet",text:"The base",title:"The poses that follow are meant in the base again",on:{click:()=>Ko(h,{T:Yi()},`end the frame at step ${h+1}`)}}))):u.kind==="output"?b("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),b("label",{class:"check"},b("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):b("div",{class:"step-editor"},b("div",{class:"line"},cn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:gt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${gt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?l(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),b("div",{class:"line"},b("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${h+1}-teach`,on:{click:()=>Ko(h,{...s(h,gu(h)),q:u.kind==="joint"?M.q.slice():null},`teach step ${h+1}`)}}),u.q?b("button",{type:"button",class:"quiet",text:"Go there",on:{click:()=>Ri(u.q.slice(),.8,`go to step ${h+1}`)}}):null))}return c}function gw(){let n=b("div",{class:"line limits-of"}),t=()=>{let e=new Set(M.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=bn({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>ow({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(np()[r]),c===null&&(u.placeholder="none"),b("label",{class:"field"},b("span",{class:"field-name",text:`${o}, ${gt.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Vt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return nt(["table","units"],t),nt("program",e=>e==="undo"&&t()),t(),n}var rp={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function W0(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>pn(t,Ze(M.table.joints[e]??{type:"R"}),1)).join(", "):`${Qt(n.T).map(t=>pn(t,"length",1)).join(", ")} ${gt.length}${n.kind==="spline"?`, ${n.through.length} poses`:""}`}var xw=200,KL=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Rl=()=>gu(op()),op=()=>M.program.length,_w={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=b("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=yo("program-verdict"),o=b("details",{class:"fold",hidden:!0},b("summary",{text:"What binds, and when"}),b("p",{class:"hint prose"})),a=(S,y,w,U)=>b("button",{type:"button",text:y,title:w,"data-testid":`step-add-${S}`,on:{click:()=>f(U())}}),l=vo({text:"Run the program",working:"Planning \u2026",testid:"run-program",verdict:r,root:n,open:()=>M.program.length>0,ask:v}),c=b("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(b("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:M.q.slice(),T:Rl(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Rl(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Rl(),blend:0})),a("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Rl()],T:Rl(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),a("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:M.frames.at(-1).slice()})),a("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max(op(),1),times:1}))),b("div",{class:"line spread"},c,b("span",{class:"line"},b("button",{type:"button",class:"quiet",text:"Start here","data-testid":"start-here",title:"The program begins in the present posture",on:{click:()=>aw(M.q.slice())}}),b("button",{type:"button",class:"quiet",text:"Go to the start",on:{click:()=>Ri(ip().slice(),.8,"go to the start")}}))),s,gw(),b("div",{class:"line"},l,b("span",{class:"line"},cn("Language of the file",KL,u,S=>{u=S},{"data-testid":"dialect"}),b("button",{type:"button",text:"Save the program","data-testid":"save-program",on:{click:A}}))),r,o),op=()=>t>=0?t+1:M.program.length;let h=()=>M.program.slice(0,op()).findLast(S=>S.T&&S.kind!=="frame")?.T??Rl(),d=()=>M.program.findLast(S=>S.kind==="gripper")?.value??0;function f(S){if(M.program.length>=xw){be(`At most ${xw} steps.`,"wrong");return}let y=t>=0?t+1:M.program.length;t=y;let w=ep(M.program,M.program.map((U,L)=>L<y?L:L+1));if(S.kind==="call"&&!y){be("There is no step before it that could be done again.","wrong"),t=-1;return}Jo([...w.slice(0,y),S,...w.slice(y)],`add a step: ${rp[S.kind].toLowerCase()}`)}function p(S,y){if(y<0||y>=M.program.length||S===y)return;let w=M.program.map((L,N)=>N);w.splice(y,0,...w.splice(S,1));let U=ep(M.program,M.program.map((L,N)=>w.indexOf(N)));t=y,Jo(U,`move step ${S+1} to ${y+1}`),s.children[y]?.querySelector(".step-name")?.focus()}function _(S){t=-1,Jo(ep(M.program,M.program.map((y,w)=>w===S?-1:w<S?w:w-1)),`remove step ${S+1}`)}function m(S,y){let w=y===t,U=b("button",{type:"button",class:"step-name quiet","aria-expanded":String(w),"data-testid":`step-${y+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=w?-1:y,T()},keydown:N=>{let H={ArrowUp:-1,ArrowDown:1}[N.key];H&&N.altKey?(N.preventDefault(),p(y,y+H)):H?(N.preventDefault(),s.children[y+H]?.querySelector(".step-name")?.focus()):N.key==="Delete"&&_(y)}}},b("b",{text:rp[S.kind]}),` ${W0(S)}`,S.blend?b("span",{class:"hint",text:`, blend ${ue(S.blend,"length",0)}`}):null),L=b("li",{class:`step${e?.step===y?" failed":""}${w?" open":""}`,draggable:"true","data-testid":`step-row-${y+1}`},b("div",{class:"step-line"},b("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),b("span",{class:"hint",text:String(y+1)}),U,_o({k:y,n:M.program.length,name:`step ${y+1}`,move:p,remove:_})),e?.step===y?b("p",{class:"reason",text:e.text}):null,w?x(S,y):null);return L.addEventListener("dragstart",N=>{i=y,N.dataTransfer.effectAllowed="move",N.dataTransfer.setData("text/plain",String(y))}),L.addEventListener("dragover",N=>{i<0||(N.preventDefault(),L.classList.add("target"))}),L.addEventListener("dragleave",()=>L.classList.remove("target")),L.addEventListener("drop",N=>{N.preventDefault();let H=i;i=-1,H>=0&&p(H,y)}),L}let g=!1,x=mw(S=>{g=!0,S(),g=!1});function T(){if(g){M.program.forEach((y,w)=>{let U=s.children[w]?.querySelector(".step-name");U&&Vt(U,b("b",{text:rp[y.kind]}),document.createTextNode(` ${W0(y)}`))});return}t>=M.program.length&&(t=-1),Vt(s,M.program.map(m)),M.program.length||s.append(b("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.show();let S=ip();bt(c,M.program.length?`Starts at ${S.map((y,w)=>pn(y,Ze(M.table.joints[w]),1)).join(", ")}`:"")}async function v(){let S=await Oe("program",{...El(),world:M.world});e=S.failed,e&&(t=e.step),r.say(e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[S.explain,S.clear?.text].filter(Boolean).join(`
`),e||S.clear?.verdict==="HIT"?"wrong":S.clear?.verdict==="UNCERTAIN"?"note":"good"),o.hidden=!S.tight.length,bt(o.lastChild,S.tight.map(w=>w.text).join(`
`)),T();let y=S.events.map(([w,U,L])=>({x:w,s:0,text:`${U} ${L} at ${w.toFixed(2)} s`,short:U==="gripper"?L>.5?"close":"open":U,stop:!1}));Ii(lr({table:M.table,q:S.q,xs:S.t,xName:"time",seconds:S.t,dq:S.dq,ddq:S.ddq,events:y,title:`${M.table.name}: program, ${S.duration.toFixed(2)} s`,happens:S.events,tight:S.tight,limits:El().limits}))}async function A(){try{let S="program",{text:y,name:w}=await Oe("program_file",{...El(),dialect:u,name:S});ci(w,y)}catch(S){r.say(S.message)}}nt(["program","units","table"],S=>{S!=="limits"&&(e=null,T())}),T()}};var ta=new An,q0=new nl,QL=new ge,tD=n=>new ii({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function $0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new ke(e,3)),n}var yw=n=>n.rotateX(Math.PI/2),ap={box:n=>[$0(new Bi(...n.size)),n.T],cylinder:n=>[$0(yw(new Ai(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new G(...n.a),e=new G(...n.b).sub(t),i=e.length(),s=new ge().makeRotationFromQuaternion(new hn().setFromUnitVectors(new G(0,0,1),i?e.clone().normalize():new G(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[$0(yw(new No(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function X0(n,t,e=.86){if(!ap[n.kind])return null;let[i,s]=ap[n.kind](n),r=tD(t);r.opacity=e,r.depthWrite=e>.5;let o=new Ye(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var bw=()=>[...M.world,...M.things??[]],Mw=n=>{let t=Cl.get(n.name)??n.T;return t?Qt(t):n.a.map((e,i)=>(e+n.b[i])/2)},eD=n=>Mw(n).map((t,e)=>t+(e===2?1:0));function nD(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=Qt(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Xs(n.T,s)[o])))}function Sw(){fn.add(ta,q0.group),nt(["world","table"],vw),nt("theme",vw)}var Cl=new Map;function Y0(n,t){if(t)Cl.set(n,t);else if(!Cl.delete(n))return;let e=ta.children.find(s=>s.userData.name===n),i=M.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),n()}var ww=n=>Cl.get(n)??null;function Ew(){for(let n of[...Cl.keys()])Y0(n,null)}function iD(){let n=bw();q0.show(n.filter(t=>t.kind==="frame"),.11*li(M.table),n.filter(t=>ap[t.kind]).map(t=>({text:t.name,at:Mw(t),wish:eD(t)})))}function vw(){for(let t of ta.children)t.geometry.dispose();ta.clear();let n=bw();for(let t of n)if(t.kind==="curve"){let e=new Te().setFromPoints(t.points.map(i=>new G(...i)));ta.add(new tr(e,new Qi({color:Ot.trace,fog:!1})))}else if(ap[t.kind]){let{mesh:e,T:i}=X0(t,t.role==="object"?Ot.accent:Ot.ghost);e.matrix.copy(QL.set(...Cl.get(t.name)??i)),e.userData.name=t.name,ta.add(e)}iD(),Ur("world",n.flatMap(nD)),xe()}var Tw=()=>ta.children.length+(q0.last?.[0].length??0);var Il=new tr(new Te,new Qi({depthTest:!1,fog:!1})),Ll=new Ar(new Te,new er({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Il.renderOrder=Ll.renderOrder=6;Il.frustumCulled=Ll.frustumCulled=!1;Il.visible=Ll.visible=!1;var Pl=new An,xu=null,Aw="",rD=()=>M.watch||M.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),oD=Ys(async()=>{try{let n=await Oe("clearance",{q:M.q,world:M.world});M.clearance=n}catch(n){M.clearance={refused:n.message}}Z0(),ut("clearance")});function Rw(){rD()&&M.table.joints.length?oD():M.clearance&&(M.clearance=null,Z0(),ut("clearance"))}function Z0(){let n=M.clearance,t=!!n?.points?.length;if(Il.visible=Ll.visible=t,t){let e=n.points.map(i=>new G(...i));for(let i of[Il,Ll])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Ot.trace:Ot.wrong)}xe()}async function j0(n){if(xu=null,n){let{bodies:t,explain:e}=await Oe("bodies",{});xu=t,Aw=e}for(let t of Pl.children)t.geometry.dispose();Pl.clear();for(let t of xu??[]){let e=X0(t,Ot.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},Pl.add(e.mesh))}return Pw(),Aw}var Cw=()=>Pl.children.length,aD=new ge;function Pw(){for(let n of Pl.children){let{on:t,T:e}=n.userData;M.frames[t]&&n.matrix.copy(aD.set(...zn(M.frames[t],e)))}xe()}function Iw(){fn.add(Il,Ll,Pl),nt(["q","world","watch"],Rw),nt("plan",Rw),nt("q",()=>xu&&Pw()),nt("table",()=>xu&&j0(!1).then(()=>ut("bodies-gone"))),nt("theme",Z0)}var cD=60,uD={box:"Box",cylinder:"Cylinder",frame:"Frame"},hD={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function J0(n,t,e={}){ut("did",{label:t,...e}),M.world=n,ut("world")}var lp=(n,t,e)=>J0(M.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function dD(n,t){if(M.world.length>=cD)return;let e=Qt(M.frames.at(-1)),i=.06*li(M.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*M.world.length;let o=t==="object"?"object":n,a=1;for(;M.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};J0([...M.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var Lw={id:"world",title:"World",wide:!0,build(n){let t=b("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=b("p",{class:"hint prose"}),i=b("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{M.watch=i.checked,ut("watch")}}}),s=b("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await j0(s.checked);bt(e,s.checked?h:"")}catch(h){bt(e,h.message)}}}}),r=b("div",{class:"things","data-testid":"world"}),o=(h,d,f,p)=>b("button",{type:"button",text:h,title:p,"data-testid":`add-${f}-${d}`,on:{click:()=>dD(d,f)}});n.append(b("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),b("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),b("div",{class:"line"},b("label",{class:"check"},i,"Distance, always"),b("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),nt(["clearance","units"],()=>{let h=M.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];bt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${ue(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${ue(-h.metres,"length")}.`))}),nt("bodies-gone",()=>{s.checked=!1,bt(e,"")});let l=!1,c=()=>{l||(Vt(r,M.world.map(u)),M.world.length||r.append(b("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=g=>(...x)=>{l=!0,g(...x),l=!1},p=b("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>p.value&&lp(d,{name:p.value},`name ${p.value}`)}}),_=hD[h.kind].map((g,x)=>{let T=bn({label:`${h.name}, ${g}`,kind:"length",testid:`world-${d+1}-size-${x}`,check:v=>v>0?null:"more than 0",input:f(v=>{let A=M.world[d],S=h.kind==="box"?{size:A.size.map((y,w)=>w===x?v:y)}:{[x?"h":"r"]:v};lp(d,S,`size of ${h.name}`)})});return T.put(h.kind==="box"?h.size[x]:x?h.h:h.r),b("label",{class:"field"},b("span",{class:"field-name",text:`${g}, ${gt.length}`}),T)}),m=ks("Place of its middle",`world-${d+1}`,()=>M.world[d]?.T,f(g=>lp(d,{T:g},`move ${h.name}`)));return b("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},b("div",{class:"line spread"},b("span",{class:"line"},p,b("span",{class:"hint",text:uD[h.kind]}),h.kind==="frame"?null:cn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,g=>lp(d,{role:g},`make ${h.name} an ${g}`))),_o({k:d,name:h.name,remove:()=>J0(M.world.filter((g,x)=>x!==d),`remove ${h.name}`)})),_.length?b("div",{class:"line"},_):null,m.el)}nt(["world","units"],h=>h!=="python"&&c()),c()}};var fD=40,Dw={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return M.sequence.postures},set postures(d){M.sequence.postures=d},get rate(){return M.sequence.rate}},e=b("thead"),i=b("tbody"),s=yo("sequence-verdict"),r=vo({text:"Run the sequence",working:"Planning \u2026",testid:"run-sequence",verdict:s,root:n,open:()=>t.postures.length>1,ask:h}),o=b("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let d=t.postures[1];if(d){ut("did",{label:"use the same times for all legs"});for(let f of t.postures.slice(2))f.seconds=d.seconds,f.hold=d.hold;u()}}}});n.append(b("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),b("div",{class:"scroll"},b("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),b("div",{class:"line"},b("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(M.q.slice())}}),b("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(M.table.postures??{}).forEach(([d,f])=>a(f.slice(),d))}}),o),b("div",{class:"line"},r),s);function a(d,f){t.postures.length>=fD||(ut("did",{label:"add a posture to the sequence"}),t.postures.push({name:f??`P${t.postures.length}`,q:d,seconds:5,hold:0}),u(),ut("sequence"))}function l(d,f){ut("did",{label:`move ${t.postures[d].name} ${f<d?"up":"down"}`}),t.postures.splice(f,0,...t.postures.splice(d,1)),u(),ut("sequence")}function c(d){ut("did",{label:`remove ${t.postures[d].name}`}),t.postures.splice(d,1),u(),ut("sequence")}function u(){let d=M.table.joints;t.postures=t.postures.filter(f=>f.q.length===d.length),r.show(),Vt(e,b("tr",{},b("td"),d.map((f,p)=>b("th",{},b("i",{text:"q"}),b("sub",{text:String(p+1)}),b("span",{class:"unit",text:` ${gt.symbol(Ze(f))}`}))),b("th",{text:"leg, s"}),b("th",{text:"rest, s"}),b("td"))),Vt(i,t.postures.map((f,p)=>{let _=d.map((g,x)=>{let T=bn({label:`${f.name}, q${x+1}`,kind:Ze(g),testid:`seq-${p}-q${x+1}`,input:v=>{ut("did",{label:`edit ${f.name} of the sequence`,key:`seq-${p}-${x}`}),f.q[x]=v,ut("sequence")}});return T.put(f.q[x],String(Number((f.q[x]*gt.factor(Ze(g))).toFixed(gt.digits(Ze(g))))+0)),b("td",{},T)}),m=(g,x,T)=>{if(p===0)return b("td");let v=bn({label:`${x} ${f.name}`,testid:`seq-${p}-${g}`,check:T,input:A=>{ut("did",{label:`edit ${f.name} of the sequence`,key:`seq-${p}-${g}`}),f[g]=A,ut("sequence")}});return v.put(f[g]),b("td",{},v)};return b("tr",{"data-testid":`seq-row-${p}`},b("th",{scope:"row"},b("button",{type:"button",class:"quiet",text:f.name,title:"Go there",on:{click:()=>Ri(f.q.slice())}})),_,m("seconds","Seconds to",g=>g>0?null:"more than 0"),m("hold","Rest after",g=>g>=0?null:"0 or more"),b("td",{class:"tools"},_o({k:p,n:t.postures.length,name:f.name,move:l,remove:c})))})),t.postures.length||i.append(b("tr",{},b("td",{class:"hint",colspan:String(d.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function h(){let d=t.postures,f=await Oe("motion",{postures:d.map(_=>_.q),seconds:d.slice(1).map(_=>_.seconds),holds:d.slice(1).map(_=>_.hold),rate:t.rate}),p=d.map((_,m)=>({x:f.arrivals[m],s:0,text:`${_.name} at ${f.arrivals[m].toFixed(2)} s`,short:_.name,stop:!1}));s.say(`${d.length} postures in ${f.t[f.t.length-1].toFixed(2)} s. ${pD(f.q)}`,"good"),Ii(lr({table:M.table,q:f.q,xs:f.t,xName:"time",seconds:f.t,dq:f.dq,events:p,title:`${M.table.name}: ${d.map(_=>_.name).join(" \u2013 ")}`}))}nt(["table","units","sequence-loaded"],u),u()}};function pD(n){let t=M.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var mD=.14,Mo=new Ye(new Rs(1,32,20),new ii({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));Mo.matrixAutoUpdate=!1;Mo.visible=!1;Mo.renderOrder=4;var _u="none";function gD(n,t,e){let i=Ax(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function Nw(n){_u=n,Uw()}var cp=()=>M.ellipsoid??null;function Uw(){let n=_u!=="none"&&M.table.joints.length>0;if(Mo.visible=n,M.ellipsoid=null,n){let t=gD(M.table,M.q,M.frames),e=mD*li(M.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(_u==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=Qt(M.frames.at(-1)),[a,l]=r,c={...r[2]};Mo.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),Mo.material.color.set(_u==="velocity"?Ot.trace:Ot.accent),Mo.material.side=fi,M.ellipsoid=t}xe(),ut("ellipsoid")}function Ow(){fn.add(Mo),nt(["q","theme"],()=>_u!=="none"&&Uw())}var up=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new te(n)),K0=new er({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Gi=new Ar(new Te,K0);Gi.frustumCulled=!1;Gi.visible=!1;fn.add(Gi);var Dl=null,yu=null,Vi=0,So={lo:0,hi:1};function Fw(n){Dl=new Float32Array(3*n),yu=new Float32Array(n),Vi=0,Gi.geometry.dispose(),Gi.geometry=new Te,Gi.geometry.setAttribute("position",new ke(Dl,3)),Gi.geometry.setAttribute("color",new ke(new Float32Array(3*n),3)),Gi.geometry.setDrawRange(0,0),Gi.visible=!0,xe()}function Bw(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Vi<yu.length;i+=4,Vi++)Dl.set(e.subarray(i,i+3),3*Vi),yu[Vi]=e[i+3];_D()}function _D(){let n=yu.slice(0,Vi).sort();So.lo=n[Math.floor(Vi*.02)]??0,So.hi=n[Math.max(Math.ceil(Vi*.98)-1,0)]??1;let t=new te,e=Gi.geometry.attributes.color.array,i=So.hi-So.lo||1;for(let s=0;s<Vi;s++){let r=Math.min(Math.max((yu[s]-So.lo)/i,0),1)*(up.length-1),o=Math.min(Math.floor(r),up.length-2);t.lerpColors(up[o],up[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Gi.geometry.setDrawRange(0,Vi),Gi.geometry.attributes.position.needsUpdate=!0,Gi.geometry.attributes.color.needsUpdate=!0,xe()}var vu=()=>Vi;function kw(n){is.localClippingEnabled=n!==null,K0.clippingPlanes=n===null?null:[new ni(new G(0,1,0),-n)],K0.needsUpdate=!0,xe()}function zw(){let n=new Fi;for(let i=0;i<Vi;i++)n.expandByPoint(new G(Dl[3*i],Dl[3*i+1],Dl[3*i+2]));let{min:t,max:e}=n;return Vi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Hw(){Vi=0,Gi.visible=!1,xe()}var Vw=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],hp=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ti(n,4):n.toExponential(2).replace("-","\u2212"),Ww={id:"analysis",title:"Analysis",build(n){let t=b("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(b("div",{title:h},b("dt",{text:u}),i[c]=b("dd",{"data-testid":`fact-${c}`})));let s=b("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=b("p",{class:"hint","data-testid":"ellipsoid-axes"});nt("ellipsoid",()=>{let c=cp();bt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>ue(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,b("h3",{text:"At the tool\u2019s point"}),Ge("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",Nw,"ellipsoid"),o,b("h3",{text:"Distance to the limits"}),s,b("h3",{text:"Reachable points"}),yD());let a=()=>{r=M.table.joints.map((c,u)=>{let h=b("span",{class:"bar-fill"}),d=b("span",{class:"bar-text"});return{el:b("div",{class:"distance"},b("span",{},b("i",{text:"q"}),b("sub",{text:String(u+1)})),b("span",{class:"bar"},h),d),fill:h,text:d}}),Vt(s,r.map(c=>c.el)),l()},l=Zs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let c=Pu(M.table,M.q,M.frames),u=c[0],h=c[c.length-1];bt(i.manipulability,hp(c.reduce((d,f)=>d*f,1))),bt(i.condition,u>1e-9?ti(h/u,1):"\u221E"),bt(i.least,hp(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},_)=>{let m=M.table.joints[_],g=M.q[_];if(m.lower===null||m.upper===null){f.style.setProperty("width","100%"),bt(p,"no limit");return}let x=Math.min(g-m.lower,m.upper-g),T=Math.max(2*x/(m.upper-m.lower||1),0);f.style.setProperty("width",`${100*T}%`),d.classList.toggle("outside",x<-1e-9),bt(p,x<-1e-9?`${ue(-x,Ze(m))} beyond`:ue(x,Ze(m)))})});nt("table",a),nt(["q","units","panel"],l),a()}};function yD(){let n="20000",t="manipulability",e=!1,i=b("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Zi("cancel",{kind:"cloud"}):d()}}),s=b("button",{type:"button",text:"Clear",on:{click:h}}),r=Ge("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>kw(f==="half"?M.table.base[7]:null),"cloud-cut"),o=b("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=b("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=b("span"),c=b("span"),u=b("div",{class:"legend-scale",hidden:!0},l,b("span",{class:"scale-bar"}),c);function h(){Hw(),Ur("cloud",[]),u.hidden=!0,bt(a,"")}async function d(){e=!0,bt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,Fw(Number(n));try{let f=await Oe("cloud",{count:Number(n),colour:t,seed:1},p=>{Bw(p.points),o.value=p.done/p.of,bt(l,hp(So.lo)),bt(c,hp(So.hi)),bt(a,`${p.done.toLocaleString("en")} of ${p.of.toLocaleString("en")} points`)});bt(a,f.stopped?`Cancelled after ${vu().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${Vw.find(([p])=>p===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){bt(a,f.message)}e=!1,Ur("cloud",zw()),Jc(),bt(i,"Draw the cloud"),o.hidden=!0}return nt("table",f=>{f!=="postures"&&f!=="name"&&vu()&&h()}),b("div",{},b("div",{class:"line"},cn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),b("span",{class:"field-name",text:"coloured by"}),cn("Coloured by",Vw,t,f=>{t=f},{"data-testid":"cloud-colour"})),b("div",{class:"line"},i,s,r),o,u,a)}var $w=n=>({id:"share",title:"Share",build(t,e){let i=b("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=b("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=b("p",{class:"hint",role:"status","data-testid":"report-note"}),o=b("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:u}}),a=b("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(b("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),b("div",{class:"line share-link"},i,b("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>qr(await _f())}})),b("h3",{text:"As a file"}),b("div",{class:"line"},b("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>ci(`${M.table.name||"arm"}.workbench.json`,JSON.stringify(gf(),null,1),"application/json")}}),b("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,b("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:Jf}})),b("h3",{text:"As Python"}),b("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,b("div",{class:"line"},b("button",{type:"button",text:"Copy the script","data-testid":"copy-python",on:{click:()=>qr(a.value)}}),b("button",{type:"button",text:"Save the script",on:{click:()=>ci("workbench.py",a.value,"text/x-python")}})),b("h3",{text:"Report"}),b("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),b("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&M.table.joints.length&&(i.value=await _f()),!e.hidden&&M.table.joints.length&&c()},c=Ys(async()=>{try{let{q:d,target:f,hasTarget:p,path:_,program:m}=M,{task:g,redundancy:x}=he,T={q:d,target:p?f:null,path:_,task:g,redundancy:x,program:El()};a.value=(await Oe("python",m.length?T:{...T,program:null})).text}catch(d){a.value=`# ${d.message}`}});nt(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await Oe("report",{q:M.q},p=>bt(r,p.note));ci(f,d,"text/html"),bt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){bt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");xf(JSON.parse(await f.text()),n()),be("Opened")}catch(p){be(p instanceof SyntaxError?`${f.name} is not a state file.`:p.message,"wrong")}}}});var vD=40,Xw=!1,Yw=0,Q0=!1,dp=null,qw=null;function Zw(n){n&&(Xw=!0,dp=M.table,jw(n))}function jw(n){Q0=!0,Yw=n.said,n.table&&(_n(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),dp=M.table,Ml(n.looks??null,n.table)),n.things&&bD(n.things),n.target&&(M.hasTarget=!0,Mi(n.target,"restored")),n.q&&n.q.length===M.table.joints.length&&(ut("did",{label:"move from Python",key:"python"}),Ni(n.q,"python")),Q0=!1}function bD(n){M.things=n.filter(i=>i.kind!=="motion"),ut("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==qw){if(qw=e,!t){Ii(null);return}Ii(lr({table:M.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${M.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var MD=ma(vD,()=>{let n=M.table===dp?void 0:Rp(M.table);dp=M.table,M.table.joints.length&&Zi("shown",{q:M.q,target:M.hasTarget?M.target:null,table:n,said:Yw}).catch(()=>{})});function Jw(){nt("push",jw),nt(["q","target","table"],()=>Xw&&!Q0&&MD.soon())}var ea=new An,Qw=new ii({fog:!1}),tx=new ii({fog:!1}),ex=new Bi(1,1,1),nx=new Ye(ex,Qw),t1=[new Ye(ex,tx),new Ye(ex,tx)];ea.add(nx,...t1);ea.matrixAutoUpdate=!1;ea.visible=!1;var bu=null;function e1(){fn.add(ea),nt("q",()=>bu!==null&&i1()),nt("theme",Kw),Kw()}function Kw(){Qw.color.set(Ot.joint),tx.color.set(Ot.accent)}function ix(n){n===null&&bu===null||(bu=n,ea.visible=n!==null,n!==null&&i1(),xe())}var n1=()=>bu;function i1(){let n=M.frames.at(-1),t=.075*li(M.table);nx.scale.set(.35*t,1.1*t,.25*t),nx.position.set(0,0,-.85*t),t1.forEach((e,i)=>{let s=(.08+.36*(1-bu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),ea.matrix.set(...n),ea.updateMatrixWorld(!0)}var ED=.25,sx=.5;function TD(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(M.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=CD(n,r);if(o>=sx&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:Di(Li(Qt(u.at(-1).T),Qt(a)))})).filter(({name:c,d:u})=>u<AD(M.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:zn(fa(a),l.T)}))}else o<sx&&s&&i&&(e.get(i).push({t:r,T:zn(a,e.get(i).at(-1).held)}),i=null);s=o>=sx}return{grips:t,objects:e}}var AD=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function RD(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var CD=(n,t)=>Ms(n.table,n.q[RD(n.seconds,t)]).at(-1),wo=null,PD=n=>{let t=wo.grips.length?1-Math.round(wo.grips[0].value):0;for(let e of wo.grips){if(e.t>n)break;let i=Math.min((n-e.t)/ED,1);t+=i*(e.value-t)}return t};function s1(){nt("motion",()=>{Ew(),wo=M.motion?.happens?TD(M.motion):null,wo||ix(null)}),nt("played",n=>{if(!wo)return;let t=M.frames.at(-1);wo.grips.length&&ix(PD(n));for(let[e,i]of wo.objects){let s=i.findLast(r=>r.t<=n)??i[0];Y0(e,s.held?zn(t,s.held):s.T)}})}function r1(){window.workbench=Object.freeze({get q(){return M.q.slice()},get frames(){return structuredClone(M.frames)},get target(){return M.target.slice()},get table(){return structuredClone(M.table)},get solutions(){return structuredClone(M.solutions)},get camera(){return Qa()},get pictures(){return Ky()},get ghosts(){return ib()},get ghostsOutside(){return sb()},get labels(){return mg()},get history(){return[ff(),pf()]},get beyond(){return tb()},get things(){return Tw()},get looks(){return RS()},get program(){return structuredClone(M.program)},get route(){return structuredClone(M.route)},routePlace(n,t){let e={which:n,turn:t};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:e})),e.at},get motion(){return structuredClone(M.motion)},get gripper(){return n1()},placeOf:n=>ww(n)??M.world.find(t=>t.name===n)?.T??null,go:kr,get stepFrame(){return M.dhStep===null?null:Zd().at(-1).T},get clearance(){return structuredClone(M.clearance)},get bodies(){return Cw()},get ellipsoid(){return structuredClone(cp())},get world(){return structuredClone(M.world)},get framesDrawn(){return eb()},get answers(){return Og.answers},get trace(){return lb()},get cloud(){return vu()},toScreen:zi,withPicture:n=>ja(n),handles:()=>Pv(),forward:(n,t)=>Ms(n,t),convert:(n,t)=>Zf(n,t),read:(n,t)=>vf(n,t),present:(n,t,e)=>Kf(n,t,e)})}Nd();tv(Ss("#view"));nt("theme",lg);lg();pb();mv(Ss("#overlay"));jv();Av();Sw();AS();Iw();Ow();e1();s1();Jw();Ox();hb();LS(Ss("#bar"));NS(Ss("#overlay"));lS(Ss("#dock"));US();var fp,Mu=(n,t,...e)=>[{...t,group:n},...e];fp=DS(Ss("#rail"),Ss("#panels"),Ss("#pinned"),[...Mu("Drive",{id:"move",title:"Move",sections:[Tb,FS]},qS),...Mu("Describe",tw,Lw),...Mu("Plan",sw,pw(()=>fp),_w,Dw),...Mu("Study",BS,nw,Ww),...Mu("Hand on",$w(()=>fp))]);dS(Ss("#room"),Ss("#rail"));Mb();var LD=vb().then(n=>n&&xf(n,fp)).catch(n=>be(`The link could not be read: ${n.message}`,"wrong"));nt("online",async n=>{if(!n)return;await LD;let t=await Ix();M.catalog=t.catalog,ut("catalog"),t.table&&(!M.table.joints.length||t.bench)&&(_n(t.table,{q:pa(t.table),step:!1,what:"new"}),mf()),t.looks&&Ml(t.looks,t.table),Zw(t.bench),document.documentElement.dataset.ready="yes"});M.online&&ut("online",!0);document.fonts?.ready.then(()=>ut("theme"));r1();
