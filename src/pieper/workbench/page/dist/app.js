import{A as Bo,B as Dn,C as Ec,D as Tc,E as Mg,F as wg,G as Ac,H as Cs,I as Eg,J as Rc,L as Zs,M as ed,a as $s,b as Zr,c as xg,d as $e,e as Kf,f as Qf,g as is,h as xc,i as yc,j as As,k as vc,l as bc,m as yg,n as $a,o as vg,p as vr,q as td,r as Sc,s as Mc,t as bg,u as Sg,v as Pt,w as oe,x as O,y as Rs,z as wc}from"./chunk-LLBWXIPN.js";function A(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var br=(n,t=document)=>t.querySelector(n),ne=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function zt(n,t){n.textContent!==t&&(n.textContent=t)}function Xn(n,t,e,i,s){let r=A("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(A("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function fi(n,t,e,i,s={}){let r=A("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>A("option",{value:o,text:a})));return r.value=e,r}function Sr(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Cc(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Mr(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function Js(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=A("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Jr(n){try{await navigator.clipboard.writeText(n)}catch{let t=A("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}ti("Copied")}var Tg;function ti(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(Tg),Tg=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}var be={},gb=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel"],_b={light:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"],dark:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},Ag=matchMedia("(prefers-color-scheme: dark)");function Pc(){let n=O.theme==="dark"||O.theme==="auto"&&Ag.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of gb)be[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();be.dark=n,be.curves=_b[n?"dark":"light"]}function Ic(n){O.theme=n,Pc(),oe("theme")}Ag.addEventListener("change",()=>{O.theme==="auto"&&(Pc(),oe("theme"))});var zo=0,sd=-1,nd=[];function xb(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function id(){let n=zo;if(!O.table.joints.length){O.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},oe("plan");return}try{let{plan:t}=await Zs("arm",{table:xb(O.table)});if(n!==zo)return;sd=n,O.plan=t,Rg()}catch(t){if(n!==zo||t instanceof Rc)return;O.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},Rg(t)}oe("plan")}function Rg(n){let t=nd;nd=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var Cg=Mr(id,60);function Pg(){Pt("table",n=>{zo+=1,n==="postures"&&(sd=-1),n==="cell"?Cg():(Cg.cancel(),id())}),Pt("online",n=>{n&&(zo+=1,id())})}function yb(){return sd===zo?Promise.resolve():new Promise((n,t)=>nd.push({resolve:n,reject:t}))}async function ei(n,t,e){return await yb(),Zs(n,t,e)}function Ig(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Lc(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var Dr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Nr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},d0=0,Nd=1,p0=2;var Ll=1,m0=2,ga=3,Ur=0,yi=1,Mi=2,ao=0,_a=1,Ud=2,Fd=3,Od=4,g0=5;var lo=100,_0=101,x0=102,y0=103,v0=104,b0=200,S0=201,M0=202,w0=203,Bd=204,zd=205,E0=206,T0=207,A0=208,R0=209,C0=210,P0=211,I0=212,L0=213,D0=214,ch=0,hh=1,uh=2,ra=3,fh=4,dh=5,ph=6,mh=7,kd=0,N0=1,U0=2,Fs=0,Hd=1,Gd=2,Vd=3,Wd=4,Xd=5,qd=6,Yd=7;var $d=300,co=301,xa=302,Hh=303,Gh=304,gh=1e3,Is=1001,_h=1002,Yn=1003,F0=1004;var Dl=1005;var gi=1006,Vh=1007;var lr=1008;var zi=1009,Zd=1010,Jd=1011,ya=1012,Wh=1013,us=1014,Zi=1015,fs=1016,Xh=1017,qh=1018,ho=1020,jd=35902,Kd=35899,Qd=1021,tp=1022,ds=1023,sr=1026,cr=1027,Yh=1028,$h=1029,Fr=1030,Zh=1031;var Jh=1033,Nl=33776,Ul=33777,Fl=33778,Ol=33779,jh=35840,Kh=35841,Qh=35842,tu=35843,eu=36196,nu=37492,iu=37496,su=37488,ru=37489,Bl=37490,ou=37491,au=37808,lu=37809,cu=37810,hu=37811,uu=37812,fu=37813,du=37814,pu=37815,mu=37816,gu=37817,_u=37818,xu=37819,yu=37820,vu=37821,bu=36492,Su=36494,Mu=36495,wu=36283,Eu=36284,zl=36285,Tu=36286;var ll=2300,xh=2301,ah=2302,Td=2303,Ad=2400,Rd=2401,Cd=2402;var O0=3200;var ep=0,B0=1,hr="",pi="srgb",cl="srgb-linear",hl="linear",Ue="srgb";var lh=7680,np=7681;var ip=517;var z0=519,k0=512,H0=513,G0=514,sp=515,V0=516,W0=517,rp=518,op=519,ap=35044,Au=35048;var lp="300 es",Yi=2e3,ul=2001;function bb(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Sb(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function fl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function X0(){let n=fl("canvas");return n.style.display="block",n}var Lg={},oa=null;function dl(...n){let t="THREE."+n.shift();oa?oa("log",t,...n):console.log(t,...n)}function q0(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Kt(...n){n=q0(n);let t="THREE."+n.shift();if(oa)oa("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ie(...n){n=q0(n);let t="THREE."+n.shift();if(oa)oa("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function rl(...n){let t=n.join(" ");t in Lg||(Lg[t]=!0,Kt(...n))}function Y0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var $0={[ch]:ch,[uh]:ph,[fh]:fh,[ra]:dh,[hh]:hh,[ph]:uh,[mh]:mh,[dh]:ra},ls=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ni=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Dg=1234567,ol=Math.PI/180,aa=180/Math.PI;function Or(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ni[n&255]+ni[n>>8&255]+ni[n>>16&255]+ni[n>>24&255]+"-"+ni[t&255]+ni[t>>8&255]+"-"+ni[t>>16&15|64]+ni[t>>24&255]+"-"+ni[e&63|128]+ni[e>>8&255]+"-"+ni[e>>16&255]+ni[e>>24&255]+ni[i&255]+ni[i>>8&255]+ni[i>>16&255]+ni[i>>24&255]).toLowerCase()}function xe(n,t,e){return Math.max(t,Math.min(e,n))}function cp(n,t){return(n%t+t)%t}function Mb(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function wb(n,t,e){return n!==t?(e-n)/(t-n):0}function al(n,t,e){return(1-e)*n+e*t}function Eb(n,t,e,i){return al(n,t,1-Math.exp(-e*i))}function Tb(n,t=1){return t-Math.abs(cp(n,t*2)-t)}function Ab(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Rb(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Cb(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Pb(n,t){return n+Math.random()*(t-n)}function Ib(n){return n*(.5-Math.random())}function Lb(n){n!==void 0&&(Dg=n);let t=Dg+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Db(n){return n*ol}function Nb(n){return n*aa}function Ub(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Fb(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function hp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ob(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),f=o((t-i)/2),d=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*f,a*c);break;case"YZY":n.set(l*f,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*f,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*d,a*c);break;case"YXY":n.set(l*d,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*d,a*h,a*c);break;default:Kt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ru(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function up(n,t){if(t.constructor===Float32Array)return n;let e=Ru(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function fp(n,t){if(t.constructor===Float32Array)return n;let e=Ru(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var va={DEG2RAD:ol,RAD2DEG:aa,generateUUID:Or,clamp:xe,euclideanModulo:cp,mapLinear:Mb,inverseLerp:wb,lerp:al,damp:Eb,pingpong:Tb,smoothstep:Ab,smootherstep:Rb,randInt:Cb,randFloat:Pb,randFloatSpread:Ib,seededRandom:Lb,degToRad:Db,radToDeg:Nb,isPowerOfTwo:Ub,ceilPowerOfTwo:Fb,floorPowerOfTwo:hp,setQuaternionFromProperEuler:Ob,normalize:fp,denormalize:up},qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ze=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],f=r[o+0],d=r[o+1],g=r[o+2],x=r[o+3];if(u!==x||l!==f||c!==d||h!==g){let p=l*f+c*d+h*g+u*x;p<0&&(f=-f,d=-d,g=-g,x=-x,p=-p);let m=1-a;if(p<.9995){let _=Math.acos(p),w=Math.sin(_);m=Math.sin(m*_)/w,a=Math.sin(a*_)/w,l=l*m+f*a,c=c*m+d*a,h=h*m+g*a,u=u*m+x*a}else{l=l*m+f*a,c=c*m+d*a,h=h*m+g*a,u=u*m+x*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*u+l*d-c*f,t[e+1]=l*g+h*f+c*u-a*d,t[e+2]=c*g+h*d+a*f-l*u,t[e+3]=h*g-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"YXZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"ZXY":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"ZYX":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"YZX":this._x=f*h*u+c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u-f*d*g;break;case"XZY":this._x=f*h*u-c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u+f*d*g;break;default:Kt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=i+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>u){let d=2*Math.sqrt(1+i-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-i-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Ng.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Ng.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return rd.copy(this).projectOnVector(t),this.sub(rd)}reflect(t){return this.sub(rd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},rd=new B,Ng=new Ze,le=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],d=i[5],g=i[8],x=s[0],p=s[3],m=s[6],_=s[1],w=s[4],b=s[7],C=s[2],S=s[5],y=s[8];return r[0]=o*x+a*_+l*C,r[3]=o*p+a*w+l*S,r[6]=o*m+a*b+l*y,r[1]=c*x+h*_+u*C,r[4]=c*p+h*w+u*S,r[7]=c*m+h*b+u*y,r[2]=f*x+d*_+g*C,r[5]=f*p+d*w+g*S,r[8]=f*m+d*b+g*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,g=e*u+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=u*x,t[1]=(s*c-h*i)*x,t[2]=(a*i-s*o)*x,t[3]=f*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=d*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return rl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(od.makeScale(t,e)),this}rotate(t){return rl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(od.makeRotation(-t)),this}translate(t,e){return rl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(od.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},od=new le,Ug=new le().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fg=new le().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Bb(){let n={enabled:!0,workingColorSpace:cl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ue&&(s.r=ir(s.r),s.g=ir(s.g),s.b=ir(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ue&&(s.r=sa(s.r),s.g=sa(s.g),s.b=sa(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===hr?hl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[cl]:{primaries:t,whitePoint:i,transfer:hl,toXYZ:Ug,fromXYZ:Fg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:pi},outputColorSpaceConfig:{drawingBufferColorSpace:pi}},[pi]:{primaries:t,whitePoint:i,transfer:Ue,toXYZ:Ug,fromXYZ:Fg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:pi}}}),n}var Ee=Bb();function ir(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function sa(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ko,yh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ko===void 0&&(ko=fl("canvas")),ko.width=t.width,ko.height=t.height;let s=ko.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=ko}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=fl("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ir(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ir(e[i]/255)*255):e[i]=ir(e[i]);return{data:e,width:t.width,height:t.height}}else return Kt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},zb=0,la=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:zb++}),this.uuid=Or(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ad(s[o].image)):r.push(ad(s[o]))}else r=ad(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ad(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?yh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Kt("Texture: Unable to serialize Texture."),{})}var kb=0,ld=new B,_i=class n extends ls{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Is,s=Is,r=gi,o=lr,a=ds,l=zi,c=n.DEFAULT_ANISOTROPY,h=hr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:kb++}),this.uuid=Or(),this.name="",this.source=new la(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new qt(0,0),this.repeat=new qt(1,1),this.center=new qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new le,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ld).x}get height(){return this.source.getSize(ld).y}get depth(){return this.source.getSize(ld).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Kt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==$d)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case gh:t.x=t.x-Math.floor(t.x);break;case Is:t.x=t.x<0?0:1;break;case _h:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case gh:t.y=t.y-Math.floor(t.y);break;case Is:t.y=t.y<0?0:1;break;case _h:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};_i.DEFAULT_IMAGE=null;_i.DEFAULT_MAPPING=$d;_i.DEFAULT_ANISOTROPY=1;var fn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],g=l[9],x=l[2],p=l[6],m=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(g+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(d+1)/2,C=(m+1)/2,S=(h+f)/4,y=(u+x)/4,M=(g+p)/4;return w>b&&w>C?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=S/i,r=y/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=S/s,r=M/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=y/r,s=M/r),this.set(i,s,r,e),this}let _=Math.sqrt((p-g)*(p-g)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(_)<.001&&(_=1),this.x=(p-g)/_,this.y=(u-x)/_,this.z=(f-h)/_,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},vh=class extends ls{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:gi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new fn(0,0,t,e),this.scissorTest=!1,this.viewport=new fn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new _i({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:gi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new la(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Oi=class extends vh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},pl=class extends _i{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Yn,this.minFilter=Yn,this.wrapR=Is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var bh=class extends _i{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Yn,this.minFilter=Yn,this.wrapR=Is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Me=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,u,f,d,g,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,f,d,g,x,p)}set(t,e,i,s,r,o,a,l,c,h,u,f,d,g,x,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=f,m[3]=d,m[7]=g,m[11]=x,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Ho.setFromMatrixColumn(t,0).length(),r=1/Ho.setFromMatrixColumn(t,1).length(),o=1/Ho.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,g=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+g*c,e[5]=f-x*c,e[9]=-a*l,e[2]=x-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,g=c*h,x=c*u;e[0]=f+x*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=x+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,g=c*h,x=c*u;e[0]=f-x*a,e[4]=-o*u,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=x-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,g=a*h,x=a*u;e[0]=l*h,e[4]=g*c-d,e[8]=f*c+x,e[1]=l*u,e[5]=x*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=x-f*u,e[8]=g*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+g,e[10]=f-x*u}else if(t.order==="XZY"){let f=o*l,d=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+x,e[5]=o*h,e[9]=d*u-g,e[2]=g*u-d,e[6]=a*h,e[10]=x*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Hb,t,Gb)}lookAt(t,e,i){let s=this.elements;return Ni.subVectors(t,e),Ni.lengthSq()===0&&(Ni.z=1),Ni.normalize(),wr.crossVectors(i,Ni),wr.lengthSq()===0&&(Math.abs(i.z)===1?Ni.x+=1e-4:Ni.z+=1e-4,Ni.normalize(),wr.crossVectors(i,Ni)),wr.normalize(),Dc.crossVectors(Ni,wr),s[0]=wr.x,s[4]=Dc.x,s[8]=Ni.x,s[1]=wr.y,s[5]=Dc.y,s[9]=Ni.y,s[2]=wr.z,s[6]=Dc.z,s[10]=Ni.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],d=i[13],g=i[2],x=i[6],p=i[10],m=i[14],_=i[3],w=i[7],b=i[11],C=i[15],S=s[0],y=s[4],M=s[8],U=s[12],I=s[1],D=s[5],z=s[9],X=s[13],N=s[2],V=s[6],Z=s[10],W=s[14],ct=s[3],$=s[7],tt=s[11],st=s[15];return r[0]=o*S+a*I+l*N+c*ct,r[4]=o*y+a*D+l*V+c*$,r[8]=o*M+a*z+l*Z+c*tt,r[12]=o*U+a*X+l*W+c*st,r[1]=h*S+u*I+f*N+d*ct,r[5]=h*y+u*D+f*V+d*$,r[9]=h*M+u*z+f*Z+d*tt,r[13]=h*U+u*X+f*W+d*st,r[2]=g*S+x*I+p*N+m*ct,r[6]=g*y+x*D+p*V+m*$,r[10]=g*M+x*z+p*Z+m*tt,r[14]=g*U+x*X+p*W+m*st,r[3]=_*S+w*I+b*N+C*ct,r[7]=_*y+w*D+b*V+C*$,r[11]=_*M+w*z+b*Z+C*tt,r[15]=_*U+w*X+b*W+C*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],g=t[3],x=t[7],p=t[11],m=t[15],_=l*d-c*f,w=a*d-c*u,b=a*f-l*u,C=o*d-c*h,S=o*f-l*h,y=o*u-a*h;return e*(x*_-p*w+m*b)-i*(g*_-p*C+m*S)+s*(g*w-x*C+m*y)-r*(g*b-x*S+p*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],g=t[12],x=t[13],p=t[14],m=t[15],_=e*a-i*o,w=e*l-s*o,b=e*c-r*o,C=i*l-s*a,S=i*c-r*a,y=s*c-r*l,M=h*x-u*g,U=h*p-f*g,I=h*m-d*g,D=u*p-f*x,z=u*m-d*x,X=f*m-d*p,N=_*X-w*z+b*D+C*I-S*U+y*M;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return t[0]=(a*X-l*z+c*D)*V,t[1]=(s*z-i*X-r*D)*V,t[2]=(x*y-p*S+m*C)*V,t[3]=(f*S-u*y-d*C)*V,t[4]=(l*I-o*X-c*U)*V,t[5]=(e*X-s*I+r*U)*V,t[6]=(p*b-g*y-m*w)*V,t[7]=(h*y-f*b+d*w)*V,t[8]=(o*z-a*I+c*M)*V,t[9]=(i*I-e*z-r*M)*V,t[10]=(g*S-x*b+m*_)*V,t[11]=(u*b-h*S-d*_)*V,t[12]=(a*U-o*D-l*M)*V,t[13]=(e*D-i*U+s*M)*V,t[14]=(x*w-g*C-p*_)*V,t[15]=(h*C-u*w+f*_)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,g=r*u,x=o*h,p=o*u,m=a*u,_=l*c,w=l*h,b=l*u,C=i.x,S=i.y,y=i.z;return s[0]=(1-(x+m))*C,s[1]=(d+b)*C,s[2]=(g-w)*C,s[3]=0,s[4]=(d-b)*S,s[5]=(1-(f+m))*S,s[6]=(p+_)*S,s[7]=0,s[8]=(g+w)*y,s[9]=(p-_)*y,s[10]=(1-(f+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Ho.set(s[0],s[1],s[2]).length(),a=Ho.set(s[4],s[5],s[6]).length(),l=Ho.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ss.copy(this);let c=1/o,h=1/a,u=1/l;return ss.elements[0]*=c,ss.elements[1]*=c,ss.elements[2]*=c,ss.elements[4]*=h,ss.elements[5]*=h,ss.elements[6]*=h,ss.elements[8]*=u,ss.elements[9]*=u,ss.elements[10]*=u,e.setFromRotationMatrix(ss),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Yi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),f=(e+t)/(e-t),d=(i+s)/(i-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Yi)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ul)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Yi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),f=-(e+t)/(e-t),d=-(i+s)/(i-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Yi)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===ul)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Ho=new B,ss=new Me,Hb=new B(0,0,0),Gb=new B(1,1,1),wr=new B,Dc=new B,Ni=new B,Og=new Me,Bg=new Ze,Ls=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Kt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Og.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Og,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Bg.setFromEuler(this),this.setFromQuaternion(Bg,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ls.DEFAULT_ORDER="XYZ";var ca=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Vb=0,zg=new B,Go=new Ze,js=new Me,Nc=new B,Za=new B,Wb=new B,Xb=new Ze,kg=new B(1,0,0),Hg=new B(0,1,0),Gg=new B(0,0,1),Vg={type:"added"},qb={type:"removed"},Vo={type:"childadded",child:null},cd={type:"childremoved",child:null},Sn=class n extends ls{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Vb++}),this.uuid=Or(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new B,e=new Ls,i=new Ze,s=new B(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Me},normalMatrix:{value:new le}}),this.matrix=new Me,this.matrixWorld=new Me,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ca,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Go.setFromAxisAngle(t,e),this.quaternion.multiply(Go),this}rotateOnWorldAxis(t,e){return Go.setFromAxisAngle(t,e),this.quaternion.premultiply(Go),this}rotateX(t){return this.rotateOnAxis(kg,t)}rotateY(t){return this.rotateOnAxis(Hg,t)}rotateZ(t){return this.rotateOnAxis(Gg,t)}translateOnAxis(t,e){return zg.copy(t).applyQuaternion(this.quaternion),this.position.add(zg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(kg,t)}translateY(t){return this.translateOnAxis(Hg,t)}translateZ(t){return this.translateOnAxis(Gg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(js.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Nc.copy(t):Nc.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Za.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?js.lookAt(Za,Nc,this.up):js.lookAt(Nc,Za,this.up),this.quaternion.setFromRotationMatrix(js),s&&(js.extractRotation(s.matrixWorld),Go.setFromRotationMatrix(js),this.quaternion.premultiply(Go.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Vg),Vo.child=t,this.dispatchEvent(Vo),Vo.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(qb),cd.child=t,this.dispatchEvent(cd),cd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),js.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),js.multiply(t.parent.matrixWorld)),t.applyMatrix4(js),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Vg),Vo.child=t,this.dispatchEvent(Vo),Vo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Za,t,Wb),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Za,Xb,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Sn.DEFAULT_UP=new B(0,1,0);Sn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var as=class extends Sn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Yb={type:"move"},ha=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new as,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new as,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new as,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let p=e.getJointPose(x,i),m=this._getHandJoint(c,x);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Yb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new as;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Z0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Er={h:0,s:0,l:0},Uc={h:0,s:0,l:0};function hd(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Qt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=pi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ee.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ee.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ee.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ee.workingColorSpace){if(t=cp(t,1),e=xe(e,0,1),i=xe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=hd(o,r,t+1/3),this.g=hd(o,r,t),this.b=hd(o,r,t-1/3)}return Ee.colorSpaceToWorking(this,s),this}setStyle(t,e=pi){function i(r){r!==void 0&&parseFloat(r)<1&&Kt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Kt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Kt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=pi){let i=Z0[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Kt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ir(t.r),this.g=ir(t.g),this.b=ir(t.b),this}copyLinearToSRGB(t){return this.r=sa(t.r),this.g=sa(t.g),this.b=sa(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=pi){return Ee.workingToColorSpace(ii.copy(this),t),Math.round(xe(ii.r*255,0,255))*65536+Math.round(xe(ii.g*255,0,255))*256+Math.round(xe(ii.b*255,0,255))}getHexString(t=pi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ee.workingColorSpace){Ee.workingToColorSpace(ii.copy(this),e);let i=ii.r,s=ii.g,r=ii.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Ee.workingColorSpace){return Ee.workingToColorSpace(ii.copy(this),e),t.r=ii.r,t.g=ii.g,t.b=ii.b,t}getStyle(t=pi){Ee.workingToColorSpace(ii.copy(this),t);let e=ii.r,i=ii.g,s=ii.b;return t!==pi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Er),this.setHSL(Er.h+t,Er.s+e,Er.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Er),t.getHSL(Uc);let i=al(Er.h,Uc.h,e),s=al(Er.s,Uc.s,e),r=al(Er.l,Uc.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ii=new Qt;Qt.NAMES=Z0;var ml=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new Qt(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},gl=class extends Sn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ls,this.environmentIntensity=1,this.environmentRotation=new Ls,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},rs=new B,Ks=new B,ud=new B,Qs=new B,Wo=new B,Xo=new B,Wg=new B,fd=new B,dd=new B,pd=new B,md=new fn,gd=new fn,_d=new fn,nr=class n{constructor(t=new B,e=new B,i=new B){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),rs.subVectors(t,e),s.cross(rs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){rs.subVectors(s,e),Ks.subVectors(i,e),ud.subVectors(t,e);let o=rs.dot(rs),a=rs.dot(Ks),l=rs.dot(ud),c=Ks.dot(Ks),h=Ks.dot(ud),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Qs)===null?!1:Qs.x>=0&&Qs.y>=0&&Qs.x+Qs.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Qs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Qs.x),l.addScaledVector(o,Qs.y),l.addScaledVector(a,Qs.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return md.setScalar(0),gd.setScalar(0),_d.setScalar(0),md.fromBufferAttribute(t,e),gd.fromBufferAttribute(t,i),_d.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(md,r.x),o.addScaledVector(gd,r.y),o.addScaledVector(_d,r.z),o}static isFrontFacing(t,e,i,s){return rs.subVectors(i,e),Ks.subVectors(t,e),rs.cross(Ks).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return rs.subVectors(this.c,this.b),Ks.subVectors(this.a,this.b),rs.cross(Ks).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Wo.subVectors(s,i),Xo.subVectors(r,i),fd.subVectors(t,i);let l=Wo.dot(fd),c=Xo.dot(fd);if(l<=0&&c<=0)return e.copy(i);dd.subVectors(t,s);let h=Wo.dot(dd),u=Xo.dot(dd);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(Wo,o);pd.subVectors(t,r);let d=Wo.dot(pd),g=Xo.dot(pd);if(g>=0&&d<=g)return e.copy(r);let x=d*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Xo,a);let p=h*g-d*u;if(p<=0&&u-h>=0&&d-g>=0)return Wg.subVectors(r,s),a=(u-h)/(u-h+(d-g)),e.copy(s).addScaledVector(Wg,a);let m=1/(p+x+f);return o=x*m,a=f*m,e.copy(i).addScaledVector(Wo,o).addScaledVector(Xo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Si=class{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(os.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(os.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=os.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,os):os.fromBufferAttribute(r,o),os.applyMatrix4(t.matrixWorld),this.expandByPoint(os);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Fc.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Fc.copy(i.boundingBox)),Fc.applyMatrix4(t.matrixWorld),this.union(Fc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,os),os.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ja),Oc.subVectors(this.max,Ja),qo.subVectors(t.a,Ja),Yo.subVectors(t.b,Ja),$o.subVectors(t.c,Ja),Tr.subVectors(Yo,qo),Ar.subVectors($o,Yo),jr.subVectors(qo,$o);let e=[0,-Tr.z,Tr.y,0,-Ar.z,Ar.y,0,-jr.z,jr.y,Tr.z,0,-Tr.x,Ar.z,0,-Ar.x,jr.z,0,-jr.x,-Tr.y,Tr.x,0,-Ar.y,Ar.x,0,-jr.y,jr.x,0];return!xd(e,qo,Yo,$o,Oc)||(e=[1,0,0,0,1,0,0,0,1],!xd(e,qo,Yo,$o,Oc))?!1:(Bc.crossVectors(Tr,Ar),e=[Bc.x,Bc.y,Bc.z],xd(e,qo,Yo,$o,Oc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,os).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(os).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(tr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),tr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),tr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),tr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),tr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),tr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),tr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),tr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(tr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},tr=[new B,new B,new B,new B,new B,new B,new B,new B],os=new B,Fc=new Si,qo=new B,Yo=new B,$o=new B,Tr=new B,Ar=new B,jr=new B,Ja=new B,Oc=new B,Bc=new B,Kr=new B;function xd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Kr.fromArray(n,r);let a=s.x*Math.abs(Kr.x)+s.y*Math.abs(Kr.y)+s.z*Math.abs(Kr.z),l=t.dot(Kr),c=e.dot(Kr),h=i.dot(Kr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Cn=new B,zc=new qt,$b=0,en=class extends ls{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$b++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=ap,this.updateRanges=[],this.gpuType=Zi,this.version=0,this._normalizationScale=t!==void 0?Ru(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)zc.fromBufferAttribute(this,e),zc.applyMatrix3(t),this.setXY(e,zc.x,zc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.applyMatrix3(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.applyMatrix4(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.applyNormalMatrix(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Cn.fromBufferAttribute(this,e),Cn.transformDirection(t),this.setXYZ(e,Cn.x,Cn.y,Cn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):up(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):fp(t,this.array)}};var _l=class extends en{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var xl=class extends en{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Te=class extends en{constructor(t,e,i){super(new Float32Array(t),e,i)}},Zb=new Si,ja=new B,yd=new B,Ds=class{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Zb.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ja.subVectors(t,this.center);let e=ja.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ja,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(yd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ja.copy(t.center).add(yd)),this.expandByPoint(ja.copy(t.center).sub(yd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Jb=0,qi=new Me,vd=new Sn,Zo=new B,Ui=new Si,Ka=new Si,qn=new B,Ce=class n extends ls{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Jb++}),this.uuid=Or(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(bb(t)?xl:_l)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new le().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return qi.makeRotationFromQuaternion(t),this.applyMatrix4(qi),this}rotateX(t){return qi.makeRotationX(t),this.applyMatrix4(qi),this}rotateY(t){return qi.makeRotationY(t),this.applyMatrix4(qi),this}rotateZ(t){return qi.makeRotationZ(t),this.applyMatrix4(qi),this}translate(t,e,i){return qi.makeTranslation(t,e,i),this.applyMatrix4(qi),this}scale(t,e,i){return qi.makeScale(t,e,i),this.applyMatrix4(qi),this}lookAt(t){return vd.lookAt(t),vd.updateMatrix(),this.applyMatrix4(vd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Zo).negate(),this.translate(Zo.x,Zo.y,Zo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Te(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Kt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Si);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ui.setFromBufferAttribute(r),this.morphTargetsRelative?(qn.addVectors(this.boundingBox.min,Ui.min),this.boundingBox.expandByPoint(qn),qn.addVectors(this.boundingBox.max,Ui.max),this.boundingBox.expandByPoint(qn)):(this.boundingBox.expandByPoint(Ui.min),this.boundingBox.expandByPoint(Ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ds);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){let i=this.boundingSphere.center;if(Ui.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ka.setFromBufferAttribute(a),this.morphTargetsRelative?(qn.addVectors(Ui.min,Ka.min),Ui.expandByPoint(qn),qn.addVectors(Ui.max,Ka.max),Ui.expandByPoint(qn)):(Ui.expandByPoint(Ka.min),Ui.expandByPoint(Ka.max))}Ui.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)qn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(qn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)qn.fromBufferAttribute(a,c),l&&(Zo.fromBufferAttribute(t,c),qn.add(Zo)),s=Math.max(s,i.distanceToSquared(qn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new en(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new B,l[U]=new B;let h=new B,u=new B,f=new B,d=new qt,g=new qt,x=new qt,p=new B,m=new B;function _(U,I,D){c[U]=c[I]=c[D]=1,h.fromBufferAttribute(i,U),u.fromBufferAttribute(i,I),f.fromBufferAttribute(i,D),d.fromBufferAttribute(r,U),g.fromBufferAttribute(r,I),x.fromBufferAttribute(r,D),u.sub(h),f.sub(h),g.sub(d),x.sub(d);let z=1/(g.x*x.y-x.x*g.y);isFinite(z)&&(p.copy(u).multiplyScalar(x.y).addScaledVector(f,-g.y).multiplyScalar(z),m.copy(f).multiplyScalar(g.x).addScaledVector(u,-x.x).multiplyScalar(z),a[U].add(p),a[I].add(p),a[D].add(p),l[U].add(m),l[I].add(m),l[D].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let U=0,I=w.length;U<I;++U){let D=w[U],z=D.start,X=D.count;for(let N=z,V=z+X;N<V;N+=3)_(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let b=new B,C=new B,S=new B,y=new B;function M(U){S.fromBufferAttribute(s,U),y.copy(S);let I=a[U];b.copy(I),b.sub(S.multiplyScalar(S.dot(I))).normalize(),C.crossVectors(y,I);let z=C.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,z)}for(let U=0,I=i.count;U<I;++U)c[U]&&M(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new en(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,h=new B,u=new B;if(t)for(let f=0,d=t.count;f<d;f+=3){let g=t.getX(f+0),x=t.getX(f+1),p=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,p),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)qn.fromBufferAttribute(t,e),qn.normalize(),t.setXYZ(e,qn.x,qn.y,qn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,g=0;for(let x=0,p=l.length;x<p;x++){a.isInterleavedBufferAttribute?d=l[x]*a.data.stride+a.offset:d=l[x]*h;for(let m=0;m<h;m++)f[g++]=c[d++]}return new en(f,h,u)}if(this.index===null)return Kt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},yl=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=ap,this.updateRanges=[],this.version=0,this.uuid=Or()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Xg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Xg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Xg(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Or()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var di=new B,ua=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Ru(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)di.fromBufferAttribute(this,e),di.applyMatrix4(t),this.setXYZ(e,di.x,di.y,di.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)di.fromBufferAttribute(this,e),di.applyNormalMatrix(t),this.setXYZ(e,di.x,di.y,di.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)di.fromBufferAttribute(this,e),di.transformDirection(t),this.setXYZ(e,di.x,di.y,di.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){dl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new en(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){dl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):up(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):fp(t,this.data.array)}},bd=new B,jb=new B,Kb=new le,Fi=class{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=bd.subVectors(i,e).cross(jb.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(bd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Kb.getNormalMatrix(t),s=this.coplanarPoint(bd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Qb=0,Ns=class extends ls{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Qb++}),this.uuid=Or(),this.name="",this.type="Material",this.blending=_a,this.side=Ur,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bd,this.blendDst=zd,this.blendEquation=lo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qt(0,0,0),this.blendAlpha=0,this.depthFunc=ra,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=z0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=lh,this.stencilZFail=lh,this.stencilZPass=lh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Kt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Fi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},fa=class extends Ns{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Qt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Jo,Qa=new B,jo=new B,Ko=new B,Qo=new qt,tl=new qt,J0=new Me,kc=new B,el=new B,Hc=new B,qg=new qt,Sd=new qt,Yg=new qt,vl=class extends Sn{constructor(t=new fa){if(super(),this.isSprite=!0,this.type="Sprite",Jo===void 0){Jo=new Ce;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new yl(e,5);Jo.setIndex([0,1,2,0,2,3]),Jo.setAttribute("position",new ua(i,3,0,!1)),Jo.setAttribute("uv",new ua(i,2,3,!1))}this.geometry=Jo,this.material=t,this.center=new qt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ie('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),jo.setFromMatrixScale(this.matrixWorld),J0.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Ko.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&jo.multiplyScalar(-Ko.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Gc(kc.set(-.5,-.5,0),Ko,o,jo,s,r),Gc(el.set(.5,-.5,0),Ko,o,jo,s,r),Gc(Hc.set(.5,.5,0),Ko,o,jo,s,r),qg.set(0,0),Sd.set(1,0),Yg.set(1,1);let a=t.ray.intersectTriangle(kc,el,Hc,!1,Qa);if(a===null&&(Gc(el.set(-.5,.5,0),Ko,o,jo,s,r),Sd.set(0,1),a=t.ray.intersectTriangle(kc,Hc,el,!1,Qa),a===null))return;let l=t.ray.origin.distanceTo(Qa);l<t.near||l>t.far||e.push({distance:l,point:Qa.clone(),uv:nr.getInterpolation(Qa,kc,el,Hc,qg,Sd,Yg,new qt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Gc(n,t,e,i,s,r){Qo.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(tl.x=r*Qo.x-s*Qo.y,tl.y=s*Qo.x+r*Qo.y):tl.copy(Qo),n.copy(t),n.x+=tl.x,n.y+=tl.y,n.applyMatrix4(J0)}var er=new B,Md=new B,Vc=new B,Wc=new B,rr=class{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,er)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=er.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(er.copy(this.origin).addScaledVector(this.direction,e),er.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Md.copy(t).add(e).multiplyScalar(.5),Vc.copy(e).sub(t).normalize(),Wc.copy(this.origin).sub(Md);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Vc),a=Wc.dot(this.direction),l=-Wc.dot(Vc),c=Wc.lengthSq(),h=Math.abs(1-o*o),u,f,d,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let x=1/h;u*=x,f*=x,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Md).addScaledVector(Vc,f),d}intersectSphere(t,e){if(t.radius<0)return null;er.subVectors(t.center,this.origin);let i=er.dot(this.direction),s=er.dot(er)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,er)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,g=e.x-o.x,x=e.y-o.y,p=e.z-o.z,m=i.x-o.x,_=i.y-o.y,w=i.z-o.z,b=Math.abs(l),C=Math.abs(c),S=Math.abs(h),y,M,U,I,D,z,X,N,V,Z,W,ct;if(b>=C&&b>=S?(U=l,z=u,V=g,ct=m,l>=0?(y=c,M=h,I=f,D=d,X=x,N=p,Z=_,W=w):(y=h,M=c,I=d,D=f,X=p,N=x,Z=w,W=_)):C>=S?(U=c,z=f,V=x,ct=_,c>=0?(y=h,M=l,I=d,D=u,X=p,N=g,Z=w,W=m):(y=l,M=h,I=u,D=d,X=g,N=p,Z=m,W=w)):(U=h,z=d,V=p,ct=w,h>=0?(y=l,M=c,I=u,D=f,X=g,N=x,Z=m,W=_):(y=c,M=l,I=f,D=u,X=x,N=g,Z=_,W=m)),U===0)return null;let $=y/U,tt=M/U,st=1/U,ft=I-$*z,dt=D-tt*z,et=X-$*V,gt=N-tt*V,yt=Z-$*ct,Rt=W-tt*ct,Mt=yt*gt-Rt*et,Zt=ft*Rt-dt*yt,ue=et*dt-gt*ft;if(s){if(Mt<0||Zt<0||ue<0)return null}else if((Mt<0||Zt<0||ue<0)&&(Mt>0||Zt>0||ue>0))return null;let Yt=Mt+Zt+ue;if(Yt===0)return null;let _e=st*(Mt*z+Zt*V+ue*ct);return(Yt>0?_e<0:_e>0)?null:this.at(_e/Yt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},cs=class extends Ns{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ls,this.combine=kd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},$g=new Me,Qr=new rr,Xc=new Ds,Zg=new B,qc=new B,Yc=new B,$c=new B,wd=new B,Zc=new B,Jg=new B,Jc=new B,Ft=class extends Sn{constructor(t=new Ce,e=new cs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Zc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(wd.fromBufferAttribute(u,t),o?Zc.addScaledVector(wd,h):Zc.addScaledVector(wd.sub(e),h))}e.add(Zc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Xc.copy(i.boundingSphere),Xc.applyMatrix4(r),Qr.copy(t.ray).recast(t.near),!(Xc.containsPoint(Qr.origin)===!1&&(Qr.intersectSphere(Xc,Zg)===null||Qr.origin.distanceToSquared(Zg)>(t.far-t.near)**2))&&($g.copy(r).invert(),Qr.copy(t.ray).applyMatrix4($g),!(i.boundingBox!==null&&Qr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Qr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=f.length;g<x;g++){let p=f[g],m=o[p.materialIndex],_=Math.max(p.start,d.start),w=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let b=_,C=w;b<C;b+=3){let S=a.getX(b),y=a.getX(b+1),M=a.getX(b+2);s=jc(this,m,t,i,c,h,u,S,y,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let p=g,m=x;p<m;p+=3){let _=a.getX(p),w=a.getX(p+1),b=a.getX(p+2);s=jc(this,o,t,i,c,h,u,_,w,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=f.length;g<x;g++){let p=f[g],m=o[p.materialIndex],_=Math.max(p.start,d.start),w=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let b=_,C=w;b<C;b+=3){let S=b,y=b+1,M=b+2;s=jc(this,m,t,i,c,h,u,S,y,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),x=Math.min(l.count,d.start+d.count);for(let p=g,m=x;p<m;p+=3){let _=p,w=p+1,b=p+2;s=jc(this,o,t,i,c,h,u,_,w,b),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function tS(n,t,e,i,s,r,o,a){let l;if(t.side===yi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ur,a),l===null)return null;Jc.copy(a),Jc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Jc);return c<e.near||c>e.far?null:{distance:c,point:Jc.clone(),object:n}}function jc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,qc),n.getVertexPosition(l,Yc),n.getVertexPosition(c,$c);let h=tS(n,t,e,i,qc,Yc,$c,Jg);if(h){let u=new B;nr.getBarycoord(Jg,qc,Yc,$c,u),s&&(h.uv=nr.getInterpolatedAttribute(s,a,l,c,u,new qt)),r&&(h.uv1=nr.getInterpolatedAttribute(r,a,l,c,u,new qt)),o&&(h.normal=nr.getInterpolatedAttribute(o,a,l,c,u,new B),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new B,materialIndex:0};nr.getNormal(qc,Yc,$c,f.normal),h.face=f,h.barycoord=u}return h}var bl=class extends _i{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Yn,h=Yn,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var da=class extends en{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},ta=new Me,jg=new Me,Kc=[],Kg=new Si,eS=new Me,nl=new Ft,il=new Ds,Sl=class extends Ft{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new da(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,eS)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Si),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ta),Kg.copy(t.boundingBox).applyMatrix4(ta),this.boundingBox.union(Kg)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ds),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ta),il.copy(t.boundingSphere).applyMatrix4(ta),this.boundingSphere.union(il)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(nl.geometry=this.geometry,nl.material=this.material,nl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),il.copy(this.boundingSphere),il.applyMatrix4(i),t.ray.intersectsSphere(il)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ta),jg.multiplyMatrices(i,ta),nl.matrixWorld=jg,nl.raycast(t,Kc);for(let o=0,a=Kc.length;o<a;o++){let l=Kc[o];l.instanceId=r,l.object=this,e.push(l)}Kc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new da(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new bl(new Float32Array(s*this.count),s,this.count,Yh,Zi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},to=new Ds,nS=new qt(.5,.5),Qc=new B,eo=class{constructor(t=new Fi,e=new Fi,i=new Fi,s=new Fi,r=new Fi,o=new Fi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Yi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],g=r[8],x=r[9],p=r[10],m=r[11],_=r[12],w=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,d-h,m-g,C-_).normalize(),s[1].setComponents(c+o,d+h,m+g,C+_).normalize(),s[2].setComponents(c+a,d+u,m+x,C+w).normalize(),s[3].setComponents(c-a,d-u,m-x,C-w).normalize(),i)s[4].setComponents(l,f,p,b).normalize(),s[5].setComponents(c-l,d-f,m-p,C-b).normalize();else if(s[4].setComponents(c-l,d-f,m-p,C-b).normalize(),e===Yi)s[5].setComponents(c+l,d+f,m+p,C+b).normalize();else if(e===ul)s[5].setComponents(l,f,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),to.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),to.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(to)}intersectsSprite(t){to.center.set(0,0,0);let e=nS.distanceTo(t.center);return to.radius=.7071067811865476+e,to.applyMatrix4(t.matrixWorld),this.intersectsSphere(to)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Qc.x=s.normal.x>0?t.max.x:t.min.x,Qc.y=s.normal.y>0?t.max.y:t.min.y,Qc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Qc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Qg=new Me,Sh=class n{constructor(){this.coordinateSystem=Yi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Qg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new eo),i[s].setFromProjectionMatrix(Qg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new eo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var hs=class extends Ns{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Mh=new B,wh=new B,t0=new Me,sl=new rr,th=new Ds,Ed=new B,e0=new B,xi=class extends Sn{constructor(t=new Ce,e=new hs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Mh.fromBufferAttribute(e,s-1),wh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Mh.distanceTo(wh);t.setAttribute("lineDistance",new Te(i,1))}else Kt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),th.copy(i.boundingSphere),th.applyMatrix4(s),th.radius+=r,t.ray.intersectsSphere(th)===!1)return;t0.copy(s).invert(),sl.copy(t.ray).applyMatrix4(t0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,f=i.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=d,p=g-1;x<p;x+=c){let m=h.getX(x),_=h.getX(x+1),w=eh(this,t,sl,l,m,_,x);w&&e.push(w)}if(this.isLineLoop){let x=h.getX(g-1),p=h.getX(d),m=eh(this,t,sl,l,x,p,g-1);m&&e.push(m)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let x=d,p=g-1;x<p;x+=c){let m=eh(this,t,sl,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=eh(this,t,sl,l,g-1,d,g-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function eh(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Mh.fromBufferAttribute(a,s),wh.fromBufferAttribute(a,r),e.distanceSqToSegment(Mh,wh,Ed,e0)>i)return;Ed.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ed);if(!(c<t.near||c>t.far))return{distance:c,point:e0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var n0=new B,i0=new B,no=class extends xi{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)n0.fromBufferAttribute(e,s),i0.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+n0.distanceTo(i0);t.setAttribute("lineDistance",new Te(i,1))}else Kt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Cr=class extends Ns{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Qt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},s0=new Me,Pd=new rr,nh=new Ds,ih=new B,io=class extends Sn{constructor(t=new Ce,e=new Cr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),nh.copy(i.boundingSphere),nh.applyMatrix4(s),nh.radius+=r,t.ray.intersectsSphere(nh)===!1)return;s0.copy(s).invert(),Pd.copy(t.ray).applyMatrix4(s0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,u=i.attributes.position;if(c!==null){let f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,x=d;g<x;g++){let p=c.getX(g);ih.fromBufferAttribute(u,p),r0(ih,p,l,s,t,e,this)}}else{let f=Math.max(0,o.start),d=Math.min(u.count,o.start+o.count);for(let g=f,x=d;g<x;g++)ih.fromBufferAttribute(u,g),r0(ih,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function r0(n,t,e,i,s,r,o){let a=Pd.distanceSqToPoint(n);if(a<e){let l=new B;Pd.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Ml=class extends _i{constructor(t=[],e=co,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},wl=class extends _i{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var or=class extends _i{constructor(t,e,i=us,s,r,o,a=Yn,l=Yn,c,h=sr,u=1){if(h!==sr&&h!==cr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new la(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},El=class extends or{constructor(t,e=us,i=co,s,r,o=Yn,a=Yn,l,c=sr){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Tl=class extends _i{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},on=class n extends Ce{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(h,3)),this.setAttribute("uv",new Te(u,2));function g(x,p,m,_,w,b,C,S,y,M,U){let I=b/y,D=C/M,z=b/2,X=C/2,N=S/2,V=y+1,Z=M+1,W=0,ct=0,$=new B;for(let tt=0;tt<Z;tt++){let st=tt*D-X;for(let ft=0;ft<V;ft++){let dt=ft*I-z;$[x]=dt*_,$[p]=st*w,$[m]=N,c.push($.x,$.y,$.z),$[x]=0,$[p]=0,$[m]=S>0?1:-1,h.push($.x,$.y,$.z),u.push(ft/y),u.push(1-tt/M),W+=1}}for(let tt=0;tt<M;tt++)for(let st=0;st<y;st++){let ft=f+st+V*tt,dt=f+st+V*(tt+1),et=f+(st+1)+V*(tt+1),gt=f+(st+1)+V*tt;l.push(ft,dt,gt),l.push(dt,et,gt),ct+=6}a.addGroup(d,ct,U),d+=ct,f+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var an=class n extends Ce{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],g=0,x=[],p=i/2,m=0;_(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Te(u,3)),this.setAttribute("normal",new Te(f,3)),this.setAttribute("uv",new Te(d,2));function _(){let b=new B,C=new B,S=0,y=(e-t)/i;for(let M=0;M<=r;M++){let U=[],I=M/r,D=I*(e-t)+t;for(let z=0;z<=s;z++){let X=z/s,N=X*l+a,V=Math.sin(N),Z=Math.cos(N);C.x=D*V,C.y=-I*i+p,C.z=D*Z,u.push(C.x,C.y,C.z),b.set(V,y,Z).normalize(),f.push(b.x,b.y,b.z),d.push(X,1-I),U.push(g++)}x.push(U)}for(let M=0;M<s;M++)for(let U=0;U<r;U++){let I=x[U][M],D=x[U+1][M],z=x[U+1][M+1],X=x[U][M+1];(t>0||U!==0)&&(h.push(I,D,X),S+=3),(e>0||U!==r-1)&&(h.push(D,z,X),S+=3)}c.addGroup(m,S,0),m+=S}function w(b){let C=g,S=new qt,y=new B,M=0,U=b===!0?t:e,I=b===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,p*I,0),f.push(0,I,0),d.push(.5,.5),g++;let D=g;for(let z=0;z<=s;z++){let N=z/s*l+a,V=Math.cos(N),Z=Math.sin(N);y.x=U*Z,y.y=p*I,y.z=U*V,u.push(y.x,y.y,y.z),f.push(0,I,0),S.x=V*.5+.5,S.y=Z*.5*I+.5,d.push(S.x,S.y),g++}for(let z=0;z<s;z++){let X=C+z,N=D+z;b===!0?h.push(N,N+1,X):h.push(N+1,N,X),M+=3}c.addGroup(m,M,b===!0?1:2),m+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Al=class n extends an{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Eh=class n extends Ce{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),h(),this.setAttribute("position",new Te(r,3)),this.setAttribute("normal",new Te(r.slice(),3)),this.setAttribute("uv",new Te(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(_){let w=new B,b=new B,C=new B;for(let S=0;S<e.length;S+=3)d(e[S+0],w),d(e[S+1],b),d(e[S+2],C),l(w,b,C,_)}function l(_,w,b,C){let S=C+1,y=[];for(let M=0;M<=S;M++){y[M]=[];let U=_.clone().lerp(b,M/S),I=w.clone().lerp(b,M/S),D=S-M;for(let z=0;z<=D;z++)z===0&&M===S?y[M][z]=U:y[M][z]=U.clone().lerp(I,z/D)}for(let M=0;M<S;M++)for(let U=0;U<2*(S-M)-1;U++){let I=Math.floor(U/2);U%2===0?(f(y[M][I+1]),f(y[M+1][I]),f(y[M][I])):(f(y[M][I+1]),f(y[M+1][I+1]),f(y[M+1][I]))}}function c(_){let w=new B;for(let b=0;b<r.length;b+=3)w.x=r[b+0],w.y=r[b+1],w.z=r[b+2],w.normalize().multiplyScalar(_),r[b+0]=w.x,r[b+1]=w.y,r[b+2]=w.z}function h(){let _=new B;for(let w=0;w<r.length;w+=3){_.x=r[w+0],_.y=r[w+1],_.z=r[w+2];let b=p(_)/2/Math.PI+.5,C=m(_)/Math.PI+.5;o.push(b,1-C)}g(),u()}function u(){for(let _=0;_<o.length;_+=6){let w=o[_+0],b=o[_+2],C=o[_+4],S=Math.max(w,b,C),y=Math.min(w,b,C);S>.9&&y<.1&&(w<.2&&(o[_+0]+=1),b<.2&&(o[_+2]+=1),C<.2&&(o[_+4]+=1))}}function f(_){r.push(_.x,_.y,_.z)}function d(_,w){let b=_*3;w.x=t[b+0],w.y=t[b+1],w.z=t[b+2]}function g(){let _=new B,w=new B,b=new B,C=new B,S=new qt,y=new qt,M=new qt;for(let U=0,I=0;U<r.length;U+=9,I+=6){_.set(r[U+0],r[U+1],r[U+2]),w.set(r[U+3],r[U+4],r[U+5]),b.set(r[U+6],r[U+7],r[U+8]),S.set(o[I+0],o[I+1]),y.set(o[I+2],o[I+3]),M.set(o[I+4],o[I+5]),C.copy(_).add(w).add(b).divideScalar(3);let D=p(C);x(S,I+0,_,D),x(y,I+2,w,D),x(M,I+4,b,D)}}function x(_,w,b,C){C<0&&_.x===1&&(o[w]=_.x-1),b.x===0&&b.z===0&&(o[w]=C/2/Math.PI+.5)}function p(_){return Math.atan2(_.z,-_.x)}function m(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Rl=class n extends Ce{constructor(t=[new qt(0,-.5),new qt(.5,0),new qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=xe(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/e,u=new B,f=new qt,d=new B,g=new B,x=new B,p=0,m=0;for(let _=0;_<=t.length-1;_++)switch(_){case 0:p=t[_+1].x-t[_].x,m=t[_+1].y-t[_].y,d.x=m*1,d.y=-p,d.z=m*0,x.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:x.normalize(),l.push(x.x,x.y,x.z);break;default:p=t[_+1].x-t[_].x,m=t[_+1].y-t[_].y,d.x=m*1,d.y=-p,d.z=m*0,g.copy(d),d.x+=x.x,d.y+=x.y,d.z+=x.z,d.normalize(),l.push(d.x,d.y,d.z),x.copy(g)}for(let _=0;_<=e;_++){let w=i+_*h*s,b=Math.sin(w),C=Math.cos(w);for(let S=0;S<=t.length-1;S++){u.x=t[S].x*b,u.y=t[S].y,u.z=t[S].x*C,o.push(u.x,u.y,u.z),f.x=_/e,f.y=S/(t.length-1),a.push(f.x,f.y);let y=l[3*S+0]*b,M=l[3*S+1],U=l[3*S+0]*C;c.push(y,M,U)}}for(let _=0;_<e;_++)for(let w=0;w<t.length-1;w++){let b=w+_*t.length,C=b,S=b+t.length,y=b+t.length+1,M=b+1;r.push(C,S,M),r.push(y,M,S)}this.setIndex(r),this.setAttribute("position",new Te(o,3)),this.setAttribute("uv",new Te(a,2)),this.setAttribute("normal",new Te(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Us=class n extends Eh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},so=class n extends Ce{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],g=[],x=[],p=[];for(let m=0;m<h;m++){let _=m*f-o;for(let w=0;w<c;w++){let b=w*u-r;g.push(b,-_,0),x.push(0,0,1),p.push(w/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let w=_+c*m,b=_+c*(m+1),C=_+1+c*(m+1),S=_+1+c*m;d.push(w,b,S),d.push(b,C,S)}this.setIndex(d),this.setAttribute("position",new Te(g,3)),this.setAttribute("normal",new Te(x,3)),this.setAttribute("uv",new Te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var ro=class n extends Ce{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new B,f=new B,d=[],g=[],x=[],p=[];for(let m=0;m<=i;m++){let _=[],w=m/i,b=o+w*a,C=t*Math.cos(b),S=Math.sqrt(t*t-C*C),y=0;m===0&&o===0?y=.5/e:m===i&&l===Math.PI&&(y=-.5/e);for(let M=0;M<=e;M++){let U=M/e,I=s+U*r;u.x=-S*Math.cos(I),u.y=C,u.z=S*Math.sin(I),g.push(u.x,u.y,u.z),f.copy(u).normalize(),x.push(f.x,f.y,f.z),p.push(U+y,1-w),_.push(c++)}h.push(_)}for(let m=0;m<i;m++)for(let _=0;_<e;_++){let w=h[m][_+1],b=h[m][_],C=h[m+1][_],S=h[m+1][_+1];(m!==0||o>0)&&d.push(w,b,S),(m!==i-1||l<Math.PI)&&d.push(b,C,S)}this.setIndex(d),this.setAttribute("position",new Te(g,3)),this.setAttribute("normal",new Te(x,3)),this.setAttribute("uv",new Te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ar=class n extends Ce{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],h=[],u=[],f=new B,d=new B,g=new B;for(let x=0;x<=i;x++){let p=o+x/i*a;for(let m=0;m<=s;m++){let _=m/s*r;d.x=(t+e*Math.cos(p))*Math.cos(_),d.y=(t+e*Math.cos(p))*Math.sin(_),d.z=e*Math.sin(p),c.push(d.x,d.y,d.z),f.x=t*Math.cos(_),f.y=t*Math.sin(_),g.subVectors(d,f).normalize(),h.push(g.x,g.y,g.z),u.push(m/s),u.push(x/i)}}for(let x=1;x<=i;x++)for(let p=1;p<=s;p++){let m=(s+1)*x+p-1,_=(s+1)*(x-1)+p-1,w=(s+1)*(x-1)+p,b=(s+1)*x+p;l.push(m,_,b),l.push(_,w,b)}this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(h,3)),this.setAttribute("uv",new Te(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function uo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(o0(s))s.isRenderTargetTexture?(Kt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(o0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function si(n){let t={};for(let e=0;e<n.length;e++){let i=uo(n[e]);for(let s in i)t[s]=i[s]}return t}function o0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function iS(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function dp(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ee.workingColorSpace}var j0={clone:uo,merge:si},sS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,rS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$i=class extends Ns{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=sS,this.fragmentShader=rS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=uo(t.uniforms),this.uniformsGroups=iS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Qt().setHex(s.value);break;case"v2":this.uniforms[i].value=new qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new B().fromArray(s.value);break;case"v4":this.uniforms[i].value=new fn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new le().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Me().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Th=class extends $i{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ah=class extends Ns{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=O0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Rh=class extends Ns{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ea(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function sh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Pr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ch=class extends Pr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ad,endingEnd:Ad}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Rd:r=t,a=2*e-i;break;case Cd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Rd:o=t,l=2*i-e;break;case Cd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(i-e)/(s-e),x=g*g,p=x*g,m=-f*p+2*f*x-f*g,_=(1+f)*p+(-1.5-2*f)*x+(-.5+f)*g+1,w=(-1-d)*p+(1.5+d)*x+.5*g,b=d*p-d*x;for(let C=0;C!==a;++C)r[C]=m*o[h+C]+_*o[c+C]+w*o[l+C]+b*o[u+C];return r}},Ph=class extends Pr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Ih=class extends Pr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Lh=class extends Pr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(i-e)/(s-e),x=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*x+o[l+p]*g;return r}let f=a*2,d=t-1;for(let g=0;g!==a;++g){let x=o[c+g],p=o[l+g],m=d*f+g*2,_=u[m],w=u[m+1],b=t*f+g*2,C=h[b],S=h[b+1],y=aS(i,e,_,C,s);r[g]=K0(y,x,w,S,p)}return r}};function K0(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function oS(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function aS(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=K0(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=oS(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Bi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ea(e,this.TimeBufferType),this.values=ea(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ea(t.times,Array),values:ea(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),sh(t.settings)&&(i.settings={inTangents:ea(t.settings.inTangents,Array),outTangents:ea(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ih(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ph(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ch(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Lh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ll:e=this.InterpolantFactoryMethodDiscrete;break;case xh:e=this.InterpolantFactoryMethodLinear;break;case ah:e=this.InterpolantFactoryMethodSmooth;break;case Td:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Kt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ll;case this.InterpolantFactoryMethodLinear:return xh;case this.InterpolantFactoryMethodSmooth:return ah;case this.InterpolantFactoryMethodBezier:return Td}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;sh(this.settings)&&(a0(this.settings.inTangents,t),a0(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;sh(this.settings)&&(l0(this.settings.inTangents,t),l0(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ie("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ie("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Sb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ie("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ah,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,f=u-i,d=u+i;for(let g=0;g!==i;++g){let x=e[u+g];if(x!==e[f+g]||x!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,f=o*i;for(let d=0;d!==i;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,sh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function a0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function l0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Bi.prototype.ValueTypeName="";Bi.prototype.TimeBufferType=Float32Array;Bi.prototype.ValueBufferType=Float32Array;Bi.prototype.DefaultInterpolation=xh;var Ir=class extends Bi{constructor(t,e,i){super(t,e,i)}};Ir.prototype.ValueTypeName="bool";Ir.prototype.ValueBufferType=Array;Ir.prototype.DefaultInterpolation=ll;Ir.prototype.InterpolantFactoryMethodLinear=void 0;Ir.prototype.InterpolantFactoryMethodSmooth=void 0;var Dh=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}};Dh.prototype.ValueTypeName="color";var Nh=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}};Nh.prototype.ValueTypeName="number";var Uh=class extends Pr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Ze.slerpFlat(r,0,o,c-a,o,c,l);return r}},Cl=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Uh(this.times,this.values,this.getValueSize(),t)}};Cl.prototype.ValueTypeName="quaternion";Cl.prototype.InterpolantFactoryMethodSmooth=void 0;var Lr=class extends Bi{constructor(t,e,i){super(t,e,i)}};Lr.prototype.ValueTypeName="string";Lr.prototype.ValueBufferType=Array;Lr.prototype.DefaultInterpolation=ll;Lr.prototype.InterpolantFactoryMethodLinear=void 0;Lr.prototype.InterpolantFactoryMethodSmooth=void 0;var Fh=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}};Fh.prototype.ValueTypeName="vector";var Oh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],g=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Q0=new Oh,Bh=class{constructor(t){this.manager=t!==void 0?t:Q0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Bh.DEFAULT_MATERIAL_NAME="__DEFAULT";var rh=new B,oh=new Ze,Ps=new B,Pl=class extends Sn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Me,this.projectionMatrix=new Me,this.projectionMatrixInverse=new Me,this.coordinateSystem=Yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(rh,oh,Ps),Ps.x===1&&Ps.y===1&&Ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(rh,oh,Ps.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(rh,oh,Ps),Ps.x===1&&Ps.y===1&&Ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(rh,oh,Ps.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Rr=new B,c0=new qt,h0=new qt,mi=class extends Pl{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=aa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ol*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return aa*2*Math.atan(Math.tan(ol*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Rr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Rr.x,Rr.y).multiplyScalar(-t/Rr.z),Rr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Rr.x,Rr.y).multiplyScalar(-t/Rr.z)}getViewSize(t,e){return this.getViewBounds(t,c0,h0),e.subVectors(h0,c0)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ol*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var zh=class extends Pl{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var na=-90,ia=1,pa=class extends Sn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new mi(na,ia,t,e);s.layers=this.layers,this.add(s);let r=new mi(na,ia,t,e);r.layers=this.layers,this.add(r);let o=new mi(na,ia,t,e);o.layers=this.layers,this.add(o);let a=new mi(na,ia,t,e);a.layers=this.layers,this.add(a);let l=new mi(na,ia,t,e);l.layers=this.layers,this.add(l);let c=new mi(na,ia,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Yi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ul)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},kh=class extends mi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var pp="\\[\\]\\.:\\/",lS=new RegExp("["+pp+"]","g"),mp="[^"+pp+"]",cS="[^"+pp.replace("\\.","")+"]",hS=/((?:WC+[\/:])*)/.source.replace("WC",mp),uS=/(WCOD+)?/.source.replace("WCOD",cS),fS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",mp),dS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",mp),pS=new RegExp("^"+hS+uS+fS+dS+"$"),mS=["material","materials","bones","map"],Id=class{constructor(t,e,i){let s=i||tn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},tn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(lS,"")}static parseTrackName(t){let e=pS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);mS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Kt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};tn.Composite=Id;tn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};tn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};tn.prototype.GetterByBindingType=[tn.prototype._getValue_direct,tn.prototype._getValue_array,tn.prototype._getValue_arrayElement,tn.prototype._getValue_toArray];tn.prototype.SetterByBindingTypeAndVersioning=[[tn.prototype._setValue_direct,tn.prototype._setValue_direct_setNeedsUpdate,tn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_array,tn.prototype._setValue_array_setNeedsUpdate,tn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_arrayElement,tn.prototype._setValue_arrayElement_setNeedsUpdate,tn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_fromArray,tn.prototype._setValue_fromArray_setNeedsUpdate,tn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var qC=new Float32Array(1);var u0=new Me,Il=class{constructor(t,e,i=0,s=1/0){this.ray=new rr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new ca,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ie("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return u0.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(u0),this}intersectObject(t,e=!0,i=[]){return Ld(t,this,i,e),i.sort(f0),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Ld(t[s],this,i,e);return i.sort(f0),i}};function f0(n,t){return n.distance-t.distance}function Ld(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Ld(r[o],t,e,!0)}}var ma=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=xe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(xe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Dd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var oo=class extends ls{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function gp(n,t,e,i){let s=gS(i);switch(e){case Qd:return n*t;case Yh:return n*t/s.components*s.byteLength;case $h:return n*t/s.components*s.byteLength;case Fr:return n*t*2/s.components*s.byteLength;case Zh:return n*t*2/s.components*s.byteLength;case tp:return n*t*3/s.components*s.byteLength;case ds:return n*t*4/s.components*s.byteLength;case Jh:return n*t*4/s.components*s.byteLength;case Nl:case Ul:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Fl:case Ol:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Kh:case tu:return Math.max(n,16)*Math.max(t,8)/4;case jh:case Qh:return Math.max(n,8)*Math.max(t,8)/2;case eu:case nu:case su:case ru:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case iu:case Bl:case ou:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case au:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case lu:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case cu:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case hu:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case uu:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case fu:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case du:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case pu:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case mu:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case gu:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case _u:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case xu:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case yu:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case vu:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case bu:case Su:case Mu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case wu:case Eu:return Math.ceil(n/4)*Math.ceil(t/4)*8;case zl:case Tu:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function gS(n){switch(n){case zi:case Zd:return{byteLength:1,components:1};case ya:case Jd:case fs:return{byteLength:2,components:1};case Xh:case qh:return{byteLength:2,components:4};case us:case Wh:case Zi:return{byteLength:4,components:1};case jd:case Kd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Kt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function b_(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function bS(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<u.length;d++){let g=u[f],x=u[d];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++f,u[f]=x)}u.length=f+1;for(let d=0,g=u.length;d<g;d++){let x=u[d];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var SS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,MS=`#ifdef USE_ALPHAHASH
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
#endif`,wS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ES=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,AS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,RS=`#ifdef USE_AOMAP
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
#endif`,CS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,PS=`#ifdef USE_BATCHING
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
#endif`,IS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,LS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,DS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,NS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,US=`#ifdef USE_IRIDESCENCE
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
#endif`,FS=`#ifdef USE_BUMPMAP
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
#endif`,OS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,BS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,zS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,kS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,HS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,GS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,VS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,WS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,XS=`#define PI 3.141592653589793
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
} // validated`,qS=`vec3 transformedNormal = objectNormal;
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
#endif`,YS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$S=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ZS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,JS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,jS="gl_FragColor = linearToOutputTexel( gl_FragColor );",KS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,QS=`#ifdef USE_ENVMAP
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
#endif`,tM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,eM=`#ifdef USE_ENVMAP
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
#endif`,nM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iM=`#ifdef USE_ENVMAP
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
#endif`,sM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,oM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,aM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lM=`#ifdef USE_GRADIENTMAP
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
}`,cM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,hM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,fM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,dM=`#ifdef USE_ENVMAP
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
#endif`,pM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_M=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xM=`PhysicalMaterial material;
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
#endif`,yM=`uniform sampler2D dfgLUT;
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
}`,vM=`
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
#endif`,bM=`#if defined( RE_IndirectDiffuse )
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
#endif`,SM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,MM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,wM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,EM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,AM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,RM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,CM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,PM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,IM=`#if defined( USE_POINTS_UV )
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
#endif`,LM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,DM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,NM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,UM=`#if defined( USE_MORPHCOLORS )
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
#endif`,FM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,OM=`#ifdef USE_MORPHTARGETS
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
#endif`,BM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,zM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,kM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,HM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,GM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,VM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,WM=`#ifdef USE_NORMALMAP
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
#endif`,XM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,YM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$M=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ZM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,JM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,jM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,KM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,QM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,tw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ew=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,nw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,iw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,sw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,rw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,ow=`float getShadowMask() {
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
}`,aw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,lw=`#ifdef USE_SKINNING
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
#endif`,cw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hw=`#ifdef USE_SKINNING
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
#endif`,uw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,fw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,pw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,mw=`#ifdef USE_TRANSMISSION
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
#endif`,gw=`#ifdef USE_TRANSMISSION
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
#endif`,_w=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,yw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Sw=`uniform sampler2D t2D;
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
}`,Mw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ww=`uniform float backgroundBlurriness;
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
}`,Ew=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Tw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Aw=`#include <common>
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
}`,Rw=`#if DEPTH_PACKING == 3200
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
}`,Cw=`#define DISTANCE
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
}`,Pw=`#define DISTANCE
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
}`,Iw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Lw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Dw=`uniform float scale;
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
}`,Nw=`uniform vec3 diffuse;
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
}`,Uw=`#include <common>
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
}`,Fw=`uniform vec3 diffuse;
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
}`,Ow=`#define LAMBERT
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
}`,Bw=`#define LAMBERT
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
}`,zw=`#define MATCAP
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
}`,kw=`#define MATCAP
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
}`,Hw=`#define NORMAL
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
}`,Gw=`#define NORMAL
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
}`,Vw=`#define PHONG
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
}`,Ww=`#define PHONG
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
}`,Xw=`#define STANDARD
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
}`,qw=`#define STANDARD
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
}`,Yw=`#define TOON
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
}`,$w=`#define TOON
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
}`,Zw=`uniform float size;
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
}`,Jw=`uniform vec3 diffuse;
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
}`,jw=`#include <common>
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
}`,Kw=`uniform vec3 color;
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
}`,Qw=`uniform float rotation;
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
}`,t1=`uniform vec3 diffuse;
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
}`,ge={alphahash_fragment:SS,alphahash_pars_fragment:MS,alphamap_fragment:wS,alphamap_pars_fragment:ES,alphatest_fragment:TS,alphatest_pars_fragment:AS,aomap_fragment:RS,aomap_pars_fragment:CS,batching_pars_vertex:PS,batching_vertex:IS,begin_vertex:LS,beginnormal_vertex:DS,bsdfs:NS,iridescence_fragment:US,bumpmap_pars_fragment:FS,clipping_planes_fragment:OS,clipping_planes_pars_fragment:BS,clipping_planes_pars_vertex:zS,clipping_planes_vertex:kS,color_fragment:HS,color_pars_fragment:GS,color_pars_vertex:VS,color_vertex:WS,common:XS,defaultnormal_vertex:qS,displacementmap_pars_vertex:YS,displacementmap_vertex:$S,emissivemap_fragment:ZS,emissivemap_pars_fragment:JS,colorspace_fragment:jS,colorspace_pars_fragment:KS,envmap_fragment:QS,envmap_common_pars_fragment:tM,envmap_pars_fragment:eM,envmap_pars_vertex:nM,envmap_physical_pars_fragment:dM,envmap_vertex:iM,fog_vertex:sM,fog_pars_vertex:rM,fog_fragment:oM,fog_pars_fragment:aM,gradientmap_pars_fragment:lM,lightmap_pars_fragment:cM,lights_lambert_fragment:hM,lights_lambert_pars_fragment:uM,lights_pars_begin:fM,lights_toon_fragment:pM,lights_toon_pars_fragment:mM,lights_phong_fragment:gM,lights_phong_pars_fragment:_M,lights_physical_fragment:xM,lights_physical_pars_fragment:yM,lights_fragment_begin:vM,lights_fragment_maps:bM,lights_fragment_end:SM,lightprobes_pars_fragment:MM,logdepthbuf_fragment:wM,logdepthbuf_pars_fragment:EM,logdepthbuf_pars_vertex:TM,logdepthbuf_vertex:AM,map_fragment:RM,map_pars_fragment:CM,map_particle_fragment:PM,map_particle_pars_fragment:IM,metalnessmap_fragment:LM,metalnessmap_pars_fragment:DM,morphinstance_vertex:NM,morphcolor_vertex:UM,morphnormal_vertex:FM,morphtarget_pars_vertex:OM,morphtarget_vertex:BM,normal_fragment_begin:zM,normal_fragment_maps:kM,normal_pars_fragment:HM,normal_pars_vertex:GM,normal_vertex:VM,normalmap_pars_fragment:WM,clearcoat_normal_fragment_begin:XM,clearcoat_normal_fragment_maps:qM,clearcoat_pars_fragment:YM,iridescence_pars_fragment:$M,opaque_fragment:ZM,packing:JM,premultiplied_alpha_fragment:jM,project_vertex:KM,dithering_fragment:QM,dithering_pars_fragment:tw,roughnessmap_fragment:ew,roughnessmap_pars_fragment:nw,shadowmap_pars_fragment:iw,shadowmap_pars_vertex:sw,shadowmap_vertex:rw,shadowmask_pars_fragment:ow,skinbase_vertex:aw,skinning_pars_vertex:lw,skinning_vertex:cw,skinnormal_vertex:hw,specularmap_fragment:uw,specularmap_pars_fragment:fw,tonemapping_fragment:dw,tonemapping_pars_fragment:pw,transmission_fragment:mw,transmission_pars_fragment:gw,uv_pars_fragment:_w,uv_pars_vertex:xw,uv_vertex:yw,worldpos_vertex:vw,background_vert:bw,background_frag:Sw,backgroundCube_vert:Mw,backgroundCube_frag:ww,cube_vert:Ew,cube_frag:Tw,depth_vert:Aw,depth_frag:Rw,distance_vert:Cw,distance_frag:Pw,equirect_vert:Iw,equirect_frag:Lw,linedashed_vert:Dw,linedashed_frag:Nw,meshbasic_vert:Uw,meshbasic_frag:Fw,meshlambert_vert:Ow,meshlambert_frag:Bw,meshmatcap_vert:zw,meshmatcap_frag:kw,meshnormal_vert:Hw,meshnormal_frag:Gw,meshphong_vert:Vw,meshphong_frag:Ww,meshphysical_vert:Xw,meshphysical_frag:qw,meshtoon_vert:Yw,meshtoon_frag:$w,points_vert:Zw,points_frag:Jw,shadow_vert:jw,shadow_frag:Kw,sprite_vert:Qw,sprite_frag:t1},Nt={common:{diffuse:{value:new Qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new le}},envmap:{envMap:{value:null},envMapRotation:{value:new le},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new le}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new le}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new le},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new le},normalScale:{value:new qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new le},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new le}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new le}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new le}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0},uvTransform:{value:new le}},sprite:{diffuse:{value:new Qt(16777215)},opacity:{value:1},center:{value:new qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}}},Bs={basic:{uniforms:si([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:ge.meshbasic_vert,fragmentShader:ge.meshbasic_frag},lambert:{uniforms:si([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new Qt(0)},envMapIntensity:{value:1}}]),vertexShader:ge.meshlambert_vert,fragmentShader:ge.meshlambert_frag},phong:{uniforms:si([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new Qt(0)},specular:{value:new Qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ge.meshphong_vert,fragmentShader:ge.meshphong_frag},standard:{uniforms:si([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new Qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag},toon:{uniforms:si([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new Qt(0)}}]),vertexShader:ge.meshtoon_vert,fragmentShader:ge.meshtoon_frag},matcap:{uniforms:si([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:ge.meshmatcap_vert,fragmentShader:ge.meshmatcap_frag},points:{uniforms:si([Nt.points,Nt.fog]),vertexShader:ge.points_vert,fragmentShader:ge.points_frag},dashed:{uniforms:si([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ge.linedashed_vert,fragmentShader:ge.linedashed_frag},depth:{uniforms:si([Nt.common,Nt.displacementmap]),vertexShader:ge.depth_vert,fragmentShader:ge.depth_frag},normal:{uniforms:si([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:ge.meshnormal_vert,fragmentShader:ge.meshnormal_frag},sprite:{uniforms:si([Nt.sprite,Nt.fog]),vertexShader:ge.sprite_vert,fragmentShader:ge.sprite_frag},background:{uniforms:{uvTransform:{value:new le},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ge.background_vert,fragmentShader:ge.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new le}},vertexShader:ge.backgroundCube_vert,fragmentShader:ge.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ge.cube_vert,fragmentShader:ge.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ge.equirect_vert,fragmentShader:ge.equirect_frag},distance:{uniforms:si([Nt.common,Nt.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ge.distance_vert,fragmentShader:ge.distance_frag},shadow:{uniforms:si([Nt.lights,Nt.fog,{color:{value:new Qt(0)},opacity:{value:1}}]),vertexShader:ge.shadow_vert,fragmentShader:ge.shadow_frag}};Bs.physical={uniforms:si([Bs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new le},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new le},clearcoatNormalScale:{value:new qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new le},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new le},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new le},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new le},sheen:{value:0},sheenColor:{value:new Qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new le},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new le},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new le},transmissionSamplerSize:{value:new qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new le},attenuationDistance:{value:0},attenuationColor:{value:new Qt(0)},specularColor:{value:new Qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new le},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new le},anisotropyVector:{value:new qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new le}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag};var Cu={r:0,b:0,g:0},e1=new Me,S_=new le;S_.set(-1,0,0,0,1,0,0,0,1);function n1(n,t,e,i,s,r){let o=new Qt(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let b=_.backgroundBlurriness>0;w=t.get(w,b)}return w}function g(_){let w=!1,b=d(_);b===null?p(o,a):b&&b.isColor&&(p(b,1),w=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,w){let b=d(w);b&&b.isCubeTexture?(c===void 0&&(c=new Ft(new on(1,1,1),new $i({name:"BackgroundCubeMaterial",uniforms:uo(Bs.backgroundCube.uniforms),vertexShader:Bs.backgroundCube.vertexShader,fragmentShader:Bs.backgroundCube.fragmentShader,side:yi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,S,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(e1.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(S_),c.material.toneMapped=Ee.getTransfer(b.colorSpace)!==Ue,(h!==b||u!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,f=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ft(new so(2,2),new $i({name:"BackgroundMaterial",uniforms:uo(Bs.background.uniforms),vertexShader:Bs.background.vertexShader,fragmentShader:Bs.background.fragmentShader,side:Ur,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Ee.getTransfer(b.colorSpace)!==Ue,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,f=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function p(_,w){_.getRGB(Cu,dp(n)),e.buffers.color.setClear(Cu.r,Cu.g,Cu.b,w,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,p(o,a)},render:g,addToRenderList:x,dispose:m}}function i1(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(D,z,X,N,V){let Z=!1,W=u(D,N,X,z);r!==W&&(r=W,c(r.object)),Z=d(D,N,X,V),Z&&g(D,N,X,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,b(D,z,X,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function u(D,z,X,N){let V=N.wireframe===!0,Z=i[z.id];Z===void 0&&(Z={},i[z.id]=Z);let W=D.isInstancedMesh===!0?D.id:0,ct=Z[W];ct===void 0&&(ct={},Z[W]=ct);let $=ct[X.id];$===void 0&&($={},ct[X.id]=$);let tt=$[V];return tt===void 0&&(tt=f(l()),$[V]=tt),tt}function f(D){let z=[],X=[],N=[];for(let V=0;V<e;V++)z[V]=0,X[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:X,attributeDivisors:N,object:D,attributes:{},index:null}}function d(D,z,X,N){let V=r.attributes,Z=z.attributes,W=0,ct=X.getAttributes();for(let $ in ct)if(ct[$].location>=0){let st=V[$],ft=Z[$];if(ft===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ft=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ft=D.instanceColor)),st===void 0||st.attribute!==ft||ft&&st.data!==ft.data)return!0;W++}return r.attributesNum!==W||r.index!==N}function g(D,z,X,N){let V={},Z=z.attributes,W=0,ct=X.getAttributes();for(let $ in ct)if(ct[$].location>=0){let st=Z[$];st===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(st=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(st=D.instanceColor));let ft={};ft.attribute=st,st&&st.data&&(ft.data=st.data),V[$]=ft,W++}r.attributes=V,r.attributesNum=W,r.index=N}function x(){let D=r.newAttributes;for(let z=0,X=D.length;z<X;z++)D[z]=0}function p(D){m(D,0)}function m(D,z){let X=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;X[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),V[D]!==z&&(n.vertexAttribDivisor(D,z),V[D]=z)}function _(){let D=r.newAttributes,z=r.enabledAttributes;for(let X=0,N=z.length;X<N;X++)z[X]!==D[X]&&(n.disableVertexAttribArray(X),z[X]=0)}function w(D,z,X,N,V,Z,W){W===!0?n.vertexAttribIPointer(D,z,X,V,Z):n.vertexAttribPointer(D,z,X,N,V,Z)}function b(D,z,X,N){x();let V=N.attributes,Z=X.getAttributes(),W=z.defaultAttributeValues;for(let ct in Z){let $=Z[ct];if($.location>=0){let tt=V[ct];if(tt===void 0&&(ct==="instanceMatrix"&&D.instanceMatrix&&(tt=D.instanceMatrix),ct==="instanceColor"&&D.instanceColor&&(tt=D.instanceColor)),tt!==void 0){let st=tt.normalized,ft=tt.itemSize,dt=t.get(tt);if(dt===void 0)continue;let et=dt.buffer,gt=dt.type,yt=dt.bytesPerElement,Rt=gt===n.INT||gt===n.UNSIGNED_INT||tt.gpuType===Wh;if(tt.isInterleavedBufferAttribute){let Mt=tt.data,Zt=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,ue=tt.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Yt=0;Yt<$.locationSize;Yt++)m($.location+Yt,Mt.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Yt=0;Yt<$.locationSize;Yt++)p($.location+Yt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Yt=0;Yt<$.locationSize;Yt++)w($.location+Yt,ft/$.locationSize,gt,st,Zt*yt,(ue+ft/$.locationSize*Yt)*yt,Rt)}else{if(tt.isInstancedBufferAttribute){for(let Mt=0;Mt<$.locationSize;Mt++)m($.location+Mt,tt.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let Mt=0;Mt<$.locationSize;Mt++)p($.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Mt=0;Mt<$.locationSize;Mt++)w($.location+Mt,ft/$.locationSize,gt,st,ft*yt,ft/$.locationSize*Mt*yt,Rt)}}else if(W!==void 0){let st=W[ct];if(st!==void 0)switch(st.length){case 2:n.vertexAttrib2fv($.location,st);break;case 3:n.vertexAttrib3fv($.location,st);break;case 4:n.vertexAttrib4fv($.location,st);break;default:n.vertexAttrib1fv($.location,st)}}}}_()}function C(){U();for(let D in i){let z=i[D];for(let X in z){let N=z[X];for(let V in N){let Z=N[V];for(let W in Z)h(Z[W].object),delete Z[W];delete N[V]}}delete i[D]}}function S(D){if(i[D.id]===void 0)return;let z=i[D.id];for(let X in z){let N=z[X];for(let V in N){let Z=N[V];for(let W in Z)h(Z[W].object),delete Z[W];delete N[V]}}delete i[D.id]}function y(D){for(let z in i){let X=i[z];for(let N in X){let V=X[N];if(V[D.id]===void 0)continue;let Z=V[D.id];for(let W in Z)h(Z[W].object),delete Z[W];delete V[D.id]}}}function M(D){for(let z in i){let X=i[z],N=D.isInstancedMesh===!0?D.id:0,V=X[N];if(V!==void 0){for(let Z in V){let W=V[Z];for(let ct in W)h(W[ct].object),delete W[ct];delete V[Z]}delete X[N],Object.keys(X).length===0&&delete i[z]}}}function U(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:S,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:p,disableUnusedAttributes:_}}function s1(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function r1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==ds&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===fs&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==zi&&y!==Zi&&!M&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Kt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Kt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Kt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:b,maxSamples:C,samples:S}}function o1(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Fi,a=new le,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||i!==0||s;return s=f,i=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let g=u.clippingPlanes,x=u.clipIntersection,p=u.clipShadows,m=n.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let _=r?0:i,w=_*4,b=m.clippingState||null;l.value=b,b=h(g,f,w,d);for(let C=0;C!==w;++C)b[C]=e[C];m.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,f,d,g){let x=u!==null?u.length:0,p=null;if(x!==0){if(p=l.value,g!==!0||p===null){let m=d+x*4,_=f.matrixWorldInverse;a.getNormalMatrix(_),(p===null||p.length<m)&&(p=new Float32Array(m));for(let w=0,b=d;w!==x;++w,b+=4)o.copy(u[w]).applyMatrix4(_,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}var Gl=class extends Oi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Ml(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new on(5,5,5),r=new $i({name:"CubemapFromEquirect",uniforms:uo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:yi,blending:ao});r.uniforms.tEquirect.value=e;let o=new Ft(s,r),a=e.minFilter;return e.minFilter===lr&&(e.minFilter=gi),new pa(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},t_=256,a1=3,l1=20,M_=256,w_=16,c1=3,h1=new B,u1=new Qt,Iu=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new pa(1,10,null),this._boxMesh=new Ft(new on(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=h1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(u1));let p=new pa(i,s,h);return p.position.copy(a),p.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=i_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=n_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(t_,hp(t))}_fromTexture(t,e){t.mapping===co||t.mapping===xa?this._setSize(t.image.length===0?t_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=e_(t,!1,!1),i=Math.log2(t)-a1;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=e_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===co||t.mapping===xa?(this._cubemapMaterial===null&&(this._cubemapMaterial=i_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=n_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=f1(),this._integrationMaterial=d1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/w_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-c1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(M_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=p1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function e_(n,t,e){return new Gl(n,{minFilter:lr,generateMipmaps:t,type:fs,colorSpace:cl,depthBuffer:e})}function Vl(n,t,e){return new $i({name:n,uniforms:t,vertexShader:ge.cube_vert,fragmentShader:e,side:yi,blending:ao,depthTest:!1,depthWrite:!1})}function f1(){return Vl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${M_}u

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
	`)}function d1(){return Vl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:w_}},`

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
	`)}function p1(){return Vl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${l1}
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
	`)}function n_(){return Vl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function i_(){return Vl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function m1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Hh||d===Gh)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let x=new Gl(g.height);return x.fromEquirectangularTexture(n,f),t.set(f,x),f.addEventListener("dispose",c),a(x.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===Hh||d===Gh,x=d===co||d===xa;if(g||x){let p=e.get(f),m=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Iu(n)),p=g?i.fromEquirectangular(f,p):i.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),p.texture;if(p!==void 0)return p.texture;{let _=f.image;return g&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new Iu(n)),p=g?i.fromEquirectangular(f):i.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,e.set(f,p),f.addEventListener("dispose",h),p.texture):null}}}return f}function a(f,d){return d===Hh?f.mapping=co:d===Gh&&(f.mapping=xa),f}function l(f){let d=0,g=6;for(let x=0;x<g;x++)f[x]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function g1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&rl("WebGLRenderer: "+i+" extension not supported."),s}}}function _1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(t.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(g){let x=g.attributes;for(let p in x)t.update(x[p],n.ARRAY_BUFFER)}function u(g){let x=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let _=x!==null?x.array.length:p.array.length/3-1,w=p.count>=65535?xl:_l,b=new w(Math.ceil(_/3)*6,1),C=b.array;if(x!==null){let y=x.array;m=x.version;for(let M=0,U=0;M<_;M+=3){let I=y[M+0],D=y[M+1],z=y[M+2];C[U++]=I,C[U++]=D,C[U++]=D,C[U++]=z,C[U++]=z,C[U++]=I}}else{m=p.version;for(let y=0,M=0;y<_;y+=3){let U=y+0,I=y+1,D=y+2;C[M++]=U,C[M++]=I,C[M++]=I,C[M++]=D,C[M++]=D,C[M++]=U}}b.version=m;let S=r.get(g);S&&t.remove(S),r.set(g,b)}function f(g){let x=r.get(g);if(x){let p=g.index;p!==null&&x.version<p.version&&u(g)}else u(g);return r.get(g)}function d(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function x1(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){n.drawElements(i,f,r,u*o),e.update(f,i,1)}function c(u,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,u*o,d),e.update(f,i,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,u,0,d);let x=0;for(let p=0;p<d;p++)x+=f[p];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function y1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function v1(n,t,e){let i=new WeakMap,s=new fn;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=i.get(a);if(f===void 0||f.count!==u){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;d===!0&&(w=1),g===!0&&(w=2),x===!0&&(w=3);let b=a.attributes.position.count*w,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let S=new Float32Array(b*C*4*u),y=new pl(S,b,C,u);y.type=Zi,y.needsUpdate=!0;let M=w*4;for(let I=0;I<u;I++){let D=p[I],z=m[I],X=_[I],N=b*C*4*I;for(let V=0;V<D.count;V++){let Z=V*M;d===!0&&(s.fromBufferAttribute(D,V),S[N+Z+0]=s.x,S[N+Z+1]=s.y,S[N+Z+2]=s.z,S[N+Z+3]=0),g===!0&&(s.fromBufferAttribute(z,V),S[N+Z+4]=s.x,S[N+Z+5]=s.y,S[N+Z+6]=s.z,S[N+Z+7]=0),x===!0&&(s.fromBufferAttribute(X,V),S[N+Z+8]=s.x,S[N+Z+9]=s.y,S[N+Z+10]=s.z,S[N+Z+11]=X.itemSize===4?s.w:1)}}f={count:u,texture:y,size:new qt(b,C)},i.set(a,f),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let x=0;x<c.length;x++)d+=c[x];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function b1(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var S1={[Hd]:"LINEAR_TONE_MAPPING",[Gd]:"REINHARD_TONE_MAPPING",[Vd]:"CINEON_TONE_MAPPING",[Wd]:"ACES_FILMIC_TONE_MAPPING",[qd]:"AGX_TONE_MAPPING",[Yd]:"NEUTRAL_TONE_MAPPING",[Xd]:"CUSTOM_TONE_MAPPING"};function M1(n,t,e,i,s,r){let o=new Oi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ce;h.setAttribute("position",new Te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Te([0,2,0,0,2,0],2));let u=new Th({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ft(h,u),d=new zh(-1,1,1,-1,0,1),g=null,x=null,p=!1,m,_=null,w=[],b=!1;this.setSize=function(C,S){o.setSize(C,S),a!==null&&a.setSize(C,S),l!==null&&l.setSize(C,S);for(let y=0;y<w.length;y++){let M=w[y];M.setSize&&M.setSize(C,S)}},this.setEffects=function(C){w=C,b=w.length>0&&w[0].isRenderPass===!0;let S=o.width,y=o.height;w.length>0&&a===null&&(a=new Oi(S,y,{type:fs,depthBuffer:!1,stencilBuffer:!1}),l=new Oi(S,y,{type:fs,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&w.some(U=>U.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new or(S,y),r===!0&&(c.format=cr,c.type=ho)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let U=0;U<w.length;U++){let I=w[U];I.setSize&&I.setSize(S,y),M&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(C,S){if(p||C.toneMapping===Fs&&w.length===0)return!1;if(_=S,S!==null){let y=S.width,M=S.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return b===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=Fs,!0},this.hasRenderPass=function(){return b},this.end=function(C,S){C.toneMapping=m,p=!0;let y=o,M=a;for(let U=0;U<w.length;U++){let I=w[U];I.enabled!==!1&&(I.render(C,M,y,S),I.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(g!==C.outputColorSpace||x!==C.toneMapping){g=C.outputColorSpace,x=C.toneMapping,u.defines={},Ee.getTransfer(g)===Ue&&(u.defines.SRGB_TRANSFER="");let U=S1[x];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(_),C.render(f,d),_=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var E_=new _i,T_=new or(1,1),A_=new El(1),R_=new pl,C_=new bh,P_=new Ml,s_=[],r_=[],o_=new Float32Array(16),a_=new Float32Array(9),l_=new Float32Array(4);function Sa(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=s_[s];if(r===void 0&&(r=new Float32Array(s),s_[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Nn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Un(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Du(n,t){let e=r_[t];e===void 0&&(e=new Int32Array(t),r_[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function w1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function E1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Nn(e,t))return;n.uniform2fv(this.addr,t),Un(e,t)}}function T1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Nn(e,t))return;n.uniform3fv(this.addr,t),Un(e,t)}}function A1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Nn(e,t))return;n.uniform4fv(this.addr,t),Un(e,t)}}function R1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Nn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Un(e,t)}else{if(Nn(e,i))return;l_.set(i),n.uniformMatrix2fv(this.addr,!1,l_),Un(e,i)}}function C1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Nn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Un(e,t)}else{if(Nn(e,i))return;a_.set(i),n.uniformMatrix3fv(this.addr,!1,a_),Un(e,i)}}function P1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Nn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Un(e,t)}else{if(Nn(e,i))return;o_.set(i),n.uniformMatrix4fv(this.addr,!1,o_),Un(e,i)}}function I1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function L1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Nn(e,t))return;n.uniform2iv(this.addr,t),Un(e,t)}}function D1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Nn(e,t))return;n.uniform3iv(this.addr,t),Un(e,t)}}function N1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Nn(e,t))return;n.uniform4iv(this.addr,t),Un(e,t)}}function U1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function F1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Nn(e,t))return;n.uniform2uiv(this.addr,t),Un(e,t)}}function O1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Nn(e,t))return;n.uniform3uiv(this.addr,t),Un(e,t)}}function B1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Nn(e,t))return;n.uniform4uiv(this.addr,t),Un(e,t)}}function Nu(n){return n.version===0&&(n.compareFunction=op,n.needsUpdate=!0),n}function z1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Nu(T_):r=E_,e.setTexture2D(t||r,s)}function k1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||C_,s)}function H1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Nu(A_):r=P_,e.setTextureCube(t||r,s)}function G1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||R_,s)}function V1(n){switch(n){case 5126:return w1;case 35664:return E1;case 35665:return T1;case 35666:return A1;case 35674:return R1;case 35675:return C1;case 35676:return P1;case 5124:case 35670:return I1;case 35667:case 35671:return L1;case 35668:case 35672:return D1;case 35669:case 35673:return N1;case 5125:return U1;case 36294:return F1;case 36295:return O1;case 36296:return B1;case 35678:case 36198:case 36298:case 36306:case 35682:return z1;case 35679:case 36299:case 36307:return k1;case 35680:case 36300:case 36308:case 36293:return H1;case 36289:case 36303:case 36311:case 36292:return G1}}function W1(n,t){n.uniform1fv(this.addr,t)}function X1(n,t){let e=Sa(t,this.size,2);n.uniform2fv(this.addr,e)}function q1(n,t){let e=Sa(t,this.size,3);n.uniform3fv(this.addr,e)}function Y1(n,t){let e=Sa(t,this.size,4);n.uniform4fv(this.addr,e)}function $1(n,t){let e=Sa(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Z1(n,t){let e=Sa(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function J1(n,t){let e=Sa(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function j1(n,t){n.uniform1iv(this.addr,t)}function K1(n,t){n.uniform2iv(this.addr,t)}function Q1(n,t){n.uniform3iv(this.addr,t)}function tE(n,t){n.uniform4iv(this.addr,t)}function eE(n,t){n.uniform1uiv(this.addr,t)}function nE(n,t){n.uniform2uiv(this.addr,t)}function iE(n,t){n.uniform3uiv(this.addr,t)}function sE(n,t){n.uniform4uiv(this.addr,t)}function rE(n,t,e){let i=this.cache,s=t.length,r=Du(e,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Nu(T_):o=E_;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function oE(n,t,e){let i=this.cache,s=t.length,r=Du(e,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||C_,r[o])}function aE(n,t,e){let i=this.cache,s=t.length,r=Du(e,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Nu(A_):o=P_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function lE(n,t,e){let i=this.cache,s=t.length,r=Du(e,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||R_,r[o])}function cE(n){switch(n){case 5126:return W1;case 35664:return X1;case 35665:return q1;case 35666:return Y1;case 35674:return $1;case 35675:return Z1;case 35676:return J1;case 5124:case 35670:return j1;case 35667:case 35671:return K1;case 35668:case 35672:return Q1;case 35669:case 35673:return tE;case 5125:return eE;case 36294:return nE;case 36295:return iE;case 36296:return sE;case 35678:case 36198:case 36298:case 36306:case 35682:return rE;case 35679:case 36299:case 36307:return oE;case 35680:case 36300:case 36308:case 36293:return aE;case 36289:case 36303:case 36311:case 36292:return lE}}var yp=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=V1(e.type)}},vp=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=cE(e.type)}},bp=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},_p=/(\w+)(\])?(\[|\.)?/g;function c_(n,t){n.seq.push(t),n.map[t.id]=t}function hE(n,t,e){let i=n.name,s=i.length;for(_p.lastIndex=0;;){let r=_p.exec(i),o=_p.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){c_(e,c===void 0?new yp(a,n,t):new vp(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new bp(a),c_(e,u)),e=u}}}var ba=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);hE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function h_(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var uE=37297,fE=0;function dE(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var u_=new le;function pE(n){Ee._getMatrix(u_,Ee.workingColorSpace,n);let t=`mat3( ${u_.elements.map(e=>e.toFixed(4))} )`;switch(Ee.getTransfer(n)){case hl:return[t,"LinearTransferOETF"];case Ue:return[t,"sRGBTransferOETF"];default:return Kt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function f_(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+dE(n.getShaderSource(t),a)}else return r}function mE(n,t){let e=pE(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var gE={[Hd]:"Linear",[Gd]:"Reinhard",[Vd]:"Cineon",[Wd]:"ACESFilmic",[qd]:"AgX",[Yd]:"Neutral",[Xd]:"Custom"};function _E(n,t){let e=gE[t];return e===void 0?(Kt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Pu=new B;function xE(){Ee.getLuminanceCoefficients(Pu);let n=Pu.x.toFixed(4),t=Pu.y.toFixed(4),e=Pu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function yE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Hl).join(`
`)}function vE(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function bE(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Hl(n){return n!==""}function d_(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function p_(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var SE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sp(n){return n.replace(SE,ME)}function ME(n,t){let e=ge[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Sp(e)}var wE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function m_(n){return n.replace(wE,EE)}function EE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function g_(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var TE={[Ll]:"SHADOWMAP_TYPE_PCF",[ga]:"SHADOWMAP_TYPE_VSM"};function AE(n){return TE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var RE={[xa]:"ENVMAP_MODE_REFRACTION"};function CE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":RE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var PE={[kd]:"ENVMAP_BLENDING_MULTIPLY",[N0]:"ENVMAP_BLENDING_MIX",[U0]:"ENVMAP_BLENDING_ADD"};function IE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":PE[n.combine]||"ENVMAP_BLENDING_NONE"}function LE(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=AE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=CE(e),u=IE(e),f=yE(e),d=vE(r),g=s.createProgram(),x,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Hl).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Hl).join(`
`),p.length>0&&(p+=`
`)):(x=[g_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Hl).join(`
`),p=[g_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Fs?"#define TONE_MAPPING":"",e.toneMapping!==Fs?ge.tonemapping_pars_fragment:"",e.toneMapping!==Fs?_E("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ge.colorspace_pars_fragment,mE("linearToOutputTexel",e.outputColorSpace),xE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Hl).join(`
`)),o=Sp(o),o=d_(o,e),o=p_(o,e),a=Sp(a),a=d_(a,e),a=p_(a,e),o=m_(o),a=m_(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",e.glslVersion===lp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===lp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let _=m+x+o,w=m+p+a,b=h_(s,s.VERTEX_SHADER,_),C=h_(s,s.FRAGMENT_SHADER,w);s.attachShader(g,b),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function S(I){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",z=s.getShaderInfoLog(b)||"",X=s.getShaderInfoLog(C)||"",N=D.trim(),V=z.trim(),Z=X.trim(),W=!0,ct=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,b,C);else{let $=f_(s,b,"vertex"),tt=f_(s,C,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+N+`
`+$+`
`+tt)}else N!==""?Kt("WebGLProgram: Program Info Log:",N):(V===""||Z==="")&&(ct=!1);ct&&(I.diagnostics={runnable:W,programLog:N,vertexShader:{log:V,prefix:x},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(b),s.deleteShader(C),y=new ba(s,g),M=bE(s,g)}let y;this.getUniforms=function(){return y===void 0&&S(this),y};let M;this.getAttributes=function(){return M===void 0&&S(this),M};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,uE)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=fE++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=C,this}var DE=0,Mp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new wp(t),e.set(t,i)),i}},wp=class{constructor(t){this.id=DE++,this.code=t,this.usedTimes=0}};function NE(n){return n===Fr||n===Bl||n===zl}function UE(n,t,e,i,s,r){let o=new ca,a=new Mp,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,M,U,I,D,z){let X=I.fog,N=D.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,Z=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,W=t.get(y.envMap||V,Z),ct=f[y.type],$=i.precision;y.precision!==null&&($=i.getMaxPrecision(y.precision),$!==y.precision&&Kt("WebGLProgram.getParameters:",y.precision,"not supported, using",$,"instead."));let tt=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,st=tt!==void 0?tt.length:0,ft=0;N.morphAttributes.position!==void 0&&(ft=1),N.morphAttributes.normal!==void 0&&(ft=2),N.morphAttributes.color!==void 0&&(ft=3);let dt,et,gt,yt;if(ct){let Ct=Bs[ct];dt=Ct.vertexShader,et=Ct.fragmentShader}else{dt=y.vertexShader,et=y.fragmentShader;let Ct=a.getVertexShaderStage(y),de=a.getFragmentShaderStage(y);a.update(y,Ct,de),gt=Ct.id,yt=de.id}let Rt=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Zt=D.isInstancedMesh===!0,ue=D.isBatchedMesh===!0,Yt=!!y.map,_e=!!y.matcap,pe=!!W,ce=pe&&W.isPMREMTexture===!0,sn=!!y.aoMap,Ye=!!y.lightMap,Mn=!!y.bumpMap&&y.wireframe===!1,He=!!y.normalMap,kn=!!y.displacementMap,Re=!!y.emissiveMap,In=!!y.metalnessMap,pn=!!y.roughnessMap,wn=y.anisotropy>0,H=y.clearcoat>0,It=y.diffuseRoughness>0,te=y.dispersion>0,fe=y.retroreflectivity>0,wt=y.iridescence>0,Ve=y.sheen>0,Xt=y.transmission>0,jt=wn&&!!y.anisotropyMap,P=H&&!!y.clearcoatMap,E=H&&!!y.clearcoatNormalMap,Y=H&&!!y.clearcoatRoughnessMap,ut=It&&!!y.diffuseRoughnessMap,at=wt&&!!y.iridescenceMap,xt=wt&&!!y.iridescenceThicknessMap,vt=Ve&&!!y.sheenColorMap,nt=Ve&&!!y.sheenRoughnessMap,rt=!!y.specularMap,mt=!!y.specularColorMap,k=!!y.specularIntensityMap,ot=Xt&&!!y.transmissionMap,it=Xt&&!!y.thicknessMap,Et=!!y.gradientMap,_t=!!y.alphaMap,St=y.alphaTest>0,$t=!!y.alphaHash,se=!!y.extensions,ht=Fs;y.toneMapped&&(Rt===null||Rt.isXRRenderTarget===!0)&&(ht=n.toneMapping);let Gt=ce?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,re={shaderID:ct,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:et,defines:y.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:$,batching:ue,batchingColor:ue&&D._colorsTexture!==null,instancing:Zt,instancingColor:Zt&&D.instanceColor!==null,instancingMorph:Zt&&D.morphTexture!==null,outputColorSpace:Rt===null?n.outputColorSpace:Rt.isXRRenderTarget===!0?Rt.texture.colorSpace:Ee.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Yt,matcap:_e,envMap:pe,envMapMode:pe&&W.mapping,envMapPMREM:ce,envMapMaxLod:ce?Gt.length-1:null,envMapSize:ce?Gt[0].width:null,aoMap:sn,lightMap:Ye,bumpMap:Mn,normalMap:He,displacementMap:kn,emissiveMap:Re,normalMapObjectSpace:He&&y.normalMapType===B0,normalMapTangentSpace:He&&y.normalMapType===ep,packedNormalMap:He&&y.normalMapType===ep&&NE(y.normalMap.format),metalnessMap:In,roughnessMap:pn,anisotropy:wn,anisotropyMap:jt,clearcoat:H,clearcoatMap:P,clearcoatNormalMap:E,clearcoatRoughnessMap:Y,diffuseRoughness:It,diffuseRoughnessMap:ut,dispersion:te,retroreflection:fe,iridescence:wt,iridescenceMap:at,iridescenceThicknessMap:xt,sheen:Ve,sheenColorMap:vt,sheenRoughnessMap:nt,specularMap:rt,specularColorMap:mt,specularIntensityMap:k,transmission:Xt,transmissionMap:ot,thicknessMap:it,gradientMap:Et,opaque:y.transparent===!1&&y.blending===_a&&y.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:$t,combine:y.combine,mapUv:Yt&&d(y.map.channel),aoMapUv:sn&&d(y.aoMap.channel),lightMapUv:Ye&&d(y.lightMap.channel),bumpMapUv:Mn&&d(y.bumpMap.channel),normalMapUv:He&&d(y.normalMap.channel),displacementMapUv:kn&&d(y.displacementMap.channel),emissiveMapUv:Re&&d(y.emissiveMap.channel),metalnessMapUv:In&&d(y.metalnessMap.channel),roughnessMapUv:pn&&d(y.roughnessMap.channel),anisotropyMapUv:jt&&d(y.anisotropyMap.channel),clearcoatMapUv:P&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(y.sheenRoughnessMap.channel),specularMapUv:rt&&d(y.specularMap.channel),specularColorMapUv:mt&&d(y.specularColorMap.channel),specularIntensityMapUv:k&&d(y.specularIntensityMap.channel),transmissionMapUv:ot&&d(y.transmissionMap.channel),thicknessMapUv:it&&d(y.thicknessMap.channel),alphaMapUv:_t&&d(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(He||wn),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Yt||_t),fog:!!X,useFog:y.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&He===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:ft,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:z.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ht,decodeVideoTexture:Yt&&y.map.isVideoTexture===!0&&Ee.getTransfer(y.map.colorSpace)===Ue,decodeVideoTextureEmissive:Re&&y.emissiveMap.isVideoTexture===!0&&Ee.getTransfer(y.emissiveMap.colorSpace)===Ue,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Mi,flipSided:y.side===yi,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:se&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(se&&y.extensions.multiDraw===!0||ue)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return re.vertexUv1s=l.has(1),re.vertexUv2s=l.has(2),re.vertexUv3s=l.has(3),l.clear(),re}function x(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)M.push(U),M.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(p(M,y),m(M,y),M.push(n.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function p(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function m(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let M=f[y.type],U;if(M){let I=Bs[M];U=j0.clone(I.uniforms)}else U=y.uniforms;return U}function w(y,M){let U=h.get(M);return U!==void 0?++U.usedTimes:(U=new LE(n,M,y,s),c.push(U),h.set(M,U)),U}function b(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function S(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:_,acquireProgram:w,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:S}}function FE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function OE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function __(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function x_(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,x,p,m){let _=n[t];return _===void 0?(_={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:x,renderOrder:f.renderOrder,z:p,group:m},n[t]=_):(_.id=f.id,_.object=f,_.geometry=d,_.material=g,_.materialVariant=o(f),_.groupOrder=x,_.renderOrder=f.renderOrder,_.z=p,_.group=m),t++,_}function l(f,d,g,x,p,m,_){_.reversedDepth===!0&&(p=-p);let w=a(f,d,g,x,p,m);g.transmission>0?i.push(w):g.transparent===!0?s.push(w):e.push(w)}function c(f,d,g,x,p,m){let _=a(f,d,g,x,p,m);g.transmission>0?i.unshift(_):g.transparent===!0?s.unshift(_):e.unshift(_)}function h(f,d){e.length>1&&e.sort(f||OE),i.length>1&&i.sort(d||__),s.length>1&&s.sort(d||__)}function u(){for(let f=t,d=n.length;f<d;f++){let g=n[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function BE(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new x_,n.set(i,[o])):s>=r.length?(o=new x_,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function zE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new B,color:new Qt};break;case"SpotLight":e={position:new B,direction:new B,color:new Qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new Qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new Qt,groundColor:new Qt};break;case"RectAreaLight":e={color:new Qt,position:new B,halfWidth:new B,halfHeight:new B};break}return n[t.id]=e,e}}}function kE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var HE=0;function GE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function VE(n){let t=new zE,e=kE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);let s=new B,r=new Me,o=new Me;function a(c){let h=0,u=0,f=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let d=0,g=0,x=0,p=0,m=0,_=0,w=0,b=0,C=0,S=0,y=0,M=0,U=0,I=0;c.sort(GE);for(let z=0,X=c.length;z<X;z++){let N=c[z],V=N.color,Z=N.intensity,W=N.distance,ct=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Fr?ct=N.shadow.map.texture:ct=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=V.r*Z,u+=V.g*Z,f+=V.b*Z;else if(N.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(N.sh.coefficients[$],Z);I++}else if(N.isSunLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let tt=N.shadow,st=e.get(N);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),i.sunShadow[g]=st,i.sunShadowMap[g]=ct;let ft=tt.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[x+dt]=tt.getMatrix(dt),i.sunShadowCascade[x+dt]=tt._cascadeData[dt];x+=ft,g++}i.sun[d]=$,d++}else if(N.isDirectionalLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let tt=N.shadow,st=e.get(N);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize=tt.mapSize,i.directionalShadow[p]=st,i.directionalShadowMap[p]=ct,i.directionalShadowMatrix[p]=N.shadow.matrix,C++}i.directional[p]=$,p++}else if(N.isSpotLight){let $=t.get(N);$.position.setFromMatrixPosition(N.matrixWorld),$.color.copy(V).multiplyScalar(Z),$.distance=W,$.coneCos=Math.cos(N.angle),$.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),$.decay=N.decay,i.spot[_]=$;let tt=N.shadow;if(N.map&&(i.spotLightMap[M]=N.map,M++,tt.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[_]=tt.matrix,N.castShadow){let st=e.get(N);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize=tt.mapSize,i.spotShadow[_]=st,i.spotShadowMap[_]=ct,y++}_++}else if(N.isRectAreaLight){let $=t.get(N);$.color.copy(V).multiplyScalar(Z),$.halfWidth.set(N.width*.5,0,0),$.halfHeight.set(0,N.height*.5,0),i.rectArea[w]=$,w++}else if(N.isPointLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),$.distance=N.distance,$.decay=N.decay,N.castShadow){let tt=N.shadow,st=e.get(N);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize=tt.mapSize,st.shadowCameraNear=tt.camera.near,st.shadowCameraFar=tt.camera.far,i.pointShadow[m]=st,i.pointShadowMap[m]=ct,i.pointShadowMatrix[m]=N.shadow.matrix,S++}i.point[m]=$,m++}else if(N.isHemisphereLight){let $=t.get(N);$.skyColor.copy(N.color).multiplyScalar(Z),$.groundColor.copy(N.groundColor).multiplyScalar(Z),i.hemi[b]=$,b++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Nt.LTC_FLOAT_1,i.rectAreaLTC2=Nt.LTC_FLOAT_2):(i.rectAreaLTC1=Nt.LTC_HALF_1,i.rectAreaLTC2=Nt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;let D=i.hash;(D.sunLength!==d||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==_||D.rectAreaLength!==w||D.hemiLength!==b||D.numSunShadows!==g||D.numDirectionalShadows!==C||D.numPointShadows!==S||D.numSpotShadows!==y||D.numSpotMaps!==M||D.numLightProbes!==I)&&(i.sun.length=d,i.directional.length=p,i.spot.length=_,i.rectArea.length=w,i.point.length=m,i.hemi.length=b,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+M-U,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=I,D.sunLength=d,D.directionalLength=p,D.pointLength=m,D.spotLength=_,D.rectAreaLength=w,D.hemiLength=b,D.numSunShadows=g,D.numDirectionalShadows=C,D.numPointShadows=S,D.numSpotShadows=y,D.numSpotMaps=M,D.numLightProbes=I,i.version=HE++)}function l(c,h){let u=0,f=0,d=0,g=0,x=0,p=0,m=h.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let b=c[_];if(b.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let C=i.directional[f];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),f++}else if(b.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),g++}else if(b.isRectAreaLight){let C=i.rectArea[x];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function y_(n){let t=new VE(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function WE(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new y_(n),t.set(s,[a])):r>=o.length?(a=new y_(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var XE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,qE=`uniform sampler2D shadow_pass;
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
}`,YE=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],$E=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],v_=new Me,kl=new B,xp=new B;function ZE(n,t,e){let i=new eo,s=new qt,r=new qt,o=new fn,a=new Ah,l=new Rh,c={},h=e.maxTextureSize,u={[Ur]:yi,[yi]:Ur,[Mi]:Mi},f=new $i({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qt},radius:{value:4}},vertexShader:XE,fragmentShader:qE}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new Ce;g.setAttribute("position",new en(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ft(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ll;let m=this.type;this.render=function(S,y,M){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||S.length===0)return;this.type===m0&&(Kt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ll);let U=n.getRenderTarget(),I=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),z=n.state;z.setBlending(ao),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let X=m!==this.type;X&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=S.length;N<V;N++){let Z=S[N],W=Z.shadow;if(W===void 0){Kt("WebGLShadowMap:",Z,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ct=W.getFrameExtents();s.multiply(ct),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,W.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=$,W.map===null||X===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===ga){if(Z.isPointLight){Kt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new Oi(s.x,s.y,{format:Fr,type:fs,minFilter:gi,magFilter:gi,generateMipmaps:!1}),W.map.texture.name=Z.name+".shadowMap",W.map.depthTexture=new or(s.x,s.y,Zi),W.map.depthTexture.name=Z.name+".shadowMapDepth",W.map.depthTexture.format=sr,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Yn,W.map.depthTexture.magFilter=Yn}else Z.isPointLight?(W.map=new Gl(s.x),W.map.depthTexture=new El(s.x,us)):(W.map=new Oi(s.x,s.y),W.map.depthTexture=new or(s.x,s.y,us)),W.map.depthTexture.name=Z.name+".shadowMap",W.map.depthTexture.format=sr,this.type===Ll?(W.map.depthTexture.compareFunction=$?rp:sp,W.map.depthTexture.minFilter=gi,W.map.depthTexture.magFilter=gi):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Yn,W.map.depthTexture.magFilter=Yn);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let tt=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Z.isPointLight!==!0&&W.updateMatrices(Z,M);let st=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:M.layers;for(let ft=0;ft<tt;ft++){let dt=W.getCamera(ft);if(Z.isPointLight){let et=W.camera,gt=W.matrix,yt=Z.distance||et.far;yt!==et.far&&(et.far=yt,et.updateProjectionMatrix()),kl.setFromMatrixPosition(Z.matrixWorld),et.position.copy(kl),xp.copy(et.position),xp.add(YE[ft]),et.up.copy($E[ft]),et.lookAt(xp),et.updateMatrixWorld(),gt.makeTranslation(-kl.x,-kl.y,-kl.z),v_.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),W._frustum.setFromProjectionMatrix(v_,et.coordinateSystem,et.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(W.map),n.clear());let et=W.getViewport(ft);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),z.viewport(o)}i=W.getFrustum(ft),b(y,M,dt,Z,st,this.type)}W.isPointLightShadow!==!0&&this.type===ga&&_(W,M),W.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(U,I,D)};function _(S,y){let M=t.update(x);f.defines.VSM_SAMPLES!==S.blurSamples&&(f.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new Oi(s.x,s.y,{format:Fr,type:fs}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),f.uniforms.shadow_pass.value=S.map.depthTexture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(y,null,M,f,x,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(y,null,M,d,x,null)}function w(S,y,M,U){let I=null,D=M.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(D!==void 0)I=D;else if(I=M.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let z=I.uuid,X=y.uuid,N=c[z];N===void 0&&(N={},c[z]=N);let V=N[X];V===void 0&&(V=I.clone(),N[X]=V,y.addEventListener("dispose",C)),I=V}if(I.visible=y.visible,I.wireframe=y.wireframe,U===ga?I.side=y.shadowSide!==null?y.shadowSide:y.side:I.side=y.shadowSide!==null?y.shadowSide:u[y.side],I.alphaMap=y.alphaMap,I.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,I.map=y.map,I.clipShadows=y.clipShadows,I.clippingPlanes=y.clippingPlanes,I.clipIntersection=y.clipIntersection,I.displacementMap=y.displacementMap,I.displacementScale=y.displacementScale,I.displacementBias=y.displacementBias,I.wireframeLinewidth=y.wireframeLinewidth,I.linewidth=y.linewidth,M.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let z=n.properties.get(I);z.light=M}return I}function b(S,y,M,U,I,D){if(S.visible===!1)return;if(S.layers.test(I)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&D===ga)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,S.matrixWorld);let N=t.update(S),V=S.material;if(Array.isArray(V)){let Z=N.groups;for(let W=0,ct=Z.length;W<ct;W++){let $=Z[W],tt=V[$.materialIndex];if(tt&&tt.visible){let st=w(S,tt,U,D);S.onBeforeShadow(n,S,y,M,N,st,$),n.renderBufferDirect(M,null,N,st,S,$),S.onAfterShadow(n,S,y,M,N,st,$)}}}else if(V.visible){let Z=w(S,V,U,D);S.onBeforeShadow(n,S,y,M,N,Z,null),n.renderBufferDirect(M,null,N,Z,S,null),S.onAfterShadow(n,S,y,M,N,Z,null)}}let X=S.children;for(let N=0,V=X.length;N<V;N++)b(X[N],y,M,U,I,D)}function C(S){S.target.removeEventListener("dispose",C);for(let M in c){let U=c[M],I=S.target.uuid;I in U&&(U[I].dispose(),delete U[I])}}}function JE(n,t){function e(){let k=!1,ot=new fn,it=null,Et=new fn(0,0,0,0);return{setMask:function(_t){it!==_t&&!k&&(n.colorMask(_t,_t,_t,_t),it=_t)},setLocked:function(_t){k=_t},setClear:function(_t,St,$t,se,ht){ht===!0&&(_t*=se,St*=se,$t*=se),ot.set(_t,St,$t,se),Et.equals(ot)===!1&&(n.clearColor(_t,St,$t,se),Et.copy(ot))},reset:function(){k=!1,it=null,Et.set(-1,0,0,0)}}}function i(){let k=!1,ot=!1,it=null,Et=null,_t=null;return{setReversed:function(St){if(ot!==St){let $t=t.get("EXT_clip_control");St?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),ot=St;let se=_t;_t=null,this.setClear(se)}},getReversed:function(){return ot},setTest:function(St){St?Mt(n.DEPTH_TEST):Zt(n.DEPTH_TEST)},setMask:function(St){it!==St&&!k&&(n.depthMask(St),it=St)},setFunc:function(St){if(ot&&(St=$0[St]),Et!==St){switch(St){case ch:n.depthFunc(n.NEVER);break;case hh:n.depthFunc(n.ALWAYS);break;case uh:n.depthFunc(n.LESS);break;case ra:n.depthFunc(n.LEQUAL);break;case fh:n.depthFunc(n.EQUAL);break;case dh:n.depthFunc(n.GEQUAL);break;case ph:n.depthFunc(n.GREATER);break;case mh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=St}},setLocked:function(St){k=St},setClear:function(St){_t!==St&&(_t=St,ot&&(St=1-St),n.clearDepth(St))},reset:function(){k=!1,it=null,Et=null,_t=null,ot=!1}}}function s(){let k=!1,ot=null,it=null,Et=null,_t=null,St=null,$t=null,se=null,ht=null;return{setTest:function(Gt){k||(Gt?Mt(n.STENCIL_TEST):Zt(n.STENCIL_TEST))},setMask:function(Gt){ot!==Gt&&!k&&(n.stencilMask(Gt),ot=Gt)},setFunc:function(Gt,re,Ct){(it!==Gt||Et!==re||_t!==Ct)&&(n.stencilFunc(Gt,re,Ct),it=Gt,Et=re,_t=Ct)},setOp:function(Gt,re,Ct){(St!==Gt||$t!==re||se!==Ct)&&(n.stencilOp(Gt,re,Ct),St=Gt,$t=re,se=Ct)},setLocked:function(Gt){k=Gt},setClear:function(Gt){ht!==Gt&&(n.clearStencil(Gt),ht=Gt)},reset:function(){k=!1,ot=null,it=null,Et=null,_t=null,St=null,$t=null,se=null,ht=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,g=[],x=null,p=!1,m=null,_=null,w=null,b=null,C=null,S=null,y=null,M=new Qt(0,0,0),U=0,I=!1,D=null,z=null,X=null,N=null,V=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ct=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec($)[1]),W=ct>=1):$.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),W=ct>=2);let tt=null,st={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),et=new fn().fromArray(ft),gt=new fn().fromArray(dt);function yt(k,ot,it,Et){let _t=new Uint8Array(4),St=n.createTexture();n.bindTexture(k,St),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $t=0;$t<it;$t++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(ot+$t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return St}let Rt={};Rt[n.TEXTURE_2D]=yt(n.TEXTURE_2D,n.TEXTURE_2D,1),Rt[n.TEXTURE_CUBE_MAP]=yt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Rt[n.TEXTURE_2D_ARRAY]=yt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Rt[n.TEXTURE_3D]=yt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(ra),Mn(!1),He(Nd),Mt(n.CULL_FACE),sn(ao);function Mt(k){h[k]!==!0&&(n.enable(k),h[k]=!0)}function Zt(k){h[k]!==!1&&(n.disable(k),h[k]=!1)}function ue(k,ot){return f[k]!==ot?(n.bindFramebuffer(k,ot),f[k]=ot,k===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=ot),k===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function Yt(k,ot){let it=g,Et=!1;if(k){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let _t=k.textures;if(it.length!==_t.length||it[0]!==n.COLOR_ATTACHMENT0){for(let St=0,$t=_t.length;St<$t;St++)it[St]=n.COLOR_ATTACHMENT0+St;it.length=_t.length,Et=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Et=!0);Et&&n.drawBuffers(it)}function _e(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let pe={[lo]:n.FUNC_ADD,[_0]:n.FUNC_SUBTRACT,[x0]:n.FUNC_REVERSE_SUBTRACT};pe[y0]=n.MIN,pe[v0]=n.MAX;let ce={[b0]:n.ZERO,[S0]:n.ONE,[M0]:n.SRC_COLOR,[Bd]:n.SRC_ALPHA,[C0]:n.SRC_ALPHA_SATURATE,[A0]:n.DST_COLOR,[E0]:n.DST_ALPHA,[w0]:n.ONE_MINUS_SRC_COLOR,[zd]:n.ONE_MINUS_SRC_ALPHA,[R0]:n.ONE_MINUS_DST_COLOR,[T0]:n.ONE_MINUS_DST_ALPHA,[P0]:n.CONSTANT_COLOR,[I0]:n.ONE_MINUS_CONSTANT_COLOR,[L0]:n.CONSTANT_ALPHA,[D0]:n.ONE_MINUS_CONSTANT_ALPHA};function sn(k,ot,it,Et,_t,St,$t,se,ht,Gt){if(k===ao){p===!0&&(Zt(n.BLEND),p=!1);return}if(p===!1&&(Mt(n.BLEND),p=!0),k!==g0){if(k!==m||Gt!==I){if((_!==lo||C!==lo)&&(n.blendEquation(n.FUNC_ADD),_=lo,C=lo),Gt)switch(k){case _a:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ud:n.blendFunc(n.ONE,n.ONE);break;case Fd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Od:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ie("WebGLState: Invalid blending: ",k);break}else switch(k){case _a:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ud:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Fd:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Od:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",k);break}w=null,b=null,S=null,y=null,M.set(0,0,0),U=0,m=k,I=Gt}return}_t=_t||ot,St=St||it,$t=$t||Et,(ot!==_||_t!==C)&&(n.blendEquationSeparate(pe[ot],pe[_t]),_=ot,C=_t),(it!==w||Et!==b||St!==S||$t!==y)&&(n.blendFuncSeparate(ce[it],ce[Et],ce[St],ce[$t]),w=it,b=Et,S=St,y=$t),(se.equals(M)===!1||ht!==U)&&(n.blendColor(se.r,se.g,se.b,ht),M.copy(se),U=ht),m=k,I=!1}function Ye(k,ot){k.side===Mi?Zt(n.CULL_FACE):Mt(n.CULL_FACE);let it=k.side===yi;ot&&(it=!it),Mn(it),k.blending===_a&&k.transparent===!1?sn(ao):sn(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Et=k.stencilWrite;a.setTest(Et),Et&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Re(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Zt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Mn(k){D!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),D=k)}function He(k){k!==d0?(Mt(n.CULL_FACE),k!==z&&(k===Nd?n.cullFace(n.BACK):k===p0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Zt(n.CULL_FACE),z=k}function kn(k){k!==X&&(W&&n.lineWidth(k),X=k)}function Re(k,ot,it){k?(Mt(n.POLYGON_OFFSET_FILL),(N!==ot||V!==it)&&(N=ot,V=it,o.getReversed()&&(ot=-ot,it=-it),n.polygonOffset(ot,it))):Zt(n.POLYGON_OFFSET_FILL)}function In(k){k?Mt(n.SCISSOR_TEST):Zt(n.SCISSOR_TEST)}function pn(k){k===void 0&&(k=n.TEXTURE0+Z-1),tt!==k&&(n.activeTexture(k),tt=k)}function wn(k,ot,it){it===void 0&&(tt===null?it=n.TEXTURE0+Z-1:it=tt);let Et=st[it];Et===void 0&&(Et={type:void 0,texture:void 0},st[it]=Et),(Et.type!==k||Et.texture!==ot)&&(tt!==it&&(n.activeTexture(it),tt=it),n.bindTexture(k,ot||Rt[k]),Et.type=k,Et.texture=ot)}function H(){let k=st[tt];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function It(){try{n.compressedTexImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function te(){try{n.compressedTexImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function fe(){try{n.texSubImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function wt(){try{n.texSubImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function Ve(){try{n.compressedTexSubImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function Xt(){try{n.compressedTexSubImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function jt(){try{n.texStorage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function P(){try{n.texStorage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function E(){try{n.texImage2D(...arguments)}catch(k){ie("WebGLState:",k)}}function Y(){try{n.texImage3D(...arguments)}catch(k){ie("WebGLState:",k)}}function ut(k){return u[k]!==void 0?u[k]:n.getParameter(k)}function at(k,ot){u[k]!==ot&&(n.pixelStorei(k,ot),u[k]=ot)}function xt(k){et.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),et.copy(k))}function vt(k){gt.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),gt.copy(k))}function nt(k,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let Et=it.get(k);Et===void 0&&(Et=n.getUniformBlockIndex(ot,k.name),n.uniformBlockBinding(ot,Et,Et),it.set(k,Et))}function rt(k,ot,it){let _t=c.get(ot).get(k);l[_t]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,it),l[_t]=it)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},tt=null,st={},f={},l={},d=new WeakMap,g=[],x=null,p=!1,m=null,_=null,w=null,b=null,C=null,S=null,y=null,M=new Qt(0,0,0),U=0,I=!1,D=null,z=null,X=null,N=null,V=null,et.set(0,0,n.canvas.width,n.canvas.height),gt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Zt,bindFramebuffer:ue,drawBuffers:Yt,useProgram:_e,setBlending:sn,setMaterial:Ye,setFlipSided:Mn,setCullFace:He,setLineWidth:kn,setPolygonOffset:Re,setScissorTest:In,activeTexture:pn,bindTexture:wn,unbindTexture:H,compressedTexImage2D:It,compressedTexImage3D:te,texImage2D:E,texImage3D:Y,pixelStorei:at,getParameter:ut,updateUBOMapping:nt,uniformBlockBinding:rt,texStorage2D:jt,texStorage3D:P,texSubImage2D:fe,texSubImage3D:wt,compressedTexSubImage2D:Ve,compressedTexSubImage3D:Xt,scissor:xt,viewport:vt,reset:mt}}function jE(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new qt,h=new WeakMap,u=new Set,f,d=new WeakMap,g=new Set,x=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,E){return p?new OffscreenCanvas(P,E):fl("canvas")}function _(P,E,Y){let ut=1,at=jt(P);if((at.width>Y||at.height>Y)&&(ut=Y/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let xt=Math.floor(ut*at.width),vt=Math.floor(ut*at.height);f===void 0&&(f=m(xt,vt));let nt=E?m(xt,vt):f;return nt.width=xt,nt.height=vt,nt.getContext("2d").drawImage(P,0,0,xt,vt),Kt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+xt+"x"+vt+")."),nt}else return"data"in P&&Kt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),P;return P}function w(P){return P.generateMipmaps}function b(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(P,E,Y,ut,at,xt=!1){if(P!==null){if(n[P]!==void 0)return n[P];Kt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let vt;ut&&(vt=t.get("EXT_texture_norm16"),vt||Kt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=E;if(E===n.RED&&(Y===n.FLOAT&&(nt=n.R32F),Y===n.HALF_FLOAT&&(nt=n.R16F),Y===n.UNSIGNED_BYTE&&(nt=n.R8),Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.R16_EXT),Y===n.SHORT&&vt&&(nt=vt.R16_SNORM_EXT)),E===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.R8UI),Y===n.UNSIGNED_SHORT&&(nt=n.R16UI),Y===n.UNSIGNED_INT&&(nt=n.R32UI),Y===n.BYTE&&(nt=n.R8I),Y===n.SHORT&&(nt=n.R16I),Y===n.INT&&(nt=n.R32I)),E===n.RG&&(Y===n.FLOAT&&(nt=n.RG32F),Y===n.HALF_FLOAT&&(nt=n.RG16F),Y===n.UNSIGNED_BYTE&&(nt=n.RG8),Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.RG16_EXT),Y===n.SHORT&&vt&&(nt=vt.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RG8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RG16UI),Y===n.UNSIGNED_INT&&(nt=n.RG32UI),Y===n.BYTE&&(nt=n.RG8I),Y===n.SHORT&&(nt=n.RG16I),Y===n.INT&&(nt=n.RG32I)),E===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),Y===n.UNSIGNED_INT&&(nt=n.RGB32UI),Y===n.BYTE&&(nt=n.RGB8I),Y===n.SHORT&&(nt=n.RGB16I),Y===n.INT&&(nt=n.RGB32I)),E===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),Y===n.UNSIGNED_INT&&(nt=n.RGBA32UI),Y===n.BYTE&&(nt=n.RGBA8I),Y===n.SHORT&&(nt=n.RGBA16I),Y===n.INT&&(nt=n.RGBA32I)),E===n.RGB&&(Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGB16_EXT),Y===n.SHORT&&vt&&(nt=vt.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),E===n.RGBA){let rt=xt?hl:Ee.getTransfer(at);Y===n.FLOAT&&(nt=n.RGBA32F),Y===n.HALF_FLOAT&&(nt=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(nt=rt===Ue?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGBA16_EXT),Y===n.SHORT&&vt&&(nt=vt.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function y(P,E){let Y;return P?E===null||E===us||E===ho?Y=n.DEPTH24_STENCIL8:E===Zi?Y=n.DEPTH32F_STENCIL8:E===ya&&(Y=n.DEPTH24_STENCIL8,Kt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===us||E===ho?Y=n.DEPTH_COMPONENT24:E===Zi?Y=n.DEPTH_COMPONENT32F:E===ya&&(Y=n.DEPTH_COMPONENT16),Y}function M(P,E){return w(P)===!0||P.isFramebufferTexture&&P.minFilter!==Yn&&P.minFilter!==gi?Math.log2(Math.max(E.width,E.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?E.mipmaps.length:1}function U(P){let E=new WeakRef(P);i.get(P).__ref=E,g.add(E),x.register(P,E,E)}function I(P){let E=i.get(P).__ref;E!==void 0&&(g.delete(E),x.unregister(E))}function D(P){X(P.target)}function z(P){N(P.target)}function X(P){P.removeEventListener("dispose",D),I(P),Z(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function N(P){P.removeEventListener("dispose",z),I(P),ct(P)}function V(){for(let P of g){let E=P.deref();E!==void 0&&(E.isRenderTarget===!0?N(E):X(E))}g.clear(),u.clear()}function Z(P){let E=i.get(P);if(E.__webglInit===void 0)return;let Y=P.source,ut=d.get(Y);if(ut){let at=ut[E.__cacheKey];at.usedTimes--,at.usedTimes===0&&W(P),Object.keys(ut).length===0&&d.delete(Y)}i.remove(P)}function W(P){let E=i.get(P);n.deleteTexture(E.__webglTexture);let Y=P.source,ut=d.get(Y);delete ut[E.__cacheKey],o.memory.textures--}function ct(P){let E=i.get(P);E.__depthDisposeCallback&&E.__depthDisposeCallback();let Y=P.depthTexture;if(Y&&Y.renderTarget===P&&X(Y),P.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(E.__webglFramebuffer[at]))for(let xt=0;xt<E.__webglFramebuffer[at].length;xt++)n.deleteFramebuffer(E.__webglFramebuffer[at][xt]);else n.deleteFramebuffer(E.__webglFramebuffer[at]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[at])}else{if(Array.isArray(E.__webglFramebuffer))for(let at=0;at<E.__webglFramebuffer.length;at++)n.deleteFramebuffer(E.__webglFramebuffer[at]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let at=0;at<E.__webglColorRenderbuffer.length;at++)E.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[at]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ut=P.textures;for(let at=0,xt=ut.length;at<xt;at++){let vt=i.get(ut[at]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ut[at])}i.remove(P)}let $=0;function tt(){$=0}function st(){return $}function ft(P){$=P}function dt(){let P=$;return P>=s.maxTextures&&Kt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,P}function et(P){let E=[];return E.push(P.wrapS),E.push(P.wrapT),E.push(P.wrapR||0),E.push(P.magFilter),E.push(P.minFilter),E.push(P.anisotropy),E.push(P.internalFormat),E.push(P.format),E.push(P.type),E.push(P.generateMipmaps),E.push(P.mipmapsAutoUpdate),E.push(P.premultiplyAlpha),E.push(P.flipY),E.push(P.unpackAlignment),E.push(P.colorSpace),E.join()}function gt(P,E){let Y=i.get(P);if(P.isVideoTexture&&Ve(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&Y.__version!==P.version){let ut=P.image;if(ut===null)Kt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Kt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ye(Y,P,E);return}}else P.isExternalTexture&&(Y.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+E)}function yt(P,E){let Y=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){Ye(Y,P,E);return}else P.isExternalTexture&&(Y.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+E)}function Rt(P,E){let Y=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){Ye(Y,P,E);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+E)}function Mt(P,E){let Y=i.get(P);if(P.version>0&&Y.__version!==P.version){Mn(Y,P,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+E)}let Zt={[gh]:n.REPEAT,[Is]:n.CLAMP_TO_EDGE,[_h]:n.MIRRORED_REPEAT},ue={[Yn]:n.NEAREST,[F0]:n.NEAREST_MIPMAP_NEAREST,[Dl]:n.NEAREST_MIPMAP_LINEAR,[gi]:n.LINEAR,[Vh]:n.LINEAR_MIPMAP_NEAREST,[lr]:n.LINEAR_MIPMAP_LINEAR},Yt={[k0]:n.NEVER,[op]:n.ALWAYS,[H0]:n.LESS,[sp]:n.LEQUAL,[G0]:n.EQUAL,[rp]:n.GEQUAL,[V0]:n.GREATER,[W0]:n.NOTEQUAL};function _e(P,E){if(E.type===Zi&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===gi||E.magFilter===Vh||E.magFilter===Dl||E.magFilter===lr||E.minFilter===gi||E.minFilter===Vh||E.minFilter===Dl||E.minFilter===lr)&&Kt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Zt[E.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Zt[E.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Zt[E.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ue[E.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ue[E.minFilter]),E.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Yt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Yn||E.minFilter!==Dl&&E.minFilter!==lr||E.type===Zi&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function pe(P,E){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,E.addEventListener("dispose",D),U(E));let ut=E.source,at=d.get(ut);at===void 0&&(at={},d.set(ut,at));let xt=et(E);if(xt!==P.__cacheKey){at[xt]===void 0&&(at[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[xt].usedTimes++;let vt=at[P.__cacheKey];vt!==void 0&&(at[P.__cacheKey].usedTimes--,vt.usedTimes===0&&W(E)),P.__cacheKey=xt,P.__webglTexture=at[xt].texture}return Y}function ce(P,E,Y){return Math.floor(Math.floor(P/Y)/E)}function sn(P,E,Y,ut){let xt=P.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,Y,ut,E.data);else{xt.sort((k,ot)=>k.start-ot.start);let vt=0;for(let k=1;k<xt.length;k++){let ot=xt[vt],it=xt[k],Et=ot.start+ot.count,_t=ce(it.start,E.width,4),St=ce(ot.start,E.width,4);it.start<=Et+1&&_t===St&&ce(it.start+it.count-1,E.width,4)===_t?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++vt,xt[vt]=it)}xt.length=vt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let k=0,ot=xt.length;k<ot;k++){let it=xt[k],Et=Math.floor(it.start/4),_t=Math.ceil(it.count/4),St=Et%E.width,$t=Math.floor(Et/E.width),se=_t,ht=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,St),e.pixelStorei(n.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(n.TEXTURE_2D,0,St,$t,se,ht,Y,ut,E.data)}P.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ye(P,E,Y){let ut=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ut=n.TEXTURE_3D);let at=pe(P,E),xt=E.source;e.bindTexture(ut,P.__webglTexture,n.TEXTURE0+Y);let vt=i.get(xt);if(xt.version!==vt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ht=Ee.getPrimaries(Ee.workingColorSpace),Gt=E.colorSpace===hr?null:Ee.getPrimaries(E.colorSpace),re=E.colorSpace===hr||ht===Gt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re)}e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let rt=_(E.image,!1,s.maxTextureSize);rt=Xt(E,rt);let mt=r.convert(E.format,E.colorSpace),k=r.convert(E.type),ot=S(E.internalFormat,mt,k,E.normalized,E.colorSpace,E.isVideoTexture);_e(ut,E);let it,Et=E.mipmaps,_t=E.isVideoTexture!==!0,St=vt.__version===void 0||at===!0,$t=xt.dataReady,se=M(E,rt);if(E.isDepthTexture)ot=y(E.format===cr,E.type),St&&(_t?e.texStorage2D(n.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,mt,k,null));else if(E.isDataTexture)if(Et.length>0){_t&&St&&e.texStorage2D(n.TEXTURE_2D,se,ot,Et[0].width,Et[0].height);for(let ht=0,Gt=Et.length;ht<Gt;ht++)it=Et[ht],_t?$t&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,k,it.data):e.texImage2D(n.TEXTURE_2D,ht,ot,it.width,it.height,0,mt,k,it.data);E.generateMipmaps=!1}else _t?(St&&e.texStorage2D(n.TEXTURE_2D,se,ot,rt.width,rt.height),$t&&sn(E,rt,mt,k)):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,mt,k,rt.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){_t&&St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,se,ot,Et[0].width,Et[0].height,rt.depth);for(let ht=0,Gt=Et.length;ht<Gt;ht++)if(it=Et[ht],E.format!==ds)if(mt!==null)if(_t){if($t)if(E.layerUpdates.size>0){let re=gp(it.width,it.height,E.format,E.type);for(let Ct of E.layerUpdates){let de=it.data.subarray(Ct*re/it.data.BYTES_PER_ELEMENT,(Ct+1)*re/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,Ct,it.width,it.height,1,mt,de)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,rt.depth,mt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ht,ot,it.width,it.height,rt.depth,0,it.data,0,0);else Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?$t&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,rt.depth,mt,k,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ht,ot,it.width,it.height,rt.depth,0,mt,k,it.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(n.TEXTURE_2D,se,ot,Et[0].width,Et[0].height);for(let ht=0,Gt=Et.length;ht<Gt;ht++)it=Et[ht],E.format!==ds?mt!==null?_t?$t&&e.compressedTexSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ht,ot,it.width,it.height,0,it.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?$t&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,k,it.data):e.texImage2D(n.TEXTURE_2D,ht,ot,it.width,it.height,0,mt,k,it.data)}else if(E.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,se,ot,rt.width,rt.height,rt.depth),$t)if(E.layerUpdates.size>0){let ht=gp(rt.width,rt.height,E.format,E.type);for(let Gt of E.layerUpdates){let re=rt.data.subarray(Gt*ht/rt.data.BYTES_PER_ELEMENT,(Gt+1)*ht/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Gt,rt.width,rt.height,1,mt,k,re)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,mt,k,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,mt,k,rt.data);else if(E.isData3DTexture)_t?(St&&e.texStorage3D(n.TEXTURE_3D,se,ot,rt.width,rt.height,rt.depth),$t&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,mt,k,rt.data)):e.texImage3D(n.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,mt,k,rt.data);else if(E.isFramebufferTexture){if(St)if(_t)e.texStorage2D(n.TEXTURE_2D,se,ot,rt.width,rt.height);else{let ht=rt.width,Gt=rt.height;for(let re=0;re<se;re++)e.texImage2D(n.TEXTURE_2D,re,ot,ht,Gt,0,mt,k,null),ht>>=1,Gt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let ht=n.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),rt.parentNode!==ht){ht.appendChild(rt),u.add(E),ht.onpaint=Gt=>{let re=Gt.changedElements;for(let Ct of u)re.includes(Ct.image)&&(Ct.needsUpdate=!0)},ht.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let re=n.RGBA,Ct=n.RGBA,de=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,re,Ct,de,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&St){let ht=jt(Et[0]);e.texStorage2D(n.TEXTURE_2D,se,ot,ht.width,ht.height)}for(let ht=0,Gt=Et.length;ht<Gt;ht++)it=Et[ht],_t?$t&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,mt,k,it):e.texImage2D(n.TEXTURE_2D,ht,ot,mt,k,it);E.generateMipmaps=!1}else if(_t){if(St){let ht=jt(rt);e.texStorage2D(n.TEXTURE_2D,se,ot,ht.width,ht.height)}$t&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,k,rt)}else e.texImage2D(n.TEXTURE_2D,0,ot,mt,k,rt);w(E)&&E.mipmapsAutoUpdate===!0&&b(ut),vt.__version=xt.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function Mn(P,E,Y){if(E.image.length!==6)return;let ut=pe(P,E),at=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+Y);let xt=i.get(at);if(at.version!==xt.__version||ut===!0){e.activeTexture(n.TEXTURE0+Y);let vt=Ee.getPrimaries(Ee.workingColorSpace),nt=E.colorSpace===hr?null:Ee.getPrimaries(E.colorSpace),rt=E.colorSpace===hr||vt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let mt=E.isCompressedTexture||E.image[0].isCompressedTexture,k=E.image[0]&&E.image[0].isDataTexture,ot=[];for(let Ct=0;Ct<6;Ct++)!mt&&!k?ot[Ct]=_(E.image[Ct],!0,s.maxCubemapSize):ot[Ct]=k?E.image[Ct].image:E.image[Ct],ot[Ct]=Xt(E,ot[Ct]);let it=ot[0],Et=r.convert(E.format,E.colorSpace),_t=r.convert(E.type),St=S(E.internalFormat,Et,_t,E.normalized,E.colorSpace),$t=E.isVideoTexture!==!0,se=xt.__version===void 0||ut===!0,ht=at.dataReady,Gt=M(E,it);_e(n.TEXTURE_CUBE_MAP,E);let re;if(E.isDepthTexture){if(St=y(E.format===cr,E.type),se)if($t)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,St,it.width,it.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,it.width,it.height,0,Et,_t,null)}else if(mt){$t&&se&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,St,it.width,it.height);for(let Ct=0;Ct<6;Ct++){re=ot[Ct].mipmaps;for(let de=0;de<re.length;de++){let Je=re[de];E.format!==ds?Et!==null?$t?ht&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,0,0,Je.width,Je.height,Et,Je.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,St,Je.width,Je.height,0,Je.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,0,0,Je.width,Je.height,Et,_t,Je.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,St,Je.width,Je.height,0,Et,_t,Je.data)}}}else{if(re=E.mipmaps,$t&&se){re.length>0&&Gt++;let Ct=jt(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(k){$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,ot[Ct].width,ot[Ct].height,Et,_t,ot[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,ot[Ct].width,ot[Ct].height,0,Et,_t,ot[Ct].data);for(let de=0;de<re.length;de++){let ai=re[de].image[Ct].image;$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,0,0,ai.width,ai.height,Et,_t,ai.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,St,ai.width,ai.height,0,Et,_t,ai.data)}}else{$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,_t,ot[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Et,_t,ot[Ct]);for(let de=0;de<re.length;de++){let Je=re[de];$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,0,0,Et,_t,Je.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,St,Et,_t,Je.image[Ct])}}}w(E)&&E.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),xt.__version=at.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function He(P,E,Y,ut,at,xt){let vt=r.convert(Y.format,Y.colorSpace),nt=r.convert(Y.type),rt=S(Y.internalFormat,vt,nt,Y.normalized,Y.colorSpace),mt=i.get(E),k=i.get(Y);if(k.__renderTarget=E,!mt.__hasExternalTextures){let ot=Math.max(1,E.width>>xt),it=Math.max(1,E.height>>xt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,xt,rt,ot,it,E.depth,0,vt,nt,null):e.texImage2D(at,xt,rt,ot,it,0,vt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,at,k.__webglTexture,0,fe(E)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,at,k.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function kn(P,E,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,P),E.depthBuffer){let ut=E.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,xt=y(E.stencilBuffer,at),vt=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(E),xt,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(E),xt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,xt,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,P)}else{let ut=E.textures;for(let at=0;at<ut.length;at++){let xt=ut[at],vt=r.convert(xt.format,xt.colorSpace),nt=r.convert(xt.type),rt=S(xt.internalFormat,vt,nt,xt.normalized,xt.colorSpace);wt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(E),rt,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(E),rt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,rt,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Re(P,E,Y){let ut=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(E.depthTexture);at.__renderTarget=E;let xt=ut?E.depthTexture.image[0]:E.depthTexture.image;(!at.__webglTexture||xt.width!==E.width||xt.height!==E.height)&&(xt.width=E.width,xt.height=E.height,E.depthTexture.needsUpdate=!0),ut?Mt(E.depthTexture,0):gt(E.depthTexture,0);let vt=at.__webglTexture,nt=fe(E),rt=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,mt=E.depthTexture.format===cr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===sr)wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,rt,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,rt,vt,0);else if(E.depthTexture.format===cr)wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,rt,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,rt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function In(P){let E=i.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==P.depthTexture){let ut=P.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ut){let at=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),E.__depthDisposeCallback=at}E.__boundDepthTexture=ut}if(P.depthTexture&&!E.__autoAllocateDepthBuffer)if(Y)for(let ut=0;ut<6;ut++)Re(E.__webglFramebuffer[ut],P,ut);else P.texture.mipmaps.length>0?Re(E.__webglFramebuffer[0],P,0):Re(E.__webglFramebuffer,P,0);else if(Y){E.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[ut]),E.__webglDepthbuffer[ut]===void 0)E.__webglDepthbuffer[ut]=n.createRenderbuffer(),kn(E.__webglDepthbuffer[ut],P,!1);else{let at=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=E.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),kn(E.__webglDepthbuffer,P,!1);else{let at=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function pn(P,E,Y){let ut=i.get(P);E!==void 0&&He(ut.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&In(P)}function wn(P){let E=P.texture,Y=i.get(P),ut=i.get(E);P.addEventListener("dispose",z),U(P);let at=P.textures,xt=P.isWebGLCubeRenderTarget===!0,vt=at.length>1;if(vt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=E.version,o.memory.textures++),xt){Y.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0){Y.__webglFramebuffer[nt]=[];for(let rt=0;rt<E.mipmaps.length;rt++)Y.__webglFramebuffer[nt][rt]=n.createFramebuffer()}else Y.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(E.mipmaps.length>0){Y.__webglFramebuffer=[];for(let nt=0;nt<E.mipmaps.length;nt++)Y.__webglFramebuffer[nt]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(vt)for(let nt=0,rt=at.length;nt<rt;nt++){let mt=i.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&wt(P)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let rt=at[nt];Y.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[nt]);let mt=r.convert(rt.format,rt.colorSpace),k=r.convert(rt.type),ot=S(rt.internalFormat,mt,k,rt.normalized,rt.colorSpace,P.isXRRenderTarget===!0),it=fe(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,ot,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,Y.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),kn(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),_e(n.TEXTURE_CUBE_MAP,E);for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0)for(let rt=0;rt<E.mipmaps.length;rt++)He(Y.__webglFramebuffer[nt][rt],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,rt);else He(Y.__webglFramebuffer[nt],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);w(E)?b(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let nt=0,rt=at.length;nt<rt;nt++){let mt=at[nt],k=i.get(mt),ot=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ot=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,k.__webglTexture),_e(ot,mt),He(Y.__webglFramebuffer,P,mt,n.COLOR_ATTACHMENT0+nt,ot,0),w(mt)&&b(ot)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(nt=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,ut.__webglTexture),_e(nt,E),E.mipmaps.length>0)for(let rt=0;rt<E.mipmaps.length;rt++)He(Y.__webglFramebuffer[rt],P,E,n.COLOR_ATTACHMENT0,nt,rt);else He(Y.__webglFramebuffer,P,E,n.COLOR_ATTACHMENT0,nt,0);w(E)?b(nt):E.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&In(P)}function H(P){let E=P.textures;for(let Y=0,ut=E.length;Y<ut;Y++){let at=E[Y];if(w(at)&&at.mipmapsAutoUpdate===!0){let xt=C(P),vt=i.get(at).__webglTexture;e.bindTexture(xt,vt),b(xt),e.unbindTexture()}}}let It=[];function te(P){if(P.samples>0){if(wt(P)===!1){let E=P.textures,Y=P.width,ut=P.height,at=n.COLOR_BUFFER_BIT,xt=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(P),nt=E.length>1;if(nt)for(let mt=0;mt<E.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let mt=0;mt<E.length;mt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[mt]);let k=i.get(E[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,Y,ut,0,0,Y,ut,at,n.NEAREST),l===!0&&(It.length=0,It.push(n.COLOR_ATTACHMENT0+mt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&It.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,It))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<E.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[mt]);let k=i.get(E[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,k,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let E=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function fe(P){return Math.min(s.maxSamples,P.samples)}function wt(P){let E=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Ve(P){let E=o.render.frame;h.get(P)!==E&&(h.set(P,E),P.update())}function Xt(P,E){let Y=P.colorSpace,ut=P.format,at=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==cl&&Y!==hr&&(Ee.getTransfer(Y)===Ue?(ut!==ds||at!==zi)&&Kt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",Y)),E}function jt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=tt,this.getTextureUnits=st,this.setTextureUnits=ft,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Rt,this.setTextureCube=Mt,this.rebindTextures=pn,this.setupRenderTarget=wn,this.updateRenderTargetMipmap=H,this.updateMultisampleRenderTarget=te,this.setupDepthRenderbuffer=In,this.setupFrameBufferTexture=He,this.useMultisampledRTT=wt,this.dispose=V}function KE(n,t){function e(i,s=hr){let r,o=Ee.getTransfer(s);if(i===zi)return n.UNSIGNED_BYTE;if(i===Xh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===qh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===jd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Kd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Zd)return n.BYTE;if(i===Jd)return n.SHORT;if(i===ya)return n.UNSIGNED_SHORT;if(i===Wh)return n.INT;if(i===us)return n.UNSIGNED_INT;if(i===Zi)return n.FLOAT;if(i===fs)return n.HALF_FLOAT;if(i===Qd)return n.ALPHA;if(i===tp)return n.RGB;if(i===ds)return n.RGBA;if(i===sr)return n.DEPTH_COMPONENT;if(i===cr)return n.DEPTH_STENCIL;if(i===Yh)return n.RED;if(i===$h)return n.RED_INTEGER;if(i===Fr)return n.RG;if(i===Zh)return n.RG_INTEGER;if(i===Jh)return n.RGBA_INTEGER;if(i===Nl||i===Ul||i===Fl||i===Ol)if(o===Ue)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Nl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Nl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ul)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Fl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ol)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===jh||i===Kh||i===Qh||i===tu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===jh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Kh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Qh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===tu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===eu||i===nu||i===iu||i===su||i===ru||i===Bl||i===ou)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===eu||i===nu)return o===Ue?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===iu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===su)return r.COMPRESSED_R11_EAC;if(i===ru)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Bl)return r.COMPRESSED_RG11_EAC;if(i===ou)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===au||i===lu||i===cu||i===hu||i===uu||i===fu||i===du||i===pu||i===mu||i===gu||i===_u||i===xu||i===yu||i===vu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===au)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===lu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===cu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===hu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===uu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===fu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===du)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===pu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===mu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===gu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===_u)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===xu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===yu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===vu)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===bu||i===Su||i===Mu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===bu)return o===Ue?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Su)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Mu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===wu||i===Eu||i===zl||i===Tu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===wu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===zl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ho?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var QE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,tT=`
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

}`,Ep=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Tl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new $i({vertexShader:QE,fragmentShader:tT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ft(new so(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Tp=class extends ls{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,g=null,x=typeof XRWebGLBinding<"u",p=new Ep,m={},_=e.getContextAttributes(),w=null,b=null,C=[],S=[],y=new qt,M=null,U=null,I=new mi;I.viewport=new fn;let D=new mi;D.viewport=new fn;let z=[I,D],X=new kh,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let gt=C[et];return gt===void 0&&(gt=new ha,C[et]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(et){let gt=C[et];return gt===void 0&&(gt=new ha,C[et]=gt),gt.getGripSpace()},this.getHand=function(et){let gt=C[et];return gt===void 0&&(gt=new ha,C[et]=gt),gt.getHandSpace()};function Z(et){let gt=S.indexOf(et.inputSource);if(gt===-1)return;let yt=C[gt];yt!==void 0&&(yt.update(et.inputSource,et.frame,c||o),yt.dispatchEvent({type:et.type,data:et.inputSource}))}function W(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ct);for(let et=0;et<C.length;et++){let gt=S[et];gt!==null&&(S[et]=null,C[et].disconnect(gt))}N=null,V=null,p.reset();for(let et in m)delete m[et];if(t.setRenderTarget(w),d=null,f=null,u=null,s=null,b=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(y.width,y.height,!1),U!==null){let et=U.camera;et.fov=U.fov,et.zoom=U.zoom,et.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,i.isPresenting===!0&&Kt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,i.isPresenting===!0&&Kt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ct),_.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Rt=null,Mt=null;_.depth&&(Mt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=_.stencil?cr:sr,Rt=_.stencil?ho:us);let Zt={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Zt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),b=new Oi(f.textureWidth,f.textureHeight,{format:ds,type:zi,depthTexture:new or(f.textureWidth,f.textureHeight,Rt,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let yt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new Oi(d.framebufferWidth,d.framebufferHeight,{format:ds,type:zi,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ct(et){for(let gt=0;gt<et.removed.length;gt++){let yt=et.removed[gt],Rt=S.indexOf(yt);Rt>=0&&(S[Rt]=null,C[Rt].disconnect(yt))}for(let gt=0;gt<et.added.length;gt++){let yt=et.added[gt],Rt=S.indexOf(yt);if(Rt===-1){for(let Zt=0;Zt<C.length;Zt++)if(Zt>=S.length){S.push(yt),Rt=Zt;break}else if(S[Zt]===null){S[Zt]=yt,Rt=Zt;break}if(Rt===-1)break}let Mt=C[Rt];Mt&&Mt.connect(yt)}}function $(et,gt){gt===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(gt.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let gt=et.near,yt=et.far;p.texture!==null&&(p.depthNear>0&&(gt=p.depthNear),p.depthFar>0&&(yt=p.depthFar)),X.near=D.near=I.near=gt,X.far=D.far=I.far=yt,(N!==X.near||V!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),N=X.near,V=X.far),X.layers.mask=et.layers.mask|6,I.layers.mask=X.layers.mask&-5,D.layers.mask=X.layers.mask&-3;let Rt=et.parent,Mt=X.cameras;$(X,Rt);for(let Zt=0;Zt<Mt.length;Zt++)$(Mt[Zt],Rt);X.projectionMatrix.copy(I.projectionMatrix),X.projectionMatrixInverse.copy(I.projectionMatrixInverse),U===null&&et.isPerspectiveCamera&&(U={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,X,Rt)};function tt(et,gt,yt){yt===null?et.matrix.copy(gt.matrixWorld):(et.matrix.copy(yt.matrixWorld),et.matrix.invert(),et.matrix.multiply(gt.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(gt.projectionMatrix),et.projectionMatrixInverse.copy(gt.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=aa*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(et){l=et,f!==null&&(f.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(X)},this.getCameraTexture=function(et){return m[et]};let st=null;function ft(et,gt){if(h=gt.getViewerPose(c||o),g=gt,h!==null){let yt=h.views;d!==null&&(t.setRenderTargetFramebuffer(b,d.framebuffer),t.setRenderTarget(b));let Rt=!1;yt.length!==X.cameras.length&&(X.cameras.length=0,Rt=!0);for(let Yt=0;Yt<yt.length;Yt++){let _e=yt[Yt],pe=null;if(d!==null)pe=d.getViewport(_e);else{let sn=u.getViewSubImage(f,_e);pe=sn.viewport,Yt===0&&(t.setRenderTargetTextures(b,sn.colorTexture,sn.depthStencilTexture),t.setRenderTarget(b))}let ce=z[Yt];ce===void 0&&(ce=new mi,ce.layers.enable(Yt),ce.viewport=new fn,z[Yt]=ce),ce.matrix.fromArray(_e.transform.matrix),ce.matrix.decompose(ce.position,ce.quaternion,ce.scale),ce.projectionMatrix.fromArray(_e.projectionMatrix),ce.projectionMatrixInverse.copy(ce.projectionMatrix).invert(),ce.viewport.set(pe.x,pe.y,pe.width,pe.height),Yt===0&&(X.matrix.copy(ce.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Rt===!0&&X.cameras.push(ce)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Yt=u.getDepthInformation(yt[0]);Yt&&Yt.isValid&&Yt.texture&&p.init(Yt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&x){t.state.unbindTexture(),u=i.getBinding();for(let Yt=0;Yt<yt.length;Yt++){let _e=yt[Yt].camera;if(_e){let pe=m[_e];pe||(pe=new Tl,m[_e]=pe);let ce=u.getCameraImage(_e);pe.sourceTexture=ce}}}}for(let yt=0;yt<C.length;yt++){let Rt=S[yt],Mt=C[yt];Rt!==null&&Mt!==void 0&&Mt.update(Rt,gt,c||o)}st&&st(et,gt),gt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:gt}),g=null}let dt=new b_;dt.setAnimationLoop(ft),this.setAnimationLoop=function(et){st=et},this.dispose=function(){}}},eT=new Me,I_=new le;I_.set(-1,0,0,0,1,0,0,0,1);function nT(n,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,dp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,_,w,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),f(p,m),m.isMeshPhysicalMaterial&&d(p,m,b)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),x(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,_,w):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===yi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===yi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let _=t.get(m),w=_.envMap,b=_.envMapRotation;w&&(p.envMap.value=w,p.envMapRotation.value.setFromMatrix4(eT.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(I_),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,_,w){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*_,p.scale.value=w*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function f(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,_){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===yi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=_.texture,p.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function x(p,m){let _=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(_.matrixWorld),p.nearDistance.value=_.shadow.camera.near,p.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function iT(n,t,e,i){let s={},r={};function o(_,w){let b=w.program;i.uniformBlockBinding(_,b,s[_.id])}function a(_,w){let b=s[_.id];b===void 0&&(g(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",p));let C=w.program;i.updateUBOMapping(_,C);let S=t.render.frame;r[_.id]!==S&&(c(_),r[_.id]=S)}function l(_){let w=n.createBuffer(),b=_.__size,C=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],b=_.uniforms,C=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let S=0,y=b.length;S<y;S++){let M=b[S];if(Array.isArray(M))for(let U=0,I=M.length;U<I;U++)h(M[U],S,U,C);else h(M,S,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,w,b,C){if(f(_,w,b,C)===!0){let S=_.__offset,y=_.value;if(Array.isArray(y)){let M=0;for(let U=0;U<y.length;U++){let I=y[U],D=x(I,!0);u(I,_.__data,M),M+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,_.__data)}}function u(_,w,b){typeof _=="number"||typeof _=="boolean"?w[b]=_:_.isMatrix3?(w[b]=_.elements[0],w[b+1]=_.elements[1],w[b+2]=_.elements[2],w[b+3]=0,w[b+4]=_.elements[3],w[b+5]=_.elements[4],w[b+6]=_.elements[5],w[b+7]=0,w[b+8]=_.elements[6],w[b+9]=_.elements[7],w[b+10]=_.elements[8],w[b+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-b),b):_.toArray(w,b)}function f(_,w,b,C){let S=_.value,y=w+"_"+b;if(Array.isArray(S)){C[y]===void 0&&(C[y]=[]);let M=C[y],U=!1;for(let I=0;I<S.length;I++)d(S[I],M,I)===!0&&(U=!0);return U}return d(S,C,y)}function d(_,w,b){if(w[b]===void 0)return typeof _=="number"||typeof _=="boolean"?w[b]=_:ArrayBuffer.isView(_)?w[b]=_.slice():w[b]=_.clone(),!0;{let C=w[b];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return w[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function g(_){let w=_.uniforms,b=0,C=16;for(let y=0,M=w.length;y<M;y++){let U=Array.isArray(w[y])?w[y]:[w[y]];for(let I=0,D=U.length;I<D;I++){let z=U[I],X=Array.isArray(z.value)?z.value:[z.value],N=Array.isArray(w[y])||Array.isArray(z.value),V=b;for(let W=0,ct=X.length;W<ct;W++){let $=X[W],tt=x($,N),st=b%C,ft=st%tt.boundary,dt=st+ft;b+=ft,dt!==0&&C-dt<tt.storage&&(b+=C-dt),W===0&&(V=b),b+=tt.storage}let Z=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Z((b-V)/Float32Array.BYTES_PER_ELEMENT),z.__offset=V}}let S=b%C;return S>0&&(b+=C-S),_.__size=b,_.__cache={},this}function x(_,w){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?Kt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):Kt("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(_){let w=_.target;w.removeEventListener("dispose",p),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function m(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var sT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Os=null;function rT(){return Os===null&&(Os=new bl(sT,16,16,Fr,fs),Os.name="DFG_LUT",Os.minFilter=gi,Os.magFilter=gi,Os.wrapS=Is,Os.wrapT=Is,Os.generateMipmaps=!1,Os.needsUpdate=!0),Os}var Lu=class{constructor(t={}){let{canvas:e=X0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=zi}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=d,p=new Set([Jh,Zh,$h]),m=new Set([zi,us,ya,ho,Xh,qh]),_=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,S=null,y=[],M=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,z=null,X=null,N=null,V=null;this._outputColorSpace=pi;let Z=0,W=0,ct=null,$=-1,tt=null,st=new fn,ft=new fn,dt=null,et=new Qt(0),gt=0,yt=e.width,Rt=e.height,Mt=1,Zt=null,ue=null,Yt=new fn(0,0,yt,Rt),_e=new fn(0,0,yt,Rt),pe=!1,ce=new eo,sn=new Sh,Ye=!1,Mn=!1,He=new Me,kn=new B,Re=new fn,In={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},pn=!1;function wn(){return ct===null?Mt:1}let H=i;function It(R,G){return e.getContext(R,G)}let te,fe,wt,Ve,Xt,jt,P,E,Y,ut,at,xt,vt,nt,rt,mt,k,ot,it,Et,_t,St,$t;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Gt,!1),e.addEventListener("webglcontextrestored",re,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),H===null){let G="webgl2";if(H=It(G,R),H===null)throw It(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}se()}catch(R){throw e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",re,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ie("WebGLRenderer: "+R.message),R}function se(){te=new g1(H),te.init(),_t=new KE(H,te),fe=new r1(H,te,t,_t),wt=new JE(H,te),fe.reversedDepthBuffer&&f&&wt.buffers.depth.setReversed(!0),X=H.createFramebuffer(),N=H.createFramebuffer(),V=H.createFramebuffer(),Ve=new y1(H),Xt=new FE,jt=new jE(H,te,wt,Xt,fe,_t,Ve),P=new m1(I),E=new bS(H),St=new i1(H,E),Y=new _1(H,E,Ve,St),ut=new b1(H,Y,E,St,Ve),ot=new v1(H,fe,jt),rt=new o1(Xt),at=new UE(I,P,te,fe,St,rt),xt=new nT(I,Xt),vt=new BE,nt=new WE(te),k=new n1(I,P,wt,ut,g,l),mt=new ZE(I,ut,fe),$t=new iT(H,Ve,fe,wt),it=new s1(H,te,Ve),Et=new x1(H,te,Ve),Ve.programs=at.programs,I.capabilities=fe,I.extensions=te,I.properties=Xt,I.renderLists=vt,I.shadowMap=mt,I.state=wt,I.info=Ve}x!==zi&&(U=new M1(x,e.width,e.height,a,s,r));let ht=new Tp(I,H);this.xr=ht,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let R=te.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=te.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(R){R!==void 0&&(Mt=R,this.setSize(yt,Rt,!1))},this.getSize=function(R){return R.set(yt,Rt)},this.setSize=function(R,G,Q=!0){if(ht.isPresenting){Kt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=R,Rt=G,e.width=Math.floor(R*Mt),e.height=Math.floor(G*Mt),Q===!0&&(e.style.width=R+"px",e.style.height=G+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,R,G)},this.getDrawingBufferSize=function(R){return R.set(yt*Mt,Rt*Mt).floor()},this.setDrawingBufferSize=function(R,G,Q){yt=R,Rt=G,Mt=Q,e.width=Math.floor(R*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,R,G)},this.setEffects=function(R){if(x===zi){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let G=0;G<R.length;G++)if(R[G].isOutputPass===!0){Kt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(st)},this.getViewport=function(R){return R.copy(Yt)},this.setViewport=function(R,G,Q,J){R.isVector4?Yt.set(R.x,R.y,R.z,R.w):Yt.set(R,G,Q,J),wt.viewport(st.copy(Yt).multiplyScalar(wn()).round())},this.getScissor=function(R){return R.copy(_e)},this.setScissor=function(R,G,Q,J){R.isVector4?_e.set(R.x,R.y,R.z,R.w):_e.set(R,G,Q,J),wt.scissor(ft.copy(_e).multiplyScalar(wn()).round())},this.getScissorTest=function(){return pe},this.setScissorTest=function(R){wt.setScissorTest(pe=R)},this.setOpaqueSort=function(R){Zt=R},this.setTransparentSort=function(R){ue=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,G=!0,Q=!0){let J=0;if(R){let j=!1;if(ct!==null){let Tt=ct.texture.format;j=p.has(Tt)}if(j){let Tt=ct.texture.type,Lt=m.has(Tt),At=k.getClearColor(),Dt=k.getClearAlpha(),Wt=At.r,ae=At.g,ye=At.b;Lt?(_[0]=Wt,_[1]=ae,_[2]=ye,_[3]=Dt,H.clearBufferuiv(H.COLOR,0,_)):(w[0]=Wt,w[1]=ae,w[2]=ye,w[3]=Dt,H.clearBufferiv(H.COLOR,0,w))}else J|=H.COLOR_BUFFER_BIT}G&&(J|=H.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(J|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&H.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),z=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",re,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),k.dispose(),vt.dispose(),nt.dispose(),jt.dispose(),Xt.dispose(),P.dispose(),ut.dispose(),Y.dispose(),St.dispose(),$t.dispose(),at.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",pc),ht.removeEventListener("sessionend",vs),Vs.stop()};function Gt(R){R.preventDefault(),dl("WebGLRenderer: Context Lost."),D=!0}function re(){dl("WebGLRenderer: Context Restored."),D=!1;let R=Ve.autoReset,G=mt.enabled,Q=mt.autoUpdate,J=mt.needsUpdate,j=mt.type;se(),Ve.autoReset=R,mt.enabled=G,mt.autoUpdate=Q,mt.needsUpdate=J,mt.type=j}function Ct(R){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function de(R){let G=R.target;G.removeEventListener("dispose",de),Je(G)}function Je(R){ai(R),Xt.remove(R)}function ai(R){let G=Xt.get(R).programs;G!==void 0&&(G.forEach(function(Q){at.releaseProgram(Q)}),R.isShaderMaterial&&at.releaseShaderCache(R))}this.renderBufferDirect=function(R,G,Q,J,j,Tt){G===null&&(G=In);let Lt=j.isMesh&&j.matrixWorld.determinantAffine()<0,At=Va(R,G,Q,J,j);wt.setMaterial(J,Lt);let Dt=Q.index,Wt=1;if(J.wireframe===!0){if(Dt=Y.getWireframeAttribute(Q),Dt===void 0)return;Wt=2}let ae=Q.drawRange,ye=Q.attributes.position,Vt=ae.start*Wt,ve=(ae.start+ae.count)*Wt;Tt!==null&&(Vt=Math.max(Vt,Tt.start*Wt),ve=Math.min(ve,(Tt.start+Tt.count)*Wt)),Dt!==null?(Vt=Math.max(Vt,0),ve=Math.min(ve,Dt.count)):ye!=null&&(Vt=Math.max(Vt,0),ve=Math.min(ve,ye.count));let un=ve-Vt;if(un<0||un===1/0)return;St.setup(j,J,At,Q,Dt);let Oe,Be=it;if(Dt!==null&&(Oe=E.get(Dt),Be=Et,Be.setIndex(Oe)),j.isMesh)J.wireframe===!0?(wt.setLineWidth(J.wireframeLinewidth*wn()),Be.setMode(H.LINES)):Be.setMode(H.TRIANGLES);else if(j.isLine){let Ln=J.linewidth;Ln===void 0&&(Ln=1),wt.setLineWidth(Ln*wn()),j.isLineSegments?Be.setMode(H.LINES):j.isLineLoop?Be.setMode(H.LINE_LOOP):Be.setMode(H.LINE_STRIP)}else j.isPoints?Be.setMode(H.POINTS):j.isSprite&&Be.setMode(H.TRIANGLES);if(j.isBatchedMesh)if(te.get("WEBGL_multi_draw"))Be.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let Ln=j._multiDrawStarts,kt=j._multiDrawCounts,En=j._multiDrawCount,we=Dt?E.get(Dt).bytesPerElement:1,Xs=Xt.get(J).currentProgram.getUniforms();for(let Tn=0;Tn<En;Tn++)Xs.setValue(H,"_gl_DrawID",Tn),Be.render(Ln[Tn]/we,kt[Tn])}else if(j.isInstancedMesh)Be.renderInstances(Vt,un,j.count);else if(Q.isInstancedBufferGeometry){let Ln=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,kt=Math.min(Q.instanceCount,Ln);Be.renderInstances(Vt,un,kt)}else Be.render(Vt,un)};function ka(R,G,Q,J){z!==null&&R.isNodeMaterial&&z.setObject(J,R),Ye===!0&&rt.setState(R,Q,!1),R.transparent===!0&&R.side===Mi&&R.forceSinglePass===!1?(R.side=yi,R.needsUpdate=!0,bs(R,G,J),R.side=Ur,R.needsUpdate=!0,bs(R,G,J),R.side=Mi):bs(R,G,J)}this.compile=function(R,G,Q=null){Q===null&&(Q=R),z!==null&&z.renderStart(R,G,Q),S=nt.get(Q),S.init(G),M.push(S),Q.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(S.pushLight(j),j.castShadow&&S.pushShadow(j))}),R!==Q&&R.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(S.pushLight(j),j.castShadow&&S.pushShadow(j))}),S.setupLights(),z!==null&&z.updateLights(S.state.lightsArray),Mn=this.localClippingEnabled,Ye=rt.init(this.clippingPlanes,Mn),Ye===!0&&rt.setGlobalState(this.clippingPlanes,G),z!==null&&mt.render(S.state.shadowsArray,Q,G);let J=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Tt=j.material;if(Tt)if(Array.isArray(Tt))for(let Lt=0;Lt<Tt.length;Lt++){let At=Tt[Lt];ka(At,Q,G,j),J.add(At)}else ka(Tt,Q,G,j),J.add(Tt)}),S=M.pop(),z!==null&&z.renderEnd(),J},this.compileAsync=function(R,G,Q=null){let J=this.compile(R,G,Q);return new Promise(j=>{function Tt(){if(J.forEach(function(Lt){let Dt=Xt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&J.delete(Lt)}),J.size===0){j(R);return}setTimeout(Tt,10)}te.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Ao=null;function Gf(R){Ao&&Ao(R)}function pc(){Vs.stop()}function vs(){Vs.start()}let Vs=new b_;Vs.setAnimationLoop(Gf),typeof self<"u"&&Vs.setContext(self),this.setAnimationLoop=function(R){Ao=R,ht.setAnimationLoop(R),R===null?Vs.stop():Vs.start()},ht.addEventListener("sessionstart",pc),ht.addEventListener("sessionend",vs),this.render=function(R,G){if(G!==void 0&&G.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(R,G);let Q=ht.enabled===!0&&ht.isPresenting===!0,J=U!==null&&(ct===null||Q)&&U.begin(I,ct);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(G),G=ht.getCamera()),R.isScene===!0&&R.onBeforeRender(I,R,G,ct),S=nt.get(R,M.length),S.init(G),S.state.textureUnits=jt.getTextureUnits(),M.push(S),He.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?sn.setFromArrayCamera(G):ce.setFromProjectionMatrix(He,Yi,G.reversedDepth),Mn=this.localClippingEnabled,Ye=rt.init(this.clippingPlanes,Mn),C=vt.get(R,y.length),C.init(),y.push(C),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Lt=I.xr.getDepthSensingMesh();Lt!==null&&Ws(Lt,G,-1/0,I.sortObjects)}Ws(R,G,0,I.sortObjects),C.finish(),z!==null&&z.updateLights(S.state.lightsArray),I.sortObjects===!0&&C.sort(Zt,ue),pn=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,pn&&k.addToRenderList(C,R),this.info.autoReset===!0&&this.info.reset(),Ye===!0&&rt.beginShadows();let j=S.state.shadowsArray;if(mt.render(j,R,G),Ye===!0&&rt.endShadows(),(J&&U.hasRenderPass())===!1){let Lt=C.opaque,At=C.transmissive;if(S.setupLights(),G.isArrayCamera){let Dt=G.cameras;if(At.length>0)for(let Wt=0,ae=Dt.length;Wt<ae;Wt++){let ye=Dt[Wt];ts(Lt,At,R,ye)}pn&&k.render(R);for(let Wt=0,ae=Dt.length;Wt<ae;Wt++){let ye=Dt[Wt];Ha(C,R,ye,ye.viewport)}}else At.length>0&&ts(Lt,At,R,G),pn&&k.render(R),Ha(C,R,G)}ct!==null&&W===0&&(jt.updateMultisampleRenderTarget(ct),jt.updateRenderTargetMipmap(ct)),J&&U.end(I),R.isScene===!0&&R.onAfterRender(I,R,G),St.resetDefaultState(),$=-1,tt=null,M.pop(),M.length>0?(S=M[M.length-1],jt.setTextureUnits(S.state.textureUnits),Ye===!0&&rt.setGlobalState(I.clippingPlanes,S.state.camera)):S=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,z!==null&&z.renderEnd()};function Ws(R,G,Q,J){if(R.visible===!1)return;if(R.layers.test(G.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(G);else if(R.isLight)S.pushLight(R),R.castShadow&&S.pushShadow(R);else if(R.isSprite){let Lt=G.isArrayCamera?sn:ce;if(!R.frustumCulled||R.intersectsFrustum(Lt)){J&&Re.setFromMatrixPosition(R.matrixWorld).applyMatrix4(He);let At=ut.update(R),Dt=R.material;Dt.visible&&C.push(R,At,Dt,Q,Re.z,null,G)}}else if(R.isMesh||R.isLine||R.isPoints){let Lt=G.isArrayCamera?sn:ce;if(!R.frustumCulled||R.intersectsFrustum(Lt)){let At=ut.update(R),Dt=R.material;if(J&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Re.copy(R.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),Re.copy(At.boundingSphere.center)),Re.applyMatrix4(R.matrixWorld).applyMatrix4(He)),Array.isArray(Dt)){let Wt=At.groups;for(let ae=0,ye=Wt.length;ae<ye;ae++){let Vt=Wt[ae],ve=Dt[Vt.materialIndex];ve&&ve.visible&&C.push(R,At,ve,Q,Re.z,Vt,G)}}else Dt.visible&&C.push(R,At,Dt,Q,Re.z,null,G)}}}let Tt=R.children;for(let Lt=0,At=Tt.length;Lt<At;Lt++)Ws(Tt[Lt],G,Q,J)}function Ha(R,G,Q,J){let{opaque:j,transmissive:Tt,transparent:Lt}=R;S.setupLightsView(Q),Ye===!0&&rt.setGlobalState(I.clippingPlanes,Q),J&&wt.viewport(st.copy(J)),j.length>0&&mn(j,G,Q),Tt.length>0&&mn(Tt,G,Q),Lt.length>0&&mn(Lt,G,Q),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function ts(R,G,Q,J){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[J.id]===void 0){let Vt=te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[J.id]=new Oi(1,1,{generateMipmaps:!0,type:Vt?fs:zi,minFilter:lr,samples:Math.max(4,fe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ee.workingColorSpace})}let Tt=S.state.transmissionRenderTarget[J.id],Lt=J.viewport||st;Tt.setSize(Lt.z*I.transmissionResolutionScale,Lt.w*I.transmissionResolutionScale);let At=I.getRenderTarget(),Dt=I.getActiveCubeFace(),Wt=I.getActiveMipmapLevel();I.setRenderTarget(Tt),I.getClearColor(et),gt=I.getClearAlpha(),gt<1&&I.setClearColor(16777215,.5),I.clear(),pn&&k.render(Q);let ae=I.toneMapping;I.toneMapping=Fs;let ye=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),S.setupLightsView(J),Ye===!0&&rt.setGlobalState(I.clippingPlanes,J),mn(R,Q,J),jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt),te.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let ve=0,un=G.length;ve<un;ve++){let Oe=G[ve],{object:Be,geometry:Ln,material:kt,group:En}=Oe;if(kt.side===Mi&&Be.layers.test(J.layers)){let we=kt.side;kt.side=yi,kt.needsUpdate=!0,vn(Be,Q,J,Ln,kt,En),kt.side=we,kt.needsUpdate=!0,Vt=!0}}Vt===!0&&(jt.updateMultisampleRenderTarget(Tt),jt.updateRenderTargetMipmap(Tt))}I.setRenderTarget(At,Dt,Wt),I.setClearColor(et,gt),ye!==void 0&&(J.viewport=ye),I.toneMapping=ae}function mn(R,G,Q){let J=G.isScene===!0?G.overrideMaterial:null;for(let j=0,Tt=R.length;j<Tt;j++){let Lt=R[j],{object:At,geometry:Dt,group:Wt}=Lt,ae=Lt.material;ae.allowOverride===!0&&J!==null&&(ae=J),At.layers.test(Q.layers)&&vn(At,G,Q,Dt,ae,Wt)}}function vn(R,G,Q,J,j,Tt){z!==null&&j.isNodeMaterial&&z.setObject(R,j),R.onBeforeRender(I,G,Q,J,j,Tt),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(I,G,Q,J,R,Tt),j.transparent===!0&&j.side===Mi&&j.forceSinglePass===!1?(j.side=yi,j.needsUpdate=!0,I.renderBufferDirect(Q,G,J,j,R,Tt),j.side=Ur,j.needsUpdate=!0,I.renderBufferDirect(Q,G,J,j,R,Tt),j.side=Mi):I.renderBufferDirect(Q,G,J,j,R,Tt),R.onAfterRender(I,G,Q,J,j,Tt)}function bn(R){let G=0;for(let Q of R)Q.texture!==null&&G++;return G}function bs(R,G,Q){G.isScene!==!0&&(G=In);let J=Xt.get(R),j=S.state.lights,Tt=S.state.shadowsArray,Lt=j.state.version,At=at.getParameters(R,j.state,Tt,G,Q,S.state.lightProbeGridArray),Dt=at.getProgramCacheKey(At),Wt=J.programs;J.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?G.environment:null,J.fog=G.fog;let ae=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;J.envMap=P.get(R.envMap||J.environment,ae),J.envMapRotation=J.environment!==null&&R.envMap===null?G.environmentRotation:R.envMapRotation,Wt===void 0&&(R.addEventListener("dispose",de),Wt=new Map,J.programs=Wt,J.programVariants=new Map);let ye=Wt.get(Dt);if(ye!==void 0){if(J.currentProgram===ye&&J.lightsStateVersion===Lt)return Ga(R,At),ye}else At.uniforms=at.getUniforms(R),z!==null&&R.isNodeMaterial&&z.build(R,Q,At),R.onBeforeCompile(At,I),ye=at.acquireProgram(At,Dt),Wt.set(Dt,ye),J.uniforms=At.uniforms;let Vt=J.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Vt.clippingPlanes=rt.uniform),Ga(R,At),J.needsLights=mr(R),J.lightsStateVersion=Lt,J.needsLights&&(Vt.ambientLightColor.value=j.state.ambient,Vt.lightProbe.value=j.state.probe,Vt.sunLights.value=j.state.sun,Vt.sunLightShadows.value=j.state.sunShadow,Vt.directionalLights.value=j.state.directional,Vt.directionalLightShadows.value=j.state.directionalShadow,Vt.spotLights.value=j.state.spot,Vt.spotLightShadows.value=j.state.spotShadow,Vt.rectAreaLights.value=j.state.rectArea,Vt.ltc_1.value=j.state.rectAreaLTC1,Vt.ltc_2.value=j.state.rectAreaLTC2,Vt.pointLights.value=j.state.point,Vt.pointLightShadows.value=j.state.pointShadow,Vt.hemisphereLights.value=j.state.hemi,Vt.sunShadowMatrix.value=j.state.sunShadowMatrix,Vt.sunShadowCascade.value=j.state.sunShadowCascade,Vt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Vt.spotLightMatrix.value=j.state.spotLightMatrix,Vt.spotLightMap.value=j.state.spotLightMap,Vt.pointShadowMatrix.value=j.state.pointShadowMatrix),J.numLightProbeGrids=bn(S.state.lightProbeGridArray),J.currentProgram=ye,J.uniformsList=null,ye}function Pi(R,G,Q,J,j){let Tt=Xt.get(R),Lt=Tt.currentProgram.id+","+J+","+j,At=Tt.programVariants.get(Lt);return At===void 0?(At=bs(R,G,Q),Tt.programVariants.set(Lt,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=J,Tt.toneMapping=j),At}function pr(R){if(R.uniformsList===null){let G=R.currentProgram.getUniforms();R.uniformsList=ba.seqWithValue(G.seq,R.uniforms)}return R.uniformsList}function Ga(R,G){let Q=Xt.get(R);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function Va(R,G,Q,J,j){G.isScene!==!0&&(G=In),jt.resetTextureUnits();let Tt=G.fog,Lt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?G.environment:null,At=ct===null?I.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Ee.workingColorSpace,Dt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Wt=P.get(J.envMap||Lt,Dt),ae=J.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,ye=!!Q.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Vt=!!Q.morphAttributes.position,ve=!!Q.morphAttributes.normal,un=!!Q.morphAttributes.color,Oe=Fs;J.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Oe=I.toneMapping);let Be=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Ln=Be!==void 0?Be.length:0,kt=Xt.get(J),En=S.state.lights;if(Ye===!0&&(Mn===!0||R!==tt)){let ze=R===tt&&J.id===$;rt.setState(J,R,ze)}let we=!1,Xs=!1;J.version===kt.__version?kt.needsLights&&kt.lightsStateVersion!==En.state.version||j.isBatchedMesh&&kt.batching===!1||!j.isBatchedMesh&&kt.batching===!0||j.isBatchedMesh&&kt.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&kt.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&kt.instancing===!1||!j.isInstancedMesh&&kt.instancing===!0||j.isSkinnedMesh&&kt.skinning===!1||!j.isSkinnedMesh&&kt.skinning===!0||j.isInstancedMesh&&kt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&kt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&kt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&kt.instancingMorph===!1&&j.morphTexture!==null||kt.envMap!==Wt||J.fog===!0&&kt.fog!==Tt||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==rt.numPlanes||kt.numIntersection!==rt.numIntersection)||kt.vertexAlphas!==ae||kt.vertexTangents!==ye||kt.morphTargets!==Vt||kt.morphNormals!==ve||kt.morphColors!==un||kt.morphTargetsCount!==Ln||kt.numLightProbeGrids!==bn(S.state.lightProbeGridArray)?we=!0:(kt.outputColorSpace!==At||kt.toneMapping!==Oe)&&(Xs=!0):(we=!0,kt.__version=J.version);let Tn=kt.currentProgram;(we===!0||Xs===!0)&&(Tn=Xs===!0?Pi(J,G,j,At,Oe):bs(J,G,j),z&&J.isNodeMaterial&&z.onUpdateProgram(J,Tn,kt));let Po=!1,Ss=!1,qs=!1,me=Tn.getUniforms(),gn=kt.uniforms;if(wt.useProgram(Tn.program)&&(Po=!0,Ss=!0,qs=!0),J.id!==$&&($=J.id,Ss=!0),Po||tt!==R){wt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),me.setValue(H,"projectionMatrix",R.projectionMatrix),me.setValue(H,"viewMatrix",R.matrixWorldInverse);let An=me.map.cameraPosition;An!==void 0&&An.setValue(H,kn.setFromMatrixPosition(R.matrixWorld)),fe.logarithmicDepthBuffer&&me.setValue(H,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&me.setValue(H,"isOrthographic",R.isOrthographicCamera===!0),tt!==R&&(tt=R,Ss=!0,qs=!0)}if(kt.needsLights&&(En.state.sunShadowMap.length>0&&me.setValue(H,"sunShadowMap",En.state.sunShadowMap,jt),En.state.directionalShadowMap.length>0&&me.setValue(H,"directionalShadowMap",En.state.directionalShadowMap,jt),En.state.spotShadowMap.length>0&&me.setValue(H,"spotShadowMap",En.state.spotShadowMap,jt),En.state.pointShadowMap.length>0&&me.setValue(H,"pointShadowMap",En.state.pointShadowMap,jt)),j.isSkinnedMesh){me.setOptional(H,j,"bindMatrix"),me.setOptional(H,j,"bindMatrixInverse");let ze=j.skeleton;ze&&(ze.boneTexture===null&&ze.computeBoneTexture(),me.setValue(H,"boneTexture",ze.boneTexture,jt))}j.isBatchedMesh&&(me.setOptional(H,j,"batchingTexture"),me.setValue(H,"batchingTexture",j._matricesTexture,jt),me.setOptional(H,j,"batchingIdTexture"),me.setValue(H,"batchingIdTexture",j._indirectTexture,jt),me.setOptional(H,j,"batchingColorTexture"),j._colorsTexture!==null&&me.setValue(H,"batchingColorTexture",j._colorsTexture,jt));let li=Q.morphAttributes;if((li.position!==void 0||li.normal!==void 0||li.color!==void 0)&&ot.update(j,Q,Tn),(Ss||kt.receiveShadow!==j.receiveShadow)&&(kt.receiveShadow=j.receiveShadow,me.setValue(H,"receiveShadow",j.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&G.environment!==null&&(gn.envMapIntensity.value=G.environmentIntensity),gn.dfgLUT!==void 0&&(gn.dfgLUT.value=rT()),Ss){if(me.setValue(H,"toneMappingExposure",I.toneMappingExposure),kt.needsLights&&Ro(gn,qs),Tt&&J.fog===!0&&xt.refreshFogUniforms(gn,Tt),xt.refreshMaterialUniforms(gn,J,Mt,Rt,S.state.transmissionRenderTarget[R.id]),kt.needsLights&&kt.numLightProbeGrids>0){let ze=b,An=0;for(let Qn of S.state.lightProbeGridArray)Qn.texture!==null&&(ze.textures[An]=Qn.texture,ze.min[An]=Qn.boundingBox.min,ze.max[An]=Qn.boundingBox.max,ze.resolution[An]=Qn.resolution,An++);for(let Qn in ze)ze[Qn].length=An;gn.probesSH.value=ze.textures,gn.probesMin.value=ze.min,gn.probesMax.value=ze.max,gn.probesResolution.value=ze.resolution}ba.upload(H,pr(kt),gn,jt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(ba.upload(H,pr(kt),gn,jt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&me.setValue(H,"center",j.center),me.setValue(H,"modelViewMatrix",j.modelViewMatrix),me.setValue(H,"normalMatrix",j.normalMatrix),me.setValue(H,"modelMatrix",j.matrixWorld),J.uniformsGroups!==void 0){let ze=J.uniformsGroups;for(let An=0,Qn=ze.length;An<Qn;An++){let mc=ze[An];$t.update(mc,Tn),$t.bind(mc,Tn)}}return Tn}function Ro(R,G){R.ambientLightColor.needsUpdate=G,R.lightProbe.needsUpdate=G,R.sunLights.needsUpdate=G,R.sunLightShadows.needsUpdate=G,R.directionalLights.needsUpdate=G,R.directionalLightShadows.needsUpdate=G,R.pointLights.needsUpdate=G,R.pointLightShadows.needsUpdate=G,R.spotLights.needsUpdate=G,R.spotLightShadows.needsUpdate=G,R.rectAreaLights.needsUpdate=G,R.hemisphereLights.needsUpdate=G}function mr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(R,G,Q){let J=Xt.get(R);J.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Xt.get(R.texture).__webglTexture=G,Xt.get(R.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:Q,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,G){let Q=Xt.get(R);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(R,G=0,Q=0){ct=R,Z=G,W=Q;let J=null,j=!1,Tt=!1;if(R){let At=Xt.get(R);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(H.FRAMEBUFFER,At.__webglFramebuffer),st.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest,wt.viewport(st),wt.scissor(ft),wt.setScissorTest(dt),$=-1;return}else if(At.__webglFramebuffer===void 0)jt.setupRenderTarget(R);else if(At.__hasExternalTextures)jt.rebindTextures(R,Xt.get(R.texture).__webglTexture,Xt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ae=R.depthTexture;if(At.__boundDepthTexture!==ae){if(ae!==null&&Xt.has(ae)&&(R.width!==ae.image.width||R.height!==ae.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");jt.setupDepthRenderbuffer(R)}}let Dt=R.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(Tt=!0);let Wt=Xt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Wt[G])?J=Wt[G][Q]:J=Wt[G],j=!0):R.samples>0&&jt.useMultisampledRTT(R)===!1?J=Xt.get(R).__webglMultisampledFramebuffer:Array.isArray(Wt)?J=Wt[Q]:J=Wt,st.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest}else st.copy(Yt).multiplyScalar(Mt).floor(),ft.copy(_e).multiplyScalar(Mt).floor(),dt=pe;if(Q!==0&&(J=X),wt.bindFramebuffer(H.FRAMEBUFFER,J)&&wt.drawBuffers(R,J),wt.viewport(st),wt.scissor(ft),wt.setScissorTest(dt),j){let At=Xt.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+G,At.__webglTexture,Q)}else if(Tt){let At=G;for(let Dt=0;Dt<R.textures.length;Dt++){let Wt=Xt.get(R.textures[Dt]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+Dt,Wt.__webglTexture,Q,At)}}else if(R!==null&&Q!==0){let At=Xt.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,At.__webglTexture,Q)}$=-1};function Co(R){let G=Xt.get(R);return(G.__readFormat!==R.format||G.__readType!==R.type)&&(G.__readFormat=R.format,G.__readType=R.type,G.__formatReadable=fe.textureFormatReadable(R.format),G.__typeReadable=fe.textureTypeReadable(R.type)),G}this.readRenderTargetPixels=function(R,G,Q,J,j,Tt,Lt,At=0){if(!(R&&R.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Xt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){wt.bindFramebuffer(H.FRAMEBUFFER,Dt);try{let Wt=R.textures[At],ae=Wt.format,ye=Wt.type;R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+At);let Vt=Co(Wt);if(Vt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=R.width-J&&Q>=0&&Q<=R.height-j&&H.readPixels(G,Q,J,j,_t.convert(ae),_t.convert(ye),Tt)}finally{let Wt=ct!==null?Xt.get(ct).__webglFramebuffer:null;wt.bindFramebuffer(H.FRAMEBUFFER,Wt)}}},this.readRenderTargetPixelsAsync=async function(R,G,Q,J,j,Tt,Lt,At=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Xt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(G>=0&&G<=R.width-J&&Q>=0&&Q<=R.height-j){wt.bindFramebuffer(H.FRAMEBUFFER,Dt);let Wt=R.textures[At],ae=Wt.format,ye=Wt.type;R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+At);let Vt=Co(Wt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ve=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,ve),H.bufferData(H.PIXEL_PACK_BUFFER,Tt.byteLength,H.STREAM_READ),H.readPixels(G,Q,J,j,_t.convert(ae),_t.convert(ye),0),H.bindBuffer(H.PIXEL_PACK_BUFFER,null);let un=ct!==null?Xt.get(ct).__webglFramebuffer:null;wt.bindFramebuffer(H.FRAMEBUFFER,un);let Oe=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await Y0(H,Oe,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,ve),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Tt),H.bindBuffer(H.PIXEL_PACK_BUFFER,null),H.deleteBuffer(ve),H.deleteSync(Oe),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,G=null,Q=0){let J=Math.pow(2,-Q),j=Math.floor(R.image.width*J),Tt=Math.floor(R.image.height*J),Lt=G!==null?G.x:0,At=G!==null?G.y:0;jt.setTexture2D(R,0),H.copyTexSubImage2D(H.TEXTURE_2D,Q,0,0,Lt,At,j,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(R,G,Q=null,J=null,j=0,Tt=0){let Lt,At,Dt,Wt,ae,ye,Vt,ve,un,Oe=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(Q!==null)Lt=Q.max.x-Q.min.x,At=Q.max.y-Q.min.y,Dt=Q.isBox3?Q.max.z-Q.min.z:1,Wt=Q.min.x,ae=Q.min.y,ye=Q.isBox3?Q.min.z:0;else{let me=Math.pow(2,-j);Lt=Math.floor(Oe.width*me),At=Math.floor(Oe.height*me),R.isDataArrayTexture?Dt=Oe.depth:R.isData3DTexture?Dt=Math.floor(Oe.depth*me):Dt=1,Wt=0,ae=0,ye=0}J!==null?(Vt=J.x,ve=J.y,un=J.z):(Vt=0,ve=0,un=0);let Be=_t.convert(G.format),Ln=_t.convert(G.type),kt;G.isData3DTexture?(jt.setTexture3D(G,0),kt=H.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(jt.setTexture2DArray(G,0),kt=H.TEXTURE_2D_ARRAY):(jt.setTexture2D(G,0),kt=H.TEXTURE_2D),wt.activeTexture(H.TEXTURE0),wt.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,G.flipY),wt.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),wt.pixelStorei(H.UNPACK_ALIGNMENT,G.unpackAlignment);let En=wt.getParameter(H.UNPACK_ROW_LENGTH),we=wt.getParameter(H.UNPACK_IMAGE_HEIGHT),Xs=wt.getParameter(H.UNPACK_SKIP_PIXELS),Tn=wt.getParameter(H.UNPACK_SKIP_ROWS),Po=wt.getParameter(H.UNPACK_SKIP_IMAGES);wt.pixelStorei(H.UNPACK_ROW_LENGTH,Oe.width),wt.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Oe.height),wt.pixelStorei(H.UNPACK_SKIP_PIXELS,Wt),wt.pixelStorei(H.UNPACK_SKIP_ROWS,ae),wt.pixelStorei(H.UNPACK_SKIP_IMAGES,ye);let Ss=R.isDataArrayTexture||R.isData3DTexture,qs=G.isDataArrayTexture||G.isData3DTexture;if(R.isDepthTexture){let me=Xt.get(R),gn=Xt.get(G),li=Xt.get(me.__renderTarget),ze=Xt.get(gn.__renderTarget);wt.bindFramebuffer(H.READ_FRAMEBUFFER,li.__webglFramebuffer),wt.bindFramebuffer(H.DRAW_FRAMEBUFFER,ze.__webglFramebuffer);for(let An=0;An<Dt;An++)Ss&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,Xt.get(R).__webglTexture,j,ye+An),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,Xt.get(G).__webglTexture,Tt,un+An)),H.blitFramebuffer(Wt,ae,Wt+Lt,ae+At,Vt,ve,Vt+Lt,ve+At,H.DEPTH_BUFFER_BIT,H.NEAREST);wt.bindFramebuffer(H.READ_FRAMEBUFFER,null),wt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||Xt.has(R)){let me=Xt.get(R),gn=Xt.get(G);wt.bindFramebuffer(H.READ_FRAMEBUFFER,N),wt.bindFramebuffer(H.DRAW_FRAMEBUFFER,V);for(let li=0;li<Dt;li++)Ss?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,me.__webglTexture,j,ye+li):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,me.__webglTexture,j),qs?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,gn.__webglTexture,Tt,un+li):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,gn.__webglTexture,Tt),j!==0?H.blitFramebuffer(Wt,ae,Wt+Lt,ae+At,Vt,ve,Vt+Lt,ve+At,H.COLOR_BUFFER_BIT,H.NEAREST):qs?H.copyTexSubImage3D(kt,Tt,Vt,ve,un+li,Wt,ae,Lt,At):H.copyTexSubImage2D(kt,Tt,Vt,ve,Wt,ae,Lt,At);wt.bindFramebuffer(H.READ_FRAMEBUFFER,null),wt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else qs?R.isDataTexture||R.isData3DTexture?H.texSubImage3D(kt,Tt,Vt,ve,un,Lt,At,Dt,Be,Ln,Oe.data):G.isCompressedArrayTexture?H.compressedTexSubImage3D(kt,Tt,Vt,ve,un,Lt,At,Dt,Be,Oe.data):H.texSubImage3D(kt,Tt,Vt,ve,un,Lt,At,Dt,Be,Ln,Oe):R.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Tt,Vt,ve,Lt,At,Be,Ln,Oe.data):R.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Tt,Vt,ve,Oe.width,Oe.height,Be,Oe.data):H.texSubImage2D(H.TEXTURE_2D,Tt,Vt,ve,Lt,At,Be,Ln,Oe);wt.pixelStorei(H.UNPACK_ROW_LENGTH,En),wt.pixelStorei(H.UNPACK_IMAGE_HEIGHT,we),wt.pixelStorei(H.UNPACK_SKIP_PIXELS,Xs),wt.pixelStorei(H.UNPACK_SKIP_ROWS,Tn),wt.pixelStorei(H.UNPACK_SKIP_IMAGES,Po),Tt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&H.generateMipmap(kt),wt.unbindTexture()},this.initRenderTarget=function(R){Xt.get(R).__webglFramebuffer===void 0&&jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?jt.setTextureCube(R,0):R.isData3DTexture?jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?jt.setTexture2DArray(R,0):jt.setTexture2D(R,0),wt.unbindTexture()},this.resetState=function(){Z=0,W=0,ct=null,wt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ee._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ee._getUnpackColorSpace()}};var L_={type:"change"},Rp={type:"start"},N_={type:"end"},Uu=new rr,D_=new Fi,oT=Math.cos(70*va.DEG2RAD),Fn=new B,wi=2*Math.PI,De={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ap=1e-6,Fu=class extends oo{constructor(t,e=null){super(t,e),this.state=De.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Dr.ROTATE,MIDDLE:Dr.DOLLY,RIGHT:Dr.PAN},this.touches={ONE:Nr.ROTATE,TWO:Nr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new Ze,this._lastTargetPosition=new B,this._quat=new Ze().setFromUnitVectors(t.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ma,this._sphericalDelta=new ma,this._scale=1,this._panOffset=new B,this._rotateStart=new qt,this._rotateEnd=new qt,this._rotateDelta=new qt,this._panStart=new qt,this._panEnd=new qt,this._panDelta=new qt,this._dollyStart=new qt,this._dollyEnd=new qt,this._dollyDelta=new qt,this._dollyDirection=new B,this._mouse=new qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=lT.bind(this),this._onPointerDown=aT.bind(this),this._onPointerUp=cT.bind(this),this._onContextMenu=gT.bind(this),this._onMouseWheel=fT.bind(this),this._onKeyDown=dT.bind(this),this._onTouchStart=pT.bind(this),this._onTouchMove=mT.bind(this),this._onMouseDown=hT.bind(this),this._onMouseMove=uT.bind(this),this._interceptControlDown=_T.bind(this),this._interceptControlUp=xT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=De.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(L_),this.update(),this.state=De.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Fn.copy(e).sub(this.target),Fn.applyQuaternion(this._quat),this._spherical.setFromVector3(Fn),this.autoRotate&&this.state===De.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=wi:i>Math.PI&&(i-=wi),s<-Math.PI?s+=wi:s>Math.PI&&(s-=wi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Fn.setFromSpherical(this._spherical),Fn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new B(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Uu.origin.copy(this.object.position),Uu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Uu.direction))<oT?this.object.lookAt(this.target):(D_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Uu.intersectPlane(D_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Ap||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ap||this._lastTargetPosition.distanceToSquared(this.target)>Ap?(this.dispatchEvent(L_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?wi/60*this.autoRotateSpeed*t:wi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Fn.setFromMatrixColumn(e,0),Fn.multiplyScalar(-t),this._panOffset.add(Fn)}_panUp(t,e){this.screenSpacePanning===!0?Fn.setFromMatrixColumn(e,1):(Fn.setFromMatrixColumn(e,0),Fn.crossVectors(this.object.up,Fn)),Fn.multiplyScalar(t),this._panOffset.add(Fn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Fn.copy(s).sub(this.target);let r=Fn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(wi*this._rotateDelta.x/e.clientHeight),this._rotateUp(wi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(wi*this._rotateDelta.x/e.clientHeight),this._rotateUp(wi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function aT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function lT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function cT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(N_),this.state=De.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function hT(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Dr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=De.DOLLY;break;case Dr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=De.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=De.ROTATE}break;case Dr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=De.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=De.PAN}break;default:this.state=De.NONE}this.state!==De.NONE&&this.dispatchEvent(Rp)}function uT(n){switch(this.state){case De.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case De.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case De.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function fT(n){this.enabled===!1||this.enableZoom===!1||this.state!==De.NONE||(n.preventDefault(),this.dispatchEvent(Rp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(N_))}function dT(n){this.enabled!==!1&&this._handleKeyDown(n)}function pT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Nr.ROTATE:if(this.enableRotate===!1){this.state=De.NONE;break}this._handleTouchStartRotate(n),this.state=De.TOUCH_ROTATE;break;case Nr.PAN:if(this.enablePan===!1){this.state=De.NONE;break}this._handleTouchStartPan(n),this.state=De.TOUCH_PAN;break;default:this.state=De.NONE}break;case 2:switch(this.touches.TWO){case Nr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=De.TOUCH_DOLLY_PAN;break;case Nr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=De.TOUCH_DOLLY_ROTATE;break;default:this.state=De.NONE}break;default:this.state=De.NONE}this.state!==De.NONE&&this.dispatchEvent(Rp)}function mT(n){switch(this._trackPointer(n),this.state){case De.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case De.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case De.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case De.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=De.NONE}}function gT(n){this.enabled!==!1&&n.preventDefault()}function _T(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function xT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var U_=[1,.75,.55,.42],yT=30,vT=17,bT=400,F_=6e6;function O_(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var Ou=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(F_/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>yT&&this.level<U_.length-1?this.level+=1:i<vT&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*U_[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(F_/this.area),.5))),this.draw()},bT)}};var k_=32,H_={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},ri=new gl,dn=new mi(k_,1,.01,100);dn.up.set(0,0,1);var ks,$n,Ji,Ip,Cp=!1,G_=!1,Lp=0;function ln(){Cp||!G_||(Cp=!0,requestAnimationFrame(V_))}function V_(n=performance.now()){Cp=!1,Ip.moving(n),W_()}function W_(){ks.render(ri,dn),Lp+=1}function X_(){G_=!0,ln()}var q_=()=>Lp;ri.fog=new ml("#fff",1,10);function B_(n){let t=document.createElement("canvas");t.width=Ji.clientWidth||1,t.height=Ji.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>ST.has(s)?i(s):null,e}var ST=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function Y_(n){Ji=n;let t=B_(!1),e=O_(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=B_(!0)),ks=new Lu({canvas:t.canvas,context:t}),ks.debug.checkShaderErrors=!1,Ip=new Ou(e,ks,W_,i=>oe("hurry",i)),ks.domElement.setAttribute("aria-hidden","true"),Ji.append(ks.domElement),$n=new Fu(dn,ks.domElement),$n.enableDamping=!1,$n.addEventListener("change",ln),$n.addEventListener("end",()=>{zu=!Z_()}),new ResizeObserver(MT).observe(Ji),Ji.tabIndex=0,Ji.setAttribute("role","application"),Ji.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),Ji.addEventListener("keydown",wT)}function MT(){let n=Ji.clientWidth,t=Ji.clientHeight;!n||!t||(Ip.resized(n,t),ks.setSize(n,t),dn.aspect=n/t,dn.updateProjectionMatrix(),Lp?V_():ln(),Up())}function wT(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)ET(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")z_(1/1.15);else if(n.key==="-")z_(1.15);else if(n.key.toLowerCase()==="f")Bu(po);else if(e)Np(e);else return;n.preventDefault()}function ET(n,t){let e=dn.position.clone().sub($n.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);dn.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add($n.target),$n.update(),ln()}function z_(n){dn.position.sub($n.target).multiplyScalar(n).add($n.target),$n.update(),ln()}var po=[[0,0,0],[0,0,1]];function $_(n,t){let e=new Si().setFromPoints(n.map(h=>new B(...h))),i=e.getCenter(new B),s=new B(...t).normalize(),r=new B().crossVectors(dn.up,s).normalize(),o=new B().crossVectors(s,r),a=Math.tan(va.degToRad(k_/2))*.8,l=a*dn.aspect,c=e.getSize(new B).length()*.4+.001;for(let h=0;h<3;h++){let u=0,f=1/0,d=-1/0,g=1/0,x=-1/0;for(let p of n){let m=new B(...p).sub(i),_=m.dot(r),w=m.dot(o),b=m.dot(s);u=Math.max(u,b+Math.abs(_)/l,b+Math.abs(w)/a),f=Math.min(f,w),d=Math.max(d,w),g=Math.min(g,_),x=Math.max(x,_)}c=Math.max(u,c*.2),h<2&&i.addScaledVector(o,(f+d)/2).addScaledVector(r,(g+x)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var Pp=0;function Dp({target:n,position:t},e=.35){let i={t:$n.target.clone(),p:dn.position.clone()},s=performance.now(),r=++Pp,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==Pp)return;let c=o?1:Math.min((l-s)/(1e3*e),1),h=c*c*(3-2*c);$n.target.lerpVectors(i.t,n,h),dn.position.lerpVectors(i.p,t,h);let u=dn.position.distanceTo($n.target);dn.near=u/100,dn.far=u*30,ri.fog.near=u*1.3,ri.fog.far=u*3.4,dn.updateProjectionMatrix(),$n.update(),ln(),c<1&&requestAnimationFrame(a)})(s)}function Bu(n,{instant:t=!1,view:e=null}={}){po=n,zu=!1;let i=e?H_[e]:dn.position.clone().sub($n.target).toArray();Dp($_(n,i),t?0:.35)}function Np(n){zu=!1,Dp($_(po,H_[n]))}var zu=!1;function Z_(){dn.updateMatrixWorld();let n=new B;return po.every(t=>(n.set(...t).project(dn),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Up(){!zu&&po.length&&!Z_()&&Bu(po)}var J_=n=>{po=n},ku=()=>[...dn.position.toArray(),...$n.target.toArray()].map(n=>Number(n.toPrecision(5)));function j_(n){Pp+=1,Dp({position:new B(...n.slice(0,3)),target:new B(...n.slice(3))},0)}var zs=null,Fp={cell:.1};function Op(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(h=>h*e).findLast(h=>h<=t*1.0001)??e;Fp.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new Qt(be.gridFine),l=new Qt(be.gridCoarse);for(let h=-s;h<=s;h++){let u=h%5===0?l:a,f=s*i;r.push(h*i,-f,0,h*i,f,0,-f,h*i,0,f,h*i,0);for(let d=0;d<4;d++)o.push(u.r,u.g,u.b)}zs?.geometry.dispose();let c=new Ce;c.setAttribute("position",new Te(r,3)),c.setAttribute("color",new Te(o,3)),zs?zs.geometry=c:(zs=new no(c,new hs({vertexColors:!0})),zs.renderOrder=-2,zs.material.depthWrite=!1,ri.add(zs)),zs.userData.reach=n,ln()}function Bp(){ri.background=new Qt(be.ground),ri.fog.color.set(be.ground),zs&&Op(zs.userData.reach),ln()}function K_(n){let t=new B(...n).project(dn),e=Ji.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Hu(n){let t=n.joints.length,e=Sc(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function zp(n,t,e){let i={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:s,size:r}=e,o=n.joints.length,a=r*1e-6,l=td(n,t),c=(u,f,d,g=!0)=>{As(is(f,u))<=a||(i.rods.push({a:u,b:f,r:d}),g&&i.balls.push({at:f,r:d}))};o&&(i.pedestal={at:$e(t[0]),dir:Kf(t[0],2),r:s[0]*1.7,h:s[0]*.34});let h=null;if(l.forEach(({point:u,dir:f,x:d},g)=>{let x=s[g],p=n.joints[g],m=$e(t[g]),_=$e(t[g+1]),w=x*.62;if(n.convention==="standard"){let S=xc(m,f,Qf(is(_,m),f));c(m,S,w),c(S,_,w)}else c(m,u,w),c(u,_,w);let b=u,C=Qf(is(_,u),f);h&&As(is(u,h.at))<.5*x&&Math.abs(C)>a?b=xc(u,f,Math.sign(C)*Math.min(Math.abs(C)*.55,h.r+x*1.15)):g===0&&Math.abs(C)>2.2*x&&(b=xc(u,f,Math.sign(C)*x*1.25)),p.type==="R"?i.drums.push({at:b,dir:f,x:d,r:x,h:x*2.15,joint:g}):i.sleeves.push({at:b,dir:f,x:d,r:x*.95,h:x*3.4,joint:g}),h={at:u,r:x}}),o){let u=t[o+1],f=$e(t[o]);i.flange={at:f,dir:Kf(t[o],2),r:e.rest*.85,h:e.rest*.5},c(f,$e(u),e.rest*.34,!1),i.tip={at:$e(u),r:e.rest*.42}}return i}function kp(n,t){let e=Hu(n).radius[0]??.05,i=$e(t[0]),s=[[i[0],i[1],0],...t.map($e)];for(let{point:r}of td(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function AT(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new Rl(s.map(([a,l])=>new qt(a,l)),n):new an(1,1,1,n),o={rod:i(new an(1,1,1,n,1,!0)),ball:t>3?new ro(1,n,t):new Us(1,0),drum:i(r),box:new on(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,h=l.index?l.index.array:Uint16Array.from({length:c.count},(u,f)=>f);return[a,{at:c.array,normal:l.attributes.normal.array,index:h,count:c.count}]}))}var Q_=new Map,Gp=(n,t)=>Q_.get(n)??Q_.set(n,AT(n,t)).get(n),RT=()=>Gp(26,12),Hp=()=>Gp(11,5),tx=()=>Gp(6,3),Vu=class{constructor(t){this.mesh=new Ft(new Ce,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Ce,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let h=new en(c,l).setUsage(Au);return s.setAttribute(a,h),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new en(o,1).setUsage(Au)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l){let c=this.corners,h=c+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let u=0,f=3*c;u<3*t.count;u+=3,f+=3){let d=a*t.at[u],g=a*t.at[u+1],x=l*t.at[u+2],p=t.normal[u]/a,m=t.normal[u+1]/a,_=t.normal[u+2]/l;for(let w=0;w<3;w++)this.at[f+w]=i[w]+s[w]*d+r[w]*g+o[w]*x,this.normal[f+w]=s[w]*p+r[w]*m+o[w]*_}this.paint.fill(e,c,h);for(let u=0;u<t.index.length;u++)this.index[this.indices+u]=c+t.index[u];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},ix=[1,0,0],CT=[0,1,0],sx=[0,0,1];function PT(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:yc(n,Math.abs(n[2])<.9?sx:ix),i=yc(n,e),s=As(i)||1,r=i.map(o=>o/s);return[yc(r,n),r]}var ex=0,Gu=1,nx=2,Ma=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new as,this.veil=i,this.moving=!1,this.arms=[],this.body=new Vu(t),this.group.add(this.body.mesh),e&&(this.flat=new Vu(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?tx:Hp:this.moving?Hp:RT;for(let i of t)this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of t)this.#t(this.flat,i,this.moving?tx():Hp(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,h,u,f,d,g,x)=>t.put(c,h,u,...PT(f,x),f,d,g),l=(c,h,u)=>t.put(i.ball,c,h,ix,CT,sx,u,u);for(let{a:c,b:h,r:u}of e.rods){let f=is(h,c),d=As(f),g=[(c[0]+h[0])/2,(c[1]+h[1])/2,(c[2]+h[2])/2];a(i.rod,ex,g,f.map(x=>x/d),r*u,d)}for(let{at:c,r:h}of e.balls)l(ex,c,r*h);for(let{at:c,dir:h,r:u,h:f}of e.drums)a(i.drum,Gu,c,h,r*u,r*f),o&&a(i.rod,nx,c,h,u*1.012,f*.13);for(let{at:c,dir:h,x:u,r:f,h:d}of e.sleeves)a(i.box,Gu,c,h,r*f,r*d,u);if(e.pedestal&&!this.veil){let{at:c,dir:h,r:u,h:f}=e.pedestal;a(i.drum,Gu,[c[0]+h[0]*f/2,c[1]+h[1]*f/2,c[2]+h[2]*f/2],h,u,f)}e.flange&&a(i.drum,Gu,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.tip&&o&&l(nx,e.tip.at,e.tip.r)}};var IT=`
  attribute float paint;
  uniform vec3 colours[3];
  varying vec3 vNormal;
  varying vec3 vToEye;
  varying vec3 vColour;
  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    vNormal = normalize(normal);
    vToEye = cameraPosition - world.xyz;
    vColour = paint < 0.5 ? colours[0] : paint < 1.5 ? colours[1] : colours[2];
    gl_Position = projectionMatrix * viewMatrix * world;
  }`,LT=`
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
  }`,DT=`
  uniform vec3 colours[3];
  uniform vec3 sky;
  uniform vec3 ground;
  varying vec3 vColour;
  const vec3 SUN = vec3(0.332, -0.443, 0.831);
  void main() {
    vec3 n = normalize(normal);
    vec3 linear = colours[0] * (mix(ground, sky, 0.5 + 0.5 * n.z) + 0.75 * max(dot(n, SUN), 0.0));
    vColour = pow(linear, vec3(1.0 / 2.2));
    gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
  }`,NT=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Wu({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new $i({vertexShader:e?DT:IT,fragmentShader:e?NT:LT,transparent:n<1,uniforms:{colours:{value:[new Qt,new Qt,new Qt]},opacity:{value:n},gloss:{value:t},sky:{value:new Qt(.46,.46,.47)},ground:{value:new Qt(.2,.2,.21)}}});return i.repaint=(s,r,o,a)=>{[s,r,o].forEach((l,c)=>i.uniforms.colours.value[c].set(l)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function Vp(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Ce;l.morphTargetsRelative=a;let c=0;for(let h=0;h<n.length;++h){let u=n[h],f=0,d=0;if(e!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let g in u.attributes){if(!i.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+g+'" attribute exists among all geometries, or in none of them.'),null;r[g]===void 0&&(r[g]=[]),r[g].push(u.attributes[g]),f++}if(f!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let g in u.morphAttributes){if(!s.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[g].length!==n[0].morphAttributes[g].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+g+'" morph attribute.'),null;o[g]===void 0&&(o[g]=[]),o[g].push(u.morphAttributes[g]),d++}if(d!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let g;if(e)g=u.index.count;else if(u.attributes.position!==void 0)g=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,g,h),c+=g}}if(e){let h=0,u=[];for(let f=0;f<n.length;++f){let d=n[f].index;for(let g=0;g<d.count;++g)u.push(d.getX(g)+h);h+=n[f].attributes.position.count}l.setIndex(u)}for(let h in r){let u=rx(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let f=0;f<u;++f){let d=[];for(let x=0;x<o[h].length;++x)d.push(o[h][x][f]);let g=rx(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(g)}}}return l}function rx(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let h=n[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=h.normalized),i!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new en(o,e,i),l=0;for(let c=0;c<n.length;++c){let h=n[c];if(h.isInterleavedBufferAttribute){let u=l/e;for(let f=0,d=h.count;f<d;f++)for(let g=0;g<e;g++){let x=h.getComponent(f,g);a.setComponent(f+u,g,x)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var Wl=["#d8343f","#1b9a50","#2f6fe0"];function Wp(n,t){let e=new an(.028,.028,.82,8).translate(0,.41,0),i=new Al(.085,.22,12).translate(0,.9,0),s=Vp([e,i]).applyMatrix4(t),r=new Qt(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new en(o,3)),s}var Xp=n=>new Me().makeRotationFromQuaternion(new Ze().setFromUnitVectors(new B(0,1,0),new B(...n))),UT=Vp([Wp(Wl[0],Xp([1,0,0])),Wp(Wl[1],Xp([0,1,0])),Wp(Wl[2],Xp([0,0,1]))]),ox=.021,Xl=new Map;function FT(n){let t=`${n}/${be.dark}`;if(Xl.has(t))return Xl.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=be.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=be.ink,s.fillText(n,e.width/2,e.height/2);let o=new wl(e);o.colorSpace=pi;let a=new fa({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,Xl.set(t,a),a}var Xu=class{constructor(){this.group=new as,this.mesh=new Sl(UT,new cs({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new Me;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new B(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new vl);a.parent||this.group.add(a),a.material=FT(r),a.scale.set(ox*a.material.userData.aspect,ox,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of Xl.values())t.map.dispose(),t.dispose();Xl.clear(),this.last&&this.show(...this.last)}};var hx=Wu(),ax=[.32,-.4,1],ux=new cs({color:"#000",transparent:!0,opacity:.1,side:Mi,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:ip,stencilRef:1,stencilZPass:np,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),OT=new Me().set(1,0,-ax[0],0,0,1,-ax[1],0,0,0,0,5e-4,0,0,0,1),qp=new Ma(hx,{shadow:{material:ux,matrix:OT}}),fx=Wu({opacity:.2,veil:!0}),qu=new Ma(fx,{veil:!0}),dx=Wu({opacity:.62,gloss:.1}),Yp=new Ma(dx,{veil:!0}),$p=new Xu,mo=Hu(O.table),Zu=[],$u=null;function px(){ri.add(qp.group,qu.group,Yp.group,$p.group),qu.group.renderOrder=1,Pt("table",n=>{mo=Hu(O.table),Op(mo.size),Zu=[],$u=null,Jp(),Ku(),n==="new"&&zr({instant:!0,view:"iso"}),X_()}),Pt("q",zT),Pt("frames",mx),Pt("theme",cx),Pt("hurry",n=>{for(let t of[qp,qu,Yp])t.hurry(n)}),cx()}var lx=new Map,Zp=[];function Ju(n,t){lx.set(n,t),Zp=[...lx.values()].flat()}function zr(n){Bu([...kp(O.table,O.frames),...Zp],n)}var BT=Mr(Up,220);function zT(){let n=O.frames;qp.show(O.table.joints.length?[zp(O.table,n,mo)]:[]),J_([...kp(O.table,n),...Zp]),BT(),yx&&kT($e(n[n.length-1])),mx()}function mx(){$p.show((O.shownFrames??[]).filter(n=>n<O.frames.length).map(n=>({T:O.frames[n],name:ju(n)})),mo.size*.13),ln()}function ju(n){let t=O.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function gx(n){Zu=n,Jp()}function wa(n){$u=n,Jp()}var _x=()=>Zu.length;function Jp(){let n=t=>zp(O.table,vr(O.table,t),mo);qu.show(Zu.map(n)),Yp.show($u?[n($u)]:[]),ln()}var xx=6e3,Yu=new Float32Array(6*xx),ur=new no(new Ce,new hs({fog:!1}));ur.geometry.setAttribute("position",new en(Yu,3));ur.frustumCulled=!1;ur.visible=!1;var Br=0,yx=!0,ql=null;ri.add(ur);function kT(n){let t=ql?As(is(n,ql)):1/0;t<mo.size*.002||(t<mo.size*.2&&(Br===xx&&(Yu.copyWithin(0,6*1e3),Br-=1e3),Yu.set(ql,6*Br),Yu.set(n,6*Br+3),Br+=1,ur.geometry.setDrawRange(0,2*Br),ur.geometry.attributes.position.needsUpdate=!0,ur.visible=!0),ql=n)}function vx(n){yx=n,n||Ku(),ln()}function Ku(){Br=0,ql=null,ur.visible=!1,ln()}var bx=()=>Br,Yl=new xi(new Ce,new hs({fog:!1}));Yl.frustumCulled=!1;var $l=new io(new Ce,new Cr({size:4,sizeAttenuation:!1,fog:!1}));$l.frustumCulled=!1;Yl.visible=$l.visible=!1;ri.add(Yl,$l);function Qu(n){Ju("path",n);let t=new Float32Array(n.flat());for(let e of[Yl,$l])e.geometry.dispose(),e.geometry=new Ce,e.geometry.setAttribute("position",new en(t,3)),e.visible=n.length>0;ln()}function cx(){hx.repaint(be.link,be.joint,be.accent,be.dark),fx.repaint(be.ghost,be.ghost,be.ghost,be.dark),dx.repaint(be.accent,be.accent,be.accent,be.dark),ur.material.color.set(be.accent),Yl.material.color.set(be.trace),$l.material.color.set(be.trace),ux.opacity=be.dark?.28:.11,$p.paint(),ln()}var go=new Il,yn=new B,kr=new B,cn=new Ze,Sx={X:new B(1,0,0),Y:new B(0,1,0),Z:new B(0,0,1)},jp={type:"change"},Mx={type:"mouseDown",mode:null},wx={type:"mouseUp",mode:null},Ex={type:"objectChange"},rf=class extends oo{constructor(t,e=null){super(void 0,e);let i=new Qp(this);this._root=i;let s=new tm;this._gizmo=s,i.add(s);let r=new em;this._plane=r,i.add(r);let o=this;function a(w,b){let C=b;Object.defineProperty(o,w,{get:function(){return C!==void 0?C:b},set:function(S){C!==S&&(C=S,r[w]=S,s[w]=S,o.dispatchEvent({type:w+"-changed",value:S}),o.dispatchEvent(jp))}}),o[w]=b,r[w]=b,s[w]=b}a("camera",t),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new B,c=new B,h=new Ze,u=new Ze,f=new B,d=new Ze,g=new B,x=new B,p=new B,m=0,_=new B;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",h),a("worldQuaternionStart",u),a("cameraPosition",f),a("cameraQuaternion",d),a("pointStart",g),a("pointEnd",x),a("rotationAxis",p),a("rotationAngle",m),a("eye",_),this._offset=new B,this._startNorm=new B,this._endNorm=new B,this._cameraScale=new B,this._parentPosition=new B,this._parentQuaternion=new Ze,this._parentQuaternionInv=new Ze,this._parentScale=new B,this._worldScaleStart=new B,this._worldQuaternionInv=new Ze,this._worldScale=new B,this._positionStart=new B,this._quaternionStart=new Ze,this._scaleStart=new B,this._getPointer=GT.bind(this),this._onPointerDown=WT.bind(this),this._onPointerHover=VT.bind(this),this._onPointerMove=XT.bind(this),this._onPointerUp=qT.bind(this),e!==null&&this.connect(e)}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(t){if(this.object===void 0||this.dragging===!0)return;t!==null&&go.setFromCamera(t,this.camera);let e=Kp(this._gizmo.picker[this.mode],go);e?this.axis=e.object.name:this.axis=null}pointerDown(t){if(!(this.object===void 0||this.dragging===!0||t!=null&&t.button!==0)&&this.axis!==null){t!==null&&go.setFromCamera(t,this.camera);let e=Kp(this._plane,go,!0);e&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(e.point).sub(this.worldPositionStart)),this.dragging=!0,Mx.mode=this.mode,this.dispatchEvent(Mx)}}pointerMove(t){let e=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(e==="E"||e==="XYZE"||e==="XYZ")&&(r="world"),s===void 0||e===null||this.dragging===!1||t!==null&&t.button!==-1)return;t!==null&&go.setFromCamera(t,this.camera);let o=Kp(this._plane,go,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&e!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),e.indexOf("X")===-1&&(this._offset.x=0),e.indexOf("Y")===-1&&(this._offset.y=0),e.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&e!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(cn.copy(this._quaternionStart).invert()),e.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(yn),e.search("X")!==-1&&(yn.x=Math.round(yn.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(yn.y=Math.round(yn.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(yn.z=Math.round(yn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(yn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(e.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),kr.set(a,a,a)}else yn.copy(this.pointStart),kr.copy(this.pointEnd),yn.applyQuaternion(this._worldQuaternionInv),kr.applyQuaternion(this._worldQuaternionInv),kr.divide(yn),e.search("X")===-1&&(kr.x=1),e.search("Y")===-1&&(kr.y=1),e.search("Z")===-1&&(kr.z=1);s.scale.copy(this._scaleStart).multiply(kr),this.scaleSnap&&(e.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(yn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;e==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(yn.copy(this.rotationAxis).cross(this.eye))*a):(e==="X"||e==="Y"||e==="Z")&&(this.rotationAxis.copy(Sx[e]),yn.copy(Sx[e]),r==="local"&&yn.applyQuaternion(this.worldQuaternion),yn.cross(this.eye),yn.length()===0?l=!0:this.rotationAngle=this._offset.dot(yn.normalize())*a),(e==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&e!=="E"&&e!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(jp),this.dispatchEvent(Ex)}}pointerUp(t){t!==null&&t.button!==0||(this.dragging&&this.axis!==null&&(wx.mode=this.mode,this.dispatchEvent(wx)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(t){return this.object=t,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(jp),this.dispatchEvent(Ex),this.pointStart.copy(this.pointEnd))}getRaycaster(){return go}getMode(){return this.mode}setMode(t){this.mode=t}setTranslationSnap(t){this.translationSnap=t}setRotationSnap(t){this.rotationSnap=t}setScaleSnap(t){this.scaleSnap=t}setSize(t){this.size=t}setSpace(t){this.space=t}setColors(t,e,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(t),r.yAxis.color.set(e),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(t),r.yAxisTransparent.color.set(e),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(t),r.yAxis._color&&r.yAxis._color.set(e),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(t),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(e),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function GT(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let t=this.domElement.getBoundingClientRect(),e=this.viewport,i,s,r,o;return e!==null?(i=e.x,s=t.height-e.y-e.w,r=e.z,o=e.w):(i=0,s=0,r=t.width,o=t.height),{x:(n.clientX-t.left-i)/r*2-1,y:-(n.clientY-t.top-s)/o*2+1,button:n.button}}}function VT(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function WT(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function XT(n){this.enabled&&this.pointerMove(this._getPointer(n))}function qT(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Kp(n,t,e){let i=t.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||e)return i[s];return!1}var tf=new Ls,We=new B(0,1,0),Tx=new B(0,0,0),Ax=new Me,ef=new Ze,sf=new Ze,Hs=new B,of=new Me,jl=new B(1,0,0),_o=new B(0,1,0),Kl=new B(0,0,1),nf=new B,Zl=new B,Jl=new B,Qp=class extends Sn{constructor(t){super(),this.isTransformControlsRoot=!0,this.controls=t,this.visible=!1}updateMatrixWorld(t){let e=this.controls;e.object!==void 0&&(e.object.updateMatrixWorld(),e.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):e.object.parent.matrixWorld.decompose(e._parentPosition,e._parentQuaternion,e._parentScale),e.object.matrixWorld.decompose(e.worldPosition,e.worldQuaternion,e._worldScale),e._parentQuaternionInv.copy(e._parentQuaternion).invert(),e._worldQuaternionInv.copy(e.worldQuaternion).invert()),e.camera.updateMatrixWorld(),e.camera.matrixWorld.decompose(e.cameraPosition,e.cameraQuaternion,e._cameraScale),e.camera.isOrthographicCamera?e.camera.getWorldDirection(e.eye).negate():e.eye.copy(e.cameraPosition).sub(e.worldPosition).normalize(),this.parent&&(of.copy(this.parent.matrixWorld).invert(),of.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(t)}dispose(){this.traverse(function(t){t.geometry&&t.geometry.dispose(),t.material&&t.material.dispose()})}},tm=class extends Sn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let t=new cs({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),e=new hs({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=t.clone();i.opacity=.15;let s=e.clone();s.opacity=.5;let r=t.clone();r.color.setHex(16711680);let o=t.clone();o.color.setHex(65280);let a=t.clone();a.color.setHex(255);let l=t.clone();l.color.setHex(16711680),l.opacity=.5;let c=t.clone();c.color.setHex(65280),c.opacity=.5;let h=t.clone();h.color.setHex(255),h.opacity=.5;let u=t.clone();u.opacity=.25;let f=t.clone();f.color.setHex(16776960),f.opacity=.25;let d=t.clone();d.color.setHex(16776960);let g=t.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:d,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:f};let x=new an(0,.04,.1,12);x.translate(0,.05,0);let p=new on(.08,.08,.08);p.translate(0,.04,0);let m=new Ce;m.setAttribute("position",new Te([0,0,0,1,0,0],3));let _=new an(.0075,.0075,.5,3);_.translate(0,.25,0);function w(V,Z){let W=new ar(V,.0075,3,64,Z*Math.PI*2);return W.rotateY(Math.PI/2),W.rotateX(Math.PI/2),W}function b(){let V=new Ce;return V.setAttribute("position",new Te([0,0,0,1,1,1],3)),V}let C={X:[[new Ft(x,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ft(x,r),[-.5,0,0],[0,0,Math.PI/2]],[new Ft(_,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Ft(x,o),[0,.5,0]],[new Ft(x,o),[0,-.5,0],[Math.PI,0,0]],[new Ft(_,o)]],Z:[[new Ft(x,a),[0,0,.5],[Math.PI/2,0,0]],[new Ft(x,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Ft(_,a),null,[Math.PI/2,0,0]]],XYZ:[[new Ft(new Us(.1,0),u),[0,0,0]]],XY:[[new Ft(new on(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new Ft(new on(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new on(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},S={X:[[new Ft(new an(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ft(new an(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ft(new an(.2,0,.6,4),i),[0,.3,0]],[new Ft(new an(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ft(new an(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ft(new an(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Ft(new Us(.2,0),i)]],XY:[[new Ft(new on(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ft(new on(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new on(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},y={START:[[new Ft(new Us(.01,2),s),null,null,null,"helper"]],END:[[new Ft(new Us(.01,2),s),null,null,null,"helper"]],DELTA:[[new xi(b(),s),null,null,null,"helper"]],X:[[new xi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new xi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new xi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},M={XYZE:[[new Ft(w(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new Ft(w(.5,.5),r)]],Y:[[new Ft(w(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Ft(w(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Ft(w(.75,1),f),null,[0,Math.PI/2,0]]]},U={AXIS:[[new xi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},I={XYZE:[[new Ft(new ro(.25,10,8),i)]],X:[[new Ft(new ar(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Ft(new ar(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Ft(new ar(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Ft(new ar(.75,.1,2,24),i)]]},D={X:[[new Ft(p,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ft(_,r),[0,0,0],[0,0,-Math.PI/2]],[new Ft(p,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Ft(p,o),[0,.5,0]],[new Ft(_,o)],[new Ft(p,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Ft(p,a),[0,0,.5],[Math.PI/2,0,0]],[new Ft(_,a),[0,0,0],[Math.PI/2,0,0]],[new Ft(p,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Ft(new on(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new Ft(new on(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new on(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ft(new on(.1,.1,.1),u)]]},z={X:[[new Ft(new an(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ft(new an(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ft(new an(.2,0,.6,4),i),[0,.3,0]],[new Ft(new an(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ft(new an(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ft(new an(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Ft(new on(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ft(new on(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new on(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ft(new on(.2,.2,.2),i),[0,0,0]]]},X={X:[[new xi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new xi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new xi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(V){let Z=new Sn;for(let W in V)for(let ct=V[W].length;ct--;){let $=V[W][ct][0].clone(),tt=V[W][ct][1],st=V[W][ct][2],ft=V[W][ct][3],dt=V[W][ct][4];$.name=W,$.tag=dt,tt&&$.position.set(tt[0],tt[1],tt[2]),st&&$.rotation.set(st[0],st[1],st[2]),ft&&$.scale.set(ft[0],ft[1],ft[2]),$.updateMatrix();let et=$.geometry.clone();et.applyMatrix4($.matrix),$.geometry=et,$.renderOrder=1/0,$.position.set(0,0,0),$.rotation.set(0,0,0),$.scale.set(1,1,1),Z.add($)}return Z}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(C)),this.add(this.gizmo.rotate=N(M)),this.add(this.gizmo.scale=N(D)),this.add(this.picker.translate=N(S)),this.add(this.picker.rotate=N(I)),this.add(this.picker.scale=N(z)),this.add(this.helper.translate=N(y)),this.add(this.helper.rotate=N(U)),this.add(this.helper.scale=N(X)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(t){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:sf;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(cn.setFromEuler(tf.set(0,0,0)),o.quaternion.copy(i).multiply(cn),Math.abs(We.copy(jl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(cn.setFromEuler(tf.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(cn),Math.abs(We.copy(_o).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(cn.setFromEuler(tf.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(cn),Math.abs(We.copy(Kl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(cn.setFromEuler(tf.set(0,Math.PI/2,0)),We.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Ax.lookAt(Tx,We,_o)),o.quaternion.multiply(cn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),yn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),yn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(yn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(We.copy(jl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(We.copy(_o).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(We.copy(Kl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(We.copy(Kl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(We.copy(jl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(We.copy(_o).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(ef.copy(i),We.copy(this.eye).applyQuaternion(cn.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Ax.lookAt(this.eye,Tx,_o)),o.name==="X"&&(cn.setFromAxisAngle(jl,Math.atan2(-We.y,We.z)),cn.multiplyQuaternions(ef,cn),o.quaternion.copy(cn)),o.name==="Y"&&(cn.setFromAxisAngle(_o,Math.atan2(We.x,We.z)),cn.multiplyQuaternions(ef,cn),o.quaternion.copy(cn)),o.name==="Z"&&(cn.setFromAxisAngle(Kl,Math.atan2(We.y,We.x)),cn.multiplyQuaternions(ef,cn),o.quaternion.copy(cn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(t)}},em=class extends Ft{constructor(){super(new so(1e5,1e5,2,2),new cs({visible:!1,wireframe:!0,side:Mi,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(t){let e=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(e="local"),nf.copy(jl).applyQuaternion(e==="local"?this.worldQuaternion:sf),Zl.copy(_o).applyQuaternion(e==="local"?this.worldQuaternion:sf),Jl.copy(Kl).applyQuaternion(e==="local"?this.worldQuaternion:sf),We.copy(Zl),this.mode){case"translate":case"scale":switch(this.axis){case"X":We.copy(this.eye).cross(nf),Hs.copy(nf).cross(We);break;case"Y":We.copy(this.eye).cross(Zl),Hs.copy(Zl).cross(We);break;case"Z":We.copy(this.eye).cross(Jl),Hs.copy(Jl).cross(We);break;case"XY":Hs.copy(Jl);break;case"YZ":Hs.copy(nf);break;case"XZ":We.copy(Jl),Hs.copy(Zl);break;case"XYZ":case"E":Hs.set(0,0,0);break}break;default:Hs.set(0,0,0)}Hs.length()===0?this.quaternion.copy(this.cameraQuaternion):(of.lookAt(yn.set(0,0,0),Hs,We),this.quaternion.setFromRotationMatrix(of)),super.updateMatrixWorld(t)}};var ps=new Sn,Ql=[],nm="both",Rx="local",im=!1,Cx=!1,af=()=>Cx;function Px(){ri.add(ps),Pt("target",ZT)}function YT(){for(let[n,t]of[["translate",.75],["rotate",.55]]){let e=new rf(dn,ks.domElement);e.setMode(n),e.setSize(t),e.setSpace(Rx),e.attach(ps),e.addEventListener("dragging-changed",({value:i})=>{$n.enabled=!i,Cx=i;for(let s of Ql)s!==e&&(s.enabled=!i&&im);i||Cs(O.target,"dropped")}),e.addEventListener("change",ln),e.addEventListener("objectChange",()=>{ps.updateMatrix();let i=ps.matrix.elements;Cs([i[0],i[4],i[8],i[12],i[1],i[5],i[9],i[13],i[2],i[6],i[10],i[14],0,0,0,1],"drag")}),$T(e.getHelper()),Ql.push(e),ri.add(e.getHelper())}}function $T(n){n.traverse(({geometry:t})=>{if(t?.type!=="TorusGeometry")return;let{radialSegments:e,tubularSegments:i}=t.parameters,s=i+1,r=[];if(!(i<64)){for(let o=1;o<=e;o++)for(let a=0;a+2<=i;a+=2){let[l,c,h,u]=[s*o+a,s*(o-1)+a,s*(o-1)+a+2,s*o+a+2];r.push(l,c,u,c,h,u)}t.setIndex(r)}})}function ZT(n){if(n==="drag"||n==="dropped")return;let t=O.target;ps.matrix.set(...t),ps.matrix.decompose(ps.position,ps.quaternion,ps.scale),ps.scale.set(1,1,1),ps.updateMatrixWorld(!0),ln()}function Ix(){Ql.forEach((n,t)=>{let e=im&&(nm==="both"||nm===(t===0?"move":"turn"));n.enabled=e,n.getHelper().visible=e}),ln()}function Lx(n){im=n,n&&!Ql.length&&YT(),Ix()}function Dx(n){nm=n,Ix()}function Nx(n){Rx=n;for(let t of Ql)t.setSpace(n);ln()}var Ei={follow:!0,ghosts:"all",task:null,redundancy:null},sm={answers:0},xo=ed(async()=>{let n=O.target,t=O.table;try{let e=af(),i=await ei("ik",{T:n,q:O.q,brief:e,task:Ei.task,redundancy:Ei.redundancy});if(t!==O.table||n!==O.target&&!e)return;sm.answers+=1,O.solutions={...i,T:n},Ei.follow&&i.nearest&&Rs(i.nearest,"follow"),Ea(),oe("solutions"),i.status==="OUT_OF_REACH"&&!e&&JT(n)}catch(e){if(e instanceof Rc)return;O.solutions={rows:[],families:[],status:"REFUSED",why:e.message,nearest:null},Ea(),oe("solutions")}}),JT=ed(async n=>{try{let t=await ei("nearest",{T:n});O.solutions&&O.solutions.T===n&&(O.solutions.near=t,oe("solutions"))}catch{}}),jT=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function Ea(){let n=O.solutions?.rows??[],t=O.panel==="inverse"&&Ei.ghosts!=="none"?n.filter(e=>(Ei.ghosts==="all"||e.inside)&&!jT(e.q,O.q)):[];gx(t.map(e=>e.q))}function Fx(){Pt("target",()=>{O.panel==="inverse"&&xo()}),Pt("panel",n=>{wa(null),n==="inverse"&&O.hasTarget&&!O.solutions&&xo(),Ea()}),Pt("moving",n=>{n||Ea()}),Pt("table",n=>{Ei.redundancy=null,oe("solutions"),n!=="new"&&O.panel==="inverse"&&O.hasTarget&&xo()}),Pt("online",n=>{n&&O.panel==="inverse"&&O.hasTarget&&O.table.joints.length&&xo()})}var om=180/Math.PI,Ti={angle:"deg",length:"mm"},QT={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},rm={deg:om,rad:1,mm:1e3,m:1},tA={deg:2,rad:4,mm:2,m:5},eA={deg:1,rad:.02,mm:5,m:.005},Ut={get angle(){return Ti.angle},get length(){return Ti.length},set(n,t){t in rm&&n in Ti&&(Ti[n]=t)},factor:n=>n in Ti?rm[Ti[n]]:1,symbol:n=>n in Ti?QT[Ti[n]]:"",digits:n=>n in Ti?tA[Ti[n]]:4,step:n=>n in Ti?eA[Ti[n]]/rm[Ti[n]]:.01,suffix:n=>n==="angle"?{deg:om,"\xB0":om,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function Zn(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var vi=(n,t,e=Ut.digits(t))=>Zn(n*Ut.factor(t),e),Jn=(n,t,e)=>`${vi(n,t,e)}${t==="angle"&&Ti.angle==="deg"?"":" "}${Ut.symbol(t)}`,tc=(n,t="plain")=>String(Number((n*Ut.factor(t)).toPrecision(9))+0),lf=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");var am=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],Ta=n=>[Math.cos(n),Math.sin(n)];function nA([n,t,e]){let[i,s]=Ta(e),[r,o]=Ta(t),[a,l]=Ta(n);return am([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function iA(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function sA([n,t,e]){let[i,s]=Ta(n),[r,o]=Ta(t),[a,l]=Ta(e);return am([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function rA(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function cf(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],u=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],f=u[0]<0?-1:1;return u.map(d=>f*d+0)}function lm(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return am([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function oA(n){let[t,e,i,s]=cf(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function aA([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:lm([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var ms={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:iA,from:nA},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:rA,from:sA},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:oA,from:aA},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:cf,from:lm}};function Ox(n,t,e){let i=ms[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Bx(n,t,e){let i=cf(n),s=cf(t),r=i.reduce((u,f,d)=>u+f*s[d],0);r<0&&(s=s.map(u=>-u),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],h=lm(i.map((u,f)=>l*u+c*s[f]));return[3,7,11].forEach(u=>{h[u]=n[u]+e*(t[u]-n[u])}),h}var kx=1,lA=30;function cm(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=O;return{pieper:kx,table:n,q:t,target:i?e:null,notation:s,frames:r,path:o,sequence:a,panel:l,theme:c,units:[Ut.angle,Ut.length],camera:ku()}}var Gr=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,ec=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(Gr),Hr=(n,t)=>typeof n=="string"?n.slice(0,t):"",nc=n=>{if(!ec(n,16))return null;let t=vc(n);return t<1e-12?n.slice():t<.001?bc(n):null},cA=n=>n&&[n.lower,n.upper,n.value].every(Gr)&&n.lower<=n.upper?{name:Hr(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:Hr(n.unit,10)}:null;function hA(n){if(!n||!Array.isArray(n.joints)||n.joints.length>lA||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>Gr(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:Hr(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:Gr(i.lower)?i.lower:null,upper:Gr(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>ec(i,t.length)).slice(0,40));return{name:Hr(n.name,60),convention:n.convention,joints:t,base:nc(n.base)??$s(),tool:nc(n.tool)??$s(),postures:e,manufacturer:Hr(n.manufacturer,200),source:Hr(n.source,2e3),notes:Hr(n.notes,3e3),actuator:cA(n.actuator)}}function hf(n,t){let e=n&&n.pieper===kx?hA(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(Ut.set("angle",n.units[0]),Ut.set("length",n.units[1])),Object.hasOwn(ms,n.notation)&&(O.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Ic(n.theme),O.shownFrames=Array.isArray(n.frames)?n.frames.filter(o=>Number.isInteger(o)&&o>=0&&o<i+2):null;let s=n.path??{};Dn(e,{q:ec(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(O.path,{from:nc(s.from),to:nc(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:Gr(s.seconds)&&s.seconds>0?s.seconds:5}),O.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(o=>o&&ec(o.q,i)&&Gr(o.seconds)&&Gr(o.hold)).slice(0,40).map(o=>({name:Hr(o.name,20)||"P",q:o.q.slice(),seconds:o.seconds,hold:o.hold}));let r=nc(n.target);O.hasTarget=!!r,r&&Cs(r,"restored"),Ac();for(let o of["units","notation","sequence-loaded"])oe(o);t(n.panel),oe("path-loaded"),ec(n.camera,6)&&j_(n.camera),Rs(O.q,"restored")}async function Hx(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function uf(){let n=await Hx(new TextEncoder().encode(JSON.stringify(cm())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function Gx(){let n=/^#s=([\w-]+)$/.exec(location.hash);if(!n)return null;if(n[1].length>6e4)throw new Error("The link is too long.");let t=Uint8Array.from(atob(n[1].replaceAll("-","+").replaceAll("_","/")),i=>i.charCodeAt(0)),e=await Hx(t,DecompressionStream);if(e.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(e))}var zx=null,uA=Mr(async()=>{if(!O.table.joints.length)return;let n=await uf();n!==zx&&(zx=n,history.replaceState(null,"",n))},600);function Vx(){Pt(["table","q","target","units","notation","panel","path","sequence","theme","frames"],uA)}var dA="uplot",pA="u-hz",mA="u-vt",gA="u-title",_A="u-wrap",xA="u-under",yA="u-over",vA="u-axis",bo="u-off",bA="u-select",SA="u-cursor-x",MA="u-cursor-y",wA="u-cursor-pt",EA="u-legend",TA="u-live",AA="u-inline",RA="u-series",CA="u-marker",Wx="u-label",PA="u-value",sc="width",rc="height";var Xx="bottom",Aa="left",hm="right",Am="#000",qx=Am+"0",um="mousemove",Yx="mousedown",fm="mouseup",$x="mouseenter",Zx="mouseleave",Jx="dblclick",IA="resize",LA="scroll",jx="change",gf="dppxchange",Rm="--",Na=typeof window<"u",_m=Na?document:null,Ca=Na?window:null,DA=Na?navigator:null,Ne,ff;function xm(){let n=devicePixelRatio;Ne!=n&&(Ne=n,ff&&vm(jx,ff,xm),ff=matchMedia(`(min-resolution: ${Ne-.001}dppx) and (max-resolution: ${Ne+.001}dppx)`),So(jx,ff,xm),Ca.dispatchEvent(new CustomEvent(gf)))}function ki(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function ym(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function nn(n,t,e){n.style[t]=e+"px"}function gs(n,t,e,i){let s=_m.createElement(n);return t!=null&&ki(s,t),e?.insertBefore(s,i),s}function ji(n,t){return gs("div",n,t)}var Kx=new WeakMap;function Gs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Kx.get(n);r!=o&&(n.style.transform=r,Kx.set(n,r),t<0||e<0||t>i||e>s?ki(n,bo):ym(n,bo))}var Qx=new WeakMap;function ty(n,t,e){let i=t+e,s=Qx.get(n);i!=s&&(Qx.set(n,i),n.style.background=t,n.style.borderColor=e)}var ey=new WeakMap;function ny(n,t,e,i){let s=t+""+e,r=ey.get(n);s!=r&&(ey.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Cm={passive:!0},NA={...Cm,capture:!0};function So(n,t,e,i){t.addEventListener(n,e,i?NA:Cm)}function vm(n,t,e,i){t.removeEventListener(n,e,Cm)}Na&&xm();function _s(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Hi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Py(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Iy=n=>n!=null,Ly=n=>n!=null&&n>0,yf=Py(Iy),UA=Py(Ly);function FA(n,t,e,i=0,s=!1){let r=s?UA:yf,o=s?Ly:Iy;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Xe,l??-Xe]}function vf(n,t,e,i){let s=ry(n),r=ry(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?fr:Dy,a=s==1?Hi:Ki,l=r==1?Ki:Hi,c=a(o(Bn(n))),h=l(o(Bn(t))),u=Pa(e,c),f=Pa(e,h);return e==10&&(c<0&&(u=qe(u,-c)),h<0&&(f=qe(f,-h))),i||e==2?(n=u*s,t=f*r):(n=Oy(n,u),t=bf(t,f)),[n,t]}function Pm(n,t,e,i){let s=vf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Im=.1,iy={mode:3,pad:Im},ac={pad:0,soft:null,mode:0},OA={min:ac,max:ac};function _f(n,t,e,i){return Sf(e)?sy(n,t,e):(ac.pad=e,ac.soft=i?0:null,ac.mode=i?3:0,sy(n,t,OA))}function Ie(n,t){return n??t}function BA(n,t,e){for(t=Ie(t,0),e=Ie(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function sy(n,t,e){let i=e.min,s=e.max,r=Ie(i.pad,0),o=Ie(s.pad,0),a=Ie(i.hard,-Xe),l=Ie(s.hard,Xe),c=Ie(i.soft,Xe),h=Ie(s.soft,-Xe),u=Ie(i.mode,0),f=Ie(s.mode,0),d=t-n,g=fr(d),x=bi(Bn(n),Bn(t)),p=fr(x),m=Bn(p-g);(d<1e-24||m>10)&&(d=0,(n==0||t==0)&&(d=1e-24,u==2&&c!=Xe&&(r=0),f==2&&h!=-Xe&&(o=0)));let _=d||x||1e3,w=fr(_),b=Pa(10,Hi(w)),C=_*(d==0?n==0?.1:1:r),S=qe(Oy(n-C,b/10),24),y=n>=c&&(u==1||u==3&&S<=c||u==2&&S>=c)?c:Xe,M=bi(a,S<y&&n>=y?y:xs(y,S)),U=_*(d==0?t==0?.1:1:o),I=qe(bf(t+U,b/10),24),D=t<=h&&(f==1||f==3&&I>=h||f==2&&I<=h)?h:-Xe,z=xs(l,I>D&&t<=D?D:bi(D,I));return M==z&&M==0&&(z=100),[M,z]}var zA=new Intl.NumberFormat(Na?DA.language:"en-US"),Lm=n=>zA.format(n),Gi=Math,mf=Gi.PI,Bn=Gi.abs,Hi=Gi.floor,On=Gi.round,Ki=Gi.ceil,xs=Gi.min,bi=Gi.max,Pa=Gi.pow,ry=Gi.sign,fr=Gi.log10,Dy=Gi.log2,kA=(n,t=1)=>Gi.sinh(n)*t,dm=(n,t=1)=>Gi.asinh(n/t),Xe=1/0;function oy(n){return(fr((n^n>>31)-(n>>31))|0)+1}function bm(n,t,e){return xs(bi(n,t),e)}function Ny(n){return typeof n=="function"}function Ae(n){return Ny(n)?n:()=>n}var HA=()=>{},Uy=n=>n,Fy=(n,t)=>t,GA=n=>null,ay=n=>!0,ly=(n,t)=>n==t,VA=/\.\d*?(?=9{6,}|0{6,})/gm,Mo=n=>{if(zy(n)||Wr.has(n))return n;let t=`${n}`,e=t.match(VA);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Mo(s)}e${r}`}return qe(n,i)};function yo(n,t){return Mo(qe(Mo(n/t))*t)}function bf(n,t){return Mo(Ki(Mo(n/t))*t)}function Oy(n,t){return Mo(Hi(Mo(n/t))*t)}function qe(n,t=0){if(zy(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return On(i)/e}var Wr=new Map;function By(n){return((""+n).split(".")[1]||"").length}function cc(n,t,e,i){let s=[],r=i.map(By);for(let o=t;o<e;o++){let a=Bn(o),l=qe(Pa(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?h:qe(h,u);s.push(f),Wr.set(f,u)}}return s}var lc={},Dm=[],Ia=[null,null],Vr=Array.isArray,zy=Number.isInteger,WA=n=>n===void 0;function cy(n){return typeof n=="string"}function Sf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function XA(n){return n!=null&&typeof n=="object"}var qA=Object.getPrototypeOf(Uint8Array),ky="__proto__";function La(n,t=Sf){let e;if(Vr(n)){let i=n.find(s=>s!=null);if(Vr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=La(n[s],t)}else e=n.slice()}else if(n instanceof qA)e=n.slice();else if(t(n)){e={};for(let i in n)i!=ky&&(e[i]=La(n[i],t))}else e=n;return e}function Pn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=ky&&(Sf(n[s])?Pn(n[s],La(i[s])):n[s]=La(i[s]))}return n}var YA=0,$A=1,ZA=2;function JA(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function jA(n,t){if(tR(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return eR(o[0])||(o=QA(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:$A,d=[];for(let g=0;g<h.length;g++){let x=h[g],p=r.get(l[g]);x===null?f!=YA&&(u[p]=x,f==ZA&&d.push(p)):u[p]=x}JA(u,d,s),i.push(u)}}return i}var KA=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function QA(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function tR(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function eR(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=bi(1,Hi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Hy=["January","February","March","April","May","June","July","August","September","October","November","December"],Gy=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Vy(n){return n.slice(0,3)}var nR=Gy.map(Vy),iR=Hy.map(Vy),sR={MMMM:Hy,MMM:iR,WWWW:Gy,WWW:nR};function ic(n){return(n<10?"0":"")+n}function rR(n){return(n<10?"00":n<100?"0":"")+n}var oR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>ic(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ic(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>ic(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ic(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ic(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>rR(n.getMilliseconds())};function Nm(n,t){t=t||sR;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?oR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var aR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function lR(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==aR?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Wy=n=>n%1==0,xf=[1,2,2.5,5],cR=cc(10,-32,0,xf),Xy=cc(10,0,32,xf),hR=Xy.filter(Wy),vo=cR.concat(Xy),Um=`
`,qy="{YYYY}",hy=Um+qy,Yy="{M}/{D}",oc=Um+Yy,df=oc+"/{YY}",$y="{aa}",uR="{h}:{mm}",Ra=uR+$y,uy=Um+Ra,fy=":{ss}",Fe=null;function Zy(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?cc(10,0,3,xf).filter(Wy):cc(10,-3,0,xf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,qy,Fe,Fe,Fe,Fe,Fe,Fe,1],[s*28,"{MMM}",hy,Fe,Fe,Fe,Fe,Fe,1],[s,Yy,hy,Fe,Fe,Fe,Fe,Fe,1],[i,"{h}"+$y,df,Fe,oc,Fe,Fe,Fe,1],[e,Ra,df,Fe,oc,Fe,Fe,Fe,1],[t,fy,df+" "+Ra,Fe,oc+" "+Ra,Fe,uy,Fe,1],[n,fy+".{fff}",df+" "+Ra,Fe,oc+" "+Ra,Fe,uy,Fe,1]];function h(u){return(f,d,g,x,p,m)=>{let _=[],w=p>=o,b=p>=r&&p<o,C=u(g),S=qe(C*n,3),y=pm(C.getFullYear(),w?0:C.getMonth(),b||w?1:C.getDate()),M=qe(y*n,3);if(b||w){let U=b?p/r:0,I=w?p/o:0,D=S==M?S:qe(pm(y.getFullYear()+I,y.getMonth()+U,1)*n,3),z=new Date(On(D/n)),X=z.getFullYear(),N=z.getMonth();for(let V=0;D<=x;V++){let Z=pm(X+I*V,N+U*V,1),W=Z-u(qe(Z*n,3));D=qe((+Z+W)*n,3),D<=x&&_.push(D)}}else{let U=p>=s?s:p,I=Hi(g)-Hi(S),D=M+I+bf(S-M,U);_.push(D);let z=u(D),X=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,N=p/i,V=f.axes[d]._space,Z=m/V;for(;D=qe(D+p,n==1?0:3),!(D>x);)if(N>1){let W=Hi(qe(X+N,6))%24,tt=u(D).getHours()-W;tt>1&&(tt=-1),D-=tt*i,X=(X+N)%24;let st=_[_.length-1];qe((D-st)/p,3)*Z>=.7&&_.push(D)}else _.push(D)}return _}}return[l,c,h]}var[fR,dR,pR]=Zy(1),[mR,gR,_R]=Zy(.001);cc(2,-53,53,[1]);function dy(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function py(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,u,f,d;return i.map(g=>{let x=n(g),p=x.getFullYear(),m=x.getMonth(),_=x.getDate(),w=x.getHours(),b=x.getMinutes(),C=x.getSeconds(),S=p!=l&&a[2]||m!=c&&a[3]||_!=h&&a[4]||w!=u&&a[5]||b!=f&&a[6]||C!=d&&a[7]||a[1];return l=p,c=m,h=_,u=w,f=b,d=C,S(x)})}}function xR(n,t){let e=Nm(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function pm(n,t,e){return new Date(n,t,e)}function my(n,t){return t(n)}var yR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function gy(n,t){return(e,i,s,r)=>r==null?Rm:t(n(i))}function vR(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function bR(n,t){return n.series[t].fill(n,t)}var SR={show:!0,live:!0,isolate:!1,mount:HA,markers:{show:!0,width:2,stroke:vR,fill:bR,dash:"solid"},idx:null,idxs:null,values:[]};function MR(n,t){let e=n.cursor.points,i=ji(),s=e.size(n,t);nn(i,sc,s),nn(i,rc,s);let r=s/-2;nn(i,"marginLeft",r),nn(i,"marginTop",r);let o=e.width(n,t,s);return o&&nn(i,"borderWidth",o),i}function wR(n,t){let e=n.series[t].points;return e._fill||e._stroke}function ER(n,t){let e=n.series[t].points;return e._stroke||e._fill}function TR(n,t){return n.series[t].points.size}var mm=[0,0];function AR(n,t,e){return mm[0]=t,mm[1]=e,mm}function pf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function gm(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var RR={show:!0,x:!0,y:!0,lock:!1,move:AR,points:{one:!1,show:MR,size:TR,width:0,stroke:ER,fill:wR},bind:{mousedown:pf,mouseup:pf,click:pf,dblclick:pf,mousemove:gm,mouseleave:gm,mouseenter:gm},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Jy={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Fm=Pn({},Jy,{filter:Fy}),jy=Pn({},Fm,{size:10}),Ky=Pn({},Jy,{show:!1}),Om='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Qy="bold "+Om,tv=1.5,_y={show:!0,scale:"x",stroke:Am,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Qy,side:2,grid:Fm,ticks:jy,border:Ky,font:Om,lineGap:tv,rotate:0},CR="Value",PR="Time",xy={show:!0,scale:"x",auto:!1,sorted:1,min:Xe,max:-Xe,idxs:[]};function IR(n,t,e,i,s){return t.map(r=>r==null?"":Lm(r))}function LR(n,t,e,i,s,r,o){let a=[],l=Wr.get(s)||0;e=o?e:qe(bf(e,s),l);for(let c=e;c<=i;c=qe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Sm(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?fr:Dy,h=Hi(c(e));s=Pa(l,h),l==10&&(s=vo[_s(s,vo)]);let u=e,f=s*l;l==10&&(f=vo[_s(f,vo)]);do a.push(u),u=u+s,l==10&&!Wr.has(u)&&(u=qe(u,Wr.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=vo[_s(f,vo)]));while(u<=i);return a}function DR(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Sm(n,t,bi(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?Sm(n,t,bi(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var ev=/./,NR=/[12357]/,UR=/[125]/,yy=/1/,Mm=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function FR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?ev:l(7,o)-h>=c?NR:l(5,o)-h>=c?UR:yy;if(u==yy){let f=Bn(l(1,o)-h);if(f<c)return Mm(t.slice().reverse(),a.distr,u,Ki(c/f)).reverse()}return Mm(t,a.distr,u,1)}function OR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Bn(l(1,o)-l(2,o));return c<a?Mm(t.slice().reverse(),3,ev,Ki(a/c)).reverse():t}function BR(n,t,e,i){return i==null?Rm:t==null?"":Lm(t)}var vy={show:!0,scale:"y",stroke:Am,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Qy,side:3,grid:Fm,ticks:jy,border:Ky,font:Om,lineGap:tv,rotate:0};function zR(n,t){let e=3+(n||1)*2;return qe(e*t,3)}function kR(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Bn(o-r),l=n.series[t],c=a/(l.points.space*Ne);return i[1]-i[0]<=c}var by={scale:null,auto:!0,sorted:0,min:Xe,max:-Xe},nv=(n,t,e,i,s)=>s,Sy={show:!0,auto:!0,sorted:0,gaps:nv,alpha:1,facets:[Pn({},by,{scale:"x"}),Pn({},by,{scale:"y"})]},My={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:nv,alpha:1,points:{show:kR,filter:null},values:null,min:Xe,max:-Xe,idxs:[],path:null,clip:null};function HR(n,t,e,i,s){return e/10}var iv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},GR=Pn({},iv,{time:!1,ori:1}),wy={};function sv(n,t){let e=wy[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(wy[n]=e)),e}var Da=1,wm=2;function wo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,x=a.height,p=n.valToPosH,m=n.valToPosV;return h.ori==0?e(s,l,c,h,u,p,m,f,d,g,x,wf,Ua,Tf,ov,lv):e(s,l,c,h,u,m,p,d,f,x,g,Ef,Fa,km,av,cv)}function Bm(n,t){let e=0,i=0,s=Ie(n.bands,Dm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function VR(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function dr(n,t,e,i,s,r){return wo(n,t,(o,a,l,c,h,u,f,d,g,x,p)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),w=c.ori==0?Ua:Fa,b,C;_==1?(b=e,C=i):(b=i,C=e);let S=m(u(a[b],c,x,d)),y=m(f(l[b],h,p,g)),M=m(u(a[C],c,x,d)),U=m(f(r==1?h.max:h.min,h,p,g)),I=new Path2D(s);return w(I,M,U),w(I,S,U),w(I,S,y),I})}function Mf(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Tf:km,l=e;for(let u=0;u<n.length;u++){let f=n[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function WR(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function zm(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[u]),g=f==u?d:r(n[f]),x=u-s;d=o<=0&&x>=0&&x<l?r(n[x]):d;let m=f+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=d&&a.push([d,g])}return a}function Ey(n){return n==0?Uy:n==1?On:t=>yo(t,n)}function rv(n){let t=n==0?wf:Ef,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=xs(c,a/2,l/2),h=xs(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var wf=(n,t,e)=>{n.moveTo(t,e)},Ef=(n,t,e)=>{n.moveTo(e,t)},Ua=(n,t,e)=>{n.lineTo(t,e)},Fa=(n,t,e)=>{n.lineTo(e,t)},Tf=rv(0),km=rv(1),ov=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},av=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},lv=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},cv=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function hv(n){return(t,e,i,s,r)=>wo(t,e,(o,a,l,c,h,u,f,d,g,x,p)=>{let{pxRound:m,points:_}=o,w,b;c.ori==0?(w=wf,b=ov):(w=Ef,b=av);let C=qe(_.width*Ne,3),S=(_.size-_.width)/2*Ne,y=qe(S*2,3),M=new Path2D,U=new Path2D,{left:I,top:D,width:z,height:X}=t.bbox;Tf(U,I-y,D-y,z+y*2,X+y*2);let N=V=>{if(l[V]!=null){let Z=m(u(a[V],c,x,d)),W=m(f(l[V],h,p,g));w(M,Z+S,W),b(M,Z,W,S,0,mf*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:C>0?M:null,fill:M,clip:U,flags:Da|wm}})}function uv(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var XR=uv(Ua),qR=uv(Fa);function fv(n){let t=Ie(n?.alignGaps,0);return(e,i,s,r)=>wo(e,i,(o,a,l,c,h,u,f,d,g,x,p)=>{[s,r]=yf(l,s,r);let m=o.pxRound,_=X=>m(u(X,c,x,d)),w=X=>m(f(X,h,p,g)),b,C;c.ori==0?(b=Ua,C=XR):(b=Fa,C=qR);let S=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Da},M=y.stroke,U=!1;if(r-s>=x*4){let X=dt=>e.posToVal(dt,c.key,!0),N=null,V=null,Z,W,ct,$=_(a[S==1?s:r]),tt=_(a[s]),st=_(a[r]),ft=X(S==1?tt+1:st-1);for(let dt=S==1?s:r;dt>=s&&dt<=r;dt+=S){let et=a[dt],yt=(S==1?et<ft:et>ft)?$:_(et),Rt=l[dt];yt==$?Rt!=null?(W=Rt,N==null?(b(M,yt,w(W)),Z=N=V=W):W<N?N=W:W>V&&(V=W)):Rt===null&&(U=!0):(N!=null&&C(M,$,w(N),w(V),w(Z),w(W)),Rt!=null?(W=Rt,b(M,yt,w(W)),N=V=Z=W):(N=V=null,Rt===null&&(U=!0)),$=yt,ft=X($+S))}N!=null&&N!=V&&ct!=$&&C(M,$,w(N),w(V),w(Z),w(W))}else for(let X=S==1?s:r;X>=s&&X<=r;X+=S){let N=l[X];N===null?U=!0:N!=null&&b(M,_(a[X]),w(N))}let[D,z]=Bm(e,i);if(o.fill!=null||D!=0){let X=y.fill=new Path2D(M),N=o.fillTo(e,i,o.min,o.max,D),V=w(N),Z=_(a[s]),W=_(a[r]);S==-1&&([W,Z]=[Z,W]),b(X,W,V),b(X,Z,V)}if(!o.spanGaps){let X=[];U&&X.push(...zm(a,l,s,r,S,_,t)),y.gaps=X=o.gaps(e,i,s,r,X),y.clip=Mf(X,c.ori,d,g,x,p)}return z!=0&&(y.band=z==2?[dr(e,i,s,r,M,-1),dr(e,i,s,r,M,1)]:dr(e,i,s,r,M,z)),y})}function YR(n){let t=Ie(n.align,1),e=Ie(n.ascDesc,!1),i=Ie(n.alignGaps,0),s=Ie(n.extend,!1);return(r,o,a,l)=>wo(r,o,(c,h,u,f,d,g,x,p,m,_,w)=>{[a,l]=yf(u,a,l);let b=c.pxRound,{left:C,width:S}=r.bbox,y=tt=>b(g(tt,f,_,p)),M=tt=>b(x(tt,d,w,m)),U=f.ori==0?Ua:Fa,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Da},D=I.stroke,z=f.dir*(f.ori==0?1:-1),X=M(u[z==1?a:l]),N=y(h[z==1?a:l]),V=N,Z=N;s&&t==-1&&(Z=C,U(D,Z,X)),U(D,N,X);for(let tt=z==1?a:l;tt>=a&&tt<=l;tt+=z){let st=u[tt];if(st==null)continue;let ft=y(h[tt]),dt=M(st);t==1?U(D,ft,X):U(D,V,dt),U(D,ft,dt),X=dt,V=ft}let W=V;s&&t==1&&(W=C+S,U(D,W,X));let[ct,$]=Bm(r,o);if(c.fill!=null||ct!=0){let tt=I.fill=new Path2D(D),st=c.fillTo(r,o,c.min,c.max,ct),ft=M(st);U(tt,W,ft),U(tt,Z,ft)}if(!c.spanGaps){let tt=[];tt.push(...zm(h,u,a,l,z,y,i));let st=c.width*Ne/2,ft=e||t==1?st:-st,dt=e||t==-1?-st:st;tt.forEach(et=>{et[0]+=ft,et[1]+=dt}),I.gaps=tt=c.gaps(r,o,a,l,tt),I.clip=Mf(tt,f.ori,p,m,_,w)}return $!=0&&(I.band=$==2?[dr(r,o,a,l,D,-1),dr(r,o,a,l,D,1)]:dr(r,o,a,l,D,$)),I})}function Ty(n,t,e,i,s,r,o=Xe){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=Bn(n[l]-n[a]);h<c&&(c=h,o=Bn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function $R(n){n=n||lc;let t=Ie(n.size,[.6,Xe,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ae(s),o=1-t[0],a=Ie(t[1],Xe),l=Ie(t[2],1),c=Ie(n.disp,lc),h=Ie(n.each,d=>{}),{fill:u,stroke:f}=c;return(d,g,x,p)=>wo(d,g,(m,_,w,b,C,S,y,M,U,I,D)=>{let z=m.pxRound,X=e,N=i*Ne,V=a*Ne,Z=l*Ne,W,ct;b.ori==0?[W,ct]=r(d,g):[ct,W]=r(d,g);let $=b.dir*(b.ori==0?1:-1),tt=b.ori==0?Tf:km,st=b.ori==0?h:(It,te,fe,wt,Ve,Xt,jt)=>{h(It,te,fe,Ve,wt,jt,Xt)},ft=Ie(d.bands,Dm).find(It=>It.series[0]==g),dt=ft!=null?ft.dir:0,et=m.fillTo(d,g,m.min,m.max,dt),gt=z(y(et,C,D,U)),yt,Rt,Mt,Zt=I,ue=z(m.width*Ne),Yt=!1,_e=null,pe=null,ce=null,sn=null;u!=null&&(ue==0||f!=null)&&(Yt=!0,_e=u.values(d,g,x,p),pe=new Map,new Set(_e).forEach(It=>{It!=null&&pe.set(It,new Path2D)}),ue>0&&(ce=f.values(d,g,x,p),sn=new Map,new Set(ce).forEach(It=>{It!=null&&sn.set(It,new Path2D)})));let{x0:Ye,size:Mn}=c;if(Ye!=null&&Mn!=null){X=1,_=Ye.values(d,g,x,p),Ye.unit==2&&(_=_.map(fe=>d.posToVal(M+fe*I,b.key,!0)));let It=Mn.values(d,g,x,p);Mn.unit==2?Rt=It[0]*I:Rt=S(It[0],b,I,M)-S(0,b,I,M),Zt=Ty(_,w,S,b,I,M,Zt),Mt=Zt-Rt+N}else Zt=Ty(_,w,S,b,I,M,Zt),Mt=Zt*o+N,Rt=Zt-Mt;Mt<1&&(Mt=0),ue>=Rt/2&&(ue=0),Mt<5&&(z=Uy);let He=Mt>0,kn=Zt-Mt-(He?ue:0);Rt=z(bm(kn,Z,V)),yt=(X==0?Rt/2:X==$?0:Rt)-X*$*((X==0?N/2:0)+(He?ue/2:0));let Re={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},In=Yt?null:new Path2D,pn=null;if(ft!=null)pn=d.data[ft.series[1]];else{let{y0:It,y1:te}=c;It!=null&&te!=null&&(w=te.values(d,g,x,p),pn=It.values(d,g,x,p))}let wn=W*Rt,H=ct*Rt;for(let It=$==1?x:p;It>=x&&It<=p;It+=$){let te=w[It];if(te==null)continue;if(pn!=null){let Y=pn[It]??0;if(te-Y==0)continue;gt=y(Y,C,D,U)}let fe=b.distr!=2||c!=null?_[It]:It,wt=S(fe,b,I,M),Ve=y(Ie(te,et),C,D,U),Xt=z(wt-yt),jt=z(bi(Ve,gt)),P=z(xs(Ve,gt)),E=jt-P;if(te!=null){let Y=te<0?H:wn,ut=te<0?wn:H;Yt?(ue>0&&ce[It]!=null&&tt(sn.get(ce[It]),Xt,P+Hi(ue/2),Rt,bi(0,E-ue),Y,ut),_e[It]!=null&&tt(pe.get(_e[It]),Xt,P+Hi(ue/2),Rt,bi(0,E-ue),Y,ut)):tt(In,Xt,P+Hi(ue/2),Rt,bi(0,E-ue),Y,ut),st(d,g,It,Xt-ue/2,P,Rt+ue,E)}}return ue>0?Re.stroke=Yt?sn:In:Yt||(Re._fill=m.width==0?m._fill:m._stroke??m._fill,Re.width=0),Re.fill=Yt?pe:In,Re})}function ZR(n,t){let e=Ie(t?.alignGaps,0);return(i,s,r,o)=>wo(i,s,(a,l,c,h,u,f,d,g,x,p,m)=>{[r,o]=yf(c,r,o);let _=a.pxRound,w=W=>_(f(W,h,p,g)),b=W=>_(d(W,u,m,x)),C,S,y;h.ori==0?(C=wf,y=Ua,S=lv):(C=Ef,y=Fa,S=cv);let M=h.dir*(h.ori==0?1:-1),U=w(l[M==1?r:o]),I=U,D=[],z=[];for(let W=M==1?r:o;W>=r&&W<=o;W+=M)if(c[W]!=null){let $=l[W],tt=w($);D.push(I=tt),z.push(b(c[W]))}let X={stroke:n(D,z,C,y,S,_),fill:null,clip:null,band:null,gaps:null,flags:Da},N=X.stroke,[V,Z]=Bm(i,s);if(a.fill!=null||V!=0){let W=X.fill=new Path2D(N),ct=a.fillTo(i,s,a.min,a.max,V),$=b(ct);y(W,I,$),y(W,U,$)}if(!a.spanGaps){let W=[];W.push(...zm(l,c,r,o,M,w,e)),X.gaps=W=a.gaps(i,s,r,o,W),X.clip=Mf(W,h.ori,g,x,p,m)}return Z!=0&&(X.band=Z==2?[dr(i,s,r,o,N,-1),dr(i,s,r,o,N,1)]:dr(i,s,r,o,N,Z)),X})}function JR(n){return ZR(jR,n)}function jR(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=n[f+1]-n[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+u[f]/3,t[f]+l[f]*u[f]/3,n[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,n[f+1],t[f+1])}return a}var Em=new Set;function Ay(){for(let n of Em)n.syncRect(!0)}Na&&(So(IA,Ca,Ay),So(LA,Ca,Ay,!0),So(gf,Ca,()=>{Kn.pxRatio=Ne}));var KR=fv(),QR=hv();function Ry(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Tm(r,o,t,e))}function tC(n,t){return n.map((e,i)=>i==0?{}:Pn({},t,e))}function Tm(n,t,e,i){return Pn({},t==0?e:i,n)}function dv(n,t,e){return t==null?Ia:[t,e]}var eC=dv;function nC(n,t,e){return t==null?Ia:_f(t,e,Im,!0)}function pv(n,t,e,i){return t==null?Ia:vf(t,e,n.scales[i].log,!1)}var iC=pv;function mv(n,t,e,i){return t==null?Ia:Pm(t,e,n.scales[i].log,!1)}var sC=mv;function rC(n,t,e,i,s){let r=bi(oy(n),oy(t)),o=t-n,a=_s(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Wr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Cy(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=On((e=+s)*Ne))+"px"),[n,t,e]}function oC(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=qe(t[2]*Ne,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Kn(n,t,e){let i={mode:Ie(n.mode,1)},s=i.mode;function r(v,T,L,F){let q=T.valToPct(v);return F+L*(T.dir==-1?1-q:q)}function o(v,T,L,F){let q=T.valToPct(v);return F+L*(T.dir==-1?q:1-q)}function a(v,T,L,F){return T.ori==0?r(v,T,L,F):o(v,T,L,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ji(dA);if(n.id!=null&&(c.id=n.id),ki(c,n.class),n.title){let v=ji(gA,c);v.textContent=n.title}let h=gs("canvas"),u=i.ctx=h.getContext("2d"),f=ji(_A,c);So("click",f,v=>{v.target===g&&(je!=Do||rn!=No)&&jn.click(i,v)},!0);let d=i.under=ji(xA,f);f.appendChild(h);let g=i.over=ji(yA,f);n=La(n);let x=+Ie(n.pxAlign,1),p=Ey(x);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let m=n.ms||.001,_=i.series=s==1?Ry(n.series||[],xy,My,!1):tC(n.series||[null],Sy),w=i.axes=Ry(n.axes||[],_y,vy,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(v=>{v.fill=Ae(v.fill||null),v.dir=Ie(v.dir,-1)});let S=s==2?_[1].facets[0].scale:_[0].scale,y={axes:qs,series:ve},M=(n.drawOrder||["axes","series"]).map(v=>y[v]);function U(v){let T=v.distr==3?L=>fr(L>0?L:v.clamp(i,L,v.min,v.max,v.key)):v.distr==4?L=>dm(L,v.asinh):v.distr==100?L=>v.fwd(L):L=>L;return L=>{let F=T(L),{_min:q,_max:K}=v,lt=K-q;return(F-q)/lt}}function I(v){let T=b[v];if(T==null){let L=(n.scales||lc)[v]||lc;if(L.from!=null){I(L.from);let F=Pn({},b[L.from],L,{key:v});F.valToPct=U(F),b[v]=F}else{T=b[v]=Pn({},v==S?iv:GR,L),T.key=v;let F=T.time,q=T.range,K=Vr(q);if((v!=S||s==2&&!F)&&(K&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?iy:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?iy:{mode:1,hard:q[1],soft:q[1]}},K=!1),!K&&Sf(q))){let lt=q;q=(pt,bt,Ot)=>bt==null?Ia:_f(bt,Ot,lt)}T.range=Ae(q||(F?eC:v==S?T.distr==3?iC:T.distr==4?sC:dv:T.distr==3?pv:T.distr==4?mv:nC)),T.auto=Ae(K?!1:T.auto),T.clamp=Ae(T.clamp||HR),T._min=T._max=null,T.valToPct=U(T)}}}I("x"),I("y"),s==1&&_.forEach(v=>{I(v.scale)}),w.forEach(v=>{I(v.scale)});for(let v in n.scales)I(v);let D=b[S],z=D.distr,X,N;D.ori==0?(ki(c,pA),X=r,N=o):(ki(c,mA),X=o,N=r);let V={};for(let v in b){let T=b[v];(T.min!=null||T.max!=null)&&(V[v]={min:T.min,max:T.max},T.min=T.max=null)}let Z=n.tzDate||(v=>new Date(On(v/m))),W=n.fmtDate||Nm,ct=m==1?pR(Z):_R(Z),$=py(Z,dy(m==1?dR:gR,W)),tt=gy(Z,my(yR,W)),st=[],ft=i.legend=Pn({},SR,n.legend),dt=i.cursor=Pn({},RR,{drag:{y:s==2}},n.cursor),et=ft.show,gt=dt.show,yt=ft.markers;ft.idxs=st,yt.width=Ae(yt.width),yt.dash=Ae(yt.dash),yt.stroke=Ae(yt.stroke),yt.fill=Ae(yt.fill);let Rt,Mt,Zt,ue=[],Yt=[],_e,pe=!1,ce={};if(ft.live){let v=_[1]?_[1].values:null;pe=v!=null,_e=pe?v(i,1,0):{_:0};for(let T in _e)ce[T]=Rm}if(et)if(Rt=gs("table",EA,c),Zt=gs("tbody",null,Rt),ft.mount(i,Rt),pe){Mt=gs("thead",null,Rt,Zt);let v=gs("tr",null,Mt);gs("th",null,v);for(var sn in _e)gs("th",Wx,v).textContent=sn}else ki(Rt,AA),ft.live&&ki(Rt,TA);let Ye={show:!0},Mn={show:!1};function He(v,T){if(T==0&&(pe||!ft.live||s==2))return Ia;let L=[],F=gs("tr",RA,Zt,Zt.childNodes[T]);ki(F,v.class),v.show||ki(F,bo);let q=gs("th",null,F);if(yt.show){let pt=ji(CA,q);if(T>0){let bt=yt.width(i,T);bt&&(pt.style.border=bt+"px "+yt.dash(i,T)+" "+yt.stroke(i,T)),pt.style.background=yt.fill(i,T)}}let K=ji(Wx,q);v.label instanceof HTMLElement?K.appendChild(v.label):K.textContent=v.label,T>0&&(yt.show||(K.style.color=v.width>0?yt.stroke(i,T):yt.fill(i,T)),Re("click",q,pt=>{if(dt._lock)return;se(pt);let bt=_.indexOf(v);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Ot=_.some((Bt,Ht)=>Ht>0&&Ht!=bt&&Bt.show);_.forEach((Bt,Ht)=>{Ht>0&&Ms(Ht,Ot?Ht==bt?Ye:Mn:Ye,!0,Rn.setSeries)})}else Ms(bt,{show:!v.show},!0,Rn.setSeries)},!1),re&&Re($x,q,pt=>{dt._lock||(se(pt),Ms(_.indexOf(v),Fo,!0,Rn.setSeries))},!1));for(var lt in _e){let pt=gs("td",PA,F);pt.textContent="--",L.push(pt)}return[F,L]}let kn=new Map;function Re(v,T,L,F=!0){let q=kn.get(T)||{},K=dt.bind[v](i,T,L,F);K&&(So(v,T,q[v]=K),kn.set(T,q))}function In(v,T,L){let F=kn.get(T)||{};for(let q in F)(v==null||q==v)&&(vm(q,T,F[q]),delete F[q]);v==null&&kn.delete(T)}let pn=0,wn=0,H=0,It=0,te=0,fe=0,wt=te,Ve=fe,Xt=H,jt=It,P=0,E=0,Y=0,ut=0;i.bbox={};let at=!1,xt=!1,vt=!1,nt=!1,rt=!1,mt=!1;function k(v,T,L){(L||v!=i.width||T!=i.height)&&ot(v,T),me(!1),vt=!0,xt=!0,Qn()}function ot(v,T){i.width=pn=H=v,i.height=wn=It=T,te=fe=0,St(),$t();let L=i.bbox;P=L.left=yo(te*Ne,.5),E=L.top=yo(fe*Ne,.5),Y=L.width=yo(H*Ne,.5),ut=L.height=yo(It*Ne,.5)}let it=3;function Et(){let v=!1,T=0;for(;!v;){T++;let L=Po(T),F=Ss(T);v=T==it||L&&F,v||(ot(i.width,i.height),xt=!0)}}function _t({width:v,height:T}){k(v,T)}i.setSize=_t;function St(){let v=!1,T=!1,L=!1,F=!1;w.forEach((q,K)=>{if(q.show&&q._show){let{side:lt,_size:pt}=q,bt=lt%2,Ot=q.label!=null?q.labelSize:0,Bt=pt+Ot;Bt>0&&(bt?(H-=Bt,lt==3?(te+=Bt,F=!0):L=!0):(It-=Bt,lt==0?(fe+=Bt,v=!0):T=!0))}}),vs[0]=v,vs[1]=L,vs[2]=T,vs[3]=F,H-=ts[1]+ts[3],te+=ts[3],It-=ts[2]+ts[0],fe+=ts[0]}function $t(){let v=te+H,T=fe+It,L=te,F=fe;function q(K,lt){switch(K){case 1:return v+=lt,v-lt;case 2:return T+=lt,T-lt;case 3:return L-=lt,L+lt;case 0:return F-=lt,F+lt}}w.forEach((K,lt)=>{if(K.show&&K._show){let pt=K.side;K._pos=q(pt,K._size),K.label!=null&&(K._lpos=q(pt,K.labelSize))}})}if(dt.dataIdx==null){let v=dt.hover,T=v.skip=new Set(v.skip??[]);T.add(void 0);let L=v.prox=Ae(v.prox),F=v.bias??=0;dt.dataIdx=(q,K,lt,pt)=>{if(K==0)return lt;let bt=lt,Ot=L(q,K,lt,pt)??Xe,Bt=Ot>=0&&Ot<Xe,Ht=D.ori==0?H:It,he=dt.left,Le=t[0],Pe=t[K];if(T.has(Pe[lt])){bt=null;let Se=null,ee=null,Jt;if(F==0||F==-1)for(Jt=lt;Se==null&&Jt-- >0;)T.has(Pe[Jt])||(Se=Jt);if(F==0||F==1)for(Jt=lt;ee==null&&Jt++<Pe.length;)T.has(Pe[Jt])||(ee=Jt);if(Se!=null||ee!=null)if(Bt){let Qe=Se==null?-1/0:X(Le[Se],D,Ht,0),_n=ee==null?1/0:X(Le[ee],D,Ht,0),Wn=he-Qe,Ge=_n-he;Wn<=Ge?Wn<=Ot&&(bt=Se):Ge<=Ot&&(bt=ee)}else bt=ee==null?Se:Se==null?ee:lt-Se<=ee-lt?Se:ee}else Bt&&Bn(he-X(Le[lt],D,Ht,0))>Ot&&(bt=null);return bt}}let se=v=>{dt.event=v};dt.idxs=st,dt._lock=!1;let ht=dt.points;ht.show=Ae(ht.show),ht.size=Ae(ht.size),ht.stroke=Ae(ht.stroke),ht.width=Ae(ht.width),ht.fill=Ae(ht.fill);let Gt=i.focus=Pn({},n.focus||{alpha:.3},dt.focus),re=Gt.prox>=0,Ct=re&&ht.one,de=[],Je=[],ai=[];function ka(v,T){let L=ht.show(i,T);if(L instanceof HTMLElement)return ki(L,wA),ki(L,v.class),Gs(L,-10,-10,H,It),g.insertBefore(L,de[T]),L}function Ao(v,T){if(s==1||T>0){let L=s==1&&b[v.scale].time,F=v.value;v.value=L?cy(F)?gy(Z,my(F,W)):F||tt:F||BR,v.label=v.label||(L?PR:CR)}if(Ct||T>0){v.width=v.width==null?1:v.width,v.paths=v.paths||KR||GA,v.fillTo=Ae(v.fillTo||VR),v.pxAlign=+Ie(v.pxAlign,x),v.pxRound=Ey(v.pxAlign),v.stroke=Ae(v.stroke||null),v.fill=Ae(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let L=zR(bi(1,v.width),1),F=v.points=Pn({},{size:L,width:bi(1,L*.2),stroke:v.stroke,space:L*2,paths:QR,_stroke:null,_fill:null},v.points);F.show=Ae(F.show),F.filter=Ae(F.filter),F.fill=Ae(F.fill),F.stroke=Ae(F.stroke),F.paths=Ae(F.paths),F.pxAlign=v.pxAlign}if(et){let L=He(v,T);ue.splice(T,0,L[0]),Yt.splice(T,0,L[1]),ft.values.push(null)}if(gt){st.splice(T,0,null);let L=null;Ct?T==0&&(L=ka(v,T)):T>0&&(L=ka(v,T)),de.splice(T,0,L),Je.splice(T,0,0),ai.splice(T,0,0)}Vn("addSeries",T)}function Gf(v,T){T=T??_.length,v=s==1?Tm(v,T,xy,My):Tm(v,T,{},Sy),_.splice(T,0,v),Ao(_[T],T)}i.addSeries=Gf;function pc(v){if(_.splice(v,1),et){ft.values.splice(v,1),Yt.splice(v,1);let T=ue.splice(v,1)[0];In(null,T.firstChild),T.remove()}gt&&(st.splice(v,1),de.splice(v,1)[0].remove(),Je.splice(v,1),ai.splice(v,1)),Vn("delSeries",v)}i.delSeries=pc;let vs=[!1,!1,!1,!1];function Vs(v,T){if(v._show=v.show,v.show){let L=v.side%2,F=b[v.scale];F==null&&(v.scale=L?_[1].scale:S,F=b[v.scale]);let q=F.time;v.size=Ae(v.size),v.space=Ae(v.space),v.rotate=Ae(v.rotate),Vr(v.incrs)&&v.incrs.forEach(lt=>{!Wr.has(lt)&&Wr.set(lt,By(lt))}),v.incrs=Ae(v.incrs||(F.distr==2?hR:q?m==1?fR:mR:vo)),v.splits=Ae(v.splits||(q&&F.distr==1?ct:F.distr==3?Sm:F.distr==4?DR:LR)),v.stroke=Ae(v.stroke),v.grid.stroke=Ae(v.grid.stroke),v.ticks.stroke=Ae(v.ticks.stroke),v.border.stroke=Ae(v.border.stroke);let K=v.values;v.values=Vr(K)&&!Vr(K[0])?Ae(K):q?Vr(K)?py(Z,dy(K,W)):cy(K)?xR(Z,K):K||$:K||IR,v.filter=Ae(v.filter||(F.distr>=3&&F.log==10?FR:F.distr==3&&F.log==2?OR:Fy)),v.font=Cy(v.font),v.labelFont=Cy(v.labelFont),v._size=v.size(i,null,T,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(vs[T]=!0,v._el=ji(vA,f))}}function Ws(v,T,L,F){let[q,K,lt,pt]=L,bt=T%2,Ot=0;return bt==0&&(pt||K)&&(Ot=T==0&&!q||T==2&&!lt?On(_y.size/3):0),bt==1&&(q||lt)&&(Ot=T==1&&!K||T==3&&!pt?On(vy.size/2):0),Ot}let Ha=i.padding=(n.padding||[Ws,Ws,Ws,Ws]).map(v=>Ae(Ie(v,Ws))),ts=i._padding=Ha.map((v,T)=>v(i,T,vs,0)),mn,vn=null,bn=null,bs=s==1?_[0].idxs:null,Pi=null,pr=!1;function Ga(v,T){if(t=v??[],i.data=i._data=t,s==2){mn=0;for(let L=1;L<_.length;L++)mn+=t[L][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Pi=t[0],mn=Pi.length;let L=t;if(z==2){L=t.slice();let F=L[0]=Array(mn);for(let q=0;q<mn;q++)F[q]=q}i._data=t=L}if(me(!0),Vn("setData"),z==2&&(vt=!0),T!==!1){let L=D;L.auto(i,pr)?Va():_r(S,L.min,L.max),nt=nt||dt.left>=0,mt=!0,Qn()}}i.setData=Ga;function Va(){pr=!0;let v,T;s==1&&(mn>0?(vn=bs[0]=0,bn=bs[1]=mn-1,v=t[0][vn],T=t[0][bn],z==2?(v=vn,T=bn):v==T&&(z==3?[v,T]=vf(v,v,D.log,!1):z==4?[v,T]=Pm(v,v,D.log,!1):D.time?T=v+On(86400/m):[v,T]=_f(v,T,Im,!0))):(vn=bs[0]=v=null,bn=bs[1]=T=null)),_r(S,v,T)}let Ro,mr,Co,R,G,Q,J,j,Tt,Lt;function At(v,T,L,F,q,K){v??=qx,L??=Dm,F??="butt",q??=qx,K??="round",v!=Ro&&(u.strokeStyle=Ro=v),q!=mr&&(u.fillStyle=mr=q),T!=Co&&(u.lineWidth=Co=T),K!=G&&(u.lineJoin=G=K),F!=Q&&(u.lineCap=Q=F),L!=R&&u.setLineDash(R=L)}function Dt(v,T,L,F){T!=mr&&(u.fillStyle=mr=T),v!=J&&(u.font=J=v),L!=j&&(u.textAlign=j=L),F!=Tt&&(u.textBaseline=Tt=F)}function Wt(v,T,L,F,q=0){if(F.length>0&&v.auto(i,pr)&&(T==null||T.min==null)){let K=Ie(vn,0),lt=Ie(bn,F.length-1),pt=L.min==null?FA(F,K,lt,q,v.distr==3):[L.min,L.max];v.min=xs(v.min,L.min=pt[0]),v.max=bi(v.max,L.max=pt[1])}}let ae={min:null,max:null};function ye(){for(let F in b){let q=b[F];V[F]==null&&(q.min==null||V[S]!=null&&q.auto(i,pr))&&(V[F]=ae)}for(let F in b){let q=b[F];V[F]==null&&q.from!=null&&V[q.from]!=null&&(V[F]=ae)}V[S]!=null&&me(!0);let v={};for(let F in V){let q=V[F];if(q!=null){let K=v[F]=La(b[F],XA);if(q.min!=null)Pn(K,q);else if(F!=S||s==2)if(mn==0&&K.from==null){let lt=K.range(i,null,null,F);K.min=lt[0],K.max=lt[1]}else K.min=Xe,K.max=-Xe}}if(mn>0){_.forEach((F,q)=>{if(s==1){let K=F.scale,lt=V[K];if(lt==null)return;let pt=v[K];if(q==0){let bt=pt.range(i,pt.min,pt.max,K);pt.min=bt[0],pt.max=bt[1],vn=_s(pt.min,t[0]),bn=_s(pt.max,t[0]),bn-vn>1&&(t[0][vn]<pt.min&&vn++,t[0][bn]>pt.max&&bn--),F.min=Pi[vn],F.max=Pi[bn]}else F.show&&F.auto&&Wt(pt,lt,F,t[q],F.sorted);F.idxs[0]=vn,F.idxs[1]=bn}else if(q>0&&F.show&&F.auto){let[K,lt]=F.facets,pt=K.scale,bt=lt.scale,[Ot,Bt]=t[q],Ht=v[pt],he=v[bt];Ht!=null&&Wt(Ht,V[pt],K,Ot,K.sorted),he!=null&&Wt(he,V[bt],lt,Bt,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in v){let q=v[F],K=V[F];if(q.from==null&&(K==null||K.min==null)){let lt=q.range(i,q.min==Xe?null:q.min,q.max==-Xe?null:q.max,F);q.min=lt[0],q.max=lt[1]}}}for(let F in v){let q=v[F];if(q.from!=null){let K=v[q.from];if(K.min==null)q.min=q.max=null;else{let lt=q.range(i,K.min,K.max,F);q.min=lt[0],q.max=lt[1]}}}let T={},L=!1;for(let F in v){let q=v[F],K=b[F];if(K.min!=q.min||K.max!=q.max){K.min=q.min,K.max=q.max;let lt=K.distr;K._min=lt==3?fr(K.min):lt==4?dm(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?fr(K.max):lt==4?dm(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,T[F]=L=!0}}if(L){_.forEach((F,q)=>{s==2?q>0&&T.y&&(F._paths=null):T[F.scale]&&(F._paths=null)});for(let F in T)vt=!0,Vn("setScale",F);gt&&dt.left>=0&&(nt=mt=!0)}for(let F in V)V[F]=null}function Vt(v){let T=bm(vn-1,0,mn-1),L=bm(bn+1,0,mn-1);for(;v[T]==null&&T>0;)T--;for(;v[L]==null&&L<mn-1;)L++;return[T,L]}function ve(){if(mn>0){let v=_.some(T=>T._focus)&&Lt!=Gt.alpha;v&&(u.globalAlpha=Lt=Gt.alpha),_.forEach((T,L)=>{if(L>0&&T.show&&(un(L,!1),un(L,!0),T._paths==null)){let F=Lt;Lt!=T.alpha&&(u.globalAlpha=Lt=T.alpha);let q=s==2?[0,t[L][0].length-1]:Vt(t[L]);T._paths=T.paths(i,L,q[0],q[1]),Lt!=F&&(u.globalAlpha=Lt=F)}}),_.forEach((T,L)=>{if(L>0&&T.show){let F=Lt;Lt!=T.alpha&&(u.globalAlpha=Lt=T.alpha),T._paths!=null&&Oe(L,!1);{let q=T._paths!=null?T._paths.gaps:null,K=T.points.show(i,L,vn,bn,q),lt=T.points.filter(i,L,K,q);(K||lt)&&(T.points._paths=T.points.paths(i,L,vn,bn,lt),Oe(L,!0))}Lt!=F&&(u.globalAlpha=Lt=F),Vn("drawSeries",L)}}),v&&(u.globalAlpha=Lt=1)}}function un(v,T){let L=T?_[v].points:_[v];L._stroke=L.stroke(i,v),L._fill=L.fill(i,v)}function Oe(v,T){let L=T?_[v].points:_[v],{stroke:F,fill:q,clip:K,flags:lt,_stroke:pt=L._stroke,_fill:bt=L._fill,_width:Ot=L.width}=L._paths;Ot=qe(Ot*Ne,3);let Bt=null,Ht=Ot%2/2;T&&bt==null&&(bt=Ot>0?"#fff":pt);let he=L.pxAlign==1&&Ht>0;if(he&&u.translate(Ht,Ht),!T){let Le=P-Ot/2,Pe=E-Ot/2,Se=Y+Ot,ee=ut+Ot;Bt=new Path2D,Bt.rect(Le,Pe,Se,ee)}T?kt(pt,Ot,L.dash,L.cap,bt,F,q,lt,K):Be(v,pt,Ot,L.dash,L.cap,bt,F,q,lt,Bt,K),he&&u.translate(-Ht,-Ht)}function Be(v,T,L,F,q,K,lt,pt,bt,Ot,Bt){let Ht=!1;bt!=0&&C.forEach((he,Le)=>{if(he.series[0]==v){let Pe=_[he.series[1]],Se=t[he.series[1]],ee=(Pe._paths||lc).band;Vr(ee)&&(ee=he.dir==1?ee[0]:ee[1]);let Jt,Qe=null;Pe.show&&ee&&BA(Se,vn,bn)?(Qe=he.fill(i,Le)||K,Jt=Pe._paths.clip):ee=null,kt(T,L,F,q,Qe,lt,pt,bt,Ot,Bt,Jt,ee),Ht=!0}}),Ht||kt(T,L,F,q,K,lt,pt,bt,Ot,Bt)}let Ln=Da|wm;function kt(v,T,L,F,q,K,lt,pt,bt,Ot,Bt,Ht){At(v,T,L,F,q),(bt||Ot||Ht)&&(u.save(),bt&&u.clip(bt),Ot&&u.clip(Ot)),Ht?(pt&Ln)==Ln?(u.clip(Ht),Bt&&u.clip(Bt),we(q,lt),En(v,K,T)):pt&wm?(we(q,lt),u.clip(Ht),En(v,K,T)):pt&Da&&(u.save(),u.clip(Ht),Bt&&u.clip(Bt),we(q,lt),u.restore(),En(v,K,T)):(we(q,lt),En(v,K,T)),(bt||Ot||Ht)&&u.restore()}function En(v,T,L){L>0&&(T instanceof Map?T.forEach((F,q)=>{u.strokeStyle=Ro=q,u.stroke(F)}):T!=null&&v&&u.stroke(T))}function we(v,T){T instanceof Map?T.forEach((L,F)=>{u.fillStyle=mr=F,u.fill(L)}):T!=null&&v&&u.fill(T)}function Xs(v,T,L,F){let q=w[v],K;if(F<=0)K=[0,0];else{let lt=q._space=q.space(i,v,T,L,F),pt=q._incrs=q.incrs(i,v,T,L,F,lt);K=rC(T,L,pt,F,lt)}return q._found=K}function Tn(v,T,L,F,q,K,lt,pt,bt,Ot){let Bt=lt%2/2;x==1&&u.translate(Bt,Bt),At(pt,lt,bt,Ot,pt),u.beginPath();let Ht,he,Le,Pe,Se=q+(F==0||F==3?-K:K);L==0?(he=q,Pe=Se):(Ht=q,Le=Se);for(let ee=0;ee<v.length;ee++)T[ee]!=null&&(L==0?Ht=Le=v[ee]:he=Pe=v[ee],u.moveTo(Ht,he),u.lineTo(Le,Pe));u.stroke(),x==1&&u.translate(-Bt,-Bt)}function Po(v){let T=!0;return w.forEach((L,F)=>{if(!L.show)return;let q=b[L.scale];if(q.min==null){L._show&&(T=!1,L._show=!1,me(!1));return}else L._show||(T=!1,L._show=!0,me(!1));let K=L.side,lt=K%2,{min:pt,max:bt}=q,[Ot,Bt]=Xs(F,pt,bt,lt==0?H:It);if(Bt==0)return;let Ht=q.distr==2,he=L._splits=L.splits(i,F,pt,bt,Ot,Bt,Ht),Le=q.distr==2?he.map(Jt=>Pi[Jt]):he,Pe=q.distr==2?Pi[he[1]]-Pi[he[0]]:Ot,Se=L._values=L.values(i,L.filter(i,Le,F,Bt,Pe),F,Bt,Pe);L._rotate=K==2?L.rotate(i,Se,F,Bt):0;let ee=L._size;L._size=Ki(L.size(i,Se,F,v)),ee!=null&&L._size!=ee&&(T=!1)}),T}function Ss(v){let T=!0;return Ha.forEach((L,F)=>{let q=L(i,F,vs,v);q!=ts[F]&&(T=!1),ts[F]=q}),T}function qs(){for(let v=0;v<w.length;v++){let T=w[v];if(!T.show||!T._show)continue;let L=T.side,F=L%2,q,K,lt=T.stroke(i,v),pt=L==0||L==3?-1:1,[bt,Ot]=T._found;if(T.label!=null){let hi=T.labelGap*pt,Di=On((T._lpos+hi)*Ne);Dt(T.labelFont[0],lt,"center",L==2?"top":Xx),u.save(),F==1?(q=K=0,u.translate(Di,On(E+ut/2)),u.rotate((L==3?-mf:mf)/2)):(q=On(P+Y/2),K=Di);let $r=Ny(T.label)?T.label(i,v,bt,Ot):T.label;u.fillText($r,q,K),u.restore()}if(Ot==0)continue;let Bt=b[T.scale],Ht=F==0?Y:ut,he=F==0?P:E,Le=T._splits,Pe=Bt.distr==2?Le.map(hi=>Pi[hi]):Le,Se=Bt.distr==2?Pi[Le[1]]-Pi[Le[0]]:bt,ee=T.ticks,Jt=T.border,Qe=ee.show?ee.size:0,_n=On(Qe*Ne),Wn=On((T.alignTo==2?T._size-Qe-T.gap:T.gap)*Ne),Ge=T._rotate*-mf/180,xn=p(T._pos*Ne),Ii=(_n+Wn)*pt,ci=xn+Ii;K=F==0?ci:0,q=F==1?ci:0;let Wi=T.font[0],es=T.align==1?Aa:T.align==2?hm:Ge>0?Aa:Ge<0?hm:F==0?"center":L==3?hm:Aa,Es=Ge||F==1?"middle":L==2?"top":Xx;Dt(Wi,lt,es,Es);let Li=T.font[1]*T.lineGap,Xi=Le.map(hi=>p(a(hi,Bt,Ht,he))),ns=T._values;for(let hi=0;hi<ns.length;hi++){let Di=ns[hi];if(Di!=null){F==0?q=Xi[hi]:K=Xi[hi],Di=""+Di;let $r=Di.indexOf(`
`)==-1?[Di]:Di.split(/\n/gm);for(let ui=0;ui<$r.length;ui++){let _g=$r[ui];Ge?(u.save(),u.translate(q,K+ui*Li),u.rotate(Ge),u.fillText(_g,0,0),u.restore()):u.fillText(_g,q,K+ui*Li)}}}ee.show&&Tn(Xi,ee.filter(i,Pe,v,Ot,Se),F,L,xn,_n,qe(ee.width*Ne,3),ee.stroke(i,v),ee.dash,ee.cap);let Ts=T.grid;Ts.show&&Tn(Xi,Ts.filter(i,Pe,v,Ot,Se),F,F==0?2:1,F==0?E:P,F==0?ut:Y,qe(Ts.width*Ne,3),Ts.stroke(i,v),Ts.dash,Ts.cap),Jt.show&&Tn([xn],[1],F==0?1:0,F==0?1:2,F==1?E:P,F==1?ut:Y,qe(Jt.width*Ne,3),Jt.stroke(i,v),Jt.dash,Jt.cap)}Vn("drawAxes")}function me(v){_.forEach((T,L)=>{L>0&&(T._paths=null,v&&(s==1?(T.min=null,T.max=null):T.facets.forEach(F=>{F.min=null,F.max=null})))})}let gn=!1,li=!1,ze=[];function An(){li=!1;for(let v=0;v<ze.length;v++)Vn(...ze[v]);ze.length=0}function Qn(){gn||(KA(Qm),gn=!0)}function mc(v,T=!1){gn=!0,li=T,v(i),Qm(),T&&ze.length>0&&queueMicrotask(An)}i.batch=mc;function Qm(){if(at&&(ye(),at=!1),vt&&(Et(),vt=!1),xt){if(nn(d,Aa,te),nn(d,"top",fe),nn(d,sc,H),nn(d,rc,It),nn(g,Aa,te),nn(g,"top",fe),nn(g,sc,H),nn(g,rc,It),nn(f,sc,pn),nn(f,rc,wn),h.width=On(pn*Ne),h.height=On(wn*Ne),w.forEach(({_el:v,_show:T,_size:L,_pos:F,side:q})=>{if(v!=null)if(T){let K=q===3||q===0?L:0,lt=q%2==1;nn(v,lt?"left":"top",F-K),nn(v,lt?"width":"height",L),nn(v,lt?"top":"left",lt?fe:te),nn(v,lt?"height":"width",lt?It:H),ym(v,bo)}else ki(v,bo)}),Ro=mr=Co=G=Q=J=j=Tt=R=null,Lt=1,qa(!0),te!=wt||fe!=Ve||H!=Xt||It!=jt){me(!1);let v=H/Xt,T=It/jt;if(gt&&!nt&&dt.left>=0){dt.left*=v,dt.top*=T,Io&&Gs(Io,On(dt.left),0,H,It),Lo&&Gs(Lo,0,On(dt.top),H,It);for(let L=0;L<de.length;L++){let F=de[L];F!=null&&(Je[L]*=v,ai[L]*=T,Gs(F,Ki(Je[L]),Ki(ai[L]),H,It))}}if(Ke.show&&!rt&&Ke.left>=0&&Ke.width>0){Ke.left*=v,Ke.width*=v,Ke.top*=T,Ke.height*=T;for(let L in $f)nn(Uo,L,Ke[L])}wt=te,Ve=fe,Xt=H,jt=It}Vn("setSize"),xt=!1}pn>0&&wn>0&&(u.clearRect(0,0,h.width,h.height),Vn("drawClear"),M.forEach(v=>v()),Vn("draw")),Ke.show&&rt&&(gc(Ke),rt=!1),gt&&nt&&(Yr(null,!0,!1),nt=!1),ft.show&&ft.live&&mt&&(qf(),mt=!1),l||(l=!0,i.status=1,Vn("ready")),pr=!1,gn=!1}i.redraw=(v,T)=>{vt=T||!1,v!==!1?_r(S,D.min,D.max):Qn()};function Vf(v,T){let L=b[v];if(L.from==null){if(mn==0){let F=L.range(i,T.min,T.max,v);T.min=F[0],T.max=F[1]}if(T.min>T.max){let F=T.min;T.min=T.max,T.max=F}if(mn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;v==S&&L.distr==2&&mn>0&&(T.min=_s(T.min,t[0]),T.max=_s(T.max,t[0]),T.min==T.max&&T.max++),V[v]=T,at=!0,Qn()}}i.setScale=Vf;let Wf,Xf,Io,Lo,tg,eg,Do,No,ng,ig,je,rn,gr=!1,jn=dt.drag,Hn=jn.x,Gn=jn.y;gt&&(dt.x&&(Wf=ji(SA,g)),dt.y&&(Xf=ji(MA,g)),D.ori==0?(Io=Wf,Lo=Xf):(Io=Xf,Lo=Wf),je=dt.left,rn=dt.top);let Ke=i.select=Pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Uo=Ke.show?ji(bA,Ke.over?g:d):null;function gc(v,T){if(Ke.show){for(let L in v)Ke[L]=v[L],L in $f&&nn(Uo,L,v[L]);T!==!1&&Vn("setSelect")}}i.setSelect=gc;function sb(v){if(_[v].show)et&&ym(ue[v],bo);else if(et&&ki(ue[v],bo),gt){let L=Ct?de[0]:de[v];L!=null&&Gs(L,-10,-10,H,It)}}function _r(v,T,L){Vf(v,{min:T,max:L})}function Ms(v,T,L,F){T.focus!=null&&cb(v),T.show!=null&&_.forEach((q,K)=>{K>0&&(v==K||v==null)&&(q.show=T.show,sb(K),s==2?(_r(q.facets[0].scale,null,null),_r(q.facets[1].scale,null,null)):_r(q.scale,null,null),Qn())}),L!==!1&&Vn("setSeries",v,T),F&&Ya("setSeries",i,v,T)}i.setSeries=Ms;function rb(v,T){Pn(C[v],T)}function ob(v,T){v.fill=Ae(v.fill||null),v.dir=Ie(v.dir,-1),T=T??C.length,C.splice(T,0,v)}function ab(v){v==null?C.length=0:C.splice(v,1)}i.addBand=ob,i.setBand=rb,i.delBand=ab;function lb(v,T){_[v].alpha=T,gt&&de[v]!=null&&(de[v].style.opacity=T),et&&ue[v]&&(ue[v].style.opacity=T)}let Ys,xr,qr,Fo={focus:!0};function cb(v){if(v!=qr){let T=v==null,L=Gt.alpha!=1;_.forEach((F,q)=>{if(s==1||q>0){let K=T||q==0||q==v;F._focus=T?null:K,L&&lb(q,K?1:Gt.alpha)}}),qr=v,L&&Qn()}}et&&re&&Re(Zx,Rt,v=>{dt._lock||(se(v),qr!=null&&Ms(null,Fo,!0,Rn.setSeries))});function ws(v,T,L){let F=b[T];L&&(v=v/Ne-(F.ori==1?fe:te));let q=H;F.ori==1&&(q=It,v=q-v),F.dir==-1&&(v=q-v);let K=F._min,lt=F._max,pt=v/q,bt=K+(lt-K)*pt,Ot=F.distr;return Ot==3?Pa(10,bt):Ot==4?kA(bt,F.asinh):Ot==100?F.bwd(bt):bt}function hb(v,T){let L=ws(v,S,T);return _s(L,t[0],vn,bn)}i.valToIdx=v=>_s(v,t[0]),i.posToIdx=hb,i.posToVal=ws,i.valToPos=(v,T,L)=>b[T].ori==0?r(v,b[T],L?Y:H,L?P:0):o(v,b[T],L?ut:It,L?E:0),i.setCursor=(v,T,L)=>{je=v.left,rn=v.top,Yr(null,T,L)};function sg(v,T){nn(Uo,Aa,Ke.left=v),nn(Uo,sc,Ke.width=T)}function rg(v,T){nn(Uo,"top",Ke.top=v),nn(Uo,rc,Ke.height=T)}let Wa=D.ori==0?sg:rg,Xa=D.ori==1?sg:rg;function ub(){if(et&&ft.live)for(let v=s==2?1:0;v<_.length;v++){if(v==0&&pe)continue;let T=ft.values[v],L=0;for(let F in T)Yt[v][L++].firstChild.nodeValue=T[F]}}function qf(v,T){if(v!=null&&(v.idxs?v.idxs.forEach((L,F)=>{st[F]=L}):WA(v.idx)||st.fill(v.idx),ft.idx=st[0]),et&&ft.live){for(let L=0;L<_.length;L++)(L>0||s==1&&!pe)&&fb(L,st[L]);ub()}mt=!1,T!==!1&&Vn("setLegend")}i.setLegend=qf;function fb(v,T){let L=_[v],F=v==0&&z==2?Pi:t[v],q;pe?q=L.values(i,v,T)??ce:(q=L.value(i,T==null?null:F[T],v,T),q=q==null?ce:{_:q}),ft.values[v]=q}function Yr(v,T,L){ng=je,ig=rn,[je,rn]=dt.move(i,je,rn),dt.left=je,dt.top=rn,gt&&(Io&&Gs(Io,On(je),0,H,It),Lo&&Gs(Lo,0,On(rn),H,It));let F,q=vn>bn;Ys=Xe,xr=null;let K=D.ori==0?H:It,lt=D.ori==1?H:It;if(je<0||mn==0||q){F=dt.idx=null;for(let pt=0;pt<_.length;pt++){let bt=de[pt];bt!=null&&Gs(bt,-10,-10,H,It)}re&&Ms(null,Fo,!0,v==null&&Rn.setSeries),ft.live&&(st.fill(F),mt=!0)}else{let pt,bt,Ot;s==1&&(pt=D.ori==0?je:rn,bt=ws(pt,S),F=dt.idx=_s(bt,t[0],vn,bn),Ot=X(t[0][F],D,K,0));let Bt=-10,Ht=-10,he=0,Le=0,Pe=!0,Se="",ee="";for(let Jt=s==2?1:0;Jt<_.length;Jt++){let Qe=_[Jt],_n=st[Jt],Wn=_n==null?null:s==1?t[Jt][_n]:t[Jt][1][_n],Ge=dt.dataIdx(i,Jt,F,bt),xn=Ge==null?null:s==1?t[Jt][Ge]:t[Jt][1][Ge];if(mt=mt||xn!=Wn||Ge!=_n,st[Jt]=Ge,Jt>0&&Qe.show){let Ii=Ge==null?-10:Ge==F?Ot:X(s==1?t[0][Ge]:t[Jt][0][Ge],D,K,0),ci=xn==null?-10:N(xn,s==1?b[Qe.scale]:b[Qe.facets[1].scale],lt,0);if(re&&xn!=null){let Wi=D.ori==1?je:rn,es=Bn(Gt.dist(i,Jt,Ge,ci,Wi));if(es<Ys){let Es=Gt.bias;if(Es!=0){let Li=ws(Wi,Qe.scale),Xi=xn>=0?1:-1,ns=Li>=0?1:-1;ns==Xi&&(ns==1?Es==1?xn>=Li:xn<=Li:Es==1?xn<=Li:xn>=Li)&&(Ys=es,xr=Jt)}else Ys=es,xr=Jt}}if(mt||Ct){let Wi,es;D.ori==0?(Wi=Ii,es=ci):(Wi=ci,es=Ii);let Es,Li,Xi,ns,Ts,hi,Di=!0,$r=ht.bbox;if($r!=null){Di=!1;let ui=$r(i,Jt);Xi=ui.left,ns=ui.top,Es=ui.width,Li=ui.height}else Xi=Wi,ns=es,Es=Li=ht.size(i,Jt);if(hi=ht.fill(i,Jt),Ts=ht.stroke(i,Jt),Ct)Jt==xr&&Ys<=Gt.prox&&(Bt=Xi,Ht=ns,he=Es,Le=Li,Pe=Di,Se=hi,ee=Ts);else{let ui=de[Jt];ui!=null&&(Je[Jt]=Xi,ai[Jt]=ns,ny(ui,Es,Li,Di),ty(ui,hi,Ts),Gs(ui,Ki(Xi),Ki(ns),H,It))}}}}if(Ct){let Jt=Gt.prox,Qe=qr==null?Ys<=Jt:Ys>Jt||xr!=qr;if(mt||Qe){let _n=de[0];_n!=null&&(Je[0]=Bt,ai[0]=Ht,ny(_n,he,Le,Pe),ty(_n,Se,ee),Gs(_n,Ki(Bt),Ki(Ht),H,It))}}}if(Ke.show&&gr)if(v!=null){let[pt,bt]=Rn.scales,[Ot,Bt]=Rn.match,[Ht,he]=v.cursor.sync.scales,Le=v.cursor.drag;if(Hn=Le._x,Gn=Le._y,Hn||Gn){let{left:Pe,top:Se,width:ee,height:Jt}=v.select,Qe=v.scales[Ht].ori,_n=v.posToVal,Wn,Ge,xn,Ii,ci,Wi=pt!=null&&Ot(pt,Ht),es=bt!=null&&Bt(bt,he);Wi&&Hn?(Qe==0?(Wn=Pe,Ge=ee):(Wn=Se,Ge=Jt),xn=b[pt],Ii=X(_n(Wn,Ht),xn,K,0),ci=X(_n(Wn+Ge,Ht),xn,K,0),Wa(xs(Ii,ci),Bn(ci-Ii))):Wa(0,K),es&&Gn?(Qe==1?(Wn=Pe,Ge=ee):(Wn=Se,Ge=Jt),xn=b[bt],Ii=N(_n(Wn,he),xn,lt,0),ci=N(_n(Wn+Ge,he),xn,lt,0),Xa(xs(Ii,ci),Bn(ci-Ii))):Xa(0,lt)}else Zf()}else{let pt=Bn(ng-tg),bt=Bn(ig-eg);if(D.ori==1){let he=pt;pt=bt,bt=he}Hn=jn.x&&pt>=jn.dist,Gn=jn.y&&bt>=jn.dist;let Ot=jn.uni;Ot!=null?Hn&&Gn&&(Hn=pt>=Ot,Gn=bt>=Ot,!Hn&&!Gn&&(bt>pt?Gn=!0:Hn=!0)):jn.x&&jn.y&&(Hn||Gn)&&(Hn=Gn=!0);let Bt,Ht;Hn&&(D.ori==0?(Bt=Do,Ht=je):(Bt=No,Ht=rn),Wa(xs(Bt,Ht),Bn(Ht-Bt)),Gn||Xa(0,lt)),Gn&&(D.ori==1?(Bt=Do,Ht=je):(Bt=No,Ht=rn),Xa(xs(Bt,Ht),Bn(Ht-Bt)),Hn||Wa(0,K)),!Hn&&!Gn&&(Wa(0,0),Xa(0,0))}if(jn._x=Hn,jn._y=Gn,v==null){if(L){if(gg!=null){let[pt,bt]=Rn.scales;Rn.values[0]=pt!=null?ws(D.ori==0?je:rn,pt):null,Rn.values[1]=bt!=null?ws(D.ori==1?je:rn,bt):null}Ya(um,i,je,rn,H,It,F)}if(re){let pt=L&&Rn.setSeries,bt=Gt.prox;qr==null?Ys<=bt&&Ms(xr,Fo,!0,pt):Ys>bt?Ms(null,Fo,!0,pt):xr!=qr&&Ms(xr,Fo,!0,pt)}}mt&&(ft.idx=F,qf()),T!==!1&&Vn("setCursor")}let yr=null;Object.defineProperty(i,"rect",{get(){return yr==null&&qa(!1),yr}});function qa(v=!1){v?yr=null:(yr=g.getBoundingClientRect(),Vn("syncRect",yr))}function og(v,T,L,F,q,K,lt){dt._lock||gr&&v!=null&&v.movementX==0&&v.movementY==0||(Yf(v,T,L,F,q,K,lt,!1,v!=null),v!=null?Yr(null,!0,!0):Yr(T,!0,!1))}function Yf(v,T,L,F,q,K,lt,pt,bt){if(yr==null&&qa(!1),se(v),v!=null)L=v.clientX-yr.left,F=v.clientY-yr.top;else{if(L<0||F<0){je=-10,rn=-10;return}let[Ot,Bt]=Rn.scales,Ht=T.cursor.sync,[he,Le]=Ht.values,[Pe,Se]=Ht.scales,[ee,Jt]=Rn.match,Qe=T.axes[0].side%2==1,_n=D.ori==0?H:It,Wn=D.ori==1?H:It,Ge=Qe?K:q,xn=Qe?q:K,Ii=Qe?F:L,ci=Qe?L:F;if(Pe!=null?L=ee(Ot,Pe)?a(he,b[Ot],_n,0):-10:L=_n*(Ii/Ge),Se!=null?F=Jt(Bt,Se)?a(Le,b[Bt],Wn,0):-10:F=Wn*(ci/xn),D.ori==1){let Wi=L;L=F,F=Wi}}bt&&(T==null||T.cursor.event.type==um)&&((L<=1||L>=H-1)&&(L=yo(L,H)),(F<=1||F>=It-1)&&(F=yo(F,It))),pt?(tg=L,eg=F,[Do,No]=dt.move(i,L,F)):(je=L,rn=F)}let $f={width:0,height:0,left:0,top:0};function Zf(){gc($f,!1)}let ag,lg,cg,hg;function ug(v,T,L,F,q,K,lt){gr=!0,Hn=Gn=jn._x=jn._y=!1,Yf(v,T,L,F,q,K,lt,!0,!1),v!=null&&(Re(fm,_m,fg,!1),Ya(Yx,i,Do,No,H,It,null));let{left:pt,top:bt,width:Ot,height:Bt}=Ke;ag=pt,lg=bt,cg=Ot,hg=Bt}function fg(v,T,L,F,q,K,lt){gr=jn._x=jn._y=!1,Yf(v,T,L,F,q,K,lt,!1,!0);let{left:pt,top:bt,width:Ot,height:Bt}=Ke,Ht=Ot>0||Bt>0,he=ag!=pt||lg!=bt||cg!=Ot||hg!=Bt;if(Ht&&he&&gc(Ke),jn.setScale&&Ht&&he){let Le=pt,Pe=Ot,Se=bt,ee=Bt;if(D.ori==1&&(Le=bt,Pe=Bt,Se=pt,ee=Ot),Hn&&_r(S,ws(Le,S),ws(Le+Pe,S)),Gn)for(let Jt in b){let Qe=b[Jt];Jt!=S&&Qe.from==null&&Qe.min!=Xe&&_r(Jt,ws(Se+ee,Jt),ws(Se,Jt))}Zf()}else dt.lock&&(dt._lock=!dt._lock,Yr(T,!0,v!=null));v!=null&&(In(fm,_m),Ya(fm,i,je,rn,H,It,null))}function db(v,T,L,F,q,K,lt){if(dt._lock)return;se(v);let pt=gr;if(gr){let bt=!0,Ot=!0,Bt=10,Ht,he;D.ori==0?(Ht=Hn,he=Gn):(Ht=Gn,he=Hn),Ht&&he&&(bt=je<=Bt||je>=H-Bt,Ot=rn<=Bt||rn>=It-Bt),Ht&&bt&&(je=je<Do?0:H),he&&Ot&&(rn=rn<No?0:It),Yr(null,!0,!0),gr=!1}je=-10,rn=-10,st.fill(null),Yr(null,!0,!0),pt&&(gr=pt)}function dg(v,T,L,F,q,K,lt){dt._lock||(se(v),Va(),Zf(),v!=null&&Ya(Jx,i,je,rn,H,It,null))}function pg(){w.forEach(oC),k(i.width,i.height,!0)}So(gf,Ca,pg);let Oo={};Oo.mousedown=ug,Oo.mousemove=og,Oo.mouseup=fg,Oo.dblclick=dg,Oo.setSeries=(v,T,L,F)=>{let q=Rn.match[2];L=q(i,T,L),L!=-1&&Ms(L,F,!0,!1)},gt&&(Re(Yx,g,ug),Re(um,g,og),Re($x,g,v=>{se(v),qa(!1)}),Re(Zx,g,db),Re(Jx,g,dg),Em.add(i),i.syncRect=qa);let _c=i.hooks=n.hooks||{};function Vn(v,T,L){li?ze.push([v,T,L]):v in _c&&_c[v].forEach(F=>{F.call(null,i,T,L)})}(n.plugins||[]).forEach(v=>{for(let T in v.hooks)_c[T]=(_c[T]||[]).concat(v.hooks[T])});let mg=(v,T,L)=>L,Rn=Pn({key:null,setSeries:!1,filters:{pub:ay,sub:ay},scales:[S,_[1]?_[1].scale:null],match:[ly,ly,mg],values:[null,null]},dt.sync);Rn.match.length==2&&Rn.match.push(mg),dt.sync=Rn;let gg=Rn.key,Jf=sv(gg);function Ya(v,T,L,F,q,K,lt){Rn.filters.pub(v,T,L,F,q,K,lt)&&Jf.pub(v,T,L,F,q,K,lt)}Jf.sub(i);function pb(v,T,L,F,q,K,lt){Rn.filters.sub(v,T,L,F,q,K,lt)&&Oo[v](null,T,L,F,q,K,lt)}i.pub=pb;function mb(){Jf.unsub(i),Em.delete(i),kn.clear(),vm(gf,Ca,pg),c.remove(),Rt?.remove(),Vn("destroy")}i.destroy=mb;function jf(){Vn("init",n,t),Ga(t||n.data,!1),V[S]?Vf(S,V[S]):Va(),rt=Ke.show&&(Ke.width>0||Ke.height>0),nt=mt=!0,k(n.width,n.height)}return _.forEach(Ao),w.forEach(Vs),e?e instanceof HTMLElement?(e.appendChild(c),jf()):e(i,jf):jf(),i}Kn.assign=Pn;Kn.fmtNum=Lm;Kn.rangeNum=_f;Kn.rangeLog=vf;Kn.rangeAsinh=Pm;Kn.orient=wo;Kn.pxRatio=Ne;Kn.join=jA;Kn.fmtDate=Nm,Kn.tzDate=lR;Kn.sync=sv;{Kn.addGap=WR,Kn.clipGaps=Mf;let n=Kn.paths={points:hv};n.linear=fv,n.stepped=YR,n.bars=$R,n.spline=JR}var hc=0;function Vi(){hc+=1,O.moving&&(O.moving=!1,oe("moving",!1))}function ys(n,t=.8){Vi();let e=O.q.slice(),i=hc,s=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),O.moving=!0,oe("moving",!0),new Promise(r=>{(function o(a){if(i!==hc||e.length!==O.q.length){r(!1);return}let l=t>0?Math.min(Math.max((a-s)/(1e3*t),0),1):1,c=l**3*(10-15*l+6*l*l);Rs(l<1?e.map((h,u)=>h+c*(n[u]-h)):n.slice(),"move"),l<1?requestAnimationFrame(o):(O.moving=!1,oe("moving",!1),r(!0))})(s)})}function gv(n,t,e,i){Vi();let s=hc,r=performance.now()-1e3*n*t;O.moving=!0,oe("moving",!0),requestAnimationFrame(function o(a){if(s!==hc){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(O.moving=!1,oe("moving",!1),i?.(!0))})}var Hm={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},_v={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},Af=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,xv=80;function aC(n){let t=[];Af.lastIndex=0;let e=n.trimEnd();for(;Af.lastIndex<e.length;){let i=Af.lastIndex,s=Af.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function Rf(n,t="plain"){let e=String(n);if(e.length>xv)throw new Error(`longer than ${xv} characters`);let i=aC(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in Ut.suffix(t)&&(s=Ut.suffix(t)[r.word],i.pop());let o=0,a=!1,l=m=>i[o]?.sign===m,c=m=>{if(!l(m))throw new Error(`\u201C${m}\u201D is missing`);o++};function h(){let m=u();for(;l("+")||l("-");){let _=i[o++].sign,w=u();m=_==="+"?m+w:m-w}return m}function u(){let m=f();for(;;)if(l("*"))o++,m*=f();else if(l("/"))o++,m/=f();else if(i[o]?.word||l("("))m*=d();else return m}function f(){return l("-")?(o++,-f()):l("+")?(o++,f()):d()}function d(){let m=g();return l("^")?(o++,m**f()):m}function g(){let m=i[o];if(!m)throw new Error("something is missing at the end");if(o++,m.number!==void 0)return m.number;if(m.sign==="("){let _=h();return c(")"),_}if(m.word){let _=m.word.toLowerCase();if(Object.hasOwn(_v,_))return a=!0,_v[_];if(Object.hasOwn(Hm,_)){c("(");let w=h();return c(")"),Hm[_](w)}throw new Error(`\u201C${m.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(Hm).join(", ")}`)}throw new Error(`\u201C${m.sign}\u201D is not expected here`)}let x=h();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(x))throw new Error("not a finite number");let p=s??(t==="angle"&&a?1:Ut.factor(t));return{value:x/p+0,symbolic:a||s!==null||i.length>2}}function Ai({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=A("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),h=null,u=null,f=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let x=Rf(c.value,l()),p=a?.(x.value);if(p)throw new Error(p);return x},d=x=>{c.classList.toggle("wrong",!!x),x?(c.setAttribute("aria-invalid","true"),c.title=x):(c.removeAttribute("aria-invalid"),c.title=o??""),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:x?{label:n,reason:x}:null}))},g=x=>{try{let p=f();return d(null),x?.(p.value,{symbolic:p.symbolic,text:c.value.trim()}),!0}catch(p){return d(p.message),!1}};return c.addEventListener("input",()=>g(e)),c.addEventListener("change",()=>{g(i??e)&&c.blurred?.()}),c.addEventListener("focus",()=>c.select()),c.addEventListener("keydown",x=>{let p={ArrowUp:1,ArrowDown:-1}[x.key];if(x.key==="Enter"&&c.select(),!!p){x.preventDefault();try{let m=f();c.value=tc((m.value??0)+p*Ut.step(l())*(x.shiftKey?.1:1),l()),g(i??e)}catch{}}}),c.put=(x,p=null)=>{document.activeElement===c&&!c.readOnly||x===h&&p===u&&!c.classList.contains("wrong")||(h=x,u=p,c.value=p??(x==null?"":tc(x,l())),c.classList.contains("wrong")&&d(null))},c.refresh=()=>{let x=h,p=u;h=NaN,c.put(x,p)},c}var hn=n=>n.type==="R"?"angle":"length";function yv(n){let t=n.type==="R"?Math.PI:Sc(O.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}function lC(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function cC(n){let t=O.table.joints[n],e=hn(t),{lo:i,hi:s,min:r,max:o}=yv(t),a=`q${n+1}`,l=A("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=g=>`${100*(g-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{Vi(),wc(n,Number(l.value))}),l.addEventListener("keydown",g=>{let x={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[g.key],p={Home:i,End:s}[g.key];if(x===void 0&&p===void 0)return;g.preventDefault(),Vi();let m=Ut.step(e)*(g.shiftKey?.1:1);wc(n,p??Math.min(Math.max(Math.round((O.q[n]+x*m)/(m/10))*(m/10),r),o))});let h=Ai({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:g=>{Vi(),wc(n,g)}}),u=A("span",{class:"out",role:"note"}),f=A("span",{class:"limits"}),d=A("div",{class:"joint","data-testid":`joint-${n+1}`},A("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},A("i",{text:"q"}),A("sub",{text:String(n+1)})),A("div",{class:"track"},l,A("div",{class:"under"},f,u)),h,A("span",{class:"unit"}));return{el:d,number:h,show(){let g=O.q[n],x=lC(t,g);(document.activeElement!==l||Number(l.value)!==g)&&(l.value=g),l.style.setProperty("--at",c(Math.min(Math.max(g,r),o))),l.setAttribute("aria-valuetext",Jn(g,e)),h.put(Number((g*Ut.factor(e)).toFixed(Ut.digits(e)+1))/Ut.factor(e)),d.classList.toggle("outside",x!==0),zt(u,x?`${Jn(Math.abs(x),e)} ${x>0?"above":"below"} the limit`:"")},relabel(){zt(d.lastChild,Ut.symbol(e));let g=x=>x===null?"no limit":Jn(x,e,Ut.angle==="deg"&&e==="angle"?0:void 0);zt(f,t.lower===null&&t.upper===null?"no limits":`${g(t.lower)} \u2026 ${g(t.upper)}`),h.refresh(),this.show()}}}var vv={id:"joints",title:"Joints",build(n){let t=[],e=A("div",{class:"joints","data-testid":"joints"}),i=A("div",{class:"chips",role:"group","aria-label":"Postures"}),s=A("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=O.table.joints.map((o,a)=>cC(a)),ne(e,t.map(o=>o.el)),t.length||e.append(A("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),ne(s,O.table.actuator?hC(O.table.actuator):null),uC(i)};Pt("table",r),Pt("q",()=>t.forEach(o=>o.show())),Pt("units",()=>t.forEach(o=>o.relabel())),r()}};function hC(n){let t=A("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=A("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),zt(e,Zn(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n.value=Number(t.value),i()}),i();let s=A("div",{class:"under"},A("span",{text:`${n.name}: moves no frame`}));return A("div",{class:"joint"},A("span",{class:"joint-name",text:"tool"}),A("div",{class:"track"},t,s),e,A("span",{class:"unit",text:n.unit}))}function uC(n){let t=O.table.joints.length,e=Object.entries(O.table.postures??{}),i=(r,o)=>A("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>Jn(a,hn(O.table.joints[l]))).join(", "),on:{click:()=>ys(o)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),ne(n,s,t?A("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>ys(fC())}}):null,t?A("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:dC}}):null)}function fC(){return O.table.joints.map(n=>{let{lo:t,hi:e}=yv(n);return t+Math.random()*(e-t)})}function dC(){let n={...O.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=O.q.slice(),Dn({...O.table,postures:n},{what:"postures"}),ti(`Kept as P${t}: ${O.q.map((e,i)=>tc(e,hn(O.table.joints[i]))).join(", ")}`),oe("postures")}var bv=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function Cf({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(h=>vr(n,h));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(h=>$e(h[h.length-1])),speeds:o??pC(t,r),least:t.map((h,u)=>Mc(n,h,c[u])[0]??0)}}function pC(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function Gm(n,t){let{table:e}=n,i=Ut.factor("length");if(t==="position")return{y:`tool, ${Ut.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(h=>h[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(hn))].map(l=>(l==="angle"?Ut.angle:Ut.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(h=>h[c]*Ut.factor(hn(l)))}))}}function Sv(n){let t=Ut.angle,e=Ut.length,{table:i}=n,s=l=>hn(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(h=>h*Ut.factor("length")),...l.map((h,u)=>h*Ut.factor(hn(i.joints[u]))),...n.speeds[c].map((h,u)=>h*Ut.factor(hn(i.joints[u]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function Mv(n,t,e){let{y:i,list:s}=Gm(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(y=>y.values),h=n.xEnd??l[l.length-1],u=l[0],f=h>u?h:u+1,[d,g]=[Math.min(...c),Math.max(...c)];g-d>1e-9||(d-=1,g+=1);let x=y=>a.l+(y-u)/(f-u)*(r-a.l-a.r),p=y=>o-a.b-(y-d)/(g-d)*(o-a.t-a.b),m=(y,M)=>{let U=(M-y)/6,I=10**Math.floor(Math.log10(U)),D=[1,2,5,10].map(z=>z*I).find(z=>z>=U);return Array.from({length:12},(z,X)=>(Math.ceil(y/D)+X)*D).filter(z=>z<=M+D*1e-6)},_=y=>y.toFixed(2),w=y=>String(Number(y.toPrecision(6))),b=y=>y.replace(/[&<>"]/g,M=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[M]),C=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],S=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${b(n.title)}</text>`];for(let y of m(d,g))S.push(`<path d="M${a.l} ${_(p(y))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${_(p(y)+4)}" text-anchor="end">${w(y)}</text>`);for(let y of m(u,f))S.push(`<path d="M${_(x(y))} ${o-a.b}v5" stroke="#333"/><text x="${_(x(y))}" y="${o-a.b+20}" text-anchor="middle">${w(y)}</text>`);S.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let y of n.events)Number.isFinite(y.x)&&S.push(`<path d="M${_(x(y.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${_(x(y.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${b(y.short)}</text>`);return s.forEach((y,M)=>{let U=e[M%e.length],I=y.values[y.values.length-1];S.push(`<polyline fill="none" stroke="${U}" stroke-width="1.8" stroke-dasharray="${C[M%C.length]}" points="${y.values.map((D,z)=>`${_(x(l[z]))},${_(p(D))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*M}h22" stroke="${U}" stroke-width="2" stroke-dasharray="${C[M%C.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*M}"><title>${_(I)}</title>${b(y.name)}</text>`)}),S.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${b(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${b(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${S.join("")}</svg>
`}var ke=null,zn=null,Oa="joints",Qi=0,wv=1,oi=null;function Ev(n){let t=A("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:mC}}),e=A("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{Vi(),Lf(Number(e.value))}}}),i=A("output",{class:"where","data-testid":"where"}),s=A("div",{class:"marks"}),r=A("div",{class:"chart","data-testid":"chart"}),o=A("div",{class:"legend"});n.append(A("div",{class:"dock-bar"},t,fi("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{wv=Number(a)},{"data-testid":"speed"}),A("div",{class:"scrubber"},e,s),i,A("span",{class:"line"},...[["CSV",()=>Js("motion.csv",Sv(ke),"text/csv")],["PNG",_C],["SVG",()=>Js(`${Oa}.svg`,Mv(ke,Oa,be.curves),"image/svg+xml")]].map(([a,l])=>A("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>ke&&l()}})),A("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>Eo(null)}}))),A("div",{class:"dock-bar second"},Xn("Curves",bv,Oa,a=>{Oa=a,Vm()},"curves"),o),r),oi={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Sr(()=>zn&&r.clientWidth&&zn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),Pt(["units","theme"],Vm),Pt("moving",a=>zt(t,a&&If?"Pause":"Play")),Pt("table",a=>{ke&&a!=="postures"&&a!=="name"&&Eo(null)})}function Eo(n){if(Vi(),ke=n,O.motion=n,oi.root.hidden=!n,zn&&(zn.destroy(),zn=null),!n){requestAnimationFrame(()=>zr()),oe("motion");return}oi.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;ne(oi.marks,n.events.map(e=>{let i=A("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i})),Vm(),n.q.length&&Lf(0),requestAnimationFrame(()=>zr()),oe("motion")}function Lf(n){ke?.q.length&&(Qi=Math.min(Math.max(Math.round(n),0),ke.q.length-1),oi.scrub.value=String(Qi),oi.scrub.style.setProperty("--at",`${ke.q.length>1?100*Qi/(ke.q.length-1):0}%`),zt(oi.where,ke.xName==="point"?`point ${Qi+1} of ${ke.q.length}`:`${Zn(ke.xs[Qi],2)} s of ${Zn(ke.xs[ke.xs.length-1],2)} s`),oi.scrub.setAttribute("aria-valuetext",oi.where.textContent),Rs(ke.q[Qi].slice(),"scrub"),Wm())}var If=!1;function mC(){if(If){Vi();return}if(!ke?.q.length)return;let n=ke.seconds,t=n[n.length-1]||1,e=Qi>=ke.q.length-1?0:n[Qi]/t;If=!0,gv(t/wv,e,i=>{let s=Qi<=ke.q.length-1&&n[Qi]<=i*t?Qi:0;for(;s<n.length-1&&n[s+1]<=i*t+1e-9;)s+=1;Lf(s)},()=>{If=!1,zt(oi.toggle,"Play")}),zt(oi.toggle,"Pause")}function Vm(){if(!ke||!oi)return;zn&&(zn.destroy(),zn=null);let{y:n,list:t}=Gm(ke,Oa),e={stroke:be.line,width:1},i=`${Math.round(.78*Pf())}px "Inter Variable", system-ui, sans-serif`;ne(oi.legend,t.map((o,a)=>{let l=A("span",{class:"swatch"});return l.style.setProperty("background",be.curves[a%be.curves.length]),A("span",{},l,o.name)}));let s={stroke:be.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*Pf(),gap:4};zn=new Kn({width:oi.chart.clientWidth||600,height:oi.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,ke.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:be.curves[a%be.curves.length],width:1.75,pxAlign:0,points:{show:ke.q.length<3}}))],axes:[{...s,label:ke.xName==="point"?"point number":"time, s",size:2.1*Pf()},{...s,label:n,size:4*Pf()}]},[ke.xs,...t.map(o=>o.values)],oi.chart);let r=A("div",{class:"now"});zn.over.append(r,...ke.events.map(o=>{let a=A("div",{class:`event ${o.stop?"stop":""}`,title:o.text},A("span",{text:o.short}));return a.x=o.x,a})),zn.over.addEventListener("pointerdown",o=>{let a=h=>Lf(gC(zn.posToVal(h.clientX-zn.over.getBoundingClientRect().left,"x")));Vi(),a(o);let l=h=>a(h),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),zn.hooks.setSize=[Wm],Wm()}var Pf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),gC=n=>ke.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(ke.xs[t]-n)?i:t,0);function Wm(){if(!zn)return;let n=zn.over.clientWidth;for(let t of zn.over.querySelectorAll(".now, .event")){let e=zn.valToPos(t.x??ke.xs[Qi],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}function _C(){let n=zn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=be.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>Js(`${Oa}.png`,i))}function Tv(n){let t=A("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>xC(t.value)}}),e=A("p",{class:"sentence","data-testid":"sentence"}),i=A("span",{class:"online",role:"status","data-testid":"online"}),s=()=>{let r=O.catalog?.includes(O.table.name)?[]:[A("option",{value:"",text:O.table.name||"my-arm"})];ne(t,r,(O.catalog??[]).map(o=>A("option",{value:o,text:o}))),t.value=r.length?"":O.table.name};n.append(A("span",{class:"mark"},A("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),A("b",{text:"pieper"})),t,e,A("span",{class:"bar-end"},i,Xn("Angles in",[["deg","\xB0"],["rad","rad"]],Ut.angle,r=>{Ut.set("angle",r),oe("units")},"unit-angle"),Xn("Lengths in",[["mm","mm"],["m","m"]],Ut.length,r=>{Ut.set("length",r),oe("units")},"unit-length"),fi("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],O.theme,Ic,{"data-testid":"theme"}))),Pt(["catalog","table"],s),Pt("plan",()=>{zt(e,[Lc(O.plan),Ig(O.plan)].filter(Boolean).join(". ").replace("..",".")),e.title=O.plan?.explain??""}),Pt("online",r=>{zt(i,r?"":"Server away; reconnecting"),i.classList.toggle("away",!r)}),Pt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(Ut.angle),n.querySelector("[data-testid=unit-length]").mark(Ut.length),n.querySelector("[data-testid=theme]").value=O.theme})}async function xC(n){if(n)try{let{table:t}=await Zs("load",{name:n});Dn(t,{q:Bo(t),what:"new"})}catch(t){ti(t.message,"wrong")}}function Av(n,t,e,i){let s=A("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=i.map(l=>{let c=A("div",{role:"tabpanel",class:"panel",id:`panel-${l.id}`,"aria-labelledby":`tab-${l.id}`,"data-testid":`panel-${l.id}`,hidden:!0});for(let u of l.sections??[l]){let f=A("section",{class:"section"},A("h2",{text:u.title}));c.append(f),u.build(f,c)}let h=A("button",{type:"button",role:"tab",id:`tab-${l.id}`,"aria-controls":c.id,text:l.title,on:{click:()=>a(l.id)}});return s.append(h),{...l,panel:c,tab:h}});function a(l){r.matches&&l==="move"&&(l="inverse"),O.panel=l;for(let c of o){let h=r.matches&&c.id==="move",u=c.id===l||h;(h?e:t).append(c.panel),c.panel.hidden=!u,c.tab.hidden=h,c.tab.setAttribute("aria-selected",String(c.id===l)),c.tab.tabIndex=c.id===l?0:-1,c.id===l&&(document.getElementById("room").dataset.panel=l,document.getElementById("room").classList.toggle("wide",!!c.wide))}oe("panel",l)}return s.addEventListener("keydown",l=>{let c={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[l.key];if(!c)return;l.preventDefault();let h=o.filter(d=>!d.tab.hidden),u=h.findIndex(d=>d.id===O.panel),f=h[(u+c+h.length)%h.length];a(f.id),f.tab.focus()}),r.addEventListener("change",()=>a(O.panel==="move"||!o.some(l=>l.id===O.panel)?"move":O.panel)),a(O.panel),a}function Rv(n){let t=A("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,h])=>A("button",{type:"button",text:h,on:{click:()=>Np(c)}})),A("button",{type:"button",text:"Fit",on:{click:()=>zr()}})),e=A("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=A("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),vx(c)}}}),s=A("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:Ku}}),r=A("span",{class:"scale"}),o=A("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,h)=>{let u=A("span",{class:"dot"});return u.style.setProperty("background",Wl[h]),A("span",{},u,c)}),r);n.append(A("div",{class:"corner top"},t,A("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s)),A("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=O.table.joints.length,h=Array.from({length:c+2},(f,d)=>d);O.shownFrames=(O.shownFrames??[0,c+1]).map(f=>f===a+1?c+1:f).filter(f=>f<c+2),a=c;let u=f=>{O.shownFrames=f,l()};ne(e,A("span",{class:"group-name",text:"Frames"}),h.map(f=>A("button",{type:"button",text:ju(f),"aria-pressed":String(O.shownFrames.includes(f)),"aria-label":`Frame ${ju(f)}`,on:{click:()=>u(O.shownFrames.includes(f)?O.shownFrames.filter(d=>d!==f):[...O.shownFrames,f])}})),A("button",{type:"button",text:O.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>u(O.shownFrames.length===c+2?[]:h)}})),oe("frames"),zt(r,`grid ${Jn(Fp.cell,"length",Ut.length==="mm"?0:2)}`)};Pt(["table","units"],l),l()}function Cv(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text], textarea")&&!n.target.closest(".dh")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Ec()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Tc()))})}function Df(n,t){let e=Array.from({length:16},(s,r)=>A("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=A("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>A("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;zt(e[r],r>=12?String(s[r]):o?Zn(s[r]*Ut.factor("length"),Ut.digits("length")):Zn(s[r],4))}},i}var Nf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var qm=()=>O.frames[O.frames.length-1],Iv={id:"pose",title:"Pose",build(n){let t=Df("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(h=>Pv(h,"length",`pose-${h.toLowerCase()}`)),i=A("div",{class:"quantities","data-testid":"orientation"}),s=A("p",{class:"hint order"}),r=[],o=fi("Notation of the orientation",Object.entries(ms).map(([h,u])=>[h,u.title]),O.notation,h=>{O.notation=h,oe("notation")}),a=A("span",{class:"copies"},A("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>Jr(Nf(qm()))}}),A("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>Jr(yC())}}));n.append(A("div",{class:"subhead"},A("span",{text:"Tool in the base frame"}),a),t,A("div",{class:"quantities"},e.map(h=>h.el)),A("div",{class:"line"},o,s),i);let l=()=>{let h=ms[O.notation];o.value=O.notation,zt(s,h.order),r=h.names.map((u,f)=>Pv(u,h.kinds[f],`turn-${f}`)),ne(i,r.map(u=>u.el)),c()},c=()=>{let h=qm();t.show(h),$e(h).forEach((u,f)=>e[f].show(u)),ms[O.notation].to(h).forEach((u,f)=>r[f].show(u))};Pt("q",c),Pt("notation",l),Pt("units",()=>{e.forEach(h=>h.relabel()),r.forEach(h=>h.relabel()),c()}),l()}};function yC(){let n=qm(),t=ms[O.notation],e=$e(n).map((s,r)=>`${"XYZ"[r]} ${vi(s,"length")} ${Ut.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${vi(s,"angle")} ${Ut.symbol("angle")}`:Zn(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function Pv(n,t,e){let i=A("output",{"data-testid":e}),s=A("span",{class:"unit",text:Ut.symbol(t)});return{el:A("div",{class:"quantity"},A("span",{class:"quantity-name",text:n}),i,s),show:o=>zt(i,t==="plain"?Zn(o,5):vi(o,t)),relabel:()=>zt(s,Ut.symbol(t))}}function vC(n,t){let e=[],i=n.joints.length,s=r=>n.convention==="standard"?n.joints[r].alpha:n.joints[r+1]?.alpha;for(let r=0;r<i-1;r++){let o=$a(n.joints[r],t[r]).theta,a=1,l=`${r+1}`;for(let c=r;c<i-1;c++){let h=s(c);if(Math.abs(Math.sin(h))>1e-9||n.joints[c+1].type!=="R"||n.joints[r].type!=="R")break;a*=Math.sign(Math.cos(h)),o+=a*$a(n.joints[c+1],t[c+1]).theta,l+=`${a>0?"":"\u2212"}${c+2}`,e.push({name:l,value:o})}}return e}var Lv={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=A("div",{class:"cards","data-testid":"matrices"}),a=A("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=fi("Posture",[["now","present posture"]],"now",g=>{e=g,f()}),c=A("span",{class:"partial"});n.append(A("div",{class:"line"},Xn("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,g=>{t=g,u()},"matrix-mode"),c),A("div",{class:"line"},A("span",{class:"field-name",text:"Numbers of the"}),l),o,A("h3",{text:"Intermediate angles"}),A("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let h=()=>e!=="now"&&O.solutions?.rows[Number(e)]?.q||O.q,u=()=>{let g=O.table.joints.length;i=Math.min(i,g),s=s===0||s>g?g:s;let x=t==="links"?O.table.joints.map((m,_)=>["A",String(_+1),""]):t==="products"?O.table.joints.map((m,_)=>["T",String(_+1),"0"]):[["T",String(s),String(i)]];t==="links"&&x.push(["T","tool","base"]);let p=Array.from({length:g+1},(m,_)=>[String(_),String(_)]);ne(c,t==="partial"?[fi("From frame",p,String(i),m=>{i=Number(m),u()})," \u2192 ",fi("To frame",p,String(s),m=>{s=Number(m),u()})]:[]),r=x.map(([m,_,w])=>({grid:Df(`${m} ${w} ${_}`,`matrix-${m}${w}${w?"-":""}${_}`),note:A("span",{class:"hint"}),sym:m,low:_,high:w})),ne(o,r.map(({grid:m,note:_,sym:w,low:b,high:C})=>A("figure",{class:"card"},A("figcaption",{},A("span",{class:"symbol"},C?A("sup",{text:C}):null,A("i",{text:w}),A("sub",{text:b})),_),m))),f()},f=Sr(()=>{if(n.closest(".panel").hidden||!O.table.joints.length)return;let g=h(),x=vg(O.table,g),p=x.length;r.forEach(({grid:_,note:w},b)=>{if(t==="links"&&b<p)_.show(x[b]),zt(w,`q${b+1} = ${Jn(g[b],hn(O.table.joints[b]))}`);else if(t==="links")_.show(vr(O.table,g)[p+1]);else if(t==="products")_.show(x.slice(0,b+1).reduce(Zr,$s()));else{let C=S=>x.slice(0,S).reduce(Zr,$s());_.show(Zr(xg(C(i)),C(s)))}});let m=O.table.joints.map((_,w)=>[_.type==="R"?`\u03B8${w+1}`:`d${w+1}`,_.type==="R"?vi($a(_,g[w]).theta,"angle"):vi($a(_,g[w]).d,"length"),_.type==="R"?"angle":"length"]).concat(vC(O.table,g).map(({name:_,value:w})=>[`\u03B8${_}`,vi(w,"angle"),"angle"]));ne(a,A("tbody",{},m.map(([_,w,b])=>A("tr",{},A("th",{scope:"row"},A("i",{text:_[0]}),A("sub",{text:_.slice(1)})),A("td",{text:w}),A("td",{class:"unit",text:Ut.symbol(b)})))))}),d=()=>{if(n.closest(".panel").hidden)return;let g=O.solutions?.rows??[];ne(l,A("option",{value:"now",text:"present posture"}),g.map((x,p)=>A("option",{value:String(p),text:`solution ${p+1}: ${x.label??""}`}))),e!=="now"&&!g[Number(e)]&&(e="now"),l.value=e,f()};Pt("table",u),Pt(["q","units","panel"],f),Pt(["solutions","panel"],d),u()}};var bC=.002;function To(n,t,e,i){let s=[],r=!1,o="",a=A("div",{class:"pose-fields"}),l=()=>{let h=ms[O.notation],u=[["X","length"],["Y","length"],["Z","length"],...h.names.map((d,g)=>[d,h.kinds[g]])],f=d=>{let g=Ox(O.notation,s.slice(3).map(x=>x.value),s.slice(0,3).map(x=>x.value));g&&i(g,d)};s=u.map(([d,g],x)=>{let p={value:0,kind:g},m=(_,w)=>{p.value=_;let b=!r;r=!w,f(b)};return p.f=Ai({label:`${n}, ${d}`,kind:g,testid:`${t}-${x}`,input:_=>m(_,!1),commit:_=>m(_,!0)}),p.el=A("label",{class:"pose-field"},A("span",{text:d}),p.f,A("span",{class:"unit",text:Ut.symbol(g)})),p}),ne(a,s.map(d=>d.el)),o=O.notation},c=()=>{o!==O.notation&&l();let h=e();!h||a.contains(document.activeElement)||[...$e(h),...ms[O.notation].to(h)].forEach((u,f)=>{s[f].value=u,s[f].f.put(u,SC(u,s[f].kind))})};return Pt("units",()=>{l(),c()}),Pt("notation",c),l(),c(),a.addEventListener("focusout",()=>{r=!1,setTimeout(c)}),{el:A("fieldset",{class:"pose-editor"},A("legend",{text:n}),a),show:c}}var SC=(n,t)=>String(Number((n*Ut.factor(t)).toFixed(t==="plain"||Ut[t]==="m"||Ut[t]==="rad"?6:3))+0);function Dv(n){let t=(n.replaceAll("\u2212","-").match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length} numbers were found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=vc(e);if(i>bC)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=Ut.factor("length");return bc(e)}function Nv(n,t){let e=t?.families??[],i=!Ei.task&&O.plan?.task==="pose";n.drawn!==e&&(n.drawn=e,ne(n,e.map((s,r)=>{let o=A("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along family ${r+1}`,"data-testid":`family-${r+1}`}),a=()=>{Vi();let h=Number(o.value),u=Math.max(s.s.findLastIndex(x=>x<=h),0),f=Math.min(u+1,s.q.length-1),d=f>u?(h-s.s[u])/(s.s[f]-s.s[u]):0;o.style.setProperty("--at",`${100*h}%`);let g=s.q[u].map((x,p)=>x+d*(s.q[f][p]-x));Rs(i?bg(O.table,g,t.T):g,"family")},l=h=>h.reduce((u,f,d)=>u+Math.sin((f-O.q[d])/2)**2,0);o.value=String(s.s[s.q.reduce((h,u,f)=>l(u)<l(s.q[h])?f:h,0)]),o.style.setProperty("--at",`${100*Number(o.value)}%`),s.inside.length===1&&(o.style.setProperty("--lo",`${100*s.inside[0][0]}%`),o.style.setProperty("--hi",`${100*s.inside[0][1]}%`)),o.addEventListener("input",a),o.addEventListener("keydown",h=>{let u={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[h.key];u&&(h.preventDefault(),o.value=Math.min(Math.max(Number(o.value)+u/100,0),1),a())});let c=s.moves.length>3?"all its joints":s.moves.join(" and ");return A("div",{class:"family"},A("p",{},A("strong",{text:e.length>1?`Self-motion ${r+1} of ${e.length}`:"Self-motion"}),` by ${c}, ${s.closed?"a closed curve":"an open curve"}: the arm moves, the tool stands still.`,s.inside.length?"":" All of it lies outside the limits."),o)})))}function Uv(){let n=A("thead"),t=A("tbody"),e=A("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=A("div",{class:"scroll"},A("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${O.table.joints.map(c=>c.type).join("")}${Ut.angle}${Ut.length}`;l!==r&&(r=l,s=[],ne(t),ne(n,A("tr",{},A("th",{text:""}),A("th",{class:"left",text:"posture"}),O.table.joints.map((c,h)=>A("th",{},A("i",{text:"q"}),A("sub",{text:String(h+1)}),A("span",{class:"unit",text:` ${Ut.symbol(hn(c))}`}))),A("th",{text:"residual"}))))},a=l=>{let c=O.table.joints.map(()=>A("td")),h=A("span"),u=A("span",{class:"offscreen"}),f=A("td",{class:"unit"}),d=A("tr",{tabindex:"0","data-testid":`solution-${l+1}`},A("th",{scope:"row",text:String(l+1)}),A("td",{class:"left"},h,u),c,f),g=()=>O.solutions?.rows[l]?.q,x=()=>g()&&wa(g()),p=()=>wa(null),m=()=>{g()&&(wa(null),ys(MC(g())))};return d.addEventListener("pointerenter",x),d.addEventListener("pointerleave",p),d.addEventListener("focus",x),d.addEventListener("blur",p),d.addEventListener("click",m),d.addEventListener("keydown",_=>{(_.key==="Enter"||_.key===" ")&&(_.preventDefault(),m())}),{tr:d,cells:c,label:h,beyond:u,residual:f}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let h=a(s.length);s.push(h),t.append(h.tr)}i.hidden=c.length===0,e.hidden=c.every(h=>h.inside),s.forEach((h,u)=>{let f=c[u];h.tr.hidden=!f,f&&(h.tr.classList.toggle("beyond",!f.inside),f.label!==null&&zt(h.label,`${f.label}${f.family>=0?" (of a family)":""}`),zt(h.beyond,f.inside?"":", outside the limits"),zt(h.residual,f.residual?`${lf(f.residual[0]*1e3)} mm`:""),h.residual.title=f.residual?`${lf(f.residual[0])} m, ${lf(f.residual[1])} rad by forward kinematics`:"",f.q.forEach((d,g)=>{let x=O.table.joints[g],p=x.lower!==null&&d<x.lower-1e-9||x.upper!==null&&d>x.upper+1e-9;zt(h.cells[g],vi(d,hn(x),hn(x)==="angle"&&Ut.angle==="deg"?1:void 0)),h.cells[g].classList.toggle("out",p)}))}),this.mark()},mark(){let l=O.solutions?.rows??[];s.forEach((c,h)=>c.tr.classList.toggle("here",!!l[h]&&l[h].q.length===O.q.length&&l[h].q.every((u,f)=>Math.abs(Math.sin((u-O.q[f])/2))<1e-5)))}}}function MC(n){return n.map((t,e)=>{let i=O.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((O.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}var wC={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},Fv={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},Ym=120;function $m(){Cs(O.frames[O.frames.length-1].slice(),"taken")}var Ov={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(A("div",{class:"line spread"},A("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:$m}}),Xn("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",g=>{i.hidden=g!=="numbers",s.hidden=g!=="matrix"},"target-as")));let e=To("Target","target",()=>O.target,g=>Cs(g,"typed")),i=A("div",{},e.el),{el:s,show:r}=EC();n.append(i,s,TC());let o=A("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=A("div",{class:"near","data-testid":"ik-nearest"}),l=A("div",{class:"families","data-testid":"families"}),c=Uv();n.append(o,a,l,c.el);let h=Cc(Ym,()=>{e.show(),r()}),u=Cc(Ym,()=>{if(t.hidden)return;let g=O.solutions;AC(o,g),RC(a,g),Nv(l,g),c.show(g)}),f=Cc(Ym,()=>c.mark()),d=g=>()=>af()?g.soon():g();Pt("target",d(h)),Pt("notation",e.show),Pt(["solutions","units"],d(u)),Pt("q",d(f)),Pt("panel",g=>{Lx(g==="inverse"),g==="inverse"&&(O.hasTarget?oe("solutions"):(O.hasTarget=!0,$m()))}),Pt("table",g=>{g==="new"&&(O.hasTarget=O.panel==="inverse",O.hasTarget&&$m())})}};function EC(){let n=A("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=A("p",{class:"reason",role:"alert"}),e=A("p",{class:"hint"});n.addEventListener("input",()=>{try{Cs(Dv(n.value),"typed"),zt(t,""),n.removeAttribute("aria-invalid")}catch(s){zt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(zt(e,`Twelve or sixteen numbers, row by row; the last column in ${Ut.length}.`),document.activeElement===n)return;let s=O.target.map((r,o)=>o%4===3&&o<12?r*Ut.factor("length"):r);n.value=Nf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return Pt("units",i),i(),{el:A("div",{hidden:!0},n,e,t),show:i}}function TC(){let n=A("span",{class:"line"}),t=A("span",{class:"line"}),e=A("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{Ei.follow=e.checked}}});return Pt("plan",()=>{let i=O.plan?.redundancy??[];ne(n,i.length===1?[A("span",{class:"field-name",text:`Free joint ${i[0]} at`}),Ai({label:`Value of ${i[0]}`,kind:O.table.joints.find(s=>s.name===i[0])?.type==="P"?"length":"angle",empty:null,testid:"redundancy",commit:s=>{Ei.redundancy=s,xo()}})]:[]),Ei.task=null,ne(t,O.plan?.solvable?[A("span",{class:"field-name",text:"Task"}),fi("Task",[["",`${O.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],"",s=>{Ei.task=s||null,xo()},{"data-testid":"task"})]:[])}),A("div",{class:"line controls"},A("span",{class:"line"},A("span",{class:"field-name",text:"Handles"}),Xn("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Dx)),Xn("Axes of the handles",[["local","Tool"],["world","World"]],"local",Nx),A("span",{class:"line"},A("span",{class:"field-name",text:"Ghosts"}),Xn("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{Ei.ghosts=i,Ea()})),A("label",{class:"check"},e,"Arm follows"),t,n)}function AC(n,t){if(!t){ne(n,A("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(r=>r.inside).length;n.dataset.tone=wC[t.status]??"note";let s=Fv[t.status]&&!i?Fv[t.status]:i===e?`${e} solution${e===1?"":"s"}`:`${e} solutions, ${i} inside the limits`;ne(n,A("strong",{text:s})," ",A("span",{text:t.status==="SOLVED"&&t.rows.length?"":t.why}),t.ms===void 0?null:A("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}function RC(n,t){let e=t?.near;if(!e){ne(n);return}let i=$e(e.T).map(s=>vi(s,"length")).join(", ");ne(n,A("p",{},A("strong",{text:"Nearest reachable: "}),`${i} ${Ut.symbol("length")}, ${Jn(e.metres,"length")} away`,e.radians>.001?`, turned by ${Jn(e.radians,"angle")}`:""),A("div",{class:"line"},A("button",{type:"button",text:"Go there",on:{click:()=>ys(e.q)}}),A("button",{type:"button",text:"Make it the target",on:{click:()=>Cs(e.T,"taken")}})))}var Zm=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Uf(n){return Zm(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Ff(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:h})=>({a:l,alpha:c,text:h})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Uf(r)??{a:0,alpha:0};Uf(r)&&(r=$s()),o=Zr(Zm(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Uf(o)??{a:0,alpha:0};Uf(o)&&(o=$s()),r=Zr(r,Zm(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var Bv=30,CC=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),Of=null;function Bf(n,t,e,{symbolic:i,text:s},r){let o=`${n}/${t}`,a=Of!==o;Of=r?null:o;let l=O.table.joints.map((h,u)=>u!==n?h:{...h,[t]:e,text:{...h.text,[t]:i?s:void 0}});Object.is(O.table.joints[n][t],e)&&O.table.joints[n].text?.[t]===l[n].text[t]||Dn({...O.table,joints:l},{step:a,what:"cell"})}function Ba(n,t){Of=null;let e=Object.fromEntries(Object.entries(O.table.postures??{}).map(([i,s])=>[i,t(s)]));Dn({...O.table,joints:n,postures:e},{q:t(O.q),what:"rows"})}function zv(n,t,e){let i=O.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function kv(){let n=O.table.joints.length;if(n>=Bv){ti(`At most ${Bv} joints.`,"wrong");return}Ba([...O.table.joints,CC(n)],t=>[...t,0]),document.querySelector(`[data-testid="dh-${n+1}-a"]`)?.focus()}function Jm(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};Ba(e(O.table.joints),e)}var Hv=()=>{Of=null};async function zf(){try{Js(`${O.table.name||"arm"}.toml`,(await ei("save",{})).text,"application/toml")}catch(n){ti(n.message,"wrong")}}async function Gv(n){let t=n.files[0];if(n.value="",!!t){if(t.size>2e5){ti(`${t.name} has ${t.size} bytes; a robot file has at most 200,000.`,"wrong");return}try{let{table:e}=await Zs("open",{name:t.name.slice(-80),text:await t.text()});Dn(e,{q:Bo(e),what:"new"})}catch(e){ti(e.message,"wrong")}}}var jm={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},PC=n=>n.type==="R"?"angle":"length",Vv={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=A("thead"),s=A("tbody"),r=A("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=A("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=A("p",{class:"verdict","data-testid":"arm-kind"}),l=Xn("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],O.table.convention,S=>{S!==O.table.convention&&Dn(Ff(O.table,S),{what:"rows"})},"convention"),c=A("p",{class:"hint order"}),h=A("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>Dn({...O.table,name:h.value||"my-arm"},{what:"name"})}}),u=A("button",{type:"button",text:"Undo",title:"Ctrl+Z",on:{click:Ec}}),f=A("button",{type:"button",text:"Redo",title:"Ctrl+Shift+Z",on:{click:Tc}}),d=A("input",{type:"file",accept:".toml,.urdf,.xml",class:"offscreen","aria-label":"Robot file","data-testid":"robot-file",tabindex:"-1",on:{change:()=>Gv(d)}}),g=To("Base","base",()=>O.table.base,(S,y)=>Dn({...O.table,base:S},{step:y,what:"cell"})),x=To("Tool","tool",()=>O.table.tool,(S,y)=>Dn({...O.table,tool:S},{step:y,what:"cell"}));n.append(A("div",{class:"line spread"},A("span",{class:"line"},h,u,f),A("span",{class:"line"},A("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>Dn(Sg(O.table.convention),{q:[],what:"new"})}}),A("button",{type:"button",text:"Open\u2026",title:"A robot file (.toml) or a URDF",on:{click:()=>d.click()}}),d,A("button",{type:"button",text:"Save",title:"As a robot file",on:{click:zf}}))),A("div",{class:"line spread"},l,Xn("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,S=>{t=S,w()},"dh-part")),c,r,A("div",{class:"line"},A("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:kv}}),A("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians."})),o,a,A("details",{class:"fold","data-testid":"base-tool"},A("summary",{text:"Base and tool"}),g.el,x.el)),n.addEventListener("verdict",S=>{let y=S.detail??IC(n);zt(o,y?`${y.label}: ${y.reason}. The arm stays as it was.`:"")});let p=(S,y,[M,U,I])=>{let D=S.type==="R"&&M==="theta"||S.type==="P"&&M==="d",z=M==="lower"||M==="upper",X=Ai({label:`Joint ${y+1}, ${U}`,kind:I??PC(S),testid:`dh-${y+1}-${M}`,empty:z?null:void 0,check:N=>z?zv(y,M,N):N!==null&&Math.abs(N)>1e6?"larger than a million":null,input:(N,V)=>Bf(y,M,N,V,!1),commit:(N,V)=>Bf(y,M,N,V,!0)});return z&&(X.placeholder="none"),e.push({f:X,i:y,key:M}),A("td",{class:D?"variable":""},D?A("span",{class:"plus"},A("i",{text:"q"}),A("sub",{text:String(y+1)})," +"):null,X)},m=(S,y)=>A("button",{type:"button",class:`type type-${S.type}`,text:S.type,"data-testid":`dh-${y+1}-type`,"aria-label":`Joint ${y+1} is ${S.type==="R"?"revolute":"prismatic"}; press to change`,title:S.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>Ba(O.table.joints.map((M,U)=>U===y?{...M,type:M.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...M.text,lower:void 0,upper:void 0,offset:void 0}}:M),M=>M.map((U,I)=>I===y?0:U))}}),_=(S,y)=>A("td",{class:"tools"},A("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${S+1} up`,disabled:S===0,on:{click:()=>Jm(S,S-1)}}),A("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${S+1} down`,disabled:S===y-1,on:{click:()=>Jm(S,S+1)}}),A("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${S+1}`,on:{click:()=>Ba(O.table.joints.filter((M,U)=>U!==S),M=>M.filter((U,I)=>I!==S))}})),w=()=>{e=[];let{joints:S}=O.table,y=O.table.convention==="modified",M=t==="geometry"?jm.geometry.map(([U,I,D])=>A("th",{scope:"col"},A("i",{text:I}),A("sub",{text:y&&(U==="a"||U==="alpha")?"i\u22121":"i"}),A("span",{class:"unit",text:` ${Ut.symbol(D)}`}))):["name","lower limit","upper limit","zero","sense"].map(U=>A("th",{scope:"col",text:U}));ne(i,A("tr",{},A("th",{scope:"col",text:"i"}),A("th",{scope:"col","aria-label":"type"}),M,A("th",{"aria-label":"row tools"}))),ne(s,S.map((U,I)=>{let D=t==="geometry"?jm.geometry.map(z=>p(U,I,z)):[A("td",{},A("input",{type:"text",class:"name",value:U.name,maxlength:"40","aria-label":`Joint ${I+1}, name`,on:{change:z=>Bf(I,"name",z.target.value||`joint_${I+1}`,{},!0)}})),...jm.joint.map(z=>p(U,I,z)),A("td",{},A("button",{type:"button",class:"type",text:U.sign>0?"+":"\u2212","aria-label":`Joint ${I+1}, sense of the maker: ${U.sign>0?"as the table":"against the table"}`,on:{click:()=>Ba(O.table.joints.map((z,X)=>X===I?{...z,sign:-z.sign}:z),O.q)}}))];return A("tr",{"data-testid":`dh-row-${I+1}`},A("th",{scope:"row",text:String(I+1)}),A("td",{},m(U,I)),D,_(I,S.length))})),S.length||s.append(A("tr",{},A("td",{colspan:"7",class:"hint",text:"No joints yet."}))),b()},b=()=>{for(let{f:S,i:y,key:M}of e){let U=O.table.joints[y];S.put(U[M],U.text?.[M]??null)}l.mark(O.table.convention),zt(c,O.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==h&&(h.value=O.table.name),g.show(),x.show()},C=()=>{u.disabled=!Mg(),f.disabled=!wg()};Pt("table",S=>{zt(o,""),S==="cell"||S==="name"||S==="postures"?b():(Hv(),w())}),Pt("units",w),Pt("notation",()=>{g.show(),x.show()}),Pt("history",C),Pt("plan",()=>{a.dataset.tone=O.plan?.solvable?"good":"wrong",ne(a,A("strong",{text:Lc(O.plan)||(O.plan?.refused?"Refused":"Not solved")})," ",A("span",{text:O.plan?.explain??""}))}),C(),w()}};function IC(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var Wv=null;async function LC(){return Wv??=(await import("./katex-OJEVB6AI.js")).default,Wv}function Xv(n,t){return A("span",{},t.split("$").map((e,i)=>{if(i%2===0)return e;let s=A("span");try{n.render(e,s,{throwOnError:!0,strict:!1,trust:!1})}catch{s.textContent=e}return s}))}function DC(n){let t=O.table.joints.map((e,i)=>A("th",{},A("i",{text:"q"}),A("sub",{text:String(i+1)}),A("span",{class:"unit",text:` ${Ut.symbol(hn(e))}`})));return[A("h3",{text:"The formulas at the present pose"}),A("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},A("thead",{},A("tr",{},A("th",{text:"branch"}),t)),A("tbody",{},n.map((e,i)=>A("tr",{},A("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>A("td",{text:vi(s,hn(O.table.joints[r]))}))))))]}var qv={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o="",a=A("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=A("div",{class:"equations","data-testid":"equations"}),c=Xn("Lengths as",[["symbols","Symbols"],["numbers","Numbers"]],i,x=>{i=x,u()},"equation-numbers"),h=A("div",{class:"scroll"});n.append(A("div",{class:"line spread"},A("span",{class:"line"},Xn("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,x=>{e=x,u()},"which-equations"),c),A("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>Jr(o)}})),a,h,l);async function u(){if(t.hidden||!O.table.joints.length)return;let x=`${e}/${i}/${JSON.stringify(O.table.joints)}${O.table.convention}`;if(s!==x){s=x,zt(a,"Deriving \u2026"),ne(l);try{let[p,m]=await Promise.all([LC(),ei("equations",{which:e,numbers:i},_=>zt(a,_.note??""))]);if(s!==x)return;zt(a,m.note??""),o=m.blocks.map(_=>_.latex?`\\[ ${_.latex} \\]`:_.text).join(`

`),r=[],ne(l,m.blocks.map(_=>f(p,_))),d(),c.hidden=e!=="forward",ne(h),g()}catch(p){if(s!==x)return;s=null,zt(a,p.message)}}}function f(x,p){if(p.heading)return A("h3",{},Xv(x,p.heading));if(p.text)return A("p",{class:"prose"},Xv(x,p.text));let m=A("div",{class:"formula"});try{x.render(p.latex,m,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{m.replaceChildren(A("code",{text:p.latex}))}if(p.entry===void 0)return m;let _=A("output",{class:"value","data-entry":String(p.entry)});return r.push({value:_,entry:p.entry}),A("div",{class:"formula-row"},m,_)}let d=Sr(()=>{if(t.hidden)return;let x=O.frames[O.frames.length-1];for(let{value:p,entry:m}of r)zt(p,`= ${m%4===3?`${Zn(x[m]*Ut.factor("length"),Ut.digits("length"))} ${Ut.length}`:Zn(x[m],4)}`)}),g=Mr(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:x}=await ei("formulas",{T:O.frames.at(-1)});ne(h,x.length&&e==="inverse"?DC(x):null)}catch{ne(h)}},250);Pt("q",g),Pt("units",g),Pt("panel",u),Pt("plan",u),Pt(["q","units"],d)}};var uc=()=>O.frames[O.frames.length-1].slice(),Yv={id:"path",title:"Path",wide:!0,build(n,t){let e=O.path,i=["from","to"].map(p=>{let m=To(p==="from"?"From":"To",`path-${p}`,()=>e[p],b=>{e[p]=b,u(),oe("path")}),_=A("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`take-${p}`,on:{click:()=>{e[p]=uc(),m.show(),u(),oe("path")}}});return{el:A("div",{class:"end"},_,m.el),show:m.show}}),s=A("span",{class:"hint"}),r=Ai({label:"Number of points N",testid:"path-n",check:p=>Number.isInteger(p)&&p>=2&&p<=2e3?null:"a whole number from 2 to 2000",input:p=>{e.n=p}}),o=Ai({label:"Seconds for the whole line",testid:"path-seconds",check:p=>p>0&&p<=3600?null:"more than 0, at most 3600",input:p=>{e.seconds=p}}),a=A("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let p=$e(e.to);e.to=e.from.slice(),[3,7,11].forEach((m,_)=>{e.to[m]=p[_]}),i[1].show(),u()}}}}),l=A("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>f(O.q)}}),c=A("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),h=A("div",{class:"branches","data-testid":"branches"});n.append(...i.map(p=>p.el),A("div",{class:"line"},a,s),A("div",{class:"line"},A("label",{class:"field"},A("span",{class:"field-name",text:"Points N"}),r),A("label",{class:"field"},A("span",{class:"field-name",text:"Seconds"}),o),l,A("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,h);let u=()=>{if(!e.from||!e.to){zt(s,"");return}let p=yg(e.from,e.to);zt(s,`${Jn(As(is($e(e.to),$e(e.from))),"length")} long${p>1e-6?`, turning ${Jn(p,"angle")}`:", orientation kept"}`),Qu(Array.from({length:33},(m,_)=>$e(Bx(e.from,e.to,_/32))))};async function f(p){zt(l,"Planning \u2026"),l.disabled=!0;try{let m=await ei("follow",{T0:e.from,T1:e.to,n:e.n,start:p});O.track=m,d(m,p)}catch(m){c.hidden=!1,c.dataset.tone="wrong",zt(c,m.message)}finally{zt(l,"Plan the line"),l.disabled=!1}}function d(p){if(c.hidden=!1,c.dataset.tone=p.complete?"good":"wrong",zt(c,p.explain),ne(h,p.branches.length?A("h3",{text:"Branches that start at the first pose"}):null,p.branches.map((b,C)=>A("button",{type:"button",class:`branch ${C===p.chosen?"chosen":""}`,"aria-pressed":String(C===p.chosen),"data-testid":`branch-${C+1}`,disabled:!b.q,title:b.cause||"reaches the end",on:{click:async()=>{await ys(b.q,.4),f(b.q)}}},A("span",{class:"branch-name",text:`${C+1}  ${b.label}`}),g(b.s),A("span",{class:"branch-end",text:b.complete?"to the end":b.q?`${b.points} of ${e.n}`:"starts outside the limits"})))),Qu(p.path.map($e)),!p.q.length){Eo(null);return}let m=p.path.length,_=p.q.map((b,C)=>C+1),w=p.q.map((b,C)=>m>1?e.seconds*C/(m-1):0);Eo(Cf({table:O.table,q:p.q,xs:_,xName:"point",xEnd:m,seconds:w,title:`${O.table.name}: straight line, ${p.q.length} of ${m} points`,events:p.events.map(b=>({...b,x:1+b.s*(m-1),short:b.cause}))}))}function g(p){let m=A("span",{class:"bar-fill"});return m.style.setProperty("width",`${100*p}%`),A("span",{class:"bar"},m)}let x=()=>{i.forEach(p=>p.show()),r.put(e.n),o.put(e.seconds),u()};Pt("panel",p=>{p==="path"&&(e.from??=uc(),e.to??=uc(),x())}),Pt("path-loaded",x),Pt("notation",x),Pt("units",u),Pt("table",p=>{p==="postures"||p==="name"||(c.hidden=!0,ne(h),Qu([]),p==="new"&&(e.from=null,e.to=null,t.hidden||(e.from=uc(),e.to=uc(),x())))})}};var NC=40,$v={id:"sequence",title:"Sequence",wide:!0,build(n){let t=O.sequence,e=A("thead"),i=A("tbody"),s=A("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=A("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:c}}),o=A("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let h=t.postures[1];if(h){for(let u of t.postures.slice(2))u.seconds=h.seconds,u.hold=h.hold;l()}}}});n.append(A("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),A("div",{class:"scroll"},A("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),A("div",{class:"line"},A("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(O.q.slice())}}),A("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(O.table.postures??{}).forEach(([h,u])=>a(u.slice(),h))}}),o),A("div",{class:"line"},r),s);function a(h,u){t.postures.length>=NC||(t.postures.push({name:u??`P${t.postures.length}`,q:h,seconds:5,hold:0}),l(),oe("sequence"))}function l(){let h=O.table.joints;t.postures=t.postures.filter(u=>u.q.length===h.length),r.disabled=t.postures.length<2,ne(e,A("tr",{},A("th",{text:""}),h.map((u,f)=>A("th",{},A("i",{text:"q"}),A("sub",{text:String(f+1)}),A("span",{class:"unit",text:` ${Ut.symbol(hn(u))}`}))),A("th",{text:"leg, s"}),A("th",{text:"rest, s"}),A("th",{"aria-label":"row tools"}))),ne(i,t.postures.map((u,f)=>{let d=h.map((x,p)=>{let m=Ai({label:`${u.name}, q${p+1}`,kind:hn(x),testid:`seq-${f}-q${p+1}`,input:_=>{u.q[p]=_,oe("sequence")}});return m.put(u.q[p]),A("td",{},m)}),g=(x,p,m)=>{if(f===0)return A("td");let _=Ai({label:`${p} ${u.name}`,testid:`seq-${f}-${x}`,check:m,input:w=>{u[x]=w,oe("sequence")}});return _.put(u[x]),A("td",{},_)};return A("tr",{"data-testid":`seq-row-${f}`},A("th",{scope:"row"},A("button",{type:"button",class:"quiet",text:u.name,title:"Go there",on:{click:()=>ys(u.q.slice())}})),d,g("seconds","Seconds to",x=>x>0?null:"more than 0"),g("hold","Rest after",x=>x>=0?null:"0 or more"),A("td",{class:"tools"},A("button",{type:"button",class:"icon",text:"\u2191",disabled:f===0,"aria-label":`Move ${u.name} up`,on:{click:()=>{t.postures.splice(f-1,0,...t.postures.splice(f,1)),l()}}}),A("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${u.name}`,on:{click:()=>{t.postures.splice(f,1),l(),oe("sequence")}}})))})),t.postures.length||i.append(A("tr",{},A("td",{class:"hint",colspan:String(h.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function c(){r.disabled=!0,s.hidden=!1;try{let h=t.postures,u=await ei("motion",{postures:h.map(d=>d.q),seconds:h.slice(1).map(d=>d.seconds),holds:h.slice(1).map(d=>d.hold),rate:t.rate}),f=h.map((d,g)=>({x:u.arrivals[g],s:0,text:`${d.name} at ${u.arrivals[g].toFixed(2)} s`,short:d.name,stop:!1}));s.dataset.tone="good",zt(s,`${h.length} postures in ${u.t[u.t.length-1].toFixed(2)} s. ${UC(u.q)}`),Eo(Cf({table:O.table,q:u.q,xs:u.t,xName:"time",seconds:u.t,dq:u.dq,events:f,title:`${O.table.name}: ${h.map(d=>d.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",zt(s,h.message)}finally{r.disabled=t.postures.length<2}}Pt(["table","units","sequence-loaded"],l),l()}};function UC(n){let t=O.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var kf=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new Qt(n)),FC=new Cr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Ri=new io(new Ce,FC);Ri.frustumCulled=!1;Ri.visible=!1;ri.add(Ri);var za=null,fc=null,Ci=0,Xr={lo:0,hi:1};function Zv(n){za=new Float32Array(3*n),fc=new Float32Array(n),Ci=0,Ri.geometry.dispose(),Ri.geometry=new Ce,Ri.geometry.setAttribute("position",new en(za,3)),Ri.geometry.setAttribute("color",new en(new Float32Array(3*n),3)),Ri.geometry.setDrawRange(0,0),Ri.visible=!0,ln()}function Jv(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Ci<fc.length;i+=4,Ci++)za.set(e.subarray(i,i+3),3*Ci),fc[Ci]=e[i+3];OC()}function OC(){let n=fc.slice(0,Ci).sort();Xr.lo=n[Math.floor(Ci*.02)]??0,Xr.hi=n[Math.max(Math.ceil(Ci*.98)-1,0)]??1;let t=new Qt,e=Ri.geometry.attributes.color.array,i=Xr.hi-Xr.lo||1;for(let s=0;s<Ci;s++){let r=Math.min(Math.max((fc[s]-Xr.lo)/i,0),1)*(kf.length-1),o=Math.min(Math.floor(r),kf.length-2);t.lerpColors(kf[o],kf[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Ri.geometry.setDrawRange(0,Ci),Ri.geometry.attributes.position.needsUpdate=!0,Ri.geometry.attributes.color.needsUpdate=!0,ln()}var dc=()=>Ci;function jv(){let n=new Si;for(let i=0;i<Ci;i++)n.expandByPoint(new B(za[3*i],za[3*i+1],za[3*i+2]));let{min:t,max:e}=n;return Ci?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function Kv(){Ci=0,Ri.visible=!1,ln()}var tb=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],Hf=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?Zn(n,4):n.toExponential(2).replace("-","\u2212"),eb={id:"analysis",title:"Analysis",build(n){let t=A("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[l,c,h]of e)t.append(A("div",{title:h},A("dt",{text:c}),i[l]=A("dd",{"data-testid":`fact-${l}`})));let s=A("div",{class:"distances","data-testid":"limit-distances"}),r=[];n.append(t,A("h3",{text:"Distance to the limits"}),s,A("h3",{text:"Reachable points"}),BC());let o=()=>{r=O.table.joints.map((l,c)=>{let h=A("span",{class:"bar-fill"}),u=A("span",{class:"bar-text"});return{el:A("div",{class:"distance"},A("span",{},A("i",{text:"q"}),A("sub",{text:String(c+1)})),A("span",{class:"bar"},h),u),fill:h,text:u}}),ne(s,r.map(l=>l.el)),a()},a=Sr(()=>{if(n.closest(".panel").hidden||!O.table.joints.length)return;let l=Mc(O.table,O.q,O.frames),c=l[0],h=l[l.length-1];zt(i.manipulability,Hf(l.reduce((u,f)=>u*f,1))),zt(i.condition,c>1e-9?Zn(h/c,1):"\u221E"),zt(i.least,Hf(c)),t.dataset.tone=c<.02?"wrong":"good",r.forEach(({el:u,fill:f,text:d},g)=>{let x=O.table.joints[g],p=O.q[g];if(x.lower===null||x.upper===null){f.style.setProperty("width","100%"),zt(d,"no limit");return}let m=Math.min(p-x.lower,x.upper-p),_=Math.max(2*m/(x.upper-x.lower||1),0);f.style.setProperty("width",`${100*_}%`),u.classList.toggle("outside",m<-1e-9),zt(d,m<-1e-9?`${Jn(-m,hn(x))} beyond`:Jn(m,hn(x)))})});Pt("table",o),Pt(["q","units","panel"],a),o()}};function BC(){let n="20000",t="manipulability",e=!1,i=A("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Zs("cancel",{kind:"cloud"}):u()}}),s=A("button",{type:"button",text:"Clear",on:{click:h}}),r=A("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),o=A("p",{class:"hint",role:"status","data-testid":"cloud-note"}),a=A("span"),l=A("span"),c=A("div",{class:"legend-scale",hidden:!0},a,A("span",{class:"scale-bar"}),l);function h(){Kv(),Ju("cloud",[]),c.hidden=!0,zt(o,"")}async function u(){e=!0,zt(i,"Cancel"),r.hidden=!1,r.value=0,c.hidden=!1,Zv(Number(n));try{let f=await ei("cloud",{count:Number(n),colour:t,seed:1},d=>{Jv(d.points),r.value=d.done/d.of,zt(a,Hf(Xr.lo)),zt(l,Hf(Xr.hi)),zt(o,`${d.done.toLocaleString("en")} of ${d.of.toLocaleString("en")} points`)});zt(o,f.stopped?`Cancelled after ${dc().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${tb.find(([d])=>d===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){zt(o,f.message)}e=!1,Ju("cloud",jv()),zr(),zt(i,"Draw the cloud"),r.hidden=!0}return Pt("table",f=>{f!=="postures"&&f!=="name"&&dc()&&h()}),A("div",{},A("div",{class:"line"},fi("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),A("span",{class:"field-name",text:"coloured by"}),fi("Coloured by",tb,t,f=>{t=f},{"data-testid":"cloud-colour"})),A("div",{class:"line"},i,s),r,c,o)}var nb=n=>({id:"share",title:"Share",build(t,e){let i=A("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:h=>h.target.select()}}),s=A("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>c(s)}}),r=A("p",{class:"hint",role:"status","data-testid":"report-note"}),o=A("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:l}});t.append(A("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),A("div",{class:"line share-link"},i,A("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>Jr(await uf())}})),A("h3",{text:"As a file"}),A("div",{class:"line"},A("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>Js(`${O.table.name||"arm"}.workbench.json`,JSON.stringify(cm(),null,1),"application/json")}}),A("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,A("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:zf}})),A("h3",{text:"Report"}),A("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),A("div",{class:"line"},o),r),Pt(["panel","table","q","units","notation"],async()=>{!e.hidden&&O.table.joints.length&&(i.value=await uf())});async function l(){o.disabled=!0;try{let{html:h,name:u}=await ei("report",{q:O.q},f=>zt(r,f.note));Js(u,h,"text/html"),zt(r,`Written: ${u}, ${Math.round(h.length/1024)} kB.`)}catch(h){zt(r,h.message)}finally{o.disabled=!1}}async function c(h){let u=h.files[0];if(h.value="",!!u)try{if(u.size>5e5)throw new Error("A state file has at most 500 kB.");hf(JSON.parse(await u.text()),n()),ti("Opened")}catch(f){ti(f instanceof SyntaxError?`${u.name} is not a state file.`:f.message,"wrong")}}}});function ib(){window.workbench=Object.freeze({get q(){return O.q.slice()},get frames(){return structuredClone(O.frames)},get target(){return O.target.slice()},get table(){return structuredClone(O.table)},get solutions(){return structuredClone(O.solutions)},get camera(){return ku()},get pictures(){return q_()},get ghosts(){return _x()},get answers(){return sm.answers},get trace(){return bx()},get cloud(){return dc()},toScreen:K_,forward:(n,t)=>vr(n,t),convert:(n,t)=>Ff(n,t),read:(n,t)=>Rf(n,t)})}Pc();Y_(br("#view"));Pt("theme",Bp);Bp();px();Px();Pg();Fx();Tv(br("#bar"));Rv(br("#overlay"));Ev(br("#dock"));Cv();var Km;Km=Av(br("#rail"),br("#panels"),br("#pinned"),[{id:"move",title:"Move",sections:[vv,Iv]},Ov,Vv,Lv,qv,Yv,$v,eb,nb(()=>Km)]);Vx();var zC=Gx().then(n=>n&&hf(n,Km)).catch(n=>ti(`The link could not be read: ${n.message}`,"wrong"));Pt("online",async n=>{if(!n)return;await zC;let t=await Eg();O.catalog=t.catalog,oe("catalog"),t.table&&!O.table.joints.length&&(Dn(t.table,{q:Bo(t.table),step:!1,what:"new"}),Ac()),document.documentElement.dataset.ready="yes"});O.online&&oe("online",!0);document.fonts?.ready.then(()=>oe("theme"));ib();
