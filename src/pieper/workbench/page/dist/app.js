import{A as M,B as Ii,C as hu,D as Qo,E as hn,F as Z0,G as xi,H as j0,I as du,K as Vi,L as Or,a as rr,b as ei,c as ou,d as ne,e as zs,f as Sl,g as Pi,h as Ml,i as au,j as ss,k as lu,l as cu,m as V0,n as W0,o as or,p as ar,q as q0,r as _s,s as Zf,t as $0,u as oi,v as uu,w as X0,x as Y0,y as st,z as ft}from"./chunk-2MW7ZYWX.js";function b(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))if(!(r==null||r===!1))if(s==="text")i.textContent=r;else if(s==="on")for(let[o,a]of Object.entries(r))i.addEventListener(o,a);else s==="value"?i.value=r:s==="checked"||s==="disabled"||s==="hidden"?i[s]=r:i.setAttribute(s,r===!0?"":r);return i.append(...e.flat().filter(s=>s!=null&&s!==!1)),i}var Hs=(n,t=document)=>t.querySelector(n),Yt=(n,...t)=>n.replaceChildren(...t.flat().filter(Boolean));function yt(n,t){n.textContent!==t&&(n.textContent=t)}function mn(n,t,e,i,s){let r=b("div",{class:"choice",role:"group","aria-label":n,"data-testid":s}),o=a=>{for(let l of r.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))};for(let[a,l]of t)r.append(b("button",{type:"button",text:l,"data-value":a,on:{click:()=>{o(a),i(a)}}}));return o(e),r.mark=o,r}function Mn(n,t,e,i,s={}){let r=b("select",{"aria-label":n,...s,on:{change:()=>i(r.value)}},t.map(([o,a])=>b("option",{value:o,text:a})));return r.value=e,r}function Br(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function ta(n,t){let e=null,i=-1/0,s=()=>{clearTimeout(e),e=null,i=performance.now(),t()};return s.soon=()=>{let r=i+n-performance.now();r<=0?s():e??=setTimeout(s,r)},s}function Gs(n,t){let e,i=(...s)=>{clearTimeout(e),e=setTimeout(()=>n(...s),t)};return i.cancel=()=>clearTimeout(e),i}function yi(n,t,e="text/plain"){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e})),s=b("a",{href:i,download:n});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}async function kr(n){try{await navigator.clipboard.writeText(n)}catch{let t=b("textarea",{class:"offscreen"});t.value=n,document.body.append(t),t.select(),document.execCommand("copy"),t.remove()}Xe("Copied")}var J0;function Xe(n,t="plain"){let e=document.getElementById("remark");e.textContent=n,e.dataset.tone=t,e.classList.add("shown"),clearTimeout(J0),J0=setTimeout(()=>e.classList.remove("shown"),t==="wrong"?8e3:2500)}function ea(n){let t=[...n.querySelectorAll(".number.wrong")].find(e=>!e.closest("[hidden]"));return t?(t.focus(),`${t.getAttribute("aria-label")} cannot be read (${t.title}). Nothing was computed.`):null}var na=0,Kf=-1,jf=[];function Qf(n){return{...n,joints:n.joints.map(({text:t,...e})=>e)}}async function Jf(){let n=na;if(!M.table.joints.length){M.plan={solvable:!1,explain:"The table is empty: add a joint.",max_solutions:0},ft("plan");return}try{let{plan:t}=await Vi("arm",{table:Qf(M.table)});if(n!==na)return;Kf=n,M.plan=t,K0()}catch(t){if(n!==na||t instanceof du)return;M.plan={solvable:!1,refused:!0,explain:t.message,max_solutions:0},K0(t)}ft("plan")}function K0(n){let t=jf;jf=[];for(let{resolve:e,reject:i}of t)n?i(n):e()}var Q0=Gs(Jf,60);function t_(){st("table",n=>{na+=1,n==="postures"&&(Kf=-1),n==="cell"?Q0():(Q0.cancel(),Jf())}),st("online",n=>{n&&(na+=1,Jf())})}function JM(){return Kf===na?Promise.resolve():new Promise((n,t)=>jf.push({resolve:n,reject:t}))}async function dn(n,t,e){return await JM(),Vi(n,t,e)}function e_(n){if(!n)return"";let t=n.explain.split(`
`).map(s=>s.trim()),e=t.find(s=>s.startsWith("Solved by:")),i=(e??t.filter(Boolean)[0]??"").replace(/\s+/g," ");return e||i.length<200?i:`${i.slice(0,200)} \u2026`}function fu(n){if(!n?.solvable)return"";let t=n.max_solutions;return t==null?"":t===1?"One solution":`Up to ${t} solutions`}var Zr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},jr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},O_=0,Cp=1,B_=2;var uc=1,k_=2,Na=3,Jr=0,Ti=1,Di=2,Mo=0,Ua=1,Pp=2,Ip=3,Lp=4,z_=5;var wo=100,H_=101,G_=102,V_=103,W_=104,q_=200,$_=201,X_=202,Y_=203,Dp=204,Np=205,Z_=206,j_=207,J_=208,K_=209,Q_=210,tx=211,ex=212,nx=213,ix=214,Wu=0,qu=1,$u=2,Sa=3,Xu=4,Yu=5,Zu=6,ju=7,Up=0,sx=1,rx=2,Zs=0,Fp=1,Op=2,Bp=3,kp=4,zp=5,Hp=6,Gp=7;var Vp=300,Eo=301,Fa=302,Sh=303,Mh=304,Ju=1e3,Ws=1001,Ku=1002,Kn=1003,ox=1004;var hc=1005;var Mi=1006,wh=1007;var vr=1008;var ji=1009,Wp=1010,qp=1011,Oa=1012,Eh=1013,Ss=1014,cs=1015,Ms=1016,Th=1017,Ah=1018,To=1020,$p=35902,Xp=35899,Yp=1021,Zp=1022,ws=1023,mr=1026,br=1027,Rh=1028,Ch=1029,Kr=1030,Ph=1031;var Ih=1033,dc=33776,fc=33777,pc=33778,mc=33779,Lh=35840,Dh=35841,Nh=35842,Uh=35843,Fh=36196,Oh=37492,Bh=37496,kh=37488,zh=37489,gc=37490,Hh=37491,Gh=37808,Vh=37809,Wh=37810,qh=37811,$h=37812,Xh=37813,Yh=37814,Zh=37815,jh=37816,Jh=37817,Kh=37818,Qh=37819,td=37820,ed=37821,nd=36492,id=36494,sd=36495,rd=36283,od=36284,_c=36285,ad=36286;var Ol=2300,Qu=2301,Gu=2302,bp=2303,Sp=2400,Mp=2401,wp=2402;var ax=3200;var jp=0,lx=1,Sr="",bi="srgb",Bl="srgb-linear",kl="linear",ke="srgb";var Vu=7680,Jp=7681;var Kp=517;var cx=519,ux=512,hx=513,dx=514,Qp=515,fx=516,px=517,tm=518,em=519,nm=35044,ld=35048;var im="300 es",os=2e3,zl=2001;function QM(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function tw(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Hl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function mx(){let n=Hl("canvas");return n.style.display="block",n}var n_={},Ma=null;function Gl(...n){let t="THREE."+n.shift();Ma?Ma("log",t,...n):console.log(t,...n)}function gx(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function te(...n){n=gx(n);let t="THREE."+n.shift();if(Ma)Ma("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function re(...n){n=gx(n);let t="THREE."+n.shift();if(Ma)Ma("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Nl(...n){let t=n.join(" ");t in n_||(n_[t]=!0,te(...n))}function _x(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var xx={[Wu]:Wu,[$u]:Zu,[Xu]:Xu,[Sa]:Yu,[qu]:qu,[Zu]:$u,[ju]:ju,[Yu]:Sa},bs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},ai=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],i_=1234567,Ul=Math.PI/180,wa=180/Math.PI;function Qr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ai[n&255]+ai[n>>8&255]+ai[n>>16&255]+ai[n>>24&255]+"-"+ai[t&255]+ai[t>>8&255]+"-"+ai[t>>16&15|64]+ai[t>>24&255]+"-"+ai[e&63|128]+ai[e>>8&255]+"-"+ai[e>>16&255]+ai[e>>24&255]+ai[i&255]+ai[i>>8&255]+ai[i>>16&255]+ai[i>>24&255]).toLowerCase()}function be(n,t,e){return Math.max(t,Math.min(e,n))}function sm(n,t){return(n%t+t)%t}function ew(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function nw(n,t,e){return n!==t?(e-n)/(t-n):0}function Fl(n,t,e){return(1-e)*n+e*t}function iw(n,t,e,i){return Fl(n,t,1-Math.exp(-e*i))}function sw(n,t=1){return t-Math.abs(sm(n,t*2)-t)}function rw(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function ow(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function aw(n,t){return n+Math.floor(Math.random()*(t-n+1))}function lw(n,t){return n+Math.random()*(t-n)}function cw(n){return n*(.5-Math.random())}function uw(n){n!==void 0&&(i_=n);let t=i_+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function hw(n){return n*Ul}function dw(n){return n*wa}function fw(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function pw(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function rm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function mw(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*g,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*g,a*c);break;case"ZYZ":n.set(l*g,l*f,a*u,a*c);break;default:te("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function cd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function om(n,t){if(t.constructor===Float32Array)return n;let e=cd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function am(n,t){if(t.constructor===Float32Array)return n;let e=cd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var to={DEG2RAD:Ul,RAD2DEG:wa,generateUUID:Qr,clamp:be,euclideanModulo:sm,mapLinear:ew,inverseLerp:nw,lerp:Fl,damp:iw,pingpong:sw,smoothstep:rw,smootherstep:ow,randInt:aw,randFloat:lw,randFloatSpread:cw,seededRandom:uw,degToRad:hw,radToDeg:dw,isPowerOfTwo:fw,ceilPowerOfTwo:pw,floorPowerOfTwo:rm,setQuaternionFromProperEuler:mw,normalize:am,denormalize:om},qt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=be(this.x,t.x,e.x),this.y=be(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=be(this.x,t,e),this.y=be(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(be(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(be(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},an=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==g){let p=l*d+c*f+u*g+h*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let x=Math.acos(p),E=Math.sin(x);m=Math.sin(m*x)/E,a=Math.sin(a*x)/E,l=l*m+d*a,c=c*m+f*a,u=u*m+g*a,h=h*m+y*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+g*a,h=h*m+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*f-c*d,t[e+1]=l*g+u*d+c*h-a*f,t[e+2]=c*g+u*f+a*d-l*h,t[e+3]=u*g-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:te("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(be(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},k=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(s_.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(s_.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=be(this.x,t.x,e.x),this.y=be(this.y,t.y,e.y),this.z=be(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=be(this.x,t,e),this.y=be(this.y,t,e),this.z=be(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(be(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return tp.copy(this).projectOnVector(t),this.sub(tp)}reflect(t){return this.sub(tp.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(be(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},tp=new k,s_=new an,ce=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],g=i[8],y=s[0],p=s[3],m=s[6],x=s[1],E=s[4],v=s[7],A=s[2],T=s[5],_=s[8];return r[0]=o*y+a*x+l*A,r[3]=o*p+a*E+l*T,r[6]=o*m+a*v+l*_,r[1]=c*y+u*x+h*A,r[4]=c*p+u*E+h*T,r[7]=c*m+u*v+h*_,r[2]=d*y+f*x+g*A,r[5]=d*p+f*E+g*T,r[8]=d*m+f*v+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=e*h+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=h*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Nl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ep.makeScale(t,e)),this}rotate(t){return Nl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ep.makeRotation(-t)),this}translate(t,e){return Nl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ep.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ep=new ce,r_=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),o_=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function gw(){let n={enabled:!0,workingColorSpace:Bl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ke&&(s.r=pr(s.r),s.g=pr(s.g),s.b=pr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ke&&(s.r=ba(s.r),s.g=ba(s.g),s.b=ba(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Sr?kl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Bl]:{primaries:t,whitePoint:i,transfer:kl,toXYZ:r_,fromXYZ:o_,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:t,whitePoint:i,transfer:ke,toXYZ:r_,fromXYZ:o_,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),n}var Ce=gw();function pr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ba(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ia,th=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ia===void 0&&(ia=Hl("canvas")),ia.width=t.width,ia.height=t.height;let s=ia.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=ia}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Hl("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=pr(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(pr(e[i]/255)*255):e[i]=pr(e[i]);return{data:e,width:t.width,height:t.height}}else return te("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},_w=0,Ea=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:_w++}),this.uuid=Qr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(np(s[o].image)):r.push(np(s[o]))}else r=np(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function np(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?th.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(te("Texture: Unable to serialize Texture."),{})}var xw=0,ip=new k,wi=class n extends bs{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ws,s=Ws,r=Mi,o=vr,a=ws,l=ji,c=n.DEFAULT_ANISOTROPY,u=Sr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:xw++}),this.uuid=Qr(),this.name="",this.source=new Ea(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new qt(0,0),this.repeat=new qt(1,1),this.center=new qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ip).x}get height(){return this.source.getSize(ip).y}get depth(){return this.source.getSize(ip).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){te(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Vp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ju:t.x=t.x-Math.floor(t.x);break;case Ws:t.x=t.x<0?0:1;break;case Ku:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ju:t.y=t.y-Math.floor(t.y);break;case Ws:t.y=t.y<0?0:1;break;case Ku:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};wi.DEFAULT_IMAGE=null;wi.DEFAULT_MAPPING=Vp;wi.DEFAULT_ANISOTROPY=1;var gn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,v=(f+1)/2,A=(m+1)/2,T=(u+d)/4,_=(h+y)/4,S=(g+p)/4;return E>v&&E>A?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=T/i,r=_/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=T/s,r=S/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=S/r),this.set(i,s,r,e),this}let x=Math.sqrt((p-g)*(p-g)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(h-y)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=be(this.x,t.x,e.x),this.y=be(this.y,t.y,e.y),this.z=be(this.z,t.z,e.z),this.w=be(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=be(this.x,t,e),this.y=be(this.y,t,e),this.z=be(this.z,t,e),this.w=be(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(be(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},eh=class extends bs{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Mi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new gn(0,0,t,e),this.scissorTest=!1,this.viewport=new gn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new wi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Mi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ea(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},$i=class extends eh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Vl=class extends wi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Kn,this.minFilter=Kn,this.wrapR=Ws,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var nh=class extends wi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Kn,this.minFilter=Kn,this.wrapR=Ws,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ge=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,g,y,p)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,g,y,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/sa.setFromMatrixColumn(t,0).length(),r=1/sa.setFromMatrixColumn(t,1).length(),o=1/sa.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,g=a*u,y=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+g*c,e[5]=d-y*c,e[9]=-a*l,e[2]=y-d*c,e[6]=g+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,g=c*u,y=c*h;e[0]=d+y*a,e[4]=g*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-g,e[6]=y+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,g=c*u,y=c*h;e[0]=d-y*a,e[4]=-o*h,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*u,e[9]=y-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,g=a*u,y=a*h;e[0]=l*u,e[4]=g*c-f,e[8]=d*c+y,e[1]=l*h,e[5]=y*c+d,e[9]=f*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;e[0]=l*u,e[4]=y-d*h,e[8]=g*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+g,e[10]=d-y*h}else if(t.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+y,e[5]=o*u,e[9]=f*h-g,e[2]=g*h-f,e[6]=a*u,e[10]=y*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(yw,t,vw)}lookAt(t,e,i){let s=this.elements;return Wi.subVectors(t,e),Wi.lengthSq()===0&&(Wi.z=1),Wi.normalize(),zr.crossVectors(i,Wi),zr.lengthSq()===0&&(Math.abs(i.z)===1?Wi.x+=1e-4:Wi.z+=1e-4,Wi.normalize(),zr.crossVectors(i,Wi)),zr.normalize(),pu.crossVectors(Wi,zr),s[0]=zr.x,s[4]=pu.x,s[8]=Wi.x,s[1]=zr.y,s[5]=pu.y,s[9]=Wi.y,s[2]=zr.z,s[6]=pu.z,s[10]=Wi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],g=i[2],y=i[6],p=i[10],m=i[14],x=i[3],E=i[7],v=i[11],A=i[15],T=s[0],_=s[4],S=s[8],L=s[12],I=s[1],D=s[5],B=s[9],V=s[13],O=s[2],$=s[6],Z=s[10],q=s[14],ht=s[3],K=s[7],tt=s[11],ot=s[15];return r[0]=o*T+a*I+l*O+c*ht,r[4]=o*_+a*D+l*$+c*K,r[8]=o*S+a*B+l*Z+c*tt,r[12]=o*L+a*V+l*q+c*ot,r[1]=u*T+h*I+d*O+f*ht,r[5]=u*_+h*D+d*$+f*K,r[9]=u*S+h*B+d*Z+f*tt,r[13]=u*L+h*V+d*q+f*ot,r[2]=g*T+y*I+p*O+m*ht,r[6]=g*_+y*D+p*$+m*K,r[10]=g*S+y*B+p*Z+m*tt,r[14]=g*L+y*V+p*q+m*ot,r[3]=x*T+E*I+v*O+A*ht,r[7]=x*_+E*D+v*$+A*K,r[11]=x*S+E*B+v*Z+A*tt,r[15]=x*L+E*V+v*q+A*ot,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],g=t[3],y=t[7],p=t[11],m=t[15],x=l*f-c*d,E=a*f-c*h,v=a*d-l*h,A=o*f-c*u,T=o*d-l*u,_=o*h-a*u;return e*(y*x-p*E+m*v)-i*(g*x-p*A+m*T)+s*(g*E-y*A+m*_)-r*(g*v-y*T+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],g=t[12],y=t[13],p=t[14],m=t[15],x=e*a-i*o,E=e*l-s*o,v=e*c-r*o,A=i*l-s*a,T=i*c-r*a,_=s*c-r*l,S=u*y-h*g,L=u*p-d*g,I=u*m-f*g,D=h*p-d*y,B=h*m-f*y,V=d*m-f*p,O=x*V-E*B+v*D+A*I-T*L+_*S;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let $=1/O;return t[0]=(a*V-l*B+c*D)*$,t[1]=(s*B-i*V-r*D)*$,t[2]=(y*_-p*T+m*A)*$,t[3]=(d*T-h*_-f*A)*$,t[4]=(l*I-o*V-c*L)*$,t[5]=(e*V-s*I+r*L)*$,t[6]=(p*v-g*_-m*E)*$,t[7]=(u*_-d*v+f*E)*$,t[8]=(o*B-a*I+c*S)*$,t[9]=(i*I-e*B-r*S)*$,t[10]=(g*T-y*v+m*x)*$,t[11]=(h*v-u*T-f*x)*$,t[12]=(a*L-o*D-l*S)*$,t[13]=(e*D-i*L+s*S)*$,t[14]=(y*E-g*A-p*x)*$,t[15]=(u*A-h*E+d*x)*$,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,y=o*u,p=o*h,m=a*h,x=l*c,E=l*u,v=l*h,A=i.x,T=i.y,_=i.z;return s[0]=(1-(y+m))*A,s[1]=(f+v)*A,s[2]=(g-E)*A,s[3]=0,s[4]=(f-v)*T,s[5]=(1-(d+m))*T,s[6]=(p+x)*T,s[7]=0,s[8]=(g+E)*_,s[9]=(p-x)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=sa.set(s[0],s[1],s[2]).length(),a=sa.set(s[4],s[5],s[6]).length(),l=sa.set(s[8],s[9],s[10]).length();r<0&&(o=-o),xs.copy(this);let c=1/o,u=1/a,h=1/l;return xs.elements[0]*=c,xs.elements[1]*=c,xs.elements[2]*=c,xs.elements[4]*=u,xs.elements[5]*=u,xs.elements[6]*=u,xs.elements[8]*=h,xs.elements[9]*=h,xs.elements[10]*=h,e.setFromRotationMatrix(xs),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=os,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===os)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===zl)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=os,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===os)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===zl)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},sa=new k,xs=new ge,yw=new k(0,0,0),vw=new k(1,1,1),zr=new k,pu=new k,Wi=new k,a_=new ge,l_=new an,qr=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(be(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-be(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(be(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-be(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(be(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-be(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:te("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return a_.makeRotationFromQuaternion(t),this.setFromRotationMatrix(a_,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return l_.setFromEuler(this),this.setFromQuaternion(l_,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};qr.DEFAULT_ORDER="XYZ";var Ta=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},bw=0,c_=new k,ra=new an,lr=new ge,mu=new k,wl=new k,Sw=new k,Mw=new an,u_=new k(1,0,0),h_=new k(0,1,0),d_=new k(0,0,1),f_={type:"added"},ww={type:"removed"},oa={type:"childadded",child:null},sp={type:"childremoved",child:null},Ei=class n extends bs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:bw++}),this.uuid=Qr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new k,e=new qr,i=new an,s=new k(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new ce}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ta,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ra.setFromAxisAngle(t,e),this.quaternion.multiply(ra),this}rotateOnWorldAxis(t,e){return ra.setFromAxisAngle(t,e),this.quaternion.premultiply(ra),this}rotateX(t){return this.rotateOnAxis(u_,t)}rotateY(t){return this.rotateOnAxis(h_,t)}rotateZ(t){return this.rotateOnAxis(d_,t)}translateOnAxis(t,e){return c_.copy(t).applyQuaternion(this.quaternion),this.position.add(c_.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(u_,t)}translateY(t){return this.translateOnAxis(h_,t)}translateZ(t){return this.translateOnAxis(d_,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(lr.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?mu.copy(t):mu.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),wl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?lr.lookAt(wl,mu,this.up):lr.lookAt(mu,wl,this.up),this.quaternion.setFromRotationMatrix(lr),s&&(lr.extractRotation(s.matrixWorld),ra.setFromRotationMatrix(lr),this.quaternion.premultiply(ra.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(f_),oa.child=t,this.dispatchEvent(oa),oa.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(ww),sp.child=t,this.dispatchEvent(sp),sp.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),lr.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),lr.multiply(t.parent.matrixWorld)),t.applyMatrix4(lr),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(f_),oa.child=t,this.dispatchEvent(oa),oa.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wl,t,Sw),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wl,Mw,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ei.DEFAULT_UP=new k(0,1,0);Ei.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ei.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Nn=class extends Ei{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ew={type:"move"},Aa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Nn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Nn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Nn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,i),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ew)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Nn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},yx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Hr={h:0,s:0,l:0},gu={h:0,s:0,l:0};function rp(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ie=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=bi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ce.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Ce.workingColorSpace){return this.r=t,this.g=e,this.b=i,Ce.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Ce.workingColorSpace){if(t=sm(t,1),e=be(e,0,1),i=be(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=rp(o,r,t+1/3),this.g=rp(o,r,t),this.b=rp(o,r,t-1/3)}return Ce.colorSpaceToWorking(this,s),this}setStyle(t,e=bi){function i(r){r!==void 0&&parseFloat(r)<1&&te("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:te("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);te("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=bi){let i=yx[t.toLowerCase()];return i!==void 0?this.setHex(i,e):te("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=pr(t.r),this.g=pr(t.g),this.b=pr(t.b),this}copyLinearToSRGB(t){return this.r=ba(t.r),this.g=ba(t.g),this.b=ba(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=bi){return Ce.workingToColorSpace(li.copy(this),t),Math.round(be(li.r*255,0,255))*65536+Math.round(be(li.g*255,0,255))*256+Math.round(be(li.b*255,0,255))}getHexString(t=bi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ce.workingColorSpace){Ce.workingToColorSpace(li.copy(this),e);let i=li.r,s=li.g,r=li.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Ce.workingColorSpace){return Ce.workingToColorSpace(li.copy(this),e),t.r=li.r,t.g=li.g,t.b=li.b,t}getStyle(t=bi){Ce.workingToColorSpace(li.copy(this),t);let e=li.r,i=li.g,s=li.b;return t!==bi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Hr),this.setHSL(Hr.h+t,Hr.s+e,Hr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Hr),t.getHSL(gu);let i=Fl(Hr.h,gu.h,e),s=Fl(Hr.s,gu.s,e),r=Fl(Hr.l,gu.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},li=new ie;ie.NAMES=yx;var Wl=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ie(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},ql=class extends Ei{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new qr,this.environmentIntensity=1,this.environmentRotation=new qr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},ys=new k,cr=new k,op=new k,ur=new k,aa=new k,la=new k,p_=new k,ap=new k,lp=new k,cp=new k,up=new gn,hp=new gn,dp=new gn,fr=class n{constructor(t=new k,e=new k,i=new k){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),ys.subVectors(t,e),s.cross(ys);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){ys.subVectors(s,e),cr.subVectors(i,e),op.subVectors(t,e);let o=ys.dot(ys),a=ys.dot(cr),l=ys.dot(op),c=cr.dot(cr),u=cr.dot(op),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ur)===null?!1:ur.x>=0&&ur.y>=0&&ur.x+ur.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ur)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ur.x),l.addScaledVector(o,ur.y),l.addScaledVector(a,ur.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return up.setScalar(0),hp.setScalar(0),dp.setScalar(0),up.fromBufferAttribute(t,e),hp.fromBufferAttribute(t,i),dp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(up,r.x),o.addScaledVector(hp,r.y),o.addScaledVector(dp,r.z),o}static isFrontFacing(t,e,i,s){return ys.subVectors(i,e),cr.subVectors(t,e),ys.cross(cr).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return ys.subVectors(this.c,this.b),cr.subVectors(this.a,this.b),ys.cross(cr).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;aa.subVectors(s,i),la.subVectors(r,i),ap.subVectors(t,i);let l=aa.dot(ap),c=la.dot(ap);if(l<=0&&c<=0)return e.copy(i);lp.subVectors(t,s);let u=aa.dot(lp),h=la.dot(lp);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(aa,o);cp.subVectors(t,r);let f=aa.dot(cp),g=la.dot(cp);if(g>=0&&f<=g)return e.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(la,a);let p=u*g-f*h;if(p<=0&&h-u>=0&&f-g>=0)return p_.subVectors(r,s),a=(h-u)/(h-u+(f-g)),e.copy(s).addScaledVector(p_,a);let m=1/(p+y+d);return o=y*m,a=d*m,e.copy(i).addScaledVector(aa,o).addScaledVector(la,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Li=class{constructor(t=new k(1/0,1/0,1/0),e=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(vs.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(vs.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=vs.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,vs):vs.fromBufferAttribute(r,o),vs.applyMatrix4(t.matrixWorld),this.expandByPoint(vs);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),_u.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),_u.copy(i.boundingBox)),_u.applyMatrix4(t.matrixWorld),this.union(_u)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,vs),vs.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(El),xu.subVectors(this.max,El),ca.subVectors(t.a,El),ua.subVectors(t.b,El),ha.subVectors(t.c,El),Gr.subVectors(ua,ca),Vr.subVectors(ha,ua),go.subVectors(ca,ha);let e=[0,-Gr.z,Gr.y,0,-Vr.z,Vr.y,0,-go.z,go.y,Gr.z,0,-Gr.x,Vr.z,0,-Vr.x,go.z,0,-go.x,-Gr.y,Gr.x,0,-Vr.y,Vr.x,0,-go.y,go.x,0];return!fp(e,ca,ua,ha,xu)||(e=[1,0,0,0,1,0,0,0,1],!fp(e,ca,ua,ha,xu))?!1:(yu.crossVectors(Gr,Vr),e=[yu.x,yu.y,yu.z],fp(e,ca,ua,ha,xu))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,vs).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(vs).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(hr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),hr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),hr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),hr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),hr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),hr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),hr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),hr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(hr),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},hr=[new k,new k,new k,new k,new k,new k,new k,new k],vs=new k,_u=new Li,ca=new k,ua=new k,ha=new k,Gr=new k,Vr=new k,go=new k,El=new k,xu=new k,yu=new k,_o=new k;function fp(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){_o.fromArray(n,r);let a=s.x*Math.abs(_o.x)+s.y*Math.abs(_o.y)+s.z*Math.abs(_o.z),l=t.dot(_o),c=e.dot(_o),u=i.dot(_o);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Dn=new k,vu=new qt,Tw=0,je=class extends bs{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Tw++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=nm,this.updateRanges=[],this.gpuType=cs,this.version=0,this._normalizationScale=t!==void 0?cd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)vu.fromBufferAttribute(this,e),vu.applyMatrix3(t),this.setXY(e,vu.x,vu.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Dn.fromBufferAttribute(this,e),Dn.applyMatrix3(t),this.setXYZ(e,Dn.x,Dn.y,Dn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Dn.fromBufferAttribute(this,e),Dn.applyMatrix4(t),this.setXYZ(e,Dn.x,Dn.y,Dn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Dn.fromBufferAttribute(this,e),Dn.applyNormalMatrix(t),this.setXYZ(e,Dn.x,Dn.y,Dn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Dn.fromBufferAttribute(this,e),Dn.transformDirection(t),this.setXYZ(e,Dn.x,Dn.y,Dn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):om(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):am(t,this.array)}};var $l=class extends je{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Xl=class extends je{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Pe=class extends je{constructor(t,e,i){super(new Float32Array(t),e,i)}},Aw=new Li,Tl=new k,pp=new k,qs=class{constructor(t=new k,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Aw.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Tl.subVectors(t,this.center);let e=Tl.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Tl,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(pp.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Tl.copy(t.center).add(pp)),this.expandByPoint(Tl.copy(t.center).sub(pp))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Rw=0,rs=new ge,mp=new Ei,da=new k,qi=new Li,Al=new Li,Jn=new k,Ae=class n extends bs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Rw++}),this.uuid=Qr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(QM(t)?Xl:$l)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ce().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return rs.makeRotationFromQuaternion(t),this.applyMatrix4(rs),this}rotateX(t){return rs.makeRotationX(t),this.applyMatrix4(rs),this}rotateY(t){return rs.makeRotationY(t),this.applyMatrix4(rs),this}rotateZ(t){return rs.makeRotationZ(t),this.applyMatrix4(rs),this}translate(t,e,i){return rs.makeTranslation(t,e,i),this.applyMatrix4(rs),this}scale(t,e,i){return rs.makeScale(t,e,i),this.applyMatrix4(rs),this}lookAt(t){return mp.lookAt(t),mp.updateMatrix(),this.applyMatrix4(mp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(da).negate(),this.translate(da.x,da.y,da.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Pe(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&te("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Li);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];qi.setFromBufferAttribute(r),this.morphTargetsRelative?(Jn.addVectors(this.boundingBox.min,qi.min),this.boundingBox.expandByPoint(Jn),Jn.addVectors(this.boundingBox.max,qi.max),this.boundingBox.expandByPoint(Jn)):(this.boundingBox.expandByPoint(qi.min),this.boundingBox.expandByPoint(qi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new qs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(t){let i=this.boundingSphere.center;if(qi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Al.setFromBufferAttribute(a),this.morphTargetsRelative?(Jn.addVectors(qi.min,Al.min),qi.expandByPoint(Jn),Jn.addVectors(qi.max,Al.max),qi.expandByPoint(Jn)):(qi.expandByPoint(Al.min),qi.expandByPoint(Al.max))}qi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Jn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Jn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Jn.fromBufferAttribute(a,c),l&&(da.fromBufferAttribute(t,c),Jn.add(da)),s=Math.max(s,i.distanceToSquared(Jn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new je(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new k,l[L]=new k;let u=new k,h=new k,d=new k,f=new qt,g=new qt,y=new qt,p=new k,m=new k;function x(L,I,D){c[L]=c[I]=c[D]=1,u.fromBufferAttribute(i,L),h.fromBufferAttribute(i,I),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,L),g.fromBufferAttribute(r,I),y.fromBufferAttribute(r,D),h.sub(u),d.sub(u),g.sub(f),y.sub(f);let B=1/(g.x*y.y-y.x*g.y);isFinite(B)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(B),m.copy(d).multiplyScalar(g.x).addScaledVector(h,-y.x).multiplyScalar(B),a[L].add(p),a[I].add(p),a[D].add(p),l[L].add(m),l[I].add(m),l[D].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let L=0,I=E.length;L<I;++L){let D=E[L],B=D.start,V=D.count;for(let O=B,$=B+V;O<$;O+=3)x(t.getX(O+0),t.getX(O+1),t.getX(O+2))}let v=new k,A=new k,T=new k,_=new k;function S(L){T.fromBufferAttribute(s,L),_.copy(T);let I=a[L];v.copy(I),v.sub(T.multiplyScalar(T.dot(I))).normalize(),A.crossVectors(_,I);let B=A.dot(l[L])<0?-1:1;o.setXYZW(L,v.x,v.y,v.z,B)}for(let L=0,I=i.count;L<I;++L)c[L]&&S(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new je(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new k,r=new k,o=new k,a=new k,l=new k,c=new k,u=new k,h=new k;if(t)for(let d=0,f=t.count;d<f;d+=3){let g=t.getX(d+0),y=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Jn.fromBufferAttribute(t,e),Jn.normalize(),t.setXYZ(e,Jn.x,Jn.y,Jn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let m=0;m<u;m++)d[g++]=c[f++]}return new je(d,u,h)}if(this.index===null)return te("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Yl=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=nm,this.updateRanges=[],this.version=0,this.uuid=Qr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=m_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=m_(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function m_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Qr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var vi=new k,Ra=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?cd(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)vi.fromBufferAttribute(this,e),vi.applyMatrix4(t),this.setXYZ(e,vi.x,vi.y,vi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)vi.fromBufferAttribute(this,e),vi.applyNormalMatrix(t),this.setXYZ(e,vi.x,vi.y,vi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)vi.fromBufferAttribute(this,e),vi.transformDirection(t),this.setXYZ(e,vi.x,vi.y,vi.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Gl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new je(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Gl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):om(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):am(t,this.data.array)}},gp=new k,Cw=new k,Pw=new ce,ni=class{constructor(t=new k(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=gp.subVectors(i,e).cross(Cw.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(gp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Pw.getNormalMatrix(t),s=this.coplanarPoint(gp).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Iw=0,$s=class extends bs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Iw++}),this.uuid=Qr(),this.name="",this.type="Material",this.blending=Ua,this.side=Jr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Dp,this.blendDst=Np,this.blendEquation=wo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ie(0,0,0),this.blendAlpha=0,this.depthFunc=Sa,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=cx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Vu,this.stencilZFail=Vu,this.stencilZPass=Vu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){te(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ie().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ni().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new qt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Ca=class extends $s{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ie(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},fa,Rl=new k,pa=new k,ma=new k,ga=new qt,Cl=new qt,vx=new ge,bu=new k,Pl=new k,Su=new k,g_=new qt,_p=new qt,__=new qt,Zl=class extends Ei{constructor(t=new Ca){if(super(),this.isSprite=!0,this.type="Sprite",fa===void 0){fa=new Ae;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Yl(e,5);fa.setIndex([0,1,2,0,2,3]),fa.setAttribute("position",new Ra(i,3,0,!1)),fa.setAttribute("uv",new Ra(i,2,3,!1))}this.geometry=fa,this.material=t,this.center=new qt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&re('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),pa.setFromMatrixScale(this.matrixWorld),vx.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),ma.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&pa.multiplyScalar(-ma.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Mu(bu.set(-.5,-.5,0),ma,o,pa,s,r),Mu(Pl.set(.5,-.5,0),ma,o,pa,s,r),Mu(Su.set(.5,.5,0),ma,o,pa,s,r),g_.set(0,0),_p.set(1,0),__.set(1,1);let a=t.ray.intersectTriangle(bu,Pl,Su,!1,Rl);if(a===null&&(Mu(Pl.set(-.5,.5,0),ma,o,pa,s,r),_p.set(0,1),a=t.ray.intersectTriangle(bu,Su,Pl,!1,Rl),a===null))return;let l=t.ray.origin.distanceTo(Rl);l<t.near||l>t.far||e.push({distance:l,point:Rl.clone(),uv:fr.getInterpolation(Rl,bu,Pl,Su,g_,_p,__,new qt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Mu(n,t,e,i,s,r){ga.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Cl.x=r*ga.x-s*ga.y,Cl.y=s*ga.x+r*ga.y):Cl.copy(ga),n.copy(t),n.x+=Cl.x,n.y+=Cl.y,n.applyMatrix4(vx)}var dr=new k,xp=new k,wu=new k,Eu=new k,gr=class{constructor(t=new k,e=new k(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,dr)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=dr.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(dr.copy(this.origin).addScaledVector(this.direction,e),dr.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){xp.copy(t).add(e).multiplyScalar(.5),wu.copy(e).sub(t).normalize(),Eu.copy(this.origin).sub(xp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(wu),a=Eu.dot(this.direction),l=-Eu.dot(wu),c=Eu.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(xp).addScaledVector(wu,d),f}intersectSphere(t,e){if(t.radius<0)return null;dr.subVectors(t.center,this.origin);let i=dr.dot(this.direction),s=dr.dot(dr)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,dr)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,g=e.x-o.x,y=e.y-o.y,p=e.z-o.z,m=i.x-o.x,x=i.y-o.y,E=i.z-o.z,v=Math.abs(l),A=Math.abs(c),T=Math.abs(u),_,S,L,I,D,B,V,O,$,Z,q,ht;if(v>=A&&v>=T?(L=l,B=h,$=g,ht=m,l>=0?(_=c,S=u,I=d,D=f,V=y,O=p,Z=x,q=E):(_=u,S=c,I=f,D=d,V=p,O=y,Z=E,q=x)):A>=T?(L=c,B=d,$=y,ht=x,c>=0?(_=u,S=l,I=f,D=h,V=p,O=g,Z=E,q=m):(_=l,S=u,I=h,D=f,V=g,O=p,Z=m,q=E)):(L=u,B=f,$=p,ht=E,u>=0?(_=l,S=c,I=h,D=d,V=g,O=y,Z=m,q=x):(_=c,S=l,I=d,D=h,V=y,O=g,Z=x,q=m)),L===0)return null;let K=_/L,tt=S/L,ot=1/L,mt=I-K*B,pt=D-tt*B,et=V-K*$,vt=O-tt*$,Mt=Z-K*ht,Lt=q-tt*ht,At=Mt*vt-Lt*et,jt=mt*Lt-pt*Mt,fe=et*pt-vt*mt;if(s){if(At<0||jt<0||fe<0)return null}else if((At<0||jt<0||fe<0)&&(At>0||jt>0||fe>0))return null;let Xt=At+jt+fe;if(Xt===0)return null;let ve=ot*(At*B+jt*$+fe*ht);return(Xt>0?ve<0:ve>0)?null:this.at(ve/Xt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ii=class extends $s{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ie(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new qr,this.combine=Up,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},x_=new ge,xo=new gr,Tu=new qs,y_=new k,Au=new k,Ru=new k,Cu=new k,yp=new k,Pu=new k,v_=new k,Iu=new k,fn=class extends Ei{constructor(t=new Ae,e=new ii){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Pu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(yp.fromBufferAttribute(h,t),o?Pu.addScaledVector(yp,u):Pu.addScaledVector(yp.sub(e),u))}e.add(Pu)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Tu.copy(i.boundingSphere),Tu.applyMatrix4(r),xo.copy(t.ray).recast(t.near),!(Tu.containsPoint(xo.origin)===!1&&(xo.intersectSphere(Tu,y_)===null||xo.origin.distanceToSquared(y_)>(t.far-t.near)**2))&&(x_.copy(r).invert(),xo.copy(t.ray).applyMatrix4(x_),!(i.boundingBox!==null&&xo.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,xo)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),E=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let v=x,A=E;v<A;v+=3){let T=a.getX(v),_=a.getX(v+1),S=a.getX(v+2);s=Lu(this,m,t,i,c,u,h,T,_,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=a.getX(p),E=a.getX(p+1),v=a.getX(p+2);s=Lu(this,o,t,i,c,u,h,x,E,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),E=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let v=x,A=E;v<A;v+=3){let T=v,_=v+1,S=v+2;s=Lu(this,m,t,i,c,u,h,T,_,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=p,E=p+1,v=p+2;s=Lu(this,o,t,i,c,u,h,x,E,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function Lw(n,t,e,i,s,r,o,a){let l;if(t.side===Ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Jr,a),l===null)return null;Iu.copy(a),Iu.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Iu);return c<e.near||c>e.far?null:{distance:c,point:Iu.clone(),object:n}}function Lu(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Au),n.getVertexPosition(l,Ru),n.getVertexPosition(c,Cu);let u=Lw(n,t,e,i,Au,Ru,Cu,v_);if(u){let h=new k;fr.getBarycoord(v_,Au,Ru,Cu,h),s&&(u.uv=fr.getInterpolatedAttribute(s,a,l,c,h,new qt)),r&&(u.uv1=fr.getInterpolatedAttribute(r,a,l,c,h,new qt)),o&&(u.normal=fr.getInterpolatedAttribute(o,a,l,c,h,new k),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new k,materialIndex:0};fr.getNormal(Au,Ru,Cu,d.normal),u.face=d,u.barycoord=h}return u}var jl=class extends wi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Kn,u=Kn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pa=class extends je{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},_a=new ge,b_=new ge,Du=[],S_=new Li,Dw=new ge,Il=new fn,Ll=new qs,Jl=class extends fn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Pa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Dw)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Li),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,_a),S_.copy(t.boundingBox).applyMatrix4(_a),this.boundingBox.union(S_)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new qs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,_a),Ll.copy(t.boundingSphere).applyMatrix4(_a),this.boundingSphere.union(Ll)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Il.geometry=this.geometry,Il.material=this.material,Il.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ll.copy(this.boundingSphere),Ll.applyMatrix4(i),t.ray.intersectsSphere(Ll)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,_a),b_.multiplyMatrices(i,_a),Il.matrixWorld=b_,Il.raycast(t,Du);for(let o=0,a=Du.length;o<a;o++){let l=Du[o];l.instanceId=r,l.object=this,e.push(l)}Du.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Pa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new jl(new Float32Array(s*this.count),s,this.count,Rh,cs));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},yo=new qs,Nw=new qt(.5,.5),Nu=new k,vo=class{constructor(t=new ni,e=new ni,i=new ni,s=new ni,r=new ni,o=new ni){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=os,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],x=r[12],E=r[13],v=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,m-g,A-x).normalize(),s[1].setComponents(c+o,f+u,m+g,A+x).normalize(),s[2].setComponents(c+a,f+h,m+y,A+E).normalize(),s[3].setComponents(c-a,f-h,m-y,A-E).normalize(),i)s[4].setComponents(l,d,p,v).normalize(),s[5].setComponents(c-l,f-d,m-p,A-v).normalize();else if(s[4].setComponents(c-l,f-d,m-p,A-v).normalize(),e===os)s[5].setComponents(c+l,f+d,m+p,A+v).normalize();else if(e===zl)s[5].setComponents(l,d,p,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),yo.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),yo.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(yo)}intersectsSprite(t){yo.center.set(0,0,0);let e=Nw.distanceTo(t.center);return yo.radius=.7071067811865476+e,yo.applyMatrix4(t.matrixWorld),this.intersectsSphere(yo)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Nu.x=s.normal.x>0?t.max.x:t.min.x,Nu.y=s.normal.y>0?t.max.y:t.min.y,Nu.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Nu)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},M_=new ge,ih=class n{constructor(){this.coordinateSystem=os,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];M_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new vo),i[s].setFromProjectionMatrix(M_,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new vo),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Xi=class extends $s{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ie(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},sh=new k,rh=new k,w_=new ge,Dl=new gr,Uu=new qs,vp=new k,E_=new k,Xs=class extends Ei{constructor(t=new Ae,e=new Xi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)sh.fromBufferAttribute(e,s-1),rh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=sh.distanceTo(rh);t.setAttribute("lineDistance",new Pe(i,1))}else te("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Uu.copy(i.boundingSphere),Uu.applyMatrix4(s),Uu.radius+=r,t.ray.intersectsSphere(Uu)===!1)return;w_.copy(s).invert(),Dl.copy(t.ray).applyMatrix4(w_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=u.getX(y),x=u.getX(y+1),E=Fu(this,t,Dl,l,m,x,y);E&&e.push(E)}if(this.isLineLoop){let y=u.getX(g-1),p=u.getX(f),m=Fu(this,t,Dl,l,y,p,g-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=Fu(this,t,Dl,l,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=Fu(this,t,Dl,l,g-1,f,g-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Fu(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(sh.fromBufferAttribute(a,s),rh.fromBufferAttribute(a,r),e.distanceSqToSegment(sh,rh,vp,E_)>i)return;vp.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(vp);if(!(c<t.near||c>t.far))return{distance:c,point:E_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var T_=new k,A_=new k,bo=class extends Xs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)T_.fromBufferAttribute(e,s),A_.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+T_.distanceTo(A_);t.setAttribute("lineDistance",new Pe(i,1))}else te("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ys=class extends $s{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ie(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},R_=new ge,Ep=new gr,Ou=new qs,Bu=new k,_r=class extends Ei{constructor(t=new Ae,e=new Ys){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ou.copy(i.boundingSphere),Ou.applyMatrix4(s),Ou.radius+=r,t.ray.intersectsSphere(Ou)===!1)return;R_.copy(s).invert(),Ep.copy(t.ray).applyMatrix4(R_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=d,y=f;g<y;g++){let p=c.getX(g);Bu.fromBufferAttribute(h,p),C_(Bu,p,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let g=d,y=f;g<y;g++)Bu.fromBufferAttribute(h,g),C_(Bu,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function C_(n,t,e,i,s,r,o){let a=Ep.distanceSqToPoint(n);if(a<e){let l=new k;Ep.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Kl=class extends wi{constructor(t=[],e=Eo,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ql=class extends wi{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var xr=class extends wi{constructor(t,e,i=Ss,s,r,o,a=Kn,l=Kn,c,u=mr,h=1){if(u!==mr&&u!==br)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ea(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},tc=class extends xr{constructor(t,e=Ss,i=Eo,s,r,o=Kn,a=Kn,l,c=mr){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ec=class extends wi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},as=class n extends Ae{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Pe(c,3)),this.setAttribute("normal",new Pe(u,3)),this.setAttribute("uv",new Pe(h,2));function g(y,p,m,x,E,v,A,T,_,S,L){let I=v/_,D=A/S,B=v/2,V=A/2,O=T/2,$=_+1,Z=S+1,q=0,ht=0,K=new k;for(let tt=0;tt<Z;tt++){let ot=tt*D-V;for(let mt=0;mt<$;mt++){let pt=mt*I-B;K[y]=pt*x,K[p]=ot*E,K[m]=O,c.push(K.x,K.y,K.z),K[y]=0,K[p]=0,K[m]=T>0?1:-1,u.push(K.x,K.y,K.z),h.push(mt/_),h.push(1-tt/S),q+=1}}for(let tt=0;tt<S;tt++)for(let ot=0;ot<_;ot++){let mt=d+ot+$*tt,pt=d+ot+$*(tt+1),et=d+(ot+1)+$*(tt+1),vt=d+(ot+1)+$*tt;l.push(mt,pt,vt),l.push(pt,et,vt),ht+=6}a.addGroup(f,ht,L),f+=ht,d+=q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},nc=class n extends Ae{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,h=Math.PI/2*t,d=e,f=2*h+d,g=i*2+r,y=s+1,p=new k,m=new k;for(let x=0;x<=g;x++){let E=0,v=0,A=0,T=0;if(x<=i){let L=x/i,I=L*Math.PI/2;v=-u-t*Math.cos(I),A=t*Math.sin(I),T=-t*Math.cos(I),E=L*h}else if(x<=i+r){let L=(x-i)/r;v=-u+L*e,A=t,T=0,E=h+L*d}else{let L=(x-i-r)/i,I=L*Math.PI/2;v=u+t*Math.sin(I),A=t*Math.cos(I),T=t*Math.sin(I),E=h+d+L*h}let _=Math.max(0,Math.min(1,E/f)),S=0;x===0?S=.5/s:x===g&&(S=-.5/s);for(let L=0;L<=s;L++){let I=L/s,D=I*Math.PI*2,B=Math.sin(D),V=Math.cos(D);m.x=-A*V,m.y=v,m.z=A*B,a.push(m.x,m.y,m.z),p.set(-A*V,T,A*B),p.normalize(),l.push(p.x,p.y,p.z),c.push(I+S,_)}if(x>0){let L=(x-1)*y;for(let I=0;I<s;I++){let D=L+I,B=L+I+1,V=x*y+I,O=x*y+I+1;o.push(D,B,V),o.push(B,O,V)}}}this.setIndex(o),this.setAttribute("position",new Pe(a,3)),this.setAttribute("normal",new Pe(l,3)),this.setAttribute("uv",new Pe(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}};var Yi=class n extends Ae{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],g=0,y=[],p=i/2,m=0;x(),o===!1&&(t>0&&E(!0),e>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new Pe(h,3)),this.setAttribute("normal",new Pe(d,3)),this.setAttribute("uv",new Pe(f,2));function x(){let v=new k,A=new k,T=0,_=(e-t)/i;for(let S=0;S<=r;S++){let L=[],I=S/r,D=I*(e-t)+t;for(let B=0;B<=s;B++){let V=B/s,O=V*l+a,$=Math.sin(O),Z=Math.cos(O);A.x=D*$,A.y=-I*i+p,A.z=D*Z,h.push(A.x,A.y,A.z),v.set($,_,Z).normalize(),d.push(v.x,v.y,v.z),f.push(V,1-I),L.push(g++)}y.push(L)}for(let S=0;S<s;S++)for(let L=0;L<r;L++){let I=y[L][S],D=y[L+1][S],B=y[L+1][S+1],V=y[L][S+1];(t>0||L!==0)&&(u.push(I,D,V),T+=3),(e>0||L!==r-1)&&(u.push(D,B,V),T+=3)}c.addGroup(m,T,0),m+=T}function E(v){let A=g,T=new qt,_=new k,S=0,L=v===!0?t:e,I=v===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,p*I,0),d.push(0,I,0),f.push(.5,.5),g++;let D=g;for(let B=0;B<=s;B++){let O=B/s*l+a,$=Math.cos(O),Z=Math.sin(O);_.x=L*Z,_.y=p*I,_.z=L*$,h.push(_.x,_.y,_.z),d.push(0,I,0),T.x=$*.5+.5,T.y=Z*.5*I+.5,f.push(T.x,T.y),g++}for(let B=0;B<s;B++){let V=A+B,O=D+B;v===!0?u.push(O,O+1,V):u.push(O+1,O,V),S+=3}c.addGroup(m,S,v===!0?1:2),m+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},So=class n extends Yi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},oh=class n extends Ae{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Pe(r,3)),this.setAttribute("normal",new Pe(r.slice(),3)),this.setAttribute("uv",new Pe(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let E=new k,v=new k,A=new k;for(let T=0;T<e.length;T+=3)f(e[T+0],E),f(e[T+1],v),f(e[T+2],A),l(E,v,A,x)}function l(x,E,v,A){let T=A+1,_=[];for(let S=0;S<=T;S++){_[S]=[];let L=x.clone().lerp(v,S/T),I=E.clone().lerp(v,S/T),D=T-S;for(let B=0;B<=D;B++)B===0&&S===T?_[S][B]=L:_[S][B]=L.clone().lerp(I,B/D)}for(let S=0;S<T;S++)for(let L=0;L<2*(T-S)-1;L++){let I=Math.floor(L/2);L%2===0?(d(_[S][I+1]),d(_[S+1][I]),d(_[S][I])):(d(_[S][I+1]),d(_[S+1][I+1]),d(_[S+1][I]))}}function c(x){let E=new k;for(let v=0;v<r.length;v+=3)E.x=r[v+0],E.y=r[v+1],E.z=r[v+2],E.normalize().multiplyScalar(x),r[v+0]=E.x,r[v+1]=E.y,r[v+2]=E.z}function u(){let x=new k;for(let E=0;E<r.length;E+=3){x.x=r[E+0],x.y=r[E+1],x.z=r[E+2];let v=p(x)/2/Math.PI+.5,A=m(x)/Math.PI+.5;o.push(v,1-A)}g(),h()}function h(){for(let x=0;x<o.length;x+=6){let E=o[x+0],v=o[x+2],A=o[x+4],T=Math.max(E,v,A),_=Math.min(E,v,A);T>.9&&_<.1&&(E<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),A<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,E){let v=x*3;E.x=t[v+0],E.y=t[v+1],E.z=t[v+2]}function g(){let x=new k,E=new k,v=new k,A=new k,T=new qt,_=new qt,S=new qt;for(let L=0,I=0;L<r.length;L+=9,I+=6){x.set(r[L+0],r[L+1],r[L+2]),E.set(r[L+3],r[L+4],r[L+5]),v.set(r[L+6],r[L+7],r[L+8]),T.set(o[I+0],o[I+1]),_.set(o[I+2],o[I+3]),S.set(o[I+4],o[I+5]),A.copy(x).add(E).add(v).divideScalar(3);let D=p(A);y(T,I+0,x,D),y(_,I+2,E,D),y(S,I+4,v,D)}}function y(x,E,v,A){A<0&&x.x===1&&(o[E]=x.x-1),v.x===0&&v.z===0&&(o[E]=A/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function m(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var ic=class n extends Ae{constructor(t=[new qt(0,-.5),new qt(.5,0),new qt(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=be(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],u=1/e,h=new k,d=new qt,f=new k,g=new k,y=new k,p=0,m=0;for(let x=0;x<=t.length-1;x++)switch(x){case 0:p=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,f.x=m*1,f.y=-p,f.z=m*0,y.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case t.length-1:y.normalize(),l.push(y.x,y.y,y.z);break;default:p=t[x+1].x-t[x].x,m=t[x+1].y-t[x].y,f.x=m*1,f.y=-p,f.z=m*0,g.copy(f),f.x+=y.x,f.y+=y.y,f.z+=y.z,f.normalize(),l.push(f.x,f.y,f.z),y.copy(g)}for(let x=0;x<=e;x++){let E=i+x*u*s,v=Math.sin(E),A=Math.cos(E);for(let T=0;T<=t.length-1;T++){h.x=t[T].x*v,h.y=t[T].y,h.z=t[T].x*A,o.push(h.x,h.y,h.z),d.x=x/e,d.y=T/(t.length-1),a.push(d.x,d.y);let _=l[3*T+0]*v,S=l[3*T+1],L=l[3*T+0]*A;c.push(_,S,L)}}for(let x=0;x<e;x++)for(let E=0;E<t.length-1;E++){let v=E+x*t.length,A=v,T=v+t.length,_=v+t.length+1,S=v+1;r.push(A,T,S),r.push(_,S,T)}this.setIndex(r),this.setAttribute("position",new Pe(o,3)),this.setAttribute("uv",new Pe(a,2)),this.setAttribute("normal",new Pe(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.points,t.segments,t.phiStart,t.phiLength)}},sc=class n extends oh{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},rc=class n extends Ae{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],g=[],y=[],p=[];for(let m=0;m<u;m++){let x=m*d-o;for(let E=0;E<c;E++){let v=E*h-r;g.push(v,-x,0),y.push(0,0,1),p.push(E/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<a;x++){let E=x+c*m,v=x+c*(m+1),A=x+1+c*(m+1),T=x+1+c*m;f.push(E,v,T),f.push(v,A,T)}this.setIndex(f),this.setAttribute("position",new Pe(g,3)),this.setAttribute("normal",new Pe(y,3)),this.setAttribute("uv",new Pe(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var yr=class n extends Ae{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new k,d=new k,f=[],g=[],y=[],p=[];for(let m=0;m<=i;m++){let x=[],E=m/i,v=o+E*a,A=t*Math.cos(v),T=Math.sqrt(t*t-A*A),_=0;m===0&&o===0?_=.5/e:m===i&&l===Math.PI&&(_=-.5/e);for(let S=0;S<=e;S++){let L=S/e,I=s+L*r;h.x=-T*Math.cos(I),h.y=A,h.z=T*Math.sin(I),g.push(h.x,h.y,h.z),d.copy(h).normalize(),y.push(d.x,d.y,d.z),p.push(L+_,1-E),x.push(c++)}u.push(x)}for(let m=0;m<i;m++)for(let x=0;x<e;x++){let E=u[m][x+1],v=u[m][x],A=u[m+1][x],T=u[m+1][x+1];(m!==0||o>0)&&f.push(E,v,T),(m!==i-1||l<Math.PI)&&f.push(v,A,T)}this.setIndex(f),this.setAttribute("position",new Pe(g,3)),this.setAttribute("normal",new Pe(y,3)),this.setAttribute("uv",new Pe(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ia=class n extends Ae{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],d=new k,f=new k,g=new k;for(let y=0;y<=i;y++){let p=o+y/i*a;for(let m=0;m<=s;m++){let x=m/s*r;f.x=(t+e*Math.cos(p))*Math.cos(x),f.y=(t+e*Math.cos(p))*Math.sin(x),f.z=e*Math.sin(p),c.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),g.subVectors(f,d).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let p=1;p<=s;p++){let m=(s+1)*y+p-1,x=(s+1)*(y-1)+p-1,E=(s+1)*(y-1)+p,v=(s+1)*y+p;l.push(m,x,v),l.push(x,E,v)}this.setIndex(l),this.setAttribute("position",new Pe(c,3)),this.setAttribute("normal",new Pe(u,3)),this.setAttribute("uv",new Pe(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function Ao(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(P_(s))s.isRenderTargetTexture?(te("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(P_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function ci(n){let t={};for(let e=0;e<n.length;e++){let i=Ao(n[e]);for(let s in i)t[s]=i[s]}return t}function P_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Uw(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function lm(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ce.workingColorSpace}var bx={clone:Ao,merge:ci},Fw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ow=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ls=class extends $s{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Fw,this.fragmentShader=Ow,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Ao(t.uniforms),this.uniformsGroups=Uw(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ie().setHex(s.value);break;case"v2":this.uniforms[i].value=new qt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new k().fromArray(s.value);break;case"v4":this.uniforms[i].value=new gn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ce().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ge().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ah=class extends ls{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var lh=class extends $s{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ax,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ch=class extends $s{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function xa(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function ku(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var $r=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},uh=class extends $r{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Sp,endingEnd:Sp}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Mp:r=t,a=2*e-i;break;case wp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Mp:o=t,l=2*i-e;break;case wp:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-e)/(s-e),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,x=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,E=(-1-f)*p+(1.5+f)*y+.5*g,v=f*p-f*y;for(let A=0;A!==a;++A)r[A]=m*o[u+A]+x*o[c+A]+E*o[l+A]+v*o[h+A];return r}},hh=class extends $r{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},dh=class extends $r{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},fh=class extends $r{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-e)/(s-e),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,f=t-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=f*d+g*2,x=h[m],E=h[m+1],v=t*d+g*2,A=u[v],T=u[v+1],_=kw(i,e,x,A,s);r[g]=Sx(_,y,E,T,p)}return r}};function Sx(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Bw(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function kw(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Sx(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Bw(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Zi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=xa(e,this.TimeBufferType),this.values=xa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:xa(t.times,Array),values:xa(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),ku(t.settings)&&(i.settings={inTangents:xa(t.settings.inTangents,Array),outTangents:xa(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new hh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new uh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new fh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ol:e=this.InterpolantFactoryMethodDiscrete;break;case Qu:e=this.InterpolantFactoryMethodLinear;break;case Gu:e=this.InterpolantFactoryMethodSmooth;break;case bp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return te("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ol;case this.InterpolantFactoryMethodLinear:return Qu;case this.InterpolantFactoryMethodSmooth:return Gu;case this.InterpolantFactoryMethodBezier:return bp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;ku(this.settings)&&(I_(this.settings.inTangents,t),I_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;ku(this.settings)&&(L_(this.settings.inTangents,t),L_(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&tw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Gu,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let g=0;g!==i;++g){let y=e[h+g];if(y!==e[d+g]||y!==e[f+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,ku(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function I_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function L_(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Zi.prototype.ValueTypeName="";Zi.prototype.TimeBufferType=Float32Array;Zi.prototype.ValueBufferType=Float32Array;Zi.prototype.DefaultInterpolation=Qu;var Xr=class extends Zi{constructor(t,e,i){super(t,e,i)}};Xr.prototype.ValueTypeName="bool";Xr.prototype.ValueBufferType=Array;Xr.prototype.DefaultInterpolation=Ol;Xr.prototype.InterpolantFactoryMethodLinear=void 0;Xr.prototype.InterpolantFactoryMethodSmooth=void 0;var ph=class extends Zi{constructor(t,e,i,s){super(t,e,i,s)}};ph.prototype.ValueTypeName="color";var mh=class extends Zi{constructor(t,e,i,s){super(t,e,i,s)}};mh.prototype.ValueTypeName="number";var gh=class extends $r{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)an.slerpFlat(r,0,o,c-a,o,c,l);return r}},oc=class extends Zi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new gh(this.times,this.values,this.getValueSize(),t)}};oc.prototype.ValueTypeName="quaternion";oc.prototype.InterpolantFactoryMethodSmooth=void 0;var Yr=class extends Zi{constructor(t,e,i){super(t,e,i)}};Yr.prototype.ValueTypeName="string";Yr.prototype.ValueBufferType=Array;Yr.prototype.DefaultInterpolation=Ol;Yr.prototype.InterpolantFactoryMethodLinear=void 0;Yr.prototype.InterpolantFactoryMethodSmooth=void 0;var _h=class extends Zi{constructor(t,e,i,s){super(t,e,i,s)}};_h.prototype.ValueTypeName="vector";var xh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],g=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Mx=new xh,yh=class{constructor(t){this.manager=t!==void 0?t:Mx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};yh.DEFAULT_MATERIAL_NAME="__DEFAULT";var zu=new k,Hu=new an,Vs=new k,ac=class extends Ei{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,this.coordinateSystem=os,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(zu,Hu,Vs),Vs.x===1&&Vs.y===1&&Vs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zu,Hu,Vs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(zu,Hu,Vs),Vs.x===1&&Vs.y===1&&Vs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zu,Hu,Vs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Wr=new k,D_=new qt,N_=new qt,Si=class extends ac{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=wa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Ul*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return wa*2*Math.atan(Math.tan(Ul*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Wr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Wr.x,Wr.y).multiplyScalar(-t/Wr.z),Wr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Wr.x,Wr.y).multiplyScalar(-t/Wr.z)}getViewSize(t,e){return this.getViewBounds(t,D_,N_),e.subVectors(N_,D_)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Ul*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var vh=class extends ac{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var ya=-90,va=1,La=class extends Ei{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Si(ya,va,t,e);s.layers=this.layers,this.add(s);let r=new Si(ya,va,t,e);r.layers=this.layers,this.add(r);let o=new Si(ya,va,t,e);o.layers=this.layers,this.add(o);let a=new Si(ya,va,t,e);a.layers=this.layers,this.add(a);let l=new Si(ya,va,t,e);l.layers=this.layers,this.add(l);let c=new Si(ya,va,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===os)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===zl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},bh=class extends Si{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var cm="\\[\\]\\.:\\/",zw=new RegExp("["+cm+"]","g"),um="[^"+cm+"]",Hw="[^"+cm.replace("\\.","")+"]",Gw=/((?:WC+[\/:])*)/.source.replace("WC",um),Vw=/(WCOD+)?/.source.replace("WCOD",Hw),Ww=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",um),qw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",um),$w=new RegExp("^"+Gw+Vw+Ww+qw+"$"),Xw=["material","materials","bones","map"],Tp=class{constructor(t,e,i){let s=i||on.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},on=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(zw,"")}static parseTrackName(t){let e=$w.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Xw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){te("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};on.Composite=Tp;on.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};on.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};on.prototype.GetterByBindingType=[on.prototype._getValue_direct,on.prototype._getValue_array,on.prototype._getValue_arrayElement,on.prototype._getValue_toArray];on.prototype.SetterByBindingTypeAndVersioning=[[on.prototype._setValue_direct,on.prototype._setValue_direct_setNeedsUpdate,on.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[on.prototype._setValue_array,on.prototype._setValue_array_setNeedsUpdate,on.prototype._setValue_array_setMatrixWorldNeedsUpdate],[on.prototype._setValue_arrayElement,on.prototype._setValue_arrayElement_setNeedsUpdate,on.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[on.prototype._setValue_fromArray,on.prototype._setValue_fromArray_setNeedsUpdate,on.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var k2=new Float32Array(1);var U_=new ge,lc=class{constructor(t,e,i=0,s=1/0){this.ray=new gr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Ta,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):re("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return U_.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(U_),this}intersectObject(t,e=!0,i=[]){return Ap(t,this,i,e),i.sort(F_),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Ap(t[s],this,i,e);return i.sort(F_),i}};function F_(n,t){return n.distance-t.distance}function Ap(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Ap(r[o],t,e,!0)}}var Da=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=be(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(be(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Rp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var cc=class extends bs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function hm(n,t,e,i){let s=Yw(i);switch(e){case Yp:return n*t;case Rh:return n*t/s.components*s.byteLength;case Ch:return n*t/s.components*s.byteLength;case Kr:return n*t*2/s.components*s.byteLength;case Ph:return n*t*2/s.components*s.byteLength;case Zp:return n*t*3/s.components*s.byteLength;case ws:return n*t*4/s.components*s.byteLength;case Ih:return n*t*4/s.components*s.byteLength;case dc:case fc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case pc:case mc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Dh:case Uh:return Math.max(n,16)*Math.max(t,8)/4;case Lh:case Nh:return Math.max(n,8)*Math.max(t,8)/2;case Fh:case Oh:case kh:case zh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Bh:case gc:case Hh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Gh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Vh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Wh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case qh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case $h:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Xh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Yh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Zh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case jh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Jh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Kh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Qh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case td:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case ed:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case nd:case id:case sd:return Math.ceil(n/4)*Math.ceil(t/4)*16;case rd:case od:return Math.ceil(n/4)*Math.ceil(t/4)*8;case _c:case ad:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Yw(n){switch(n){case ji:case Wp:return{byteLength:1,components:1};case Oa:case qp:case Ms:return{byteLength:2,components:1};case Th:case Ah:return{byteLength:2,components:4};case Ss:case Eh:case cs:return{byteLength:4,components:1};case $p:case Xp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?te("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function qx(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Qw(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],y=h[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let y=h[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var tE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,eE=`#ifdef USE_ALPHAHASH
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
#endif`,nE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,iE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,sE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,rE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,oE=`#ifdef USE_AOMAP
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
#endif`,aE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,lE=`#ifdef USE_BATCHING
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
#endif`,cE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,uE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,hE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,dE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,fE=`#ifdef USE_IRIDESCENCE
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
#endif`,pE=`#ifdef USE_BUMPMAP
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
#endif`,mE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,gE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,_E=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,xE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,yE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,vE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,bE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,SE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ME=`#define PI 3.141592653589793
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
} // validated`,wE=`vec3 transformedNormal = objectNormal;
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
#endif`,EE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,TE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,AE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,RE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,CE="gl_FragColor = linearToOutputTexel( gl_FragColor );",PE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,IE=`#ifdef USE_ENVMAP
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
#endif`,LE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,DE=`#ifdef USE_ENVMAP
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
#endif`,NE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,UE=`#ifdef USE_ENVMAP
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
#endif`,FE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,OE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,BE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,kE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,zE=`#ifdef USE_GRADIENTMAP
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
}`,HE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,GE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,VE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,WE=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,qE=`#ifdef USE_ENVMAP
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
#endif`,$E=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,XE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,YE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ZE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,jE=`PhysicalMaterial material;
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
#endif`,JE=`uniform sampler2D dfgLUT;
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
}`,KE=`
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
#endif`,QE=`#if defined( RE_IndirectDiffuse )
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
#endif`,t1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,e1=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,n1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,i1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,s1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,r1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,o1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,a1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,l1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,c1=`#if defined( USE_POINTS_UV )
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
#endif`,u1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,h1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,d1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,f1=`#if defined( USE_MORPHCOLORS )
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
#endif`,p1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,m1=`#ifdef USE_MORPHTARGETS
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
#endif`,g1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,_1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,x1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,y1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,v1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,b1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,S1=`#ifdef USE_NORMALMAP
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
#endif`,M1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,w1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,E1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,T1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,A1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,R1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,C1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,P1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,I1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,L1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,D1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,N1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,U1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,F1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,O1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,B1=`float getShadowMask() {
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
}`,k1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,z1=`#ifdef USE_SKINNING
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
#endif`,H1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,G1=`#ifdef USE_SKINNING
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
#endif`,V1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,W1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,q1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,$1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,X1=`#ifdef USE_TRANSMISSION
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
#endif`,Y1=`#ifdef USE_TRANSMISSION
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
#endif`,Z1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,j1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,J1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,K1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Q1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,tT=`uniform sampler2D t2D;
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
}`,eT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,nT=`uniform float backgroundBlurriness;
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
}`,iT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,sT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rT=`#include <common>
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
}`,oT=`#if DEPTH_PACKING == 3200
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
}`,aT=`#define DISTANCE
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
}`,lT=`#define DISTANCE
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
}`,cT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,uT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hT=`uniform float scale;
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
}`,dT=`uniform vec3 diffuse;
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
}`,fT=`#include <common>
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
}`,pT=`uniform vec3 diffuse;
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
}`,mT=`#define LAMBERT
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
}`,gT=`#define LAMBERT
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
}`,_T=`#define MATCAP
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
}`,xT=`#define MATCAP
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
}`,yT=`#define NORMAL
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
}`,vT=`#define NORMAL
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
}`,bT=`#define PHONG
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
}`,ST=`#define PHONG
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
}`,MT=`#define STANDARD
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
}`,wT=`#define STANDARD
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
}`,ET=`#define TOON
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
}`,TT=`#define TOON
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
}`,AT=`uniform float size;
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
}`,RT=`uniform vec3 diffuse;
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
}`,CT=`#include <common>
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
}`,PT=`uniform vec3 color;
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
}`,IT=`uniform float rotation;
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
}`,LT=`uniform vec3 diffuse;
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
}`,ye={alphahash_fragment:tE,alphahash_pars_fragment:eE,alphamap_fragment:nE,alphamap_pars_fragment:iE,alphatest_fragment:sE,alphatest_pars_fragment:rE,aomap_fragment:oE,aomap_pars_fragment:aE,batching_pars_vertex:lE,batching_vertex:cE,begin_vertex:uE,beginnormal_vertex:hE,bsdfs:dE,iridescence_fragment:fE,bumpmap_pars_fragment:pE,clipping_planes_fragment:mE,clipping_planes_pars_fragment:gE,clipping_planes_pars_vertex:_E,clipping_planes_vertex:xE,color_fragment:yE,color_pars_fragment:vE,color_pars_vertex:bE,color_vertex:SE,common:ME,defaultnormal_vertex:wE,displacementmap_pars_vertex:EE,displacementmap_vertex:TE,emissivemap_fragment:AE,emissivemap_pars_fragment:RE,colorspace_fragment:CE,colorspace_pars_fragment:PE,envmap_fragment:IE,envmap_common_pars_fragment:LE,envmap_pars_fragment:DE,envmap_pars_vertex:NE,envmap_physical_pars_fragment:qE,envmap_vertex:UE,fog_vertex:FE,fog_pars_vertex:OE,fog_fragment:BE,fog_pars_fragment:kE,gradientmap_pars_fragment:zE,lightmap_pars_fragment:HE,lights_lambert_fragment:GE,lights_lambert_pars_fragment:VE,lights_pars_begin:WE,lights_toon_fragment:$E,lights_toon_pars_fragment:XE,lights_phong_fragment:YE,lights_phong_pars_fragment:ZE,lights_physical_fragment:jE,lights_physical_pars_fragment:JE,lights_fragment_begin:KE,lights_fragment_maps:QE,lights_fragment_end:t1,lightprobes_pars_fragment:e1,logdepthbuf_fragment:n1,logdepthbuf_pars_fragment:i1,logdepthbuf_pars_vertex:s1,logdepthbuf_vertex:r1,map_fragment:o1,map_pars_fragment:a1,map_particle_fragment:l1,map_particle_pars_fragment:c1,metalnessmap_fragment:u1,metalnessmap_pars_fragment:h1,morphinstance_vertex:d1,morphcolor_vertex:f1,morphnormal_vertex:p1,morphtarget_pars_vertex:m1,morphtarget_vertex:g1,normal_fragment_begin:_1,normal_fragment_maps:x1,normal_pars_fragment:y1,normal_pars_vertex:v1,normal_vertex:b1,normalmap_pars_fragment:S1,clearcoat_normal_fragment_begin:M1,clearcoat_normal_fragment_maps:w1,clearcoat_pars_fragment:E1,iridescence_pars_fragment:T1,opaque_fragment:A1,packing:R1,premultiplied_alpha_fragment:C1,project_vertex:P1,dithering_fragment:I1,dithering_pars_fragment:L1,roughnessmap_fragment:D1,roughnessmap_pars_fragment:N1,shadowmap_pars_fragment:U1,shadowmap_pars_vertex:F1,shadowmap_vertex:O1,shadowmask_pars_fragment:B1,skinbase_vertex:k1,skinning_pars_vertex:z1,skinning_vertex:H1,skinnormal_vertex:G1,specularmap_fragment:V1,specularmap_pars_fragment:W1,tonemapping_fragment:q1,tonemapping_pars_fragment:$1,transmission_fragment:X1,transmission_pars_fragment:Y1,uv_pars_fragment:Z1,uv_pars_vertex:j1,uv_vertex:J1,worldpos_vertex:K1,background_vert:Q1,background_frag:tT,backgroundCube_vert:eT,backgroundCube_frag:nT,cube_vert:iT,cube_frag:sT,depth_vert:rT,depth_frag:oT,distance_vert:aT,distance_frag:lT,equirect_vert:cT,equirect_frag:uT,linedashed_vert:hT,linedashed_frag:dT,meshbasic_vert:fT,meshbasic_frag:pT,meshlambert_vert:mT,meshlambert_frag:gT,meshmatcap_vert:_T,meshmatcap_frag:xT,meshnormal_vert:yT,meshnormal_frag:vT,meshphong_vert:bT,meshphong_frag:ST,meshphysical_vert:MT,meshphysical_frag:wT,meshtoon_vert:ET,meshtoon_frag:TT,points_vert:AT,points_frag:RT,shadow_vert:CT,shadow_frag:PT,sprite_vert:IT,sprite_frag:LT},Ot={common:{diffuse:{value:new ie(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ie(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ie(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new ie(16777215)},opacity:{value:1},center:{value:new qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},Js={basic:{uniforms:ci([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.fog]),vertexShader:ye.meshbasic_vert,fragmentShader:ye.meshbasic_frag},lambert:{uniforms:ci([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)},envMapIntensity:{value:1}}]),vertexShader:ye.meshlambert_vert,fragmentShader:ye.meshlambert_frag},phong:{uniforms:ci([Ot.common,Ot.specularmap,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)},specular:{value:new ie(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ye.meshphong_vert,fragmentShader:ye.meshphong_frag},standard:{uniforms:ci([Ot.common,Ot.envmap,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.roughnessmap,Ot.metalnessmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ye.meshphysical_vert,fragmentShader:ye.meshphysical_frag},toon:{uniforms:ci([Ot.common,Ot.aomap,Ot.lightmap,Ot.emissivemap,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.gradientmap,Ot.fog,Ot.lights,{emissive:{value:new ie(0)}}]),vertexShader:ye.meshtoon_vert,fragmentShader:ye.meshtoon_frag},matcap:{uniforms:ci([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,Ot.fog,{matcap:{value:null}}]),vertexShader:ye.meshmatcap_vert,fragmentShader:ye.meshmatcap_frag},points:{uniforms:ci([Ot.points,Ot.fog]),vertexShader:ye.points_vert,fragmentShader:ye.points_frag},dashed:{uniforms:ci([Ot.common,Ot.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ye.linedashed_vert,fragmentShader:ye.linedashed_frag},depth:{uniforms:ci([Ot.common,Ot.displacementmap]),vertexShader:ye.depth_vert,fragmentShader:ye.depth_frag},normal:{uniforms:ci([Ot.common,Ot.bumpmap,Ot.normalmap,Ot.displacementmap,{opacity:{value:1}}]),vertexShader:ye.meshnormal_vert,fragmentShader:ye.meshnormal_frag},sprite:{uniforms:ci([Ot.sprite,Ot.fog]),vertexShader:ye.sprite_vert,fragmentShader:ye.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ye.background_vert,fragmentShader:ye.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:ye.backgroundCube_vert,fragmentShader:ye.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ye.cube_vert,fragmentShader:ye.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ye.equirect_vert,fragmentShader:ye.equirect_frag},distance:{uniforms:ci([Ot.common,Ot.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ye.distance_vert,fragmentShader:ye.distance_frag},shadow:{uniforms:ci([Ot.lights,Ot.fog,{color:{value:new ie(0)},opacity:{value:1}}]),vertexShader:ye.shadow_vert,fragmentShader:ye.shadow_frag}};Js.physical={uniforms:ci([Js.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ce},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new ie(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new ie(0)},specularColor:{value:new ie(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:ye.meshphysical_vert,fragmentShader:ye.meshphysical_frag};var ud={r:0,b:0,g:0},DT=new ge,$x=new ce;$x.set(-1,0,0,0,1,0,0,0,1);function NT(n,t,e,i,s,r){let o=new ie(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let E=x.isScene===!0?x.background:null;if(E&&E.isTexture){let v=x.backgroundBlurriness>0;E=t.get(E,v)}return E}function g(x){let E=!1,v=f(x);v===null?p(o,a):v&&v.isColor&&(p(v,1),E=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,E){let v=f(E);v&&v.isCubeTexture?(c===void 0&&(c=new fn(new as(1,1,1),new ls({name:"BackgroundCubeMaterial",uniforms:Ao(Js.backgroundCube.uniforms),vertexShader:Js.backgroundCube.vertexShader,fragmentShader:Js.backgroundCube.fragmentShader,side:Ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,T,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(DT.makeRotationFromEuler(E.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply($x),c.material.toneMapped=Ce.getTransfer(v.colorSpace)!==ke,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new fn(new rc(2,2),new ls({name:"BackgroundMaterial",uniforms:Ao(Js.background.uniforms),vertexShader:Js.background.vertexShader,fragmentShader:Js.background.fragmentShader,side:Jr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=Ce.getTransfer(v.colorSpace)!==ke,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,E){x.getRGB(ud,lm(n)),e.buffers.color.setClear(ud.r,ud.g,ud.b,E,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,E=1){o.set(x),a=E,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:y,dispose:m}}function UT(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,B,V,O,$){let Z=!1,q=h(D,O,V,B);r!==q&&(r=q,c(r.object)),Z=f(D,O,V,$),Z&&g(D,O,V,$),$!==null&&t.update($,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,v(D,B,V,O),$!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get($).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function h(D,B,V,O){let $=O.wireframe===!0,Z=i[B.id];Z===void 0&&(Z={},i[B.id]=Z);let q=D.isInstancedMesh===!0?D.id:0,ht=Z[q];ht===void 0&&(ht={},Z[q]=ht);let K=ht[V.id];K===void 0&&(K={},ht[V.id]=K);let tt=K[$];return tt===void 0&&(tt=d(l()),K[$]=tt),tt}function d(D){let B=[],V=[],O=[];for(let $=0;$<e;$++)B[$]=0,V[$]=0,O[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:O,object:D,attributes:{},index:null}}function f(D,B,V,O){let $=r.attributes,Z=B.attributes,q=0,ht=V.getAttributes();for(let K in ht)if(ht[K].location>=0){let ot=$[K],mt=Z[K];if(mt===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(mt=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(mt=D.instanceColor)),ot===void 0||ot.attribute!==mt||mt&&ot.data!==mt.data)return!0;q++}return r.attributesNum!==q||r.index!==O}function g(D,B,V,O){let $={},Z=B.attributes,q=0,ht=V.getAttributes();for(let K in ht)if(ht[K].location>=0){let ot=Z[K];ot===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(ot=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(ot=D.instanceColor));let mt={};mt.attribute=ot,ot&&ot.data&&(mt.data=ot.data),$[K]=mt,q++}r.attributes=$,r.attributesNum=q,r.index=O}function y(){let D=r.newAttributes;for(let B=0,V=D.length;B<V;B++)D[B]=0}function p(D){m(D,0)}function m(D,B){let V=r.newAttributes,O=r.enabledAttributes,$=r.attributeDivisors;V[D]=1,O[D]===0&&(n.enableVertexAttribArray(D),O[D]=1),$[D]!==B&&(n.vertexAttribDivisor(D,B),$[D]=B)}function x(){let D=r.newAttributes,B=r.enabledAttributes;for(let V=0,O=B.length;V<O;V++)B[V]!==D[V]&&(n.disableVertexAttribArray(V),B[V]=0)}function E(D,B,V,O,$,Z,q){q===!0?n.vertexAttribIPointer(D,B,V,$,Z):n.vertexAttribPointer(D,B,V,O,$,Z)}function v(D,B,V,O){y();let $=O.attributes,Z=V.getAttributes(),q=B.defaultAttributeValues;for(let ht in Z){let K=Z[ht];if(K.location>=0){let tt=$[ht];if(tt===void 0&&(ht==="instanceMatrix"&&D.instanceMatrix&&(tt=D.instanceMatrix),ht==="instanceColor"&&D.instanceColor&&(tt=D.instanceColor)),tt!==void 0){let ot=tt.normalized,mt=tt.itemSize,pt=t.get(tt);if(pt===void 0)continue;let et=pt.buffer,vt=pt.type,Mt=pt.bytesPerElement,Lt=vt===n.INT||vt===n.UNSIGNED_INT||tt.gpuType===Eh;if(tt.isInterleavedBufferAttribute){let At=tt.data,jt=At.isInterleavedBuffer===!0?At.stride:At.itemSize,fe=tt.offset;if(At.isInstancedInterleavedBuffer||At.isInstancedBufferAttribute){for(let Xt=0;Xt<K.locationSize;Xt++)m(K.location+Xt,At.meshPerAttribute);D.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=At.meshPerAttribute*At.count)}else for(let Xt=0;Xt<K.locationSize;Xt++)p(K.location+Xt);n.bindBuffer(n.ARRAY_BUFFER,et);for(let Xt=0;Xt<K.locationSize;Xt++)E(K.location+Xt,mt/K.locationSize,vt,ot,jt*Mt,(fe+mt/K.locationSize*Xt)*Mt,Lt)}else{if(tt.isInstancedBufferAttribute){for(let At=0;At<K.locationSize;At++)m(K.location+At,tt.meshPerAttribute);D.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let At=0;At<K.locationSize;At++)p(K.location+At);n.bindBuffer(n.ARRAY_BUFFER,et);for(let At=0;At<K.locationSize;At++)E(K.location+At,mt/K.locationSize,vt,ot,mt*Mt,mt/K.locationSize*At*Mt,Lt)}}else if(q!==void 0){let ot=q[ht];if(ot!==void 0)switch(ot.length){case 2:n.vertexAttrib2fv(K.location,ot);break;case 3:n.vertexAttrib3fv(K.location,ot);break;case 4:n.vertexAttrib4fv(K.location,ot);break;default:n.vertexAttrib1fv(K.location,ot)}}}}x()}function A(){L();for(let D in i){let B=i[D];for(let V in B){let O=B[V];for(let $ in O){let Z=O[$];for(let q in Z)u(Z[q].object),delete Z[q];delete O[$]}}delete i[D]}}function T(D){if(i[D.id]===void 0)return;let B=i[D.id];for(let V in B){let O=B[V];for(let $ in O){let Z=O[$];for(let q in Z)u(Z[q].object),delete Z[q];delete O[$]}}delete i[D.id]}function _(D){for(let B in i){let V=i[B];for(let O in V){let $=V[O];if($[D.id]===void 0)continue;let Z=$[D.id];for(let q in Z)u(Z[q].object),delete Z[q];delete $[D.id]}}}function S(D){for(let B in i){let V=i[B],O=D.isInstancedMesh===!0?D.id:0,$=V[O];if($!==void 0){for(let Z in $){let q=$[Z];for(let ht in q)u(q[ht].object),delete q[ht];delete $[Z]}delete V[O],Object.keys(V).length===0&&delete i[B]}}}function L(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:I,dispose:A,releaseStatesOfGeometry:T,releaseStatesOfObject:S,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function FT(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function OT(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ws&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let S=_===Ms&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ji&&_!==cs&&!S&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(te("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&te("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&te("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:x,maxVaryings:E,maxFragmentUniforms:v,maxSamples:A,samples:T}}function BT(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ni,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,m=n.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let x=r?0:i,E=x*4,v=m.clippingState||null;l.value=v,v=u(g,d,E,f);for(let A=0;A!==E;++A)v[A]=e[A];m.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,g){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<m)&&(p=new Float32Array(m));for(let E=0,v=f;E!==y;++E,v+=4)o.copy(h[E]).applyMatrix4(x,a),o.normal.toArray(p,v),p[v+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var vc=class extends $i{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Kl(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new as(5,5,5),r=new ls({name:"CubemapFromEquirect",uniforms:Ao(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ti,blending:Mo});r.uniforms.tEquirect.value=e;let o=new fn(s,r),a=e.minFilter;return e.minFilter===vr&&(e.minFilter=Mi),new La(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},wx=256,kT=3,zT=20,Xx=256,Yx=16,HT=3,GT=new k,VT=new ie,dd=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new La(1,10,null),this._boxMesh=new fn(new as(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=GT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(VT));let p=new La(i,s,u);return p.position.copy(a),p.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ax(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Tx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(wx,rm(t))}_fromTexture(t,e){t.mapping===Eo||t.mapping===Fa?this._setSize(t.image.length===0?wx:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Ex(t,!1,!1),i=Math.log2(t)-kT;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ex(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Eo||t.mapping===Fa?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ax()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Tx()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=WT(),this._integrationMaterial=qT());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Yx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-HT)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Xx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=$T());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Ex(n,t,e){return new vc(n,{minFilter:vr,generateMipmaps:t,type:Ms,colorSpace:Bl,depthBuffer:e})}function bc(n,t,e){return new ls({name:n,uniforms:t,vertexShader:ye.cube_vert,fragmentShader:e,side:Ti,blending:Mo,depthTest:!1,depthWrite:!1})}function WT(){return bc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Xx}u

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
	`)}function qT(){return bc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Yx}},`

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
	`)}function $T(){return bc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${zT}
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
	`)}function Tx(){return bc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ax(){return bc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function XT(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Sh||f===Mh)if(t.has(d)){let g=t.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new vc(g.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Sh||f===Mh,y=f===Eo||f===Fa;if(g||y){let p=e.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new dd(n)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return g&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new dd(n)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function a(d,f){return f===Sh?d.mapping=Eo:f===Mh&&(d.mapping=Fa),d}function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function YT(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Nl("WebGLRenderer: "+i+" extension not supported."),s}}}function ZT(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(g){let y=g.attributes;for(let p in y)t.update(y[p],n.ARRAY_BUFFER)}function h(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,E=p.count>=65535?Xl:$l,v=new E(Math.ceil(x/3)*6,1),A=v.array;if(y!==null){let _=y.array;m=y.version;for(let S=0,L=0;S<x;S+=3){let I=_[S+0],D=_[S+1],B=_[S+2];A[L++]=I,A[L++]=D,A[L++]=D,A[L++]=B,A[L++]=B,A[L++]=I}}else{m=p.version;for(let _=0,S=0;_<x;_+=3){let L=_+0,I=_+1,D=_+2;A[S++]=L,A[S++]=I,A[S++]=I,A[S++]=D,A[S++]=D,A[S++]=L}}v.version=m;let T=r.get(g);T&&t.remove(T),r.set(g,v)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function jT(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function JT(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function KT(n,t,e){let i=new WeakMap,s=new gn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let L=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",L)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],E=0;f===!0&&(E=1),g===!0&&(E=2),y===!0&&(E=3);let v=a.attributes.position.count*E,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let T=new Float32Array(v*A*4*h),_=new Vl(T,v,A,h);_.type=cs,_.needsUpdate=!0;let S=E*4;for(let I=0;I<h;I++){let D=p[I],B=m[I],V=x[I],O=v*A*4*I;for(let $=0;$<D.count;$++){let Z=$*S;f===!0&&(s.fromBufferAttribute(D,$),T[O+Z+0]=s.x,T[O+Z+1]=s.y,T[O+Z+2]=s.z,T[O+Z+3]=0),g===!0&&(s.fromBufferAttribute(B,$),T[O+Z+4]=s.x,T[O+Z+5]=s.y,T[O+Z+6]=s.z,T[O+Z+7]=0),y===!0&&(s.fromBufferAttribute(V,$),T[O+Z+8]=s.x,T[O+Z+9]=s.y,T[O+Z+10]=s.z,T[O+Z+11]=V.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new qt(v,A)},i.set(a,d),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function QT(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var tA={[Fp]:"LINEAR_TONE_MAPPING",[Op]:"REINHARD_TONE_MAPPING",[Bp]:"CINEON_TONE_MAPPING",[kp]:"ACES_FILMIC_TONE_MAPPING",[Hp]:"AGX_TONE_MAPPING",[Gp]:"NEUTRAL_TONE_MAPPING",[zp]:"CUSTOM_TONE_MAPPING"};function eA(n,t,e,i,s,r){let o=new $i(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ae;u.setAttribute("position",new Pe([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Pe([0,2,0,0,2,0],2));let h=new ah({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new fn(u,h),f=new vh(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,x=null,E=[],v=!1;this.setSize=function(A,T){o.setSize(A,T),a!==null&&a.setSize(A,T),l!==null&&l.setSize(A,T);for(let _=0;_<E.length;_++){let S=E[_];S.setSize&&S.setSize(A,T)}},this.setEffects=function(A){E=A,v=E.length>0&&E[0].isRenderPass===!0;let T=o.width,_=o.height;E.length>0&&a===null&&(a=new $i(T,_,{type:Ms,depthBuffer:!1,stencilBuffer:!1}),l=new $i(T,_,{type:Ms,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&E.some(L=>L.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new xr(T,_),r===!0&&(c.format=br,c.type=To)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let L=0;L<E.length;L++){let I=E[L];I.setSize&&I.setSize(T,_),S&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(A,T){if(p||A.toneMapping===Zs&&E.length===0)return!1;if(x=T,T!==null){let _=T.width,S=T.height;(o.width!==_||o.height!==S)&&this.setSize(_,S)}return v===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=Zs,!0},this.hasRenderPass=function(){return v},this.end=function(A,T){A.toneMapping=m,p=!0;let _=o,S=a;for(let L=0;L<E.length;L++){let I=E[L];I.enabled!==!1&&(I.render(A,S,_,T),I.needsSwap!==!1&&(_=S,S=S===a?l:a))}if(g!==A.outputColorSpace||y!==A.toneMapping){g=A.outputColorSpace,y=A.toneMapping,h.defines={},Ce.getTransfer(g)===ke&&(h.defines.SRGB_TRANSFER="");let L=tA[y];L&&(h.defines[L]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(x),A.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Zx=new wi,jx=new xr(1,1),Jx=new tc(1),Kx=new Vl,Qx=new nh,ty=new Kl,Rx=[],Cx=[],Px=new Float32Array(16),Ix=new Float32Array(9),Lx=new Float32Array(4);function ka(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Rx[s];if(r===void 0&&(r=new Float32Array(s),Rx[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function kn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function zn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function pd(n,t){let e=Cx[t];e===void 0&&(e=new Int32Array(t),Cx[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function nA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function iA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(kn(e,t))return;n.uniform2fv(this.addr,t),zn(e,t)}}function sA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(kn(e,t))return;n.uniform3fv(this.addr,t),zn(e,t)}}function rA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(kn(e,t))return;n.uniform4fv(this.addr,t),zn(e,t)}}function oA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(kn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),zn(e,t)}else{if(kn(e,i))return;Lx.set(i),n.uniformMatrix2fv(this.addr,!1,Lx),zn(e,i)}}function aA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(kn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),zn(e,t)}else{if(kn(e,i))return;Ix.set(i),n.uniformMatrix3fv(this.addr,!1,Ix),zn(e,i)}}function lA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(kn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),zn(e,t)}else{if(kn(e,i))return;Px.set(i),n.uniformMatrix4fv(this.addr,!1,Px),zn(e,i)}}function cA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function uA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(kn(e,t))return;n.uniform2iv(this.addr,t),zn(e,t)}}function hA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(kn(e,t))return;n.uniform3iv(this.addr,t),zn(e,t)}}function dA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(kn(e,t))return;n.uniform4iv(this.addr,t),zn(e,t)}}function fA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function pA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(kn(e,t))return;n.uniform2uiv(this.addr,t),zn(e,t)}}function mA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(kn(e,t))return;n.uniform3uiv(this.addr,t),zn(e,t)}}function gA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(kn(e,t))return;n.uniform4uiv(this.addr,t),zn(e,t)}}function md(n){return n.version===0&&(n.compareFunction=em,n.needsUpdate=!0),n}function _A(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=md(jx):r=Zx,e.setTexture2D(t||r,s)}function xA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Qx,s)}function yA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=md(Jx):r=ty,e.setTextureCube(t||r,s)}function vA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Kx,s)}function bA(n){switch(n){case 5126:return nA;case 35664:return iA;case 35665:return sA;case 35666:return rA;case 35674:return oA;case 35675:return aA;case 35676:return lA;case 5124:case 35670:return cA;case 35667:case 35671:return uA;case 35668:case 35672:return hA;case 35669:case 35673:return dA;case 5125:return fA;case 36294:return pA;case 36295:return mA;case 36296:return gA;case 35678:case 36198:case 36298:case 36306:case 35682:return _A;case 35679:case 36299:case 36307:return xA;case 35680:case 36300:case 36308:case 36293:return yA;case 36289:case 36303:case 36311:case 36292:return vA}}function SA(n,t){n.uniform1fv(this.addr,t)}function MA(n,t){let e=ka(t,this.size,2);n.uniform2fv(this.addr,e)}function wA(n,t){let e=ka(t,this.size,3);n.uniform3fv(this.addr,e)}function EA(n,t){let e=ka(t,this.size,4);n.uniform4fv(this.addr,e)}function TA(n,t){let e=ka(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function AA(n,t){let e=ka(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function RA(n,t){let e=ka(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function CA(n,t){n.uniform1iv(this.addr,t)}function PA(n,t){n.uniform2iv(this.addr,t)}function IA(n,t){n.uniform3iv(this.addr,t)}function LA(n,t){n.uniform4iv(this.addr,t)}function DA(n,t){n.uniform1uiv(this.addr,t)}function NA(n,t){n.uniform2uiv(this.addr,t)}function UA(n,t){n.uniform3uiv(this.addr,t)}function FA(n,t){n.uniform4uiv(this.addr,t)}function OA(n,t,e){let i=this.cache,s=t.length,r=pd(e,s);kn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=md(jx):o=Zx;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function BA(n,t,e){let i=this.cache,s=t.length,r=pd(e,s);kn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Qx,r[o])}function kA(n,t,e){let i=this.cache,s=t.length,r=pd(e,s);kn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=md(Jx):o=ty;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function zA(n,t,e){let i=this.cache,s=t.length,r=pd(e,s);kn(i,r)||(n.uniform1iv(this.addr,r),zn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Kx,r[o])}function HA(n){switch(n){case 5126:return SA;case 35664:return MA;case 35665:return wA;case 35666:return EA;case 35674:return TA;case 35675:return AA;case 35676:return RA;case 5124:case 35670:return CA;case 35667:case 35671:return PA;case 35668:case 35672:return IA;case 35669:case 35673:return LA;case 5125:return DA;case 36294:return NA;case 36295:return UA;case 36296:return FA;case 35678:case 36198:case 36298:case 36306:case 35682:return OA;case 35679:case 36299:case 36307:return BA;case 35680:case 36300:case 36308:case 36293:return kA;case 36289:case 36303:case 36311:case 36292:return zA}}var pm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=bA(e.type)}},mm=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=HA(e.type)}},gm=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},dm=/(\w+)(\])?(\[|\.)?/g;function Dx(n,t){n.seq.push(t),n.map[t.id]=t}function GA(n,t,e){let i=n.name,s=i.length;for(dm.lastIndex=0;;){let r=dm.exec(i),o=dm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Dx(e,c===void 0?new pm(a,n,t):new mm(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new gm(a),Dx(e,h)),e=h}}}var Ba=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);GA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Nx(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var VA=37297,WA=0;function qA(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Ux=new ce;function $A(n){Ce._getMatrix(Ux,Ce.workingColorSpace,n);let t=`mat3( ${Ux.elements.map(e=>e.toFixed(4))} )`;switch(Ce.getTransfer(n)){case kl:return[t,"LinearTransferOETF"];case ke:return[t,"sRGBTransferOETF"];default:return te("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Fx(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+qA(n.getShaderSource(t),a)}else return r}function XA(n,t){let e=$A(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var YA={[Fp]:"Linear",[Op]:"Reinhard",[Bp]:"Cineon",[kp]:"ACESFilmic",[Hp]:"AgX",[Gp]:"Neutral",[zp]:"Custom"};function ZA(n,t){let e=YA[t];return e===void 0?(te("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var hd=new k;function jA(){Ce.getLuminanceCoefficients(hd);let n=hd.x.toFixed(4),t=hd.y.toFixed(4),e=hd.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function JA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(yc).join(`
`)}function KA(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function QA(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function yc(n){return n!==""}function Ox(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Bx(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var tR=/^[ \t]*#include +<([\w\d./]+)>/gm;function _m(n){return n.replace(tR,eR)}function eR(n,t){let e=ye[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return _m(e)}var nR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function kx(n){return n.replace(nR,iR)}function iR(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function zx(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var sR={[uc]:"SHADOWMAP_TYPE_PCF",[Na]:"SHADOWMAP_TYPE_VSM"};function rR(n){return sR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var oR={[Fa]:"ENVMAP_MODE_REFRACTION"};function aR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":oR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var lR={[Up]:"ENVMAP_BLENDING_MULTIPLY",[sx]:"ENVMAP_BLENDING_MIX",[rx]:"ENVMAP_BLENDING_ADD"};function cR(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":lR[n.combine]||"ENVMAP_BLENDING_NONE"}function uR(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=rR(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=aR(e),h=cR(e),d=JA(e),f=KA(r),g=s.createProgram(),y,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(yc).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(yc).join(`
`),p.length>0&&(p+=`
`)):(y=[zx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(yc).join(`
`),p=[zx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Zs?"#define TONE_MAPPING":"",e.toneMapping!==Zs?ye.tonemapping_pars_fragment:"",e.toneMapping!==Zs?ZA("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ye.colorspace_pars_fragment,XA("linearToOutputTexel",e.outputColorSpace),jA(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(yc).join(`
`)),o=_m(o),o=Ox(o,e),o=Bx(o,e),a=_m(a),a=Ox(a,e),a=Bx(a,e),o=kx(o),a=kx(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===im?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===im?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=m+y+o,E=m+p+a,v=Nx(s,s.VERTEX_SHADER,x),A=Nx(s,s.FRAGMENT_SHADER,E);s.attachShader(g,v),s.attachShader(g,A),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(I){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(v)||"",V=s.getShaderInfoLog(A)||"",O=D.trim(),$=B.trim(),Z=V.trim(),q=!0,ht=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(q=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,v,A);else{let K=Fx(s,v,"vertex"),tt=Fx(s,A,"fragment");re("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+O+`
`+K+`
`+tt)}else O!==""?te("WebGLProgram: Program Info Log:",O):($===""||Z==="")&&(ht=!1);ht&&(I.diagnostics={runnable:q,programLog:O,vertexShader:{log:$,prefix:y},fragmentShader:{log:Z,prefix:p}})}s.deleteShader(v),s.deleteShader(A),_=new Ba(s,g),S=QA(s,g)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let S;this.getAttributes=function(){return S===void 0&&T(this),S};let L=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,VA)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=WA++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=A,this}var hR=0,xm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new ym(t),e.set(t,i)),i}},ym=class{constructor(t){this.id=hR++,this.code=t,this.usedTimes=0}};function dR(n){return n===Kr||n===gc||n===_c}function fR(n,t,e,i,s,r){let o=new Ta,a=new xm,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,S,L,I,D,B){let V=I.fog,O=D.geometry,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?I.environment:null,Z=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,q=t.get(_.envMap||$,Z),ht=d[_.type],K=i.precision;_.precision!==null&&(K=i.getMaxPrecision(_.precision),K!==_.precision&&te("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let tt=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,ot=tt!==void 0?tt.length:0,mt=0;O.morphAttributes.position!==void 0&&(mt=1),O.morphAttributes.normal!==void 0&&(mt=2),O.morphAttributes.color!==void 0&&(mt=3);let pt,et,vt,Mt;if(ht){let Dt=Js[ht];pt=Dt.vertexShader,et=Dt.fragmentShader}else{pt=_.vertexShader,et=_.fragmentShader;let Dt=a.getVertexShaderStage(_),me=a.getFragmentShaderStage(_);a.update(_,Dt,me),vt=Dt.id,Mt=me.id}let Lt=n.getRenderTarget(),At=n.state.buffers.depth.getReversed(),jt=D.isInstancedMesh===!0,fe=D.isBatchedMesh===!0,Xt=!!_.map,ve=!!_.matcap,_e=!!q,he=_e&&q.isPMREMTexture===!0,cn=!!_.aoMap,tn=!!_.lightMap,An=!!_.bumpMap&&_.wireframe===!1,qe=!!_.normalMap,$n=!!_.displacementMap,Le=!!_.emissiveMap,On=!!_.metalnessMap,xn=!!_.roughnessMap,Rn=_.anisotropy>0,H=_.clearcoat>0,Nt=_.diffuseRoughness>0,ee=_.dispersion>0,pe=_.retroreflectivity>0,Rt=_.iridescence>0,Ze=_.sheen>0,$t=_.transmission>0,Qt=Rn&&!!_.anisotropyMap,N=H&&!!_.clearcoatMap,R=H&&!!_.clearcoatNormalMap,X=H&&!!_.clearcoatRoughnessMap,dt=Nt&&!!_.diffuseRoughnessMap,lt=Rt&&!!_.iridescenceMap,St=Rt&&!!_.iridescenceThicknessMap,wt=Ze&&!!_.sheenColorMap,nt=Ze&&!!_.sheenRoughnessMap,rt=!!_.specularMap,xt=!!_.specularColorMap,z=!!_.specularIntensityMap,at=$t&&!!_.transmissionMap,it=$t&&!!_.thicknessMap,Ct=!!_.gradientMap,bt=!!_.alphaMap,Tt=_.alphaTest>0,Zt=!!_.alphaHash,oe=!!_.extensions,ut=Zs;_.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(ut=n.toneMapping);let Gt=he?q.isCompressedCubeTexture?q.image[0].mipmaps:q.mipmaps:null,ae={shaderID:ht,shaderType:_.type,shaderName:_.name,vertexShader:pt,fragmentShader:et,defines:_.defines,customVertexShaderID:vt,customFragmentShaderID:Mt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:fe,batchingColor:fe&&D._colorsTexture!==null,instancing:jt,instancingColor:jt&&D.instanceColor!==null,instancingMorph:jt&&D.morphTexture!==null,outputColorSpace:Lt===null?n.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:Ce.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Xt,matcap:ve,envMap:_e,envMapMode:_e&&q.mapping,envMapPMREM:he,envMapMaxLod:he?Gt.length-1:null,envMapSize:he?Gt[0].width:null,aoMap:cn,lightMap:tn,bumpMap:An,normalMap:qe,displacementMap:$n,emissiveMap:Le,normalMapObjectSpace:qe&&_.normalMapType===lx,normalMapTangentSpace:qe&&_.normalMapType===jp,packedNormalMap:qe&&_.normalMapType===jp&&dR(_.normalMap.format),metalnessMap:On,roughnessMap:xn,anisotropy:Rn,anisotropyMap:Qt,clearcoat:H,clearcoatMap:N,clearcoatNormalMap:R,clearcoatRoughnessMap:X,diffuseRoughness:Nt,diffuseRoughnessMap:dt,dispersion:ee,retroreflection:pe,iridescence:Rt,iridescenceMap:lt,iridescenceThicknessMap:St,sheen:Ze,sheenColorMap:wt,sheenRoughnessMap:nt,specularMap:rt,specularColorMap:xt,specularIntensityMap:z,transmission:$t,transmissionMap:at,thicknessMap:it,gradientMap:Ct,opaque:_.transparent===!1&&_.blending===Ua&&_.alphaToCoverage===!1,alphaMap:bt,alphaTest:Tt,alphaHash:Zt,combine:_.combine,mapUv:Xt&&f(_.map.channel),aoMapUv:cn&&f(_.aoMap.channel),lightMapUv:tn&&f(_.lightMap.channel),bumpMapUv:An&&f(_.bumpMap.channel),normalMapUv:qe&&f(_.normalMap.channel),displacementMapUv:$n&&f(_.displacementMap.channel),emissiveMapUv:Le&&f(_.emissiveMap.channel),metalnessMapUv:On&&f(_.metalnessMap.channel),roughnessMapUv:xn&&f(_.roughnessMap.channel),anisotropyMapUv:Qt&&f(_.anisotropyMap.channel),clearcoatMapUv:N&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:lt&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:St&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(_.sheenRoughnessMap.channel),specularMapUv:rt&&f(_.specularMap.channel),specularColorMapUv:xt&&f(_.specularColorMap.channel),specularIntensityMapUv:z&&f(_.specularIntensityMap.channel),transmissionMapUv:at&&f(_.transmissionMap.channel),thicknessMapUv:it&&f(_.thicknessMap.channel),alphaMapUv:bt&&f(_.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(qe||Rn),vertexNormals:!!O.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!O.attributes.uv&&(Xt||bt),fog:!!V,useFog:_.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||O.attributes.normal===void 0&&qe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:At,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:ot,morphTextureStride:mt,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:B.filter(Dt=>Dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:ut,decodeVideoTexture:Xt&&_.map.isVideoTexture===!0&&Ce.getTransfer(_.map.colorSpace)===ke,decodeVideoTextureEmissive:Le&&_.emissiveMap.isVideoTexture===!0&&Ce.getTransfer(_.emissiveMap.colorSpace)===ke,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Di,flipSided:_.side===Ti,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:oe&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(oe&&_.extensions.multiDraw===!0||fe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ae.vertexUv1s=l.has(1),ae.vertexUv2s=l.has(2),ae.vertexUv3s=l.has(3),l.clear(),ae}function y(_){let S=[];if(_.shaderID?S.push(_.shaderID):(S.push(_.customVertexShaderID),S.push(_.customFragmentShaderID)),_.defines!==void 0)for(let L in _.defines)S.push(L),S.push(_.defines[L]);return _.isRawShaderMaterial===!1&&(p(S,_),m(S,_),S.push(n.outputColorSpace)),S.push(_.customProgramCacheKey),S.join()}function p(_,S){_.push(S.precision),_.push(S.outputColorSpace),_.push(S.envMapMode),_.push(S.envMapPMREM),_.push(S.envMapMaxLod),_.push(S.envMapSize),_.push(S.mapUv),_.push(S.alphaMapUv),_.push(S.lightMapUv),_.push(S.aoMapUv),_.push(S.bumpMapUv),_.push(S.normalMapUv),_.push(S.displacementMapUv),_.push(S.emissiveMapUv),_.push(S.metalnessMapUv),_.push(S.roughnessMapUv),_.push(S.anisotropyMapUv),_.push(S.clearcoatMapUv),_.push(S.clearcoatNormalMapUv),_.push(S.clearcoatRoughnessMapUv),_.push(S.diffuseRoughnessMapUv),_.push(S.iridescenceMapUv),_.push(S.iridescenceThicknessMapUv),_.push(S.sheenColorMapUv),_.push(S.sheenRoughnessMapUv),_.push(S.specularMapUv),_.push(S.specularColorMapUv),_.push(S.specularIntensityMapUv),_.push(S.transmissionMapUv),_.push(S.thicknessMapUv),_.push(S.combine),_.push(S.fogExp2),_.push(S.sizeAttenuation),_.push(S.morphTargetsCount),_.push(S.numSunLights),_.push(S.numDirLights),_.push(S.numPointLights),_.push(S.numSpotLights),_.push(S.numSpotLightMaps),_.push(S.numHemiLights),_.push(S.numRectAreaLights),_.push(S.numSunLightShadows),_.push(S.numDirLightShadows),_.push(S.numPointLightShadows),_.push(S.numSpotLightShadows),_.push(S.numSpotLightShadowsWithMaps),_.push(S.numLightProbes),_.push(S.numLightProbeGrids),_.push(S.shadowMapType),_.push(S.toneMapping),_.push(S.numClippingPlanes),_.push(S.numClipIntersection),_.push(S.depthPacking)}function m(_,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let S=d[_.type],L;if(S){let I=Js[S];L=bx.clone(I.uniforms)}else L=_.uniforms;return L}function E(_,S){let L=u.get(S);return L!==void 0?++L.usedTimes:(L=new uR(n,S,_,s),c.push(L),u.set(S,L)),L}function v(_){if(--_.usedTimes===0){let S=c.indexOf(_);c[S]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:E,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:T}}function pR(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function mR(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Hx(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Gx(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=g,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=p,x.group=m),t++,x}function l(d,f,g,y,p,m,x){x.reversedDepth===!0&&(p=-p);let E=a(d,f,g,y,p,m);g.transmission>0?i.push(E):g.transparent===!0?s.push(E):e.push(E)}function c(d,f,g,y,p,m){let x=a(d,f,g,y,p,m);g.transmission>0?i.unshift(x):g.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||mR),i.length>1&&i.sort(f||Hx),s.length>1&&s.sort(f||Hx)}function h(){for(let d=t,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function gR(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Gx,n.set(i,[o])):s>=r.length?(o=new Gx,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function _R(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new k,color:new ie};break;case"SpotLight":e={position:new k,direction:new k,color:new ie,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new k,color:new ie,distance:0,decay:0};break;case"HemisphereLight":e={direction:new k,skyColor:new ie,groundColor:new ie};break;case"RectAreaLight":e={color:new ie,position:new k,halfWidth:new k,halfHeight:new k};break}return n[t.id]=e,e}}}function xR(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var yR=0;function vR(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function bR(n){let t=new _R,e=xR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new k);let s=new k,r=new ge,o=new ge;function a(c){let u=0,h=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,x=0,E=0,v=0,A=0,T=0,_=0,S=0,L=0,I=0;c.sort(vR);for(let B=0,V=c.length;B<V;B++){let O=c[B],$=O.color,Z=O.intensity,q=O.distance,ht=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===Kr?ht=O.shadow.map.texture:ht=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)u+=$.r*Z,h+=$.g*Z,d+=$.b*Z;else if(O.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(O.sh.coefficients[K],Z);I++}else if(O.isSunLight){let K=t.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let tt=O.shadow,ot=e.get(O);ot.shadowIntensity=tt.intensity,ot.shadowBias=tt.bias,ot.shadowNormalBias=tt.normalBias,ot.shadowRadius=tt.radius,ot.shadowMapSize.copy(tt.mapSize).multiply(tt.getFrameExtents()),i.sunShadow[g]=ot,i.sunShadowMap[g]=ht;let mt=tt.getViewportCount();for(let pt=0;pt<mt;pt++)i.sunShadowMatrix[y+pt]=tt.getMatrix(pt),i.sunShadowCascade[y+pt]=tt._cascadeData[pt];y+=mt,g++}i.sun[f]=K,f++}else if(O.isDirectionalLight){let K=t.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let tt=O.shadow,ot=e.get(O);ot.shadowIntensity=tt.intensity,ot.shadowBias=tt.bias,ot.shadowNormalBias=tt.normalBias,ot.shadowRadius=tt.radius,ot.shadowMapSize=tt.mapSize,i.directionalShadow[p]=ot,i.directionalShadowMap[p]=ht,i.directionalShadowMatrix[p]=O.shadow.matrix,A++}i.directional[p]=K,p++}else if(O.isSpotLight){let K=t.get(O);K.position.setFromMatrixPosition(O.matrixWorld),K.color.copy($).multiplyScalar(Z),K.distance=q,K.coneCos=Math.cos(O.angle),K.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),K.decay=O.decay,i.spot[x]=K;let tt=O.shadow;if(O.map&&(i.spotLightMap[S]=O.map,S++,tt.updateMatrices(O),O.castShadow&&L++),i.spotLightMatrix[x]=tt.matrix,O.castShadow){let ot=e.get(O);ot.shadowIntensity=tt.intensity,ot.shadowBias=tt.bias,ot.shadowNormalBias=tt.normalBias,ot.shadowRadius=tt.radius,ot.shadowMapSize=tt.mapSize,i.spotShadow[x]=ot,i.spotShadowMap[x]=ht,_++}x++}else if(O.isRectAreaLight){let K=t.get(O);K.color.copy($).multiplyScalar(Z),K.halfWidth.set(O.width*.5,0,0),K.halfHeight.set(0,O.height*.5,0),i.rectArea[E]=K,E++}else if(O.isPointLight){let K=t.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),K.distance=O.distance,K.decay=O.decay,O.castShadow){let tt=O.shadow,ot=e.get(O);ot.shadowIntensity=tt.intensity,ot.shadowBias=tt.bias,ot.shadowNormalBias=tt.normalBias,ot.shadowRadius=tt.radius,ot.shadowMapSize=tt.mapSize,ot.shadowCameraNear=tt.camera.near,ot.shadowCameraFar=tt.camera.far,i.pointShadow[m]=ot,i.pointShadowMap[m]=ht,i.pointShadowMatrix[m]=O.shadow.matrix,T++}i.point[m]=K,m++}else if(O.isHemisphereLight){let K=t.get(O);K.skyColor.copy(O.color).multiplyScalar(Z),K.groundColor.copy(O.groundColor).multiplyScalar(Z),i.hemi[v]=K,v++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ot.LTC_FLOAT_1,i.rectAreaLTC2=Ot.LTC_FLOAT_2):(i.rectAreaLTC1=Ot.LTC_HALF_1,i.rectAreaLTC2=Ot.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==x||D.rectAreaLength!==E||D.hemiLength!==v||D.numSunShadows!==g||D.numDirectionalShadows!==A||D.numPointShadows!==T||D.numSpotShadows!==_||D.numSpotMaps!==S||D.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=p,i.spot.length=x,i.rectArea.length=E,i.point.length=m,i.hemi.length=v,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+S-L,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=I,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=x,D.rectAreaLength=E,D.hemiLength=v,D.numSunShadows=g,D.numDirectionalShadows=A,D.numPointShadows=T,D.numSpotShadows=_,D.numSpotMaps=S,D.numLightProbes=I,i.version=yR++)}function l(c,u){let h=0,d=0,f=0,g=0,y=0,p=0,m=u.matrixWorldInverse;for(let x=0,E=c.length;x<E;x++){let v=c[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),d++}else if(v.isSpotLight){let A=i.spot[g];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),g++}else if(v.isRectAreaLight){let A=i.rectArea[y];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let A=i.hemi[p];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function Vx(n){let t=new bR(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function SR(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Vx(n),t.set(s,[a])):r>=o.length?(a=new Vx(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var MR=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,wR=`uniform sampler2D shadow_pass;
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
}`,ER=[new k(1,0,0),new k(-1,0,0),new k(0,1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1)],TR=[new k(0,-1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1),new k(0,-1,0),new k(0,-1,0)],Wx=new ge,xc=new k,fm=new k;function AR(n,t,e){let i=new vo,s=new qt,r=new qt,o=new gn,a=new lh,l=new ch,c={},u=e.maxTextureSize,h={[Jr]:Ti,[Ti]:Jr,[Di]:Di},d=new ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qt},radius:{value:4}},vertexShader:MR,fragmentShader:wR}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Ae;g.setAttribute("position",new je(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new fn(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=uc;let m=this.type;this.render=function(T,_,S){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===k_&&(te("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=uc);let L=n.getRenderTarget(),I=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Mo),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=m!==this.type;V&&_.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach($=>$.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,$=T.length;O<$;O++){let Z=T[O],q=Z.shadow;if(q===void 0){te("WebGLShadowMap:",Z,"has no shadow.");continue}if(q.autoUpdate===!1&&q.needsUpdate===!1)continue;s.copy(q.mapSize);let ht=q.getFrameExtents();s.multiply(ht),r.copy(q.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,q.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,q.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(q.camera._reversedDepth=K,q.map===null||V===!0){if(q.map!==null&&(q.map.depthTexture!==null&&(q.map.depthTexture.dispose(),q.map.depthTexture=null),q.map.dispose()),this.type===Na){if(Z.isPointLight){te("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}q.map=new $i(s.x,s.y,{format:Kr,type:Ms,minFilter:Mi,magFilter:Mi,generateMipmaps:!1}),q.map.texture.name=Z.name+".shadowMap",q.map.depthTexture=new xr(s.x,s.y,cs),q.map.depthTexture.name=Z.name+".shadowMapDepth",q.map.depthTexture.format=mr,q.map.depthTexture.compareFunction=null,q.map.depthTexture.minFilter=Kn,q.map.depthTexture.magFilter=Kn}else Z.isPointLight?(q.map=new vc(s.x),q.map.depthTexture=new tc(s.x,Ss)):(q.map=new $i(s.x,s.y),q.map.depthTexture=new xr(s.x,s.y,Ss)),q.map.depthTexture.name=Z.name+".shadowMap",q.map.depthTexture.format=mr,this.type===uc?(q.map.depthTexture.compareFunction=K?tm:Qp,q.map.depthTexture.minFilter=Mi,q.map.depthTexture.magFilter=Mi):(q.map.depthTexture.compareFunction=null,q.map.depthTexture.minFilter=Kn,q.map.depthTexture.magFilter=Kn);q.camera.updateProjectionMatrix()}q.map.isWebGLCubeRenderTarget!==!0&&(q.map.width!==s.x||q.map.height!==s.y)&&q.map.setSize(s.x,s.y);let tt=q.map.isWebGLCubeRenderTarget?6:q.getViewportCount();Z.isPointLight!==!0&&q.updateMatrices(Z,S);let ot=(q.camera.layers.mask&4294967294)!==0?q.camera.layers:S.layers;for(let mt=0;mt<tt;mt++){let pt=q.getCamera(mt);if(Z.isPointLight){let et=q.camera,vt=q.matrix,Mt=Z.distance||et.far;Mt!==et.far&&(et.far=Mt,et.updateProjectionMatrix()),xc.setFromMatrixPosition(Z.matrixWorld),et.position.copy(xc),fm.copy(et.position),fm.add(ER[mt]),et.up.copy(TR[mt]),et.lookAt(fm),et.updateMatrixWorld(),vt.makeTranslation(-xc.x,-xc.y,-xc.z),Wx.multiplyMatrices(et.projectionMatrix,et.matrixWorldInverse),q._frustum.setFromProjectionMatrix(Wx,et.coordinateSystem,et.reversedDepth)}if(q.map.isWebGLCubeRenderTarget)n.setRenderTarget(q.map,mt),n.clear();else{mt===0&&(n.setRenderTarget(q.map),n.clear());let et=q.getViewport(mt);o.set(r.x*et.x,r.y*et.y,r.x*et.z,r.y*et.w),B.viewport(o)}i=q.getFrustum(mt),v(_,S,pt,Z,ot,this.type)}q.isPointLightShadow!==!0&&this.type===Na&&x(q,S),q.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(L,I,D)};function x(T,_){let S=t.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new $i(s.x,s.y,{format:Kr,type:Ms}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(_,null,S,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(_,null,S,f,y,null)}function E(T,_,S,L){let I=null,D=S.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(D!==void 0)I=D;else if(I=S.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let B=I.uuid,V=_.uuid,O=c[B];O===void 0&&(O={},c[B]=O);let $=O[V];$===void 0&&($=I.clone(),O[V]=$,_.addEventListener("dispose",A)),I=$}if(I.visible=_.visible,I.wireframe=_.wireframe,L===Na?I.side=_.shadowSide!==null?_.shadowSide:_.side:I.side=_.shadowSide!==null?_.shadowSide:h[_.side],I.alphaMap=_.alphaMap,I.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,I.map=_.map,I.clipShadows=_.clipShadows,I.clippingPlanes=_.clippingPlanes,I.clipIntersection=_.clipIntersection,I.displacementMap=_.displacementMap,I.displacementScale=_.displacementScale,I.displacementBias=_.displacementBias,I.wireframeLinewidth=_.wireframeLinewidth,I.linewidth=_.linewidth,S.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=n.properties.get(I);B.light=S}return I}function v(T,_,S,L,I,D){if(T.visible===!1)return;if(T.layers.test(I)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&D===Na)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,T.matrixWorld);let O=t.update(T),$=T.material;if(Array.isArray($)){let Z=O.groups;for(let q=0,ht=Z.length;q<ht;q++){let K=Z[q],tt=$[K.materialIndex];if(tt&&tt.visible){let ot=E(T,tt,L,D);T.onBeforeShadow(n,T,_,S,O,ot,K),n.renderBufferDirect(S,null,O,ot,T,K),T.onAfterShadow(n,T,_,S,O,ot,K)}}}else if($.visible){let Z=E(T,$,L,D);T.onBeforeShadow(n,T,_,S,O,Z,null),n.renderBufferDirect(S,null,O,Z,T,null),T.onAfterShadow(n,T,_,S,O,Z,null)}}let V=T.children;for(let O=0,$=V.length;O<$;O++)v(V[O],_,S,L,I,D)}function A(T){T.target.removeEventListener("dispose",A);for(let S in c){let L=c[S],I=T.target.uuid;I in L&&(L[I].dispose(),delete L[I])}}}function RR(n,t){function e(){let z=!1,at=new gn,it=null,Ct=new gn(0,0,0,0);return{setMask:function(bt){it!==bt&&!z&&(n.colorMask(bt,bt,bt,bt),it=bt)},setLocked:function(bt){z=bt},setClear:function(bt,Tt,Zt,oe,ut){ut===!0&&(bt*=oe,Tt*=oe,Zt*=oe),at.set(bt,Tt,Zt,oe),Ct.equals(at)===!1&&(n.clearColor(bt,Tt,Zt,oe),Ct.copy(at))},reset:function(){z=!1,it=null,Ct.set(-1,0,0,0)}}}function i(){let z=!1,at=!1,it=null,Ct=null,bt=null;return{setReversed:function(Tt){if(at!==Tt){let Zt=t.get("EXT_clip_control");Tt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT),at=Tt;let oe=bt;bt=null,this.setClear(oe)}},getReversed:function(){return at},setTest:function(Tt){Tt?At(n.DEPTH_TEST):jt(n.DEPTH_TEST)},setMask:function(Tt){it!==Tt&&!z&&(n.depthMask(Tt),it=Tt)},setFunc:function(Tt){if(at&&(Tt=xx[Tt]),Ct!==Tt){switch(Tt){case Wu:n.depthFunc(n.NEVER);break;case qu:n.depthFunc(n.ALWAYS);break;case $u:n.depthFunc(n.LESS);break;case Sa:n.depthFunc(n.LEQUAL);break;case Xu:n.depthFunc(n.EQUAL);break;case Yu:n.depthFunc(n.GEQUAL);break;case Zu:n.depthFunc(n.GREATER);break;case ju:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ct=Tt}},setLocked:function(Tt){z=Tt},setClear:function(Tt){bt!==Tt&&(bt=Tt,at&&(Tt=1-Tt),n.clearDepth(Tt))},reset:function(){z=!1,it=null,Ct=null,bt=null,at=!1}}}function s(){let z=!1,at=null,it=null,Ct=null,bt=null,Tt=null,Zt=null,oe=null,ut=null;return{setTest:function(Gt){z||(Gt?At(n.STENCIL_TEST):jt(n.STENCIL_TEST))},setMask:function(Gt){at!==Gt&&!z&&(n.stencilMask(Gt),at=Gt)},setFunc:function(Gt,ae,Dt){(it!==Gt||Ct!==ae||bt!==Dt)&&(n.stencilFunc(Gt,ae,Dt),it=Gt,Ct=ae,bt=Dt)},setOp:function(Gt,ae,Dt){(Tt!==Gt||Zt!==ae||oe!==Dt)&&(n.stencilOp(Gt,ae,Dt),Tt=Gt,Zt=ae,oe=Dt)},setLocked:function(Gt){z=Gt},setClear:function(Gt){ut!==Gt&&(n.clearStencil(Gt),ut=Gt)},reset:function(){z=!1,at=null,it=null,Ct=null,bt=null,Tt=null,Zt=null,oe=null,ut=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,E=null,v=null,A=null,T=null,_=null,S=new ie(0,0,0),L=0,I=!1,D=null,B=null,V=null,O=null,$=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,ht=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(K)[1]),q=ht>=1):K.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),q=ht>=2);let tt=null,ot={},mt=n.getParameter(n.SCISSOR_BOX),pt=n.getParameter(n.VIEWPORT),et=new gn().fromArray(mt),vt=new gn().fromArray(pt);function Mt(z,at,it,Ct){let bt=new Uint8Array(4),Tt=n.createTexture();n.bindTexture(z,Tt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<it;Zt++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(at,0,n.RGBA,1,1,Ct,0,n.RGBA,n.UNSIGNED_BYTE,bt):n.texImage2D(at+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,bt);return Tt}let Lt={};Lt[n.TEXTURE_2D]=Mt(n.TEXTURE_2D,n.TEXTURE_2D,1),Lt[n.TEXTURE_CUBE_MAP]=Mt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[n.TEXTURE_2D_ARRAY]=Mt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Lt[n.TEXTURE_3D]=Mt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),At(n.DEPTH_TEST),o.setFunc(Sa),An(!1),qe(Cp),At(n.CULL_FACE),cn(Mo);function At(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function jt(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function fe(z,at){return d[z]!==at?(n.bindFramebuffer(z,at),d[z]=at,z===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=at),z===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=at),!0):!1}function Xt(z,at){let it=g,Ct=!1;if(z){it=f.get(at),it===void 0&&(it=[],f.set(at,it));let bt=z.textures;if(it.length!==bt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Tt=0,Zt=bt.length;Tt<Zt;Tt++)it[Tt]=n.COLOR_ATTACHMENT0+Tt;it.length=bt.length,Ct=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Ct=!0);Ct&&n.drawBuffers(it)}function ve(z){return y!==z?(n.useProgram(z),y=z,!0):!1}let _e={[wo]:n.FUNC_ADD,[H_]:n.FUNC_SUBTRACT,[G_]:n.FUNC_REVERSE_SUBTRACT};_e[V_]=n.MIN,_e[W_]=n.MAX;let he={[q_]:n.ZERO,[$_]:n.ONE,[X_]:n.SRC_COLOR,[Dp]:n.SRC_ALPHA,[Q_]:n.SRC_ALPHA_SATURATE,[J_]:n.DST_COLOR,[Z_]:n.DST_ALPHA,[Y_]:n.ONE_MINUS_SRC_COLOR,[Np]:n.ONE_MINUS_SRC_ALPHA,[K_]:n.ONE_MINUS_DST_COLOR,[j_]:n.ONE_MINUS_DST_ALPHA,[tx]:n.CONSTANT_COLOR,[ex]:n.ONE_MINUS_CONSTANT_COLOR,[nx]:n.CONSTANT_ALPHA,[ix]:n.ONE_MINUS_CONSTANT_ALPHA};function cn(z,at,it,Ct,bt,Tt,Zt,oe,ut,Gt){if(z===Mo){p===!0&&(jt(n.BLEND),p=!1);return}if(p===!1&&(At(n.BLEND),p=!0),z!==z_){if(z!==m||Gt!==I){if((x!==wo||A!==wo)&&(n.blendEquation(n.FUNC_ADD),x=wo,A=wo),Gt)switch(z){case Ua:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Pp:n.blendFunc(n.ONE,n.ONE);break;case Ip:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Lp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:re("WebGLState: Invalid blending: ",z);break}else switch(z){case Ua:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Pp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ip:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Lp:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",z);break}E=null,v=null,T=null,_=null,S.set(0,0,0),L=0,m=z,I=Gt}return}bt=bt||at,Tt=Tt||it,Zt=Zt||Ct,(at!==x||bt!==A)&&(n.blendEquationSeparate(_e[at],_e[bt]),x=at,A=bt),(it!==E||Ct!==v||Tt!==T||Zt!==_)&&(n.blendFuncSeparate(he[it],he[Ct],he[Tt],he[Zt]),E=it,v=Ct,T=Tt,_=Zt),(oe.equals(S)===!1||ut!==L)&&(n.blendColor(oe.r,oe.g,oe.b,ut),S.copy(oe),L=ut),m=z,I=!1}function tn(z,at){z.side===Di?jt(n.CULL_FACE):At(n.CULL_FACE);let it=z.side===Ti;at&&(it=!it),An(it),z.blending===Ua&&z.transparent===!1?cn(Mo):cn(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Ct=z.stencilWrite;a.setTest(Ct),Ct&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),Le(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?At(n.SAMPLE_ALPHA_TO_COVERAGE):jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function An(z){D!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),D=z)}function qe(z){z!==O_?(At(n.CULL_FACE),z!==B&&(z===Cp?n.cullFace(n.BACK):z===B_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):jt(n.CULL_FACE),B=z}function $n(z){z!==V&&(q&&n.lineWidth(z),V=z)}function Le(z,at,it){z?(At(n.POLYGON_OFFSET_FILL),(O!==at||$!==it)&&(O=at,$=it,o.getReversed()&&(at=-at,it=-it),n.polygonOffset(at,it))):jt(n.POLYGON_OFFSET_FILL)}function On(z){z?At(n.SCISSOR_TEST):jt(n.SCISSOR_TEST)}function xn(z){z===void 0&&(z=n.TEXTURE0+Z-1),tt!==z&&(n.activeTexture(z),tt=z)}function Rn(z,at,it){it===void 0&&(tt===null?it=n.TEXTURE0+Z-1:it=tt);let Ct=ot[it];Ct===void 0&&(Ct={type:void 0,texture:void 0},ot[it]=Ct),(Ct.type!==z||Ct.texture!==at)&&(tt!==it&&(n.activeTexture(it),tt=it),n.bindTexture(z,at||Lt[z]),Ct.type=z,Ct.texture=at)}function H(){let z=ot[tt];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Nt(){try{n.compressedTexImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function ee(){try{n.compressedTexImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function pe(){try{n.texSubImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function Rt(){try{n.texSubImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function Ze(){try{n.compressedTexSubImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function $t(){try{n.compressedTexSubImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function Qt(){try{n.texStorage2D(...arguments)}catch(z){re("WebGLState:",z)}}function N(){try{n.texStorage3D(...arguments)}catch(z){re("WebGLState:",z)}}function R(){try{n.texImage2D(...arguments)}catch(z){re("WebGLState:",z)}}function X(){try{n.texImage3D(...arguments)}catch(z){re("WebGLState:",z)}}function dt(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function lt(z,at){h[z]!==at&&(n.pixelStorei(z,at),h[z]=at)}function St(z){et.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),et.copy(z))}function wt(z){vt.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),vt.copy(z))}function nt(z,at){let it=c.get(at);it===void 0&&(it=new WeakMap,c.set(at,it));let Ct=it.get(z);Ct===void 0&&(Ct=n.getUniformBlockIndex(at,z.name),n.uniformBlockBinding(at,Ct,Ct),it.set(z,Ct))}function rt(z,at,it){let bt=c.get(at).get(z);l[bt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,bt,it),l[bt]=it)}function xt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},tt=null,ot={},d={},l={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,E=null,v=null,A=null,T=null,_=null,S=new ie(0,0,0),L=0,I=!1,D=null,B=null,V=null,O=null,$=null,et.set(0,0,n.canvas.width,n.canvas.height),vt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:At,disable:jt,bindFramebuffer:fe,drawBuffers:Xt,useProgram:ve,setBlending:cn,setMaterial:tn,setFlipSided:An,setCullFace:qe,setLineWidth:$n,setPolygonOffset:Le,setScissorTest:On,activeTexture:xn,bindTexture:Rn,unbindTexture:H,compressedTexImage2D:Nt,compressedTexImage3D:ee,texImage2D:R,texImage3D:X,pixelStorei:lt,getParameter:dt,updateUBOMapping:nt,uniformBlockBinding:rt,texStorage2D:Qt,texStorage3D:N,texSubImage2D:pe,texSubImage3D:Rt,compressedTexSubImage2D:Ze,compressedTexSubImage3D:$t,scissor:St,viewport:wt,reset:xt}}function CR(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new qt,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(N=>g.delete(N)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(N,R){return p?new OffscreenCanvas(N,R):Hl("canvas")}function x(N,R,X){let dt=1,lt=Qt(N);if((lt.width>X||lt.height>X)&&(dt=X/Math.max(lt.width,lt.height)),dt<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let St=Math.floor(dt*lt.width),wt=Math.floor(dt*lt.height);d===void 0&&(d=m(St,wt));let nt=R?m(St,wt):d;return nt.width=St,nt.height=wt,nt.getContext("2d").drawImage(N,0,0,St,wt),te("WebGLRenderer: Texture has been resized from ("+lt.width+"x"+lt.height+") to ("+St+"x"+wt+")."),nt}else return"data"in N&&te("WebGLRenderer: Image in DataTexture is too big ("+lt.width+"x"+lt.height+")."),N;return N}function E(N){return N.generateMipmaps}function v(N){n.generateMipmap(N)}function A(N){return N.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?n.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(N,R,X,dt,lt,St=!1){if(N!==null){if(n[N]!==void 0)return n[N];te("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let wt;dt&&(wt=t.get("EXT_texture_norm16"),wt||te("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=R;if(R===n.RED&&(X===n.FLOAT&&(nt=n.R32F),X===n.HALF_FLOAT&&(nt=n.R16F),X===n.UNSIGNED_BYTE&&(nt=n.R8),X===n.UNSIGNED_SHORT&&wt&&(nt=wt.R16_EXT),X===n.SHORT&&wt&&(nt=wt.R16_SNORM_EXT)),R===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.R8UI),X===n.UNSIGNED_SHORT&&(nt=n.R16UI),X===n.UNSIGNED_INT&&(nt=n.R32UI),X===n.BYTE&&(nt=n.R8I),X===n.SHORT&&(nt=n.R16I),X===n.INT&&(nt=n.R32I)),R===n.RG&&(X===n.FLOAT&&(nt=n.RG32F),X===n.HALF_FLOAT&&(nt=n.RG16F),X===n.UNSIGNED_BYTE&&(nt=n.RG8),X===n.UNSIGNED_SHORT&&wt&&(nt=wt.RG16_EXT),X===n.SHORT&&wt&&(nt=wt.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RG8UI),X===n.UNSIGNED_SHORT&&(nt=n.RG16UI),X===n.UNSIGNED_INT&&(nt=n.RG32UI),X===n.BYTE&&(nt=n.RG8I),X===n.SHORT&&(nt=n.RG16I),X===n.INT&&(nt=n.RG32I)),R===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),X===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),X===n.UNSIGNED_INT&&(nt=n.RGB32UI),X===n.BYTE&&(nt=n.RGB8I),X===n.SHORT&&(nt=n.RGB16I),X===n.INT&&(nt=n.RGB32I)),R===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),X===n.UNSIGNED_INT&&(nt=n.RGBA32UI),X===n.BYTE&&(nt=n.RGBA8I),X===n.SHORT&&(nt=n.RGBA16I),X===n.INT&&(nt=n.RGBA32I)),R===n.RGB&&(X===n.UNSIGNED_SHORT&&wt&&(nt=wt.RGB16_EXT),X===n.SHORT&&wt&&(nt=wt.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),R===n.RGBA){let rt=St?kl:Ce.getTransfer(lt);X===n.FLOAT&&(nt=n.RGBA32F),X===n.HALF_FLOAT&&(nt=n.RGBA16F),X===n.UNSIGNED_BYTE&&(nt=rt===ke?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&wt&&(nt=wt.RGBA16_EXT),X===n.SHORT&&wt&&(nt=wt.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function _(N,R){let X;return N?R===null||R===Ss||R===To?X=n.DEPTH24_STENCIL8:R===cs?X=n.DEPTH32F_STENCIL8:R===Oa&&(X=n.DEPTH24_STENCIL8,te("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===Ss||R===To?X=n.DEPTH_COMPONENT24:R===cs?X=n.DEPTH_COMPONENT32F:R===Oa&&(X=n.DEPTH_COMPONENT16),X}function S(N,R){return E(N)===!0||N.isFramebufferTexture&&N.minFilter!==Kn&&N.minFilter!==Mi?Math.log2(Math.max(R.width,R.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?R.mipmaps.length:1}function L(N){let R=new WeakRef(N);i.get(N).__ref=R,g.add(R),y.register(N,R,R)}function I(N){let R=i.get(N).__ref;R!==void 0&&(g.delete(R),y.unregister(R))}function D(N){V(N.target)}function B(N){O(N.target)}function V(N){N.removeEventListener("dispose",D),I(N),Z(N),N.isVideoTexture&&u.delete(N),N.isHTMLTexture&&h.delete(N)}function O(N){N.removeEventListener("dispose",B),I(N),ht(N)}function $(){for(let N of g){let R=N.deref();R!==void 0&&(R.isRenderTarget===!0?O(R):V(R))}g.clear(),h.clear()}function Z(N){let R=i.get(N);if(R.__webglInit===void 0)return;let X=N.source,dt=f.get(X);if(dt){let lt=dt[R.__cacheKey];lt.usedTimes--,lt.usedTimes===0&&q(N),Object.keys(dt).length===0&&f.delete(X)}i.remove(N)}function q(N){let R=i.get(N);n.deleteTexture(R.__webglTexture);let X=N.source,dt=f.get(X);delete dt[R.__cacheKey],o.memory.textures--}function ht(N){let R=i.get(N);R.__depthDisposeCallback&&R.__depthDisposeCallback();let X=N.depthTexture;if(X&&X.renderTarget===N&&V(X),N.isWebGLCubeRenderTarget)for(let lt=0;lt<6;lt++){if(Array.isArray(R.__webglFramebuffer[lt]))for(let St=0;St<R.__webglFramebuffer[lt].length;St++)n.deleteFramebuffer(R.__webglFramebuffer[lt][St]);else n.deleteFramebuffer(R.__webglFramebuffer[lt]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[lt])}else{if(Array.isArray(R.__webglFramebuffer))for(let lt=0;lt<R.__webglFramebuffer.length;lt++)n.deleteFramebuffer(R.__webglFramebuffer[lt]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let lt=0;lt<R.__webglColorRenderbuffer.length;lt++)R.__webglColorRenderbuffer[lt]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[lt]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let dt=N.textures;for(let lt=0,St=dt.length;lt<St;lt++){let wt=i.get(dt[lt]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(dt[lt])}i.remove(N)}let K=0;function tt(){K=0}function ot(){return K}function mt(N){K=N}function pt(){let N=K;return N>=s.maxTextures&&te("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,N}function et(N){let R=[];return R.push(N.wrapS),R.push(N.wrapT),R.push(N.wrapR||0),R.push(N.magFilter),R.push(N.minFilter),R.push(N.anisotropy),R.push(N.internalFormat),R.push(N.format),R.push(N.type),R.push(N.generateMipmaps),R.push(N.mipmapsAutoUpdate),R.push(N.premultiplyAlpha),R.push(N.flipY),R.push(N.unpackAlignment),R.push(N.colorSpace),R.join()}function vt(N,R){let X=i.get(N);if(N.isVideoTexture&&Ze(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&X.__version!==N.version){let dt=N.image;if(dt===null)te("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)te("WebGLRenderer: Texture marked for update but image is incomplete");else{tn(X,N,R);return}}else N.isExternalTexture&&(X.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+R)}function Mt(N,R){let X=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&X.__version!==N.version){tn(X,N,R);return}else N.isExternalTexture&&(X.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+R)}function Lt(N,R){let X=i.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&X.__version!==N.version){tn(X,N,R);return}e.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+R)}function At(N,R){let X=i.get(N);if(N.version>0&&X.__version!==N.version){An(X,N,R);return}e.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+R)}let jt={[Ju]:n.REPEAT,[Ws]:n.CLAMP_TO_EDGE,[Ku]:n.MIRRORED_REPEAT},fe={[Kn]:n.NEAREST,[ox]:n.NEAREST_MIPMAP_NEAREST,[hc]:n.NEAREST_MIPMAP_LINEAR,[Mi]:n.LINEAR,[wh]:n.LINEAR_MIPMAP_NEAREST,[vr]:n.LINEAR_MIPMAP_LINEAR},Xt={[ux]:n.NEVER,[em]:n.ALWAYS,[hx]:n.LESS,[Qp]:n.LEQUAL,[dx]:n.EQUAL,[tm]:n.GEQUAL,[fx]:n.GREATER,[px]:n.NOTEQUAL};function ve(N,R){if(R.type===cs&&t.has("OES_texture_float_linear")===!1&&(R.magFilter===Mi||R.magFilter===wh||R.magFilter===hc||R.magFilter===vr||R.minFilter===Mi||R.minFilter===wh||R.minFilter===hc||R.minFilter===vr)&&te("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(N,n.TEXTURE_WRAP_S,jt[R.wrapS]),n.texParameteri(N,n.TEXTURE_WRAP_T,jt[R.wrapT]),(N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY)&&n.texParameteri(N,n.TEXTURE_WRAP_R,jt[R.wrapR]),n.texParameteri(N,n.TEXTURE_MAG_FILTER,fe[R.magFilter]),n.texParameteri(N,n.TEXTURE_MIN_FILTER,fe[R.minFilter]),R.compareFunction&&(n.texParameteri(N,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(N,n.TEXTURE_COMPARE_FUNC,Xt[R.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Kn||R.minFilter!==hc&&R.minFilter!==vr||R.type===cs&&t.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");n.texParameterf(N,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function _e(N,R){let X=!1;N.__webglInit===void 0&&(N.__webglInit=!0,R.addEventListener("dispose",D),L(R));let dt=R.source,lt=f.get(dt);lt===void 0&&(lt={},f.set(dt,lt));let St=et(R);if(St!==N.__cacheKey){lt[St]===void 0&&(lt[St]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),lt[St].usedTimes++;let wt=lt[N.__cacheKey];wt!==void 0&&(lt[N.__cacheKey].usedTimes--,wt.usedTimes===0&&q(R)),N.__cacheKey=St,N.__webglTexture=lt[St].texture}return X}function he(N,R,X){return Math.floor(Math.floor(N/X)/R)}function cn(N,R,X,dt){let St=N.updateRanges;if(St.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,X,dt,R.data);else{St.sort((z,at)=>z.start-at.start);let wt=0;for(let z=1;z<St.length;z++){let at=St[wt],it=St[z],Ct=at.start+at.count,bt=he(it.start,R.width,4),Tt=he(at.start,R.width,4);it.start<=Ct+1&&bt===Tt&&he(it.start+it.count-1,R.width,4)===bt?at.count=Math.max(at.count,it.start+it.count-at.start):(++wt,St[wt]=it)}St.length=wt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),xt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let z=0,at=St.length;z<at;z++){let it=St[z],Ct=Math.floor(it.start/4),bt=Math.ceil(it.count/4),Tt=Ct%R.width,Zt=Math.floor(Ct/R.width),oe=bt,ut=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Tt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Zt),e.texSubImage2D(n.TEXTURE_2D,0,Tt,Zt,oe,ut,X,dt,R.data)}N.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,xt)}}function tn(N,R,X){let dt=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(dt=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(dt=n.TEXTURE_3D);let lt=_e(N,R),St=R.source;e.bindTexture(dt,N.__webglTexture,n.TEXTURE0+X);let wt=i.get(St);if(St.version!==wt.__version||lt===!0){if(e.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let ut=Ce.getPrimaries(Ce.workingColorSpace),Gt=R.colorSpace===Sr?null:Ce.getPrimaries(R.colorSpace),ae=R.colorSpace===Sr||ut===Gt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let rt=x(R.image,!1,s.maxTextureSize);rt=$t(R,rt);let xt=r.convert(R.format,R.colorSpace),z=r.convert(R.type),at=T(R.internalFormat,xt,z,R.normalized,R.colorSpace,R.isVideoTexture);ve(dt,R);let it,Ct=R.mipmaps,bt=R.isVideoTexture!==!0,Tt=wt.__version===void 0||lt===!0,Zt=St.dataReady,oe=S(R,rt);if(R.isDepthTexture)at=_(R.format===br,R.type),Tt&&(bt?e.texStorage2D(n.TEXTURE_2D,1,at,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,at,rt.width,rt.height,0,xt,z,null));else if(R.isDataTexture)if(Ct.length>0){bt&&Tt&&e.texStorage2D(n.TEXTURE_2D,oe,at,Ct[0].width,Ct[0].height);for(let ut=0,Gt=Ct.length;ut<Gt;ut++)it=Ct[ut],bt?Zt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,it.width,it.height,xt,z,it.data):e.texImage2D(n.TEXTURE_2D,ut,at,it.width,it.height,0,xt,z,it.data);R.generateMipmaps=!1}else bt?(Tt&&e.texStorage2D(n.TEXTURE_2D,oe,at,rt.width,rt.height),Zt&&cn(R,rt,xt,z)):e.texImage2D(n.TEXTURE_2D,0,at,rt.width,rt.height,0,xt,z,rt.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){bt&&Tt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,at,Ct[0].width,Ct[0].height,rt.depth);for(let ut=0,Gt=Ct.length;ut<Gt;ut++)if(it=Ct[ut],R.format!==ws)if(xt!==null)if(bt){if(Zt)if(R.layerUpdates.size>0){let ae=hm(it.width,it.height,R.format,R.type);for(let Dt of R.layerUpdates){let me=it.data.subarray(Dt*ae/it.data.BYTES_PER_ELEMENT,(Dt+1)*ae/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,Dt,it.width,it.height,1,xt,me)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,rt.depth,xt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ut,at,it.width,it.height,rt.depth,0,it.data,0,0);else te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else bt?Zt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,it.width,it.height,rt.depth,xt,z,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ut,at,it.width,it.height,rt.depth,0,xt,z,it.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{bt&&Tt&&e.texStorage2D(n.TEXTURE_2D,oe,at,Ct[0].width,Ct[0].height);for(let ut=0,Gt=Ct.length;ut<Gt;ut++)it=Ct[ut],R.format!==ws?xt!==null?bt?Zt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ut,0,0,it.width,it.height,xt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ut,at,it.width,it.height,0,it.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):bt?Zt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,it.width,it.height,xt,z,it.data):e.texImage2D(n.TEXTURE_2D,ut,at,it.width,it.height,0,xt,z,it.data)}else if(R.isDataArrayTexture)if(bt){if(Tt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,oe,at,rt.width,rt.height,rt.depth),Zt)if(R.layerUpdates.size>0){let ut=hm(rt.width,rt.height,R.format,R.type);for(let Gt of R.layerUpdates){let ae=rt.data.subarray(Gt*ut/rt.data.BYTES_PER_ELEMENT,(Gt+1)*ut/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Gt,rt.width,rt.height,1,xt,z,ae)}R.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,xt,z,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,at,rt.width,rt.height,rt.depth,0,xt,z,rt.data);else if(R.isData3DTexture)bt?(Tt&&e.texStorage3D(n.TEXTURE_3D,oe,at,rt.width,rt.height,rt.depth),Zt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,xt,z,rt.data)):e.texImage3D(n.TEXTURE_3D,0,at,rt.width,rt.height,rt.depth,0,xt,z,rt.data);else if(R.isFramebufferTexture){if(Tt)if(bt)e.texStorage2D(n.TEXTURE_2D,oe,at,rt.width,rt.height);else{let ut=rt.width,Gt=rt.height;for(let ae=0;ae<oe;ae++)e.texImage2D(n.TEXTURE_2D,ae,at,ut,Gt,0,xt,z,null),ut>>=1,Gt>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let ut=n.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),rt.parentNode!==ut){ut.appendChild(rt),h.add(R),ut.onpaint=Gt=>{let ae=Gt.changedElements;for(let Dt of h)ae.includes(Dt.image)&&(Dt.needsUpdate=!0)},ut.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let ae=n.RGBA,Dt=n.RGBA,me=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ae,Dt,me,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ct.length>0){if(bt&&Tt){let ut=Qt(Ct[0]);e.texStorage2D(n.TEXTURE_2D,oe,at,ut.width,ut.height)}for(let ut=0,Gt=Ct.length;ut<Gt;ut++)it=Ct[ut],bt?Zt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,xt,z,it):e.texImage2D(n.TEXTURE_2D,ut,at,xt,z,it);R.generateMipmaps=!1}else if(bt){if(Tt){let ut=Qt(rt);e.texStorage2D(n.TEXTURE_2D,oe,at,ut.width,ut.height)}Zt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,xt,z,rt)}else e.texImage2D(n.TEXTURE_2D,0,at,xt,z,rt);E(R)&&R.mipmapsAutoUpdate===!0&&v(dt),wt.__version=St.version,R.onUpdate&&R.onUpdate(R)}N.__version=R.version}function An(N,R,X){if(R.image.length!==6)return;let dt=_e(N,R),lt=R.source;e.bindTexture(n.TEXTURE_CUBE_MAP,N.__webglTexture,n.TEXTURE0+X);let St=i.get(lt);if(lt.version!==St.__version||dt===!0){e.activeTexture(n.TEXTURE0+X);let wt=Ce.getPrimaries(Ce.workingColorSpace),nt=R.colorSpace===Sr?null:Ce.getPrimaries(R.colorSpace),rt=R.colorSpace===Sr||wt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let xt=R.isCompressedTexture||R.image[0].isCompressedTexture,z=R.image[0]&&R.image[0].isDataTexture,at=[];for(let Dt=0;Dt<6;Dt++)!xt&&!z?at[Dt]=x(R.image[Dt],!0,s.maxCubemapSize):at[Dt]=z?R.image[Dt].image:R.image[Dt],at[Dt]=$t(R,at[Dt]);let it=at[0],Ct=r.convert(R.format,R.colorSpace),bt=r.convert(R.type),Tt=T(R.internalFormat,Ct,bt,R.normalized,R.colorSpace),Zt=R.isVideoTexture!==!0,oe=St.__version===void 0||dt===!0,ut=lt.dataReady,Gt=S(R,it);ve(n.TEXTURE_CUBE_MAP,R);let ae;if(R.isDepthTexture){if(Tt=_(R.format===br,R.type),oe)if(Zt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Tt,it.width,it.height);else for(let Dt=0;Dt<6;Dt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Tt,it.width,it.height,0,Ct,bt,null)}else if(xt){Zt&&oe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,Tt,it.width,it.height);for(let Dt=0;Dt<6;Dt++){ae=at[Dt].mipmaps;for(let me=0;me<ae.length;me++){let en=ae[me];R.format!==ws?Ct!==null?Zt?ut&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,0,0,en.width,en.height,Ct,en.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,Tt,en.width,en.height,0,en.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Zt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,0,0,en.width,en.height,Ct,bt,en.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me,Tt,en.width,en.height,0,Ct,bt,en.data)}}}else{if(ae=R.mipmaps,Zt&&oe){ae.length>0&&Gt++;let Dt=Qt(at[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,Tt,Dt.width,Dt.height)}for(let Dt=0;Dt<6;Dt++)if(z){Zt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,at[Dt].width,at[Dt].height,Ct,bt,at[Dt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Tt,at[Dt].width,at[Dt].height,0,Ct,bt,at[Dt].data);for(let me=0;me<ae.length;me++){let fi=ae[me].image[Dt].image;Zt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,0,0,fi.width,fi.height,Ct,bt,fi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,Tt,fi.width,fi.height,0,Ct,bt,fi.data)}}else{Zt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,0,0,Ct,bt,at[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,0,Tt,Ct,bt,at[Dt]);for(let me=0;me<ae.length;me++){let en=ae[me];Zt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,0,0,Ct,bt,en.image[Dt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Dt,me+1,Tt,Ct,bt,en.image[Dt])}}}E(R)&&R.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),St.__version=lt.version,R.onUpdate&&R.onUpdate(R)}N.__version=R.version}function qe(N,R,X,dt,lt,St){let wt=r.convert(X.format,X.colorSpace),nt=r.convert(X.type),rt=T(X.internalFormat,wt,nt,X.normalized,X.colorSpace),xt=i.get(R),z=i.get(X);if(z.__renderTarget=R,!xt.__hasExternalTextures){let at=Math.max(1,R.width>>St),it=Math.max(1,R.height>>St);lt===n.TEXTURE_3D||lt===n.TEXTURE_2D_ARRAY?e.texImage3D(lt,St,rt,at,it,R.depth,0,wt,nt,null):e.texImage2D(lt,St,rt,at,it,0,wt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,N),Rt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,dt,lt,z.__webglTexture,0,pe(R)):(lt===n.TEXTURE_2D||lt>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&lt<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,dt,lt,z.__webglTexture,St),e.bindFramebuffer(n.FRAMEBUFFER,null)}function $n(N,R,X){if(n.bindRenderbuffer(n.RENDERBUFFER,N),R.depthBuffer){let dt=R.depthTexture,lt=dt&&dt.isDepthTexture?dt.type:null,St=_(R.stencilBuffer,lt),wt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Rt(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,pe(R),St,R.width,R.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,pe(R),St,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,St,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,N)}else{let dt=R.textures;for(let lt=0;lt<dt.length;lt++){let St=dt[lt],wt=r.convert(St.format,St.colorSpace),nt=r.convert(St.type),rt=T(St.internalFormat,wt,nt,St.normalized,St.colorSpace);Rt(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,pe(R),rt,R.width,R.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,pe(R),rt,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,rt,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Le(N,R,X){let dt=R.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,N),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let lt=i.get(R.depthTexture);lt.__renderTarget=R;let St=dt?R.depthTexture.image[0]:R.depthTexture.image;(!lt.__webglTexture||St.width!==R.width||St.height!==R.height)&&(St.width=R.width,St.height=R.height,R.depthTexture.needsUpdate=!0),dt?At(R.depthTexture,0):vt(R.depthTexture,0);let wt=lt.__webglTexture,nt=pe(R),rt=dt?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,xt=R.depthTexture.format===br?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===mr)Rt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xt,rt,wt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,xt,rt,wt,0);else if(R.depthTexture.format===br)Rt(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xt,rt,wt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,xt,rt,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function On(N){let R=i.get(N),X=N.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==N.depthTexture){let dt=N.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),dt){let lt=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,dt.removeEventListener("dispose",lt)};dt.addEventListener("dispose",lt),R.__depthDisposeCallback=lt}R.__boundDepthTexture=dt}if(N.depthTexture&&!R.__autoAllocateDepthBuffer)if(X)for(let dt=0;dt<6;dt++)Le(R.__webglFramebuffer[dt],N,dt);else N.texture.mipmaps.length>0?Le(R.__webglFramebuffer[0],N,0):Le(R.__webglFramebuffer,N,0);else if(X){R.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[dt]),R.__webglDepthbuffer[dt]===void 0)R.__webglDepthbuffer[dt]=n.createRenderbuffer(),$n(R.__webglDepthbuffer[dt],N,!1);else{let lt=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer[dt];n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,lt,n.RENDERBUFFER,St)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),$n(R.__webglDepthbuffer,N,!1);else{let lt=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,St),n.framebufferRenderbuffer(n.FRAMEBUFFER,lt,n.RENDERBUFFER,St)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function xn(N,R,X){let dt=i.get(N);R!==void 0&&qe(dt.__webglFramebuffer,N,N.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&On(N)}function Rn(N){let R=N.texture,X=i.get(N),dt=i.get(R);N.addEventListener("dispose",B),L(N);let lt=N.textures,St=N.isWebGLCubeRenderTarget===!0,wt=lt.length>1;if(wt||(dt.__webglTexture===void 0&&(dt.__webglTexture=n.createTexture()),dt.__version=R.version,o.memory.textures++),St){X.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(R.mipmaps.length>0){X.__webglFramebuffer[nt]=[];for(let rt=0;rt<R.mipmaps.length;rt++)X.__webglFramebuffer[nt][rt]=n.createFramebuffer()}else X.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(R.mipmaps.length>0){X.__webglFramebuffer=[];for(let nt=0;nt<R.mipmaps.length;nt++)X.__webglFramebuffer[nt]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(wt)for(let nt=0,rt=lt.length;nt<rt;nt++){let xt=i.get(lt[nt]);xt.__webglTexture===void 0&&(xt.__webglTexture=n.createTexture(),o.memory.textures++)}if(N.samples>0&&Rt(N)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let nt=0;nt<lt.length;nt++){let rt=lt[nt];X.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[nt]);let xt=r.convert(rt.format,rt.colorSpace),z=r.convert(rt.type),at=T(rt.internalFormat,xt,z,rt.normalized,rt.colorSpace,N.isXRRenderTarget===!0),it=pe(N);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,at,N.width,N.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,X.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),N.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),$n(X.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(St){e.bindTexture(n.TEXTURE_CUBE_MAP,dt.__webglTexture),ve(n.TEXTURE_CUBE_MAP,R);for(let nt=0;nt<6;nt++)if(R.mipmaps.length>0)for(let rt=0;rt<R.mipmaps.length;rt++)qe(X.__webglFramebuffer[nt][rt],N,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,rt);else qe(X.__webglFramebuffer[nt],N,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);E(R)?v(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let nt=0,rt=lt.length;nt<rt;nt++){let xt=lt[nt],z=i.get(xt),at=n.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(at=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(at,z.__webglTexture),ve(at,xt),qe(X.__webglFramebuffer,N,xt,n.COLOR_ATTACHMENT0+nt,at,0),E(xt)&&v(at)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(nt=N.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,dt.__webglTexture),ve(nt,R),R.mipmaps.length>0)for(let rt=0;rt<R.mipmaps.length;rt++)qe(X.__webglFramebuffer[rt],N,R,n.COLOR_ATTACHMENT0,nt,rt);else qe(X.__webglFramebuffer,N,R,n.COLOR_ATTACHMENT0,nt,0);E(R)?v(nt):R.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&On(N)}function H(N){let R=N.textures;for(let X=0,dt=R.length;X<dt;X++){let lt=R[X];if(E(lt)&&lt.mipmapsAutoUpdate===!0){let St=A(N),wt=i.get(lt).__webglTexture;e.bindTexture(St,wt),v(St),e.unbindTexture()}}}let Nt=[];function ee(N){if(N.samples>0){if(Rt(N)===!1){let R=N.textures,X=N.width,dt=N.height,lt=n.COLOR_BUFFER_BIT,St=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(N),nt=R.length>1;if(nt)for(let xt=0;xt<R.length;xt++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let xt=0;xt<R.length;xt++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(lt|=n.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(lt|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[xt]);let z=i.get(R[xt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,X,dt,0,0,X,dt,lt,n.NEAREST),l===!0&&(Nt.length=0,Nt.push(n.COLOR_ATTACHMENT0+xt),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Nt.push(St),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Nt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let xt=0;xt<R.length;xt++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.RENDERBUFFER,wt.__webglColorRenderbuffer[xt]);let z=i.get(R[xt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xt,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&l){let R=N.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function pe(N){return Math.min(s.maxSamples,N.samples)}function Rt(N){let R=i.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Ze(N){let R=o.render.frame;u.get(N)!==R&&(u.set(N,R),N.update())}function $t(N,R){let X=N.colorSpace,dt=N.format,lt=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||X!==Bl&&X!==Sr&&(Ce.getTransfer(X)===ke?(dt!==ws||lt!==ji)&&te("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",X)),R}function Qt(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(c.width=N.naturalWidth||N.width,c.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(c.width=N.displayWidth,c.height=N.displayHeight):(c.width=N.width,c.height=N.height),c}this.allocateTextureUnit=pt,this.resetTextureUnits=tt,this.getTextureUnits=ot,this.setTextureUnits=mt,this.setTexture2D=vt,this.setTexture2DArray=Mt,this.setTexture3D=Lt,this.setTextureCube=At,this.rebindTextures=xn,this.setupRenderTarget=Rn,this.updateRenderTargetMipmap=H,this.updateMultisampleRenderTarget=ee,this.setupDepthRenderbuffer=On,this.setupFrameBufferTexture=qe,this.useMultisampledRTT=Rt,this.dispose=$}function PR(n,t){function e(i,s=Sr){let r,o=Ce.getTransfer(s);if(i===ji)return n.UNSIGNED_BYTE;if(i===Th)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ah)return n.UNSIGNED_SHORT_5_5_5_1;if(i===$p)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Xp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Wp)return n.BYTE;if(i===qp)return n.SHORT;if(i===Oa)return n.UNSIGNED_SHORT;if(i===Eh)return n.INT;if(i===Ss)return n.UNSIGNED_INT;if(i===cs)return n.FLOAT;if(i===Ms)return n.HALF_FLOAT;if(i===Yp)return n.ALPHA;if(i===Zp)return n.RGB;if(i===ws)return n.RGBA;if(i===mr)return n.DEPTH_COMPONENT;if(i===br)return n.DEPTH_STENCIL;if(i===Rh)return n.RED;if(i===Ch)return n.RED_INTEGER;if(i===Kr)return n.RG;if(i===Ph)return n.RG_INTEGER;if(i===Ih)return n.RGBA_INTEGER;if(i===dc||i===fc||i===pc||i===mc)if(o===ke)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===dc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===fc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===pc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===mc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===dc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===fc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===pc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===mc)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Lh||i===Dh||i===Nh||i===Uh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Lh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Dh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Uh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Fh||i===Oh||i===Bh||i===kh||i===zh||i===gc||i===Hh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Fh||i===Oh)return o===ke?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Bh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===kh)return r.COMPRESSED_R11_EAC;if(i===zh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===gc)return r.COMPRESSED_RG11_EAC;if(i===Hh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Gh||i===Vh||i===Wh||i===qh||i===$h||i===Xh||i===Yh||i===Zh||i===jh||i===Jh||i===Kh||i===Qh||i===td||i===ed)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Gh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Vh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Wh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===qh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===$h)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Xh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Yh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Zh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===jh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Jh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Kh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Qh)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===td)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===ed)return o===ke?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===nd||i===id||i===sd)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===nd)return o===ke?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===id)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===sd)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===rd||i===od||i===_c||i===ad)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===rd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===od)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===_c)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ad)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===To?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var IR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,LR=`
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

}`,vm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new ec(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new ls({vertexShader:IR,fragmentShader:LR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new fn(new rc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},bm=class extends bs{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new vm,m={},x=e.getContextAttributes(),E=null,v=null,A=[],T=[],_=new qt,S=null,L=null,I=new Si;I.viewport=new gn;let D=new Si;D.viewport=new gn;let B=[I,D],V=new bh,O=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(et){let vt=A[et];return vt===void 0&&(vt=new Aa,A[et]=vt),vt.getTargetRaySpace()},this.getControllerGrip=function(et){let vt=A[et];return vt===void 0&&(vt=new Aa,A[et]=vt),vt.getGripSpace()},this.getHand=function(et){let vt=A[et];return vt===void 0&&(vt=new Aa,A[et]=vt),vt.getHandSpace()};function Z(et){let vt=T.indexOf(et.inputSource);if(vt===-1)return;let Mt=A[vt];Mt!==void 0&&(Mt.update(et.inputSource,et.frame,c||o),Mt.dispatchEvent({type:et.type,data:et.inputSource}))}function q(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",ht);for(let et=0;et<A.length;et++){let vt=T[et];vt!==null&&(T[et]=null,A[et].disconnect(vt))}O=null,$=null,p.reset();for(let et in m)delete m[et];if(t.setRenderTarget(E),f=null,d=null,h=null,s=null,v=null,pt.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(_.width,_.height,!1),L!==null){let et=L.camera;et.fov=L.fov,et.zoom=L.zoom,et.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(et){r=et,i.isPresenting===!0&&te("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(et){a=et,i.isPresenting===!0&&te("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(et){c=et},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(et){if(s=et,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",q),s.addEventListener("inputsourceschange",ht),x.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Mt=null,Lt=null,At=null;x.depth&&(At=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Mt=x.stencil?br:mr,Lt=x.stencil?To:Ss);let jt={colorFormat:e.RGBA8,depthFormat:At,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new $i(d.textureWidth,d.textureHeight,{format:ws,type:ji,depthTexture:new xr(d.textureWidth,d.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,Mt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Mt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,Mt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new $i(f.framebufferWidth,f.framebufferHeight,{format:ws,type:ji,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ht(et){for(let vt=0;vt<et.removed.length;vt++){let Mt=et.removed[vt],Lt=T.indexOf(Mt);Lt>=0&&(T[Lt]=null,A[Lt].disconnect(Mt))}for(let vt=0;vt<et.added.length;vt++){let Mt=et.added[vt],Lt=T.indexOf(Mt);if(Lt===-1){for(let jt=0;jt<A.length;jt++)if(jt>=T.length){T.push(Mt),Lt=jt;break}else if(T[jt]===null){T[jt]=Mt,Lt=jt;break}if(Lt===-1)break}let At=A[Lt];At&&At.connect(Mt)}}function K(et,vt){vt===null?et.matrixWorld.copy(et.matrix):et.matrixWorld.multiplyMatrices(vt.matrixWorld,et.matrix),et.matrixWorldInverse.copy(et.matrixWorld).invert()}this.updateCamera=function(et){if(s===null)return;let vt=et.near,Mt=et.far;p.texture!==null&&(p.depthNear>0&&(vt=p.depthNear),p.depthFar>0&&(Mt=p.depthFar)),V.near=D.near=I.near=vt,V.far=D.far=I.far=Mt,(O!==V.near||$!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),O=V.near,$=V.far),V.layers.mask=et.layers.mask|6,I.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Lt=et.parent,At=V.cameras;K(V,Lt);for(let jt=0;jt<At.length;jt++)K(At[jt],Lt);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),L===null&&et.isPerspectiveCamera&&(L={camera:et,fov:et.fov,zoom:et.zoom}),tt(et,V,Lt)};function tt(et,vt,Mt){Mt===null?et.matrix.copy(vt.matrixWorld):(et.matrix.copy(Mt.matrixWorld),et.matrix.invert(),et.matrix.multiply(vt.matrixWorld)),et.matrix.decompose(et.position,et.quaternion,et.scale),et.updateMatrixWorld(!0),et.projectionMatrix.copy(vt.projectionMatrix),et.projectionMatrixInverse.copy(vt.projectionMatrixInverse),et.isPerspectiveCamera&&(et.fov=wa*2*Math.atan(1/et.projectionMatrix.elements[5]),et.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(et){l=et,d!==null&&(d.fixedFoveation=et),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=et)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(V)},this.getCameraTexture=function(et){return m[et]};let ot=null;function mt(et,vt){if(u=vt.getViewerPose(c||o),g=vt,u!==null){let Mt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Lt=!1;Mt.length!==V.cameras.length&&(V.cameras.length=0,Lt=!0);for(let Xt=0;Xt<Mt.length;Xt++){let ve=Mt[Xt],_e=null;if(f!==null)_e=f.getViewport(ve);else{let cn=h.getViewSubImage(d,ve);_e=cn.viewport,Xt===0&&(t.setRenderTargetTextures(v,cn.colorTexture,cn.depthStencilTexture),t.setRenderTarget(v))}let he=B[Xt];he===void 0&&(he=new Si,he.layers.enable(Xt),he.viewport=new gn,B[Xt]=he),he.matrix.fromArray(ve.transform.matrix),he.matrix.decompose(he.position,he.quaternion,he.scale),he.projectionMatrix.fromArray(ve.projectionMatrix),he.projectionMatrixInverse.copy(he.projectionMatrix).invert(),he.viewport.set(_e.x,_e.y,_e.width,_e.height),Xt===0&&(V.matrix.copy(he.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Lt===!0&&V.cameras.push(he)}let At=s.enabledFeatures;if(At&&At.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Xt=h.getDepthInformation(Mt[0]);Xt&&Xt.isValid&&Xt.texture&&p.init(Xt,s.renderState)}if(At&&At.includes("camera-access")&&y){t.state.unbindTexture(),h=i.getBinding();for(let Xt=0;Xt<Mt.length;Xt++){let ve=Mt[Xt].camera;if(ve){let _e=m[ve];_e||(_e=new ec,m[ve]=_e);let he=h.getCameraImage(ve);_e.sourceTexture=he}}}}for(let Mt=0;Mt<A.length;Mt++){let Lt=T[Mt],At=A[Mt];Lt!==null&&At!==void 0&&At.update(Lt,vt,c||o)}ot&&ot(et,vt),vt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:vt}),g=null}let pt=new qx;pt.setAnimationLoop(mt),this.setAnimationLoop=function(et){ot=et},this.dispose=function(){}}},DR=new ge,ey=new ce;ey.set(-1,0,0,0,1,0,0,0,1);function NR(n,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,lm(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,x,E,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),h(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,v)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,x,E):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Ti&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Ti&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let x=t.get(m),E=x.envMap,v=x.envMapRotation;E&&(p.envMap.value=E,p.envMapRotation.value.setFromMatrix4(DR.makeRotationFromEuler(v)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(ey),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,x,E){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*x,p.scale.value=E*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,x){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Ti&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let x=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function UR(n,t,e,i){let s={},r={};function o(x,E){let v=E.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,E){let v=s[x.id];v===void 0&&(g(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",p));let A=E.program;i.updateUBOMapping(x,A);let T=t.render.frame;r[x.id]!==T&&(c(x),r[x.id]=T)}function l(x){let E=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(x){let E=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let T=0,_=v.length;T<_;T++){let S=v[T];if(Array.isArray(S))for(let L=0,I=S.length;L<I;L++)u(S[L],T,L,A);else u(S,T,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,E,v,A){if(d(x,E,v,A)===!0){let T=x.__offset,_=x.value;if(Array.isArray(_)){let S=0;for(let L=0;L<_.length;L++){let I=_[L],D=y(I,!0);h(I,x.__data,S),S+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,x.__data)}}function h(x,E,v){typeof x=="number"||typeof x=="boolean"?E[v]=x:x.isMatrix3?(E[v]=x.elements[0],E[v+1]=x.elements[1],E[v+2]=x.elements[2],E[v+3]=0,E[v+4]=x.elements[3],E[v+5]=x.elements[4],E[v+6]=x.elements[5],E[v+7]=0,E[v+8]=x.elements[6],E[v+9]=x.elements[7],E[v+10]=x.elements[8],E[v+11]=0):ArrayBuffer.isView(x)?E.set(x.subarray(0,E.length-v),v):x.toArray(E,v)}function d(x,E,v,A){let T=x.value,_=E+"_"+v;if(Array.isArray(T)){A[_]===void 0&&(A[_]=[]);let S=A[_],L=!1;for(let I=0;I<T.length;I++)f(T[I],S,I)===!0&&(L=!0);return L}return f(T,A,_)}function f(x,E,v){if(E[v]===void 0)return typeof x=="number"||typeof x=="boolean"?E[v]=x:ArrayBuffer.isView(x)?E[v]=x.slice():E[v]=x.clone(),!0;{let A=E[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return E[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function g(x){let E=x.uniforms,v=0,A=16;for(let _=0,S=E.length;_<S;_++){let L=Array.isArray(E[_])?E[_]:[E[_]];for(let I=0,D=L.length;I<D;I++){let B=L[I],V=Array.isArray(B.value)?B.value:[B.value],O=Array.isArray(E[_])||Array.isArray(B.value),$=v;for(let q=0,ht=V.length;q<ht;q++){let K=V[q],tt=y(K,O),ot=v%A,mt=ot%tt.boundary,pt=ot+mt;v+=mt,pt!==0&&A-pt<tt.storage&&(v+=A-pt),q===0&&($=v),v+=tt.storage}let Z=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Z((v-$)/Float32Array.BYTES_PER_ELEMENT),B.__offset=$}}let T=v%A;return T>0&&(v+=A-T),x.__size=v,x.__cache={},this}function y(x,E){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?te("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):te("WebGLRenderer: Unsupported uniform value type.",x),E===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function p(x){let E=x.target;E.removeEventListener("dispose",p),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:m}}var FR=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),js=null;function OR(){return js===null&&(js=new jl(FR,16,16,Kr,Ms),js.name="DFG_LUT",js.minFilter=Mi,js.magFilter=Mi,js.wrapS=Ws,js.wrapT=Ws,js.generateMipmaps=!1,js.needsUpdate=!0),js}var fd=class{constructor(t={}){let{canvas:e=mx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ji}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=f,p=new Set([Ih,Ph,Ch]),m=new Set([ji,Ss,Oa,To,Th,Ah]),x=new Uint32Array(4),E=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,T=null,_=[],S=[],L=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Zs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,B=null,V=null,O=null,$=null;this._outputColorSpace=bi;let Z=0,q=0,ht=null,K=-1,tt=null,ot=new gn,mt=new gn,pt=null,et=new ie(0),vt=0,Mt=e.width,Lt=e.height,At=1,jt=null,fe=null,Xt=new gn(0,0,Mt,Lt),ve=new gn(0,0,Mt,Lt),_e=!1,he=new vo,cn=new ih,tn=!1,An=!1,qe=new ge,$n=new k,Le=new gn,On={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},xn=!1;function Rn(){return ht===null?At:1}let H=i;function Nt(P,G){return e.getContext(P,G)}let ee,pe,Rt,Ze,$t,Qt,N,R,X,dt,lt,St,wt,nt,rt,xt,z,at,it,Ct,bt,Tt,Zt;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Gt,!1),e.addEventListener("webglcontextrestored",ae,!1),e.addEventListener("webglcontextcreationerror",Dt,!1),H===null){let G="webgl2";if(H=Nt(G,P),H===null)throw Nt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}oe()}catch(P){throw e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),re("WebGLRenderer: "+P.message),P}function oe(){ee=new YT(H),ee.init(),bt=new PR(H,ee),pe=new OT(H,ee,t,bt),Rt=new RR(H,ee),pe.reversedDepthBuffer&&d&&Rt.buffers.depth.setReversed(!0),V=H.createFramebuffer(),O=H.createFramebuffer(),$=H.createFramebuffer(),Ze=new JT(H),$t=new pR,Qt=new CR(H,ee,Rt,$t,pe,bt,Ze),N=new XT(I),R=new Qw(H),Tt=new UT(H,R),X=new ZT(H,R,Ze,Tt),dt=new QT(H,X,R,Tt,Ze),at=new KT(H,pe,Qt),rt=new BT($t),lt=new fR(I,N,ee,pe,Tt,rt),St=new NR(I,$t),wt=new gR,nt=new SR(ee),z=new NT(I,N,Rt,dt,g,l),xt=new AR(I,dt,pe),Zt=new UR(H,Ze,pe,Rt),it=new FT(H,ee,Ze),Ct=new jT(H,ee,Ze),Ze.programs=lt.programs,I.capabilities=pe,I.extensions=ee,I.properties=$t,I.renderLists=wt,I.shadowMap=xt,I.state=Rt,I.info=Ze}y!==ji&&(L=new eA(y,e.width,e.height,a,s,r));let ut=new bm(I,H);this.xr=ut,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let P=ee.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=ee.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return At},this.setPixelRatio=function(P){P!==void 0&&(At=P,this.setSize(Mt,Lt,!1))},this.getSize=function(P){return P.set(Mt,Lt)},this.setSize=function(P,G,Q=!0){if(ut.isPresenting){te("WebGLRenderer: Can't change size while VR device is presenting.");return}Mt=P,Lt=G,e.width=Math.floor(P*At),e.height=Math.floor(G*At),Q===!0&&(e.style.width=P+"px",e.style.height=G+"px"),L!==null&&L.setSize(e.width,e.height),this.setViewport(0,0,P,G)},this.getDrawingBufferSize=function(P){return P.set(Mt*At,Lt*At).floor()},this.setDrawingBufferSize=function(P,G,Q){Mt=P,Lt=G,At=Q,e.width=Math.floor(P*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,P,G)},this.setEffects=function(P){if(y===ji){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let G=0;G<P.length;G++)if(P[G].isOutputPass===!0){te("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(ot)},this.getViewport=function(P){return P.copy(Xt)},this.setViewport=function(P,G,Q,Y){P.isVector4?Xt.set(P.x,P.y,P.z,P.w):Xt.set(P,G,Q,Y),Rt.viewport(ot.copy(Xt).multiplyScalar(Rn()).round())},this.getScissor=function(P){return P.copy(ve)},this.setScissor=function(P,G,Q,Y){P.isVector4?ve.set(P.x,P.y,P.z,P.w):ve.set(P,G,Q,Y),Rt.scissor(mt.copy(ve).multiplyScalar(Rn()).round())},this.getScissorTest=function(){return _e},this.setScissorTest=function(P){Rt.setScissorTest(_e=P)},this.setOpaqueSort=function(P){jt=P},this.setTransparentSort=function(P){fe=P},this.getClearColor=function(P){return P.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(P=!0,G=!0,Q=!0){let Y=0;if(P){let j=!1;if(ht!==null){let Pt=ht.texture.format;j=p.has(Pt)}if(j){let Pt=ht.texture.type,Ut=m.has(Pt),It=z.getClearColor(),Ft=z.getClearAlpha(),Wt=It.r,le=It.g,Se=It.b;Ut?(x[0]=Wt,x[1]=le,x[2]=Se,x[3]=Ft,H.clearBufferuiv(H.COLOR,0,x)):(E[0]=Wt,E[1]=le,E[2]=Se,E[3]=Ft,H.clearBufferiv(H.COLOR,0,E))}else Y|=H.COLOR_BUFFER_BIT}G&&(Y|=H.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&H.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),B=P},this.dispose=function(){e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",ae,!1),e.removeEventListener("webglcontextcreationerror",Dt,!1),z.dispose(),wt.dispose(),nt.dispose(),Qt.dispose(),$t.dispose(),N.dispose(),dt.dispose(),X.dispose(),Tt.dispose(),Zt.dispose(),lt.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",nu),ut.removeEventListener("sessionend",Ds),tr.stop()};function Gt(P){P.preventDefault(),Gl("WebGLRenderer: Context Lost."),D=!0}function ae(){Gl("WebGLRenderer: Context Restored."),D=!1;let P=Ze.autoReset,G=xt.enabled,Q=xt.autoUpdate,Y=xt.needsUpdate,j=xt.type;oe(),Ze.autoReset=P,xt.enabled=G,xt.autoUpdate=Q,xt.needsUpdate=Y,xt.type=j}function Dt(P){re("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function me(P){let G=P.target;G.removeEventListener("dispose",me),en(G)}function en(P){fi(P),$t.remove(P)}function fi(P){let G=$t.get(P).programs;G!==void 0&&(G.forEach(function(Q){lt.releaseProgram(Q)}),P.isShaderMaterial&&lt.releaseShaderCache(P))}this.renderBufferDirect=function(P,G,Q,Y,j,Pt){G===null&&(G=On);let Ut=j.isMesh&&j.matrixWorld.determinantAffine()<0,It=_l(P,G,Q,Y,j);Rt.setMaterial(Y,Ut);let Ft=Q.index,Wt=1;if(Y.wireframe===!0){if(Ft=X.getWireframeAttribute(Q),Ft===void 0)return;Wt=2}let le=Q.drawRange,Se=Q.attributes.position,Vt=le.start*Wt,Me=(le.start+le.count)*Wt;Pt!==null&&(Vt=Math.max(Vt,Pt.start*Wt),Me=Math.min(Me,(Pt.start+Pt.count)*Wt)),Ft!==null?(Vt=Math.max(Vt,0),Me=Math.min(Me,Ft.count)):Se!=null&&(Vt=Math.max(Vt,0),Me=Math.min(Me,Se.count));let pn=Me-Vt;if(pn<0||pn===1/0)return;Tt.setup(j,Y,It,Q,Ft);let Ge,Ve=it;if(Ft!==null&&(Ge=R.get(Ft),Ve=Ct,Ve.setIndex(Ge)),j.isMesh)Y.wireframe===!0?(Rt.setLineWidth(Y.wireframeLinewidth*Rn()),Ve.setMode(H.LINES)):Ve.setMode(H.TRIANGLES);else if(j.isLine){let Bn=Y.linewidth;Bn===void 0&&(Bn=1),Rt.setLineWidth(Bn*Rn()),j.isLineSegments?Ve.setMode(H.LINES):j.isLineLoop?Ve.setMode(H.LINE_LOOP):Ve.setMode(H.LINE_STRIP)}else j.isPoints?Ve.setMode(H.POINTS):j.isSprite&&Ve.setMode(H.TRIANGLES);if(j.isBatchedMesh)if(ee.get("WEBGL_multi_draw"))Ve.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let Bn=j._multiDrawStarts,zt=j._multiDrawCounts,Cn=j._multiDrawCount,Re=Ft?R.get(Ft).bytesPerElement:1,nr=$t.get(Y).currentProgram.getUniforms();for(let Pn=0;Pn<Cn;Pn++)nr.setValue(H,"_gl_DrawID",Pn),Ve.render(Bn[Pn]/Re,zt[Pn])}else if(j.isInstancedMesh)Ve.renderInstances(Vt,pn,j.count);else if(Q.isInstancedBufferGeometry){let Bn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,zt=Math.min(Q.instanceCount,Bn);Ve.renderInstances(Vt,pn,zt)}else Ve.render(Vt,pn)};function pl(P,G,Q,Y){B!==null&&P.isNodeMaterial&&B.setObject(Y,P),tn===!0&&rt.setState(P,Q,!1),P.transparent===!0&&P.side===Di&&P.forceSinglePass===!1?(P.side=Ti,P.needsUpdate=!0,Ns(P,G,Y),P.side=Jr,P.needsUpdate=!0,Ns(P,G,Y),P.side=Di):Ns(P,G,Y)}this.compile=function(P,G,Q=null){Q===null&&(Q=P),B!==null&&B.renderStart(P,G,Q),T=nt.get(Q),T.init(G),S.push(T),Q.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(T.pushLight(j),j.castShadow&&T.pushShadow(j))}),P!==Q&&P.traverseVisible(function(j){j.isLight&&j.layers.test(G.layers)&&(T.pushLight(j),j.castShadow&&T.pushShadow(j))}),T.setupLights(),B!==null&&B.updateLights(T.state.lightsArray),An=this.localClippingEnabled,tn=rt.init(this.clippingPlanes,An),tn===!0&&rt.setGlobalState(this.clippingPlanes,G),B!==null&&xt.render(T.state.shadowsArray,Q,G);let Y=new Set;return P.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Pt=j.material;if(Pt)if(Array.isArray(Pt))for(let Ut=0;Ut<Pt.length;Ut++){let It=Pt[Ut];pl(It,Q,G,j),Y.add(It)}else pl(Pt,Q,G,j),Y.add(Pt)}),T=S.pop(),B!==null&&B.renderEnd(),Y},this.compileAsync=function(P,G,Q=null){let Y=this.compile(P,G,Q);return new Promise(j=>{function Pt(){if(Y.forEach(function(Ut){let Ft=$t.get(Ut).currentProgram;(Ft===void 0||Ft.isReady())&&Y.delete(Ut)}),Y.size===0){j(P);return}setTimeout(Pt,10)}ee.get("KHR_parallel_shader_compile")!==null?Pt():setTimeout(Pt,10)})};let Go=null;function kf(P){Go&&Go(P)}function nu(){tr.stop()}function Ds(){tr.start()}let tr=new qx;tr.setAnimationLoop(kf),typeof self<"u"&&tr.setContext(self),this.setAnimationLoop=function(P){Go=P,ut.setAnimationLoop(P),P===null?tr.stop():tr.start()},ut.addEventListener("sessionstart",nu),ut.addEventListener("sessionend",Ds),this.render=function(P,G){if(G!==void 0&&G.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(P,G);let Q=ut.enabled===!0&&ut.isPresenting===!0,Y=L!==null&&(ht===null||Q)&&L.begin(I,ht);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(G),G=ut.getCamera()),P.isScene===!0&&P.onBeforeRender(I,P,G,ht),T=nt.get(P,S.length),T.init(G),T.state.textureUnits=Qt.getTextureUnits(),S.push(T),qe.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?cn.setFromArrayCamera(G):he.setFromProjectionMatrix(qe,os,G.reversedDepth),An=this.localClippingEnabled,tn=rt.init(this.clippingPlanes,An),A=wt.get(P,_.length),A.init(),_.push(A),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Ut=I.xr.getDepthSensingMesh();Ut!==null&&er(Ut,G,-1/0,I.sortObjects)}er(P,G,0,I.sortObjects),A.finish(),B!==null&&B.updateLights(T.state.lightsArray),I.sortObjects===!0&&A.sort(jt,fe),xn=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,xn&&z.addToRenderList(A,P),this.info.autoReset===!0&&this.info.reset(),tn===!0&&rt.beginShadows();let j=T.state.shadowsArray;if(xt.render(j,P,G),tn===!0&&rt.endShadows(),(Y&&L.hasRenderPass())===!1){let Ut=A.opaque,It=A.transmissive;if(T.setupLights(),G.isArrayCamera){let Ft=G.cameras;if(It.length>0)for(let Wt=0,le=Ft.length;Wt<le;Wt++){let Se=Ft[Wt];ps(Ut,It,P,Se)}xn&&z.render(P);for(let Wt=0,le=Ft.length;Wt<le;Wt++){let Se=Ft[Wt];ml(A,P,Se,Se.viewport)}}else It.length>0&&ps(Ut,It,P,G),xn&&z.render(P),ml(A,P,G)}ht!==null&&q===0&&(Qt.updateMultisampleRenderTarget(ht),Qt.updateRenderTargetMipmap(ht)),Y&&L.end(I),P.isScene===!0&&P.onAfterRender(I,P,G),Tt.resetDefaultState(),K=-1,tt=null,S.pop(),S.length>0?(T=S[S.length-1],Qt.setTextureUnits(T.state.textureUnits),tn===!0&&rt.setGlobalState(I.clippingPlanes,T.state.camera)):T=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,B!==null&&B.renderEnd()};function er(P,G,Q,Y){if(P.visible===!1)return;if(P.layers.test(G.layers)){if(P.isGroup)Q=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update(G);else if(P.isLight)T.pushLight(P),P.castShadow&&T.pushShadow(P);else if(P.isSprite){let Ut=G.isArrayCamera?cn:he;if(!P.frustumCulled||P.intersectsFrustum(Ut)){Y&&Le.setFromMatrixPosition(P.matrixWorld).applyMatrix4(qe);let It=dt.update(P),Ft=P.material;Ft.visible&&A.push(P,It,Ft,Q,Le.z,null,G)}}else if(P.isMesh||P.isLine||P.isPoints){let Ut=G.isArrayCamera?cn:he;if(!P.frustumCulled||P.intersectsFrustum(Ut)){let It=dt.update(P),Ft=P.material;if(Y&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),Le.copy(P.boundingSphere.center)):(It.boundingSphere===null&&It.computeBoundingSphere(),Le.copy(It.boundingSphere.center)),Le.applyMatrix4(P.matrixWorld).applyMatrix4(qe)),Array.isArray(Ft)){let Wt=It.groups;for(let le=0,Se=Wt.length;le<Se;le++){let Vt=Wt[le],Me=Ft[Vt.materialIndex];Me&&Me.visible&&A.push(P,It,Me,Q,Le.z,Vt,G)}}else Ft.visible&&A.push(P,It,Ft,Q,Le.z,null,G)}}}let Pt=P.children;for(let Ut=0,It=Pt.length;Ut<It;Ut++)er(Pt[Ut],G,Q,Y)}function ml(P,G,Q,Y){let{opaque:j,transmissive:Pt,transparent:Ut}=P;T.setupLightsView(Q),tn===!0&&rt.setGlobalState(I.clippingPlanes,Q),Y&&Rt.viewport(ot.copy(Y)),j.length>0&&yn(j,G,Q),Pt.length>0&&yn(Pt,G,Q),Ut.length>0&&yn(Ut,G,Q),Rt.buffers.depth.setTest(!0),Rt.buffers.depth.setMask(!0),Rt.buffers.color.setMask(!0),Rt.setPolygonOffset(!1)}function ps(P,G,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Vt=ee.has("EXT_color_buffer_half_float")||ee.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new $i(1,1,{generateMipmaps:!0,type:Vt?Ms:ji,minFilter:vr,samples:Math.max(4,pe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ce.workingColorSpace})}let Pt=T.state.transmissionRenderTarget[Y.id],Ut=Y.viewport||ot;Pt.setSize(Ut.z*I.transmissionResolutionScale,Ut.w*I.transmissionResolutionScale);let It=I.getRenderTarget(),Ft=I.getActiveCubeFace(),Wt=I.getActiveMipmapLevel();I.setRenderTarget(Pt),I.getClearColor(et),vt=I.getClearAlpha(),vt<1&&I.setClearColor(16777215,.5),I.clear(),xn&&z.render(Q);let le=I.toneMapping;I.toneMapping=Zs;let Se=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),tn===!0&&rt.setGlobalState(I.clippingPlanes,Y),yn(P,Q,Y),Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt),ee.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let Me=0,pn=G.length;Me<pn;Me++){let Ge=G[Me],{object:Ve,geometry:Bn,material:zt,group:Cn}=Ge;if(zt.side===Di&&Ve.layers.test(Y.layers)){let Re=zt.side;zt.side=Ti,zt.needsUpdate=!0,En(Ve,Q,Y,Bn,zt,Cn),zt.side=Re,zt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Qt.updateMultisampleRenderTarget(Pt),Qt.updateRenderTargetMipmap(Pt))}I.setRenderTarget(It,Ft,Wt),I.setClearColor(et,vt),Se!==void 0&&(Y.viewport=Se),I.toneMapping=le}function yn(P,G,Q){let Y=G.isScene===!0?G.overrideMaterial:null;for(let j=0,Pt=P.length;j<Pt;j++){let Ut=P[j],{object:It,geometry:Ft,group:Wt}=Ut,le=Ut.material;le.allowOverride===!0&&Y!==null&&(le=Y),It.layers.test(Q.layers)&&En(It,G,Q,Ft,le,Wt)}}function En(P,G,Q,Y,j,Pt){B!==null&&j.isNodeMaterial&&B.setObject(P,j),P.onBeforeRender(I,G,Q,Y,j,Pt),P.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),j.onBeforeRender(I,G,Q,Y,P,Pt),j.transparent===!0&&j.side===Di&&j.forceSinglePass===!1?(j.side=Ti,j.needsUpdate=!0,I.renderBufferDirect(Q,G,Y,j,P,Pt),j.side=Jr,j.needsUpdate=!0,I.renderBufferDirect(Q,G,Y,j,P,Pt),j.side=Di):I.renderBufferDirect(Q,G,Y,j,P,Pt),P.onAfterRender(I,G,Q,Y,j,Pt)}function Tn(P){let G=0;for(let Q of P)Q.texture!==null&&G++;return G}function Ns(P,G,Q){G.isScene!==!0&&(G=On);let Y=$t.get(P),j=T.state.lights,Pt=T.state.shadowsArray,Ut=j.state.version,It=lt.getParameters(P,j.state,Pt,G,Q,T.state.lightProbeGridArray),Ft=lt.getProgramCacheKey(It),Wt=Y.programs;Y.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?G.environment:null,Y.fog=G.fog;let le=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;Y.envMap=N.get(P.envMap||Y.environment,le),Y.envMapRotation=Y.environment!==null&&P.envMap===null?G.environmentRotation:P.envMapRotation,Wt===void 0&&(P.addEventListener("dispose",me),Wt=new Map,Y.programs=Wt,Y.programVariants=new Map);let Se=Wt.get(Ft);if(Se!==void 0){if(Y.currentProgram===Se&&Y.lightsStateVersion===Ut)return gl(P,It),Se}else It.uniforms=lt.getUniforms(P),B!==null&&P.isNodeMaterial&&B.build(P,Q,It),P.onBeforeCompile(It,I),Se=lt.acquireProgram(It,Ft),Wt.set(Ft,Se),Y.uniforms=It.uniforms;let Vt=Y.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(Vt.clippingPlanes=rt.uniform),gl(P,It),Y.needsLights=Lr(P),Y.lightsStateVersion=Ut,Y.needsLights&&(Vt.ambientLightColor.value=j.state.ambient,Vt.lightProbe.value=j.state.probe,Vt.sunLights.value=j.state.sun,Vt.sunLightShadows.value=j.state.sunShadow,Vt.directionalLights.value=j.state.directional,Vt.directionalLightShadows.value=j.state.directionalShadow,Vt.spotLights.value=j.state.spot,Vt.spotLightShadows.value=j.state.spotShadow,Vt.rectAreaLights.value=j.state.rectArea,Vt.ltc_1.value=j.state.rectAreaLTC1,Vt.ltc_2.value=j.state.rectAreaLTC2,Vt.pointLights.value=j.state.point,Vt.pointLightShadows.value=j.state.pointShadow,Vt.hemisphereLights.value=j.state.hemi,Vt.sunShadowMatrix.value=j.state.sunShadowMatrix,Vt.sunShadowCascade.value=j.state.sunShadowCascade,Vt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Vt.spotLightMatrix.value=j.state.spotLightMatrix,Vt.spotLightMap.value=j.state.spotLightMap,Vt.pointShadowMatrix.value=j.state.pointShadowMatrix),Y.numLightProbeGrids=Tn(T.state.lightProbeGridArray),Y.currentProgram=Se,Y.uniformsList=null,Se}function ki(P,G,Q,Y,j){let Pt=$t.get(P),Ut=Pt.currentProgram.id+","+Y+","+j,It=Pt.programVariants.get(Ut);return It===void 0?(It=Ns(P,G,Q),Pt.programVariants.set(Ut,It)):(Pt.currentProgram=It,Pt.uniformsList=null,Pt.outputColorSpace=Y,Pt.toneMapping=j),It}function Ir(P){if(P.uniformsList===null){let G=P.currentProgram.getUniforms();P.uniformsList=Ba.seqWithValue(G.seq,P.uniforms)}return P.uniformsList}function gl(P,G){let Q=$t.get(P);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function _l(P,G,Q,Y,j){G.isScene!==!0&&(G=On),Qt.resetTextureUnits();let Pt=G.fog,Ut=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?G.environment:null,It=ht===null?I.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:Ce.workingColorSpace,Ft=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Wt=N.get(Y.envMap||Ut,Ft),le=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,Se=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Vt=!!Q.morphAttributes.position,Me=!!Q.morphAttributes.normal,pn=!!Q.morphAttributes.color,Ge=Zs;Y.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Ge=I.toneMapping);let Ve=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Bn=Ve!==void 0?Ve.length:0,zt=$t.get(Y),Cn=T.state.lights;if(tn===!0&&(An===!0||P!==tt)){let We=P===tt&&Y.id===K;rt.setState(Y,P,We)}let Re=!1,nr=!1;Y.version===zt.__version?zt.needsLights&&zt.lightsStateVersion!==Cn.state.version||j.isBatchedMesh&&zt.batching===!1||!j.isBatchedMesh&&zt.batching===!0||j.isBatchedMesh&&zt.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&zt.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&zt.instancing===!1||!j.isInstancedMesh&&zt.instancing===!0||j.isSkinnedMesh&&zt.skinning===!1||!j.isSkinnedMesh&&zt.skinning===!0||j.isInstancedMesh&&zt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&zt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&zt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&zt.instancingMorph===!1&&j.morphTexture!==null||zt.envMap!==Wt||Y.fog===!0&&zt.fog!==Pt||zt.numClippingPlanes!==void 0&&(zt.numClippingPlanes!==rt.numPlanes||zt.numIntersection!==rt.numIntersection)||zt.vertexAlphas!==le||zt.vertexTangents!==Se||zt.morphTargets!==Vt||zt.morphNormals!==Me||zt.morphColors!==pn||zt.morphTargetsCount!==Bn||zt.numLightProbeGrids!==Tn(T.state.lightProbeGridArray)?Re=!0:(zt.outputColorSpace!==It||zt.toneMapping!==Ge)&&(nr=!0):(Re=!0,zt.__version=Y.version);let Pn=zt.currentProgram;(Re===!0||nr===!0)&&(Pn=nr===!0?ki(Y,G,j,It,Ge):Ns(Y,G,j),B&&Y.isNodeMaterial&&B.onUpdateProgram(Y,Pn,zt));let qo=!1,Us=!1,ir=!1,xe=Pn.getUniforms(),vn=zt.uniforms;if(Rt.useProgram(Pn.program)&&(qo=!0,Us=!0,ir=!0),Y.id!==K&&(K=Y.id,Us=!0),qo||tt!==P){Rt.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),xe.setValue(H,"projectionMatrix",P.projectionMatrix),xe.setValue(H,"viewMatrix",P.matrixWorldInverse);let In=xe.map.cameraPosition;In!==void 0&&In.setValue(H,$n.setFromMatrixPosition(P.matrixWorld)),pe.logarithmicDepthBuffer&&xe.setValue(H,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&xe.setValue(H,"isOrthographic",P.isOrthographicCamera===!0),tt!==P&&(tt=P,Us=!0,ir=!0)}if(zt.needsLights&&(Cn.state.sunShadowMap.length>0&&xe.setValue(H,"sunShadowMap",Cn.state.sunShadowMap,Qt),Cn.state.directionalShadowMap.length>0&&xe.setValue(H,"directionalShadowMap",Cn.state.directionalShadowMap,Qt),Cn.state.spotShadowMap.length>0&&xe.setValue(H,"spotShadowMap",Cn.state.spotShadowMap,Qt),Cn.state.pointShadowMap.length>0&&xe.setValue(H,"pointShadowMap",Cn.state.pointShadowMap,Qt)),j.isSkinnedMesh){xe.setOptional(H,j,"bindMatrix"),xe.setOptional(H,j,"bindMatrixInverse");let We=j.skeleton;We&&(We.boneTexture===null&&We.computeBoneTexture(),xe.setValue(H,"boneTexture",We.boneTexture,Qt))}j.isBatchedMesh&&(xe.setOptional(H,j,"batchingTexture"),xe.setValue(H,"batchingTexture",j._matricesTexture,Qt),xe.setOptional(H,j,"batchingIdTexture"),xe.setValue(H,"batchingIdTexture",j._indirectTexture,Qt),xe.setOptional(H,j,"batchingColorTexture"),j._colorsTexture!==null&&xe.setValue(H,"batchingColorTexture",j._colorsTexture,Qt));let pi=Q.morphAttributes;if((pi.position!==void 0||pi.normal!==void 0||pi.color!==void 0)&&at.update(j,Q,Pn),(Us||zt.receiveShadow!==j.receiveShadow)&&(zt.receiveShadow=j.receiveShadow,xe.setValue(H,"receiveShadow",j.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&G.environment!==null&&(vn.envMapIntensity.value=G.environmentIntensity),vn.dfgLUT!==void 0&&(vn.dfgLUT.value=OR()),Us){if(xe.setValue(H,"toneMappingExposure",I.toneMappingExposure),zt.needsLights&&Vo(vn,ir),Pt&&Y.fog===!0&&St.refreshFogUniforms(vn,Pt),St.refreshMaterialUniforms(vn,Y,At,Lt,T.state.transmissionRenderTarget[P.id]),zt.needsLights&&zt.numLightProbeGrids>0){let We=v,In=0;for(let ri of T.state.lightProbeGridArray)ri.texture!==null&&(We.textures[In]=ri.texture,We.min[In]=ri.boundingBox.min,We.max[In]=ri.boundingBox.max,We.resolution[In]=ri.resolution,In++);for(let ri in We)We[ri].length=In;vn.probesSH.value=We.textures,vn.probesMin.value=We.min,vn.probesMax.value=We.max,vn.probesResolution.value=We.resolution}Ba.upload(H,Ir(zt),vn,Qt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Ba.upload(H,Ir(zt),vn,Qt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&xe.setValue(H,"center",j.center),xe.setValue(H,"modelViewMatrix",j.modelViewMatrix),xe.setValue(H,"normalMatrix",j.normalMatrix),xe.setValue(H,"modelMatrix",j.matrixWorld),Y.uniformsGroups!==void 0){let We=Y.uniformsGroups;for(let In=0,ri=We.length;In<ri;In++){let iu=We[In];Zt.update(iu,Pn),Zt.bind(iu,Pn)}}return Pn}function Vo(P,G){P.ambientLightColor.needsUpdate=G,P.lightProbe.needsUpdate=G,P.sunLights.needsUpdate=G,P.sunLightShadows.needsUpdate=G,P.directionalLights.needsUpdate=G,P.directionalLightShadows.needsUpdate=G,P.pointLights.needsUpdate=G,P.pointLightShadows.needsUpdate=G,P.spotLights.needsUpdate=G,P.spotLightShadows.needsUpdate=G,P.rectAreaLights.needsUpdate=G,P.hemisphereLights.needsUpdate=G}function Lr(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return q},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(P,G,Q){let Y=$t.get(P);Y.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),$t.get(P.texture).__webglTexture=G,$t.get(P.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,G){let Q=$t.get(P);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(P,G=0,Q=0){ht=P,Z=G,q=Q;let Y=null,j=!1,Pt=!1;if(P){let It=$t.get(P);if(It.__useDefaultFramebuffer!==void 0){Rt.bindFramebuffer(H.FRAMEBUFFER,It.__webglFramebuffer),ot.copy(P.viewport),mt.copy(P.scissor),pt=P.scissorTest,Rt.viewport(ot),Rt.scissor(mt),Rt.setScissorTest(pt),K=-1;return}else if(It.__webglFramebuffer===void 0)Qt.setupRenderTarget(P);else if(It.__hasExternalTextures)Qt.rebindTextures(P,$t.get(P.texture).__webglTexture,$t.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let le=P.depthTexture;if(It.__boundDepthTexture!==le){if(le!==null&&$t.has(le)&&(P.width!==le.image.width||P.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Qt.setupDepthRenderbuffer(P)}}let Ft=P.texture;(Ft.isData3DTexture||Ft.isDataArrayTexture||Ft.isCompressedArrayTexture)&&(Pt=!0);let Wt=$t.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray(Wt[G])?Y=Wt[G][Q]:Y=Wt[G],j=!0):P.samples>0&&Qt.useMultisampledRTT(P)===!1?Y=$t.get(P).__webglMultisampledFramebuffer:Array.isArray(Wt)?Y=Wt[Q]:Y=Wt,ot.copy(P.viewport),mt.copy(P.scissor),pt=P.scissorTest}else ot.copy(Xt).multiplyScalar(At).floor(),mt.copy(ve).multiplyScalar(At).floor(),pt=_e;if(Q!==0&&(Y=V),Rt.bindFramebuffer(H.FRAMEBUFFER,Y)&&Rt.drawBuffers(P,Y),Rt.viewport(ot),Rt.scissor(mt),Rt.setScissorTest(pt),j){let It=$t.get(P.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+G,It.__webglTexture,Q)}else if(Pt){let It=G;for(let Ft=0;Ft<P.textures.length;Ft++){let Wt=$t.get(P.textures[Ft]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+Ft,Wt.__webglTexture,Q,It)}}else if(P!==null&&Q!==0){let It=$t.get(P.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,It.__webglTexture,Q)}K=-1};function Wo(P){let G=$t.get(P);return(G.__readFormat!==P.format||G.__readType!==P.type)&&(G.__readFormat=P.format,G.__readType=P.type,G.__formatReadable=pe.textureFormatReadable(P.format),G.__typeReadable=pe.textureTypeReadable(P.type)),G}this.readRenderTargetPixels=function(P,G,Q,Y,j,Pt,Ut,It=0){if(!(P&&P.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=$t.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft){Rt.bindFramebuffer(H.FRAMEBUFFER,Ft);try{let Wt=P.textures[It],le=Wt.format,Se=Wt.type;P.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+It);let Vt=Wo(Wt);if(Vt.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=P.width-Y&&Q>=0&&Q<=P.height-j&&H.readPixels(G,Q,Y,j,bt.convert(le),bt.convert(Se),Pt)}finally{let Wt=ht!==null?$t.get(ht).__webglFramebuffer:null;Rt.bindFramebuffer(H.FRAMEBUFFER,Wt)}}},this.readRenderTargetPixelsAsync=async function(P,G,Q,Y,j,Pt,Ut,It=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=$t.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Ut!==void 0&&(Ft=Ft[Ut],Array.isArray(Ft)&&(Ft=Ft[0])),Ft)if(G>=0&&G<=P.width-Y&&Q>=0&&Q<=P.height-j){Rt.bindFramebuffer(H.FRAMEBUFFER,Ft);let Wt=P.textures[It],le=Wt.format,Se=Wt.type;P.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+It);let Vt=Wo(Wt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Me=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,Me),H.bufferData(H.PIXEL_PACK_BUFFER,Pt.byteLength,H.STREAM_READ),H.readPixels(G,Q,Y,j,bt.convert(le),bt.convert(Se),0),H.bindBuffer(H.PIXEL_PACK_BUFFER,null);let pn=ht!==null?$t.get(ht).__webglFramebuffer:null;Rt.bindFramebuffer(H.FRAMEBUFFER,pn);let Ge=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await _x(H,Ge,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,Me),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Pt),H.bindBuffer(H.PIXEL_PACK_BUFFER,null),H.deleteBuffer(Me),H.deleteSync(Ge),Pt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,G=null,Q=0){let Y=Math.pow(2,-Q),j=Math.floor(P.image.width*Y),Pt=Math.floor(P.image.height*Y),Ut=G!==null?G.x:0,It=G!==null?G.y:0;Qt.setTexture2D(P,0),H.copyTexSubImage2D(H.TEXTURE_2D,Q,0,0,Ut,It,j,Pt),Rt.unbindTexture()},this.copyTextureToTexture=function(P,G,Q=null,Y=null,j=0,Pt=0){let Ut,It,Ft,Wt,le,Se,Vt,Me,pn,Ge=P.isCompressedTexture?P.mipmaps[Pt]:P.image;if(Q!==null)Ut=Q.max.x-Q.min.x,It=Q.max.y-Q.min.y,Ft=Q.isBox3?Q.max.z-Q.min.z:1,Wt=Q.min.x,le=Q.min.y,Se=Q.isBox3?Q.min.z:0;else{let xe=Math.pow(2,-j);Ut=Math.floor(Ge.width*xe),It=Math.floor(Ge.height*xe),P.isDataArrayTexture?Ft=Ge.depth:P.isData3DTexture?Ft=Math.floor(Ge.depth*xe):Ft=1,Wt=0,le=0,Se=0}Y!==null?(Vt=Y.x,Me=Y.y,pn=Y.z):(Vt=0,Me=0,pn=0);let Ve=bt.convert(G.format),Bn=bt.convert(G.type),zt;G.isData3DTexture?(Qt.setTexture3D(G,0),zt=H.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Qt.setTexture2DArray(G,0),zt=H.TEXTURE_2D_ARRAY):(Qt.setTexture2D(G,0),zt=H.TEXTURE_2D),Rt.activeTexture(H.TEXTURE0),Rt.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,G.flipY),Rt.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Rt.pixelStorei(H.UNPACK_ALIGNMENT,G.unpackAlignment);let Cn=Rt.getParameter(H.UNPACK_ROW_LENGTH),Re=Rt.getParameter(H.UNPACK_IMAGE_HEIGHT),nr=Rt.getParameter(H.UNPACK_SKIP_PIXELS),Pn=Rt.getParameter(H.UNPACK_SKIP_ROWS),qo=Rt.getParameter(H.UNPACK_SKIP_IMAGES);Rt.pixelStorei(H.UNPACK_ROW_LENGTH,Ge.width),Rt.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Ge.height),Rt.pixelStorei(H.UNPACK_SKIP_PIXELS,Wt),Rt.pixelStorei(H.UNPACK_SKIP_ROWS,le),Rt.pixelStorei(H.UNPACK_SKIP_IMAGES,Se);let Us=P.isDataArrayTexture||P.isData3DTexture,ir=G.isDataArrayTexture||G.isData3DTexture;if(P.isDepthTexture){let xe=$t.get(P),vn=$t.get(G),pi=$t.get(xe.__renderTarget),We=$t.get(vn.__renderTarget);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,pi.__webglFramebuffer),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,We.__webglFramebuffer);for(let In=0;In<Ft;In++)Us&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$t.get(P).__webglTexture,j,Se+In),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$t.get(G).__webglTexture,Pt,pn+In)),H.blitFramebuffer(Wt,le,Wt+Ut,le+It,Vt,Me,Vt+Ut,Me+It,H.DEPTH_BUFFER_BIT,H.NEAREST);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,null),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(j!==0||P.isRenderTargetTexture||$t.has(P)){let xe=$t.get(P),vn=$t.get(G);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,O),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,$);for(let pi=0;pi<Ft;pi++)Us?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,xe.__webglTexture,j,Se+pi):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,xe.__webglTexture,j),ir?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,vn.__webglTexture,Pt,pn+pi):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,vn.__webglTexture,Pt),j!==0?H.blitFramebuffer(Wt,le,Wt+Ut,le+It,Vt,Me,Vt+Ut,Me+It,H.COLOR_BUFFER_BIT,H.NEAREST):ir?H.copyTexSubImage3D(zt,Pt,Vt,Me,pn+pi,Wt,le,Ut,It):H.copyTexSubImage2D(zt,Pt,Vt,Me,Wt,le,Ut,It);Rt.bindFramebuffer(H.READ_FRAMEBUFFER,null),Rt.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else ir?P.isDataTexture||P.isData3DTexture?H.texSubImage3D(zt,Pt,Vt,Me,pn,Ut,It,Ft,Ve,Bn,Ge.data):G.isCompressedArrayTexture?H.compressedTexSubImage3D(zt,Pt,Vt,Me,pn,Ut,It,Ft,Ve,Ge.data):H.texSubImage3D(zt,Pt,Vt,Me,pn,Ut,It,Ft,Ve,Bn,Ge):P.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Pt,Vt,Me,Ut,It,Ve,Bn,Ge.data):P.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Pt,Vt,Me,Ge.width,Ge.height,Ve,Ge.data):H.texSubImage2D(H.TEXTURE_2D,Pt,Vt,Me,Ut,It,Ve,Bn,Ge);Rt.pixelStorei(H.UNPACK_ROW_LENGTH,Cn),Rt.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Re),Rt.pixelStorei(H.UNPACK_SKIP_PIXELS,nr),Rt.pixelStorei(H.UNPACK_SKIP_ROWS,Pn),Rt.pixelStorei(H.UNPACK_SKIP_IMAGES,qo),Pt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&H.generateMipmap(zt),Rt.unbindTexture()},this.initRenderTarget=function(P){$t.get(P).__webglFramebuffer===void 0&&Qt.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?Qt.setTextureCube(P,0):P.isData3DTexture?Qt.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?Qt.setTexture2DArray(P,0):Qt.setTexture2D(P,0),Rt.unbindTexture()},this.resetState=function(){Z=0,q=0,ht=null,Rt.reset(),Tt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return os}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ce._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ce._getUnpackColorSpace()}};var Kt={},BR=["ground","gridFine","gridCoarse","link","joint","accent","ghost","ink","muted","line","trace","panel","wrong"],kR={light:["#0072b2","#d55e00","#009e73","#cc79a7","#8a6d00","#56b4e9","#4b4b4b","#7a3e9d"],dark:["#56b4e9","#ff9a4d","#2fd6a3","#f0a3cb","#f0e442","#8fb7ff","#d0d4da","#c9a0ff"]},ny=matchMedia("(prefers-color-scheme: dark)");function gd(){let n=M.theme==="dark"||M.theme==="auto"&&ny.matches;document.documentElement.dataset.theme=n?"dark":"light";let t=getComputedStyle(document.documentElement);for(let e of BR)Kt[e]=t.getPropertyValue(`--${e.replace(/[A-Z]/g,i=>`-${i.toLowerCase()}`)}`).trim();Kt.dark=n,Kt.curves=kR[n?"dark":"light"]}function _d(n){M.theme=n,gd(),ft("theme")}ny.addEventListener("change",()=>{M.theme==="auto"&&(gd(),ft("theme"))});var iy={type:"change"},Mm={type:"start"},ry={type:"end"},xd=new gr,sy=new ni,zR=Math.cos(70*to.DEG2RAD),Hn=new k,Ni=2*Math.PI,Fe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Sm=1e-6,yd=class extends cc{constructor(t,e=null){super(t,e),this.state=Fe.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Zr.ROTATE,MIDDLE:Zr.DOLLY,RIGHT:Zr.PAN},this.touches={ONE:jr.ROTATE,TWO:jr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new an,this._lastTargetPosition=new k,this._quat=new an().setFromUnitVectors(t.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Da,this._sphericalDelta=new Da,this._scale=1,this._panOffset=new k,this._rotateStart=new qt,this._rotateEnd=new qt,this._rotateDelta=new qt,this._panStart=new qt,this._panEnd=new qt,this._panDelta=new qt,this._dollyStart=new qt,this._dollyEnd=new qt,this._dollyDelta=new qt,this._dollyDirection=new k,this._mouse=new qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=GR.bind(this),this._onPointerDown=HR.bind(this),this._onPointerUp=VR.bind(this),this._onContextMenu=jR.bind(this),this._onMouseWheel=$R.bind(this),this._onKeyDown=XR.bind(this),this._onTouchStart=YR.bind(this),this._onTouchMove=ZR.bind(this),this._onMouseDown=WR.bind(this),this._onMouseMove=qR.bind(this),this._interceptControlDown=JR.bind(this),this._interceptControlUp=KR.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Fe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(iy),this.update(),this.state=Fe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Hn.copy(e).sub(this.target),Hn.applyQuaternion(this._quat),this._spherical.setFromVector3(Hn),this.autoRotate&&this.state===Fe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Ni:i>Math.PI&&(i-=Ni),s<-Math.PI?s+=Ni:s>Math.PI&&(s-=Ni),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Hn.setFromSpherical(this._spherical),Hn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Hn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Hn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new k(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Hn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(xd.origin.copy(this.object.position),xd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(xd.direction))<zR?this.object.lookAt(this.target):(sy.setFromNormalAndCoplanarPoint(this.object.up,this.target),xd.intersectPlane(sy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Sm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Sm||this._lastTargetPosition.distanceToSquared(this.target)>Sm?(this.dispatchEvent(iy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Ni/60*this.autoRotateSpeed*t:Ni/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Hn.setFromMatrixColumn(e,0),Hn.multiplyScalar(-t),this._panOffset.add(Hn)}_panUp(t,e){this.screenSpacePanning===!0?Hn.setFromMatrixColumn(e,1):(Hn.setFromMatrixColumn(e,0),Hn.crossVectors(this.object.up,Hn)),Hn.multiplyScalar(t),this._panOffset.add(Hn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Hn.copy(s).sub(this.target);let r=Hn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ni*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ni*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Ni*this._rotateDelta.x/e.clientHeight),this._rotateUp(Ni*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function HR(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function GR(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function VR(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(ry),this.state=Fe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function WR(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Zr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Fe.DOLLY;break;case Zr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Fe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Fe.ROTATE}break;case Zr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Fe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Fe.PAN}break;default:this.state=Fe.NONE}this.state!==Fe.NONE&&this.dispatchEvent(Mm)}function qR(n){switch(this.state){case Fe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Fe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Fe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function $R(n){this.enabled===!1||this.enableZoom===!1||this.state!==Fe.NONE||(n.preventDefault(),this.dispatchEvent(Mm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(ry))}function XR(n){this.enabled!==!1&&this._handleKeyDown(n)}function YR(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case jr.ROTATE:if(this.enableRotate===!1){this.state=Fe.NONE;break}this._handleTouchStartRotate(n),this.state=Fe.TOUCH_ROTATE;break;case jr.PAN:if(this.enablePan===!1){this.state=Fe.NONE;break}this._handleTouchStartPan(n),this.state=Fe.TOUCH_PAN;break;default:this.state=Fe.NONE}break;case 2:switch(this.touches.TWO){case jr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Fe.TOUCH_DOLLY_PAN;break;case jr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Fe.TOUCH_DOLLY_ROTATE;break;default:this.state=Fe.NONE}break;default:this.state=Fe.NONE}this.state!==Fe.NONE&&this.dispatchEvent(Mm)}function ZR(n){switch(this._trackPointer(n),this.state){case Fe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Fe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Fe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Fe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Fe.NONE}}function jR(n){this.enabled!==!1&&n.preventDefault()}function JR(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function KR(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var oy=[1,.75,.55,.42],QR=30,tC=17,eC=400,ay=6e6;function ly(n){let t=n.getExtension("WEBGL_debug_renderer_info");return/swiftshader|llvmpipe|software|basic render/i.test(String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER)))}var vd=class{constructor(t,e,i,s){this.software=t,this.renderer=e,this.draw=i,this.hurry=s,this.resting=!0,this.level=0,this.gaps=[],this.last=0,this.area=1}resized(t,e){this.area=t*e}get base(){return Math.min(devicePixelRatio,2,Math.sqrt(ay/this.area))}#t(t){Math.abs(this.renderer.getPixelRatio()-t)>.001&&this.renderer.setPixelRatio(t)}moving(t){if(!this.software){this.#t(this.base);return}let e=t-this.last;if(this.last=t,e<120&&this.gaps.push(e),this.gaps.length>=8){let i=this.gaps.sort((s,r)=>s-r)[4];this.gaps=[],i>QR&&this.level<oy.length-1?this.level+=1:i<tC&&this.level>0&&(this.level-=1)}this.resting&&this.hurry(!0),this.resting=!1,this.#t(this.base*oy[this.level]),clearTimeout(this.timer),this.timer=setTimeout(()=>{this.gaps=[],this.resting=!0,this.hurry(!1),this.#t(Math.min(2*this.base,Math.max(Math.sqrt(ay/this.area),.5))),this.draw()},eC)}};var hy=32,dy={iso:[1,-1.25,.62],front:[1,0,0],side:[0,-1,0],top:[0,-1e-4,1]},_n=new ql,Oe=new Si(hy,1,.01,100);Oe.up.set(0,0,1);var Ji,wn,us,Tm,wm=!1,fy=!1,Am=0;function we(){wm||!fy||(wm=!0,requestAnimationFrame(py))}function py(n=performance.now()){wm=!1,Tm.moving(n),Rm()}var my=[],gy=n=>my.push(n);function Rm(){for(let n of my)n();Ji.render(_n,Oe),Am+=1}function _y(){fy=!0,we()}function za(n){return Rm(),n(Ji.domElement)}var xy=()=>Am;_n.fog=new Wl("#fff",1,10);function cy(n){let t=document.createElement("canvas");t.width=us.clientWidth||1,t.height=us.clientHeight||1;let e=t.getContext("webgl2",{alpha:!1,antialias:n,stencil:!0,powerPreference:"high-performance"});if(!e)throw new Error("This browser offers no WebGL 2, which the picture needs.");let i=e.getExtension.bind(e);return e.getExtension=s=>nC.has(s)?i(s):null,e}var nC=new Set(["WEBGL_debug_renderer_info","WEBGL_lose_context"]);function yy(n){us=n;let t=cy(!1),e=ly(t);e||(t.getExtension("WEBGL_lose_context")?.loseContext(),t=cy(!0)),Ji=new fd({canvas:t.canvas,context:t}),Ji.debug.checkShaderErrors=!1,Tm=new vd(e,Ji,Rm,i=>ft("hurry",i)),Ji.domElement.setAttribute("aria-hidden","true"),us.append(Ji.domElement),wn=new yd(Oe,Ji.domElement),wn.enableDamping=!1,wn.addEventListener("change",we),wn.addEventListener("end",()=>{Sc=!by(),Ro=null}),new ResizeObserver(iC).observe(us),us.tabIndex=0,us.setAttribute("role","application"),us.setAttribute("aria-label","The arm in space. Arrow keys turn the view, plus and minus zoom, F fits, 1 to 4 are the standard views."),us.addEventListener("keydown",sC)}function iC(){let n=us.clientWidth,t=us.clientHeight;!n||!t||(Tm.resized(n,t),Ji.setSize(n,t),Oe.aspect=n/t,Oe.updateProjectionMatrix(),Am?py():we(),Ha())}function sC(n){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]}[n.key],e={1:"iso",2:"front",3:"side",4:"top"}[n.key];if(t)rC(t[0]*.1,t[1]*.1);else if(n.key==="+"||n.key==="=")uy(1/1.15);else if(n.key==="-")uy(1.15);else if(n.key.toLowerCase()==="f")Sd(Co);else if(e)Cm(e);else return;n.preventDefault()}function rC(n,t){let e=Oe.position.clone().sub(wn.target),i=e.length(),s=Math.atan2(e.y,e.x)+n,r=Math.min(Math.max(Math.acos(e.z/i)+t,.02),Math.PI-.02);Oe.position.set(Math.sin(r)*Math.cos(s),Math.sin(r)*Math.sin(s),Math.cos(r)).multiplyScalar(i).add(wn.target),wn.update(),we()}function uy(n){Oe.position.sub(wn.target).multiplyScalar(n).add(wn.target),wn.update(),we()}var Co=[[0,0,0],[0,0,1]];function vy(n,t){let e=new Li().setFromPoints(n.map(u=>new k(...u))),i=e.getCenter(new k),s=new k(...t).normalize(),r=new k().crossVectors(Oe.up,s).normalize(),o=new k().crossVectors(s,r),a=Math.tan(to.degToRad(hy/2))*.8,l=a*Oe.aspect,c=e.getSize(new k).length()*.4+.001;for(let u=0;u<3;u++){let h=0,d=1/0,f=-1/0,g=1/0,y=-1/0;for(let p of n){let m=new k(...p).sub(i),x=m.dot(r),E=m.dot(o),v=m.dot(s);h=Math.max(h,v+Math.abs(x)/l,v+Math.abs(E)/a),d=Math.min(d,E),f=Math.max(f,E),g=Math.min(g,x),y=Math.max(y,x)}c=Math.max(h,c*.2),u<2&&i.addScaledVector(o,(d+f)/2).addScaledVector(r,(g+y)/2)}return{target:i,position:i.clone().addScaledVector(s,c)}}var Em=0;function bd({target:n,position:t},e=.35){let i={t:wn.target.clone(),p:Oe.position.clone()},s=performance.now(),r=++Em,o=matchMedia("(prefers-reduced-motion: reduce)").matches||e===0;(function a(l){if(r!==Em)return;let c=o?1:Math.min((l-s)/(1e3*e),1),u=c*c*(3-2*c);wn.target.lerpVectors(i.t,n,u),Oe.position.lerpVectors(i.p,t,u);let h=Oe.position.distanceTo(wn.target);Oe.near=h/100,Oe.far=h*30,_n.fog.near=h*1.3,_n.fog.far=h*3.4,Oe.updateProjectionMatrix(),wn.update(),we(),c<1&&requestAnimationFrame(a)})(s)}function Sd(n,{instant:t=!1,view:e=null,byItself:i=!1}={}){Co=n,i||(Ro=null),Sc=!1;let s=e?dy[e]:Oe.position.clone().sub(wn.target).toArray();bd(vy(n,s),t?0:.35)}function Cm(n){Sc=!1,Ro=null,bd(vy(Co,dy[n]))}var Sc=!1;function by(){Oe.updateMatrixWorld();let n=new k;return Co.every(t=>(n.set(...t).project(Oe),Math.abs(n.x)<1&&Math.abs(n.y)<1&&n.z<1))}function Ha(){Sc||!wn.enabled||!Co.length||by()||(Ro??={position:Oe.position.clone(),target:wn.target.clone()},Sd(Co,{byItself:!0}))}var Ro=null;function Sy(){if(!Ro||Sc||!wn.enabled)return;let n=Ro;Ro=null,bd(n),setTimeout(Ha,500)}var Pm=n=>{Co=n},Md=()=>[...Oe.position.toArray(),...wn.target.toArray()].map(n=>Number(n.toPrecision(5)));function My(n){Em+=1,bd({position:new k(...n.slice(0,3)),target:new k(...n.slice(3))},0)}var Ks=null,Im={cell:.1};function Lm(n){let t=n/6,e=10**Math.floor(Math.log10(t)),i=[1,2,5,10].map(u=>u*e).findLast(u=>u<=t*1.0001)??e;Im.cell=i;let s=Math.ceil(n*2.2/i),r=[],o=[],a=new ie(Kt.gridFine),l=new ie(Kt.gridCoarse);for(let u=-s;u<=s;u++){let h=u%5===0?l:a,d=s*i;r.push(u*i,-d,0,u*i,d,0,-d,u*i,0,d,u*i,0);for(let f=0;f<4;f++)o.push(h.r,h.g,h.b)}Ks?.geometry.dispose();let c=new Ae;c.setAttribute("position",new Pe(r,3)),c.setAttribute("color",new Pe(o,3)),Ks?Ks.geometry=c:(Ks=new bo(c,new Xi({vertexColors:!0})),Ks.renderOrder=-2,Ks.material.depthWrite=!1,_n.add(Ks)),Ks.userData.reach=n,we()}function Dm(){_n.background=new ie(Kt.ground),_n.fog.color.set(Kt.ground),Ks&&Lm(Ks.userData.reach),we()}function Ui(n){Oe.updateMatrixWorld();let t=new k(...n).project(Oe),e=us.getBoundingClientRect();return[e.x+(t.x+1)/2*e.width,e.y+(1-t.y)/2*e.height]}function wd(n){let t=n.joints.length,e=oi(n),i=Math.min(.062,.075-.002*t)*e,s=n.joints.map((r,o)=>i*(1-.52*o/Math.max(t-1,1)));return{size:e,radius:s,rest:s[t-1]??i*.5}}function Nm(n,t,e,i=null){let s={rods:[],balls:[],drums:[],sleeves:[],flange:null},{radius:r,size:o}=e,a=n.joints.length,l=o*1e-6,c=Zf(n,t),u=(d,f,g,y=!0)=>{ss(Pi(f,d))<=l||(s.rods.push({a:d,b:f,r:g}),y&&s.balls.push({at:f,r:g}))};a&&(s.pedestal={at:ne(t[0]),dir:zs(t[0],2),r:r[0]*1.7,h:r[0]*.34});let h=null;if(c.forEach(({point:d,dir:f,x:g},y)=>{let p=r[y],m=n.joints[y],x=ne(t[y]),E=ne(t[y+1]),v=p*.62;if(n.convention==="standard"){let B=Ml(x,f,Sl(Pi(E,x),f));u(x,B,v),u(B,E,v)}else u(x,d,v),u(d,E,v);let A=d,T=Sl(Pi(E,d),f);h&&ss(Pi(d,h.at))<.5*p&&Math.abs(T)>l?A=Ml(d,f,Math.sign(T)*Math.min(Math.abs(T)*.55,h.r+p*1.15)):y===0&&Math.abs(T)>2.2*p&&(A=Ml(d,f,Math.sign(T)*p*1.25));let _=p*2.15,S=zs(t[y+1],0),L=!!(i&&Um(m,i[y])),I=zs(t[0],2),D=Sl(Pi(A,ne(t[0])),I)-_/2;y===0&&m.type==="R"&&Math.abs(Sl(f,I))>.99&&D<0&&D>-_&&(A=Ml(A,I,-D)),m.type==="R"?s.drums.push({at:A,dir:f,x:g,turned:S,r:p,h:_,beyond:L,joint:y}):s.sleeves.push({at:A,dir:f,x:g,r:p*.95,h:p*3.4,beyond:L,joint:y}),h={at:d,r:p}}),a){let d=t[a+1],f=ne(t[a]);s.flange={at:f,dir:zs(t[a],2),turned:zs(t[a],0),r:e.rest*.85,h:e.rest*.5},u(f,ne(d),e.rest*.34,!1),s.tip={at:ne(d),r:e.rest*.42}}return s}function Um(n,t){return n.lower!==null&&t<n.lower-1e-9?t-n.lower:n.upper!==null&&t>n.upper+1e-9?t-n.upper:0}function Mc(n,t){let e=wd(n).radius[0]??.05,i=ne(t[0]);if(!n.joints.length)return[-.4,.4].flatMap(r=>[[i[0]+r,i[1]+r,0],[i[0]+r,i[1]-r,1]]);let s=[[i[0],i[1],0],...t.map(ne)];for(let{point:r}of Zf(n,t))s.push(r);return s.flatMap(r=>[[r[0]-e,r[1]-e,r[2]-e],[r[0]+e,r[1]+e,r[2]+e]])}function aC(n,t){let i=a=>a.rotateX(Math.PI/2),s=[[0,-.5],[.9,-.5],[1,-.45],[1,.45],[.9,.5],[0,.5]],r=t>8?new ic(s.map(([a,l])=>new qt(a,l)),n):new Yi(1,1,1,n),o={rod:i(new Yi(1,1,1,n,1,!0)),ball:t>3?new yr(1,n,t):new sc(1,0),drum:i(r),box:new as(2,2,1)};return Object.fromEntries(Object.entries(o).map(([a,l])=>{let c=l.attributes.position,u=l.index?l.index.array:Uint16Array.from({length:c.count},(h,d)=>d);return[a,{at:c.array,normal:l.attributes.normal.array,index:u,count:c.count}]}))}var wy=new Map,km=(n,t)=>wy.get(n)??wy.set(n,aC(n,t)).get(n),lC=()=>km(26,12),Fm=()=>km(11,5),Ey=()=>km(6,3),Td=class{constructor(t){this.mesh=new fn(new Ae,t),this.mesh.frustumCulled=!1,this.mesh.visible=!1,this.#t(1024,4096),this.clear()}#t(t,e){let i=this.mesh.geometry.attributes,s=new Ae,r=(a,l)=>{let c=new Float32Array(l*t);i[a]&&c.set(i[a].array);let u=new je(c,l).setUsage(ld);return s.setAttribute(a,u),c};this.at=r("position",3),this.normal=r("normal",3),this.paint=r("paint",1);let o=new Uint32Array(e);this.index&&o.set(this.index),this.index=o,s.setIndex(new je(o,1).setUsage(ld)),this.mesh.geometry.dispose(),this.mesh.geometry=s}clear(){this.corners=0,this.indices=0}put(t,e,i,s,r,o,a,l){let c=this.corners,u=c+t.count;(3*u>this.at.length||this.indices+t.index.length>this.index.length)&&this.#t(2*Math.max(u,this.at.length/3),2*Math.max(this.indices+t.index.length,this.index.length));for(let h=0,d=3*c;h<3*t.count;h+=3,d+=3){let f=a*t.at[h],g=a*t.at[h+1],y=l*t.at[h+2],p=t.normal[h]/a,m=t.normal[h+1]/a,x=t.normal[h+2]/l;for(let E=0;E<3;E++)this.at[d+E]=i[E]+s[E]*f+r[E]*g+o[E]*y,this.normal[d+E]=s[E]*p+r[E]*m+o[E]*x}this.paint.fill(e,c,u);for(let h=0;h<t.index.length;h++)this.index[this.indices+h]=c+t.index[h];this.corners=u,this.indices+=t.index.length}done(){let t=this.mesh.geometry;for(let[e,i]of[[t.attributes.position,3*this.corners],[t.attributes.normal,3*this.corners],[t.attributes.paint,this.corners],[t.index,this.indices]])e.clearUpdateRanges(),e.addUpdateRange(0,i),e.needsUpdate=!0;t.setDrawRange(0,this.indices),this.mesh.visible=this.indices>0}},Ay=[1,0,0],cC=[0,1,0],Ry=[0,0,1];function uC(n,t=null){let e=t&&Math.abs(n[0]*t[0]+n[1]*t[1]+n[2]*t[2])<.5?t:au(n,Math.abs(n[2])<.9?Ry:Ay),i=au(n,e),s=ss(i)||1,r=i.map(o=>o/s);return[au(r,n),r]}var Om=0,Ed=1,Bm=2,Ty=3,Ga=class{constructor(t,{shadow:e=null,veil:i=!1}={}){this.group=new Nn,this.veil=i,this.moving=!1,this.arms=[],this.body=new Td(t),this.group.add(this.body.mesh),e&&(this.flat=new Td(e.material),this.flat.mesh.matrixAutoUpdate=!1,this.flat.mesh.matrix.copy(e.matrix),this.flat.mesh.renderOrder=-1,this.group.add(this.flat.mesh))}hurry(t){this.moving=t,this.show(this.arms)}show(t){this.arms=t,this.body.clear();let e=this.veil?this.moving?Ey:Fm:this.moving?Fm:lC;for(let i of t)this.#t(this.body,i,e());if(this.body.done(),!!this.flat){this.flat.clear();for(let i of t)this.#t(this.flat,i,this.moving?Ey():Fm(),!0);this.flat.done()}}#t(t,e,i,s=!1){let r=this.veil?.95:1,o=!this.veil&&!s,a=(c,u,h,d,f,g,y)=>t.put(c,u,h,...uC(d,y),d,f,g),l=(c,u,h)=>t.put(i.ball,c,u,Ay,cC,Ry,h,h);for(let{a:c,b:u,r:h}of e.rods){let d=Pi(u,c),f=ss(d),g=[(c[0]+u[0])/2,(c[1]+u[1])/2,(c[2]+u[2])/2];a(i.rod,Om,g,d.map(y=>y/f),r*h,f)}for(let{at:c,r:u}of e.balls)l(Om,c,r*u);for(let{at:c,dir:u,turned:h,r:d,h:f,beyond:g}of e.drums){if(a(i.drum,g&&o?Ty:Ed,c,u,r*d,r*f),!o)continue;a(i.rod,Bm,c,u,d*1.012,f*.13);let y=[0,1,2].map(p=>c[p]+h[p]*d*.96);a(i.box,Om,y,u,d*.11,f*.86,h)}for(let{at:c,dir:u,x:h,r:d,h:f,beyond:g}of e.sleeves)a(i.box,g&&o?Ty:Ed,c,u,r*d,r*f,h);if(e.pedestal&&!this.veil){let{at:c,dir:u,r:h,h:d}=e.pedestal;a(i.drum,Ed,[c[0]+u[0]*d/2,c[1]+u[1]*d/2,c[2]+u[2]*d/2],u,h,d)}if(e.flange&&a(i.drum,Ed,e.flange.at,e.flange.dir,e.flange.r,e.flange.h),e.flange&&o){let{at:c,dir:u,turned:h,r:d,h:f}=e.flange;a(i.box,Bm,[0,1,2].map(g=>c[g]+h[g]*d*.95),u,d*.16,f*1.04,h)}e.tip&&o&&l(Bm,e.tip.at,e.tip.r)}};var hC=`
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
  }`,dC=`
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
  }`,fC=`
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
  }`,pC=`
  uniform float opacity;
  varying vec3 vColour;
  void main() {
    gl_FragColor = vec4(vColour, opacity);
  }`;function Ad({opacity:n=1,gloss:t=.16,veil:e=!1}={}){let i=new ls({vertexShader:e?fC:hC,fragmentShader:e?pC:dC,transparent:n<1,uniforms:{colours:{value:[0,1,2,3].map(()=>new ie)},opacity:{value:n},gloss:{value:t},sky:{value:new ie(.46,.46,.47)},ground:{value:new ie(.2,.2,.21)}}});return i.repaint=(s,r,o,a,l=o)=>{[s,r,o,l].forEach((c,u)=>i.uniforms.colours.value[u].set(c)),i.uniforms.sky.value.setScalar(a?.36:.47),i.uniforms.ground.value.setScalar(a?.1:.2)},i}function zm(n,t=!1){let e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new Ae;l.morphTargetsRelative=a;let c=0;for(let u=0;u<n.length;++u){let h=n[u],d=0,f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let g in h.attributes){if(!i.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+g+'" attribute exists among all geometries, or in none of them.'),null;r[g]===void 0&&(r[g]=[]),r[g].push(h.attributes[g]),d++}if(d!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let g in h.morphAttributes){if(!s.has(g))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[g].length!==n[0].morphAttributes[g].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+g+'" morph attribute.'),null;o[g]===void 0&&(o[g]=[]),o[g].push(h.morphAttributes[g]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(t){let g;if(e)g=h.index.count;else if(h.attributes.position!==void 0)g=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,g,u),c+=g}}if(e){let u=0,h=[];for(let d=0;d<n.length;++d){let f=n[d].index;for(let g=0;g<f.count;++g)h.push(f.getX(g)+u);u+=n[d].attributes.position.count}l.setIndex(h)}for(let u in r){let h=Cy(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let d=0;d<h;++d){let f=[];for(let y=0;y<o[u].length;++y)f.push(o[u][y][d]);let g=Cy(f);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}}return l}function Cy(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){let u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}let o=new t(r),a=new je(o,e,i),l=0;for(let c=0;c<n.length;++c){let u=n[c];if(u.isInterleavedBufferAttribute){let h=l/e;for(let d=0,f=u.count;d<f;d++)for(let g=0;g<e;g++){let y=u.getComponent(d,g);a.setComponent(d+h,g,y)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}var Mr=["#d8343f","#1b9a50","#2f6fe0"];function Hm(n,t){let e=new Yi(.028,.028,.82,8).translate(0,.41,0),i=new So(.085,.22,12).translate(0,.9,0),s=zm([e,i]).applyMatrix4(t),r=new ie(n),o=new Float32Array(s.attributes.position.count*3);for(let a=0;a<o.length;a+=3)o.set([r.r,r.g,r.b],a);return s.setAttribute("color",new je(o,3)),s}var Gm=n=>new ge().makeRotationFromQuaternion(new an().setFromUnitVectors(new k(0,1,0),new k(...n))),mC=zm([Hm(Mr[0],Gm([1,0,0])),Hm(Mr[1],Gm([0,1,0])),Hm(Mr[2],Gm([0,0,1]))]),Py=.021,wc=new Map;function gC(n){let t=`${n}/${Kt.dark}`;if(wc.has(t))return wc.get(t);let e=document.createElement("canvas"),i=4,s=e.getContext("2d",{willReadFrequently:!0}),r=`600 ${13*i}px "Inter Variable", system-ui, sans-serif`;s.font=r,e.width=s.measureText(n).width+12*i,e.height=20*i,s.font=r,s.textAlign="center",s.textBaseline="middle",s.lineWidth=4*i,s.lineJoin="round",s.strokeStyle=Kt.ground,s.strokeText(n,e.width/2,e.height/2),s.fillStyle=Kt.ink,s.fillText(n,e.width/2,e.height/2);let o=new Ql(e);o.colorSpace=bi;let a=new Ca({map:o,depthTest:!1,sizeAttenuation:!1,fog:!1});return a.userData.aspect=e.width/e.height,wc.set(t,a),a}var Va=class{constructor(){this.group=new Nn,this.mesh=new Jl(mC,new ii({vertexColors:!0,fog:!1}),64),this.mesh.frustumCulled=!1,this.mesh.count=0,this.sprites=[],this.group.add(this.mesh)}show(t,e){this.last=[t,e];let i=new ge;this.mesh.count=t.length,this.sprites.forEach((s,r)=>{s.visible=r<t.length}),t.forEach(({T:s,name:r},o)=>{this.mesh.setMatrixAt(o,i.set(...s).scale(new k(e,e,e)));let a=this.sprites[o]??(this.sprites[o]=new Zl);a.parent||this.group.add(a),a.material=gC(r),a.scale.set(Py*a.material.userData.aspect,Py,1),a.renderOrder=5;let l=e*.16;a.position.set(s[3]-l*(s[0]+s[1]+s[2]),s[7]-l*(s[4]+s[5]+s[6]),s[11]-l*(s[8]+s[9]+s[10]))}),this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.visible=t.length>0}paint(){for(let t of wc.values())t.map.dispose(),t.dispose();wc.clear(),this.last&&this.show(...this.last)}};var Wm=180/Math.PI,Fi={angle:"deg",length:"mm"},_C={deg:"\xB0",rad:"rad",mm:"mm",m:"m"},Vm={deg:Wm,rad:1,mm:1e3,m:1},xC={deg:2,rad:4,mm:2,m:5},yC={deg:1,rad:.02,mm:5,m:.005},gt={get angle(){return Fi.angle},get length(){return Fi.length},set(n,t){t in Vm&&n in Fi&&(Fi[n]=t)},factor:n=>n in Fi?Vm[Fi[n]]:1,symbol:n=>n in Fi?_C[Fi[n]]:"",digits:n=>n in Fi?xC[Fi[n]]:4,step:n=>n in Fi?yC[Fi[n]]/Vm[Fi[n]]:.01,suffix:n=>n==="angle"?{deg:Wm,"\xB0":Wm,rad:1}:n==="length"?{mm:1e3,m:1,cm:100}:{}};function Qn(n,t){if(!Number.isFinite(n))return n===1/0?"\u221E":n===-1/0?"\u2212\u221E":"\u2013";let e=n.toFixed(t);return Number(e)===0?e.replace("-",""):e.replace("-","\u2212")}var Gn=(n,t,e=gt.digits(t))=>Qn(n*gt.factor(t),e),Ee=(n,t,e)=>`${Gn(n,t,e)}${t==="angle"&&Fi.angle==="deg"?"":" "}${gt.symbol(t)}`,Ec=(n,t="plain")=>String(Number((n*gt.factor(t)).toPrecision(9))+0),Rd=n=>n===0?"0":n.toExponential(0).replace("-","\u2212");function Wa(n,t){let e=n.map(s=>/^[-+−]?\d*[.,](\d+)$/.exec(s.trim())?.[1].length??0);return .5*10**-(Math.max(0,...e)||gt.digits(t))/gt.factor(t)}var vC={standard:["theta","d","a","alpha"],modified:["alpha","a","theta","d"]},bC={theta:(n,t,e)=>`turn by \u03B8${n} = ${Ee(t,"angle")} about z${e}`,d:(n,t,e)=>`go d${n} = ${Ee(t,"length")} along z${e}`,a:(n,t)=>`go a${n} = ${Ee(t,"length")} along x`,alpha:(n,t)=>`turn by \u03B1${n} = ${Ee(t,"angle")} about x`};function Iy(n,t,e){let i=Math.floor(e/4),s=e%4+1,r=vC[n.convention],o=or(n.joints[i],ar(n,t)[i]),a=Object.fromEntries(r.map((l,c)=>[l,c<s?o[l]:0]));return{i,key:r[s-1],value:o[r[s-1]],A:W0(n.convention,a.a,a.alpha,a.d,a.theta)}}function Ly(){let n=b("p",{class:"step-said",role:"status","data-testid":"dh-step-said"}),t=(o,a,l)=>b("button",{type:"button",text:o,"aria-label":a,on:{click:()=>i(l())}}),e=()=>4*M.table.joints.length-1,i=o=>{M.dhStep=o===null||o<0?null:Math.min(o,e()),r(),ft("frames")},s=b("details",{class:"fold","data-testid":"dh-steps"},b("summary",{text:"The frames, one step at a time"}),b("div",{class:"line"},t("First","To the base",()=>0),t("Back","One step back",()=>(M.dhStep??1)-1),t("On","One step on",()=>(M.dhStep??-1)+1),t("Last","To the end",e),n));s.addEventListener("toggle",()=>i(s.open?0:null));let r=()=>{if(M.dhStep===null||!M.table.joints.length){M.dhStep=null,yt(n,"");return}M.dhStep=Math.min(M.dhStep,e());let{i:o,key:a,value:l}=Iy(M.table,M.q,M.dhStep),c=M.table.convention==="standard"?o:o+1;yt(n,`Joint ${o+1}, ${M.dhStep%4+1} of 4: ${bC[a](o+1,l,c)}`)};return st(["q","table","units"],()=>M.dhStep!==null&&r()),st("panel",o=>{o!=="table"&&M.dhStep!==null&&(s.open=!1,i(null))}),s}function Cd(){let{i:n,A:t}=Iy(M.table,M.q,M.dhStep);return[...M.frames.slice(0,n+1).map((i,s)=>({T:i,name:s===0?"base":String(s)})),{T:ei(M.frames[n],t),name:`\u2192 ${n+1}`}]}var qm=(n,t,e)=>[n[0],t[0],e[0],0,n[1],t[1],e[1],0,n[2],t[2],e[2],0,0,0,0,1],qa=n=>[Math.cos(n),Math.sin(n)];function SC([n,t,e]){let[i,s]=qa(e),[r,o]=qa(t),[a,l]=qa(n);return qm([i*r,s*r,-o],[i*o*l-s*a,s*o*l+i*a,r*l],[i*o*a+s*l,s*o*a-i*l,r*a])}function MC(n){let t=Math.hypot(n[0],n[4]),e=Math.atan2(-n[8],t);return t>1e-9?[Math.atan2(n[9],n[10]),e,Math.atan2(n[4],n[0])]:[Math.atan2(-n[6],n[5]),e,0]}function wC([n,t,e]){let[i,s]=qa(n),[r,o]=qa(t),[a,l]=qa(e);return qm([i*r*a-s*l,s*r*a+i*l,-o*a],[-i*r*l-s*a,-s*r*l+i*a,o*l],[i*o,s*o,r])}function EC(n){let t=Math.hypot(n[2],n[6]);return t<1e-9?n[10]>0?[0,0,Math.atan2(n[4],n[0])]:[0,Math.PI,Math.atan2(n[4],-n[0])||0]:[Math.atan2(n[6],n[2]),Math.atan2(t,n[10]),Math.atan2(n[9],-n[8])]}function Pd(n){let t=[n[0]+n[5]+n[10],n[0]-n[5]-n[10],n[5]-n[0]-n[10],n[10]-n[0]-n[5]],e=t.indexOf(Math.max(...t)),i=2*Math.sqrt(Math.max(t[e]+1,0)),s=n[9]-n[6],r=n[2]-n[8],o=n[4]-n[1],a=n[1]+n[4],l=n[2]+n[8],c=n[6]+n[9],h=[[i/4,s/i,r/i,o/i],[s/i,i/4,a/i,l/i],[r/i,a/i,i/4,c/i],[o/i,l/i,c/i,i/4]][e],d=h[0]<0?-1:1;return h.map(f=>d*f+0)}function Tc(n){let t=Math.hypot(...n);if(t<1e-9)return null;let[e,i,s,r]=n.map(o=>o/t);return qm([1-2*(s*s+r*r),2*(i*s+e*r),2*(i*r-e*s)],[2*(i*s-e*r),1-2*(i*i+r*r),2*(s*r+e*i)],[2*(i*r+e*s),2*(s*r-e*i),1-2*(i*i+s*s)])}function TC(n){let[t,e,i,s]=Pd(n),r=Math.hypot(e,i,s);return r<1e-9?[0,0,1,0]:[e/r,i/r,s/r,2*Math.atan2(r,t)]}function AC([n,t,e,i]){let s=Math.hypot(n,t,e),r=Math.sin(i/2);return s<1e-9?null:Tc([Math.cos(i/2),r*n/s,r*t/s,r*e/s])}var Ts={rpy:{title:"Roll, pitch, yaw",order:"R = Rz(yaw) Ry(pitch) Rx(roll)",names:["roll","pitch","yaw"],kinds:["angle","angle","angle"],to:MC,from:SC},zyz:{title:"ZYZ Euler angles",order:"R = Rz(\u03C6) Ry(\u03B8) Rz(\u03C8)",names:["\u03C6","\u03B8","\u03C8"],kinds:["angle","angle","angle"],to:EC,from:wC},axis:{title:"Axis and angle",order:"unit axis x y z, then the turn about it",names:["x","y","z","angle"],kinds:["plain","plain","plain","angle"],to:TC,from:AC},quaternion:{title:"Quaternion",order:"order w x y z, scalar first, w \u2265 0",names:["w","x","y","z"],kinds:["plain","plain","plain","plain"],to:Pd,from:Tc}};function Dy(n,t,e){let i=Ts[n].from(t);return i?(i[3]=e[0],i[7]=e[1],i[11]=e[2],i):null}function Ny(n,t,e){let i=Pd(n),s=Pd(t),r=i.reduce((h,d,f)=>h+d*s[f],0);r<0&&(s=s.map(h=>-h),r=-r);let o=Math.acos(Math.min(r,1)),a=Math.sin(o),[l,c]=a<1e-7?[1-e,e]:[Math.sin((1-e)*o)/a,Math.sin(e*o)/a],u=Tc(i.map((h,d)=>l*h+c*s[d]));return[3,7,11].forEach(h=>{u[h]=n[h]+e*(t[h]-n[h])}),u}var $a=.145,Dd=.105,Qm=.165,Uy={mouse:13,pen:16,touch:28},RC=.2,io=["x","y","z"],Rc=72,Po=new Nn,Ld=new Map,Zm="both",Nd="local",tg=0,wr=!1,jm=null,Je=null,Ud=()=>Je!==null,zy=()=>wr,eo=null,no=null;function Hy(){Po.visible=!1,_n.add(Po),gy(eg),no=document.getElementById("view"),eo=b("output",{class:"gizmo-readout","data-testid":"gizmo-readout",hidden:!0}),document.getElementById("overlay").append(eo),no.addEventListener("pointerdown",UC,!0),no.addEventListener("pointermove",OC,!0);for(let n of["pointerup","pointercancel"])no.addEventListener(n,Zy,!0);addEventListener("keydown",n=>n.key==="Escape"&&Je&&kC()),st(["target","theme"],we)}function Ac(n,t,e=8){let i=new ii({color:t,depthTest:!1,depthWrite:!1,transparent:!0,opacity:.95,fog:!1}),s=new fn(n,i);return s.renderOrder=e,s.frustumCulled=!1,s.userData.colour=t,s}var CC=[new an().setFromUnitVectors(new k(0,1,0),new k(1,0,0)),new an,new an().setFromUnitVectors(new k(0,1,0),new k(0,0,1))],PC=[new an().setFromUnitVectors(new k(0,0,1),new k(1,0,0)),new an().setFromUnitVectors(new k(0,0,1),new k(0,1,0)),new an];function IC(){if(Ld.size)return;let n=(t,e)=>{Ld.set(t,e),Po.add(e)};io.forEach((t,e)=>{let i=new Yi(.0032,.0032,$a*.8,8).translate(0,$a*.45,0),s=new So(.0125,.034,14).translate(0,$a*.9,0),r=new Nn;r.add(Ac(i,Mr[e]),Ac(s,Mr[e])),r.userData.turn=CC[e],n(`move-${t}`,r);let o=Ac(new Ia(Dd,.0026,6,Rc),Mr[e],7);o.userData.turn=PC[e],n(`turn-${t}`,o)}),n("turn-view",Ac(new Ia(Qm,.0022,6,Rc),"#8891a0",7)),n("move-view",Ac(new yr(.0115,14,10),"#8891a0",9))}var Id=new k,so=new k,$m=new an;function Fd(){return 2*Math.tan(to.degToRad(Oe.fov/2))*Oe.position.distanceTo(Id)}var Pc=()=>Nd==="world"?[0,1,2].map(n=>[0,1,2].map(t=>+(n===t))):LC(),LC=()=>[0,1,2].map(n=>zs(M.target,n)),DC=new ge;function eg(){if(Po.visible=wr,!wr)return;Id.set(...ne(M.target)),so.copy(Oe.position).sub(Id).normalize(),Nd==="world"?$m.identity():$m.setFromRotationMatrix(DC.set(...M.target)),Po.position.copy(Id),Po.scale.setScalar(Fd());let n=Pc();for(let[t,e]of Ld){let[i,s]=t.split("-"),r=io.indexOf(s),o=Zm==="both"||Zm===i;e.visible=o&&NC(i,n[r])&&(!Je||Je.name===t),s==="view"?e.quaternion.copy(Oe.quaternion):e.quaternion.copy($m).multiply(e.userData.turn);let a=t===(Je?.name??jm);e.traverse(l=>l.material?.color.set(a?Kt.accent:l.userData.colour))}}function NC(n,t){return!t||n!=="move"?!0:Math.hypot(...Gy(t,so.toArray()))>RC}var Gy=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Cc=(n,t)=>ne(M.target).map((e,i)=>e+t*n[i]);function Jm(n,t){let e=Pc(),[i,s]=n<0?[Fy(Oe.matrixWorld,0),Fy(Oe.matrixWorld,1)]:[e[(n+1)%3],e[(n+2)%3]];return Array.from({length:Rc+1},(r,o)=>{let a=2*Math.PI*o/Rc,l=i.map((c,u)=>Math.cos(a)*c+Math.sin(a)*s[u]);return{p:Cc(l,t),front:n<0||l.reduce((c,u,h)=>c+u*so.getComponent(h),0)>-.15}})}var Fy=(n,t)=>[n.elements[4*t],n.elements[4*t+1],n.elements[4*t+2]];function Oy(n,t,[e,i],[s,r]){let o=s-e,a=r-i,l=o*o+a*a,c=l>0?Math.min(Math.max(((n-e)*o+(t-i)*a)/l,0),1):0;return Math.hypot(n-e-c*o,t-i-c*a)}function Km(n,t){let e=Fd(),i=[];for(let[s,r]of Ld){if(!r.visible)continue;let[o,a]=s.split("-"),l=io.indexOf(a),c=1/0;if(o==="move"&&l<0){let[u,h]=Ui(ne(M.target));c=Math.hypot(n-u,t-h)-3}else if(o==="move"){let u=Pc()[l],h=Ui(Cc(u,.92*$a*e));c=Math.min(Oy(n,t,Ui(Cc(u,.3*$a*e)),h),Math.hypot(n-h[0],t-h[1])-4)}else{let u=Jm(l,(l<0?Qm:Dd)*e).map(h=>({...h,s:Ui(h.p)}));for(let h=0;h<Rc;h++)u[h].front&&(c=Math.min(c,Oy(n,t,u[h].s,u[h+1].s)+(l<0?2:0)))}i.push([s,c])}return i.sort((s,r)=>s[1]-r[1])}function Vy(n){if(!wr)return null;eg();let[t]=Km(n.clientX,n.clientY);return t&&t[1]<=(Uy[n.pointerType]??Uy.mouse)?t[0]:null}function Wy(){if(!wr)return{};eg();let n=Fd(),t=Pc(),e={"move-view":Ui(ne(M.target))};return io.forEach((i,s)=>{let o=[.92,.85,.75,.6,.5].map(c=>Ui(Cc(t[s],c*$a*n))).find(([c,u])=>Km(c,u)[0]?.[0]===`move-${i}`);o&&(e[`move-${i}`]=o);let l=Jm(s,Dd*n).filter(c=>c.front).map(c=>Ui(c.p)).filter(([c,u])=>Km(c,u)[0]?.[0]===`turn-${i}`);l.length&&(e[`turn-${i}`]=l[Math.floor(l.length/2)])}),e["turn-view"]=Ui(Jm(-1,Qm*n)[9].p),e}var By=new lc,ky=new qt;function qy(n){let t=Ji.domElement.getBoundingClientRect();return ky.set((n.clientX-t.x)/t.width*2-1,1-(n.clientY-t.y)/t.height*2),By.setFromCamera(ky,Oe),By.ray}function $y(n,t,e){let{origin:i,direction:s}=qy(e),r=new k(...n),o=new k(...t).sub(i),a=r.dot(s),l=1-a*a;return l<1e-6?0:(a*s.dot(o)-r.dot(o))/l}function Xy(n,t,e){let i=new ni().setFromNormalAndCoplanarPoint(n,new k(...t));return qy(e).intersectPlane(i,new k)}function UC(n){if(n.button!==0)return;let t=Vy(n);if(!t)return;n.stopPropagation(),n.preventDefault(),no.focus({preventScroll:!0}),no.setPointerCapture(n.pointerId),wn.enabled=!1;let[e,i]=t.split("-"),s=io.indexOf(i),r=s<0?so.toArray():Pc()[s].slice();Je={name:t,what:e,axis:r,i:s,T:M.target.slice(),x:n.clientX,y:n.clientY,total:0,before:null},Je.start=e==="turn"?Yy(n):s<0?Xy(so,ne(Je.T),n):$y(r,ne(Je.T),n),we()}function Yy(n){let[t,e]=Ui(ne(Je.T)),i=Je.axis.reduce((h,d,f)=>h+d*so.getComponent(f),0);if(Math.abs(i)>.3)return-Math.sign(i)*Math.atan2(n.clientY-e,n.clientX-t);let s=Gy(Je.axis,so.toArray()),r=Fd(),o=Ui(ne(Je.T)),a=Ui(Cc(s,Dd*r)),l=a[0]-o[0],c=a[1]-o[1],u=Math.hypot(l,c)||1;return((n.clientX-Je.x)*l+(n.clientY-Je.y)*c)/(u*u)}var FC=n=>Math.atan2(Math.sin(n),Math.cos(n)),Xm=(n,t,e)=>{let i=tg||(t.shiftKey?5:0);return i?Math.round(n/(i*e))*i*e:n};function OC(n){if(!Je){if(n.buttons||!wr)return;let l=Vy(n);l!==jm&&(jm=l,no.style.setProperty("cursor",l?"grab":""),we());return}n.stopPropagation();let{T:t,axis:e,what:i,i:s}=Je,r=Nd==="world"||s<0?"":"tool ",o=t.slice(),a;if(i==="turn"){let l=Yy(n);Je.total+=FC(l-(Je.before??Je.start)),Je.before=l;let c=Xm(Je.total,n,Math.PI/180),u=Math.sin(c/2);o=ei(Tc([Math.cos(c/2),u*e[0],u*e[1],u*e[2]]),t);for(let h of[3,7,11])o[h]=t[h];a=`${Ym(c,"angle")} about ${s<0?"the line of sight":r+io[s]}`}else if(s<0){let l=Xy(so,ne(t),n);if(!l)return;let c=l.sub(Je.start);(tg||n.shiftKey)&&c.set(...c.toArray().map(u=>Xm(u,n,.001))),[3,7,11].forEach((u,h)=>{o[u]=t[u]+c.getComponent(h)}),a=c.toArray().map((u,h)=>`${io[h]} ${Ym(u,"length")}`).join(", ")}else{let l=Xm($y(e,ne(t),n)-Je.start,n,.001);[3,7,11].forEach((c,u)=>{o[c]=t[c]+l*e[u]}),a=`${Ym(l,"length")} along ${r}${io[s]}`}xi(o,"drag"),BC(a,n),we()}var Ym=(n,t)=>`${n>=0?"+":""}${Ee(n,t,gt.digits(t))}`;function BC(n,t){let e=no.getBoundingClientRect();eo.hidden=!1,yt(eo,n),eo.style.setProperty("left",`${Math.min(t.clientX-e.x+18,e.width-eo.offsetWidth-8)}px`),eo.style.setProperty("top",`${Math.max(t.clientY-e.y-34,8)}px`)}function Zy(n){Je&&(n.stopPropagation(),Je=null,eo.hidden=!0,wn.enabled=!0,xi(M.target,"dropped"),we())}function kC(){let{T:n}=Je;xi(n,"drag"),Zy({stopPropagation(){}})}function jy(){wr&&IC(),Po.visible=wr,ft("frames"),we()}function Jy(n){wr=n,jy()}function Ky(n){Zm=n,jy()}function Qy(n){Nd=n,we()}function tv(n){tg=n}var rv=Ad(),nv=[.32,-.4,1],ov=new ii({color:"#000",transparent:!0,opacity:.1,side:Di,depthWrite:!1,fog:!1,stencilWrite:!0,stencilFunc:Kp,stencilRef:1,stencilZPass:Jp,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),zC=new ge().set(1,0,-nv[0],0,0,1,-nv[1],0,0,0,0,5e-4,0,0,0,1),kd=new Ga(rv,{shadow:{material:ov,matrix:zC}}),av=Ad({opacity:.2,veil:!0}),Od=new Ga(av,{veil:!0}),lv=Ad({opacity:.62,gloss:.1}),ig=new Ga(lv,{veil:!0}),Hd=new Va,Io=wd(M.table),Gd=[],zd=null;function cv(){_n.add(kd.group,Od.group,ig.group,Hd.group),Od.group.renderOrder=1,st("table",n=>{Io=wd(M.table),Lm(Io.size),Gd=[],zd=null,sg(),Wd(),n==="new"&&Dc({instant:!0,view:"iso"}),_y()}),st("q",GC),st("frames",dv),st("theme",sv),st("hurry",n=>{for(let t of[kd,Od,ig])t.hurry(n)}),sv()}var iv=new Map,Lc=[],ng=0;function Tr(n,t){if(iv.set(n,t),Lc=[...iv.values()].flat(),!M.table.joints.length)return;let e=ng;ng=Lc.length,Pm([...Mc(M.table,M.frames),...Lc]),t.length?hv():e>ng&&HC()}var HC=Gs(Sy,120);function uv(n,t){let e=Math.max(1,Math.floor(t.length/24)),i=t.filter((s,r)=>r%e===0||r===t.length-1);Tr("motion",i.flatMap(s=>Mc(n,_s(n,s))))}function Dc(n){Sd([...Mc(M.table,M.frames),...Lc],n)}var hv=Gs(Ha,220);function GC(){let n=M.frames;kd.show(M.table.joints.length?[Nm(M.table,n,Io,M.q)]:[]),Pm([...Mc(M.table,n),...Lc]),hv(),xv&&VC(ne(n[n.length-1])),dv()}function dv(){let n=(M.shownFrames??[]).filter(t=>t<M.frames.length&&!(t===M.frames.length-1&&zy())).map(t=>({T:M.frames[t],name:Vd(t)}));Hd.show(M.dhStep===null?n:Cd(),Io.size*.13),we()}var fv=()=>kd.arms.flatMap(n=>[...n.drums,...n.sleeves].filter(t=>t.beyond).map(t=>t.joint+1)),pv=()=>(Hd.last?.[0]??[]).map(n=>n.name);function Vd(n){let t=M.table.joints.length;return n===0?"base":n===t+1?"tool":String(n)}function mv(n){Gd=n,sg()}function Xa(n){zd=n,sg()}var gv=()=>Gd.length;function sg(){let n=t=>Nm(M.table,_s(M.table,t),Io);Od.show(Gd.map(n)),ig.show(zd?[n(zd)]:[]),we()}var _v=6e3,Bd=new Float32Array(6*_v),Er=new bo(new Ae,new Xi({fog:!1}));Er.geometry.setAttribute("position",new je(Bd,3));Er.frustumCulled=!1;Er.visible=!1;var ro=0,xv=!0,Ic=null;_n.add(Er);function VC(n){let t=Ic?ss(Pi(n,Ic)):1/0;t<Io.size*.002||(t<Io.size*.2&&(ro===_v&&(Bd.copyWithin(0,6*1e3),ro-=1e3),Bd.set(Ic,6*ro),Bd.set(n,6*ro+3),ro+=1,Er.geometry.setDrawRange(0,2*ro),Er.geometry.attributes.position.needsUpdate=!0,Er.visible=!0),Ic=n)}function yv(n){xv=n,n||Wd(),we()}function Wd(){ro=0,Ic=null,Er.visible=!1,we()}var vv=()=>ro,Nc=new Xs(new Ae,new Xi({fog:!1}));Nc.frustumCulled=!1;var Uc=new _r(new Ae,new Ys({size:4,sizeAttenuation:!1,fog:!1}));Uc.frustumCulled=!1;Nc.visible=Uc.visible=!1;_n.add(Nc,Uc);function qd(n){Tr("path",n);let t=new Float32Array(n.flat());for(let e of[Nc,Uc])e.geometry.dispose(),e.geometry=new Ae,e.geometry.setAttribute("position",new je(t,3)),e.visible=n.length>0;we()}function sv(){rv.repaint(Kt.link,Kt.joint,Kt.accent,Kt.dark,Kt.wrong),av.repaint(Kt.ghost,Kt.ghost,Kt.ghost,Kt.dark),lv.repaint(Kt.accent,Kt.accent,Kt.accent,Kt.dark),Er.material.color.set(Kt.accent),Nc.material.color.set(Kt.trace),Uc.material.color.set(Kt.trace),ov.opacity=Kt.dark?.28:.11,Hd.paint(),we()}var ue={follow:!0,ghosts:"all",task:null,redundancy:null},rg={answers:0},$d=!1,bv=Or(async()=>{let n=$d;$d=!1;let t=M.target,e=M.table;try{let i=Ud()||og,s=i?null:M.digits,{task:r,redundancy:o}=ue,a=await dn("ik",{T:t,q:M.q,brief:i,task:r,redundancy:o,digits:s});if(e!==M.table||t!==M.target&&!i)return;rg.answers+=1,M.solutions={...a,T:t,brief:i},n&&ue.follow&&a.nearest&&Ii(a.nearest,"follow"),Ya(),ft("solutions"),!i&&!a.rows.some(l=>l.inside)&&$C(t),a.self_motions===null&&!i&&qC(M.solutions)}catch(i){if(i instanceof du)return;M.solutions={rows:[],self_motions:[],status:"REFUSED",why:i.message,nearest:null},Ya(),ft("solutions")}}),og=!1;function Sv(){og=!0,$d=!0,bv()}function As({follow:n=!1}={}){og=!1,$d||=n,bv()}var qC=Or(async n=>{try{let t={T:n.T,q:M.q,task:ue.task,redundancy:ue.redundancy},{self_motions:e}=await dn("self_motions",t);if(M.solutions!==n||!e)return;n.self_motions=e,ft("solutions")}catch{}}),$C=Or(async n=>{try{let t=await dn("nearest",{T:n,task:ue.task});M.solutions&&M.solutions.T===n&&(M.solutions.near=t,ft("solutions"))}catch{}}),XC=(n,t)=>n.every((e,i)=>Math.abs(Math.atan2(Math.sin(e-t[i]),Math.cos(e-t[i])))<1e-6||Math.abs(e-t[i])<1e-9);function Ya(){let n=M.solutions?.rows??[],t=M.panel==="inverse"&&ue.ghosts!=="none"?n.filter(e=>(ue.ghosts==="all"||e.inside)&&!XC(e.q,M.q)):[];mv(t.map(e=>e.q))}function Mv(){st("target",n=>{M.panel==="inverse"&&As({follow:Z0.has(n)})}),st("task",()=>{ft("plan"),M.panel==="inverse"&&M.hasTarget&&As()}),st("panel",n=>{Xa(null),n==="inverse"&&M.hasTarget&&!M.solutions&&As(),Ya()}),st("moving",n=>{n||Ya()}),st("table",n=>{ue.redundancy=null,n==="new"&&(ue.task=null),ft("solutions"),n!=="new"&&M.panel==="inverse"&&M.hasTarget&&As()}),st("online",n=>{n&&M.panel==="inverse"&&M.hasTarget&&M.table.joints.length&&As()})}var Fc=0;function ui(){Fc+=1,M.moving&&(M.moving=!1,ft("moving",!1))}function Ai(n,t=.8,e="move to a posture"){ui(),ft("let-go"),ft("did",{label:e});let i=M.q.slice(),s=Fc,r=performance.now();return matchMedia("(prefers-reduced-motion: reduce)").matches&&(t=0),M.moving=!0,ft("moving",!0),new Promise(o=>{(function a(l){if(s!==Fc||i.length!==M.q.length){o(!1);return}let c=t>0?Math.min(Math.max((l-r)/(1e3*t),0),1):1,u=c**3*(10-15*c+6*c*c);Ii(c<1?i.map((h,d)=>h+u*(n[d]-h)):n.slice(),"move"),c<1?requestAnimationFrame(a):(M.moving=!1,ft("moving",!1),o(!0))})(r)})}function wv(n,t,e,i){ui();let s=Fc,r=performance.now()-1e3*n*t;M.moving=!0,ft("moving",!0),requestAnimationFrame(function o(a){if(s!==Fc){i?.(!1);return}let l=Math.min(Math.max((a-r)/(1e3*n),0),1);e(l),l<1?requestAnimationFrame(o):(M.moving=!1,ft("moving",!1),i?.(!0))})}var ZC=200,jC=1500,Lo=[],kc=[],Bc=null,Oc={key:null,at:0,open:!1},ag=!1,Xd=()=>({table:M.table,q:M.q,target:M.target,digits:M.digits,hasTarget:M.hasTarget,path:{...M.path},sequence:structuredClone(M.sequence),program:M.program,world:M.world,limits:M.limits,start:M.start,task:ue.task,redundancy:ue.redundancy});function lg(){ag||(ag=!0,queueMicrotask(()=>{ag=!1,Bc=Xd()}))}function JC({label:n,key:t=n,open:e=!1}){let i=performance.now();!(t===Oc.key&&(Oc.open||i-Oc.at<jC))&&Bc&&(Lo.push({label:n,before:Bc}),Lo.length>ZC&&Lo.shift(),kc.length=0),Oc={key:t,at:i,open:e},lg(),ft("history")}function cg(){Oc={key:null,at:0,open:!1}}function KC(n){ui(),cg(),ue.task=n.task,n.table!==M.table?hn(n.table,{q:n.q,step:!1,what:"undo"}):Ii(n.q,"undo"),ue.redundancy=n.redundancy,Object.assign(M.path,n.path),M.sequence=structuredClone(n.sequence),M.program=n.program,M.world=n.world,M.limits=n.limits,M.start=n.start,M.hasTarget=n.hasTarget,n.target!==M.target&&xi(n.target,"restored",n.digits);for(let t of["path-loaded","sequence-loaded","program","world","task"])ft(t,"undo")}function Ev(n,t,e){let i=n.pop();if(!i)return;let s=Xd();KC(i.before),t.push({label:i.label,before:s}),lg(),ft("history"),Xe(`${e}: ${i.label}`)}var ug=()=>Ev(Lo,kc,"Undone"),hg=()=>Ev(kc,Lo,"Redone"),Yd=()=>Lo.at(-1)?.label??null,Zd=()=>kc.at(-1)?.label??null;function jd(){Lo.length=0,kc.length=0,cg(),Bc=Xd(),ft("history")}function Tv(){Bc=Xd(),st("did",JC),st("let-go",cg),st(["table","q","target","path","sequence","program","world","task"],lg)}var Cv=1,Pv=30;function Jd(){let{table:n,q:t,target:e,hasTarget:i,notation:s,shownFrames:r,path:o,sequence:a,panel:l,theme:c}=M;return{pieper:Cv,table:n,q:t,target:i?e:null,digits:M.digits,task:ue.task,redundancy:ue.redundancy,follow:ue.follow,ghosts:ue.ghosts,notation:s,frames:r,path:o,sequence:a,program:{steps:M.program,start:M.start,limits:M.limits},world:M.world,panel:l,theme:c,units:[gt.angle,gt.length],camera:Md()}}var hi=n=>typeof n=="number"&&Number.isFinite(n)&&Math.abs(n)<1e7,Ar=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(hi),Rs=(n,t)=>typeof n=="string"?n.slice(0,t):"",Rr=n=>{if(!Ar(n,16))return null;let t=lu(n);return t<1e-12?n.slice():t<.001?cu(n):null},tP=n=>n&&hi(n.metres)&&hi(n.radians)?{metres:n.metres,radians:n.radians}:null,eP=n=>n&&[n.lower,n.upper,n.value].every(hi)&&n.lower<=n.upper?{name:Rs(n.name,40),lower:n.lower,upper:n.upper,value:n.value,unit:Rs(n.unit,10)}:null,nP=(n,t)=>Array.isArray(n)&&n.length===t&&n.every(e=>Ar(e,t))?n:null;function iP(n){if(!n||!Array.isArray(n.joints)||n.joints.length>Pv||!["standard","modified"].includes(n.convention))return null;let t=n.joints.map((i,s)=>{if(!i||!["a","alpha","d","theta","offset"].every(o=>hi(i[o]))||!["R","P"].includes(i.type)||![1,-1].includes(i.sign))return null;let r=Object.fromEntries(Object.entries(i.text??{}).filter(([,o])=>typeof o=="string"&&o.length<80));return{name:Rs(i.name,40)||`joint_${s+1}`,type:i.type,a:i.a,alpha:i.alpha,d:i.d,theta:i.theta,lower:hi(i.lower)?i.lower:null,upper:hi(i.upper)?i.upper:null,sign:i.sign,offset:i.offset,text:r}});if(t.includes(null))return null;let e=Object.fromEntries(Object.entries(n.postures??{}).filter(([,i])=>Ar(i,t.length)).slice(0,40));return{name:Rs(n.name,60),convention:n.convention,joints:t,base:Rr(n.base)??rr(),tool:Rr(n.tool)??rr(),postures:e,manufacturer:Rs(n.manufacturer,200),source:Rs(n.source,2e3),notes:Rs(n.notes,3e3),actuator:eP(n.actuator),catalog:Rs(n.catalog,60)||void 0,derived:Rs(n.derived,60)||void 0,coupling:nP(n.coupling,t.length)}}var Av={joint:0,line:0,circle:0,wait:"seconds",gripper:"value",output:"port"};function sP(n,t){if(!n||!Object.hasOwn(Av,n.kind))return null;let e=Av[n.kind];if(e)return hi(n[e])?{kind:n.kind,[e]:n[e],...n.kind==="output"?{value:!!n.value}:{}}:null;let i=n.kind==="joint"&&Ar(n.q,t)?n.q.slice():null,s=Rr(n.T);if(!s||n.kind==="circle"&&!Rr(n.via))return null;let r=(o,a)=>a===null?{}:{[o]:a};return{kind:n.kind,...r("q",i),T:s,...r("via",Rr(n.via)),...r("speed",hi(n.speed)&&n.speed>0?n.speed:null),blend:hi(n.blend)&&n.blend>=0?n.blend:0}}var dg={frame:[],box:["size"],cylinder:["r","h"]};function rP(n){if(!n||!Object.hasOwn(dg,n.kind))return null;let t=Rr(n.T),e=Rs(n.name,40),i=s=>s==="size"?Ar(n.size,3)&&n.size.every(r=>r>0):hi(n[s])&&n[s]>0;return!t||!e||!dg[n.kind].every(i)?null:{kind:n.kind,name:e,T:t,role:n.role==="object"?"object":"obstacle",...Object.fromEntries(dg[n.kind].map(s=>[s,n[s]]))}}function oP(n,t){let e=(s,r,o)=>Array.isArray(s)?s.slice(0,o).map(r).filter(Boolean):[],i=n.program??{};M.program=e(i.steps,s=>sP(s,t),200),M.start=Ar(i.start,t)?i.start.slice():null,M.limits=Object.fromEntries(Object.entries(i.limits??{}).filter(([s,r])=>s.length<30&&(r===null||hi(r)&&r>0))),M.world=e(n.world,rP,60)}function Kd(n,t){let e=n&&n.pieper===Cv?iP(n.table):null;if(!e)throw new Error("This is not a state of the workbench.");let i=e.joints.length;Array.isArray(n.units)&&(gt.set("angle",n.units[0]),gt.set("length",n.units[1])),Object.hasOwn(Ts,n.notation)&&(M.notation=n.notation),["auto","light","dark"].includes(n.theme)&&_d(n.theme),M.shownFrames=Array.isArray(n.frames)?n.frames.filter(a=>Number.isInteger(a)&&a>=0&&a<i+2):null;let s=n.path??{};hn(e,{q:Ar(n.q,i)?n.q:null,step:!1,what:"new"}),Object.assign(M.path,{from:Rr(s.from),to:Rr(s.to),n:Number.isInteger(s.n)&&s.n>=2&&s.n<=2e3?s.n:50,seconds:hi(s.seconds)&&s.seconds>0?s.seconds:5}),M.sequence.postures=(Array.isArray(n.sequence?.postures)?n.sequence.postures:[]).filter(a=>a&&Ar(a.q,i)&&hi(a.seconds)&&hi(a.hold)).slice(0,40).map(a=>({name:Rs(a.name,20)||"P",q:a.q.slice(),seconds:a.seconds,hold:a.hold})),oP(n,i),["pose","position","position+axis"].includes(n.task)&&(ue.task=n.task);let r=Object.entries(n.redundancy??{}).filter(([a,l])=>a.length<80&&hi(l));ue.redundancy=r.length?Object.fromEntries(r.slice(0,Pv)):null,typeof n.follow=="boolean"&&(ue.follow=n.follow),["all","inside","none"].includes(n.ghosts)&&(ue.ghosts=n.ghosts);let o=Rr(n.target);M.hasTarget=!!o,o&&xi(o,"restored",tP(n.digits));for(let a of["units","notation","sequence-loaded","task","program","world"])ft(a);t(n.panel),ft("path-loaded"),Ar(n.camera,6)&&My(n.camera),Ii(M.q,"restored"),jd()}async function Iv(n,t){return new Uint8Array(await new Response(new Blob([n]).stream().pipeThrough(new t("deflate-raw"))).arrayBuffer())}async function Qd(){let n=await Iv(new TextEncoder().encode(JSON.stringify(Jd())),CompressionStream),t=btoa(String.fromCharCode(...n)).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}#s=${t}`}async function Lv(){let n=aP();if(n)return n;let t=/^#s=([\w-]+)$/.exec(location.hash);if(!t)return null;if(t[1].length>6e4)throw new Error("The link is too long.");let e=Uint8Array.from(atob(t[1].replaceAll("-","+").replaceAll("_","/")),s=>s.charCodeAt(0)),i=await Iv(e,DecompressionStream);if(i.length>5e5)throw new Error("The link unfolds to more than it should.");return JSON.parse(new TextDecoder().decode(i))}var Dv="pieper-workbench";function aP(){try{let{address:n,shown:t}=JSON.parse(sessionStorage.getItem(Dv)??"{}");return t&&n===location.href?t:null}catch{return null}}function lP(){if(M.table.joints.length)try{sessionStorage.setItem(Dv,JSON.stringify({address:location.href,shown:Jd()}))}catch{}}var Rv=null,cP=Gs(async()=>{if(!M.table.joints.length)return;let n=await Qd();n!==Rv&&(Rv=n,history.replaceState(null,"",n))},600);function Nv(){addEventListener("pagehide",lP),st(["table","q","target","solutions","units","notation","panel","path","sequence","program","world","theme","frames"],cP)}var hP="uplot",dP="u-hz",fP="u-vt",pP="u-title",mP="u-wrap",gP="u-under",_P="u-over",xP="u-axis",Uo="u-off",yP="u-select",vP="u-cursor-x",bP="u-cursor-y",SP="u-cursor-pt",MP="u-legend",wP="u-live",EP="u-inline",TP="u-series",AP="u-marker",Uv="u-label",RP="u-value",Hc="width",Gc="height";var Fv="bottom",Za="left",fg="right",Pg="#000",Ov=Pg+"0",pg="mousemove",Bv="mousedown",mg="mouseup",kv="mouseenter",zv="mouseleave",Hv="dblclick",CP="resize",PP="scroll",Gv="change",rf="dppxchange",Ig="--",nl=typeof window<"u",vg=nl?document:null,Ja=nl?window:null,IP=nl?navigator:null,Be,tf;function bg(){let n=devicePixelRatio;Be!=n&&(Be=n,tf&&Mg(Gv,tf,bg),tf=matchMedia(`(min-resolution: ${Be-.001}dppx) and (max-resolution: ${Be+.001}dppx)`),Fo(Gv,tf,bg),Ja.dispatchEvent(new CustomEvent(rf)))}function Ki(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Sg(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function ln(n,t,e){n.style[t]=e+"px"}function Cs(n,t,e,i){let s=vg.createElement(n);return t!=null&&Ki(s,t),e?.insertBefore(s,i),s}function hs(n,t){return Cs("div",n,t)}var Vv=new WeakMap;function Qs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Vv.get(n);r!=o&&(n.style.transform=r,Vv.set(n,r),t<0||e<0||t>i||e>s?Ki(n,Uo):Sg(n,Uo))}var Wv=new WeakMap;function qv(n,t,e){let i=t+e,s=Wv.get(n);i!=s&&(Wv.set(n,i),n.style.background=t,n.style.borderColor=e)}var $v=new WeakMap;function Xv(n,t,e,i){let s=t+""+e,r=$v.get(n);s!=r&&($v.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Lg={passive:!0},LP={...Lg,capture:!0};function Fo(n,t,e,i){t.addEventListener(n,e,i?LP:Lg)}function Mg(n,t,e,i){t.removeEventListener(n,e,Lg)}nl&&bg();function Ps(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Qi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function bb(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Sb=n=>n!=null,Mb=n=>n!=null&&n>0,lf=bb(Sb),DP=bb(Mb);function NP(n,t,e,i=0,s=!1){let r=s?DP:lf,o=s?Mb:Sb;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ke,l??-Ke]}function cf(n,t,e,i){let s=jv(n),r=jv(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Cr:wb,a=s==1?Qi:ds,l=r==1?ds:Qi,c=a(o(Wn(n))),u=l(o(Wn(t))),h=Ka(e,c),d=Ka(e,u);return e==10&&(c<0&&(h=Qe(h,-c)),u<0&&(d=Qe(d,-u))),i||e==2?(n=h*s,t=d*r):(n=Rb(n,h),t=uf(t,d)),[n,t]}function Dg(n,t,e,i){let s=cf(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Ng=.1,Yv={mode:3,pad:Ng},Wc={pad:0,soft:null,mode:0},UP={min:Wc,max:Wc};function of(n,t,e,i){return hf(e)?Zv(n,t,e):(Wc.pad=e,Wc.soft=i?0:null,Wc.mode=i?3:0,Zv(n,t,UP))}function Ne(n,t){return n??t}function FP(n,t,e){for(t=Ne(t,0),e=Ne(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Zv(n,t,e){let i=e.min,s=e.max,r=Ne(i.pad,0),o=Ne(s.pad,0),a=Ne(i.hard,-Ke),l=Ne(s.hard,Ke),c=Ne(i.soft,Ke),u=Ne(s.soft,-Ke),h=Ne(i.mode,0),d=Ne(s.mode,0),f=t-n,g=Cr(f),y=Ri(Wn(n),Wn(t)),p=Cr(y),m=Wn(p-g);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Ke&&(r=0),d==2&&u!=-Ke&&(o=0)));let x=f||y||1e3,E=Cr(x),v=Ka(10,Qi(E)),A=x*(f==0?n==0?.1:1:r),T=Qe(Rb(n-A,v/10),24),_=n>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:Ke,S=Ri(a,T<_&&n>=_?_:Is(_,T)),L=x*(f==0?t==0?.1:1:o),I=Qe(uf(t+L,v/10),24),D=t<=u&&(d==1||d==3&&I>=u||d==2&&I<=u)?u:-Ke,B=Is(l,I>D&&t<=D?D:Ri(D,I));return S==B&&S==0&&(B=100),[S,B]}var OP=new Intl.NumberFormat(nl?IP.language:"en-US"),Ug=n=>OP.format(n),ts=Math,sf=ts.PI,Wn=ts.abs,Qi=ts.floor,Vn=ts.round,ds=ts.ceil,Is=ts.min,Ri=ts.max,Ka=ts.pow,jv=ts.sign,Cr=ts.log10,wb=ts.log2,BP=(n,t=1)=>ts.sinh(n)*t,gg=(n,t=1)=>ts.asinh(n/t),Ke=1/0;function Jv(n){return(Cr((n^n>>31)-(n>>31))|0)+1}function wg(n,t,e){return Is(Ri(n,t),e)}function Eb(n){return typeof n=="function"}function Ie(n){return Eb(n)?n:()=>n}var kP=()=>{},Tb=n=>n,Ab=(n,t)=>t,zP=n=>null,Kv=n=>!0,Qv=(n,t)=>n==t,HP=/\.\d*?(?=9{6,}|0{6,})/gm,Oo=n=>{if(Pb(n)||ao.has(n))return n;let t=`${n}`,e=t.match(HP);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Oo(s)}e${r}`}return Qe(n,i)};function Do(n,t){return Oo(Qe(Oo(n/t))*t)}function uf(n,t){return Oo(ds(Oo(n/t))*t)}function Rb(n,t){return Oo(Qi(Oo(n/t))*t)}function Qe(n,t=0){if(Pb(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Vn(i)/e}var ao=new Map;function Cb(n){return((""+n).split(".")[1]||"").length}function $c(n,t,e,i){let s=[],r=i.map(Cb);for(let o=t;o<e;o++){let a=Wn(o),l=Qe(Ka(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Qe(u,h);s.push(d),ao.set(d,h)}}return s}var qc={},Fg=[],Qa=[null,null],oo=Array.isArray,Pb=Number.isInteger,GP=n=>n===void 0;function tb(n){return typeof n=="string"}function hf(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function VP(n){return n!=null&&typeof n=="object"}var WP=Object.getPrototypeOf(Uint8Array),Ib="__proto__";function tl(n,t=hf){let e;if(oo(n)){let i=n.find(s=>s!=null);if(oo(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=tl(n[s],t)}else e=n.slice()}else if(n instanceof WP)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Ib&&(e[i]=tl(n[i],t))}else e=n;return e}function Un(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Ib&&(hf(n[s])?Un(n[s],tl(i[s])):n[s]=tl(i[s]))}return n}var qP=0,$P=1,XP=2;function YP(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function ZP(n,t){if(KP(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return QP(o[0])||(o=JP(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:$P,f=[];for(let g=0;g<u.length;g++){let y=u[g],p=r.get(l[g]);y===null?d!=qP&&(h[p]=y,d==XP&&f.push(p)):h[p]=y}YP(h,f,s),i.push(h)}}return i}var jP=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function JP(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function KP(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function QP(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Ri(1,Qi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Lb=["January","February","March","April","May","June","July","August","September","October","November","December"],Db=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Nb(n){return n.slice(0,3)}var tI=Db.map(Nb),eI=Lb.map(Nb),nI={MMMM:Lb,MMM:eI,WWWW:Db,WWW:tI};function zc(n){return(n<10?"0":"")+n}function iI(n){return(n<10?"00":n<100?"0":"")+n}var sI={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>zc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>zc(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>zc(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>zc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>zc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>iI(n.getMilliseconds())};function Og(n,t){t=t||nI;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?sI[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var rI=new Intl.DateTimeFormat().resolvedOptions().timeZone;function oI(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==rI?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Ub=n=>n%1==0,af=[1,2,2.5,5],aI=$c(10,-32,0,af),Fb=$c(10,0,32,af),lI=Fb.filter(Ub),No=aI.concat(Fb),Bg=`
`,Ob="{YYYY}",eb=Bg+Ob,Bb="{M}/{D}",Vc=Bg+Bb,ef=Vc+"/{YY}",kb="{aa}",cI="{h}:{mm}",ja=cI+kb,nb=Bg+ja,ib=":{ss}",ze=null;function zb(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?$c(10,0,3,af).filter(Ub):$c(10,-3,0,af)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ob,ze,ze,ze,ze,ze,ze,1],[s*28,"{MMM}",eb,ze,ze,ze,ze,ze,1],[s,Bb,eb,ze,ze,ze,ze,ze,1],[i,"{h}"+kb,ef,ze,Vc,ze,ze,ze,1],[e,ja,ef,ze,Vc,ze,ze,ze,1],[t,ib,ef+" "+ja,ze,Vc+" "+ja,ze,nb,ze,1],[n,ib+".{fff}",ef+" "+ja,ze,Vc+" "+ja,ze,nb,ze,1]];function u(h){return(d,f,g,y,p,m)=>{let x=[],E=p>=o,v=p>=r&&p<o,A=h(g),T=Qe(A*n,3),_=_g(A.getFullYear(),E?0:A.getMonth(),v||E?1:A.getDate()),S=Qe(_*n,3);if(v||E){let L=v?p/r:0,I=E?p/o:0,D=T==S?T:Qe(_g(_.getFullYear()+I,_.getMonth()+L,1)*n,3),B=new Date(Vn(D/n)),V=B.getFullYear(),O=B.getMonth();for(let $=0;D<=y;$++){let Z=_g(V+I*$,O+L*$,1),q=Z-h(Qe(Z*n,3));D=Qe((+Z+q)*n,3),D<=y&&x.push(D)}}else{let L=p>=s?s:p,I=Qi(g)-Qi(T),D=S+I+uf(T-S,L);x.push(D);let B=h(D),V=B.getHours()+B.getMinutes()/e+B.getSeconds()/i,O=p/i,$=d.axes[f]._space,Z=m/$;for(;D=Qe(D+p,n==1?0:3),!(D>y);)if(O>1){let q=Qi(Qe(V+O,6))%24,tt=h(D).getHours()-q;tt>1&&(tt=-1),D-=tt*i,V=(V+O)%24;let ot=x[x.length-1];Qe((D-ot)/p,3)*Z>=.7&&x.push(D)}else x.push(D)}return x}}return[l,c,u]}var[uI,hI,dI]=zb(1),[fI,pI,mI]=zb(.001);$c(2,-53,53,[1]);function sb(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function rb(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,d,f;return i.map(g=>{let y=n(g),p=y.getFullYear(),m=y.getMonth(),x=y.getDate(),E=y.getHours(),v=y.getMinutes(),A=y.getSeconds(),T=p!=l&&a[2]||m!=c&&a[3]||x!=u&&a[4]||E!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return l=p,c=m,u=x,h=E,d=v,f=A,T(y)})}}function gI(n,t){let e=Og(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function _g(n,t,e){return new Date(n,t,e)}function ob(n,t){return t(n)}var _I="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ab(n,t){return(e,i,s,r)=>r==null?Ig:t(n(i))}function xI(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function yI(n,t){return n.series[t].fill(n,t)}var vI={show:!0,live:!0,isolate:!1,mount:kP,markers:{show:!0,width:2,stroke:xI,fill:yI,dash:"solid"},idx:null,idxs:null,values:[]};function bI(n,t){let e=n.cursor.points,i=hs(),s=e.size(n,t);ln(i,Hc,s),ln(i,Gc,s);let r=s/-2;ln(i,"marginLeft",r),ln(i,"marginTop",r);let o=e.width(n,t,s);return o&&ln(i,"borderWidth",o),i}function SI(n,t){let e=n.series[t].points;return e._fill||e._stroke}function MI(n,t){let e=n.series[t].points;return e._stroke||e._fill}function wI(n,t){return n.series[t].points.size}var xg=[0,0];function EI(n,t,e){return xg[0]=t,xg[1]=e,xg}function nf(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function yg(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var TI={show:!0,x:!0,y:!0,lock:!1,move:EI,points:{one:!1,show:bI,size:wI,width:0,stroke:MI,fill:SI},bind:{mousedown:nf,mouseup:nf,click:nf,dblclick:nf,mousemove:yg,mouseleave:yg,mouseenter:yg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Hb={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},kg=Un({},Hb,{filter:Ab}),Gb=Un({},kg,{size:10}),Vb=Un({},Hb,{show:!1}),zg='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Wb="bold "+zg,qb=1.5,lb={show:!0,scale:"x",stroke:Pg,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Wb,side:2,grid:kg,ticks:Gb,border:Vb,font:zg,lineGap:qb,rotate:0},AI="Value",RI="Time",cb={show:!0,scale:"x",auto:!1,sorted:1,min:Ke,max:-Ke,idxs:[]};function CI(n,t,e,i,s){return t.map(r=>r==null?"":Ug(r))}function PI(n,t,e,i,s,r,o){let a=[],l=ao.get(s)||0;e=o?e:Qe(uf(e,s),l);for(let c=e;c<=i;c=Qe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Eg(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Cr:wb,u=Qi(c(e));s=Ka(l,u),l==10&&(s=No[Ps(s,No)]);let h=e,d=s*l;l==10&&(d=No[Ps(d,No)]);do a.push(h),h=h+s,l==10&&!ao.has(h)&&(h=Qe(h,ao.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=No[Ps(d,No)]));while(h<=i);return a}function II(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Eg(n,t,Ri(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Eg(n,t,Ri(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var $b=/./,LI=/[12357]/,DI=/[125]/,ub=/1/,Tg=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function NI(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?$b:l(7,o)-u>=c?LI:l(5,o)-u>=c?DI:ub;if(h==ub){let d=Wn(l(1,o)-u);if(d<c)return Tg(t.slice().reverse(),a.distr,h,ds(c/d)).reverse()}return Tg(t,a.distr,h,1)}function UI(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Wn(l(1,o)-l(2,o));return c<a?Tg(t.slice().reverse(),3,$b,ds(a/c)).reverse():t}function FI(n,t,e,i){return i==null?Ig:t==null?"":Ug(t)}var hb={show:!0,scale:"y",stroke:Pg,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Wb,side:3,grid:kg,ticks:Gb,border:Vb,font:zg,lineGap:qb,rotate:0};function OI(n,t){let e=3+(n||1)*2;return Qe(e*t,3)}function BI(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Wn(o-r),l=n.series[t],c=a/(l.points.space*Be);return i[1]-i[0]<=c}var db={scale:null,auto:!0,sorted:0,min:Ke,max:-Ke},Xb=(n,t,e,i,s)=>s,fb={show:!0,auto:!0,sorted:0,gaps:Xb,alpha:1,facets:[Un({},db,{scale:"x"}),Un({},db,{scale:"y"})]},pb={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Xb,alpha:1,points:{show:BI,filter:null},values:null,min:Ke,max:-Ke,idxs:[],path:null,clip:null};function kI(n,t,e,i,s){return e/10}var Yb={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zI=Un({},Yb,{time:!1,ori:1}),mb={};function Zb(n,t){let e=mb[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(mb[n]=e)),e}var el=1,Ag=2;function Bo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,l,c,u,h,p,m,d,f,g,y,ff,il,mf,Jb,Qb):e(s,l,c,u,h,m,p,f,d,y,g,pf,sl,Vg,Kb,tS)}function Hg(n,t){let e=0,i=0,s=Ne(n.bands,Fg);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function HI(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Pr(n,t,e,i,s,r){return Bo(n,t,(o,a,l,c,u,h,d,f,g,y,p)=>{let m=o.pxRound,x=c.dir*(c.ori==0?1:-1),E=c.ori==0?il:sl,v,A;x==1?(v=e,A=i):(v=i,A=e);let T=m(h(a[v],c,y,f)),_=m(d(l[v],u,p,g)),S=m(h(a[A],c,y,f)),L=m(d(r==1?u.max:u.min,u,p,g)),I=new Path2D(s);return E(I,S,L),E(I,T,L),E(I,T,_),I})}function df(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?mf:Vg,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function GI(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Gg(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),g=d==h?f:r(n[d]),y=h-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=f&&a.push([f,g])}return a}function gb(n){return n==0?Tb:n==1?Vn:t=>Do(t,n)}function jb(n){let t=n==0?ff:pf,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Is(c,a/2,l/2),u=Is(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var ff=(n,t,e)=>{n.moveTo(t,e)},pf=(n,t,e)=>{n.moveTo(e,t)},il=(n,t,e)=>{n.lineTo(t,e)},sl=(n,t,e)=>{n.lineTo(e,t)},mf=jb(0),Vg=jb(1),Jb=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Kb=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Qb=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},tS=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function eS(n){return(t,e,i,s,r)=>Bo(t,e,(o,a,l,c,u,h,d,f,g,y,p)=>{let{pxRound:m,points:x}=o,E,v;c.ori==0?(E=ff,v=Jb):(E=pf,v=Kb);let A=Qe(x.width*Be,3),T=(x.size-x.width)/2*Be,_=Qe(T*2,3),S=new Path2D,L=new Path2D,{left:I,top:D,width:B,height:V}=t.bbox;mf(L,I-_,D-_,B+_*2,V+_*2);let O=$=>{if(l[$]!=null){let Z=m(h(a[$],c,y,f)),q=m(d(l[$],u,p,g));E(S,Z+T,q),v(S,Z,q,T,0,sf*2)}};if(r)r.forEach(O);else for(let $=i;$<=s;$++)O($);return{stroke:A>0?S:null,fill:S,clip:L,flags:el|Ag}})}function nS(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var VI=nS(il),WI=nS(sl);function iS(n){let t=Ne(n?.alignGaps,0);return(e,i,s,r)=>Bo(e,i,(o,a,l,c,u,h,d,f,g,y,p)=>{[s,r]=lf(l,s,r);let m=o.pxRound,x=V=>m(h(V,c,y,f)),E=V=>m(d(V,u,p,g)),v,A;c.ori==0?(v=il,A=VI):(v=sl,A=WI);let T=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:el},S=_.stroke,L=!1;if(r-s>=y*4){let V=pt=>e.posToVal(pt,c.key,!0),O=null,$=null,Z,q,ht,K=x(a[T==1?s:r]),tt=x(a[s]),ot=x(a[r]),mt=V(T==1?tt+1:ot-1);for(let pt=T==1?s:r;pt>=s&&pt<=r;pt+=T){let et=a[pt],Mt=(T==1?et<mt:et>mt)?K:x(et),Lt=l[pt];Mt==K?Lt!=null?(q=Lt,O==null?(v(S,Mt,E(q)),Z=O=$=q):q<O?O=q:q>$&&($=q)):Lt===null&&(L=!0):(O!=null&&A(S,K,E(O),E($),E(Z),E(q)),Lt!=null?(q=Lt,v(S,Mt,E(q)),O=$=Z=q):(O=$=null,Lt===null&&(L=!0)),K=Mt,mt=V(K+T))}O!=null&&O!=$&&ht!=K&&A(S,K,E(O),E($),E(Z),E(q))}else for(let V=T==1?s:r;V>=s&&V<=r;V+=T){let O=l[V];O===null?L=!0:O!=null&&v(S,x(a[V]),E(O))}let[D,B]=Hg(e,i);if(o.fill!=null||D!=0){let V=_.fill=new Path2D(S),O=o.fillTo(e,i,o.min,o.max,D),$=E(O),Z=x(a[s]),q=x(a[r]);T==-1&&([q,Z]=[Z,q]),v(V,q,$),v(V,Z,$)}if(!o.spanGaps){let V=[];L&&V.push(...Gg(a,l,s,r,T,x,t)),_.gaps=V=o.gaps(e,i,s,r,V),_.clip=df(V,c.ori,f,g,y,p)}return B!=0&&(_.band=B==2?[Pr(e,i,s,r,S,-1),Pr(e,i,s,r,S,1)]:Pr(e,i,s,r,S,B)),_})}function qI(n){let t=Ne(n.align,1),e=Ne(n.ascDesc,!1),i=Ne(n.alignGaps,0),s=Ne(n.extend,!1);return(r,o,a,l)=>Bo(r,o,(c,u,h,d,f,g,y,p,m,x,E)=>{[a,l]=lf(h,a,l);let v=c.pxRound,{left:A,width:T}=r.bbox,_=tt=>v(g(tt,d,x,p)),S=tt=>v(y(tt,f,E,m)),L=d.ori==0?il:sl,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:el},D=I.stroke,B=d.dir*(d.ori==0?1:-1),V=S(h[B==1?a:l]),O=_(u[B==1?a:l]),$=O,Z=O;s&&t==-1&&(Z=A,L(D,Z,V)),L(D,O,V);for(let tt=B==1?a:l;tt>=a&&tt<=l;tt+=B){let ot=h[tt];if(ot==null)continue;let mt=_(u[tt]),pt=S(ot);t==1?L(D,mt,V):L(D,$,pt),L(D,mt,pt),V=pt,$=mt}let q=$;s&&t==1&&(q=A+T,L(D,q,V));let[ht,K]=Hg(r,o);if(c.fill!=null||ht!=0){let tt=I.fill=new Path2D(D),ot=c.fillTo(r,o,c.min,c.max,ht),mt=S(ot);L(tt,q,mt),L(tt,Z,mt)}if(!c.spanGaps){let tt=[];tt.push(...Gg(u,h,a,l,B,_,i));let ot=c.width*Be/2,mt=e||t==1?ot:-ot,pt=e||t==-1?-ot:ot;tt.forEach(et=>{et[0]+=mt,et[1]+=pt}),I.gaps=tt=c.gaps(r,o,a,l,tt),I.clip=df(tt,d.ori,p,m,x,E)}return K!=0&&(I.band=K==2?[Pr(r,o,a,l,D,-1),Pr(r,o,a,l,D,1)]:Pr(r,o,a,l,D,K)),I})}function _b(n,t,e,i,s,r,o=Ke){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Wn(n[l]-n[a]);u<c&&(c=u,o=Wn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function $I(n){n=n||qc;let t=Ne(n.size,[.6,Ke,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ie(s),o=1-t[0],a=Ne(t[1],Ke),l=Ne(t[2],1),c=Ne(n.disp,qc),u=Ne(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,g,y,p)=>Bo(f,g,(m,x,E,v,A,T,_,S,L,I,D)=>{let B=m.pxRound,V=e,O=i*Be,$=a*Be,Z=l*Be,q,ht;v.ori==0?[q,ht]=r(f,g):[ht,q]=r(f,g);let K=v.dir*(v.ori==0?1:-1),tt=v.ori==0?mf:Vg,ot=v.ori==0?u:(Nt,ee,pe,Rt,Ze,$t,Qt)=>{u(Nt,ee,pe,Ze,Rt,Qt,$t)},mt=Ne(f.bands,Fg).find(Nt=>Nt.series[0]==g),pt=mt!=null?mt.dir:0,et=m.fillTo(f,g,m.min,m.max,pt),vt=B(_(et,A,D,L)),Mt,Lt,At,jt=I,fe=B(m.width*Be),Xt=!1,ve=null,_e=null,he=null,cn=null;h!=null&&(fe==0||d!=null)&&(Xt=!0,ve=h.values(f,g,y,p),_e=new Map,new Set(ve).forEach(Nt=>{Nt!=null&&_e.set(Nt,new Path2D)}),fe>0&&(he=d.values(f,g,y,p),cn=new Map,new Set(he).forEach(Nt=>{Nt!=null&&cn.set(Nt,new Path2D)})));let{x0:tn,size:An}=c;if(tn!=null&&An!=null){V=1,x=tn.values(f,g,y,p),tn.unit==2&&(x=x.map(pe=>f.posToVal(S+pe*I,v.key,!0)));let Nt=An.values(f,g,y,p);An.unit==2?Lt=Nt[0]*I:Lt=T(Nt[0],v,I,S)-T(0,v,I,S),jt=_b(x,E,T,v,I,S,jt),At=jt-Lt+O}else jt=_b(x,E,T,v,I,S,jt),At=jt*o+O,Lt=jt-At;At<1&&(At=0),fe>=Lt/2&&(fe=0),At<5&&(B=Tb);let qe=At>0,$n=jt-At-(qe?fe:0);Lt=B(wg($n,Z,$)),Mt=(V==0?Lt/2:V==K?0:Lt)-V*K*((V==0?O/2:0)+(qe?fe/2:0));let Le={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},On=Xt?null:new Path2D,xn=null;if(mt!=null)xn=f.data[mt.series[1]];else{let{y0:Nt,y1:ee}=c;Nt!=null&&ee!=null&&(E=ee.values(f,g,y,p),xn=Nt.values(f,g,y,p))}let Rn=q*Lt,H=ht*Lt;for(let Nt=K==1?y:p;Nt>=y&&Nt<=p;Nt+=K){let ee=E[Nt];if(ee==null)continue;if(xn!=null){let X=xn[Nt]??0;if(ee-X==0)continue;vt=_(X,A,D,L)}let pe=v.distr!=2||c!=null?x[Nt]:Nt,Rt=T(pe,v,I,S),Ze=_(Ne(ee,et),A,D,L),$t=B(Rt-Mt),Qt=B(Ri(Ze,vt)),N=B(Is(Ze,vt)),R=Qt-N;if(ee!=null){let X=ee<0?H:Rn,dt=ee<0?Rn:H;Xt?(fe>0&&he[Nt]!=null&&tt(cn.get(he[Nt]),$t,N+Qi(fe/2),Lt,Ri(0,R-fe),X,dt),ve[Nt]!=null&&tt(_e.get(ve[Nt]),$t,N+Qi(fe/2),Lt,Ri(0,R-fe),X,dt)):tt(On,$t,N+Qi(fe/2),Lt,Ri(0,R-fe),X,dt),ot(f,g,Nt,$t-fe/2,N,Lt+fe,R)}}return fe>0?Le.stroke=Xt?cn:On:Xt||(Le._fill=m.width==0?m._fill:m._stroke??m._fill,Le.width=0),Le.fill=Xt?_e:On,Le})}function XI(n,t){let e=Ne(t?.alignGaps,0);return(i,s,r,o)=>Bo(i,s,(a,l,c,u,h,d,f,g,y,p,m)=>{[r,o]=lf(c,r,o);let x=a.pxRound,E=q=>x(d(q,u,p,g)),v=q=>x(f(q,h,m,y)),A,T,_;u.ori==0?(A=ff,_=il,T=Qb):(A=pf,_=sl,T=tS);let S=u.dir*(u.ori==0?1:-1),L=E(l[S==1?r:o]),I=L,D=[],B=[];for(let q=S==1?r:o;q>=r&&q<=o;q+=S)if(c[q]!=null){let K=l[q],tt=E(K);D.push(I=tt),B.push(v(c[q]))}let V={stroke:n(D,B,A,_,T,x),fill:null,clip:null,band:null,gaps:null,flags:el},O=V.stroke,[$,Z]=Hg(i,s);if(a.fill!=null||$!=0){let q=V.fill=new Path2D(O),ht=a.fillTo(i,s,a.min,a.max,$),K=v(ht);_(q,I,K),_(q,L,K)}if(!a.spanGaps){let q=[];q.push(...Gg(l,c,r,o,S,E,e)),V.gaps=q=a.gaps(i,s,r,o,q),V.clip=df(q,u.ori,g,y,p,m)}return Z!=0&&(V.band=Z==2?[Pr(i,s,r,o,O,-1),Pr(i,s,r,o,O,1)]:Pr(i,s,r,o,O,Z)),V})}function YI(n){return XI(ZI,n)}function ZI(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var Rg=new Set;function xb(){for(let n of Rg)n.syncRect(!0)}nl&&(Fo(CP,Ja,xb),Fo(PP,Ja,xb,!0),Fo(rf,Ja,()=>{si.pxRatio=Be}));var jI=iS(),JI=eS();function yb(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Cg(r,o,t,e))}function KI(n,t){return n.map((e,i)=>i==0?{}:Un({},t,e))}function Cg(n,t,e,i){return Un({},t==0?e:i,n)}function sS(n,t,e){return t==null?Qa:[t,e]}var QI=sS;function t3(n,t,e){return t==null?Qa:of(t,e,Ng,!0)}function rS(n,t,e,i){return t==null?Qa:cf(t,e,n.scales[i].log,!1)}var e3=rS;function oS(n,t,e,i){return t==null?Qa:Dg(t,e,n.scales[i].log,!1)}var n3=oS;function i3(n,t,e,i,s){let r=Ri(Jv(n),Jv(t)),o=t-n,a=Ps(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?ao.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function vb(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Vn((e=+s)*Be))+"px"),[n,t,e]}function s3(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Qe(t[2]*Be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function si(n,t,e){let i={mode:Ne(n.mode,1)},s=i.mode;function r(w,C,U,F){let W=C.valToPct(w);return F+U*(C.dir==-1?1-W:W)}function o(w,C,U,F){let W=C.valToPct(w);return F+U*(C.dir==-1?W:1-W)}function a(w,C,U,F){return C.ori==0?r(w,C,U,F):o(w,C,U,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=hs(hP);if(n.id!=null&&(c.id=n.id),Ki(c,n.class),n.title){let w=hs(pP,c);w.textContent=n.title}let u=Cs("canvas"),h=i.ctx=u.getContext("2d"),d=hs(mP,c);Fo("click",d,w=>{w.target===g&&(nn!=Yo||un!=Zo)&&ti.click(i,w)},!0);let f=i.under=hs(gP,d);d.appendChild(u);let g=i.over=hs(_P,d);n=tl(n);let y=+Ne(n.pxAlign,1),p=gb(y);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let m=n.ms||.001,x=i.series=s==1?yb(n.series||[],cb,pb,!1):KI(n.series||[null],fb),E=i.axes=yb(n.axes||[],lb,hb,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(w=>{w.fill=Ie(w.fill||null),w.dir=Ne(w.dir,-1)});let T=s==2?x[1].facets[0].scale:x[0].scale,_={axes:ir,series:Me},S=(n.drawOrder||["axes","series"]).map(w=>_[w]);function L(w){let C=w.distr==3?U=>Cr(U>0?U:w.clamp(i,U,w.min,w.max,w.key)):w.distr==4?U=>gg(U,w.asinh):w.distr==100?U=>w.fwd(U):U=>U;return U=>{let F=C(U),{_min:W,_max:J}=w,ct=J-W;return(F-W)/ct}}function I(w){let C=v[w];if(C==null){let U=(n.scales||qc)[w]||qc;if(U.from!=null){I(U.from);let F=Un({},v[U.from],U,{key:w});F.valToPct=L(F),v[w]=F}else{C=v[w]=Un({},w==T?Yb:zI,U),C.key=w;let F=C.time,W=C.range,J=oo(W);if((w!=T||s==2&&!F)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Yv:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Yv:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&hf(W))){let ct=W;W=(_t,Et,Bt)=>Et==null?Qa:of(Et,Bt,ct)}C.range=Ie(W||(F?QI:w==T?C.distr==3?e3:C.distr==4?n3:sS:C.distr==3?rS:C.distr==4?oS:t3)),C.auto=Ie(J?!1:C.auto),C.clamp=Ie(C.clamp||kI),C._min=C._max=null,C.valToPct=L(C)}}}I("x"),I("y"),s==1&&x.forEach(w=>{I(w.scale)}),E.forEach(w=>{I(w.scale)});for(let w in n.scales)I(w);let D=v[T],B=D.distr,V,O;D.ori==0?(Ki(c,dP),V=r,O=o):(Ki(c,fP),V=o,O=r);let $={};for(let w in v){let C=v[w];(C.min!=null||C.max!=null)&&($[w]={min:C.min,max:C.max},C.min=C.max=null)}let Z=n.tzDate||(w=>new Date(Vn(w/m))),q=n.fmtDate||Og,ht=m==1?dI(Z):mI(Z),K=rb(Z,sb(m==1?hI:pI,q)),tt=ab(Z,ob(_I,q)),ot=[],mt=i.legend=Un({},vI,n.legend),pt=i.cursor=Un({},TI,{drag:{y:s==2}},n.cursor),et=mt.show,vt=pt.show,Mt=mt.markers;mt.idxs=ot,Mt.width=Ie(Mt.width),Mt.dash=Ie(Mt.dash),Mt.stroke=Ie(Mt.stroke),Mt.fill=Ie(Mt.fill);let Lt,At,jt,fe=[],Xt=[],ve,_e=!1,he={};if(mt.live){let w=x[1]?x[1].values:null;_e=w!=null,ve=_e?w(i,1,0):{_:0};for(let C in ve)he[C]=Ig}if(et)if(Lt=Cs("table",MP,c),jt=Cs("tbody",null,Lt),mt.mount(i,Lt),_e){At=Cs("thead",null,Lt,jt);let w=Cs("tr",null,At);Cs("th",null,w);for(var cn in ve)Cs("th",Uv,w).textContent=cn}else Ki(Lt,EP),mt.live&&Ki(Lt,wP);let tn={show:!0},An={show:!1};function qe(w,C){if(C==0&&(_e||!mt.live||s==2))return Qa;let U=[],F=Cs("tr",TP,jt,jt.childNodes[C]);Ki(F,w.class),w.show||Ki(F,Uo);let W=Cs("th",null,F);if(Mt.show){let _t=hs(AP,W);if(C>0){let Et=Mt.width(i,C);Et&&(_t.style.border=Et+"px "+Mt.dash(i,C)+" "+Mt.stroke(i,C)),_t.style.background=Mt.fill(i,C)}}let J=hs(Uv,W);w.label instanceof HTMLElement?J.appendChild(w.label):J.textContent=w.label,C>0&&(Mt.show||(J.style.color=w.width>0?Mt.stroke(i,C):Mt.fill(i,C)),Le("click",W,_t=>{if(pt._lock)return;oe(_t);let Et=x.indexOf(w);if((_t.ctrlKey||_t.metaKey)!=mt.isolate){let Bt=x.some((kt,Ht)=>Ht>0&&Ht!=Et&&kt.show);x.forEach((kt,Ht)=>{Ht>0&&Fs(Ht,Bt?Ht==Et?tn:An:tn,!0,Ln.setSeries)})}else Fs(Et,{show:!w.show},!0,Ln.setSeries)},!1),ae&&Le(kv,W,_t=>{pt._lock||(oe(_t),Fs(x.indexOf(w),Jo,!0,Ln.setSeries))},!1));for(var ct in ve){let _t=Cs("td",RP,F);_t.textContent="--",U.push(_t)}return[F,U]}let $n=new Map;function Le(w,C,U,F=!0){let W=$n.get(C)||{},J=pt.bind[w](i,C,U,F);J&&(Fo(w,C,W[w]=J),$n.set(C,W))}function On(w,C,U){let F=$n.get(C)||{};for(let W in F)(w==null||W==w)&&(Mg(W,C,F[W]),delete F[W]);w==null&&$n.delete(C)}let xn=0,Rn=0,H=0,Nt=0,ee=0,pe=0,Rt=ee,Ze=pe,$t=H,Qt=Nt,N=0,R=0,X=0,dt=0;i.bbox={};let lt=!1,St=!1,wt=!1,nt=!1,rt=!1,xt=!1;function z(w,C,U){(U||w!=i.width||C!=i.height)&&at(w,C),xe(!1),wt=!0,St=!0,ri()}function at(w,C){i.width=xn=H=w,i.height=Rn=Nt=C,ee=pe=0,Tt(),Zt();let U=i.bbox;N=U.left=Do(ee*Be,.5),R=U.top=Do(pe*Be,.5),X=U.width=Do(H*Be,.5),dt=U.height=Do(Nt*Be,.5)}let it=3;function Ct(){let w=!1,C=0;for(;!w;){C++;let U=qo(C),F=Us(C);w=C==it||U&&F,w||(at(i.width,i.height),St=!0)}}function bt({width:w,height:C}){z(w,C)}i.setSize=bt;function Tt(){let w=!1,C=!1,U=!1,F=!1;E.forEach((W,J)=>{if(W.show&&W._show){let{side:ct,_size:_t}=W,Et=ct%2,Bt=W.label!=null?W.labelSize:0,kt=_t+Bt;kt>0&&(Et?(H-=kt,ct==3?(ee+=kt,F=!0):U=!0):(Nt-=kt,ct==0?(pe+=kt,w=!0):C=!0))}}),Ds[0]=w,Ds[1]=U,Ds[2]=C,Ds[3]=F,H-=ps[1]+ps[3],ee+=ps[3],Nt-=ps[2]+ps[0],pe+=ps[0]}function Zt(){let w=ee+H,C=pe+Nt,U=ee,F=pe;function W(J,ct){switch(J){case 1:return w+=ct,w-ct;case 2:return C+=ct,C-ct;case 3:return U-=ct,U+ct;case 0:return F-=ct,F+ct}}E.forEach((J,ct)=>{if(J.show&&J._show){let _t=J.side;J._pos=W(_t,J._size),J.label!=null&&(J._lpos=W(_t,J.labelSize))}})}if(pt.dataIdx==null){let w=pt.hover,C=w.skip=new Set(w.skip??[]);C.add(void 0);let U=w.prox=Ie(w.prox),F=w.bias??=0;pt.dataIdx=(W,J,ct,_t)=>{if(J==0)return ct;let Et=ct,Bt=U(W,J,ct,_t)??Ke,kt=Bt>=0&&Bt<Ke,Ht=D.ori==0?H:Nt,de=pt.left,Ue=t[0],De=t[J];if(C.has(De[ct])){Et=null;let Te=null,se=null,Jt;if(F==0||F==-1)for(Jt=ct;Te==null&&Jt-- >0;)C.has(De[Jt])||(Te=Jt);if(F==0||F==1)for(Jt=ct;se==null&&Jt++<De.length;)C.has(De[Jt])||(se=Jt);if(Te!=null||se!=null)if(kt){let rn=Te==null?-1/0:V(Ue[Te],D,Ht,0),bn=se==null?1/0:V(Ue[se],D,Ht,0),jn=de-rn,$e=bn-de;jn<=$e?jn<=Bt&&(Et=Te):$e<=Bt&&(Et=se)}else Et=se==null?Te:Te==null?se:ct-Te<=se-ct?Te:se}else kt&&Wn(de-V(Ue[ct],D,Ht,0))>Bt&&(Et=null);return Et}}let oe=w=>{pt.event=w};pt.idxs=ot,pt._lock=!1;let ut=pt.points;ut.show=Ie(ut.show),ut.size=Ie(ut.size),ut.stroke=Ie(ut.stroke),ut.width=Ie(ut.width),ut.fill=Ie(ut.fill);let Gt=i.focus=Un({},n.focus||{alpha:.3},pt.focus),ae=Gt.prox>=0,Dt=ae&&ut.one,me=[],en=[],fi=[];function pl(w,C){let U=ut.show(i,C);if(U instanceof HTMLElement)return Ki(U,SP),Ki(U,w.class),Qs(U,-10,-10,H,Nt),g.insertBefore(U,me[C]),U}function Go(w,C){if(s==1||C>0){let U=s==1&&v[w.scale].time,F=w.value;w.value=U?tb(F)?ab(Z,ob(F,q)):F||tt:F||FI,w.label=w.label||(U?RI:AI)}if(Dt||C>0){w.width=w.width==null?1:w.width,w.paths=w.paths||jI||zP,w.fillTo=Ie(w.fillTo||HI),w.pxAlign=+Ne(w.pxAlign,y),w.pxRound=gb(w.pxAlign),w.stroke=Ie(w.stroke||null),w.fill=Ie(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let U=OI(Ri(1,w.width),1),F=w.points=Un({},{size:U,width:Ri(1,U*.2),stroke:w.stroke,space:U*2,paths:JI,_stroke:null,_fill:null},w.points);F.show=Ie(F.show),F.filter=Ie(F.filter),F.fill=Ie(F.fill),F.stroke=Ie(F.stroke),F.paths=Ie(F.paths),F.pxAlign=w.pxAlign}if(et){let U=qe(w,C);fe.splice(C,0,U[0]),Xt.splice(C,0,U[1]),mt.values.push(null)}if(vt){ot.splice(C,0,null);let U=null;Dt?C==0&&(U=pl(w,C)):C>0&&(U=pl(w,C)),me.splice(C,0,U),en.splice(C,0,0),fi.splice(C,0,0)}Zn("addSeries",C)}function kf(w,C){C=C??x.length,w=s==1?Cg(w,C,cb,pb):Cg(w,C,{},fb),x.splice(C,0,w),Go(x[C],C)}i.addSeries=kf;function nu(w){if(x.splice(w,1),et){mt.values.splice(w,1),Xt.splice(w,1);let C=fe.splice(w,1)[0];On(null,C.firstChild),C.remove()}vt&&(ot.splice(w,1),me.splice(w,1)[0].remove(),en.splice(w,1),fi.splice(w,1)),Zn("delSeries",w)}i.delSeries=nu;let Ds=[!1,!1,!1,!1];function tr(w,C){if(w._show=w.show,w.show){let U=w.side%2,F=v[w.scale];F==null&&(w.scale=U?x[1].scale:T,F=v[w.scale]);let W=F.time;w.size=Ie(w.size),w.space=Ie(w.space),w.rotate=Ie(w.rotate),oo(w.incrs)&&w.incrs.forEach(ct=>{!ao.has(ct)&&ao.set(ct,Cb(ct))}),w.incrs=Ie(w.incrs||(F.distr==2?lI:W?m==1?uI:fI:No)),w.splits=Ie(w.splits||(W&&F.distr==1?ht:F.distr==3?Eg:F.distr==4?II:PI)),w.stroke=Ie(w.stroke),w.grid.stroke=Ie(w.grid.stroke),w.ticks.stroke=Ie(w.ticks.stroke),w.border.stroke=Ie(w.border.stroke);let J=w.values;w.values=oo(J)&&!oo(J[0])?Ie(J):W?oo(J)?rb(Z,sb(J,q)):tb(J)?gI(Z,J):J||K:J||CI,w.filter=Ie(w.filter||(F.distr>=3&&F.log==10?NI:F.distr==3&&F.log==2?UI:Ab)),w.font=vb(w.font),w.labelFont=vb(w.labelFont),w._size=w.size(i,null,C,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(Ds[C]=!0,w._el=hs(xP,d))}}function er(w,C,U,F){let[W,J,ct,_t]=U,Et=C%2,Bt=0;return Et==0&&(_t||J)&&(Bt=C==0&&!W||C==2&&!ct?Vn(lb.size/3):0),Et==1&&(W||ct)&&(Bt=C==1&&!J||C==3&&!_t?Vn(hb.size/2):0),Bt}let ml=i.padding=(n.padding||[er,er,er,er]).map(w=>Ie(Ne(w,er))),ps=i._padding=ml.map((w,C)=>w(i,C,Ds,0)),yn,En=null,Tn=null,Ns=s==1?x[0].idxs:null,ki=null,Ir=!1;function gl(w,C){if(t=w??[],i.data=i._data=t,s==2){yn=0;for(let U=1;U<x.length;U++)yn+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ki=t[0],yn=ki.length;let U=t;if(B==2){U=t.slice();let F=U[0]=Array(yn);for(let W=0;W<yn;W++)F[W]=W}i._data=t=U}if(xe(!0),Zn("setData"),B==2&&(wt=!0),C!==!1){let U=D;U.auto(i,Ir)?_l():Nr(T,U.min,U.max),nt=nt||pt.left>=0,xt=!0,ri()}}i.setData=gl;function _l(){Ir=!0;let w,C;s==1&&(yn>0?(En=Ns[0]=0,Tn=Ns[1]=yn-1,w=t[0][En],C=t[0][Tn],B==2?(w=En,C=Tn):w==C&&(B==3?[w,C]=cf(w,w,D.log,!1):B==4?[w,C]=Dg(w,w,D.log,!1):D.time?C=w+Vn(86400/m):[w,C]=of(w,C,Ng,!0))):(En=Ns[0]=w=null,Tn=Ns[1]=C=null)),Nr(T,w,C)}let Vo,Lr,Wo,P,G,Q,Y,j,Pt,Ut;function It(w,C,U,F,W,J){w??=Ov,U??=Fg,F??="butt",W??=Ov,J??="round",w!=Vo&&(h.strokeStyle=Vo=w),W!=Lr&&(h.fillStyle=Lr=W),C!=Wo&&(h.lineWidth=Wo=C),J!=G&&(h.lineJoin=G=J),F!=Q&&(h.lineCap=Q=F),U!=P&&h.setLineDash(P=U)}function Ft(w,C,U,F){C!=Lr&&(h.fillStyle=Lr=C),w!=Y&&(h.font=Y=w),U!=j&&(h.textAlign=j=U),F!=Pt&&(h.textBaseline=Pt=F)}function Wt(w,C,U,F,W=0){if(F.length>0&&w.auto(i,Ir)&&(C==null||C.min==null)){let J=Ne(En,0),ct=Ne(Tn,F.length-1),_t=U.min==null?NP(F,J,ct,W,w.distr==3):[U.min,U.max];w.min=Is(w.min,U.min=_t[0]),w.max=Ri(w.max,U.max=_t[1])}}let le={min:null,max:null};function Se(){for(let F in v){let W=v[F];$[F]==null&&(W.min==null||$[T]!=null&&W.auto(i,Ir))&&($[F]=le)}for(let F in v){let W=v[F];$[F]==null&&W.from!=null&&$[W.from]!=null&&($[F]=le)}$[T]!=null&&xe(!0);let w={};for(let F in $){let W=$[F];if(W!=null){let J=w[F]=tl(v[F],VP);if(W.min!=null)Un(J,W);else if(F!=T||s==2)if(yn==0&&J.from==null){let ct=J.range(i,null,null,F);J.min=ct[0],J.max=ct[1]}else J.min=Ke,J.max=-Ke}}if(yn>0){x.forEach((F,W)=>{if(s==1){let J=F.scale,ct=$[J];if(ct==null)return;let _t=w[J];if(W==0){let Et=_t.range(i,_t.min,_t.max,J);_t.min=Et[0],_t.max=Et[1],En=Ps(_t.min,t[0]),Tn=Ps(_t.max,t[0]),Tn-En>1&&(t[0][En]<_t.min&&En++,t[0][Tn]>_t.max&&Tn--),F.min=ki[En],F.max=ki[Tn]}else F.show&&F.auto&&Wt(_t,ct,F,t[W],F.sorted);F.idxs[0]=En,F.idxs[1]=Tn}else if(W>0&&F.show&&F.auto){let[J,ct]=F.facets,_t=J.scale,Et=ct.scale,[Bt,kt]=t[W],Ht=w[_t],de=w[Et];Ht!=null&&Wt(Ht,$[_t],J,Bt,J.sorted),de!=null&&Wt(de,$[Et],ct,kt,ct.sorted),F.min=ct.min,F.max=ct.max}});for(let F in w){let W=w[F],J=$[F];if(W.from==null&&(J==null||J.min==null)){let ct=W.range(i,W.min==Ke?null:W.min,W.max==-Ke?null:W.max,F);W.min=ct[0],W.max=ct[1]}}}for(let F in w){let W=w[F];if(W.from!=null){let J=w[W.from];if(J.min==null)W.min=W.max=null;else{let ct=W.range(i,J.min,J.max,F);W.min=ct[0],W.max=ct[1]}}}let C={},U=!1;for(let F in w){let W=w[F],J=v[F];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let ct=J.distr;J._min=ct==3?Cr(J.min):ct==4?gg(J.min,J.asinh):ct==100?J.fwd(J.min):J.min,J._max=ct==3?Cr(J.max):ct==4?gg(J.max,J.asinh):ct==100?J.fwd(J.max):J.max,C[F]=U=!0}}if(U){x.forEach((F,W)=>{s==2?W>0&&C.y&&(F._paths=null):C[F.scale]&&(F._paths=null)});for(let F in C)wt=!0,Zn("setScale",F);vt&&pt.left>=0&&(nt=xt=!0)}for(let F in $)$[F]=null}function Vt(w){let C=wg(En-1,0,yn-1),U=wg(Tn+1,0,yn-1);for(;w[C]==null&&C>0;)C--;for(;w[U]==null&&U<yn-1;)U++;return[C,U]}function Me(){if(yn>0){let w=x.some(C=>C._focus)&&Ut!=Gt.alpha;w&&(h.globalAlpha=Ut=Gt.alpha),x.forEach((C,U)=>{if(U>0&&C.show&&(pn(U,!1),pn(U,!0),C._paths==null)){let F=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha);let W=s==2?[0,t[U][0].length-1]:Vt(t[U]);C._paths=C.paths(i,U,W[0],W[1]),Ut!=F&&(h.globalAlpha=Ut=F)}}),x.forEach((C,U)=>{if(U>0&&C.show){let F=Ut;Ut!=C.alpha&&(h.globalAlpha=Ut=C.alpha),C._paths!=null&&Ge(U,!1);{let W=C._paths!=null?C._paths.gaps:null,J=C.points.show(i,U,En,Tn,W),ct=C.points.filter(i,U,J,W);(J||ct)&&(C.points._paths=C.points.paths(i,U,En,Tn,ct),Ge(U,!0))}Ut!=F&&(h.globalAlpha=Ut=F),Zn("drawSeries",U)}}),w&&(h.globalAlpha=Ut=1)}}function pn(w,C){let U=C?x[w].points:x[w];U._stroke=U.stroke(i,w),U._fill=U.fill(i,w)}function Ge(w,C){let U=C?x[w].points:x[w],{stroke:F,fill:W,clip:J,flags:ct,_stroke:_t=U._stroke,_fill:Et=U._fill,_width:Bt=U.width}=U._paths;Bt=Qe(Bt*Be,3);let kt=null,Ht=Bt%2/2;C&&Et==null&&(Et=Bt>0?"#fff":_t);let de=U.pxAlign==1&&Ht>0;if(de&&h.translate(Ht,Ht),!C){let Ue=N-Bt/2,De=R-Bt/2,Te=X+Bt,se=dt+Bt;kt=new Path2D,kt.rect(Ue,De,Te,se)}C?zt(_t,Bt,U.dash,U.cap,Et,F,W,ct,J):Ve(w,_t,Bt,U.dash,U.cap,Et,F,W,ct,kt,J),de&&h.translate(-Ht,-Ht)}function Ve(w,C,U,F,W,J,ct,_t,Et,Bt,kt){let Ht=!1;Et!=0&&A.forEach((de,Ue)=>{if(de.series[0]==w){let De=x[de.series[1]],Te=t[de.series[1]],se=(De._paths||qc).band;oo(se)&&(se=de.dir==1?se[0]:se[1]);let Jt,rn=null;De.show&&se&&FP(Te,En,Tn)?(rn=de.fill(i,Ue)||J,Jt=De._paths.clip):se=null,zt(C,U,F,W,rn,ct,_t,Et,Bt,kt,Jt,se),Ht=!0}}),Ht||zt(C,U,F,W,J,ct,_t,Et,Bt,kt)}let Bn=el|Ag;function zt(w,C,U,F,W,J,ct,_t,Et,Bt,kt,Ht){It(w,C,U,F,W),(Et||Bt||Ht)&&(h.save(),Et&&h.clip(Et),Bt&&h.clip(Bt)),Ht?(_t&Bn)==Bn?(h.clip(Ht),kt&&h.clip(kt),Re(W,ct),Cn(w,J,C)):_t&Ag?(Re(W,ct),h.clip(Ht),Cn(w,J,C)):_t&el&&(h.save(),h.clip(Ht),kt&&h.clip(kt),Re(W,ct),h.restore(),Cn(w,J,C)):(Re(W,ct),Cn(w,J,C)),(Et||Bt||Ht)&&h.restore()}function Cn(w,C,U){U>0&&(C instanceof Map?C.forEach((F,W)=>{h.strokeStyle=Vo=W,h.stroke(F)}):C!=null&&w&&h.stroke(C))}function Re(w,C){C instanceof Map?C.forEach((U,F)=>{h.fillStyle=Lr=F,h.fill(U)}):C!=null&&w&&h.fill(C)}function nr(w,C,U,F){let W=E[w],J;if(F<=0)J=[0,0];else{let ct=W._space=W.space(i,w,C,U,F),_t=W._incrs=W.incrs(i,w,C,U,F,ct);J=i3(C,U,_t,F,ct)}return W._found=J}function Pn(w,C,U,F,W,J,ct,_t,Et,Bt){let kt=ct%2/2;y==1&&h.translate(kt,kt),It(_t,ct,Et,Bt,_t),h.beginPath();let Ht,de,Ue,De,Te=W+(F==0||F==3?-J:J);U==0?(de=W,De=Te):(Ht=W,Ue=Te);for(let se=0;se<w.length;se++)C[se]!=null&&(U==0?Ht=Ue=w[se]:de=De=w[se],h.moveTo(Ht,de),h.lineTo(Ue,De));h.stroke(),y==1&&h.translate(-kt,-kt)}function qo(w){let C=!0;return E.forEach((U,F)=>{if(!U.show)return;let W=v[U.scale];if(W.min==null){U._show&&(C=!1,U._show=!1,xe(!1));return}else U._show||(C=!1,U._show=!0,xe(!1));let J=U.side,ct=J%2,{min:_t,max:Et}=W,[Bt,kt]=nr(F,_t,Et,ct==0?H:Nt);if(kt==0)return;let Ht=W.distr==2,de=U._splits=U.splits(i,F,_t,Et,Bt,kt,Ht),Ue=W.distr==2?de.map(Jt=>ki[Jt]):de,De=W.distr==2?ki[de[1]]-ki[de[0]]:Bt,Te=U._values=U.values(i,U.filter(i,Ue,F,kt,De),F,kt,De);U._rotate=J==2?U.rotate(i,Te,F,kt):0;let se=U._size;U._size=ds(U.size(i,Te,F,w)),se!=null&&U._size!=se&&(C=!1)}),C}function Us(w){let C=!0;return ml.forEach((U,F)=>{let W=U(i,F,Ds,w);W!=ps[F]&&(C=!1),ps[F]=W}),C}function ir(){for(let w=0;w<E.length;w++){let C=E[w];if(!C.show||!C._show)continue;let U=C.side,F=U%2,W,J,ct=C.stroke(i,w),_t=U==0||U==3?-1:1,[Et,Bt]=C._found;if(C.label!=null){let gi=C.labelGap*_t,Gi=Vn((C._lpos+gi)*Be);Ft(C.labelFont[0],ct,"center",U==2?"top":Fv),h.save(),F==1?(W=J=0,h.translate(Gi,Vn(R+dt/2)),h.rotate((U==3?-sf:sf)/2)):(W=Vn(N+X/2),J=Gi);let mo=Eb(C.label)?C.label(i,w,Et,Bt):C.label;h.fillText(mo,W,J),h.restore()}if(Bt==0)continue;let kt=v[C.scale],Ht=F==0?X:dt,de=F==0?N:R,Ue=C._splits,De=kt.distr==2?Ue.map(gi=>ki[gi]):Ue,Te=kt.distr==2?ki[Ue[1]]-ki[Ue[0]]:Et,se=C.ticks,Jt=C.border,rn=se.show?se.size:0,bn=Vn(rn*Be),jn=Vn((C.alignTo==2?C._size-rn-C.gap:C.gap)*Be),$e=C._rotate*-sf/180,Sn=p(C._pos*Be),zi=(bn+jn)*_t,mi=Sn+zi;J=F==0?mi:0,W=F==1?mi:0;let ns=C.font[0],ms=C.align==1?Za:C.align==2?fg:$e>0?Za:$e<0?fg:F==0?"center":U==3?fg:Za,Bs=$e||F==1?"middle":U==2?"top":Fv;Ft(ns,ct,ms,Bs);let Hi=C.font[1]*C.lineGap,is=Ue.map(gi=>p(a(gi,kt,Ht,de))),gs=C._values;for(let gi=0;gi<gs.length;gi++){let Gi=gs[gi];if(Gi!=null){F==0?W=is[gi]:J=is[gi],Gi=""+Gi;let mo=Gi.indexOf(`
`)==-1?[Gi]:Gi.split(/\n/gm);for(let _i=0;_i<mo.length;_i++){let G0=mo[_i];$e?(h.save(),h.translate(W,J+_i*Hi),h.rotate($e),h.fillText(G0,0,0),h.restore()):h.fillText(G0,W,J+_i*Hi)}}}se.show&&Pn(is,se.filter(i,De,w,Bt,Te),F,U,Sn,bn,Qe(se.width*Be,3),se.stroke(i,w),se.dash,se.cap);let ks=C.grid;ks.show&&Pn(is,ks.filter(i,De,w,Bt,Te),F,F==0?2:1,F==0?R:N,F==0?dt:X,Qe(ks.width*Be,3),ks.stroke(i,w),ks.dash,ks.cap),Jt.show&&Pn([Sn],[1],F==0?1:0,F==0?1:2,F==1?R:N,F==1?dt:X,Qe(Jt.width*Be,3),Jt.stroke(i,w),Jt.dash,Jt.cap)}Zn("drawAxes")}function xe(w){x.forEach((C,U)=>{U>0&&(C._paths=null,w&&(s==1?(C.min=null,C.max=null):C.facets.forEach(F=>{F.min=null,F.max=null})))})}let vn=!1,pi=!1,We=[];function In(){pi=!1;for(let w=0;w<We.length;w++)Zn(...We[w]);We.length=0}function ri(){vn||(jP(w0),vn=!0)}function iu(w,C=!1){vn=!0,pi=C,w(i),w0(),C&&We.length>0&&queueMicrotask(In)}i.batch=iu;function w0(){if(lt&&(Se(),lt=!1),wt&&(Ct(),wt=!1),St){if(ln(f,Za,ee),ln(f,"top",pe),ln(f,Hc,H),ln(f,Gc,Nt),ln(g,Za,ee),ln(g,"top",pe),ln(g,Hc,H),ln(g,Gc,Nt),ln(d,Hc,xn),ln(d,Gc,Rn),u.width=Vn(xn*Be),u.height=Vn(Rn*Be),E.forEach(({_el:w,_show:C,_size:U,_pos:F,side:W})=>{if(w!=null)if(C){let J=W===3||W===0?U:0,ct=W%2==1;ln(w,ct?"left":"top",F-J),ln(w,ct?"width":"height",U),ln(w,ct?"top":"left",ct?pe:ee),ln(w,ct?"height":"width",ct?Nt:H),Sg(w,Uo)}else Ki(w,Uo)}),Vo=Lr=Wo=G=Q=Y=j=Pt=P=null,Ut=1,vl(!0),ee!=Rt||pe!=Ze||H!=$t||Nt!=Qt){xe(!1);let w=H/$t,C=Nt/Qt;if(vt&&!nt&&pt.left>=0){pt.left*=w,pt.top*=C,$o&&Qs($o,Vn(pt.left),0,H,Nt),Xo&&Qs(Xo,0,Vn(pt.top),H,Nt);for(let U=0;U<me.length;U++){let F=me[U];F!=null&&(en[U]*=w,fi[U]*=C,Qs(F,ds(en[U]),ds(fi[U]),H,Nt))}}if(sn.show&&!rt&&sn.left>=0&&sn.width>0){sn.left*=w,sn.width*=w,sn.top*=C,sn.height*=C;for(let U in qf)ln(jo,U,sn[U])}Rt=ee,Ze=pe,$t=H,Qt=Nt}Zn("setSize"),St=!1}xn>0&&Rn>0&&(h.clearRect(0,0,u.width,u.height),Zn("drawClear"),S.forEach(w=>w()),Zn("draw")),sn.show&&rt&&(su(sn),rt=!1),vt&&nt&&(po(null,!0,!1),nt=!1),mt.show&&mt.live&&xt&&(Vf(),xt=!1),l||(l=!0,i.status=1,Zn("ready")),Ir=!1,vn=!1}i.redraw=(w,C)=>{wt=C||!1,w!==!1?Nr(T,D.min,D.max):ri()};function zf(w,C){let U=v[w];if(U.from==null){if(yn==0){let F=U.range(i,C.min,C.max,w);C.min=F[0],C.max=F[1]}if(C.min>C.max){let F=C.min;C.min=C.max,C.max=F}if(yn>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;w==T&&U.distr==2&&yn>0&&(C.min=Ps(C.min,t[0]),C.max=Ps(C.max,t[0]),C.min==C.max&&C.max++),$[w]=C,lt=!0,ri()}}i.setScale=zf;let Hf,Gf,$o,Xo,E0,T0,Yo,Zo,A0,R0,nn,un,Dr=!1,ti=pt.drag,Xn=ti.x,Yn=ti.y;vt&&(pt.x&&(Hf=hs(vP,g)),pt.y&&(Gf=hs(bP,g)),D.ori==0?($o=Hf,Xo=Gf):($o=Gf,Xo=Hf),nn=pt.left,un=pt.top);let sn=i.select=Un({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),jo=sn.show?hs(yP,sn.over?g:f):null;function su(w,C){if(sn.show){for(let U in w)sn[U]=w[U],U in qf&&ln(jo,U,w[U]);C!==!1&&Zn("setSelect")}}i.setSelect=su;function kM(w){if(x[w].show)et&&Sg(fe[w],Uo);else if(et&&Ki(fe[w],Uo),vt){let U=Dt?me[0]:me[w];U!=null&&Qs(U,-10,-10,H,Nt)}}function Nr(w,C,U){zf(w,{min:C,max:U})}function Fs(w,C,U,F){C.focus!=null&&WM(w),C.show!=null&&x.forEach((W,J)=>{J>0&&(w==J||w==null)&&(W.show=C.show,kM(J),s==2?(Nr(W.facets[0].scale,null,null),Nr(W.facets[1].scale,null,null)):Nr(W.scale,null,null),ri())}),U!==!1&&Zn("setSeries",w,C),F&&bl("setSeries",i,w,C)}i.setSeries=Fs;function zM(w,C){Un(A[w],C)}function HM(w,C){w.fill=Ie(w.fill||null),w.dir=Ne(w.dir,-1),C=C??A.length,A.splice(C,0,w)}function GM(w){w==null?A.length=0:A.splice(w,1)}i.addBand=HM,i.setBand=zM,i.delBand=GM;function VM(w,C){x[w].alpha=C,vt&&me[w]!=null&&(me[w].style.opacity=C),et&&fe[w]&&(fe[w].style.opacity=C)}let sr,Ur,fo,Jo={focus:!0};function WM(w){if(w!=fo){let C=w==null,U=Gt.alpha!=1;x.forEach((F,W)=>{if(s==1||W>0){let J=C||W==0||W==w;F._focus=C?null:J,U&&VM(W,J?1:Gt.alpha)}}),fo=w,U&&ri()}}et&&ae&&Le(zv,Lt,w=>{pt._lock||(oe(w),fo!=null&&Fs(null,Jo,!0,Ln.setSeries))});function Os(w,C,U){let F=v[C];U&&(w=w/Be-(F.ori==1?pe:ee));let W=H;F.ori==1&&(W=Nt,w=W-w),F.dir==-1&&(w=W-w);let J=F._min,ct=F._max,_t=w/W,Et=J+(ct-J)*_t,Bt=F.distr;return Bt==3?Ka(10,Et):Bt==4?BP(Et,F.asinh):Bt==100?F.bwd(Et):Et}function qM(w,C){let U=Os(w,T,C);return Ps(U,t[0],En,Tn)}i.valToIdx=w=>Ps(w,t[0]),i.posToIdx=qM,i.posToVal=Os,i.valToPos=(w,C,U)=>v[C].ori==0?r(w,v[C],U?X:H,U?N:0):o(w,v[C],U?dt:Nt,U?R:0),i.setCursor=(w,C,U)=>{nn=w.left,un=w.top,po(null,C,U)};function C0(w,C){ln(jo,Za,sn.left=w),ln(jo,Hc,sn.width=C)}function P0(w,C){ln(jo,"top",sn.top=w),ln(jo,Gc,sn.height=C)}let xl=D.ori==0?C0:P0,yl=D.ori==1?C0:P0;function $M(){if(et&&mt.live)for(let w=s==2?1:0;w<x.length;w++){if(w==0&&_e)continue;let C=mt.values[w],U=0;for(let F in C)Xt[w][U++].firstChild.nodeValue=C[F]}}function Vf(w,C){if(w!=null&&(w.idxs?w.idxs.forEach((U,F)=>{ot[F]=U}):GP(w.idx)||ot.fill(w.idx),mt.idx=ot[0]),et&&mt.live){for(let U=0;U<x.length;U++)(U>0||s==1&&!_e)&&XM(U,ot[U]);$M()}xt=!1,C!==!1&&Zn("setLegend")}i.setLegend=Vf;function XM(w,C){let U=x[w],F=w==0&&B==2?ki:t[w],W;_e?W=U.values(i,w,C)??he:(W=U.value(i,C==null?null:F[C],w,C),W=W==null?he:{_:W}),mt.values[w]=W}function po(w,C,U){A0=nn,R0=un,[nn,un]=pt.move(i,nn,un),pt.left=nn,pt.top=un,vt&&($o&&Qs($o,Vn(nn),0,H,Nt),Xo&&Qs(Xo,0,Vn(un),H,Nt));let F,W=En>Tn;sr=Ke,Ur=null;let J=D.ori==0?H:Nt,ct=D.ori==1?H:Nt;if(nn<0||yn==0||W){F=pt.idx=null;for(let _t=0;_t<x.length;_t++){let Et=me[_t];Et!=null&&Qs(Et,-10,-10,H,Nt)}ae&&Fs(null,Jo,!0,w==null&&Ln.setSeries),mt.live&&(ot.fill(F),xt=!0)}else{let _t,Et,Bt;s==1&&(_t=D.ori==0?nn:un,Et=Os(_t,T),F=pt.idx=Ps(Et,t[0],En,Tn),Bt=V(t[0][F],D,J,0));let kt=-10,Ht=-10,de=0,Ue=0,De=!0,Te="",se="";for(let Jt=s==2?1:0;Jt<x.length;Jt++){let rn=x[Jt],bn=ot[Jt],jn=bn==null?null:s==1?t[Jt][bn]:t[Jt][1][bn],$e=pt.dataIdx(i,Jt,F,Et),Sn=$e==null?null:s==1?t[Jt][$e]:t[Jt][1][$e];if(xt=xt||Sn!=jn||$e!=bn,ot[Jt]=$e,Jt>0&&rn.show){let zi=$e==null?-10:$e==F?Bt:V(s==1?t[0][$e]:t[Jt][0][$e],D,J,0),mi=Sn==null?-10:O(Sn,s==1?v[rn.scale]:v[rn.facets[1].scale],ct,0);if(ae&&Sn!=null){let ns=D.ori==1?nn:un,ms=Wn(Gt.dist(i,Jt,$e,mi,ns));if(ms<sr){let Bs=Gt.bias;if(Bs!=0){let Hi=Os(ns,rn.scale),is=Sn>=0?1:-1,gs=Hi>=0?1:-1;gs==is&&(gs==1?Bs==1?Sn>=Hi:Sn<=Hi:Bs==1?Sn<=Hi:Sn>=Hi)&&(sr=ms,Ur=Jt)}else sr=ms,Ur=Jt}}if(xt||Dt){let ns,ms;D.ori==0?(ns=zi,ms=mi):(ns=mi,ms=zi);let Bs,Hi,is,gs,ks,gi,Gi=!0,mo=ut.bbox;if(mo!=null){Gi=!1;let _i=mo(i,Jt);is=_i.left,gs=_i.top,Bs=_i.width,Hi=_i.height}else is=ns,gs=ms,Bs=Hi=ut.size(i,Jt);if(gi=ut.fill(i,Jt),ks=ut.stroke(i,Jt),Dt)Jt==Ur&&sr<=Gt.prox&&(kt=is,Ht=gs,de=Bs,Ue=Hi,De=Gi,Te=gi,se=ks);else{let _i=me[Jt];_i!=null&&(en[Jt]=is,fi[Jt]=gs,Xv(_i,Bs,Hi,Gi),qv(_i,gi,ks),Qs(_i,ds(is),ds(gs),H,Nt))}}}}if(Dt){let Jt=Gt.prox,rn=fo==null?sr<=Jt:sr>Jt||Ur!=fo;if(xt||rn){let bn=me[0];bn!=null&&(en[0]=kt,fi[0]=Ht,Xv(bn,de,Ue,De),qv(bn,Te,se),Qs(bn,ds(kt),ds(Ht),H,Nt))}}}if(sn.show&&Dr)if(w!=null){let[_t,Et]=Ln.scales,[Bt,kt]=Ln.match,[Ht,de]=w.cursor.sync.scales,Ue=w.cursor.drag;if(Xn=Ue._x,Yn=Ue._y,Xn||Yn){let{left:De,top:Te,width:se,height:Jt}=w.select,rn=w.scales[Ht].ori,bn=w.posToVal,jn,$e,Sn,zi,mi,ns=_t!=null&&Bt(_t,Ht),ms=Et!=null&&kt(Et,de);ns&&Xn?(rn==0?(jn=De,$e=se):(jn=Te,$e=Jt),Sn=v[_t],zi=V(bn(jn,Ht),Sn,J,0),mi=V(bn(jn+$e,Ht),Sn,J,0),xl(Is(zi,mi),Wn(mi-zi))):xl(0,J),ms&&Yn?(rn==1?(jn=De,$e=se):(jn=Te,$e=Jt),Sn=v[Et],zi=O(bn(jn,de),Sn,ct,0),mi=O(bn(jn+$e,de),Sn,ct,0),yl(Is(zi,mi),Wn(mi-zi))):yl(0,ct)}else $f()}else{let _t=Wn(A0-E0),Et=Wn(R0-T0);if(D.ori==1){let de=_t;_t=Et,Et=de}Xn=ti.x&&_t>=ti.dist,Yn=ti.y&&Et>=ti.dist;let Bt=ti.uni;Bt!=null?Xn&&Yn&&(Xn=_t>=Bt,Yn=Et>=Bt,!Xn&&!Yn&&(Et>_t?Yn=!0:Xn=!0)):ti.x&&ti.y&&(Xn||Yn)&&(Xn=Yn=!0);let kt,Ht;Xn&&(D.ori==0?(kt=Yo,Ht=nn):(kt=Zo,Ht=un),xl(Is(kt,Ht),Wn(Ht-kt)),Yn||yl(0,ct)),Yn&&(D.ori==1?(kt=Yo,Ht=nn):(kt=Zo,Ht=un),yl(Is(kt,Ht),Wn(Ht-kt)),Xn||xl(0,J)),!Xn&&!Yn&&(xl(0,0),yl(0,0))}if(ti._x=Xn,ti._y=Yn,w==null){if(U){if(H0!=null){let[_t,Et]=Ln.scales;Ln.values[0]=_t!=null?Os(D.ori==0?nn:un,_t):null,Ln.values[1]=Et!=null?Os(D.ori==1?nn:un,Et):null}bl(pg,i,nn,un,H,Nt,F)}if(ae){let _t=U&&Ln.setSeries,Et=Gt.prox;fo==null?sr<=Et&&Fs(Ur,Jo,!0,_t):sr>Et?Fs(null,Jo,!0,_t):Ur!=fo&&Fs(Ur,Jo,!0,_t)}}xt&&(mt.idx=F,Vf()),C!==!1&&Zn("setCursor")}let Fr=null;Object.defineProperty(i,"rect",{get(){return Fr==null&&vl(!1),Fr}});function vl(w=!1){w?Fr=null:(Fr=g.getBoundingClientRect(),Zn("syncRect",Fr))}function I0(w,C,U,F,W,J,ct){pt._lock||Dr&&w!=null&&w.movementX==0&&w.movementY==0||(Wf(w,C,U,F,W,J,ct,!1,w!=null),w!=null?po(null,!0,!0):po(C,!0,!1))}function Wf(w,C,U,F,W,J,ct,_t,Et){if(Fr==null&&vl(!1),oe(w),w!=null)U=w.clientX-Fr.left,F=w.clientY-Fr.top;else{if(U<0||F<0){nn=-10,un=-10;return}let[Bt,kt]=Ln.scales,Ht=C.cursor.sync,[de,Ue]=Ht.values,[De,Te]=Ht.scales,[se,Jt]=Ln.match,rn=C.axes[0].side%2==1,bn=D.ori==0?H:Nt,jn=D.ori==1?H:Nt,$e=rn?J:W,Sn=rn?W:J,zi=rn?F:U,mi=rn?U:F;if(De!=null?U=se(Bt,De)?a(de,v[Bt],bn,0):-10:U=bn*(zi/$e),Te!=null?F=Jt(kt,Te)?a(Ue,v[kt],jn,0):-10:F=jn*(mi/Sn),D.ori==1){let ns=U;U=F,F=ns}}Et&&(C==null||C.cursor.event.type==pg)&&((U<=1||U>=H-1)&&(U=Do(U,H)),(F<=1||F>=Nt-1)&&(F=Do(F,Nt))),_t?(E0=U,T0=F,[Yo,Zo]=pt.move(i,U,F)):(nn=U,un=F)}let qf={width:0,height:0,left:0,top:0};function $f(){su(qf,!1)}let L0,D0,N0,U0;function F0(w,C,U,F,W,J,ct){Dr=!0,Xn=Yn=ti._x=ti._y=!1,Wf(w,C,U,F,W,J,ct,!0,!1),w!=null&&(Le(mg,vg,O0,!1),bl(Bv,i,Yo,Zo,H,Nt,null));let{left:_t,top:Et,width:Bt,height:kt}=sn;L0=_t,D0=Et,N0=Bt,U0=kt}function O0(w,C,U,F,W,J,ct){Dr=ti._x=ti._y=!1,Wf(w,C,U,F,W,J,ct,!1,!0);let{left:_t,top:Et,width:Bt,height:kt}=sn,Ht=Bt>0||kt>0,de=L0!=_t||D0!=Et||N0!=Bt||U0!=kt;if(Ht&&de&&su(sn),ti.setScale&&Ht&&de){let Ue=_t,De=Bt,Te=Et,se=kt;if(D.ori==1&&(Ue=Et,De=kt,Te=_t,se=Bt),Xn&&Nr(T,Os(Ue,T),Os(Ue+De,T)),Yn)for(let Jt in v){let rn=v[Jt];Jt!=T&&rn.from==null&&rn.min!=Ke&&Nr(Jt,Os(Te+se,Jt),Os(Te,Jt))}$f()}else pt.lock&&(pt._lock=!pt._lock,po(C,!0,w!=null));w!=null&&(On(mg,vg),bl(mg,i,nn,un,H,Nt,null))}function YM(w,C,U,F,W,J,ct){if(pt._lock)return;oe(w);let _t=Dr;if(Dr){let Et=!0,Bt=!0,kt=10,Ht,de;D.ori==0?(Ht=Xn,de=Yn):(Ht=Yn,de=Xn),Ht&&de&&(Et=nn<=kt||nn>=H-kt,Bt=un<=kt||un>=Nt-kt),Ht&&Et&&(nn=nn<Yo?0:H),de&&Bt&&(un=un<Zo?0:Nt),po(null,!0,!0),Dr=!1}nn=-10,un=-10,ot.fill(null),po(null,!0,!0),_t&&(Dr=_t)}function B0(w,C,U,F,W,J,ct){pt._lock||(oe(w),_l(),$f(),w!=null&&bl(Hv,i,nn,un,H,Nt,null))}function k0(){E.forEach(s3),z(i.width,i.height,!0)}Fo(rf,Ja,k0);let Ko={};Ko.mousedown=F0,Ko.mousemove=I0,Ko.mouseup=O0,Ko.dblclick=B0,Ko.setSeries=(w,C,U,F)=>{let W=Ln.match[2];U=W(i,C,U),U!=-1&&Fs(U,F,!0,!1)},vt&&(Le(Bv,g,F0),Le(pg,g,I0),Le(kv,g,w=>{oe(w),vl(!1)}),Le(zv,g,YM),Le(Hv,g,B0),Rg.add(i),i.syncRect=vl);let ru=i.hooks=n.hooks||{};function Zn(w,C,U){pi?We.push([w,C,U]):w in ru&&ru[w].forEach(F=>{F.call(null,i,C,U)})}(n.plugins||[]).forEach(w=>{for(let C in w.hooks)ru[C]=(ru[C]||[]).concat(w.hooks[C])});let z0=(w,C,U)=>U,Ln=Un({key:null,setSeries:!1,filters:{pub:Kv,sub:Kv},scales:[T,x[1]?x[1].scale:null],match:[Qv,Qv,z0],values:[null,null]},pt.sync);Ln.match.length==2&&Ln.match.push(z0),pt.sync=Ln;let H0=Ln.key,Xf=Zb(H0);function bl(w,C,U,F,W,J,ct){Ln.filters.pub(w,C,U,F,W,J,ct)&&Xf.pub(w,C,U,F,W,J,ct)}Xf.sub(i);function ZM(w,C,U,F,W,J,ct){Ln.filters.sub(w,C,U,F,W,J,ct)&&Ko[w](null,C,U,F,W,J,ct)}i.pub=ZM;function jM(){Xf.unsub(i),Rg.delete(i),$n.clear(),Mg(rf,Ja,k0),c.remove(),Lt?.remove(),Zn("destroy")}i.destroy=jM;function Yf(){Zn("init",n,t),gl(t||n.data,!1),$[T]?zf(T,$[T]):_l(),rt=sn.show&&(sn.width>0||sn.height>0),nt=xt=!0,z(n.width,n.height)}return x.forEach(Go),E.forEach(tr),e?e instanceof HTMLElement?(e.appendChild(c),Yf()):e(i,Yf):Yf(),i}si.assign=Un;si.fmtNum=Ug;si.rangeNum=of;si.rangeLog=cf;si.rangeAsinh=Dg;si.orient=Bo;si.pxRatio=Be;si.join=ZP;si.fmtDate=Og,si.tzDate=oI;si.sync=Zb;{si.addGap=GI,si.clipGaps=df;let n=si.paths={points:eS};n.linear=iS,n.stepped=qI,n.bars=$I,n.spline=YI}var Wg={sqrt:Math.sqrt,sin:Math.sin,cos:Math.cos,tan:Math.tan,asin:Math.asin,acos:Math.acos,atan:Math.atan,abs:Math.abs},aS={pi:Math.PI,\u03C0:Math.PI,tau:2*Math.PI},gf=/\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-zπ°]+)|(\*\*|[-+*/^()−·]))/y,lS=80;function r3(n){let t=[];gf.lastIndex=0;let e=n.trimEnd();for(;gf.lastIndex<e.length;){let i=gf.lastIndex,s=gf.exec(e);if(!s)throw new Error(`cannot read \u201C${e.slice(i).trim().slice(0,8)}\u201D at character ${i+1}`);s[1]!==void 0?t.push({number:Number(s[1])}):s[2]!==void 0?t.push({word:s[2]}):t.push({sign:{"\u2212":"-","\xB7":"*","**":"^"}[s[3]]??s[3]})}return t}function o3(n){if(!n.includes(","))return n;if(n.includes(".")||/\d,\d*,/.test(n))throw new Error("a comma is the decimal sign here: leave out the ones between thousands");return n.replace(/(\d),(?=\d)|(\d),(?!\d)|(^|\D),(?=\d)/g,"$1$2$3.")}function _f(n,t="plain"){let e=o3(String(n));if(e.length>lS)throw new Error(`longer than ${lS} characters`);let i=r3(e);if(!i.length)throw new Error("empty: type a number, or an expression such as pi/2");let s=null,r=i[i.length-1];i.length>1&&r.word&&r.word in gt.suffix(t)&&(s=gt.suffix(t)[r.word],i.pop());let o=0,a=!1,l=m=>i[o]?.sign===m,c=m=>{if(!l(m))throw new Error(`\u201C${m}\u201D is missing`);o++};function u(){let m=h();for(;l("+")||l("-");){let x=i[o++].sign,E=h();m=x==="+"?m+E:m-E}return m}function h(){let m=d();for(;;)if(l("*"))o++,m*=d();else if(l("/"))o++,m/=d();else if(i[o]?.word||l("("))m*=f();else return m}function d(){return l("-")?(o++,-d()):l("+")?(o++,d()):f()}function f(){let m=g();return l("^")?(o++,m**d()):m}function g(){let m=i[o];if(!m)throw new Error("something is missing at the end");if(o++,m.number!==void 0)return m.number;if(m.sign==="("){let x=u();return c(")"),x}if(m.word){let x=m.word.toLowerCase();if(Object.hasOwn(aS,x))return a=!0,aS[x];if(Object.hasOwn(Wg,x)){c("(");let E=u();return c(")"),Wg[x](E)}throw new Error(`\u201C${m.word.slice(0,20)}\u201D is not known; allowed are pi, ${Object.keys(Wg).join(", ")}`)}throw new Error(`\u201C${m.sign}\u201D is not expected here`)}let y=u();if(o<i.length)throw new Error(`\u201C${i[o].sign??i[o].word??i[o].number}\u201D is not expected here`);if(!Number.isFinite(y))throw new Error("not a finite number");let p=s??(t==="angle"&&a?1:gt.factor(t));return{value:y/p+0,symbolic:a||s!==null||i.length>2}}function Fn({label:n,kind:t="plain",input:e,commit:i,empty:s,testid:r,title:o,check:a}){let l=typeof t=="function"?t:()=>t,c=b("input",{type:"text",class:"number",inputmode:"decimal",autocomplete:"off",spellcheck:"false","aria-label":n,"data-testid":r,title:o}),u=null,h=null,d=()=>{if(c.value.trim()===""&&s!==void 0)return{value:s,symbolic:!1};let p=_f(c.value,l()),m=a?.(p.value);if(m)throw new Error(m);return p},f=p=>{c.classList.toggle("wrong",!!p),p?(c.setAttribute("aria-invalid","true"),c.title=p):(c.removeAttribute("aria-invalid"),c.title=o??""),qg(c,p),c.dispatchEvent(new CustomEvent("verdict",{bubbles:!0,detail:p?{label:n,reason:p}:null}))},g=p=>{try{let m=d();return f(null),p?.(m.value,{symbolic:m.symbolic,text:c.value.trim()}),!0}catch(m){return f(m.message),!1}};c.addEventListener("input",()=>g(e)),c.addEventListener("change",()=>{g(i??e)&&c.blurred?.()});let y="";return c.addEventListener("focus",()=>{y=c.value,c.classList.contains("wrong")&&qg(c,c.title),c.select()}),c.addEventListener("blur",()=>qg(c,null)),c.addEventListener("keydown",p=>{let m=c.closest("table.dh");if(p.key==="Escape"&&c.value!==y){p.preventDefault(),c.value=y,g(i??e),c.select();return}if(m&&a3(c,p))return;let x={ArrowUp:1,ArrowDown:-1}[p.key];if(p.key==="Enter"&&(y=c.value,c.select()),!(!x||m&&!p.altKey)){p.preventDefault();try{let E=d();c.value=Ec((E.value??0)+x*gt.step(l())*(p.shiftKey?.1:1),l()),g(i??e)}catch{}}}),c.put=(p,m=null)=>{document.activeElement===c&&!c.readOnly||p===u&&m===h&&!c.classList.contains("wrong")||(u=p,h=m,c.value=m??(p==null?"":Ec(p,l())),$g(c),c.classList.contains("wrong")&&f(null))},c.addEventListener("input",()=>$g(c)),c.refresh=()=>{let p=u,m=h;u=NaN,c.put(p,m)},c}function $g(n){if(n.value.length<7&&!n.shrunk)return;let t=n.clientWidth;if(!t){n.waits||requestAnimationFrame(()=>{n.waits=!1,n.clientWidth&&$g(n)}),n.waits=!0;return}if(n.style.removeProperty("font-size"),n.shrunk=!1,n.scrollWidth<=t)return;let e=parseFloat(getComputedStyle(n).fontSize);n.style.setProperty("font-size",`${Math.max(.58*e,e*(t-14)/(n.scrollWidth-14)).toFixed(2)}px`),n.shrunk=!0}var Ci=null;function qg(n,t){if(!t){Ci&&Ci.about===n&&(Ci.hidden=!0),n.removeAttribute("aria-describedby");return}Ci||(Ci=b("div",{class:"why",id:"why",role:"alert","data-testid":"why"}),document.body.append(Ci)),Ci.about=n,Ci.hidden=!1,Ci.textContent!==t&&(Ci.textContent=t),n.setAttribute("aria-describedby","why");let e=n.getBoundingClientRect();Ci.style.setProperty("top",`${e.bottom+4}px`),Ci.style.setProperty("left",`${Math.max(8,Math.min(e.left,innerWidth-Ci.offsetWidth-8))}px`)}addEventListener("scroll",()=>Ci&&(Ci.hidden=!0),!0);function a3(n,t){let e=n.selectionStart===0&&n.selectionEnd===n.value.length,i={ArrowUp:-1,ArrowDown:1,Enter:t.shiftKey?-1:1}[t.key],s={ArrowLeft:e||n.selectionEnd===0?-1:0,ArrowRight:e||n.selectionStart===n.value.length?1:0}[t.key]??0;if(t.altKey||t.ctrlKey||t.metaKey||!i&&!s)return!1;let r=[...n.closest("tbody").rows].map(c=>[...c.querySelectorAll("input.number")]),o=r.findIndex(c=>c.includes(n)),a=r[o].indexOf(n),l=r[o+(i??0)]?.[a+s];return t.key==="Enter"&&n.dispatchEvent(new Event("change")),l?(t.preventDefault(),l.focus(),!0):t.key!=="Enter"}function xf(n){let t=n.trim().replace(/^\[\s*\[|\]\s*\]$/g,"").split(/\]\s*,?\s*\[|[;\r\n]+/).map(e=>e.replace(/^[\s[(,]+|[\s\]),]+$/g,"")).filter(Boolean).map(e=>{let i=e.split("	");return(i.length>1?i:e.split(/\s*,\s+|\s+|,(?=[^,]*\.)|,(?=[A-Za-z(-])/)).map(s=>s.trim()).filter(Boolean)});return t.length>1||(t[0]?.length??0)>1?t:null}function yf(n,t,e,i){let s=0;return i.forEach((r,o)=>r.forEach((a,l)=>{let c=n[t+o]?.[e+l];c&&(c.value=a,c.dispatchEvent(new Event("input",{bubbles:!0})),c.dispatchEvent(new Event("change",{bubbles:!0})),s+=1)})),s}var Ye=n=>n.type==="R"?"angle":"length";function cS(n){let t=n.type==="R"?Math.PI:oi(M.table),e=n.lower??Math.min(-t,(n.upper??t)-2*t),i=n.upper??Math.max(t,e+2*t),s=Math.max((i-e)*.08,.001);return{lo:e,hi:i,min:n.lower===null?e:e-s,max:n.upper===null?i:i+s}}var l3=Um;function c3(n){let t=M.table.joints[n],e=Ye(t),{lo:i,hi:s,min:r,max:o}=cS(t),a=`q${n+1}`,l=b("input",{type:"range",min:String(r),max:String(o),step:"any","aria-label":`${a}, ${t.name}`,"data-testid":`slider-${n+1}`}),c=y=>`${100*(y-r)/(o-r)}%`;l.style.setProperty("--lo",c(i)),l.style.setProperty("--hi",c(s)),l.addEventListener("input",()=>{ui(),hu(n,Number(l.value))}),l.addEventListener("keydown",y=>{let p={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[y.key],m={Home:i,End:s}[y.key];if(p===void 0&&m===void 0)return;y.preventDefault(),ui();let x=gt.step(e)*(y.shiftKey?.1:1);hu(n,m??Math.min(Math.max(Math.round((M.q[n]+p*x)/(x/10))*(x/10),r),o))});let u=Fn({label:`${a} value`,kind:e,testid:`q-${n+1}`,input:y=>{ui(),hu(n,y)}}),h=b("span",{class:"out",role:"note"}),d=b("span",{class:"chain",title:"What this row of the table moves by"}),f=b("span",{class:"limits"}),g=b("div",{class:"joint","data-testid":`joint-${n+1}`},b("span",{class:"joint-name",title:`${t.name}, ${t.type==="R"?"revolute":"prismatic"}`},b("i",{text:"q"}),b("sub",{text:String(n+1)})),b("div",{class:"track"},l,b("div",{class:"under"},f,d,h)),u,b("span",{class:"unit"}));return{el:g,number:u,show(){let y=M.q[n],p=l3(t,y);(document.activeElement!==l||Number(l.value)!==y)&&(l.value=y),l.style.setProperty("--at",c(Math.min(Math.max(y,r),o))),l.setAttribute("aria-valuetext",Ee(y,e)),u.put(Number((y*gt.factor(e)).toFixed(gt.digits(e)+1))/gt.factor(e)),g.classList.toggle("outside",p!==0);let m=M.table.coupling?`chain ${Ee(ar(M.table,M.q)[n],e)}`:"";yt(d,m),yt(h,p?`${Ee(Math.abs(p),e)} ${p>0?"above":"below"} the limit`:"")},relabel(){yt(g.lastChild,gt.symbol(e));let y=p=>p===null?"no limit":Ee(p,e,gt.angle==="deg"&&e==="angle"?0:void 0);yt(f,t.lower===null&&t.upper===null?"no limits":`${y(t.lower)} \u2026 ${y(t.upper)}`),u.refresh(),this.show()}}}var uS={id:"joints",title:"Joints",build(n){let t=[],e=b("div",{class:"joints","data-testid":"joints"}),i=b("div",{class:"chips",role:"group","aria-label":"Postures"}),s=b("div",{class:"joints gripper"});n.append(e,s,i);let r=()=>{t=M.table.joints.map((o,a)=>c3(a)),Yt(e,t.map(o=>o.el)),t.length||e.append(b("p",{class:"hint",text:"This table has no joints yet. Add one in the DH table."})),t.forEach(o=>o.relabel()),Yt(s,M.table.actuator?u3(M.table.actuator):null),h3(i)};st("table",o=>o!=="gripper"&&r()),st("q",()=>t.forEach(o=>o.show())),st("units",()=>t.forEach(o=>o.relabel())),r()}};function u3(n){let t=b("input",{type:"range",min:String(n.lower),max:String(n.upper),step:"any","aria-label":`${n.name}, ${n.unit}`,"data-testid":"actuator"}),e=b("output",{class:"quantity"}),i=()=>{t.style.setProperty("--at",`${100*(n.value-n.lower)/(n.upper-n.lower||1)}%`),yt(e,Qn(n.value,1))};t.value=n.value,t.addEventListener("input",()=>{n={...n,value:Number(t.value)},hn({...M.table,actuator:n},{what:"gripper",label:`set the ${n.name}`,key:"actuator"}),i()}),i();let s=b("div",{class:"under"},b("span",{text:`${n.name}: moves no frame`}));return b("div",{class:"joint"},b("span",{class:"joint-name",text:"tool"}),b("div",{class:"track"},t,s),e,b("span",{class:"unit",text:n.unit}))}function h3(n){let t=M.table.joints.length,e=Object.entries(M.table.postures??{}),i=(r,o)=>b("button",{type:"button",class:"chip",text:r,title:o.map((a,l)=>Ee(a,Ye(M.table.joints[l]))).join(", "),on:{click:()=>Ai(o,.8,`move to ${r}`)}}),s=e.map(([r,o])=>i(r,o));t&&!e.some(([,r])=>r.every(o=>o===0))&&s.unshift(i("zero",new Array(t).fill(0))),Yt(n,s,t?b("button",{type:"button",class:"chip quiet",text:"Random",title:"A posture inside the limits",on:{click:()=>Ai(d3(),.8,"move to a random posture")}}):null,t?b("button",{type:"button",class:"chip quiet",text:"Keep this one",title:"Add the present posture to the arm",on:{click:f3}}):null)}function d3(){return M.table.joints.map(n=>{let{lo:t,hi:e}=cS(n);return t+Math.random()*(e-t)})}function f3(){let n={...M.table.postures},t=0;for(;`P${t}`in n;)t+=1;n[`P${t}`]=M.q.slice(),hn({...M.table,postures:n},{what:"postures",label:`keep the posture P${t}`}),Xe(`Kept as P${t}: ${M.q.map((e,i)=>Ec(e,Ye(M.table.joints[i]))).join(", ")}`),ft("postures")}var hS=[["position","Position"],["joints","Joints"],["speeds","Joint speeds"],["singularity","Distance to singularity"]];function lo({table:n,q:t,xs:e,xName:i,xEnd:s=null,seconds:r,dq:o=null,events:a=[],title:l}){let c=t.map(u=>_s(n,u));return{table:n,q:t,xs:e,xName:i,xEnd:s,seconds:r,events:a,title:l,tool:c.map(u=>ne(u[u.length-1])),speeds:o??p3(t,r),least:t.map((u,h)=>uu(n,u,c[h])[0]??0)}}function p3(n,t){return n.map((e,i)=>{let s=Math.max(i-1,0),r=Math.min(i+1,n.length-1),o=t[r]-t[s];return n[i].map((a,l)=>o>0?(n[r][l]-n[s][l])/o:0)})}function Xg(n,t){let{table:e}=n,i=gt.factor("length");if(t==="position")return{y:`tool, ${gt.length}`,list:["X","Y","Z"].map((l,c)=>({name:l,values:n.tool.map(u=>u[c]*i)}))};if(t==="singularity")return{y:"smallest singular value",list:[{name:"\u03C3 min",values:n.least}]};let s=t==="joints"?n.q:n.speeds,r=t==="joints"?"":"/s";return{y:[...new Set(e.joints.map(Ye))].map(l=>(l==="angle"?gt.angle:gt.length)+r).join(" or "),list:e.joints.map((l,c)=>({name:`q${c+1}`,values:s.map(u=>u[c]*gt.factor(Ye(l)))}))}}function dS(n){let t=gt.angle,e=gt.length,{table:i}=n,s=l=>Ye(l)==="angle"?t:e,r=[n.xName.replace(" ","_"),"time_s",`X_${e}`,`Y_${e}`,`Z_${e}`,...i.joints.map((l,c)=>`q${c+1}_${s(l)}`),...i.joints.map((l,c)=>`dq${c+1}_${s(l)}_per_s`),"sigma_min"],o=l=>String(Number(l.toPrecision(10))),a=n.q.map((l,c)=>[n.xs[c],n.seconds[c],...n.tool[c].map(u=>u*gt.factor("length")),...l.map((u,h)=>u*gt.factor(Ye(i.joints[h]))),...n.speeds[c].map((u,h)=>u*gt.factor(Ye(i.joints[h]))),n.least[c]].map(o).join(","));return[r.join(","),...a].join(`
`)+`
`}function fS(n,t,e){let{y:i,list:s}=Xg(n,t),r=720,o=380,a={l:66,r:96,t:34,b:48},l=n.xs,c=s.flatMap(_=>_.values),u=n.xEnd??l[l.length-1],h=l[0],d=u>h?u:h+1,[f,g]=[Math.min(...c),Math.max(...c)];g-f>1e-9||(f-=1,g+=1);let y=_=>a.l+(_-h)/(d-h)*(r-a.l-a.r),p=_=>o-a.b-(_-f)/(g-f)*(o-a.t-a.b),m=(_,S)=>{let L=(S-_)/6,I=10**Math.floor(Math.log10(L)),D=[1,2,5,10].map(B=>B*I).find(B=>B>=L);return Array.from({length:12},(B,V)=>(Math.ceil(_/D)+V)*D).filter(B=>B<=S+D*1e-6)},x=_=>_.toFixed(2),E=_=>String(Number(_.toPrecision(6))),v=_=>_.replace(/[&<>"]/g,S=>({"&":"&amp;","<":"&lt;",">":"&gt;",'"':"&quot;"})[S]),A=["","7 3","2 3","9 3 2 3","5 2 1 2 1 2","12 4","1 2","6 6"],T=[`<rect width="${r}" height="${o}" fill="#fff"/>`,`<text x="${a.l}" y="20" font-weight="600">${v(n.title)}</text>`];for(let _ of m(f,g))T.push(`<path d="M${a.l} ${x(p(_))}H${r-a.r}" stroke="#ddd"/><text x="${a.l-8}" y="${x(p(_)+4)}" text-anchor="end">${E(_)}</text>`);for(let _ of m(h,d))T.push(`<path d="M${x(y(_))} ${o-a.b}v5" stroke="#333"/><text x="${x(y(_))}" y="${o-a.b+20}" text-anchor="middle">${E(_)}</text>`);T.push(`<path d="M${a.l} ${a.t}V${o-a.b}H${r-a.r}" fill="none" stroke="#333"/>`);for(let _ of n.events)Number.isFinite(_.x)&&T.push(`<path d="M${x(y(_.x))} ${a.t}V${o-a.b}" stroke="#b42318" stroke-dasharray="3 3"/><text x="${x(y(_.x)+4)}" y="${a.t+10}" fill="#b42318" font-size="11">${v(_.short)}</text>`);return s.forEach((_,S)=>{let L=e[S%e.length],I=_.values[_.values.length-1];T.push(`<polyline fill="none" stroke="${L}" stroke-width="1.8" stroke-dasharray="${A[S%A.length]}" points="${_.values.map((D,B)=>`${x(y(l[B]))},${x(p(D))}`).join(" ")}"/>`,`<path d="M${r-a.r+12} ${a.t+8+18*S}h22" stroke="${L}" stroke-width="2" stroke-dasharray="${A[S%A.length]}"/><text x="${r-a.r+40}" y="${a.t+12+18*S}"><title>${x(I)}</title>${v(_.name)}</text>`)}),T.push(`<text x="${(a.l+r-a.r)/2}" y="${o-8}" text-anchor="middle">${v(n.xName)}</text>`,`<text transform="translate(16 ${(a.t+o-a.b)/2}) rotate(-90)" text-anchor="middle">${v(i)}</text>`),`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${r} ${o}" width="${r}" height="${o}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12" fill="#222">${T.join("")}</svg>
`}async function pS(n,t){if(!window.MediaRecorder||!n.captureStream)throw new Error("This browser records no video.");let e=new MediaRecorder(n.captureStream(30),{mimeType:"video/webm",videoBitsPerSecond:8e6}),i=[];e.ondataavailable=({data:r})=>r.size&&i.push(r);let s=new Promise(r=>{e.onstop=r});return e.start(),await t(),await new Promise(r=>setTimeout(r,400)),e.stop(),await s,new Blob(i,{type:"video/webm"})}var He=null,qn=null,rl="joints",es=0,mS=1,di=null;function gS(n){let t=b("button",{type:"button",class:"primary",text:"Play","data-testid":"play",on:{click:_S}}),e=b("input",{type:"range",min:"0",max:"1",step:"1",value:"0","aria-label":"Point of the motion","data-testid":"scrub",on:{input:()=>{ui(),ko(Number(e.value))}}}),i=b("output",{class:"where","data-testid":"where"}),s=b("div",{class:"marks"}),r=b("div",{class:"chart","data-testid":"chart"}),o=b("div",{class:"legend"});n.append(b("div",{class:"dock-bar"},t,Mn("Speed",[["0.25","\xBC\xD7"],["0.5","\xBD\xD7"],["1","1\xD7"],["2","2\xD7"],["4","4\xD7"],["10","10\xD7"]],"1",a=>{mS=Number(a)},{"data-testid":"speed"}),b("div",{class:"scrubber"},e,s),i,b("span",{class:"line"},...[["CSV",()=>yi("motion.csv",dS(He),"text/csv")],["PNG",_3],["Film",g3],["SVG",()=>yi(`${rl}.svg`,fS(He,rl,Kt.curves),"image/svg+xml")]].map(([a,l])=>b("button",{type:"button",class:"quiet",text:a,"aria-label":`Save as ${a}`,on:{click:()=>He&&l()}})),b("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the curves",on:{click:()=>fs(null)}}))),b("div",{class:"dock-bar second"},mn("Curves",hS,rl,a=>{rl=a,Yg()},"curves"),o),r),di={root:n,toggle:t,scrub:e,where:i,marks:s,chart:r,legend:o},new ResizeObserver(Br(()=>qn&&r.clientWidth&&qn.setSize({width:r.clientWidth,height:r.clientHeight}))).observe(r),st(["units","theme"],Yg),st("moving",a=>yt(t,a&&bf?"Pause":"Play")),st("table",a=>{He&&!["postures","name","gripper"].includes(a)&&fs(null)})}function fs(n){if(ui(),He=n,M.motion=n,di.root.hidden=!n,qn&&(qn.destroy(),qn=null),uv(n?.table??null,n?.q??[]),!n){ft("motion");return}di.scrub.max=String(Math.max(n.q.length-1,0));let t=n.xs[n.xs.length-1]-n.xs[0]||1;Yt(di.marks,n.events.map(e=>{let i=b("span",{class:"event-mark",title:e.text});return i.style.setProperty("left",`${Math.min(100*(e.x-n.xs[0])/t,100)}%`),i}),(n.tight??[]).map(e=>{let i=b("span",{class:"tight-mark",title:e.text});return i.style.setProperty("left",`${100*(e.start-n.xs[0])/t}%`),i.style.setProperty("width",`${100*(e.end-e.start)/t}%`),i})),Yg(),ft("motion"),n.q.length&&ko(0),requestAnimationFrame(()=>Ha())}function ko(n){He?.q.length&&(es=Math.min(Math.max(Math.round(n),0),He.q.length-1),di.scrub.value=String(es),di.scrub.style.setProperty("--at",`${He.q.length>1?100*es/(He.q.length-1):0}%`),yt(di.where,He.xName==="point"?`point ${es+1} of ${He.q.length}`:`${Qn(He.xs[es],2)} s of ${Qn(He.xs[He.xs.length-1],2)} s`),di.scrub.setAttribute("aria-valuetext",di.where.textContent),Ii(He.q[es].slice(),"scrub"),ft("played",He.seconds[es]),Zg())}var bf=!1;function _S(n,t){if(bf){ui();return}if(!He?.q.length)return;let e=He.seconds,i=e[e.length-1]||1,s=es>=He.q.length-1?0:e[es]/i;bf=!0,wv(i/mS,s,r=>{let o=es<=He.q.length-1&&e[es]<=r*i?es:0;for(;o<e.length-1&&e[o+1]<=r*i+1e-9;)o+=1;ko(o)},()=>{bf=!1,yt(di.toggle,"Play"),t?.()}),yt(di.toggle,"Pause")}function Yg(){if(!He||!di)return;qn&&(qn.destroy(),qn=null);let{y:n,list:t}=Xg(He,rl),e={stroke:Kt.line,width:1},i=`${Math.round(.78*vf())}px "Inter Variable", system-ui, sans-serif`;Yt(di.legend,t.map((o,a)=>{let l=b("span",{class:"swatch"});return l.style.setProperty("background",Kt.curves[a%Kt.curves.length]),b("span",{},l,o.name)}));let s={stroke:Kt.muted,grid:e,ticks:{...e,size:4},font:i,labelFont:i,labelSize:1.4*vf(),gap:4};qn=new si({width:di.chart.clientWidth||600,height:di.chart.clientHeight||180,pxAlign:0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,He.xEnd??l,a+1e-6)]},y:{range:(o,a,l)=>l-a>1e-9?[a-.06*(l-a),l+.06*(l-a)]:[a-1,l+1]}},series:[{},...t.map((o,a)=>({label:o.name,stroke:Kt.curves[a%Kt.curves.length],width:1.75,pxAlign:0,points:{show:He.q.length<3}}))],axes:[{...s,label:He.xName==="point"?"point number":"time, s",size:2.1*vf()},{...s,label:n,size:4*vf()}]},[He.xs,...t.map(o=>o.values)],di.chart);let r=b("div",{class:"now"});qn.over.append(r,...He.events.map(o=>{let a=b("div",{class:`event ${o.stop?"stop":""}`,title:o.text},b("span",{text:o.short}));return a.x=o.x,a})),qn.over.addEventListener("pointerdown",o=>{let a=u=>ko(m3(qn.posToVal(u.clientX-qn.over.getBoundingClientRect().left,"x")));ui(),a(o);let l=u=>a(u),c=()=>{removeEventListener("pointermove",l),removeEventListener("pointerup",c)};addEventListener("pointermove",l),addEventListener("pointerup",c)}),qn.hooks.setSize=[Zg],Zg()}var vf=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),m3=n=>He.xs.reduce((t,e,i)=>Math.abs(e-n)<Math.abs(He.xs[t]-n)?i:t,0);function Zg(){if(!qn)return;let n=qn.over.clientWidth;for(let t of qn.over.querySelectorAll(".now, .event")){let e=qn.valToPos(t.x??He.xs[es],"x");t.style.setProperty("left",`${e}px`),t.classList.toggle("leftward",e>n*.7)}}async function g3(){ui(),ko(0);try{let n=await za(t=>pS(t,()=>new Promise(e=>_S(null,e))));yi("motion.webm",n)}catch(n){Xe(n.message,"wrong")}}function _3(){let n=qn.ctx.canvas,t=document.createElement("canvas"),e=t.getContext("2d");t.width=n.width,t.height=n.height,e.fillStyle=Kt.panel,e.fillRect(0,0,t.width,t.height),e.drawImage(n,0,0),t.toBlob(i=>yi(`${rl}.png`,i))}function ol(n,t){let e=Array.from({length:16},(s,r)=>b("span",{role:"cell",class:r%4===3&&r<12?"p":r>=12?"last":""})),i=b("div",{class:"matrix",role:"table","aria-label":n,"data-testid":t},[0,4,8,12].map(s=>b("div",{role:"row",class:"matrix-row"},e.slice(s,s+4))));return i.show=s=>{for(let r=0;r<16;r++){let o=r%4===3&&r<12;yt(e[r],r>=12?String(s[r]):o?Qn(s[r]*gt.factor("length"),gt.digits("length")):Qn(s[r],4))}},i}var Sf=n=>[0,4,8,12].map(t=>`[${n.slice(t,t+4).map(e=>Number(e.toPrecision(12))+0).join(", ")}]`).join(`,
`);var jg="pieper-panel-width",Jg=18,xS=70;function yS(n,t){let e=b("div",{class:"splitter",role:"separator","aria-orientation":"vertical","aria-label":"Width of the panels","aria-valuemin":String(Jg),"aria-valuemax":String(xS),tabindex:"0","data-testid":"splitter"});t.prepend(e);let i=()=>parseFloat(getComputedStyle(document.documentElement).fontSize),s=()=>document.getElementById("panels").offsetWidth/i(),r=a=>{let l=a===null?null:Math.min(Math.max(a,Jg),xS,.75*innerWidth/i());l===null?n.style.removeProperty("--panel-width"):n.style.setProperty("--panel-width",`${l}rem`),n.classList.toggle("split",l!==null),e.setAttribute("aria-valuenow",String(Math.round(l??s())));try{l===null?localStorage.removeItem(jg):localStorage.setItem(jg,String(l))}catch{}};e.addEventListener("pointerdown",a=>{e.setPointerCapture(a.pointerId);let l=a.clientX,c=s(),u=h=>r(c+(l-h.clientX)/i());e.addEventListener("pointermove",u),e.addEventListener("pointerup",()=>e.removeEventListener("pointermove",u),{once:!0})}),e.addEventListener("dblclick",()=>r(null)),e.addEventListener("keydown",a=>{let l={ArrowLeft:1,ArrowRight:-1}[a.key];if(l)r(s()+l*(a.shiftKey?5:1));else if(a.key==="Home")r(null);else return;a.preventDefault()});let o=Number(localStorage.getItem(jg));o>=Jg?r(o):e.setAttribute("aria-valuenow","38")}function vS(n){let t=ol("Pose of the tool, large","present-pose"),e=b("div",{class:"present-card",hidden:!0},t);n.append(e);let i=document.documentElement,s=b("button",{type:"button",text:"Present","aria-pressed":"false","data-testid":"present",on:{click:()=>o(i.dataset.present!=="yes")}}),r=()=>!e.hidden&&t.show(M.frames.at(-1));function o(a){a?i.dataset.present="yes":delete i.dataset.present,e.hidden=!a,s.setAttribute("aria-pressed",String(a)),r(),ft("units"),dispatchEvent(new Event("resize"))}return st(["q","units"],r),addEventListener("keydown",a=>a.key==="Escape"&&i.dataset.present&&!a.target.matches?.("input")&&o(!1)),s}function bS(){za(n=>n.toBlob(t=>t?yi(`${M.table.name||"arm"}.png`,t):Xe("The picture could not be read.","wrong")))}var x3="http://www.w3.org/2000/svg";function y3(n){let t=n.map(([l,c,u])=>[.77*l+.62*c,.3*l-.38*c-.88*u]);t.unshift([t[0][0],t[0][1]]);let[e,i]=[0,1].map(l=>t.map(c=>c[l])),s=Math.max(Math.max(...e)-Math.min(...e),Math.max(...i)-Math.min(...i))||1,r=([l,c])=>[22+36*(l-(Math.max(...e)+Math.min(...e))/2)/s,22+36*(c-(Math.max(...i)+Math.min(...i))/2)/s],o=(l,c)=>{let u=document.createElementNS(x3,l);for(let[h,d]of Object.entries(c))u.setAttribute(h,d);return u},a=o("svg",{viewBox:"0 0 44 44",class:"thumb","aria-hidden":"true"});a.append(o("polyline",{points:t.map(l=>r(l).map(c=>c.toFixed(1)).join(",")).join(" ")}));for(let l of t.slice(1))a.append(o("circle",{cx:r(l)[0].toFixed(1),cy:r(l)[1].toFixed(1),r:1.7}));return a}function SS(n){let t=null,e=b("div",{class:"arms",role:"listbox","aria-label":"Arms found","data-testid":"arms-found"}),i=b("span",{class:"hint",role:"status"}),s=b("input",{type:"text",placeholder:"Name, maker, or joints such as 7R","aria-label":"Search the catalogue","data-testid":"search-arms",autocomplete:"off",on:{input:()=>a(),keydown:l=>{if(l.key==="ArrowDown")e.firstElementChild?.focus();else if(l.key==="Enter")e.firstElementChild?.click();else return;l.preventDefault()}}}),r=b("dialog",{class:"catalogue","aria-label":"Catalogue"},b("div",{class:"line"},s,i,b("button",{type:"button",class:"icon",text:"\xD7","aria-label":"Close the catalogue",on:{click:()=>r.close()}})),e);document.body.append(r);let o=l=>/^(.)\1*$/.test(l)?`${l.length}${l[0]}`:l;function a(){let l=s.value.toLowerCase().split(/\s+/).filter(Boolean),c=(t??[]).filter(u=>{let h=`${u.name} ${u.maker} ${u.joints} ${o(u.joints)}`.toLowerCase();return l.every(d=>h.includes(d))});i.textContent=`${c.length} of ${t?.length??0} arms`,Yt(e,c.map(u=>b("button",{type:"button",role:"option",class:"arm-card","data-name":u.name,on:{click:()=>{r.close(),n(u.name)},keydown:h=>{let d={ArrowDown:"nextElementSibling",ArrowUp:"previousElementSibling"}[h.key];d&&(h.preventDefault(),(h.currentTarget[d]??s).focus())}}},y3(u.points),b("span",{},b("b",{text:u.name}),b("span",{class:"hint",text:[u.maker,o(u.joints)].filter(Boolean).join(", ")})))))}return async()=>{if(r.showModal(),s.select(),!t)try{t=(await Vi("catalog")).arms,a()}catch(l){Xe(l.message,"wrong")}}}function wS(n){let t=b("select",{"aria-label":"Arm from the catalogue","data-testid":"catalog",on:{change:()=>MS(t.value)}}),e=SS(MS),i=b("p",{class:"sentence","data-testid":"sentence"}),s=b("span",{class:"online",role:"status","data-testid":"online"}),r=(u,h,d,f)=>{let g=b("button",{type:"button",text:u,"aria-label":h,on:{click:d}});return g.show=y=>{g.disabled=!y,g.title=y?`${h}: ${y} (${f})`:`Nothing to ${h.toLowerCase()}`,g.setAttribute("aria-description",y??"")},g},o=r("\u21B6","Undo",ug,"Ctrl+Z"),a=r("\u21B7","Redo",hg,"Ctrl+Shift+Z");st("history",()=>{o.show(Yd()),a.show(Zd())});let l=()=>{let{name:u,derived:h,catalog:d}=M.table,f=d?[]:[b("option",{value:"",text:h?`${u} (from ${h}, edited)`:u||"my-arm"})];Yt(t,f,(M.catalog??[]).map(g=>b("option",{value:g,text:g}))),t.value=d??""},c=b("span",{class:"group",role:"group","aria-label":"History"},o,a);n.append(b("span",{class:"mark"},b("img",{src:"icon.svg",alt:"",width:"22",height:"22"}),b("b",{text:"pieper"})),t,b("button",{type:"button",class:"find",text:"Find\u2026","aria-label":"Find an arm in the catalogue","data-testid":"find-arm",on:{click:e}}),c,i,b("span",{class:"bar-end"},s,mn("Angles in",[["deg","\xB0"],["rad","rad"]],gt.angle,u=>{gt.set("angle",u),ft("units")},"unit-angle"),mn("Lengths in",[["mm","mm"],["m","m"]],gt.length,u=>{gt.set("length",u),ft("units")},"unit-length"),Mn("Light or dark",[["auto","Auto"],["light","Light"],["dark","Dark"]],M.theme,_d,{"data-testid":"theme"}))),ft("history"),st(["catalog","table"],l),st("plan",()=>{yt(i,[fu(M.plan),e_(M.plan)].filter(Boolean).join(". ").replace("..",".")),i.title=M.plan?.explain??""}),st("online",u=>{yt(s,u?"":"Server away; reconnecting"),s.classList.toggle("away",!u)}),st(["units","theme"],()=>{n.querySelector("[data-testid=unit-angle]").mark(gt.angle),n.querySelector("[data-testid=unit-length]").mark(gt.length),n.querySelector("[data-testid=theme]").value=M.theme})}async function MS(n){if(n)try{let{table:t}=await Vi("load",{name:n});hn(t,{q:Qo(t),what:"new",label:`open ${n}`})}catch(t){Xe(t.message,"wrong")}}function ES(n,t,e,i){let s=b("div",{role:"tablist","aria-orientation":"vertical",class:"tabs"}),r=matchMedia("(min-width: 1700px)");n.append(s);let o=new Map,a=i.map(c=>{let u=b("div",{role:"tabpanel",class:"panel",id:`panel-${c.id}`,"aria-labelledby":`tab-${c.id}`,"data-testid":`panel-${c.id}`,hidden:!0});for(let d of c.sections??[c]){let f=b("section",{class:"section"},b("h2",{text:d.title}));u.append(f),d.build(f,u)}let h=b("button",{type:"button",role:"tab",id:`tab-${c.id}`,"aria-controls":u.id,text:c.title,on:{click:()=>l(c.id)}});return c.group&&s.append(b("span",{class:"tab-group","aria-hidden":"true",text:c.group})),s.append(h),{...c,panel:u,tab:h}});function l(c){r.matches&&c==="move"&&(c="inverse"),o.set(M.panel,t.scrollTop),M.panel=c;for(let u of a){let h=r.matches&&u.id==="move",d=u.id===c||h;(h?e:t).append(u.panel),u.panel.hidden=!d,u.tab.hidden=h,u.tab.setAttribute("aria-selected",String(u.id===c)),u.tab.tabIndex=u.id===c?0:-1,u.id===c&&(document.getElementById("room").dataset.panel=c,document.getElementById("room").classList.toggle("wide",!!u.wide))}ft("panel",c),t.scrollTop=o.get(c)??0}return s.addEventListener("keydown",c=>{let u={ArrowDown:1,ArrowUp:-1,ArrowRight:1,ArrowLeft:-1}[c.key];if(!u)return;c.preventDefault();let h=a.filter(g=>!g.tab.hidden),d=h.findIndex(g=>g.id===M.panel),f=h[(d+u+h.length)%h.length];l(f.id),f.tab.focus()}),r.addEventListener("change",()=>l(M.panel==="move"||!a.some(c=>c.id===M.panel)?"move":M.panel)),l(M.panel),l}function TS(n){let t=b("div",{class:"group",role:"group","aria-label":"Views"},[["iso","Iso"],["front","Front"],["side","Side"],["top","Top"]].map(([c,u])=>b("button",{type:"button",text:u,on:{click:()=>Cm(c)}})),b("button",{type:"button",text:"Fit",on:{click:()=>Dc()}})),e=b("div",{class:"group frames",role:"group","aria-label":"Frames shown","data-testid":"frames"}),i=b("button",{type:"button",text:"Trace","aria-pressed":"true",on:{click:()=>{let c=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(c)),yv(c)}}}),s=b("button",{type:"button",text:"Clear","aria-label":"Clear the trace",on:{click:Wd}}),r=b("span",{class:"scale"}),o=b("div",{class:"key","aria-label":"Axes: x red, y green, z blue"},["x","y","z"].map((c,u)=>{let h=b("span",{class:"dot"});return h.style.setProperty("background",Mr[u]),b("span",{},h,c)}),r);n.append(b("div",{class:"corner top"},t,b("div",{class:"group",role:"group","aria-label":"Trace of the tool"},i,s),b("div",{class:"group",role:"group","aria-label":"The picture"},vS(n),b("button",{type:"button",text:"PNG","aria-label":"Save the picture","data-testid":"save-picture",on:{click:bS}}))),b("div",{class:"corner bottom"},o,e));let a=-2,l=()=>{let c=M.table.joints.length,u=Array.from({length:c+2},(d,f)=>f);M.shownFrames=(M.shownFrames??[0,c+1]).map(d=>d===a+1?c+1:d).filter(d=>d<c+2),a=c;let h=d=>{M.shownFrames=d,l()};Yt(e,b("span",{class:"group-name",text:"Frames"}),u.map(d=>b("button",{type:"button",text:Vd(d),"aria-pressed":String(M.shownFrames.includes(d)),"aria-label":`Frame ${Vd(d)}`,on:{click:()=>h(M.shownFrames.includes(d)?M.shownFrames.filter(f=>f!==d):[...M.shownFrames,d])}})),b("button",{type:"button",text:M.shownFrames.length===c+2?"none":"all","aria-label":"All frames or none",on:{click:()=>h(M.shownFrames.length===c+2?[]:u)}})),ft("frames"),yt(r,`grid ${Ee(Im.cell,"length",gt.length==="mm"?0:2)}`)};st(["table","units"],l),l()}function AS(){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.metaKey)||n.altKey)return;let t=n.key.toLowerCase();n.target.matches?.("input[type=text]:not(.number), textarea")||(t==="z"&&!n.shiftKey?(n.preventDefault(),n.target.blur?.(),ug()):(t==="y"||t==="z"&&n.shiftKey)&&(n.preventDefault(),n.target.blur?.(),hg()))})}var Kg=()=>M.frames[M.frames.length-1],CS={id:"pose",title:"Pose",build(n){let t=ol("Pose of the tool in the base frame","pose"),e=["X","Y","Z"].map(u=>RS(u,"length",`pose-${u.toLowerCase()}`)),i=b("div",{class:"quantities","data-testid":"orientation"}),s=b("p",{class:"hint order"}),r=[],o=Mn("Notation of the orientation",Object.entries(Ts).map(([u,h])=>[u,h.title]),M.notation,u=>{M.notation=u,ft("notation")}),a=b("span",{class:"copies"},b("button",{type:"button",class:"quiet",text:"Copy matrix",title:"As numbers in metres, row by row",on:{click:()=>kr(Sf(Kg()))}}),b("button",{type:"button",class:"quiet",text:"Copy numbers",title:"Position and orientation, in the units shown",on:{click:()=>kr(v3())}}));n.append(b("div",{class:"subhead"},b("span",{text:"Tool in the base frame"}),a),t,b("div",{class:"quantities"},e.map(u=>u.el)),b("div",{class:"line"},o,s),i);let l=()=>{let u=Ts[M.notation];o.value=M.notation,yt(s,u.order),r=u.names.map((h,d)=>RS(h,u.kinds[d],`turn-${d}`)),Yt(i,r.map(h=>h.el)),c()},c=()=>{let u=Kg();t.show(u),ne(u).forEach((h,d)=>e[d].show(h)),Ts[M.notation].to(u).forEach((h,d)=>r[d].show(h))};st("q",c),st("notation",l),st("units",()=>{e.forEach(u=>u.relabel()),r.forEach(u=>u.relabel()),c()}),l()}};function v3(){let n=Kg(),t=Ts[M.notation],e=ne(n).map((s,r)=>`${"XYZ"[r]} ${Gn(s,"length")} ${gt.symbol("length")}`),i=t.to(n).map((s,r)=>`${t.names[r]} ${t.kinds[r]==="angle"?`${Gn(s,"angle")} ${gt.symbol("angle")}`:Qn(s,5)}`);return`${e.join(", ")}; ${i.join(", ")} (${t.order})`.replaceAll("\u2212","-")}function RS(n,t,e){let i=b("output",{"data-testid":e}),s=b("span",{class:"unit",text:gt.symbol(t)});return{el:b("div",{class:"quantity"},b("span",{class:"quantity-name",text:n}),i,s),show:o=>yt(i,t==="plain"?Qn(o,5):Gn(o,t)),relabel:()=>yt(s,gt.symbol(t))}}function b3(n,t){let e=[],i=n.joints.length,s=ar(n,t),r=o=>n.convention==="standard"?n.joints[o].alpha:n.joints[o+1]?.alpha;for(let o=0;o<i-1;o++){let a=or(n.joints[o],s[o]).theta,l=1,c=`${o+1}`;for(let u=o;u<i-1;u++){let h=r(u);if(Math.abs(Math.sin(h))>1e-9||n.joints[u+1].type!=="R"||n.joints[o].type!=="R")break;l*=Math.sign(Math.cos(h)),a+=l*or(n.joints[u+1],s[u+1]).theta,c+=`${l>0?"":"\u2212"}${u+2}`,e.push({name:c,value:a})}}return e}var PS={id:"matrices",title:"Matrices",wide:!0,build(n){let t="links",e="now",i=0,s=0,r=[],o=b("div",{class:"cards","data-testid":"matrices"}),a=b("table",{class:"plain","data-testid":"angles","aria-label":"Intermediate angles"}),l=Mn("Posture",[["now","present posture"]],"now",g=>{e=g,d()}),c=b("span",{class:"partial"});n.append(b("div",{class:"line"},mn("Matrices shown",[["links","Each A"],["products","Products from the base"],["partial","Between two frames"]],t,g=>{t=g,h()},"matrix-mode"),c),b("div",{class:"line"},b("span",{class:"field-name",text:"Numbers of the"}),l),o,b("h3",{text:"Intermediate angles"}),b("p",{class:"hint",text:"Each \u03B8 with the maker\u2019s sign and zero put in, and the sums of neighbouring joints whose axes are parallel, as a derivation uses them."}),a);let u=()=>e!=="now"&&M.solutions?.rows[Number(e)]?.q||M.q,h=()=>{let g=M.table.joints.length;i=Math.min(i,g),s=s===0||s>g?g:s;let y=t==="links"?M.table.joints.map((m,x)=>["A",String(x+1),""]):t==="products"?M.table.joints.map((m,x)=>["T",String(x+1),"0"]):[["T",String(s),String(i)]];t==="links"&&y.push(["T","tool","base"]);let p=Array.from({length:g+1},(m,x)=>[String(x),String(x)]);Yt(c,t==="partial"?[Mn("From frame",p,String(i),m=>{i=Number(m),h()})," \u2192 ",Mn("To frame",p,String(s),m=>{s=Number(m),h()})]:[]),r=y.map(([m,x,E])=>({grid:ol(`${m} ${E} ${x}`,`matrix-${m}${E}${E?"-":""}${x}`),note:b("span",{class:"hint"}),sym:m,low:x,high:E})),Yt(o,r.map(({grid:m,note:x,sym:E,low:v,high:A})=>b("figure",{class:"card"},b("figcaption",{},b("span",{class:"symbol"},A?b("sup",{text:A}):null,b("i",{text:E}),b("sub",{text:v})),x),m))),d()},d=Br(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let g=u(),y=q0(M.table,g),p=y.length;r.forEach(({grid:E,note:v},A)=>{if(t==="links"&&A<p)E.show(y[A]),yt(v,`q${A+1} = ${Ee(g[A],Ye(M.table.joints[A]))}`);else if(t==="links")E.show(_s(M.table,g)[p+1]);else if(t==="products")E.show(y.slice(0,A+1).reduce(ei,rr()));else{let T=_=>y.slice(0,_).reduce(ei,rr());E.show(ei(ou(T(i)),T(s)))}});let m=ar(M.table,g),x=M.table.joints.map((E,v)=>[E.type==="R"?`\u03B8${v+1}`:`d${v+1}`,E.type==="R"?Gn(or(E,m[v]).theta,"angle"):Gn(or(E,m[v]).d,"length"),E.type==="R"?"angle":"length"]).concat(b3(M.table,g).map(({name:E,value:v})=>[`\u03B8${E}`,Gn(v,"angle"),"angle"]));Yt(a,b("tbody",{},x.map(([E,v,A])=>b("tr",{},b("th",{scope:"row"},b("i",{text:E[0]}),b("sub",{text:E.slice(1)})),b("td",{text:v}),b("td",{class:"unit",text:gt.symbol(A)})))))}),f=()=>{if(n.closest(".panel").hidden)return;let g=M.solutions?.rows??[];Yt(l,b("option",{value:"now",text:"present posture"}),g.map((y,p)=>b("option",{value:String(p),text:`solution ${p+1}: ${y.label??""}`}))),e!=="now"&&!g[Number(e)]&&(e="now"),l.value=e,d()};st("table",h),st(["q","units","panel"],d),st(["solutions","panel"],f),h()}};var S3=.002;function Ls(n,t,e,i){let s=[],r="",o=b("div",{class:"pose-fields"}),a=()=>{let c=Ts[M.notation],u=[["X","length"],["Y","length"],["Z","length"],...c.names.map((d,f)=>[d,c.kinds[f]])],h=()=>{let d=Dy(M.notation,s.slice(3).map(f=>f.value),s.slice(0,3).map(f=>f.value));d&&i(d,M3(s))};s=u.map(([d,f],g)=>{let y={value:0,kind:f},p=(m,x)=>{y.value=m,y.text=x.text,h()};return y.f=Fn({label:`${n}, ${d}`,kind:f,testid:`${t}-${g}`,input:p,commit:(m,x)=>{p(m,x),ft("let-go")}}),y.el=b("label",{class:"pose-field"},b("span",{text:d}),y.f,b("span",{class:"unit",text:gt.symbol(f)})),y}),Yt(o,s.map(d=>d.el)),r=M.notation},l=()=>{r!==M.notation&&a();let c=e();!c||o.contains(document.activeElement)||[...ne(c),...Ts[M.notation].to(c)].forEach((u,h)=>{s[h].value=u,s[h].text=null,s[h].f.put(u,w3(u,s[h].kind))})};return st("units",()=>{a(),l()}),st("notation",l),a(),l(),o.addEventListener("paste",c=>{let u=xf(c.clipboardData.getData("text"))?.flat(),h=s.findIndex(d=>d.f===c.target);!u||h<0||(c.preventDefault(),yf([s.map(d=>d.f)],0,u.length===s.length?0:h,[u]))}),o.addEventListener("focusout",()=>{setTimeout(l)}),{el:b("fieldset",{class:"pose-editor"},b("legend",{text:n}),o),show:l}}function M3(n){let t=s=>s.map(r=>r.text??""),e=n.slice(3).filter(s=>s.kind==="angle"),i=e.length>1?Wa(t(e),"angle"):2*Wa(t(n.slice(3)),"plain");return{metres:Wa(t(n.slice(0,3)),"length"),radians:i}}var w3=(n,t)=>String(Number((n*gt.factor(t)).toFixed(t==="plain"||gt[t]==="m"||gt[t]==="rad"?6:3))+0);function IS(n){let t=n.match(LS)??[],e=t.filter((s,r)=>r%4===3&&r<12),i=t.filter((s,r)=>r%4!==3&&r<12);return{metres:Wa(e,"length"),radians:2*Wa(i,"plain")}}var LS=/[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;function DS(n){let t=(n.replaceAll("\u2212","-").match(LS)??[]).map(Number);if(t.length!==16&&t.length!==12)throw new Error(`${t.length===1?"1 number was":`${t.length} numbers were`} found; a pose has 16 (four rows) or 12 (three rows)`);let e=t.length===16?t:[...t,0,0,0,1];if(Math.abs(e[12])+Math.abs(e[13])+Math.abs(e[14])+Math.abs(e[15]-1)>1e-9)throw new Error("the last row must be 0 0 0 1");if(!e.every(Number.isFinite))throw new Error("a number is not finite");let i=lu(e);if(i>S3)throw new Error(i===1/0?"the upper left block is left-handed, so it is no rotation":`the upper left block is no rotation: its rows miss being perpendicular unit vectors by ${i.toPrecision(2)}`);for(let s of[3,7,11])e[s]/=gt.factor("length");return cu(e)}function Mf(n){return n.map((t,e)=>{let i=M.table.joints[e];if(i.type!=="R")return t;let s=t+2*Math.PI*Math.round((M.q[e]-t)/(2*Math.PI));return(i.lower===null||s>=i.lower-1e-9)&&(i.upper===null||s<=i.upper+1e-9)?s:t})}function NS(n,t){let e=t?.self_motions??[],i=ue.task??M.plan?.task,s=i==="pose";n.classList.toggle("stale",t?.self_motions===null);for(let d of n.querySelectorAll("input"))d.disabled=t?.self_motions===null;if(t?.self_motions===null&&n.childElementCount)return;let r=t?.self_motions===null?"pending":t?.self_motions;if(n.drawn===r)return;if(n.drawn=r,r==="pending"){Yt(n,b("p",{class:"hint",text:"Following the self-motions of this pose \u2026"}));return}let o=i==="position"?"the tool point stands still":i==="pose"?"the tool stands still":"the tool point and its axis stand still",a=d=>d.dimension>1?`one line in a surface of ${d.dimension} dimensions`:d.closed?"a closed curve":"an open curve",l=(d,f)=>{let g=d.moves.length>3?"most of its joints":d.moves.join(" and "),y=d.inside.length?R3(d):"All of it lies outside the limits.";return b("div",{class:"self-motion"},b("p",{},b("strong",{text:e.length>1?`Self-motion ${f+1} of ${e.length}`:"Self-motion"}),` by ${g}, ${a(d)}: the arm moves, ${o}. ${y}`),P3(d,f,t.T,s))},c=e.length?T3(e):-1,u=e.map((d,f)=>f===c?null:l(d,f)).filter(Boolean),h=u.length?b("details",{class:"fold"},b("summary",{text:u.length===1?"One other self-motion":`${u.length} other self-motions`}),u):null;Yt(n,c>=0?l(e[c],c):null,h)}var E3=n=>n.reduce((t,e,i)=>t+Math.sin((e-M.q[i])/2)**2,0),T3=n=>{let t=n.map(e=>Math.min(...e.q.map(E3)));return t.indexOf(Math.min(...t))};function A3(n){let t=(s,r)=>s.map((o,a)=>M.table.joints[a]?.type==="P"?o-r[a]:Math.atan2(Math.sin(o-r[a]),Math.cos(o-r[a]))),e=n.s[0],i=1/0;for(let s=0;s+1<n.q.length;s++){let r=t(n.q[s+1],n.q[s]),o=t(M.q,n.q[s]),a=r.reduce((u,h)=>u+h*h,0),l=a>0?Math.min(Math.max(r.reduce((u,h,d)=>u+h*o[d],0)/a,0),1):0,c=r.reduce((u,h,d)=>u+(o[d]-l*h)**2,0);c<i&&([i,e]=[c,n.s[s]+l*(n.s[s+1]-n.s[s])])}return e}var R3=({inside:n})=>n.length===1&&n[0][0]<=1e-9&&n[0][1]>=1-1e-9?"":`Inside the limits: ${n.map(([t,e])=>`${(100*t).toFixed(1)} to ${(100*e).toFixed(1)} %`).join(", ")} of it.`;function C3(n){let t=[],e=0;for(let[i,s]of n)t.push(`var(--wrong-soft) ${100*e}% ${100*i}%`,`var(--good) ${100*i}% ${100*s}%`),e=s;return t.push(`var(--wrong-soft) ${100*e}% 100%`),`linear-gradient(to right, ${t.join(", ")})`}function P3(n,t,e,i){let s=b("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":`Along self-motion ${t+1}`,"data-testid":`self-motion-${t+1}`}),r=()=>{ui();let o=Number(s.value),a=Math.max(n.s.findLastIndex(h=>h<=o),0),l=Math.min(a+1,n.q.length-1),c=l>a?(o-n.s[a])/(n.s[l]-n.s[a]):0;s.style.setProperty("--at",`${100*o}%`);let u=n.q[a].map((h,d)=>h+c*(n.q[l][d]-h));ft("did",{label:"slide along a self-motion",key:"self-motion"}),Ii(Mf(i?X0(M.table,u,e):u),"self-motion")};return s.value=String(A3(n)),s.style.setProperty("--at",`${100*Number(s.value)}%`),s.classList.add("parts"),s.style.setProperty("--parts",C3(n.inside)),s.dataset.inside=JSON.stringify(n.inside),s.addEventListener("input",r),s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[o.key];if(!a)return;o.preventDefault();let l=Number(s.value)+a/100;s.value=String(n.closed?l-Math.floor(l):Math.min(Math.max(l,0),1)),r()}),s}function US(){let n=[],t=[],e={},i=b("div",{class:"joints"}),s=b("details",{},b("summary",{class:"hint",text:"Hold by value"}),i),r=b("p",{class:"hint"}),o=mn("Redundant coordinates",[["free","Free"],["chosen","Chosen"]],"free",f=>l(f==="chosen"?n.filter(g=>!g.instead).map(g=>g.name):null),"spare-mode"),a=b("div",{class:"spare",role:"group","aria-label":"Redundant coordinates of the arm","data-testid":"spare",hidden:!0},b("div",{class:"line spread"},b("span",{class:"field-name",text:"Redundant coordinates"}),o),r,s);function l(f,{sliding:g=!1}={}){ft("did",{label:f?`hold ${f.join(" and ")}`:"free the redundant coordinates",key:"spare"}),ue.redundancy=f&&Object.fromEntries(f.map(y=>[y,e[y]])),d(),g?Sv():As({follow:!0})}let c=f=>n.filter(g=>g.instead===f.instead).map(g=>g.name),u=f=>M.table.joints.findIndex(g=>g.name===f.name);function h(f,g){let y=f.kind==="angle"?Math.PI:oi(M.table),p=f.lower??-y,m=f.upper??y,x=b("input",{type:"range",min:String(p),max:String(m),step:"any","aria-label":`Slide ${f.name}`,"data-testid":`spare-slider-${g+1}`}),E=!1,v=(S,L)=>{e[f.name]=S,l(c(f),{sliding:L})};x.addEventListener("input",()=>v(Number(x.value),!0)),x.addEventListener("change",()=>As({follow:!0})),x.addEventListener("keydown",S=>{let L={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[S.key];if(L===void 0)return;S.preventDefault(),E=!0;let I=L*gt.step(f.kind)*(S.shiftKey?.1:1);v(Math.min(Math.max(e[f.name]+I,p),m),!0)}),x.addEventListener("keyup",()=>{E&&As({follow:!0}),E=!1});let A=Fn({label:`Value of ${f.name}`,kind:f.kind,testid:`spare-${g+1}`,check:S=>S<p-1e-9&&f.lower!==null?`below the limit ${Ee(p,f.kind)}`:S>m+1e-9&&f.upper!==null?`above the limit ${Ee(m,f.kind)}`:null,commit:S=>v(S,!1)}),T=b("span",{class:"limits"}),_=b("div",{class:"joint"},b("span",{class:"joint-name",text:f.name}),b("div",{class:"track"},x,b("div",{class:"under"},T)),A,b("span",{class:"unit"}));return{line:_,show(){let S=e[f.name];x.value=S,x.style.setProperty("--at",`${100*(Math.min(Math.max(S,p),m)-p)/(m-p||1)}%`),x.setAttribute("aria-valuetext",Ee(S,f.kind)),_.classList.toggle("held",!!(ue.redundancy&&f.name in ue.redundancy)),A.put(Number((S*gt.factor(f.kind)).toFixed(gt.digits(f.kind)+1))/gt.factor(f.kind))},relabel(){yt(_.lastChild,gt.symbol(f.kind));let S=L=>L===null?"no limit":Ee(L,f.kind,f.kind==="angle"&&gt.angle==="deg"?0:void 0);yt(T,f.lower===null&&f.upper===null?"no limits":`${S(f.lower)} \u2026 ${S(f.upper)}`),A.refresh()}}}function d(){for(let f of n)ue.redundancy&&f.name in ue.redundancy?e[f.name]=ue.redundancy[f.name]:u(f)>=0?e[f.name]=M.q[u(f)]:f.instead&&Number.isFinite(M.solutions?.arm_angle)?e[f.name]=M.solutions.arm_angle:e[f.name]??=0;o.mark(ue.redundancy?"chosen":"free"),yt(r,ue.redundancy?"Held at these values; what is left has separate solutions.":"Free: the solutions form self-motions; the table has those at the present values.");for(let f of t)f.show()}return st("solutions",()=>{let f=M.solutions?.spare;if(!M.solutions||!f&&(M.solutions.brief||M.solutions.status==="REFUSED"))return;let g=JSON.stringify(f??[])!==JSON.stringify(n);if(g){n=f??[],e={},t=n.map(h),Yt(i,t.map(y=>y.line));for(let y of t)y.relabel()}a.hidden=n.length===0,g&&(s.open=n.filter(y=>!y.instead).length>1||!!ue.redundancy),d()}),st("q",()=>!a.hidden&&!a.closest("[hidden]")&&!ue.redundancy&&d()),st("units",()=>{for(let f of t)f.relabel();d()}),a}function FS(){let n=b("thead"),t=b("tbody"),e=b("p",{class:"hint below",text:"Grey rows lie outside the limits; the joints in red exceed them."}),i=b("div",{class:"scroll"},b("table",{class:"plain solutions","data-testid":"solutions","aria-label":"Solutions"},n,t),e),s=[],r="",o=()=>{let l=`${M.table.joints.map(c=>c.type).join("")}${gt.angle}${gt.length}`;l!==r&&(r=l,s=[],Yt(t),Yt(n,b("tr",{},b("th",{text:""}),b("th",{class:"left",text:"posture"}),M.table.joints.map((c,u)=>b("th",{},b("i",{text:"q"}),b("sub",{text:String(u+1)}),b("span",{class:"unit",text:` ${gt.symbol(Ye(c))}`}))),b("th",{text:"off, mm",title:"By how much forward kinematics misses the pose"}))))},a=l=>{let c=M.table.joints.map(()=>b("td")),u=b("span"),h=b("span",{class:"offscreen"}),d=b("td",{class:"unit"}),f=b("tr",{tabindex:"0","data-testid":`solution-${l+1}`},b("th",{scope:"row",text:String(l+1)}),b("td",{class:"left"},u,h),c,d),g=()=>M.solutions?.rows[l]?.q,y=()=>g()&&Xa(g()),p=()=>Xa(null),m=()=>{g()&&(Xa(null),Ai(Mf(g()),.8,`move to solution ${l+1}`))};return f.addEventListener("pointerenter",y),f.addEventListener("pointerleave",p),f.addEventListener("focus",y),f.addEventListener("blur",p),f.addEventListener("click",m),f.addEventListener("keydown",x=>{(x.key==="Enter"||x.key===" ")&&(x.preventDefault(),m())}),{tr:f,cells:c,label:u,beyond:h,residual:d}};return{el:i,show(l){o();let c=l?.rows??[];for(;s.length<c.length;){let u=a(s.length);s.push(u),t.append(u.tr)}i.hidden=c.length===0,e.hidden=c.every(u=>u.inside),s.forEach((u,h)=>{let d=c[h];u.tr.hidden=!d,d&&(u.tr.classList.toggle("beyond",!d.inside),d.label!==null&&yt(u.label,`${d.label}${d.self_motion>=0?" (of a self-motion)":""}`),yt(u.beyond,d.inside?"":", outside the limits"),yt(u.residual,d.residual?Rd(d.residual[0]*1e3):""),u.residual.title=d.residual?`${Rd(d.residual[0])} m, ${Rd(d.residual[1])} rad by forward kinematics`:"",d.q.forEach((f,g)=>{let y=M.table.joints[g],p=y.lower!==null&&f<y.lower-1e-9||y.upper!==null&&f>y.upper+1e-9;yt(u.cells[g],Gn(f,Ye(y))),u.cells[g].classList.toggle("out",p)}))}),this.mark()},mark(){let l=M.solutions?.rows??[];s.forEach((c,u)=>c.tr.classList.toggle("here",!!l[u]&&l[u].q.length===M.q.length&&l[u].q.every((h,d)=>Math.abs(Math.sin((h-M.q[d])/2))<1e-5)))}}}var I3={SOLVED:"good",SINGULAR:"note",REDUNDANT:"note",OUT_OF_REACH:"wrong",OUTSIDE_LIMITS:"wrong",UNCERTAIN:"wrong",REFUSED:"wrong"},Qg={OUT_OF_REACH:"Out of reach",OUTSIDE_LIMITS:"Outside the limits",UNCERTAIN:"Not certain",REFUSED:"Refused"},L3=new Set(["REDUNDANT","UNCERTAIN"]),D3=(n,t)=>`Listed ${n===1?"is 1 posture":`are ${n} postures`}${t===n?"":`, ${t} inside the limits`}.`,t0=120;function e0(){xi(M.frames[M.frames.length-1].slice(),"taken")}var BS={id:"inverse",title:"Inverse",wide:!0,build(n,t){n.append(b("div",{class:"line spread"},b("button",{type:"button",text:"Take the present pose","data-testid":"take-pose",on:{click:e0}}),mn("Target as",[["numbers","Position and angles"],["matrix","Matrix"]],"numbers",y=>{i.hidden=y!=="numbers",s.hidden=y!=="matrix"},"target-as")));let e=Ls("Target","target",()=>M.target,(y,p)=>xi(y,"typed",p)),i=b("div",{},e.el),{el:s,show:r}=U3();n.append(i,s,F3());let o=b("p",{class:"verdict","data-testid":"ik-verdict",role:"status"}),a=b("div",{class:"near","data-testid":"ik-nearest"}),l=b("div",{class:"self-motions","data-testid":"self-motions"}),c=FS();n.append(US(),o,a,l,c.el);let u=ta(t0,()=>{e.show(),r()}),h=ta(t0,()=>{if(t.hidden)return;let y=M.solutions;O3(o,y),z3(a,y),NS(l,y),c.show(y)}),d=ta(t0,()=>c.mark()),f=y=>()=>Ud()?y.soon():y();st("target",f(u)),st("notation",e.show),st(["solutions","units"],f(h)),st("q",f(d));let g=()=>Tr("target",M.panel==="inverse"?N3(ne(M.target)):[]);st("target",y=>y!=="drag"&&g()),st("panel",y=>{Jy(y==="inverse"),(y!=="inverse"||M.hasTarget)&&g(),y==="inverse"&&(M.hasTarget?ft("solutions"):(M.hasTarget=!0,e0()))}),st("table",y=>{y==="new"&&(M.hasTarget=M.panel==="inverse",M.hasTarget&&e0())})}};function N3(n){let t=.25*oi(M.table);return[0,1,2].flatMap(e=>[t,-t].map(i=>n.map((s,r)=>r===e?s+i:s)))}function U3(){let n=b("textarea",{rows:"4","aria-label":"Target as a matrix","data-testid":"target-matrix",spellcheck:"false"}),t=b("p",{class:"reason",role:"alert"}),e=b("p",{class:"hint"});n.addEventListener("input",()=>{try{xi(DS(n.value),"typed",IS(n.value)),yt(t,""),n.removeAttribute("aria-invalid")}catch(s){yt(t,s.message),n.setAttribute("aria-invalid","true")}});let i=()=>{if(yt(e,`Twelve or sixteen numbers, row by row; the last column in ${gt.length}.`),document.activeElement===n)return;let s=M.target.map((r,o)=>o%4===3&&o<12?r*gt.factor("length"):r);n.value=Sf(s.map(r=>Number(r.toFixed(6)))).replaceAll(`,
`,`
`)};return st("units",i),i(),{el:b("div",{hidden:!0},n,e,t),show:i}}function F3(){let n=b("span",{class:"line"}),t=b("input",{type:"checkbox",checked:!0,"data-testid":"follow",on:{change:()=>{ue.follow=t.checked}}}),e=mn("Ghosts",[["all","All"],["inside","In limits"],["none","None"]],"all",i=>{ue.ghosts=i,Ya()});return st("task",()=>{t.checked=ue.follow,e.mark(ue.ghosts)}),st("plan",()=>Yt(n,M.plan?.solvable?[b("span",{class:"field-name",text:"Task"}),Mn("Task",[["",`${M.plan.task} (default)`],["pose","pose"],["position","position"],["position+axis","position + axis"]],ue.task??"",i=>{ft("did",{label:"choose the task"}),ue.task=i||null,ue.redundancy=null,As()},{"data-testid":"task"})]:[])),b("div",{class:"line controls"},b("span",{class:"line"},b("span",{class:"field-name",text:"Handles"}),mn("Handles",[["both","Both"],["move","Move"],["turn","Turn"]],"both",Ky)),mn("Axes of the handles",[["local","Tool"],["world","World"]],"local",Qy),b("span",{class:"line"},b("span",{class:"field-name",text:"Snap"}),Mn("Snap to whole steps",[["0","off"],["1","1 mm, 1\xB0"],["5","5 mm, 5\xB0"],["10","10 mm, 10\xB0"],["45","45 mm, 45\xB0"]],"0",i=>tv(Number(i)),{"data-testid":"snap",title:"While dragging; Shift snaps to 5 at any time"})),b("span",{class:"line"},b("span",{class:"field-name",text:"Ghosts"}),e),b("label",{class:"check"},t,"Arm follows"),n)}function O3(n,t){if(!t){Yt(n,b("span",{text:"Solving \u2026"})),n.dataset.tone="note";return}let e=t.rows.length,i=t.rows.filter(o=>o.inside).length;n.dataset.tone=I3[t.status]??"note";let s=t.status==="SOLVED"&&e?OS(t.missed):[t.why,t.status==="SINGULAR"?D3(e,i):"",OS(t.missed)].filter(Boolean).join(" "),r=Qg[t.status]&&!i?t.why.toLowerCase().includes(Qg[t.status].toLowerCase())?"":Qg[t.status]:t.status==="SINGULAR"||L3.has(t.status)&&i===e?"":`${e} solution${e===1?"":"s"}${i===e?"":`, ${i} inside the limits`}`;Yt(n,b("strong",{text:r})," ",b("span",{text:s}),t.ms===void 0?null:b("span",{class:"hint took",text:`${t.ms<1?`${Math.round(t.ms*1e3)} \xB5s`:`${t.ms.toFixed(1)} ms`}`}))}var OS=n=>n?`The pose was rounded by ${k3(n)||"less than its digits"} when typed; solved is the nearest one that the arm takes.`:"",B3=(n,t)=>Ee(n,t,gt.digits(t)+2),k3=n=>[[n.metres,"length"],[n.radians,"angle"]].filter(([t,e])=>t*gt.factor(e)>=.5*10**-(gt.digits(e)+2)).map(([t,e])=>B3(t,e)).join(" and ");function z3(n,t){let e=t?.near;if(!e){Yt(n);return}let i=ne(e.T).map(s=>Gn(s,"length")).join(", ");Yt(n,b("p",{},b("strong",{text:"Nearest reachable: "}),`${i} ${gt.symbol("length")}, ${Ee(e.metres,"length")} away`,e.radians>.001?`, turned by ${Ee(e.radians,"angle")}`:""),b("div",{class:"line"},b("button",{type:"button",text:"Go there",on:{click:()=>Ai(e.q)}}),b("button",{type:"button",text:"Make it the target",on:{click:()=>xi(e.T,"chosen")}})))}var n0=(n,t)=>{let e=Math.cos(t),i=Math.sin(t);return[1,0,0,n,0,e,-i,0,0,i,e,0,0,0,0,1]};function wf(n){return n0(n[3],Math.atan2(n[9],n[5])).every((e,i)=>Math.abs(e-n[i])<1e-12)?{a:n[3],alpha:Math.atan2(n[9],n[5])+0}:null}function Ef(n,t){if(n.convention===t||!n.joints.length)return{...n,convention:t};let e=n.joints,i=e.length,s=e.map(({a:l,alpha:c,text:u})=>({a:l,alpha:c,text:u})),{base:r,tool:o}=n,a;if(t==="modified"){let l=wf(r)??{a:0,alpha:0};wf(r)&&(r=rr()),o=ei(n0(s[i-1].a,s[i-1].alpha),o),a=[l,...s.slice(0,-1)]}else{let l=wf(o)??{a:0,alpha:0};wf(o)&&(o=rr()),r=ei(r,n0(s[0].a,s[0].alpha)),a=[...s.slice(1),l]}return{...n,convention:t,base:r,tool:o,joints:e.map((l,c)=>({...l,a:a[c].a,alpha:a[c].alpha,text:{...l.text,a:a[c].text?.a,alpha:a[c].text?.alpha}}))}}var kS=30,H3=n=>({name:`joint_${n+1}`,type:"R",a:0,alpha:0,d:0,theta:0,lower:null,upper:null,sign:1,offset:0}),G3={a:"a",alpha:"\u03B1",d:"d",theta:"\u03B8",lower:"lower limit",upper:"upper limit",offset:"zero"},al=null;function zS(n,t){al={label:n,key:"paste",open:!0};try{t(al)}finally{al=null,ft("let-go")}}function Tf(n,t,e,{symbolic:i,text:s},r){let o=M.table.joints.map((u,h)=>h!==n?u:{...u,[t]:e,text:{...u.text,[t]:i?s:void 0}}),a=Object.is(M.table.joints[n][t],e)&&M.table.joints[n].text?.[t]===o[n].text[t],c={what:"cell",label:`edit ${G3[t]??t} of joint ${n+1}`,key:`${n}/${t}`,open:!0};a||hn({...M.table,joints:o},al?{...c,...al}:c),r&&!al&&ft("let-go")}function ll(n,t,e,{key:i,open:s}={}){let{postures:r,coupling:o}=M.table,a=Object.fromEntries(Object.entries(r??{}).map(([u,h])=>[u,t(h,0)])),l=t(M.q,0),c=o?t(o,null).map((u,h)=>V3(u&&t(u,0),h,n.length)):null;hn({...M.table,joints:n,postures:a,coupling:c},{q:l,what:"rows",label:e,key:i,open:s})}var V3=(n,t,e)=>n??Array.from({length:e},(i,s)=>+(s===t));function HS(n,t,e){let i=M.table.joints[n];return e===null?null:t==="lower"&&i.upper!==null&&e>i.upper?"above the upper limit":t==="upper"&&i.lower!==null&&e<i.lower?"below the lower limit":null}function i0({label:n,key:t,open:e}={}){let i=M.table.joints.length;return i>=kS?(Xe(`At most ${kS} joints.`,"wrong"),!1):(ll([...M.table.joints,H3(i)],(s,r)=>[...s,r],n??`add joint ${i+1}`,{key:t,open:e}),document.querySelector(`[data-testid="dh-${i+1}-a"]`)?.focus(),!0)}function s0(n,t){let e=i=>{let s=i.slice();return[s[n],s[t]]=[s[t],s[n]],s};ll(e(M.table.joints),e,`swap joints ${n+1} and ${t+1}`)}async function Af(){try{yi(`${M.table.name||"arm"}.toml`,(await dn("save",{})).text,"application/toml")}catch(n){Xe(n.message,"wrong")}}async function GS(n){let t=n.files[0];if(n.value="",!!t){if(t.size>2e5){Xe(`${t.name} has ${t.size} bytes; a robot file has at most 200,000.`,"wrong");return}try{let{table:e}=await Vi("open",{name:t.name.slice(-80),text:await t.text()});hn(e,{q:Qo(e),what:"new",label:`open ${t.name.slice(-40)}`})}catch(e){Xe(e.message,"wrong")}}}var r0={geometry:[["a","a","length"],["alpha","\u03B1","angle"],["d","d","length"],["theta","\u03B8","angle"]],joint:[["lower","lower limit",null],["upper","upper limit",null],["offset","zero",null]]},W3=({catalog:n,...t})=>n?{...t,derived:n}:t,q3=n=>n.type==="R"?"angle":"length",VS={id:"table",title:"DH table",wide:!0,build(n){let t="geometry",e=[],i=b("thead"),s=b("tbody"),r=b("table",{class:"dh","data-testid":"dh-table","aria-label":"DH table"},i,s),o=b("p",{class:"reason",role:"alert","data-testid":"dh-wrong"}),a=b("p",{class:"verdict","data-testid":"arm-kind"}),l=mn("Convention",[["standard","Standard"],["modified","Modified (Craig)"]],M.table.convention,E=>{E!==M.table.convention&&hn(Ef(M.table,E),{what:"rows",label:`make the table ${E}`})},"convention"),c=b("p",{class:"hint order"}),u=b("input",{type:"text","aria-label":"Name of the arm","data-testid":"arm-name",maxlength:"60",on:{change:()=>hn({...W3(M.table),name:u.value||"my-arm"},{what:"name",label:"name the arm"})}}),h=b("input",{type:"file",accept:".toml,.urdf,.xml",class:"offscreen","aria-label":"Robot file","data-testid":"robot-file",tabindex:"-1",on:{change:()=>GS(h)}}),d=Ls("Base","base",()=>M.table.base,E=>hn({...M.table,base:E},{what:"cell",label:"edit the base",key:"base",open:!0})),f=Ls("Tool","tool",()=>M.table.tool,E=>hn({...M.table,tool:E},{what:"cell",label:"edit the tool",key:"tool",open:!0}));n.append(b("div",{class:"line spread"},b("span",{class:"line"},u),b("span",{class:"line"},b("button",{type:"button",text:"Blank",title:"An empty table",on:{click:()=>hn(Y0(M.table.convention),{q:[],what:"new",label:"begin a blank table"})}}),b("button",{type:"button",text:"Open\u2026",title:"A robot file (.toml) or a URDF",on:{click:()=>h.click()}}),h,b("button",{type:"button",text:"Save",title:"As a robot file",on:{click:Af}}))),b("div",{class:"line spread"},l,mn("Columns",[["geometry","Geometry"],["joint","Limits and zeros"]],t,E=>{t=E,m()},"dh-part")),c,r,b("div",{class:"line"},b("button",{type:"button",class:"add",text:"+ Add joint","data-testid":"add-joint",on:{click:()=>i0()}}),b("span",{class:"hint",text:"Numbers or expressions: pi/2, 90 deg, 0.5 m, 125+85. With pi, an angle is in radians. Arrows and Enter go from cell to cell, Alt and an arrow steps; a table can be pasted."})),o,a,Ly(),b("details",{class:"fold","data-testid":"base-tool"},b("summary",{text:"Base and tool"}),d.el,f.el)),s.addEventListener("paste",E=>{let v=xf(E.clipboardData.getData("text")),A=()=>[...s.rows].map(S=>[...S.querySelectorAll("input.number")]);if(!v||!E.target.matches("input.number"))return;E.preventDefault();let T=A().findIndex(S=>S.includes(E.target)),_=A()[T].indexOf(E.target);zS("paste a table",S=>{for(;M.table.joints.length<T+v.length&&i0(S););let L=yf(A(),T,_,v),I=v.flat().length;Xe(`Pasted ${L} number${L===1?"":"s"}${L<I?`; ${I-L} had no cell`:""}`)})}),n.addEventListener("verdict",E=>{let v=E.detail??$3(n);yt(o,v?`${v.label}: ${v.reason}. The arm stays as it was.`:"")});let g=(E,v,[A,T,_])=>{let S=E.type==="R"&&A==="theta"||E.type==="P"&&A==="d",L=A==="lower"||A==="upper",I=Fn({label:`Joint ${v+1}, ${T}`,kind:_??q3(E),testid:`dh-${v+1}-${A}`,empty:L?null:void 0,check:D=>L?HS(v,A,D):D!==null&&Math.abs(D)>1e6?"larger than a million":null,input:(D,B)=>Tf(v,A,D,B,!1),commit:(D,B)=>Tf(v,A,D,B,!0)});return L&&(I.placeholder="none"),e.push({f:I,i:v,key:A}),b("td",{class:S?"variable":""},S?b("span",{class:"plus"},b("i",{text:"q"}),b("sub",{text:String(v+1)})," +"):null,I)},y=(E,v)=>b("button",{type:"button",class:`type type-${E.type}`,text:E.type,"data-testid":`dh-${v+1}-type`,"aria-label":`Joint ${v+1} is ${E.type==="R"?"revolute":"prismatic"}; press to change`,title:E.type==="R"?"Revolute: turns. Press for prismatic.":"Prismatic: slides. Press for revolute.",on:{click:()=>ll(M.table.joints.map((A,T)=>T===v?{...A,type:A.type==="R"?"P":"R",lower:null,upper:null,offset:0,text:{...A.text,lower:void 0,upper:void 0,offset:void 0}}:A),A=>A.map((T,_)=>_===v&&typeof T=="number"?0:T),`make joint ${v+1} ${E.type==="R"?"prismatic":"revolute"}`)}}),p=(E,v)=>b("td",{class:"tools"},b("button",{type:"button",class:"icon",text:"\u2191","aria-label":`Move joint ${E+1} up`,disabled:E===0,on:{click:()=>s0(E,E-1)}}),b("button",{type:"button",class:"icon",text:"\u2193","aria-label":`Move joint ${E+1} down`,disabled:E===v-1,on:{click:()=>s0(E,E+1)}}),b("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove joint ${E+1}`,on:{click:()=>ll(M.table.joints.filter((A,T)=>T!==E),A=>A.filter((T,_)=>_!==E),`remove joint ${E+1}`)}})),m=()=>{e=[];let{joints:E}=M.table,v=M.table.convention==="modified",A=t==="geometry"?r0.geometry.map(([T,_,S])=>b("th",{scope:"col"},b("i",{text:_}),b("sub",{text:v&&(T==="a"||T==="alpha")?"i\u22121":"i"}),b("span",{class:"unit",text:` ${gt.symbol(S)}`}))):["name","lower limit","upper limit","zero","sense"].map(T=>b("th",{scope:"col",text:T}));Yt(i,b("tr",{},b("th",{scope:"col",text:"i"}),b("th",{scope:"col","aria-label":"type"}),A,b("th",{"aria-label":"row tools"}))),Yt(s,E.map((T,_)=>{let S=t==="geometry"?r0.geometry.map(L=>g(T,_,L)):[b("td",{},b("input",{type:"text",class:"name",value:T.name,maxlength:"40","aria-label":`Joint ${_+1}, name`,on:{change:L=>Tf(_,"name",L.target.value||`joint_${_+1}`,{},!0)}})),...r0.joint.map(L=>g(T,_,L)),b("td",{},b("button",{type:"button",class:"type",text:T.sign>0?"+":"\u2212","aria-label":`Joint ${_+1}, sense of the maker: ${T.sign>0?"as the table":"against the table"}`,on:{click:()=>ll(M.table.joints.map((L,I)=>I===_?{...L,sign:-L.sign}:L),L=>L,`turn the sense of joint ${_+1}`)}}))];return b("tr",{"data-testid":`dh-row-${_+1}`},b("th",{scope:"row",text:String(_+1)}),b("td",{},y(T,_)),S,p(_,E.length))})),E.length||s.append(b("tr",{},b("td",{colspan:"7",class:"hint",text:"No joints yet."}))),x()},x=()=>{for(let{f:E,i:v,key:A}of e){let T=M.table.joints[v];E.put(T[A],T.text?.[A]??null)}l.mark(M.table.convention),yt(c,M.table.convention==="standard"?"A\u1D62 = Rz(\u03B8) Tz(d) Tx(a) Rx(\u03B1)":"A\u1D62 = Rx(\u03B1) Tx(a) Rz(\u03B8) Tz(d), each row with the a and \u03B1 before its joint"),document.activeElement!==u&&(u.value=M.table.name),d.show(),f.show()};st("table",E=>{yt(o,""),E==="cell"||E==="name"||E==="postures"?x():m()}),st("units",m),st("notation",()=>{d.show(),f.show()}),st("plan",()=>{a.dataset.tone=M.plan?.solvable?"good":"wrong",Yt(a,b("strong",{text:fu(M.plan)||(M.plan?.refused?"Refused":"Not solved")})," ",b("span",{text:M.plan?.explain??""}))}),m()}};function $3(n){let t=n.querySelector(".number.wrong");return t?{label:t.getAttribute("aria-label"),reason:t.title}:null}var X3=4,Y3=n=>{let t=n.toFixed(X3);return Number(t)<0?`(${t})`:t.replace("-","")};function Rf(n,t,e){let i=ar(t,e),s=t.joints.map((c,u)=>or(c,i[u])),r=c=>c.reduce((u,[h,d])=>u+d*s[h-1].theta,0),o={cos:c=>Math.cos(r(c)),sin:c=>Math.sin(r(c)),slide:([[c]])=>s[c-1].d};return n.symbols.reduce((c,u)=>c.replaceAll(u.latex,Y3(o[u.is](u.joints))),n.latex).replaceAll("\\left(","(").replaceAll("\\right)",")").replace(/(\d|\))\s+(?=\d|\()/g,"$1 \\cdot ")}var Cf=null;async function Z3(){return Cf??=(await import("./katex-OJEVB6AI.js")).default,Cf}function j3(n,t){let e=b("span");try{n.render(t.latex,e,{throwOnError:!0,strict:!1,trust:!1})}catch{e.textContent=t.text}return e}function WS(n,t){let e=[[i=>typeof i=="string",i=>i],[i=>"latex"in i,i=>j3(n,i)],[i=>"code"in i,i=>b("code",{text:i.code})],[()=>!0,i=>b("em",{text:i.emphasis})]];return t.map(i=>e.find(([s])=>s(i))[1](i))}var J3=n=>n.map(t=>typeof t=="string"?t:t.latex?`$${t.latex}$`:t.code??t.emphasis).join("");function K3(n){let t=M.table.joints.map((e,i)=>b("th",{},b("i",{text:"q"}),b("sub",{text:String(i+1)}),b("span",{class:"unit",text:` ${gt.symbol(Ye(e))}`})));return[b("h3",{text:"The formulas at the present pose"}),b("table",{class:"plain","data-testid":"formula-values","aria-label":"Branches of the formulas at the present pose"},b("thead",{},b("tr",{},b("th",{text:"branch"}),t)),b("tbody",{},n.map((e,i)=>b("tr",{},b("th",{scope:"row",text:String(i+1)}),e.map((s,r)=>b("td",{text:Gn(s,Ye(M.table.joints[r]))}))))))]}var qS={id:"equations",title:"Equations",wide:!0,build(n,t){let e="forward",i="symbols",s=null,r=[],o=[],a=b("p",{class:"hint",role:"status","data-testid":"equations-note"}),l=b("div",{class:"equations","data-testid":"equations"}),c=mn("Written with",[["symbols","Symbols"],["numbers","Lengths"],["present","Numbers"]],i,v=>{i=v,y()},"equation-numbers"),u=b("div",{class:"scroll"});n.append(b("div",{class:"line spread"},b("span",{class:"line"},mn("Equations",[["forward","Forward"],["inverse","Inverse"],["singular","Singularities"]],e,v=>{e=v,y()},"which-equations"),c),b("button",{type:"button",class:"quiet",text:"Copy LaTeX",on:{click:()=>kr(f())}})),a,u,l);let h=v=>v.symbols&&i==="present"?Rf(v,M.table,M.q):v.latex,d=v=>v.number===void 0?"":` \\tag{${v.number}}`,f=()=>o.map(v=>v.kind==="equation"?`\\[ ${h(v)}${d(v)} \\]`:J3(v.pieces)).join(`

`);function g(v){r=[],Yt(l,o.map(A=>p(v,A))),m()}async function y(){if(t.hidden||!M.table.joints.length)return;let v=`${e}/${i}/${JSON.stringify(M.table.joints)}${M.table.convention}`;if(s!==v){s=v,yt(a,"Deriving \u2026"),Yt(l);try{let[A,T]=await Promise.all([Z3(),dn("equations",{which:e,numbers:i==="symbols"?i:"numbers"},_=>yt(a,_.note??""))]);if(s!==v)return;yt(a,T.note??""),o=T.blocks,g(A),c.hidden=e!=="forward",Yt(u),x()}catch(A){if(s!==v)return;s=null,yt(a,A.message)}}}function p(v,A){if(A.kind==="heading"||A.kind==="step")return b("h3",{},WS(v,A.pieces));if(A.kind!=="equation")return b("p",{class:"prose"},WS(v,A.pieces));let T=b("div",{class:"formula"});try{v.render(h(A),T,{displayMode:!0,throwOnError:!0,strict:!1,trust:!1,maxSize:20,maxExpand:1e3})}catch{T.replaceChildren(b("code",{text:h(A)}))}if(A.number!==void 0)return b("div",{class:"formula-row numbered"},T,b("span",{class:"hint",text:`(${A.number})`}));if(A.entry===void 0)return T;let _=b("output",{class:"value","data-entry":String(A.entry)});return r.push({value:_,entry:A.entry}),b("div",{class:"formula-row"},T,_)}let m=Br(()=>{if(t.hidden)return;let v=M.frames[M.frames.length-1];for(let{value:A,entry:T}of r)yt(A,`= ${T%4===3?`${Qn(v[T]*gt.factor("length"),gt.digits("length"))} ${gt.length}`:Qn(v[T],4)}`)}),x=Gs(async()=>{if(!(t.hidden||e!=="inverse"||!l.childElementCount))try{let{rows:v}=await dn("formulas",{T:M.frames.at(-1)});Yt(u,v.length&&e==="inverse"?K3(v):null)}catch{Yt(u)}},250),E=Gs(()=>{!t.hidden&&Cf&&o.length&&e==="forward"&&i==="present"&&g(Cf)},120);st("q",E),st("panel",E),st("q",x),st("units",x),st("panel",y),st("plan",y),st(["q","units"],m)}};var o0=()=>M.frames[M.frames.length-1].slice(),$S={id:"path",title:"Path",wide:!0,build(n,t){let e=M.path,i=["from","to"].map(p=>{let m=Ls(p==="from"?"From":"To",`path-${p}`,()=>e[p],v=>{ft("did",{label:`set \u201C${p}\u201D of the path`,key:`path-${p}`}),e[p]=v,h(),ft("path")}),x=b("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`take-${p}`,on:{click:()=>{ft("did",{label:`take \u201C${p}\u201D of the path`}),e[p]=o0(),m.show(),h(),ft("path")}}});return{el:b("div",{class:"end"},x,m.el),show:m.show}}),s=b("span",{class:"hint"}),r=Fn({label:"Number of points N",testid:"path-n",check:p=>Number.isInteger(p)&&p>=2&&p<=2e3?null:"a whole number from 2 to 2000",input:p=>{ft("did",{label:"set the points of the path",key:"path-n"}),e.n=p}}),o=Fn({label:"Seconds for the whole line",testid:"path-seconds",check:p=>p>0&&p<=3600?null:"more than 0, at most 3600",input:p=>{ft("did",{label:"set the seconds of the path",key:"path-seconds"}),e.seconds=p}}),a=b("button",{type:"button",class:"quiet",text:"Keep the orientation of \u201CFrom\u201D",on:{click:()=>{if(e.from&&e.to){let p=ne(e.to);ft("did",{label:"keep the orientation of the path"}),e.to=e.from.slice(),[3,7,11].forEach((m,x)=>{e.to[m]=p[x]}),i[1].show(),h()}}}}),l=b("button",{type:"button",class:"primary",text:"Plan the line","data-testid":"plan",on:{click:()=>d(M.q)}}),c=b("p",{class:"verdict",role:"status","data-testid":"path-verdict",hidden:!0}),u=b("div",{class:"branches","data-testid":"branches"});n.append(...i.map(p=>p.el),b("div",{class:"line"},a,s),b("div",{class:"line"},b("label",{class:"field"},b("span",{class:"field-name",text:"Points N"}),r),b("label",{class:"field"},b("span",{class:"field-name",text:"Seconds"}),o),l,b("span",{class:"hint",text:"starts from the solution nearest to the present posture"})),c,u);let h=()=>{if(!e.from||!e.to){yt(s,"");return}let p=V0(e.from,e.to);yt(s,`${Ee(ss(Pi(ne(e.to),ne(e.from))),"length")} long${p>1e-6?`, turning ${Ee(p,"angle")}`:", orientation kept"}`),qd(Array.from({length:33},(m,x)=>ne(Ny(e.from,e.to,x/32))))};async function d(p){let m=ea(n);if(m){c.hidden=!1,c.dataset.tone="wrong",yt(c,m);return}yt(l,"Planning \u2026"),l.disabled=!0;try{let x=await dn("follow",{T0:e.from,T1:e.to,n:e.n,start:p});M.track=x,f(x,p)}catch(x){c.hidden=!1,c.dataset.tone="wrong",yt(c,x.message)}finally{yt(l,"Plan the line"),l.disabled=!1}}function f(p){if(c.hidden=!1,c.dataset.tone=p.complete?"good":"wrong",yt(c,p.explain),Yt(u,p.branches.length?b("h3",{text:"Branches that start at the first pose"}):null,p.branches.map((v,A)=>b("button",{type:"button",class:`branch ${A===p.chosen?"chosen":""}`,"aria-pressed":String(A===p.chosen),"data-testid":`branch-${A+1}`,disabled:!v.q,title:v.cause||"reaches the end",on:{click:async()=>{await Ai(v.q,.4,`take branch ${A+1}`),d(v.q)}}},b("span",{class:"branch-name",text:`${A+1}  ${v.label}`}),g(v.s),b("span",{class:"branch-end",text:v.complete?"to the end":v.q?`${v.points} of ${e.n}`:"starts outside the limits"})))),qd(p.path.map(ne)),!p.q.length){fs(null);return}let m=p.path.length,x=p.q.map((v,A)=>A+1),E=p.q.map((v,A)=>m>1?e.seconds*A/(m-1):0);fs(lo({table:M.table,q:p.q,xs:x,xName:"point",xEnd:m,seconds:E,title:`${M.table.name}: straight line, ${p.q.length} of ${m} points`,events:p.events.map(v=>({...v,x:1+v.s*(m-1),short:v.cause}))}))}function g(p){let m=b("span",{class:"bar-fill"});return m.style.setProperty("width",`${100*p}%`),b("span",{class:"bar"},m)}let y=()=>{i.forEach(p=>p.show()),r.put(e.n),o.put(e.seconds),h()};st("panel",p=>{p==="path"&&(e.from??=o0(),e.to??=o0(),y())}),st("path-loaded",y),st("notation",y),st("units",h),st("table",p=>{["postures","name","gripper"].includes(p)||(c.hidden=!0,Yt(u),qd([]),t.hidden||y())})}};var XS=Math.PI/180,Q3=()=>({turn_speed:180*XS,turn_acceleration:600*XS,turn_jerk:null,slide_speed:.5,slide_acceleration:2,slide_jerk:null,tool_speed:.5});function Yc(n,t,{key:e,open:i}={}){ft("did",{label:t,key:e,open:i}),!M.program.length&&n.length&&(M.start??=M.q),M.program=n,ft("program")}var a0=(n,t,e,i)=>Yc(M.program.map((s,r)=>r===n?{...s,...t}:s),e,i);function YS(n,t){ft("did",{label:t,key:"limits"}),M.limits={...Pf(),...n},ft("program","limits")}var Pf=()=>({...Q3(),...M.limits});function ZS(n,t="set the start of the program"){ft("did",{label:t}),M.start=n,ft("program")}var If=()=>M.start?.length===M.table.joints.length?M.start:M.q;function cl(){let n=Pf(),t=M.table.joints,e=i=>t.every(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]===null)?null:t.map(s=>n[`${s.type==="R"?"turn":"slide"}_${i}`]??1e6);return{start:If(),limits:{speed:e("speed"),acceleration:e("acceleration"),jerk:e("jerk"),tool_speed:n.tool_speed},steps:M.program.map(({name:i,...s})=>s)}}var t2=()=>M.frames.at(-1).slice();function jS(n){let t=r=>`edit step ${r+1}`,e=(r,o,a)=>a0(r,o,t(r),{key:`step-${r}-${a}`});function i(r,o,a,l){let c=Fn({label:`Step ${r+1}, ${a}`,testid:`step-${r+1}-${o}`,...l,input:u=>{n(()=>e(r,{[o]:u},o))}});return c.put(M.program[r][o]??null),b("label",{class:"field"},b("span",{class:"field-name",text:l.unit?`${a}, ${l.unit}`:a}),c)}function s(r,o){if(r.kind==="wait")return b("div",{class:"line step-editor"},i(o,"seconds","seconds",{check:l=>l>=0?null:"0 or more"}));if(r.kind==="gripper")return b("div",{class:"line step-editor"},i(o,"value","value",{check:l=>l>=0&&l<=1?null:"from 0, open, to 1, closed"}));if(r.kind==="output")return b("div",{class:"line step-editor"},i(o,"port","port",{check:l=>Number.isInteger(l)&&l>=0?null:"a whole number from 0"}),b("label",{class:"check"},b("input",{type:"checkbox",checked:r.value,on:{change:l=>e(o,{value:l.target.checked},"value")}}),"on"));let a=(l,c)=>Ls(c,`step-${o+1}-${l}`,()=>M.program[o]?.[l],h=>{n(()=>e(o,l==="T"?{T:h,q:null}:{[l]:h},l))}).el;return b("div",{class:"step-editor"},b("div",{class:"line"},Mn("Kind of move",[["joint","Joints"],["line","Line"],["circle","Circle"]],r.kind,l=>e(o,{kind:l,q:l==="joint"?r.q??null:null,speed:null,...l==="circle"&&!r.via?{via:r.T}:{}},"kind"),{"data-testid":`step-${o+1}-kind`}),i(o,"blend","blend",{kind:"length",unit:gt.length,check:l=>l>=0?null:"0 or more"}),r.kind==="joint"?i(o,"speed","part of the speed",{empty:null,check:l=>l===null||l>0&&l<=1?null:"above 0 to 1"}):i(o,"speed","speed",{kind:"length",unit:`${gt.length}/s`,empty:null,check:l=>l===null||l>0?null:"more than 0"})),r.kind==="circle"?a("via","Over"):null,a("T",r.q?"To (a taught posture; typing makes it a pose)":"To"),b("div",{class:"line"},b("button",{type:"button",class:"quiet",text:"Take the present pose","data-testid":`step-${o+1}-teach`,on:{click:()=>a0(o,{T:t2(),q:r.kind==="joint"?M.q.slice():null},`teach step ${o+1}`)}}),r.q?b("button",{type:"button",class:"quiet",text:"Go there",on:{click:()=>Ai(r.q.slice(),.8,`go to step ${o+1}`)}}):null))}return s}function JS(){let n=b("div",{class:"line limits-of"}),t=()=>{let e=new Set(M.table.joints.map(r=>r.type)),i=(r,o,a,l,c)=>{let u=Fn({label:o,kind:a,empty:c,testid:`limit-${r}`,check:h=>h===null||h>0?null:"more than 0",input:h=>YS({[r]:h},`limit the ${o.toLowerCase()}`)});return u.put(Pf()[r]),c===null&&(u.placeholder="none"),b("label",{class:"field"},b("span",{class:"field-name",text:`${o}, ${gt.symbol(a)}${l}`}),u)},s=(r,o,a)=>[i(`${o}_speed`,`${a}speed`,r,"/s"),i(`${o}_acceleration`,`${a}acceleration`,r,"/s\xB2"),i(`${o}_jerk`,`${a}jerk`,r,"/s\xB3",null)];Yt(n,e.has("R")?s("angle","turn","Joint "):null,e.has("P")?s("length","slide","Slide "):null,i("tool_speed","Tool speed","length","/s",null))};return st(["table","units"],t),st("program",e=>e==="undo"&&t()),t(),n}var KS=200,e2=[["rapid","ABB RAPID"],["urscript","URScript"],["krl","KUKA KRL"],["fanuc-ls","Fanuc LS"],["inform","Yaskawa INFORM"],["pacscript","Denso PacScript"],["ros","ROS trajectory"],["csv","CSV of the motion"]],l0={joint:"Joints to",line:"Line to",circle:"Circle to",wait:"Wait",gripper:"Gripper",output:"Output"},Lf=()=>M.frames.at(-1).slice(),QS={id:"program",title:"Program",wide:!0,build(n){let t=-1,e=null,i=-1,s=b("ol",{class:"steps","data-testid":"program","aria-label":"Steps of the program"}),r=b("p",{class:"verdict",role:"status","data-testid":"program-verdict",hidden:!0}),o=b("details",{class:"fold",hidden:!0},b("summary",{text:"What binds, and when"}),b("p",{class:"hint prose"})),a=(_,S,L,I)=>b("button",{type:"button",text:S,title:L,"data-testid":`step-add-${_}`,on:{click:()=>f(I())}}),l=b("button",{type:"button",class:"primary",text:"Run the program","data-testid":"run-program",on:{click:A}}),c=b("span",{class:"hint","data-testid":"program-start"}),u="rapid";n.append(b("div",{class:"line"},a("joint","+ Joints","All joints to the present posture",()=>({kind:"joint",q:M.q.slice(),T:Lf(),blend:0})),a("line","+ Line","The tool on a straight line to the present pose",()=>({kind:"line",T:Lf(),blend:0})),a("circle","+ Circle","Over a point on the way to the present pose; both can be typed",()=>({kind:"circle",via:h(),T:Lf(),blend:0})),a("gripper","+ Gripper","From 0, open, to 1, closed",()=>({kind:"gripper",value:d()>.5?0:1})),a("wait","+ Wait","The arm rests",()=>({kind:"wait",seconds:.5})),a("output","+ Output","A digital output",()=>({kind:"output",port:1,value:!0}))),b("div",{class:"line spread"},c,b("span",{class:"line"},b("button",{type:"button",class:"quiet",text:"Start here","data-testid":"start-here",title:"The program begins in the present posture",on:{click:()=>ZS(M.q.slice())}}),b("button",{type:"button",class:"quiet",text:"Go to the start",on:{click:()=>Ai(If().slice(),.8,"go to the start")}}))),s,JS(),b("div",{class:"line"},l,b("span",{class:"line"},Mn("Language of the file",e2,u,_=>{u=_},{"data-testid":"dialect"}),b("button",{type:"button",text:"Save the program","data-testid":"save-program",on:{click:T}}))),r,o);let h=()=>M.program.findLast(_=>_.T)?.T??Lf(),d=()=>M.program.findLast(_=>_.kind==="gripper")?.value??0;function f(_){if(M.program.length>=KS){Xe(`At most ${KS} steps.`,"wrong");return}let S=t>=0?t+1:M.program.length;t=S,Yc([...M.program.slice(0,S),_,...M.program.slice(S)],`add a step: ${l0[_.kind].toLowerCase()}`)}function g(_,S){if(S<0||S>=M.program.length||_===S)return;let L=M.program.slice(),[I]=L.splice(_,1);L.splice(S,0,I),t=S,Yc(L,`move step ${_+1} to ${S+1}`),s.children[S]?.querySelector(".step-name")?.focus()}function y(_){t=-1,Yc(M.program.filter((S,L)=>L!==_),`remove step ${_+1}`)}function p(_){return _.kind==="wait"?`${_.seconds} s`:_.kind==="gripper"?_.value===0?"open":_.value===1?"closed":`${_.value}`:_.kind==="output"?`${_.port} ${_.value?"on":"off"}`:_.kind==="joint"&&_.q?_.q.map((S,L)=>Gn(S,Ye(M.table.joints[L]??{type:"R"}),1)).join(", "):`${ne(_.T).map(S=>Gn(S,"length",1)).join(", ")} ${gt.length}`}function m(_,S){let L=S===t,I=b("button",{type:"button",class:"step-name quiet","aria-expanded":String(L),"data-testid":`step-${S+1}`,title:"Press to edit; Alt and an arrow moves it",on:{click:()=>{t=L?-1:S,v()},keydown:B=>{let V={ArrowUp:-1,ArrowDown:1}[B.key];V&&B.altKey?(B.preventDefault(),g(S,S+V)):V?(B.preventDefault(),s.children[S+V]?.querySelector(".step-name")?.focus()):B.key==="Delete"&&y(S)}}},b("b",{text:l0[_.kind]}),` ${p(_)}`,_.blend?b("span",{class:"hint",text:`, blend ${Ee(_.blend,"length",0)}`}):null),D=b("li",{class:`step${e?.step===S?" failed":""}${L?" open":""}`,draggable:"true","data-testid":`step-row-${S+1}`},b("div",{class:"step-line"},b("span",{class:"grip","aria-hidden":"true",text:"\u283F"}),b("span",{class:"hint",text:String(S+1)}),I,b("button",{type:"button",class:"icon",text:"\u2191",disabled:S===0,"aria-label":`Move step ${S+1} up`,on:{click:()=>g(S,S-1)}}),b("button",{type:"button",class:"icon",text:"\u2193",disabled:S===M.program.length-1,"aria-label":`Move step ${S+1} down`,on:{click:()=>g(S,S+1)}}),b("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove step ${S+1}`,on:{click:()=>y(S)}})),e?.step===S?b("p",{class:"reason",text:e.text}):null,L?E(_,S):null);return D.addEventListener("dragstart",B=>{i=S,B.dataTransfer.effectAllowed="move",B.dataTransfer.setData("text/plain",String(S))}),D.addEventListener("dragover",B=>{i<0||(B.preventDefault(),D.classList.add("target"))}),D.addEventListener("dragleave",()=>D.classList.remove("target")),D.addEventListener("drop",B=>{B.preventDefault();let V=i;i=-1,V>=0&&g(V,S)}),D}let x=!1,E=jS(_=>{x=!0,_(),x=!1});function v(){if(x){M.program.forEach((S,L)=>{let I=s.children[L]?.querySelector(".step-name");I&&Yt(I,b("b",{text:l0[S.kind]}),document.createTextNode(` ${p(S)}`))});return}t>=M.program.length&&(t=-1),Yt(s,M.program.map(m)),M.program.length||s.append(b("li",{class:"hint empty",text:"No steps yet. Move the arm and teach it: Joints or Line takes where it stands; every pose can be typed afterwards."})),l.disabled=!M.program.length;let _=If();yt(c,M.program.length?`Starts at ${_.map((S,L)=>Gn(S,Ye(M.table.joints[L]),1)).join(", ")}`:"")}async function A(){r.hidden=!1;let _=ea(n);if(_){r.dataset.tone="wrong",yt(r,_);return}l.disabled=!0,yt(l,"Planning \u2026");try{let S=await dn("program",{...cl(),world:M.world});e=S.failed,e&&(t=e.step),r.dataset.tone=e||S.clear?.verdict==="HIT"?"wrong":S.clear?.verdict==="UNCERTAIN"?"note":"good",yt(r,e?`Step ${e.step+1} cannot be done: ${e.text}
Shown is what comes before it.`:[S.explain,S.clear?.text].filter(Boolean).join(`
`)),o.hidden=!S.tight.length,yt(o.lastChild,S.tight.map(I=>I.text).join(`
`)),v();let L=S.events.map(([I,D,B])=>({x:I,s:0,text:`${D} ${B} at ${I.toFixed(2)} s`,short:D==="gripper"?B>.5?"close":"open":D,stop:!1}));fs(Object.assign(lo({table:M.table,q:S.q,xs:S.t,xName:"time",seconds:S.t,dq:S.dq,events:L,title:`${M.table.name}: program, ${S.duration.toFixed(2)} s`}),{ddq:S.ddq,happens:S.events,tight:S.tight,limits:cl().limits}))}catch(S){r.dataset.tone="wrong",yt(r,S.message)}finally{l.disabled=!M.program.length,yt(l,"Run the program")}}async function T(){try{let _="program",{text:S,name:L}=await dn("program_file",{...cl(),dialect:u,name:_});yi(L,S)}catch(_){r.hidden=!1,r.dataset.tone="wrong",yt(r,_.message)}}st(["program","units","table"],_=>{_!=="limits"&&(e=null,v())}),v()}};var zo=new Nn,Df=new Va,n2=new ge,i2=n=>new ii({color:n,vertexColors:!0,transparent:!0,opacity:.86,fog:!1});function c0(n){let t=n.attributes.normal,e=new Float32Array(3*t.count);for(let i=0;i<t.count;i++)e.fill(.72+.2*t.getZ(i)+.08*(t.getX(i)*.6-t.getY(i)*.8),3*i,3*i+3);return n.setAttribute("color",new je(e,3)),n}var tM=n=>n.rotateX(Math.PI/2),u0={box:n=>[c0(new as(...n.size)),n.T],cylinder:n=>[c0(tM(new Yi(n.r,n.r,n.h,40))),n.T],capsule(n){let t=new k(...n.a),e=new k(...n.b).sub(t),i=e.length(),s=new ge().makeRotationFromQuaternion(new an().setFromUnitVectors(new k(0,0,1),i?e.clone().normalize():new k(0,0,1)));return s.setPosition(t.addScaledVector(e,.5)),[c0(tM(new nc(n.r,i,12,28))),s.clone().transpose().elements.slice()]}};function h0(n,t,e=.86){if(!u0[n.kind])return null;let[i,s]=u0[n.kind](n),r=i2(t);r.opacity=e,r.depthWrite=e>.5;let o=new fn(i,r);return o.matrixAutoUpdate=!1,{mesh:o,T:s}}var s2=()=>[...M.world,...M.things??[]];function r2(n){if(n.kind==="curve")return n.points.filter((i,s)=>s%20===0||s===n.points.length-1);if(n.kind==="capsule")return[n.a,n.b];if(!n.T)return[];let t=ne(n.T),e=n.kind==="box"?n.size.map(i=>i/2):n.kind==="cylinder"?[n.r,n.r,n.h/2]:[0,0,0];return[-1,1].flatMap(i=>[0,1,2].map(s=>t.map((r,o)=>r+i*e[s]*zs(n.T,s)[o])))}function nM(){_n.add(zo,Df.group),st(["world","table"],eM),st("theme",()=>{Df.paint(),eM()})}var Zc=new Map;function d0(n,t){if(t)Zc.set(n,t);else if(!Zc.delete(n))return;let e=zo.children.find(s=>s.userData.name===n),i=M.world.find(s=>s.name===n);e&&i&&e.matrix.set(...t??i.T),we()}var iM=n=>Zc.get(n)??null;function sM(){for(let n of[...Zc.keys()])d0(n,null)}function eM(){for(let t of zo.children)t.geometry.dispose();zo.clear();let n=s2();for(let t of n)if(t.kind==="curve"){let e=new Ae().setFromPoints(t.points.map(i=>new k(...i)));zo.add(new Xs(e,new Xi({color:Kt.trace,fog:!1})))}else if(u0[t.kind]){let{mesh:e,T:i}=h0(t,t.role==="object"?Kt.accent:Kt.ghost);e.matrix.copy(n2.set(...Zc.get(t.name)??i)),e.userData.name=t.name,zo.add(e)}Df.show(n.filter(t=>t.kind==="frame"),.11*oi(M.table)),Tr("world",n.flatMap(r2)),we()}var rM=()=>zo.children.length+(Df.last?.[0].length??0);var hl=new Xs(new Ae,new Xi({depthTest:!1,fog:!1})),dl=new _r(new Ae,new Ys({size:9,sizeAttenuation:!1,depthTest:!1,fog:!1}));hl.renderOrder=dl.renderOrder=6;hl.frustumCulled=dl.frustumCulled=!1;hl.visible=dl.visible=!1;var ul=new Nn,jc=null,oM="",a2=()=>M.watch||M.world.some(n=>n.role==="obstacle"&&n.kind!=="frame"),l2=Or(async()=>{try{let n=await dn("clearance",{q:M.q,world:M.world});M.clearance=n}catch(n){M.clearance={refused:n.message}}f0(),ft("clearance")});function aM(){a2()&&M.table.joints.length?l2():M.clearance&&(M.clearance=null,f0(),ft("clearance"))}function f0(){let n=M.clearance,t=!!n?.points?.length;if(hl.visible=dl.visible=t,t){let e=n.points.map(i=>new k(...i));for(let i of[hl,dl])i.geometry.setFromPoints(e),i.material.color.set(n.metres>0?Kt.trace:Kt.wrong)}we()}async function p0(n){if(jc=null,n){let{bodies:t,explain:e}=await dn("bodies",{});jc=t,oM=e}for(let t of ul.children)t.geometry.dispose();ul.clear();for(let t of jc??[]){let e=h0(t,Kt.trace,.34);e&&(e.mesh.userData={on:t.on,T:e.T},ul.add(e.mesh))}return cM(),oM}var lM=()=>ul.children.length,c2=new ge;function cM(){for(let n of ul.children){let{on:t,T:e}=n.userData;M.frames[t]&&n.matrix.copy(c2.set(...ei(M.frames[t],e)))}we()}function uM(){_n.add(hl,dl,ul),st(["q","world","watch"],aM),st("plan",aM),st("q",()=>jc&&cM()),st("table",()=>jc&&p0(!1).then(()=>ft("bodies-gone"))),st("theme",f0)}var h2=60,d2={box:"Box",cylinder:"Cylinder",frame:"Frame"},f2={box:["x","y","z"],cylinder:["radius","height"],frame:[]};function m0(n,t,e={}){ft("did",{label:t,...e}),M.world=n,ft("world")}var Nf=(n,t,e)=>m0(M.world.map((i,s)=>s===n?{...i,...t}:i),e,{key:`world-${n}-${Object.keys(t)[0]}`});function p2(n,t){if(M.world.length>=h2)return;let e=ne(M.frames.at(-1)),i=.06*oi(M.table),s=c=>Math.round(c*1e3)/1e3||.001,r=[1,0,0,s(e[0]),0,1,0,s(e[1]),0,0,1,s(n==="frame"?e[2]:i/2),0,0,0,1];r[7]+=1.5*i*M.world.length;let o=t==="object"?"object":n,a=1;for(;M.world.some(c=>c.name===`${o} ${a}`);)a+=1;let l=n==="box"?{size:[s(i),s(i),s(i)]}:n==="cylinder"?{r:s(i/2),h:s(i)}:{};m0([...M.world,{kind:n,role:t,name:`${o} ${a}`,T:r,...l}],`add ${o} ${a}`)}var hM={id:"world",title:"World",wide:!0,build(n){let t=b("p",{class:"verdict",role:"status","data-testid":"clearance",hidden:!0}),e=b("p",{class:"hint prose"}),i=b("input",{type:"checkbox","data-testid":"watch",on:{change:()=>{M.watch=i.checked,ft("watch")}}}),s=b("input",{type:"checkbox","data-testid":"show-bodies",on:{change:async()=>{try{let h=await p0(s.checked);yt(e,s.checked?h:"")}catch(h){yt(e,h.message)}}}}),r=b("div",{class:"things","data-testid":"world"}),o=(h,d,f,g)=>b("button",{type:"button",text:h,title:g,"data-testid":`add-${f}-${d}`,on:{click:()=>p2(d,f)}});n.append(b("div",{class:"line"},o("+ Object","box","object","A box that the gripper can take"),o("+ Box","box","obstacle","A table, a wall"),o("+ Cylinder","cylinder","obstacle","A post, a can"),o("+ Frame","frame","obstacle","A place with a name")),b("p",{class:"hint",text:"An object is taken by a gripper that closes with the tool\u2019s point at it, and goes with the tool until it opens."}),b("div",{class:"line"},b("label",{class:"check"},i,"Distance, always"),b("label",{class:"check"},s,"Bodies it is measured of")),t,e,r),st(["clearance","units"],()=>{let h=M.clearance;if(t.hidden=!h,!h)return;t.dataset.tone=h.refused||h.metres<=0?"wrong":"good";let[d,f]=h.pair??[];yt(t,h.refused??(h.metres===null?"There is nothing that could be touched.":h.metres>0?`Nearest: ${d} and ${f}, ${Ee(h.metres,"length")} apart.`:`${d} and ${f} overlap by ${Ee(-h.metres,"length")}.`))}),st("bodies-gone",()=>{s.checked=!1,yt(e,"")});let l=!1,c=()=>{l||(Yt(r,M.world.map(u)),M.world.length||r.append(b("p",{class:"hint",text:"Nothing stands around the arm yet."})))};function u(h,d){let f=m=>(...x)=>{l=!0,m(...x),l=!1},g=b("input",{type:"text",value:h.name,maxlength:"40","aria-label":`Name of ${h.name}`,on:{change:()=>g.value&&Nf(d,{name:g.value},`name ${g.value}`)}}),y=f2[h.kind].map((m,x)=>{let E=Fn({label:`${h.name}, ${m}`,kind:"length",testid:`world-${d+1}-size-${x}`,check:v=>v>0?null:"more than 0",input:f(v=>{let A=M.world[d],T=h.kind==="box"?{size:A.size.map((_,S)=>S===x?v:_)}:{[x?"h":"r"]:v};Nf(d,T,`size of ${h.name}`)})});return E.put(h.kind==="box"?h.size[x]:x?h.h:h.r),b("label",{class:"field"},b("span",{class:"field-name",text:`${m}, ${gt.length}`}),E)}),p=Ls("Place of its middle",`world-${d+1}`,()=>M.world[d]?.T,f(m=>Nf(d,{T:m},`move ${h.name}`)));return b("section",{class:"thing","aria-label":h.name,"data-testid":`thing-${d+1}`},b("div",{class:"line spread"},b("span",{class:"line"},g,b("span",{class:"hint",text:d2[h.kind]}),h.kind==="frame"?null:Mn(`What ${h.name} is`,[["object","object"],["obstacle","obstacle"]],h.role,m=>Nf(d,{role:m},`make ${h.name} an ${m}`))),b("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>m0(M.world.filter((m,x)=>x!==d),`remove ${h.name}`)}})),y.length?b("div",{class:"line"},y):null,p.el)}st(["world","units"],h=>h!=="python"&&c()),c()}};var m2=40,dM={id:"sequence",title:"Sequence",wide:!0,build(n){let t={get postures(){return M.sequence.postures},set postures(u){M.sequence.postures=u},get rate(){return M.sequence.rate}},e=b("thead"),i=b("tbody"),s=b("p",{class:"verdict",role:"status","data-testid":"sequence-verdict",hidden:!0}),r=b("button",{type:"button",class:"primary",text:"Run the sequence","data-testid":"run-sequence",on:{click:c}}),o=b("button",{type:"button",class:"quiet",text:"Same times for all legs",title:"Copy the first leg\u2019s time and rest to the others",on:{click:()=>{let u=t.postures[1];if(u){ft("did",{label:"use the same times for all legs"});for(let h of t.postures.slice(2))h.seconds=u.seconds,h.hold=u.hold;l()}}}});n.append(b("p",{class:"hint",text:"Each leg is a quintic in time: all joints start and arrive together, at rest in every posture. After a leg the arm rests."}),b("div",{class:"scroll"},b("table",{class:"dh sequence","data-testid":"sequence","aria-label":"Postures of the sequence"},e,i)),b("div",{class:"line"},b("button",{type:"button",class:"add",text:"+ Present posture","data-testid":"add-posture",on:{click:()=>a(M.q.slice())}}),b("button",{type:"button",text:"+ All named postures",on:{click:()=>Object.entries(M.table.postures??{}).forEach(([u,h])=>a(h.slice(),u))}}),o),b("div",{class:"line"},r),s);function a(u,h){t.postures.length>=m2||(ft("did",{label:"add a posture to the sequence"}),t.postures.push({name:h??`P${t.postures.length}`,q:u,seconds:5,hold:0}),l(),ft("sequence"))}function l(){let u=M.table.joints;t.postures=t.postures.filter(h=>h.q.length===u.length),r.disabled=t.postures.length<2,Yt(e,b("tr",{},b("th",{text:""}),u.map((h,d)=>b("th",{},b("i",{text:"q"}),b("sub",{text:String(d+1)}),b("span",{class:"unit",text:` ${gt.symbol(Ye(h))}`}))),b("th",{text:"leg, s"}),b("th",{text:"rest, s"}),b("th",{"aria-label":"row tools"}))),Yt(i,t.postures.map((h,d)=>{let f=u.map((y,p)=>{let m=Fn({label:`${h.name}, q${p+1}`,kind:Ye(y),testid:`seq-${d}-q${p+1}`,input:x=>{ft("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${p}`}),h.q[p]=x,ft("sequence")}});return m.put(h.q[p],String(Number((h.q[p]*gt.factor(Ye(y))).toFixed(gt.digits(Ye(y))))+0)),b("td",{},m)}),g=(y,p,m)=>{if(d===0)return b("td");let x=Fn({label:`${p} ${h.name}`,testid:`seq-${d}-${y}`,check:m,input:E=>{ft("did",{label:`edit ${h.name} of the sequence`,key:`seq-${d}-${y}`}),h[y]=E,ft("sequence")}});return x.put(h[y]),b("td",{},x)};return b("tr",{"data-testid":`seq-row-${d}`},b("th",{scope:"row"},b("button",{type:"button",class:"quiet",text:h.name,title:"Go there",on:{click:()=>Ai(h.q.slice())}})),f,g("seconds","Seconds to",y=>y>0?null:"more than 0"),g("hold","Rest after",y=>y>=0?null:"0 or more"),b("td",{class:"tools"},b("button",{type:"button",class:"icon",text:"\u2191",disabled:d===0,"aria-label":`Move ${h.name} up`,on:{click:()=>{ft("did",{label:`move ${h.name} up`}),t.postures.splice(d-1,0,...t.postures.splice(d,1)),l()}}}),b("button",{type:"button",class:"icon",text:"\xD7","aria-label":`Remove ${h.name}`,on:{click:()=>{ft("did",{label:`remove ${h.name}`}),t.postures.splice(d,1),l(),ft("sequence")}}})))})),t.postures.length||i.append(b("tr",{},b("td",{class:"hint",colspan:String(u.length+4),text:"No postures yet: add the present one, move the arm, add the next."})))}async function c(){s.hidden=!1;let u=ea(n);if(u){s.dataset.tone="wrong",yt(s,u);return}r.disabled=!0;try{let h=t.postures,d=await dn("motion",{postures:h.map(g=>g.q),seconds:h.slice(1).map(g=>g.seconds),holds:h.slice(1).map(g=>g.hold),rate:t.rate}),f=h.map((g,y)=>({x:d.arrivals[y],s:0,text:`${g.name} at ${d.arrivals[y].toFixed(2)} s`,short:g.name,stop:!1}));s.dataset.tone="good",yt(s,`${h.length} postures in ${d.t[d.t.length-1].toFixed(2)} s. ${g2(d.q)}`),fs(lo({table:M.table,q:d.q,xs:d.t,xName:"time",seconds:d.t,dq:d.dq,events:f,title:`${M.table.name}: ${h.map(g=>g.name).join(" \u2013 ")}`}))}catch(h){s.dataset.tone="wrong",yt(s,h.message)}finally{r.disabled=t.postures.length<2}}st(["table","units","sequence-loaded"],l),l()}};function g2(n){let t=M.table.joints.filter((e,i)=>n.some(s=>e.lower!==null&&s[i]<e.lower-1e-9||e.upper!==null&&s[i]>e.upper+1e-9));return t.length?`Outside the limits on the way: ${t.map(e=>e.name).join(", ")}.`:"Inside all limits."}var _2=.14,co=new fn(new yr(1,32,20),new ii({transparent:!0,opacity:.3,depthWrite:!1,fog:!1}));co.matrixAutoUpdate=!1;co.visible=!1;co.renderOrder=4;var Jc="none";function x2(n,t,e){let i=$0(n,t,e).slice(0,3),s=i.map(o=>i.map(a=>o.reduce((l,c,u)=>l+c*a[u],0))),r=[[1,0,0],[0,1,0],[0,0,1]];for(let o=0;o<20;o++)for(let[a,l]of[[0,1],[0,2],[1,2]]){if(Math.abs(s[a][l])<1e-300)continue;let c=(s[l][l]-s[a][a])/(2*s[a][l]),u=Math.sign(c||1)/(Math.abs(c)+Math.sqrt(c*c+1)),h=1/Math.sqrt(u*u+1),d=u*h;for(let f=0;f<3;f++)[s[f][a],s[f][l]]=[h*s[f][a]-d*s[f][l],d*s[f][a]+h*s[f][l]];for(let f=0;f<3;f++)[s[a][f],s[l][f]]=[h*s[a][f]-d*s[l][f],d*s[a][f]+h*s[l][f]];for(let f=0;f<3;f++)[r[f][a],r[f][l]]=[h*r[f][a]-d*r[f][l],d*r[f][a]+h*r[f][l]]}return[0,1,2].map(o=>({axis:r.map(a=>a[o]),length:Math.sqrt(Math.max(s[o][o],0))})).sort((o,a)=>a.length-o.length)}function fM(n){Jc=n,pM()}var Uf=()=>M.ellipsoid??null;function pM(){let n=Jc!=="none"&&M.table.joints.length>0;if(co.visible=n,M.ellipsoid=null,n){let t=x2(M.table,M.q,M.frames),e=_2*oi(M.table),i=t[0].length||1,s=.004,r=t.map(({axis:u,length:h})=>({axis:u,half:e*Math.max(Jc==="velocity"?h/i:Math.min(t[2].length/Math.max(h,1e-12),1),s)})),o=ne(M.frames.at(-1)),[a,l]=r,c={...r[2]};co.matrix.set(...[0,1,2].flatMap(u=>[a.half*a.axis[u],l.half*l.axis[u],c.half*c.axis[u],o[u]]),0,0,0,1),co.material.color.set(Jc==="velocity"?Kt.trace:Kt.accent),co.material.side=Di,M.ellipsoid=t}we(),ft("ellipsoid")}function mM(){_n.add(co),st(["q","theme"],()=>Jc!=="none"&&pM())}var Ff=["#440154","#414487","#2a788e","#22a884","#7ad151","#fde725"].map(n=>new ie(n)),g0=new Ys({size:2.2,sizeAttenuation:!1,vertexColors:!0,fog:!1}),Oi=new _r(new Ae,g0);Oi.frustumCulled=!1;Oi.visible=!1;_n.add(Oi);var fl=null,Kc=null,Bi=0,uo={lo:0,hi:1};function gM(n){fl=new Float32Array(3*n),Kc=new Float32Array(n),Bi=0,Oi.geometry.dispose(),Oi.geometry=new Ae,Oi.geometry.setAttribute("position",new je(fl,3)),Oi.geometry.setAttribute("color",new je(new Float32Array(3*n),3)),Oi.geometry.setDrawRange(0,0),Oi.visible=!0,we()}function _M(n){let t=Uint8Array.from(atob(n),i=>i.charCodeAt(0)),e=new Float32Array(t.buffer);for(let i=0;i<e.length&&Bi<Kc.length;i+=4,Bi++)fl.set(e.subarray(i,i+3),3*Bi),Kc[Bi]=e[i+3];v2()}function v2(){let n=Kc.slice(0,Bi).sort();uo.lo=n[Math.floor(Bi*.02)]??0,uo.hi=n[Math.max(Math.ceil(Bi*.98)-1,0)]??1;let t=new ie,e=Oi.geometry.attributes.color.array,i=uo.hi-uo.lo||1;for(let s=0;s<Bi;s++){let r=Math.min(Math.max((Kc[s]-uo.lo)/i,0),1)*(Ff.length-1),o=Math.min(Math.floor(r),Ff.length-2);t.lerpColors(Ff[o],Ff[o+1],r-o),e[3*s]=t.r,e[3*s+1]=t.g,e[3*s+2]=t.b}Oi.geometry.setDrawRange(0,Bi),Oi.geometry.attributes.position.needsUpdate=!0,Oi.geometry.attributes.color.needsUpdate=!0,we()}var Qc=()=>Bi;function xM(n){Ji.localClippingEnabled=n!==null,g0.clippingPlanes=n===null?null:[new ni(new k(0,1,0),-n)],g0.needsUpdate=!0,we()}function yM(){let n=new Li;for(let i=0;i<Bi;i++)n.expandByPoint(new k(fl[3*i],fl[3*i+1],fl[3*i+2]));let{min:t,max:e}=n;return Bi?[0,1,2,3,4,5,6,7].map(i=>[i&1?t.x:e.x,i&2?t.y:e.y,i&4?t.z:e.z]):[]}function vM(){Bi=0,Oi.visible=!1,we()}var SM=[["height","height of the tool"],["manipulability","manipulability"],["condition","inverse condition number"],["limits","distance to the limits"]],Of=n=>n===0?"0":Math.abs(n)>=.001&&Math.abs(n)<1e4?Qn(n,4):n.toExponential(2).replace("-","\u2212"),MM={id:"analysis",title:"Analysis",build(n){let t=b("dl",{class:"facts","data-testid":"analysis"}),e=[["manipulability","Manipulability","the product of the singular values of the Jacobian, lengths divided by the arm\u2019s"],["condition","Condition number","the largest singular value over the smallest; 1 is best"],["least","Smallest singular value","0 at a singularity"]],i={};for(let[c,u,h]of e)t.append(b("div",{title:h},b("dt",{text:u}),i[c]=b("dd",{"data-testid":`fact-${c}`})));let s=b("div",{class:"distances","data-testid":"limit-distances"}),r=[],o=b("p",{class:"hint","data-testid":"ellipsoid-axes"});st("ellipsoid",()=>{let c=Uf();yt(o,c?`Joint rates of norm 1 move the point at most ${c.map(u=>Ee(u.length,"length")).join(", ")} a second along the three axes; forces are greatest where speeds are least.`:"")}),n.append(t,b("h3",{text:"At the tool\u2019s point"}),mn("Ellipsoid at the tool",[["none","None"],["velocity","Velocities"],["force","Forces"]],"none",fM,"ellipsoid"),o,b("h3",{text:"Distance to the limits"}),s,b("h3",{text:"Reachable points"}),b2());let a=()=>{r=M.table.joints.map((c,u)=>{let h=b("span",{class:"bar-fill"}),d=b("span",{class:"bar-text"});return{el:b("div",{class:"distance"},b("span",{},b("i",{text:"q"}),b("sub",{text:String(u+1)})),b("span",{class:"bar"},h),d),fill:h,text:d}}),Yt(s,r.map(c=>c.el)),l()},l=Br(()=>{if(n.closest(".panel").hidden||!M.table.joints.length)return;let c=uu(M.table,M.q,M.frames),u=c[0],h=c[c.length-1];yt(i.manipulability,Of(c.reduce((d,f)=>d*f,1))),yt(i.condition,u>1e-9?Qn(h/u,1):"\u221E"),yt(i.least,Of(u)),t.dataset.tone=u<.02?"wrong":"good",r.forEach(({el:d,fill:f,text:g},y)=>{let p=M.table.joints[y],m=M.q[y];if(p.lower===null||p.upper===null){f.style.setProperty("width","100%"),yt(g,"no limit");return}let x=Math.min(m-p.lower,p.upper-m),E=Math.max(2*x/(p.upper-p.lower||1),0);f.style.setProperty("width",`${100*E}%`),d.classList.toggle("outside",x<-1e-9),yt(g,x<-1e-9?`${Ee(-x,Ye(p))} beyond`:Ee(x,Ye(p)))})});st("table",a),st(["q","units","panel"],l),a()}};function b2(){let n="20000",t="manipulability",e=!1,i=b("button",{type:"button",class:"primary",text:"Draw the cloud","data-testid":"cloud-start",on:{click:()=>e?Vi("cancel",{kind:"cloud"}):d()}}),s=b("button",{type:"button",text:"Clear",on:{click:h}}),r=mn("Cloud shown",[["whole","Whole"],["half","Cut open"]],"whole",f=>xM(f==="half"?M.table.base[7]:null),"cloud-cut"),o=b("progress",{max:"1","aria-label":"Progress of the cloud","data-testid":"cloud-progress",hidden:!0}),a=b("p",{class:"hint",role:"status","data-testid":"cloud-note"}),l=b("span"),c=b("span"),u=b("div",{class:"legend-scale",hidden:!0},l,b("span",{class:"scale-bar"}),c);function h(){vM(),Tr("cloud",[]),u.hidden=!0,yt(a,"")}async function d(){e=!0,yt(i,"Cancel"),o.hidden=!1,o.value=0,u.hidden=!1,gM(Number(n));try{let f=await dn("cloud",{count:Number(n),colour:t,seed:1},g=>{_M(g.points),o.value=g.done/g.of,yt(l,Of(uo.lo)),yt(c,Of(uo.hi)),yt(a,`${g.done.toLocaleString("en")} of ${g.of.toLocaleString("en")} points`)});yt(a,f.stopped?`Cancelled after ${Qc().toLocaleString("en")} points.`:`${f.done.toLocaleString("en")} random postures inside the limits, coloured by ${SM.find(([g])=>g===t)[1]}${t==="height"?" (m)":""}.`)}catch(f){yt(a,f.message)}e=!1,Tr("cloud",yM()),Dc(),yt(i,"Draw the cloud"),o.hidden=!0}return st("table",f=>{f!=="postures"&&f!=="name"&&Qc()&&h()}),b("div",{},b("div",{class:"line"},Mn("Number of points",[["5000","5,000 points"],["20000","20,000 points"],["100000","100,000 points"]],n,f=>{n=f},{"data-testid":"cloud-count"}),b("span",{class:"field-name",text:"coloured by"}),Mn("Coloured by",SM,t,f=>{t=f},{"data-testid":"cloud-colour"})),b("div",{class:"line"},i,s,r),o,u,a)}var wM=n=>({id:"share",title:"Share",build(t,e){let i=b("input",{type:"text",readonly:!0,class:"address","aria-label":"Link to this state","data-testid":"link",on:{focus:d=>d.target.select()}}),s=b("input",{type:"file",accept:".json,application/json",class:"offscreen",tabindex:"-1","aria-label":"State file","data-testid":"state-file",on:{change:()=>h(s)}}),r=b("p",{class:"hint",role:"status","data-testid":"report-note"}),o=b("button",{type:"button",class:"primary",text:"Write the report","data-testid":"report",on:{click:u}}),a=b("textarea",{rows:"9",readonly:!0,class:"code",spellcheck:"false","aria-label":"The screen as a Python script","data-testid":"python"});t.append(b("p",{class:"hint",text:"Arm, posture, target, path, sequence, units and view, all in the link: whoever opens it on their own workbench sees what you see."}),b("div",{class:"line share-link"},i,b("button",{type:"button",text:"Copy the link","data-testid":"copy-link",on:{click:async()=>kr(await Qd())}})),b("h3",{text:"As a file"}),b("div",{class:"line"},b("button",{type:"button",text:"Save the state","data-testid":"save-state",on:{click:()=>yi(`${M.table.name||"arm"}.workbench.json`,JSON.stringify(Jd(),null,1),"application/json")}}),b("button",{type:"button",text:"Open a state\u2026",on:{click:()=>s.click()}}),s,b("button",{type:"button",text:"Save the robot file","data-testid":"save-robot",on:{click:Af}})),b("h3",{text:"As Python"}),b("p",{class:"hint",text:"A script that makes and computes what is on the screen, in metres and radians."}),a,b("div",{class:"line"},b("button",{type:"button",text:"Copy the script","data-testid":"copy-python",on:{click:()=>kr(a.value)}}),b("button",{type:"button",text:"Save the script",on:{click:()=>yi("workbench.py",a.value,"text/x-python")}})),b("h3",{text:"Report"}),b("p",{class:"hint",text:"One page that stands alone: the arm, its table and equations, the present pose with all its solutions, singularities and reach."}),b("div",{class:"line"},o),r);let l=async()=>{!e.hidden&&M.table.joints.length&&(i.value=await Qd()),!e.hidden&&M.table.joints.length&&c()},c=Or(async()=>{try{let{q:d,target:f,hasTarget:g,path:y,program:p}=M,{task:m,redundancy:x}=ue,E={q:d,target:g?f:null,path:y,task:m,redundancy:x,program:cl()};a.value=(await dn("python",p.length?E:{...E,program:null})).text}catch(d){a.value=`# ${d.message}`}});st(["panel","table","q","units","notation"],l);async function u(){o.disabled=!0;try{let{html:d,name:f}=await dn("report",{q:M.q},g=>yt(r,g.note));yi(f,d,"text/html"),yt(r,`Written: ${f}, ${Math.round(d.length/1024)} kB.`)}catch(d){yt(r,d.message)}finally{o.disabled=!1}}async function h(d){let f=d.files[0];if(d.value="",!!f)try{if(f.size>5e5)throw new Error("A state file has at most 500 kB.");Kd(JSON.parse(await f.text()),n()),Xe("Opened")}catch(g){Xe(g instanceof SyntaxError?`${f.name} is not a state file.`:g.message,"wrong")}}}});var S2=40,TM=!1,AM=0,_0=!1,Bf=null,EM=null;function RM(n){n&&(TM=!0,Bf=M.table,CM(n))}function CM(n){_0=!0,AM=n.said,n.table&&(hn(n.table,{q:n.q,what:"new",label:"open an arm from Python"}),Bf=M.table),n.things&&M2(n.things),n.target&&(M.hasTarget=!0,xi(n.target,"restored")),n.q&&n.q.length===M.table.joints.length&&(ft("did",{label:"move from Python",key:"python"}),Ii(n.q,"python")),_0=!1}function M2(n){M.things=n.filter(i=>i.kind!=="motion"),ft("world","python");let t=n.findLast(i=>i.kind==="motion")??null,e=JSON.stringify(t);if(e!==EM){if(EM=e,!t){fs(null);return}fs(lo({table:M.table,q:t.q,xs:t.t,xName:"time",seconds:t.t,title:`${M.table.name}: ${t.name}`,events:t.events.map(([i,s,r])=>({x:i,s:0,text:`${s} ${r} at ${i.toFixed(2)} s`,short:s,stop:!1}))}))}}var w2=ta(S2,()=>{let n=M.table===Bf?void 0:Qf(M.table);Bf=M.table,M.table.joints.length&&Vi("shown",{q:M.q,target:M.hasTarget?M.target:null,table:n,said:AM}).catch(()=>{})});function PM(){st("push",CM),st(["q","target","table"],()=>TM&&!_0&&w2.soon())}var Ho=new Nn,LM=new ii({fog:!1}),x0=new ii({fog:!1}),y0=new as(1,1,1),v0=new fn(y0,LM),DM=[new fn(y0,x0),new fn(y0,x0)];Ho.add(v0,...DM);Ho.matrixAutoUpdate=!1;Ho.visible=!1;var tu=null;function NM(){_n.add(Ho),st("q",()=>tu!==null&&FM()),st("theme",IM),IM()}function IM(){LM.color.set(Kt.joint),x0.color.set(Kt.accent)}function b0(n){n===null&&tu===null||(tu=n,Ho.visible=n!==null,n!==null&&FM(),we())}var UM=()=>tu;function FM(){let n=M.frames.at(-1),t=.075*oi(M.table);v0.scale.set(.35*t,1.1*t,.25*t),v0.position.set(0,0,-.85*t),DM.forEach((e,i)=>{let s=(.08+.36*(1-tu))*t;e.scale.set(.26*t,.13*t,.95*t),e.position.set(0,(i?1:-1)*s,-.3*t)}),Ho.matrix.set(...n),Ho.updateMatrixWorld(!0)}var A2=.25,S0=.5;function R2(n){let t=(n.happens??[]).filter(([,r])=>r==="gripper").map(([r,,o])=>({t:r,value:o})),e=new Map(M.world.filter(r=>r.role==="object").map(r=>[r.name,[{t:-1,T:r.T}]])),i=null,s=!1;for(let{t:r,value:o}of t){let a=I2(n,r);if(o>=S0&&!s){let l=[...e].map(([c,u])=>({name:c,T:u.at(-1).T,d:ss(Pi(ne(u.at(-1).T),ne(a)))})).filter(({name:c,d:u})=>u<C2(M.world.find(h=>h.name===c))).sort((c,u)=>c.d-u.d)[0];l&&(i=l.name,e.get(i).push({t:r,held:ei(ou(a),l.T)}))}else o<S0&&s&&i&&(e.get(i).push({t:r,T:ei(a,e.get(i).at(-1).held)}),i=null);s=o>=S0}return{grips:t,objects:e}}var C2=n=>.6*Math.max(...n.size??[2*(n.r??0),n.h??0])+.01;function P2(n,t){let e=0,i=n.length-1;for(;e<i;){let s=e+i+1>>1;n[s]<=t+1e-9?e=s:i=s-1}return e}var I2=(n,t)=>_s(n.table,n.q[P2(n.seconds,t)]).at(-1),ho=null,L2=n=>{let t=ho.grips.length?1-Math.round(ho.grips[0].value):0;for(let e of ho.grips){if(e.t>n)break;let i=Math.min((n-e.t)/A2,1);t+=i*(e.value-t)}return t};function OM(){st("motion",()=>{sM(),ho=M.motion?.happens?R2(M.motion):null,ho||b0(null)}),st("played",n=>{if(!ho)return;let t=M.frames.at(-1);ho.grips.length&&b0(L2(n));for(let[e,i]of ho.objects){let s=i.findLast(r=>r.t<=n)??i[0];d0(e,s.held?ei(t,s.held):s.T)}})}function BM(){window.workbench=Object.freeze({get q(){return M.q.slice()},get frames(){return structuredClone(M.frames)},get target(){return M.target.slice()},get table(){return structuredClone(M.table)},get solutions(){return structuredClone(M.solutions)},get camera(){return Md()},get pictures(){return xy()},get ghosts(){return gv()},get history(){return[Yd(),Zd()]},get beyond(){return fv()},get things(){return rM()},get program(){return structuredClone(M.program)},get motion(){return structuredClone(M.motion)},get gripper(){return UM()},placeOf:n=>iM(n)??M.world.find(t=>t.name===n)?.T??null,go:ko,get stepFrame(){return M.dhStep===null?null:Cd().at(-1).T},get clearance(){return structuredClone(M.clearance)},get bodies(){return lM()},get ellipsoid(){return structuredClone(Uf())},get world(){return structuredClone(M.world)},get framesDrawn(){return pv()},get answers(){return rg.answers},get trace(){return vv()},get cloud(){return Qc()},toScreen:Ui,withPicture:n=>za(n),handles:()=>Wy(),forward:(n,t)=>_s(n,t),convert:(n,t)=>Ef(n,t),read:(n,t)=>_f(n,t),present:(n,t,e)=>Rf(n,t,e)})}gd();yy(Hs("#view"));st("theme",Dm);Dm();Tv();cv();Hy();nM();uM();mM();NM();OM();PM();t_();Mv();wS(Hs("#bar"));TS(Hs("#overlay"));gS(Hs("#dock"));AS();var M0,eu=(n,t,...e)=>[{...t,group:n},...e];M0=ES(Hs("#rail"),Hs("#panels"),Hs("#pinned"),[...eu("Drive",{id:"move",title:"Move",sections:[uS,CS]},BS),...eu("Describe",VS,hM),...eu("Plan",$S,QS,dM),...eu("Study",PS,qS,MM),...eu("Hand on",wM(()=>M0))]);yS(Hs("#room"),Hs("#rail"));Nv();var N2=Lv().then(n=>n&&Kd(n,M0)).catch(n=>Xe(`The link could not be read: ${n.message}`,"wrong"));st("online",async n=>{if(!n)return;await N2;let t=await j0();M.catalog=t.catalog,ft("catalog"),t.table&&(!M.table.joints.length||t.bench)&&(hn(t.table,{q:Qo(t.table),step:!1,what:"new"}),jd()),RM(t.bench),document.documentElement.dataset.ready="yes"});M.online&&ft("online",!0);document.fonts?.ready.then(()=>ft("theme"));BM();
