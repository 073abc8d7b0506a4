import{A as zo,B as Fn,C as Tc,D as Ac,E as Rg,F as Cg,G as Rc,H as Ps,I as Pg,J as Cc,L as Js,M as Pc,a as Zs,b as Jr,c as Mg,d as Xe,e as id,f as sd,g as ss,h as vc,i as bc,j as Rs,k as Sc,l as Mc,m as wg,n as jr,o as Eg,p as Mr,q as rd,r as ko,s as wc,t as Tg,u as Ag,v as yt,w as ie,x as N,y as Cs,z as Ec}from"./chunk-LLBWXIPN.js";function T(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var wr=(n,t=document)=>t.querySelector(n),ee=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function Ot(n,t){n.textContent!==t&&(n.textContent=t)}function bn(n,t,e,i,s){let r=T("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(T("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function di(n,t,e,i,s={}){let r=T("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>T("option",{value:o,text:a})));return r.value=e,r}function Er(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Ic(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function js(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function Ks(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=T("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Kr(n){try{await navigator.clipboard.writeText(n)}catch{let t=T("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}ni("Copied")}var Ig;function ni(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(Ig),Ig=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}var be={},Eb=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel"],Tb={light:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"],dark:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},Lg=matchMedia("(prefers-color-scheme: dark)");function Lc(){let n=N.theme==="dark"||N.theme==="auto"&&Lg.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of Eb)be[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();be.dark=n,be.curves=Tb[n?"dark":"light"]}function Dc(n){N.theme=n,Lc(),ie("theme")}Lg.addEventListener("change",()=>{N.theme==="auto"&&(Lc(),ie("theme"))});var Ho=0,ld=-1,od=[];function Ab(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function ad(){let n=Ho;if(!N.table.joints.length){N.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ie("plan");return}try{let{plan:t}=await Js("arm",{table:Ab(N.table)});if(n!==Ho)return;ld=n,N.plan=t,Dg()}catch(t){if(n!==Ho||t instanceof Cc)return;N.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},Dg(t)}ie("plan")}function Dg(n){let t=od;od=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var Ng=js(ad,60);function Ug(){yt("table",n=>{Ho+=1,n==="postures"&&(ld=-1),n==="cell"?Ng():(Ng.cancel(),ad())}),yt("online",n=>{n&&(Ho+=1,ad())})}function Rb(){return ld===Ho?Promise.resolve():new Promise((n,t)=>od.push({resolve:n,reject:t}))}async function Qn(n,t,e){return await Rb(),Js(n,t,e)}function Fg(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function Nc(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var Ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Fr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},x0=0,Bd=1,y0=2;var Nl=1,v0=2,xa=3,Or=0,bi=1,Ei=2,co=0,ya=1,kd=2,zd=3,Hd=4,b0=5;var ho=100,S0=101,M0=102,w0=103,E0=104,T0=200,A0=201,R0=202,C0=203,Gd=204,Vd=205,P0=206,I0=207,L0=208,D0=209,N0=210,U0=211,F0=212,O0=213,B0=214,uh=0,fh=1,dh=2,aa=3,ph=4,mh=5,gh=6,_h=7,Wd=0,k0=1,z0=2,Os=0,Xd=1,qd=2,Yd=3,$d=4,Zd=5,Jd=6,jd=7;var Kd=300,uo=301,va=302,Vh=303,Wh=304,xh=1e3,Ls=1001,yh=1002,Jn=1003,H0=1004;var Ul=1005;var xi=1006,Xh=1007;var hr=1008;var ki=1009,Qd=1010,tp=1011,ba=1012,qh=1013,fs=1014,Zi=1015,ds=1016,Yh=1017,$h=1018,fo=1020,ep=35902,np=35899,ip=1021,sp=1022,ps=1023,or=1026,ur=1027,Zh=1028,Jh=1029,Br=1030,jh=1031;var Kh=1033,Fl=33776,Ol=33777,Bl=33778,kl=33779,Qh=35840,tu=35841,eu=35842,nu=35843,iu=36196,su=37492,ru=37496,ou=37488,au=37489,zl=37490,lu=37491,cu=37808,hu=37809,uu=37810,fu=37811,du=37812,pu=37813,mu=37814,gu=37815,_u=37816,xu=37817,yu=37818,vu=37819,bu=37820,Su=37821,Mu=36492,wu=36494,Eu=36495,Tu=36283,Au=36284,Hl=36285,Ru=36286;var hl=2300,vh=2301,ch=2302,Pd=2303,Id=2400,Ld=2401,Dd=2402;var G0=3200;var rp=0,V0=1,fr="",mi="srgb",ul="srgb-linear",fl="linear",Fe="srgb";var hh=7680,op=7681;var ap=517;var W0=519,X0=512,q0=513,Y0=514,lp=515,$0=516,Z0=517,cp=518,hp=519,up=35044,Cu=35048;var fp="300 es",Yi=2e3,dl=2001;function Pb(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Ib(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function pl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function J0(){let n=pl("canvas");return n.style.display="block",n}var Og={},la=null;function ml(...n){let t="THREE."+n.shift();la?la("log",t,...n):console.log(t,...n)}function j0(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Kt(...n){n=j0(n);let t="THREE."+n.shift();if(la)la("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function se(...n){n=j0(n);let t="THREE."+n.shift();if(la)la("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function al(...n){let t=n.join(" ");t in Og||(Og[t]=!0,Kt(...n))}function K0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Q0={[uh]:uh,[dh]:gh,[ph]:ph,[aa]:mh,[fh]:fh,[gh]:dh,[_h]:_h,[mh]:aa},cs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ii=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Bg=1234567,ll=Math.PI/180,ca=180/Math.PI;function kr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ii[n&255]+ii[n>>8&255]+ii[n>>16&255]+ii[n>>24&255]+"-"+ii[t&255]+ii[t>>8&255]+"-"+ii[t>>16&15|64]+ii[t>>24&255]+"-"+ii[e&63|128]+ii[e>>8&255]+"-"+ii[e>>16&255]+ii[e>>24&255]+ii[i&255]+ii[i>>8&255]+ii[i>>16&255]+ii[i>>24&255]).toLowerCase()}function xe(n,t,e){return Math.max(t,Math.min(e,n))}function dp(n,t){return(n%t+t)%t}function Lb(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Db(n,t,e){return n!==t?(e-n)/(t-n):0}function cl(n,t,e){return(1-e)*n+e*t}function Nb(n,t,e,i){return cl(n,t,1-Math.exp(-e*i))}function Ub(n,t=1){return t-Math.abs(dp(n,t*2)-t)}function Fb(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Ob(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Bb(n,t){return n+Math.floor(Math.random()*(t-n+1))}function kb(n,t){return n+Math.random()*(t-n)}function zb(n){return n*(.5-Math.random())}function Hb(n){n!==void 0&&(Bg=n);let t=Bg+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Gb(n){return n*ll}function Vb(n){return n*ca}function Wb(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Xb(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function pp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function qb(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),f=r((t-i)/2),u=o((t-i)/2),d=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*f,l*u,a*c);break;case"YZY":n.set(l*u,a*h,l*f,a*c);break;case"ZXZ":n.set(l*f,l*u,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*d,a*c);break;case"YXY":n.set(l*d,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*d,a*h,a*c);break;default:Kt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function mp(n,t){if(t.constructor===Float32Array)return n;let e=Pu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function gp(n,t){if(t.constructor===Float32Array)return n;let e=Pu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Sa={DEG2RAD:ll,RAD2DEG:ca,generateUUID:kr,clamp:xe,euclideanModulo:dp,mapLinear:Lb,inverseLerp:Db,lerp:cl,damp:Nb,pingpong:Ub,smoothstep:Fb,smootherstep:Ob,randInt:Bb,randFloat:kb,randFloatSpread:zb,seededRandom:Hb,degToRad:Gb,radToDeg:Vb,isPowerOfTwo:Wb,ceilPowerOfTwo:Xb,floorPowerOfTwo:pp,setQuaternionFromProperEuler:qb,normalize:gp,denormalize:mp},qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Je=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],f=i[s+3],u=r[o+0],d=r[o+1],g=r[o+2],_=r[o+3];if(f!==_||l!==u||c!==d||h!==g){let m=l*u+c*d+h*g+f*_;m<0&&(u=-u,d=-d,g=-g,_=-_,m=-m);let p=1-a;if(m<.9995){let y=Math.acos(m),w=Math.sin(y);p=Math.sin(p*y)/w,a=Math.sin(a*y)/w,l=l*p+u*a,c=c*p+d*a,h=h*p+g*a,f=f*p+_*a}else{l=l*p+u*a,c=c*p+d*a,h=h*p+g*a,f=f*p+_*a;let y=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=y,c*=y,h*=y,f*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],f=r[o],u=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+h*f+l*d-c*u,t[e+1]=l*g+h*u+c*f-a*d,t[e+2]=c*g+h*d+a*u-l*f,t[e+3]=h*g-a*f-l*u-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),f=a(r/2),u=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"YXZ":this._x=u*h*f+c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"ZXY":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f-u*d*g;break;case"ZYX":this._x=u*h*f-c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f+u*d*g;break;case"YZX":this._x=u*h*f+c*d*g,this._y=c*d*f+u*h*g,this._z=c*h*g-u*d*f,this._w=c*h*f-u*d*g;break;case"XZY":this._x=u*h*f-c*d*g,this._y=c*d*f-u*h*g,this._z=c*h*g+u*d*f,this._w=c*h*f+u*d*g;break;default:Kt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],f=e[10],u=i+a+f;if(u>0){let d=.5/Math.sqrt(u+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(kg.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(kg.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),f=2*(r*i-o*e);return this.x=e+l*c+o*f-a*h,this.y=i+l*h+a*c-r*f,this.z=s+l*f+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return cd.copy(this).projectOnVector(t),this.sub(cd)}reflect(t){return this.sub(cd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},cd=new B,kg=new Je,le=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],f=i[7],u=i[2],d=i[5],g=i[8],_=s[0],m=s[3],p=s[6],y=s[1],w=s[4],v=s[7],C=s[2],S=s[5],x=s[8];return r[0]=o*_+a*y+l*C,r[3]=o*m+a*w+l*S,r[6]=o*p+a*v+l*x,r[1]=c*_+h*y+f*C,r[4]=c*m+h*w+f*S,r[7]=c*p+h*v+f*x,r[2]=u*_+d*y+g*C,r[5]=u*m+d*w+g*S,r[8]=u*p+d*v+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],f=h*o-a*c,u=a*l-h*r,d=c*r-o*l,g=e*f+i*u+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return t[0]=f*_,t[1]=(s*c-h*i)*_,t[2]=(a*i-s*o)*_,t[3]=u*_,t[4]=(h*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=d*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return al("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hd.makeScale(t,e)),this}rotate(t){return al("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hd.makeRotation(-t)),this}translate(t,e){return al("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},hd=new le,zg=new le().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Hg=new le().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Yb(){let n={enabled:!0,workingColorSpace:ul,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Fe&&(s.r=rr(s.r),s.g=rr(s.g),s.b=rr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Fe&&(s.r=oa(s.r),s.g=oa(s.g),s.b=oa(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===fr?fl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ul]:{primaries:t,whitePoint:i,transfer:fl,toXYZ:zg,fromXYZ:Hg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:mi},outputColorSpaceConfig:{drawingBufferColorSpace:mi}},[mi]:{primaries:t,whitePoint:i,transfer:Fe,toXYZ:zg,fromXYZ:Hg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:mi}}}),n}var Ee=Yb();function rr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function oa(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Go,bh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Go===void 0&&(Go=pl("canvas")),Go.width=t.width,Go.height=t.height;let s=Go.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Go}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=pl("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=rr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(rr(e[i]/255)*255):e[i]=rr(e[i]);return{data:e,width:t.width,height:t.height}}else return Kt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},$b=0,ha=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:$b++}),this.uuid=kr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ud(s[o].image)):r.push(ud(s[o]))}else r=ud(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ud(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?bh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Kt("Texture: Unable to serialize Texture."),{})}var Zb=0,fd=new B,yi=class n extends cs{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ls,s=Ls,r=xi,o=hr,a=ps,l=ki,c=n.DEFAULT_ANISOTROPY,h=fr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Zb++}),this.uuid=kr(),this.name="",this.source=new ha(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new qt(0,0),this.repeat=new qt(1,1),this.center=new qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new le,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fd).x}get height(){return this.source.getSize(fd).y}get depth(){return this.source.getSize(fd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Kt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Kd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case xh:t.x=t.x-Math.floor(t.x);break;case Ls:t.x=t.x<0?0:1;break;case yh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case xh:t.y=t.y-Math.floor(t.y);break;case Ls:t.y=t.y<0?0:1;break;case yh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};yi.DEFAULT_IMAGE=null;yi.DEFAULT_MAPPING=Kd;yi.DEFAULT_ANISOTROPY=1;var dn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],f=l[8],u=l[1],d=l[5],g=l[9],_=l[2],m=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(f-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,v=(d+1)/2,C=(p+1)/2,S=(h+u)/4,x=(f+_)/4,M=(g+m)/4;return w>v&&w>C?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=S/i,r=x/i):v>C?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=S/s,r=M/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=M/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(f-_)*(f-_)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(f-_)/y,this.z=(u-h)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Sh=class extends cs{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new dn(0,0,t,e),this.scissorTest=!1,this.viewport=new dn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new yi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:xi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ha(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Oi=class extends Sh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},gl=class extends yi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Jn,this.minFilter=Jn,this.wrapR=Ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Mh=class extends yi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Jn,this.minFilter=Jn,this.wrapR=Ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Me=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,f,u,d,g,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,f,u,d,g,_,m)}set(t,e,i,s,r,o,a,l,c,h,f,u,d,g,_,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=f,p[14]=u,p[3]=d,p[7]=g,p[11]=_,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Vo.setFromMatrixColumn(t,0).length(),r=1/Vo.setFromMatrixColumn(t,1).length(),o=1/Vo.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let u=o*h,d=o*f,g=a*h,_=a*f;e[0]=l*h,e[4]=-l*f,e[8]=c,e[1]=d+g*c,e[5]=u-_*c,e[9]=-a*l,e[2]=_-u*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,d=l*f,g=c*h,_=c*f;e[0]=u+_*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*f,e[5]=o*h,e[9]=-a,e[2]=d*a-g,e[6]=_+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,d=l*f,g=c*h,_=c*f;e[0]=u-_*a,e[4]=-o*f,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*h,e[9]=_-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,d=o*f,g=a*h,_=a*f;e[0]=l*h,e[4]=g*c-d,e[8]=u*c+_,e[1]=l*f,e[5]=_*c+u,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,d=o*c,g=a*l,_=a*c;e[0]=l*h,e[4]=_-u*f,e[8]=g*f+d,e[1]=f,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*f+g,e[10]=u-_*f}else if(t.order==="XZY"){let u=o*l,d=o*c,g=a*l,_=a*c;e[0]=l*h,e[4]=-f,e[8]=c*h,e[1]=u*f+_,e[5]=o*h,e[9]=d*f-g,e[2]=g*f-d,e[6]=a*h,e[10]=_*f+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Jb,t,jb)}lookAt(t,e,i){let s=this.elements;return Ui.subVectors(t,e),Ui.lengthSq()===0&&(Ui.z=1),Ui.normalize(),Tr.crossVectors(i,Ui),Tr.lengthSq()===0&&(Math.abs(i.z)===1?Ui.x+=1e-4:Ui.z+=1e-4,Ui.normalize(),Tr.crossVectors(i,Ui)),Tr.normalize(),Uc.crossVectors(Ui,Tr),s[0]=Tr.x,s[4]=Uc.x,s[8]=Ui.x,s[1]=Tr.y,s[5]=Uc.y,s[9]=Ui.y,s[2]=Tr.z,s[6]=Uc.z,s[10]=Ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],f=i[5],u=i[9],d=i[13],g=i[2],_=i[6],m=i[10],p=i[14],y=i[3],w=i[7],v=i[11],C=i[15],S=s[0],x=s[4],M=s[8],F=s[12],I=s[1],D=s[5],k=s[9],X=s[13],U=s[2],V=s[6],Z=s[10],W=s[14],ct=s[3],$=s[7],tt=s[11],st=s[15];return r[0]=o*S+a*I+l*U+c*ct,r[4]=o*x+a*D+l*V+c*$,r[8]=o*M+a*k+l*Z+c*tt,r[12]=o*F+a*X+l*W+c*st,r[1]=h*S+f*I+u*U+d*ct,r[5]=h*x+f*D+u*V+d*$,r[9]=h*M+f*k+u*Z+d*tt,r[13]=h*F+f*X+u*W+d*st,r[2]=g*S+_*I+m*U+p*ct,r[6]=g*x+_*D+m*V+p*$,r[10]=g*M+_*k+m*Z+p*tt,r[14]=g*F+_*X+m*W+p*st,r[3]=y*S+w*I+v*U+C*ct,r[7]=y*x+w*D+v*V+C*$,r[11]=y*M+w*k+v*Z+C*tt,r[15]=y*F+w*X+v*W+C*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],f=t[6],u=t[10],d=t[14],g=t[3],_=t[7],m=t[11],p=t[15],y=l*d-c*u,w=a*d-c*f,v=a*u-l*f,C=o*d-c*h,S=o*u-l*h,x=o*f-a*h;return e*(_*y-m*w+p*v)-i*(g*y-m*C+p*S)+s*(g*w-_*C+p*x)-r*(g*v-_*S+m*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],f=t[9],u=t[10],d=t[11],g=t[12],_=t[13],m=t[14],p=t[15],y=e*a-i*o,w=e*l-s*o,v=e*c-r*o,C=i*l-s*a,S=i*c-r*a,x=s*c-r*l,M=h*_-f*g,F=h*m-u*g,I=h*p-d*g,D=f*m-u*_,k=f*p-d*_,X=u*p-d*m,U=y*X-w*k+v*D+C*I-S*F+x*M;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/U;return t[0]=(a*X-l*k+c*D)*V,t[1]=(s*k-i*X-r*D)*V,t[2]=(_*x-m*S+p*C)*V,t[3]=(u*S-f*x-d*C)*V,t[4]=(l*I-o*X-c*F)*V,t[5]=(e*X-s*I+r*F)*V,t[6]=(m*v-g*x-p*w)*V,t[7]=(h*x-u*v+d*w)*V,t[8]=(o*k-a*I+c*M)*V,t[9]=(i*I-e*k-r*M)*V,t[10]=(g*S-_*v+p*y)*V,t[11]=(f*v-h*S-d*y)*V,t[12]=(a*F-o*D-l*M)*V,t[13]=(e*D-i*F+s*M)*V,t[14]=(_*w-g*C-m*y)*V,t[15]=(h*C-f*w+u*y)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,f=a+a,u=r*c,d=r*h,g=r*f,_=o*h,m=o*f,p=a*f,y=l*c,w=l*h,v=l*f,C=i.x,S=i.y,x=i.z;return s[0]=(1-(_+p))*C,s[1]=(d+v)*C,s[2]=(g-w)*C,s[3]=0,s[4]=(d-v)*S,s[5]=(1-(u+p))*S,s[6]=(m+y)*S,s[7]=0,s[8]=(g+w)*x,s[9]=(m-y)*x,s[10]=(1-(u+_))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Vo.set(s[0],s[1],s[2]).length(),a=Vo.set(s[4],s[5],s[6]).length(),l=Vo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),rs.copy(this);let c=1/o,h=1/a,f=1/l;return rs.elements[0]*=c,rs.elements[1]*=c,rs.elements[2]*=c,rs.elements[4]*=h,rs.elements[5]*=h,rs.elements[6]*=h,rs.elements[8]*=f,rs.elements[9]*=f,rs.elements[10]*=f,e.setFromRotationMatrix(rs),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Yi,l=!1){let c=this.elements,h=2*r/(e-t),f=2*r/(i-s),u=(e+t)/(e-t),d=(i+s)/(i-s),g,_;if(l)g=r/(o-r),_=o*r/(o-r);else if(a===Yi)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===dl)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Yi,l=!1){let c=this.elements,h=2/(e-t),f=2/(i-s),u=-(e+t)/(e-t),d=-(i+s)/(i-s),g,_;if(l)g=1/(o-r),_=o/(o-r);else if(a===Yi)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===dl)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Vo=new B,rs=new Me,Jb=new B(0,0,0),jb=new B(1,1,1),Tr=new B,Uc=new B,Ui=new B,Gg=new Me,Vg=new Je,Ds=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],f=s[2],u=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Kt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Gg.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Gg,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Vg.setFromEuler(this),this.setFromQuaternion(Vg,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ds.DEFAULT_ORDER="XYZ";var ua=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Kb=0,Wg=new B,Wo=new Je,Qs=new Me,Fc=new B,ja=new B,Qb=new B,tS=new Je,Xg=new B(1,0,0),qg=new B(0,1,0),Yg=new B(0,0,1),$g={type:"added"},eS={type:"removed"},Xo={type:"childadded",child:null},dd={type:"childremoved",child:null},En=class n extends cs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Kb++}),this.uuid=kr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new B,e=new Ds,i=new Je,s=new B(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Me},normalMatrix:{value:new le}}),this.matrix=new Me,this.matrixWorld=new Me,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ua,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Wo.setFromAxisAngle(t,e),this.quaternion.multiply(Wo),this}rotateOnWorldAxis(t,e){return Wo.setFromAxisAngle(t,e),this.quaternion.premultiply(Wo),this}rotateX(t){return this.rotateOnAxis(Xg,t)}rotateY(t){return this.rotateOnAxis(qg,t)}rotateZ(t){return this.rotateOnAxis(Yg,t)}translateOnAxis(t,e){return Wg.copy(t).applyQuaternion(this.quaternion),this.position.add(Wg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Xg,t)}translateY(t){return this.translateOnAxis(qg,t)}translateZ(t){return this.translateOnAxis(Yg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Qs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Fc.copy(t):Fc.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ja.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Qs.lookAt(ja,Fc,this.up):Qs.lookAt(Fc,ja,this.up),this.quaternion.setFromRotationMatrix(Qs),s&&(Qs.extractRotation(s.matrixWorld),Wo.setFromRotationMatrix(Qs),this.quaternion.premultiply(Wo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent($g),Xo.child=t,this.dispatchEvent(Xo),Xo.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(eS),dd.child=t,this.dispatchEvent(dd),dd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Qs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Qs.multiply(t.parent.matrixWorld)),t.applyMatrix4(Qs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent($g),Xo.child=t,this.dispatchEvent(Xo),Xo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ja,t,Qb),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ja,tS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let f=l[c];r(t.shapes,f)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),f=o(t.shapes),u=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),u.length>0&&(i.skeletons=u),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};En.DEFAULT_UP=new B(0,1,0);En.DEFAULT_MATRIX_AUTO_UPDATE=!0;En.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ls=class extends En{constructor(){super(),this.isGroup=!0,this.type="Group"}},nS={type:"move"},fa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ls,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ls,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ls,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),p=this._getHandJoint(c,_);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],u=h.position.distanceTo(f.position),d=.02,g=.005;c.inputState.pinching&&u>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(nS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new ls;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},t_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ar={h:0,s:0,l:0},Oc={h:0,s:0,l:0};function pd(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Qt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=mi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ee.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ee.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ee.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ee.workingColorSpace){if(t=dp(t,1),e=xe(e,0,1),i=xe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=pd(o,r,t+1/3),this.g=pd(o,r,t),this.b=pd(o,r,t-1/3)}return Ee.colorSpaceToWorking(this,s),this}setStyle(t,e=mi){function i(r){r!==void 0&&parseFloat(r)<1&&Kt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Kt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Kt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=mi){let i=t_[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Kt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=rr(t.r),this.g=rr(t.g),this.b=rr(t.b),this}copyLinearToSRGB(t){return this.r=oa(t.r),this.g=oa(t.g),this.b=oa(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=mi){return Ee.workingToColorSpace(si.copy(this),t),Math.round(xe(si.r*255,0,255))*65536+Math.round(xe(si.g*255,0,255))*256+Math.round(xe(si.b*255,0,255))}getHexString(t=mi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ee.workingColorSpace){Ee.workingToColorSpace(si.copy(this),e);let i=si.r,s=si.g,r=si.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=h<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Ee.workingColorSpace){return Ee.workingToColorSpace(si.copy(this),e),t.r=si.r,t.g=si.g,t.b=si.b,t}getStyle(t=mi){Ee.workingToColorSpace(si.copy(this),t);let e=si.r,i=si.g,s=si.b;return t!==mi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ar),this.setHSL(Ar.h+t,Ar.s+e,Ar.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ar),t.getHSL(Oc);let i=cl(Ar.h,Oc.h,e),s=cl(Ar.s,Oc.s,e),r=cl(Ar.l,Oc.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},si=new Qt;Qt.NAMES=t_;var _l=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new Qt(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},xl=class extends En{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ds,this.environmentIntensity=1,this.environmentRotation=new Ds,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},os=new B,tr=new B,md=new B,er=new B,qo=new B,Yo=new B,Zg=new B,gd=new B,_d=new B,xd=new B,yd=new dn,vd=new dn,bd=new dn,sr=class n{constructor(t=new B,e=new B,i=new B){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),os.subVectors(t,e),s.cross(os);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){os.subVectors(s,e),tr.subVectors(i,e),md.subVectors(t,e);let o=os.dot(os),a=os.dot(tr),l=os.dot(md),c=tr.dot(tr),h=tr.dot(md),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let u=1/f,d=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,er)===null?!1:er.x>=0&&er.y>=0&&er.x+er.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,er)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,er.x),l.addScaledVector(o,er.y),l.addScaledVector(a,er.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return yd.setScalar(0),vd.setScalar(0),bd.setScalar(0),yd.fromBufferAttribute(t,e),vd.fromBufferAttribute(t,i),bd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(yd,r.x),o.addScaledVector(vd,r.y),o.addScaledVector(bd,r.z),o}static isFrontFacing(t,e,i,s){return os.subVectors(i,e),tr.subVectors(t,e),os.cross(tr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return os.subVectors(this.c,this.b),tr.subVectors(this.a,this.b),os.cross(tr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;qo.subVectors(s,i),Yo.subVectors(r,i),gd.subVectors(t,i);let l=qo.dot(gd),c=Yo.dot(gd);if(l<=0&&c<=0)return e.copy(i);_d.subVectors(t,s);let h=qo.dot(_d),f=Yo.dot(_d);if(h>=0&&f<=h)return e.copy(s);let u=l*f-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(qo,o);xd.subVectors(t,r);let d=qo.dot(xd),g=Yo.dot(xd);if(g>=0&&d<=g)return e.copy(r);let _=d*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(Yo,a);let m=h*g-d*f;if(m<=0&&f-h>=0&&d-g>=0)return Zg.subVectors(r,s),a=(f-h)/(f-h+(d-g)),e.copy(s).addScaledVector(Zg,a);let p=1/(m+_+u);return o=_*p,a=u*p,e.copy(i).addScaledVector(qo,o).addScaledVector(Yo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},wi=class{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(as.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(as.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=as.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,as):as.fromBufferAttribute(r,o),as.applyMatrix4(t.matrixWorld),this.expandByPoint(as);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Bc.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Bc.copy(i.boundingBox)),Bc.applyMatrix4(t.matrixWorld),this.union(Bc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,as),as.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ka),kc.subVectors(this.max,Ka),$o.subVectors(t.a,Ka),Zo.subVectors(t.b,Ka),Jo.subVectors(t.c,Ka),Rr.subVectors(Zo,$o),Cr.subVectors(Jo,Zo),Qr.subVectors($o,Jo);let e=[0,-Rr.z,Rr.y,0,-Cr.z,Cr.y,0,-Qr.z,Qr.y,Rr.z,0,-Rr.x,Cr.z,0,-Cr.x,Qr.z,0,-Qr.x,-Rr.y,Rr.x,0,-Cr.y,Cr.x,0,-Qr.y,Qr.x,0];return!Sd(e,$o,Zo,Jo,kc)||(e=[1,0,0,0,1,0,0,0,1],!Sd(e,$o,Zo,Jo,kc))?!1:(zc.crossVectors(Rr,Cr),e=[zc.x,zc.y,zc.z],Sd(e,$o,Zo,Jo,kc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,as).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(as).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(nr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),nr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),nr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),nr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),nr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),nr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),nr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),nr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(nr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},nr=[new B,new B,new B,new B,new B,new B,new B,new B],as=new B,Bc=new wi,$o=new B,Zo=new B,Jo=new B,Rr=new B,Cr=new B,Qr=new B,Ka=new B,kc=new B,zc=new B,to=new B;function Sd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){to.fromArray(n,r);let a=s.x*Math.abs(to.x)+s.y*Math.abs(to.y)+s.z*Math.abs(to.z),l=t.dot(to),c=e.dot(to),h=i.dot(to);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Ln=new B,Hc=new qt,iS=0,sn=class extends cs{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:iS++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=up,this.updateRanges=[],this.gpuType=Zi,this.version=0,this._normalizationScale=t!==void 0?Pu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Hc.fromBufferAttribute(this,e),Hc.applyMatrix3(t),this.setXY(e,Hc.x,Hc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.applyMatrix3(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.applyMatrix4(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.applyNormalMatrix(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.transformDirection(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):mp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):gp(t,this.array)}};var yl=class extends sn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var vl=class extends sn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Te=class extends sn{constructor(t,e,i){super(new Float32Array(t),e,i)}},sS=new wi,Qa=new B,Md=new B,Ns=class{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):sS.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qa.subVectors(t,this.center);let e=Qa.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Qa,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Md.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qa.copy(t.center).add(Md)),this.expandByPoint(Qa.copy(t.center).sub(Md))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},rS=0,qi=new Me,wd=new En,jo=new B,Fi=new wi,tl=new wi,Zn=new B,Ce=class n extends cs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:rS++}),this.uuid=kr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Pb(t)?vl:yl)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new le().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return qi.makeRotationFromQuaternion(t),this.applyMatrix4(qi),this}rotateX(t){return qi.makeRotationX(t),this.applyMatrix4(qi),this}rotateY(t){return qi.makeRotationY(t),this.applyMatrix4(qi),this}rotateZ(t){return qi.makeRotationZ(t),this.applyMatrix4(qi),this}translate(t,e,i){return qi.makeTranslation(t,e,i),this.applyMatrix4(qi),this}scale(t,e,i){return qi.makeScale(t,e,i),this.applyMatrix4(qi),this}lookAt(t){return wd.lookAt(t),wd.updateMatrix(),this.applyMatrix4(wd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jo).negate(),this.translate(jo.x,jo.y,jo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Te(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Kt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new wi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Zn.addVectors(this.boundingBox.min,Fi.min),this.boundingBox.expandByPoint(Zn),Zn.addVectors(this.boundingBox.max,Fi.max),this.boundingBox.expandByPoint(Zn)):(this.boundingBox.expandByPoint(Fi.min),this.boundingBox.expandByPoint(Fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ns);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){let i=this.boundingSphere.center;if(Fi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];tl.setFromBufferAttribute(a),this.morphTargetsRelative?(Zn.addVectors(Fi.min,tl.min),Fi.expandByPoint(Zn),Zn.addVectors(Fi.max,tl.max),Fi.expandByPoint(Zn)):(Fi.expandByPoint(tl.min),Fi.expandByPoint(tl.max))}Fi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Zn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Zn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Zn.fromBufferAttribute(a,c),l&&(jo.fromBufferAttribute(t,c),Zn.add(jo)),s=Math.max(s,i.distanceToSquared(Zn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new sn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new B,l[F]=new B;let h=new B,f=new B,u=new B,d=new qt,g=new qt,_=new qt,m=new B,p=new B;function y(F,I,D){c[F]=c[I]=c[D]=1,h.fromBufferAttribute(i,F),f.fromBufferAttribute(i,I),u.fromBufferAttribute(i,D),d.fromBufferAttribute(r,F),g.fromBufferAttribute(r,I),_.fromBufferAttribute(r,D),f.sub(h),u.sub(h),g.sub(d),_.sub(d);let k=1/(g.x*_.y-_.x*g.y);isFinite(k)&&(m.copy(f).multiplyScalar(_.y).addScaledVector(u,-g.y).multiplyScalar(k),p.copy(u).multiplyScalar(g.x).addScaledVector(f,-_.x).multiplyScalar(k),a[F].add(m),a[I].add(m),a[D].add(m),l[F].add(p),l[I].add(p),l[D].add(p))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let F=0,I=w.length;F<I;++F){let D=w[F],k=D.start,X=D.count;for(let U=k,V=k+X;U<V;U+=3)y(t.getX(U+0),t.getX(U+1),t.getX(U+2))}let v=new B,C=new B,S=new B,x=new B;function M(F){S.fromBufferAttribute(s,F),x.copy(S);let I=a[F];v.copy(I),v.sub(S.multiplyScalar(S.dot(I))).normalize(),C.crossVectors(x,I);let k=C.dot(l[F])<0?-1:1;o.setXYZW(F,v.x,v.y,v.z,k)}for(let F=0,I=i.count;F<I;++F)c[F]&&M(F);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new sn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,d=i.count;u<d;u++)i.setXYZ(u,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,h=new B,f=new B;if(t)for(let u=0,d=t.count;u<d;u+=3){let g=t.getX(u+0),_=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,d=e.count;u<d;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Zn.fromBufferAttribute(t,e),Zn.normalize(),t.setXYZ(e,Zn.x,Zn.y,Zn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,f=a.normalized,u=new c.constructor(l.length*h),d=0,g=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*h;for(let p=0;p<h;p++)u[g++]=c[d++]}return new sn(u,h,f)}if(this.index===null)return Kt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,f=c.length;h<f;h++){let u=c[h],d=t(u,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let f=0,u=c.length;f<u;f++){let d=c[f];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],f=r[c];for(let u=0,d=f.length;u<d;u++)h.push(f[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},bl=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=up,this.updateRanges=[],this.version=0,this.uuid=kr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Jg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Jg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Jg(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=kr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var pi=new B,da=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Pu(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)pi.fromBufferAttribute(this,e),pi.applyMatrix4(t),this.setXYZ(e,pi.x,pi.y,pi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)pi.fromBufferAttribute(this,e),pi.applyNormalMatrix(t),this.setXYZ(e,pi.x,pi.y,pi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)pi.fromBufferAttribute(this,e),pi.transformDirection(t),this.setXYZ(e,pi.x,pi.y,pi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){ml("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new sn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){ml("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):mp(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):gp(t,this.data.array)}},Ed=new B,oS=new B,aS=new le,gi=class{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Ed.subVectors(i,e).cross(oS.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Ed),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||aS.getNormalMatrix(t),s=this.coplanarPoint(Ed).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},lS=0,Us=class extends cs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:lS++}),this.uuid=kr(),this.name="",this.type="Material",this.blending=ya,this.side=Or,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Gd,this.blendDst=Vd,this.blendEquation=ho,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qt(0,0,0),this.blendAlpha=0,this.depthFunc=aa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=W0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hh,this.stencilZFail=hh,this.stencilZPass=hh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Kt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new gi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},pa=class extends Us{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Qt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ko,el=new B,Qo=new B,ta=new B,ea=new qt,nl=new qt,e_=new Me,Gc=new B,il=new B,Vc=new B,jg=new qt,Td=new qt,Kg=new qt,Sl=class extends En{constructor(t=new pa){if(super(),this.isSprite=!0,this.type="Sprite",Ko===void 0){Ko=new Ce;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new bl(e,5);Ko.setIndex([0,1,2,0,2,3]),Ko.setAttribute("position",new da(i,3,0,!1)),Ko.setAttribute("uv",new da(i,2,3,!1))}this.geometry=Ko,this.material=t,this.center=new qt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&se('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Qo.setFromMatrixScale(this.matrixWorld),e_.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),ta.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Qo.multiplyScalar(-ta.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Wc(Gc.set(-.5,-.5,0),ta,o,Qo,s,r),Wc(il.set(.5,-.5,0),ta,o,Qo,s,r),Wc(Vc.set(.5,.5,0),ta,o,Qo,s,r),jg.set(0,0),Td.set(1,0),Kg.set(1,1);let a=t.ray.intersectTriangle(Gc,il,Vc,!1,el);if(a===null&&(Wc(il.set(-.5,.5,0),ta,o,Qo,s,r),Td.set(0,1),a=t.ray.intersectTriangle(Gc,Vc,il,!1,el),a===null))return;let l=t.ray.origin.distanceTo(el);l<t.near||l>t.far||e.push({distance:l,point:el.clone(),uv:sr.getInterpolation(el,Gc,il,Vc,jg,Td,Kg,new qt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Wc(n,t,e,i,s,r){ea.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(nl.x=r*ea.x-s*ea.y,nl.y=s*ea.x+r*ea.y):nl.copy(ea),n.copy(t),n.x+=nl.x,n.y+=nl.y,n.applyMatrix4(e_)}var ir=new B,Ad=new B,Xc=new B,qc=new B,ar=class{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ir)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ir.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ir.copy(this.origin).addScaledVector(this.direction,e),ir.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Ad.copy(t).add(e).multiplyScalar(.5),Xc.copy(e).sub(t).normalize(),qc.copy(this.origin).sub(Ad);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Xc),a=qc.dot(this.direction),l=-qc.dot(Xc),c=qc.lengthSq(),h=Math.abs(1-o*o),f,u,d,g;if(h>0)if(f=o*l-a,u=o*a-l,g=r*h,f>=0)if(u>=-g)if(u<=g){let _=1/h;f*=_,u*=_,d=f*(f+o*u+2*a)+u*(o*f+u+2*l)+c}else u=r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u=-r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;else u<=-g?(f=Math.max(0,-(-o*r+a)),u=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+u*(u+2*l)+c):u<=g?(f=0,u=Math.min(Math.max(-r,-l),r),d=u*(u+2*l)+c):(f=Math.max(0,-(o*r+a)),u=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+u*(u+2*l)+c);else u=o>0?-r:r,f=Math.max(0,-(o*u+a)),d=-f*f+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ad).addScaledVector(Xc,u),d}intersectSphere(t,e){if(t.radius<0)return null;ir.subVectors(t.center,this.origin);let i=ir.dot(this.direction),s=ir.dot(ir)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return c>=0?(i=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(i=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(t.min.z-u.z)*f,l=(t.max.z-u.z)*f):(a=(t.max.z-u.z)*f,l=(t.min.z-u.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,ir)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,f=t.x-o.x,u=t.y-o.y,d=t.z-o.z,g=e.x-o.x,_=e.y-o.y,m=e.z-o.z,p=i.x-o.x,y=i.y-o.y,w=i.z-o.z,v=Math.abs(l),C=Math.abs(c),S=Math.abs(h),x,M,F,I,D,k,X,U,V,Z,W,ct;if(v>=C&&v>=S?(F=l,k=f,V=g,ct=p,l>=0?(x=c,M=h,I=u,D=d,X=_,U=m,Z=y,W=w):(x=h,M=c,I=d,D=u,X=m,U=_,Z=w,W=y)):C>=S?(F=c,k=u,V=_,ct=y,c>=0?(x=h,M=l,I=d,D=f,X=m,U=g,Z=w,W=p):(x=l,M=h,I=f,D=d,X=g,U=m,Z=p,W=w)):(F=h,k=d,V=m,ct=w,h>=0?(x=l,M=c,I=f,D=u,X=g,U=_,Z=p,W=y):(x=c,M=l,I=u,D=f,X=_,U=g,Z=y,W=p)),F===0)return null;let $=x/F,tt=M/F,st=1/F,ft=I-$*k,dt=D-tt*k,et=X-$*V,gt=U-tt*V,vt=Z-$*ct,Pt=W-tt*ct,wt=vt*gt-Pt*et,Zt=ft*Pt-dt*vt,ue=et*dt-gt*ft;if(s){if(wt<0||Zt<0||ue<0)return null}else if((wt<0||Zt<0||ue<0)&&(wt>0||Zt>0||ue>0))return null;let Yt=wt+Zt+ue;if(Yt===0)return null;let _e=st*(wt*k+Zt*V+ue*ct);return(Yt>0?_e<0:_e>0)?null:this.at(_e/Yt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hs=class extends Us{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ds,this.combine=Wd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Qg=new Me,eo=new ar,Yc=new Ns,t0=new B,$c=new B,Zc=new B,Jc=new B,Rd=new B,jc=new B,e0=new B,Kc=new B,Ft=class extends En{constructor(t=new Ce,e=new hs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){jc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],f=r[l];h!==0&&(Rd.fromBufferAttribute(f,t),o?jc.addScaledVector(Rd,h):jc.addScaledVector(Rd.sub(e),h))}e.add(jc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Yc.copy(i.boundingSphere),Yc.applyMatrix4(r),eo.copy(t.ray).recast(t.near),!(Yc.containsPoint(eo.origin)===!1&&(eo.intersectSphere(Yc,t0)===null||eo.origin.distanceToSquared(t0)>(t.far-t.near)**2))&&(Qg.copy(r).invert(),eo.copy(t.ray).applyMatrix4(Qg),!(i.boundingBox!==null&&eo.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,eo)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,u=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=u.length;g<_;g++){let m=u[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),w=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let v=y,C=w;v<C;v+=3){let S=a.getX(v),x=a.getX(v+1),M=a.getX(v+2);s=Qc(this,p,t,i,c,h,f,S,x,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let m=g,p=_;m<p;m+=3){let y=a.getX(m),w=a.getX(m+1),v=a.getX(m+2);s=Qc(this,o,t,i,c,h,f,y,w,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,_=u.length;g<_;g++){let m=u[g],p=o[m.materialIndex],y=Math.max(m.start,d.start),w=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let v=y,C=w;v<C;v+=3){let S=v,x=v+1,M=v+2;s=Qc(this,p,t,i,c,h,f,S,x,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let m=g,p=_;m<p;m+=3){let y=m,w=m+1,v=m+2;s=Qc(this,o,t,i,c,h,f,y,w,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function cS(n,t,e,i,s,r,o,a){let l;if(t.side===bi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Or,a),l===null)return null;Kc.copy(a),Kc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Kc);return c<e.near||c>e.far?null:{distance:c,point:Kc.clone(),object:n}}function Qc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,$c),n.getVertexPosition(l,Zc),n.getVertexPosition(c,Jc);let h=cS(n,t,e,i,$c,Zc,Jc,e0);if(h){let f=new B;sr.getBarycoord(e0,$c,Zc,Jc,f),s&&(h.uv=sr.getInterpolatedAttribute(s,a,l,c,f,new qt)),r&&(h.uv1=sr.getInterpolatedAttribute(r,a,l,c,f,new qt)),o&&(h.normal=sr.getInterpolatedAttribute(o,a,l,c,f,new B),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new B,materialIndex:0};sr.getNormal($c,Zc,Jc,u.normal),h.face=u,h.barycoord=f}return h}var Ml=class extends yi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Jn,h=Jn,f,u){super(null,o,a,l,c,h,s,r,f,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ma=class extends sn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},na=new Me,n0=new Me,th=[],i0=new wi,hS=new Me,sl=new Ft,rl=new Ns,wl=class extends Ft{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ma(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,hS)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new wi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,na),i0.copy(t.boundingBox).applyMatrix4(na),this.boundingBox.union(i0)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ns),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,na),rl.copy(t.boundingSphere).applyMatrix4(na),this.boundingSphere.union(rl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(sl.geometry=this.geometry,sl.material=this.material,sl.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),rl.copy(this.boundingSphere),rl.applyMatrix4(i),t.ray.intersectsSphere(rl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,na),n0.multiplyMatrices(i,na),sl.matrixWorld=n0,sl.raycast(t,th);for(let o=0,a=th.length;o<a;o++){let l=th[o];l.instanceId=r,l.object=this,e.push(l)}th.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new ma(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ml(new Float32Array(s*this.count),s,this.count,Zh,Zi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},no=new Ns,uS=new qt(.5,.5),eh=new B,io=class{constructor(t=new gi,e=new gi,i=new gi,s=new gi,r=new gi,o=new gi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Yi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],f=r[5],u=r[6],d=r[7],g=r[8],_=r[9],m=r[10],p=r[11],y=r[12],w=r[13],v=r[14],C=r[15];if(s[0].setComponents(c-o,d-h,p-g,C-y).normalize(),s[1].setComponents(c+o,d+h,p+g,C+y).normalize(),s[2].setComponents(c+a,d+f,p+_,C+w).normalize(),s[3].setComponents(c-a,d-f,p-_,C-w).normalize(),i)s[4].setComponents(l,u,m,v).normalize(),s[5].setComponents(c-l,d-u,p-m,C-v).normalize();else if(s[4].setComponents(c-l,d-u,p-m,C-v).normalize(),e===Yi)s[5].setComponents(c+l,d+u,p+m,C+v).normalize();else if(e===dl)s[5].setComponents(l,u,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),no.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),no.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(no)}intersectsSprite(t){no.center.set(0,0,0);let e=uS.distanceTo(t.center);return no.radius=.7071067811865476+e,no.applyMatrix4(t.matrixWorld),this.intersectsSphere(no)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(eh.x=s.normal.x>0?t.max.x:t.min.x,eh.y=s.normal.y>0?t.max.y:t.min.y,eh.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(eh)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},s0=new Me,wh=class n{constructor(){this.coordinateSystem=Yi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];s0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new io),i[s].setFromProjectionMatrix(s0,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new io),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var us=class extends Us{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Eh=new B,Th=new B,r0=new Me,ol=new ar,nh=new Ns,Cd=new B,o0=new B,vi=class extends En{constructor(t=new Ce,e=new us){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Eh.fromBufferAttribute(e,s-1),Th.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Eh.distanceTo(Th);t.setAttribute("lineDistance",new Te(i,1))}else Kt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),nh.copy(i.boundingSphere),nh.applyMatrix4(s),nh.radius+=r,t.ray.intersectsSphere(nh)===!1)return;r0.copy(s).invert(),ol.copy(t.ray).applyMatrix4(r0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let d=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let _=d,m=g-1;_<m;_+=c){let p=h.getX(_),y=h.getX(_+1),w=ih(this,t,ol,l,p,y,_);w&&e.push(w)}if(this.isLineLoop){let _=h.getX(g-1),m=h.getX(d),p=ih(this,t,ol,l,_,m,g-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let _=d,m=g-1;_<m;_+=c){let p=ih(this,t,ol,l,_,_+1,_);p&&e.push(p)}if(this.isLineLoop){let _=ih(this,t,ol,l,g-1,d,g-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ih(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Eh.fromBufferAttribute(a,s),Th.fromBufferAttribute(a,r),e.distanceSqToSegment(Eh,Th,Cd,o0)>i)return;Cd.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Cd);if(!(c<t.near||c>t.far))return{distance:c,point:o0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var a0=new B,l0=new B,so=class extends vi{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)a0.fromBufferAttribute(e,s),l0.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+a0.distanceTo(l0);t.setAttribute("lineDistance",new Te(i,1))}else Kt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ir=class extends Us{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Qt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},c0=new Me,Nd=new ar,sh=new Ns,rh=new B,ro=class extends En{constructor(t=new Ce,e=new Ir){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),sh.copy(i.boundingSphere),sh.applyMatrix4(s),sh.radius+=r,t.ray.intersectsSphere(sh)===!1)return;c0.copy(s).invert(),Nd.copy(t.ray).applyMatrix4(c0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let u=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=u,_=d;g<_;g++){let m=c.getX(g);rh.fromBufferAttribute(f,m),h0(rh,m,l,s,t,e,this)}}else{let u=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let g=u,_=d;g<_;g++)rh.fromBufferAttribute(f,g),h0(rh,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function h0(n,t,e,i,s,r,o){let a=Nd.distanceSqToPoint(n);if(a<e){let l=new B;Nd.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var El=class extends yi{constructor(t=[],e=uo,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Tl=class extends yi{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var lr=class extends yi{constructor(t,e,i=fs,s,r,o,a=Jn,l=Jn,c,h=or,f=1){if(h!==or&&h!==ur)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:f};super(u,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ha(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Al=class extends lr{constructor(t,e=fs,i=uo,s,r,o=Jn,a=Jn,l,c=or){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Rl=class extends yi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},cn=class n extends Ce{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],f=[],u=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(h,3)),this.setAttribute("uv",new Te(f,2));function g(_,m,p,y,w,v,C,S,x,M,F){let I=v/x,D=C/M,k=v/2,X=C/2,U=S/2,V=x+1,Z=M+1,W=0,ct=0,$=new B;for(let tt=0;tt<Z;tt++){let st=tt*D-X;for(let ft=0;ft<V;ft++){let dt=ft*I-k;$[_]=dt*y,$[m]=st*w,$[p]=U,c.push($.x,$.y,$.z),$[_]=0,$[m]=0,$[p]=S>0?1:-1,h.push($.x,$.y,$.z),f.push(ft/x),f.push(1-tt/M),W+=1}}for(let tt=0;tt<M;tt++)for(let st=0;st<x;st++){let ft=u+st+V*tt,dt=u+st+V*(tt+1),et=u+(st+1)+V*(tt+1),gt=u+(st+1)+V*tt;l.push(ft,dt,gt),l.push(dt,et,gt),ct+=6}a.addGroup(d,ct,F),d+=ct,u+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var hn=class n extends Ce{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],u=[],d=[],g=0,_=[],m=i/2,p=0;y(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Te(f,3)),this.setAttribute("normal",new Te(u,3)),this.setAttribute("uv",new Te(d,2));function y(){let v=new B,C=new B,S=0,x=(e-t)/i;for(let M=0;M<=r;M++){let F=[],I=M/r,D=I*(e-t)+t;for(let k=0;k<=s;k++){let X=k/s,U=X*l+a,V=Math.sin(U),Z=Math.cos(U);C.x=D*V,C.y=-I*i+m,C.z=D*Z,f.push(C.x,C.y,C.z),v.set(V,x,Z).normalize(),u.push(v.x,v.y,v.z),d.push(X,1-I),F.push(g++)}_.push(F)}for(let M=0;M<s;M++)for(let F=0;F<r;F++){let I=_[F][M],D=_[F+1][M],k=_[F+1][M+1],X=_[F][M+1];(t>0||F!==0)&&(h.push(I,D,X),S+=3),(e>0||F!==r-1)&&(h.push(D,k,X),S+=3)}c.addGroup(p,S,0),p+=S}function w(v){let C=g,S=new qt,x=new B,M=0,F=v===!0?t:e,I=v===!0?1:-1;for(let k=1;k<=s;k++)f.push(0,m*I,0),u.push(0,I,0),d.push(.5,.5),g++;let D=g;for(let k=0;k<=s;k++){let U=k/s*l+a,V=Math.cos(U),Z=Math.sin(U);x.x=F*Z,x.y=m*I,x.z=F*V,f.push(x.x,x.y,x.z),u.push(0,I,0),S.x=V*.5+.5,S.y=Z*.5*I+.5,d.push(S.x,S.y),g++}for(let k=0;k<s;k++){let X=C+k,U=D+k;v===!0?h.push(U,U+1,X):h.push(U+1,U,X),M+=3}c.addGroup(p,M,v===!0?1:2),p+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Cl=class n extends hn{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ah=class n extends Ce{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),h(),this.setAttribute("position",new Te(r,3)),this.setAttribute("normal",new Te(r.slice(),3)),this.setAttribute("uv",new Te(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){let w=new B,v=new B,C=new B;for(let S=0;S<e.length;S+=3)d(e[S+0],w),d(e[S+1],v),d(e[S+2],C),l(w,v,C,y)}function l(y,w,v,C){let S=C+1,x=[];for(let M=0;M<=S;M++){x[M]=[];let F=y.clone().lerp(v,M/S),I=w.clone().lerp(v,M/S),D=S-M;for(let k=0;k<=D;k++)k===0&&M===S?x[M][k]=F:x[M][k]=F.clone().lerp(I,k/D)}for(let M=0;M<S;M++)for(let F=0;F<2*(S-M)-1;F++){let I=Math.floor(F/2);F%2===0?(u(x[M][I+1]),u(x[M+1][I]),u(x[M][I])):(u(x[M][I+1]),u(x[M+1][I+1]),u(x[M+1][I]))}}function c(y){let w=new B;for(let v=0;v<r.length;v+=3)w.x=r[v+0],w.y=r[v+1],w.z=r[v+2],w.normalize().multiplyScalar(y),r[v+0]=w.x,r[v+1]=w.y,r[v+2]=w.z}function h(){let y=new B;for(let w=0;w<r.length;w+=3){y.x=r[w+0],y.y=r[w+1],y.z=r[w+2];let v=m(y)/2/Math.PI+.5,C=p(y)/Math.PI+.5;o.push(v,1-C)}g(),f()}function f(){for(let y=0;y<o.length;y+=6){let w=o[y+0],v=o[y+2],C=o[y+4],S=Math.max(w,v,C),x=Math.min(w,v,C);S>.9&&x<.1&&(w<.2&&(o[y+0]+=1),v<.2&&(o[y+2]+=1),C<.2&&(o[y+4]+=1))}}function u(y){r.push(y.x,y.y,y.z)}function d(y,w){let v=y*3;w.x=t[v+0],w.y=t[v+1],w.z=t[v+2]}function g(){let y=new B,w=new B,v=new B,C=new B,S=new qt,x=new qt,M=new qt;for(let F=0,I=0;F<r.length;F+=9,I+=6){y.set(r[F+0],r[F+1],r[F+2]),w.set(r[F+3],r[F+4],r[F+5]),v.set(r[F+6],r[F+7],r[F+8]),S.set(o[I+0],o[I+1]),x.set(o[I+2],o[I+3]),M.set(o[I+4],o[I+5]),C.copy(y).add(w).add(v).divideScalar(3);let D=m(C);_(S,I+0,y,D),_(x,I+2,w,D),_(M,I+4,v,D)}}function _(y,w,v,C){C<0&&y.x===1&&(o[w]=y.x-1),v.x===0&&v.z===0&&(o[w]=C/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function p(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Pl=class n extends Ce{constructor(t=[new qt(0,-.5),new qt(.5,0),new qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=xe(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/e,f=new B,u=new qt,d=new B,g=new B,_=new B,m=0,p=0;for(let y=0;y<=t.length-1;y++)switch(y){case 0:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,_.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:_.normalize(),l.push(_.x,_.y,_.z);break;default:m=t[y+1].x-t[y].x,p=t[y+1].y-t[y].y,d.x=p*1,d.y=-m,d.z=p*0,g.copy(d),d.x+=_.x,d.y+=_.y,d.z+=_.z,d.normalize(),l.push(d.x,d.y,d.z),_.copy(g)}for(let y=0;y<=e;y++){let w=i+y*h*s,v=Math.sin(w),C=Math.cos(w);for(let S=0;S<=t.length-1;S++){f.x=t[S].x*v,f.y=t[S].y,f.z=t[S].x*C,o.push(f.x,f.y,f.z),u.x=y/e,u.y=S/(t.length-1),a.push(u.x,u.y);let x=l[3*S+0]*v,M=l[3*S+1],F=l[3*S+0]*C;c.push(x,M,F)}}for(let y=0;y<e;y++)for(let w=0;w<t.length-1;w++){let v=w+y*t.length,C=v,S=v+t.length,x=v+t.length+1,M=v+1;r.push(C,S,M),r.push(x,M,S)}this.setIndex(r),this.setAttribute("position",new Te(o,3)),this.setAttribute("uv",new Te(a,2)),this.setAttribute("normal",new Te(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Fs=class n extends Ah{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},oo=class n extends Ce{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,f=t/a,u=e/l,d=[],g=[],_=[],m=[];for(let p=0;p<h;p++){let y=p*u-o;for(let w=0;w<c;w++){let v=w*f-r;g.push(v,-y,0),_.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let w=y+c*p,v=y+c*(p+1),C=y+1+c*(p+1),S=y+1+c*p;d.push(w,v,S),d.push(v,C,S)}this.setIndex(d),this.setAttribute("position",new Te(g,3)),this.setAttribute("normal",new Te(_,3)),this.setAttribute("uv",new Te(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var ao=class n extends Ce{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],f=new B,u=new B,d=[],g=[],_=[],m=[];for(let p=0;p<=i;p++){let y=[],w=p/i,v=o+w*a,C=t*Math.cos(v),S=Math.sqrt(t*t-C*C),x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let M=0;M<=e;M++){let F=M/e,I=s+F*r;f.x=-S*Math.cos(I),f.y=C,f.z=S*Math.sin(I),g.push(f.x,f.y,f.z),u.copy(f).normalize(),_.push(u.x,u.y,u.z),m.push(F+x,1-w),y.push(c++)}h.push(y)}for(let p=0;p<i;p++)for(let y=0;y<e;y++){let w=h[p][y+1],v=h[p][y],C=h[p+1][y],S=h[p+1][y+1];(p!==0||o>0)&&d.push(w,v,S),(p!==i-1||l<Math.PI)&&d.push(v,C,S)}this.setIndex(d),this.setAttribute("position",new Te(g,3)),this.setAttribute("normal",new Te(_,3)),this.setAttribute("uv",new Te(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var cr=class n extends Ce{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],h=[],f=[],u=new B,d=new B,g=new B;for(let _=0;_<=i;_++){let m=o+_/i*a;for(let p=0;p<=s;p++){let y=p/s*r;d.x=(t+e*Math.cos(m))*Math.cos(y),d.y=(t+e*Math.cos(m))*Math.sin(y),d.z=e*Math.sin(m),c.push(d.x,d.y,d.z),u.x=t*Math.cos(y),u.y=t*Math.sin(y),g.subVectors(d,u).normalize(),h.push(g.x,g.y,g.z),f.push(p/s),f.push(_/i)}}for(let _=1;_<=i;_++)for(let m=1;m<=s;m++){let p=(s+1)*_+m-1,y=(s+1)*(_-1)+m-1,w=(s+1)*(_-1)+m,v=(s+1)*_+m;l.push(p,y,v),l.push(y,w,v)}this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(h,3)),this.setAttribute("uv",new Te(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function po(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(u0(s))s.isRenderTargetTexture?(Kt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(u0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function ri(n){let t={};for(let e=0;e<n.length;e++){let i=po(n[e]);for(let s in i)t[s]=i[s]}return t}function u0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function fS(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function _p(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ee.workingColorSpace}var n_={clone:po,merge:ri},dS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,pS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$i=class extends Us{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=dS,this.fragmentShader=pS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=po(t.uniforms),this.uniformsGroups=fS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Qt().setHex(s.value);break;case"v2":this.uniforms[i].value=new qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new B().fromArray(s.value);break;case"v4":this.uniforms[i].value=new dn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new le().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Me().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Rh=class extends $i{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ch=class extends Us{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=G0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Ph=class extends Us{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ia(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function oh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Lr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ih=class extends Lr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Id,endingEnd:Id}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ld:r=t,a=2*e-i;break;case Dd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Ld:o=t,l=2*i-e;break;case Dd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,f=this._offsetNext,u=this._weightPrev,d=this._weightNext,g=(i-e)/(s-e),_=g*g,m=_*g,p=-u*m+2*u*_-u*g,y=(1+u)*m+(-1.5-2*u)*_+(-.5+u)*g+1,w=(-1-d)*m+(1.5+d)*_+.5*g,v=d*m-d*_;for(let C=0;C!==a;++C)r[C]=p*o[h+C]+y*o[c+C]+w*o[l+C]+v*o[f+C];return r}},Lh=class extends Lr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),f=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*f+o[l+u]*h;return r}},Dh=class extends Lr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Nh=class extends Lr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(i-e)/(s-e),_=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*g;return r}let u=a*2,d=t-1;for(let g=0;g!==a;++g){let _=o[c+g],m=o[l+g],p=d*u+g*2,y=f[p],w=f[p+1],v=t*u+g*2,C=h[v],S=h[v+1],x=gS(i,e,y,C,s);r[g]=i_(x,_,w,S,m)}return r}};function i_(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function mS(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function gS(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=i_(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=mS(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Bi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ia(e,this.TimeBufferType),this.values=ia(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ia(t.times,Array),values:ia(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),oh(t.settings)&&(i.settings={inTangents:ia(t.settings.inTangents,Array),outTangents:ia(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Lh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ih(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Nh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case hl:e=this.InterpolantFactoryMethodDiscrete;break;case vh:e=this.InterpolantFactoryMethodLinear;break;case ch:e=this.InterpolantFactoryMethodSmooth;break;case Pd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Kt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return hl;case this.InterpolantFactoryMethodLinear:return vh;case this.InterpolantFactoryMethodSmooth:return ch;case this.InterpolantFactoryMethodBezier:return Pd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;oh(this.settings)&&(f0(this.settings.inTangents,t),f0(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;oh(this.settings)&&(d0(this.settings.inTangents,t),d0(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){se("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){se("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Ib(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){se("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ch,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let f=a*i,u=f-i,d=f+i;for(let g=0;g!==i;++g){let _=e[f+g];if(_!==e[u+g]||_!==e[d+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let f=a*i,u=o*i;for(let d=0;d!==i;++d)e[u+d]=e[f+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,oh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function f0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function d0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Bi.prototype.ValueTypeName="";Bi.prototype.TimeBufferType=Float32Array;Bi.prototype.ValueBufferType=Float32Array;Bi.prototype.DefaultInterpolation=vh;var Dr=class extends Bi{constructor(t,e,i){super(t,e,i)}};Dr.prototype.ValueTypeName="bool";Dr.prototype.ValueBufferType=Array;Dr.prototype.DefaultInterpolation=hl;Dr.prototype.InterpolantFactoryMethodLinear=void 0;Dr.prototype.InterpolantFactoryMethodSmooth=void 0;var Uh=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}};Uh.prototype.ValueTypeName="color";var Fh=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}};Fh.prototype.ValueTypeName="number";var Oh=class extends Lr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Je.slerpFlat(r,0,o,c-a,o,c,l);return r}},Il=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Oh(this.times,this.values,this.getValueSize(),t)}};Il.prototype.ValueTypeName="quaternion";Il.prototype.InterpolantFactoryMethodSmooth=void 0;var Nr=class extends Bi{constructor(t,e,i){super(t,e,i)}};Nr.prototype.ValueTypeName="string";Nr.prototype.ValueBufferType=Array;Nr.prototype.DefaultInterpolation=hl;Nr.prototype.InterpolantFactoryMethodLinear=void 0;Nr.prototype.InterpolantFactoryMethodSmooth=void 0;var Bh=class extends Bi{constructor(t,e,i,s){super(t,e,i,s)}};Bh.prototype.ValueTypeName="vector";var kh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,f){return c.push(h,f),this},this.removeHandler=function(h){let f=c.indexOf(h);return f!==-1&&c.splice(f,2),this},this.getHandler=function(h){for(let f=0,u=c.length;f<u;f+=2){let d=c[f],g=c[f+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},s_=new kh,zh=class{constructor(t){this.manager=t!==void 0?t:s_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};zh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ah=new B,lh=new Je,Is=new B,Ll=class extends En{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Me,this.projectionMatrix=new Me,this.projectionMatrixInverse=new Me,this.coordinateSystem=Yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ah,lh,Is),Is.x===1&&Is.y===1&&Is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ah,lh,Is.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ah,lh,Is),Is.x===1&&Is.y===1&&Is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ah,lh,Is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Pr=new B,p0=new qt,m0=new qt,_i=class extends Ll{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ca*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ll*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ca*2*Math.atan(Math.tan(ll*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Pr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Pr.x,Pr.y).multiplyScalar(-t/Pr.z),Pr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Pr.x,Pr.y).multiplyScalar(-t/Pr.z)}getViewSize(t,e){return this.getViewBounds(t,p0,m0),e.subVectors(m0,p0)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ll*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Hh=class extends Ll{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var sa=-90,ra=1,ga=class extends En{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new _i(sa,ra,t,e);s.layers=this.layers,this.add(s);let r=new _i(sa,ra,t,e);r.layers=this.layers,this.add(r);let o=new _i(sa,ra,t,e);o.layers=this.layers,this.add(o);let a=new _i(sa,ra,t,e);a.layers=this.layers,this.add(a);let l=new _i(sa,ra,t,e);l.layers=this.layers,this.add(l);let c=new _i(sa,ra,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Yi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===dl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,f=t.getRenderTarget(),u=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,u,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Gh=class extends _i{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var xp="\\[\\]\\.:\\/",_S=new RegExp("["+xp+"]","g"),yp="[^"+xp+"]",xS="[^"+xp.replace("\\.","")+"]",yS=/((?:WC+[\/:])*)/.source.replace("WC",yp),vS=/(WCOD+)?/.source.replace("WCOD",xS),bS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",yp),SS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",yp),MS=new RegExp("^"+yS+vS+bS+SS+"$"),wS=["material","materials","bones","map"],Ud=class{constructor(t,e,i){let s=i||nn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},nn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(_S,"")}static parseTrackName(t){let e=MS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);wS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Kt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;se("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=Ud;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var oP=new Float32Array(1);var g0=new Me,Dl=class{constructor(t,e,i=0,s=1/0){this.ray=new ar(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new ua,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):se("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return g0.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(g0),this}intersectObject(t,e=!0,i=[]){return Fd(t,this,i,e),i.sort(_0),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Fd(t[s],this,i,e);return i.sort(_0),i}};function _0(n,t){return n.distance-t.distance}function Fd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Fd(r[o],t,e,!0)}}var _a=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=xe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(xe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Od=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var lo=class extends cs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function vp(n,t,e,i){let s=ES(i);switch(e){case ip:return n*t;case Zh:return n*t/s.components*s.byteLength;case Jh:return n*t/s.components*s.byteLength;case Br:return n*t*2/s.components*s.byteLength;case jh:return n*t*2/s.components*s.byteLength;case sp:return n*t*3/s.components*s.byteLength;case ps:return n*t*4/s.components*s.byteLength;case Kh:return n*t*4/s.components*s.byteLength;case Fl:case Ol:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Bl:case kl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case tu:case nu:return Math.max(n,16)*Math.max(t,8)/4;case Qh:case eu:return Math.max(n,8)*Math.max(t,8)/2;case iu:case su:case ou:case au:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ru:case zl:case lu:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case cu:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case hu:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case uu:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case fu:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case du:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case pu:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case mu:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case gu:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case _u:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case xu:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case yu:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case vu:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case bu:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Su:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Mu:case wu:case Eu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Tu:case Au:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Hl:case Ru:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function ES(n){switch(n){case ki:case Qd:return{byteLength:1,components:1};case ba:case tp:case ds:return{byteLength:2,components:1};case Yh:case $h:return{byteLength:2,components:4};case fs:case qh:case Zi:return{byteLength:4,components:1};case ep:case np:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Kt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function T_(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function PS(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,f=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let h=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,h);else{f.sort((d,g)=>d.start-g.start);let u=0;for(let d=1;d<f.length;d++){let g=f[u],_=f[d];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++u,f[u]=_)}f.length=u+1;for(let d=0,g=f.length;d<g;d++){let _=f[d];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var IS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,LS=`#ifdef USE_ALPHAHASH
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
#endif`,DS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,NS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,US=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,FS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,OS=`#ifdef USE_AOMAP
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
#endif`,BS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kS=`#ifdef USE_BATCHING
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
#endif`,zS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,HS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,GS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,VS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,WS=`#ifdef USE_IRIDESCENCE
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
#endif`,XS=`#ifdef USE_BUMPMAP
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
#endif`,qS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,YS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$S=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,JS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,jS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,KS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,QS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,tM=`#define PI 3.141592653589793
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
} // validated`,eM=`vec3 transformedNormal = objectNormal;
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
#endif`,nM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,iM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,oM="gl_FragColor = linearToOutputTexel( gl_FragColor );",aM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lM=`#ifdef USE_ENVMAP
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
#endif`,cM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,hM=`#ifdef USE_ENVMAP
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
#endif`,uM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fM=`#ifdef USE_ENVMAP
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
#endif`,dM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_M=`#ifdef USE_GRADIENTMAP
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
}`,xM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,yM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,vM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,bM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,SM=`#ifdef USE_ENVMAP
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
#endif`,MM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,wM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,EM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,TM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,AM=`PhysicalMaterial material;
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
#endif`,RM=`uniform sampler2D dfgLUT;
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
}`,CM=`
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
#endif`,PM=`#if defined( RE_IndirectDiffuse )
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
#endif`,IM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,LM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,DM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,NM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,UM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,FM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,OM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,BM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,zM=`#if defined( USE_POINTS_UV )
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
#endif`,HM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,GM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,VM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,WM=`#if defined( USE_MORPHCOLORS )
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
#endif`,XM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qM=`#ifdef USE_MORPHTARGETS
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
#endif`,YM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$M=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ZM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,JM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,KM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,QM=`#ifdef USE_NORMALMAP
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
#endif`,tw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,ew=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,nw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,rw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,ow=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,aw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,lw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,cw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,dw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,pw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,mw=`float getShadowMask() {
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
}`,gw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_w=`#ifdef USE_SKINNING
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
#endif`,xw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,yw=`#ifdef USE_SKINNING
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
#endif`,vw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,bw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Sw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Mw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ww=`#ifdef USE_TRANSMISSION
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
#endif`,Ew=`#ifdef USE_TRANSMISSION
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
#endif`,Tw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Aw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Rw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Cw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Pw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Iw=`uniform sampler2D t2D;
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
}`,Lw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Dw=`uniform float backgroundBlurriness;
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
}`,Nw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fw=`#include <common>
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
}`,Ow=`#if DEPTH_PACKING == 3200
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
}`,Bw=`#define DISTANCE
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
}`,kw=`#define DISTANCE
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
}`,zw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Hw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Gw=`uniform float scale;
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
}`,Vw=`uniform vec3 diffuse;
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
}`,Ww=`#include <common>
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
}`,Xw=`uniform vec3 diffuse;
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
}`,qw=`#define LAMBERT
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
}`,Yw=`#define LAMBERT
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
}`,$w=`#define MATCAP
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
}`,Zw=`#define MATCAP
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
}`,Jw=`#define NORMAL
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
}`,jw=`#define NORMAL
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
}`,Kw=`#define PHONG
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
}`,Qw=`#define PHONG
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
}`,t1=`#define STANDARD
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
}`,e1=`#define STANDARD
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
}`,n1=`#define TOON
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
}`,i1=`#define TOON
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
}`,s1=`uniform float size;
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
}`,r1=`uniform vec3 diffuse;
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
}`,o1=`#include <common>
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
}`,a1=`uniform vec3 color;
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
}`,l1=`uniform float rotation;
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
}`,c1=`uniform vec3 diffuse;
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
}`,ge={alphahash_fragment:IS,alphahash_pars_fragment:LS,alphamap_fragment:DS,alphamap_pars_fragment:NS,alphatest_fragment:US,alphatest_pars_fragment:FS,aomap_fragment:OS,aomap_pars_fragment:BS,batching_pars_vertex:kS,batching_vertex:zS,begin_vertex:HS,beginnormal_vertex:GS,bsdfs:VS,iridescence_fragment:WS,bumpmap_pars_fragment:XS,clipping_planes_fragment:qS,clipping_planes_pars_fragment:YS,clipping_planes_pars_vertex:$S,clipping_planes_vertex:ZS,color_fragment:JS,color_pars_fragment:jS,color_pars_vertex:KS,color_vertex:QS,common:tM,defaultnormal_vertex:eM,displacementmap_pars_vertex:nM,displacementmap_vertex:iM,emissivemap_fragment:sM,emissivemap_pars_fragment:rM,colorspace_fragment:oM,colorspace_pars_fragment:aM,envmap_fragment:lM,envmap_common_pars_fragment:cM,envmap_pars_fragment:hM,envmap_pars_vertex:uM,envmap_physical_pars_fragment:SM,envmap_vertex:fM,fog_vertex:dM,fog_pars_vertex:pM,fog_fragment:mM,fog_pars_fragment:gM,gradientmap_pars_fragment:_M,lightmap_pars_fragment:xM,lights_lambert_fragment:yM,lights_lambert_pars_fragment:vM,lights_pars_begin:bM,lights_toon_fragment:MM,lights_toon_pars_fragment:wM,lights_phong_fragment:EM,lights_phong_pars_fragment:TM,lights_physical_fragment:AM,lights_physical_pars_fragment:RM,lights_fragment_begin:CM,lights_fragment_maps:PM,lights_fragment_end:IM,lightprobes_pars_fragment:LM,logdepthbuf_fragment:DM,logdepthbuf_pars_fragment:NM,logdepthbuf_pars_vertex:UM,logdepthbuf_vertex:FM,map_fragment:OM,map_pars_fragment:BM,map_particle_fragment:kM,map_particle_pars_fragment:zM,metalnessmap_fragment:HM,metalnessmap_pars_fragment:GM,morphinstance_vertex:VM,morphcolor_vertex:WM,morphnormal_vertex:XM,morphtarget_pars_vertex:qM,morphtarget_vertex:YM,normal_fragment_begin:$M,normal_fragment_maps:ZM,normal_pars_fragment:JM,normal_pars_vertex:jM,normal_vertex:KM,normalmap_pars_fragment:QM,clearcoat_normal_fragment_begin:tw,clearcoat_normal_fragment_maps:ew,clearcoat_pars_fragment:nw,iridescence_pars_fragment:iw,opaque_fragment:sw,packing:rw,premultiplied_alpha_fragment:ow,project_vertex:aw,dithering_fragment:lw,dithering_pars_fragment:cw,roughnessmap_fragment:hw,roughnessmap_pars_fragment:uw,shadowmap_pars_fragment:fw,shadowmap_pars_vertex:dw,shadowmap_vertex:pw,shadowmask_pars_fragment:mw,skinbase_vertex:gw,skinning_pars_vertex:_w,skinning_vertex:xw,skinnormal_vertex:yw,specularmap_fragment:vw,specularmap_pars_fragment:bw,tonemapping_fragment:Sw,tonemapping_pars_fragment:Mw,transmission_fragment:ww,transmission_pars_fragment:Ew,uv_pars_fragment:Tw,uv_pars_vertex:Aw,uv_vertex:Rw,worldpos_vertex:Cw,background_vert:Pw,background_frag:Iw,backgroundCube_vert:Lw,backgroundCube_frag:Dw,cube_vert:Nw,cube_frag:Uw,depth_vert:Fw,depth_frag:Ow,distance_vert:Bw,distance_frag:kw,equirect_vert:zw,equirect_frag:Hw,linedashed_vert:Gw,linedashed_frag:Vw,meshbasic_vert:Ww,meshbasic_frag:Xw,meshlambert_vert:qw,meshlambert_frag:Yw,meshmatcap_vert:$w,meshmatcap_frag:Zw,meshnormal_vert:Jw,meshnormal_frag:jw,meshphong_vert:Kw,meshphong_frag:Qw,meshphysical_vert:t1,meshphysical_frag:e1,meshtoon_vert:n1,meshtoon_frag:i1,points_vert:s1,points_frag:r1,shadow_vert:o1,shadow_frag:a1,sprite_vert:l1,sprite_frag:c1},Ut={common:{diffuse:{value:new Qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new le}},envmap:{envMap:{value:null},envMapRotation:{value:new le},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new le}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new le}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new le},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new le},normalScale:{value:new qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new le},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new le}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new le}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new le}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0},uvTransform:{value:new le}},sprite:{diffuse:{value:new Qt(16777215)},opacity:{value:1},center:{value:new qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}}},ks={basic:{uniforms:ri([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.fog]),vertexShader:ge.meshbasic_vert,fragmentShader:ge.meshbasic_frag},lambert:{uniforms:ri([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new Qt(0)},envMapIntensity:{value:1}}]),vertexShader:ge.meshlambert_vert,fragmentShader:ge.meshlambert_frag},phong:{uniforms:ri([Ut.common,Ut.specularmap,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,Ut.lights,{emissive:{value:new Qt(0)},specular:{value:new Qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ge.meshphong_vert,fragmentShader:ge.meshphong_frag},standard:{uniforms:ri([Ut.common,Ut.envmap,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.roughnessmap,Ut.metalnessmap,Ut.fog,Ut.lights,{emissive:{value:new Qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag},toon:{uniforms:ri([Ut.common,Ut.aomap,Ut.lightmap,Ut.emissivemap,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.gradientmap,Ut.fog,Ut.lights,{emissive:{value:new Qt(0)}}]),vertexShader:ge.meshtoon_vert,fragmentShader:ge.meshtoon_frag},matcap:{uniforms:ri([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,Ut.fog,{matcap:{value:null}}]),vertexShader:ge.meshmatcap_vert,fragmentShader:ge.meshmatcap_frag},points:{uniforms:ri([Ut.points,Ut.fog]),vertexShader:ge.points_vert,fragmentShader:ge.points_frag},dashed:{uniforms:ri([Ut.common,Ut.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ge.linedashed_vert,fragmentShader:ge.linedashed_frag},depth:{uniforms:ri([Ut.common,Ut.displacementmap]),vertexShader:ge.depth_vert,fragmentShader:ge.depth_frag},normal:{uniforms:ri([Ut.common,Ut.bumpmap,Ut.normalmap,Ut.displacementmap,{opacity:{value:1}}]),vertexShader:ge.meshnormal_vert,fragmentShader:ge.meshnormal_frag},sprite:{uniforms:ri([Ut.sprite,Ut.fog]),vertexShader:ge.sprite_vert,fragmentShader:ge.sprite_frag},background:{uniforms:{uvTransform:{value:new le},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ge.background_vert,fragmentShader:ge.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new le}},vertexShader:ge.backgroundCube_vert,fragmentShader:ge.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ge.cube_vert,fragmentShader:ge.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ge.equirect_vert,fragmentShader:ge.equirect_frag},distance:{uniforms:ri([Ut.common,Ut.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ge.distance_vert,fragmentShader:ge.distance_frag},shadow:{uniforms:ri([Ut.lights,Ut.fog,{color:{value:new Qt(0)},opacity:{value:1}}]),vertexShader:ge.shadow_vert,fragmentShader:ge.shadow_frag}};ks.physical={uniforms:ri([ks.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new le},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new le},clearcoatNormalScale:{value:new qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new le},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new le},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new le},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new le},sheen:{value:0},sheenColor:{value:new Qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new le},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new le},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new le},transmissionSamplerSize:{value:new qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new le},attenuationDistance:{value:0},attenuationColor:{value:new Qt(0)},specularColor:{value:new Qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new le},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new le},anisotropyVector:{value:new qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new le}}]),vertexShader:ge.meshphysical_vert,fragmentShader:ge.meshphysical_frag};var Iu={r:0,b:0,g:0},h1=new Me,A_=new le;A_.set(-1,0,0,0,1,0,0,0,1);function u1(n,t,e,i,s,r){let o=new Qt(0),a=s===!0?0:1,l,c,h=null,f=0,u=null;function d(y){let w=y.isScene===!0?y.background:null;if(w&&w.isTexture){let v=y.backgroundBlurriness>0;w=t.get(w,v)}return w}function g(y){let w=!1,v=d(y);v===null?m(o,a):v&&v.isColor&&(m(v,1),w=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(y,w){let v=d(w);v&&v.isCubeTexture?(c===void 0&&(c=new Ft(new cn(1,1,1),new $i({name:"BackgroundCubeMaterial",uniforms:po(ks.backgroundCube.uniforms),vertexShader:ks.backgroundCube.vertexShader,fragmentShader:ks.backgroundCube.fragmentShader,side:bi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,S,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(h1.makeRotationFromEuler(w.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(A_),c.material.toneMapped=Ee.getTransfer(v.colorSpace)!==Fe,(h!==v||f!==v.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=v,f=v.version,u=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ft(new oo(2,2),new $i({name:"BackgroundMaterial",uniforms:po(ks.background.uniforms),vertexShader:ks.background.vertexShader,fragmentShader:ks.background.fragmentShader,side:Or,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Ee.getTransfer(v.colorSpace)!==Fe,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||f!==v.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=v,f=v.version,u=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,w){y.getRGB(Iu,_p(n)),e.buffers.color.setClear(Iu.r,Iu.g,Iu.b,w,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,w=1){o.set(y),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:g,addToRenderList:_,dispose:p}}function f1(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(D,k,X,U,V){let Z=!1,W=f(D,U,X,k);r!==W&&(r=W,c(r.object)),Z=d(D,U,X,V),Z&&g(D,U,X,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,v(D,k,X,U),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function f(D,k,X,U){let V=U.wireframe===!0,Z=i[k.id];Z===void 0&&(Z={},i[k.id]=Z);let W=D.isInstancedMesh===!0?D.id:0,ct=Z[W];ct===void 0&&(ct={},Z[W]=ct);let $=ct[X.id];$===void 0&&($={},ct[X.id]=$);let tt=$[V];return tt===void 0&&(tt=u(l()),$[V]=tt),tt}function u(D){let k=[],X=[],U=[];for(let V=0;V<e;V++)k[V]=0,X[V]=0,U[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:X,attributeDivisors:U,object:D,attributes:{},index:null}}function d(D,k,X,U){let V=r.attributes,Z=k.attributes,W=0,ct=X.getAttributes();for(let $ in ct)if(ct[$].location>=0){let st=V[$],ft=Z[$];if(ft===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ft=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ft=D.instanceColor)),st===void 0||st.attribute!==ft||ft&&st.data!==ft.data)return!0;W++}return r.attributesNum!==W||r.index!==U}function g(D,k,X,U){let V={},Z=k.attributes,W=0,ct=X.getAttributes();for(let $ in ct)if(ct[$].location>=0){let st=Z[$];st===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(st=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(st=D.instanceColor));let ft={};ft.attribute=st,st&&st.data&&(ft.data=st.data),V[$]=ft,W++}r.attributes=V,r.attributesNum=W,r.index=U}function _(){let D=r.newAttributes;for(let k=0,X=D.length;k<X;k++)D[k]=0}function m(D){p(D,0)}function p(D,k){let X=r.newAttributes,U=r.enabledAttributes,V=r.attributeDivisors;X[D]=1,U[D]===0&&(n.enableVertexAttribArray(D),U[D]=1),V[D]!==k&&(n.vertexAttribDivisor(D,k),V[D]=k)}function y(){let D=r.newAttributes,k=r.enabledAttributes;for(let X=0,U=k.length;X<U;X++)k[X]!==D[X]&&(n.disableVertexAttribArray(X),k[X]=0)}function w(D,k,X,U,V,Z,W){W===!0?n.vertexAttribIPointer(D,k,X,V,Z):n.vertexAttribPointer(D,k,X,U,V,Z)}function v(D,k,X,U){_();let V=U.attributes,Z=X.getAttributes(),W=k.defaultAttributeValues;for(let ct in Z){let $=Z[ct];if($.location>=0){let tt=V[ct];if(tt===void 0&&(ct==="instanceMatrix"&&D.instanceMatrix&&(tt=D.instanceMatrix),ct==="instanceColor"&&D.instanceColor&&(tt=D.instanceColor)),tt!==void 0){let st=tt.normalized,ft=tt.itemSize,dt=t.get(tt);if(dt===void 0)continue;let et=dt.buffer,gt=dt.type,vt=dt.bytesPerElement,Pt=gt===n.INT||gt===n.UNSIGNED_INT||tt.gpuType===qh;if(tt.isInterleavedBufferAttribute){let wt=tt.data,Zt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,ue=tt.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Yt=0;Yt<$.locationSize;Yt++)p($.location+Yt,wt.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Yt=0;Yt<$.locationSize;Yt++)m($.location+Yt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Yt=0;Yt<$.locationSize;Yt++)w($.location+Yt,ft/$.locationSize,gt,st,Zt*vt,(ue+ft/$.locationSize*Yt)*vt,Pt)}else{if(tt.isInstancedBufferAttribute){for(let wt=0;wt<$.locationSize;wt++)p($.location+wt,tt.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let wt=0;wt<$.locationSize;wt++)m($.location+wt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let wt=0;wt<$.locationSize;wt++)w($.location+wt,ft/$.locationSize,gt,st,ft*vt,ft/$.locationSize*wt*vt,Pt)}}else if(W!==void 0){let st=W[ct];if(st!==void 0)switch(st.length){case 2:n.vertexAttrib2fv($.location,st);break;case 3:n.vertexAttrib3fv($.location,st);break;case 4:n.vertexAttrib4fv($.location,st);break;default:n.vertexAttrib1fv($.location,st)}}}}y()}function C(){F();for(let D in i){let k=i[D];for(let X in k){let U=k[X];for(let V in U){let Z=U[V];for(let W in Z)h(Z[W].object),delete Z[W];delete U[V]}}delete i[D]}}function S(D){if(i[D.id]===void 0)return;let k=i[D.id];for(let X in k){let U=k[X];for(let V in U){let Z=U[V];for(let W in Z)h(Z[W].object),delete Z[W];delete U[V]}}delete i[D.id]}function x(D){for(let k in i){let X=i[k];for(let U in X){let V=X[U];if(V[D.id]===void 0)continue;let Z=V[D.id];for(let W in Z)h(Z[W].object),delete Z[W];delete V[D.id]}}}function M(D){for(let k in i){let X=i[k],U=D.isInstancedMesh===!0?D.id:0,V=X[U];if(V!==void 0){for(let Z in V){let W=V[Z];for(let ct in W)h(W[ct].object),delete W[ct];delete V[Z]}delete X[U],Object.keys(X).length===0&&delete i[k]}}}function F(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:S,releaseStatesOfObject:M,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:m,disableUnusedAttributes:y}}function d1(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let d=0;d<h;d++)u+=c[d];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function p1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==ps&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let M=x===ds&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==ki&&x!==Zi&&!M&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Kt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Kt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Kt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),S=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:w,maxFragmentUniforms:v,maxSamples:C,samples:S}}function m1(n){let t=this,e=null,i=0,s=!1,r=!1,o=new gi,a=new le,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let d=f.length!==0||u||i!==0||s;return s=u,i=f.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,u){e=h(f,u,0)},this.setState=function(f,u,d){let g=f.clippingPlanes,_=f.clipIntersection,m=f.clipShadows,p=n.get(f);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let y=r?0:i,w=y*4,v=p.clippingState||null;l.value=v,v=h(g,u,w,d);for(let C=0;C!==w;++C)v[C]=e[C];p.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(f,u,d,g){let _=f!==null?f.length:0,m=null;if(_!==0){if(m=l.value,g!==!0||m===null){let p=d+_*4,y=u.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,v=d;w!==_;++w,v+=4)o.copy(f[w]).applyMatrix4(y,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Wl=class extends Oi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new El(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new cn(5,5,5),r=new $i({name:"CubemapFromEquirect",uniforms:po(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:bi,blending:co});r.uniforms.tEquirect.value=e;let o=new Ft(s,r),a=e.minFilter;return e.minFilter===hr&&(e.minFilter=xi),new ga(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},r_=256,g1=3,_1=20,R_=256,C_=16,x1=3,y1=new B,v1=new Qt,Du=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ga(1,10,null),this._boxMesh=new Ft(new cn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=y1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,u=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(v1));let m=new ga(i,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=f,l.autoClearColor=u,l.autoClearDepth=d,l.autoClearStencil=g,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=l_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=a_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(r_,pp(t))}_fromTexture(t,e){t.mapping===uo||t.mapping===va?this._setSize(t.image.length===0?r_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=o_(t,!1,!1),i=Math.log2(t)-g1;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=o_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===uo||t.mapping===va?(this._cubemapMaterial===null&&(this._cubemapMaterial=l_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=a_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=b1(),this._integrationMaterial=S1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/C_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-x1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(R_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=M1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function o_(n,t,e){return new Wl(n,{minFilter:hr,generateMipmaps:t,type:ds,colorSpace:ul,depthBuffer:e})}function Xl(n,t,e){return new $i({name:n,uniforms:t,vertexShader:ge.cube_vert,fragmentShader:e,side:bi,blending:co,depthTest:!1,depthWrite:!1})}function b1(){return Xl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${R_}u

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
	`)}function S1(){return Xl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:C_}},`

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
	`)}function M1(){return Xl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_1}
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
	`)}function a_(){return Xl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function l_(){return Xl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function w1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,d=!1){return u==null?null:d?o(u):r(u)}function r(u){if(u&&u.isTexture){let d=u.mapping;if(d===Vh||d===Wh)if(t.has(u)){let g=t.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let _=new Wl(g.height);return _.fromEquirectangularTexture(n,u),t.set(u,_),u.addEventListener("dispose",c),a(_.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let d=u.mapping,g=d===Vh||d===Wh,_=d===uo||d===va;if(g||_){let m=e.get(u),p=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new Du(n)),m=g?i.fromEquirectangular(u,m):i.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let y=u.image;return g&&y&&y.height>0||_&&y&&l(y)?(i===null&&(i=new Du(n)),m=g?i.fromEquirectangular(u):i.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,d){return d===Vh?u.mapping=uo:d===Wh&&(u.mapping=va),u}function l(u){let d=0,g=6;for(let _=0;_<g;_++)u[_]!==void 0&&d++;return d===g}function c(u){let d=u.target;d.removeEventListener("dispose",c);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function h(u){let d=u.target;d.removeEventListener("dispose",h);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function E1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&al("WebGLRenderer: "+i+" extension not supported."),s}}}function T1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let _=r.get(g);_&&(t.remove(_),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(g){let _=g.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function f(g){let _=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let y=_!==null?_.array.length:m.array.length/3-1,w=m.count>=65535?vl:yl,v=new w(Math.ceil(y/3)*6,1),C=v.array;if(_!==null){let x=_.array;p=_.version;for(let M=0,F=0;M<y;M+=3){let I=x[M+0],D=x[M+1],k=x[M+2];C[F++]=I,C[F++]=D,C[F++]=D,C[F++]=k,C[F++]=k,C[F++]=I}}else{p=m.version;for(let x=0,M=0;x<y;x+=3){let F=x+0,I=x+1,D=x+2;C[M++]=F,C[M++]=I,C[M++]=I,C[M++]=D,C[M++]=D,C[M++]=F}}v.version=p;let S=r.get(g);S&&t.remove(S),r.set(g,v)}function u(g){let _=r.get(g);if(_){let m=g.index;m!==null&&_.version<m.version&&f(g)}else f(g);return r.get(g)}function d(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:u,dispose:d}}function A1(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,u){n.drawElements(i,u,r,f*o),e.update(u,i,1)}function c(f,u,d){d!==0&&(n.drawElementsInstanced(i,u,r,f*o,d),e.update(u,i,d))}function h(f,u,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,f,0,d);let _=0;for(let m=0;m<d;m++)_+=u[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function R1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function C1(n,t,e){let i=new WeakMap,s=new dn;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==f){let F=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",F)};u!==void 0&&u.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],w=0;d===!0&&(w=1),g===!0&&(w=2),_===!0&&(w=3);let v=a.attributes.position.count*w,C=1;v>t.maxTextureSize&&(C=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let S=new Float32Array(v*C*4*f),x=new gl(S,v,C,f);x.type=Zi,x.needsUpdate=!0;let M=w*4;for(let I=0;I<f;I++){let D=m[I],k=p[I],X=y[I],U=v*C*4*I;for(let V=0;V<D.count;V++){let Z=V*M;d===!0&&(s.fromBufferAttribute(D,V),S[U+Z+0]=s.x,S[U+Z+1]=s.y,S[U+Z+2]=s.z,S[U+Z+3]=0),g===!0&&(s.fromBufferAttribute(k,V),S[U+Z+4]=s.x,S[U+Z+5]=s.y,S[U+Z+6]=s.z,S[U+Z+7]=0),_===!0&&(s.fromBufferAttribute(X,V),S[U+Z+8]=s.x,S[U+Z+9]=s.y,S[U+Z+10]=s.z,S[U+Z+11]=X.itemSize===4?s.w:1)}}u={count:f,texture:x,size:new qt(v,C)},i.set(a,u),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function P1(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,f=c.geometry,u=t.get(c,f);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var I1={[Xd]:"LINEAR_TONE_MAPPING",[qd]:"REINHARD_TONE_MAPPING",[Yd]:"CINEON_TONE_MAPPING",[$d]:"ACES_FILMIC_TONE_MAPPING",[Jd]:"AGX_TONE_MAPPING",[jd]:"NEUTRAL_TONE_MAPPING",[Zd]:"CUSTOM_TONE_MAPPING"};function L1(n,t,e,i,s,r){let o=new Oi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ce;h.setAttribute("position",new Te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Te([0,2,0,0,2,0],2));let f=new Rh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Ft(h,f),d=new Hh(-1,1,1,-1,0,1),g=null,_=null,m=!1,p,y=null,w=[],v=!1;this.setSize=function(C,S){o.setSize(C,S),a!==null&&a.setSize(C,S),l!==null&&l.setSize(C,S);for(let x=0;x<w.length;x++){let M=w[x];M.setSize&&M.setSize(C,S)}},this.setEffects=function(C){w=C,v=w.length>0&&w[0].isRenderPass===!0;let S=o.width,x=o.height;w.length>0&&a===null&&(a=new Oi(S,x,{type:ds,depthBuffer:!1,stencilBuffer:!1}),l=new Oi(S,x,{type:ds,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&w.some(F=>F.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new lr(S,x),r===!0&&(c.format=ur,c.type=fo)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let F=0;F<w.length;F++){let I=w[F];I.setSize&&I.setSize(S,x),M&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(C,S){if(m||C.toneMapping===Os&&w.length===0)return!1;if(y=S,S!==null){let x=S.width,M=S.height;(o.width!==x||o.height!==M)&&this.setSize(x,M)}return v===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Os,!0},this.hasRenderPass=function(){return v},this.end=function(C,S){C.toneMapping=p,m=!0;let x=o,M=a;for(let F=0;F<w.length;F++){let I=w[F];I.enabled!==!1&&(I.render(C,M,x,S),I.needsSwap!==!1&&(x=M,M=M===a?l:a))}if(g!==C.outputColorSpace||_!==C.toneMapping){g=C.outputColorSpace,_=C.toneMapping,f.defines={},Ee.getTransfer(g)===Fe&&(f.defines.SRGB_TRANSFER="");let F=I1[_];F&&(f.defines[F]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(y),C.render(u,d),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),f.dispose()}}var P_=new yi,I_=new lr(1,1),L_=new Al(1),D_=new gl,N_=new Mh,U_=new El,c_=[],h_=[],u_=new Float32Array(16),f_=new Float32Array(9),d_=new Float32Array(4);function wa(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=c_[s];if(r===void 0&&(r=new Float32Array(s),c_[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function On(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Bn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Uu(n,t){let e=h_[t];e===void 0&&(e=new Int32Array(t),h_[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function D1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function N1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(On(e,t))return;n.uniform2fv(this.addr,t),Bn(e,t)}}function U1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(On(e,t))return;n.uniform3fv(this.addr,t),Bn(e,t)}}function F1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(On(e,t))return;n.uniform4fv(this.addr,t),Bn(e,t)}}function O1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(On(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Bn(e,t)}else{if(On(e,i))return;d_.set(i),n.uniformMatrix2fv(this.addr,!1,d_),Bn(e,i)}}function B1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(On(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Bn(e,t)}else{if(On(e,i))return;f_.set(i),n.uniformMatrix3fv(this.addr,!1,f_),Bn(e,i)}}function k1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(On(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Bn(e,t)}else{if(On(e,i))return;u_.set(i),n.uniformMatrix4fv(this.addr,!1,u_),Bn(e,i)}}function z1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function H1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(On(e,t))return;n.uniform2iv(this.addr,t),Bn(e,t)}}function G1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(On(e,t))return;n.uniform3iv(this.addr,t),Bn(e,t)}}function V1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(On(e,t))return;n.uniform4iv(this.addr,t),Bn(e,t)}}function W1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function X1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(On(e,t))return;n.uniform2uiv(this.addr,t),Bn(e,t)}}function q1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(On(e,t))return;n.uniform3uiv(this.addr,t),Bn(e,t)}}function Y1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(On(e,t))return;n.uniform4uiv(this.addr,t),Bn(e,t)}}function Fu(n){return n.version===0&&(n.compareFunction=hp,n.needsUpdate=!0),n}function $1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Fu(I_):r=P_,e.setTexture2D(t||r,s)}function Z1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||N_,s)}function J1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Fu(L_):r=U_,e.setTextureCube(t||r,s)}function j1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||D_,s)}function K1(n){switch(n){case 5126:return D1;case 35664:return N1;case 35665:return U1;case 35666:return F1;case 35674:return O1;case 35675:return B1;case 35676:return k1;case 5124:case 35670:return z1;case 35667:case 35671:return H1;case 35668:case 35672:return G1;case 35669:case 35673:return V1;case 5125:return W1;case 36294:return X1;case 36295:return q1;case 36296:return Y1;case 35678:case 36198:case 36298:case 36306:case 35682:return $1;case 35679:case 36299:case 36307:return Z1;case 35680:case 36300:case 36308:case 36293:return J1;case 36289:case 36303:case 36311:case 36292:return j1}}function Q1(n,t){n.uniform1fv(this.addr,t)}function tE(n,t){let e=wa(t,this.size,2);n.uniform2fv(this.addr,e)}function eE(n,t){let e=wa(t,this.size,3);n.uniform3fv(this.addr,e)}function nE(n,t){let e=wa(t,this.size,4);n.uniform4fv(this.addr,e)}function iE(n,t){let e=wa(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function sE(n,t){let e=wa(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function rE(n,t){let e=wa(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function oE(n,t){n.uniform1iv(this.addr,t)}function aE(n,t){n.uniform2iv(this.addr,t)}function lE(n,t){n.uniform3iv(this.addr,t)}function cE(n,t){n.uniform4iv(this.addr,t)}function hE(n,t){n.uniform1uiv(this.addr,t)}function uE(n,t){n.uniform2uiv(this.addr,t)}function fE(n,t){n.uniform3uiv(this.addr,t)}function dE(n,t){n.uniform4uiv(this.addr,t)}function pE(n,t,e){let i=this.cache,s=t.length,r=Uu(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Fu(I_):o=P_;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function mE(n,t,e){let i=this.cache,s=t.length,r=Uu(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||N_,r[o])}function gE(n,t,e){let i=this.cache,s=t.length,r=Uu(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Fu(L_):o=U_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function _E(n,t,e){let i=this.cache,s=t.length,r=Uu(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||D_,r[o])}function xE(n){switch(n){case 5126:return Q1;case 35664:return tE;case 35665:return eE;case 35666:return nE;case 35674:return iE;case 35675:return sE;case 35676:return rE;case 5124:case 35670:return oE;case 35667:case 35671:return aE;case 35668:case 35672:return lE;case 35669:case 35673:return cE;case 5125:return hE;case 36294:return uE;case 36295:return fE;case 36296:return dE;case 35678:case 36198:case 36298:case 36306:case 35682:return pE;case 35679:case 36299:case 36307:return mE;case 35680:case 36300:case 36308:case 36293:return gE;case 36289:case 36303:case 36311:case 36292:return _E}}var Mp=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=K1(e.type)}},wp=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=xE(e.type)}},Ep=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},bp=/(\w+)(\])?(\[|\.)?/g;function p_(n,t){n.seq.push(t),n.map[t.id]=t}function yE(n,t,e){let i=n.name,s=i.length;for(bp.lastIndex=0;;){let r=bp.exec(i),o=bp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){p_(e,c===void 0?new Mp(a,n,t):new wp(a,n,t));break}else{let f=e.map[a];f===void 0&&(f=new Ep(a),p_(e,f)),e=f}}}var Ma=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);yE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function m_(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var vE=37297,bE=0;function SE(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var g_=new le;function ME(n){Ee._getMatrix(g_,Ee.workingColorSpace,n);let t=`mat3( ${g_.elements.map(e=>e.toFixed(4))} )`;switch(Ee.getTransfer(n)){case fl:return[t,"LinearTransferOETF"];case Fe:return[t,"sRGBTransferOETF"];default:return Kt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function __(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+SE(n.getShaderSource(t),a)}else return r}function wE(n,t){let e=ME(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var EE={[Xd]:"Linear",[qd]:"Reinhard",[Yd]:"Cineon",[$d]:"ACESFilmic",[Jd]:"AgX",[jd]:"Neutral",[Zd]:"Custom"};function TE(n,t){let e=EE[t];return e===void 0?(Kt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Lu=new B;function AE(){Ee.getLuminanceCoefficients(Lu);let n=Lu.x.toFixed(4),t=Lu.y.toFixed(4),e=Lu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function RE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Vl).join(`
`)}function CE(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function PE(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Vl(n){return n!==""}function x_(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function y_(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var IE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Tp(n){return n.replace(IE,LE)}function LE(n,t){let e=ge[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Tp(e)}var DE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function v_(n){return n.replace(DE,NE)}function NE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function b_(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var UE={[Nl]:"SHADOWMAP_TYPE_PCF",[xa]:"SHADOWMAP_TYPE_VSM"};function FE(n){return UE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OE={[va]:"ENVMAP_MODE_REFRACTION"};function BE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":OE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kE={[Wd]:"ENVMAP_BLENDING_MULTIPLY",[k0]:"ENVMAP_BLENDING_MIX",[z0]:"ENVMAP_BLENDING_ADD"};function zE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kE[n.combine]||"ENVMAP_BLENDING_NONE"}function HE(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=FE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=BE(e),f=zE(e),u=RE(e),d=CE(r),g=s.createProgram(),_,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Vl).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Vl).join(`
`),m.length>0&&(m+=`
`)):(_=[b_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Vl).join(`
`),m=[b_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Os?"#define TONE_MAPPING":"",e.toneMapping!==Os?ge.tonemapping_pars_fragment:"",e.toneMapping!==Os?TE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ge.colorspace_pars_fragment,wE("linearToOutputTexel",e.outputColorSpace),AE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Vl).join(`
`)),o=Tp(o),o=x_(o,e),o=y_(o,e),a=Tp(a),a=x_(a,e),a=y_(a,e),o=v_(o),a=v_(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===fp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===fp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=p+_+o,w=p+m+a,v=m_(s,s.VERTEX_SHADER,y),C=m_(s,s.FRAGMENT_SHADER,w);s.attachShader(g,v),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function S(I){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(v)||"",X=s.getShaderInfoLog(C)||"",U=D.trim(),V=k.trim(),Z=X.trim(),W=!0,ct=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,v,C);else{let $=__(s,v,"vertex"),tt=__(s,C,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+U+`
`+$+`
`+tt)}else U!==""?Kt("WebGLProgram: Program Info Log:",U):(V===""||Z==="")&&(ct=!1);ct&&(I.diagnostics={runnable:W,programLog:U,vertexShader:{log:V,prefix:_},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(v),s.deleteShader(C),x=new Ma(s,g),M=PE(s,g)}let x;this.getUniforms=function(){return x===void 0&&S(this),x};let M;this.getAttributes=function(){return M===void 0&&S(this),M};let F=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(g,vE)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=bE++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=C,this}var GE=0,Ap=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Rp(t),e.set(t,i)),i}},Rp=class{constructor(t){this.id=GE++,this.code=t,this.usedTimes=0}};function VE(n){return n===Br||n===zl||n===Hl}function WE(n,t,e,i,s,r){let o=new ua,a=new Ap,l=new Set,c=[],h=new Map,f=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,M,F,I,D,k){let X=I.fog,U=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,W=t.get(x.envMap||V,Z),ct=u[x.type],$=i.precision;x.precision!==null&&($=i.getMaxPrecision(x.precision),$!==x.precision&&Kt("WebGLProgram.getParameters:",x.precision,"not supported, using",$,"instead."));let tt=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,st=tt!==void 0?tt.length:0,ft=0;U.morphAttributes.position!==void 0&&(ft=1),U.morphAttributes.normal!==void 0&&(ft=2),U.morphAttributes.color!==void 0&&(ft=3);let dt,et,gt,vt;if(ct){let It=ks[ct];dt=It.vertexShader,et=It.fragmentShader}else{dt=x.vertexShader,et=x.fragmentShader;let It=a.getVertexShaderStage(x),de=a.getFragmentShaderStage(x);a.update(x,It,de),gt=It.id,vt=de.id}let Pt=n.getRenderTarget(),wt=n.state.buffers.depth.getReversed(),Zt=D.isInstancedMesh===!0,ue=D.isBatchedMesh===!0,Yt=!!x.map,_e=!!x.matcap,pe=!!W,ce=pe&&W.isPMREMTexture===!0,an=!!x.aoMap,Ze=!!x.lightMap,Tn=!!x.bumpMap&&x.wireframe===!1,Ge=!!x.normalMap,Wn=!!x.displacementMap,Re=!!x.emissiveMap,Nn=!!x.metalnessMap,gn=!!x.roughnessMap,An=x.anisotropy>0,H=x.clearcoat>0,Lt=x.diffuseRoughness>0,te=x.dispersion>0,fe=x.retroreflectivity>0,Et=x.iridescence>0,We=x.sheen>0,Xt=x.transmission>0,jt=An&&!!x.anisotropyMap,P=H&&!!x.clearcoatMap,E=H&&!!x.clearcoatNormalMap,Y=H&&!!x.clearcoatRoughnessMap,ut=Lt&&!!x.diffuseRoughnessMap,at=Et&&!!x.iridescenceMap,xt=Et&&!!x.iridescenceThicknessMap,bt=We&&!!x.sheenColorMap,nt=We&&!!x.sheenRoughnessMap,rt=!!x.specularMap,mt=!!x.specularColorMap,z=!!x.specularIntensityMap,ot=Xt&&!!x.transmissionMap,it=Xt&&!!x.thicknessMap,Tt=!!x.gradientMap,_t=!!x.alphaMap,Mt=x.alphaTest>0,$t=!!x.alphaHash,re=!!x.extensions,ht=Os;x.toneMapped&&(Pt===null||Pt.isXRRenderTarget===!0)&&(ht=n.toneMapping);let Gt=ce?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,oe={shaderID:ct,shaderType:x.type,shaderName:x.name,vertexShader:dt,fragmentShader:et,defines:x.defines,customVertexShaderID:gt,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:$,batching:ue,batchingColor:ue&&D._colorsTexture!==null,instancing:Zt,instancingColor:Zt&&D.instanceColor!==null,instancingMorph:Zt&&D.morphTexture!==null,outputColorSpace:Pt===null?n.outputColorSpace:Pt.isXRRenderTarget===!0?Pt.texture.colorSpace:Ee.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Yt,matcap:_e,envMap:pe,envMapMode:pe&&W.mapping,envMapPMREM:ce,envMapMaxLod:ce?Gt.length-1:null,envMapSize:ce?Gt[0].width:null,aoMap:an,lightMap:Ze,bumpMap:Tn,normalMap:Ge,displacementMap:Wn,emissiveMap:Re,normalMapObjectSpace:Ge&&x.normalMapType===V0,normalMapTangentSpace:Ge&&x.normalMapType===rp,packedNormalMap:Ge&&x.normalMapType===rp&&VE(x.normalMap.format),metalnessMap:Nn,roughnessMap:gn,anisotropy:An,anisotropyMap:jt,clearcoat:H,clearcoatMap:P,clearcoatNormalMap:E,clearcoatRoughnessMap:Y,diffuseRoughness:Lt,diffuseRoughnessMap:ut,dispersion:te,retroreflection:fe,iridescence:Et,iridescenceMap:at,iridescenceThicknessMap:xt,sheen:We,sheenColorMap:bt,sheenRoughnessMap:nt,specularMap:rt,specularColorMap:mt,specularIntensityMap:z,transmission:Xt,transmissionMap:ot,thicknessMap:it,gradientMap:Tt,opaque:x.transparent===!1&&x.blending===ya&&x.alphaToCoverage===!1,alphaMap:_t,alphaTest:Mt,alphaHash:$t,combine:x.combine,mapUv:Yt&&d(x.map.channel),aoMapUv:an&&d(x.aoMap.channel),lightMapUv:Ze&&d(x.lightMap.channel),bumpMapUv:Tn&&d(x.bumpMap.channel),normalMapUv:Ge&&d(x.normalMap.channel),displacementMapUv:Wn&&d(x.displacementMap.channel),emissiveMapUv:Re&&d(x.emissiveMap.channel),metalnessMapUv:Nn&&d(x.metalnessMap.channel),roughnessMapUv:gn&&d(x.roughnessMap.channel),anisotropyMapUv:jt&&d(x.anisotropyMap.channel),clearcoatMapUv:P&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:at&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:bt&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:nt&&d(x.sheenRoughnessMap.channel),specularMapUv:rt&&d(x.specularMap.channel),specularColorMapUv:mt&&d(x.specularColorMap.channel),specularIntensityMapUv:z&&d(x.specularIntensityMap.channel),transmissionMapUv:ot&&d(x.transmissionMap.channel),thicknessMapUv:it&&d(x.thicknessMap.channel),alphaMapUv:_t&&d(x.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ge||An),vertexNormals:!!U.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!U.attributes.uv&&(Yt||_t),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||U.attributes.normal===void 0&&Ge===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:wt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:ft,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:k.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ht,decodeVideoTexture:Yt&&x.map.isVideoTexture===!0&&Ee.getTransfer(x.map.colorSpace)===Fe,decodeVideoTextureEmissive:Re&&x.emissiveMap.isVideoTexture===!0&&Ee.getTransfer(x.emissiveMap.colorSpace)===Fe,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ei,flipSided:x.side===bi,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:re&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(re&&x.extensions.multiDraw===!0||ue)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return oe.vertexUv1s=l.has(1),oe.vertexUv2s=l.has(2),oe.vertexUv3s=l.has(3),l.clear(),oe}function _(x){let M=[];if(x.shaderID?M.push(x.shaderID):(M.push(x.customVertexShaderID),M.push(x.customFragmentShaderID)),x.defines!==void 0)for(let F in x.defines)M.push(F),M.push(x.defines[F]);return x.isRawShaderMaterial===!1&&(m(M,x),p(M,x),M.push(n.outputColorSpace)),M.push(x.customProgramCacheKey),M.join()}function m(x,M){x.push(M.precision),x.push(M.outputColorSpace),x.push(M.envMapMode),x.push(M.envMapPMREM),x.push(M.envMapMaxLod),x.push(M.envMapSize),x.push(M.mapUv),x.push(M.alphaMapUv),x.push(M.lightMapUv),x.push(M.aoMapUv),x.push(M.bumpMapUv),x.push(M.normalMapUv),x.push(M.displacementMapUv),x.push(M.emissiveMapUv),x.push(M.metalnessMapUv),x.push(M.roughnessMapUv),x.push(M.anisotropyMapUv),x.push(M.clearcoatMapUv),x.push(M.clearcoatNormalMapUv),x.push(M.clearcoatRoughnessMapUv),x.push(M.diffuseRoughnessMapUv),x.push(M.iridescenceMapUv),x.push(M.iridescenceThicknessMapUv),x.push(M.sheenColorMapUv),x.push(M.sheenRoughnessMapUv),x.push(M.specularMapUv),x.push(M.specularColorMapUv),x.push(M.specularIntensityMapUv),x.push(M.transmissionMapUv),x.push(M.thicknessMapUv),x.push(M.combine),x.push(M.fogExp2),x.push(M.sizeAttenuation),x.push(M.morphTargetsCount),x.push(M.numSunLights),x.push(M.numDirLights),x.push(M.numPointLights),x.push(M.numSpotLights),x.push(M.numSpotLightMaps),x.push(M.numHemiLights),x.push(M.numRectAreaLights),x.push(M.numSunLightShadows),x.push(M.numDirLightShadows),x.push(M.numPointLightShadows),x.push(M.numSpotLightShadows),x.push(M.numSpotLightShadowsWithMaps),x.push(M.numLightProbes),x.push(M.numLightProbeGrids),x.push(M.shadowMapType),x.push(M.toneMapping),x.push(M.numClippingPlanes),x.push(M.numClipIntersection),x.push(M.depthPacking)}function p(x,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let M=u[x.type],F;if(M){let I=ks[M];F=n_.clone(I.uniforms)}else F=x.uniforms;return F}function w(x,M){let F=h.get(M);return F!==void 0?++F.usedTimes:(F=new HE(n,M,x,s),c.push(F),h.set(M,F)),F}function v(x){if(--x.usedTimes===0){let M=c.indexOf(x);c[M]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function S(){a.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:y,acquireProgram:w,releaseProgram:v,releaseShaderCache:C,programs:c,dispose:S}}function XE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function qE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function S_(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function M_(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let d=0;return u.isInstancedMesh&&(d+=2),u.isSkinnedMesh&&(d+=1),d}function a(u,d,g,_,m,p){let y=n[t];return y===void 0?(y={id:u.id,object:u,geometry:d,material:g,materialVariant:o(u),groupOrder:_,renderOrder:u.renderOrder,z:m,group:p},n[t]=y):(y.id=u.id,y.object=u,y.geometry=d,y.material=g,y.materialVariant=o(u),y.groupOrder=_,y.renderOrder=u.renderOrder,y.z=m,y.group=p),t++,y}function l(u,d,g,_,m,p,y){y.reversedDepth===!0&&(m=-m);let w=a(u,d,g,_,m,p);g.transmission>0?i.push(w):g.transparent===!0?s.push(w):e.push(w)}function c(u,d,g,_,m,p){let y=a(u,d,g,_,m,p);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):e.unshift(y)}function h(u,d){e.length>1&&e.sort(u||qE),i.length>1&&i.sort(d||S_),s.length>1&&s.sort(d||S_)}function f(){for(let u=t,d=n.length;u<d;u++){let g=n[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:h}}function YE(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new M_,n.set(i,[o])):s>=r.length?(o=new M_,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function $E(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new B,color:new Qt};break;case"SpotLight":e={position:new B,direction:new B,color:new Qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new Qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new Qt,groundColor:new Qt};break;case"RectAreaLight":e={color:new Qt,position:new B,halfWidth:new B,halfHeight:new B};break}return n[t.id]=e,e}}}function ZE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var JE=0;function jE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function KE(n){let t=new $E,e=ZE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);let s=new B,r=new Me,o=new Me;function a(c){let h=0,f=0,u=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,g=0,_=0,m=0,p=0,y=0,w=0,v=0,C=0,S=0,x=0,M=0,F=0,I=0;c.sort(jE);for(let k=0,X=c.length;k<X;k++){let U=c[k],V=U.color,Z=U.intensity,W=U.distance,ct=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Br?ct=U.shadow.map.texture:ct=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=V.r*Z,f+=V.g*Z,u+=V.b*Z;else if(U.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(U.sh.coefficients[$],Z);I++}else if(U.isSunLight){let $=t.get(U);if($.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let tt=U.shadow,st=e.get(U);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),i.sunShadow[g]=st,i.sunShadowMap[g]=ct;let ft=tt.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[_+dt]=tt.getMatrix(dt),i.sunShadowCascade[_+dt]=tt._cascadeData[dt];_+=ft,g++}i.sun[d]=$,d++}else if(U.isDirectionalLight){let $=t.get(U);if($.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let tt=U.shadow,st=e.get(U);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize=tt.mapSize,i.directionalShadow[m]=st,i.directionalShadowMap[m]=ct,i.directionalShadowMatrix[m]=U.shadow.matrix,C++}i.directional[m]=$,m++}else if(U.isSpotLight){let $=t.get(U);$.position.setFromMatrixPosition(U.matrixWorld),$.color.copy(V).multiplyScalar(Z),$.distance=W,$.coneCos=Math.cos(U.angle),$.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),$.decay=U.decay,i.spot[y]=$;let tt=U.shadow;if(U.map&&(i.spotLightMap[M]=U.map,M++,tt.updateMatrices(U),U.castShadow&&F++),i.spotLightMatrix[y]=tt.matrix,U.castShadow){let st=e.get(U);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize=tt.mapSize,i.spotShadow[y]=st,i.spotShadowMap[y]=ct,x++}y++}else if(U.isRectAreaLight){let $=t.get(U);$.color.copy(V).multiplyScalar(Z),$.halfWidth.set(U.width*.5,0,0),$.halfHeight.set(0,U.height*.5,0),i.rectArea[w]=$,w++}else if(U.isPointLight){let $=t.get(U);if($.color.copy(U.color).multiplyScalar(U.intensity),$.distance=U.distance,$.decay=U.decay,U.castShadow){let tt=U.shadow,st=e.get(U);st.shadowIntensity=tt.intensity,st.shadowBias=tt.bias,st.shadowNormalBias=tt.normalBias,st.shadowRadius=tt.radius,st.shadowMapSize=tt.mapSize,st.shadowCameraNear=tt.camera.near,st.shadowCameraFar=tt.camera.far,i.pointShadow[p]=st,i.pointShadowMap[p]=ct,i.pointShadowMatrix[p]=U.shadow.matrix,S++}i.point[p]=$,p++}else if(U.isHemisphereLight){let $=t.get(U);$.skyColor.copy(U.color).multiplyScalar(Z),$.groundColor.copy(U.groundColor).multiplyScalar(Z),i.hemi[v]=$,v++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ut.LTC_FLOAT_1,i.rectAreaLTC2=Ut.LTC_FLOAT_2):(i.rectAreaLTC1=Ut.LTC_HALF_1,i.rectAreaLTC2=Ut.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=u;let D=i.hash;(D.sunLength!==d||D.directionalLength!==m||D.pointLength!==p||D.spotLength!==y||D.rectAreaLength!==w||D.hemiLength!==v||D.numSunShadows!==g||D.numDirectionalShadows!==C||D.numPointShadows!==S||D.numSpotShadows!==x||D.numSpotMaps!==M||D.numLightProbes!==I)&&(i.sun.length=d,i.directional.length=m,i.spot.length=y,i.rectArea.length=w,i.point.length=p,i.hemi.length=v,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=S,i.pointShadowMap.length=S,i.pointShadowMatrix.length=S,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+M-F,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=I,D.sunLength=d,D.directionalLength=m,D.pointLength=p,D.spotLength=y,D.rectAreaLength=w,D.hemiLength=v,D.numSunShadows=g,D.numDirectionalShadows=C,D.numPointShadows=S,D.numSpotShadows=x,D.numSpotMaps=M,D.numLightProbes=I,i.version=JE++)}function l(c,h){let f=0,u=0,d=0,g=0,_=0,m=0,p=h.matrixWorldInverse;for(let y=0,w=c.length;y<w;y++){let v=c[y];if(v.isSunLight){let C=i.sun[f];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(p),f++}else if(v.isDirectionalLight){let C=i.directional[u];C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),u++}else if(v.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(v.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(v.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(v.width*.5,0,0),C.halfHeight.set(0,v.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),d++}else if(v.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function w_(n){let t=new KE(n),e=[],i=[],s=[];function r(f){h.camera=f,e.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):e.push(f)}function a(f){i.push(f)}function l(){t.setup(e),s.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function c(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QE(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new w_(n),t.set(s,[a])):r>=o.length?(a=new w_(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var tT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eT=`uniform sampler2D shadow_pass;
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
}`,nT=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],iT=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],E_=new Me,Gl=new B,Sp=new B;function sT(n,t,e){let i=new io,s=new qt,r=new qt,o=new dn,a=new Ch,l=new Ph,c={},h=e.maxTextureSize,f={[Or]:bi,[bi]:Or,[Ei]:Ei},u=new $i({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qt},radius:{value:4}},vertexShader:tT,fragmentShader:eT}),d=u.clone();d.defines.HORIZONTAL_PASS=1;let g=new Ce;g.setAttribute("position",new sn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ft(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Nl;let p=this.type;this.render=function(S,x,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||S.length===0)return;this.type===v0&&(Kt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Nl);let F=n.getRenderTarget(),I=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),k=n.state;k.setBlending(co),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let X=p!==this.type;X&&x.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(V=>V.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,V=S.length;U<V;U++){let Z=S[U],W=Z.shadow;if(W===void 0){Kt("WebGLShadowMap:",Z,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ct=W.getFrameExtents();s.multiply(ct),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,W.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=$,W.map===null||X===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===xa){if(Z.isPointLight){Kt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new Oi(s.x,s.y,{format:Br,type:ds,minFilter:xi,magFilter:xi,generateMipmaps:!1}),W.map.texture.name=Z.name+".shadowMap",W.map.depthTexture=new lr(s.x,s.y,Zi),W.map.depthTexture.name=Z.name+".shadowMapDepth",W.map.depthTexture.format=or,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Jn,W.map.depthTexture.magFilter=Jn}else Z.isPointLight?(W.map=new Wl(s.x),W.map.depthTexture=new Al(s.x,fs)):(W.map=new Oi(s.x,s.y),W.map.depthTexture=new lr(s.x,s.y,fs)),W.map.depthTexture.name=Z.name+".shadowMap",W.map.depthTexture.format=or,this.type===Nl?(W.map.depthTexture.compareFunction=$?cp:lp,W.map.depthTexture.minFilter=xi,W.map.depthTexture.magFilter=xi):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Jn,W.map.depthTexture.magFilter=Jn);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let tt=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Z.isPointLight!==!0&&W.updateMatrices(Z,M);let st=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:M.layers;for(let ft=0;ft<tt;ft++){let dt=W.getCamera(ft);if(Z.isPointLight){let et=W.camera,gt=W.matrix,vt=Z.distance||et.far;vt!==et.far&&(et.far=vt,et.updateProjectionMatrix()),Gl.setFromMatrixPosition(Z.matrixWorld),et.position.copy(Gl),Sp.copy(et.position),Sp.add(nT[ft]),et.up.copy(iT[ft]),et.lookAt(Sp),et.updateMatrixWorld(),gt.makeTranslation(-Gl.x,-Gl.y,-Gl.z),E_.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),W._frustum.setFromProjectionMatrix(E_,et.coordinateSystem,et.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(W.map),n.clear());let et=W.getViewport(ft);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),k.viewport(o)}i=W.getFrustum(ft),v(x,M,dt,Z,st,this.type)}W.isPointLightShadow!==!0&&this.type===xa&&y(W,M),W.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(F,I,D)};function y(S,x){let M=t.update(_);u.defines.VSM_SAMPLES!==S.blurSamples&&(u.defines.VSM_SAMPLES=S.blurSamples,d.defines.VSM_SAMPLES=S.blurSamples,u.needsUpdate=!0,d.needsUpdate=!0),S.mapPass===null?S.mapPass=new Oi(s.x,s.y,{format:Br,type:ds}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),u.uniforms.shadow_pass.value=S.map.depthTexture,u.uniforms.resolution.value.set(S.map.width,S.map.height),u.uniforms.radius.value=S.radius,n.setRenderTarget(S.mapPass),n.clear(),n.renderBufferDirect(x,null,M,u,_,null),d.uniforms.shadow_pass.value=S.mapPass.texture,d.uniforms.resolution.value.set(S.map.width,S.map.height),d.uniforms.radius.value=S.radius,n.setRenderTarget(S.map),n.clear(),n.renderBufferDirect(x,null,M,d,_,null)}function w(S,x,M,F){let I=null,D=M.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(D!==void 0)I=D;else if(I=M.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let k=I.uuid,X=x.uuid,U=c[k];U===void 0&&(U={},c[k]=U);let V=U[X];V===void 0&&(V=I.clone(),U[X]=V,x.addEventListener("dispose",C)),I=V}if(I.visible=x.visible,I.wireframe=x.wireframe,F===xa?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:f[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,M.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let k=n.properties.get(I);k.light=M}return I}function v(S,x,M,F,I,D){if(S.visible===!1)return;if(S.layers.test(I)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&D===xa)&&(!S.frustumCulled||S.intersectsFrustum(i))){S.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,S.matrixWorld);let U=t.update(S),V=S.material;if(Array.isArray(V)){let Z=U.groups;for(let W=0,ct=Z.length;W<ct;W++){let $=Z[W],tt=V[$.materialIndex];if(tt&&tt.visible){let st=w(S,tt,F,D);S.onBeforeShadow(n,S,x,M,U,st,$),n.renderBufferDirect(M,null,U,st,S,$),S.onAfterShadow(n,S,x,M,U,st,$)}}}else if(V.visible){let Z=w(S,V,F,D);S.onBeforeShadow(n,S,x,M,U,Z,null),n.renderBufferDirect(M,null,U,Z,S,null),S.onAfterShadow(n,S,x,M,U,Z,null)}}let X=S.children;for(let U=0,V=X.length;U<V;U++)v(X[U],x,M,F,I,D)}function C(S){S.target.removeEventListener("dispose",C);for(let M in c){let F=c[M],I=S.target.uuid;I in F&&(F[I].dispose(),delete F[I])}}}function rT(n,t){function e(){let z=!1,ot=new dn,it=null,Tt=new dn(0,0,0,0);return{setMask:function(_t){it!==_t&&!z&&(n.colorMask(_t,_t,_t,_t),it=_t)},setLocked:function(_t){z=_t},setClear:function(_t,Mt,$t,re,ht){ht===!0&&(_t*=re,Mt*=re,$t*=re),ot.set(_t,Mt,$t,re),Tt.equals(ot)===!1&&(n.clearColor(_t,Mt,$t,re),Tt.copy(ot))},reset:function(){z=!1,it=null,Tt.set(-1,0,0,0)}}}function i(){let z=!1,ot=!1,it=null,Tt=null,_t=null;return{setReversed:function(Mt){if(ot!==Mt){let $t=t.get("EXT_clip_control");Mt?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),ot=Mt;let re=_t;_t=null,this.setClear(re)}},getReversed:function(){return ot},setTest:function(Mt){Mt?wt(n.DEPTH_TEST):Zt(n.DEPTH_TEST)},setMask:function(Mt){it!==Mt&&!z&&(n.depthMask(Mt),it=Mt)},setFunc:function(Mt){if(ot&&(Mt=Q0[Mt]),Tt!==Mt){switch(Mt){case uh:n.depthFunc(n.NEVER);break;case fh:n.depthFunc(n.ALWAYS);break;case dh:n.depthFunc(n.LESS);break;case aa:n.depthFunc(n.LEQUAL);break;case ph:n.depthFunc(n.EQUAL);break;case mh:n.depthFunc(n.GEQUAL);break;case gh:n.depthFunc(n.GREATER);break;case _h:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Tt=Mt}},setLocked:function(Mt){z=Mt},setClear:function(Mt){_t!==Mt&&(_t=Mt,ot&&(Mt=1-Mt),n.clearDepth(Mt))},reset:function(){z=!1,it=null,Tt=null,_t=null,ot=!1}}}function s(){let z=!1,ot=null,it=null,Tt=null,_t=null,Mt=null,$t=null,re=null,ht=null;return{setTest:function(Gt){z||(Gt?wt(n.STENCIL_TEST):Zt(n.STENCIL_TEST))},setMask:function(Gt){ot!==Gt&&!z&&(n.stencilMask(Gt),ot=Gt)},setFunc:function(Gt,oe,It){(it!==Gt||Tt!==oe||_t!==It)&&(n.stencilFunc(Gt,oe,It),it=Gt,Tt=oe,_t=It)},setOp:function(Gt,oe,It){(Mt!==Gt||$t!==oe||re!==It)&&(n.stencilOp(Gt,oe,It),Mt=Gt,$t=oe,re=It)},setLocked:function(Gt){z=Gt},setClear:function(Gt){ht!==Gt&&(n.clearStencil(Gt),ht=Gt)},reset:function(){z=!1,ot=null,it=null,Tt=null,_t=null,Mt=null,$t=null,re=null,ht=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},f={},u={},d=new WeakMap,g=[],_=null,m=!1,p=null,y=null,w=null,v=null,C=null,S=null,x=null,M=new Qt(0,0,0),F=0,I=!1,D=null,k=null,X=null,U=null,V=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ct=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec($)[1]),W=ct>=1):$.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),W=ct>=2);let tt=null,st={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),et=new dn().fromArray(ft),gt=new dn().fromArray(dt);function vt(z,ot,it,Tt){let _t=new Uint8Array(4),Mt=n.createTexture();n.bindTexture(z,Mt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $t=0;$t<it;$t++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,Tt,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(ot+$t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return Mt}let Pt={};Pt[n.TEXTURE_2D]=vt(n.TEXTURE_2D,n.TEXTURE_2D,1),Pt[n.TEXTURE_CUBE_MAP]=vt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pt[n.TEXTURE_2D_ARRAY]=vt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pt[n.TEXTURE_3D]=vt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(n.DEPTH_TEST),o.setFunc(aa),Tn(!1),Ge(Bd),wt(n.CULL_FACE),an(co);function wt(z){h[z]!==!0&&(n.enable(z),h[z]=!0)}function Zt(z){h[z]!==!1&&(n.disable(z),h[z]=!1)}function ue(z,ot){return u[z]!==ot?(n.bindFramebuffer(z,ot),u[z]=ot,z===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=ot),z===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function Yt(z,ot){let it=g,Tt=!1;if(z){it=d.get(ot),it===void 0&&(it=[],d.set(ot,it));let _t=z.textures;if(it.length!==_t.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Mt=0,$t=_t.length;Mt<$t;Mt++)it[Mt]=n.COLOR_ATTACHMENT0+Mt;it.length=_t.length,Tt=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Tt=!0);Tt&&n.drawBuffers(it)}function _e(z){return _!==z?(n.useProgram(z),_=z,!0):!1}let pe={[ho]:n.FUNC_ADD,[S0]:n.FUNC_SUBTRACT,[M0]:n.FUNC_REVERSE_SUBTRACT};pe[w0]=n.MIN,pe[E0]=n.MAX;let ce={[T0]:n.ZERO,[A0]:n.ONE,[R0]:n.SRC_COLOR,[Gd]:n.SRC_ALPHA,[N0]:n.SRC_ALPHA_SATURATE,[L0]:n.DST_COLOR,[P0]:n.DST_ALPHA,[C0]:n.ONE_MINUS_SRC_COLOR,[Vd]:n.ONE_MINUS_SRC_ALPHA,[D0]:n.ONE_MINUS_DST_COLOR,[I0]:n.ONE_MINUS_DST_ALPHA,[U0]:n.CONSTANT_COLOR,[F0]:n.ONE_MINUS_CONSTANT_COLOR,[O0]:n.CONSTANT_ALPHA,[B0]:n.ONE_MINUS_CONSTANT_ALPHA};function an(z,ot,it,Tt,_t,Mt,$t,re,ht,Gt){if(z===co){m===!0&&(Zt(n.BLEND),m=!1);return}if(m===!1&&(wt(n.BLEND),m=!0),z!==b0){if(z!==p||Gt!==I){if((y!==ho||C!==ho)&&(n.blendEquation(n.FUNC_ADD),y=ho,C=ho),Gt)switch(z){case ya:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case kd:n.blendFunc(n.ONE,n.ONE);break;case zd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Hd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:se("WebGLState: Invalid blending: ",z);break}else switch(z){case ya:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case kd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case zd:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hd:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",z);break}w=null,v=null,S=null,x=null,M.set(0,0,0),F=0,p=z,I=Gt}return}_t=_t||ot,Mt=Mt||it,$t=$t||Tt,(ot!==y||_t!==C)&&(n.blendEquationSeparate(pe[ot],pe[_t]),y=ot,C=_t),(it!==w||Tt!==v||Mt!==S||$t!==x)&&(n.blendFuncSeparate(ce[it],ce[Tt],ce[Mt],ce[$t]),w=it,v=Tt,S=Mt,x=$t),(re.equals(M)===!1||ht!==F)&&(n.blendColor(re.r,re.g,re.b,ht),M.copy(re),F=ht),p=z,I=!1}function Ze(z,ot){z.side===Ei?Zt(n.CULL_FACE):wt(n.CULL_FACE);let it=z.side===bi;ot&&(it=!it),Tn(it),z.blending===ya&&z.transparent===!1?an(co):an(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Tt=z.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),Re(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?wt(n.SAMPLE_ALPHA_TO_COVERAGE):Zt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Tn(z){D!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),D=z)}function Ge(z){z!==x0?(wt(n.CULL_FACE),z!==k&&(z===Bd?n.cullFace(n.BACK):z===y0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Zt(n.CULL_FACE),k=z}function Wn(z){z!==X&&(W&&n.lineWidth(z),X=z)}function Re(z,ot,it){z?(wt(n.POLYGON_OFFSET_FILL),(U!==ot||V!==it)&&(U=ot,V=it,o.getReversed()&&(ot=-ot,it=-it),n.polygonOffset(ot,it))):Zt(n.POLYGON_OFFSET_FILL)}function Nn(z){z?wt(n.SCISSOR_TEST):Zt(n.SCISSOR_TEST)}function gn(z){z===void 0&&(z=n.TEXTURE0+Z-1),tt!==z&&(n.activeTexture(z),tt=z)}function An(z,ot,it){it===void 0&&(tt===null?it=n.TEXTURE0+Z-1:it=tt);let Tt=st[it];Tt===void 0&&(Tt={type:void 0,texture:void 0},st[it]=Tt),(Tt.type!==z||Tt.texture!==ot)&&(tt!==it&&(n.activeTexture(it),tt=it),n.bindTexture(z,ot||Pt[z]),Tt.type=z,Tt.texture=ot)}function H(){let z=st[tt];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Lt(){try{n.compressedTexImage2D(...arguments)}catch(z){se("WebGLState:",z)}}function te(){try{n.compressedTexImage3D(...arguments)}catch(z){se("WebGLState:",z)}}function fe(){try{n.texSubImage2D(...arguments)}catch(z){se("WebGLState:",z)}}function Et(){try{n.texSubImage3D(...arguments)}catch(z){se("WebGLState:",z)}}function We(){try{n.compressedTexSubImage2D(...arguments)}catch(z){se("WebGLState:",z)}}function Xt(){try{n.compressedTexSubImage3D(...arguments)}catch(z){se("WebGLState:",z)}}function jt(){try{n.texStorage2D(...arguments)}catch(z){se("WebGLState:",z)}}function P(){try{n.texStorage3D(...arguments)}catch(z){se("WebGLState:",z)}}function E(){try{n.texImage2D(...arguments)}catch(z){se("WebGLState:",z)}}function Y(){try{n.texImage3D(...arguments)}catch(z){se("WebGLState:",z)}}function ut(z){return f[z]!==void 0?f[z]:n.getParameter(z)}function at(z,ot){f[z]!==ot&&(n.pixelStorei(z,ot),f[z]=ot)}function xt(z){et.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),et.copy(z))}function bt(z){gt.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),gt.copy(z))}function nt(z,ot){let it=c.get(ot);it===void 0&&(it=new WeakMap,c.set(ot,it));let Tt=it.get(z);Tt===void 0&&(Tt=n.getUniformBlockIndex(ot,z.name),n.uniformBlockBinding(ot,Tt,Tt),it.set(z,Tt))}function rt(z,ot,it){let _t=c.get(ot).get(z);l[_t]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,it),l[_t]=it)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},f={},tt=null,st={},u={},l={},d=new WeakMap,g=[],_=null,m=!1,p=null,y=null,w=null,v=null,C=null,S=null,x=null,M=new Qt(0,0,0),F=0,I=!1,D=null,k=null,X=null,U=null,V=null,et.set(0,0,n.canvas.width,n.canvas.height),gt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:Zt,bindFramebuffer:ue,drawBuffers:Yt,useProgram:_e,setBlending:an,setMaterial:Ze,setFlipSided:Tn,setCullFace:Ge,setLineWidth:Wn,setPolygonOffset:Re,setScissorTest:Nn,activeTexture:gn,bindTexture:An,unbindTexture:H,compressedTexImage2D:Lt,compressedTexImage3D:te,texImage2D:E,texImage3D:Y,pixelStorei:at,getParameter:ut,updateUBOMapping:nt,uniformBlockBinding:rt,texStorage2D:jt,texStorage3D:P,texSubImage2D:fe,texSubImage3D:Et,compressedTexSubImage2D:We,compressedTexSubImage3D:Xt,scissor:xt,viewport:bt,reset:mt}}function oT(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new qt,h=new WeakMap,f=new Set,u,d=new WeakMap,g=new Set,_=new FinalizationRegistry(P=>g.delete(P)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(P,E){return m?new OffscreenCanvas(P,E):pl("canvas")}function y(P,E,Y){let ut=1,at=jt(P);if((at.width>Y||at.height>Y)&&(ut=Y/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let xt=Math.floor(ut*at.width),bt=Math.floor(ut*at.height);u===void 0&&(u=p(xt,bt));let nt=E?p(xt,bt):u;return nt.width=xt,nt.height=bt,nt.getContext("2d").drawImage(P,0,0,xt,bt),Kt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+xt+"x"+bt+")."),nt}else return"data"in P&&Kt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),P;return P}function w(P){return P.generateMipmaps}function v(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(P,E,Y,ut,at,xt=!1){if(P!==null){if(n[P]!==void 0)return n[P];Kt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let bt;ut&&(bt=t.get("EXT_texture_norm16"),bt||Kt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=E;if(E===n.RED&&(Y===n.FLOAT&&(nt=n.R32F),Y===n.HALF_FLOAT&&(nt=n.R16F),Y===n.UNSIGNED_BYTE&&(nt=n.R8),Y===n.UNSIGNED_SHORT&&bt&&(nt=bt.R16_EXT),Y===n.SHORT&&bt&&(nt=bt.R16_SNORM_EXT)),E===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.R8UI),Y===n.UNSIGNED_SHORT&&(nt=n.R16UI),Y===n.UNSIGNED_INT&&(nt=n.R32UI),Y===n.BYTE&&(nt=n.R8I),Y===n.SHORT&&(nt=n.R16I),Y===n.INT&&(nt=n.R32I)),E===n.RG&&(Y===n.FLOAT&&(nt=n.RG32F),Y===n.HALF_FLOAT&&(nt=n.RG16F),Y===n.UNSIGNED_BYTE&&(nt=n.RG8),Y===n.UNSIGNED_SHORT&&bt&&(nt=bt.RG16_EXT),Y===n.SHORT&&bt&&(nt=bt.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RG8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RG16UI),Y===n.UNSIGNED_INT&&(nt=n.RG32UI),Y===n.BYTE&&(nt=n.RG8I),Y===n.SHORT&&(nt=n.RG16I),Y===n.INT&&(nt=n.RG32I)),E===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),Y===n.UNSIGNED_INT&&(nt=n.RGB32UI),Y===n.BYTE&&(nt=n.RGB8I),Y===n.SHORT&&(nt=n.RGB16I),Y===n.INT&&(nt=n.RGB32I)),E===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),Y===n.UNSIGNED_INT&&(nt=n.RGBA32UI),Y===n.BYTE&&(nt=n.RGBA8I),Y===n.SHORT&&(nt=n.RGBA16I),Y===n.INT&&(nt=n.RGBA32I)),E===n.RGB&&(Y===n.UNSIGNED_SHORT&&bt&&(nt=bt.RGB16_EXT),Y===n.SHORT&&bt&&(nt=bt.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),E===n.RGBA){let rt=xt?fl:Ee.getTransfer(at);Y===n.FLOAT&&(nt=n.RGBA32F),Y===n.HALF_FLOAT&&(nt=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(nt=rt===Fe?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&bt&&(nt=bt.RGBA16_EXT),Y===n.SHORT&&bt&&(nt=bt.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function x(P,E){let Y;return P?E===null||E===fs||E===fo?Y=n.DEPTH24_STENCIL8:E===Zi?Y=n.DEPTH32F_STENCIL8:E===ba&&(Y=n.DEPTH24_STENCIL8,Kt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===fs||E===fo?Y=n.DEPTH_COMPONENT24:E===Zi?Y=n.DEPTH_COMPONENT32F:E===ba&&(Y=n.DEPTH_COMPONENT16),Y}function M(P,E){return w(P)===!0||P.isFramebufferTexture&&P.minFilter!==Jn&&P.minFilter!==xi?Math.log2(Math.max(E.width,E.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?E.mipmaps.length:1}function F(P){let E=new WeakRef(P);i.get(P).__ref=E,g.add(E),_.register(P,E,E)}function I(P){let E=i.get(P).__ref;E!==void 0&&(g.delete(E),_.unregister(E))}function D(P){X(P.target)}function k(P){U(P.target)}function X(P){P.removeEventListener("dispose",D),I(P),Z(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&f.delete(P)}function U(P){P.removeEventListener("dispose",k),I(P),ct(P)}function V(){for(let P of g){let E=P.deref();E!==void 0&&(E.isRenderTarget===!0?U(E):X(E))}g.clear(),f.clear()}function Z(P){let E=i.get(P);if(E.__webglInit===void 0)return;let Y=P.source,ut=d.get(Y);if(ut){let at=ut[E.__cacheKey];at.usedTimes--,at.usedTimes===0&&W(P),Object.keys(ut).length===0&&d.delete(Y)}i.remove(P)}function W(P){let E=i.get(P);n.deleteTexture(E.__webglTexture);let Y=P.source,ut=d.get(Y);delete ut[E.__cacheKey],o.memory.textures--}function ct(P){let E=i.get(P);E.__depthDisposeCallback&&E.__depthDisposeCallback();let Y=P.depthTexture;if(Y&&Y.renderTarget===P&&X(Y),P.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(E.__webglFramebuffer[at]))for(let xt=0;xt<E.__webglFramebuffer[at].length;xt++)n.deleteFramebuffer(E.__webglFramebuffer[at][xt]);else n.deleteFramebuffer(E.__webglFramebuffer[at]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[at])}else{if(Array.isArray(E.__webglFramebuffer))for(let at=0;at<E.__webglFramebuffer.length;at++)n.deleteFramebuffer(E.__webglFramebuffer[at]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let at=0;at<E.__webglColorRenderbuffer.length;at++)E.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[at]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ut=P.textures;for(let at=0,xt=ut.length;at<xt;at++){let bt=i.get(ut[at]);bt.__webglTexture&&(n.deleteTexture(bt.__webglTexture),o.memory.textures--),i.remove(ut[at])}i.remove(P)}let $=0;function tt(){$=0}function st(){return $}function ft(P){$=P}function dt(){let P=$;return P>=s.maxTextures&&Kt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,P}function et(P){let E=[];return E.push(P.wrapS),E.push(P.wrapT),E.push(P.wrapR||0),E.push(P.magFilter),E.push(P.minFilter),E.push(P.anisotropy),E.push(P.internalFormat),E.push(P.format),E.push(P.type),E.push(P.generateMipmaps),E.push(P.mipmapsAutoUpdate),E.push(P.premultiplyAlpha),E.push(P.flipY),E.push(P.unpackAlignment),E.push(P.colorSpace),E.join()}function gt(P,E){let Y=i.get(P);if(P.isVideoTexture&&We(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&Y.__version!==P.version){let ut=P.image;if(ut===null)Kt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Kt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ze(Y,P,E);return}}else P.isExternalTexture&&(Y.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+E)}function vt(P,E){let Y=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){Ze(Y,P,E);return}else P.isExternalTexture&&(Y.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+E)}function Pt(P,E){let Y=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){Ze(Y,P,E);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+E)}function wt(P,E){let Y=i.get(P);if(P.version>0&&Y.__version!==P.version){Tn(Y,P,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+E)}let Zt={[xh]:n.REPEAT,[Ls]:n.CLAMP_TO_EDGE,[yh]:n.MIRRORED_REPEAT},ue={[Jn]:n.NEAREST,[H0]:n.NEAREST_MIPMAP_NEAREST,[Ul]:n.NEAREST_MIPMAP_LINEAR,[xi]:n.LINEAR,[Xh]:n.LINEAR_MIPMAP_NEAREST,[hr]:n.LINEAR_MIPMAP_LINEAR},Yt={[X0]:n.NEVER,[hp]:n.ALWAYS,[q0]:n.LESS,[lp]:n.LEQUAL,[Y0]:n.EQUAL,[cp]:n.GEQUAL,[$0]:n.GREATER,[Z0]:n.NOTEQUAL};function _e(P,E){if(E.type===Zi&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===xi||E.magFilter===Xh||E.magFilter===Ul||E.magFilter===hr||E.minFilter===xi||E.minFilter===Xh||E.minFilter===Ul||E.minFilter===hr)&&Kt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Zt[E.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Zt[E.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Zt[E.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ue[E.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ue[E.minFilter]),E.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Yt[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Jn||E.minFilter!==Ul&&E.minFilter!==hr||E.type===Zi&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function pe(P,E){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,E.addEventListener("dispose",D),F(E));let ut=E.source,at=d.get(ut);at===void 0&&(at={},d.set(ut,at));let xt=et(E);if(xt!==P.__cacheKey){at[xt]===void 0&&(at[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[xt].usedTimes++;let bt=at[P.__cacheKey];bt!==void 0&&(at[P.__cacheKey].usedTimes--,bt.usedTimes===0&&W(E)),P.__cacheKey=xt,P.__webglTexture=at[xt].texture}return Y}function ce(P,E,Y){return Math.floor(Math.floor(P/Y)/E)}function an(P,E,Y,ut){let xt=P.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,Y,ut,E.data);else{xt.sort((z,ot)=>z.start-ot.start);let bt=0;for(let z=1;z<xt.length;z++){let ot=xt[bt],it=xt[z],Tt=ot.start+ot.count,_t=ce(it.start,E.width,4),Mt=ce(ot.start,E.width,4);it.start<=Tt+1&&_t===Mt&&ce(it.start+it.count-1,E.width,4)===_t?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++bt,xt[bt]=it)}xt.length=bt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let z=0,ot=xt.length;z<ot;z++){let it=xt[z],Tt=Math.floor(it.start/4),_t=Math.ceil(it.count/4),Mt=Tt%E.width,$t=Math.floor(Tt/E.width),re=_t,ht=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(n.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(n.TEXTURE_2D,0,Mt,$t,re,ht,Y,ut,E.data)}P.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ze(P,E,Y){let ut=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ut=n.TEXTURE_3D);let at=pe(P,E),xt=E.source;e.bindTexture(ut,P.__webglTexture,n.TEXTURE0+Y);let bt=i.get(xt);if(xt.version!==bt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ht=Ee.getPrimaries(Ee.workingColorSpace),Gt=E.colorSpace===fr?null:Ee.getPrimaries(E.colorSpace),oe=E.colorSpace===fr||ht===Gt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,oe)}e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let rt=y(E.image,!1,s.maxTextureSize);rt=Xt(E,rt);let mt=r.convert(E.format,E.colorSpace),z=r.convert(E.type),ot=S(E.internalFormat,mt,z,E.normalized,E.colorSpace,E.isVideoTexture);_e(ut,E);let it,Tt=E.mipmaps,_t=E.isVideoTexture!==!0,Mt=bt.__version===void 0||at===!0,$t=xt.dataReady,re=M(E,rt);if(E.isDepthTexture)ot=x(E.format===ur,E.type),Mt&&(_t?e.texStorage2D(n.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,mt,z,null));else if(E.isDataTexture)if(Tt.length>0){_t&&Mt&&e.texStorage2D(n.TEXTURE_2D,re,ot,Tt[0].width,Tt[0].height);for(let ht=0,Gt=Tt.length;ht<Gt;ht++)it=Tt[ht],_t?$t&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,z,it.data):e.texImage2D(n.TEXTURE_2D,ht,ot,it.width,it.height,0,mt,z,it.data);E.generateMipmaps=!1}else _t?(Mt&&e.texStorage2D(n.TEXTURE_2D,re,ot,rt.width,rt.height),$t&&an(E,rt,mt,z)):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,mt,z,rt.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){_t&&Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,ot,Tt[0].width,Tt[0].height,rt.depth);for(let ht=0,Gt=Tt.length;ht<Gt;ht++)if(it=Tt[ht],E.format!==ps)if(mt!==null)if(_t){if($t)if(E.layerUpdates.size>0){let oe=vp(it.width,it.height,E.format,E.type);for(let It of E.layerUpdates){let de=it.data.subarray(It*oe/it.data.BYTES_PER_ELEMENT,(It+1)*oe/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,It,it.width,it.height,1,mt,de)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,rt.depth,mt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ht,ot,it.width,it.height,rt.depth,0,it.data,0,0);else Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?$t&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,rt.depth,mt,z,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ht,ot,it.width,it.height,rt.depth,0,mt,z,it.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{_t&&Mt&&e.texStorage2D(n.TEXTURE_2D,re,ot,Tt[0].width,Tt[0].height);for(let ht=0,Gt=Tt.length;ht<Gt;ht++)it=Tt[ht],E.format!==ps?mt!==null?_t?$t&&e.compressedTexSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ht,ot,it.width,it.height,0,it.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?$t&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,z,it.data):e.texImage2D(n.TEXTURE_2D,ht,ot,it.width,it.height,0,mt,z,it.data)}else if(E.isDataArrayTexture)if(_t){if(Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,ot,rt.width,rt.height,rt.depth),$t)if(E.layerUpdates.size>0){let ht=vp(rt.width,rt.height,E.format,E.type);for(let Gt of E.layerUpdates){let oe=rt.data.subarray(Gt*ht/rt.data.BYTES_PER_ELEMENT,(Gt+1)*ht/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Gt,rt.width,rt.height,1,mt,z,oe)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,mt,z,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,mt,z,rt.data);else if(E.isData3DTexture)_t?(Mt&&e.texStorage3D(n.TEXTURE_3D,re,ot,rt.width,rt.height,rt.depth),$t&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,mt,z,rt.data)):e.texImage3D(n.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,mt,z,rt.data);else if(E.isFramebufferTexture){if(Mt)if(_t)e.texStorage2D(n.TEXTURE_2D,re,ot,rt.width,rt.height);else{let ht=rt.width,Gt=rt.height;for(let oe=0;oe<re;oe++)e.texImage2D(n.TEXTURE_2D,oe,ot,ht,Gt,0,mt,z,null),ht>>=1,Gt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let ht=n.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),rt.parentNode!==ht){ht.appendChild(rt),f.add(E),ht.onpaint=Gt=>{let oe=Gt.changedElements;for(let It of f)oe.includes(It.image)&&(It.needsUpdate=!0)},ht.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let oe=n.RGBA,It=n.RGBA,de=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,oe,It,de,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(_t&&Mt){let ht=jt(Tt[0]);e.texStorage2D(n.TEXTURE_2D,re,ot,ht.width,ht.height)}for(let ht=0,Gt=Tt.length;ht<Gt;ht++)it=Tt[ht],_t?$t&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,mt,z,it):e.texImage2D(n.TEXTURE_2D,ht,ot,mt,z,it);E.generateMipmaps=!1}else if(_t){if(Mt){let ht=jt(rt);e.texStorage2D(n.TEXTURE_2D,re,ot,ht.width,ht.height)}$t&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,z,rt)}else e.texImage2D(n.TEXTURE_2D,0,ot,mt,z,rt);w(E)&&E.mipmapsAutoUpdate===!0&&v(ut),bt.__version=xt.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function Tn(P,E,Y){if(E.image.length!==6)return;let ut=pe(P,E),at=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+Y);let xt=i.get(at);if(at.version!==xt.__version||ut===!0){e.activeTexture(n.TEXTURE0+Y);let bt=Ee.getPrimaries(Ee.workingColorSpace),nt=E.colorSpace===fr?null:Ee.getPrimaries(E.colorSpace),rt=E.colorSpace===fr||bt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let mt=E.isCompressedTexture||E.image[0].isCompressedTexture,z=E.image[0]&&E.image[0].isDataTexture,ot=[];for(let It=0;It<6;It++)!mt&&!z?ot[It]=y(E.image[It],!0,s.maxCubemapSize):ot[It]=z?E.image[It].image:E.image[It],ot[It]=Xt(E,ot[It]);let it=ot[0],Tt=r.convert(E.format,E.colorSpace),_t=r.convert(E.type),Mt=S(E.internalFormat,Tt,_t,E.normalized,E.colorSpace),$t=E.isVideoTexture!==!0,re=xt.__version===void 0||ut===!0,ht=at.dataReady,Gt=M(E,it);_e(n.TEXTURE_CUBE_MAP,E);let oe;if(E.isDepthTexture){if(Mt=x(E.format===ur,E.type),re)if($t)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Mt,it.width,it.height);else for(let It=0;It<6;It++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Mt,it.width,it.height,0,Tt,_t,null)}else if(mt){$t&&re&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,Mt,it.width,it.height);for(let It=0;It<6;It++){oe=ot[It].mipmaps;for(let de=0;de<oe.length;de++){let Ke=oe[de];E.format!==ps?Tt!==null?$t?ht&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de,0,0,Ke.width,Ke.height,Tt,Ke.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de,Mt,Ke.width,Ke.height,0,Ke.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de,0,0,Ke.width,Ke.height,Tt,_t,Ke.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de,Mt,Ke.width,Ke.height,0,Tt,_t,Ke.data)}}}else{if(oe=E.mipmaps,$t&&re){oe.length>0&&Gt++;let It=jt(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,Mt,It.width,It.height)}for(let It=0;It<6;It++)if(z){$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,ot[It].width,ot[It].height,Tt,_t,ot[It].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Mt,ot[It].width,ot[It].height,0,Tt,_t,ot[It].data);for(let de=0;de<oe.length;de++){let li=oe[de].image[It].image;$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de+1,0,0,li.width,li.height,Tt,_t,li.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de+1,Mt,li.width,li.height,0,Tt,_t,li.data)}}else{$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,Tt,_t,ot[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Mt,Tt,_t,ot[It]);for(let de=0;de<oe.length;de++){let Ke=oe[de];$t?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de+1,0,0,Tt,_t,Ke.image[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,de+1,Mt,Tt,_t,Ke.image[It])}}}w(E)&&E.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),xt.__version=at.version,E.onUpdate&&E.onUpdate(E)}P.__version=E.version}function Ge(P,E,Y,ut,at,xt){let bt=r.convert(Y.format,Y.colorSpace),nt=r.convert(Y.type),rt=S(Y.internalFormat,bt,nt,Y.normalized,Y.colorSpace),mt=i.get(E),z=i.get(Y);if(z.__renderTarget=E,!mt.__hasExternalTextures){let ot=Math.max(1,E.width>>xt),it=Math.max(1,E.height>>xt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,xt,rt,ot,it,E.depth,0,bt,nt,null):e.texImage2D(at,xt,rt,ot,it,0,bt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),Et(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,at,z.__webglTexture,0,fe(E)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,at,z.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Wn(P,E,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,P),E.depthBuffer){let ut=E.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,xt=x(E.stencilBuffer,at),bt=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Et(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(E),xt,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(E),xt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,xt,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,bt,n.RENDERBUFFER,P)}else{let ut=E.textures;for(let at=0;at<ut.length;at++){let xt=ut[at],bt=r.convert(xt.format,xt.colorSpace),nt=r.convert(xt.type),rt=S(xt.internalFormat,bt,nt,xt.normalized,xt.colorSpace);Et(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(E),rt,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(E),rt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,rt,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Re(P,E,Y){let ut=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(E.depthTexture);at.__renderTarget=E;let xt=ut?E.depthTexture.image[0]:E.depthTexture.image;(!at.__webglTexture||xt.width!==E.width||xt.height!==E.height)&&(xt.width=E.width,xt.height=E.height,E.depthTexture.needsUpdate=!0),ut?wt(E.depthTexture,0):gt(E.depthTexture,0);let bt=at.__webglTexture,nt=fe(E),rt=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,mt=E.depthTexture.format===ur?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===or)Et(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,rt,bt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,rt,bt,0);else if(E.depthTexture.format===ur)Et(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,rt,bt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,rt,bt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Nn(P){let E=i.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==P.depthTexture){let ut=P.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ut){let at=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),E.__depthDisposeCallback=at}E.__boundDepthTexture=ut}if(P.depthTexture&&!E.__autoAllocateDepthBuffer)if(Y)for(let ut=0;ut<6;ut++)Re(E.__webglFramebuffer[ut],P,ut);else P.texture.mipmaps.length>0?Re(E.__webglFramebuffer[0],P,0):Re(E.__webglFramebuffer,P,0);else if(Y){E.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[ut]),E.__webglDepthbuffer[ut]===void 0)E.__webglDepthbuffer[ut]=n.createRenderbuffer(),Wn(E.__webglDepthbuffer[ut],P,!1);else{let at=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=E.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),Wn(E.__webglDepthbuffer,P,!1);else{let at=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function gn(P,E,Y){let ut=i.get(P);E!==void 0&&Ge(ut.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&Nn(P)}function An(P){let E=P.texture,Y=i.get(P),ut=i.get(E);P.addEventListener("dispose",k),F(P);let at=P.textures,xt=P.isWebGLCubeRenderTarget===!0,bt=at.length>1;if(bt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=E.version,o.memory.textures++),xt){Y.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0){Y.__webglFramebuffer[nt]=[];for(let rt=0;rt<E.mipmaps.length;rt++)Y.__webglFramebuffer[nt][rt]=n.createFramebuffer()}else Y.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(E.mipmaps.length>0){Y.__webglFramebuffer=[];for(let nt=0;nt<E.mipmaps.length;nt++)Y.__webglFramebuffer[nt]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(bt)for(let nt=0,rt=at.length;nt<rt;nt++){let mt=i.get(at[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Et(P)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let rt=at[nt];Y.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[nt]);let mt=r.convert(rt.format,rt.colorSpace),z=r.convert(rt.type),ot=S(rt.internalFormat,mt,z,rt.normalized,rt.colorSpace,P.isXRRenderTarget===!0),it=fe(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,ot,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,Y.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),Wn(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),_e(n.TEXTURE_CUBE_MAP,E);for(let nt=0;nt<6;nt++)if(E.mipmaps.length>0)for(let rt=0;rt<E.mipmaps.length;rt++)Ge(Y.__webglFramebuffer[nt][rt],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,rt);else Ge(Y.__webglFramebuffer[nt],P,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);w(E)?v(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(bt){for(let nt=0,rt=at.length;nt<rt;nt++){let mt=at[nt],z=i.get(mt),ot=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ot=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,z.__webglTexture),_e(ot,mt),Ge(Y.__webglFramebuffer,P,mt,n.COLOR_ATTACHMENT0+nt,ot,0),w(mt)&&v(ot)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(nt=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,ut.__webglTexture),_e(nt,E),E.mipmaps.length>0)for(let rt=0;rt<E.mipmaps.length;rt++)Ge(Y.__webglFramebuffer[rt],P,E,n.COLOR_ATTACHMENT0,nt,rt);else Ge(Y.__webglFramebuffer,P,E,n.COLOR_ATTACHMENT0,nt,0);w(E)?v(nt):E.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&Nn(P)}function H(P){let E=P.textures;for(let Y=0,ut=E.length;Y<ut;Y++){let at=E[Y];if(w(at)&&at.mipmapsAutoUpdate===!0){let xt=C(P),bt=i.get(at).__webglTexture;e.bindTexture(xt,bt),v(xt),e.unbindTexture()}}}let Lt=[];function te(P){if(P.samples>0){if(Et(P)===!1){let E=P.textures,Y=P.width,ut=P.height,at=n.COLOR_BUFFER_BIT,xt=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=i.get(P),nt=E.length>1;if(nt)for(let mt=0;mt<E.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,bt.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglFramebuffer);for(let mt=0;mt<E.length;mt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,bt.__webglColorRenderbuffer[mt]);let z=i.get(E[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,Y,ut,0,0,Y,ut,at,n.NEAREST),l===!0&&(Lt.length=0,Lt.push(n.COLOR_ATTACHMENT0+mt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Lt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Lt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<E.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,bt.__webglColorRenderbuffer[mt]);let z=i.get(E[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let E=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function fe(P){return Math.min(s.maxSamples,P.samples)}function Et(P){let E=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function We(P){let E=o.render.frame;h.get(P)!==E&&(h.set(P,E),P.update())}function Xt(P,E){let Y=P.colorSpace,ut=P.format,at=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==ul&&Y!==fr&&(Ee.getTransfer(Y)===Fe?(ut!==ps||at!==ki)&&Kt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",Y)),E}function jt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=tt,this.getTextureUnits=st,this.setTextureUnits=ft,this.setTexture2D=gt,this.setTexture2DArray=vt,this.setTexture3D=Pt,this.setTextureCube=wt,this.rebindTextures=gn,this.setupRenderTarget=An,this.updateRenderTargetMipmap=H,this.updateMultisampleRenderTarget=te,this.setupDepthRenderbuffer=Nn,this.setupFrameBufferTexture=Ge,this.useMultisampledRTT=Et,this.dispose=V}function aT(n,t){function e(i,s=fr){let r,o=Ee.getTransfer(s);if(i===ki)return n.UNSIGNED_BYTE;if(i===Yh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===$h)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ep)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===np)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Qd)return n.BYTE;if(i===tp)return n.SHORT;if(i===ba)return n.UNSIGNED_SHORT;if(i===qh)return n.INT;if(i===fs)return n.UNSIGNED_INT;if(i===Zi)return n.FLOAT;if(i===ds)return n.HALF_FLOAT;if(i===ip)return n.ALPHA;if(i===sp)return n.RGB;if(i===ps)return n.RGBA;if(i===or)return n.DEPTH_COMPONENT;if(i===ur)return n.DEPTH_STENCIL;if(i===Zh)return n.RED;if(i===Jh)return n.RED_INTEGER;if(i===Br)return n.RG;if(i===jh)return n.RG_INTEGER;if(i===Kh)return n.RGBA_INTEGER;if(i===Fl||i===Ol||i===Bl||i===kl)if(o===Fe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Fl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Bl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===kl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Fl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Bl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===kl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Qh||i===tu||i===eu||i===nu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Qh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===tu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===eu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===nu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===iu||i===su||i===ru||i===ou||i===au||i===zl||i===lu)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===iu||i===su)return o===Fe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ru)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ou)return r.COMPRESSED_R11_EAC;if(i===au)return r.COMPRESSED_SIGNED_R11_EAC;if(i===zl)return r.COMPRESSED_RG11_EAC;if(i===lu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===cu||i===hu||i===uu||i===fu||i===du||i===pu||i===mu||i===gu||i===_u||i===xu||i===yu||i===vu||i===bu||i===Su)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===cu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===hu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===uu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===fu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===du)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===pu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===mu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===gu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===_u)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===xu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===yu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===vu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===bu)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Su)return o===Fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Mu||i===wu||i===Eu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Mu)return o===Fe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===wu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Eu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Tu||i===Au||i===Hl||i===Ru)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Tu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Au)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Hl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ru)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===fo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var lT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cT=`
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

}`,Cp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Rl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new $i({vertexShader:lT,fragmentShader:cT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ft(new oo(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Pp=class extends cs{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,f=null,u=null,d=null,g=null,_=typeof XRWebGLBinding<"u",m=new Cp,p={},y=e.getContextAttributes(),w=null,v=null,C=[],S=[],x=new qt,M=null,F=null,I=new _i;I.viewport=new dn;let D=new _i;D.viewport=new dn;let k=[I,D],X=new Gh,U=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let gt=C[et];return gt===void 0&&(gt=new fa,C[et]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(et){let gt=C[et];return gt===void 0&&(gt=new fa,C[et]=gt),gt.getGripSpace()},this.getHand=function(et){let gt=C[et];return gt===void 0&&(gt=new fa,C[et]=gt),gt.getHandSpace()};function Z(et){let gt=S.indexOf(et.inputSource);if(gt===-1)return;let vt=C[gt];vt!==void 0&&(vt.update(et.inputSource,et.frame,c||o),vt.dispatchEvent({type:et.type,data:et.inputSource}))}function W(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ct);for(let et=0;et<C.length;et++){let gt=S[et];gt!==null&&(S[et]=null,C[et].disconnect(gt))}U=null,V=null,m.reset();for(let et in p)delete p[et];if(t.setRenderTarget(w),d=null,u=null,f=null,s=null,v=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(x.width,x.height,!1),F!==null){let et=F.camera;et.fov=F.fov,et.zoom=F.zoom,et.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,i.isPresenting===!0&&Kt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,i.isPresenting===!0&&Kt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return u!==null?u:d},this.getBinding=function(){return f===null&&_&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ct),y.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Pt=null,wt=null;y.depth&&(wt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=y.stencil?ur:or,Pt=y.stencil?fo:fs);let Zt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};f=this.getBinding(),u=f.createProjectionLayer(Zt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),v=new Oi(u.textureWidth,u.textureHeight,{format:ps,type:ki,depthTexture:new lr(u.textureWidth,u.textureHeight,Pt,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let vt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new Oi(d.framebufferWidth,d.framebufferHeight,{format:ps,type:ki,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(et){for(let gt=0;gt<et.removed.length;gt++){let vt=et.removed[gt],Pt=S.indexOf(vt);Pt>=0&&(S[Pt]=null,C[Pt].disconnect(vt))}for(let gt=0;gt<et.added.length;gt++){let vt=et.added[gt],Pt=S.indexOf(vt);if(Pt===-1){for(let Zt=0;Zt<C.length;Zt++)if(Zt>=S.length){S.push(vt),Pt=Zt;break}else if(S[Zt]===null){S[Zt]=vt,Pt=Zt;break}if(Pt===-1)break}let wt=C[Pt];wt&&wt.connect(vt)}}function $(et,gt){gt===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(gt.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let gt=et.near,vt=et.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(vt=m.depthFar)),X.near=D.near=I.near=gt,X.far=D.far=I.far=vt,(U!==X.near||V!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),U=X.near,V=X.far),X.layers.mask=et.layers.mask|6,I.layers.mask=X.layers.mask&-5,D.layers.mask=X.layers.mask&-3;let Pt=et.parent,wt=X.cameras;$(X,Pt);for(let Zt=0;Zt<wt.length;Zt++)$(wt[Zt],Pt);X.projectionMatrix.copy(I.projectionMatrix),X.projectionMatrixInverse.copy(I.projectionMatrixInverse),F===null&&et.isPerspectiveCamera&&(F={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,X,Pt)};function tt(et,gt,vt){vt===null?et.matrix.copy(gt.matrixWorld):(et.matrix.copy(vt.matrixWorld),et.matrix.invert(),et.matrix.multiply(gt.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(gt.projectionMatrix),et.projectionMatrixInverse.copy(gt.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=ca*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(u===null&&d===null))return l},this.setFoveation=function(et){l=et,u!==null&&(u.fixedFoveation=et),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=et)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(X)},this.getCameraTexture=function(et){return p[et]};let st=null;function ft(et,gt){if(h=gt.getViewerPose(c||o),g=gt,h!==null){let vt=h.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let Pt=!1;vt.length!==X.cameras.length&&(X.cameras.length=0,Pt=!0);for(let Yt=0;Yt<vt.length;Yt++){let _e=vt[Yt],pe=null;if(d!==null)pe=d.getViewport(_e);else{let an=f.getViewSubImage(u,_e);pe=an.viewport,Yt===0&&(t.setRenderTargetTextures(v,an.colorTexture,an.depthStencilTexture),t.setRenderTarget(v))}let ce=k[Yt];ce===void 0&&(ce=new _i,ce.layers.enable(Yt),ce.viewport=new dn,k[Yt]=ce),ce.matrix.fromArray(_e.transform.matrix),ce.matrix.decompose(ce.position,ce.quaternion,ce.scale),ce.projectionMatrix.fromArray(_e.projectionMatrix),ce.projectionMatrixInverse.copy(ce.projectionMatrix).invert(),ce.viewport.set(pe.x,pe.y,pe.width,pe.height),Yt===0&&(X.matrix.copy(ce.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Pt===!0&&X.cameras.push(ce)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){f=i.getBinding();let Yt=f.getDepthInformation(vt[0]);Yt&&Yt.isValid&&Yt.texture&&m.init(Yt,s.renderState)}if(wt&&wt.includes("camera-access")&&_){t.state.unbindTexture(),f=i.getBinding();for(let Yt=0;Yt<vt.length;Yt++){let _e=vt[Yt].camera;if(_e){let pe=p[_e];pe||(pe=new Rl,p[_e]=pe);let ce=f.getCameraImage(_e);pe.sourceTexture=ce}}}}for(let vt=0;vt<C.length;vt++){let Pt=S[vt],wt=C[vt];Pt!==null&&wt!==void 0&&wt.update(Pt,gt,c||o)}st&&st(et,gt),gt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:gt}),g=null}let dt=new T_;dt.setAnimationLoop(ft),this.setAnimationLoop=function(et){st=et},this.dispose=function(){}}},hT=new Me,F_=new le;F_.set(-1,0,0,0,1,0,0,0,1);function uT(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,_p(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,w,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),f(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),u(m,p),p.isMeshPhysicalMaterial&&d(m,p,v)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),_(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===bi&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===bi&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let y=t.get(p),w=y.envMap,v=y.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(hT.makeRotationFromEuler(v)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(F_),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=w*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function f(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,y){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===bi&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function _(m,p){let y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function fT(n,t,e,i){let s={},r={};function o(y,w){let v=w.program;i.uniformBlockBinding(y,v,s[y.id])}function a(y,w){let v=s[y.id];v===void 0&&(g(y),v=l(y),s[y.id]=v,y.addEventListener("dispose",m));let C=w.program;i.updateUBOMapping(y,C);let S=t.render.frame;r[y.id]!==S&&(c(y),r[y.id]=S)}function l(y){let w=n.createBuffer(),v=y.__size,C=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,v,C),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(y){let w=s[y.id],v=y.uniforms,C=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let S=0,x=v.length;S<x;S++){let M=v[S];if(Array.isArray(M))for(let F=0,I=M.length;F<I;F++)h(M[F],S,F,C);else h(M,S,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,w,v,C){if(u(y,w,v,C)===!0){let S=y.__offset,x=y.value;if(Array.isArray(x)){let M=0;for(let F=0;F<x.length;F++){let I=x[F],D=_(I,!0);f(I,y.__data,M),M+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,S,y.__data)}}function f(y,w,v){typeof y=="number"||typeof y=="boolean"?w[v]=y:y.isMatrix3?(w[v]=y.elements[0],w[v+1]=y.elements[1],w[v+2]=y.elements[2],w[v+3]=0,w[v+4]=y.elements[3],w[v+5]=y.elements[4],w[v+6]=y.elements[5],w[v+7]=0,w[v+8]=y.elements[6],w[v+9]=y.elements[7],w[v+10]=y.elements[8],w[v+11]=0):ArrayBuffer.isView(y)?w.set(y.subarray(0,w.length-v),v):y.toArray(w,v)}function u(y,w,v,C){let S=y.value,x=w+"_"+v;if(Array.isArray(S)){C[x]===void 0&&(C[x]=[]);let M=C[x],F=!1;for(let I=0;I<S.length;I++)d(S[I],M,I)===!0&&(F=!0);return F}return d(S,C,x)}function d(y,w,v){if(w[v]===void 0)return typeof y=="number"||typeof y=="boolean"?w[v]=y:ArrayBuffer.isView(y)?w[v]=y.slice():w[v]=y.clone(),!0;{let C=w[v];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return w[v]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function g(y){let w=y.uniforms,v=0,C=16;for(let x=0,M=w.length;x<M;x++){let F=Array.isArray(w[x])?w[x]:[w[x]];for(let I=0,D=F.length;I<D;I++){let k=F[I],X=Array.isArray(k.value)?k.value:[k.value],U=Array.isArray(w[x])||Array.isArray(k.value),V=v;for(let W=0,ct=X.length;W<ct;W++){let $=X[W],tt=_($,U),st=v%C,ft=st%tt.boundary,dt=st+ft;v+=ft,dt!==0&&C-dt<tt.storage&&(v+=C-dt),W===0&&(V=v),v+=tt.storage}let Z=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Z((v-V)/Float32Array.BYTES_PER_ELEMENT),k.__offset=V}}let S=v%C;return S>0&&(v+=C-S),y.__size=v,y.__cache={},this}function _(y,w){let v={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(v.boundary=4,v.storage=4):y.isVector2?(v.boundary=8,v.storage=8):y.isVector3||y.isColor?(v.boundary=16,v.storage=12):y.isVector4?(v.boundary=16,v.storage=16):y.isMatrix3?(v.boundary=16,v.storage=48):y.isMatrix4?(v.boundary=16,v.storage=64):y.isTexture?Kt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(v.boundary=16,v.storage=y.byteLength):Kt("WebGLRenderer: Unsupported uniform value type.",y),w===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(y){let w=y.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var dT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Bs=null;function pT(){return Bs===null&&(Bs=new Ml(dT,16,16,Br,ds),Bs.name="DFG_LUT",Bs.minFilter=xi,Bs.magFilter=xi,Bs.wrapS=Ls,Bs.wrapT=Ls,Bs.generateMipmaps=!1,Bs.needsUpdate=!0),Bs}var Nu=class{constructor(t={}){let{canvas:e=J0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:d=ki}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let _=d,m=new Set([Kh,jh,Jh]),p=new Set([ki,fs,ba,fo,Yh,$h]),y=new Uint32Array(4),w=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},C=null,S=null,x=[],M=[],F=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,k=null,X=null,U=null,V=null;this._outputColorSpace=mi;let Z=0,W=0,ct=null,$=-1,tt=null,st=new dn,ft=new dn,dt=null,et=new Qt(0),gt=0,vt=e.width,Pt=e.height,wt=1,Zt=null,ue=null,Yt=new dn(0,0,vt,Pt),_e=new dn(0,0,vt,Pt),pe=!1,ce=new io,an=new wh,Ze=!1,Tn=!1,Ge=new Me,Wn=new B,Re=new dn,Nn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},gn=!1;function An(){return ct===null?wt:1}let H=i;function Lt(R,G){return e.getContext(R,G)}let te,fe,Et,We,Xt,jt,P,E,Y,ut,at,xt,bt,nt,rt,mt,z,ot,it,Tt,_t,Mt,$t;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Gt,!1),e.addEventListener("webglcontextrestored",oe,!1),e.addEventListener("webglcontextcreationerror",It,!1),H===null){let G="webgl2";if(H=Lt(G,R),H===null)throw Lt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}re()}catch(R){throw e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",It,!1),se("WebGLRenderer: "+R.message),R}function re(){te=new E1(H),te.init(),_t=new aT(H,te),fe=new p1(H,te,t,_t),Et=new rT(H,te),fe.reversedDepthBuffer&&u&&Et.buffers.depth.setReversed(!0),X=H.createFramebuffer(),U=H.createFramebuffer(),V=H.createFramebuffer(),We=new R1(H),Xt=new XE,jt=new oT(H,te,Et,Xt,fe,_t,We),P=new w1(I),E=new PS(H),Mt=new f1(H,E),Y=new T1(H,E,We,Mt),ut=new P1(H,Y,E,Mt,We),ot=new C1(H,fe,jt),rt=new m1(Xt),at=new WE(I,P,te,fe,Mt,rt),xt=new uT(I,Xt),bt=new YE,nt=new QE(te),z=new u1(I,P,Et,ut,g,l),mt=new sT(I,ut,fe),$t=new fT(H,We,fe,Et),it=new d1(H,te,We),Tt=new A1(H,te,We),We.programs=at.programs,I.capabilities=fe,I.extensions=te,I.properties=Xt,I.renderLists=bt,I.shadowMap=mt,I.state=Et,I.info=We}_!==ki&&(F=new L1(_,e.width,e.height,a,s,r));let ht=new Pp(I,H);this.xr=ht,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let R=te.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=te.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(R){R!==void 0&&(wt=R,this.setSize(vt,Pt,!1))},this.getSize=function(R){return R.set(vt,Pt)},this.setSize=function(R,G,Q=!0){if(ht.isPresenting){Kt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=R,Pt=G,e.width=Math.floor(R*wt),e.height=Math.floor(G*wt),Q===!0&&(e.style.width=R+"px",e.style.height=G+"px"),F!==null&&F.setSize(e.width,e.height),this.setViewport(0,0,R,G)},this.getDrawingBufferSize=function(R){return R.set(vt*wt,Pt*wt).floor()},this.setDrawingBufferSize=function(R,G,Q){vt=R,Pt=G,wt=Q,e.width=Math.floor(R*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,R,G)},this.setEffects=function(R){if(_===ki){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let G=0;G<R.length;G++)if(R[G].isOutputPass===!0){Kt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(st)},this.getViewport=function(R){return R.copy(Yt)},this.setViewport=function(R,G,Q,J){R.isVector4?Yt.set(R.x,R.y,R.z,R.w):Yt.set(R,G,Q,J),Et.viewport(st.copy(Yt).multiplyScalar(An()).round())},this.getScissor=function(R){return R.copy(_e)},this.setScissor=function(R,G,Q,J){R.isVector4?_e.set(R.x,R.y,R.z,R.w):_e.set(R,G,Q,J),Et.scissor(ft.copy(_e).multiplyScalar(An()).round())},this.getScissorTest=function(){return pe},this.setScissorTest=function(R){Et.setScissorTest(pe=R)},this.setOpaqueSort=function(R){Zt=R},this.setTransparentSort=function(R){ue=R},this.getClearColor=function(R){return R.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(R=!0,G=!0,Q=!0){let J=0;if(R){let j=!1;if(ct!==null){let At=ct.texture.format;j=m.has(At)}if(j){let At=ct.texture.type,Dt=p.has(At),Rt=z.getClearColor(),Nt=z.getClearAlpha(),Wt=Rt.r,ae=Rt.g,ye=Rt.b;Dt?(y[0]=Wt,y[1]=ae,y[2]=ye,y[3]=Nt,H.clearBufferuiv(H.COLOR,0,y)):(w[0]=Wt,w[1]=ae,w[2]=ye,w[3]=Nt,H.clearBufferiv(H.COLOR,0,w))}else J|=H.COLOR_BUFFER_BIT}G&&(J|=H.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(J|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&H.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),k=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",It,!1),z.dispose(),bt.dispose(),nt.dispose(),jt.dispose(),Xt.dispose(),P.dispose(),ut.dispose(),Y.dispose(),Mt.dispose(),$t.dispose(),at.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",gc),ht.removeEventListener("sessionend",bs),Ws.stop()};function Gt(R){R.preventDefault(),ml("WebGLRenderer: Context Lost."),D=!0}function oe(){ml("WebGLRenderer: Context Restored."),D=!1;let R=We.autoReset,G=mt.enabled,Q=mt.autoUpdate,J=mt.needsUpdate,j=mt.type;re(),We.autoReset=R,mt.enabled=G,mt.autoUpdate=Q,mt.needsUpdate=J,mt.type=j}function It(R){se("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function de(R){let G=R.target;G.removeEventListener("dispose",de),Ke(G)}function Ke(R){li(R),Xt.remove(R)}function li(R){let G=Xt.get(R).programs;G!==void 0&&(G.forEach(function(Q){at.releaseProgram(Q)}),R.isShaderMaterial&&at.releaseShaderCache(R))}this.renderBufferDirect=function(R,G,Q,J,j,At){G===null&&(G=Nn);let Dt=j.isMesh&&j.matrixWorld.determinantAffine()<0,Rt=qa(R,G,Q,J,j);Et.setMaterial(J,Dt);let Nt=Q.index,Wt=1;if(J.wireframe===!0){if(Nt=Y.getWireframeAttribute(Q),Nt===void 0)return;Wt=2}let ae=Q.drawRange,ye=Q.attributes.position,Vt=ae.start*Wt,ve=(ae.start+ae.count)*Wt;At!==null&&(Vt=Math.max(Vt,At.start*Wt),ve=Math.min(ve,(At.start+At.count)*Wt)),Nt!==null?(Vt=Math.max(Vt,0),ve=Math.min(ve,Nt.count)):ye!=null&&(Vt=Math.max(Vt,0),ve=Math.min(ve,ye.count));let fn=ve-Vt;if(fn<0||fn===1/0)return;Mt.setup(j,J,Rt,Q,Nt);let Be,ke=it;if(Nt!==null&&(Be=E.get(Nt),ke=Tt,ke.setIndex(Be)),j.isMesh)J.wireframe===!0?(Et.setLineWidth(J.wireframeLinewidth*An()),ke.setMode(H.LINES)):ke.setMode(H.TRIANGLES);else if(j.isLine){let Un=J.linewidth;Un===void 0&&(Un=1),Et.setLineWidth(Un*An()),j.isLineSegments?ke.setMode(H.LINES):j.isLineLoop?ke.setMode(H.LINE_LOOP):ke.setMode(H.LINE_STRIP)}else j.isPoints?ke.setMode(H.POINTS):j.isSprite&&ke.setMode(H.TRIANGLES);if(j.isBatchedMesh)if(te.get("WEBGL_multi_draw"))ke.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let Un=j._multiDrawStarts,zt=j._multiDrawCounts,Rn=j._multiDrawCount,we=Nt?E.get(Nt).bytesPerElement:1,qs=Xt.get(J).currentProgram.getUniforms();for(let Cn=0;Cn<Rn;Cn++)qs.setValue(H,"_gl_DrawID",Cn),ke.render(Un[Cn]/we,zt[Cn])}else if(j.isInstancedMesh)ke.renderInstances(Vt,fn,j.count);else if(Q.isInstancedBufferGeometry){let Un=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,zt=Math.min(Q.instanceCount,Un);ke.renderInstances(Vt,fn,zt)}else ke.render(Vt,fn)};function Va(R,G,Q,J){k!==null&&R.isNodeMaterial&&k.setObject(J,R),Ze===!0&&rt.setState(R,Q,!1),R.transparent===!0&&R.side===Ei&&R.forceSinglePass===!1?(R.side=bi,R.needsUpdate=!0,Ss(R,G,J),R.side=Or,R.needsUpdate=!0,Ss(R,G,J),R.side=Ei):Ss(R,G,J)}this.compile=function(R,G,Q=null){Q===null&&(Q=R),k!==null&&k.renderStart(R,G,Q),S=nt.get(Q),S.init(G),M.push(S),Q.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(S.pushLight(j),j.castShadow&&S.pushShadow(j))}),R!==Q&&R.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(S.pushLight(j),j.castShadow&&S.pushShadow(j))}),S.setupLights(),k!==null&&k.updateLights(S.state.lightsArray),Tn=this.localClippingEnabled,Ze=rt.init(this.clippingPlanes,Tn),Ze===!0&&rt.setGlobalState(this.clippingPlanes,G),k!==null&&mt.render(S.state.shadowsArray,Q,G);let J=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let At=j.material;if(At)if(Array.isArray(At))for(let Dt=0;Dt<At.length;Dt++){let Rt=At[Dt];Va(Rt,Q,G,j),J.add(Rt)}else Va(At,Q,G,j),J.add(At)}),S=M.pop(),k!==null&&k.renderEnd(),J},this.compileAsync=function(R,G,Q=null){let J=this.compile(R,G,Q);return new Promise(j=>{function At(){if(J.forEach(function(Dt){let Nt=Xt.get(Dt).currentProgram;(Nt===void 0||Nt.isReady())&&J.delete(Dt)}),J.size===0){j(R);return}setTimeout(At,10)}te.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let Ro=null;function Yf(R){Ro&&Ro(R)}function gc(){Ws.stop()}function bs(){Ws.start()}let Ws=new T_;Ws.setAnimationLoop(Yf),typeof self<"u"&&Ws.setContext(self),this.setAnimationLoop=function(R){Ro=R,ht.setAnimationLoop(R),R===null?Ws.stop():Ws.start()},ht.addEventListener("sessionstart",gc),ht.addEventListener("sessionend",bs),this.render=function(R,G){if(G!==void 0&&G.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;k!==null&&k.renderStart(R,G);let Q=ht.enabled===!0&&ht.isPresenting===!0,J=F!==null&&(ct===null||Q)&&F.begin(I,ct);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(G),G=ht.getCamera()),R.isScene===!0&&R.onBeforeRender(I,R,G,ct),S=nt.get(R,M.length),S.init(G),S.state.textureUnits=jt.getTextureUnits(),M.push(S),Ge.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?an.setFromArrayCamera(G):ce.setFromProjectionMatrix(Ge,Yi,G.reversedDepth),Tn=this.localClippingEnabled,Ze=rt.init(this.clippingPlanes,Tn),C=bt.get(R,x.length),C.init(),x.push(C),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Dt=I.xr.getDepthSensingMesh();Dt!==null&&Xs(Dt,G,-1/0,I.sortObjects)}Xs(R,G,0,I.sortObjects),C.finish(),k!==null&&k.updateLights(S.state.lightsArray),I.sortObjects===!0&&C.sort(Zt,ue),gn=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,gn&&z.addToRenderList(C,R),this.info.autoReset===!0&&this.info.reset(),Ze===!0&&rt.beginShadows();let j=S.state.shadowsArray;if(mt.render(j,R,G),Ze===!0&&rt.endShadows(),(J&&F.hasRenderPass())===!1){let Dt=C.opaque,Rt=C.transmissive;if(S.setupLights(),G.isArrayCamera){let Nt=G.cameras;if(Rt.length>0)for(let Wt=0,ae=Nt.length;Wt<ae;Wt++){let ye=Nt[Wt];es(Dt,Rt,R,ye)}gn&&z.render(R);for(let Wt=0,ae=Nt.length;Wt<ae;Wt++){let ye=Nt[Wt];Wa(C,R,ye,ye.viewport)}}else Rt.length>0&&es(Dt,Rt,R,G),gn&&z.render(R),Wa(C,R,G)}ct!==null&&W===0&&(jt.updateMultisampleRenderTarget(ct),jt.updateRenderTargetMipmap(ct)),J&&F.end(I),R.isScene===!0&&R.onAfterRender(I,R,G),Mt.resetDefaultState(),$=-1,tt=null,M.pop(),M.length>0?(S=M[M.length-1],jt.setTextureUnits(S.state.textureUnits),Ze===!0&&rt.setGlobalState(I.clippingPlanes,S.state.camera)):S=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,k!==null&&k.renderEnd()};function Xs(R,G,Q,J){if(R.visible===!1)return;if(R.layers.test(G.layers)){if(R.isGroup)Q=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(G);else if(R.isLight)S.pushLight(R),R.castShadow&&S.pushShadow(R);else if(R.isSprite){let Dt=G.isArrayCamera?an:ce;if(!R.frustumCulled||R.intersectsFrustum(Dt)){J&&Re.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ge);let Rt=ut.update(R),Nt=R.material;Nt.visible&&C.push(R,Rt,Nt,Q,Re.z,null,G)}}else if(R.isMesh||R.isLine||R.isPoints){let Dt=G.isArrayCamera?an:ce;if(!R.frustumCulled||R.intersectsFrustum(Dt)){let Rt=ut.update(R),Nt=R.material;if(J&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Re.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),Re.copy(Rt.boundingSphere.center)),Re.applyMatrix4(R.matrixWorld).applyMatrix4(Ge)),Array.isArray(Nt)){let Wt=Rt.groups;for(let ae=0,ye=Wt.length;ae<ye;ae++){let Vt=Wt[ae],ve=Nt[Vt.materialIndex];ve&&ve.visible&&C.push(R,Rt,ve,Q,Re.z,Vt,G)}}else Nt.visible&&C.push(R,Rt,Nt,Q,Re.z,null,G)}}}let At=R.children;for(let Dt=0,Rt=At.length;Dt<Rt;Dt++)Xs(At[Dt],G,Q,J)}function Wa(R,G,Q,J){let{opaque:j,transmissive:At,transparent:Dt}=R;S.setupLightsView(Q),Ze===!0&&rt.setGlobalState(I.clippingPlanes,Q),J&&Et.viewport(st.copy(J)),j.length>0&&_n(j,G,Q),At.length>0&&_n(At,G,Q),Dt.length>0&&_n(Dt,G,Q),Et.buffers.depth.setTest(!0),Et.buffers.depth.setMask(!0),Et.buffers.color.setMask(!0),Et.setPolygonOffset(!1)}function es(R,G,Q,J){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[J.id]===void 0){let Vt=te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[J.id]=new Oi(1,1,{generateMipmaps:!0,type:Vt?ds:ki,minFilter:hr,samples:Math.max(4,fe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ee.workingColorSpace})}let At=S.state.transmissionRenderTarget[J.id],Dt=J.viewport||st;At.setSize(Dt.z*I.transmissionResolutionScale,Dt.w*I.transmissionResolutionScale);let Rt=I.getRenderTarget(),Nt=I.getActiveCubeFace(),Wt=I.getActiveMipmapLevel();I.setRenderTarget(At),I.getClearColor(et),gt=I.getClearAlpha(),gt<1&&I.setClearColor(16777215,.5),I.clear(),gn&&z.render(Q);let ae=I.toneMapping;I.toneMapping=Os;let ye=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),S.setupLightsView(J),Ze===!0&&rt.setGlobalState(I.clippingPlanes,J),_n(R,Q,J),jt.updateMultisampleRenderTarget(At),jt.updateRenderTargetMipmap(At),te.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let ve=0,fn=G.length;ve<fn;ve++){let Be=G[ve],{object:ke,geometry:Un,material:zt,group:Rn}=Be;if(zt.side===Ei&&ke.layers.test(J.layers)){let we=zt.side;zt.side=bi,zt.needsUpdate=!0,Mn(ke,Q,J,Un,zt,Rn),zt.side=we,zt.needsUpdate=!0,Vt=!0}}Vt===!0&&(jt.updateMultisampleRenderTarget(At),jt.updateRenderTargetMipmap(At))}I.setRenderTarget(Rt,Nt,Wt),I.setClearColor(et,gt),ye!==void 0&&(J.viewport=ye),I.toneMapping=ae}function _n(R,G,Q){let J=G.isScene===!0?G.overrideMaterial:null;for(let j=0,At=R.length;j<At;j++){let Dt=R[j],{object:Rt,geometry:Nt,group:Wt}=Dt,ae=Dt.material;ae.allowOverride===!0&&J!==null&&(ae=J),Rt.layers.test(Q.layers)&&Mn(Rt,G,Q,Nt,ae,Wt)}}function Mn(R,G,Q,J,j,At){k!==null&&j.isNodeMaterial&&k.setObject(R,j),R.onBeforeRender(I,G,Q,J,j,At),R.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(I,G,Q,J,R,At),j.transparent===!0&&j.side===Ei&&j.forceSinglePass===!1?(j.side=bi,j.needsUpdate=!0,I.renderBufferDirect(Q,G,J,j,R,At),j.side=Or,j.needsUpdate=!0,I.renderBufferDirect(Q,G,J,j,R,At),j.side=Ei):I.renderBufferDirect(Q,G,J,j,R,At),R.onAfterRender(I,G,Q,J,j,At)}function wn(R){let G=0;for(let Q of R)Q.texture!==null&&G++;return G}function Ss(R,G,Q){G.isScene!==!0&&(G=Nn);let J=Xt.get(R),j=S.state.lights,At=S.state.shadowsArray,Dt=j.state.version,Rt=at.getParameters(R,j.state,At,G,Q,S.state.lightProbeGridArray),Nt=at.getProgramCacheKey(Rt),Wt=J.programs;J.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?G.environment:null,J.fog=G.fog;let ae=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;J.envMap=P.get(R.envMap||J.environment,ae),J.envMapRotation=J.environment!==null&&R.envMap===null?G.environmentRotation:R.envMapRotation,Wt===void 0&&(R.addEventListener("dispose",de),Wt=new Map,J.programs=Wt,J.programVariants=new Map);let ye=Wt.get(Nt);if(ye!==void 0){if(J.currentProgram===ye&&J.lightsStateVersion===Dt)return Xa(R,Rt),ye}else Rt.uniforms=at.getUniforms(R),k!==null&&R.isNodeMaterial&&k.build(R,Q,Rt),R.onBeforeCompile(Rt,I),ye=at.acquireProgram(Rt,Nt),Wt.set(Nt,ye),J.uniforms=Rt.uniforms;let Vt=J.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Vt.clippingPlanes=rt.uniform),Xa(R,Rt),J.needsLights=xr(R),J.lightsStateVersion=Dt,J.needsLights&&(Vt.ambientLightColor.value=j.state.ambient,Vt.lightProbe.value=j.state.probe,Vt.sunLights.value=j.state.sun,Vt.sunLightShadows.value=j.state.sunShadow,Vt.directionalLights.value=j.state.directional,Vt.directionalLightShadows.value=j.state.directionalShadow,Vt.spotLights.value=j.state.spot,Vt.spotLightShadows.value=j.state.spotShadow,Vt.rectAreaLights.value=j.state.rectArea,Vt.ltc_1.value=j.state.rectAreaLTC1,Vt.ltc_2.value=j.state.rectAreaLTC2,Vt.pointLights.value=j.state.point,Vt.pointLightShadows.value=j.state.pointShadow,Vt.hemisphereLights.value=j.state.hemi,Vt.sunShadowMatrix.value=j.state.sunShadowMatrix,Vt.sunShadowCascade.value=j.state.sunShadowCascade,Vt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Vt.spotLightMatrix.value=j.state.spotLightMatrix,Vt.spotLightMap.value=j.state.spotLightMap,Vt.pointShadowMatrix.value=j.state.pointShadowMatrix),J.numLightProbeGrids=wn(S.state.lightProbeGridArray),J.currentProgram=ye,J.uniformsList=null,ye}function Ii(R,G,Q,J,j){let At=Xt.get(R),Dt=At.currentProgram.id+","+J+","+j,Rt=At.programVariants.get(Dt);return Rt===void 0?(Rt=Ss(R,G,Q),At.programVariants.set(Dt,Rt)):(At.currentProgram=Rt,At.uniformsList=null,At.outputColorSpace=J,At.toneMapping=j),Rt}function _r(R){if(R.uniformsList===null){let G=R.currentProgram.getUniforms();R.uniformsList=Ma.seqWithValue(G.seq,R.uniforms)}return R.uniformsList}function Xa(R,G){let Q=Xt.get(R);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function qa(R,G,Q,J,j){G.isScene!==!0&&(G=Nn),jt.resetTextureUnits();let At=G.fog,Dt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?G.environment:null,Rt=ct===null?I.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Ee.workingColorSpace,Nt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Wt=P.get(J.envMap||Dt,Nt),ae=J.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,ye=!!Q.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Vt=!!Q.morphAttributes.position,ve=!!Q.morphAttributes.normal,fn=!!Q.morphAttributes.color,Be=Os;J.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Be=I.toneMapping);let ke=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Un=ke!==void 0?ke.length:0,zt=Xt.get(J),Rn=S.state.lights;if(Ze===!0&&(Tn===!0||R!==tt)){let ze=R===tt&&J.id===$;rt.setState(J,R,ze)}let we=!1,qs=!1;J.version===zt.__version?zt.needsLights&&zt.lightsStateVersion!==Rn.state.version||j.isBatchedMesh&&zt.batching===!1||!j.isBatchedMesh&&zt.batching===!0||j.isBatchedMesh&&zt.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&zt.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&zt.instancing===!1||!j.isInstancedMesh&&zt.instancing===!0||j.isSkinnedMesh&&zt.skinning===!1||!j.isSkinnedMesh&&zt.skinning===!0||j.isInstancedMesh&&zt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&zt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&zt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&zt.instancingMorph===!1&&j.morphTexture!==null||zt.envMap!==Wt||J.fog===!0&&zt.fog!==At||zt.numClippingPlanes!==void 0&&(zt.numClippingPlanes!==rt.numPlanes||zt.numIntersection!==rt.numIntersection)||zt.vertexAlphas!==ae||zt.vertexTangents!==ye||zt.morphTargets!==Vt||zt.morphNormals!==ve||zt.morphColors!==fn||zt.morphTargetsCount!==Un||zt.numLightProbeGrids!==wn(S.state.lightProbeGridArray)?we=!0:(zt.outputColorSpace!==Rt||zt.toneMapping!==Be)&&(qs=!0):(we=!0,zt.__version=J.version);let Cn=zt.currentProgram;(we===!0||qs===!0)&&(Cn=qs===!0?Ii(J,G,j,Rt,Be):Ss(J,G,j),k&&J.isNodeMaterial&&k.onUpdateProgram(J,Cn,zt));let Io=!1,Ms=!1,Ys=!1,me=Cn.getUniforms(),xn=zt.uniforms;if(Et.useProgram(Cn.program)&&(Io=!0,Ms=!0,Ys=!0),J.id!==$&&($=J.id,Ms=!0),Io||tt!==R){Et.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),me.setValue(H,"projectionMatrix",R.projectionMatrix),me.setValue(H,"viewMatrix",R.matrixWorldInverse);let Pn=me.map.cameraPosition;Pn!==void 0&&Pn.setValue(H,Wn.setFromMatrixPosition(R.matrixWorld)),fe.logarithmicDepthBuffer&&me.setValue(H,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&me.setValue(H,"isOrthographic",R.isOrthographicCamera===!0),tt!==R&&(tt=R,Ms=!0,Ys=!0)}if(zt.needsLights&&(Rn.state.sunShadowMap.length>0&&me.setValue(H,"sunShadowMap",Rn.state.sunShadowMap,jt),Rn.state.directionalShadowMap.length>0&&me.setValue(H,"directionalShadowMap",Rn.state.directionalShadowMap,jt),Rn.state.spotShadowMap.length>0&&me.setValue(H,"spotShadowMap",Rn.state.spotShadowMap,jt),Rn.state.pointShadowMap.length>0&&me.setValue(H,"pointShadowMap",Rn.state.pointShadowMap,jt)),j.isSkinnedMesh){me.setOptional(H,j,"bindMatrix"),me.setOptional(H,j,"bindMatrixInverse");let ze=j.skeleton;ze&&(ze.boneTexture===null&&ze.computeBoneTexture(),me.setValue(H,"boneTexture",ze.boneTexture,jt))}j.isBatchedMesh&&(me.setOptional(H,j,"batchingTexture"),me.setValue(H,"batchingTexture",j._matricesTexture,jt),me.setOptional(H,j,"batchingIdTexture"),me.setValue(H,"batchingIdTexture",j._indirectTexture,jt),me.setOptional(H,j,"batchingColorTexture"),j._colorsTexture!==null&&me.setValue(H,"batchingColorTexture",j._colorsTexture,jt));let ci=Q.morphAttributes;if((ci.position!==void 0||ci.normal!==void 0||ci.color!==void 0)&&ot.update(j,Q,Cn),(Ms||zt.receiveShadow!==j.receiveShadow)&&(zt.receiveShadow=j.receiveShadow,me.setValue(H,"receiveShadow",j.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&G.environment!==null&&(xn.envMapIntensity.value=G.environmentIntensity),xn.dfgLUT!==void 0&&(xn.dfgLUT.value=pT()),Ms){if(me.setValue(H,"toneMappingExposure",I.toneMappingExposure),zt.needsLights&&Co(xn,Ys),At&&J.fog===!0&&xt.refreshFogUniforms(xn,At),xt.refreshMaterialUniforms(xn,J,wt,Pt,S.state.transmissionRenderTarget[R.id]),zt.needsLights&&zt.numLightProbeGrids>0){let ze=v,Pn=0;for(let ei of S.state.lightProbeGridArray)ei.texture!==null&&(ze.textures[Pn]=ei.texture,ze.min[Pn]=ei.boundingBox.min,ze.max[Pn]=ei.boundingBox.max,ze.resolution[Pn]=ei.resolution,Pn++);for(let ei in ze)ze[ei].length=Pn;xn.probesSH.value=ze.textures,xn.probesMin.value=ze.min,xn.probesMax.value=ze.max,xn.probesResolution.value=ze.resolution}Ma.upload(H,_r(zt),xn,jt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Ma.upload(H,_r(zt),xn,jt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&me.setValue(H,"center",j.center),me.setValue(H,"modelViewMatrix",j.modelViewMatrix),me.setValue(H,"normalMatrix",j.normalMatrix),me.setValue(H,"modelMatrix",j.matrixWorld),J.uniformsGroups!==void 0){let ze=J.uniformsGroups;for(let Pn=0,ei=ze.length;Pn<ei;Pn++){let _c=ze[Pn];$t.update(_c,Cn),$t.bind(_c,Cn)}}return Cn}function Co(R,G){R.ambientLightColor.needsUpdate=G,R.lightProbe.needsUpdate=G,R.sunLights.needsUpdate=G,R.sunLightShadows.needsUpdate=G,R.directionalLights.needsUpdate=G,R.directionalLightShadows.needsUpdate=G,R.pointLights.needsUpdate=G,R.pointLightShadows.needsUpdate=G,R.spotLights.needsUpdate=G,R.spotLightShadows.needsUpdate=G,R.rectAreaLights.needsUpdate=G,R.hemisphereLights.needsUpdate=G}function xr(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(R,G,Q){let J=Xt.get(R);J.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Xt.get(R.texture).__webglTexture=G,Xt.get(R.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:Q,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,G){let Q=Xt.get(R);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(R,G=0,Q=0){ct=R,Z=G,W=Q;let J=null,j=!1,At=!1;if(R){let Rt=Xt.get(R);if(Rt.__useDefaultFramebuffer!==void 0){Et.bindFramebuffer(H.FRAMEBUFFER,Rt.__webglFramebuffer),st.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest,Et.viewport(st),Et.scissor(ft),Et.setScissorTest(dt),$=-1;return}else if(Rt.__webglFramebuffer===void 0)jt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)jt.rebindTextures(R,Xt.get(R.texture).__webglTexture,Xt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ae=R.depthTexture;if(Rt.__boundDepthTexture!==ae){if(ae!==null&&Xt.has(ae)&&(R.width!==ae.image.width||R.height!==ae.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");jt.setupDepthRenderbuffer(R)}}let Nt=R.texture;(Nt.isData3DTexture||Nt.isDataArrayTexture||Nt.isCompressedArrayTexture)&&(At=!0);let Wt=Xt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Wt[G])?J=Wt[G][Q]:J=Wt[G],j=!0):R.samples>0&&jt.useMultisampledRTT(R)===!1?J=Xt.get(R).__webglMultisampledFramebuffer:Array.isArray(Wt)?J=Wt[Q]:J=Wt,st.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest}else st.copy(Yt).multiplyScalar(wt).floor(),ft.copy(_e).multiplyScalar(wt).floor(),dt=pe;if(Q!==0&&(J=X),Et.bindFramebuffer(H.FRAMEBUFFER,J)&&Et.drawBuffers(R,J),Et.viewport(st),Et.scissor(ft),Et.setScissorTest(dt),j){let Rt=Xt.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+G,Rt.__webglTexture,Q)}else if(At){let Rt=G;for(let Nt=0;Nt<R.textures.length;Nt++){let Wt=Xt.get(R.textures[Nt]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+Nt,Wt.__webglTexture,Q,Rt)}}else if(R!==null&&Q!==0){let Rt=Xt.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,Rt.__webglTexture,Q)}$=-1};function Po(R){let G=Xt.get(R);return(G.__readFormat!==R.format||G.__readType!==R.type)&&(G.__readFormat=R.format,G.__readType=R.type,G.__formatReadable=fe.textureFormatReadable(R.format),G.__typeReadable=fe.textureTypeReadable(R.type)),G}this.readRenderTargetPixels=function(R,G,Q,J,j,At,Dt,Rt=0){if(!(R&&R.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Nt=Xt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt){Et.bindFramebuffer(H.FRAMEBUFFER,Nt);try{let Wt=R.textures[Rt],ae=Wt.format,ye=Wt.type;R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+Rt);let Vt=Po(Wt);if(Vt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=R.width-J&&Q>=0&&Q<=R.height-j&&H.readPixels(G,Q,J,j,_t.convert(ae),_t.convert(ye),At)}finally{let Wt=ct!==null?Xt.get(ct).__webglFramebuffer:null;Et.bindFramebuffer(H.FRAMEBUFFER,Wt)}}},this.readRenderTargetPixelsAsync=async function(R,G,Q,J,j,At,Dt,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Nt=Xt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Dt!==void 0&&(Nt=Nt[Dt],Array.isArray(Nt)&&(Nt=Nt[0])),Nt)if(G>=0&&G<=R.width-J&&Q>=0&&Q<=R.height-j){Et.bindFramebuffer(H.FRAMEBUFFER,Nt);let Wt=R.textures[Rt],ae=Wt.format,ye=Wt.type;R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+Rt);let Vt=Po(Wt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ve=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,ve),H.bufferData(H.PIXEL_PACK_BUFFER,At.byteLength,H.STREAM_READ),H.readPixels(G,Q,J,j,_t.convert(ae),_t.convert(ye),0),H.bindBuffer(H.PIXEL_PACK_BUFFER,null);let fn=ct!==null?Xt.get(ct).__webglFramebuffer:null;Et.bindFramebuffer(H.FRAMEBUFFER,fn);let Be=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await K0(H,Be,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,ve),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,At),H.bindBuffer(H.PIXEL_PACK_BUFFER,null),H.deleteBuffer(ve),H.deleteSync(Be),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,G=null,Q=0){let J=Math.pow(2,-Q),j=Math.floor(R.image.width*J),At=Math.floor(R.image.height*J),Dt=G!==null?G.x:0,Rt=G!==null?G.y:0;jt.setTexture2D(R,0),H.copyTexSubImage2D(H.TEXTURE_2D,Q,0,0,Dt,Rt,j,At),Et.unbindTexture()},this.copyTextureToTexture=function(R,G,Q=null,J=null,j=0,At=0){let Dt,Rt,Nt,Wt,ae,ye,Vt,ve,fn,Be=R.isCompressedTexture?R.mipmaps[At]:R.image;if(Q!==null)Dt=Q.max.x-Q.min.x,Rt=Q.max.y-Q.min.y,Nt=Q.isBox3?Q.max.z-Q.min.z:1,Wt=Q.min.x,ae=Q.min.y,ye=Q.isBox3?Q.min.z:0;else{let me=Math.pow(2,-j);Dt=Math.floor(Be.width*me),Rt=Math.floor(Be.height*me),R.isDataArrayTexture?Nt=Be.depth:R.isData3DTexture?Nt=Math.floor(Be.depth*me):Nt=1,Wt=0,ae=0,ye=0}J!==null?(Vt=J.x,ve=J.y,fn=J.z):(Vt=0,ve=0,fn=0);let ke=_t.convert(G.format),Un=_t.convert(G.type),zt;G.isData3DTexture?(jt.setTexture3D(G,0),zt=H.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(jt.setTexture2DArray(G,0),zt=H.TEXTURE_2D_ARRAY):(jt.setTexture2D(G,0),zt=H.TEXTURE_2D),Et.activeTexture(H.TEXTURE0),Et.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,G.flipY),Et.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Et.pixelStorei(H.UNPACK_ALIGNMENT,G.unpackAlignment);let Rn=Et.getParameter(H.UNPACK_ROW_LENGTH),we=Et.getParameter(H.UNPACK_IMAGE_HEIGHT),qs=Et.getParameter(H.UNPACK_SKIP_PIXELS),Cn=Et.getParameter(H.UNPACK_SKIP_ROWS),Io=Et.getParameter(H.UNPACK_SKIP_IMAGES);Et.pixelStorei(H.UNPACK_ROW_LENGTH,Be.width),Et.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Be.height),Et.pixelStorei(H.UNPACK_SKIP_PIXELS,Wt),Et.pixelStorei(H.UNPACK_SKIP_ROWS,ae),Et.pixelStorei(H.UNPACK_SKIP_IMAGES,ye);let Ms=R.isDataArrayTexture||R.isData3DTexture,Ys=G.isDataArrayTexture||G.isData3DTexture;if(R.isDepthTexture){let me=Xt.get(R),xn=Xt.get(G),ci=Xt.get(me.__renderTarget),ze=Xt.get(xn.__renderTarget);Et.bindFramebuffer(H.READ_FRAMEBUFFER,ci.__webglFramebuffer),Et.bindFramebuffer(H.DRAW_FRAMEBUFFER,ze.__webglFramebuffer);for(let Pn=0;Pn<Nt;Pn++)Ms&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,Xt.get(R).__webglTexture,j,ye+Pn),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,Xt.get(G).__webglTexture,At,fn+Pn)),H.blitFramebuffer(Wt,ae,Wt+Dt,ae+Rt,Vt,ve,Vt+Dt,ve+Rt,H.DEPTH_BUFFER_BIT,H.NEAREST);Et.bindFramebuffer(H.READ_FRAMEBUFFER,null),Et.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||Xt.has(R)){let me=Xt.get(R),xn=Xt.get(G);Et.bindFramebuffer(H.READ_FRAMEBUFFER,U),Et.bindFramebuffer(H.DRAW_FRAMEBUFFER,V);for(let ci=0;ci<Nt;ci++)Ms?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,me.__webglTexture,j,ye+ci):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,me.__webglTexture,j),Ys?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,xn.__webglTexture,At,fn+ci):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,xn.__webglTexture,At),j!==0?H.blitFramebuffer(Wt,ae,Wt+Dt,ae+Rt,Vt,ve,Vt+Dt,ve+Rt,H.COLOR_BUFFER_BIT,H.NEAREST):Ys?H.copyTexSubImage3D(zt,At,Vt,ve,fn+ci,Wt,ae,Dt,Rt):H.copyTexSubImage2D(zt,At,Vt,ve,Wt,ae,Dt,Rt);Et.bindFramebuffer(H.READ_FRAMEBUFFER,null),Et.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else Ys?R.isDataTexture||R.isData3DTexture?H.texSubImage3D(zt,At,Vt,ve,fn,Dt,Rt,Nt,ke,Un,Be.data):G.isCompressedArrayTexture?H.compressedTexSubImage3D(zt,At,Vt,ve,fn,Dt,Rt,Nt,ke,Be.data):H.texSubImage3D(zt,At,Vt,ve,fn,Dt,Rt,Nt,ke,Un,Be):R.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,At,Vt,ve,Dt,Rt,ke,Un,Be.data):R.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,At,Vt,ve,Be.width,Be.height,ke,Be.data):H.texSubImage2D(H.TEXTURE_2D,At,Vt,ve,Dt,Rt,ke,Un,Be);Et.pixelStorei(H.UNPACK_ROW_LENGTH,Rn),Et.pixelStorei(H.UNPACK_IMAGE_HEIGHT,we),Et.pixelStorei(H.UNPACK_SKIP_PIXELS,qs),Et.pixelStorei(H.UNPACK_SKIP_ROWS,Cn),Et.pixelStorei(H.UNPACK_SKIP_IMAGES,Io),At===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&H.generateMipmap(zt),Et.unbindTexture()},this.initRenderTarget=function(R){Xt.get(R).__webglFramebuffer===void 0&&jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?jt.setTextureCube(R,0):R.isData3DTexture?jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?jt.setTexture2DArray(R,0):jt.setTexture2D(R,0),Et.unbindTexture()},this.resetState=function(){Z=0,W=0,ct=null,Et.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ee._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ee._getUnpackColorSpace()}};var O_={type:"change"},Lp={type:"start"},k_={type:"end"},Ou=new ar,B_=new gi,mT=Math.cos(70*Sa.DEG2RAD),kn=new B,Ti=2*Math.PI,Ne={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ip=1e-6,Bu=class extends lo{constructor(t,e=null){super(t,e),this.state=Ne.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ur.ROTATE,MIDDLE:Ur.DOLLY,RIGHT:Ur.PAN},this.touches={ONE:Fr.ROTATE,TWO:Fr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new Je,this._lastTargetPosition=new B,this._quat=new Je().setFromUnitVectors(t.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new _a,this._sphericalDelta=new _a,this._scale=1,this._panOffset=new B,this._rotateStart=new qt,this._rotateEnd=new qt,this._rotateDelta=new qt,this._panStart=new qt,this._panEnd=new qt,this._panDelta=new qt,this._dollyStart=new qt,this._dollyEnd=new qt,this._dollyDelta=new qt,this._dollyDirection=new B,this._mouse=new qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=_T.bind(this),this._onPointerDown=gT.bind(this),this._onPointerUp=xT.bind(this),this._onContextMenu=ET.bind(this),this._onMouseWheel=bT.bind(this),this._onKeyDown=ST.bind(this),this._onTouchStart=MT.bind(this),this._onTouchMove=wT.bind(this),this._onMouseDown=yT.bind(this),this._onMouseMove=vT.bind(this),this._interceptControlDown=TT.bind(this),this._interceptControlUp=AT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ne.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(O_),this.update(),this.state=Ne.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;kn.copy(e).sub(this.target),kn.applyQuaternion(this._quat),this._spherical.setFromVector3(kn),this.autoRotate&&this.state===Ne.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Ti:i>Math.PI&&(i-=Ti),s<-Math.PI?s+=Ti:s>Math.PI&&(s-=Ti),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(kn.setFromSpherical(this._spherical),kn.applyQuaternion(this._quatInverse),e.copy(this.target).add(kn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=kn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new B(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=kn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ou.origin.copy(this.object.position),Ou.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ou.direction))<mT?this.object.lookAt(this.target):(B_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ou.intersectPlane(B_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Ip||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ip||this._lastTargetPosition.distanceToSquared(this.target)>Ip?(this.dispatchEvent(O_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Ti/60*this.autoRotateSpeed*t:Ti/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){kn.setFromMatrixColumn(e,0),kn.multiplyScalar(-t),this._panOffset.add(kn)}_panUp(t,e){this.screenSpacePanning===!0?kn.setFromMatrixColumn(e,1):(kn.setFromMatrixColumn(e,0),kn.crossVectors(this.object.up,kn)),kn.multiplyScalar(t),this._panOffset.add(kn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;kn.copy(s).sub(this.target);let r=kn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ti*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ti*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Ti*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ti*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ti*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function gT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function _T(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function xT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(k_),this.state=Ne.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function yT(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ne.DOLLY;break;case Ur.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ne.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ne.ROTATE}break;case Ur.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ne.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ne.PAN}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Lp)}function vT(n){switch(this.state){case Ne.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ne.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ne.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function bT(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ne.NONE||(n.preventDefault(),this.dispatchEvent(Lp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(k_))}function ST(n){this.enabled!==!1&&this._handleKeyDown(n)}function MT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Fr.ROTATE:if(this.enableRotate===!1){this.state=Ne.NONE;break}this._handleTouchStartRotate(n),this.state=Ne.TOUCH_ROTATE;break;case Fr.PAN:if(this.enablePan===!1){this.state=Ne.NONE;break}this._handleTouchStartPan(n),this.state=Ne.TOUCH_PAN;break;default:this.state=Ne.NONE}break;case 2:switch(this.touches.TWO){case Fr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ne.TOUCH_DOLLY_PAN;break;case Fr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ne.TOUCH_DOLLY_ROTATE;break;default:this.state=Ne.NONE}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Lp)}function wT(n){switch(this._trackPointer(n),this.state){case Ne.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ne.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ne.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ne.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ne.NONE}}function ET(n){this.enabled!==!1&&n.preventDefault()}function TT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function AT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var z_=[1,.75,.55,.42],RT=30,CT=17,PT=400,H_=6e6;function G_(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var ku=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(H_/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>RT&&this.level<z_.length-1?this.level+=1:i<CT&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*z_[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(H_/this.area),.5))),this.draw()},PT)}};var X_=32,q_={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},oi=new xl,pn=new _i(X_,1,.01,100);pn.up.set(0,0,1);var ji,zn,Ji,Up,Dp=!1,Y_=!1,Fp=0;function rn(){Dp||!Y_||(Dp=!0,requestAnimationFrame($_))}function $_(n=performance.now()){Dp=!1,Up.moving(n),Z_()}function Z_(){ji.render(oi,pn),Fp+=1}function J_(){Y_=!0,rn()}var j_=()=>Fp;oi.fog=new _l("#fff",1,10);function V_(n){let t=document.createElement("canvas");t.width=Ji.clientWidth||1,t.height=Ji.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>IT.has(s)?i(s):null,e}var IT=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function K_(n){Ji=n;let t=V_(!1),e=G_(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=V_(!0)),ji=new Nu({canvas:t.canvas,context:t}),ji.debug.checkShaderErrors=!1,Up=new ku(e,ji,Z_,i=>ie("hurry",i)),ji.domElement.setAttribute("aria-hidden","true"),Ji.append(ji.domElement),zn=new Bu(pn,ji.domElement),zn.enableDamping=!1,zn.addEventListener("change",rn),zn.addEventListener("end",()=>{Hu=!tx()}),new ResizeObserver(LT).observe(Ji),Ji.tabIndex=0,Ji.setAttribute("role","application"),Ji.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),Ji.addEventListener("keydown",DT)}function LT(){let n=Ji.clientWidth,t=Ji.clientHeight;!n||!t||(Up.resized(n,t),ji.setSize(n,t),pn.aspect=n/t,pn.updateProjectionMatrix(),Fp?$_():rn(),kp())}function DT(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)NT(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")W_(1/1.15);else if(n.key==="-")W_(1.15);else if(n.key.toLowerCase()==="f")zu(go);else if(e)Bp(e);else return;n.preventDefault()}function NT(n,t){let e=pn.position.clone().sub(zn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);pn.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(zn.target),zn.update(),rn()}function W_(n){pn.position.sub(zn.target).multiplyScalar(n).add(zn.target),zn.update(),rn()}var go=[[0,0,0],[0,0,1]];function Q_(n,t){let e=new wi().setFromPoints(n.map(h=>new B(...h))),i=e.getCenter(new B),s=new B(...t).normalize(),r=new B().crossVectors(pn.up,s).normalize(),o=new B().crossVectors(s,r),a=Math.tan(Sa.degToRad(X_/2))*.8,l=a*pn.aspect,c=e.getSize(new B).length()*.4+.001;for(let h=0;h<3;h++){let f=0,u=1/0,d=-1/0,g=1/0,_=-1/0;for(let m of n){let p=new B(...m).sub(i),y=p.dot(r),w=p.dot(o),v=p.dot(s);f=Math.max(f,v+Math.abs(y)/l,v+Math.abs(w)/a),u=Math.min(u,w),d=Math.max(d,w),g=Math.min(g,y),_=Math.max(_,y)}c=Math.max(f,c*.2),h<2&&i.addScaledVector(o,(u+d)/2).addScaledVector(r,(g+_)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var Np=0;function Op({target:n,position:t},e=.35){let i={t:zn.target.clone(),p:pn.position.clone()},s=performance.now(),r=++Np,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==Np)return;let c=o?1:Math.min((l-s)/(1e3*e),1),h=c*c*(3-2*c);zn.target.lerpVectors(i.t,n,h),pn.position.lerpVectors(i.p,t,h);let f=pn.position.distanceTo(zn.target);pn.near=f/100,pn.far=f*30,oi.fog.near=f*1.3,oi.fog.far=f*3.4,pn.updateProjectionMatrix(),zn.update(),rn(),c<1&&requestAnimationFrame(a)})(s)}function zu(n,{instant:t=!1,view:e=null}={}){go=n,Hu=!1;let i=e?q_[e]:pn.position.clone().sub(zn.target).toArray();Op(Q_(n,i),t?0:.35)}function Bp(n){Hu=!1,Op(Q_(go,q_[n]))}var Hu=!1;function tx(){pn.updateMatrixWorld();let n=new B;return go.every(t=>(n.set(...t).project(pn),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function kp(){!Hu&&zn.enabled&&go.length&&!tx()&&zu(go)}var zp=n=>{go=n},Gu=()=>[...pn.position.toArray(),...zn.target.toArray()].map(n=>Number(n.toPrecision(5)));function ex(n){Np+=1,Op({position:new B(...n.slice(0,3)),target:new B(...n.slice(3))},0)}var zs=null,Hp={cell:.1};function Gp(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(h=>h*e).findLast(h=>h<=t*1.0001)??e;Hp.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new Qt(be.gridFine),l=new Qt(be.gridCoarse);for(let h=-s;h<=s;h++){let f=h%5===0?l:a,u=s*i;r.push(h*i,-u,0,h*i,u,0,-u,h*i,0,u,h*i,0);for(let d=0;d<4;d++)o.push(f.r,f.g,f.b)}zs?.geometry.dispose();let c=new Ce;c.setAttribute("position",new Te(r,3)),c.setAttribute("color",new Te(o,3)),zs?zs.geometry=c:(zs=new so(c,new us({vertexColors:!0})),zs.renderOrder=-2,zs.material.depthWrite=!1,oi.add(zs)),zs.userData.reach=n,rn()}function Vp(){oi.background=new Qt(be.ground),oi.fog.color.set(be.ground),zs&&Gp(zs.userData.reach),rn()}function nx(n){let t=new B(...n).project(pn),e=Ji.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function Vu(n){let t=n.joints.length,e=ko(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function Wp(n,t,e){let i={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:s,size:r}=e,o=n.joints.length,a=r*1e-6,l=rd(n,t),c=(f,u,d,g=!0)=>{Rs(ss(u,f))<=a||(i.rods.push({a:f,b:u,r:d}),g&&i.balls.push({at:u,r:d}))};o&&(i.pedestal={at:Xe(t[0]),dir:id(t[0],2),r:s[0]*1.7,h:s[0]*.34});let h=null;if(l.forEach(({point:f,dir:u,x:d},g)=>{let _=s[g],m=n.joints[g],p=Xe(t[g]),y=Xe(t[g+1]),w=_*.62;if(n.convention==="standard"){let S=vc(p,u,sd(ss(y,p),u));c(p,S,w),c(S,y,w)}else c(p,f,w),c(f,y,w);let v=f,C=sd(ss(y,f),u);h&&Rs(ss(f,h.at))<.5*_&&Math.abs(C)>a?v=vc(f,u,Math.sign(C)*Math.min(Math.abs(C)*.55,h.r+_*1.15)):g===0&&Math.abs(C)>2.2*_&&(v=vc(f,u,Math.sign(C)*_*1.25)),m.type==="R"?i.drums.push({at:v,dir:u,x:d,r:_,h:_*2.15,joint:g}):i.sleeves.push({at:v,dir:u,x:d,r:_*.95,h:_*3.4,joint:g}),h={at:f,r:_}}),o){let f=t[o+1],u=Xe(t[o]);i.flange={at:u,dir:id(t[o],2),r:e.rest*.85,h:e.rest*.5},c(u,Xe(f),e.rest*.34,!1),i.tip={at:Xe(f),r:e.rest*.42}}return i}function Wu(n,t){let e=Vu(n).radius[0]??.05,i=Xe(t[0]),s=[[i[0],i[1],0],...t.map(Xe)];for(let{point:r}of rd(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function FT(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new Pl(s.map(([a,l])=>new qt(a,l)),n):new hn(1,1,1,n),o={rod:i(new hn(1,1,1,n,1,!0)),ball:t>3?new ao(1,n,t):new Fs(1,0),drum:i(r),box:new cn(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,h=l.index?l.index.array:Uint16Array.from({length:c.count},(f,u)=>u);return[a,{at:c.array,normal:l.attributes.normal.array,index:h,count:c.count}]}))}var ix=new Map,qp=(n,t)=>ix.get(n)??ix.set(n,FT(n,t)).get(n),OT=()=>qp(26,12),Xp=()=>qp(11,5),sx=()=>qp(6,3),qu=class{constructor(t){this.mesh=new Ft(new Ce,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Ce,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let h=new sn(c,l).setUsage(Cu);return s.setAttribute(a,h),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new sn(o,1).setUsage(Cu)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l){let c=this.corners,h=c+t.count;(3*h>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(h,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let f=0,u=3*c;f<3*t.count;f+=3,u+=3){let d=a*t.at[f],g=a*t.at[f+1],_=l*t.at[f+2],m=t.normal[f]/a,p=t.normal[f+1]/a,y=t.normal[f+2]/l;for(let w=0;w<3;w++)this.at[u+w]=i[w]+s[w]*d+r[w]*g+o[w]*_,this.normal[u+w]=s[w]*m+r[w]*p+o[w]*y}this.paint.fill(e,c,h);for(let f=0;f<t.index.length;f++)this.index[this.indices+f]=c+t.index[f];this.corners=h,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},ax=[1,0,0],BT=[0,1,0],lx=[0,0,1];function kT(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:bc(n,Math.abs(n[2])<.9?lx:ax),i=bc(n,e),s=Rs(i)||1,r=i.map(o=>o/s);return[bc(r,n),r]}var rx=0,Xu=1,ox=2,Ea=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new ls,this.veil=i,this.moving=!1,this.arms=[],this.body=new qu(t),this.group.add(this.body.mesh),e&&(this.flat=new qu(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?sx:Xp:this.moving?Xp:OT;for(let i of t)this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of t)this.#t(this.flat,i,this.moving?sx():Xp(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,h,f,u,d,g,_)=>t.put(c,h,f,...kT(u,_),u,d,g),l=(c,h,f)=>t.put(i.ball,c,h,ax,BT,lx,f,f);for(let{a:c,b:h,r:f}of e.rods){let u=ss(h,c),d=Rs(u),g=[(c[0]+h[0])/2,(c[1]+h[1])/2,(c[2]+h[2])/2];a(i.rod,rx,g,u.map(_=>_/d),r*f,d)}for(let{at:c,r:h}of e.balls)l(rx,c,r*h);for(let{at:c,dir:h,r:f,h:u}of e.drums)a(i.drum,Xu,c,h,r*f,r*u),o&&a(i.rod,ox,c,h,f*1.012,u*.13);for(let{at:c,dir:h,x:f,r:u,h:d}of e.sleeves)a(i.box,Xu,c,h,r*u,r*d,f);if(e.pedestal&&!this.veil){let{at:c,dir:h,r:f,h:u}=e.pedestal;a(i.drum,Xu,[c[0]+h[0]*u/2,c[1]+h[1]*u/2,c[2]+h[2]*u/2],h,f,u)}e.flange&&a(i.drum,Xu,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.tip&&o&&l(ox,e.tip.at,e.tip.r)}};var zT=`
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
  }`,HT=`
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
  }`,GT=`
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
  }`,VT=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Yu({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new $i({vertexShader:e?GT:zT,fragmentShader:e?VT:HT,transparent:n<1,uniforms:{colours:{value:[new Qt,new Qt,new Qt]},opacity:{value:n},gloss:{value:t},sky:{value:new Qt(.46,.46,.47)},ground:{value:new Qt(.2,.2,.21)}}});return i.repaint=(s,r,o,a)=>{[s,r,o].forEach((l,c)=>i.uniforms.colours.value[c].set(l)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function Yp(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Ce;l.morphTargetsRelative=a;let c=0;for(let h=0;h<n.length;++h){let f=n[h],u=0,d=0;if(e!==(f.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let g in f.attributes){if(!i.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+g+'" attribute exists among all geometries, or in none of them.'),null;r[g]===void 0&&(r[g]=[]),r[g].push(f.attributes[g]),u++}if(u!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==f.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let g in f.morphAttributes){if(!s.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(f.morphAttributes[g].length!==n[0].morphAttributes[g].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+g+'" morph attribute.'),null;o[g]===void 0&&(o[g]=[]),o[g].push(f.morphAttributes[g]),d++}if(d!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(t){let g;if(e)g=f.index.count;else if(f.attributes.position!==void 0)g=f.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,g,h),c+=g}}if(e){let h=0,f=[];for(let u=0;u<n.length;++u){let d=n[u].index;for(let g=0;g<d.count;++g)f.push(d.getX(g)+h);h+=n[u].attributes.position.count}l.setIndex(f)}for(let h in r){let f=cx(r[h]);if(!f)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,f)}for(let h in o){let f=o[h][0].length;if(f!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let u=0;u<f;++u){let d=[];for(let _=0;_<o[h].length;++_)d.push(o[h][_][u]);let g=cx(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(g)}}}return l}function cx(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let h=n[c];if(t===void 0&&(t=h.array.constructor),t!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=h.itemSize),e!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=h.normalized),i!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*e}let o=new t(r),a=new sn(o,e,i),l=0;for(let c=0;c<n.length;++c){let h=n[c];if(h.isInterleavedBufferAttribute){let f=l/e;for(let u=0,d=h.count;u<d;u++)for(let g=0;g<e;g++){let _=h.getComponent(u,g);a.setComponent(u+f,g,_)}}else o.set(h.array,l);l+=h.count*e}return s!==void 0&&(a.gpuType=s),a}var ql=["#d8343f","#1b9a50","#2f6fe0"];function $p(n,t){let e=new hn(.028,.028,.82,8).translate(0,.41,0),i=new Cl(.085,.22,12).translate(0,.9,0),s=Yp([e,i]).applyMatrix4(t),r=new Qt(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new sn(o,3)),s}var Zp=n=>new Me().makeRotationFromQuaternion(new Je().setFromUnitVectors(new B(0,1,0),new B(...n))),WT=Yp([$p(ql[0],Zp([1,0,0])),$p(ql[1],Zp([0,1,0])),$p(ql[2],Zp([0,0,1]))]),hx=.021,Yl=new Map;function XT(n){let t=`${n}/${be.dark}`;if(Yl.has(t))return Yl.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=be.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=be.ink,s.fillText(n,e.width/2,e.height/2);let o=new Tl(e);o.colorSpace=mi;let a=new pa({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,Yl.set(t,a),a}var $u=class{constructor(){this.group=new ls,this.mesh=new wl(WT,new hs({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new Me;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new B(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new Sl);a.parent||this.group.add(a),a.material=XT(r),a.scale.set(hx*a.material.userData.aspect,hx,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of Yl.values())t.map.dispose(),t.dispose();Yl.clear(),this.last&&this.show(...this.last)}};var px=Yu(),ux=[.32,-.4,1],mx=new hs({color:"#000",transparent:!0,opacity:.1,side:Ei,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:ap,stencilRef:1,stencilZPass:op,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),qT=new Me().set(1,0,-ux[0],0,0,1,-ux[1],0,0,0,0,5e-4,0,0,0,1),Jp=new Ea(px,{shadow:{material:mx,matrix:qT}}),gx=Yu({opacity:.2,veil:!0}),Zu=new Ea(gx,{veil:!0}),_x=Yu({opacity:.62,gloss:.1}),jp=new Ea(_x,{veil:!0}),Kp=new $u,_o=Vu(N.table),Qu=[],ju=null;function xx(){oi.add(Jp.group,Zu.group,jp.group,Kp.group),Zu.group.renderOrder=1,yt("table",n=>{_o=Vu(N.table),Gp(_o.size),Qu=[],ju=null,Qp(),ef(),n==="new"&&Hr({instant:!0,view:"iso"}),J_()}),yt("q",YT),yt("frames",vx),yt("theme",dx),yt("hurry",n=>{for(let t of[Jp,Zu,jp])t.hurry(n)}),dx()}var fx=new Map,Ku=[];function Ta(n,t){fx.set(n,t),Ku=[...fx.values()].flat(),N.table.joints.length&&(zp([...Wu(N.table,N.frames),...Ku]),t.length&&yx())}function Hr(n){zu([...Wu(N.table,N.frames),...Ku],n)}var yx=js(kp,220);function YT(){let n=N.frames;Jp.show(N.table.joints.length?[Wp(N.table,n,_o)]:[]),zp([...Wu(N.table,n),...Ku]),yx(),wx&&$T(Xe(n[n.length-1])),vx()}function vx(){Kp.show((N.shownFrames??[]).filter(n=>n<N.frames.length).map(n=>({T:N.frames[n],name:tf(n)})),_o.size*.13),rn()}function tf(n){let t=N.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function bx(n){Qu=n,Qp()}function Aa(n){ju=n,Qp()}var Sx=()=>Qu.length;function Qp(){let n=t=>Wp(N.table,Mr(N.table,t),_o);Zu.show(Qu.map(n)),jp.show(ju?[n(ju)]:[]),rn()}var Mx=6e3,Ju=new Float32Array(6*Mx),dr=new so(new Ce,new us({fog:!1}));dr.geometry.setAttribute("position",new sn(Ju,3));dr.frustumCulled=!1;dr.visible=!1;var zr=0,wx=!0,$l=null;oi.add(dr);function $T(n){let t=$l?Rs(ss(n,$l)):1/0;t<_o.size*.002||(t<_o.size*.2&&(zr===Mx&&(Ju.copyWithin(0,6*1e3),zr-=1e3),Ju.set($l,6*zr),Ju.set(n,6*zr+3),zr+=1,dr.geometry.setDrawRange(0,2*zr),dr.geometry.attributes.position.needsUpdate=!0,dr.visible=!0),$l=n)}function Ex(n){wx=n,n||ef(),rn()}function ef(){zr=0,$l=null,dr.visible=!1,rn()}var Tx=()=>zr,Zl=new vi(new Ce,new us({fog:!1}));Zl.frustumCulled=!1;var Jl=new ro(new Ce,new Ir({size:4,sizeAttenuation:!1,fog:!1}));Jl.frustumCulled=!1;Zl.visible=Jl.visible=!1;oi.add(Zl,Jl);function nf(n){Ta("path",n);let t=new Float32Array(n.flat());for(let e of[Zl,Jl])e.geometry.dispose(),e.geometry=new Ce,e.geometry.setAttribute("position",new sn(t,3)),e.visible=n.length>0;rn()}function dx(){px.repaint(be.link,be.joint,be.accent,be.dark),gx.repaint(be.ghost,be.ghost,be.ghost,be.dark),_x.repaint(be.accent,be.accent,be.accent,be.dark),dr.material.color.set(be.accent),Zl.material.color.set(be.trace),Jl.material.color.set(be.trace),mx.opacity=be.dark?.28:.11,Kp.paint(),rn()}var xo=new Dl,Sn=new B,Gr=new B,un=new Je,Ax={X:new B(1,0,0),Y:new B(0,1,0),Z:new B(0,0,1)},tm={type:"change"},Rx={type:"mouseDown",mode:null},Cx={type:"mouseUp",mode:null},Px={type:"objectChange"},lf=class extends lo{constructor(t,e=null){super(void 0,e);let i=new nm(this);this._root=i;let s=new im;this._gizmo=s,i.add(s);let r=new sm;this._plane=r,i.add(r);let o=this;function a(w,v){let C=v;Object.defineProperty(o,w,{get:function(){return C!==void 0?C:v},set:function(S){C!==S&&(C=S,r[w]=S,s[w]=S,o.dispatchEvent({type:w+"-changed",value:S}),o.dispatchEvent(tm))}}),o[w]=v,r[w]=v,s[w]=v}a("camera",t),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new B,c=new B,h=new Je,f=new Je,u=new B,d=new Je,g=new B,_=new B,m=new B,p=0,y=new B;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",h),a("worldQuaternionStart",f),a("cameraPosition",u),a("cameraQuaternion",d),a("pointStart",g),a("pointEnd",_),a("rotationAxis",m),a("rotationAngle",p),a("eye",y),this._offset=new B,this._startNorm=new B,this._endNorm=new B,this._cameraScale=new B,this._parentPosition=new B,this._parentQuaternion=new Je,this._parentQuaternionInv=new Je,this._parentScale=new B,this._worldScaleStart=new B,this._worldQuaternionInv=new Je,this._worldScale=new B,this._positionStart=new B,this._quaternionStart=new Je,this._scaleStart=new B,this._getPointer=JT.bind(this),this._onPointerDown=KT.bind(this),this._onPointerHover=jT.bind(this),this._onPointerMove=QT.bind(this),this._onPointerUp=tA.bind(this),e!==null&&this.connect(e)}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(t){if(this.object===void 0||this.dragging===!0)return;t!==null&&xo.setFromCamera(t,this.camera);let e=em(this._gizmo.picker[this.mode],xo);e?this.axis=e.object.name:this.axis=null}pointerDown(t){if(!(this.object===void 0||this.dragging===!0||t!=null&&t.button!==0)&&this.axis!==null){t!==null&&xo.setFromCamera(t,this.camera);let e=em(this._plane,xo,!0);e&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(e.point).sub(this.worldPositionStart)),this.dragging=!0,Rx.mode=this.mode,this.dispatchEvent(Rx)}}pointerMove(t){let e=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(e==="E"||e==="XYZE"||e==="XYZ")&&(r="world"),s===void 0||e===null||this.dragging===!1||t!==null&&t.button!==-1)return;t!==null&&xo.setFromCamera(t,this.camera);let o=em(this._plane,xo,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&e!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),e.indexOf("X")===-1&&(this._offset.x=0),e.indexOf("Y")===-1&&(this._offset.y=0),e.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&e!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(un.copy(this._quaternionStart).invert()),e.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(Sn),e.search("X")!==-1&&(Sn.x=Math.round(Sn.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(Sn.y=Math.round(Sn.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(Sn.z=Math.round(Sn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(Sn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(e.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Gr.set(a,a,a)}else Sn.copy(this.pointStart),Gr.copy(this.pointEnd),Sn.applyQuaternion(this._worldQuaternionInv),Gr.applyQuaternion(this._worldQuaternionInv),Gr.divide(Sn),e.search("X")===-1&&(Gr.x=1),e.search("Y")===-1&&(Gr.y=1),e.search("Z")===-1&&(Gr.z=1);s.scale.copy(this._scaleStart).multiply(Gr),this.scaleSnap&&(e.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(Sn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;e==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(Sn.copy(this.rotationAxis).cross(this.eye))*a):(e==="X"||e==="Y"||e==="Z")&&(this.rotationAxis.copy(Ax[e]),Sn.copy(Ax[e]),r==="local"&&Sn.applyQuaternion(this.worldQuaternion),Sn.cross(this.eye),Sn.length()===0?l=!0:this.rotationAngle=this._offset.dot(Sn.normalize())*a),(e==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&e!=="E"&&e!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(un.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(un.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(tm),this.dispatchEvent(Px)}}pointerUp(t){t!==null&&t.button!==0||(this.dragging&&this.axis!==null&&(Cx.mode=this.mode,this.dispatchEvent(Cx)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(t){return this.object=t,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(tm),this.dispatchEvent(Px),this.pointStart.copy(this.pointEnd))}getRaycaster(){return xo}getMode(){return this.mode}setMode(t){this.mode=t}setTranslationSnap(t){this.translationSnap=t}setRotationSnap(t){this.rotationSnap=t}setScaleSnap(t){this.scaleSnap=t}setSize(t){this.size=t}setSpace(t){this.space=t}setColors(t,e,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(t),r.yAxis.color.set(e),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(t),r.yAxisTransparent.color.set(e),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(t),r.yAxis._color&&r.yAxis._color.set(e),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(t),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(e),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function JT(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let t=this.domElement.getBoundingClientRect(),e=this.viewport,i,s,r,o;return e!==null?(i=e.x,s=t.height-e.y-e.w,r=e.z,o=e.w):(i=0,s=0,r=t.width,o=t.height),{x:(n.clientX-t.left-i)/r*2-1,y:-(n.clientY-t.top-s)/o*2+1,button:n.button}}}function jT(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function KT(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function QT(n){this.enabled&&this.pointerMove(this._getPointer(n))}function tA(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function em(n,t,e){let i=t.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||e)return i[s];return!1}var sf=new Ds,qe=new B(0,1,0),Ix=new B(0,0,0),Lx=new Me,rf=new Je,af=new Je,Hs=new B,cf=new Me,Ql=new B(1,0,0),yo=new B(0,1,0),tc=new B(0,0,1),of=new B,jl=new B,Kl=new B,nm=class extends En{constructor(t){super(),this.isTransformControlsRoot=!0,this.controls=t,this.visible=!1}updateMatrixWorld(t){let e=this.controls;e.object!==void 0&&(e.object.updateMatrixWorld(),e.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):e.object.parent.matrixWorld.decompose(e._parentPosition,e._parentQuaternion,e._parentScale),e.object.matrixWorld.decompose(e.worldPosition,e.worldQuaternion,e._worldScale),e._parentQuaternionInv.copy(e._parentQuaternion).invert(),e._worldQuaternionInv.copy(e.worldQuaternion).invert()),e.camera.updateMatrixWorld(),e.camera.matrixWorld.decompose(e.cameraPosition,e.cameraQuaternion,e._cameraScale),e.camera.isOrthographicCamera?e.camera.getWorldDirection(e.eye).negate():e.eye.copy(e.cameraPosition).sub(e.worldPosition).normalize(),this.parent&&(cf.copy(this.parent.matrixWorld).invert(),cf.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(t)}dispose(){this.traverse(function(t){t.geometry&&t.geometry.dispose(),t.material&&t.material.dispose()})}},im=class extends En{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let t=new hs({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),e=new us({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=t.clone();i.opacity=.15;let s=e.clone();s.opacity=.5;let r=t.clone();r.color.setHex(16711680);let o=t.clone();o.color.setHex(65280);let a=t.clone();a.color.setHex(255);let l=t.clone();l.color.setHex(16711680),l.opacity=.5;let c=t.clone();c.color.setHex(65280),c.opacity=.5;let h=t.clone();h.color.setHex(255),h.opacity=.5;let f=t.clone();f.opacity=.25;let u=t.clone();u.color.setHex(16776960),u.opacity=.25;let d=t.clone();d.color.setHex(16776960);let g=t.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:d,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:u};let _=new hn(0,.04,.1,12);_.translate(0,.05,0);let m=new cn(.08,.08,.08);m.translate(0,.04,0);let p=new Ce;p.setAttribute("position",new Te([0,0,0,1,0,0],3));let y=new hn(.0075,.0075,.5,3);y.translate(0,.25,0);function w(V,Z){let W=new cr(V,.0075,3,64,Z*Math.PI*2);return W.rotateY(Math.PI/2),W.rotateX(Math.PI/2),W}function v(){let V=new Ce;return V.setAttribute("position",new Te([0,0,0,1,1,1],3)),V}let C={X:[[new Ft(_,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ft(_,r),[-.5,0,0],[0,0,Math.PI/2]],[new Ft(y,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Ft(_,o),[0,.5,0]],[new Ft(_,o),[0,-.5,0],[Math.PI,0,0]],[new Ft(y,o)]],Z:[[new Ft(_,a),[0,0,.5],[Math.PI/2,0,0]],[new Ft(_,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Ft(y,a),null,[Math.PI/2,0,0]]],XYZ:[[new Ft(new Fs(.1,0),f),[0,0,0]]],XY:[[new Ft(new cn(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new Ft(new cn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new cn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},S={X:[[new Ft(new hn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ft(new hn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ft(new hn(.2,0,.6,4),i),[0,.3,0]],[new Ft(new hn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ft(new hn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ft(new hn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Ft(new Fs(.2,0),i)]],XY:[[new Ft(new cn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ft(new cn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new cn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},x={START:[[new Ft(new Fs(.01,2),s),null,null,null,"helper"]],END:[[new Ft(new Fs(.01,2),s),null,null,null,"helper"]],DELTA:[[new vi(v(),s),null,null,null,"helper"]],X:[[new vi(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new vi(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new vi(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},M={XYZE:[[new Ft(w(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new Ft(w(.5,.5),r)]],Y:[[new Ft(w(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Ft(w(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Ft(w(.75,1),u),null,[0,Math.PI/2,0]]]},F={AXIS:[[new vi(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},I={XYZE:[[new Ft(new ao(.25,10,8),i)]],X:[[new Ft(new cr(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Ft(new cr(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Ft(new cr(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Ft(new cr(.75,.1,2,24),i)]]},D={X:[[new Ft(m,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ft(y,r),[0,0,0],[0,0,-Math.PI/2]],[new Ft(m,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Ft(m,o),[0,.5,0]],[new Ft(y,o)],[new Ft(m,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Ft(m,a),[0,0,.5],[Math.PI/2,0,0]],[new Ft(y,a),[0,0,0],[Math.PI/2,0,0]],[new Ft(m,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Ft(new cn(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new Ft(new cn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new cn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ft(new cn(.1,.1,.1),f)]]},k={X:[[new Ft(new hn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ft(new hn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ft(new hn(.2,0,.6,4),i),[0,.3,0]],[new Ft(new hn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ft(new hn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ft(new hn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Ft(new cn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ft(new cn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ft(new cn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ft(new cn(.2,.2,.2),i),[0,0,0]]]},X={X:[[new vi(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new vi(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new vi(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function U(V){let Z=new En;for(let W in V)for(let ct=V[W].length;ct--;){let $=V[W][ct][0].clone(),tt=V[W][ct][1],st=V[W][ct][2],ft=V[W][ct][3],dt=V[W][ct][4];$.name=W,$.tag=dt,tt&&$.position.set(tt[0],tt[1],tt[2]),st&&$.rotation.set(st[0],st[1],st[2]),ft&&$.scale.set(ft[0],ft[1],ft[2]),$.updateMatrix();let et=$.geometry.clone();et.applyMatrix4($.matrix),$.geometry=et,$.renderOrder=1/0,$.position.set(0,0,0),$.rotation.set(0,0,0),$.scale.set(1,1,1),Z.add($)}return Z}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=U(C)),this.add(this.gizmo.rotate=U(M)),this.add(this.gizmo.scale=U(D)),this.add(this.picker.translate=U(S)),this.add(this.picker.rotate=U(I)),this.add(this.picker.scale=U(k)),this.add(this.helper.translate=U(x)),this.add(this.helper.rotate=U(F)),this.add(this.helper.scale=U(X)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(t){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:af;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(un.setFromEuler(sf.set(0,0,0)),o.quaternion.copy(i).multiply(un),Math.abs(qe.copy(Ql).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(un.setFromEuler(sf.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(un),Math.abs(qe.copy(yo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(un.setFromEuler(sf.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(un),Math.abs(qe.copy(tc).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(un.setFromEuler(sf.set(0,Math.PI/2,0)),qe.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Lx.lookAt(Ix,qe,yo)),o.quaternion.multiply(un),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),Sn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),Sn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(Sn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(qe.copy(Ql).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(qe.copy(yo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(qe.copy(tc).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(qe.copy(tc).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(qe.copy(Ql).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(qe.copy(yo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(rf.copy(i),qe.copy(this.eye).applyQuaternion(un.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Lx.lookAt(this.eye,Ix,yo)),o.name==="X"&&(un.setFromAxisAngle(Ql,Math.atan2(-qe.y,qe.z)),un.multiplyQuaternions(rf,un),o.quaternion.copy(un)),o.name==="Y"&&(un.setFromAxisAngle(yo,Math.atan2(qe.x,qe.z)),un.multiplyQuaternions(rf,un),o.quaternion.copy(un)),o.name==="Z"&&(un.setFromAxisAngle(tc,Math.atan2(qe.y,qe.x)),un.multiplyQuaternions(rf,un),o.quaternion.copy(un))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(t)}},sm=class extends Ft{constructor(){super(new oo(1e5,1e5,2,2),new hs({visible:!1,wireframe:!0,side:Ei,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(t){let e=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(e="local"),of.copy(Ql).applyQuaternion(e==="local"?this.worldQuaternion:af),jl.copy(yo).applyQuaternion(e==="local"?this.worldQuaternion:af),Kl.copy(tc).applyQuaternion(e==="local"?this.worldQuaternion:af),qe.copy(jl),this.mode){case"translate":case"scale":switch(this.axis){case"X":qe.copy(this.eye).cross(of),Hs.copy(of).cross(qe);break;case"Y":qe.copy(this.eye).cross(jl),Hs.copy(jl).cross(qe);break;case"Z":qe.copy(this.eye).cross(Kl),Hs.copy(Kl).cross(qe);break;case"XY":Hs.copy(Kl);break;case"YZ":Hs.copy(of);break;case"XZ":qe.copy(Kl),Hs.copy(jl);break;case"XYZ":case"E":Hs.set(0,0,0);break}break;default:Hs.set(0,0,0)}Hs.length()===0?this.quaternion.copy(this.cameraQuaternion):(cf.lookAt(Sn.set(0,0,0),Hs,qe),this.quaternion.setFromRotationMatrix(cf)),super.updateMatrixWorld(t)}};var ms=new En,ec=[],rm="both",Dx="local",om=!1,Nx=!1,hf=()=>Nx;function Ux(){oi.add(ms),yt("target",iA)}function eA(){for(let[n,t]of[["translate",.75],["rotate",.55]]){let e=new lf(pn,ji.domElement);e.setMode(n),e.setSize(t),e.setSpace(Dx),e.attach(ms),e.addEventListener("dragging-changed",({value:i})=>{zn.enabled=!i,Nx=i;for(let s of ec)s!==e&&(s.enabled=!i&&om);i||Ps(N.target,"dropped")}),e.addEventListener("change",rn),e.addEventListener("objectChange",()=>{ms.updateMatrix();let i=ms.matrix.elements;Ps([i[0],i[4],i[8],i[12],i[1],i[5],i[9],i[13],i[2],i[6],i[10],i[14],0,0,0,1],"drag")}),nA(e.getHelper()),ec.push(e),oi.add(e.getHelper())}}function nA(n){n.traverse(({geometry:t})=>{if(t?.type!=="TorusGeometry")return;let{radialSegments:e,tubularSegments:i}=t.parameters,s=i+1,r=[];if(!(i<64)){for(let o=1;o<=e;o++)for(let a=0;a+2<=i;a+=2){let[l,c,h,f]=[s*o+a,s*(o-1)+a,s*(o-1)+a+2,s*o+a+2];r.push(l,c,f,c,h,f)}t.setIndex(r)}})}function iA(n){if(n==="drag"||n==="dropped")return;let t=N.target;ms.matrix.set(...t),ms.matrix.decompose(ms.position,ms.quaternion,ms.scale),ms.scale.set(1,1,1),ms.updateMatrixWorld(!0),rn()}function Fx(){ec.forEach((n,t)=>{let e=om&&(rm==="both"||rm===(t===0?"move":"turn"));n.enabled=e,n.getHelper().visible=e}),rn()}function Ox(n){om=n,n&&!ec.length&&eA(),Fx()}function Bx(n){rm=n,Fx()}function kx(n){Dx=n;for(let t of ec)t.setSpace(n);rn()}var Ie={follow:!0,ghosts:"all",task:null,redundancy:null},am={answers:0},Hx=Pc(async()=>{let n=N.target,t=N.table;try{let e=hf()||lm,i=await Qn("ik",{T:n,q:N.q,brief:e,task:Ie.task,redundancy:Ie.redundancy});if(t!==N.table||n!==N.target&&!e)return;am.answers+=1,N.solutions={...i,T:n,brief:e},Ie.follow&&i.nearest&&Cs(i.nearest,"follow"),Ra(),ie("solutions"),i.status==="OUT_OF_REACH"&&!e&&rA(n),i.self_motions===null&&!e&&sA(N.solutions)}catch(e){if(e instanceof Cc)return;N.solutions={rows:[],self_motions:[],status:"REFUSED",why:e.message,nearest:null},Ra(),ie("solutions")}}),lm=!1;function Gx(){lm=!0,Hx()}function Gs(){lm=!1,Hx()}var sA=Pc(async n=>{try{let t={T:n.T,q:N.q,task:Ie.task,redundancy:Ie.redundancy},{self_motions:e}=await Qn("self_motions",t);if(N.solutions!==n||!e)return;n.self_motions=e,ie("solutions")}catch{}}),rA=Pc(async n=>{try{let t=await Qn("nearest",{T:n});N.solutions&&N.solutions.T===n&&(N.solutions.near=t,ie("solutions"))}catch{}}),oA=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function Ra(){let n=N.solutions?.rows??[],t=N.panel==="inverse"&&Ie.ghosts!=="none"?n.filter(e=>(Ie.ghosts==="all"||e.inside)&&!oA(e.q,N.q)):[];bx(t.map(e=>e.q))}function Vx(){yt("target",()=>{N.panel==="inverse"&&Gs()}),yt("panel",n=>{Aa(null),n==="inverse"&&N.hasTarget&&!N.solutions&&Gs(),Ra()}),yt("moving",n=>{n||Ra()}),yt("table",n=>{Ie.redundancy=null,n==="new"&&(Ie.task=null),ie("solutions"),n!=="new"&&N.panel==="inverse"&&N.hasTarget&&Gs()}),yt("online",n=>{n&&N.panel==="inverse"&&N.hasTarget&&N.table.joints.length&&Gs()})}var hm=180/Math.PI,Ai={angle:"deg",length:"mm"},lA={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},cm={deg:hm,rad:1,mm:1e3,m:1},cA={deg:2,rad:4,mm:2,m:5},hA={deg:1,rad:.02,mm:5,m:.005},Ct={get angle(){return Ai.angle},get length(){return Ai.length},set(n,t){t in cm&&n in Ai&&(Ai[n]=t)},factor:n=>n in Ai?cm[Ai[n]]:1,symbol:n=>n in Ai?lA[Ai[n]]:"",digits:n=>n in Ai?cA[Ai[n]]:4,step:n=>n in Ai?hA[Ai[n]]/cm[Ai[n]]:.01,suffix:n=>n==="angle"?{deg:hm,"\xB0":hm,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function jn(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var Si=(n,t,e=Ct.digits(t))=>jn(n*Ct.factor(t),e),mn=(n,t,e)=>`${Si(n,t,e)}${t==="angle"&&Ai.angle==="deg"?"":" "}${Ct.symbol(t)}`,nc=(n,t="plain")=>String(Number((n*Ct.factor(t)).toPrecision(9))+0),uf=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");var um=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],Ca=n=>[Math.cos(n),Math.sin(n)];function uA([n,t,e]){let[i,s]=Ca(e),[r,o]=Ca(t),[a,l]=Ca(n);return um([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function fA(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function dA([n,t,e]){let[i,s]=Ca(n),[r,o]=Ca(t),[a,l]=Ca(e);return um([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function pA(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function ff(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],f=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],u=f[0]<0?-1:1;return f.map(d=>u*d+0)}function fm(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return um([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function mA(n){let[t,e,i,s]=ff(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function gA([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:fm([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var gs={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:fA,from:uA},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:pA,from:dA},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:mA,from:gA},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:ff,from:fm}};function Wx(n,t,e){let i=gs[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Xx(n,t,e){let i=ff(n),s=ff(t),r=i.reduce((f,u,d)=>f+u*s[d],0);r<0&&(s=s.map(f=>-f),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],h=fm(i.map((f,u)=>l*f+c*s[u]));return[3,7,11].forEach(f=>{h[f]=n[f]+e*(t[f]-n[f])}),h}var Yx=1,$x=30;function dm(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=N;return{pieper:Yx,table:n,q:t,target:i?e:null,task:Ie.task,redundancy:Ie.redundancy,notation:s,frames:r,path:o,sequence:a,panel:l,theme:c,units:[Ct.angle,Ct.length],camera:Gu()}}var pr=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,ic=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(pr),Vr=(n,t)=>typeof n=="string"?n.slice(0,t):"",sc=n=>{if(!ic(n,16))return null;let t=Sc(n);return t<1e-12?n.slice():t<.001?Mc(n):null},_A=n=>n&&[n.lower,n.upper,n.value].every(pr)&&n.lower<=n.upper?{name:Vr(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:Vr(n.unit,10)}:null;function xA(n){if(!n||!Array.isArray(n.joints)||n.joints.length>$x||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>pr(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:Vr(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:pr(i.lower)?i.lower:null,upper:pr(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>ic(i,t.length)).slice(0,40));return{name:Vr(n.name,60),convention:n.convention,joints:t,base:sc(n.base)??Zs(),tool:sc(n.tool)??Zs(),postures:e,manufacturer:Vr(n.manufacturer,200),source:Vr(n.source,2e3),notes:Vr(n.notes,3e3),actuator:_A(n.actuator)}}function df(n,t){let e=n&&n.pieper===Yx?xA(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(Ct.set("angle",n.units[0]),Ct.set("length",n.units[1])),Object.hasOwn(gs,n.notation)&&(N.notation=n.notation),["auto","light","dark"].includes(n.theme)&&Dc(n.theme),N.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};Fn(e,{q:ic(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(N.path,{from:sc(s.from),to:sc(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:pr(s.seconds)&&s.seconds>0?s.seconds:5}),N.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&ic(a.q,i)&&pr(a.seconds)&&pr(a.hold)).slice(0,40).map(a=>({name:Vr(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),["pose","position","position+axis"].includes(n.task)&&(Ie.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&pr(l));Ie.redundancy=r.length?Object.fromEntries(r.slice(0,$x)):null;let o=sc(n.target);N.hasTarget=!!o,o&&Ps(o,"restored"),Rc();for(let a of["units","notation","sequence-loaded"])ie(a);t(n.panel),ie("path-loaded"),ic(n.camera,6)&&ex(n.camera),Cs(N.q,"restored")}async function Zx(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function pf(){let n=await Zx(new TextEncoder().encode(JSON.stringify(dm())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function Jx(){let n=/^#s=([\w-]+)$/.exec(location.hash);if(!n)return null;if(n[1].length>6e4)throw new Error("The link is too long.");let t=Uint8Array.from(atob(n[1].replaceAll("-","+").replaceAll("_","/")),i=>i.charCodeAt(0)),e=await Zx(t,DecompressionStream);if(e.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(e))}var qx=null,yA=js(async()=>{if(!N.table.joints.length)return;let n=await pf();n!==qx&&(qx=n,history.replaceState(null,"",n))},600);function jx(){yt(["table","q","target","solutions","units","notation","panel","path","sequence","theme","frames"],yA)}var bA="uplot",SA="u-hz",MA="u-vt",wA="u-title",EA="u-wrap",TA="u-under",AA="u-over",RA="u-axis",So="u-off",CA="u-select",PA="u-cursor-x",IA="u-cursor-y",LA="u-cursor-pt",DA="u-legend",NA="u-live",UA="u-inline",FA="u-series",OA="u-marker",Kx="u-label",BA="u-value",oc="width",ac="height";var Qx="bottom",Pa="left",pm="right",Im="#000",ty=Im+"0",mm="mousemove",ey="mousedown",gm="mouseup",ny="mouseenter",iy="mouseleave",sy="dblclick",kA="resize",zA="scroll",ry="change",yf="dppxchange",Lm="--",Oa=typeof window<"u",bm=Oa?document:null,La=Oa?window:null,HA=Oa?navigator:null,Ue,mf;function Sm(){let n=devicePixelRatio;Ue!=n&&(Ue=n,mf&&wm(ry,mf,Sm),mf=matchMedia(`(min-resolution: ${Ue-.001}dppx) and (max-resolution: ${Ue+.001}dppx)`),Mo(ry,mf,Sm),La.dispatchEvent(new CustomEvent(yf)))}function zi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Mm(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function on(n,t,e){n.style[t]=e+"px"}function _s(n,t,e,i){let s=bm.createElement(n);return t!=null&&zi(s,t),e?.insertBefore(s,i),s}function Ki(n,t){return _s("div",n,t)}var oy=new WeakMap;function Vs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=oy.get(n);r!=o&&(n.style.transform=r,oy.set(n,r),t<0||e<0||t>i||e>s?zi(n,So):Mm(n,So))}var ay=new WeakMap;function ly(n,t,e){let i=t+e,s=ay.get(n);i!=s&&(ay.set(n,i),n.style.background=t,n.style.borderColor=e)}var cy=new WeakMap;function hy(n,t,e,i){let s=t+""+e,r=cy.get(n);s!=r&&(cy.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Dm={passive:!0},GA={...Dm,capture:!0};function Mo(n,t,e,i){t.addEventListener(n,e,i?GA:Dm)}function wm(n,t,e,i){t.removeEventListener(n,e,Dm)}Oa&&Sm();function xs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Hi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function By(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var ky=n=>n!=null,zy=n=>n!=null&&n>0,Sf=By(ky),VA=By(zy);function WA(n,t,e,i=0,s=!1){let r=s?VA:Sf,o=s?zy:ky;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ye,l??-Ye]}function Mf(n,t,e,i){let s=dy(n),r=dy(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?mr:Hy,a=s==1?Hi:Qi,l=r==1?Qi:Hi,c=a(o(Gn(n))),h=l(o(Gn(t))),f=Da(e,c),u=Da(e,h);return e==10&&(c<0&&(f=$e(f,-c)),h<0&&(u=$e(u,-h))),i||e==2?(n=f*s,t=u*r):(n=Xy(n,f),t=wf(t,u)),[n,t]}function Nm(n,t,e,i){let s=Mf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Um=.1,uy={mode:3,pad:Um},cc={pad:0,soft:null,mode:0},XA={min:cc,max:cc};function vf(n,t,e,i){return Ef(e)?fy(n,t,e):(cc.pad=e,cc.soft=i?0:null,cc.mode=i?3:0,fy(n,t,XA))}function Le(n,t){return n??t}function qA(n,t,e){for(t=Le(t,0),e=Le(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function fy(n,t,e){let i=e.min,s=e.max,r=Le(i.pad,0),o=Le(s.pad,0),a=Le(i.hard,-Ye),l=Le(s.hard,Ye),c=Le(i.soft,Ye),h=Le(s.soft,-Ye),f=Le(i.mode,0),u=Le(s.mode,0),d=t-n,g=mr(d),_=Mi(Gn(n),Gn(t)),m=mr(_),p=Gn(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,f==2&&c!=Ye&&(r=0),u==2&&h!=-Ye&&(o=0)));let y=d||_||1e3,w=mr(y),v=Da(10,Hi(w)),C=y*(d==0?n==0?.1:1:r),S=$e(Xy(n-C,v/10),24),x=n>=c&&(f==1||f==3&&S<=c||f==2&&S>=c)?c:Ye,M=Mi(a,S<x&&n>=x?x:ys(x,S)),F=y*(d==0?t==0?.1:1:o),I=$e(wf(t+F,v/10),24),D=t<=h&&(u==1||u==3&&I>=h||u==2&&I<=h)?h:-Ye,k=ys(l,I>D&&t<=D?D:Mi(D,I));return M==k&&M==0&&(k=100),[M,k]}var YA=new Intl.NumberFormat(Oa?HA.language:"en-US"),Fm=n=>YA.format(n),Gi=Math,xf=Gi.PI,Gn=Gi.abs,Hi=Gi.floor,Hn=Gi.round,Qi=Gi.ceil,ys=Gi.min,Mi=Gi.max,Da=Gi.pow,dy=Gi.sign,mr=Gi.log10,Hy=Gi.log2,$A=(n,t=1)=>Gi.sinh(n)*t,_m=(n,t=1)=>Gi.asinh(n/t),Ye=1/0;function py(n){return(mr((n^n>>31)-(n>>31))|0)+1}function Em(n,t,e){return ys(Mi(n,t),e)}function Gy(n){return typeof n=="function"}function Ae(n){return Gy(n)?n:()=>n}var ZA=()=>{},Vy=n=>n,Wy=(n,t)=>t,JA=n=>null,my=n=>!0,gy=(n,t)=>n==t,jA=/\.\d*?(?=9{6,}|0{6,})/gm,wo=n=>{if(Yy(n)||Xr.has(n))return n;let t=`${n}`,e=t.match(jA);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${wo(s)}e${r}`}return $e(n,i)};function vo(n,t){return wo($e(wo(n/t))*t)}function wf(n,t){return wo(Qi(wo(n/t))*t)}function Xy(n,t){return wo(Hi(wo(n/t))*t)}function $e(n,t=0){if(Yy(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Hn(i)/e}var Xr=new Map;function qy(n){return((""+n).split(".")[1]||"").length}function uc(n,t,e,i){let s=[],r=i.map(qy);for(let o=t;o<e;o++){let a=Gn(o),l=$e(Da(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?h:$e(h,f);s.push(u),Xr.set(u,f)}}return s}var hc={},Om=[],Na=[null,null],Wr=Array.isArray,Yy=Number.isInteger,KA=n=>n===void 0;function _y(n){return typeof n=="string"}function Ef(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function QA(n){return n!=null&&typeof n=="object"}var tR=Object.getPrototypeOf(Uint8Array),$y="__proto__";function Ua(n,t=Ef){let e;if(Wr(n)){let i=n.find(s=>s!=null);if(Wr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Ua(n[s],t)}else e=n.slice()}else if(n instanceof tR)e=n.slice();else if(t(n)){e={};for(let i in n)i!=$y&&(e[i]=Ua(n[i],t))}else e=n;return e}function Dn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=$y&&(Ef(n[s])?Dn(n[s],Ua(i[s])):n[s]=Ua(i[s]))}return n}var eR=0,nR=1,iR=2;function sR(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function rR(n,t){if(lR(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return cR(o[0])||(o=aR(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],f=Array(s).fill(void 0),u=t?t[o][c]:nR,d=[];for(let g=0;g<h.length;g++){let _=h[g],m=r.get(l[g]);_===null?u!=eR&&(f[m]=_,u==iR&&d.push(m)):f[m]=_}sR(f,d,s),i.push(f)}}return i}var oR=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function aR(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function lR(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function cR(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Mi(1,Hi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Zy=["January","February","March","April","May","June","July","August","September","October","November","December"],Jy=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function jy(n){return n.slice(0,3)}var hR=Jy.map(jy),uR=Zy.map(jy),fR={MMMM:Zy,MMM:uR,WWWW:Jy,WWW:hR};function rc(n){return(n<10?"0":"")+n}function dR(n){return(n<10?"00":n<100?"0":"")+n}var pR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>rc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>rc(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>rc(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>rc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>rc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>dR(n.getMilliseconds())};function Bm(n,t){t=t||fR;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?pR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var mR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function gR(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==mR?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Ky=n=>n%1==0,bf=[1,2,2.5,5],_R=uc(10,-32,0,bf),Qy=uc(10,0,32,bf),xR=Qy.filter(Ky),bo=_R.concat(Qy),km=`
`,tv="{YYYY}",xy=km+tv,ev="{M}/{D}",lc=km+ev,gf=lc+"/{YY}",nv="{aa}",yR="{h}:{mm}",Ia=yR+nv,yy=km+Ia,vy=":{ss}",Oe=null;function iv(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?uc(10,0,3,bf).filter(Ky):uc(10,-3,0,bf)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,tv,Oe,Oe,Oe,Oe,Oe,Oe,1],[s*28,"{MMM}",xy,Oe,Oe,Oe,Oe,Oe,1],[s,ev,xy,Oe,Oe,Oe,Oe,Oe,1],[i,"{h}"+nv,gf,Oe,lc,Oe,Oe,Oe,1],[e,Ia,gf,Oe,lc,Oe,Oe,Oe,1],[t,vy,gf+" "+Ia,Oe,lc+" "+Ia,Oe,yy,Oe,1],[n,vy+".{fff}",gf+" "+Ia,Oe,lc+" "+Ia,Oe,yy,Oe,1]];function h(f){return(u,d,g,_,m,p)=>{let y=[],w=m>=o,v=m>=r&&m<o,C=f(g),S=$e(C*n,3),x=xm(C.getFullYear(),w?0:C.getMonth(),v||w?1:C.getDate()),M=$e(x*n,3);if(v||w){let F=v?m/r:0,I=w?m/o:0,D=S==M?S:$e(xm(x.getFullYear()+I,x.getMonth()+F,1)*n,3),k=new Date(Hn(D/n)),X=k.getFullYear(),U=k.getMonth();for(let V=0;D<=_;V++){let Z=xm(X+I*V,U+F*V,1),W=Z-f($e(Z*n,3));D=$e((+Z+W)*n,3),D<=_&&y.push(D)}}else{let F=m>=s?s:m,I=Hi(g)-Hi(S),D=M+I+wf(S-M,F);y.push(D);let k=f(D),X=k.getHours()+k.getMinutes()/e+k.getSeconds()/i,U=m/i,V=u.axes[d]._space,Z=p/V;for(;D=$e(D+m,n==1?0:3),!(D>_);)if(U>1){let W=Hi($e(X+U,6))%24,tt=f(D).getHours()-W;tt>1&&(tt=-1),D-=tt*i,X=(X+U)%24;let st=y[y.length-1];$e((D-st)/m,3)*Z>=.7&&y.push(D)}else y.push(D)}return y}}return[l,c,h]}var[vR,bR,SR]=iv(1),[MR,wR,ER]=iv(.001);uc(2,-53,53,[1]);function by(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Sy(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,f,u,d;return i.map(g=>{let _=n(g),m=_.getFullYear(),p=_.getMonth(),y=_.getDate(),w=_.getHours(),v=_.getMinutes(),C=_.getSeconds(),S=m!=l&&a[2]||p!=c&&a[3]||y!=h&&a[4]||w!=f&&a[5]||v!=u&&a[6]||C!=d&&a[7]||a[1];return l=m,c=p,h=y,f=w,u=v,d=C,S(_)})}}function TR(n,t){let e=Bm(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function xm(n,t,e){return new Date(n,t,e)}function My(n,t){return t(n)}var AR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function wy(n,t){return(e,i,s,r)=>r==null?Lm:t(n(i))}function RR(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function CR(n,t){return n.series[t].fill(n,t)}var PR={show:!0,live:!0,isolate:!1,mount:ZA,markers:{show:!0,width:2,stroke:RR,fill:CR,dash:"solid"},idx:null,idxs:null,values:[]};function IR(n,t){let e=n.cursor.points,i=Ki(),s=e.size(n,t);on(i,oc,s),on(i,ac,s);let r=s/-2;on(i,"marginLeft",r),on(i,"marginTop",r);let o=e.width(n,t,s);return o&&on(i,"borderWidth",o),i}function LR(n,t){let e=n.series[t].points;return e._fill||e._stroke}function DR(n,t){let e=n.series[t].points;return e._stroke||e._fill}function NR(n,t){return n.series[t].points.size}var ym=[0,0];function UR(n,t,e){return ym[0]=t,ym[1]=e,ym}function _f(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function vm(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var FR={show:!0,x:!0,y:!0,lock:!1,move:UR,points:{one:!1,show:IR,size:NR,width:0,stroke:DR,fill:LR},bind:{mousedown:_f,mouseup:_f,click:_f,dblclick:_f,mousemove:vm,mouseleave:vm,mouseenter:vm},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},sv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},zm=Dn({},sv,{filter:Wy}),rv=Dn({},zm,{size:10}),ov=Dn({},sv,{show:!1}),Hm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',av="bold "+Hm,lv=1.5,Ey={show:!0,scale:"x",stroke:Im,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:av,side:2,grid:zm,ticks:rv,border:ov,font:Hm,lineGap:lv,rotate:0},OR="Value",BR="Time",Ty={show:!0,scale:"x",auto:!1,sorted:1,min:Ye,max:-Ye,idxs:[]};function kR(n,t,e,i,s){return t.map(r=>r==null?"":Fm(r))}function zR(n,t,e,i,s,r,o){let a=[],l=Xr.get(s)||0;e=o?e:$e(wf(e,s),l);for(let c=e;c<=i;c=$e(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Tm(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?mr:Hy,h=Hi(c(e));s=Da(l,h),l==10&&(s=bo[xs(s,bo)]);let f=e,u=s*l;l==10&&(u=bo[xs(u,bo)]);do a.push(f),f=f+s,l==10&&!Xr.has(f)&&(f=$e(f,Xr.get(s))),f>=u&&(s=f,u=s*l,l==10&&(u=bo[xs(u,bo)]));while(f<=i);return a}function HR(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Tm(n,t,Mi(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?Tm(n,t,Mi(l,-i),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var cv=/./,GR=/[12357]/,VR=/[125]/,Ay=/1/,Am=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function WR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),f=l(9,o)-h>=c?cv:l(7,o)-h>=c?GR:l(5,o)-h>=c?VR:Ay;if(f==Ay){let u=Gn(l(1,o)-h);if(u<c)return Am(t.slice().reverse(),a.distr,f,Qi(c/u)).reverse()}return Am(t,a.distr,f,1)}function XR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Gn(l(1,o)-l(2,o));return c<a?Am(t.slice().reverse(),3,cv,Qi(a/c)).reverse():t}function qR(n,t,e,i){return i==null?Lm:t==null?"":Fm(t)}var Ry={show:!0,scale:"y",stroke:Im,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:av,side:3,grid:zm,ticks:rv,border:ov,font:Hm,lineGap:lv,rotate:0};function YR(n,t){let e=3+(n||1)*2;return $e(e*t,3)}function $R(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Gn(o-r),l=n.series[t],c=a/(l.points.space*Ue);return i[1]-i[0]<=c}var Cy={scale:null,auto:!0,sorted:0,min:Ye,max:-Ye},hv=(n,t,e,i,s)=>s,Py={show:!0,auto:!0,sorted:0,gaps:hv,alpha:1,facets:[Dn({},Cy,{scale:"x"}),Dn({},Cy,{scale:"y"})]},Iy={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:hv,alpha:1,points:{show:$R,filter:null},values:null,min:Ye,max:-Ye,idxs:[],path:null,clip:null};function ZR(n,t,e,i,s){return e/10}var uv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},JR=Dn({},uv,{time:!1,ori:1}),Ly={};function fv(n,t){let e=Ly[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Ly[n]=e)),e}var Fa=1,Rm=2;function Eo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,d=a.top,g=a.width,_=a.height,m=n.valToPosH,p=n.valToPosV;return h.ori==0?e(s,l,c,h,f,m,p,u,d,g,_,Af,Ba,Cf,pv,gv):e(s,l,c,h,f,p,m,d,u,_,g,Rf,ka,Wm,mv,_v)}function Gm(n,t){let e=0,i=0,s=Le(n.bands,Om);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function jR(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gr(n,t,e,i,s,r){return Eo(n,t,(o,a,l,c,h,f,u,d,g,_,m)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),w=c.ori==0?Ba:ka,v,C;y==1?(v=e,C=i):(v=i,C=e);let S=p(f(a[v],c,_,d)),x=p(u(l[v],h,m,g)),M=p(f(a[C],c,_,d)),F=p(u(r==1?h.max:h.min,h,m,g)),I=new Path2D(s);return w(I,M,F),w(I,S,F),w(I,S,x),I})}function Tf(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Cf:Wm,l=e;for(let f=0;f<n.length;f++){let u=n[f];if(u[1]>u[0]){let d=u[0]-l;d>0&&a(o,l,i,d,i+r),l=u[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function KR(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Vm(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let f=c,u=c;if(s==1)for(;++c<=i&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let d=r(n[f]),g=u==f?d:r(n[u]),_=f-s;d=o<=0&&_>=0&&_<l?r(n[_]):d;let p=u+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function Dy(n){return n==0?Vy:n==1?Hn:t=>vo(t,n)}function dv(n){let t=n==0?Af:Rf,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=ys(c,a/2,l/2),h=ys(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Af=(n,t,e)=>{n.moveTo(t,e)},Rf=(n,t,e)=>{n.moveTo(e,t)},Ba=(n,t,e)=>{n.lineTo(t,e)},ka=(n,t,e)=>{n.lineTo(e,t)},Cf=dv(0),Wm=dv(1),pv=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},mv=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},gv=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},_v=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function xv(n){return(t,e,i,s,r)=>Eo(t,e,(o,a,l,c,h,f,u,d,g,_,m)=>{let{pxRound:p,points:y}=o,w,v;c.ori==0?(w=Af,v=pv):(w=Rf,v=mv);let C=$e(y.width*Ue,3),S=(y.size-y.width)/2*Ue,x=$e(S*2,3),M=new Path2D,F=new Path2D,{left:I,top:D,width:k,height:X}=t.bbox;Cf(F,I-x,D-x,k+x*2,X+x*2);let U=V=>{if(l[V]!=null){let Z=p(f(a[V],c,_,d)),W=p(u(l[V],h,m,g));w(M,Z+S,W),v(M,Z,W,S,0,xf*2)}};if(r)r.forEach(U);else for(let V=i;V<=s;V++)U(V);return{stroke:C>0?M:null,fill:M,clip:F,flags:Fa|Rm}})}function yv(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var QR=yv(Ba),tC=yv(ka);function vv(n){let t=Le(n?.alignGaps,0);return(e,i,s,r)=>Eo(e,i,(o,a,l,c,h,f,u,d,g,_,m)=>{[s,r]=Sf(l,s,r);let p=o.pxRound,y=X=>p(f(X,c,_,d)),w=X=>p(u(X,h,m,g)),v,C;c.ori==0?(v=Ba,C=QR):(v=ka,C=tC);let S=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fa},M=x.stroke,F=!1;if(r-s>=_*4){let X=dt=>e.posToVal(dt,c.key,!0),U=null,V=null,Z,W,ct,$=y(a[S==1?s:r]),tt=y(a[s]),st=y(a[r]),ft=X(S==1?tt+1:st-1);for(let dt=S==1?s:r;dt>=s&&dt<=r;dt+=S){let et=a[dt],vt=(S==1?et<ft:et>ft)?$:y(et),Pt=l[dt];vt==$?Pt!=null?(W=Pt,U==null?(v(M,vt,w(W)),Z=U=V=W):W<U?U=W:W>V&&(V=W)):Pt===null&&(F=!0):(U!=null&&C(M,$,w(U),w(V),w(Z),w(W)),Pt!=null?(W=Pt,v(M,vt,w(W)),U=V=Z=W):(U=V=null,Pt===null&&(F=!0)),$=vt,ft=X($+S))}U!=null&&U!=V&&ct!=$&&C(M,$,w(U),w(V),w(Z),w(W))}else for(let X=S==1?s:r;X>=s&&X<=r;X+=S){let U=l[X];U===null?F=!0:U!=null&&v(M,y(a[X]),w(U))}let[D,k]=Gm(e,i);if(o.fill!=null||D!=0){let X=x.fill=new Path2D(M),U=o.fillTo(e,i,o.min,o.max,D),V=w(U),Z=y(a[s]),W=y(a[r]);S==-1&&([W,Z]=[Z,W]),v(X,W,V),v(X,Z,V)}if(!o.spanGaps){let X=[];F&&X.push(...Vm(a,l,s,r,S,y,t)),x.gaps=X=o.gaps(e,i,s,r,X),x.clip=Tf(X,c.ori,d,g,_,m)}return k!=0&&(x.band=k==2?[gr(e,i,s,r,M,-1),gr(e,i,s,r,M,1)]:gr(e,i,s,r,M,k)),x})}function eC(n){let t=Le(n.align,1),e=Le(n.ascDesc,!1),i=Le(n.alignGaps,0),s=Le(n.extend,!1);return(r,o,a,l)=>Eo(r,o,(c,h,f,u,d,g,_,m,p,y,w)=>{[a,l]=Sf(f,a,l);let v=c.pxRound,{left:C,width:S}=r.bbox,x=tt=>v(g(tt,u,y,m)),M=tt=>v(_(tt,d,w,p)),F=u.ori==0?Ba:ka,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fa},D=I.stroke,k=u.dir*(u.ori==0?1:-1),X=M(f[k==1?a:l]),U=x(h[k==1?a:l]),V=U,Z=U;s&&t==-1&&(Z=C,F(D,Z,X)),F(D,U,X);for(let tt=k==1?a:l;tt>=a&&tt<=l;tt+=k){let st=f[tt];if(st==null)continue;let ft=x(h[tt]),dt=M(st);t==1?F(D,ft,X):F(D,V,dt),F(D,ft,dt),X=dt,V=ft}let W=V;s&&t==1&&(W=C+S,F(D,W,X));let[ct,$]=Gm(r,o);if(c.fill!=null||ct!=0){let tt=I.fill=new Path2D(D),st=c.fillTo(r,o,c.min,c.max,ct),ft=M(st);F(tt,W,ft),F(tt,Z,ft)}if(!c.spanGaps){let tt=[];tt.push(...Vm(h,f,a,l,k,x,i));let st=c.width*Ue/2,ft=e||t==1?st:-st,dt=e||t==-1?-st:st;tt.forEach(et=>{et[0]+=ft,et[1]+=dt}),I.gaps=tt=c.gaps(r,o,a,l,tt),I.clip=Tf(tt,u.ori,m,p,y,w)}return $!=0&&(I.band=$==2?[gr(r,o,a,l,D,-1),gr(r,o,a,l,D,1)]:gr(r,o,a,l,D,$)),I})}function Ny(n,t,e,i,s,r,o=Ye){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=Gn(n[l]-n[a]);h<c&&(c=h,o=Gn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function nC(n){n=n||hc;let t=Le(n.size,[.6,Ye,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ae(s),o=1-t[0],a=Le(t[1],Ye),l=Le(t[2],1),c=Le(n.disp,hc),h=Le(n.each,d=>{}),{fill:f,stroke:u}=c;return(d,g,_,m)=>Eo(d,g,(p,y,w,v,C,S,x,M,F,I,D)=>{let k=p.pxRound,X=e,U=i*Ue,V=a*Ue,Z=l*Ue,W,ct;v.ori==0?[W,ct]=r(d,g):[ct,W]=r(d,g);let $=v.dir*(v.ori==0?1:-1),tt=v.ori==0?Cf:Wm,st=v.ori==0?h:(Lt,te,fe,Et,We,Xt,jt)=>{h(Lt,te,fe,We,Et,jt,Xt)},ft=Le(d.bands,Om).find(Lt=>Lt.series[0]==g),dt=ft!=null?ft.dir:0,et=p.fillTo(d,g,p.min,p.max,dt),gt=k(x(et,C,D,F)),vt,Pt,wt,Zt=I,ue=k(p.width*Ue),Yt=!1,_e=null,pe=null,ce=null,an=null;f!=null&&(ue==0||u!=null)&&(Yt=!0,_e=f.values(d,g,_,m),pe=new Map,new Set(_e).forEach(Lt=>{Lt!=null&&pe.set(Lt,new Path2D)}),ue>0&&(ce=u.values(d,g,_,m),an=new Map,new Set(ce).forEach(Lt=>{Lt!=null&&an.set(Lt,new Path2D)})));let{x0:Ze,size:Tn}=c;if(Ze!=null&&Tn!=null){X=1,y=Ze.values(d,g,_,m),Ze.unit==2&&(y=y.map(fe=>d.posToVal(M+fe*I,v.key,!0)));let Lt=Tn.values(d,g,_,m);Tn.unit==2?Pt=Lt[0]*I:Pt=S(Lt[0],v,I,M)-S(0,v,I,M),Zt=Ny(y,w,S,v,I,M,Zt),wt=Zt-Pt+U}else Zt=Ny(y,w,S,v,I,M,Zt),wt=Zt*o+U,Pt=Zt-wt;wt<1&&(wt=0),ue>=Pt/2&&(ue=0),wt<5&&(k=Vy);let Ge=wt>0,Wn=Zt-wt-(Ge?ue:0);Pt=k(Em(Wn,Z,V)),vt=(X==0?Pt/2:X==$?0:Pt)-X*$*((X==0?U/2:0)+(Ge?ue/2:0));let Re={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Nn=Yt?null:new Path2D,gn=null;if(ft!=null)gn=d.data[ft.series[1]];else{let{y0:Lt,y1:te}=c;Lt!=null&&te!=null&&(w=te.values(d,g,_,m),gn=Lt.values(d,g,_,m))}let An=W*Pt,H=ct*Pt;for(let Lt=$==1?_:m;Lt>=_&&Lt<=m;Lt+=$){let te=w[Lt];if(te==null)continue;if(gn!=null){let Y=gn[Lt]??0;if(te-Y==0)continue;gt=x(Y,C,D,F)}let fe=v.distr!=2||c!=null?y[Lt]:Lt,Et=S(fe,v,I,M),We=x(Le(te,et),C,D,F),Xt=k(Et-vt),jt=k(Mi(We,gt)),P=k(ys(We,gt)),E=jt-P;if(te!=null){let Y=te<0?H:An,ut=te<0?An:H;Yt?(ue>0&&ce[Lt]!=null&&tt(an.get(ce[Lt]),Xt,P+Hi(ue/2),Pt,Mi(0,E-ue),Y,ut),_e[Lt]!=null&&tt(pe.get(_e[Lt]),Xt,P+Hi(ue/2),Pt,Mi(0,E-ue),Y,ut)):tt(Nn,Xt,P+Hi(ue/2),Pt,Mi(0,E-ue),Y,ut),st(d,g,Lt,Xt-ue/2,P,Pt+ue,E)}}return ue>0?Re.stroke=Yt?an:Nn:Yt||(Re._fill=p.width==0?p._fill:p._stroke??p._fill,Re.width=0),Re.fill=Yt?pe:Nn,Re})}function iC(n,t){let e=Le(t?.alignGaps,0);return(i,s,r,o)=>Eo(i,s,(a,l,c,h,f,u,d,g,_,m,p)=>{[r,o]=Sf(c,r,o);let y=a.pxRound,w=W=>y(u(W,h,m,g)),v=W=>y(d(W,f,p,_)),C,S,x;h.ori==0?(C=Af,x=Ba,S=gv):(C=Rf,x=ka,S=_v);let M=h.dir*(h.ori==0?1:-1),F=w(l[M==1?r:o]),I=F,D=[],k=[];for(let W=M==1?r:o;W>=r&&W<=o;W+=M)if(c[W]!=null){let $=l[W],tt=w($);D.push(I=tt),k.push(v(c[W]))}let X={stroke:n(D,k,C,x,S,y),fill:null,clip:null,band:null,gaps:null,flags:Fa},U=X.stroke,[V,Z]=Gm(i,s);if(a.fill!=null||V!=0){let W=X.fill=new Path2D(U),ct=a.fillTo(i,s,a.min,a.max,V),$=v(ct);x(W,I,$),x(W,F,$)}if(!a.spanGaps){let W=[];W.push(...Vm(l,c,r,o,M,w,e)),X.gaps=W=a.gaps(i,s,r,o,W),X.clip=Tf(W,h.ori,g,_,m,p)}return Z!=0&&(X.band=Z==2?[gr(i,s,r,o,U,-1),gr(i,s,r,o,U,1)]:gr(i,s,r,o,U,Z)),X})}function sC(n){return iC(rC,n)}function rC(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),f=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],f[u]=n[u+1]-n[u],c[u]=h[u]/f[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/c[u-1]+(f[u]+2*f[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+f[u]/3,t[u]+l[u]*f[u]/3,n[u+1]-f[u]/3,t[u+1]-l[u+1]*f[u]/3,n[u+1],t[u+1])}return a}var Cm=new Set;function Uy(){for(let n of Cm)n.syncRect(!0)}Oa&&(Mo(kA,La,Uy),Mo(zA,La,Uy,!0),Mo(yf,La,()=>{ti.pxRatio=Ue}));var oC=vv(),aC=xv();function Fy(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Pm(r,o,t,e))}function lC(n,t){return n.map((e,i)=>i==0?{}:Dn({},t,e))}function Pm(n,t,e,i){return Dn({},t==0?e:i,n)}function bv(n,t,e){return t==null?Na:[t,e]}var cC=bv;function hC(n,t,e){return t==null?Na:vf(t,e,Um,!0)}function Sv(n,t,e,i){return t==null?Na:Mf(t,e,n.scales[i].log,!1)}var uC=Sv;function Mv(n,t,e,i){return t==null?Na:Nm(t,e,n.scales[i].log,!1)}var fC=Mv;function dC(n,t,e,i,s){let r=Mi(py(n),py(t)),o=t-n,a=xs(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Xr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Oy(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Hn((e=+s)*Ue))+"px"),[n,t,e]}function pC(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=$e(t[2]*Ue,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ti(n,t,e){let i={mode:Le(n.mode,1)},s=i.mode;function r(b,A,L,O){let q=A.valToPct(b);return O+L*(A.dir==-1?1-q:q)}function o(b,A,L,O){let q=A.valToPct(b);return O+L*(A.dir==-1?q:1-q)}function a(b,A,L,O){return A.ori==0?r(b,A,L,O):o(b,A,L,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ki(bA);if(n.id!=null&&(c.id=n.id),zi(c,n.class),n.title){let b=Ki(wA,c);b.textContent=n.title}let h=_s("canvas"),f=i.ctx=h.getContext("2d"),u=Ki(EA,c);Mo("click",u,b=>{b.target===g&&(Qe!=No||ln!=Uo)&&Kn.click(i,b)},!0);let d=i.under=Ki(TA,u);u.appendChild(h);let g=i.over=Ki(AA,u);n=Ua(n);let _=+Le(n.pxAlign,1),m=Dy(_);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let p=n.ms||.001,y=i.series=s==1?Fy(n.series||[],Ty,Iy,!1):lC(n.series||[null],Py),w=i.axes=Fy(n.axes||[],Ey,Ry,!0),v=i.scales={},C=i.bands=n.bands||[];C.forEach(b=>{b.fill=Ae(b.fill||null),b.dir=Le(b.dir,-1)});let S=s==2?y[1].facets[0].scale:y[0].scale,x={axes:Ys,series:ve},M=(n.drawOrder||["axes","series"]).map(b=>x[b]);function F(b){let A=b.distr==3?L=>mr(L>0?L:b.clamp(i,L,b.min,b.max,b.key)):b.distr==4?L=>_m(L,b.asinh):b.distr==100?L=>b.fwd(L):L=>L;return L=>{let O=A(L),{_min:q,_max:K}=b,lt=K-q;return(O-q)/lt}}function I(b){let A=v[b];if(A==null){let L=(n.scales||hc)[b]||hc;if(L.from!=null){I(L.from);let O=Dn({},v[L.from],L,{key:b});O.valToPct=F(O),v[b]=O}else{A=v[b]=Dn({},b==S?uv:JR,L),A.key=b;let O=A.time,q=A.range,K=Wr(q);if((b!=S||s==2&&!O)&&(K&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?uy:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?uy:{mode:1,hard:q[1],soft:q[1]}},K=!1),!K&&Ef(q))){let lt=q;q=(pt,St,Bt)=>St==null?Na:vf(St,Bt,lt)}A.range=Ae(q||(O?cC:b==S?A.distr==3?uC:A.distr==4?fC:bv:A.distr==3?Sv:A.distr==4?Mv:hC)),A.auto=Ae(K?!1:A.auto),A.clamp=Ae(A.clamp||ZR),A._min=A._max=null,A.valToPct=F(A)}}}I("x"),I("y"),s==1&&y.forEach(b=>{I(b.scale)}),w.forEach(b=>{I(b.scale)});for(let b in n.scales)I(b);let D=v[S],k=D.distr,X,U;D.ori==0?(zi(c,SA),X=r,U=o):(zi(c,MA),X=o,U=r);let V={};for(let b in v){let A=v[b];(A.min!=null||A.max!=null)&&(V[b]={min:A.min,max:A.max},A.min=A.max=null)}let Z=n.tzDate||(b=>new Date(Hn(b/p))),W=n.fmtDate||Bm,ct=p==1?SR(Z):ER(Z),$=Sy(Z,by(p==1?bR:wR,W)),tt=wy(Z,My(AR,W)),st=[],ft=i.legend=Dn({},PR,n.legend),dt=i.cursor=Dn({},FR,{drag:{y:s==2}},n.cursor),et=ft.show,gt=dt.show,vt=ft.markers;ft.idxs=st,vt.width=Ae(vt.width),vt.dash=Ae(vt.dash),vt.stroke=Ae(vt.stroke),vt.fill=Ae(vt.fill);let Pt,wt,Zt,ue=[],Yt=[],_e,pe=!1,ce={};if(ft.live){let b=y[1]?y[1].values:null;pe=b!=null,_e=pe?b(i,1,0):{_:0};for(let A in _e)ce[A]=Lm}if(et)if(Pt=_s("table",DA,c),Zt=_s("tbody",null,Pt),ft.mount(i,Pt),pe){wt=_s("thead",null,Pt,Zt);let b=_s("tr",null,wt);_s("th",null,b);for(var an in _e)_s("th",Kx,b).textContent=an}else zi(Pt,UA),ft.live&&zi(Pt,NA);let Ze={show:!0},Tn={show:!1};function Ge(b,A){if(A==0&&(pe||!ft.live||s==2))return Na;let L=[],O=_s("tr",FA,Zt,Zt.childNodes[A]);zi(O,b.class),b.show||zi(O,So);let q=_s("th",null,O);if(vt.show){let pt=Ki(OA,q);if(A>0){let St=vt.width(i,A);St&&(pt.style.border=St+"px "+vt.dash(i,A)+" "+vt.stroke(i,A)),pt.style.background=vt.fill(i,A)}}let K=Ki(Kx,q);b.label instanceof HTMLElement?K.appendChild(b.label):K.textContent=b.label,A>0&&(vt.show||(K.style.color=b.width>0?vt.stroke(i,A):vt.fill(i,A)),Re("click",q,pt=>{if(dt._lock)return;re(pt);let St=y.indexOf(b);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Bt=y.some((kt,Ht)=>Ht>0&&Ht!=St&&kt.show);y.forEach((kt,Ht)=>{Ht>0&&ws(Ht,Bt?Ht==St?Ze:Tn:Ze,!0,In.setSeries)})}else ws(St,{show:!b.show},!0,In.setSeries)},!1),oe&&Re(ny,q,pt=>{dt._lock||(re(pt),ws(y.indexOf(b),Oo,!0,In.setSeries))},!1));for(var lt in _e){let pt=_s("td",BA,O);pt.textContent="--",L.push(pt)}return[O,L]}let Wn=new Map;function Re(b,A,L,O=!0){let q=Wn.get(A)||{},K=dt.bind[b](i,A,L,O);K&&(Mo(b,A,q[b]=K),Wn.set(A,q))}function Nn(b,A,L){let O=Wn.get(A)||{};for(let q in O)(b==null||q==b)&&(wm(q,A,O[q]),delete O[q]);b==null&&Wn.delete(A)}let gn=0,An=0,H=0,Lt=0,te=0,fe=0,Et=te,We=fe,Xt=H,jt=Lt,P=0,E=0,Y=0,ut=0;i.bbox={};let at=!1,xt=!1,bt=!1,nt=!1,rt=!1,mt=!1;function z(b,A,L){(L||b!=i.width||A!=i.height)&&ot(b,A),me(!1),bt=!0,xt=!0,ei()}function ot(b,A){i.width=gn=H=b,i.height=An=Lt=A,te=fe=0,Mt(),$t();let L=i.bbox;P=L.left=vo(te*Ue,.5),E=L.top=vo(fe*Ue,.5),Y=L.width=vo(H*Ue,.5),ut=L.height=vo(Lt*Ue,.5)}let it=3;function Tt(){let b=!1,A=0;for(;!b;){A++;let L=Io(A),O=Ms(A);b=A==it||L&&O,b||(ot(i.width,i.height),xt=!0)}}function _t({width:b,height:A}){z(b,A)}i.setSize=_t;function Mt(){let b=!1,A=!1,L=!1,O=!1;w.forEach((q,K)=>{if(q.show&&q._show){let{side:lt,_size:pt}=q,St=lt%2,Bt=q.label!=null?q.labelSize:0,kt=pt+Bt;kt>0&&(St?(H-=kt,lt==3?(te+=kt,O=!0):L=!0):(Lt-=kt,lt==0?(fe+=kt,b=!0):A=!0))}}),bs[0]=b,bs[1]=L,bs[2]=A,bs[3]=O,H-=es[1]+es[3],te+=es[3],Lt-=es[2]+es[0],fe+=es[0]}function $t(){let b=te+H,A=fe+Lt,L=te,O=fe;function q(K,lt){switch(K){case 1:return b+=lt,b-lt;case 2:return A+=lt,A-lt;case 3:return L-=lt,L+lt;case 0:return O-=lt,O+lt}}w.forEach((K,lt)=>{if(K.show&&K._show){let pt=K.side;K._pos=q(pt,K._size),K.label!=null&&(K._lpos=q(pt,K.labelSize))}})}if(dt.dataIdx==null){let b=dt.hover,A=b.skip=new Set(b.skip??[]);A.add(void 0);let L=b.prox=Ae(b.prox),O=b.bias??=0;dt.dataIdx=(q,K,lt,pt)=>{if(K==0)return lt;let St=lt,Bt=L(q,K,lt,pt)??Ye,kt=Bt>=0&&Bt<Ye,Ht=D.ori==0?H:Lt,he=dt.left,De=t[0],Pe=t[K];if(A.has(Pe[lt])){St=null;let Se=null,ne=null,Jt;if(O==0||O==-1)for(Jt=lt;Se==null&&Jt-- >0;)A.has(Pe[Jt])||(Se=Jt);if(O==0||O==1)for(Jt=lt;ne==null&&Jt++<Pe.length;)A.has(Pe[Jt])||(ne=Jt);if(Se!=null||ne!=null)if(kt){let en=Se==null?-1/0:X(De[Se],D,Ht,0),yn=ne==null?1/0:X(De[ne],D,Ht,0),$n=he-en,Ve=yn-he;$n<=Ve?$n<=Bt&&(St=Se):Ve<=Bt&&(St=ne)}else St=ne==null?Se:Se==null?ne:lt-Se<=ne-lt?Se:ne}else kt&&Gn(he-X(De[lt],D,Ht,0))>Bt&&(St=null);return St}}let re=b=>{dt.event=b};dt.idxs=st,dt._lock=!1;let ht=dt.points;ht.show=Ae(ht.show),ht.size=Ae(ht.size),ht.stroke=Ae(ht.stroke),ht.width=Ae(ht.width),ht.fill=Ae(ht.fill);let Gt=i.focus=Dn({},n.focus||{alpha:.3},dt.focus),oe=Gt.prox>=0,It=oe&&ht.one,de=[],Ke=[],li=[];function Va(b,A){let L=ht.show(i,A);if(L instanceof HTMLElement)return zi(L,LA),zi(L,b.class),Vs(L,-10,-10,H,Lt),g.insertBefore(L,de[A]),L}function Ro(b,A){if(s==1||A>0){let L=s==1&&v[b.scale].time,O=b.value;b.value=L?_y(O)?wy(Z,My(O,W)):O||tt:O||qR,b.label=b.label||(L?BR:OR)}if(It||A>0){b.width=b.width==null?1:b.width,b.paths=b.paths||oC||JA,b.fillTo=Ae(b.fillTo||jR),b.pxAlign=+Le(b.pxAlign,_),b.pxRound=Dy(b.pxAlign),b.stroke=Ae(b.stroke||null),b.fill=Ae(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let L=YR(Mi(1,b.width),1),O=b.points=Dn({},{size:L,width:Mi(1,L*.2),stroke:b.stroke,space:L*2,paths:aC,_stroke:null,_fill:null},b.points);O.show=Ae(O.show),O.filter=Ae(O.filter),O.fill=Ae(O.fill),O.stroke=Ae(O.stroke),O.paths=Ae(O.paths),O.pxAlign=b.pxAlign}if(et){let L=Ge(b,A);ue.splice(A,0,L[0]),Yt.splice(A,0,L[1]),ft.values.push(null)}if(gt){st.splice(A,0,null);let L=null;It?A==0&&(L=Va(b,A)):A>0&&(L=Va(b,A)),de.splice(A,0,L),Ke.splice(A,0,0),li.splice(A,0,0)}Yn("addSeries",A)}function Yf(b,A){A=A??y.length,b=s==1?Pm(b,A,Ty,Iy):Pm(b,A,{},Py),y.splice(A,0,b),Ro(y[A],A)}i.addSeries=Yf;function gc(b){if(y.splice(b,1),et){ft.values.splice(b,1),Yt.splice(b,1);let A=ue.splice(b,1)[0];Nn(null,A.firstChild),A.remove()}gt&&(st.splice(b,1),de.splice(b,1)[0].remove(),Ke.splice(b,1),li.splice(b,1)),Yn("delSeries",b)}i.delSeries=gc;let bs=[!1,!1,!1,!1];function Ws(b,A){if(b._show=b.show,b.show){let L=b.side%2,O=v[b.scale];O==null&&(b.scale=L?y[1].scale:S,O=v[b.scale]);let q=O.time;b.size=Ae(b.size),b.space=Ae(b.space),b.rotate=Ae(b.rotate),Wr(b.incrs)&&b.incrs.forEach(lt=>{!Xr.has(lt)&&Xr.set(lt,qy(lt))}),b.incrs=Ae(b.incrs||(O.distr==2?xR:q?p==1?vR:MR:bo)),b.splits=Ae(b.splits||(q&&O.distr==1?ct:O.distr==3?Tm:O.distr==4?HR:zR)),b.stroke=Ae(b.stroke),b.grid.stroke=Ae(b.grid.stroke),b.ticks.stroke=Ae(b.ticks.stroke),b.border.stroke=Ae(b.border.stroke);let K=b.values;b.values=Wr(K)&&!Wr(K[0])?Ae(K):q?Wr(K)?Sy(Z,by(K,W)):_y(K)?TR(Z,K):K||$:K||kR,b.filter=Ae(b.filter||(O.distr>=3&&O.log==10?WR:O.distr==3&&O.log==2?XR:Wy)),b.font=Oy(b.font),b.labelFont=Oy(b.labelFont),b._size=b.size(i,null,A,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(bs[A]=!0,b._el=Ki(RA,u))}}function Xs(b,A,L,O){let[q,K,lt,pt]=L,St=A%2,Bt=0;return St==0&&(pt||K)&&(Bt=A==0&&!q||A==2&&!lt?Hn(Ey.size/3):0),St==1&&(q||lt)&&(Bt=A==1&&!K||A==3&&!pt?Hn(Ry.size/2):0),Bt}let Wa=i.padding=(n.padding||[Xs,Xs,Xs,Xs]).map(b=>Ae(Le(b,Xs))),es=i._padding=Wa.map((b,A)=>b(i,A,bs,0)),_n,Mn=null,wn=null,Ss=s==1?y[0].idxs:null,Ii=null,_r=!1;function Xa(b,A){if(t=b??[],i.data=i._data=t,s==2){_n=0;for(let L=1;L<y.length;L++)_n+=t[L][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Ii=t[0],_n=Ii.length;let L=t;if(k==2){L=t.slice();let O=L[0]=Array(_n);for(let q=0;q<_n;q++)O[q]=q}i._data=t=L}if(me(!0),Yn("setData"),k==2&&(bt=!0),A!==!1){let L=D;L.auto(i,_r)?qa():vr(S,L.min,L.max),nt=nt||dt.left>=0,mt=!0,ei()}}i.setData=Xa;function qa(){_r=!0;let b,A;s==1&&(_n>0?(Mn=Ss[0]=0,wn=Ss[1]=_n-1,b=t[0][Mn],A=t[0][wn],k==2?(b=Mn,A=wn):b==A&&(k==3?[b,A]=Mf(b,b,D.log,!1):k==4?[b,A]=Nm(b,b,D.log,!1):D.time?A=b+Hn(86400/p):[b,A]=vf(b,A,Um,!0))):(Mn=Ss[0]=b=null,wn=Ss[1]=A=null)),vr(S,b,A)}let Co,xr,Po,R,G,Q,J,j,At,Dt;function Rt(b,A,L,O,q,K){b??=ty,L??=Om,O??="butt",q??=ty,K??="round",b!=Co&&(f.strokeStyle=Co=b),q!=xr&&(f.fillStyle=xr=q),A!=Po&&(f.lineWidth=Po=A),K!=G&&(f.lineJoin=G=K),O!=Q&&(f.lineCap=Q=O),L!=R&&f.setLineDash(R=L)}function Nt(b,A,L,O){A!=xr&&(f.fillStyle=xr=A),b!=J&&(f.font=J=b),L!=j&&(f.textAlign=j=L),O!=At&&(f.textBaseline=At=O)}function Wt(b,A,L,O,q=0){if(O.length>0&&b.auto(i,_r)&&(A==null||A.min==null)){let K=Le(Mn,0),lt=Le(wn,O.length-1),pt=L.min==null?WA(O,K,lt,q,b.distr==3):[L.min,L.max];b.min=ys(b.min,L.min=pt[0]),b.max=Mi(b.max,L.max=pt[1])}}let ae={min:null,max:null};function ye(){for(let O in v){let q=v[O];V[O]==null&&(q.min==null||V[S]!=null&&q.auto(i,_r))&&(V[O]=ae)}for(let O in v){let q=v[O];V[O]==null&&q.from!=null&&V[q.from]!=null&&(V[O]=ae)}V[S]!=null&&me(!0);let b={};for(let O in V){let q=V[O];if(q!=null){let K=b[O]=Ua(v[O],QA);if(q.min!=null)Dn(K,q);else if(O!=S||s==2)if(_n==0&&K.from==null){let lt=K.range(i,null,null,O);K.min=lt[0],K.max=lt[1]}else K.min=Ye,K.max=-Ye}}if(_n>0){y.forEach((O,q)=>{if(s==1){let K=O.scale,lt=V[K];if(lt==null)return;let pt=b[K];if(q==0){let St=pt.range(i,pt.min,pt.max,K);pt.min=St[0],pt.max=St[1],Mn=xs(pt.min,t[0]),wn=xs(pt.max,t[0]),wn-Mn>1&&(t[0][Mn]<pt.min&&Mn++,t[0][wn]>pt.max&&wn--),O.min=Ii[Mn],O.max=Ii[wn]}else O.show&&O.auto&&Wt(pt,lt,O,t[q],O.sorted);O.idxs[0]=Mn,O.idxs[1]=wn}else if(q>0&&O.show&&O.auto){let[K,lt]=O.facets,pt=K.scale,St=lt.scale,[Bt,kt]=t[q],Ht=b[pt],he=b[St];Ht!=null&&Wt(Ht,V[pt],K,Bt,K.sorted),he!=null&&Wt(he,V[St],lt,kt,lt.sorted),O.min=lt.min,O.max=lt.max}});for(let O in b){let q=b[O],K=V[O];if(q.from==null&&(K==null||K.min==null)){let lt=q.range(i,q.min==Ye?null:q.min,q.max==-Ye?null:q.max,O);q.min=lt[0],q.max=lt[1]}}}for(let O in b){let q=b[O];if(q.from!=null){let K=b[q.from];if(K.min==null)q.min=q.max=null;else{let lt=q.range(i,K.min,K.max,O);q.min=lt[0],q.max=lt[1]}}}let A={},L=!1;for(let O in b){let q=b[O],K=v[O];if(K.min!=q.min||K.max!=q.max){K.min=q.min,K.max=q.max;let lt=K.distr;K._min=lt==3?mr(K.min):lt==4?_m(K.min,K.asinh):lt==100?K.fwd(K.min):K.min,K._max=lt==3?mr(K.max):lt==4?_m(K.max,K.asinh):lt==100?K.fwd(K.max):K.max,A[O]=L=!0}}if(L){y.forEach((O,q)=>{s==2?q>0&&A.y&&(O._paths=null):A[O.scale]&&(O._paths=null)});for(let O in A)bt=!0,Yn("setScale",O);gt&&dt.left>=0&&(nt=mt=!0)}for(let O in V)V[O]=null}function Vt(b){let A=Em(Mn-1,0,_n-1),L=Em(wn+1,0,_n-1);for(;b[A]==null&&A>0;)A--;for(;b[L]==null&&L<_n-1;)L++;return[A,L]}function ve(){if(_n>0){let b=y.some(A=>A._focus)&&Dt!=Gt.alpha;b&&(f.globalAlpha=Dt=Gt.alpha),y.forEach((A,L)=>{if(L>0&&A.show&&(fn(L,!1),fn(L,!0),A._paths==null)){let O=Dt;Dt!=A.alpha&&(f.globalAlpha=Dt=A.alpha);let q=s==2?[0,t[L][0].length-1]:Vt(t[L]);A._paths=A.paths(i,L,q[0],q[1]),Dt!=O&&(f.globalAlpha=Dt=O)}}),y.forEach((A,L)=>{if(L>0&&A.show){let O=Dt;Dt!=A.alpha&&(f.globalAlpha=Dt=A.alpha),A._paths!=null&&Be(L,!1);{let q=A._paths!=null?A._paths.gaps:null,K=A.points.show(i,L,Mn,wn,q),lt=A.points.filter(i,L,K,q);(K||lt)&&(A.points._paths=A.points.paths(i,L,Mn,wn,lt),Be(L,!0))}Dt!=O&&(f.globalAlpha=Dt=O),Yn("drawSeries",L)}}),b&&(f.globalAlpha=Dt=1)}}function fn(b,A){let L=A?y[b].points:y[b];L._stroke=L.stroke(i,b),L._fill=L.fill(i,b)}function Be(b,A){let L=A?y[b].points:y[b],{stroke:O,fill:q,clip:K,flags:lt,_stroke:pt=L._stroke,_fill:St=L._fill,_width:Bt=L.width}=L._paths;Bt=$e(Bt*Ue,3);let kt=null,Ht=Bt%2/2;A&&St==null&&(St=Bt>0?"#fff":pt);let he=L.pxAlign==1&&Ht>0;if(he&&f.translate(Ht,Ht),!A){let De=P-Bt/2,Pe=E-Bt/2,Se=Y+Bt,ne=ut+Bt;kt=new Path2D,kt.rect(De,Pe,Se,ne)}A?zt(pt,Bt,L.dash,L.cap,St,O,q,lt,K):ke(b,pt,Bt,L.dash,L.cap,St,O,q,lt,kt,K),he&&f.translate(-Ht,-Ht)}function ke(b,A,L,O,q,K,lt,pt,St,Bt,kt){let Ht=!1;St!=0&&C.forEach((he,De)=>{if(he.series[0]==b){let Pe=y[he.series[1]],Se=t[he.series[1]],ne=(Pe._paths||hc).band;Wr(ne)&&(ne=he.dir==1?ne[0]:ne[1]);let Jt,en=null;Pe.show&&ne&&qA(Se,Mn,wn)?(en=he.fill(i,De)||K,Jt=Pe._paths.clip):ne=null,zt(A,L,O,q,en,lt,pt,St,Bt,kt,Jt,ne),Ht=!0}}),Ht||zt(A,L,O,q,K,lt,pt,St,Bt,kt)}let Un=Fa|Rm;function zt(b,A,L,O,q,K,lt,pt,St,Bt,kt,Ht){Rt(b,A,L,O,q),(St||Bt||Ht)&&(f.save(),St&&f.clip(St),Bt&&f.clip(Bt)),Ht?(pt&Un)==Un?(f.clip(Ht),kt&&f.clip(kt),we(q,lt),Rn(b,K,A)):pt&Rm?(we(q,lt),f.clip(Ht),Rn(b,K,A)):pt&Fa&&(f.save(),f.clip(Ht),kt&&f.clip(kt),we(q,lt),f.restore(),Rn(b,K,A)):(we(q,lt),Rn(b,K,A)),(St||Bt||Ht)&&f.restore()}function Rn(b,A,L){L>0&&(A instanceof Map?A.forEach((O,q)=>{f.strokeStyle=Co=q,f.stroke(O)}):A!=null&&b&&f.stroke(A))}function we(b,A){A instanceof Map?A.forEach((L,O)=>{f.fillStyle=xr=O,f.fill(L)}):A!=null&&b&&f.fill(A)}function qs(b,A,L,O){let q=w[b],K;if(O<=0)K=[0,0];else{let lt=q._space=q.space(i,b,A,L,O),pt=q._incrs=q.incrs(i,b,A,L,O,lt);K=dC(A,L,pt,O,lt)}return q._found=K}function Cn(b,A,L,O,q,K,lt,pt,St,Bt){let kt=lt%2/2;_==1&&f.translate(kt,kt),Rt(pt,lt,St,Bt,pt),f.beginPath();let Ht,he,De,Pe,Se=q+(O==0||O==3?-K:K);L==0?(he=q,Pe=Se):(Ht=q,De=Se);for(let ne=0;ne<b.length;ne++)A[ne]!=null&&(L==0?Ht=De=b[ne]:he=Pe=b[ne],f.moveTo(Ht,he),f.lineTo(De,Pe));f.stroke(),_==1&&f.translate(-kt,-kt)}function Io(b){let A=!0;return w.forEach((L,O)=>{if(!L.show)return;let q=v[L.scale];if(q.min==null){L._show&&(A=!1,L._show=!1,me(!1));return}else L._show||(A=!1,L._show=!0,me(!1));let K=L.side,lt=K%2,{min:pt,max:St}=q,[Bt,kt]=qs(O,pt,St,lt==0?H:Lt);if(kt==0)return;let Ht=q.distr==2,he=L._splits=L.splits(i,O,pt,St,Bt,kt,Ht),De=q.distr==2?he.map(Jt=>Ii[Jt]):he,Pe=q.distr==2?Ii[he[1]]-Ii[he[0]]:Bt,Se=L._values=L.values(i,L.filter(i,De,O,kt,Pe),O,kt,Pe);L._rotate=K==2?L.rotate(i,Se,O,kt):0;let ne=L._size;L._size=Qi(L.size(i,Se,O,b)),ne!=null&&L._size!=ne&&(A=!1)}),A}function Ms(b){let A=!0;return Wa.forEach((L,O)=>{let q=L(i,O,bs,b);q!=es[O]&&(A=!1),es[O]=q}),A}function Ys(){for(let b=0;b<w.length;b++){let A=w[b];if(!A.show||!A._show)continue;let L=A.side,O=L%2,q,K,lt=A.stroke(i,b),pt=L==0||L==3?-1:1,[St,Bt]=A._found;if(A.label!=null){let ui=A.labelGap*pt,Ni=Hn((A._lpos+ui)*Ue);Nt(A.labelFont[0],lt,"center",L==2?"top":Qx),f.save(),O==1?(q=K=0,f.translate(Ni,Hn(E+ut/2)),f.rotate((L==3?-xf:xf)/2)):(q=Hn(P+Y/2),K=Ni);let Zr=Gy(A.label)?A.label(i,b,St,Bt):A.label;f.fillText(Zr,q,K),f.restore()}if(Bt==0)continue;let kt=v[A.scale],Ht=O==0?Y:ut,he=O==0?P:E,De=A._splits,Pe=kt.distr==2?De.map(ui=>Ii[ui]):De,Se=kt.distr==2?Ii[De[1]]-Ii[De[0]]:St,ne=A.ticks,Jt=A.border,en=ne.show?ne.size:0,yn=Hn(en*Ue),$n=Hn((A.alignTo==2?A._size-en-A.gap:A.gap)*Ue),Ve=A._rotate*-xf/180,vn=m(A._pos*Ue),Li=(yn+$n)*pt,hi=vn+Li;K=O==0?hi:0,q=O==1?hi:0;let Wi=A.font[0],ns=A.align==1?Pa:A.align==2?pm:Ve>0?Pa:Ve<0?pm:O==0?"center":L==3?pm:Pa,Ts=Ve||O==1?"middle":L==2?"top":Qx;Nt(Wi,lt,ns,Ts);let Di=A.font[1]*A.lineGap,Xi=De.map(ui=>m(a(ui,kt,Ht,he))),is=A._values;for(let ui=0;ui<is.length;ui++){let Ni=is[ui];if(Ni!=null){O==0?q=Xi[ui]:K=Xi[ui],Ni=""+Ni;let Zr=Ni.indexOf(`
`)==-1?[Ni]:Ni.split(/\n/gm);for(let fi=0;fi<Zr.length;fi++){let Sg=Zr[fi];Ve?(f.save(),f.translate(q,K+fi*Di),f.rotate(Ve),f.fillText(Sg,0,0),f.restore()):f.fillText(Sg,q,K+fi*Di)}}}ne.show&&Cn(Xi,ne.filter(i,Pe,b,Bt,Se),O,L,vn,yn,$e(ne.width*Ue,3),ne.stroke(i,b),ne.dash,ne.cap);let As=A.grid;As.show&&Cn(Xi,As.filter(i,Pe,b,Bt,Se),O,O==0?2:1,O==0?E:P,O==0?ut:Y,$e(As.width*Ue,3),As.stroke(i,b),As.dash,As.cap),Jt.show&&Cn([vn],[1],O==0?1:0,O==0?1:2,O==1?E:P,O==1?ut:Y,$e(Jt.width*Ue,3),Jt.stroke(i,b),Jt.dash,Jt.cap)}Yn("drawAxes")}function me(b){y.forEach((A,L)=>{L>0&&(A._paths=null,b&&(s==1?(A.min=null,A.max=null):A.facets.forEach(O=>{O.min=null,O.max=null})))})}let xn=!1,ci=!1,ze=[];function Pn(){ci=!1;for(let b=0;b<ze.length;b++)Yn(...ze[b]);ze.length=0}function ei(){xn||(oR(sg),xn=!0)}function _c(b,A=!1){xn=!0,ci=A,b(i),sg(),A&&ze.length>0&&queueMicrotask(Pn)}i.batch=_c;function sg(){if(at&&(ye(),at=!1),bt&&(Tt(),bt=!1),xt){if(on(d,Pa,te),on(d,"top",fe),on(d,oc,H),on(d,ac,Lt),on(g,Pa,te),on(g,"top",fe),on(g,oc,H),on(g,ac,Lt),on(u,oc,gn),on(u,ac,An),h.width=Hn(gn*Ue),h.height=Hn(An*Ue),w.forEach(({_el:b,_show:A,_size:L,_pos:O,side:q})=>{if(b!=null)if(A){let K=q===3||q===0?L:0,lt=q%2==1;on(b,lt?"left":"top",O-K),on(b,lt?"width":"height",L),on(b,lt?"top":"left",lt?fe:te),on(b,lt?"height":"width",lt?Lt:H),Mm(b,So)}else zi(b,So)}),Co=xr=Po=G=Q=J=j=At=R=null,Dt=1,Za(!0),te!=Et||fe!=We||H!=Xt||Lt!=jt){me(!1);let b=H/Xt,A=Lt/jt;if(gt&&!nt&&dt.left>=0){dt.left*=b,dt.top*=A,Lo&&Vs(Lo,Hn(dt.left),0,H,Lt),Do&&Vs(Do,0,Hn(dt.top),H,Lt);for(let L=0;L<de.length;L++){let O=de[L];O!=null&&(Ke[L]*=b,li[L]*=A,Vs(O,Qi(Ke[L]),Qi(li[L]),H,Lt))}}if(tn.show&&!rt&&tn.left>=0&&tn.width>0){tn.left*=b,tn.width*=b,tn.top*=A,tn.height*=A;for(let L in Qf)on(Fo,L,tn[L])}Et=te,We=fe,Xt=H,jt=Lt}Yn("setSize"),xt=!1}gn>0&&An>0&&(f.clearRect(0,0,h.width,h.height),Yn("drawClear"),M.forEach(b=>b()),Yn("draw")),tn.show&&rt&&(xc(tn),rt=!1),gt&&nt&&($r(null,!0,!1),nt=!1),ft.show&&ft.live&&mt&&(jf(),mt=!1),l||(l=!0,i.status=1,Yn("ready")),_r=!1,xn=!1}i.redraw=(b,A)=>{bt=A||!1,b!==!1?vr(S,D.min,D.max):ei()};function $f(b,A){let L=v[b];if(L.from==null){if(_n==0){let O=L.range(i,A.min,A.max,b);A.min=O[0],A.max=O[1]}if(A.min>A.max){let O=A.min;A.min=A.max,A.max=O}if(_n>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;b==S&&L.distr==2&&_n>0&&(A.min=xs(A.min,t[0]),A.max=xs(A.max,t[0]),A.min==A.max&&A.max++),V[b]=A,at=!0,ei()}}i.setScale=$f;let Zf,Jf,Lo,Do,rg,og,No,Uo,ag,lg,Qe,ln,yr=!1,Kn=dt.drag,Xn=Kn.x,qn=Kn.y;gt&&(dt.x&&(Zf=Ki(PA,g)),dt.y&&(Jf=Ki(IA,g)),D.ori==0?(Lo=Zf,Do=Jf):(Lo=Jf,Do=Zf),Qe=dt.left,ln=dt.top);let tn=i.select=Dn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Fo=tn.show?Ki(CA,tn.over?g:d):null;function xc(b,A){if(tn.show){for(let L in b)tn[L]=b[L],L in Qf&&on(Fo,L,b[L]);A!==!1&&Yn("setSelect")}}i.setSelect=xc;function db(b){if(y[b].show)et&&Mm(ue[b],So);else if(et&&zi(ue[b],So),gt){let L=It?de[0]:de[b];L!=null&&Vs(L,-10,-10,H,Lt)}}function vr(b,A,L){$f(b,{min:A,max:L})}function ws(b,A,L,O){A.focus!=null&&xb(b),A.show!=null&&y.forEach((q,K)=>{K>0&&(b==K||b==null)&&(q.show=A.show,db(K),s==2?(vr(q.facets[0].scale,null,null),vr(q.facets[1].scale,null,null)):vr(q.scale,null,null),ei())}),L!==!1&&Yn("setSeries",b,A),O&&Ja("setSeries",i,b,A)}i.setSeries=ws;function pb(b,A){Dn(C[b],A)}function mb(b,A){b.fill=Ae(b.fill||null),b.dir=Le(b.dir,-1),A=A??C.length,C.splice(A,0,b)}function gb(b){b==null?C.length=0:C.splice(b,1)}i.addBand=mb,i.setBand=pb,i.delBand=gb;function _b(b,A){y[b].alpha=A,gt&&de[b]!=null&&(de[b].style.opacity=A),et&&ue[b]&&(ue[b].style.opacity=A)}let $s,br,Yr,Oo={focus:!0};function xb(b){if(b!=Yr){let A=b==null,L=Gt.alpha!=1;y.forEach((O,q)=>{if(s==1||q>0){let K=A||q==0||q==b;O._focus=A?null:K,L&&_b(q,K?1:Gt.alpha)}}),Yr=b,L&&ei()}}et&&oe&&Re(iy,Pt,b=>{dt._lock||(re(b),Yr!=null&&ws(null,Oo,!0,In.setSeries))});function Es(b,A,L){let O=v[A];L&&(b=b/Ue-(O.ori==1?fe:te));let q=H;O.ori==1&&(q=Lt,b=q-b),O.dir==-1&&(b=q-b);let K=O._min,lt=O._max,pt=b/q,St=K+(lt-K)*pt,Bt=O.distr;return Bt==3?Da(10,St):Bt==4?$A(St,O.asinh):Bt==100?O.bwd(St):St}function yb(b,A){let L=Es(b,S,A);return xs(L,t[0],Mn,wn)}i.valToIdx=b=>xs(b,t[0]),i.posToIdx=yb,i.posToVal=Es,i.valToPos=(b,A,L)=>v[A].ori==0?r(b,v[A],L?Y:H,L?P:0):o(b,v[A],L?ut:Lt,L?E:0),i.setCursor=(b,A,L)=>{Qe=b.left,ln=b.top,$r(null,A,L)};function cg(b,A){on(Fo,Pa,tn.left=b),on(Fo,oc,tn.width=A)}function hg(b,A){on(Fo,"top",tn.top=b),on(Fo,ac,tn.height=A)}let Ya=D.ori==0?cg:hg,$a=D.ori==1?cg:hg;function vb(){if(et&&ft.live)for(let b=s==2?1:0;b<y.length;b++){if(b==0&&pe)continue;let A=ft.values[b],L=0;for(let O in A)Yt[b][L++].firstChild.nodeValue=A[O]}}function jf(b,A){if(b!=null&&(b.idxs?b.idxs.forEach((L,O)=>{st[O]=L}):KA(b.idx)||st.fill(b.idx),ft.idx=st[0]),et&&ft.live){for(let L=0;L<y.length;L++)(L>0||s==1&&!pe)&&bb(L,st[L]);vb()}mt=!1,A!==!1&&Yn("setLegend")}i.setLegend=jf;function bb(b,A){let L=y[b],O=b==0&&k==2?Ii:t[b],q;pe?q=L.values(i,b,A)??ce:(q=L.value(i,A==null?null:O[A],b,A),q=q==null?ce:{_:q}),ft.values[b]=q}function $r(b,A,L){ag=Qe,lg=ln,[Qe,ln]=dt.move(i,Qe,ln),dt.left=Qe,dt.top=ln,gt&&(Lo&&Vs(Lo,Hn(Qe),0,H,Lt),Do&&Vs(Do,0,Hn(ln),H,Lt));let O,q=Mn>wn;$s=Ye,br=null;let K=D.ori==0?H:Lt,lt=D.ori==1?H:Lt;if(Qe<0||_n==0||q){O=dt.idx=null;for(let pt=0;pt<y.length;pt++){let St=de[pt];St!=null&&Vs(St,-10,-10,H,Lt)}oe&&ws(null,Oo,!0,b==null&&In.setSeries),ft.live&&(st.fill(O),mt=!0)}else{let pt,St,Bt;s==1&&(pt=D.ori==0?Qe:ln,St=Es(pt,S),O=dt.idx=xs(St,t[0],Mn,wn),Bt=X(t[0][O],D,K,0));let kt=-10,Ht=-10,he=0,De=0,Pe=!0,Se="",ne="";for(let Jt=s==2?1:0;Jt<y.length;Jt++){let en=y[Jt],yn=st[Jt],$n=yn==null?null:s==1?t[Jt][yn]:t[Jt][1][yn],Ve=dt.dataIdx(i,Jt,O,St),vn=Ve==null?null:s==1?t[Jt][Ve]:t[Jt][1][Ve];if(mt=mt||vn!=$n||Ve!=yn,st[Jt]=Ve,Jt>0&&en.show){let Li=Ve==null?-10:Ve==O?Bt:X(s==1?t[0][Ve]:t[Jt][0][Ve],D,K,0),hi=vn==null?-10:U(vn,s==1?v[en.scale]:v[en.facets[1].scale],lt,0);if(oe&&vn!=null){let Wi=D.ori==1?Qe:ln,ns=Gn(Gt.dist(i,Jt,Ve,hi,Wi));if(ns<$s){let Ts=Gt.bias;if(Ts!=0){let Di=Es(Wi,en.scale),Xi=vn>=0?1:-1,is=Di>=0?1:-1;is==Xi&&(is==1?Ts==1?vn>=Di:vn<=Di:Ts==1?vn<=Di:vn>=Di)&&($s=ns,br=Jt)}else $s=ns,br=Jt}}if(mt||It){let Wi,ns;D.ori==0?(Wi=Li,ns=hi):(Wi=hi,ns=Li);let Ts,Di,Xi,is,As,ui,Ni=!0,Zr=ht.bbox;if(Zr!=null){Ni=!1;let fi=Zr(i,Jt);Xi=fi.left,is=fi.top,Ts=fi.width,Di=fi.height}else Xi=Wi,is=ns,Ts=Di=ht.size(i,Jt);if(ui=ht.fill(i,Jt),As=ht.stroke(i,Jt),It)Jt==br&&$s<=Gt.prox&&(kt=Xi,Ht=is,he=Ts,De=Di,Pe=Ni,Se=ui,ne=As);else{let fi=de[Jt];fi!=null&&(Ke[Jt]=Xi,li[Jt]=is,hy(fi,Ts,Di,Ni),ly(fi,ui,As),Vs(fi,Qi(Xi),Qi(is),H,Lt))}}}}if(It){let Jt=Gt.prox,en=Yr==null?$s<=Jt:$s>Jt||br!=Yr;if(mt||en){let yn=de[0];yn!=null&&(Ke[0]=kt,li[0]=Ht,hy(yn,he,De,Pe),ly(yn,Se,ne),Vs(yn,Qi(kt),Qi(Ht),H,Lt))}}}if(tn.show&&yr)if(b!=null){let[pt,St]=In.scales,[Bt,kt]=In.match,[Ht,he]=b.cursor.sync.scales,De=b.cursor.drag;if(Xn=De._x,qn=De._y,Xn||qn){let{left:Pe,top:Se,width:ne,height:Jt}=b.select,en=b.scales[Ht].ori,yn=b.posToVal,$n,Ve,vn,Li,hi,Wi=pt!=null&&Bt(pt,Ht),ns=St!=null&&kt(St,he);Wi&&Xn?(en==0?($n=Pe,Ve=ne):($n=Se,Ve=Jt),vn=v[pt],Li=X(yn($n,Ht),vn,K,0),hi=X(yn($n+Ve,Ht),vn,K,0),Ya(ys(Li,hi),Gn(hi-Li))):Ya(0,K),ns&&qn?(en==1?($n=Pe,Ve=ne):($n=Se,Ve=Jt),vn=v[St],Li=U(yn($n,he),vn,lt,0),hi=U(yn($n+Ve,he),vn,lt,0),$a(ys(Li,hi),Gn(hi-Li))):$a(0,lt)}else td()}else{let pt=Gn(ag-rg),St=Gn(lg-og);if(D.ori==1){let he=pt;pt=St,St=he}Xn=Kn.x&&pt>=Kn.dist,qn=Kn.y&&St>=Kn.dist;let Bt=Kn.uni;Bt!=null?Xn&&qn&&(Xn=pt>=Bt,qn=St>=Bt,!Xn&&!qn&&(St>pt?qn=!0:Xn=!0)):Kn.x&&Kn.y&&(Xn||qn)&&(Xn=qn=!0);let kt,Ht;Xn&&(D.ori==0?(kt=No,Ht=Qe):(kt=Uo,Ht=ln),Ya(ys(kt,Ht),Gn(Ht-kt)),qn||$a(0,lt)),qn&&(D.ori==1?(kt=No,Ht=Qe):(kt=Uo,Ht=ln),$a(ys(kt,Ht),Gn(Ht-kt)),Xn||Ya(0,K)),!Xn&&!qn&&(Ya(0,0),$a(0,0))}if(Kn._x=Xn,Kn._y=qn,b==null){if(L){if(bg!=null){let[pt,St]=In.scales;In.values[0]=pt!=null?Es(D.ori==0?Qe:ln,pt):null,In.values[1]=St!=null?Es(D.ori==1?Qe:ln,St):null}Ja(mm,i,Qe,ln,H,Lt,O)}if(oe){let pt=L&&In.setSeries,St=Gt.prox;Yr==null?$s<=St&&ws(br,Oo,!0,pt):$s>St?ws(null,Oo,!0,pt):br!=Yr&&ws(br,Oo,!0,pt)}}mt&&(ft.idx=O,jf()),A!==!1&&Yn("setCursor")}let Sr=null;Object.defineProperty(i,"rect",{get(){return Sr==null&&Za(!1),Sr}});function Za(b=!1){b?Sr=null:(Sr=g.getBoundingClientRect(),Yn("syncRect",Sr))}function ug(b,A,L,O,q,K,lt){dt._lock||yr&&b!=null&&b.movementX==0&&b.movementY==0||(Kf(b,A,L,O,q,K,lt,!1,b!=null),b!=null?$r(null,!0,!0):$r(A,!0,!1))}function Kf(b,A,L,O,q,K,lt,pt,St){if(Sr==null&&Za(!1),re(b),b!=null)L=b.clientX-Sr.left,O=b.clientY-Sr.top;else{if(L<0||O<0){Qe=-10,ln=-10;return}let[Bt,kt]=In.scales,Ht=A.cursor.sync,[he,De]=Ht.values,[Pe,Se]=Ht.scales,[ne,Jt]=In.match,en=A.axes[0].side%2==1,yn=D.ori==0?H:Lt,$n=D.ori==1?H:Lt,Ve=en?K:q,vn=en?q:K,Li=en?O:L,hi=en?L:O;if(Pe!=null?L=ne(Bt,Pe)?a(he,v[Bt],yn,0):-10:L=yn*(Li/Ve),Se!=null?O=Jt(kt,Se)?a(De,v[kt],$n,0):-10:O=$n*(hi/vn),D.ori==1){let Wi=L;L=O,O=Wi}}St&&(A==null||A.cursor.event.type==mm)&&((L<=1||L>=H-1)&&(L=vo(L,H)),(O<=1||O>=Lt-1)&&(O=vo(O,Lt))),pt?(rg=L,og=O,[No,Uo]=dt.move(i,L,O)):(Qe=L,ln=O)}let Qf={width:0,height:0,left:0,top:0};function td(){xc(Qf,!1)}let fg,dg,pg,mg;function gg(b,A,L,O,q,K,lt){yr=!0,Xn=qn=Kn._x=Kn._y=!1,Kf(b,A,L,O,q,K,lt,!0,!1),b!=null&&(Re(gm,bm,_g,!1),Ja(ey,i,No,Uo,H,Lt,null));let{left:pt,top:St,width:Bt,height:kt}=tn;fg=pt,dg=St,pg=Bt,mg=kt}function _g(b,A,L,O,q,K,lt){yr=Kn._x=Kn._y=!1,Kf(b,A,L,O,q,K,lt,!1,!0);let{left:pt,top:St,width:Bt,height:kt}=tn,Ht=Bt>0||kt>0,he=fg!=pt||dg!=St||pg!=Bt||mg!=kt;if(Ht&&he&&xc(tn),Kn.setScale&&Ht&&he){let De=pt,Pe=Bt,Se=St,ne=kt;if(D.ori==1&&(De=St,Pe=kt,Se=pt,ne=Bt),Xn&&vr(S,Es(De,S),Es(De+Pe,S)),qn)for(let Jt in v){let en=v[Jt];Jt!=S&&en.from==null&&en.min!=Ye&&vr(Jt,Es(Se+ne,Jt),Es(Se,Jt))}td()}else dt.lock&&(dt._lock=!dt._lock,$r(A,!0,b!=null));b!=null&&(Nn(gm,bm),Ja(gm,i,Qe,ln,H,Lt,null))}function Sb(b,A,L,O,q,K,lt){if(dt._lock)return;re(b);let pt=yr;if(yr){let St=!0,Bt=!0,kt=10,Ht,he;D.ori==0?(Ht=Xn,he=qn):(Ht=qn,he=Xn),Ht&&he&&(St=Qe<=kt||Qe>=H-kt,Bt=ln<=kt||ln>=Lt-kt),Ht&&St&&(Qe=Qe<No?0:H),he&&Bt&&(ln=ln<Uo?0:Lt),$r(null,!0,!0),yr=!1}Qe=-10,ln=-10,st.fill(null),$r(null,!0,!0),pt&&(yr=pt)}function xg(b,A,L,O,q,K,lt){dt._lock||(re(b),qa(),td(),b!=null&&Ja(sy,i,Qe,ln,H,Lt,null))}function yg(){w.forEach(pC),z(i.width,i.height,!0)}Mo(yf,La,yg);let Bo={};Bo.mousedown=gg,Bo.mousemove=ug,Bo.mouseup=_g,Bo.dblclick=xg,Bo.setSeries=(b,A,L,O)=>{let q=In.match[2];L=q(i,A,L),L!=-1&&ws(L,O,!0,!1)},gt&&(Re(ey,g,gg),Re(mm,g,ug),Re(ny,g,b=>{re(b),Za(!1)}),Re(iy,g,Sb),Re(sy,g,xg),Cm.add(i),i.syncRect=Za);let yc=i.hooks=n.hooks||{};function Yn(b,A,L){ci?ze.push([b,A,L]):b in yc&&yc[b].forEach(O=>{O.call(null,i,A,L)})}(n.plugins||[]).forEach(b=>{for(let A in b.hooks)yc[A]=(yc[A]||[]).concat(b.hooks[A])});let vg=(b,A,L)=>L,In=Dn({key:null,setSeries:!1,filters:{pub:my,sub:my},scales:[S,y[1]?y[1].scale:null],match:[gy,gy,vg],values:[null,null]},dt.sync);In.match.length==2&&In.match.push(vg),dt.sync=In;let bg=In.key,ed=fv(bg);function Ja(b,A,L,O,q,K,lt){In.filters.pub(b,A,L,O,q,K,lt)&&ed.pub(b,A,L,O,q,K,lt)}ed.sub(i);function Mb(b,A,L,O,q,K,lt){In.filters.sub(b,A,L,O,q,K,lt)&&Bo[b](null,A,L,O,q,K,lt)}i.pub=Mb;function wb(){ed.unsub(i),Cm.delete(i),Wn.clear(),wm(yf,La,yg),c.remove(),Pt?.remove(),Yn("destroy")}i.destroy=wb;function nd(){Yn("init",n,t),Xa(t||n.data,!1),V[S]?$f(S,V[S]):qa(),rt=tn.show&&(tn.width>0||tn.height>0),nt=mt=!0,z(n.width,n.height)}return y.forEach(Ro),w.forEach(Ws),e?e instanceof HTMLElement?(e.appendChild(c),nd()):e(i,nd):nd(),i}ti.assign=Dn;ti.fmtNum=Fm;ti.rangeNum=vf;ti.rangeLog=Mf;ti.rangeAsinh=Nm;ti.orient=Eo;ti.pxRatio=Ue;ti.join=rR;ti.fmtDate=Bm,ti.tzDate=gR;ti.sync=fv;{ti.addGap=KR,ti.clipGaps=Tf;let n=ti.paths={points:xv};n.linear=vv,n.stepped=eC,n.bars=nC,n.spline=sC}var fc=0;function Vi(){fc+=1,N.moving&&(N.moving=!1,ie("moving",!1))}function vs(n,t=.8){Vi();let e=N.q.slice(),i=fc,s=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),N.moving=!0,ie("moving",!0),new Promise(r=>{(function o(a){if(i!==fc||e.length!==N.q.length){r(!1);return}let l=t>0?Math.min(Math.max((a-s)/(1e3*t),0),1):1,c=l**3*(10-15*l+6*l*l);Cs(l<1?e.map((h,f)=>h+c*(n[f]-h)):n.slice(),"move"),l<1?requestAnimationFrame(o):(N.moving=!1,ie("moving",!1),r(!0))})(s)})}function wv(n,t,e,i){Vi();let s=fc,r=performance.now()-1e3*n*t;N.moving=!0,ie("moving",!0),requestAnimationFrame(function o(a){if(s!==fc){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(N.moving=!1,ie("moving",!1),i?.(!0))})}var Xm={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},Ev={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},Pf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,Tv=80;function mC(n){let t=[];Pf.lastIndex=0;let e=n.trimEnd();for(;Pf.lastIndex<e.length;){let i=Pf.lastIndex,s=Pf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function If(n,t="plain"){let e=String(n);if(e.length>Tv)throw new Error(`longer than ${Tv} characters`);let i=mC(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in Ct.suffix(t)&&(s=Ct.suffix(t)[r.word],i.pop());let o=0,a=!1,l=p=>i[o]?.sign===p,c=p=>{if(!l(p))throw new Error(`\u201C${p}\u201D is missing`);o++};function h(){let p=f();for(;l("+")||l("-");){let y=i[o++].sign,w=f();p=y==="+"?p+w:p-w}return p}function f(){let p=u();for(;;)if(l("*"))o++,p*=u();else if(l("/"))o++,p/=u();else if(i[o]?.word||l("("))p*=d();else return p}function u(){return l("-")?(o++,-u()):l("+")?(o++,u()):d()}function d(){let p=g();return l("^")?(o++,p**u()):p}function g(){let p=i[o];if(!p)throw new Error("something is missing at the end");if(o++,p.number!==void 0)return p.number;if(p.sign==="("){let y=h();return c(")"),y}if(p.word){let y=p.word.toLowerCase();if(Object.hasOwn(Ev,y))return a=!0,Ev[y];if(Object.hasOwn(Xm,y)){c("(");let w=h();return c(")"),Xm[y](w)}throw new Error(`\u201C${p.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(Xm).join(", ")}`)}throw new Error(`\u201C${p.sign}\u201D is not expected here`)}let _=h();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(_))throw new Error("not a finite number");let m=s??(t==="angle"&&a?1:Ct.factor(t));return{value:_/m+0,symbolic:a||s!==null||i.length>2}}function Ri({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=T("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),h=null,f=null,u=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let _=If(c.value,l()),m=a?.(_.value);if(m)throw new Error(m);return _},d=_=>{c.classList.toggle("wrong",!!_),_?(c.setAttribute("aria-invalid","true"),c.title=_):(c.removeAttribute("aria-invalid"),c.title=o??""),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:_?{label:n,reason:_}:null}))},g=_=>{try{let m=u();return d(null),_?.(m.value,{symbolic:m.symbolic,text:c.value.trim()}),!0}catch(m){return d(m.message),!1}};return c.addEventListener("input",()=>g(e)),c.addEventListener("change",()=>{g(i??e)&&c.blurred?.()}),c.addEventListener("focus",()=>c.select()),c.addEventListener("keydown",_=>{let m={ArrowUp:1,ArrowDown:-1}[_.key];if(_.key==="Enter"&&c.select(),!!m){_.preventDefault();try{let p=u();c.value=nc((p.value??0)+m*Ct.step(l())*(_.shiftKey?.1:1),l()),g(i??e)}catch{}}}),c.put=(_,m=null)=>{document.activeElement===c&&!c.readOnly||_===h&&m===f&&!c.classList.contains("wrong")||(h=_,f=m,c.value=m??(_==null?"":nc(_,l())),c.classList.contains("wrong")&&d(null))},c.refresh=()=>{let _=h,m=f;h=NaN,c.put(_,m)},c}var je=n=>n.type==="R"?"angle":"length";function Av(n){let t=n.type==="R"?Math.PI:ko(N.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}function gC(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function _C(n){let t=N.table.joints[n],e=je(t),{lo:i,hi:s,min:r,max:o}=Av(t),a=`q${n+1}`,l=T("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=g=>`${100*(g-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{Vi(),Ec(n,Number(l.value))}),l.addEventListener("keydown",g=>{let _={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[g.key],m={Home:i,End:s}[g.key];if(_===void 0&&m===void 0)return;g.preventDefault(),Vi();let p=Ct.step(e)*(g.shiftKey?.1:1);Ec(n,m??Math.min(Math.max(Math.round((N.q[n]+_*p)/(p/10))*(p/10),r),o))});let h=Ri({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:g=>{Vi(),Ec(n,g)}}),f=T("span",{class:"out",role:"note"}),u=T("span",{class:"limits"}),d=T("div",{class:"joint","data-testid":`joint-${n+1}`},T("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},T("i",{text:"q"}),T("sub",{text:String(n+1)})),T("div",{class:"track"},l,T("div",{class:"under"},u,f)),h,T("span",{class:"unit"}));return{el:d,number:h,show(){let g=N.q[n],_=gC(t,g);(document.activeElement!==l||Number(l.value)!==g)&&(l.value=g),l.style.setProperty("--at",c(Math.min(Math.max(g,r),o))),l.setAttribute("aria-valuetext",mn(g,e)),h.put(Number((g*Ct.factor(e)).toFixed(Ct.digits(e)+1))/Ct.factor(e)),d.classList.toggle("outside",_!==0),Ot(f,_?`${mn(Math.abs(_),e)} ${_>0?"above":"below"} the limit`:"")},relabel(){Ot(d.lastChild,Ct.symbol(e));let g=_=>_===null?"no limit":mn(_,e,Ct.angle==="deg"&&e==="angle"?0:void 0);Ot(u,t.lower===null&&t.upper===null?"no limits":`${g(t.lower)} \u2026 ${g(t.upper)}`),h.refresh(),this.show()}}}var Rv={id:"joints",title:"Joints",build(n){let t=[],e=T("div",{class:"joints","data-testid":"joints"}),i=T("div",{class:"chips",role:"group","aria-label":"Postures"}),s=T("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=N.table.joints.map((o,a)=>_C(a)),ee(e,t.map(o=>o.el)),t.length||e.append(T("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),ee(s,N.table.actuator?xC(N.table.actuator):null),yC(i)};yt("table",r),yt("q",()=>t.forEach(o=>o.show())),yt("units",()=>t.forEach(o=>o.relabel())),r()}};function xC(n){let t=T("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=T("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),Ot(e,jn(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n.value=Number(t.value),i()}),i();let s=T("div",{class:"under"},T("span",{text:`${n.name}: moves no frame`}));return T("div",{class:"joint"},T("span",{class:"joint-name",text:"tool"}),T("div",{class:"track"},t,s),e,T("span",{class:"unit",text:n.unit}))}function yC(n){let t=N.table.joints.length,e=Object.entries(N.table.postures??{}),i=(r,o)=>T("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>mn(a,je(N.table.joints[l]))).join(", "),on:{click:()=>vs(o)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),ee(n,s,t?T("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>vs(vC())}}):null,t?T("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:bC}}):null)}function vC(){return N.table.joints.map(n=>{let{lo:t,hi:e}=Av(n);return t+Math.random()*(e-t)})}function bC(){let n={...N.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=N.q.slice(),Fn({...N.table,postures:n},{what:"postures"}),ni(`Kept as P${t}: ${N.q.map((e,i)=>nc(e,je(N.table.joints[i]))).join(", ")}`),ie("postures")}var Cv=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function Lf({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(h=>Mr(n,h));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(h=>Xe(h[h.length-1])),speeds:o??SC(t,r),least:t.map((h,f)=>wc(n,h,c[f])[0]??0)}}function SC(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function qm(n,t){let{table:e}=n,i=Ct.factor("length");if(t==="position")return{y:`tool, ${Ct.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(h=>h[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(je))].map(l=>(l==="angle"?Ct.angle:Ct.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(h=>h[c]*Ct.factor(je(l)))}))}}function Pv(n){let t=Ct.angle,e=Ct.length,{table:i}=n,s=l=>je(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(h=>h*Ct.factor("length")),...l.map((h,f)=>h*Ct.factor(je(i.joints[f]))),...n.speeds[c].map((h,f)=>h*Ct.factor(je(i.joints[f]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function Iv(n,t,e){let{y:i,list:s}=qm(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(x=>x.values),h=n.xEnd??l[l.length-1],f=l[0],u=h>f?h:f+1,[d,g]=[Math.min(...c),Math.max(...c)];g-d>1e-9||(d-=1,g+=1);let _=x=>a.l+(x-f)/(u-f)*(r-a.l-a.r),m=x=>o-a.b-(x-d)/(g-d)*(o-a.t-a.b),p=(x,M)=>{let F=(M-x)/6,I=10**Math.floor(Math.log10(F)),D=[1,2,5,10].map(k=>k*I).find(k=>k>=F);return Array.from({length:12},(k,X)=>(Math.ceil(x/D)+X)*D).filter(k=>k<=M+D*1e-6)},y=x=>x.toFixed(2),w=x=>String(Number(x.toPrecision(6))),v=x=>x.replace(/[&<>"]/g,M=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[M]),C=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],S=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let x of p(d,g))S.push(`<path d="M${a.l} ${y(m(x))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${y(m(x)+4)}" text-anchor="end">${w(x)}</text>`);for(let x of p(f,u))S.push(`<path d="M${y(_(x))} ${o-a.b}v5" stroke="#333"/><text x="${y(_(x))}" y="${o-a.b+20}" text-anchor="middle">${w(x)}</text>`);S.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let x of n.events)Number.isFinite(x.x)&&S.push(`<path d="M${y(_(x.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${y(_(x.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(x.short)}</text>`);return s.forEach((x,M)=>{let F=e[M%e.length],I=x.values[x.values.length-1];S.push(`<polyline fill="none" stroke="${F}" stroke-width="1.8" stroke-dasharray="${C[M%C.length]}" points="${x.values.map((D,k)=>`${y(_(l[k]))},${y(m(D))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*M}h22" stroke="${F}" stroke-width="2" stroke-dasharray="${C[M%C.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*M}"><title>${y(I)}</title>${v(x.name)}</text>`)}),S.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${S.join("")}</svg>
`}var He=null,Vn=null,za="joints",ts=0,Lv=1,ai=null;function Dv(n){let t=T("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:MC}}),e=T("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{Vi(),Uf(Number(e.value))}}}),i=T("output",{class:"where","data-testid":"where"}),s=T("div",{class:"marks"}),r=T("div",{class:"chart","data-testid":"chart"}),o=T("div",{class:"legend"});n.append(T("div",{class:"dock-bar"},t,di("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{Lv=Number(a)},{"data-testid":"speed"}),T("div",{class:"scrubber"},e,s),i,T("span",{class:"line"},...[["CSV",()=>Ks("motion.csv",Pv(He),"text/csv")],["PNG",EC],["SVG",()=>Ks(`${za}.svg`,Iv(He,za,be.curves),"image/svg+xml")]].map(([a,l])=>T("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>He&&l()}})),T("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>To(null)}}))),T("div",{class:"dock-bar second"},bn("Curves",Cv,za,a=>{za=a,Ym()},"curves"),o),r),ai={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Er(()=>Vn&&r.clientWidth&&Vn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),yt(["units","theme"],Ym),yt("moving",a=>Ot(t,a&&Nf?"Pause":"Play")),yt("table",a=>{He&&a!=="postures"&&a!=="name"&&To(null)})}function To(n){if(Vi(),He=n,N.motion=n,ai.root.hidden=!n,Vn&&(Vn.destroy(),Vn=null),!n){requestAnimationFrame(()=>Hr()),ie("motion");return}ai.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;ee(ai.marks,n.events.map(e=>{let i=T("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i})),Ym(),n.q.length&&Uf(0),requestAnimationFrame(()=>Hr()),ie("motion")}function Uf(n){He?.q.length&&(ts=Math.min(Math.max(Math.round(n),0),He.q.length-1),ai.scrub.value=String(ts),ai.scrub.style.setProperty("--at",`${He.q.length>1?100*ts/(He.q.length-1):0}%`),Ot(ai.where,He.xName==="point"?`point ${ts+1} of ${He.q.length}`:`${jn(He.xs[ts],2)} s of ${jn(He.xs[He.xs.length-1],2)} s`),ai.scrub.setAttribute("aria-valuetext",ai.where.textContent),Cs(He.q[ts].slice(),"scrub"),$m())}var Nf=!1;function MC(){if(Nf){Vi();return}if(!He?.q.length)return;let n=He.seconds,t=n[n.length-1]||1,e=ts>=He.q.length-1?0:n[ts]/t;Nf=!0,wv(t/Lv,e,i=>{let s=ts<=He.q.length-1&&n[ts]<=i*t?ts:0;for(;s<n.length-1&&n[s+1]<=i*t+1e-9;)s+=1;Uf(s)},()=>{Nf=!1,Ot(ai.toggle,"Play")}),Ot(ai.toggle,"Pause")}function Ym(){if(!He||!ai)return;Vn&&(Vn.destroy(),Vn=null);let{y:n,list:t}=qm(He,za),e={stroke:be.line,width:1},i=`${Math.round(.78*Df())}px "Inter Variable", system-ui, sans-serif`;ee(ai.legend,t.map((o,a)=>{let l=T("span",{class:"swatch"});return l.style.setProperty("background",be.curves[a%be.curves.length]),T("span",{},l,o.name)}));let s={stroke:be.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*Df(),gap:4};Vn=new ti({width:ai.chart.clientWidth||600,height:ai.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,He.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:be.curves[a%be.curves.length],width:1.75,pxAlign:0,points:{show:He.q.length<3}}))],axes:[{...s,label:He.xName==="point"?"point number":"time, s",size:2.1*Df()},{...s,label:n,size:4*Df()}]},[He.xs,...t.map(o=>o.values)],ai.chart);let r=T("div",{class:"now"});Vn.over.append(r,...He.events.map(o=>{let a=T("div",{class:`event ${o.stop?"stop":""}`,title:o.text},T("span",{text:o.short}));return a.x=o.x,a})),Vn.over.addEventListener("pointerdown",o=>{let a=h=>Uf(wC(Vn.posToVal(h.clientX-Vn.over.getBoundingClientRect().left,"x")));Vi(),a(o);let l=h=>a(h),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),Vn.hooks.setSize=[$m],$m()}var Df=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),wC=n=>He.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(He.xs[t]-n)?i:t,0);function $m(){if(!Vn)return;let n=Vn.over.clientWidth;for(let t of Vn.over.querySelectorAll(".now, .event")){let e=Vn.valToPos(t.x??He.xs[ts],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}function EC(){let n=Vn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=be.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>Ks(`${za}.png`,i))}function Nv(n){let t=T("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>TC(t.value)}}),e=T("p",{class:"sentence","data-testid":"sentence"}),i=T("span",{class:"online",role:"status","data-testid":"online"}),s=()=>{let r=N.catalog?.includes(N.table.name)?[]:[T("option",{value:"",text:N.table.name||"my-arm"})];ee(t,r,(N.catalog??[]).map(o=>T("option",{value:o,text:o}))),t.value=r.length?"":N.table.name};n.append(T("span",{class:"mark"},T("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),T("b",{text:"pieper"})),t,e,T("span",{class:"bar-end"},i,bn("Angles in",[["deg","\xB0"],["rad","rad"]],Ct.angle,r=>{Ct.set("angle",r),ie("units")},"unit-angle"),bn("Lengths in",[["mm","mm"],["m","m"]],Ct.length,r=>{Ct.set("length",r),ie("units")},"unit-length"),di("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],N.theme,Dc,{"data-testid":"theme"}))),yt(["catalog","table"],s),yt("plan",()=>{Ot(e,[Nc(N.plan),Fg(N.plan)].filter(Boolean).join(". ").replace("..",".")),e.title=N.plan?.explain??""}),yt("online",r=>{Ot(i,r?"":"Server away; reconnecting"),i.classList.toggle("away",!r)}),yt(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(Ct.angle),n.querySelector("[data-testid=unit-length]").mark(Ct.length),n.querySelector("[data-testid=theme]").value=N.theme})}async function TC(n){if(n)try{let{table:t}=await Js("load",{name:n});Fn(t,{q:zo(t),what:"new"})}catch(t){ni(t.message,"wrong")}}function Uv(n,t,e,i){let s=T("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=i.map(l=>{let c=T("div",{role:"tabpanel",class:"panel",id:`panel-${l.id}`,"aria-labelledby":`tab-${l.id}`,"data-testid":`panel-${l.id}`,hidden:!0});for(let f of l.sections??[l]){let u=T("section",{class:"section"},T("h2",{text:f.title}));c.append(u),f.build(u,c)}let h=T("button",{type:"button",role:"tab",id:`tab-${l.id}`,"aria-controls":c.id,text:l.title,on:{click:()=>a(l.id)}});return s.append(h),{...l,panel:c,tab:h}});function a(l){r.matches&&l==="move"&&(l="inverse"),N.panel=l;for(let c of o){let h=r.matches&&c.id==="move",f=c.id===l||h;(h?e:t).append(c.panel),c.panel.hidden=!f,c.tab.hidden=h,c.tab.setAttribute("aria-selected",String(c.id===l)),c.tab.tabIndex=c.id===l?0:-1,c.id===l&&(document.getElementById("room").dataset.panel=l,document.getElementById("room").classList.toggle("wide",!!c.wide))}ie("panel",l)}return s.addEventListener("keydown",l=>{let c={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[l.key];if(!c)return;l.preventDefault();let h=o.filter(d=>!d.tab.hidden),f=h.findIndex(d=>d.id===N.panel),u=h[(f+c+h.length)%h.length];a(u.id),u.tab.focus()}),r.addEventListener("change",()=>a(N.panel==="move"||!o.some(l=>l.id===N.panel)?"move":N.panel)),a(N.panel),a}function Fv(n){let t=T("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,h])=>T("button",{type:"button",text:h,on:{click:()=>Bp(c)}})),T("button",{type:"button",text:"Fit",on:{click:()=>Hr()}})),e=T("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=T("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),Ex(c)}}}),s=T("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:ef}}),r=T("span",{class:"scale"}),o=T("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,h)=>{let f=T("span",{class:"dot"});return f.style.setProperty("background",ql[h]),T("span",{},f,c)}),r);n.append(T("div",{class:"corner top"},t,T("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s)),T("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=N.table.joints.length,h=Array.from({length:c+2},(u,d)=>d);N.shownFrames=(N.shownFrames??[0,c+1]).map(u=>u===a+1?c+1:u).filter(u=>u<c+2),a=c;let f=u=>{N.shownFrames=u,l()};ee(e,T("span",{class:"group-name",text:"Frames"}),h.map(u=>T("button",{type:"button",text:tf(u),"aria-pressed":String(N.shownFrames.includes(u)),"aria-label":`Frame ${tf(u)}`,on:{click:()=>f(N.shownFrames.includes(u)?N.shownFrames.filter(d=>d!==u):[...N.shownFrames,u])}})),T("button",{type:"button",text:N.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>f(N.shownFrames.length===c+2?[]:h)}})),ie("frames"),Ot(r,`grid ${mn(Hp.cell,"length",Ct.length==="mm"?0:2)}`)};yt(["table","units"],l),l()}function Ov(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text], textarea")&&!n.target.closest(".dh")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),Tc()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),Ac()))})}function Ff(n,t){let e=Array.from({length:16},(s,r)=>T("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=T("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>T("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;Ot(e[r],r>=12?String(s[r]):o?jn(s[r]*Ct.factor("length"),Ct.digits("length")):jn(s[r],4))}},i}var Of=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var Jm=()=>N.frames[N.frames.length-1],kv={id:"pose",title:"Pose",build(n){let t=Ff("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(h=>Bv(h,"length",`pose-${h.toLowerCase()}`)),i=T("div",{class:"quantities","data-testid":"orientation"}),s=T("p",{class:"hint order"}),r=[],o=di("Notation of the orientation",Object.entries(gs).map(([h,f])=>[h,f.title]),N.notation,h=>{N.notation=h,ie("notation")}),a=T("span",{class:"copies"},T("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>Kr(Of(Jm()))}}),T("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>Kr(AC())}}));n.append(T("div",{class:"subhead"},T("span",{text:"Tool in the base frame"}),a),t,T("div",{class:"quantities"},e.map(h=>h.el)),T("div",{class:"line"},o,s),i);let l=()=>{let h=gs[N.notation];o.value=N.notation,Ot(s,h.order),r=h.names.map((f,u)=>Bv(f,h.kinds[u],`turn-${u}`)),ee(i,r.map(f=>f.el)),c()},c=()=>{let h=Jm();t.show(h),Xe(h).forEach((f,u)=>e[u].show(f)),gs[N.notation].to(h).forEach((f,u)=>r[u].show(f))};yt("q",c),yt("notation",l),yt("units",()=>{e.forEach(h=>h.relabel()),r.forEach(h=>h.relabel()),c()}),l()}};function AC(){let n=Jm(),t=gs[N.notation],e=Xe(n).map((s,r)=>`${"XYZ"[r]} ${Si(s,"length")} ${Ct.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${Si(s,"angle")} ${Ct.symbol("angle")}`:jn(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function Bv(n,t,e){let i=T("output",{"data-testid":e}),s=T("span",{class:"unit",text:Ct.symbol(t)});return{el:T("div",{class:"quantity"},T("span",{class:"quantity-name",text:n}),i,s),show:o=>Ot(i,t==="plain"?jn(o,5):Si(o,t)),relabel:()=>Ot(s,Ct.symbol(t))}}function RC(n,t){let e=[],i=n.joints.length,s=r=>n.convention==="standard"?n.joints[r].alpha:n.joints[r+1]?.alpha;for(let r=0;r<i-1;r++){let o=jr(n.joints[r],t[r]).theta,a=1,l=`${r+1}`;for(let c=r;c<i-1;c++){let h=s(c);if(Math.abs(Math.sin(h))>1e-9||n.joints[c+1].type!=="R"||n.joints[r].type!=="R")break;a*=Math.sign(Math.cos(h)),o+=a*jr(n.joints[c+1],t[c+1]).theta,l+=`${a>0?"":"\u2212"}${c+2}`,e.push({name:l,value:o})}}return e}var zv={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=T("div",{class:"cards","data-testid":"matrices"}),a=T("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=di("Posture",[["now","present posture"]],"now",g=>{e=g,u()}),c=T("span",{class:"partial"});n.append(T("div",{class:"line"},bn("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,g=>{t=g,f()},"matrix-mode"),c),T("div",{class:"line"},T("span",{class:"field-name",text:"Numbers of the"}),l),o,T("h3",{text:"Intermediate angles"}),T("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let h=()=>e!=="now"&&N.solutions?.rows[Number(e)]?.q||N.q,f=()=>{let g=N.table.joints.length;i=Math.min(i,g),s=s===0||s>g?g:s;let _=t==="links"?N.table.joints.map((p,y)=>["A",String(y+1),""]):t==="products"?N.table.joints.map((p,y)=>["T",String(y+1),"0"]):[["T",String(s),String(i)]];t==="links"&&_.push(["T","tool","base"]);let m=Array.from({length:g+1},(p,y)=>[String(y),String(y)]);ee(c,t==="partial"?[di("From frame",m,String(i),p=>{i=Number(p),f()})," \u2192 ",di("To frame",m,String(s),p=>{s=Number(p),f()})]:[]),r=_.map(([p,y,w])=>({grid:Ff(`${p} ${w} ${y}`,`matrix-${p}${w}${w?"-":""}${y}`),note:T("span",{class:"hint"}),sym:p,low:y,high:w})),ee(o,r.map(({grid:p,note:y,sym:w,low:v,high:C})=>T("figure",{class:"card"},T("figcaption",{},T("span",{class:"symbol"},C?T("sup",{text:C}):null,T("i",{text:w}),T("sub",{text:v})),y),p))),u()},u=Er(()=>{if(n.closest(".panel").hidden||!N.table.joints.length)return;let g=h(),_=Eg(N.table,g),m=_.length;r.forEach(({grid:y,note:w},v)=>{if(t==="links"&&v<m)y.show(_[v]),Ot(w,`q${v+1} = ${mn(g[v],je(N.table.joints[v]))}`);else if(t==="links")y.show(Mr(N.table,g)[m+1]);else if(t==="products")y.show(_.slice(0,v+1).reduce(Jr,Zs()));else{let C=S=>_.slice(0,S).reduce(Jr,Zs());y.show(Jr(Mg(C(i)),C(s)))}});let p=N.table.joints.map((y,w)=>[y.type==="R"?`\u03B8${w+1}`:`d${w+1}`,y.type==="R"?Si(jr(y,g[w]).theta,"angle"):Si(jr(y,g[w]).d,"length"),y.type==="R"?"angle":"length"]).concat(RC(N.table,g).map(({name:y,value:w})=>[`\u03B8${y}`,Si(w,"angle"),"angle"]));ee(a,T("tbody",{},p.map(([y,w,v])=>T("tr",{},T("th",{scope:"row"},T("i",{text:y[0]}),T("sub",{text:y.slice(1)})),T("td",{text:w}),T("td",{class:"unit",text:Ct.symbol(v)})))))}),d=()=>{if(n.closest(".panel").hidden)return;let g=N.solutions?.rows??[];ee(l,T("option",{value:"now",text:"present posture"}),g.map((_,m)=>T("option",{value:String(m),text:`solution ${m+1}: ${_.label??""}`}))),e!=="now"&&!g[Number(e)]&&(e="now"),l.value=e,u()};yt("table",f),yt(["q","units","panel"],u),yt(["solutions","panel"],d),f()}};var CC=.002;function Ao(n,t,e,i){let s=[],r=!1,o="",a=T("div",{class:"pose-fields"}),l=()=>{let h=gs[N.notation],f=[["X","length"],["Y","length"],["Z","length"],...h.names.map((d,g)=>[d,h.kinds[g]])],u=d=>{let g=Wx(N.notation,s.slice(3).map(_=>_.value),s.slice(0,3).map(_=>_.value));g&&i(g,d)};s=f.map(([d,g],_)=>{let m={value:0,kind:g},p=(y,w)=>{m.value=y;let v=!r;r=!w,u(v)};return m.f=Ri({label:`${n}, ${d}`,kind:g,testid:`${t}-${_}`,input:y=>p(y,!1),commit:y=>p(y,!0)}),m.el=T("label",{class:"pose-field"},T("span",{text:d}),m.f,T("span",{class:"unit",text:Ct.symbol(g)})),m}),ee(a,s.map(d=>d.el)),o=N.notation},c=()=>{o!==N.notation&&l();let h=e();!h||a.contains(document.activeElement)||[...Xe(h),...gs[N.notation].to(h)].forEach((f,u)=>{s[u].value=f,s[u].f.put(f,PC(f,s[u].kind))})};return yt("units",()=>{l(),c()}),yt("notation",c),l(),c(),a.addEventListener("focusout",()=>{r=!1,setTimeout(c)}),{el:T("fieldset",{class:"pose-editor"},T("legend",{text:n}),a),show:c}}var PC=(n,t)=>String(Number((n*Ct.factor(t)).toFixed(t==="plain"||Ct[t]==="m"||Ct[t]==="rad"?6:3))+0);function Hv(n){let t=(n.replaceAll("\u2212","-").match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Sc(e);if(i>CC)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=Ct.factor("length");return Mc(e)}var IC=2;function Gv(n,t){let e=t?.self_motions??[],i=Ie.task??N.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let c of n.querySelectorAll("input"))c.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){ee(n,T("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=c=>c.dimension>1?`one line in a surface of ${c.dimension} dimensions`:c.closed?"a closed curve":"an open curve",l=e.length>IC;ee(n,l?T("p",{},T("strong",{text:`${e.length} self-motions`}),`: the arm moves along each, ${o}.`):null,e.map((c,h)=>{let f=LC(c,h,t.T,s),u=c.inside.length?"":"All of it lies outside the limits.";if(l)return T("div",{class:"self-motion short"},T("span",{title:u,text:`${h+1}, ${u?"outside the limits":c.dimension>1?"in a surface":a(c)}`}),f);let d=c.moves.length>3?"most of its joints":c.moves.join(" and ");return T("div",{class:"self-motion"},T("p",{},T("strong",{text:e.length>1?`Self-motion ${h+1} of ${e.length}`:"Self-motion"}),` by ${d}, ${a(c)}: the arm moves, ${o}. ${u}`),f)}))}function LC(n,t,e,i){let s=T("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{Vi();let a=Number(s.value),l=Math.max(n.s.findLastIndex(u=>u<=a),0),c=Math.min(l+1,n.q.length-1),h=c>l?(a-n.s[l])/(n.s[c]-n.s[l]):0;s.style.setProperty("--at",`${100*a}%`);let f=n.q[l].map((u,d)=>u+h*(n.q[c][d]-u));Cs(i?Tg(N.table,f,e):f,"self-motion")},o=a=>a.reduce((l,c,h)=>l+Math.sin((c-N.q[h])/2)**2,0);return s.value=String(n.s[n.q.reduce((a,l,c)=>o(l)<o(n.q[a])?c:a,0)]),s.style.setProperty("--at",`${100*Number(s.value)}%`),n.inside.length===1&&(s.style.setProperty("--lo",`${100*n.inside[0][0]}%`),s.style.setProperty("--hi",`${100*n.inside[0][1]}%`)),s.addEventListener("input",r),s.addEventListener("keydown",a=>{let l={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[a.key];if(!l)return;a.preventDefault();let c=Number(s.value)+l/100;s.value=String(n.closed?c-Math.floor(c):Math.min(Math.max(c,0),1)),r()}),s}function Vv(){let n=[],t=[],e={},i=T("div",{class:"joints"}),s=T("p",{class:"hint"}),r=bn("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",u=>a(u==="chosen"?n.filter(d=>!d.instead).map(d=>d.name):null),"spare-mode"),o=T("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},T("div",{class:"line spread"},T("span",{class:"field-name",text:"Redundant coordinates"}),r),s,i);function a(u,{sliding:d=!1}={}){Ie.redundancy=u&&Object.fromEntries(u.map(g=>[g,e[g]])),f(),d?Gx():Gs()}let l=u=>n.filter(d=>d.instead===u.instead).map(d=>d.name),c=u=>N.table.joints.findIndex(d=>d.name===u.name);function h(u,d){let g=u.kind==="angle"?Math.PI:ko(N.table),_=u.lower??-g,m=u.upper??g,p=T("input",{type:"range",min:String(_),max:String(m),step:"any","aria-label":`Slide ${u.name}`,"data-testid":`spare-slider-${d+1}`}),y=!1,w=(x,M)=>{e[u.name]=x,a(l(u),{sliding:M})};p.addEventListener("input",()=>w(Number(p.value),!0)),p.addEventListener("change",()=>Gs()),p.addEventListener("keydown",x=>{let M={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[x.key];if(M===void 0)return;x.preventDefault(),y=!0;let F=M*Ct.step(u.kind)*(x.shiftKey?.1:1);w(Math.min(Math.max(e[u.name]+F,_),m),!0)}),p.addEventListener("keyup",()=>{y&&Gs(),y=!1});let v=Ri({label:`Value of ${u.name}`,kind:u.kind,testid:`spare-${d+1}`,check:x=>x<_-1e-9&&u.lower!==null?`below the limit ${mn(_,u.kind)}`:x>m+1e-9&&u.upper!==null?`above the limit ${mn(m,u.kind)}`:null,commit:x=>w(x,!1)}),C=T("span",{class:"limits"}),S=T("div",{class:"joint"},T("span",{class:"joint-name",text:u.name}),T("div",{class:"track"},p,T("div",{class:"under"},C)),v,T("span",{class:"unit"}));return{line:S,show(){let x=e[u.name];p.value=x,p.style.setProperty("--at",`${100*(Math.min(Math.max(x,_),m)-_)/(m-_||1)}%`),p.setAttribute("aria-valuetext",mn(x,u.kind)),S.classList.toggle("held",!!(Ie.redundancy&&u.name in Ie.redundancy)),v.put(Number((x*Ct.factor(u.kind)).toFixed(Ct.digits(u.kind)+1))/Ct.factor(u.kind))},relabel(){Ot(S.lastChild,Ct.symbol(u.kind));let x=M=>M===null?"no limit":mn(M,u.kind,u.kind==="angle"&&Ct.angle==="deg"?0:void 0);Ot(C,u.lower===null&&u.upper===null?"no limits":`${x(u.lower)} \u2026 ${x(u.upper)}`),v.refresh()}}}function f(){for(let u of n)Ie.redundancy&&u.name in Ie.redundancy?e[u.name]=Ie.redundancy[u.name]:c(u)>=0?e[u.name]=N.q[c(u)]:u.instead&&Number.isFinite(N.solutions?.arm_angle)?e[u.name]=N.solutions.arm_angle:e[u.name]??=0;r.mark(Ie.redundancy?"chosen":"free"),Ot(s,Ie.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at these values. Slide one to hold it.");for(let u of t)u.show()}return yt("solutions",()=>{let u=N.solutions?.spare;if(!(!N.solutions||!u&&(N.solutions.brief||N.solutions.status==="REFUSED"))){if(JSON.stringify(u??[])!==JSON.stringify(n)){n=u??[],e={},t=n.map(h),ee(i,t.map(d=>d.line));for(let d of t)d.relabel()}o.hidden=n.length===0,f()}}),yt("q",()=>!o.hidden&&!o.closest("[hidden]")&&!Ie.redundancy&&f()),yt("units",()=>{for(let u of t)u.relabel();f()}),o}function Wv(){let n=T("thead"),t=T("tbody"),e=T("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=T("div",{class:"scroll"},T("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${N.table.joints.map(c=>c.type).join("")}${Ct.angle}${Ct.length}`;l!==r&&(r=l,s=[],ee(t),ee(n,T("tr",{},T("th",{text:""}),T("th",{class:"left",text:"posture"}),N.table.joints.map((c,h)=>T("th",{},T("i",{text:"q"}),T("sub",{text:String(h+1)}),T("span",{class:"unit",text:` ${Ct.symbol(je(c))}`}))),T("th",{text:"residual"}))))},a=l=>{let c=N.table.joints.map(()=>T("td")),h=T("span"),f=T("span",{class:"offscreen"}),u=T("td",{class:"unit"}),d=T("tr",{tabindex:"0","data-testid":`solution-${l+1}`},T("th",{scope:"row",text:String(l+1)}),T("td",{class:"left"},h,f),c,u),g=()=>N.solutions?.rows[l]?.q,_=()=>g()&&Aa(g()),m=()=>Aa(null),p=()=>{g()&&(Aa(null),vs(DC(g())))};return d.addEventListener("pointerenter",_),d.addEventListener("pointerleave",m),d.addEventListener("focus",_),d.addEventListener("blur",m),d.addEventListener("click",p),d.addEventListener("keydown",y=>{(y.key==="Enter"||y.key===" ")&&(y.preventDefault(),p())}),{tr:d,cells:c,label:h,beyond:f,residual:u}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let h=a(s.length);s.push(h),t.append(h.tr)}i.hidden=c.length===0,e.hidden=c.every(h=>h.inside),s.forEach((h,f)=>{let u=c[f];h.tr.hidden=!u,u&&(h.tr.classList.toggle("beyond",!u.inside),u.label!==null&&Ot(h.label,`${u.label}${u.self_motion>=0?" (of a self-motion)":""}`),Ot(h.beyond,u.inside?"":", outside the limits"),Ot(h.residual,u.residual?`${uf(u.residual[0]*1e3)} mm`:""),h.residual.title=u.residual?`${uf(u.residual[0])} m, ${uf(u.residual[1])} rad by forward kinematics`:"",u.q.forEach((d,g)=>{let _=N.table.joints[g],m=_.lower!==null&&d<_.lower-1e-9||_.upper!==null&&d>_.upper+1e-9;Ot(h.cells[g],Si(d,je(_),je(_)==="angle"&&Ct.angle==="deg"?1:void 0)),h.cells[g].classList.toggle("out",m)}))}),this.mark()},mark(){let l=N.solutions?.rows??[];s.forEach((c,h)=>c.tr.classList.toggle("here",!!l[h]&&l[h].q.length===N.q.length&&l[h].q.every((f,u)=>Math.abs(Math.sin((f-N.q[u])/2))<1e-5)))}}}function DC(n){return n.map((t,e)=>{let i=N.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((N.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}var NC={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},Xv={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},UC=new Set(["REDUNDANT","UNCERTAIN"]),jm=120;function Km(){Ps(N.frames[N.frames.length-1].slice(),"taken")}var qv={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(T("div",{class:"line spread"},T("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:Km}}),bn("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",_=>{i.hidden=_!=="numbers",s.hidden=_!=="matrix"},"target-as")));let e=Ao("Target","target",()=>N.target,_=>Ps(_,"typed")),i=T("div",{},e.el),{el:s,show:r}=FC();n.append(i,s,OC());let o=T("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=T("div",{class:"near","data-testid":"ik-nearest"}),l=T("div",{class:"self-motions","data-testid":"self-motions"}),c=Wv();n.append(Vv(),o,a,l,c.el);let h=Ic(jm,()=>{e.show(),r()}),f=Ic(jm,()=>{if(t.hidden)return;let _=N.solutions;BC(o,_),kC(a,_),Gv(l,_),c.show(_)}),u=Ic(jm,()=>c.mark()),d=_=>()=>hf()?_.soon():_();yt("target",d(h)),yt("notation",e.show),yt(["solutions","units"],d(f)),yt("q",d(u));let g=()=>Ta("target",N.panel==="inverse"?[Xe(N.target)]:[]);yt("target",_=>_!=="drag"&&g()),yt("panel",_=>{Ox(_==="inverse"),(_!=="inverse"||N.hasTarget)&&g(),_==="inverse"&&(N.hasTarget?ie("solutions"):(N.hasTarget=!0,Km()))}),yt("table",_=>{_==="new"&&(N.hasTarget=N.panel==="inverse",N.hasTarget&&Km())})}};function FC(){let n=T("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=T("p",{class:"reason",role:"alert"}),e=T("p",{class:"hint"});n.addEventListener("input",()=>{try{Ps(Hv(n.value),"typed"),Ot(t,""),n.removeAttribute("aria-invalid")}catch(s){Ot(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(Ot(e,`Twelve or sixteen numbers, row by row; the last column in ${Ct.length}.`),document.activeElement===n)return;let s=N.target.map((r,o)=>o%4===3&&o<12?r*Ct.factor("length"):r);n.value=Of(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return yt("units",i),i(),{el:T("div",{hidden:!0},n,e,t),show:i}}function OC(){let n=T("span",{class:"line"}),t=T("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{Ie.follow=t.checked}}});return yt("plan",()=>ee(n,N.plan?.solvable?[T("span",{class:"field-name",text:"Task"}),di("Task",[["",`${N.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],Ie.task??"",e=>{Ie.task=e||null,Ie.redundancy=null,Gs()},{"data-testid":"task"})]:[])),T("div",{class:"line controls"},T("span",{class:"line"},T("span",{class:"field-name",text:"Handles"}),bn("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Bx)),bn("Axes of the handles",[["local","Tool"],["world","World"]],"local",kx),T("span",{class:"line"},T("span",{class:"field-name",text:"Ghosts"}),bn("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",e=>{Ie.ghosts=e,Ra()})),T("label",{class:"check"},t,"Arm follows"),n)}function BC(n,t){if(!t){ee(n,T("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=NC[t.status]??"note";let s=t.status==="SOLVED"&&e?"":t.why,r=Xv[t.status]&&!i?Xv[t.status]:UC.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;ee(n,T("strong",{text:r})," ",T("span",{text:s}),t.ms===void 0?null:T("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}function kC(n,t){let e=t?.near;if(!e){ee(n);return}let i=Xe(e.T).map(s=>Si(s,"length")).join(", ");ee(n,T("p",{},T("strong",{text:"Nearest reachable: "}),`${i} ${Ct.symbol("length")}, ${mn(e.metres,"length")} away`,e.radians>.001?`, turned by ${mn(e.radians,"angle")}`:""),T("div",{class:"line"},T("button",{type:"button",text:"Go there",on:{click:()=>vs(e.q)}}),T("button",{type:"button",text:"Make it the target",on:{click:()=>Ps(e.T,"taken")}})))}var Qm=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function Bf(n){return Qm(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function kf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:h})=>({a:l,alpha:c,text:h})),{base:r,tool:o}=n,a;if(t==="modified"){let l=Bf(r)??{a:0,alpha:0};Bf(r)&&(r=Zs()),o=Jr(Qm(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=Bf(o)??{a:0,alpha:0};Bf(o)&&(o=Zs()),r=Jr(r,Qm(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var Yv=30,zC=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),zf=null;function Hf(n,t,e,{symbolic:i,text:s},r){let o=`${n}/${t}`,a=zf!==o;zf=r?null:o;let l=N.table.joints.map((h,f)=>f!==n?h:{...h,[t]:e,text:{...h.text,[t]:i?s:void 0}});Object.is(N.table.joints[n][t],e)&&N.table.joints[n].text?.[t]===l[n].text[t]||Fn({...N.table,joints:l},{step:a,what:"cell"})}function Ha(n,t){zf=null;let e=Object.fromEntries(Object.entries(N.table.postures??{}).map(([i,s])=>[i,t(s)]));Fn({...N.table,joints:n,postures:e},{q:t(N.q),what:"rows"})}function $v(n,t,e){let i=N.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function Zv(){let n=N.table.joints.length;if(n>=Yv){ni(`At most ${Yv} joints.`,"wrong");return}Ha([...N.table.joints,zC(n)],t=>[...t,0]),document.querySelector(`[data-testid="dh-${n+1}-a"]`)?.focus()}function tg(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};Ha(e(N.table.joints),e)}var Jv=()=>{zf=null};async function Gf(){try{Ks(`${N.table.name||"arm"}.toml`,(await Qn("save",{})).text,"application/toml")}catch(n){ni(n.message,"wrong")}}async function jv(n){let t=n.files[0];if(n.value="",!!t){if(t.size>2e5){ni(`${t.name} has ${t.size} bytes; a robot file has at most 200,000.`,"wrong");return}try{let{table:e}=await Js("open",{name:t.name.slice(-80),text:await t.text()});Fn(e,{q:zo(e),what:"new"})}catch(e){ni(e.message,"wrong")}}}var eg={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},HC=n=>n.type==="R"?"angle":"length",Kv={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=T("thead"),s=T("tbody"),r=T("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=T("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=T("p",{class:"verdict","data-testid":"arm-kind"}),l=bn("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],N.table.convention,S=>{S!==N.table.convention&&Fn(kf(N.table,S),{what:"rows"})},"convention"),c=T("p",{class:"hint order"}),h=T("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>Fn({...N.table,name:h.value||"my-arm"},{what:"name"})}}),f=T("button",{type:"button",text:"Undo",title:"Ctrl+Z",on:{click:Tc}}),u=T("button",{type:"button",text:"Redo",title:"Ctrl+Shift+Z",on:{click:Ac}}),d=T("input",{type:"file",accept:".toml,.urdf,.xml",class:"offscreen","aria-label":"Robot file","data-testid":"robot-file",tabindex:"-1",on:{change:()=>jv(d)}}),g=Ao("Base","base",()=>N.table.base,(S,x)=>Fn({...N.table,base:S},{step:x,what:"cell"})),_=Ao("Tool","tool",()=>N.table.tool,(S,x)=>Fn({...N.table,tool:S},{step:x,what:"cell"}));n.append(T("div",{class:"line spread"},T("span",{class:"line"},h,f,u),T("span",{class:"line"},T("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>Fn(Ag(N.table.convention),{q:[],what:"new"})}}),T("button",{type:"button",text:"Open\u2026",title:"A robot file (.toml) or a URDF",on:{click:()=>d.click()}}),d,T("button",{type:"button",text:"Save",title:"As a robot file",on:{click:Gf}}))),T("div",{class:"line spread"},l,bn("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,S=>{t=S,w()},"dh-part")),c,r,T("div",{class:"line"},T("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:Zv}}),T("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians."})),o,a,T("details",{class:"fold","data-testid":"base-tool"},T("summary",{text:"Base and tool"}),g.el,_.el)),n.addEventListener("verdict",S=>{let x=S.detail??GC(n);Ot(o,x?`${x.label}: ${x.reason}. The arm stays as it was.`:"")});let m=(S,x,[M,F,I])=>{let D=S.type==="R"&&M==="theta"||S.type==="P"&&M==="d",k=M==="lower"||M==="upper",X=Ri({label:`Joint ${x+1}, ${F}`,kind:I??HC(S),testid:`dh-${x+1}-${M}`,empty:k?null:void 0,check:U=>k?$v(x,M,U):U!==null&&Math.abs(U)>1e6?"larger than a million":null,input:(U,V)=>Hf(x,M,U,V,!1),commit:(U,V)=>Hf(x,M,U,V,!0)});return k&&(X.placeholder="none"),e.push({f:X,i:x,key:M}),T("td",{class:D?"variable":""},D?T("span",{class:"plus"},T("i",{text:"q"}),T("sub",{text:String(x+1)})," +"):null,X)},p=(S,x)=>T("button",{type:"button",class:`type type-${S.type}`,text:S.type,"data-testid":`dh-${x+1}-type`,"aria-label":`Joint ${x+1} is ${S.type==="R"?"revolute":"prismatic"}; press to change`,title:S.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>Ha(N.table.joints.map((M,F)=>F===x?{...M,type:M.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...M.text,lower:void 0,upper:void 0,offset:void 0}}:M),M=>M.map((F,I)=>I===x?0:F))}}),y=(S,x)=>T("td",{class:"tools"},T("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${S+1} up`,disabled:S===0,on:{click:()=>tg(S,S-1)}}),T("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${S+1} down`,disabled:S===x-1,on:{click:()=>tg(S,S+1)}}),T("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${S+1}`,on:{click:()=>Ha(N.table.joints.filter((M,F)=>F!==S),M=>M.filter((F,I)=>I!==S))}})),w=()=>{e=[];let{joints:S}=N.table,x=N.table.convention==="modified",M=t==="geometry"?eg.geometry.map(([F,I,D])=>T("th",{scope:"col"},T("i",{text:I}),T("sub",{text:x&&(F==="a"||F==="alpha")?"i\u22121":"i"}),T("span",{class:"unit",text:` ${Ct.symbol(D)}`}))):["name","lower limit","upper limit","zero","sense"].map(F=>T("th",{scope:"col",text:F}));ee(i,T("tr",{},T("th",{scope:"col",text:"i"}),T("th",{scope:"col","aria-label":"type"}),M,T("th",{"aria-label":"row tools"}))),ee(s,S.map((F,I)=>{let D=t==="geometry"?eg.geometry.map(k=>m(F,I,k)):[T("td",{},T("input",{type:"text",class:"name",value:F.name,maxlength:"40","aria-label":`Joint ${I+1}, name`,on:{change:k=>Hf(I,"name",k.target.value||`joint_${I+1}`,{},!0)}})),...eg.joint.map(k=>m(F,I,k)),T("td",{},T("button",{type:"button",class:"type",text:F.sign>0?"+":"\u2212","aria-label":`Joint ${I+1}, sense of the maker: ${F.sign>0?"as the table":"against the table"}`,on:{click:()=>Ha(N.table.joints.map((k,X)=>X===I?{...k,sign:-k.sign}:k),N.q)}}))];return T("tr",{"data-testid":`dh-row-${I+1}`},T("th",{scope:"row",text:String(I+1)}),T("td",{},p(F,I)),D,y(I,S.length))})),S.length||s.append(T("tr",{},T("td",{colspan:"7",class:"hint",text:"No joints yet."}))),v()},v=()=>{for(let{f:S,i:x,key:M}of e){let F=N.table.joints[x];S.put(F[M],F.text?.[M]??null)}l.mark(N.table.convention),Ot(c,N.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==h&&(h.value=N.table.name),g.show(),_.show()},C=()=>{f.disabled=!Rg(),u.disabled=!Cg()};yt("table",S=>{Ot(o,""),S==="cell"||S==="name"||S==="postures"?v():(Jv(),w())}),yt("units",w),yt("notation",()=>{g.show(),_.show()}),yt("history",C),yt("plan",()=>{a.dataset.tone=N.plan?.solvable?"good":"wrong",ee(a,T("strong",{text:Nc(N.plan)||(N.plan?.refused?"Refused":"Not solved")})," ",T("span",{text:N.plan?.explain??""}))}),C(),w()}};function GC(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var VC=4,WC=n=>{let t=n.toFixed(VC);return Number(t)<0?`(${t})`:t.replace("-","")};function Vf(n,t,e){let i=t.joints.map((l,c)=>jr(l,e[c])),s=l=>l.reduce((c,[h,f])=>c+f*i[h-1].theta,0),r={cos:l=>Math.cos(s(l)),sin:l=>Math.sin(s(l)),slide:([[l]])=>i[l-1].d};return n.symbols.reduce((l,c)=>l.replaceAll(c.latex,WC(r[c.is](c.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Wf=null;async function XC(){return Wf??=(await import("./katex-OJEVB6AI.js")).default,Wf}function qC(n,t){let e=T("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function Qv(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>qC(n,i)],[i=>"code"in i,i=>T("code",{text:i.code})],[()=>!0,i=>T("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var YC=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function $C(n){let t=N.table.joints.map((e,i)=>T("th",{},T("i",{text:"q"}),T("sub",{text:String(i+1)}),T("span",{class:"unit",text:` ${Ct.symbol(je(e))}`})));return[T("h3",{text:"The formulas at the present pose"}),T("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},T("thead",{},T("tr",{},T("th",{text:"branch"}),t)),T("tbody",{},n.map((e,i)=>T("tr",{},T("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>T("td",{text:Si(s,je(N.table.joints[r]))}))))))]}var tb={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=T("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=T("div",{class:"equations","data-testid":"equations"}),c=bn("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,_()},"equation-numbers"),h=T("div",{class:"scroll"});n.append(T("div",{class:"line spread"},T("span",{class:"line"},bn("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,_()},"which-equations"),c),T("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>Kr(d())}})),a,h,l);let f=v=>v.symbols&&i==="present"?Vf(v,N.table,N.q):v.latex,u=v=>v.number===void 0?"":` \\tag{${v.number}}`,d=()=>o.map(v=>v.kind==="equation"?`\\[ ${f(v)}${u(v)} \\]`:YC(v.pieces)).join(`

`);function g(v){r=[],ee(l,o.map(C=>m(v,C))),p()}async function _(){if(t.hidden||!N.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(N.table.joints)}${N.table.convention}`;if(s!==v){s=v,Ot(a,"Deriving \u2026"),ee(l);try{let[C,S]=await Promise.all([XC(),Qn("equations",{which:e,numbers:i==="symbols"?i:"numbers"},x=>Ot(a,x.note??""))]);if(s!==v)return;Ot(a,S.note??""),o=S.blocks,g(C),c.hidden=e!=="forward",ee(h),y()}catch(C){if(s!==v)return;s=null,Ot(a,C.message)}}}function m(v,C){if(C.kind==="heading"||C.kind==="step")return T("h3",{},Qv(v,C.pieces));if(C.kind!=="equation")return T("p",{class:"prose"},Qv(v,C.pieces));let S=T("div",{class:"formula"});try{v.render(f(C),S,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{S.replaceChildren(T("code",{text:f(C)}))}if(C.number!==void 0)return T("div",{class:"formula-row numbered"},S,T("span",{class:"hint",text:`(${C.number})`}));if(C.entry===void 0)return S;let x=T("output",{class:"value","data-entry":String(C.entry)});return r.push({value:x,entry:C.entry}),T("div",{class:"formula-row"},S,x)}let p=Er(()=>{if(t.hidden)return;let v=N.frames[N.frames.length-1];for(let{value:C,entry:S}of r)Ot(C,`= ${S%4===3?`${jn(v[S]*Ct.factor("length"),Ct.digits("length"))} ${Ct.length}`:jn(v[S],4)}`)}),y=js(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:v}=await Qn("formulas",{T:N.frames.at(-1)});ee(h,v.length&&e==="inverse"?$C(v):null)}catch{ee(h)}},250),w=js(()=>{!t.hidden&&Wf&&o.length&&e==="forward"&&i==="present"&&g(Wf)},120);yt("q",w),yt("panel",w),yt("q",y),yt("units",y),yt("panel",_),yt("plan",_),yt(["q","units"],p)}};var dc=()=>N.frames[N.frames.length-1].slice(),eb={id:"path",title:"Path",wide:!0,build(n,t){let e=N.path,i=["from","to"].map(m=>{let p=Ao(m==="from"?"From":"To",`path-${m}`,()=>e[m],v=>{e[m]=v,f(),ie("path")}),y=T("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`take-${m}`,on:{click:()=>{e[m]=dc(),p.show(),f(),ie("path")}}});return{el:T("div",{class:"end"},y,p.el),show:p.show}}),s=T("span",{class:"hint"}),r=Ri({label:"Number of points N",testid:"path-n",check:m=>Number.isInteger(m)&&m>=2&&m<=2e3?null:"a whole number from 2 to 2000",input:m=>{e.n=m}}),o=Ri({label:"Seconds for the whole line",testid:"path-seconds",check:m=>m>0&&m<=3600?null:"more than 0, at most 3600",input:m=>{e.seconds=m}}),a=T("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let m=Xe(e.to);e.to=e.from.slice(),[3,7,11].forEach((p,y)=>{e.to[p]=m[y]}),i[1].show(),f()}}}}),l=T("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>u(N.q)}}),c=T("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),h=T("div",{class:"branches","data-testid":"branches"});n.append(...i.map(m=>m.el),T("div",{class:"line"},a,s),T("div",{class:"line"},T("label",{class:"field"},T("span",{class:"field-name",text:"Points N"}),r),T("label",{class:"field"},T("span",{class:"field-name",text:"Seconds"}),o),l,T("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,h);let f=()=>{if(!e.from||!e.to){Ot(s,"");return}let m=wg(e.from,e.to);Ot(s,`${mn(Rs(ss(Xe(e.to),Xe(e.from))),"length")} long${m>1e-6?`, turning ${mn(m,"angle")}`:", orientation kept"}`),nf(Array.from({length:33},(p,y)=>Xe(Xx(e.from,e.to,y/32))))};async function u(m){Ot(l,"Planning \u2026"),l.disabled=!0;try{let p=await Qn("follow",{T0:e.from,T1:e.to,n:e.n,start:m});N.track=p,d(p,m)}catch(p){c.hidden=!1,c.dataset.tone="wrong",Ot(c,p.message)}finally{Ot(l,"Plan the line"),l.disabled=!1}}function d(m){if(c.hidden=!1,c.dataset.tone=m.complete?"good":"wrong",Ot(c,m.explain),ee(h,m.branches.length?T("h3",{text:"Branches that start at the first pose"}):null,m.branches.map((v,C)=>T("button",{type:"button",class:`branch ${C===m.chosen?"chosen":""}`,"aria-pressed":String(C===m.chosen),"data-testid":`branch-${C+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await vs(v.q,.4),u(v.q)}}},T("span",{class:"branch-name",text:`${C+1}  ${v.label}`}),g(v.s),T("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),nf(m.path.map(Xe)),!m.q.length){To(null);return}let p=m.path.length,y=m.q.map((v,C)=>C+1),w=m.q.map((v,C)=>p>1?e.seconds*C/(p-1):0);To(Lf({table:N.table,q:m.q,xs:y,xName:"point",xEnd:p,seconds:w,title:`${N.table.name}: straight line, ${m.q.length} of ${p} points`,events:m.events.map(v=>({...v,x:1+v.s*(p-1),short:v.cause}))}))}function g(m){let p=T("span",{class:"bar-fill"});return p.style.setProperty("width",`${100*m}%`),T("span",{class:"bar"},p)}let _=()=>{i.forEach(m=>m.show()),r.put(e.n),o.put(e.seconds),f()};yt("panel",m=>{m==="path"&&(e.from??=dc(),e.to??=dc(),_())}),yt("path-loaded",_),yt("notation",_),yt("units",f),yt("table",m=>{m==="postures"||m==="name"||(c.hidden=!0,ee(h),nf([]),m==="new"&&(e.from=null,e.to=null,t.hidden||(e.from=dc(),e.to=dc(),_())))})}};var ZC=40,nb={id:"sequence",title:"Sequence",wide:!0,build(n){let t=N.sequence,e=T("thead"),i=T("tbody"),s=T("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=T("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:c}}),o=T("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let h=t.postures[1];if(h){for(let f of t.postures.slice(2))f.seconds=h.seconds,f.hold=h.hold;l()}}}});n.append(T("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),T("div",{class:"scroll"},T("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),T("div",{class:"line"},T("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(N.q.slice())}}),T("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(N.table.postures??{}).forEach(([h,f])=>a(f.slice(),h))}}),o),T("div",{class:"line"},r),s);function a(h,f){t.postures.length>=ZC||(t.postures.push({name:f??`P${t.postures.length}`,q:h,seconds:5,hold:0}),l(),ie("sequence"))}function l(){let h=N.table.joints;t.postures=t.postures.filter(f=>f.q.length===h.length),r.disabled=t.postures.length<2,ee(e,T("tr",{},T("th",{text:""}),h.map((f,u)=>T("th",{},T("i",{text:"q"}),T("sub",{text:String(u+1)}),T("span",{class:"unit",text:` ${Ct.symbol(je(f))}`}))),T("th",{text:"leg, s"}),T("th",{text:"rest, s"}),T("th",{"aria-label":"row tools"}))),ee(i,t.postures.map((f,u)=>{let d=h.map((_,m)=>{let p=Ri({label:`${f.name}, q${m+1}`,kind:je(_),testid:`seq-${u}-q${m+1}`,input:y=>{f.q[m]=y,ie("sequence")}});return p.put(f.q[m],String(Number((f.q[m]*Ct.factor(je(_))).toFixed(Ct.digits(je(_))))+0)),T("td",{},p)}),g=(_,m,p)=>{if(u===0)return T("td");let y=Ri({label:`${m} ${f.name}`,testid:`seq-${u}-${_}`,check:p,input:w=>{f[_]=w,ie("sequence")}});return y.put(f[_]),T("td",{},y)};return T("tr",{"data-testid":`seq-row-${u}`},T("th",{scope:"row"},T("button",{type:"button",class:"quiet",text:f.name,title:"Go there",on:{click:()=>vs(f.q.slice())}})),d,g("seconds","Seconds to",_=>_>0?null:"more than 0"),g("hold","Rest after",_=>_>=0?null:"0 or more"),T("td",{class:"tools"},T("button",{type:"button",class:"icon",text:"\u2191",disabled:u===0,"aria-label":`Move ${f.name} up`,on:{click:()=>{t.postures.splice(u-1,0,...t.postures.splice(u,1)),l()}}}),T("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${f.name}`,on:{click:()=>{t.postures.splice(u,1),l(),ie("sequence")}}})))})),t.postures.length||i.append(T("tr",{},T("td",{class:"hint",colspan:String(h.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function c(){r.disabled=!0,s.hidden=!1;try{let h=t.postures,f=await Qn("motion",{postures:h.map(d=>d.q),seconds:h.slice(1).map(d=>d.seconds),holds:h.slice(1).map(d=>d.hold),rate:t.rate}),u=h.map((d,g)=>({x:f.arrivals[g],s:0,text:`${d.name} at ${f.arrivals[g].toFixed(2)} s`,short:d.name,stop:!1}));s.dataset.tone="good",Ot(s,`${h.length} postures in ${f.t[f.t.length-1].toFixed(2)} s. ${JC(f.q)}`),To(Lf({table:N.table,q:f.q,xs:f.t,xName:"time",seconds:f.t,dq:f.dq,events:u,title:`${N.table.name}: ${h.map(d=>d.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",Ot(s,h.message)}finally{r.disabled=t.postures.length<2}}yt(["table","units","sequence-loaded"],l),l()}};function JC(n){let t=N.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var Xf=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new Qt(n)),ng=new Ir({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Ci=new ro(new Ce,ng);Ci.frustumCulled=!1;Ci.visible=!1;oi.add(Ci);var Ga=null,pc=null,Pi=0,qr={lo:0,hi:1};function ib(n){Ga=new Float32Array(3*n),pc=new Float32Array(n),Pi=0,Ci.geometry.dispose(),Ci.geometry=new Ce,Ci.geometry.setAttribute("position",new sn(Ga,3)),Ci.geometry.setAttribute("color",new sn(new Float32Array(3*n),3)),Ci.geometry.setDrawRange(0,0),Ci.visible=!0,rn()}function sb(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Pi<pc.length;i+=4,Pi++)Ga.set(e.subarray(i,i+3),3*Pi),pc[Pi]=e[i+3];jC()}function jC(){let n=pc.slice(0,Pi).sort();qr.lo=n[Math.floor(Pi*.02)]??0,qr.hi=n[Math.max(Math.ceil(Pi*.98)-1,0)]??1;let t=new Qt,e=Ci.geometry.attributes.color.array,i=qr.hi-qr.lo||1;for(let s=0;s<Pi;s++){let r=Math.min(Math.max((pc[s]-qr.lo)/i,0),1)*(Xf.length-1),o=Math.min(Math.floor(r),Xf.length-2);t.lerpColors(Xf[o],Xf[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Ci.geometry.setDrawRange(0,Pi),Ci.geometry.attributes.position.needsUpdate=!0,Ci.geometry.attributes.color.needsUpdate=!0,rn()}var mc=()=>Pi;function rb(n){ji.localClippingEnabled=n!==null,ng.clippingPlanes=n===null?null:[new gi(new B(0,1,0),-n)],ng.needsUpdate=!0,rn()}function ob(){let n=new wi;for(let i=0;i<Pi;i++)n.expandByPoint(new B(Ga[3*i],Ga[3*i+1],Ga[3*i+2]));let{min:t,max:e}=n;return Pi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function ab(){Pi=0,Ci.visible=!1,rn()}var cb=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],qf=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?jn(n,4):n.toExponential(2).replace("-","\u2212"),hb={id:"analysis",title:"Analysis",build(n){let t=T("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[l,c,h]of e)t.append(T("div",{title:h},T("dt",{text:c}),i[l]=T("dd",{"data-testid":`fact-${l}`})));let s=T("div",{class:"distances","data-testid":"limit-distances"}),r=[];n.append(t,T("h3",{text:"Distance to the limits"}),s,T("h3",{text:"Reachable points"}),KC());let o=()=>{r=N.table.joints.map((l,c)=>{let h=T("span",{class:"bar-fill"}),f=T("span",{class:"bar-text"});return{el:T("div",{class:"distance"},T("span",{},T("i",{text:"q"}),T("sub",{text:String(c+1)})),T("span",{class:"bar"},h),f),fill:h,text:f}}),ee(s,r.map(l=>l.el)),a()},a=Er(()=>{if(n.closest(".panel").hidden||!N.table.joints.length)return;let l=wc(N.table,N.q,N.frames),c=l[0],h=l[l.length-1];Ot(i.manipulability,qf(l.reduce((f,u)=>f*u,1))),Ot(i.condition,c>1e-9?jn(h/c,1):"\u221E"),Ot(i.least,qf(c)),t.dataset.tone=c<.02?"wrong":"good",r.forEach(({el:f,fill:u,text:d},g)=>{let _=N.table.joints[g],m=N.q[g];if(_.lower===null||_.upper===null){u.style.setProperty("width","100%"),Ot(d,"no limit");return}let p=Math.min(m-_.lower,_.upper-m),y=Math.max(2*p/(_.upper-_.lower||1),0);u.style.setProperty("width",`${100*y}%`),f.classList.toggle("outside",p<-1e-9),Ot(d,p<-1e-9?`${mn(-p,je(_))} beyond`:mn(p,je(_)))})});yt("table",o),yt(["q","units","panel"],a),o()}};function KC(){let n="20000",t="manipulability",e=!1,i=T("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Js("cancel",{kind:"cloud"}):u()}}),s=T("button",{type:"button",text:"Clear",on:{click:f}}),r=bn("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",d=>rb(d==="half"?N.table.base[7]:null),"cloud-cut"),o=T("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=T("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=T("span"),c=T("span"),h=T("div",{class:"legend-scale",hidden:!0},l,T("span",{class:"scale-bar"}),c);function f(){ab(),Ta("cloud",[]),h.hidden=!0,Ot(a,"")}async function u(){e=!0,Ot(i,"Cancel"),o.hidden=!1,o.value=0,h.hidden=!1,ib(Number(n));try{let d=await Qn("cloud",{count:Number(n),colour:t,seed:1},g=>{sb(g.points),o.value=g.done/g.of,Ot(l,qf(qr.lo)),Ot(c,qf(qr.hi)),Ot(a,`${g.done.toLocaleString("en")} of ${g.of.toLocaleString("en")} points`)});Ot(a,d.stopped?`Cancelled after ${mc().toLocaleString("en")} points.`:`${d.done.toLocaleString("en")} random postures inside the limits, coloured by ${cb.find(([g])=>g===t)[1]}${t==="height"?" (m)":""}.`)}catch(d){Ot(a,d.message)}e=!1,Ta("cloud",ob()),Hr(),Ot(i,"Draw the cloud"),o.hidden=!0}return yt("table",d=>{d!=="postures"&&d!=="name"&&mc()&&f()}),T("div",{},T("div",{class:"line"},di("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,d=>{n=d},{"data-testid":"cloud-count"}),T("span",{class:"field-name",text:"coloured by"}),di("Coloured by",cb,t,d=>{t=d},{"data-testid":"cloud-colour"})),T("div",{class:"line"},i,s,r),o,h,a)}var ub=n=>({id:"share",title:"Share",build(t,e){let i=T("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:h=>h.target.select()}}),s=T("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>c(s)}}),r=T("p",{class:"hint",role:"status","data-testid":"report-note"}),o=T("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:l}});t.append(T("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),T("div",{class:"line share-link"},i,T("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>Kr(await pf())}})),T("h3",{text:"As a file"}),T("div",{class:"line"},T("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>Ks(`${N.table.name||"arm"}.workbench.json`,JSON.stringify(dm(),null,1),"application/json")}}),T("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,T("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:Gf}})),T("h3",{text:"Report"}),T("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),T("div",{class:"line"},o),r),yt(["panel","table","q","units","notation"],async()=>{!e.hidden&&N.table.joints.length&&(i.value=await pf())});async function l(){o.disabled=!0;try{let{html:h,name:f}=await Qn("report",{q:N.q},u=>Ot(r,u.note));Ks(f,h,"text/html"),Ot(r,`Written: ${f}, ${Math.round(h.length/1024)} kB.`)}catch(h){Ot(r,h.message)}finally{o.disabled=!1}}async function c(h){let f=h.files[0];if(h.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");df(JSON.parse(await f.text()),n()),ni("Opened")}catch(u){ni(u instanceof SyntaxError?`${f.name} is not a state file.`:u.message,"wrong")}}}});function fb(){window.workbench=Object.freeze({get q(){return N.q.slice()},get frames(){return structuredClone(N.frames)},get target(){return N.target.slice()},get table(){return structuredClone(N.table)},get solutions(){return structuredClone(N.solutions)},get camera(){return Gu()},get pictures(){return j_()},get ghosts(){return Sx()},get answers(){return am.answers},get trace(){return Tx()},get cloud(){return mc()},toScreen:nx,forward:(n,t)=>Mr(n,t),convert:(n,t)=>kf(n,t),read:(n,t)=>If(n,t),present:(n,t,e)=>Vf(n,t,e)})}Lc();K_(wr("#view"));yt("theme",Vp);Vp();xx();Ux();Ug();Vx();Nv(wr("#bar"));Fv(wr("#overlay"));Dv(wr("#dock"));Ov();var ig;ig=Uv(wr("#rail"),wr("#panels"),wr("#pinned"),[{id:"move",title:"Move",sections:[Rv,kv]},qv,Kv,zv,tb,eb,nb,hb,ub(()=>ig)]);jx();var QC=Jx().then(n=>n&&df(n,ig)).catch(n=>ni(`The link could not be read: ${n.message}`,"wrong"));yt("online",async n=>{if(!n)return;await QC;let t=await Pg();N.catalog=t.catalog,ie("catalog"),t.table&&!N.table.joints.length&&(Fn(t.table,{q:zo(t.table),step:!1,what:"new"}),Rc()),document.documentElement.dataset.ready="yes"});N.online&&ie("online",!0);document.fonts?.ready.then(()=>ie("theme"));fb();
