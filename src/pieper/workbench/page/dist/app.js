import{A as b,B as Oi,C as Ju,D as Aa,E as yn,F as R_,G as wi,H as C_,I as Bo,K as Fi,L as Ks,a as Ji,b as Hn,c as Ta,d as te,e as Js,f as rc,g as Ni,h as oc,i as Yu,j as Ui,k as ju,l as Zu,m as M_,n as S_,o as br,p as Mr,q as w_,r as As,s as im,t as E_,u as Gn,v as ac,w as T_,x as A_,y as tt,z as ct}from"./chunk-MK7W7VMR.js";import{a as b_}from"./chunk-WOT6VMZA.js";var Ra=null,Ku=new Map,P_=()=>{Ra=null;let n=[...Ku.values()];Ku.clear();for(let t of n)t()};addEventListener("pointerdown",n=>Ra=n.target,!0);addEventListener("pointerup",()=>setTimeout(P_,60),!0);addEventListener("pointercancel",P_,!0);addEventListener("click",()=>Ra=null,!0);function Qu(n,t){Ra&&Ra!==n&&n.contains(Ra)?Ku.set(n,t):(Ku.delete(n),t())}function S(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Ut=(n,t,e)=>S("button",{type:"button",text:n,...t,on:{click:e}}),Rs=(n,t=document)=>t.querySelector(n),Gt=(n,...t)=>Qu(n,()=>n.replaceChildren(...t.flat().filter(Boolean)));function bt(n,t){n.textContent!==t&&(n.textContent=t)}function Be(n,t,e,i,s){let r=S("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(S("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function hn(n,t,e,i,s={}){let r=S("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>S("option",{value:o,text:a})));return r.value=e,r}function Qs(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Ca(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function tr(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function hi(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=S("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function eo(n){try{await navigator.clipboard.writeText(n)}catch{let t=S("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}he("Copied")}var I_;function he(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(I_),I_=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Sr(...n){for(let t of n){let e=o=>{let a=o.closest("[hidden]");return!a||a.contains(t)},i=[...t.querySelectorAll(".number.wrong")].find(e);if(!i)continue;let s=t.closest(".panel");return i.closest("details")&&(i.closest("details").open=!0),i.focus(),`${s.hidden?`${document.getElementById(s.getAttribute("aria-labelledby")).textContent}: `:""}${i.getAttribute("aria-label")} cannot be read (${i.title}).`}return null}var Pa=0,th=0,om=-1,sm=[];function am(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function rm(){let n=Pa;if(!b.table.joints.length){b.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ct("plan");return}try{let{plan:t}=await Fi("arm",{table:am(b.table)});if(n!==Pa)return;om=n,b.plan=t,L_()}catch(t){if(n!==Pa||t instanceof Bo)return;b.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},L_(t)}ct("plan")}function L_(n){let t=sm;sm=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var D_=tr(rm,60);function N_(){tt("table",n=>{Pa+=1,["postures","name","gripper"].includes(n)||(th+=1),n==="postures"&&(om=-1),n==="cell"?D_():(D_.cancel(),rm())}),tt("online",n=>{n&&(Pa+=1,rm())})}function CE(){return om===Pa?Promise.resolve():new Promise((n,t)=>sm.push({resolve:n,reject:t}))}var no=()=>th,eh=class extends Error{},nh=n=>n instanceof Bo||n instanceof eh;async function Oe(n,t,e,{whichever:i=!1}={}){let s=th;await CE();let r=await Fi(n,t,e);if(s!==th&&!i)throw new eh("The arm was changed meanwhile, so the answer is not shown.");return r}function U_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function ih(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var po={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},mo={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},my=0,Om=1,gy=2;var Gc=1,xy=2,sl=3,or=0,oi=1,mi=2,Xo=0,rl=1,Fm=2,Bm=3,km=4,_y=5;var Yo=100,yy=101,vy=102,by=103,My=104,Sy=200,wy=201,Ey=202,Ty=203,zm=204,Hm=205,Ay=206,Ry=207,Cy=208,Py=209,Iy=210,Ly=211,Dy=212,Ny=213,Uy=214,Ih=0,Lh=1,Dh=2,qa=3,Nh=4,Uh=5,Oh=6,Fh=7,Gm=0,Oy=1,Fy=2,ar=0,Vm=1,Wm=2,$m=3,qm=4,Xm=5,Ym=6,jm=7;var Zm=300,jo=301,ol=302,cd=303,ud=304,Bh=1e3,nr=1001,kh=1002,ni=1003,By=1004;var Vc=1005;var Ri=1006,hd=1007;var Ur=1008;var is=1009,Jm=1010,Km=1011,al=1012,dd=1013,Ns=1014,ps=1015,Us=1016,fd=1017,pd=1018,Zo=1020,Qm=35902,tg=35899,eg=1021,ng=1022,Os=1023,Pr=1026,Or=1027,md=1028,gd=1029,go=1030,xd=1031;var _d=1033,Wc=33776,$c=33777,qc=33778,Xc=33779,yd=35840,vd=35841,bd=35842,Md=35843,Sd=36196,wd=37492,Ed=37496,Td=37488,Ad=37489,Yc=37490,Rd=37491,Cd=37808,Pd=37809,Id=37810,Ld=37811,Dd=37812,Nd=37813,Ud=37814,Od=37815,Fd=37816,Bd=37817,kd=37818,zd=37819,Hd=37820,Gd=37821,Vd=36492,Wd=36494,$d=36495,qd=36283,Xd=36284,jc=36285,Yd=36286;var _c=2300,zh=2301,Ch=2302,Rm=2303,Cm=2400,Pm=2401,Im=2402;var ky=3200;var ig=0,zy=1,Fr="",Ti="srgb",yc="srgb-linear",vc="linear",$e="srgb";var Ph=7680,sg=7681;var rg=517;var Hy=519,Gy=512,Vy=513,Wy=514,og=515,$y=516,qy=517,ag=518,lg=519,cg=35044,jd=35048;var ug="300 es",fs=2e3,bc=2001;function IE(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function LE(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Mc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Xy(){let n=Mc("canvas");return n.style.display="block",n}var O_={},Xa=null;function Sc(...n){let t="THREE."+n.shift();Xa?Xa("log",t,...n):console.log(t,...n)}function Yy(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ie(...n){n=Yy(n);let t="THREE."+n.shift();if(Xa)Xa("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ce(...n){n=Yy(n);let t="THREE."+n.shift();if(Xa)Xa("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function mc(...n){let t=n.join(" ");t in O_||(O_[t]=!0,ie(...n))}function jy(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Zy={[Ih]:Ih,[Dh]:Oh,[Nh]:Nh,[qa]:Uh,[Lh]:Lh,[Oh]:Dh,[Fh]:Fh,[Uh]:qa},Ls=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},di=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],F_=1234567,gc=Math.PI/180,Ya=180/Math.PI;function xo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(di[n&255]+di[n>>8&255]+di[n>>16&255]+di[n>>24&255]+"-"+di[t&255]+di[t>>8&255]+"-"+di[t>>16&15|64]+di[t>>24&255]+"-"+di[e&63|128]+di[e>>8&255]+"-"+di[e>>16&255]+di[e>>24&255]+di[i&255]+di[i>>8&255]+di[i>>16&255]+di[i>>24&255]).toLowerCase()}function Ae(n,t,e){return Math.max(t,Math.min(e,n))}function hg(n,t){return(n%t+t)%t}function DE(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function NE(n,t,e){return n!==t?(e-n)/(t-n):0}function xc(n,t,e){return(1-e)*n+e*t}function UE(n,t,e,i){return xc(n,t,1-Math.exp(-e*i))}function OE(n,t=1){return t-Math.abs(hg(n,t*2)-t)}function FE(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function BE(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function kE(n,t){return n+Math.floor(Math.random()*(t-n+1))}function zE(n,t){return n+Math.random()*(t-n)}function HE(n){return n*(.5-Math.random())}function GE(n){n!==void 0&&(F_=n);let t=F_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function VE(n){return n*gc}function WE(n){return n*Ya}function $E(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function qE(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function dg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function XE(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:ie("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Zd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function fg(n,t){if(t.constructor===Float32Array)return n;let e=Zd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function pg(n,t){if(t.constructor===Float32Array)return n;let e=Zd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var _o={DEG2RAD:gc,RAD2DEG:Ya,generateUUID:xo,clamp:Ae,euclideanModulo:hg,mapLinear:DE,inverseLerp:NE,lerp:xc,damp:UE,pingpong:OE,smoothstep:FE,smootherstep:BE,randInt:kE,randFloat:zE,randFloatSpread:HE,seededRandom:GE,degToRad:VE,radToDeg:WE,isPowerOfTwo:$E,ceilPowerOfTwo:qE,floorPowerOfTwo:dg,setQuaternionFromProperEuler:XE,normalize:pg,denormalize:fg},Qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*_;m<0&&(d=-d,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),M=Math.sin(x);g=Math.sin(g*x)/M,a=Math.sin(a*x)/M,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+_*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:ie("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Ae(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(B_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(B_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this.z=Ae(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this.z=Ae(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return lm.copy(this).projectOnVector(t),this.sub(lm)}reflect(t){return this.sub(lm.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},lm=new V,B_=new fn,de=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],_=s[0],m=s[3],g=s[6],x=s[1],M=s[4],v=s[7],A=s[2],E=s[5],y=s[8];return r[0]=o*_+a*x+l*A,r[3]=o*m+a*M+l*E,r[6]=o*g+a*v+l*y,r[1]=c*_+u*x+h*A,r[4]=c*m+u*M+h*E,r[7]=c*g+u*v+h*y,r[2]=d*_+f*x+p*A,r[5]=d*m+f*M+p*E,r[8]=d*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=h*_,t[1]=(s*c-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(u*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return mc("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(cm.makeScale(t,e)),this}rotate(t){return mc("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(cm.makeRotation(-t)),this}translate(t,e){return mc("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(cm.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},cm=new de,k_=new de().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),z_=new de().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function YE(){let n={enabled:!0,workingColorSpace:yc,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===$e&&(s.r=Cr(s.r),s.g=Cr(s.g),s.b=Cr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===$e&&(s.r=$a(s.r),s.g=$a(s.g),s.b=$a(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fr?vc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[yc]:{primaries:t,whitePoint:i,transfer:vc,toXYZ:k_,fromXYZ:z_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ti},outputColorSpaceConfig:{drawingBufferColorSpace:Ti}},[Ti]:{primaries:t,whitePoint:i,transfer:$e,toXYZ:k_,fromXYZ:z_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ti}}}),n}var De=YE();function Cr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function $a(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ia,Hh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Ia===void 0&&(Ia=Mc("canvas")),Ia.width=t.width,Ia.height=t.height;let s=Ia.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Ia}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Mc("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Cr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Cr(e[i]/255)*255):e[i]=Cr(e[i]);return{data:e,width:t.width,height:t.height}}else return ie("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},jE=0,ja=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jE++}),this.uuid=xo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(um(s[o].image)):r.push(um(s[o]))}else r=um(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function um(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Hh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ie("Texture: Unable to serialize Texture."),{})}var ZE=0,hm=new V,Bi=class n extends Ls{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=nr,s=nr,r=Ri,o=Ur,a=Os,l=is,c=n.DEFAULT_ANISOTROPY,u=Fr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ZE++}),this.uuid=xo(),this.name="",this.source=new ja(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Qt(0,0),this.repeat=new Qt(1,1),this.center=new Qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new de,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hm).x}get height(){return this.source.getSize(hm).y}get depth(){return this.source.getSize(hm).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ie(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Zm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Bh:t.x=t.x-Math.floor(t.x);break;case nr:t.x=t.x<0?0:1;break;case kh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Bh:t.y=t.y-Math.floor(t.y);break;case nr:t.y=t.y<0?0:1;break;case kh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Bi.DEFAULT_IMAGE=null;Bi.DEFAULT_MAPPING=Zm;Bi.DEFAULT_ANISOTROPY=1;var bn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,v=(f+1)/2,A=(g+1)/2,E=(u+d)/4,y=(h+_)/4,w=(p+m)/4;return M>v&&M>A?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=E/i,r=y/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=E/s,r=w/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=w/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(h-_)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Ae(this.x,t.x,e.x),this.y=Ae(this.y,t.y,e.y),this.z=Ae(this.z,t.z,e.z),this.w=Ae(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Ae(this.x,t,e),this.y=Ae(this.y,t,e),this.z=Ae(this.z,t,e),this.w=Ae(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Gh=class extends Ls{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new bn(0,0,t,e),this.scissorTest=!1,this.viewport=new bn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Bi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ja(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ts=class extends Gh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},wc=class extends Bi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=nr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Vh=class extends Bi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ni,this.minFilter=ni,this.wrapR=nr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ye=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/La.setFromMatrixColumn(t,0).length(),r=1/La.setFromMatrixColumn(t,1).length(),o=1/La.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d+_*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d-_*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+_,e[1]=l*h,e[5]=_*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=_-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-_*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+_,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=_*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(JE,t,KE)}lookAt(t,e,i){let s=this.elements;return Ki.subVectors(t,e),Ki.lengthSq()===0&&(Ki.z=1),Ki.normalize(),io.crossVectors(i,Ki),io.lengthSq()===0&&(Math.abs(i.z)===1?Ki.x+=1e-4:Ki.z+=1e-4,Ki.normalize(),io.crossVectors(i,Ki)),io.normalize(),sh.crossVectors(Ki,io),s[0]=io.x,s[4]=sh.x,s[8]=Ki.x,s[1]=io.y,s[5]=sh.y,s[9]=Ki.y,s[2]=io.z,s[6]=sh.z,s[10]=Ki.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],_=i[6],m=i[10],g=i[14],x=i[3],M=i[7],v=i[11],A=i[15],E=s[0],y=s[4],w=s[8],N=s[12],R=s[1],L=s[5],z=s[9],G=s[13],F=s[2],U=s[6],D=s[10],O=s[14],Z=s[3],X=s[7],J=s[11],nt=s[15];return r[0]=o*E+a*R+l*F+c*Z,r[4]=o*y+a*L+l*U+c*X,r[8]=o*w+a*z+l*D+c*J,r[12]=o*N+a*G+l*O+c*nt,r[1]=u*E+h*R+d*F+f*Z,r[5]=u*y+h*L+d*U+f*X,r[9]=u*w+h*z+d*D+f*J,r[13]=u*N+h*G+d*O+f*nt,r[2]=p*E+_*R+m*F+g*Z,r[6]=p*y+_*L+m*U+g*X,r[10]=p*w+_*z+m*D+g*J,r[14]=p*N+_*G+m*O+g*nt,r[3]=x*E+M*R+v*F+A*Z,r[7]=x*y+M*L+v*U+A*X,r[11]=x*w+M*z+v*D+A*J,r[15]=x*N+M*G+v*O+A*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],_=t[7],m=t[11],g=t[15],x=l*f-c*d,M=a*f-c*h,v=a*d-l*h,A=o*f-c*u,E=o*d-l*u,y=o*h-a*u;return e*(_*x-m*M+g*v)-i*(p*x-m*A+g*E)+s*(p*M-_*A+g*y)-r*(p*v-_*E+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],_=t[13],m=t[14],g=t[15],x=e*a-i*o,M=e*l-s*o,v=e*c-r*o,A=i*l-s*a,E=i*c-r*a,y=s*c-r*l,w=u*_-h*p,N=u*m-d*p,R=u*g-f*p,L=h*m-d*_,z=h*g-f*_,G=d*g-f*m,F=x*G-M*z+v*L+A*R-E*N+y*w;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let U=1/F;return t[0]=(a*G-l*z+c*L)*U,t[1]=(s*z-i*G-r*L)*U,t[2]=(_*y-m*E+g*A)*U,t[3]=(d*E-h*y-f*A)*U,t[4]=(l*R-o*G-c*N)*U,t[5]=(e*G-s*R+r*N)*U,t[6]=(m*v-p*y-g*M)*U,t[7]=(u*y-d*v+f*M)*U,t[8]=(o*z-a*R+c*w)*U,t[9]=(i*R-e*z-r*w)*U,t[10]=(p*E-_*v+g*x)*U,t[11]=(h*v-u*E-f*x)*U,t[12]=(a*N-o*L-l*w)*U,t[13]=(e*L-i*N+s*w)*U,t[14]=(_*M-p*A-m*x)*U,t[15]=(u*A-h*M+d*x)*U,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,_=o*u,m=o*h,g=a*h,x=l*c,M=l*u,v=l*h,A=i.x,E=i.y,y=i.z;return s[0]=(1-(_+g))*A,s[1]=(f+v)*A,s[2]=(p-M)*A,s[3]=0,s[4]=(f-v)*E,s[5]=(1-(d+g))*E,s[6]=(m+x)*E,s[7]=0,s[8]=(p+M)*y,s[9]=(m-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=La.set(s[0],s[1],s[2]).length(),a=La.set(s[4],s[5],s[6]).length(),l=La.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Cs.copy(this);let c=1/o,u=1/a,h=1/l;return Cs.elements[0]*=c,Cs.elements[1]*=c,Cs.elements[2]*=c,Cs.elements[4]*=u,Cs.elements[5]*=u,Cs.elements[6]*=u,Cs.elements[8]*=h,Cs.elements[9]*=h,Cs.elements[10]*=h,e.setFromRotationMatrix(Cs),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=fs,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===fs)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===bc)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=fs,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===fs)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===bc)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},La=new V,Cs=new ye,JE=new V(0,0,0),KE=new V(1,1,1),io=new V,sh=new V,Ki=new V,H_=new ye,G_=new fn,co=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Ae(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ae(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ae(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ae(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ae(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ae(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ie("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return H_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(H_,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return G_.setFromEuler(this),this.setFromQuaternion(G_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};co.DEFAULT_ORDER="XYZ";var Za=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},QE=0,V_=new V,Da=new fn,wr=new ye,rh=new V,lc=new V,tT=new V,eT=new fn,W_=new V(1,0,0),$_=new V(0,1,0),q_=new V(0,0,1),X_={type:"added"},nT={type:"removed"},Na={type:"childadded",child:null},dm={type:"childremoved",child:null},ki=class n extends Ls{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:QE++}),this.uuid=xo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new V,e=new co,i=new fn,s=new V(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ye},normalMatrix:{value:new de}}),this.matrix=new ye,this.matrixWorld=new ye,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Za,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Da.setFromAxisAngle(t,e),this.quaternion.multiply(Da),this}rotateOnWorldAxis(t,e){return Da.setFromAxisAngle(t,e),this.quaternion.premultiply(Da),this}rotateX(t){return this.rotateOnAxis(W_,t)}rotateY(t){return this.rotateOnAxis($_,t)}rotateZ(t){return this.rotateOnAxis(q_,t)}translateOnAxis(t,e){return V_.copy(t).applyQuaternion(this.quaternion),this.position.add(V_.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(W_,t)}translateY(t){return this.translateOnAxis($_,t)}translateZ(t){return this.translateOnAxis(q_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(wr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?rh.copy(t):rh.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),lc.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?wr.lookAt(lc,rh,this.up):wr.lookAt(rh,lc,this.up),this.quaternion.setFromRotationMatrix(wr),s&&(wr.extractRotation(s.matrixWorld),Da.setFromRotationMatrix(wr),this.quaternion.premultiply(Da.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ce("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(X_),Na.child=t,this.dispatchEvent(Na),Na.child=null):ce("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(nT),dm.child=t,this.dispatchEvent(dm),dm.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),wr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),wr.multiply(t.parent.matrixWorld)),t.applyMatrix4(wr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(X_),Na.child=t,this.dispatchEvent(Na),Na.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(lc,t,tT),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(lc,eT,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ki.DEFAULT_UP=new V(0,1,0);ki.DEFAULT_MATRIX_AUTO_UPDATE=!0;ki.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Rn=class extends ki{constructor(){super(),this.isGroup=!0,this.type="Group"}},iT={type:"move"},Ja=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Rn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Rn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Rn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(iT)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Rn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Jy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},so={h:0,s:0,l:0},oh={h:0,s:0,l:0};function fm(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ti){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,De.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=De.workingColorSpace){return this.r=t,this.g=e,this.b=i,De.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=De.workingColorSpace){if(t=hg(t,1),e=Ae(e,0,1),i=Ae(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=fm(o,r,t+1/3),this.g=fm(o,r,t),this.b=fm(o,r,t-1/3)}return De.colorSpaceToWorking(this,s),this}setStyle(t,e=Ti){function i(r){r!==void 0&&parseFloat(r)<1&&ie("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ie("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ie("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ti){let i=Jy[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ie("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Cr(t.r),this.g=Cr(t.g),this.b=Cr(t.b),this}copyLinearToSRGB(t){return this.r=$a(t.r),this.g=$a(t.g),this.b=$a(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ti){return De.workingToColorSpace(fi.copy(this),t),Math.round(Ae(fi.r*255,0,255))*65536+Math.round(Ae(fi.g*255,0,255))*256+Math.round(Ae(fi.b*255,0,255))}getHexString(t=Ti){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=De.workingColorSpace){De.workingToColorSpace(fi.copy(this),e);let i=fi.r,s=fi.g,r=fi.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=De.workingColorSpace){return De.workingToColorSpace(fi.copy(this),e),t.r=fi.r,t.g=fi.g,t.b=fi.b,t}getStyle(t=Ti){De.workingToColorSpace(fi.copy(this),t);let e=fi.r,i=fi.g,s=fi.b;return t!==Ti?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(so),this.setHSL(so.h+t,so.s+e,so.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(so),t.getHSL(oh);let i=xc(so.h,oh.h,e),s=xc(so.s,oh.s,e),r=xc(so.l,oh.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},fi=new ee;ee.NAMES=Jy;var Ec=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Tc=class extends ki{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new co,this.environmentIntensity=1,this.environmentRotation=new co,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ps=new V,Er=new V,pm=new V,Tr=new V,Ua=new V,Oa=new V,Y_=new V,mm=new V,gm=new V,xm=new V,_m=new bn,ym=new bn,vm=new bn,lo=class n{constructor(t=new V,e=new V,i=new V){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ps.subVectors(t,e),s.cross(Ps);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ps.subVectors(s,e),Er.subVectors(i,e),pm.subVectors(t,e);let o=Ps.dot(Ps),a=Ps.dot(Er),l=Ps.dot(pm),c=Er.dot(Er),u=Er.dot(pm),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Tr)===null?!1:Tr.x>=0&&Tr.y>=0&&Tr.x+Tr.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Tr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Tr.x),l.addScaledVector(o,Tr.y),l.addScaledVector(a,Tr.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return _m.setScalar(0),ym.setScalar(0),vm.setScalar(0),_m.fromBufferAttribute(t,e),ym.fromBufferAttribute(t,i),vm.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(_m,r.x),o.addScaledVector(ym,r.y),o.addScaledVector(vm,r.z),o}static isFrontFacing(t,e,i,s){return Ps.subVectors(i,e),Er.subVectors(t,e),Ps.cross(Er).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ps.subVectors(this.c,this.b),Er.subVectors(this.a,this.b),Ps.cross(Er).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Ua.subVectors(s,i),Oa.subVectors(r,i),mm.subVectors(t,i);let l=Ua.dot(mm),c=Oa.dot(mm);if(l<=0&&c<=0)return e.copy(i);gm.subVectors(t,s);let u=Ua.dot(gm),h=Oa.dot(gm);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Ua,o);xm.subVectors(t,r);let f=Ua.dot(xm),p=Oa.dot(xm);if(p>=0&&f<=p)return e.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Oa,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return Y_.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(Y_,a);let g=1/(m+_+d);return o=_*g,a=d*g,e.copy(i).addScaledVector(Ua,o).addScaledVector(Oa,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zi=class{constructor(t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Is.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Is.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Is.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Is):Is.fromBufferAttribute(r,o),Is.applyMatrix4(t.matrixWorld),this.expandByPoint(Is);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ah.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ah.copy(i.boundingBox)),ah.applyMatrix4(t.matrixWorld),this.union(ah)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Is),Is.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(cc),lh.subVectors(this.max,cc),Fa.subVectors(t.a,cc),Ba.subVectors(t.b,cc),ka.subVectors(t.c,cc),ro.subVectors(Ba,Fa),oo.subVectors(ka,Ba),ko.subVectors(Fa,ka);let e=[0,-ro.z,ro.y,0,-oo.z,oo.y,0,-ko.z,ko.y,ro.z,0,-ro.x,oo.z,0,-oo.x,ko.z,0,-ko.x,-ro.y,ro.x,0,-oo.y,oo.x,0,-ko.y,ko.x,0];return!bm(e,Fa,Ba,ka,lh)||(e=[1,0,0,0,1,0,0,0,1],!bm(e,Fa,Ba,ka,lh))?!1:(ch.crossVectors(ro,oo),e=[ch.x,ch.y,ch.z],bm(e,Fa,Ba,ka,lh))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Is).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Is).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ar[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ar[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ar[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ar[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ar[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ar[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ar[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ar[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ar),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ar=[new V,new V,new V,new V,new V,new V,new V,new V],Is=new V,ah=new zi,Fa=new V,Ba=new V,ka=new V,ro=new V,oo=new V,ko=new V,cc=new V,lh=new V,ch=new V,zo=new V;function bm(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){zo.fromArray(n,r);let a=s.x*Math.abs(zo.x)+s.y*Math.abs(zo.y)+s.z*Math.abs(zo.z),l=t.dot(zo),c=e.dot(zo),u=i.dot(zo);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Fn=new V,uh=new Qt,sT=0,He=class extends Ls{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:sT++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=cg,this.updateRanges=[],this.gpuType=ps,this.version=0,this._normalizationScale=t!==void 0?Zd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)uh.fromBufferAttribute(this,e),uh.applyMatrix3(t),this.setXY(e,uh.x,uh.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix3(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):fg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):pg(t,this.array)}};var Ac=class extends He{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Rc=class extends He{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var be=class extends He{constructor(t,e,i){super(new Float32Array(t),e,i)}},rT=new zi,uc=new V,Mm=new V,ir=class{constructor(t=new V,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):rT.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;uc.subVectors(t,this.center);let e=uc.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(uc,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Mm.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(uc.copy(t.center).add(Mm)),this.expandByPoint(uc.copy(t.center).sub(Mm))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},oT=0,ds=new ye,Sm=new ki,za=new V,Qi=new zi,hc=new zi,ei=new V,Me=class n extends Ls{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:oT++}),this.uuid=xo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(IE(t)?Rc:Ac)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new de().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return ds.makeRotationFromQuaternion(t),this.applyMatrix4(ds),this}rotateX(t){return ds.makeRotationX(t),this.applyMatrix4(ds),this}rotateY(t){return ds.makeRotationY(t),this.applyMatrix4(ds),this}rotateZ(t){return ds.makeRotationZ(t),this.applyMatrix4(ds),this}translate(t,e,i){return ds.makeTranslation(t,e,i),this.applyMatrix4(ds),this}scale(t,e,i){return ds.makeScale(t,e,i),this.applyMatrix4(ds),this}lookAt(t){return Sm.lookAt(t),Sm.updateMatrix(),this.applyMatrix4(Sm.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(za).negate(),this.translate(za.x,za.y,za.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new be(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ie("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Qi.setFromBufferAttribute(r),this.morphTargetsRelative?(ei.addVectors(this.boundingBox.min,Qi.min),this.boundingBox.expandByPoint(ei),ei.addVectors(this.boundingBox.max,Qi.max),this.boundingBox.expandByPoint(ei)):(this.boundingBox.expandByPoint(Qi.min),this.boundingBox.expandByPoint(Qi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ce('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ir);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ce("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){let i=this.boundingSphere.center;if(Qi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];hc.setFromBufferAttribute(a),this.morphTargetsRelative?(ei.addVectors(Qi.min,hc.min),Qi.expandByPoint(ei),ei.addVectors(Qi.max,hc.max),Qi.expandByPoint(ei)):(Qi.expandByPoint(hc.min),Qi.expandByPoint(hc.max))}Qi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)ei.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(ei));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)ei.fromBufferAttribute(a,c),l&&(za.fromBufferAttribute(t,c),ei.add(za)),s=Math.max(s,i.distanceToSquared(ei))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ce('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ce("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new He(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let N=0;N<i.count;N++)a[N]=new V,l[N]=new V;let u=new V,h=new V,d=new V,f=new Qt,p=new Qt,_=new Qt,m=new V,g=new V;function x(N,R,L){c[N]=c[R]=c[L]=1,u.fromBufferAttribute(i,N),h.fromBufferAttribute(i,R),d.fromBufferAttribute(i,L),f.fromBufferAttribute(r,N),p.fromBufferAttribute(r,R),_.fromBufferAttribute(r,L),h.sub(u),d.sub(u),p.sub(f),_.sub(f);let z=1/(p.x*_.y-_.x*p.y);isFinite(z)&&(m.copy(h).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(z),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(z),a[N].add(m),a[R].add(m),a[L].add(m),l[N].add(g),l[R].add(g),l[L].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let N=0,R=M.length;N<R;++N){let L=M[N],z=L.start,G=L.count;for(let F=z,U=z+G;F<U;F+=3)x(t.getX(F+0),t.getX(F+1),t.getX(F+2))}let v=new V,A=new V,E=new V,y=new V;function w(N){E.fromBufferAttribute(s,N),y.copy(E);let R=a[N];v.copy(R),v.sub(E.multiplyScalar(E.dot(R))).normalize(),A.crossVectors(y,R);let z=A.dot(l[N])<0?-1:1;o.setXYZW(N,v.x,v.y,v.z,z)}for(let N=0,R=i.count;N<R;++N)c[N]&&w(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new He(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,u=new V,h=new V;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),_=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)ei.fromBufferAttribute(t,e),ei.normalize(),t.setXYZ(e,ei.x,ei.y,ei.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new He(d,u,h)}if(this.index===null)return ie("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ka=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=cg,this.updateRanges=[],this.version=0,this.uuid=xo()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=j_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=j_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function j_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=xo()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Ei=new V,Qa=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Zd(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Ei.fromBufferAttribute(this,e),Ei.applyMatrix4(t),this.setXYZ(e,Ei.x,Ei.y,Ei.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ei.fromBufferAttribute(this,e),Ei.applyNormalMatrix(t),this.setXYZ(e,Ei.x,Ei.y,Ei.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ei.fromBufferAttribute(this,e),Ei.transformDirection(t),this.setXYZ(e,Ei.x,Ei.y,Ei.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Sc("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new He(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Sc("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):fg(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):pg(t,this.data.array)}},wm=new V,aT=new V,lT=new de,ri=class{constructor(t=new V(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=wm.subVectors(i,e).cross(aT.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(wm),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||lT.getNormalMatrix(t),s=this.coplanarPoint(wm).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},cT=0,Ir=class extends Ls{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:cT++}),this.uuid=xo(),this.name="",this.type="Material",this.blending=rl,this.side=or,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=zm,this.blendDst=Hm,this.blendEquation=Yo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=qa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Hy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ph,this.stencilZFail=Ph,this.stencilZPass=Ph,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ie(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ie(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ri().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Rr=new V,Em=new V,hh=new V,dh=new V,Lr=class{constructor(t=new V,e=new V(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Rr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Rr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Rr.copy(this.origin).addScaledVector(this.direction,e),Rr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Em.copy(t).add(e).multiplyScalar(.5),hh.copy(e).sub(t).normalize(),dh.copy(this.origin).sub(Em);let r=t.distanceTo(e)*.5,o=-this.direction.dot(hh),a=dh.dot(this.direction),l=-dh.dot(hh),c=dh.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Em).addScaledVector(hh,d),f}intersectSphere(t,e){if(t.radius<0)return null;Rr.subVectors(t.center,this.origin);let i=Rr.dot(this.direction),s=Rr.dot(Rr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Rr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,_=e.y-o.y,m=e.z-o.z,g=i.x-o.x,x=i.y-o.y,M=i.z-o.z,v=Math.abs(l),A=Math.abs(c),E=Math.abs(u),y,w,N,R,L,z,G,F,U,D,O,Z;if(v>=A&&v>=E?(N=l,z=h,U=p,Z=g,l>=0?(y=c,w=u,R=d,L=f,G=_,F=m,D=x,O=M):(y=u,w=c,R=f,L=d,G=m,F=_,D=M,O=x)):A>=E?(N=c,z=d,U=_,Z=x,c>=0?(y=u,w=l,R=f,L=h,G=m,F=p,D=M,O=g):(y=l,w=u,R=h,L=f,G=p,F=m,D=g,O=M)):(N=u,z=f,U=m,Z=M,u>=0?(y=l,w=c,R=h,L=d,G=p,F=_,D=g,O=x):(y=c,w=l,R=d,L=h,G=_,F=p,D=x,O=g)),N===0)return null;let X=y/N,J=w/N,nt=1/N,dt=R-X*z,ft=L-J*z,st=G-X*U,yt=F-J*U,xt=D-X*Z,Tt=O-J*Z,At=xt*yt-Tt*st,Jt=dt*Tt-ft*xt,xe=st*ft-yt*dt;if(s){if(At<0||Jt<0||xe<0)return null}else if((At<0||Jt<0||xe<0)&&(At>0||Jt>0||xe>0))return null;let jt=At+Jt+xe;if(jt===0)return null;let Te=nt*(At*z+Jt*U+xe*Z);return(jt>0?Te<0:Te>0)?null:this.at(Te/jt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vn=class extends Ir{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new co,this.combine=Gm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Z_=new ye,Ho=new Lr,fh=new ir,J_=new V,ph=new V,mh=new V,gh=new V,Tm=new V,xh=new V,K_=new V,_h=new V,Ge=class extends ki{constructor(t=new Me,e=new Vn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){xh.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Tm.fromBufferAttribute(h,t),o?xh.addScaledVector(Tm,u):xh.addScaledVector(Tm.sub(e),u))}e.add(xh)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),fh.copy(i.boundingSphere),fh.applyMatrix4(r),Ho.copy(t.ray).recast(t.near),!(fh.containsPoint(Ho.origin)===!1&&(Ho.intersectSphere(fh,J_)===null||Ho.origin.distanceToSquared(J_)>(t.far-t.near)**2))&&(Z_.copy(r).invert(),Ho.copy(t.ray).applyMatrix4(Z_),!(i.boundingBox!==null&&Ho.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Ho)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=M;v<A;v+=3){let E=a.getX(v),y=a.getX(v+1),w=a.getX(v+2);s=yh(this,g,t,i,c,u,h,E,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),M=a.getX(m+1),v=a.getX(m+2);s=yh(this,o,t,i,c,u,h,x,M,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=M;v<A;v+=3){let E=v,y=v+1,w=v+2;s=yh(this,g,t,i,c,u,h,E,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,M=m+1,v=m+2;s=yh(this,o,t,i,c,u,h,x,M,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function uT(n,t,e,i,s,r,o,a){let l;if(t.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===or,a),l===null)return null;_h.copy(a),_h.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(_h);return c<e.near||c>e.far?null:{distance:c,point:_h.clone(),object:n}}function yh(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ph),n.getVertexPosition(l,mh),n.getVertexPosition(c,gh);let u=uT(n,t,e,i,ph,mh,gh,K_);if(u){let h=new V;lo.getBarycoord(K_,ph,mh,gh,h),s&&(u.uv=lo.getInterpolatedAttribute(s,a,l,c,h,new Qt)),r&&(u.uv1=lo.getInterpolatedAttribute(r,a,l,c,h,new Qt)),o&&(u.normal=lo.getInterpolatedAttribute(o,a,l,c,h,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new V,materialIndex:0};lo.getNormal(ph,mh,gh,d.normal),u.face=d,u.barycoord=h}return u}var Cc=class extends Bi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ni,u=ni,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var tl=class extends He{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ha=new ye,Q_=new ye,vh=[],ty=new zi,hT=new ye,dc=new Ge,fc=new ir,Pc=class extends Ge{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new tl(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,hT)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new zi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ha),ty.copy(t.boundingBox).applyMatrix4(Ha),this.boundingBox.union(ty)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ir),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Ha),fc.copy(t.boundingSphere).applyMatrix4(Ha),this.boundingSphere.union(fc)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(dc.geometry=this.geometry,dc.material=this.material,dc.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),fc.copy(this.boundingSphere),fc.applyMatrix4(i),t.ray.intersectsSphere(fc)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Ha),Q_.multiplyMatrices(i,Ha),dc.matrixWorld=Q_,dc.raycast(t,vh);for(let o=0,a=vh.length;o<a;o++){let l=vh[o];l.instanceId=r,l.object=this,e.push(l)}vh.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new tl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Cc(new Float32Array(s*this.count),s,this.count,md,ps));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Go=new ir,dT=new Qt(.5,.5),bh=new V,Vo=class{constructor(t=new ri,e=new ri,i=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=fs,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],M=r[13],v=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-p,A-x).normalize(),s[1].setComponents(c+o,f+u,g+p,A+x).normalize(),s[2].setComponents(c+a,f+h,g+_,A+M).normalize(),s[3].setComponents(c-a,f-h,g-_,A-M).normalize(),i)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,f-d,g-m,A-v).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-v).normalize(),e===fs)s[5].setComponents(c+l,f+d,g+m,A+v).normalize();else if(e===bc)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Go.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Go.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Go)}intersectsSprite(t){Go.center.set(0,0,0);let e=dT.distanceTo(t.center);return Go.radius=.7071067811865476+e,Go.applyMatrix4(t.matrixWorld),this.intersectsSphere(Go)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(bh.x=s.normal.x>0?t.max.x:t.min.x,bh.y=s.normal.y>0?t.max.y:t.min.y,bh.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(bh)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ey=new ye,Wh=class n{constructor(){this.coordinateSystem=fs,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];ey.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Vo),i[s].setFromProjectionMatrix(ey,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Vo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var es=class extends Ir{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},$h=new V,qh=new V,ny=new ye,pc=new Lr,Mh=new ir,Am=new V,iy=new V,sr=class extends ki{constructor(t=new Me,e=new es){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)$h.fromBufferAttribute(e,s-1),qh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=$h.distanceTo(qh);t.setAttribute("lineDistance",new be(i,1))}else ie("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Mh.copy(i.boundingSphere),Mh.applyMatrix4(s),Mh.radius+=r,t.ray.intersectsSphere(Mh)===!1)return;ny.copy(s).invert(),pc.copy(t.ray).applyMatrix4(ny);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=u.getX(_),x=u.getX(_+1),M=Sh(this,t,pc,l,g,x,_);M&&e.push(M)}if(this.isLineLoop){let _=u.getX(p-1),m=u.getX(f),g=Sh(this,t,pc,l,_,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=Sh(this,t,pc,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=Sh(this,t,pc,l,p-1,f,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Sh(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if($h.fromBufferAttribute(a,s),qh.fromBufferAttribute(a,r),e.distanceSqToSegment($h,qh,Am,iy)>i)return;Am.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Am);if(!(c<t.near||c>t.far))return{distance:c,point:iy.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var sy=new V,ry=new V,Wo=class extends sr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)sy.fromBufferAttribute(e,s),ry.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+sy.distanceTo(ry);t.setAttribute("lineDistance",new be(i,1))}else ie("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var rr=class extends Ir{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},oy=new ye,Lm=new Lr,wh=new ir,Eh=new V,Dr=class extends ki{constructor(t=new Me,e=new rr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),wh.copy(i.boundingSphere),wh.applyMatrix4(s),wh.radius+=r,t.ray.intersectsSphere(wh)===!1)return;oy.copy(s).invert(),Lm.copy(t.ray).applyMatrix4(oy);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,_=f;p<_;p++){let m=c.getX(p);Eh.fromBufferAttribute(h,m),ay(Eh,m,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let p=d,_=f;p<_;p++)Eh.fromBufferAttribute(h,p),ay(Eh,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ay(n,t,e,i,s,r,o){let a=Lm.distanceSqToPoint(n);if(a<e){let l=new V;Lm.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Ic=class extends Bi{constructor(t=[],e=jo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Nr=class extends Bi{constructor(t,e,i=Ns,s,r,o,a=ni,l=ni,c,u=Pr,h=1){if(u!==Pr&&u!==Or)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ja(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Lc=class extends Nr{constructor(t,e=Ns,i=jo,s,r,o=ni,a=ni,l,c=Pr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Dc=class extends Bi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Hi=class n extends Me{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new be(c,3)),this.setAttribute("normal",new be(u,3)),this.setAttribute("uv",new be(h,2));function p(_,m,g,x,M,v,A,E,y,w,N){let R=v/y,L=A/w,z=v/2,G=A/2,F=E/2,U=y+1,D=w+1,O=0,Z=0,X=new V;for(let J=0;J<D;J++){let nt=J*L-G;for(let dt=0;dt<U;dt++){let ft=dt*R-z;X[_]=ft*x,X[m]=nt*M,X[g]=F,c.push(X.x,X.y,X.z),X[_]=0,X[m]=0,X[g]=E>0?1:-1,u.push(X.x,X.y,X.z),h.push(dt/y),h.push(1-J/w),O+=1}}for(let J=0;J<w;J++)for(let nt=0;nt<y;nt++){let dt=d+nt+U*J,ft=d+nt+U*(J+1),st=d+(nt+1)+U*(J+1),yt=d+(nt+1)+U*J;l.push(dt,ft,yt),l.push(ft,st,yt),Z+=6}a.addGroup(f,Z,N),f+=Z,d+=O}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},$o=class n extends Me{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,p=i*2+r,_=s+1,m=new V,g=new V;for(let x=0;x<=p;x++){let M=0,v=0,A=0,E=0;if(x<=i){let N=x/i,R=N*Math.PI/2;v=-u-t*Math.cos(R),A=t*Math.sin(R),E=-t*Math.cos(R),M=N*h}else if(x<=i+r){let N=(x-i)/r;v=-u+N*e,A=t,E=0,M=h+N*d}else{let N=(x-i-r)/i,R=N*Math.PI/2;v=u+t*Math.sin(R),A=t*Math.cos(R),E=t*Math.sin(R),M=h+d+N*h}let y=Math.max(0,Math.min(1,M/f)),w=0;x===0?w=.5/s:x===p&&(w=-.5/s);for(let N=0;N<=s;N++){let R=N/s,L=R*Math.PI*2,z=Math.sin(L),G=Math.cos(L);g.x=-A*G,g.y=v,g.z=A*z,a.push(g.x,g.y,g.z),m.set(-A*G,E,A*z),m.normalize(),l.push(m.x,m.y,m.z),c.push(R+w,y)}if(x>0){let N=(x-1)*_;for(let R=0;R<s;R++){let L=N+R,z=N+R+1,G=x*_+R,F=x*_+R+1;o.push(L,z,G),o.push(z,F,G)}}}this.setIndex(o),this.setAttribute("position",new be(a,3)),this.setAttribute("normal",new be(l,3)),this.setAttribute("uv",new be(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},Nc=class n extends Me{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new V,u=new Qt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,d=3;h<=e;h++,d+=3){let f=i+h/e*s;c.x=t*Math.cos(f),c.y=t*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[d]/t+1)/2,u.y=(o[d+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new be(o,3)),this.setAttribute("normal",new be(a,3)),this.setAttribute("uv",new be(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ci=class n extends Me{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,_=[],m=i/2,g=0;x(),o===!1&&(t>0&&M(!0),e>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new be(h,3)),this.setAttribute("normal",new be(d,3)),this.setAttribute("uv",new be(f,2));function x(){let v=new V,A=new V,E=0,y=(e-t)/i;for(let w=0;w<=r;w++){let N=[],R=w/r,L=R*(e-t)+t;for(let z=0;z<=s;z++){let G=z/s,F=G*l+a,U=Math.sin(F),D=Math.cos(F);A.x=L*U,A.y=-R*i+m,A.z=L*D,h.push(A.x,A.y,A.z),v.set(U,y,D).normalize(),d.push(v.x,v.y,v.z),f.push(G,1-R),N.push(p++)}_.push(N)}for(let w=0;w<s;w++)for(let N=0;N<r;N++){let R=_[N][w],L=_[N+1][w],z=_[N+1][w+1],G=_[N][w+1];(t>0||N!==0)&&(u.push(R,L,G),E+=3),(e>0||N!==r-1)&&(u.push(L,z,G),E+=3)}c.addGroup(g,E,0),g+=E}function M(v){let A=p,E=new Qt,y=new V,w=0,N=v===!0?t:e,R=v===!0?1:-1;for(let z=1;z<=s;z++)h.push(0,m*R,0),d.push(0,R,0),f.push(.5,.5),p++;let L=p;for(let z=0;z<=s;z++){let F=z/s*l+a,U=Math.cos(F),D=Math.sin(F);y.x=N*D,y.y=m*R,y.z=N*U,h.push(y.x,y.y,y.z),d.push(0,R,0),E.x=U*.5+.5,E.y=D*.5*R+.5,f.push(E.x,E.y),p++}for(let z=0;z<s;z++){let G=A+z,F=L+z;v===!0?u.push(F,F+1,G):u.push(F+1,F,G),w+=3}c.addGroup(g,w,v===!0?1:2),g+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},qo=class n extends Ci{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Xh=class n extends Me{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new be(r,3)),this.setAttribute("normal",new be(r.slice(),3)),this.setAttribute("uv",new be(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let M=new V,v=new V,A=new V;for(let E=0;E<e.length;E+=3)f(e[E+0],M),f(e[E+1],v),f(e[E+2],A),l(M,v,A,x)}function l(x,M,v,A){let E=A+1,y=[];for(let w=0;w<=E;w++){y[w]=[];let N=x.clone().lerp(v,w/E),R=M.clone().lerp(v,w/E),L=E-w;for(let z=0;z<=L;z++)z===0&&w===E?y[w][z]=N:y[w][z]=N.clone().lerp(R,z/L)}for(let w=0;w<E;w++)for(let N=0;N<2*(E-w)-1;N++){let R=Math.floor(N/2);N%2===0?(d(y[w][R+1]),d(y[w+1][R]),d(y[w][R])):(d(y[w][R+1]),d(y[w+1][R+1]),d(y[w+1][R]))}}function c(x){let M=new V;for(let v=0;v<r.length;v+=3)M.x=r[v+0],M.y=r[v+1],M.z=r[v+2],M.normalize().multiplyScalar(x),r[v+0]=M.x,r[v+1]=M.y,r[v+2]=M.z}function u(){let x=new V;for(let M=0;M<r.length;M+=3){x.x=r[M+0],x.y=r[M+1],x.z=r[M+2];let v=m(x)/2/Math.PI+.5,A=g(x)/Math.PI+.5;o.push(v,1-A)}p(),h()}function h(){for(let x=0;x<o.length;x+=6){let M=o[x+0],v=o[x+2],A=o[x+4],E=Math.max(M,v,A),y=Math.min(M,v,A);E>.9&&y<.1&&(M<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,M){let v=x*3;M.x=t[v+0],M.y=t[v+1],M.z=t[v+2]}function p(){let x=new V,M=new V,v=new V,A=new V,E=new Qt,y=new Qt,w=new Qt;for(let N=0,R=0;N<r.length;N+=9,R+=6){x.set(r[N+0],r[N+1],r[N+2]),M.set(r[N+3],r[N+4],r[N+5]),v.set(r[N+6],r[N+7],r[N+8]),E.set(o[R+0],o[R+1]),y.set(o[R+2],o[R+3]),w.set(o[R+4],o[R+5]),A.copy(x).add(M).add(v).divideScalar(3);let L=m(A);_(E,R+0,x,L),_(y,R+2,M,L),_(w,R+4,v,L)}}function _(x,M,v,A){A<0&&x.x===1&&(o[M]=x.x-1),v.x===0&&v.z===0&&(o[M]=A/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Uc=class n extends Me{constructor(t=[new Qt(0,-.5),new Qt(.5,0),new Qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=Ae(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new V,d=new Qt,f=new V,p=new V,_=new V,m=0,g=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,_.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:_.normalize(),l.push(_.x,_.y,_.z);break;default:m=t[x+1].x-t[x].x,g=t[x+1].y-t[x].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=_.x,f.y+=_.y,f.z+=_.z,f.normalize(),l.push(f.x,f.y,f.z),_.copy(p)}for(let x=0;x<=e;x++){let M=i+x*u*s,v=Math.sin(M),A=Math.cos(M);for(let E=0;E<=t.length-1;E++){h.x=t[E].x*v,h.y=t[E].y,h.z=t[E].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=E/(t.length-1),a.push(d.x,d.y);let y=l[3*E+0]*v,w=l[3*E+1],N=l[3*E+0]*A;c.push(y,w,N)}}for(let x=0;x<e;x++)for(let M=0;M<t.length-1;M++){let v=M+x*t.length,A=v,E=v+t.length,y=v+t.length+1,w=v+1;r.push(A,E,w),r.push(y,w,E)}this.setIndex(r),this.setAttribute("position",new be(o,3)),this.setAttribute("uv",new be(a,2)),this.setAttribute("normal",new be(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Oc=class n extends Xh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Fc=class n extends Me{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],_=[],m=[];for(let g=0;g<u;g++){let x=g*d-o;for(let M=0;M<c;M++){let v=M*h-r;p.push(v,-x,0),_.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let M=x+c*g,v=x+c*(g+1),A=x+1+c*(g+1),E=x+1+c*g;f.push(M,v,E),f.push(v,A,E)}this.setIndex(f),this.setAttribute("position",new be(p,3)),this.setAttribute("normal",new be(_,3)),this.setAttribute("uv",new be(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ds=class n extends Me{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new V,d=new V,f=[],p=[],_=[],m=[];for(let g=0;g<=i;g++){let x=[],M=g/i,v=o+M*a,A=t*Math.cos(v),E=Math.sqrt(t*t-A*A),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let w=0;w<=e;w++){let N=w/e,R=s+N*r;h.x=-E*Math.cos(R),h.y=A,h.z=E*Math.sin(R),p.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),m.push(N+y,1-M),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let M=u[g][x+1],v=u[g][x],A=u[g+1][x],E=u[g+1][x+1];(g!==0||o>0)&&f.push(M,v,E),(g!==i-1||l<Math.PI)&&f.push(v,A,E)}this.setIndex(f),this.setAttribute("position",new be(p,3)),this.setAttribute("normal",new be(_,3)),this.setAttribute("uv",new be(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var el=class n extends Me{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new V,f=new V,p=new V;for(let _=0;_<=i;_++){let m=o+_/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(x),f.y=(t+e*Math.cos(m))*Math.sin(x),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),p.subVectors(f,d).normalize(),u.push(p.x,p.y,p.z),h.push(g/s),h.push(_/i)}}for(let _=1;_<=i;_++)for(let m=1;m<=s;m++){let g=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,M=(s+1)*(_-1)+m,v=(s+1)*_+m;l.push(g,x,v),l.push(x,M,v)}this.setIndex(l),this.setAttribute("position",new be(c,3)),this.setAttribute("normal",new be(u,3)),this.setAttribute("uv",new be(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Jo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(ly(s))s.isRenderTargetTexture?(ie("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(ly(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function gi(n){let t={};for(let e=0;e<n.length;e++){let i=Jo(n[e]);for(let s in i)t[s]=i[s]}return t}function ly(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function fT(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function mg(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:De.workingColorSpace}var Ky={clone:Jo,merge:gi},pT=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,mT=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,pi=class extends Ir{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=pT,this.fragmentShader=mT,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Jo(t.uniforms),this.uniformsGroups=fT(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new V().fromArray(s.value);break;case"v4":this.uniforms[i].value=new bn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new de().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ye().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Yh=class extends pi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var jh=class extends Ir{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ky,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Zh=class extends Ir{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ga(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Th(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var uo=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Jh=class extends uo{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Cm,endingEnd:Cm}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Pm:r=t,a=2*e-i;break;case Im:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Pm:o=t,l=2*i-e;break;case Im:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),_=p*p,m=_*p,g=-d*m+2*d*_-d*p,x=(1+d)*m+(-1.5-2*d)*_+(-.5+d)*p+1,M=(-1-f)*m+(1.5+f)*_+.5*p,v=f*m-f*_;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[c+A]+M*o[l+A]+v*o[h+A];return r}},Kh=class extends uo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Qh=class extends uo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},td=class extends uo{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*d+p*2,x=h[g],M=h[g+1],v=t*d+p*2,A=u[v],E=u[v+1],y=xT(i,e,x,A,s);r[p]=Qy(y,_,M,E,m)}return r}};function Qy(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function gT(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function xT(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Qy(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=gT(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ns=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ga(e,this.TimeBufferType),this.values=Ga(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ga(t.times,Array),values:Ga(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Th(t.settings)&&(i.settings={inTangents:Ga(t.settings.inTangents,Array),outTangents:Ga(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Qh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Kh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Jh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new td(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case _c:e=this.InterpolantFactoryMethodDiscrete;break;case zh:e=this.InterpolantFactoryMethodLinear;break;case Ch:e=this.InterpolantFactoryMethodSmooth;break;case Rm:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ie("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return _c;case this.InterpolantFactoryMethodLinear:return zh;case this.InterpolantFactoryMethodSmooth:return Ch;case this.InterpolantFactoryMethodBezier:return Rm}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Th(this.settings)&&(cy(this.settings.inTangents,t),cy(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Th(this.settings)&&(uy(this.settings.inTangents,t),uy(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ce("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ce("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ce("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ce("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&LE(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ce("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Ch,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let _=e[h+p];if(_!==e[d+p]||_!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Th(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function cy(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function uy(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ns.prototype.ValueTypeName="";ns.prototype.TimeBufferType=Float32Array;ns.prototype.ValueBufferType=Float32Array;ns.prototype.DefaultInterpolation=zh;var ho=class extends ns{constructor(t,e,i){super(t,e,i)}};ho.prototype.ValueTypeName="bool";ho.prototype.ValueBufferType=Array;ho.prototype.DefaultInterpolation=_c;ho.prototype.InterpolantFactoryMethodLinear=void 0;ho.prototype.InterpolantFactoryMethodSmooth=void 0;var ed=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};ed.prototype.ValueTypeName="color";var nd=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};nd.prototype.ValueTypeName="number";var id=class extends uo{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)fn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Bc=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new id(this.times,this.values,this.getValueSize(),t)}};Bc.prototype.ValueTypeName="quaternion";Bc.prototype.InterpolantFactoryMethodSmooth=void 0;var fo=class extends ns{constructor(t,e,i){super(t,e,i)}};fo.prototype.ValueTypeName="string";fo.prototype.ValueBufferType=Array;fo.prototype.DefaultInterpolation=_c;fo.prototype.InterpolantFactoryMethodLinear=void 0;fo.prototype.InterpolantFactoryMethodSmooth=void 0;var sd=class extends ns{constructor(t,e,i,s){super(t,e,i,s)}};sd.prototype.ValueTypeName="vector";var rd=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},tv=new rd,od=class{constructor(t){this.manager=t!==void 0?t:tv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};od.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ah=new V,Rh=new fn,er=new V,kc=class extends ki{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ye,this.projectionMatrix=new ye,this.projectionMatrixInverse=new ye,this.coordinateSystem=fs,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Ah,Rh,er),er.x===1&&er.y===1&&er.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ah,Rh,er.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Ah,Rh,er),er.x===1&&er.y===1&&er.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ah,Rh,er.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ao=new V,hy=new Qt,dy=new Qt,Ai=class extends kc{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ya*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(gc*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ya*2*Math.atan(Math.tan(gc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ao.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ao.x,ao.y).multiplyScalar(-t/ao.z),ao.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ao.x,ao.y).multiplyScalar(-t/ao.z)}getViewSize(t,e){return this.getViewBounds(t,hy,dy),e.subVectors(dy,hy)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(gc*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ad=class extends kc{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Va=-90,Wa=1,nl=class extends ki{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ai(Va,Wa,t,e);s.layers=this.layers,this.add(s);let r=new Ai(Va,Wa,t,e);r.layers=this.layers,this.add(r);let o=new Ai(Va,Wa,t,e);o.layers=this.layers,this.add(o);let a=new Ai(Va,Wa,t,e);a.layers=this.layers,this.add(a);let l=new Ai(Va,Wa,t,e);l.layers=this.layers,this.add(l);let c=new Ai(Va,Wa,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===fs)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===bc)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},ld=class extends Ai{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var gg="\\[\\]\\.:\\/",_T=new RegExp("["+gg+"]","g"),xg="[^"+gg+"]",yT="[^"+gg.replace("\\.","")+"]",vT=/((?:WC+[\/:])*)/.source.replace("WC",xg),bT=/(WCOD+)?/.source.replace("WCOD",yT),MT=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xg),ST=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xg),wT=new RegExp("^"+vT+bT+MT+ST+"$"),ET=["material","materials","bones","map"],Dm=class{constructor(t,e,i){let s=i||dn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},dn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(_T,"")}static parseTrackName(t){let e=wT.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);ET.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ie("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ce("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ce("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ce("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ce("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ce("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ce("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ce("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ce("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};dn.Composite=Dm;dn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};dn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};dn.prototype.GetterByBindingType=[dn.prototype._getValue_direct,dn.prototype._getValue_array,dn.prototype._getValue_arrayElement,dn.prototype._getValue_toArray];dn.prototype.SetterByBindingTypeAndVersioning=[[dn.prototype._setValue_direct,dn.prototype._setValue_direct_setNeedsUpdate,dn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_array,dn.prototype._setValue_array_setNeedsUpdate,dn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_arrayElement,dn.prototype._setValue_arrayElement_setNeedsUpdate,dn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[dn.prototype._setValue_fromArray,dn.prototype._setValue_fromArray_setNeedsUpdate,dn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var _U=new Float32Array(1);var fy=new ye,zc=class{constructor(t,e,i=0,s=1/0){this.ray=new Lr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Za,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ce("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return fy.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(fy),this}intersectObject(t,e=!0,i=[]){return Nm(t,this,i,e),i.sort(py),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Nm(t[s],this,i,e);return i.sort(py),i}};function py(n,t){return n.distance-t.distance}function Nm(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Nm(r[o],t,e,!0)}}var il=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Ae(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Ae(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Um=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Hc=class extends Ls{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function _g(n,t,e,i){let s=TT(i);switch(e){case eg:return n*t;case md:return n*t/s.components*s.byteLength;case gd:return n*t/s.components*s.byteLength;case go:return n*t*2/s.components*s.byteLength;case xd:return n*t*2/s.components*s.byteLength;case ng:return n*t*3/s.components*s.byteLength;case Os:return n*t*4/s.components*s.byteLength;case _d:return n*t*4/s.components*s.byteLength;case Wc:case $c:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case qc:case Xc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vd:case Md:return Math.max(n,16)*Math.max(t,8)/4;case yd:case bd:return Math.max(n,8)*Math.max(t,8)/2;case Sd:case wd:case Td:case Ad:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ed:case Yc:case Rd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Cd:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Pd:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Id:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Ld:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Dd:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Nd:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ud:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Od:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Fd:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Bd:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case kd:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case zd:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Hd:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Gd:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Vd:case Wd:case $d:return Math.ceil(n/4)*Math.ceil(t/4)*16;case qd:case Xd:return Math.ceil(n/4)*Math.ceil(t/4)*8;case jc:case Yd:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function TT(n){switch(n){case is:case Jm:return{byteLength:1,components:1};case al:case Km:case Us:return{byteLength:2,components:1};case fd:case pd:return{byteLength:2,components:4};case Ns:case dd:case ps:return{byteLength:4,components:1};case Qm:case tg:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ie("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Mv(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function IT(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],_=h[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let _=h[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var LT=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,DT=`#ifdef USE_ALPHAHASH
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
#endif`,NT=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,UT=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,OT=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,FT=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,BT=`#ifdef USE_AOMAP
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
#endif`,kT=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,zT=`#ifdef USE_BATCHING
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
#endif`,HT=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,GT=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VT=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,WT=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,$T=`#ifdef USE_IRIDESCENCE
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
#endif`,qT=`#ifdef USE_BUMPMAP
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
#endif`,XT=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,YT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,JT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,KT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,QT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,tA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,eA=`#define PI 3.141592653589793
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
} // validated`,nA=`vec3 transformedNormal = objectNormal;
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
#endif`,iA=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sA=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rA=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,oA=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,aA="gl_FragColor = linearToOutputTexel( gl_FragColor );",lA=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cA=`#ifdef USE_ENVMAP
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
#endif`,uA=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,hA=`#ifdef USE_ENVMAP
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
#endif`,dA=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fA=`#ifdef USE_ENVMAP
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
#endif`,pA=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,mA=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,gA=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,xA=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_A=`#ifdef USE_GRADIENTMAP
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
}`,yA=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vA=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,bA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,MA=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,SA=`#ifdef USE_ENVMAP
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
#endif`,wA=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,EA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,TA=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,AA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,RA=`PhysicalMaterial material;
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
#endif`,CA=`uniform sampler2D dfgLUT;
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
}`,PA=`
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
#endif`,IA=`#if defined( RE_IndirectDiffuse )
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
#endif`,LA=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,DA=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,NA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,UA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,OA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,FA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,BA=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,kA=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,zA=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,HA=`#if defined( USE_POINTS_UV )
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
#endif`,GA=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,VA=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,WA=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$A=`#if defined( USE_MORPHCOLORS )
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
#endif`,qA=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,XA=`#ifdef USE_MORPHTARGETS
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
#endif`,YA=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jA=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ZA=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,JA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,KA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,QA=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,tR=`#ifdef USE_NORMALMAP
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
#endif`,eR=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,nR=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,iR=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sR=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,rR=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,oR=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,aR=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,lR=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,cR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,uR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,dR=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,pR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,mR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,gR=`float getShadowMask() {
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
}`,xR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_R=`#ifdef USE_SKINNING
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
#endif`,yR=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vR=`#ifdef USE_SKINNING
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
#endif`,bR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,MR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,SR=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,wR=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ER=`#ifdef USE_TRANSMISSION
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
#endif`,TR=`#ifdef USE_TRANSMISSION
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
#endif`,AR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,RR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,PR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,IR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,LR=`uniform sampler2D t2D;
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
}`,DR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NR=`uniform float backgroundBlurriness;
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
}`,UR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OR=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FR=`#include <common>
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
}`,BR=`#if DEPTH_PACKING == 3200
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
}`,kR=`#define DISTANCE
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
}`,zR=`#define DISTANCE
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
}`,HR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VR=`uniform float scale;
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
}`,WR=`uniform vec3 diffuse;
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
}`,$R=`#include <common>
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
}`,qR=`uniform vec3 diffuse;
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
}`,XR=`#define LAMBERT
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
}`,YR=`#define LAMBERT
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
}`,jR=`#define MATCAP
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
}`,ZR=`#define MATCAP
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
}`,JR=`#define NORMAL
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
}`,KR=`#define NORMAL
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
}`,QR=`#define PHONG
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
}`,tC=`#define PHONG
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
}`,eC=`#define STANDARD
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
}`,nC=`#define STANDARD
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
}`,iC=`#define TOON
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
}`,sC=`#define TOON
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
}`,rC=`uniform float size;
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
}`,oC=`uniform vec3 diffuse;
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
}`,aC=`#include <common>
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
}`,lC=`uniform vec3 color;
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
}`,cC=`uniform float rotation;
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
}`,uC=`uniform vec3 diffuse;
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
}`,Ee={alphahash_fragment:LT,alphahash_pars_fragment:DT,alphamap_fragment:NT,alphamap_pars_fragment:UT,alphatest_fragment:OT,alphatest_pars_fragment:FT,aomap_fragment:BT,aomap_pars_fragment:kT,batching_pars_vertex:zT,batching_vertex:HT,begin_vertex:GT,beginnormal_vertex:VT,bsdfs:WT,iridescence_fragment:$T,bumpmap_pars_fragment:qT,clipping_planes_fragment:XT,clipping_planes_pars_fragment:YT,clipping_planes_pars_vertex:jT,clipping_planes_vertex:ZT,color_fragment:JT,color_pars_fragment:KT,color_pars_vertex:QT,color_vertex:tA,common:eA,defaultnormal_vertex:nA,displacementmap_pars_vertex:iA,displacementmap_vertex:sA,emissivemap_fragment:rA,emissivemap_pars_fragment:oA,colorspace_fragment:aA,colorspace_pars_fragment:lA,envmap_fragment:cA,envmap_common_pars_fragment:uA,envmap_pars_fragment:hA,envmap_pars_vertex:dA,envmap_physical_pars_fragment:SA,envmap_vertex:fA,fog_vertex:pA,fog_pars_vertex:mA,fog_fragment:gA,fog_pars_fragment:xA,gradientmap_pars_fragment:_A,lightmap_pars_fragment:yA,lights_lambert_fragment:vA,lights_lambert_pars_fragment:bA,lights_pars_begin:MA,lights_toon_fragment:wA,lights_toon_pars_fragment:EA,lights_phong_fragment:TA,lights_phong_pars_fragment:AA,lights_physical_fragment:RA,lights_physical_pars_fragment:CA,lights_fragment_begin:PA,lights_fragment_maps:IA,lights_fragment_end:LA,lightprobes_pars_fragment:DA,logdepthbuf_fragment:NA,logdepthbuf_pars_fragment:UA,logdepthbuf_pars_vertex:OA,logdepthbuf_vertex:FA,map_fragment:BA,map_pars_fragment:kA,map_particle_fragment:zA,map_particle_pars_fragment:HA,metalnessmap_fragment:GA,metalnessmap_pars_fragment:VA,morphinstance_vertex:WA,morphcolor_vertex:$A,morphnormal_vertex:qA,morphtarget_pars_vertex:XA,morphtarget_vertex:YA,normal_fragment_begin:jA,normal_fragment_maps:ZA,normal_pars_fragment:JA,normal_pars_vertex:KA,normal_vertex:QA,normalmap_pars_fragment:tR,clearcoat_normal_fragment_begin:eR,clearcoat_normal_fragment_maps:nR,clearcoat_pars_fragment:iR,iridescence_pars_fragment:sR,opaque_fragment:rR,packing:oR,premultiplied_alpha_fragment:aR,project_vertex:lR,dithering_fragment:cR,dithering_pars_fragment:uR,roughnessmap_fragment:hR,roughnessmap_pars_fragment:dR,shadowmap_pars_fragment:fR,shadowmap_pars_vertex:pR,shadowmap_vertex:mR,shadowmask_pars_fragment:gR,skinbase_vertex:xR,skinning_pars_vertex:_R,skinning_vertex:yR,skinnormal_vertex:vR,specularmap_fragment:bR,specularmap_pars_fragment:MR,tonemapping_fragment:SR,tonemapping_pars_fragment:wR,transmission_fragment:ER,transmission_pars_fragment:TR,uv_pars_fragment:AR,uv_pars_vertex:RR,uv_vertex:CR,worldpos_vertex:PR,background_vert:IR,background_frag:LR,backgroundCube_vert:DR,backgroundCube_frag:NR,cube_vert:UR,cube_frag:OR,depth_vert:FR,depth_frag:BR,distance_vert:kR,distance_frag:zR,equirect_vert:HR,equirect_frag:GR,linedashed_vert:VR,linedashed_frag:WR,meshbasic_vert:$R,meshbasic_frag:qR,meshlambert_vert:XR,meshlambert_frag:YR,meshmatcap_vert:jR,meshmatcap_frag:ZR,meshnormal_vert:JR,meshnormal_frag:KR,meshphong_vert:QR,meshphong_frag:tC,meshphysical_vert:eC,meshphysical_frag:nC,meshtoon_vert:iC,meshtoon_frag:sC,points_vert:rC,points_frag:oC,shadow_vert:aC,shadow_frag:lC,sprite_vert:cC,sprite_frag:uC},kt={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new de},alphaMap:{value:null},alphaMapTransform:{value:new de},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new de}},envmap:{envMap:{value:null},envMapRotation:{value:new de},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new de}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new de}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new de},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new de},normalScale:{value:new Qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new de},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new de}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new de}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new de}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new de},alphaTest:{value:0},uvTransform:{value:new de}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new Qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new de},alphaMap:{value:null},alphaMapTransform:{value:new de},alphaTest:{value:0}}},cr={basic:{uniforms:gi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.fog]),vertexShader:Ee.meshbasic_vert,fragmentShader:Ee.meshbasic_frag},lambert:{uniforms:gi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:Ee.meshlambert_vert,fragmentShader:Ee.meshlambert_frag},phong:{uniforms:gi([kt.common,kt.specularmap,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ee.meshphong_vert,fragmentShader:Ee.meshphong_frag},standard:{uniforms:gi([kt.common,kt.envmap,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.roughnessmap,kt.metalnessmap,kt.fog,kt.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ee.meshphysical_vert,fragmentShader:Ee.meshphysical_frag},toon:{uniforms:gi([kt.common,kt.aomap,kt.lightmap,kt.emissivemap,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.gradientmap,kt.fog,kt.lights,{emissive:{value:new ee(0)}}]),vertexShader:Ee.meshtoon_vert,fragmentShader:Ee.meshtoon_frag},matcap:{uniforms:gi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,kt.fog,{matcap:{value:null}}]),vertexShader:Ee.meshmatcap_vert,fragmentShader:Ee.meshmatcap_frag},points:{uniforms:gi([kt.points,kt.fog]),vertexShader:Ee.points_vert,fragmentShader:Ee.points_frag},dashed:{uniforms:gi([kt.common,kt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ee.linedashed_vert,fragmentShader:Ee.linedashed_frag},depth:{uniforms:gi([kt.common,kt.displacementmap]),vertexShader:Ee.depth_vert,fragmentShader:Ee.depth_frag},normal:{uniforms:gi([kt.common,kt.bumpmap,kt.normalmap,kt.displacementmap,{opacity:{value:1}}]),vertexShader:Ee.meshnormal_vert,fragmentShader:Ee.meshnormal_frag},sprite:{uniforms:gi([kt.sprite,kt.fog]),vertexShader:Ee.sprite_vert,fragmentShader:Ee.sprite_frag},background:{uniforms:{uvTransform:{value:new de},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ee.background_vert,fragmentShader:Ee.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new de}},vertexShader:Ee.backgroundCube_vert,fragmentShader:Ee.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ee.cube_vert,fragmentShader:Ee.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ee.equirect_vert,fragmentShader:Ee.equirect_frag},distance:{uniforms:gi([kt.common,kt.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ee.distance_vert,fragmentShader:Ee.distance_frag},shadow:{uniforms:gi([kt.lights,kt.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:Ee.shadow_vert,fragmentShader:Ee.shadow_frag}};cr.physical={uniforms:gi([cr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new de},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new de},clearcoatNormalScale:{value:new Qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new de},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new de},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new de},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new de},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new de},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new de},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new de},transmissionSamplerSize:{value:new Qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new de},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new de},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new de},anisotropyVector:{value:new Qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new de}}]),vertexShader:Ee.meshphysical_vert,fragmentShader:Ee.meshphysical_frag};var Jd={r:0,b:0,g:0},hC=new ye,Sv=new de;Sv.set(-1,0,0,0,1,0,0,0,1);function dC(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let v=x.backgroundBlurriness>0;M=t.get(M,v)}return M}function p(x){let M=!1,v=f(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),M=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,M){let v=f(M);v&&v.isCubeTexture?(c===void 0&&(c=new Ge(new Hi(1,1,1),new pi({name:"BackgroundCubeMaterial",uniforms:Jo(cr.backgroundCube.uniforms),vertexShader:cr.backgroundCube.vertexShader,fragmentShader:cr.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(hC.makeRotationFromEuler(M.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Sv),c.material.toneMapped=De.getTransfer(v.colorSpace)!==$e,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ge(new Fc(2,2),new pi({name:"BackgroundMaterial",uniforms:Jo(cr.background.uniforms),vertexShader:cr.background.vertexShader,fragmentShader:cr.background.fragmentShader,side:or,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=De.getTransfer(v.colorSpace)!==$e,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,M){x.getRGB(Jd,mg(n)),e.buffers.color.setClear(Jd.r,Jd.g,Jd.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function fC(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(L,z,G,F,U){let D=!1,O=h(L,F,G,z);r!==O&&(r=O,c(r.object)),D=f(L,F,G,U),D&&p(L,F,G,U),U!==null&&t.update(U,n.ELEMENT_ARRAY_BUFFER),(D||o)&&(o=!1,v(L,z,G,F),U!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(U).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,z,G,F){let U=F.wireframe===!0,D=i[z.id];D===void 0&&(D={},i[z.id]=D);let O=L.isInstancedMesh===!0?L.id:0,Z=D[O];Z===void 0&&(Z={},D[O]=Z);let X=Z[G.id];X===void 0&&(X={},Z[G.id]=X);let J=X[U];return J===void 0&&(J=d(l()),X[U]=J),J}function d(L){let z=[],G=[],F=[];for(let U=0;U<e;U++)z[U]=0,G[U]=0,F[U]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:G,attributeDivisors:F,object:L,attributes:{},index:null}}function f(L,z,G,F){let U=r.attributes,D=z.attributes,O=0,Z=G.getAttributes();for(let X in Z)if(Z[X].location>=0){let nt=U[X],dt=D[X];if(dt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(dt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(dt=L.instanceColor)),nt===void 0||nt.attribute!==dt||dt&&nt.data!==dt.data)return!0;O++}return r.attributesNum!==O||r.index!==F}function p(L,z,G,F){let U={},D=z.attributes,O=0,Z=G.getAttributes();for(let X in Z)if(Z[X].location>=0){let nt=D[X];nt===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(nt=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(nt=L.instanceColor));let dt={};dt.attribute=nt,nt&&nt.data&&(dt.data=nt.data),U[X]=dt,O++}r.attributes=U,r.attributesNum=O,r.index=F}function _(){let L=r.newAttributes;for(let z=0,G=L.length;z<G;z++)L[z]=0}function m(L){g(L,0)}function g(L,z){let G=r.newAttributes,F=r.enabledAttributes,U=r.attributeDivisors;G[L]=1,F[L]===0&&(n.enableVertexAttribArray(L),F[L]=1),U[L]!==z&&(n.vertexAttribDivisor(L,z),U[L]=z)}function x(){let L=r.newAttributes,z=r.enabledAttributes;for(let G=0,F=z.length;G<F;G++)z[G]!==L[G]&&(n.disableVertexAttribArray(G),z[G]=0)}function M(L,z,G,F,U,D,O){O===!0?n.vertexAttribIPointer(L,z,G,U,D):n.vertexAttribPointer(L,z,G,F,U,D)}function v(L,z,G,F){_();let U=F.attributes,D=G.getAttributes(),O=z.defaultAttributeValues;for(let Z in D){let X=D[Z];if(X.location>=0){let J=U[Z];if(J===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(J=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(J=L.instanceColor)),J!==void 0){let nt=J.normalized,dt=J.itemSize,ft=t.get(J);if(ft===void 0)continue;let st=ft.buffer,yt=ft.type,xt=ft.bytesPerElement,Tt=yt===n.INT||yt===n.UNSIGNED_INT||J.gpuType===dd;if(J.isInterleavedBufferAttribute){let At=J.data,Jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,xe=J.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let jt=0;jt<X.locationSize;jt++)g(X.location+jt,At.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let jt=0;jt<X.locationSize;jt++)m(X.location+jt);n.bindBuffer(n.ARRAY_BUFFER,st);for(let jt=0;jt<X.locationSize;jt++)M(X.location+jt,dt/X.locationSize,yt,nt,Jt*xt,(xe+dt/X.locationSize*jt)*xt,Tt)}else{if(J.isInstancedBufferAttribute){for(let At=0;At<X.locationSize;At++)g(X.location+At,J.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let At=0;At<X.locationSize;At++)m(X.location+At);n.bindBuffer(n.ARRAY_BUFFER,st);for(let At=0;At<X.locationSize;At++)M(X.location+At,dt/X.locationSize,yt,nt,dt*xt,dt/X.locationSize*At*xt,Tt)}}else if(O!==void 0){let nt=O[Z];if(nt!==void 0)switch(nt.length){case 2:n.vertexAttrib2fv(X.location,nt);break;case 3:n.vertexAttrib3fv(X.location,nt);break;case 4:n.vertexAttrib4fv(X.location,nt);break;default:n.vertexAttrib1fv(X.location,nt)}}}}x()}function A(){N();for(let L in i){let z=i[L];for(let G in z){let F=z[G];for(let U in F){let D=F[U];for(let O in D)u(D[O].object),delete D[O];delete F[U]}}delete i[L]}}function E(L){if(i[L.id]===void 0)return;let z=i[L.id];for(let G in z){let F=z[G];for(let U in F){let D=F[U];for(let O in D)u(D[O].object),delete D[O];delete F[U]}}delete i[L.id]}function y(L){for(let z in i){let G=i[z];for(let F in G){let U=G[F];if(U[L.id]===void 0)continue;let D=U[L.id];for(let O in D)u(D[O].object),delete D[O];delete U[L.id]}}}function w(L){for(let z in i){let G=i[z],F=L.isInstancedMesh===!0?L.id:0,U=G[F];if(U!==void 0){for(let D in U){let O=U[D];for(let Z in O)u(O[Z].object),delete O[Z];delete U[D]}delete G[F],Object.keys(G).length===0&&delete i[z]}}}function N(){R(),o=!0,r!==s&&(r=s,c(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:R,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function pC(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function mC(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Os&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===Us&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==is&&y!==ps&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(ie("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&ie("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&ie("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:v,maxSamples:A,samples:E}}function gC(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ri,a=new de,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,_=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,M=x*4,v=g.clippingState||null;l.value=v,v=u(p,d,M,f);for(let A=0;A!==M;++A)v[A]=e[A];g.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let _=h!==null?h.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,v=f;M!==_;++M,v+=4)o.copy(h[M]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Kc=class extends ts{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Ic(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Hi(5,5,5),r=new pi({name:"CubemapFromEquirect",uniforms:Jo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:Xo});r.uniforms.tEquirect.value=e;let o=new Ge(s,r),a=e.minFilter;return e.minFilter===Ur&&(e.minFilter=Ri),new nl(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},ev=256,xC=3,_C=20,wv=256,Ev=16,yC=3,vC=new V,bC=new ee,Qd=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new nl(1,10,null),this._boxMesh=new Ge(new Hi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=vC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(bC));let m=new nl(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=sv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=iv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(ev,dg(t))}_fromTexture(t,e){t.mapping===jo||t.mapping===ol?this._setSize(t.image.length===0?ev:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=nv(t,!1,!1),i=Math.log2(t)-xC;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=nv(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===jo||t.mapping===ol?(this._cubemapMaterial===null&&(this._cubemapMaterial=sv()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=iv()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=MC(),this._integrationMaterial=SC());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Ev);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-yC)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(wv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=wC());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function nv(n,t,e){return new Kc(n,{minFilter:Ur,generateMipmaps:t,type:Us,colorSpace:yc,depthBuffer:e})}function Qc(n,t,e){return new pi({name:n,uniforms:t,vertexShader:Ee.cube_vert,fragmentShader:e,side:oi,blending:Xo,depthTest:!1,depthWrite:!1})}function MC(){return Qc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${wv}u

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
	`)}function SC(){return Qc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ev}},`

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
	`)}function wC(){return Qc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_C}
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
	`)}function iv(){return Qc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function sv(){return Qc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function EC(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===cd||f===ud)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new Kc(p.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===cd||f===ud,_=f===jo||f===ol;if(p||_){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Qd(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new Qd(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===cd?d.mapping=jo:f===ud&&(d.mapping=ol),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function TC(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&mc("WebGLRenderer: "+i+" extension not supported."),s}}}function AC(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(p){let _=p.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function h(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,M=m.count>=65535?Rc:Ac,v=new M(Math.ceil(x/3)*6,1),A=v.array;if(_!==null){let y=_.array;g=_.version;for(let w=0,N=0;w<x;w+=3){let R=y[w+0],L=y[w+1],z=y[w+2];A[N++]=R,A[N++]=L,A[N++]=L,A[N++]=z,A[N++]=z,A[N++]=R}}else{g=m.version;for(let y=0,w=0;y<x;y+=3){let N=y+0,R=y+1,L=y+2;A[w++]=N,A[w++]=R,A[w++]=R,A[w++]=L,A[w++]=L,A[w++]=N}}v.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,v)}function d(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function RC(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let m=0;m<f;m++)_+=d[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function CC(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ce("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function PC(n,t,e){let i=new WeakMap,s=new bn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let N=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),_===!0&&(M=3);let v=a.attributes.position.count*M,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let E=new Float32Array(v*A*4*h),y=new wc(E,v,A,h);y.type=ps,y.needsUpdate=!0;let w=M*4;for(let R=0;R<h;R++){let L=m[R],z=g[R],G=x[R],F=v*A*4*R;for(let U=0;U<L.count;U++){let D=U*w;f===!0&&(s.fromBufferAttribute(L,U),E[F+D+0]=s.x,E[F+D+1]=s.y,E[F+D+2]=s.z,E[F+D+3]=0),p===!0&&(s.fromBufferAttribute(z,U),E[F+D+4]=s.x,E[F+D+5]=s.y,E[F+D+6]=s.z,E[F+D+7]=0),_===!0&&(s.fromBufferAttribute(G,U),E[F+D+8]=s.x,E[F+D+9]=s.y,E[F+D+10]=s.z,E[F+D+11]=G.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Qt(v,A)},i.set(a,d),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function IC(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var LC={[Vm]:"LINEAR_TONE_MAPPING",[Wm]:"REINHARD_TONE_MAPPING",[$m]:"CINEON_TONE_MAPPING",[qm]:"ACES_FILMIC_TONE_MAPPING",[Ym]:"AGX_TONE_MAPPING",[jm]:"NEUTRAL_TONE_MAPPING",[Xm]:"CUSTOM_TONE_MAPPING"};function DC(n,t,e,i,s,r){let o=new ts(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Me;u.setAttribute("position",new be([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new be([0,2,0,0,2,0],2));let h=new Yh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ge(u,h),f=new ad(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,M=[],v=!1;this.setSize=function(A,E){o.setSize(A,E),a!==null&&a.setSize(A,E),l!==null&&l.setSize(A,E);for(let y=0;y<M.length;y++){let w=M[y];w.setSize&&w.setSize(A,E)}},this.setEffects=function(A){M=A,v=M.length>0&&M[0].isRenderPass===!0;let E=o.width,y=o.height;M.length>0&&a===null&&(a=new ts(E,y,{type:Us,depthBuffer:!1,stencilBuffer:!1}),l=new ts(E,y,{type:Us,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(N=>N.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Nr(E,y),r===!0&&(c.format=Or,c.type=Zo)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let N=0;N<M.length;N++){let R=M[N];R.setSize&&R.setSize(E,y),w&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(A,E){if(m||A.toneMapping===ar&&M.length===0)return!1;if(x=E,E!==null){let y=E.width,w=E.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return v===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=ar,!0},this.hasRenderPass=function(){return v},this.end=function(A,E){A.toneMapping=g,m=!0;let y=o,w=a;for(let N=0;N<M.length;N++){let R=M[N];R.enabled!==!1&&(R.render(A,w,y,E),R.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(p!==A.outputColorSpace||_!==A.toneMapping){p=A.outputColorSpace,_=A.toneMapping,h.defines={},De.getTransfer(p)===$e&&(h.defines.SRGB_TRANSFER="");let N=LC[_];N&&(h.defines[N]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Tv=new Bi,Av=new Nr(1,1),Rv=new Lc(1),Cv=new wc,Pv=new Vh,Iv=new Ic,rv=[],ov=[],av=new Float32Array(16),lv=new Float32Array(9),cv=new Float32Array(4);function cl(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=rv[s];if(r===void 0&&(r=new Float32Array(s),rv[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Wn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function $n(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function ef(n,t){let e=ov[t];e===void 0&&(e=new Int32Array(t),ov[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function NC(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function UC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2fv(this.addr,t),$n(e,t)}}function OC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Wn(e,t))return;n.uniform3fv(this.addr,t),$n(e,t)}}function FC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4fv(this.addr,t),$n(e,t)}}function BC(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;cv.set(i),n.uniformMatrix2fv(this.addr,!1,cv),$n(e,i)}}function kC(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;lv.set(i),n.uniformMatrix3fv(this.addr,!1,lv),$n(e,i)}}function zC(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Wn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),$n(e,t)}else{if(Wn(e,i))return;av.set(i),n.uniformMatrix4fv(this.addr,!1,av),$n(e,i)}}function HC(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function GC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2iv(this.addr,t),$n(e,t)}}function VC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Wn(e,t))return;n.uniform3iv(this.addr,t),$n(e,t)}}function WC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4iv(this.addr,t),$n(e,t)}}function $C(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function qC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Wn(e,t))return;n.uniform2uiv(this.addr,t),$n(e,t)}}function XC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Wn(e,t))return;n.uniform3uiv(this.addr,t),$n(e,t)}}function YC(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Wn(e,t))return;n.uniform4uiv(this.addr,t),$n(e,t)}}function nf(n){return n.version===0&&(n.compareFunction=lg,n.needsUpdate=!0),n}function jC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=nf(Av):r=Tv,e.setTexture2D(t||r,s)}function ZC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Pv,s)}function JC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=nf(Rv):r=Iv,e.setTextureCube(t||r,s)}function KC(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Cv,s)}function QC(n){switch(n){case 5126:return NC;case 35664:return UC;case 35665:return OC;case 35666:return FC;case 35674:return BC;case 35675:return kC;case 35676:return zC;case 5124:case 35670:return HC;case 35667:case 35671:return GC;case 35668:case 35672:return VC;case 35669:case 35673:return WC;case 5125:return $C;case 36294:return qC;case 36295:return XC;case 36296:return YC;case 35678:case 36198:case 36298:case 36306:case 35682:return jC;case 35679:case 36299:case 36307:return ZC;case 35680:case 36300:case 36308:case 36293:return JC;case 36289:case 36303:case 36311:case 36292:return KC}}function tP(n,t){n.uniform1fv(this.addr,t)}function eP(n,t){let e=cl(t,this.size,2);n.uniform2fv(this.addr,e)}function nP(n,t){let e=cl(t,this.size,3);n.uniform3fv(this.addr,e)}function iP(n,t){let e=cl(t,this.size,4);n.uniform4fv(this.addr,e)}function sP(n,t){let e=cl(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function rP(n,t){let e=cl(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function oP(n,t){let e=cl(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function aP(n,t){n.uniform1iv(this.addr,t)}function lP(n,t){n.uniform2iv(this.addr,t)}function cP(n,t){n.uniform3iv(this.addr,t)}function uP(n,t){n.uniform4iv(this.addr,t)}function hP(n,t){n.uniform1uiv(this.addr,t)}function dP(n,t){n.uniform2uiv(this.addr,t)}function fP(n,t){n.uniform3uiv(this.addr,t)}function pP(n,t){n.uniform4uiv(this.addr,t)}function mP(n,t,e){let i=this.cache,s=t.length,r=ef(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=nf(Av):o=Tv;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function gP(n,t,e){let i=this.cache,s=t.length,r=ef(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Pv,r[o])}function xP(n,t,e){let i=this.cache,s=t.length,r=ef(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=nf(Rv):o=Iv;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function _P(n,t,e){let i=this.cache,s=t.length,r=ef(e,s);Wn(i,r)||(n.uniform1iv(this.addr,r),$n(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Cv,r[o])}function yP(n){switch(n){case 5126:return tP;case 35664:return eP;case 35665:return nP;case 35666:return iP;case 35674:return sP;case 35675:return rP;case 35676:return oP;case 5124:case 35670:return aP;case 35667:case 35671:return lP;case 35668:case 35672:return cP;case 35669:case 35673:return uP;case 5125:return hP;case 36294:return dP;case 36295:return fP;case 36296:return pP;case 35678:case 36198:case 36298:case 36306:case 35682:return mP;case 35679:case 36299:case 36307:return gP;case 35680:case 36300:case 36308:case 36293:return xP;case 36289:case 36303:case 36311:case 36292:return _P}}var bg=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=QC(e.type)}},Mg=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=yP(e.type)}},Sg=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},yg=/(\w+)(\])?(\[|\.)?/g;function uv(n,t){n.seq.push(t),n.map[t.id]=t}function vP(n,t,e){let i=n.name,s=i.length;for(yg.lastIndex=0;;){let r=yg.exec(i),o=yg.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){uv(e,c===void 0?new bg(a,n,t):new Mg(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Sg(a),uv(e,h)),e=h}}}var ll=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);vP(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function hv(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var bP=37297,MP=0;function SP(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var dv=new de;function wP(n){De._getMatrix(dv,De.workingColorSpace,n);let t=`mat3( ${dv.elements.map(e=>e.toFixed(4))} )`;switch(De.getTransfer(n)){case vc:return[t,"LinearTransferOETF"];case $e:return[t,"sRGBTransferOETF"];default:return ie("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function fv(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+SP(n.getShaderSource(t),a)}else return r}function EP(n,t){let e=wP(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var TP={[Vm]:"Linear",[Wm]:"Reinhard",[$m]:"Cineon",[qm]:"ACESFilmic",[Ym]:"AgX",[jm]:"Neutral",[Xm]:"Custom"};function AP(n,t){let e=TP[t];return e===void 0?(ie("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Kd=new V;function RP(){De.getLuminanceCoefficients(Kd);let n=Kd.x.toFixed(4),t=Kd.y.toFixed(4),e=Kd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function CP(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Jc).join(`
`)}function PP(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function IP(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Jc(n){return n!==""}function pv(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function mv(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var LP=/^[ \t]*#include +<([\w\d./]+)>/gm;function wg(n){return n.replace(LP,DP)}function DP(n,t){let e=Ee[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return wg(e)}var NP=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function gv(n){return n.replace(NP,UP)}function UP(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function xv(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var OP={[Gc]:"SHADOWMAP_TYPE_PCF",[sl]:"SHADOWMAP_TYPE_VSM"};function FP(n){return OP[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var BP={[ol]:"ENVMAP_MODE_REFRACTION"};function kP(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":BP[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var zP={[Gm]:"ENVMAP_BLENDING_MULTIPLY",[Oy]:"ENVMAP_BLENDING_MIX",[Fy]:"ENVMAP_BLENDING_ADD"};function HP(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":zP[n.combine]||"ENVMAP_BLENDING_NONE"}function GP(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=FP(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=kP(e),h=HP(e),d=CP(e),f=PP(r),p=s.createProgram(),_,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Jc).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Jc).join(`
`),m.length>0&&(m+=`
`)):(_=[xv(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Jc).join(`
`),m=[xv(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ar?"#define TONE_MAPPING":"",e.toneMapping!==ar?Ee.tonemapping_pars_fragment:"",e.toneMapping!==ar?AP("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Ee.colorspace_pars_fragment,EP("linearToOutputTexel",e.outputColorSpace),RP(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Jc).join(`
`)),o=wg(o),o=pv(o,e),o=mv(o,e),a=wg(a),a=pv(a,e),a=mv(a,e),o=gv(o),a=gv(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===ug?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===ug?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,M=g+m+a,v=hv(s,s.VERTEX_SHADER,x),A=hv(s,s.FRAGMENT_SHADER,M);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(R){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(v)||"",G=s.getShaderInfoLog(A)||"",F=L.trim(),U=z.trim(),D=G.trim(),O=!0,Z=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,A);else{let X=fv(s,v,"vertex"),J=fv(s,A,"fragment");ce("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+F+`
`+X+`
`+J)}else F!==""?ie("WebGLProgram: Program Info Log:",F):(U===""||D==="")&&(Z=!1);Z&&(R.diagnostics={runnable:O,programLog:F,vertexShader:{log:U,prefix:_},fragmentShader:{log:D,prefix:m}})}s.deleteShader(v),s.deleteShader(A),y=new ll(s,p),w=IP(s,p)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(p,bP)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=MP++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var VP=0,Eg=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Tg(t),e.set(t,i)),i}},Tg=class{constructor(t){this.id=VP++,this.code=t,this.usedTimes=0}};function WP(n){return n===go||n===Yc||n===jc}function $P(n,t,e,i,s,r){let o=new Za,a=new Eg,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,w,N,R,L,z){let G=R.fog,F=L.geometry,U=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?R.environment:null,D=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,O=t.get(y.envMap||U,D),Z=d[y.type],X=i.precision;y.precision!==null&&(X=i.getMaxPrecision(y.precision),X!==y.precision&&ie("WebGLProgram.getParameters:",y.precision,"not supported, using",X,"instead."));let J=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,nt=J!==void 0?J.length:0,dt=0;F.morphAttributes.position!==void 0&&(dt=1),F.morphAttributes.normal!==void 0&&(dt=2),F.morphAttributes.color!==void 0&&(dt=3);let ft,st,yt,xt;if(Z){let Dt=cr[Z];ft=Dt.vertexShader,st=Dt.fragmentShader}else{ft=y.vertexShader,st=y.fragmentShader;let Dt=a.getVertexShaderStage(y),ve=a.getFragmentShaderStage(y);a.update(y,Dt,ve),yt=Dt.id,xt=ve.id}let Tt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),Jt=L.isInstancedMesh===!0,xe=L.isBatchedMesh===!0,jt=!!y.map,Te=!!y.matcap,Se=!!O,me=Se&&O.isPMREMTexture===!0,xn=!!y.aoMap,on=!!y.lightMap,In=!!y.bumpMap&&y.wireframe===!1,Je=!!y.normalMap,Zn=!!y.displacementMap,Ue=!!y.emissiveMap,kn=!!y.metalnessMap,Sn=!!y.roughnessMap,Ln=y.anisotropy>0,$=y.clearcoat>0,Nt=y.diffuseRoughness>0,se=y.dispersion>0,_e=y.retroreflectivity>0,Ct=y.iridescence>0,tn=y.sheen>0,Yt=y.transmission>0,ne=Ln&&!!y.anisotropyMap,B=$&&!!y.clearcoatMap,C=$&&!!y.clearcoatNormalMap,j=$&&!!y.clearcoatRoughnessMap,mt=Nt&&!!y.diffuseRoughnessMap,ut=Ct&&!!y.iridescenceMap,St=Ct&&!!y.iridescenceThicknessMap,wt=tn&&!!y.sheenColorMap,rt=tn&&!!y.sheenRoughnessMap,at=!!y.specularMap,vt=!!y.specularColorMap,W=!!y.specularIntensityMap,lt=Yt&&!!y.transmissionMap,ot=Yt&&!!y.thicknessMap,Pt=!!y.gradientMap,Mt=!!y.alphaMap,Rt=y.alphaTest>0,Zt=!!y.alphaHash,ae=!!y.extensions,pt=ar;y.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(pt=n.toneMapping);let $t=me?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,le={shaderID:Z,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:st,defines:y.defines,customVertexShaderID:yt,customFragmentShaderID:xt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:X,batching:xe,batchingColor:xe&&L._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&L.instanceColor!==null,instancingMorph:Jt&&L.morphTexture!==null,outputColorSpace:Tt===null?n.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:De.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:jt,matcap:Te,envMap:Se,envMapMode:Se&&O.mapping,envMapPMREM:me,envMapMaxLod:me?$t.length-1:null,envMapSize:me?$t[0].width:null,aoMap:xn,lightMap:on,bumpMap:In,normalMap:Je,displacementMap:Zn,emissiveMap:Ue,normalMapObjectSpace:Je&&y.normalMapType===zy,normalMapTangentSpace:Je&&y.normalMapType===ig,packedNormalMap:Je&&y.normalMapType===ig&&WP(y.normalMap.format),metalnessMap:kn,roughnessMap:Sn,anisotropy:Ln,anisotropyMap:ne,clearcoat:$,clearcoatMap:B,clearcoatNormalMap:C,clearcoatRoughnessMap:j,diffuseRoughness:Nt,diffuseRoughnessMap:mt,dispersion:se,retroreflection:_e,iridescence:Ct,iridescenceMap:ut,iridescenceThicknessMap:St,sheen:tn,sheenColorMap:wt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:vt,specularIntensityMap:W,transmission:Yt,transmissionMap:lt,thicknessMap:ot,gradientMap:Pt,opaque:y.transparent===!1&&y.blending===rl&&y.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Rt,alphaHash:Zt,combine:y.combine,mapUv:jt&&f(y.map.channel),aoMapUv:xn&&f(y.aoMap.channel),lightMapUv:on&&f(y.lightMap.channel),bumpMapUv:In&&f(y.bumpMap.channel),normalMapUv:Je&&f(y.normalMap.channel),displacementMapUv:Zn&&f(y.displacementMap.channel),emissiveMapUv:Ue&&f(y.emissiveMap.channel),metalnessMapUv:kn&&f(y.metalnessMap.channel),roughnessMapUv:Sn&&f(y.roughnessMap.channel),anisotropyMapUv:ne&&f(y.anisotropyMap.channel),clearcoatMapUv:B&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:C&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ut&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(y.sheenRoughnessMap.channel),specularMapUv:at&&f(y.specularMap.channel),specularColorMapUv:vt&&f(y.specularColorMap.channel),specularIntensityMapUv:W&&f(y.specularIntensityMap.channel),transmissionMapUv:lt&&f(y.transmissionMap.channel),thicknessMapUv:ot&&f(y.thicknessMap.channel),alphaMapUv:Mt&&f(y.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(Je||Ln),vertexNormals:!!F.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!F.attributes.uv&&(jt||Mt),fog:!!G,useFog:y.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||F.attributes.normal===void 0&&Je===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:dt,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:z.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:jt&&y.map.isVideoTexture===!0&&De.getTransfer(y.map.colorSpace)===$e,decodeVideoTextureEmissive:Ue&&y.emissiveMap.isVideoTexture===!0&&De.getTransfer(y.emissiveMap.colorSpace)===$e,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===mi,flipSided:y.side===oi,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:ae&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ae&&y.extensions.multiDraw===!0||xe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return le.vertexUv1s=l.has(1),le.vertexUv2s=l.has(2),le.vertexUv3s=l.has(3),l.clear(),le}function _(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let N in y.defines)w.push(N),w.push(y.defines[N]);return y.isRawShaderMaterial===!1&&(m(w,y),g(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function m(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let w=d[y.type],N;if(w){let R=cr[w];N=Ky.clone(R.uniforms)}else N=y.uniforms;return N}function M(y,w){let N=u.get(w);return N!==void 0?++N.usedTimes:(N=new GP(n,w,y,s),c.push(N),u.set(w,N)),N}function v(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:M,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:E}}function qP(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function XP(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function _v(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function yv(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,m,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:m,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=m,x.group=g),t++,x}function l(d,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let M=a(d,f,p,_,m,g);p.transmission>0?i.push(M):p.transparent===!0?s.push(M):e.push(M)}function c(d,f,p,_,m,g){let x=a(d,f,p,_,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||XP),i.length>1&&i.sort(f||_v),s.length>1&&s.sort(f||_v)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function YP(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new yv,n.set(i,[o])):s>=r.length?(o=new yv,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function jP(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new V,color:new ee};break;case"SpotLight":e={position:new V,direction:new V,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new V,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new V,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new V,halfWidth:new V,halfHeight:new V};break}return n[t.id]=e,e}}}function ZP(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var JP=0;function KP(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function QP(n){let t=new jP,e=ZP(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new V);let s=new V,r=new ye,o=new ye;function a(c){let u=0,h=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,M=0,v=0,A=0,E=0,y=0,w=0,N=0,R=0;c.sort(KP);for(let z=0,G=c.length;z<G;z++){let F=c[z],U=F.color,D=F.intensity,O=F.distance,Z=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===go?Z=F.shadow.map.texture:Z=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)u+=U.r*D,h+=U.g*D,d+=U.b*D;else if(F.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(F.sh.coefficients[X],D);R++}else if(F.isSunLight){let X=t.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let J=F.shadow,nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[p]=nt,i.sunShadowMap[p]=Z;let dt=J.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[_+ft]=J.getMatrix(ft),i.sunShadowCascade[_+ft]=J._cascadeData[ft];_+=dt,p++}i.sun[f]=X,f++}else if(F.isDirectionalLight){let X=t.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let J=F.shadow,nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize=J.mapSize,i.directionalShadow[m]=nt,i.directionalShadowMap[m]=Z,i.directionalShadowMatrix[m]=F.shadow.matrix,A++}i.directional[m]=X,m++}else if(F.isSpotLight){let X=t.get(F);X.position.setFromMatrixPosition(F.matrixWorld),X.color.copy(U).multiplyScalar(D),X.distance=O,X.coneCos=Math.cos(F.angle),X.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),X.decay=F.decay,i.spot[x]=X;let J=F.shadow;if(F.map&&(i.spotLightMap[w]=F.map,w++,J.updateMatrices(F),F.castShadow&&N++),i.spotLightMatrix[x]=J.matrix,F.castShadow){let nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize=J.mapSize,i.spotShadow[x]=nt,i.spotShadowMap[x]=Z,y++}x++}else if(F.isRectAreaLight){let X=t.get(F);X.color.copy(U).multiplyScalar(D),X.halfWidth.set(F.width*.5,0,0),X.halfHeight.set(0,F.height*.5,0),i.rectArea[M]=X,M++}else if(F.isPointLight){let X=t.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),X.distance=F.distance,X.decay=F.decay,F.castShadow){let J=F.shadow,nt=e.get(F);nt.shadowIntensity=J.intensity,nt.shadowBias=J.bias,nt.shadowNormalBias=J.normalBias,nt.shadowRadius=J.radius,nt.shadowMapSize=J.mapSize,nt.shadowCameraNear=J.camera.near,nt.shadowCameraFar=J.camera.far,i.pointShadow[g]=nt,i.pointShadowMap[g]=Z,i.pointShadowMatrix[g]=F.shadow.matrix,E++}i.point[g]=X,g++}else if(F.isHemisphereLight){let X=t.get(F);X.skyColor.copy(F.color).multiplyScalar(D),X.groundColor.copy(F.groundColor).multiplyScalar(D),i.hemi[v]=X,v++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=kt.LTC_FLOAT_1,i.rectAreaLTC2=kt.LTC_FLOAT_2):(i.rectAreaLTC1=kt.LTC_HALF_1,i.rectAreaLTC2=kt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let L=i.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==x||L.rectAreaLength!==M||L.hemiLength!==v||L.numSunShadows!==p||L.numDirectionalShadows!==A||L.numPointShadows!==E||L.numSpotShadows!==y||L.numSpotMaps!==w||L.numLightProbes!==R)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=M,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-N,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=N,i.numLightProbes=R,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=x,L.rectAreaLength=M,L.hemiLength=v,L.numSunShadows=p,L.numDirectionalShadows=A,L.numPointShadows=E,L.numSpotShadows=y,L.numSpotMaps=w,L.numLightProbes=R,i.version=JP++)}function l(c,u){let h=0,d=0,f=0,p=0,_=0,m=0,g=u.matrixWorldInverse;for(let x=0,M=c.length;x<M;x++){let v=c[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(v.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let A=i.rectArea[_];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function vv(n){let t=new QP(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function tI(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new vv(n),t.set(s,[a])):r>=o.length?(a=new vv(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var eI=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,nI=`uniform sampler2D shadow_pass;
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
}`,iI=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],sI=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],bv=new ye,Zc=new V,vg=new V;function rI(n,t,e){let i=new Vo,s=new Qt,r=new Qt,o=new bn,a=new jh,l=new Zh,c={},u=e.maxTextureSize,h={[or]:oi,[oi]:or,[mi]:mi},d=new pi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Qt},radius:{value:4}},vertexShader:eI,fragmentShader:nI}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Me;p.setAttribute("position",new He(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ge(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Gc;let g=this.type;this.render=function(E,y,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===xy&&(ie("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Gc);let N=n.getRenderTarget(),R=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Xo),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let G=g!==this.type;G&&y.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(U=>U.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,U=E.length;F<U;F++){let D=E[F],O=D.shadow;if(O===void 0){ie("WebGLShadowMap:",D,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;s.copy(O.mapSize);let Z=O.getFrameExtents();s.multiply(Z),r.copy(O.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Z.x),s.x=r.x*Z.x,O.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Z.y),s.y=r.y*Z.y,O.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=X,O.map===null||G===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===sl){if(D.isPointLight){ie("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new ts(s.x,s.y,{format:go,type:Us,minFilter:Ri,magFilter:Ri,generateMipmaps:!1}),O.map.texture.name=D.name+".shadowMap",O.map.depthTexture=new Nr(s.x,s.y,ps),O.map.depthTexture.name=D.name+".shadowMapDepth",O.map.depthTexture.format=Pr,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=ni,O.map.depthTexture.magFilter=ni}else D.isPointLight?(O.map=new Kc(s.x),O.map.depthTexture=new Lc(s.x,Ns)):(O.map=new ts(s.x,s.y),O.map.depthTexture=new Nr(s.x,s.y,Ns)),O.map.depthTexture.name=D.name+".shadowMap",O.map.depthTexture.format=Pr,this.type===Gc?(O.map.depthTexture.compareFunction=X?ag:og,O.map.depthTexture.minFilter=Ri,O.map.depthTexture.magFilter=Ri):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=ni,O.map.depthTexture.magFilter=ni);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==s.x||O.map.height!==s.y)&&O.map.setSize(s.x,s.y);let J=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();D.isPointLight!==!0&&O.updateMatrices(D,w);let nt=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:w.layers;for(let dt=0;dt<J;dt++){let ft=O.getCamera(dt);if(D.isPointLight){let st=O.camera,yt=O.matrix,xt=D.distance||st.far;xt!==st.far&&(st.far=xt,st.updateProjectionMatrix()),Zc.setFromMatrixPosition(D.matrixWorld),st.position.copy(Zc),vg.copy(st.position),vg.add(iI[dt]),st.up.copy(sI[dt]),st.lookAt(vg),st.updateMatrixWorld(),yt.makeTranslation(-Zc.x,-Zc.y,-Zc.z),bv.multiplyMatrices(st.projectionMatrix,st.matrixWorldInverse),O._frustum.setFromProjectionMatrix(bv,st.coordinateSystem,st.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(O.map),n.clear());let st=O.getViewport(dt);o.set(r.x*st.x,r.y*st.y,r.x*st.z,r.y*st.w),z.viewport(o)}i=O.getFrustum(dt),v(y,w,ft,D,nt,this.type)}O.isPointLightShadow!==!0&&this.type===sl&&x(O,w),O.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(N,R,L)};function x(E,y){let w=t.update(_);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new ts(s.x,s.y,{format:go,type:Us}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(y,null,w,d,_,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(y,null,w,f,_,null)}function M(E,y,w,N){let R=null,L=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)R=L;else if(R=w.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let z=R.uuid,G=y.uuid,F=c[z];F===void 0&&(F={},c[z]=F);let U=F[G];U===void 0&&(U=R.clone(),F[G]=U,y.addEventListener("dispose",A)),R=U}if(R.visible=y.visible,R.wireframe=y.wireframe,N===sl?R.side=y.shadowSide!==null?y.shadowSide:y.side:R.side=y.shadowSide!==null?y.shadowSide:h[y.side],R.alphaMap=y.alphaMap,R.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,R.map=y.map,R.clipShadows=y.clipShadows,R.clippingPlanes=y.clippingPlanes,R.clipIntersection=y.clipIntersection,R.displacementMap=y.displacementMap,R.displacementScale=y.displacementScale,R.displacementBias=y.displacementBias,R.wireframeLinewidth=y.wireframeLinewidth,R.linewidth=y.linewidth,w.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let z=n.properties.get(R);z.light=w}return R}function v(E,y,w,N,R,L){if(E.visible===!1)return;if(E.layers.test(R)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===sl)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let F=t.update(E),U=E.material;if(Array.isArray(U)){let D=F.groups;for(let O=0,Z=D.length;O<Z;O++){let X=D[O],J=U[X.materialIndex];if(J&&J.visible){let nt=M(E,J,N,L);E.onBeforeShadow(n,E,y,w,F,nt,X),n.renderBufferDirect(w,null,F,nt,E,X),E.onAfterShadow(n,E,y,w,F,nt,X)}}}else if(U.visible){let D=M(E,U,N,L);E.onBeforeShadow(n,E,y,w,F,D,null),n.renderBufferDirect(w,null,F,D,E,null),E.onAfterShadow(n,E,y,w,F,D,null)}}let G=E.children;for(let F=0,U=G.length;F<U;F++)v(G[F],y,w,N,R,L)}function A(E){E.target.removeEventListener("dispose",A);for(let w in c){let N=c[w],R=E.target.uuid;R in N&&(N[R].dispose(),delete N[R])}}}function oI(n,t){function e(){let W=!1,lt=new bn,ot=null,Pt=new bn(0,0,0,0);return{setMask:function(Mt){ot!==Mt&&!W&&(n.colorMask(Mt,Mt,Mt,Mt),ot=Mt)},setLocked:function(Mt){W=Mt},setClear:function(Mt,Rt,Zt,ae,pt){pt===!0&&(Mt*=ae,Rt*=ae,Zt*=ae),lt.set(Mt,Rt,Zt,ae),Pt.equals(lt)===!1&&(n.clearColor(Mt,Rt,Zt,ae),Pt.copy(lt))},reset:function(){W=!1,ot=null,Pt.set(-1,0,0,0)}}}function i(){let W=!1,lt=!1,ot=null,Pt=null,Mt=null;return{setReversed:function(Rt){if(lt!==Rt){let Zt=t.get("EXT_clip_control");Rt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),lt=Rt;let ae=Mt;Mt=null,this.setClear(ae)}},getReversed:function(){return lt},setTest:function(Rt){Rt?At(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(Rt){ot!==Rt&&!W&&(n.depthMask(Rt),ot=Rt)},setFunc:function(Rt){if(lt&&(Rt=Zy[Rt]),Pt!==Rt){switch(Rt){case Ih:n.depthFunc(n.NEVER);break;case Lh:n.depthFunc(n.ALWAYS);break;case Dh:n.depthFunc(n.LESS);break;case qa:n.depthFunc(n.LEQUAL);break;case Nh:n.depthFunc(n.EQUAL);break;case Uh:n.depthFunc(n.GEQUAL);break;case Oh:n.depthFunc(n.GREATER);break;case Fh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=Rt}},setLocked:function(Rt){W=Rt},setClear:function(Rt){Mt!==Rt&&(Mt=Rt,lt&&(Rt=1-Rt),n.clearDepth(Rt))},reset:function(){W=!1,ot=null,Pt=null,Mt=null,lt=!1}}}function s(){let W=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,ae=null,pt=null;return{setTest:function($t){W||($t?At(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function($t){lt!==$t&&!W&&(n.stencilMask($t),lt=$t)},setFunc:function($t,le,Dt){(ot!==$t||Pt!==le||Mt!==Dt)&&(n.stencilFunc($t,le,Dt),ot=$t,Pt=le,Mt=Dt)},setOp:function($t,le,Dt){(Rt!==$t||Zt!==le||ae!==Dt)&&(n.stencilOp($t,le,Dt),Rt=$t,Zt=le,ae=Dt)},setLocked:function($t){W=$t},setClear:function($t){pt!==$t&&(n.clearStencil($t),pt=$t)},reset:function(){W=!1,lt=null,ot=null,Pt=null,Mt=null,Rt=null,Zt=null,ae=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,M=null,v=null,A=null,E=null,y=null,w=new ee(0,0,0),N=0,R=!1,L=null,z=null,G=null,F=null,U=null,D=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,Z=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(Z=parseFloat(/^WebGL (\d)/.exec(X)[1]),O=Z>=1):X.indexOf("OpenGL ES")!==-1&&(Z=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),O=Z>=2);let J=null,nt={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),st=new bn().fromArray(dt),yt=new bn().fromArray(ft);function xt(W,lt,ot,Pt){let Mt=new Uint8Array(4),Rt=n.createTexture();n.bindTexture(W,Rt),n.texParameteri(W,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(W,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<ot;Zt++)W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Rt}let Tt={};Tt[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Tt[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Tt[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(qa),In(!1),Je(Om),At(n.CULL_FACE),xn(Xo);function At(W){u[W]!==!0&&(n.enable(W),u[W]=!0)}function Jt(W){u[W]!==!1&&(n.disable(W),u[W]=!1)}function xe(W,lt){return d[W]!==lt?(n.bindFramebuffer(W,lt),d[W]=lt,W===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=lt),W===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function jt(W,lt){let ot=p,Pt=!1;if(W){ot=f.get(lt),ot===void 0&&(ot=[],f.set(lt,ot));let Mt=W.textures;if(ot.length!==Mt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let Rt=0,Zt=Mt.length;Rt<Zt;Rt++)ot[Rt]=n.COLOR_ATTACHMENT0+Rt;ot.length=Mt.length,Pt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(ot)}function Te(W){return _!==W?(n.useProgram(W),_=W,!0):!1}let Se={[Yo]:n.FUNC_ADD,[yy]:n.FUNC_SUBTRACT,[vy]:n.FUNC_REVERSE_SUBTRACT};Se[by]=n.MIN,Se[My]=n.MAX;let me={[Sy]:n.ZERO,[wy]:n.ONE,[Ey]:n.SRC_COLOR,[zm]:n.SRC_ALPHA,[Iy]:n.SRC_ALPHA_SATURATE,[Cy]:n.DST_COLOR,[Ay]:n.DST_ALPHA,[Ty]:n.ONE_MINUS_SRC_COLOR,[Hm]:n.ONE_MINUS_SRC_ALPHA,[Py]:n.ONE_MINUS_DST_COLOR,[Ry]:n.ONE_MINUS_DST_ALPHA,[Ly]:n.CONSTANT_COLOR,[Dy]:n.ONE_MINUS_CONSTANT_COLOR,[Ny]:n.CONSTANT_ALPHA,[Uy]:n.ONE_MINUS_CONSTANT_ALPHA};function xn(W,lt,ot,Pt,Mt,Rt,Zt,ae,pt,$t){if(W===Xo){m===!0&&(Jt(n.BLEND),m=!1);return}if(m===!1&&(At(n.BLEND),m=!0),W!==_y){if(W!==g||$t!==R){if((x!==Yo||A!==Yo)&&(n.blendEquation(n.FUNC_ADD),x=Yo,A=Yo),$t)switch(W){case rl:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Fm:n.blendFunc(n.ONE,n.ONE);break;case Bm:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case km:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ce("WebGLState: Invalid blending: ",W);break}else switch(W){case rl:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Fm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Bm:ce("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case km:ce("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ce("WebGLState: Invalid blending: ",W);break}M=null,v=null,E=null,y=null,w.set(0,0,0),N=0,g=W,R=$t}return}Mt=Mt||lt,Rt=Rt||ot,Zt=Zt||Pt,(lt!==x||Mt!==A)&&(n.blendEquationSeparate(Se[lt],Se[Mt]),x=lt,A=Mt),(ot!==M||Pt!==v||Rt!==E||Zt!==y)&&(n.blendFuncSeparate(me[ot],me[Pt],me[Rt],me[Zt]),M=ot,v=Pt,E=Rt,y=Zt),(ae.equals(w)===!1||pt!==N)&&(n.blendColor(ae.r,ae.g,ae.b,pt),w.copy(ae),N=pt),g=W,R=!1}function on(W,lt){W.side===mi?Jt(n.CULL_FACE):At(n.CULL_FACE);let ot=W.side===oi;lt&&(ot=!ot),In(ot),W.blending===rl&&W.transparent===!1?xn(Xo):xn(W.blending,W.blendEquation,W.blendSrc,W.blendDst,W.blendEquationAlpha,W.blendSrcAlpha,W.blendDstAlpha,W.blendColor,W.blendAlpha,W.premultipliedAlpha),o.setFunc(W.depthFunc),o.setTest(W.depthTest),o.setMask(W.depthWrite),r.setMask(W.colorWrite);let Pt=W.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(W.stencilWriteMask),a.setFunc(W.stencilFunc,W.stencilRef,W.stencilFuncMask),a.setOp(W.stencilFail,W.stencilZFail,W.stencilZPass)),Ue(W.polygonOffset,W.polygonOffsetFactor,W.polygonOffsetUnits),W.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function In(W){L!==W&&(W?n.frontFace(n.CW):n.frontFace(n.CCW),L=W)}function Je(W){W!==my?(At(n.CULL_FACE),W!==z&&(W===Om?n.cullFace(n.BACK):W===gy?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),z=W}function Zn(W){W!==G&&(O&&n.lineWidth(W),G=W)}function Ue(W,lt,ot){W?(At(n.POLYGON_OFFSET_FILL),(F!==lt||U!==ot)&&(F=lt,U=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Jt(n.POLYGON_OFFSET_FILL)}function kn(W){W?At(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function Sn(W){W===void 0&&(W=n.TEXTURE0+D-1),J!==W&&(n.activeTexture(W),J=W)}function Ln(W,lt,ot){ot===void 0&&(J===null?ot=n.TEXTURE0+D-1:ot=J);let Pt=nt[ot];Pt===void 0&&(Pt={type:void 0,texture:void 0},nt[ot]=Pt),(Pt.type!==W||Pt.texture!==lt)&&(J!==ot&&(n.activeTexture(ot),J=ot),n.bindTexture(W,lt||Tt[W]),Pt.type=W,Pt.texture=lt)}function $(){let W=nt[J];W!==void 0&&W.type!==void 0&&(n.bindTexture(W.type,null),W.type=void 0,W.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function se(){try{n.compressedTexImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function _e(){try{n.texSubImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function Ct(){try{n.texSubImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function tn(){try{n.compressedTexSubImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function Yt(){try{n.compressedTexSubImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function ne(){try{n.texStorage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function B(){try{n.texStorage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function C(){try{n.texImage2D(...arguments)}catch(W){ce("WebGLState:",W)}}function j(){try{n.texImage3D(...arguments)}catch(W){ce("WebGLState:",W)}}function mt(W){return h[W]!==void 0?h[W]:n.getParameter(W)}function ut(W,lt){h[W]!==lt&&(n.pixelStorei(W,lt),h[W]=lt)}function St(W){st.equals(W)===!1&&(n.scissor(W.x,W.y,W.z,W.w),st.copy(W))}function wt(W){yt.equals(W)===!1&&(n.viewport(W.x,W.y,W.z,W.w),yt.copy(W))}function rt(W,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Pt=ot.get(W);Pt===void 0&&(Pt=n.getUniformBlockIndex(lt,W.name),n.uniformBlockBinding(lt,Pt,Pt),ot.set(W,Pt))}function at(W,lt,ot){let Mt=c.get(lt).get(W);l[Mt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,ot),l[Mt]=ot)}function vt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},J=null,nt={},d={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,M=null,v=null,A=null,E=null,y=null,w=new ee(0,0,0),N=0,R=!1,L=null,z=null,G=null,F=null,U=null,st.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:Jt,bindFramebuffer:xe,drawBuffers:jt,useProgram:Te,setBlending:xn,setMaterial:on,setFlipSided:In,setCullFace:Je,setLineWidth:Zn,setPolygonOffset:Ue,setScissorTest:kn,activeTexture:Sn,bindTexture:Ln,unbindTexture:$,compressedTexImage2D:Nt,compressedTexImage3D:se,texImage2D:C,texImage3D:j,pixelStorei:ut,getParameter:mt,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:ne,texStorage3D:B,texSubImage2D:_e,texSubImage3D:Ct,compressedTexSubImage2D:tn,compressedTexSubImage3D:Yt,scissor:St,viewport:wt,reset:vt}}function aI(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Qt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(B=>p.delete(B)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(B,C){return m?new OffscreenCanvas(B,C):Mc("canvas")}function x(B,C,j){let mt=1,ut=ne(B);if((ut.width>j||ut.height>j)&&(mt=j/Math.max(ut.width,ut.height)),mt<1)if(typeof HTMLImageElement<"u"&&B instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&B instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&B instanceof ImageBitmap||typeof VideoFrame<"u"&&B instanceof VideoFrame){let St=Math.floor(mt*ut.width),wt=Math.floor(mt*ut.height);d===void 0&&(d=g(St,wt));let rt=C?g(St,wt):d;return rt.width=St,rt.height=wt,rt.getContext("2d").drawImage(B,0,0,St,wt),ie("WebGLRenderer: Texture has been resized from ("+ut.width+"x"+ut.height+") to ("+St+"x"+wt+")."),rt}else return"data"in B&&ie("WebGLRenderer: Image in DataTexture is too big ("+ut.width+"x"+ut.height+")."),B;return B}function M(B){return B.generateMipmaps}function v(B){n.generateMipmap(B)}function A(B){return B.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:B.isWebGL3DRenderTarget?n.TEXTURE_3D:B.isWebGLArrayRenderTarget||B.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(B,C,j,mt,ut,St=!1){if(B!==null){if(n[B]!==void 0)return n[B];ie("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+B+"'")}let wt;mt&&(wt=t.get("EXT_texture_norm16"),wt||ie("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=C;if(C===n.RED&&(j===n.FLOAT&&(rt=n.R32F),j===n.HALF_FLOAT&&(rt=n.R16F),j===n.UNSIGNED_BYTE&&(rt=n.R8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.R16_EXT),j===n.SHORT&&wt&&(rt=wt.R16_SNORM_EXT)),C===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.R8UI),j===n.UNSIGNED_SHORT&&(rt=n.R16UI),j===n.UNSIGNED_INT&&(rt=n.R32UI),j===n.BYTE&&(rt=n.R8I),j===n.SHORT&&(rt=n.R16I),j===n.INT&&(rt=n.R32I)),C===n.RG&&(j===n.FLOAT&&(rt=n.RG32F),j===n.HALF_FLOAT&&(rt=n.RG16F),j===n.UNSIGNED_BYTE&&(rt=n.RG8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RG16_EXT),j===n.SHORT&&wt&&(rt=wt.RG16_SNORM_EXT)),C===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RG8UI),j===n.UNSIGNED_SHORT&&(rt=n.RG16UI),j===n.UNSIGNED_INT&&(rt=n.RG32UI),j===n.BYTE&&(rt=n.RG8I),j===n.SHORT&&(rt=n.RG16I),j===n.INT&&(rt=n.RG32I)),C===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),j===n.UNSIGNED_INT&&(rt=n.RGB32UI),j===n.BYTE&&(rt=n.RGB8I),j===n.SHORT&&(rt=n.RGB16I),j===n.INT&&(rt=n.RGB32I)),C===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),j===n.UNSIGNED_INT&&(rt=n.RGBA32UI),j===n.BYTE&&(rt=n.RGBA8I),j===n.SHORT&&(rt=n.RGBA16I),j===n.INT&&(rt=n.RGBA32I)),C===n.RGB&&(j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGB16_EXT),j===n.SHORT&&wt&&(rt=wt.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),C===n.RGBA){let at=St?vc:De.getTransfer(ut);j===n.FLOAT&&(rt=n.RGBA32F),j===n.HALF_FLOAT&&(rt=n.RGBA16F),j===n.UNSIGNED_BYTE&&(rt=at===$e?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&wt&&(rt=wt.RGBA16_EXT),j===n.SHORT&&wt&&(rt=wt.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function y(B,C){let j;return B?C===null||C===Ns||C===Zo?j=n.DEPTH24_STENCIL8:C===ps?j=n.DEPTH32F_STENCIL8:C===al&&(j=n.DEPTH24_STENCIL8,ie("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):C===null||C===Ns||C===Zo?j=n.DEPTH_COMPONENT24:C===ps?j=n.DEPTH_COMPONENT32F:C===al&&(j=n.DEPTH_COMPONENT16),j}function w(B,C){return M(B)===!0||B.isFramebufferTexture&&B.minFilter!==ni&&B.minFilter!==Ri?Math.log2(Math.max(C.width,C.height))+1:B.mipmaps.length>0?B.mipmaps.length:B.isCompressedTexture&&Array.isArray(B.image)?C.mipmaps.length:1}function N(B){let C=new WeakRef(B);i.get(B).__ref=C,p.add(C),_.register(B,C,C)}function R(B){let C=i.get(B).__ref;C!==void 0&&(p.delete(C),_.unregister(C))}function L(B){G(B.target)}function z(B){F(B.target)}function G(B){B.removeEventListener("dispose",L),R(B),D(B),B.isVideoTexture&&u.delete(B),B.isHTMLTexture&&h.delete(B)}function F(B){B.removeEventListener("dispose",z),R(B),Z(B)}function U(){for(let B of p){let C=B.deref();C!==void 0&&(C.isRenderTarget===!0?F(C):G(C))}p.clear(),h.clear()}function D(B){let C=i.get(B);if(C.__webglInit===void 0)return;let j=B.source,mt=f.get(j);if(mt){let ut=mt[C.__cacheKey];ut.usedTimes--,ut.usedTimes===0&&O(B),Object.keys(mt).length===0&&f.delete(j)}i.remove(B)}function O(B){let C=i.get(B);n.deleteTexture(C.__webglTexture);let j=B.source,mt=f.get(j);delete mt[C.__cacheKey],o.memory.textures--}function Z(B){let C=i.get(B);C.__depthDisposeCallback&&C.__depthDisposeCallback();let j=B.depthTexture;if(j&&j.renderTarget===B&&G(j),B.isWebGLCubeRenderTarget)for(let ut=0;ut<6;ut++){if(Array.isArray(C.__webglFramebuffer[ut]))for(let St=0;St<C.__webglFramebuffer[ut].length;St++)n.deleteFramebuffer(C.__webglFramebuffer[ut][St]);else n.deleteFramebuffer(C.__webglFramebuffer[ut]);C.__webglDepthbuffer&&n.deleteRenderbuffer(C.__webglDepthbuffer[ut])}else{if(Array.isArray(C.__webglFramebuffer))for(let ut=0;ut<C.__webglFramebuffer.length;ut++)n.deleteFramebuffer(C.__webglFramebuffer[ut]);else n.deleteFramebuffer(C.__webglFramebuffer);if(C.__webglDepthbuffer&&n.deleteRenderbuffer(C.__webglDepthbuffer),C.__webglMultisampledFramebuffer&&n.deleteFramebuffer(C.__webglMultisampledFramebuffer),C.__webglColorRenderbuffer)for(let ut=0;ut<C.__webglColorRenderbuffer.length;ut++)C.__webglColorRenderbuffer[ut]&&n.deleteRenderbuffer(C.__webglColorRenderbuffer[ut]);C.__webglDepthRenderbuffer&&n.deleteRenderbuffer(C.__webglDepthRenderbuffer)}let mt=B.textures;for(let ut=0,St=mt.length;ut<St;ut++){let wt=i.get(mt[ut]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(mt[ut])}i.remove(B)}let X=0;function J(){X=0}function nt(){return X}function dt(B){X=B}function ft(){let B=X;return B>=s.maxTextures&&ie("WebGLTextures: Trying to use "+(B+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,B}function st(B){let C=[];return C.push(B.wrapS),C.push(B.wrapT),C.push(B.wrapR||0),C.push(B.magFilter),C.push(B.minFilter),C.push(B.anisotropy),C.push(B.internalFormat),C.push(B.format),C.push(B.type),C.push(B.generateMipmaps),C.push(B.mipmapsAutoUpdate),C.push(B.premultiplyAlpha),C.push(B.flipY),C.push(B.unpackAlignment),C.push(B.colorSpace),C.join()}function yt(B,C){let j=i.get(B);if(B.isVideoTexture&&tn(B),B.isRenderTargetTexture===!1&&B.isExternalTexture!==!0&&B.version>0&&j.__version!==B.version){let mt=B.image;if(mt===null)ie("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ie("WebGLRenderer: Texture marked for update but image is incomplete");else{on(j,B,C);return}}else B.isExternalTexture&&(j.__webglTexture=B.sourceTexture?B.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+C)}function xt(B,C){let j=i.get(B);if(B.isRenderTargetTexture===!1&&B.version>0&&j.__version!==B.version){on(j,B,C);return}else B.isExternalTexture&&(j.__webglTexture=B.sourceTexture?B.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+C)}function Tt(B,C){let j=i.get(B);if(B.isRenderTargetTexture===!1&&B.version>0&&j.__version!==B.version){on(j,B,C);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+C)}function At(B,C){let j=i.get(B);if(B.version>0&&j.__version!==B.version){In(j,B,C);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+C)}let Jt={[Bh]:n.REPEAT,[nr]:n.CLAMP_TO_EDGE,[kh]:n.MIRRORED_REPEAT},xe={[ni]:n.NEAREST,[By]:n.NEAREST_MIPMAP_NEAREST,[Vc]:n.NEAREST_MIPMAP_LINEAR,[Ri]:n.LINEAR,[hd]:n.LINEAR_MIPMAP_NEAREST,[Ur]:n.LINEAR_MIPMAP_LINEAR},jt={[Gy]:n.NEVER,[lg]:n.ALWAYS,[Vy]:n.LESS,[og]:n.LEQUAL,[Wy]:n.EQUAL,[ag]:n.GEQUAL,[$y]:n.GREATER,[qy]:n.NOTEQUAL};function Te(B,C){if(C.type===ps&&t.has("OES_texture_float_linear")===!1&&(C.magFilter===Ri||C.magFilter===hd||C.magFilter===Vc||C.magFilter===Ur||C.minFilter===Ri||C.minFilter===hd||C.minFilter===Vc||C.minFilter===Ur)&&ie("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(B,n.TEXTURE_WRAP_S,Jt[C.wrapS]),n.texParameteri(B,n.TEXTURE_WRAP_T,Jt[C.wrapT]),(B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY)&&n.texParameteri(B,n.TEXTURE_WRAP_R,Jt[C.wrapR]),n.texParameteri(B,n.TEXTURE_MAG_FILTER,xe[C.magFilter]),n.texParameteri(B,n.TEXTURE_MIN_FILTER,xe[C.minFilter]),C.compareFunction&&(n.texParameteri(B,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(B,n.TEXTURE_COMPARE_FUNC,jt[C.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(C.magFilter===ni||C.minFilter!==Vc&&C.minFilter!==Ur||C.type===ps&&t.has("OES_texture_float_linear")===!1)return;if(C.anisotropy>1||i.get(C).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(B,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(C.anisotropy,s.getMaxAnisotropy())),i.get(C).__currentAnisotropy=C.anisotropy}}}function Se(B,C){let j=!1;B.__webglInit===void 0&&(B.__webglInit=!0,C.addEventListener("dispose",L),N(C));let mt=C.source,ut=f.get(mt);ut===void 0&&(ut={},f.set(mt,ut));let St=st(C);if(St!==B.__cacheKey){ut[St]===void 0&&(ut[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),ut[St].usedTimes++;let wt=ut[B.__cacheKey];wt!==void 0&&(ut[B.__cacheKey].usedTimes--,wt.usedTimes===0&&O(C)),B.__cacheKey=St,B.__webglTexture=ut[St].texture}return j}function me(B,C,j){return Math.floor(Math.floor(B/j)/C)}function xn(B,C,j,mt){let St=B.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,C.width,C.height,j,mt,C.data);else{St.sort((W,lt)=>W.start-lt.start);let wt=0;for(let W=1;W<St.length;W++){let lt=St[wt],ot=St[W],Pt=lt.start+lt.count,Mt=me(ot.start,C.width,4),Rt=me(lt.start,C.width,4);ot.start<=Pt+1&&Mt===Rt&&me(ot.start+ot.count-1,C.width,4)===Mt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++wt,St[wt]=ot)}St.length=wt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),vt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,C.width);for(let W=0,lt=St.length;W<lt;W++){let ot=St[W],Pt=Math.floor(ot.start/4),Mt=Math.ceil(ot.count/4),Rt=Pt%C.width,Zt=Math.floor(Pt/C.width),ae=Mt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,Rt,Zt,ae,pt,j,mt,C.data)}B.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,vt)}}function on(B,C,j){let mt=n.TEXTURE_2D;(C.isDataArrayTexture||C.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),C.isData3DTexture&&(mt=n.TEXTURE_3D);let ut=Se(B,C),St=C.source;e.bindTexture(mt,B.__webglTexture,n.TEXTURE0+j);let wt=i.get(St);if(St.version!==wt.__version||ut===!0){if(e.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&C.image instanceof ImageBitmap)===!1){let pt=De.getPrimaries(De.workingColorSpace),$t=C.colorSpace===Fr?null:De.getPrimaries(C.colorSpace),le=C.colorSpace===Fr||pt===$t?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,C.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,C.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,le)}e.pixelStorei(n.UNPACK_ALIGNMENT,C.unpackAlignment);let at=x(C.image,!1,s.maxTextureSize);at=Yt(C,at);let vt=r.convert(C.format,C.colorSpace),W=r.convert(C.type),lt=E(C.internalFormat,vt,W,C.normalized,C.colorSpace,C.isVideoTexture);Te(mt,C);let ot,Pt=C.mipmaps,Mt=C.isVideoTexture!==!0,Rt=wt.__version===void 0||ut===!0,Zt=St.dataReady,ae=w(C,at);if(C.isDepthTexture)lt=y(C.format===Or,C.type),Rt&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,W,null));else if(C.isDataTexture)if(Pt.length>0){Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,ae,lt,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,W,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,W,ot.data);C.generateMipmaps=!1}else Mt?(Rt&&e.texStorage2D(n.TEXTURE_2D,ae,lt,at.width,at.height),Zt&&xn(C,at,vt,W)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,vt,W,at.data);else if(C.isCompressedTexture)if(C.isCompressedArrayTexture){Mt&&Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ae,lt,Pt[0].width,Pt[0].height,at.depth);for(let pt=0,$t=Pt.length;pt<$t;pt++)if(ot=Pt[pt],C.format!==Os)if(vt!==null)if(Mt){if(Zt)if(C.layerUpdates.size>0){let le=_g(ot.width,ot.height,C.format,C.type);for(let Dt of C.layerUpdates){let ve=ot.data.subarray(Dt*le/ot.data.BYTES_PER_ELEMENT,(Dt+1)*le/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Dt,ot.width,ot.height,1,vt,ve)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,ot.width,ot.height,at.depth,vt,W,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,lt,ot.width,ot.height,at.depth,0,vt,W,ot.data);C.layerUpdates.size>0&&C.clearLayerUpdates()}else{Mt&&Rt&&e.texStorage2D(n.TEXTURE_2D,ae,lt,Pt[0].width,Pt[0].height);for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],C.format!==Os?vt!==null?Mt?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,ot.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,ot.width,ot.height,vt,W,ot.data):e.texImage2D(n.TEXTURE_2D,pt,lt,ot.width,ot.height,0,vt,W,ot.data)}else if(C.isDataArrayTexture)if(Mt){if(Rt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ae,lt,at.width,at.height,at.depth),Zt)if(C.layerUpdates.size>0){let pt=_g(at.width,at.height,C.format,C.type);for(let $t of C.layerUpdates){let le=at.data.subarray($t*pt/at.data.BYTES_PER_ELEMENT,($t+1)*pt/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,$t,at.width,at.height,1,vt,W,le)}C.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,vt,W,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,vt,W,at.data);else if(C.isData3DTexture)Mt?(Rt&&e.texStorage3D(n.TEXTURE_3D,ae,lt,at.width,at.height,at.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,vt,W,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,vt,W,at.data);else if(C.isFramebufferTexture){if(Rt)if(Mt)e.texStorage2D(n.TEXTURE_2D,ae,lt,at.width,at.height);else{let pt=at.width,$t=at.height;for(let le=0;le<ae;le++)e.texImage2D(n.TEXTURE_2D,le,lt,pt,$t,0,vt,W,null),pt>>=1,$t>>=1}}else if(C.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),at.parentNode!==pt){pt.appendChild(at),h.add(C),pt.onpaint=$t=>{let le=$t.changedElements;for(let Dt of h)le.includes(Dt.image)&&(Dt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let le=n.RGBA,Dt=n.RGBA,ve=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,le,Dt,ve,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pt.length>0){if(Mt&&Rt){let pt=ne(Pt[0]);e.texStorage2D(n.TEXTURE_2D,ae,lt,pt.width,pt.height)}for(let pt=0,$t=Pt.length;pt<$t;pt++)ot=Pt[pt],Mt?Zt&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,vt,W,ot):e.texImage2D(n.TEXTURE_2D,pt,lt,vt,W,ot);C.generateMipmaps=!1}else if(Mt){if(Rt){let pt=ne(at);e.texStorage2D(n.TEXTURE_2D,ae,lt,pt.width,pt.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,W,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,vt,W,at);M(C)&&C.mipmapsAutoUpdate===!0&&v(mt),wt.__version=St.version,C.onUpdate&&C.onUpdate(C)}B.__version=C.version}function In(B,C,j){if(C.image.length!==6)return;let mt=Se(B,C),ut=C.source;e.bindTexture(n.TEXTURE_CUBE_MAP,B.__webglTexture,n.TEXTURE0+j);let St=i.get(ut);if(ut.version!==St.__version||mt===!0){e.activeTexture(n.TEXTURE0+j);let wt=De.getPrimaries(De.workingColorSpace),rt=C.colorSpace===Fr?null:De.getPrimaries(C.colorSpace),at=C.colorSpace===Fr||wt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,C.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,C.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,C.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let vt=C.isCompressedTexture||C.image[0].isCompressedTexture,W=C.image[0]&&C.image[0].isDataTexture,lt=[];for(let Dt=0;Dt<6;Dt++)!vt&&!W?lt[Dt]=x(C.image[Dt],!0,s.maxCubemapSize):lt[Dt]=W?C.image[Dt].image:C.image[Dt],lt[Dt]=Yt(C,lt[Dt]);let ot=lt[0],Pt=r.convert(C.format,C.colorSpace),Mt=r.convert(C.type),Rt=E(C.internalFormat,Pt,Mt,C.normalized,C.colorSpace),Zt=C.isVideoTexture!==!0,ae=St.__version===void 0||mt===!0,pt=ut.dataReady,$t=w(C,ot);Te(n.TEXTURE_CUBE_MAP,C);let le;if(C.isDepthTexture){if(Rt=y(C.format===Or,C.type),ae)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Rt,ot.width,ot.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,ot.width,ot.height,0,Pt,Mt,null)}else if(vt){Zt&&ae&&e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,ot.width,ot.height);for(let Dt=0;Dt<6;Dt++){le=lt[Dt].mipmaps;for(let ve=0;ve<le.length;ve++){let an=le[ve];C.format!==Os?Pt!==null?Zt?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,0,0,an.width,an.height,Pt,an.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,Rt,an.width,an.height,0,an.data):ie("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,0,0,an.width,an.height,Pt,Mt,an.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve,Rt,an.width,an.height,0,Pt,Mt,an.data)}}}else{if(le=C.mipmaps,Zt&&ae){le.length>0&&$t++;let Dt=ne(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,$t,Rt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(W){Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,lt[Dt].width,lt[Dt].height,Pt,Mt,lt[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,lt[Dt].width,lt[Dt].height,0,Pt,Mt,lt[Dt].data);for(let ve=0;ve<le.length;ve++){let yi=le[ve].image[Dt].image;Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,0,0,yi.width,yi.height,Pt,Mt,yi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,Rt,yi.width,yi.height,0,Pt,Mt,yi.data)}}else{Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Pt,Mt,lt[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Rt,Pt,Mt,lt[Dt]);for(let ve=0;ve<le.length;ve++){let an=le[ve];Zt?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,0,0,Pt,Mt,an.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,ve+1,Rt,Pt,Mt,an.image[Dt])}}}M(C)&&C.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),St.__version=ut.version,C.onUpdate&&C.onUpdate(C)}B.__version=C.version}function Je(B,C,j,mt,ut,St){let wt=r.convert(j.format,j.colorSpace),rt=r.convert(j.type),at=E(j.internalFormat,wt,rt,j.normalized,j.colorSpace),vt=i.get(C),W=i.get(j);if(W.__renderTarget=C,!vt.__hasExternalTextures){let lt=Math.max(1,C.width>>St),ot=Math.max(1,C.height>>St);ut===n.TEXTURE_3D||ut===n.TEXTURE_2D_ARRAY?e.texImage3D(ut,St,at,lt,ot,C.depth,0,wt,rt,null):e.texImage2D(ut,St,at,lt,ot,0,wt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,B),Ct(C)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,ut,W.__webglTexture,0,_e(C)):(ut===n.TEXTURE_2D||ut>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ut<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,ut,W.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Zn(B,C,j){if(n.bindRenderbuffer(n.RENDERBUFFER,B),C.depthBuffer){let mt=C.depthTexture,ut=mt&&mt.isDepthTexture?mt.type:null,St=y(C.stencilBuffer,ut),wt=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ct(C)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e(C),St,C.width,C.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e(C),St,C.width,C.height):n.renderbufferStorage(n.RENDERBUFFER,St,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,B)}else{let mt=C.textures;for(let ut=0;ut<mt.length;ut++){let St=mt[ut],wt=r.convert(St.format,St.colorSpace),rt=r.convert(St.type),at=E(St.internalFormat,wt,rt,St.normalized,St.colorSpace);Ct(C)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e(C),at,C.width,C.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e(C),at,C.width,C.height):n.renderbufferStorage(n.RENDERBUFFER,at,C.width,C.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ue(B,C,j){let mt=C.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,B),!(C.depthTexture&&C.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ut=i.get(C.depthTexture);ut.__renderTarget=C;let St=mt?C.depthTexture.image[0]:C.depthTexture.image;(!ut.__webglTexture||St.width!==C.width||St.height!==C.height)&&(St.width=C.width,St.height=C.height,C.depthTexture.needsUpdate=!0),mt?At(C.depthTexture,0):yt(C.depthTexture,0);let wt=ut.__webglTexture,rt=_e(C),at=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,vt=C.depthTexture.format===Or?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(C.depthTexture.format===Pr)Ct(C)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else if(C.depthTexture.format===Or)Ct(C)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,vt,at,wt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,vt,at,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function kn(B){let C=i.get(B),j=B.isWebGLCubeRenderTarget===!0;if(C.__boundDepthTexture!==B.depthTexture){let mt=B.depthTexture;if(C.__depthDisposeCallback&&C.__depthDisposeCallback(),mt){let ut=()=>{delete C.__boundDepthTexture,delete C.__depthDisposeCallback,mt.removeEventListener("dispose",ut)};mt.addEventListener("dispose",ut),C.__depthDisposeCallback=ut}C.__boundDepthTexture=mt}if(B.depthTexture&&!C.__autoAllocateDepthBuffer)if(j)for(let mt=0;mt<6;mt++)Ue(C.__webglFramebuffer[mt],B,mt);else B.texture.mipmaps.length>0?Ue(C.__webglFramebuffer[0],B,0):Ue(C.__webglFramebuffer,B,0);else if(j){C.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,C.__webglFramebuffer[mt]),C.__webglDepthbuffer[mt]===void 0)C.__webglDepthbuffer[mt]=n.createRenderbuffer(),Zn(C.__webglDepthbuffer[mt],B,!1);else{let ut=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=C.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ut,n.RENDERBUFFER,St)}}else if(B.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,C.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,C.__webglFramebuffer),C.__webglDepthbuffer===void 0)C.__webglDepthbuffer=n.createRenderbuffer(),Zn(C.__webglDepthbuffer,B,!1);else{let ut=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=C.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,ut,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Sn(B,C,j){let mt=i.get(B);C!==void 0&&Je(mt.__webglFramebuffer,B,B.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&kn(B)}function Ln(B){let C=B.texture,j=i.get(B),mt=i.get(C);B.addEventListener("dispose",z),N(B);let ut=B.textures,St=B.isWebGLCubeRenderTarget===!0,wt=ut.length>1;if(wt||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=C.version,o.memory.textures++),St){j.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(C.mipmaps.length>0){j.__webglFramebuffer[rt]=[];for(let at=0;at<C.mipmaps.length;at++)j.__webglFramebuffer[rt][at]=n.createFramebuffer()}else j.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(C.mipmaps.length>0){j.__webglFramebuffer=[];for(let rt=0;rt<C.mipmaps.length;rt++)j.__webglFramebuffer[rt]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(wt)for(let rt=0,at=ut.length;rt<at;rt++){let vt=i.get(ut[rt]);vt.__webglTexture===void 0&&(vt.__webglTexture=n.createTexture(),o.memory.textures++)}if(B.samples>0&&Ct(B)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let rt=0;rt<ut.length;rt++){let at=ut[rt];j.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[rt]);let vt=r.convert(at.format,at.colorSpace),W=r.convert(at.type),lt=E(at.internalFormat,vt,W,at.normalized,at.colorSpace,B.isXRRenderTarget===!0),ot=_e(B);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,B.width,B.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,j.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),B.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),Zn(j.__webglDepthRenderbuffer,B,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),Te(n.TEXTURE_CUBE_MAP,C);for(let rt=0;rt<6;rt++)if(C.mipmaps.length>0)for(let at=0;at<C.mipmaps.length;at++)Je(j.__webglFramebuffer[rt][at],B,C,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Je(j.__webglFramebuffer[rt],B,C,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);M(C)?v(n.TEXTURE_CUBE_MAP):C.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,C.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let rt=0,at=ut.length;rt<at;rt++){let vt=ut[rt],W=i.get(vt),lt=n.TEXTURE_2D;(B.isWebGL3DRenderTarget||B.isWebGLArrayRenderTarget)&&(lt=B.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,W.__webglTexture),Te(lt,vt),Je(j.__webglFramebuffer,B,vt,n.COLOR_ATTACHMENT0+rt,lt,0),M(vt)&&v(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((B.isWebGL3DRenderTarget||B.isWebGLArrayRenderTarget)&&(rt=B.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,mt.__webglTexture),Te(rt,C),C.mipmaps.length>0)for(let at=0;at<C.mipmaps.length;at++)Je(j.__webglFramebuffer[at],B,C,n.COLOR_ATTACHMENT0,rt,at);else Je(j.__webglFramebuffer,B,C,n.COLOR_ATTACHMENT0,rt,0);M(C)?v(rt):C.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,C.mipmaps.length-1),e.unbindTexture()}B.depthBuffer&&kn(B)}function $(B){let C=B.textures;for(let j=0,mt=C.length;j<mt;j++){let ut=C[j];if(M(ut)&&ut.mipmapsAutoUpdate===!0){let St=A(B),wt=i.get(ut).__webglTexture;e.bindTexture(St,wt),v(St),e.unbindTexture()}}}let Nt=[];function se(B){if(B.samples>0){if(Ct(B)===!1){let C=B.textures,j=B.width,mt=B.height,ut=n.COLOR_BUFFER_BIT,St=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(B),rt=C.length>1;if(rt)for(let vt=0;vt<C.length;vt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),B.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let vt=0;vt<C.length;vt++){if(B.resolveDepthBuffer&&(B.depthBuffer&&(ut|=n.DEPTH_BUFFER_BIT),B.stencilBuffer&&B.resolveStencilBuffer&&(ut|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let W=i.get(C[vt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,W,0)}n.blitFramebuffer(0,0,j,mt,0,0,j,mt,ut,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+vt),B.depthBuffer&&B.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let vt=0;vt<C.length;vt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[vt]);let W=i.get(C[vt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+vt,n.TEXTURE_2D,W,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(B.depthBuffer&&B.storeMultisampledDepthBuffer===!1&&l){let C=B.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[C])}}}function _e(B){return Math.min(s.maxSamples,B.samples)}function Ct(B){let C=i.get(B);return B.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&C.__useRenderToTexture!==!1}function tn(B){let C=o.render.frame;u.get(B)!==C&&(u.set(B,C),B.update())}function Yt(B,C){let j=B.colorSpace,mt=B.format,ut=B.type;return B.isCompressedTexture===!0||B.isVideoTexture===!0||j!==yc&&j!==Fr&&(De.getTransfer(j)===$e?(mt!==Os||ut!==is)&&ie("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ce("WebGLTextures: Unsupported texture color space:",j)),C}function ne(B){return typeof HTMLImageElement<"u"&&B instanceof HTMLImageElement?(c.width=B.naturalWidth||B.width,c.height=B.naturalHeight||B.height):typeof VideoFrame<"u"&&B instanceof VideoFrame?(c.width=B.displayWidth,c.height=B.displayHeight):(c.width=B.width,c.height=B.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=J,this.getTextureUnits=nt,this.setTextureUnits=dt,this.setTexture2D=yt,this.setTexture2DArray=xt,this.setTexture3D=Tt,this.setTextureCube=At,this.rebindTextures=Sn,this.setupRenderTarget=Ln,this.updateRenderTargetMipmap=$,this.updateMultisampleRenderTarget=se,this.setupDepthRenderbuffer=kn,this.setupFrameBufferTexture=Je,this.useMultisampledRTT=Ct,this.dispose=U}function lI(n,t){function e(i,s=Fr){let r,o=De.getTransfer(s);if(i===is)return n.UNSIGNED_BYTE;if(i===fd)return n.UNSIGNED_SHORT_4_4_4_4;if(i===pd)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Qm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===tg)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Jm)return n.BYTE;if(i===Km)return n.SHORT;if(i===al)return n.UNSIGNED_SHORT;if(i===dd)return n.INT;if(i===Ns)return n.UNSIGNED_INT;if(i===ps)return n.FLOAT;if(i===Us)return n.HALF_FLOAT;if(i===eg)return n.ALPHA;if(i===ng)return n.RGB;if(i===Os)return n.RGBA;if(i===Pr)return n.DEPTH_COMPONENT;if(i===Or)return n.DEPTH_STENCIL;if(i===md)return n.RED;if(i===gd)return n.RED_INTEGER;if(i===go)return n.RG;if(i===xd)return n.RG_INTEGER;if(i===_d)return n.RGBA_INTEGER;if(i===Wc||i===$c||i===qc||i===Xc)if(o===$e)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Wc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===$c)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===qc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Xc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Wc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===$c)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===qc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Xc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===yd||i===vd||i===bd||i===Md)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===yd)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===vd)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===bd)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Md)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Sd||i===wd||i===Ed||i===Td||i===Ad||i===Yc||i===Rd)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Sd||i===wd)return o===$e?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ed)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Td)return r.COMPRESSED_R11_EAC;if(i===Ad)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Yc)return r.COMPRESSED_RG11_EAC;if(i===Rd)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Cd||i===Pd||i===Id||i===Ld||i===Dd||i===Nd||i===Ud||i===Od||i===Fd||i===Bd||i===kd||i===zd||i===Hd||i===Gd)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Cd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Pd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Id)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ld)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Dd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Nd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ud)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Od)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Fd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Bd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===kd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===zd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Hd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Gd)return o===$e?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Vd||i===Wd||i===$d)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Vd)return o===$e?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Wd)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===$d)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===qd||i===Xd||i===jc||i===Yd)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===qd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Xd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===jc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Yd)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Zo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var cI=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,uI=`
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

}`,Ag=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Dc(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new pi({vertexShader:cI,fragmentShader:uI,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new Fc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Rg=class extends Ls{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new Ag,g={},x=e.getContextAttributes(),M=null,v=null,A=[],E=[],y=new Qt,w=null,N=null,R=new Ai;R.viewport=new bn;let L=new Ai;L.viewport=new bn;let z=[R,L],G=new ld,F=null,U=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(st){let yt=A[st];return yt===void 0&&(yt=new Ja,A[st]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(st){let yt=A[st];return yt===void 0&&(yt=new Ja,A[st]=yt),yt.getGripSpace()},this.getHand=function(st){let yt=A[st];return yt===void 0&&(yt=new Ja,A[st]=yt),yt.getHandSpace()};function D(st){let yt=E.indexOf(st.inputSource);if(yt===-1)return;let xt=A[yt];xt!==void 0&&(xt.update(st.inputSource,st.frame,c||o),xt.dispatchEvent({type:st.type,data:st.inputSource}))}function O(){s.removeEventListener("select",D),s.removeEventListener("selectstart",D),s.removeEventListener("selectend",D),s.removeEventListener("squeeze",D),s.removeEventListener("squeezestart",D),s.removeEventListener("squeezeend",D),s.removeEventListener("end",O),s.removeEventListener("inputsourceschange",Z);for(let st=0;st<A.length;st++){let yt=E[st];yt!==null&&(E[st]=null,A[st].disconnect(yt))}F=null,U=null,m.reset();for(let st in g)delete g[st];if(t.setRenderTarget(M),f=null,d=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),N!==null){let st=N.camera;st.fov=N.fov,st.zoom=N.zoom,st.updateProjectionMatrix(),N=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(st){r=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(st){a=st,i.isPresenting===!0&&ie("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(st){c=st},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(st){if(s=st,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",D),s.addEventListener("selectstart",D),s.addEventListener("selectend",D),s.addEventListener("squeeze",D),s.addEventListener("squeezestart",D),s.addEventListener("squeezeend",D),s.addEventListener("end",O),s.addEventListener("inputsourceschange",Z),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Tt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=x.stencil?Or:Pr,Tt=x.stencil?Zo:Ns);let Jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new ts(d.textureWidth,d.textureHeight,{format:Os,type:is,depthTexture:new Nr(d.textureWidth,d.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new ts(f.framebufferWidth,f.framebufferHeight,{format:Os,type:is,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Z(st){for(let yt=0;yt<st.removed.length;yt++){let xt=st.removed[yt],Tt=E.indexOf(xt);Tt>=0&&(E[Tt]=null,A[Tt].disconnect(xt))}for(let yt=0;yt<st.added.length;yt++){let xt=st.added[yt],Tt=E.indexOf(xt);if(Tt===-1){for(let Jt=0;Jt<A.length;Jt++)if(Jt>=E.length){E.push(xt),Tt=Jt;break}else if(E[Jt]===null){E[Jt]=xt,Tt=Jt;break}if(Tt===-1)break}let At=A[Tt];At&&At.connect(xt)}}function X(st,yt){yt===null?st.matrixWorld.copy(st.matrix):st.matrixWorld.multiplyMatrices(yt.matrixWorld,st.matrix),st.matrixWorldInverse.copy(st.matrixWorld).invert()}this.updateCamera=function(st){if(s===null)return;let yt=st.near,xt=st.far;m.texture!==null&&(m.depthNear>0&&(yt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),G.near=L.near=R.near=yt,G.far=L.far=R.far=xt,(F!==G.near||U!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),F=G.near,U=G.far),G.layers.mask=st.layers.mask|6,R.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Tt=st.parent,At=G.cameras;X(G,Tt);for(let Jt=0;Jt<At.length;Jt++)X(At[Jt],Tt);G.projectionMatrix.copy(R.projectionMatrix),G.projectionMatrixInverse.copy(R.projectionMatrixInverse),N===null&&st.isPerspectiveCamera&&(N={camera:st,fov:st.fov,zoom:st.zoom}),J(st,G,Tt)};function J(st,yt,xt){xt===null?st.matrix.copy(yt.matrixWorld):(st.matrix.copy(xt.matrixWorld),st.matrix.invert(),st.matrix.multiply(yt.matrixWorld)),st.matrix.decompose(st.position,st.quaternion,st.scale),st.updateMatrixWorld(!0),st.projectionMatrix.copy(yt.projectionMatrix),st.projectionMatrixInverse.copy(yt.projectionMatrixInverse),st.isPerspectiveCamera&&(st.fov=Ya*2*Math.atan(1/st.projectionMatrix.elements[5]),st.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(st){l=st,d!==null&&(d.fixedFoveation=st),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=st)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(st){return g[st]};let nt=null;function dt(st,yt){if(u=yt.getViewerPose(c||o),p=yt,u!==null){let xt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Tt=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,Tt=!0);for(let jt=0;jt<xt.length;jt++){let Te=xt[jt],Se=null;if(f!==null)Se=f.getViewport(Te);else{let xn=h.getViewSubImage(d,Te);Se=xn.viewport,jt===0&&(t.setRenderTargetTextures(v,xn.colorTexture,xn.depthStencilTexture),t.setRenderTarget(v))}let me=z[jt];me===void 0&&(me=new Ai,me.layers.enable(jt),me.viewport=new bn,z[jt]=me),me.matrix.fromArray(Te.transform.matrix),me.matrix.decompose(me.position,me.quaternion,me.scale),me.projectionMatrix.fromArray(Te.projectionMatrix),me.projectionMatrixInverse.copy(me.projectionMatrix).invert(),me.viewport.set(Se.x,Se.y,Se.width,Se.height),jt===0&&(G.matrix.copy(me.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Tt===!0&&G.cameras.push(me)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let jt=h.getDepthInformation(xt[0]);jt&&jt.isValid&&jt.texture&&m.init(jt,s.renderState)}if(At&&At.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let jt=0;jt<xt.length;jt++){let Te=xt[jt].camera;if(Te){let Se=g[Te];Se||(Se=new Dc,g[Te]=Se);let me=h.getCameraImage(Te);Se.sourceTexture=me}}}}for(let xt=0;xt<A.length;xt++){let Tt=E[xt],At=A[xt];Tt!==null&&At!==void 0&&At.update(Tt,yt,c||o)}nt&&nt(st,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),p=null}let ft=new Mv;ft.setAnimationLoop(dt),this.setAnimationLoop=function(st){nt=st},this.dispose=function(){}}},hI=new ye,Lv=new de;Lv.set(-1,0,0,0,1,0,0,0,1);function dI(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,mg(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,M,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===oi&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===oi&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=t.get(g),M=x.envMap,v=x.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(hI.makeRotationFromEuler(v)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Lv),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=M*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===oi&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function fI(n,t,e,i){let s={},r={};function o(x,M){let v=M.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,M){let v=s[x.id];v===void 0&&(p(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",m));let A=M.program;i.updateUBOMapping(x,A);let E=t.render.frame;r[x.id]!==E&&(c(x),r[x.id]=E)}function l(x){let M=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(x){let M=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let E=0,y=v.length;E<y;E++){let w=v[E];if(Array.isArray(w))for(let N=0,R=w.length;N<R;N++)u(w[N],E,N,A);else u(w,E,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,M,v,A){if(d(x,M,v,A)===!0){let E=x.__offset,y=x.value;if(Array.isArray(y)){let w=0;for(let N=0;N<y.length;N++){let R=y[N],L=_(R,!0);h(R,x.__data,w),w+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,x.__data)}}function h(x,M,v){typeof x=="number"||typeof x=="boolean"?M[v]=x:x.isMatrix3?(M[v]=x.elements[0],M[v+1]=x.elements[1],M[v+2]=x.elements[2],M[v+3]=0,M[v+4]=x.elements[3],M[v+5]=x.elements[4],M[v+6]=x.elements[5],M[v+7]=0,M[v+8]=x.elements[6],M[v+9]=x.elements[7],M[v+10]=x.elements[8],M[v+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-v),v):x.toArray(M,v)}function d(x,M,v,A){let E=x.value,y=M+"_"+v;if(Array.isArray(E)){A[y]===void 0&&(A[y]=[]);let w=A[y],N=!1;for(let R=0;R<E.length;R++)f(E[R],w,R)===!0&&(N=!0);return N}return f(E,A,y)}function f(x,M,v){if(M[v]===void 0)return typeof x=="number"||typeof x=="boolean"?M[v]=x:ArrayBuffer.isView(x)?M[v]=x.slice():M[v]=x.clone(),!0;{let A=M[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return M[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let M=x.uniforms,v=0,A=16;for(let y=0,w=M.length;y<w;y++){let N=Array.isArray(M[y])?M[y]:[M[y]];for(let R=0,L=N.length;R<L;R++){let z=N[R],G=Array.isArray(z.value)?z.value:[z.value],F=Array.isArray(M[y])||Array.isArray(z.value),U=v;for(let O=0,Z=G.length;O<Z;O++){let X=G[O],J=_(X,F),nt=v%A,dt=nt%J.boundary,ft=nt+dt;v+=dt,ft!==0&&A-ft<J.storage&&(v+=A-ft),O===0&&(U=v),v+=J.storage}let D=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new D((v-U)/Float32Array.BYTES_PER_ELEMENT),z.__offset=U}}let E=v%A;return E>0&&(v+=A-E),x.__size=v,x.__cache={},this}function _(x,M){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?ie("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):ie("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let M=x.target;M.removeEventListener("dispose",m),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var pI=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),lr=null;function mI(){return lr===null&&(lr=new Cc(pI,16,16,go,Us),lr.name="DFG_LUT",lr.minFilter=Ri,lr.magFilter=Ri,lr.wrapS=nr,lr.wrapT=nr,lr.generateMipmaps=!1,lr.needsUpdate=!0),lr}var tf=class{constructor(t={}){let{canvas:e=Xy(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=is}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,m=new Set([_d,xd,gd]),g=new Set([is,Ns,al,Zo,fd,pd]),x=new Uint32Array(4),M=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,E=null,y=[],w=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ar,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,L=!1,z=null,G=null,F=null,U=null;this._outputColorSpace=Ti;let D=0,O=0,Z=null,X=-1,J=null,nt=new bn,dt=new bn,ft=null,st=new ee(0),yt=0,xt=e.width,Tt=e.height,At=1,Jt=null,xe=null,jt=new bn(0,0,xt,Tt),Te=new bn(0,0,xt,Tt),Se=!1,me=new Vo,xn=new Wh,on=!1,In=!1,Je=new ye,Zn=new V,Ue=new bn,kn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Sn=!1;function Ln(){return Z===null?At:1}let $=i;function Nt(I,q){return e.getContext(I,q)}let se,_e,Ct,tn,Yt,ne,B,C,j,mt,ut,St,wt,rt,at,vt,W,lt,ot,Pt,Mt,Rt,Zt;try{let I={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",$t,!1),e.addEventListener("webglcontextrestored",le,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),$===null){let q="webgl2";if($=Nt(q,I),$===null)throw Nt(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ae()}catch(I){throw e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),ce("WebGLRenderer: "+I.message),I}function ae(){se=new TC($),se.init(),Mt=new lI($,se),_e=new mC($,se,t,Mt),Ct=new oI($,se),_e.reversedDepthBuffer&&d&&Ct.buffers.depth.setReversed(!0),G=$.createFramebuffer(),F=$.createFramebuffer(),U=$.createFramebuffer(),tn=new CC($),Yt=new qP,ne=new aI($,se,Ct,Yt,_e,Mt,tn),B=new EC(R),C=new IT($),Rt=new fC($,C),j=new AC($,C,tn,Rt),mt=new IC($,j,C,Rt,tn),lt=new PC($,_e,ne),at=new gC(Yt),ut=new $P(R,B,se,_e,Rt,at),St=new dI(R,Yt),wt=new YP,rt=new tI(se),W=new dC(R,B,Ct,mt,p,l),vt=new rI(R,mt,_e),Zt=new fI($,tn,_e,Ct),ot=new pC($,se,tn),Pt=new RC($,se,tn),tn.programs=ut.programs,R.capabilities=_e,R.extensions=se,R.properties=Yt,R.renderLists=wt,R.shadowMap=vt,R.state=Ct,R.info=tn}_!==is&&(N=new DC(_,e.width,e.height,a,s,r));let pt=new Rg(R,$);this.xr=pt,this.getContext=function(){return $},this.getContextAttributes=function(){return $.getContextAttributes()},this.forceContextLoss=function(){let I=se.get("WEBGL_lose_context");I&&I.loseContext()},this.forceContextRestore=function(){let I=se.get("WEBGL_lose_context");I&&I.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(I){I!==void 0&&(At=I,this.setSize(xt,Tt,!1))},this.getSize=function(I){return I.set(xt,Tt)},this.setSize=function(I,q,it=!0){if(pt.isPresenting){ie("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=I,Tt=q,e.width=Math.floor(I*At),e.height=Math.floor(q*At),it===!0&&(e.style.width=I+"px",e.style.height=q+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,I,q)},this.getDrawingBufferSize=function(I){return I.set(xt*At,Tt*At).floor()},this.setDrawingBufferSize=function(I,q,it){xt=I,Tt=q,At=it,e.width=Math.floor(I*it),e.height=Math.floor(q*it),this.setViewport(0,0,I,q)},this.setEffects=function(I){if(_===is){ce("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(I){for(let q=0;q<I.length;q++)if(I[q].isOutputPass===!0){ie("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(I||[])},this.getCurrentViewport=function(I){return I.copy(nt)},this.getViewport=function(I){return I.copy(jt)},this.setViewport=function(I,q,it,K){I.isVector4?jt.set(I.x,I.y,I.z,I.w):jt.set(I,q,it,K),Ct.viewport(nt.copy(jt).multiplyScalar(Ln()).round())},this.getScissor=function(I){return I.copy(Te)},this.setScissor=function(I,q,it,K){I.isVector4?Te.set(I.x,I.y,I.z,I.w):Te.set(I,q,it,K),Ct.scissor(dt.copy(Te).multiplyScalar(Ln()).round())},this.getScissorTest=function(){return Se},this.setScissorTest=function(I){Ct.setScissorTest(Se=I)},this.setOpaqueSort=function(I){Jt=I},this.setTransparentSort=function(I){xe=I},this.getClearColor=function(I){return I.copy(W.getClearColor())},this.setClearColor=function(){W.setClearColor(...arguments)},this.getClearAlpha=function(){return W.getClearAlpha()},this.setClearAlpha=function(){W.setClearAlpha(...arguments)},this.clear=function(I=!0,q=!0,it=!0){let K=0;if(I){let Q=!1;if(Z!==null){let It=Z.texture.format;Q=m.has(It)}if(Q){let It=Z.texture.type,Ot=g.has(It),Lt=W.getClearColor(),Bt=W.getClearAlpha(),Xt=Lt.r,ue=Lt.g,Re=Lt.b;Ot?(x[0]=Xt,x[1]=ue,x[2]=Re,x[3]=Bt,$.clearBufferuiv($.COLOR,0,x)):(M[0]=Xt,M[1]=ue,M[2]=Re,M[3]=Bt,$.clearBufferiv($.COLOR,0,M))}else K|=$.COLOR_BUFFER_BIT}q&&(K|=$.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),it&&(K|=$.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&$.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(I){I.setRenderer(this),z=I},this.dispose=function(){e.removeEventListener("webglcontextlost",$t,!1),e.removeEventListener("webglcontextrestored",le,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),W.dispose(),wt.dispose(),rt.dispose(),ne.dispose(),Yt.dispose(),B.dispose(),mt.dispose(),j.dispose(),Rt.dispose(),Zt.dispose(),ut.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",Wu),pt.removeEventListener("sessionend",Ws),gr.stop()};function $t(I){I.preventDefault(),Sc("WebGLRenderer: Context Lost."),L=!0}function le(){Sc("WebGLRenderer: Context Restored."),L=!1;let I=tn.autoReset,q=vt.enabled,it=vt.autoUpdate,K=vt.needsUpdate,Q=vt.type;ae(),tn.autoReset=I,vt.enabled=q,vt.autoUpdate=it,vt.needsUpdate=K,vt.type=Q}function Dt(I){ce("WebGLRenderer: A WebGL context could not be created. Reason: ",I.statusMessage)}function ve(I){let q=I.target;q.removeEventListener("dispose",ve),an(q)}function an(I){yi(I),Yt.remove(I)}function yi(I){let q=Yt.get(I).programs;q!==void 0&&(q.forEach(function(it){ut.releaseProgram(it)}),I.isShaderMaterial&&ut.releaseShaderCache(I))}this.renderBufferDirect=function(I,q,it,K,Q,It){q===null&&(q=kn);let Ot=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,Lt=tc(I,q,it,K,Q);Ct.setMaterial(K,Ot);let Bt=it.index,Xt=1;if(K.wireframe===!0){if(Bt=j.getWireframeAttribute(it),Bt===void 0)return;Xt=2}let ue=it.drawRange,Re=it.attributes.position,qt=ue.start*Xt,Ce=(ue.start+ue.count)*Xt;It!==null&&(qt=Math.max(qt,It.start*Xt),Ce=Math.min(Ce,(It.start+It.count)*Xt)),Bt!==null?(qt=Math.max(qt,0),Ce=Math.min(Ce,Bt.count)):Re!=null&&(qt=Math.max(qt,0),Ce=Math.min(Ce,Re.count));let vn=Ce-qt;if(vn<0||vn===1/0)return;Rt.setup(Q,K,Lt,it,Bt);let Xe,Ye=ot;if(Bt!==null&&(Xe=C.get(Bt),Ye=Pt,Ye.setIndex(Xe)),Q.isMesh)K.wireframe===!0?(Ct.setLineWidth(K.wireframeLinewidth*Ln()),Ye.setMode($.LINES)):Ye.setMode($.TRIANGLES);else if(Q.isLine){let zn=K.linewidth;zn===void 0&&(zn=1),Ct.setLineWidth(zn*Ln()),Q.isLineSegments?Ye.setMode($.LINES):Q.isLineLoop?Ye.setMode($.LINE_LOOP):Ye.setMode($.LINE_STRIP)}else Q.isPoints?Ye.setMode($.POINTS):Q.isSprite&&Ye.setMode($.TRIANGLES);if(Q.isBatchedMesh)if(se.get("WEBGL_multi_draw"))Ye.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let zn=Q._multiDrawStarts,Vt=Q._multiDrawCounts,Dn=Q._multiDrawCount,Le=Bt?C.get(Bt).bytesPerElement:1,_r=Yt.get(K).currentProgram.getUniforms();for(let Nn=0;Nn<Dn;Nn++)_r.setValue($,"_gl_DrawID",Nn),Ye.render(zn[Nn]/Le,Vt[Nn])}else if(Q.isInstancedMesh)Ye.renderInstances(qt,vn,Q.count);else if(it.isInstancedBufferGeometry){let zn=it._maxInstanceCount!==void 0?it._maxInstanceCount:1/0,Vt=Math.min(it.instanceCount,zn);Ye.renderInstances(qt,vn,Vt)}else Ye.render(qt,vn)};function Jl(I,q,it,K){z!==null&&I.isNodeMaterial&&z.setObject(K,I),on===!0&&at.setState(I,it,!1),I.transparent===!0&&I.side===mi&&I.forceSinglePass===!1?(I.side=oi,I.needsUpdate=!0,$s(I,q,K),I.side=or,I.needsUpdate=!0,$s(I,q,K),I.side=mi):$s(I,q,K)}this.compile=function(I,q,it=null){it===null&&(it=I),z!==null&&z.renderStart(I,q,it),E=rt.get(it),E.init(q),w.push(E),it.traverseVisible(function(Q){Q.isLight&&Q.layers.test(q.layers)&&(E.pushLight(Q),Q.castShadow&&E.pushShadow(Q))}),I!==it&&I.traverseVisible(function(Q){Q.isLight&&Q.layers.test(q.layers)&&(E.pushLight(Q),Q.castShadow&&E.pushShadow(Q))}),E.setupLights(),z!==null&&z.updateLights(E.state.lightsArray),In=this.localClippingEnabled,on=at.init(this.clippingPlanes,In),on===!0&&at.setGlobalState(this.clippingPlanes,q),z!==null&&vt.render(E.state.shadowsArray,it,q);let K=new Set;return I.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let It=Q.material;if(It)if(Array.isArray(It))for(let Ot=0;Ot<It.length;Ot++){let Lt=It[Ot];Jl(Lt,it,q,Q),K.add(Lt)}else Jl(It,it,q,Q),K.add(It)}),E=w.pop(),z!==null&&z.renderEnd(),K},this.compileAsync=function(I,q,it=null){let K=this.compile(I,q,it);return new Promise(Q=>{function It(){if(K.forEach(function(Ot){let Bt=Yt.get(Ot).currentProgram;(Bt===void 0||Bt.isReady())&&K.delete(Ot)}),K.size===0){Q(I);return}setTimeout(It,10)}se.get("KHR_parallel_shader_compile")!==null?It():setTimeout(It,10)})};let ma=null;function Xp(I){ma&&ma(I)}function Wu(){gr.stop()}function Ws(){gr.start()}let gr=new Mv;gr.setAnimationLoop(Xp),typeof self<"u"&&gr.setContext(self),this.setAnimationLoop=function(I){ma=I,pt.setAnimationLoop(I),I===null?gr.stop():gr.start()},pt.addEventListener("sessionstart",Wu),pt.addEventListener("sessionend",Ws),this.render=function(I,q){if(q!==void 0&&q.isCamera!==!0){ce("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;z!==null&&z.renderStart(I,q);let it=pt.enabled===!0&&pt.isPresenting===!0,K=N!==null&&(Z===null||it)&&N.begin(R,Z);if(I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),I.isScene===!0&&I.onBeforeRender(R,I,q,Z),E=rt.get(I,w.length),E.init(q),E.state.textureUnits=ne.getTextureUnits(),w.push(E),Je.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?xn.setFromArrayCamera(q):me.setFromProjectionMatrix(Je,fs,q.reversedDepth),In=this.localClippingEnabled,on=at.init(this.clippingPlanes,In),A=wt.get(I,y.length),A.init(),y.push(A),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let Ot=R.xr.getDepthSensingMesh();Ot!==null&&xr(Ot,q,-1/0,R.sortObjects)}xr(I,q,0,R.sortObjects),A.finish(),z!==null&&z.updateLights(E.state.lightsArray),R.sortObjects===!0&&A.sort(Jt,xe),Sn=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Sn&&W.addToRenderList(A,I),this.info.autoReset===!0&&this.info.reset(),on===!0&&at.beginShadows();let Q=E.state.shadowsArray;if(vt.render(Q,I,q),on===!0&&at.endShadows(),(K&&N.hasRenderPass())===!1){let Ot=A.opaque,Lt=A.transmissive;if(E.setupLights(),q.isArrayCamera){let Bt=q.cameras;if(Lt.length>0)for(let Xt=0,ue=Bt.length;Xt<ue;Xt++){let Re=Bt[Xt];ws(Ot,Lt,I,Re)}Sn&&W.render(I);for(let Xt=0,ue=Bt.length;Xt<ue;Xt++){let Re=Bt[Xt];Kl(A,I,Re,Re.viewport)}}else Lt.length>0&&ws(Ot,Lt,I,q),Sn&&W.render(I),Kl(A,I,q)}Z!==null&&O===0&&(ne.updateMultisampleRenderTarget(Z),ne.updateRenderTargetMipmap(Z)),K&&N.end(R),I.isScene===!0&&I.onAfterRender(R,I,q),Rt.resetDefaultState(),X=-1,J=null,w.pop(),w.length>0?(E=w[w.length-1],ne.setTextureUnits(E.state.textureUnits),on===!0&&at.setGlobalState(R.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,z!==null&&z.renderEnd()};function xr(I,q,it,K){if(I.visible===!1)return;if(I.layers.test(q.layers)){if(I.isGroup)it=I.renderOrder;else if(I.isLOD)I.autoUpdate===!0&&I.update(q);else if(I.isLight)E.pushLight(I),I.castShadow&&E.pushShadow(I);else if(I.isSprite){let Ot=q.isArrayCamera?xn:me;if(!I.frustumCulled||I.intersectsFrustum(Ot)){K&&Ue.setFromMatrixPosition(I.matrixWorld).applyMatrix4(Je);let Lt=mt.update(I),Bt=I.material;Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}else if(I.isMesh||I.isLine||I.isPoints){let Ot=q.isArrayCamera?xn:me;if(!I.frustumCulled||I.intersectsFrustum(Ot)){let Lt=mt.update(I),Bt=I.material;if(K&&(I.boundingSphere!==void 0?(I.boundingSphere===null&&I.computeBoundingSphere(),Ue.copy(I.boundingSphere.center)):(Lt.boundingSphere===null&&Lt.computeBoundingSphere(),Ue.copy(Lt.boundingSphere.center)),Ue.applyMatrix4(I.matrixWorld).applyMatrix4(Je)),Array.isArray(Bt)){let Xt=Lt.groups;for(let ue=0,Re=Xt.length;ue<Re;ue++){let qt=Xt[ue],Ce=Bt[qt.materialIndex];Ce&&Ce.visible&&A.push(I,Lt,Ce,it,Ue.z,qt,q)}}else Bt.visible&&A.push(I,Lt,Bt,it,Ue.z,null,q)}}}let It=I.children;for(let Ot=0,Lt=It.length;Ot<Lt;Ot++)xr(It[Ot],q,it,K)}function Kl(I,q,it,K){let{opaque:Q,transmissive:It,transparent:Ot}=I;E.setupLightsView(it),on===!0&&at.setGlobalState(R.clippingPlanes,it),K&&Ct.viewport(nt.copy(K)),Q.length>0&&wn(Q,q,it),It.length>0&&wn(It,q,it),Ot.length>0&&wn(Ot,q,it),Ct.buffers.depth.setTest(!0),Ct.buffers.depth.setMask(!0),Ct.buffers.color.setMask(!0),Ct.setPolygonOffset(!1)}function ws(I,q,it,K){if((it.isScene===!0?it.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[K.id]===void 0){let qt=se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[K.id]=new ts(1,1,{generateMipmaps:!0,type:qt?Us:is,minFilter:Ur,samples:Math.max(4,_e.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:De.workingColorSpace})}let It=E.state.transmissionRenderTarget[K.id],Ot=K.viewport||nt;It.setSize(Ot.z*R.transmissionResolutionScale,Ot.w*R.transmissionResolutionScale);let Lt=R.getRenderTarget(),Bt=R.getActiveCubeFace(),Xt=R.getActiveMipmapLevel();R.setRenderTarget(It),R.getClearColor(st),yt=R.getClearAlpha(),yt<1&&R.setClearColor(16777215,.5),R.clear(),Sn&&W.render(it);let ue=R.toneMapping;R.toneMapping=ar;let Re=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),E.setupLightsView(K),on===!0&&at.setGlobalState(R.clippingPlanes,K),wn(I,it,K),ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It),se.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Ce=0,vn=q.length;Ce<vn;Ce++){let Xe=q[Ce],{object:Ye,geometry:zn,material:Vt,group:Dn}=Xe;if(Vt.side===mi&&Ye.layers.test(K.layers)){let Le=Vt.side;Vt.side=oi,Vt.needsUpdate=!0,Cn(Ye,it,K,zn,Vt,Dn),Vt.side=Le,Vt.needsUpdate=!0,qt=!0}}qt===!0&&(ne.updateMultisampleRenderTarget(It),ne.updateRenderTargetMipmap(It))}R.setRenderTarget(Lt,Bt,Xt),R.setClearColor(st,yt),Re!==void 0&&(K.viewport=Re),R.toneMapping=ue}function wn(I,q,it){let K=q.isScene===!0?q.overrideMaterial:null;for(let Q=0,It=I.length;Q<It;Q++){let Ot=I[Q],{object:Lt,geometry:Bt,group:Xt}=Ot,ue=Ot.material;ue.allowOverride===!0&&K!==null&&(ue=K),Lt.layers.test(it.layers)&&Cn(Lt,q,it,Bt,ue,Xt)}}function Cn(I,q,it,K,Q,It){z!==null&&Q.isNodeMaterial&&z.setObject(I,Q),I.onBeforeRender(R,q,it,K,Q,It),I.modelViewMatrix.multiplyMatrices(it.matrixWorldInverse,I.matrixWorld),I.normalMatrix.getNormalMatrix(I.modelViewMatrix),Q.onBeforeRender(R,q,it,K,I,It),Q.transparent===!0&&Q.side===mi&&Q.forceSinglePass===!1?(Q.side=oi,Q.needsUpdate=!0,R.renderBufferDirect(it,q,K,Q,I,It),Q.side=or,Q.needsUpdate=!0,R.renderBufferDirect(it,q,K,Q,I,It),Q.side=mi):R.renderBufferDirect(it,q,K,Q,I,It),I.onAfterRender(R,q,it,K,Q,It)}function Pn(I){let q=0;for(let it of I)it.texture!==null&&q++;return q}function $s(I,q,it){q.isScene!==!0&&(q=kn);let K=Yt.get(I),Q=E.state.lights,It=E.state.shadowsArray,Ot=Q.state.version,Lt=ut.getParameters(I,Q.state,It,q,it,E.state.lightProbeGridArray),Bt=ut.getProgramCacheKey(Lt),Xt=K.programs;K.environment=I.isMeshStandardMaterial||I.isMeshLambertMaterial||I.isMeshPhongMaterial?q.environment:null,K.fog=q.fog;let ue=I.isMeshStandardMaterial||I.isMeshLambertMaterial&&!I.envMap||I.isMeshPhongMaterial&&!I.envMap;K.envMap=B.get(I.envMap||K.environment,ue),K.envMapRotation=K.environment!==null&&I.envMap===null?q.environmentRotation:I.envMapRotation,Xt===void 0&&(I.addEventListener("dispose",ve),Xt=new Map,K.programs=Xt,K.programVariants=new Map);let Re=Xt.get(Bt);if(Re!==void 0){if(K.currentProgram===Re&&K.lightsStateVersion===Ot)return Ql(I,Lt),Re}else Lt.uniforms=ut.getUniforms(I),z!==null&&I.isNodeMaterial&&z.build(I,it,Lt),I.onBeforeCompile(Lt,R),Re=ut.acquireProgram(Lt,Bt),Xt.set(Bt,Re),K.uniforms=Lt.uniforms;let qt=K.uniforms;return(!I.isShaderMaterial&&!I.isRawShaderMaterial||I.clipping===!0)&&(qt.clippingPlanes=at.uniform),Ql(I,Lt),K.needsLights=Zr(I),K.lightsStateVersion=Ot,K.needsLights&&(qt.ambientLightColor.value=Q.state.ambient,qt.lightProbe.value=Q.state.probe,qt.sunLights.value=Q.state.sun,qt.sunLightShadows.value=Q.state.sunShadow,qt.directionalLights.value=Q.state.directional,qt.directionalLightShadows.value=Q.state.directionalShadow,qt.spotLights.value=Q.state.spot,qt.spotLightShadows.value=Q.state.spotShadow,qt.rectAreaLights.value=Q.state.rectArea,qt.ltc_1.value=Q.state.rectAreaLTC1,qt.ltc_2.value=Q.state.rectAreaLTC2,qt.pointLights.value=Q.state.point,qt.pointLightShadows.value=Q.state.pointShadow,qt.hemisphereLights.value=Q.state.hemi,qt.sunShadowMatrix.value=Q.state.sunShadowMatrix,qt.sunShadowCascade.value=Q.state.sunShadowCascade,qt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,qt.spotLightMatrix.value=Q.state.spotLightMatrix,qt.spotLightMap.value=Q.state.spotLightMap,qt.pointShadowMatrix.value=Q.state.pointShadowMatrix),K.numLightProbeGrids=Pn(E.state.lightProbeGridArray),K.currentProgram=Re,K.uniformsList=null,Re}function Xi(I,q,it,K,Q){let It=Yt.get(I),Ot=It.currentProgram.id+","+K+","+Q,Lt=It.programVariants.get(Ot);return Lt===void 0?(Lt=$s(I,q,it),It.programVariants.set(Ot,Lt)):(It.currentProgram=Lt,It.uniformsList=null,It.outputColorSpace=K,It.toneMapping=Q),Lt}function jr(I){if(I.uniformsList===null){let q=I.currentProgram.getUniforms();I.uniformsList=ll.seqWithValue(q.seq,I.uniforms)}return I.uniformsList}function Ql(I,q){let it=Yt.get(I);it.outputColorSpace=q.outputColorSpace,it.batching=q.batching,it.batchingColor=q.batchingColor,it.instancing=q.instancing,it.instancingColor=q.instancingColor,it.instancingMorph=q.instancingMorph,it.skinning=q.skinning,it.morphTargets=q.morphTargets,it.morphNormals=q.morphNormals,it.morphColors=q.morphColors,it.morphTargetsCount=q.morphTargetsCount,it.numClippingPlanes=q.numClippingPlanes,it.numIntersection=q.numClipIntersection,it.vertexAlphas=q.vertexAlphas,it.vertexTangents=q.vertexTangents,it.toneMapping=q.toneMapping}function tc(I,q,it,K,Q){q.isScene!==!0&&(q=kn),ne.resetTextureUnits();let It=q.fog,Ot=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?q.environment:null,Lt=Z===null?R.outputColorSpace:Z.isXRRenderTarget===!0?Z.texture.colorSpace:De.workingColorSpace,Bt=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Xt=B.get(K.envMap||Ot,Bt),ue=K.vertexColors===!0&&!!it.attributes.color&&it.attributes.color.itemSize===4,Re=!!it.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),qt=!!it.morphAttributes.position,Ce=!!it.morphAttributes.normal,vn=!!it.morphAttributes.color,Xe=ar;K.toneMapped&&(Z===null||Z.isXRRenderTarget===!0)&&(Xe=R.toneMapping);let Ye=it.morphAttributes.position||it.morphAttributes.normal||it.morphAttributes.color,zn=Ye!==void 0?Ye.length:0,Vt=Yt.get(K),Dn=E.state.lights;if(on===!0&&(In===!0||I!==J)){let je=I===J&&K.id===X;at.setState(K,I,je)}let Le=!1,_r=!1;K.version===Vt.__version?Vt.needsLights&&Vt.lightsStateVersion!==Dn.state.version||Q.isBatchedMesh&&Vt.batching===!1||!Q.isBatchedMesh&&Vt.batching===!0||Q.isBatchedMesh&&Vt.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Vt.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Vt.instancing===!1||!Q.isInstancedMesh&&Vt.instancing===!0||Q.isSkinnedMesh&&Vt.skinning===!1||!Q.isSkinnedMesh&&Vt.skinning===!0||Q.isInstancedMesh&&Vt.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Vt.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Vt.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Vt.instancingMorph===!1&&Q.morphTexture!==null||Vt.envMap!==Xt||K.fog===!0&&Vt.fog!==It||Vt.numClippingPlanes!==void 0&&(Vt.numClippingPlanes!==at.numPlanes||Vt.numIntersection!==at.numIntersection)||Vt.vertexAlphas!==ue||Vt.vertexTangents!==Re||Vt.morphTargets!==qt||Vt.morphNormals!==Ce||Vt.morphColors!==vn||Vt.morphTargetsCount!==zn||Vt.numLightProbeGrids!==Pn(E.state.lightProbeGridArray)?Le=!0:(Vt.outputColorSpace!==Lt||Vt.toneMapping!==Xe)&&(_r=!0):(Le=!0,Vt.__version=K.version);let Nn=Vt.currentProgram;(Le===!0||_r===!0)&&(Nn=_r===!0?Xi(K,q,Q,Lt,Xe):$s(K,q,Q),z&&K.isNodeMaterial&&z.onUpdateProgram(K,Nn,Vt));let _a=!1,qs=!1,yr=!1,we=Nn.getUniforms(),En=Vt.uniforms;if(Ct.useProgram(Nn.program)&&(_a=!0,qs=!0,yr=!0),K.id!==X&&(X=K.id,qs=!0),_a||J!==I){Ct.buffers.depth.getReversed()&&I.reversedDepth!==!0&&(I._reversedDepth=!0,I.updateProjectionMatrix()),we.setValue($,"projectionMatrix",I.projectionMatrix),we.setValue($,"viewMatrix",I.matrixWorldInverse);let Un=we.map.cameraPosition;Un!==void 0&&Un.setValue($,Zn.setFromMatrixPosition(I.matrixWorld)),_e.logarithmicDepthBuffer&&we.setValue($,"logDepthBufFC",2/(Math.log(I.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&we.setValue($,"isOrthographic",I.isOrthographicCamera===!0),J!==I&&(J=I,qs=!0,yr=!0)}if(Vt.needsLights&&(Dn.state.sunShadowMap.length>0&&we.setValue($,"sunShadowMap",Dn.state.sunShadowMap,ne),Dn.state.directionalShadowMap.length>0&&we.setValue($,"directionalShadowMap",Dn.state.directionalShadowMap,ne),Dn.state.spotShadowMap.length>0&&we.setValue($,"spotShadowMap",Dn.state.spotShadowMap,ne),Dn.state.pointShadowMap.length>0&&we.setValue($,"pointShadowMap",Dn.state.pointShadowMap,ne)),Q.isSkinnedMesh){we.setOptional($,Q,"bindMatrix"),we.setOptional($,Q,"bindMatrixInverse");let je=Q.skeleton;je&&(je.boneTexture===null&&je.computeBoneTexture(),we.setValue($,"boneTexture",je.boneTexture,ne))}Q.isBatchedMesh&&(we.setOptional($,Q,"batchingTexture"),we.setValue($,"batchingTexture",Q._matricesTexture,ne),we.setOptional($,Q,"batchingIdTexture"),we.setValue($,"batchingIdTexture",Q._indirectTexture,ne),we.setOptional($,Q,"batchingColorTexture"),Q._colorsTexture!==null&&we.setValue($,"batchingColorTexture",Q._colorsTexture,ne));let vi=it.morphAttributes;if((vi.position!==void 0||vi.normal!==void 0||vi.color!==void 0)&&lt.update(Q,it,Nn),(qs||Vt.receiveShadow!==Q.receiveShadow)&&(Vt.receiveShadow=Q.receiveShadow,we.setValue($,"receiveShadow",Q.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&q.environment!==null&&(En.envMapIntensity.value=q.environmentIntensity),En.dfgLUT!==void 0&&(En.dfgLUT.value=mI()),qs){if(we.setValue($,"toneMappingExposure",R.toneMappingExposure),Vt.needsLights&&ga(En,yr),It&&K.fog===!0&&St.refreshFogUniforms(En,It),St.refreshMaterialUniforms(En,K,At,Tt,E.state.transmissionRenderTarget[I.id]),Vt.needsLights&&Vt.numLightProbeGrids>0){let je=v,Un=0;for(let ui of E.state.lightProbeGridArray)ui.texture!==null&&(je.textures[Un]=ui.texture,je.min[Un]=ui.boundingBox.min,je.max[Un]=ui.boundingBox.max,je.resolution[Un]=ui.resolution,Un++);for(let ui in je)je[ui].length=Un;En.probesSH.value=je.textures,En.probesMin.value=je.min,En.probesMax.value=je.max,En.probesResolution.value=je.resolution}ll.upload($,jr(Vt),En,ne)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(ll.upload($,jr(Vt),En,ne),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&we.setValue($,"center",Q.center),we.setValue($,"modelViewMatrix",Q.modelViewMatrix),we.setValue($,"normalMatrix",Q.normalMatrix),we.setValue($,"modelMatrix",Q.matrixWorld),K.uniformsGroups!==void 0){let je=K.uniformsGroups;for(let Un=0,ui=je.length;Un<ui;Un++){let $u=je[Un];Zt.update($u,Nn),Zt.bind($u,Nn)}}return Nn}function ga(I,q){I.ambientLightColor.needsUpdate=q,I.lightProbe.needsUpdate=q,I.sunLights.needsUpdate=q,I.sunLightShadows.needsUpdate=q,I.directionalLights.needsUpdate=q,I.directionalLightShadows.needsUpdate=q,I.pointLights.needsUpdate=q,I.pointLightShadows.needsUpdate=q,I.spotLights.needsUpdate=q,I.spotLightShadows.needsUpdate=q,I.rectAreaLights.needsUpdate=q,I.hemisphereLights.needsUpdate=q}function Zr(I){return I.isMeshLambertMaterial||I.isMeshToonMaterial||I.isMeshPhongMaterial||I.isMeshStandardMaterial||I.isShadowMaterial||I.isShaderMaterial&&I.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return Z},this.setRenderTargetTextures=function(I,q,it){let K=Yt.get(I);K.__autoAllocateDepthBuffer=I.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Yt.get(I.texture).__webglTexture=q,Yt.get(I.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:it,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(I,q){let it=Yt.get(I);it.__webglFramebuffer=q,it.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(I,q=0,it=0){Z=I,D=q,O=it;let K=null,Q=!1,It=!1;if(I){let Lt=Yt.get(I);if(Lt.__useDefaultFramebuffer!==void 0){Ct.bindFramebuffer($.FRAMEBUFFER,Lt.__webglFramebuffer),nt.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest,Ct.viewport(nt),Ct.scissor(dt),Ct.setScissorTest(ft),X=-1;return}else if(Lt.__webglFramebuffer===void 0)ne.setupRenderTarget(I);else if(Lt.__hasExternalTextures)ne.rebindTextures(I,Yt.get(I.texture).__webglTexture,Yt.get(I.depthTexture).__webglTexture);else if(I.depthBuffer){let ue=I.depthTexture;if(Lt.__boundDepthTexture!==ue){if(ue!==null&&Yt.has(ue)&&(I.width!==ue.image.width||I.height!==ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ne.setupDepthRenderbuffer(I)}}let Bt=I.texture;(Bt.isData3DTexture||Bt.isDataArrayTexture||Bt.isCompressedArrayTexture)&&(It=!0);let Xt=Yt.get(I).__webglFramebuffer;I.isWebGLCubeRenderTarget?(Array.isArray(Xt[q])?K=Xt[q][it]:K=Xt[q],Q=!0):I.samples>0&&ne.useMultisampledRTT(I)===!1?K=Yt.get(I).__webglMultisampledFramebuffer:Array.isArray(Xt)?K=Xt[it]:K=Xt,nt.copy(I.viewport),dt.copy(I.scissor),ft=I.scissorTest}else nt.copy(jt).multiplyScalar(At).floor(),dt.copy(Te).multiplyScalar(At).floor(),ft=Se;if(it!==0&&(K=G),Ct.bindFramebuffer($.FRAMEBUFFER,K)&&Ct.drawBuffers(I,K),Ct.viewport(nt),Ct.scissor(dt),Ct.setScissorTest(ft),Q){let Lt=Yt.get(I.texture);$.framebufferTexture2D($.FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_CUBE_MAP_POSITIVE_X+q,Lt.__webglTexture,it)}else if(It){let Lt=q;for(let Bt=0;Bt<I.textures.length;Bt++){let Xt=Yt.get(I.textures[Bt]);$.framebufferTextureLayer($.FRAMEBUFFER,$.COLOR_ATTACHMENT0+Bt,Xt.__webglTexture,it,Lt)}}else if(I!==null&&it!==0){let Lt=Yt.get(I.texture);$.framebufferTexture2D($.FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,Lt.__webglTexture,it)}X=-1};function xa(I){let q=Yt.get(I);return(q.__readFormat!==I.format||q.__readType!==I.type)&&(q.__readFormat=I.format,q.__readType=I.type,q.__formatReadable=_e.textureFormatReadable(I.format),q.__typeReadable=_e.textureTypeReadable(I.type)),q}this.readRenderTargetPixels=function(I,q,it,K,Q,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget)){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt){Ct.bindFramebuffer($.FRAMEBUFFER,Bt);try{let Xt=I.textures[Lt],ue=Xt.format,Re=Xt.type;I.textures.length>1&&$.readBuffer($.COLOR_ATTACHMENT0+Lt);let qt=xa(Xt);if(qt.__formatReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(qt.__typeReadable===!1){ce("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=I.width-K&&it>=0&&it<=I.height-Q&&$.readPixels(q,it,K,Q,Mt.convert(ue),Mt.convert(Re),It)}finally{let Xt=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer($.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(I,q,it,K,Q,It,Ot,Lt=0){if(!(I&&I.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Yt.get(I).__webglFramebuffer;if(I.isWebGLCubeRenderTarget&&Ot!==void 0&&(Bt=Bt[Ot],Array.isArray(Bt)&&(Bt=Bt[0])),Bt)if(q>=0&&q<=I.width-K&&it>=0&&it<=I.height-Q){Ct.bindFramebuffer($.FRAMEBUFFER,Bt);let Xt=I.textures[Lt],ue=Xt.format,Re=Xt.type;I.textures.length>1&&$.readBuffer($.COLOR_ATTACHMENT0+Lt);let qt=xa(Xt);if(qt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(qt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ce=$.createBuffer();$.bindBuffer($.PIXEL_PACK_BUFFER,Ce),$.bufferData($.PIXEL_PACK_BUFFER,It.byteLength,$.STREAM_READ),$.readPixels(q,it,K,Q,Mt.convert(ue),Mt.convert(Re),0),$.bindBuffer($.PIXEL_PACK_BUFFER,null);let vn=Z!==null?Yt.get(Z).__webglFramebuffer:null;Ct.bindFramebuffer($.FRAMEBUFFER,vn);let Xe=$.fenceSync($.SYNC_GPU_COMMANDS_COMPLETE,0);return $.flush(),await jy($,Xe,4),$.bindBuffer($.PIXEL_PACK_BUFFER,Ce),$.getBufferSubData($.PIXEL_PACK_BUFFER,0,It),$.bindBuffer($.PIXEL_PACK_BUFFER,null),$.deleteBuffer(Ce),$.deleteSync(Xe),It}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(I,q=null,it=0){let K=Math.pow(2,-it),Q=Math.floor(I.image.width*K),It=Math.floor(I.image.height*K),Ot=q!==null?q.x:0,Lt=q!==null?q.y:0;ne.setTexture2D(I,0),$.copyTexSubImage2D($.TEXTURE_2D,it,0,0,Ot,Lt,Q,It),Ct.unbindTexture()},this.copyTextureToTexture=function(I,q,it=null,K=null,Q=0,It=0){let Ot,Lt,Bt,Xt,ue,Re,qt,Ce,vn,Xe=I.isCompressedTexture?I.mipmaps[It]:I.image;if(it!==null)Ot=it.max.x-it.min.x,Lt=it.max.y-it.min.y,Bt=it.isBox3?it.max.z-it.min.z:1,Xt=it.min.x,ue=it.min.y,Re=it.isBox3?it.min.z:0;else{let we=Math.pow(2,-Q);Ot=Math.floor(Xe.width*we),Lt=Math.floor(Xe.height*we),I.isDataArrayTexture?Bt=Xe.depth:I.isData3DTexture?Bt=Math.floor(Xe.depth*we):Bt=1,Xt=0,ue=0,Re=0}K!==null?(qt=K.x,Ce=K.y,vn=K.z):(qt=0,Ce=0,vn=0);let Ye=Mt.convert(q.format),zn=Mt.convert(q.type),Vt;q.isData3DTexture?(ne.setTexture3D(q,0),Vt=$.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(ne.setTexture2DArray(q,0),Vt=$.TEXTURE_2D_ARRAY):(ne.setTexture2D(q,0),Vt=$.TEXTURE_2D),Ct.activeTexture($.TEXTURE0),Ct.pixelStorei($.UNPACK_FLIP_Y_WEBGL,q.flipY),Ct.pixelStorei($.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ct.pixelStorei($.UNPACK_ALIGNMENT,q.unpackAlignment);let Dn=Ct.getParameter($.UNPACK_ROW_LENGTH),Le=Ct.getParameter($.UNPACK_IMAGE_HEIGHT),_r=Ct.getParameter($.UNPACK_SKIP_PIXELS),Nn=Ct.getParameter($.UNPACK_SKIP_ROWS),_a=Ct.getParameter($.UNPACK_SKIP_IMAGES);Ct.pixelStorei($.UNPACK_ROW_LENGTH,Xe.width),Ct.pixelStorei($.UNPACK_IMAGE_HEIGHT,Xe.height),Ct.pixelStorei($.UNPACK_SKIP_PIXELS,Xt),Ct.pixelStorei($.UNPACK_SKIP_ROWS,ue),Ct.pixelStorei($.UNPACK_SKIP_IMAGES,Re);let qs=I.isDataArrayTexture||I.isData3DTexture,yr=q.isDataArrayTexture||q.isData3DTexture;if(I.isDepthTexture){let we=Yt.get(I),En=Yt.get(q),vi=Yt.get(we.__renderTarget),je=Yt.get(En.__renderTarget);Ct.bindFramebuffer($.READ_FRAMEBUFFER,vi.__webglFramebuffer),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,je.__webglFramebuffer);for(let Un=0;Un<Bt;Un++)qs&&($.framebufferTextureLayer($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Yt.get(I).__webglTexture,Q,Re+Un),$.framebufferTextureLayer($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,Yt.get(q).__webglTexture,It,vn+Un)),$.blitFramebuffer(Xt,ue,Xt+Ot,ue+Lt,qt,Ce,qt+Ot,Ce+Lt,$.DEPTH_BUFFER_BIT,$.NEAREST);Ct.bindFramebuffer($.READ_FRAMEBUFFER,null),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,null)}else if(Q!==0||I.isRenderTargetTexture||Yt.has(I)){let we=Yt.get(I),En=Yt.get(q);Ct.bindFramebuffer($.READ_FRAMEBUFFER,F),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,U);for(let vi=0;vi<Bt;vi++)qs?$.framebufferTextureLayer($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,we.__webglTexture,Q,Re+vi):$.framebufferTexture2D($.READ_FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,we.__webglTexture,Q),yr?$.framebufferTextureLayer($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,En.__webglTexture,It,vn+vi):$.framebufferTexture2D($.DRAW_FRAMEBUFFER,$.COLOR_ATTACHMENT0,$.TEXTURE_2D,En.__webglTexture,It),Q!==0?$.blitFramebuffer(Xt,ue,Xt+Ot,ue+Lt,qt,Ce,qt+Ot,Ce+Lt,$.COLOR_BUFFER_BIT,$.NEAREST):yr?$.copyTexSubImage3D(Vt,It,qt,Ce,vn+vi,Xt,ue,Ot,Lt):$.copyTexSubImage2D(Vt,It,qt,Ce,Xt,ue,Ot,Lt);Ct.bindFramebuffer($.READ_FRAMEBUFFER,null),Ct.bindFramebuffer($.DRAW_FRAMEBUFFER,null)}else yr?I.isDataTexture||I.isData3DTexture?$.texSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,zn,Xe.data):q.isCompressedArrayTexture?$.compressedTexSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,Xe.data):$.texSubImage3D(Vt,It,qt,Ce,vn,Ot,Lt,Bt,Ye,zn,Xe):I.isDataTexture?$.texSubImage2D($.TEXTURE_2D,It,qt,Ce,Ot,Lt,Ye,zn,Xe.data):I.isCompressedTexture?$.compressedTexSubImage2D($.TEXTURE_2D,It,qt,Ce,Xe.width,Xe.height,Ye,Xe.data):$.texSubImage2D($.TEXTURE_2D,It,qt,Ce,Ot,Lt,Ye,zn,Xe);Ct.pixelStorei($.UNPACK_ROW_LENGTH,Dn),Ct.pixelStorei($.UNPACK_IMAGE_HEIGHT,Le),Ct.pixelStorei($.UNPACK_SKIP_PIXELS,_r),Ct.pixelStorei($.UNPACK_SKIP_ROWS,Nn),Ct.pixelStorei($.UNPACK_SKIP_IMAGES,_a),It===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&$.generateMipmap(Vt),Ct.unbindTexture()},this.initRenderTarget=function(I){Yt.get(I).__webglFramebuffer===void 0&&ne.setupRenderTarget(I)},this.initTexture=function(I){I.isCubeTexture?ne.setTextureCube(I,0):I.isData3DTexture?ne.setTexture3D(I,0):I.isDataArrayTexture||I.isCompressedArrayTexture?ne.setTexture2DArray(I,0):ne.setTexture2D(I,0),Ct.unbindTexture()},this.resetState=function(){D=0,O=0,Z=null,Ct.reset(),Rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return fs}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=De._getDrawingBufferColorSpace(t),e.unpackColorSpace=De._getUnpackColorSpace()}};var sf={about:"One identity for the workbench, reports, figures and the site; read by document/identity.py and the page's build.",wordmark:"pieper",type:{sans:'"Inter Variable", Inter, system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif',serif:'"Source Serif 4", "Iowan Old Style", "Palatino Linotype", Palatino, "Noto Serif", Georgia, serif',mono:'ui-monospace, "SFMono-Regular", "JetBrains Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace'},light:{colours:{paper:"#ffffff",panel:"#ffffff",ground:"#f3f4f6",soft:"#f0f2f5",softer:"#f7f8fa",ink:"#171c24",muted:"#566070",line:"#dde1e7",edge:"#8891a0",accent:"#c2410c",accentInk:"#b03a08",accentSoft:"#fdeee6",onAccent:"#ffffff",good:"#1a7f4b",wrong:"#b42318",wrongSoft:"#fdecea",onWrong:"#ffffff",link:"#d5d9e0",joint:"#39424f",ghost:"#5b6b84",trace:"#0072b2",gridFine:"#e3e6eb",gridCoarse:"#cfd4dc"},curves:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"]},dark:{colours:{paper:"#12151a",panel:"#171b21",ground:"#101318",soft:"#222831",softer:"#1c2128",ink:"#e9ecf1",muted:"#a3acba",line:"#2b323c",edge:"#6d7787",accent:"#ff8a4c",accentInk:"#ff9d68",accentSoft:"#3a2419",onAccent:"#1a0f08",good:"#4cc38a",wrong:"#ff8f85",wrongSoft:"#3a1d1b",onWrong:"#2a0b08",link:"#9aa5b5",joint:"#4d5969",ghost:"#8fa6c8",trace:"#56b4e9",gridFine:"#1b2027",gridCoarse:"#2a313b"},curves:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},axes:["#d55e00","#009e73","#0072b2"]};var Ft={},xI=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],Dv=matchMedia("(prefers-color-scheme: dark)");function rf(){let n=b.theme==="dark"||b.theme==="auto"&&Dv.matches;document.documentElement.dataset.theme=n?"dark":"light",document.documentElement.style.setProperty("--text-size",String(tu()));let t=getComputedStyle(document.documentElement);for(let e of xI)Ft[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Ft.dark=n,Ft.curves=sf[n?"dark":"light"].curves}function of(n){b.theme=n,rf(),ct("theme")}var Nv="pieper-text-size";function tu(){let n=Number(localStorage.getItem(Nv));return n>=.5&&n<=3?n:1}function Uv(n){document.documentElement.style.setProperty("--text-size",String(n));try{localStorage.setItem(Nv,String(n))}catch{}ct("theme"),dispatchEvent(new Event("resize"))}Dv.addEventListener("change",()=>{b.theme==="auto"&&(rf(),ct("theme"))});var Ov={type:"change"},Pg={type:"start"},Bv={type:"end"},af=new Lr,Fv=new ri,_I=Math.cos(70*_o.DEG2RAD),qn=new V,Gi=2*Math.PI,Ve={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Cg=1e-6,lf=class extends Hc{constructor(t,e=null){super(t,e),this.state=Ve.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:po.ROTATE,MIDDLE:po.DOLLY,RIGHT:po.PAN},this.touches={ONE:mo.ROTATE,TWO:mo.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new fn,this._lastTargetPosition=new V,this._quat=new fn().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new il,this._sphericalDelta=new il,this._scale=1,this._panOffset=new V,this._rotateStart=new Qt,this._rotateEnd=new Qt,this._rotateDelta=new Qt,this._panStart=new Qt,this._panEnd=new Qt,this._panDelta=new Qt,this._dollyStart=new Qt,this._dollyEnd=new Qt,this._dollyDelta=new Qt,this._dollyDirection=new V,this._mouse=new Qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=vI.bind(this),this._onPointerDown=yI.bind(this),this._onPointerUp=bI.bind(this),this._onContextMenu=RI.bind(this),this._onMouseWheel=wI.bind(this),this._onKeyDown=EI.bind(this),this._onTouchStart=TI.bind(this),this._onTouchMove=AI.bind(this),this._onMouseDown=MI.bind(this),this._onMouseMove=SI.bind(this),this._interceptControlDown=CI.bind(this),this._interceptControlUp=PI.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ve.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ov),this.update(),this.state=Ve.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;qn.copy(e).sub(this.target),qn.applyQuaternion(this._quat),this._spherical.setFromVector3(qn),this.autoRotate&&this.state===Ve.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Gi:i>Math.PI&&(i-=Gi),s<-Math.PI?s+=Gi:s>Math.PI&&(s-=Gi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(qn.setFromSpherical(this._spherical),qn.applyQuaternion(this._quatInverse),e.copy(this.target).add(qn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=qn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=qn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(af.origin.copy(this.object.position),af.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(af.direction))<_I?this.object.lookAt(this.target):(Fv.setFromNormalAndCoplanarPoint(this.object.up,this.target),af.intersectPlane(Fv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Cg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Cg||this._lastTargetPosition.distanceToSquared(this.target)>Cg?(this.dispatchEvent(Ov),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Gi/60*this.autoRotateSpeed*t:Gi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){qn.setFromMatrixColumn(e,0),qn.multiplyScalar(-t),this._panOffset.add(qn)}_panUp(t,e){this.screenSpacePanning===!0?qn.setFromMatrixColumn(e,1):(qn.setFromMatrixColumn(e,0),qn.crossVectors(this.object.up,qn)),qn.multiplyScalar(t),this._panOffset.add(qn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;qn.copy(s).sub(this.target);let r=qn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Gi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function yI(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function vI(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function bI(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Bv),this.state=Ve.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function MI(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case po.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ve.DOLLY;break;case po.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ve.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ve.ROTATE}break;case po.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ve.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ve.PAN}break;default:this.state=Ve.NONE}this.state!==Ve.NONE&&this.dispatchEvent(Pg)}function SI(n){switch(this.state){case Ve.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ve.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ve.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function wI(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ve.NONE||(n.preventDefault(),this.dispatchEvent(Pg),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Bv))}function EI(n){this.enabled!==!1&&this._handleKeyDown(n)}function TI(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case mo.ROTATE:if(this.enableRotate===!1){this.state=Ve.NONE;break}this._handleTouchStartRotate(n),this.state=Ve.TOUCH_ROTATE;break;case mo.PAN:if(this.enablePan===!1){this.state=Ve.NONE;break}this._handleTouchStartPan(n),this.state=Ve.TOUCH_PAN;break;default:this.state=Ve.NONE}break;case 2:switch(this.touches.TWO){case mo.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ve.TOUCH_DOLLY_PAN;break;case mo.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ve.TOUCH_DOLLY_ROTATE;break;default:this.state=Ve.NONE}break;default:this.state=Ve.NONE}this.state!==Ve.NONE&&this.dispatchEvent(Pg)}function AI(n){switch(this._trackPointer(n),this.state){case Ve.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ve.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ve.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ve.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ve.NONE}}function RI(n){this.enabled!==!1&&n.preventDefault()}function CI(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function PI(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var kv=[1,.75,.55,.42],II=30,LI=17,DI=400,zv=6e6;function Hv(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var cf=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(zv/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>II&&this.level<kv.length-1?this.level+=1:i<LI&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*kv[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(zv/this.area),.5))),this.draw()},DI)}};var Wv=32,$v={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},en=new Tc,Ie=new Ai(Wv,1,.01,100);Ie.up.set(0,0,1);var ss,pn,ms,uf,Ig=!1,qv=!1,Dg=0;function fe(){Ig||!qv||(Ig=!0,requestAnimationFrame(Xv))}function Xv(n=performance.now()){Ig=!1,uf.moving(n),Ng()}var Yv=[],hf=n=>Yv.push(n);function Ng(){for(let n of Yv)n();ss.render(en,Ie),Dg+=1}function jv(){qv=!0,fe()}function ul(n){return Ng(),n(ss.domElement)}var Zv=()=>Dg,Jv=()=>!!uf?.software;en.fog=new Ec("#fff",1,10);function Gv(n){let t=document.createElement("canvas");t.width=ms.clientWidth||1,t.height=ms.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>NI.has(s)?i(s):null,e}var NI=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function Kv(n){ms=n;let t=Gv(!1),e=Hv(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=Gv(!0)),ss=new tf({canvas:t.canvas,context:t}),ss.debug.checkShaderErrors=!1,uf=new cf(e,ss,Ng,i=>ct("hurry",i)),ss.domElement.setAttribute("aria-hidden","true"),ms.append(ss.domElement),pn=new lf(Ie,ss.domElement),pn.enableDamping=!1,pn.addEventListener("change",fe),pn.addEventListener("end",()=>{hl=!Og(),hr=null}),new ResizeObserver(UI).observe(ms),ms.tabIndex=0,ms.setAttribute("role","application"),ms.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ms.addEventListener("keydown",OI)}function UI(){let n=ms.clientWidth,t=ms.clientHeight;!n||!t||(uf.resized(n,t),ss.setSize(n,t),Ie.aspect=n/t,Ie.updateProjectionMatrix(),Dg?Xv():fe(),BI()||dl())}function OI(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)FI(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")Vv(1/1.15);else if(n.key==="-")Vv(1.15);else if(n.key.toLowerCase()==="f")df(Ko);else if(e)Ug(e);else return;n.preventDefault()}function FI(n,t){let e=Ie.position.clone().sub(pn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Ie.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(pn.target),pn.update(),fe()}function Vv(n){Ie.position.sub(pn.target).multiplyScalar(n).add(pn.target),pn.update(),fe()}var Ko=[[0,0,0],[0,0,1]];function Qv(n,t){let e=new zi().setFromPoints(n.map(u=>new V(...u))),i=e.getCenter(new V),s=new V(...t).normalize(),r=new V().crossVectors(Ie.up,s).normalize(),o=new V().crossVectors(s,r),a=Math.tan(_o.degToRad(Wv/2))*.8,l=a*Ie.aspect,c=e.getSize(new V).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,p=1/0,_=-1/0;for(let m of n){let g=new V(...m).sub(i),x=g.dot(r),M=g.dot(o),v=g.dot(s);h=Math.max(h,v+Math.abs(x)/l,v+Math.abs(M)/a),d=Math.min(d,M),f=Math.max(f,M),p=Math.min(p,x),_=Math.max(_,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(p+_)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var Lg=0;function eu({target:n,position:t},e=.35){let i={t:pn.target.clone(),p:Ie.position.clone()},s=performance.now(),r=++Lg,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==Lg)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);pn.target.lerpVectors(i.t,n,u),Ie.position.lerpVectors(i.p,t,u);let h=Ie.position.distanceTo(pn.target);Ie.near=h/100,Ie.far=h*30,en.fog.near=h*1.3,en.fog.far=h*3.4,Ie.updateProjectionMatrix(),pn.update(),fe(),c<1&&requestAnimationFrame(a)})(s)}function df(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){Ko=n,i||(hr=null),hl=!1;let s=e?$v[e]:Ie.position.clone().sub(pn.target).toArray();eu(Qv(n,s),t?0:.35)}function Ug(n){hl=!1,hr=null,eu(Qv(Ko,$v[n]))}var hl=!1;function Og(){Ie.updateMatrixWorld();let n=new V;return Ko.every(t=>(n.set(...t).project(Ie),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function dl(){hl||!pn.enabled||!Ko.length||Og()||(hr??={position:Ie.position.clone(),target:pn.target.clone()},df(Ko,{byItself:!0}))}var hr=null;function tb(){if(!hr||hl||!pn.enabled)return;let n=hr;hr=null,eu(n),setTimeout(dl,500)}function BI(){if(!hr||hl||!pn.enabled)return!1;let n={position:Ie.position.clone(),target:pn.target.clone()},t=hr,e=({position:s,target:r})=>{Ie.position.copy(s),pn.target.copy(r),Ie.lookAt(r)};e(t);let i=Og();return e(n),i?(hr=null,eu(t,0),!0):!1}var ff=n=>{Ko=n},fl=()=>[...Ie.position.toArray(),...pn.target.toArray()].map(n=>Number(n.toPrecision(5)));function eb(n){Lg+=1,eu({position:new V(...n.slice(0,3)),target:new V(...n.slice(3))},0)}var ur=null,Fg={cell:.1};function Bg(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;Fg.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(Ft.gridFine),l=new ee(Ft.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}ur?.geometry.dispose();let c=new Me;c.setAttribute("position",new be(r,3)),c.setAttribute("color",new be(o,3)),ur?ur.geometry=c:(ur=new Wo(c,new es({vertexColors:!0})),ur.renderOrder=-2,ur.material.depthWrite=!1,en.add(ur)),ur.userData.reach=n,fe()}function kg(){en.background=new ee(Ft.ground),en.fog.color.set(Ft.ground),ur&&Bg(ur.userData.reach),fe()}function Vi(n){Ie.updateMatrixWorld();let t=new V(...n).project(Ie),e=ms.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function pf(n){let t=n.joints.length,e=Gn(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function zg(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=im(n,t),u=(d,f,p,_=!0,m=p)=>{Ui(Ni(f,d))<=l||(s.rods.push({a:d,b:f,r:p,far:m}),_&&s.balls.push({at:f,r:m}))};a&&(s.pedestal={at:te(t[0]),dir:Js(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:p},_)=>{let m=r[_],g=n.joints[_],x=te(t[_]),M=te(t[_+1]),v=m*.62,A=m*.84,E=(r[_+1]??e.rest)*.62,y=(r[_-1]??m)*.84;if(n.convention==="standard"){let U=oc(x,f,rc(Ni(M,x),f));u(x,U,v),u(U,M,A,!0,E)}else u(x,d,y,!0,v),u(d,M,v);let w=d,N=rc(Ni(M,d),f);h&&Ui(Ni(d,h.at))<.5*m&&Math.abs(N)>l?w=oc(d,f,Math.sign(N)*Math.min(Math.abs(N)*.55,h.r+m*1.15)):_===0&&Math.abs(N)>2.2*m&&(w=oc(d,f,Math.sign(N)*m*1.25));let R=m*2.15,L=Js(t[_+1],0),z=!!(i&&nu(g,i[_])),G=Js(t[0],2),F=rc(Ni(w,te(t[0])),G)-R/2;_===0&&g.type==="R"&&Math.abs(rc(f,G))>.99&&F<0&&F>-R&&(w=oc(w,G,-F)),g.type==="R"?s.drums.push({at:w,dir:f,x:p,turned:L,r:m,h:R,beyond:z,joint:_}):s.sleeves.push({at:w,dir:f,x:p,r:m*.95,h:m*3.4,beyond:z,joint:_}),h={at:d,r:m}}),a){let d=t[a+1],f=te(t[a]);s.flange={at:f,dir:Js(t[a],2),turned:Js(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,te(d),e.rest*.34,!1),s.tip={at:te(d),r:e.rest*.42}}return s}function nu(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}var Hg=.13;function Gg(n,t){let{radius:e,size:i}=pf(n),s=e[0]??.05,r=te(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(c=>[[r[0]+c,r[1]+c,0],[r[0]+c,r[1]-c,1]]);let o=[[r[0],r[1],0],...t.map(te)];for(let{point:c}of im(n,t))o.push(c);let a=t.at(-1);return[...[0,1,2].map(c=>[3,7,11].map(u=>a[u]+Hg*i*a[u-3+c])),...o.flatMap(c=>[[c[0]-s,c[1]-s,c[2]-s],[c[0]+s,c[1]+s,c[2]+s]])]}function zI(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new Uc(s.map(([a,l])=>new Qt(a,l)),n):new Ci(1,1,1,n),o={rod:i(new Ci(1,1,1,n,1,!0)),ball:t>3?new Ds(1,n,t):new Oc(1,0),drum:i(r),box:new Hi(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var nb=new Map,qg=(n,t)=>nb.get(n)??nb.set(n,zI(n,t)).get(n),HI=()=>qg(26,12),Vg=()=>qg(11,5),ib=()=>qg(6,3),iu=class{constructor(t){this.mesh=new Ge(new Me,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Me,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new He(c,l).setUsage(jd);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new He(o,1).setUsage(jd)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l,c=a){let u=this.corners,h=u+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let d=0,f=3*u;d<3*t.count;d+=3,f+=3){let p=t.at[d+2]>0?c:a,_=p*t.at[d],m=p*t.at[d+1],g=l*t.at[d+2],x=t.normal[d]/a,M=t.normal[d+1]/a,v=t.normal[d+2]/l;for(let A=0;A<3;A++)this.at[f+A]=i[A]+s[A]*_+r[A]*m+o[A]*g,this.normal[f+A]=s[A]*x+r[A]*M+o[A]*v}this.paint.fill(e,u,h);for(let d=0;d<t.index.length;d++)this.index[this.indices+d]=u+t.index[d];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},sb=[1,0,0],GI=[0,1,0],rb=[0,0,1];function VI(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Yu(n,Math.abs(n[2])<.9?rb:sb),i=Yu(n,e),s=Ui(i)||1,r=i.map(o=>o/s);return[Yu(r,n),r]}var mf=0,gf=1,Wg=2,$g=3,pl=class{constructor(t,{shadow:e=null,veil:i=!1,rim:s=null}={}){this.group=new Rn,this.veil=i,this.moving=!1,this.seen=this.shadowSeen=!0,this.arms=[],this.body=new iu(t),this.group.add(this.body.mesh),s&&(this.rim=new iu(s),this.rim.mesh.renderOrder=1,this.group.add(this.rim.mesh)),e&&(this.flat=new iu(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}shown(t,e){t===this.seen&&e===this.shadowSeen||(this.seen=t,this.shadowSeen=e,this.show(this.arms))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?ib:Vg:this.moving?Vg:HI;for(let i of this.seen?t:[])this.#t(this.body,i,e());if(this.body.done(),this.rim){this.rim.clear();for(let i of this.seen&&!this.moving?t:[])this.#t(this.rim,i,e(),{rim:!0});this.rim.done()}if(this.flat){this.flat.clear();for(let i of this.shadowSeen?t:[])this.#t(this.flat,i,this.moving?ib():Vg(),{flat:!0});this.flat.done()}}#t(t,e,i,{flat:s=!1,rim:r=!1}={}){let o=this.rim&&!this.moving&&!r?e.rim:0,a=!this.veil&&!s,l=f=>this.veil?Math.max(.96*f-o,.3*f):f,c=f=>2*l(f/2),u=f=>this.veil?e.outside?$g:mf:f,h=(f,p,_,m,g,x,M,v)=>t.put(f,u(p),_,...VI(m,M),m,g,x,v),d=(f,p,_)=>t.put(i.ball,u(f),p,sb,GI,rb,_,_);for(let{a:f,b:p,r:_,far:m}of e.rods){let g=Ni(p,f),x=Ui(g),M=[(f[0]+p[0])/2,(f[1]+p[1])/2,(f[2]+p[2])/2];h(i.rod,mf,M,g.map(v=>v/x),l(_),x,null,l(m??_))}for(let{at:f,r:p}of e.balls)d(mf,f,l(p));for(let{at:f,dir:p,turned:_,r:m,h:g,beyond:x}of e.drums){if(h(i.drum,x&&a?$g:gf,f,p,l(m),c(g)),!a)continue;h(i.rod,Wg,f,p,m*1.012,g*.13);let M=[0,1,2].map(v=>f[v]+_[v]*m*.96);h(i.box,mf,M,p,m*.11,g*.86,_)}for(let{at:f,dir:p,x:_,r:m,h:g,beyond:x}of e.sleeves)h(i.box,x&&a?$g:gf,f,p,l(m),c(g),_);if(e.pedestal&&!this.veil){let{at:f,dir:p,r:_,h:m}=e.pedestal;h(i.drum,gf,[f[0]+p[0]*m/2,f[1]+p[1]*m/2,f[2]+p[2]*m/2],p,_,m)}if(e.flange&&h(i.drum,gf,e.flange.at,e.flange.dir,l(e.flange.r),c(e.flange.h)),e.flange&&a){let{at:f,dir:p,turned:_,r:m,h:g}=e.flange;h(i.box,Wg,[0,1,2].map(x=>f[x]+_[x]*m*.95),p,m*.16,g*1.04,_)}e.tip&&a&&d(Wg,e.tip.at,e.tip.r)}};var WI=`
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
  }`,ob=`
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
  }`,$I=`
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
  }`,qI=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function xf({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new pi({vertexShader:e?$I:WI,fragmentShader:e?qI:ob,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function ab(){let n=new pi({vertexShader:`
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
      }`,side:oi,transparent:!0,depthWrite:!1,uniforms:{colours:{value:[new ee,new ee]}}});return n.repaint=(...t)=>t.forEach((e,i)=>n.uniforms.colours.value[i].set(e)),n}function lb(n){let t=new pi({vertexShader:`
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
      }`,fragmentShader:ob.replace("vec3 n = normalize(vNormal),","vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal),"),side:n?or:mi,uniforms:{colour:{value:new ee},opacity:{value:1},gloss:{value:.14},sky:{value:new ee},ground:{value:new ee}}});return t.colour=t.uniforms.colour.value,t.see=(e,i)=>{t.uniforms.opacity.value=e,t.transparent=e<1,t.uniforms.sky.value.setScalar(i?.4:.47),t.uniforms.ground.value.setScalar(i?.13:.2)},t}function Xg(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Me;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in h.attributes){if(!i.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(h.attributes[p]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in h.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[p].length!==n[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(h.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let p;if(e)p=h.index.count;else if(h.attributes.position!==void 0)p=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,u),c+=p}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let p=0;p<f.count;++p)h.push(f.getX(p)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=cb(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let _=0;_<o[u].length;++_)f.push(o[u][_][d]);let p=cb(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(p)}}}return l}function cb(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new He(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let p=0;p<e;p++){let _=u.getComponent(d,p);a.setComponent(d+h,p,_)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var XI=Array.from({length:12},(n,t)=>[Math.cos(t*Math.PI/6),Math.sin(t*Math.PI/6)]),YI=[.75,1.5,2.4],ub=2,_f=4,ml=S("div",{class:"labels","aria-hidden":"true"}),su=new Map,yo=null;function db(n,t){let e=su.get(n)??[],i=t.map(({text:s,at:r,wish:o},a)=>{let l=e[a]??{el:ml.appendChild(S("span",{class:"label"})),stands:null};return l.text!==s&&(l.text=l.el.textContent=s,l.width=null),Object.assign(l,{at:r,wish:o})});for(let s of e.slice(t.length))s.el.remove();su.set(n,i),fe()}function fb(n){n.prepend(ml),hf(jI),tt("theme",()=>{for(let t of[...su.values()].flat())t.width=null;yo=null}),new ResizeObserver(([t])=>{yo=[t.contentRect.width,t.contentRect.height],fe()}).observe(ml)}var yf=new V;function pb(n){return yf.set(...n).project(Ie),yf.z<1?[(yf.x+1)/2*yo[0],(1-yf.y)/2*yo[1]]:null}var hb=(n,t)=>Math.max(0,Math.min(n[2],t[2])-Math.max(n[0],t[0]))*Math.max(0,Math.min(n[3],t[3])-Math.max(n[1],t[1]));function jI(){yo??=[ml.clientWidth,ml.clientHeight],Ie.updateMatrixWorld();let n=[...su.values()].flat();for(let i of n)i.point=pb(i.at),i.width===null&&(i.width=i.el.offsetWidth,i.height=i.el.offsetHeight);let t=n.filter(i=>i.point).map(({point:[i,s]})=>[i-_f,s-_f,i+_f,s+_f]),e=[];for(let i of n){let s=i.point&&ZI(i,e,t);if(i.box=s?s.box:null,i.stands=s?s.key:null,i.el.hidden=!s,!s)continue;e.push(s.box.map((o,a)=>o+(a<2?-ub:ub)));let r=`translate(${Math.round(s.box[0])}px, ${Math.round(s.box[1])}px)`;r!==i.where&&i.el.style.setProperty("transform",i.where=r)}}function ZI({point:n,width:t,height:e,wish:i,stands:s},r,o){let[a,l]=n;if(a<0||l<0||a>yo[0]||l>yo[1])return null;let c=i&&pb(i),u=c&&Math.hypot(c[0]-a,c[1]-l)||1,h=c?[(c[0]-a)/u,(c[1]-l)/u]:[0,-1],d=null;return YI.forEach((f,p)=>{XI.forEach(([_,m],g)=>{let x=a+_*(f*e+t/2),M=l+m*f*e*1.35,v=[x-t/2,M-e/2,x+t/2,M+e/2],A=t*e-hb(v,[0,0,...yo]),E=[...r,...o].reduce((N,R)=>N+hb(v,R),A),y=`${p}.${g}`,w=100*E+2*p+(1-_*h[0]-m*h[1])-(y===s?.8:0);(!d||w<d.cost)&&(d={cost:w,box:v,key:y})})}),d}var Yg=()=>[...su.values()].flat().map(({text:n,box:t,point:e})=>({text:n,box:t,point:e}));function mb(n,t){let e=getComputedStyle(ml);n.font=`600 ${parseFloat(e.fontSize)*t}px ${e.fontFamily}`,Object.assign(n,{textAlign:"center",textBaseline:"middle",lineJoin:"round",lineWidth:4*t}),n.strokeStyle=Ft.ground,n.fillStyle=Ft.ink;for(let{text:i,box:s}of Yg()){if(!s)continue;let r=[(s[0]+s[2])/2*t,(s[1]+s[3])/2*t];n.strokeText(i,...r),n.fillText(i,...r)}}var Br=sf.axes;function jg(n,t){let e=new Ci(.028,.028,.82,8).translate(0,.41,0),i=new qo(.085,.22,12).translate(0,.9,0),s=Xg([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new He(o,3)),s}var Zg=n=>new ye().makeRotationFromQuaternion(new fn().setFromUnitVectors(new V(0,1,0),new V(...n))),KI=Xg([jg(Br[0],Zg([1,0,0])),jg(Br[1],Zg([0,1,0])),jg(Br[2],Zg([0,0,1]))]),gl=class{constructor(){this.group=new Rn,this.mesh=new Pc(KI,new Vn({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.group.add(this.mesh)}show(t,e,i=[]){this.last=[t,e];let s=new ye;this.mesh.count=t.length,t.forEach(({T:o},a)=>this.mesh.setMatrixAt(a,s.set(...o).scale(new V(e,e,e))));let r=(o,a)=>o[a+3]-e*.4*(o[a]+o[a+1]+o[a+2]);db(this,[...t.map(({T:o,name:a})=>({text:a,at:[o[3],o[7],o[11]],wish:[0,4,8].map(l=>r(o,l))})),...i]),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}};var Kg=180/Math.PI,Wi={angle:"deg",length:"mm"},QI={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},Jg={deg:Kg,rad:1,mm:1e3,m:1},t3={deg:2,rad:4,mm:2,m:5},e3={deg:1,rad:.02,mm:5,m:.005},gt={get angle(){return Wi.angle},get length(){return Wi.length},set(n,t){t in Jg&&n in Wi&&(Wi[n]=t)},factor:n=>n in Wi?Jg[Wi[n]]:1,symbol:n=>n in Wi?QI[Wi[n]]:"",digits:n=>n in Wi?t3[Wi[n]]:4,step:n=>n in Wi?e3[Wi[n]]/Jg[Wi[n]]:.01,suffix:n=>n==="angle"?{deg:Kg,"\xB0":Kg,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function ii(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var mn=(n,t,e=gt.digits(t))=>ii(n*gt.factor(t),e),re=(n,t,e)=>`${mn(n,t,e)}${t==="angle"&&Wi.angle==="deg"?"":" "}${gt.symbol(t)}`,ru=(n,t="plain")=>String(Number((n*gt.factor(t)).toPrecision(9))+0),vf=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function xl(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||gt.digits(t))/gt.factor(t)}var ou=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?ii(n,4):n.toExponential(2).replace("-","\u2212");var n3={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},i3={theta:(n,t,e)=>`turn by \u03B8${n} = ${re(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${re(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${re(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${re(t,"angle")} about x`};function gb(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=n3[n.convention],o=br(n.joints[i],Mr(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:S_(n.convention,a.a,a.alpha,a.d,a.theta)}}function xb(){let n=S("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>Ut(o,{"aria-label":a},()=>i(l())),e=()=>4*b.table.joints.length-1,i=o=>{b.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ct("frames")},s=S("details",{class:"fold","data-testid":"dh-steps"},S("summary",{text:"The frames, one step at a time"}),S("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(b.dhStep??1)-1),t("On","One step on",()=>(b.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(b.dhStep===null||!b.table.joints.length){b.dhStep=null,bt(n,"");return}b.dhStep=Math.min(b.dhStep,e());let{i:o,key:a,value:l}=gb(b.table,b.q,b.dhStep),c=b.table.convention==="standard"?o:o+1;bt(n,`Joint ${o+1}, ${b.dhStep%4+1} of 4: ${i3[a](o+1,l,c)}`)};return tt(["q","table","units"],()=>b.dhStep!==null&&r()),tt("panel",o=>{o!=="table"&&b.dhStep!==null&&(s.open=!1,i(null))}),s}function bf(){let{i:n,A:t}=gb(b.table,b.q,b.dhStep);return[...b.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:Hn(b.frames[n],t),name:`\u2192 ${n+1}`}]}var Qg=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],_l=n=>[Math.cos(n),Math.sin(n)];function s3([n,t,e]){let[i,s]=_l(e),[r,o]=_l(t),[a,l]=_l(n);return Qg([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function r3(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function o3([n,t,e]){let[i,s]=_l(n),[r,o]=_l(t),[a,l]=_l(e);return Qg([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function a3(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Mf(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function au(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return Qg([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function l3(n){let[t,e,i,s]=Mf(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function c3([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:au([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Fs={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:r3,from:s3},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:a3,from:o3},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:l3,from:c3},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Mf,from:au}};function _b(n,t,e){let i=Fs[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Sf(n,t,e){let i=Mf(n),s=Mf(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=au(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var yl=.145,Tf=.105,a0=.165,yb={mouse:13,pen:16,touch:28},u3=.2,Mo=["x","y","z"],cu=72,Qo=new Rn,Ef=new Map,i0="both",Af="local",l0=0,kr=!1,s0=null,nn=null,Rf=()=>nn!==null,wb=()=>kr,vo=null,bo=null;function Eb(){Qo.visible=!1,en.add(Qo),hf(c0),bo=document.getElementById("view"),vo=S("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(vo),bo.addEventListener("pointerdown",x3,!0),bo.addEventListener("pointermove",y3,!0);for(let n of["pointerup","pointercancel"])bo.addEventListener(n,Db,!0);addEventListener("keydown",n=>n.key==="Escape"&&nn&&b3()),tt(["target","theme"],fe)}function lu(n,t,e=8){let i=new Vn({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new Ge(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var h3=[new fn().setFromUnitVectors(new V(0,1,0),new V(1,0,0)),new fn,new fn().setFromUnitVectors(new V(0,1,0),new V(0,0,1))],d3=[new fn().setFromUnitVectors(new V(0,0,1),new V(1,0,0)),new fn().setFromUnitVectors(new V(0,0,1),new V(0,1,0)),new fn];function f3(){if(Ef.size)return;let n=(t,e)=>{Ef.set(t,e),Qo.add(e)};Mo.forEach((t,e)=>{let i=new Ci(.0032,.0032,yl*.8,8).translate(0,yl*.45,0),s=new qo(.0125,.034,14).translate(0,yl*.9,0),r=new Rn;r.add(lu(i,Br[e]),lu(s,Br[e])),r.userData.turn=h3[e],n(`move-${t}`,r);let o=lu(new el(Tf,.0026,6,cu),Br[e],7);o.userData.turn=d3[e],n(`turn-${t}`,o)}),n("turn-view",lu(new el(a0,.0022,6,cu),"#8891a0",7)),n("move-view",lu(new Ds(.0115,14,10),"#8891a0",9))}var wf=new V,So=new V,t0=new fn;function Cf(){return 2*Math.tan(_o.degToRad(Ie.fov/2))*Ie.position.distanceTo(wf)}var hu=()=>Af==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):p3(),p3=()=>[0,1,2].map(n=>Js(b.target,n)),m3=new ye;function c0(){if(Qo.visible=kr,!kr)return;wf.set(...te(b.target)),So.copy(Ie.position).sub(wf).normalize(),Af==="world"?t0.identity():t0.setFromRotationMatrix(m3.set(...b.target)),Qo.position.copy(wf),Qo.scale.setScalar(Cf());let n=hu();for(let[t,e]of Ef){let[i,s]=t.split("-"),r=Mo.indexOf(s),o=i0==="both"||i0===i;e.visible=o&&g3(i,n[r])&&(!nn||nn.name===t),s==="view"?e.quaternion.copy(Ie.quaternion):e.quaternion.copy(t0).multiply(e.userData.turn);let a=t===(nn?.name??s0);e.traverse(l=>l.material?.color.set(a?Ft.accent:l.userData.colour))}}function g3(n,t){return!t||n!=="move"?!0:Math.hypot(...Tb(t,So.toArray()))>u3}var Tb=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],uu=(n,t)=>te(b.target).map((e,i)=>e+t*n[i]);function r0(n,t){let e=hu(),[i,s]=n<0?[vb(Ie.matrixWorld,0),vb(Ie.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:cu+1},(r,o)=>{let a=2*Math.PI*o/cu,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:uu(l,t),front:n<0||l.reduce((c,u,h)=>c+u*So.getComponent(h),0)>-.15}})}var vb=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function bb(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function o0(n,t){let e=Cf(),i=[];for(let[s,r]of Ef){if(!r.visible)continue;let[o,a]=s.split("-"),l=Mo.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=Vi(te(b.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=hu()[l],h=Vi(uu(u,.92*yl*e));c=Math.min(bb(n,t,Vi(uu(u,.3*yl*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=r0(l,(l<0?a0:Tf)*e).map(h=>({...h,s:Vi(h.p)}));for(let h=0;h<cu;h++)u[h].front&&(c=Math.min(c,bb(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Ab(n){if(!kr)return null;c0();let[t]=o0(n.clientX,n.clientY);return t&&t[1]<=(yb[n.pointerType]??yb.mouse)?t[0]:null}function Rb(){if(!kr)return{};c0();let n=Cf(),t=hu(),e={"move-view":Vi(te(b.target))};return Mo.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>Vi(uu(t[s],c*yl*n))).find(([c,u])=>o0(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=r0(s,Tf*n).filter(c=>c.front).map(c=>Vi(c.p)).filter(([c,u])=>o0(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=Vi(r0(-1,a0*n)[9].p),e}var Mb=new zc,Sb=new Qt;function Cb(n){let t=ss.domElement.getBoundingClientRect();return Sb.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),Mb.setFromCamera(Sb,Ie),Mb.ray}function Pb(n,t,e){let{origin:i,direction:s}=Cb(e),r=new V(...n),o=new V(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function Ib(n,t,e){let i=new ri().setFromNormalAndCoplanarPoint(n,new V(...t));return Cb(e).intersectPlane(i,new V)}function x3(n){if(n.button!==0)return;let t=Ab(n);if(!t)return;n.stopPropagation(),n.preventDefault(),bo.focus({preventScroll:!0}),bo.setPointerCapture(n.pointerId),pn.enabled=!1;let[e,i]=t.split("-"),s=Mo.indexOf(i),r=s<0?So.toArray():hu()[s].slice();nn={name:t,what:e,axis:r,i:s,T:b.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},nn.start=e==="turn"?Lb(n):s<0?Ib(So,te(nn.T),n):Pb(r,te(nn.T),n),fe()}function Lb(n){let[t,e]=Vi(te(nn.T)),i=nn.axis.reduce((h,d,f)=>h+d*So.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Tb(nn.axis,So.toArray()),r=Cf(),o=Vi(te(nn.T)),a=Vi(uu(s,Tf*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-nn.x)*l+(n.clientY-nn.y)*c)/(u*u)}var _3=n=>Math.atan2(Math.sin(n),Math.cos(n)),e0=(n,t,e)=>{let i=l0||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function y3(n){if(!nn){if(n.buttons||!kr)return;let l=Ab(n);l!==s0&&(s0=l,bo.style.setProperty("cursor",l?"grab":""),fe());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=nn,r=Af==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Lb(n);nn.total+=_3(l-(nn.before??nn.start)),nn.before=l;let c=e0(nn.total,n,Math.PI/180),u=Math.sin(c/2);o=Hn(au([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${n0(c,"angle")} about ${s<0?"the line of sight":r+Mo[s]}`}else if(s<0){let l=Ib(So,te(t),n);if(!l)return;let c=l.sub(nn.start);(l0||n.shiftKey)&&c.set(...c.toArray().map(u=>e0(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${Mo[h]} ${n0(u,"length")}`).join(", ")}else{let l=e0(Pb(e,te(t),n)-nn.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${n0(l,"length")} along ${r}${Mo[s]}`}wi(o,"drag"),v3(a,n),fe()}var n0=(n,t)=>`${n>=0?"+":""}${re(n,t,gt.digits(t))}`;function v3(n,t){let e=bo.getBoundingClientRect();vo.hidden=!1,bt(vo,n),vo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-vo.offsetWidth-8)}px`),vo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Db(n){nn&&(n.stopPropagation(),nn=null,vo.hidden=!0,pn.enabled=!0,wi(b.target,"dropped"),fe())}function b3(){let{T:n}=nn;wi(n,"drag"),Db({stopPropagation(){}})}function Nb(){kr&&f3(),Qo.visible=kr,ct("frames"),fe()}function Ub(n){kr=n,Nb()}function Ob(n){i0=n,Nb()}function Fb(n){Af=n,fe()}function Bb(n){l0=n}var Vb=xf(),zb=[.32,-.4,1],Nf=new Vn({color:"#000",transparent:!0,opacity:.1,side:mi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:rg,stencilRef:1,stencilZPass:sg,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),p0=new ye().set(1,0,-zb[0],0,0,1,-zb[1],0,0,0,0,5e-4,0,0,0,1),vl=new Ge(new Nc(1,40),new pi({transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1,uniforms:{strength:{value:.3}},vertexShader:"varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",fragmentShader:"uniform float strength; varying vec2 at; void main() { float d = 1.0 - length(at); gl_FragColor = vec4(0.0, 0.0, 0.0, strength * d * d); }"}));vl.renderOrder=-1;function M3(){let n=b.frames[0],t=2*(Bs.radius[0]??0);vl.visible=b.table.joints.length>0&&Math.abs(n[11])<.02*Bs.size&&n[10]>.99,vl.position.set(n[3],n[7],4e-4*Bs.size),vl.scale.set(1.6*t,1.6*t,1)}var pu=new pl(Vb,{shadow:{material:Nf,matrix:p0}});function Wb(n,t){pu.shown(n,n&&!t)}var h0=.1,m0=xf({opacity:h0,veil:!0}),$b=ab(),fu=new pl(m0,{veil:!0,rim:$b}),qb=xf({opacity:.62,gloss:.1}),d0=new pl(qb,{veil:!0}),g0=new gl,Bs=pf(b.table),Uf=[],Lf=null;function Xb(){en.add(vl,pu.group,fu.group,d0.group,g0.group),fu.group.renderOrder=1,tt("table",n=>{Bs=pf(b.table),Bg(Bs.size),Uf=[],Lf=null,_0(),kf(),n==="new"&&mu({instant:!0,view:"iso"}),jv()}),tt("q",S3),tt("frames",Zb),tt("theme",Gb),tt("hurry",n=>{m0.uniforms.opacity.value=n?2*h0:h0;for(let t of[pu,fu,d0])t.hurry(n)}),Gb()}var Hb=new Map,f0=[],u0=0;function Hr(n,t){if(Hb.set(n,t),f0=[...Hb.values()].flat(),!b.table.joints.length)return;let e=u0;u0=f0.length,ff(Ff()),t.length?x0():e>u0&&Yb()}var Df=()=>[],Pf=0;function Of(n){let t=Pf;Df=n,Pf=Df(b.frames).length,b.table.joints.length&&(ff(Ff()),Pf<t?Yb():Pf&&x0())}var Ff=()=>[...Gg(b.table,b.frames),...Df(b.frames),...f0],Yb=tr(tb,120);function jb(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Hr("motion",i.flatMap(s=>{let r=As(n,s);return[...Gg(n,r),...n===b.table?Df(r):[]]}))}function mu(n){df(Ff(),n)}var x0=tr(dl,220);function S3(){let n=b.frames;pu.show(b.table.joints.length?[zg(b.table,n,Bs,b.q)]:[]),M3(),ff(Ff()),x0(),iM&&E3(te(n[n.length-1])),Zb()}function Zb(){let n=(b.shownFrames??[]).filter(t=>t<b.frames.length&&!(t===b.frames.length-1&&wb())).map(t=>({T:b.frames[t],name:Bf(t)}));g0.show(b.dhStep===null?n:bf(),Bs.size*Hg),fe()}var Jb=()=>pu.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),Kb=()=>(g0.last?.[0]??[]).map(n=>n.name);function Bf(n){let t=b.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function Qb(n){Uf=n,_0()}function gs(n){Lf=n,_0()}var tM=()=>Uf.length,eM=()=>fu.arms.filter(n=>n.outside).length,w3=.0035;function _0(){let n=t=>({...zg(b.table,As(b.table,t),Bs),outside:b.table.joints.some((e,i)=>nu(e,t[i])),rim:w3*Bs.size});fu.show(Uf.map(n)),d0.show(Lf?[n(Lf)]:[]),fe()}var nM=6e3,If=new Float32Array(6*nM),zr=new Wo(new Me,new es({fog:!1}));zr.geometry.setAttribute("position",new He(If,3));zr.frustumCulled=!1;zr.visible=!1;var wo=0,iM=!0,du=null;en.add(zr);function E3(n){let t=du?Ui(Ni(n,du)):1/0;t<Bs.size*.002||(t<Bs.size*.2&&(wo===nM&&(If.copyWithin(0,6*1e3),wo-=1e3),If.set(du,6*wo),If.set(n,6*wo+3),wo+=1,zr.geometry.setDrawRange(0,2*wo),zr.geometry.attributes.position.needsUpdate=!0,zr.visible=!0),du=n)}function sM(n){iM=n,n||kf(),fe()}function kf(){wo=0,du=null,zr.visible=!1,fe()}var rM=()=>wo,gu=new sr(new Me,new es({fog:!1}));gu.frustumCulled=!1;var xu=new Dr(new Me,new rr({size:4,sizeAttenuation:!1,fog:!1}));xu.frustumCulled=!1;gu.visible=xu.visible=!1;en.add(gu,xu);function ta(n){Hr("path",n);let t=new Float32Array(n.flat());for(let e of[gu,xu])e.geometry.dispose(),e.geometry=new Me,e.geometry.setAttribute("position",new He(t,3)),e.visible=n.length>0;fe()}function Gb(){Vb.repaint(Ft.link,Ft.joint,Ft.accent,Ft.dark,Ft.wrong),m0.repaint(Ft.ghost,Ft.ghost,Ft.ghost,Ft.dark,Ft.wrong),$b.repaint(Ft.ghost,Ft.wrong),qb.repaint(Ft.accent,Ft.accent,Ft.accent,Ft.dark),zr.material.color.set(Ft.accent),gu.material.color.set(Ft.trace),xu.material.color.set(Ft.trace),Nf.opacity=Ft.dark?.28:.11,vl.material.uniforms.strength.value=Ft.dark?.75:.34,fe()}var pe={follow:!0,ghosts:"all",task:null,redundancy:null},y0={answers:0},zf=!1,oM=Ks(async()=>{let n=zf;zf=!1;let t=b.target,e=b.table;try{let i=Rf()||v0,s=i?null:b.digits,{task:r,redundancy:o}=pe,a=await Oe("ik",{T:t,q:b.q,brief:i,task:r,redundancy:o,digits:s});if(e!==b.table||t!==b.target&&!i)return;y0.answers+=1,b.solutions={...a,T:t,brief:i},n&&pe.follow&&a.nearest&&Oi(a.nearest,"follow"),bl(),ct("solutions"),!i&&!a.rows.some(l=>l.inside)&&R3(t),a.self_motions===null&&!i&&A3(b.solutions)}catch(i){if(nh(i))return;b.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},bl(),ct("solutions")}}),v0=!1;function aM(){v0=!0,zf=!0,oM()}function ks({follow:n=!1}={}){v0=!1,zf||=n,oM()}var A3=Ks(async n=>{try{let t={T:n.T,q:b.q,task:pe.task,redundancy:pe.redundancy},{self_motions:e}=await Oe("self_motions",t);if(b.solutions!==n||!e)return;n.self_motions=e,ct("solutions")}catch{}}),R3=Ks(async n=>{try{let t=await Oe("nearest",{T:n,task:pe.task});b.solutions&&b.solutions.T===n&&(b.solutions.near=t,ct("solutions"))}catch{}}),C3=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function bl(){let n=b.solutions?.rows??[],t=b.panel==="inverse"&&pe.ghosts!=="none"?n.filter(e=>(pe.ghosts==="all"||e.inside)&&!C3(e.q,b.q)):[];Qb(t.map(e=>e.q))}function lM(){tt("target",n=>{b.panel==="inverse"&&ks({follow:R_.has(n)})}),tt("task",()=>{ct("plan"),b.panel==="inverse"&&b.hasTarget&&ks()}),tt("panel",n=>{gs(null),n==="inverse"&&b.hasTarget&&!b.solutions&&ks(),bl()}),tt("moving",n=>{n||bl()}),tt("table",n=>{pe.redundancy=null,n==="new"&&(pe.task=null),ct("solutions"),n!=="new"&&b.panel==="inverse"&&b.hasTarget&&ks()}),tt("online",n=>{n&&b.panel==="inverse"&&b.hasTarget&&b.table.joints.length&&ks()})}var _u=0;function xi(){_u+=1,b.moving&&(b.moving=!1,ct("moving",!1))}function Ii(n,t=.8,e="move to a posture"){xi(),ct("let-go"),ct("did",{label:e});let i=b.q.slice(),s=_u,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),b.moving=!0,ct("moving",!0),new Promise(o=>{(function a(l){if(s!==_u||i.length!==b.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Oi(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(b.moving=!1,ct("moving",!1),o(!0))})(r)})}function cM(n,t,e,i){xi();let s=_u,r=performance.now()-1e3*n*t;b.moving=!0,ct("moving",!0),requestAnimationFrame(function o(a){if(s!==_u){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(b.moving=!1,ct("moving",!1),i?.(!0))})}var I3=200,L3=1500,ea=[],bu=[],vu=null,yu={key:null,at:0,open:!1},b0=!1,Hf=()=>({table:b.table,q:b.q,target:b.target,digits:b.digits,hasTarget:b.hasTarget,path:{...b.path},sequence:structuredClone(b.sequence),program:b.program,world:b.world,limits:b.limits,start:b.start,routing:b.routing,task:pe.task,redundancy:pe.redundancy});function M0(){b0||(b0=!0,queueMicrotask(()=>{b0=!1,vu=Hf()}))}var Ml=null;function Mu(n,t){na(),Ml={label:n,open:!0};try{t()}finally{Ml=null,na()}}function D3(n){let{label:t,key:e=Symbol(t),open:i=!1}=Ml?{...Ml,key:Ml}:n,s=performance.now();!(e===yu.key&&(yu.open||s-yu.at<L3))&&vu&&(ea.push({label:t,before:vu}),ea.length>I3&&ea.shift(),bu.length=0),yu={key:e,at:s,open:i},M0(),ct("history")}function na(){Ml||(yu={key:null,at:0,open:!1})}function N3(n){xi(),na(),pe.task=n.task,n.table!==b.table?yn(n.table,{q:n.q,step:!1,what:"undo"}):Oi(n.q,"undo"),pe.redundancy=n.redundancy,Object.assign(b.path,n.path),b.sequence=structuredClone(n.sequence),b.program=n.program,b.world=n.world,b.limits=n.limits,b.start=n.start;let t=b.routing!==n.routing;b.routing=n.routing,b.hasTarget=n.hasTarget,n.target!==b.target&&wi(n.target,"restored",n.digits);for(let e of["path-loaded","sequence-loaded","program","world","task"])ct(e,"undo");t&&ct("routing","undo")}function uM(n,t,e){let i=n.pop();if(!i)return;let s=Hf();N3(i.before),t.push({label:i.label,before:s}),M0(),ct("history"),he(`${e}: ${i.label}`)}var S0=()=>uM(ea,bu,"Undone"),w0=()=>uM(bu,ea,"Redone"),Gf=()=>ea.at(-1)?.label??null,Vf=()=>bu.at(-1)?.label??null;function Wf(){ea.length=0,bu.length=0,na(),vu=Hf(),ct("history")}function hM(){vu=Hf(),tt("did",D3),tt("let-go",na),tt(["table","q","target","path","sequence","program","world","task","routing","panel"],M0)}var O3=[[64.3,"tablet"],[87.33,"narrow"],[103.02,"usual"]],F3=n=>tu()*Math.min(Math.max(14,8+.005*n),28),E0=()=>document.documentElement.dataset.layout;function dM(){let n=innerWidth/F3(innerWidth),t=O3.find(([e])=>n<=e)?.[1]??"pinned";t!==E0()&&(document.documentElement.dataset.layout=t,ct("layout"))}function fM(){dM(),addEventListener("resize",dM)}var T0={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},pM={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},$f=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,mM=80;function k3(n){let t=[];$f.lastIndex=0;let e=n.trimEnd();for(;$f.lastIndex<e.length;){let i=$f.lastIndex,s=$f.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1]),text:s[1]}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function z3(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function Sl(n,t="plain"){let e=z3(String(n));if(e.length>mM)throw new Error(`longer than ${mM} characters`);let i=k3(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in gt.suffix(t)&&(s=gt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=g=>i[o]?.sign===g,c=g=>{if(!l(g))throw new Error(`\u201C${g}\u201D is missing`);o++};function u(){let g=h();for(;l("+")||l("-");){let x=i[o++].sign,M=h();g=x==="+"?g+M:g-M}return g}function h(){let g=d();for(;;)if(l("*"))o++,g*=d();else if(l("/"))o++,g/=d();else if(i[o]?.word||l("("))g*=f();else return g}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let g=p();return l("^")?(o++,g**d()):g}function p(){let g=i[o];if(!g)throw new Error("something is missing at the end");if(o++,g.number!==void 0)return g.number;if(g.sign==="("){let x=u();return c(")"),x}if(g.word){let x=g.word.toLowerCase();if(Object.hasOwn(pM,x))return a=!0,pM[x];if(Object.hasOwn(T0,x)){c("(");let M=u();return c(")"),T0[x](M)}throw new Error(`\u201C${g.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(T0).join(", ")}`)}throw new Error(`\u201C${g.sign}\u201D is not expected here`)}let _=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].text}\u201D is not expected here`);if(!Number.isFinite(_))throw new Error("not a finite number");let m=s??(t==="angle"&&a?1:gt.factor(t));return{value:_/m+0,symbolic:a||s!==null||i.length>2}}function Mn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a,key:l=r}){let c=typeof t=="function"?t:()=>t,u=S("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o});u.key=l,u.mayBeEmpty=s!==void 0;let h=null,d=null,f="",p=!1,_=!1,m=()=>{if(u.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let y=Sl(u.value,c()),w=a?.(y.value);if(w)throw new Error(w);return y},g=(y,w=!0)=>{u.classList.toggle("wrong",!!y),y?(u.setAttribute("aria-invalid","true"),u.title=y):(u.removeAttribute("aria-invalid"),u.title=o??""),w&&A0(u,y),u.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:y?{label:n,reason:y}:null}))},x=y=>{_=!1;try{let w=m();return g(null),y&&(h=w.value,d=w.symbolic?u.value.trim():null),y?.(w.value,{symbolic:w.symbolic,text:u.value.trim()}),!0}catch(w){return g(w.message),!1}};u.addEventListener("input",()=>{p=!0,x(e)}),u.addEventListener("change",()=>{p=!1,i||!e?x(i):_&&E(),ct("let-go")});let M="",v=()=>{try{m(),M=u.value}catch{}};u.addEventListener("focus",()=>{v(),u.classList.contains("wrong")&&A0(u,u.title),u.select()}),u.addEventListener("blur",()=>{p=!1,_&&E(),A0(u,null)}),u.addEventListener("keydown",y=>{let w=u.closest("table.dh");if(y.key==="Escape"&&u.value!==M){y.preventDefault(),u.value=M,p=!1,x(i??e),u.select();return}if(w&&V3(u,y))return;let N={ArrowUp:1,ArrowDown:-1}[y.key];if(y.key==="Enter"&&(p=!1,v(),u.select()),!(!N||w&&!y.altKey)){y.preventDefault();try{let R=m();u.value=ru((R.value??0)+N*gt.step(c())*(y.shiftKey?.1:1),c()),x(i??e)}catch{}}});let A=()=>u.classList.contains("wrong"),E=()=>{_=!1,f=d??(h==null?"":ru(h,c())),u.value=f,R0(u),A()&&g(null)};return u.put=(y,w=null,N=!1)=>{let R=y===h&&!N,L=R&&w===d;h=y,d=w;let z=document.activeElement===u&&!u.readOnly;if(z&&(p||A())){_||=!R;return}if(L&&(z||A()||u.value===f))return;let G=z&&u.selectionStart===0&&u.selectionEnd===u.value.length;E(),M=u.value,G&&u.select()},u.giveUp=E,u.leave=y=>{u.value=y;try{m()}catch(w){g(w.message,!1)}},u.addEventListener("input",()=>R0(u)),G3.observe(u),u.refresh=()=>{!A()&&document.activeElement!==u&&E()},u}function $i(n,t){Qu(n,()=>H3(n,t))}function gM(n){for(let t of n.querySelectorAll(".number.wrong"))t.giveUp()}function H3(n,t){let e=[...n.querySelectorAll(".number.wrong")];if(t(),!e.length)return;let i=new Map([...n.querySelectorAll(".number")].map(o=>[o.key,o])),r=e.filter(o=>{let a=i.get(o.key);return a&&a!==o&&a.leave(o.value),!a}).map(o=>`${o.getAttribute("aria-label")} (\u201C${o.value}\u201D)`).join(", ");r&&he(`Could not be read and is given up: ${r}.`,"wrong")}var G3=new ResizeObserver(n=>requestAnimationFrame(()=>n.forEach(({target:t})=>{let e=parseFloat(getComputedStyle(t).fontSize);t.sure=t.shrunk?0:Math.floor((t.clientWidth-14)/(.8*e)),R0(t)})));function R0(n){if(n.value.length<=n.sure&&!n.shrunk)return;let t=n.clientWidth;if(!t||(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t))return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.5*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Li=null;function A0(n,t){if(!t){Li&&Li.about===n&&(Li.hidden=!0),n.removeAttribute("aria-describedby");return}Li||(Li=S("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Li)),Li.about=n,Li.hidden=!1,Li.textContent!==t&&(Li.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Li.style.setProperty("top",`${e.bottom+4}px`),Li.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Li.offsetWidth-8))}px`)}addEventListener("scroll",()=>Li&&(Li.hidden=!0),!0);function V3(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}var _M=1,yM=30;function wl(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=b;return{pieper:_M,table:n,q:t,target:i?e:null,digits:i?b.digits:null,task:pe.task,redundancy:pe.redundancy,follow:pe.follow,ghosts:pe.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:b.program,start:b.start,limits:b.limits},world:b.world,routing:b.routing,look:b.look,panel:l,theme:c,units:[gt.angle,gt.length],camera:fl()}}var Xn=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,ys=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Xn),xs=(n,t)=>typeof n=="string"?n.slice(0,t):"",_s=n=>{if(!ys(n,16))return null;let t=ju(n);return t<1e-12?n.slice():t<.001?Zu(n):null},W3=n=>n&&Xn(n.metres)&&Xn(n.radians)?{metres:n.metres,radians:n.radians}:null,$3=n=>n&&[n.lower,n.upper,n.value].every(Xn)&&n.lower<=n.upper?{name:xs(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:xs(n.unit,10)}:null,q3=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>ys(e,t))?n:null;function X3(n){if(!n||!Array.isArray(n.joints)||n.joints.length>yM||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Xn(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:xs(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Xn(i.lower)?i.lower:null,upper:Xn(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>ys(i,t.length)).slice(0,40));return{name:xs(n.name,60),convention:n.convention,joints:t,base:_s(n.base)??Ji(),tool:_s(n.tool)??Ji(),postures:e,manufacturer:xs(n.manufacturer,200),source:xs(n.source,2e3),notes:xs(n.notes,3e3),actuator:$3(n.actuator),catalog:xs(n.catalog,60)||void 0,derived:xs(n.derived,60)||void 0,coupling:q3(n.coupling,t.length)}}var xM={joint:0,line:0,circle:0,spline:0,frame:0,call:0,wait:"seconds",gripper:"value",output:"port"};function Y3(n,t){if(!n||!Object.hasOwn(xM,n.kind))return null;let e=xM[n.kind];if(e)return Xn(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;if(n.kind==="call")return[n.first,n.last,n.times].every(l=>Number.isInteger(l)&&l>=1&&l<=200)?{kind:"call",first:n.first,last:n.last,times:Math.min(n.times,50)}:null;if(n.kind==="frame")return _s(n.T)?{kind:"frame",T:_s(n.T)}:null;let i=n.kind==="joint"&&ys(n.q,t)?n.q.slice():null,s=_s(n.T),r=n.kind==="circle"&&ys(n.centre,3)?n.centre.slice():null;if(!s||n.kind==="circle"&&!r&&!_s(n.via))return null;let o=n.kind==="spline"&&Array.isArray(n.through)?n.through.slice(0,100).map(_s):null;if(n.kind==="spline"&&(!o?.length||o.includes(null)))return null;let a=(l,c)=>c===null?{}:{[l]:c};return{kind:n.kind,...a("q",i),T:s,...a("via",_s(n.via)),...a("through",o),...r?{centre:r,long_way:!!n.long_way}:{},...a("speed",Xn(n.speed)&&n.speed>0?n.speed:null),blend:Xn(n.blend)&&n.blend>=0?n.blend:0}}var C0={frame:[],box:["size"],cylinder:["r","h"]};function j3(n){if(!n||!Object.hasOwn(C0,n.kind))return null;let t=_s(n.T),e=xs(n.name,40),i=s=>s==="size"?ys(n.size,3)&&n.size.every(r=>r>0):Xn(n[s])&&n[s]>0;return!t||!e||!C0[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(C0[n.kind].map(s=>[s,n[s]]))}}function Z3(n,t){if(!n||typeof n!="object")return null;let e=s=>s&&Xn(s.turn)&&ys(s.q,t)?{turn:s.turn,q:s.q.slice(),branch:xs(s.branch,80)}:null,i=(s,r)=>Xn(s)&&s>=0&&s<r?s:0;return{turn:ys(n.turn,2)?n.turn.slice():null,cone:i(n.cone,Math.PI/2),axis:["x","y","z"].includes(n.axis)?n.axis:"z",cost:n.cost==="time"?"time":"motion",singularity:i(n.singularity,1),clearance:i(n.clearance,1e3),start:e(n.start),end:e(n.end)}}function J3(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};b.program=e(i.steps,s=>Y3(s,t),200),b.start=ys(i.start,t)?i.start.slice():null,b.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||Xn(r)&&r>0))),b.world=e(n.world,j3,60),b.routing=Z3(n.routing,t),["sketch","real","both"].includes(n.look?.mode)&&Xn(n.look.opacity)&&(b.look={mode:n.look.mode,opacity:Math.min(Math.max(n.look.opacity,.1),.9)})}function Su(n,t,e=null){let i=n&&n.pieper===_M?X3(n.table):null;if(!i)throw new Error("This is not a state of the workbench.");let s=i.joints.length;e&&ct("did",{label:e}),gM(document),Array.isArray(n.units)&&(gt.set("angle",n.units[0]),gt.set("length",n.units[1])),Object.hasOwn(Fs,n.notation)&&(b.notation=n.notation),["auto","light","dark"].includes(n.theme)&&of(n.theme),b.shownFrames=Array.isArray(n.frames)?n.frames.filter(l=>Number.isInteger(l)&&l>=0&&l<s+2):null;let r=n.path??{};yn(i,{q:ys(n.q,s)?n.q:null,step:!1,what:"new"}),Object.assign(b.path,{from:_s(r.from),to:_s(r.to),n:Number.isInteger(r.n)&&r.n>=2&&r.n<=2e3?r.n:50,seconds:Xn(r.seconds)&&r.seconds>0?r.seconds:5}),b.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(l=>l&&ys(l.q,s)&&Xn(l.seconds)&&Xn(l.hold)).slice(0,40).map(l=>({name:xs(l.name,20)||"P",q:l.q.slice(),seconds:l.seconds,hold:l.hold})),J3(n,s),["pose","position","position+axis"].includes(n.task)&&(pe.task=n.task);let o=Object.entries(n.redundancy??{}).filter(([l,c])=>l.length<80&&Xn(c));pe.redundancy=o.length?Object.fromEntries(o.slice(0,yM)):null,typeof n.follow=="boolean"&&(pe.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(pe.ghosts=n.ghosts);let a=_s(n.target);b.hasTarget=!!a,a&&wi(a,"restored",W3(n.digits));for(let l of["units","notation","sequence-loaded","task","program","world"])ct(l);t(n.panel),ct("path-loaded"),ct("routing","loaded"),ct("look","loaded"),ys(n.camera,6)&&eb(n.camera),Oi(b.q,"restored"),e?na():Wf()}async function vM(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function qf(){let n=await vM(new TextEncoder().encode(JSON.stringify(wl())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}var bM=async()=>K3()??await MM(location.hash);async function MM(n){let t=/^#s=([\w-]+)$/.exec(n);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await vM(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var SM="pieper-workbench";function K3(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(SM)??"{}");return t&&n===location.href?t:null}catch{return null}}function Q3(){if(b.table.joints.length)try{sessionStorage.setItem(SM,JSON.stringify({address:location.href,shown:wl()}))}catch{}}var P0=null,t2=tr(async()=>{if(!b.table.joints.length)return;let n=await qf();n!==P0&&(P0=n,history.replaceState(null,"",n))},600);async function e2(n){if(location.href!==P0)try{let t=await MM(location.hash);t&&Su(t,n,"open a link")}catch(t){he(`The link could not be read: ${t.message}`,"wrong")}}function wM(n){addEventListener("pagehide",Q3),addEventListener("hashchange",()=>e2(n)),tt(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","routing","look","theme","frames"],t2)}function wu(n){if(n.length>2e4)throw new Error("longer than 20000 characters");let t=i2(n);return/[[\]{}]/.test(t)||CM(t,t.search(/\S/))?l2(t):t.includes("	")?RM(t,"	"):t.includes(";")?a2(t):AM(t)}function I0(n){if(n.length>2e4)return null;let t=wu(n);return t.length>1||(t[0]?.length??0)>1?t:null}function i2(n){let t=n.replace(/\r\n?/g,`
`).replace(/[\u00a0\u202f\u2007]/g," ");return/\\begin\b|&/.test(t)&&(t=t.replace(/\\(?:begin|end)\s*\{[^}]*\}(?:\{[clr|]*\})?|\\(?:left|right)\s*[[\]().|]|\\hline|\$/g,"").replace(/[ \t]+/g," ").replace(/\\\\(?:\[[^\]]*\])?\s*/g,`
`).replaceAll("\\","").replace(/ ?& ?/g,"	")),t.replace(/^\s*[A-Za-z_][\w.]*\s*=\s*/,"").replace(/\b(?:np|numpy)\.(?:float|double|single|int)\w*\(([^()]*)\)/g,"$1").replace(/^\s*[A-Za-z_][\w.]*\s*\(\s*(?=[[{])/,"").replace(/(?:,\s*[A-Za-z_]\w*\s*=\s*[\w.'"]+\s*)*\)?\s*[;,]?\s*$/,e=>/[=;,]/.test(e)?"":e).replace(/^(?:[ ]*\n)+|\n\s*$/g,"")}var s2=/\s*,\s+|\s+,\s*|\s+/,L0=n=>n.trim().replace(/\s*([*/^·])\s*/g,"$1").replace(/(?<=[\w.)°π])\s+([-+−])\s+(?=\S)/g,"$1").replace(/(?<=[\d.)πi])\s+(?=(?:deg|rad|mm|cm|m|°)(?![\wπ]))/g,"").replace(/\(\s+/g,"(").replace(/\s+\)/g,")"),EM=/^[-+−]?\d{1,3}(?:(?:,\d{3})+(?:\.\d*)?|(?:\.\d{3})+,\d*)$/,r2=n=>/\d,\d/.test(n)&&!/,(?!\d)|(?<!\d),|\./.test(n)&&/[\d)][ \t]+[-+−]?\d/.test(n);function TM(n){let t=n.filter(Boolean);if(t.some(i=>/,\s|\s,/.test(i.replace(/,$/,""))))return i=>i.split(/\s*,\s*|\s+/);if(t.some(i=>/\s/.test(i)))return i=>i.split(s2);if(t.every(i=>EM.test(i)))return null;let e=i=>!EM.test(i)&&(/,.*,/.test(i)||i.includes(",")&&/[.A-Za-zπ(]|,[-+−]/.test(i));return t.some(e)?i=>i.split(","):null}var o2=n=>{let t=n.map(e=>e.trim());return t.at(-1)===""&&t.pop(),t};function AM(n){let t=n.split(`
`).map(L0),e=TM(t);return e?t.filter(Boolean).map(i=>o2(e(i))):t.map(i=>[i.replace(/,$/,"")])}function RM(n,t){let e=n.split(`
`).filter(i=>i.includes(t)||i.trim()).map(i=>i.split(t).map(s=>s.trim().replace(/^"(.*)"$/,"$1")));for(;e.length&&e.at(-1).every(i=>!i);)e.pop();return e}function a2(n){let t=n.split(`
`).filter(s=>s.trim()),e=n.split(/[;\n]/).map(L0).filter(Boolean);return t.length>1&&t.slice(0,-1).every(s=>/^[^;]*;\s*$/.test(s))||TM(e)?AM(e.join(`
`)):RM(n,";")}function CM(n,t){if(n[t]!=="("||/[\w)π°.*/^+−-]\s*$/.test(n.slice(0,t)))return!1;let e=0;for(let i=t;i<n.length;i++)if("([".includes(n[i]))e+=1;else{if(")]".includes(n[i])&&(e-=1)===0)return!1;if(n[i]===","&&e===1)return!0}return!1}function l2(n){let t=/[[({]\s*[[({]|[\])}]\s*,?\s*[[({]/.test(n),e=r2(n.replace(/[\])}]\s*,\s*(?=[[({])/g,";")),i=[],s=[],r="",o=()=>{let a=t?r.replaceAll(`
`," "):r.replace(/(,|\.\.\.)\s*\n/g,"$1 ");for(let l of a.replaceAll("..."," ").split(/[;\n]/)){let c=L0(l).split(e?/\s+/:/\s*,\s*|\s+/).filter(Boolean);c.some(u=>/[\wπ]/.test(u))&&i.push(c)}r=""};for(let a=0;a<n.length;a++){let l=n[a];"[{".includes(l)||l==="("&&CM(n,a)?(s.push(!0),o()):l==="("?(s.push(!1),r+=l):"])}".includes(l)&&(s.pop()??l!==")")?o():r+=l}return o(),i}function PM(n,t,e,i){let s={filled:0,empty:0,lost:0};return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n()[t+o]?.[e+l];c?!a&&!c.mayBeEmpty?s.empty+=1:(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s.filled+=1):s.lost+=a?1:0})),s}function IM({filled:n,empty:t,lost:e}){let i=[`Pasted ${n} number${n===1?"":"s"}`];t&&i.push(t===1?"an empty cell left what stood there":`${t} empty cells left what stood there`),e&&i.push(`${e} had no cell`),he(`${i.join("; ")}.`,t||e?"wrong":"plain")}function Xf(n,t,e=()=>{}){let i=()=>[...n.rows].map(s=>[...s.querySelectorAll("input.number")]);n.addEventListener("paste",s=>{let r=s.target.matches("input.number")&&I0(s.clipboardData.getData("text"));if(!r)return;s.preventDefault();let o=i().findIndex(l=>l.includes(s.target)),a=i()[o].indexOf(s.target);Mu(t,()=>{e(o+r.length),IM(PM(i,o,a,r))})})}function Yf(n,t,e){n.addEventListener("paste",i=>{let s=e(),r=s.indexOf(i.target),o=r>=0&&I0(i.clipboardData.getData("text"))?.flat();if(!o)return;i.preventDefault();let a=o.length===s.length?0:r;if(o.length>s.length-a){let l=s.length-a;he(`${o.length} numbers for ${l} field${l===1?"":"s"}: nothing was pasted.`,"wrong");return}Mu(t,()=>IM(PM(()=>[e()],0,a,[o])))})}var Ze=n=>n.type==="R"?"angle":"length";function LM(n){let t=n.type==="R"?Math.PI:Gn(b.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var c2=nu;function u2(n){let t=b.table.joints[n],e=Ze(t),{lo:i,hi:s,min:r,max:o}=LM(t),a=`q${n+1}`,l=S("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=_=>`${100*(_-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{xi(),Ju(n,Number(l.value))}),l.addEventListener("change",()=>ct("let-go")),l.addEventListener("keydown",_=>{let m={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[_.key],g={Home:i,End:s}[_.key];if(m===void 0&&g===void 0)return;_.preventDefault(),xi();let x=gt.step(e)*(_.shiftKey?.1:1);Ju(n,g??Math.min(Math.max(Math.round((b.q[n]+m*x)/(x/10))*(x/10),r),o))});let u=Mn({label:`${a} value`,kind:e,testid:`q-${n+1}`,key:`q/${t.name}`,input:_=>{xi(),Ju(n,_)}}),h=S("span",{class:"out",role:"note"}),d=S("span",{class:"chain",title:"What this row of the table moves by"}),f=S("span",{class:"limits"}),p=S("div",{class:"joint","data-testid":`joint-${n+1}`},S("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},S("i",{text:"q"}),S("sub",{text:String(n+1)})),S("div",{class:"track"},l,S("div",{class:"under"},f,d,h)),u,S("span",{class:"unit"}));return{el:p,number:u,show(){let _=b.q[n],m=c2(t,_);(document.activeElement!==l||Number(l.value)!==_)&&(l.value=_),l.style.setProperty("--at",c(Math.min(Math.max(_,r),o))),l.setAttribute("aria-valuetext",re(_,e)),u.put(_,String(Number((_*gt.factor(e)).toFixed(gt.digits(e)+1))+0)),p.classList.toggle("outside",m!==0);let g=b.table.coupling?`chain ${re(Mr(b.table,b.q)[n],e)}`:"";bt(d,g),bt(h,m?`${re(Math.abs(m),e)} ${m>0?"above":"below"} the limit`:"")},relabel(){bt(p.lastChild,gt.symbol(e));let _=m=>m===null?"no limit":re(m,e,gt.angle==="deg"&&e==="angle"?0:void 0);bt(f,t.lower===null&&t.upper===null?"no limits":`${_(t.lower)} \u2026 ${_(t.upper)}`),u.refresh(),this.show()}}}var DM={id:"joints",title:"Joints",build(n){let t=[],e=S("div",{class:"joints","data-testid":"joints"}),i=S("div",{class:"chips",role:"group","aria-label":"Postures"}),s=S("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=b.table.joints.map((o,a)=>u2(a)),Gt(e,t.map(o=>o.el)),t.length||e.append(S("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Gt(s,b.table.actuator?h2(b.table.actuator):null),d2(i)};Yf(e,"paste joint values",()=>t.map(o=>o.number)),tt("table",o=>{o==="undo"||o==="new"?r():o!=="gripper"&&$i(e,r)}),tt("q",()=>t.forEach(o=>o.show())),tt("units",()=>t.forEach(o=>o.relabel())),r()}};function h2(n){let t=S("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=S("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),bt(e,ii(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},yn({...b.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=S("div",{class:"under"},S("span",{text:`${n.name}: moves no frame`}));return S("div",{class:"joint"},S("span",{class:"joint-name",text:"tool"}),S("div",{class:"track"},t,s),e,S("span",{class:"unit",text:n.unit}))}function d2(n){let t=b.table.joints.length,e=Object.entries(b.table.postures??{}),i=(r,o)=>Ut(r,{class:"chip",title:o.map((a,l)=>re(a,Ze(b.table.joints[l]))).join(", ")},()=>Ii(o,.8,`move to ${r}`)),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Gt(n,s,t?Ut("Random",{class:"chip quiet",title:"A posture inside the limits"},()=>Ii(f2(),.8,"move to a random posture")):null,t?Ut("Keep this one",{class:"chip quiet",title:"Add the present posture to the arm"},p2):null)}function f2(){return b.table.joints.map(n=>{let{lo:t,hi:e}=LM(n);return t+Math.random()*(e-t)})}function p2(){let n={...b.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=b.q.slice(),yn({...b.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),he(`Kept as P${t}: ${b.q.map((e,i)=>ru(e,Ze(b.table.joints[i]))).join(", ")}`),ct("postures")}var UM=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["accelerations","Accelerations"],["toolspeed","Tool speed"],["singularity","Distance to singularity"]];function dr({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o,ddq:a,events:l=[],title:c,...u}){let h=t.map(p=>As(n,p)),d=h.map(p=>te(p[p.length-1])),f=o??D0(t,r);return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:l,title:c,...u,tool:d,speeds:f,accelerations:a??D0(f,r),toolspeeds:D0(d,r).map(Ui),least:t.map((p,_)=>ac(n,p,h[_])[0]??0)}}function D0(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}var m2=1e6;function g2(n,t,e){let i=n.table.joints[e];if(t==="joints")return[i.lower,i.upper];let s=n.limits?.[{speeds:"speed",accelerations:"acceleration"}[t]],r=Array.isArray(s)?s[e]:s??null;return r===null||r>=m2?[null,null]:[-r,r]}var x2={speeds:"speed",accelerations:"acceleration",toolspeed:"tool speed"},NM=(n,t,e=null)=>(n.tight??[]).filter(i=>i.limit===x2[t]&&i.joint===e),OM=(n,t)=>(n.tight??[]).filter(e=>e.start-1e-9<=t&&t<=e.end+1e-9).map(e=>e.joint?`${e.limit} of ${e.joint}`:e.limit).join(", ");function N0(n,t){let{table:e}=n,i=gt.factor("length");if(t==="position")return{y:`tool, ${gt.length}`,list:["X","Y","Z"].map((c,u)=>jf(c,n.tool.map(h=>h[u]*i)))};if(t==="singularity")return{y:"smallest singular value",list:[jf("\u03C3 min",n.least)]};if(t==="toolspeed"){let c=n.limits?.tool_speed??null,u=n.toolspeeds.map(h=>h*i);return{y:`tool, ${gt.length}/s`,list:[jf("tool speed",u,[null,c&&c*i],NM(n,t))]}}let s={joints:n.q,speeds:n.speeds,accelerations:n.accelerations}[t],r={joints:"",speeds:"/s",accelerations:"/s\xB2"}[t],a=[...new Set(e.joints.map(Ze))].map(c=>(c==="angle"?gt.angle:gt.length)+r).join(" or "),l=e.joints.map((c,u)=>{let h=gt.factor(Ze(c));return jf(`q${u+1}`,s.map(d=>d[u]*h),g2(n,t,u).map(d=>d===null?null:d*h),NM(n,t,c.name))});return{y:a,list:l}}var jf=(n,t,e=[null,null],i=[])=>({name:n,values:t,limits:e,binds:i});function Eu(n){let t=n.flatMap((i,s)=>i.limits.filter(r=>r!==null).map(r=>({value:r,of:s}))),e=new Map;for(let i of t)e.set(i.value,[...e.get(i.value)??[],i.of]);return[...e].map(([i,s])=>({value:i,of:s.length===1&&n.length>1?s[0]:null}))}function FM(n){let t=gt.angle,e=gt.length,{table:i}=n,s=l=>Ze(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*gt.factor("length")),...l.map((u,h)=>u*gt.factor(Ze(i.joints[h]))),...n.speeds[c].map((u,h)=>u*gt.factor(Ze(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function BM(n,t,e){let{y:i,list:s}=N0(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(y=>y.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,p]=[Math.min(...c),Math.max(...c)];p-f>1e-9||(f-=1,p+=1);let _=y=>a.l+(y-h)/(d-h)*(r-a.l-a.r),m=y=>o-a.b-(y-f)/(p-f)*(o-a.t-a.b),g=(y,w)=>{let N=(w-y)/6,R=10**Math.floor(Math.log10(N)),L=[1,2,5,10].map(z=>z*R).find(z=>z>=N);return Array.from({length:12},(z,G)=>(Math.ceil(y/L)+G)*L).filter(z=>z<=w+L*1e-6)},x=y=>y.toFixed(2),M=y=>String(Number(y.toPrecision(6))),v=y=>y.replace(/[&<>"]/g,w=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[w]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],E=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let y of g(f,p))E.push(`<path d="M${a.l} ${x(m(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(m(y)+4)}" text-anchor="end">${M(y)}</text>`);for(let y of g(h,d))E.push(`<path d="M${x(_(y))} ${o-a.b}v5" stroke="#333"/><text x="${x(_(y))}" y="${o-a.b+20}" text-anchor="middle">${M(y)}</text>`);E.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&E.push(`<path d="M${x(_(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(_(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(y.short)}</text>`);for(let{value:y,of:w}of Eu(s))y>=f&&y<=p&&E.push(`<path d="M${a.l} ${x(m(y))}H${r-a.r}" stroke="${w===null?"#333":e[w%e.length]}" stroke-dasharray="2 5"/>`);return s.forEach((y,w)=>{let N=e[w%e.length],R=y.values[y.values.length-1];E.push(`<polyline fill="none" stroke="${N}" stroke-width="1.8" stroke-dasharray="${A[w%A.length]}" points="${y.values.map((L,z)=>`${x(_(l[z]))},${x(m(L))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*w}h22" stroke="${N}" stroke-width="2" stroke-dasharray="${A[w%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*w}"><title>${x(R)}</title>${v(y.name)}</text>`)}),E.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${E.join("")}</svg>
`}var _2="uplot",y2="u-hz",v2="u-vt",b2="u-title",M2="u-wrap",S2="u-under",w2="u-over",E2="u-axis",ra="u-off",T2="u-select",A2="u-cursor-x",R2="u-cursor-y",C2="u-cursor-pt",P2="u-legend",I2="u-live",L2="u-inline",D2="u-series",N2="u-marker",kM="u-label",U2="u-value",Au="width",Ru="height";var zM="bottom",El="left",U0="right",K0="#000",HM=K0+"0",O0="mousemove",GM="mousedown",F0="mouseup",VM="mouseenter",WM="mouseleave",$M="dblclick",O2="resize",F2="scroll",qM="change",tp="dppxchange",Q0="--",Ll=typeof window<"u",G0=Ll?document:null,Al=Ll?window:null,B2=Ll?navigator:null,We,Zf;function V0(){let n=devicePixelRatio;We!=n&&(We=n,Zf&&$0(qM,Zf,V0),Zf=matchMedia(`(min-resolution: ${We-.001}dppx) and (max-resolution: ${We+.001}dppx)`),oa(qM,Zf,V0),Al.dispatchEvent(new CustomEvent(tp)))}function rs(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function W0(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function gn(n,t,e){n.style[t]=e+"px"}function zs(n,t,e,i){let s=G0.createElement(n);return t!=null&&rs(s,t),e?.insertBefore(s,i),s}function vs(n,t){return zs("div",n,t)}var XM=new WeakMap;function fr(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=XM.get(n);r!=o&&(n.style.transform=r,XM.set(n,r),t<0||e<0||t>i||e>s?rs(n,ra):W0(n,ra))}var YM=new WeakMap;function jM(n,t,e){let i=t+e,s=YM.get(n);i!=s&&(YM.set(n,i),n.style.background=t,n.style.borderColor=e)}var ZM=new WeakMap;function JM(n,t,e,i){let s=t+""+e,r=ZM.get(n);s!=r&&(ZM.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var tx={passive:!0},k2={...tx,capture:!0};function oa(n,t,e,i){t.addEventListener(n,e,i?k2:tx)}function $0(n,t,e,i){t.removeEventListener(n,e,tx)}Ll&&V0();function Hs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:os((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function ES(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var TS=n=>n!=null,AS=n=>n!=null&&n>0,ip=ES(TS),z2=ES(AS);function H2(n,t,e,i=0,s=!1){let r=s?z2:ip,o=s?AS:TS;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??sn,l??-sn]}function sp(n,t,e,i){let s=tS(n),r=tS(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Gr:RS,a=s==1?os:bs,l=r==1?bs:os,c=a(o(jn(n))),u=l(o(jn(t))),h=Rl(e,c),d=Rl(e,u);return e==10&&(c<0&&(h=rn(h,-c)),u<0&&(d=rn(d,-u))),i||e==2?(n=h*s,t=d*r):(n=LS(n,h),t=rp(t,d)),[n,t]}function ex(n,t,e,i){let s=sp(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var nx=.1,KM={mode:3,pad:nx},Pu={pad:0,soft:null,mode:0},G2={min:Pu,max:Pu};function ep(n,t,e,i){return op(e)?QM(n,t,e):(Pu.pad=e,Pu.soft=i?0:null,Pu.mode=i?3:0,QM(n,t,G2))}function ke(n,t){return n??t}function V2(n,t,e){for(t=ke(t,0),e=ke(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function QM(n,t,e){let i=e.min,s=e.max,r=ke(i.pad,0),o=ke(s.pad,0),a=ke(i.hard,-sn),l=ke(s.hard,sn),c=ke(i.soft,sn),u=ke(s.soft,-sn),h=ke(i.mode,0),d=ke(s.mode,0),f=t-n,p=Gr(f),_=Di(jn(n),jn(t)),m=Gr(_),g=jn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=sn&&(r=0),d==2&&u!=-sn&&(o=0)));let x=f||_||1e3,M=Gr(x),v=Rl(10,os(M)),A=x*(f==0?n==0?.1:1:r),E=rn(LS(n-A,v/10),24),y=n>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:sn,w=Di(a,E<y&&n>=y?y:Gs(y,E)),N=x*(f==0?t==0?.1:1:o),R=rn(rp(t+N,v/10),24),L=t<=u&&(d==1||d==3&&R>=u||d==2&&R<=u)?u:-sn,z=Gs(l,R>L&&t<=L?L:Di(L,R));return w==z&&w==0&&(z=100),[w,z]}var W2=new Intl.NumberFormat(Ll?B2.language:"en-US"),ix=n=>W2.format(n),as=Math,Qf=as.PI,jn=as.abs,os=as.floor,Yn=as.round,bs=as.ceil,Gs=as.min,Di=as.max,Rl=as.pow,tS=as.sign,Gr=as.log10,RS=as.log2,$2=(n,t=1)=>as.sinh(n)*t,B0=(n,t=1)=>as.asinh(n/t),sn=1/0;function eS(n){return(Gr((n^n>>31)-(n>>31))|0)+1}function q0(n,t,e){return Gs(Di(n,t),e)}function CS(n){return typeof n=="function"}function Ne(n){return CS(n)?n:()=>n}var q2=()=>{},PS=n=>n,IS=(n,t)=>t,X2=n=>null,nS=n=>!0,iS=(n,t)=>n==t,Y2=/\.\d*?(?=9{6,}|0{6,})/gm,aa=n=>{if(NS(n)||To.has(n))return n;let t=`${n}`,e=t.match(Y2);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${aa(s)}e${r}`}return rn(n,i)};function ia(n,t){return aa(rn(aa(n/t))*t)}function rp(n,t){return aa(bs(aa(n/t))*t)}function LS(n,t){return aa(os(aa(n/t))*t)}function rn(n,t=0){if(NS(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Yn(i)/e}var To=new Map;function DS(n){return((""+n).split(".")[1]||"").length}function Lu(n,t,e,i){let s=[],r=i.map(DS);for(let o=t;o<e;o++){let a=jn(o),l=rn(Rl(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:rn(u,h);s.push(d),To.set(d,h)}}return s}var Iu={},sx=[],Cl=[null,null],Eo=Array.isArray,NS=Number.isInteger,j2=n=>n===void 0;function sS(n){return typeof n=="string"}function op(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Z2(n){return n!=null&&typeof n=="object"}var J2=Object.getPrototypeOf(Uint8Array),US="__proto__";function Pl(n,t=op){let e;if(Eo(n)){let i=n.find(s=>s!=null);if(Eo(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Pl(n[s],t)}else e=n.slice()}else if(n instanceof J2)e=n.slice();else if(t(n)){e={};for(let i in n)i!=US&&(e[i]=Pl(n[i],t))}else e=n;return e}function Bn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=US&&(op(n[s])?Bn(n[s],Pl(i[s])):n[s]=Pl(i[s]))}return n}var K2=0,Q2=1,tL=2;function eL(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function nL(n,t){if(rL(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return oL(o[0])||(o=sL(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:Q2,f=[];for(let p=0;p<u.length;p++){let _=u[p],m=r.get(l[p]);_===null?d!=K2&&(h[m]=_,d==tL&&f.push(m)):h[m]=_}eL(h,f,s),i.push(h)}}return i}var iL=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function sL(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function rL(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function oL(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Di(1,os((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var OS=["January","February","March","April","May","June","July","August","September","October","November","December"],FS=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function BS(n){return n.slice(0,3)}var aL=FS.map(BS),lL=OS.map(BS),cL={MMMM:OS,MMM:lL,WWWW:FS,WWW:aL};function Tu(n){return(n<10?"0":"")+n}function uL(n){return(n<10?"00":n<100?"0":"")+n}var hL={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Tu(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Tu(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Tu(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Tu(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Tu(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>uL(n.getMilliseconds())};function rx(n,t){t=t||cL;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?hL[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var dL=new Intl.DateTimeFormat().resolvedOptions().timeZone;function fL(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==dL?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var kS=n=>n%1==0,np=[1,2,2.5,5],pL=Lu(10,-32,0,np),zS=Lu(10,0,32,np),mL=zS.filter(kS),sa=pL.concat(zS),ox=`
`,HS="{YYYY}",rS=ox+HS,GS="{M}/{D}",Cu=ox+GS,Jf=Cu+"/{YY}",VS="{aa}",gL="{h}:{mm}",Tl=gL+VS,oS=ox+Tl,aS=":{ss}",qe=null;function WS(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Lu(10,0,3,np).filter(kS):Lu(10,-3,0,np)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,HS,qe,qe,qe,qe,qe,qe,1],[s*28,"{MMM}",rS,qe,qe,qe,qe,qe,1],[s,GS,rS,qe,qe,qe,qe,qe,1],[i,"{h}"+VS,Jf,qe,Cu,qe,qe,qe,1],[e,Tl,Jf,qe,Cu,qe,qe,qe,1],[t,aS,Jf+" "+Tl,qe,Cu+" "+Tl,qe,oS,qe,1],[n,aS+".{fff}",Jf+" "+Tl,qe,Cu+" "+Tl,qe,oS,qe,1]];function u(h){return(d,f,p,_,m,g)=>{let x=[],M=m>=o,v=m>=r&&m<o,A=h(p),E=rn(A*n,3),y=k0(A.getFullYear(),M?0:A.getMonth(),v||M?1:A.getDate()),w=rn(y*n,3);if(v||M){let N=v?m/r:0,R=M?m/o:0,L=E==w?E:rn(k0(y.getFullYear()+R,y.getMonth()+N,1)*n,3),z=new Date(Yn(L/n)),G=z.getFullYear(),F=z.getMonth();for(let U=0;L<=_;U++){let D=k0(G+R*U,F+N*U,1),O=D-h(rn(D*n,3));L=rn((+D+O)*n,3),L<=_&&x.push(L)}}else{let N=m>=s?s:m,R=os(p)-os(E),L=w+R+rp(E-w,N);x.push(L);let z=h(L),G=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,F=m/i,U=d.axes[f]._space,D=g/U;for(;L=rn(L+m,n==1?0:3),!(L>_);)if(F>1){let O=os(rn(G+F,6))%24,J=h(L).getHours()-O;J>1&&(J=-1),L-=J*i,G=(G+F)%24;let nt=x[x.length-1];rn((L-nt)/m,3)*D>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,u]}var[xL,_L,yL]=WS(1),[vL,bL,ML]=WS(.001);Lu(2,-53,53,[1]);function lS(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function cS(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let _=n(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),M=_.getHours(),v=_.getMinutes(),A=_.getSeconds(),E=m!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||M!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,u=x,h=M,d=v,f=A,E(_)})}}function SL(n,t){let e=rx(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function k0(n,t,e){return new Date(n,t,e)}function uS(n,t){return t(n)}var wL="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function hS(n,t){return(e,i,s,r)=>r==null?Q0:t(n(i))}function EL(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function TL(n,t){return n.series[t].fill(n,t)}var AL={show:!0,live:!0,isolate:!1,mount:q2,markers:{show:!0,width:2,stroke:EL,fill:TL,dash:"solid"},idx:null,idxs:null,values:[]};function RL(n,t){let e=n.cursor.points,i=vs(),s=e.size(n,t);gn(i,Au,s),gn(i,Ru,s);let r=s/-2;gn(i,"marginLeft",r),gn(i,"marginTop",r);let o=e.width(n,t,s);return o&&gn(i,"borderWidth",o),i}function CL(n,t){let e=n.series[t].points;return e._fill||e._stroke}function PL(n,t){let e=n.series[t].points;return e._stroke||e._fill}function IL(n,t){return n.series[t].points.size}var z0=[0,0];function LL(n,t,e){return z0[0]=t,z0[1]=e,z0}function Kf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function H0(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var DL={show:!0,x:!0,y:!0,lock:!1,move:LL,points:{one:!1,show:RL,size:IL,width:0,stroke:PL,fill:CL},bind:{mousedown:Kf,mouseup:Kf,click:Kf,dblclick:Kf,mousemove:H0,mouseleave:H0,mouseenter:H0},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},$S={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ax=Bn({},$S,{filter:IS}),qS=Bn({},ax,{size:10}),XS=Bn({},$S,{show:!1}),lx='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',YS="bold "+lx,jS=1.5,dS={show:!0,scale:"x",stroke:K0,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:YS,side:2,grid:ax,ticks:qS,border:XS,font:lx,lineGap:jS,rotate:0},NL="Value",UL="Time",fS={show:!0,scale:"x",auto:!1,sorted:1,min:sn,max:-sn,idxs:[]};function OL(n,t,e,i,s){return t.map(r=>r==null?"":ix(r))}function FL(n,t,e,i,s,r,o){let a=[],l=To.get(s)||0;e=o?e:rn(rp(e,s),l);for(let c=e;c<=i;c=rn(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function X0(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Gr:RS,u=os(c(e));s=Rl(l,u),l==10&&(s=sa[Hs(s,sa)]);let h=e,d=s*l;l==10&&(d=sa[Hs(d,sa)]);do a.push(h),h=h+s,l==10&&!To.has(h)&&(h=rn(h,To.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=sa[Hs(d,sa)]));while(h<=i);return a}function BL(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?X0(n,t,Di(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?X0(n,t,Di(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var ZS=/./,kL=/[12357]/,zL=/[125]/,pS=/1/,Y0=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function HL(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?ZS:l(7,o)-u>=c?kL:l(5,o)-u>=c?zL:pS;if(h==pS){let d=jn(l(1,o)-u);if(d<c)return Y0(t.slice().reverse(),a.distr,h,bs(c/d)).reverse()}return Y0(t,a.distr,h,1)}function GL(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=jn(l(1,o)-l(2,o));return c<a?Y0(t.slice().reverse(),3,ZS,bs(a/c)).reverse():t}function VL(n,t,e,i){return i==null?Q0:t==null?"":ix(t)}var mS={show:!0,scale:"y",stroke:K0,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:YS,side:3,grid:ax,ticks:qS,border:XS,font:lx,lineGap:jS,rotate:0};function WL(n,t){let e=3+(n||1)*2;return rn(e*t,3)}function $L(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=jn(o-r),l=n.series[t],c=a/(l.points.space*We);return i[1]-i[0]<=c}var gS={scale:null,auto:!0,sorted:0,min:sn,max:-sn},JS=(n,t,e,i,s)=>s,xS={show:!0,auto:!0,sorted:0,gaps:JS,alpha:1,facets:[Bn({},gS,{scale:"x"}),Bn({},gS,{scale:"y"})]},_S={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:JS,alpha:1,points:{show:$L,filter:null},values:null,min:sn,max:-sn,idxs:[],path:null,clip:null};function qL(n,t,e,i,s){return e/10}var KS={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},XL=Bn({},KS,{time:!1,ori:1}),yS={};function QS(n,t){let e=yS[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(yS[n]=e)),e}var Il=1,j0=2;function la(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,g,d,f,p,_,lp,Dl,up,ew,iw):e(s,l,c,u,h,g,m,f,d,_,p,cp,Nl,hx,nw,sw)}function cx(n,t){let e=0,i=0,s=ke(n.bands,sx);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function YL(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Vr(n,t,e,i,s,r){return la(n,t,(o,a,l,c,u,h,d,f,p,_,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),M=c.ori==0?Dl:Nl,v,A;x==1?(v=e,A=i):(v=i,A=e);let E=g(h(a[v],c,_,f)),y=g(d(l[v],u,m,p)),w=g(h(a[A],c,_,f)),N=g(d(r==1?u.max:u.min,u,m,p)),R=new Path2D(s);return M(R,w,N),M(R,E,N),M(R,E,y),R})}function ap(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?up:hx,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function jL(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function ux(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function vS(n){return n==0?PS:n==1?Yn:t=>ia(t,n)}function tw(n){let t=n==0?lp:cp,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Gs(c,a/2,l/2),u=Gs(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var lp=(n,t,e)=>{n.moveTo(t,e)},cp=(n,t,e)=>{n.moveTo(e,t)},Dl=(n,t,e)=>{n.lineTo(t,e)},Nl=(n,t,e)=>{n.lineTo(e,t)},up=tw(0),hx=tw(1),ew=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},nw=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},iw=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},sw=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function rw(n){return(t,e,i,s,r)=>la(t,e,(o,a,l,c,u,h,d,f,p,_,m)=>{let{pxRound:g,points:x}=o,M,v;c.ori==0?(M=lp,v=ew):(M=cp,v=nw);let A=rn(x.width*We,3),E=(x.size-x.width)/2*We,y=rn(E*2,3),w=new Path2D,N=new Path2D,{left:R,top:L,width:z,height:G}=t.bbox;up(N,R-y,L-y,z+y*2,G+y*2);let F=U=>{if(l[U]!=null){let D=g(h(a[U],c,_,f)),O=g(d(l[U],u,m,p));M(w,D+E,O),v(w,D,O,E,0,Qf*2)}};if(r)r.forEach(F);else for(let U=i;U<=s;U++)F(U);return{stroke:A>0?w:null,fill:w,clip:N,flags:Il|j0}})}function ow(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var ZL=ow(Dl),JL=ow(Nl);function aw(n){let t=ke(n?.alignGaps,0);return(e,i,s,r)=>la(e,i,(o,a,l,c,u,h,d,f,p,_,m)=>{[s,r]=ip(l,s,r);let g=o.pxRound,x=G=>g(h(G,c,_,f)),M=G=>g(d(G,u,m,p)),v,A;c.ori==0?(v=Dl,A=ZL):(v=Nl,A=JL);let E=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Il},w=y.stroke,N=!1;if(r-s>=_*4){let G=ft=>e.posToVal(ft,c.key,!0),F=null,U=null,D,O,Z,X=x(a[E==1?s:r]),J=x(a[s]),nt=x(a[r]),dt=G(E==1?J+1:nt-1);for(let ft=E==1?s:r;ft>=s&&ft<=r;ft+=E){let st=a[ft],xt=(E==1?st<dt:st>dt)?X:x(st),Tt=l[ft];xt==X?Tt!=null?(O=Tt,F==null?(v(w,xt,M(O)),D=F=U=O):O<F?F=O:O>U&&(U=O)):Tt===null&&(N=!0):(F!=null&&A(w,X,M(F),M(U),M(D),M(O)),Tt!=null?(O=Tt,v(w,xt,M(O)),F=U=D=O):(F=U=null,Tt===null&&(N=!0)),X=xt,dt=G(X+E))}F!=null&&F!=U&&Z!=X&&A(w,X,M(F),M(U),M(D),M(O))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let F=l[G];F===null?N=!0:F!=null&&v(w,x(a[G]),M(F))}let[L,z]=cx(e,i);if(o.fill!=null||L!=0){let G=y.fill=new Path2D(w),F=o.fillTo(e,i,o.min,o.max,L),U=M(F),D=x(a[s]),O=x(a[r]);E==-1&&([O,D]=[D,O]),v(G,O,U),v(G,D,U)}if(!o.spanGaps){let G=[];N&&G.push(...ux(a,l,s,r,E,x,t)),y.gaps=G=o.gaps(e,i,s,r,G),y.clip=ap(G,c.ori,f,p,_,m)}return z!=0&&(y.band=z==2?[Vr(e,i,s,r,w,-1),Vr(e,i,s,r,w,1)]:Vr(e,i,s,r,w,z)),y})}function KL(n){let t=ke(n.align,1),e=ke(n.ascDesc,!1),i=ke(n.alignGaps,0),s=ke(n.extend,!1);return(r,o,a,l)=>la(r,o,(c,u,h,d,f,p,_,m,g,x,M)=>{[a,l]=ip(h,a,l);let v=c.pxRound,{left:A,width:E}=r.bbox,y=J=>v(p(J,d,x,m)),w=J=>v(_(J,f,M,g)),N=d.ori==0?Dl:Nl,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Il},L=R.stroke,z=d.dir*(d.ori==0?1:-1),G=w(h[z==1?a:l]),F=y(u[z==1?a:l]),U=F,D=F;s&&t==-1&&(D=A,N(L,D,G)),N(L,F,G);for(let J=z==1?a:l;J>=a&&J<=l;J+=z){let nt=h[J];if(nt==null)continue;let dt=y(u[J]),ft=w(nt);t==1?N(L,dt,G):N(L,U,ft),N(L,dt,ft),G=ft,U=dt}let O=U;s&&t==1&&(O=A+E,N(L,O,G));let[Z,X]=cx(r,o);if(c.fill!=null||Z!=0){let J=R.fill=new Path2D(L),nt=c.fillTo(r,o,c.min,c.max,Z),dt=w(nt);N(J,O,dt),N(J,D,dt)}if(!c.spanGaps){let J=[];J.push(...ux(u,h,a,l,z,y,i));let nt=c.width*We/2,dt=e||t==1?nt:-nt,ft=e||t==-1?-nt:nt;J.forEach(st=>{st[0]+=dt,st[1]+=ft}),R.gaps=J=c.gaps(r,o,a,l,J),R.clip=ap(J,d.ori,m,g,x,M)}return X!=0&&(R.band=X==2?[Vr(r,o,a,l,L,-1),Vr(r,o,a,l,L,1)]:Vr(r,o,a,l,L,X)),R})}function bS(n,t,e,i,s,r,o=sn){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=jn(n[l]-n[a]);u<c&&(c=u,o=jn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function QL(n){n=n||Iu;let t=ke(n.size,[.6,sn,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ne(s),o=1-t[0],a=ke(t[1],sn),l=ke(t[2],1),c=ke(n.disp,Iu),u=ke(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,_,m)=>la(f,p,(g,x,M,v,A,E,y,w,N,R,L)=>{let z=g.pxRound,G=e,F=i*We,U=a*We,D=l*We,O,Z;v.ori==0?[O,Z]=r(f,p):[Z,O]=r(f,p);let X=v.dir*(v.ori==0?1:-1),J=v.ori==0?up:hx,nt=v.ori==0?u:(Nt,se,_e,Ct,tn,Yt,ne)=>{u(Nt,se,_e,tn,Ct,ne,Yt)},dt=ke(f.bands,sx).find(Nt=>Nt.series[0]==p),ft=dt!=null?dt.dir:0,st=g.fillTo(f,p,g.min,g.max,ft),yt=z(y(st,A,L,N)),xt,Tt,At,Jt=R,xe=z(g.width*We),jt=!1,Te=null,Se=null,me=null,xn=null;h!=null&&(xe==0||d!=null)&&(jt=!0,Te=h.values(f,p,_,m),Se=new Map,new Set(Te).forEach(Nt=>{Nt!=null&&Se.set(Nt,new Path2D)}),xe>0&&(me=d.values(f,p,_,m),xn=new Map,new Set(me).forEach(Nt=>{Nt!=null&&xn.set(Nt,new Path2D)})));let{x0:on,size:In}=c;if(on!=null&&In!=null){G=1,x=on.values(f,p,_,m),on.unit==2&&(x=x.map(_e=>f.posToVal(w+_e*R,v.key,!0)));let Nt=In.values(f,p,_,m);In.unit==2?Tt=Nt[0]*R:Tt=E(Nt[0],v,R,w)-E(0,v,R,w),Jt=bS(x,M,E,v,R,w,Jt),At=Jt-Tt+F}else Jt=bS(x,M,E,v,R,w,Jt),At=Jt*o+F,Tt=Jt-At;At<1&&(At=0),xe>=Tt/2&&(xe=0),At<5&&(z=PS);let Je=At>0,Zn=Jt-At-(Je?xe:0);Tt=z(q0(Zn,D,U)),xt=(G==0?Tt/2:G==X?0:Tt)-G*X*((G==0?F/2:0)+(Je?xe/2:0));let Ue={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kn=jt?null:new Path2D,Sn=null;if(dt!=null)Sn=f.data[dt.series[1]];else{let{y0:Nt,y1:se}=c;Nt!=null&&se!=null&&(M=se.values(f,p,_,m),Sn=Nt.values(f,p,_,m))}let Ln=O*Tt,$=Z*Tt;for(let Nt=X==1?_:m;Nt>=_&&Nt<=m;Nt+=X){let se=M[Nt];if(se==null)continue;if(Sn!=null){let j=Sn[Nt]??0;if(se-j==0)continue;yt=y(j,A,L,N)}let _e=v.distr!=2||c!=null?x[Nt]:Nt,Ct=E(_e,v,R,w),tn=y(ke(se,st),A,L,N),Yt=z(Ct-xt),ne=z(Di(tn,yt)),B=z(Gs(tn,yt)),C=ne-B;if(se!=null){let j=se<0?$:Ln,mt=se<0?Ln:$;jt?(xe>0&&me[Nt]!=null&&J(xn.get(me[Nt]),Yt,B+os(xe/2),Tt,Di(0,C-xe),j,mt),Te[Nt]!=null&&J(Se.get(Te[Nt]),Yt,B+os(xe/2),Tt,Di(0,C-xe),j,mt)):J(kn,Yt,B+os(xe/2),Tt,Di(0,C-xe),j,mt),nt(f,p,Nt,Yt-xe/2,B,Tt+xe,C)}}return xe>0?Ue.stroke=jt?xn:kn:jt||(Ue._fill=g.width==0?g._fill:g._stroke??g._fill,Ue.width=0),Ue.fill=jt?Se:kn,Ue})}function tD(n,t){let e=ke(t?.alignGaps,0);return(i,s,r,o)=>la(i,s,(a,l,c,u,h,d,f,p,_,m,g)=>{[r,o]=ip(c,r,o);let x=a.pxRound,M=O=>x(d(O,u,m,p)),v=O=>x(f(O,h,g,_)),A,E,y;u.ori==0?(A=lp,y=Dl,E=iw):(A=cp,y=Nl,E=sw);let w=u.dir*(u.ori==0?1:-1),N=M(l[w==1?r:o]),R=N,L=[],z=[];for(let O=w==1?r:o;O>=r&&O<=o;O+=w)if(c[O]!=null){let X=l[O],J=M(X);L.push(R=J),z.push(v(c[O]))}let G={stroke:n(L,z,A,y,E,x),fill:null,clip:null,band:null,gaps:null,flags:Il},F=G.stroke,[U,D]=cx(i,s);if(a.fill!=null||U!=0){let O=G.fill=new Path2D(F),Z=a.fillTo(i,s,a.min,a.max,U),X=v(Z);y(O,R,X),y(O,N,X)}if(!a.spanGaps){let O=[];O.push(...ux(l,c,r,o,w,M,e)),G.gaps=O=a.gaps(i,s,r,o,O),G.clip=ap(O,u.ori,p,_,m,g)}return D!=0&&(G.band=D==2?[Vr(i,s,r,o,F,-1),Vr(i,s,r,o,F,1)]:Vr(i,s,r,o,F,D)),G})}function eD(n){return tD(nD,n)}function nD(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var Z0=new Set;function MS(){for(let n of Z0)n.syncRect(!0)}Ll&&(oa(O2,Al,MS),oa(F2,Al,MS,!0),oa(tp,Al,()=>{ai.pxRatio=We}));var iD=aw(),sD=rw();function SS(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>J0(r,o,t,e))}function rD(n,t){return n.map((e,i)=>i==0?{}:Bn({},t,e))}function J0(n,t,e,i){return Bn({},t==0?e:i,n)}function lw(n,t,e){return t==null?Cl:[t,e]}var oD=lw;function aD(n,t,e){return t==null?Cl:ep(t,e,nx,!0)}function cw(n,t,e,i){return t==null?Cl:sp(t,e,n.scales[i].log,!1)}var lD=cw;function uw(n,t,e,i){return t==null?Cl:ex(t,e,n.scales[i].log,!1)}var cD=uw;function uD(n,t,e,i,s){let r=Di(eS(n),eS(t)),o=t-n,a=Hs(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?To.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function wS(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Yn((e=+s)*We))+"px"),[n,t,e]}function hD(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=rn(t[2]*We,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ai(n,t,e){let i={mode:ke(n.mode,1)},s=i.mode;function r(T,P,k,H){let Y=P.valToPct(T);return H+k*(P.dir==-1?1-Y:Y)}function o(T,P,k,H){let Y=P.valToPct(T);return H+k*(P.dir==-1?Y:1-Y)}function a(T,P,k,H){return P.ori==0?r(T,P,k,H):o(T,P,k,H)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vs(_2);if(n.id!=null&&(c.id=n.id),rs(c,n.class),n.title){let T=vs(b2,c);T.textContent=n.title}let u=zs("canvas"),h=i.ctx=u.getContext("2d"),d=vs(M2,c);oa("click",d,T=>{T.target===p&&(ln!=ba||_n!=Ma)&&si.click(i,T)},!0);let f=i.under=vs(S2,d);d.appendChild(u);let p=i.over=vs(w2,d);n=Pl(n);let _=+ke(n.pxAlign,1),m=vS(_);(n.plugins||[]).forEach(T=>{T.opts&&(n=T.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?SS(n.series||[],fS,_S,!1):rD(n.series||[null],xS),M=i.axes=SS(n.axes||[],dS,mS,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(T=>{T.fill=Ne(T.fill||null),T.dir=ke(T.dir,-1)});let E=s==2?x[1].facets[0].scale:x[0].scale,y={axes:yr,series:Ce},w=(n.drawOrder||["axes","series"]).map(T=>y[T]);function N(T){let P=T.distr==3?k=>Gr(k>0?k:T.clamp(i,k,T.min,T.max,T.key)):T.distr==4?k=>B0(k,T.asinh):T.distr==100?k=>T.fwd(k):k=>k;return k=>{let H=P(k),{_min:Y,_max:et}=T,ht=et-Y;return(H-Y)/ht}}function R(T){let P=v[T];if(P==null){let k=(n.scales||Iu)[T]||Iu;if(k.from!=null){R(k.from);let H=Bn({},v[k.from],k,{key:T});H.valToPct=N(H),v[T]=H}else{P=v[T]=Bn({},T==E?KS:XL,k),P.key=T;let H=P.time,Y=P.range,et=Eo(Y);if((T!=E||s==2&&!H)&&(et&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?KM:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?KM:{mode:1,hard:Y[1],soft:Y[1]}},et=!1),!et&&op(Y))){let ht=Y;Y=(_t,Et,zt)=>Et==null?Cl:ep(Et,zt,ht)}P.range=Ne(Y||(H?oD:T==E?P.distr==3?lD:P.distr==4?cD:lw:P.distr==3?cw:P.distr==4?uw:aD)),P.auto=Ne(et?!1:P.auto),P.clamp=Ne(P.clamp||qL),P._min=P._max=null,P.valToPct=N(P)}}}R("x"),R("y"),s==1&&x.forEach(T=>{R(T.scale)}),M.forEach(T=>{R(T.scale)});for(let T in n.scales)R(T);let L=v[E],z=L.distr,G,F;L.ori==0?(rs(c,y2),G=r,F=o):(rs(c,v2),G=o,F=r);let U={};for(let T in v){let P=v[T];(P.min!=null||P.max!=null)&&(U[T]={min:P.min,max:P.max},P.min=P.max=null)}let D=n.tzDate||(T=>new Date(Yn(T/g))),O=n.fmtDate||rx,Z=g==1?yL(D):ML(D),X=cS(D,lS(g==1?_L:bL,O)),J=hS(D,uS(wL,O)),nt=[],dt=i.legend=Bn({},AL,n.legend),ft=i.cursor=Bn({},DL,{drag:{y:s==2}},n.cursor),st=dt.show,yt=ft.show,xt=dt.markers;dt.idxs=nt,xt.width=Ne(xt.width),xt.dash=Ne(xt.dash),xt.stroke=Ne(xt.stroke),xt.fill=Ne(xt.fill);let Tt,At,Jt,xe=[],jt=[],Te,Se=!1,me={};if(dt.live){let T=x[1]?x[1].values:null;Se=T!=null,Te=Se?T(i,1,0):{_:0};for(let P in Te)me[P]=Q0}if(st)if(Tt=zs("table",P2,c),Jt=zs("tbody",null,Tt),dt.mount(i,Tt),Se){At=zs("thead",null,Tt,Jt);let T=zs("tr",null,At);zs("th",null,T);for(var xn in Te)zs("th",kM,T).textContent=xn}else rs(Tt,L2),dt.live&&rs(Tt,I2);let on={show:!0},In={show:!1};function Je(T,P){if(P==0&&(Se||!dt.live||s==2))return Cl;let k=[],H=zs("tr",D2,Jt,Jt.childNodes[P]);rs(H,T.class),T.show||rs(H,ra);let Y=zs("th",null,H);if(xt.show){let _t=vs(N2,Y);if(P>0){let Et=xt.width(i,P);Et&&(_t.style.border=Et+"px "+xt.dash(i,P)+" "+xt.stroke(i,P)),_t.style.background=xt.fill(i,P)}}let et=vs(kM,Y);T.label instanceof HTMLElement?et.appendChild(T.label):et.textContent=T.label,P>0&&(xt.show||(et.style.color=T.width>0?xt.stroke(i,P):xt.fill(i,P)),Ue("click",Y,_t=>{if(ft._lock)return;ae(_t);let Et=x.indexOf(T);if((_t.ctrlKey||_t.metaKey)!=dt.isolate){let zt=x.some((Ht,Wt)=>Wt>0&&Wt!=Et&&Ht.show);x.forEach((Ht,Wt)=>{Wt>0&&Xs(Wt,zt?Wt==Et?on:In:on,!0,On.setSeries)})}else Xs(Et,{show:!T.show},!0,On.setSeries)},!1),le&&Ue(VM,Y,_t=>{ft._lock||(ae(_t),Xs(x.indexOf(T),wa,!0,On.setSeries))},!1));for(var ht in Te){let _t=zs("td",U2,H);_t.textContent="--",k.push(_t)}return[H,k]}let Zn=new Map;function Ue(T,P,k,H=!0){let Y=Zn.get(P)||{},et=ft.bind[T](i,P,k,H);et&&(oa(T,P,Y[T]=et),Zn.set(P,Y))}function kn(T,P,k){let H=Zn.get(P)||{};for(let Y in H)(T==null||Y==T)&&($0(Y,P,H[Y]),delete H[Y]);T==null&&Zn.delete(P)}let Sn=0,Ln=0,$=0,Nt=0,se=0,_e=0,Ct=se,tn=_e,Yt=$,ne=Nt,B=0,C=0,j=0,mt=0;i.bbox={};let ut=!1,St=!1,wt=!1,rt=!1,at=!1,vt=!1;function W(T,P,k){(k||T!=i.width||P!=i.height)&&lt(T,P),we(!1),wt=!0,St=!0,ui()}function lt(T,P){i.width=Sn=$=T,i.height=Ln=Nt=P,se=_e=0,Rt(),Zt();let k=i.bbox;B=k.left=ia(se*We,.5),C=k.top=ia(_e*We,.5),j=k.width=ia($*We,.5),mt=k.height=ia(Nt*We,.5)}let ot=3;function Pt(){let T=!1,P=0;for(;!T;){P++;let k=_a(P),H=qs(P);T=P==ot||k&&H,T||(lt(i.width,i.height),St=!0)}}function Mt({width:T,height:P}){W(T,P)}i.setSize=Mt;function Rt(){let T=!1,P=!1,k=!1,H=!1;M.forEach((Y,et)=>{if(Y.show&&Y._show){let{side:ht,_size:_t}=Y,Et=ht%2,zt=Y.label!=null?Y.labelSize:0,Ht=_t+zt;Ht>0&&(Et?($-=Ht,ht==3?(se+=Ht,H=!0):k=!0):(Nt-=Ht,ht==0?(_e+=Ht,T=!0):P=!0))}}),Ws[0]=T,Ws[1]=k,Ws[2]=P,Ws[3]=H,$-=ws[1]+ws[3],se+=ws[3],Nt-=ws[2]+ws[0],_e+=ws[0]}function Zt(){let T=se+$,P=_e+Nt,k=se,H=_e;function Y(et,ht){switch(et){case 1:return T+=ht,T-ht;case 2:return P+=ht,P-ht;case 3:return k-=ht,k+ht;case 0:return H-=ht,H+ht}}M.forEach((et,ht)=>{if(et.show&&et._show){let _t=et.side;et._pos=Y(_t,et._size),et.label!=null&&(et._lpos=Y(_t,et.labelSize))}})}if(ft.dataIdx==null){let T=ft.hover,P=T.skip=new Set(T.skip??[]);P.add(void 0);let k=T.prox=Ne(T.prox),H=T.bias??=0;ft.dataIdx=(Y,et,ht,_t)=>{if(et==0)return ht;let Et=ht,zt=k(Y,et,ht,_t)??sn,Ht=zt>=0&&zt<sn,Wt=L.ori==0?$:Nt,ge=ft.left,ze=t[0],Fe=t[et];if(P.has(Fe[ht])){Et=null;let Pe=null,oe=null,Kt;if(H==0||H==-1)for(Kt=ht;Pe==null&&Kt-- >0;)P.has(Fe[Kt])||(Pe=Kt);if(H==0||H==1)for(Kt=ht;oe==null&&Kt++<Fe.length;)P.has(Fe[Kt])||(oe=Kt);if(Pe!=null||oe!=null)if(Ht){let un=Pe==null?-1/0:G(ze[Pe],L,Wt,0),Tn=oe==null?1/0:G(ze[oe],L,Wt,0),ti=ge-un,Ke=Tn-ge;ti<=Ke?ti<=zt&&(Et=Pe):Ke<=zt&&(Et=oe)}else Et=oe==null?Pe:Pe==null?oe:ht-Pe<=oe-ht?Pe:oe}else Ht&&jn(ge-G(ze[ht],L,Wt,0))>zt&&(Et=null);return Et}}let ae=T=>{ft.event=T};ft.idxs=nt,ft._lock=!1;let pt=ft.points;pt.show=Ne(pt.show),pt.size=Ne(pt.size),pt.stroke=Ne(pt.stroke),pt.width=Ne(pt.width),pt.fill=Ne(pt.fill);let $t=i.focus=Bn({},n.focus||{alpha:.3},ft.focus),le=$t.prox>=0,Dt=le&&pt.one,ve=[],an=[],yi=[];function Jl(T,P){let k=pt.show(i,P);if(k instanceof HTMLElement)return rs(k,C2),rs(k,T.class),fr(k,-10,-10,$,Nt),p.insertBefore(k,ve[P]),k}function ma(T,P){if(s==1||P>0){let k=s==1&&v[T.scale].time,H=T.value;T.value=k?sS(H)?hS(D,uS(H,O)):H||J:H||VL,T.label=T.label||(k?UL:NL)}if(Dt||P>0){T.width=T.width==null?1:T.width,T.paths=T.paths||iD||X2,T.fillTo=Ne(T.fillTo||YL),T.pxAlign=+ke(T.pxAlign,_),T.pxRound=vS(T.pxAlign),T.stroke=Ne(T.stroke||null),T.fill=Ne(T.fill||null),T._stroke=T._fill=T._paths=T._focus=null;let k=WL(Di(1,T.width),1),H=T.points=Bn({},{size:k,width:Di(1,k*.2),stroke:T.stroke,space:k*2,paths:sD,_stroke:null,_fill:null},T.points);H.show=Ne(H.show),H.filter=Ne(H.filter),H.fill=Ne(H.fill),H.stroke=Ne(H.stroke),H.paths=Ne(H.paths),H.pxAlign=T.pxAlign}if(st){let k=Je(T,P);xe.splice(P,0,k[0]),jt.splice(P,0,k[1]),dt.values.push(null)}if(yt){nt.splice(P,0,null);let k=null;Dt?P==0&&(k=Jl(T,P)):P>0&&(k=Jl(T,P)),ve.splice(P,0,k),an.splice(P,0,0),yi.splice(P,0,0)}Qn("addSeries",P)}function Xp(T,P){P=P??x.length,T=s==1?J0(T,P,fS,_S):J0(T,P,{},xS),x.splice(P,0,T),ma(x[P],P)}i.addSeries=Xp;function Wu(T){if(x.splice(T,1),st){dt.values.splice(T,1),jt.splice(T,1);let P=xe.splice(T,1)[0];kn(null,P.firstChild),P.remove()}yt&&(nt.splice(T,1),ve.splice(T,1)[0].remove(),an.splice(T,1),yi.splice(T,1)),Qn("delSeries",T)}i.delSeries=Wu;let Ws=[!1,!1,!1,!1];function gr(T,P){if(T._show=T.show,T.show){let k=T.side%2,H=v[T.scale];H==null&&(T.scale=k?x[1].scale:E,H=v[T.scale]);let Y=H.time;T.size=Ne(T.size),T.space=Ne(T.space),T.rotate=Ne(T.rotate),Eo(T.incrs)&&T.incrs.forEach(ht=>{!To.has(ht)&&To.set(ht,DS(ht))}),T.incrs=Ne(T.incrs||(H.distr==2?mL:Y?g==1?xL:vL:sa)),T.splits=Ne(T.splits||(Y&&H.distr==1?Z:H.distr==3?X0:H.distr==4?BL:FL)),T.stroke=Ne(T.stroke),T.grid.stroke=Ne(T.grid.stroke),T.ticks.stroke=Ne(T.ticks.stroke),T.border.stroke=Ne(T.border.stroke);let et=T.values;T.values=Eo(et)&&!Eo(et[0])?Ne(et):Y?Eo(et)?cS(D,lS(et,O)):sS(et)?SL(D,et):et||X:et||OL,T.filter=Ne(T.filter||(H.distr>=3&&H.log==10?HL:H.distr==3&&H.log==2?GL:IS)),T.font=wS(T.font),T.labelFont=wS(T.labelFont),T._size=T.size(i,null,P,0),T._space=T._rotate=T._incrs=T._found=T._splits=T._values=null,T._size>0&&(Ws[P]=!0,T._el=vs(E2,d))}}function xr(T,P,k,H){let[Y,et,ht,_t]=k,Et=P%2,zt=0;return Et==0&&(_t||et)&&(zt=P==0&&!Y||P==2&&!ht?Yn(dS.size/3):0),Et==1&&(Y||ht)&&(zt=P==1&&!et||P==3&&!_t?Yn(mS.size/2):0),zt}let Kl=i.padding=(n.padding||[xr,xr,xr,xr]).map(T=>Ne(ke(T,xr))),ws=i._padding=Kl.map((T,P)=>T(i,P,Ws,0)),wn,Cn=null,Pn=null,$s=s==1?x[0].idxs:null,Xi=null,jr=!1;function Ql(T,P){if(t=T??[],i.data=i._data=t,s==2){wn=0;for(let k=1;k<x.length;k++)wn+=t[k][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Xi=t[0],wn=Xi.length;let k=t;if(z==2){k=t.slice();let H=k[0]=Array(wn);for(let Y=0;Y<wn;Y++)H[Y]=Y}i._data=t=k}if(we(!0),Qn("setData"),z==2&&(wt=!0),P!==!1){let k=L;k.auto(i,jr)?tc():Kr(E,k.min,k.max),rt=rt||ft.left>=0,vt=!0,ui()}}i.setData=Ql;function tc(){jr=!0;let T,P;s==1&&(wn>0?(Cn=$s[0]=0,Pn=$s[1]=wn-1,T=t[0][Cn],P=t[0][Pn],z==2?(T=Cn,P=Pn):T==P&&(z==3?[T,P]=sp(T,T,L.log,!1):z==4?[T,P]=ex(T,T,L.log,!1):L.time?P=T+Yn(86400/g):[T,P]=ep(T,P,nx,!0))):(Cn=$s[0]=T=null,Pn=$s[1]=P=null)),Kr(E,T,P)}let ga,Zr,xa,I,q,it,K,Q,It,Ot;function Lt(T,P,k,H,Y,et){T??=HM,k??=sx,H??="butt",Y??=HM,et??="round",T!=ga&&(h.strokeStyle=ga=T),Y!=Zr&&(h.fillStyle=Zr=Y),P!=xa&&(h.lineWidth=xa=P),et!=q&&(h.lineJoin=q=et),H!=it&&(h.lineCap=it=H),k!=I&&h.setLineDash(I=k)}function Bt(T,P,k,H){P!=Zr&&(h.fillStyle=Zr=P),T!=K&&(h.font=K=T),k!=Q&&(h.textAlign=Q=k),H!=It&&(h.textBaseline=It=H)}function Xt(T,P,k,H,Y=0){if(H.length>0&&T.auto(i,jr)&&(P==null||P.min==null)){let et=ke(Cn,0),ht=ke(Pn,H.length-1),_t=k.min==null?H2(H,et,ht,Y,T.distr==3):[k.min,k.max];T.min=Gs(T.min,k.min=_t[0]),T.max=Di(T.max,k.max=_t[1])}}let ue={min:null,max:null};function Re(){for(let H in v){let Y=v[H];U[H]==null&&(Y.min==null||U[E]!=null&&Y.auto(i,jr))&&(U[H]=ue)}for(let H in v){let Y=v[H];U[H]==null&&Y.from!=null&&U[Y.from]!=null&&(U[H]=ue)}U[E]!=null&&we(!0);let T={};for(let H in U){let Y=U[H];if(Y!=null){let et=T[H]=Pl(v[H],Z2);if(Y.min!=null)Bn(et,Y);else if(H!=E||s==2)if(wn==0&&et.from==null){let ht=et.range(i,null,null,H);et.min=ht[0],et.max=ht[1]}else et.min=sn,et.max=-sn}}if(wn>0){x.forEach((H,Y)=>{if(s==1){let et=H.scale,ht=U[et];if(ht==null)return;let _t=T[et];if(Y==0){let Et=_t.range(i,_t.min,_t.max,et);_t.min=Et[0],_t.max=Et[1],Cn=Hs(_t.min,t[0]),Pn=Hs(_t.max,t[0]),Pn-Cn>1&&(t[0][Cn]<_t.min&&Cn++,t[0][Pn]>_t.max&&Pn--),H.min=Xi[Cn],H.max=Xi[Pn]}else H.show&&H.auto&&Xt(_t,ht,H,t[Y],H.sorted);H.idxs[0]=Cn,H.idxs[1]=Pn}else if(Y>0&&H.show&&H.auto){let[et,ht]=H.facets,_t=et.scale,Et=ht.scale,[zt,Ht]=t[Y],Wt=T[_t],ge=T[Et];Wt!=null&&Xt(Wt,U[_t],et,zt,et.sorted),ge!=null&&Xt(ge,U[Et],ht,Ht,ht.sorted),H.min=ht.min,H.max=ht.max}});for(let H in T){let Y=T[H],et=U[H];if(Y.from==null&&(et==null||et.min==null)){let ht=Y.range(i,Y.min==sn?null:Y.min,Y.max==-sn?null:Y.max,H);Y.min=ht[0],Y.max=ht[1]}}}for(let H in T){let Y=T[H];if(Y.from!=null){let et=T[Y.from];if(et.min==null)Y.min=Y.max=null;else{let ht=Y.range(i,et.min,et.max,H);Y.min=ht[0],Y.max=ht[1]}}}let P={},k=!1;for(let H in T){let Y=T[H],et=v[H];if(et.min!=Y.min||et.max!=Y.max){et.min=Y.min,et.max=Y.max;let ht=et.distr;et._min=ht==3?Gr(et.min):ht==4?B0(et.min,et.asinh):ht==100?et.fwd(et.min):et.min,et._max=ht==3?Gr(et.max):ht==4?B0(et.max,et.asinh):ht==100?et.fwd(et.max):et.max,P[H]=k=!0}}if(k){x.forEach((H,Y)=>{s==2?Y>0&&P.y&&(H._paths=null):P[H.scale]&&(H._paths=null)});for(let H in P)wt=!0,Qn("setScale",H);yt&&ft.left>=0&&(rt=vt=!0)}for(let H in U)U[H]=null}function qt(T){let P=q0(Cn-1,0,wn-1),k=q0(Pn+1,0,wn-1);for(;T[P]==null&&P>0;)P--;for(;T[k]==null&&k<wn-1;)k++;return[P,k]}function Ce(){if(wn>0){let T=x.some(P=>P._focus)&&Ot!=$t.alpha;T&&(h.globalAlpha=Ot=$t.alpha),x.forEach((P,k)=>{if(k>0&&P.show&&(vn(k,!1),vn(k,!0),P._paths==null)){let H=Ot;Ot!=P.alpha&&(h.globalAlpha=Ot=P.alpha);let Y=s==2?[0,t[k][0].length-1]:qt(t[k]);P._paths=P.paths(i,k,Y[0],Y[1]),Ot!=H&&(h.globalAlpha=Ot=H)}}),x.forEach((P,k)=>{if(k>0&&P.show){let H=Ot;Ot!=P.alpha&&(h.globalAlpha=Ot=P.alpha),P._paths!=null&&Xe(k,!1);{let Y=P._paths!=null?P._paths.gaps:null,et=P.points.show(i,k,Cn,Pn,Y),ht=P.points.filter(i,k,et,Y);(et||ht)&&(P.points._paths=P.points.paths(i,k,Cn,Pn,ht),Xe(k,!0))}Ot!=H&&(h.globalAlpha=Ot=H),Qn("drawSeries",k)}}),T&&(h.globalAlpha=Ot=1)}}function vn(T,P){let k=P?x[T].points:x[T];k._stroke=k.stroke(i,T),k._fill=k.fill(i,T)}function Xe(T,P){let k=P?x[T].points:x[T],{stroke:H,fill:Y,clip:et,flags:ht,_stroke:_t=k._stroke,_fill:Et=k._fill,_width:zt=k.width}=k._paths;zt=rn(zt*We,3);let Ht=null,Wt=zt%2/2;P&&Et==null&&(Et=zt>0?"#fff":_t);let ge=k.pxAlign==1&&Wt>0;if(ge&&h.translate(Wt,Wt),!P){let ze=B-zt/2,Fe=C-zt/2,Pe=j+zt,oe=mt+zt;Ht=new Path2D,Ht.rect(ze,Fe,Pe,oe)}P?Vt(_t,zt,k.dash,k.cap,Et,H,Y,ht,et):Ye(T,_t,zt,k.dash,k.cap,Et,H,Y,ht,Ht,et),ge&&h.translate(-Wt,-Wt)}function Ye(T,P,k,H,Y,et,ht,_t,Et,zt,Ht){let Wt=!1;Et!=0&&A.forEach((ge,ze)=>{if(ge.series[0]==T){let Fe=x[ge.series[1]],Pe=t[ge.series[1]],oe=(Fe._paths||Iu).band;Eo(oe)&&(oe=ge.dir==1?oe[0]:oe[1]);let Kt,un=null;Fe.show&&oe&&V2(Pe,Cn,Pn)?(un=ge.fill(i,ze)||et,Kt=Fe._paths.clip):oe=null,Vt(P,k,H,Y,un,ht,_t,Et,zt,Ht,Kt,oe),Wt=!0}}),Wt||Vt(P,k,H,Y,et,ht,_t,Et,zt,Ht)}let zn=Il|j0;function Vt(T,P,k,H,Y,et,ht,_t,Et,zt,Ht,Wt){Lt(T,P,k,H,Y),(Et||zt||Wt)&&(h.save(),Et&&h.clip(Et),zt&&h.clip(zt)),Wt?(_t&zn)==zn?(h.clip(Wt),Ht&&h.clip(Ht),Le(Y,ht),Dn(T,et,P)):_t&j0?(Le(Y,ht),h.clip(Wt),Dn(T,et,P)):_t&Il&&(h.save(),h.clip(Wt),Ht&&h.clip(Ht),Le(Y,ht),h.restore(),Dn(T,et,P)):(Le(Y,ht),Dn(T,et,P)),(Et||zt||Wt)&&h.restore()}function Dn(T,P,k){k>0&&(P instanceof Map?P.forEach((H,Y)=>{h.strokeStyle=ga=Y,h.stroke(H)}):P!=null&&T&&h.stroke(P))}function Le(T,P){P instanceof Map?P.forEach((k,H)=>{h.fillStyle=Zr=H,h.fill(k)}):P!=null&&T&&h.fill(P)}function _r(T,P,k,H){let Y=M[T],et;if(H<=0)et=[0,0];else{let ht=Y._space=Y.space(i,T,P,k,H),_t=Y._incrs=Y.incrs(i,T,P,k,H,ht);et=uD(P,k,_t,H,ht)}return Y._found=et}function Nn(T,P,k,H,Y,et,ht,_t,Et,zt){let Ht=ht%2/2;_==1&&h.translate(Ht,Ht),Lt(_t,ht,Et,zt,_t),h.beginPath();let Wt,ge,ze,Fe,Pe=Y+(H==0||H==3?-et:et);k==0?(ge=Y,Fe=Pe):(Wt=Y,ze=Pe);for(let oe=0;oe<T.length;oe++)P[oe]!=null&&(k==0?Wt=ze=T[oe]:ge=Fe=T[oe],h.moveTo(Wt,ge),h.lineTo(ze,Fe));h.stroke(),_==1&&h.translate(-Ht,-Ht)}function _a(T){let P=!0;return M.forEach((k,H)=>{if(!k.show)return;let Y=v[k.scale];if(Y.min==null){k._show&&(P=!1,k._show=!1,we(!1));return}else k._show||(P=!1,k._show=!0,we(!1));let et=k.side,ht=et%2,{min:_t,max:Et}=Y,[zt,Ht]=_r(H,_t,Et,ht==0?$:Nt);if(Ht==0)return;let Wt=Y.distr==2,ge=k._splits=k.splits(i,H,_t,Et,zt,Ht,Wt),ze=Y.distr==2?ge.map(Kt=>Xi[Kt]):ge,Fe=Y.distr==2?Xi[ge[1]]-Xi[ge[0]]:zt,Pe=k._values=k.values(i,k.filter(i,ze,H,Ht,Fe),H,Ht,Fe);k._rotate=et==2?k.rotate(i,Pe,H,Ht):0;let oe=k._size;k._size=bs(k.size(i,Pe,H,T)),oe!=null&&k._size!=oe&&(P=!1)}),P}function qs(T){let P=!0;return Kl.forEach((k,H)=>{let Y=k(i,H,Ws,T);Y!=ws[H]&&(P=!1),ws[H]=Y}),P}function yr(){for(let T=0;T<M.length;T++){let P=M[T];if(!P.show||!P._show)continue;let k=P.side,H=k%2,Y,et,ht=P.stroke(i,T),_t=k==0||k==3?-1:1,[Et,zt]=P._found;if(P.label!=null){let Mi=P.labelGap*_t,Zi=Yn((P._lpos+Mi)*We);Bt(P.labelFont[0],ht,"center",k==2?"top":zM),h.save(),H==1?(Y=et=0,h.translate(Zi,Yn(C+mt/2)),h.rotate((k==3?-Qf:Qf)/2)):(Y=Yn(B+j/2),et=Zi);let Fo=CS(P.label)?P.label(i,T,Et,zt):P.label;h.fillText(Fo,Y,et),h.restore()}if(zt==0)continue;let Ht=v[P.scale],Wt=H==0?j:mt,ge=H==0?B:C,ze=P._splits,Fe=Ht.distr==2?ze.map(Mi=>Xi[Mi]):ze,Pe=Ht.distr==2?Xi[ze[1]]-Xi[ze[0]]:Et,oe=P.ticks,Kt=P.border,un=oe.show?oe.size:0,Tn=Yn(un*We),ti=Yn((P.alignTo==2?P._size-un-P.gap:P.gap)*We),Ke=P._rotate*-Qf/180,An=m(P._pos*We),Yi=(Tn+ti)*_t,bi=An+Yi;et=H==0?bi:0,Y=H==1?bi:0;let us=P.font[0],Es=P.align==1?El:P.align==2?U0:Ke>0?El:Ke<0?U0:H==0?"center":k==3?U0:El,js=Ke||H==1?"middle":k==2?"top":zM;Bt(us,ht,Es,js);let ji=P.font[1]*P.lineGap,hs=ze.map(Mi=>m(a(Mi,Ht,Wt,ge))),Ts=P._values;for(let Mi=0;Mi<Ts.length;Mi++){let Zi=Ts[Mi];if(Zi!=null){H==0?Y=hs[Mi]:et=hs[Mi],Zi=""+Zi;let Fo=Zi.indexOf(`
`)==-1?[Zi]:Zi.split(/\n/gm);for(let Si=0;Si<Fo.length;Si++){let v_=Fo[Si];Ke?(h.save(),h.translate(Y,et+Si*ji),h.rotate(Ke),h.fillText(v_,0,0),h.restore()):h.fillText(v_,Y,et+Si*ji)}}}oe.show&&Nn(hs,oe.filter(i,Fe,T,zt,Pe),H,k,An,Tn,rn(oe.width*We,3),oe.stroke(i,T),oe.dash,oe.cap);let Zs=P.grid;Zs.show&&Nn(hs,Zs.filter(i,Fe,T,zt,Pe),H,H==0?2:1,H==0?C:B,H==0?mt:j,rn(Zs.width*We,3),Zs.stroke(i,T),Zs.dash,Zs.cap),Kt.show&&Nn([An],[1],H==0?1:0,H==0?1:2,H==1?C:B,H==1?mt:j,rn(Kt.width*We,3),Kt.stroke(i,T),Kt.dash,Kt.cap)}Qn("drawAxes")}function we(T){x.forEach((P,k)=>{k>0&&(P._paths=null,T&&(s==1?(P.min=null,P.max=null):P.facets.forEach(H=>{H.min=null,H.max=null})))})}let En=!1,vi=!1,je=[];function Un(){vi=!1;for(let T=0;T<je.length;T++)Qn(...je[T]);je.length=0}function ui(){En||(iL(n_),En=!0)}function $u(T,P=!1){En=!0,vi=P,T(i),n_(),P&&je.length>0&&queueMicrotask(Un)}i.batch=$u;function n_(){if(ut&&(Re(),ut=!1),wt&&(Pt(),wt=!1),St){if(gn(f,El,se),gn(f,"top",_e),gn(f,Au,$),gn(f,Ru,Nt),gn(p,El,se),gn(p,"top",_e),gn(p,Au,$),gn(p,Ru,Nt),gn(d,Au,Sn),gn(d,Ru,Ln),u.width=Yn(Sn*We),u.height=Yn(Ln*We),M.forEach(({_el:T,_show:P,_size:k,_pos:H,side:Y})=>{if(T!=null)if(P){let et=Y===3||Y===0?k:0,ht=Y%2==1;gn(T,ht?"left":"top",H-et),gn(T,ht?"width":"height",k),gn(T,ht?"top":"left",ht?_e:se),gn(T,ht?"height":"width",ht?Nt:$),W0(T,ra)}else rs(T,ra)}),ga=Zr=xa=q=it=K=Q=It=I=null,Ot=1,ic(!0),se!=Ct||_e!=tn||$!=Yt||Nt!=ne){we(!1);let T=$/Yt,P=Nt/ne;if(yt&&!rt&&ft.left>=0){ft.left*=T,ft.top*=P,ya&&fr(ya,Yn(ft.left),0,$,Nt),va&&fr(va,0,Yn(ft.top),$,Nt);for(let k=0;k<ve.length;k++){let H=ve[k];H!=null&&(an[k]*=T,yi[k]*=P,fr(H,bs(an[k]),bs(yi[k]),$,Nt))}}if(cn.show&&!at&&cn.left>=0&&cn.width>0){cn.left*=T,cn.width*=T,cn.top*=P,cn.height*=P;for(let k in Qp)gn(Sa,k,cn[k])}Ct=se,tn=_e,Yt=$,ne=Nt}Qn("setSize"),St=!1}Sn>0&&Ln>0&&(h.clearRect(0,0,u.width,u.height),Qn("drawClear"),w.forEach(T=>T()),Qn("draw")),cn.show&&at&&(qu(cn),at=!1),yt&&rt&&(Oo(null,!0,!1),rt=!1),dt.show&&dt.live&&vt&&(Jp(),vt=!1),l||(l=!0,i.status=1,Qn("ready")),jr=!1,En=!1}i.redraw=(T,P)=>{wt=P||!1,T!==!1?Kr(E,L.min,L.max):ui()};function Yp(T,P){let k=v[T];if(k.from==null){if(wn==0){let H=k.range(i,P.min,P.max,T);P.min=H[0],P.max=H[1]}if(P.min>P.max){let H=P.min;P.min=P.max,P.max=H}if(wn>1&&P.min!=null&&P.max!=null&&P.max-P.min<1e-16)return;T==E&&k.distr==2&&wn>0&&(P.min=Hs(P.min,t[0]),P.max=Hs(P.max,t[0]),P.min==P.max&&P.max++),U[T]=P,ut=!0,ui()}}i.setScale=Yp;let jp,Zp,ya,va,i_,s_,ba,Ma,r_,o_,ln,_n,Jr=!1,si=ft.drag,Jn=si.x,Kn=si.y;yt&&(ft.x&&(jp=vs(A2,p)),ft.y&&(Zp=vs(R2,p)),L.ori==0?(ya=jp,va=Zp):(ya=Zp,va=jp),ln=ft.left,_n=ft.top);let cn=i.select=Bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Sa=cn.show?vs(T2,cn.over?p:f):null;function qu(T,P){if(cn.show){for(let k in T)cn[k]=T[k],k in Qp&&gn(Sa,k,T[k]);P!==!1&&Qn("setSelect")}}i.setSelect=qu;function xE(T){if(x[T].show)st&&W0(xe[T],ra);else if(st&&rs(xe[T],ra),yt){let k=Dt?ve[0]:ve[T];k!=null&&fr(k,-10,-10,$,Nt)}}function Kr(T,P,k){Yp(T,{min:P,max:k})}function Xs(T,P,k,H){P.focus!=null&&ME(T),P.show!=null&&x.forEach((Y,et)=>{et>0&&(T==et||T==null)&&(Y.show=P.show,xE(et),s==2?(Kr(Y.facets[0].scale,null,null),Kr(Y.facets[1].scale,null,null)):Kr(Y.scale,null,null),ui())}),k!==!1&&Qn("setSeries",T,P),H&&sc("setSeries",i,T,P)}i.setSeries=Xs;function _E(T,P){Bn(A[T],P)}function yE(T,P){T.fill=Ne(T.fill||null),T.dir=ke(T.dir,-1),P=P??A.length,A.splice(P,0,T)}function vE(T){T==null?A.length=0:A.splice(T,1)}i.addBand=yE,i.setBand=_E,i.delBand=vE;function bE(T,P){x[T].alpha=P,yt&&ve[T]!=null&&(ve[T].style.opacity=P),st&&xe[T]&&(xe[T].style.opacity=P)}let vr,Qr,Uo,wa={focus:!0};function ME(T){if(T!=Uo){let P=T==null,k=$t.alpha!=1;x.forEach((H,Y)=>{if(s==1||Y>0){let et=P||Y==0||Y==T;H._focus=P?null:et,k&&bE(Y,et?1:$t.alpha)}}),Uo=T,k&&ui()}}st&&le&&Ue(WM,Tt,T=>{ft._lock||(ae(T),Uo!=null&&Xs(null,wa,!0,On.setSeries))});function Ys(T,P,k){let H=v[P];k&&(T=T/We-(H.ori==1?_e:se));let Y=$;H.ori==1&&(Y=Nt,T=Y-T),H.dir==-1&&(T=Y-T);let et=H._min,ht=H._max,_t=T/Y,Et=et+(ht-et)*_t,zt=H.distr;return zt==3?Rl(10,Et):zt==4?$2(Et,H.asinh):zt==100?H.bwd(Et):Et}function SE(T,P){let k=Ys(T,E,P);return Hs(k,t[0],Cn,Pn)}i.valToIdx=T=>Hs(T,t[0]),i.posToIdx=SE,i.posToVal=Ys,i.valToPos=(T,P,k)=>v[P].ori==0?r(T,v[P],k?j:$,k?B:0):o(T,v[P],k?mt:Nt,k?C:0),i.setCursor=(T,P,k)=>{ln=T.left,_n=T.top,Oo(null,P,k)};function a_(T,P){gn(Sa,El,cn.left=T),gn(Sa,Au,cn.width=P)}function l_(T,P){gn(Sa,"top",cn.top=T),gn(Sa,Ru,cn.height=P)}let ec=L.ori==0?a_:l_,nc=L.ori==1?a_:l_;function wE(){if(st&&dt.live)for(let T=s==2?1:0;T<x.length;T++){if(T==0&&Se)continue;let P=dt.values[T],k=0;for(let H in P)jt[T][k++].firstChild.nodeValue=P[H]}}function Jp(T,P){if(T!=null&&(T.idxs?T.idxs.forEach((k,H)=>{nt[H]=k}):j2(T.idx)||nt.fill(T.idx),dt.idx=nt[0]),st&&dt.live){for(let k=0;k<x.length;k++)(k>0||s==1&&!Se)&&EE(k,nt[k]);wE()}vt=!1,P!==!1&&Qn("setLegend")}i.setLegend=Jp;function EE(T,P){let k=x[T],H=T==0&&z==2?Xi:t[T],Y;Se?Y=k.values(i,T,P)??me:(Y=k.value(i,P==null?null:H[P],T,P),Y=Y==null?me:{_:Y}),dt.values[T]=Y}function Oo(T,P,k){r_=ln,o_=_n,[ln,_n]=ft.move(i,ln,_n),ft.left=ln,ft.top=_n,yt&&(ya&&fr(ya,Yn(ln),0,$,Nt),va&&fr(va,0,Yn(_n),$,Nt));let H,Y=Cn>Pn;vr=sn,Qr=null;let et=L.ori==0?$:Nt,ht=L.ori==1?$:Nt;if(ln<0||wn==0||Y){H=ft.idx=null;for(let _t=0;_t<x.length;_t++){let Et=ve[_t];Et!=null&&fr(Et,-10,-10,$,Nt)}le&&Xs(null,wa,!0,T==null&&On.setSeries),dt.live&&(nt.fill(H),vt=!0)}else{let _t,Et,zt;s==1&&(_t=L.ori==0?ln:_n,Et=Ys(_t,E),H=ft.idx=Hs(Et,t[0],Cn,Pn),zt=G(t[0][H],L,et,0));let Ht=-10,Wt=-10,ge=0,ze=0,Fe=!0,Pe="",oe="";for(let Kt=s==2?1:0;Kt<x.length;Kt++){let un=x[Kt],Tn=nt[Kt],ti=Tn==null?null:s==1?t[Kt][Tn]:t[Kt][1][Tn],Ke=ft.dataIdx(i,Kt,H,Et),An=Ke==null?null:s==1?t[Kt][Ke]:t[Kt][1][Ke];if(vt=vt||An!=ti||Ke!=Tn,nt[Kt]=Ke,Kt>0&&un.show){let Yi=Ke==null?-10:Ke==H?zt:G(s==1?t[0][Ke]:t[Kt][0][Ke],L,et,0),bi=An==null?-10:F(An,s==1?v[un.scale]:v[un.facets[1].scale],ht,0);if(le&&An!=null){let us=L.ori==1?ln:_n,Es=jn($t.dist(i,Kt,Ke,bi,us));if(Es<vr){let js=$t.bias;if(js!=0){let ji=Ys(us,un.scale),hs=An>=0?1:-1,Ts=ji>=0?1:-1;Ts==hs&&(Ts==1?js==1?An>=ji:An<=ji:js==1?An<=ji:An>=ji)&&(vr=Es,Qr=Kt)}else vr=Es,Qr=Kt}}if(vt||Dt){let us,Es;L.ori==0?(us=Yi,Es=bi):(us=bi,Es=Yi);let js,ji,hs,Ts,Zs,Mi,Zi=!0,Fo=pt.bbox;if(Fo!=null){Zi=!1;let Si=Fo(i,Kt);hs=Si.left,Ts=Si.top,js=Si.width,ji=Si.height}else hs=us,Ts=Es,js=ji=pt.size(i,Kt);if(Mi=pt.fill(i,Kt),Zs=pt.stroke(i,Kt),Dt)Kt==Qr&&vr<=$t.prox&&(Ht=hs,Wt=Ts,ge=js,ze=ji,Fe=Zi,Pe=Mi,oe=Zs);else{let Si=ve[Kt];Si!=null&&(an[Kt]=hs,yi[Kt]=Ts,JM(Si,js,ji,Zi),jM(Si,Mi,Zs),fr(Si,bs(hs),bs(Ts),$,Nt))}}}}if(Dt){let Kt=$t.prox,un=Uo==null?vr<=Kt:vr>Kt||Qr!=Uo;if(vt||un){let Tn=ve[0];Tn!=null&&(an[0]=Ht,yi[0]=Wt,JM(Tn,ge,ze,Fe),jM(Tn,Pe,oe),fr(Tn,bs(Ht),bs(Wt),$,Nt))}}}if(cn.show&&Jr)if(T!=null){let[_t,Et]=On.scales,[zt,Ht]=On.match,[Wt,ge]=T.cursor.sync.scales,ze=T.cursor.drag;if(Jn=ze._x,Kn=ze._y,Jn||Kn){let{left:Fe,top:Pe,width:oe,height:Kt}=T.select,un=T.scales[Wt].ori,Tn=T.posToVal,ti,Ke,An,Yi,bi,us=_t!=null&&zt(_t,Wt),Es=Et!=null&&Ht(Et,ge);us&&Jn?(un==0?(ti=Fe,Ke=oe):(ti=Pe,Ke=Kt),An=v[_t],Yi=G(Tn(ti,Wt),An,et,0),bi=G(Tn(ti+Ke,Wt),An,et,0),ec(Gs(Yi,bi),jn(bi-Yi))):ec(0,et),Es&&Kn?(un==1?(ti=Fe,Ke=oe):(ti=Pe,Ke=Kt),An=v[Et],Yi=F(Tn(ti,ge),An,ht,0),bi=F(Tn(ti+Ke,ge),An,ht,0),nc(Gs(Yi,bi),jn(bi-Yi))):nc(0,ht)}else tm()}else{let _t=jn(r_-i_),Et=jn(o_-s_);if(L.ori==1){let ge=_t;_t=Et,Et=ge}Jn=si.x&&_t>=si.dist,Kn=si.y&&Et>=si.dist;let zt=si.uni;zt!=null?Jn&&Kn&&(Jn=_t>=zt,Kn=Et>=zt,!Jn&&!Kn&&(Et>_t?Kn=!0:Jn=!0)):si.x&&si.y&&(Jn||Kn)&&(Jn=Kn=!0);let Ht,Wt;Jn&&(L.ori==0?(Ht=ba,Wt=ln):(Ht=Ma,Wt=_n),ec(Gs(Ht,Wt),jn(Wt-Ht)),Kn||nc(0,ht)),Kn&&(L.ori==1?(Ht=ba,Wt=ln):(Ht=Ma,Wt=_n),nc(Gs(Ht,Wt),jn(Wt-Ht)),Jn||ec(0,et)),!Jn&&!Kn&&(ec(0,0),nc(0,0))}if(si._x=Jn,si._y=Kn,T==null){if(k){if(y_!=null){let[_t,Et]=On.scales;On.values[0]=_t!=null?Ys(L.ori==0?ln:_n,_t):null,On.values[1]=Et!=null?Ys(L.ori==1?ln:_n,Et):null}sc(O0,i,ln,_n,$,Nt,H)}if(le){let _t=k&&On.setSeries,Et=$t.prox;Uo==null?vr<=Et&&Xs(Qr,wa,!0,_t):vr>Et?Xs(null,wa,!0,_t):Qr!=Uo&&Xs(Qr,wa,!0,_t)}}vt&&(dt.idx=H,Jp()),P!==!1&&Qn("setCursor")}let to=null;Object.defineProperty(i,"rect",{get(){return to==null&&ic(!1),to}});function ic(T=!1){T?to=null:(to=p.getBoundingClientRect(),Qn("syncRect",to))}function c_(T,P,k,H,Y,et,ht){ft._lock||Jr&&T!=null&&T.movementX==0&&T.movementY==0||(Kp(T,P,k,H,Y,et,ht,!1,T!=null),T!=null?Oo(null,!0,!0):Oo(P,!0,!1))}function Kp(T,P,k,H,Y,et,ht,_t,Et){if(to==null&&ic(!1),ae(T),T!=null)k=T.clientX-to.left,H=T.clientY-to.top;else{if(k<0||H<0){ln=-10,_n=-10;return}let[zt,Ht]=On.scales,Wt=P.cursor.sync,[ge,ze]=Wt.values,[Fe,Pe]=Wt.scales,[oe,Kt]=On.match,un=P.axes[0].side%2==1,Tn=L.ori==0?$:Nt,ti=L.ori==1?$:Nt,Ke=un?et:Y,An=un?Y:et,Yi=un?H:k,bi=un?k:H;if(Fe!=null?k=oe(zt,Fe)?a(ge,v[zt],Tn,0):-10:k=Tn*(Yi/Ke),Pe!=null?H=Kt(Ht,Pe)?a(ze,v[Ht],ti,0):-10:H=ti*(bi/An),L.ori==1){let us=k;k=H,H=us}}Et&&(P==null||P.cursor.event.type==O0)&&((k<=1||k>=$-1)&&(k=ia(k,$)),(H<=1||H>=Nt-1)&&(H=ia(H,Nt))),_t?(i_=k,s_=H,[ba,Ma]=ft.move(i,k,H)):(ln=k,_n=H)}let Qp={width:0,height:0,left:0,top:0};function tm(){qu(Qp,!1)}let u_,h_,d_,f_;function p_(T,P,k,H,Y,et,ht){Jr=!0,Jn=Kn=si._x=si._y=!1,Kp(T,P,k,H,Y,et,ht,!0,!1),T!=null&&(Ue(F0,G0,m_,!1),sc(GM,i,ba,Ma,$,Nt,null));let{left:_t,top:Et,width:zt,height:Ht}=cn;u_=_t,h_=Et,d_=zt,f_=Ht}function m_(T,P,k,H,Y,et,ht){Jr=si._x=si._y=!1,Kp(T,P,k,H,Y,et,ht,!1,!0);let{left:_t,top:Et,width:zt,height:Ht}=cn,Wt=zt>0||Ht>0,ge=u_!=_t||h_!=Et||d_!=zt||f_!=Ht;if(Wt&&ge&&qu(cn),si.setScale&&Wt&&ge){let ze=_t,Fe=zt,Pe=Et,oe=Ht;if(L.ori==1&&(ze=Et,Fe=Ht,Pe=_t,oe=zt),Jn&&Kr(E,Ys(ze,E),Ys(ze+Fe,E)),Kn)for(let Kt in v){let un=v[Kt];Kt!=E&&un.from==null&&un.min!=sn&&Kr(Kt,Ys(Pe+oe,Kt),Ys(Pe,Kt))}tm()}else ft.lock&&(ft._lock=!ft._lock,Oo(P,!0,T!=null));T!=null&&(kn(F0,G0),sc(F0,i,ln,_n,$,Nt,null))}function TE(T,P,k,H,Y,et,ht){if(ft._lock)return;ae(T);let _t=Jr;if(Jr){let Et=!0,zt=!0,Ht=10,Wt,ge;L.ori==0?(Wt=Jn,ge=Kn):(Wt=Kn,ge=Jn),Wt&&ge&&(Et=ln<=Ht||ln>=$-Ht,zt=_n<=Ht||_n>=Nt-Ht),Wt&&Et&&(ln=ln<ba?0:$),ge&&zt&&(_n=_n<Ma?0:Nt),Oo(null,!0,!0),Jr=!1}ln=-10,_n=-10,nt.fill(null),Oo(null,!0,!0),_t&&(Jr=_t)}function g_(T,P,k,H,Y,et,ht){ft._lock||(ae(T),tc(),tm(),T!=null&&sc($M,i,ln,_n,$,Nt,null))}function x_(){M.forEach(hD),W(i.width,i.height,!0)}oa(tp,Al,x_);let Ea={};Ea.mousedown=p_,Ea.mousemove=c_,Ea.mouseup=m_,Ea.dblclick=g_,Ea.setSeries=(T,P,k,H)=>{let Y=On.match[2];k=Y(i,P,k),k!=-1&&Xs(k,H,!0,!1)},yt&&(Ue(GM,p,p_),Ue(O0,p,c_),Ue(VM,p,T=>{ae(T),ic(!1)}),Ue(WM,p,TE),Ue($M,p,g_),Z0.add(i),i.syncRect=ic);let Xu=i.hooks=n.hooks||{};function Qn(T,P,k){vi?je.push([T,P,k]):T in Xu&&Xu[T].forEach(H=>{H.call(null,i,P,k)})}(n.plugins||[]).forEach(T=>{for(let P in T.hooks)Xu[P]=(Xu[P]||[]).concat(T.hooks[P])});let __=(T,P,k)=>k,On=Bn({key:null,setSeries:!1,filters:{pub:nS,sub:nS},scales:[E,x[1]?x[1].scale:null],match:[iS,iS,__],values:[null,null]},ft.sync);On.match.length==2&&On.match.push(__),ft.sync=On;let y_=On.key,em=QS(y_);function sc(T,P,k,H,Y,et,ht){On.filters.pub(T,P,k,H,Y,et,ht)&&em.pub(T,P,k,H,Y,et,ht)}em.sub(i);function AE(T,P,k,H,Y,et,ht){On.filters.sub(T,P,k,H,Y,et,ht)&&Ea[T](null,P,k,H,Y,et,ht)}i.pub=AE;function RE(){em.unsub(i),Z0.delete(i),Zn.clear(),$0(tp,Al,x_),c.remove(),Tt?.remove(),Qn("destroy")}i.destroy=RE;function nm(){Qn("init",n,t),Ql(t||n.data,!1),U[E]?Yp(E,U[E]):tc(),at=cn.show&&(cn.width>0||cn.height>0),rt=vt=!0,W(n.width,n.height)}return x.forEach(ma),M.forEach(gr),e?e instanceof HTMLElement?(e.appendChild(c),nm()):e(i,nm):nm(),i}ai.assign=Bn;ai.fmtNum=ix;ai.rangeNum=ep;ai.rangeLog=sp;ai.rangeAsinh=ex;ai.orient=la;ai.pxRatio=We;ai.join=nL;ai.fmtDate=rx,ai.tzDate=fL;ai.sync=QS;{ai.addGap=jL,ai.clipGaps=ap;let n=ai.paths={points:rw};n.linear=aw,n.stepped=KL,n.bars=QL,n.spline=eD}var hp=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),dx=n=>Ft.curves[n%Ft.curves.length],dD=.06;function fD(n,t,e){let i=[n,t,...e.map(a=>a.value)],s=Math.min(...i),r=Math.max(...i),o=dD*(r-s);return r-s>1e-9?[s-o,r+o]:[s-1,r+1]}function pD(n,t,e,i){let{ctx:s}=n,r=devicePixelRatio;s.save(),s.beginPath(),s.rect(n.bbox.left,n.bbox.top,n.bbox.width,n.bbox.height),s.clip();for(let{value:o,of:a}of i){let l=n.valToPos(o,"y",!0);s.strokeStyle=a===null?Ft.ink:dx(a),s.lineWidth=1.25*r,s.setLineDash([5*r,4*r]),s.beginPath(),s.moveTo(n.bbox.left,l),s.lineTo(n.bbox.left+n.bbox.width,l),s.stroke()}s.setLineDash([]),s.lineCap="round",s.lineWidth=4.5*r,e.forEach((o,a)=>{s.strokeStyle=dx(a);for(let{start:l,end:c}of o.binds){let u=t.xs.map((h,d)=>[h,o.values[d]]).filter(([h])=>h>=l-1e-9&&h<=c+1e-9);s.beginPath();for(let[h,d]of u)s.lineTo(n.valToPos(h,"x",!0),n.valToPos(d,"y",!0));s.stroke()}}),s.restore()}function hw(n,t,{y:e,list:i},{withLimits:s,pick:r}){let o={stroke:Ft.line,width:1},a=`${Math.round(.78*hp())}px "Inter Variable", system-ui, sans-serif`,l=Eu(i),c={stroke:Ft.muted,grid:o,ticks:{...o,size:4},font:a,labelFont:a,labelSize:1.4*hp(),gap:4},u=new ai({width:n.clientWidth||600,height:n.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(f,p,_)=>[p,Math.max(_,t.xEnd??_,p+1e-6)]},y:{range:(f,p,_)=>fD(p,_,s?l:[])}},series:[{},...i.map((f,p)=>({label:f.name,stroke:dx(p),width:1.75,pxAlign:0,points:{show:t.q.length<3}}))],axes:[{...c,label:t.xName==="point"?"point number":"time, s",size:2.1*hp()},{...c,label:e,size:4*hp()}],hooks:{draw:[f=>pD(f,t,i,l)],setSize:[()=>d()]}},[t.xs,...i.map(f=>f.values)],n);u.over.append(S("div",{class:"now"}),...t.events.map(f=>{let p=S("div",{class:`event ${f.stop?"stop":""}`,title:f.text},S("span",{text:f.short}));return p.x=f.x,p})),u.over.addEventListener("pointerdown",f=>{let p=m=>{let g=u.posToVal(m.clientX-u.over.getBoundingClientRect().left,"x");r(t.xs.reduce((x,M,v)=>Math.abs(M-g)<Math.abs(t.xs[x]-g)?v:x,0))};p(f);let _=()=>{removeEventListener("pointermove",p),removeEventListener("pointerup",_),removeEventListener("pointercancel",_)};addEventListener("pointermove",p),addEventListener("pointerup",_),addEventListener("pointercancel",_)});let h=0;function d(f=h){h=f;let p=u.over.clientWidth,_=[];for(let m of u.over.querySelectorAll(".now, .event")){let g=u.valToPos(m.x??t.xs[h],"x"),x=g>p*.7;m.style.setProperty("left",`${g}px`),m.classList.toggle("leftward",x);let M=m.firstElementChild;if(!M)continue;let[v,A]=x?[g-M.offsetWidth,g]:[g,g+M.offsetWidth],E=0;for(;_.some(y=>y.line===E&&v<y.to&&y.from<A);)E+=1;_.push({line:E,from:v,to:A}),M.style.setProperty("top",`${E*M.offsetHeight}px`)}}return{point:d,canvas:u.ctx.canvas,resize:()=>n.clientWidth&&u.setSize({width:n.clientWidth,height:n.clientHeight}),destroy:()=>u.destroy()}}var mD=1500,gD={gif:"image/gif",webp:"image/webp",mp4:"video/mp4"};async function dw(n,t,e,i){let s=Math.max(1,Math.ceil(n.q.length/mD)),r=n.q.map((v,A)=>A).filter(v=>v%s===0||v===n.q.length-1),[o,a,l,c,u,h]=fl(),[d,f,p]=[o-c,a-u,l-h],_=[Math.atan2(p,Math.hypot(d,f)),Math.atan2(f,d)].map(v=>v*180/Math.PI),m=v=>Number(v.toPrecision(8)),g={kind:t,speed:e,view:_,q:r.map(v=>n.q[v].map(m)),t:r.map(v=>m(n.seconds[v]))},x=await Oe("film",g,({done:v,of:A})=>i(v,A));if(x.stopped)return null;let M=Uint8Array.from(atob(x.data),v=>v.charCodeAt(0));return{name:x.name,blob:new Blob([M],{type:gD[t]})}}async function fw(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var Qe=null,Wr=null,pr="joints",_i=0,fx=1,li=null,pp=new Set(["speeds","accelerations","toolspeed"]);function mw(n){let t=Ut("Play",{class:"primary","data-testid":"play"},xw),e=S("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{xi(),qr(Number(e.value))}}}),i=S("output",{class:"where","data-testid":"where"}),s=S("div",{class:"marks"}),r=S("div",{class:"chart","data-testid":"chart"}),o=S("div",{class:"legend"}),a=S("output",{class:"binds","data-testid":"binds"}),l=Ut("To the limits",{class:"quiet",title:"Scale the curves so that their limits, dashed, are seen; thick is where one binds","data-testid":"limits-shown"},()=>{pp.delete(pr)||pp.add(pr),fp()});n.append(S("div",{class:"dock-bar"},t,hn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",c=>{fx=Number(c)},{"data-testid":"speed"}),S("div",{class:"scrubber"},e,s),i,Ut("\xD7",{class:"icon","aria-label":"Close the curves"},()=>ci(null))),S("div",{class:"dock-bar second"},Be("Curves",UM,pr,c=>{pr=c,fp()},"curves"),l,o,a,S("span",{class:"line saves"},...[["CSV",()=>hi("motion.csv",FM(Qe),"text/csv")],["PNG",_D],["Film",xD],["GIF",()=>pw("gif")],["MP4",()=>pw("mp4")],["SVG",()=>hi(`${pr}.svg`,BM(Qe,pr,Ft.curves),"image/svg+xml")]].map(([c,u])=>Ut(c,{class:"quiet","aria-label":`Save as ${c}`},()=>Qe&&u())))),r),li={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o,limits:l,binds:a},new ResizeObserver(Qs(()=>Wr?.resize())).observe(r),tt(["units","theme"],fp),tt("moving",c=>bt(t,c&&dp?"Pause":"Play")),tt("table",c=>{Qe&&!["postures","name","gripper"].includes(c)&&ci(null)})}function ci(n){if(xi(),Qe=n,b.motion=n,li.root.hidden=!n,Wr&&(Wr.destroy(),Wr=null),jb(n?.table??null,n?.q??[]),!n){ct("motion");return}li.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Gt(li.marks,n.events.map(e=>{let i=S("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=S("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),fp(),ct("motion"),n.q.length&&qr(0),requestAnimationFrame(()=>dl())}var $r=n=>n&&n===Qe&&ci(null);var gw=()=>_i;function qr(n){Qe?.q.length&&(_i=Math.min(Math.max(Math.round(n),0),Qe.q.length-1),li.scrub.value=String(_i),li.scrub.style.setProperty("--at",`${Qe.q.length>1?100*_i/(Qe.q.length-1):0}%`),bt(li.where,Qe.xName==="point"?`point ${_i+1} of ${Qe.q.length}`:`${ii(Qe.xs[_i],2)} s of ${ii(Qe.xs[Qe.xs.length-1],2)} s`),li.scrub.setAttribute("aria-valuetext",li.where.textContent),Oi(Qe.q[_i].slice(),"scrub"),ct("played",Qe.seconds[_i]),bt(li.binds,Qe.tight?`Binds: ${OM(Qe,Qe.seconds[_i])||"nothing"}`:""),Wr?.point(_i))}var dp=!1;function xw(n,t){if(dp){xi();return}if(!Qe?.q.length)return;let e=Qe.seconds,i=e[e.length-1]||1,s=_i>=Qe.q.length-1?0:e[_i]/i;dp=!0,cM(i/fx,s,r=>{let o=_i<=Qe.q.length-1&&e[_i]<=r*i?_i:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;qr(o)},()=>{dp=!1,bt(li.toggle,"Play"),t?.()}),bt(li.toggle,"Pause")}function fp(){if(!Qe||!li)return;Wr?.destroy();let n=N0(Qe,pr);Gt(li.legend,n.list.map((t,e)=>{let i=S("span",{class:"swatch"});return i.style.setProperty("background",Ft.curves[e%Ft.curves.length]),S("span",{},i,t.name)})),li.limits.hidden=!Eu(n.list).length,li.limits.setAttribute("aria-pressed",String(pp.has(pr))),Wr=hw(li.chart,Qe,n,{withLimits:pp.has(pr),pick(t){xi(),qr(t)}}),Wr.point(_i)}async function pw(n){he(`Drawing the ${n.toUpperCase()} \u2026`);try{let t=await dw(Qe,n,fx,(e,i)=>he(`Drawing the ${n.toUpperCase()}: ${e} of ${i} pictures`));t&&hi(t.name,t.blob)}catch(t){he(t.message,"wrong")}}async function xD(){xi(),qr(0);try{let n=await ul(t=>fw(t,()=>new Promise(e=>xw(null,e))));hi("motion.webm",n)}catch(n){he(n.message,"wrong")}}function _D(){let n=Wr.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Ft.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>hi(`${pr}.png`,i))}function Ol(n,t){let e=Array.from({length:16},(s,r)=>S("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=S("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>S("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;bt(e[r],r>=12?String(s[r]):o?ii(s[r]*gt.factor("length"),gt.digits("length")):ii(s[r],4))}},i}var mp=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var px="pieper-panel-width",mx=18,_w=70;function yw(n,t){let e=S("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(mx),"aria-valuemax":String(_w),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,mx),_w,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(px):localStorage.setItem(px,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(px));o>=mx?r(o):e.setAttribute("aria-valuenow","38")}function vw(n){let t=Ol("Pose of the tool, large","present-pose"),e=S("div",{class:"present-card",hidden:!0},t);n.parentElement.append(e);let i=document.documentElement,s=Ut("Present",{"aria-pressed":"false","data-testid":"present"},()=>o(i.dataset.present!=="yes")),r=()=>!e.hidden&&t.show(b.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ct("units"),dispatchEvent(new Event("resize"))}return tt(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function bw(){ul(n=>{let t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.drawImage(n,0,0),mb(e,n.width/n.clientWidth),t.toBlob(i=>i?hi(`${b.table.name||"arm"}.png`,i):he("The picture could not be read.","wrong"))})}var yD="http://www.w3.org/2000/svg";function vD(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(yD,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}var Mw=n=>/^(.)\1*$/.test(n)?`${n.length}${n[0]}`:n;function bD(n){let t=/^>?(\d+(?:[.,]\d+)?)(kg|mm|m)$/.exec(n);if(!t)return null;let e=Number(t[1].replace(",","."));return t[2]==="kg"?{payload:e}:{reach:t[2]==="m"?e:e/1e3}}function MD(n,t){let e=`${n.name} ${n.maker} ${n.joints} ${Mw(n.joints)}`.toLowerCase();return t.every(i=>{let s=/^(\d+)joints$/.exec(i);if(s)return n.joints.length===Number(s[1]);let r=bD(i);return r?Object.entries(r).every(([o,a])=>n[o]!==null&&n[o]>=a-1e-9):e.includes(i)})}var SD=({maker:n,joints:t,payload:e,reach:i})=>[n,Mw(t),e===null?"":`${e} kg`,i===null?"":`${Math.round(i*1e3)} mm`].filter(Boolean);function Sw(n){let t=null,e=S("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=S("span",{class:"hint",role:"status"}),s=S("input",{type:"text",placeholder:"Name, maker, joints (7R, 5 axes), payload (5 kg), reach (900 mm)","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>o(),keydown:a=>{if(a.key==="ArrowDown")e.firstElementChild?.focus();else if(a.key==="Enter")e.firstElementChild?.click();else return;a.preventDefault()}}}),r=S("dialog",{class:"catalogue","aria-label":"Catalogue"},S("div",{class:"line"},s,i,Ut("\xD7",{class:"icon","aria-label":"Close the catalogue"},()=>r.close())),e);document.body.append(r);function o(){let l=s.value.toLowerCase().replace(/(\d)\s+(kg|mm|m)\b/g,"$1$2").replace(/(\d)[\s-]*(joints?|ax[ei]s|axe|dof)\b/g,"$1joints").split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>MD(u,l));i.textContent=t?`${c.length} of ${t.length} arms`:"Fetching the list \u2026",Gt(e,c.map(u=>S("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},vD(u.points),S("span",{},S("b",{text:u.name}),S("span",{class:"hint",text:SD(u).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t){o();try{t=(await Fi("catalog")).arms,o()}catch(a){i.textContent=a.message}}}}var Du=n=>(n?.textContent.trim()??"").split(/\s+/).filter(Boolean).map(Number),Ao=(n,t)=>[...n.children].filter(e=>e.localName===t),wD=()=>[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1];function ED(n,t){let e=new Array(16).fill(0);for(let i=0;i<4;i++)for(let s=0;s<4;s++)for(let r=0;r<4;r++)e[4*i+s]+=n[4*i+r]*t[4*r+s];return e}function TD([n,t,e,i]){let s=Math.hypot(n,t,e)||1,r=i*Math.PI/180,o=Math.cos(r),a=Math.sin(r),l=1-o;return[n,t,e]=[n/s,t/s,e/s],[l*n*n+o,l*n*t-a*e,l*n*e+a*t,0,l*n*t+a*e,l*t*t+o,l*t*e-a*n,0,l*n*e-a*t,l*t*e+a*n,l*e*e+o,0,0,0,0,1]}var ww={matrix:n=>n,translate:([n,t,e])=>[1,0,0,n,0,1,0,t,0,0,1,e,0,0,0,1],scale:([n,t,e])=>[n,0,0,0,0,t,0,0,0,0,e,0,0,0,0,1],rotate:TD},AD={X_UP:[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1],Y_UP:[1,0,0,0,0,0,-1,0,0,1,0,0,0,0,0,1]};function Ew(n){let t=new DOMParser().parseFromString(n,"application/xml");if(t.querySelector("parsererror")||t.documentElement.localName!=="COLLADA")throw new Error("this is no DAE");let e=f=>[...t.getElementsByTagName("*")].filter(p=>p.localName===f),i=new Map([...t.getElementsByTagName("*")].filter(f=>f.id||f.getAttribute("id")).map(f=>[f.getAttribute("id"),f])),s=f=>i.get((f??"").replace(/^#/,"")),r=Number(e("unit")[0]?.getAttribute("meter")??1)||1,o=AD[e("up_axis")[0]?.textContent.trim()]??wD(),a=[];function l(f){let p=s(Ao(s(f)??t.documentElement,"instance_effect")[0]?.getAttribute("url")),_=p&&[...p.getElementsByTagName("*")].find(g=>g.localName==="diffuse"),m=_?Du(Ao(_,"color")[0]):[];return m.length>=3?[m[0],m[1],m[2],m[3]??1]:null}function c(f){let p=Ao(f,"input").find(m=>m.getAttribute("semantic")==="POSITION"),_=s(p?.getAttribute("source"));return _?Du(Ao(_,"float_array")[0]):[]}function u(f,p,_){let m=f&&Ao(f,"mesh")[0];if(m)for(let g of m.children){if(!["triangles","polylist","polygons"].includes(g.localName))continue;let x=Ao(g,"input"),M=1+Math.max(...x.map(G=>Number(G.getAttribute("offset")??0))),v=x.find(G=>G.getAttribute("semantic")==="VERTEX");if(!v)continue;let A=Number(v.getAttribute("offset")??0),E=c(s(v.getAttribute("source"))),y=Ao(g,"p").map(Du),w=g.localName==="polylist"?Du(Ao(g,"vcount")[0]):g.localName==="polygons"?y.map(G=>G.length/M):new Array(y.reduce((G,F)=>G+F.length,0)/M/3).fill(3),N=y.flat(),R=[],L=0,z=G=>{let F=3*N[(L+G)*M+A],[U,D,O]=[E[F],E[F+1],E[F+2]];for(let Z=0;Z<3;Z++)R.push(r*(p[4*Z]*U+p[4*Z+1]*D+p[4*Z+2]*O+p[4*Z+3]))};for(let G of w){for(let F=2;F<G;F++)for(let U of[0,F-1,F])z(U);L+=G}R.length&&R.every(Number.isFinite)&&a.push({at:Float32Array.from(R),colour:l(_.get(g.getAttribute("material")))})}}function h(f,p,_){if(!(_>60)){for(let m of f.children)ww[m.localName]&&(p=ED(p,ww[m.localName](Du(m))));for(let m of f.children)if(m.localName==="instance_geometry"){let g=new Map([...m.getElementsByTagName("*")].filter(x=>x.localName==="instance_material").map(x=>[x.getAttribute("symbol"),x.getAttribute("target")]));u(s(m.getAttribute("url")),p,g)}else if(m.localName==="node")h(m,p,_+1);else if(m.localName==="instance_node"){let g=s(m.getAttribute("url"));g&&h(g,p,_+1)}}}let d=s(e("instance_visual_scene")[0]?.getAttribute("url"))??e("visual_scene")[0];if(d&&h(d,o,0),!a.length)throw new Error("there is no triangle in this DAE");return a}var gp=[],Nu=new Map,xp=0;function RD(){if(gp.length<2){let n=new Worker("meshes.js",{type:"module"});return n.onmessage=({data:{id:t,mesh:e,error:i}})=>{let{resolve:s,reject:r}=Nu.get(t);Nu.delete(t),i?r(new Error(i)):s(e)},n.onerror=()=>{for(let{reject:t}of Nu.values())t(new Error("meshes cannot be read in this browser"));Nu.clear()},gp.push(n),n}return gp[xp%gp.length]}function Tw(n,t){return new Promise((e,i)=>{xp+=1,Nu.set(xp,{resolve:e,reject:i}),RD().postMessage({id:xp,...n},t)})}async function Aw(n,t){let e=t.split(".").at(-1).toLowerCase(),i;if(n.file)i=await n.file.arrayBuffer();else{let s=await fetch(n.url);if(!s.ok)throw new Error(`${t} cannot be fetched`);i=await s.arrayBuffer()}if(e==="dae"){let s=Ew(new TextDecoder().decode(i));return Promise.all(s.map(async({at:r,colour:o})=>({mesh:await Tw({at:r},[r.buffer]),colour:o})))}return[{mesh:await Tw({bytes:i,kind:e},[i]),colour:null}]}var Rw={light:"#c9ced6",dark:"#8b96a6"},Bl=new Rn,Ms=[],Uu=0,Iw=!1,Lw=n=>JSON.stringify([n.convention,n.coupling??null,n.joints.map(t=>[t.type,t.a,t.alpha,t.d,t.theta,t.sign,t.offset])]);function kl(n,t,e=null){b.looks=n?.shapes.length?{...n,key:Lw(t),files:e}:null,n?.notes.length&&he(`Of its looks: ${n.notes.join(" ")}`,n.shapes.length?"plain":"wrong"),CD()}var yx=()=>!!(b.looks&&b.looks.key===Lw(b.table)),yp=()=>yx()?b.look.mode:"sketch",_p=null;function CD(){if(_p===b.looks)return;_p=b.looks;for(let t of Ms)for(let e of new Set([t.fine,t.some,t.few]))e.dispose();Ms=[],Bl.clear();let n=_p;for(let t of n?.shapes??[]){if(t.kind!=="mesh"){Pw(t,[ID[t.kind](t.size)],t.colour);continue}let e=t.url?{url:t.url}:{file:n.files?.(t.file)};!e.url&&!e.file||(Uu+=1,Aw(e,t.url??t.file).then(i=>{if(_p===n)for(let{mesh:s,colour:r}of i){let o=gx(s),a=s.some===s?o:gx(s.some);Pw(t,[o,a,s.few===s.some?a:gx(s.few)],t.colour??r,t.size,s.closed)}}).catch(i=>he(`${t.name}: ${i.message}`,"wrong")).finally(()=>{Uu-=1,Fl(),!Uu&&(Of(xx),ct("looks","loaded"))}))}ct("looks"),Fl(),Of(xx)}function xx(n){return yp()==="sketch"?[]:Ms.filter(t=>n[t.on]).flatMap(t=>(_x.set(...n[t.on]),t.corners.map(e=>PD.copy(e).applyMatrix4(_x).toArray())))}var PD=new V,Cw=n=>n.rotateX(Math.PI/2),ID={box:n=>new Hi(...n),cylinder:([n,t])=>Cw(new Ci(n,n,t,36)),capsule:([n,t])=>Cw(new $o(n,t,8,24)),sphere:([n])=>new Ds(n,28,16)};function gx(n){let t=new Me;return t.setAttribute("position",new He(n.at,3)),t.setAttribute("normal",n.normal.length===n.at.length?new He(n.normal,3):LD(n.normal)),t.setIndex(new He(n.index,1)),t}function LD(n){return new Qa(new Ka(n,4),3,0,!0)}function Pw(n,[t,e=t,i=e],s,r=null,o=!0){let a=lb(o),l=new Ge(t,a),c=new Ge(i,Nf),u=new ye().set(...n.T);r&&u.scale(new V(...r));for(let p of[l,c])p.matrixAutoUpdate=!1,p.frustumCulled=!1;c.renderOrder=-1,Bl.add(l,c),i.computeBoundingBox();let{min:h,max:d}=i.boundingBox,f=[h.x,d.x].flatMap(p=>[h.y,d.y].flatMap(_=>[h.z,d.z].map(m=>new V(p,_,m).applyMatrix4(u))));Ms.push({on:n.on,T:u,fine:t,some:e,few:i,mesh:l,shadow:c,colour:s,corners:f}),Ou()}var _x=new ye;function Fl(){Dw(),fe()}function Dw(){let n=yp();if(Bl.visible=n!=="sketch"&&Ms.length>0,Wb(n!=="real"||Uu>0,n!=="sketch"&&Ms.length>0),!!Bl.visible)for(let t of Ms){let e=b.frames[t.on];e&&(t.mesh.geometry=Iw?t.few:Jv()?t.some:t.fine,t.mesh.matrix.copy(_x.set(...e)).multiply(t.T),t.shadow.matrix.copy(p0).multiply(t.mesh.matrix),t.mesh.matrixWorldNeedsUpdate=t.shadow.matrixWorldNeedsUpdate=!0)}}function Ou(){let n=yp()==="both"?b.look.opacity:1;for(let{mesh:t,colour:e}of Ms){let[i,s,r,o]=e??[];e?t.material.colour.setRGB(i,s,r,Ti):t.material.colour.set(Ft.dark?Rw.dark:Rw.light),t.material.see((o??1)*n,Ft.dark)}fe()}function vx(n){b.look={...b.look,...n},Ou(),Fl(),Of(xx),ct("look")}function Nw(){en.add(Bl),tt("table",()=>{Fl(),Ou(),ct("looks")}),tt("q",Fl),tt("theme",Ou),tt("look",n=>{n==="loaded"&&(Ou(),Fl())}),tt("hurry",n=>{Iw=n,Dw()})}var Uw=()=>({mode:yp(),visible:Bl.visible,loading:Uu,shapes:Ms.length,triangles:Ms.reduce((n,t)=>n+(t.fine.index?.count??0)/3,0),few:Ms.reduce((n,t)=>n+(t.few.index?.count??0)/3,0),places:Ms.map(n=>n.mesh.matrix.clone().transpose().toArray())});function Fw(){let n=Be("The arm as",[["sketch","Sketch"],["real","Real"],["both","Both"]],b.look.mode,s=>vx({mode:s}),"look"),t=S("input",{type:"range",min:"0.1",max:"0.9",step:"0.05",value:String(b.look.opacity),"aria-label":"How opaque the real arm is over the sketch","data-testid":"look-opacity",on:{input:()=>vx({opacity:Number(t.value)})}}),e=S("div",{class:"group look",hidden:!0},n,t),i=()=>{e.hidden=!yx(),n.mark(b.look.mode),t.hidden=b.look.mode!=="both",t.value=String(b.look.opacity)};return tt(["looks","look","table"],i),i(),e}function kw(n){let t=S("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>Bw(t.value)}}),e=Sw(Bw),i=S("p",{class:"sentence","data-testid":"sentence"}),s=S("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let p=Ut(u,{"aria-label":h},d);return p.show=_=>{p.disabled=!_,p.title=_?`${h}: ${_} (${f})`:`Nothing to ${h.toLowerCase()}`,p.setAttribute("aria-description",_??"")},p},o=r("\u21B6","Undo",S0,"Ctrl+Z"),a=r("\u21B7","Redo",w0,"Ctrl+Shift+Z");tt("history",()=>{o.show(Gf()),a.show(Vf())});let l=()=>{let{name:u,derived:h,catalog:d}=b.table,f=d?[]:[S("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Gt(t,f,(b.catalog??[]).map(p=>S("option",{value:p,text:p}))),t.value=d??""},c=S("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(S("h1",{class:"mark"},S("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),S("span",{text:"pieper"})),t,Ut("Find\u2026",{class:"find","aria-label":"Find an arm in the catalogue","data-testid":"find-arm"},e),c,i,S("span",{class:"bar-end"},s,Be("Angles in",[["deg","\xB0"],["rad","rad"]],gt.angle,u=>{gt.set("angle",u),ct("units")},"unit-angle"),Be("Lengths in",[["mm","mm"],["m","m"]],gt.length,u=>{gt.set("length",u),ct("units")},"unit-length"),hn("Size of the letters",[1,1.15,1.3,1.5].map(u=>[String(u),`${Math.round(100*u)} %`]),String(tu()),u=>Uv(Number(u)),{"data-testid":"text-size"}),hn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],b.theme,of,{"data-testid":"theme"}))),ct("history"),tt(["catalog","table"],l),tt("plan",()=>{bt(i,[ih(b.plan),U_(b.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=b.plan?.explain??""}),tt("online",u=>{bt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),tt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(gt.angle),n.querySelector("[data-testid=unit-length]").mark(gt.length),n.querySelector("[data-testid=theme]").value=b.theme})}async function Bw(n){if(n)try{let{table:t}=await Fi("load",{name:n});yn(t,{q:Aa(t),what:"new",label:`open ${n}`})}catch(t){ct("catalog"),he(t.message,"wrong")}}function zw(n,t,e,i){let s=S("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=()=>E0()==="pinned";n.append(s);let o=new Map,a=i.map(c=>{let u=S("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=S("section",{class:"section"},S("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=Ut(c.title,{role:"tab",id:`tab-${c.id}`,"aria-controls":u.id},()=>l(c.id));return c.group&&s.append(S("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r()&&c==="move"&&(c="inverse"),o.set(b.panel,t.scrollTop),b.panel=c;for(let u of a){let h=r()&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ct("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(p=>!p.tab.hidden),d=h.findIndex(p=>p.id===b.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),tt("layout",()=>l(b.panel==="move"||!a.some(c=>c.id===b.panel)?"move":b.panel)),l(b.panel),l}function Hw(n){let t=S("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>Ut(u,{},()=>Ug(c))),Ut("Fit",{},()=>mu())),e=S("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=Ut("Trace",{"aria-pressed":"true"},()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),sM(c)}),s=Ut("Clear",{"aria-label":"Clear the trace"},kf),r=S("span",{class:"scale"}),o=S("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=S("span",{class:"dot"});return h.style.setProperty("background",Br[u]),S("span",{},h,c)}),r);n.append(S("div",{class:"corner top"},t,S("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),Fw(),S("div",{class:"group",role:"group","aria-label":"The picture"},vw(n),Ut("PNG",{"aria-label":"Save the picture","data-testid":"save-picture"},bw))),S("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=b.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);b.shownFrames=(b.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{b.shownFrames=d,l()};Gt(e,S("span",{class:"group-name",text:"Frames"}),u.map(d=>Ut(Bf(d),{"aria-pressed":String(b.shownFrames.includes(d)),"aria-label":`Frame ${Bf(d)}`},()=>h(b.shownFrames.includes(d)?b.shownFrames.filter(f=>f!==d):[...b.shownFrames,d]))),Ut(b.shownFrames.length===c+2?"none":"all",{"aria-label":"All frames or none"},()=>h(b.shownFrames.length===c+2?[]:u))),ct("frames"),bt(r,`grid ${re(Fg.cell,"length",gt.length==="mm"?0:2)}`)};tt(["table","units"],l),l()}function Gw(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),S0()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),w0()))})}var bx=()=>b.frames[b.frames.length-1],Ww={id:"pose",title:"Pose",build(n){let t=Ol("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>Vw(u,"length",`pose-${u.toLowerCase()}`)),i=S("div",{class:"quantities","data-testid":"orientation"}),s=S("p",{class:"hint order"}),r=[],o=hn("Notation of the orientation",Object.entries(Fs).map(([u,h])=>[u,h.title]),b.notation,u=>{b.notation=u,ct("notation")}),a=S("span",{class:"copies"},Ut("Copy matrix",{class:"quiet",title:"As numbers in metres, row by row"},()=>eo(mp(bx()))),Ut("Copy numbers",{class:"quiet",title:"Position and orientation, in the units shown"},()=>eo(DD())));n.append(S("div",{class:"subhead"},S("span",{text:"Tool in the base frame"}),a),t,S("div",{class:"quantities"},e.map(u=>u.el)),S("div",{class:"line"},o,s),i);let l=()=>{let u=Fs[b.notation];o.value=b.notation,bt(s,u.order),r=u.names.map((h,d)=>Vw(h,u.kinds[d],`turn-${d}`)),Gt(i,r.map(h=>h.el)),c()},c=()=>{let u=bx();t.show(u),te(u).forEach((h,d)=>e[d].show(h)),Fs[b.notation].to(u).forEach((h,d)=>r[d].show(h))};tt("q",c),tt("notation",l),tt("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function DD(){let n=bx(),t=Fs[b.notation],e=te(n).map((s,r)=>`${"XYZ"[r]} ${mn(s,"length")} ${gt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${mn(s,"angle")} ${gt.symbol("angle")}`:ii(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function Vw(n,t,e){let i=S("output",{"data-testid":e}),s=S("span",{class:"unit",text:gt.symbol(t)});return{el:S("div",{class:"quantity"},S("span",{class:"quantity-name",text:n}),i,s),show:o=>bt(i,t==="plain"?ii(o,5):mn(o,t)),relabel:()=>bt(s,gt.symbol(t))}}function ND(n,t){let e=[],i=n.joints.length,s=Mr(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=br(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*br(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var $w={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=S("div",{class:"cards","data-testid":"matrices"}),a=S("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=hn("Posture",[["now","present posture"]],"now",p=>{e=p,d()}),c=S("span",{class:"partial"});n.append(S("div",{class:"line"},Be("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,p=>{t=p,h()},"matrix-mode"),c),S("div",{class:"line"},S("span",{class:"field-name",text:"Numbers of the"}),l),o,S("h3",{text:"Intermediate angles"}),S("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&b.solutions?.rows[Number(e)]?.q||b.q,h=()=>{let p=b.table.joints.length;i=Math.min(i,p),s=s===0||s>p?p:s;let _=t==="links"?b.table.joints.map((g,x)=>["A",String(x+1),""]):t==="products"?b.table.joints.map((g,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&_.push(["T","tool","base"]);let m=Array.from({length:p+1},(g,x)=>[String(x),String(x)]);Gt(c,t==="partial"?[hn("From frame",m,String(i),g=>{i=Number(g),h()})," \u2192 ",hn("To frame",m,String(s),g=>{s=Number(g),h()})]:[]),r=_.map(([g,x,M])=>({grid:Ol(`${g} ${M} ${x}`,`matrix-${g}${M}${M?"-":""}${x}`),note:S("span",{class:"hint"}),sym:g,low:x,high:M})),Gt(o,r.map(({grid:g,note:x,sym:M,low:v,high:A})=>S("figure",{class:"card"},S("figcaption",{},S("span",{class:"symbol"},A?S("sup",{text:A}):null,S("i",{text:M}),S("sub",{text:v})),x),g))),d()},d=Qs(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let p=u(),_=w_(b.table,p),m=_.length;r.forEach(({grid:M,note:v},A)=>{if(t==="links"&&A<m)M.show(_[A]),bt(v,`q${A+1} = ${re(p[A],Ze(b.table.joints[A]))}`);else if(t==="links")M.show(As(b.table,p)[m+1]);else if(t==="products")M.show(_.slice(0,A+1).reduce(Hn,Ji()));else{let E=y=>_.slice(0,y).reduce(Hn,Ji());M.show(Hn(Ta(E(i)),E(s)))}});let g=Mr(b.table,p),x=b.table.joints.map((M,v)=>[M.type==="R"?`\u03B8${v+1}`:`d${v+1}`,M.type==="R"?mn(br(M,g[v]).theta,"angle"):mn(br(M,g[v]).d,"length"),M.type==="R"?"angle":"length"]).concat(ND(b.table,p).map(({name:M,value:v})=>[`\u03B8${M}`,mn(v,"angle"),"angle"]));Gt(a,S("tbody",{},x.map(([M,v,A])=>S("tr",{},S("th",{scope:"row"},S("i",{text:M[0]}),S("sub",{text:M.slice(1)})),S("td",{text:v}),S("td",{class:"unit",text:gt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let p=b.solutions?.rows??[];Gt(l,S("option",{value:"now",text:"present posture"}),p.map((_,m)=>S("option",{value:String(m),text:`solution ${m+1}: ${_.label??""}`}))),e!=="now"&&!p[Number(e)]&&(e="now"),l.value=e,d()};tt("table",h),tt(["q","units","panel"],d),tt(["solutions","panel"],f),h()}};var UD=.002,OD=1e-12;function Vs(n,t,e,i,s=t){let r=[],o="",a=null,l=S("div",{class:"pose-fields"}),c=()=>r.some(f=>f.f.classList.contains("wrong")),u=()=>{let f=Fs[b.notation],p=[["X","length"],["Y","length"],["Z","length"],...f.names.map((m,g)=>[m,f.kinds[g]])],_=()=>{if(c())return;let m=_b(b.notation,r.slice(3).map(g=>g.value),r.slice(0,3).map(g=>g.value));m&&(a=m,i(m,FD(r)))};r=p.map(([m,g],x)=>{let M={value:0,kind:g},v=(A,E)=>{M.value=A,M.text=E.text,_()};return M.f=Mn({label:`${n}, ${m}`,kind:g,testid:`${t}-${x}`,key:`${s}-${x}`,input:v,commit:(A,E)=>{E.text!==M.text&&v(A,E),ct("let-go")}}),M.el=S("label",{class:"pose-field"},S("span",{text:m}),M.f,S("span",{class:"unit",text:gt.symbol(g)})),M}),Gt(l,r.map(m=>m.el)),l.style.setProperty("--half",Math.ceil(r.length/2)),o=b.notation},h=()=>{if(o!==b.notation){d();return}let f=e();if(!f)return;let p=!a||f.some((_,m)=>Math.abs(_-a[m])>OD);!p&&(c()||l.contains(document.activeElement))||(a=f,[...te(f),...Fs[b.notation].to(f)].forEach((_,m)=>{r[m].value=_,r[m].text=null,r[m].f.put(_,BD(_,r[m].kind),p)}))},d=()=>$i(l,()=>{u(),h()});return tt("units",d),tt("notation",h),u(),h(),Yf(l,"paste a pose",()=>r.map(f=>f.f)),l.addEventListener("focusout",()=>setTimeout(h)),{el:S("fieldset",{class:"pose-editor"},S("legend",{text:n}),S("div",{class:"pose-room"},l)),show:h}}function FD(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?xl(t(e),"angle"):2*xl(t(n.slice(3)),"plain");return{metres:xl(t(n.slice(0,3)),"length"),radians:i}}var BD=(n,t)=>String(Number((n*gt.factor(t)).toFixed(t==="plain"||gt[t]==="m"||gt[t]==="rad"?6:3))+0),kD=n=>`row ${Math.floor(n/4)+1}, column ${n%4+1}`,Mx=n=>n%4===3&&n<12,qw=n=>wu(n).flat().filter(Boolean);function Xw(n){let t=qw(n).slice(0,12),e=t.filter((s,r)=>Mx(r)),i=t.filter((s,r)=>!Mx(r));return{metres:xl(e,"length"),radians:2*xl(i,"plain")}}function Yw(n){let t=qw(n);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.map((r,o)=>{try{return Sl(r,Mx(o)?"length":"plain").value}catch(a){throw new Error(`${kD(o)}: ${a.message}`)}}),i=e.length===16?e:[...e,0,0,0,1];if(Math.abs(i[12])+Math.abs(i[13])+Math.abs(i[14])+Math.abs(i[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");let s=ju(i);if(s>UD)throw new Error(s===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${s.toPrecision(2)}`);return Zu(i)}var Ro=2*Math.PI,jw=1e-9;function vp(n){return n.map((t,e)=>b.table.joints[e].type==="R"?zD(t,b.table.joints[e],b.q[e]):t)}function zD(n,{lower:t,upper:e},i){let s=t??-1/0,r=e??1/0,o=Math.ceil((s-jw-n)/Ro),a=Math.floor((r+jw-n)/Ro),l=Math.round((i-n)/Ro);return o>a?s-(n+Ro*a)<n+Ro*o-r?n+Ro*a:n+Ro*o:n+Ro*Math.min(Math.max(l,o),a)}function Zw(n,t){let e=t?.self_motions??[],i=pe.task??b.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Gt(n,S("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let p=d.moves.length>3?"most of its joints":d.moves.join(" and "),_=d.inside.length?WD(d):"All of it lies outside the limits.";return S("div",{class:"self-motion"},S("p",{},S("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${p}, ${a(d)}: the arm moves, ${o}. ${_}`),qD(d,f,t.T,s))},c=e.length?GD(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?S("details",{class:"fold"},S("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Gt(n,c>=0?l(e[c],c):null,h)}var HD=n=>n.reduce((t,e,i)=>t+Math.sin((e-b.q[i])/2)**2,0),GD=n=>{let t=n.map(e=>Math.min(...e.q.map(HD)));return t.indexOf(Math.min(...t))};function VD(n){let t=(s,r)=>s.map((o,a)=>b.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(b.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var WD=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function $D(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function qD(n,t,e,i){let s=S("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{xi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ct("did",{label:"slide along a self-motion",key:"self-motion"}),Oi(vp(i?T_(b.table,u,e):u),"self-motion")};return s.value=String(VD(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",$D(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function Jw(){let n=[],t=[],e={},i=S("div",{class:"joints"}),s=S("details",{},S("summary",{class:"hint",text:"Hold by value"}),i),r=S("p",{class:"hint"}),o=Be("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(p=>!p.instead).map(p=>p.name):null),"spare-mode"),a=S("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},S("div",{class:"line spread"},S("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:p=!1}={}){ct("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),pe.redundancy=f&&Object.fromEntries(f.map(_=>[_,e[_]])),d(),p?aM():ks({follow:!0})}let c=f=>n.filter(p=>p.instead===f.instead).map(p=>p.name),u=f=>b.table.joints.findIndex(p=>p.name===f.name);function h(f,p){let _=f.kind==="angle"?Math.PI:Gn(b.table),m=f.lower??-_,g=f.upper??_,x=S("input",{type:"range",min:String(m),max:String(g),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${p+1}`}),M=!1,v=(w,N)=>{e[f.name]=w,l(c(f),{sliding:N})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>ks({follow:!0})),x.addEventListener("keydown",w=>{let N={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[w.key];if(N===void 0)return;w.preventDefault(),M=!0;let R=N*gt.step(f.kind)*(w.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+R,m),g),!0)}),x.addEventListener("keyup",()=>{M&&ks({follow:!0}),M=!1});let A=Mn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${p+1}`,check:w=>w<m-1e-9&&f.lower!==null?`below the limit ${re(m,f.kind)}`:w>g+1e-9&&f.upper!==null?`above the limit ${re(g,f.kind)}`:null,commit:w=>v(w,!1)}),E=S("span",{class:"limits"}),y=S("div",{class:"joint"},S("span",{class:"joint-name",text:f.name}),S("div",{class:"track"},x,S("div",{class:"under"},E)),A,S("span",{class:"unit"}));return{line:y,show(){let w=e[f.name];x.value=w,x.style.setProperty("--at",`${100*(Math.min(Math.max(w,m),g)-m)/(g-m||1)}%`),x.setAttribute("aria-valuetext",re(w,f.kind)),y.classList.toggle("held",!!(pe.redundancy&&f.name in pe.redundancy)),A.put(Number((w*gt.factor(f.kind)).toFixed(gt.digits(f.kind)+1))/gt.factor(f.kind))},relabel(){bt(y.lastChild,gt.symbol(f.kind));let w=N=>N===null?"no limit":re(N,f.kind,f.kind==="angle"&&gt.angle==="deg"?0:void 0);bt(E,f.lower===null&&f.upper===null?"no limits":`${w(f.lower)} \u2026 ${w(f.upper)}`),A.refresh()}}}function d(){for(let f of n)pe.redundancy&&f.name in pe.redundancy?e[f.name]=pe.redundancy[f.name]:u(f)>=0?e[f.name]=b.q[u(f)]:f.instead&&Number.isFinite(b.solutions?.arm_angle)?e[f.name]=b.solutions.arm_angle:e[f.name]??=0;o.mark(pe.redundancy?"chosen":"free"),bt(r,pe.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return tt("solutions",()=>{let f=b.solutions?.spare;if(!b.solutions||!f&&(b.solutions.brief||b.solutions.status==="REFUSED"))return;let p=JSON.stringify(f??[])!==JSON.stringify(n);if(p){n=f??[],e={},t=n.map(h),Gt(i,t.map(_=>_.line));for(let _ of t)_.relabel()}a.hidden=n.length===0,p&&(s.open=n.filter(_=>!_.instead).length>1||!!pe.redundancy),d()}),tt("q",()=>!a.hidden&&!a.closest("[hidden]")&&!pe.redundancy&&d()),tt("units",()=>{for(let f of t)f.relabel();d()}),a}function Kw(){let n=S("thead"),t=S("tbody"),e=S("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=S("div",{class:"scroll"},S("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${b.table.joints.map(c=>c.type).join("")}${gt.angle}${gt.length}`;l!==r&&(r=l,s=[],i.classList.toggle("many",b.table.joints.length>6),Gt(t),Gt(n,S("tr",{},S("td"),S("th",{class:"left",text:"posture"}),b.table.joints.map((c,u)=>S("th",{},S("i",{text:"q"}),S("sub",{text:String(u+1)}),S("span",{class:"unit",text:` ${gt.symbol(Ze(c))}`}))),S("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=b.table.joints.map(()=>S("td")),u=S("span"),h=S("span",{class:"offscreen"}),d=S("td",{class:"unit"}),f=S("tr",{tabindex:"0","data-testid":`solution-${l+1}`},S("th",{scope:"row",text:String(l+1)}),S("td",{class:"left"},u,h),c,d),p=()=>b.solutions?.rows[l]?.q,_=()=>p()&&gs(p()),m=()=>gs(null),g=()=>{p()&&(gs(null),Ii(vp(p()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",_),f.addEventListener("pointerleave",m),f.addEventListener("focus",_),f.addEventListener("blur",m),f.addEventListener("click",g),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),g())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&bt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),bt(u.beyond,d.inside?"":", outside the limits"),bt(u.residual,d.residual?vf(d.residual[0]*1e3):""),u.residual.title=d.residual?`${vf(d.residual[0])} m, ${vf(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,p)=>{let _=b.table.joints[p],m=_.lower!==null&&f<_.lower-1e-9||_.upper!==null&&f>_.upper+1e-9;bt(u.cells[p],mn(f,Ze(_))),u.cells[p].classList.toggle("out",m)}))}),this.mark()},mark(){let l=b.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===b.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-b.q[d])/2))<1e-5)))}}}var XD={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},Sx={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},YD=new Set(["REDUNDANT","UNCERTAIN","SINGULAR"]),jD=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,wx=120;function Ex(){wi(b.frames[b.frames.length-1].slice(),"taken")}var t1={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(S("div",{class:"line spread"},Ut("Take the present pose",{"data-testid":"take-pose"},Ex),Be("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",_=>{i.hidden=_!=="numbers",s.hidden=_!=="matrix"},"target-as")));let e=Vs("Target","target",()=>b.target,(_,m)=>wi(_,"typed",m)),i=S("div",{},e.el),{el:s,show:r}=JD();n.append(i,s,KD());let o=S("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=S("div",{class:"near","data-testid":"ik-nearest"}),l=S("div",{class:"self-motions","data-testid":"self-motions"}),c=Kw();n.append(Jw(),o,a,l,c.el);let u=Ca(wx,()=>{e.show(),r()}),h=Ca(wx,()=>{if(t.hidden)return;let _=b.solutions;QD(o,_),nN(a,_),Zw(l,_),c.show(_)}),d=Ca(wx,()=>c.mark()),f=_=>()=>Rf()?_.soon():_();tt("target",f(u)),tt("notation",e.show),tt(["solutions","units"],f(h)),tt("q",f(d));let p=()=>Hr("target",b.panel==="inverse"?ZD(te(b.target)):[]);tt("target",_=>_!=="drag"&&p()),tt("panel",_=>{Ub(_==="inverse"),(_!=="inverse"||b.hasTarget)&&p(),_==="inverse"&&(b.hasTarget?ct("solutions"):(b.hasTarget=!0,Ex()))}),tt("table",_=>{_==="new"&&(b.hasTarget=b.panel==="inverse",b.hasTarget&&Ex())})}};function ZD(n){let t=.25*Gn(b.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function JD(){let n=S("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=S("p",{class:"reason",role:"alert"}),e=S("p",{class:"hint"});n.addEventListener("input",()=>{try{wi(Yw(n.value),"typed",Xw(n.value)),bt(t,""),n.removeAttribute("aria-invalid")}catch(r){bt(t,r.message),n.setAttribute("aria-invalid","true")}});let i=null,s=()=>{if(bt(e,`Twelve or sixteen numbers, row by row; the last column in ${gt.length}.`),document.activeElement===n||n.hasAttribute("aria-invalid")&&i===b.target)return;i=b.target,bt(t,""),n.removeAttribute("aria-invalid");let r=b.target.map((o,a)=>a%4===3&&a<12?o*gt.factor("length"):o);n.value=mp(r.map(o=>Number(o.toFixed(6)))).replaceAll(`,
`,`
`)};return tt("units",s),s(),{el:S("div",{hidden:!0},n,e,t),show:s}}function KD(){let n=S("span",{class:"line"}),t=S("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{pe.follow=t.checked}}}),e=Be("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{pe.ghosts=i,bl()});return tt("task",()=>{t.checked=pe.follow,e.mark(pe.ghosts)}),tt("plan",()=>Gt(n,b.plan?.solvable?[S("span",{class:"field-name",text:"Task"}),hn("Task",[["",`${b.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],pe.task??"",i=>{ct("did",{label:"choose the task"}),pe.task=i||null,pe.redundancy=null,ks()},{"data-testid":"task"})]:[])),S("div",{class:"line controls"},S("span",{class:"line"},S("span",{class:"field-name",text:"Handles"}),Be("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Ob)),Be("Axes of the handles",[["local","Tool"],["world","World"]],"local",Fb),S("span",{class:"line"},S("span",{class:"field-name",text:"Snap"}),hn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>Bb(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),S("span",{class:"line"},S("span",{class:"field-name",text:"Ghosts"}),e),S("label",{class:"check"},t,"Arm follows"),n)}function QD(n,t){if(!t){Gt(n,S("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(a=>a.inside).length;n.dataset.tone=XD[t.status]??"note";let s=e>0&&YD.has(t.status),r=t.status==="SOLVED"&&e?Qw(t.missed):[t.why,s&&(t.status==="SINGULAR"||i<e)?jD(e,i):"",Qw(t.missed)].filter(Boolean).join(" "),o=Sx[t.status]&&!i?t.why.toLowerCase().includes(Sx[t.status].toLowerCase())?"":Sx[t.status]:s?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Gt(n,S("strong",{text:o})," ",S("span",{text:r}),t.ms===void 0?null:S("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var Qw=n=>n?`The pose was rounded by ${eN(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",tN=(n,t)=>re(n,t,gt.digits(t)+2),eN=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*gt.factor(e)>=.5*10**-(gt.digits(e)+2)).map(([t,e])=>tN(t,e)).join(" and ");function nN(n,t){let e=t?.near;if(!e){Gt(n);return}let i=te(e.T).map(s=>mn(s,"length")).join(", ");Gt(n,S("p",{},S("strong",{text:"Nearest reachable: "}),`${i} ${gt.symbol("length")}, ${re(e.metres,"length")} away`,e.radians>.001?`, turned by ${re(e.radians,"angle")}`:""),S("div",{class:"line"},Ut("Go there",{},()=>Ii(e.q)),Ut("Make it the target",{},()=>wi(e.T,"chosen"))))}var Tx=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function bp(n){return Tx(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Mp(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=bp(r)??{a:0,alpha:0};bp(r)&&(r=Ji()),o=Hn(Tx(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=bp(o)??{a:0,alpha:0};bp(o)&&(o=Ji()),r=Hn(r,Tx(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var e1=30,iN=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),sN={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"};function Sp(n,t,e,{symbolic:i,text:s},r){let o=b.table.joints.map((c,u)=>u!==n?c:{...c,[t]:e,text:{...c.text,[t]:i?s:void 0}}),a=Object.is(b.table.joints[n][t],e)&&b.table.joints[n].text?.[t]===o[n].text[t],l=`edit ${sN[t]??t} of joint ${n+1}`;a||yn({...b.table,joints:o},{what:"cell",label:l,key:`${n}/${t}`,open:!0}),r&&ct("let-go")}function zl(n,t,e){let{postures:i,coupling:s}=b.table,r=Object.fromEntries(Object.entries(i??{}).map(([l,c])=>[l,t(c,0)])),o=t(b.q,0),a=s?t(s,null).map((l,c)=>rN(l&&t(l,0),c,n.length)):null;yn({...b.table,joints:n,postures:r,coupling:a},{q:o,what:"rows",label:e})}var rN=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function n1(n,t,e){let i=b.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function Ax(){let n=b.table.joints.length;return n>=e1?(he(`At most ${e1} joints.`,"wrong"),!1):(zl([...b.table.joints,iN(n)],(t,e)=>[...t,e],`add joint ${n+1}`),document.querySelector(`[data-testid="dh-${n+1}-a"]`)?.focus(),!0)}function i1(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};zl(e(b.table.joints),e,`swap joints ${n+1} and ${t+1}`)}var oN=["did","table","path","path-loaded","program","routing","sequence","sequence-loaded","world"],Rx="The server was away and is back; this was not answered. Ask again.";function Xr(n){let t=S("p",{class:"verdict",role:"status","data-testid":n,hidden:!0});return t.say=(e,i="wrong")=>{t.hidden=!e,t.dataset.tone=i,bt(t,e)},t}var ls=()=>document.querySelector("#panel-table section"),wp=()=>document.querySelector("#panel-world section"),s1=(n,t)=>n.length===t.length&&n.every((e,i)=>Object.is(e,t[i]));async function Ep({roots:n,about:t},e){let i=Sr(...n());if(i)throw new Error(`${i} Nothing was computed.`);let s=t(),r=await e();if(!s1(s,t()))throw new Error("What was asked was changed meanwhile, so the answer is not shown. Ask again.");return r}function Co({text:n,working:t,testid:e,verdict:i,roots:s,about:r,ask:o,show:a,forget:l,open:c=()=>!0}){let u=S("button",{type:"button",class:"primary",text:n,"data-testid":e}),h=null,d=!1;u.ask=async(...p)=>{h=null,d=!1,u.disabled=!0,bt(u,t);try{let _=await Ep({roots:s,about:r},()=>o(...p));if(_.stopped)return;h=r(),a(_)}catch(_){d=_ instanceof Bo,i.say(_.message)}finally{bt(u,n),u.show()}},u.show=()=>{u.disabled=!c()},u.addEventListener("click",()=>u.ask());let f=()=>{!h||s1(h,r())||(h=null,i.say(""),l?.())};return tt("online",p=>{p&&d&&i.say(Rx,"note"),d=!1}),tt(oN,()=>queueMicrotask(f)),u}async function Tp(){let n=Sr(ls());if(n){he(`${n} Nothing was written.`,"wrong");return}try{hi(`${b.table.name||"arm"}.toml`,(await Oe("save",{})).text,"application/toml")}catch(t){he(t.message,"wrong")}}function a1(){let n=(t,e,i)=>{let s=S("input",{type:"file",class:"offscreen",tabindex:"-1",...i,on:{change:()=>lN(s)}});return[Ut(t,{title:e},()=>s.click()),s]};return[...n("Open\u2026","A robot file (.toml) or a URDF",{accept:".toml,.urdf,.xml","aria-label":"Robot file","data-testid":"robot-file"}),...n("Folder\u2026","A folder with a URDF and the meshes that it names; they stay in this browser",{webkitdirectory:!0,multiple:!0,"aria-label":"Folder with a robot file and its meshes","data-testid":"robot-folder"})]}var aN=/\.(toml|urdf|xml)$/i,r1=2e5;async function lN(n){let t=[...n.files];if(n.value="",!t.length)return;let e=t.filter(s=>aN.test(s.name)),i=t.length===1?t[0]:e.find(s=>/\.urdf$/i.test(s.name))??e[0];if(!i){he("There is no robot file (.urdf or .toml) in this folder.","wrong");return}if(i.size>r1){he(`${i.name} has ${i.size} bytes; a robot file has at most ${r1.toLocaleString("en")}.`,"wrong");return}try{let{table:s,looks:r}=await Fi("open",{name:i.name.slice(-80),text:await i.text()});yn(s,{q:Aa(s),what:"new",label:`open ${i.name.slice(-40)}`}),kl(r,s,a=>o1(t,a));let o=r?.shapes.filter(a=>a.file&&!o1(t,a.file)).length;o&&he(`${o} of its meshes were not opened with it: open the folder that holds them.`)}catch(s){he(s.message,"wrong")}}function o1(n,t){let e=t.replace(/^\w+:\/\//,"").split("/"),i=s=>{let r=(s.webkitRelativePath||s.name).split("/"),o=0;for(;o<e.length&&o<r.length&&e.at(-1-o)===r.at(-1-o);)o+=1;return o};return n.reduce((s,r)=>i(r)>(s?i(s):0)?r:s,null)}var Cx=(n,t,e,i=!1)=>Ut(n,{class:"icon","aria-label":t,disabled:i},e),Po=({k:n,n:t,name:e,move:i=null,remove:s})=>[...i?[Cx("\u2191",`Move ${e} up`,()=>i(n,n-1),n===0),Cx("\u2193",`Move ${e} down`,()=>i(n,n+1),n===t-1)]:[],Cx("\xD7",`Remove ${e}`,()=>s(n))];var Px={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},cN=({catalog:n,...t})=>n?{...t,derived:n}:t,uN=n=>n.type==="R"?"angle":"length",c1={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=S("thead"),s=S("tbody"),r=S("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=S("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=S("p",{class:"verdict","data-testid":"arm-kind"}),l=Be("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],b.table.convention,v=>{v!==b.table.convention&&yn(Mp(b.table,v),{what:"rows",label:`make the table ${v}`})},"convention"),c=S("p",{class:"hint order"}),u=S("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>yn({...cN(b.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=Vs("Base","base",()=>b.table.base,v=>yn({...b.table,base:v},{what:"cell",label:"edit the base",key:"base",open:!0})),d=Vs("Tool","tool",()=>b.table.tool,v=>yn({...b.table,tool:v},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(S("div",{class:"line spread"},S("span",{class:"line"},u),S("span",{class:"line"},Ut("Blank",{title:"An empty table"},()=>yn(A_(b.table.convention),{q:[],what:"new",label:"begin a blank table"})),...a1(),Ut("Save",{title:"As a robot file"},Tp))),S("div",{class:"line spread"},l,Be("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,v=>{t=v,g()},"dh-part")),c,r,S("div",{class:"line"},Ut("+ Add joint",{class:"add","data-testid":"add-joint"},()=>Ax()),S("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,xb(),S("details",{class:"fold","data-testid":"base-tool"},S("summary",{text:"Base and tool"}),h.el,d.el)),Xf(s,"paste a table",v=>{for(;b.table.joints.length<v&&Ax(););}),n.addEventListener("verdict",v=>{f(v.detail??l1(n))});let f=v=>bt(o,v?`${v.label}: ${v.reason}. The arm stays as it was.`:""),p=(v,A,[E,y,w])=>{let N=v.type==="R"&&E==="theta"||v.type==="P"&&E==="d",R=E==="lower"||E==="upper",L=Mn({label:`Joint ${A+1}, ${y}`,kind:w??uN(v),testid:`dh-${A+1}-${E}`,key:`${v.name}/${E}`,empty:R?null:void 0,check:z=>R?n1(A,E,z):z!==null&&Math.abs(z)>1e6?"larger than a million":null,input:(z,G)=>Sp(A,E,z,G,!1),commit:(z,G)=>Sp(A,E,z,G,!0)});return R&&(L.placeholder="none"),e.push({f:L,i:A,key:E}),S("td",{class:N?"variable":""},N?S("span",{class:"plus"},S("i",{text:"q"}),S("sub",{text:String(A+1)})," +"):null,L)},_=(v,A)=>Ut(v.type,{class:`type type-${v.type}`,"data-testid":`dh-${A+1}-type`,"aria-label":`Joint ${A+1} is ${v.type==="R"?"revolute":"prismatic"}; press to change`,title:v.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute."},()=>zl(b.table.joints.map((E,y)=>y===A?{...E,type:E.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...E.text,lower:void 0,upper:void 0,offset:void 0}}:E),E=>E.map((y,w)=>w===A&&typeof y=="number"?0:y),`make joint ${A+1} ${v.type==="R"?"prismatic":"revolute"}`)),m=(v,A)=>S("td",{class:"tools"},Po({k:v,n:A,name:`joint ${v+1}`,move:i1,remove:()=>zl(b.table.joints.filter((E,y)=>y!==v),E=>E.filter((y,w)=>w!==v),`remove joint ${v+1}`)})),g=v=>v==="undo"||v==="new"?x():$i(s,x),x=()=>{e=[];let{joints:v}=b.table,A=b.table.convention==="modified",E=t==="geometry"?Px.geometry.map(([y,w,N])=>S("th",{scope:"col"},S("i",{text:w}),S("sub",{text:A&&(y==="a"||y==="alpha")?"i\u22121":"i"}),S("span",{class:"unit",text:` ${gt.symbol(N)}`}))):["name","lower limit","upper limit","zero","sense"].map(y=>S("th",{scope:"col",text:y}));Gt(i,S("tr",{},S("th",{scope:"col",text:"i"}),S("th",{scope:"col"},S("span",{class:"offscreen",text:"type"})),E,S("td"))),Gt(s,v.map((y,w)=>{let N=t==="geometry"?Px.geometry.map(R=>p(y,w,R)):[S("td",{},S("input",{type:"text",class:"name",value:y.name,maxlength:"40","aria-label":`Joint ${w+1}, name`,on:{change:R=>Sp(w,"name",R.target.value||`joint_${w+1}`,{},!0)}})),...Px.joint.map(R=>p(y,w,R)),S("td",{},Ut(y.sign>0?"+":"\u2212",{class:"type","aria-label":`Joint ${w+1}, sense of the maker: ${y.sign>0?"as the table":"against the table"}`},()=>zl(b.table.joints.map((R,L)=>L===w?{...R,sign:-R.sign}:R),R=>R,`turn the sense of joint ${w+1}`)))];return S("tr",{"data-testid":`dh-row-${w+1}`},S("th",{scope:"row",text:String(w+1)}),S("td",{},_(y,w)),N,m(w,v.length))})),v.length||s.append(S("tr",{},S("td",{colspan:"7",class:"hint",text:"No joints yet."}))),M()},M=()=>{for(let{f:v,i:A,key:E}of e){let y=b.table.joints[A];v.put(y[E],y.text?.[E]??null)}l.mark(b.table.convention),bt(c,b.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=b.table.name),h.show(),d.show()};tt("table",v=>{v==="cell"||v==="name"||v==="postures"?M():g(v),f(l1(n))}),tt("units",g),tt("notation",()=>{h.show(),d.show()}),tt("plan",()=>{a.dataset.tone=b.plan?.solvable?"good":"wrong",Gt(a,S("strong",{text:ih(b.plan)||(b.plan?.refused?"Refused":"Not solved")})," ",S("span",{text:b.plan?.explain??""}))}),g()}};function l1(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var hN=4,dN=n=>{let t=n.toFixed(hN);return Number(t)<0?`(${t})`:t.replace("-","")};function Ap(n,t,e){let i=Mr(t,e),s=t.joints.map((c,u)=>br(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,dN(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Rp=null;async function fN(){return Rp??=(await import("./katex-PEGWDONQ.js")).default,Rp}function pN(n,t){let e=S("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function u1(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>pN(n,i)],[i=>"code"in i,i=>S("code",{text:i.code})],[()=>!0,i=>S("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var mN=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function gN(n){let t=b.table.joints.map((e,i)=>S("th",{},S("i",{text:"q"}),S("sub",{text:String(i+1)}),S("span",{class:"unit",text:` ${gt.symbol(Ze(e))}`})));return[S("h3",{text:"The formulas at the present pose"}),S("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},S("thead",{},S("tr",{},S("th",{text:"branch"}),t)),S("tbody",{},n.map((e,i)=>S("tr",{},S("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>S("td",{text:mn(s,Ze(b.table.joints[r]))}))))))]}var h1={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=S("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=S("div",{class:"equations",tabindex:"0",role:"region","aria-label":"Equations","data-testid":"equations"}),c=Be("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,_()},"equation-numbers"),u=S("div",{class:"scroll"});n.append(S("div",{class:"line spread"},S("span",{class:"line"},Be("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,_()},"which-equations"),c),Ut("Copy LaTeX",{class:"quiet"},()=>eo(f()))),a,u,l);let h=v=>v.symbols&&i==="present"?Ap(v,b.table,b.q):v.latex,d=v=>v.number===void 0?"":` \\tag{${v.number}}`,f=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${d(v)} \\]`:mN(v.pieces)).join(`

`);function p(v){r=[],Gt(l,o.map(A=>m(v,A))),g()}async function _(){if(t.hidden||!b.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(b.table.joints)}${b.table.convention}`;if(s!==v){s=v,bt(a,"Deriving \u2026"),Gt(l);try{let[A,E]=await Promise.all([fN(),Oe("equations",{which:e,numbers:i==="symbols"?i:"numbers"},y=>bt(a,y.note??""))]);if(s!==v)return;bt(a,E.note??""),o=E.blocks,p(A),c.hidden=e!=="forward",Gt(u),x()}catch(A){if(s!==v)return;s=null,bt(a,A.message)}}}function m(v,A){if(A.kind==="heading"||A.kind==="step")return S("h3",{},u1(v,A.pieces));if(A.kind!=="equation")return S("p",{class:"prose"},u1(v,A.pieces));let E=S("div",{class:"formula"});try{v.render(h(A),E,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{E.replaceChildren(S("code",{text:h(A)}))}if(A.number!==void 0)return S("div",{class:"formula-row numbered"},E,S("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return E;let y=S("output",{class:"value","data-entry":String(A.entry)});return r.push({value:y,entry:A.entry}),S("div",{class:"formula-row"},E,y)}let g=Qs(()=>{if(t.hidden)return;let v=b.frames[b.frames.length-1];for(let{value:A,entry:E}of r)bt(A,`= ${E%4===3?`${ii(v[E]*gt.factor("length"),gt.digits("length"))} ${gt.length}`:ii(v[E],4)}`)}),x=tr(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:v}=await Oe("formulas",{T:b.frames.at(-1)});Gt(u,v.length&&e==="inverse"?gN(v):null)}catch{Gt(u)}},250),M=tr(()=>{!t.hidden&&Rp&&o.length&&e==="forward"&&i==="present"&&p(Rp)},120);tt("q",M),tt("panel",M),tt("q",x),tt("units",x),tt("panel",_),tt("plan",_),tt(["q","units"],g)}};var xN=()=>b.frames.at(-1).slice();function Cp(n,t){let e=b.path,i=n==="path"?"":`${n}-`,s=(a,l,c,u)=>{ct("did",{label:c,key:u}),e[a]=l,t(),ct("path",n)},r=["from","to"].map(a=>{let l=Vs(a==="from"?"From":"To",`${n}-${a}`,()=>e[a],u=>s(a,u,`set \u201C${a}\u201D of the path`,`path-${a}`)),c=Ut("Take the present pose",{class:"quiet","data-testid":`${i}take-${a}`},()=>{s(a,xN(),`take \u201C${a}\u201D of the path`),l.show()});return{el:S("div",{class:"end"},c,l.el),show:l.show}}),o=()=>r.forEach(a=>a.show());return tt("path",a=>a!==n&&o()),tt("path-loaded",o),tt("notation",o),{el:S("div",{},...r.map(a=>a.el)),show:o,showEnd:a=>r[a].show()}}var d1=()=>b.frames[b.frames.length-1].slice(),f1={id:"path",title:"Path",wide:!0,build(n,t){let e=b.path,i=null,s=Cp("path",()=>d()),r=S("span",{class:"hint"}),o=Mn({label:"Number of points N",testid:"path-n",check:M=>Number.isInteger(M)&&M>=2&&M<=2e3?null:"a whole number from 2 to 2000",input:M=>{ct("did",{label:"set the points of the path",key:"path-n"}),e.n=M}}),a=Mn({label:"Seconds for the whole line",testid:"path-seconds",check:M=>M>0&&M<=3600?null:"more than 0, at most 3600",input:M=>{ct("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=M,$r(i)}}),l=Ut("Keep the orientation of \u201CFrom\u201D",{class:"quiet"},()=>{if(e.from&&e.to){let M=te(e.to);ct("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((v,A)=>{e.to[v]=M[A]}),s.show(),ct("path","path"),d()}}),c=Xr("path-verdict"),u=Co({text:"Plan the line",working:"Planning \u2026",testid:"plan",verdict:c,roots:()=>[n,ls()],about:()=>[no(),e.from,e.to,e.n],ask:M=>Oe("follow",p(M??b.q)),show:_,forget:()=>{$r(i),Gt(h)}}),h=S("div",{class:"branches","data-testid":"branches"});n.append(s.el,S("div",{class:"line"},l,r),S("div",{class:"line"},S("label",{class:"field"},S("span",{class:"field-name",text:"Points N"}),o),S("label",{class:"field"},S("span",{class:"field-name",text:"Seconds"}),a),u,S("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,h);let d=()=>{if(!e.from||!e.to){bt(r,"");return}let M=M_(e.from,e.to);bt(r,`${re(Ui(Ni(te(e.to),te(e.from))),"length")} long${M>1e-6?`, turning ${re(M,"angle")}`:", orientation kept"}`),ta(Array.from({length:33},(v,A)=>te(Sf(e.from,e.to,A/32))))},f=null,p=M=>f={T0:e.from,T1:e.to,n:e.n,start:M};function _(M){if(b.track=M,c.say(M.explain,M.complete?"good":"wrong"),M.complete||m(M),Gt(h,M.branches.length?S("h3",{text:"Branches that start at the first pose"}):null,M.branches.map((y,w)=>S("button",{type:"button",class:`branch ${w===M.chosen?"chosen":""}`,"aria-pressed":String(w===M.chosen),"data-testid":`branch-${w+1}`,disabled:!y.q,title:y.cause||"reaches the end",on:{click:async()=>{await Ii(y.q,.4,`take branch ${w+1}`),u.ask(y.q)}}},S("span",{class:"branch-name",text:`${w+1}  ${y.label}`}),g(y.s),S("span",{class:"branch-end",text:y.complete?"to the end":y.q?`${y.points} of ${e.n}`:"starts outside the limits"})))),ta(M.path.map(te)),!M.q.length){ci(null);return}let v=M.path.length,A=M.q.map((y,w)=>w+1),E=M.q.map((y,w)=>v>1?e.seconds*w/(v-1):0);i=dr({table:b.table,q:M.q,xs:A,xName:"point",xEnd:v,seconds:E,title:`${b.table.name}: straight line, ${M.q.length} of ${v} points`,events:M.events.map(y=>({...y,x:1+y.s*(v-1),short:y.cause}))}),ci(i)}function m(M){c.say(`${M.explain}
Looking for what would let it pass \u2026`,"wrong"),Oe("cures",f).then(v=>v.explain??M.explain).catch(()=>M.explain).then(v=>b.track===M&&!c.hidden&&c.say(v,"wrong"))}function g(M){let v=S("span",{class:"bar-fill"});return v.style.setProperty("width",`${100*M}%`),S("span",{class:"bar"},v)}let x=()=>{s.show(),o.put(e.n),a.put(e.seconds),d()};tt("panel",M=>{M==="path"&&(e.from??=d1(),e.to??=d1(),x())}),tt("path-loaded",x),tt("units",d),tt("table",M=>{["postures","name","gripper"].includes(M)||(ta([]),t.hidden||x())})}};var p1=Math.PI/180,_N=()=>({turn_speed:180*p1,turn_acceleration:600*p1,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});var yN=n=>b.program.slice(0,Math.max(n,0)).findLast(t=>t.kind==="frame")?.T??Ji(),Fu=n=>Hn(Ta(yN(n)),b.frames.at(-1));function Pp(n,t){let e=(s,r)=>{for(;s>=1&&s<=t.length&&t[s-1]<0;)s+=r;return s>=1&&s<=t.length?t[s-1]+1:null},i=[];return n.forEach((s,r)=>{if(t[r]<0)return;if(s.kind!=="call"){i[t[r]]=s;return}let o=[e(s.first,1),e(s.last,-1)].filter(a=>a!==null);o.length===2&&s.first<=s.last&&(i[t[r]]={...s,first:Math.min(...o),last:Math.max(...o)})}),i.filter(Boolean)}var m1=(n,t)=>n.kind==="call"&&n.last>t?"Only steps before it can be done again: move it down, or name others.":null;function ca(n,t,{key:e,open:i}={}){ct("did",{label:t,key:e,open:i}),!b.program.length&&n.length&&(b.start??=b.q),b.program=n,ct("program")}var ua=(n,t,e,i)=>ca(b.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function g1(n,t){ct("did",{label:t,key:"limits"}),b.limits={...Ip(),...n},ct("program","limits")}var Ip=()=>({..._N(),...b.limits});function x1(n,t="set the start of the program"){ct("did",{label:t}),b.start=n,ct("program")}var Lp=()=>b.start?.length===b.table.joints.length?b.start:b.q;function Io(){let n=Ip(),t=b.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:Lp(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:b.program.map(({name:i,...s})=>s)}}var vN=()=>({turn:null,cone:0,axis:"z",cost:"motion",singularity:0,clearance:0,start:null,end:null}),Yr=()=>b.routing??vN();function Hl(n,t,e=t){ct("did",{label:t,key:e}),b.routing={...Yr(),...n},ct("routing")}var Ix=()=>{let n=Yr();return{turn:n.turn??"free",cone:n.cone,axis:n.axis}};function Dp(){let n=Yr(),t=b.path,e=b.world.some(i=>i.role!=="object"&&i.kind!=="frame");return{T0:t.from,T1:t.to,n:t.n,free:Ix(),cost:n.cost,singularity:n.singularity,start:n.start?.q??null,end:n.end?.q??null,world:b.world,clearance:e?n.clearance:0}}function Lx(n,t){let e=Uint8Array.from(atob(n.open[t]),i=>i.charCodeAt(0));return(i,s)=>{let r=i*n.turn.length+s;return e[r>>3]>>7-(r&7)&1}}var Gl=n=>{let t=n.turn[1]-n.turn[0];return Math.abs(t*n.turn.length-2*Math.PI)<1e-6};function _1(n,t,e){let i=n.turn[1]-n.turn[0],s=n.turn.length,r=Math.round((e-n.turn[0])/i);if(Gl(n)&&(r=(r%s+s)%s),r<0||r>=s)return[];let o=Math.round(t*(n.s.length-1));return n.branches.filter((a,l)=>Lx(n,l)(o,r))}var ha=Math.PI/180,y1=3.4,bN=2.1,v1=.5,MN=.9;function b1({drag:n,drop:t,scrub:e}){let i=S("canvas",{"aria-hidden":"true"}),s=S("div",{class:"route-now",hidden:!0}),r=S("div",{class:"route-word",hidden:!0,"data-testid":"route-word"}),o=["start","end"].map(D=>S("div",{class:`route-end ${D}`,role:"slider",tabindex:"0","aria-orientation":"vertical","aria-label":D==="start"?"Turn of the tool where the route begins":"Turn of the tool where it ends","data-testid":`route-${D}`,hidden:!0})),a=S("div",{class:"route-map","data-testid":"route-map"},i,s,...o,r),l=null,c=null,u=null,h=null,d={start:!1,end:!1},f=[],p=()=>parseFloat(getComputedStyle(document.documentElement).fontSize);function _(){let D=p(),O=a.clientWidth,Z=a.clientHeight,X={l:y1*D,t:v1*D,w:O-(y1+MN)*D,h:Z-(v1+bN)*D},J=-Math.PI,nt=Math.PI;if(l.map&&!Gl(l.map))J=l.map.turn[0],nt=l.map.turn.at(-1);else if(l.turn.length){let dt=90*ha;J=Math.min(J,dt*Math.floor(Math.min(...l.turn)/dt)),nt=Math.max(nt,dt*Math.ceil(Math.max(...l.turn)/dt))}u={...X,lo:J,hi:nt,W:O,H:Z}}let m=D=>u.l+D*u.w,g=D=>u.t+(1-(D-u.lo)/(u.hi-u.lo))*u.h,x=D=>u.lo+(1-(D-u.t)/u.h)*(u.hi-u.lo),M=D=>Ft.curves[Math.max(l.branches.indexOf(D),0)%Ft.curves.length];function v(){f=(l.map?.branches??[]).map((D,O)=>{let Z=Lx(l.map,O),X=l.map.s.length,J=l.map.turn.length,nt=S("canvas",{width:X,height:J}),dt=nt.getContext("2d"),ft=dt.createImageData(X,J),st=parseInt(M(D).slice(1),16);for(let yt=0;yt<X;yt++)for(let xt=0;xt<J;xt++){if(!Z(yt,xt))continue;let Tt=4*((J-1-xt)*X+yt);ft.data.set([st>>16,st>>8&255,st&255,255],Tt)}return dt.putImageData(ft,0,0),{name:D,c:nt}})}function A(){if(!l||!a.clientWidth)return;_();let D=Math.min(devicePixelRatio,2),O=i.getContext("2d");i.width=u.W*D,i.height=u.H*D,O.scale(D,D);let Z=.76*p();O.font=`${Z}px "Inter Variable", system-ui, sans-serif`,O.fillStyle=Ft.ground,O.fillRect(u.l,u.t,u.w,u.h),O.save(),O.beginPath(),O.rect(u.l,u.t,u.w,u.h),O.clip(),E(O),y(O),w(O),O.restore(),N(O,Z),L()}function E(D){let O=l.map;if(!O)return;let Z=O.turn[1]-O.turn[0],X=Gl(O),J=O.turn[0]-Z/2,nt=O.turn.at(-1)+Z/2,dt=X?Math.floor((u.lo-J)/(2*Math.PI)):0,ft=X?Math.ceil((u.hi-nt)/(2*Math.PI)):0;for(let{name:st,c:yt}of f)if(!(c&&c!==st)){D.globalAlpha=(c?.4:.3)*(Ft.dark?.8:1);for(let xt=dt;xt<=ft;xt++){let Tt=g(nt+2*Math.PI*xt),At=g(J+2*Math.PI*xt);D.drawImage(yt,u.l,Tt,u.w,At-Tt)}}D.globalAlpha=1}function y(D){if(!l.blocked)return;let[O,Z]=l.blocked.s,X=m(O),J=Math.max(m(Z)-X,3);D.fillStyle=Ft.wrong,D.globalAlpha=.75,D.fillRect(Math.min(X,u.l+u.w-J),u.t,J,u.h),D.globalAlpha=1}function w(D){if(!l.q.length)return;let O=[[0]];l.labels.forEach((Z,X)=>{X&&Z!==l.labels[X-1]&&O.push([X-1]),O.at(-1).push(X)});for(let[Z,X]of[[.38,!0],[.18,!1]])for(let J of O){D.beginPath();for(let nt of J)D.lineTo(m(l.s[nt]),g(l.turn[nt]));D.lineWidth=Z*p(),D.lineJoin=D.lineCap="round",D.strokeStyle=X?Ft.panel:Ft.curves[l.labels[J.at(-1)]%Ft.curves.length],D.stroke()}}function N(D,O){D.strokeStyle=Ft.line,D.strokeRect(u.l,u.t,u.w,u.h),D.fillStyle=Ft.muted,D.textBaseline="middle",D.textAlign="right";let Z=(u.hi-u.lo)/ha,X=[5,10,15,30,45,90,180].find(nt=>Z/nt<=6)??180;for(let nt=Math.ceil(u.lo/ha/X-1e-9)*X;nt<=u.hi/ha+1e-6;nt+=X){let dt=g(nt*ha);D.fillText(mn(nt*ha,"angle",gt.angle==="deg"?0:2),u.l-.45*O,dt),D.globalAlpha=.5,D.beginPath(),D.moveTo(u.l,dt),D.lineTo(u.l+u.w,dt),D.lineWidth=1,D.stroke(),D.globalAlpha=1}D.textBaseline="top",D.textAlign="center";let J=u.t+u.h+.45*O;for(let nt of[0,.25,.5,.75,1])D.fillText(String(nt),m(nt),J);D.fillText("path, from 0 to 1",m(.5),J+1.15*O),D.save(),D.translate(.5*O,u.t+u.h/2),D.rotate(-Math.PI/2),D.textBaseline="middle",D.fillText(`turn of the tool, ${gt.symbol("angle")}`,0,0),D.restore()}let R=D=>h?.which===D?h.turn:D==="start"?l.turn[0]:l.turn.at(-1);function L(){o.forEach((D,O)=>{let Z=O?"end":"start",X=!!(l?.turn.length&&l.map);if(D.hidden=!X,!X)return;let J=R(Z);D.style.setProperty("left",`${m(O)}px`),D.style.setProperty("top",`${g(J)}px`),D.classList.toggle("pinned",d[Z]),D.setAttribute("aria-valuemin",mn(u.lo,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuemax",mn(u.hi,"angle",0).replace("\u2212","-")),D.setAttribute("aria-valuenow",mn(J,"angle").replace("\u2212","-")),D.setAttribute("aria-valuetext",`${re(J,"angle")}${d[Z]?", held":""}`)})}let z=D=>Math.min(Math.max(D,u.lo),u.hi);function G(D,O){h={which:D,turn:z(O)},L();let Z=_1(l.map,D==="start"?0:1,h.turn);r.hidden=!1,bt(r,`${re(h.turn,"angle",1)}: ${Z.length?Z.join("; "):"closed on every branch"}`),r.dataset.tone=Z.length?"":"wrong",r.style.setProperty("top",`${Math.min(Math.max(g(h.turn),u.t+12),u.t+u.h-12)}px`),r.classList.toggle("right",D==="end"),n(D,h.turn)}function F(){if(!h)return;let{which:D,turn:O}=h;r.hidden=!0,t(D,O)}o.forEach((D,O)=>{let Z=O?"end":"start";D.addEventListener("pointerdown",X=>{X.preventDefault(),D.focus(),D.setPointerCapture(X.pointerId);let J=R(Z)-x(X.clientY-a.getBoundingClientRect().top),nt=ft=>G(Z,x(ft.clientY-a.getBoundingClientRect().top)+J);D.addEventListener("pointermove",nt);let dt=()=>{D.removeEventListener("pointermove",nt),F()};D.addEventListener("pointerup",dt,{once:!0}),D.addEventListener("pointercancel",dt,{once:!0})}),D.addEventListener("keydown",X=>{let J={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1,PageUp:10,PageDown:-10}[X.key];if(J)G(Z,R(Z)+J*ha*(X.shiftKey?.1:1));else if(X.key==="Enter")F();else if(X.key==="Escape"&&h)U(),n(Z,null);else return;X.preventDefault(),X.stopPropagation()}),D.addEventListener("blur",()=>h?.which===Z&&F())}),i.addEventListener("pointerdown",D=>{if(!l?.q.length)return;let O=X=>e(Math.min(Math.max((X.clientX-a.getBoundingClientRect().left-u.l)/u.w,0),1));i.setPointerCapture(D.pointerId),O(D),i.addEventListener("pointermove",O);let Z=()=>i.removeEventListener("pointermove",O);i.addEventListener("pointerup",Z,{once:!0}),i.addEventListener("pointercancel",Z,{once:!0})});function U(){h=null,r.hidden=!0,l&&L()}return new ResizeObserver(Qs(A)).observe(a),{el:a,paint(){l&&v(),A()},cancel:U,show(D,O=null,Z={start:!1,end:!1}){l=D,d=Z,h=null,r.hidden=!0,a.hidden=!D,D&&(c=O,v(),A())},only(D){c=D,A()},at(D){s.hidden=D===null||!u||!l?.q.length,s.hidden||(s.style.setProperty("left",`${m(D)}px`),s.style.setProperty("top",`${u.t}px`),s.style.setProperty("height",`${u.h}px`))},place(D,O=null){let Z=a.getBoundingClientRect();return[Z.x+m(D==="end"?1:0),Z.y+g(O??R(D))]}}}var M1=Math.PI/180;function S1(){let n=(p,_,m)=>Hl({...p,start:null,end:null},_,m),t=(p,_,m)=>{let g=S("span",{class:"field-name"}),x=S("label",{class:"field"},g,m);return x.label=()=>{g.textContent=_==="plain"?p:`${p}, ${gt.symbol(_)}`},x},e=(p,_,m,g,x)=>{let M=Mn({label:p,kind:_,testid:m,check:g,input:x});return{f:M,el:t(p,_,M)}},i=Be("How far the tool may turn",[["free","All the way round"],["within","Within"]],"free",p=>{n({turn:p==="free"?null:[-45*M1,45*M1]},"free the turn of the route"),f()},"route-turn"),s=[0,1].map(p=>e(p?"to":"from","angle",`route-turn-${p}`,_=>Math.abs(_)<=4*Math.PI?null:"at most two turns",_=>{let m=Yr().turn?.slice()??[0,0];m[p]=_,n({turn:m},"bound the turn of the route",`route-turn-${p}`)})),r=Be("About which axis of the tool",["x","y","z"].map(p=>[p,p]),"z",p=>n({axis:p},"set the axis of the route"),"route-axis"),o=e("Axis may tilt by","angle","route-cone",p=>p>=0&&p<Math.PI/2?null:"from 0 to less than 90 degrees",p=>n({cone:p},"set the cone of the route","route-cone")),a=hn("What is cheapest",[["motion","least motion of the joints"],["time","least time"]],"motion",p=>n({cost:p},"set the cost of the route"),{"data-testid":"route-cost"}),l=e("Keep the singular values\u2019 ratio above","plain","route-singularity",p=>p>=0&&p<1?null:"from 0 to less than 1",p=>n({singularity:p},"keep the route from singular postures","route-singularity")),c=e("Keep from obstacles","length","route-clearance",p=>p>=0?null:"0 or more",p=>n({clearance:p},"keep the route from obstacles","route-clearance")),u=S("details",{class:"fold"},S("summary",{text:"More that is free, and what must be kept"}),S("div",{class:"line"},o.el),S("div",{class:"line"},S("label",{class:"field"},S("span",{class:"field-name",text:"Cheapest"}),a)),S("div",{class:"line"},l.el),S("div",{class:"line"},c.el)),h=S("div",{},S("div",{class:"line"},S("span",{class:"field-name",text:"Turn"}),i,...s.map(p=>p.el),S("span",{class:"field-name",text:"about the tool\u2019s"}),r),u),d=[...s,o,l,c];function f(){let p=Yr();i.mark(p.turn?"within":"free"),s.forEach((_,m)=>{_.el.hidden=!p.turn,_.f.put(p.turn?.[m]??0)}),r.mark(p.axis),o.f.put(p.cone),a.value=p.cost,l.f.put(p.singularity),c.f.put(p.clearance),c.el.hidden=!b.world.some(_=>_.role!=="object"&&_.kind!=="frame"),d.forEach(_=>_.el.label())}return tt(["units","world"],f),tt("routing",p=>["undo","loaded"].includes(p)&&f()),f(),{el:h,show:f}}var w1=n=>({id:"route",title:"Route",wide:!0,build(t){let e=b.path,i=null,s=null,r=null,o=Cp("route",()=>M()),a=S1(),l=(U,D,O,Z={})=>Ut(U,{"data-testid":D,...Z},O),c=l("Let both ends free","free-ends",()=>{Hl({start:null,end:null},"let the ends of the route free"),p.ask()}),u=l("Send to the program","route-to-program",z,{hidden:!0}),h=l("","route-others",L,{hidden:!0}),d=Xr("route-verdict"),f={roots:()=>[t,ls(),wp()],about:()=>[no(),e.from,e.to,e.n,b.routing,b.world]},p=Co({text:"Find the route",working:"Looking \u2026",testid:"find-route",verdict:d,...f,async ask(){let[U,D]=Yr().turn??[0,0];if(U>D)throw new Error(`The turn must have its lower end first; it goes from ${re(U,"angle")} to ${re(D,"angle")}.`);try{return await Oe("route",Dp())}catch(O){throw g.cancel(),O}},show:v,forget:()=>F()}),_=S("div",{class:"chips",role:"group","aria-label":"Branches on the map"}),m=S("div",{class:"branches","data-testid":"route-list"}),g=b1({drag:(U,D)=>D===null?gs(null):N(U,D),drop:(U,D)=>R(U,D),scrub:U=>r&&b.motion===r&&qr(E(U))}),x=S("details",{class:"fold",open:!0},S("summary",{text:"The line"}),o.el);g.el.hidden=!0,c.hidden=!0,t.append(S("p",{class:"hint",text:"The line of Path, with the tool free to turn about its own axis on the way. The map shows every turn at every place of the line and which branch is open there; drag the ends of the curve."}),x,a.el,S("div",{class:"line"},p,c,u),g.el,_,d,S("div",{class:"line"},h),m);let M=()=>{e.from&&e.to&&!i&&ta(Array.from({length:33},(U,D)=>te(Sf(e.from,e.to,D/32))))};function v(U){let D=Yr();if(i=b.route={...U,turn:A(U,D),asked:[e.from,e.to]},s=U.found?U.branches[U.labels[0]]:null,U.found&&(x.open=!1),d.say(U.text,U.found?"good":U.verdict==="IMPOSSIBLE"?"wrong":"note"),g.show(i,s,{start:!!D.start,end:!!D.end}),gs(null),c.hidden=!(D.start||D.end),u.hidden=!U.found,h.hidden=!1,bt(h,U.found?"Routes that begin with other postures":"What would let it through?"),Gt(m),y(),ta(U.points),!U.found){r=null,ci(null);return}let O=U.q.length;r=dr({table:b.table,q:U.q,xs:U.q.map((Z,X)=>X+1),xName:"point",xEnd:O,seconds:U.s.map(Z=>e.seconds*Z),title:`${b.table.name}: route, ${O} points`}),ci(r)}function A(U,D){if(!U.found||!U.map||!Gl(U.map))return U.turn;let O=D.start?D.start.turn-U.turn[0]:D.end?D.end.turn-U.turn.at(-1):0;return U.turn.map(Z=>Z+2*Math.PI*Math.round(O/(2*Math.PI)))}let E=U=>i.s.reduce((D,O,Z)=>Math.abs(O-U)<Math.abs(i.s[D]-U)?Z:D,0);function y(){Gt(_,i.branches.map((U,D)=>{let O=S("span",{class:"swatch"});return O.style.setProperty("background",Ft.curves[D%Ft.curves.length]),S("button",{type:"button",class:"chip","aria-pressed":String(s===U),title:s===U?"Show all branches":"Show this branch alone","data-testid":`route-branch-${D+1}`,on:{click:()=>{s=s===U?null:U,g.only(s),y()}}},O,U)}))}let w=(U,D)=>{let O=U==="start",Z=O?0:i.q.length-1;return{T:O?e.from:e.to,turn:D,free:Ix(),near:i.q[Z],branch:i.branches[i.labels[Z]]}},N=Ks(async(U,D)=>{let O=await Oe("route_posture",w(U,D)).catch(()=>null);gs(O?.q??null)});async function R(U,D){try{let O=await Oe("route_posture",w(U,D));if(!O.q)throw new Error(`The route cannot ${U} there. ${O.why}`);Hl({[U]:{turn:D,q:O.q,branch:O.label}},`turn the ${U} of the route to ${re(D,"angle",1)}`),await p.ask()}catch(O){gs(null),g.cancel(),he(O.message,"wrong")}}async function L(){h.disabled=!0,bt(h,"Looking \u2026");try{let U=await Ep(f,()=>Oe("route_others",Dp()));if(U.stopped)return;let D=O=>`cost ${Number(O.toPrecision(3))}`;Gt(m,U.relaxations.map(O=>S("p",{class:"verdict","data-tone":"note",text:O})),U.alternatives.map((O,Z)=>S("button",{type:"button",class:"branch","data-testid":`route-other-${Z+1}`,on:{click:async()=>{Hl({start:{turn:O.turn,q:O.q,branch:O.branch},end:null},`begin the route ${O.branch}`),await p.ask()}}},S("span",{class:"branch-name",text:O.branch}),S("span",{class:"hint",text:`begins turned ${re(O.turn,"angle",1)}`}),S("span",{class:"branch-end",text:D(O.cost)}))),U.relaxations.length+U.alternatives.length?null:S("p",{class:"hint",text:i?.found?"There is no other.":"No single change that was tried lets a route through."})),h.hidden=!0}catch(U){d.say(U.message)}finally{h.disabled=!1,i&&bt(h,i.found?"Routes that begin with other postures":"What would let it through?")}}async function z(){u.disabled=!0;try{let U=await Ep(f,()=>Oe("route_program",Dp()));if(U.stopped)return;let D=!b.program.length,O=D?U.steps.slice(1):U.steps;D&&(b.start=U.steps[0].q),ca([...b.program,...O],"send the route to the program");let Z=`${re(U.metres,"length",3)} and ${re(U.radians,"angle",3)}`;he(`Sent as a spline through ${U.poses} poses; it strays by at most ${Z}.`),n()?.("program")}catch(U){d.say(U.message)}finally{u.disabled=!1}}let G=()=>{b.routing&&(b.routing={...b.routing,start:null,end:null})};function F(){i=b.route=null,$r(r),d.say(""),g.show(null),u.hidden=h.hidden=c.hidden=!0,Gt(_),Gt(m),gs(null)}tt("panel",U=>{if(U!=="route")return;let D=()=>b.frames.at(-1).slice();e.from??=D(),e.to??=D(),o.show(),M(),i&&g.paint()}),tt("played",()=>{!r||b.motion!==r?g.at(null):g.at(i.s[gw()]??null)}),tt("motion",()=>b.motion!==r&&g.at(null)),tt("theme",()=>{g.paint(),i&&y()}),tt("units",()=>g.paint()),tt("routing",U=>{U==="undo"&&i&&p.ask()}),tt(["path","path-loaded"],()=>{!i||i.asked[0]===e.from&&i.asked[1]===e.to||(G(),F())}),tt("table",U=>{["postures","name","gripper"].includes(U)||(U!=="undo"&&G(),F())}),g.el.addEventListener("where",U=>Object.assign(U.detail,{at:g.place(U.detail.which,U.detail.turn)}))}});function E1(n){let t=u=>`edit step ${u+1}`,e=(u,h,d)=>ua(u,h,t(u),{key:`step-${u}-${d}`});function i(u,h,d,f){let p=Mn({label:`Step ${u+1}, ${d}`,testid:`step-${u+1}-${h}`,...f,input:_=>{n(()=>e(u,{[h]:_},h))}});return p.put(b.program[u][h]??null),S("label",{class:"field"},S("span",{class:"field-name",text:f.unit?`${d}, ${f.unit}`:d}),p)}let s=(u,h)=>{let d=b.program[u];return d.kind==="spline"?{T:h,through:[...d.through.slice(0,-1),h]}:{T:h}},r=(u,h,d)=>Number.isInteger(u)&&u>=h&&u<=d,o=u=>(h,d)=>Vs(d,`step-${u+1}-${h}`,()=>b.program[u]?.[h],f=>{let p=b.program[u].kind==="frame"?{}:{q:null};n(()=>e(u,h==="T"?{...s(u,f),...p}:{[h]:f},h))}).el;function a(u,h){let d=Be("A circle by",[["via","a pose on it"],["centre","its centre"]],u.centre?"centre":"via",_=>ua(h,_==="centre"?{centre:te(u.via??u.T),long_way:!1}:{centre:null,via:u.via??u.T},t(h)),`step-${h+1}-by`);if(!u.centre)return S("div",{},S("div",{class:"line"},d),o(h)("via","Over"));let f=["X","Y","Z"].map((_,m)=>{let g=Mn({label:`Step ${h+1}, centre ${_}`,kind:"length",testid:`step-${h+1}-centre-${m}`,input:x=>{let M=b.program[h].centre.slice();M[m]=x,n(()=>e(h,{centre:M},"centre"))}});return g.put(u.centre[m]),S("label",{class:"field"},S("span",{class:"field-name",text:_}),g)}),p=S("input",{type:"checkbox",checked:!!u.long_way,"data-testid":`step-${h+1}-far`,on:{change:()=>e(h,{long_way:p.checked},"far")}});return S("div",{},S("div",{class:"line"},d),S("div",{class:"line"},...f,S("span",{class:"unit",text:gt.length})),S("label",{class:"check"},p,"the longer way round"))}function l(u,h){let d=f=>ua(h,{through:f,T:f.at(-1)},t(h));return S("div",{class:"line"},S("span",{class:"field-name",text:u.through.length===1?"Goes to its target alone; add poses for it to go through":`Goes through ${u.through.length} poses, the last one its target`}),Ut("Add the present pose",{class:"quiet","data-testid":`step-${h+1}-through`},()=>d([...u.through,Fu(h)])),Ut("Take the last one out",{class:"quiet",disabled:u.through.length<2},()=>d(u.through.slice(0,-1))))}function c(u,h){return u.kind==="wait"?S("div",{class:"line step-editor"},i(h,"seconds","seconds",{check:d=>d>=0?null:"0 or more"})):u.kind==="gripper"?S("div",{class:"line step-editor"},i(h,"value","value",{check:d=>d>=0&&d<=1?null:"from 0, open, to 1, closed"})):u.kind==="call"?S("div",{class:"line step-editor"},i(h,"first","from step",{check:d=>r(d,1,h)?null:`from 1 to ${h}`}),i(h,"last","to step",{check:d=>r(d,u.first,h)?null:`from ${u.first} to ${h}`}),i(h,"times","times",{check:d=>r(d,1,50)?null:"a whole number from 1 to 50"})):u.kind==="frame"?S("div",{class:"step-editor"},o(h)("T","The frame, in the base"),S("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>ua(h,{T:b.frames.at(-1).slice()},`teach step ${h+1}`)),Ut("The base",{class:"quiet",title:"The poses that follow are meant in the base again"},()=>ua(h,{T:Ji()},`end the frame at step ${h+1}`)))):u.kind==="output"?S("div",{class:"line step-editor"},i(h,"port","port",{check:d=>Number.isInteger(d)&&d>=0?null:"a whole number from 0"}),S("label",{class:"check"},S("input",{type:"checkbox",checked:u.value,on:{change:d=>e(h,{value:d.target.checked},"value")}}),"on")):S("div",{class:"step-editor"},S("div",{class:"line"},hn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"],["spline","Spline"]],u.kind,d=>e(h,{kind:d,q:d==="joint"?u.q??null:null,speed:null,...d==="circle"&&!u.via?{via:u.T}:{},...d==="spline"?{through:u.through??[...u.via?[u.via]:[],u.T]}:{}},"kind"),{"data-testid":`step-${h+1}-kind`}),i(h,"blend","blend",{kind:"length",unit:gt.length,check:d=>d>=0?null:"0 or more"}),u.kind==="joint"?i(h,"speed","part of the speed",{empty:null,check:d=>d===null||d>0&&d<=1?null:"above 0 to 1"}):i(h,"speed","speed",{kind:"length",unit:`${gt.length}/s`,empty:null,check:d=>d===null||d>0?null:"more than 0"})),u.kind==="circle"?a(u,h):null,u.kind==="spline"?l(u,h):null,o(h)("T",u.q?"To (a taught posture; typing makes it a pose)":"To"),S("div",{class:"line"},Ut("Take the present pose",{class:"quiet","data-testid":`step-${h+1}-teach`},()=>ua(h,{...s(h,Fu(h)),q:u.kind==="joint"?b.q.slice():null},`teach step ${h+1}`)),u.q?Ut("Go there",{class:"quiet"},()=>Ii(u.q.slice(),.8,`go to step ${h+1}`)):null))}return c}function T1(){let n=S("div",{class:"line limits-of"}),t=i=>i==="undo"?e():$i(n,e),e=()=>{let i=new Set(b.table.joints.map(o=>o.type)),s=(o,a,l,c,u)=>{let h=Mn({label:a,kind:l,empty:u,testid:`limit-${o}`,check:d=>d===null||d>0?null:"more than 0",input:d=>g1({[o]:d},`limit the ${a.toLowerCase()}`)});return h.put(Ip()[o]),u===null&&(h.placeholder="none"),S("label",{class:"field"},S("span",{class:"field-name",text:`${a}, ${gt.symbol(l)}${c}`}),h)},r=(o,a,l)=>[s(`${a}_speed`,`${l}speed`,o,"/s"),s(`${a}_acceleration`,`${l}acceleration`,o,"/s\xB2"),s(`${a}_jerk`,`${l}jerk`,o,"/s\xB3",null)];Gt(n,i.has("R")?r("angle","turn","Joint "):null,i.has("P")?r("length","slide","Slide "):null,s("tool_speed","Tool speed","length","/s",null))};return tt(["table","units"],t),tt("program",i=>i!=="limits"&&t(i)),t(),n}var Np={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output",spline:"Spline to",frame:"Work frame",call:"Again"};function Dx(n){return n.kind==="wait"?`${n.seconds} s`:n.kind==="gripper"?n.value===0?"open":n.value===1?"closed":`${n.value}`:n.kind==="call"?`${n.first===n.last?`step ${n.first}`:`steps ${n.first} to ${n.last}`}${n.times>1?`, ${n.times} times`:""}`:n.kind==="output"?`${n.port} ${n.value?"on":"off"}`:n.kind==="joint"&&n.q?n.q.map((t,e)=>mn(t,Ze(b.table.joints[e]??{type:"R"}),1)).join(", "):`${te(n.T).map(t=>mn(t,"length",1)).join(", ")} ${gt.length}${n.kind==="spline"?`, ${n.through.length} ${n.through.length===1?"pose":"poses"}`:""}`}var A1=200,SN=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Vl=()=>Fu(Up()),Up=()=>b.program.length,R1={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=null,s=-1,r=S("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),o=Xr("program-verdict"),a=Xr("save-verdict"),l=S("details",{class:"fold",hidden:!0},S("summary",{text:"What binds, and when"}),S("p",{class:"hint prose"})),c=(R,L,z,G)=>Ut(L,{title:z,"data-testid":`step-add-${R}`},()=>m(G())),u=Co({text:"Run the program",working:"Planning \u2026",testid:"run-program",verdict:o,roots:()=>[n,ls(),wp()],about:()=>[no(),b.program,b.limits,b.start,b.world],open:()=>b.program.length>0,ask:()=>Oe("program",{...Io(),world:b.world}),show:w,forget:()=>{$r(i),l.hidden=!0}}),h=S("span",{class:"hint","data-testid":"program-start"}),d="rapid";n.append(S("div",{class:"line"},c("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:b.q.slice(),T:Vl(),blend:0})),c("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Vl(),blend:0})),c("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:f(),T:Vl(),blend:0})),c("spline","+ Spline","A smooth curve through taught poses, the first of them the present one",()=>({kind:"spline",through:[Vl()],T:Vl(),blend:0})),c("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:p()>.5?0:1})),c("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),c("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0})),c("frame","+ Frame","The poses that follow are meant in this frame, at first the present pose",()=>({kind:"frame",T:b.frames.at(-1).slice()})),c("call","+ Again","Earlier steps once more, in the frame that holds here",()=>({kind:"call",first:1,last:Math.max(Up(),1),times:1}))),S("div",{class:"line spread"},h,S("span",{class:"line"},Ut("Start here",{class:"quiet","data-testid":"start-here",title:"The program begins in the present posture"},()=>x1(b.q.slice())),Ut("Go to the start",{class:"quiet"},()=>Ii(Lp().slice(),.8,"go to the start")))),r,T1(),S("div",{class:"line"},u,S("span",{class:"line"},hn("Language of the file",SN,d,R=>{d=R,a.say("")},{"data-testid":"dialect"}),Ut("Save the program",{"data-testid":"save-program"},N))),a,o,l),Up=()=>t>=0?t+1:b.program.length;let f=()=>b.program.slice(0,Up()).findLast(R=>R.T&&R.kind!=="frame")?.T??Vl(),p=()=>b.program.findLast(R=>R.kind==="gripper")?.value??0;function _(){let R=Sr(r);return R&&he(`${R} Escape puts back what was there.`,"wrong"),!!R}function m(R){if(_())return;if(b.program.length>=A1){he(`At most ${A1} steps.`,"wrong");return}let L=t>=0?t+1:b.program.length;t=L;let z=Pp(b.program,b.program.map((G,F)=>F<L?F:F+1));if(R.kind==="call"&&!L){he("There is no step before it that could be done again.","wrong"),t=-1;return}ca([...z.slice(0,L),R,...z.slice(L)],`add a step: ${Np[R.kind].toLowerCase()}`)}function g(R,L){if(L<0||L>=b.program.length||R===L||_())return;let z=b.program.map((F,U)=>U);z.splice(L,0,...z.splice(R,1));let G=Pp(b.program,b.program.map((F,U)=>z.indexOf(U)));t=L,ca(G,`move step ${R+1} to ${L+1}`),r.children[L]?.querySelector(".step-name")?.focus()}function x(R){R!==t&&_()||(t=-1,ca(Pp(b.program,b.program.map((L,z)=>z===R?-1:z<R?z:z-1)),`remove step ${R+1}`))}function M(R,L){let z=L===t,G=e?.step===L?e.text:m1(R,L),F=S("button",{type:"button",class:"step-name quiet","aria-expanded":String(z),"data-testid":`step-${L+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{_()||(t=z?-1:L,E())},keydown:D=>{let O={ArrowUp:-1,ArrowDown:1}[D.key];O&&D.altKey?(D.preventDefault(),g(L,L+O)):O?(D.preventDefault(),r.children[L+O]?.querySelector(".step-name")?.focus()):D.key==="Delete"&&x(L)}}},S("b",{text:Np[R.kind]}),` ${Dx(R)}`,R.blend?S("span",{class:"hint",text:`, blend ${re(R.blend,"length",0)}`}):null),U=S("li",{class:`step${G?" failed":""}${z?" open":""}`,draggable:"true","data-testid":`step-row-${L+1}`},S("div",{class:"step-line"},S("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),S("span",{class:"hint",text:String(L+1)}),F,Po({k:L,n:b.program.length,name:`step ${L+1}`,move:g,remove:x})),G?S("p",{class:"reason",text:G}):null,z?A(R,L):null);return U.addEventListener("dragstart",D=>{s=L,D.dataTransfer.effectAllowed="move",D.dataTransfer.setData("text/plain",String(L))}),U.addEventListener("dragover",D=>{s<0||(D.preventDefault(),U.classList.add("target"))}),U.addEventListener("dragleave",()=>U.classList.remove("target")),U.addEventListener("drop",D=>{D.preventDefault();let O=s;s=-1,O>=0&&g(O,L)}),U}let v=!1,A=E1(R=>{v=!0,R(),v=!1}),E=R=>R==="undo"?y():$i(r,y);function y(){if(v){b.program.forEach((L,z)=>{let G=r.children[z]?.querySelector(".step-name");G&&Gt(G,S("b",{text:Np[L.kind]}),document.createTextNode(` ${Dx(L)}`))});return}t>=b.program.length&&(t=-1),Gt(r,b.program.map(M)),b.program.length||r.append(S("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),u.show();let R=Lp();bt(h,b.program.length?`Starts at ${R.map((L,z)=>mn(L,Ze(b.table.joints[z]),1)).join(", ")}`:"")}function w(R){if(e=R.failed,e&&(t=e.step),o.say(e?`S${e.name.slice(1)} cannot be done: ${e.text}${R.duration>0?`
Shown is what comes before it.`:""}`:[R.explain,R.clear?.text].filter(Boolean).join(`
`),e||R.clear?.verdict==="HIT"?"wrong":R.clear?.verdict==="UNCERTAIN"?"note":"good"),l.hidden=!R.tight.length,bt(l.lastChild,R.tight.map(z=>z.text).join(`
`)),E(),!(R.duration>0)){ci(null);return}let L=R.events.map(([z,G,F])=>({x:z,s:0,text:`${G} ${F} at ${z.toFixed(2)} s`,short:G==="gripper"?F>.5?"close":"open":G,stop:!1}));i=dr({table:b.table,q:R.q,xs:R.t,xName:"time",seconds:R.t,dq:R.dq,ddq:R.ddq,events:L,title:`${b.table.name}: program, ${R.duration.toFixed(2)} s`,happens:R.events,tight:R.tight,limits:Io().limits}),ci(i)}async function N(){let R=Sr(n,ls());if(R){a.say(`${R} Nothing was written.`);return}a.say("");try{let L="program",{text:z,name:G}=await Oe("program_file",{...Io(),dialect:d,name:L});hi(G,z)}catch(L){a.say(L.message)}}tt(["program","units","table"],R=>{a.say(""),R!=="limits"&&(e=null,E(R))}),E()}};var da=new Rn,Ux=new gl,wN=new ye,EN=n=>new Vn({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function Nx(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new He(e,3)),n}var C1=n=>n.rotateX(Math.PI/2),Op={box:n=>[Nx(new Hi(...n.size)),n.T],cylinder:n=>[Nx(C1(new Ci(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new V(...n.a),e=new V(...n.b).sub(t),i=e.length(),s=new ye().makeRotationFromQuaternion(new fn().setFromUnitVectors(new V(0,0,1),i?e.clone().normalize():new V(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[Nx(C1(new $o(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function Ox(n,t,e=.86){if(!Op[n.kind])return null;let[i,s]=Op[n.kind](n),r=EN(t);r.opacity=e,r.depthWrite=e>.5;let o=new Ge(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var I1=()=>[...b.world,...b.things??[]],L1=n=>{let t=Wl.get(n.name)??n.T;return t?te(t):n.a.map((e,i)=>(e+n.b[i])/2)},TN=n=>L1(n).map((t,e)=>t+(e===2?1:0));function AN(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=te(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*Js(n.T,s)[o])))}function D1(){en.add(da,Ux.group),tt(["world","table"],P1),tt("theme",P1)}var Wl=new Map;function Fx(n,t){if(t)Wl.set(n,t);else if(!Wl.delete(n))return;let e=da.children.find(s=>s.userData.name===n),i=b.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),O1()}var N1=n=>Wl.get(n)??null;function U1(){for(let n of[...Wl.keys()])Fx(n,null)}function O1(){let n=I1();Ux.show(n.filter(t=>t.kind==="frame"),.11*Gn(b.table),n.filter(t=>Op[t.kind]).map(t=>({text:t.name,at:L1(t),wish:TN(t)})))}function P1(){for(let t of da.children)t.geometry.dispose();da.clear();let n=I1();for(let t of n)if(t.kind==="curve"){let e=new Me().setFromPoints(t.points.map(i=>new V(...i)));da.add(new sr(e,new es({color:Ft.trace,fog:!1})))}else if(Op[t.kind]){let{mesh:e,T:i}=Ox(t,t.role==="object"?Ft.accent:Ft.ghost);e.matrix.copy(wN.set(...Wl.get(t.name)??i)),e.userData.name=t.name,da.add(e)}O1(),Hr("world",n.flatMap(AN)),fe()}var F1=()=>da.children.length+(Ux.last?.[0].length??0);var ql=new sr(new Me,new es({depthTest:!1,fog:!1})),Xl=new Dr(new Me,new rr({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));ql.renderOrder=Xl.renderOrder=6;ql.frustumCulled=Xl.frustumCulled=!1;ql.visible=Xl.visible=!1;var $l=new Rn,Bu=null,B1="",CN=()=>b.watch||b.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),PN=Ks(async()=>{try{let n=await Oe("clearance",{q:b.q,world:b.world});b.clearance=n}catch(n){if(nh(n))return;b.clearance={refused:n.message}}Bx(),ct("clearance")});function k1(){CN()&&b.table.joints.length?PN():b.clearance&&(b.clearance=null,Bx(),ct("clearance"))}function Bx(){let n=b.clearance,t=!!n?.points?.length;if(ql.visible=Xl.visible=t,t){let e=n.points.map(i=>new V(...i));for(let i of[ql,Xl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Ft.trace:Ft.wrong)}fe()}async function kx(n){if(Bu=null,n){let{bodies:t,explain:e}=await Oe("bodies",{});Bu=t,B1=e}for(let t of $l.children)t.geometry.dispose();$l.clear();for(let t of Bu??[]){let e=Ox(t,Ft.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},$l.add(e.mesh))}return H1(),B1}var z1=()=>$l.children.length,IN=new ye;function H1(){for(let n of $l.children){let{on:t,T:e}=n.userData;b.frames[t]&&n.matrix.copy(IN.set(...Hn(b.frames[t],e)))}fe()}function G1(){en.add(ql,Xl,$l),tt(["q","world","watch"],k1),tt("plan",k1),tt("q",()=>Bu&&H1()),tt("table",()=>Bu&&kx(!1).then(()=>ct("bodies-gone"))),tt("theme",Bx)}var DN=60,NN={box:"Box",cylinder:"Cylinder",frame:"Frame"},UN={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function zx(n,t,e={}){ct("did",{label:t,...e}),b.world=n,ct("world")}var Fp=(n,t,e)=>zx(b.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function ON(n,t){let e=t.value.trim(),i=b.world[n].name,s=b.world.some((r,o)=>o!==n&&r.name===e);if(e&&!s){e!==i&&Fp(n,{name:e},`name ${e}`);return}t.value=i,he(s?`There is a ${e} already; the name stays ${i}.`:`A thing needs a name; it stays ${i}.`,"wrong")}function FN(n,t){if(b.world.length>=DN)return;let e=te(b.frames.at(-1)),i=.06*Gn(b.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*b.world.length;let o=t==="object"?"object":n,a=1;for(;b.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};zx([...b.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var V1={id:"world",title:"World",wide:!0,build(n){let t=S("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=S("p",{class:"hint prose"}),i=S("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{b.watch=i.checked,ct("watch")}}}),s=S("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let d=await kx(s.checked);bt(e,s.checked?d:"")}catch(d){bt(e,d.message)}}}}),r=S("div",{class:"things","data-testid":"world"}),o=(d,f,p,_)=>Ut(d,{title:_,"data-testid":`add-${p}-${f}`},()=>FN(f,p));n.append(S("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),S("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),S("div",{class:"line"},S("label",{class:"check"},i,"Distance, always"),S("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),tt(["clearance","units"],()=>{let d=b.clearance;if(t.hidden=!d,!d)return;t.dataset.tone=d.refused||d.metres<=0?"wrong":"good";let[f,p]=d.pair??[];bt(t,d.refused??(d.metres===null?"There is nothing that could be touched.":d.metres>0?`Nearest: ${f} and ${p}, ${re(d.metres,"length")} apart.`:`${f} and ${p} overlap by ${re(-d.metres,"length")}.`))}),tt("bodies-gone",()=>{s.checked=!1,bt(e,"")});let l=!1,c=d=>{l||d==="python"||(d==="undo"?u():$i(r,u))},u=()=>{let d=S("p",{class:"hint",text:"Nothing stands around the arm yet."});Gt(r,b.world.length?b.world.map(h):d)};function h(d,f){let p=x=>(...M)=>{l=!0,x(...M),l=!1},_=S("input",{type:"text",value:d.name,maxlength:"40","aria-label":`Name of ${d.name}`,on:{change:()=>ON(f,_)}}),m=UN[d.kind].map((x,M)=>{let v=Mn({label:`${d.name}, ${x}`,kind:"length",testid:`world-${f+1}-size-${M}`,key:`${d.name}/${x}`,check:A=>A>0?null:"more than 0",input:p(A=>{let E=b.world[f],y=d.kind==="box"?{size:E.size.map((w,N)=>N===M?A:w)}:{[M?"h":"r"]:A};Fp(f,y,`size of ${d.name}`)})});return v.put(d.kind==="box"?d.size[M]:M?d.h:d.r),S("label",{class:"field"},S("span",{class:"field-name",text:`${x}, ${gt.length}`}),v)}),g=Vs(d.kind==="frame"?`Place of ${d.name}`:`Place of the middle of ${d.name}`,`world-${f+1}`,()=>b.world[f]?.T,p(x=>Fp(f,{T:x},`move ${d.name}`)),d.name);return S("section",{class:"thing","aria-label":d.name,"data-testid":`thing-${f+1}`},S("div",{class:"line spread"},S("span",{class:"line"},_,S("span",{class:"hint",text:NN[d.kind]}),d.kind==="frame"?null:hn(`What ${d.name} is`,[["object","object"],["obstacle","obstacle"]],d.role,x=>Fp(f,{role:x},`make ${d.name} an ${x}`))),Po({k:f,name:d.name,remove:()=>zx(b.world.filter((x,M)=>M!==f),`remove ${d.name}`)})),m.length?S("div",{class:"line"},m):null,g.el)}tt(["world","units"],c),c()}};var BN=40,W1={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return b.sequence.postures},set postures(x){b.sequence.postures=x},get rate(){return b.sequence.rate}},e=null,i=S("thead"),s=S("tbody"),r=Xr("sequence-verdict"),o=Co({text:"Run the sequence",working:"Planning \u2026",testid:"run-sequence",verdict:r,roots:()=>[n,ls()],about:()=>[no(),JSON.stringify(t.postures)],open:()=>t.postures.length>1,ask:()=>Oe("motion",m()),show:g,forget:()=>$r(e)}),a=Ut("Same times for all legs",{class:"quiet",title:"Copy the first leg\u2019s time and rest to the others"},()=>{let x=t.postures[1];if(x){ct("did",{label:"use the same times for all legs"});for(let M of t.postures.slice(2))M.seconds=x.seconds,M.hold=x.hold;p()}});n.append(S("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),S("div",{class:"scroll"},S("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},i,s)),S("div",{class:"line"},Ut("+ Present posture",{class:"add","data-testid":"add-posture"},()=>l(b.q.slice())),Ut("+ All named postures",{},()=>Mu("add all named postures",()=>Object.entries(b.table.postures??{}).forEach(([x,M])=>l(M.slice(),x)))),a),S("div",{class:"line"},o),r);function l(x,M){t.postures.length>=BN||(ct("did",{label:"add a posture to the sequence"}),t.postures.push({name:M??`P${t.postures.length}`,q:x,seconds:5,hold:0}),p(),ct("sequence"))}function c(x,M){ct("did",{label:`move ${t.postures[x].name} ${M<x?"up":"down"}`}),t.postures.splice(M,0,...t.postures.splice(x,1)),p(),ct("sequence")}function u(x){ct("did",{label:`remove ${t.postures[x].name}`}),t.postures.splice(x,1),p(),ct("sequence")}let h=new WeakMap,d=0,f=x=>h.get(x)??h.set(x,d+=1).get(x),p=()=>$i(s,_);function _(){let x=b.table.joints;t.postures=t.postures.filter(M=>M.q.length===x.length),o.show(),Gt(i,S("tr",{},S("td"),x.map((M,v)=>S("th",{},S("i",{text:"q"}),S("sub",{text:String(v+1)}),S("span",{class:"unit",text:` ${gt.symbol(Ze(M))}`}))),S("th",{text:"leg, s"}),S("th",{text:"rest, s"}),S("td"))),Gt(s,t.postures.map((M,v)=>{let A=x.map((y,w)=>{let N=Mn({label:`${M.name}, q${w+1}`,kind:Ze(y),testid:`seq-${v}-q${w+1}`,key:`${f(M)}-q${w+1}`,input:R=>{ct("did",{label:`edit ${M.name} of the sequence`,key:`seq-${v}-${w}`}),M.q[w]=R,ct("sequence")}});return N.put(M.q[w],String(Number((M.q[w]*gt.factor(Ze(y))).toFixed(gt.digits(Ze(y))))+0)),S("td",{},N)}),E=(y,w,N)=>{if(v===0)return S("td");let R=Mn({label:`${w} ${M.name}`,testid:`seq-${v}-${y}`,key:`${f(M)}-${y}`,check:N,input:L=>{ct("did",{label:`edit ${M.name} of the sequence`,key:`seq-${v}-${y}`}),M[y]=L,ct("sequence")}});return R.put(M[y]),S("td",{},R)};return S("tr",{"data-testid":`seq-row-${v}`},S("th",{scope:"row"},Ut(M.name,{class:"quiet",title:"Go there"},()=>Ii(M.q.slice()))),A,E("seconds","Seconds to",y=>y>0?null:"more than 0"),E("hold","Rest after",y=>y>=0?null:"0 or more"),S("td",{class:"tools"},Po({k:v,n:t.postures.length,name:M.name,move:c,remove:u})))})),t.postures.length||s.append(S("tr",{},S("td",{class:"hint",colspan:String(x.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}Xf(s,"paste into the sequence");let m=()=>({postures:t.postures.map(x=>x.q),seconds:t.postures.slice(1).map(x=>x.seconds),holds:t.postures.slice(1).map(x=>x.hold),rate:t.rate});function g(x){let M=t.postures,v=M.map((A,E)=>({x:x.arrivals[E],s:0,text:`${A.name} at ${x.arrivals[E].toFixed(2)} s`,short:A.name,stop:!1}));r.say(`${M.length} postures in ${x.t[x.t.length-1].toFixed(2)} s. ${kN(x.q)}`,"good"),e=dr({table:b.table,q:x.q,xs:x.t,xName:"time",seconds:x.t,dq:x.dq,events:v,title:`${b.table.name}: ${M.map(A=>A.name).join(" \u2013 ")}`}),ci(e)}tt(["table","units","sequence-loaded"],p),p()}};function kN(n){let t=b.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var zN=.14,Lo=new Ge(new Ds(1,32,20),new Vn({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));Lo.matrixAutoUpdate=!1;Lo.visible=!1;Lo.renderOrder=4;var ku="none";function HN(n,t,e){let i=E_(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function $1(n){ku=n,q1()}var Bp=()=>b.ellipsoid??null;function q1(){let n=ku!=="none"&&b.table.joints.length>0;if(Lo.visible=n,b.ellipsoid=null,n){let t=HN(b.table,b.q,b.frames),e=zN*Gn(b.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(ku==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=te(b.frames.at(-1)),[a,l]=r,c={...r[2]};Lo.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),Lo.material.color.set(ku==="velocity"?Ft.trace:Ft.accent),Lo.material.side=mi,b.ellipsoid=t}fe(),ct("ellipsoid")}function X1(){en.add(Lo),tt(["q","theme"],()=>ku!=="none"&&q1())}var Vp={};b_(Vp,{begin:()=>Vx,clear:()=>XN,corners:()=>qN,cutAt:()=>$N,range:()=>Gx,size:()=>jl,take:()=>Wx});var kp=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),Y1=.02;function zp(n){let t=Float32Array.from(n).sort(),e=t.length;return{lo:t[Math.floor(e*Y1)]??0,hi:t[Math.max(Math.ceil(e*(1-Y1))-1,0)]??1}}var VN=new ee;function Hp(n,{lo:t,hi:e}){let i=Math.min(Math.max((n-t)/(e-t||1),0),1)*(kp.length-1),s=Math.min(Math.floor(i),kp.length-2);return VN.lerpColors(kp[s],kp[s+1],i-s)}var Gp=n=>new Float32Array(Uint8Array.from(atob(n),t=>t.charCodeAt(0)).buffer);var Hx=new rr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),qi=new Dr(new Me,Hx);qi.frustumCulled=!1;qi.visible=!1;en.add(qi);var Yl=null,zu=null,Ss=0,Gx={lo:0,hi:1};function Vx(n){Yl=new Float32Array(3*n),zu=new Float32Array(n),Ss=0,qi.geometry.dispose(),qi.geometry=new Me,qi.geometry.setAttribute("position",new He(Yl,3)),qi.geometry.setAttribute("color",new He(new Float32Array(3*n),3)),qi.geometry.setDrawRange(0,0),qi.visible=!0,fe()}function Wx(n){let t=Gp(n);for(let e=0;e<t.length&&Ss<zu.length;e+=4,Ss++)Yl.set(t.subarray(e,e+3),3*Ss),zu[Ss]=t[e+3];WN()}function WN(){Object.assign(Gx,zp(zu.subarray(0,Ss)));let n=qi.geometry.attributes.color.array;for(let t=0;t<Ss;t++)Hp(zu[t],Gx).toArray(n,3*t);qi.geometry.setDrawRange(0,Ss),qi.geometry.attributes.position.needsUpdate=!0,qi.geometry.attributes.color.needsUpdate=!0,fe()}var jl=()=>Ss;function $N(n){ss.localClippingEnabled=n!==null,Hx.clippingPlanes=n===null?null:[new ri(new V(0,1,0),-n)],Hx.needsUpdate=!0,fe()}function qN(){let n=new zi;for(let i=0;i<Ss;i++)n.expandByPoint(new V(Yl[3*i],Yl[3*i+1],Yl[3*i+2]));let{min:t,max:e}=n;return Ss?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function XN(){Ss=0,qi.visible=!1,fe()}var $p={};b_($p,{begin:()=>Xx,clear:()=>jx,corners:()=>ZN,cutAt:()=>jN,range:()=>qx,size:()=>Do,take:()=>Yx});var YN=[[[1,0,0],[1,0,0,1,1,0,1,1,1,1,0,1],.86],[[-1,0,0],[0,1,0,0,0,0,0,0,1,0,1,1],.7],[[0,1,0],[1,1,0,0,1,0,0,1,1,1,1,1],.66],[[0,-1,0],[0,0,0,1,0,0,1,0,1,0,0,1],.92],[[0,0,1],[0,0,1,1,0,1,1,1,1,0,1,1],1],[[0,0,-1],[0,1,0,1,1,0,1,0,0,0,0,0],.5]],mr=new Ge(new Me,new Vn({vertexColors:!0,fog:!1}));mr.frustumCulled=!1;mr.visible=!1;en.add(mr);var cs=null,$x=null,qx={lo:0,hi:1};function Xx({low:n,shape:t,step:e}){cs={low:n,shape:t,step:e,values:new Map},Wp()}var j1=(n,t,e)=>(n*cs.shape[1]+t)*cs.shape[2]+e;function Yx(n){let t=Gp(n);for(let e=0;e<t.length;e+=4){let[i,s,r]=[0,1,2].map(o=>Math.floor((t[e+o]-cs.low[o])/cs.step));cs.values.set(j1(i,s,r),t[e+3])}Wp()}var Do=()=>cs?.values.size??0;function jN(n){$x=n,Wp()}function ZN(){if(!Do())return[];let n=cs.low.map((t,e)=>t+cs.shape[e]*cs.step);return[0,1,2,3,4,5,6,7].map(t=>[0,1,2].map(e=>t&1<<e?n[e]:cs.low[e]))}function jx(){cs=null,Wp()}function Wp(){if(mr.visible=Do()>0,mr.geometry.dispose(),mr.geometry=new Me,!mr.visible){fe();return}let{low:n,shape:t,step:e,values:i}=cs,s=[],r=[],o=[];Object.assign(qx,zp(i.values()));let a=(c,u,h)=>u>=0&&c>=0&&h>=0&&c<t[0]&&u<t[1]&&h<t[2]&&i.has(j1(c,u,h))&&l(u),l=c=>$x===null||n[1]+(c+.5)*e>=$x;for(let[c,u]of i){let h=c%t[2],d=Math.floor(c/t[2])%t[1],f=Math.floor(c/(t[1]*t[2]));if(!l(d))continue;let{r:p,g:_,b:m}=Hp(u,qx);for(let[[g,x,M],v,A]of YN){if(a(f+g,d+x,h+M))continue;let E=s.length/3;for(let y=0;y<12;y+=3)s.push(n[0]+(f+v[y])*e,n[1]+(d+v[y+1])*e,n[2]+(h+v[y+2])*e),r.push(p*A,_*A,m*A);o.push(E,E+1,E+2,E,E+2,E+3)}}mr.geometry.setAttribute("position",new be(s,3)),mr.geometry.setAttribute("color",new be(r,3)),mr.geometry.setIndex(o),fe()}var fa=n=>n.toLocaleString("en"),JN={coarse:12,middling:20,fine:32};function Z1(n){let t=2*Gn(b.table)/JN[n],e=10**Math.floor(Math.log10(t));return[1,2,2.5,5,10].map(i=>i*e).findLast(i=>i<=t*1.0001)}var Zl={cloud:{scene:Vp,colours:[["manipulability","manipulability"],["height","height of the tool",n=>re(n,"length")],["condition","inverse condition number"],["limits","distance to the limits"]],sizes:[["20000","20,000 points"],["5000","5,000 points"],["100000","100,000 points"]],begin:n=>Vx(Number(n)),asked:(n,t)=>({count:Number(n),colour:t,seed:1}),piece:n=>Wx(n.points),progress:n=>`${fa(n.done)} of ${fa(n.of)} points`,stopped:()=>`Cancelled after ${fa(jl())} points.`,ended:(n,t)=>`${fa(n.done)} random postures inside the limits, coloured by ${t}.`},voxels:{scene:$p,colours:[["fraction","share of orientations"],["count","number of solutions in all orientations",n=>fa(Math.round(n))],["manipulability","best manipulability"],["margin","distance to the limits"]],sizes:[["middling","middling voxels"],["coarse","coarse voxels"],["fine","fine voxels"]],begin:()=>jx(),asked:(n,t)=>({step:Z1(n),colour:t}),piece:n=>n.low?Xx(n):Yx(n.points),progress:n=>`${Math.round(100*n.done/n.of)} % solved`,stopped:()=>`Cancelled after ${fa(Do())} voxels.`,ended:(n,t,e)=>`${fa(n.reached)} voxels of ${re(Z1(e),"length",gt.length==="mm"?0:3)} are reached inside the limits in some of ${n.orientations} orientations, ${n.volume.toPrecision(3)} m\xB3 together; coloured by ${t}. Each is solved at its centre.`}};function J1(){let n="cloud",t=!1,e=!1,i=null,s={size:null,colour:null},r=Ut("",{class:"primary","data-testid":"reach-start"},()=>t?Fi("cancel",{kind:t}):M()),o=Ut("Clear",{},x),a=S("input",{type:"range",min:"-1",max:"1",step:"any",value:"0",hidden:!0,"aria-label":"Where it is cut","data-testid":"reach-cut-at",on:{input:u}}),l=!1,c=Be("Shown",[["whole","Whole"],["half","Cut open"]],"whole",E=>{l=E==="half",a.hidden=!l,u()},"reach-cut");function u(){let E=l?b.table.base[7]+Number(a.value)*Gn(b.table):null;a.style.setProperty("--at",`${50*(1+Number(a.value))}%`);for(let{scene:y}of Object.values(Zl))y.cutAt(E)}let h=S("progress",{max:"1","aria-label":"Progress","data-testid":"reach-progress",hidden:!0}),d=S("p",{class:"hint",role:"status","data-testid":"reach-note"}),f=S("span"),p=S("span"),_=S("div",{class:"legend-scale",hidden:!0},f,S("span",{class:"scale-bar"}),p),m=S("div",{class:"line"});function g(){if(!i)return;let{range:E}=Zl[i.kind].scene,y=Zl[i.kind].colours.find(([w])=>w===i.colour)[2]??ou;bt(f,`\u2264 ${y(E.lo)}`),bt(p,`\u2265 ${y(E.hi)}`)}tt("units",g),tt("online",E=>{E&&e&&bt(d,Rx),e=!1});function x(){i=null,e=!1;for(let{scene:E}of Object.values(Zl))E.clear();Hr("reach",[]),_.hidden=!0,bt(d,"")}async function M(){let E=Zl[n],{size:y,colour:w}=s,N=E.colours.find(([R])=>R===w)[1];x(),t=n,i={kind:n,colour:w},bt(r,"Cancel"),h.hidden=_.hidden=!1,h.value=0,E.begin(y);try{let R=await Oe(n,E.asked(y,w),L=>{E.piece(L),h.value=L.done/L.of,g(),bt(d,E.progress(L))});bt(d,R.stopped?E.stopped():E.ended(R,N,y))}catch(R){e=R instanceof Bo,bt(d,R.message)}t=!1,_.hidden=!E.scene.size(),Hr("reach",E.scene.corners()),mu(),v(),h.hidden=!0}let v=()=>t||bt(r,n==="cloud"?"Draw the cloud":"Draw the map");function A(){let{sizes:E,colours:y}=Zl[n];s.size=E[0][0],s.colour=y[0][0];let w=N=>R=>{s[N]=R};Gt(m,hn("How many",E,s.size,w("size"),{"data-testid":"reach-size"}),S("span",{class:"field-name",text:"coloured by"}),hn("Coloured by",y,s.colour,w("colour"),{"data-testid":"reach-colour"})),v()}return tt("table",E=>{E==="postures"||E==="name"||(t&&Fi("cancel",{kind:t}),(jl()||Do())&&x())}),A(),S("div",{},Be("Drawn as",[["cloud","Cloud"],["voxels","Map"]],n,E=>{n=E,A()},"reach-kind"),S("p",{class:"hint",text:"A cloud is of random postures. A map asks every voxel completely, which takes minutes for arms without a closed form or with joints to spare."}),m,S("div",{class:"line"},r,o,c,a),h,_,d)}var KN=()=>b.plan?.task==="position"?3:6,K1={id:"analysis",title:"Analysis",build(n){let t=S("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","\u221Adet(J J\u1D40) of the rows that the arm\u2019s task moves (J\u1D40J where joints are fewer); in metres and radians, as in the cloud and the map"],["condition","Condition number","the largest singular value over the smallest, lengths divided by the arm\u2019s; 1 is best"],["least","Smallest singular value","0 at a singularity; lengths divided by the arm\u2019s"]],i={};for(let[c,u,h]of e)t.append(S("div",{title:h},S("dt",{text:u}),i[c]=S("dd",{"data-testid":`fact-${c}`})));let s=S("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=S("p",{class:"hint","data-testid":"ellipsoid-axes"});tt("ellipsoid",()=>{let c=Bp();bt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>re(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,S("h3",{text:"At the tool\u2019s point"}),Be("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",$1,"ellipsoid"),o,S("h3",{text:"Distance to the limits"}),s,S("h3",{text:"Where the tool can be"}),J1());let a=()=>{r=b.table.joints.map((c,u)=>{let h=S("span",{class:"bar-fill"}),d=S("span",{class:"bar-text"});return{el:S("div",{class:"distance"},S("span",{},S("i",{text:"q"}),S("sub",{text:String(u+1)})),S("span",{class:"bar"},h),d),fill:h,text:d}}),Gt(s,r.map(c=>c.el)),l()},l=Qs(()=>{if(n.closest(".panel").hidden||!b.table.joints.length)return;let c=ac(b.table,b.q,b.frames),u=c[0],h=c[c.length-1];bt(i.manipulability,ou(ac(b.table,b.q,b.frames,1,KN()).reduce((d,f)=>d*f,1))),bt(i.condition,u>1e-9?ii(h/u,1):"\u221E"),bt(i.least,ou(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:p},_)=>{let m=b.table.joints[_],g=b.q[_];if(m.lower===null||m.upper===null){f.style.setProperty("width","100%"),bt(p,"no limit");return}let x=Math.min(g-m.lower,m.upper-g),M=Math.max(2*x/(m.upper-m.lower||1),0);f.style.setProperty("width",`${100*M}%`),d.classList.toggle("outside",x<-1e-9),bt(p,x<-1e-9?`${re(-x,Ze(m))} beyond`:re(x,Ze(m)))})});tt("table",a),tt(["q","units","panel","plan"],l),a()}};var QN=["panel","table","q","target","path","path-loaded","program","sequence","sequence-loaded","world","task","routing","units","notation","history"],Q1=n=>({id:"share",title:"Share",build(t,e){let i=S("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:p=>p.target.select()}}),s=S("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>f(s)}}),r=S("p",{class:"hint",role:"status","data-testid":"report-note"}),o=Ut("Write the report",{class:"primary","data-testid":"report"},d),a=S("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"}),l=[Ut("Copy the script",{"data-testid":"copy-python"},()=>eo(a.value)),Ut("Save the script",{"data-testid":"save-python"},()=>hi("workbench.py",a.value,"text/x-python"))];t.append(S("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),S("div",{class:"line share-link"},i,Ut("Copy the link",{"data-testid":"copy-link"},async()=>eo(await qf()))),S("h3",{text:"As a file"}),S("div",{class:"line"},Ut("Save the state",{"data-testid":"save-state"},()=>hi(`${b.table.name||"arm"}.workbench.json`,JSON.stringify(wl(),null,1),"application/json")),Ut("Open a state\u2026",{},()=>s.click()),s,Ut("Save the robot file",{"data-testid":"save-robot"},Tp)),S("h3",{text:"As Python"}),S("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,S("div",{class:"line"},...l),S("h3",{text:"Report"}),S("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),S("div",{class:"line"},o),r);let c=0,u=async()=>{c+=1,a.value="",a.placeholder="Being written \u2026";for(let p of l)p.disabled=!0;e.hidden||!b.table.joints.length||(h(),i.value=await qf())},h=Ks(async()=>{let p=c;try{let{q:_,target:m,hasTarget:g,path:x,program:M,world:v}=b,{task:A,redundancy:E}=pe,y={q:_,target:g?m:null,path:x,task:A,redundancy:E,world:v,program:Io()},{text:w}=await Oe("python",M.length?y:{...y,program:null});if(p!==c)return;a.value=w;for(let N of l)N.disabled=!1}catch(_){p===c&&(a.placeholder=_.message)}});tt(QN,()=>queueMicrotask(u)),tt("online",p=>p&&u());async function d(){let p=Sr(ls());if(p){bt(r,`${p} Nothing was written.`);return}o.disabled=!0;try{let _=x=>bt(r,x.note),{html:m,name:g}=await Oe("report",{q:b.q},_,{whichever:!0});hi(g,m,"text/html"),bt(r,`Written: ${g}, ${Math.round(m.length/1024)} kB.`)}catch(_){bt(r,_.message)}finally{o.disabled=!1}}async function f(p){let _=p.files[0];if(p.value="",!!_)try{if(_.size>5e5)throw new Error("A state file has at most 500 kB.");Su(JSON.parse(await _.text()),n(),"open a state"),he("Opened")}catch(m){he(m instanceof SyntaxError?`${_.name} is not a state file.`:m.message,"wrong")}}}});var tU=40,iE=!1,sE=0,Zx=!1,qp=null,tE=[],eE="null",nE=null;function rE(n){n&&(iE=!0,qp=b.table,oE(n),(b.program.length||b.world.length)&&aE.soon())}function oE(n){Zx=!0,sE=n.said,n.table&&(yn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),qp=b.table,kl(n.looks??null,n.table)),n.things&&eU(n.things),n.target&&(b.hasTarget=!0,wi(n.target,"restored")),n.q&&n.q.length===b.table.joints.length&&(ct("did",{label:"move from Python",key:"python"}),Oi(n.q,"python")),Zx=!1}function eU(n){b.things=n.filter(i=>i.kind!=="motion"),ct("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==nE){if(nE=e,!t){ci(null);return}ci(dr({table:b.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${b.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var aE=Ca(tU,()=>{if(!b.table.joints.length)return;let n=b.q,t=b.hasTarget?b.target:null,e=b.program.length?Io():null,i={},s=JSON.stringify(e);b.table!==qp&&(i.table=am(b.table)),b.world!==tE&&(i.world=b.world),s!==eE&&(i.program=e),[qp,tE,eE]=[b.table,b.world,s],Fi("shown",{q:n,target:t,said:sE,...i}).catch(()=>{})});function lE(){tt("push",oE),tt(["q","target","table","program","world"],()=>iE&&!Zx&&aE.soon())}var pa=new Rn,uE=new Vn({fog:!1}),Jx=new Vn({fog:!1}),Kx=new Hi(1,1,1),Qx=new Ge(Kx,uE),hE=[new Ge(Kx,Jx),new Ge(Kx,Jx)];pa.add(Qx,...hE);pa.matrixAutoUpdate=!1;pa.visible=!1;var Hu=null;function dE(){en.add(pa),tt("q",()=>Hu!==null&&pE()),tt("theme",cE),cE()}function cE(){uE.color.set(Ft.joint),Jx.color.set(Ft.accent)}function t_(n){n===null&&Hu===null||(Hu=n,pa.visible=n!==null,n!==null&&pE(),fe())}var fE=()=>Hu;function pE(){let n=b.frames.at(-1),t=.075*Gn(b.table);Qx.scale.set(.35*t,1.1*t,.25*t),Qx.position.set(0,0,-.85*t),hE.forEach((e,i)=>{let s=(.08+.36*(1-Hu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),pa.matrix.set(...n),pa.updateMatrixWorld(!0)}var sU=.25,e_=.5;function rU(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(b.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=lU(n,r);if(o>=e_&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:Ui(Ni(te(u.at(-1).T),te(a)))})).filter(({name:c,d:u})=>u<oU(b.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:Hn(Ta(a),l.T)}))}else o<e_&&s&&i&&(e.get(i).push({t:r,T:Hn(a,e.get(i).at(-1).held)}),i=null);s=o>=e_}return{grips:t,objects:e}}var oU=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function aU(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var lU=(n,t)=>As(n.table,n.q[aU(n.seconds,t)]).at(-1),No=null,cU=n=>{let t=No.grips.length?1-Math.round(No.grips[0].value):0;for(let e of No.grips){if(e.t>n)break;let i=Math.min((n-e.t)/sU,1);t+=i*(e.value-t)}return t};function mE(){tt("motion",()=>{U1(),No=b.motion?.happens?rU(b.motion):null,No||t_(null)}),tt("played",n=>{if(!No)return;let t=b.frames.at(-1);No.grips.length&&t_(cU(n));for(let[e,i]of No.objects){let s=i.findLast(r=>r.t<=n)??i[0];Fx(e,s.held?Hn(t,s.held):s.T)}})}function gE(){let n={said:()=>structuredClone(wl()),q:()=>b.q.slice(),frames:()=>structuredClone(b.frames),target:()=>b.target.slice(),table:()=>structuredClone(b.table),solutions:()=>structuredClone(b.solutions),camera:()=>fl(),pictures:()=>Zv(),ghosts:()=>tM(),ghostsOutside:()=>eM(),labels:()=>Yg(),history:()=>[Gf(),Vf()],beyond:()=>Jb(),things:()=>F1(),looks:()=>Uw(),program:()=>structuredClone(b.program),route:()=>structuredClone(b.route),motion:()=>structuredClone(b.motion),gripper:()=>fE(),stepFrame:()=>b.dhStep===null?null:bf().at(-1).T,clearance:()=>structuredClone(b.clearance),bodies:()=>z1(),ellipsoid:()=>structuredClone(Bp()),world:()=>structuredClone(b.world),framesDrawn:()=>Kb(),answers:()=>y0.answers,trace:()=>rM(),voxels:()=>Do(),cloud:()=>jl()},t={routePlace(e,i){let s={which:e,turn:i};return document.querySelector(".route-map").dispatchEvent(new CustomEvent("where",{detail:s})),s.at},placeOf:e=>N1(e)??b.world.find(i=>i.name===e)?.T??null,go:qr,toScreen:Vi,withPicture:e=>ul(e),handles:()=>Rb(),forward:(e,i)=>As(e,i),convert:(e,i)=>Mp(e,i),read:(e,i)=>Sl(e,i),block:e=>wu(e),present:(e,i,s)=>Ap(e,i,s)};for(let[e,i]of Object.entries(n))Object.defineProperty(t,e,{get:i,enumerable:!0});window.workbench=Object.freeze(t)}rf();fM();Kv(Rs("#view"));tt("theme",kg);kg();hM();fb(Rs("#overlay"));Xb();Eb();D1();Nw();G1();X1();dE();mE();lE();N_();lM();kw(Rs("#bar"));Hw(Rs("#overlay"));mw(Rs("#dock"));Gw();var Vu,Gu=(n,t,...e)=>[{...t,group:n},...e];Vu=zw(Rs("#rail"),Rs("#panels"),Rs("#pinned"),[...Gu("Drive",{id:"move",title:"Move",sections:[DM,Ww]},t1),...Gu("Describe",c1,V1),...Gu("Plan",f1,w1(()=>Vu),R1,W1),...Gu("Study",$w,h1,K1),...Gu("Hand on",Q1(()=>Vu))]);yw(Rs("#room"),Rs("#rail"));wM(Vu);var hU=bM().then(n=>n&&Su(n,Vu)).catch(n=>he(`The link could not be read: ${n.message}`,"wrong"));tt("online",async n=>{if(!n)return;await hU;let t=await C_();b.catalog=t.catalog,ct("catalog"),t.table&&(!b.table.joints.length||t.bench)&&(yn(t.table,{q:Aa(t.table),step:!1,what:"new"}),Wf()),t.looks&&kl(t.looks,t.table),rE(t.bench),document.documentElement.dataset.ready="yes"});b.online&&ct("online",!0);document.fonts?.ready.then(()=>ct("theme"));gE();
