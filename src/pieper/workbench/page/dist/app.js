import{A as nu,B as jo,C as un,D as P0,E as pi,F as I0,G as iu,I as gs,J as Jo,a as er,b as zi,c as Jc,d as oe,e as ks,f as gl,g as Ai,h as _l,i as Kc,j as ts,k as Qc,l as tu,m as T0,n as co,o as uo,p as A0,q as ms,r as kf,s as Ri,t as eu,u as R0,v as C0,w as ct,x as xt,y as E,z as Ci}from"./chunk-ULOXO7YQ.js";function S(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Pr=(n,t=document)=>t.querySelector(n),Zt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function Et(n,t){n.textContent!==t&&(n.textContent=t)}function xn(n,t,e,i,s){let r=S("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let c of r.children)c.setAttribute("aria-pressed",String(c.dataset.value===a))};for(let[a,c]of t)r.append(S("button",{type:"button",text:c,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function yn(n,t,e,i,s={}){let r=S("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>S("option",{value:o,text:a})));return r.value=e,r}function Ir(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Ko(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function zs(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function es(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=S("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function Lr(n){try{await navigator.clipboard.writeText(n)}catch{let t=S("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}vn("Copied")}var L0;function vn(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(L0),L0=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function Qo(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var ta=0,Gf=-1,zf=[];function Vf(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Hf(){let n=ta;if(!E.table.joints.length){E.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},xt("plan");return}try{let{plan:t}=await gs("arm",{table:Vf(E.table)});if(n!==ta)return;Gf=n,E.plan=t,D0()}catch(t){if(n!==ta||t instanceof iu)return;E.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},D0(t)}xt("plan")}function D0(n){let t=zf;zf=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var N0=zs(Hf,60);function U0(){ct("table",n=>{ta+=1,n==="postures"&&(Gf=-1),n==="cell"?N0():(N0.cancel(),Hf())}),ct("online",n=>{n&&(ta+=1,Hf())})}function _M(){return Gf===ta?Promise.resolve():new Promise((n,t)=>zf.push({resolve:n,reject:t}))}async function En(n,t,e){return await _M(),gs(n,t,e)}function F0(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function su(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var Wr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},qr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},x_=0,yp=1,y_=2;var sc=1,v_=2,La=3,$r=0,Si=1,os=2,bo=0,Da=1,vp=2,bp=3,Sp=4,b_=5;var So=100,S_=101,M_=102,w_=103,E_=104,T_=200,A_=201,R_=202,C_=203,Mp=204,wp=205,P_=206,I_=207,L_=208,D_=209,N_=210,U_=211,F_=212,O_=213,B_=214,Uu=0,Fu=1,Ou=2,va=3,Bu=4,ku=5,zu=6,Hu=7,Ep=0,k_=1,z_=2,qs=0,Tp=1,Ap=2,Rp=3,Cp=4,Pp=5,Ip=6,Lp=7;var Dp=300,Mo=301,Na=302,fh=303,ph=304,Gu=1e3,Gs=1001,Vu=1002,Kn=1003,H_=1004;var rc=1005;var xi=1006,mh=1007;var dr=1008;var $i=1009,Np=1010,Up=1011,Ua=1012,gh=1013,Ss=1014,as=1015,Ms=1016,_h=1017,xh=1018,wo=1020,Fp=35902,Op=35899,Bp=1021,kp=1022,ws=1023,cr=1026,fr=1027,yh=1028,vh=1029,Xr=1030,bh=1031;var Sh=1033,oc=33776,ac=33777,lc=33778,cc=33779,Mh=35840,wh=35841,Eh=35842,Th=35843,Ah=36196,Rh=37492,Ch=37496,Ph=37488,Ih=37489,uc=37490,Lh=37491,Dh=37808,Nh=37809,Uh=37810,Fh=37811,Oh=37812,Bh=37813,kh=37814,zh=37815,Hh=37816,Gh=37817,Vh=37818,Wh=37819,qh=37820,$h=37821,Xh=36492,Yh=36494,Zh=36495,jh=36283,Jh=36284,hc=36285,Kh=36286;var Il=2300,Wu=2301,Du=2302,hp=2303,dp=2400,fp=2401,pp=2402;var G_=3200;var zp=0,V_=1,pr="",gi="srgb",Ll="srgb-linear",Dl="linear",Be="srgb";var Nu=7680,Hp=7681;var Gp=517;var W_=519,q_=512,$_=513,X_=514,Vp=515,Y_=516,Z_=517,Wp=518,qp=519,$p=35044,Qh=35048;var Xp="300 es",is=2e3,Nl=2001;function yM(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function vM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ul(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function j_(){let n=Ul("canvas");return n.style.display="block",n}var O0={},ba=null;function Fl(...n){let t="THREE."+n.shift();ba?ba("log",t,...n):console.log(t,...n)}function J_(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Qt(...n){n=J_(n);let t="THREE."+n.shift();if(ba)ba("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ie(...n){n=J_(n);let t="THREE."+n.shift();if(ba)ba("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Rl(...n){let t=n.join(" ");t in O0||(O0[t]=!0,Qt(...n))}function K_(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Q_={[Uu]:Uu,[Ou]:zu,[Bu]:Bu,[va]:ku,[Fu]:Fu,[zu]:Ou,[Hu]:Hu,[ku]:va},vs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},si=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],B0=1234567,Cl=Math.PI/180,Sa=180/Math.PI;function Yr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(si[n&255]+si[n>>8&255]+si[n>>16&255]+si[n>>24&255]+"-"+si[t&255]+si[t>>8&255]+"-"+si[t>>16&15|64]+si[t>>24&255]+"-"+si[e&63|128]+si[e>>8&255]+"-"+si[e>>16&255]+si[e>>24&255]+si[i&255]+si[i>>8&255]+si[i>>16&255]+si[i>>24&255]).toLowerCase()}function ve(n,t,e){return Math.max(t,Math.min(e,n))}function Yp(n,t){return(n%t+t)%t}function bM(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function SM(n,t,e){return n!==t?(e-n)/(t-n):0}function Pl(n,t,e){return(1-e)*n+e*t}function MM(n,t,e,i){return Pl(n,t,1-Math.exp(-e*i))}function wM(n,t=1){return t-Math.abs(Yp(n,t*2)-t)}function EM(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function TM(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function AM(n,t){return n+Math.floor(Math.random()*(t-n+1))}function RM(n,t){return n+Math.random()*(t-n)}function CM(n){return n*(.5-Math.random())}function PM(n){n!==void 0&&(B0=n);let t=B0+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function IM(n){return n*Cl}function LM(n){return n*Sa}function DM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function NM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Zp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function UM(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*u,c*h,c*d,a*l);break;case"YZY":n.set(c*d,a*u,c*h,a*l);break;case"ZXZ":n.set(c*h,c*d,a*u,a*l);break;case"XZX":n.set(a*u,c*g,c*f,a*l);break;case"YXY":n.set(c*f,a*u,c*g,a*l);break;case"ZYZ":n.set(c*g,c*f,a*u,a*l);break;default:Qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function td(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jp(n,t){if(t.constructor===Float32Array)return n;let e=td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Jp(n,t){if(t.constructor===Float32Array)return n;let e=td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Zr={DEG2RAD:Cl,RAD2DEG:Sa,generateUUID:Yr,clamp:ve,euclideanModulo:Yp,mapLinear:bM,inverseLerp:SM,lerp:Pl,damp:MM,pingpong:wM,smoothstep:EM,smootherstep:TM,randInt:AM,randFloat:RM,randFloatSpread:CM,seededRandom:PM,degToRad:IM,radToDeg:LM,isPowerOfTwo:DM,ceilPowerOfTwo:NM,floorPowerOfTwo:Zp,setQuaternionFromProperEuler:UM,normalize:Jp,denormalize:jp},qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ve(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ve(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},on=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(h!==y||c!==d||l!==f||u!==g){let p=c*d+l*f+u*g+h*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let x=Math.acos(p),w=Math.sin(x);m=Math.sin(m*x)/w,a=Math.sin(a*x)/w,c=c*m+d*a,l=l*m+f*a,u=u*m+g*a,h=h*m+y*a}else{c=c*m+d*a,l=l*m+f*a,u=u*m+g*a,h=h*m+y*a;let x=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=x,l*=x,u*=x,h*=x}}t[e]=c,t[e+1]=l,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+u*h+c*f-l*d,t[e+1]=c*g+u*d+l*h-a*f,t[e+2]=l*g+u*f+a*d-c*h,t[e+3]=u*g-a*h-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),u=a(s/2),h=a(r/2),d=c(i/2),f=c(s/2),g=c(r/2);switch(o){case"XYZ":this._x=d*u*h+l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h+d*f*g;break;case"YZX":this._x=d*u*h+l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h-d*f*g;break;case"XZY":this._x=d*u*h-l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h+d*f*g;break;default:Qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,u=e._w;return this._x=i*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-i*l,this._z=r*u+o*l+i*c-s*a,this._w=o*u-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,e=Math.sin(e*l)/u,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},k=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(k0.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(k0.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+c*l+o*h-a*u,this.y=i+c*u+a*l-r*h,this.z=s+c*h+r*u-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ve(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Wf.copy(this).projectOnVector(t),this.sub(Wf)}reflect(t){return this.sub(Wf.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ve(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Wf=new k,k0=new on,ce=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=c,u[6]=i,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],u=i[4],h=i[7],d=i[2],f=i[5],g=i[8],y=s[0],p=s[3],m=s[6],x=s[1],w=s[4],v=s[7],A=s[2],T=s[5],_=s[8];return r[0]=o*y+a*x+c*A,r[3]=o*p+a*w+c*T,r[6]=o*m+a*v+c*_,r[1]=l*y+u*x+h*A,r[4]=l*p+u*w+h*T,r[7]=l*m+u*v+h*_,r[2]=d*y+f*x+g*A,r[5]=d*p+f*w+g*T,r[8]=d*m+f*v+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8];return e*o*u-e*a*l-i*r*u+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=u*o-a*l,d=a*c-u*r,f=l*r-o*c,g=e*h+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=h*y,t[1]=(s*l-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(u*e-s*c)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*c-l*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Rl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(qf.makeScale(t,e)),this}rotate(t){return Rl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(qf.makeRotation(-t)),this}translate(t,e){return Rl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(qf.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},qf=new ce,z0=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),H0=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function FM(){let n={enabled:!0,workingColorSpace:Ll,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Be&&(s.r=lr(s.r),s.g=lr(s.g),s.b=lr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Be&&(s.r=ya(s.r),s.g=ya(s.g),s.b=ya(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===pr?Dl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ll]:{primaries:t,whitePoint:i,transfer:Dl,toXYZ:z0,fromXYZ:H0,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:gi},outputColorSpaceConfig:{drawingBufferColorSpace:gi}},[gi]:{primaries:t,whitePoint:i,transfer:Be,toXYZ:z0,fromXYZ:H0,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:gi}}}),n}var Te=FM();function lr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ya(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ea,qu=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ea===void 0&&(ea=Ul("canvas")),ea.width=t.width,ea.height=t.height;let s=ea.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=ea}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ul("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=lr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(lr(e[i]/255)*255):e[i]=lr(e[i]);return{data:e,width:t.width,height:t.height}}else return Qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},OM=0,Ma=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:OM++}),this.uuid=Yr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push($f(s[o].image)):r.push($f(s[o]))}else r=$f(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function $f(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?qu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Qt("Texture: Unable to serialize Texture."),{})}var BM=0,Xf=new k,yi=class n extends vs{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Gs,s=Gs,r=xi,o=dr,a=ws,c=$i,l=n.DEFAULT_ANISOTROPY,u=pr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:BM++}),this.uuid=Yr(),this.name="",this.source=new Ma(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new qt(0,0),this.repeat=new qt(1,1),this.center=new qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Xf).x}get height(){return this.source.getSize(Xf).y}get depth(){return this.source.getSize(Xf).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Dp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Gu:t.x=t.x-Math.floor(t.x);break;case Gs:t.x=t.x<0?0:1;break;case Vu:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Gu:t.y=t.y-Math.floor(t.y);break;case Gs:t.y=t.y<0?0:1;break;case Vu:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};yi.DEFAULT_IMAGE=null;yi.DEFAULT_MAPPING=Dp;yi.DEFAULT_ANISOTROPY=1;var dn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],u=c[4],h=c[8],d=c[1],f=c[5],g=c[9],y=c[2],p=c[6],m=c[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(g+p)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(l+1)/2,v=(f+1)/2,A=(m+1)/2,T=(u+d)/4,_=(h+y)/4,b=(g+p)/4;return w>v&&w>A?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=T/i,r=_/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=T/s,r=b/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=b/r),this.set(i,s,r,e),this}let x=Math.sqrt((p-g)*(p-g)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(h-y)/x,this.z=(d-u)/x,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ve(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},$u=class extends vs{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new dn(0,0,t,e),this.scissorTest=!1,this.viewport=new dn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new yi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:xi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ma(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Vi=class extends $u{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Ol=class extends yi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Kn,this.minFilter=Kn,this.wrapR=Gs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Xu=class extends yi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Kn,this.minFilter=Kn,this.wrapR=Gs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var be=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,c,l,u,h,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,u,h,d,f,g,y,p)}set(t,e,i,s,r,o,a,c,l,u,h,d,f,g,y,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/na.setFromMatrixColumn(t,0).length(),r=1/na.setFromMatrixColumn(t,1).length(),o=1/na.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,g=a*u,y=a*h;e[0]=c*u,e[4]=-c*h,e[8]=l,e[1]=f+g*l,e[5]=d-y*l,e[9]=-a*c,e[2]=y-d*l,e[6]=g+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*u,f=c*h,g=l*u,y=l*h;e[0]=d+y*a,e[4]=g*a-f,e[8]=o*l,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-g,e[6]=y+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*u,f=c*h,g=l*u,y=l*h;e[0]=d-y*a,e[4]=-o*h,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*u,e[9]=y-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*u,f=o*h,g=a*u,y=a*h;e[0]=c*u,e[4]=g*l-f,e[8]=d*l+y,e[1]=c*h,e[5]=y*l+d,e[9]=f*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,g=a*c,y=a*l;e[0]=c*u,e[4]=y-d*h,e[8]=g*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-l*u,e[6]=f*h+g,e[10]=d-y*h}else if(t.order==="XZY"){let d=o*c,f=o*l,g=a*c,y=a*l;e[0]=c*u,e[4]=-h,e[8]=l*u,e[1]=d*h+y,e[5]=o*u,e[9]=f*h-g,e[2]=g*h-f,e[6]=a*u,e[10]=y*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(kM,t,zM)}lookAt(t,e,i){let s=this.elements;return Hi.subVectors(t,e),Hi.lengthSq()===0&&(Hi.z=1),Hi.normalize(),Dr.crossVectors(i,Hi),Dr.lengthSq()===0&&(Math.abs(i.z)===1?Hi.x+=1e-4:Hi.z+=1e-4,Hi.normalize(),Dr.crossVectors(i,Hi)),Dr.normalize(),ru.crossVectors(Hi,Dr),s[0]=Dr.x,s[4]=ru.x,s[8]=Hi.x,s[1]=Dr.y,s[5]=ru.y,s[9]=Hi.y,s[2]=Dr.z,s[6]=ru.z,s[10]=Hi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],u=i[1],h=i[5],d=i[9],f=i[13],g=i[2],y=i[6],p=i[10],m=i[14],x=i[3],w=i[7],v=i[11],A=i[15],T=s[0],_=s[4],b=s[8],L=s[12],I=s[1],D=s[5],B=s[9],V=s[13],O=s[2],$=s[6],Z=s[10],q=s[14],ht=s[3],K=s[7],tt=s[11],rt=s[15];return r[0]=o*T+a*I+c*O+l*ht,r[4]=o*_+a*D+c*$+l*K,r[8]=o*b+a*B+c*Z+l*tt,r[12]=o*L+a*V+c*q+l*rt,r[1]=u*T+h*I+d*O+f*ht,r[5]=u*_+h*D+d*$+f*K,r[9]=u*b+h*B+d*Z+f*tt,r[13]=u*L+h*V+d*q+f*rt,r[2]=g*T+y*I+p*O+m*ht,r[6]=g*_+y*D+p*$+m*K,r[10]=g*b+y*B+p*Z+m*tt,r[14]=g*L+y*V+p*q+m*rt,r[3]=x*T+w*I+v*O+A*ht,r[7]=x*_+w*D+v*$+A*K,r[11]=x*b+w*B+v*Z+A*tt,r[15]=x*L+w*V+v*q+A*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],u=t[2],h=t[6],d=t[10],f=t[14],g=t[3],y=t[7],p=t[11],m=t[15],x=c*f-l*d,w=a*f-l*h,v=a*d-c*h,A=o*f-l*u,T=o*d-c*u,_=o*h-a*u;return e*(y*x-p*w+m*v)-i*(g*x-p*A+m*T)+s*(g*w-y*A+m*_)-r*(g*v-y*T+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],u=t[10];return e*(o*u-a*l)-i*(r*u-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],u=t[8],h=t[9],d=t[10],f=t[11],g=t[12],y=t[13],p=t[14],m=t[15],x=e*a-i*o,w=e*c-s*o,v=e*l-r*o,A=i*c-s*a,T=i*l-r*a,_=s*l-r*c,b=u*y-h*g,L=u*p-d*g,I=u*m-f*g,D=h*p-d*y,B=h*m-f*y,V=d*m-f*p,O=x*V-w*B+v*D+A*I-T*L+_*b;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let $=1/O;return t[0]=(a*V-c*B+l*D)*$,t[1]=(s*B-i*V-r*D)*$,t[2]=(y*_-p*T+m*A)*$,t[3]=(d*T-h*_-f*A)*$,t[4]=(c*I-o*V-l*L)*$,t[5]=(e*V-s*I+r*L)*$,t[6]=(p*v-g*_-m*w)*$,t[7]=(u*_-d*v+f*w)*$,t[8]=(o*B-a*I+l*b)*$,t[9]=(i*I-e*B-r*b)*$,t[10]=(g*T-y*v+m*x)*$,t[11]=(h*v-u*T-f*x)*$,t[12]=(a*L-o*D-c*b)*$,t[13]=(e*D-i*L+s*b)*$,t[14]=(y*w-g*A-p*x)*$,t[15]=(u*A-h*w+d*x)*$,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,u=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+i,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,u=o+o,h=a+a,d=r*l,f=r*u,g=r*h,y=o*u,p=o*h,m=a*h,x=c*l,w=c*u,v=c*h,A=i.x,T=i.y,_=i.z;return s[0]=(1-(y+m))*A,s[1]=(f+v)*A,s[2]=(g-w)*A,s[3]=0,s[4]=(f-v)*T,s[5]=(1-(d+m))*T,s[6]=(p+x)*T,s[7]=0,s[8]=(g+w)*_,s[9]=(p-x)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=na.set(s[0],s[1],s[2]).length(),a=na.set(s[4],s[5],s[6]).length(),c=na.set(s[8],s[9],s[10]).length();r<0&&(o=-o),_s.copy(this);let l=1/o,u=1/a,h=1/c;return _s.elements[0]*=l,_s.elements[1]*=l,_s.elements[2]*=l,_s.elements[4]*=u,_s.elements[5]*=u,_s.elements[6]*=u,_s.elements[8]*=h,_s.elements[9]*=h,_s.elements[10]*=h,e.setFromRotationMatrix(_s),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=is,c=!1){let l=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),g,y;if(c)g=r/(o-r),y=o*r/(o-r);else if(a===is)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Nl)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=is,c=!1){let l=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),g,y;if(c)g=1/(o-r),y=o/(o-r);else if(a===is)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Nl)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=h,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},na=new k,_s=new be,kM=new k(0,0,0),zM=new k(1,1,1),Dr=new k,ru=new k,Hi=new k,G0=new be,V0=new on,Br=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ve(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ve(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return G0.makeRotationFromQuaternion(t),this.setFromRotationMatrix(G0,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return V0.setFromEuler(this),this.setFromQuaternion(V0,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Br.DEFAULT_ORDER="XYZ";var wa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},HM=0,W0=new k,ia=new on,nr=new be,ou=new k,xl=new k,GM=new k,VM=new on,q0=new k(1,0,0),$0=new k(0,1,0),X0=new k(0,0,1),Y0={type:"added"},WM={type:"removed"},sa={type:"childadded",child:null},Yf={type:"childremoved",child:null},vi=class n extends vs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:HM++}),this.uuid=Yr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new k,e=new Br,i=new on,s=new k(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new be},normalMatrix:{value:new ce}}),this.matrix=new be,this.matrixWorld=new be,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new wa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ia.setFromAxisAngle(t,e),this.quaternion.multiply(ia),this}rotateOnWorldAxis(t,e){return ia.setFromAxisAngle(t,e),this.quaternion.premultiply(ia),this}rotateX(t){return this.rotateOnAxis(q0,t)}rotateY(t){return this.rotateOnAxis($0,t)}rotateZ(t){return this.rotateOnAxis(X0,t)}translateOnAxis(t,e){return W0.copy(t).applyQuaternion(this.quaternion),this.position.add(W0.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(q0,t)}translateY(t){return this.translateOnAxis($0,t)}translateZ(t){return this.translateOnAxis(X0,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(nr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ou.copy(t):ou.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),xl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?nr.lookAt(xl,ou,this.up):nr.lookAt(ou,xl,this.up),this.quaternion.setFromRotationMatrix(nr),s&&(nr.extractRotation(s.matrixWorld),ia.setFromRotationMatrix(nr),this.quaternion.premultiply(ia.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ie("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Y0),sa.child=t,this.dispatchEvent(sa),sa.child=null):ie("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(WM),Yf.child=t,this.dispatchEvent(Yf),Yf.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),nr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),nr.multiply(t.parent.matrixWorld)),t.applyMatrix4(nr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Y0),sa.child=t,this.dispatchEvent(sa),sa.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xl,t,GM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xl,VM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let h=c[l];r(t.shapes,h)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};vi.DEFAULT_UP=new k(0,1,0);vi.DEFAULT_MATRIX_AUTO_UPDATE=!0;vi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Jn=class extends vi{constructor(){super(),this.isGroup=!0,this.type="Group"}},qM={type:"move"},Ea=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,i),m=this._getHandJoint(l,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;l.inputState.pinching&&d>f+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(qM)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Jn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},tx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Nr={h:0,s:0,l:0},au={h:0,s:0,l:0};function Zf(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ee=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=gi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Te.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Te.workingColorSpace){return this.r=t,this.g=e,this.b=i,Te.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Te.workingColorSpace){if(t=Yp(t,1),e=ve(e,0,1),i=ve(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Zf(o,r,t+1/3),this.g=Zf(o,r,t),this.b=Zf(o,r,t-1/3)}return Te.colorSpaceToWorking(this,s),this}setStyle(t,e=gi){function i(r){r!==void 0&&parseFloat(r)<1&&Qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=gi){let i=tx[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=lr(t.r),this.g=lr(t.g),this.b=lr(t.b),this}copyLinearToSRGB(t){return this.r=ya(t.r),this.g=ya(t.g),this.b=ya(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=gi){return Te.workingToColorSpace(ri.copy(this),t),Math.round(ve(ri.r*255,0,255))*65536+Math.round(ve(ri.g*255,0,255))*256+Math.round(ve(ri.b*255,0,255))}getHexString(t=gi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Te.workingColorSpace){Te.workingToColorSpace(ri.copy(this),e);let i=ri.r,s=ri.g,r=ri.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let h=o-a;switch(l=u<=.5?h/(o+a):h/(2-o-a),o){case i:c=(s-r)/h+(s<r?6:0);break;case s:c=(r-i)/h+2;break;case r:c=(i-s)/h+4;break}c/=6}return t.h=c,t.s=l,t.l=u,t}getRGB(t,e=Te.workingColorSpace){return Te.workingToColorSpace(ri.copy(this),e),t.r=ri.r,t.g=ri.g,t.b=ri.b,t}getStyle(t=gi){Te.workingToColorSpace(ri.copy(this),t);let e=ri.r,i=ri.g,s=ri.b;return t!==gi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Nr),this.setHSL(Nr.h+t,Nr.s+e,Nr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Nr),t.getHSL(au);let i=Pl(Nr.h,au.h,e),s=Pl(Nr.s,au.s,e),r=Pl(Nr.l,au.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ri=new ee;ee.NAMES=tx;var Bl=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ee(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},kl=class extends vi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Br,this.environmentIntensity=1,this.environmentRotation=new Br,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},xs=new k,ir=new k,jf=new k,sr=new k,ra=new k,oa=new k,Z0=new k,Jf=new k,Kf=new k,Qf=new k,tp=new dn,ep=new dn,np=new dn,ar=class n{constructor(t=new k,e=new k,i=new k){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),xs.subVectors(t,e),s.cross(xs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){xs.subVectors(s,e),ir.subVectors(i,e),jf.subVectors(t,e);let o=xs.dot(xs),a=xs.dot(ir),c=xs.dot(jf),l=ir.dot(ir),u=ir.dot(jf),h=o*l-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(l*c-a*u)*d,g=(o*u-a*c)*d;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,sr)===null?!1:sr.x>=0&&sr.y>=0&&sr.x+sr.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,sr)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,sr.x),c.addScaledVector(o,sr.y),c.addScaledVector(a,sr.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return tp.setScalar(0),ep.setScalar(0),np.setScalar(0),tp.fromBufferAttribute(t,e),ep.fromBufferAttribute(t,i),np.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(tp,r.x),o.addScaledVector(ep,r.y),o.addScaledVector(np,r.z),o}static isFrontFacing(t,e,i,s){return xs.subVectors(i,e),ir.subVectors(t,e),xs.cross(ir).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return xs.subVectors(this.c,this.b),ir.subVectors(this.a,this.b),xs.cross(ir).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ra.subVectors(s,i),oa.subVectors(r,i),Jf.subVectors(t,i);let c=ra.dot(Jf),l=oa.dot(Jf);if(c<=0&&l<=0)return e.copy(i);Kf.subVectors(t,s);let u=ra.dot(Kf),h=oa.dot(Kf);if(u>=0&&h<=u)return e.copy(s);let d=c*h-u*l;if(d<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),e.copy(i).addScaledVector(ra,o);Qf.subVectors(t,r);let f=ra.dot(Qf),g=oa.dot(Qf);if(g>=0&&f<=g)return e.copy(r);let y=f*l-c*g;if(y<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(i).addScaledVector(oa,a);let p=u*g-f*h;if(p<=0&&h-u>=0&&f-g>=0)return Z0.subVectors(r,s),a=(h-u)/(h-u+(f-g)),e.copy(s).addScaledVector(Z0,a);let m=1/(p+y+d);return o=y*m,a=d*m,e.copy(i).addScaledVector(ra,o).addScaledVector(oa,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Pi=class{constructor(t=new k(1/0,1/0,1/0),e=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(ys.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(ys.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=ys.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ys):ys.fromBufferAttribute(r,o),ys.applyMatrix4(t.matrixWorld),this.expandByPoint(ys);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),lu.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),lu.copy(i.boundingBox)),lu.applyMatrix4(t.matrixWorld),this.union(lu)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ys),ys.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(yl),cu.subVectors(this.max,yl),aa.subVectors(t.a,yl),la.subVectors(t.b,yl),ca.subVectors(t.c,yl),Ur.subVectors(la,aa),Fr.subVectors(ca,la),ho.subVectors(aa,ca);let e=[0,-Ur.z,Ur.y,0,-Fr.z,Fr.y,0,-ho.z,ho.y,Ur.z,0,-Ur.x,Fr.z,0,-Fr.x,ho.z,0,-ho.x,-Ur.y,Ur.x,0,-Fr.y,Fr.x,0,-ho.y,ho.x,0];return!ip(e,aa,la,ca,cu)||(e=[1,0,0,0,1,0,0,0,1],!ip(e,aa,la,ca,cu))?!1:(uu.crossVectors(Ur,Fr),e=[uu.x,uu.y,uu.z],ip(e,aa,la,ca,cu))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ys).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ys).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(rr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),rr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),rr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),rr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),rr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),rr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),rr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),rr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(rr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},rr=[new k,new k,new k,new k,new k,new k,new k,new k],ys=new k,lu=new Pi,aa=new k,la=new k,ca=new k,Ur=new k,Fr=new k,ho=new k,yl=new k,cu=new k,uu=new k,fo=new k;function ip(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){fo.fromArray(n,r);let a=s.x*Math.abs(fo.x)+s.y*Math.abs(fo.y)+s.z*Math.abs(fo.z),c=t.dot(fo),l=e.dot(fo),u=i.dot(fo);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var Ln=new k,hu=new qt,$M=0,Ze=class extends vs{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$M++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=$p,this.updateRanges=[],this.gpuType=as,this.version=0,this._normalizationScale=t!==void 0?td(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)hu.fromBufferAttribute(this,e),hu.applyMatrix3(t),this.setXY(e,hu.x,hu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.applyMatrix3(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.applyMatrix4(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.applyNormalMatrix(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ln.fromBufferAttribute(this,e),Ln.transformDirection(t),this.setXYZ(e,Ln.x,Ln.y,Ln.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Jp(t,this.array)}};var zl=class extends Ze{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Hl=class extends Ze{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Ae=class extends Ze{constructor(t,e,i){super(new Float32Array(t),e,i)}},XM=new Pi,vl=new k,sp=new k,Vs=class{constructor(t=new k,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):XM.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;vl.subVectors(t,this.center);let e=vl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(vl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(sp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(vl.copy(t.center).add(sp)),this.expandByPoint(vl.copy(t.center).sub(sp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},YM=0,ns=new be,rp=new vi,ua=new k,Gi=new Pi,bl=new Pi,jn=new k,Pe=class n extends vs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:YM++}),this.uuid=Yr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(yM(t)?Hl:zl)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ce().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return ns.makeRotationFromQuaternion(t),this.applyMatrix4(ns),this}rotateX(t){return ns.makeRotationX(t),this.applyMatrix4(ns),this}rotateY(t){return ns.makeRotationY(t),this.applyMatrix4(ns),this}rotateZ(t){return ns.makeRotationZ(t),this.applyMatrix4(ns),this}translate(t,e,i){return ns.makeTranslation(t,e,i),this.applyMatrix4(ns),this}scale(t,e,i){return ns.makeScale(t,e,i),this.applyMatrix4(ns),this}lookAt(t){return rp.lookAt(t),rp.updateMatrix(),this.applyMatrix4(rp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ua).negate(),this.translate(ua.x,ua.y,ua.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ae(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Gi.setFromBufferAttribute(r),this.morphTargetsRelative?(jn.addVectors(this.boundingBox.min,Gi.min),this.boundingBox.expandByPoint(jn),jn.addVectors(this.boundingBox.max,Gi.max),this.boundingBox.expandByPoint(jn)):(this.boundingBox.expandByPoint(Gi.min),this.boundingBox.expandByPoint(Gi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(t){let i=this.boundingSphere.center;if(Gi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];bl.setFromBufferAttribute(a),this.morphTargetsRelative?(jn.addVectors(Gi.min,bl.min),Gi.expandByPoint(jn),jn.addVectors(Gi.max,bl.max),Gi.expandByPoint(jn)):(Gi.expandByPoint(bl.min),Gi.expandByPoint(bl.max))}Gi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)jn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(jn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)jn.fromBufferAttribute(a,l),c&&(ua.fromBufferAttribute(t,l),jn.add(ua)),s=Math.max(s,i.distanceToSquared(jn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ze(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new k,c[L]=new k;let u=new k,h=new k,d=new k,f=new qt,g=new qt,y=new qt,p=new k,m=new k;function x(L,I,D){l[L]=l[I]=l[D]=1,u.fromBufferAttribute(i,L),h.fromBufferAttribute(i,I),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,L),g.fromBufferAttribute(r,I),y.fromBufferAttribute(r,D),h.sub(u),d.sub(u),g.sub(f),y.sub(f);let B=1/(g.x*y.y-y.x*g.y);isFinite(B)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(B),m.copy(d).multiplyScalar(g.x).addScaledVector(h,-y.x).multiplyScalar(B),a[L].add(p),a[I].add(p),a[D].add(p),c[L].add(m),c[I].add(m),c[D].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let L=0,I=w.length;L<I;++L){let D=w[L],B=D.start,V=D.count;for(let O=B,$=B+V;O<$;O+=3)x(t.getX(O+0),t.getX(O+1),t.getX(O+2))}let v=new k,A=new k,T=new k,_=new k;function b(L){T.fromBufferAttribute(s,L),_.copy(T);let I=a[L];v.copy(I),v.sub(T.multiplyScalar(T.dot(I))).normalize(),A.crossVectors(_,I);let B=A.dot(c[L])<0?-1:1;o.setXYZW(L,v.x,v.y,v.z,B)}for(let L=0,I=i.count;L<I;++L)l[L]&&b(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ze(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new k,r=new k,o=new k,a=new k,c=new k,l=new k,u=new k,h=new k;if(t)for(let d=0,f=t.count;d<f;d+=3){let g=t.getX(d+0),y=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,y),l.fromBufferAttribute(i,p),a.add(u),c.add(u),l.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)jn.fromBufferAttribute(t,e),jn.normalize(),t.setXYZ(e,jn.x,jn.y,jn.z)}toNonIndexed(){function t(a,c){let l=a.array,u=a.itemSize,h=a.normalized,d=new l.constructor(c.length*u),f=0,g=0;for(let y=0,p=c.length;y<p;y++){a.isInterleavedBufferAttribute?f=c[y]*a.data.stride+a.offset:f=c[y]*u;for(let m=0;m<u;m++)d[g++]=l[f++]}return new Ze(d,u,h)}if(this.index===null)return Qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,h=l.length;u<h;u++){let d=l[u],f=t(d,i);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let h=0,d=l.length;h<d;h++){let f=l[h];u.push(f.toJSON(t.data))}u.length>0&&(s[c]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(e))}let r=t.morphAttributes;for(let l in r){let u=[],h=r[l];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[l]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,u=o.length;l<u;l++){let h=o[l];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Gl=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=$p,this.updateRanges=[],this.version=0,this.uuid=Yr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=j0(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=j0(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function j0(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Yr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var mi=new k,Ta=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?td(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)mi.fromBufferAttribute(this,e),mi.applyMatrix4(t),this.setXYZ(e,mi.x,mi.y,mi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)mi.fromBufferAttribute(this,e),mi.applyNormalMatrix(t),this.setXYZ(e,mi.x,mi.y,mi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)mi.fromBufferAttribute(this,e),mi.transformDirection(t),this.setXYZ(e,mi.x,mi.y,mi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Fl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ze(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Fl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jp(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Jp(t,this.data.array)}},op=new k,ZM=new k,jM=new ce,ei=class{constructor(t=new k(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=op.subVectors(i,e).cross(ZM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(op),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||jM.getNormalMatrix(t),s=this.coplanarPoint(op).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},JM=0,Ws=class extends vs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:JM++}),this.uuid=Yr(),this.name="",this.type="Material",this.blending=Da,this.side=$r,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Mp,this.blendDst=wp,this.blendEquation=So,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ee(0,0,0),this.blendAlpha=0,this.depthFunc=va,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=W_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Nu,this.stencilZFail=Nu,this.stencilZPass=Nu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ee().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ei().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Aa=class extends Ws{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},ha,Sl=new k,da=new k,fa=new k,pa=new qt,Ml=new qt,ex=new be,du=new k,wl=new k,fu=new k,J0=new qt,ap=new qt,K0=new qt,Vl=class extends vi{constructor(t=new Aa){if(super(),this.isSprite=!0,this.type="Sprite",ha===void 0){ha=new Pe;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Gl(e,5);ha.setIndex([0,1,2,0,2,3]),ha.setAttribute("position",new Ta(i,3,0,!1)),ha.setAttribute("uv",new Ta(i,2,3,!1))}this.geometry=ha,this.material=t,this.center=new qt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ie('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),da.setFromMatrixScale(this.matrixWorld),ex.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),fa.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&da.multiplyScalar(-fa.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;pu(du.set(-.5,-.5,0),fa,o,da,s,r),pu(wl.set(.5,-.5,0),fa,o,da,s,r),pu(fu.set(.5,.5,0),fa,o,da,s,r),J0.set(0,0),ap.set(1,0),K0.set(1,1);let a=t.ray.intersectTriangle(du,wl,fu,!1,Sl);if(a===null&&(pu(wl.set(-.5,.5,0),fa,o,da,s,r),ap.set(0,1),a=t.ray.intersectTriangle(du,fu,wl,!1,Sl),a===null))return;let c=t.ray.origin.distanceTo(Sl);c<t.near||c>t.far||e.push({distance:c,point:Sl.clone(),uv:ar.getInterpolation(Sl,du,wl,fu,J0,ap,K0,new qt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function pu(n,t,e,i,s,r){pa.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Ml.x=r*pa.x-s*pa.y,Ml.y=s*pa.x+r*pa.y):Ml.copy(pa),n.copy(t),n.x+=Ml.x,n.y+=Ml.y,n.applyMatrix4(ex)}var or=new k,lp=new k,mu=new k,gu=new k,ur=class{constructor(t=new k,e=new k(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,or)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=or.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(or.copy(this.origin).addScaledVector(this.direction,e),or.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){lp.copy(t).add(e).multiplyScalar(.5),mu.copy(e).sub(t).normalize(),gu.copy(this.origin).sub(lp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(mu),a=gu.dot(this.direction),c=-gu.dot(mu),l=gu.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*c-a,d=o*a-c,g=r*u,h>=0)if(d>=-g)if(d<=g){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*c)+l}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l):d<=g?(h=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-c),r),f=-h*h+d*(d+2*c)+l);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(lp).addScaledVector(mu,d),f}intersectSphere(t,e){if(t.radius<0)return null;or.subVectors(t.center,this.origin);let i=or.dot(this.direction),s=or.dot(or)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return l>=0?(i=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(i=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,c=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,c=(t.min.z-d.z)*h),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,or)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,g=e.x-o.x,y=e.y-o.y,p=e.z-o.z,m=i.x-o.x,x=i.y-o.y,w=i.z-o.z,v=Math.abs(c),A=Math.abs(l),T=Math.abs(u),_,b,L,I,D,B,V,O,$,Z,q,ht;if(v>=A&&v>=T?(L=c,B=h,$=g,ht=m,c>=0?(_=l,b=u,I=d,D=f,V=y,O=p,Z=x,q=w):(_=u,b=l,I=f,D=d,V=p,O=y,Z=w,q=x)):A>=T?(L=l,B=d,$=y,ht=x,l>=0?(_=u,b=c,I=f,D=h,V=p,O=g,Z=w,q=m):(_=c,b=u,I=h,D=f,V=g,O=p,Z=m,q=w)):(L=u,B=f,$=p,ht=w,u>=0?(_=c,b=l,I=h,D=d,V=g,O=y,Z=m,q=x):(_=l,b=c,I=d,D=h,V=y,O=g,Z=x,q=m)),L===0)return null;let K=_/L,tt=b/L,rt=1/L,pt=I-K*B,ft=D-tt*B,et=V-K*$,yt=O-tt*$,St=Z-K*ht,Lt=q-tt*ht,At=St*yt-Lt*et,jt=pt*Lt-ft*St,de=et*ft-yt*pt;if(s){if(At<0||jt<0||de<0)return null}else if((At<0||jt<0||de<0)&&(At>0||jt>0||de>0))return null;let Xt=At+jt+de;if(Xt===0)return null;let ye=rt*(At*B+jt*$+de*ht);return(Xt>0?ye<0:ye>0)?null:this.at(ye/Xt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},bi=class extends Ws{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ee(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Br,this.combine=Ep,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Q0=new be,po=new ur,_u=new Vs,t_=new k,xu=new k,yu=new k,vu=new k,cp=new k,bu=new k,e_=new k,Su=new k,bn=class extends vi{constructor(t=new Pe,e=new bi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){bu.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],h=r[c];u!==0&&(cp.fromBufferAttribute(h,t),o?bu.addScaledVector(cp,u):bu.addScaledVector(cp.sub(e),u))}e.add(bu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),_u.copy(i.boundingSphere),_u.applyMatrix4(r),po.copy(t.ray).recast(t.near),!(_u.containsPoint(po.origin)===!1&&(po.intersectSphere(_u,t_)===null||po.origin.distanceToSquared(t_)>(t.far-t.near)**2))&&(Q0.copy(r).invert(),po.copy(t.ray).applyMatrix4(Q0),!(i.boundingBox!==null&&po.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,po)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),w=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let v=x,A=w;v<A;v+=3){let T=a.getX(v),_=a.getX(v+1),b=a.getX(v+2);s=Mu(this,m,t,i,l,u,h,T,_,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=a.getX(p),w=a.getX(p+1),v=a.getX(p+2);s=Mu(this,o,t,i,l,u,h,x,w,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),w=Math.min(c.count,Math.min(p.start+p.count,f.start+f.count));for(let v=x,A=w;v<A;v+=3){let T=v,_=v+1,b=v+2;s=Mu(this,m,t,i,l,u,h,T,_,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=p,w=p+1,v=p+2;s=Mu(this,o,t,i,l,u,h,x,w,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function KM(n,t,e,i,s,r,o,a){let c;if(t.side===Si?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===$r,a),c===null)return null;Su.copy(a),Su.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(Su);return l<e.near||l>e.far?null:{distance:l,point:Su.clone(),object:n}}function Mu(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,xu),n.getVertexPosition(c,yu),n.getVertexPosition(l,vu);let u=KM(n,t,e,i,xu,yu,vu,e_);if(u){let h=new k;ar.getBarycoord(e_,xu,yu,vu,h),s&&(u.uv=ar.getInterpolatedAttribute(s,a,c,l,h,new qt)),r&&(u.uv1=ar.getInterpolatedAttribute(r,a,c,l,h,new qt)),o&&(u.normal=ar.getInterpolatedAttribute(o,a,c,l,h,new k),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new k,materialIndex:0};ar.getNormal(xu,yu,vu,d.normal),u.face=d,u.barycoord=h}return u}var Wl=class extends yi{constructor(t=null,e=1,i=1,s,r,o,a,c,l=Kn,u=Kn,h,d){super(null,o,a,c,l,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ra=class extends Ze{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},ma=new be,n_=new be,wu=[],i_=new Pi,QM=new be,El=new bn,Tl=new Vs,ql=class extends bn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ra(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,QM)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Pi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ma),i_.copy(t.boundingBox).applyMatrix4(ma),this.boundingBox.union(i_)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Vs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ma),Tl.copy(t.boundingSphere).applyMatrix4(ma),this.boundingSphere.union(Tl)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(El.geometry=this.geometry,El.material=this.material,El.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Tl.copy(this.boundingSphere),Tl.applyMatrix4(i),t.ray.intersectsSphere(Tl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ma),n_.multiplyMatrices(i,ma),El.matrixWorld=n_,El.raycast(t,wu);for(let o=0,a=wu.length;o<a;o++){let c=wu[o];c.instanceId=r,c.object=this,e.push(c)}wu.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ra(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Wl(new Float32Array(s*this.count),s,this.count,yh,as));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},mo=new Vs,tw=new qt(.5,.5),Eu=new k,go=class{constructor(t=new ei,e=new ei,i=new ei,s=new ei,r=new ei,o=new ei){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=is,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],x=r[12],w=r[13],v=r[14],A=r[15];if(s[0].setComponents(l-o,f-u,m-g,A-x).normalize(),s[1].setComponents(l+o,f+u,m+g,A+x).normalize(),s[2].setComponents(l+a,f+h,m+y,A+w).normalize(),s[3].setComponents(l-a,f-h,m-y,A-w).normalize(),i)s[4].setComponents(c,d,p,v).normalize(),s[5].setComponents(l-c,f-d,m-p,A-v).normalize();else if(s[4].setComponents(l-c,f-d,m-p,A-v).normalize(),e===is)s[5].setComponents(l+c,f+d,m+p,A+v).normalize();else if(e===Nl)s[5].setComponents(c,d,p,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),mo.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),mo.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(mo)}intersectsSprite(t){mo.center.set(0,0,0);let e=tw.distanceTo(t.center);return mo.radius=.7071067811865476+e,mo.applyMatrix4(t.matrixWorld),this.intersectsSphere(mo)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Eu.x=s.normal.x>0?t.max.x:t.min.x,Eu.y=s.normal.y>0?t.max.y:t.min.y,Eu.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Eu)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},s_=new be,Yu=class n{constructor(){this.coordinateSystem=is,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];s_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new go),i[s].setFromProjectionMatrix(s_,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new go),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var bs=class extends Ws{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ee(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Zu=new k,ju=new k,r_=new be,Al=new ur,Tu=new Vs,up=new k,o_=new k,kr=class extends vi{constructor(t=new Pe,e=new bs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Zu.fromBufferAttribute(e,s-1),ju.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Zu.distanceTo(ju);t.setAttribute("lineDistance",new Ae(i,1))}else Qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Tu.copy(i.boundingSphere),Tu.applyMatrix4(s),Tu.radius+=r,t.ray.intersectsSphere(Tu)===!1)return;r_.copy(s).invert(),Al.copy(t.ray).applyMatrix4(r_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=l){let m=u.getX(y),x=u.getX(y+1),w=Au(this,t,Al,c,m,x,y);w&&e.push(w)}if(this.isLineLoop){let y=u.getX(g-1),p=u.getX(f),m=Au(this,t,Al,c,y,p,g-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=l){let m=Au(this,t,Al,c,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=Au(this,t,Al,c,g-1,f,g-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Au(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Zu.fromBufferAttribute(a,s),ju.fromBufferAttribute(a,r),e.distanceSqToSegment(Zu,ju,up,o_)>i)return;up.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(up);if(!(l<t.near||l>t.far))return{distance:l,point:o_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var a_=new k,l_=new k,_o=class extends kr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)a_.fromBufferAttribute(e,s),l_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+a_.distanceTo(l_);t.setAttribute("lineDistance",new Ae(i,1))}else Qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var zr=class extends Ws{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ee(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},c_=new be,mp=new ur,Ru=new Vs,Cu=new k,xo=class extends vi{constructor(t=new Pe,e=new zr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ru.copy(i.boundingSphere),Ru.applyMatrix4(s),Ru.radius+=r,t.ray.intersectsSphere(Ru)===!1)return;c_.copy(s).invert(),mp.copy(t.ray).applyMatrix4(c_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,h=i.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let g=d,y=f;g<y;g++){let p=l.getX(g);Cu.fromBufferAttribute(h,p),u_(Cu,p,c,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let g=d,y=f;g<y;g++)Cu.fromBufferAttribute(h,g),u_(Cu,g,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function u_(n,t,e,i,s,r,o){let a=mp.distanceSqToPoint(n);if(a<e){let c=new k;mp.closestPointToPoint(n,c),c.applyMatrix4(i);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var $l=class extends yi{constructor(t=[],e=Mo,i,s,r,o,a,c,l,u){super(t,e,i,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Xl=class extends yi{constructor(t,e,i,s,r,o,a,c,l){super(t,e,i,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var hr=class extends yi{constructor(t,e,i=Ss,s,r,o,a=Kn,c=Kn,l,u=cr,h=1){if(u!==cr&&u!==fr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,c,u,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ma(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Yl=class extends hr{constructor(t,e=Ss,i=Mo,s,r,o=Kn,a=Kn,c,l=cr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Zl=class extends yi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ss=class n extends Pe{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Ae(l,3)),this.setAttribute("normal",new Ae(u,3)),this.setAttribute("uv",new Ae(h,2));function g(y,p,m,x,w,v,A,T,_,b,L){let I=v/_,D=A/b,B=v/2,V=A/2,O=T/2,$=_+1,Z=b+1,q=0,ht=0,K=new k;for(let tt=0;tt<Z;tt++){let rt=tt*D-V;for(let pt=0;pt<$;pt++){let ft=pt*I-B;K[y]=ft*x,K[p]=rt*w,K[m]=O,l.push(K.x,K.y,K.z),K[y]=0,K[p]=0,K[m]=T>0?1:-1,u.push(K.x,K.y,K.z),h.push(pt/_),h.push(1-tt/b),q+=1}}for(let tt=0;tt<b;tt++)for(let rt=0;rt<_;rt++){let pt=d+rt+$*tt,ft=d+rt+$*(tt+1),et=d+(rt+1)+$*(tt+1),yt=d+(rt+1)+$*tt;c.push(pt,ft,yt),c.push(ft,et,yt),ht+=6}a.addGroup(f,ht,L),f+=ht,d+=q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},jl=class n extends Pe{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],c=[],l=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,g=i*2+r,y=s+1,p=new k,m=new k;for(let x=0;x<=g;x++){let w=0,v=0,A=0,T=0;if(x<=i){let L=x/i,I=L*Math.PI/2;v=-u-t*Math.cos(I),A=t*Math.sin(I),T=-t*Math.cos(I),w=L*h}else if(x<=i+r){let L=(x-i)/r;v=-u+L*e,A=t,T=0,w=h+L*d}else{let L=(x-i-r)/i,I=L*Math.PI/2;v=u+t*Math.sin(I),A=t*Math.cos(I),T=t*Math.sin(I),w=h+d+L*h}let _=Math.max(0,Math.min(1,w/f)),b=0;x===0?b=.5/s:x===g&&(b=-.5/s);for(let L=0;L<=s;L++){let I=L/s,D=I*Math.PI*2,B=Math.sin(D),V=Math.cos(D);m.x=-A*V,m.y=v,m.z=A*B,a.push(m.x,m.y,m.z),p.set(-A*V,T,A*B),p.normalize(),c.push(p.x,p.y,p.z),l.push(I+b,_)}if(x>0){let L=(x-1)*y;for(let I=0;I<s;I++){let D=L+I,B=L+I+1,V=x*y+I,O=x*y+I+1;o.push(D,B,V),o.push(B,O,V)}}}this.setIndex(o),this.setAttribute("position",new Ae(a,3)),this.setAttribute("normal",new Ae(c,3)),this.setAttribute("uv",new Ae(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}};var Wi=class n extends Pe{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],g=0,y=[],p=i/2,m=0;x(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new Ae(h,3)),this.setAttribute("normal",new Ae(d,3)),this.setAttribute("uv",new Ae(f,2));function x(){let v=new k,A=new k,T=0,_=(e-t)/i;for(let b=0;b<=r;b++){let L=[],I=b/r,D=I*(e-t)+t;for(let B=0;B<=s;B++){let V=B/s,O=V*c+a,$=Math.sin(O),Z=Math.cos(O);A.x=D*$,A.y=-I*i+p,A.z=D*Z,h.push(A.x,A.y,A.z),v.set($,_,Z).normalize(),d.push(v.x,v.y,v.z),f.push(V,1-I),L.push(g++)}y.push(L)}for(let b=0;b<s;b++)for(let L=0;L<r;L++){let I=y[L][b],D=y[L+1][b],B=y[L+1][b+1],V=y[L][b+1];(t>0||L!==0)&&(u.push(I,D,V),T+=3),(e>0||L!==r-1)&&(u.push(D,B,V),T+=3)}l.addGroup(m,T,0),m+=T}function w(v){let A=g,T=new qt,_=new k,b=0,L=v===!0?t:e,I=v===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,p*I,0),d.push(0,I,0),f.push(.5,.5),g++;let D=g;for(let B=0;B<=s;B++){let O=B/s*c+a,$=Math.cos(O),Z=Math.sin(O);_.x=L*Z,_.y=p*I,_.z=L*$,h.push(_.x,_.y,_.z),d.push(0,I,0),T.x=$*.5+.5,T.y=Z*.5*I+.5,f.push(T.x,T.y),g++}for(let B=0;B<s;B++){let V=A+B,O=D+B;v===!0?u.push(O,O+1,V):u.push(O+1,O,V),b+=3}l.addGroup(m,b,v===!0?1:2),m+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},yo=class n extends Wi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ju=class n extends Pe{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),l(i),u(),this.setAttribute("position",new Ae(r,3)),this.setAttribute("normal",new Ae(r.slice(),3)),this.setAttribute("uv",new Ae(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let w=new k,v=new k,A=new k;for(let T=0;T<e.length;T+=3)f(e[T+0],w),f(e[T+1],v),f(e[T+2],A),c(w,v,A,x)}function c(x,w,v,A){let T=A+1,_=[];for(let b=0;b<=T;b++){_[b]=[];let L=x.clone().lerp(v,b/T),I=w.clone().lerp(v,b/T),D=T-b;for(let B=0;B<=D;B++)B===0&&b===T?_[b][B]=L:_[b][B]=L.clone().lerp(I,B/D)}for(let b=0;b<T;b++)for(let L=0;L<2*(T-b)-1;L++){let I=Math.floor(L/2);L%2===0?(d(_[b][I+1]),d(_[b+1][I]),d(_[b][I])):(d(_[b][I+1]),d(_[b+1][I+1]),d(_[b+1][I]))}}function l(x){let w=new k;for(let v=0;v<r.length;v+=3)w.x=r[v+0],w.y=r[v+1],w.z=r[v+2],w.normalize().multiplyScalar(x),r[v+0]=w.x,r[v+1]=w.y,r[v+2]=w.z}function u(){let x=new k;for(let w=0;w<r.length;w+=3){x.x=r[w+0],x.y=r[w+1],x.z=r[w+2];let v=p(x)/2/Math.PI+.5,A=m(x)/Math.PI+.5;o.push(v,1-A)}g(),h()}function h(){for(let x=0;x<o.length;x+=6){let w=o[x+0],v=o[x+2],A=o[x+4],T=Math.max(w,v,A),_=Math.min(w,v,A);T>.9&&_<.1&&(w<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,w){let v=x*3;w.x=t[v+0],w.y=t[v+1],w.z=t[v+2]}function g(){let x=new k,w=new k,v=new k,A=new k,T=new qt,_=new qt,b=new qt;for(let L=0,I=0;L<r.length;L+=9,I+=6){x.set(r[L+0],r[L+1],r[L+2]),w.set(r[L+3],r[L+4],r[L+5]),v.set(r[L+6],r[L+7],r[L+8]),T.set(o[I+0],o[I+1]),_.set(o[I+2],o[I+3]),b.set(o[I+4],o[I+5]),A.copy(x).add(w).add(v).divideScalar(3);let D=p(A);y(T,I+0,x,D),y(_,I+2,w,D),y(b,I+4,v,D)}}function y(x,w,v,A){A<0&&x.x===1&&(o[w]=x.x-1),v.x===0&&v.z===0&&(o[w]=A/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function m(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Jl=class n extends Pe{constructor(t=[new qt(0,-.5),new qt(.5,0),new qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=ve(s,0,Math.PI*2);let r=[],o=[],a=[],c=[],l=[],u=1/e,h=new k,d=new qt,f=new k,g=new k,y=new k,p=0,m=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:p=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,f.x=m*1,f.y=-p,f.z=m*0,y.copy(f),f.normalize(),c.push(f.x,f.y,f.z);break;case t.length-1:y.normalize(),c.push(y.x,y.y,y.z);break;default:p=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,f.x=m*1,f.y=-p,f.z=m*0,g.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),c.push(f.x,f.y,f.z),y.copy(g)}for(let x=0;x<=e;x++){let w=i+x*u*s,v=Math.sin(w),A=Math.cos(w);for(let T=0;T<=t.length-1;T++){h.x=t[T].x*v,h.y=t[T].y,h.z=t[T].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=T/(t.length-1),a.push(d.x,d.y);let _=c[3*T+0]*v,b=c[3*T+1],L=c[3*T+0]*A;l.push(_,b,L)}}for(let x=0;x<e;x++)for(let w=0;w<t.length-1;w++){let v=w+x*t.length,A=v,T=v+t.length,_=v+t.length+1,b=v+1;r.push(A,T,b),r.push(_,b,T)}this.setIndex(r),this.setAttribute("position",new Ae(o,3)),this.setAttribute("uv",new Ae(a,2)),this.setAttribute("normal",new Ae(l,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},Kl=class n extends Ju{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Ql=class n extends Pe{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,u=c+1,h=t/a,d=e/c,f=[],g=[],y=[],p=[];for(let m=0;m<u;m++){let x=m*d-o;for(let w=0;w<l;w++){let v=w*h-r;g.push(v,-x,0),y.push(0,0,1),p.push(w/a),p.push(1-m/c)}}for(let m=0;m<c;m++)for(let x=0;x<a;x++){let w=x+l*m,v=x+l*(m+1),A=x+1+l*(m+1),T=x+1+l*m;f.push(w,v,T),f.push(v,A,T)}this.setIndex(f),this.setAttribute("position",new Ae(g,3)),this.setAttribute("normal",new Ae(y,3)),this.setAttribute("uv",new Ae(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var vo=class n extends Pe{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,u=[],h=new k,d=new k,f=[],g=[],y=[],p=[];for(let m=0;m<=i;m++){let x=[],w=m/i,v=o+w*a,A=t*Math.cos(v),T=Math.sqrt(t*t-A*A),_=0;m===0&&o===0?_=.5/e:m===i&&c===Math.PI&&(_=-.5/e);for(let b=0;b<=e;b++){let L=b/e,I=s+L*r;h.x=-T*Math.cos(I),h.y=A,h.z=T*Math.sin(I),g.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),p.push(L+_,1-w),x.push(l++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<e;x++){let w=u[m][x+1],v=u[m][x],A=u[m+1][x],T=u[m+1][x+1];(m!==0||o>0)&&f.push(w,v,T),(m!==i-1||c<Math.PI)&&f.push(v,A,T)}this.setIndex(f),this.setAttribute("position",new Ae(g,3)),this.setAttribute("normal",new Ae(y,3)),this.setAttribute("uv",new Ae(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ca=class n extends Pe{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let c=[],l=[],u=[],h=[],d=new k,f=new k,g=new k;for(let y=0;y<=i;y++){let p=o+y/i*a;for(let m=0;m<=s;m++){let x=m/s*r;f.x=(t+e*Math.cos(p))*Math.cos(x),f.y=(t+e*Math.cos(p))*Math.sin(x),f.z=e*Math.sin(p),l.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),g.subVectors(f,d).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let p=1;p<=s;p++){let m=(s+1)*y+p-1,x=(s+1)*(y-1)+p-1,w=(s+1)*(y-1)+p,v=(s+1)*y+p;c.push(m,x,v),c.push(x,w,v)}this.setIndex(c),this.setAttribute("position",new Ae(l,3)),this.setAttribute("normal",new Ae(u,3)),this.setAttribute("uv",new Ae(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Eo(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(h_(s))s.isRenderTargetTexture?(Qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(h_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function oi(n){let t={};for(let e=0;e<n.length;e++){let i=Eo(n[e]);for(let s in i)t[s]=i[s]}return t}function h_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function ew(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Kp(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Te.workingColorSpace}var nx={clone:Eo,merge:oi},nw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,iw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,rs=class extends Ws{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=nw,this.fragmentShader=iw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Eo(t.uniforms),this.uniformsGroups=ew(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ee().setHex(s.value);break;case"v2":this.uniforms[i].value=new qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new k().fromArray(s.value);break;case"v4":this.uniforms[i].value=new dn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ce().fromArray(s.value);break;case"m4":this.uniforms[i].value=new be().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Ku=class extends rs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Qu=class extends Ws{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=G_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},th=class extends Ws{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ga(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Pu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Hr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},eh=class extends Hr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:dp,endingEnd:dp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case fp:r=t,a=2*e-i;break;case pp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case fp:o=t,c=2*i-e;break;case pp:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,u=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-e)/(s-e),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,x=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,w=(-1-f)*p+(1.5+f)*y+.5*g,v=f*p-f*y;for(let A=0;A!==a;++A)r[A]=m*o[u+A]+x*o[l+A]+w*o[c+A]+v*o[h+A];return r}},nh=class extends Hr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[l+d]*h+o[c+d]*u;return r}},ih=class extends Hr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},sh=class extends Hr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-e)/(s-e),y=1-g;for(let p=0;p!==a;++p)r[p]=o[l+p]*y+o[c+p]*g;return r}let d=a*2,f=t-1;for(let g=0;g!==a;++g){let y=o[l+g],p=o[c+g],m=f*d+g*2,x=h[m],w=h[m+1],v=t*d+g*2,A=u[v],T=u[v+1],_=rw(i,e,x,A,s);r[g]=ix(_,y,w,T,p)}return r}};function ix(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function sw(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function rw(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=ix(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=sw(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var qi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ga(e,this.TimeBufferType),this.values=ga(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ga(t.times,Array),values:ga(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Pu(t.settings)&&(i.settings={inTangents:ga(t.settings.inTangents,Array),outTangents:ga(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new ih(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new nh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new eh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new sh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Il:e=this.InterpolantFactoryMethodDiscrete;break;case Wu:e=this.InterpolantFactoryMethodLinear;break;case Du:e=this.InterpolantFactoryMethodSmooth;break;case hp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Il;case this.InterpolantFactoryMethodLinear:return Wu;case this.InterpolantFactoryMethodSmooth:return Du;case this.InterpolantFactoryMethodBezier:return hp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Pu(this.settings)&&(d_(this.settings.inTangents,t),d_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Pu(this.settings)&&(f_(this.settings.inTangents,t),f_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ie("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ie("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){ie("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){ie("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&vM(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){ie("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Du,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],u=t[a+1];if(l!==u&&(a!==1||l!==t[0]))if(s)c=!0;else{let h=a*i,d=h-i,f=h+i;for(let g=0;g!==i;++g){let y=e[h+g];if(y!==e[d+g]||y!==e[f+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Pu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function d_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function f_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}qi.prototype.ValueTypeName="";qi.prototype.TimeBufferType=Float32Array;qi.prototype.ValueBufferType=Float32Array;qi.prototype.DefaultInterpolation=Wu;var Gr=class extends qi{constructor(t,e,i){super(t,e,i)}};Gr.prototype.ValueTypeName="bool";Gr.prototype.ValueBufferType=Array;Gr.prototype.DefaultInterpolation=Il;Gr.prototype.InterpolantFactoryMethodLinear=void 0;Gr.prototype.InterpolantFactoryMethodSmooth=void 0;var rh=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}};rh.prototype.ValueTypeName="color";var oh=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}};oh.prototype.ValueTypeName="number";var ah=class extends Hr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let u=l+a;l!==u;l+=4)on.slerpFlat(r,0,o,l-a,o,l,c);return r}},tc=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ah(this.times,this.values,this.getValueSize(),t)}};tc.prototype.ValueTypeName="quaternion";tc.prototype.InterpolantFactoryMethodSmooth=void 0;var Vr=class extends qi{constructor(t,e,i){super(t,e,i)}};Vr.prototype.ValueTypeName="string";Vr.prototype.ValueBufferType=Array;Vr.prototype.DefaultInterpolation=Il;Vr.prototype.InterpolantFactoryMethodLinear=void 0;Vr.prototype.InterpolantFactoryMethodSmooth=void 0;var lh=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}};lh.prototype.ValueTypeName="vector";var ch=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,h){return l.push(u,h),this},this.removeHandler=function(u){let h=l.indexOf(u);return h!==-1&&l.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=l.length;h<d;h+=2){let f=l[h],g=l[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},sx=new ch,uh=class{constructor(t){this.manager=t!==void 0?t:sx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};uh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Iu=new k,Lu=new on,Hs=new k,ec=class extends vi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new be,this.projectionMatrix=new be,this.projectionMatrixInverse=new be,this.coordinateSystem=is,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Iu,Lu,Hs),Hs.x===1&&Hs.y===1&&Hs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Iu,Lu,Hs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Iu,Lu,Hs),Hs.x===1&&Hs.y===1&&Hs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Iu,Lu,Hs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Or=new k,p_=new qt,m_=new qt,_i=class extends ec{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Sa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Cl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Sa*2*Math.atan(Math.tan(Cl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Or.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Or.x,Or.y).multiplyScalar(-t/Or.z),Or.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Or.x,Or.y).multiplyScalar(-t/Or.z)}getViewSize(t,e){return this.getViewBounds(t,p_,m_),e.subVectors(m_,p_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Cl*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var hh=class extends ec{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var _a=-90,xa=1,Pa=class extends vi{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new _i(_a,xa,t,e);s.layers=this.layers,this.add(s);let r=new _i(_a,xa,t,e);r.layers=this.layers,this.add(r);let o=new _i(_a,xa,t,e);o.layers=this.layers,this.add(o);let a=new _i(_a,xa,t,e);a.layers=this.layers,this.add(a);let c=new _i(_a,xa,t,e);c.layers=this.layers,this.add(c);let l=new _i(_a,xa,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===is)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Nl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},dh=class extends _i{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Qp="\\[\\]\\.:\\/",ow=new RegExp("["+Qp+"]","g"),tm="[^"+Qp+"]",aw="[^"+Qp.replace("\\.","")+"]",lw=/((?:WC+[\/:])*)/.source.replace("WC",tm),cw=/(WCOD+)?/.source.replace("WCOD",aw),uw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tm),hw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tm),dw=new RegExp("^"+lw+cw+uw+hw+"$"),fw=["material","materials","bones","map"],gp=class{constructor(t,e,i){let s=i||rn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},rn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(ow,"")}static parseTrackName(t){let e=dw.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);fw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===l){l=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;ie("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};rn.Composite=gp;rn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};rn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};rn.prototype.GetterByBindingType=[rn.prototype._getValue_direct,rn.prototype._getValue_array,rn.prototype._getValue_arrayElement,rn.prototype._getValue_toArray];rn.prototype.SetterByBindingTypeAndVersioning=[[rn.prototype._setValue_direct,rn.prototype._setValue_direct_setNeedsUpdate,rn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_array,rn.prototype._setValue_array_setNeedsUpdate,rn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_arrayElement,rn.prototype._setValue_arrayElement_setNeedsUpdate,rn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_fromArray,rn.prototype._setValue_fromArray_setNeedsUpdate,rn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Y3=new Float32Array(1);var g_=new be,nc=class{constructor(t,e,i=0,s=1/0){this.ray=new ur(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new wa,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ie("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return g_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(g_),this}intersectObject(t,e=!0,i=[]){return _p(t,this,i,e),i.sort(__),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)_p(t[s],this,i,e);return i.sort(__),i}};function __(n,t){return n.distance-t.distance}function _p(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)_p(r[o],t,e,!0)}}var Ia=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ve(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var xp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var ic=class extends vs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function em(n,t,e,i){let s=pw(i);switch(e){case Bp:return n*t;case yh:return n*t/s.components*s.byteLength;case vh:return n*t/s.components*s.byteLength;case Xr:return n*t*2/s.components*s.byteLength;case bh:return n*t*2/s.components*s.byteLength;case kp:return n*t*3/s.components*s.byteLength;case ws:return n*t*4/s.components*s.byteLength;case Sh:return n*t*4/s.components*s.byteLength;case oc:case ac:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case lc:case cc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case wh:case Th:return Math.max(n,16)*Math.max(t,8)/4;case Mh:case Eh:return Math.max(n,8)*Math.max(t,8)/2;case Ah:case Rh:case Ph:case Ih:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ch:case uc:case Lh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Dh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Nh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Uh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Fh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Oh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Bh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case kh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case zh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Hh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Gh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Vh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Wh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case qh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case $h:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Xh:case Yh:case Zh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case jh:case Jh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case hc:case Kh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function pw(n){switch(n){case $i:case Np:return{byteLength:1,components:1};case Ua:case Up:case Ms:return{byteLength:2,components:1};case _h:case xh:return{byteLength:2,components:4};case Ss:case gh:case as:return{byteLength:4,components:1};case Fp:case Op:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Tx(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function yw(n){let t=new WeakMap;function e(a,c){let l=a.array,u=a.usage,h=l.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,l,u),a.onUploadCallback();let f;if(l instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=n.SHORT;else if(l instanceof Uint32Array)f=n.UNSIGNED_INT;else if(l instanceof Int32Array)f=n.INT;else if(l instanceof Int8Array)f=n.BYTE;else if(l instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,c,l){let u=c.array,h=c.updateRanges;if(n.bindBuffer(l,a),h.length===0)n.bufferSubData(l,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],y=h[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let y=h[f];n.bufferSubData(l,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var vw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bw=`#ifdef USE_ALPHAHASH
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
#endif`,Sw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Mw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ww=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ew=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Tw=`#ifdef USE_AOMAP
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
#endif`,Aw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Rw=`#ifdef USE_BATCHING
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
#endif`,Cw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Pw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Iw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Lw=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Dw=`#ifdef USE_IRIDESCENCE
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
#endif`,Nw=`#ifdef USE_BUMPMAP
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
#endif`,Uw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Fw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ow=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Bw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,kw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,zw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Hw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Gw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Vw=`#define PI 3.141592653589793
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
} // validated`,Ww=`vec3 transformedNormal = objectNormal;
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
#endif`,qw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$w=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Xw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Yw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Zw="gl_FragColor = linearToOutputTexel( gl_FragColor );",jw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Jw=`#ifdef USE_ENVMAP
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
#endif`,Kw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Qw=`#ifdef USE_ENVMAP
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
#endif`,tE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,eE=`#ifdef USE_ENVMAP
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
#endif`,nE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,iE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,sE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,rE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,oE=`#ifdef USE_GRADIENTMAP
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
}`,aE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,cE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,uE=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,hE=`#ifdef USE_ENVMAP
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
#endif`,dE=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,fE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,pE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,mE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,gE=`PhysicalMaterial material;
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
#endif`,_E=`uniform sampler2D dfgLUT;
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
}`,xE=`
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
#endif`,yE=`#if defined( RE_IndirectDiffuse )
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
#endif`,vE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,bE=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,SE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ME=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,EE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,TE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,AE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,RE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,CE=`#if defined( USE_POINTS_UV )
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
#endif`,PE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,IE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,LE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,DE=`#if defined( USE_MORPHCOLORS )
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
#endif`,NE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,UE=`#ifdef USE_MORPHTARGETS
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
#endif`,FE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,OE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,BE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,kE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,GE=`#ifdef USE_NORMALMAP
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
#endif`,VE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,WE=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qE=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$E=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,XE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,YE=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,ZE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,jE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,JE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,KE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,QE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,t1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,e1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,n1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,i1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,s1=`float getShadowMask() {
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
}`,r1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,o1=`#ifdef USE_SKINNING
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
#endif`,a1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,l1=`#ifdef USE_SKINNING
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
#endif`,c1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,u1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,h1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,d1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,f1=`#ifdef USE_TRANSMISSION
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
#endif`,p1=`#ifdef USE_TRANSMISSION
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
#endif`,m1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,g1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,x1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,y1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,v1=`uniform sampler2D t2D;
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
}`,b1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,S1=`uniform float backgroundBlurriness;
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
}`,M1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,w1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,E1=`#include <common>
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
}`,T1=`#if DEPTH_PACKING == 3200
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
}`,A1=`#define DISTANCE
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
}`,R1=`#define DISTANCE
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
}`,C1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,P1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,I1=`uniform float scale;
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
}`,L1=`uniform vec3 diffuse;
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
}`,D1=`#include <common>
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
}`,N1=`uniform vec3 diffuse;
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
}`,U1=`#define LAMBERT
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
}`,F1=`#define LAMBERT
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
}`,O1=`#define MATCAP
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
}`,B1=`#define MATCAP
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
}`,k1=`#define NORMAL
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
}`,z1=`#define NORMAL
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
}`,H1=`#define PHONG
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
}`,G1=`#define PHONG
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
}`,V1=`#define STANDARD
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
}`,W1=`#define STANDARD
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
}`,q1=`#define TOON
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
}`,$1=`#define TOON
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
}`,X1=`uniform float size;
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
}`,Y1=`uniform vec3 diffuse;
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
}`,Z1=`#include <common>
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
}`,j1=`uniform vec3 color;
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
}`,J1=`uniform float rotation;
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
}`,K1=`uniform vec3 diffuse;
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
}`,xe={alphahash_fragment:vw,alphahash_pars_fragment:bw,alphamap_fragment:Sw,alphamap_pars_fragment:Mw,alphatest_fragment:ww,alphatest_pars_fragment:Ew,aomap_fragment:Tw,aomap_pars_fragment:Aw,batching_pars_vertex:Rw,batching_vertex:Cw,begin_vertex:Pw,beginnormal_vertex:Iw,bsdfs:Lw,iridescence_fragment:Dw,bumpmap_pars_fragment:Nw,clipping_planes_fragment:Uw,clipping_planes_pars_fragment:Fw,clipping_planes_pars_vertex:Ow,clipping_planes_vertex:Bw,color_fragment:kw,color_pars_fragment:zw,color_pars_vertex:Hw,color_vertex:Gw,common:Vw,defaultnormal_vertex:Ww,displacementmap_pars_vertex:qw,displacementmap_vertex:$w,emissivemap_fragment:Xw,emissivemap_pars_fragment:Yw,colorspace_fragment:Zw,colorspace_pars_fragment:jw,envmap_fragment:Jw,envmap_common_pars_fragment:Kw,envmap_pars_fragment:Qw,envmap_pars_vertex:tE,envmap_physical_pars_fragment:hE,envmap_vertex:eE,fog_vertex:nE,fog_pars_vertex:iE,fog_fragment:sE,fog_pars_fragment:rE,gradientmap_pars_fragment:oE,lightmap_pars_fragment:aE,lights_lambert_fragment:lE,lights_lambert_pars_fragment:cE,lights_pars_begin:uE,lights_toon_fragment:dE,lights_toon_pars_fragment:fE,lights_phong_fragment:pE,lights_phong_pars_fragment:mE,lights_physical_fragment:gE,lights_physical_pars_fragment:_E,lights_fragment_begin:xE,lights_fragment_maps:yE,lights_fragment_end:vE,lightprobes_pars_fragment:bE,logdepthbuf_fragment:SE,logdepthbuf_pars_fragment:ME,logdepthbuf_pars_vertex:wE,logdepthbuf_vertex:EE,map_fragment:TE,map_pars_fragment:AE,map_particle_fragment:RE,map_particle_pars_fragment:CE,metalnessmap_fragment:PE,metalnessmap_pars_fragment:IE,morphinstance_vertex:LE,morphcolor_vertex:DE,morphnormal_vertex:NE,morphtarget_pars_vertex:UE,morphtarget_vertex:FE,normal_fragment_begin:OE,normal_fragment_maps:BE,normal_pars_fragment:kE,normal_pars_vertex:zE,normal_vertex:HE,normalmap_pars_fragment:GE,clearcoat_normal_fragment_begin:VE,clearcoat_normal_fragment_maps:WE,clearcoat_pars_fragment:qE,iridescence_pars_fragment:$E,opaque_fragment:XE,packing:YE,premultiplied_alpha_fragment:ZE,project_vertex:jE,dithering_fragment:JE,dithering_pars_fragment:KE,roughnessmap_fragment:QE,roughnessmap_pars_fragment:t1,shadowmap_pars_fragment:e1,shadowmap_pars_vertex:n1,shadowmap_vertex:i1,shadowmask_pars_fragment:s1,skinbase_vertex:r1,skinning_pars_vertex:o1,skinning_vertex:a1,skinnormal_vertex:l1,specularmap_fragment:c1,specularmap_pars_fragment:u1,tonemapping_fragment:h1,tonemapping_pars_fragment:d1,transmission_fragment:f1,transmission_pars_fragment:p1,uv_pars_fragment:m1,uv_pars_vertex:g1,uv_vertex:_1,worldpos_vertex:x1,background_vert:y1,background_frag:v1,backgroundCube_vert:b1,backgroundCube_frag:S1,cube_vert:M1,cube_frag:w1,depth_vert:E1,depth_frag:T1,distance_vert:A1,distance_frag:R1,equirect_vert:C1,equirect_frag:P1,linedashed_vert:I1,linedashed_frag:L1,meshbasic_vert:D1,meshbasic_frag:N1,meshlambert_vert:U1,meshlambert_frag:F1,meshmatcap_vert:O1,meshmatcap_frag:B1,meshnormal_vert:k1,meshnormal_frag:z1,meshphong_vert:H1,meshphong_frag:G1,meshphysical_vert:V1,meshphysical_frag:W1,meshtoon_vert:q1,meshtoon_frag:$1,points_vert:X1,points_frag:Y1,shadow_vert:Z1,shadow_frag:j1,sprite_vert:J1,sprite_frag:K1},Ot={common:{diffuse:{value:new ee(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ee(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ee(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new ee(16777215)},opacity:{value:1},center:{value:new qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},Xs={basic:{uniforms:oi([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:xe.meshbasic_vert,fragmentShader:xe.meshbasic_frag},lambert:{uniforms:oi([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},envMapIntensity:{value:1}}]),vertexShader:xe.meshlambert_vert,fragmentShader:xe.meshlambert_frag},phong:{uniforms:oi([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},specular:{value:new ee(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:xe.meshphong_vert,fragmentShader:xe.meshphong_frag},standard:{uniforms:oi([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:xe.meshphysical_vert,fragmentShader:xe.meshphysical_frag},toon:{uniforms:oi([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new ee(0)}}]),vertexShader:xe.meshtoon_vert,fragmentShader:xe.meshtoon_frag},matcap:{uniforms:oi([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:xe.meshmatcap_vert,fragmentShader:xe.meshmatcap_frag},points:{uniforms:oi([Ot.points,Ot.fog]),vertexShader:xe.points_vert,fragmentShader:xe.points_frag},dashed:{uniforms:oi([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:xe.linedashed_vert,fragmentShader:xe.linedashed_frag},depth:{uniforms:oi([Ot.common,Ot.displacementmap]),vertexShader:xe.depth_vert,fragmentShader:xe.depth_frag},normal:{uniforms:oi([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:xe.meshnormal_vert,fragmentShader:xe.meshnormal_frag},sprite:{uniforms:oi([Ot.sprite,Ot.fog]),vertexShader:xe.sprite_vert,fragmentShader:xe.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:xe.background_vert,fragmentShader:xe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:xe.backgroundCube_vert,fragmentShader:xe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:xe.cube_vert,fragmentShader:xe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:xe.equirect_vert,fragmentShader:xe.equirect_frag},distance:{uniforms:oi([Ot.common,Ot.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:xe.distance_vert,fragmentShader:xe.distance_frag},shadow:{uniforms:oi([Ot.lights,Ot.fog,{color:{value:new ee(0)},opacity:{value:1}}]),vertexShader:xe.shadow_vert,fragmentShader:xe.shadow_frag}};Xs.physical={uniforms:oi([Xs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ce},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new ee(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new ee(0)},specularColor:{value:new ee(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:xe.meshphysical_vert,fragmentShader:xe.meshphysical_frag};var ed={r:0,b:0,g:0},Q1=new be,Ax=new ce;Ax.set(-1,0,0,0,1,0,0,0,1);function tT(n,t,e,i,s,r){let o=new ee(0),a=s===!0?0:1,c,l,u=null,h=0,d=null;function f(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let v=x.backgroundBlurriness>0;w=t.get(w,v)}return w}function g(x){let w=!1,v=f(x);v===null?p(o,a):v&&v.isColor&&(p(v,1),w=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,w){let v=f(w);v&&v.isCubeTexture?(l===void 0&&(l=new bn(new ss(1,1,1),new rs({name:"BackgroundCubeMaterial",uniforms:Eo(Xs.backgroundCube.uniforms),vertexShader:Xs.backgroundCube.vertexShader,fragmentShader:Xs.backgroundCube.fragmentShader,side:Si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(A,T,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Q1.makeRotationFromEuler(w.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Ax),l.material.toneMapped=Te.getTransfer(v.colorSpace)!==Be,(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new bn(new Ql(2,2),new rs({name:"BackgroundMaterial",uniforms:Eo(Xs.background.uniforms),vertexShader:Xs.background.vertexShader,fragmentShader:Xs.background.fragmentShader,side:$r,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.toneMapped=Te.getTransfer(v.colorSpace)!==Be,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null))}function p(x,w){x.getRGB(ed,Kp(n)),e.buffers.color.setClear(ed.r,ed.g,ed.b,w,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:y,dispose:m}}function eT(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,B,V,O,$){let Z=!1,q=h(D,O,V,B);r!==q&&(r=q,l(r.object)),Z=f(D,O,V,$),Z&&g(D,O,V,$),$!==null&&t.update($,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,v(D,B,V,O),$!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get($).buffer))}function c(){return n.createVertexArray()}function l(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function h(D,B,V,O){let $=O.wireframe===!0,Z=i[B.id];Z===void 0&&(Z={},i[B.id]=Z);let q=D.isInstancedMesh===!0?D.id:0,ht=Z[q];ht===void 0&&(ht={},Z[q]=ht);let K=ht[V.id];K===void 0&&(K={},ht[V.id]=K);let tt=K[$];return tt===void 0&&(tt=d(c()),K[$]=tt),tt}function d(D){let B=[],V=[],O=[];for(let $=0;$<e;$++)B[$]=0,V[$]=0,O[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:O,object:D,attributes:{},index:null}}function f(D,B,V,O){let $=r.attributes,Z=B.attributes,q=0,ht=V.getAttributes();for(let K in ht)if(ht[K].location>=0){let rt=$[K],pt=Z[K];if(pt===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(pt=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(pt=D.instanceColor)),rt===void 0||rt.attribute!==pt||pt&&rt.data!==pt.data)return!0;q++}return r.attributesNum!==q||r.index!==O}function g(D,B,V,O){let $={},Z=B.attributes,q=0,ht=V.getAttributes();for(let K in ht)if(ht[K].location>=0){let rt=Z[K];rt===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(rt=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(rt=D.instanceColor));let pt={};pt.attribute=rt,rt&&rt.data&&(pt.data=rt.data),$[K]=pt,q++}r.attributes=$,r.attributesNum=q,r.index=O}function y(){let D=r.newAttributes;for(let B=0,V=D.length;B<V;B++)D[B]=0}function p(D){m(D,0)}function m(D,B){let V=r.newAttributes,O=r.enabledAttributes,$=r.attributeDivisors;V[D]=1,O[D]===0&&(n.enableVertexAttribArray(D),O[D]=1),$[D]!==B&&(n.vertexAttribDivisor(D,B),$[D]=B)}function x(){let D=r.newAttributes,B=r.enabledAttributes;for(let V=0,O=B.length;V<O;V++)B[V]!==D[V]&&(n.disableVertexAttribArray(V),B[V]=0)}function w(D,B,V,O,$,Z,q){q===!0?n.vertexAttribIPointer(D,B,V,$,Z):n.vertexAttribPointer(D,B,V,O,$,Z)}function v(D,B,V,O){y();let $=O.attributes,Z=V.getAttributes(),q=B.defaultAttributeValues;for(let ht in Z){let K=Z[ht];if(K.location>=0){let tt=$[ht];if(tt===void 0&&(ht==="instanceMatrix"&&D.instanceMatrix&&(tt=D.instanceMatrix),ht==="instanceColor"&&D.instanceColor&&(tt=D.instanceColor)),tt!==void 0){let rt=tt.normalized,pt=tt.itemSize,ft=t.get(tt);if(ft===void 0)continue;let et=ft.buffer,yt=ft.type,St=ft.bytesPerElement,Lt=yt===n.INT||yt===n.UNSIGNED_INT||tt.gpuType===gh;if(tt.isInterleavedBufferAttribute){let At=tt.data,jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,de=tt.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Xt=0;Xt<K.locationSize;Xt++)m(K.location+Xt,At.meshPerAttribute);D.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Xt=0;Xt<K.locationSize;Xt++)p(K.location+Xt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Xt=0;Xt<K.locationSize;Xt++)w(K.location+Xt,pt/K.locationSize,yt,rt,jt*St,(de+pt/K.locationSize*Xt)*St,Lt)}else{if(tt.isInstancedBufferAttribute){for(let At=0;At<K.locationSize;At++)m(K.location+At,tt.meshPerAttribute);D.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let At=0;At<K.locationSize;At++)p(K.location+At);n.bindBuffer(n.ARRAY_BUFFER,et);for(let At=0;At<K.locationSize;At++)w(K.location+At,pt/K.locationSize,yt,rt,pt*St,pt/K.locationSize*At*St,Lt)}}else if(q!==void 0){let rt=q[ht];if(rt!==void 0)switch(rt.length){case 2:n.vertexAttrib2fv(K.location,rt);break;case 3:n.vertexAttrib3fv(K.location,rt);break;case 4:n.vertexAttrib4fv(K.location,rt);break;default:n.vertexAttrib1fv(K.location,rt)}}}}x()}function A(){L();for(let D in i){let B=i[D];for(let V in B){let O=B[V];for(let $ in O){let Z=O[$];for(let q in Z)u(Z[q].object),delete Z[q];delete O[$]}}delete i[D]}}function T(D){if(i[D.id]===void 0)return;let B=i[D.id];for(let V in B){let O=B[V];for(let $ in O){let Z=O[$];for(let q in Z)u(Z[q].object),delete Z[q];delete O[$]}}delete i[D.id]}function _(D){for(let B in i){let V=i[B];for(let O in V){let $=V[O];if($[D.id]===void 0)continue;let Z=$[D.id];for(let q in Z)u(Z[q].object),delete Z[q];delete $[D.id]}}}function b(D){for(let B in i){let V=i[B],O=D.isInstancedMesh===!0?D.id:0,$=V[O];if($!==void 0){for(let Z in $){let q=$[Z];for(let ht in q)u(q[ht].object),delete q[ht];delete $[Z]}delete V[O],Object.keys(V).length===0&&delete i[B]}}}function L(){I(),o=!0,r!==s&&(r=s,l(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:I,dispose:A,releaseStatesOfGeometry:T,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function nT(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,u){u!==0&&(n.drawArraysInstanced(i,c,l,u),e.update(l,i,u))}function a(c,l,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,u);let d=0;for(let f=0;f<u;f++)d+=l[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function iT(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ws&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Ms&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==$i&&_!==as&&!b&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",u=c(l);u!==l&&(Qt("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&Qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&Qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:v,maxSamples:A,samples:T}}function sT(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ei,a=new ce,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,m=n.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):l();else{let x=r?0:i,w=x*4,v=m.clippingState||null;c.value=v,v=u(g,d,w,f);for(let A=0;A!==w;++A)v[A]=e[A];m.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,g){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=c.value,g!==!0||p===null){let m=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<m)&&(p=new Float32Array(m));for(let w=0,v=f;w!==y;++w,v+=4)o.copy(h[w]).applyMatrix4(x,a),o.normal.toArray(p,v),p[v+3]=o.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var pc=class extends Vi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new $l(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ss(5,5,5),r=new rs({name:"CubemapFromEquirect",uniforms:Eo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Si,blending:bo});r.uniforms.tEquirect.value=e;let o=new bn(s,r),a=e.minFilter;return e.minFilter===dr&&(e.minFilter=xi),new Pa(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},rx=256,rT=3,oT=20,Rx=256,Cx=16,aT=3,lT=new k,cT=new ee,id=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Pa(1,10,null),this._boxMesh=new bn(new ss(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=lT}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,g=c.autoClearStencil,y=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(t.background=c.getClearColor(cT));let p=new Pa(i,s,u);return p.position.copy(a),p.update(c,t),c.autoClear=h,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=g,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=lx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ax(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(rx,Zp(t))}_fromTexture(t,e){t.mapping===Mo||t.mapping===Na?this._setSize(t.image.length===0?rx:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=ox(t,!1,!1),i=Math.log2(t)-rT;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ox(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Mo||t.mapping===Na?(this._cubemapMaterial===null&&(this._cubemapMaterial=lx()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ax()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=uT(),this._integrationMaterial=hT());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Cx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-aT)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(Rx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=dT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function ox(n,t,e){return new pc(n,{minFilter:dr,generateMipmaps:t,type:Ms,colorSpace:Ll,depthBuffer:e})}function mc(n,t,e){return new rs({name:n,uniforms:t,vertexShader:xe.cube_vert,fragmentShader:e,side:Si,blending:bo,depthTest:!1,depthWrite:!1})}function uT(){return mc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Rx}u

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
	`)}function hT(){return mc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Cx}},`

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
	`)}function dT(){return mc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${oT}
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
	`)}function ax(){return mc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function lx(){return mc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function fT(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===fh||f===ph)if(t.has(d)){let g=t.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new pc(g.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",l),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===fh||f===ph,y=f===Mo||f===Na;if(g||y){let p=e.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new id(n)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return g&&x&&x.height>0||y&&x&&c(x)?(i===null&&(i=new id(n)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function a(d,f){return f===fh?d.mapping=Mo:f===ph&&(d.mapping=Na),d}function c(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function l(d){let f=d.target;f.removeEventListener("dispose",l);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function pT(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Rl("WebGLRenderer: "+i+" extension not supported."),s}}}function mT(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(g){let y=g.attributes;for(let p in y)t.update(y[p],n.ARRAY_BUFFER)}function h(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,w=p.count>=65535?Hl:zl,v=new w(Math.ceil(x/3)*6,1),A=v.array;if(y!==null){let _=y.array;m=y.version;for(let b=0,L=0;b<x;b+=3){let I=_[b+0],D=_[b+1],B=_[b+2];A[L++]=I,A[L++]=D,A[L++]=D,A[L++]=B,A[L++]=B,A[L++]=I}}else{m=p.version;for(let _=0,b=0;_<x;_+=3){let L=_+0,I=_+1,D=_+2;A[b++]=L,A[b++]=I,A[b++]=I,A[b++]=D,A[b++]=D,A[b++]=L}}v.version=m;let T=r.get(g);T&&t.remove(T),r.set(g,v)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&c(y)}}return{get:l,update:u,getWireframeAttribute:d,dispose:f}}function gT(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function c(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function l(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function _T(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ie("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function xT(n,t,e){let i=new WeakMap,s=new dn;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let L=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",L)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],w=0;f===!0&&(w=1),g===!0&&(w=2),y===!0&&(w=3);let v=a.attributes.position.count*w,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let T=new Float32Array(v*A*4*h),_=new Ol(T,v,A,h);_.type=as,_.needsUpdate=!0;let b=w*4;for(let I=0;I<h;I++){let D=p[I],B=m[I],V=x[I],O=v*A*4*I;for(let $=0;$<D.count;$++){let Z=$*b;f===!0&&(s.fromBufferAttribute(D,$),T[O+Z+0]=s.x,T[O+Z+1]=s.y,T[O+Z+2]=s.z,T[O+Z+3]=0),g===!0&&(s.fromBufferAttribute(B,$),T[O+Z+4]=s.x,T[O+Z+5]=s.y,T[O+Z+6]=s.z,T[O+Z+7]=0),y===!0&&(s.fromBufferAttribute(V,$),T[O+Z+8]=s.x,T[O+Z+9]=s.y,T[O+Z+10]=s.z,T[O+Z+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new qt(v,A)},i.set(a,d),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<l.length;y++)f+=l[y];let g=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(n,"morphTargetBaseInfluence",g),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function yT(n,t,e,i,s){let r=new WeakMap;function o(l){let u=s.render.frame,h=l.geometry,d=t.get(l,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var vT={[Tp]:"LINEAR_TONE_MAPPING",[Ap]:"REINHARD_TONE_MAPPING",[Rp]:"CINEON_TONE_MAPPING",[Cp]:"ACES_FILMIC_TONE_MAPPING",[Ip]:"AGX_TONE_MAPPING",[Lp]:"NEUTRAL_TONE_MAPPING",[Pp]:"CUSTOM_TONE_MAPPING"};function bT(n,t,e,i,s,r){let o=new Vi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new Pe;u.setAttribute("position",new Ae([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ae([0,2,0,0,2,0],2));let h=new Ku({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new bn(u,h),f=new hh(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,x=null,w=[],v=!1;this.setSize=function(A,T){o.setSize(A,T),a!==null&&a.setSize(A,T),c!==null&&c.setSize(A,T);for(let _=0;_<w.length;_++){let b=w[_];b.setSize&&b.setSize(A,T)}},this.setEffects=function(A){w=A,v=w.length>0&&w[0].isRenderPass===!0;let T=o.width,_=o.height;w.length>0&&a===null&&(a=new Vi(T,_,{type:Ms,depthBuffer:!1,stencilBuffer:!1}),c=new Vi(T,_,{type:Ms,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&w.some(L=>L.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&l===null&&(l=new hr(T,_),r===!0&&(l.format=fr,l.type=wo)),o.dispose(),o.depthTexture=b?l:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let L=0;L<w.length;L++){let I=w[L];I.setSize&&I.setSize(T,_),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(l)}},this.begin=function(A,T){if(p||A.toneMapping===qs&&w.length===0)return!1;if(x=T,T!==null){let _=T.width,b=T.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return v===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=qs,!0},this.hasRenderPass=function(){return v},this.end=function(A,T){A.toneMapping=m,p=!0;let _=o,b=a;for(let L=0;L<w.length;L++){let I=w[L];I.enabled!==!1&&(I.render(A,b,_,T),I.needsSwap!==!1&&(_=b,b=b===a?c:a))}if(g!==A.outputColorSpace||y!==A.toneMapping){g=A.outputColorSpace,y=A.toneMapping,h.defines={},Te.getTransfer(g)===Be&&(h.defines.SRGB_TRANSFER="");let L=vT[y];L&&(h.defines[L]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(x),A.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),h.dispose()}}var Px=new yi,Ix=new hr(1,1),Lx=new Yl(1),Dx=new Ol,Nx=new Xu,Ux=new $l,cx=[],ux=[],hx=new Float32Array(16),dx=new Float32Array(9),fx=new Float32Array(4);function Oa(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=cx[s];if(r===void 0&&(r=new Float32Array(s),cx[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function On(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Bn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function rd(n,t){let e=ux[t];e===void 0&&(e=new Int32Array(t),ux[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function ST(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function MT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(On(e,t))return;n.uniform2fv(this.addr,t),Bn(e,t)}}function wT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(On(e,t))return;n.uniform3fv(this.addr,t),Bn(e,t)}}function ET(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(On(e,t))return;n.uniform4fv(this.addr,t),Bn(e,t)}}function TT(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(On(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Bn(e,t)}else{if(On(e,i))return;fx.set(i),n.uniformMatrix2fv(this.addr,!1,fx),Bn(e,i)}}function AT(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(On(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Bn(e,t)}else{if(On(e,i))return;dx.set(i),n.uniformMatrix3fv(this.addr,!1,dx),Bn(e,i)}}function RT(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(On(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Bn(e,t)}else{if(On(e,i))return;hx.set(i),n.uniformMatrix4fv(this.addr,!1,hx),Bn(e,i)}}function CT(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function PT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(On(e,t))return;n.uniform2iv(this.addr,t),Bn(e,t)}}function IT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(On(e,t))return;n.uniform3iv(this.addr,t),Bn(e,t)}}function LT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(On(e,t))return;n.uniform4iv(this.addr,t),Bn(e,t)}}function DT(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function NT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(On(e,t))return;n.uniform2uiv(this.addr,t),Bn(e,t)}}function UT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(On(e,t))return;n.uniform3uiv(this.addr,t),Bn(e,t)}}function FT(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(On(e,t))return;n.uniform4uiv(this.addr,t),Bn(e,t)}}function od(n){return n.version===0&&(n.compareFunction=qp,n.needsUpdate=!0),n}function OT(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=od(Ix):r=Px,e.setTexture2D(t||r,s)}function BT(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Nx,s)}function kT(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=od(Lx):r=Ux,e.setTextureCube(t||r,s)}function zT(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Dx,s)}function HT(n){switch(n){case 5126:return ST;case 35664:return MT;case 35665:return wT;case 35666:return ET;case 35674:return TT;case 35675:return AT;case 35676:return RT;case 5124:case 35670:return CT;case 35667:case 35671:return PT;case 35668:case 35672:return IT;case 35669:case 35673:return LT;case 5125:return DT;case 36294:return NT;case 36295:return UT;case 36296:return FT;case 35678:case 36198:case 36298:case 36306:case 35682:return OT;case 35679:case 36299:case 36307:return BT;case 35680:case 36300:case 36308:case 36293:return kT;case 36289:case 36303:case 36311:case 36292:return zT}}function GT(n,t){n.uniform1fv(this.addr,t)}function VT(n,t){let e=Oa(t,this.size,2);n.uniform2fv(this.addr,e)}function WT(n,t){let e=Oa(t,this.size,3);n.uniform3fv(this.addr,e)}function qT(n,t){let e=Oa(t,this.size,4);n.uniform4fv(this.addr,e)}function $T(n,t){let e=Oa(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function XT(n,t){let e=Oa(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function YT(n,t){let e=Oa(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function ZT(n,t){n.uniform1iv(this.addr,t)}function jT(n,t){n.uniform2iv(this.addr,t)}function JT(n,t){n.uniform3iv(this.addr,t)}function KT(n,t){n.uniform4iv(this.addr,t)}function QT(n,t){n.uniform1uiv(this.addr,t)}function tA(n,t){n.uniform2uiv(this.addr,t)}function eA(n,t){n.uniform3uiv(this.addr,t)}function nA(n,t){n.uniform4uiv(this.addr,t)}function iA(n,t,e){let i=this.cache,s=t.length,r=rd(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=od(Ix):o=Px;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function sA(n,t,e){let i=this.cache,s=t.length,r=rd(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Nx,r[o])}function rA(n,t,e){let i=this.cache,s=t.length,r=rd(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=od(Lx):o=Ux;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function oA(n,t,e){let i=this.cache,s=t.length,r=rd(e,s);On(i,r)||(n.uniform1iv(this.addr,r),Bn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Dx,r[o])}function aA(n){switch(n){case 5126:return GT;case 35664:return VT;case 35665:return WT;case 35666:return qT;case 35674:return $T;case 35675:return XT;case 35676:return YT;case 5124:case 35670:return ZT;case 35667:case 35671:return jT;case 35668:case 35672:return JT;case 35669:case 35673:return KT;case 5125:return QT;case 36294:return tA;case 36295:return eA;case 36296:return nA;case 35678:case 36198:case 36298:case 36306:case 35682:return iA;case 35679:case 36299:case 36307:return sA;case 35680:case 36300:case 36308:case 36293:return rA;case 36289:case 36303:case 36311:case 36292:return oA}}var sm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=HT(e.type)}},rm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=aA(e.type)}},om=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},nm=/(\w+)(\])?(\[|\.)?/g;function px(n,t){n.seq.push(t),n.map[t.id]=t}function lA(n,t,e){let i=n.name,s=i.length;for(nm.lastIndex=0;;){let r=nm.exec(i),o=nm.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){px(e,l===void 0?new sm(a,n,t):new rm(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new om(a),px(e,h)),e=h}}}var Fa=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);lA(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function mx(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var cA=37297,uA=0;function hA(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var gx=new ce;function dA(n){Te._getMatrix(gx,Te.workingColorSpace,n);let t=`mat3( ${gx.elements.map(e=>e.toFixed(4))} )`;switch(Te.getTransfer(n)){case Dl:return[t,"LinearTransferOETF"];case Be:return[t,"sRGBTransferOETF"];default:return Qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function _x(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+hA(n.getShaderSource(t),a)}else return r}function fA(n,t){let e=dA(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var pA={[Tp]:"Linear",[Ap]:"Reinhard",[Rp]:"Cineon",[Cp]:"ACESFilmic",[Ip]:"AgX",[Lp]:"Neutral",[Pp]:"Custom"};function mA(n,t){let e=pA[t];return e===void 0?(Qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var nd=new k;function gA(){Te.getLuminanceCoefficients(nd);let n=nd.x.toFixed(4),t=nd.y.toFixed(4),e=nd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function _A(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(fc).join(`
`)}function xA(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function yA(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function fc(n){return n!==""}function xx(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function yx(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var vA=/^[ \t]*#include +<([\w\d./]+)>/gm;function am(n){return n.replace(vA,bA)}function bA(n,t){let e=xe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return am(e)}var SA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vx(n){return n.replace(SA,MA)}function MA(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function bx(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var wA={[sc]:"SHADOWMAP_TYPE_PCF",[La]:"SHADOWMAP_TYPE_VSM"};function EA(n){return wA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var TA={[Na]:"ENVMAP_MODE_REFRACTION"};function AA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":TA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var RA={[Ep]:"ENVMAP_BLENDING_MULTIPLY",[k_]:"ENVMAP_BLENDING_MIX",[z_]:"ENVMAP_BLENDING_ADD"};function CA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":RA[n.combine]||"ENVMAP_BLENDING_NONE"}function PA(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=EA(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=AA(e),h=CA(e),d=_A(e),f=xA(r),g=s.createProgram(),y,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(fc).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(fc).join(`
`),p.length>0&&(p+=`
`)):(y=[bx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(fc).join(`
`),p=[bx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==qs?"#define TONE_MAPPING":"",e.toneMapping!==qs?xe.tonemapping_pars_fragment:"",e.toneMapping!==qs?mA("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",xe.colorspace_pars_fragment,fA("linearToOutputTexel",e.outputColorSpace),gA(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(fc).join(`
`)),o=am(o),o=xx(o,e),o=yx(o,e),a=am(a),a=xx(a,e),a=yx(a,e),o=vx(o),a=vx(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===Xp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Xp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=m+y+o,w=m+p+a,v=mx(s,s.VERTEX_SHADER,x),A=mx(s,s.FRAGMENT_SHADER,w);s.attachShader(g,v),s.attachShader(g,A),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(I){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(v)||"",V=s.getShaderInfoLog(A)||"",O=D.trim(),$=B.trim(),Z=V.trim(),q=!0,ht=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(q=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,v,A);else{let K=_x(s,v,"vertex"),tt=_x(s,A,"fragment");ie("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+O+`
`+K+`
`+tt)}else O!==""?Qt("WebGLProgram: Program Info Log:",O):($===""||Z==="")&&(ht=!1);ht&&(I.diagnostics={runnable:q,programLog:O,vertexShader:{log:$,prefix:y},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(v),s.deleteShader(A),_=new Fa(s,g),b=yA(s,g)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let b;this.getAttributes=function(){return b===void 0&&T(this),b};let L=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,cA)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=uA++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=A,this}var IA=0,lm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new cm(t),e.set(t,i)),i}},cm=class{constructor(t){this.id=IA++,this.code=t,this.usedTimes=0}};function LA(n){return n===Xr||n===uc||n===hc}function DA(n,t,e,i,s,r){let o=new wa,a=new lm,c=new Set,l=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function g(_,b,L,I,D,B){let V=I.fog,O=D.geometry,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?I.environment:null,Z=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,q=t.get(_.envMap||$,Z),ht=d[_.type],K=i.precision;_.precision!==null&&(K=i.getMaxPrecision(_.precision),K!==_.precision&&Qt("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let tt=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,rt=tt!==void 0?tt.length:0,pt=0;O.morphAttributes.position!==void 0&&(pt=1),O.morphAttributes.normal!==void 0&&(pt=2),O.morphAttributes.color!==void 0&&(pt=3);let ft,et,yt,St;if(ht){let Dt=Xs[ht];ft=Dt.vertexShader,et=Dt.fragmentShader}else{ft=_.vertexShader,et=_.fragmentShader;let Dt=a.getVertexShaderStage(_),me=a.getFragmentShaderStage(_);a.update(_,Dt,me),yt=Dt.id,St=me.id}let Lt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),jt=D.isInstancedMesh===!0,de=D.isBatchedMesh===!0,Xt=!!_.map,ye=!!_.matcap,ge=!!q,ue=ge&&q.isPMREMTexture===!0,ln=!!_.aoMap,Qe=!!_.lightMap,Tn=!!_.bumpMap&&_.wireframe===!1,qe=!!_.normalMap,qn=!!_.displacementMap,Ce=!!_.emissiveMap,Un=!!_.metalnessMap,fn=!!_.roughnessMap,An=_.anisotropy>0,H=_.clearcoat>0,Nt=_.diffuseRoughness>0,te=_.dispersion>0,fe=_.retroreflectivity>0,Rt=_.iridescence>0,Ye=_.sheen>0,$t=_.transmission>0,Kt=An&&!!_.anisotropyMap,N=H&&!!_.clearcoatMap,R=H&&!!_.clearcoatNormalMap,X=H&&!!_.clearcoatRoughnessMap,dt=Nt&&!!_.diffuseRoughnessMap,at=Rt&&!!_.iridescenceMap,bt=Rt&&!!_.iridescenceThicknessMap,Mt=Ye&&!!_.sheenColorMap,nt=Ye&&!!_.sheenRoughnessMap,st=!!_.specularMap,_t=!!_.specularColorMap,z=!!_.specularIntensityMap,ot=$t&&!!_.transmissionMap,it=$t&&!!_.thicknessMap,Ct=!!_.gradientMap,vt=!!_.alphaMap,Tt=_.alphaTest>0,Yt=!!_.alphaHash,se=!!_.extensions,ut=qs;_.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(ut=n.toneMapping);let Gt=ue?q.isCompressedCubeTexture?q.image[0].mipmaps:q.mipmaps:null,re={shaderID:ht,shaderType:_.type,shaderName:_.name,vertexShader:ft,fragmentShader:et,defines:_.defines,customVertexShaderID:yt,customFragmentShaderID:St,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:de,batchingColor:de&&D._colorsTexture!==null,instancing:jt,instancingColor:jt&&D.instanceColor!==null,instancingMorph:jt&&D.morphTexture!==null,outputColorSpace:Lt===null?n.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:Te.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Xt,matcap:ye,envMap:ge,envMapMode:ge&&q.mapping,envMapPMREM:ue,envMapMaxLod:ue?Gt.length-1:null,envMapSize:ue?Gt[0].width:null,aoMap:ln,lightMap:Qe,bumpMap:Tn,normalMap:qe,displacementMap:qn,emissiveMap:Ce,normalMapObjectSpace:qe&&_.normalMapType===V_,normalMapTangentSpace:qe&&_.normalMapType===zp,packedNormalMap:qe&&_.normalMapType===zp&&LA(_.normalMap.format),metalnessMap:Un,roughnessMap:fn,anisotropy:An,anisotropyMap:Kt,clearcoat:H,clearcoatMap:N,clearcoatNormalMap:R,clearcoatRoughnessMap:X,diffuseRoughness:Nt,diffuseRoughnessMap:dt,dispersion:te,retroreflection:fe,iridescence:Rt,iridescenceMap:at,iridescenceThicknessMap:bt,sheen:Ye,sheenColorMap:Mt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:_t,specularIntensityMap:z,transmission:$t,transmissionMap:ot,thicknessMap:it,gradientMap:Ct,opaque:_.transparent===!1&&_.blending===Da&&_.alphaToCoverage===!1,alphaMap:vt,alphaTest:Tt,alphaHash:Yt,combine:_.combine,mapUv:Xt&&f(_.map.channel),aoMapUv:ln&&f(_.aoMap.channel),lightMapUv:Qe&&f(_.lightMap.channel),bumpMapUv:Tn&&f(_.bumpMap.channel),normalMapUv:qe&&f(_.normalMap.channel),displacementMapUv:qn&&f(_.displacementMap.channel),emissiveMapUv:Ce&&f(_.emissiveMap.channel),metalnessMapUv:Un&&f(_.metalnessMap.channel),roughnessMapUv:fn&&f(_.roughnessMap.channel),anisotropyMapUv:Kt&&f(_.anisotropyMap.channel),clearcoatMapUv:N&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:bt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:Mt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(_.sheenRoughnessMap.channel),specularMapUv:st&&f(_.specularMap.channel),specularColorMapUv:_t&&f(_.specularColorMap.channel),specularIntensityMapUv:z&&f(_.specularIntensityMap.channel),transmissionMapUv:ot&&f(_.transmissionMap.channel),thicknessMapUv:it&&f(_.thicknessMap.channel),alphaMapUv:vt&&f(_.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(qe||An),vertexNormals:!!O.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!O.attributes.uv&&(Xt||vt),fog:!!V,useFog:_.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||O.attributes.normal===void 0&&qe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:pt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:ut,decodeVideoTexture:Xt&&_.map.isVideoTexture===!0&&Te.getTransfer(_.map.colorSpace)===Be,decodeVideoTextureEmissive:Ce&&_.emissiveMap.isVideoTexture===!0&&Te.getTransfer(_.emissiveMap.colorSpace)===Be,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===os,flipSided:_.side===Si,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:se&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(se&&_.extensions.multiDraw===!0||de)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return re.vertexUv1s=c.has(1),re.vertexUv2s=c.has(2),re.vertexUv3s=c.has(3),c.clear(),re}function y(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let L in _.defines)b.push(L),b.push(_.defines[L]);return _.isRawShaderMaterial===!1&&(p(b,_),m(b,_),b.push(n.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function p(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function m(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let b=d[_.type],L;if(b){let I=Xs[b];L=nx.clone(I.uniforms)}else L=_.uniforms;return L}function w(_,b){let L=u.get(b);return L!==void 0?++L.usedTimes:(L=new PA(n,b,_,s),l.push(L),u.set(b,L)),L}function v(_){if(--_.usedTimes===0){let b=l.indexOf(_);l[b]=l[l.length-1],l.pop(),u.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:w,releaseProgram:v,releaseShaderCache:A,programs:l,dispose:T}}function NA(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function UA(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Sx(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Mx(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=g,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=p,x.group=m),t++,x}function c(d,f,g,y,p,m,x){x.reversedDepth===!0&&(p=-p);let w=a(d,f,g,y,p,m);g.transmission>0?i.push(w):g.transparent===!0?s.push(w):e.push(w)}function l(d,f,g,y,p,m){let x=a(d,f,g,y,p,m);g.transmission>0?i.unshift(x):g.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||UA),i.length>1&&i.sort(f||Sx),s.length>1&&s.sort(f||Sx)}function h(){for(let d=t,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:h,sort:u}}function FA(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Mx,n.set(i,[o])):s>=r.length?(o=new Mx,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function OA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new k,color:new ee};break;case"SpotLight":e={position:new k,direction:new k,color:new ee,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new k,color:new ee,distance:0,decay:0};break;case"HemisphereLight":e={direction:new k,skyColor:new ee,groundColor:new ee};break;case"RectAreaLight":e={color:new ee,position:new k,halfWidth:new k,halfHeight:new k};break}return n[t.id]=e,e}}}function BA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var kA=0;function zA(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function HA(n){let t=new OA,e=BA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new k);let s=new k,r=new be,o=new be;function a(l){let u=0,h=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,x=0,w=0,v=0,A=0,T=0,_=0,b=0,L=0,I=0;l.sort(zA);for(let B=0,V=l.length;B<V;B++){let O=l[B],$=O.color,Z=O.intensity,q=O.distance,ht=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===Xr?ht=O.shadow.map.texture:ht=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)u+=$.r*Z,h+=$.g*Z,d+=$.b*Z;else if(O.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(O.sh.coefficients[K],Z);I++}else if(O.isSunLight){let K=t.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let tt=O.shadow,rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),i.sunShadow[g]=rt,i.sunShadowMap[g]=ht;let pt=tt.getViewportCount();for(let ft=0;ft<pt;ft++)i.sunShadowMatrix[y+ft]=tt.getMatrix(ft),i.sunShadowCascade[y+ft]=tt._cascadeData[ft];y+=pt,g++}i.sun[f]=K,f++}else if(O.isDirectionalLight){let K=t.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let tt=O.shadow,rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,i.directionalShadow[p]=rt,i.directionalShadowMap[p]=ht,i.directionalShadowMatrix[p]=O.shadow.matrix,A++}i.directional[p]=K,p++}else if(O.isSpotLight){let K=t.get(O);K.position.setFromMatrixPosition(O.matrixWorld),K.color.copy($).multiplyScalar(Z),K.distance=q,K.coneCos=Math.cos(O.angle),K.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),K.decay=O.decay,i.spot[x]=K;let tt=O.shadow;if(O.map&&(i.spotLightMap[b]=O.map,b++,tt.updateMatrices(O),O.castShadow&&L++),i.spotLightMatrix[x]=tt.matrix,O.castShadow){let rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,i.spotShadow[x]=rt,i.spotShadowMap[x]=ht,_++}x++}else if(O.isRectAreaLight){let K=t.get(O);K.color.copy($).multiplyScalar(Z),K.halfWidth.set(O.width*.5,0,0),K.halfHeight.set(0,O.height*.5,0),i.rectArea[w]=K,w++}else if(O.isPointLight){let K=t.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),K.distance=O.distance,K.decay=O.decay,O.castShadow){let tt=O.shadow,rt=e.get(O);rt.shadowIntensity=tt.intensity,rt.shadowBias=tt.bias,rt.shadowNormalBias=tt.normalBias,rt.shadowRadius=tt.radius,rt.shadowMapSize=tt.mapSize,rt.shadowCameraNear=tt.camera.near,rt.shadowCameraFar=tt.camera.far,i.pointShadow[m]=rt,i.pointShadowMap[m]=ht,i.pointShadowMatrix[m]=O.shadow.matrix,T++}i.point[m]=K,m++}else if(O.isHemisphereLight){let K=t.get(O);K.skyColor.copy(O.color).multiplyScalar(Z),K.groundColor.copy(O.groundColor).multiplyScalar(Z),i.hemi[v]=K,v++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ot.LTC_FLOAT_1,i.rectAreaLTC2=Ot.LTC_FLOAT_2):(i.rectAreaLTC1=Ot.LTC_HALF_1,i.rectAreaLTC2=Ot.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==x||D.rectAreaLength!==w||D.hemiLength!==v||D.numSunShadows!==g||D.numDirectionalShadows!==A||D.numPointShadows!==T||D.numSpotShadows!==_||D.numSpotMaps!==b||D.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=p,i.spot.length=x,i.rectArea.length=w,i.point.length=m,i.hemi.length=v,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+b-L,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=I,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=x,D.rectAreaLength=w,D.hemiLength=v,D.numSunShadows=g,D.numDirectionalShadows=A,D.numPointShadows=T,D.numSpotShadows=_,D.numSpotMaps=b,D.numLightProbes=I,i.version=kA++)}function c(l,u){let h=0,d=0,f=0,g=0,y=0,p=0,m=u.matrixWorldInverse;for(let x=0,w=l.length;x<w;x++){let v=l[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),d++}else if(v.isSpotLight){let A=i.spot[g];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),g++}else if(v.isRectAreaLight){let A=i.rectArea[y];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let A=i.hemi[p];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),p++}}}return{setup:a,setupView:c,state:i}}function wx(n){let t=new HA(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function c(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function l(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function GA(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new wx(n),t.set(s,[a])):r>=o.length?(a=new wx(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var VA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,WA=`uniform sampler2D shadow_pass;
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
}`,qA=[new k(1,0,0),new k(-1,0,0),new k(0,1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1)],$A=[new k(0,-1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1),new k(0,-1,0),new k(0,-1,0)],Ex=new be,dc=new k,im=new k;function XA(n,t,e){let i=new go,s=new qt,r=new qt,o=new dn,a=new Qu,c=new th,l={},u=e.maxTextureSize,h={[$r]:Si,[Si]:$r,[os]:os},d=new rs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qt},radius:{value:4}},vertexShader:VA,fragmentShader:WA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Pe;g.setAttribute("position",new Ze(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new bn(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=sc;let m=this.type;this.render=function(T,_,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===v_&&(Qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=sc);let L=n.getRenderTarget(),I=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),B=n.state;B.setBlending(bo),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=m!==this.type;V&&_.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach($=>$.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,$=T.length;O<$;O++){let Z=T[O],q=Z.shadow;if(q===void 0){Qt("WebGLShadowMap:",Z,"has no shadow.");continue}if(q.autoUpdate===!1&&q.needsUpdate===!1)continue;s.copy(q.mapSize);let ht=q.getFrameExtents();s.multiply(ht),r.copy(q.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,q.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,q.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(q.camera._reversedDepth=K,q.map===null||V===!0){if(q.map!==null&&(q.map.depthTexture!==null&&(q.map.depthTexture.dispose(),q.map.depthTexture=null),q.map.dispose()),this.type===La){if(Z.isPointLight){Qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}q.map=new Vi(s.x,s.y,{format:Xr,type:Ms,minFilter:xi,magFilter:xi,generateMipmaps:!1}),q.map.texture.name=Z.name+".shadowMap",q.map.depthTexture=new hr(s.x,s.y,as),q.map.depthTexture.name=Z.name+".shadowMapDepth",q.map.depthTexture.format=cr,q.map.depthTexture.compareFunction=null,q.map.depthTexture.minFilter=Kn,q.map.depthTexture.magFilter=Kn}else Z.isPointLight?(q.map=new pc(s.x),q.map.depthTexture=new Yl(s.x,Ss)):(q.map=new Vi(s.x,s.y),q.map.depthTexture=new hr(s.x,s.y,Ss)),q.map.depthTexture.name=Z.name+".shadowMap",q.map.depthTexture.format=cr,this.type===sc?(q.map.depthTexture.compareFunction=K?Wp:Vp,q.map.depthTexture.minFilter=xi,q.map.depthTexture.magFilter=xi):(q.map.depthTexture.compareFunction=null,q.map.depthTexture.minFilter=Kn,q.map.depthTexture.magFilter=Kn);q.camera.updateProjectionMatrix()}q.map.isWebGLCubeRenderTarget!==!0&&(q.map.width!==s.x||q.map.height!==s.y)&&q.map.setSize(s.x,s.y);let tt=q.map.isWebGLCubeRenderTarget?6:q.getViewportCount();Z.isPointLight!==!0&&q.updateMatrices(Z,b);let rt=(q.camera.layers.mask&4294967294)!==0?q.camera.layers:b.layers;for(let pt=0;pt<tt;pt++){let ft=q.getCamera(pt);if(Z.isPointLight){let et=q.camera,yt=q.matrix,St=Z.distance||et.far;St!==et.far&&(et.far=St,et.updateProjectionMatrix()),dc.setFromMatrixPosition(Z.matrixWorld),et.position.copy(dc),im.copy(et.position),im.add(qA[pt]),et.up.copy($A[pt]),et.lookAt(im),et.updateMatrixWorld(),yt.makeTranslation(-dc.x,-dc.y,-dc.z),Ex.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),q._frustum.setFromProjectionMatrix(Ex,et.coordinateSystem,et.reversedDepth)}if(q.map.isWebGLCubeRenderTarget)n.setRenderTarget(q.map,pt),n.clear();else{pt===0&&(n.setRenderTarget(q.map),n.clear());let et=q.getViewport(pt);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),B.viewport(o)}i=q.getFrustum(pt),v(_,b,ft,Z,rt,this.type)}q.isPointLightShadow!==!0&&this.type===La&&x(q,b),q.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(L,I,D)};function x(T,_){let b=t.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new Vi(s.x,s.y,{format:Xr,type:Ms}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(_,null,b,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(_,null,b,f,y,null)}function w(T,_,b,L){let I=null,D=b.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(D!==void 0)I=D;else if(I=b.isPointLight===!0?c:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let B=I.uuid,V=_.uuid,O=l[B];O===void 0&&(O={},l[B]=O);let $=O[V];$===void 0&&($=I.clone(),O[V]=$,_.addEventListener("dispose",A)),I=$}if(I.visible=_.visible,I.wireframe=_.wireframe,L===La?I.side=_.shadowSide!==null?_.shadowSide:_.side:I.side=_.shadowSide!==null?_.shadowSide:h[_.side],I.alphaMap=_.alphaMap,I.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,I.map=_.map,I.clipShadows=_.clipShadows,I.clippingPlanes=_.clippingPlanes,I.clipIntersection=_.clipIntersection,I.displacementMap=_.displacementMap,I.displacementScale=_.displacementScale,I.displacementBias=_.displacementBias,I.wireframeLinewidth=_.wireframeLinewidth,I.linewidth=_.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=n.properties.get(I);B.light=b}return I}function v(T,_,b,L,I,D){if(T.visible===!1)return;if(T.layers.test(I)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&D===La)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,T.matrixWorld);let O=t.update(T),$=T.material;if(Array.isArray($)){let Z=O.groups;for(let q=0,ht=Z.length;q<ht;q++){let K=Z[q],tt=$[K.materialIndex];if(tt&&tt.visible){let rt=w(T,tt,L,D);T.onBeforeShadow(n,T,_,b,O,rt,K),n.renderBufferDirect(b,null,O,rt,T,K),T.onAfterShadow(n,T,_,b,O,rt,K)}}}else if($.visible){let Z=w(T,$,L,D);T.onBeforeShadow(n,T,_,b,O,Z,null),n.renderBufferDirect(b,null,O,Z,T,null),T.onAfterShadow(n,T,_,b,O,Z,null)}}let V=T.children;for(let O=0,$=V.length;O<$;O++)v(V[O],_,b,L,I,D)}function A(T){T.target.removeEventListener("dispose",A);for(let b in l){let L=l[b],I=T.target.uuid;I in L&&(L[I].dispose(),delete L[I])}}}function YA(n,t){function e(){let z=!1,ot=new dn,it=null,Ct=new dn(0,0,0,0);return{setMask:function(vt){it!==vt&&!z&&(n.colorMask(vt,vt,vt,vt),it=vt)},setLocked:function(vt){z=vt},setClear:function(vt,Tt,Yt,se,ut){ut===!0&&(vt*=se,Tt*=se,Yt*=se),ot.set(vt,Tt,Yt,se),Ct.equals(ot)===!1&&(n.clearColor(vt,Tt,Yt,se),Ct.copy(ot))},reset:function(){z=!1,it=null,Ct.set(-1,0,0,0)}}}function i(){let z=!1,ot=!1,it=null,Ct=null,vt=null;return{setReversed:function(Tt){if(ot!==Tt){let Yt=t.get("EXT_clip_control");Tt?Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.ZERO_TO_ONE_EXT):Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.NEGATIVE_ONE_TO_ONE_EXT),ot=Tt;let se=vt;vt=null,this.setClear(se)}},getReversed:function(){return ot},setTest:function(Tt){Tt?At(n.DEPTH_TEST):jt(n.DEPTH_TEST)},setMask:function(Tt){it!==Tt&&!z&&(n.depthMask(Tt),it=Tt)},setFunc:function(Tt){if(ot&&(Tt=Q_[Tt]),Ct!==Tt){switch(Tt){case Uu:n.depthFunc(n.NEVER);break;case Fu:n.depthFunc(n.ALWAYS);break;case Ou:n.depthFunc(n.LESS);break;case va:n.depthFunc(n.LEQUAL);break;case Bu:n.depthFunc(n.EQUAL);break;case ku:n.depthFunc(n.GEQUAL);break;case zu:n.depthFunc(n.GREATER);break;case Hu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ct=Tt}},setLocked:function(Tt){z=Tt},setClear:function(Tt){vt!==Tt&&(vt=Tt,ot&&(Tt=1-Tt),n.clearDepth(Tt))},reset:function(){z=!1,it=null,Ct=null,vt=null,ot=!1}}}function s(){let z=!1,ot=null,it=null,Ct=null,vt=null,Tt=null,Yt=null,se=null,ut=null;return{setTest:function(Gt){z||(Gt?At(n.STENCIL_TEST):jt(n.STENCIL_TEST))},setMask:function(Gt){ot!==Gt&&!z&&(n.stencilMask(Gt),ot=Gt)},setFunc:function(Gt,re,Dt){(it!==Gt||Ct!==re||vt!==Dt)&&(n.stencilFunc(Gt,re,Dt),it=Gt,Ct=re,vt=Dt)},setOp:function(Gt,re,Dt){(Tt!==Gt||Yt!==re||se!==Dt)&&(n.stencilOp(Gt,re,Dt),Tt=Gt,Yt=re,se=Dt)},setLocked:function(Gt){z=Gt},setClear:function(Gt){ut!==Gt&&(n.clearStencil(Gt),ut=Gt)},reset:function(){z=!1,ot=null,it=null,Ct=null,vt=null,Tt=null,Yt=null,se=null,ut=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,w=null,v=null,A=null,T=null,_=null,b=new ee(0,0,0),L=0,I=!1,D=null,B=null,V=null,O=null,$=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,ht=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(K)[1]),q=ht>=1):K.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),q=ht>=2);let tt=null,rt={},pt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),et=new dn().fromArray(pt),yt=new dn().fromArray(ft);function St(z,ot,it,Ct){let vt=new Uint8Array(4),Tt=n.createTexture();n.bindTexture(z,Tt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Yt=0;Yt<it;Yt++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,Ct,0,n.RGBA,n.UNSIGNED_BYTE,vt):n.texImage2D(ot+Yt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,vt);return Tt}let Lt={};Lt[n.TEXTURE_2D]=St(n.TEXTURE_2D,n.TEXTURE_2D,1),Lt[n.TEXTURE_CUBE_MAP]=St(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[n.TEXTURE_2D_ARRAY]=St(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Lt[n.TEXTURE_3D]=St(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(va),Tn(!1),qe(yp),At(n.CULL_FACE),ln(bo);function At(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function jt(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function de(z,ot){return d[z]!==ot?(n.bindFramebuffer(z,ot),d[z]=ot,z===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=ot),z===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function Xt(z,ot){let it=g,Ct=!1;if(z){it=f.get(ot),it===void 0&&(it=[],f.set(ot,it));let vt=z.textures;if(it.length!==vt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Tt=0,Yt=vt.length;Tt<Yt;Tt++)it[Tt]=n.COLOR_ATTACHMENT0+Tt;it.length=vt.length,Ct=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Ct=!0);Ct&&n.drawBuffers(it)}function ye(z){return y!==z?(n.useProgram(z),y=z,!0):!1}let ge={[So]:n.FUNC_ADD,[S_]:n.FUNC_SUBTRACT,[M_]:n.FUNC_REVERSE_SUBTRACT};ge[w_]=n.MIN,ge[E_]=n.MAX;let ue={[T_]:n.ZERO,[A_]:n.ONE,[R_]:n.SRC_COLOR,[Mp]:n.SRC_ALPHA,[N_]:n.SRC_ALPHA_SATURATE,[L_]:n.DST_COLOR,[P_]:n.DST_ALPHA,[C_]:n.ONE_MINUS_SRC_COLOR,[wp]:n.ONE_MINUS_SRC_ALPHA,[D_]:n.ONE_MINUS_DST_COLOR,[I_]:n.ONE_MINUS_DST_ALPHA,[U_]:n.CONSTANT_COLOR,[F_]:n.ONE_MINUS_CONSTANT_COLOR,[O_]:n.CONSTANT_ALPHA,[B_]:n.ONE_MINUS_CONSTANT_ALPHA};function ln(z,ot,it,Ct,vt,Tt,Yt,se,ut,Gt){if(z===bo){p===!0&&(jt(n.BLEND),p=!1);return}if(p===!1&&(At(n.BLEND),p=!0),z!==b_){if(z!==m||Gt!==I){if((x!==So||A!==So)&&(n.blendEquation(n.FUNC_ADD),x=So,A=So),Gt)switch(z){case Da:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case vp:n.blendFunc(n.ONE,n.ONE);break;case bp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Sp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ie("WebGLState: Invalid blending: ",z);break}else switch(z){case Da:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case vp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case bp:ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Sp:ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ie("WebGLState: Invalid blending: ",z);break}w=null,v=null,T=null,_=null,b.set(0,0,0),L=0,m=z,I=Gt}return}vt=vt||ot,Tt=Tt||it,Yt=Yt||Ct,(ot!==x||vt!==A)&&(n.blendEquationSeparate(ge[ot],ge[vt]),x=ot,A=vt),(it!==w||Ct!==v||Tt!==T||Yt!==_)&&(n.blendFuncSeparate(ue[it],ue[Ct],ue[Tt],ue[Yt]),w=it,v=Ct,T=Tt,_=Yt),(se.equals(b)===!1||ut!==L)&&(n.blendColor(se.r,se.g,se.b,ut),b.copy(se),L=ut),m=z,I=!1}function Qe(z,ot){z.side===os?jt(n.CULL_FACE):At(n.CULL_FACE);let it=z.side===Si;ot&&(it=!it),Tn(it),z.blending===Da&&z.transparent===!1?ln(bo):ln(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Ct=z.stencilWrite;a.setTest(Ct),Ct&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),Ce(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Tn(z){D!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),D=z)}function qe(z){z!==x_?(At(n.CULL_FACE),z!==B&&(z===yp?n.cullFace(n.BACK):z===y_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):jt(n.CULL_FACE),B=z}function qn(z){z!==V&&(q&&n.lineWidth(z),V=z)}function Ce(z,ot,it){z?(At(n.POLYGON_OFFSET_FILL),(O!==ot||$!==it)&&(O=ot,$=it,o.getReversed()&&(ot=-ot,it=-it),n.polygonOffset(ot,it))):jt(n.POLYGON_OFFSET_FILL)}function Un(z){z?At(n.SCISSOR_TEST):jt(n.SCISSOR_TEST)}function fn(z){z===void 0&&(z=n.TEXTURE0+Z-1),tt!==z&&(n.activeTexture(z),tt=z)}function An(z,ot,it){it===void 0&&(tt===null?it=n.TEXTURE0+Z-1:it=tt);let Ct=rt[it];Ct===void 0&&(Ct={type:void 0,texture:void 0},rt[it]=Ct),(Ct.type!==z||Ct.texture!==ot)&&(tt!==it&&(n.activeTexture(it),tt=it),n.bindTexture(z,ot||Lt[z]),Ct.type=z,Ct.texture=ot)}function H(){let z=rt[tt];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function te(){try{n.compressedTexImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function fe(){try{n.texSubImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function Rt(){try{n.texSubImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function Ye(){try{n.compressedTexSubImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function $t(){try{n.compressedTexSubImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function Kt(){try{n.texStorage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function N(){try{n.texStorage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function R(){try{n.texImage2D(...arguments)}catch(z){ie("WebGLState:",z)}}function X(){try{n.texImage3D(...arguments)}catch(z){ie("WebGLState:",z)}}function dt(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function at(z,ot){h[z]!==ot&&(n.pixelStorei(z,ot),h[z]=ot)}function bt(z){et.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),et.copy(z))}function Mt(z){yt.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),yt.copy(z))}function nt(z,ot){let it=l.get(ot);it===void 0&&(it=new WeakMap,l.set(ot,it));let Ct=it.get(z);Ct===void 0&&(Ct=n.getUniformBlockIndex(ot,z.name),n.uniformBlockBinding(ot,Ct,Ct),it.set(z,Ct))}function st(z,ot,it){let vt=l.get(ot).get(z);c[vt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,vt,it),c[vt]=it)}function _t(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},tt=null,rt={},d={},c={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,w=null,v=null,A=null,T=null,_=null,b=new ee(0,0,0),L=0,I=!1,D=null,B=null,V=null,O=null,$=null,et.set(0,0,n.canvas.width,n.canvas.height),yt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:jt,bindFramebuffer:de,drawBuffers:Xt,useProgram:ye,setBlending:ln,setMaterial:Qe,setFlipSided:Tn,setCullFace:qe,setLineWidth:qn,setPolygonOffset:Ce,setScissorTest:Un,activeTexture:fn,bindTexture:An,unbindTexture:H,compressedTexImage2D:Nt,compressedTexImage3D:te,texImage2D:R,texImage3D:X,pixelStorei:at,getParameter:dt,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Kt,texStorage3D:N,texSubImage2D:fe,texSubImage3D:Rt,compressedTexSubImage2D:Ye,compressedTexSubImage3D:$t,scissor:bt,viewport:Mt,reset:_t}}function ZA(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new qt,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(N=>g.delete(N)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(N,R){return p?new OffscreenCanvas(N,R):Ul("canvas")}function x(N,R,X){let dt=1,at=Kt(N);if((at.width>X||at.height>X)&&(dt=X/Math.max(at.width,at.height)),dt<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let bt=Math.floor(dt*at.width),Mt=Math.floor(dt*at.height);d===void 0&&(d=m(bt,Mt));let nt=R?m(bt,Mt):d;return nt.width=bt,nt.height=Mt,nt.getContext("2d").drawImage(N,0,0,bt,Mt),Qt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+bt+"x"+Mt+")."),nt}else return"data"in N&&Qt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),N;return N}function w(N){return N.generateMipmaps}function v(N){n.generateMipmap(N)}function A(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(N,R,X,dt,at,bt=!1){if(N!==null){if(n[N]!==void 0)return n[N];Qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let Mt;dt&&(Mt=t.get("EXT_texture_norm16"),Mt||Qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=R;if(R===n.RED&&(X===n.FLOAT&&(nt=n.R32F),X===n.HALF_FLOAT&&(nt=n.R16F),X===n.UNSIGNED_BYTE&&(nt=n.R8),X===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.R16_EXT),X===n.SHORT&&Mt&&(nt=Mt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.R8UI),X===n.UNSIGNED_SHORT&&(nt=n.R16UI),X===n.UNSIGNED_INT&&(nt=n.R32UI),X===n.BYTE&&(nt=n.R8I),X===n.SHORT&&(nt=n.R16I),X===n.INT&&(nt=n.R32I)),R===n.RG&&(X===n.FLOAT&&(nt=n.RG32F),X===n.HALF_FLOAT&&(nt=n.RG16F),X===n.UNSIGNED_BYTE&&(nt=n.RG8),X===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.RG16_EXT),X===n.SHORT&&Mt&&(nt=Mt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RG8UI),X===n.UNSIGNED_SHORT&&(nt=n.RG16UI),X===n.UNSIGNED_INT&&(nt=n.RG32UI),X===n.BYTE&&(nt=n.RG8I),X===n.SHORT&&(nt=n.RG16I),X===n.INT&&(nt=n.RG32I)),R===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),X===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),X===n.UNSIGNED_INT&&(nt=n.RGB32UI),X===n.BYTE&&(nt=n.RGB8I),X===n.SHORT&&(nt=n.RGB16I),X===n.INT&&(nt=n.RGB32I)),R===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),X===n.UNSIGNED_INT&&(nt=n.RGBA32UI),X===n.BYTE&&(nt=n.RGBA8I),X===n.SHORT&&(nt=n.RGBA16I),X===n.INT&&(nt=n.RGBA32I)),R===n.RGB&&(X===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.RGB16_EXT),X===n.SHORT&&Mt&&(nt=Mt.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),R===n.RGBA){let st=bt?Dl:Te.getTransfer(at);X===n.FLOAT&&(nt=n.RGBA32F),X===n.HALF_FLOAT&&(nt=n.RGBA16F),X===n.UNSIGNED_BYTE&&(nt=st===Be?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&Mt&&(nt=Mt.RGBA16_EXT),X===n.SHORT&&Mt&&(nt=Mt.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function _(N,R){let X;return N?R===null||R===Ss||R===wo?X=n.DEPTH24_STENCIL8:R===as?X=n.DEPTH32F_STENCIL8:R===Ua&&(X=n.DEPTH24_STENCIL8,Qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Ss||R===wo?X=n.DEPTH_COMPONENT24:R===as?X=n.DEPTH_COMPONENT32F:R===Ua&&(X=n.DEPTH_COMPONENT16),X}function b(N,R){return w(N)===!0||N.isFramebufferTexture&&N.minFilter!==Kn&&N.minFilter!==xi?Math.log2(Math.max(R.width,R.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?R.mipmaps.length:1}function L(N){let R=new WeakRef(N);i.get(N).__ref=R,g.add(R),y.register(N,R,R)}function I(N){let R=i.get(N).__ref;R!==void 0&&(g.delete(R),y.unregister(R))}function D(N){V(N.target)}function B(N){O(N.target)}function V(N){N.removeEventListener("dispose",D),I(N),Z(N),N.isVideoTexture&&u.delete(N),N.isHTMLTexture&&h.delete(N)}function O(N){N.removeEventListener("dispose",B),I(N),ht(N)}function $(){for(let N of g){let R=N.deref();R!==void 0&&(R.isRenderTarget===!0?O(R):V(R))}g.clear(),h.clear()}function Z(N){let R=i.get(N);if(R.__webglInit===void 0)return;let X=N.source,dt=f.get(X);if(dt){let at=dt[R.__cacheKey];at.usedTimes--,at.usedTimes===0&&q(N),Object.keys(dt).length===0&&f.delete(X)}i.remove(N)}function q(N){let R=i.get(N);n.deleteTexture(R.__webglTexture);let X=N.source,dt=f.get(X);delete dt[R.__cacheKey],o.memory.textures--}function ht(N){let R=i.get(N);R.__depthDisposeCallback&&R.__depthDisposeCallback();let X=N.depthTexture;if(X&&X.renderTarget===N&&V(X),N.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(R.__webglFramebuffer[at]))for(let bt=0;bt<R.__webglFramebuffer[at].length;bt++)n.deleteFramebuffer(R.__webglFramebuffer[at][bt]);else n.deleteFramebuffer(R.__webglFramebuffer[at]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[at])}else{if(Array.isArray(R.__webglFramebuffer))for(let at=0;at<R.__webglFramebuffer.length;at++)n.deleteFramebuffer(R.__webglFramebuffer[at]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let at=0;at<R.__webglColorRenderbuffer.length;at++)R.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[at]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let dt=N.textures;for(let at=0,bt=dt.length;at<bt;at++){let Mt=i.get(dt[at]);Mt.__webglTexture&&(n.deleteTexture(Mt.__webglTexture),o.memory.textures--),i.remove(dt[at])}i.remove(N)}let K=0;function tt(){K=0}function rt(){return K}function pt(N){K=N}function ft(){let N=K;return N>=s.maxTextures&&Qt("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,N}function et(N){let R=[];return R.push(N.wrapS),R.push(N.wrapT),R.push(N.wrapR||0),R.push(N.magFilter),R.push(N.minFilter),R.push(N.anisotropy),R.push(N.internalFormat),R.push(N.format),R.push(N.type),R.push(N.generateMipmaps),R.push(N.mipmapsAutoUpdate),R.push(N.premultiplyAlpha),R.push(N.flipY),R.push(N.unpackAlignment),R.push(N.colorSpace),R.join()}function yt(N,R){let X=i.get(N);if(N.isVideoTexture&&Ye(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&X.__version!==N.version){let dt=N.image;if(dt===null)Qt("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)Qt("WebGLRenderer: Texture marked for update but image is incomplete");else{Qe(X,N,R);return}}else N.isExternalTexture&&(X.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+R)}function St(N,R){let X=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&X.__version!==N.version){Qe(X,N,R);return}else N.isExternalTexture&&(X.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+R)}function Lt(N,R){let X=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&X.__version!==N.version){Qe(X,N,R);return}e.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+R)}function At(N,R){let X=i.get(N);if(N.version>0&&X.__version!==N.version){Tn(X,N,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+R)}let jt={[Gu]:n.REPEAT,[Gs]:n.CLAMP_TO_EDGE,[Vu]:n.MIRRORED_REPEAT},de={[Kn]:n.NEAREST,[H_]:n.NEAREST_MIPMAP_NEAREST,[rc]:n.NEAREST_MIPMAP_LINEAR,[xi]:n.LINEAR,[mh]:n.LINEAR_MIPMAP_NEAREST,[dr]:n.LINEAR_MIPMAP_LINEAR},Xt={[q_]:n.NEVER,[qp]:n.ALWAYS,[$_]:n.LESS,[Vp]:n.LEQUAL,[X_]:n.EQUAL,[Wp]:n.GEQUAL,[Y_]:n.GREATER,[Z_]:n.NOTEQUAL};function ye(N,R){if(R.type===as&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===xi||R.magFilter===mh||R.magFilter===rc||R.magFilter===dr||R.minFilter===xi||R.minFilter===mh||R.minFilter===rc||R.minFilter===dr)&&Qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,jt[R.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,jt[R.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,jt[R.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,de[R.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,de[R.minFilter]),R.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Xt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Kn||R.minFilter!==rc&&R.minFilter!==dr||R.type===as&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");n.texParameterf(N,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ge(N,R){let X=!1;N.__webglInit===void 0&&(N.__webglInit=!0,R.addEventListener("dispose",D),L(R));let dt=R.source,at=f.get(dt);at===void 0&&(at={},f.set(dt,at));let bt=et(R);if(bt!==N.__cacheKey){at[bt]===void 0&&(at[bt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),at[bt].usedTimes++;let Mt=at[N.__cacheKey];Mt!==void 0&&(at[N.__cacheKey].usedTimes--,Mt.usedTimes===0&&q(R)),N.__cacheKey=bt,N.__webglTexture=at[bt].texture}return X}function ue(N,R,X){return Math.floor(Math.floor(N/X)/R)}function ln(N,R,X,dt){let bt=N.updateRanges;if(bt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,X,dt,R.data);else{bt.sort((z,ot)=>z.start-ot.start);let Mt=0;for(let z=1;z<bt.length;z++){let ot=bt[Mt],it=bt[z],Ct=ot.start+ot.count,vt=ue(it.start,R.width,4),Tt=ue(ot.start,R.width,4);it.start<=Ct+1&&vt===Tt&&ue(it.start+it.count-1,R.width,4)===vt?ot.count=Math.max(ot.count,it.start+it.count-ot.start):(++Mt,bt[Mt]=it)}bt.length=Mt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),_t=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let z=0,ot=bt.length;z<ot;z++){let it=bt[z],Ct=Math.floor(it.start/4),vt=Math.ceil(it.count/4),Tt=Ct%R.width,Yt=Math.floor(Ct/R.width),se=vt,ut=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Tt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Yt),e.texSubImage2D(n.TEXTURE_2D,0,Tt,Yt,se,ut,X,dt,R.data)}N.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,_t)}}function Qe(N,R,X){let dt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(dt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(dt=n.TEXTURE_3D);let at=ge(N,R),bt=R.source;e.bindTexture(dt,N.__webglTexture,n.TEXTURE0+X);let Mt=i.get(bt);if(bt.version!==Mt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let ut=Te.getPrimaries(Te.workingColorSpace),Gt=R.colorSpace===pr?null:Te.getPrimaries(R.colorSpace),re=R.colorSpace===pr||ut===Gt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let st=x(R.image,!1,s.maxTextureSize);st=$t(R,st);let _t=r.convert(R.format,R.colorSpace),z=r.convert(R.type),ot=T(R.internalFormat,_t,z,R.normalized,R.colorSpace,R.isVideoTexture);ye(dt,R);let it,Ct=R.mipmaps,vt=R.isVideoTexture!==!0,Tt=Mt.__version===void 0||at===!0,Yt=bt.dataReady,se=b(R,st);if(R.isDepthTexture)ot=_(R.format===fr,R.type),Tt&&(vt?e.texStorage2D(n.TEXTURE_2D,1,ot,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,ot,st.width,st.height,0,_t,z,null));else if(R.isDataTexture)if(Ct.length>0){vt&&Tt&&e.texStorage2D(n.TEXTURE_2D,se,ot,Ct[0].width,Ct[0].height);for(let ut=0,Gt=Ct.length;ut<Gt;ut++)it=Ct[ut],vt?Yt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,it.width,it.height,_t,z,it.data):e.texImage2D(n.TEXTURE_2D,ut,ot,it.width,it.height,0,_t,z,it.data);R.generateMipmaps=!1}else vt?(Tt&&e.texStorage2D(n.TEXTURE_2D,se,ot,st.width,st.height),Yt&&ln(R,st,_t,z)):e.texImage2D(n.TEXTURE_2D,0,ot,st.width,st.height,0,_t,z,st.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){vt&&Tt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,se,ot,Ct[0].width,Ct[0].height,st.depth);for(let ut=0,Gt=Ct.length;ut<Gt;ut++)if(it=Ct[ut],R.format!==ws)if(_t!==null)if(vt){if(Yt)if(R.layerUpdates.size>0){let re=em(it.width,it.height,R.format,R.type);for(let Dt of R.layerUpdates){let me=it.data.subarray(Dt*re/it.data.BYTES_PER_ELEMENT,(Dt+1)*re/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,Dt,it.width,it.height,1,_t,me)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,_t,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,st.depth,0,it.data,0,0);else Qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else vt?Yt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,st.depth,_t,z,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ut,ot,it.width,it.height,st.depth,0,_t,z,it.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{vt&&Tt&&e.texStorage2D(n.TEXTURE_2D,se,ot,Ct[0].width,Ct[0].height);for(let ut=0,Gt=Ct.length;ut<Gt;ut++)it=Ct[ut],R.format!==ws?_t!==null?vt?Yt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ut,0,0,it.width,it.height,_t,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ut,ot,it.width,it.height,0,it.data):Qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):vt?Yt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,it.width,it.height,_t,z,it.data):e.texImage2D(n.TEXTURE_2D,ut,ot,it.width,it.height,0,_t,z,it.data)}else if(R.isDataArrayTexture)if(vt){if(Tt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,se,ot,st.width,st.height,st.depth),Yt)if(R.layerUpdates.size>0){let ut=em(st.width,st.height,R.format,R.type);for(let Gt of R.layerUpdates){let re=st.data.subarray(Gt*ut/st.data.BYTES_PER_ELEMENT,(Gt+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Gt,st.width,st.height,1,_t,z,re)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,_t,z,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,st.width,st.height,st.depth,0,_t,z,st.data);else if(R.isData3DTexture)vt?(Tt&&e.texStorage3D(n.TEXTURE_3D,se,ot,st.width,st.height,st.depth),Yt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,_t,z,st.data)):e.texImage3D(n.TEXTURE_3D,0,ot,st.width,st.height,st.depth,0,_t,z,st.data);else if(R.isFramebufferTexture){if(Tt)if(vt)e.texStorage2D(n.TEXTURE_2D,se,ot,st.width,st.height);else{let ut=st.width,Gt=st.height;for(let re=0;re<se;re++)e.texImage2D(n.TEXTURE_2D,re,ot,ut,Gt,0,_t,z,null),ut>>=1,Gt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let ut=n.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),h.add(R),ut.onpaint=Gt=>{let re=Gt.changedElements;for(let Dt of h)re.includes(Dt.image)&&(Dt.needsUpdate=!0)},ut.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let re=n.RGBA,Dt=n.RGBA,me=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,re,Dt,me,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ct.length>0){if(vt&&Tt){let ut=Kt(Ct[0]);e.texStorage2D(n.TEXTURE_2D,se,ot,ut.width,ut.height)}for(let ut=0,Gt=Ct.length;ut<Gt;ut++)it=Ct[ut],vt?Yt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,_t,z,it):e.texImage2D(n.TEXTURE_2D,ut,ot,_t,z,it);R.generateMipmaps=!1}else if(vt){if(Tt){let ut=Kt(st);e.texStorage2D(n.TEXTURE_2D,se,ot,ut.width,ut.height)}Yt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,_t,z,st)}else e.texImage2D(n.TEXTURE_2D,0,ot,_t,z,st);w(R)&&R.mipmapsAutoUpdate===!0&&v(dt),Mt.__version=bt.version,R.onUpdate&&R.onUpdate(R)}N.__version=R.version}function Tn(N,R,X){if(R.image.length!==6)return;let dt=ge(N,R),at=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+X);let bt=i.get(at);if(at.version!==bt.__version||dt===!0){e.activeTexture(n.TEXTURE0+X);let Mt=Te.getPrimaries(Te.workingColorSpace),nt=R.colorSpace===pr?null:Te.getPrimaries(R.colorSpace),st=R.colorSpace===pr||Mt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let _t=R.isCompressedTexture||R.image[0].isCompressedTexture,z=R.image[0]&&R.image[0].isDataTexture,ot=[];for(let Dt=0;Dt<6;Dt++)!_t&&!z?ot[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):ot[Dt]=z?R.image[Dt].image:R.image[Dt],ot[Dt]=$t(R,ot[Dt]);let it=ot[0],Ct=r.convert(R.format,R.colorSpace),vt=r.convert(R.type),Tt=T(R.internalFormat,Ct,vt,R.normalized,R.colorSpace),Yt=R.isVideoTexture!==!0,se=bt.__version===void 0||dt===!0,ut=at.dataReady,Gt=b(R,it);ye(n.TEXTURE_CUBE_MAP,R);let re;if(R.isDepthTexture){if(Tt=_(R.format===fr,R.type),se)if(Yt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Tt,it.width,it.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Tt,it.width,it.height,0,Ct,vt,null)}else if(_t){Yt&&se&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,Tt,it.width,it.height);for(let Dt=0;Dt<6;Dt++){re=ot[Dt].mipmaps;for(let me=0;me<re.length;me++){let tn=re[me];R.format!==ws?Ct!==null?Yt?ut&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,0,0,tn.width,tn.height,Ct,tn.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,Tt,tn.width,tn.height,0,tn.data):Qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,0,0,tn.width,tn.height,Ct,vt,tn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,Tt,tn.width,tn.height,0,Ct,vt,tn.data)}}}else{if(re=R.mipmaps,Yt&&se){re.length>0&&Gt++;let Dt=Kt(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,Tt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(z){Yt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,ot[Dt].width,ot[Dt].height,Ct,vt,ot[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Tt,ot[Dt].width,ot[Dt].height,0,Ct,vt,ot[Dt].data);for(let me=0;me<re.length;me++){let ci=re[me].image[Dt].image;Yt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,0,0,ci.width,ci.height,Ct,vt,ci.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,Tt,ci.width,ci.height,0,Ct,vt,ci.data)}}else{Yt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Ct,vt,ot[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Tt,Ct,vt,ot[Dt]);for(let me=0;me<re.length;me++){let tn=re[me];Yt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,0,0,Ct,vt,tn.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,Tt,Ct,vt,tn.image[Dt])}}}w(R)&&R.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),bt.__version=at.version,R.onUpdate&&R.onUpdate(R)}N.__version=R.version}function qe(N,R,X,dt,at,bt){let Mt=r.convert(X.format,X.colorSpace),nt=r.convert(X.type),st=T(X.internalFormat,Mt,nt,X.normalized,X.colorSpace),_t=i.get(R),z=i.get(X);if(z.__renderTarget=R,!_t.__hasExternalTextures){let ot=Math.max(1,R.width>>bt),it=Math.max(1,R.height>>bt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,bt,st,ot,it,R.depth,0,Mt,nt,null):e.texImage2D(at,bt,st,ot,it,0,Mt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,N),Rt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,dt,at,z.__webglTexture,0,fe(R)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,dt,at,z.__webglTexture,bt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function qn(N,R,X){if(n.bindRenderbuffer(n.RENDERBUFFER,N),R.depthBuffer){let dt=R.depthTexture,at=dt&&dt.isDepthTexture?dt.type:null,bt=_(R.stencilBuffer,at),Mt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Rt(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(R),bt,R.width,R.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(R),bt,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,bt,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Mt,n.RENDERBUFFER,N)}else{let dt=R.textures;for(let at=0;at<dt.length;at++){let bt=dt[at],Mt=r.convert(bt.format,bt.colorSpace),nt=r.convert(bt.type),st=T(bt.internalFormat,Mt,nt,bt.normalized,bt.colorSpace);Rt(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(R),st,R.width,R.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(R),st,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,st,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ce(N,R,X){let dt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,N),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(R.depthTexture);at.__renderTarget=R;let bt=dt?R.depthTexture.image[0]:R.depthTexture.image;(!at.__webglTexture||bt.width!==R.width||bt.height!==R.height)&&(bt.width=R.width,bt.height=R.height,R.depthTexture.needsUpdate=!0),dt?At(R.depthTexture,0):yt(R.depthTexture,0);let Mt=at.__webglTexture,nt=fe(R),st=dt?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,_t=R.depthTexture.format===fr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===cr)Rt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,st,Mt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,_t,st,Mt,0);else if(R.depthTexture.format===fr)Rt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,st,Mt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,_t,st,Mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Un(N){let R=i.get(N),X=N.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==N.depthTexture){let dt=N.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),dt){let at=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,dt.removeEventListener("dispose",at)};dt.addEventListener("dispose",at),R.__depthDisposeCallback=at}R.__boundDepthTexture=dt}if(N.depthTexture&&!R.__autoAllocateDepthBuffer)if(X)for(let dt=0;dt<6;dt++)Ce(R.__webglFramebuffer[dt],N,dt);else N.texture.mipmaps.length>0?Ce(R.__webglFramebuffer[0],N,0):Ce(R.__webglFramebuffer,N,0);else if(X){R.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[dt]),R.__webglDepthbuffer[dt]===void 0)R.__webglDepthbuffer[dt]=n.createRenderbuffer(),qn(R.__webglDepthbuffer[dt],N,!1);else{let at=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=R.__webglDepthbuffer[dt];n.bindRenderbuffer(n.RENDERBUFFER,bt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,bt)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),qn(R.__webglDepthbuffer,N,!1);else{let at=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,bt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,bt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function fn(N,R,X){let dt=i.get(N);R!==void 0&&qe(dt.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&Un(N)}function An(N){let R=N.texture,X=i.get(N),dt=i.get(R);N.addEventListener("dispose",B),L(N);let at=N.textures,bt=N.isWebGLCubeRenderTarget===!0,Mt=at.length>1;if(Mt||(dt.__webglTexture===void 0&&(dt.__webglTexture=n.createTexture()),dt.__version=R.version,o.memory.textures++),bt){X.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(R.mipmaps.length>0){X.__webglFramebuffer[nt]=[];for(let st=0;st<R.mipmaps.length;st++)X.__webglFramebuffer[nt][st]=n.createFramebuffer()}else X.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){X.__webglFramebuffer=[];for(let nt=0;nt<R.mipmaps.length;nt++)X.__webglFramebuffer[nt]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(Mt)for(let nt=0,st=at.length;nt<st;nt++){let _t=i.get(at[nt]);_t.__webglTexture===void 0&&(_t.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&Rt(N)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];X.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[nt]);let _t=r.convert(st.format,st.colorSpace),z=r.convert(st.type),ot=T(st.internalFormat,_t,z,st.normalized,st.colorSpace,N.isXRRenderTarget===!0),it=fe(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,ot,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,X.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),qn(X.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(bt){e.bindTexture(n.TEXTURE_CUBE_MAP,dt.__webglTexture),ye(n.TEXTURE_CUBE_MAP,R);for(let nt=0;nt<6;nt++)if(R.mipmaps.length>0)for(let st=0;st<R.mipmaps.length;st++)qe(X.__webglFramebuffer[nt][st],N,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else qe(X.__webglFramebuffer[nt],N,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);w(R)?v(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(Mt){for(let nt=0,st=at.length;nt<st;nt++){let _t=at[nt],z=i.get(_t),ot=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ot=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,z.__webglTexture),ye(ot,_t),qe(X.__webglFramebuffer,N,_t,n.COLOR_ATTACHMENT0+nt,ot,0),w(_t)&&v(ot)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(nt=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,dt.__webglTexture),ye(nt,R),R.mipmaps.length>0)for(let st=0;st<R.mipmaps.length;st++)qe(X.__webglFramebuffer[st],N,R,n.COLOR_ATTACHMENT0,nt,st);else qe(X.__webglFramebuffer,N,R,n.COLOR_ATTACHMENT0,nt,0);w(R)?v(nt):R.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&Un(N)}function H(N){let R=N.textures;for(let X=0,dt=R.length;X<dt;X++){let at=R[X];if(w(at)&&at.mipmapsAutoUpdate===!0){let bt=A(N),Mt=i.get(at).__webglTexture;e.bindTexture(bt,Mt),v(bt),e.unbindTexture()}}}let Nt=[];function te(N){if(N.samples>0){if(Rt(N)===!1){let R=N.textures,X=N.width,dt=N.height,at=n.COLOR_BUFFER_BIT,bt=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=i.get(N),nt=R.length>1;if(nt)for(let _t=0;_t<R.length;_t++)e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let _t=0;_t<R.length;_t++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[_t]);let z=i.get(R[_t]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,X,dt,0,0,X,dt,at,n.NEAREST),c===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+_t),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Nt.push(bt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let _t=0;_t<R.length;_t++){e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[_t]);let z=i.get(R[_t]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&c){let R=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function fe(N){return Math.min(s.maxSamples,N.samples)}function Rt(N){let R=i.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Ye(N){let R=o.render.frame;u.get(N)!==R&&(u.set(N,R),N.update())}function $t(N,R){let X=N.colorSpace,dt=N.format,at=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||X!==Ll&&X!==pr&&(Te.getTransfer(X)===Be?(dt!==ws||at!==$i)&&Qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ie("WebGLTextures: Unsupported texture color space:",X)),R}function Kt(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(l.width=N.naturalWidth||N.width,l.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(l.width=N.displayWidth,l.height=N.displayHeight):(l.width=N.width,l.height=N.height),l}this.allocateTextureUnit=ft,this.resetTextureUnits=tt,this.getTextureUnits=rt,this.setTextureUnits=pt,this.setTexture2D=yt,this.setTexture2DArray=St,this.setTexture3D=Lt,this.setTextureCube=At,this.rebindTextures=fn,this.setupRenderTarget=An,this.updateRenderTargetMipmap=H,this.updateMultisampleRenderTarget=te,this.setupDepthRenderbuffer=Un,this.setupFrameBufferTexture=qe,this.useMultisampledRTT=Rt,this.dispose=$}function jA(n,t){function e(i,s=pr){let r,o=Te.getTransfer(s);if(i===$i)return n.UNSIGNED_BYTE;if(i===_h)return n.UNSIGNED_SHORT_4_4_4_4;if(i===xh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Fp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Op)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Np)return n.BYTE;if(i===Up)return n.SHORT;if(i===Ua)return n.UNSIGNED_SHORT;if(i===gh)return n.INT;if(i===Ss)return n.UNSIGNED_INT;if(i===as)return n.FLOAT;if(i===Ms)return n.HALF_FLOAT;if(i===Bp)return n.ALPHA;if(i===kp)return n.RGB;if(i===ws)return n.RGBA;if(i===cr)return n.DEPTH_COMPONENT;if(i===fr)return n.DEPTH_STENCIL;if(i===yh)return n.RED;if(i===vh)return n.RED_INTEGER;if(i===Xr)return n.RG;if(i===bh)return n.RG_INTEGER;if(i===Sh)return n.RGBA_INTEGER;if(i===oc||i===ac||i===lc||i===cc)if(o===Be)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===oc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ac)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===lc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===cc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===oc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ac)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===lc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===cc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Mh||i===wh||i===Eh||i===Th)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Mh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===wh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Eh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Th)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ah||i===Rh||i===Ch||i===Ph||i===Ih||i===uc||i===Lh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ah||i===Rh)return o===Be?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ch)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ph)return r.COMPRESSED_R11_EAC;if(i===Ih)return r.COMPRESSED_SIGNED_R11_EAC;if(i===uc)return r.COMPRESSED_RG11_EAC;if(i===Lh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Dh||i===Nh||i===Uh||i===Fh||i===Oh||i===Bh||i===kh||i===zh||i===Hh||i===Gh||i===Vh||i===Wh||i===qh||i===$h)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Dh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Nh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Uh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Fh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Oh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Bh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===kh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===zh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Hh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Gh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Vh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Wh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===qh)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===$h)return o===Be?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Xh||i===Yh||i===Zh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Xh)return o===Be?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Yh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Zh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===jh||i===Jh||i===hc||i===Kh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===jh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Jh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===hc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Kh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===wo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var JA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,KA=`
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

}`,um=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Zl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new rs({vertexShader:JA,fragmentShader:KA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new bn(new Ql(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},hm=class extends vs{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,h=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new um,m={},x=e.getContextAttributes(),w=null,v=null,A=[],T=[],_=new qt,b=null,L=null,I=new _i;I.viewport=new dn;let D=new _i;D.viewport=new dn;let B=[I,D],V=new dh,O=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let yt=A[et];return yt===void 0&&(yt=new Ea,A[et]=yt),yt.getTargetRaySpace()},this.getControllerGrip=function(et){let yt=A[et];return yt===void 0&&(yt=new Ea,A[et]=yt),yt.getGripSpace()},this.getHand=function(et){let yt=A[et];return yt===void 0&&(yt=new Ea,A[et]=yt),yt.getHandSpace()};function Z(et){let yt=T.indexOf(et.inputSource);if(yt===-1)return;let St=A[yt];St!==void 0&&(St.update(et.inputSource,et.frame,l||o),St.dispatchEvent({type:et.type,data:et.inputSource}))}function q(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",ht);for(let et=0;et<A.length;et++){let yt=T[et];yt!==null&&(T[et]=null,A[et].disconnect(yt))}O=null,$=null,p.reset();for(let et in m)delete m[et];if(t.setRenderTarget(w),f=null,d=null,h=null,s=null,v=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(b),t.setSize(_.width,_.height,!1),L!==null){let et=L.camera;et.fov=L.fov,et.zoom=L.zoom,et.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,i.isPresenting===!0&&Qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,i.isPresenting===!0&&Qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(et){l=et},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",q),s.addEventListener("inputsourceschange",ht),x.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let St=null,Lt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,St=x.stencil?fr:cr,Lt=x.stencil?wo:Ss);let jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new Vi(d.textureWidth,d.textureHeight,{format:ws,type:$i,depthTexture:new hr(d.textureWidth,d.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,St),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let St={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,St),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Vi(f.framebufferWidth,f.framebufferHeight,{format:ws,type:$i,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ht(et){for(let yt=0;yt<et.removed.length;yt++){let St=et.removed[yt],Lt=T.indexOf(St);Lt>=0&&(T[Lt]=null,A[Lt].disconnect(St))}for(let yt=0;yt<et.added.length;yt++){let St=et.added[yt],Lt=T.indexOf(St);if(Lt===-1){for(let jt=0;jt<A.length;jt++)if(jt>=T.length){T.push(St),Lt=jt;break}else if(T[jt]===null){T[jt]=St,Lt=jt;break}if(Lt===-1)break}let At=A[Lt];At&&At.connect(St)}}function K(et,yt){yt===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(yt.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let yt=et.near,St=et.far;p.texture!==null&&(p.depthNear>0&&(yt=p.depthNear),p.depthFar>0&&(St=p.depthFar)),V.near=D.near=I.near=yt,V.far=D.far=I.far=St,(O!==V.near||$!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),O=V.near,$=V.far),V.layers.mask=et.layers.mask|6,I.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Lt=et.parent,At=V.cameras;K(V,Lt);for(let jt=0;jt<At.length;jt++)K(At[jt],Lt);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),L===null&&et.isPerspectiveCamera&&(L={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,V,Lt)};function tt(et,yt,St){St===null?et.matrix.copy(yt.matrixWorld):(et.matrix.copy(St.matrixWorld),et.matrix.invert(),et.matrix.multiply(yt.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(yt.projectionMatrix),et.projectionMatrixInverse.copy(yt.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=Sa*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(et){c=et,d!==null&&(d.fixedFoveation=et),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(V)},this.getCameraTexture=function(et){return m[et]};let rt=null;function pt(et,yt){if(u=yt.getViewerPose(l||o),g=yt,u!==null){let St=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Lt=!1;St.length!==V.cameras.length&&(V.cameras.length=0,Lt=!0);for(let Xt=0;Xt<St.length;Xt++){let ye=St[Xt],ge=null;if(f!==null)ge=f.getViewport(ye);else{let ln=h.getViewSubImage(d,ye);ge=ln.viewport,Xt===0&&(t.setRenderTargetTextures(v,ln.colorTexture,ln.depthStencilTexture),t.setRenderTarget(v))}let ue=B[Xt];ue===void 0&&(ue=new _i,ue.layers.enable(Xt),ue.viewport=new dn,B[Xt]=ue),ue.matrix.fromArray(ye.transform.matrix),ue.matrix.decompose(ue.position,ue.quaternion,ue.scale),ue.projectionMatrix.fromArray(ye.projectionMatrix),ue.projectionMatrixInverse.copy(ue.projectionMatrix).invert(),ue.viewport.set(ge.x,ge.y,ge.width,ge.height),Xt===0&&(V.matrix.copy(ue.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Lt===!0&&V.cameras.push(ue)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Xt=h.getDepthInformation(St[0]);Xt&&Xt.isValid&&Xt.texture&&p.init(Xt,s.renderState)}if(At&&At.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let Xt=0;Xt<St.length;Xt++){let ye=St[Xt].camera;if(ye){let ge=m[ye];ge||(ge=new Zl,m[ye]=ge);let ue=h.getCameraImage(ye);ge.sourceTexture=ue}}}}for(let St=0;St<A.length;St++){let Lt=T[St],At=A[St];Lt!==null&&At!==void 0&&At.update(Lt,yt,l||o)}rt&&rt(et,yt),yt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:yt}),g=null}let ft=new Tx;ft.setAnimationLoop(pt),this.setAnimationLoop=function(et){rt=et},this.dispose=function(){}}},QA=new be,Fx=new ce;Fx.set(-1,0,0,0,1,0,0,0,1);function tR(n,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,Kp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,x,w,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),h(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,v)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?c(p,m,x,w):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Si&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Si&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let x=t.get(m),w=x.envMap,v=x.envMapRotation;w&&(p.envMap.value=w,p.envMapRotation.value.setFromMatrix4(QA.makeRotationFromEuler(v)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Fx),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,x,w){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*x,p.scale.value=w*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,x){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Si&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let x=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function eR(n,t,e,i){let s={},r={};function o(x,w){let v=w.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,w){let v=s[x.id];v===void 0&&(g(x),v=c(x),s[x.id]=v,x.addEventListener("dispose",p));let A=w.program;i.updateUBOMapping(x,A);let T=t.render.frame;r[x.id]!==T&&(l(x),r[x.id]=T)}function c(x){let w=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function l(x){let w=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let T=0,_=v.length;T<_;T++){let b=v[T];if(Array.isArray(b))for(let L=0,I=b.length;L<I;L++)u(b[L],T,L,A);else u(b,T,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,w,v,A){if(d(x,w,v,A)===!0){let T=x.__offset,_=x.value;if(Array.isArray(_)){let b=0;for(let L=0;L<_.length;L++){let I=_[L],D=y(I,!0);h(I,x.__data,b),b+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,x.__data)}}function h(x,w,v){typeof x=="number"||typeof x=="boolean"?w[v]=x:x.isMatrix3?(w[v]=x.elements[0],w[v+1]=x.elements[1],w[v+2]=x.elements[2],w[v+3]=0,w[v+4]=x.elements[3],w[v+5]=x.elements[4],w[v+6]=x.elements[5],w[v+7]=0,w[v+8]=x.elements[6],w[v+9]=x.elements[7],w[v+10]=x.elements[8],w[v+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-v),v):x.toArray(w,v)}function d(x,w,v,A){let T=x.value,_=w+"_"+v;if(Array.isArray(T)){A[_]===void 0&&(A[_]=[]);let b=A[_],L=!1;for(let I=0;I<T.length;I++)f(T[I],b,I)===!0&&(L=!0);return L}return f(T,A,_)}function f(x,w,v){if(w[v]===void 0)return typeof x=="number"||typeof x=="boolean"?w[v]=x:ArrayBuffer.isView(x)?w[v]=x.slice():w[v]=x.clone(),!0;{let A=w[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return w[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function g(x){let w=x.uniforms,v=0,A=16;for(let _=0,b=w.length;_<b;_++){let L=Array.isArray(w[_])?w[_]:[w[_]];for(let I=0,D=L.length;I<D;I++){let B=L[I],V=Array.isArray(B.value)?B.value:[B.value],O=Array.isArray(w[_])||Array.isArray(B.value),$=v;for(let q=0,ht=V.length;q<ht;q++){let K=V[q],tt=y(K,O),rt=v%A,pt=rt%tt.boundary,ft=rt+pt;v+=pt,ft!==0&&A-ft<tt.storage&&(v+=A-ft),q===0&&($=v),v+=tt.storage}let Z=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Z((v-$)/Float32Array.BYTES_PER_ELEMENT),B.__offset=$}}let T=v%A;return T>0&&(v+=A-T),x.__size=v,x.__cache={},this}function y(x,w){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?Qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):Qt("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function p(x){let w=x.target;w.removeEventListener("dispose",p),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var nR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),$s=null;function iR(){return $s===null&&($s=new Wl(nR,16,16,Xr,Ms),$s.name="DFG_LUT",$s.minFilter=xi,$s.magFilter=xi,$s.wrapS=Gs,$s.wrapT=Gs,$s.generateMipmaps=!1,$s.needsUpdate=!0),$s}var sd=class{constructor(t={}){let{canvas:e=j_(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=$i}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=f,p=new Set([Sh,bh,vh]),m=new Set([$i,Ss,Ua,wo,_h,xh]),x=new Uint32Array(4),w=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,T=null,_=[],b=[],L=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,B=null,V=null,O=null,$=null;this._outputColorSpace=gi;let Z=0,q=0,ht=null,K=-1,tt=null,rt=new dn,pt=new dn,ft=null,et=new ee(0),yt=0,St=e.width,Lt=e.height,At=1,jt=null,de=null,Xt=new dn(0,0,St,Lt),ye=new dn(0,0,St,Lt),ge=!1,ue=new go,ln=new Yu,Qe=!1,Tn=!1,qe=new be,qn=new k,Ce=new dn,Un={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},fn=!1;function An(){return ht===null?At:1}let H=i;function Nt(P,G){return e.getContext(P,G)}let te,fe,Rt,Ye,$t,Kt,N,R,X,dt,at,bt,Mt,nt,st,_t,z,ot,it,Ct,vt,Tt,Yt;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Gt,!1),e.addEventListener("webglcontextrestored",re,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),H===null){let G="webgl2";if(H=Nt(G,P),H===null)throw Nt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}se()}catch(P){throw e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",re,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),ie("WebGLRenderer: "+P.message),P}function se(){te=new pT(H),te.init(),vt=new jA(H,te),fe=new iT(H,te,t,vt),Rt=new YA(H,te),fe.reversedDepthBuffer&&d&&Rt.buffers.depth.setReversed(!0),V=H.createFramebuffer(),O=H.createFramebuffer(),$=H.createFramebuffer(),Ye=new _T(H),$t=new NA,Kt=new ZA(H,te,Rt,$t,fe,vt,Ye),N=new fT(I),R=new yw(H),Tt=new eT(H,R),X=new mT(H,R,Ye,Tt),dt=new yT(H,X,R,Tt,Ye),ot=new xT(H,fe,Kt),st=new sT($t),at=new DA(I,N,te,fe,Tt,st),bt=new tR(I,$t),Mt=new FA,nt=new GA(te),z=new tT(I,N,Rt,dt,g,c),_t=new XA(I,dt,fe),Yt=new eR(H,Ye,fe,Rt),it=new nT(H,te,Ye),Ct=new gT(H,te,Ye),Ye.programs=at.programs,I.capabilities=fe,I.extensions=te,I.properties=$t,I.renderLists=Mt,I.shadowMap=_t,I.state=Rt,I.info=Ye}y!==$i&&(L=new bT(y,e.width,e.height,a,s,r));let ut=new hm(I,H);this.xr=ut,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let P=te.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=te.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(P){P!==void 0&&(At=P,this.setSize(St,Lt,!1))},this.getSize=function(P){return P.set(St,Lt)},this.setSize=function(P,G,Q=!0){if(ut.isPresenting){Qt("WebGLRenderer: Can't change size while VR device is presenting.");return}St=P,Lt=G,e.width=Math.floor(P*At),e.height=Math.floor(G*At),Q===!0&&(e.style.width=P+"px",e.style.height=G+"px"),L!==null&&L.setSize(e.width,e.height),this.setViewport(0,0,P,G)},this.getDrawingBufferSize=function(P){return P.set(St*At,Lt*At).floor()},this.setDrawingBufferSize=function(P,G,Q){St=P,Lt=G,At=Q,e.width=Math.floor(P*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,P,G)},this.setEffects=function(P){if(y===$i){ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let G=0;G<P.length;G++)if(P[G].isOutputPass===!0){Qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(rt)},this.getViewport=function(P){return P.copy(Xt)},this.setViewport=function(P,G,Q,Y){P.isVector4?Xt.set(P.x,P.y,P.z,P.w):Xt.set(P,G,Q,Y),Rt.viewport(rt.copy(Xt).multiplyScalar(An()).round())},this.getScissor=function(P){return P.copy(ye)},this.setScissor=function(P,G,Q,Y){P.isVector4?ye.set(P.x,P.y,P.z,P.w):ye.set(P,G,Q,Y),Rt.scissor(pt.copy(ye).multiplyScalar(An()).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(P){Rt.setScissorTest(ge=P)},this.setOpaqueSort=function(P){jt=P},this.setTransparentSort=function(P){de=P},this.getClearColor=function(P){return P.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(P=!0,G=!0,Q=!0){let Y=0;if(P){let j=!1;if(ht!==null){let Pt=ht.texture.format;j=p.has(Pt)}if(j){let Pt=ht.texture.type,Ut=m.has(Pt),It=z.getClearColor(),Ft=z.getClearAlpha(),Wt=It.r,le=It.g,Se=It.b;Ut?(x[0]=Wt,x[1]=le,x[2]=Se,x[3]=Ft,H.clearBufferuiv(H.COLOR,0,x)):(w[0]=Wt,w[1]=le,w[2]=Se,w[3]=Ft,H.clearBufferiv(H.COLOR,0,w))}else Y|=H.COLOR_BUFFER_BIT}G&&(Y|=H.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&H.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),B=P},this.dispose=function(){e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",re,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),z.dispose(),Mt.dispose(),nt.dispose(),Kt.dispose(),$t.dispose(),N.dispose(),dt.dispose(),X.dispose(),Tt.dispose(),Yt.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Xc),ut.removeEventListener("sessionend",Ls),js.stop()};function Gt(P){P.preventDefault(),Fl("WebGLRenderer: Context Lost."),D=!0}function re(){Fl("WebGLRenderer: Context Restored."),D=!1;let P=Ye.autoReset,G=_t.enabled,Q=_t.autoUpdate,Y=_t.needsUpdate,j=_t.type;se(),Ye.autoReset=P,_t.enabled=G,_t.autoUpdate=Q,_t.needsUpdate=Y,_t.type=j}function Dt(P){ie("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function me(P){let G=P.target;G.removeEventListener("dispose",me),tn(G)}function tn(P){ci(P),$t.remove(P)}function ci(P){let G=$t.get(P).programs;G!==void 0&&(G.forEach(function(Q){at.releaseProgram(Q)}),P.isShaderMaterial&&at.releaseShaderCache(P))}this.renderBufferDirect=function(P,G,Q,Y,j,Pt){G===null&&(G=Un);let Ut=j.isMesh&&j.matrixWorld.determinantAffine()<0,It=hl(P,G,Q,Y,j);Rt.setMaterial(Y,Ut);let Ft=Q.index,Wt=1;if(Y.wireframe===!0){if(Ft=X.getWireframeAttribute(Q),Ft===void 0)return;Wt=2}let le=Q.drawRange,Se=Q.attributes.position,Vt=le.start*Wt,Me=(le.start+le.count)*Wt;Pt!==null&&(Vt=Math.max(Vt,Pt.start*Wt),Me=Math.min(Me,(Pt.start+Pt.count)*Wt)),Ft!==null?(Vt=Math.max(Vt,0),Me=Math.min(Me,Ft.count)):Se!=null&&(Vt=Math.max(Vt,0),Me=Math.min(Me,Se.count));let hn=Me-Vt;if(hn<0||hn===1/0)return;Tt.setup(j,Y,It,Q,Ft);let He,Ge=it;if(Ft!==null&&(He=R.get(Ft),Ge=Ct,Ge.setIndex(He)),j.isMesh)Y.wireframe===!0?(Rt.setLineWidth(Y.wireframeLinewidth*An()),Ge.setMode(H.LINES)):Ge.setMode(H.TRIANGLES);else if(j.isLine){let Fn=Y.linewidth;Fn===void 0&&(Fn=1),Rt.setLineWidth(Fn*An()),j.isLineSegments?Ge.setMode(H.LINES):j.isLineLoop?Ge.setMode(H.LINE_LOOP):Ge.setMode(H.LINE_STRIP)}else j.isPoints?Ge.setMode(H.POINTS):j.isSprite&&Ge.setMode(H.TRIANGLES);if(j.isBatchedMesh)if(te.get("WEBGL_multi_draw"))Ge.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let Fn=j._multiDrawStarts,zt=j._multiDrawCounts,Rn=j._multiDrawCount,Ee=Ft?R.get(Ft).bytesPerElement:1,Ks=$t.get(Y).currentProgram.getUniforms();for(let Cn=0;Cn<Rn;Cn++)Ks.setValue(H,"_gl_DrawID",Cn),Ge.render(Fn[Cn]/Ee,zt[Cn])}else if(j.isInstancedMesh)Ge.renderInstances(Vt,hn,j.count);else if(Q.isInstancedBufferGeometry){let Fn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,zt=Math.min(Q.instanceCount,Fn);Ge.renderInstances(Vt,hn,zt)}else Ge.render(Vt,hn)};function ll(P,G,Q,Y){B!==null&&P.isNodeMaterial&&B.setObject(Y,P),Qe===!0&&st.setState(P,Q,!1),P.transparent===!0&&P.side===os&&P.forceSinglePass===!1?(P.side=Si,P.needsUpdate=!0,Ds(P,G,Y),P.side=$r,P.needsUpdate=!0,Ds(P,G,Y),P.side=os):Ds(P,G,Y)}this.compile=function(P,G,Q=null){Q===null&&(Q=P),B!==null&&B.renderStart(P,G,Q),T=nt.get(Q),T.init(G),b.push(T),Q.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(T.pushLight(j),j.castShadow&&T.pushShadow(j))}),P!==Q&&P.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(T.pushLight(j),j.castShadow&&T.pushShadow(j))}),T.setupLights(),B!==null&&B.updateLights(T.state.lightsArray),Tn=this.localClippingEnabled,Qe=st.init(this.clippingPlanes,Tn),Qe===!0&&st.setGlobalState(this.clippingPlanes,G),B!==null&&_t.render(T.state.shadowsArray,Q,G);let Y=new Set;return P.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Pt=j.material;if(Pt)if(Array.isArray(Pt))for(let Ut=0;Ut<Pt.length;Ut++){let It=Pt[Ut];ll(It,Q,G,j),Y.add(It)}else ll(Pt,Q,G,j),Y.add(Pt)}),T=b.pop(),B!==null&&B.renderEnd(),Y},this.compileAsync=function(P,G,Q=null){let Y=this.compile(P,G,Q);return new Promise(j=>{function Pt(){if(Y.forEach(function(Ut){let Ft=$t.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&Y.delete(Ut)}),Y.size===0){j(P);return}setTimeout(Pt,10)}te.get("KHR_parallel_shader_compile")!==null?Pt():setTimeout(Pt,10)})};let ko=null;function Cf(P){ko&&ko(P)}function Xc(){js.stop()}function Ls(){js.start()}let js=new Tx;js.setAnimationLoop(Cf),typeof self<"u"&&js.setContext(self),this.setAnimationLoop=function(P){ko=P,ut.setAnimationLoop(P),P===null?js.stop():js.start()},ut.addEventListener("sessionstart",Xc),ut.addEventListener("sessionend",Ls),this.render=function(P,G){if(G!==void 0&&G.isCamera!==!0){ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(P,G);let Q=ut.enabled===!0&&ut.isPresenting===!0,Y=L!==null&&(ht===null||Q)&&L.begin(I,ht);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(G),G=ut.getCamera()),P.isScene===!0&&P.onBeforeRender(I,P,G,ht),T=nt.get(P,b.length),T.init(G),T.state.textureUnits=Kt.getTextureUnits(),b.push(T),qe.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?ln.setFromArrayCamera(G):ue.setFromProjectionMatrix(qe,is,G.reversedDepth),Tn=this.localClippingEnabled,Qe=st.init(this.clippingPlanes,Tn),A=Mt.get(P,_.length),A.init(),_.push(A),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Ut=I.xr.getDepthSensingMesh();Ut!==null&&Js(Ut,G,-1/0,I.sortObjects)}Js(P,G,0,I.sortObjects),A.finish(),B!==null&&B.updateLights(T.state.lightsArray),I.sortObjects===!0&&A.sort(jt,de),fn=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,fn&&z.addToRenderList(A,P),this.info.autoReset===!0&&this.info.reset(),Qe===!0&&st.beginShadows();let j=T.state.shadowsArray;if(_t.render(j,P,G),Qe===!0&&st.endShadows(),(Y&&L.hasRenderPass())===!1){let Ut=A.opaque,It=A.transmissive;if(T.setupLights(),G.isArrayCamera){let Ft=G.cameras;if(It.length>0)for(let Wt=0,le=Ft.length;Wt<le;Wt++){let Se=Ft[Wt];ds(Ut,It,P,Se)}fn&&z.render(P);for(let Wt=0,le=Ft.length;Wt<le;Wt++){let Se=Ft[Wt];cl(A,P,Se,Se.viewport)}}else It.length>0&&ds(Ut,It,P,G),fn&&z.render(P),cl(A,P,G)}ht!==null&&q===0&&(Kt.updateMultisampleRenderTarget(ht),Kt.updateRenderTargetMipmap(ht)),Y&&L.end(I),P.isScene===!0&&P.onAfterRender(I,P,G),Tt.resetDefaultState(),K=-1,tt=null,b.pop(),b.length>0?(T=b[b.length-1],Kt.setTextureUnits(T.state.textureUnits),Qe===!0&&st.setGlobalState(I.clippingPlanes,T.state.camera)):T=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,B!==null&&B.renderEnd()};function Js(P,G,Q,Y){if(P.visible===!1)return;if(P.layers.test(G.layers)){if(P.isGroup)Q=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update(G);else if(P.isLight)T.pushLight(P),P.castShadow&&T.pushShadow(P);else if(P.isSprite){let Ut=G.isArrayCamera?ln:ue;if(!P.frustumCulled||P.intersectsFrustum(Ut)){Y&&Ce.setFromMatrixPosition(P.matrixWorld).applyMatrix4(qe);let It=dt.update(P),Ft=P.material;Ft.visible&&A.push(P,It,Ft,Q,Ce.z,null,G)}}else if(P.isMesh||P.isLine||P.isPoints){let Ut=G.isArrayCamera?ln:ue;if(!P.frustumCulled||P.intersectsFrustum(Ut)){let It=dt.update(P),Ft=P.material;if(Y&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),Ce.copy(P.boundingSphere.center)):(It.boundingSphere===null&&It.computeBoundingSphere(),Ce.copy(It.boundingSphere.center)),Ce.applyMatrix4(P.matrixWorld).applyMatrix4(qe)),Array.isArray(Ft)){let Wt=It.groups;for(let le=0,Se=Wt.length;le<Se;le++){let Vt=Wt[le],Me=Ft[Vt.materialIndex];Me&&Me.visible&&A.push(P,It,Me,Q,Ce.z,Vt,G)}}else Ft.visible&&A.push(P,It,Ft,Q,Ce.z,null,G)}}}let Pt=P.children;for(let Ut=0,It=Pt.length;Ut<It;Ut++)Js(Pt[Ut],G,Q,Y)}function cl(P,G,Q,Y){let{opaque:j,transmissive:Pt,transparent:Ut}=P;T.setupLightsView(Q),Qe===!0&&st.setGlobalState(I.clippingPlanes,Q),Y&&Rt.viewport(rt.copy(Y)),j.length>0&&pn(j,G,Q),Pt.length>0&&pn(Pt,G,Q),Ut.length>0&&pn(Ut,G,Q),Rt.buffers.depth.setTest(!0),Rt.buffers.depth.setMask(!0),Rt.buffers.color.setMask(!0),Rt.setPolygonOffset(!1)}function ds(P,G,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Vt=te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new Vi(1,1,{generateMipmaps:!0,type:Vt?Ms:$i,minFilter:dr,samples:Math.max(4,fe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Te.workingColorSpace})}let Pt=T.state.transmissionRenderTarget[Y.id],Ut=Y.viewport||rt;Pt.setSize(Ut.z*I.transmissionResolutionScale,Ut.w*I.transmissionResolutionScale);let It=I.getRenderTarget(),Ft=I.getActiveCubeFace(),Wt=I.getActiveMipmapLevel();I.setRenderTarget(Pt),I.getClearColor(et),yt=I.getClearAlpha(),yt<1&&I.setClearColor(16777215,.5),I.clear(),fn&&z.render(Q);let le=I.toneMapping;I.toneMapping=qs;let Se=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),Qe===!0&&st.setGlobalState(I.clippingPlanes,Y),pn(P,Q,Y),Kt.updateMultisampleRenderTarget(Pt),Kt.updateRenderTargetMipmap(Pt),te.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let Me=0,hn=G.length;Me<hn;Me++){let He=G[Me],{object:Ge,geometry:Fn,material:zt,group:Rn}=He;if(zt.side===os&&Ge.layers.test(Y.layers)){let Ee=zt.side;zt.side=Si,zt.needsUpdate=!0,Mn(Ge,Q,Y,Fn,zt,Rn),zt.side=Ee,zt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(Pt),Kt.updateRenderTargetMipmap(Pt))}I.setRenderTarget(It,Ft,Wt),I.setClearColor(et,yt),Se!==void 0&&(Y.viewport=Se),I.toneMapping=le}function pn(P,G,Q){let Y=G.isScene===!0?G.overrideMaterial:null;for(let j=0,Pt=P.length;j<Pt;j++){let Ut=P[j],{object:It,geometry:Ft,group:Wt}=Ut,le=Ut.material;le.allowOverride===!0&&Y!==null&&(le=Y),It.layers.test(Q.layers)&&Mn(It,G,Q,Ft,le,Wt)}}function Mn(P,G,Q,Y,j,Pt){B!==null&&j.isNodeMaterial&&B.setObject(P,j),P.onBeforeRender(I,G,Q,Y,j,Pt),P.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),j.onBeforeRender(I,G,Q,Y,P,Pt),j.transparent===!0&&j.side===os&&j.forceSinglePass===!1?(j.side=Si,j.needsUpdate=!0,I.renderBufferDirect(Q,G,Y,j,P,Pt),j.side=$r,j.needsUpdate=!0,I.renderBufferDirect(Q,G,Y,j,P,Pt),j.side=os):I.renderBufferDirect(Q,G,Y,j,P,Pt),P.onAfterRender(I,G,Q,Y,j,Pt)}function wn(P){let G=0;for(let Q of P)Q.texture!==null&&G++;return G}function Ds(P,G,Q){G.isScene!==!0&&(G=Un);let Y=$t.get(P),j=T.state.lights,Pt=T.state.shadowsArray,Ut=j.state.version,It=at.getParameters(P,j.state,Pt,G,Q,T.state.lightProbeGridArray),Ft=at.getProgramCacheKey(It),Wt=Y.programs;Y.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?G.environment:null,Y.fog=G.fog;let le=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;Y.envMap=N.get(P.envMap||Y.environment,le),Y.envMapRotation=Y.environment!==null&&P.envMap===null?G.environmentRotation:P.envMapRotation,Wt===void 0&&(P.addEventListener("dispose",me),Wt=new Map,Y.programs=Wt,Y.programVariants=new Map);let Se=Wt.get(Ft);if(Se!==void 0){if(Y.currentProgram===Se&&Y.lightsStateVersion===Ut)return ul(P,It),Se}else It.uniforms=at.getUniforms(P),B!==null&&P.isNodeMaterial&&B.build(P,Q,It),P.onBeforeCompile(It,I),Se=at.acquireProgram(It,Ft),Wt.set(Ft,Se),Y.uniforms=It.uniforms;let Vt=Y.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(Vt.clippingPlanes=st.uniform),ul(P,It),Y.needsLights=Er(P),Y.lightsStateVersion=Ut,Y.needsLights&&(Vt.ambientLightColor.value=j.state.ambient,Vt.lightProbe.value=j.state.probe,Vt.sunLights.value=j.state.sun,Vt.sunLightShadows.value=j.state.sunShadow,Vt.directionalLights.value=j.state.directional,Vt.directionalLightShadows.value=j.state.directionalShadow,Vt.spotLights.value=j.state.spot,Vt.spotLightShadows.value=j.state.spotShadow,Vt.rectAreaLights.value=j.state.rectArea,Vt.ltc_1.value=j.state.rectAreaLTC1,Vt.ltc_2.value=j.state.rectAreaLTC2,Vt.pointLights.value=j.state.point,Vt.pointLightShadows.value=j.state.pointShadow,Vt.hemisphereLights.value=j.state.hemi,Vt.sunShadowMatrix.value=j.state.sunShadowMatrix,Vt.sunShadowCascade.value=j.state.sunShadowCascade,Vt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Vt.spotLightMatrix.value=j.state.spotLightMatrix,Vt.spotLightMap.value=j.state.spotLightMap,Vt.pointShadowMatrix.value=j.state.pointShadowMatrix),Y.numLightProbeGrids=wn(T.state.lightProbeGridArray),Y.currentProgram=Se,Y.uniformsList=null,Se}function Fi(P,G,Q,Y,j){let Pt=$t.get(P),Ut=Pt.currentProgram.id+","+Y+","+j,It=Pt.programVariants.get(Ut);return It===void 0?(It=Ds(P,G,Q),Pt.programVariants.set(Ut,It)):(Pt.currentProgram=It,Pt.uniformsList=null,Pt.outputColorSpace=Y,Pt.toneMapping=j),It}function wr(P){if(P.uniformsList===null){let G=P.currentProgram.getUniforms();P.uniformsList=Fa.seqWithValue(G.seq,P.uniforms)}return P.uniformsList}function ul(P,G){let Q=$t.get(P);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function hl(P,G,Q,Y,j){G.isScene!==!0&&(G=Un),Kt.resetTextureUnits();let Pt=G.fog,Ut=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?G.environment:null,It=ht===null?I.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:Te.workingColorSpace,Ft=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Wt=N.get(Y.envMap||Ut,Ft),le=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,Se=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Vt=!!Q.morphAttributes.position,Me=!!Q.morphAttributes.normal,hn=!!Q.morphAttributes.color,He=qs;Y.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(He=I.toneMapping);let Ge=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Fn=Ge!==void 0?Ge.length:0,zt=$t.get(Y),Rn=T.state.lights;if(Qe===!0&&(Tn===!0||P!==tt)){let Ve=P===tt&&Y.id===K;st.setState(Y,P,Ve)}let Ee=!1,Ks=!1;Y.version===zt.__version?zt.needsLights&&zt.lightsStateVersion!==Rn.state.version||j.isBatchedMesh&&zt.batching===!1||!j.isBatchedMesh&&zt.batching===!0||j.isBatchedMesh&&zt.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&zt.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&zt.instancing===!1||!j.isInstancedMesh&&zt.instancing===!0||j.isSkinnedMesh&&zt.skinning===!1||!j.isSkinnedMesh&&zt.skinning===!0||j.isInstancedMesh&&zt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&zt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&zt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&zt.instancingMorph===!1&&j.morphTexture!==null||zt.envMap!==Wt||Y.fog===!0&&zt.fog!==Pt||zt.numClippingPlanes!==void 0&&(zt.numClippingPlanes!==st.numPlanes||zt.numIntersection!==st.numIntersection)||zt.vertexAlphas!==le||zt.vertexTangents!==Se||zt.morphTargets!==Vt||zt.morphNormals!==Me||zt.morphColors!==hn||zt.morphTargetsCount!==Fn||zt.numLightProbeGrids!==wn(T.state.lightProbeGridArray)?Ee=!0:(zt.outputColorSpace!==It||zt.toneMapping!==He)&&(Ks=!0):(Ee=!0,zt.__version=Y.version);let Cn=zt.currentProgram;(Ee===!0||Ks===!0)&&(Cn=Ks===!0?Fi(Y,G,j,It,He):Ds(Y,G,j),B&&Y.isNodeMaterial&&B.onUpdateProgram(Y,Cn,zt));let Go=!1,Ns=!1,Qs=!1,_e=Cn.getUniforms(),mn=zt.uniforms;if(Rt.useProgram(Cn.program)&&(Go=!0,Ns=!0,Qs=!0),Y.id!==K&&(K=Y.id,Ns=!0),Go||tt!==P){Rt.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),_e.setValue(H,"projectionMatrix",P.projectionMatrix),_e.setValue(H,"viewMatrix",P.matrixWorldInverse);let Pn=_e.map.cameraPosition;Pn!==void 0&&Pn.setValue(H,qn.setFromMatrixPosition(P.matrixWorld)),fe.logarithmicDepthBuffer&&_e.setValue(H,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&_e.setValue(H,"isOrthographic",P.isOrthographicCamera===!0),tt!==P&&(tt=P,Ns=!0,Qs=!0)}if(zt.needsLights&&(Rn.state.sunShadowMap.length>0&&_e.setValue(H,"sunShadowMap",Rn.state.sunShadowMap,Kt),Rn.state.directionalShadowMap.length>0&&_e.setValue(H,"directionalShadowMap",Rn.state.directionalShadowMap,Kt),Rn.state.spotShadowMap.length>0&&_e.setValue(H,"spotShadowMap",Rn.state.spotShadowMap,Kt),Rn.state.pointShadowMap.length>0&&_e.setValue(H,"pointShadowMap",Rn.state.pointShadowMap,Kt)),j.isSkinnedMesh){_e.setOptional(H,j,"bindMatrix"),_e.setOptional(H,j,"bindMatrixInverse");let Ve=j.skeleton;Ve&&(Ve.boneTexture===null&&Ve.computeBoneTexture(),_e.setValue(H,"boneTexture",Ve.boneTexture,Kt))}j.isBatchedMesh&&(_e.setOptional(H,j,"batchingTexture"),_e.setValue(H,"batchingTexture",j._matricesTexture,Kt),_e.setOptional(H,j,"batchingIdTexture"),_e.setValue(H,"batchingIdTexture",j._indirectTexture,Kt),_e.setOptional(H,j,"batchingColorTexture"),j._colorsTexture!==null&&_e.setValue(H,"batchingColorTexture",j._colorsTexture,Kt));let ui=Q.morphAttributes;if((ui.position!==void 0||ui.normal!==void 0||ui.color!==void 0)&&ot.update(j,Q,Cn),(Ns||zt.receiveShadow!==j.receiveShadow)&&(zt.receiveShadow=j.receiveShadow,_e.setValue(H,"receiveShadow",j.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&G.environment!==null&&(mn.envMapIntensity.value=G.environmentIntensity),mn.dfgLUT!==void 0&&(mn.dfgLUT.value=iR()),Ns){if(_e.setValue(H,"toneMappingExposure",I.toneMappingExposure),zt.needsLights&&zo(mn,Qs),Pt&&Y.fog===!0&&bt.refreshFogUniforms(mn,Pt),bt.refreshMaterialUniforms(mn,Y,At,Lt,T.state.transmissionRenderTarget[P.id]),zt.needsLights&&zt.numLightProbeGrids>0){let Ve=v,Pn=0;for(let ii of T.state.lightProbeGridArray)ii.texture!==null&&(Ve.textures[Pn]=ii.texture,Ve.min[Pn]=ii.boundingBox.min,Ve.max[Pn]=ii.boundingBox.max,Ve.resolution[Pn]=ii.resolution,Pn++);for(let ii in Ve)Ve[ii].length=Pn;mn.probesSH.value=Ve.textures,mn.probesMin.value=Ve.min,mn.probesMax.value=Ve.max,mn.probesResolution.value=Ve.resolution}Fa.upload(H,wr(zt),mn,Kt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Fa.upload(H,wr(zt),mn,Kt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&_e.setValue(H,"center",j.center),_e.setValue(H,"modelViewMatrix",j.modelViewMatrix),_e.setValue(H,"normalMatrix",j.normalMatrix),_e.setValue(H,"modelMatrix",j.matrixWorld),Y.uniformsGroups!==void 0){let Ve=Y.uniformsGroups;for(let Pn=0,ii=Ve.length;Pn<ii;Pn++){let Yc=Ve[Pn];Yt.update(Yc,Cn),Yt.bind(Yc,Cn)}}return Cn}function zo(P,G){P.ambientLightColor.needsUpdate=G,P.lightProbe.needsUpdate=G,P.sunLights.needsUpdate=G,P.sunLightShadows.needsUpdate=G,P.directionalLights.needsUpdate=G,P.directionalLightShadows.needsUpdate=G,P.pointLights.needsUpdate=G,P.pointLightShadows.needsUpdate=G,P.spotLights.needsUpdate=G,P.spotLightShadows.needsUpdate=G,P.rectAreaLights.needsUpdate=G,P.hemisphereLights.needsUpdate=G}function Er(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return q},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(P,G,Q){let Y=$t.get(P);Y.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),$t.get(P.texture).__webglTexture=G,$t.get(P.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,G){let Q=$t.get(P);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(P,G=0,Q=0){ht=P,Z=G,q=Q;let Y=null,j=!1,Pt=!1;if(P){let It=$t.get(P);if(It.__useDefaultFramebuffer!==void 0){Rt.bindFramebuffer(H.FRAMEBUFFER,It.__webglFramebuffer),rt.copy(P.viewport),pt.copy(P.scissor),ft=P.scissorTest,Rt.viewport(rt),Rt.scissor(pt),Rt.setScissorTest(ft),K=-1;return}else if(It.__webglFramebuffer===void 0)Kt.setupRenderTarget(P);else if(It.__hasExternalTextures)Kt.rebindTextures(P,$t.get(P.texture).__webglTexture,$t.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let le=P.depthTexture;if(It.__boundDepthTexture!==le){if(le!==null&&$t.has(le)&&(P.width!==le.image.width||P.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(P)}}let Ft=P.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Pt=!0);let Wt=$t.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray(Wt[G])?Y=Wt[G][Q]:Y=Wt[G],j=!0):P.samples>0&&Kt.useMultisampledRTT(P)===!1?Y=$t.get(P).__webglMultisampledFramebuffer:Array.isArray(Wt)?Y=Wt[Q]:Y=Wt,rt.copy(P.viewport),pt.copy(P.scissor),ft=P.scissorTest}else rt.copy(Xt).multiplyScalar(At).floor(),pt.copy(ye).multiplyScalar(At).floor(),ft=ge;if(Q!==0&&(Y=V),Rt.bindFramebuffer(H.FRAMEBUFFER,Y)&&Rt.drawBuffers(P,Y),Rt.viewport(rt),Rt.scissor(pt),Rt.setScissorTest(ft),j){let It=$t.get(P.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+G,It.__webglTexture,Q)}else if(Pt){let It=G;for(let Ft=0;Ft<P.textures.length;Ft++){let Wt=$t.get(P.textures[Ft]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+Ft,Wt.__webglTexture,Q,It)}}else if(P!==null&&Q!==0){let It=$t.get(P.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,It.__webglTexture,Q)}K=-1};function Ho(P){let G=$t.get(P);return(G.__readFormat!==P.format||G.__readType!==P.type)&&(G.__readFormat=P.format,G.__readType=P.type,G.__formatReadable=fe.textureFormatReadable(P.format),G.__typeReadable=fe.textureTypeReadable(P.type)),G}this.readRenderTargetPixels=function(P,G,Q,Y,j,Pt,Ut,It=0){if(!(P&&P.isWebGLRenderTarget)){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=$t.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Rt.bindFramebuffer(H.FRAMEBUFFER,Ft);try{let Wt=P.textures[It],le=Wt.format,Se=Wt.type;P.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+It);let Vt=Ho(Wt);if(Vt.__formatReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=P.width-Y&&Q>=0&&Q<=P.height-j&&H.readPixels(G,Q,Y,j,vt.convert(le),vt.convert(Se),Pt)}finally{let Wt=ht!==null?$t.get(ht).__webglFramebuffer:null;Rt.bindFramebuffer(H.FRAMEBUFFER,Wt)}}},this.readRenderTargetPixelsAsync=async function(P,G,Q,Y,j,Pt,Ut,It=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=$t.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(G>=0&&G<=P.width-Y&&Q>=0&&Q<=P.height-j){Rt.bindFramebuffer(H.FRAMEBUFFER,Ft);let Wt=P.textures[It],le=Wt.format,Se=Wt.type;P.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+It);let Vt=Ho(Wt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Me=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,Me),H.bufferData(H.PIXEL_PACK_BUFFER,Pt.byteLength,H.STREAM_READ),H.readPixels(G,Q,Y,j,vt.convert(le),vt.convert(Se),0),H.bindBuffer(H.PIXEL_PACK_BUFFER,null);let hn=ht!==null?$t.get(ht).__webglFramebuffer:null;Rt.bindFramebuffer(H.FRAMEBUFFER,hn);let He=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await K_(H,He,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,Me),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Pt),H.bindBuffer(H.PIXEL_PACK_BUFFER,null),H.deleteBuffer(Me),H.deleteSync(He),Pt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,G=null,Q=0){let Y=Math.pow(2,-Q),j=Math.floor(P.image.width*Y),Pt=Math.floor(P.image.height*Y),Ut=G!==null?G.x:0,It=G!==null?G.y:0;Kt.setTexture2D(P,0),H.copyTexSubImage2D(H.TEXTURE_2D,Q,0,0,Ut,It,j,Pt),Rt.unbindTexture()},this.copyTextureToTexture=function(P,G,Q=null,Y=null,j=0,Pt=0){let Ut,It,Ft,Wt,le,Se,Vt,Me,hn,He=P.isCompressedTexture?P.mipmaps[Pt]:P.image;if(Q!==null)Ut=Q.max.x-Q.min.x,It=Q.max.y-Q.min.y,Ft=Q.isBox3?Q.max.z-Q.min.z:1,Wt=Q.min.x,le=Q.min.y,Se=Q.isBox3?Q.min.z:0;else{let _e=Math.pow(2,-j);Ut=Math.floor(He.width*_e),It=Math.floor(He.height*_e),P.isDataArrayTexture?Ft=He.depth:P.isData3DTexture?Ft=Math.floor(He.depth*_e):Ft=1,Wt=0,le=0,Se=0}Y!==null?(Vt=Y.x,Me=Y.y,hn=Y.z):(Vt=0,Me=0,hn=0);let Ge=vt.convert(G.format),Fn=vt.convert(G.type),zt;G.isData3DTexture?(Kt.setTexture3D(G,0),zt=H.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Kt.setTexture2DArray(G,0),zt=H.TEXTURE_2D_ARRAY):(Kt.setTexture2D(G,0),zt=H.TEXTURE_2D),Rt.activeTexture(H.TEXTURE0),Rt.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,G.flipY),Rt.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Rt.pixelStorei(H.UNPACK_ALIGNMENT,G.unpackAlignment);let Rn=Rt.getParameter(H.UNPACK_ROW_LENGTH),Ee=Rt.getParameter(H.UNPACK_IMAGE_HEIGHT),Ks=Rt.getParameter(H.UNPACK_SKIP_PIXELS),Cn=Rt.getParameter(H.UNPACK_SKIP_ROWS),Go=Rt.getParameter(H.UNPACK_SKIP_IMAGES);Rt.pixelStorei(H.UNPACK_ROW_LENGTH,He.width),Rt.pixelStorei(H.UNPACK_IMAGE_HEIGHT,He.height),Rt.pixelStorei(H.UNPACK_SKIP_PIXELS,Wt),Rt.pixelStorei(H.UNPACK_SKIP_ROWS,le),Rt.pixelStorei(H.UNPACK_SKIP_IMAGES,Se);let Ns=P.isDataArrayTexture||P.isData3DTexture,Qs=G.isDataArrayTexture||G.isData3DTexture;if(P.isDepthTexture){let _e=$t.get(P),mn=$t.get(G),ui=$t.get(_e.__renderTarget),Ve=$t.get(mn.__renderTarget);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,ui.__webglFramebuffer),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ve.__webglFramebuffer);for(let Pn=0;Pn<Ft;Pn++)Ns&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$t.get(P).__webglTexture,j,Se+Pn),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$t.get(G).__webglTexture,Pt,hn+Pn)),H.blitFramebuffer(Wt,le,Wt+Ut,le+It,Vt,Me,Vt+Ut,Me+It,H.DEPTH_BUFFER_BIT,H.NEAREST);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,null),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(j!==0||P.isRenderTargetTexture||$t.has(P)){let _e=$t.get(P),mn=$t.get(G);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,O),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,$);for(let ui=0;ui<Ft;ui++)Ns?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,_e.__webglTexture,j,Se+ui):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,_e.__webglTexture,j),Qs?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,mn.__webglTexture,Pt,hn+ui):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,mn.__webglTexture,Pt),j!==0?H.blitFramebuffer(Wt,le,Wt+Ut,le+It,Vt,Me,Vt+Ut,Me+It,H.COLOR_BUFFER_BIT,H.NEAREST):Qs?H.copyTexSubImage3D(zt,Pt,Vt,Me,hn+ui,Wt,le,Ut,It):H.copyTexSubImage2D(zt,Pt,Vt,Me,Wt,le,Ut,It);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,null),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else Qs?P.isDataTexture||P.isData3DTexture?H.texSubImage3D(zt,Pt,Vt,Me,hn,Ut,It,Ft,Ge,Fn,He.data):G.isCompressedArrayTexture?H.compressedTexSubImage3D(zt,Pt,Vt,Me,hn,Ut,It,Ft,Ge,He.data):H.texSubImage3D(zt,Pt,Vt,Me,hn,Ut,It,Ft,Ge,Fn,He):P.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Pt,Vt,Me,Ut,It,Ge,Fn,He.data):P.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Pt,Vt,Me,He.width,He.height,Ge,He.data):H.texSubImage2D(H.TEXTURE_2D,Pt,Vt,Me,Ut,It,Ge,Fn,He);Rt.pixelStorei(H.UNPACK_ROW_LENGTH,Rn),Rt.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Ee),Rt.pixelStorei(H.UNPACK_SKIP_PIXELS,Ks),Rt.pixelStorei(H.UNPACK_SKIP_ROWS,Cn),Rt.pixelStorei(H.UNPACK_SKIP_IMAGES,Go),Pt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&H.generateMipmap(zt),Rt.unbindTexture()},this.initRenderTarget=function(P){$t.get(P).__webglFramebuffer===void 0&&Kt.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?Kt.setTextureCube(P,0):P.isData3DTexture?Kt.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?Kt.setTexture2DArray(P,0):Kt.setTexture2D(P,0),Rt.unbindTexture()},this.resetState=function(){Z=0,q=0,ht=null,Rt.reset(),Tt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return is}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Te._getDrawingBufferColorSpace(t),e.unpackColorSpace=Te._getUnpackColorSpace()}};var ae={},sR=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],rR={light:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"],dark:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},Ox=matchMedia("(prefers-color-scheme: dark)");function ad(){let n=E.theme==="dark"||E.theme==="auto"&&Ox.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of sR)ae[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();ae.dark=n,ae.curves=rR[n?"dark":"light"]}function ld(n){E.theme=n,ad(),xt("theme")}Ox.addEventListener("change",()=>{E.theme==="auto"&&(ad(),xt("theme"))});var Bx={type:"change"},fm={type:"start"},zx={type:"end"},cd=new ur,kx=new ei,oR=Math.cos(70*Zr.DEG2RAD),kn=new k,Ii=2*Math.PI,Ue={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},dm=1e-6,ud=class extends ic{constructor(t,e=null){super(t,e),this.state=Ue.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Wr.ROTATE,MIDDLE:Wr.DOLLY,RIGHT:Wr.PAN},this.touches={ONE:qr.ROTATE,TWO:qr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new on,this._lastTargetPosition=new k,this._quat=new on().setFromUnitVectors(t.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ia,this._sphericalDelta=new Ia,this._scale=1,this._panOffset=new k,this._rotateStart=new qt,this._rotateEnd=new qt,this._rotateDelta=new qt,this._panStart=new qt,this._panEnd=new qt,this._panDelta=new qt,this._dollyStart=new qt,this._dollyEnd=new qt,this._dollyDelta=new qt,this._dollyDirection=new k,this._mouse=new qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=lR.bind(this),this._onPointerDown=aR.bind(this),this._onPointerUp=cR.bind(this),this._onContextMenu=gR.bind(this),this._onMouseWheel=dR.bind(this),this._onKeyDown=fR.bind(this),this._onTouchStart=pR.bind(this),this._onTouchMove=mR.bind(this),this._onMouseDown=uR.bind(this),this._onMouseMove=hR.bind(this),this._interceptControlDown=_R.bind(this),this._interceptControlUp=xR.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ue.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Bx),this.update(),this.state=Ue.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;kn.copy(e).sub(this.target),kn.applyQuaternion(this._quat),this._spherical.setFromVector3(kn),this.autoRotate&&this.state===Ue.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Ii:i>Math.PI&&(i-=Ii),s<-Math.PI?s+=Ii:s>Math.PI&&(s-=Ii),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(kn.setFromSpherical(this._spherical),kn.applyQuaternion(this._quatInverse),e.copy(this.target).add(kn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=kn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new k(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=kn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(cd.origin.copy(this.object.position),cd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(cd.direction))<oR?this.object.lookAt(this.target):(kx.setFromNormalAndCoplanarPoint(this.object.up,this.target),cd.intersectPlane(kx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>dm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>dm||this._lastTargetPosition.distanceToSquared(this.target)>dm?(this.dispatchEvent(Bx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Ii/60*this.autoRotateSpeed*t:Ii/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){kn.setFromMatrixColumn(e,0),kn.multiplyScalar(-t),this._panOffset.add(kn)}_panUp(t,e){this.screenSpacePanning===!0?kn.setFromMatrixColumn(e,1):(kn.setFromMatrixColumn(e,0),kn.crossVectors(this.object.up,kn)),kn.multiplyScalar(t),this._panOffset.add(kn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;kn.copy(s).sub(this.target);let r=kn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ii*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ii*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function aR(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function lR(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function cR(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(zx),this.state=Ue.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function uR(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Wr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ue.DOLLY;break;case Wr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ue.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ue.ROTATE}break;case Wr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ue.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ue.PAN}break;default:this.state=Ue.NONE}this.state!==Ue.NONE&&this.dispatchEvent(fm)}function hR(n){switch(this.state){case Ue.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ue.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ue.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function dR(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ue.NONE||(n.preventDefault(),this.dispatchEvent(fm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(zx))}function fR(n){this.enabled!==!1&&this._handleKeyDown(n)}function pR(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case qr.ROTATE:if(this.enableRotate===!1){this.state=Ue.NONE;break}this._handleTouchStartRotate(n),this.state=Ue.TOUCH_ROTATE;break;case qr.PAN:if(this.enablePan===!1){this.state=Ue.NONE;break}this._handleTouchStartPan(n),this.state=Ue.TOUCH_PAN;break;default:this.state=Ue.NONE}break;case 2:switch(this.touches.TWO){case qr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ue.TOUCH_DOLLY_PAN;break;case qr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ue.TOUCH_DOLLY_ROTATE;break;default:this.state=Ue.NONE}break;default:this.state=Ue.NONE}this.state!==Ue.NONE&&this.dispatchEvent(fm)}function mR(n){switch(this._trackPointer(n),this.state){case Ue.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ue.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ue.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ue.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ue.NONE}}function gR(n){this.enabled!==!1&&n.preventDefault()}function _R(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function xR(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Hx=[1,.75,.55,.42],yR=30,vR=17,bR=400,Gx=6e6;function Vx(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var hd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(Gx/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>yR&&this.level<Hx.length-1?this.level+=1:i<vR&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*Hx[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(Gx/this.area),.5))),this.draw()},bR)}};var $x=32,Xx={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},zn=new kl,Fe=new _i($x,1,.01,100);Fe.up.set(0,0,1);var Xi,Sn,ls,gm,pm=!1,Yx=!1,_m=0;function Ie(){pm||!Yx||(pm=!0,requestAnimationFrame(Zx))}function Zx(n=performance.now()){pm=!1,gm.moving(n),xm()}var jx=[],Jx=n=>jx.push(n);function xm(){for(let n of jx)n();Xi.render(zn,Fe),_m+=1}function Kx(){Yx=!0,Ie()}function Qx(n){return xm(),n(Xi.domElement)}var ty=()=>_m;zn.fog=new Bl("#fff",1,10);function Wx(n){let t=document.createElement("canvas");t.width=ls.clientWidth||1,t.height=ls.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>SR.has(s)?i(s):null,e}var SR=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function ey(n){ls=n;let t=Wx(!1),e=Vx(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=Wx(!0)),Xi=new sd({canvas:t.canvas,context:t}),Xi.debug.checkShaderErrors=!1,gm=new hd(e,Xi,xm,i=>xt("hurry",i)),Xi.domElement.setAttribute("aria-hidden","true"),ls.append(Xi.domElement),Sn=new ud(Fe,Xi.domElement),Sn.enableDamping=!1,Sn.addEventListener("change",Ie),Sn.addEventListener("end",()=>{gc=!iy(),To=null}),new ResizeObserver(MR).observe(ls),ls.tabIndex=0,ls.setAttribute("role","application"),ls.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),ls.addEventListener("keydown",wR)}function MR(){let n=ls.clientWidth,t=ls.clientHeight;!n||!t||(gm.resized(n,t),Xi.setSize(n,t),Fe.aspect=n/t,Fe.updateProjectionMatrix(),_m?Zx():Ie(),Ba())}function wR(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)ER(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")qx(1/1.15);else if(n.key==="-")qx(1.15);else if(n.key.toLowerCase()==="f")fd(Ao);else if(e)ym(e);else return;n.preventDefault()}function ER(n,t){let e=Fe.position.clone().sub(Sn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Fe.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(Sn.target),Sn.update(),Ie()}function qx(n){Fe.position.sub(Sn.target).multiplyScalar(n).add(Sn.target),Sn.update(),Ie()}var Ao=[[0,0,0],[0,0,1]];function ny(n,t){let e=new Pi().setFromPoints(n.map(u=>new k(...u))),i=e.getCenter(new k),s=new k(...t).normalize(),r=new k().crossVectors(Fe.up,s).normalize(),o=new k().crossVectors(s,r),a=Math.tan(Zr.degToRad($x/2))*.8,c=a*Fe.aspect,l=e.getSize(new k).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,g=1/0,y=-1/0;for(let p of n){let m=new k(...p).sub(i),x=m.dot(r),w=m.dot(o),v=m.dot(s);h=Math.max(h,v+Math.abs(x)/c,v+Math.abs(w)/a),d=Math.min(d,w),f=Math.max(f,w),g=Math.min(g,x),y=Math.max(y,x)}l=Math.max(h,l*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(g+y)/2)}return{target:i,position:i.clone().addScaledVector(s,l)}}var mm=0;function dd({target:n,position:t},e=.35){let i={t:Sn.target.clone(),p:Fe.position.clone()},s=performance.now(),r=++mm,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(c){if(r!==mm)return;let l=o?1:Math.min((c-s)/(1e3*e),1),u=l*l*(3-2*l);Sn.target.lerpVectors(i.t,n,u),Fe.position.lerpVectors(i.p,t,u);let h=Fe.position.distanceTo(Sn.target);Fe.near=h/100,Fe.far=h*30,zn.fog.near=h*1.3,zn.fog.far=h*3.4,Fe.updateProjectionMatrix(),Sn.update(),Ie(),l<1&&requestAnimationFrame(a)})(s)}function fd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){Ao=n,i||(To=null),gc=!1;let s=e?Xx[e]:Fe.position.clone().sub(Sn.target).toArray();dd(ny(n,s),t?0:.35)}function ym(n){gc=!1,To=null,dd(ny(Ao,Xx[n]))}var gc=!1;function iy(){Fe.updateMatrixWorld();let n=new k;return Ao.every(t=>(n.set(...t).project(Fe),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Ba(){gc||!Sn.enabled||!Ao.length||iy()||(To??={position:Fe.position.clone(),target:Sn.target.clone()},fd(Ao,{byItself:!0}))}var To=null;function sy(){if(!To||gc||!Sn.enabled)return;let n=To;To=null,dd(n),setTimeout(Ba,500)}var vm=n=>{Ao=n},pd=()=>[...Fe.position.toArray(),...Sn.target.toArray()].map(n=>Number(n.toPrecision(5)));function ry(n){mm+=1,dd({position:new k(...n.slice(0,3)),target:new k(...n.slice(3))},0)}var Ys=null,bm={cell:.1};function Sm(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;bm.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ee(ae.gridFine),c=new ee(ae.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?c:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}Ys?.geometry.dispose();let l=new Pe;l.setAttribute("position",new Ae(r,3)),l.setAttribute("color",new Ae(o,3)),Ys?Ys.geometry=l:(Ys=new _o(l,new bs({vertexColors:!0})),Ys.renderOrder=-2,Ys.material.depthWrite=!1,zn.add(Ys)),Ys.userData.reach=n,Ie()}function Mm(){zn.background=new ee(ae.ground),zn.fog.color.set(ae.ground),Ys&&Sm(Ys.userData.reach),Ie()}function Li(n){Fe.updateMatrixWorld();let t=new k(...n).project(Fe),e=ls.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function md(n){let t=n.joints.length,e=Ri(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function wm(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,c=o*1e-6,l=kf(n,t),u=(d,f,g,y=!0)=>{ts(Ai(f,d))<=c||(s.rods.push({a:d,b:f,r:g}),y&&s.balls.push({at:f,r:g}))};a&&(s.pedestal={at:oe(t[0]),dir:ks(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(l.forEach(({point:d,dir:f,x:g},y)=>{let p=r[y],m=n.joints[y],x=oe(t[y]),w=oe(t[y+1]),v=p*.62;if(n.convention==="standard"){let B=_l(x,f,gl(Ai(w,x),f));u(x,B,v),u(B,w,v)}else u(x,d,v),u(d,w,v);let A=d,T=gl(Ai(w,d),f);h&&ts(Ai(d,h.at))<.5*p&&Math.abs(T)>c?A=_l(d,f,Math.sign(T)*Math.min(Math.abs(T)*.55,h.r+p*1.15)):y===0&&Math.abs(T)>2.2*p&&(A=_l(d,f,Math.sign(T)*p*1.25));let _=p*2.15,b=ks(t[y+1],0),L=!!(i&&Em(m,i[y])),I=ks(t[0],2),D=gl(Ai(A,oe(t[0])),I)-_/2;y===0&&m.type==="R"&&Math.abs(gl(f,I))>.99&&D<0&&D>-_&&(A=_l(A,I,-D)),m.type==="R"?s.drums.push({at:A,dir:f,x:g,turned:b,r:p,h:_,beyond:L,joint:y}):s.sleeves.push({at:A,dir:f,x:g,r:p*.95,h:p*3.4,beyond:L,joint:y}),h={at:d,r:p}}),a){let d=t[a+1],f=oe(t[a]);s.flange={at:f,dir:ks(t[a],2),turned:ks(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,oe(d),e.rest*.34,!1),s.tip={at:oe(d),r:e.rest*.42}}return s}function Em(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function _c(n,t){let e=md(n).radius[0]??.05,i=oe(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(oe)];for(let{point:r}of kf(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function AR(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new Jl(s.map(([a,c])=>new qt(a,c)),n):new Wi(1,1,1,n),o={rod:i(new Wi(1,1,1,n,1,!0)),ball:t>3?new vo(1,n,t):new Kl(1,0),drum:i(r),box:new ss(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,c])=>{let l=c.attributes.position,u=c.index?c.index.array:Uint16Array.from({length:l.count},(h,d)=>d);return[a,{at:l.array,normal:c.attributes.normal.array,index:u,count:l.count}]}))}var oy=new Map,Cm=(n,t)=>oy.get(n)??oy.set(n,AR(n,t)).get(n),RR=()=>Cm(26,12),Tm=()=>Cm(11,5),ay=()=>Cm(6,3),_d=class{constructor(t){this.mesh=new bn(new Pe,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Pe,r=(a,c)=>{let l=new Float32Array(c*t);i[a]&&l.set(i[a].array);let u=new Ze(l,c).setUsage(Qh);return s.setAttribute(a,u),l};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new Ze(o,1).setUsage(Qh)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,c){let l=this.corners,u=l+t.count;(3*u>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(u,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let h=0,d=3*l;h<3*t.count;h+=3,d+=3){let f=a*t.at[h],g=a*t.at[h+1],y=c*t.at[h+2],p=t.normal[h]/a,m=t.normal[h+1]/a,x=t.normal[h+2]/c;for(let w=0;w<3;w++)this.at[d+w]=i[w]+s[w]*f+r[w]*g+o[w]*y,this.normal[d+w]=s[w]*p+r[w]*m+o[w]*x}this.paint.fill(e,l,u);for(let h=0;h<t.index.length;h++)this.index[this.indices+h]=l+t.index[h];this.corners=u,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},cy=[1,0,0],CR=[0,1,0],uy=[0,0,1];function PR(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:Kc(n,Math.abs(n[2])<.9?uy:cy),i=Kc(n,e),s=ts(i)||1,r=i.map(o=>o/s);return[Kc(r,n),r]}var Am=0,gd=1,Rm=2,ly=3,ka=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new Jn,this.veil=i,this.moving=!1,this.arms=[],this.body=new _d(t),this.group.add(this.body.mesh),e&&(this.flat=new _d(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?ay:Tm:this.moving?Tm:RR;for(let i of t)this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of t)this.#t(this.flat,i,this.moving?ay():Tm(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(l,u,h,d,f,g,y)=>t.put(l,u,h,...PR(d,y),d,f,g),c=(l,u,h)=>t.put(i.ball,l,u,cy,CR,uy,h,h);for(let{a:l,b:u,r:h}of e.rods){let d=Ai(u,l),f=ts(d),g=[(l[0]+u[0])/2,(l[1]+u[1])/2,(l[2]+u[2])/2];a(i.rod,Am,g,d.map(y=>y/f),r*h,f)}for(let{at:l,r:u}of e.balls)c(Am,l,r*u);for(let{at:l,dir:u,turned:h,r:d,h:f,beyond:g}of e.drums){if(a(i.drum,g&&o?ly:gd,l,u,r*d,r*f),!o)continue;a(i.rod,Rm,l,u,d*1.012,f*.13);let y=[0,1,2].map(p=>l[p]+h[p]*d*.96);a(i.box,Am,y,u,d*.11,f*.86,h)}for(let{at:l,dir:u,x:h,r:d,h:f,beyond:g}of e.sleeves)a(i.box,g&&o?ly:gd,l,u,r*d,r*f,h);if(e.pedestal&&!this.veil){let{at:l,dir:u,r:h,h:d}=e.pedestal;a(i.drum,gd,[l[0]+u[0]*d/2,l[1]+u[1]*d/2,l[2]+u[2]*d/2],u,h,d)}if(e.flange&&a(i.drum,gd,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:l,dir:u,turned:h,r:d,h:f}=e.flange;a(i.box,Rm,[0,1,2].map(g=>l[g]+h[g]*d*.95),u,d*.16,f*1.04,h)}e.tip&&o&&c(Rm,e.tip.at,e.tip.r)}};var IR=`
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
  }`,LR=`
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
  }`,DR=`
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
  }`,NR=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function xd({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new rs({vertexShader:e?DR:IR,fragmentShader:e?NR:LR,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ee)},opacity:{value:n},gloss:{value:t},sky:{value:new ee(.46,.46,.47)},ground:{value:new ee(.2,.2,.21)}}});return i.repaint=(s,r,o,a,c=o)=>{[s,r,o,c].forEach((l,u)=>i.uniforms.colours.value[u].set(l)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function Pm(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,c=new Pe;c.morphTargetsRelative=a;let l=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let g in h.attributes){if(!i.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+g+'" attribute exists among all geometries, or in none of them.'),null;r[g]===void 0&&(r[g]=[]),r[g].push(h.attributes[g]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let g in h.morphAttributes){if(!s.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[g].length!==n[0].morphAttributes[g].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+g+'" morph attribute.'),null;o[g]===void 0&&(o[g]=[]),o[g].push(h.morphAttributes[g]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let g;if(e)g=h.index.count;else if(h.attributes.position!==void 0)g=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,g,u),l+=g}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let g=0;g<f.count;++g)h.push(f.getX(g)+u);u+=n[d].attributes.position.count}c.setIndex(h)}for(let u in r){let h=hy(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;c.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let y=0;y<o[u].length;++y)f.push(o[u][y][d]);let g=hy(f);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;c.morphAttributes[u].push(g)}}}return c}function hy(n){let t,e,i,s=-1,r=0;for(let l=0;l<n.length;++l){let u=n[l];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new Ze(o,e,i),c=0;for(let l=0;l<n.length;++l){let u=n[l];if(u.isInterleavedBufferAttribute){let h=c/e;for(let d=0,f=u.count;d<f;d++)for(let g=0;g<e;g++){let y=u.getComponent(d,g);a.setComponent(d+h,g,y)}}else o.set(u.array,c);c+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var gr=["#d8343f","#1b9a50","#2f6fe0"];function Im(n,t){let e=new Wi(.028,.028,.82,8).translate(0,.41,0),i=new yo(.085,.22,12).translate(0,.9,0),s=Pm([e,i]).applyMatrix4(t),r=new ee(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new Ze(o,3)),s}var Lm=n=>new be().makeRotationFromQuaternion(new on().setFromUnitVectors(new k(0,1,0),new k(...n))),UR=Pm([Im(gr[0],Lm([1,0,0])),Im(gr[1],Lm([0,1,0])),Im(gr[2],Lm([0,0,1]))]),dy=.021,xc=new Map;function FR(n){let t=`${n}/${ae.dark}`;if(xc.has(t))return xc.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=ae.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=ae.ink,s.fillText(n,e.width/2,e.height/2);let o=new Xl(e);o.colorSpace=gi;let a=new Aa({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,xc.set(t,a),a}var za=class{constructor(){this.group=new Jn,this.mesh=new ql(UR,new bi({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new be;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new k(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new Vl);a.parent||this.group.add(a),a.material=FR(r),a.scale.set(dy*a.material.userData.aspect,dy,1),a.renderOrder=5;let c=e*.16;a.position.set(s[3]-c*(s[0]+s[1]+s[2]),s[7]-c*(s[4]+s[5]+s[6]),s[11]-c*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of xc.values())t.map.dispose(),t.dispose();xc.clear(),this.last&&this.show(...this.last)}};var Nm=180/Math.PI,Di={angle:"deg",length:"mm"},OR={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},Dm={deg:Nm,rad:1,mm:1e3,m:1},BR={deg:2,rad:4,mm:2,m:5},kR={deg:1,rad:.02,mm:5,m:.005},mt={get angle(){return Di.angle},get length(){return Di.length},set(n,t){t in Dm&&n in Di&&(Di[n]=t)},factor:n=>n in Di?Dm[Di[n]]:1,symbol:n=>n in Di?OR[Di[n]]:"",digits:n=>n in Di?BR[Di[n]]:4,step:n=>n in Di?kR[Di[n]]/Dm[Di[n]]:.01,suffix:n=>n==="angle"?{deg:Nm,"\xB0":Nm,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function Qn(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var Hn=(n,t,e=mt.digits(t))=>Qn(n*mt.factor(t),e),We=(n,t,e)=>`${Hn(n,t,e)}${t==="angle"&&Di.angle==="deg"?"":" "}${mt.symbol(t)}`,yc=(n,t="plain")=>String(Number((n*mt.factor(t)).toPrecision(9))+0),yd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function Ha(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||mt.digits(t))/mt.factor(t)}var Um=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],Ga=n=>[Math.cos(n),Math.sin(n)];function zR([n,t,e]){let[i,s]=Ga(e),[r,o]=Ga(t),[a,c]=Ga(n);return Um([i*r,s*r,-o],[i*o*c-s*a,s*o*c+i*a,r*c],[i*o*a+s*c,s*o*a-i*c,r*a])}function HR(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function GR([n,t,e]){let[i,s]=Ga(n),[r,o]=Ga(t),[a,c]=Ga(e);return Um([i*r*a-s*c,s*r*a+i*c,-o*a],[-i*r*c-s*a,-s*r*c+i*a,o*c],[i*o,s*o,r])}function VR(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function vd(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],c=n[2]+n[8],l=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,c/i],[r/i,a/i,i/4,l/i],[o/i,c/i,l/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function vc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return Um([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function WR(n){let[t,e,i,s]=vd(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function qR([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:vc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Es={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:HR,from:zR},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:VR,from:GR},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:WR,from:qR},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:vd,from:vc}};function fy(n,t,e){let i=Es[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function py(n,t,e){let i=vd(n),s=vd(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[c,l]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=vc(i.map((h,d)=>c*h+l*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var Va=.145,Md=.105,Vm=.165,my={mouse:13,pen:16,touch:28},$R=.2,Kr=["x","y","z"],Sc=72,Ro=new Jn,Sd=new Map,km="both",wd="local",Wm=0,_r=!1,zm=null,je=null,Ed=()=>je!==null,vy=()=>_r,jr=null,Jr=null;function by(){Ro.visible=!1,zn.add(Ro),Jx(qm),Jr=document.getElementById("view"),jr=S("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(jr),Jr.addEventListener("pointerdown",QR,!0),Jr.addEventListener("pointermove",eC,!0);for(let n of["pointerup","pointercancel"])Jr.addEventListener(n,Cy,!0);addEventListener("keydown",n=>n.key==="Escape"&&je&&iC()),ct(["target","theme"],Ie)}function bc(n,t,e=8){let i=new bi({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new bn(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var XR=[new on().setFromUnitVectors(new k(0,1,0),new k(1,0,0)),new on,new on().setFromUnitVectors(new k(0,1,0),new k(0,0,1))],YR=[new on().setFromUnitVectors(new k(0,0,1),new k(1,0,0)),new on().setFromUnitVectors(new k(0,0,1),new k(0,1,0)),new on];function ZR(){if(Sd.size)return;let n=(t,e)=>{Sd.set(t,e),Ro.add(e)};Kr.forEach((t,e)=>{let i=new Wi(.0032,.0032,Va*.8,8).translate(0,Va*.45,0),s=new yo(.0125,.034,14).translate(0,Va*.9,0),r=new Jn;r.add(bc(i,gr[e]),bc(s,gr[e])),r.userData.turn=XR[e],n(`move-${t}`,r);let o=bc(new Ca(Md,.0026,6,Sc),gr[e],7);o.userData.turn=YR[e],n(`turn-${t}`,o)}),n("turn-view",bc(new Ca(Vm,.0022,6,Sc),"#8891a0",7)),n("move-view",bc(new vo(.0115,14,10),"#8891a0",9))}var bd=new k,Qr=new k,Fm=new on;function Td(){return 2*Math.tan(Zr.degToRad(Fe.fov/2))*Fe.position.distanceTo(bd)}var wc=()=>wd==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):jR(),jR=()=>[0,1,2].map(n=>ks(E.target,n)),JR=new be;function qm(){if(Ro.visible=_r,!_r)return;bd.set(...oe(E.target)),Qr.copy(Fe.position).sub(bd).normalize(),wd==="world"?Fm.identity():Fm.setFromRotationMatrix(JR.set(...E.target)),Ro.position.copy(bd),Ro.scale.setScalar(Td());let n=wc();for(let[t,e]of Sd){let[i,s]=t.split("-"),r=Kr.indexOf(s),o=km==="both"||km===i;e.visible=o&&KR(i,n[r])&&(!je||je.name===t),s==="view"?e.quaternion.copy(Fe.quaternion):e.quaternion.copy(Fm).multiply(e.userData.turn);let a=t===(je?.name??zm);e.traverse(c=>c.material?.color.set(a?ae.accent:c.userData.colour))}}function KR(n,t){return!t||n!=="move"?!0:Math.hypot(...Sy(t,Qr.toArray()))>$R}var Sy=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Mc=(n,t)=>oe(E.target).map((e,i)=>e+t*n[i]);function Hm(n,t){let e=wc(),[i,s]=n<0?[gy(Fe.matrixWorld,0),gy(Fe.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Sc+1},(r,o)=>{let a=2*Math.PI*o/Sc,c=i.map((l,u)=>Math.cos(a)*l+Math.sin(a)*s[u]);return{p:Mc(c,t),front:n<0||c.reduce((l,u,h)=>l+u*Qr.getComponent(h),0)>-.15}})}var gy=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function _y(n,t,[e,i],[s,r]){let o=s-e,a=r-i,c=o*o+a*a,l=c>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/c,0),1):0;return Math.hypot(n-e-l*o,t-i-l*a)}function Gm(n,t){let e=Td(),i=[];for(let[s,r]of Sd){if(!r.visible)continue;let[o,a]=s.split("-"),c=Kr.indexOf(a),l=1/0;if(o==="move"&&c<0){let[u,h]=Li(oe(E.target));l=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=wc()[c],h=Li(Mc(u,.92*Va*e));l=Math.min(_y(n,t,Li(Mc(u,.3*Va*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Hm(c,(c<0?Vm:Md)*e).map(h=>({...h,s:Li(h.p)}));for(let h=0;h<Sc;h++)u[h].front&&(l=Math.min(l,_y(n,t,u[h].s,u[h+1].s)+(c<0?2:0)))}i.push([s,l])}return i.sort((s,r)=>s[1]-r[1])}function My(n){if(!_r)return null;qm();let[t]=Gm(n.clientX,n.clientY);return t&&t[1]<=(my[n.pointerType]??my.mouse)?t[0]:null}function wy(){if(!_r)return{};qm();let n=Td(),t=wc(),e={"move-view":Li(oe(E.target))};return Kr.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(l=>Li(Mc(t[s],l*Va*n))).find(([l,u])=>Gm(l,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let c=Hm(s,Md*n).filter(l=>l.front).map(l=>Li(l.p)).filter(([l,u])=>Gm(l,u)[0]?.[0]===`turn-${i}`);c.length&&(e[`turn-${i}`]=c[Math.floor(c.length/2)])}),e["turn-view"]=Li(Hm(-1,Vm*n)[9].p),e}var xy=new nc,yy=new qt;function Ey(n){let t=Xi.domElement.getBoundingClientRect();return yy.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),xy.setFromCamera(yy,Fe),xy.ray}function Ty(n,t,e){let{origin:i,direction:s}=Ey(e),r=new k(...n),o=new k(...t).sub(i),a=r.dot(s),c=1-a*a;return c<1e-6?0:(a*s.dot(o)-r.dot(o))/c}function Ay(n,t,e){let i=new ei().setFromNormalAndCoplanarPoint(n,new k(...t));return Ey(e).intersectPlane(i,new k)}function QR(n){if(n.button!==0)return;let t=My(n);if(!t)return;n.stopPropagation(),n.preventDefault(),Jr.focus({preventScroll:!0}),Jr.setPointerCapture(n.pointerId),Sn.enabled=!1;let[e,i]=t.split("-"),s=Kr.indexOf(i),r=s<0?Qr.toArray():wc()[s].slice();je={name:t,what:e,axis:r,i:s,T:E.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},je.start=e==="turn"?Ry(n):s<0?Ay(Qr,oe(je.T),n):Ty(r,oe(je.T),n),Ie()}function Ry(n){let[t,e]=Li(oe(je.T)),i=je.axis.reduce((h,d,f)=>h+d*Qr.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Sy(je.axis,Qr.toArray()),r=Td(),o=Li(oe(je.T)),a=Li(Mc(s,Md*r)),c=a[0]-o[0],l=a[1]-o[1],u=Math.hypot(c,l)||1;return((n.clientX-je.x)*c+(n.clientY-je.y)*l)/(u*u)}var tC=n=>Math.atan2(Math.sin(n),Math.cos(n)),Om=(n,t,e)=>{let i=Wm||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function eC(n){if(!je){if(n.buttons||!_r)return;let c=My(n);c!==zm&&(zm=c,Jr.style.setProperty("cursor",c?"grab":""),Ie());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=je,r=wd==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let c=Ry(n);je.total+=tC(c-(je.before??je.start)),je.before=c;let l=Om(je.total,n,Math.PI/180),u=Math.sin(l/2);o=zi(vc([Math.cos(l/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${Bm(l,"angle")} about ${s<0?"the line of sight":r+Kr[s]}`}else if(s<0){let c=Ay(Qr,oe(t),n);if(!c)return;let l=c.sub(je.start);(Wm||n.shiftKey)&&l.set(...l.toArray().map(u=>Om(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+l.getComponent(h)}),a=l.toArray().map((u,h)=>`${Kr[h]} ${Bm(u,"length")}`).join(", ")}else{let c=Om(Ty(e,oe(t),n)-je.start,n,.001);[3,7,11].forEach((l,u)=>{o[l]=t[l]+c*e[u]}),a=`${Bm(c,"length")} along ${r}${Kr[s]}`}pi(o,"drag"),nC(a,n),Ie()}var Bm=(n,t)=>`${n>=0?"+":""}${We(n,t,mt.digits(t))}`;function nC(n,t){let e=Jr.getBoundingClientRect();jr.hidden=!1,Et(jr,n),jr.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-jr.offsetWidth-8)}px`),jr.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Cy(n){je&&(n.stopPropagation(),je=null,jr.hidden=!0,Sn.enabled=!0,pi(E.target,"dropped"),Ie())}function iC(){let{T:n}=je;pi(n,"drag"),Cy({stopPropagation(){}})}function Py(){_r&&ZR(),Ro.visible=_r,xt("frames"),Ie()}function Iy(n){_r=n,Py()}function Ly(n){km=n,Py()}function Dy(n){wd=n,Ie()}function Ny(n){Wm=n}var ky=xd(),Fy=[.32,-.4,1],zy=new bi({color:"#000",transparent:!0,opacity:.1,side:os,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Gp,stencilRef:1,stencilZPass:Hp,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),sC=new be().set(1,0,-Fy[0],0,0,1,-Fy[1],0,0,0,0,5e-4,0,0,0,1),Cd=new ka(ky,{shadow:{material:zy,matrix:sC}}),Hy=xd({opacity:.2,veil:!0}),Ad=new ka(Hy,{veil:!0}),Gy=xd({opacity:.62,gloss:.1}),Xm=new ka(Gy,{veil:!0}),Id=new za,Co=md(E.table),Ld=[],Pd=null;function Vy(){zn.add(Cd.group,Ad.group,Xm.group,Id.group),Ad.group.renderOrder=1,ct("table",n=>{Co=md(E.table),Sm(Co.size),Ld=[],Pd=null,Ym(),Nd(),n==="new"&&Ac({instant:!0,view:"iso"}),Kx()}),ct("q",oC),ct("frames",$y),ct("theme",By),ct("hurry",n=>{for(let t of[Cd,Ad,Xm])t.hurry(n)}),By()}var Oy=new Map,Tc=[],$m=0;function yr(n,t){if(Oy.set(n,t),Tc=[...Oy.values()].flat(),!E.table.joints.length)return;let e=$m;$m=Tc.length,vm([..._c(E.table,E.frames),...Tc]),t.length?qy():e>$m&&rC()}var rC=zs(sy,120);function Wy(n,t){let e=Math.max(1,Math.floor(t.length/40)),i=t.filter((r,o)=>o%e===0||o===t.length-1).flatMap(r=>_c(n,ms(n,r))),s=[0,1,2].map(r=>[Math.min(...i.map(o=>o[r])),Math.max(...i.map(o=>o[r]))]);yr("motion",i.length?s[0].flatMap(r=>s[1].flatMap(o=>s[2].map(a=>[r,o,a]))):[])}function Ac(n){fd([..._c(E.table,E.frames),...Tc],n)}var qy=zs(Ba,220);function oC(){let n=E.frames;Cd.show(E.table.joints.length?[wm(E.table,n,Co,E.q)]:[]),vm([..._c(E.table,n),...Tc]),qy(),Ky&&aC(oe(n[n.length-1])),$y()}function $y(){Id.show((E.shownFrames??[]).filter(n=>n<E.frames.length&&!(n===E.frames.length-1&&vy())).map(n=>({T:E.frames[n],name:Dd(n)})),Co.size*.13),Ie()}var Xy=()=>Cd.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),Yy=()=>(Id.last?.[0]??[]).map(n=>n.name);function Dd(n){let t=E.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function Zy(n){Ld=n,Ym()}function Wa(n){Pd=n,Ym()}var jy=()=>Ld.length;function Ym(){let n=t=>wm(E.table,ms(E.table,t),Co);Ad.show(Ld.map(n)),Xm.show(Pd?[n(Pd)]:[]),Ie()}var Jy=6e3,Rd=new Float32Array(6*Jy),xr=new _o(new Pe,new bs({fog:!1}));xr.geometry.setAttribute("position",new Ze(Rd,3));xr.frustumCulled=!1;xr.visible=!1;var to=0,Ky=!0,Ec=null;zn.add(xr);function aC(n){let t=Ec?ts(Ai(n,Ec)):1/0;t<Co.size*.002||(t<Co.size*.2&&(to===Jy&&(Rd.copyWithin(0,6*1e3),to-=1e3),Rd.set(Ec,6*to),Rd.set(n,6*to+3),to+=1,xr.geometry.setDrawRange(0,2*to),xr.geometry.attributes.position.needsUpdate=!0,xr.visible=!0),Ec=n)}function Qy(n){Ky=n,n||Nd(),Ie()}function Nd(){to=0,Ec=null,xr.visible=!1,Ie()}var tv=()=>to,Rc=new kr(new Pe,new bs({fog:!1}));Rc.frustumCulled=!1;var Cc=new xo(new Pe,new zr({size:4,sizeAttenuation:!1,fog:!1}));Cc.frustumCulled=!1;Rc.visible=Cc.visible=!1;zn.add(Rc,Cc);function Ud(n){yr("path",n);let t=new Float32Array(n.flat());for(let e of[Rc,Cc])e.geometry.dispose(),e.geometry=new Pe,e.geometry.setAttribute("position",new Ze(t,3)),e.visible=n.length>0;Ie()}function By(){ky.repaint(ae.link,ae.joint,ae.accent,ae.dark,ae.wrong),Hy.repaint(ae.ghost,ae.ghost,ae.ghost,ae.dark),Gy.repaint(ae.accent,ae.accent,ae.accent,ae.dark),xr.material.color.set(ae.accent),Rc.material.color.set(ae.trace),Cc.material.color.set(ae.trace),zy.opacity=ae.dark?.28:.11,Id.paint(),Ie()}var pe={follow:!0,ghosts:"all",task:null,redundancy:null},Zm={answers:0},Fd=!1,ev=Jo(async()=>{let n=Fd;Fd=!1;let t=E.target,e=E.table;try{let i=Ed()||jm,s=i?null:E.digits,{task:r,redundancy:o}=pe,a=await En("ik",{T:t,q:E.q,brief:i,task:r,redundancy:o,digits:s});if(e!==E.table||t!==E.target&&!i)return;Zm.answers+=1,E.solutions={...a,T:t,brief:i},n&&pe.follow&&a.nearest&&Ci(a.nearest,"follow"),qa(),xt("solutions"),!i&&!a.rows.some(c=>c.inside)&&uC(t),a.self_motions===null&&!i&&cC(E.solutions)}catch(i){if(i instanceof iu)return;E.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},qa(),xt("solutions")}}),jm=!1;function nv(){jm=!0,Fd=!0,ev()}function Ts({follow:n=!1}={}){jm=!1,Fd||=n,ev()}var cC=Jo(async n=>{try{let t={T:n.T,q:E.q,task:pe.task,redundancy:pe.redundancy},{self_motions:e}=await En("self_motions",t);if(E.solutions!==n||!e)return;n.self_motions=e,xt("solutions")}catch{}}),uC=Jo(async n=>{try{let t=await En("nearest",{T:n,task:pe.task});E.solutions&&E.solutions.T===n&&(E.solutions.near=t,xt("solutions"))}catch{}}),hC=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function qa(){let n=E.solutions?.rows??[],t=E.panel==="inverse"&&pe.ghosts!=="none"?n.filter(e=>(pe.ghosts==="all"||e.inside)&&!hC(e.q,E.q)):[];Zy(t.map(e=>e.q))}function iv(){ct("target",n=>{E.panel==="inverse"&&Ts({follow:P0.has(n)})}),ct("task",()=>{xt("plan"),E.panel==="inverse"&&E.hasTarget&&Ts()}),ct("panel",n=>{Wa(null),n==="inverse"&&E.hasTarget&&!E.solutions&&Ts(),qa()}),ct("moving",n=>{n||qa()}),ct("table",n=>{pe.redundancy=null,n==="new"&&(pe.task=null),xt("solutions"),n!=="new"&&E.panel==="inverse"&&E.hasTarget&&Ts()}),ct("online",n=>{n&&E.panel==="inverse"&&E.hasTarget&&E.table.joints.length&&Ts()})}var Pc=0;function Mi(){Pc+=1,E.moving&&(E.moving=!1,xt("moving",!1))}function wi(n,t=.8,e="move to a posture"){Mi(),xt("let-go"),xt("did",{label:e});let i=E.q.slice(),s=Pc,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),E.moving=!0,xt("moving",!0),new Promise(o=>{(function a(c){if(s!==Pc||i.length!==E.q.length){o(!1);return}let l=t>0?Math.min(Math.max((c-r)/(1e3*t),0),1):1,u=l**3*(10-15*l+6*l*l);Ci(l<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),l<1?requestAnimationFrame(a):(E.moving=!1,xt("moving",!1),o(!0))})(r)})}function sv(n,t,e,i){Mi();let s=Pc,r=performance.now()-1e3*n*t;E.moving=!0,xt("moving",!0),requestAnimationFrame(function o(a){if(s!==Pc){i?.(!1);return}let c=Math.min(Math.max((a-r)/(1e3*n),0),1);e(c),c<1?requestAnimationFrame(o):(E.moving=!1,xt("moving",!1),i?.(!0))})}var fC=200,pC=1500,Po=[],Dc=[],Lc=null,Ic={key:null,at:0,open:!1},Jm=!1,Od=()=>({table:E.table,q:E.q,target:E.target,digits:E.digits,hasTarget:E.hasTarget,path:{...E.path},sequence:structuredClone(E.sequence),program:E.program,world:E.world,limits:E.limits,start:E.start,task:pe.task,redundancy:pe.redundancy});function Km(){Jm||(Jm=!0,queueMicrotask(()=>{Jm=!1,Lc=Od()}))}function mC({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===Ic.key&&(Ic.open||i-Ic.at<pC))&&Lc&&(Po.push({label:n,before:Lc}),Po.length>fC&&Po.shift(),Dc.length=0),Ic={key:t,at:i,open:e},Km(),xt("history")}function Qm(){Ic={key:null,at:0,open:!1}}function gC(n){Mi(),Qm(),pe.task=n.task,n.table!==E.table?un(n.table,{q:n.q,step:!1,what:"undo"}):Ci(n.q,"undo"),pe.redundancy=n.redundancy,Object.assign(E.path,n.path),E.sequence=structuredClone(n.sequence),E.program=n.program,E.world=n.world,E.limits=n.limits,E.start=n.start,E.hasTarget=n.hasTarget,n.target!==E.target&&pi(n.target,"restored",n.digits);for(let t of["path-loaded","sequence-loaded","program","world","task"])xt(t,"undo")}function rv(n,t,e){let i=n.pop();if(!i)return;let s=Od();gC(i.before),t.push({label:i.label,before:s}),Km(),xt("history"),vn(`${e}: ${i.label}`)}var tg=()=>rv(Po,Dc,"Undone"),eg=()=>rv(Dc,Po,"Redone"),Bd=()=>Po.at(-1)?.label??null,kd=()=>Dc.at(-1)?.label??null;function zd(){Po.length=0,Dc.length=0,Qm(),Lc=Od(),xt("history")}function ov(){Lc=Od(),ct("did",mC),ct("let-go",Qm),ct(["table","q","target","path","sequence","program","world","task"],Km)}var cv=1,uv=30;function Hd(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:c,theme:l}=E;return{pieper:cv,table:n,q:t,target:i?e:null,digits:E.digits,task:pe.task,redundancy:pe.redundancy,follow:pe.follow,ghosts:pe.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:E.program,start:E.start,limits:E.limits},world:E.world,panel:c,theme:l,units:[mt.angle,mt.length],camera:pd()}}var ai=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,vr=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(ai),As=(n,t)=>typeof n=="string"?n.slice(0,t):"",br=n=>{if(!vr(n,16))return null;let t=Qc(n);return t<1e-12?n.slice():t<.001?tu(n):null},xC=n=>n&&ai(n.metres)&&ai(n.radians)?{metres:n.metres,radians:n.radians}:null,yC=n=>n&&[n.lower,n.upper,n.value].every(ai)&&n.lower<=n.upper?{name:As(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:As(n.unit,10)}:null,vC=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>vr(e,t))?n:null;function bC(n){if(!n||!Array.isArray(n.joints)||n.joints.length>uv||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>ai(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:As(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:ai(i.lower)?i.lower:null,upper:ai(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>vr(i,t.length)).slice(0,40));return{name:As(n.name,60),convention:n.convention,joints:t,base:br(n.base)??er(),tool:br(n.tool)??er(),postures:e,manufacturer:As(n.manufacturer,200),source:As(n.source,2e3),notes:As(n.notes,3e3),actuator:yC(n.actuator),catalog:As(n.catalog,60)||void 0,derived:As(n.derived,60)||void 0,coupling:vC(n.coupling,t.length)}}var av={joint:0,line:0,circle:0,wait:"seconds",gripper:"value",output:"port"};function SC(n,t){if(!n||!Object.hasOwn(av,n.kind))return null;let e=av[n.kind];if(e)return ai(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;let i=n.kind==="joint"&&vr(n.q,t)?n.q.slice():null,s=br(n.T);if(!s||n.kind==="circle"&&!br(n.via))return null;let r=(o,a)=>a===null?{}:{[o]:a};return{kind:n.kind,...r("q",i),T:s,...r("via",br(n.via)),...r("speed",ai(n.speed)&&n.speed>0?n.speed:null),blend:ai(n.blend)&&n.blend>=0?n.blend:0}}var ng={frame:[],box:["size"],cylinder:["r","h"]};function MC(n){if(!n||!Object.hasOwn(ng,n.kind))return null;let t=br(n.T),e=As(n.name,40),i=s=>s==="size"?vr(n.size,3)&&n.size.every(r=>r>0):ai(n[s])&&n[s]>0;return!t||!e||!ng[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(ng[n.kind].map(s=>[s,n[s]]))}}function wC(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};E.program=e(i.steps,s=>SC(s,t),200),E.start=vr(i.start,t)?i.start.slice():null,E.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||ai(r)&&r>0))),E.world=e(n.world,MC,60)}function Gd(n,t){let e=n&&n.pieper===cv?bC(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(mt.set("angle",n.units[0]),mt.set("length",n.units[1])),Object.hasOwn(Es,n.notation)&&(E.notation=n.notation),["auto","light","dark"].includes(n.theme)&&ld(n.theme),E.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};un(e,{q:vr(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(E.path,{from:br(s.from),to:br(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:ai(s.seconds)&&s.seconds>0?s.seconds:5}),E.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&vr(a.q,i)&&ai(a.seconds)&&ai(a.hold)).slice(0,40).map(a=>({name:As(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),wC(n,i),["pose","position","position+axis"].includes(n.task)&&(pe.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,c])=>a.length<80&&ai(c));pe.redundancy=r.length?Object.fromEntries(r.slice(0,uv)):null,typeof n.follow=="boolean"&&(pe.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(pe.ghosts=n.ghosts);let o=br(n.target);E.hasTarget=!!o,o&&pi(o,"restored",xC(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])xt(a);t(n.panel),xt("path-loaded"),vr(n.camera,6)&&ry(n.camera),Ci(E.q,"restored"),zd()}async function hv(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function Vd(){let n=await hv(new TextEncoder().encode(JSON.stringify(Hd())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function dv(){let n=EC();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await hv(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var fv="pieper-workbench";function EC(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(fv)??"{}");return t&&n===location.href?t:null}catch{return null}}function TC(){if(E.table.joints.length)try{sessionStorage.setItem(fv,JSON.stringify({address:location.href,shown:Hd()}))}catch{}}var lv=null,AC=zs(async()=>{if(!E.table.joints.length)return;let n=await Vd();n!==lv&&(lv=n,history.replaceState(null,"",n))},600);function pv(){addEventListener("pagehide",TC),ct(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","theme","frames"],AC)}var CC="uplot",PC="u-hz",IC="u-vt",LC="u-title",DC="u-wrap",NC="u-under",UC="u-over",FC="u-axis",Do="u-off",OC="u-select",BC="u-cursor-x",kC="u-cursor-y",zC="u-cursor-pt",HC="u-legend",GC="u-live",VC="u-inline",WC="u-series",qC="u-marker",mv="u-label",$C="u-value",Uc="width",Fc="height";var gv="bottom",$a="left",ig="right",vg="#000",_v=vg+"0",sg="mousemove",xv="mousedown",rg="mouseup",yv="mouseenter",vv="mouseleave",bv="dblclick",XC="resize",YC="scroll",Sv="change",Yd="dppxchange",bg="--",Qa=typeof window<"u",ug=Qa?document:null,Ya=Qa?window:null,ZC=Qa?navigator:null,Oe,Wd;function hg(){let n=devicePixelRatio;Oe!=n&&(Oe=n,Wd&&fg(Sv,Wd,hg),Wd=matchMedia(`(min-resolution: ${Oe-.001}dppx) and (max-resolution: ${Oe+.001}dppx)`),No(Sv,Wd,hg),Ya.dispatchEvent(new CustomEvent(Yd)))}function Yi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function dg(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function an(n,t,e){n.style[t]=e+"px"}function Rs(n,t,e,i){let s=ug.createElement(n);return t!=null&&Yi(s,t),e?.insertBefore(s,i),s}function cs(n,t){return Rs("div",n,t)}var Mv=new WeakMap;function Zs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Mv.get(n);r!=o&&(n.style.transform=r,Mv.set(n,r),t<0||e<0||t>i||e>s?Yi(n,Do):dg(n,Do))}var wv=new WeakMap;function Ev(n,t,e){let i=t+e,s=wv.get(n);i!=s&&(wv.set(n,i),n.style.background=t,n.style.borderColor=e)}var Tv=new WeakMap;function Av(n,t,e,i){let s=t+""+e,r=Tv.get(n);s!=r&&(Tv.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Sg={passive:!0},jC={...Sg,capture:!0};function No(n,t,e,i){t.addEventListener(n,e,i?jC:Sg)}function fg(n,t,e,i){t.removeEventListener(n,e,Sg)}Qa&&hg();function Cs(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Zi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function eb(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var nb=n=>n!=null,ib=n=>n!=null&&n>0,Jd=eb(nb),JC=eb(ib);function KC(n,t,e,i=0,s=!1){let r=s?JC:Jd,o=s?ib:nb;[t,e]=r(n,t,e);let a=n[t],c=n[t];if(t>-1)if(i==1)a=n[t],c=n[e];else if(i==-1)a=n[e],c=n[t];else for(let l=t;l<=e;l++){let u=n[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??Je,c??-Je]}function Kd(n,t,e,i){let s=Pv(n),r=Pv(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Sr:sb,a=s==1?Zi:us,c=r==1?us:Zi,l=a(o(Vn(n))),u=c(o(Vn(t))),h=Za(e,l),d=Za(e,u);return e==10&&(l<0&&(h=Ke(h,-l)),u<0&&(d=Ke(d,-u))),i||e==2?(n=h*s,t=d*r):(n=lb(n,h),t=Qd(t,d)),[n,t]}function Mg(n,t,e,i){let s=Kd(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var wg=.1,Rv={mode:3,pad:wg},Bc={pad:0,soft:null,mode:0},QC={min:Bc,max:Bc};function Zd(n,t,e,i){return tf(e)?Cv(n,t,e):(Bc.pad=e,Bc.soft=i?0:null,Bc.mode=i?3:0,Cv(n,t,QC))}function De(n,t){return n??t}function tP(n,t,e){for(t=De(t,0),e=De(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Cv(n,t,e){let i=e.min,s=e.max,r=De(i.pad,0),o=De(s.pad,0),a=De(i.hard,-Je),c=De(s.hard,Je),l=De(i.soft,Je),u=De(s.soft,-Je),h=De(i.mode,0),d=De(s.mode,0),f=t-n,g=Sr(f),y=Ei(Vn(n),Vn(t)),p=Sr(y),m=Vn(p-g);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&l!=Je&&(r=0),d==2&&u!=-Je&&(o=0)));let x=f||y||1e3,w=Sr(x),v=Za(10,Zi(w)),A=x*(f==0?n==0?.1:1:r),T=Ke(lb(n-A,v/10),24),_=n>=l&&(h==1||h==3&&T<=l||h==2&&T>=l)?l:Je,b=Ei(a,T<_&&n>=_?_:Ps(_,T)),L=x*(f==0?t==0?.1:1:o),I=Ke(Qd(t+L,v/10),24),D=t<=u&&(d==1||d==3&&I>=u||d==2&&I<=u)?u:-Je,B=Ps(c,I>D&&t<=D?D:Ei(D,I));return b==B&&b==0&&(B=100),[b,B]}var eP=new Intl.NumberFormat(Qa?ZC.language:"en-US"),Eg=n=>eP.format(n),ji=Math,Xd=ji.PI,Vn=ji.abs,Zi=ji.floor,Gn=ji.round,us=ji.ceil,Ps=ji.min,Ei=ji.max,Za=ji.pow,Pv=ji.sign,Sr=ji.log10,sb=ji.log2,nP=(n,t=1)=>ji.sinh(n)*t,og=(n,t=1)=>ji.asinh(n/t),Je=1/0;function Iv(n){return(Sr((n^n>>31)-(n>>31))|0)+1}function pg(n,t,e){return Ps(Ei(n,t),e)}function rb(n){return typeof n=="function"}function Re(n){return rb(n)?n:()=>n}var iP=()=>{},ob=n=>n,ab=(n,t)=>t,sP=n=>null,Lv=n=>!0,Dv=(n,t)=>n==t,rP=/\.\d*?(?=9{6,}|0{6,})/gm,Uo=n=>{if(ub(n)||no.has(n))return n;let t=`${n}`,e=t.match(rP);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Uo(s)}e${r}`}return Ke(n,i)};function Io(n,t){return Uo(Ke(Uo(n/t))*t)}function Qd(n,t){return Uo(us(Uo(n/t))*t)}function lb(n,t){return Uo(Zi(Uo(n/t))*t)}function Ke(n,t=0){if(ub(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Gn(i)/e}var no=new Map;function cb(n){return((""+n).split(".")[1]||"").length}function zc(n,t,e,i){let s=[],r=i.map(cb);for(let o=t;o<e;o++){let a=Vn(o),c=Ke(Za(n,o),a);for(let l=0;l<i.length;l++){let u=n==10?+`${i[l]}e${o}`:i[l]*c,h=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=n==10?u:Ke(u,h);s.push(d),no.set(d,h)}}return s}var kc={},Tg=[],ja=[null,null],eo=Array.isArray,ub=Number.isInteger,oP=n=>n===void 0;function Nv(n){return typeof n=="string"}function tf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function aP(n){return n!=null&&typeof n=="object"}var lP=Object.getPrototypeOf(Uint8Array),hb="__proto__";function Ja(n,t=tf){let e;if(eo(n)){let i=n.find(s=>s!=null);if(eo(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Ja(n[s],t)}else e=n.slice()}else if(n instanceof lP)e=n.slice();else if(t(n)){e={};for(let i in n)i!=hb&&(e[i]=Ja(n[i],t))}else e=n;return e}function Dn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=hb&&(tf(n[s])?Dn(n[s],Ja(i[s])):n[s]=Ja(i[s]))}return n}var cP=0,uP=1,hP=2;function dP(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function fP(n,t){if(gP(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return _P(o[0])||(o=mP(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let u=0;u<l;u++)e.add(c[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],h=Array(s).fill(void 0),d=t?t[o][l]:uP,f=[];for(let g=0;g<u.length;g++){let y=u[g],p=r.get(c[g]);y===null?d!=cP&&(h[p]=y,d==hP&&f.push(p)):h[p]=y}dP(h,f,s),i.push(h)}}return i}var pP=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function mP(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[i[c]];s.push(a)}return s}function gP(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function _P(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Ei(1,Zi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var db=["January","February","March","April","May","June","July","August","September","October","November","December"],fb=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function pb(n){return n.slice(0,3)}var xP=fb.map(pb),yP=db.map(pb),vP={MMMM:db,MMM:yP,WWWW:fb,WWW:xP};function Nc(n){return(n<10?"0":"")+n}function bP(n){return(n<10?"00":n<100?"0":"")+n}var SP={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Nc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Nc(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Nc(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Nc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Nc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>bP(n.getMilliseconds())};function Ag(n,t){t=t||vP;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?SP[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var MP=new Intl.DateTimeFormat().resolvedOptions().timeZone;function wP(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==MP?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var mb=n=>n%1==0,jd=[1,2,2.5,5],EP=zc(10,-32,0,jd),gb=zc(10,0,32,jd),TP=gb.filter(mb),Lo=EP.concat(gb),Rg=`
`,_b="{YYYY}",Uv=Rg+_b,xb="{M}/{D}",Oc=Rg+xb,qd=Oc+"/{YY}",yb="{aa}",AP="{h}:{mm}",Xa=AP+yb,Fv=Rg+Xa,Ov=":{ss}",ke=null;function vb(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,c=(n==1?zc(10,0,3,jd).filter(mb):zc(10,-3,0,jd)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,_b,ke,ke,ke,ke,ke,ke,1],[s*28,"{MMM}",Uv,ke,ke,ke,ke,ke,1],[s,xb,Uv,ke,ke,ke,ke,ke,1],[i,"{h}"+yb,qd,ke,Oc,ke,ke,ke,1],[e,Xa,qd,ke,Oc,ke,ke,ke,1],[t,Ov,qd+" "+Xa,ke,Oc+" "+Xa,ke,Fv,ke,1],[n,Ov+".{fff}",qd+" "+Xa,ke,Oc+" "+Xa,ke,Fv,ke,1]];function u(h){return(d,f,g,y,p,m)=>{let x=[],w=p>=o,v=p>=r&&p<o,A=h(g),T=Ke(A*n,3),_=ag(A.getFullYear(),w?0:A.getMonth(),v||w?1:A.getDate()),b=Ke(_*n,3);if(v||w){let L=v?p/r:0,I=w?p/o:0,D=T==b?T:Ke(ag(_.getFullYear()+I,_.getMonth()+L,1)*n,3),B=new Date(Gn(D/n)),V=B.getFullYear(),O=B.getMonth();for(let $=0;D<=y;$++){let Z=ag(V+I*$,O+L*$,1),q=Z-h(Ke(Z*n,3));D=Ke((+Z+q)*n,3),D<=y&&x.push(D)}}else{let L=p>=s?s:p,I=Zi(g)-Zi(T),D=b+I+Qd(T-b,L);x.push(D);let B=h(D),V=B.getHours()+B.getMinutes()/e+B.getSeconds()/i,O=p/i,$=d.axes[f]._space,Z=m/$;for(;D=Ke(D+p,n==1?0:3),!(D>y);)if(O>1){let q=Zi(Ke(V+O,6))%24,tt=h(D).getHours()-q;tt>1&&(tt=-1),D-=tt*i,V=(V+O)%24;let rt=x[x.length-1];Ke((D-rt)/p,3)*Z>=.7&&x.push(D)}else x.push(D)}return x}}return[c,l,u]}var[RP,CP,PP]=vb(1),[IP,LP,DP]=vb(.001);zc(2,-53,53,[1]);function Bv(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function kv(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],c,l,u,h,d,f;return i.map(g=>{let y=n(g),p=y.getFullYear(),m=y.getMonth(),x=y.getDate(),w=y.getHours(),v=y.getMinutes(),A=y.getSeconds(),T=p!=c&&a[2]||m!=l&&a[3]||x!=u&&a[4]||w!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return c=p,l=m,u=x,h=w,d=v,f=A,T(y)})}}function NP(n,t){let e=Ag(t);return(i,s,r,o,a)=>s.map(c=>e(n(c)))}function ag(n,t,e){return new Date(n,t,e)}function zv(n,t){return t(n)}var UP="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Hv(n,t){return(e,i,s,r)=>r==null?bg:t(n(i))}function FP(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function OP(n,t){return n.series[t].fill(n,t)}var BP={show:!0,live:!0,isolate:!1,mount:iP,markers:{show:!0,width:2,stroke:FP,fill:OP,dash:"solid"},idx:null,idxs:null,values:[]};function kP(n,t){let e=n.cursor.points,i=cs(),s=e.size(n,t);an(i,Uc,s),an(i,Fc,s);let r=s/-2;an(i,"marginLeft",r),an(i,"marginTop",r);let o=e.width(n,t,s);return o&&an(i,"borderWidth",o),i}function zP(n,t){let e=n.series[t].points;return e._fill||e._stroke}function HP(n,t){let e=n.series[t].points;return e._stroke||e._fill}function GP(n,t){return n.series[t].points.size}var lg=[0,0];function VP(n,t,e){return lg[0]=t,lg[1]=e,lg}function $d(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function cg(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var WP={show:!0,x:!0,y:!0,lock:!1,move:VP,points:{one:!1,show:kP,size:GP,width:0,stroke:HP,fill:zP},bind:{mousedown:$d,mouseup:$d,click:$d,dblclick:$d,mousemove:cg,mouseleave:cg,mouseenter:cg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},bb={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Cg=Dn({},bb,{filter:ab}),Sb=Dn({},Cg,{size:10}),Mb=Dn({},bb,{show:!1}),Pg='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wb="bold "+Pg,Eb=1.5,Gv={show:!0,scale:"x",stroke:vg,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wb,side:2,grid:Cg,ticks:Sb,border:Mb,font:Pg,lineGap:Eb,rotate:0},qP="Value",$P="Time",Vv={show:!0,scale:"x",auto:!1,sorted:1,min:Je,max:-Je,idxs:[]};function XP(n,t,e,i,s){return t.map(r=>r==null?"":Eg(r))}function YP(n,t,e,i,s,r,o){let a=[],c=no.get(s)||0;e=o?e:Ke(Qd(e,s),c);for(let l=e;l<=i;l=Ke(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function mg(n,t,e,i,s,r,o){let a=[],c=n.scales[n.axes[t].scale].log,l=c==10?Sr:sb,u=Zi(l(e));s=Za(c,u),c==10&&(s=Lo[Cs(s,Lo)]);let h=e,d=s*c;c==10&&(d=Lo[Cs(d,Lo)]);do a.push(h),h=h+s,c==10&&!no.has(h)&&(h=Ke(h,no.get(s))),h>=d&&(s=h,d=s*c,c==10&&(d=Lo[Cs(d,Lo)]));while(h<=i);return a}function ZP(n,t,e,i,s,r,o){let c=n.scales[n.axes[t].scale].asinh,l=i>c?mg(n,t,Ei(c,e),i,s):[c],u=i>=0&&e<=0?[0]:[];return(e<-c?mg(n,t,Ei(c,-i),-e,s):[c]).reverse().map(d=>-d).concat(u,l)}var Tb=/./,jP=/[12357]/,JP=/[125]/,Wv=/1/,gg=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function KP(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],c=n.valToPos,l=r._space,u=c(10,o),h=c(9,o)-u>=l?Tb:c(7,o)-u>=l?jP:c(5,o)-u>=l?JP:Wv;if(h==Wv){let d=Vn(c(1,o)-u);if(d<l)return gg(t.slice().reverse(),a.distr,h,us(l/d)).reverse()}return gg(t,a.distr,h,1)}function QP(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,c=n.valToPos,l=Vn(c(1,o)-c(2,o));return l<a?gg(t.slice().reverse(),3,Tb,us(a/l)).reverse():t}function tI(n,t,e,i){return i==null?bg:t==null?"":Eg(t)}var qv={show:!0,scale:"y",stroke:vg,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wb,side:3,grid:Cg,ticks:Sb,border:Mb,font:Pg,lineGap:Eb,rotate:0};function eI(n,t){let e=3+(n||1)*2;return Ke(e*t,3)}function nI(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Vn(o-r),c=n.series[t],l=a/(c.points.space*Oe);return i[1]-i[0]<=l}var $v={scale:null,auto:!0,sorted:0,min:Je,max:-Je},Ab=(n,t,e,i,s)=>s,Xv={show:!0,auto:!0,sorted:0,gaps:Ab,alpha:1,facets:[Dn({},$v,{scale:"x"}),Dn({},$v,{scale:"y"})]},Yv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ab,alpha:1,points:{show:nI,filter:null},values:null,min:Je,max:-Je,idxs:[],path:null,clip:null};function iI(n,t,e,i,s){return e/10}var Rb={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},sI=Dn({},Rb,{time:!1,ori:1}),Zv={};function Cb(n,t){let e=Zv[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,c,l){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,c,l)}},n!=null&&(Zv[n]=e)),e}var Ka=1,_g=2;function Fo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,c=r[0],l=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,c,l,u,h,p,m,d,f,g,y,nf,tl,rf,Ib,Db):e(s,c,l,u,h,m,p,f,d,y,g,sf,el,Dg,Lb,Nb)}function Ig(n,t){let e=0,i=0,s=De(n.bands,Tg);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function rI(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,c=n.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function Mr(n,t,e,i,s,r){return Fo(n,t,(o,a,c,l,u,h,d,f,g,y,p)=>{let m=o.pxRound,x=l.dir*(l.ori==0?1:-1),w=l.ori==0?tl:el,v,A;x==1?(v=e,A=i):(v=i,A=e);let T=m(h(a[v],l,y,f)),_=m(d(c[v],u,p,g)),b=m(h(a[A],l,y,f)),L=m(d(r==1?u.max:u.min,u,p,g)),I=new Path2D(s);return w(I,b,L),w(I,T,L),w(I,T,_),I})}function ef(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?rf:Dg,c=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,i,f,i+r),c=d[1]}}let l=e+s-c,u=10;l>0&&a(o,c,i-u/2,l,i+r+u)}return o}function oI(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Lg(n,t,e,i,s,r,o){let a=[],c=n.length;for(let l=s==1?e:i;l>=e&&l<=i;l+=s)if(t[l]===null){let h=l,d=l;if(s==1)for(;++l<=i&&t[l]===null;)d=l;else for(;--l>=e&&t[l]===null;)d=l;let f=r(n[h]),g=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<c?r(n[y]):f;let m=d+s;g=o>=0&&m>=0&&m<c?r(n[m]):g,g>=f&&a.push([f,g])}return a}function jv(n){return n==0?ob:n==1?Gn:t=>Io(t,n)}function Pb(n){let t=n==0?nf:sf,e=n==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},i=n==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?i(s,r,o,a,c):(l=Ps(l,a/2,c/2),u=Ps(u,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,u),e(s,r,o+c,r,o,u),e(s,r,o,r+a,o,l),s.closePath())}}var nf=(n,t,e)=>{n.moveTo(t,e)},sf=(n,t,e)=>{n.moveTo(e,t)},tl=(n,t,e)=>{n.lineTo(t,e)},el=(n,t,e)=>{n.lineTo(e,t)},rf=Pb(0),Dg=Pb(1),Ib=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Lb=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Db=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Nb=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Ub(n){return(t,e,i,s,r)=>Fo(t,e,(o,a,c,l,u,h,d,f,g,y,p)=>{let{pxRound:m,points:x}=o,w,v;l.ori==0?(w=nf,v=Ib):(w=sf,v=Lb);let A=Ke(x.width*Oe,3),T=(x.size-x.width)/2*Oe,_=Ke(T*2,3),b=new Path2D,L=new Path2D,{left:I,top:D,width:B,height:V}=t.bbox;rf(L,I-_,D-_,B+_*2,V+_*2);let O=$=>{if(c[$]!=null){let Z=m(h(a[$],l,y,f)),q=m(d(c[$],u,p,g));w(b,Z+T,q),v(b,Z,q,T,0,Xd*2)}};if(r)r.forEach(O);else for(let $=i;$<=s;$++)O($);return{stroke:A>0?b:null,fill:b,clip:L,flags:Ka|_g}})}function Fb(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var aI=Fb(tl),lI=Fb(el);function Ob(n){let t=De(n?.alignGaps,0);return(e,i,s,r)=>Fo(e,i,(o,a,c,l,u,h,d,f,g,y,p)=>{[s,r]=Jd(c,s,r);let m=o.pxRound,x=V=>m(h(V,l,y,f)),w=V=>m(d(V,u,p,g)),v,A;l.ori==0?(v=tl,A=aI):(v=el,A=lI);let T=l.dir*(l.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ka},b=_.stroke,L=!1;if(r-s>=y*4){let V=ft=>e.posToVal(ft,l.key,!0),O=null,$=null,Z,q,ht,K=x(a[T==1?s:r]),tt=x(a[s]),rt=x(a[r]),pt=V(T==1?tt+1:rt-1);for(let ft=T==1?s:r;ft>=s&&ft<=r;ft+=T){let et=a[ft],St=(T==1?et<pt:et>pt)?K:x(et),Lt=c[ft];St==K?Lt!=null?(q=Lt,O==null?(v(b,St,w(q)),Z=O=$=q):q<O?O=q:q>$&&($=q)):Lt===null&&(L=!0):(O!=null&&A(b,K,w(O),w($),w(Z),w(q)),Lt!=null?(q=Lt,v(b,St,w(q)),O=$=Z=q):(O=$=null,Lt===null&&(L=!0)),K=St,pt=V(K+T))}O!=null&&O!=$&&ht!=K&&A(b,K,w(O),w($),w(Z),w(q))}else for(let V=T==1?s:r;V>=s&&V<=r;V+=T){let O=c[V];O===null?L=!0:O!=null&&v(b,x(a[V]),w(O))}let[D,B]=Ig(e,i);if(o.fill!=null||D!=0){let V=_.fill=new Path2D(b),O=o.fillTo(e,i,o.min,o.max,D),$=w(O),Z=x(a[s]),q=x(a[r]);T==-1&&([q,Z]=[Z,q]),v(V,q,$),v(V,Z,$)}if(!o.spanGaps){let V=[];L&&V.push(...Lg(a,c,s,r,T,x,t)),_.gaps=V=o.gaps(e,i,s,r,V),_.clip=ef(V,l.ori,f,g,y,p)}return B!=0&&(_.band=B==2?[Mr(e,i,s,r,b,-1),Mr(e,i,s,r,b,1)]:Mr(e,i,s,r,b,B)),_})}function cI(n){let t=De(n.align,1),e=De(n.ascDesc,!1),i=De(n.alignGaps,0),s=De(n.extend,!1);return(r,o,a,c)=>Fo(r,o,(l,u,h,d,f,g,y,p,m,x,w)=>{[a,c]=Jd(h,a,c);let v=l.pxRound,{left:A,width:T}=r.bbox,_=tt=>v(g(tt,d,x,p)),b=tt=>v(y(tt,f,w,m)),L=d.ori==0?tl:el,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ka},D=I.stroke,B=d.dir*(d.ori==0?1:-1),V=b(h[B==1?a:c]),O=_(u[B==1?a:c]),$=O,Z=O;s&&t==-1&&(Z=A,L(D,Z,V)),L(D,O,V);for(let tt=B==1?a:c;tt>=a&&tt<=c;tt+=B){let rt=h[tt];if(rt==null)continue;let pt=_(u[tt]),ft=b(rt);t==1?L(D,pt,V):L(D,$,ft),L(D,pt,ft),V=ft,$=pt}let q=$;s&&t==1&&(q=A+T,L(D,q,V));let[ht,K]=Ig(r,o);if(l.fill!=null||ht!=0){let tt=I.fill=new Path2D(D),rt=l.fillTo(r,o,l.min,l.max,ht),pt=b(rt);L(tt,q,pt),L(tt,Z,pt)}if(!l.spanGaps){let tt=[];tt.push(...Lg(u,h,a,c,B,_,i));let rt=l.width*Oe/2,pt=e||t==1?rt:-rt,ft=e||t==-1?-rt:rt;tt.forEach(et=>{et[0]+=pt,et[1]+=ft}),I.gaps=tt=l.gaps(r,o,a,c,tt),I.clip=ef(tt,d.ori,p,m,x,w)}return K!=0&&(I.band=K==2?[Mr(r,o,a,c,D,-1),Mr(r,o,a,c,D,1)]:Mr(r,o,a,c,D,K)),I})}function Jv(n,t,e,i,s,r,o=Je){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(t[c]!==void 0){if(a!=null){let u=Vn(n[c]-n[a]);u<l&&(l=u,o=Vn(e(n[c],i,s,r)-e(n[a],i,s,r)))}a=c}}return o}function uI(n){n=n||kc;let t=De(n.size,[.6,Je,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Re(s),o=1-t[0],a=De(t[1],Je),c=De(t[2],1),l=De(n.disp,kc),u=De(n.each,f=>{}),{fill:h,stroke:d}=l;return(f,g,y,p)=>Fo(f,g,(m,x,w,v,A,T,_,b,L,I,D)=>{let B=m.pxRound,V=e,O=i*Oe,$=a*Oe,Z=c*Oe,q,ht;v.ori==0?[q,ht]=r(f,g):[ht,q]=r(f,g);let K=v.dir*(v.ori==0?1:-1),tt=v.ori==0?rf:Dg,rt=v.ori==0?u:(Nt,te,fe,Rt,Ye,$t,Kt)=>{u(Nt,te,fe,Ye,Rt,Kt,$t)},pt=De(f.bands,Tg).find(Nt=>Nt.series[0]==g),ft=pt!=null?pt.dir:0,et=m.fillTo(f,g,m.min,m.max,ft),yt=B(_(et,A,D,L)),St,Lt,At,jt=I,de=B(m.width*Oe),Xt=!1,ye=null,ge=null,ue=null,ln=null;h!=null&&(de==0||d!=null)&&(Xt=!0,ye=h.values(f,g,y,p),ge=new Map,new Set(ye).forEach(Nt=>{Nt!=null&&ge.set(Nt,new Path2D)}),de>0&&(ue=d.values(f,g,y,p),ln=new Map,new Set(ue).forEach(Nt=>{Nt!=null&&ln.set(Nt,new Path2D)})));let{x0:Qe,size:Tn}=l;if(Qe!=null&&Tn!=null){V=1,x=Qe.values(f,g,y,p),Qe.unit==2&&(x=x.map(fe=>f.posToVal(b+fe*I,v.key,!0)));let Nt=Tn.values(f,g,y,p);Tn.unit==2?Lt=Nt[0]*I:Lt=T(Nt[0],v,I,b)-T(0,v,I,b),jt=Jv(x,w,T,v,I,b,jt),At=jt-Lt+O}else jt=Jv(x,w,T,v,I,b,jt),At=jt*o+O,Lt=jt-At;At<1&&(At=0),de>=Lt/2&&(de=0),At<5&&(B=ob);let qe=At>0,qn=jt-At-(qe?de:0);Lt=B(pg(qn,Z,$)),St=(V==0?Lt/2:V==K?0:Lt)-V*K*((V==0?O/2:0)+(qe?de/2:0));let Ce={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Un=Xt?null:new Path2D,fn=null;if(pt!=null)fn=f.data[pt.series[1]];else{let{y0:Nt,y1:te}=l;Nt!=null&&te!=null&&(w=te.values(f,g,y,p),fn=Nt.values(f,g,y,p))}let An=q*Lt,H=ht*Lt;for(let Nt=K==1?y:p;Nt>=y&&Nt<=p;Nt+=K){let te=w[Nt];if(te==null)continue;if(fn!=null){let X=fn[Nt]??0;if(te-X==0)continue;yt=_(X,A,D,L)}let fe=v.distr!=2||l!=null?x[Nt]:Nt,Rt=T(fe,v,I,b),Ye=_(De(te,et),A,D,L),$t=B(Rt-St),Kt=B(Ei(Ye,yt)),N=B(Ps(Ye,yt)),R=Kt-N;if(te!=null){let X=te<0?H:An,dt=te<0?An:H;Xt?(de>0&&ue[Nt]!=null&&tt(ln.get(ue[Nt]),$t,N+Zi(de/2),Lt,Ei(0,R-de),X,dt),ye[Nt]!=null&&tt(ge.get(ye[Nt]),$t,N+Zi(de/2),Lt,Ei(0,R-de),X,dt)):tt(Un,$t,N+Zi(de/2),Lt,Ei(0,R-de),X,dt),rt(f,g,Nt,$t-de/2,N,Lt+de,R)}}return de>0?Ce.stroke=Xt?ln:Un:Xt||(Ce._fill=m.width==0?m._fill:m._stroke??m._fill,Ce.width=0),Ce.fill=Xt?ge:Un,Ce})}function hI(n,t){let e=De(t?.alignGaps,0);return(i,s,r,o)=>Fo(i,s,(a,c,l,u,h,d,f,g,y,p,m)=>{[r,o]=Jd(l,r,o);let x=a.pxRound,w=q=>x(d(q,u,p,g)),v=q=>x(f(q,h,m,y)),A,T,_;u.ori==0?(A=nf,_=tl,T=Db):(A=sf,_=el,T=Nb);let b=u.dir*(u.ori==0?1:-1),L=w(c[b==1?r:o]),I=L,D=[],B=[];for(let q=b==1?r:o;q>=r&&q<=o;q+=b)if(l[q]!=null){let K=c[q],tt=w(K);D.push(I=tt),B.push(v(l[q]))}let V={stroke:n(D,B,A,_,T,x),fill:null,clip:null,band:null,gaps:null,flags:Ka},O=V.stroke,[$,Z]=Ig(i,s);if(a.fill!=null||$!=0){let q=V.fill=new Path2D(O),ht=a.fillTo(i,s,a.min,a.max,$),K=v(ht);_(q,I,K),_(q,L,K)}if(!a.spanGaps){let q=[];q.push(...Lg(c,l,r,o,b,w,e)),V.gaps=q=a.gaps(i,s,r,o,q),V.clip=ef(q,u.ori,g,y,p,m)}return Z!=0&&(V.band=Z==2?[Mr(i,s,r,o,O,-1),Mr(i,s,r,o,O,1)]:Mr(i,s,r,o,O,Z)),V})}function dI(n){return hI(fI,n)}function fI(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],l[d]=u[d]/h[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/l[d-1]+(h[d]+2*h[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+c[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-c[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var xg=new Set;function Kv(){for(let n of xg)n.syncRect(!0)}Qa&&(No(XC,Ya,Kv),No(YC,Ya,Kv,!0),No(Yd,Ya,()=>{ni.pxRatio=Oe}));var pI=Ob(),mI=Ub();function Qv(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>yg(r,o,t,e))}function gI(n,t){return n.map((e,i)=>i==0?{}:Dn({},t,e))}function yg(n,t,e,i){return Dn({},t==0?e:i,n)}function Bb(n,t,e){return t==null?ja:[t,e]}var _I=Bb;function xI(n,t,e){return t==null?ja:Zd(t,e,wg,!0)}function kb(n,t,e,i){return t==null?ja:Kd(t,e,n.scales[i].log,!1)}var yI=kb;function zb(n,t,e,i){return t==null?ja:Mg(t,e,n.scales[i].log,!1)}var vI=zb;function bI(n,t,e,i,s){let r=Ei(Iv(n),Iv(t)),o=t-n,a=Cs(s/i*o,e);do{let c=e[a],l=i*c/o;if(l>=s&&r+(c<5?no.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function tb(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Gn((e=+s)*Oe))+"px"),[n,t,e]}function SI(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ke(t[2]*Oe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ni(n,t,e){let i={mode:De(n.mode,1)},s=i.mode;function r(M,C,U,F){let W=C.valToPct(M);return F+U*(C.dir==-1?1-W:W)}function o(M,C,U,F){let W=C.valToPct(M);return F+U*(C.dir==-1?W:1-W)}function a(M,C,U,F){return C.ori==0?r(M,C,U,F):o(M,C,U,F)}i.valToPosH=r,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=cs(CC);if(n.id!=null&&(l.id=n.id),Yi(l,n.class),n.title){let M=cs(LC,l);M.textContent=n.title}let u=Rs("canvas"),h=i.ctx=u.getContext("2d"),d=cs(DC,l);No("click",d,M=>{M.target===g&&(en!=qo||cn!=$o)&&ti.click(i,M)},!0);let f=i.under=cs(NC,d);d.appendChild(u);let g=i.over=cs(UC,d);n=Ja(n);let y=+De(n.pxAlign,1),p=jv(y);(n.plugins||[]).forEach(M=>{M.opts&&(n=M.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?Qv(n.series||[],Vv,Yv,!1):gI(n.series||[null],Xv),w=i.axes=Qv(n.axes||[],Gv,qv,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(M=>{M.fill=Re(M.fill||null),M.dir=De(M.dir,-1)});let T=s==2?x[1].facets[0].scale:x[0].scale,_={axes:Qs,series:Me},b=(n.drawOrder||["axes","series"]).map(M=>_[M]);function L(M){let C=M.distr==3?U=>Sr(U>0?U:M.clamp(i,U,M.min,M.max,M.key)):M.distr==4?U=>og(U,M.asinh):M.distr==100?U=>M.fwd(U):U=>U;return U=>{let F=C(U),{_min:W,_max:J}=M,lt=J-W;return(F-W)/lt}}function I(M){let C=v[M];if(C==null){let U=(n.scales||kc)[M]||kc;if(U.from!=null){I(U.from);let F=Dn({},v[U.from],U,{key:M});F.valToPct=L(F),v[M]=F}else{C=v[M]=Dn({},M==T?Rb:sI,U),C.key=M;let F=C.time,W=C.range,J=eo(W);if((M!=T||s==2&&!F)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Rv:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Rv:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&tf(W))){let lt=W;W=(gt,wt,Bt)=>wt==null?ja:Zd(wt,Bt,lt)}C.range=Re(W||(F?_I:M==T?C.distr==3?yI:C.distr==4?vI:Bb:C.distr==3?kb:C.distr==4?zb:xI)),C.auto=Re(J?!1:C.auto),C.clamp=Re(C.clamp||iI),C._min=C._max=null,C.valToPct=L(C)}}}I("x"),I("y"),s==1&&x.forEach(M=>{I(M.scale)}),w.forEach(M=>{I(M.scale)});for(let M in n.scales)I(M);let D=v[T],B=D.distr,V,O;D.ori==0?(Yi(l,PC),V=r,O=o):(Yi(l,IC),V=o,O=r);let $={};for(let M in v){let C=v[M];(C.min!=null||C.max!=null)&&($[M]={min:C.min,max:C.max},C.min=C.max=null)}let Z=n.tzDate||(M=>new Date(Gn(M/m))),q=n.fmtDate||Ag,ht=m==1?PP(Z):DP(Z),K=kv(Z,Bv(m==1?CP:LP,q)),tt=Hv(Z,zv(UP,q)),rt=[],pt=i.legend=Dn({},BP,n.legend),ft=i.cursor=Dn({},WP,{drag:{y:s==2}},n.cursor),et=pt.show,yt=ft.show,St=pt.markers;pt.idxs=rt,St.width=Re(St.width),St.dash=Re(St.dash),St.stroke=Re(St.stroke),St.fill=Re(St.fill);let Lt,At,jt,de=[],Xt=[],ye,ge=!1,ue={};if(pt.live){let M=x[1]?x[1].values:null;ge=M!=null,ye=ge?M(i,1,0):{_:0};for(let C in ye)ue[C]=bg}if(et)if(Lt=Rs("table",HC,l),jt=Rs("tbody",null,Lt),pt.mount(i,Lt),ge){At=Rs("thead",null,Lt,jt);let M=Rs("tr",null,At);Rs("th",null,M);for(var ln in ye)Rs("th",mv,M).textContent=ln}else Yi(Lt,VC),pt.live&&Yi(Lt,GC);let Qe={show:!0},Tn={show:!1};function qe(M,C){if(C==0&&(ge||!pt.live||s==2))return ja;let U=[],F=Rs("tr",WC,jt,jt.childNodes[C]);Yi(F,M.class),M.show||Yi(F,Do);let W=Rs("th",null,F);if(St.show){let gt=cs(qC,W);if(C>0){let wt=St.width(i,C);wt&&(gt.style.border=wt+"px "+St.dash(i,C)+" "+St.stroke(i,C)),gt.style.background=St.fill(i,C)}}let J=cs(mv,W);M.label instanceof HTMLElement?J.appendChild(M.label):J.textContent=M.label,C>0&&(St.show||(J.style.color=M.width>0?St.stroke(i,C):St.fill(i,C)),Ce("click",W,gt=>{if(ft._lock)return;se(gt);let wt=x.indexOf(M);if((gt.ctrlKey||gt.metaKey)!=pt.isolate){let Bt=x.some((kt,Ht)=>Ht>0&&Ht!=wt&&kt.show);x.forEach((kt,Ht)=>{Ht>0&&Us(Ht,Bt?Ht==wt?Qe:Tn:Qe,!0,In.setSeries)})}else Us(wt,{show:!M.show},!0,In.setSeries)},!1),re&&Ce(yv,W,gt=>{ft._lock||(se(gt),Us(x.indexOf(M),Yo,!0,In.setSeries))},!1));for(var lt in ye){let gt=Rs("td",$C,F);gt.textContent="--",U.push(gt)}return[F,U]}let qn=new Map;function Ce(M,C,U,F=!0){let W=qn.get(C)||{},J=ft.bind[M](i,C,U,F);J&&(No(M,C,W[M]=J),qn.set(C,W))}function Un(M,C,U){let F=qn.get(C)||{};for(let W in F)(M==null||W==M)&&(fg(W,C,F[W]),delete F[W]);M==null&&qn.delete(C)}let fn=0,An=0,H=0,Nt=0,te=0,fe=0,Rt=te,Ye=fe,$t=H,Kt=Nt,N=0,R=0,X=0,dt=0;i.bbox={};let at=!1,bt=!1,Mt=!1,nt=!1,st=!1,_t=!1;function z(M,C,U){(U||M!=i.width||C!=i.height)&&ot(M,C),_e(!1),Mt=!0,bt=!0,ii()}function ot(M,C){i.width=fn=H=M,i.height=An=Nt=C,te=fe=0,Tt(),Yt();let U=i.bbox;N=U.left=Io(te*Oe,.5),R=U.top=Io(fe*Oe,.5),X=U.width=Io(H*Oe,.5),dt=U.height=Io(Nt*Oe,.5)}let it=3;function Ct(){let M=!1,C=0;for(;!M;){C++;let U=Go(C),F=Ns(C);M=C==it||U&&F,M||(ot(i.width,i.height),bt=!0)}}function vt({width:M,height:C}){z(M,C)}i.setSize=vt;function Tt(){let M=!1,C=!1,U=!1,F=!1;w.forEach((W,J)=>{if(W.show&&W._show){let{side:lt,_size:gt}=W,wt=lt%2,Bt=W.label!=null?W.labelSize:0,kt=gt+Bt;kt>0&&(wt?(H-=kt,lt==3?(te+=kt,F=!0):U=!0):(Nt-=kt,lt==0?(fe+=kt,M=!0):C=!0))}}),Ls[0]=M,Ls[1]=U,Ls[2]=C,Ls[3]=F,H-=ds[1]+ds[3],te+=ds[3],Nt-=ds[2]+ds[0],fe+=ds[0]}function Yt(){let M=te+H,C=fe+Nt,U=te,F=fe;function W(J,lt){switch(J){case 1:return M+=lt,M-lt;case 2:return C+=lt,C-lt;case 3:return U-=lt,U+lt;case 0:return F-=lt,F+lt}}w.forEach((J,lt)=>{if(J.show&&J._show){let gt=J.side;J._pos=W(gt,J._size),J.label!=null&&(J._lpos=W(gt,J.labelSize))}})}if(ft.dataIdx==null){let M=ft.hover,C=M.skip=new Set(M.skip??[]);C.add(void 0);let U=M.prox=Re(M.prox),F=M.bias??=0;ft.dataIdx=(W,J,lt,gt)=>{if(J==0)return lt;let wt=lt,Bt=U(W,J,lt,gt)??Je,kt=Bt>=0&&Bt<Je,Ht=D.ori==0?H:Nt,he=ft.left,Ne=t[0],Le=t[J];if(C.has(Le[lt])){wt=null;let we=null,ne=null,Jt;if(F==0||F==-1)for(Jt=lt;we==null&&Jt-- >0;)C.has(Le[Jt])||(we=Jt);if(F==0||F==1)for(Jt=lt;ne==null&&Jt++<Le.length;)C.has(Le[Jt])||(ne=Jt);if(we!=null||ne!=null)if(kt){let sn=we==null?-1/0:V(Ne[we],D,Ht,0),gn=ne==null?1/0:V(Ne[ne],D,Ht,0),Zn=he-sn,$e=gn-he;Zn<=$e?Zn<=Bt&&(wt=we):$e<=Bt&&(wt=ne)}else wt=ne==null?we:we==null?ne:lt-we<=ne-lt?we:ne}else kt&&Vn(he-V(Ne[lt],D,Ht,0))>Bt&&(wt=null);return wt}}let se=M=>{ft.event=M};ft.idxs=rt,ft._lock=!1;let ut=ft.points;ut.show=Re(ut.show),ut.size=Re(ut.size),ut.stroke=Re(ut.stroke),ut.width=Re(ut.width),ut.fill=Re(ut.fill);let Gt=i.focus=Dn({},n.focus||{alpha:.3},ft.focus),re=Gt.prox>=0,Dt=re&&ut.one,me=[],tn=[],ci=[];function ll(M,C){let U=ut.show(i,C);if(U instanceof HTMLElement)return Yi(U,zC),Yi(U,M.class),Zs(U,-10,-10,H,Nt),g.insertBefore(U,me[C]),U}function ko(M,C){if(s==1||C>0){let U=s==1&&v[M.scale].time,F=M.value;M.value=U?Nv(F)?Hv(Z,zv(F,q)):F||tt:F||tI,M.label=M.label||(U?$P:qP)}if(Dt||C>0){M.width=M.width==null?1:M.width,M.paths=M.paths||pI||sP,M.fillTo=Re(M.fillTo||rI),M.pxAlign=+De(M.pxAlign,y),M.pxRound=jv(M.pxAlign),M.stroke=Re(M.stroke||null),M.fill=Re(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let U=eI(Ei(1,M.width),1),F=M.points=Dn({},{size:U,width:Ei(1,U*.2),stroke:M.stroke,space:U*2,paths:mI,_stroke:null,_fill:null},M.points);F.show=Re(F.show),F.filter=Re(F.filter),F.fill=Re(F.fill),F.stroke=Re(F.stroke),F.paths=Re(F.paths),F.pxAlign=M.pxAlign}if(et){let U=qe(M,C);de.splice(C,0,U[0]),Xt.splice(C,0,U[1]),pt.values.push(null)}if(yt){rt.splice(C,0,null);let U=null;Dt?C==0&&(U=ll(M,C)):C>0&&(U=ll(M,C)),me.splice(C,0,U),tn.splice(C,0,0),ci.splice(C,0,0)}Yn("addSeries",C)}function Cf(M,C){C=C??x.length,M=s==1?yg(M,C,Vv,Yv):yg(M,C,{},Xv),x.splice(C,0,M),ko(x[C],C)}i.addSeries=Cf;function Xc(M){if(x.splice(M,1),et){pt.values.splice(M,1),Xt.splice(M,1);let C=de.splice(M,1)[0];Un(null,C.firstChild),C.remove()}yt&&(rt.splice(M,1),me.splice(M,1)[0].remove(),tn.splice(M,1),ci.splice(M,1)),Yn("delSeries",M)}i.delSeries=Xc;let Ls=[!1,!1,!1,!1];function js(M,C){if(M._show=M.show,M.show){let U=M.side%2,F=v[M.scale];F==null&&(M.scale=U?x[1].scale:T,F=v[M.scale]);let W=F.time;M.size=Re(M.size),M.space=Re(M.space),M.rotate=Re(M.rotate),eo(M.incrs)&&M.incrs.forEach(lt=>{!no.has(lt)&&no.set(lt,cb(lt))}),M.incrs=Re(M.incrs||(F.distr==2?TP:W?m==1?RP:IP:Lo)),M.splits=Re(M.splits||(W&&F.distr==1?ht:F.distr==3?mg:F.distr==4?ZP:YP)),M.stroke=Re(M.stroke),M.grid.stroke=Re(M.grid.stroke),M.ticks.stroke=Re(M.ticks.stroke),M.border.stroke=Re(M.border.stroke);let J=M.values;M.values=eo(J)&&!eo(J[0])?Re(J):W?eo(J)?kv(Z,Bv(J,q)):Nv(J)?NP(Z,J):J||K:J||XP,M.filter=Re(M.filter||(F.distr>=3&&F.log==10?KP:F.distr==3&&F.log==2?QP:ab)),M.font=tb(M.font),M.labelFont=tb(M.labelFont),M._size=M.size(i,null,C,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(Ls[C]=!0,M._el=cs(FC,d))}}function Js(M,C,U,F){let[W,J,lt,gt]=U,wt=C%2,Bt=0;return wt==0&&(gt||J)&&(Bt=C==0&&!W||C==2&&!lt?Gn(Gv.size/3):0),wt==1&&(W||lt)&&(Bt=C==1&&!J||C==3&&!gt?Gn(qv.size/2):0),Bt}let cl=i.padding=(n.padding||[Js,Js,Js,Js]).map(M=>Re(De(M,Js))),ds=i._padding=cl.map((M,C)=>M(i,C,Ls,0)),pn,Mn=null,wn=null,Ds=s==1?x[0].idxs:null,Fi=null,wr=!1;function ul(M,C){if(t=M??[],i.data=i._data=t,s==2){pn=0;for(let U=1;U<x.length;U++)pn+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Fi=t[0],pn=Fi.length;let U=t;if(B==2){U=t.slice();let F=U[0]=Array(pn);for(let W=0;W<pn;W++)F[W]=W}i._data=t=U}if(_e(!0),Yn("setData"),B==2&&(Mt=!0),C!==!1){let U=D;U.auto(i,wr)?hl():Ar(T,U.min,U.max),nt=nt||ft.left>=0,_t=!0,ii()}}i.setData=ul;function hl(){wr=!0;let M,C;s==1&&(pn>0?(Mn=Ds[0]=0,wn=Ds[1]=pn-1,M=t[0][Mn],C=t[0][wn],B==2?(M=Mn,C=wn):M==C&&(B==3?[M,C]=Kd(M,M,D.log,!1):B==4?[M,C]=Mg(M,M,D.log,!1):D.time?C=M+Gn(86400/m):[M,C]=Zd(M,C,wg,!0))):(Mn=Ds[0]=M=null,wn=Ds[1]=C=null)),Ar(T,M,C)}let zo,Er,Ho,P,G,Q,Y,j,Pt,Ut;function It(M,C,U,F,W,J){M??=_v,U??=Tg,F??="butt",W??=_v,J??="round",M!=zo&&(h.strokeStyle=zo=M),W!=Er&&(h.fillStyle=Er=W),C!=Ho&&(h.lineWidth=Ho=C),J!=G&&(h.lineJoin=G=J),F!=Q&&(h.lineCap=Q=F),U!=P&&h.setLineDash(P=U)}function Ft(M,C,U,F){C!=Er&&(h.fillStyle=Er=C),M!=Y&&(h.font=Y=M),U!=j&&(h.textAlign=j=U),F!=Pt&&(h.textBaseline=Pt=F)}function Wt(M,C,U,F,W=0){if(F.length>0&&M.auto(i,wr)&&(C==null||C.min==null)){let J=De(Mn,0),lt=De(wn,F.length-1),gt=U.min==null?KC(F,J,lt,W,M.distr==3):[U.min,U.max];M.min=Ps(M.min,U.min=gt[0]),M.max=Ei(M.max,U.max=gt[1])}}let le={min:null,max:null};function Se(){for(let F in v){let W=v[F];$[F]==null&&(W.min==null||$[T]!=null&&W.auto(i,wr))&&($[F]=le)}for(let F in v){let W=v[F];$[F]==null&&W.from!=null&&$[W.from]!=null&&($[F]=le)}$[T]!=null&&_e(!0);let M={};for(let F in $){let W=$[F];if(W!=null){let J=M[F]=Ja(v[F],aP);if(W.min!=null)Dn(J,W);else if(F!=T||s==2)if(pn==0&&J.from==null){let lt=J.range(i,null,null,F);J.min=lt[0],J.max=lt[1]}else J.min=Je,J.max=-Je}}if(pn>0){x.forEach((F,W)=>{if(s==1){let J=F.scale,lt=$[J];if(lt==null)return;let gt=M[J];if(W==0){let wt=gt.range(i,gt.min,gt.max,J);gt.min=wt[0],gt.max=wt[1],Mn=Cs(gt.min,t[0]),wn=Cs(gt.max,t[0]),wn-Mn>1&&(t[0][Mn]<gt.min&&Mn++,t[0][wn]>gt.max&&wn--),F.min=Fi[Mn],F.max=Fi[wn]}else F.show&&F.auto&&Wt(gt,lt,F,t[W],F.sorted);F.idxs[0]=Mn,F.idxs[1]=wn}else if(W>0&&F.show&&F.auto){let[J,lt]=F.facets,gt=J.scale,wt=lt.scale,[Bt,kt]=t[W],Ht=M[gt],he=M[wt];Ht!=null&&Wt(Ht,$[gt],J,Bt,J.sorted),he!=null&&Wt(he,$[wt],lt,kt,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in M){let W=M[F],J=$[F];if(W.from==null&&(J==null||J.min==null)){let lt=W.range(i,W.min==Je?null:W.min,W.max==-Je?null:W.max,F);W.min=lt[0],W.max=lt[1]}}}for(let F in M){let W=M[F];if(W.from!=null){let J=M[W.from];if(J.min==null)W.min=W.max=null;else{let lt=W.range(i,J.min,J.max,F);W.min=lt[0],W.max=lt[1]}}}let C={},U=!1;for(let F in M){let W=M[F],J=v[F];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let lt=J.distr;J._min=lt==3?Sr(J.min):lt==4?og(J.min,J.asinh):lt==100?J.fwd(J.min):J.min,J._max=lt==3?Sr(J.max):lt==4?og(J.max,J.asinh):lt==100?J.fwd(J.max):J.max,C[F]=U=!0}}if(U){x.forEach((F,W)=>{s==2?W>0&&C.y&&(F._paths=null):C[F.scale]&&(F._paths=null)});for(let F in C)Mt=!0,Yn("setScale",F);yt&&ft.left>=0&&(nt=_t=!0)}for(let F in $)$[F]=null}function Vt(M){let C=pg(Mn-1,0,pn-1),U=pg(wn+1,0,pn-1);for(;M[C]==null&&C>0;)C--;for(;M[U]==null&&U<pn-1;)U++;return[C,U]}function Me(){if(pn>0){let M=x.some(C=>C._focus)&&Ut!=Gt.alpha;M&&(h.globalAlpha=Ut=Gt.alpha),x.forEach((C,U)=>{if(U>0&&C.show&&(hn(U,!1),hn(U,!0),C._paths==null)){let F=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha);let W=s==2?[0,t[U][0].length-1]:Vt(t[U]);C._paths=C.paths(i,U,W[0],W[1]),Ut!=F&&(h.globalAlpha=Ut=F)}}),x.forEach((C,U)=>{if(U>0&&C.show){let F=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha),C._paths!=null&&He(U,!1);{let W=C._paths!=null?C._paths.gaps:null,J=C.points.show(i,U,Mn,wn,W),lt=C.points.filter(i,U,J,W);(J||lt)&&(C.points._paths=C.points.paths(i,U,Mn,wn,lt),He(U,!0))}Ut!=F&&(h.globalAlpha=Ut=F),Yn("drawSeries",U)}}),M&&(h.globalAlpha=Ut=1)}}function hn(M,C){let U=C?x[M].points:x[M];U._stroke=U.stroke(i,M),U._fill=U.fill(i,M)}function He(M,C){let U=C?x[M].points:x[M],{stroke:F,fill:W,clip:J,flags:lt,_stroke:gt=U._stroke,_fill:wt=U._fill,_width:Bt=U.width}=U._paths;Bt=Ke(Bt*Oe,3);let kt=null,Ht=Bt%2/2;C&&wt==null&&(wt=Bt>0?"#fff":gt);let he=U.pxAlign==1&&Ht>0;if(he&&h.translate(Ht,Ht),!C){let Ne=N-Bt/2,Le=R-Bt/2,we=X+Bt,ne=dt+Bt;kt=new Path2D,kt.rect(Ne,Le,we,ne)}C?zt(gt,Bt,U.dash,U.cap,wt,F,W,lt,J):Ge(M,gt,Bt,U.dash,U.cap,wt,F,W,lt,kt,J),he&&h.translate(-Ht,-Ht)}function Ge(M,C,U,F,W,J,lt,gt,wt,Bt,kt){let Ht=!1;wt!=0&&A.forEach((he,Ne)=>{if(he.series[0]==M){let Le=x[he.series[1]],we=t[he.series[1]],ne=(Le._paths||kc).band;eo(ne)&&(ne=he.dir==1?ne[0]:ne[1]);let Jt,sn=null;Le.show&&ne&&tP(we,Mn,wn)?(sn=he.fill(i,Ne)||J,Jt=Le._paths.clip):ne=null,zt(C,U,F,W,sn,lt,gt,wt,Bt,kt,Jt,ne),Ht=!0}}),Ht||zt(C,U,F,W,J,lt,gt,wt,Bt,kt)}let Fn=Ka|_g;function zt(M,C,U,F,W,J,lt,gt,wt,Bt,kt,Ht){It(M,C,U,F,W),(wt||Bt||Ht)&&(h.save(),wt&&h.clip(wt),Bt&&h.clip(Bt)),Ht?(gt&Fn)==Fn?(h.clip(Ht),kt&&h.clip(kt),Ee(W,lt),Rn(M,J,C)):gt&_g?(Ee(W,lt),h.clip(Ht),Rn(M,J,C)):gt&Ka&&(h.save(),h.clip(Ht),kt&&h.clip(kt),Ee(W,lt),h.restore(),Rn(M,J,C)):(Ee(W,lt),Rn(M,J,C)),(wt||Bt||Ht)&&h.restore()}function Rn(M,C,U){U>0&&(C instanceof Map?C.forEach((F,W)=>{h.strokeStyle=zo=W,h.stroke(F)}):C!=null&&M&&h.stroke(C))}function Ee(M,C){C instanceof Map?C.forEach((U,F)=>{h.fillStyle=Er=F,h.fill(U)}):C!=null&&M&&h.fill(C)}function Ks(M,C,U,F){let W=w[M],J;if(F<=0)J=[0,0];else{let lt=W._space=W.space(i,M,C,U,F),gt=W._incrs=W.incrs(i,M,C,U,F,lt);J=bI(C,U,gt,F,lt)}return W._found=J}function Cn(M,C,U,F,W,J,lt,gt,wt,Bt){let kt=lt%2/2;y==1&&h.translate(kt,kt),It(gt,lt,wt,Bt,gt),h.beginPath();let Ht,he,Ne,Le,we=W+(F==0||F==3?-J:J);U==0?(he=W,Le=we):(Ht=W,Ne=we);for(let ne=0;ne<M.length;ne++)C[ne]!=null&&(U==0?Ht=Ne=M[ne]:he=Le=M[ne],h.moveTo(Ht,he),h.lineTo(Ne,Le));h.stroke(),y==1&&h.translate(-kt,-kt)}function Go(M){let C=!0;return w.forEach((U,F)=>{if(!U.show)return;let W=v[U.scale];if(W.min==null){U._show&&(C=!1,U._show=!1,_e(!1));return}else U._show||(C=!1,U._show=!0,_e(!1));let J=U.side,lt=J%2,{min:gt,max:wt}=W,[Bt,kt]=Ks(F,gt,wt,lt==0?H:Nt);if(kt==0)return;let Ht=W.distr==2,he=U._splits=U.splits(i,F,gt,wt,Bt,kt,Ht),Ne=W.distr==2?he.map(Jt=>Fi[Jt]):he,Le=W.distr==2?Fi[he[1]]-Fi[he[0]]:Bt,we=U._values=U.values(i,U.filter(i,Ne,F,kt,Le),F,kt,Le);U._rotate=J==2?U.rotate(i,we,F,kt):0;let ne=U._size;U._size=us(U.size(i,we,F,M)),ne!=null&&U._size!=ne&&(C=!1)}),C}function Ns(M){let C=!0;return cl.forEach((U,F)=>{let W=U(i,F,Ls,M);W!=ds[F]&&(C=!1),ds[F]=W}),C}function Qs(){for(let M=0;M<w.length;M++){let C=w[M];if(!C.show||!C._show)continue;let U=C.side,F=U%2,W,J,lt=C.stroke(i,M),gt=U==0||U==3?-1:1,[wt,Bt]=C._found;if(C.label!=null){let di=C.labelGap*gt,ki=Gn((C._lpos+di)*Oe);Ft(C.labelFont[0],lt,"center",U==2?"top":gv),h.save(),F==1?(W=J=0,h.translate(ki,Gn(R+dt/2)),h.rotate((U==3?-Xd:Xd)/2)):(W=Gn(N+X/2),J=ki);let lo=rb(C.label)?C.label(i,M,wt,Bt):C.label;h.fillText(lo,W,J),h.restore()}if(Bt==0)continue;let kt=v[C.scale],Ht=F==0?X:dt,he=F==0?N:R,Ne=C._splits,Le=kt.distr==2?Ne.map(di=>Fi[di]):Ne,we=kt.distr==2?Fi[Ne[1]]-Fi[Ne[0]]:wt,ne=C.ticks,Jt=C.border,sn=ne.show?ne.size:0,gn=Gn(sn*Oe),Zn=Gn((C.alignTo==2?C._size-sn-C.gap:C.gap)*Oe),$e=C._rotate*-Xd/180,_n=p(C._pos*Oe),Oi=(gn+Zn)*gt,hi=_n+Oi;J=F==0?hi:0,W=F==1?hi:0;let Ki=C.font[0],fs=C.align==1?$a:C.align==2?ig:$e>0?$a:$e<0?ig:F==0?"center":U==3?ig:$a,Os=$e||F==1?"middle":U==2?"top":gv;Ft(Ki,lt,fs,Os);let Bi=C.font[1]*C.lineGap,Qi=Ne.map(di=>p(a(di,kt,Ht,he))),ps=C._values;for(let di=0;di<ps.length;di++){let ki=ps[di];if(ki!=null){F==0?W=Qi[di]:J=Qi[di],ki=""+ki;let lo=ki.indexOf(`
`)==-1?[ki]:ki.split(/\n/gm);for(let fi=0;fi<lo.length;fi++){let E0=lo[fi];$e?(h.save(),h.translate(W,J+fi*Bi),h.rotate($e),h.fillText(E0,0,0),h.restore()):h.fillText(E0,W,J+fi*Bi)}}}ne.show&&Cn(Qi,ne.filter(i,Le,M,Bt,we),F,U,_n,gn,Ke(ne.width*Oe,3),ne.stroke(i,M),ne.dash,ne.cap);let Bs=C.grid;Bs.show&&Cn(Qi,Bs.filter(i,Le,M,Bt,we),F,F==0?2:1,F==0?R:N,F==0?dt:X,Ke(Bs.width*Oe,3),Bs.stroke(i,M),Bs.dash,Bs.cap),Jt.show&&Cn([_n],[1],F==0?1:0,F==0?1:2,F==1?R:N,F==1?dt:X,Ke(Jt.width*Oe,3),Jt.stroke(i,M),Jt.dash,Jt.cap)}Yn("drawAxes")}function _e(M){x.forEach((C,U)=>{U>0&&(C._paths=null,M&&(s==1?(C.min=null,C.max=null):C.facets.forEach(F=>{F.min=null,F.max=null})))})}let mn=!1,ui=!1,Ve=[];function Pn(){ui=!1;for(let M=0;M<Ve.length;M++)Yn(...Ve[M]);Ve.length=0}function ii(){mn||(pP(a0),mn=!0)}function Yc(M,C=!1){mn=!0,ui=C,M(i),a0(),C&&Ve.length>0&&queueMicrotask(Pn)}i.batch=Yc;function a0(){if(at&&(Se(),at=!1),Mt&&(Ct(),Mt=!1),bt){if(an(f,$a,te),an(f,"top",fe),an(f,Uc,H),an(f,Fc,Nt),an(g,$a,te),an(g,"top",fe),an(g,Uc,H),an(g,Fc,Nt),an(d,Uc,fn),an(d,Fc,An),u.width=Gn(fn*Oe),u.height=Gn(An*Oe),w.forEach(({_el:M,_show:C,_size:U,_pos:F,side:W})=>{if(M!=null)if(C){let J=W===3||W===0?U:0,lt=W%2==1;an(M,lt?"left":"top",F-J),an(M,lt?"width":"height",U),an(M,lt?"top":"left",lt?fe:te),an(M,lt?"height":"width",lt?Nt:H),dg(M,Do)}else Yi(M,Do)}),zo=Er=Ho=G=Q=Y=j=Pt=P=null,Ut=1,pl(!0),te!=Rt||fe!=Ye||H!=$t||Nt!=Kt){_e(!1);let M=H/$t,C=Nt/Kt;if(yt&&!nt&&ft.left>=0){ft.left*=M,ft.top*=C,Vo&&Zs(Vo,Gn(ft.left),0,H,Nt),Wo&&Zs(Wo,0,Gn(ft.top),H,Nt);for(let U=0;U<me.length;U++){let F=me[U];F!=null&&(tn[U]*=M,ci[U]*=C,Zs(F,us(tn[U]),us(ci[U]),H,Nt))}}if(nn.show&&!st&&nn.left>=0&&nn.width>0){nn.left*=M,nn.width*=M,nn.top*=C,nn.height*=C;for(let U in Uf)an(Xo,U,nn[U])}Rt=te,Ye=fe,$t=H,Kt=Nt}Yn("setSize"),bt=!1}fn>0&&An>0&&(h.clearRect(0,0,u.width,u.height),Yn("drawClear"),b.forEach(M=>M()),Yn("draw")),nn.show&&st&&(Zc(nn),st=!1),yt&&nt&&(ao(null,!0,!1),nt=!1),pt.show&&pt.live&&_t&&(Df(),_t=!1),c||(c=!0,i.status=1,Yn("ready")),wr=!1,mn=!1}i.redraw=(M,C)=>{Mt=C||!1,M!==!1?Ar(T,D.min,D.max):ii()};function Pf(M,C){let U=v[M];if(U.from==null){if(pn==0){let F=U.range(i,C.min,C.max,M);C.min=F[0],C.max=F[1]}if(C.min>C.max){let F=C.min;C.min=C.max,C.max=F}if(pn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;M==T&&U.distr==2&&pn>0&&(C.min=Cs(C.min,t[0]),C.max=Cs(C.max,t[0]),C.min==C.max&&C.max++),$[M]=C,at=!0,ii()}}i.setScale=Pf;let If,Lf,Vo,Wo,l0,c0,qo,$o,u0,h0,en,cn,Tr=!1,ti=ft.drag,$n=ti.x,Xn=ti.y;yt&&(ft.x&&(If=cs(BC,g)),ft.y&&(Lf=cs(kC,g)),D.ori==0?(Vo=If,Wo=Lf):(Vo=Lf,Wo=If),en=ft.left,cn=ft.top);let nn=i.select=Dn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Xo=nn.show?cs(OC,nn.over?g:f):null;function Zc(M,C){if(nn.show){for(let U in M)nn[U]=M[U],U in Uf&&an(Xo,U,M[U]);C!==!1&&Yn("setSelect")}}i.setSelect=Zc;function rM(M){if(x[M].show)et&&dg(de[M],Do);else if(et&&Yi(de[M],Do),yt){let U=Dt?me[0]:me[M];U!=null&&Zs(U,-10,-10,H,Nt)}}function Ar(M,C,U){Pf(M,{min:C,max:U})}function Us(M,C,U,F){C.focus!=null&&uM(M),C.show!=null&&x.forEach((W,J)=>{J>0&&(M==J||M==null)&&(W.show=C.show,rM(J),s==2?(Ar(W.facets[0].scale,null,null),Ar(W.facets[1].scale,null,null)):Ar(W.scale,null,null),ii())}),U!==!1&&Yn("setSeries",M,C),F&&ml("setSeries",i,M,C)}i.setSeries=Us;function oM(M,C){Dn(A[M],C)}function aM(M,C){M.fill=Re(M.fill||null),M.dir=De(M.dir,-1),C=C??A.length,A.splice(C,0,M)}function lM(M){M==null?A.length=0:A.splice(M,1)}i.addBand=aM,i.setBand=oM,i.delBand=lM;function cM(M,C){x[M].alpha=C,yt&&me[M]!=null&&(me[M].style.opacity=C),et&&de[M]&&(de[M].style.opacity=C)}let tr,Rr,oo,Yo={focus:!0};function uM(M){if(M!=oo){let C=M==null,U=Gt.alpha!=1;x.forEach((F,W)=>{if(s==1||W>0){let J=C||W==0||W==M;F._focus=C?null:J,U&&cM(W,J?1:Gt.alpha)}}),oo=M,U&&ii()}}et&&re&&Ce(vv,Lt,M=>{ft._lock||(se(M),oo!=null&&Us(null,Yo,!0,In.setSeries))});function Fs(M,C,U){let F=v[C];U&&(M=M/Oe-(F.ori==1?fe:te));let W=H;F.ori==1&&(W=Nt,M=W-M),F.dir==-1&&(M=W-M);let J=F._min,lt=F._max,gt=M/W,wt=J+(lt-J)*gt,Bt=F.distr;return Bt==3?Za(10,wt):Bt==4?nP(wt,F.asinh):Bt==100?F.bwd(wt):wt}function hM(M,C){let U=Fs(M,T,C);return Cs(U,t[0],Mn,wn)}i.valToIdx=M=>Cs(M,t[0]),i.posToIdx=hM,i.posToVal=Fs,i.valToPos=(M,C,U)=>v[C].ori==0?r(M,v[C],U?X:H,U?N:0):o(M,v[C],U?dt:Nt,U?R:0),i.setCursor=(M,C,U)=>{en=M.left,cn=M.top,ao(null,C,U)};function d0(M,C){an(Xo,$a,nn.left=M),an(Xo,Uc,nn.width=C)}function f0(M,C){an(Xo,"top",nn.top=M),an(Xo,Fc,nn.height=C)}let dl=D.ori==0?d0:f0,fl=D.ori==1?d0:f0;function dM(){if(et&&pt.live)for(let M=s==2?1:0;M<x.length;M++){if(M==0&&ge)continue;let C=pt.values[M],U=0;for(let F in C)Xt[M][U++].firstChild.nodeValue=C[F]}}function Df(M,C){if(M!=null&&(M.idxs?M.idxs.forEach((U,F)=>{rt[F]=U}):oP(M.idx)||rt.fill(M.idx),pt.idx=rt[0]),et&&pt.live){for(let U=0;U<x.length;U++)(U>0||s==1&&!ge)&&fM(U,rt[U]);dM()}_t=!1,C!==!1&&Yn("setLegend")}i.setLegend=Df;function fM(M,C){let U=x[M],F=M==0&&B==2?Fi:t[M],W;ge?W=U.values(i,M,C)??ue:(W=U.value(i,C==null?null:F[C],M,C),W=W==null?ue:{_:W}),pt.values[M]=W}function ao(M,C,U){u0=en,h0=cn,[en,cn]=ft.move(i,en,cn),ft.left=en,ft.top=cn,yt&&(Vo&&Zs(Vo,Gn(en),0,H,Nt),Wo&&Zs(Wo,0,Gn(cn),H,Nt));let F,W=Mn>wn;tr=Je,Rr=null;let J=D.ori==0?H:Nt,lt=D.ori==1?H:Nt;if(en<0||pn==0||W){F=ft.idx=null;for(let gt=0;gt<x.length;gt++){let wt=me[gt];wt!=null&&Zs(wt,-10,-10,H,Nt)}re&&Us(null,Yo,!0,M==null&&In.setSeries),pt.live&&(rt.fill(F),_t=!0)}else{let gt,wt,Bt;s==1&&(gt=D.ori==0?en:cn,wt=Fs(gt,T),F=ft.idx=Cs(wt,t[0],Mn,wn),Bt=V(t[0][F],D,J,0));let kt=-10,Ht=-10,he=0,Ne=0,Le=!0,we="",ne="";for(let Jt=s==2?1:0;Jt<x.length;Jt++){let sn=x[Jt],gn=rt[Jt],Zn=gn==null?null:s==1?t[Jt][gn]:t[Jt][1][gn],$e=ft.dataIdx(i,Jt,F,wt),_n=$e==null?null:s==1?t[Jt][$e]:t[Jt][1][$e];if(_t=_t||_n!=Zn||$e!=gn,rt[Jt]=$e,Jt>0&&sn.show){let Oi=$e==null?-10:$e==F?Bt:V(s==1?t[0][$e]:t[Jt][0][$e],D,J,0),hi=_n==null?-10:O(_n,s==1?v[sn.scale]:v[sn.facets[1].scale],lt,0);if(re&&_n!=null){let Ki=D.ori==1?en:cn,fs=Vn(Gt.dist(i,Jt,$e,hi,Ki));if(fs<tr){let Os=Gt.bias;if(Os!=0){let Bi=Fs(Ki,sn.scale),Qi=_n>=0?1:-1,ps=Bi>=0?1:-1;ps==Qi&&(ps==1?Os==1?_n>=Bi:_n<=Bi:Os==1?_n<=Bi:_n>=Bi)&&(tr=fs,Rr=Jt)}else tr=fs,Rr=Jt}}if(_t||Dt){let Ki,fs;D.ori==0?(Ki=Oi,fs=hi):(Ki=hi,fs=Oi);let Os,Bi,Qi,ps,Bs,di,ki=!0,lo=ut.bbox;if(lo!=null){ki=!1;let fi=lo(i,Jt);Qi=fi.left,ps=fi.top,Os=fi.width,Bi=fi.height}else Qi=Ki,ps=fs,Os=Bi=ut.size(i,Jt);if(di=ut.fill(i,Jt),Bs=ut.stroke(i,Jt),Dt)Jt==Rr&&tr<=Gt.prox&&(kt=Qi,Ht=ps,he=Os,Ne=Bi,Le=ki,we=di,ne=Bs);else{let fi=me[Jt];fi!=null&&(tn[Jt]=Qi,ci[Jt]=ps,Av(fi,Os,Bi,ki),Ev(fi,di,Bs),Zs(fi,us(Qi),us(ps),H,Nt))}}}}if(Dt){let Jt=Gt.prox,sn=oo==null?tr<=Jt:tr>Jt||Rr!=oo;if(_t||sn){let gn=me[0];gn!=null&&(tn[0]=kt,ci[0]=Ht,Av(gn,he,Ne,Le),Ev(gn,we,ne),Zs(gn,us(kt),us(Ht),H,Nt))}}}if(nn.show&&Tr)if(M!=null){let[gt,wt]=In.scales,[Bt,kt]=In.match,[Ht,he]=M.cursor.sync.scales,Ne=M.cursor.drag;if($n=Ne._x,Xn=Ne._y,$n||Xn){let{left:Le,top:we,width:ne,height:Jt}=M.select,sn=M.scales[Ht].ori,gn=M.posToVal,Zn,$e,_n,Oi,hi,Ki=gt!=null&&Bt(gt,Ht),fs=wt!=null&&kt(wt,he);Ki&&$n?(sn==0?(Zn=Le,$e=ne):(Zn=we,$e=Jt),_n=v[gt],Oi=V(gn(Zn,Ht),_n,J,0),hi=V(gn(Zn+$e,Ht),_n,J,0),dl(Ps(Oi,hi),Vn(hi-Oi))):dl(0,J),fs&&Xn?(sn==1?(Zn=Le,$e=ne):(Zn=we,$e=Jt),_n=v[wt],Oi=O(gn(Zn,he),_n,lt,0),hi=O(gn(Zn+$e,he),_n,lt,0),fl(Ps(Oi,hi),Vn(hi-Oi))):fl(0,lt)}else Ff()}else{let gt=Vn(u0-l0),wt=Vn(h0-c0);if(D.ori==1){let he=gt;gt=wt,wt=he}$n=ti.x&&gt>=ti.dist,Xn=ti.y&&wt>=ti.dist;let Bt=ti.uni;Bt!=null?$n&&Xn&&($n=gt>=Bt,Xn=wt>=Bt,!$n&&!Xn&&(wt>gt?Xn=!0:$n=!0)):ti.x&&ti.y&&($n||Xn)&&($n=Xn=!0);let kt,Ht;$n&&(D.ori==0?(kt=qo,Ht=en):(kt=$o,Ht=cn),dl(Ps(kt,Ht),Vn(Ht-kt)),Xn||fl(0,lt)),Xn&&(D.ori==1?(kt=qo,Ht=en):(kt=$o,Ht=cn),fl(Ps(kt,Ht),Vn(Ht-kt)),$n||dl(0,J)),!$n&&!Xn&&(dl(0,0),fl(0,0))}if(ti._x=$n,ti._y=Xn,M==null){if(U){if(w0!=null){let[gt,wt]=In.scales;In.values[0]=gt!=null?Fs(D.ori==0?en:cn,gt):null,In.values[1]=wt!=null?Fs(D.ori==1?en:cn,wt):null}ml(sg,i,en,cn,H,Nt,F)}if(re){let gt=U&&In.setSeries,wt=Gt.prox;oo==null?tr<=wt&&Us(Rr,Yo,!0,gt):tr>wt?Us(null,Yo,!0,gt):Rr!=oo&&Us(Rr,Yo,!0,gt)}}_t&&(pt.idx=F,Df()),C!==!1&&Yn("setCursor")}let Cr=null;Object.defineProperty(i,"rect",{get(){return Cr==null&&pl(!1),Cr}});function pl(M=!1){M?Cr=null:(Cr=g.getBoundingClientRect(),Yn("syncRect",Cr))}function p0(M,C,U,F,W,J,lt){ft._lock||Tr&&M!=null&&M.movementX==0&&M.movementY==0||(Nf(M,C,U,F,W,J,lt,!1,M!=null),M!=null?ao(null,!0,!0):ao(C,!0,!1))}function Nf(M,C,U,F,W,J,lt,gt,wt){if(Cr==null&&pl(!1),se(M),M!=null)U=M.clientX-Cr.left,F=M.clientY-Cr.top;else{if(U<0||F<0){en=-10,cn=-10;return}let[Bt,kt]=In.scales,Ht=C.cursor.sync,[he,Ne]=Ht.values,[Le,we]=Ht.scales,[ne,Jt]=In.match,sn=C.axes[0].side%2==1,gn=D.ori==0?H:Nt,Zn=D.ori==1?H:Nt,$e=sn?J:W,_n=sn?W:J,Oi=sn?F:U,hi=sn?U:F;if(Le!=null?U=ne(Bt,Le)?a(he,v[Bt],gn,0):-10:U=gn*(Oi/$e),we!=null?F=Jt(kt,we)?a(Ne,v[kt],Zn,0):-10:F=Zn*(hi/_n),D.ori==1){let Ki=U;U=F,F=Ki}}wt&&(C==null||C.cursor.event.type==sg)&&((U<=1||U>=H-1)&&(U=Io(U,H)),(F<=1||F>=Nt-1)&&(F=Io(F,Nt))),gt?(l0=U,c0=F,[qo,$o]=ft.move(i,U,F)):(en=U,cn=F)}let Uf={width:0,height:0,left:0,top:0};function Ff(){Zc(Uf,!1)}let m0,g0,_0,x0;function y0(M,C,U,F,W,J,lt){Tr=!0,$n=Xn=ti._x=ti._y=!1,Nf(M,C,U,F,W,J,lt,!0,!1),M!=null&&(Ce(rg,ug,v0,!1),ml(xv,i,qo,$o,H,Nt,null));let{left:gt,top:wt,width:Bt,height:kt}=nn;m0=gt,g0=wt,_0=Bt,x0=kt}function v0(M,C,U,F,W,J,lt){Tr=ti._x=ti._y=!1,Nf(M,C,U,F,W,J,lt,!1,!0);let{left:gt,top:wt,width:Bt,height:kt}=nn,Ht=Bt>0||kt>0,he=m0!=gt||g0!=wt||_0!=Bt||x0!=kt;if(Ht&&he&&Zc(nn),ti.setScale&&Ht&&he){let Ne=gt,Le=Bt,we=wt,ne=kt;if(D.ori==1&&(Ne=wt,Le=kt,we=gt,ne=Bt),$n&&Ar(T,Fs(Ne,T),Fs(Ne+Le,T)),Xn)for(let Jt in v){let sn=v[Jt];Jt!=T&&sn.from==null&&sn.min!=Je&&Ar(Jt,Fs(we+ne,Jt),Fs(we,Jt))}Ff()}else ft.lock&&(ft._lock=!ft._lock,ao(C,!0,M!=null));M!=null&&(Un(rg,ug),ml(rg,i,en,cn,H,Nt,null))}function pM(M,C,U,F,W,J,lt){if(ft._lock)return;se(M);let gt=Tr;if(Tr){let wt=!0,Bt=!0,kt=10,Ht,he;D.ori==0?(Ht=$n,he=Xn):(Ht=Xn,he=$n),Ht&&he&&(wt=en<=kt||en>=H-kt,Bt=cn<=kt||cn>=Nt-kt),Ht&&wt&&(en=en<qo?0:H),he&&Bt&&(cn=cn<$o?0:Nt),ao(null,!0,!0),Tr=!1}en=-10,cn=-10,rt.fill(null),ao(null,!0,!0),gt&&(Tr=gt)}function b0(M,C,U,F,W,J,lt){ft._lock||(se(M),hl(),Ff(),M!=null&&ml(bv,i,en,cn,H,Nt,null))}function S0(){w.forEach(SI),z(i.width,i.height,!0)}No(Yd,Ya,S0);let Zo={};Zo.mousedown=y0,Zo.mousemove=p0,Zo.mouseup=v0,Zo.dblclick=b0,Zo.setSeries=(M,C,U,F)=>{let W=In.match[2];U=W(i,C,U),U!=-1&&Us(U,F,!0,!1)},yt&&(Ce(xv,g,y0),Ce(sg,g,p0),Ce(yv,g,M=>{se(M),pl(!1)}),Ce(vv,g,pM),Ce(bv,g,b0),xg.add(i),i.syncRect=pl);let jc=i.hooks=n.hooks||{};function Yn(M,C,U){ui?Ve.push([M,C,U]):M in jc&&jc[M].forEach(F=>{F.call(null,i,C,U)})}(n.plugins||[]).forEach(M=>{for(let C in M.hooks)jc[C]=(jc[C]||[]).concat(M.hooks[C])});let M0=(M,C,U)=>U,In=Dn({key:null,setSeries:!1,filters:{pub:Lv,sub:Lv},scales:[T,x[1]?x[1].scale:null],match:[Dv,Dv,M0],values:[null,null]},ft.sync);In.match.length==2&&In.match.push(M0),ft.sync=In;let w0=In.key,Of=Cb(w0);function ml(M,C,U,F,W,J,lt){In.filters.pub(M,C,U,F,W,J,lt)&&Of.pub(M,C,U,F,W,J,lt)}Of.sub(i);function mM(M,C,U,F,W,J,lt){In.filters.sub(M,C,U,F,W,J,lt)&&Zo[M](null,C,U,F,W,J,lt)}i.pub=mM;function gM(){Of.unsub(i),xg.delete(i),qn.clear(),fg(Yd,Ya,S0),l.remove(),Lt?.remove(),Yn("destroy")}i.destroy=gM;function Bf(){Yn("init",n,t),ul(t||n.data,!1),$[T]?Pf(T,$[T]):hl(),st=nn.show&&(nn.width>0||nn.height>0),nt=_t=!0,z(n.width,n.height)}return x.forEach(ko),w.forEach(js),e?e instanceof HTMLElement?(e.appendChild(l),Bf()):e(i,Bf):Bf(),i}ni.assign=Dn;ni.fmtNum=Eg;ni.rangeNum=Zd;ni.rangeLog=Kd;ni.rangeAsinh=Mg;ni.orient=Fo;ni.pxRatio=Oe;ni.join=fP;ni.fmtDate=Ag,ni.tzDate=wP;ni.sync=Cb;{ni.addGap=oI,ni.clipGaps=ef;let n=ni.paths={points:Ub};n.linear=Ob,n.stepped=cI,n.bars=uI,n.spline=dI}var Ng={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},Hb={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},of=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,Gb=80;function MI(n){let t=[];of.lastIndex=0;let e=n.trimEnd();for(;of.lastIndex<e.length;){let i=of.lastIndex,s=of.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function wI(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function af(n,t="plain"){let e=wI(String(n));if(e.length>Gb)throw new Error(`longer than ${Gb} characters`);let i=MI(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in mt.suffix(t)&&(s=mt.suffix(t)[r.word],i.pop());let o=0,a=!1,c=m=>i[o]?.sign===m,l=m=>{if(!c(m))throw new Error(`\u201C${m}\u201D is missing`);o++};function u(){let m=h();for(;c("+")||c("-");){let x=i[o++].sign,w=h();m=x==="+"?m+w:m-w}return m}function h(){let m=d();for(;;)if(c("*"))o++,m*=d();else if(c("/"))o++,m/=d();else if(i[o]?.word||c("("))m*=f();else return m}function d(){return c("-")?(o++,-d()):c("+")?(o++,d()):f()}function f(){let m=g();return c("^")?(o++,m**d()):m}function g(){let m=i[o];if(!m)throw new Error("something is missing at the end");if(o++,m.number!==void 0)return m.number;if(m.sign==="("){let x=u();return l(")"),x}if(m.word){let x=m.word.toLowerCase();if(Object.hasOwn(Hb,x))return a=!0,Hb[x];if(Object.hasOwn(Ng,x)){l("(");let w=u();return l(")"),Ng[x](w)}throw new Error(`\u201C${m.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(Ng).join(", ")}`)}throw new Error(`\u201C${m.sign}\u201D is not expected here`)}let y=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(y))throw new Error("not a finite number");let p=s??(t==="angle"&&a?1:mt.factor(t));return{value:y/p+0,symbolic:a||s!==null||i.length>2}}function Nn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let c=typeof t=="function"?t:()=>t,l=S("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(l.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let p=af(l.value,c()),m=a?.(p.value);if(m)throw new Error(m);return p},f=p=>{l.classList.toggle("wrong",!!p),p?(l.setAttribute("aria-invalid","true"),l.title=p):(l.removeAttribute("aria-invalid"),l.title=o??""),Ug(l,p),l.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:p?{label:n,reason:p}:null}))},g=p=>{try{let m=d();return f(null),p?.(m.value,{symbolic:m.symbolic,text:l.value.trim()}),!0}catch(m){return f(m.message),!1}};l.addEventListener("input",()=>g(e)),l.addEventListener("change",()=>{g(i??e)&&l.blurred?.()});let y="";return l.addEventListener("focus",()=>{y=l.value,l.classList.contains("wrong")&&Ug(l,l.title),l.select()}),l.addEventListener("blur",()=>Ug(l,null)),l.addEventListener("keydown",p=>{let m=l.closest("table.dh");if(p.key==="Escape"&&l.value!==y){p.preventDefault(),l.value=y,g(i??e),l.select();return}if(m&&EI(l,p))return;let x={ArrowUp:1,ArrowDown:-1}[p.key];if(p.key==="Enter"&&(y=l.value,l.select()),!(!x||m&&!p.altKey)){p.preventDefault();try{let w=d();l.value=yc((w.value??0)+x*mt.step(c())*(p.shiftKey?.1:1),c()),g(i??e)}catch{}}}),l.put=(p,m=null)=>{document.activeElement===l&&!l.readOnly||p===u&&m===h&&!l.classList.contains("wrong")||(u=p,h=m,l.value=m??(p==null?"":yc(p,c())),Vb(l),l.classList.contains("wrong")&&f(null))},l.addEventListener("input",()=>Vb(l)),l.refresh=()=>{let p=u,m=h;u=NaN,l.put(p,m)},l}function Vb(n){let t=n.clientWidth;if(n.value.length<7&&!n.shrunk||(n.style.removeProperty("font-size"),n.shrunk=!1,!t||n.scrollWidth<=t))return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Ti=null;function Ug(n,t){if(!t){Ti&&Ti.about===n&&(Ti.hidden=!0),n.removeAttribute("aria-describedby");return}Ti||(Ti=S("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Ti)),Ti.about=n,Ti.hidden=!1,Ti.textContent!==t&&(Ti.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Ti.style.setProperty("top",`${e.bottom+4}px`),Ti.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Ti.offsetWidth-8))}px`)}addEventListener("scroll",()=>Ti&&(Ti.hidden=!0),!0);function EI(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(l=>[...l.querySelectorAll("input.number")]),o=r.findIndex(l=>l.includes(n)),a=r[o].indexOf(n),c=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),c?(t.preventDefault(),c.focus(),!0):t.key!=="Enter"}function lf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function cf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,c)=>{let l=n[t+o]?.[e+c];l&&(l.value=a,l.dispatchEvent(new Event("input",{bubbles:!0})),l.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Xe=n=>n.type==="R"?"angle":"length";function Wb(n){let t=n.type==="R"?Math.PI:Ri(E.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var TI=Em;function AI(n){let t=E.table.joints[n],e=Xe(t),{lo:i,hi:s,min:r,max:o}=Wb(t),a=`q${n+1}`,c=S("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),l=y=>`${100*(y-r)/(o-r)}%`;c.style.setProperty("--lo",l(i)),c.style.setProperty("--hi",l(s)),c.addEventListener("input",()=>{Mi(),nu(n,Number(c.value))}),c.addEventListener("keydown",y=>{let p={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[y.key],m={Home:i,End:s}[y.key];if(p===void 0&&m===void 0)return;y.preventDefault(),Mi();let x=mt.step(e)*(y.shiftKey?.1:1);nu(n,m??Math.min(Math.max(Math.round((E.q[n]+p*x)/(x/10))*(x/10),r),o))});let u=Nn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:y=>{Mi(),nu(n,y)}}),h=S("span",{class:"out",role:"note"}),d=S("span",{class:"chain",title:"What this row of the table moves by"}),f=S("span",{class:"limits"}),g=S("div",{class:"joint","data-testid":`joint-${n+1}`},S("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},S("i",{text:"q"}),S("sub",{text:String(n+1)})),S("div",{class:"track"},c,S("div",{class:"under"},f,d,h)),u,S("span",{class:"unit"}));return{el:g,number:u,show(){let y=E.q[n],p=TI(t,y);(document.activeElement!==c||Number(c.value)!==y)&&(c.value=y),c.style.setProperty("--at",l(Math.min(Math.max(y,r),o))),c.setAttribute("aria-valuetext",We(y,e)),u.put(Number((y*mt.factor(e)).toFixed(mt.digits(e)+1))/mt.factor(e)),g.classList.toggle("outside",p!==0);let m=E.table.coupling?`chain ${We(uo(E.table,E.q)[n],e)}`:"";Et(d,m),Et(h,p?`${We(Math.abs(p),e)} ${p>0?"above":"below"} the limit`:"")},relabel(){Et(g.lastChild,mt.symbol(e));let y=p=>p===null?"no limit":We(p,e,mt.angle==="deg"&&e==="angle"?0:void 0);Et(f,t.lower===null&&t.upper===null?"no limits":`${y(t.lower)} \u2026 ${y(t.upper)}`),u.refresh(),this.show()}}}var qb={id:"joints",title:"Joints",build(n){let t=[],e=S("div",{class:"joints","data-testid":"joints"}),i=S("div",{class:"chips",role:"group","aria-label":"Postures"}),s=S("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=E.table.joints.map((o,a)=>AI(a)),Zt(e,t.map(o=>o.el)),t.length||e.append(S("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Zt(s,E.table.actuator?RI(E.table.actuator):null),CI(i)};ct("table",o=>o!=="gripper"&&r()),ct("q",()=>t.forEach(o=>o.show())),ct("units",()=>t.forEach(o=>o.relabel())),r()}};function RI(n){let t=S("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=S("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),Et(e,Qn(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},un({...E.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=S("div",{class:"under"},S("span",{text:`${n.name}: moves no frame`}));return S("div",{class:"joint"},S("span",{class:"joint-name",text:"tool"}),S("div",{class:"track"},t,s),e,S("span",{class:"unit",text:n.unit}))}function CI(n){let t=E.table.joints.length,e=Object.entries(E.table.postures??{}),i=(r,o)=>S("button",{type:"button",class:"chip",text:r,title:o.map((a,c)=>We(a,Xe(E.table.joints[c]))).join(", "),on:{click:()=>wi(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Zt(n,s,t?S("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>wi(PI(),.8,"move to a random posture")}}):null,t?S("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:II}}):null)}function PI(){return E.table.joints.map(n=>{let{lo:t,hi:e}=Wb(n);return t+Math.random()*(e-t)})}function II(){let n={...E.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=E.q.slice(),un({...E.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),vn(`Kept as P${t}: ${E.q.map((e,i)=>yc(e,Xe(E.table.joints[i]))).join(", ")}`),xt("postures")}var $b=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function io({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:c}){let l=t.map(u=>ms(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:c,tool:l.map(u=>oe(u[u.length-1])),speeds:o??LI(t,r),least:t.map((u,h)=>eu(n,u,l[h])[0]??0)}}function LI(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,c)=>o>0?(n[r][c]-n[s][c])/o:0)})}function Fg(n,t){let{table:e}=n,i=mt.factor("length");if(t==="position")return{y:`tool, ${mt.length}`,list:["X","Y","Z"].map((c,l)=>({name:c,values:n.tool.map(u=>u[l]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(Xe))].map(c=>(c==="angle"?mt.angle:mt.length)+r).join(" or "),list:e.joints.map((c,l)=>({name:`q${l+1}`,values:s.map(u=>u[l]*mt.factor(Xe(c)))}))}}function Xb(n){let t=mt.angle,e=mt.length,{table:i}=n,s=c=>Xe(c)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((c,l)=>`q${l+1}_${s(c)}`),...i.joints.map((c,l)=>`dq${l+1}_${s(c)}_per_s`),"sigma_min"],o=c=>String(Number(c.toPrecision(10))),a=n.q.map((c,l)=>[n.xs[l],n.seconds[l],...n.tool[l].map(u=>u*mt.factor("length")),...c.map((u,h)=>u*mt.factor(Xe(i.joints[h]))),...n.speeds[l].map((u,h)=>u*mt.factor(Xe(i.joints[h]))),n.least[l]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function Yb(n,t,e){let{y:i,list:s}=Fg(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},c=n.xs,l=s.flatMap(_=>_.values),u=n.xEnd??c[c.length-1],h=c[0],d=u>h?u:h+1,[f,g]=[Math.min(...l),Math.max(...l)];g-f>1e-9||(f-=1,g+=1);let y=_=>a.l+(_-h)/(d-h)*(r-a.l-a.r),p=_=>o-a.b-(_-f)/(g-f)*(o-a.t-a.b),m=(_,b)=>{let L=(b-_)/6,I=10**Math.floor(Math.log10(L)),D=[1,2,5,10].map(B=>B*I).find(B=>B>=L);return Array.from({length:12},(B,V)=>(Math.ceil(_/D)+V)*D).filter(B=>B<=b+D*1e-6)},x=_=>_.toFixed(2),w=_=>String(Number(_.toPrecision(6))),v=_=>_.replace(/[&<>"]/g,b=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[b]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],T=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let _ of m(f,g))T.push(`<path d="M${a.l} ${x(p(_))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(p(_)+4)}" text-anchor="end">${w(_)}</text>`);for(let _ of m(h,d))T.push(`<path d="M${x(y(_))} ${o-a.b}v5" stroke="#333"/><text x="${x(y(_))}" y="${o-a.b+20}" text-anchor="middle">${w(_)}</text>`);T.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let _ of n.events)Number.isFinite(_.x)&&T.push(`<path d="M${x(y(_.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(y(_.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(_.short)}</text>`);return s.forEach((_,b)=>{let L=e[b%e.length],I=_.values[_.values.length-1];T.push(`<polyline fill="none" stroke="${L}" stroke-width="1.8" stroke-dasharray="${A[b%A.length]}" points="${_.values.map((D,B)=>`${x(y(c[B]))},${x(p(D))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*b}h22" stroke="${L}" stroke-width="2" stroke-dasharray="${A[b%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*b}"><title>${x(I)}</title>${v(_.name)}</text>`)}),T.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${T.join("")}</svg>
`}var ze=null,Wn=null,nl="joints",Ji=0,Zb=1,li=null;function jb(n){let t=S("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:DI}}),e=S("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{Mi(),il(Number(e.value))}}}),i=S("output",{class:"where","data-testid":"where"}),s=S("div",{class:"marks"}),r=S("div",{class:"chart","data-testid":"chart"}),o=S("div",{class:"legend"});n.append(S("div",{class:"dock-bar"},t,yn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{Zb=Number(a)},{"data-testid":"speed"}),S("div",{class:"scrubber"},e,s),i,S("span",{class:"line"},...[["CSV",()=>es("motion.csv",Xb(ze),"text/csv")],["PNG",UI],["SVG",()=>es(`${nl}.svg`,Yb(ze,nl,ae.curves),"image/svg+xml")]].map(([a,c])=>S("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>ze&&c()}})),S("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>hs(null)}}))),S("div",{class:"dock-bar second"},xn("Curves",$b,nl,a=>{nl=a,Og()},"curves"),o),r),li={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Ir(()=>Wn&&r.clientWidth&&Wn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),ct(["units","theme"],Og),ct("moving",a=>Et(t,a&&hf?"Pause":"Play")),ct("table",a=>{ze&&!["postures","name","gripper"].includes(a)&&hs(null)})}function hs(n){if(Mi(),ze=n,E.motion=n,li.root.hidden=!n,Wn&&(Wn.destroy(),Wn=null),Wy(n?.table??null,n?.q??[]),!n){xt("motion");return}li.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Zt(li.marks,n.events.map(e=>{let i=S("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=S("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),Og(),xt("motion"),n.q.length&&il(0),requestAnimationFrame(()=>Ba())}function il(n){ze?.q.length&&(Ji=Math.min(Math.max(Math.round(n),0),ze.q.length-1),li.scrub.value=String(Ji),li.scrub.style.setProperty("--at",`${ze.q.length>1?100*Ji/(ze.q.length-1):0}%`),Et(li.where,ze.xName==="point"?`point ${Ji+1} of ${ze.q.length}`:`${Qn(ze.xs[Ji],2)} s of ${Qn(ze.xs[ze.xs.length-1],2)} s`),li.scrub.setAttribute("aria-valuetext",li.where.textContent),Ci(ze.q[Ji].slice(),"scrub"),xt("played",ze.seconds[Ji]),Bg())}var hf=!1;function DI(){if(hf){Mi();return}if(!ze?.q.length)return;let n=ze.seconds,t=n[n.length-1]||1,e=Ji>=ze.q.length-1?0:n[Ji]/t;hf=!0,sv(t/Zb,e,i=>{let s=Ji<=ze.q.length-1&&n[Ji]<=i*t?Ji:0;for(;s<n.length-1&&n[s+1]<=i*t+1e-9;)s+=1;il(s)},()=>{hf=!1,Et(li.toggle,"Play")}),Et(li.toggle,"Pause")}function Og(){if(!ze||!li)return;Wn&&(Wn.destroy(),Wn=null);let{y:n,list:t}=Fg(ze,nl),e={stroke:ae.line,width:1},i=`${Math.round(.78*uf())}px "Inter Variable", system-ui, sans-serif`;Zt(li.legend,t.map((o,a)=>{let c=S("span",{class:"swatch"});return c.style.setProperty("background",ae.curves[a%ae.curves.length]),S("span",{},c,o.name)}));let s={stroke:ae.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*uf(),gap:4};Wn=new ni({width:li.chart.clientWidth||600,height:li.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,c)=>[a,Math.max(c,ze.xEnd??c,a+1e-6)]},y:{range:(o,a,c)=>c-a>1e-9?[a-.06*(c-a),c+.06*(c-a)]:[a-1,c+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:ae.curves[a%ae.curves.length],width:1.75,pxAlign:0,points:{show:ze.q.length<3}}))],axes:[{...s,label:ze.xName==="point"?"point number":"time, s",size:2.1*uf()},{...s,label:n,size:4*uf()}]},[ze.xs,...t.map(o=>o.values)],li.chart);let r=S("div",{class:"now"});Wn.over.append(r,...ze.events.map(o=>{let a=S("div",{class:`event ${o.stop?"stop":""}`,title:o.text},S("span",{text:o.short}));return a.x=o.x,a})),Wn.over.addEventListener("pointerdown",o=>{let a=u=>il(NI(Wn.posToVal(u.clientX-Wn.over.getBoundingClientRect().left,"x")));Mi(),a(o);let c=u=>a(u),l=()=>{removeEventListener("pointermove",c),removeEventListener("pointerup",l)};addEventListener("pointermove",c),addEventListener("pointerup",l)}),Wn.hooks.setSize=[Bg],Bg()}var uf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),NI=n=>ze.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(ze.xs[t]-n)?i:t,0);function Bg(){if(!Wn)return;let n=Wn.over.clientWidth;for(let t of Wn.over.querySelectorAll(".now, .event")){let e=Wn.valToPos(t.x??ze.xs[Ji],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}function UI(){let n=Wn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=ae.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>es(`${nl}.png`,i))}function Jb(n){let t=S("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>FI(t.value)}}),e=S("p",{class:"sentence","data-testid":"sentence"}),i=S("span",{class:"online",role:"status","data-testid":"online"}),s=(l,u,h,d)=>{let f=S("button",{type:"button",text:l,"aria-label":u,on:{click:h}});return f.show=g=>{f.disabled=!g,f.title=g?`${u}: ${g} (${d})`:`Nothing to ${u.toLowerCase()}`,f.setAttribute("aria-description",g??"")},f},r=s("\u21B6","Undo",tg,"Ctrl+Z"),o=s("\u21B7","Redo",eg,"Ctrl+Shift+Z");ct("history",()=>{r.show(Bd()),o.show(kd())});let a=()=>{let{name:l,derived:u,catalog:h}=E.table,d=h?[]:[S("option",{value:"",text:u?`${l} (from ${u}, edited)`:l||"my-arm"})];Zt(t,d,(E.catalog??[]).map(f=>S("option",{value:f,text:f}))),t.value=h??""},c=S("span",{class:"group",role:"group","aria-label":"History"},r,o);n.append(S("span",{class:"mark"},S("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),S("b",{text:"pieper"})),t,c,e,S("span",{class:"bar-end"},i,xn("Angles in",[["deg","\xB0"],["rad","rad"]],mt.angle,l=>{mt.set("angle",l),xt("units")},"unit-angle"),xn("Lengths in",[["mm","mm"],["m","m"]],mt.length,l=>{mt.set("length",l),xt("units")},"unit-length"),yn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],E.theme,ld,{"data-testid":"theme"}))),xt("history"),ct(["catalog","table"],a),ct("plan",()=>{Et(e,[su(E.plan),F0(E.plan)].filter(Boolean).join(". ").replace("..",".")),e.title=E.plan?.explain??""}),ct("online",l=>{Et(i,l?"":"Server away; reconnecting"),i.classList.toggle("away",!l)}),ct(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(mt.angle),n.querySelector("[data-testid=unit-length]").mark(mt.length),n.querySelector("[data-testid=theme]").value=E.theme})}async function FI(n){if(n)try{let{table:t}=await gs("load",{name:n});un(t,{q:jo(t),what:"new",label:`open ${n}`})}catch(t){vn(t.message,"wrong")}}function Kb(n,t,e,i){let s=S("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(l=>{let u=S("div",{role:"tabpanel",class:"panel",id:`panel-${l.id}`,"aria-labelledby":`tab-${l.id}`,"data-testid":`panel-${l.id}`,hidden:!0});for(let d of l.sections??[l]){let f=S("section",{class:"section"},S("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=S("button",{type:"button",role:"tab",id:`tab-${l.id}`,"aria-controls":u.id,text:l.title,on:{click:()=>c(l.id)}});return s.append(h),{...l,panel:u,tab:h}});function c(l){r.matches&&l==="move"&&(l="inverse"),o.set(E.panel,t.scrollTop),E.panel=l;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===l||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===l)),u.tab.tabIndex=u.id===l?0:-1,u.id===l&&(document.getElementById("room").dataset.panel=l,document.getElementById("room").classList.toggle("wide",!!u.wide))}xt("panel",l),t.scrollTop=o.get(l)??0}return s.addEventListener("keydown",l=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[l.key];if(!u)return;l.preventDefault();let h=a.filter(g=>!g.tab.hidden),d=h.findIndex(g=>g.id===E.panel),f=h[(d+u+h.length)%h.length];c(f.id),f.tab.focus()}),r.addEventListener("change",()=>c(E.panel==="move"||!a.some(l=>l.id===E.panel)?"move":E.panel)),c(E.panel),c}function Qb(n){let t=S("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([l,u])=>S("button",{type:"button",text:u,on:{click:()=>ym(l)}})),S("button",{type:"button",text:"Fit",on:{click:()=>Ac()}})),e=S("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=S("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let l=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(l)),Qy(l)}}}),s=S("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:Nd}}),r=S("span",{class:"scale"}),o=S("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((l,u)=>{let h=S("span",{class:"dot"});return h.style.setProperty("background",gr[u]),S("span",{},h,l)}),r);n.append(S("div",{class:"corner top"},t,S("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s)),S("div",{class:"corner bottom"},o,e));let a=-2,c=()=>{let l=E.table.joints.length,u=Array.from({length:l+2},(d,f)=>f);E.shownFrames=(E.shownFrames??[0,l+1]).map(d=>d===a+1?l+1:d).filter(d=>d<l+2),a=l;let h=d=>{E.shownFrames=d,c()};Zt(e,S("span",{class:"group-name",text:"Frames"}),u.map(d=>S("button",{type:"button",text:Dd(d),"aria-pressed":String(E.shownFrames.includes(d)),"aria-label":`Frame ${Dd(d)}`,on:{click:()=>h(E.shownFrames.includes(d)?E.shownFrames.filter(f=>f!==d):[...E.shownFrames,d])}})),S("button",{type:"button",text:E.shownFrames.length===l+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(E.shownFrames.length===l+2?[]:u)}})),xt("frames"),Et(r,`grid ${We(bm.cell,"length",mt.length==="mm"?0:2)}`)};ct(["table","units"],c),c()}function tS(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),tg()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),eg()))})}function df(n,t){let e=Array.from({length:16},(s,r)=>S("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=S("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>S("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;Et(e[r],r>=12?String(s[r]):o?Qn(s[r]*mt.factor("length"),mt.digits("length")):Qn(s[r],4))}},i}var ff=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var kg=()=>E.frames[E.frames.length-1],nS={id:"pose",title:"Pose",build(n){let t=df("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>eS(u,"length",`pose-${u.toLowerCase()}`)),i=S("div",{class:"quantities","data-testid":"orientation"}),s=S("p",{class:"hint order"}),r=[],o=yn("Notation of the orientation",Object.entries(Es).map(([u,h])=>[u,h.title]),E.notation,u=>{E.notation=u,xt("notation")}),a=S("span",{class:"copies"},S("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>Lr(ff(kg()))}}),S("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>Lr(OI())}}));n.append(S("div",{class:"subhead"},S("span",{text:"Tool in the base frame"}),a),t,S("div",{class:"quantities"},e.map(u=>u.el)),S("div",{class:"line"},o,s),i);let c=()=>{let u=Es[E.notation];o.value=E.notation,Et(s,u.order),r=u.names.map((h,d)=>eS(h,u.kinds[d],`turn-${d}`)),Zt(i,r.map(h=>h.el)),l()},l=()=>{let u=kg();t.show(u),oe(u).forEach((h,d)=>e[d].show(h)),Es[E.notation].to(u).forEach((h,d)=>r[d].show(h))};ct("q",l),ct("notation",c),ct("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),l()}),c()}};function OI(){let n=kg(),t=Es[E.notation],e=oe(n).map((s,r)=>`${"XYZ"[r]} ${Hn(s,"length")} ${mt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${Hn(s,"angle")} ${mt.symbol("angle")}`:Qn(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function eS(n,t,e){let i=S("output",{"data-testid":e}),s=S("span",{class:"unit",text:mt.symbol(t)});return{el:S("div",{class:"quantity"},S("span",{class:"quantity-name",text:n}),i,s),show:o=>Et(i,t==="plain"?Qn(o,5):Hn(o,t)),relabel:()=>Et(s,mt.symbol(t))}}function BI(n,t){let e=[],i=n.joints.length,s=uo(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=co(n.joints[o],s[o]).theta,c=1,l=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;c*=Math.sign(Math.cos(h)),a+=c*co(n.joints[u+1],s[u+1]).theta,l+=`${c>0?"":"\u2212"}${u+2}`,e.push({name:l,value:a})}}return e}var iS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=S("div",{class:"cards","data-testid":"matrices"}),a=S("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),c=yn("Posture",[["now","present posture"]],"now",g=>{e=g,d()}),l=S("span",{class:"partial"});n.append(S("div",{class:"line"},xn("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,g=>{t=g,h()},"matrix-mode"),l),S("div",{class:"line"},S("span",{class:"field-name",text:"Numbers of the"}),c),o,S("h3",{text:"Intermediate angles"}),S("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&E.solutions?.rows[Number(e)]?.q||E.q,h=()=>{let g=E.table.joints.length;i=Math.min(i,g),s=s===0||s>g?g:s;let y=t==="links"?E.table.joints.map((m,x)=>["A",String(x+1),""]):t==="products"?E.table.joints.map((m,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&y.push(["T","tool","base"]);let p=Array.from({length:g+1},(m,x)=>[String(x),String(x)]);Zt(l,t==="partial"?[yn("From frame",p,String(i),m=>{i=Number(m),h()})," \u2192 ",yn("To frame",p,String(s),m=>{s=Number(m),h()})]:[]),r=y.map(([m,x,w])=>({grid:df(`${m} ${w} ${x}`,`matrix-${m}${w}${w?"-":""}${x}`),note:S("span",{class:"hint"}),sym:m,low:x,high:w})),Zt(o,r.map(({grid:m,note:x,sym:w,low:v,high:A})=>S("figure",{class:"card"},S("figcaption",{},S("span",{class:"symbol"},A?S("sup",{text:A}):null,S("i",{text:w}),S("sub",{text:v})),x),m))),d()},d=Ir(()=>{if(n.closest(".panel").hidden||!E.table.joints.length)return;let g=u(),y=A0(E.table,g),p=y.length;r.forEach(({grid:w,note:v},A)=>{if(t==="links"&&A<p)w.show(y[A]),Et(v,`q${A+1} = ${We(g[A],Xe(E.table.joints[A]))}`);else if(t==="links")w.show(ms(E.table,g)[p+1]);else if(t==="products")w.show(y.slice(0,A+1).reduce(zi,er()));else{let T=_=>y.slice(0,_).reduce(zi,er());w.show(zi(Jc(T(i)),T(s)))}});let m=uo(E.table,g),x=E.table.joints.map((w,v)=>[w.type==="R"?`\u03B8${v+1}`:`d${v+1}`,w.type==="R"?Hn(co(w,m[v]).theta,"angle"):Hn(co(w,m[v]).d,"length"),w.type==="R"?"angle":"length"]).concat(BI(E.table,g).map(({name:w,value:v})=>[`\u03B8${w}`,Hn(v,"angle"),"angle"]));Zt(a,S("tbody",{},x.map(([w,v,A])=>S("tr",{},S("th",{scope:"row"},S("i",{text:w[0]}),S("sub",{text:w.slice(1)})),S("td",{text:v}),S("td",{class:"unit",text:mt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let g=E.solutions?.rows??[];Zt(c,S("option",{value:"now",text:"present posture"}),g.map((y,p)=>S("option",{value:String(p),text:`solution ${p+1}: ${y.label??""}`}))),e!=="now"&&!g[Number(e)]&&(e="now"),c.value=e,d()};ct("table",h),ct(["q","units","panel"],d),ct(["solutions","panel"],f),h()}};var kI=.002;function Is(n,t,e,i){let s=[],r="",o=S("div",{class:"pose-fields"}),a=()=>{let l=Es[E.notation],u=[["X","length"],["Y","length"],["Z","length"],...l.names.map((d,f)=>[d,l.kinds[f]])],h=()=>{let d=fy(E.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,zI(s))};s=u.map(([d,f],g)=>{let y={value:0,kind:f},p=(m,x)=>{y.value=m,y.text=x.text,h()};return y.f=Nn({label:`${n}, ${d}`,kind:f,testid:`${t}-${g}`,input:p,commit:(m,x)=>{p(m,x),xt("let-go")}}),y.el=S("label",{class:"pose-field"},S("span",{text:d}),y.f,S("span",{class:"unit",text:mt.symbol(f)})),y}),Zt(o,s.map(d=>d.el)),r=E.notation},c=()=>{r!==E.notation&&a();let l=e();!l||o.contains(document.activeElement)||[...oe(l),...Es[E.notation].to(l)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,HI(u,s[h].kind))})};return ct("units",()=>{a(),c()}),ct("notation",c),a(),c(),o.addEventListener("paste",l=>{let u=lf(l.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===l.target);!u||h<0||(l.preventDefault(),cf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(c)}),{el:S("fieldset",{class:"pose-editor"},S("legend",{text:n}),o),show:c}}function zI(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?Ha(t(e),"angle"):2*Ha(t(n.slice(3)),"plain");return{metres:Ha(t(n.slice(0,3)),"length"),radians:i}}var HI=(n,t)=>String(Number((n*mt.factor(t)).toFixed(t==="plain"||mt[t]==="m"||mt[t]==="rad"?6:3))+0);function sS(n){let t=n.match(rS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:Ha(e,"length"),radians:2*Ha(i,"plain")}}var rS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function oS(n){let t=(n.replaceAll("\u2212","-").match(rS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=Qc(e);if(i>kI)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=mt.factor("length");return tu(e)}function pf(n){return n.map((t,e)=>{let i=E.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((E.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function aS(n,t){let e=t?.self_motions??[],i=pe.task??E.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Zt(n,S("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",c=(d,f)=>{let g=d.moves.length>3?"most of its joints":d.moves.join(" and "),y=d.inside.length?qI(d):"All of it lies outside the limits.";return S("div",{class:"self-motion"},S("p",{},S("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${g}, ${a(d)}: the arm moves, ${o}. ${y}`),XI(d,f,t.T,s))},l=e.length?VI(e):-1,u=e.map((d,f)=>f===l?null:c(d,f)).filter(Boolean),h=u.length?S("details",{class:"fold"},S("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Zt(n,l>=0?c(e[l],l):null,h)}var GI=n=>n.reduce((t,e,i)=>t+Math.sin((e-E.q[i])/2)**2,0),VI=n=>{let t=n.map(e=>Math.min(...e.q.map(GI)));return t.indexOf(Math.min(...t))};function WI(n){let t=(s,r)=>s.map((o,a)=>E.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(E.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),c=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,l=r.reduce((u,h,d)=>u+(o[d]-c*h)**2,0);l<i&&([i,e]=[l,n.s[s]+c*(n.s[s+1]-n.s[s])])}return e}var qI=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function $I(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function XI(n,t,e,i){let s=S("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{Mi();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),c=Math.min(a+1,n.q.length-1),l=c>a?(o-n.s[a])/(n.s[c]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+l*(n.q[c][d]-h));xt("did",{label:"slide along a self-motion",key:"self-motion"}),Ci(pf(i?R0(E.table,u,e):u),"self-motion")};return s.value=String(WI(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",$I(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let c=Number(s.value)+a/100;s.value=String(n.closed?c-Math.floor(c):Math.min(Math.max(c,0),1)),r()}),s}function lS(){let n=[],t=[],e={},i=S("div",{class:"joints"}),s=S("details",{},S("summary",{class:"hint",text:"Hold by value"}),i),r=S("p",{class:"hint"}),o=xn("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>c(f==="chosen"?n.filter(g=>!g.instead).map(g=>g.name):null),"spare-mode"),a=S("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},S("div",{class:"line spread"},S("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function c(f,{sliding:g=!1}={}){xt("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),pe.redundancy=f&&Object.fromEntries(f.map(y=>[y,e[y]])),d(),g?nv():Ts({follow:!0})}let l=f=>n.filter(g=>g.instead===f.instead).map(g=>g.name),u=f=>E.table.joints.findIndex(g=>g.name===f.name);function h(f,g){let y=f.kind==="angle"?Math.PI:Ri(E.table),p=f.lower??-y,m=f.upper??y,x=S("input",{type:"range",min:String(p),max:String(m),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${g+1}`}),w=!1,v=(b,L)=>{e[f.name]=b,c(l(f),{sliding:L})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>Ts({follow:!0})),x.addEventListener("keydown",b=>{let L={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[b.key];if(L===void 0)return;b.preventDefault(),w=!0;let I=L*mt.step(f.kind)*(b.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+I,p),m),!0)}),x.addEventListener("keyup",()=>{w&&Ts({follow:!0}),w=!1});let A=Nn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${g+1}`,check:b=>b<p-1e-9&&f.lower!==null?`below the limit ${We(p,f.kind)}`:b>m+1e-9&&f.upper!==null?`above the limit ${We(m,f.kind)}`:null,commit:b=>v(b,!1)}),T=S("span",{class:"limits"}),_=S("div",{class:"joint"},S("span",{class:"joint-name",text:f.name}),S("div",{class:"track"},x,S("div",{class:"under"},T)),A,S("span",{class:"unit"}));return{line:_,show(){let b=e[f.name];x.value=b,x.style.setProperty("--at",`${100*(Math.min(Math.max(b,p),m)-p)/(m-p||1)}%`),x.setAttribute("aria-valuetext",We(b,f.kind)),_.classList.toggle("held",!!(pe.redundancy&&f.name in pe.redundancy)),A.put(Number((b*mt.factor(f.kind)).toFixed(mt.digits(f.kind)+1))/mt.factor(f.kind))},relabel(){Et(_.lastChild,mt.symbol(f.kind));let b=L=>L===null?"no limit":We(L,f.kind,f.kind==="angle"&&mt.angle==="deg"?0:void 0);Et(T,f.lower===null&&f.upper===null?"no limits":`${b(f.lower)} \u2026 ${b(f.upper)}`),A.refresh()}}}function d(){for(let f of n)pe.redundancy&&f.name in pe.redundancy?e[f.name]=pe.redundancy[f.name]:u(f)>=0?e[f.name]=E.q[u(f)]:f.instead&&Number.isFinite(E.solutions?.arm_angle)?e[f.name]=E.solutions.arm_angle:e[f.name]??=0;o.mark(pe.redundancy?"chosen":"free"),Et(r,pe.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return ct("solutions",()=>{let f=E.solutions?.spare;if(!E.solutions||!f&&(E.solutions.brief||E.solutions.status==="REFUSED"))return;let g=JSON.stringify(f??[])!==JSON.stringify(n);if(g){n=f??[],e={},t=n.map(h),Zt(i,t.map(y=>y.line));for(let y of t)y.relabel()}a.hidden=n.length===0,g&&(s.open=n.filter(y=>!y.instead).length>1||!!pe.redundancy),d()}),ct("q",()=>!a.hidden&&!a.closest("[hidden]")&&!pe.redundancy&&d()),ct("units",()=>{for(let f of t)f.relabel();d()}),a}function cS(){let n=S("thead"),t=S("tbody"),e=S("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=S("div",{class:"scroll"},S("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let c=`${E.table.joints.map(l=>l.type).join("")}${mt.angle}${mt.length}`;c!==r&&(r=c,s=[],Zt(t),Zt(n,S("tr",{},S("th",{text:""}),S("th",{class:"left",text:"posture"}),E.table.joints.map((l,u)=>S("th",{},S("i",{text:"q"}),S("sub",{text:String(u+1)}),S("span",{class:"unit",text:` ${mt.symbol(Xe(l))}`}))),S("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=c=>{let l=E.table.joints.map(()=>S("td")),u=S("span"),h=S("span",{class:"offscreen"}),d=S("td",{class:"unit"}),f=S("tr",{tabindex:"0","data-testid":`solution-${c+1}`},S("th",{scope:"row",text:String(c+1)}),S("td",{class:"left"},u,h),l,d),g=()=>E.solutions?.rows[c]?.q,y=()=>g()&&Wa(g()),p=()=>Wa(null),m=()=>{g()&&(Wa(null),wi(pf(g()),.8,`move to solution ${c+1}`))};return f.addEventListener("pointerenter",y),f.addEventListener("pointerleave",p),f.addEventListener("focus",y),f.addEventListener("blur",p),f.addEventListener("click",m),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),m())}),{tr:f,cells:l,label:u,beyond:h,residual:d}};return{el:i,show(c){o();let l=c?.rows??[];for(;s.length<l.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=l.length===0,e.hidden=l.every(u=>u.inside),s.forEach((u,h)=>{let d=l[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&Et(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),Et(u.beyond,d.inside?"":", outside the limits"),Et(u.residual,d.residual?yd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${yd(d.residual[0])} m, ${yd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,g)=>{let y=E.table.joints[g],p=y.lower!==null&&f<y.lower-1e-9||y.upper!==null&&f>y.upper+1e-9;Et(u.cells[g],Hn(f,Xe(y))),u.cells[g].classList.toggle("out",p)}))}),this.mark()},mark(){let c=E.solutions?.rows??[];s.forEach((l,u)=>l.tr.classList.toggle("here",!!c[u]&&c[u].q.length===E.q.length&&c[u].q.every((h,d)=>Math.abs(Math.sin((h-E.q[d])/2))<1e-5)))}}}var YI={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},zg={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},ZI=new Set(["REDUNDANT","UNCERTAIN"]),Hg=120;function Gg(){pi(E.frames[E.frames.length-1].slice(),"taken")}var hS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(S("div",{class:"line spread"},S("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:Gg}}),xn("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",y=>{i.hidden=y!=="numbers",s.hidden=y!=="matrix"},"target-as")));let e=Is("Target","target",()=>E.target,(y,p)=>pi(y,"typed",p)),i=S("div",{},e.el),{el:s,show:r}=JI();n.append(i,s,KI());let o=S("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=S("div",{class:"near","data-testid":"ik-nearest"}),c=S("div",{class:"self-motions","data-testid":"self-motions"}),l=cS();n.append(lS(),o,a,c,l.el);let u=Ko(Hg,()=>{e.show(),r()}),h=Ko(Hg,()=>{if(t.hidden)return;let y=E.solutions;QI(o,y),n3(a,y),aS(c,y),l.show(y)}),d=Ko(Hg,()=>l.mark()),f=y=>()=>Ed()?y.soon():y();ct("target",f(u)),ct("notation",e.show),ct(["solutions","units"],f(h)),ct("q",f(d));let g=()=>yr("target",E.panel==="inverse"?jI(oe(E.target)):[]);ct("target",y=>y!=="drag"&&g()),ct("panel",y=>{Iy(y==="inverse"),(y!=="inverse"||E.hasTarget)&&g(),y==="inverse"&&(E.hasTarget?xt("solutions"):(E.hasTarget=!0,Gg()))}),ct("table",y=>{y==="new"&&(E.hasTarget=E.panel==="inverse",E.hasTarget&&Gg())})}};function jI(n){let t=.25*Ri(E.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function JI(){let n=S("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=S("p",{class:"reason",role:"alert"}),e=S("p",{class:"hint"});n.addEventListener("input",()=>{try{pi(oS(n.value),"typed",sS(n.value)),Et(t,""),n.removeAttribute("aria-invalid")}catch(s){Et(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(Et(e,`Twelve or sixteen numbers, row by row; the last column in ${mt.length}.`),document.activeElement===n)return;let s=E.target.map((r,o)=>o%4===3&&o<12?r*mt.factor("length"):r);n.value=ff(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return ct("units",i),i(),{el:S("div",{hidden:!0},n,e,t),show:i}}function KI(){let n=S("span",{class:"line"}),t=S("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{pe.follow=t.checked}}});return ct("plan",()=>Zt(n,E.plan?.solvable?[S("span",{class:"field-name",text:"Task"}),yn("Task",[["",`${E.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],pe.task??"",e=>{xt("did",{label:"choose the task"}),pe.task=e||null,pe.redundancy=null,Ts()},{"data-testid":"task"})]:[])),S("div",{class:"line controls"},S("span",{class:"line"},S("span",{class:"field-name",text:"Handles"}),xn("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Ly)),xn("Axes of the handles",[["local","Tool"],["world","World"]],"local",Dy),S("span",{class:"line"},S("span",{class:"field-name",text:"Snap"}),yn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",e=>Ny(Number(e)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),S("span",{class:"line"},S("span",{class:"field-name",text:"Ghosts"}),xn("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",e=>{pe.ghosts=e,qa()})),S("label",{class:"check"},t,"Arm follows"),n)}function QI(n,t){if(!t){Zt(n,S("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=YI[t.status]??"note";let s=t.status==="SOLVED"&&e?uS(t.missed):[t.why,uS(t.missed)].filter(Boolean).join(" "),r=zg[t.status]&&!i?t.why.toLowerCase().includes(zg[t.status].toLowerCase())?"":zg[t.status]:ZI.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Zt(n,S("strong",{text:r})," ",S("span",{text:s}),t.ms===void 0?null:S("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var uS=n=>n?`The pose was rounded by ${e3(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",t3=(n,t)=>We(n,t,mt.digits(t)+2),e3=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*mt.factor(e)>=.5*10**-(mt.digits(e)+2)).map(([t,e])=>t3(t,e)).join(" and ");function n3(n,t){let e=t?.near;if(!e){Zt(n);return}let i=oe(e.T).map(s=>Hn(s,"length")).join(", ");Zt(n,S("p",{},S("strong",{text:"Nearest reachable: "}),`${i} ${mt.symbol("length")}, ${We(e.metres,"length")} away`,e.radians>.001?`, turned by ${We(e.radians,"angle")}`:""),S("div",{class:"line"},S("button",{type:"button",text:"Go there",on:{click:()=>wi(e.q)}}),S("button",{type:"button",text:"Make it the target",on:{click:()=>pi(e.T,"chosen")}})))}var Vg=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function mf(n){return Vg(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function gf(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:c,alpha:l,text:u})=>({a:c,alpha:l,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let c=mf(r)??{a:0,alpha:0};mf(r)&&(r=er()),o=zi(Vg(s[i-1].a,s[i-1].alpha),o),a=[c,...s.slice(0,-1)]}else{let c=mf(o)??{a:0,alpha:0};mf(o)&&(o=er()),r=zi(r,Vg(s[0].a,s[0].alpha)),a=[...s.slice(1),c]}return{...n,convention:t,base:r,tool:o,joints:e.map((c,l)=>({...c,a:a[l].a,alpha:a[l].alpha,text:{...c.text,a:a[l].text?.a,alpha:a[l].text?.alpha}}))}}var dS=30,i3=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),s3={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},sl=null;function fS(n,t){sl={label:n,key:"paste",open:!0};try{t(sl)}finally{sl=null,xt("let-go")}}function _f(n,t,e,{symbolic:i,text:s},r){let o=E.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(E.table.joints[n][t],e)&&E.table.joints[n].text?.[t]===o[n].text[t],l={what:"cell",label:`edit ${s3[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||un({...E.table,joints:o},sl?{...l,...sl}:l),r&&!sl&&xt("let-go")}function rl(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=E.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),c=t(E.q,0),l=o?t(o,null).map((u,h)=>r3(u&&t(u,0),h,n.length)):null;un({...E.table,joints:n,postures:a,coupling:l},{q:c,what:"rows",label:e,key:i,open:s})}var r3=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function pS(n,t,e){let i=E.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function Wg({label:n,key:t,open:e}={}){let i=E.table.joints.length;return i>=dS?(vn(`At most ${dS} joints.`,"wrong"),!1):(rl([...E.table.joints,i3(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function qg(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};rl(e(E.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function xf(){try{es(`${E.table.name||"arm"}.toml`,(await En("save",{})).text,"application/toml")}catch(n){vn(n.message,"wrong")}}async function mS(n){let t=n.files[0];if(n.value="",!!t){if(t.size>2e5){vn(`${t.name} has ${t.size} bytes; a robot file has at most 200,000.`,"wrong");return}try{let{table:e}=await gs("open",{name:t.name.slice(-80),text:await t.text()});un(e,{q:jo(e),what:"new",label:`open ${t.name.slice(-40)}`})}catch(e){vn(e.message,"wrong")}}}var $g={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},o3=({catalog:n,...t})=>n?{...t,derived:n}:t,a3=n=>n.type==="R"?"angle":"length",gS={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=S("thead"),s=S("tbody"),r=S("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=S("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=S("p",{class:"verdict","data-testid":"arm-kind"}),c=xn("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],E.table.convention,w=>{w!==E.table.convention&&un(gf(E.table,w),{what:"rows",label:`make the table ${w}`})},"convention"),l=S("p",{class:"hint order"}),u=S("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>un({...o3(E.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=S("input",{type:"file",accept:".toml,.urdf,.xml",class:"offscreen","aria-label":"Robot file","data-testid":"robot-file",tabindex:"-1",on:{change:()=>mS(h)}}),d=Is("Base","base",()=>E.table.base,w=>un({...E.table,base:w},{what:"cell",label:"edit the base",key:"base",open:!0})),f=Is("Tool","tool",()=>E.table.tool,w=>un({...E.table,tool:w},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(S("div",{class:"line spread"},S("span",{class:"line"},u),S("span",{class:"line"},S("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>un(C0(E.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),S("button",{type:"button",text:"Open\u2026",title:"A robot file (.toml) or a URDF",on:{click:()=>h.click()}}),h,S("button",{type:"button",text:"Save",title:"As a robot file",on:{click:xf}}))),S("div",{class:"line spread"},c,xn("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,w=>{t=w,m()},"dh-part")),l,r,S("div",{class:"line"},S("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>Wg()}}),S("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,S("details",{class:"fold","data-testid":"base-tool"},S("summary",{text:"Base and tool"}),d.el,f.el)),s.addEventListener("paste",w=>{let v=lf(w.clipboardData.getData("text")),A=()=>[...s.rows].map(b=>[...b.querySelectorAll("input.number")]);if(!v||!w.target.matches("input.number"))return;w.preventDefault();let T=A().findIndex(b=>b.includes(w.target)),_=A()[T].indexOf(w.target);fS("paste a table",b=>{for(;E.table.joints.length<T+v.length&&Wg(b););let L=cf(A(),T,_,v),I=v.flat().length;vn(`Pasted ${L} number${L===1?"":"s"}${L<I?`; ${I-L} had no cell`:""}`)})}),n.addEventListener("verdict",w=>{let v=w.detail??l3(n);Et(o,v?`${v.label}: ${v.reason}. The arm stays as it was.`:"")});let g=(w,v,[A,T,_])=>{let b=w.type==="R"&&A==="theta"||w.type==="P"&&A==="d",L=A==="lower"||A==="upper",I=Nn({label:`Joint ${v+1}, ${T}`,kind:_??a3(w),testid:`dh-${v+1}-${A}`,empty:L?null:void 0,check:D=>L?pS(v,A,D):D!==null&&Math.abs(D)>1e6?"larger than a million":null,input:(D,B)=>_f(v,A,D,B,!1),commit:(D,B)=>_f(v,A,D,B,!0)});return L&&(I.placeholder="none"),e.push({f:I,i:v,key:A}),S("td",{class:b?"variable":""},b?S("span",{class:"plus"},S("i",{text:"q"}),S("sub",{text:String(v+1)})," +"):null,I)},y=(w,v)=>S("button",{type:"button",class:`type type-${w.type}`,text:w.type,"data-testid":`dh-${v+1}-type`,"aria-label":`Joint ${v+1} is ${w.type==="R"?"revolute":"prismatic"}; press to change`,title:w.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>rl(E.table.joints.map((A,T)=>T===v?{...A,type:A.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...A.text,lower:void 0,upper:void 0,offset:void 0}}:A),A=>A.map((T,_)=>_===v&&typeof T=="number"?0:T),`make joint ${v+1} ${w.type==="R"?"prismatic":"revolute"}`)}}),p=(w,v)=>S("td",{class:"tools"},S("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${w+1} up`,disabled:w===0,on:{click:()=>qg(w,w-1)}}),S("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${w+1} down`,disabled:w===v-1,on:{click:()=>qg(w,w+1)}}),S("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${w+1}`,on:{click:()=>rl(E.table.joints.filter((A,T)=>T!==w),A=>A.filter((T,_)=>_!==w),`remove joint ${w+1}`)}})),m=()=>{e=[];let{joints:w}=E.table,v=E.table.convention==="modified",A=t==="geometry"?$g.geometry.map(([T,_,b])=>S("th",{scope:"col"},S("i",{text:_}),S("sub",{text:v&&(T==="a"||T==="alpha")?"i\u22121":"i"}),S("span",{class:"unit",text:` ${mt.symbol(b)}`}))):["name","lower limit","upper limit","zero","sense"].map(T=>S("th",{scope:"col",text:T}));Zt(i,S("tr",{},S("th",{scope:"col",text:"i"}),S("th",{scope:"col","aria-label":"type"}),A,S("th",{"aria-label":"row tools"}))),Zt(s,w.map((T,_)=>{let b=t==="geometry"?$g.geometry.map(L=>g(T,_,L)):[S("td",{},S("input",{type:"text",class:"name",value:T.name,maxlength:"40","aria-label":`Joint ${_+1}, name`,on:{change:L=>_f(_,"name",L.target.value||`joint_${_+1}`,{},!0)}})),...$g.joint.map(L=>g(T,_,L)),S("td",{},S("button",{type:"button",class:"type",text:T.sign>0?"+":"\u2212","aria-label":`Joint ${_+1}, sense of the maker: ${T.sign>0?"as the table":"against the table"}`,on:{click:()=>rl(E.table.joints.map((L,I)=>I===_?{...L,sign:-L.sign}:L),L=>L,`turn the sense of joint ${_+1}`)}}))];return S("tr",{"data-testid":`dh-row-${_+1}`},S("th",{scope:"row",text:String(_+1)}),S("td",{},y(T,_)),b,p(_,w.length))})),w.length||s.append(S("tr",{},S("td",{colspan:"7",class:"hint",text:"No joints yet."}))),x()},x=()=>{for(let{f:w,i:v,key:A}of e){let T=E.table.joints[v];w.put(T[A],T.text?.[A]??null)}c.mark(E.table.convention),Et(l,E.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=E.table.name),d.show(),f.show()};ct("table",w=>{Et(o,""),w==="cell"||w==="name"||w==="postures"?x():m()}),ct("units",m),ct("notation",()=>{d.show(),f.show()}),ct("plan",()=>{a.dataset.tone=E.plan?.solvable?"good":"wrong",Zt(a,S("strong",{text:su(E.plan)||(E.plan?.refused?"Refused":"Not solved")})," ",S("span",{text:E.plan?.explain??""}))}),m()}};function l3(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var c3=4,u3=n=>{let t=n.toFixed(c3);return Number(t)<0?`(${t})`:t.replace("-","")};function yf(n,t,e){let i=uo(t,e),s=t.joints.map((l,u)=>co(l,i[u])),r=l=>l.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:l=>Math.cos(r(l)),sin:l=>Math.sin(r(l)),slide:([[l]])=>s[l-1].d};return n.symbols.reduce((l,u)=>l.replaceAll(u.latex,u3(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var vf=null;async function h3(){return vf??=(await import("./katex-OJEVB6AI.js")).default,vf}function d3(n,t){let e=S("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function _S(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>d3(n,i)],[i=>"code"in i,i=>S("code",{text:i.code})],[()=>!0,i=>S("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var f3=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function p3(n){let t=E.table.joints.map((e,i)=>S("th",{},S("i",{text:"q"}),S("sub",{text:String(i+1)}),S("span",{class:"unit",text:` ${mt.symbol(Xe(e))}`})));return[S("h3",{text:"The formulas at the present pose"}),S("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},S("thead",{},S("tr",{},S("th",{text:"branch"}),t)),S("tbody",{},n.map((e,i)=>S("tr",{},S("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>S("td",{text:Hn(s,Xe(E.table.joints[r]))}))))))]}var xS={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=S("p",{class:"hint",role:"status","data-testid":"equations-note"}),c=S("div",{class:"equations","data-testid":"equations"}),l=xn("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,y()},"equation-numbers"),u=S("div",{class:"scroll"});n.append(S("div",{class:"line spread"},S("span",{class:"line"},xn("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,y()},"which-equations"),l),S("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>Lr(f())}})),a,u,c);let h=v=>v.symbols&&i==="present"?yf(v,E.table,E.q):v.latex,d=v=>v.number===void 0?"":` \\tag{${v.number}}`,f=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${d(v)} \\]`:f3(v.pieces)).join(`

`);function g(v){r=[],Zt(c,o.map(A=>p(v,A))),m()}async function y(){if(t.hidden||!E.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(E.table.joints)}${E.table.convention}`;if(s!==v){s=v,Et(a,"Deriving \u2026"),Zt(c);try{let[A,T]=await Promise.all([h3(),En("equations",{which:e,numbers:i==="symbols"?i:"numbers"},_=>Et(a,_.note??""))]);if(s!==v)return;Et(a,T.note??""),o=T.blocks,g(A),l.hidden=e!=="forward",Zt(u),x()}catch(A){if(s!==v)return;s=null,Et(a,A.message)}}}function p(v,A){if(A.kind==="heading"||A.kind==="step")return S("h3",{},_S(v,A.pieces));if(A.kind!=="equation")return S("p",{class:"prose"},_S(v,A.pieces));let T=S("div",{class:"formula"});try{v.render(h(A),T,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{T.replaceChildren(S("code",{text:h(A)}))}if(A.number!==void 0)return S("div",{class:"formula-row numbered"},T,S("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return T;let _=S("output",{class:"value","data-entry":String(A.entry)});return r.push({value:_,entry:A.entry}),S("div",{class:"formula-row"},T,_)}let m=Ir(()=>{if(t.hidden)return;let v=E.frames[E.frames.length-1];for(let{value:A,entry:T}of r)Et(A,`= ${T%4===3?`${Qn(v[T]*mt.factor("length"),mt.digits("length"))} ${mt.length}`:Qn(v[T],4)}`)}),x=zs(async()=>{if(!(t.hidden||e!=="inverse"||!c.childElementCount))try{let{rows:v}=await En("formulas",{T:E.frames.at(-1)});Zt(u,v.length&&e==="inverse"?p3(v):null)}catch{Zt(u)}},250),w=zs(()=>{!t.hidden&&vf&&o.length&&e==="forward"&&i==="present"&&g(vf)},120);ct("q",w),ct("panel",w),ct("q",x),ct("units",x),ct("panel",y),ct("plan",y),ct(["q","units"],m)}};var Xg=()=>E.frames[E.frames.length-1].slice(),yS={id:"path",title:"Path",wide:!0,build(n,t){let e=E.path,i=["from","to"].map(p=>{let m=Is(p==="from"?"From":"To",`path-${p}`,()=>e[p],v=>{xt("did",{label:`set \u201C${p}\u201D of the path`,key:`path-${p}`}),e[p]=v,h(),xt("path")}),x=S("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`take-${p}`,on:{click:()=>{xt("did",{label:`take \u201C${p}\u201D of the path`}),e[p]=Xg(),m.show(),h(),xt("path")}}});return{el:S("div",{class:"end"},x,m.el),show:m.show}}),s=S("span",{class:"hint"}),r=Nn({label:"Number of points N",testid:"path-n",check:p=>Number.isInteger(p)&&p>=2&&p<=2e3?null:"a whole number from 2 to 2000",input:p=>{xt("did",{label:"set the points of the path",key:"path-n"}),e.n=p}}),o=Nn({label:"Seconds for the whole line",testid:"path-seconds",check:p=>p>0&&p<=3600?null:"more than 0, at most 3600",input:p=>{xt("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=p}}),a=S("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let p=oe(e.to);xt("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((m,x)=>{e.to[m]=p[x]}),i[1].show(),h()}}}}),c=S("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>d(E.q)}}),l=S("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=S("div",{class:"branches","data-testid":"branches"});n.append(...i.map(p=>p.el),S("div",{class:"line"},a,s),S("div",{class:"line"},S("label",{class:"field"},S("span",{class:"field-name",text:"Points N"}),r),S("label",{class:"field"},S("span",{class:"field-name",text:"Seconds"}),o),c,S("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),l,u);let h=()=>{if(!e.from||!e.to){Et(s,"");return}let p=T0(e.from,e.to);Et(s,`${We(ts(Ai(oe(e.to),oe(e.from))),"length")} long${p>1e-6?`, turning ${We(p,"angle")}`:", orientation kept"}`),Ud(Array.from({length:33},(m,x)=>oe(py(e.from,e.to,x/32))))};async function d(p){let m=Qo(n);if(m){l.hidden=!1,l.dataset.tone="wrong",Et(l,m);return}Et(c,"Planning \u2026"),c.disabled=!0;try{let x=await En("follow",{T0:e.from,T1:e.to,n:e.n,start:p});E.track=x,f(x,p)}catch(x){l.hidden=!1,l.dataset.tone="wrong",Et(l,x.message)}finally{Et(c,"Plan the line"),c.disabled=!1}}function f(p){if(l.hidden=!1,l.dataset.tone=p.complete?"good":"wrong",Et(l,p.explain),Zt(u,p.branches.length?S("h3",{text:"Branches that start at the first pose"}):null,p.branches.map((v,A)=>S("button",{type:"button",class:`branch ${A===p.chosen?"chosen":""}`,"aria-pressed":String(A===p.chosen),"data-testid":`branch-${A+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await wi(v.q,.4,`take branch ${A+1}`),d(v.q)}}},S("span",{class:"branch-name",text:`${A+1}  ${v.label}`}),g(v.s),S("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),Ud(p.path.map(oe)),!p.q.length){hs(null);return}let m=p.path.length,x=p.q.map((v,A)=>A+1),w=p.q.map((v,A)=>m>1?e.seconds*A/(m-1):0);hs(io({table:E.table,q:p.q,xs:x,xName:"point",xEnd:m,seconds:w,title:`${E.table.name}: straight line, ${p.q.length} of ${m} points`,events:p.events.map(v=>({...v,x:1+v.s*(m-1),short:v.cause}))}))}function g(p){let m=S("span",{class:"bar-fill"});return m.style.setProperty("width",`${100*p}%`),S("span",{class:"bar"},m)}let y=()=>{i.forEach(p=>p.show()),r.put(e.n),o.put(e.seconds),h()};ct("panel",p=>{p==="path"&&(e.from??=Xg(),e.to??=Xg(),y())}),ct("path-loaded",y),ct("notation",y),ct("units",h),ct("table",p=>{["postures","name","gripper"].includes(p)||(l.hidden=!0,Zt(u),Ud([]),t.hidden||y())})}};var vS=Math.PI/180,m3=()=>({turn_speed:180*vS,turn_acceleration:600*vS,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});function Gc(n,t,{key:e,open:i}={}){xt("did",{label:t,key:e,open:i}),!E.program.length&&n.length&&(E.start??=E.q),E.program=n,xt("program")}var Yg=(n,t,e,i)=>Gc(E.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function bS(n,t){xt("did",{label:t,key:"limits"}),E.limits={...bf(),...n},xt("program","limits")}var bf=()=>({...m3(),...E.limits});function SS(n,t="set the start of the program"){xt("did",{label:t}),E.start=n,xt("program")}var Sf=()=>E.start?.length===E.table.joints.length?E.start:E.q;function ol(){let n=bf(),t=E.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:Sf(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:E.program.map(({name:i,...s})=>s)}}var g3=()=>E.frames.at(-1).slice();function MS(n){let t=r=>`edit step ${r+1}`,e=(r,o,a)=>Yg(r,o,t(r),{key:`step-${r}-${a}`});function i(r,o,a,c){let l=Nn({label:`Step ${r+1}, ${a}`,testid:`step-${r+1}-${o}`,...c,input:u=>{n(()=>e(r,{[o]:u},o))}});return l.put(E.program[r][o]??null),S("label",{class:"field"},S("span",{class:"field-name",text:c.unit?`${a}, ${c.unit}`:a}),l)}function s(r,o){if(r.kind==="wait")return S("div",{class:"line step-editor"},i(o,"seconds","seconds",{check:c=>c>=0?null:"0 or more"}));if(r.kind==="gripper")return S("div",{class:"line step-editor"},i(o,"value","value",{check:c=>c>=0&&c<=1?null:"from 0, open, to 1, closed"}));if(r.kind==="output")return S("div",{class:"line step-editor"},i(o,"port","port",{check:c=>Number.isInteger(c)&&c>=0?null:"a whole number from 0"}),S("label",{class:"check"},S("input",{type:"checkbox",checked:r.value,on:{change:c=>e(o,{value:c.target.checked},"value")}}),"on"));let a=(c,l)=>Is(l,`step-${o+1}-${c}`,()=>E.program[o]?.[c],h=>{n(()=>e(o,c==="T"?{T:h,q:null}:{[c]:h},c))}).el;return S("div",{class:"step-editor"},S("div",{class:"line"},yn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"]],r.kind,c=>e(o,{kind:c,q:c==="joint"?r.q??null:null,speed:null,...c==="circle"&&!r.via?{via:r.T}:{}},"kind"),{"data-testid":`step-${o+1}-kind`}),i(o,"blend","blend",{kind:"length",unit:mt.length,check:c=>c>=0?null:"0 or more"}),r.kind==="joint"?i(o,"speed","part of the speed",{empty:null,check:c=>c===null||c>0&&c<=1?null:"above 0 to 1"}):i(o,"speed","speed",{kind:"length",unit:`${mt.length}/s`,empty:null,check:c=>c===null||c>0?null:"more than 0"})),r.kind==="circle"?a("via","Over"):null,a("T",r.q?"To (a taught posture; typing makes it a pose)":"To"),S("div",{class:"line"},S("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${o+1}-teach`,on:{click:()=>Yg(o,{T:g3(),q:r.kind==="joint"?E.q.slice():null},`teach step ${o+1}`)}}),r.q?S("button",{type:"button",class:"quiet",text:"Go there",on:{click:()=>wi(r.q.slice(),.8,`go to step ${o+1}`)}}):null))}return s}function wS(){let n=S("div",{class:"line limits-of"}),t=()=>{let e=new Set(E.table.joints.map(r=>r.type)),i=(r,o,a,c,l)=>{let u=Nn({label:o,kind:a,empty:l,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>bS({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(bf()[r]),l===null&&(u.placeholder="none"),S("label",{class:"field"},S("span",{class:"field-name",text:`${o}, ${mt.symbol(a)}${c}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Zt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return ct(["table","units"],t),ct("program",e=>e==="undo"&&t()),t(),n}var ES=200,_3=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],Zg={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output"},Mf=()=>E.frames.at(-1).slice(),TS={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=S("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=S("p",{class:"verdict",role:"status","data-testid":"program-verdict",hidden:!0}),o=S("details",{class:"fold",hidden:!0},S("summary",{text:"What binds, and when"}),S("p",{class:"hint prose"})),a=(_,b,L,I)=>S("button",{type:"button",text:b,title:L,"data-testid":`step-add-${_}`,on:{click:()=>f(I())}}),c=S("button",{type:"button",class:"primary",text:"Run the program","data-testid":"run-program",on:{click:A}}),l=S("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(S("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:E.q.slice(),T:Mf(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Mf(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Mf(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0}))),S("div",{class:"line spread"},l,S("span",{class:"line"},S("button",{type:"button",class:"quiet",text:"Start here","data-testid":"start-here",title:"The program begins in the present posture",on:{click:()=>SS(E.q.slice())}}),S("button",{type:"button",class:"quiet",text:"Go to the start",on:{click:()=>wi(Sf().slice(),.8,"go to the start")}}))),s,wS(),S("div",{class:"line"},c,S("span",{class:"line"},yn("Language of the file",_3,u,_=>{u=_},{"data-testid":"dialect"}),S("button",{type:"button",text:"Save the program","data-testid":"save-program",on:{click:T}}))),r,o);let h=()=>E.program.findLast(_=>_.T)?.T??Mf(),d=()=>E.program.findLast(_=>_.kind==="gripper")?.value??0;function f(_){if(E.program.length>=ES){vn(`At most ${ES} steps.`,"wrong");return}let b=t>=0?t+1:E.program.length;t=b,Gc([...E.program.slice(0,b),_,...E.program.slice(b)],`add a step: ${Zg[_.kind].toLowerCase()}`)}function g(_,b){if(b<0||b>=E.program.length||_===b)return;let L=E.program.slice(),[I]=L.splice(_,1);L.splice(b,0,I),t=b,Gc(L,`move step ${_+1} to ${b+1}`),s.children[b]?.querySelector(".step-name")?.focus()}function y(_){t=-1,Gc(E.program.filter((b,L)=>L!==_),`remove step ${_+1}`)}function p(_){return _.kind==="wait"?`${_.seconds} s`:_.kind==="gripper"?_.value===0?"open":_.value===1?"closed":`${_.value}`:_.kind==="output"?`${_.port} ${_.value?"on":"off"}`:_.kind==="joint"&&_.q?_.q.map((b,L)=>Hn(b,Xe(E.table.joints[L]??{type:"R"}),1)).join(", "):`${oe(_.T).map(b=>Hn(b,"length",1)).join(", ")} ${mt.length}`}function m(_,b){let L=b===t,I=S("button",{type:"button",class:"step-name quiet","aria-expanded":String(L),"data-testid":`step-${b+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=L?-1:b,v()},keydown:B=>{let V={ArrowUp:-1,ArrowDown:1}[B.key];V&&B.altKey?(B.preventDefault(),g(b,b+V)):V?(B.preventDefault(),s.children[b+V]?.querySelector(".step-name")?.focus()):B.key==="Delete"&&y(b)}}},S("b",{text:Zg[_.kind]}),` ${p(_)}`,_.blend?S("span",{class:"hint",text:`, blend ${We(_.blend,"length",0)}`}):null),D=S("li",{class:`step${e?.step===b?" failed":""}${L?" open":""}`,draggable:"true","data-testid":`step-row-${b+1}`},S("div",{class:"step-line"},S("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),S("span",{class:"hint",text:String(b+1)}),I,S("button",{type:"button",class:"icon",text:"\u2191",disabled:b===0,"aria-label":`Move step ${b+1} up`,on:{click:()=>g(b,b-1)}}),S("button",{type:"button",class:"icon",text:"\u2193",disabled:b===E.program.length-1,"aria-label":`Move step ${b+1} down`,on:{click:()=>g(b,b+1)}}),S("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove step ${b+1}`,on:{click:()=>y(b)}})),e?.step===b?S("p",{class:"reason",text:e.text}):null,L?w(_,b):null);return D.addEventListener("dragstart",B=>{i=b,B.dataTransfer.effectAllowed="move",B.dataTransfer.setData("text/plain",String(b))}),D.addEventListener("dragover",B=>{i<0||(B.preventDefault(),D.classList.add("target"))}),D.addEventListener("dragleave",()=>D.classList.remove("target")),D.addEventListener("drop",B=>{B.preventDefault();let V=i;i=-1,V>=0&&g(V,b)}),D}let x=!1,w=MS(_=>{x=!0,_(),x=!1});function v(){if(x){E.program.forEach((b,L)=>{let I=s.children[L]?.querySelector(".step-name");I&&Zt(I,S("b",{text:Zg[b.kind]}),document.createTextNode(` ${p(b)}`))});return}t>=E.program.length&&(t=-1),Zt(s,E.program.map(m)),E.program.length||s.append(S("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),c.disabled=!E.program.length;let _=Sf();Et(l,E.program.length?`Starts at ${_.map((b,L)=>Hn(b,Xe(E.table.joints[L]),1)).join(", ")}`:"")}async function A(){r.hidden=!1;let _=Qo(n);if(_){r.dataset.tone="wrong",Et(r,_);return}c.disabled=!0,Et(c,"Planning \u2026");try{let b=await En("program",ol());e=b.failed,e&&(t=e.step),r.dataset.tone=e?"wrong":"good",Et(r,e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:b.explain),o.hidden=!b.tight.length,Et(o.lastChild,b.tight.map(I=>I.text).join(`
`)),v();let L=b.events.map(([I,D,B])=>({x:I,s:0,text:`${D} ${B} at ${I.toFixed(2)} s`,short:D==="gripper"?B>.5?"close":"open":D,stop:!1}));hs(Object.assign(io({table:E.table,q:b.q,xs:b.t,xName:"time",seconds:b.t,dq:b.dq,events:L,title:`${E.table.name}: program, ${b.duration.toFixed(2)} s`}),{ddq:b.ddq,happens:b.events,tight:b.tight,limits:ol().limits}))}catch(b){r.dataset.tone="wrong",Et(r,b.message)}finally{c.disabled=!E.program.length,Et(c,"Run the program")}}async function T(){try{let _="program",{text:b,name:L}=await En("program_file",{...ol(),dialect:u,name:_});es(L,b)}catch(_){r.hidden=!1,r.dataset.tone="wrong",Et(r,_.message)}}ct(["program","units","table"],_=>{_!=="limits"&&(e=null,v())}),v()}};var x3=60,y3={box:"Box",cylinder:"Cylinder",frame:"Frame"},v3={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function jg(n,t,e={}){xt("did",{label:t,...e}),E.world=n,xt("world")}var wf=(n,t,e)=>jg(E.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function b3(n,t){if(E.world.length>=x3)return;let e=oe(E.frames.at(-1)),i=.06*Ri(E.table),s=l=>Math.round(l*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1],o=t==="object"?"object":n,a=1;for(;E.world.some(l=>l.name===`${o} ${a}`);)a+=1;let c=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};jg([...E.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...c}],`add ${o} ${a}`)}var AS={id:"world",title:"World",wide:!0,build(n){let t=S("div",{class:"things","data-testid":"world"}),e=(o,a,c,l)=>S("button",{type:"button",text:o,title:l,"data-testid":`add-${c}-${a}`,on:{click:()=>b3(a,c)}});n.append(S("div",{class:"line"},e("+ Object","box","object","A box that the gripper can take"),e("+ Box","box","obstacle","A table, a wall"),e("+ Cylinder","cylinder","obstacle","A post, a can"),e("+ Frame","frame","obstacle","A place with a name")),S("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),t);let i=!1,s=()=>{i||(Zt(t,E.world.map(r)),E.world.length||t.append(S("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function r(o,a){let c=d=>(...f)=>{i=!0,d(...f),i=!1},l=S("input",{type:"text",value:o.name,maxlength:"40","aria-label":`Name of ${o.name}`,on:{change:()=>l.value&&wf(a,{name:l.value},`name ${l.value}`)}}),u=v3[o.kind].map((d,f)=>{let g=Nn({label:`${o.name}, ${d}`,kind:"length",testid:`world-${a+1}-size-${f}`,check:y=>y>0?null:"more than 0",input:c(y=>{let p=E.world[a],m=o.kind==="box"?{size:p.size.map((x,w)=>w===f?y:x)}:{[f?"h":"r"]:y};wf(a,m,`size of ${o.name}`)})});return g.put(o.kind==="box"?o.size[f]:f?o.h:o.r),S("label",{class:"field"},S("span",{class:"field-name",text:`${d}, ${mt.length}`}),g)}),h=Is("Place of its middle",`world-${a+1}`,()=>E.world[a]?.T,c(d=>wf(a,{T:d},`move ${o.name}`)));return S("section",{class:"thing","aria-label":o.name,"data-testid":`thing-${a+1}`},S("div",{class:"line spread"},S("span",{class:"line"},l,S("span",{class:"hint",text:y3[o.kind]}),o.kind==="frame"?null:yn(`What ${o.name} is`,[["object","object"],["obstacle","obstacle"]],o.role,d=>wf(a,{role:d},`make ${o.name} an ${d}`))),S("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${o.name}`,on:{click:()=>jg(E.world.filter((d,f)=>f!==a),`remove ${o.name}`)}})),u.length?S("div",{class:"line"},u):null,h.el)}ct(["world","units"],o=>o!=="python"&&s()),s()}};var S3=40,RS={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return E.sequence.postures},set postures(u){E.sequence.postures=u},get rate(){return E.sequence.rate}},e=S("thead"),i=S("tbody"),s=S("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=S("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:l}}),o=S("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let u=t.postures[1];if(u){xt("did",{label:"use the same times for all legs"});for(let h of t.postures.slice(2))h.seconds=u.seconds,h.hold=u.hold;c()}}}});n.append(S("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),S("div",{class:"scroll"},S("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),S("div",{class:"line"},S("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(E.q.slice())}}),S("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(E.table.postures??{}).forEach(([u,h])=>a(h.slice(),u))}}),o),S("div",{class:"line"},r),s);function a(u,h){t.postures.length>=S3||(xt("did",{label:"add a posture to the sequence"}),t.postures.push({name:h??`P${t.postures.length}`,q:u,seconds:5,hold:0}),c(),xt("sequence"))}function c(){let u=E.table.joints;t.postures=t.postures.filter(h=>h.q.length===u.length),r.disabled=t.postures.length<2,Zt(e,S("tr",{},S("th",{text:""}),u.map((h,d)=>S("th",{},S("i",{text:"q"}),S("sub",{text:String(d+1)}),S("span",{class:"unit",text:` ${mt.symbol(Xe(h))}`}))),S("th",{text:"leg, s"}),S("th",{text:"rest, s"}),S("th",{"aria-label":"row tools"}))),Zt(i,t.postures.map((h,d)=>{let f=u.map((y,p)=>{let m=Nn({label:`${h.name}, q${p+1}`,kind:Xe(y),testid:`seq-${d}-q${p+1}`,input:x=>{xt("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${p}`}),h.q[p]=x,xt("sequence")}});return m.put(h.q[p],String(Number((h.q[p]*mt.factor(Xe(y))).toFixed(mt.digits(Xe(y))))+0)),S("td",{},m)}),g=(y,p,m)=>{if(d===0)return S("td");let x=Nn({label:`${p} ${h.name}`,testid:`seq-${d}-${y}`,check:m,input:w=>{xt("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${y}`}),h[y]=w,xt("sequence")}});return x.put(h[y]),S("td",{},x)};return S("tr",{"data-testid":`seq-row-${d}`},S("th",{scope:"row"},S("button",{type:"button",class:"quiet",text:h.name,title:"Go there",on:{click:()=>wi(h.q.slice())}})),f,g("seconds","Seconds to",y=>y>0?null:"more than 0"),g("hold","Rest after",y=>y>=0?null:"0 or more"),S("td",{class:"tools"},S("button",{type:"button",class:"icon",text:"\u2191",disabled:d===0,"aria-label":`Move ${h.name} up`,on:{click:()=>{xt("did",{label:`move ${h.name} up`}),t.postures.splice(d-1,0,...t.postures.splice(d,1)),c()}}}),S("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>{xt("did",{label:`remove ${h.name}`}),t.postures.splice(d,1),c(),xt("sequence")}}})))})),t.postures.length||i.append(S("tr",{},S("td",{class:"hint",colspan:String(u.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function l(){s.hidden=!1;let u=Qo(n);if(u){s.dataset.tone="wrong",Et(s,u);return}r.disabled=!0;try{let h=t.postures,d=await En("motion",{postures:h.map(g=>g.q),seconds:h.slice(1).map(g=>g.seconds),holds:h.slice(1).map(g=>g.hold),rate:t.rate}),f=h.map((g,y)=>({x:d.arrivals[y],s:0,text:`${g.name} at ${d.arrivals[y].toFixed(2)} s`,short:g.name,stop:!1}));s.dataset.tone="good",Et(s,`${h.length} postures in ${d.t[d.t.length-1].toFixed(2)} s. ${M3(d.q)}`),hs(io({table:E.table,q:d.q,xs:d.t,xName:"time",seconds:d.t,dq:d.dq,events:f,title:`${E.table.name}: ${h.map(g=>g.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",Et(s,h.message)}finally{r.disabled=t.postures.length<2}}ct(["table","units","sequence-loaded"],c),c()}};function M3(n){let t=E.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var Ef=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ee(n)),Jg=new zr({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Ni=new xo(new Pe,Jg);Ni.frustumCulled=!1;Ni.visible=!1;zn.add(Ni);var al=null,Vc=null,Ui=0,so={lo:0,hi:1};function CS(n){al=new Float32Array(3*n),Vc=new Float32Array(n),Ui=0,Ni.geometry.dispose(),Ni.geometry=new Pe,Ni.geometry.setAttribute("position",new Ze(al,3)),Ni.geometry.setAttribute("color",new Ze(new Float32Array(3*n),3)),Ni.geometry.setDrawRange(0,0),Ni.visible=!0,Ie()}function PS(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Ui<Vc.length;i+=4,Ui++)al.set(e.subarray(i,i+3),3*Ui),Vc[Ui]=e[i+3];w3()}function w3(){let n=Vc.slice(0,Ui).sort();so.lo=n[Math.floor(Ui*.02)]??0,so.hi=n[Math.max(Math.ceil(Ui*.98)-1,0)]??1;let t=new ee,e=Ni.geometry.attributes.color.array,i=so.hi-so.lo||1;for(let s=0;s<Ui;s++){let r=Math.min(Math.max((Vc[s]-so.lo)/i,0),1)*(Ef.length-1),o=Math.min(Math.floor(r),Ef.length-2);t.lerpColors(Ef[o],Ef[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Ni.geometry.setDrawRange(0,Ui),Ni.geometry.attributes.position.needsUpdate=!0,Ni.geometry.attributes.color.needsUpdate=!0,Ie()}var Wc=()=>Ui;function IS(n){Xi.localClippingEnabled=n!==null,Jg.clippingPlanes=n===null?null:[new ei(new k(0,1,0),-n)],Jg.needsUpdate=!0,Ie()}function LS(){let n=new Pi;for(let i=0;i<Ui;i++)n.expandByPoint(new k(al[3*i],al[3*i+1],al[3*i+2]));let{min:t,max:e}=n;return Ui?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function DS(){Ui=0,Ni.visible=!1,Ie()}var US=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],Tf=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?Qn(n,4):n.toExponential(2).replace("-","\u2212"),FS={id:"analysis",title:"Analysis",build(n){let t=S("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,l,u]of e)t.append(S("div",{title:u},S("dt",{text:l}),i[c]=S("dd",{"data-testid":`fact-${c}`})));let s=S("div",{class:"distances","data-testid":"limit-distances"}),r=[];n.append(t,S("h3",{text:"Distance to the limits"}),s,S("h3",{text:"Reachable points"}),E3());let o=()=>{r=E.table.joints.map((c,l)=>{let u=S("span",{class:"bar-fill"}),h=S("span",{class:"bar-text"});return{el:S("div",{class:"distance"},S("span",{},S("i",{text:"q"}),S("sub",{text:String(l+1)})),S("span",{class:"bar"},u),h),fill:u,text:h}}),Zt(s,r.map(c=>c.el)),a()},a=Ir(()=>{if(n.closest(".panel").hidden||!E.table.joints.length)return;let c=eu(E.table,E.q,E.frames),l=c[0],u=c[c.length-1];Et(i.manipulability,Tf(c.reduce((h,d)=>h*d,1))),Et(i.condition,l>1e-9?Qn(u/l,1):"\u221E"),Et(i.least,Tf(l)),t.dataset.tone=l<.02?"wrong":"good",r.forEach(({el:h,fill:d,text:f},g)=>{let y=E.table.joints[g],p=E.q[g];if(y.lower===null||y.upper===null){d.style.setProperty("width","100%"),Et(f,"no limit");return}let m=Math.min(p-y.lower,y.upper-p),x=Math.max(2*m/(y.upper-y.lower||1),0);d.style.setProperty("width",`${100*x}%`),h.classList.toggle("outside",m<-1e-9),Et(f,m<-1e-9?`${We(-m,Xe(y))} beyond`:We(m,Xe(y)))})});ct("table",o),ct(["q","units","panel"],a),o()}};function E3(){let n="20000",t="manipulability",e=!1,i=S("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?gs("cancel",{kind:"cloud"}):d()}}),s=S("button",{type:"button",text:"Clear",on:{click:h}}),r=xn("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>IS(f==="half"?E.table.base[7]:null),"cloud-cut"),o=S("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=S("p",{class:"hint",role:"status","data-testid":"cloud-note"}),c=S("span"),l=S("span"),u=S("div",{class:"legend-scale",hidden:!0},c,S("span",{class:"scale-bar"}),l);function h(){DS(),yr("cloud",[]),u.hidden=!0,Et(a,"")}async function d(){e=!0,Et(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,CS(Number(n));try{let f=await En("cloud",{count:Number(n),colour:t,seed:1},g=>{PS(g.points),o.value=g.done/g.of,Et(c,Tf(so.lo)),Et(l,Tf(so.hi)),Et(a,`${g.done.toLocaleString("en")} of ${g.of.toLocaleString("en")} points`)});Et(a,f.stopped?`Cancelled after ${Wc().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${US.find(([g])=>g===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){Et(a,f.message)}e=!1,yr("cloud",LS()),Ac(),Et(i,"Draw the cloud"),o.hidden=!0}return ct("table",f=>{f!=="postures"&&f!=="name"&&Wc()&&h()}),S("div",{},S("div",{class:"line"},yn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),S("span",{class:"field-name",text:"coloured by"}),yn("Coloured by",US,t,f=>{t=f},{"data-testid":"cloud-colour"})),S("div",{class:"line"},i,s,r),o,u,a)}var OS=n=>({id:"share",title:"Share",build(t,e){let i=S("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=S("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=S("p",{class:"hint",role:"status","data-testid":"report-note"}),o=S("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:u}}),a=S("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(S("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),S("div",{class:"line share-link"},i,S("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>Lr(await Vd())}})),S("h3",{text:"As a file"}),S("div",{class:"line"},S("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>es(`${E.table.name||"arm"}.workbench.json`,JSON.stringify(Hd(),null,1),"application/json")}}),S("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,S("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:xf}})),S("h3",{text:"As Python"}),S("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,S("div",{class:"line"},S("button",{type:"button",text:"Copy the script","data-testid":"copy-python",on:{click:()=>Lr(a.value)}}),S("button",{type:"button",text:"Save the script",on:{click:()=>es("workbench.py",a.value,"text/x-python")}})),S("h3",{text:"Report"}),S("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),S("div",{class:"line"},o),r);let c=async()=>{!e.hidden&&E.table.joints.length&&(i.value=await Vd()),!e.hidden&&E.table.joints.length&&l()},l=Jo(async()=>{try{let{q:d,target:f,hasTarget:g,path:y,program:p}=E,{task:m,redundancy:x}=pe,w={q:d,target:g?f:null,path:y,task:m,redundancy:x,program:ol()};a.value=(await En("python",p.length?w:{...w,program:null})).text}catch(d){a.value=`# ${d.message}`}});ct(["panel","table","q","units","notation"],c);async function u(){o.disabled=!0;try{let{html:d,name:f}=await En("report",{q:E.q},g=>Et(r,g.note));es(f,d,"text/html"),Et(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){Et(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");Gd(JSON.parse(await f.text()),n()),vn("Opened")}catch(g){vn(g instanceof SyntaxError?`${f.name} is not a state file.`:g.message,"wrong")}}}});var T3=40,kS=!1,zS=0,Kg=!1,Af=null,BS=null;function HS(n){n&&(kS=!0,Af=E.table,GS(n))}function GS(n){Kg=!0,zS=n.said,n.table&&(un(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),Af=E.table),n.things&&A3(n.things),n.target&&(E.hasTarget=!0,pi(n.target,"restored")),n.q&&n.q.length===E.table.joints.length&&(xt("did",{label:"move from Python",key:"python"}),Ci(n.q,"python")),Kg=!1}function A3(n){E.things=n.filter(i=>i.kind!=="motion"),xt("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==BS){if(BS=e,!t){hs(null);return}hs(io({table:E.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${E.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var R3=Ko(T3,()=>{let n=E.table===Af?void 0:Vf(E.table);Af=E.table,E.table.joints.length&&gs("shown",{q:E.q,target:E.hasTarget?E.target:null,table:n,said:zS}).catch(()=>{})});function VS(){ct("push",GS),ct(["q","target","table"],()=>kS&&!Kg&&R3.soon())}var Oo=new Jn,qS=new bi({fog:!1}),Qg=new bi({fog:!1}),t0=new ss(1,1,1),e0=new bn(t0,qS),$S=[new bn(t0,Qg),new bn(t0,Qg)];Oo.add(e0,...$S);Oo.matrixAutoUpdate=!1;Oo.visible=!1;var qc=null;function XS(){zn.add(Oo),ct("q",()=>qc!==null&&ZS()),ct("theme",WS),WS()}function WS(){qS.color.set(ae.joint),Qg.color.set(ae.accent)}function n0(n){n===null&&qc===null||(qc=n,Oo.visible=n!==null,n!==null&&ZS(),Ie())}var YS=()=>qc;function ZS(){let n=E.frames.at(-1),t=.075*Ri(E.table);e0.scale.set(.35*t,1.1*t,.25*t),e0.position.set(0,0,-.85*t),$S.forEach((e,i)=>{let s=(.08+.36*(1-qc))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),Oo.matrix.set(...n),Oo.updateMatrixWorld(!0)}var Bo=new Jn,Rf=new za,I3=new be,L3=n=>new bi({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function i0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new Ze(e,3)),n}var jS=n=>n.rotateX(Math.PI/2),JS={box:n=>[i0(new ss(...n.size)),n.T],cylinder:n=>[i0(jS(new Wi(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new k(...n.a),e=new k(...n.b).sub(t),i=e.length(),s=new be().makeRotationFromQuaternion(new on().setFromUnitVectors(new k(0,0,1),i?e.clone().normalize():new k(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[i0(jS(new jl(n.r,i,12,28))),s.clone().transpose().elements.slice()]}},D3=()=>[...E.world,...E.things??[]];function N3(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=oe(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*ks(n.T,s)[o])))}function QS(){zn.add(Bo,Rf.group),ct(["world","table"],KS),ct("theme",()=>{Rf.paint(),KS()})}var $c=new Map;function s0(n,t){if(t)$c.set(n,t);else if(!$c.delete(n))return;let e=Bo.children.find(s=>s.userData.name===n),i=E.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),Ie()}var tM=n=>$c.get(n)??null;function eM(){for(let n of[...$c.keys()])s0(n,null)}function KS(){for(let t of Bo.children)t.geometry.dispose();Bo.clear();let n=D3();for(let t of n)if(t.kind==="curve"){let e=new Pe().setFromPoints(t.points.map(i=>new k(...i)));Bo.add(new kr(e,new bs({color:ae.trace,fog:!1})))}else if(JS[t.kind]){let[e,i]=JS[t.kind](t),s=new bn(e,L3(t.role==="object"?ae.accent:ae.ghost));s.matrixAutoUpdate=!1,s.matrix.copy(I3.set(...$c.get(t.name)??i)),s.userData.name=t.name,Bo.add(s)}Rf.show(n.filter(t=>t.kind==="frame"),.11*Ri(E.table)),yr("world",n.flatMap(N3)),Ie()}var nM=()=>Bo.children.length+(Rf.last?.[0].length??0);var F3=.25,r0=.5;function O3(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(E.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=z3(n,r);if(o>=r0&&!s){let c=[...e].map(([l,u])=>({name:l,T:u.at(-1).T,d:ts(Ai(oe(u.at(-1).T),oe(a)))})).filter(({name:l,d:u})=>u<B3(E.world.find(h=>h.name===l))).sort((l,u)=>l.d-u.d)[0];c&&(i=c.name,e.get(i).push({t:r,held:zi(Jc(a),c.T)}))}else o<r0&&s&&i&&(e.get(i).push({t:r,T:zi(a,e.get(i).at(-1).held)}),i=null);s=o>=r0}return{grips:t,objects:e}}var B3=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function k3(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var z3=(n,t)=>ms(n.table,n.q[k3(n.seconds,t)]).at(-1),ro=null,H3=n=>{let t=ro.grips.length?1-Math.round(ro.grips[0].value):0;for(let e of ro.grips){if(e.t>n)break;let i=Math.min((n-e.t)/F3,1);t+=i*(e.value-t)}return t};function iM(){ct("motion",()=>{eM(),ro=E.motion?.happens?O3(E.motion):null,ro||n0(null)}),ct("played",n=>{if(!ro)return;let t=E.frames.at(-1);ro.grips.length&&n0(H3(n));for(let[e,i]of ro.objects){let s=i.findLast(r=>r.t<=n)??i[0];s0(e,s.held?zi(t,s.held):s.T)}})}function sM(){window.workbench=Object.freeze({get q(){return E.q.slice()},get frames(){return structuredClone(E.frames)},get target(){return E.target.slice()},get table(){return structuredClone(E.table)},get solutions(){return structuredClone(E.solutions)},get camera(){return pd()},get pictures(){return ty()},get ghosts(){return jy()},get history(){return[Bd(),kd()]},get beyond(){return Xy()},get things(){return nM()},get program(){return structuredClone(E.program)},get motion(){return structuredClone(E.motion)},get gripper(){return YS()},placeOf:n=>tM(n)??E.world.find(t=>t.name===n)?.T??null,go:il,get framesDrawn(){return Yy()},get answers(){return Zm.answers},get trace(){return tv()},get cloud(){return Wc()},toScreen:Li,withPicture:n=>Qx(n),handles:()=>wy(),forward:(n,t)=>ms(n,t),convert:(n,t)=>gf(n,t),read:(n,t)=>af(n,t),present:(n,t,e)=>yf(n,t,e)})}ad();ey(Pr("#view"));ct("theme",Mm);Mm();ov();Vy();by();QS();XS();iM();VS();U0();iv();Jb(Pr("#bar"));Qb(Pr("#overlay"));jb(Pr("#dock"));tS();var o0;o0=Kb(Pr("#rail"),Pr("#panels"),Pr("#pinned"),[{id:"move",title:"Move",sections:[qb,nS]},hS,gS,iS,xS,yS,TS,AS,RS,FS,OS(()=>o0)]);pv();var V3=dv().then(n=>n&&Gd(n,o0)).catch(n=>vn(`The link could not be read: ${n.message}`,"wrong"));ct("online",async n=>{if(!n)return;await V3;let t=await I0();E.catalog=t.catalog,xt("catalog"),t.table&&(!E.table.joints.length||t.bench)&&(un(t.table,{q:jo(t.table),step:!1,what:"new"}),zd()),HS(t.bench),document.documentElement.dataset.ready="yes"});E.online&&xt("online",!0);document.fonts?.ready.then(()=>xt("theme"));sM();
