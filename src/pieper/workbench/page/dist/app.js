import{A as M,B as Ui,C as Ru,D as ua,E as mn,F as wx,G as vi,H as Ex,I as Cu,K as Yi,L as qs,a as fr,b as ni,c as Su,d as ee,e as Ws,f as Ol,g as Ni,h as Bl,i as wu,j as as,k as Eu,l as Tu,m as _x,n as yx,o as pr,p as mr,q as vx,r as vs,s as vp,t as bx,u as li,v as Au,w as Mx,x as Sx,y as nt,z as ht}from"./chunk-F4CXFWSV.js";function v(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var $s=(n,t=document)=>t.querySelector(n),Vt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function gt(n,t){n.textContent!==t&&(n.textContent=t)}function Je(n,t,e,i,s){let r=v("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(v("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function gn(n,t,e,i,s={}){let r=v("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>v("option",{value:o,text:a})));return r.value=e,r}function Xs(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function ha(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Ys(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function bi(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=v("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Wr(n){try{await navigator.clipboard.writeText(n)}catch{let t=v("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}Pe("Copied")}var Tx;function Pe(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(Tx),Tx=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function qr(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var da=0,Sp=-1,bp=[];function wp(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Mp(){let n=da;if(!M.table.joints.length){M.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ht("plan");return}try{let{plan:t}=await Yi("arm",{table:wp(M.table)});if(n!==da)return;Sp=n,M.plan=t,Ax()}catch(t){if(n!==da||t instanceof Cu)return;M.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},Ax(t)}ht("plan")}function Ax(n){let t=bp;bp=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var Rx=Ys(Mp,60);function Cx(){nt("table",n=>{da+=1,n==="postures"&&(Sp=-1),n==="cell"?Rx():(Rx.cancel(),Mp())}),nt("online",n=>{n&&(da+=1,Mp())})}function Qw(){return Sp===da?Promise.resolve():new Promise((n,t)=>bp.push({resolve:n,reject:t}))}async function He(n,t,e){return await Qw(),Yi(n,t,e)}function Px(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Pu(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var no={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},io={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},d_=0,tm=1,f_=2;var wc=1,p_=2,Va=3,so=0,Ci=1,hi=2,Do=0,Wa=1,em=2,nm=3,im=4,m_=5;var No=100,g_=101,x_=102,__=103,y_=104,v_=200,b_=201,M_=202,S_=203,sm=204,rm=205,w_=206,E_=207,T_=208,A_=209,R_=210,C_=211,P_=212,I_=213,L_=214,ah=0,lh=1,ch=2,La=3,uh=4,hh=5,dh=6,fh=7,om=0,D_=1,N_=2,er=0,am=1,lm=2,cm=3,um=4,hm=5,dm=6,fm=7;var pm=300,Uo=301,qa=302,kh=303,zh=304,ph=1e3,js=1001,mh=1002,Qn=1003,U_=1004;var Ec=1005;var wi=1006,Hh=1007;var Ar=1008;var ts=1009,mm=1010,gm=1011,$a=1012,Gh=1013,Ts=1014,us=1015,As=1016,Vh=1017,Wh=1018,Fo=1020,xm=35902,_m=35899,ym=1021,vm=1022,Rs=1023,Sr=1026,Rr=1027,qh=1028,$h=1029,ro=1030,Xh=1031;var Yh=1033,Tc=33776,Ac=33777,Rc=33778,Cc=33779,Zh=35840,jh=35841,Jh=35842,Kh=35843,Qh=36196,td=37492,ed=37496,nd=37488,id=37489,Pc=37490,sd=37491,rd=37808,od=37809,ad=37810,ld=37811,cd=37812,ud=37813,hd=37814,dd=37815,fd=37816,pd=37817,md=37818,gd=37819,xd=37820,_d=37821,yd=36492,vd=36494,bd=36495,Md=36283,Sd=36284,Ic=36285,wd=36286;var Kl=2300,gh=2301,rh=2302,$p=2303,Xp=2400,Yp=2401,Zp=2402;var F_=3200;var bm=0,O_=1,Cr="",ii="srgb",Ql="srgb-linear",tc="linear",Ge="srgb";var oh=7680,Mm=7681;var Sm=517;var B_=519,k_=512,z_=513,H_=514,wm=515,G_=516,V_=517,Em=518,Tm=519,Am=35044,Ed=35048;var Rm="300 es",cs=2e3,ec=2001;function e1(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function n1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function nc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function W_(){let n=nc("canvas");return n.style.display="block",n}var Ix={},Da=null;function ic(...n){let t="THREE."+n.shift();Da?Da("log",t,...n):console.log(t,...n)}function q_(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ne(...n){n=q_(n);let t="THREE."+n.shift();if(Da)Da("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function re(...n){n=q_(n);let t="THREE."+n.shift();if(Da)Da("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Zl(...n){let t=n.join(" ");t in Ix||(Ix[t]=!0,ne(...n))}function $_(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var X_={[ah]:ah,[ch]:dh,[uh]:uh,[La]:hh,[lh]:lh,[dh]:ch,[fh]:fh,[hh]:La},ws=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ci=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Lx=1234567,jl=Math.PI/180,Na=180/Math.PI;function oo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ci[n&255]+ci[n>>8&255]+ci[n>>16&255]+ci[n>>24&255]+"-"+ci[t&255]+ci[t>>8&255]+"-"+ci[t>>16&15|64]+ci[t>>24&255]+"-"+ci[e&63|128]+ci[e>>8&255]+"-"+ci[e>>16&255]+ci[e>>24&255]+ci[i&255]+ci[i>>8&255]+ci[i>>16&255]+ci[i>>24&255]).toLowerCase()}function we(n,t,e){return Math.max(t,Math.min(e,n))}function Cm(n,t){return(n%t+t)%t}function i1(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function s1(n,t,e){return n!==t?(e-n)/(t-n):0}function Jl(n,t,e){return(1-e)*n+e*t}function r1(n,t,e,i){return Jl(n,t,1-Math.exp(-e*i))}function o1(n,t=1){return t-Math.abs(Cm(n,t*2)-t)}function a1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function l1(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function c1(n,t){return n+Math.floor(Math.random()*(t-n+1))}function u1(n,t){return n+Math.random()*(t-n)}function h1(n){return n*(.5-Math.random())}function d1(n){n!==void 0&&(Lx=n);let t=Lx+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function f1(n){return n*jl}function p1(n){return n*Na}function m1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function g1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Pm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function x1(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*f,a*u,a*c);break;default:ne("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Td(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Im(n,t){if(t.constructor===Float32Array)return n;let e=Td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Lm(n,t){if(t.constructor===Float32Array)return n;let e=Td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ao={DEG2RAD:jl,RAD2DEG:Na,generateUUID:oo,clamp:we,euclideanModulo:Cm,mapLinear:i1,inverseLerp:s1,lerp:Jl,damp:r1,pingpong:o1,smoothstep:a1,smootherstep:l1,randInt:c1,randFloat:u1,randFloatSpread:h1,seededRandom:d1,degToRad:f1,radToDeg:p1,isPowerOfTwo:m1,ceilPowerOfTwo:g1,floorPowerOfTwo:Pm,setQuaternionFromProperEuler:x1,normalize:Lm,denormalize:Im},Xt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=we(this.x,t.x,e.x),this.y=we(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=we(this.x,t,e),this.y=we(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(we(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(we(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},un=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],m=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==m){let p=l*d+c*f+u*m+h*_;p<0&&(d=-d,f=-f,m=-m,_=-_,p=-p);let g=1-a;if(p<.9995){let x=Math.acos(p),E=Math.sin(x);g=Math.sin(g*x)/E,a=Math.sin(a*x)/E,l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+_*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+m*a,h=h*g+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+u*h+l*f-c*d,t[e+1]=l*m+u*d+c*h-a*f,t[e+2]=c*m+u*f+a*d-l*h,t[e+3]=u*m-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:ne("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(we(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Dx.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Dx.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=we(this.x,t.x,e.x),this.y=we(this.y,t.y,e.y),this.z=we(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=we(this.x,t,e),this.y=we(this.y,t,e),this.z=we(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(we(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ep.copy(this).projectOnVector(t),this.sub(Ep)}reflect(t){return this.sub(Ep.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(we(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ep=new H,Dx=new un,ce=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],m=i[8],_=s[0],p=s[3],g=s[6],x=s[1],E=s[4],b=s[7],A=s[2],T=s[5],y=s[8];return r[0]=o*_+a*x+l*A,r[3]=o*p+a*E+l*T,r[6]=o*g+a*b+l*y,r[1]=c*_+u*x+h*A,r[4]=c*p+u*E+h*T,r[7]=c*g+u*b+h*y,r[2]=d*_+f*x+m*A,r[5]=d*p+f*E+m*T,r[8]=d*g+f*b+m*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,m=e*h+i*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return t[0]=h*_,t[1]=(s*c-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(u*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Zl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Tp.makeScale(t,e)),this}rotate(t){return Zl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Tp.makeRotation(-t)),this}translate(t,e){return Zl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Tp.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Tp=new ce,Nx=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ux=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _1(){let n={enabled:!0,workingColorSpace:Ql,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ge&&(s.r=Mr(s.r),s.g=Mr(s.g),s.b=Mr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ge&&(s.r=Ia(s.r),s.g=Ia(s.g),s.b=Ia(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cr?tc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ql]:{primaries:t,whitePoint:i,transfer:tc,toXYZ:Nx,fromXYZ:Ux,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ii},outputColorSpaceConfig:{drawingBufferColorSpace:ii}},[ii]:{primaries:t,whitePoint:i,transfer:Ge,toXYZ:Nx,fromXYZ:Ux,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ii}}}),n}var Ie=_1();function Mr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ia(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var fa,xh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{fa===void 0&&(fa=nc("canvas")),fa.width=t.width,fa.height=t.height;let s=fa.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=fa}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=nc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Mr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Mr(e[i]/255)*255):e[i]=Mr(e[i]);return{data:e,width:t.width,height:t.height}}else return ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},y1=0,Ua=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:y1++}),this.uuid=oo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ap(s[o].image)):r.push(Ap(s[o]))}else r=Ap(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Ap(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?xh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ne("Texture: Unable to serialize Texture."),{})}var v1=0,Rp=new H,Ei=class n extends ws{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=js,s=js,r=wi,o=Ar,a=Rs,l=ts,c=n.DEFAULT_ANISOTROPY,u=Cr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:v1++}),this.uuid=oo(),this.name="",this.source=new Ua(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Xt(0,0),this.repeat=new Xt(1,1),this.center=new Xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Rp).x}get height(){return this.source.getSize(Rp).y}get depth(){return this.source.getSize(Rp).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ne(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ne(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==pm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ph:t.x=t.x-Math.floor(t.x);break;case js:t.x=t.x<0?0:1;break;case mh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ph:t.y=t.y-Math.floor(t.y);break;case js:t.y=t.y<0?0:1;break;case mh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ei.DEFAULT_IMAGE=null;Ei.DEFAULT_MAPPING=pm;Ei.DEFAULT_ANISOTROPY=1;var yn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],_=l[2],p=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(m-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(m+p)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,b=(f+1)/2,A=(g+1)/2,T=(u+d)/4,y=(h+_)/4,S=(m+p)/4;return E>b&&E>A?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=T/i,r=y/i):b>A?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=T/s,r=S/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=S/r),this.set(i,s,r,e),this}let x=Math.sqrt((p-m)*(p-m)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(p-m)/x,this.y=(h-_)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=we(this.x,t.x,e.x),this.y=we(this.y,t.y,e.y),this.z=we(this.z,t.z,e.z),this.w=we(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=we(this.x,t,e),this.y=we(this.y,t,e),this.z=we(this.z,t,e),this.w=we(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(we(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},_h=class extends ws{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:wi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new yn(0,0,t,e),this.scissorTest=!1,this.viewport=new yn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ei({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:wi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ua(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ji=class extends _h{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},sc=class extends Ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Qn,this.minFilter=Qn,this.wrapR=js,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var yh=class extends Ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Qn,this.minFilter=Qn,this.wrapR=js,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ge=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,m,_,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,m,_,p)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,m,_,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=m,g[11]=_,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/pa.setFromMatrixColumn(t,0).length(),r=1/pa.setFromMatrixColumn(t,1).length(),o=1/pa.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,m=a*u,_=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+m*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,m=c*u,_=c*h;e[0]=d+_*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-m,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,m=c*u,_=c*h;e[0]=d-_*a,e[4]=-o*h,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*u,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,m=a*u,_=a*h;e[0]=l*u,e[4]=m*c-f,e[8]=d*c+_,e[1]=l*h,e[5]=_*c+d,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*u,e[4]=_-d*h,e[8]=m*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+m,e[10]=d-_*h}else if(t.order==="XZY"){let d=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+_,e[5]=o*u,e[9]=f*h-m,e[2]=m*h-f,e[6]=a*u,e[10]=_*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(b1,t,M1)}lookAt(t,e,i){let s=this.elements;return Zi.subVectors(t,e),Zi.lengthSq()===0&&(Zi.z=1),Zi.normalize(),$r.crossVectors(i,Zi),$r.lengthSq()===0&&(Math.abs(i.z)===1?Zi.x+=1e-4:Zi.z+=1e-4,Zi.normalize(),$r.crossVectors(i,Zi)),$r.normalize(),Iu.crossVectors(Zi,$r),s[0]=$r.x,s[4]=Iu.x,s[8]=Zi.x,s[1]=$r.y,s[5]=Iu.y,s[9]=Zi.y,s[2]=$r.z,s[6]=Iu.z,s[10]=Zi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],m=i[2],_=i[6],p=i[10],g=i[14],x=i[3],E=i[7],b=i[11],A=i[15],T=s[0],y=s[4],S=s[8],D=s[12],L=s[1],N=s[5],z=s[9],G=s[13],B=s[2],X=s[6],P=s[10],U=s[14],Z=s[3],q=s[7],j=s[11],et=s[15];return r[0]=o*T+a*L+l*B+c*Z,r[4]=o*y+a*N+l*X+c*q,r[8]=o*S+a*z+l*P+c*j,r[12]=o*D+a*G+l*U+c*et,r[1]=u*T+h*L+d*B+f*Z,r[5]=u*y+h*N+d*X+f*q,r[9]=u*S+h*z+d*P+f*j,r[13]=u*D+h*G+d*U+f*et,r[2]=m*T+_*L+p*B+g*Z,r[6]=m*y+_*N+p*X+g*q,r[10]=m*S+_*z+p*P+g*j,r[14]=m*D+_*G+p*U+g*et,r[3]=x*T+E*L+b*B+A*Z,r[7]=x*y+E*N+b*X+A*q,r[11]=x*S+E*z+b*P+A*j,r[15]=x*D+E*G+b*U+A*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],m=t[3],_=t[7],p=t[11],g=t[15],x=l*f-c*d,E=a*f-c*h,b=a*d-l*h,A=o*f-c*u,T=o*d-l*u,y=o*h-a*u;return e*(_*x-p*E+g*b)-i*(m*x-p*A+g*T)+s*(m*E-_*A+g*y)-r*(m*b-_*T+p*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],m=t[12],_=t[13],p=t[14],g=t[15],x=e*a-i*o,E=e*l-s*o,b=e*c-r*o,A=i*l-s*a,T=i*c-r*a,y=s*c-r*l,S=u*_-h*m,D=u*p-d*m,L=u*g-f*m,N=h*p-d*_,z=h*g-f*_,G=d*g-f*p,B=x*G-E*z+b*N+A*L-T*D+y*S;if(B===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/B;return t[0]=(a*G-l*z+c*N)*X,t[1]=(s*z-i*G-r*N)*X,t[2]=(_*y-p*T+g*A)*X,t[3]=(d*T-h*y-f*A)*X,t[4]=(l*L-o*G-c*D)*X,t[5]=(e*G-s*L+r*D)*X,t[6]=(p*b-m*y-g*E)*X,t[7]=(u*y-d*b+f*E)*X,t[8]=(o*z-a*L+c*S)*X,t[9]=(i*L-e*z-r*S)*X,t[10]=(m*T-_*b+g*x)*X,t[11]=(h*b-u*T-f*x)*X,t[12]=(a*D-o*N-l*S)*X,t[13]=(e*N-i*D+s*S)*X,t[14]=(_*E-m*A-p*x)*X,t[15]=(u*A-h*E+d*x)*X,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,m=r*h,_=o*u,p=o*h,g=a*h,x=l*c,E=l*u,b=l*h,A=i.x,T=i.y,y=i.z;return s[0]=(1-(_+g))*A,s[1]=(f+b)*A,s[2]=(m-E)*A,s[3]=0,s[4]=(f-b)*T,s[5]=(1-(d+g))*T,s[6]=(p+x)*T,s[7]=0,s[8]=(m+E)*y,s[9]=(p-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=pa.set(s[0],s[1],s[2]).length(),a=pa.set(s[4],s[5],s[6]).length(),l=pa.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bs.copy(this);let c=1/o,u=1/a,h=1/l;return bs.elements[0]*=c,bs.elements[1]*=c,bs.elements[2]*=c,bs.elements[4]*=u,bs.elements[5]*=u,bs.elements[6]*=u,bs.elements[8]*=h,bs.elements[9]*=h,bs.elements[10]*=h,e.setFromRotationMatrix(bs),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=cs,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===cs)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ec)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=cs,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===cs)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===ec)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},pa=new H,bs=new ge,b1=new H(0,0,0),M1=new H(1,1,1),$r=new H,Iu=new H,Zi=new H,Fx=new ge,Ox=new un,Jr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(we(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-we(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(we(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-we(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(we(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-we(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Fx.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Fx,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Ox.setFromEuler(this),this.setFromQuaternion(Ox,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Jr.DEFAULT_ORDER="XYZ";var Fa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},S1=0,Bx=new H,ma=new un,gr=new ge,Lu=new H,kl=new H,w1=new H,E1=new un,kx=new H(1,0,0),zx=new H(0,1,0),Hx=new H(0,0,1),Gx={type:"added"},T1={type:"removed"},ga={type:"childadded",child:null},Cp={type:"childremoved",child:null},Ti=class n extends ws{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:S1++}),this.uuid=oo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new H,e=new Jr,i=new un,s=new H(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new ce}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Fa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ma.setFromAxisAngle(t,e),this.quaternion.multiply(ma),this}rotateOnWorldAxis(t,e){return ma.setFromAxisAngle(t,e),this.quaternion.premultiply(ma),this}rotateX(t){return this.rotateOnAxis(kx,t)}rotateY(t){return this.rotateOnAxis(zx,t)}rotateZ(t){return this.rotateOnAxis(Hx,t)}translateOnAxis(t,e){return Bx.copy(t).applyQuaternion(this.quaternion),this.position.add(Bx.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(kx,t)}translateY(t){return this.translateOnAxis(zx,t)}translateZ(t){return this.translateOnAxis(Hx,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(gr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Lu.copy(t):Lu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),kl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?gr.lookAt(kl,Lu,this.up):gr.lookAt(Lu,kl,this.up),this.quaternion.setFromRotationMatrix(gr),s&&(gr.extractRotation(s.matrixWorld),ma.setFromRotationMatrix(gr),this.quaternion.premultiply(ma.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Gx),ga.child=t,this.dispatchEvent(ga),ga.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(T1),Cp.child=t,this.dispatchEvent(Cp),Cp.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),gr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),gr.multiply(t.parent.matrixWorld)),t.applyMatrix4(gr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Gx),ga.child=t,this.dispatchEvent(ga),ga.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(kl,t,w1),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(kl,E1,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ti.DEFAULT_UP=new H(0,1,0);Ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var En=class extends Ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},A1={type:"move"},Oa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new En,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new En,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new En,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let p=e.getJointPose(_,i),g=this._getHandJoint(c,_);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(A1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new En;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Y_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xr={h:0,s:0,l:0},Du={h:0,s:0,l:0};function Pp(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var te=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ii){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ie.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ie.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ie.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ie.workingColorSpace){if(t=Cm(t,1),e=we(e,0,1),i=we(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Pp(o,r,t+1/3),this.g=Pp(o,r,t),this.b=Pp(o,r,t-1/3)}return Ie.colorSpaceToWorking(this,s),this}setStyle(t,e=ii){function i(r){r!==void 0&&parseFloat(r)<1&&ne("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ne("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ne("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ii){let i=Y_[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ne("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Mr(t.r),this.g=Mr(t.g),this.b=Mr(t.b),this}copyLinearToSRGB(t){return this.r=Ia(t.r),this.g=Ia(t.g),this.b=Ia(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ii){return Ie.workingToColorSpace(ui.copy(this),t),Math.round(we(ui.r*255,0,255))*65536+Math.round(we(ui.g*255,0,255))*256+Math.round(we(ui.b*255,0,255))}getHexString(t=ii){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ie.workingColorSpace){Ie.workingToColorSpace(ui.copy(this),e);let i=ui.r,s=ui.g,r=ui.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Ie.workingColorSpace){return Ie.workingToColorSpace(ui.copy(this),e),t.r=ui.r,t.g=ui.g,t.b=ui.b,t}getStyle(t=ii){Ie.workingToColorSpace(ui.copy(this),t);let e=ui.r,i=ui.g,s=ui.b;return t!==ii?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Xr),this.setHSL(Xr.h+t,Xr.s+e,Xr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Xr),t.getHSL(Du);let i=Jl(Xr.h,Du.h,e),s=Jl(Xr.s,Du.s,e),r=Jl(Xr.l,Du.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ui=new te;te.NAMES=Y_;var rc=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new te(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},oc=class extends Ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Jr,this.environmentIntensity=1,this.environmentRotation=new Jr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ms=new H,xr=new H,Ip=new H,_r=new H,xa=new H,_a=new H,Vx=new H,Lp=new H,Dp=new H,Np=new H,Up=new yn,Fp=new yn,Op=new yn,br=class n{constructor(t=new H,e=new H,i=new H){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ms.subVectors(t,e),s.cross(Ms);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ms.subVectors(s,e),xr.subVectors(i,e),Ip.subVectors(t,e);let o=Ms.dot(Ms),a=Ms.dot(xr),l=Ms.dot(Ip),c=xr.dot(xr),u=xr.dot(Ip),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,_r)===null?!1:_r.x>=0&&_r.y>=0&&_r.x+_r.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,_r)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,_r.x),l.addScaledVector(o,_r.y),l.addScaledVector(a,_r.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Up.setScalar(0),Fp.setScalar(0),Op.setScalar(0),Up.fromBufferAttribute(t,e),Fp.fromBufferAttribute(t,i),Op.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Up,r.x),o.addScaledVector(Fp,r.y),o.addScaledVector(Op,r.z),o}static isFrontFacing(t,e,i,s){return Ms.subVectors(i,e),xr.subVectors(t,e),Ms.cross(xr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ms.subVectors(this.c,this.b),xr.subVectors(this.a,this.b),Ms.cross(xr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;xa.subVectors(s,i),_a.subVectors(r,i),Lp.subVectors(t,i);let l=xa.dot(Lp),c=_a.dot(Lp);if(l<=0&&c<=0)return e.copy(i);Dp.subVectors(t,s);let u=xa.dot(Dp),h=_a.dot(Dp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(xa,o);Np.subVectors(t,r);let f=xa.dot(Np),m=_a.dot(Np);if(m>=0&&f<=m)return e.copy(r);let _=f*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(_a,a);let p=u*m-f*h;if(p<=0&&h-u>=0&&f-m>=0)return Vx.subVectors(r,s),a=(h-u)/(h-u+(f-m)),e.copy(s).addScaledVector(Vx,a);let g=1/(p+_+d);return o=_*g,a=d*g,e.copy(i).addScaledVector(xa,o).addScaledVector(_a,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Fi=class{constructor(t=new H(1/0,1/0,1/0),e=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ss.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ss.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ss.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ss):Ss.fromBufferAttribute(r,o),Ss.applyMatrix4(t.matrixWorld),this.expandByPoint(Ss);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Nu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Nu.copy(i.boundingBox)),Nu.applyMatrix4(t.matrixWorld),this.union(Nu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ss),Ss.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(zl),Uu.subVectors(this.max,zl),ya.subVectors(t.a,zl),va.subVectors(t.b,zl),ba.subVectors(t.c,zl),Yr.subVectors(va,ya),Zr.subVectors(ba,va),wo.subVectors(ya,ba);let e=[0,-Yr.z,Yr.y,0,-Zr.z,Zr.y,0,-wo.z,wo.y,Yr.z,0,-Yr.x,Zr.z,0,-Zr.x,wo.z,0,-wo.x,-Yr.y,Yr.x,0,-Zr.y,Zr.x,0,-wo.y,wo.x,0];return!Bp(e,ya,va,ba,Uu)||(e=[1,0,0,0,1,0,0,0,1],!Bp(e,ya,va,ba,Uu))?!1:(Fu.crossVectors(Yr,Zr),e=[Fu.x,Fu.y,Fu.z],Bp(e,ya,va,ba,Uu))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ss).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ss).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(yr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),yr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),yr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),yr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),yr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),yr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),yr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),yr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(yr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},yr=[new H,new H,new H,new H,new H,new H,new H,new H],Ss=new H,Nu=new Fi,ya=new H,va=new H,ba=new H,Yr=new H,Zr=new H,wo=new H,zl=new H,Uu=new H,Fu=new H,Eo=new H;function Bp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Eo.fromArray(n,r);let a=s.x*Math.abs(Eo.x)+s.y*Math.abs(Eo.y)+s.z*Math.abs(Eo.z),l=t.dot(Eo),c=e.dot(Eo),u=i.dot(Eo);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Fn=new H,Ou=new Xt,R1=0,Oe=class extends ws{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:R1++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Am,this.updateRanges=[],this.gpuType=us,this.version=0,this._normalizationScale=t!==void 0?Td(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Ou.fromBufferAttribute(this,e),Ou.applyMatrix3(t),this.setXY(e,Ou.x,Ou.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix3(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Im(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Lm(t,this.array)}};var ac=class extends Oe{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var lc=class extends Oe{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ee=class extends Oe{constructor(t,e,i){super(new Float32Array(t),e,i)}},C1=new Fi,Hl=new H,kp=new H,Js=class{constructor(t=new H,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):C1.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Hl.subVectors(t,this.center);let e=Hl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Hl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(kp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Hl.copy(t.center).add(kp)),this.expandByPoint(Hl.copy(t.center).sub(kp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},P1=0,ls=new ge,zp=new Ti,Ma=new H,ji=new Fi,Gl=new Fi,Kn=new H,be=class n extends ws{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:P1++}),this.uuid=oo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(e1(t)?lc:ac)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ce().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return ls.makeRotationFromQuaternion(t),this.applyMatrix4(ls),this}rotateX(t){return ls.makeRotationX(t),this.applyMatrix4(ls),this}rotateY(t){return ls.makeRotationY(t),this.applyMatrix4(ls),this}rotateZ(t){return ls.makeRotationZ(t),this.applyMatrix4(ls),this}translate(t,e,i){return ls.makeTranslation(t,e,i),this.applyMatrix4(ls),this}scale(t,e,i){return ls.makeScale(t,e,i),this.applyMatrix4(ls),this}lookAt(t){return zp.lookAt(t),zp.updateMatrix(),this.applyMatrix4(zp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ma).negate(),this.translate(Ma.x,Ma.y,Ma.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ee(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Fi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ji.setFromBufferAttribute(r),this.morphTargetsRelative?(Kn.addVectors(this.boundingBox.min,ji.min),this.boundingBox.expandByPoint(Kn),Kn.addVectors(this.boundingBox.max,ji.max),this.boundingBox.expandByPoint(Kn)):(this.boundingBox.expandByPoint(ji.min),this.boundingBox.expandByPoint(ji.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Js);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(t){let i=this.boundingSphere.center;if(ji.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Gl.setFromBufferAttribute(a),this.morphTargetsRelative?(Kn.addVectors(ji.min,Gl.min),ji.expandByPoint(Kn),Kn.addVectors(ji.max,Gl.max),ji.expandByPoint(Kn)):(ji.expandByPoint(Gl.min),ji.expandByPoint(Gl.max))}ji.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Kn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Kn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Kn.fromBufferAttribute(a,c),l&&(Ma.fromBufferAttribute(t,c),Kn.add(Ma)),s=Math.max(s,i.distanceToSquared(Kn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Oe(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new H,l[D]=new H;let u=new H,h=new H,d=new H,f=new Xt,m=new Xt,_=new Xt,p=new H,g=new H;function x(D,L,N){c[D]=c[L]=c[N]=1,u.fromBufferAttribute(i,D),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,N),f.fromBufferAttribute(r,D),m.fromBufferAttribute(r,L),_.fromBufferAttribute(r,N),h.sub(u),d.sub(u),m.sub(f),_.sub(f);let z=1/(m.x*_.y-_.x*m.y);isFinite(z)&&(p.copy(h).multiplyScalar(_.y).addScaledVector(d,-m.y).multiplyScalar(z),g.copy(d).multiplyScalar(m.x).addScaledVector(h,-_.x).multiplyScalar(z),a[D].add(p),a[L].add(p),a[N].add(p),l[D].add(g),l[L].add(g),l[N].add(g))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let D=0,L=E.length;D<L;++D){let N=E[D],z=N.start,G=N.count;for(let B=z,X=z+G;B<X;B+=3)x(t.getX(B+0),t.getX(B+1),t.getX(B+2))}let b=new H,A=new H,T=new H,y=new H;function S(D){T.fromBufferAttribute(s,D),y.copy(T);let L=a[D];b.copy(L),b.sub(T.multiplyScalar(T.dot(L))).normalize(),A.crossVectors(y,L);let z=A.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,z)}for(let D=0,L=i.count;D<L;++D)c[D]&&S(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Oe(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(t)for(let d=0,f=t.count;d<f;d+=3){let m=t.getX(d+0),_=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Kn.fromBufferAttribute(t,e),Kn.normalize(),t.setXYZ(e,Kn.x,Kn.y,Kn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let _=0,p=l.length;_<p;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let g=0;g<u;g++)d[m++]=c[f++]}return new Oe(d,u,h)}if(this.index===null)return ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ro=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Am,this.updateRanges=[],this.version=0,this.uuid=oo()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wx(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Wx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=oo()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Mi=new H,Kr=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Td(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Mi.fromBufferAttribute(this,e),Mi.applyMatrix4(t),this.setXYZ(e,Mi.x,Mi.y,Mi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Mi.fromBufferAttribute(this,e),Mi.applyNormalMatrix(t),this.setXYZ(e,Mi.x,Mi.y,Mi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Mi.fromBufferAttribute(this,e),Mi.transformDirection(t),this.setXYZ(e,Mi.x,Mi.y,Mi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){ic("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Oe(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){ic("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Im(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Lm(t,this.data.array)}},Hp=new H,I1=new H,L1=new ce,si=class{constructor(t=new H(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Hp.subVectors(i,e).cross(I1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Hp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||L1.getNormalMatrix(t),s=this.coplanarPoint(Hp).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},D1=0,Ks=class extends ws{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:D1++}),this.uuid=oo(),this.name="",this.type="Material",this.blending=Wa,this.side=so,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=sm,this.blendDst=rm,this.blendEquation=No,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new te(0,0,0),this.blendAlpha=0,this.depthFunc=La,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=B_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=oh,this.stencilZFail=oh,this.stencilZPass=oh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ne(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ne(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new te().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new si().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Xt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Ba=class extends Ks{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new te(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Sa,Vl=new H,wa=new H,Ea=new H,Ta=new Xt,Wl=new Xt,Z_=new ge,Bu=new H,ql=new H,ku=new H,qx=new Xt,Gp=new Xt,$x=new Xt,cc=class extends Ti{constructor(t=new Ba){if(super(),this.isSprite=!0,this.type="Sprite",Sa===void 0){Sa=new be;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Ro(e,5);Sa.setIndex([0,1,2,0,2,3]),Sa.setAttribute("position",new Kr(i,3,0,!1)),Sa.setAttribute("uv",new Kr(i,2,3,!1))}this.geometry=Sa,this.material=t,this.center=new Xt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&re('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),wa.setFromMatrixScale(this.matrixWorld),Z_.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Ea.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&wa.multiplyScalar(-Ea.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;zu(Bu.set(-.5,-.5,0),Ea,o,wa,s,r),zu(ql.set(.5,-.5,0),Ea,o,wa,s,r),zu(ku.set(.5,.5,0),Ea,o,wa,s,r),qx.set(0,0),Gp.set(1,0),$x.set(1,1);let a=t.ray.intersectTriangle(Bu,ql,ku,!1,Vl);if(a===null&&(zu(ql.set(-.5,.5,0),Ea,o,wa,s,r),Gp.set(0,1),a=t.ray.intersectTriangle(Bu,ku,ql,!1,Vl),a===null))return;let l=t.ray.origin.distanceTo(Vl);l<t.near||l>t.far||e.push({distance:l,point:Vl.clone(),uv:br.getInterpolation(Vl,Bu,ql,ku,qx,Gp,$x,new Xt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function zu(n,t,e,i,s,r){Ta.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Wl.x=r*Ta.x-s*Ta.y,Wl.y=s*Ta.x+r*Ta.y):Wl.copy(Ta),n.copy(t),n.x+=Wl.x,n.y+=Wl.y,n.applyMatrix4(Z_)}var vr=new H,Vp=new H,Hu=new H,Gu=new H,wr=class{constructor(t=new H,e=new H(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,vr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=vr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(vr.copy(this.origin).addScaledVector(this.direction,e),vr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Vp.copy(t).add(e).multiplyScalar(.5),Hu.copy(e).sub(t).normalize(),Gu.copy(this.origin).sub(Vp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Hu),a=Gu.dot(this.direction),l=-Gu.dot(Hu),c=Gu.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=r*u,h>=0)if(d>=-m)if(d<=m){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Vp).addScaledVector(Hu,d),f}intersectSphere(t,e){if(t.radius<0)return null;vr.subVectors(t.center,this.origin);let i=vr.dot(this.direction),s=vr.dot(vr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,vr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,m=e.x-o.x,_=e.y-o.y,p=e.z-o.z,g=i.x-o.x,x=i.y-o.y,E=i.z-o.z,b=Math.abs(l),A=Math.abs(c),T=Math.abs(u),y,S,D,L,N,z,G,B,X,P,U,Z;if(b>=A&&b>=T?(D=l,z=h,X=m,Z=g,l>=0?(y=c,S=u,L=d,N=f,G=_,B=p,P=x,U=E):(y=u,S=c,L=f,N=d,G=p,B=_,P=E,U=x)):A>=T?(D=c,z=d,X=_,Z=x,c>=0?(y=u,S=l,L=f,N=h,G=p,B=m,P=E,U=g):(y=l,S=u,L=h,N=f,G=m,B=p,P=g,U=E)):(D=u,z=f,X=p,Z=E,u>=0?(y=l,S=c,L=h,N=d,G=m,B=_,P=g,U=x):(y=c,S=l,L=d,N=h,G=_,B=m,P=x,U=g)),D===0)return null;let q=y/D,j=S/D,et=1/D,dt=L-q*z,ft=N-j*z,st=G-q*X,vt=B-j*X,_t=P-q*Z,Tt=U-j*Z,At=_t*vt-Tt*st,Jt=dt*Tt-ft*_t,pe=st*ft-vt*dt;if(s){if(At<0||Jt<0||pe<0)return null}else if((At<0||Jt<0||pe<0)&&(At>0||Jt>0||pe>0))return null;let Zt=At+Jt+pe;if(Zt===0)return null;let Se=et*(At*z+Jt*X+pe*Z);return(Zt>0?Se<0:Se>0)?null:this.at(Se/Zt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ri=class extends Ks{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new te(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Jr,this.combine=om,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Xx=new ge,To=new wr,Vu=new Js,Yx=new H,Wu=new H,qu=new H,$u=new H,Wp=new H,Xu=new H,Zx=new H,Yu=new H,Ye=class extends Ti{constructor(t=new be,e=new ri){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Xu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Wp.fromBufferAttribute(h,t),o?Xu.addScaledVector(Wp,u):Xu.addScaledVector(Wp.sub(e),u))}e.add(Xu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Vu.copy(i.boundingSphere),Vu.applyMatrix4(r),To.copy(t.ray).recast(t.near),!(Vu.containsPoint(To.origin)===!1&&(To.intersectSphere(Vu,Yx)===null||To.origin.distanceToSquared(Yx)>(t.far-t.near)**2))&&(Xx.copy(r).invert(),To.copy(t.ray).applyMatrix4(Xx),!(i.boundingBox!==null&&To.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,To)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let p=d[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),E=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let b=x,A=E;b<A;b+=3){let T=a.getX(b),y=a.getX(b+1),S=a.getX(b+2);s=Zu(this,g,t,i,c,u,h,T,y,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let p=m,g=_;p<g;p+=3){let x=a.getX(p),E=a.getX(p+1),b=a.getX(p+2);s=Zu(this,o,t,i,c,u,h,x,E,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let p=d[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),E=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let b=x,A=E;b<A;b+=3){let T=b,y=b+1,S=b+2;s=Zu(this,g,t,i,c,u,h,T,y,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let p=m,g=_;p<g;p+=3){let x=p,E=p+1,b=p+2;s=Zu(this,o,t,i,c,u,h,x,E,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function N1(n,t,e,i,s,r,o,a){let l;if(t.side===Ci?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===so,a),l===null)return null;Yu.copy(a),Yu.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Yu);return c<e.near||c>e.far?null:{distance:c,point:Yu.clone(),object:n}}function Zu(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Wu),n.getVertexPosition(l,qu),n.getVertexPosition(c,$u);let u=N1(n,t,e,i,Wu,qu,$u,Zx);if(u){let h=new H;br.getBarycoord(Zx,Wu,qu,$u,h),s&&(u.uv=br.getInterpolatedAttribute(s,a,l,c,h,new Xt)),r&&(u.uv1=br.getInterpolatedAttribute(r,a,l,c,h,new Xt)),o&&(u.normal=br.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new H,materialIndex:0};br.getNormal(Wu,qu,$u,d.normal),u.face=d,u.barycoord=h}return u}var uc=class extends Ei{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Qn,u=Qn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ka=class extends Oe{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Aa=new ge,jx=new ge,ju=[],Jx=new Fi,U1=new ge,$l=new Ye,Xl=new Js,hc=class extends Ye{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ka(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,U1)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Fi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Aa),Jx.copy(t.boundingBox).applyMatrix4(Aa),this.boundingBox.union(Jx)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Js),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Aa),Xl.copy(t.boundingSphere).applyMatrix4(Aa),this.boundingSphere.union(Xl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if($l.geometry=this.geometry,$l.material=this.material,$l.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Xl.copy(this.boundingSphere),Xl.applyMatrix4(i),t.ray.intersectsSphere(Xl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Aa),jx.multiplyMatrices(i,Aa),$l.matrixWorld=jx,$l.raycast(t,ju);for(let o=0,a=ju.length;o<a;o++){let l=ju[o];l.instanceId=r,l.object=this,e.push(l)}ju.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new ka(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new uc(new Float32Array(s*this.count),s,this.count,qh,us));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ao=new Js,F1=new Xt(.5,.5),Ju=new H,Co=class{constructor(t=new si,e=new si,i=new si,s=new si,r=new si,o=new si){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=cs,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],m=r[8],_=r[9],p=r[10],g=r[11],x=r[12],E=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-m,A-x).normalize(),s[1].setComponents(c+o,f+u,g+m,A+x).normalize(),s[2].setComponents(c+a,f+h,g+_,A+E).normalize(),s[3].setComponents(c-a,f-h,g-_,A-E).normalize(),i)s[4].setComponents(l,d,p,b).normalize(),s[5].setComponents(c-l,f-d,g-p,A-b).normalize();else if(s[4].setComponents(c-l,f-d,g-p,A-b).normalize(),e===cs)s[5].setComponents(c+l,f+d,g+p,A+b).normalize();else if(e===ec)s[5].setComponents(l,d,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ao.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ao.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ao)}intersectsSprite(t){Ao.center.set(0,0,0);let e=F1.distanceTo(t.center);return Ao.radius=.7071067811865476+e,Ao.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ao)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ju.x=s.normal.x>0?t.max.x:t.min.x,Ju.y=s.normal.y>0?t.max.y:t.min.y,Ju.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ju)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Kx=new ge,vh=class n{constructor(){this.coordinateSystem=cs,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Kx.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Co),i[s].setFromProjectionMatrix(Kx,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Co),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Ki=class extends Ks{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new te(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},bh=new H,Mh=new H,Qx=new ge,Yl=new wr,Ku=new Js,qp=new H,t_=new H,Qs=class extends Ti{constructor(t=new be,e=new Ki){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)bh.fromBufferAttribute(e,s-1),Mh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=bh.distanceTo(Mh);t.setAttribute("lineDistance",new Ee(i,1))}else ne("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ku.copy(i.boundingSphere),Ku.applyMatrix4(s),Ku.radius+=r,t.ray.intersectsSphere(Ku)===!1)return;Qx.copy(s).invert(),Yl.copy(t.ray).applyMatrix4(Qx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=f,p=m-1;_<p;_+=c){let g=u.getX(_),x=u.getX(_+1),E=Qu(this,t,Yl,l,g,x,_);E&&e.push(E)}if(this.isLineLoop){let _=u.getX(m-1),p=u.getX(f),g=Qu(this,t,Yl,l,_,p,m-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let _=f,p=m-1;_<p;_+=c){let g=Qu(this,t,Yl,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=Qu(this,t,Yl,l,m-1,f,m-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Qu(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(bh.fromBufferAttribute(a,s),Mh.fromBufferAttribute(a,r),e.distanceSqToSegment(bh,Mh,qp,t_)>i)return;qp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(qp);if(!(c<t.near||c>t.far))return{distance:c,point:t_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var e_=new H,n_=new H,Po=class extends Qs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)e_.fromBufferAttribute(e,s),n_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+e_.distanceTo(n_);t.setAttribute("lineDistance",new Ee(i,1))}else ne("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var tr=class extends Ks{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new te(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},i_=new ge,jp=new wr,th=new Js,eh=new H,Er=class extends Ti{constructor(t=new be,e=new tr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),th.copy(i.boundingSphere),th.applyMatrix4(s),th.radius+=r,t.ray.intersectsSphere(th)===!1)return;i_.copy(s).invert(),jp.copy(t.ray).applyMatrix4(i_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,_=f;m<_;m++){let p=c.getX(m);eh.fromBufferAttribute(h,p),s_(eh,p,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let m=d,_=f;m<_;m++)eh.fromBufferAttribute(h,m),s_(eh,m,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function s_(n,t,e,i,s,r,o){let a=jp.distanceSqToPoint(n);if(a<e){let l=new H;jp.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var dc=class extends Ei{constructor(t=[],e=Uo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},fc=class extends Ei{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Tr=class extends Ei{constructor(t,e,i=Ts,s,r,o,a=Qn,l=Qn,c,u=Sr,h=1){if(u!==Sr&&u!==Rr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ua(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},pc=class extends Tr{constructor(t,e=Ts,i=Uo,s,r,o=Qn,a=Qn,l,c=Sr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},mc=class extends Ei{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Oi=class n extends be{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ee(c,3)),this.setAttribute("normal",new Ee(u,3)),this.setAttribute("uv",new Ee(h,2));function m(_,p,g,x,E,b,A,T,y,S,D){let L=b/y,N=A/S,z=b/2,G=A/2,B=T/2,X=y+1,P=S+1,U=0,Z=0,q=new H;for(let j=0;j<P;j++){let et=j*N-G;for(let dt=0;dt<X;dt++){let ft=dt*L-z;q[_]=ft*x,q[p]=et*E,q[g]=B,c.push(q.x,q.y,q.z),q[_]=0,q[p]=0,q[g]=T>0?1:-1,u.push(q.x,q.y,q.z),h.push(dt/y),h.push(1-j/S),U+=1}}for(let j=0;j<S;j++)for(let et=0;et<y;et++){let dt=d+et+X*j,ft=d+et+X*(j+1),st=d+(et+1)+X*(j+1),vt=d+(et+1)+X*j;l.push(dt,ft,vt),l.push(ft,st,vt),Z+=6}a.addGroup(f,Z,D),f+=Z,d+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Io=class n extends be{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,m=i*2+r,_=s+1,p=new H,g=new H;for(let x=0;x<=m;x++){let E=0,b=0,A=0,T=0;if(x<=i){let D=x/i,L=D*Math.PI/2;b=-u-t*Math.cos(L),A=t*Math.sin(L),T=-t*Math.cos(L),E=D*h}else if(x<=i+r){let D=(x-i)/r;b=-u+D*e,A=t,T=0,E=h+D*d}else{let D=(x-i-r)/i,L=D*Math.PI/2;b=u+t*Math.sin(L),A=t*Math.cos(L),T=t*Math.sin(L),E=h+d+D*h}let y=Math.max(0,Math.min(1,E/f)),S=0;x===0?S=.5/s:x===m&&(S=-.5/s);for(let D=0;D<=s;D++){let L=D/s,N=L*Math.PI*2,z=Math.sin(N),G=Math.cos(N);g.x=-A*G,g.y=b,g.z=A*z,a.push(g.x,g.y,g.z),p.set(-A*G,T,A*z),p.normalize(),l.push(p.x,p.y,p.z),c.push(L+S,y)}if(x>0){let D=(x-1)*_;for(let L=0;L<s;L++){let N=D+L,z=D+L+1,G=x*_+L,B=x*_+L+1;o.push(N,z,G),o.push(z,B,G)}}}this.setIndex(o),this.setAttribute("position",new Ee(a,3)),this.setAttribute("normal",new Ee(l,3)),this.setAttribute("uv",new Ee(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},gc=class n extends be{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new H,u=new Xt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new Ee(o,3)),this.setAttribute("normal",new Ee(a,3)),this.setAttribute("uv",new Ee(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ai=class n extends be{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],m=0,_=[],p=i/2,g=0;x(),o===!1&&(t>0&&E(!0),e>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new Ee(h,3)),this.setAttribute("normal",new Ee(d,3)),this.setAttribute("uv",new Ee(f,2));function x(){let b=new H,A=new H,T=0,y=(e-t)/i;for(let S=0;S<=r;S++){let D=[],L=S/r,N=L*(e-t)+t;for(let z=0;z<=s;z++){let G=z/s,B=G*l+a,X=Math.sin(B),P=Math.cos(B);A.x=N*X,A.y=-L*i+p,A.z=N*P,h.push(A.x,A.y,A.z),b.set(X,y,P).normalize(),d.push(b.x,b.y,b.z),f.push(G,1-L),D.push(m++)}_.push(D)}for(let S=0;S<s;S++)for(let D=0;D<r;D++){let L=_[D][S],N=_[D+1][S],z=_[D+1][S+1],G=_[D][S+1];(t>0||D!==0)&&(u.push(L,N,G),T+=3),(e>0||D!==r-1)&&(u.push(N,z,G),T+=3)}c.addGroup(g,T,0),g+=T}function E(b){let A=m,T=new Xt,y=new H,S=0,D=b===!0?t:e,L=b===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,p*L,0),d.push(0,L,0),f.push(.5,.5),m++;let N=m;for(let z=0;z<=s;z++){let B=z/s*l+a,X=Math.cos(B),P=Math.sin(B);y.x=D*P,y.y=p*L,y.z=D*X,h.push(y.x,y.y,y.z),d.push(0,L,0),T.x=X*.5+.5,T.y=P*.5*L+.5,f.push(T.x,T.y),m++}for(let z=0;z<s;z++){let G=A+z,B=N+z;b===!0?u.push(B,B+1,G):u.push(B+1,B,G),S+=3}c.addGroup(g,S,b===!0?1:2),g+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Lo=class n extends Ai{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Sh=class n extends be{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Ee(r,3)),this.setAttribute("normal",new Ee(r.slice(),3)),this.setAttribute("uv",new Ee(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let E=new H,b=new H,A=new H;for(let T=0;T<e.length;T+=3)f(e[T+0],E),f(e[T+1],b),f(e[T+2],A),l(E,b,A,x)}function l(x,E,b,A){let T=A+1,y=[];for(let S=0;S<=T;S++){y[S]=[];let D=x.clone().lerp(b,S/T),L=E.clone().lerp(b,S/T),N=T-S;for(let z=0;z<=N;z++)z===0&&S===T?y[S][z]=D:y[S][z]=D.clone().lerp(L,z/N)}for(let S=0;S<T;S++)for(let D=0;D<2*(T-S)-1;D++){let L=Math.floor(D/2);D%2===0?(d(y[S][L+1]),d(y[S+1][L]),d(y[S][L])):(d(y[S][L+1]),d(y[S+1][L+1]),d(y[S+1][L]))}}function c(x){let E=new H;for(let b=0;b<r.length;b+=3)E.x=r[b+0],E.y=r[b+1],E.z=r[b+2],E.normalize().multiplyScalar(x),r[b+0]=E.x,r[b+1]=E.y,r[b+2]=E.z}function u(){let x=new H;for(let E=0;E<r.length;E+=3){x.x=r[E+0],x.y=r[E+1],x.z=r[E+2];let b=p(x)/2/Math.PI+.5,A=g(x)/Math.PI+.5;o.push(b,1-A)}m(),h()}function h(){for(let x=0;x<o.length;x+=6){let E=o[x+0],b=o[x+2],A=o[x+4],T=Math.max(E,b,A),y=Math.min(E,b,A);T>.9&&y<.1&&(E<.2&&(o[x+0]+=1),b<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,E){let b=x*3;E.x=t[b+0],E.y=t[b+1],E.z=t[b+2]}function m(){let x=new H,E=new H,b=new H,A=new H,T=new Xt,y=new Xt,S=new Xt;for(let D=0,L=0;D<r.length;D+=9,L+=6){x.set(r[D+0],r[D+1],r[D+2]),E.set(r[D+3],r[D+4],r[D+5]),b.set(r[D+6],r[D+7],r[D+8]),T.set(o[L+0],o[L+1]),y.set(o[L+2],o[L+3]),S.set(o[L+4],o[L+5]),A.copy(x).add(E).add(b).divideScalar(3);let N=p(A);_(T,L+0,x,N),_(y,L+2,E,N),_(S,L+4,b,N)}}function _(x,E,b,A){A<0&&x.x===1&&(o[E]=x.x-1),b.x===0&&b.z===0&&(o[E]=A/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var xc=class n extends be{constructor(t=[new Xt(0,-.5),new Xt(.5,0),new Xt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=we(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new H,d=new Xt,f=new H,m=new H,_=new H,p=0,g=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:p=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-p,f.z=g*0,_.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:_.normalize(),l.push(_.x,_.y,_.z);break;default:p=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-p,f.z=g*0,m.copy(f),f.x+=_.x,f.y+=_.y,f.z+=_.z,f.normalize(),l.push(f.x,f.y,f.z),_.copy(m)}for(let x=0;x<=e;x++){let E=i+x*u*s,b=Math.sin(E),A=Math.cos(E);for(let T=0;T<=t.length-1;T++){h.x=t[T].x*b,h.y=t[T].y,h.z=t[T].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=T/(t.length-1),a.push(d.x,d.y);let y=l[3*T+0]*b,S=l[3*T+1],D=l[3*T+0]*A;c.push(y,S,D)}}for(let x=0;x<e;x++)for(let E=0;E<t.length-1;E++){let b=E+x*t.length,A=b,T=b+t.length,y=b+t.length+1,S=b+1;r.push(A,T,S),r.push(y,S,T)}this.setIndex(r),this.setAttribute("position",new Ee(o,3)),this.setAttribute("uv",new Ee(a,2)),this.setAttribute("normal",new Ee(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},_c=class n extends Sh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},yc=class n extends be{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],m=[],_=[],p=[];for(let g=0;g<u;g++){let x=g*d-o;for(let E=0;E<c;E++){let b=E*h-r;m.push(b,-x,0),_.push(0,0,1),p.push(E/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let E=x+c*g,b=x+c*(g+1),A=x+1+c*(g+1),T=x+1+c*g;f.push(E,b,T),f.push(b,A,T)}this.setIndex(f),this.setAttribute("position",new Ee(m,3)),this.setAttribute("normal",new Ee(_,3)),this.setAttribute("uv",new Ee(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Es=class n extends be{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,d=new H,f=[],m=[],_=[],p=[];for(let g=0;g<=i;g++){let x=[],E=g/i,b=o+E*a,A=t*Math.cos(b),T=Math.sqrt(t*t-A*A),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let S=0;S<=e;S++){let D=S/e,L=s+D*r;h.x=-T*Math.cos(L),h.y=A,h.z=T*Math.sin(L),m.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),p.push(D+y,1-E),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let E=u[g][x+1],b=u[g][x],A=u[g+1][x],T=u[g+1][x+1];(g!==0||o>0)&&f.push(E,b,T),(g!==i-1||l<Math.PI)&&f.push(b,A,T)}this.setIndex(f),this.setAttribute("position",new Ee(m,3)),this.setAttribute("normal",new Ee(_,3)),this.setAttribute("uv",new Ee(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var za=class n extends be{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new H,f=new H,m=new H;for(let _=0;_<=i;_++){let p=o+_/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(p))*Math.cos(x),f.y=(t+e*Math.cos(p))*Math.sin(x),f.z=e*Math.sin(p),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),m.subVectors(f,d).normalize(),u.push(m.x,m.y,m.z),h.push(g/s),h.push(_/i)}}for(let _=1;_<=i;_++)for(let p=1;p<=s;p++){let g=(s+1)*_+p-1,x=(s+1)*(_-1)+p-1,E=(s+1)*(_-1)+p,b=(s+1)*_+p;l.push(g,x,b),l.push(x,E,b)}this.setIndex(l),this.setAttribute("position",new Ee(c,3)),this.setAttribute("normal",new Ee(u,3)),this.setAttribute("uv",new Ee(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Oo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(r_(s))s.isRenderTargetTexture?(ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(r_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function di(n){let t={};for(let e=0;e<n.length;e++){let i=Oo(n[e]);for(let s in i)t[s]=i[s]}return t}function r_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function O1(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Dm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ie.workingColorSpace}var j_={clone:Oo,merge:di},B1=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,k1=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ri=class extends Ks{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=B1,this.fragmentShader=k1,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Oo(t.uniforms),this.uniformsGroups=O1(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new te().setHex(s.value);break;case"v2":this.uniforms[i].value=new Xt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new yn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ce().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ge().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},wh=class extends Ri{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Eh=class extends Ks{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=F_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Th=class extends Ks{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ra(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function nh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Qr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ah=class extends Qr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Xp,endingEnd:Xp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Yp:r=t,a=2*e-i;break;case Zp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Yp:o=t,l=2*i-e;break;case Zp:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),_=m*m,p=_*m,g=-d*p+2*d*_-d*m,x=(1+d)*p+(-1.5-2*d)*_+(-.5+d)*m+1,E=(-1-f)*p+(1.5+f)*_+.5*m,b=f*p-f*_;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[c+A]+E*o[l+A]+b*o[h+A];return r}},Rh=class extends Qr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Ch=class extends Qr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ph=class extends Qr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-e)/(s-e),_=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*_+o[l+p]*m;return r}let d=a*2,f=t-1;for(let m=0;m!==a;++m){let _=o[c+m],p=o[l+m],g=f*d+m*2,x=h[g],E=h[g+1],b=t*d+m*2,A=u[b],T=u[b+1],y=H1(i,e,x,A,s);r[m]=J_(y,_,E,T,p)}return r}};function J_(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function z1(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function H1(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=J_(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=z1(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Qi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ra(e,this.TimeBufferType),this.values=Ra(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ra(t.times,Array),values:Ra(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),nh(t.settings)&&(i.settings={inTangents:Ra(t.settings.inTangents,Array),outTangents:Ra(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ch(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Rh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ah(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ph(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Kl:e=this.InterpolantFactoryMethodDiscrete;break;case gh:e=this.InterpolantFactoryMethodLinear;break;case rh:e=this.InterpolantFactoryMethodSmooth;break;case $p:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ne("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Kl;case this.InterpolantFactoryMethodLinear:return gh;case this.InterpolantFactoryMethodSmooth:return rh;case this.InterpolantFactoryMethodBezier:return $p}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;nh(this.settings)&&(o_(this.settings.inTangents,t),o_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;nh(this.settings)&&(a_(this.settings.inTangents,t),a_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&n1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===rh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let m=0;m!==i;++m){let _=e[h+m];if(_!==e[d+m]||_!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,nh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function o_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function a_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Qi.prototype.ValueTypeName="";Qi.prototype.TimeBufferType=Float32Array;Qi.prototype.ValueBufferType=Float32Array;Qi.prototype.DefaultInterpolation=gh;var to=class extends Qi{constructor(t,e,i){super(t,e,i)}};to.prototype.ValueTypeName="bool";to.prototype.ValueBufferType=Array;to.prototype.DefaultInterpolation=Kl;to.prototype.InterpolantFactoryMethodLinear=void 0;to.prototype.InterpolantFactoryMethodSmooth=void 0;var Ih=class extends Qi{constructor(t,e,i,s){super(t,e,i,s)}};Ih.prototype.ValueTypeName="color";var Lh=class extends Qi{constructor(t,e,i,s){super(t,e,i,s)}};Lh.prototype.ValueTypeName="number";var Dh=class extends Qr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)un.slerpFlat(r,0,o,c-a,o,c,l);return r}},vc=class extends Qi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Dh(this.times,this.values,this.getValueSize(),t)}};vc.prototype.ValueTypeName="quaternion";vc.prototype.InterpolantFactoryMethodSmooth=void 0;var eo=class extends Qi{constructor(t,e,i){super(t,e,i)}};eo.prototype.ValueTypeName="string";eo.prototype.ValueBufferType=Array;eo.prototype.DefaultInterpolation=Kl;eo.prototype.InterpolantFactoryMethodLinear=void 0;eo.prototype.InterpolantFactoryMethodSmooth=void 0;var Nh=class extends Qi{constructor(t,e,i,s){super(t,e,i,s)}};Nh.prototype.ValueTypeName="vector";var Uh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},K_=new Uh,Fh=class{constructor(t){this.manager=t!==void 0?t:K_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Fh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ih=new H,sh=new un,Zs=new H,bc=class extends Ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,this.coordinateSystem=cs,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ih,sh,Zs),Zs.x===1&&Zs.y===1&&Zs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ih,sh,Zs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ih,sh,Zs),Zs.x===1&&Zs.y===1&&Zs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ih,sh,Zs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},jr=new H,l_=new Xt,c_=new Xt,Si=class extends bc{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Na*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(jl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Na*2*Math.atan(Math.tan(jl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){jr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(jr.x,jr.y).multiplyScalar(-t/jr.z),jr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(jr.x,jr.y).multiplyScalar(-t/jr.z)}getViewSize(t,e){return this.getViewBounds(t,l_,c_),e.subVectors(c_,l_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(jl*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Oh=class extends bc{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Ca=-90,Pa=1,Ha=class extends Ti{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Si(Ca,Pa,t,e);s.layers=this.layers,this.add(s);let r=new Si(Ca,Pa,t,e);r.layers=this.layers,this.add(r);let o=new Si(Ca,Pa,t,e);o.layers=this.layers,this.add(o);let a=new Si(Ca,Pa,t,e);a.layers=this.layers,this.add(a);let l=new Si(Ca,Pa,t,e);l.layers=this.layers,this.add(l);let c=new Si(Ca,Pa,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===cs)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ec)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Bh=class extends Si{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Nm="\\[\\]\\.:\\/",G1=new RegExp("["+Nm+"]","g"),Um="[^"+Nm+"]",V1="[^"+Nm.replace("\\.","")+"]",W1=/((?:WC+[\/:])*)/.source.replace("WC",Um),q1=/(WCOD+)?/.source.replace("WCOD",V1),$1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Um),X1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Um),Y1=new RegExp("^"+W1+q1+$1+X1+"$"),Z1=["material","materials","bones","map"],Jp=class{constructor(t,e,i){let s=i||cn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},cn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(G1,"")}static parseTrackName(t){let e=Y1.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Z1.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ne("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};cn.Composite=Jp;cn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};cn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};cn.prototype.GetterByBindingType=[cn.prototype._getValue_direct,cn.prototype._getValue_array,cn.prototype._getValue_arrayElement,cn.prototype._getValue_toArray];cn.prototype.SetterByBindingTypeAndVersioning=[[cn.prototype._setValue_direct,cn.prototype._setValue_direct_setNeedsUpdate,cn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[cn.prototype._setValue_array,cn.prototype._setValue_array_setNeedsUpdate,cn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[cn.prototype._setValue_arrayElement,cn.prototype._setValue_arrayElement_setNeedsUpdate,cn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[cn.prototype._setValue_fromArray,cn.prototype._setValue_fromArray_setNeedsUpdate,cn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nD=new Float32Array(1);var u_=new ge,Mc=class{constructor(t,e,i=0,s=1/0){this.ray=new wr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Fa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):re("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return u_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(u_),this}intersectObject(t,e=!0,i=[]){return Kp(t,this,i,e),i.sort(h_),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Kp(t[s],this,i,e);return i.sort(h_),i}};function h_(n,t){return n.distance-t.distance}function Kp(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Kp(r[o],t,e,!0)}}var Ga=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=we(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(we(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Qp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Sc=class extends ws{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Fm(n,t,e,i){let s=j1(i);switch(e){case ym:return n*t;case qh:return n*t/s.components*s.byteLength;case $h:return n*t/s.components*s.byteLength;case ro:return n*t*2/s.components*s.byteLength;case Xh:return n*t*2/s.components*s.byteLength;case vm:return n*t*3/s.components*s.byteLength;case Rs:return n*t*4/s.components*s.byteLength;case Yh:return n*t*4/s.components*s.byteLength;case Tc:case Ac:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Rc:case Cc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case jh:case Kh:return Math.max(n,16)*Math.max(t,8)/4;case Zh:case Jh:return Math.max(n,8)*Math.max(t,8)/2;case Qh:case td:case nd:case id:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ed:case Pc:case sd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case rd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case od:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ad:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case ld:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case cd:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case ud:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case hd:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case dd:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case fd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case pd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case md:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case gd:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case xd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case _d:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case yd:case vd:case bd:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Md:case Sd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ic:case wd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function j1(n){switch(n){case ts:case mm:return{byteLength:1,components:1};case $a:case gm:case As:return{byteLength:2,components:1};case Vh:case Wh:return{byteLength:2,components:4};case Ts:case Gh:case us:return{byteLength:4,components:1};case xm:case _m:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function vy(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function eE(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],_=h[f];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let _=h[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var nE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,iE=`#ifdef USE_ALPHAHASH
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
#endif`,sE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,rE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,oE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,aE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,lE=`#ifdef USE_AOMAP
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
#endif`,cE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,uE=`#ifdef USE_BATCHING
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
#endif`,hE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,dE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,fE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,pE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,mE=`#ifdef USE_IRIDESCENCE
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
#endif`,gE=`#ifdef USE_BUMPMAP
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
#endif`,xE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,_E=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,yE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,vE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,bE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ME=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,SE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,wE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,EE=`#define PI 3.141592653589793
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
} // validated`,TE=`vec3 transformedNormal = objectNormal;
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
#endif`,AE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,RE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,CE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,PE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,IE="gl_FragColor = linearToOutputTexel( gl_FragColor );",LE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,DE=`#ifdef USE_ENVMAP
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
#endif`,NE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,UE=`#ifdef USE_ENVMAP
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
#endif`,FE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,OE=`#ifdef USE_ENVMAP
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
#endif`,BE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,kE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,zE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,HE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,GE=`#ifdef USE_GRADIENTMAP
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
}`,VE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,WE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,$E=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,XE=`#ifdef USE_ENVMAP
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
#endif`,YE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ZE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,jE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,JE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,KE=`PhysicalMaterial material;
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
#endif`,QE=`uniform sampler2D dfgLUT;
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
}`,tT=`
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
#endif`,eT=`#if defined( RE_IndirectDiffuse )
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
#endif`,nT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,iT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,sT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,rT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,oT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,aT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,lT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,cT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,uT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,hT=`#if defined( USE_POINTS_UV )
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
#endif`,dT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,fT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,pT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,mT=`#if defined( USE_MORPHCOLORS )
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
#endif`,gT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xT=`#ifdef USE_MORPHTARGETS
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
#endif`,_T=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,vT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,bT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,MT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ST=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,wT=`#ifdef USE_NORMALMAP
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
#endif`,ET=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,TT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,AT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,RT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,CT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,PT=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,IT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,LT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,DT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,NT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,UT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,FT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,OT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,BT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,kT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,zT=`float getShadowMask() {
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
}`,HT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,GT=`#ifdef USE_SKINNING
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
#endif`,VT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,WT=`#ifdef USE_SKINNING
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
#endif`,qT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,$T=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,XT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,YT=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ZT=`#ifdef USE_TRANSMISSION
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
#endif`,jT=`#ifdef USE_TRANSMISSION
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
#endif`,JT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,KT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,QT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,tA=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,eA=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,nA=`uniform sampler2D t2D;
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
}`,iA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sA=`uniform float backgroundBlurriness;
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
}`,rA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oA=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aA=`#include <common>
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
}`,lA=`#if DEPTH_PACKING == 3200
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
}`,cA=`#define DISTANCE
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
}`,uA=`#define DISTANCE
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
}`,hA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,dA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fA=`uniform float scale;
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
}`,pA=`uniform vec3 diffuse;
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
}`,mA=`#include <common>
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
}`,gA=`uniform vec3 diffuse;
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
}`,xA=`#define LAMBERT
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
}`,_A=`#define LAMBERT
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
}`,yA=`#define MATCAP
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
}`,vA=`#define MATCAP
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
}`,bA=`#define NORMAL
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
}`,MA=`#define NORMAL
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
}`,SA=`#define PHONG
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
}`,wA=`#define PHONG
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
}`,EA=`#define STANDARD
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
}`,TA=`#define STANDARD
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
}`,AA=`#define TOON
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
}`,RA=`#define TOON
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
}`,CA=`uniform float size;
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
}`,PA=`uniform vec3 diffuse;
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
}`,IA=`#include <common>
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
}`,LA=`uniform vec3 color;
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
}`,DA=`uniform float rotation;
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
}`,NA=`uniform vec3 diffuse;
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
}`,Me={alphahash_fragment:nE,alphahash_pars_fragment:iE,alphamap_fragment:sE,alphamap_pars_fragment:rE,alphatest_fragment:oE,alphatest_pars_fragment:aE,aomap_fragment:lE,aomap_pars_fragment:cE,batching_pars_vertex:uE,batching_vertex:hE,begin_vertex:dE,beginnormal_vertex:fE,bsdfs:pE,iridescence_fragment:mE,bumpmap_pars_fragment:gE,clipping_planes_fragment:xE,clipping_planes_pars_fragment:_E,clipping_planes_pars_vertex:yE,clipping_planes_vertex:vE,color_fragment:bE,color_pars_fragment:ME,color_pars_vertex:SE,color_vertex:wE,common:EE,defaultnormal_vertex:TE,displacementmap_pars_vertex:AE,displacementmap_vertex:RE,emissivemap_fragment:CE,emissivemap_pars_fragment:PE,colorspace_fragment:IE,colorspace_pars_fragment:LE,envmap_fragment:DE,envmap_common_pars_fragment:NE,envmap_pars_fragment:UE,envmap_pars_vertex:FE,envmap_physical_pars_fragment:XE,envmap_vertex:OE,fog_vertex:BE,fog_pars_vertex:kE,fog_fragment:zE,fog_pars_fragment:HE,gradientmap_pars_fragment:GE,lightmap_pars_fragment:VE,lights_lambert_fragment:WE,lights_lambert_pars_fragment:qE,lights_pars_begin:$E,lights_toon_fragment:YE,lights_toon_pars_fragment:ZE,lights_phong_fragment:jE,lights_phong_pars_fragment:JE,lights_physical_fragment:KE,lights_physical_pars_fragment:QE,lights_fragment_begin:tT,lights_fragment_maps:eT,lights_fragment_end:nT,lightprobes_pars_fragment:iT,logdepthbuf_fragment:sT,logdepthbuf_pars_fragment:rT,logdepthbuf_pars_vertex:oT,logdepthbuf_vertex:aT,map_fragment:lT,map_pars_fragment:cT,map_particle_fragment:uT,map_particle_pars_fragment:hT,metalnessmap_fragment:dT,metalnessmap_pars_fragment:fT,morphinstance_vertex:pT,morphcolor_vertex:mT,morphnormal_vertex:gT,morphtarget_pars_vertex:xT,morphtarget_vertex:_T,normal_fragment_begin:yT,normal_fragment_maps:vT,normal_pars_fragment:bT,normal_pars_vertex:MT,normal_vertex:ST,normalmap_pars_fragment:wT,clearcoat_normal_fragment_begin:ET,clearcoat_normal_fragment_maps:TT,clearcoat_pars_fragment:AT,iridescence_pars_fragment:RT,opaque_fragment:CT,packing:PT,premultiplied_alpha_fragment:IT,project_vertex:LT,dithering_fragment:DT,dithering_pars_fragment:NT,roughnessmap_fragment:UT,roughnessmap_pars_fragment:FT,shadowmap_pars_fragment:OT,shadowmap_pars_vertex:BT,shadowmap_vertex:kT,shadowmask_pars_fragment:zT,skinbase_vertex:HT,skinning_pars_vertex:GT,skinning_vertex:VT,skinnormal_vertex:WT,specularmap_fragment:qT,specularmap_pars_fragment:$T,tonemapping_fragment:XT,tonemapping_pars_fragment:YT,transmission_fragment:ZT,transmission_pars_fragment:jT,uv_pars_fragment:JT,uv_pars_vertex:KT,uv_vertex:QT,worldpos_vertex:tA,background_vert:eA,background_frag:nA,backgroundCube_vert:iA,backgroundCube_frag:sA,cube_vert:rA,cube_frag:oA,depth_vert:aA,depth_frag:lA,distance_vert:cA,distance_frag:uA,equirect_vert:hA,equirect_frag:dA,linedashed_vert:fA,linedashed_frag:pA,meshbasic_vert:mA,meshbasic_frag:gA,meshlambert_vert:xA,meshlambert_frag:_A,meshmatcap_vert:yA,meshmatcap_frag:vA,meshnormal_vert:bA,meshnormal_frag:MA,meshphong_vert:SA,meshphong_frag:wA,meshphysical_vert:EA,meshphysical_frag:TA,meshtoon_vert:AA,meshtoon_frag:RA,points_vert:CA,points_frag:PA,shadow_vert:IA,shadow_frag:LA,sprite_vert:DA,sprite_frag:NA},Ot={common:{diffuse:{value:new te(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new Xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new te(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new te(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new te(16777215)},opacity:{value:1},center:{value:new Xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},ir={basic:{uniforms:di([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:Me.meshbasic_vert,fragmentShader:Me.meshbasic_frag},lambert:{uniforms:di([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new te(0)},envMapIntensity:{value:1}}]),vertexShader:Me.meshlambert_vert,fragmentShader:Me.meshlambert_frag},phong:{uniforms:di([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new te(0)},specular:{value:new te(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Me.meshphong_vert,fragmentShader:Me.meshphong_frag},standard:{uniforms:di([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new te(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Me.meshphysical_vert,fragmentShader:Me.meshphysical_frag},toon:{uniforms:di([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new te(0)}}]),vertexShader:Me.meshtoon_vert,fragmentShader:Me.meshtoon_frag},matcap:{uniforms:di([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:Me.meshmatcap_vert,fragmentShader:Me.meshmatcap_frag},points:{uniforms:di([Ot.points,Ot.fog]),vertexShader:Me.points_vert,fragmentShader:Me.points_frag},dashed:{uniforms:di([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Me.linedashed_vert,fragmentShader:Me.linedashed_frag},depth:{uniforms:di([Ot.common,Ot.displacementmap]),vertexShader:Me.depth_vert,fragmentShader:Me.depth_frag},normal:{uniforms:di([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:Me.meshnormal_vert,fragmentShader:Me.meshnormal_frag},sprite:{uniforms:di([Ot.sprite,Ot.fog]),vertexShader:Me.sprite_vert,fragmentShader:Me.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Me.background_vert,fragmentShader:Me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:Me.backgroundCube_vert,fragmentShader:Me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Me.cube_vert,fragmentShader:Me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Me.equirect_vert,fragmentShader:Me.equirect_frag},distance:{uniforms:di([Ot.common,Ot.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Me.distance_vert,fragmentShader:Me.distance_frag},shadow:{uniforms:di([Ot.lights,Ot.fog,{color:{value:new te(0)},opacity:{value:1}}]),vertexShader:Me.shadow_vert,fragmentShader:Me.shadow_frag}};ir.physical={uniforms:di([ir.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new Xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ce},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new te(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new Xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new te(0)},specularColor:{value:new te(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new Xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:Me.meshphysical_vert,fragmentShader:Me.meshphysical_frag};var Ad={r:0,b:0,g:0},UA=new ge,by=new ce;by.set(-1,0,0,0,1,0,0,0,1);function FA(n,t,e,i,s,r){let o=new te(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let E=x.isScene===!0?x.background:null;if(E&&E.isTexture){let b=x.backgroundBlurriness>0;E=t.get(E,b)}return E}function m(x){let E=!1,b=f(x);b===null?p(o,a):b&&b.isColor&&(p(b,1),E=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,E){let b=f(E);b&&b.isCubeTexture?(c===void 0&&(c=new Ye(new Oi(1,1,1),new Ri({name:"BackgroundCubeMaterial",uniforms:Oo(ir.backgroundCube.uniforms),vertexShader:ir.backgroundCube.vertexShader,fragmentShader:ir.backgroundCube.fragmentShader,side:Ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,T,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(UA.makeRotationFromEuler(E.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(by),c.material.toneMapped=Ie.getTransfer(b.colorSpace)!==Ge,(u!==b||h!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ye(new yc(2,2),new Ri({name:"BackgroundMaterial",uniforms:Oo(ir.background.uniforms),vertexShader:ir.background.vertexShader,fragmentShader:ir.background.fragmentShader,side:so,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=Ie.getTransfer(b.colorSpace)!==Ge,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,E){x.getRGB(Ad,Dm(n)),e.buffers.color.setClear(Ad.r,Ad.g,Ad.b,E,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,E=1){o.set(x),a=E,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:m,addToRenderList:_,dispose:g}}function OA(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(N,z,G,B,X){let P=!1,U=h(N,B,G,z);r!==U&&(r=U,c(r.object)),P=f(N,B,G,X),P&&m(N,B,G,X),X!==null&&t.update(X,n.ELEMENT_ARRAY_BUFFER),(P||o)&&(o=!1,b(N,z,G,B),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return n.createVertexArray()}function c(N){return n.bindVertexArray(N)}function u(N){return n.deleteVertexArray(N)}function h(N,z,G,B){let X=B.wireframe===!0,P=i[z.id];P===void 0&&(P={},i[z.id]=P);let U=N.isInstancedMesh===!0?N.id:0,Z=P[U];Z===void 0&&(Z={},P[U]=Z);let q=Z[G.id];q===void 0&&(q={},Z[G.id]=q);let j=q[X];return j===void 0&&(j=d(l()),q[X]=j),j}function d(N){let z=[],G=[],B=[];for(let X=0;X<e;X++)z[X]=0,G[X]=0,B[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:G,attributeDivisors:B,object:N,attributes:{},index:null}}function f(N,z,G,B){let X=r.attributes,P=z.attributes,U=0,Z=G.getAttributes();for(let q in Z)if(Z[q].location>=0){let et=X[q],dt=P[q];if(dt===void 0&&(q==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),q==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;U++}return r.attributesNum!==U||r.index!==B}function m(N,z,G,B){let X={},P=z.attributes,U=0,Z=G.getAttributes();for(let q in Z)if(Z[q].location>=0){let et=P[q];et===void 0&&(q==="instanceMatrix"&&N.instanceMatrix&&(et=N.instanceMatrix),q==="instanceColor"&&N.instanceColor&&(et=N.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),X[q]=dt,U++}r.attributes=X,r.attributesNum=U,r.index=B}function _(){let N=r.newAttributes;for(let z=0,G=N.length;z<G;z++)N[z]=0}function p(N){g(N,0)}function g(N,z){let G=r.newAttributes,B=r.enabledAttributes,X=r.attributeDivisors;G[N]=1,B[N]===0&&(n.enableVertexAttribArray(N),B[N]=1),X[N]!==z&&(n.vertexAttribDivisor(N,z),X[N]=z)}function x(){let N=r.newAttributes,z=r.enabledAttributes;for(let G=0,B=z.length;G<B;G++)z[G]!==N[G]&&(n.disableVertexAttribArray(G),z[G]=0)}function E(N,z,G,B,X,P,U){U===!0?n.vertexAttribIPointer(N,z,G,X,P):n.vertexAttribPointer(N,z,G,B,X,P)}function b(N,z,G,B){_();let X=B.attributes,P=G.getAttributes(),U=z.defaultAttributeValues;for(let Z in P){let q=P[Z];if(q.location>=0){let j=X[Z];if(j===void 0&&(Z==="instanceMatrix"&&N.instanceMatrix&&(j=N.instanceMatrix),Z==="instanceColor"&&N.instanceColor&&(j=N.instanceColor)),j!==void 0){let et=j.normalized,dt=j.itemSize,ft=t.get(j);if(ft===void 0)continue;let st=ft.buffer,vt=ft.type,_t=ft.bytesPerElement,Tt=vt===n.INT||vt===n.UNSIGNED_INT||j.gpuType===Gh;if(j.isInterleavedBufferAttribute){let At=j.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,pe=j.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Zt=0;Zt<q.locationSize;Zt++)g(q.location+Zt,At.meshPerAttribute);N.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Zt=0;Zt<q.locationSize;Zt++)p(q.location+Zt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let Zt=0;Zt<q.locationSize;Zt++)E(q.location+Zt,dt/q.locationSize,vt,et,Jt*_t,(pe+dt/q.locationSize*Zt)*_t,Tt)}else{if(j.isInstancedBufferAttribute){for(let At=0;At<q.locationSize;At++)g(q.location+At,j.meshPerAttribute);N.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let At=0;At<q.locationSize;At++)p(q.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<q.locationSize;At++)E(q.location+At,dt/q.locationSize,vt,et,dt*_t,dt/q.locationSize*At*_t,Tt)}}else if(U!==void 0){let et=U[Z];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(q.location,et);break;case 3:n.vertexAttrib3fv(q.location,et);break;case 4:n.vertexAttrib4fv(q.location,et);break;default:n.vertexAttrib1fv(q.location,et)}}}}x()}function A(){D();for(let N in i){let z=i[N];for(let G in z){let B=z[G];for(let X in B){let P=B[X];for(let U in P)u(P[U].object),delete P[U];delete B[X]}}delete i[N]}}function T(N){if(i[N.id]===void 0)return;let z=i[N.id];for(let G in z){let B=z[G];for(let X in B){let P=B[X];for(let U in P)u(P[U].object),delete P[U];delete B[X]}}delete i[N.id]}function y(N){for(let z in i){let G=i[z];for(let B in G){let X=G[B];if(X[N.id]===void 0)continue;let P=X[N.id];for(let U in P)u(P[U].object),delete P[U];delete X[N.id]}}}function S(N){for(let z in i){let G=i[z],B=N.isInstancedMesh===!0?N.id:0,X=G[B];if(X!==void 0){for(let P in X){let U=X[P];for(let Z in U)u(U[Z].object),delete U[Z];delete X[P]}delete G[B],Object.keys(G).length===0&&delete i[z]}}}function D(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:T,releaseStatesOfObject:S,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:p,disableUnusedAttributes:x}}function BA(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function kA(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Rs&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let S=y===As&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==ts&&y!==us&&!S&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ne("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ne("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:x,maxVaryings:E,maxFragmentUniforms:b,maxSamples:A,samples:T}}function zA(n){let t=this,e=null,i=0,s=!1,r=!1,o=new si,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,_=h.clipIntersection,p=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!p)r?u(null):c();else{let x=r?0:i,E=x*4,b=g.clippingState||null;l.value=b,b=u(m,d,E,f);for(let A=0;A!==E;++A)b[A]=e[A];g.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,m){let _=h!==null?h.length:0,p=null;if(_!==0){if(p=l.value,m!==!0||p===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<g)&&(p=new Float32Array(g));for(let E=0,b=f;E!==_;++E,b+=4)o.copy(h[E]).applyMatrix4(x,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,p}}var Nc=class extends Ji{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new dc(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Oi(5,5,5),r=new Ri({name:"CubemapFromEquirect",uniforms:Oo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ci,blending:Do});r.uniforms.tEquirect.value=e;let o=new Ye(s,r),a=e.minFilter;return e.minFilter===Ar&&(e.minFilter=wi),new Ha(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Q_=256,HA=3,GA=20,My=256,Sy=16,VA=3,WA=new H,qA=new te,Cd=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ha(1,10,null),this._boxMesh=new Ye(new Oi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=WA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(qA));let p=new Ha(i,s,u);return p.position.copy(a),p.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ny(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ey(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Q_,Pm(t))}_fromTexture(t,e){t.mapping===Uo||t.mapping===qa?this._setSize(t.image.length===0?Q_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=ty(t,!1,!1),i=Math.log2(t)-HA;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ty(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Uo||t.mapping===qa?(this._cubemapMaterial===null&&(this._cubemapMaterial=ny()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ey()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=$A(),this._integrationMaterial=XA());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Sy);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-VA)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(My*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=YA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function ty(n,t,e){return new Nc(n,{minFilter:Ar,generateMipmaps:t,type:As,colorSpace:Ql,depthBuffer:e})}function Uc(n,t,e){return new Ri({name:n,uniforms:t,vertexShader:Me.cube_vert,fragmentShader:e,side:Ci,blending:Do,depthTest:!1,depthWrite:!1})}function $A(){return Uc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${My}u

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
	`)}function XA(){return Uc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Sy}},`

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
	`)}function YA(){return Uc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${GA}
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
	`)}function ey(){return Uc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function ny(){return Uc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ZA(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===kh||f===zh)if(t.has(d)){let m=t.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let _=new Nc(m.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===kh||f===zh,_=f===Uo||f===qa;if(m||_){let p=e.get(d),g=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Cd(n)),p=m?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return m&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new Cd(n)),p=m?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function a(d,f){return f===kh?d.mapping=Uo:f===zh&&(d.mapping=qa),d}function l(d){let f=0,m=6;for(let _=0;_<m;_++)d[_]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function jA(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Zl("WebGLRenderer: "+i+" extension not supported."),s}}}function JA(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(t.remove(_),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(m){let _=m.attributes;for(let p in _)t.update(_[p],n.ARRAY_BUFFER)}function h(m){let _=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let x=_!==null?_.array.length:p.array.length/3-1,E=p.count>=65535?lc:ac,b=new E(Math.ceil(x/3)*6,1),A=b.array;if(_!==null){let y=_.array;g=_.version;for(let S=0,D=0;S<x;S+=3){let L=y[S+0],N=y[S+1],z=y[S+2];A[D++]=L,A[D++]=N,A[D++]=N,A[D++]=z,A[D++]=z,A[D++]=L}}else{g=p.version;for(let y=0,S=0;y<x;y+=3){let D=y+0,L=y+1,N=y+2;A[S++]=D,A[S++]=L,A[S++]=L,A[S++]=N,A[S++]=N,A[S++]=D}}b.version=g;let T=r.get(m);T&&t.remove(T),r.set(m,b)}function d(m){let _=r.get(m);if(_){let p=m.index;p!==null&&_.version<p.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function KA(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let p=0;p<f;p++)_+=d[p];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function QA(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function tR(n,t,e){let i=new WeakMap,s=new yn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let D=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],E=0;f===!0&&(E=1),m===!0&&(E=2),_===!0&&(E=3);let b=a.attributes.position.count*E,A=1;b>t.maxTextureSize&&(A=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let T=new Float32Array(b*A*4*h),y=new sc(T,b,A,h);y.type=us,y.needsUpdate=!0;let S=E*4;for(let L=0;L<h;L++){let N=p[L],z=g[L],G=x[L],B=b*A*4*L;for(let X=0;X<N.count;X++){let P=X*S;f===!0&&(s.fromBufferAttribute(N,X),T[B+P+0]=s.x,T[B+P+1]=s.y,T[B+P+2]=s.z,T[B+P+3]=0),m===!0&&(s.fromBufferAttribute(z,X),T[B+P+4]=s.x,T[B+P+5]=s.y,T[B+P+6]=s.z,T[B+P+7]=0),_===!0&&(s.fromBufferAttribute(G,X),T[B+P+8]=s.x,T[B+P+9]=s.y,T[B+P+10]=s.z,T[B+P+11]=G.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Xt(b,A)},i.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function eR(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var nR={[am]:"LINEAR_TONE_MAPPING",[lm]:"REINHARD_TONE_MAPPING",[cm]:"CINEON_TONE_MAPPING",[um]:"ACES_FILMIC_TONE_MAPPING",[dm]:"AGX_TONE_MAPPING",[fm]:"NEUTRAL_TONE_MAPPING",[hm]:"CUSTOM_TONE_MAPPING"};function iR(n,t,e,i,s,r){let o=new Ji(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new be;u.setAttribute("position",new Ee([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ee([0,2,0,0,2,0],2));let h=new wh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ye(u,h),f=new Oh(-1,1,1,-1,0,1),m=null,_=null,p=!1,g,x=null,E=[],b=!1;this.setSize=function(A,T){o.setSize(A,T),a!==null&&a.setSize(A,T),l!==null&&l.setSize(A,T);for(let y=0;y<E.length;y++){let S=E[y];S.setSize&&S.setSize(A,T)}},this.setEffects=function(A){E=A,b=E.length>0&&E[0].isRenderPass===!0;let T=o.width,y=o.height;E.length>0&&a===null&&(a=new Ji(T,y,{type:As,depthBuffer:!1,stencilBuffer:!1}),l=new Ji(T,y,{type:As,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&E.some(D=>D.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Tr(T,y),r===!0&&(c.format=Rr,c.type=Fo)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let D=0;D<E.length;D++){let L=E[D];L.setSize&&L.setSize(T,y),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(A,T){if(p||A.toneMapping===er&&E.length===0)return!1;if(x=T,T!==null){let y=T.width,S=T.height;(o.width!==y||o.height!==S)&&this.setSize(y,S)}return b===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=er,!0},this.hasRenderPass=function(){return b},this.end=function(A,T){A.toneMapping=g,p=!0;let y=o,S=a;for(let D=0;D<E.length;D++){let L=E[D];L.enabled!==!1&&(L.render(A,S,y,T),L.needsSwap!==!1&&(y=S,S=S===a?l:a))}if(m!==A.outputColorSpace||_!==A.toneMapping){m=A.outputColorSpace,_=A.toneMapping,h.defines={},Ie.getTransfer(m)===Ge&&(h.defines.SRGB_TRANSFER="");let D=nR[_];D&&(h.defines[D]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var wy=new Ei,Ey=new Tr(1,1),Ty=new pc(1),Ay=new sc,Ry=new yh,Cy=new dc,iy=[],sy=[],ry=new Float32Array(16),oy=new Float32Array(9),ay=new Float32Array(4);function Ya(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=iy[s];if(r===void 0&&(r=new Float32Array(s),iy[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function zn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Hn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Id(n,t){let e=sy[t];e===void 0&&(e=new Int32Array(t),sy[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function sR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function rR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(zn(e,t))return;n.uniform2fv(this.addr,t),Hn(e,t)}}function oR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(zn(e,t))return;n.uniform3fv(this.addr,t),Hn(e,t)}}function aR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(zn(e,t))return;n.uniform4fv(this.addr,t),Hn(e,t)}}function lR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(zn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Hn(e,t)}else{if(zn(e,i))return;ay.set(i),n.uniformMatrix2fv(this.addr,!1,ay),Hn(e,i)}}function cR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(zn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Hn(e,t)}else{if(zn(e,i))return;oy.set(i),n.uniformMatrix3fv(this.addr,!1,oy),Hn(e,i)}}function uR(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(zn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Hn(e,t)}else{if(zn(e,i))return;ry.set(i),n.uniformMatrix4fv(this.addr,!1,ry),Hn(e,i)}}function hR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function dR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(zn(e,t))return;n.uniform2iv(this.addr,t),Hn(e,t)}}function fR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(zn(e,t))return;n.uniform3iv(this.addr,t),Hn(e,t)}}function pR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(zn(e,t))return;n.uniform4iv(this.addr,t),Hn(e,t)}}function mR(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function gR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(zn(e,t))return;n.uniform2uiv(this.addr,t),Hn(e,t)}}function xR(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(zn(e,t))return;n.uniform3uiv(this.addr,t),Hn(e,t)}}function _R(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(zn(e,t))return;n.uniform4uiv(this.addr,t),Hn(e,t)}}function Ld(n){return n.version===0&&(n.compareFunction=Tm,n.needsUpdate=!0),n}function yR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ld(Ey):r=wy,e.setTexture2D(t||r,s)}function vR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Ry,s)}function bR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ld(Ty):r=Cy,e.setTextureCube(t||r,s)}function MR(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Ay,s)}function SR(n){switch(n){case 5126:return sR;case 35664:return rR;case 35665:return oR;case 35666:return aR;case 35674:return lR;case 35675:return cR;case 35676:return uR;case 5124:case 35670:return hR;case 35667:case 35671:return dR;case 35668:case 35672:return fR;case 35669:case 35673:return pR;case 5125:return mR;case 36294:return gR;case 36295:return xR;case 36296:return _R;case 35678:case 36198:case 36298:case 36306:case 35682:return yR;case 35679:case 36299:case 36307:return vR;case 35680:case 36300:case 36308:case 36293:return bR;case 36289:case 36303:case 36311:case 36292:return MR}}function wR(n,t){n.uniform1fv(this.addr,t)}function ER(n,t){let e=Ya(t,this.size,2);n.uniform2fv(this.addr,e)}function TR(n,t){let e=Ya(t,this.size,3);n.uniform3fv(this.addr,e)}function AR(n,t){let e=Ya(t,this.size,4);n.uniform4fv(this.addr,e)}function RR(n,t){let e=Ya(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function CR(n,t){let e=Ya(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function PR(n,t){let e=Ya(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function IR(n,t){n.uniform1iv(this.addr,t)}function LR(n,t){n.uniform2iv(this.addr,t)}function DR(n,t){n.uniform3iv(this.addr,t)}function NR(n,t){n.uniform4iv(this.addr,t)}function UR(n,t){n.uniform1uiv(this.addr,t)}function FR(n,t){n.uniform2uiv(this.addr,t)}function OR(n,t){n.uniform3uiv(this.addr,t)}function BR(n,t){n.uniform4uiv(this.addr,t)}function kR(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ld(Ey):o=wy;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function zR(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ry,r[o])}function HR(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ld(Ty):o=Cy;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function GR(n,t,e){let i=this.cache,s=t.length,r=Id(e,s);zn(i,r)||(n.uniform1iv(this.addr,r),Hn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Ay,r[o])}function VR(n){switch(n){case 5126:return wR;case 35664:return ER;case 35665:return TR;case 35666:return AR;case 35674:return RR;case 35675:return CR;case 35676:return PR;case 5124:case 35670:return IR;case 35667:case 35671:return LR;case 35668:case 35672:return DR;case 35669:case 35673:return NR;case 5125:return UR;case 36294:return FR;case 36295:return OR;case 36296:return BR;case 35678:case 36198:case 36298:case 36306:case 35682:return kR;case 35679:case 36299:case 36307:return zR;case 35680:case 36300:case 36308:case 36293:return HR;case 36289:case 36303:case 36311:case 36292:return GR}}var km=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=SR(e.type)}},zm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=VR(e.type)}},Hm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Om=/(\w+)(\])?(\[|\.)?/g;function ly(n,t){n.seq.push(t),n.map[t.id]=t}function WR(n,t,e){let i=n.name,s=i.length;for(Om.lastIndex=0;;){let r=Om.exec(i),o=Om.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ly(e,c===void 0?new km(a,n,t):new zm(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Hm(a),ly(e,h)),e=h}}}var Xa=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);WR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function cy(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var qR=37297,$R=0;function XR(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var uy=new ce;function YR(n){Ie._getMatrix(uy,Ie.workingColorSpace,n);let t=`mat3( ${uy.elements.map(e=>e.toFixed(4))} )`;switch(Ie.getTransfer(n)){case tc:return[t,"LinearTransferOETF"];case Ge:return[t,"sRGBTransferOETF"];default:return ne("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function hy(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+XR(n.getShaderSource(t),a)}else return r}function ZR(n,t){let e=YR(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var jR={[am]:"Linear",[lm]:"Reinhard",[cm]:"Cineon",[um]:"ACESFilmic",[dm]:"AgX",[fm]:"Neutral",[hm]:"Custom"};function JR(n,t){let e=jR[t];return e===void 0?(ne("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Rd=new H;function KR(){Ie.getLuminanceCoefficients(Rd);let n=Rd.x.toFixed(4),t=Rd.y.toFixed(4),e=Rd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function QR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Dc).join(`
`)}function tC(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function eC(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Dc(n){return n!==""}function dy(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function fy(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var nC=/^[ \t]*#include +<([\w\d./]+)>/gm;function Gm(n){return n.replace(nC,iC)}function iC(n,t){let e=Me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Gm(e)}var sC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function py(n){return n.replace(sC,rC)}function rC(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function my(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var oC={[wc]:"SHADOWMAP_TYPE_PCF",[Va]:"SHADOWMAP_TYPE_VSM"};function aC(n){return oC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var lC={[qa]:"ENVMAP_MODE_REFRACTION"};function cC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":lC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var uC={[om]:"ENVMAP_BLENDING_MULTIPLY",[D_]:"ENVMAP_BLENDING_MIX",[N_]:"ENVMAP_BLENDING_ADD"};function hC(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":uC[n.combine]||"ENVMAP_BLENDING_NONE"}function dC(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=aC(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=cC(e),h=hC(e),d=QR(e),f=tC(r),m=s.createProgram(),_,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dc).join(`
`),_.length>0&&(_+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Dc).join(`
`),p.length>0&&(p+=`
`)):(_=[my(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Dc).join(`
`),p=[my(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==er?"#define TONE_MAPPING":"",e.toneMapping!==er?Me.tonemapping_pars_fragment:"",e.toneMapping!==er?JR("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Me.colorspace_pars_fragment,ZR("linearToOutputTexel",e.outputColorSpace),KR(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Dc).join(`
`)),o=Gm(o),o=dy(o,e),o=fy(o,e),a=Gm(a),a=dy(a,e),a=fy(a,e),o=py(o),a=py(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,p=["#define varying in",e.glslVersion===Rm?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Rm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=g+_+o,E=g+p+a,b=cy(s,s.VERTEX_SHADER,x),A=cy(s,s.FRAGMENT_SHADER,E);s.attachShader(m,b),s.attachShader(m,A),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function T(L){if(n.debug.checkShaderErrors){let N=s.getProgramInfoLog(m)||"",z=s.getShaderInfoLog(b)||"",G=s.getShaderInfoLog(A)||"",B=N.trim(),X=z.trim(),P=G.trim(),U=!0,Z=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(U=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,b,A);else{let q=hy(s,b,"vertex"),j=hy(s,A,"fragment");re("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+B+`
`+q+`
`+j)}else B!==""?ne("WebGLProgram: Program Info Log:",B):(X===""||P==="")&&(Z=!1);Z&&(L.diagnostics={runnable:U,programLog:B,vertexShader:{log:X,prefix:_},fragmentShader:{log:P,prefix:p}})}s.deleteShader(b),s.deleteShader(A),y=new Xa(s,m),S=eC(s,m)}let y;this.getUniforms=function(){return y===void 0&&T(this),y};let S;this.getAttributes=function(){return S===void 0&&T(this),S};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(m,qR)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=$R++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=A,this}var fC=0,Vm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Wm(t),e.set(t,i)),i}},Wm=class{constructor(t){this.id=fC++,this.code=t,this.usedTimes=0}};function pC(n){return n===ro||n===Pc||n===Ic}function mC(n,t,e,i,s,r){let o=new Fa,a=new Vm,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,S,D,L,N,z){let G=L.fog,B=N.geometry,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,P=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,U=t.get(y.envMap||X,P),Z=d[y.type],q=i.precision;y.precision!==null&&(q=i.getMaxPrecision(y.precision),q!==y.precision&&ne("WebGLProgram.getParameters:",y.precision,"not supported, using",q,"instead."));let j=B.morphAttributes.position||B.morphAttributes.normal||B.morphAttributes.color,et=j!==void 0?j.length:0,dt=0;B.morphAttributes.position!==void 0&&(dt=1),B.morphAttributes.normal!==void 0&&(dt=2),B.morphAttributes.color!==void 0&&(dt=3);let ft,st,vt,_t;if(Z){let Dt=ir[Z];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=y.vertexShader,st=y.fragmentShader;let Dt=a.getVertexShaderStage(y),xe=a.getFragmentShaderStage(y);a.update(y,Dt,xe),vt=Dt.id,_t=xe.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=N.isInstancedMesh===!0,pe=N.isBatchedMesh===!0,Zt=!!y.map,Se=!!y.matcap,ye=!!U,de=ye&&U.isPMREMTexture===!0,fn=!!y.aoMap,sn=!!y.lightMap,Pn=!!y.bumpMap&&y.wireframe===!1,Ze=!!y.normalMap,Xn=!!y.displacementMap,De=!!y.emissiveMap,Bn=!!y.metalnessMap,vn=!!y.roughnessMap,In=y.anisotropy>0,W=y.clearcoat>0,Nt=y.diffuseRoughness>0,ie=y.dispersion>0,me=y.retroreflectivity>0,Ct=y.iridescence>0,Qe=y.sheen>0,Yt=y.transmission>0,Qt=In&&!!y.anisotropyMap,F=W&&!!y.clearcoatMap,R=W&&!!y.clearcoatNormalMap,J=W&&!!y.clearcoatRoughnessMap,mt=Nt&&!!y.diffuseRoughnessMap,ct=Ct&&!!y.iridescenceMap,St=Ct&&!!y.iridescenceThicknessMap,wt=Qe&&!!y.sheenColorMap,rt=Qe&&!!y.sheenRoughnessMap,at=!!y.specularMap,bt=!!y.specularColorMap,V=!!y.specularIntensityMap,lt=Yt&&!!y.transmissionMap,ot=Yt&&!!y.thicknessMap,Pt=!!y.gradientMap,Mt=!!y.alphaMap,Rt=y.alphaTest>0,jt=!!y.alphaHash,oe=!!y.extensions,pt=er;y.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let Wt=de?U.isCompressedCubeTexture?U.image[0].mipmaps:U.mipmaps:null,ae={shaderID:Z,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:st,defines:y.defines,customVertexShaderID:vt,customFragmentShaderID:_t,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:q,batching:pe,batchingColor:pe&&N._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&N.instanceColor!==null,instancingMorph:Jt&&N.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:Ie.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Zt,matcap:Se,envMap:ye,envMapMode:ye&&U.mapping,envMapPMREM:de,envMapMaxLod:de?Wt.length-1:null,envMapSize:de?Wt[0].width:null,aoMap:fn,lightMap:sn,bumpMap:Pn,normalMap:Ze,displacementMap:Xn,emissiveMap:De,normalMapObjectSpace:Ze&&y.normalMapType===O_,normalMapTangentSpace:Ze&&y.normalMapType===bm,packedNormalMap:Ze&&y.normalMapType===bm&&pC(y.normalMap.format),metalnessMap:Bn,roughnessMap:vn,anisotropy:In,anisotropyMap:Qt,clearcoat:W,clearcoatMap:F,clearcoatNormalMap:R,clearcoatRoughnessMap:J,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:ie,retroreflection:me,iridescence:Ct,iridescenceMap:ct,iridescenceThicknessMap:St,sheen:Qe,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:bt,specularIntensityMap:V,transmission:Yt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:y.transparent===!1&&y.blending===Wa&&y.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:jt,combine:y.combine,mapUv:Zt&&f(y.map.channel),aoMapUv:fn&&f(y.aoMap.channel),lightMapUv:sn&&f(y.lightMap.channel),bumpMapUv:Pn&&f(y.bumpMap.channel),normalMapUv:Ze&&f(y.normalMap.channel),displacementMapUv:Xn&&f(y.displacementMap.channel),emissiveMapUv:De&&f(y.emissiveMap.channel),metalnessMapUv:Bn&&f(y.metalnessMap.channel),roughnessMapUv:vn&&f(y.roughnessMap.channel),anisotropyMapUv:Qt&&f(y.anisotropyMap.channel),clearcoatMapUv:F&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:J&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(y.sheenRoughnessMap.channel),specularMapUv:at&&f(y.specularMap.channel),specularColorMapUv:bt&&f(y.specularColorMap.channel),specularIntensityMapUv:V&&f(y.specularIntensityMap.channel),transmissionMapUv:lt&&f(y.transmissionMap.channel),thicknessMapUv:ot&&f(y.thicknessMap.channel),alphaMapUv:Mt&&f(y.alphaMap.channel),vertexTangents:!!B.attributes.tangent&&(Ze||In),vertexNormals:!!B.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!B.attributes.color&&B.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!B.attributes.uv&&(Zt||Mt),fog:!!G,useFog:y.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||B.attributes.normal===void 0&&Ze===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:B.attributes.position!==void 0,morphTargets:B.morphAttributes.position!==void 0,morphNormals:B.morphAttributes.normal!==void 0,morphColors:B.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:z.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:Zt&&y.map.isVideoTexture===!0&&Ie.getTransfer(y.map.colorSpace)===Ge,decodeVideoTextureEmissive:De&&y.emissiveMap.isVideoTexture===!0&&Ie.getTransfer(y.emissiveMap.colorSpace)===Ge,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===hi,flipSided:y.side===Ci,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:oe&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(oe&&y.extensions.multiDraw===!0||pe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return ae.vertexUv1s=l.has(1),ae.vertexUv2s=l.has(2),ae.vertexUv3s=l.has(3),l.clear(),ae}function _(y){let S=[];if(y.shaderID?S.push(y.shaderID):(S.push(y.customVertexShaderID),S.push(y.customFragmentShaderID)),y.defines!==void 0)for(let D in y.defines)S.push(D),S.push(y.defines[D]);return y.isRawShaderMaterial===!1&&(p(S,y),g(S,y),S.push(n.outputColorSpace)),S.push(y.customProgramCacheKey),S.join()}function p(y,S){y.push(S.precision),y.push(S.outputColorSpace),y.push(S.envMapMode),y.push(S.envMapPMREM),y.push(S.envMapMaxLod),y.push(S.envMapSize),y.push(S.mapUv),y.push(S.alphaMapUv),y.push(S.lightMapUv),y.push(S.aoMapUv),y.push(S.bumpMapUv),y.push(S.normalMapUv),y.push(S.displacementMapUv),y.push(S.emissiveMapUv),y.push(S.metalnessMapUv),y.push(S.roughnessMapUv),y.push(S.anisotropyMapUv),y.push(S.clearcoatMapUv),y.push(S.clearcoatNormalMapUv),y.push(S.clearcoatRoughnessMapUv),y.push(S.diffuseRoughnessMapUv),y.push(S.iridescenceMapUv),y.push(S.iridescenceThicknessMapUv),y.push(S.sheenColorMapUv),y.push(S.sheenRoughnessMapUv),y.push(S.specularMapUv),y.push(S.specularColorMapUv),y.push(S.specularIntensityMapUv),y.push(S.transmissionMapUv),y.push(S.thicknessMapUv),y.push(S.combine),y.push(S.fogExp2),y.push(S.sizeAttenuation),y.push(S.morphTargetsCount),y.push(S.numSunLights),y.push(S.numDirLights),y.push(S.numPointLights),y.push(S.numSpotLights),y.push(S.numSpotLightMaps),y.push(S.numHemiLights),y.push(S.numRectAreaLights),y.push(S.numSunLightShadows),y.push(S.numDirLightShadows),y.push(S.numPointLightShadows),y.push(S.numSpotLightShadows),y.push(S.numSpotLightShadowsWithMaps),y.push(S.numLightProbes),y.push(S.numLightProbeGrids),y.push(S.shadowMapType),y.push(S.toneMapping),y.push(S.numClippingPlanes),y.push(S.numClipIntersection),y.push(S.depthPacking)}function g(y,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let S=d[y.type],D;if(S){let L=ir[S];D=j_.clone(L.uniforms)}else D=y.uniforms;return D}function E(y,S){let D=u.get(S);return D!==void 0?++D.usedTimes:(D=new dC(n,S,y,s),c.push(D),u.set(S,D)),D}function b(y){if(--y.usedTimes===0){let S=c.indexOf(y);c[S]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function T(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:x,acquireProgram:E,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:T}}function gC(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function xC(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function gy(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function xy(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,_,p,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:p,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=m,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=p,x.group=g),t++,x}function l(d,f,m,_,p,g,x){x.reversedDepth===!0&&(p=-p);let E=a(d,f,m,_,p,g);m.transmission>0?i.push(E):m.transparent===!0?s.push(E):e.push(E)}function c(d,f,m,_,p,g){let x=a(d,f,m,_,p,g);m.transmission>0?i.unshift(x):m.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||xC),i.length>1&&i.sort(f||gy),s.length>1&&s.sort(f||gy)}function h(){for(let d=t,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function _C(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new xy,n.set(i,[o])):s>=r.length?(o=new xy,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function yC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new H,color:new te};break;case"SpotLight":e={position:new H,direction:new H,color:new te,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new H,color:new te,distance:0,decay:0};break;case"HemisphereLight":e={direction:new H,skyColor:new te,groundColor:new te};break;case"RectAreaLight":e={color:new te,position:new H,halfWidth:new H,halfHeight:new H};break}return n[t.id]=e,e}}}function vC(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var bC=0;function MC(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function SC(n){let t=new yC,e=vC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new H);let s=new H,r=new ge,o=new ge;function a(c){let u=0,h=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,m=0,_=0,p=0,g=0,x=0,E=0,b=0,A=0,T=0,y=0,S=0,D=0,L=0;c.sort(MC);for(let z=0,G=c.length;z<G;z++){let B=c[z],X=B.color,P=B.intensity,U=B.distance,Z=null;if(B.shadow&&B.shadow.map&&(B.shadow.map.texture.format===ro?Z=B.shadow.map.texture:Z=B.shadow.map.depthTexture||B.shadow.map.texture),B.isAmbientLight)u+=X.r*P,h+=X.g*P,d+=X.b*P;else if(B.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(B.sh.coefficients[q],P);L++}else if(B.isSunLight){let q=t.get(B);if(q.color.copy(B.color).multiplyScalar(B.intensity),B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[m]=et,i.sunShadowMap[m]=Z;let dt=j.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[_+ft]=j.getMatrix(ft),i.sunShadowCascade[_+ft]=j._cascadeData[ft];_+=dt,m++}i.sun[f]=q,f++}else if(B.isDirectionalLight){let q=t.get(B);if(q.color.copy(B.color).multiplyScalar(B.intensity),B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.directionalShadow[p]=et,i.directionalShadowMap[p]=Z,i.directionalShadowMatrix[p]=B.shadow.matrix,A++}i.directional[p]=q,p++}else if(B.isSpotLight){let q=t.get(B);q.position.setFromMatrixPosition(B.matrixWorld),q.color.copy(X).multiplyScalar(P),q.distance=U,q.coneCos=Math.cos(B.angle),q.penumbraCos=Math.cos(B.angle*(1-B.penumbra)),q.decay=B.decay,i.spot[x]=q;let j=B.shadow;if(B.map&&(i.spotLightMap[S]=B.map,S++,j.updateMatrices(B),B.castShadow&&D++),i.spotLightMatrix[x]=j.matrix,B.castShadow){let et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=Z,y++}x++}else if(B.isRectAreaLight){let q=t.get(B);q.color.copy(X).multiplyScalar(P),q.halfWidth.set(B.width*.5,0,0),q.halfHeight.set(0,B.height*.5,0),i.rectArea[E]=q,E++}else if(B.isPointLight){let q=t.get(B);if(q.color.copy(B.color).multiplyScalar(B.intensity),q.distance=B.distance,q.decay=B.decay,B.castShadow){let j=B.shadow,et=e.get(B);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=Z,i.pointShadowMatrix[g]=B.shadow.matrix,T++}i.point[g]=q,g++}else if(B.isHemisphereLight){let q=t.get(B);q.skyColor.copy(B.color).multiplyScalar(P),q.groundColor.copy(B.groundColor).multiplyScalar(P),i.hemi[b]=q,b++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ot.LTC_FLOAT_1,i.rectAreaLTC2=Ot.LTC_FLOAT_2):(i.rectAreaLTC1=Ot.LTC_HALF_1,i.rectAreaLTC2=Ot.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let N=i.hash;(N.sunLength!==f||N.directionalLength!==p||N.pointLength!==g||N.spotLength!==x||N.rectAreaLength!==E||N.hemiLength!==b||N.numSunShadows!==m||N.numDirectionalShadows!==A||N.numPointShadows!==T||N.numSpotShadows!==y||N.numSpotMaps!==S||N.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=p,i.spot.length=x,i.rectArea.length=E,i.point.length=g,i.hemi.length=b,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+S-D,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=L,N.sunLength=f,N.directionalLength=p,N.pointLength=g,N.spotLength=x,N.rectAreaLength=E,N.hemiLength=b,N.numSunShadows=m,N.numDirectionalShadows=A,N.numPointShadows=T,N.numSpotShadows=y,N.numSpotMaps=S,N.numLightProbes=L,i.version=bC++)}function l(c,u){let h=0,d=0,f=0,m=0,_=0,p=0,g=u.matrixWorldInverse;for(let x=0,E=c.length;x<E;x++){let b=c[x];if(b.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),h++}else if(b.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(b.isSpotLight){let A=i.spot[m];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),m++}else if(b.isRectAreaLight){let A=i.rectArea[_];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let A=i.hemi[p];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:i}}function _y(n){let t=new SC(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function wC(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new _y(n),t.set(s,[a])):r>=o.length?(a=new _y(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var EC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,TC=`uniform sampler2D shadow_pass;
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
}`,AC=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],RC=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],yy=new ge,Lc=new H,Bm=new H;function CC(n,t,e){let i=new Co,s=new Xt,r=new Xt,o=new yn,a=new Eh,l=new Th,c={},u=e.maxTextureSize,h={[so]:Ci,[Ci]:so,[hi]:hi},d=new Ri({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xt},radius:{value:4}},vertexShader:EC,fragmentShader:TC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new be;m.setAttribute("position",new Oe(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ye(m,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=wc;let g=this.type;this.render=function(T,y,S){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===p_&&(ne("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=wc);let D=n.getRenderTarget(),L=n.getActiveCubeFace(),N=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Do),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let G=g!==this.type;G&&y.traverse(function(B){B.material&&(Array.isArray(B.material)?B.material.forEach(X=>X.needsUpdate=!0):B.material.needsUpdate=!0)});for(let B=0,X=T.length;B<X;B++){let P=T[B],U=P.shadow;if(U===void 0){ne("WebGLShadowMap:",P,"has no shadow.");continue}if(U.autoUpdate===!1&&U.needsUpdate===!1)continue;s.copy(U.mapSize);let Z=U.getFrameExtents();s.multiply(Z),r.copy(U.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Z.x),s.x=r.x*Z.x,U.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Z.y),s.y=r.y*Z.y,U.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(U.camera._reversedDepth=q,U.map===null||G===!0){if(U.map!==null&&(U.map.depthTexture!==null&&(U.map.depthTexture.dispose(),U.map.depthTexture=null),U.map.dispose()),this.type===Va){if(P.isPointLight){ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}U.map=new Ji(s.x,s.y,{format:ro,type:As,minFilter:wi,magFilter:wi,generateMipmaps:!1}),U.map.texture.name=P.name+".shadowMap",U.map.depthTexture=new Tr(s.x,s.y,us),U.map.depthTexture.name=P.name+".shadowMapDepth",U.map.depthTexture.format=Sr,U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Qn,U.map.depthTexture.magFilter=Qn}else P.isPointLight?(U.map=new Nc(s.x),U.map.depthTexture=new pc(s.x,Ts)):(U.map=new Ji(s.x,s.y),U.map.depthTexture=new Tr(s.x,s.y,Ts)),U.map.depthTexture.name=P.name+".shadowMap",U.map.depthTexture.format=Sr,this.type===wc?(U.map.depthTexture.compareFunction=q?Em:wm,U.map.depthTexture.minFilter=wi,U.map.depthTexture.magFilter=wi):(U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=Qn,U.map.depthTexture.magFilter=Qn);U.camera.updateProjectionMatrix()}U.map.isWebGLCubeRenderTarget!==!0&&(U.map.width!==s.x||U.map.height!==s.y)&&U.map.setSize(s.x,s.y);let j=U.map.isWebGLCubeRenderTarget?6:U.getViewportCount();P.isPointLight!==!0&&U.updateMatrices(P,S);let et=(U.camera.layers.mask&4294967294)!==0?U.camera.layers:S.layers;for(let dt=0;dt<j;dt++){let ft=U.getCamera(dt);if(P.isPointLight){let st=U.camera,vt=U.matrix,_t=P.distance||st.far;_t!==st.far&&(st.far=_t,st.updateProjectionMatrix()),Lc.setFromMatrixPosition(P.matrixWorld),st.position.copy(Lc),Bm.copy(st.position),Bm.add(AC[dt]),st.up.copy(RC[dt]),st.lookAt(Bm),st.updateMatrixWorld(),vt.makeTranslation(-Lc.x,-Lc.y,-Lc.z),yy.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),U._frustum.setFromProjectionMatrix(yy,st.coordinateSystem,st.reversedDepth)}if(U.map.isWebGLCubeRenderTarget)n.setRenderTarget(U.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(U.map),n.clear());let st=U.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),z.viewport(o)}i=U.getFrustum(dt),b(y,S,ft,P,et,this.type)}U.isPointLightShadow!==!0&&this.type===Va&&x(U,S),U.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(D,L,N)};function x(T,y){let S=t.update(_);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new Ji(s.x,s.y,{format:ro,type:As}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(y,null,S,d,_,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(y,null,S,f,_,null)}function E(T,y,S,D){let L=null,N=S.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(N!==void 0)L=N;else if(L=S.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let z=L.uuid,G=y.uuid,B=c[z];B===void 0&&(B={},c[z]=B);let X=B[G];X===void 0&&(X=L.clone(),B[G]=X,y.addEventListener("dispose",A)),L=X}if(L.visible=y.visible,L.wireframe=y.wireframe,D===Va?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let z=n.properties.get(L);z.light=S}return L}function b(T,y,S,D,L,N){if(T.visible===!1)return;if(T.layers.test(L)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&N===Va)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,T.matrixWorld);let B=t.update(T),X=T.material;if(Array.isArray(X)){let P=B.groups;for(let U=0,Z=P.length;U<Z;U++){let q=P[U],j=X[q.materialIndex];if(j&&j.visible){let et=E(T,j,D,N);T.onBeforeShadow(n,T,y,S,B,et,q),n.renderBufferDirect(S,null,B,et,T,q),T.onAfterShadow(n,T,y,S,B,et,q)}}}else if(X.visible){let P=E(T,X,D,N);T.onBeforeShadow(n,T,y,S,B,P,null),n.renderBufferDirect(S,null,B,P,T,null),T.onAfterShadow(n,T,y,S,B,P,null)}}let G=T.children;for(let B=0,X=G.length;B<X;B++)b(G[B],y,S,D,L,N)}function A(T){T.target.removeEventListener("dispose",A);for(let S in c){let D=c[S],L=T.target.uuid;L in D&&(D[L].dispose(),delete D[L])}}}function PC(n,t){function e(){let V=!1,lt=new yn,ot=null,Pt=new yn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!V&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){V=Mt},setClear:function(Mt,Rt,jt,oe,pt){pt===!0&&(Mt*=oe,Rt*=oe,jt*=oe),lt.set(Mt,Rt,jt,oe),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,jt,oe),Pt.copy(lt))},reset:function(){V=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let V=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let jt=t.get("EXT_clip_control");Rt?jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.ZERO_TO_ONE_EXT):jt.clipControlEXT(jt.LOWER_LEFT_EXT,jt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let oe=Mt;Mt=null,this.setClear(oe)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!V&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=X_[Rt]),Pt!==Rt){switch(Rt){case ah:n.depthFunc(n.NEVER);break;case lh:n.depthFunc(n.ALWAYS);break;case ch:n.depthFunc(n.LESS);break;case La:n.depthFunc(n.LEQUAL);break;case uh:n.depthFunc(n.EQUAL);break;case hh:n.depthFunc(n.GEQUAL);break;case dh:n.depthFunc(n.GREATER);break;case fh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){V=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){V=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,jt=null,oe=null,pt=null;return{setTest:function(Wt){V||(Wt?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function(Wt){lt!==Wt&&!V&&(n.stencilMask(Wt),lt=Wt)},setFunc:function(Wt,ae,Dt){(ot!==Wt||Pt!==ae||Mt!==Dt)&&(n.stencilFunc(Wt,ae,Dt),ot=Wt,Pt=ae,Mt=Dt)},setOp:function(Wt,ae,Dt){(Rt!==Wt||jt!==ae||oe!==Dt)&&(n.stencilOp(Wt,ae,Dt),Rt=Wt,jt=ae,oe=Dt)},setLocked:function(Wt){V=Wt},setClear:function(Wt){pt!==Wt&&(n.clearStencil(Wt),pt=Wt)},reset:function(){V=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,jt=null,oe=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],_=null,p=!1,g=null,x=null,E=null,b=null,A=null,T=null,y=null,S=new te(0,0,0),D=0,L=!1,N=null,z=null,G=null,B=null,X=null,P=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),U=!1,Z=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(q)[1]),U=Z>=1):q.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),U=Z>=2);let j=null,et={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new yn().fromArray(dt),vt=new yn().fromArray(ft);function _t(V,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(V,Rt),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let jt=0;jt<ot;jt++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+jt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=_t(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=_t(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=_t(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=_t(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(La),Pn(!1),Ze(tm),At(n.CULL_FACE),fn(Do);function At(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Jt(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function pe(V,lt){return d[V]!==lt?(n.bindFramebuffer(V,lt),d[V]=lt,V===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),V===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function Zt(V,lt){let ot=m,Pt=!1;if(V){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=V.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,jt=Mt.length;Rt<jt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function Se(V){return _!==V?(n.useProgram(V),_=V,!0):!1}let ye={[No]:n.FUNC_ADD,[g_]:n.FUNC_SUBTRACT,[x_]:n.FUNC_REVERSE_SUBTRACT};ye[__]=n.MIN,ye[y_]=n.MAX;let de={[v_]:n.ZERO,[b_]:n.ONE,[M_]:n.SRC_COLOR,[sm]:n.SRC_ALPHA,[R_]:n.SRC_ALPHA_SATURATE,[T_]:n.DST_COLOR,[w_]:n.DST_ALPHA,[S_]:n.ONE_MINUS_SRC_COLOR,[rm]:n.ONE_MINUS_SRC_ALPHA,[A_]:n.ONE_MINUS_DST_COLOR,[E_]:n.ONE_MINUS_DST_ALPHA,[C_]:n.CONSTANT_COLOR,[P_]:n.ONE_MINUS_CONSTANT_COLOR,[I_]:n.CONSTANT_ALPHA,[L_]:n.ONE_MINUS_CONSTANT_ALPHA};function fn(V,lt,ot,Pt,Mt,Rt,jt,oe,pt,Wt){if(V===Do){p===!0&&(Jt(n.BLEND),p=!1);return}if(p===!1&&(At(n.BLEND),p=!0),V!==m_){if(V!==g||Wt!==L){if((x!==No||A!==No)&&(n.blendEquation(n.FUNC_ADD),x=No,A=No),Wt)switch(V){case Wa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case em:n.blendFunc(n.ONE,n.ONE);break;case nm:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case im:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:re("WebGLState: Invalid blending: ",V);break}else switch(V){case Wa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case em:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case nm:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case im:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",V);break}E=null,b=null,T=null,y=null,S.set(0,0,0),D=0,g=V,L=Wt}return}Mt=Mt||lt,Rt=Rt||ot,jt=jt||Pt,(lt!==x||Mt!==A)&&(n.blendEquationSeparate(ye[lt],ye[Mt]),x=lt,A=Mt),(ot!==E||Pt!==b||Rt!==T||jt!==y)&&(n.blendFuncSeparate(de[ot],de[Pt],de[Rt],de[jt]),E=ot,b=Pt,T=Rt,y=jt),(oe.equals(S)===!1||pt!==D)&&(n.blendColor(oe.r,oe.g,oe.b,pt),S.copy(oe),D=pt),g=V,L=!1}function sn(V,lt){V.side===hi?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=V.side===Ci;lt&&(ot=!ot),Pn(ot),V.blending===Wa&&V.transparent===!1?fn(Do):fn(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Pt=V.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),De(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Pn(V){N!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),N=V)}function Ze(V){V!==d_?(At(n.CULL_FACE),V!==z&&(V===tm?n.cullFace(n.BACK):V===f_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),z=V}function Xn(V){V!==G&&(U&&n.lineWidth(V),G=V)}function De(V,lt,ot){V?(At(n.POLYGON_OFFSET_FILL),(B!==lt||X!==ot)&&(B=lt,X=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Jt(n.POLYGON_OFFSET_FILL)}function Bn(V){V?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function vn(V){V===void 0&&(V=n.TEXTURE0+P-1),j!==V&&(n.activeTexture(V),j=V)}function In(V,lt,ot){ot===void 0&&(j===null?ot=n.TEXTURE0+P-1:ot=j);let Pt=et[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},et[ot]=Pt),(Pt.type!==V||Pt.texture!==lt)&&(j!==ot&&(n.activeTexture(ot),j=ot),n.bindTexture(V,lt||Tt[V]),Pt.type=V,Pt.texture=lt)}function W(){let V=et[j];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(V){re("WebGLState:",V)}}function ie(){try{n.compressedTexImage3D(...arguments)}catch(V){re("WebGLState:",V)}}function me(){try{n.texSubImage2D(...arguments)}catch(V){re("WebGLState:",V)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(V){re("WebGLState:",V)}}function Qe(){try{n.compressedTexSubImage2D(...arguments)}catch(V){re("WebGLState:",V)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(V){re("WebGLState:",V)}}function Qt(){try{n.texStorage2D(...arguments)}catch(V){re("WebGLState:",V)}}function F(){try{n.texStorage3D(...arguments)}catch(V){re("WebGLState:",V)}}function R(){try{n.texImage2D(...arguments)}catch(V){re("WebGLState:",V)}}function J(){try{n.texImage3D(...arguments)}catch(V){re("WebGLState:",V)}}function mt(V){return h[V]!==void 0?h[V]:n.getParameter(V)}function ct(V,lt){h[V]!==lt&&(n.pixelStorei(V,lt),h[V]=lt)}function St(V){st.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),st.copy(V))}function wt(V){vt.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),vt.copy(V))}function rt(V,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Pt=ot.get(V);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,V.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(V,Pt))}function at(V,lt,ot){let Mt=c.get(lt).get(V);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function bt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,et={},d={},l={},f=new WeakMap,m=[],_=null,p=!1,g=null,x=null,E=null,b=null,A=null,T=null,y=null,S=new te(0,0,0),D=0,L=!1,N=null,z=null,G=null,B=null,X=null,st.set(0,0,n.canvas.width,n.canvas.height),vt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:pe,drawBuffers:Zt,useProgram:Se,setBlending:fn,setMaterial:sn,setFlipSided:Pn,setCullFace:Ze,setLineWidth:Xn,setPolygonOffset:De,setScissorTest:Bn,activeTexture:vn,bindTexture:In,unbindTexture:W,compressedTexImage2D:Nt,compressedTexImage3D:ie,texImage2D:R,texImage3D:J,pixelStorei:ct,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:Qt,texStorage3D:F,texSubImage2D:me,texSubImage3D:Ct,compressedTexSubImage2D:Qe,compressedTexSubImage3D:Yt,scissor:St,viewport:wt,reset:bt}}function IC(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xt,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,_=new FinalizationRegistry(F=>m.delete(F)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(F,R){return p?new OffscreenCanvas(F,R):nc("canvas")}function x(F,R,J){let mt=1,ct=Qt(F);if((ct.width>J||ct.height>J)&&(mt=J/Math.max(ct.width,ct.height)),mt<1)if(typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&F instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&F instanceof ImageBitmap||typeof VideoFrame<"u"&&F instanceof VideoFrame){let St=Math.floor(mt*ct.width),wt=Math.floor(mt*ct.height);d===void 0&&(d=g(St,wt));let rt=R?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(F,0,0,St,wt),ne("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+St+"x"+wt+")."),rt}else return"data"in F&&ne("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),F;return F}function E(F){return F.generateMipmaps}function b(F){n.generateMipmap(F)}function A(F){return F.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:F.isWebGL3DRenderTarget?n.TEXTURE_3D:F.isWebGLArrayRenderTarget||F.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(F,R,J,mt,ct,St=!1){if(F!==null){if(n[F]!==void 0)return n[F];ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+F+"'")}let wt;mt&&(wt=t.get("EXT_texture_norm16"),wt||ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=R;if(R===n.RED&&(J===n.FLOAT&&(rt=n.R32F),J===n.HALF_FLOAT&&(rt=n.R16F),J===n.UNSIGNED_BYTE&&(rt=n.R8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),J===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.R8UI),J===n.UNSIGNED_SHORT&&(rt=n.R16UI),J===n.UNSIGNED_INT&&(rt=n.R32UI),J===n.BYTE&&(rt=n.R8I),J===n.SHORT&&(rt=n.R16I),J===n.INT&&(rt=n.R32I)),R===n.RG&&(J===n.FLOAT&&(rt=n.RG32F),J===n.HALF_FLOAT&&(rt=n.RG16F),J===n.UNSIGNED_BYTE&&(rt=n.RG8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),J===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RG8UI),J===n.UNSIGNED_SHORT&&(rt=n.RG16UI),J===n.UNSIGNED_INT&&(rt=n.RG32UI),J===n.BYTE&&(rt=n.RG8I),J===n.SHORT&&(rt=n.RG16I),J===n.INT&&(rt=n.RG32I)),R===n.RGB_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),J===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),J===n.UNSIGNED_INT&&(rt=n.RGB32UI),J===n.BYTE&&(rt=n.RGB8I),J===n.SHORT&&(rt=n.RGB16I),J===n.INT&&(rt=n.RGB32I)),R===n.RGBA_INTEGER&&(J===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),J===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),J===n.UNSIGNED_INT&&(rt=n.RGBA32UI),J===n.BYTE&&(rt=n.RGBA8I),J===n.SHORT&&(rt=n.RGBA16I),J===n.INT&&(rt=n.RGBA32I)),R===n.RGB&&(J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),J===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),J===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),J===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),R===n.RGBA){let at=St?tc:Ie.getTransfer(ct);J===n.FLOAT&&(rt=n.RGBA32F),J===n.HALF_FLOAT&&(rt=n.RGBA16F),J===n.UNSIGNED_BYTE&&(rt=at===Ge?n.SRGB8_ALPHA8:n.RGBA8),J===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),J===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),J===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),J===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function y(F,R){let J;return F?R===null||R===Ts||R===Fo?J=n.DEPTH24_STENCIL8:R===us?J=n.DEPTH32F_STENCIL8:R===$a&&(J=n.DEPTH24_STENCIL8,ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Ts||R===Fo?J=n.DEPTH_COMPONENT24:R===us?J=n.DEPTH_COMPONENT32F:R===$a&&(J=n.DEPTH_COMPONENT16),J}function S(F,R){return E(F)===!0||F.isFramebufferTexture&&F.minFilter!==Qn&&F.minFilter!==wi?Math.log2(Math.max(R.width,R.height))+1:F.mipmaps.length>0?F.mipmaps.length:F.isCompressedTexture&&Array.isArray(F.image)?R.mipmaps.length:1}function D(F){let R=new WeakRef(F);i.get(F).__ref=R,m.add(R),_.register(F,R,R)}function L(F){let R=i.get(F).__ref;R!==void 0&&(m.delete(R),_.unregister(R))}function N(F){G(F.target)}function z(F){B(F.target)}function G(F){F.removeEventListener("dispose",N),L(F),P(F),F.isVideoTexture&&u.delete(F),F.isHTMLTexture&&h.delete(F)}function B(F){F.removeEventListener("dispose",z),L(F),Z(F)}function X(){for(let F of m){let R=F.deref();R!==void 0&&(R.isRenderTarget===!0?B(R):G(R))}m.clear(),h.clear()}function P(F){let R=i.get(F);if(R.__webglInit===void 0)return;let J=F.source,mt=f.get(J);if(mt){let ct=mt[R.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&U(F),Object.keys(mt).length===0&&f.delete(J)}i.remove(F)}function U(F){let R=i.get(F);n.deleteTexture(R.__webglTexture);let J=F.source,mt=f.get(J);delete mt[R.__cacheKey],o.memory.textures--}function Z(F){let R=i.get(F);R.__depthDisposeCallback&&R.__depthDisposeCallback();let J=F.depthTexture;if(J&&J.renderTarget===F&&G(J),F.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(R.__webglFramebuffer[ct]))for(let St=0;St<R.__webglFramebuffer[ct].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[ct][St]);else n.deleteFramebuffer(R.__webglFramebuffer[ct]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ct])}else{if(Array.isArray(R.__webglFramebuffer))for(let ct=0;ct<R.__webglFramebuffer.length;ct++)n.deleteFramebuffer(R.__webglFramebuffer[ct]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ct=0;ct<R.__webglColorRenderbuffer.length;ct++)R.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ct]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let mt=F.textures;for(let ct=0,St=mt.length;ct<St;ct++){let wt=i.get(mt[ct]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(mt[ct])}i.remove(F)}let q=0;function j(){q=0}function et(){return q}function dt(F){q=F}function ft(){let F=q;return F>=s.maxTextures&&ne("WebGLTextures: Trying to use "+(F+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,F}function st(F){let R=[];return R.push(F.wrapS),R.push(F.wrapT),R.push(F.wrapR||0),R.push(F.magFilter),R.push(F.minFilter),R.push(F.anisotropy),R.push(F.internalFormat),R.push(F.format),R.push(F.type),R.push(F.generateMipmaps),R.push(F.mipmapsAutoUpdate),R.push(F.premultiplyAlpha),R.push(F.flipY),R.push(F.unpackAlignment),R.push(F.colorSpace),R.join()}function vt(F,R){let J=i.get(F);if(F.isVideoTexture&&Qe(F),F.isRenderTargetTexture===!1&&F.isExternalTexture!==!0&&F.version>0&&J.__version!==F.version){let mt=F.image;if(mt===null)ne("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ne("WebGLRenderer: Texture marked for update but image is incomplete");else{sn(J,F,R);return}}else F.isExternalTexture&&(J.__webglTexture=F.sourceTexture?F.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,J.__webglTexture,n.TEXTURE0+R)}function _t(F,R){let J=i.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&J.__version!==F.version){sn(J,F,R);return}else F.isExternalTexture&&(J.__webglTexture=F.sourceTexture?F.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,J.__webglTexture,n.TEXTURE0+R)}function Tt(F,R){let J=i.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&J.__version!==F.version){sn(J,F,R);return}e.bindTexture(n.TEXTURE_3D,J.__webglTexture,n.TEXTURE0+R)}function At(F,R){let J=i.get(F);if(F.version>0&&J.__version!==F.version){Pn(J,F,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture,n.TEXTURE0+R)}let Jt={[ph]:n.REPEAT,[js]:n.CLAMP_TO_EDGE,[mh]:n.MIRRORED_REPEAT},pe={[Qn]:n.NEAREST,[U_]:n.NEAREST_MIPMAP_NEAREST,[Ec]:n.NEAREST_MIPMAP_LINEAR,[wi]:n.LINEAR,[Hh]:n.LINEAR_MIPMAP_NEAREST,[Ar]:n.LINEAR_MIPMAP_LINEAR},Zt={[k_]:n.NEVER,[Tm]:n.ALWAYS,[z_]:n.LESS,[wm]:n.LEQUAL,[H_]:n.EQUAL,[Em]:n.GEQUAL,[G_]:n.GREATER,[V_]:n.NOTEQUAL};function Se(F,R){if(R.type===us&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===wi||R.magFilter===Hh||R.magFilter===Ec||R.magFilter===Ar||R.minFilter===wi||R.minFilter===Hh||R.minFilter===Ec||R.minFilter===Ar)&&ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(F,n.TEXTURE_WRAP_S,Jt[R.wrapS]),n.texParameteri(F,n.TEXTURE_WRAP_T,Jt[R.wrapT]),(F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY)&&n.texParameteri(F,n.TEXTURE_WRAP_R,Jt[R.wrapR]),n.texParameteri(F,n.TEXTURE_MAG_FILTER,pe[R.magFilter]),n.texParameteri(F,n.TEXTURE_MIN_FILTER,pe[R.minFilter]),R.compareFunction&&(n.texParameteri(F,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(F,n.TEXTURE_COMPARE_FUNC,Zt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Qn||R.minFilter!==Ec&&R.minFilter!==Ar||R.type===us&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let J=t.get("EXT_texture_filter_anisotropic");n.texParameterf(F,J.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ye(F,R){let J=!1;F.__webglInit===void 0&&(F.__webglInit=!0,R.addEventListener("dispose",N),D(R));let mt=R.source,ct=f.get(mt);ct===void 0&&(ct={},f.set(mt,ct));let St=st(R);if(St!==F.__cacheKey){ct[St]===void 0&&(ct[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,J=!0),ct[St].usedTimes++;let wt=ct[F.__cacheKey];wt!==void 0&&(ct[F.__cacheKey].usedTimes--,wt.usedTimes===0&&U(R)),F.__cacheKey=St,F.__webglTexture=ct[St].texture}return J}function de(F,R,J){return Math.floor(Math.floor(F/J)/R)}function fn(F,R,J,mt){let St=F.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,J,mt,R.data);else{St.sort((V,lt)=>V.start-lt.start);let wt=0;for(let V=1;V<St.length;V++){let lt=St[wt],ot=St[V],Pt=lt.start+lt.count,Mt=de(ot.start,R.width,4),Rt=de(lt.start,R.width,4);ot.start<=Pt+1&&Mt===Rt&&de(ot.start+ot.count-1,R.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),bt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let V=0,lt=St.length;V<lt;V++){let ot=St[V],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%R.width,jt=Math.floor(Pt/R.width),oe=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,jt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,jt,oe,pt,J,mt,R.data)}F.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,bt)}}function sn(F,R,J){let mt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(mt=n.TEXTURE_3D);let ct=ye(F,R),St=R.source;e.bindTexture(mt,F.__webglTexture,n.TEXTURE0+J);let wt=i.get(St);if(St.version!==wt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+J),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let pt=Ie.getPrimaries(Ie.workingColorSpace),Wt=R.colorSpace===Cr?null:Ie.getPrimaries(R.colorSpace),ae=R.colorSpace===Cr||pt===Wt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let at=x(R.image,!1,s.maxTextureSize);at=Yt(R,at);let bt=r.convert(R.format,R.colorSpace),V=r.convert(R.type),lt=T(R.internalFormat,bt,V,R.normalized,R.colorSpace,R.isVideoTexture);Se(mt,R);let ot,Pt=R.mipmaps,Mt=R.isVideoTexture!==!0,Rt=wt.__version===void 0||ct===!0,jt=St.dataReady,oe=S(R,at);if(R.isDepthTexture)lt=y(R.format===Rr,R.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,bt,V,null));else if(R.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,bt,V,ot.data);R.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height),jt&&fn(R,at,bt,V)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,bt,V,at.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)if(ot=Pt[pt],R.format!==Rs)if(bt!==null)if(Mt){if(jt)if(R.layerUpdates.size>0){let ae=Fm(ot.width,ot.height,R.format,R.type);for(let Dt of R.layerUpdates){let xe=ot.data.subarray(Dt*ae/ot.data.BYTES_PER_ELEMENT,(Dt+1)*ae/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,bt,xe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,bt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?jt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,bt,V,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,bt,V,ot.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,oe,lt,Pt[0].width,Pt[0].height);for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],R.format!==Rs?bt!==null?Mt?jt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,bt,V,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,bt,V,ot.data)}else if(R.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,lt,at.width,at.height,at.depth),jt)if(R.layerUpdates.size>0){let pt=Fm(at.width,at.height,R.format,R.type);for(let Wt of R.layerUpdates){let ae=at.data.subarray(Wt*pt/at.data.BYTES_PER_ELEMENT,(Wt+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Wt,at.width,at.height,1,bt,V,ae)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,bt,V,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,bt,V,at.data);else if(R.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,oe,lt,at.width,at.height,at.depth),jt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,bt,V,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,bt,V,at.data);else if(R.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,oe,lt,at.width,at.height);else{let pt=at.width,Wt=at.height;for(let ae=0;ae<oe;ae++)e.texImage2D(n.TEXTURE_2D,ae,lt,pt,Wt,0,bt,V,null),pt>>=1,Wt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(R),pt.onpaint=Wt=>{let ae=Wt.changedElements;for(let Dt of h)ae.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ae=n.RGBA,Dt=n.RGBA,xe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ae,Dt,xe,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=Qt(Pt[0]);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}for(let pt=0,Wt=Pt.length;pt<Wt;pt++)ot=Pt[pt],Mt?jt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,bt,V,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,bt,V,ot);R.generateMipmaps=!1}else if(Mt){if(Rt){let pt=Qt(at);e.texStorage2D(n.TEXTURE_2D,oe,lt,pt.width,pt.height)}jt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,bt,V,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,bt,V,at);E(R)&&R.mipmapsAutoUpdate===!0&&b(mt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}F.__version=R.version}function Pn(F,R,J){if(R.image.length!==6)return;let mt=ye(F,R),ct=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,F.__webglTexture,n.TEXTURE0+J);let St=i.get(ct);if(ct.version!==St.__version||mt===!0){e.activeTexture(n.TEXTURE0+J);let wt=Ie.getPrimaries(Ie.workingColorSpace),rt=R.colorSpace===Cr?null:Ie.getPrimaries(R.colorSpace),at=R.colorSpace===Cr||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let bt=R.isCompressedTexture||R.image[0].isCompressedTexture,V=R.image[0]&&R.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!bt&&!V?lt[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):lt[Dt]=V?R.image[Dt].image:R.image[Dt],lt[Dt]=Yt(R,lt[Dt]);let ot=lt[0],Pt=r.convert(R.format,R.colorSpace),Mt=r.convert(R.type),Rt=T(R.internalFormat,Pt,Mt,R.normalized,R.colorSpace),jt=R.isVideoTexture!==!0,oe=St.__version===void 0||mt===!0,pt=ct.dataReady,Wt=S(R,ot);Se(n.TEXTURE_CUBE_MAP,R);let ae;if(R.isDepthTexture){if(Rt=y(R.format===Rr,R.type),oe)if(jt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(bt){jt&&oe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){ae=lt[Dt].mipmaps;for(let xe=0;xe<ae.length;xe++){let rn=ae[xe];R.format!==Rs?Pt!==null?jt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,0,0,rn.width,rn.height,Pt,rn.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,Rt,rn.width,rn.height,0,rn.data):ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,0,0,rn.width,rn.height,Pt,Mt,rn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe,Rt,rn.width,rn.height,0,Pt,Mt,rn.data)}}}else{if(ae=R.mipmaps,jt&&oe){ae.length>0&&Wt++;let Dt=Qt(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Wt,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(V){jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let xe=0;xe<ae.length;xe++){let mi=ae[xe].image[Dt].image;jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,0,0,mi.width,mi.height,Pt,Mt,mi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,Rt,mi.width,mi.height,0,Pt,Mt,mi.data)}}else{jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let xe=0;xe<ae.length;xe++){let rn=ae[xe];jt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,0,0,Pt,Mt,rn.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,xe+1,Rt,Pt,Mt,rn.image[Dt])}}}E(R)&&R.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),St.__version=ct.version,R.onUpdate&&R.onUpdate(R)}F.__version=R.version}function Ze(F,R,J,mt,ct,St){let wt=r.convert(J.format,J.colorSpace),rt=r.convert(J.type),at=T(J.internalFormat,wt,rt,J.normalized,J.colorSpace),bt=i.get(R),V=i.get(J);if(V.__renderTarget=R,!bt.__hasExternalTextures){let lt=Math.max(1,R.width>>St),ot=Math.max(1,R.height>>St);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,St,at,lt,ot,R.depth,0,wt,rt,null):e.texImage2D(ct,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,F),Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ct,V.__webglTexture,0,me(R)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ct,V.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Xn(F,R,J){if(n.bindRenderbuffer(n.RENDERBUFFER,F),R.depthBuffer){let mt=R.depthTexture,ct=mt&&mt.isDepthTexture?mt.type:null,St=y(R.stencilBuffer,ct),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),St,R.width,R.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,F)}else{let mt=R.textures;for(let ct=0;ct<mt.length;ct++){let St=mt[ct],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=T(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,me(R),at,R.width,R.height):J?n.renderbufferStorageMultisample(n.RENDERBUFFER,me(R),at,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,at,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function De(F,R,J){let mt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,F),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(R.depthTexture);ct.__renderTarget=R;let St=mt?R.depthTexture.image[0]:R.depthTexture.image;(!ct.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),mt?At(R.depthTexture,0):vt(R.depthTexture,0);let wt=ct.__webglTexture,rt=me(R),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+J:n.TEXTURE_2D,bt=R.depthTexture.format===Rr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===Sr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,bt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,bt,at,wt,0);else if(R.depthTexture.format===Rr)Ct(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,bt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,bt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bn(F){let R=i.get(F),J=F.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==F.depthTexture){let mt=F.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),mt){let ct=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,mt.removeEventListener("dispose",ct)};mt.addEventListener("dispose",ct),R.__depthDisposeCallback=ct}R.__boundDepthTexture=mt}if(F.depthTexture&&!R.__autoAllocateDepthBuffer)if(J)for(let mt=0;mt<6;mt++)De(R.__webglFramebuffer[mt],F,mt);else F.texture.mipmaps.length>0?De(R.__webglFramebuffer[0],F,0):De(R.__webglFramebuffer,F,0);else if(J){R.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[mt]),R.__webglDepthbuffer[mt]===void 0)R.__webglDepthbuffer[mt]=n.createRenderbuffer(),Xn(R.__webglDepthbuffer[mt],F,!1);else{let ct=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}}else if(F.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),Xn(R.__webglDepthbuffer,F,!1);else{let ct=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function vn(F,R,J){let mt=i.get(F);R!==void 0&&Ze(mt.__webglFramebuffer,F,F.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),J!==void 0&&Bn(F)}function In(F){let R=F.texture,J=i.get(F),mt=i.get(R);F.addEventListener("dispose",z),D(F);let ct=F.textures,St=F.isWebGLCubeRenderTarget===!0,wt=ct.length>1;if(wt||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=R.version,o.memory.textures++),St){J.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0){J.__webglFramebuffer[rt]=[];for(let at=0;at<R.mipmaps.length;at++)J.__webglFramebuffer[rt][at]=n.createFramebuffer()}else J.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){J.__webglFramebuffer=[];for(let rt=0;rt<R.mipmaps.length;rt++)J.__webglFramebuffer[rt]=n.createFramebuffer()}else J.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ct.length;rt<at;rt++){let bt=i.get(ct[rt]);bt.__webglTexture===void 0&&(bt.__webglTexture=n.createTexture(),o.memory.textures++)}if(F.samples>0&&Ct(F)===!1){J.__webglMultisampledFramebuffer=n.createFramebuffer(),J.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,J.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];J.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,J.__webglColorRenderbuffer[rt]);let bt=r.convert(at.format,at.colorSpace),V=r.convert(at.type),lt=T(at.internalFormat,bt,V,at.normalized,at.colorSpace,F.isXRRenderTarget===!0),ot=me(F);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,F.width,F.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,J.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),F.depthBuffer&&(J.__webglDepthRenderbuffer=n.createRenderbuffer(),Xn(J.__webglDepthRenderbuffer,F,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),Se(n.TEXTURE_CUBE_MAP,R);for(let rt=0;rt<6;rt++)if(R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Ze(J.__webglFramebuffer[rt][at],F,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Ze(J.__webglFramebuffer[rt],F,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);E(R)?b(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ct.length;rt<at;rt++){let bt=ct[rt],V=i.get(bt),lt=n.TEXTURE_2D;(F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(lt=F.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,V.__webglTexture),Se(lt,bt),Ze(J.__webglFramebuffer,F,bt,n.COLOR_ATTACHMENT0+rt,lt,0),E(bt)&&b(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(rt=F.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),Se(rt,R),R.mipmaps.length>0)for(let at=0;at<R.mipmaps.length;at++)Ze(J.__webglFramebuffer[at],F,R,n.COLOR_ATTACHMENT0,rt,at);else Ze(J.__webglFramebuffer,F,R,n.COLOR_ATTACHMENT0,rt,0);E(R)?b(rt):R.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}F.depthBuffer&&Bn(F)}function W(F){let R=F.textures;for(let J=0,mt=R.length;J<mt;J++){let ct=R[J];if(E(ct)&&ct.mipmapsAutoUpdate===!0){let St=A(F),wt=i.get(ct).__webglTexture;e.bindTexture(St,wt),b(St),e.unbindTexture()}}}let Nt=[];function ie(F){if(F.samples>0){if(Ct(F)===!1){let R=F.textures,J=F.width,mt=F.height,ct=n.COLOR_BUFFER_BIT,St=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(F),rt=R.length>1;if(rt)for(let bt=0;bt<R.length;bt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),F.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let bt=0;bt<R.length;bt++){if(F.resolveDepthBuffer&&(F.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),F.stencilBuffer&&F.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let V=i.get(R[bt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,J,mt,0,0,J,mt,ct,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+bt),F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let bt=0;bt<R.length;bt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[bt]);let V=i.get(R[bt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+bt,n.TEXTURE_2D,V,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&l){let R=F.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function me(F){return Math.min(s.maxSamples,F.samples)}function Ct(F){let R=i.get(F);return F.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Qe(F){let R=o.render.frame;u.get(F)!==R&&(u.set(F,R),F.update())}function Yt(F,R){let J=F.colorSpace,mt=F.format,ct=F.type;return F.isCompressedTexture===!0||F.isVideoTexture===!0||J!==Ql&&J!==Cr&&(Ie.getTransfer(J)===Ge?(mt!==Rs||ct!==ts)&&ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",J)),R}function Qt(F){return typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement?(c.width=F.naturalWidth||F.width,c.height=F.naturalHeight||F.height):typeof VideoFrame<"u"&&F instanceof VideoFrame?(c.width=F.displayWidth,c.height=F.displayHeight):(c.width=F.width,c.height=F.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=vt,this.setTexture2DArray=_t,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=vn,this.setupRenderTarget=In,this.updateRenderTargetMipmap=W,this.updateMultisampleRenderTarget=ie,this.setupDepthRenderbuffer=Bn,this.setupFrameBufferTexture=Ze,this.useMultisampledRTT=Ct,this.dispose=X}function LC(n,t){function e(i,s=Cr){let r,o=Ie.getTransfer(s);if(i===ts)return n.UNSIGNED_BYTE;if(i===Vh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Wh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===xm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===_m)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===mm)return n.BYTE;if(i===gm)return n.SHORT;if(i===$a)return n.UNSIGNED_SHORT;if(i===Gh)return n.INT;if(i===Ts)return n.UNSIGNED_INT;if(i===us)return n.FLOAT;if(i===As)return n.HALF_FLOAT;if(i===ym)return n.ALPHA;if(i===vm)return n.RGB;if(i===Rs)return n.RGBA;if(i===Sr)return n.DEPTH_COMPONENT;if(i===Rr)return n.DEPTH_STENCIL;if(i===qh)return n.RED;if(i===$h)return n.RED_INTEGER;if(i===ro)return n.RG;if(i===Xh)return n.RG_INTEGER;if(i===Yh)return n.RGBA_INTEGER;if(i===Tc||i===Ac||i===Rc||i===Cc)if(o===Ge)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Tc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ac)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Rc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Cc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Tc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ac)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Rc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Cc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zh||i===jh||i===Jh||i===Kh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===jh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Jh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Kh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qh||i===td||i===ed||i===nd||i===id||i===Pc||i===sd)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Qh||i===td)return o===Ge?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ed)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===nd)return r.COMPRESSED_R11_EAC;if(i===id)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Pc)return r.COMPRESSED_RG11_EAC;if(i===sd)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===rd||i===od||i===ad||i===ld||i===cd||i===ud||i===hd||i===dd||i===fd||i===pd||i===md||i===gd||i===xd||i===_d)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===rd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===od)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ad)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ld)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===cd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ud)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===hd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===dd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===pd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===md)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===gd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===xd)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===_d)return o===Ge?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===yd||i===vd||i===bd)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===yd)return o===Ge?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vd)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===bd)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Md||i===Sd||i===Ic||i===wd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Md)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Sd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ic)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===wd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var DC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,NC=`
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

}`,qm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new mc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ri({vertexShader:DC,fragmentShader:NC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ye(new yc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},$m=class extends ws{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,_=typeof XRWebGLBinding<"u",p=new qm,g={},x=e.getContextAttributes(),E=null,b=null,A=[],T=[],y=new Xt,S=null,D=null,L=new Si;L.viewport=new yn;let N=new Si;N.viewport=new yn;let z=[L,N],G=new Bh,B=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let vt=A[st];return vt===void 0&&(vt=new Oa,A[st]=vt),vt.getTargetRaySpace()},this.getControllerGrip=function(st){let vt=A[st];return vt===void 0&&(vt=new Oa,A[st]=vt),vt.getGripSpace()},this.getHand=function(st){let vt=A[st];return vt===void 0&&(vt=new Oa,A[st]=vt),vt.getHandSpace()};function P(st){let vt=T.indexOf(st.inputSource);if(vt===-1)return;let _t=A[vt];_t!==void 0&&(_t.update(st.inputSource,st.frame,c||o),_t.dispatchEvent({type:st.type,data:st.inputSource}))}function U(){s.removeEventListener("select",P),s.removeEventListener("selectstart",P),s.removeEventListener("selectend",P),s.removeEventListener("squeeze",P),s.removeEventListener("squeezestart",P),s.removeEventListener("squeezeend",P),s.removeEventListener("end",U),s.removeEventListener("inputsourceschange",Z);for(let st=0;st<A.length;st++){let vt=T[st];vt!==null&&(T[st]=null,A[st].disconnect(vt))}B=null,X=null,p.reset();for(let st in g)delete g[st];if(t.setRenderTarget(E),f=null,d=null,h=null,s=null,b=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(y.width,y.height,!1),D!==null){let st=D.camera;st.fov=D.fov,st.zoom=D.zoom,st.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",P),s.addEventListener("selectstart",P),s.addEventListener("selectend",P),s.addEventListener("squeeze",P),s.addEventListener("squeezestart",P),s.addEventListener("squeezeend",P),s.addEventListener("end",U),s.addEventListener("inputsourceschange",Z),x.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=x.stencil?Rr:Sr,Tt=x.stencil?Fo:Ts);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new Ji(d.textureWidth,d.textureHeight,{format:Rs,type:ts,depthTexture:new Tr(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _t={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Ji(f.framebufferWidth,f.framebufferHeight,{format:Rs,type:ts,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function Z(st){for(let vt=0;vt<st.removed.length;vt++){let _t=st.removed[vt],Tt=T.indexOf(_t);Tt>=0&&(T[Tt]=null,A[Tt].disconnect(_t))}for(let vt=0;vt<st.added.length;vt++){let _t=st.added[vt],Tt=T.indexOf(_t);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=T.length){T.push(_t),Tt=Jt;break}else if(T[Jt]===null){T[Jt]=_t,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(_t)}}function q(st,vt){vt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(vt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let vt=st.near,_t=st.far;p.texture!==null&&(p.depthNear>0&&(vt=p.depthNear),p.depthFar>0&&(_t=p.depthFar)),G.near=N.near=L.near=vt,G.far=N.far=L.far=_t,(B!==G.near||X!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),B=G.near,X=G.far),G.layers.mask=st.layers.mask|6,L.layers.mask=G.layers.mask&-5,N.layers.mask=G.layers.mask&-3;let Tt=st.parent,At=G.cameras;q(G,Tt);for(let Jt=0;Jt<At.length;Jt++)q(At[Jt],Tt);G.projectionMatrix.copy(L.projectionMatrix),G.projectionMatrixInverse.copy(L.projectionMatrixInverse),D===null&&st.isPerspectiveCamera&&(D={camera:st,fov:st.fov,zoom:st.zoom}),j(st,G,Tt)};function j(st,vt,_t){_t===null?st.matrix.copy(vt.matrixWorld):(st.matrix.copy(_t.matrixWorld),st.matrix.invert(),st.matrix.multiply(vt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(vt.projectionMatrix),st.projectionMatrixInverse.copy(vt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Na*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(st){return g[st]};let et=null;function dt(st,vt){if(u=vt.getViewerPose(c||o),m=vt,u!==null){let _t=u.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Tt=!1;_t.length!==G.cameras.length&&(G.cameras.length=0,Tt=!0);for(let Zt=0;Zt<_t.length;Zt++){let Se=_t[Zt],ye=null;if(f!==null)ye=f.getViewport(Se);else{let fn=h.getViewSubImage(d,Se);ye=fn.viewport,Zt===0&&(t.setRenderTargetTextures(b,fn.colorTexture,fn.depthStencilTexture),t.setRenderTarget(b))}let de=z[Zt];de===void 0&&(de=new Si,de.layers.enable(Zt),de.viewport=new yn,z[Zt]=de),de.matrix.fromArray(Se.transform.matrix),de.matrix.decompose(de.position,de.quaternion,de.scale),de.projectionMatrix.fromArray(Se.projectionMatrix),de.projectionMatrixInverse.copy(de.projectionMatrix).invert(),de.viewport.set(ye.x,ye.y,ye.width,ye.height),Zt===0&&(G.matrix.copy(de.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Tt===!0&&G.cameras.push(de)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let Zt=h.getDepthInformation(_t[0]);Zt&&Zt.isValid&&Zt.texture&&p.init(Zt,s.renderState)}if(At&&At.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let Zt=0;Zt<_t.length;Zt++){let Se=_t[Zt].camera;if(Se){let ye=g[Se];ye||(ye=new mc,g[Se]=ye);let de=h.getCameraImage(Se);ye.sourceTexture=de}}}}for(let _t=0;_t<A.length;_t++){let Tt=T[_t],At=A[_t];Tt!==null&&At!==void 0&&At.update(Tt,vt,c||o)}et&&et(st,vt),vt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:vt}),m=null}let ft=new vy;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){et=st},this.dispose=function(){}}},UC=new ge,Py=new ce;Py.set(-1,0,0,0,1,0,0,0,1);function FC(n,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,Dm(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,x,E,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),h(p,g)):g.isMeshPhongMaterial?(r(p,g),u(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),d(p,g),g.isMeshPhysicalMaterial&&f(p,g,b)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),_(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,x,E):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===Ci&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===Ci&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let x=t.get(g),E=x.envMap,b=x.envMapRotation;E&&(p.envMap.value=E,p.envMapRotation.value.setFromMatrix4(UC.makeRotationFromEuler(b)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Py),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,x,E){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*x,p.scale.value=E*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function u(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function h(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function d(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,x){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Ci&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function _(p,g){let x=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function OC(n,t,e,i){let s={},r={};function o(x,E){let b=E.program;i.uniformBlockBinding(x,b,s[x.id])}function a(x,E){let b=s[x.id];b===void 0&&(m(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",p));let A=E.program;i.updateUBOMapping(x,A);let T=t.render.frame;r[x.id]!==T&&(c(x),r[x.id]=T)}function l(x){let E=n.createBuffer(),b=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,b,A),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(x){let E=s[x.id],b=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let T=0,y=b.length;T<y;T++){let S=b[T];if(Array.isArray(S))for(let D=0,L=S.length;D<L;D++)u(S[D],T,D,A);else u(S,T,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,E,b,A){if(d(x,E,b,A)===!0){let T=x.__offset,y=x.value;if(Array.isArray(y)){let S=0;for(let D=0;D<y.length;D++){let L=y[D],N=_(L,!0);h(L,x.__data,S),S+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,x.__data)}}function h(x,E,b){typeof x=="number"||typeof x=="boolean"?E[b]=x:x.isMatrix3?(E[b]=x.elements[0],E[b+1]=x.elements[1],E[b+2]=x.elements[2],E[b+3]=0,E[b+4]=x.elements[3],E[b+5]=x.elements[4],E[b+6]=x.elements[5],E[b+7]=0,E[b+8]=x.elements[6],E[b+9]=x.elements[7],E[b+10]=x.elements[8],E[b+11]=0):ArrayBuffer.isView(x)?E.set(x.subarray(0,E.length-b),b):x.toArray(E,b)}function d(x,E,b,A){let T=x.value,y=E+"_"+b;if(Array.isArray(T)){A[y]===void 0&&(A[y]=[]);let S=A[y],D=!1;for(let L=0;L<T.length;L++)f(T[L],S,L)===!0&&(D=!0);return D}return f(T,A,y)}function f(x,E,b){if(E[b]===void 0)return typeof x=="number"||typeof x=="boolean"?E[b]=x:ArrayBuffer.isView(x)?E[b]=x.slice():E[b]=x.clone(),!0;{let A=E[b];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return E[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function m(x){let E=x.uniforms,b=0,A=16;for(let y=0,S=E.length;y<S;y++){let D=Array.isArray(E[y])?E[y]:[E[y]];for(let L=0,N=D.length;L<N;L++){let z=D[L],G=Array.isArray(z.value)?z.value:[z.value],B=Array.isArray(E[y])||Array.isArray(z.value),X=b;for(let U=0,Z=G.length;U<Z;U++){let q=G[U],j=_(q,B),et=b%A,dt=et%j.boundary,ft=et+dt;b+=dt,ft!==0&&A-ft<j.storage&&(b+=A-ft),U===0&&(X=b),b+=j.storage}let P=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new P((b-X)/Float32Array.BYTES_PER_ELEMENT),z.__offset=X}}let T=b%A;return T>0&&(b+=A-T),x.__size=b,x.__cache={},this}function _(x,E){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):ne("WebGLRenderer: Unsupported uniform value type.",x),E===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(x){let E=x.target;E.removeEventListener("dispose",p),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var BC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),nr=null;function kC(){return nr===null&&(nr=new uc(BC,16,16,ro,As),nr.name="DFG_LUT",nr.minFilter=wi,nr.magFilter=wi,nr.wrapS=js,nr.wrapT=js,nr.generateMipmaps=!1,nr.needsUpdate=!0),nr}var Pd=class{constructor(t={}){let{canvas:e=W_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ts}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let _=f,p=new Set([Yh,Xh,$h]),g=new Set([ts,Ts,$a,Fo,Vh,Wh]),x=new Uint32Array(4),E=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,T=null,y=[],S=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=er,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,z=null,G=null,B=null,X=null;this._outputColorSpace=ii;let P=0,U=0,Z=null,q=-1,j=null,et=new yn,dt=new yn,ft=null,st=new te(0),vt=0,_t=e.width,Tt=e.height,At=1,Jt=null,pe=null,Zt=new yn(0,0,_t,Tt),Se=new yn(0,0,_t,Tt),ye=!1,de=new Co,fn=new vh,sn=!1,Pn=!1,Ze=new ge,Xn=new H,De=new yn,Bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},vn=!1;function In(){return Z===null?At:1}let W=i;function Nt(I,$){return e.getContext(I,$)}let ie,me,Ct,Qe,Yt,Qt,F,R,J,mt,ct,St,wt,rt,at,bt,V,lt,ot,Pt,Mt,Rt,jt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Wt,!1),e.addEventListener("webglcontextrestored",ae,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),W===null){let $="webgl2";if(W=Nt($,I),W===null)throw Nt($)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}oe()}catch(I){throw e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),re("WebGLRenderer: "+I.message),I}function oe(){ie=new jA(W),ie.init(),Mt=new LC(W,ie),me=new kA(W,ie,t,Mt),Ct=new PC(W,ie),me.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),G=W.createFramebuffer(),B=W.createFramebuffer(),X=W.createFramebuffer(),Qe=new QA(W),Yt=new gC,Qt=new IC(W,ie,Ct,Yt,me,Mt,Qe),F=new ZA(L),R=new eE(W),Rt=new OA(W,R),J=new JA(W,R,Qe,Rt),mt=new eR(W,J,R,Rt,Qe),lt=new tR(W,me,Qt),at=new zA(Yt),ct=new mC(L,F,ie,me,Rt,at),St=new FC(L,Yt),wt=new _C,rt=new wC(ie),V=new FA(L,F,Ct,mt,m,l),bt=new CC(L,mt,me),jt=new OC(W,Qe,me,Ct),ot=new BA(W,ie,Qe),Pt=new KA(W,ie,Qe),Qe.programs=ct.programs,L.capabilities=me,L.extensions=ie,L.properties=Yt,L.renderLists=wt,L.shadowMap=bt,L.state=Ct,L.info=Qe}_!==ts&&(D=new iR(_,e.width,e.height,a,s,r));let pt=new $m(L,W);this.xr=pt,this.getContext=function(){return W},this.getContextAttributes=function(){return W.getContextAttributes()},this.forceContextLoss=function(){let I=ie.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=ie.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(_t,Tt,!1))},this.getSize=function(I){return I.set(_t,Tt)},this.setSize=function(I,$,it=!0){if(pt.isPresenting){ne("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=I,Tt=$,e.width=Math.floor(I*At),e.height=Math.floor($*At),it===!0&&(e.style.width=I+"px",e.style.height=$+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,I,$)},this.getDrawingBufferSize=function(I){return I.set(_t*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,$,it){_t=I,Tt=$,At=it,e.width=Math.floor(I*it),e.height=Math.floor($*it),this.setViewport(0,0,I,$)},this.setEffects=function(I){if(_===ts){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let $=0;$<I.length;$++)if(I[$].isOutputPass===!0){ne("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(et)},this.getViewport=function(I){return I.copy(Zt)},this.setViewport=function(I,$,it,K){I.isVector4?Zt.set(I.x,I.y,I.z,I.w):Zt.set(I,$,it,K),Ct.viewport(et.copy(Zt).multiplyScalar(In()).round())},this.getScissor=function(I){return I.copy(Se)},this.setScissor=function(I,$,it,K){I.isVector4?Se.set(I.x,I.y,I.z,I.w):Se.set(I,$,it,K),Ct.scissor(dt.copy(Se).multiplyScalar(In()).round())},this.getScissorTest=function(){return ye},this.setScissorTest=function(I){Ct.setScissorTest(ye=I)},this.setOpaqueSort=function(I){Jt=I},this.setTransparentSort=function(I){pe=I},this.getClearColor=function(I){return I.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(I=!0,$=!0,it=!0){let K=0;if(I){let Q=!1;if(Z!==null){let It=Z.texture.format;Q=p.has(It)}if(Q){let It=Z.texture.type,Ut=g.has(It),Lt=V.getClearColor(),Ft=V.getClearAlpha(),$t=Lt.r,le=Lt.g,Te=Lt.b;Ut?(x[0]=$t,x[1]=le,x[2]=Te,x[3]=Ft,W.clearBufferuiv(W.COLOR,0,x)):(E[0]=$t,E[1]=le,E[2]=Te,E[3]=Ft,W.clearBufferiv(W.COLOR,0,E))}else K|=W.COLOR_BUFFER_BIT}$&&(K|=W.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(K|=W.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&W.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),z=I},this.dispose=function(){e.removeEventListener("webglcontextlost",Wt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),V.dispose(),wt.dispose(),rt.dispose(),Qt.dispose(),Yt.dispose(),F.dispose(),mt.dispose(),J.dispose(),Rt.dispose(),jt.dispose(),ct.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",yu),pt.removeEventListener("sessionend",Os),lr.stop()};function Wt(I){I.preventDefault(),ic("WebGLRenderer: Context Lost."),N=!0}function ae(){ic("WebGLRenderer: Context Restored."),N=!1;let I=Qe.autoReset,$=bt.enabled,it=bt.autoUpdate,K=bt.needsUpdate,Q=bt.type;oe(),Qe.autoReset=I,bt.enabled=$,bt.autoUpdate=it,bt.needsUpdate=K,bt.type=Q}function Dt(I){re("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function xe(I){let $=I.target;$.removeEventListener("dispose",xe),rn($)}function rn(I){mi(I),Yt.remove(I)}function mi(I){let $=Yt.get(I).programs;$!==void 0&&($.forEach(function(it){ct.releaseProgram(it)}),I.isShaderMaterial&&ct.releaseShaderCache(I))}this.renderBufferDirect=function(I,$,it,K,Q,It){$===null&&($=Bn);let Ut=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Lt=Ll(I,$,it,K,Q);Ct.setMaterial(K,Ut);let Ft=it.index,$t=1;if(K.wireframe===!0){if(Ft=J.getWireframeAttribute(it),Ft===void 0)return;$t=2}let le=it.drawRange,Te=it.attributes.position,qt=le.start*$t,Ae=(le.start+le.count)*$t;It!==null&&(qt=Math.max(qt,It.start*$t),Ae=Math.min(Ae,(It.start+It.count)*$t)),Ft!==null?(qt=Math.max(qt,0),Ae=Math.min(Ae,Ft.count)):Te!=null&&(qt=Math.max(qt,0),Ae=Math.min(Ae,Te.count));let _n=Ae-qt;if(_n<0||_n===1/0)return;Rt.setup(Q,K,Lt,it,Ft);let qe,$e=ot;if(Ft!==null&&(qe=R.get(Ft),$e=Pt,$e.setIndex(qe)),Q.isMesh)K.wireframe===!0?(Ct.setLineWidth(K.wireframeLinewidth*In()),$e.setMode(W.LINES)):$e.setMode(W.TRIANGLES);else if(Q.isLine){let kn=K.linewidth;kn===void 0&&(kn=1),Ct.setLineWidth(kn*In()),Q.isLineSegments?$e.setMode(W.LINES):Q.isLineLoop?$e.setMode(W.LINE_LOOP):$e.setMode(W.LINE_STRIP)}else Q.isPoints?$e.setMode(W.POINTS):Q.isSprite&&$e.setMode(W.TRIANGLES);if(Q.isBatchedMesh)if(ie.get("WEBGL_multi_draw"))$e.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let kn=Q._multiDrawStarts,Ht=Q._multiDrawCounts,Ln=Q._multiDrawCount,Ce=Ft?R.get(Ft).bytesPerElement:1,ur=Yt.get(K).currentProgram.getUniforms();for(let Dn=0;Dn<Ln;Dn++)ur.setValue(W,"_gl_DrawID",Dn),$e.render(kn[Dn]/Ce,Ht[Dn])}else if(Q.isInstancedMesh)$e.renderInstances(qt,_n,Q.count);else if(it.isInstancedBufferGeometry){let kn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Ht=Math.min(it.instanceCount,kn);$e.renderInstances(qt,_n,Ht)}else $e.render(qt,_n)};function Cl(I,$,it,K){z!==null&&I.isNodeMaterial&&z.setObject(K,I),sn===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===hi&&I.forceSinglePass===!1?(I.side=Ci,I.needsUpdate=!0,Bs(I,$,K),I.side=so,I.needsUpdate=!0,Bs(I,$,K),I.side=hi):Bs(I,$,K)}this.compile=function(I,$,it=null){it===null&&(it=I),z!==null&&z.renderStart(I,$,it),T=rt.get(it),T.init($),S.push(T),it.traverseVisible(function(Q){Q.isLight&&Q.layers.test($.layers)&&(T.pushLight(Q),Q.castShadow&&T.pushShadow(Q))}),I!==it&&I.traverseVisible(function(Q){Q.isLight&&Q.layers.test($.layers)&&(T.pushLight(Q),Q.castShadow&&T.pushShadow(Q))}),T.setupLights(),z!==null&&z.updateLights(T.state.lightsArray),Pn=this.localClippingEnabled,sn=at.init(this.clippingPlanes,Pn),sn===!0&&at.setGlobalState(this.clippingPlanes,$),z!==null&&bt.render(T.state.shadowsArray,it,$);let K=new Set;return I.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let It=Q.material;if(It)if(Array.isArray(It))for(let Ut=0;Ut<It.length;Ut++){let Lt=It[Ut];Cl(Lt,it,$,Q),K.add(Lt)}else Cl(It,it,$,Q),K.add(It)}),T=S.pop(),z!==null&&z.renderEnd(),K},this.compileAsync=function(I,$,it=null){let K=this.compile(I,$,it);return new Promise(Q=>{function It(){if(K.forEach(function(Ut){let Ft=Yt.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&K.delete(Ut)}),K.size===0){Q(I);return}setTimeout(It,10)}ie.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let Qo=null;function up(I){Qo&&Qo(I)}function yu(){lr.stop()}function Os(){lr.start()}let lr=new vy;lr.setAnimationLoop(up),typeof self<"u"&&lr.setContext(self),this.setAnimationLoop=function(I){Qo=I,pt.setAnimationLoop(I),I===null?lr.stop():lr.start()},pt.addEventListener("sessionstart",yu),pt.addEventListener("sessionend",Os),this.render=function(I,$){if($!==void 0&&$.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;z!==null&&z.renderStart(I,$);let it=pt.enabled===!0&&pt.isPresenting===!0,K=D!==null&&(Z===null||it)&&D.begin(L,Z);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),$.parent===null&&$.matrixWorldAutoUpdate===!0&&$.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera($),$=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(L,I,$,Z),T=rt.get(I,S.length),T.init($),T.state.textureUnits=Qt.getTextureUnits(),S.push(T),Ze.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),$.isArrayCamera?fn.setFromArrayCamera($):de.setFromProjectionMatrix(Ze,cs,$.reversedDepth),Pn=this.localClippingEnabled,sn=at.init(this.clippingPlanes,Pn),A=wt.get(I,y.length),A.init(),y.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ut=L.xr.getDepthSensingMesh();Ut!==null&&cr(Ut,$,-1/0,L.sortObjects)}cr(I,$,0,L.sortObjects),A.finish(),z!==null&&z.updateLights(T.state.lightsArray),L.sortObjects===!0&&A.sort(Jt,pe),vn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,vn&&V.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),sn===!0&&at.beginShadows();let Q=T.state.shadowsArray;if(bt.render(Q,I,$),sn===!0&&at.endShadows(),(K&&D.hasRenderPass())===!1){let Ut=A.opaque,Lt=A.transmissive;if(T.setupLights(),$.isArrayCamera){let Ft=$.cameras;if(Lt.length>0)for(let $t=0,le=Ft.length;$t<le;$t++){let Te=Ft[$t];xs(Ut,Lt,I,Te)}vn&&V.render(I);for(let $t=0,le=Ft.length;$t<le;$t++){let Te=Ft[$t];Pl(A,I,Te,Te.viewport)}}else Lt.length>0&&xs(Ut,Lt,I,$),vn&&V.render(I),Pl(A,I,$)}Z!==null&&U===0&&(Qt.updateMultisampleRenderTarget(Z),Qt.updateRenderTargetMipmap(Z)),K&&D.end(L),I.isScene===!0&&I.onAfterRender(L,I,$),Rt.resetDefaultState(),q=-1,j=null,S.pop(),S.length>0?(T=S[S.length-1],Qt.setTextureUnits(T.state.textureUnits),sn===!0&&at.setGlobalState(L.clippingPlanes,T.state.camera)):T=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,z!==null&&z.renderEnd()};function cr(I,$,it,K){if(I.visible===!1)return;if(I.layers.test($.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update($);else if(I.isLight)T.pushLight(I),I.castShadow&&T.pushShadow(I);else if(I.isSprite){let Ut=$.isArrayCamera?fn:de;if(!I.frustumCulled||I.intersectsFrustum(Ut)){K&&De.setFromMatrixPosition(I.matrixWorld).applyMatrix4(Ze);let Lt=mt.update(I),Ft=I.material;Ft.visible&&A.push(I,Lt,Ft,it,De.z,null,$)}}else if(I.isMesh||I.isLine||I.isPoints){let Ut=$.isArrayCamera?fn:de;if(!I.frustumCulled||I.intersectsFrustum(Ut)){let Lt=mt.update(I),Ft=I.material;if(K&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),De.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),De.copy(Lt.boundingSphere.center)),De.applyMatrix4(I.matrixWorld).applyMatrix4(Ze)),Array.isArray(Ft)){let $t=Lt.groups;for(let le=0,Te=$t.length;le<Te;le++){let qt=$t[le],Ae=Ft[qt.materialIndex];Ae&&Ae.visible&&A.push(I,Lt,Ae,it,De.z,qt,$)}}else Ft.visible&&A.push(I,Lt,Ft,it,De.z,null,$)}}}let It=I.children;for(let Ut=0,Lt=It.length;Ut<Lt;Ut++)cr(It[Ut],$,it,K)}function Pl(I,$,it,K){let{opaque:Q,transmissive:It,transparent:Ut}=I;T.setupLightsView(it),sn===!0&&at.setGlobalState(L.clippingPlanes,it),K&&Ct.viewport(et.copy(K)),Q.length>0&&bn(Q,$,it),It.length>0&&bn(It,$,it),Ut.length>0&&bn(Ut,$,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function xs(I,$,it,K){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[K.id]===void 0){let qt=ie.has("EXT_color_buffer_half_float")||ie.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[K.id]=new Ji(1,1,{generateMipmaps:!0,type:qt?As:ts,minFilter:Ar,samples:Math.max(4,me.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ie.workingColorSpace})}let It=T.state.transmissionRenderTarget[K.id],Ut=K.viewport||et;It.setSize(Ut.z*L.transmissionResolutionScale,Ut.w*L.transmissionResolutionScale);let Lt=L.getRenderTarget(),Ft=L.getActiveCubeFace(),$t=L.getActiveMipmapLevel();L.setRenderTarget(It),L.getClearColor(st),vt=L.getClearAlpha(),vt<1&&L.setClearColor(16777215,.5),L.clear(),vn&&V.render(it);let le=L.toneMapping;L.toneMapping=er;let Te=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),T.setupLightsView(K),sn===!0&&at.setGlobalState(L.clippingPlanes,K),bn(I,it,K),Qt.updateMultisampleRenderTarget(It),Qt.updateRenderTargetMipmap(It),ie.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ae=0,_n=$.length;Ae<_n;Ae++){let qe=$[Ae],{object:$e,geometry:kn,material:Ht,group:Ln}=qe;if(Ht.side===hi&&$e.layers.test(K.layers)){let Ce=Ht.side;Ht.side=Ci,Ht.needsUpdate=!0,Rn($e,it,K,kn,Ht,Ln),Ht.side=Ce,Ht.needsUpdate=!0,qt=!0}}qt===!0&&(Qt.updateMultisampleRenderTarget(It),Qt.updateRenderTargetMipmap(It))}L.setRenderTarget(Lt,Ft,$t),L.setClearColor(st,vt),Te!==void 0&&(K.viewport=Te),L.toneMapping=le}function bn(I,$,it){let K=$.isScene===!0?$.overrideMaterial:null;for(let Q=0,It=I.length;Q<It;Q++){let Ut=I[Q],{object:Lt,geometry:Ft,group:$t}=Ut,le=Ut.material;le.allowOverride===!0&&K!==null&&(le=K),Lt.layers.test(it.layers)&&Rn(Lt,$,it,Ft,le,$t)}}function Rn(I,$,it,K,Q,It){z!==null&&Q.isNodeMaterial&&z.setObject(I,Q),I.onBeforeRender(L,$,it,K,Q,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),Q.onBeforeRender(L,$,it,K,I,It),Q.transparent===!0&&Q.side===hi&&Q.forceSinglePass===!1?(Q.side=Ci,Q.needsUpdate=!0,L.renderBufferDirect(it,$,K,Q,I,It),Q.side=so,Q.needsUpdate=!0,L.renderBufferDirect(it,$,K,Q,I,It),Q.side=hi):L.renderBufferDirect(it,$,K,Q,I,It),I.onAfterRender(L,$,it,K,Q,It)}function Cn(I){let $=0;for(let it of I)it.texture!==null&&$++;return $}function Bs(I,$,it){$.isScene!==!0&&($=Bn);let K=Yt.get(I),Q=T.state.lights,It=T.state.shadowsArray,Ut=Q.state.version,Lt=ct.getParameters(I,Q.state,It,$,it,T.state.lightProbeGridArray),Ft=ct.getProgramCacheKey(Lt),$t=K.programs;K.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?$.environment:null,K.fog=$.fog;let le=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;K.envMap=F.get(I.envMap||K.environment,le),K.envMapRotation=K.environment!==null&&I.envMap===null?$.environmentRotation:I.envMapRotation,$t===void 0&&(I.addEventListener("dispose",xe),$t=new Map,K.programs=$t,K.programVariants=new Map);let Te=$t.get(Ft);if(Te!==void 0){if(K.currentProgram===Te&&K.lightsStateVersion===Ut)return Il(I,Lt),Te}else Lt.uniforms=ct.getUniforms(I),z!==null&&I.isNodeMaterial&&z.build(I,it,Lt),I.onBeforeCompile(Lt,L),Te=ct.acquireProgram(Lt,Ft),$t.set(Ft,Te),K.uniforms=Lt.uniforms;let qt=K.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&(qt.clippingPlanes=at.uniform),Il(I,Lt),K.needsLights=kr(I),K.lightsStateVersion=Ut,K.needsLights&&(qt.ambientLightColor.value=Q.state.ambient,qt.lightProbe.value=Q.state.probe,qt.sunLights.value=Q.state.sun,qt.sunLightShadows.value=Q.state.sunShadow,qt.directionalLights.value=Q.state.directional,qt.directionalLightShadows.value=Q.state.directionalShadow,qt.spotLights.value=Q.state.spot,qt.spotLightShadows.value=Q.state.spotShadow,qt.rectAreaLights.value=Q.state.rectArea,qt.ltc_1.value=Q.state.rectAreaLTC1,qt.ltc_2.value=Q.state.rectAreaLTC2,qt.pointLights.value=Q.state.point,qt.pointLightShadows.value=Q.state.pointShadow,qt.hemisphereLights.value=Q.state.hemi,qt.sunShadowMatrix.value=Q.state.sunShadowMatrix,qt.sunShadowCascade.value=Q.state.sunShadowCascade,qt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,qt.spotLightMatrix.value=Q.state.spotLightMatrix,qt.spotLightMap.value=Q.state.spotLightMap,qt.pointShadowMatrix.value=Q.state.pointShadowMatrix),K.numLightProbeGrids=Cn(T.state.lightProbeGridArray),K.currentProgram=Te,K.uniformsList=null,Te}function Wi(I,$,it,K,Q){let It=Yt.get(I),Ut=It.currentProgram.id+","+K+","+Q,Lt=It.programVariants.get(Ut);return Lt===void 0?(Lt=Bs(I,$,it),It.programVariants.set(Ut,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=K,It.toneMapping=Q),Lt}function Br(I){if(I.uniformsList===null){let $=I.currentProgram.getUniforms();I.uniformsList=Xa.seqWithValue($.seq,I.uniforms)}return I.uniformsList}function Il(I,$){let it=Yt.get(I);it.outputColorSpace=$.outputColorSpace,it.batching=$.batching,it.batchingColor=$.batchingColor,it.instancing=$.instancing,it.instancingColor=$.instancingColor,it.instancingMorph=$.instancingMorph,it.skinning=$.skinning,it.morphTargets=$.morphTargets,it.morphNormals=$.morphNormals,it.morphColors=$.morphColors,it.morphTargetsCount=$.morphTargetsCount,it.numClippingPlanes=$.numClippingPlanes,it.numIntersection=$.numClipIntersection,it.vertexAlphas=$.vertexAlphas,it.vertexTangents=$.vertexTangents,it.toneMapping=$.toneMapping}function Ll(I,$,it,K,Q){$.isScene!==!0&&($=Bn),Qt.resetTextureUnits();let It=$.fog,Ut=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?$.environment:null,Lt=Z===null?L.outputColorSpace:Z.isXRRenderTarget===!0?Z.texture.colorSpace:Ie.workingColorSpace,Ft=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,$t=F.get(K.envMap||Ut,Ft),le=K.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Te=!!it.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),qt=!!it.morphAttributes.position,Ae=!!it.morphAttributes.normal,_n=!!it.morphAttributes.color,qe=er;K.toneMapped&&(Z===null||Z.isXRRenderTarget===!0)&&(qe=L.toneMapping);let $e=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,kn=$e!==void 0?$e.length:0,Ht=Yt.get(K),Ln=T.state.lights;if(sn===!0&&(Pn===!0||I!==j)){let Xe=I===j&&K.id===q;at.setState(K,I,Xe)}let Ce=!1,ur=!1;K.version===Ht.__version?Ht.needsLights&&Ht.lightsStateVersion!==Ln.state.version||Q.isBatchedMesh&&Ht.batching===!1||!Q.isBatchedMesh&&Ht.batching===!0||Q.isBatchedMesh&&Ht.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Ht.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Ht.instancing===!1||!Q.isInstancedMesh&&Ht.instancing===!0||Q.isSkinnedMesh&&Ht.skinning===!1||!Q.isSkinnedMesh&&Ht.skinning===!0||Q.isInstancedMesh&&Ht.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Ht.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Ht.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Ht.instancingMorph===!1&&Q.morphTexture!==null||Ht.envMap!==$t||K.fog===!0&&Ht.fog!==It||Ht.numClippingPlanes!==void 0&&(Ht.numClippingPlanes!==at.numPlanes||Ht.numIntersection!==at.numIntersection)||Ht.vertexAlphas!==le||Ht.vertexTangents!==Te||Ht.morphTargets!==qt||Ht.morphNormals!==Ae||Ht.morphColors!==_n||Ht.morphTargetsCount!==kn||Ht.numLightProbeGrids!==Cn(T.state.lightProbeGridArray)?Ce=!0:(Ht.outputColorSpace!==Lt||Ht.toneMapping!==qe)&&(ur=!0):(Ce=!0,Ht.__version=K.version);let Dn=Ht.currentProgram;(Ce===!0||ur===!0)&&(Dn=ur===!0?Wi(K,$,Q,Lt,qe):Bs(K,$,Q),z&&K.isNodeMaterial&&z.onUpdateProgram(K,Dn,Ht));let na=!1,ks=!1,hr=!1,ve=Dn.getUniforms(),Mn=Ht.uniforms;if(Ct.useProgram(Dn.program)&&(na=!0,ks=!0,hr=!0),K.id!==q&&(q=K.id,ks=!0),na||j!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),ve.setValue(W,"projectionMatrix",I.projectionMatrix),ve.setValue(W,"viewMatrix",I.matrixWorldInverse);let Nn=ve.map.cameraPosition;Nn!==void 0&&Nn.setValue(W,Xn.setFromMatrixPosition(I.matrixWorld)),me.logarithmicDepthBuffer&&ve.setValue(W,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&ve.setValue(W,"isOrthographic",I.isOrthographicCamera===!0),j!==I&&(j=I,ks=!0,hr=!0)}if(Ht.needsLights&&(Ln.state.sunShadowMap.length>0&&ve.setValue(W,"sunShadowMap",Ln.state.sunShadowMap,Qt),Ln.state.directionalShadowMap.length>0&&ve.setValue(W,"directionalShadowMap",Ln.state.directionalShadowMap,Qt),Ln.state.spotShadowMap.length>0&&ve.setValue(W,"spotShadowMap",Ln.state.spotShadowMap,Qt),Ln.state.pointShadowMap.length>0&&ve.setValue(W,"pointShadowMap",Ln.state.pointShadowMap,Qt)),Q.isSkinnedMesh){ve.setOptional(W,Q,"bindMatrix"),ve.setOptional(W,Q,"bindMatrixInverse");let Xe=Q.skeleton;Xe&&(Xe.boneTexture===null&&Xe.computeBoneTexture(),ve.setValue(W,"boneTexture",Xe.boneTexture,Qt))}Q.isBatchedMesh&&(ve.setOptional(W,Q,"batchingTexture"),ve.setValue(W,"batchingTexture",Q._matricesTexture,Qt),ve.setOptional(W,Q,"batchingIdTexture"),ve.setValue(W,"batchingIdTexture",Q._indirectTexture,Qt),ve.setOptional(W,Q,"batchingColorTexture"),Q._colorsTexture!==null&&ve.setValue(W,"batchingColorTexture",Q._colorsTexture,Qt));let gi=it.morphAttributes;if((gi.position!==void 0||gi.normal!==void 0||gi.color!==void 0)&&lt.update(Q,it,Dn),(ks||Ht.receiveShadow!==Q.receiveShadow)&&(Ht.receiveShadow=Q.receiveShadow,ve.setValue(W,"receiveShadow",Q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&$.environment!==null&&(Mn.envMapIntensity.value=$.environmentIntensity),Mn.dfgLUT!==void 0&&(Mn.dfgLUT.value=kC()),ks){if(ve.setValue(W,"toneMappingExposure",L.toneMappingExposure),Ht.needsLights&&ta(Mn,hr),It&&K.fog===!0&&St.refreshFogUniforms(Mn,It),St.refreshMaterialUniforms(Mn,K,At,Tt,T.state.transmissionRenderTarget[I.id]),Ht.needsLights&&Ht.numLightProbeGrids>0){let Xe=b,Nn=0;for(let ai of T.state.lightProbeGridArray)ai.texture!==null&&(Xe.textures[Nn]=ai.texture,Xe.min[Nn]=ai.boundingBox.min,Xe.max[Nn]=ai.boundingBox.max,Xe.resolution[Nn]=ai.resolution,Nn++);for(let ai in Xe)Xe[ai].length=Nn;Mn.probesSH.value=Xe.textures,Mn.probesMin.value=Xe.min,Mn.probesMax.value=Xe.max,Mn.probesResolution.value=Xe.resolution}Xa.upload(W,Br(Ht),Mn,Qt)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Xa.upload(W,Br(Ht),Mn,Qt),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&ve.setValue(W,"center",Q.center),ve.setValue(W,"modelViewMatrix",Q.modelViewMatrix),ve.setValue(W,"normalMatrix",Q.normalMatrix),ve.setValue(W,"modelMatrix",Q.matrixWorld),K.uniformsGroups!==void 0){let Xe=K.uniformsGroups;for(let Nn=0,ai=Xe.length;Nn<ai;Nn++){let vu=Xe[Nn];jt.update(vu,Dn),jt.bind(vu,Dn)}}return Dn}function ta(I,$){I.ambientLightColor.needsUpdate=$,I.lightProbe.needsUpdate=$,I.sunLights.needsUpdate=$,I.sunLightShadows.needsUpdate=$,I.directionalLights.needsUpdate=$,I.directionalLightShadows.needsUpdate=$,I.pointLights.needsUpdate=$,I.pointLightShadows.needsUpdate=$,I.spotLights.needsUpdate=$,I.spotLightShadows.needsUpdate=$,I.rectAreaLights.needsUpdate=$,I.hemisphereLights.needsUpdate=$}function kr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return Z},this.setRenderTargetTextures=function(I,$,it){let K=Yt.get(I);K.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Yt.get(I.texture).__webglTexture=$,Yt.get(I.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:it,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,$){let it=Yt.get(I);it.__webglFramebuffer=$,it.__useDefaultFramebuffer=$===void 0},this.setRenderTarget=function(I,$=0,it=0){Z=I,P=$,U=it;let K=null,Q=!1,It=!1;if(I){let Lt=Yt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer(W.FRAMEBUFFER,Lt.__webglFramebuffer),et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),q=-1;return}else if(Lt.__webglFramebuffer===void 0)Qt.setupRenderTarget(I);else if(Lt.__hasExternalTextures)Qt.rebindTextures(I,Yt.get(I.texture).__webglTexture,Yt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let le=I.depthTexture;if(Lt.__boundDepthTexture!==le){if(le!==null&&Yt.has(le)&&(I.width!==le.image.width||I.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Qt.setupDepthRenderbuffer(I)}}let Ft=I.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(It=!0);let $t=Yt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray($t[$])?K=$t[$][it]:K=$t[$],Q=!0):I.samples>0&&Qt.useMultisampledRTT(I)===!1?K=Yt.get(I).__webglMultisampledFramebuffer:Array.isArray($t)?K=$t[it]:K=$t,et.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else et.copy(Zt).multiplyScalar(At).floor(),dt.copy(Se).multiplyScalar(At).floor(),ft=ye;if(it!==0&&(K=G),Ct.bindFramebuffer(W.FRAMEBUFFER,K)&&Ct.drawBuffers(I,K),Ct.viewport(et),Ct.scissor(dt),Ct.setScissorTest(ft),Q){let Lt=Yt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_CUBE_MAP_POSITIVE_X+$,Lt.__webglTexture,it)}else if(It){let Lt=$;for(let Ft=0;Ft<I.textures.length;Ft++){let $t=Yt.get(I.textures[Ft]);W.framebufferTextureLayer(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0+Ft,$t.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Yt.get(I.texture);W.framebufferTexture2D(W.FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Lt.__webglTexture,it)}q=-1};function ea(I){let $=Yt.get(I);return($.__readFormat!==I.format||$.__readType!==I.type)&&($.__readFormat=I.format,$.__readType=I.type,$.__formatReadable=me.textureFormatReadable(I.format),$.__typeReadable=me.textureTypeReadable(I.type)),$}this.readRenderTargetPixels=function(I,$,it,K,Q,It,Ut,Lt=0){if(!(I&&I.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Ct.bindFramebuffer(W.FRAMEBUFFER,Ft);try{let $t=I.textures[Lt],le=$t.format,Te=$t.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let qt=ea($t);if(qt.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}$>=0&&$<=I.width-K&&it>=0&&it<=I.height-Q&&W.readPixels($,it,K,Q,Mt.convert(le),Mt.convert(Te),It)}finally{let $t=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,$t)}}},this.readRenderTargetPixelsAsync=async function(I,$,it,K,Q,It,Ut,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if($>=0&&$<=I.width-K&&it>=0&&it<=I.height-Q){Ct.bindFramebuffer(W.FRAMEBUFFER,Ft);let $t=I.textures[Lt],le=$t.format,Te=$t.type;I.textures.length>1&&W.readBuffer(W.COLOR_ATTACHMENT0+Lt);let qt=ea($t);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ae=W.createBuffer();W.bindBuffer(W.PIXEL_PACK_BUFFER,Ae),W.bufferData(W.PIXEL_PACK_BUFFER,It.byteLength,W.STREAM_READ),W.readPixels($,it,K,Q,Mt.convert(le),Mt.convert(Te),0),W.bindBuffer(W.PIXEL_PACK_BUFFER,null);let _n=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer(W.FRAMEBUFFER,_n);let qe=W.fenceSync(W.SYNC_GPU_COMMANDS_COMPLETE,0);return W.flush(),await $_(W,qe,4),W.bindBuffer(W.PIXEL_PACK_BUFFER,Ae),W.getBufferSubData(W.PIXEL_PACK_BUFFER,0,It),W.bindBuffer(W.PIXEL_PACK_BUFFER,null),W.deleteBuffer(Ae),W.deleteSync(qe),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,$=null,it=0){let K=Math.pow(2,-it),Q=Math.floor(I.image.width*K),It=Math.floor(I.image.height*K),Ut=$!==null?$.x:0,Lt=$!==null?$.y:0;Qt.setTexture2D(I,0),W.copyTexSubImage2D(W.TEXTURE_2D,it,0,0,Ut,Lt,Q,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,$,it=null,K=null,Q=0,It=0){let Ut,Lt,Ft,$t,le,Te,qt,Ae,_n,qe=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ut=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Ft=it.isBox3?it.max.z-it.min.z:1,$t=it.min.x,le=it.min.y,Te=it.isBox3?it.min.z:0;else{let ve=Math.pow(2,-Q);Ut=Math.floor(qe.width*ve),Lt=Math.floor(qe.height*ve),I.isDataArrayTexture?Ft=qe.depth:I.isData3DTexture?Ft=Math.floor(qe.depth*ve):Ft=1,$t=0,le=0,Te=0}K!==null?(qt=K.x,Ae=K.y,_n=K.z):(qt=0,Ae=0,_n=0);let $e=Mt.convert($.format),kn=Mt.convert($.type),Ht;$.isData3DTexture?(Qt.setTexture3D($,0),Ht=W.TEXTURE_3D):$.isDataArrayTexture||$.isCompressedArrayTexture?(Qt.setTexture2DArray($,0),Ht=W.TEXTURE_2D_ARRAY):(Qt.setTexture2D($,0),Ht=W.TEXTURE_2D),Ct.activeTexture(W.TEXTURE0),Ct.pixelStorei(W.UNPACK_FLIP_Y_WEBGL,$.flipY),Ct.pixelStorei(W.UNPACK_PREMULTIPLY_ALPHA_WEBGL,$.premultiplyAlpha),Ct.pixelStorei(W.UNPACK_ALIGNMENT,$.unpackAlignment);let Ln=Ct.getParameter(W.UNPACK_ROW_LENGTH),Ce=Ct.getParameter(W.UNPACK_IMAGE_HEIGHT),ur=Ct.getParameter(W.UNPACK_SKIP_PIXELS),Dn=Ct.getParameter(W.UNPACK_SKIP_ROWS),na=Ct.getParameter(W.UNPACK_SKIP_IMAGES);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,qe.width),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,qe.height),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,$t),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,le),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,Te);let ks=I.isDataArrayTexture||I.isData3DTexture,hr=$.isDataArrayTexture||$.isData3DTexture;if(I.isDepthTexture){let ve=Yt.get(I),Mn=Yt.get($),gi=Yt.get(ve.__renderTarget),Xe=Yt.get(Mn.__renderTarget);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,gi.__webglFramebuffer),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,Xe.__webglFramebuffer);for(let Nn=0;Nn<Ft;Nn++)ks&&(W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Yt.get(I).__webglTexture,Q,Te+Nn),W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Yt.get($).__webglTexture,It,_n+Nn)),W.blitFramebuffer($t,le,$t+Ut,le+Lt,qt,Ae,qt+Ut,Ae+Lt,W.DEPTH_BUFFER_BIT,W.NEAREST);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else if(Q!==0||I.isRenderTargetTexture||Yt.has(I)){let ve=Yt.get(I),Mn=Yt.get($);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,B),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,X);for(let gi=0;gi<Ft;gi++)ks?W.framebufferTextureLayer(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,ve.__webglTexture,Q,Te+gi):W.framebufferTexture2D(W.READ_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,ve.__webglTexture,Q),hr?W.framebufferTextureLayer(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,Mn.__webglTexture,It,_n+gi):W.framebufferTexture2D(W.DRAW_FRAMEBUFFER,W.COLOR_ATTACHMENT0,W.TEXTURE_2D,Mn.__webglTexture,It),Q!==0?W.blitFramebuffer($t,le,$t+Ut,le+Lt,qt,Ae,qt+Ut,Ae+Lt,W.COLOR_BUFFER_BIT,W.NEAREST):hr?W.copyTexSubImage3D(Ht,It,qt,Ae,_n+gi,$t,le,Ut,Lt):W.copyTexSubImage2D(Ht,It,qt,Ae,$t,le,Ut,Lt);Ct.bindFramebuffer(W.READ_FRAMEBUFFER,null),Ct.bindFramebuffer(W.DRAW_FRAMEBUFFER,null)}else hr?I.isDataTexture||I.isData3DTexture?W.texSubImage3D(Ht,It,qt,Ae,_n,Ut,Lt,Ft,$e,kn,qe.data):$.isCompressedArrayTexture?W.compressedTexSubImage3D(Ht,It,qt,Ae,_n,Ut,Lt,Ft,$e,qe.data):W.texSubImage3D(Ht,It,qt,Ae,_n,Ut,Lt,Ft,$e,kn,qe):I.isDataTexture?W.texSubImage2D(W.TEXTURE_2D,It,qt,Ae,Ut,Lt,$e,kn,qe.data):I.isCompressedTexture?W.compressedTexSubImage2D(W.TEXTURE_2D,It,qt,Ae,qe.width,qe.height,$e,qe.data):W.texSubImage2D(W.TEXTURE_2D,It,qt,Ae,Ut,Lt,$e,kn,qe);Ct.pixelStorei(W.UNPACK_ROW_LENGTH,Ln),Ct.pixelStorei(W.UNPACK_IMAGE_HEIGHT,Ce),Ct.pixelStorei(W.UNPACK_SKIP_PIXELS,ur),Ct.pixelStorei(W.UNPACK_SKIP_ROWS,Dn),Ct.pixelStorei(W.UNPACK_SKIP_IMAGES,na),It===0&&$.generateMipmaps===!0&&$.mipmapsAutoUpdate===!0&&W.generateMipmap(Ht),Ct.unbindTexture()},this.initRenderTarget=function(I){Yt.get(I).__webglFramebuffer===void 0&&Qt.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?Qt.setTextureCube(I,0):I.isData3DTexture?Qt.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?Qt.setTexture2DArray(I,0):Qt.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){P=0,U=0,Z=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return cs}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ie._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ie._getUnpackColorSpace()}};var Dd={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Bt={},HC=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],Iy=matchMedia("(prefers-color-scheme: dark)");function Nd(){let n=M.theme==="dark"||M.theme==="auto"&&Iy.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of HC)Bt[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Bt.dark=n,Bt.curves=Dd[n?"dark":"light"].curves}function Ud(n){M.theme=n,Nd(),ht("theme")}Iy.addEventListener("change",()=>{M.theme==="auto"&&(Nd(),ht("theme"))});var Ly={type:"change"},Ym={type:"start"},Ny={type:"end"},Fd=new wr,Dy=new si,GC=Math.cos(70*ao.DEG2RAD),Gn=new H,Bi=2*Math.PI,Be={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Xm=1e-6,Od=class extends Sc{constructor(t,e=null){super(t,e),this.state=Be.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:no.ROTATE,MIDDLE:no.DOLLY,RIGHT:no.PAN},this.touches={ONE:io.ROTATE,TWO:io.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new un,this._lastTargetPosition=new H,this._quat=new un().setFromUnitVectors(t.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ga,this._sphericalDelta=new Ga,this._scale=1,this._panOffset=new H,this._rotateStart=new Xt,this._rotateEnd=new Xt,this._rotateDelta=new Xt,this._panStart=new Xt,this._panEnd=new Xt,this._panDelta=new Xt,this._dollyStart=new Xt,this._dollyEnd=new Xt,this._dollyDelta=new Xt,this._dollyDirection=new H,this._mouse=new Xt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=WC.bind(this),this._onPointerDown=VC.bind(this),this._onPointerUp=qC.bind(this),this._onContextMenu=KC.bind(this),this._onMouseWheel=YC.bind(this),this._onKeyDown=ZC.bind(this),this._onTouchStart=jC.bind(this),this._onTouchMove=JC.bind(this),this._onMouseDown=$C.bind(this),this._onMouseMove=XC.bind(this),this._interceptControlDown=QC.bind(this),this._interceptControlUp=tP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Be.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ly),this.update(),this.state=Be.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Gn.copy(e).sub(this.target),Gn.applyQuaternion(this._quat),this._spherical.setFromVector3(Gn),this.autoRotate&&this.state===Be.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Bi:i>Math.PI&&(i-=Bi),s<-Math.PI?s+=Bi:s>Math.PI&&(s-=Bi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Gn.setFromSpherical(this._spherical),Gn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Gn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Gn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new H(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Gn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Fd.origin.copy(this.object.position),Fd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Fd.direction))<GC?this.object.lookAt(this.target):(Dy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Fd.intersectPlane(Dy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Xm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Xm||this._lastTargetPosition.distanceToSquared(this.target)>Xm?(this.dispatchEvent(Ly),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Bi/60*this.autoRotateSpeed*t:Bi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Gn.setFromMatrixColumn(e,0),Gn.multiplyScalar(-t),this._panOffset.add(Gn)}_panUp(t,e){this.screenSpacePanning===!0?Gn.setFromMatrixColumn(e,1):(Gn.setFromMatrixColumn(e,0),Gn.crossVectors(this.object.up,Gn)),Gn.multiplyScalar(t),this._panOffset.add(Gn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Gn.copy(s).sub(this.target);let r=Gn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Bi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Bi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Bi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Bi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Bi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Xt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function VC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function WC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function qC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ny),this.state=Be.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function $C(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case no.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Be.DOLLY;break;case no.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Be.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Be.ROTATE}break;case no.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Be.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Be.PAN}break;default:this.state=Be.NONE}this.state!==Be.NONE&&this.dispatchEvent(Ym)}function XC(n){switch(this.state){case Be.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Be.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Be.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function YC(n){this.enabled===!1||this.enableZoom===!1||this.state!==Be.NONE||(n.preventDefault(),this.dispatchEvent(Ym),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Ny))}function ZC(n){this.enabled!==!1&&this._handleKeyDown(n)}function jC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case io.ROTATE:if(this.enableRotate===!1){this.state=Be.NONE;break}this._handleTouchStartRotate(n),this.state=Be.TOUCH_ROTATE;break;case io.PAN:if(this.enablePan===!1){this.state=Be.NONE;break}this._handleTouchStartPan(n),this.state=Be.TOUCH_PAN;break;default:this.state=Be.NONE}break;case 2:switch(this.touches.TWO){case io.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Be.TOUCH_DOLLY_PAN;break;case io.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Be.TOUCH_DOLLY_ROTATE;break;default:this.state=Be.NONE}break;default:this.state=Be.NONE}this.state!==Be.NONE&&this.dispatchEvent(Ym)}function JC(n){switch(this._trackPointer(n),this.state){case Be.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Be.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Be.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Be.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Be.NONE}}function KC(n){this.enabled!==!1&&n.preventDefault()}function QC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function tP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Uy=[1,.75,.55,.42],eP=30,nP=17,iP=400,Fy=6e6;function Oy(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Bd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(Fy/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>eP&&this.level<Uy.length-1?this.level+=1:i<nP&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*Uy[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(Fy/this.area),.5))),this.draw()},iP)}};var zy=32,Hy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},hn=new oc,ke=new Si(zy,1,.01,100);ke.up.set(0,0,1);var es,Tn,ds,kd,Zm=!1,Gy=!1,Jm=0;function _e(){Zm||!Gy||(Zm=!0,requestAnimationFrame(Vy))}function Vy(n=performance.now()){Zm=!1,kd.moving(n),Km()}var Wy=[],qy=n=>Wy.push(n);function Km(){for(let n of Wy)n();es.render(hn,ke),Jm+=1}function $y(){Gy=!0,_e()}function Za(n){return Km(),n(es.domElement)}var Xy=()=>Jm,Yy=()=>!!kd?.software;hn.fog=new rc("#fff",1,10);function By(n){let t=document.createElement("canvas");t.width=ds.clientWidth||1,t.height=ds.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>sP.has(s)?i(s):null,e}var sP=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function Zy(n){ds=n;let t=By(!1),e=Oy(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=By(!0)),es=new Pd({canvas:t.canvas,context:t}),es.debug.checkShaderErrors=!1,kd=new Bd(e,es,Km,i=>ht("hurry",i)),es.domElement.setAttribute("aria-hidden","true"),ds.append(es.domElement),Tn=new Od(ke,es.domElement),Tn.enableDamping=!1,Tn.addEventListener("change",_e),Tn.addEventListener("end",()=>{Fc=!Jy(),Bo=null}),new ResizeObserver(rP).observe(ds),ds.tabIndex=0,ds.setAttribute("role","application"),ds.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ds.addEventListener("keydown",oP)}function rP(){let n=ds.clientWidth,t=ds.clientHeight;!n||!t||(kd.resized(n,t),es.setSize(n,t),ke.aspect=n/t,ke.updateProjectionMatrix(),Jm?Vy():_e(),ja())}function oP(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)aP(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")ky(1/1.15);else if(n.key==="-")ky(1.15);else if(n.key.toLowerCase()==="f")Hd(ko);else if(e)Qm(e);else return;n.preventDefault()}function aP(n,t){let e=ke.position.clone().sub(Tn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);ke.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(Tn.target),Tn.update(),_e()}function ky(n){ke.position.sub(Tn.target).multiplyScalar(n).add(Tn.target),Tn.update(),_e()}var ko=[[0,0,0],[0,0,1]];function jy(n,t){let e=new Fi().setFromPoints(n.map(u=>new H(...u))),i=e.getCenter(new H),s=new H(...t).normalize(),r=new H().crossVectors(ke.up,s).normalize(),o=new H().crossVectors(s,r),a=Math.tan(ao.degToRad(zy/2))*.8,l=a*ke.aspect,c=e.getSize(new H).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,m=1/0,_=-1/0;for(let p of n){let g=new H(...p).sub(i),x=g.dot(r),E=g.dot(o),b=g.dot(s);h=Math.max(h,b+Math.abs(x)/l,b+Math.abs(E)/a),d=Math.min(d,E),f=Math.max(f,E),m=Math.min(m,x),_=Math.max(_,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(m+_)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var jm=0;function zd({target:n,position:t},e=.35){let i={t:Tn.target.clone(),p:ke.position.clone()},s=performance.now(),r=++jm,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==jm)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);Tn.target.lerpVectors(i.t,n,u),ke.position.lerpVectors(i.p,t,u);let h=ke.position.distanceTo(Tn.target);ke.near=h/100,ke.far=h*30,hn.fog.near=h*1.3,hn.fog.far=h*3.4,ke.updateProjectionMatrix(),Tn.update(),_e(),c<1&&requestAnimationFrame(a)})(s)}function Hd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){ko=n,i||(Bo=null),Fc=!1;let s=e?Hy[e]:ke.position.clone().sub(Tn.target).toArray();zd(jy(n,s),t?0:.35)}function Qm(n){Fc=!1,Bo=null,zd(jy(ko,Hy[n]))}var Fc=!1;function Jy(){ke.updateMatrixWorld();let n=new H;return ko.every(t=>(n.set(...t).project(ke),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function ja(){Fc||!Tn.enabled||!ko.length||Jy()||(Bo??={position:ke.position.clone(),target:Tn.target.clone()},Hd(ko,{byItself:!0}))}var Bo=null;function Ky(){if(!Bo||Fc||!Tn.enabled)return;let n=Bo;Bo=null,zd(n),setTimeout(ja,500)}var tg=n=>{ko=n},Gd=()=>[...ke.position.toArray(),...Tn.target.toArray()].map(n=>Number(n.toPrecision(5)));function Qy(n){jm+=1,zd({position:new H(...n.slice(0,3)),target:new H(...n.slice(3))},0)}var sr=null,eg={cell:.1};function ng(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;eg.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new te(Bt.gridFine),l=new te(Bt.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}sr?.geometry.dispose();let c=new be;c.setAttribute("position",new Ee(r,3)),c.setAttribute("color",new Ee(o,3)),sr?sr.geometry=c:(sr=new Po(c,new Ki({vertexColors:!0})),sr.renderOrder=-2,sr.material.depthWrite=!1,hn.add(sr)),sr.userData.reach=n,_e()}function ig(){hn.background=new te(Bt.ground),hn.fog.color.set(Bt.ground),sr&&ng(sr.userData.reach),_e()}function ki(n){ke.updateMatrixWorld();let t=new H(...n).project(ke),e=ds.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Vd(n){let t=n.joints.length,e=li(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function sg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=vp(n,t),u=(d,f,m,_=!0,p=m)=>{as(Ni(f,d))<=l||(s.rods.push({a:d,b:f,r:m,far:p}),_&&s.balls.push({at:f,r:p}))};a&&(s.pedestal={at:ee(t[0]),dir:Ws(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:m},_)=>{let p=r[_],g=n.joints[_],x=ee(t[_]),E=ee(t[_+1]),b=p*.62,A=p*.84,T=(r[_+1]??e.rest)*.62,y=(r[_-1]??p)*.84;if(n.convention==="standard"){let X=Bl(x,f,Ol(Ni(E,x),f));u(x,X,b),u(X,E,A,!0,T)}else u(x,d,y,!0,b),u(d,E,b);let S=d,D=Ol(Ni(E,d),f);h&&as(Ni(d,h.at))<.5*p&&Math.abs(D)>l?S=Bl(d,f,Math.sign(D)*Math.min(Math.abs(D)*.55,h.r+p*1.15)):_===0&&Math.abs(D)>2.2*p&&(S=Bl(d,f,Math.sign(D)*p*1.25));let L=p*2.15,N=Ws(t[_+1],0),z=!!(i&&rg(g,i[_])),G=Ws(t[0],2),B=Ol(Ni(S,ee(t[0])),G)-L/2;_===0&&g.type==="R"&&Math.abs(Ol(f,G))>.99&&B<0&&B>-L&&(S=Bl(S,G,-B)),g.type==="R"?s.drums.push({at:S,dir:f,x:m,turned:N,r:p,h:L,beyond:z,joint:_}):s.sleeves.push({at:S,dir:f,x:m,r:p*.95,h:p*3.4,beyond:z,joint:_}),h={at:d,r:p}}),a){let d=t[a+1],f=ee(t[a]);s.flange={at:f,dir:Ws(t[a],2),turned:Ws(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,ee(d),e.rest*.34,!1),s.tip={at:ee(d),r:e.rest*.42}}return s}function rg(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function Oc(n,t){let e=Vd(n).radius[0]??.05,i=ee(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(ee)];for(let{point:r}of vp(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function cP(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new xc(s.map(([a,l])=>new Xt(a,l)),n):new Ai(1,1,1,n),o={rod:i(new Ai(1,1,1,n,1,!0)),ball:t>3?new Es(1,n,t):new _c(1,0),drum:i(r),box:new Oi(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var tv=new Map,cg=(n,t)=>tv.get(n)??tv.set(n,cP(n,t)).get(n),uP=()=>cg(26,12),og=()=>cg(11,5),ev=()=>cg(6,3),qd=class{constructor(t){this.mesh=new Ye(new be,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new be,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new Oe(c,l).setUsage(Ed);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new Oe(o,1).setUsage(Ed)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let m=t.at[d+2]>0?c:a,_=m*t.at[d],p=m*t.at[d+1],g=l*t.at[d+2],x=t.normal[d]/a,E=t.normal[d+1]/a,b=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*_+r[A]*p+o[A]*g,this.normal[f+A]=s[A]*x+r[A]*E+o[A]*b}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},iv=[1,0,0],hP=[0,1,0],sv=[0,0,1];function dP(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:wu(n,Math.abs(n[2])<.9?sv:iv),i=wu(n,e),s=as(i)||1,r=i.map(o=>o/s);return[wu(r,n),r]}var ag=0,Wd=1,lg=2,nv=3,Ja=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new En,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new qd(t),this.group.add(this.body.mesh),e&&(this.flat=new qd(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?ev:og:this.moving?og:uP;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?ev():og(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,u,h,d,f,m,_,p)=>t.put(c,u,h,...dP(d,_),d,f,m,p),l=(c,u,h)=>t.put(i.ball,c,u,iv,hP,sv,h,h);for(let{a:c,b:u,r:h,far:d}of e.rods){let f=Ni(u,c),m=as(f),_=[(c[0]+u[0])/2,(c[1]+u[1])/2,(c[2]+u[2])/2];a(i.rod,ag,_,f.map(p=>p/m),r*h,m,null,r*(d??h))}for(let{at:c,r:u}of e.balls)l(ag,c,r*u);for(let{at:c,dir:u,turned:h,r:d,h:f,beyond:m}of e.drums){if(a(i.drum,m&&o?nv:Wd,c,u,r*d,r*f),!o)continue;a(i.rod,lg,c,u,d*1.012,f*.13);let _=[0,1,2].map(p=>c[p]+h[p]*d*.96);a(i.box,ag,_,u,d*.11,f*.86,h)}for(let{at:c,dir:u,x:h,r:d,h:f,beyond:m}of e.sleeves)a(i.box,m&&o?nv:Wd,c,u,r*d,r*f,h);if(e.pedestal&&!this.veil){let{at:c,dir:u,r:h,h:d}=e.pedestal;a(i.drum,Wd,[c[0]+u[0]*d/2,c[1]+u[1]*d/2,c[2]+u[2]*d/2],u,h,d)}if(e.flange&&a(i.drum,Wd,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:c,dir:u,turned:h,r:d,h:f}=e.flange;a(i.box,lg,[0,1,2].map(m=>c[m]+h[m]*d*.95),u,d*.16,f*1.04,h)}e.tip&&o&&l(lg,e.tip.at,e.tip.r)}};var fP=`
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
  }`,rv=`
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
  }`,pP=`
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
  }`,mP=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function $d({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new Ri({vertexShader:e?pP:fP,fragmentShader:e?mP:rv,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new te)},opacity:{value:n},gloss:{value:t},sky:{value:new te(.46,.46,.47)},ground:{value:new te(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function ov(){let n=new Ri({vertexShader:`
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
      }`,fragmentShader:rv.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:hi,uniforms:{colour:{value:new te},opacity:{value:1},gloss:{value:.14},sky:{value:new te},ground:{value:new te}}});return n.colour=n.uniforms.colour.value,n.see=(t,e)=>{n.uniforms.opacity.value=t,n.transparent=t<1,n.uniforms.sky.value.setScalar(e?.4:.47),n.uniforms.ground.value.setScalar(e?.13:.2)},n}function ug(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new be;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let m in h.attributes){if(!i.has(m))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+m+'" attribute exists among all geometries, or in none of them.'),null;r[m]===void 0&&(r[m]=[]),r[m].push(h.attributes[m]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let m in h.morphAttributes){if(!s.has(m))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[m].length!==n[0].morphAttributes[m].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+m+'" morph attribute.'),null;o[m]===void 0&&(o[m]=[]),o[m].push(h.morphAttributes[m]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let m;if(e)m=h.index.count;else if(h.attributes.position!==void 0)m=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,m,u),c+=m}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let m=0;m<f.count;++m)h.push(f.getX(m)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=av(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let _=0;_<o[u].length;++_)f.push(o[u][_][d]);let m=av(f);if(!m)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(m)}}}return l}function av(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new Oe(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let m=0;m<e;m++){let _=u.getComponent(d,m);a.setComponent(d+h,m,_)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var Pr=Dd.axes;function hg(n,t){let e=new Ai(.028,.028,.82,8).translate(0,.41,0),i=new Lo(.085,.22,12).translate(0,.9,0),s=ug([e,i]).applyMatrix4(t),r=new te(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new Oe(o,3)),s}var dg=n=>new ge().makeRotationFromQuaternion(new un().setFromUnitVectors(new H(0,1,0),new H(...n))),gP=ug([hg(Pr[0],dg([1,0,0])),hg(Pr[1],dg([0,1,0])),hg(Pr[2],dg([0,0,1]))]),lv=.021,Bc=new Map;function xP(n){let t=`${n}/${Bt.dark}`;if(Bc.has(t))return Bc.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=Bt.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=Bt.ink,s.fillText(n,e.width/2,e.height/2);let o=new fc(e);o.colorSpace=ii;let a=new Ba({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,Bc.set(t,a),a}var Ka=class{constructor(){this.group=new En,this.mesh=new hc(gP,new ri({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new ge;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new H(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new cc);a.parent||this.group.add(a),a.material=xP(r),a.scale.set(lv*a.material.userData.aspect,lv,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of Bc.values())t.map.dispose(),t.dispose();Bc.clear(),this.last&&this.show(...this.last)}};var pg=180/Math.PI,zi={angle:"deg",length:"mm"},_P={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},fg={deg:pg,rad:1,mm:1e3,m:1},yP={deg:2,rad:4,mm:2,m:5},vP={deg:1,rad:.02,mm:5,m:.005},xt={get angle(){return zi.angle},get length(){return zi.length},set(n,t){t in fg&&n in zi&&(zi[n]=t)},factor:n=>n in zi?fg[zi[n]]:1,symbol:n=>n in zi?_P[zi[n]]:"",digits:n=>n in zi?yP[zi[n]]:4,step:n=>n in zi?vP[zi[n]]/fg[zi[n]]:.01,suffix:n=>n==="angle"?{deg:pg,"\xB0":pg,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ti(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var xn=(n,t,e=xt.digits(t))=>ti(n*xt.factor(t),e),ue=(n,t,e)=>`${xn(n,t,e)}${t==="angle"&&zi.angle==="deg"?"":" "}${xt.symbol(t)}`,kc=(n,t="plain")=>String(Number((n*xt.factor(t)).toPrecision(9))+0),Xd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function Qa(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||xt.digits(t))/xt.factor(t)}var bP={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},MP={theta:(n,t,e)=>`turn by \u03B8${n} = ${ue(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${ue(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${ue(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${ue(t,"angle")} about x`};function cv(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=bP[n.convention],o=pr(n.joints[i],mr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:yx(n.convention,a.a,a.alpha,a.d,a.theta)}}function uv(){let n=v("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>v("button",{type:"button",text:o,"aria-label":a,on:{click:()=>i(l())}}),e=()=>4*M.table.joints.length-1,i=o=>{M.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ht("frames")},s=v("details",{class:"fold","data-testid":"dh-steps"},v("summary",{text:"The frames, one step at a time"}),v("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(M.dhStep??1)-1),t("On","One step on",()=>(M.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(M.dhStep===null||!M.table.joints.length){M.dhStep=null,gt(n,"");return}M.dhStep=Math.min(M.dhStep,e());let{i:o,key:a,value:l}=cv(M.table,M.q,M.dhStep),c=M.table.convention==="standard"?o:o+1;gt(n,`Joint ${o+1}, ${M.dhStep%4+1} of 4: ${MP[a](o+1,l,c)}`)};return nt(["q","table","units"],()=>M.dhStep!==null&&r()),nt("panel",o=>{o!=="table"&&M.dhStep!==null&&(s.open=!1,i(null))}),s}function Yd(){let{i:n,A:t}=cv(M.table,M.q,M.dhStep);return[...M.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:ni(M.frames[n],t),name:`\u2192 ${n+1}`}]}var mg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],tl=n=>[Math.cos(n),Math.sin(n)];function SP([n,t,e]){let[i,s]=tl(e),[r,o]=tl(t),[a,l]=tl(n);return mg([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function wP(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function EP([n,t,e]){let[i,s]=tl(n),[r,o]=tl(t),[a,l]=tl(e);return mg([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function TP(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Zd(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function zc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return mg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function AP(n){let[t,e,i,s]=Zd(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function RP([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:zc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Cs={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:wP,from:SP},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:TP,from:EP},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:AP,from:RP},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Zd,from:zc}};function hv(n,t,e){let i=Cs[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function jd(n,t,e){let i=Zd(n),s=Zd(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=zc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var el=.145,Qd=.105,Sg=.165,dv={mouse:13,pen:16,touch:28},CP=.2,uo=["x","y","z"],Gc=72,zo=new En,Kd=new Map,yg="both",tf="local",wg=0,Ir=!1,vg=null,tn=null,ef=()=>tn!==null,xv=()=>Ir,lo=null,co=null;function _v(){zo.visible=!1,hn.add(zo),qy(Eg),co=document.getElementById("view"),lo=v("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(lo),co.addEventListener("pointerdown",FP,!0),co.addEventListener("pointermove",BP,!0);for(let n of["pointerup","pointercancel"])co.addEventListener(n,Tv,!0);addEventListener("keydown",n=>n.key==="Escape"&&tn&&zP()),nt(["target","theme"],_e)}function Hc(n,t,e=8){let i=new ri({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new Ye(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var PP=[new un().setFromUnitVectors(new H(0,1,0),new H(1,0,0)),new un,new un().setFromUnitVectors(new H(0,1,0),new H(0,0,1))],IP=[new un().setFromUnitVectors(new H(0,0,1),new H(1,0,0)),new un().setFromUnitVectors(new H(0,0,1),new H(0,1,0)),new un];function LP(){if(Kd.size)return;let n=(t,e)=>{Kd.set(t,e),zo.add(e)};uo.forEach((t,e)=>{let i=new Ai(.0032,.0032,el*.8,8).translate(0,el*.45,0),s=new Lo(.0125,.034,14).translate(0,el*.9,0),r=new En;r.add(Hc(i,Pr[e]),Hc(s,Pr[e])),r.userData.turn=PP[e],n(`move-${t}`,r);let o=Hc(new za(Qd,.0026,6,Gc),Pr[e],7);o.userData.turn=IP[e],n(`turn-${t}`,o)}),n("turn-view",Hc(new za(Sg,.0022,6,Gc),"#8891a0",7)),n("move-view",Hc(new Es(.0115,14,10),"#8891a0",9))}var Jd=new H,ho=new H,gg=new un;function nf(){return 2*Math.tan(ao.degToRad(ke.fov/2))*ke.position.distanceTo(Jd)}var Wc=()=>tf==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):DP(),DP=()=>[0,1,2].map(n=>Ws(M.target,n)),NP=new ge;function Eg(){if(zo.visible=Ir,!Ir)return;Jd.set(...ee(M.target)),ho.copy(ke.position).sub(Jd).normalize(),tf==="world"?gg.identity():gg.setFromRotationMatrix(NP.set(...M.target)),zo.position.copy(Jd),zo.scale.setScalar(nf());let n=Wc();for(let[t,e]of Kd){let[i,s]=t.split("-"),r=uo.indexOf(s),o=yg==="both"||yg===i;e.visible=o&&UP(i,n[r])&&(!tn||tn.name===t),s==="view"?e.quaternion.copy(ke.quaternion):e.quaternion.copy(gg).multiply(e.userData.turn);let a=t===(tn?.name??vg);e.traverse(l=>l.material?.color.set(a?Bt.accent:l.userData.colour))}}function UP(n,t){return!t||n!=="move"?!0:Math.hypot(...yv(t,ho.toArray()))>CP}var yv=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Vc=(n,t)=>ee(M.target).map((e,i)=>e+t*n[i]);function bg(n,t){let e=Wc(),[i,s]=n<0?[fv(ke.matrixWorld,0),fv(ke.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Gc+1},(r,o)=>{let a=2*Math.PI*o/Gc,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:Vc(l,t),front:n<0||l.reduce((c,u,h)=>c+u*ho.getComponent(h),0)>-.15}})}var fv=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function pv(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function Mg(n,t){let e=nf(),i=[];for(let[s,r]of Kd){if(!r.visible)continue;let[o,a]=s.split("-"),l=uo.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=ki(ee(M.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=Wc()[l],h=ki(Vc(u,.92*el*e));c=Math.min(pv(n,t,ki(Vc(u,.3*el*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=bg(l,(l<0?Sg:Qd)*e).map(h=>({...h,s:ki(h.p)}));for(let h=0;h<Gc;h++)u[h].front&&(c=Math.min(c,pv(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function vv(n){if(!Ir)return null;Eg();let[t]=Mg(n.clientX,n.clientY);return t&&t[1]<=(dv[n.pointerType]??dv.mouse)?t[0]:null}function bv(){if(!Ir)return{};Eg();let n=nf(),t=Wc(),e={"move-view":ki(ee(M.target))};return uo.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>ki(Vc(t[s],c*el*n))).find(([c,u])=>Mg(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=bg(s,Qd*n).filter(c=>c.front).map(c=>ki(c.p)).filter(([c,u])=>Mg(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=ki(bg(-1,Sg*n)[9].p),e}var mv=new Mc,gv=new Xt;function Mv(n){let t=es.domElement.getBoundingClientRect();return gv.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),mv.setFromCamera(gv,ke),mv.ray}function Sv(n,t,e){let{origin:i,direction:s}=Mv(e),r=new H(...n),o=new H(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function wv(n,t,e){let i=new si().setFromNormalAndCoplanarPoint(n,new H(...t));return Mv(e).intersectPlane(i,new H)}function FP(n){if(n.button!==0)return;let t=vv(n);if(!t)return;n.stopPropagation(),n.preventDefault(),co.focus({preventScroll:!0}),co.setPointerCapture(n.pointerId),Tn.enabled=!1;let[e,i]=t.split("-"),s=uo.indexOf(i),r=s<0?ho.toArray():Wc()[s].slice();tn={name:t,what:e,axis:r,i:s,T:M.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},tn.start=e==="turn"?Ev(n):s<0?wv(ho,ee(tn.T),n):Sv(r,ee(tn.T),n),_e()}function Ev(n){let[t,e]=ki(ee(tn.T)),i=tn.axis.reduce((h,d,f)=>h+d*ho.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=yv(tn.axis,ho.toArray()),r=nf(),o=ki(ee(tn.T)),a=ki(Vc(s,Qd*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-tn.x)*l+(n.clientY-tn.y)*c)/(u*u)}var OP=n=>Math.atan2(Math.sin(n),Math.cos(n)),xg=(n,t,e)=>{let i=wg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function BP(n){if(!tn){if(n.buttons||!Ir)return;let l=vv(n);l!==vg&&(vg=l,co.style.setProperty("cursor",l?"grab":""),_e());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=tn,r=tf==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Ev(n);tn.total+=OP(l-(tn.before??tn.start)),tn.before=l;let c=xg(tn.total,n,Math.PI/180),u=Math.sin(c/2);o=ni(zc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${_g(c,"angle")} about ${s<0?"the line of sight":r+uo[s]}`}else if(s<0){let l=wv(ho,ee(t),n);if(!l)return;let c=l.sub(tn.start);(wg||n.shiftKey)&&c.set(...c.toArray().map(u=>xg(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${uo[h]} ${_g(u,"length")}`).join(", ")}else{let l=xg(Sv(e,ee(t),n)-tn.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${_g(l,"length")} along ${r}${uo[s]}`}vi(o,"drag"),kP(a,n),_e()}var _g=(n,t)=>`${n>=0?"+":""}${ue(n,t,xt.digits(t))}`;function kP(n,t){let e=co.getBoundingClientRect();lo.hidden=!1,gt(lo,n),lo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-lo.offsetWidth-8)}px`),lo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Tv(n){tn&&(n.stopPropagation(),tn=null,lo.hidden=!0,Tn.enabled=!0,vi(M.target,"dropped"),_e())}function zP(){let{T:n}=tn;vi(n,"drag"),Tv({stopPropagation(){}})}function Av(){Ir&&LP(),zo.visible=Ir,ht("frames"),_e()}function Rv(n){Ir=n,Av()}function Cv(n){yg=n,Av()}function Pv(n){tf=n,_e()}function Iv(n){wg=n}var Fv=$d(),Dv=[.32,-.4,1],af=new ri({color:"#000",transparent:!0,opacity:.1,side:hi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Sm,stencilRef:1,stencilZPass:Mm,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),Rg=new ge().set(1,0,-Dv[0],0,0,1,-Dv[1],0,0,0,0,5e-4,0,0,0,1),nl=new Ye(new gc(1,40),new Ri({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));nl.renderOrder=-1;function HP(){let n=M.frames[0],t=2*(rr.radius[0]??0);nl.visible=M.table.joints.length>0&&Math.abs(n[11])<.02*rr.size&&n[10]>.99,nl.position.set(n[3],n[7],4e-4*rr.size),nl.scale.set(1.6*t,1.6*t,1)}var Xc=new Ja(Fv,{shadow:{material:af,matrix:Rg}});function Ov(n,t){Xc.shown(n,n&&!t)}var Bv=$d({opacity:.2,veil:!0}),sf=new Ja(Bv,{veil:!0}),kv=$d({opacity:.62,gloss:.1}),Ag=new Ja(kv,{veil:!0}),lf=new Ka,rr=Vd(M.table),cf=[],of=null;function zv(){hn.add(nl,Xc.group,sf.group,Ag.group,lf.group),sf.group.renderOrder=1,nt("table",n=>{rr=Vd(M.table),ng(rr.size),cf=[],of=null,Cg(),hf(),n==="new"&&Yc({instant:!0,view:"iso"}),$y()}),nt("q",VP),nt("frames",Vv),nt("theme",Uv),nt("hurry",n=>{for(let t of[Xc,sf,Ag])t.hurry(n)}),Uv()}var Nv=new Map,$c=[],Tg=0;function Dr(n,t){if(Nv.set(n,t),$c=[...Nv.values()].flat(),!M.table.joints.length)return;let e=Tg;Tg=$c.length,tg([...Oc(M.table,M.frames),...$c]),t.length?Gv():e>Tg&&GP()}var GP=Ys(Ky,120);function Hv(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Dr("motion",i.flatMap(s=>Oc(n,vs(n,s))))}function Yc(n){Hd([...Oc(M.table,M.frames),...$c],n)}var Gv=Ys(ja,220);function VP(){let n=M.frames;Xc.show(M.table.joints.length?[sg(M.table,n,rr,M.q)]:[]),HP(),tg([...Oc(M.table,n),...$c]),Gv(),Zv&&WP(ee(n[n.length-1])),Vv()}function Vv(){let n=(M.shownFrames??[]).filter(t=>t<M.frames.length&&!(t===M.frames.length-1&&xv())).map(t=>({T:M.frames[t],name:uf(t)}));lf.show(M.dhStep===null?n:Yd(),rr.size*.13),_e()}var Wv=()=>Xc.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),qv=()=>(lf.last?.[0]??[]).map(n=>n.name);function uf(n){let t=M.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function $v(n){cf=n,Cg()}function fs(n){of=n,Cg()}var Xv=()=>cf.length;function Cg(){let n=t=>sg(M.table,vs(M.table,t),rr);sf.show(cf.map(n)),Ag.show(of?[n(of)]:[]),_e()}var Yv=6e3,rf=new Float32Array(6*Yv),Lr=new Po(new be,new Ki({fog:!1}));Lr.geometry.setAttribute("position",new Oe(rf,3));Lr.frustumCulled=!1;Lr.visible=!1;var fo=0,Zv=!0,qc=null;hn.add(Lr);function WP(n){let t=qc?as(Ni(n,qc)):1/0;t<rr.size*.002||(t<rr.size*.2&&(fo===Yv&&(rf.copyWithin(0,6*1e3),fo-=1e3),rf.set(qc,6*fo),rf.set(n,6*fo+3),fo+=1,Lr.geometry.setDrawRange(0,2*fo),Lr.geometry.attributes.position.needsUpdate=!0,Lr.visible=!0),qc=n)}function jv(n){Zv=n,n||hf(),_e()}function hf(){fo=0,qc=null,Lr.visible=!1,_e()}var Jv=()=>fo,Zc=new Qs(new be,new Ki({fog:!1}));Zc.frustumCulled=!1;var jc=new Er(new be,new tr({size:4,sizeAttenuation:!1,fog:!1}));jc.frustumCulled=!1;Zc.visible=jc.visible=!1;hn.add(Zc,jc);function Ho(n){Dr("path",n);let t=new Float32Array(n.flat());for(let e of[Zc,jc])e.geometry.dispose(),e.geometry=new be,e.geometry.setAttribute("position",new Oe(t,3)),e.visible=n.length>0;_e()}function Uv(){Fv.repaint(Bt.link,Bt.joint,Bt.accent,Bt.dark,Bt.wrong),Bv.repaint(Bt.ghost,Bt.ghost,Bt.ghost,Bt.dark),kv.repaint(Bt.accent,Bt.accent,Bt.accent,Bt.dark),Lr.material.color.set(Bt.accent),Zc.material.color.set(Bt.trace),jc.material.color.set(Bt.trace),af.opacity=Bt.dark?.28:.11,nl.material.uniforms.strength.value=Bt.dark?.75:.34,lf.paint(),_e()}var he={follow:!0,ghosts:"all",task:null,redundancy:null},Pg={answers:0},df=!1,Kv=qs(async()=>{let n=df;df=!1;let t=M.target,e=M.table;try{let i=ef()||Ig,s=i?null:M.digits,{task:r,redundancy:o}=he,a=await He("ik",{T:t,q:M.q,brief:i,task:r,redundancy:o,digits:s});if(e!==M.table||t!==M.target&&!i)return;Pg.answers+=1,M.solutions={...a,T:t,brief:i},n&&he.follow&&a.nearest&&Ui(a.nearest,"follow"),il(),ht("solutions"),!i&&!a.rows.some(l=>l.inside)&&XP(t),a.self_motions===null&&!i&&$P(M.solutions)}catch(i){if(i instanceof Cu)return;M.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},il(),ht("solutions")}}),Ig=!1;function Qv(){Ig=!0,df=!0,Kv()}function Ps({follow:n=!1}={}){Ig=!1,df||=n,Kv()}var $P=qs(async n=>{try{let t={T:n.T,q:M.q,task:he.task,redundancy:he.redundancy},{self_motions:e}=await He("self_motions",t);if(M.solutions!==n||!e)return;n.self_motions=e,ht("solutions")}catch{}}),XP=qs(async n=>{try{let t=await He("nearest",{T:n,task:he.task});M.solutions&&M.solutions.T===n&&(M.solutions.near=t,ht("solutions"))}catch{}}),YP=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function il(){let n=M.solutions?.rows??[],t=M.panel==="inverse"&&he.ghosts!=="none"?n.filter(e=>(he.ghosts==="all"||e.inside)&&!YP(e.q,M.q)):[];$v(t.map(e=>e.q))}function tb(){nt("target",n=>{M.panel==="inverse"&&Ps({follow:wx.has(n)})}),nt("task",()=>{ht("plan"),M.panel==="inverse"&&M.hasTarget&&Ps()}),nt("panel",n=>{fs(null),n==="inverse"&&M.hasTarget&&!M.solutions&&Ps(),il()}),nt("moving",n=>{n||il()}),nt("table",n=>{he.redundancy=null,n==="new"&&(he.task=null),ht("solutions"),n!=="new"&&M.panel==="inverse"&&M.hasTarget&&Ps()}),nt("online",n=>{n&&M.panel==="inverse"&&M.hasTarget&&M.table.joints.length&&Ps()})}var Jc=0;function fi(){Jc+=1,M.moving&&(M.moving=!1,ht("moving",!1))}function Pi(n,t=.8,e="move to a posture"){fi(),ht("let-go"),ht("did",{label:e});let i=M.q.slice(),s=Jc,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),M.moving=!0,ht("moving",!0),new Promise(o=>{(function a(l){if(s!==Jc||i.length!==M.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Ui(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(M.moving=!1,ht("moving",!1),o(!0))})(r)})}function eb(n,t,e,i){fi();let s=Jc,r=performance.now()-1e3*n*t;M.moving=!0,ht("moving",!0),requestAnimationFrame(function o(a){if(s!==Jc){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(M.moving=!1,ht("moving",!1),i?.(!0))})}var jP=200,JP=1500,Go=[],tu=[],Qc=null,Kc={key:null,at:0,open:!1},Lg=!1,ff=()=>({table:M.table,q:M.q,target:M.target,digits:M.digits,hasTarget:M.hasTarget,path:{...M.path},sequence:structuredClone(M.sequence),program:M.program,world:M.world,limits:M.limits,start:M.start,routing:M.routing,task:he.task,redundancy:he.redundancy});function Dg(){Lg||(Lg=!0,queueMicrotask(()=>{Lg=!1,Qc=ff()}))}function KP({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===Kc.key&&(Kc.open||i-Kc.at<JP))&&Qc&&(Go.push({label:n,before:Qc}),Go.length>jP&&Go.shift(),tu.length=0),Kc={key:t,at:i,open:e},Dg(),ht("history")}function Ng(){Kc={key:null,at:0,open:!1}}function QP(n){fi(),Ng(),he.task=n.task,n.table!==M.table?mn(n.table,{q:n.q,step:!1,what:"undo"}):Ui(n.q,"undo"),he.redundancy=n.redundancy,Object.assign(M.path,n.path),M.sequence=structuredClone(n.sequence),M.program=n.program,M.world=n.world,M.limits=n.limits,M.start=n.start;let t=M.routing!==n.routing;M.routing=n.routing,M.hasTarget=n.hasTarget,n.target!==M.target&&vi(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ht(e,"undo");t&&ht("routing","undo")}function nb(n,t,e){let i=n.pop();if(!i)return;let s=ff();QP(i.before),t.push({label:i.label,before:s}),Dg(),ht("history"),Pe(`${e}: ${i.label}`)}var Ug=()=>nb(Go,tu,"Undone"),Fg=()=>nb(tu,Go,"Redone"),pf=()=>Go.at(-1)?.label??null,mf=()=>tu.at(-1)?.label??null;function gf(){Go.length=0,tu.length=0,Ng(),Qc=ff(),ht("history")}function ib(){Qc=ff(),nt("did",KP),nt("let-go",Ng),nt(["table","q","target","path","sequence","program","world","task","routing"],Dg)}var ob=1,ab=30;function xf(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=M;return{pieper:ob,table:n,q:t,target:i?e:null,digits:M.digits,task:he.task,redundancy:he.redundancy,follow:he.follow,ghosts:he.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:M.program,start:M.start,limits:M.limits},world:M.world,routing:M.routing,look:M.look,panel:l,theme:c,units:[xt.angle,xt.length],camera:Gd()}}var Vn=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,Is=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Vn),ps=(n,t)=>typeof n=="string"?n.slice(0,t):"",Nr=n=>{if(!Is(n,16))return null;let t=Eu(n);return t<1e-12?n.slice():t<.001?Tu(n):null},eI=n=>n&&Vn(n.metres)&&Vn(n.radians)?{metres:n.metres,radians:n.radians}:null,nI=n=>n&&[n.lower,n.upper,n.value].every(Vn)&&n.lower<=n.upper?{name:ps(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:ps(n.unit,10)}:null,iI=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>Is(e,t))?n:null;function sI(n){if(!n||!Array.isArray(n.joints)||n.joints.length>ab||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Vn(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:ps(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Vn(i.lower)?i.lower:null,upper:Vn(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>Is(i,t.length)).slice(0,40));return{name:ps(n.name,60),convention:n.convention,joints:t,base:Nr(n.base)??fr(),tool:Nr(n.tool)??fr(),postures:e,manufacturer:ps(n.manufacturer,200),source:ps(n.source,2e3),notes:ps(n.notes,3e3),actuator:nI(n.actuator),catalog:ps(n.catalog,60)||void 0,derived:ps(n.derived,60)||void 0,coupling:iI(n.coupling,t.length)}}var sb={joint:0,line:0,circle:0,wait:"seconds",gripper:"value",output:"port"};function rI(n,t){if(!n||!Object.hasOwn(sb,n.kind))return null;let e=sb[n.kind];if(e)return Vn(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;let i=n.kind==="joint"&&Is(n.q,t)?n.q.slice():null,s=Nr(n.T);if(!s||n.kind==="circle"&&!Nr(n.via))return null;let r=(o,a)=>a===null?{}:{[o]:a};return{kind:n.kind,...r("q",i),T:s,...r("via",Nr(n.via)),...r("speed",Vn(n.speed)&&n.speed>0?n.speed:null),blend:Vn(n.blend)&&n.blend>=0?n.blend:0}}var Og={frame:[],box:["size"],cylinder:["r","h"]};function oI(n){if(!n||!Object.hasOwn(Og,n.kind))return null;let t=Nr(n.T),e=ps(n.name,40),i=s=>s==="size"?Is(n.size,3)&&n.size.every(r=>r>0):Vn(n[s])&&n[s]>0;return!t||!e||!Og[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(Og[n.kind].map(s=>[s,n[s]]))}}function aI(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&Vn(s.turn)&&Is(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:ps(s.branch,80)}:null,i=(s,r)=>Vn(s)&&s>=0&&s<r?s:0;return{turn:Is(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function lI(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};M.program=e(i.steps,s=>rI(s,t),200),M.start=Is(i.start,t)?i.start.slice():null,M.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||Vn(r)&&r>0))),M.world=e(n.world,oI,60),M.routing=aI(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&Vn(n.look.opacity)&&(M.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function _f(n,t){let e=n&&n.pieper===ob?sI(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(xt.set("angle",n.units[0]),xt.set("length",n.units[1])),Object.hasOwn(Cs,n.notation)&&(M.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Ud(n.theme),M.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};mn(e,{q:Is(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(M.path,{from:Nr(s.from),to:Nr(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:Vn(s.seconds)&&s.seconds>0?s.seconds:5}),M.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&Is(a.q,i)&&Vn(a.seconds)&&Vn(a.hold)).slice(0,40).map(a=>({name:ps(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),lI(n,i),["pose","position","position+axis"].includes(n.task)&&(he.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&Vn(l));he.redundancy=r.length?Object.fromEntries(r.slice(0,ab)):null,typeof n.follow=="boolean"&&(he.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(he.ghosts=n.ghosts);let o=Nr(n.target);M.hasTarget=!!o,o&&vi(o,"restored",eI(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ht(a);t(n.panel),ht("path-loaded"),ht("routing","loaded"),ht("look","loaded"),Is(n.camera,6)&&Qy(n.camera),Ui(M.q,"restored"),gf()}async function lb(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function yf(){let n=await lb(new TextEncoder().encode(JSON.stringify(xf())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function cb(){let n=cI();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await lb(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var ub="pieper-workbench";function cI(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(ub)??"{}");return t&&n===location.href?t:null}catch{return null}}function uI(){if(M.table.joints.length)try{sessionStorage.setItem(ub,JSON.stringify({address:location.href,shown:xf()}))}catch{}}var rb=null,hI=Ys(async()=>{if(!M.table.joints.length)return;let n=await yf();n!==rb&&(rb=n,history.replaceState(null,"",n))},600);function hb(){addEventListener("pagehide",uI),nt(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],hI)}var fI="uplot",pI="u-hz",mI="u-vt",gI="u-title",xI="u-wrap",_I="u-under",yI="u-over",vI="u-axis",qo="u-off",bI="u-select",MI="u-cursor-x",SI="u-cursor-y",wI="u-cursor-pt",EI="u-legend",TI="u-live",AI="u-inline",RI="u-series",CI="u-marker",db="u-label",PI="u-value",nu="width",iu="height";var fb="bottom",sl="left",Bg="right",e0="#000",pb=e0+"0",kg="mousemove",mb="mousedown",zg="mouseup",gb="mouseenter",xb="mouseleave",_b="dblclick",II="resize",LI="scroll",yb="change",wf="dppxchange",n0="--",hl=typeof window<"u",qg=hl?document:null,ol=hl?window:null,DI=hl?navigator:null,ze,vf;function $g(){let n=devicePixelRatio;ze!=n&&(ze=n,vf&&Yg(yb,vf,$g),vf=matchMedia(`(min-resolution: ${ze-.001}dppx) and (max-resolution: ${ze+.001}dppx)`),$o(yb,vf,$g),ol.dispatchEvent(new CustomEvent(wf)))}function ns(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Xg(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function dn(n,t,e){n.style[t]=e+"px"}function Ls(n,t,e,i){let s=qg.createElement(n);return t!=null&&ns(s,t),e?.insertBefore(s,i),s}function ms(n,t){return Ls("div",n,t)}var vb=new WeakMap;function or(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=vb.get(n);r!=o&&(n.style.transform=r,vb.set(n,r),t<0||e<0||t>i||e>s?ns(n,qo):Xg(n,qo))}var bb=new WeakMap;function Mb(n,t,e){let i=t+e,s=bb.get(n);i!=s&&(bb.set(n,i),n.style.background=t,n.style.borderColor=e)}var Sb=new WeakMap;function wb(n,t,e,i){let s=t+""+e,r=Sb.get(n);s!=r&&(Sb.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var i0={passive:!0},NI={...i0,capture:!0};function $o(n,t,e,i){t.addEventListener(n,e,i?NI:i0)}function Yg(n,t,e,i){t.removeEventListener(n,e,i0)}hl&&$g();function Ds(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:is((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Kb(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Qb=n=>n!=null,tM=n=>n!=null&&n>0,Af=Kb(Qb),UI=Kb(tM);function FI(n,t,e,i=0,s=!1){let r=s?UI:Af,o=s?tM:Qb;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??en,l??-en]}function Rf(n,t,e,i){let s=Ab(n),r=Ab(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ur:eM,a=s==1?is:gs,l=r==1?gs:is,c=a(o(qn(n))),u=l(o(qn(t))),h=al(e,c),d=al(e,u);return e==10&&(c<0&&(h=nn(h,-c)),u<0&&(d=nn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=rM(n,h),t=Cf(t,d)),[n,t]}function s0(n,t,e,i){let s=Rf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var r0=.1,Eb={mode:3,pad:r0},ru={pad:0,soft:null,mode:0},OI={min:ru,max:ru};function Ef(n,t,e,i){return Pf(e)?Tb(n,t,e):(ru.pad=e,ru.soft=i?0:null,ru.mode=i?3:0,Tb(n,t,OI))}function Ue(n,t){return n??t}function BI(n,t,e){for(t=Ue(t,0),e=Ue(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Tb(n,t,e){let i=e.min,s=e.max,r=Ue(i.pad,0),o=Ue(s.pad,0),a=Ue(i.hard,-en),l=Ue(s.hard,en),c=Ue(i.soft,en),u=Ue(s.soft,-en),h=Ue(i.mode,0),d=Ue(s.mode,0),f=t-n,m=Ur(f),_=Ii(qn(n),qn(t)),p=Ur(_),g=qn(p-m);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=en&&(r=0),d==2&&u!=-en&&(o=0)));let x=f||_||1e3,E=Ur(x),b=al(10,is(E)),A=x*(f==0?n==0?.1:1:r),T=nn(rM(n-A,b/10),24),y=n>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:en,S=Ii(a,T<y&&n>=y?y:Ns(y,T)),D=x*(f==0?t==0?.1:1:o),L=nn(Cf(t+D,b/10),24),N=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-en,z=Ns(l,L>N&&t<=N?N:Ii(N,L));return S==z&&S==0&&(z=100),[S,z]}var kI=new Intl.NumberFormat(hl?DI.language:"en-US"),o0=n=>kI.format(n),ss=Math,Sf=ss.PI,qn=ss.abs,is=ss.floor,Wn=ss.round,gs=ss.ceil,Ns=ss.min,Ii=ss.max,al=ss.pow,Ab=ss.sign,Ur=ss.log10,eM=ss.log2,zI=(n,t=1)=>ss.sinh(n)*t,Hg=(n,t=1)=>ss.asinh(n/t),en=1/0;function Rb(n){return(Ur((n^n>>31)-(n>>31))|0)+1}function Zg(n,t,e){return Ns(Ii(n,t),e)}function nM(n){return typeof n=="function"}function Le(n){return nM(n)?n:()=>n}var HI=()=>{},iM=n=>n,sM=(n,t)=>t,GI=n=>null,Cb=n=>!0,Pb=(n,t)=>n==t,VI=/\.\d*?(?=9{6,}|0{6,})/gm,Xo=n=>{if(aM(n)||mo.has(n))return n;let t=`${n}`,e=t.match(VI);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Xo(s)}e${r}`}return nn(n,i)};function Vo(n,t){return Xo(nn(Xo(n/t))*t)}function Cf(n,t){return Xo(gs(Xo(n/t))*t)}function rM(n,t){return Xo(is(Xo(n/t))*t)}function nn(n,t=0){if(aM(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Wn(i)/e}var mo=new Map;function oM(n){return((""+n).split(".")[1]||"").length}function au(n,t,e,i){let s=[],r=i.map(oM);for(let o=t;o<e;o++){let a=qn(o),l=nn(al(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:nn(u,h);s.push(d),mo.set(d,h)}}return s}var ou={},a0=[],ll=[null,null],po=Array.isArray,aM=Number.isInteger,WI=n=>n===void 0;function Ib(n){return typeof n=="string"}function Pf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function qI(n){return n!=null&&typeof n=="object"}var $I=Object.getPrototypeOf(Uint8Array),lM="__proto__";function cl(n,t=Pf){let e;if(po(n)){let i=n.find(s=>s!=null);if(po(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=cl(n[s],t)}else e=n.slice()}else if(n instanceof $I)e=n.slice();else if(t(n)){e={};for(let i in n)i!=lM&&(e[i]=cl(n[i],t))}else e=n;return e}function On(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=lM&&(Pf(n[s])?On(n[s],cl(i[s])):n[s]=cl(i[s]))}return n}var XI=0,YI=1,ZI=2;function jI(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function JI(n,t){if(t3(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return e3(o[0])||(o=QI(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:YI,f=[];for(let m=0;m<u.length;m++){let _=u[m],p=r.get(l[m]);_===null?d!=XI&&(h[p]=_,d==ZI&&f.push(p)):h[p]=_}jI(h,f,s),i.push(h)}}return i}var KI=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function QI(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function t3(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function e3(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Ii(1,is((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var cM=["January","February","March","April","May","June","July","August","September","October","November","December"],uM=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function hM(n){return n.slice(0,3)}var n3=uM.map(hM),i3=cM.map(hM),s3={MMMM:cM,MMM:i3,WWWW:uM,WWW:n3};function eu(n){return(n<10?"0":"")+n}function r3(n){return(n<10?"00":n<100?"0":"")+n}var o3={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>eu(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>eu(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>eu(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>eu(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>eu(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>r3(n.getMilliseconds())};function l0(n,t){t=t||s3;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?o3[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var a3=new Intl.DateTimeFormat().resolvedOptions().timeZone;function l3(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==a3?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var dM=n=>n%1==0,Tf=[1,2,2.5,5],c3=au(10,-32,0,Tf),fM=au(10,0,32,Tf),u3=fM.filter(dM),Wo=c3.concat(fM),c0=`
`,pM="{YYYY}",Lb=c0+pM,mM="{M}/{D}",su=c0+mM,bf=su+"/{YY}",gM="{aa}",h3="{h}:{mm}",rl=h3+gM,Db=c0+rl,Nb=":{ss}",Ve=null;function xM(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?au(10,0,3,Tf).filter(dM):au(10,-3,0,Tf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,pM,Ve,Ve,Ve,Ve,Ve,Ve,1],[s*28,"{MMM}",Lb,Ve,Ve,Ve,Ve,Ve,1],[s,mM,Lb,Ve,Ve,Ve,Ve,Ve,1],[i,"{h}"+gM,bf,Ve,su,Ve,Ve,Ve,1],[e,rl,bf,Ve,su,Ve,Ve,Ve,1],[t,Nb,bf+" "+rl,Ve,su+" "+rl,Ve,Db,Ve,1],[n,Nb+".{fff}",bf+" "+rl,Ve,su+" "+rl,Ve,Db,Ve,1]];function u(h){return(d,f,m,_,p,g)=>{let x=[],E=p>=o,b=p>=r&&p<o,A=h(m),T=nn(A*n,3),y=Gg(A.getFullYear(),E?0:A.getMonth(),b||E?1:A.getDate()),S=nn(y*n,3);if(b||E){let D=b?p/r:0,L=E?p/o:0,N=T==S?T:nn(Gg(y.getFullYear()+L,y.getMonth()+D,1)*n,3),z=new Date(Wn(N/n)),G=z.getFullYear(),B=z.getMonth();for(let X=0;N<=_;X++){let P=Gg(G+L*X,B+D*X,1),U=P-h(nn(P*n,3));N=nn((+P+U)*n,3),N<=_&&x.push(N)}}else{let D=p>=s?s:p,L=is(m)-is(T),N=S+L+Cf(T-S,D);x.push(N);let z=h(N),G=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,B=p/i,X=d.axes[f]._space,P=g/X;for(;N=nn(N+p,n==1?0:3),!(N>_);)if(B>1){let U=is(nn(G+B,6))%24,j=h(N).getHours()-U;j>1&&(j=-1),N-=j*i,G=(G+B)%24;let et=x[x.length-1];nn((N-et)/p,3)*P>=.7&&x.push(N)}else x.push(N)}return x}}return[l,c,u]}var[d3,f3,p3]=xM(1),[m3,g3,x3]=xM(.001);au(2,-53,53,[1]);function Ub(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Fb(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,d,f;return i.map(m=>{let _=n(m),p=_.getFullYear(),g=_.getMonth(),x=_.getDate(),E=_.getHours(),b=_.getMinutes(),A=_.getSeconds(),T=p!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||E!=h&&a[5]||b!=d&&a[6]||A!=f&&a[7]||a[1];return l=p,c=g,u=x,h=E,d=b,f=A,T(_)})}}function _3(n,t){let e=l0(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Gg(n,t,e){return new Date(n,t,e)}function Ob(n,t){return t(n)}var y3="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Bb(n,t){return(e,i,s,r)=>r==null?n0:t(n(i))}function v3(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function b3(n,t){return n.series[t].fill(n,t)}var M3={show:!0,live:!0,isolate:!1,mount:HI,markers:{show:!0,width:2,stroke:v3,fill:b3,dash:"solid"},idx:null,idxs:null,values:[]};function S3(n,t){let e=n.cursor.points,i=ms(),s=e.size(n,t);dn(i,nu,s),dn(i,iu,s);let r=s/-2;dn(i,"marginLeft",r),dn(i,"marginTop",r);let o=e.width(n,t,s);return o&&dn(i,"borderWidth",o),i}function w3(n,t){let e=n.series[t].points;return e._fill||e._stroke}function E3(n,t){let e=n.series[t].points;return e._stroke||e._fill}function T3(n,t){return n.series[t].points.size}var Vg=[0,0];function A3(n,t,e){return Vg[0]=t,Vg[1]=e,Vg}function Mf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Wg(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var R3={show:!0,x:!0,y:!0,lock:!1,move:A3,points:{one:!1,show:S3,size:T3,width:0,stroke:E3,fill:w3},bind:{mousedown:Mf,mouseup:Mf,click:Mf,dblclick:Mf,mousemove:Wg,mouseleave:Wg,mouseenter:Wg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},_M={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},u0=On({},_M,{filter:sM}),yM=On({},u0,{size:10}),vM=On({},_M,{show:!1}),h0='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',bM="bold "+h0,MM=1.5,kb={show:!0,scale:"x",stroke:e0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:bM,side:2,grid:u0,ticks:yM,border:vM,font:h0,lineGap:MM,rotate:0},C3="Value",P3="Time",zb={show:!0,scale:"x",auto:!1,sorted:1,min:en,max:-en,idxs:[]};function I3(n,t,e,i,s){return t.map(r=>r==null?"":o0(r))}function L3(n,t,e,i,s,r,o){let a=[],l=mo.get(s)||0;e=o?e:nn(Cf(e,s),l);for(let c=e;c<=i;c=nn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function jg(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ur:eM,u=is(c(e));s=al(l,u),l==10&&(s=Wo[Ds(s,Wo)]);let h=e,d=s*l;l==10&&(d=Wo[Ds(d,Wo)]);do a.push(h),h=h+s,l==10&&!mo.has(h)&&(h=nn(h,mo.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Wo[Ds(d,Wo)]));while(h<=i);return a}function D3(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?jg(n,t,Ii(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?jg(n,t,Ii(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var SM=/./,N3=/[12357]/,U3=/[125]/,Hb=/1/,Jg=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function F3(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?SM:l(7,o)-u>=c?N3:l(5,o)-u>=c?U3:Hb;if(h==Hb){let d=qn(l(1,o)-u);if(d<c)return Jg(t.slice().reverse(),a.distr,h,gs(c/d)).reverse()}return Jg(t,a.distr,h,1)}function O3(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=qn(l(1,o)-l(2,o));return c<a?Jg(t.slice().reverse(),3,SM,gs(a/c)).reverse():t}function B3(n,t,e,i){return i==null?n0:t==null?"":o0(t)}var Gb={show:!0,scale:"y",stroke:e0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:bM,side:3,grid:u0,ticks:yM,border:vM,font:h0,lineGap:MM,rotate:0};function k3(n,t){let e=3+(n||1)*2;return nn(e*t,3)}function z3(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=qn(o-r),l=n.series[t],c=a/(l.points.space*ze);return i[1]-i[0]<=c}var Vb={scale:null,auto:!0,sorted:0,min:en,max:-en},wM=(n,t,e,i,s)=>s,Wb={show:!0,auto:!0,sorted:0,gaps:wM,alpha:1,facets:[On({},Vb,{scale:"x"}),On({},Vb,{scale:"y"})]},qb={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:wM,alpha:1,points:{show:z3,filter:null},values:null,min:en,max:-en,idxs:[],path:null,clip:null};function H3(n,t,e,i,s){return e/10}var EM={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},G3=On({},EM,{time:!1,ori:1}),$b={};function TM(n,t){let e=$b[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&($b[n]=e)),e}var ul=1,Kg=2;function Yo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,_=a.height,p=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,p,g,d,f,m,_,Lf,dl,Nf,RM,PM):e(s,l,c,u,h,g,p,f,d,_,m,Df,fl,p0,CM,IM)}function d0(n,t){let e=0,i=0,s=Ue(n.bands,a0);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function V3(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Fr(n,t,e,i,s,r){return Yo(n,t,(o,a,l,c,u,h,d,f,m,_,p)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),E=c.ori==0?dl:fl,b,A;x==1?(b=e,A=i):(b=i,A=e);let T=g(h(a[b],c,_,f)),y=g(d(l[b],u,p,m)),S=g(h(a[A],c,_,f)),D=g(d(r==1?u.max:u.min,u,p,m)),L=new Path2D(s);return E(L,S,D),E(L,T,D),E(L,T,y),L})}function If(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Nf:p0,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function W3(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function f0(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),m=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=d+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=f&&a.push([f,m])}return a}function Xb(n){return n==0?iM:n==1?Wn:t=>Vo(t,n)}function AM(n){let t=n==0?Lf:Df,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ns(c,a/2,l/2),u=Ns(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Lf=(n,t,e)=>{n.moveTo(t,e)},Df=(n,t,e)=>{n.moveTo(e,t)},dl=(n,t,e)=>{n.lineTo(t,e)},fl=(n,t,e)=>{n.lineTo(e,t)},Nf=AM(0),p0=AM(1),RM=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},CM=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},PM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},IM=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function LM(n){return(t,e,i,s,r)=>Yo(t,e,(o,a,l,c,u,h,d,f,m,_,p)=>{let{pxRound:g,points:x}=o,E,b;c.ori==0?(E=Lf,b=RM):(E=Df,b=CM);let A=nn(x.width*ze,3),T=(x.size-x.width)/2*ze,y=nn(T*2,3),S=new Path2D,D=new Path2D,{left:L,top:N,width:z,height:G}=t.bbox;Nf(D,L-y,N-y,z+y*2,G+y*2);let B=X=>{if(l[X]!=null){let P=g(h(a[X],c,_,f)),U=g(d(l[X],u,p,m));E(S,P+T,U),b(S,P,U,T,0,Sf*2)}};if(r)r.forEach(B);else for(let X=i;X<=s;X++)B(X);return{stroke:A>0?S:null,fill:S,clip:D,flags:ul|Kg}})}function DM(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var q3=DM(dl),$3=DM(fl);function NM(n){let t=Ue(n?.alignGaps,0);return(e,i,s,r)=>Yo(e,i,(o,a,l,c,u,h,d,f,m,_,p)=>{[s,r]=Af(l,s,r);let g=o.pxRound,x=G=>g(h(G,c,_,f)),E=G=>g(d(G,u,p,m)),b,A;c.ori==0?(b=dl,A=q3):(b=fl,A=$3);let T=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ul},S=y.stroke,D=!1;if(r-s>=_*4){let G=ft=>e.posToVal(ft,c.key,!0),B=null,X=null,P,U,Z,q=x(a[T==1?s:r]),j=x(a[s]),et=x(a[r]),dt=G(T==1?j+1:et-1);for(let ft=T==1?s:r;ft>=s&&ft<=r;ft+=T){let st=a[ft],_t=(T==1?st<dt:st>dt)?q:x(st),Tt=l[ft];_t==q?Tt!=null?(U=Tt,B==null?(b(S,_t,E(U)),P=B=X=U):U<B?B=U:U>X&&(X=U)):Tt===null&&(D=!0):(B!=null&&A(S,q,E(B),E(X),E(P),E(U)),Tt!=null?(U=Tt,b(S,_t,E(U)),B=X=P=U):(B=X=null,Tt===null&&(D=!0)),q=_t,dt=G(q+T))}B!=null&&B!=X&&Z!=q&&A(S,q,E(B),E(X),E(P),E(U))}else for(let G=T==1?s:r;G>=s&&G<=r;G+=T){let B=l[G];B===null?D=!0:B!=null&&b(S,x(a[G]),E(B))}let[N,z]=d0(e,i);if(o.fill!=null||N!=0){let G=y.fill=new Path2D(S),B=o.fillTo(e,i,o.min,o.max,N),X=E(B),P=x(a[s]),U=x(a[r]);T==-1&&([U,P]=[P,U]),b(G,U,X),b(G,P,X)}if(!o.spanGaps){let G=[];D&&G.push(...f0(a,l,s,r,T,x,t)),y.gaps=G=o.gaps(e,i,s,r,G),y.clip=If(G,c.ori,f,m,_,p)}return z!=0&&(y.band=z==2?[Fr(e,i,s,r,S,-1),Fr(e,i,s,r,S,1)]:Fr(e,i,s,r,S,z)),y})}function X3(n){let t=Ue(n.align,1),e=Ue(n.ascDesc,!1),i=Ue(n.alignGaps,0),s=Ue(n.extend,!1);return(r,o,a,l)=>Yo(r,o,(c,u,h,d,f,m,_,p,g,x,E)=>{[a,l]=Af(h,a,l);let b=c.pxRound,{left:A,width:T}=r.bbox,y=j=>b(m(j,d,x,p)),S=j=>b(_(j,f,E,g)),D=d.ori==0?dl:fl,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ul},N=L.stroke,z=d.dir*(d.ori==0?1:-1),G=S(h[z==1?a:l]),B=y(u[z==1?a:l]),X=B,P=B;s&&t==-1&&(P=A,D(N,P,G)),D(N,B,G);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let et=h[j];if(et==null)continue;let dt=y(u[j]),ft=S(et);t==1?D(N,dt,G):D(N,X,ft),D(N,dt,ft),G=ft,X=dt}let U=X;s&&t==1&&(U=A+T,D(N,U,G));let[Z,q]=d0(r,o);if(c.fill!=null||Z!=0){let j=L.fill=new Path2D(N),et=c.fillTo(r,o,c.min,c.max,Z),dt=S(et);D(j,U,dt),D(j,P,dt)}if(!c.spanGaps){let j=[];j.push(...f0(u,h,a,l,z,y,i));let et=c.width*ze/2,dt=e||t==1?et:-et,ft=e||t==-1?-et:et;j.forEach(st=>{st[0]+=dt,st[1]+=ft}),L.gaps=j=c.gaps(r,o,a,l,j),L.clip=If(j,d.ori,p,g,x,E)}return q!=0&&(L.band=q==2?[Fr(r,o,a,l,N,-1),Fr(r,o,a,l,N,1)]:Fr(r,o,a,l,N,q)),L})}function Yb(n,t,e,i,s,r,o=en){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=qn(n[l]-n[a]);u<c&&(c=u,o=qn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function Y3(n){n=n||ou;let t=Ue(n.size,[.6,en,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Le(s),o=1-t[0],a=Ue(t[1],en),l=Ue(t[2],1),c=Ue(n.disp,ou),u=Ue(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,_,p)=>Yo(f,m,(g,x,E,b,A,T,y,S,D,L,N)=>{let z=g.pxRound,G=e,B=i*ze,X=a*ze,P=l*ze,U,Z;b.ori==0?[U,Z]=r(f,m):[Z,U]=r(f,m);let q=b.dir*(b.ori==0?1:-1),j=b.ori==0?Nf:p0,et=b.ori==0?u:(Nt,ie,me,Ct,Qe,Yt,Qt)=>{u(Nt,ie,me,Qe,Ct,Qt,Yt)},dt=Ue(f.bands,a0).find(Nt=>Nt.series[0]==m),ft=dt!=null?dt.dir:0,st=g.fillTo(f,m,g.min,g.max,ft),vt=z(y(st,A,N,D)),_t,Tt,At,Jt=L,pe=z(g.width*ze),Zt=!1,Se=null,ye=null,de=null,fn=null;h!=null&&(pe==0||d!=null)&&(Zt=!0,Se=h.values(f,m,_,p),ye=new Map,new Set(Se).forEach(Nt=>{Nt!=null&&ye.set(Nt,new Path2D)}),pe>0&&(de=d.values(f,m,_,p),fn=new Map,new Set(de).forEach(Nt=>{Nt!=null&&fn.set(Nt,new Path2D)})));let{x0:sn,size:Pn}=c;if(sn!=null&&Pn!=null){G=1,x=sn.values(f,m,_,p),sn.unit==2&&(x=x.map(me=>f.posToVal(S+me*L,b.key,!0)));let Nt=Pn.values(f,m,_,p);Pn.unit==2?Tt=Nt[0]*L:Tt=T(Nt[0],b,L,S)-T(0,b,L,S),Jt=Yb(x,E,T,b,L,S,Jt),At=Jt-Tt+B}else Jt=Yb(x,E,T,b,L,S,Jt),At=Jt*o+B,Tt=Jt-At;At<1&&(At=0),pe>=Tt/2&&(pe=0),At<5&&(z=iM);let Ze=At>0,Xn=Jt-At-(Ze?pe:0);Tt=z(Zg(Xn,P,X)),_t=(G==0?Tt/2:G==q?0:Tt)-G*q*((G==0?B/2:0)+(Ze?pe/2:0));let De={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bn=Zt?null:new Path2D,vn=null;if(dt!=null)vn=f.data[dt.series[1]];else{let{y0:Nt,y1:ie}=c;Nt!=null&&ie!=null&&(E=ie.values(f,m,_,p),vn=Nt.values(f,m,_,p))}let In=U*Tt,W=Z*Tt;for(let Nt=q==1?_:p;Nt>=_&&Nt<=p;Nt+=q){let ie=E[Nt];if(ie==null)continue;if(vn!=null){let J=vn[Nt]??0;if(ie-J==0)continue;vt=y(J,A,N,D)}let me=b.distr!=2||c!=null?x[Nt]:Nt,Ct=T(me,b,L,S),Qe=y(Ue(ie,st),A,N,D),Yt=z(Ct-_t),Qt=z(Ii(Qe,vt)),F=z(Ns(Qe,vt)),R=Qt-F;if(ie!=null){let J=ie<0?W:In,mt=ie<0?In:W;Zt?(pe>0&&de[Nt]!=null&&j(fn.get(de[Nt]),Yt,F+is(pe/2),Tt,Ii(0,R-pe),J,mt),Se[Nt]!=null&&j(ye.get(Se[Nt]),Yt,F+is(pe/2),Tt,Ii(0,R-pe),J,mt)):j(Bn,Yt,F+is(pe/2),Tt,Ii(0,R-pe),J,mt),et(f,m,Nt,Yt-pe/2,F,Tt+pe,R)}}return pe>0?De.stroke=Zt?fn:Bn:Zt||(De._fill=g.width==0?g._fill:g._stroke??g._fill,De.width=0),De.fill=Zt?ye:Bn,De})}function Z3(n,t){let e=Ue(t?.alignGaps,0);return(i,s,r,o)=>Yo(i,s,(a,l,c,u,h,d,f,m,_,p,g)=>{[r,o]=Af(c,r,o);let x=a.pxRound,E=U=>x(d(U,u,p,m)),b=U=>x(f(U,h,g,_)),A,T,y;u.ori==0?(A=Lf,y=dl,T=PM):(A=Df,y=fl,T=IM);let S=u.dir*(u.ori==0?1:-1),D=E(l[S==1?r:o]),L=D,N=[],z=[];for(let U=S==1?r:o;U>=r&&U<=o;U+=S)if(c[U]!=null){let q=l[U],j=E(q);N.push(L=j),z.push(b(c[U]))}let G={stroke:n(N,z,A,y,T,x),fill:null,clip:null,band:null,gaps:null,flags:ul},B=G.stroke,[X,P]=d0(i,s);if(a.fill!=null||X!=0){let U=G.fill=new Path2D(B),Z=a.fillTo(i,s,a.min,a.max,X),q=b(Z);y(U,L,q),y(U,D,q)}if(!a.spanGaps){let U=[];U.push(...f0(l,c,r,o,S,E,e)),G.gaps=U=a.gaps(i,s,r,o,U),G.clip=If(U,u.ori,m,_,p,g)}return P!=0&&(G.band=P==2?[Fr(i,s,r,o,B,-1),Fr(i,s,r,o,B,1)]:Fr(i,s,r,o,B,P)),G})}function j3(n){return Z3(J3,n)}function J3(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var Qg=new Set;function Zb(){for(let n of Qg)n.syncRect(!0)}hl&&($o(II,ol,Zb),$o(LI,ol,Zb,!0),$o(wf,ol,()=>{oi.pxRatio=ze}));var K3=NM(),Q3=LM();function jb(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>t0(r,o,t,e))}function t2(n,t){return n.map((e,i)=>i==0?{}:On({},t,e))}function t0(n,t,e,i){return On({},t==0?e:i,n)}function UM(n,t,e){return t==null?ll:[t,e]}var e2=UM;function n2(n,t,e){return t==null?ll:Ef(t,e,r0,!0)}function FM(n,t,e,i){return t==null?ll:Rf(t,e,n.scales[i].log,!1)}var i2=FM;function OM(n,t,e,i){return t==null?ll:s0(t,e,n.scales[i].log,!1)}var s2=OM;function r2(n,t,e,i,s){let r=Ii(Rb(n),Rb(t)),o=t-n,a=Ds(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?mo.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Jb(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Wn((e=+s)*ze))+"px"),[n,t,e]}function o2(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=nn(t[2]*ze,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function oi(n,t,e){let i={mode:Ue(n.mode,1)},s=i.mode;function r(w,C,O,k){let Y=C.valToPct(w);return k+O*(C.dir==-1?1-Y:Y)}function o(w,C,O,k){let Y=C.valToPct(w);return k+O*(C.dir==-1?Y:1-Y)}function a(w,C,O,k){return C.ori==0?r(w,C,O,k):o(w,C,O,k)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ms(fI);if(n.id!=null&&(c.id=n.id),ns(c,n.class),n.title){let w=ms(gI,c);w.textContent=n.title}let u=Ls("canvas"),h=i.ctx=u.getContext("2d"),d=ms(xI,c);$o("click",d,w=>{w.target===m&&(on!=ra||pn!=oa)&&ei.click(i,w)},!0);let f=i.under=ms(_I,d);d.appendChild(u);let m=i.over=ms(yI,d);n=cl(n);let _=+Ue(n.pxAlign,1),p=Xb(_);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?jb(n.series||[],zb,qb,!1):t2(n.series||[null],Wb),E=i.axes=jb(n.axes||[],kb,Gb,!0),b=i.scales={},A=i.bands=n.bands||[];A.forEach(w=>{w.fill=Le(w.fill||null),w.dir=Ue(w.dir,-1)});let T=s==2?x[1].facets[0].scale:x[0].scale,y={axes:hr,series:Ae},S=(n.drawOrder||["axes","series"]).map(w=>y[w]);function D(w){let C=w.distr==3?O=>Ur(O>0?O:w.clamp(i,O,w.min,w.max,w.key)):w.distr==4?O=>Hg(O,w.asinh):w.distr==100?O=>w.fwd(O):O=>O;return O=>{let k=C(O),{_min:Y,_max:tt}=w,ut=tt-Y;return(k-Y)/ut}}function L(w){let C=b[w];if(C==null){let O=(n.scales||ou)[w]||ou;if(O.from!=null){L(O.from);let k=On({},b[O.from],O,{key:w});k.valToPct=D(k),b[w]=k}else{C=b[w]=On({},w==T?EM:G3,O),C.key=w;let k=C.time,Y=C.range,tt=po(Y);if((w!=T||s==2&&!k)&&(tt&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?Eb:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?Eb:{mode:1,hard:Y[1],soft:Y[1]}},tt=!1),!tt&&Pf(Y))){let ut=Y;Y=(yt,Et,kt)=>Et==null?ll:Ef(Et,kt,ut)}C.range=Le(Y||(k?e2:w==T?C.distr==3?i2:C.distr==4?s2:UM:C.distr==3?FM:C.distr==4?OM:n2)),C.auto=Le(tt?!1:C.auto),C.clamp=Le(C.clamp||H3),C._min=C._max=null,C.valToPct=D(C)}}}L("x"),L("y"),s==1&&x.forEach(w=>{L(w.scale)}),E.forEach(w=>{L(w.scale)});for(let w in n.scales)L(w);let N=b[T],z=N.distr,G,B;N.ori==0?(ns(c,pI),G=r,B=o):(ns(c,mI),G=o,B=r);let X={};for(let w in b){let C=b[w];(C.min!=null||C.max!=null)&&(X[w]={min:C.min,max:C.max},C.min=C.max=null)}let P=n.tzDate||(w=>new Date(Wn(w/g))),U=n.fmtDate||l0,Z=g==1?p3(P):x3(P),q=Fb(P,Ub(g==1?f3:g3,U)),j=Bb(P,Ob(y3,U)),et=[],dt=i.legend=On({},M3,n.legend),ft=i.cursor=On({},R3,{drag:{y:s==2}},n.cursor),st=dt.show,vt=ft.show,_t=dt.markers;dt.idxs=et,_t.width=Le(_t.width),_t.dash=Le(_t.dash),_t.stroke=Le(_t.stroke),_t.fill=Le(_t.fill);let Tt,At,Jt,pe=[],Zt=[],Se,ye=!1,de={};if(dt.live){let w=x[1]?x[1].values:null;ye=w!=null,Se=ye?w(i,1,0):{_:0};for(let C in Se)de[C]=n0}if(st)if(Tt=Ls("table",EI,c),Jt=Ls("tbody",null,Tt),dt.mount(i,Tt),ye){At=Ls("thead",null,Tt,Jt);let w=Ls("tr",null,At);Ls("th",null,w);for(var fn in Se)Ls("th",db,w).textContent=fn}else ns(Tt,AI),dt.live&&ns(Tt,TI);let sn={show:!0},Pn={show:!1};function Ze(w,C){if(C==0&&(ye||!dt.live||s==2))return ll;let O=[],k=Ls("tr",RI,Jt,Jt.childNodes[C]);ns(k,w.class),w.show||ns(k,qo);let Y=Ls("th",null,k);if(_t.show){let yt=ms(CI,Y);if(C>0){let Et=_t.width(i,C);Et&&(yt.style.border=Et+"px "+_t.dash(i,C)+" "+_t.stroke(i,C)),yt.style.background=_t.fill(i,C)}}let tt=ms(db,Y);w.label instanceof HTMLElement?tt.appendChild(w.label):tt.textContent=w.label,C>0&&(_t.show||(tt.style.color=w.width>0?_t.stroke(i,C):_t.fill(i,C)),De("click",Y,yt=>{if(ft._lock)return;oe(yt);let Et=x.indexOf(w);if((yt.ctrlKey||yt.metaKey)!=dt.isolate){let kt=x.some((zt,Gt)=>Gt>0&&Gt!=Et&&zt.show);x.forEach((zt,Gt)=>{Gt>0&&zs(Gt,kt?Gt==Et?sn:Pn:sn,!0,Un.setSeries)})}else zs(Et,{show:!w.show},!0,Un.setSeries)},!1),ae&&De(gb,Y,yt=>{ft._lock||(oe(yt),zs(x.indexOf(w),la,!0,Un.setSeries))},!1));for(var ut in Se){let yt=Ls("td",PI,k);yt.textContent="--",O.push(yt)}return[k,O]}let Xn=new Map;function De(w,C,O,k=!0){let Y=Xn.get(C)||{},tt=ft.bind[w](i,C,O,k);tt&&($o(w,C,Y[w]=tt),Xn.set(C,Y))}function Bn(w,C,O){let k=Xn.get(C)||{};for(let Y in k)(w==null||Y==w)&&(Yg(Y,C,k[Y]),delete k[Y]);w==null&&Xn.delete(C)}let vn=0,In=0,W=0,Nt=0,ie=0,me=0,Ct=ie,Qe=me,Yt=W,Qt=Nt,F=0,R=0,J=0,mt=0;i.bbox={};let ct=!1,St=!1,wt=!1,rt=!1,at=!1,bt=!1;function V(w,C,O){(O||w!=i.width||C!=i.height)&&lt(w,C),ve(!1),wt=!0,St=!0,ai()}function lt(w,C){i.width=vn=W=w,i.height=In=Nt=C,ie=me=0,Rt(),jt();let O=i.bbox;F=O.left=Vo(ie*ze,.5),R=O.top=Vo(me*ze,.5),J=O.width=Vo(W*ze,.5),mt=O.height=Vo(Nt*ze,.5)}let ot=3;function Pt(){let w=!1,C=0;for(;!w;){C++;let O=na(C),k=ks(C);w=C==ot||O&&k,w||(lt(i.width,i.height),St=!0)}}function Mt({width:w,height:C}){V(w,C)}i.setSize=Mt;function Rt(){let w=!1,C=!1,O=!1,k=!1;E.forEach((Y,tt)=>{if(Y.show&&Y._show){let{side:ut,_size:yt}=Y,Et=ut%2,kt=Y.label!=null?Y.labelSize:0,zt=yt+kt;zt>0&&(Et?(W-=zt,ut==3?(ie+=zt,k=!0):O=!0):(Nt-=zt,ut==0?(me+=zt,w=!0):C=!0))}}),Os[0]=w,Os[1]=O,Os[2]=C,Os[3]=k,W-=xs[1]+xs[3],ie+=xs[3],Nt-=xs[2]+xs[0],me+=xs[0]}function jt(){let w=ie+W,C=me+Nt,O=ie,k=me;function Y(tt,ut){switch(tt){case 1:return w+=ut,w-ut;case 2:return C+=ut,C-ut;case 3:return O-=ut,O+ut;case 0:return k-=ut,k+ut}}E.forEach((tt,ut)=>{if(tt.show&&tt._show){let yt=tt.side;tt._pos=Y(yt,tt._size),tt.label!=null&&(tt._lpos=Y(yt,tt.labelSize))}})}if(ft.dataIdx==null){let w=ft.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let O=w.prox=Le(w.prox),k=w.bias??=0;ft.dataIdx=(Y,tt,ut,yt)=>{if(tt==0)return ut;let Et=ut,kt=O(Y,tt,ut,yt)??en,zt=kt>=0&&kt<en,Gt=N.ori==0?W:Nt,fe=ft.left,Fe=t[0],Ne=t[tt];if(C.has(Ne[ut])){Et=null;let Re=null,se=null,Kt;if(k==0||k==-1)for(Kt=ut;Re==null&&Kt-- >0;)C.has(Ne[Kt])||(Re=Kt);if(k==0||k==1)for(Kt=ut;se==null&&Kt++<Ne.length;)C.has(Ne[Kt])||(se=Kt);if(Re!=null||se!=null)if(zt){let ln=Re==null?-1/0:G(Fe[Re],N,Gt,0),Sn=se==null?1/0:G(Fe[se],N,Gt,0),Jn=fe-ln,je=Sn-fe;Jn<=je?Jn<=kt&&(Et=Re):je<=kt&&(Et=se)}else Et=se==null?Re:Re==null?se:ut-Re<=se-ut?Re:se}else zt&&qn(fe-G(Fe[ut],N,Gt,0))>kt&&(Et=null);return Et}}let oe=w=>{ft.event=w};ft.idxs=et,ft._lock=!1;let pt=ft.points;pt.show=Le(pt.show),pt.size=Le(pt.size),pt.stroke=Le(pt.stroke),pt.width=Le(pt.width),pt.fill=Le(pt.fill);let Wt=i.focus=On({},n.focus||{alpha:.3},ft.focus),ae=Wt.prox>=0,Dt=ae&&pt.one,xe=[],rn=[],mi=[];function Cl(w,C){let O=pt.show(i,C);if(O instanceof HTMLElement)return ns(O,wI),ns(O,w.class),or(O,-10,-10,W,Nt),m.insertBefore(O,xe[C]),O}function Qo(w,C){if(s==1||C>0){let O=s==1&&b[w.scale].time,k=w.value;w.value=O?Ib(k)?Bb(P,Ob(k,U)):k||j:k||B3,w.label=w.label||(O?P3:C3)}if(Dt||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||K3||GI,w.fillTo=Le(w.fillTo||V3),w.pxAlign=+Ue(w.pxAlign,_),w.pxRound=Xb(w.pxAlign),w.stroke=Le(w.stroke||null),w.fill=Le(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let O=k3(Ii(1,w.width),1),k=w.points=On({},{size:O,width:Ii(1,O*.2),stroke:w.stroke,space:O*2,paths:Q3,_stroke:null,_fill:null},w.points);k.show=Le(k.show),k.filter=Le(k.filter),k.fill=Le(k.fill),k.stroke=Le(k.stroke),k.paths=Le(k.paths),k.pxAlign=w.pxAlign}if(st){let O=Ze(w,C);pe.splice(C,0,O[0]),Zt.splice(C,0,O[1]),dt.values.push(null)}if(vt){et.splice(C,0,null);let O=null;Dt?C==0&&(O=Cl(w,C)):C>0&&(O=Cl(w,C)),xe.splice(C,0,O),rn.splice(C,0,0),mi.splice(C,0,0)}jn("addSeries",C)}function up(w,C){C=C??x.length,w=s==1?t0(w,C,zb,qb):t0(w,C,{},Wb),x.splice(C,0,w),Qo(x[C],C)}i.addSeries=up;function yu(w){if(x.splice(w,1),st){dt.values.splice(w,1),Zt.splice(w,1);let C=pe.splice(w,1)[0];Bn(null,C.firstChild),C.remove()}vt&&(et.splice(w,1),xe.splice(w,1)[0].remove(),rn.splice(w,1),mi.splice(w,1)),jn("delSeries",w)}i.delSeries=yu;let Os=[!1,!1,!1,!1];function lr(w,C){if(w._show=w.show,w.show){let O=w.side%2,k=b[w.scale];k==null&&(w.scale=O?x[1].scale:T,k=b[w.scale]);let Y=k.time;w.size=Le(w.size),w.space=Le(w.space),w.rotate=Le(w.rotate),po(w.incrs)&&w.incrs.forEach(ut=>{!mo.has(ut)&&mo.set(ut,oM(ut))}),w.incrs=Le(w.incrs||(k.distr==2?u3:Y?g==1?d3:m3:Wo)),w.splits=Le(w.splits||(Y&&k.distr==1?Z:k.distr==3?jg:k.distr==4?D3:L3)),w.stroke=Le(w.stroke),w.grid.stroke=Le(w.grid.stroke),w.ticks.stroke=Le(w.ticks.stroke),w.border.stroke=Le(w.border.stroke);let tt=w.values;w.values=po(tt)&&!po(tt[0])?Le(tt):Y?po(tt)?Fb(P,Ub(tt,U)):Ib(tt)?_3(P,tt):tt||q:tt||I3,w.filter=Le(w.filter||(k.distr>=3&&k.log==10?F3:k.distr==3&&k.log==2?O3:sM)),w.font=Jb(w.font),w.labelFont=Jb(w.labelFont),w._size=w.size(i,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Os[C]=!0,w._el=ms(vI,d))}}function cr(w,C,O,k){let[Y,tt,ut,yt]=O,Et=C%2,kt=0;return Et==0&&(yt||tt)&&(kt=C==0&&!Y||C==2&&!ut?Wn(kb.size/3):0),Et==1&&(Y||ut)&&(kt=C==1&&!tt||C==3&&!yt?Wn(Gb.size/2):0),kt}let Pl=i.padding=(n.padding||[cr,cr,cr,cr]).map(w=>Le(Ue(w,cr))),xs=i._padding=Pl.map((w,C)=>w(i,C,Os,0)),bn,Rn=null,Cn=null,Bs=s==1?x[0].idxs:null,Wi=null,Br=!1;function Il(w,C){if(t=w??[],i.data=i._data=t,s==2){bn=0;for(let O=1;O<x.length;O++)bn+=t[O][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Wi=t[0],bn=Wi.length;let O=t;if(z==2){O=t.slice();let k=O[0]=Array(bn);for(let Y=0;Y<bn;Y++)k[Y]=Y}i._data=t=O}if(ve(!0),jn("setData"),z==2&&(wt=!0),C!==!1){let O=N;O.auto(i,Br)?Ll():Hr(T,O.min,O.max),rt=rt||ft.left>=0,bt=!0,ai()}}i.setData=Il;function Ll(){Br=!0;let w,C;s==1&&(bn>0?(Rn=Bs[0]=0,Cn=Bs[1]=bn-1,w=t[0][Rn],C=t[0][Cn],z==2?(w=Rn,C=Cn):w==C&&(z==3?[w,C]=Rf(w,w,N.log,!1):z==4?[w,C]=s0(w,w,N.log,!1):N.time?C=w+Wn(86400/g):[w,C]=Ef(w,C,r0,!0))):(Rn=Bs[0]=w=null,Cn=Bs[1]=C=null)),Hr(T,w,C)}let ta,kr,ea,I,$,it,K,Q,It,Ut;function Lt(w,C,O,k,Y,tt){w??=pb,O??=a0,k??="butt",Y??=pb,tt??="round",w!=ta&&(h.strokeStyle=ta=w),Y!=kr&&(h.fillStyle=kr=Y),C!=ea&&(h.lineWidth=ea=C),tt!=$&&(h.lineJoin=$=tt),k!=it&&(h.lineCap=it=k),O!=I&&h.setLineDash(I=O)}function Ft(w,C,O,k){C!=kr&&(h.fillStyle=kr=C),w!=K&&(h.font=K=w),O!=Q&&(h.textAlign=Q=O),k!=It&&(h.textBaseline=It=k)}function $t(w,C,O,k,Y=0){if(k.length>0&&w.auto(i,Br)&&(C==null||C.min==null)){let tt=Ue(Rn,0),ut=Ue(Cn,k.length-1),yt=O.min==null?FI(k,tt,ut,Y,w.distr==3):[O.min,O.max];w.min=Ns(w.min,O.min=yt[0]),w.max=Ii(w.max,O.max=yt[1])}}let le={min:null,max:null};function Te(){for(let k in b){let Y=b[k];X[k]==null&&(Y.min==null||X[T]!=null&&Y.auto(i,Br))&&(X[k]=le)}for(let k in b){let Y=b[k];X[k]==null&&Y.from!=null&&X[Y.from]!=null&&(X[k]=le)}X[T]!=null&&ve(!0);let w={};for(let k in X){let Y=X[k];if(Y!=null){let tt=w[k]=cl(b[k],qI);if(Y.min!=null)On(tt,Y);else if(k!=T||s==2)if(bn==0&&tt.from==null){let ut=tt.range(i,null,null,k);tt.min=ut[0],tt.max=ut[1]}else tt.min=en,tt.max=-en}}if(bn>0){x.forEach((k,Y)=>{if(s==1){let tt=k.scale,ut=X[tt];if(ut==null)return;let yt=w[tt];if(Y==0){let Et=yt.range(i,yt.min,yt.max,tt);yt.min=Et[0],yt.max=Et[1],Rn=Ds(yt.min,t[0]),Cn=Ds(yt.max,t[0]),Cn-Rn>1&&(t[0][Rn]<yt.min&&Rn++,t[0][Cn]>yt.max&&Cn--),k.min=Wi[Rn],k.max=Wi[Cn]}else k.show&&k.auto&&$t(yt,ut,k,t[Y],k.sorted);k.idxs[0]=Rn,k.idxs[1]=Cn}else if(Y>0&&k.show&&k.auto){let[tt,ut]=k.facets,yt=tt.scale,Et=ut.scale,[kt,zt]=t[Y],Gt=w[yt],fe=w[Et];Gt!=null&&$t(Gt,X[yt],tt,kt,tt.sorted),fe!=null&&$t(fe,X[Et],ut,zt,ut.sorted),k.min=ut.min,k.max=ut.max}});for(let k in w){let Y=w[k],tt=X[k];if(Y.from==null&&(tt==null||tt.min==null)){let ut=Y.range(i,Y.min==en?null:Y.min,Y.max==-en?null:Y.max,k);Y.min=ut[0],Y.max=ut[1]}}}for(let k in w){let Y=w[k];if(Y.from!=null){let tt=w[Y.from];if(tt.min==null)Y.min=Y.max=null;else{let ut=Y.range(i,tt.min,tt.max,k);Y.min=ut[0],Y.max=ut[1]}}}let C={},O=!1;for(let k in w){let Y=w[k],tt=b[k];if(tt.min!=Y.min||tt.max!=Y.max){tt.min=Y.min,tt.max=Y.max;let ut=tt.distr;tt._min=ut==3?Ur(tt.min):ut==4?Hg(tt.min,tt.asinh):ut==100?tt.fwd(tt.min):tt.min,tt._max=ut==3?Ur(tt.max):ut==4?Hg(tt.max,tt.asinh):ut==100?tt.fwd(tt.max):tt.max,C[k]=O=!0}}if(O){x.forEach((k,Y)=>{s==2?Y>0&&C.y&&(k._paths=null):C[k.scale]&&(k._paths=null)});for(let k in C)wt=!0,jn("setScale",k);vt&&ft.left>=0&&(rt=bt=!0)}for(let k in X)X[k]=null}function qt(w){let C=Zg(Rn-1,0,bn-1),O=Zg(Cn+1,0,bn-1);for(;w[C]==null&&C>0;)C--;for(;w[O]==null&&O<bn-1;)O++;return[C,O]}function Ae(){if(bn>0){let w=x.some(C=>C._focus)&&Ut!=Wt.alpha;w&&(h.globalAlpha=Ut=Wt.alpha),x.forEach((C,O)=>{if(O>0&&C.show&&(_n(O,!1),_n(O,!0),C._paths==null)){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha);let Y=s==2?[0,t[O][0].length-1]:qt(t[O]);C._paths=C.paths(i,O,Y[0],Y[1]),Ut!=k&&(h.globalAlpha=Ut=k)}}),x.forEach((C,O)=>{if(O>0&&C.show){let k=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha),C._paths!=null&&qe(O,!1);{let Y=C._paths!=null?C._paths.gaps:null,tt=C.points.show(i,O,Rn,Cn,Y),ut=C.points.filter(i,O,tt,Y);(tt||ut)&&(C.points._paths=C.points.paths(i,O,Rn,Cn,ut),qe(O,!0))}Ut!=k&&(h.globalAlpha=Ut=k),jn("drawSeries",O)}}),w&&(h.globalAlpha=Ut=1)}}function _n(w,C){let O=C?x[w].points:x[w];O._stroke=O.stroke(i,w),O._fill=O.fill(i,w)}function qe(w,C){let O=C?x[w].points:x[w],{stroke:k,fill:Y,clip:tt,flags:ut,_stroke:yt=O._stroke,_fill:Et=O._fill,_width:kt=O.width}=O._paths;kt=nn(kt*ze,3);let zt=null,Gt=kt%2/2;C&&Et==null&&(Et=kt>0?"#fff":yt);let fe=O.pxAlign==1&&Gt>0;if(fe&&h.translate(Gt,Gt),!C){let Fe=F-kt/2,Ne=R-kt/2,Re=J+kt,se=mt+kt;zt=new Path2D,zt.rect(Fe,Ne,Re,se)}C?Ht(yt,kt,O.dash,O.cap,Et,k,Y,ut,tt):$e(w,yt,kt,O.dash,O.cap,Et,k,Y,ut,zt,tt),fe&&h.translate(-Gt,-Gt)}function $e(w,C,O,k,Y,tt,ut,yt,Et,kt,zt){let Gt=!1;Et!=0&&A.forEach((fe,Fe)=>{if(fe.series[0]==w){let Ne=x[fe.series[1]],Re=t[fe.series[1]],se=(Ne._paths||ou).band;po(se)&&(se=fe.dir==1?se[0]:se[1]);let Kt,ln=null;Ne.show&&se&&BI(Re,Rn,Cn)?(ln=fe.fill(i,Fe)||tt,Kt=Ne._paths.clip):se=null,Ht(C,O,k,Y,ln,ut,yt,Et,kt,zt,Kt,se),Gt=!0}}),Gt||Ht(C,O,k,Y,tt,ut,yt,Et,kt,zt)}let kn=ul|Kg;function Ht(w,C,O,k,Y,tt,ut,yt,Et,kt,zt,Gt){Lt(w,C,O,k,Y),(Et||kt||Gt)&&(h.save(),Et&&h.clip(Et),kt&&h.clip(kt)),Gt?(yt&kn)==kn?(h.clip(Gt),zt&&h.clip(zt),Ce(Y,ut),Ln(w,tt,C)):yt&Kg?(Ce(Y,ut),h.clip(Gt),Ln(w,tt,C)):yt&ul&&(h.save(),h.clip(Gt),zt&&h.clip(zt),Ce(Y,ut),h.restore(),Ln(w,tt,C)):(Ce(Y,ut),Ln(w,tt,C)),(Et||kt||Gt)&&h.restore()}function Ln(w,C,O){O>0&&(C instanceof Map?C.forEach((k,Y)=>{h.strokeStyle=ta=Y,h.stroke(k)}):C!=null&&w&&h.stroke(C))}function Ce(w,C){C instanceof Map?C.forEach((O,k)=>{h.fillStyle=kr=k,h.fill(O)}):C!=null&&w&&h.fill(C)}function ur(w,C,O,k){let Y=E[w],tt;if(k<=0)tt=[0,0];else{let ut=Y._space=Y.space(i,w,C,O,k),yt=Y._incrs=Y.incrs(i,w,C,O,k,ut);tt=r2(C,O,yt,k,ut)}return Y._found=tt}function Dn(w,C,O,k,Y,tt,ut,yt,Et,kt){let zt=ut%2/2;_==1&&h.translate(zt,zt),Lt(yt,ut,Et,kt,yt),h.beginPath();let Gt,fe,Fe,Ne,Re=Y+(k==0||k==3?-tt:tt);O==0?(fe=Y,Ne=Re):(Gt=Y,Fe=Re);for(let se=0;se<w.length;se++)C[se]!=null&&(O==0?Gt=Fe=w[se]:fe=Ne=w[se],h.moveTo(Gt,fe),h.lineTo(Fe,Ne));h.stroke(),_==1&&h.translate(-zt,-zt)}function na(w){let C=!0;return E.forEach((O,k)=>{if(!O.show)return;let Y=b[O.scale];if(Y.min==null){O._show&&(C=!1,O._show=!1,ve(!1));return}else O._show||(C=!1,O._show=!0,ve(!1));let tt=O.side,ut=tt%2,{min:yt,max:Et}=Y,[kt,zt]=ur(k,yt,Et,ut==0?W:Nt);if(zt==0)return;let Gt=Y.distr==2,fe=O._splits=O.splits(i,k,yt,Et,kt,zt,Gt),Fe=Y.distr==2?fe.map(Kt=>Wi[Kt]):fe,Ne=Y.distr==2?Wi[fe[1]]-Wi[fe[0]]:kt,Re=O._values=O.values(i,O.filter(i,Fe,k,zt,Ne),k,zt,Ne);O._rotate=tt==2?O.rotate(i,Re,k,zt):0;let se=O._size;O._size=gs(O.size(i,Re,k,w)),se!=null&&O._size!=se&&(C=!1)}),C}function ks(w){let C=!0;return Pl.forEach((O,k)=>{let Y=O(i,k,Os,w);Y!=xs[k]&&(C=!1),xs[k]=Y}),C}function hr(){for(let w=0;w<E.length;w++){let C=E[w];if(!C.show||!C._show)continue;let O=C.side,k=O%2,Y,tt,ut=C.stroke(i,w),yt=O==0||O==3?-1:1,[Et,kt]=C._found;if(C.label!=null){let _i=C.labelGap*yt,Xi=Wn((C._lpos+_i)*ze);Ft(C.labelFont[0],ut,"center",O==2?"top":fb),h.save(),k==1?(Y=tt=0,h.translate(Xi,Wn(R+mt/2)),h.rotate((O==3?-Sf:Sf)/2)):(Y=Wn(F+J/2),tt=Xi);let So=nM(C.label)?C.label(i,w,Et,kt):C.label;h.fillText(So,Y,tt),h.restore()}if(kt==0)continue;let zt=b[C.scale],Gt=k==0?J:mt,fe=k==0?F:R,Fe=C._splits,Ne=zt.distr==2?Fe.map(_i=>Wi[_i]):Fe,Re=zt.distr==2?Wi[Fe[1]]-Wi[Fe[0]]:Et,se=C.ticks,Kt=C.border,ln=se.show?se.size:0,Sn=Wn(ln*ze),Jn=Wn((C.alignTo==2?C._size-ln-C.gap:C.gap)*ze),je=C._rotate*-Sf/180,wn=p(C._pos*ze),qi=(Sn+Jn)*yt,xi=wn+qi;tt=k==0?xi:0,Y=k==1?xi:0;let rs=C.font[0],_s=C.align==1?sl:C.align==2?Bg:je>0?sl:je<0?Bg:k==0?"center":O==3?Bg:sl,Gs=je||k==1?"middle":O==2?"top":fb;Ft(rs,ut,_s,Gs);let $i=C.font[1]*C.lineGap,os=Fe.map(_i=>p(a(_i,zt,Gt,fe))),ys=C._values;for(let _i=0;_i<ys.length;_i++){let Xi=ys[_i];if(Xi!=null){k==0?Y=os[_i]:tt=os[_i],Xi=""+Xi;let So=Xi.indexOf(`
`)==-1?[Xi]:Xi.split(/\n/gm);for(let yi=0;yi<So.length;yi++){let xx=So[yi];je?(h.save(),h.translate(Y,tt+yi*$i),h.rotate(je),h.fillText(xx,0,0),h.restore()):h.fillText(xx,Y,tt+yi*$i)}}}se.show&&Dn(os,se.filter(i,Ne,w,kt,Re),k,O,wn,Sn,nn(se.width*ze,3),se.stroke(i,w),se.dash,se.cap);let Vs=C.grid;Vs.show&&Dn(os,Vs.filter(i,Ne,w,kt,Re),k,k==0?2:1,k==0?R:F,k==0?mt:J,nn(Vs.width*ze,3),Vs.stroke(i,w),Vs.dash,Vs.cap),Kt.show&&Dn([wn],[1],k==0?1:0,k==0?1:2,k==1?R:F,k==1?mt:J,nn(Kt.width*ze,3),Kt.stroke(i,w),Kt.dash,Kt.cap)}jn("drawAxes")}function ve(w){x.forEach((C,O)=>{O>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(k=>{k.min=null,k.max=null})))})}let Mn=!1,gi=!1,Xe=[];function Nn(){gi=!1;for(let w=0;w<Xe.length;w++)jn(...Xe[w]);Xe.length=0}function ai(){Mn||(KI(Q0),Mn=!0)}function vu(w,C=!1){Mn=!0,gi=C,w(i),Q0(),C&&Xe.length>0&&queueMicrotask(Nn)}i.batch=vu;function Q0(){if(ct&&(Te(),ct=!1),wt&&(Pt(),wt=!1),St){if(dn(f,sl,ie),dn(f,"top",me),dn(f,nu,W),dn(f,iu,Nt),dn(m,sl,ie),dn(m,"top",me),dn(m,nu,W),dn(m,iu,Nt),dn(d,nu,vn),dn(d,iu,In),u.width=Wn(vn*ze),u.height=Wn(In*ze),E.forEach(({_el:w,_show:C,_size:O,_pos:k,side:Y})=>{if(w!=null)if(C){let tt=Y===3||Y===0?O:0,ut=Y%2==1;dn(w,ut?"left":"top",k-tt),dn(w,ut?"width":"height",O),dn(w,ut?"top":"left",ut?me:ie),dn(w,ut?"height":"width",ut?Nt:W),Xg(w,qo)}else ns(w,qo)}),ta=kr=ea=$=it=K=Q=It=I=null,Ut=1,Ul(!0),ie!=Ct||me!=Qe||W!=Yt||Nt!=Qt){ve(!1);let w=W/Yt,C=Nt/Qt;if(vt&&!rt&&ft.left>=0){ft.left*=w,ft.top*=C,ia&&or(ia,Wn(ft.left),0,W,Nt),sa&&or(sa,0,Wn(ft.top),W,Nt);for(let O=0;O<xe.length;O++){let k=xe[O];k!=null&&(rn[O]*=w,mi[O]*=C,or(k,gs(rn[O]),gs(mi[O]),W,Nt))}}if(an.show&&!at&&an.left>=0&&an.width>0){an.left*=w,an.width*=w,an.top*=C,an.height*=C;for(let O in gp)dn(aa,O,an[O])}Ct=ie,Qe=me,Yt=W,Qt=Nt}jn("setSize"),St=!1}vn>0&&In>0&&(h.clearRect(0,0,u.width,u.height),jn("drawClear"),S.forEach(w=>w()),jn("draw")),an.show&&at&&(bu(an),at=!1),vt&&rt&&(Mo(null,!0,!1),rt=!1),dt.show&&dt.live&&bt&&(pp(),bt=!1),l||(l=!0,i.status=1,jn("ready")),Br=!1,Mn=!1}i.redraw=(w,C)=>{wt=C||!1,w!==!1?Hr(T,N.min,N.max):ai()};function hp(w,C){let O=b[w];if(O.from==null){if(bn==0){let k=O.range(i,C.min,C.max,w);C.min=k[0],C.max=k[1]}if(C.min>C.max){let k=C.min;C.min=C.max,C.max=k}if(bn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==T&&O.distr==2&&bn>0&&(C.min=Ds(C.min,t[0]),C.max=Ds(C.max,t[0]),C.min==C.max&&C.max++),X[w]=C,ct=!0,ai()}}i.setScale=hp;let dp,fp,ia,sa,tx,ex,ra,oa,nx,ix,on,pn,zr=!1,ei=ft.drag,Yn=ei.x,Zn=ei.y;vt&&(ft.x&&(dp=ms(MI,m)),ft.y&&(fp=ms(SI,m)),N.ori==0?(ia=dp,sa=fp):(ia=fp,sa=dp),on=ft.left,pn=ft.top);let an=i.select=On({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),aa=an.show?ms(bI,an.over?m:f):null;function bu(w,C){if(an.show){for(let O in w)an[O]=w[O],O in gp&&dn(aa,O,w[O]);C!==!1&&jn("setSelect")}}i.setSelect=bu;function Hw(w){if(x[w].show)st&&Xg(pe[w],qo);else if(st&&ns(pe[w],qo),vt){let O=Dt?xe[0]:xe[w];O!=null&&or(O,-10,-10,W,Nt)}}function Hr(w,C,O){hp(w,{min:C,max:O})}function zs(w,C,O,k){C.focus!=null&&$w(w),C.show!=null&&x.forEach((Y,tt)=>{tt>0&&(w==tt||w==null)&&(Y.show=C.show,Hw(tt),s==2?(Hr(Y.facets[0].scale,null,null),Hr(Y.facets[1].scale,null,null)):Hr(Y.scale,null,null),ai())}),O!==!1&&jn("setSeries",w,C),k&&Fl("setSeries",i,w,C)}i.setSeries=zs;function Gw(w,C){On(A[w],C)}function Vw(w,C){w.fill=Le(w.fill||null),w.dir=Ue(w.dir,-1),C=C??A.length,A.splice(C,0,w)}function Ww(w){w==null?A.length=0:A.splice(w,1)}i.addBand=Vw,i.setBand=Gw,i.delBand=Ww;function qw(w,C){x[w].alpha=C,vt&&xe[w]!=null&&(xe[w].style.opacity=C),st&&pe[w]&&(pe[w].style.opacity=C)}let dr,Gr,bo,la={focus:!0};function $w(w){if(w!=bo){let C=w==null,O=Wt.alpha!=1;x.forEach((k,Y)=>{if(s==1||Y>0){let tt=C||Y==0||Y==w;k._focus=C?null:tt,O&&qw(Y,tt?1:Wt.alpha)}}),bo=w,O&&ai()}}st&&ae&&De(xb,Tt,w=>{ft._lock||(oe(w),bo!=null&&zs(null,la,!0,Un.setSeries))});function Hs(w,C,O){let k=b[C];O&&(w=w/ze-(k.ori==1?me:ie));let Y=W;k.ori==1&&(Y=Nt,w=Y-w),k.dir==-1&&(w=Y-w);let tt=k._min,ut=k._max,yt=w/Y,Et=tt+(ut-tt)*yt,kt=k.distr;return kt==3?al(10,Et):kt==4?zI(Et,k.asinh):kt==100?k.bwd(Et):Et}function Xw(w,C){let O=Hs(w,T,C);return Ds(O,t[0],Rn,Cn)}i.valToIdx=w=>Ds(w,t[0]),i.posToIdx=Xw,i.posToVal=Hs,i.valToPos=(w,C,O)=>b[C].ori==0?r(w,b[C],O?J:W,O?F:0):o(w,b[C],O?mt:Nt,O?R:0),i.setCursor=(w,C,O)=>{on=w.left,pn=w.top,Mo(null,C,O)};function sx(w,C){dn(aa,sl,an.left=w),dn(aa,nu,an.width=C)}function rx(w,C){dn(aa,"top",an.top=w),dn(aa,iu,an.height=C)}let Dl=N.ori==0?sx:rx,Nl=N.ori==1?sx:rx;function Yw(){if(st&&dt.live)for(let w=s==2?1:0;w<x.length;w++){if(w==0&&ye)continue;let C=dt.values[w],O=0;for(let k in C)Zt[w][O++].firstChild.nodeValue=C[k]}}function pp(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((O,k)=>{et[k]=O}):WI(w.idx)||et.fill(w.idx),dt.idx=et[0]),st&&dt.live){for(let O=0;O<x.length;O++)(O>0||s==1&&!ye)&&Zw(O,et[O]);Yw()}bt=!1,C!==!1&&jn("setLegend")}i.setLegend=pp;function Zw(w,C){let O=x[w],k=w==0&&z==2?Wi:t[w],Y;ye?Y=O.values(i,w,C)??de:(Y=O.value(i,C==null?null:k[C],w,C),Y=Y==null?de:{_:Y}),dt.values[w]=Y}function Mo(w,C,O){nx=on,ix=pn,[on,pn]=ft.move(i,on,pn),ft.left=on,ft.top=pn,vt&&(ia&&or(ia,Wn(on),0,W,Nt),sa&&or(sa,0,Wn(pn),W,Nt));let k,Y=Rn>Cn;dr=en,Gr=null;let tt=N.ori==0?W:Nt,ut=N.ori==1?W:Nt;if(on<0||bn==0||Y){k=ft.idx=null;for(let yt=0;yt<x.length;yt++){let Et=xe[yt];Et!=null&&or(Et,-10,-10,W,Nt)}ae&&zs(null,la,!0,w==null&&Un.setSeries),dt.live&&(et.fill(k),bt=!0)}else{let yt,Et,kt;s==1&&(yt=N.ori==0?on:pn,Et=Hs(yt,T),k=ft.idx=Ds(Et,t[0],Rn,Cn),kt=G(t[0][k],N,tt,0));let zt=-10,Gt=-10,fe=0,Fe=0,Ne=!0,Re="",se="";for(let Kt=s==2?1:0;Kt<x.length;Kt++){let ln=x[Kt],Sn=et[Kt],Jn=Sn==null?null:s==1?t[Kt][Sn]:t[Kt][1][Sn],je=ft.dataIdx(i,Kt,k,Et),wn=je==null?null:s==1?t[Kt][je]:t[Kt][1][je];if(bt=bt||wn!=Jn||je!=Sn,et[Kt]=je,Kt>0&&ln.show){let qi=je==null?-10:je==k?kt:G(s==1?t[0][je]:t[Kt][0][je],N,tt,0),xi=wn==null?-10:B(wn,s==1?b[ln.scale]:b[ln.facets[1].scale],ut,0);if(ae&&wn!=null){let rs=N.ori==1?on:pn,_s=qn(Wt.dist(i,Kt,je,xi,rs));if(_s<dr){let Gs=Wt.bias;if(Gs!=0){let $i=Hs(rs,ln.scale),os=wn>=0?1:-1,ys=$i>=0?1:-1;ys==os&&(ys==1?Gs==1?wn>=$i:wn<=$i:Gs==1?wn<=$i:wn>=$i)&&(dr=_s,Gr=Kt)}else dr=_s,Gr=Kt}}if(bt||Dt){let rs,_s;N.ori==0?(rs=qi,_s=xi):(rs=xi,_s=qi);let Gs,$i,os,ys,Vs,_i,Xi=!0,So=pt.bbox;if(So!=null){Xi=!1;let yi=So(i,Kt);os=yi.left,ys=yi.top,Gs=yi.width,$i=yi.height}else os=rs,ys=_s,Gs=$i=pt.size(i,Kt);if(_i=pt.fill(i,Kt),Vs=pt.stroke(i,Kt),Dt)Kt==Gr&&dr<=Wt.prox&&(zt=os,Gt=ys,fe=Gs,Fe=$i,Ne=Xi,Re=_i,se=Vs);else{let yi=xe[Kt];yi!=null&&(rn[Kt]=os,mi[Kt]=ys,wb(yi,Gs,$i,Xi),Mb(yi,_i,Vs),or(yi,gs(os),gs(ys),W,Nt))}}}}if(Dt){let Kt=Wt.prox,ln=bo==null?dr<=Kt:dr>Kt||Gr!=bo;if(bt||ln){let Sn=xe[0];Sn!=null&&(rn[0]=zt,mi[0]=Gt,wb(Sn,fe,Fe,Ne),Mb(Sn,Re,se),or(Sn,gs(zt),gs(Gt),W,Nt))}}}if(an.show&&zr)if(w!=null){let[yt,Et]=Un.scales,[kt,zt]=Un.match,[Gt,fe]=w.cursor.sync.scales,Fe=w.cursor.drag;if(Yn=Fe._x,Zn=Fe._y,Yn||Zn){let{left:Ne,top:Re,width:se,height:Kt}=w.select,ln=w.scales[Gt].ori,Sn=w.posToVal,Jn,je,wn,qi,xi,rs=yt!=null&&kt(yt,Gt),_s=Et!=null&&zt(Et,fe);rs&&Yn?(ln==0?(Jn=Ne,je=se):(Jn=Re,je=Kt),wn=b[yt],qi=G(Sn(Jn,Gt),wn,tt,0),xi=G(Sn(Jn+je,Gt),wn,tt,0),Dl(Ns(qi,xi),qn(xi-qi))):Dl(0,tt),_s&&Zn?(ln==1?(Jn=Ne,je=se):(Jn=Re,je=Kt),wn=b[Et],qi=B(Sn(Jn,fe),wn,ut,0),xi=B(Sn(Jn+je,fe),wn,ut,0),Nl(Ns(qi,xi),qn(xi-qi))):Nl(0,ut)}else xp()}else{let yt=qn(nx-tx),Et=qn(ix-ex);if(N.ori==1){let fe=yt;yt=Et,Et=fe}Yn=ei.x&&yt>=ei.dist,Zn=ei.y&&Et>=ei.dist;let kt=ei.uni;kt!=null?Yn&&Zn&&(Yn=yt>=kt,Zn=Et>=kt,!Yn&&!Zn&&(Et>yt?Zn=!0:Yn=!0)):ei.x&&ei.y&&(Yn||Zn)&&(Yn=Zn=!0);let zt,Gt;Yn&&(N.ori==0?(zt=ra,Gt=on):(zt=oa,Gt=pn),Dl(Ns(zt,Gt),qn(Gt-zt)),Zn||Nl(0,ut)),Zn&&(N.ori==1?(zt=ra,Gt=on):(zt=oa,Gt=pn),Nl(Ns(zt,Gt),qn(Gt-zt)),Yn||Dl(0,tt)),!Yn&&!Zn&&(Dl(0,0),Nl(0,0))}if(ei._x=Yn,ei._y=Zn,w==null){if(O){if(gx!=null){let[yt,Et]=Un.scales;Un.values[0]=yt!=null?Hs(N.ori==0?on:pn,yt):null,Un.values[1]=Et!=null?Hs(N.ori==1?on:pn,Et):null}Fl(kg,i,on,pn,W,Nt,k)}if(ae){let yt=O&&Un.setSeries,Et=Wt.prox;bo==null?dr<=Et&&zs(Gr,la,!0,yt):dr>Et?zs(null,la,!0,yt):Gr!=bo&&zs(Gr,la,!0,yt)}}bt&&(dt.idx=k,pp()),C!==!1&&jn("setCursor")}let Vr=null;Object.defineProperty(i,"rect",{get(){return Vr==null&&Ul(!1),Vr}});function Ul(w=!1){w?Vr=null:(Vr=m.getBoundingClientRect(),jn("syncRect",Vr))}function ox(w,C,O,k,Y,tt,ut){ft._lock||zr&&w!=null&&w.movementX==0&&w.movementY==0||(mp(w,C,O,k,Y,tt,ut,!1,w!=null),w!=null?Mo(null,!0,!0):Mo(C,!0,!1))}function mp(w,C,O,k,Y,tt,ut,yt,Et){if(Vr==null&&Ul(!1),oe(w),w!=null)O=w.clientX-Vr.left,k=w.clientY-Vr.top;else{if(O<0||k<0){on=-10,pn=-10;return}let[kt,zt]=Un.scales,Gt=C.cursor.sync,[fe,Fe]=Gt.values,[Ne,Re]=Gt.scales,[se,Kt]=Un.match,ln=C.axes[0].side%2==1,Sn=N.ori==0?W:Nt,Jn=N.ori==1?W:Nt,je=ln?tt:Y,wn=ln?Y:tt,qi=ln?k:O,xi=ln?O:k;if(Ne!=null?O=se(kt,Ne)?a(fe,b[kt],Sn,0):-10:O=Sn*(qi/je),Re!=null?k=Kt(zt,Re)?a(Fe,b[zt],Jn,0):-10:k=Jn*(xi/wn),N.ori==1){let rs=O;O=k,k=rs}}Et&&(C==null||C.cursor.event.type==kg)&&((O<=1||O>=W-1)&&(O=Vo(O,W)),(k<=1||k>=Nt-1)&&(k=Vo(k,Nt))),yt?(tx=O,ex=k,[ra,oa]=ft.move(i,O,k)):(on=O,pn=k)}let gp={width:0,height:0,left:0,top:0};function xp(){bu(gp,!1)}let ax,lx,cx,ux;function hx(w,C,O,k,Y,tt,ut){zr=!0,Yn=Zn=ei._x=ei._y=!1,mp(w,C,O,k,Y,tt,ut,!0,!1),w!=null&&(De(zg,qg,dx,!1),Fl(mb,i,ra,oa,W,Nt,null));let{left:yt,top:Et,width:kt,height:zt}=an;ax=yt,lx=Et,cx=kt,ux=zt}function dx(w,C,O,k,Y,tt,ut){zr=ei._x=ei._y=!1,mp(w,C,O,k,Y,tt,ut,!1,!0);let{left:yt,top:Et,width:kt,height:zt}=an,Gt=kt>0||zt>0,fe=ax!=yt||lx!=Et||cx!=kt||ux!=zt;if(Gt&&fe&&bu(an),ei.setScale&&Gt&&fe){let Fe=yt,Ne=kt,Re=Et,se=zt;if(N.ori==1&&(Fe=Et,Ne=zt,Re=yt,se=kt),Yn&&Hr(T,Hs(Fe,T),Hs(Fe+Ne,T)),Zn)for(let Kt in b){let ln=b[Kt];Kt!=T&&ln.from==null&&ln.min!=en&&Hr(Kt,Hs(Re+se,Kt),Hs(Re,Kt))}xp()}else ft.lock&&(ft._lock=!ft._lock,Mo(C,!0,w!=null));w!=null&&(Bn(zg,qg),Fl(zg,i,on,pn,W,Nt,null))}function jw(w,C,O,k,Y,tt,ut){if(ft._lock)return;oe(w);let yt=zr;if(zr){let Et=!0,kt=!0,zt=10,Gt,fe;N.ori==0?(Gt=Yn,fe=Zn):(Gt=Zn,fe=Yn),Gt&&fe&&(Et=on<=zt||on>=W-zt,kt=pn<=zt||pn>=Nt-zt),Gt&&Et&&(on=on<ra?0:W),fe&&kt&&(pn=pn<oa?0:Nt),Mo(null,!0,!0),zr=!1}on=-10,pn=-10,et.fill(null),Mo(null,!0,!0),yt&&(zr=yt)}function fx(w,C,O,k,Y,tt,ut){ft._lock||(oe(w),Ll(),xp(),w!=null&&Fl(_b,i,on,pn,W,Nt,null))}function px(){E.forEach(o2),V(i.width,i.height,!0)}$o(wf,ol,px);let ca={};ca.mousedown=hx,ca.mousemove=ox,ca.mouseup=dx,ca.dblclick=fx,ca.setSeries=(w,C,O,k)=>{let Y=Un.match[2];O=Y(i,C,O),O!=-1&&zs(O,k,!0,!1)},vt&&(De(mb,m,hx),De(kg,m,ox),De(gb,m,w=>{oe(w),Ul(!1)}),De(xb,m,jw),De(_b,m,fx),Qg.add(i),i.syncRect=Ul);let Mu=i.hooks=n.hooks||{};function jn(w,C,O){gi?Xe.push([w,C,O]):w in Mu&&Mu[w].forEach(k=>{k.call(null,i,C,O)})}(n.plugins||[]).forEach(w=>{for(let C in w.hooks)Mu[C]=(Mu[C]||[]).concat(w.hooks[C])});let mx=(w,C,O)=>O,Un=On({key:null,setSeries:!1,filters:{pub:Cb,sub:Cb},scales:[T,x[1]?x[1].scale:null],match:[Pb,Pb,mx],values:[null,null]},ft.sync);Un.match.length==2&&Un.match.push(mx),ft.sync=Un;let gx=Un.key,_p=TM(gx);function Fl(w,C,O,k,Y,tt,ut){Un.filters.pub(w,C,O,k,Y,tt,ut)&&_p.pub(w,C,O,k,Y,tt,ut)}_p.sub(i);function Jw(w,C,O,k,Y,tt,ut){Un.filters.sub(w,C,O,k,Y,tt,ut)&&ca[w](null,C,O,k,Y,tt,ut)}i.pub=Jw;function Kw(){_p.unsub(i),Qg.delete(i),Xn.clear(),Yg(wf,ol,px),c.remove(),Tt?.remove(),jn("destroy")}i.destroy=Kw;function yp(){jn("init",n,t),Il(t||n.data,!1),X[T]?hp(T,X[T]):Ll(),at=an.show&&(an.width>0||an.height>0),rt=bt=!0,V(n.width,n.height)}return x.forEach(Qo),E.forEach(lr),e?e instanceof HTMLElement?(e.appendChild(c),yp()):e(i,yp):yp(),i}oi.assign=On;oi.fmtNum=o0;oi.rangeNum=Ef;oi.rangeLog=Rf;oi.rangeAsinh=s0;oi.orient=Yo;oi.pxRatio=ze;oi.join=JI;oi.fmtDate=l0,oi.tzDate=l3;oi.sync=TM;{oi.addGap=W3,oi.clipGaps=If;let n=oi.paths={points:LM};n.linear=NM,n.stepped=X3,n.bars=Y3,n.spline=j3}var m0={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},BM={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},Uf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,kM=80;function a2(n){let t=[];Uf.lastIndex=0;let e=n.trimEnd();for(;Uf.lastIndex<e.length;){let i=Uf.lastIndex,s=Uf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function l2(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Ff(n,t="plain"){let e=l2(String(n));if(e.length>kM)throw new Error(`longer than ${kM} characters`);let i=a2(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in xt.suffix(t)&&(s=xt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=g=>i[o]?.sign===g,c=g=>{if(!l(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;l("+")||l("-");){let x=i[o++].sign,E=h();g=x==="+"?g+E:g-E}return g}function h(){let g=d();for(;;)if(l("*"))o++,g*=d();else if(l("/"))o++,g/=d();else if(i[o]?.word||l("("))g*=f();else return g}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let g=m();return l("^")?(o++,g**d()):g}function m(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let x=u();return c(")"),x}if(g.word){let x=g.word.toLowerCase();if(Object.hasOwn(BM,x))return a=!0,BM[x];if(Object.hasOwn(m0,x)){c("(");let E=u();return c(")"),m0[x](E)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(m0).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let _=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(_))throw new Error("not a finite number");let p=s??(t==="angle"&&a?1:xt.factor(t));return{value:_/p+0,symbolic:a||s!==null||i.length>2}}function An({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=v("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let p=Ff(c.value,l()),g=a?.(p.value);if(g)throw new Error(g);return p},f=p=>{c.classList.toggle("wrong",!!p),p?(c.setAttribute("aria-invalid","true"),c.title=p):(c.removeAttribute("aria-invalid"),c.title=o??""),g0(c,p),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:p?{label:n,reason:p}:null}))},m=p=>{try{let g=d();return f(null),p?.(g.value,{symbolic:g.symbolic,text:c.value.trim()}),!0}catch(g){return f(g.message),!1}};c.addEventListener("input",()=>m(e)),c.addEventListener("change",()=>{m(i??e)&&c.blurred?.()});let _="";return c.addEventListener("focus",()=>{_=c.value,c.classList.contains("wrong")&&g0(c,c.title),c.select()}),c.addEventListener("blur",()=>g0(c,null)),c.addEventListener("keydown",p=>{let g=c.closest("table.dh");if(p.key==="Escape"&&c.value!==_){p.preventDefault(),c.value=_,m(i??e),c.select();return}if(g&&c2(c,p))return;let x={ArrowUp:1,ArrowDown:-1}[p.key];if(p.key==="Enter"&&(_=c.value,c.select()),!(!x||g&&!p.altKey)){p.preventDefault();try{let E=d();c.value=kc((E.value??0)+x*xt.step(l())*(p.shiftKey?.1:1),l()),m(i??e)}catch{}}}),c.put=(p,g=null)=>{document.activeElement===c&&!c.readOnly||p===u&&g===h&&!c.classList.contains("wrong")||(u=p,h=g,c.value=g??(p==null?"":kc(p,l())),x0(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>x0(c)),c.refresh=()=>{let p=u,g=h;u=NaN,c.put(p,g)},c}function x0(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&x0(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Li=null;function g0(n,t){if(!t){Li&&Li.about===n&&(Li.hidden=!0),n.removeAttribute("aria-describedby");return}Li||(Li=v("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Li)),Li.about=n,Li.hidden=!1,Li.textContent!==t&&(Li.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Li.style.setProperty("top",`${e.bottom+4}px`),Li.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Li.offsetWidth-8))}px`)}addEventListener("scroll",()=>Li&&(Li.hidden=!0),!0);function c2(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function Of(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function Bf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Ke=n=>n.type==="R"?"angle":"length";function zM(n){let t=n.type==="R"?Math.PI:li(M.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var u2=rg;function h2(n){let t=M.table.joints[n],e=Ke(t),{lo:i,hi:s,min:r,max:o}=zM(t),a=`q${n+1}`,l=v("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=_=>`${100*(_-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{fi(),Ru(n,Number(l.value))}),l.addEventListener("keydown",_=>{let p={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[_.key],g={Home:i,End:s}[_.key];if(p===void 0&&g===void 0)return;_.preventDefault(),fi();let x=xt.step(e)*(_.shiftKey?.1:1);Ru(n,g??Math.min(Math.max(Math.round((M.q[n]+p*x)/(x/10))*(x/10),r),o))});let u=An({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:_=>{fi(),Ru(n,_)}}),h=v("span",{class:"out",role:"note"}),d=v("span",{class:"chain",title:"What this row of the table moves by"}),f=v("span",{class:"limits"}),m=v("div",{class:"joint","data-testid":`joint-${n+1}`},v("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},v("i",{text:"q"}),v("sub",{text:String(n+1)})),v("div",{class:"track"},l,v("div",{class:"under"},f,d,h)),u,v("span",{class:"unit"}));return{el:m,number:u,show(){let _=M.q[n],p=u2(t,_);(document.activeElement!==l||Number(l.value)!==_)&&(l.value=_),l.style.setProperty("--at",c(Math.min(Math.max(_,r),o))),l.setAttribute("aria-valuetext",ue(_,e)),u.put(Number((_*xt.factor(e)).toFixed(xt.digits(e)+1))/xt.factor(e)),m.classList.toggle("outside",p!==0);let g=M.table.coupling?`chain ${ue(mr(M.table,M.q)[n],e)}`:"";gt(d,g),gt(h,p?`${ue(Math.abs(p),e)} ${p>0?"above":"below"} the limit`:"")},relabel(){gt(m.lastChild,xt.symbol(e));let _=p=>p===null?"no limit":ue(p,e,xt.angle==="deg"&&e==="angle"?0:void 0);gt(f,t.lower===null&&t.upper===null?"no limits":`${_(t.lower)} \u2026 ${_(t.upper)}`),u.refresh(),this.show()}}}var HM={id:"joints",title:"Joints",build(n){let t=[],e=v("div",{class:"joints","data-testid":"joints"}),i=v("div",{class:"chips",role:"group","aria-label":"Postures"}),s=v("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=M.table.joints.map((o,a)=>h2(a)),Vt(e,t.map(o=>o.el)),t.length||e.append(v("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Vt(s,M.table.actuator?d2(M.table.actuator):null),f2(i)};nt("table",o=>o!=="gripper"&&r()),nt("q",()=>t.forEach(o=>o.show())),nt("units",()=>t.forEach(o=>o.relabel())),r()}};function d2(n){let t=v("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=v("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),gt(e,ti(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},mn({...M.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=v("div",{class:"under"},v("span",{text:`${n.name}: moves no frame`}));return v("div",{class:"joint"},v("span",{class:"joint-name",text:"tool"}),v("div",{class:"track"},t,s),e,v("span",{class:"unit",text:n.unit}))}function f2(n){let t=M.table.joints.length,e=Object.entries(M.table.postures??{}),i=(r,o)=>v("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>ue(a,Ke(M.table.joints[l]))).join(", "),on:{click:()=>Pi(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Vt(n,s,t?v("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>Pi(p2(),.8,"move to a random posture")}}):null,t?v("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:m2}}):null)}function p2(){return M.table.joints.map(n=>{let{lo:t,hi:e}=zM(n);return t+Math.random()*(e-t)})}function m2(){let n={...M.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=M.q.slice(),mn({...M.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),Pe(`Kept as P${t}: ${M.q.map((e,i)=>kc(e,Ke(M.table.joints[i]))).join(", ")}`),ht("postures")}var GM=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function ar({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(u=>vs(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(u=>ee(u[u.length-1])),speeds:o??g2(t,r),least:t.map((u,h)=>Au(n,u,c[h])[0]??0)}}function g2(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function _0(n,t){let{table:e}=n,i=xt.factor("length");if(t==="position")return{y:`tool, ${xt.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(u=>u[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(Ke))].map(l=>(l==="angle"?xt.angle:xt.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(u=>u[c]*xt.factor(Ke(l)))}))}}function VM(n){let t=xt.angle,e=xt.length,{table:i}=n,s=l=>Ke(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*xt.factor("length")),...l.map((u,h)=>u*xt.factor(Ke(i.joints[h]))),...n.speeds[c].map((u,h)=>u*xt.factor(Ke(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function WM(n,t,e){let{y:i,list:s}=_0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(y=>y.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,m]=[Math.min(...c),Math.max(...c)];m-f>1e-9||(f-=1,m+=1);let _=y=>a.l+(y-h)/(d-h)*(r-a.l-a.r),p=y=>o-a.b-(y-f)/(m-f)*(o-a.t-a.b),g=(y,S)=>{let D=(S-y)/6,L=10**Math.floor(Math.log10(D)),N=[1,2,5,10].map(z=>z*L).find(z=>z>=D);return Array.from({length:12},(z,G)=>(Math.ceil(y/N)+G)*N).filter(z=>z<=S+N*1e-6)},x=y=>y.toFixed(2),E=y=>String(Number(y.toPrecision(6))),b=y=>y.replace(/[&<>"]/g,S=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[S]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],T=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${b(n.title)}</text>`];for(let y of g(f,m))T.push(`<path d="M${a.l} ${x(p(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(p(y)+4)}" text-anchor="end">${E(y)}</text>`);for(let y of g(h,d))T.push(`<path d="M${x(_(y))} ${o-a.b}v5" stroke="#333"/><text x="${x(_(y))}" y="${o-a.b+20}" text-anchor="middle">${E(y)}</text>`);T.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&T.push(`<path d="M${x(_(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(_(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${b(y.short)}</text>`);return s.forEach((y,S)=>{let D=e[S%e.length],L=y.values[y.values.length-1];T.push(`<polyline fill="none" stroke="${D}" stroke-width="1.8" stroke-dasharray="${A[S%A.length]}" points="${y.values.map((N,z)=>`${x(_(l[z]))},${x(p(N))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*S}h22" stroke="${D}" stroke-width="2" stroke-dasharray="${A[S%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*S}"><title>${x(L)}</title>${b(y.name)}</text>`)}),T.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${b(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${b(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${T.join("")}</svg>
`}async function qM(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var We=null,$n=null,pl="joints",Hi=0,$M=1,pi=null;function XM(n){let t=v("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:ZM}}),e=v("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{fi(),Or(Number(e.value))}}}),i=v("output",{class:"where","data-testid":"where"}),s=v("div",{class:"marks"}),r=v("div",{class:"chart","data-testid":"chart"}),o=v("div",{class:"legend"});n.append(v("div",{class:"dock-bar"},t,gn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{$M=Number(a)},{"data-testid":"speed"}),v("div",{class:"scrubber"},e,s),i,v("span",{class:"line"},...[["CSV",()=>bi("motion.csv",VM(We),"text/csv")],["PNG",y2],["Film",_2],["SVG",()=>bi(`${pl}.svg`,WM(We,pl,Bt.curves),"image/svg+xml")]].map(([a,l])=>v("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>We&&l()}})),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>Di(null)}}))),v("div",{class:"dock-bar second"},Je("Curves",GM,pl,a=>{pl=a,y0()},"curves"),o),r),pi={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Xs(()=>$n&&r.clientWidth&&$n.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),nt(["units","theme"],y0),nt("moving",a=>gt(t,a&&zf?"Pause":"Play")),nt("table",a=>{We&&!["postures","name","gripper"].includes(a)&&Di(null)})}function Di(n){if(fi(),We=n,M.motion=n,pi.root.hidden=!n,$n&&($n.destroy(),$n=null),Hv(n?.table??null,n?.q??[]),!n){ht("motion");return}pi.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Vt(pi.marks,n.events.map(e=>{let i=v("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=v("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),y0(),ht("motion"),n.q.length&&Or(0),requestAnimationFrame(()=>ja())}var YM=()=>Hi;function Or(n){We?.q.length&&(Hi=Math.min(Math.max(Math.round(n),0),We.q.length-1),pi.scrub.value=String(Hi),pi.scrub.style.setProperty("--at",`${We.q.length>1?100*Hi/(We.q.length-1):0}%`),gt(pi.where,We.xName==="point"?`point ${Hi+1} of ${We.q.length}`:`${ti(We.xs[Hi],2)} s of ${ti(We.xs[We.xs.length-1],2)} s`),pi.scrub.setAttribute("aria-valuetext",pi.where.textContent),Ui(We.q[Hi].slice(),"scrub"),ht("played",We.seconds[Hi]),v0())}var zf=!1;function ZM(n,t){if(zf){fi();return}if(!We?.q.length)return;let e=We.seconds,i=e[e.length-1]||1,s=Hi>=We.q.length-1?0:e[Hi]/i;zf=!0,eb(i/$M,s,r=>{let o=Hi<=We.q.length-1&&e[Hi]<=r*i?Hi:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;Or(o)},()=>{zf=!1,gt(pi.toggle,"Play"),t?.()}),gt(pi.toggle,"Pause")}function y0(){if(!We||!pi)return;$n&&($n.destroy(),$n=null);let{y:n,list:t}=_0(We,pl),e={stroke:Bt.line,width:1},i=`${Math.round(.78*kf())}px "Inter Variable", system-ui, sans-serif`;Vt(pi.legend,t.map((o,a)=>{let l=v("span",{class:"swatch"});return l.style.setProperty("background",Bt.curves[a%Bt.curves.length]),v("span",{},l,o.name)}));let s={stroke:Bt.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*kf(),gap:4};$n=new oi({width:pi.chart.clientWidth||600,height:pi.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,We.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:Bt.curves[a%Bt.curves.length],width:1.75,pxAlign:0,points:{show:We.q.length<3}}))],axes:[{...s,label:We.xName==="point"?"point number":"time, s",size:2.1*kf()},{...s,label:n,size:4*kf()}]},[We.xs,...t.map(o=>o.values)],pi.chart);let r=v("div",{class:"now"});$n.over.append(r,...We.events.map(o=>{let a=v("div",{class:`event ${o.stop?"stop":""}`,title:o.text},v("span",{text:o.short}));return a.x=o.x,a})),$n.over.addEventListener("pointerdown",o=>{let a=u=>Or(x2($n.posToVal(u.clientX-$n.over.getBoundingClientRect().left,"x")));fi(),a(o);let l=u=>a(u),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),$n.hooks.setSize=[v0],v0()}var kf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),x2=n=>We.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(We.xs[t]-n)?i:t,0);function v0(){if(!$n)return;let n=$n.over.clientWidth;for(let t of $n.over.querySelectorAll(".now, .event")){let e=$n.valToPos(t.x??We.xs[Hi],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}async function _2(){fi(),Or(0);try{let n=await Za(t=>qM(t,()=>new Promise(e=>ZM(null,e))));bi("motion.webm",n)}catch(n){Pe(n.message,"wrong")}}function y2(){let n=$n.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Bt.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>bi(`${pl}.png`,i))}function gl(n,t){let e=Array.from({length:16},(s,r)=>v("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=v("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>v("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;gt(e[r],r>=12?String(s[r]):o?ti(s[r]*xt.factor("length"),xt.digits("length")):ti(s[r],4))}},i}var Hf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var b0="pieper-panel-width",M0=18,jM=70;function JM(n,t){let e=v("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(M0),"aria-valuemax":String(jM),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,M0),jM,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(b0):localStorage.setItem(b0,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(b0));o>=M0?r(o):e.setAttribute("aria-valuenow","38")}function KM(n){let t=gl("Pose of the tool, large","present-pose"),e=v("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=v("button",{type:"button",text:"Present","aria-pressed":"false","data-testid":"present",on:{click:()=>o(i.dataset.present!=="yes")}}),r=()=>!e.hidden&&t.show(M.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ht("units"),dispatchEvent(new Event("resize"))}return nt(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function QM(){Za(n=>n.toBlob(t=>t?bi(`${M.table.name||"arm"}.png`,t):Pe("The picture could not be read.","wrong")))}var v2="http://www.w3.org/2000/svg";function b2(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(v2,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}function tS(n){let t=null,e=v("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=v("span",{class:"hint",role:"status"}),s=v("input",{type:"text",placeholder:"Name, maker, or joints such as 7R","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>a(),keydown:l=>{if(l.key==="ArrowDown")e.firstElementChild?.focus();else if(l.key==="Enter")e.firstElementChild?.click();else return;l.preventDefault()}}}),r=v("dialog",{class:"catalogue","aria-label":"Catalogue"},v("div",{class:"line"},s,i,v("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the catalogue",on:{click:()=>r.close()}})),e);document.body.append(r);let o=l=>/^(.)\1*$/.test(l)?`${l.length}${l[0]}`:l;function a(){let l=s.value.toLowerCase().split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>{let h=`${u.name} ${u.maker} ${u.joints} ${o(u.joints)}`.toLowerCase();return l.every(d=>h.includes(d))});i.textContent=`${c.length} of ${t?.length??0} arms`,Vt(e,c.map(u=>v("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},b2(u.points),v("span",{},v("b",{text:u.name}),v("span",{class:"hint",text:[u.maker,o(u.joints)].filter(Boolean).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Yi("catalog")).arms,a()}catch(l){Pe(l.message,"wrong")}}}var lu=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),go=(n,t)=>[...n.children].filter(e=>e.localName===t),M2=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function S2(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function w2([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var eS={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:w2},E2={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function nS(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(m=>m.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=E2[e("up_axis")[0]?.textContent.trim()]??M2(),a=[];function l(f){let m=s(go(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),_=m&&[...m.getElementsByTagName("*")].find(g=>g.localName==="diffuse"),p=_?lu(go(_,"color")[0]):[];return p.length>=3?[p[0],p[1],p[2],p[3]??1]:null}function c(f){let m=go(f,"input").find(p=>p.getAttribute("semantic")==="POSITION"),_=s(m?.getAttribute("source"));return _?lu(go(_,"float_array")[0]):[]}function u(f,m,_){let p=f&&go(f,"mesh")[0];if(p)for(let g of p.children){if(!["triangles","polylist","polygons"].includes(g.localName))continue;let x=go(g,"input"),E=1+Math.max(...x.map(G=>Number(G.getAttribute("offset")??0))),b=x.find(G=>G.getAttribute("semantic")==="VERTEX");if(!b)continue;let A=Number(b.getAttribute("offset")??0),T=c(s(b.getAttribute("source"))),y=go(g,"p").map(lu),S=g.localName==="polylist"?lu(go(g,"vcount")[0]):g.localName==="polygons"?y.map(G=>G.length/E):new Array(y.reduce((G,B)=>G+B.length,0)/E/3).fill(3),D=y.flat(),L=[],N=0,z=G=>{let B=3*D[(N+G)*E+A],[X,P,U]=[T[B],T[B+1],T[B+2]];for(let Z=0;Z<3;Z++)L.push(r*(m[4*Z]*X+m[4*Z+1]*P+m[4*Z+2]*U+m[4*Z+3]))};for(let G of S){for(let B=2;B<G;B++)for(let X of[0,B-1,B])z(X);N+=G}L.length&&L.every(Number.isFinite)&&a.push({at:Float32Array.from(L),colour:l(_.get(g.getAttribute("material")))})}}function h(f,m,_){if(!(_>60)){for(let p of f.children)eS[p.localName]&&(m=S2(m,eS[p.localName](lu(p))));for(let p of f.children)if(p.localName==="instance_geometry"){let g=new Map([...p.getElementsByTagName("*")].filter(x=>x.localName==="instance_material").map(x=>[x.getAttribute("symbol"),x.getAttribute("target")]));u(s(p.getAttribute("url")),m,g)}else if(p.localName==="node")h(p,m,_+1);else if(p.localName==="instance_node"){let g=s(p.getAttribute("url"));g&&h(g,m,_+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var Gf=[],cu=new Map,Vf=0;function T2(){if(Gf.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=cu.get(t);cu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of cu.values())t(new Error("meshes cannot be read in this browser"));cu.clear()},Gf.push(n),n}return Gf[Vf%Gf.length]}function iS(n,t){return new Promise((e,i)=>{Vf+=1,cu.set(Vf,{resolve:e,reject:i}),T2().postMessage({id:Vf,...n},t)})}async function sS(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=nS(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await iS({at:r},[r.buffer]),colour:o})))}return[{mesh:await iS({bytes:i,kind:e},[i]),colour:null}]}var rS={light:"#c9ced6",dark:"#8b96a6"},_l=new En,Us=[],uu=0,lS=!1,cS=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function yl(n,t,e=null){M.looks=n?.shapes.length?{...n,key:cS(t),files:e}:null,n?.notes.length&&Pe(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),A2()}var w0=()=>!!(M.looks&&M.looks.key===cS(M.table)),E0=()=>w0()?M.look.mode:"sketch",Wf=null;function A2(){if(Wf===M.looks)return;Wf=M.looks;for(let t of Us)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();Us=[],_l.clear();let n=Wf;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){aS(t,[R2[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(uu+=1,sS(e,t.url??t.file).then(i=>{if(Wf===n)for(let{mesh:s,colour:r}of i){let o=S0(s),a=s.some===s?o:S0(s.some);aS(t,[o,a,s.few===s.some?a:S0(s.few)],t.colour??r,t.size)}}).catch(i=>Pe(`${t.name}: ${i.message}`,"wrong")).finally(()=>{uu-=1,xl(),uu||ht("looks","loaded")}))}ht("looks"),xl()}var oS=n=>n.rotateX(Math.PI/2),R2={box:n=>new Oi(...n),cylinder:([n,t])=>oS(new Ai(n,n,t,36)),capsule:([n,t])=>oS(new Io(n,t,8,24)),sphere:([n])=>new Es(n,28,16)};function S0(n){let t=new be;return t.setAttribute("position",new Oe(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new Oe(n.normal,3):C2(n.normal)),t.setIndex(new Oe(n.index,1)),t}function C2(n){return new Kr(new Ro(n,4),3,0,!0)}function aS(n,[t,e=t,i=e],s,r=null){let o=ov(),a=new Ye(t,o),l=new Ye(i,af),c=new ge().set(...n.T);r&&c.scale(new H(...r));for(let u of[a,l])u.matrixAutoUpdate=!1,u.frustumCulled=!1;l.renderOrder=-1,_l.add(a,l),Us.push({on:n.on,T:c,fine:t,some:e,few:i,mesh:a,shadow:l,colour:s}),hu()}var P2=new ge;function xl(){uS(),_e()}function uS(){let n=E0();if(_l.visible=n!=="sketch"&&Us.length>0,Ov(n!=="real"||uu>0,n!=="sketch"&&Us.length>0),!!_l.visible)for(let t of Us){let e=M.frames[t.on];e&&(t.mesh.geometry=lS?t.few:Yy()?t.some:t.fine,t.mesh.matrix.copy(P2.set(...e)).multiply(t.T),t.shadow.matrix.copy(Rg).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function hu(){let n=E0()==="both"?M.look.opacity:1;for(let{mesh:t,colour:e}of Us){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,ii):t.material.colour.set(Bt.dark?rS.dark:rS.light),t.material.see((o??1)*n,Bt.dark)}_e()}function T0(n){M.look={...M.look,...n},hu(),xl(),ht("look")}function hS(){hn.add(_l),nt("table",()=>{xl(),hu(),ht("looks")}),nt("q",xl),nt("theme",hu),nt("look",n=>{n==="loaded"&&(hu(),xl())}),nt("hurry",n=>{lS=n,uS()})}var dS=()=>({mode:E0(),visible:_l.visible,loading:uu,shapes:Us.length,triangles:Us.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:Us.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:Us.map(n=>n.mesh.matrix.clone().transpose().toArray())});function pS(){let n=Je("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],M.look.mode,s=>T0({mode:s}),"look"),t=v("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(M.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>T0({opacity:Number(t.value)})}}),e=v("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!w0(),n.mark(M.look.mode),t.hidden=M.look.mode!=="both",t.value=String(M.look.opacity)};return nt(["looks","look","table"],i),i(),e}function gS(n){let t=v("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>mS(t.value)}}),e=tS(mS),i=v("p",{class:"sentence","data-testid":"sentence"}),s=v("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let m=v("button",{type:"button",text:u,"aria-label":h,on:{click:d}});return m.show=_=>{m.disabled=!_,m.title=_?`${h}: ${_} (${f})`:`Nothing to ${h.toLowerCase()}`,m.setAttribute("aria-description",_??"")},m},o=r("\u21B6","Undo",Ug,"Ctrl+Z"),a=r("\u21B7","Redo",Fg,"Ctrl+Shift+Z");nt("history",()=>{o.show(pf()),a.show(mf())});let l=()=>{let{name:u,derived:h,catalog:d}=M.table,f=d?[]:[v("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Vt(t,f,(M.catalog??[]).map(m=>v("option",{value:m,text:m}))),t.value=d??""},c=v("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(v("span",{class:"mark"},v("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),v("b",{text:"pieper"})),t,v("button",{type:"button",class:"find",text:"Find\u2026","aria-label":"Find an arm in the catalogue","data-testid":"find-arm",on:{click:e}}),c,i,v("span",{class:"bar-end"},s,Je("Angles in",[["deg","\xB0"],["rad","rad"]],xt.angle,u=>{xt.set("angle",u),ht("units")},"unit-angle"),Je("Lengths in",[["mm","mm"],["m","m"]],xt.length,u=>{xt.set("length",u),ht("units")},"unit-length"),gn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],M.theme,Ud,{"data-testid":"theme"}))),ht("history"),nt(["catalog","table"],l),nt("plan",()=>{gt(i,[Pu(M.plan),Px(M.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=M.plan?.explain??""}),nt("online",u=>{gt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),nt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(xt.angle),n.querySelector("[data-testid=unit-length]").mark(xt.length),n.querySelector("[data-testid=theme]").value=M.theme})}async function mS(n){if(n)try{let{table:t}=await Yi("load",{name:n});mn(t,{q:ua(t),what:"new",label:`open ${n}`})}catch(t){Pe(t.message,"wrong")}}function xS(n,t,e,i){let s=v("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=v("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=v("section",{class:"section"},v("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=v("button",{type:"button",role:"tab",id:`tab-${c.id}`,"aria-controls":u.id,text:c.title,on:{click:()=>l(c.id)}});return c.group&&s.append(v("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(M.panel,t.scrollTop),M.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ht("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(m=>!m.tab.hidden),d=h.findIndex(m=>m.id===M.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(M.panel==="move"||!a.some(c=>c.id===M.panel)?"move":M.panel)),l(M.panel),l}function _S(n){let t=v("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>v("button",{type:"button",text:u,on:{click:()=>Qm(c)}})),v("button",{type:"button",text:"Fit",on:{click:()=>Yc()}})),e=v("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=v("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),jv(c)}}}),s=v("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:hf}}),r=v("span",{class:"scale"}),o=v("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=v("span",{class:"dot"});return h.style.setProperty("background",Pr[u]),v("span",{},h,c)}),r);n.append(v("div",{class:"corner top"},t,v("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),pS(),v("div",{class:"group",role:"group","aria-label":"The picture"},KM(n),v("button",{type:"button",text:"PNG","aria-label":"Save the picture","data-testid":"save-picture",on:{click:QM}}))),v("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=M.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);M.shownFrames=(M.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{M.shownFrames=d,l()};Vt(e,v("span",{class:"group-name",text:"Frames"}),u.map(d=>v("button",{type:"button",text:uf(d),"aria-pressed":String(M.shownFrames.includes(d)),"aria-label":`Frame ${uf(d)}`,on:{click:()=>h(M.shownFrames.includes(d)?M.shownFrames.filter(f=>f!==d):[...M.shownFrames,d])}})),v("button",{type:"button",text:M.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(M.shownFrames.length===c+2?[]:u)}})),ht("frames"),gt(r,`grid ${ue(eg.cell,"length",xt.length==="mm"?0:2)}`)};nt(["table","units"],l),l()}function yS(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Ug()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Fg()))})}var A0=()=>M.frames[M.frames.length-1],bS={id:"pose",title:"Pose",build(n){let t=gl("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>vS(u,"length",`pose-${u.toLowerCase()}`)),i=v("div",{class:"quantities","data-testid":"orientation"}),s=v("p",{class:"hint order"}),r=[],o=gn("Notation of the orientation",Object.entries(Cs).map(([u,h])=>[u,h.title]),M.notation,u=>{M.notation=u,ht("notation")}),a=v("span",{class:"copies"},v("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>Wr(Hf(A0()))}}),v("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>Wr(I2())}}));n.append(v("div",{class:"subhead"},v("span",{text:"Tool in the base frame"}),a),t,v("div",{class:"quantities"},e.map(u=>u.el)),v("div",{class:"line"},o,s),i);let l=()=>{let u=Cs[M.notation];o.value=M.notation,gt(s,u.order),r=u.names.map((h,d)=>vS(h,u.kinds[d],`turn-${d}`)),Vt(i,r.map(h=>h.el)),c()},c=()=>{let u=A0();t.show(u),ee(u).forEach((h,d)=>e[d].show(h)),Cs[M.notation].to(u).forEach((h,d)=>r[d].show(h))};nt("q",c),nt("notation",l),nt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function I2(){let n=A0(),t=Cs[M.notation],e=ee(n).map((s,r)=>`${"XYZ"[r]} ${xn(s,"length")} ${xt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${xn(s,"angle")} ${xt.symbol("angle")}`:ti(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function vS(n,t,e){let i=v("output",{"data-testid":e}),s=v("span",{class:"unit",text:xt.symbol(t)});return{el:v("div",{class:"quantity"},v("span",{class:"quantity-name",text:n}),i,s),show:o=>gt(i,t==="plain"?ti(o,5):xn(o,t)),relabel:()=>gt(s,xt.symbol(t))}}function L2(n,t){let e=[],i=n.joints.length,s=mr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=pr(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*pr(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var MS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=v("div",{class:"cards","data-testid":"matrices"}),a=v("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=gn("Posture",[["now","present posture"]],"now",m=>{e=m,d()}),c=v("span",{class:"partial"});n.append(v("div",{class:"line"},Je("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,m=>{t=m,h()},"matrix-mode"),c),v("div",{class:"line"},v("span",{class:"field-name",text:"Numbers of the"}),l),o,v("h3",{text:"Intermediate angles"}),v("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&M.solutions?.rows[Number(e)]?.q||M.q,h=()=>{let m=M.table.joints.length;i=Math.min(i,m),s=s===0||s>m?m:s;let _=t==="links"?M.table.joints.map((g,x)=>["A",String(x+1),""]):t==="products"?M.table.joints.map((g,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&_.push(["T","tool","base"]);let p=Array.from({length:m+1},(g,x)=>[String(x),String(x)]);Vt(c,t==="partial"?[gn("From frame",p,String(i),g=>{i=Number(g),h()})," \u2192 ",gn("To frame",p,String(s),g=>{s=Number(g),h()})]:[]),r=_.map(([g,x,E])=>({grid:gl(`${g} ${E} ${x}`,`matrix-${g}${E}${E?"-":""}${x}`),note:v("span",{class:"hint"}),sym:g,low:x,high:E})),Vt(o,r.map(({grid:g,note:x,sym:E,low:b,high:A})=>v("figure",{class:"card"},v("figcaption",{},v("span",{class:"symbol"},A?v("sup",{text:A}):null,v("i",{text:E}),v("sub",{text:b})),x),g))),d()},d=Xs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let m=u(),_=vx(M.table,m),p=_.length;r.forEach(({grid:E,note:b},A)=>{if(t==="links"&&A<p)E.show(_[A]),gt(b,`q${A+1} = ${ue(m[A],Ke(M.table.joints[A]))}`);else if(t==="links")E.show(vs(M.table,m)[p+1]);else if(t==="products")E.show(_.slice(0,A+1).reduce(ni,fr()));else{let T=y=>_.slice(0,y).reduce(ni,fr());E.show(ni(Su(T(i)),T(s)))}});let g=mr(M.table,m),x=M.table.joints.map((E,b)=>[E.type==="R"?`\u03B8${b+1}`:`d${b+1}`,E.type==="R"?xn(pr(E,g[b]).theta,"angle"):xn(pr(E,g[b]).d,"length"),E.type==="R"?"angle":"length"]).concat(L2(M.table,m).map(({name:E,value:b})=>[`\u03B8${E}`,xn(b,"angle"),"angle"]));Vt(a,v("tbody",{},x.map(([E,b,A])=>v("tr",{},v("th",{scope:"row"},v("i",{text:E[0]}),v("sub",{text:E.slice(1)})),v("td",{text:b}),v("td",{class:"unit",text:xt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let m=M.solutions?.rows??[];Vt(l,v("option",{value:"now",text:"present posture"}),m.map((_,p)=>v("option",{value:String(p),text:`solution ${p+1}: ${_.label??""}`}))),e!=="now"&&!m[Number(e)]&&(e="now"),l.value=e,d()};nt("table",h),nt(["q","units","panel"],d),nt(["solutions","panel"],f),h()}};var D2=.002;function Fs(n,t,e,i){let s=[],r="",o=v("div",{class:"pose-fields"}),a=()=>{let c=Cs[M.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=hv(M.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,N2(s))};s=u.map(([d,f],m)=>{let _={value:0,kind:f},p=(g,x)=>{_.value=g,_.text=x.text,h()};return _.f=An({label:`${n}, ${d}`,kind:f,testid:`${t}-${m}`,input:p,commit:(g,x)=>{p(g,x),ht("let-go")}}),_.el=v("label",{class:"pose-field"},v("span",{text:d}),_.f,v("span",{class:"unit",text:xt.symbol(f)})),_}),Vt(o,s.map(d=>d.el)),r=M.notation},l=()=>{r!==M.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...ee(c),...Cs[M.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,U2(u,s[h].kind))})};return nt("units",()=>{a(),l()}),nt("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=Of(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),Bf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:v("fieldset",{class:"pose-editor"},v("legend",{text:n}),o),show:l}}function N2(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?Qa(t(e),"angle"):2*Qa(t(n.slice(3)),"plain");return{metres:Qa(t(n.slice(0,3)),"length"),radians:i}}var U2=(n,t)=>String(Number((n*xt.factor(t)).toFixed(t==="plain"||xt[t]==="m"||xt[t]==="rad"?6:3))+0);function SS(n){let t=n.match(wS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:Qa(e,"length"),radians:2*Qa(i,"plain")}}var wS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function ES(n){let t=(n.replaceAll("\u2212","-").match(wS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Eu(e);if(i>D2)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=xt.factor("length");return Tu(e)}function qf(n){return n.map((t,e)=>{let i=M.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((M.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function TS(n,t){let e=t?.self_motions??[],i=he.task??M.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Vt(n,v("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let m=d.moves.length>3?"most of its joints":d.moves.join(" and "),_=d.inside.length?k2(d):"All of it lies outside the limits.";return v("div",{class:"self-motion"},v("p",{},v("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${m}, ${a(d)}: the arm moves, ${o}. ${_}`),H2(d,f,t.T,s))},c=e.length?O2(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?v("details",{class:"fold"},v("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Vt(n,c>=0?l(e[c],c):null,h)}var F2=n=>n.reduce((t,e,i)=>t+Math.sin((e-M.q[i])/2)**2,0),O2=n=>{let t=n.map(e=>Math.min(...e.q.map(F2)));return t.indexOf(Math.min(...t))};function B2(n){let t=(s,r)=>s.map((o,a)=>M.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(M.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var k2=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function z2(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function H2(n,t,e,i){let s=v("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{fi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ht("did",{label:"slide along a self-motion",key:"self-motion"}),Ui(qf(i?Mx(M.table,u,e):u),"self-motion")};return s.value=String(B2(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",z2(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function AS(){let n=[],t=[],e={},i=v("div",{class:"joints"}),s=v("details",{},v("summary",{class:"hint",text:"Hold by value"}),i),r=v("p",{class:"hint"}),o=Je("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(m=>!m.instead).map(m=>m.name):null),"spare-mode"),a=v("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},v("div",{class:"line spread"},v("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:m=!1}={}){ht("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),he.redundancy=f&&Object.fromEntries(f.map(_=>[_,e[_]])),d(),m?Qv():Ps({follow:!0})}let c=f=>n.filter(m=>m.instead===f.instead).map(m=>m.name),u=f=>M.table.joints.findIndex(m=>m.name===f.name);function h(f,m){let _=f.kind==="angle"?Math.PI:li(M.table),p=f.lower??-_,g=f.upper??_,x=v("input",{type:"range",min:String(p),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${m+1}`}),E=!1,b=(S,D)=>{e[f.name]=S,l(c(f),{sliding:D})};x.addEventListener("input",()=>b(Number(x.value),!0)),x.addEventListener("change",()=>Ps({follow:!0})),x.addEventListener("keydown",S=>{let D={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[S.key];if(D===void 0)return;S.preventDefault(),E=!0;let L=D*xt.step(f.kind)*(S.shiftKey?.1:1);b(Math.min(Math.max(e[f.name]+L,p),g),!0)}),x.addEventListener("keyup",()=>{E&&Ps({follow:!0}),E=!1});let A=An({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${m+1}`,check:S=>S<p-1e-9&&f.lower!==null?`below the limit ${ue(p,f.kind)}`:S>g+1e-9&&f.upper!==null?`above the limit ${ue(g,f.kind)}`:null,commit:S=>b(S,!1)}),T=v("span",{class:"limits"}),y=v("div",{class:"joint"},v("span",{class:"joint-name",text:f.name}),v("div",{class:"track"},x,v("div",{class:"under"},T)),A,v("span",{class:"unit"}));return{line:y,show(){let S=e[f.name];x.value=S,x.style.setProperty("--at",`${100*(Math.min(Math.max(S,p),g)-p)/(g-p||1)}%`),x.setAttribute("aria-valuetext",ue(S,f.kind)),y.classList.toggle("held",!!(he.redundancy&&f.name in he.redundancy)),A.put(Number((S*xt.factor(f.kind)).toFixed(xt.digits(f.kind)+1))/xt.factor(f.kind))},relabel(){gt(y.lastChild,xt.symbol(f.kind));let S=D=>D===null?"no limit":ue(D,f.kind,f.kind==="angle"&&xt.angle==="deg"?0:void 0);gt(T,f.lower===null&&f.upper===null?"no limits":`${S(f.lower)} \u2026 ${S(f.upper)}`),A.refresh()}}}function d(){for(let f of n)he.redundancy&&f.name in he.redundancy?e[f.name]=he.redundancy[f.name]:u(f)>=0?e[f.name]=M.q[u(f)]:f.instead&&Number.isFinite(M.solutions?.arm_angle)?e[f.name]=M.solutions.arm_angle:e[f.name]??=0;o.mark(he.redundancy?"chosen":"free"),gt(r,he.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return nt("solutions",()=>{let f=M.solutions?.spare;if(!M.solutions||!f&&(M.solutions.brief||M.solutions.status==="REFUSED"))return;let m=JSON.stringify(f??[])!==JSON.stringify(n);if(m){n=f??[],e={},t=n.map(h),Vt(i,t.map(_=>_.line));for(let _ of t)_.relabel()}a.hidden=n.length===0,m&&(s.open=n.filter(_=>!_.instead).length>1||!!he.redundancy),d()}),nt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!he.redundancy&&d()),nt("units",()=>{for(let f of t)f.relabel();d()}),a}function RS(){let n=v("thead"),t=v("tbody"),e=v("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=v("div",{class:"scroll"},v("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${M.table.joints.map(c=>c.type).join("")}${xt.angle}${xt.length}`;l!==r&&(r=l,s=[],Vt(t),Vt(n,v("tr",{},v("th",{text:""}),v("th",{class:"left",text:"posture"}),M.table.joints.map((c,u)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(u+1)}),v("span",{class:"unit",text:` ${xt.symbol(Ke(c))}`}))),v("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=M.table.joints.map(()=>v("td")),u=v("span"),h=v("span",{class:"offscreen"}),d=v("td",{class:"unit"}),f=v("tr",{tabindex:"0","data-testid":`solution-${l+1}`},v("th",{scope:"row",text:String(l+1)}),v("td",{class:"left"},u,h),c,d),m=()=>M.solutions?.rows[l]?.q,_=()=>m()&&fs(m()),p=()=>fs(null),g=()=>{m()&&(fs(null),Pi(qf(m()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",_),f.addEventListener("pointerleave",p),f.addEventListener("focus",_),f.addEventListener("blur",p),f.addEventListener("click",g),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),g())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&gt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),gt(u.beyond,d.inside?"":", outside the limits"),gt(u.residual,d.residual?Xd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${Xd(d.residual[0])} m, ${Xd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,m)=>{let _=M.table.joints[m],p=_.lower!==null&&f<_.lower-1e-9||_.upper!==null&&f>_.upper+1e-9;gt(u.cells[m],xn(f,Ke(_))),u.cells[m].classList.toggle("out",p)}))}),this.mark()},mark(){let l=M.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===M.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-M.q[d])/2))<1e-5)))}}}var G2={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},R0={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},V2=new Set(["REDUNDANT","UNCERTAIN"]),W2=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,C0=120;function P0(){vi(M.frames[M.frames.length-1].slice(),"taken")}var PS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(v("div",{class:"line spread"},v("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:P0}}),Je("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",_=>{i.hidden=_!=="numbers",s.hidden=_!=="matrix"},"target-as")));let e=Fs("Target","target",()=>M.target,(_,p)=>vi(_,"typed",p)),i=v("div",{},e.el),{el:s,show:r}=$2();n.append(i,s,X2());let o=v("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=v("div",{class:"near","data-testid":"ik-nearest"}),l=v("div",{class:"self-motions","data-testid":"self-motions"}),c=RS();n.append(AS(),o,a,l,c.el);let u=ha(C0,()=>{e.show(),r()}),h=ha(C0,()=>{if(t.hidden)return;let _=M.solutions;Y2(o,_),J2(a,_),TS(l,_),c.show(_)}),d=ha(C0,()=>c.mark()),f=_=>()=>ef()?_.soon():_();nt("target",f(u)),nt("notation",e.show),nt(["solutions","units"],f(h)),nt("q",f(d));let m=()=>Dr("target",M.panel==="inverse"?q2(ee(M.target)):[]);nt("target",_=>_!=="drag"&&m()),nt("panel",_=>{Rv(_==="inverse"),(_!=="inverse"||M.hasTarget)&&m(),_==="inverse"&&(M.hasTarget?ht("solutions"):(M.hasTarget=!0,P0()))}),nt("table",_=>{_==="new"&&(M.hasTarget=M.panel==="inverse",M.hasTarget&&P0())})}};function q2(n){let t=.25*li(M.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function $2(){let n=v("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=v("p",{class:"reason",role:"alert"}),e=v("p",{class:"hint"});n.addEventListener("input",()=>{try{vi(ES(n.value),"typed",SS(n.value)),gt(t,""),n.removeAttribute("aria-invalid")}catch(s){gt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(gt(e,`Twelve or sixteen numbers, row by row; the last column in ${xt.length}.`),document.activeElement===n)return;let s=M.target.map((r,o)=>o%4===3&&o<12?r*xt.factor("length"):r);n.value=Hf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return nt("units",i),i(),{el:v("div",{hidden:!0},n,e,t),show:i}}function X2(){let n=v("span",{class:"line"}),t=v("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{he.follow=t.checked}}}),e=Je("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{he.ghosts=i,il()});return nt("task",()=>{t.checked=he.follow,e.mark(he.ghosts)}),nt("plan",()=>Vt(n,M.plan?.solvable?[v("span",{class:"field-name",text:"Task"}),gn("Task",[["",`${M.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],he.task??"",i=>{ht("did",{label:"choose the task"}),he.task=i||null,he.redundancy=null,Ps()},{"data-testid":"task"})]:[])),v("div",{class:"line controls"},v("span",{class:"line"},v("span",{class:"field-name",text:"Handles"}),Je("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Cv)),Je("Axes of the handles",[["local","Tool"],["world","World"]],"local",Pv),v("span",{class:"line"},v("span",{class:"field-name",text:"Snap"}),gn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>Iv(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),v("span",{class:"line"},v("span",{class:"field-name",text:"Ghosts"}),e),v("label",{class:"check"},t,"Arm follows"),n)}function Y2(n,t){if(!t){Vt(n,v("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=G2[t.status]??"note";let s=t.status==="SOLVED"&&e?CS(t.missed):[t.why,t.status==="SINGULAR"?W2(e,i):"",CS(t.missed)].filter(Boolean).join(" "),r=R0[t.status]&&!i?t.why.toLowerCase().includes(R0[t.status].toLowerCase())?"":R0[t.status]:t.status==="SINGULAR"||V2.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Vt(n,v("strong",{text:r})," ",v("span",{text:s}),t.ms===void 0?null:v("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var CS=n=>n?`The pose was rounded by ${j2(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",Z2=(n,t)=>ue(n,t,xt.digits(t)+2),j2=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*xt.factor(e)>=.5*10**-(xt.digits(e)+2)).map(([t,e])=>Z2(t,e)).join(" and ");function J2(n,t){let e=t?.near;if(!e){Vt(n);return}let i=ee(e.T).map(s=>xn(s,"length")).join(", ");Vt(n,v("p",{},v("strong",{text:"Nearest reachable: "}),`${i} ${xt.symbol("length")}, ${ue(e.metres,"length")} away`,e.radians>.001?`, turned by ${ue(e.radians,"angle")}`:""),v("div",{class:"line"},v("button",{type:"button",text:"Go there",on:{click:()=>Pi(e.q)}}),v("button",{type:"button",text:"Make it the target",on:{click:()=>vi(e.T,"chosen")}})))}var I0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function $f(n){return I0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Xf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=$f(r)??{a:0,alpha:0};$f(r)&&(r=fr()),o=ni(I0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=$f(o)??{a:0,alpha:0};$f(o)&&(o=fr()),r=ni(r,I0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var IS=30,K2=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),Q2={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},vl=null;function LS(n,t){vl={label:n,key:"paste",open:!0};try{t(vl)}finally{vl=null,ht("let-go")}}function Yf(n,t,e,{symbolic:i,text:s},r){let o=M.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(M.table.joints[n][t],e)&&M.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${Q2[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||mn({...M.table,joints:o},vl?{...c,...vl}:c),r&&!vl&&ht("let-go")}function bl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=M.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(M.q,0),c=o?t(o,null).map((u,h)=>tL(u&&t(u,0),h,n.length)):null;mn({...M.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var tL=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function DS(n,t,e){let i=M.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function L0({label:n,key:t,open:e}={}){let i=M.table.joints.length;return i>=IS?(Pe(`At most ${IS} joints.`,"wrong"),!1):(bl([...M.table.joints,K2(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function D0(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};bl(e(M.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function Zf(){try{bi(`${M.table.name||"arm"}.toml`,(await He("save",{})).text,"application/toml")}catch(n){Pe(n.message,"wrong")}}function FS(){let n=(t,e,i)=>{let s=v("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>nL(s)}});return[v("button",{type:"button",text:t,title:e,on:{click:()=>s.click()}}),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var eL=/\.(toml|urdf|xml)$/i,NS=2e5;async function nL(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>eL.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){Pe("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>NS){Pe(`${i.name} has ${i.size} bytes; a robot file has at most ${NS.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Yi("open",{name:i.name.slice(-80),text:await i.text()});mn(s,{q:ua(s),what:"new",label:`open ${i.name.slice(-40)}`}),yl(r,s,a=>US(t,a));let o=r?.shapes.filter(a=>a.file&&!US(t,a.file)).length;o&&Pe(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){Pe(s.message,"wrong")}}function US(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var N0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},iL=({catalog:n,...t})=>n?{...t,derived:n}:t,sL=n=>n.type==="R"?"angle":"length",OS={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=v("thead"),s=v("tbody"),r=v("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=v("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=v("p",{class:"verdict","data-testid":"arm-kind"}),l=Je("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],M.table.convention,x=>{x!==M.table.convention&&mn(Xf(M.table,x),{what:"rows",label:`make the table ${x}`})},"convention"),c=v("p",{class:"hint order"}),u=v("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>mn({...iL(M.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=Fs("Base","base",()=>M.table.base,x=>mn({...M.table,base:x},{what:"cell",label:"edit the base",key:"base",open:!0})),d=Fs("Tool","tool",()=>M.table.tool,x=>mn({...M.table,tool:x},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(v("div",{class:"line spread"},v("span",{class:"line"},u),v("span",{class:"line"},v("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>mn(Sx(M.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),...FS(),v("button",{type:"button",text:"Save",title:"As a robot file",on:{click:Zf}}))),v("div",{class:"line spread"},l,Je("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,x=>{t=x,p()},"dh-part")),c,r,v("div",{class:"line"},v("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>L0()}}),v("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,uv(),v("details",{class:"fold","data-testid":"base-tool"},v("summary",{text:"Base and tool"}),h.el,d.el)),s.addEventListener("paste",x=>{let E=Of(x.clipboardData.getData("text")),b=()=>[...s.rows].map(y=>[...y.querySelectorAll("input.number")]);if(!E||!x.target.matches("input.number"))return;x.preventDefault();let A=b().findIndex(y=>y.includes(x.target)),T=b()[A].indexOf(x.target);LS("paste a table",y=>{for(;M.table.joints.length<A+E.length&&L0(y););let S=Bf(b(),A,T,E),D=E.flat().length;Pe(`Pasted ${S} number${S===1?"":"s"}${S<D?`; ${D-S} had no cell`:""}`)})}),n.addEventListener("verdict",x=>{let E=x.detail??rL(n);gt(o,E?`${E.label}: ${E.reason}. The arm stays as it was.`:"")});let f=(x,E,[b,A,T])=>{let y=x.type==="R"&&b==="theta"||x.type==="P"&&b==="d",S=b==="lower"||b==="upper",D=An({label:`Joint ${E+1}, ${A}`,kind:T??sL(x),testid:`dh-${E+1}-${b}`,empty:S?null:void 0,check:L=>S?DS(E,b,L):L!==null&&Math.abs(L)>1e6?"larger than a million":null,input:(L,N)=>Yf(E,b,L,N,!1),commit:(L,N)=>Yf(E,b,L,N,!0)});return S&&(D.placeholder="none"),e.push({f:D,i:E,key:b}),v("td",{class:y?"variable":""},y?v("span",{class:"plus"},v("i",{text:"q"}),v("sub",{text:String(E+1)})," +"):null,D)},m=(x,E)=>v("button",{type:"button",class:`type type-${x.type}`,text:x.type,"data-testid":`dh-${E+1}-type`,"aria-label":`Joint ${E+1} is ${x.type==="R"?"revolute":"prismatic"}; press to change`,title:x.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>bl(M.table.joints.map((b,A)=>A===E?{...b,type:b.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...b.text,lower:void 0,upper:void 0,offset:void 0}}:b),b=>b.map((A,T)=>T===E&&typeof A=="number"?0:A),`make joint ${E+1} ${x.type==="R"?"prismatic":"revolute"}`)}}),_=(x,E)=>v("td",{class:"tools"},v("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${x+1} up`,disabled:x===0,on:{click:()=>D0(x,x-1)}}),v("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${x+1} down`,disabled:x===E-1,on:{click:()=>D0(x,x+1)}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${x+1}`,on:{click:()=>bl(M.table.joints.filter((b,A)=>A!==x),b=>b.filter((A,T)=>T!==x),`remove joint ${x+1}`)}})),p=()=>{e=[];let{joints:x}=M.table,E=M.table.convention==="modified",b=t==="geometry"?N0.geometry.map(([A,T,y])=>v("th",{scope:"col"},v("i",{text:T}),v("sub",{text:E&&(A==="a"||A==="alpha")?"i\u22121":"i"}),v("span",{class:"unit",text:` ${xt.symbol(y)}`}))):["name","lower limit","upper limit","zero","sense"].map(A=>v("th",{scope:"col",text:A}));Vt(i,v("tr",{},v("th",{scope:"col",text:"i"}),v("th",{scope:"col","aria-label":"type"}),b,v("th",{"aria-label":"row tools"}))),Vt(s,x.map((A,T)=>{let y=t==="geometry"?N0.geometry.map(S=>f(A,T,S)):[v("td",{},v("input",{type:"text",class:"name",value:A.name,maxlength:"40","aria-label":`Joint ${T+1}, name`,on:{change:S=>Yf(T,"name",S.target.value||`joint_${T+1}`,{},!0)}})),...N0.joint.map(S=>f(A,T,S)),v("td",{},v("button",{type:"button",class:"type",text:A.sign>0?"+":"\u2212","aria-label":`Joint ${T+1}, sense of the maker: ${A.sign>0?"as the table":"against the table"}`,on:{click:()=>bl(M.table.joints.map((S,D)=>D===T?{...S,sign:-S.sign}:S),S=>S,`turn the sense of joint ${T+1}`)}}))];return v("tr",{"data-testid":`dh-row-${T+1}`},v("th",{scope:"row",text:String(T+1)}),v("td",{},m(A,T)),y,_(T,x.length))})),x.length||s.append(v("tr",{},v("td",{colspan:"7",class:"hint",text:"No joints yet."}))),g()},g=()=>{for(let{f:x,i:E,key:b}of e){let A=M.table.joints[E];x.put(A[b],A.text?.[b]??null)}l.mark(M.table.convention),gt(c,M.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=M.table.name),h.show(),d.show()};nt("table",x=>{gt(o,""),x==="cell"||x==="name"||x==="postures"?g():p()}),nt("units",p),nt("notation",()=>{h.show(),d.show()}),nt("plan",()=>{a.dataset.tone=M.plan?.solvable?"good":"wrong",Vt(a,v("strong",{text:Pu(M.plan)||(M.plan?.refused?"Refused":"Not solved")})," ",v("span",{text:M.plan?.explain??""}))}),p()}};function rL(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var oL=4,aL=n=>{let t=n.toFixed(oL);return Number(t)<0?`(${t})`:t.replace("-","")};function jf(n,t,e){let i=mr(t,e),s=t.joints.map((c,u)=>pr(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,aL(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Jf=null;async function lL(){return Jf??=(await import("./katex-OJEVB6AI.js")).default,Jf}function cL(n,t){let e=v("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function BS(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>cL(n,i)],[i=>"code"in i,i=>v("code",{text:i.code})],[()=>!0,i=>v("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var uL=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function hL(n){let t=M.table.joints.map((e,i)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(i+1)}),v("span",{class:"unit",text:` ${xt.symbol(Ke(e))}`})));return[v("h3",{text:"The formulas at the present pose"}),v("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},v("thead",{},v("tr",{},v("th",{text:"branch"}),t)),v("tbody",{},n.map((e,i)=>v("tr",{},v("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>v("td",{text:xn(s,Ke(M.table.joints[r]))}))))))]}var kS={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=v("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=v("div",{class:"equations","data-testid":"equations"}),c=Je("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,b=>{i=b,_()},"equation-numbers"),u=v("div",{class:"scroll"});n.append(v("div",{class:"line spread"},v("span",{class:"line"},Je("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,b=>{e=b,_()},"which-equations"),c),v("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>Wr(f())}})),a,u,l);let h=b=>b.symbols&&i==="present"?jf(b,M.table,M.q):b.latex,d=b=>b.number===void 0?"":` \\tag{${b.number}}`,f=()=>o.map(b=>b.kind==="equation"?`\\[ ${h(b)}${d(b)} \\]`:uL(b.pieces)).join(`

`);function m(b){r=[],Vt(l,o.map(A=>p(b,A))),g()}async function _(){if(t.hidden||!M.table.joints.length)return;let b=`${e}/${i}/${JSON.stringify(M.table.joints)}${M.table.convention}`;if(s!==b){s=b,gt(a,"Deriving \u2026"),Vt(l);try{let[A,T]=await Promise.all([lL(),He("equations",{which:e,numbers:i==="symbols"?i:"numbers"},y=>gt(a,y.note??""))]);if(s!==b)return;gt(a,T.note??""),o=T.blocks,m(A),c.hidden=e!=="forward",Vt(u),x()}catch(A){if(s!==b)return;s=null,gt(a,A.message)}}}function p(b,A){if(A.kind==="heading"||A.kind==="step")return v("h3",{},BS(b,A.pieces));if(A.kind!=="equation")return v("p",{class:"prose"},BS(b,A.pieces));let T=v("div",{class:"formula"});try{b.render(h(A),T,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{T.replaceChildren(v("code",{text:h(A)}))}if(A.number!==void 0)return v("div",{class:"formula-row numbered"},T,v("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return T;let y=v("output",{class:"value","data-entry":String(A.entry)});return r.push({value:y,entry:A.entry}),v("div",{class:"formula-row"},T,y)}let g=Xs(()=>{if(t.hidden)return;let b=M.frames[M.frames.length-1];for(let{value:A,entry:T}of r)gt(A,`= ${T%4===3?`${ti(b[T]*xt.factor("length"),xt.digits("length"))} ${xt.length}`:ti(b[T],4)}`)}),x=Ys(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:b}=await He("formulas",{T:M.frames.at(-1)});Vt(u,b.length&&e==="inverse"?hL(b):null)}catch{Vt(u)}},250),E=Ys(()=>{!t.hidden&&Jf&&o.length&&e==="forward"&&i==="present"&&m(Jf)},120);nt("q",E),nt("panel",E),nt("q",x),nt("units",x),nt("panel",_),nt("plan",_),nt(["q","units"],g)}};var dL=()=>M.frames.at(-1).slice();function Kf(n,t){let e=M.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{ht("did",{label:c,key:u}),e[a]=l,t(),ht("path",n)},r=["from","to"].map(a=>{let l=Fs(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`${i}take-${a}`,on:{click:()=>{s(a,dL(),`take \u201C${a}\u201D of the path`),l.show()}}});return{el:v("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return nt("path",a=>a!==n&&o()),nt("path-loaded",o),nt("notation",o),{el:v("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var zS=()=>M.frames[M.frames.length-1].slice(),HS={id:"path",title:"Path",wide:!0,build(n,t){let e=M.path,i=Kf("path",()=>h()),s=v("span",{class:"hint"}),r=An({label:"Number of points N",testid:"path-n",check:p=>Number.isInteger(p)&&p>=2&&p<=2e3?null:"a whole number from 2 to 2000",input:p=>{ht("did",{label:"set the points of the path",key:"path-n"}),e.n=p}}),o=An({label:"Seconds for the whole line",testid:"path-seconds",check:p=>p>0&&p<=3600?null:"more than 0, at most 3600",input:p=>{ht("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=p}}),a=v("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let p=ee(e.to);ht("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((g,x)=>{e.to[g]=p[x]}),i.show(),ht("path","path"),h()}}}}),l=v("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>d(M.q)}}),c=v("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=v("div",{class:"branches","data-testid":"branches"});n.append(i.el,v("div",{class:"line"},a,s),v("div",{class:"line"},v("label",{class:"field"},v("span",{class:"field-name",text:"Points N"}),r),v("label",{class:"field"},v("span",{class:"field-name",text:"Seconds"}),o),l,v("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,u);let h=()=>{if(!e.from||!e.to){gt(s,"");return}let p=_x(e.from,e.to);gt(s,`${ue(as(Ni(ee(e.to),ee(e.from))),"length")} long${p>1e-6?`, turning ${ue(p,"angle")}`:", orientation kept"}`),Ho(Array.from({length:33},(g,x)=>ee(jd(e.from,e.to,x/32))))};async function d(p){let g=qr(n);if(g){c.hidden=!1,c.dataset.tone="wrong",gt(c,g);return}gt(l,"Planning \u2026"),l.disabled=!0;try{let x=await He("follow",{T0:e.from,T1:e.to,n:e.n,start:p});M.track=x,f(x,p)}catch(x){c.hidden=!1,c.dataset.tone="wrong",gt(c,x.message)}finally{gt(l,"Plan the line"),l.disabled=!1}}function f(p){if(c.hidden=!1,c.dataset.tone=p.complete?"good":"wrong",gt(c,p.explain),Vt(u,p.branches.length?v("h3",{text:"Branches that start at the first pose"}):null,p.branches.map((b,A)=>v("button",{type:"button",class:`branch ${A===p.chosen?"chosen":""}`,"aria-pressed":String(A===p.chosen),"data-testid":`branch-${A+1}`,disabled:!b.q,title:b.cause||"reaches the end",on:{click:async()=>{await Pi(b.q,.4,`take branch ${A+1}`),d(b.q)}}},v("span",{class:"branch-name",text:`${A+1}  ${b.label}`}),m(b.s),v("span",{class:"branch-end",text:b.complete?"to the end":b.q?`${b.points} of ${e.n}`:"starts outside the limits"})))),Ho(p.path.map(ee)),!p.q.length){Di(null);return}let g=p.path.length,x=p.q.map((b,A)=>A+1),E=p.q.map((b,A)=>g>1?e.seconds*A/(g-1):0);Di(ar({table:M.table,q:p.q,xs:x,xName:"point",xEnd:g,seconds:E,title:`${M.table.name}: straight line, ${p.q.length} of ${g} points`,events:p.events.map(b=>({...b,x:1+b.s*(g-1),short:b.cause}))}))}function m(p){let g=v("span",{class:"bar-fill"});return g.style.setProperty("width",`${100*p}%`),v("span",{class:"bar"},g)}let _=()=>{i.show(),r.put(e.n),o.put(e.seconds),h()};nt("panel",p=>{p==="path"&&(e.from??=zS(),e.to??=zS(),_())}),nt("path-loaded",_),nt("units",h),nt("table",p=>{["postures","name","gripper"].includes(p)||(c.hidden=!0,Vt(u),Ho([]),t.hidden||_())})}};var GS=Math.PI/180,fL=()=>({turn_speed:180*GS,turn_acceleration:600*GS,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});function Zo(n,t,{key:e,open:i}={}){ht("did",{label:t,key:e,open:i}),!M.program.length&&n.length&&(M.start??=M.q),M.program=n,ht("program")}var U0=(n,t,e,i)=>Zo(M.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function VS(n,t){ht("did",{label:t,key:"limits"}),M.limits={...Qf(),...n},ht("program","limits")}var Qf=()=>({...fL(),...M.limits});function WS(n,t="set the start of the program"){ht("did",{label:t}),M.start=n,ht("program")}var tp=()=>M.start?.length===M.table.joints.length?M.start:M.q;function Ml(){let n=Qf(),t=M.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:tp(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:M.program.map(({name:i,...s})=>s)}}var pL=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),xo=()=>M.routing??pL();function Sl(n,t,e=t){ht("did",{label:t,key:e}),M.routing={...xo(),...n},ht("routing")}var F0=()=>{let n=xo();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function ep(){let n=xo(),t=M.path,e=M.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:F0(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:M.world,clearance:e?n.clearance:0}}function O0(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var wl=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function qS(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(wl(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>O0(n,l)(o,r))}var jo=Math.PI/180,$S=3.4,mL=2.1,XS=.5,gL=.9;function YS({drag:n,drop:t,scrub:e}){let i=v("canvas",{"aria-hidden":"true"}),s=v("div",{class:"route-now",hidden:!0}),r=v("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(P=>v("div",{class:`route-end ${P}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":P==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${P}`,hidden:!0})),a=v("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],m=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function _(){let P=m(),U=a.clientWidth,Z=a.clientHeight,q={l:$S*P,t:XS*P,w:U-($S+gL)*P,h:Z-(XS+mL)*P},j=-Math.PI,et=Math.PI;if(l.map&&!wl(l.map))j=l.map.turn[0],et=l.map.turn.at(-1);else if(l.turn.length){let dt=90*jo;j=Math.min(j,dt*Math.floor(Math.min(...l.turn)/dt)),et=Math.max(et,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...q,lo:j,hi:et,W:U,H:Z}}let p=P=>u.l+P*u.w,g=P=>u.t+(1-(P-u.lo)/(u.hi-u.lo))*u.h,x=P=>u.lo+(1-(P-u.t)/u.h)*(u.hi-u.lo),E=P=>Bt.curves[Math.max(l.branches.indexOf(P),0)%Bt.curves.length];function b(){f=(l.map?.branches??[]).map((P,U)=>{let Z=O0(l.map,U),q=l.map.s.length,j=l.map.turn.length,et=v("canvas",{width:q,height:j}),dt=et.getContext("2d"),ft=dt.createImageData(q,j),st=parseInt(E(P).slice(1),16);for(let vt=0;vt<q;vt++)for(let _t=0;_t<j;_t++){if(!Z(vt,_t))continue;let Tt=4*((j-1-_t)*q+vt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:P,c:et}})}function A(){if(!l||!a.clientWidth)return;_();let P=Math.min(devicePixelRatio,2),U=i.getContext("2d");i.width=u.W*P,i.height=u.H*P,U.scale(P,P);let Z=.76*m();U.font=`${Z}px "Inter Variable", system-ui, sans-serif`,U.fillStyle=Bt.ground,U.fillRect(u.l,u.t,u.w,u.h),U.save(),U.beginPath(),U.rect(u.l,u.t,u.w,u.h),U.clip(),T(U),y(U),S(U),U.restore(),D(U,Z),N()}function T(P){let U=l.map;if(!U)return;let Z=U.turn[1]-U.turn[0],q=wl(U),j=U.turn[0]-Z/2,et=U.turn.at(-1)+Z/2,dt=q?Math.floor((u.lo-j)/(2*Math.PI)):0,ft=q?Math.ceil((u.hi-et)/(2*Math.PI)):0;for(let{name:st,c:vt}of f)if(!(c&&c!==st)){P.globalAlpha=(c?.4:.3)*(Bt.dark?.8:1);for(let _t=dt;_t<=ft;_t++){let Tt=g(et+2*Math.PI*_t),At=g(j+2*Math.PI*_t);P.drawImage(vt,u.l,Tt,u.w,At-Tt)}}P.globalAlpha=1}function y(P){if(!l.blocked)return;let[U,Z]=l.blocked.s,q=p(U),j=Math.max(p(Z)-q,3);P.fillStyle=Bt.wrong,P.globalAlpha=.75,P.fillRect(Math.min(q,u.l+u.w-j),u.t,j,u.h),P.globalAlpha=1}function S(P){if(!l.q.length)return;let U=[[0]];l.labels.forEach((Z,q)=>{q&&Z!==l.labels[q-1]&&U.push([q-1]),U.at(-1).push(q)});for(let[Z,q]of[[.38,!0],[.18,!1]])for(let j of U){P.beginPath();for(let et of j)P.lineTo(p(l.s[et]),g(l.turn[et]));P.lineWidth=Z*m(),P.lineJoin=P.lineCap="round",P.strokeStyle=q?Bt.panel:Bt.curves[l.labels[j.at(-1)]%Bt.curves.length],P.stroke()}}function D(P,U){P.strokeStyle=Bt.line,P.strokeRect(u.l,u.t,u.w,u.h),P.fillStyle=Bt.muted,P.textBaseline="middle",P.textAlign="right";let Z=(u.hi-u.lo)/jo,q=[5,10,15,30,45,90,180].find(et=>Z/et<=6)??180;for(let et=Math.ceil(u.lo/jo/q-1e-9)*q;et<=u.hi/jo+1e-6;et+=q){let dt=g(et*jo);P.fillText(xn(et*jo,"angle",xt.angle==="deg"?0:2),u.l-.45*U,dt),P.globalAlpha=.5,P.beginPath(),P.moveTo(u.l,dt),P.lineTo(u.l+u.w,dt),P.lineWidth=1,P.stroke(),P.globalAlpha=1}P.textBaseline="top",P.textAlign="center";let j=u.t+u.h+.45*U;for(let et of[0,.25,.5,.75,1])P.fillText(String(et),p(et),j);P.fillText("path, from 0 to 1",p(.5),j+1.15*U),P.save(),P.translate(.5*U,u.t+u.h/2),P.rotate(-Math.PI/2),P.textBaseline="middle",P.fillText(`turn of the tool, ${xt.symbol("angle")}`,0,0),P.restore()}let L=P=>h?.which===P?h.turn:P==="start"?l.turn[0]:l.turn.at(-1);function N(){o.forEach((P,U)=>{let Z=U?"end":"start",q=!!(l?.turn.length&&l.map);if(P.hidden=!q,!q)return;let j=L(Z);P.style.setProperty("left",`${p(U)}px`),P.style.setProperty("top",`${g(j)}px`),P.classList.toggle("pinned",d[Z]),P.setAttribute("aria-valuemin",xn(u.lo,"angle",0).replace("\u2212","-")),P.setAttribute("aria-valuemax",xn(u.hi,"angle",0).replace("\u2212","-")),P.setAttribute("aria-valuenow",xn(j,"angle").replace("\u2212","-")),P.setAttribute("aria-valuetext",`${ue(j,"angle")}${d[Z]?", held":""}`)})}let z=P=>Math.min(Math.max(P,u.lo),u.hi);function G(P,U){h={which:P,turn:z(U)},N();let Z=qS(l.map,P==="start"?0:1,h.turn);r.hidden=!1,gt(r,`${ue(h.turn,"angle",1)}: ${Z.length?Z.join("; "):"closed on every branch"}`),r.dataset.tone=Z.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",P==="end"),n(P,h.turn)}function B(){if(!h)return;let{which:P,turn:U}=h;r.hidden=!0,t(P,U)}o.forEach((P,U)=>{let Z=U?"end":"start";P.addEventListener("pointerdown",q=>{q.preventDefault(),P.focus(),P.setPointerCapture(q.pointerId);let j=L(Z)-x(q.clientY-a.getBoundingClientRect().top),et=ft=>G(Z,x(ft.clientY-a.getBoundingClientRect().top)+j);P.addEventListener("pointermove",et);let dt=()=>{P.removeEventListener("pointermove",et),B()};P.addEventListener("pointerup",dt,{once:!0}),P.addEventListener("pointercancel",dt,{once:!0})}),P.addEventListener("keydown",q=>{let j={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[q.key];if(j)G(Z,L(Z)+j*jo*(q.shiftKey?.1:1));else if(q.key==="Enter")B();else if(q.key==="Escape"&&h)X(),n(Z,null);else return;q.preventDefault(),q.stopPropagation()}),P.addEventListener("blur",()=>h?.which===Z&&B())}),i.addEventListener("pointerdown",P=>{if(!l?.q.length)return;let U=q=>e(Math.min(Math.max((q.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(P.pointerId),U(P),i.addEventListener("pointermove",U);let Z=()=>i.removeEventListener("pointermove",U);i.addEventListener("pointerup",Z,{once:!0}),i.addEventListener("pointercancel",Z,{once:!0})});function X(){h=null,r.hidden=!0,l&&N()}return new ResizeObserver(Xs(A)).observe(a),{el:a,paint(){l&&b(),A()},cancel:X,show(P,U=null,Z={start:!1,end:!1}){l=P,d=Z,h=null,r.hidden=!0,a.hidden=!P,P&&(c=U,b(),A())},only(P){c=P,A()},at(P){s.hidden=P===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${p(P)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(P,U=null){let Z=a.getBoundingClientRect();return[Z.x+p(P==="end"?1:0),Z.y+g(U??L(P))]}}}var ZS=Math.PI/180;function jS(){let n=(m,_,p)=>Sl({...m,start:null,end:null},_,p),t=(m,_,p)=>{let g=v("span",{class:"field-name"}),x=v("label",{class:"field"},g,p);return x.label=()=>{g.textContent=_==="plain"?m:`${m}, ${xt.symbol(_)}`},x},e=(m,_,p,g,x)=>{let E=An({label:m,kind:_,testid:p,check:g,input:x});return{f:E,el:t(m,_,E)}},i=Je("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",m=>{n({turn:m==="free"?null:[-45*ZS,45*ZS]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(m=>e(m?"to":"from","angle",`route-turn-${m}`,_=>Math.abs(_)<=4*Math.PI?null:"at most two turns",_=>{let p=xo().turn?.slice()??[0,0];p[m]=_,n({turn:p},"bound the turn of the route",`route-turn-${m}`)})),r=Je("About which axis of the tool",["x","y","z"].map(m=>[m,m]),"z",m=>n({axis:m},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",m=>m>=0&&m<Math.PI/2?null:"from 0 to less than 90 degrees",m=>n({cone:m},"set the cone of the route","route-cone")),a=gn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",m=>n({cost:m},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",m=>m>=0&&m<1?null:"from 0 to less than 1",m=>n({singularity:m},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",m=>m>=0?null:"0 or more",m=>n({clearance:m},"keep the route from obstacles","route-clearance")),u=v("details",{class:"fold"},v("summary",{text:"More that is free, and what must be kept"}),v("div",{class:"line"},o.el),v("div",{class:"line"},v("label",{class:"field"},v("span",{class:"field-name",text:"Cheapest"}),a)),v("div",{class:"line"},l.el),v("div",{class:"line"},c.el)),h=v("div",{},v("div",{class:"line"},v("span",{class:"field-name",text:"Turn"}),i,...s.map(m=>m.el),v("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let m=xo();i.mark(m.turn?"within":"free"),s.forEach((_,p)=>{_.el.hidden=!m.turn,_.f.put(m.turn?.[p]??0)}),r.mark(m.axis),o.f.put(m.cone),a.value=m.cost,l.f.put(m.singularity),c.f.put(m.clearance),c.el.hidden=!M.world.some(_=>_.role!=="object"&&_.kind!=="frame"),d.forEach(_=>_.el.label())}return nt(["units","world"],f),nt("routing",m=>["undo","loaded"].includes(m)&&f()),f(),{el:h,show:f}}var JS=n=>({id:"route",title:"Route",wide:!0,build(t){let e=M.path,i=null,s=null,r=null,o=Kf("route",()=>x()),a=jS(),l=(P,U,Z,q={})=>v("button",{type:"button",text:P,"data-testid":U,on:{click:Z},...q}),c=l("Find the route","find-route",()=>b(),{class:"primary"}),u=l("Let both ends free","free-ends",()=>{Sl({start:null,end:null},"let the ends of the route free"),b()}),h=l("Send to the program","route-to-program",G,{hidden:!0}),d=l("","route-others",z,{hidden:!0}),f=v("p",{class:"verdict",role:"status","data-testid":"route-verdict",hidden:!0}),m=v("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),_=v("div",{class:"branches","data-testid":"route-list"}),p=YS({drag:(P,U)=>U===null?fs(null):L(P,U),drop:(P,U)=>N(P,U),scrub:P=>r&&M.motion===r&&Or(y(P))}),g=v("details",{class:"fold",open:!0},v("summary",{text:"The line"}),o.el);p.el.hidden=!0,u.hidden=!0,t.append(v("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),g,a.el,v("div",{class:"line"},c,u,h),p.el,m,f,v("div",{class:"line"},d),_);let x=()=>{e.from&&e.to&&!i&&Ho(Array.from({length:33},(P,U)=>ee(jd(e.from,e.to,U/32))))},E=P=>{f.hidden=!1,f.dataset.tone="wrong",gt(f,P)};async function b(){let P=qr(t);if(P){E(P);return}gt(c,"Looking \u2026"),c.disabled=!0;try{let U=await He("route",ep());U.stopped||A(U)}catch(U){p.cancel(),E(U.message)}finally{gt(c,"Find the route"),c.disabled=!1}}function A(P){let U=xo();if(i=M.route={...P,turn:T(P,U),asked:[e.from,e.to]},s=P.found?P.branches[P.labels[0]]:null,P.found&&(g.open=!1),f.hidden=!1,f.dataset.tone=P.found?"good":P.verdict==="IMPOSSIBLE"?"wrong":"note",gt(f,P.text),p.show(i,s,{start:!!U.start,end:!!U.end}),fs(null),u.hidden=!(U.start||U.end),h.hidden=!P.found,d.hidden=!1,gt(d,P.found?"Routes that begin with other postures":"What would let it through?"),Vt(_),S(),Ho(P.points),!P.found){r=null,Di(null);return}let Z=P.q.length;r=ar({table:M.table,q:P.q,xs:P.q.map((q,j)=>j+1),xName:"point",xEnd:Z,seconds:P.s.map(q=>e.seconds*q),title:`${M.table.name}: route, ${Z} points`}),Di(r)}function T(P,U){if(!P.found||!P.map||!wl(P.map))return P.turn;let Z=U.start?U.start.turn-P.turn[0]:U.end?U.end.turn-P.turn.at(-1):0;return P.turn.map(q=>q+2*Math.PI*Math.round(Z/(2*Math.PI)))}let y=P=>i.s.reduce((U,Z,q)=>Math.abs(Z-P)<Math.abs(i.s[U]-P)?q:U,0);function S(){Vt(m,i.branches.map((P,U)=>{let Z=v("span",{class:"swatch"});return Z.style.setProperty("background",Bt.curves[U%Bt.curves.length]),v("button",{type:"button",class:"chip","aria-pressed":String(s===P),title:s===P?"Show all branches":"Show this branch alone","data-testid":`route-branch-${U+1}`,on:{click:()=>{s=s===P?null:P,p.only(s),S()}}},Z,P)}))}let D=(P,U)=>{let Z=P==="start",q=Z?0:i.q.length-1;return{T:Z?e.from:e.to,turn:U,free:F0(),near:i.q[q],branch:i.branches[i.labels[q]]}},L=qs(async(P,U)=>{let Z=await He("route_posture",D(P,U)).catch(()=>null);fs(Z?.q??null)});async function N(P,U){try{let Z=await He("route_posture",D(P,U));if(!Z.q)throw new Error(`The route cannot ${P} there. ${Z.why}`);Sl({[P]:{turn:U,q:Z.q,branch:Z.label}},`turn the ${P} of the route to ${ue(U,"angle",1)}`),await b()}catch(Z){fs(null),p.cancel(),Pe(Z.message,"wrong")}}async function z(){d.disabled=!0,gt(d,"Looking \u2026");try{let P=await He("route_others",ep());if(P.stopped)return;let U=Z=>`cost ${Number(Z.toPrecision(3))}`;Vt(_,P.relaxations.map(Z=>v("p",{class:"verdict","data-tone":"note",text:Z})),P.alternatives.map((Z,q)=>v("button",{type:"button",class:"branch","data-testid":`route-other-${q+1}`,on:{click:async()=>{Sl({start:{turn:Z.turn,q:Z.q,branch:Z.branch},end:null},`begin the route ${Z.branch}`),await b()}}},v("span",{class:"branch-name",text:Z.branch}),v("span",{class:"hint",text:`begins turned ${ue(Z.turn,"angle",1)}`}),v("span",{class:"branch-end",text:U(Z.cost)}))),P.relaxations.length+P.alternatives.length?null:v("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),d.hidden=!0}catch(P){E(P.message)}finally{d.disabled=!1,i&&gt(d,i.found?"Routes that begin with other postures":"What would let it through?")}}async function G(){h.disabled=!0;try{let P=await He("route_program",ep());if(P.stopped)return;let U=!M.program.length,Z=U?P.steps.slice(1):P.steps;U&&(M.start=P.steps[0].q),Zo([...M.program,...Z],"send the route to the program");let q=`${ue(P.metres,"length",3)} and ${ue(P.radians,"angle",3)}`;Pe(`Sent as a spline through ${P.poses} poses; it strays by at most ${q}.`),n()?.("program")}catch(P){E(P.message)}finally{h.disabled=!1}}let B=()=>{M.routing&&(M.routing={...M.routing,start:null,end:null})};function X(){i=M.route=null,f.hidden=!0,p.show(null),h.hidden=d.hidden=u.hidden=!0,Vt(m),Vt(_),fs(null)}nt("panel",P=>{if(P!=="route")return;let U=()=>M.frames.at(-1).slice();e.from??=U(),e.to??=U(),o.show(),x(),i&&p.paint()}),nt("played",()=>{!r||M.motion!==r?p.at(null):p.at(i.s[YM()]??null)}),nt("motion",()=>M.motion!==r&&p.at(null)),nt("theme",()=>{p.paint(),i&&S()}),nt("units",()=>p.paint()),nt("routing",P=>{P==="undo"&&i&&b()}),nt(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(B(),X())}),nt("table",P=>{["postures","name","gripper"].includes(P)||(P!=="undo"&&B(),X())}),p.el.addEventListener("where",P=>Object.assign(P.detail,{at:p.place(P.detail.which,P.detail.turn)}))}});var xL=()=>M.frames.at(-1).slice();function KS(n){let t=r=>`edit step ${r+1}`,e=(r,o,a)=>U0(r,o,t(r),{key:`step-${r}-${a}`});function i(r,o,a,l){let c=An({label:`Step ${r+1}, ${a}`,testid:`step-${r+1}-${o}`,...l,input:u=>{n(()=>e(r,{[o]:u},o))}});return c.put(M.program[r][o]??null),v("label",{class:"field"},v("span",{class:"field-name",text:l.unit?`${a}, ${l.unit}`:a}),c)}function s(r,o){if(r.kind==="wait")return v("div",{class:"line step-editor"},i(o,"seconds","seconds",{check:l=>l>=0?null:"0 or more"}));if(r.kind==="gripper")return v("div",{class:"line step-editor"},i(o,"value","value",{check:l=>l>=0&&l<=1?null:"from 0, open, to 1, closed"}));if(r.kind==="output")return v("div",{class:"line step-editor"},i(o,"port","port",{check:l=>Number.isInteger(l)&&l>=0?null:"a whole number from 0"}),v("label",{class:"check"},v("input",{type:"checkbox",checked:r.value,on:{change:l=>e(o,{value:l.target.checked},"value")}}),"on"));let a=(l,c)=>Fs(c,`step-${o+1}-${l}`,()=>M.program[o]?.[l],h=>{n(()=>e(o,l==="T"?{T:h,q:null}:{[l]:h},l))}).el;return v("div",{class:"step-editor"},v("div",{class:"line"},gn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"]],r.kind,l=>e(o,{kind:l,q:l==="joint"?r.q??null:null,speed:null,...l==="circle"&&!r.via?{via:r.T}:{}},"kind"),{"data-testid":`step-${o+1}-kind`}),i(o,"blend","blend",{kind:"length",unit:xt.length,check:l=>l>=0?null:"0 or more"}),r.kind==="joint"?i(o,"speed","part of the speed",{empty:null,check:l=>l===null||l>0&&l<=1?null:"above 0 to 1"}):i(o,"speed","speed",{kind:"length",unit:`${xt.length}/s`,empty:null,check:l=>l===null||l>0?null:"more than 0"})),r.kind==="circle"?a("via","Over"):null,a("T",r.q?"To (a taught posture; typing makes it a pose)":"To"),v("div",{class:"line"},v("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${o+1}-teach`,on:{click:()=>U0(o,{T:xL(),q:r.kind==="joint"?M.q.slice():null},`teach step ${o+1}`)}}),r.q?v("button",{type:"button",class:"quiet",text:"Go there",on:{click:()=>Pi(r.q.slice(),.8,`go to step ${o+1}`)}}):null))}return s}function QS(){let n=v("div",{class:"line limits-of"}),t=()=>{let e=new Set(M.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=An({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>VS({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(Qf()[r]),c===null&&(u.placeholder="none"),v("label",{class:"field"},v("span",{class:"field-name",text:`${o}, ${xt.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Vt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return nt(["table","units"],t),nt("program",e=>e==="undo"&&t()),t(),n}var tw=200,_L=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],B0={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output"},np=()=>M.frames.at(-1).slice(),ew={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=v("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=v("p",{class:"verdict",role:"status","data-testid":"program-verdict",hidden:!0}),o=v("details",{class:"fold",hidden:!0},v("summary",{text:"What binds, and when"}),v("p",{class:"hint prose"})),a=(y,S,D,L)=>v("button",{type:"button",text:S,title:D,"data-testid":`step-add-${y}`,on:{click:()=>f(L())}}),l=v("button",{type:"button",class:"primary",text:"Run the program","data-testid":"run-program",on:{click:A}}),c=v("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(v("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:M.q.slice(),T:np(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:np(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:np(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0}))),v("div",{class:"line spread"},c,v("span",{class:"line"},v("button",{type:"button",class:"quiet",text:"Start here","data-testid":"start-here",title:"The program begins in the present posture",on:{click:()=>WS(M.q.slice())}}),v("button",{type:"button",class:"quiet",text:"Go to the start",on:{click:()=>Pi(tp().slice(),.8,"go to the start")}}))),s,QS(),v("div",{class:"line"},l,v("span",{class:"line"},gn("Language of the file",_L,u,y=>{u=y},{"data-testid":"dialect"}),v("button",{type:"button",text:"Save the program","data-testid":"save-program",on:{click:T}}))),r,o);let h=()=>M.program.findLast(y=>y.T)?.T??np(),d=()=>M.program.findLast(y=>y.kind==="gripper")?.value??0;function f(y){if(M.program.length>=tw){Pe(`At most ${tw} steps.`,"wrong");return}let S=t>=0?t+1:M.program.length;t=S,Zo([...M.program.slice(0,S),y,...M.program.slice(S)],`add a step: ${B0[y.kind].toLowerCase()}`)}function m(y,S){if(S<0||S>=M.program.length||y===S)return;let D=M.program.slice(),[L]=D.splice(y,1);D.splice(S,0,L),t=S,Zo(D,`move step ${y+1} to ${S+1}`),s.children[S]?.querySelector(".step-name")?.focus()}function _(y){t=-1,Zo(M.program.filter((S,D)=>D!==y),`remove step ${y+1}`)}function p(y){return y.kind==="wait"?`${y.seconds} s`:y.kind==="gripper"?y.value===0?"open":y.value===1?"closed":`${y.value}`:y.kind==="output"?`${y.port} ${y.value?"on":"off"}`:y.kind==="joint"&&y.q?y.q.map((S,D)=>xn(S,Ke(M.table.joints[D]??{type:"R"}),1)).join(", "):`${ee(y.T).map(S=>xn(S,"length",1)).join(", ")} ${xt.length}`}function g(y,S){let D=S===t,L=v("button",{type:"button",class:"step-name quiet","aria-expanded":String(D),"data-testid":`step-${S+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=D?-1:S,b()},keydown:z=>{let G={ArrowUp:-1,ArrowDown:1}[z.key];G&&z.altKey?(z.preventDefault(),m(S,S+G)):G?(z.preventDefault(),s.children[S+G]?.querySelector(".step-name")?.focus()):z.key==="Delete"&&_(S)}}},v("b",{text:B0[y.kind]}),` ${p(y)}`,y.blend?v("span",{class:"hint",text:`, blend ${ue(y.blend,"length",0)}`}):null),N=v("li",{class:`step${e?.step===S?" failed":""}${D?" open":""}`,draggable:"true","data-testid":`step-row-${S+1}`},v("div",{class:"step-line"},v("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),v("span",{class:"hint",text:String(S+1)}),L,v("button",{type:"button",class:"icon",text:"\u2191",disabled:S===0,"aria-label":`Move step ${S+1} up`,on:{click:()=>m(S,S-1)}}),v("button",{type:"button",class:"icon",text:"\u2193",disabled:S===M.program.length-1,"aria-label":`Move step ${S+1} down`,on:{click:()=>m(S,S+1)}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove step ${S+1}`,on:{click:()=>_(S)}})),e?.step===S?v("p",{class:"reason",text:e.text}):null,D?E(y,S):null);return N.addEventListener("dragstart",z=>{i=S,z.dataTransfer.effectAllowed="move",z.dataTransfer.setData("text/plain",String(S))}),N.addEventListener("dragover",z=>{i<0||(z.preventDefault(),N.classList.add("target"))}),N.addEventListener("dragleave",()=>N.classList.remove("target")),N.addEventListener("drop",z=>{z.preventDefault();let G=i;i=-1,G>=0&&m(G,S)}),N}let x=!1,E=KS(y=>{x=!0,y(),x=!1});function b(){if(x){M.program.forEach((S,D)=>{let L=s.children[D]?.querySelector(".step-name");L&&Vt(L,v("b",{text:B0[S.kind]}),document.createTextNode(` ${p(S)}`))});return}t>=M.program.length&&(t=-1),Vt(s,M.program.map(g)),M.program.length||s.append(v("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.disabled=!M.program.length;let y=tp();gt(c,M.program.length?`Starts at ${y.map((S,D)=>xn(S,Ke(M.table.joints[D]),1)).join(", ")}`:"")}async function A(){r.hidden=!1;let y=qr(n);if(y){r.dataset.tone="wrong",gt(r,y);return}l.disabled=!0,gt(l,"Planning \u2026");try{let S=await He("program",{...Ml(),world:M.world});e=S.failed,e&&(t=e.step),r.dataset.tone=e||S.clear?.verdict==="HIT"?"wrong":S.clear?.verdict==="UNCERTAIN"?"note":"good",gt(r,e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[S.explain,S.clear?.text].filter(Boolean).join(`
`)),o.hidden=!S.tight.length,gt(o.lastChild,S.tight.map(L=>L.text).join(`
`)),b();let D=S.events.map(([L,N,z])=>({x:L,s:0,text:`${N} ${z} at ${L.toFixed(2)} s`,short:N==="gripper"?z>.5?"close":"open":N,stop:!1}));Di(Object.assign(ar({table:M.table,q:S.q,xs:S.t,xName:"time",seconds:S.t,dq:S.dq,events:D,title:`${M.table.name}: program, ${S.duration.toFixed(2)} s`}),{ddq:S.ddq,happens:S.events,tight:S.tight,limits:Ml().limits}))}catch(S){r.dataset.tone="wrong",gt(r,S.message)}finally{l.disabled=!M.program.length,gt(l,"Run the program")}}async function T(){try{let y="program",{text:S,name:D}=await He("program_file",{...Ml(),dialect:u,name:y});bi(D,S)}catch(y){r.hidden=!1,r.dataset.tone="wrong",gt(r,y.message)}}nt(["program","units","table"],y=>{y!=="limits"&&(e=null,b())}),b()}};var Jo=new En,ip=new Ka,yL=new ge,vL=n=>new ri({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function k0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new Oe(e,3)),n}var nw=n=>n.rotateX(Math.PI/2),z0={box:n=>[k0(new Oi(...n.size)),n.T],cylinder:n=>[k0(nw(new Ai(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new H(...n.a),e=new H(...n.b).sub(t),i=e.length(),s=new ge().makeRotationFromQuaternion(new un().setFromUnitVectors(new H(0,0,1),i?e.clone().normalize():new H(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[k0(nw(new Io(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function H0(n,t,e=.86){if(!z0[n.kind])return null;let[i,s]=z0[n.kind](n),r=vL(t);r.opacity=e,r.depthWrite=e>.5;let o=new Ye(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var bL=()=>[...M.world,...M.things??[]];function ML(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=ee(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Ws(n.T,s)[o])))}function sw(){hn.add(Jo,ip.group),nt(["world","table"],iw),nt("theme",()=>{ip.paint(),iw()})}var du=new Map;function G0(n,t){if(t)du.set(n,t);else if(!du.delete(n))return;let e=Jo.children.find(s=>s.userData.name===n),i=M.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),_e()}var rw=n=>du.get(n)??null;function ow(){for(let n of[...du.keys()])G0(n,null)}function iw(){for(let t of Jo.children)t.geometry.dispose();Jo.clear();let n=bL();for(let t of n)if(t.kind==="curve"){let e=new be().setFromPoints(t.points.map(i=>new H(...i)));Jo.add(new Qs(e,new Ki({color:Bt.trace,fog:!1})))}else if(z0[t.kind]){let{mesh:e,T:i}=H0(t,t.role==="object"?Bt.accent:Bt.ghost);e.matrix.copy(yL.set(...du.get(t.name)??i)),e.userData.name=t.name,Jo.add(e)}ip.show(n.filter(t=>t.kind==="frame"),.11*li(M.table)),Dr("world",n.flatMap(ML)),_e()}var aw=()=>Jo.children.length+(ip.last?.[0].length??0);var Tl=new Qs(new be,new Ki({depthTest:!1,fog:!1})),Al=new Er(new be,new tr({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));Tl.renderOrder=Al.renderOrder=6;Tl.frustumCulled=Al.frustumCulled=!1;Tl.visible=Al.visible=!1;var El=new En,fu=null,lw="",wL=()=>M.watch||M.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),EL=qs(async()=>{try{let n=await He("clearance",{q:M.q,world:M.world});M.clearance=n}catch(n){M.clearance={refused:n.message}}V0(),ht("clearance")});function cw(){wL()&&M.table.joints.length?EL():M.clearance&&(M.clearance=null,V0(),ht("clearance"))}function V0(){let n=M.clearance,t=!!n?.points?.length;if(Tl.visible=Al.visible=t,t){let e=n.points.map(i=>new H(...i));for(let i of[Tl,Al])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Bt.trace:Bt.wrong)}_e()}async function W0(n){if(fu=null,n){let{bodies:t,explain:e}=await He("bodies",{});fu=t,lw=e}for(let t of El.children)t.geometry.dispose();El.clear();for(let t of fu??[]){let e=H0(t,Bt.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},El.add(e.mesh))}return hw(),lw}var uw=()=>El.children.length,TL=new ge;function hw(){for(let n of El.children){let{on:t,T:e}=n.userData;M.frames[t]&&n.matrix.copy(TL.set(...ni(M.frames[t],e)))}_e()}function dw(){hn.add(Tl,Al,El),nt(["q","world","watch"],cw),nt("plan",cw),nt("q",()=>fu&&hw()),nt("table",()=>fu&&W0(!1).then(()=>ht("bodies-gone"))),nt("theme",V0)}var RL=60,CL={box:"Box",cylinder:"Cylinder",frame:"Frame"},PL={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function q0(n,t,e={}){ht("did",{label:t,...e}),M.world=n,ht("world")}var sp=(n,t,e)=>q0(M.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function IL(n,t){if(M.world.length>=RL)return;let e=ee(M.frames.at(-1)),i=.06*li(M.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*M.world.length;let o=t==="object"?"object":n,a=1;for(;M.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};q0([...M.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var fw={id:"world",title:"World",wide:!0,build(n){let t=v("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=v("p",{class:"hint prose"}),i=v("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{M.watch=i.checked,ht("watch")}}}),s=v("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await W0(s.checked);gt(e,s.checked?h:"")}catch(h){gt(e,h.message)}}}}),r=v("div",{class:"things","data-testid":"world"}),o=(h,d,f,m)=>v("button",{type:"button",text:h,title:m,"data-testid":`add-${f}-${d}`,on:{click:()=>IL(d,f)}});n.append(v("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),v("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),v("div",{class:"line"},v("label",{class:"check"},i,"Distance, always"),v("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),nt(["clearance","units"],()=>{let h=M.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];gt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${ue(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${ue(-h.metres,"length")}.`))}),nt("bodies-gone",()=>{s.checked=!1,gt(e,"")});let l=!1,c=()=>{l||(Vt(r,M.world.map(u)),M.world.length||r.append(v("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=g=>(...x)=>{l=!0,g(...x),l=!1},m=v("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>m.value&&sp(d,{name:m.value},`name ${m.value}`)}}),_=PL[h.kind].map((g,x)=>{let E=An({label:`${h.name}, ${g}`,kind:"length",testid:`world-${d+1}-size-${x}`,check:b=>b>0?null:"more than 0",input:f(b=>{let A=M.world[d],T=h.kind==="box"?{size:A.size.map((y,S)=>S===x?b:y)}:{[x?"h":"r"]:b};sp(d,T,`size of ${h.name}`)})});return E.put(h.kind==="box"?h.size[x]:x?h.h:h.r),v("label",{class:"field"},v("span",{class:"field-name",text:`${g}, ${xt.length}`}),E)}),p=Fs("Place of its middle",`world-${d+1}`,()=>M.world[d]?.T,f(g=>sp(d,{T:g},`move ${h.name}`)));return v("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},v("div",{class:"line spread"},v("span",{class:"line"},m,v("span",{class:"hint",text:CL[h.kind]}),h.kind==="frame"?null:gn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,g=>sp(d,{role:g},`make ${h.name} an ${g}`))),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>q0(M.world.filter((g,x)=>x!==d),`remove ${h.name}`)}})),_.length?v("div",{class:"line"},_):null,p.el)}nt(["world","units"],h=>h!=="python"&&c()),c()}};var LL=40,pw={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return M.sequence.postures},set postures(u){M.sequence.postures=u},get rate(){return M.sequence.rate}},e=v("thead"),i=v("tbody"),s=v("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=v("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:c}}),o=v("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let u=t.postures[1];if(u){ht("did",{label:"use the same times for all legs"});for(let h of t.postures.slice(2))h.seconds=u.seconds,h.hold=u.hold;l()}}}});n.append(v("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),v("div",{class:"scroll"},v("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),v("div",{class:"line"},v("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(M.q.slice())}}),v("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(M.table.postures??{}).forEach(([u,h])=>a(h.slice(),u))}}),o),v("div",{class:"line"},r),s);function a(u,h){t.postures.length>=LL||(ht("did",{label:"add a posture to the sequence"}),t.postures.push({name:h??`P${t.postures.length}`,q:u,seconds:5,hold:0}),l(),ht("sequence"))}function l(){let u=M.table.joints;t.postures=t.postures.filter(h=>h.q.length===u.length),r.disabled=t.postures.length<2,Vt(e,v("tr",{},v("th",{text:""}),u.map((h,d)=>v("th",{},v("i",{text:"q"}),v("sub",{text:String(d+1)}),v("span",{class:"unit",text:` ${xt.symbol(Ke(h))}`}))),v("th",{text:"leg, s"}),v("th",{text:"rest, s"}),v("th",{"aria-label":"row tools"}))),Vt(i,t.postures.map((h,d)=>{let f=u.map((_,p)=>{let g=An({label:`${h.name}, q${p+1}`,kind:Ke(_),testid:`seq-${d}-q${p+1}`,input:x=>{ht("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${p}`}),h.q[p]=x,ht("sequence")}});return g.put(h.q[p],String(Number((h.q[p]*xt.factor(Ke(_))).toFixed(xt.digits(Ke(_))))+0)),v("td",{},g)}),m=(_,p,g)=>{if(d===0)return v("td");let x=An({label:`${p} ${h.name}`,testid:`seq-${d}-${_}`,check:g,input:E=>{ht("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${_}`}),h[_]=E,ht("sequence")}});return x.put(h[_]),v("td",{},x)};return v("tr",{"data-testid":`seq-row-${d}`},v("th",{scope:"row"},v("button",{type:"button",class:"quiet",text:h.name,title:"Go there",on:{click:()=>Pi(h.q.slice())}})),f,m("seconds","Seconds to",_=>_>0?null:"more than 0"),m("hold","Rest after",_=>_>=0?null:"0 or more"),v("td",{class:"tools"},v("button",{type:"button",class:"icon",text:"\u2191",disabled:d===0,"aria-label":`Move ${h.name} up`,on:{click:()=>{ht("did",{label:`move ${h.name} up`}),t.postures.splice(d-1,0,...t.postures.splice(d,1)),l()}}}),v("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>{ht("did",{label:`remove ${h.name}`}),t.postures.splice(d,1),l(),ht("sequence")}}})))})),t.postures.length||i.append(v("tr",{},v("td",{class:"hint",colspan:String(u.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function c(){s.hidden=!1;let u=qr(n);if(u){s.dataset.tone="wrong",gt(s,u);return}r.disabled=!0;try{let h=t.postures,d=await He("motion",{postures:h.map(m=>m.q),seconds:h.slice(1).map(m=>m.seconds),holds:h.slice(1).map(m=>m.hold),rate:t.rate}),f=h.map((m,_)=>({x:d.arrivals[_],s:0,text:`${m.name} at ${d.arrivals[_].toFixed(2)} s`,short:m.name,stop:!1}));s.dataset.tone="good",gt(s,`${h.length} postures in ${d.t[d.t.length-1].toFixed(2)} s. ${DL(d.q)}`),Di(ar({table:M.table,q:d.q,xs:d.t,xName:"time",seconds:d.t,dq:d.dq,events:f,title:`${M.table.name}: ${h.map(m=>m.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",gt(s,h.message)}finally{r.disabled=t.postures.length<2}}nt(["table","units","sequence-loaded"],l),l()}};function DL(n){let t=M.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var NL=.14,_o=new Ye(new Es(1,32,20),new ri({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));_o.matrixAutoUpdate=!1;_o.visible=!1;_o.renderOrder=4;var pu="none";function UL(n,t,e){let i=bx(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function mw(n){pu=n,gw()}var rp=()=>M.ellipsoid??null;function gw(){let n=pu!=="none"&&M.table.joints.length>0;if(_o.visible=n,M.ellipsoid=null,n){let t=UL(M.table,M.q,M.frames),e=NL*li(M.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(pu==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=ee(M.frames.at(-1)),[a,l]=r,c={...r[2]};_o.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),_o.material.color.set(pu==="velocity"?Bt.trace:Bt.accent),_o.material.side=hi,M.ellipsoid=t}_e(),ht("ellipsoid")}function xw(){hn.add(_o),nt(["q","theme"],()=>pu!=="none"&&gw())}var op=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new te(n)),$0=new tr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Gi=new Er(new be,$0);Gi.frustumCulled=!1;Gi.visible=!1;hn.add(Gi);var Rl=null,mu=null,Vi=0,yo={lo:0,hi:1};function _w(n){Rl=new Float32Array(3*n),mu=new Float32Array(n),Vi=0,Gi.geometry.dispose(),Gi.geometry=new be,Gi.geometry.setAttribute("position",new Oe(Rl,3)),Gi.geometry.setAttribute("color",new Oe(new Float32Array(3*n),3)),Gi.geometry.setDrawRange(0,0),Gi.visible=!0,_e()}function yw(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Vi<mu.length;i+=4,Vi++)Rl.set(e.subarray(i,i+3),3*Vi),mu[Vi]=e[i+3];OL()}function OL(){let n=mu.slice(0,Vi).sort();yo.lo=n[Math.floor(Vi*.02)]??0,yo.hi=n[Math.max(Math.ceil(Vi*.98)-1,0)]??1;let t=new te,e=Gi.geometry.attributes.color.array,i=yo.hi-yo.lo||1;for(let s=0;s<Vi;s++){let r=Math.min(Math.max((mu[s]-yo.lo)/i,0),1)*(op.length-1),o=Math.min(Math.floor(r),op.length-2);t.lerpColors(op[o],op[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Gi.geometry.setDrawRange(0,Vi),Gi.geometry.attributes.position.needsUpdate=!0,Gi.geometry.attributes.color.needsUpdate=!0,_e()}var gu=()=>Vi;function vw(n){es.localClippingEnabled=n!==null,$0.clippingPlanes=n===null?null:[new si(new H(0,1,0),-n)],$0.needsUpdate=!0,_e()}function bw(){let n=new Fi;for(let i=0;i<Vi;i++)n.expandByPoint(new H(Rl[3*i],Rl[3*i+1],Rl[3*i+2]));let{min:t,max:e}=n;return Vi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Mw(){Vi=0,Gi.visible=!1,_e()}var ww=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],ap=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ti(n,4):n.toExponential(2).replace("-","\u2212"),Ew={id:"analysis",title:"Analysis",build(n){let t=v("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(v("div",{title:h},v("dt",{text:u}),i[c]=v("dd",{"data-testid":`fact-${c}`})));let s=v("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=v("p",{class:"hint","data-testid":"ellipsoid-axes"});nt("ellipsoid",()=>{let c=rp();gt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>ue(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,v("h3",{text:"At the tool\u2019s point"}),Je("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",mw,"ellipsoid"),o,v("h3",{text:"Distance to the limits"}),s,v("h3",{text:"Reachable points"}),BL());let a=()=>{r=M.table.joints.map((c,u)=>{let h=v("span",{class:"bar-fill"}),d=v("span",{class:"bar-text"});return{el:v("div",{class:"distance"},v("span",{},v("i",{text:"q"}),v("sub",{text:String(u+1)})),v("span",{class:"bar"},h),d),fill:h,text:d}}),Vt(s,r.map(c=>c.el)),l()},l=Xs(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let c=Au(M.table,M.q,M.frames),u=c[0],h=c[c.length-1];gt(i.manipulability,ap(c.reduce((d,f)=>d*f,1))),gt(i.condition,u>1e-9?ti(h/u,1):"\u221E"),gt(i.least,ap(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:m},_)=>{let p=M.table.joints[_],g=M.q[_];if(p.lower===null||p.upper===null){f.style.setProperty("width","100%"),gt(m,"no limit");return}let x=Math.min(g-p.lower,p.upper-g),E=Math.max(2*x/(p.upper-p.lower||1),0);f.style.setProperty("width",`${100*E}%`),d.classList.toggle("outside",x<-1e-9),gt(m,x<-1e-9?`${ue(-x,Ke(p))} beyond`:ue(x,Ke(p)))})});nt("table",a),nt(["q","units","panel"],l),a()}};function BL(){let n="20000",t="manipulability",e=!1,i=v("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Yi("cancel",{kind:"cloud"}):d()}}),s=v("button",{type:"button",text:"Clear",on:{click:h}}),r=Je("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>vw(f==="half"?M.table.base[7]:null),"cloud-cut"),o=v("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=v("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=v("span"),c=v("span"),u=v("div",{class:"legend-scale",hidden:!0},l,v("span",{class:"scale-bar"}),c);function h(){Mw(),Dr("cloud",[]),u.hidden=!0,gt(a,"")}async function d(){e=!0,gt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,_w(Number(n));try{let f=await He("cloud",{count:Number(n),colour:t,seed:1},m=>{yw(m.points),o.value=m.done/m.of,gt(l,ap(yo.lo)),gt(c,ap(yo.hi)),gt(a,`${m.done.toLocaleString("en")} of ${m.of.toLocaleString("en")} points`)});gt(a,f.stopped?`Cancelled after ${gu().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${ww.find(([m])=>m===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){gt(a,f.message)}e=!1,Dr("cloud",bw()),Yc(),gt(i,"Draw the cloud"),o.hidden=!0}return nt("table",f=>{f!=="postures"&&f!=="name"&&gu()&&h()}),v("div",{},v("div",{class:"line"},gn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),v("span",{class:"field-name",text:"coloured by"}),gn("Coloured by",ww,t,f=>{t=f},{"data-testid":"cloud-colour"})),v("div",{class:"line"},i,s,r),o,u,a)}var Tw=n=>({id:"share",title:"Share",build(t,e){let i=v("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=v("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=v("p",{class:"hint",role:"status","data-testid":"report-note"}),o=v("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:u}}),a=v("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(v("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),v("div",{class:"line share-link"},i,v("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>Wr(await yf())}})),v("h3",{text:"As a file"}),v("div",{class:"line"},v("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>bi(`${M.table.name||"arm"}.workbench.json`,JSON.stringify(xf(),null,1),"application/json")}}),v("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,v("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:Zf}})),v("h3",{text:"As Python"}),v("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,v("div",{class:"line"},v("button",{type:"button",text:"Copy the script","data-testid":"copy-python",on:{click:()=>Wr(a.value)}}),v("button",{type:"button",text:"Save the script",on:{click:()=>bi("workbench.py",a.value,"text/x-python")}})),v("h3",{text:"Report"}),v("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),v("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&M.table.joints.length&&(i.value=await yf()),!e.hidden&&M.table.joints.length&&c()},c=qs(async()=>{try{let{q:d,target:f,hasTarget:m,path:_,program:p}=M,{task:g,redundancy:x}=he,E={q:d,target:m?f:null,path:_,task:g,redundancy:x,program:Ml()};a.value=(await He("python",p.length?E:{...E,program:null})).text}catch(d){a.value=`# ${d.message}`}});nt(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await He("report",{q:M.q},m=>gt(r,m.note));bi(f,d,"text/html"),gt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){gt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");_f(JSON.parse(await f.text()),n()),Pe("Opened")}catch(m){Pe(m instanceof SyntaxError?`${f.name} is not a state file.`:m.message,"wrong")}}}});var kL=40,Rw=!1,Cw=0,X0=!1,lp=null,Aw=null;function Pw(n){n&&(Rw=!0,lp=M.table,Iw(n))}function Iw(n){X0=!0,Cw=n.said,n.table&&(mn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),lp=M.table,yl(n.looks??null,n.table)),n.things&&zL(n.things),n.target&&(M.hasTarget=!0,vi(n.target,"restored")),n.q&&n.q.length===M.table.joints.length&&(ht("did",{label:"move from Python",key:"python"}),Ui(n.q,"python")),X0=!1}function zL(n){M.things=n.filter(i=>i.kind!=="motion"),ht("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==Aw){if(Aw=e,!t){Di(null);return}Di(ar({table:M.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${M.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var HL=ha(kL,()=>{let n=M.table===lp?void 0:wp(M.table);lp=M.table,M.table.joints.length&&Yi("shown",{q:M.q,target:M.hasTarget?M.target:null,table:n,said:Cw}).catch(()=>{})});function Lw(){nt("push",Iw),nt(["q","target","table"],()=>Rw&&!X0&&HL.soon())}var Ko=new En,Nw=new ri({fog:!1}),Y0=new ri({fog:!1}),Z0=new Oi(1,1,1),j0=new Ye(Z0,Nw),Uw=[new Ye(Z0,Y0),new Ye(Z0,Y0)];Ko.add(j0,...Uw);Ko.matrixAutoUpdate=!1;Ko.visible=!1;var xu=null;function Fw(){hn.add(Ko),nt("q",()=>xu!==null&&Bw()),nt("theme",Dw),Dw()}function Dw(){Nw.color.set(Bt.joint),Y0.color.set(Bt.accent)}function J0(n){n===null&&xu===null||(xu=n,Ko.visible=n!==null,n!==null&&Bw(),_e())}var Ow=()=>xu;function Bw(){let n=M.frames.at(-1),t=.075*li(M.table);j0.scale.set(.35*t,1.1*t,.25*t),j0.position.set(0,0,-.85*t),Uw.forEach((e,i)=>{let s=(.08+.36*(1-xu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),Ko.matrix.set(...n),Ko.updateMatrixWorld(!0)}var WL=.25,K0=.5;function qL(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(M.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=YL(n,r);if(o>=K0&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:as(Ni(ee(u.at(-1).T),ee(a)))})).filter(({name:c,d:u})=>u<$L(M.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:ni(Su(a),l.T)}))}else o<K0&&s&&i&&(e.get(i).push({t:r,T:ni(a,e.get(i).at(-1).held)}),i=null);s=o>=K0}return{grips:t,objects:e}}var $L=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function XL(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var YL=(n,t)=>vs(n.table,n.q[XL(n.seconds,t)]).at(-1),vo=null,ZL=n=>{let t=vo.grips.length?1-Math.round(vo.grips[0].value):0;for(let e of vo.grips){if(e.t>n)break;let i=Math.min((n-e.t)/WL,1);t+=i*(e.value-t)}return t};function kw(){nt("motion",()=>{ow(),vo=M.motion?.happens?qL(M.motion):null,vo||J0(null)}),nt("played",n=>{if(!vo)return;let t=M.frames.at(-1);vo.grips.length&&J0(ZL(n));for(let[e,i]of vo.objects){let s=i.findLast(r=>r.t<=n)??i[0];G0(e,s.held?ni(t,s.held):s.T)}})}function zw(){window.workbench=Object.freeze({get q(){return M.q.slice()},get frames(){return structuredClone(M.frames)},get target(){return M.target.slice()},get table(){return structuredClone(M.table)},get solutions(){return structuredClone(M.solutions)},get camera(){return Gd()},get pictures(){return Xy()},get ghosts(){return Xv()},get history(){return[pf(),mf()]},get beyond(){return Wv()},get things(){return aw()},get looks(){return dS()},get program(){return structuredClone(M.program)},get route(){return structuredClone(M.route)},routePlace(n,t){let e={which:n,turn:t};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:e})),e.at},get motion(){return structuredClone(M.motion)},get gripper(){return Ow()},placeOf:n=>rw(n)??M.world.find(t=>t.name===n)?.T??null,go:Or,get stepFrame(){return M.dhStep===null?null:Yd().at(-1).T},get clearance(){return structuredClone(M.clearance)},get bodies(){return uw()},get ellipsoid(){return structuredClone(rp())},get world(){return structuredClone(M.world)},get framesDrawn(){return qv()},get answers(){return Pg.answers},get trace(){return Jv()},get cloud(){return gu()},toScreen:ki,withPicture:n=>Za(n),handles:()=>bv(),forward:(n,t)=>vs(n,t),convert:(n,t)=>Xf(n,t),read:(n,t)=>Ff(n,t),present:(n,t,e)=>jf(n,t,e)})}Nd();Zy($s("#view"));nt("theme",ig);ig();ib();zv();_v();sw();hS();dw();xw();Fw();kw();Lw();Cx();tb();gS($s("#bar"));_S($s("#overlay"));XM($s("#dock"));yS();var cp,_u=(n,t,...e)=>[{...t,group:n},...e];cp=xS($s("#rail"),$s("#panels"),$s("#pinned"),[..._u("Drive",{id:"move",title:"Move",sections:[HM,bS]},PS),..._u("Describe",OS,fw),..._u("Plan",HS,JS(()=>cp),ew,pw),..._u("Study",MS,kS,Ew),..._u("Hand on",Tw(()=>cp))]);JM($s("#room"),$s("#rail"));hb();var JL=cb().then(n=>n&&_f(n,cp)).catch(n=>Pe(`The link could not be read: ${n.message}`,"wrong"));nt("online",async n=>{if(!n)return;await JL;let t=await Ex();M.catalog=t.catalog,ht("catalog"),t.table&&(!M.table.joints.length||t.bench)&&(mn(t.table,{q:ua(t.table),step:!1,what:"new"}),gf()),t.looks&&yl(t.looks,t.table),Pw(t.bench),document.documentElement.dataset.ready="yes"});M.online&&ht("online",!0);document.fonts?.ready.then(()=>ht("theme"));zw();
